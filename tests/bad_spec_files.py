"""Bad specifications: the rows of the tables in tests/bad_specs, each laid over the good specification of base.yaml.

`PYTHONPATH=generator python tests/bad_spec_files.py [name ...]` writes what is reported now into the rows.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml
from mipgen.emit import build, discovery
from mipgen.read.problems import SpecError
from mipgen.resolve.load import load_model
from support import BUILD, locked

CORPUS = Path(__file__).parent / "bad_specs"
TARGETS = CORPUS / "targets"
FRAMES, GOOD = CORPUS / "frames.yaml", CORPUS / "base.yaml"

_KEY = re.compile(r" *(- )?([\w\".*]+:(?= |$)|\{name: \w+,)")
_MARK = re.compile(r"( *)\^ (.*)")
_OPTION = re.compile(r"! (target|remove|encoding|typical): (.*)")
_PLACE = re.compile(r"(.+?):(\d+):(\d+): error: (.*)", re.DOTALL)


def good_specification() -> Path:
    """The folder of the good specification, one for each version of base.yaml."""
    text = GOOD.read_text("utf-8")
    folder = BUILD / f"bad_specs/{hashlib.sha256(text.encode()).hexdigest()[:8]}"
    with locked(folder):
        for name, content in yaml.safe_load(text).items():
            if not (folder / name).is_file():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_text(content, "utf-8")
    return folder


BASE = good_specification()


@dataclass(frozen=True)
class BadSpec:
    name: str
    file: str
    lines: list[str]  # the whole file
    written: list[int]  # the indexes of the lines that the row states
    options: dict[str, str]
    errors: list[str]

    def lay(self, folder: Path) -> Path:
        """Writes the whole specification below `folder`."""
        spec = Path(shutil.copytree(BASE, folder / "spec"))
        self.change(spec)
        return spec

    def change(self, spec: Path) -> None:
        """Makes the good specification in this folder the bad one."""
        if self.lines:
            (spec / self.file).parent.mkdir(exist_ok=True)
            text = "".join(f"{line}\n" for line in self.lines)
            (spec / self.file).write_bytes(text.encode(self.options.get("encoding", "utf-8")))
        if "typical" in self.options:
            (spec / "packets").mkdir(exist_ok=True)
            (spec / "packets/bad.yaml").write_text(f"typical: {self.options['typical']}\n", "utf-8")
        if "remove" in self.options:
            (spec / self.options["remove"]).unlink()

    def restore(self, spec: Path) -> None:
        """Makes it the good one again."""
        for name in {self.file, "packets/bad.yaml", self.options.get("remove", self.file)}:
            if (BASE / name).is_file():
                shutil.copyfile(BASE / name, spec / name)
            else:
                (spec / name).unlink(missing_ok=True)
            if not (BASE / name).parent.is_dir() and (spec / name).parent.is_dir():
                (spec / name).parent.rmdir()

    @property
    def target(self) -> str | None:
        return self.options.get("target")


def tables() -> list[Path]:
    return [path for path in sorted(CORPUS.glob("*.yaml")) if path not in (FRAMES, GOOD)]


@cache
def bad_specs() -> list[BadSpec]:
    loaded = [yaml.load(path.read_text("utf-8"), _loader()) for path in tables()]
    return [read(n, heading, text) for table in loaded for heading, rows in table.items() for n, text in rows.items()]


def named(name: str) -> BadSpec:
    return next(bad for bad in bad_specs() if bad.name == name)


def _loader() -> Any:
    return getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@cache
def frame(heading: str) -> tuple[str, list[str]]:
    """Returns the file that rows below this heading change, and its lines."""
    known = yaml.load(FRAMES.read_text("utf-8"), _loader())
    if heading in known:
        return known[heading]["file"], known[heading]["text"].splitlines()
    path = BASE / heading
    return heading, path.read_text("utf-8").splitlines() if path.exists() else []


def read(name: str, heading: str, row: str) -> BadSpec:
    """Lays a row over its frame."""
    file, framed = frame(heading)
    lines, written, options, errors = list(framed), list[int](), dict[str, str](), list[str]()
    keys = [match and match[0] for match in map(_KEY.match, framed)]
    for line in row.splitlines():
        if option := _OPTION.fullmatch(line):
            options[option[1]] = option[2]
        elif line.startswith("! "):
            errors.append(line[2:].replace(": ", ": error: ", 1))
        elif mark := _MARK.fullmatch(line):
            errors.append(f"{file}:{written[-1] + 1}:{len(mark[1]) + 1}: error: {mark[2]}")
        else:
            key = _KEY.match(line)
            replaced = key is not None and key[0] in keys and (not written or written[-1] < len(framed))
            at = keys.index(key[0]) if key is not None and replaced else len(lines)
            lines[at : at + 1] = [line]
            written.append(at)
    return BadSpec(name, file, lines, written, options, sorted(errors, key=_order))


def _order(error: str) -> tuple[str, int, int]:
    match = _PLACE.fullmatch(error)
    assert match is not None, error
    return match[1], int(match[2]), int(match[3])


def problems(spec: Path, target: str | None = None) -> list[str]:
    """What is wrong with a specification, with paths below its folder."""
    try:
        model = load_model(spec)
        if target is not None:
            build.check_names(model, [discovery.targets([TARGETS])[target]])
    except SpecError as error:
        return [str(p).replace(f"{spec}/", "").replace(str(spec), ".") for p in error.problems]
    return []


# --------------------------------------------------------------------------- messages that changed


def row_with(bad: BadSpec, errors: list[str]) -> Iterator[str]:
    """The lines of a row that announces these errors."""
    yield from (f"! {name}: {value}" for name, value in bad.options.items())
    marks: dict[int, list[str]] = {}
    keys = [match and match[0] for match in map(_KEY.match, bad.lines)]
    for error in errors:
        file, line, column = _order(error)
        message = error.split(": error: ", 1)[1]
        if file == bad.file and (line - 1 in bad.written or keys.index(keys[line - 1]) == line - 1):
            marks.setdefault(line - 1, []).append(" " * (column - 1) + "^ " + message)
        else:
            yield f"! {file}:{line}:{column}: {message}"
    for at in sorted({*bad.written, *marks}):
        yield from (bad.lines[at], *marks.get(at, ()))


def accept(names: list[str]) -> None:
    for table in tables():
        rows = re.split(r"(?m)^(?=  \w+: |\S)", table.read_text("utf-8"))
        for i, row in enumerate(rows):
            header = re.match(r"  (\w+): \|2\n", row)
            if header and (not names or header[1] in names):
                bad = named(header[1])
                with tempfile.TemporaryDirectory() as folder:
                    found = problems(bad.lay(Path(folder)), bad.target)
                rows[i] = header[0] + "".join(f"    {line}".rstrip(" ") + "\n" for line in row_with(bad, found))
        table.write_text("".join(rows), "utf-8")


if __name__ == "__main__":
    accept(sys.argv[1:])
