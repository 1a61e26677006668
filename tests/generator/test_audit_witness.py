"""The comparison with the facts of one revision of the vendor's SDK; specification and facts are made up here."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from bad_spec_files import BASE
from mipgen import cli
from mipgen.audit.witness import audit
from mipgen.resolve.load import load_model
from spec_defaults import filled

COMMANDS = """\
set: 0x05
name: radio
title: Radio
description: Commands.
types:
  tone: {enum: u8, values: {none: 0, low: 1}}
  state: {bitfield: u16, bits: {ready: 0, level: 1-2}}
  step: {struct: [{name: at, type: s16, unit: s}, {name: tone, type: tone}]}
  near: {struct: [{name: first, type: double, unit: m}, {name: second, type: double, unit: m}]}
  far: {struct: [{name: first, type: double, unit: m}, {name: gap, type: double, unit: m}]}
  limit:
    struct: [{name: tone, type: tone}, {name: range, switch: tone, cases: {none: {type: near}, low: {type: far}}}]
fields:
  - command: 0x01
    name: tune
    title: Tune
    description: Tunes.
    sources: [{manual: guide, section: Tune}]
    functions: WRA
    parameters:
      - {name: channel, type: u8, for: WR}
      - {name: tone, type: tone, for: W}
      - {name: enable, type: u8, for: W}
      - {name: num_steps, type: u8, for: W}
      - {name: steps, type: step, count: num_steps, for: W}
    responses: [{response: 0x81, parameters: [{name: state, type: state}]}]
  - command: 0x02
    name: limits
    title: Limits
    description: Limits.
    sources: [{manual: guide, section: Limits}]
    parameters:
      - {name: kind, type: tone}
      - {name: limit, switch: kind, cases: {none: {}, low: {type: limit}}}
named:
  - {command: 0x10, name: ghost, title: Ghost, sources: [{manual: guide, section: Ghost}]}
"""

DATA = """\
name: signal
title: Signal
description: Data.
sets:
  signal: {set: 0x91, title: Signal, description: First., every_field: [{manual: guide, section: Signal}]}
  signal_2: {set: 0x92, title: Signal 2, description: Second., every_field: [{manual: guide, section: Signal}]}
fields:
  - data: 0x07
    name: strength
    title: Strength
    description: Strength.
    parameters: [{name: position, type: vector3f, unit: m, frame: sensor}]
  - data: 0x07
    name: strength_old
    title: Old strength
    description: Strength of another size.
    parameters: [{name: level, type: u16}]
"""

WITNESS = """\
source: {name: kit, commit: abc}
same_layouts: {"0x91": ["0x92"]}
layouts:
- {key: "0x05,0x01", role: command, name: Tune, functions: WR, response: "0x81", parameters: [
  {name: channel, type: u8, for: WR},
  {name: tone, type: u8, enum: Tone, for: W},
  {name: enable, type: bool, for: W},
  {name: num_steps, type: u8, for: W},
  {name: steps, type: struct, struct: Step, by: num_steps, max: 40, for: W}]}
- {key: "0x05,0x02", role: command, name: Limits, parameters: [
  {name: kind, type: u8, enum: Tone},
  {name: limit, type: union, by: kind, cases: [{name: low, type: struct, struct: Limit, when: [LOW, 1]}]}]}
- {key: "0x05,0x81", role: response, name: Tune::Response, parameters: [{name: state, type: u16, bitfield: State}]}
- {key: "0x91,0x07", role: data, name: Strength, parameters: [{name: position, type: float, count: 3, of: Vector3f}]}
structs:
  Step: [{name: at, type: s16}, {name: tone, type: u8, enum: Tone}]
  Limit: [{name: tone, type: u8, enum: Tone}, {name: first_limit, type: double}, {name: second_limit, type: double}]
enums:
  Tone: {type: u8, values: {NONE: 0, LOW: 1}}
bitfields:
  State: {type: u16, bits: {READY: [0, 1], LEVEL: [1, 2], RESERVED: [3, 13]}}
named: {"0x05,0x10": CMD_GHOST, "0x91,0x07": DATA_STRENGTH}
"""


@pytest.fixture(scope="module")
def spec(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("specification") / "spec"
    shutil.copytree(BASE, folder)
    for name, text in (("sets/a", COMMANDS), ("sets/b", DATA)):
        (folder / f"{name}.yaml").write_text(filled(text), "utf-8")
    manual = folder / "manuals/guide.yaml"
    manual.write_text(manual.read_text("utf-8").partition("sections:")[0], "utf-8")
    return folder


def findings(spec: Path, folder: Path, old: str = "", new: str = "") -> list[str]:
    assert old in WITNESS
    (folder / "witness.yaml").write_text(WITNESS.replace(old, new, 1) if old else WITNESS, "utf-8")
    return [f.message for f in audit(load_model(spec), folder)]


def test_what_agrees_is_no_finding(spec: Path, tmp_path: Path) -> None:
    """A boolean is a byte, one structure may have names for all cases, and one of several layouts is enough."""
    assert findings(spec, tmp_path) == []


def test_without_facts_nothing_is_compared(spec: Path, tmp_path: Path) -> None:
    assert audit(load_model(spec), tmp_path) == []


@pytest.mark.parametrize(
    ("old", "new", "messages"),
    [
        ("functions: WR,", "functions: WRS,", ["(0x05,0x01): tune lacks the functions S"]),
        ('response: "0x81"', 'response: "0x82"', ["(0x05,0x01): tune lacks the response 0x82"]),
        ("{name: tone, type: u8, enum: Tone, for: W}", "{name: tone, type: u16, for: W}",
         ["(0x05,0x01): tone is u8, not u16"]),
        ("by: num_steps, max: 40", "count: 4", ["(0x05,0x01): steps is struct counted by parameter 4, not 4 struct"]),
        ("LOW: 1}", "LOW: 1, HIGH: 2}", [
            "(0x05,0x01): tone lacks the value 2 (HIGH)", "(0x05,0x01): steps.tone lacks the value 2 (HIGH)",
            "(0x05,0x02): kind lacks the value 2 (HIGH)", "(0x05,0x02): limit.low.tone lacks the value 2 (HIGH)"]),
        ("RESERVED: [3, 13]", "ERROR: [2, 2]", ["(0x05,0x81): state lacks the bits 2 to 3 (ERROR)"]),
        ("when: [LOW, 1]", "when: [HIGH, 2]", ["(0x05,0x02): limit lacks the case 2 (HIGH)"]),
        ("{name: at, type: s16}, ", "", [
            "(0x05,0x01): steps.at is s16, not u8", "(0x05,0x01): steps.tone is not in the SDK"]),
        ("second_limit, type: double", "second_limit, type: float", [
            "(0x05,0x02): limit.low lacks second_limit float", "(0x05,0x02): limit.low.range is union, not double"]),
        ("float, count: 3, of: Vector3f}", "float, count: 3, of: Vector3f}, {name: age, type: u8, unit: s}", [
            "(0x91,0x07): the field lacks age u8 [s]", "(0x92,0x07): the field lacks age u8 [s]"]),
        ('"0x91,0x07", role', '"0x91,0x08", role', [
            "(0x91,0x08): the data Strength is missing: position float of Vector3f[3]",
            "(0x92,0x08): the data Strength is missing: position float of Vector3f[3]"]),
        ('"0x05,0x02", role', '"0x06,0x02", role', [
            "(0x06,0x02): the command Limits is missing: "
            "kind u8 (NONE 0, LOW 1), limit union[kind]"]),
        ('"0x05,0x10": CMD_GHOST', '"0x05,0x11": CMD_SPECTRE', ["(0x05,0x11): not listed, not even as CMD_SPECTRE"]),
    ],
)  # fmt: skip
def test_what_is_missing(spec: Path, tmp_path: Path, old: str, new: str, messages: list[str]) -> None:
    assert sorted(findings(spec, tmp_path, old, new)) == sorted(messages)


def test_command_line(spec: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A folder with these facts needs no others."""
    findings(spec, tmp_path)
    assert cli.main(["audit", "--spec", str(spec), "--sdk", str(tmp_path)]) == 0
    assert capsys.readouterr().out == "0 findings\n"
