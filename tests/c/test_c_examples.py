"""Each printed packet, built in C as a user would: members by name, values by their constants."""

from __future__ import annotations

import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from c_build import SANITIZE, SANITIZED, archive, include, run
from mipgen import model as m
from mipgen.targets.c import members as target_members
from mipgen.targets.c import names
from support import SPECS, model, need

PRELUDE = """
#include <stdio.h>
#include <string.h>

static float f32(uint32_t bits) { float f; memcpy(&f, &bits, 4); return f; }
static double f64(uint64_t bits) { double f; memcpy(&f, &bits, 8); return f; }
static int failed;

static void check(const char *id, struct mip_builder *b, const char *hex) {
    struct mip_packet p = mip_builder_finish(b);
    char text[2 * MIP_MAX_PACKET + 1];
    for (size_t i = 0; i < p.size; i++) {
        snprintf(text + 2 * i, 3, "%02x", p.bytes[i]);
    }
    if (strcmp(text, hex) != 0) {
        printf("%s: %s\\n", id, text);
        failed = 1;
    }
}
"""


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_examples_built_by_hand(spec: str, tmp_path: Path) -> None:
    of, folder = model(spec), SPECS[spec][1] / "c"
    lines = [f'#include "mip/{p.name}"' for p in sorted((folder / "src/mip").glob("*.h"))]
    lines += [PRELUDE, "static uint8_t buffer[MIP_MAX_PACKET];", "static struct mip_builder b;"]
    lines += ["int main(void) {", "(void)f32; (void)f64;"]
    for e in of.examples:
        lines.append(f"mip_builder_start(&b, buffer, sizeof(buffer), {e.set});")
        for f in e.fields:
            field = of.field(f.field) if f.field else None
            lines += raw(f) if field is None or f.trailing else built(field, f.values or {})
        lines.append(f'check("{e.id}", &b, "{e.packet.hex()}");')
    lines += [f'printf("{len(of.examples)} examples\\n");', "return failed;", "}"]
    program = tmp_path / "examples.c"
    program.write_text("\n".join(lines))
    out = tmp_path / "examples"
    flags = ["-std=c99", *SANITIZE]
    library = archive(spec, "cc", *SANITIZED)  # that of the unit programs
    run(need("cc"), *flags, "-Wall", "-Wextra", "-Wconversion", "-Werror", include(spec), program, library, "-o", out)
    done = subprocess.run([str(out)], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout == f"{len(of.examples)} examples\n", done.stdout + done.stderr


def raw(f: m.ExampleField) -> list[str]:
    octets = ", ".join(str(b) for b in f.data) or "0"
    added = f"mip_builder_add(&b, {f.descriptor}, d, {len(f.data)})"
    return [f"{{ const uint8_t d[] = {{{octets}}}; if ({added} != MIP_OK) {{ return 2; }} }}"]


def built(field: m.Field, values: dict[str, Any]) -> list[str]:
    name = names.symbol(field)
    lines = [f"{{ struct {name} v;", "memset(&v, 0, sizeof(v));"]
    lines += members("v", field.parameters, values)
    there = max((i + 1 for i, p in enumerate(field.counted) if p.name in values), default=0)
    if field.optional and there > field.required(values.get("function")):
        lines.append(f"v.present = {there};")
    return [*lines, f'if ({name}_encode(&v, &b) != MIP_OK) {{ printf("{name}\\n"); return 2; }} }}']


def members(path: str, parameters: tuple[m.Parameter, ...], values: dict[str, Any]) -> list[str]:
    lines = []
    for p in parameters:
        if p.name in values and p.constant is None:
            lines += assign(f"{path}.{names.member(p.name)}", p, values[p.name])
    return lines


def assign(path: str, p: m.Parameter, value: Any) -> list[str]:
    if p.tag:
        inner = {c.parameter.name: c.parameter for c in p.cases if c.parameter}
        return [
            line
            for k, v in value.items()
            for line in assign(f"{path}.{target_members.home(inner[k])}{names.member(k)}", inner[k], v)
        ]
    if p.length == "rest":
        rest = assign(path, replace(p, length=len(value)), value)
        return [f"{path}_count = {len(value)};", *rest]
    if isinstance(value, str) and p.length is not None:
        octets = ", ".join(str(b) for b in value.encode("latin-1"))
        return [f"{{ const uint8_t t[] = {{{octets}}}; memcpy({path}, t, sizeof(t)); }}"] if value else []
    if p.length is not None:
        count = [f"{path}_count = {len(value)};"] if p.length == "rest" else []
        return count + [line for i, v in enumerate(value) for line in one(f"{path}[{i}]", p.element, v)]
    return one(path, p.element, value)


def one(path: str, e: Any, value: Any) -> list[str]:
    if isinstance(e, m.Struct):
        return members(path, e.parameters, value)
    if isinstance(e, m.Vector):
        return [line for i, v in enumerate(value) for line in one(f"{path}[{i}]", e.scalar, v)]
    if isinstance(e, m.Bitfield) and isinstance(value, list):
        return [f"{path}.bytes[{i}] = {b};" for i, b in enumerate(value)]
    if isinstance(e, m.Enum):
        known = next((v for v in e.values if v.value == value), None)
        return [f"{path} = {names.constant(e, known) if known else value};"]
    if isinstance(e, m.Scalar) and e.kind == "float":
        return [f"{path} = f{8 * e.size}({value}u{'ll' if e.size == 8 else ''});"]
    return [f"{path} = {value}{'ull' if isinstance(value, int) and value > 0x7FFFFFFF else ''};"]
