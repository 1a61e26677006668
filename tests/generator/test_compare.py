"""Comparing two specifications shows what a program for the old one would meet with the new one."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from mipgen.compare.changes import CLASSES, Report, compare_models
from mipgen.resolve.load import load_model
from support import ROOT, SPECS, model

BASE = ROOT / "tests/bad_specs/base"


def changed(folder: Path, file: str, old: str, new: str) -> Report:
    spec = folder / "spec"
    shutil.copytree(BASE, spec)
    text = (spec / file).read_text()
    assert text.count(old) >= 1, text
    (spec / file).write_text(text.replace(old, new))
    return compare_models(load_model(BASE), load_model(spec))


TOOLS, DATA, TYPES = "sets/tools.yaml", "sets/measurements.yaml", "types/types.yaml"
MODEL_A = "devices/model_a.yaml"
READING = "varies: {tools.settings.port: {type: mode}}\nbase_rates"
PORT = "{name: port, type: u8, for: WRS"


@pytest.mark.parametrize(
    ("file", "old", "new", "verdict", "said"),
    [
        (TOOLS, "title: Ping", "title: Ping it", "compatible", "tools.ping: another description"),
        (TOOLS, "name: identify", "name: who", "source", "tools.who: was called tools.identify"),
        (TOOLS, "{name: model, type", "{name: kind, type", "source", "tools.identify.kind: was called model"),
        (TOOLS, PORT, PORT.replace("u8", "s8"), "wire", "from port on"),
        (TOOLS, PORT, PORT.replace("WRS", "WR"), "wire", "tools.settings: functions require other parameters"),
        (TOOLS, "{name: mode, type: mode", "{name: mode, type: u8", "source", "type u8, was mode"),
        (DATA, "unit: m,", "unit: s,", "wire", "measurements.accel.accel: unit s, was m"),
        (DATA, "frame: sensor, ", "", "wire", "frame none, was sensor"),
        (DATA, "unit: m,", "unit: m, range: [0, ~],", "compatible", "range 0, open, was open, open"),
        (DATA, "unit: m,", "unit: m, at_rest: [0, 0, -1],", "compatible", "at rest 0, 0, -1, was none"),
        (DATA, ", valid: flags.ready", "", "wire", "valid none, was flags.ready"),
        (DATA, "unit: m,", "unit: m, default: [0, 0, 1],", "compatible", "default 0, 0, 1, was none"),
        (DATA, "unit: m,", 'unit: m, range: "magnitude >= 0, <= 9",', "compatible", "magnitude 0, 9, was open, open"),
        (MODEL_A, "base_rates", READING, "wire", "tools.settings.port on model-a: type mode,"),
        (
            MODEL_A,
            "base_rates",
            READING.replace("type: mode", "default: 3"),
            "compatible",
            "tools.settings.port on model-a: default 3, was none",
        ),
        (
            TOOLS,
            "name: identify",
            "name: identify\n    affects: [measurements.accel]",
            "compatible",
            "tools.identify: affects measurements.accel, was none",
        ),
        (
            TYPES,
            "{bit: 4-6",
            "{bit: 4-6, concerns: [tools.ping]",
            "compatible",
            "flags.level: concerns tools.ping, was none",
        ),
        (TYPES, "slow: 1", "slow: 1, lazy: 5", "compatible", "added         mode.lazy: added: 5"),
        (TYPES, "slow: 1", "slow: 3", "wire", "mode.slow: is 3, was 1"),
        (TYPES, "slow: 1", "lazy: 1", "source", "mode.lazy: was called slow"),
        (TYPES, "slow: 1", "slow: 1, turbo: 7", "compatible", "mode.turbo: added: 7"),
        (TYPES, "level: {bit: 4-6", "level: {bit: 4-7", "wire", "flags.level: is bits 4-7, was bits 4-6"),
        (
            TOOLS,
            "name: identify",
            "name: identify\n    short: who",
            "source",
            "tools.identify: short name who, was none",
        ),
        (TYPES, "slow: 1", "slow: {value: 1, short: lag, description: S.}", "source", "mode.slow: short name lag, was"),
        (TYPES, "{bit: 4-6", "{bit: 4-6, short: lv", "source", "flags.level: short name lv, was none"),
        (TYPES, "health: {", "health: {short: hp, ", "source", "health: short name hp, was none"),
        (MODEL_A, "title: Model A", "title: Model 1", "compatible", "model-a: profile differs: identity"),
        (MODEL_A, "title: Model A", "title: Model A\nalso: [A]", "compatible", "model-a: profile differs: identity"),
        (
            TOOLS,
            "{response: 0x82, ",
            "{response: 0x82, devices: [spare], ",
            "compatible",
            "tools.settings_response: layout used by different devices",
        ),
        ("simulation/world.yaml", "Of the device", "Of it", "same", "height: another quantity"),
        ("simulation/world.yaml", "{unit: m,", "{unit: m, typical: 3,", "same", "height: another quantity"),
        ("packets/measurements.yaml", "[1, 0", "[2, 0", "same", "accel.accel: typical value 0x40000000"),
        ("errata/errata.yaml", "reason: ", "reason: Indeed. ", "same", ": another erratum"),
        ("examples/examples.yaml", "title: ", "title: The ", "same", ": another example"),
        ("guides/guide.yaml", "question: ", "question: Or ", "same", ": another guide"),
        ("guides/guide.yaml", "guide: ", "guide: new_", "same", ": guide added"),
        ("guides/guide.yaml", "guide: ", "guide: new_", "same", ": guide removed"),
        ("protocol.yaml", "name: MIP", "name: MIP\npackage: probe", "source", "the package: renamed from mip to probe"),
        ("protocol.yaml", "save: {value", "store: {value", "source", "function_selector.store: was called save"),
    ],
)
def test_verdict(tmp_path: Path, file: str, old: str, new: str, verdict: str, said: str) -> None:
    report = changed(tmp_path, file, old, new)
    assert report.verdict == verdict, report.changes
    assert any(said in str(c) for c in report.changes), [str(c) for c in report.changes]


def test_a_field_less_and_a_field_more() -> None:
    real, more = model("real"), load_model(SPECS["real"][0], ROOT / "tests/overlay")
    assert not [c for c in compare_models(real, more).changes if c.verdict == "same"]
    assert compare_models(real, more).verdict == "compatible" and compare_models(more, real).verdict == "source"
    assert compare_models(real, real).verdict == "same" and compare_models(real, real).changes == ()
    assert "payload.lamp" in {c["subject"] for c in compare_models(more, real).plain()["changes"]}


def test_a_device_of_which_only_the_name_is_known(tmp_path: Path) -> None:
    texts = {
        "known": (BASE / "devices/spare.yaml").read_text().replace("spare", "other").replace("Spare", "Other"),
        "named": "named: [{device: other, title: Other, like: model-a}]",
        "called": "named: [{device: other, title: Other, also: [O], like: model-a}]",
    }
    for name, text in texts.items():
        shutil.copytree(BASE, tmp_path / name)
        (tmp_path / name / "devices/other.yaml").write_text(text)
    known, named, called = (load_model(tmp_path / name) for name in texts)
    changes = [compare_models(*pair).changes for pair in ((known, named), (named, known), (named, called))]
    assert [str(c) for each in changes for c in each] == [
        "source     profile       other: profile removed: only the name is known",
        "compatible profile       other: profile added: only the name was known",
        "compatible profile       other: other names, or another device is most like it",
    ]


def test_a_set_that_a_device_may_now_have() -> None:
    """The support of a whole set is no list of fields."""
    real = model("real")
    lacking = next(d for d in real.devices if any(e.sets for e in d.evidence))
    able = replace(lacking, evidence=tuple(replace(e, sets=()) for e in lacking.evidence))
    new = replace(real, devices=tuple(able if d is lacking else d for d in real.devices))
    assert [c.what for c in compare_models(real, new).changes] == ["profile differs: absent sets"]


def test_the_worst_comes_first() -> None:
    report = compare_models(model("real"), model("invented"))
    order = ["wire", "source", "compatible", "same"]
    found = [c.verdict for c in report.changes]
    assert found == sorted(found, key=order.index) and report.verdict == "wire"


STATUS = """\
    responses:
      - response: 0x90
        name: brief
        parameters: [{name: a, type: u8, description: A.}]
"""
LONGER = """\
      - response: 0x90
        name: longer
        parameters: [{name: b, type: u16, description: B.}]
"""


def test_layouts_that_only_their_size_tells_apart(tmp_path: Path) -> None:
    """A further layout is an addition; the one that was alone before does not change."""
    for name, more in (("one", STATUS), ("two", STATUS + LONGER)):
        shutil.copytree(BASE, tmp_path / name)
        with (tmp_path / name / TOOLS).open("a") as file:
            file.write(more)
    one, two = load_model(tmp_path / "one"), load_model(tmp_path / "two")
    added = "compatible added         tools.longer: added (0x01,0x90)"
    assert added in [str(c) for c in compare_models(one, two).changes]
    assert not [c for c in compare_models(one, two).changes if c.verdict != "compatible"]
    assert [str(c) for c in compare_models(two, one).changes if "removed" in c.what] == [
        "source     removed       tools.longer: removed (0x01,0x90)"
    ]


def test_each_change_has_a_class_and_a_place(tmp_path: Path) -> None:
    """The changes in the table of classes, of two specifications that have little in common."""
    report = compare_models(model("real"), model("invented"))
    assert {c.kind for c in report.changes} <= set(CLASSES)
    changes = changed(tmp_path, DATA, "unit: m, frame: sensor, valid: flags.ready", "unit: s, default: [0, 0, 1]")
    assert [(c.verdict, c.kind) for c in changes.changes] == [
        ("wire", "frame"), ("wire", "unit"), ("wire", "valid"), ("compatible", "default"),
    ]  # fmt: skip
    assert {(c.position.file[-22:], c.position.line) for c in changes.changes if c.position} == {(f"/{DATA}"[-22:], 13)}


def test_what_a_new_device_reads_is_part_of_it(tmp_path: Path) -> None:
    shutil.copytree(BASE, tmp_path / "spec")
    text = (BASE / "devices/spare.yaml").read_text().replace("spare", "other").replace("Spare", "Other")
    (tmp_path / "spec/devices/other.yaml").write_text(text.replace("base_rates", READING))
    found = [str(c) for c in compare_models(load_model(BASE), load_model(tmp_path / "spec")).changes]
    assert found == ["compatible added         other: added"]
