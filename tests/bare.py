"""A PATH with Python, a C compiler, make, git and what every machine has.

Tests that declare nothing find nothing else: one that needs more is red on all machines, not only on a bare one.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

#: What is used of the compiler's tools, of bash, git, make, procps and so on; and all of coreutils.
PROGRAMS = """
sh bash make git cc gcc as ld ar nm ranlib size strip awk sed grep find xargs tar gzip diff cmp ps kill
b2sum base32 base64 basename cat chgrp chmod chown cksum comm cp csplit cut date dd df dirname du echo env expand expr
false fmt fold head hostid id install join link ln logname ls md5sum mkdir mkfifo mknod mktemp mv nice nl nohup nproc
numfmt od paste pathchk pr printenv printf pwd readlink realpath rm rmdir seq sha1sum sha256sum sha512sum shuf sleep
sort split stat stdbuf stty sum sync tac tail tee test timeout touch tr true truncate tsort tty uname unexpand uniq
unlink wc who whoami
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
