"""The command line, called in this process: starting Python for each run would take most of the time."""

from __future__ import annotations

import contextlib
import io
import os
from dataclasses import dataclass
from pathlib import Path

from mipgen import cli
from support import ROOT


@dataclass(frozen=True)
class Done:
    returncode: int
    stdout: str
    stderr: str


def mipgen(*arguments: str | Path, cwd: Path = ROOT, **environment: str) -> Done:
    """Runs a command in a folder, with variables of the environment."""
    here, before = Path.cwd(), dict(os.environ)
    out, err = io.StringIO(), io.StringIO()
    os.chdir(cwd)
    os.environ.update(environment)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = cli.main([str(argument) for argument in arguments])
    finally:
        os.chdir(here)
        for name in environment:
            os.environ.pop(name)
        os.environ.update({name: value for name, value in before.items() if name in environment})
    return Done(status, out.getvalue(), err.getvalue())
