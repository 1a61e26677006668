"""Whole numbers that a double does not represent: constants, values of enumerations, tags and bits of u64."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from bad_spec_files import BASE
from mipgen.emit import output, render
from mipgen.lower import codec
from mipgen.resolve.load import load_model
from spec_defaults import filled
from support import Driver, build_script, decode_request, differences, expected, heavy, need, uses

JAVASCRIPT = pytest.param("javascript", marks=uses("node"))
RUST = pytest.param("rust", marks=[heavy("another crate"), uses("cargo")])

ODD, MOST = 2**53 + 1, 2**64 - 1

SET = f"""set: 0x90
name: large
title: Large
description: Large numbers.
types:
  large: {{enum: u64, values: {{none: 0, odd: {ODD}, even: {ODD - 1}, most: {MOST}}}}}
  wide: {{bitfield: u64, bits: {{low: 0, middle: 53, high: 63}}}}
fields:
  - data: 0x01
    name: odd
    title: Odd
    description: Its constant is that of no double.
    parameters: [{{name: kind, type: u64, const: {ODD}}}, {{name: value, type: u8}}]
  - data: 0x01
    name: most
    title: Most
    description: Another constant.
    parameters: [{{name: kind, type: u64, const: {MOST}}}, {{name: value, type: u8}}]
  - data: 0x02
    name: tagged
    title: Tagged
    description: A tag of eight bytes.
    parameters:
      - {{name: tag, type: large}}
      - {{name: one, switch: tag, cases: {{none: {{}}, odd: {{type: u8}}, even: {{type: u16}}, most: {{type: u32}}}}}}
  - data: 0x03
    name: limits
    title: Limits
    description: The largest and the smallest numbers.
    parameters:
      - {{name: flags, type: wide}}
      - {{name: value, type: large, default: odd}}
      - {{name: gap, type: u64, reserved: {MOST}}}
      - {{name: signed, type: s64, range: [{-(2**63)}, {2**63 - 1}], default: {-(2**63)}}}
      - {{name: place, type: point}}
"""


@pytest.mark.parametrize("language", ["c", "json", "python", JAVASCRIPT, RUST])
def test_large_numbers(language: str, tmp_path: Path) -> None:
    spec = tmp_path / "spec"
    shutil.copytree(BASE, spec)
    (spec / "sets/large.yaml").write_text(filled(SET), "utf-8")
    model = load_model(spec)
    output.write(render.render(language, model), tmp_path / language)
    build = [str(build_script(language)), str(tmp_path / language), str(tmp_path / "build")]
    environment = {"PYTHON": need("python3")}
    done = subprocess.run(build, capture_output=True, text=True, env={**os.environ, **environment})
    assert done.returncode == 0, done.stdout + done.stderr
    driver = Driver(language, done.stdout.splitlines()[-1].split(), environment)

    def sent(descriptor: int, *numbers: int, more: bytes = b"") -> dict[str, Any]:
        data = b"".join(n.to_bytes(8, "big") for n in numbers) + more
        return decode_request(codec.build(model, 0x90, [(descriptor, data)]))

    requests = [sent(1, n, more=b"\x05") for n in (ODD, ODD - 1, ODD + 1, MOST, MOST - 1)]
    requests += [sent(2, n, more=bytes(range(4))) for n in (0, ODD, ODD - 1, ODD + 1, MOST, MOST - 1)]
    requests += [sent(3, 1 << 63 | 1 << 53 | 1, ODD, MOST, 1 << 63, more=bytes(4))]
    requests += [sent(3, ODD, MOST, 1, (1 << 63) - 1, more=bytes(4))]
    fields = [field for r in requests for field in expected(model, r)["fields"] if "values" in field]
    keys = ("descriptor", "name", "values")
    requests += [{"op": "encode", "set": 0x90, "fields": [{key: f[key] for key in keys}]} for f in fields]
    assert len(fields) == 10
    wrong = differences(requests, [expected(model, r) for r in requests], driver.ask(requests))
    assert not wrong, wrong
