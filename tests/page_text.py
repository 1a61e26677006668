"""What pages for readers show: their sections, commands and programs."""

from __future__ import annotations

import re
import shlex
import sys
from pathlib import Path


def section(page: str, title: str) -> str:
    """A section of a page, which must be there."""
    found = f"\n{page}".partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    assert found, title
    return found


def commands(text: str, program: str = "") -> list[str]:
    """The indented commands, of one program or of any; those in fenced blocks are not among them."""
    return re.findall(rf"^    (?=\S)({program}.*)$", re.sub(r"```.*?```", "", text, flags=re.S), re.M)


def blocks(text: str, language: str) -> list[str]:
    """The fenced blocks of a language."""
    return re.findall(rf"```{language}\n(.*?)```", text, re.S)


def programs(folder: Path, **modules: str) -> Path:
    """A folder with programs that run modules of Python."""
    folder.mkdir()
    for name, module in modules.items():
        words = [sys.executable, *(["-m", module] if module else [])]
        (folder / name).write_text(f'#!/bin/sh\nexec {shlex.join(words)} "$@"\n')
        (folder / name).chmod(0o755)
    return folder
