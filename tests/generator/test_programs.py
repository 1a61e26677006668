"""Programs that show how fields are used: what they import, and texts in them."""

from __future__ import annotations

import ast
import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.model.guides import Step
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from mipgen.targets.c import api as c
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust
from small_specs import load
from support import SPECS, model, some

TEXT = "a ~b.c~d, (e]"


def talking() -> tuple[m.Field, SampleValues]:
    """A command with a text full of words and marks that programs themselves contain."""
    of = load(
        """\
        set: 0x05
        name: it
        title: It
        description: It.
        fields:
          - command: 0x01
            name: say
            title: Say
            description: Says it.
            parameters: [{name: words, type: char, count: rest, description: Words.}]
        """
    )
    f = some(of.field("it.say"))
    f = replace(f, parameters=(replace(f.parameters[0], typical=TEXT),))
    return f, SampleValues(of)


@pytest.mark.parametrize("api", [c, python, rust])
def test_a_text_stays_as_it_is(api: object) -> None:
    f, samples = talking()
    text = api.Programs(samples).command(f)  # type: ignore[attr-defined]
    assert f'"{TEXT}"' in text


def test_a_text_needs_no_import() -> None:
    f, samples = talking()
    assert python.Programs(samples).command(f).startswith("from mip_protocol import it\ndevice.")
    assert rust.Programs(samples).command(f).startswith("use mip_protocol::{VarText, it};\ndevice.")


def test_python_imports_what_it_uses() -> None:
    of = model("real")
    samples = SampleValues(of)
    for f in of.fields:
        programs = python.Programs(samples)
        tree = ast.parse(programs.command(f) if f.role == m.COMMAND else programs.data(f))
        (imports,) = (x for x in ast.walk(tree) if isinstance(x, ast.ImportFrom))
        known = {x.asname or x.name for x in imports.names}
        used = {x.id for x in ast.walk(tree) if isinstance(x, ast.Name)}
        assert known <= used and used - known <= {"device", "response", "print", "stamp", "value"}, f.full_name


def test_rust_imports_what_it_uses() -> None:
    of = model("real")
    samples = SampleValues(of)
    for f in of.fields:
        programs = rust.Programs(samples)
        head, _, body = (programs.command(f) if f.role == m.COMMAND else programs.data(f)).partition("\n")
        for name in re.findall(r"\w+", head.partition("::")[2]):
            assert re.search(rf"\b{name}\b", body), f.full_name


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
