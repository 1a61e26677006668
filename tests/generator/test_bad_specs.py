"""Every bad specification is refused with just the messages that it announces; every check has one."""

from __future__ import annotations

import ast
import gc
import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import CodeType, FunctionType

import mipgen.read.problems
import pytest
from bad_spec_files import BASE, bad_specs, named, problems, tables
from mipgen import cli
from mipgen.lower import codec
from mipgen.read import syntax
from mipgen.resolve import checks
from mipgen.resolve.load import load_model
from support import tree

GENERATOR = Path(mipgen.__file__).parent
MODULES = (
    *("read/loader.py", "read/nodes.py", "read/schemas.py", "read/syntax.py", "facts/references.py", "emit/naming.py"),
    *sorted(f"resolve/{path.name}" for path in (GENERATOR / "resolve").glob("[!_]*.py")),
)  # fmt: skip

#: What reports a problem: calls of these, `raise Wrong(...)`, and the faults that `syntax` and `schemas` return.
FAULTS = {"_fault", "_fault_of_key", "Fault", "_unclosed"}
REPORTERS = {"add", "problem", "complain", "wrong", "named", "_fits", "Wrong", *FAULTS}

#: Sites that no specification can reach; each has its own test.
UNREACHABLE = {
    "loader: problems.add(Position(display_path(folder), 1, 1), f'this overlay contains none of these files: {files}')":
        "test_overlay.py::test_messages",
    "loader: problems.add(Position(display_path(folder), 1, 1), "
    "'this folder contains no witnesses, that is, no .yaml files')":
        "test_witness.py::test_command_line",
    "checks: problems.add(model.protocol.acknowledge.position, 'no set contains a field; add one to a file in sets/')":
        "test_no_field_at_all",
    "loader: problems.add(Position(shown, 1, 1), f'the name of this file {fault}; rename it')":
        "test_what_is_no_file_and_a_name_that_is_no_text",
    "loader: problems.add(Position(shown, 1, 1), 'this is not a file')":
        "test_what_is_no_file_and_a_name_that_is_no_text",
    "nodes: problems.add(Position(name, 1, 1), f'cannot be read: {error.strerror}')":
        "test_a_folder_in_place_of_a_file",
    "evidence: raise Wrong(place, f\"'{field.full_name}' does not encode to its own bytes, but to {again.hex(' ')}\")":
        "test_an_example_that_does_not_encode_to_its_own_bytes",
}  # fmt: skip


def test_the_base_is_good() -> None:
    assert len(load_model(BASE).fields) == 5


def test_the_tables() -> None:
    """Rows have names of their own and announce something; characters that look like others are in two tables only."""
    written = [name for path in tables() for name in re.findall(r"(?m)^  (\w+): ", path.read_text("utf-8"))]
    assert sorted(written) == sorted({bad.name for bad in bad_specs()})
    assert [bad.name for bad in bad_specs() if not bad.errors] == []
    others = [path.stem for path in tables() if not path.read_text("utf-8").isascii()]
    assert others == ["characters", "yaml"]


# --------------------------------------------------------------------------- the command line


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
    with pytest.raises(mipgen.read.problems.SpecError, match=r"^spec/sets/bad.yaml:"):
        load_model(spec)


def test_no_field_at_all(tmp_path: Path) -> None:
    """Whether the sets are empty or missing."""
    shutil.copytree(BASE, tmp_path / "spec")
    for part in ("devices", "evidence", "examples", "errata", "guides", "packets", "simulation"):
        shutil.rmtree(tmp_path / "spec" / part)
    for path in (tmp_path / "spec/sets").glob("*.yaml"):
        path.write_text(path.read_text("utf-8").partition("fields:\n")[0], "utf-8")
    for _ in range(2):
        with pytest.raises(
            mipgen.read.problems.SpecError, match=r"protocol.yaml:13:3: error: no set contains a field; add one"
        ):
            load_model(tmp_path / "spec")
        shutil.rmtree(tmp_path / "spec/sets", ignore_errors=True)


@pytest.mark.parametrize(("target", "whose"), [("c", "names of a command"), ("javascript", "names of a class")])
def test_a_function_with_a_name_of_every_command(target: str, whose: str, tmp_path: Path) -> None:
    """It is reported once, where the function is."""
    spec = Path(shutil.copytree(BASE, tmp_path / "spec"))
    text = (spec / "protocol.yaml").read_text("utf-8").replace("  apply: {", "  decode: {")
    (spec / "protocol.yaml").write_text(text, "utf-8")
    of = f"decode of every {whose.rpartition(' ')[2]}"
    assert problems(spec, target) == [
        f"protocol.yaml:11:3: error: 'function decode' and '{of}' both become decode in the {whose} of the target "
        f"{target}; rename one"
    ]


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
            if isinstance(node, (ast.Expr, ast.Raise, ast.Return)) and _reports(node):
                last = node.end_lineno or node.lineno
                yield Site(str(path), function.lineno, node.lineno, last, ast.unparse(node))


def _reports(node: ast.Expr | ast.Raise | ast.Return) -> bool:
    value = node.exc if isinstance(node, ast.Raise) else node.value
    if not isinstance(value, ast.Call):
        return False
    name = value.func.attr if isinstance(value.func, ast.Attribute) else getattr(value.func, "id", "")
    if name == "add":
        return "problems" in ast.unparse(value.func)
    kind = ast.Raise if name == "Wrong" else ast.Return if name in FAULTS else ast.Expr
    return name in REPORTERS and isinstance(node, kind)


def watched(path: Path, own: set[Site], reached: set[Site]) -> Iterator[tuple[FunctionType, CodeType]]:
    """The functions of a module, with code that notes which sites run; a tracer would take six times as long."""
    tree = ast.parse(path.read_text("utf-8"))
    known = sorted(own, key=lambda s: s.first)
    numbers = {(s.first, s.last): i for i, s in enumerate(known)}
    for block in (getattr(n, part, None) for n in ast.walk(tree) for part in ("body", "orelse", "handlers")):
        for i, statement in reversed(list(enumerate(block if isinstance(block, list) else ()))):
            number = numbers.get((statement.lineno, statement.end_lineno))
            if number is not None:
                note = ast.parse(f"_reached({number})").body[0]
                block.insert(i, ast.fix_missing_locations(ast.copy_location(note, statement)))
    codes = {(c.co_name, c.co_firstlineno): c for c in parts(compile(tree, str(path), "exec"))}
    for function in [f for f in gc.get_objects() if type(f) is FunctionType and f.__code__.co_filename == str(path)]:
        function.__globals__["_reached"] = lambda number: reached.add(known[number])
        yield function, codes[function.__code__.co_name, function.__code__.co_firstlineno]


def parts(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from parts(constant)


def test_every_message_and_every_site_that_reports_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What each bad specification announces is reported, and nothing in the generator can report more."""
    wanted, reached = {site for module in MODULES for site in sites(GENERATOR / module)}, set[Site]()
    assert len(wanted) > 120
    with monkeypatch.context() as patch:
        for module in MODULES:
            own = {s for s in wanted if s.file == str(GENERATOR / module)}
            for function, code in watched(GENERATOR / module, own, reached):
                patch.setattr(function, "__code__", code)
        found = {}
        spec = Path(shutil.copytree(BASE, tmp_path / "spec"))
        for bad in bad_specs():
            bad.change(spec)
            found[bad.name] = problems(spec, bad.target)
            bad.restore(spec)
    assert tree(spec) == tree(BASE)
    assert found == {bad.name: bad.errors for bad in bad_specs()}
    assert sorted(str(s) for s in wanted - reached) == sorted(UNREACHABLE)


def test_every_remedy_of_a_parser_is_given() -> None:
    """The remedies in the table are raised in one place; each has a bad specification of its own."""
    given = "\n".join(error for bad in bad_specs() for error in bad.errors)
    assert [words for words in syntax._REMEDIES.values() if re.split(r" *'?\{", words)[0] not in given] == []


def test_every_check_is_run() -> None:
    """A function of checks.py that takes a model and problems is named by one of its two entries."""
    tree = ast.parse((GENERATOR / "resolve/checks.py").read_text("utf-8"))
    functions = {f.name: f for f in tree.body if isinstance(f, ast.FunctionDef)}
    taking = {n for n, f in functions.items() if [a.arg for a in f.args.args] == ["model", "problems"]}
    entries = {"check_definitions", "check_evidence"}
    run = {n.id for e in entries for n in ast.walk(functions[e]) if isinstance(n, ast.Name)}
    assert taking - entries <= run
    assert all(callable(getattr(checks, name)) for name in taking)


def test_an_example_that_does_not_encode_to_its_own_bytes(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The reference codec would have to be wrong; nothing in a specification makes it so."""
    monkeypatch.setattr(codec, "encode", lambda field, values: b"\x00")
    with pytest.raises(mipgen.read.problems.SpecError, match="does not encode to its own bytes, but to 00"):
        load_model(BASE)
