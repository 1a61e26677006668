"""Crates of the specifications and packages that use them, for all tests of Rust.

All of it builds into one target folder, so that a crate is built once for all that use it with the same features.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import difficult_sets
from mipgen import model as m
from mipgen.emit import output, render
from mipgen.resolve.load import load_model
from support import BUILD, SPECS, generated, locked, model, need

WORK = BUILD / "rust"
#: No debug information and no incremental builds: they would take a third of the time.
PROFILE = {"CARGO_INCREMENTAL": "0", "CARGO_PROFILE_DEV_DEBUG": "0", "CARGO_TERM_COLOR": "never"}


def write(files: dict[str, bytes], folder: Path) -> None:
    """Writes only what differs, so that cargo builds nothing needlessly."""
    for name, data in files.items():
        path = folder / name
        if not path.is_file() or path.read_bytes() != data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)


@cache
def specification(spec: str) -> m.Model:
    """`difficult` is the invented specification with some more sets."""
    if spec != "difficult":
        return model(spec)
    folder = WORK / "difficult" / "spec"
    with locked(WORK / "difficult-spec"):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(SPECS["invented"][0], folder)
        for name, text in difficult_sets.files().items():
            (folder / "sets" / name).write_text(text, "utf-8")
        return load_model(folder)


@cache
def cargo_lock() -> bytes:
    """The versions of what the crate and its tests depend on, with the crate's own version of now."""
    text = (Path(__file__).parent / "rust/Cargo.lock").read_text("utf-8")
    own = rf"\g<1>{model('real').protocol.version}"
    return re.sub(r'(name = "mip-protocol", version = ")[^"]*', own, text).encode()


@cache
def rendered(spec: str) -> dict[str, bytes]:
    return generated("rust", spec) if spec in SPECS else render.render("rust", specification(spec))


@cache
def crate(spec: str) -> Path:
    """The crate, unchanged."""
    folder = WORK / spec / "mip-protocol"
    with locked(WORK / f"{spec}-crate"):
        output.write(rendered(spec), folder)
    return folder


@cache
def bare(spec: str) -> Path:
    """The crate without optional dependencies."""
    with locked(WORK / f"{spec}-bare"):
        write(without_dependencies(rendered(spec)), WORK / spec / "bare")
    return WORK / spec / "bare"


def without_dependencies(files: dict[str, bytes]) -> dict[str, bytes]:
    """Cargo resolves optional dependencies even where it does not use them."""
    manifest = files["Cargo.toml"].decode("utf-8")
    manifest = re.sub(r"\[(?:.*\.dev-)?dependencies\]\n(?:.+\n)+", "", manifest)
    manifest = re.sub(r'"(?:dep:[\w-]+|[\w-]+\??/\w+)"(, )?', "", manifest)
    assert "dep:" not in manifest and "dependencies]" not in manifest
    return {**files, "Cargo.toml": f"{manifest}\n[workspace]\n".encode()}


def project(
    spec: str,
    name: str,
    targets: str,
    features: str = '"std", "dynamic"',
    files: dict[str, bytes] | None = None,
    default: bool = True,
) -> Path:
    """A package that uses the crate; for tests of its documentation, cargo wants it without other dependencies."""
    manifest = f"""[package]
name = "{name}"
version = "0.0.0"
edition = "2021"
publish = false
autotests = false

[dependencies]
mip-protocol = {{ path = "../bare", features = [{features}], default-features = {str(default).lower()} }}

{targets}
[profile.release]
lto = true
codegen-units = 1
panic = "abort"

[workspace]
"""
    bare(spec)
    folder = WORK / spec / name
    with locked(WORK / f"{spec}-{name}"):
        write({"Cargo.toml": manifest.encode(), "src/lib.rs": b"#![no_std]\n", **(files or {})}, folder)
    return folder


def cargo(folder: Path, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """One at a time: both specifications make a crate of the same name in one target folder."""
    with locked(WORK / "cargo"):
        return subprocess.run(
            [need("cargo"), *arguments], cwd=folder, capture_output=True, text=True,
            env={**os.environ, "CARGO_TARGET_DIR": str(WORK / "target"), **PROFILE, **environment},
        )  # fmt: skip


def passes(folder: Path, *arguments: str, **environment: str) -> str:
    done = cargo(folder, *arguments, **environment)
    assert done.returncode == 0, f"cargo {' '.join(arguments)}\n{done.stdout[-6000:]}{done.stderr[-6000:]}"
    return done.stdout
