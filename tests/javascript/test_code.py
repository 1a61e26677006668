"""The programs of the builder are those on the pages of the reference, which are compiled and run there."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from mipgen.targets.c import snippets as c
from mipgen.targets.python import snippets as python
from mipgen.targets.rust.snippets import Snippets
from mipgen.typical import Typical
from support import SPECS, heavy, model, need

#: It needs Node.
pytestmark = [] if shutil.which("node") else heavy("node")

HERE = Path(__file__).parent


def programs(spec: str, calls: dict[str, Any], folder: Path) -> dict[str, dict[str, str]]:
    """What the builder writes for these calls: function selectors, for typical values, or whole values."""
    path = folder / "calls.json"
    path.write_text(json.dumps(calls))
    command = [need("node"), HERE / "programs.mjs", SPECS[spec][1] / "javascript", path]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found: dict[str, dict[str, str]] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_typical_values_of_every_command_and_field(spec: str, tmp_path: Path) -> None:
    of = model(spec)
    typical, rust = Typical(of), Snippets(Typical(of))
    asked = [f for f in of.fields if f.role != m.RESPONSE]
    calls = {
        f.full_name: [x.function and x.function.value for x in typical.shown(f)] if f.role == m.COMMAND else None
        for f in asked
    }
    found = programs(spec, calls, tmp_path)
    for f in asked:
        if f.role == m.COMMAND:
            wanted = (c.command(f, typical), python.command(f, typical), rust.command(f))
        else:
            wanted = (c.data(f), python.data(f), rust.data(f))
        assert found[f.full_name] == dict(zip(("c", "python", "rust"), wanted, strict=True)), f.full_name
