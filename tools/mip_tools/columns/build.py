"""Compiles the innermost loops of columns: `python -m mip_tools.columns.build`.

Columns are then two to four times as fast, and the same. Besides NumPy, it takes a C compiler, nothing
else; without it, NumPy does everything.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from ..binding import MissingExtra
from ..errors import Failure

_COMPILERS = ("cc", "gcc", "clang")
_OPTIONS = ("-std=c99", "-O3", "-shared", "-fPIC")


def build(folder: Path | None = None) -> Path:
    """Compiles it into a folder, by default that of this package, and returns the path.

    Raises Failure if there is no compiler or no source, if it fails, or if the folder cannot be
    written to, MissingExtra without NumPy.
    """
    from . import native

    try:
        path = native.library() if folder is None else native.library(folder)
    except OSError as error:
        raise Failure(f"{native.SOURCE}: {error.strerror or error}; install the whole package in a folder") from None
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    command = [*_compiler(), *_OPTIONS, "-o", str(part), str(native.SOURCE)]
    if not os.access(path.parent, os.W_OK):
        raise Failure(f"{path.parent} cannot be written to; install the package where you may")
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace")
        if done.returncode:
            raise Failure(f"{shlex.join(command)} fails:\n{done.stderr.strip()}")
        try:
            native.Kernel(part)
        except (OSError, AttributeError) as error:
            raise Failure(f"what {command[0]} has made cannot be loaded: {error}") from None
        os.replace(part, path)
    except OSError as error:
        raise Failure(f"{command[0]}: {error.strerror or error}") from None
    finally:
        part.unlink(missing_ok=True)
    return path


def _compiler() -> list[str]:
    """The compiler that the environment names, else one that is there."""
    try:
        named = _words(os.environ.get("CC", ""))
    except ValueError as error:
        raise Failure(f"CC={os.environ['CC']}: {error}; quote a path with spaces") from None
    if named:
        return named
    for name in _COMPILERS:
        if shutil.which(name):
            return [name]
    raise Failure(f"no C compiler found: none of {', '.join(_COMPILERS)}; name one with CC")


def _words(text: str, windows: bool = sys.platform == "win32") -> list[str]:
    """The words of a command, with quotes around those that have spaces. Raises ValueError."""
    if not windows:
        return shlex.split(text)
    words = shlex.split(text, posix=False)  # a backslash is in every path there
    return [w[1:-1] if w[0] in "\"'" and w[-1] == w[0] else w for w in words]


def main() -> int:
    """The command line, which takes no arguments."""
    if len(sys.argv) > 1:
        print("usage: python -m mip_tools.columns.build", file=sys.stderr)
        return 0 if sys.argv[1:] in (["-h"], ["--help"]) else 2
    try:
        path = build()
    except (Failure, MissingExtra) as error:
        print(f"{__spec__.name if __spec__ else 'build'}: {error}", file=sys.stderr)
        return 1
    print(f"{path}\nColumns use it from now on; without the file, they do not.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
