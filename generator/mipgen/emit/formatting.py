"""Runs formatters on the output of a target, so that templates need not care about line breaks.

A target selects one with `Target(formatter=formatting.CLANG_FORMAT)`. The style is a file of the output,
so that running the same tool there changes nothing.
"""

from __future__ import annotations

import importlib
import subprocess
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mipgen.base import cache
from mipgen.base.errors import Failure


@dataclass(frozen=True, slots=True)
class Formatter:
    package: str  # the Python package on PyPI that contains the program
    program: Callable[[], str]  # the path of the program in that package
    suffixes: tuple[str, ...]  # of files to format
    style: str  # the style file, at the top of the output
    steps: tuple[tuple[str, ...], ...]  # the arguments of each run, without the files

    def version(self) -> str:
        from importlib.metadata import PackageNotFoundError, version  # slow to import

        try:
            return version(self.package)
        except PackageNotFoundError:
            raise FormatError(f"{self.package} is missing; pip install {self.package}") from None


class FormatError(Failure):
    """The formatter is missing, or cannot read the files of a target."""


def _clang_format() -> str:
    module: Any = importlib.import_module("clang_format")
    return str(module.get_executable("clang-format"))


def _ruff() -> str:
    module: Any = importlib.import_module("ruff")
    return str(module.find_ruff_bin())


CLANG_FORMAT = Formatter(
    package="clang-format",
    program=_clang_format,
    suffixes=(".c", ".h", ".hpp"),
    style=".clang-format",
    steps=(("-i", "--style=file:.clang-format", "--fail-on-incomplete-format"),),
)
RUFF = Formatter(
    package="ruff",
    program=_ruff,
    suffixes=(".py",),
    style="pyproject.toml",
    steps=(
        ("check", "--no-cache", "--config=pyproject.toml", "--select=F401,I", "--fix-only"),
        ("format", "--no-cache", "--config=pyproject.toml"),
    ),
)


def formatted(formatter: Formatter, made: Mapping[str, bytes]) -> dict[str, bytes]:
    """Returns the files of an output, formatted if they are in the formatter's language."""
    if formatter.style not in made:
        raise FormatError(f"{formatter.package} needs {formatter.style} in the output, which defines the style")
    how = cache.key(formatter.package, formatter.version(), repr(formatter.steps), made[formatter.style])
    keys = {path: cache.key(how, path, data) for path, data in made.items() if path.endswith(formatter.suffixes)}
    cached = {path: cache.get("formatted", name) for path, name in keys.items()}
    done = {path: text for path, text in cached.items() if text is not None}
    wanted = sorted(cached.keys() - done.keys())
    if wanted:
        new = _run(formatter, {path: made[path] for path in (formatter.style, *keys)}, wanted)
        cache.put("formatted", {keys[path]: text for path, text in new.items()})
        done |= new
    return {**made, **done}


def _run(formatter: Formatter, made: Mapping[str, bytes], wanted: list[str]) -> dict[str, bytes]:
    """Formats in a temporary folder that contains the names of all files, because import sorting looks for modules."""
    needed = {formatter.style, *wanted}
    with tempfile.TemporaryDirectory(prefix="mipgen-") as name:
        folder = Path(name)
        for path, data in made.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(data if path in needed else b"")
        for step in formatter.steps:
            if _ran(formatter, step, wanted, folder).returncode != 0:
                failed = {path: _ran(formatter, step, [path], folder) for path in wanted}
                texts = [f"{path}: {_message(done)}" for path, done in failed.items() if done.returncode != 0]
                raise FormatError("\n".join([f"{formatter.package} cannot format the generated files:", *texts]))
        return {path: (folder / path).read_bytes() for path in wanted}


def _ran(
    formatter: Formatter, step: tuple[str, ...], files: list[str], folder: Path
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [formatter.program(), *step, *files], cwd=folder, capture_output=True, text=True, encoding="utf-8"
    )


def _message(done: subprocess.CompletedProcess[str]) -> str:
    return (done.stdout + done.stderr).strip() or "it cannot be parsed; is a bracket missing?"
