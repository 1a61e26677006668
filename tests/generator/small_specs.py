"""Small specifications, written in tests: one set laid over the good base."""

from __future__ import annotations

import shutil
import tempfile
import textwrap
from pathlib import Path

from bad_spec_files import BASE
from mipgen import model as m
from mipgen.resolve.load import load_model
from spec_defaults import filled
from support import some


def load(text: str) -> m.Model:
    """The base with one more file, sets/it.yaml."""
    with tempfile.TemporaryDirectory() as folder:
        spec = Path(folder) / "spec"
        shutil.copytree(BASE, spec)
        (spec / "sets/it.yaml").write_text(filled(textwrap.dedent(text)), "utf-8")
        return load_model(spec)


def field(parameters: str, functions: str = "", types: str = "{}", role: str = "command") -> m.Field:
    """A field `it` with these parameters, written as a YAML list in one line."""
    number = "0x05" if role == "command" else "0x90"
    responses = "responses: [{response: 0x81, parameters: as_command}]" if "R" in functions else ""
    model = load(
        f"""\
        set: {number}
        name: it
        title: It
        description: It.
        types: {types}
        fields:
          - {role}: 0x01
            name: it
            title: It
            description: It.
            {f"functions: {functions}" if functions else ""}
            {responses}
            parameters: {parameters}
        """
    )
    return some(model.field("it.it"))
