"""The pictures of the README can be made, and show the commands that are run."""

from __future__ import annotations

import re
import subprocess
import sys
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

from support import ROOT, heavy

COMMITTED = ROOT / "docs/pictures/session.svg"


def commands(picture: Path) -> list[str]:
    return [unescape(x) for x in re.findall(r'class="command"[^>]*>\$ (.*?)</text>', picture.read_text("utf-8"))]


@heavy("a session in a terminal")
def test_the_session_is_up_to_date(tmp_path: Path) -> None:
    made = tmp_path / "session.svg"
    subprocess.run([sys.executable, ROOT / "docs/pictures/session.py", made], check=True)
    ElementTree.parse(made)
    assert commands(made) == commands(COMMITTED), "`make pictures` makes it anew"
    assert len(commands(made)) > 5 and made.stat().st_size < 300_000


def test_the_committed_session_is_small_and_well_formed() -> None:
    ElementTree.parse(COMMITTED)
    assert COMMITTED.stat().st_size < 300_000 and len(commands(COMMITTED)) > 5
