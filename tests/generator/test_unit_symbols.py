"""The symbol of a unit: another spelling of what is shown is one line of the specification."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from mipgen.emit import render
from mipgen.model import Model
from mipgen.resolve.load import load_model
from support import SPECS, generated

#: A line of the specification, and the one in its place.
DEGREES = "  deg: {title: degree, ", "  deg: {title: degree, symbol: arc-degree, "
SECONDS = "  s: {title: second}", "  s: {title: second, symbol: sec}"
#: The targets that show units, and the only lines in which they keep the key.
KEEP = {
    "c": r"$^",
    "json": r'"symbol":"arc-degree",.*"key":"deg"',
    "markdown": r"$^",
    "python": r"""["']arc-degree["']: ["']deg["']""",
    "rust": r"$^",
    "wireshark": r"$^",
}


def respelled(folder: Path, *lines: tuple[str, str]) -> Model:
    """Loads the small specification with other lines."""
    spec = folder / "spec"
    shutil.copytree(SPECS["invented"][0], spec)
    text = (spec / "protocol.yaml").read_text("utf-8")
    for old, new in lines:
        assert old in text
        text = text.replace(old, new)
    (spec / "protocol.yaml").write_text(text, "utf-8")
    return load_model(spec)


@pytest.fixture(scope="module")
def degrees(tmp_path_factory: pytest.TempPathFactory) -> Model:
    return respelled(tmp_path_factory.mktemp("degrees"), DEGREES)


@cache
def shows(symbol: str, text: str) -> tuple[str, ...]:
    """The lines of a text in which a unit is a word by itself."""
    word = re.compile(rf"(?<![\w.`/]){symbol}(?![\w/(.])")
    return tuple(line for line in text.splitlines() if word.search(line))


@pytest.mark.parametrize("target", sorted(KEEP))
def test_another_spelling_is_one_line(target: str, degrees: Model) -> None:
    before, after = generated(target, "invented"), render.render(target, degrees)
    changed = {path for path in after if after[path] != before[path]}
    was = [line for path in changed for line in shows("deg", before[path].decode())]
    now = [line for path in changed for line in shows("arc-degree", after[path].decode())]
    kept = [line for path in after for line in shows("deg", after[path].decode()) if not re.search(KEEP[target], line)]
    assert was and len(now) >= len(was)
    assert [line for line in kept if line in was] == []


def test_times_are_found_by_key(tmp_path: Path) -> None:
    for path, data in render.render("python", respelled(tmp_path, SECONDS)).items():
        file = tmp_path / "python" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(data)
    program = """
from mip_protocol import reflection, shared, timestamps
p = reflection.info(shared.Timestamp)["tow"]
print(p.unit, timestamps.scale(p))
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path / "python", capture_output=True, text=True)
    assert done.stdout.split() == ["sec", "1000000000"], done.stderr


def test_programs_find_the_key_in_the_document(tmp_path: Path) -> None:
    document = json.loads(render.render("json", respelled(tmp_path, SECONDS))["mip.json"])
    assert {u["symbol"]: u.get("key") for u in document["units"] if "key" in u} == {"sec": "s"}
    (timestamp,) = (f for f in document["fields"] if f["name"] == "shared.timestamp")
    assert ["sec"] in [p.get("units") for p in timestamp["parameters"]]
