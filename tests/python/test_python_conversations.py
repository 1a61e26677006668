"""The client in any order of calls, as hypothesis chooses them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from support import ROOT, SEED, heavy, rounds

HERE = Path(__file__).parent
FOLDERS = (ROOT / "generated/python", ROOT / "generator", HERE.parent, HERE)


@heavy("hypothesis")
def test_conversations() -> None:
    count = rounds(15, 3000)
    path = os.pathsep.join(map(str, FOLDERS))
    done = subprocess.run(
        [sys.executable, HERE / "conversations.py", str(count), str(SEED)],
        capture_output=True, text=True, env={**os.environ, "PYTHONPATH": path},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    assert done.stdout == f"{count} conversations\n"
