"""The comparison with facts about devices; the facts are made up here."""

from __future__ import annotations

import re

import pytest
import yaml
from audit.devices import compared_devices, debt
from support import model

INVENTED = model("invented")

FACTS = """\
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


def differences(text: str, manuals: dict[str, set[str]]) -> list[str]:
    found = [finding for _, finding in compared_devices(INVENTED, yaml.safe_load(text), manuals)]
    return [f"{x.at}: {x.text}" for x in found if x]


def test_what_agrees() -> None:
    assert differences(FACTS, {"model-c": {"0x01,0x01", "0x80,0x02"}}) == []


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
    assert differences(FACTS.replace(old, new), {}) == [message]


def test_contents_of_a_manual() -> None:
    text = "0x80,0x09 is in its manual, but not documented here"
    assert differences(FACTS, {"model-c": {"0x01,0x01", "0x80,0x09"}}) == [f"model-c: {text}"]


def test_debt() -> None:
    """What the witness does not state is counted: one fact less there is one more without a witness."""
    before = debt(INVENTED, yaml.safe_load(FACTS), {})
    for line in ('limits: {segments: [6, "1"]}', "functions: {tools.settings: WRS}", "antennas: 2"):
        after = debt(INVENTED, yaml.safe_load(FACTS.replace(line, "")), {})
        assert after - before == {line.partition(":")[0]: 1}
    less = re.sub("  tools.status.selector.*\n", "", FACTS)
    assert debt(INVENTED, yaml.safe_load(less), {})["readings"] == before["readings"] + 1
    undocumented = FACTS.replace("[1, 2]", "[1]")
    assert debt(INVENTED, yaml.safe_load(undocumented), {}) - before == {"yes": 1}
    assert not debt(INVENTED, yaml.safe_load(undocumented), {"model-c": {"0x01,0x02"}}) - before
