"""The comparison with witnesses: a specification and facts that are made up."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
import yaml
from audit import rules, sdk, witnesses
from audit.__main__ import main
from audit.devices import compared_devices, debt
from audit.leaves import written_out
from mipgen.base.errors import Failure
from mipgen.read.loader import load_witnesses
from mipgen.read.problems import Problems, SpecError
from small_specs import load
from support import ROOT, SPECS, model

SPEC = """\
set: 0x05
name: radio
title: Radio
description: Commands.
types:
  tone: {enum: u8, description: Tone., values: {none: 0, low: 1, high: 4}}
  state: {bitfield: u16, description: State., bits: {on: 0, level: {bit: 1-3, description: Level.}}}
  valid: {bitfield: u8, description: Flags., bits: {speed: 0, place: 1}}
  step: {struct: [{name: at, type: s16, unit: s, description: Time.}, {name: size, type: u8, description: Size.}]}
fields:
  - command: 0x01
    name: tune
    title: Tune
    description: Tunes.
    functions: WR
    parameters:
      - {name: channel, type: u8, for: WR, range: [1, 8], description: Channel.}
      - {name: tone, type: tone, for: W, default: low, description: Tone.}
      - {name: state, type: state, for: W, description: State.}
      - {name: gain, type: float, unit: s, for: W, range: "> 0", description: Gain.}
      - {name: spare, type: u8, count: 3, for: W, reserved: 0}
      - {name: num_steps, type: u8, for: W, description: Number.}
      - {name: steps, type: step, count: num_steps, for: W, description: Steps.}
    responses: [{response: 0x81, parameters: as_command}]
  - command: 0x02
    name: move
    also: [run]
    title: Move
    description: Moves.
    parameters:
      - {name: speed, type: float, unit: s, valid: valid_flags.speed, description: Speed.}
      - {name: place, type: vector3f, unit: m, frame: sensor, valid: valid_flags.place, description: Place.}
      - {name: valid_flags, type: valid, description: Flags.}
"""

FACTS = """\
source: {name: made up}
vectors: {Vector3f: [float, xyz]}
units: {s: [seconds, sec], m: [meters]}
layouts:
- {key: "0x05,0x01", role: command, name: Tune, functions: WR, response: "0x81", parameters: [
  {name: channel, type: u8, for: WR, range: [1, 8]},
  {name: tone, type: u8, enum: Tone, for: W, default: 1},
  {name: state, type: u16, bitfield: State, for: W},
  {name: gain, type: float, unit: seconds, for: W, above: 0},
  {name: spare, type: u8, count: 3, for: W},
  {name: num_steps, type: u8, for: W},
  {name: steps, type: struct, struct: Step, by: num_steps, for: W}]}
- {key: "0x05,0x02", role: command, name: "commands_radio::Run", parameters: [
  {name: speed, type: float, unit: sec},
  {name: place, type: float, count: 3, of: Vector3f, unit: meters, frames: [sensor]},
  {name: valid_flags, type: u8, bitfield: Valid}]}
structs:
  Step: [{name: at, type: s16, unit: seconds}, {name: size, type: u8}]
enums:
  Tone: {type: u8, values: {NONE: 0, LOW: 1, HIGH: 4}}
bitfields:
  State: {type: u16, bits: {ON: [0, 1], LEVEL: [1, 3]}}
  Valid: {type: u8, bits: {SPEED: [0, 1], PLACE: [1, 1]}}
named: {}
"""


def report(folder: Path, facts: str = FACTS, accepted: str = "") -> witnesses.Report:
    (folder / "book.yaml").write_text(facts, "utf-8")
    if accepted:
        (folder / "accepted.yaml").write_text(accepted, "utf-8")
    return witnesses.audit_all(load(SPEC), folder)


def findings(folder: Path, facts: str = FACTS, accepted: str = "") -> list[str]:
    found = report(folder, facts, accepted)
    return [f"{d.at}: {d.text}" for d in found.differences] + found.stale


def test_what_agrees_is_no_finding(tmp_path: Path) -> None:
    assert findings(tmp_path) == []


@pytest.mark.parametrize(
    ("fact", "other", "message"),
    [
        ("unit: sec}", "unit: meters}", "move: speed: unit s, witness m"),
        ("frames: [sensor]", "frames: [vehicle]", "move: place.x: frame sensor, witness vehicle"),
        ("ON: [0, 1]", "ON: [5, 1]", "tune: state: bit 0 (on) is not in State"),
        ("LEVEL: [1, 3]", "LEVEL: [1, 2]", "tune: state: bit 1-2 (LEVEL of State) is missing"),
        ("HIGH: 4", "HIGH: 3", "tune: tone: value 3 (HIGH of Tone) is missing"),
        ("NONE: 0, LOW: 1", "NONE: 1, LOW: 0", "tune: tone: value 0 is none, witness LOW"),
        ("default: 1", "default: 4", "tune: tone: default 1, witness 4"),
        ("range: [1, 8]", "range: [1, 9]", "tune: channel: range minimum 1, maximum 8, witness minimum 1, maximum 9"),
        ("above: 0", "above: 1", "tune: gain: range above 0, witness above 1"),
        ("num_steps, type: u8, for: W}", "num_steps, type: u8, for: WR}", "tune: num_steps: for W, witness WR"),
        ("{name: at, type: s16", "{name: at, type: u16", "tune: steps.at: type s16, witness u16"),
        ("count: 3, for", "count: 4, for", "tune: 10 numbers, witness 11"),
        ("by: num_steps", "by: channel", "tune: steps.at: repeated by num_steps, witness channel"),
        ("{name: size, type: u8}", "{name: length, type: u8}", "tune: steps.size: name size, witness length"),
        ("SPEED: [0, 1], PLACE: [1, 1]", "PLACE: [0, 1], SPEED: [1, 1]", "move: speed: valid by bit 0, witness 1"),
        ("radio::Run", "radio::Run::Response", "move: names move, run, witness commands_radio::Run::Response"),
        ("functions: WR", "functions: WRS", "tune: functions WR, witness WRS"),
        ('response: "0x81"', 'response: "0x82"', "tune: responses 0x81, witness 0x82"),
        (
            '"0x05,0x02"',
            '"0x05,0x03"',
            "0x05,0x03: no such command; the witness has commands_radio::Run: speed:float, place:float, valid_flags:u8",
        ),
        ("named: {}", 'named: {"0x05,0x33": LOST}', "0x05,0x33: not listed; the witness names it LOST"),
    ],
)  # fmt: skip
def test_a_difference(tmp_path: Path, fact: str, other: str, message: str) -> None:
    assert FACTS.count(fact) == 1
    found = findings(tmp_path, FACTS.replace(fact, other))
    assert any(line.removeprefix("radio.").startswith(message) for line in found), found


def test_parameters_in_another_order(tmp_path: Path) -> None:
    lines = FACTS.splitlines(True)
    i = next(i for i, line in enumerate(lines) if "name: speed" in line)
    lines[i], lines[i + 1] = lines[i + 1], lines[i]
    assert "radio.move: speed: name speed, witness place" in findings(tmp_path, "".join(lines))


ACCEPTED = """\
differences:
- {at: {book: [radio.move]}, reason: Measured., texts: ["speed: unit s, witness m"]}
names: {size: [length]}
"""


def test_accepted_differences_and_names(tmp_path: Path) -> None:
    facts = FACTS.replace("unit: sec}", "unit: meters}").replace("name: size", "name: length")
    assert findings(tmp_path, facts, ACCEPTED) == []
    further = facts.replace("{name: speed, type: float", "{name: speed, type: u32")
    assert findings(tmp_path, further, ACCEPTED) == ["radio.move: speed: type float, witness u32"]


@pytest.mark.parametrize("name", ["length", "OLD_SIZE", "sz", "OLD_sz"])
def test_names_that_mean_the_same(tmp_path: Path, name: str) -> None:
    facts = FACTS.replace("name: size", f"name: {name}")
    assert {x.partition(": ")[2] for x in findings(tmp_path, facts)} == {f"steps.size: name size, witness {name}"}
    assert findings(tmp_path, facts, "names: {size: [length]}\nprefixes: [OLD_]\nwords: {sz: size}\n") == []


def test_an_accepted_difference_that_is_gone(tmp_path: Path) -> None:
    (found,) = findings(tmp_path, FACTS, ACCEPTED)
    assert found.endswith("radio.move: there is no difference 'speed: unit s, witness m' (book); remove it")
    assert "accepted.yaml:2: " in found


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("layouts: [", "not YAML"),
        ("layouts: []\n", "'source' is missing in the file"),
        (
            FACTS.replace("range: [1, 8]", "rage: [1, 8]"),
            "book.yaml:6:38: error: unknown key 'rage', did you mean 'range'?",
        ),
    ],
)
def test_a_witness_that_cannot_be_read(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(SpecError) as error:
        report(tmp_path, text)
    assert message in str(error.value)


def test_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["--spec", str(ROOT / "tests/invented/spec"), "--witness"]
    assert main([*arguments, str(tmp_path / "no")]) == 1
    assert "no such folder; write --witness FOLDER" in capsys.readouterr().err
    assert main([*arguments, str(tmp_path)]) == 1
    assert "this folder contains no witnesses, that is, no .yaml files" in capsys.readouterr().err
    (tmp_path / "book.yaml").write_text(FACTS, "utf-8")
    assert main([*arguments, str(tmp_path)]) == 1
    assert "0x05,0x01: no such command; the witness has Tune: " in capsys.readouterr().out


def test_another_revision_of_the_sdk(tmp_path: Path) -> None:
    """It may agree where a difference is accepted; what it has in addition is named, with its parameters."""
    accepted = 'differences:\n- {at: {sdk: [radio.move]}, reason: It is so., texts: ["speed: unit s, witness m"]}\n'
    (tmp_path / "sdk.yaml").write_text(FACTS.replace("unit: sec}", "unit: meters}", 1), "utf-8")
    (tmp_path / "accepted.yaml").write_text(accepted, "utf-8")
    assert witnesses.audit_all(load(SPEC), tmp_path).lines() == []
    more = '- {key: "0x05,0x07", role: command, name: Sing, parameters: [{name: key, type: u16}]}\nstructs:'
    newer = tmp_path / "newer/sdk.yaml"
    newer.parent.mkdir()
    newer.write_text(FACTS.replace("structs:", more, 1).replace("named: {}", 'named: {"0x05,0x09": HUM}'), "utf-8")
    (revision,) = load_witnesses(newer.parent, Problems())
    assert [str(d) for d in witnesses.audit_all(load(SPEC), tmp_path, revision.root.plain()).differences] == [
        "0x05,0x07: no such command; the witness has Sing: key:u16 (sdk)",
        "0x05,0x09: not listed; the witness names it HUM (sdk)",
    ]


def test_the_specification_agrees_with_its_witnesses() -> None:
    found = witnesses.audit_all(model("real"), ROOT / "spec/witness")
    assert found.lines() == []
    assert found.counts["layouts"] > 400
    assert found.counts["units"] > 650


# --------------------------------------------------------------------------- a working copy of the SDK

HEADER = """\
#pragma once

namespace mip {
namespace C {
struct mip_interface;
} // namespace C

namespace commands_radio {

enum
{
    DESCRIPTOR_SET = 0x05,

    CMD_TUNE       = 0x01,
    CMD_LOST       = 0x33,

    REPLY_TUNE     = 0x81,
};

static constexpr const uint8_t LOUDEST = 0x09;
enum class Tone : uint8_t
{
    NONE = 0,  ///<
    LOW  = 1,  ///<
};

////////////////////////////////////////////////////////////////////////////////
///@defgroup radio_tune_cpp  (0x05,0x01) Tune
/// Each of the noise values must be greater than 0.0 in the NED frame.
///@{

struct Tune
{
    struct State : Bitfield<State>
    {
        typedef uint16_t Type;
        enum _enumType : uint16_t
        {
            NONE  = 0x0000,
            ON    = 0x0001,  ///<
            LEVEL = 0x000E,  ///<
            ALL   = 0x000F,
        };
        uint16_t value = NONE;

        constexpr State() : value(NONE) {}
        constexpr bool on() const { return (value & ON) > 0; }
    };
    struct Step
    {
        /// Parameters
        int16_t at = 0; ///< Time in seconds
        uint8_t size = 0;

        void extract(Serializer& serializer);
    };
    union Extra
    {
        Step step;
        float speed;

        Extra() {}
    };
    /// Parameters
    FunctionSelector function = static_cast<FunctionSelector>(0);
    uint8_t channel = 0; ///< Channel, counted from 1.
    Tone tone = static_cast<Tone>(0); ///< Tone (1 - high).
    State state; ///< State.
    uint8_t level = 0; ///< Level: <br/> 0=Off, <br/> 1=Low (default).
    Vector3f noise; ///< Noise [meters/second]
    uint8_t num_steps = 0;
    Step steps[7];
    uint16_t masks[3] = {0}; ///< Masks.
    Extra extra;
    union
    {
        double low;
        double interval;
    };

    /// Descriptors
    static constexpr const uint8_t FIELD_DESCRIPTOR = ::mip::commands_radio::CMD_TUNE;
    static constexpr const bool HAS_FUNCTION_SELECTOR = true;

    auto asTuple() const
    {
        return std::make_tuple(channel);
    }

    struct Response
    {
        /// Parameters
        uint8_t channel = 0; ///< Channel, counted from 1.

        static constexpr const uint8_t FIELD_DESCRIPTOR = ::mip::commands_radio::REPLY_TUNE;

        void extract(Serializer& serializer);
    };
};
TypedResult<Tune> writeTune(C::mip_interface& device, uint8_t channel);
TypedResult<Tune> readTune(C::mip_interface& device, uint8_t channel);

///@}
} // namespace commands_radio
} // namespace mip
"""

IMPLEMENTATION = """\
void Tune::Step::extract(Serializer& serializer)
{
    serializer.extract(at);
    serializer.extract(size);
}

void Tune::extract(Serializer& serializer)
{
    serializer.extract(function);

    serializer.extract(channel);

    if( function == FunctionSelector::WRITE )
    {
        serializer.extract(tone);

        serializer.extract(state);

        serializer.extract(level);

        serializer.extract(noise);

        serializer.extract_count(num_steps, sizeof(steps)/sizeof(steps[0]));
        for(unsigned int i=0; i < num_steps; i++)
            serializer.extract(steps[i]);

        for(unsigned int i=0; i < 3; i++)
            serializer.extract(masks[i]);

        if( tone == Tone::NONE )
        {
            serializer.extract(extra.step);

        }
        if( tone == Tone::LOW )
        {
            serializer.extract(extra.speed);

        }
        if( tone == Tone::NONE )
        {
            serializer.extract(low);

        }
        if( tone == Tone::LOW )
        {
            serializer.extract(interval);

        }
    }
}
void Tune::Response::extract(Serializer& serializer)
{
    serializer.extract(channel);

}
"""


def working_copy(folder: Path) -> Path:
    files = {
        "src/cpp/mip/definitions/commands_radio.hpp": HEADER,
        "src/cpp/mip/definitions/commands_radio.cpp": IMPLEMENTATION,
        "src/c/mip/mip_result.h": "    MIP_ACK_OK = 0x00,  ///< Good.\n",
        "src/c/mip/mip_descriptors.h": "    MIP_FUNCTION_WRITE = 0x01,\n",
    }
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")
    return folder


def test_a_working_copy_of_the_sdk(tmp_path: Path) -> None:
    facts = sdk.extract_sdk(working_copy(tmp_path))
    tune, reply = facts["layouts"]
    about = {"key": "0x05,0x01", "role": "command", "name": "commands_radio::Tune", "functions": "WR"}
    assert {key: tune[key] for key in about} == about
    assert tune["response"] == "0x81"
    assert tune["frames"] == ["ned"]
    step = {"type": "struct", "struct": "commands_radio::Tune::Step"}
    vector = {"type": "float", "count": 3, "of": "Vector3f"}
    assert tune["parameters"] == [
        {"name": "channel", "type": "u8", "range": [1.0, None], "for": "WR"},
        {"name": "tone", "type": "u8", "enum": "commands_radio::Tone", "for": "W"},
        {"name": "state", "type": "u16", "bitfield": "commands_radio::Tune::State", "for": "W"},
        {"name": "level", "type": "u8", "values": {"OFF": 0, "LOW": 1}, "default": 1, "for": "W"},
        {"name": "noise", **vector, "unit": "meters/second", "above": 0, "for": "W"},
        {"name": "num_steps", "type": "u8", "for": "W"},
        {"name": "steps", **step, "by": "num_steps", "max": 7, "for": "W"},
        {"name": "masks", "type": "u16", "count": 3, "for": "W"},
        {
            "name": "extra",
            "type": "union",
            "by": "tone",
            "for": "W",
            "cases": [
                {"name": "step", **step, "when": ["NONE", 0]},
                {"name": "speed", "type": "float", "when": ["LOW", 1]},
            ],
        },
        {"name": "low", "type": "double", "for": "W"},
    ]
    assert (reply["key"], reply["parameters"][0]["name"]) == ("0x05,0x81", "channel")
    assert facts["structs"]["commands_radio::Tune::Step"][0] == {"name": "at", "type": "s16", "unit": "seconds"}
    assert facts["enums"]["commands_radio::Tone"] == {"type": "u8", "values": {"NONE": 0, "LOW": 1}}
    assert facts["bitfields"]["commands_radio::Tune::State"] == {"type": "u16", "bits": {"ON": [0, 1], "LEVEL": [1, 3]}}
    assert facts["constants"] == {"commands_radio": {"LOUDEST": 9}}
    assert facts["named"] == {"0x05,0x33": "CMD_LOST"}
    assert facts["enums"]["FunctionSelector"] == {"type": "u8", "values": {"WRITE": 1}}


def test_a_response_with_the_parameters_of_its_command() -> None:
    number = {"name": "channel", "type": "u8"}
    command = {"key": "0x05,0x01", "role": "command", "name": "Tune", "response": "0x81"}
    tune = command | {"parameters": [{**number, "for": "W"}]}
    answer = {"key": "0x05,0x81", "role": "response", "name": "Tune::Response", "parameters": [number]}
    short = [sdk._shortened(x, [tune, answer]) for x in (tune, answer)]
    assert short == [tune, {**answer, "parameters": "as_command"}]
    assert written_out({"layouts": short}) == {"layouts": [tune, answer]}


def test_auditing_a_working_copy(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is compared with the specification, or becomes its witness."""
    copy, spec = working_copy(tmp_path / "copy"), tmp_path / "spec"
    shutil.copytree(SPECS["invented"][0], spec)
    (spec / "witness").mkdir()
    arguments = ["--spec", str(spec), "--sdk", str(copy)]
    assert main([*arguments, "--extract"]) == 0
    assert yaml.safe_load((spec / "witness/sdk.yaml").read_text("utf-8")) == sdk.extract_sdk(copy)
    assert main(arguments) == 1
    assert "0x05,0x01: no such command; the witness has commands_radio::Tune: " in capsys.readouterr().out
    assert main([*arguments[:3], str(tmp_path)]) == 1
    assert "this is no working copy of the vendor's SDK" in capsys.readouterr().err


def test_a_working_copy_of_another_form(tmp_path: Path) -> None:
    copy = working_copy(tmp_path)
    (copy / "src/cpp/mip/definitions/commands_radio.cpp").write_text("// empty\n", "utf-8")
    with pytest.raises(Failure, match="definitions have an unknown format: nothing defines 'Tune"):
        sdk.extract_sdk(copy)


# --------------------------------------------------------------------------- rules

RULES = """\
rules:
- {names: [channel], if_range: [1, ~]}
- {names: [gain, speed], of: float, range: [0, ~]}
- {fields: [radio.move], names: [place], unit: [m]}
- {names: ["spe*"], unit: [s], type: float}
- {names: [size], unit_of: "size -> at"}
- {default: [none]}
"""


@pytest.mark.parametrize(
    ("fact", "other", "message"),
    [
        ("range: [1, 8]", "range: [2, 8]", "radio.tune: channel: range 2 to 8, a rule has 1 to none"),
        ('range: "> 0"', 'range: "> 1"', "radio.tune: gain: range 1 to none, a rule has 0 to none"),
        ("vector3f, unit: m", "vector3f, unit: s", "radio.move: place: unit s, a rule has m"),
        ("speed, type: float", "speed, type: u32", "radio.move: speed: type u32, a rule has float"),
        ("size, type: u8, unit: s", "size, type: u8, unit: m", "step: size: unit m, that of at is s"),
        ("default: none", "default: low", "radio.tune: tone: default low, a rule has none"),
    ],
)
def test_a_rule(tmp_path: Path, fact: str, other: str, message: str) -> None:
    (tmp_path / "rules.yaml").write_text(RULES, "utf-8")
    spec = SPEC.replace("default: low", "default: none").replace("size, type: u8", "size, type: u8, unit: s")
    spec = spec.replace("{name: speed, type: float, unit: s", "{name: speed, type: float, range: [0, ~], unit: s")
    assert [d.text for d in witnesses.audit_all(load(spec), tmp_path).differences] == []
    assert spec.count(fact) == 1
    found = witnesses.audit_all(load(spec.replace(fact, other)), tmp_path).differences
    assert message in {f"{d.at}: {d.text}" for d in found}


def test_a_rule_of_a_frame(tmp_path: Path) -> None:
    (tmp_path / "rules.yaml").write_text("rules: [{names: [pl*], frame: [ned]}]\n", "utf-8")
    (found,) = witnesses.audit_all(load(SPEC), tmp_path).differences
    assert f"{found.at}: {found.text}" == "radio.move: place: frame sensor, a rule has ned"


def test_ids_of_ports_and_leap_seconds() -> None:
    """The id of a port is the value of the same name in the enumeration of ports."""
    real = model("real")
    own = next(d for d in real.devices if any(port.name == "UART 2" for port in d.ports))
    ports = tuple(replace(port, id=0x13) if port.name == "UART 2" else port for port in own.ports)
    seconds = (*real.protocol.leap_seconds[:-1], (real.protocol.leap_seconds[-1][0], 17))
    wrong = replace(
        real, devices=(replace(own, ports=ports),), protocol=replace(real.protocol, leap_seconds=seconds)
    )  # fmt: skip
    stated = {"units": {}}
    kinds = ("ids of ports", "leap seconds")
    found = [finding.text for kind, finding in rules.compare_constants(wrong, stated) if kind in kinds and finding]
    assert found == [
        "leap seconds: 17 on 2017-01-01 after 17; each adds one, in January or July",
        "the id of port UART 2 is 19; the enumeration has 18",
    ]
    assert not [1 for kind, finding in rules.compare_constants(real, stated) if kind in kinds and finding]


INVENTED = model("invented")

OF_DEVICES = """\
models:
  model-c:
    number: 4713
    generation: 3
    sensors: [accelerometer]
    receivers: 0
    antennas: 2
    ack_codes: [0, 1, 3]
    base_rates: {"0x80": 1000, "0x81": 250}
    baud_rates: {Main: [9600]}
    limits: {segments: [6, "1"]}
    functions: {tools.settings: WRS}
    "yes": {"0x01": [1, 2], "0x81": [1]}
    likely: {"0x01": [12]}
  old-1: {number: 4001, assumed: {"0x80": [2]}}
  old-3: {number: 4003}
readings:
  tools.settings.mode: [{only: [default, fast], devices: [model-c]}]
  tools.status.selector: [{const: 2, devices: [model-c]}]
  tools.status_short.flags: [{type: model_a_faults, devices: [model-c]}]
"""


def differences(text: str) -> list[str]:
    found = [finding for _, finding in compared_devices(INVENTED, yaml.safe_load(text))]
    return [f"{x.at}: {x.text}" for x in found if x]


def test_what_agrees() -> None:
    assert differences(OF_DEVICES) == []


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("number: 4713", "number: 4714", "model-c: number: 4713, witness 4714"),
        ("number: 4003", "number: 4004", "old-3: number: 4003, witness 4004"),
        ("generation: 3", "generation: 4", "model-c: generation: 3, witness 4"),
        ("[accelerometer]", "[gyroscope]", "model-c: sensors: accelerometer, witness gyroscope"),
        ("antennas: 2", "antennas: 1", "model-c: antennas: 2, witness 1"),
        ("[0, 1, 3]", "[0, 1]", "model-c: ack_codes: 0, 1, 3, witness 0, 1"),
        ('"0x81": 250', '"0x81": 500', "model-c: base_rates 0x81: 250, witness 500"),
        ("[9600]", "[9600, 19200]", "model-c: baud_rates Main: 9600, witness 9600, 19200"),
        ('[6, "1"]', "[6, Hz]", "model-c: limits segments: 6, 1, witness 6, Hz"),
        ("WRS", "WR", "model-c: functions tools.settings: WRS, witness WR"),
        ("[1, 2]", "[1, 2, 8]", "model-c: not yes: 0x01,0x08"),
        ("likely: ", "assumed: ", "model-c: not assumed: 0x01,0x0C"),
        ("[default, fast]", "[fast]", "model-c: tools.settings.mode: only default, fast, witness only fast"),
        ("const: 2", "const: 3", "model-c: tools.status.selector: const 2, witness const 3"),
        ("model_a_faults", "faults", "model-c: tools.status_short.flags: type model_a_faults, witness type faults"),
        ("old-3:", "old-5:", "old-5: number: nothing, witness 4003"),
    ],
)
def test_what_differs(old: str, new: str, message: str) -> None:
    assert differences(OF_DEVICES.replace(old, new)) == [message]


def test_debt() -> None:
    """What the witness does not state is counted: one fact less there is one more without a witness."""
    before = debt(INVENTED, yaml.safe_load(OF_DEVICES))
    for line in ('limits: {segments: [6, "1"]}', "functions: {tools.settings: WRS}", "antennas: 2"):
        after = debt(INVENTED, yaml.safe_load(OF_DEVICES.replace(line, "")))
        assert after - before == {line.partition(":")[0]: 1}
    less = re.sub("  tools.status.selector.*\n", "", OF_DEVICES)
    assert debt(INVENTED, yaml.safe_load(less))["readings"] == before["readings"] + 1
    undocumented = OF_DEVICES.replace("[1, 2]", "[1]")
    assert debt(INVENTED, yaml.safe_load(undocumented)) - before == {"yes": 1}
