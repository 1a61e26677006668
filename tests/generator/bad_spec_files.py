"""The corpus of bad specifications: each file is laid over tests/bad_specs/base and says what is wrong with it.

The first lines of a file state what happens to it; the whole file, with them, becomes the file of the specification:

    # file: sets/bad.yaml            what it replaces or adds
    # remove: protocol.yaml          a file of the base that is taken away (instead of `file`)
    # target: python                 check the names that this target makes, too; ours, or one of `targets/`
    # error: sets/bad.yaml:12:9: error: ...      what must be reported, all of it, in this order

`python tests/generator/bad_spec_files.py accept [name ...]` writes the errors that are reported now into the files.
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import pytest
from mipgen.emit import discovery, naming
from mipgen.read import loader, nodes
from mipgen.read.problems import Problems, SpecError
from mipgen.resolve.load import load_model

CORPUS = Path(__file__).parents[1] / "bad_specs"
BASE = CORPUS / "base"
TARGETS = CORPUS / "targets"

_HEADER = re.compile(r"# (file|remove|target|error): (.*)")


@dataclass(frozen=True)
class BadSpec:
    name: str
    data: bytes
    file: str | None
    remove: str | None
    target: str | None
    errors: list[str]

    def lay(self, folder: Path) -> Path:
        """Writes the whole specification below `folder`."""
        spec = folder / "spec"
        shutil.copytree(BASE, spec)
        if self.file is not None:
            (spec / self.file).write_bytes(self.data)
        if self.remove is not None:
            (spec / self.remove).unlink()
        return spec


def bad_specs() -> list[BadSpec]:
    return [read(path) for path in sorted(CORPUS.glob("*.yaml"))]


def read(path: Path) -> BadSpec:
    data = path.read_bytes()
    found: dict[str, list[str]] = {"file": [], "remove": [], "target": [], "error": []}
    for line in data.decode("utf-8", errors="replace").splitlines():
        header = _HEADER.fullmatch(line)
        if header is None:
            break
        found[header[1]].append(header[2])
    one = {key: values[0] if values else None for key, values in found.items()}
    return BadSpec(path.stem, data, one["file"], one["remove"], one["target"], found["error"])


def problems(spec: Path, target: str | None = None) -> list[str]:
    """What is wrong with a specification, with paths below its folder."""
    try:
        model = load_model(spec)
        if target is not None:
            found = Problems()
            of = discovery.sources([TARGETS])[target].load()
            naming.judge(target, of.identifiers(model), of.grammar, found)
            found.raise_if_any()
    except SpecError as error:
        return [str(p).replace(f"{spec}/", "").replace(str(spec), ".") for p in error.problems]
    return []


def only_what_changed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Files that were valid and have not changed are neither parsed nor checked again: for tests with many runs."""
    good: dict[tuple[str, bytes], nodes.Node] = {}
    judge = loader._valid

    def quick_read(path: Path, name: str, problems: Problems) -> nodes.Node | None:
        key = (name, path.read_bytes())
        return good[key] if key in good else nodes.read(path, name, problems)

    def quick_judge(kind: str, root: nodes.Node, problems: Problems) -> bool:
        if any(root is known for known in good.values()):
            return True
        fine = judge(kind, root, problems)
        if fine and not problems:
            file = root.position.file
            good[file, Path(file).read_bytes()] = root
        return fine

    monkeypatch.setattr(loader, "read", quick_read)
    monkeypatch.setattr(loader, "_valid", quick_judge)


def reported(bad: BadSpec) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        return problems(bad.lay(Path(folder)), bad.target)


def accept(path: Path) -> None:
    """The lines that are added move the places, so this takes more than one turn."""
    for _ in range(3):
        lines = path.read_bytes().split(b"\n")
        head = [line for line in lines if re.match(rb"# (file|remove|target): ", line)]
        rest = [line for line in lines if not re.match(rb"# (file|remove|target|error): ", line)]
        errors = [f"# error: {error}".encode() for error in reported(read(path))]
        path.write_bytes(b"\n".join([*head, *errors, *rest]))


if __name__ == "__main__" and sys.argv[1:2] == ["accept"]:
    for name in sys.argv[2:] or [path.stem for path in sorted(CORPUS.glob("*.yaml"))]:
        accept(CORPUS / f"{name}.yaml")
