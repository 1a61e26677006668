"""What targets declare about their drivers: only a declaration leaves something out of the suite."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from mipgen.emit.target import OPERATIONS
from support import OFFERS, ROOT, SOURCES, WITHIN, build_script

#: A target whose driver finds packets, and nothing else.
TARGET = """
from mipgen.emit.target import File, Target


def files(model):
    yield File("set.txt", "set.txt.j2")


TARGET = Target(title="nothing", files=files, {declared})
"""
BUILD_DRIVER = """#!/bin/sh
test -f "$1/set.txt" && echo "env PYTHONPATH={paths} ${{PYTHON:-python3}} {driver}"
"""
DRIVER = """
import json, sys
from support import expected_parse

for line in sys.stdin:
    r = json.loads(line)
    try:
        right = r["op"] == "parse" and r["chunk"] > 0
        print(json.dumps(expected_parse(bytes.fromhex(r["stream"])) if right else {"error": "request"}))
    except (KeyError, TypeError, ValueError):
        print(json.dumps({"error": "request"}))
"""


def test_a_driver_and_its_declaration_come_together() -> None:
    scripts = {p.parent.name for p in (ROOT / "tests").glob("*/build_driver.sh")}
    assert scripts == {name for name in OFFERS if SOURCES[WITHIN.get(name, name)].module is None}
    for name in OFFERS:
        assert os.access(build_script(name), os.X_OK), f"{build_script(name)} is missing or cannot be run"


@pytest.mark.parametrize("operation", OPERATIONS)
def test_the_bindings_offer_everything(operation: str) -> None:
    assert {name for name, offered in OFFERS.items() if operation in offered} >= {"c", "python", "rust", "javascript"}


def mine(folder: Path, driver: str = DRIVER, declared: str = 'conformance=("parse",)', name: str = "mine") -> Path:
    """A folder of targets, and in it one that has a driver."""
    paths = os.pathsep.join((str(ROOT / "generator"), str(ROOT / "tests")))
    (folder / name).mkdir(parents=True)
    for file, text in (
        ("target.py", TARGET.format(declared=declared)),
        ("set.txt.j2", "{{ model.sets | length }}\n"),
        ("build_driver.sh", BUILD_DRIVER.format(paths=paths, driver=folder / name / "driver.py")),
        ("driver.py", driver),
    ):
        (folder / name / file).write_text(text)
    (folder / name / "build_driver.sh").chmod(0o755)
    return folder


def suite(targets: Path) -> str:
    """The output of the suite for the targets of a folder, without ours; with the invented specification only."""
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-m", "not heavy", "-k", "mine and not real",
         "tests/conformance/test_conformance.py", "tests/conformance/test_client.py"],
        cwd=ROOT, capture_output=True, text=True, env={**os.environ, "MIPGEN_TARGETS": str(targets)},
    )  # fmt: skip
    return done.stdout + done.stderr


def test_the_suite_asks_a_target_of_others_what_it_declares(tmp_path: Path) -> None:
    """It leaves out, by name, those whose tools or programs are not there; a wrong driver fails."""
    mine(tmp_path)
    mine(tmp_path, declared='conformance=("parse",), needs="punched cards"', name="mine_cards")
    mine(tmp_path, declared='conformance=("parse",), program="no-such-program"', name="mine_program")
    mine(tmp_path, DRIVER.replace("expected_parse(bytes.fromhex", "expected_parse(b'u' + bytes.fromhex"), name="mine_x")
    said = suite(tmp_path)
    # Streams, and invalid requests, which the wrong driver refuses as well.
    assert "tests run: conformance 4; " in said, said
    assert re.findall(r"^FAILED .*\[(\w+)", said, re.M) == ["mine_x"], said
    for what in ("punched cards", "no-such-program"):
        assert re.search(f"left out, .*: .*{what}", said), said
