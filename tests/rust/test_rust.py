"""The Rust crate as its users see it: no_std, features, lints, documentation, and its own tests.

What every field does is tested by `everything.py`, which writes a Rust test from the specification;
the rest is in `cases/`.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import everything
import pytest
from bad_spec_files import BASE
from crates import (
    WORK,
    bare,
    cargo,
    cargo_lock,
    crate,
    passes,
    project,
    rendered,
    specification,
    without_dependencies,
    write,
)
from mipgen import model as m
from mipgen.emit import render
from mipgen.resolve.load import load_model
from mipgen.resolve.subset import Selection, select
from mipgen.targets.rust import names
from random_values import chance
from support import SEED, heavy, locked, need, nightly, rounds

HERE = Path(__file__).parent
EMBEDDED = "thumbv7m-none-eabi"
LONG = "the Rust crate in many more builds"
each = pytest.mark.parametrize("spec", ["difficult", "invented", "real"])
CASES = sorted(p.stem for p in (HERE / "cases").glob("*.rs"))


@cache
def embedded(machine: str = EMBEDDED) -> str:
    """A target without an operating system and without std."""
    installed = subprocess.run([need("rustup"), "target", "list", "--installed"], capture_output=True, text=True)
    if machine not in installed.stdout.split():
        done = subprocess.run([need("rustup"), "target", "add", machine], capture_output=True, text=True)
        assert done.returncode == 0, f"rustup target add {machine}: {done.stderr}"
    return machine


# --------------------------------------------------------------------------- what users do with it


def program(spec: str, name: str, cases: Iterable[str] = (), everything: str = "") -> Path:
    """A project whose tests are one program, because linking each alone takes longer than running all."""
    device = "#[allow(unused)]\nuse mip_protocol::device::Device;\n#[allow(unused)]\nconst SLACK: u32 = 0;\n"
    modules = device + "".join(f'#[path = "{HERE}/cases/{case}.rs"]\nmod {case};\n' for case in cases)
    files = {"tests.rs": modules.encode()}
    if everything:
        files = {"tests.rs": f"{modules}mod everything;\n".encode(), "everything.rs": everything.encode()}
    return project(spec, name, f'[[test]]\nname = "{name}"\npath = "tests.rs"\n', files=files)


def all_of(spec: str) -> str:
    """Tests of one in so many fields and devices: compiling those of all real ones takes minutes, and the difficult
    ones are besides those of the invented specification."""
    share = rounds({"real": 10, "difficult": 2}.get(spec, 1), 1)
    found = everything.source(specification(spec), share, SEED)
    assert found.count("#[test]") > len(specification(spec).fields) / share
    return found


def test_cases() -> None:
    """What is written by hand; and every constructor, accessor, constant, default and link of a specification."""
    source = all_of("invented")
    out = passes(program("invented", "cases", CASES, source), "test", "--offline", "--quiet", "--test", "cases")
    (count,) = re.findall(r"test result: ok\. (\d+) passed", out)
    assert int(count) > 60 + source.count("#[test]")


@heavy(LONG)
@pytest.mark.parametrize("spec", ["difficult", "real"])
def test_everything(spec: str) -> None:
    assert "test result: ok" in passes(program(spec, "everything", (), all_of(spec)), "test", "--offline", "--quiet")


@nightly("Miri, of Rust's nightly toolchain")
def test_cases_in_miri() -> None:
    """They do nothing undefined, not even in the standard library, and nothing overflows."""
    out = passes(program("invented", "miri", CASES), "+nightly", "miri", "test", "--offline", "--quiet")
    assert "test result: ok" in out


def test_a_list_that_is_too_long_does_not_compile() -> None:
    code = b"#[test]\nfn test() { let _: mip_protocol::List<u8, 2> = [1, 2, 3].into(); }\n"
    folder = project("invented", "long", '[[test]]\nname = "long"\npath = "long.rs"\n', files={"long.rs": code})
    done = cargo(folder, "test", "--offline", "--quiet", "--test", "long")
    assert done.returncode != 0 and "more items than the list can hold" in done.stderr


FEATURES = '"std", "dynamic", "serde", "embedded-io-07", "embedded-io-async-07"'


@cache
def workspace(spec: str = "difficult") -> Path:
    """The crate and what uses it with the real dependencies, whose versions Cargo.lock pins for all of them."""
    folder, embassy = WORK / spec / "workspace", "mip-protocol/examples/embassy"
    files = {f"mip-protocol/{name}": data for name, data in rendered(spec).items()}
    members = ["features", "mip-protocol"]
    if f"{embassy}/Cargo.toml" in files:  # for everybody else, it is a workspace of its own
        files[f"{embassy}/Cargo.toml"] = files[f"{embassy}/Cargo.toml"].partition(b"[profile.release]")[0]
        members.append(embassy)
    tests = "".join(
        f'[[test]]\nname = "{name}"\npath = "{HERE / "features" / name}.rs"\n'
        for name in ("json", "features", "embedded", "awaited")
    )
    features = f"""[package]
name = "features"
version = "0.0.0"
edition = "2021"
publish = false

[dependencies]
mip-protocol = {{ path = "../mip-protocol", features = [{FEATURES}] }}
embedded-io = "0.7"
embedded-io-async = "0.7"
serde = "1"
serde_json = {{ version = "1", features = ["float_roundtrip"] }}
serde_test = "1"

{tests}"""
    root = f'[workspace]\nmembers = {json.dumps(members)}\nresolver = "2"\n'
    with locked(WORK / f"{spec}-workspace"):
        files |= {"Cargo.toml": root.encode(), "Cargo.lock": cargo_lock(), "features/Cargo.toml": features.encode()}
        write(files | {"features/src/lib.rs": b""}, folder)
    return folder


@heavy(LONG)
def test_serde_and_embedded_io() -> None:
    passes(workspace() / "features", "test", "--quiet")


@nightly("the real Rust crate with serde")
def test_every_field_goes_to_json_and_comes_back() -> None:
    """For the real specification; the test above does so for the difficult one, which has every kind of field."""
    passes(workspace("real") / "features", "test", "--quiet", "--test", "json")


@heavy(LONG)
def test_lints_of_dependencies() -> None:
    """Features that bring a dependency alone and with a set, of which the seed draws some; and all together."""
    manifest = rendered("difficult")["Cargo.toml"].decode("utf-8")
    alone = re.findall(r'^([\w-]+) = \[.*"dep:', manifest, re.MULTILINE)
    assert alone and manifest.count('"dep:') == manifest.count("optional = true")
    few = [["--no-default-features", f"--features={name}{sets}"] for name in alone for sets in ("", ",tools")]
    few.append(["--features=embedded-io-async-07,core-error"])
    some = chance("dependencies").sample(few, rounds(1, len(few)))
    for features in (*some, ["--all-features"]):
        passes(workspace() / "mip-protocol", "clippy", "--quiet", *features, "--", "-D", "warnings")


@heavy(LONG)
def test_documentation_of_all_features() -> None:
    """As docs.rs builds it: every link leads somewhere, and items that a dependency brings say so."""
    environment = {"RUSTC_BOOTSTRAP": "1", "RUSTDOCFLAGS": "--cfg docsrs -D warnings"}
    target = WORK / "target-docs"
    doc = ("doc", "--quiet", "--no-deps", "--all-features")
    passes(workspace() / "mip-protocol", *doc, CARGO_TARGET_DIR=str(target), **environment)
    for page, feature in (
        ("device/struct.EmbeddedPort", "embedded-io-07"),
        ("device/struct.AsyncDevice", "embedded-io-async-07"),
        ("dynamic/index", "dynamic"),
        ("tools/struct.Ping", "tools"),
        ("struct.PacketReader", "std"),
    ):
        text = (target / f"doc/mip_protocol/{page}.html").read_text("utf-8")
        assert f"Available on crate feature {feature} only" in re.sub(r"<[^>]+>", "", text), page


@heavy(EMBEDDED)
def test_dependencies_without_std() -> None:
    for features in ("serde,defmt", "embedded-io-07,embedded-io-async-07"):
        passes(workspace() / "mip-protocol", "check", "--quiet", "--target", embedded(), "--features", features)


# --------------------------------------------------------------------------- what the crate promises


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
        pytest.param("difficult", marks=heavy(EMBEDDED)),
        pytest.param("real", marks=nightly("all of Rust for a microcontroller")),
    ],
)
def test_no_function_panics(spec: str) -> None:
    """Not even one that nobody calls."""
    assert not panics(spec, whole(spec))
    if spec == "difficult":
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
    shutil.copytree(program("invented", "small", ["packets"]), folder / "small", dirs_exist_ok=True)
    assert "test result: ok" in passes(folder / "small", "test", "--offline", "--quiet")


@heavy(LONG)
def test_checksums_have_vector_instructions() -> None:
    """Compilers find them only in code of a certain form; without them, a parser takes twice as many instructions."""
    assembly = WORK / "checksum.s"
    build = ("rustc", "--quiet", "--offline", "--release", "--lib", "--target", embedded("x86_64-unknown-linux-gnu"))
    passes(bare("invented"), *build, "--", "-Ccodegen-units=1", "--emit", f"asm={assembly}")
    found = re.search(r"^_\w*6packet5quick\w*:\n(.*?)\.cfi_endproc", assembly.read_text("utf-8"), re.M | re.S)
    assert found is not None
    assert len(re.findall(r"\tmovdqu\t\S+\(", found[1])) >= 3  # blocks, the last block, and its mask, each loaded whole


def test_formatted() -> None:
    """`make check` formats what is committed."""
    done = cargo(crate("difficult"), "fmt", "--check")
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr


UNUSED = ("--force-warn", "dead_code", "--force-warn", "unused_macros")


def lints(spec: str, *features: str) -> str:
    """No lint has anything to say; what it would say of unused code is returned."""
    lint = ("clippy", "--quiet", "--offline", *features, "--", "-D", "warnings", "-W", "clippy::pedantic", *UNUSED)
    done = cargo(bare(spec), *lint)
    assert done.returncode == 0, done.stderr[-6000:]
    return done.stderr


@heavy(LONG)
def test_lints() -> None:
    """clippy also says where something is newer than the oldest Rust that the manifest promises. What a part may leave
    unused is used by the whole: `difficult` has all kinds of fields, and `real` a session."""
    said = [lints(spec, "--features", "std,dynamic") for spec in ("difficult", "real")]
    unused = [{*re.findall(r"`(\w+)`", " ".join(re.findall(r"^warning: .*", x, re.MULTILINE)))} for x in said]
    assert not unused[0] & unused[1]


@heavy(LONG)
@each
def test_each_family_alone_builds(spec: str) -> None:
    """A family is a feature that brings the families whose types it needs, and nothing warns without the others. The
    seed draws some of them."""
    same = {x.name for x in specification("invented").families} if spec == "difficult" else set()
    families = [names.module(x.name) for x in specification(spec).families if x.name not in same]
    assert families
    for name in ("", *chance("families", spec).sample(families, rounds(1, len(families)))):
        lints(spec, "--no-default-features", "--features", name)


PARTS = {
    "device": ("real", Selection(devices=("3dm-gx5-15",))),
    "set": ("real", Selection(sets=("base",))),
    "field": ("invented", Selection(fields=("tools.ping",))),
}


@heavy(LONG)
@pytest.mark.parametrize("part", [*PARTS, "no devices"])
def test_a_part_of_a_specification_builds(part: str, tmp_path: Path) -> None:
    """Nothing warns about what only the rest would use."""
    folder = WORK / "parts" / part
    if part in PARTS:
        spec, selection = PARTS[part]
        of = select(specification(spec), selection)
    else:
        shutil.copytree(BASE, tmp_path / "spec", ignore=lambda *_: ["devices", "guides"])
        of = load_model(tmp_path / "spec")
    with locked(WORK / f"part-{part}"):
        write(without_dependencies(render.render("rust", of)), folder)
    for features in ("", "std,dynamic"):
        passes(folder, "clippy", "--quiet", "--offline", "--features", features, "--", "-D", "warnings")


@heavy(LONG)
def test_the_registry_lists_the_sets_that_are_there() -> None:
    own = [f for f in specification("invented").fields if f.family == "tools"]
    code = f"""
#[test]
fn test() {{
    assert_eq!(mip_protocol::registry::FIELDS.len(), {len(own)} + 1); // and the acknowledge field
    let field = mip_protocol::RawField {{ set: mip_protocol::DescriptorSet(0x80), descriptor: 0x01, data: &[0; 14] }};
    assert_eq!(mip_protocol::AnyField::decode(&field), Ok(None));
    let field = mip_protocol::RawField {{ set: mip_protocol::DescriptorSet(1), descriptor: 0x01, data: &[] }};
    assert!(matches!(mip_protocol::AnyField::decode(&field), Ok(Some(_))));
}}
"""
    target = '[[test]]\nname = "few"\npath = "few.rs"\n'
    folder = project("invented", "few", target, '"tools", "registry"', {"few.rs": code.encode()}, default=False)
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


@each
def test_the_front_page_lists_the_modules(spec: str) -> None:
    """Every public module, so that nobody has to search; and it is short."""
    assert rendered(spec)["README.md"].count(b"\n") <= 120
    page = (rendered(spec)["src/map.md"] + rendered(spec)["src/sets.md"]).decode("utf-8")
    lib = rendered(spec)["src/lib.rs"].decode("utf-8")
    families = [names.module(x.name) for x in specification(spec).families]
    for name in (*re.findall(r"^pub mod (\w+);", lib, re.MULTILINE), *families):
        assert name == "dynamic" or f"[`{name}`]" in page, name


@heavy(LONG)
@pytest.mark.parametrize("spec", ["invented", "real"])
def test_documentation(spec: str) -> None:
    """The README and the examples in the documentation run; links lead somewhere."""
    folder, package = project(spec, "everything", ""), ("--quiet", "--offline", "-p", "mip-protocol")
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
