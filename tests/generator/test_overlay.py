"""Overlays add to a specification; their mistakes are reported with their places."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from bad_spec_files import BASE
from mipgen import cli
from mipgen import model as m
from mipgen.facts import describe
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import ROOT, SPECS, model, some

OVERLAY = ROOT / "tests/overlay"


WIND = """\
extend: aiding
parts:
  tail: [{name: valid_flags, type: axis_flags, description: Which axes are valid.}]
fields:
  - command: 0x7A
    name: wind
    title: Wind
    description: A measured wind, as `aiding.body_frame_velocity` has it.
    parameters: [{include: head}, {name: wind, type: vector3f, unit: m/s, description: Wind.}, {include: tail}]
"""
HORN = "extend: payload\nfields:\n  - {command: 0x02, name: horn, title: Horn, description: Sounds the horn.}\n"


@pytest.fixture(scope="module")
def after(tmp_path_factory: pytest.TempPathFactory) -> m.Model:
    """The real specification with an overlay, and with one that extends both."""
    second = tmp_path_factory.mktemp("overlay")
    (second / "sets").mkdir()
    for name, text in (("horn", HORN), ("wind", WIND)):
        (second / f"sets/{name}.yaml").write_text(text, "utf-8")
    return load_model(SPECS["real"][0], OVERLAY, second)


def test_an_overlay_adds_sets_fields_types_units_and_support(after: m.Model) -> None:
    new = {f.full_name for f in after.fields} - {f.full_name for f in model("real").fields}
    assert new - {"aiding.wind", "payload.horn"} == {"payload.lamp", "payload.lamp_response", "sensor.ambient_light"}
    light, lamp = after.field("sensor.ambient_light"), after.field("payload.lamp")
    assert light is not None and lamp is not None and light.sources == lamp.sources == ()
    assert light.parameters[0].units == ("lx",) and light.parameters[2].element in after.types
    assert [d.id for d in after.devices_of(light)] == [d.id for d in after.devices_of(lamp)] == ["3dm-cv7-gnss-ins"]
    said = [describe.say(x.sentence, lambda ref: ref.words) for x in describe.field(lamp, after)]
    assert "Supported by 3DM-CV7-GNSS/INS." in said
    assert "Affects sensor.ambient_light and system_data (0xA0)." in said
    assert after.changed_by(light) == (lamp,)
    state = lamp.parameters[1]
    assert lamp.title == "Lamp" and isinstance(state.element, m.Enum) and state.description == state.element.description
    bend = light.parameters[1]
    assert (bend.frame, bend.at_rest, bend.positive) == ("mast", (0, 0, None), "away from the mast")
    assert [c.values for w in after.protocol.frames for c in w.conversions if w.symbol == "mast"] == [("-x", "-y", "z")]


def test_sources_are_optional(tmp_path: Path) -> None:
    """Whether in an overlay, or in a specification of one's own: nothing requires a manual."""
    named = "{}\nnamed:\n  - {{command: 0x70, name: lamp, title: Lamp}}\n"
    (tmp_path / "mine/sets").mkdir(parents=True)
    (tmp_path / "mine/sets/a.yaml").write_text(named.format("extend: tools"), "utf-8")
    assert [x.name for x in load_model(BASE, tmp_path / "mine").families[0].named] == ["lamp"]
    spec = tmp_path / "spec"
    shutil.copytree(BASE, spec)
    for part in ("manuals", "errata", "examples", "evidence"):
        shutil.rmtree(spec / part)
    for path in spec.rglob("*.yaml"):
        kept = (line for line in path.read_text("utf-8").splitlines() if not line.startswith(("sources:", "manual:")))
        lines = (line for line in kept if not line.lstrip().startswith("sources:"))
        path.write_text("\n".join(lines) + "\n", "utf-8")
    tools = spec / "sets/tools.yaml"
    tools.write_text(named.format(tools.read_text("utf-8")), "utf-8")
    (spec / "sets/pair.yaml").write_text(PAIR, "utf-8")
    of = load_model(spec)
    assert of.protocol.manuals == () and not any(f.sources for f in of.fields)
    assert of.families[0].named[0].sources == of.guides[0].sources == of.protocol.acknowledge.sources == ()
    heat = some(of.field("right.heat"))
    assert heat.sets == (0x90, 0x91)
    out = tmp_path / "out"
    assert cli.main(["generate", "--spec", str(spec), "--out", str(out), "--target", "c", "--target", "markdown"]) == 0
    pages = "\n".join(path.read_text("utf-8") for path in (out / "markdown").rglob("*.md"))
    assert "Source: " not in pages and "Sources: " not in pages


PAIR = """\
name: pair
title: Pair
description: Data of two of a kind.
sets:
  left: {set: 0x90, title: Left, description: Left one.}
  right: {set: 0x91, title: Right, description: Right one.}
fields:
  - {data: 0x01, name: heat, title: Heat, description: How warm it is.}
"""


def test_every_fact_of_the_specification_has_a_source() -> None:
    of = model("real")
    named = [x for family in of.families for x in family.named]
    cited = {f.full_name: f.sources for f in (*of.fields, of.protocol.acknowledge)}
    cited |= {x.title: x.sources for x in (*named, *of.guides, *of.protocol.notes)}
    assert [name for name, sources in cited.items() if not sources] == []
    assert len(cited) > 380


def test_the_names_of_an_overlay_are_free(tmp_path: Path) -> None:
    """The vocabulary applies only to the specification below."""
    named = "extend: tools\nfields:\n  - {command: 0x70, name: gyroscope, title: Gyroscope, description: Turns.}\n"
    (tmp_path / "mine/sets").mkdir(parents=True)
    (tmp_path / "mine/sets/a.yaml").write_text(named, "utf-8")
    assert load_model(BASE, tmp_path / "mine").field("tools.gyroscope") is not None


def test_an_overlay_adds_parts_and_includes_those_that_are_there(after: m.Model) -> None:
    wind = some(after.field("aiding.wind"))
    assert [p.name for p in wind.parameters] == ["time", "frame_id", "wind", "valid_flags"]


def test_an_overlay_may_extend_another(after: m.Model) -> None:
    (payload,) = (x for x in after.families if x.name == "payload")
    assert [f.name for f in payload.fields] == ["lamp", "horn", "lamp_response"]


A = "sets/a.yaml"
DEVICE = "devices/a.yaml"
PONG = "extend: tools\nfields:\n  - {command: 0x01, name: pong, title: Pong, description: Pongs.}\n"
MODE = "extend: tools\ntypes:\n  mode: {enum: u8, description: A., values: {a: {value: 1, description: A.}}}\n"


@pytest.mark.parametrize(
    ("file", "text", "message"),
    [
        (A, "extend: tols\nfields: []\n", ":1:9: error: no set 'tols' to extend, did you mean 'tools'?"),
        (A, "extend: tools\ntitle: T\n", ":2:1: error: unknown key 'title'"),
        (A, PONG, ":3:5: error: 'pong' has the descriptor 0x01 of 'ping'; give it another"),
        (A, MODE, ":3:3: error: the type 'mode' is already defined"),
        (DEVICE, "extend: model-x\n", ":1:9: error: no device 'model-x' to extend, did you mean 'model-a'?"),
        (
            DEVICE,
            "extend: model-a\nbase_rates: {measurements: 5}\n",
            ":2:14: error: 'measurements' is already given at ",
        ),
        ("overlay.yaml", "units:\n  m: {title: mile}\n", ":2:3: error: 'm' is already given at "),
        ("protocol.yaml", "name: MIP\n", ":1:1: error: an overlay has overlay.yaml in its place; name"),
        (
            "sets/a.txt",
            "",
            ":1:1: error: this overlay contains none of these files: overlay.yaml, manuals/*.yaml, types/*.yaml",
        ),
    ],
)
def test_messages(tmp_path: Path, file: str, text: str, message: str) -> None:
    path = tmp_path / "over" / file
    path.parent.mkdir(parents=True)
    path.write_text(text)
    with pytest.raises(SpecError) as caught:
        load_model(BASE, tmp_path / "over")
    place = "" if file.endswith(".txt") else file
    assert f"{place}{message}" in str(caught.value)
