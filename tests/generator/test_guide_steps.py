"""Packets and replies of steps of a kind that the specification's own guides do not have."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from mipgen.model.guides import Step
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import SPECS

GUIDE = """\
guide: walk
title: walk
question: How?
answer: So.
sources: [{{manual: guide, section: Ping}}]
sequences:
  - title: One
    devices: [model-a]
    steps:
      - {{reason: So., {step}}}
"""


def resolved(step: str, folder: Path) -> Step:
    spec = folder / "spec"
    shutil.copytree(SPECS["invented"][0], spec)
    (spec / "guides/walk.yaml").write_text(GUIDE.format(step=step), "utf-8")
    return next(g for g in load_model(spec).guides if g.name == "walk").sequences[0].steps[0]


FORMATS = "command: tools.formats, values: {{suppress_ack: {}, checkpoint: 1, segments: []}}"


@pytest.mark.parametrize(("quiet", "answer"), [("true", ""), ("false", "75 65 01 04 04 F1 07 00 DB 76")])
def test_a_silenced_step_has_no_answer(quiet: str, answer: str, tmp_path: Path) -> None:
    step = resolved(FORMATS.format(quiet), tmp_path)
    assert step.packet[4:7] == bytes([5, 7, quiet == "true"])
    assert (step.answer, step.response) == (bytes.fromhex(answer), None)


def test_a_silenced_step_states_no_answer(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match=r"not answered with 'tools.settings_response' here: no answer; leave it out"):
        resolved(f"{FORMATS.format('true')}, answer: {{tools.settings_response: {{port: 1}}}}", tmp_path)


def test_a_function_that_is_not_acknowledged_has_no_answer(tmp_path: Path) -> None:
    values = "{function: apply, port: 1, mode: slow, baud: 9600}"
    step = resolved(f"command: tools.settings, values: {values}", tmp_path)
    assert (step.answer, step.response) == (b"", None)


def rated(rate: str) -> str:
    return f"command: tools.ping, data: [{{set: measurements, rate: {rate}, fields: [measurements.accel]}}]"


@pytest.mark.parametrize("rate", ["1000", "0.1", "2.5", "0.8"])
def test_a_rate_may_be_a_decimal(rate: str, tmp_path: Path) -> None:
    assert resolved(rated(rate), tmp_path).data[0].rate == float(rate)


@pytest.mark.parametrize("rate", ["0.3", "2000", "999.9"])
def test_a_rate_divides_the_base_rate(rate: str, tmp_path: Path) -> None:
    with pytest.raises(SpecError, match=rf"{rate} Hz is not the base rate of 'measurements' on the Model A, 1000 Hz"):
        resolved(rated(rate), tmp_path)
