"""The comparison with facts about another source's layouts; specification and facts are made up here."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from bad_spec_files import BASE
from mipgen import cli
from mipgen.audit import sdk
from mipgen.audit.sdk import audit
from mipgen.read.nodes import Node
from mipgen.read.position import Position
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from small_specs import field
from spec_defaults import filled

HERE = Position("layouts.yaml", 1, 1)


def at(value: Any) -> Node:
    return Node(value, HERE)


COMMANDS = """\
set: 0x05
name: radio
title: Radio
description: Commands.
types:
  tone: {enum: u8, uncertain: [How loud.], values: {none: 0, low: 1, high: 4}}
  step: {struct: [{name: at, type: s16, unit: s}, {name: tone, type: tone}]}
  older: {bitfield: u16, bits: {ready: 3}}
fields:
  - command: 0x01
    name: tune
    title: Tune
    also: [set_frequency]
    description: Tunes.
    sources: [{manual: guide, section: Tune}]
    functions: WRA
    parameters:
      - {name: channel, type: u8, for: WR, range: [1, 8]}
      - {name: tone, type: tone, for: W, default: none}
      - {name: gain, type: float, unit: ~, for: W, above: 0}
      - {name: spare, type: u8, for: W, reserved: 1}
      - {name: num_steps, type: u8, for: W}
      - {name: steps, type: step, count: num_steps, for: W}
    responses: [{response: 0x81, parameters: as_command}]
  - command: 0x02
    name: survey
    title: Survey
    description: Asks.
    sources: [{manual: guide, section: Survey}]
    responses:
      - response: 0x82
        parameters: [{name: num_steps, type: u8}, {name: steps, type: step, count: num_steps}]
  - command: 0x03
    name: wrong
    title: Wrong
    description: The other source has another layout.
    sources: [{manual: guide, section: Wrong}]
    parameters: [{name: a, type: u8}]
named:
  - {command: 0x10, name: ghost, title: Ghost, sources: [{manual: guide, section: Ghost}]}
"""

DATA = """\
name: signal
title: Signal
description: Data.
sets:
  signal: {set: 0x91, title: Signal, description: Data., every_field: []}
  signal_2: {set: 0x92, title: Second signal, description: Data., every_field: []}
fields:
  - data: 0x07
    name: strength
    title: Strength
    description: Data.
    deprecated: there is nothing better
    sources: [{manual: guide, section: Strength}]
    parameters:
      - {name: connected, type: bool}
      - {name: level, type: s32, valid: connected}
      - {name: place, type: vector3f, unit: m, frame: sensor, valid: flags.ready}
      - {name: gaps, type: double, count: 2, reserved: 0}
      - {name: flags, type: flags}
named:
  - {data: 0x60, name: shade, title: Shade, sources: [{manual: guide, section: Shade}]}
"""

ERRATA = """\
errata:
  - id: guide-wrong
    manual: guide
    section: Wrong
    severity: wire
    printed: It has two parameters.
    right: It has one.
    reason: It was measured.
"""

LAYOUTS = """\
source: guide
vendor_sets: [{set: 0x05}, {set: 0x91}, {set: 0x92, repeats: 0x91}]
new_units: {s: time}
sets:
  - set: 0x05
    layouts:
      - descriptor: 0x01
        role: command
        functions: WR
        facts: [The gain must be greater than 0.]
        parameters:
          - {name: number, type: u8, for: WR, range: [1, 8]}
          - {name: sound, type: u8, for: W, default: none, values: {none: 0, soft: {value: 1}, loud: 4}}
          - {name: gain, type: float, for: W, range: [0, ~]}
          - {name: rest, type: u8, for: W, reserved: 1}
          - {name: count, type: u8, for: W}
          - {name: list, struct: hop, count: count, for: W,
             members: [{name: t, type: s16, unit: s}, {name: s, type: u8, values: {none: 0, soft: 1, loud: 4}}]}
        response: 0x81
        uncertain: How loud it is.
      - {descriptor: 0x81, role: response, of: 0x01, parameters: as_command}
      - {descriptor: 0x02, role: command, parameters: [], response: 0x82}
      - {descriptor: 0x82, role: response, of: 0x02,
         parameters: [{name: n, type: u8}, {name: x, struct: hop, count: n, members: [{name: t}, {name: s}]}]}
      - {descriptor: 0x03, role: command, parameters: [{name: a, type: u8}, {name: b, type: u8}]}
  - set: 0x91
    layouts:
      - descriptor: 0x07
        role: data
        deprecated: true
        parameters:
          - {name: ok, type: bool}
          - {name: level, type: s32, valid: ok}
          - {name: position, type: float, count: 3, unit: m, frame: sensor, valid: bits.set}
          - {name: gaps, type: double, count: 2, reserved: 0}
          - name: bits
            type: u16
            bits: {set: 0, level: {bits: 4-6, alias: true}, reserved: 7-15}
            alternative: {bitfield: other, bits: {set: 3}}
named_only:
  0x05: {command: {0x10: ghost, 0x02: survey}, response: {0x81: tune}}
  0x91: {data: {0x60: shade}}
"""

NAMES = """\
0x05,0x01,command: set_frequency
0x05,0x81,response: [set_frequency, tune]
0x91,0x07,data: strength
"""

TUNE, STRENGTH = "(0x05,0x01) radio.tune", "(0x91,0x07) signal.strength"


@pytest.fixture(scope="module")
def spec(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("specification") / "spec"
    shutil.copytree(BASE, folder)
    for name, text in (("sets/a", COMMANDS), ("sets/b", DATA), ("errata/d", ERRATA)):
        (folder / f"{name}.yaml").write_text(filled(text), "utf-8")
    manual = folder / "manuals/guide.yaml"
    manual.write_text(manual.read_text("utf-8").partition("sections:")[0], "utf-8")
    return folder


def lay(folder: Path, layouts: str = LAYOUTS, names: str = NAMES) -> Path:
    (folder / "layouts.yaml").write_text(layouts, "utf-8")
    (folder / "names.yaml").write_text(names, "utf-8")
    return folder


def findings(spec: Path, folder: Path, layouts: str = LAYOUTS, names: str = NAMES) -> list[str]:
    return [f.message for f in audit(load_model(spec), lay(folder, layouts, names))]


def test_what_agrees_is_no_finding(spec: Path, tmp_path: Path) -> None:
    assert findings(spec, tmp_path) == []


@pytest.mark.parametrize(
    ("fact", "other", "messages"),
    [
        ("{name: ok, type: bool}", "{name: ok, type: u8}", ["connected: type bool, not u8"]),
        ("type: float, count: 3", "type: float, count: 4", ["place: type 3 float, not 4 float"]),
        ("type: float, count: 3", "type: vector3d", ["place: type 3 float, not 3 double"]),
        ("unit: m, frame", "unit: s, frame", ["place: unit m, not s"]),
        ("unit: m, frame", "frame", ["place: unit m, not none"]),
        ("frame: sensor", "frame: ned", ["place: frame sensor, not ned"]),
        ("double, count: 2, reserved: 0", "double, count: 2", ["gaps: reserved 0.0, not none"]),
        ("valid: ok", "valid: bits.set",
         ["level: valid parameter 1, not parameter 5, bit 0"]),
        ("valid: bits.set", "valid: bits.level",
         ["place: valid parameter 5, bit 0, not parameter 5, bit 4"]),
        ("{set: 0, level", "{set: 1, level",
         ["flags: bits 0, 4-6, not 1, 4-6", "place: valid parameter 5, bit 0, not parameter 5, bit 1"]),
        ("bits: {set: 3}", "bits: {set: 2}", ["flags: no type has the bits of other"]),
        ("deprecated: true", "deprecated: false", ["deprecated: True"]),
        ("deprecated: true", "deprecated: true\n        uncertain: All.", ["nothing of it is uncertain"]),
        ("          - {name: ok, type: bool}\n", "", ["it has 5 parameters, not 4"]),
    ],
)  # fmt: skip
def test_a_difference_of_data(spec: Path, tmp_path: Path, fact: str, other: str, messages: list[str]) -> None:
    assert LAYOUTS.count(fact) == 1
    found = findings(spec, tmp_path, LAYOUTS.replace(fact, other))
    second = STRENGTH.replace("0x91", "0x92").replace("signal", "signal_2")
    assert found == [f"{which}: {text}" for which in (STRENGTH, second) for text in messages]


@pytest.mark.parametrize(
    ("fact", "other", "messages"),
    [
        ("functions: WR\n", "functions: WRS\n", ["functions RW, not RSW"]),
        ("for: WR, range: [1, 8]", "for: W, range: [1, 8]", ["channel: for WR, not W"]),
        ("range: [1, 8]", "range: [1, ~]", ["channel: range >= 1 <= 8, not >= 1"]),
        ("[The gain must be greater than 0.]", "[]", ["gain: range > 0, not >= 0"]),
        ("default: none, values", "default: soft, values", ["tone: default none, not soft"]),
        ("soft: {value: 1}, loud: 4", "soft: {value: 1}", ["tone: values 0, 1, 4, not 0, 1"]),
        ("reserved: 1}", "reserved: 0}", ["spare: reserved 1, not 0"]),
        ("struct: hop, count: count", "struct: hop, count: number",
         ["steps: type struct counted by parameter 5, not struct counted by parameter 1"]),
        ("{name: t, type: s16, unit: s}", "{name: t, type: u16, unit: s}", ["steps.at: type s16, not u16"]),
        ("{none: 0, soft: 1, loud: 4}", "{none: 0, soft: 1, loud: 5}", ["steps.tone: values 0, 1, 4, not 0, 1, 5"]),
        ("response: 0x81\n", "response: 0x84\n", ["responses 0x81, not 0x84"]),
    ],
)  # fmt: skip
def test_a_difference_of_a_command(spec: Path, tmp_path: Path, fact: str, other: str, messages: list[str]) -> None:
    assert LAYOUTS.count(fact) == 1
    found = findings(spec, tmp_path, LAYOUTS.replace(fact, other))
    assert [x for x in found if x.startswith(TUNE)] == [f"{TUNE}: {text}" for text in messages]


@pytest.mark.parametrize(
    ("fact", "other", "message"),
    [
        ("of: 0x02", "of: 0x01", "(0x05,0x82) radio.survey_response: answers 0x02, not 0x01"),
        ("- descriptor: 0x07", "- descriptor: 0x08", "(0x91,0x08): 0 fields have the role data"),
        ("{set: 0x91}", "{set: 0x91}, {set: 0x99}", "there is no set 0x99"),
        ("{s: time}", "{mi: distance}", "there is no unit mi"),
        ("0x10: ghost", "0x11: ghost", "(0x05,0x11) is no command, not even by name"),
        ("0x60: shade", "0x61: shade", "(0x92,0x61) is no data, not even by name"),
        (", {name: b, type: u8}]", "]",
         "(0x05,0x03) radio.wrong: no difference, but the erratum 'guide-wrong' tells of one"),
    ],
)  # fmt: skip
def test_another_difference(spec: Path, tmp_path: Path, fact: str, other: str, message: str) -> None:
    assert LAYOUTS.count(fact) == 1
    assert message in findings(spec, tmp_path, LAYOUTS.replace(fact, other))


def test_without_the_erratum_it_is_a_difference(spec: Path, tmp_path: Path) -> None:
    copy = tmp_path / "spec"
    shutil.copytree(spec, copy)
    (copy / "errata/d.yaml").unlink()
    assert findings(copy, tmp_path) == ["(0x05,0x03) radio.wrong: it has 1 parameters, not 2"]


def test_what_fits_by_the_facts_is_right(spec: Path, tmp_path: Path) -> None:
    other = LAYOUTS.replace("{name: t, type: s16", "{name: t, type: s8")
    assert findings(spec, tmp_path, other) != []
    fitting = other.replace("struct: hop, ", "struct: hop, spec_type: step, ")
    assert findings(spec, tmp_path, fitting) == []


def test_names_that_lead_nowhere_or_elsewhere(spec: Path, tmp_path: Path) -> None:
    names = "0x05,0x02,command: tune\n0x05,0x81,response: set_tone\n0x91,0x07,data: [strength, level]\n"
    assert findings(spec, tmp_path, names=names) == [
        "(0x05,0x02): 'tune' leads to radio.tune",
        "(0x05,0x81): 'set_tone_response' leads to no field",
        "(0x91,0x07): 'level' leads to no field",
        "(0x92,0x07): 'level' leads to no field",
    ]


def test_a_file_that_is_missing(spec: Path, tmp_path: Path) -> None:
    lay(tmp_path)
    (tmp_path / "names.yaml").unlink()
    with pytest.raises(SpecError, match=r"^names.yaml:1:1: error: cannot be read"):
        audit(load_model(spec), tmp_path)


def test_command_line(spec: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["audit", "--spec", str(spec)]
    assert cli.main([*arguments, "--sdk", str(lay(tmp_path))]) == 0
    assert capsys.readouterr().out == "0 findings\n"
    lay(tmp_path, names="0x05,0x01,command: turn\n")
    assert cli.main([*arguments, "--sdk", str(tmp_path)]) == 1
    assert capsys.readouterr().out == "names.yaml:1: (0x05,0x01): 'turn' leads to no field\n1 findings\n"
    assert cli.main(arguments) == 1
    assert "nothing to compare with" in capsys.readouterr().err
    assert cli.main([*arguments, "--sdk", str(tmp_path / "no")]) == 1
    assert "no such folder" in capsys.readouterr().err


def test_a_magnitude_bounds_the_elements() -> None:
    vectors = "[{name: a, type: vector3f, magnitude: [~, 5]}, {name: b, type: vector3f, magnitude: [0.9, 1.1]}]"
    a, b = field(vectors).parameters
    assert [sdk._range(a, given) for given in ("", ">= -5 <= 5", ">= -6 <= 6")] == ["", ">= -5 <= 5", ""]
    assert sdk._range(b, "") == ""


def test_a_specification_that_is_ahead_of_the_source() -> None:
    """Bits may be new, and what was reserved may have values."""
    assert sdk._ahead(frozenset({(0, 0), (1, 1), (0, 1)}), frozenset({(0, 0)}))
    assert sdk._ahead(frozenset({(0, 0), (1, 1), (2, 2), (0, 2)}), frozenset({(0, 0), (1, 1), (0, 1)}))
    assert not sdk._ahead(frozenset({(0, 0), (2, 2)}), frozenset({(0, 0), (1, 1)}))
    assert not sdk._ahead(frozenset({0, 1}), frozenset({0}))
    ours = field("[{name: a, type: u8}, {name: b, type: u16}, {name: c, type: u8, count: 2, reserved: 0}]").parameters
    reserved = [Node({"reserved": at(0), "type": at("u8"), "count": at(count)}, HERE) for count in (4, 5)]
    assert [len(sdk._without_reserved(ours, [at({}), node])[0]) for node in reserved] == [1, 3]
