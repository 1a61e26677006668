"""A PATH with Python, a C compiler, make, git and what every machine has.

Tests that declare nothing find nothing else: one that needs more is red on all machines, not only on a bare one.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

PROGRAMS = """
sh bash env make git cc gcc as ld ar nm ranlib size strip awk sed grep find xargs tar gzip diff cmp
basename cat chmod cp cut date dd dirname echo expr false head id install kill ln ls mkdir mkfifo mktemp mv nproc od
paste printf ps pwd readlink realpath rm rmdir seq sleep sort split stat stty tail tee test timeout touch tr true tty
uname uniq wc
"""


def path(folder: Path, where: str) -> str:
    """Fills a folder with those of these programs that are on a PATH, and returns it."""
    folder.mkdir(parents=True, exist_ok=True)
    found = {name: shutil.which(name, path=where) for name in PROGRAMS.split()}
    found["python3"] = os.path.realpath(sys.executable)
    for name, program in found.items():
        if program is not None:
            link = folder / f"{name}.{os.getpid()}"
            link.symlink_to(program)
            link.replace(folder / name)  # at once, because other processes use it
    return str(folder)
