"""The workbench of a specification, built as `make workbench` does, from its committed package."""

from __future__ import annotations

import os
import subprocess
import tempfile
from functools import cache
from pathlib import Path

from support import ROOT, SPECS, need, node_modules

BUNDLE = ROOT / "tools/workbench/bundle.mjs"

#: Where it is built; it goes when the tests end.
FOLDER = tempfile.TemporaryDirectory(prefix="mip-workbench-")


@cache
def workbench(spec: str) -> Path:
    folder = Path(FOLDER.name) / spec
    done = bundled(SPECS[spec][1] / "javascript", folder)
    assert done.returncode == 0, done.stderr
    return folder


def bundled(package: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    command = [need("node"), BUNDLE, package, folder]
    environment = {**os.environ, "NODE_PATH": str(node_modules())}
    return subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
