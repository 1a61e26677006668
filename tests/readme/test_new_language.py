"""docs/new-language.md runs as written, from its first block to its last."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

from mipgen.emit.target import Target
from support import ROOT, uses

PAGE = (ROOT / "docs/new-language.md").read_text("utf-8")

pytestmark = uses("node")


def test_every_block_from_the_first_to_the_last(tmp_path: Path) -> None:
    """A block below the name of a file is that file; the others are commands with their output."""
    program = tmp_path / "bin/mipgen"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m mipgen "$@"\n')
    program.chmod(0o755)
    path = os.pathsep.join((str(program.parent), os.environ["PATH"]))
    environment = {**os.environ, "PATH": path, "PYTHONPATH": str(ROOT / "generator"), "LC_ALL": "C"}
    here = tmp_path / "here"
    here.mkdir()
    blocks = re.findall(r"(?:^`(\S+)`:\n\n)?^```(\w*)\n(.*?)^```$", PAGE, re.M | re.S)
    assert len(blocks) == PAGE.count("```") / 2 >= 10
    for file, kind, text in blocks:
        if file:
            (here / file).parent.mkdir(parents=True, exist_ok=True)
            (here / file).write_text(text)
            continue
        assert kind == "console", text
        for command, output in re.findall(r"^\$ (.*\n)((?:[^$].*\n)*)", text, re.M):
            done = subprocess.run(
                ["sh", "-c", f"exec 2>&1; {command}"], cwd=here, env=environment, text=True, stdout=subprocess.PIPE
            )
            assert (command, done.stdout) == (command, output) and done.returncode == 0


def test_every_attribute_is_described() -> None:
    table = PAGE.partition("\n| Attribute |")[2].partition("\n\n")[0]
    named = [name for row in table.splitlines()[2:] for name in re.findall(r"`(\w+)`", row.split("|")[1])]
    assert named == [f.name for f in fields(Target)]
