"""The workbench of a specification, built as `make workbench` does, from its committed package."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

from support import ROOT, SPECS

BUILD = ROOT / "tools/workbench/build.py"

#: Where it is built; it goes when the tests end.
FOLDER = tempfile.TemporaryDirectory(prefix="mip-workbench-")


@cache
def workbench(spec: str) -> Path:
    folder = Path(FOLDER.name) / spec
    command = [sys.executable, BUILD, SPECS[spec][1] / "javascript", folder]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder
