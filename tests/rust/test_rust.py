"""The Rust crate as its users see it: no_std, features, lints, documentation, and its own tests.

What every field does is tested by `everything.py`, which writes a Rust test from the specification;
the rest is in `cases/`.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import everything
import pytest
from crates import WORK, bare, cargo, crate, passes, project, rendered, specification, without_dependencies, write
from mipgen import model as m
from mipgen.emit import output, render
from mipgen.resolve.load import load_model
from mipgen.resolve.subset import Selection, select
from mipgen.targets.rust import names
from random_values import chance
from support import ROOT, SEED, heavy, locked, need, nightly, rounds
from support import driver as conformance_driver

HERE = Path(__file__).parent
EMBEDDED = "thumbv7m-none-eabi"
LONG = "the Rust crate in many more builds"
each = pytest.mark.parametrize("spec", ["difficult", "invented", "real"])
#: The real crate is ten times as large: `make test` leaves to `make test-all` what would only find the same again. All
#: bytes of the real one are in the conformance suite.
small = pytest.mark.parametrize(
    "spec", ["invented", *(pytest.param(spec, marks=heavy(LONG)) for spec in ("difficult", "real"))]
)


@cache
def embedded(machine: str = EMBEDDED) -> str:
    """A target without an operating system and without std."""
    installed = subprocess.run([need("rustup"), "target", "list", "--installed"], capture_output=True, text=True)
    if machine not in installed.stdout.split():
        done = subprocess.run([need("rustup"), "target", "add", machine], capture_output=True, text=True)
        assert done.returncode == 0, f"rustup target add {machine}: {done.stderr}"
    return machine


def cargo_tests(*names: str, folder: Path = HERE / "cases") -> str:
    return "\n".join(f'[[test]]\nname = "{name}"\npath = "{folder / name}.rs"\n' for name in names)


# --------------------------------------------------------------------------- what users do with it


def test_cases() -> None:
    """Packets, parser, presence, unions, client, trees: hand-written, with the invented specification."""
    names = sorted(p.stem for p in (HERE / "cases").glob("*.rs"))
    out = passes(project("invented", "cases", cargo_tests(*names)), "test", "--offline", "--quiet")
    assert out.count("test result: ok") >= len(names)


@nightly("Miri, of Rust's nightly toolchain")
def test_cases_in_miri() -> None:
    """They do nothing undefined, not even in the standard library, and nothing overflows."""
    names = sorted(p.stem for p in (HERE / "cases").glob("*.rs"))
    folder = project("invented", "cases", cargo_tests(*names))
    out = passes(folder, "+nightly", "miri", "test", "--offline", "--quiet")
    assert out.count("test result: ok") >= len(names)


def share(spec: str) -> int:
    """One in this many fields and devices is tested: compiling the tests of all real ones takes minutes, and the
    difficult ones are besides those of the invented specification."""
    return rounds({"real": 10, "difficult": 2}.get(spec, 1), 1)


def all_of(spec: str) -> str:
    return everything.source(specification(spec), share(spec), SEED)


def with_everything(spec: str) -> Path:
    target = '[[test]]\nname = "everything"\npath = "everything.rs"\n'
    return project(spec, "everything", target, files={"everything.rs": all_of(spec).encode()})


@small
def test_everything(spec: str) -> None:
    """Every constructor, accessor, constant, default, link and truncation of a specification."""
    out = passes(with_everything(spec), "test", "--offline", "--quiet", "--test", "everything")
    count = sum(1 for line in all_of(spec).splitlines() if line == "#[test]")
    assert f"test result: ok. {count} passed" in out
    assert count > len(specification(spec).fields) / share(spec)


@heavy(LONG)
def test_a_wrong_constructor_would_be_noticed() -> None:
    """So the tests above can fail."""
    wrong = everything.source(specification("invented")).replace("tools::Settings::write(", "tools::Settings::apply(")
    target = '[[test]]\nname = "everything"\npath = "everything.rs"\n'
    folder = project("invented", "wrong", target, files={"everything.rs": wrong.encode()})
    done = cargo(folder, "test", "--offline", "--quiet", "--test", "everything")
    assert done.returncode != 0 and "test result: FAILED" in done.stdout
    assert re.findall(r"^    (\w+)$", done.stdout, re.MULTILINE) == ["tools_settings"]


def test_a_list_that_is_too_long_does_not_compile() -> None:
    code = b"#[test]\nfn test() { let _: mip_protocol::List<u8, 2> = [1, 2, 3].into(); }\n"
    folder = project("invented", "long", '[[test]]\nname = "long"\npath = "long.rs"\n', files={"long.rs": code})
    done = cargo(folder, "test", "--offline", "--quiet", "--test", "long")
    assert done.returncode != 0 and "more items than the list can hold" in done.stderr


FEATURES = '"std", "dynamic", "serde", "embedded-io", "embedded-io-async"'


@contextmanager
def with_dependencies(spec: str = "difficult") -> Iterator[Path]:
    """A project that uses the crate with the real dependencies, pinned in features/Cargo.lock."""
    folder = WORK / spec / "features"
    manifest = f"""[package]
name = "features"
version = "0.0.0"
edition = "2021"
publish = false

[dependencies]
mip-protocol = {{ path = "mip-protocol", features = [{FEATURES}] }}
embedded-io = "0.7"
embedded-io-async = "0.7"
serde = "1"
serde_json = {{ version = "1", features = ["float_roundtrip"] }}

[[test]]
name = "json"
path = "{HERE / "features" / "json.rs"}"

[[test]]
name = "features"
path = "{HERE / "features" / "features.rs"}"

[[test]]
name = "embedded"
path = "{HERE / "features" / "embedded.rs"}"

[workspace]
members = ["mip-protocol"]
"""
    with locked(WORK / f"{spec}-features"):
        output.write(rendered(spec), folder / "mip-protocol")
        lock = (HERE / "features/Cargo.lock").read_bytes()
        write({"Cargo.toml": manifest.encode(), "src/lib.rs": b"", "Cargo.lock": lock}, folder)
        yield folder


@heavy(LONG)
def test_serde_and_embedded_io() -> None:
    with with_dependencies() as folder:
        passes(folder, "test", "--quiet")


@nightly("the real Rust crate with serde")
def test_every_field_goes_to_json_and_comes_back() -> None:
    """For the real specification; the test above does so for the difficult one, which has every kind of field."""
    with with_dependencies("real") as folder:
        passes(folder, "test", "--quiet", "--test", "json")


@heavy(LONG)
def test_lints_of_dependencies() -> None:
    """Features that bring a dependency alone and with a set, of which the seed draws some; and all together."""
    manifest = rendered("difficult")["Cargo.toml"].decode("utf-8")
    alone = re.findall(r'^([\w-]+) = \[.*"dep:', manifest, re.MULTILINE)
    assert len(alone) == manifest.count("optional = true")
    few = [["--no-default-features", f"--features={name}{sets}"] for name in alone for sets in ("", ",tools")]
    few.append(["--features=embedded-io-async,core-error"])
    some = chance("dependencies").sample(few, rounds(1, len(few)))
    with with_dependencies() as folder:
        for features in (*some, ["--all-features"]):
            passes(folder, "clippy", "--quiet", "-p", "mip-protocol", *features, "--", "-D", "warnings")


@heavy(LONG)
def test_documentation_of_all_features() -> None:
    """As docs.rs builds it: every link leads somewhere, and items that a dependency brings say so."""
    environment = {"RUSTC_BOOTSTRAP": "1", "RUSTDOCFLAGS": "--cfg docsrs -D warnings"}
    target = WORK / "target-docs"
    with with_dependencies() as folder:
        doc = ("doc", "--quiet", "--no-deps", "-p", "mip-protocol", "--all-features")
        passes(folder, *doc, CARGO_TARGET_DIR=str(target), **environment)
    for item, feature in (("EmbeddedPort", "embedded-io"), ("AsyncDevice", "embedded-io-async")):
        text = (target / f"doc/mip_protocol/device/struct.{item}.html").read_text("utf-8")
        assert f"Available on crate feature {feature} only" in re.sub(r"<[^>]+>", "", text), item


@heavy(EMBEDDED)
def test_dependencies_without_std() -> None:
    with with_dependencies() as folder:
        for features in ("serde,defmt", "embedded-io,embedded-io-async"):
            passes(folder, "check", "--quiet", "--target", embedded(), "-p", "mip-protocol", "--features", features)


# --------------------------------------------------------------------------- what the crate promises


@heavy(EMBEDDED)
@pytest.mark.parametrize("spec", ["difficult", "invented"])  # the real one is linked below
def test_no_std(spec: str) -> None:
    """It builds for a target that has no std; `alloc` and the trees of values do too."""
    for features in ("", "alloc", "dynamic") if spec == "invented" else ("dynamic",):
        passes(bare(spec), "check", "--quiet", "--offline", "--target", embedded(), "--features", features)


@heavy(EMBEDDED)
@pytest.mark.parametrize("spec", ["difficult", "real"])
def test_nothing_panics(spec: str) -> None:
    """A program that uses every field links although its panic handler does not."""
    target = f'[[bin]]\nname = "no_panic"\npath = "{HERE / "no_panic.rs"}"\ntest = false\n'
    folder = project(spec, "no_panic", target, features="")
    build = ("build", "--quiet", "--offline", "--release", "--target", embedded())
    passes(folder, *build)
    if spec == "real":  # the other one shows that a panic would be noticed
        return
    source = (HERE / "no_panic.rs").read_text("utf-8")
    assert "let mut rest = input();" in source
    spoiled = source.replace("let mut rest = input();", "let mut rest = &input()[1..];")
    target = '[[bin]]\nname = "panics"\npath = "panics.rs"\ntest = false\n'
    folder = project(spec, "panics", target, features="", files={"panics.rs": spoiled.encode()})
    done = cargo(folder, *build)
    assert done.returncode != 0 and "a_panic_can_be_reached" in done.stderr


def whole(spec: str) -> str:
    """The program of `whole.rs`, with each command in each of its functions."""
    commands = [f for f in specification(spec).fields if f.role == m.COMMAND]
    types = [everything.path(f) for f in commands]
    types += [f"mip_protocol::Call<{everything.path(f)}, {x.value}>" for f in commands for x in f.functions]
    lines = "".join(f"    black_box(command::<{t}> as fn(&{t}, Parts<'_>));\n" for t in types)
    return (HERE / "whole.rs").read_text("utf-8") + f"\npub fn every_command() {{\n{lines}}}\n"


def panics(spec: str, source: str) -> str:
    """How functions for a microcontroller, all of the crate and of a program, reach a panic, if any does.

    The compiler makes all of them, used or not, with checks for overflow; the linker keeps what they need. Formatting
    is left out, because it is in the standard library; so are two functions of constants.
    """
    target, flags = embedded("thumbv7em-none-eabi"), "-Clink-dead-code -Coverflow-checks -Cpanic=abort"
    folder = project(spec, "whole", "", features="", files={"src/lib.rs": source.encode()})
    build, build_flags = WORK / "target-whole", {"RUSTFLAGS": flags, "CARGO_PROFILE_RELEASE_LTO": "off"}
    passes(folder, "build", "--quiet", "--offline", "--release", "--target", target,
           CARGO_TARGET_DIR=str(build), **build_flags)  # fmt: skip
    made = [build / target / "release/libwhole.rlib", *(build / target / "release/deps").glob("libmip_protocol-*.rlib")]
    names, roots = [], []
    for readable in ([], ["-C"]):
        done = subprocess.run([need("nm"), *readable, *made], capture_output=True, text=True)
        names.append(re.findall(r"^[0-9a-f]{8} T (.*)", done.stdout, re.MULTILINE))
    for symbol, name in zip(*names, strict=True):
        ours = re.match(r"<?&?(mip_protocol|whole)::|<.* as mip_protocol::", name)
        if ours and not re.search(r"fmt::|::debug|registry::(rows|count)\b", name):
            roots.append(f"-u {symbol}\n")
    (build / "roots").write_text("".join(roots))
    assert len(roots) > 50 * len(specification(spec).fields)
    sysroot = Path(subprocess.run([need("rustc"), "--print", "sysroot"], capture_output=True, text=True).stdout.strip())
    (linker,) = sysroot.glob("lib/rustlib/*/bin/rust-lld")
    libraries = [
        p for name in ("core", "compiler_builtins") for p in sysroot.glob(f"lib/rustlib/{target}/lib/lib{name}-*.rlib")
    ]
    done = subprocess.run(
        [linker, "-flavor", "gnu", "--gc-sections", "--why-live=*panicking*", f"@{build}/roots", *made, *libraries,
         "-o", build / "linked"], capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0 or "rust_begin_unwind" in done.stderr, done.stderr[-3000:]
    return (done.stdout + done.stderr)[:6000] if done.returncode else ""


@pytest.mark.parametrize(
    "spec",
    [
        pytest.param("invented", marks=heavy(EMBEDDED)),
        pytest.param("real", marks=nightly("all of Rust for a microcontroller")),
    ],
)
def test_no_function_panics(spec: str) -> None:
    """Not even one that nobody calls."""
    assert not panics(spec, whole(spec))
    if spec == "invented":
        planted = "\npub fn planted(data: &[u8]) -> u8 {\n    data[0]\n}\n"
        assert "whole::planted" in panics(spec, whole(spec) + planted)


@heavy(LONG)
def test_the_small_forms_for_microcontrollers_find_the_same_packets() -> None:
    """They are chosen by the width of pointers, so no other test on this machine runs them."""
    files = without_dependencies(rendered("invented"))
    source = files["src/packet.rs"].decode()
    small = source.replace('const HOST: bool = cfg!(target_pointer_width = "64");', "const HOST: bool = false;")
    assert small != source
    folder = WORK / "small"
    write({**files, "src/packet.rs": small.encode()}, folder / "bare")
    manifest = project("invented", "small", cargo_tests("packets")) / "Cargo.toml"
    write({"Cargo.toml": manifest.read_bytes(), "src/lib.rs": b"#![no_std]\n"}, folder / "small")
    assert "test result: ok" in passes(folder / "small", "test", "--offline", "--quiet")


INLINED = """
use std::hint::black_box;
use mip_protocol::{measurements, packets};

fn main() {
    for packet in packets(black_box(&[])) {
        for field in packet.fields().flatten() {
            black_box(field.get::<measurements::Accel>());
        }
    }
}
"""


@heavy(LONG)
def test_reading_fields_is_part_of_the_loop() -> None:
    """Even without LTO: as a call that returns each field in memory, decoding is half as fast."""
    target = '[[bin]]\nname = "inlined"\npath = "inlined.rs"\ntest = false\n'
    folder = project("invented", "inlined", target, features="", files={"inlined.rs": INLINED.encode()})
    default = ("--config", "profile.release.lto=false", "--config", "profile.release.codegen-units=16")
    passes(folder, "build", "--quiet", "--offline", "--release", *default)
    program = WORK / "target" / "release" / "inlined"
    symbols = subprocess.run([need("nm"), "-C", str(program)], capture_output=True, text=True, check=True).stdout
    assert "inlined::main" in symbols
    calls = [line for line in symbols.splitlines() if "packet::Fields" in line or "codec::" in line]
    assert not calls


@heavy(LONG)
def test_checksums_have_vector_instructions() -> None:
    """Compilers find them only in code of a certain form; without them, a parser takes twice as many instructions."""
    assembly = WORK / "checksum.s"
    build = ("rustc", "--quiet", "--offline", "--release", "--lib", "--target", embedded("x86_64-unknown-linux-gnu"))
    passes(bare("invented"), *build, "--", "-Ccodegen-units=1", "--emit", f"asm={assembly}")
    found = re.search(r"^_\w*6packet5quick\w*:\n(.*?)\.cfi_endproc", assembly.read_text("utf-8"), re.M | re.S)
    assert found is not None
    assert len(re.findall(r"\tmovdqu\t\S+\(", found[1])) >= 3  # blocks, the last block, and its mask, each loaded whole


@each
def test_formatted(spec: str) -> None:
    done = cargo(crate(spec), "fmt", "--check")
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr


UNUSED = ("--force-warn", "dead_code", "--force-warn", "unused_macros")


def lints(spec: str, *features: str) -> str:
    """No lint has anything to say; what it would say of unused code is returned."""
    lint = ("clippy", "--quiet", "--offline", *features, "--", "-D", "warnings", "-W", "clippy::pedantic", *UNUSED)
    done = cargo(bare(spec), *lint)
    assert done.returncode == 0, done.stderr[-6000:]
    return done.stderr


@small
def test_lints(spec: str) -> None:
    """clippy also says where something is newer than the oldest Rust that the manifest promises."""
    lints(spec, "--features", "std,dynamic")


@heavy(LONG)
@each
def test_each_family_alone_builds(spec: str) -> None:
    """A family is a feature that brings the families whose types it needs, and nothing warns without the others. The
    seed draws some of them."""
    same = {x.name for x in specification("invented").families} if spec == "difficult" else set()
    families = [names.feature(x) for x in specification(spec).families if x.name not in same]
    assert families
    for name in ("", *chance("families", spec).sample(families, rounds(1, len(families)))):
        lints(spec, "--no-default-features", "--features", name)


PARTS = {
    "device": ("real", Selection(devices=("3dm-gx5-15",))),
    "set": ("real", Selection(sets=("base",))),
    "field": ("invented", Selection(fields=("tools.ping",))),
}


@pytest.mark.parametrize(
    "part", ["field", *(pytest.param(p, marks=heavy(LONG)) for p in ("device", "set", "no devices"))]
)
def test_a_part_of_a_specification_builds(part: str, tmp_path: Path) -> None:
    """Nothing warns about what only the rest would use."""
    folder = WORK / "parts" / part
    if part in PARTS:
        spec, selection = PARTS[part]
        of = select(specification(spec), selection)
    else:
        shutil.copytree(ROOT / "tests/bad_specs/base", tmp_path / "spec", ignore=lambda *_: ["devices", "guides"])
        of = load_model(tmp_path / "spec")
    with locked(WORK / f"part-{part}"):
        write(without_dependencies(render.render("rust", of)), folder)
    for features in ("", "std,dynamic"):
        passes(folder, "clippy", "--quiet", "--offline", "--features", features, "--", "-D", "warnings")


@heavy(LONG)
def test_the_whole_has_no_dead_code() -> None:
    """What a part may leave unused is used by the whole: `difficult` has all kinds of fields, and `real` a session."""
    unused = []
    for spec in ("difficult", "real"):  # cargo keeps what it has said in `test_lints`
        said = lints(spec, "--features", "std,dynamic")
        unused.append({*re.findall(r"`(\w+)`", " ".join(re.findall(r"^warning: .*", said, re.MULTILINE)))})
    assert not unused[0] & unused[1]


@each
def test_all_sets_are_there_by_default(spec: str) -> None:
    manifest = rendered(spec)["Cargo.toml"].decode("utf-8")
    default = manifest.partition("default = [\n")[2].partition("]")[0]
    assert default.split() == [f'"{names.feature(x)}",' for x in specification(spec).families]


def test_the_registry_lists_the_sets_that_are_there() -> None:
    own = [f for f in specification("invented").fields if f.family == "tools"]
    code = f"""
#[test]
fn test() {{
    assert_eq!(mip_protocol::registry::FIELDS.len(), {len(own)} + 1); // and the acknowledge field
    let field = mip_protocol::RawField {{ set: 0x80, descriptor: 0x01, data: &[0; 14] }};
    assert!(mip_protocol::AnyField::decode(&field).is_none());
    let field = mip_protocol::RawField {{ set: 0x01, descriptor: 0x01, data: &[] }};
    assert!(mip_protocol::AnyField::decode(&field).is_some());
}}
"""
    target = '[[test]]\nname = "few"\npath = "few.rs"\n'
    folder = project("invented", "few", target, '"tools"', {"few.rs": code.encode()}, default=False)
    passes(folder, "test", "--offline", "--quiet", "--test", "few")


@heavy(LONG)
def test_errors_are_errors_without_std() -> None:
    """The feature `core-error`; without it and `std` they are not, as the oldest compilers require."""
    code = b"""#![no_std]
fn error<E: core::error::Error>() {}
pub fn all() {
    error::<mip_protocol::DecodeError>();
    error::<mip_protocol::EncodeErrorKind>();
    error::<mip_protocol::list::CapacityError>();
    error::<mip_protocol::RequestError>();
    error::<mip_protocol::PacketError>();
    error::<mip_protocol::FieldLengthError>();
    error::<mip_protocol::client::CommandError>();
    error::<mip_protocol::device::DeviceError<mip_protocol::PacketError>>();
}
"""
    folder = project("invented", "core-error", "", '"core-error"', {"src/lib.rs": code})
    passes(folder, "check", "--offline", "--quiet")
    folder = project("invented", "no-error", "", "", {"src/lib.rs": code})
    done = cargo(folder, "check", "--offline", "--quiet")
    assert done.returncode != 0 and "the trait bound" in done.stderr


@heavy(LONG)
def test_documentation_tells_which_feature_brings_an_item() -> None:
    """As docs.rs builds it. The badges need a feature of the compiler that is not stable yet."""
    environment = {"RUSTC_BOOTSTRAP": "1", "RUSTDOCFLAGS": "--cfg docsrs -D warnings"}
    doc = ("doc", "--quiet", "--offline", "--no-deps", "--features", "std,dynamic")
    passes(bare("invented"), *doc, **environment)
    pages = WORK / "target" / "doc" / "mip_protocol"
    for page, feature in (
        ("dynamic/index", "dynamic"),
        ("tools/struct.Ping", "tools"),
        ("struct.PacketReader", "std"),
        ("device/struct.StdPort", "std"),
    ):
        text = re.sub(r"<[^>]+>", "", (pages / f"{page}.html").read_text("utf-8"))
        assert f"Available on crate feature {feature} only" in text, page
    assert 'rustdoc-args = ["--cfg", "docsrs"]' in rendered("invented")["Cargo.toml"].decode("utf-8")


@each
def test_the_front_page_lists_the_modules(spec: str) -> None:
    """Every public module, so that nobody has to search."""
    page = (rendered(spec)["src/map.md"] + rendered(spec)["src/sets.md"]).decode("utf-8")
    lib = rendered(spec)["src/lib.rs"].decode("utf-8")
    families = [names.module(x.name) for x in specification(spec).families]
    for name in (*re.findall(r"^pub mod (\w+);", lib, re.MULTILINE), *families):
        assert name == "dynamic" or f"[`{name}`]" in page, name


@pytest.mark.parametrize("spec", ["invented", pytest.param("real", marks=heavy(LONG))])
def test_documentation(spec: str) -> None:
    """The README and the examples in the documentation run; links lead somewhere.

    The crate is the dependency of another test, for which it is built anyway.
    """
    folder, package = with_everything(spec), ("--quiet", "--offline", "-p", "mip-protocol")
    out = passes(folder, "test", "--doc", *package)
    assert re.search(r"test result: ok\. [1-9]", out)
    passes(folder, "doc", "--no-deps", *package, RUSTDOCFLAGS="-D warnings")


@each
def test_attributes(spec: str) -> None:
    lib = rendered(spec)["src/lib.rs"].decode("utf-8")
    for attribute in ("#![no_std]", "#![forbid(unsafe_code)]", "#![deny(missing_docs)]"):
        assert f"\n{attribute}\n" in lib
    for name, data in rendered(spec).items():
        assert b"unsafe " not in data.replace(b"forbid(unsafe_code)", b""), name
    manifest = rendered(spec)["Cargo.toml"].decode("utf-8")
    assert f'version = "{specification(spec).protocol.version}"' in manifest
    assert 'edition = "2021"' in manifest and 'rust-version = "' in manifest
    dependencies = manifest.partition("[dependencies]\n")[2].partition("\n\n")[0].splitlines()
    assert dependencies and all("optional = true" in line for line in dependencies)
    assert "Cargo.lock" not in rendered(spec)


def test_every_family_is_a_module_with_its_sets() -> None:
    """The names of sets differ, so that several modules can be imported as a whole; no packet has the set of shared
    data."""
    modules = rendered("real")["src/sets.rs"].decode("utf-8")
    found = {}
    for x in specification("real").families:
        name = x.name if not x.name[0].isdigit() else f"mip_{x.name}"
        assert f"\npub mod {name};\n" in modules
        text = rendered("real")[f"src/sets/{name}.rs"].decode("utf-8")
        found[name] = dict(re.findall(r"^pub const (\w+): u8 = (\w+);", text, re.MULTILINE))
    assert {"session", *found} == set(re.findall(r"^pub mod (\w+)", modules, re.MULTILINE))
    assert (found.pop("shared"), found["base"], found["sensor"]) == ({}, {"BASE_SET": "0x01"}, {"SENSOR_SET": "0x80"})
    assert found.pop("gnss_data") == {
        "GNSS_DATA_SET": "0x81", "GNSS_1_SET": "0x91", "GNSS_2_SET": "0x92", "GNSS_CORRECTIONS_SET": "0x93",
        "GNSS_EXTERNAL_SET": "0x94", "GNSS_EXTERNAL_2_SET": "0x95",
    }  # fmt: skip
    assert all(constants.keys() == {f"{name.upper()}_SET"} for name, constants in found.items())


# --------------------------------------------------------------------------- the driver


def build_driver(generated: Path, build: Path) -> str:
    done = subprocess.run(
        [str(HERE / "build_driver.sh"), str(generated), str(build)], capture_output=True, text=True,
        env={**os.environ, "CARGO_PROFILE_RELEASE_OPT_LEVEL": "0"},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()[-1]


def ask(driver: str, *lines: str) -> list[Any]:
    done = subprocess.run([driver], input="".join(f"{line}\n" for line in lines), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@heavy(LONG)
def test_the_driver_is_built_from_any_folder_and_only_once() -> None:
    generated = WORK / 'a "strange" \\ folder\'s name' / "mip-protocol"
    build = WORK / "driver of a strange folder"
    with locked(WORK / "driver"):
        output.write(rendered("invented"), generated)
        driver = build_driver(generated, build)
        built = Path(driver).stat().st_mtime_ns
        assert build_driver(generated, build) == driver
        assert Path(driver).stat().st_mtime_ns == built
    assert ask(driver, '{"op":"encode","set":1,"fields":[]}') == [{"packet": "75650100db05"}]


@pytest.fixture(scope="module")
def driver() -> str:
    return conformance_driver("rust", "invented").command[0]


def test_what_is_no_request_is_refused_and_the_driver_goes_on(driver: str) -> None:
    parse, encode = '{"op":"parse","stream":', '{"op":"encode","set":1,"fields":'
    bad = [
        "", "nonsense", "{", "[1]", "7", '"op"', "null", "{}", '{"op":7}', '{"op":"dance"}', "[" * 99999, '{"a":' * 999,
        '{"op":"parse"}', parse + '"7","chunk":1}', parse + '"zz","chunk":1}', parse + '"00","chunk":0}',
        parse + '"00","chunk":-1}', parse + '"00"}', parse + '"00","chunk":1}x',
        '{"op":"decode"}', '{"op":"decode","packet":5}', '{"op":"decode","packet":"0 "}',
        '{"op":"encode"}', '{"op":"encode","set":1}',
        '{"op":"encode","set":256,"fields":[]}', encode + "[7]}", encode + '[{"raw":"00"}]}',
        encode + '[{"descriptor":256,"raw":"00"}]}', encode + '[{"descriptor":1}]}', encode + "[],}",
        '{"op":"encode" "set":1}', '{"op":"\\x"}', '{"op":"\\ud800"}', '{"op":"\\u12"}', '{"op":"\t"}', '{"op":--1}',
    ]  # fmt: skip
    refused, good, answered = {"error": "request"}, parse + '"00","chunk":1}', {"packets": [], "skipped": 1}
    assert ask(driver, *(line for b in bad for line in (b, good))) == [refused, answered] * len(bad)
    raw = subprocess.run([driver], input=b"\xff\xfe\n\n" + good.encode(), capture_output=True)
    assert [json.loads(line) for line in raw.stdout.splitlines()] == [refused, refused, answered]


def encode(descriptor: int, name: str, values: str) -> str:
    return f'{{"op":"encode","set":128,"fields":[{{"descriptor":{descriptor},"name":"{name}","values":{values}}}]}}'


def decoded(driver: str, packet: str) -> dict[str, Any]:
    (answer,) = ask(driver, json.dumps({"op": "decode", "packet": packet}))
    values: dict[str, Any] = answer["fields"][0]["values"]
    return values


def test_text_is_exact(driver: str) -> None:
    def strings(rest: str) -> str:
        model = json.dumps("é" * 16)
        return encode(3, "measurements.strings", f'{{"model": {model}, "length": 0, "name": "", "rest": {rest}}}')

    text = "".join(map(chr, range(200)))
    for line in (json.dumps(text), json.dumps(text).replace('\\"', "\\u0022")):
        (answer,) = ask(driver, strings(line))
        assert bytes.fromhex(answer["packet"])[6:-2] == b"\xe9" * 16 + b"\0" + bytes(range(200))
        assert decoded(driver, answer["packet"])["rest"] == text
    (answer,) = ask(driver, strings(json.dumps("naïve ÿ", ensure_ascii=False)))
    assert decoded(driver, answer["packet"])["rest"] == "naïve ÿ"
    assert ask(driver, strings('"\\u20ac"'), strings('"\\ud83d\\ude00"')) == [{"error": "range"}] * 2


def test_numbers_are_exact(driver: str) -> None:
    field = specification("invented").field("measurements.numbers")
    assert field is not None
    zeros = {p.name: 0 for p in field.parameters} | {"float": "0x00000000", "double": "0x0000000000000000"}

    def number(name: str, value: str) -> str:
        return encode(2, "measurements.numbers", json.dumps(zeros).replace(f'"{name}": 0', f'"{name}": {value}'))

    for name, value in (("u64", 2**64 - 1), ("s64", -(2**63)), ("u64", 2**53 + 1), ("s8", -128)):
        (answer,) = ask(driver, number(name, str(value)))
        assert decoded(driver, answer["packet"])[name] == value
    for name, value in (("u64", 2**64), ("s64", 2**63), ("u8", -1), ("s8", 128), ("u32", 10**60), ("s32", -(10**60))):
        assert ask(driver, number(name, str(value))) == [{"error": "range"}], (name, value)
    assert ask(driver, number("u8", "1.5"), number("u8", "1e2")) == [{"error": "range"}] * 2
