"""MISRA.md names exactly the rules that are not kept."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

from support import ROOT, heavy

C = ROOT / "generated/c"


@heavy("cppcheck")
def test_misra_names_what_is_reported(tmp_path: Path) -> None:
    copy = tmp_path / "c"  # cppcheck leaves files beside the sources if it is stopped
    shutil.copytree(C, copy)
    page = (C / "MISRA.md").read_text("utf-8")
    command = re.search(r"^ {4}(cppcheck .*) \S+$", page, re.M)
    assert command
    finished = [path.relative_to(ROOT / "runtime/c") for path in (ROOT / "runtime/c").rglob("*.c")]
    small = command[1].replace("PARSER_FAST", "PARSER_SMALL")
    reported = set()
    for line in (
        [*command[1].split(), *finished, "src/mip/sets/base.c"],
        [*small.split(), "src/mip/core/parser_small.c"],
    ):
        done = subprocess.run(line, cwd=copy, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        reported |= set(re.findall(r"\[misra-c2012-([\d.]+)\]", done.stderr))
    assert reported == set(re.findall(r"^\| ([\d.]+) ", page, re.M))
