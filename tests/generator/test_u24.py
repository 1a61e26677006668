"""What a further scalar costs: `u24` is added to a copy of the project by the edits that docs/architecture.md lists,
and a field with it is encoded and decoded in C, Python and Rust. The bytes are computed by hand."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import crates
import pytest
from support import ROOT, SPECS, need

FIELD = """set: 0x90
name: wide
title: Wide
description: A set with a number of three bytes.
fields:
  - data: 0x01
    name: reading
    title: Reading
    description: Three bytes between others.
    parameters:
      - {name: before, type: u8, description: One byte.}
      - {name: number, type: u24, description: Three bytes.}
      - {name: after, type: u16, description: Two bytes.}
      - {name: length, type: u8, description: How many follow.}
      - {name: more, type: u24, count: length, description: More numbers of three bytes.}
"""
#: before 1, number 0x123456, after 0xABCD; two more: 1, 0xFEDCBA
WIRE = "01123456ABCD02000001FEDCBA"
#: What the programs print.
SAID = [WIRE, "1", "123456", "ABCD", "1", "FEDCBA"]

#: File -> the texts there, and what is written in their place. First the row, then a word for each language.
EDITS: dict[str, list[tuple[str, str]]] = {
    "generator/mipgen/model/types.py": [
        ('        Scalar("float", 4', '        Scalar("u24", 3, "unsigned"),\n        Scalar("float", 4'),
    ],
    "templates/c/language.yaml": [("  u32: uint32_t\n", "  u24: uint32_t\n  u32: uint32_t\n")],
    "templates/python/language.yaml": [("u32: I,", "u24: T, u32: I,")],
    "templates/rust/language.yaml": [("u32: u32,", 'u24: "crate::U24", u32: u32,')],
    # The primitive of C: two functions, a kind of step, and its place in the tables for printing.
    "runtime/c/src/mip/core.h": [
        ("/** Reads a 32-bit big-endian integer. */", """/** Reads a 24-bit big-endian integer. */
static inline uint32_t mip_get_24(const uint8_t *from) {
    return (uint32_t)from[0] << 16 | (uint32_t)from[1] << 8 | from[2];
}

/** Writes a 24-bit big-endian integer. */
static inline void mip_put_24(uint8_t *to, uint32_t value) {
    to[0] = (uint8_t)(value >> 16);
    to[1] = (uint8_t)(value >> 8);
    to[2] = (uint8_t)value;
}

/** Reads a 32-bit big-endian integer. */"""),
    ],
    "runtime/c/src/mip/core/program.h": [
        ("/** Doubles. */", """/** The kind of three-byte numbers, in four bytes of memory. */
#define MIP_KIND_24 2
/** Numbers of 24 bits. */
#define MIP_24_BITS(count, place) MIP_NUMBERS(MIP_KIND_24, count), place
/** Doubles. */"""),
    ],
    "runtime/c/src/mip/core/codec.c": [
        ("#ifdef __OPTIMIZE_SIZE__\n", """/** Reads or writes numbers of 24 bits. */
static uint8_t *move_24(uint8_t *wire, uint8_t *memory, size_t count, bool writing) {
    for (; count > 0; count--) {
        uint32_t number;
        if (writing) {
            memcpy(&number, memory, sizeof(number));
            mip_put_24(wire, number);
        } else {
            number = mip_get_24(wire);
            memcpy(memory, &number, sizeof(number));
        }
        wire += 3;
        memory += sizeof(number);
    }
    return wire;
}

#ifdef __OPTIMIZE_SIZE__
"""),
        ("    if (kind == MIP_KIND_DOUBLE && sizeof", """    if (kind == MIP_KIND_24) {
        return move_24(wire, memory, count, writing);
    }
    if (kind == MIP_KIND_DOUBLE && sizeof"""),
        ("    if (sizeof(double) < 8 && step <", """    if (step < MIP_NUMBERS(MIP_KIND_24 + 1, 0)) {
        return move_24(wire, memory, count, writing);
    }
    if (sizeof(double) < 8 && step <"""),
    ],
    "runtime/c/src/mip/core/program.c": [
        ("MIP_NUMBERS(MIP_KIND_DOUBLE, 0)", "MIP_NUMBERS(MIP_KIND_24, 0)"),
        ("take(s, n << (kind & 3))", "take(s, kind == MIP_KIND_24 ? 3 * n : n << (kind & 3))"),
    ],
    "runtime/c/src/mip/extra/reflect.h": [
        ("#define MIP_SCALAR_CHAR 11\n", "#define MIP_SCALAR_CHAR 11\n/** 24 bits. */\n#define MIP_SCALAR_U24 12\n"),
    ],
    "runtime/c/src/mip/extra/print.c": [
        ("    case MIP_SCALAR_U32:", "    case MIP_SCALAR_U24:\n    case MIP_SCALAR_U32:"),
    ],
    # The primitive of Rust: a type.
    "runtime/rust/src/lib.rs": [("pub use codec::{Bool,", "pub use codec::{Bool, U24,")],
    "runtime/rust/src/codec.rs": [
        ("/// A Boolean that keeps its byte", """/// A number of 24 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct U24(pub u32);

impl Item for U24 {
    const BLANK: Self = Self(0);
}

impl Wire for U24 {
    const SIZE: usize = 3;
    const FIXED: bool = true;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, Invalid> {
        reader.bytes().map(|[a, b, c]: [u8; 3]| Self(u32::from_be_bytes([0, a, b, c])))
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeErrorKind> {
        let [_, a, b, c] = self.0.to_be_bytes();
        writer.put(&[a, b, c])
    }
}

/// A Boolean that keeps its byte"""),
    ],
    "runtime/rust/src/dynamic/value.rs": [
        ("use crate::codec::{Bool,", "use crate::codec::{Bool, U24,"),
        ("impl ToValue for Bool {", """impl ToValue for U24 {
    fn to_value(&self) -> Value {
        self.0.to_value()
    }
}

impl FromValue for U24 {
    fn from_value(value: &Value) -> Result<Self, ValueError> {
        let number = u32::from_value(value)?;
        (number >> 24 == 0).then_some(Self(number)).ok_or(ValueError::Range)
    }
}

impl ToValue for Bool {"""),
    ],
    # The primitive of Python: `struct` has no letter for three bytes.
    "runtime/python/mip_protocol/codec.py": [("\nimport struct\n", "\nfrom . import wide_struct as struct\n")],
}  # fmt: skip
WIDE_STRUCT = '''"""`struct` with the letter T for a number of three bytes."""

from struct import Struct as Narrow
from struct import calcsize as narrow_size
from struct import error, pack, unpack


def calcsize(layout):
    return narrow_size(layout.replace("T", "3s"))


def Struct(layout):
    return Wide(layout) if "T" in layout else Narrow(layout)


class Wide:
    def __init__(self, layout):
        self.size, self.inner = calcsize(layout), Narrow(layout.replace("T", "3s"))
        samples = self.inner.unpack(bytes(self.size))
        self.wide = [i for i, value in enumerate(samples) if value == bytes(3)]

    def unpack_from(self, data, at=0):
        values = [*self.inner.unpack_from(data, at)]
        for i in self.wide:
            values[i] = int.from_bytes(values[i], "big")
        return tuple(values)

    def unpack(self, data):
        self.inner.unpack(data)
        return self.unpack_from(data)

    def pack(self, *values):
        values = [*values]
        for i in self.wide:
            values[i] = values[i].to_bytes(3, "big")
        return self.inner.pack(*values)
'''

IN_C = """
#include "mip/mip.h"
#include <stdio.h>

int main(void) {
    const struct mip_wide_reading value = {1, 0x123456, 0xABCD, 2, {1, 0xFEDCBA}};
    uint8_t buffer[64];
    struct mip_builder builder;
    struct mip_wide_reading back;
    if (mip_builder_start(&builder, buffer, sizeof(buffer), 0x90) != MIP_OK ||
        mip_wide_reading_encode(&value, &builder) != MIP_OK) {
        return 1;
    }
    const struct mip_field field = {buffer + 6, 13, 0x90, 0x01};
    for (int i = 0; i < 13; i++) {
        printf("%02X", field.data[i]);
    }
    if (mip_decode(&mip_wide_reading_codec, &back, &field, NULL) != MIP_OK) {
        return 2;
    }
    printf(" %u %lX %X", back.before, (unsigned long)back.number, back.after);
    printf(" %lX %lX\\n", (unsigned long)back.more[0], (unsigned long)back.more[1]);
    return 0;
}
"""
IN_PYTHON = """
from mip_protocol import wide
value = wide.Reading(before=1, number=0x123456, after=0xABCD, more=(1, 0xFEDCBA))
back = wide.Reading.decode(value.encode())
print(value.encode().hex().upper(), f"{back.before} {back.number:X} {back.after:X}", *map("{:X}".format, back.more))
"""
IN_RUST = """
use mip_protocol::{wide::Reading, Field, U24};

fn main() {
    let mut value = Reading::default();
    (value.before, value.number, value.after) = (1, U24(0x12_3456), 0xABCD);
    value.more = [U24(1), U24(0xFE_DCBA)].into();
    let mut buffer = [0; 16];
    let size = value.encode(&mut buffer).unwrap();
    let back = Reading::decode(&buffer[..size]).unwrap();
    let hex: String = buffer[..size].iter().map(|b| format!("{b:02X}")).collect();
    let more: Vec<String> = back.more.iter().map(|n| format!("{:X}", n.0)).collect();
    println!("{hex} {} {:X} {:X} {}", back.before, back.number.0, back.after, more.join(" "));
}
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The output of a copy of the project with `u24`, for the small specification with one more set."""
    copy = tmp_path_factory.mktemp("u24")
    ignored = shutil.ignore_patterns("__pycache__")
    for name in ("generator", "templates", "runtime", "spec/schema", "examples", "docs/parts"):
        shutil.copytree(ROOT / name, copy / name, ignore=ignored)
    shutil.copy(ROOT / "LICENSE", copy)
    for path, edits in EDITS.items():
        text = (copy / path).read_text("utf-8")
        for old, new in edits:
            assert text.count(old) == 1, (path, old)
            text = text.replace(old, new)
        (copy / path).write_text(text, "utf-8")
    (copy / "runtime/python/mip_protocol/wide_struct.py").write_text(WIDE_STRUCT, "utf-8")
    shutil.copytree(SPECS["invented"][0], copy / "small")
    (copy / "small/sets/wide.yaml").write_text(FIELD, "utf-8")
    targets = [word for name in ("c", "python", "rust") for word in ("--target", name)]
    run(copy, sys.executable, "-m", "mipgen", "generate", "--spec", "small", "--out", "out", *targets)
    return copy / "out"


def run(folder: Path, *command: str) -> str:
    environment = {**os.environ, "PYTHONPATH": str(folder / "generator")}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    return done.stdout


@pytest.mark.parametrize("flags", [["-O2"], ["-Os"]], ids="".join)
def test_c_has_a_further_scalar(flags: list[str], made: Path, tmp_path: Path) -> None:
    (tmp_path / "main.c").write_text(IN_C, "utf-8")
    sources = [str(path) for path in sorted((made / "c/src/mip").glob("*/*.c"))]
    command = [need("cc"), "-std=c99", "-Wall", "-Wextra", "-Werror", *flags, f"-I{made / 'c/src'}", *sources]
    run(tmp_path, *command, "main.c", "-o", "main")
    assert run(tmp_path, "./main").split() == SAID


def test_python_has_a_further_scalar(made: Path) -> None:
    assert run(made / "python", sys.executable, "-c", IN_PYTHON).split() == SAID


@pytest.mark.xdist_group("cargo")
def test_rust_has_a_further_scalar(made: Path) -> None:
    crate = made / "rust"
    files = {"Cargo.toml": (crate / "Cargo.toml").read_bytes()}
    (crate / "Cargo.toml").write_bytes(crates.without_dependencies(files)["Cargo.toml"])
    (crate / "examples").mkdir(exist_ok=True)
    (crate / "examples/wide.rs").write_text(IN_RUST, "utf-8")
    features = ("--no-default-features", "--features", "wide,dynamic")
    assert crates.passes(crate, "run", "--quiet", "--offline", *features, "--example", "wide").split() == SAID


def test_the_edits_are_those_of_the_document() -> None:
    text = (ROOT / "docs/architecture.md").read_text("utf-8")
    listed = text.partition("## A further scalar\n")[2].partition("\n## ")[0].partition("\n- ")[2]
    named = set(re.findall(r"`([\w/<>]+\.\w+)`", listed))
    found: set[str] = set()
    for path in EDITS:
        general = path.replace(path.split("/")[1], "<name>", 1)
        own = {name for name in named if f"/{path}".endswith(f"/{name}") or general == name}
        assert own, path
        found |= own
    assert found == named
