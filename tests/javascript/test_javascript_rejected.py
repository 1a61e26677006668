"""JavaScript names the field for which a device rejects a command, by the cases that all languages share."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

from support import ROOT, SPECS, need, uses

pytestmark = uses("node")


def test_the_field_to_blame() -> None:
    text = (ROOT / "tests/rejected.json").read_text("utf-8")
    command = [need("node"), Path(__file__).with_name("rejected.mjs"), SPECS["real"][1] / "javascript"]
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    cases = json.loads(text)
    assert {c["title"]: x for c, x in zip(cases, json.loads(done.stdout), strict=True)} == {
        c["title"]: c["cause"] for c in cases
    }
