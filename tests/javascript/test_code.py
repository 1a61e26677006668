"""The programs of the builder are those on the pages of the reference, which are compiled and run there."""

from __future__ import annotations

import json
import math
import os
import struct
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.lower import codec
from mipgen.targets.c import api as c
from mipgen.targets.javascript import api as javascript
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust
from random_values import drawn
from support import SPECS, heavy, model, need, rounds, small, uses
from workbench import workbench

#: It needs Node.
pytestmark = uses("npm")

HERE = Path(__file__).parent


def programs(spec: str, calls: dict[str, Any], folder: Path) -> dict[str, dict[str, str]]:
    """What the builder writes for these calls: function selectors, for typical values, or whole values."""
    path = folder / "calls.json"
    path.write_text(json.dumps(calls))
    command = [need("node"), HERE / "programs.mjs", workbench(spec), path]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: dict[str, dict[str, str]] = json.loads(done.stdout)
    return found


@small("programs for many values")
def test_typical_values_of_every_command_and_field(spec: str, tmp_path: Path) -> None:
    of = model(spec)
    samples = SampleValues(of)
    asked = [f for f in of.fields if f.role != m.RESPONSE]
    calls = {
        f.full_name: [x.function and x.function.value for x in samples.shown(f)] if f.role == m.COMMAND else None
        for f in asked
    }
    found = programs(spec, calls, tmp_path)
    for f in asked:
        assert found[f.full_name] == wanted(f, samples), f.full_name


def wanted(f: m.Field, samples: SampleValues) -> dict[str, str]:
    """What the generator writes in each language."""
    each = {"c": c, "python": python, "rust": rust, "javascript": javascript}
    writers = {language: api.Programs(samples) for language, api in each.items()} | {"cpp": c.CppPrograms(samples)}
    return {language: of.command(f) if f.role == m.COMMAND else of.data(f) for language, of in writers.items()}


# --------------------------------------------------------------------------- other values


class Given(SampleValues):
    """These values in place of sample ones."""

    def __init__(self, of: m.Model, given: codec.Values) -> None:
        super().__init__(of)
        object.__setattr__(self, "given", given)

    def values(self, f: m.Field, call: m.Call) -> codec.Values:
        found: codec.Values = self.given  # type: ignore[attr-defined]
        return found

    def shown(self, f: m.Field) -> list[m.Call]:
        function = self.given.get("function") if f.selector else None  # type: ignore[attr-defined]
        return [c for c in f.calls if (c.function and c.function.value) == function]


def writable(p: m.Parameter, value: Any) -> Any:
    """A value that every language can write: printable, finite, exact in JSON; bools are 0 or 1."""
    if p.struct:
        values = record(p.struct.parameters, value)
        return values | {
            q.name: reserved(q) for q in p.struct.parameters if q.name in values and q.reserved is not None
        }
    if p.union:
        return record(p.alternatives, value)
    if p.kind == "text":
        return "".join(chr(33 + ord(x) % 94) for x in value)
    if p.kind == "array":
        return [writable(p.item, x) for x in value]
    if p.kind != "scalar":
        return value
    if p.scalar.kind == "float":
        number = struct.unpack(">f" if p.size == 4 else ">d", bytes.fromhex(value[2:]))[0]
        return value if math.isfinite(number) else "0x" + bytes(p.size).hex()
    return value & 1 if p.scalar.kind == "bool" else value >> 11 if p.size == 8 else value


def record(parameters: tuple[m.Parameter, ...], values: codec.Values) -> codec.Values:
    known = {p.name: p for p in parameters}
    return {name: writable(known[name], value) for name, value in values.items()}


def others(of: m.Model, count: int) -> Iterator[tuple[m.Field, codec.Values]]:
    """Random values of commands, without optional ones; unions have the member that their tag selects."""
    for f in of.fields:
        if f.role != m.COMMAND:
            continue
        for values in drawn(f, count):
            call = next((c for c in f.calls if (c.function and c.function.value) == values.get("function")), None)
            if f.selector and (call is None or call.function is None):
                continue
            assert call is not None
            wanted = {p.name for p in call.required if p.constant is None} | ({"function"} if f.selector else set())
            found = record(f.parameters, {k: v for k, v in values.items() if k in wanted})
            unions = [p for p in call.required if p.cases]
            known = all(found[p.name] or found[str(p.tag)] in [c.tag.value for c in p.cases] for p in unions)
            if found.keys() == wanted and known:
                yield f, found | {p.name: reserved(p) for p in call.required if p.reserved is not None}


def reserved(p: m.Parameter) -> Any:
    """The value that constructors set."""
    return codec.canonical(p, p.reserved if p.length is None else [p.reserved] * int(p.length), p.name)


@small("programs for many values")
def test_other_values(spec: str, tmp_path: Path) -> None:
    """The same text as the generator writes, whose typical programs other tests compile; two languages are run here."""
    of, seen, bodies = model(spec), 0, []
    for round_ in range(rounds(1, 3)):
        chosen = {f.full_name: (f, values) for f, values in others(of, 3 + round_)}
        found = programs(spec, {name: [values] for name, (_, values) in chosen.items()}, tmp_path)
        for name, (f, values) in chosen.items():
            assert found[name] == wanted(f, Given(of, values)), name
            bodies.append((f, values, found[name]))
            seen += 1
    assert seen > (100 if spec == "real" else 10)
    run_python(spec, bodies)
    run_javascript(spec, bodies, tmp_path)


Bodies = list[tuple[m.Field, codec.Values, dict[str, str]]]


def run_python(spec: str, bodies: Bodies) -> None:
    """The programs send what the reference codec encodes."""
    script = [
        "import sys",
        "class Device:",
        "    def request(self, command):",
        "        sys.stdout.write(command.encode().hex() + '\\n')",
        "device = Device()",
        "print = lambda response: None",
    ]
    for _, _, texts in bodies:
        script.append(texts["python"])
    environment = {**os.environ, "PYTHONPATH": str(SPECS[spec][1] / "python")}
    done = subprocess.run(
        [sys.executable, "-"], input="\n".join(script), capture_output=True, text=True, env=environment, check=False
    )
    assert done.returncode == 0, done.stderr[-2000:]
    same(bodies, "python", done.stdout)


def same(bodies: Bodies, language: str, output: str) -> None:
    sent = output.splitlines()
    assert len(sent) == len(bodies)
    for (f, values, texts), data in zip(bodies, sent, strict=True):
        assert data == codec.encode(f, values).hex(), (f.full_name, texts[language])


def run_javascript(spec: str, bodies: Bodies, folder: Path) -> None:
    """The same for programs in JavaScript, each of which is a module."""
    (folder / "node_modules").mkdir()
    (folder / "node_modules/mip-protocol").symlink_to(SPECS[spec][1] / "javascript")
    script = [
        'import { toHex } from "mip-protocol";',
        "const request = async (command) => process.stdout.write(`${toHex(command.encode())}\\n`);",
        "globalThis.device = { request };",
        "console.log = () => {};",
    ]
    for i, (_, _, texts) in enumerate(bodies):
        (folder / f"{i}.mjs").write_text(texts["javascript"], "utf-8")
        script.append(f'await import("./{i}.mjs");')
    (folder / "all.mjs").write_text("\n".join(script), "utf-8")
    done = subprocess.run([need("node"), folder / "all.mjs"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    same(bodies, "javascript", done.stdout)


@heavy("g++")
@pytest.mark.parametrize("spec", sorted(SPECS))
def test_other_values_compile(spec: str, tmp_path: Path) -> None:
    """In C and C++."""
    chosen = {f.full_name: [values] for f, values in others(model(spec), 3)}
    found = programs(spec, chosen, tmp_path)
    includes = f"-I{SPECS[spec][1]}/c/src"
    for language, ending, device in (("c", "c", "struct mip_device *device"), ("cpp", "cpp", "mip::device<> &device")):
        ends = ("device.h", "stdio.h") if language == "c" else ("cpp/device.hpp", "iostream")
        heads, functions = {f'#include "mip/{ends[0]}"', f"#include <{ends[1]}>"}, []
        for i, texts in enumerate(found.values()):
            head, _, body = texts[language].partition("\n")
            heads.add(head)
            functions.append(f"void f_{i}({device});\nvoid f_{i}({device}) {{{body}\n}}")
        source = tmp_path / f"programs.{ending}"
        source.write_text("\n".join([*sorted(heads), *functions]), "utf-8")
        flags = (
            ["-std=c99", "-Wno-unused-variable"]
            if language == "c"
            else ["-std=c++17", "-pedantic-errors", "-Wno-unused"]
        )
        command = [
            need("cc" if language == "c" else "g++"),
            *flags,
            "-fsyntax-only",
            "-Wall",
            "-Werror",
            includes,
            source,
        ]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr[:4000]


def spoiled(parameters: tuple[m.Parameter, ...], values: codec.Values) -> tuple[str, codec.Values] | None:
    """The name of the first reserved parameter, and the values with another one there."""
    for p in parameters:
        if p.name not in values or values[p.name] == []:
            continue
        value = values[p.name]
        first = value[0] if isinstance(value, list) else value
        if p.reserved is not None:
            scalar = p.element.scalar if isinstance(p.element, (m.Enum, m.Bitfield)) else p.element
            assert isinstance(scalar, m.Scalar)
            other = "0x41000000" if scalar.kind == "float" else first ^ 2
            return p.name, values | {p.name: [other, *value[1:]] if isinstance(value, list) else other}
        if isinstance(p.element, m.Struct) and (inside := spoiled(p.element.parameters, first)):
            name, other = inside
            return name, values | {p.name: [other, *value[1:]] if isinstance(value, list) else other}
    return None


@small("programs for many values")
def test_another_value_of_what_is_reserved(spec: str, tmp_path: Path) -> None:
    """Constructors set it: a program would send something other than the packet beside it."""
    commands = (f for f in model(spec).fields if f.role == m.COMMAND)
    typical = ((f, SampleValues(model(spec)).values(f, f.calls[0])) for f in commands)
    chosen = {f.full_name: found for f, values in typical if (found := spoiled(f.parameters, values))}
    found = programs(spec, {name: [values] for name, (_, values) in chosen.items()}, tmp_path)
    for name, (reserved_, _) in chosen.items():
        why = f"{reserved_} is reserved; set it in the object of the command"
        assert set(found[name].values()) == {f"MipError program: no program can be given here: {why}"}, name
    if spec == "real":
        assert {"filter.speed_measurement", "3dm.gnss_assisted_fix", "gnss.signal_config", "aiding.pressure"} <= {
            *chosen
        }


@heavy("programs for many values")
def test_a_union_without_a_value(tmp_path: Path) -> None:
    """The type of the union has no name: C leaves it out of its structure, where {0} would lack braces."""
    of = model("real")
    f = of.field("3dm.event_trigger_config")
    assert f is not None
    held = {"descriptor_set": 0x82, "field_descriptor": 5, "parameter_id": 1, "type": 9, "thresholds": {}}
    values = {"function": 1, "instance": 1, "type": 2, "parameters": {"threshold": held}}
    text = programs("real", {f.full_name: [values]}, tmp_path)[f.full_name]["c"]
    assert text == c.Programs(Given(of, values)).command(f) and "thresholds" not in text
    source = tmp_path / "program.c"
    head, _, body = text.partition("\n")
    source.write_text(
        f"{head}\nvoid program(struct mip_device *device);\nvoid program(struct mip_device *device) {{"
        f"{body}\n(void)result;}}"
    )
    flags = ["-std=c99", "-fsyntax-only", "-Wall", "-Wextra", "-Wmissing-braces", "-Werror"]
    command = [need("cc"), *flags, f"-I{SPECS['real'][1]}/c/src", source]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
