"""Every bad specification is refused with just the messages that it announces; every check has one."""

from __future__ import annotations

import ast
import re
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import FrameType
from typing import Any

import mipgen.problems
import pytest
from corpus import BASE, BadSpec, bad_specs, only_what_changed, problems, reported
from mipgen import checks, cli, codec, syntax
from mipgen.resolve import load_model

GENERATOR = Path(mipgen.__file__).parent
MODULES = (
    "loader", "nodes", "syntax", "vocabulary", "layout", "meaning", "variation", "resolve", "sets", "devices",
    "inheritance", "evidence", "guides", "checks", "references", "naming",
)  # fmt: skip

#: What reports a problem: calls of these, `raise Wrong(...)`, the faults that `syntax` returns, and the messages that
#: `loader.messages` yields.
REPORTERS = {"add", "problem", "complain", "wrong", "named", "_fits", "Wrong", "_fault", "Fault", "_unclosed"}

FAULTS = {"_fault", "Fault", "_unclosed"}

#: Sites that no specification can reach; each has its own test.
UNREACHABLE = {
    "loader: problems.add(Position(shown(folder), 1, 1), f'nothing to add to the specification: no {files}')":
        "test_overlay.py::test_messages",
    "checks: problems.add(model.protocol.acknowledge.position, 'no set has a field; write one, in a file of sets/')":
        "test_no_field_at_all",
    "loader: yield ([], f'{inside}: {error.message}')": "test_a_rule_without_words",
    "nodes: problems.add(Position(name, 1, 1), f'cannot be read: {error.strerror}')":
        "test_a_folder_in_place_of_a_file",
    "evidence: raise Wrong(place, f\"'{field.full_name}' does not encode to its own bytes, but to {again.hex(' ')}\")":
        "test_an_example_that_does_not_encode_to_its_own_bytes",
}  # fmt: skip


def test_the_base_is_good() -> None:
    assert len(load_model(BASE).fields) == 5


@pytest.mark.parametrize("bad", bad_specs(), ids=lambda bad: bad.name)
def test_message(bad: BadSpec) -> None:
    assert bad.errors, "an '# error:' line is missing; `python tests/generator/corpus.py accept` writes it"
    assert reported(bad) == bad.errors


@pytest.mark.parametrize("bad", bad_specs(), ids=lambda bad: bad.name)
def test_small(bad: BadSpec) -> None:
    assert len(bad.data.splitlines()) <= 50
    assert bad.data.isascii() or bad.name.startswith(("character_", "yaml_not_utf8", "yaml_space", "yaml_curly"))


# --------------------------------------------------------------------------- the command line


def named(name: str) -> BadSpec:
    return next(bad for bad in bad_specs() if bad.name == name)


@pytest.mark.parametrize(
    "name", ["yaml_colon", "schema_missing", "descriptor_twice", "example_checksum", "name_collision"]
)
@pytest.mark.parametrize("command", ["validate", "generate", "check"])
def test_nothing_is_written(name: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec, out = named(name).lay(tmp_path), tmp_path / "out"
    (out / "python").mkdir(parents=True)
    (out / "python" / "kept.txt").write_text("kept", "utf-8")
    options = ["--target", "python", *([] if command == "validate" else ["--out", str(out)])]
    assert cli.main([command, "--spec", str(spec), *options]) == 1
    written = capsys.readouterr()
    assert written.out == ""
    assert written.err.splitlines()[-1].endswith("nothing was written")
    assert [e.replace(f"{spec}/", "") for e in written.err.splitlines()[:-1]] == named(name).errors
    assert [p.relative_to(out).as_posix() for p in out.rglob("*") if p.is_file()] == ["python/kept.txt"]


def test_paths_are_those_of_the_caller(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    spec = named("descriptor_twice").lay(tmp_path)
    monkeypatch.chdir(spec.parent)
    with pytest.raises(mipgen.problems.SpecError, match=r"^spec/sets/bad.yaml:"):
        load_model(spec)


def test_no_field_at_all(tmp_path: Path) -> None:
    """Whether the sets are empty or missing."""
    shutil.copytree(BASE, tmp_path / "spec")
    for part in ("devices", "examples", "errata", "guides", "simulation"):
        shutil.rmtree(tmp_path / "spec" / part)
    for path in (tmp_path / "spec/sets").glob("*.yaml"):
        path.write_text(path.read_text("utf-8").partition("fields:\n")[0], "utf-8")
    for _ in range(2):
        with pytest.raises(
            mipgen.problems.SpecError, match=r"protocol.yaml:12:3: error: no set has a field; write one"
        ):
            load_model(tmp_path / "spec")
        shutil.rmtree(tmp_path / "spec/sets", ignore_errors=True)


# --------------------------------------------------------------------------- completeness


@dataclass(frozen=True)
class Site:
    """A place in the generator that reports a problem."""

    file: str
    function: int  # the first line of the function around it
    first: int
    last: int
    text: str

    def __str__(self) -> str:
        return f"{Path(self.file).stem}: {self.text}"


def sites(path: Path) -> Iterator[Site]:
    for function in ast.walk(ast.parse(path.read_text("utf-8"))):
        if not isinstance(function, ast.FunctionDef) or function.name in REPORTERS - {"named", "wrong"}:
            continue
        for node in ast.walk(function):
            if isinstance(node, (ast.Expr, ast.Raise, ast.Return)) and _reports(node, function.name):
                last = node.end_lineno or node.lineno
                yield Site(str(path), function.lineno, node.lineno, last, ast.unparse(node))


def _reports(node: ast.Expr | ast.Raise | ast.Return, function: str) -> bool:
    value = node.exc if isinstance(node, ast.Raise) else node.value
    if isinstance(value, ast.Yield):
        return function == "messages"
    if not isinstance(value, ast.Call):
        return False
    name = value.func.attr if isinstance(value.func, ast.Attribute) else getattr(value.func, "id", "")
    if name == "add":
        return "problems" in ast.unparse(value.func)
    kind = ast.Raise if name == "Wrong" else ast.Return if name in FAULTS else ast.Expr
    return name in REPORTERS and isinstance(node, kind)


class Coverage:
    """Watches which sites run; functions whose sites have all run are no longer watched."""

    def __init__(self, wanted: set[Site]) -> None:
        self.missing = set(wanted)
        self.functions = {(s.file, s.function) for s in wanted}

    def __call__(self, frame: FrameType, event: str, argument: Any) -> Any:
        code = frame.f_code
        return self.line if (code.co_filename, code.co_firstlineno) in self.functions else None

    def line(self, frame: FrameType, event: str, argument: Any) -> Any:
        if event == "line":
            file, line = frame.f_code.co_filename, frame.f_lineno
            done = {s for s in self.missing if s.file == file and s.first <= line <= s.last}
            if done:
                self.missing -= done
                self.functions = {(s.file, s.function) for s in self.missing}
        return self.line


def test_every_site_is_reached_by_a_bad_spec(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    only_what_changed(monkeypatch)
    wanted = {site for module in MODULES for site in sites(GENERATOR / f"{module}.py")}
    assert len(wanted) > 120
    coverage = Coverage(wanted)
    before = sys.gettrace()
    sys.settrace(coverage)
    try:
        for bad in bad_specs():
            problems(bad.lay(tmp_path), bad.target)
            shutil.rmtree(tmp_path / "spec")
    finally:
        sys.settrace(before)
    assert sorted(str(s) for s in coverage.missing) == sorted(UNREACHABLE)


def test_every_remedy_of_a_parser_is_given() -> None:
    """Those in the table are one site; each has a bad specification of its own."""
    given = "\n".join(error for bad in bad_specs() for error in bad.errors)
    assert [words for words in syntax._REMEDIES.values() if re.split(r" *'?\{", words)[0] not in given] == []


def test_every_check_is_run() -> None:
    """A function of checks.py that takes a model and problems is named by one of its two entries."""
    tree = ast.parse((GENERATOR / "checks.py").read_text("utf-8"))
    functions = {f.name: f for f in tree.body if isinstance(f, ast.FunctionDef)}
    taking = {n for n, f in functions.items() if [a.arg for a in f.args.args] == ["model", "problems"]}
    entries = {"check_definitions", "check_evidence"}
    run = {n.id for e in entries for n in ast.walk(functions[e]) if isinstance(n, ast.Name)}
    assert taking - entries <= run
    assert all(callable(getattr(checks, name)) for name in taking)


def test_an_example_that_does_not_encode_to_its_own_bytes(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The reference codec would have to be wrong; nothing in a specification makes it so."""
    monkeypatch.setattr(codec, "encode", lambda field, values: b"\x00")
    with pytest.raises(mipgen.problems.SpecError, match="does not encode to its own bytes, but to 00"):
        load_model(BASE)
