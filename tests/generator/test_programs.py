"""Programs that show how fields are used: what they import, and texts in them."""

from __future__ import annotations

import ast
import re
from dataclasses import replace

import pytest
from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.targets.c import api as c
from mipgen.targets.python import api as python
from mipgen.targets.rust import api as rust
from small_specs import load
from support import model, some

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
