"""The crate as it is released: its package, the oldest compilers that it promises, and sets of features."""

from __future__ import annotations

import itertools
import json
import os
import re
import shutil
import subprocess
import tarfile
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from crates import WORK, crate, passes, rendered, specification, write
from mipgen.targets.rust import OLDEST, names
from random_values import chance
from support import NIGHTLY, ROOT, SPECS, heavy, locked, need, rounds
from test_rust import LONG, lints, workspace

#: The Rust version that features with dependencies need, as locked for the tests.
DEPENDENCIES = {"serde": "1.71", "defmt": "1.81", "embedded-io-07": "1.81", "embedded-io-async-07": "1.81",
                "open": "1.85", "tokio": "1.85", "mint": OLDEST}  # fmt: skip

#: Those whose dependencies may be of versions that demand less or more, so that the README names the version as well.
OTHERS = {"serde": "serde", "defmt": "defmt", "open": "serialport", "tokio": "serialport"}


@cache
def manifest(spec: str) -> dict[str, Any]:
    metadata = passes(crate(spec), "metadata", "--offline", "--no-deps", "--format-version", "1")
    (package,) = json.loads(metadata)["packages"]
    assert isinstance(package, dict)
    return package


# --------------------------------------------------------------------------- the oldest compilers


def promised() -> dict[str, str]:
    """Feature -> the oldest Rust, from the table of the README; `none` stands for none, all sets are one row."""
    text = (SPECS["invented"][1] / "rust/README.md").read_text("utf-8")
    table = text.partition("| Feature | Adds | Oldest Rust |\n|---|---|---|\n")[2].partition("\n\n")[0]
    return dict(re.findall(r"^\| `?([\w -]+)`? \| .+ \| ([^|]+) \|$", table, re.MULTILINE))


def pinned(name: str) -> str:
    """The version of a dependency that the tests use."""
    lock = (Path(__file__).parent / "Cargo.lock").read_text("utf-8")
    return lock.partition(f'name = "{name}", version = "')[2].partition('"')[0]


@cache
def toolchain(version: str) -> str:
    """A compiler of this version; one that is not available is an error."""
    rustup = need("rustup")
    installed = subprocess.run([rustup, "toolchain", "list"], capture_output=True, text=True).stdout
    if not re.search(rf"^{re.escape(version)}-", installed, re.MULTILINE):
        arguments = ["toolchain", "install", version, "--profile", "minimal", "--no-self-update"]
        done = subprocess.run([rustup, *arguments], capture_output=True, text=True)
        assert done.returncode == 0, f"rustup {' '.join(arguments)}: {done.stderr[-2000:]}"
    return version


def user(spec: str, features: list[str], default: bool = True) -> Path:
    """A package that depends on the crate as it is, whose manifest also names dependencies that these features do not
    need."""
    manifest = f"""[package]
name = "user"
version = "0.0.0"
edition = "2021"

[dependencies.mip-protocol]
path = "../mip-protocol"
features = {json.dumps(features)}
default-features = {json.dumps(default)}

[workspace]
"""
    folder = crate(spec).parent / "user"
    with locked(WORK / f"{spec}-user"):
        write({"Cargo.toml": manifest.encode(), "src/lib.rs": b"#![no_std]\n"}, folder)
    return folder


def checked_with(version: str, folder: Path, *arguments: str) -> None:
    command = [need("rustup"), "run", toolchain(version), "cargo", "check", "--quiet", *arguments]
    environment = {**os.environ, "CARGO_TARGET_DIR": str(WORK / "target-oldest"), "CARGO_TERM_COLOR": "never"}
    if version == OLDEST:  # else it would clone the registry with Git; it knows the present way as an unstable one
        environment |= {"RUSTC_BOOTSTRAP": "1", "CARGO_UNSTABLE_SPARSE_REGISTRY": "true"}
    with locked(WORK / "oldest"):
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment)
    assert done.returncode == 0, f"{version}: {' '.join(arguments)}\n{done.stderr[-6000:]}"


def test_each_feature_has_an_oldest_compiler() -> None:
    sets = {names.module(s.name) for s in specification("invented").families}
    own = manifest("invented")["features"].keys() - sets - {"default"}
    table = promised()
    manifest_text = rendered("invented")["Cargo.toml"].decode("utf-8")
    assert table.keys() == own | {"none", "one for each family of descriptor sets"}
    assert table["none"] == OLDEST == manifest("invented")["rust_version"]
    for feature, version in table.items():
        if feature in OTHERS:
            assert version == f"{DEPENDENCIES[feature]}, required by `{OTHERS[feature]}` {pinned(OTHERS[feature])}"
        else:
            assert re.fullmatch(r"1\.\d+", version) and version == DEPENDENCIES.get(feature, version)
            text = manifest_text.partition(f"\n{feature} = ")[0].rpartition("\n")[2]  # the comment before it
            assert version == OLDEST or text.endswith(f" needs Rust {version}."), feature


#: The features whose compilers build them here; the seed draws some of them.
DRAWN = chance("oldest").sample(sorted(promised()), rounds(1, len(promised())))


@heavy("other Rust compilers")
@pytest.mark.parametrize("feature", sorted(DRAWN))
def test_the_oldest_compiler_builds_it(feature: str) -> None:
    if feature in DEPENDENCIES:
        checked_with(DEPENDENCIES[feature], workspace() / "mip-protocol", "--features", feature)
        return
    own = [] if feature == "none" or " " in feature else [feature]
    checked_with(promised()[feature], user("difficult", own, default=feature != "none"), "--offline")


@heavy("other Rust compilers")
def test_an_older_compiler_would_not_do() -> None:
    """The promised version is really the oldest, so that the tests above can fail."""
    with pytest.raises(AssertionError, match=r"core.*error|error_in_core"):
        checked_with(OLDEST, user("invented", ["core-error"]), "--offline")


# --------------------------------------------------------------------------- sets of features


#: Features that need no dependency, and one set. Of any two, each is once there without the other, and both together.
OWN = ("alloc", "std", "dynamic", "core-error", "tools", "devices", "registry")
PAIRS = ("", ",".join(OWN), "std,dynamic,devices,registry", "alloc,dynamic,core-error,tools", "alloc,std,tools,devices",
         "alloc,core-error,devices,registry", "std,dynamic,core-error,tools,registry")  # fmt: skip


def combinations() -> list[str]:
    """Pairs of features; `make nightly` has all sets of them."""
    assert manifest("invented")["features"].keys() >= {*OWN}
    every = [",".join(x) for n in range(len(OWN) + 1) for x in itertools.combinations(OWN, n)]
    return every if NIGHTLY else [*PAIRS]


@heavy(LONG)
def test_each_combination_of_features() -> None:
    for features in combinations():
        lints("invented", "--no-default-features", "--features", features)


# --------------------------------------------------------------------------- what may grow

#: Enumerations that cannot get more members: see docs/versions.md.
COMPLETE = {"Support", "Value"}


def growing(files: dict[str, bytes]) -> dict[str, bool]:
    """Public enumerations and errors of the runtime -> whether they are marked as `non_exhaustive`."""
    found = {}
    for path, data in files.items():
        text = data.decode("utf-8") if re.fullmatch(r"src/(?!sets/|types)[\w/]+\.rs", path) else ""
        for attributes, kind, name in re.findall(r"((?:^#\[.*\]\n)*)^pub (enum|struct) (\w+)", text, re.MULTILINE):
            if kind == "enum" or name.endswith("Error"):
                found[name] = "#[non_exhaustive]\n" in attributes
    return found


def test_what_may_grow_is_not_exhaustive() -> None:
    found = growing(rendered("invented"))
    assert len(found) > 12
    assert {name for name, grows in found.items() if not grows} == COMPLETE
    text = " ".join((ROOT / "docs/versions.md").read_text("utf-8").split())
    promise = text.partition("- `#[non_exhaustive]`: ")[2].partition(" A `match`")[0]
    others = {name for name in found if "Error" not in name} - COMPLETE
    assert [name for name in others if f"`{name}`" not in promise] == []


# --------------------------------------------------------------------------- the package


def test_manifest() -> None:
    """What the registry demands, and what it shows."""
    for spec in SPECS:
        package = manifest(spec)
        for key in ("description", "license", "readme", "documentation", "rust_version"):
            assert package[key], key
        assert package["repository"] == (specification(spec).protocol.repository or None)
        assert len(package["keywords"]) <= 5 and all(re.fullmatch(r"[a-z][\w-]{0,19}", k) for k in package["keywords"])
        assert len(package["categories"]) <= 5
        docs = package["metadata"]["docs"]["rs"]
        assert docs["all-features"] and docs["rustdoc-args"] == ["--cfg", "docsrs"] and len(docs["targets"]) == 1
        readme = rendered(spec)["README.md"].decode("utf-8")
        links = re.findall(r"\]\(([^)]*)\)", readme)
        assert all(link.startswith("https://") for link in links), links  # others lead nowhere in a registry


@heavy(LONG)
def test_package(tmp_path: Path) -> None:
    """From a folder that is in no repository and has been worked in; what is packed builds by itself."""
    folder = tmp_path / "mip-protocol"
    shutil.copytree(crate("invented"), folder, ignore=shutil.ignore_patterns("target", "Cargo.lock"))
    (folder / "notes.txt").write_text("not for others")
    (folder / "target").mkdir()
    (folder / "target/junk").write_text("")
    assert not any((parent / ".git").exists() for parent in folder.parents)
    passes(folder, "package", "--quiet", CARGO_TARGET_DIR=str(tmp_path / "target"))
    (archive,) = (tmp_path / "target/package").glob("*.crate")
    with tarfile.open(archive) as packed:
        found = {name.partition("/")[2] for name in packed.getnames()}
    made = {"Cargo.toml.orig", "Cargo.lock"}
    wanted = {name for name in rendered("invented") if not name.startswith(".") and name != "rustfmt.toml"}
    assert found == wanted | made | {"LICENSE"}
    assert archive.stat().st_size < 10_000_000  # the registry takes no more
