"""Formatters run over the output, and the cache that makes them cheap."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import jinja2
import pytest
from jinja2 import nodes
from mipgen.base import cache
from mipgen.emit import formatting
from mipgen.emit.formatting import CLANG_FORMAT, RUFF, FormatError, Formatter, formatted
from support import ROOT

C = {".clang-format": b"BasedOnStyle: LLVM\nIndentWidth: 4\n", "a.c": b"int  f(void){return 1;}\n", "b.txt": b"a  b"}
PYTHON = {"pyproject.toml": b"[tool.ruff]\nline-length = 100\n", "p/a.py": b"import sys\nimport os\nx = [os,sys]\n"}
WELL = {"a.c": b"int f(void) { return 1; }\n", "p/a.py": b"import os\nimport sys\n\nx = [os, sys]\n"}


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("MIPGEN_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def no_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a program is run")

    monkeypatch.setattr(subprocess, "run", refuse)


@pytest.mark.parametrize(("formatter", "made"), [(CLANG_FORMAT, C), (RUFF, PYTHON)], ids=["c", "python"])
def test_files_of_the_language_are_formatted(formatter: Formatter, made: dict[str, bytes]) -> None:
    assert formatted(formatter, made) == {**made, **{p: WELL[p] for p in made if p in WELL}}


@pytest.mark.parametrize(("formatter", "made"), [(CLANG_FORMAT, C), (RUFF, PYTHON)], ids=["c", "python"])
def test_neither_the_folder_nor_the_path_matters(
    formatter: Formatter, made: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / ".clang-format").write_text("BasedOnStyle: GNU\n")
    (tmp_path / "ruff.toml").write_text("line-length = 4\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", "")
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    assert formatted(formatter, made)[next(p for p in made if p in WELL)] in WELL.values()


def test_the_style_of_the_output_decides() -> None:
    assert formatted(CLANG_FORMAT, C)["a.c"] == WELL["a.c"]
    other = formatted(CLANG_FORMAT, {**C, ".clang-format": b"BasedOnStyle: GNU\n"})
    assert other["a.c"] == b"int\nf (void)\n{\n  return 1;\n}\n"


def test_what_was_formatted_before_is_not_formatted_again(request: pytest.FixtureRequest) -> None:
    first = formatted(CLANG_FORMAT, C)
    request.getfixturevalue("no_programs")
    assert formatted(CLANG_FORMAT, C) == first


def test_only_what_changed_is_formatted_again(monkeypatch: pytest.MonkeyPatch) -> None:
    formatted(RUFF, {**PYTHON, "b.py": b"b=1\n"})
    asked = []
    run = subprocess.run
    monkeypatch.setattr(subprocess, "run", lambda command, **more: asked.append(command[-1:]) or run(command, **more))
    assert formatted(RUFF, {**PYTHON, "b.py": b"b=2\n"}) == {**PYTHON, "b.py": b"b = 2\n", "p/a.py": WELL["p/a.py"]}
    assert asked == [["b.py"], ["b.py"]]


def test_a_damaged_entry_is_made_again(folder: Path) -> None:
    formatted(CLANG_FORMAT, C)
    (entry,) = (folder / "formatted").iterdir()
    entry.write_bytes(entry.read_bytes()[:-4] + b"; }\n")
    assert formatted(CLANG_FORMAT, C)["a.c"] == WELL["a.c"]
    entry.write_bytes(b"")
    assert formatted(CLANG_FORMAT, C)["a.c"] == WELL["a.c"]


@pytest.mark.parametrize("cache_folder", ["", "/dev/null/no folder"])
def test_it_works_without_a_cache(cache_folder: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MIPGEN_CACHE", cache_folder)
    assert formatted(CLANG_FORMAT, C)["a.c"] == WELL["a.c"]


def test_the_cache_is_where_the_user_keeps_caches(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("MIPGEN_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/var/caches")
    assert cache.cache_folder() == Path("/var/caches/mipgen")
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", "/home/ada")
    assert cache.cache_folder() == Path("/home/ada/.cache/mipgen")


def test_the_cache_does_not_grow_without_end(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "LIMIT", 3 * 5000)
    for n in range(10):
        cache.put("some", {f"0{n}": bytes(300)})  # with such a name, each call looks at all entries
        os.utime(folder / "some" / f"0{n}", (1e9 + n, 1e9 + n))
        assert cache.get("some", "00") == bytes(300)  # in use all the time
    assert sorted(x.name for x in (folder / "some").iterdir()) == ["00", "08", "09"]


def test_what_cannot_be_formatted_is_reported() -> None:
    with pytest.raises(FormatError, match=r"cannot format the generated files:\np/a\.py: (.|\n)*Expected a parameter"):
        formatted(RUFF, {**PYTHON, "p/a.py": b"def f(:\n"})
    with pytest.raises(
        FormatError, match=r"cannot format the generated files:\nb\.c: it cannot be parsed; is a bracket missing\?$"
    ):
        formatted(CLANG_FORMAT, {**C, "b.c": b"int f( { ] )\n"})
    with pytest.raises(FormatError, match="unknown key 'Nonsense'"):
        formatted(CLANG_FORMAT, {**C, ".clang-format": b"Nonsense: 1\n"})


def test_a_missing_formatter_or_style_is_reported(no_programs: None) -> None:
    with pytest.raises(FormatError, match="pip install no-such-formatter"):
        formatted(formatting.Formatter("no-such-formatter", str, (".c",), ".clang-format", ()), C)
    with pytest.raises(FormatError, match=r"needs \.clang-format in the output"):
        formatted(CLANG_FORMAT, {"a.c": b""})


# --------------------------------------------------------------------------- what no formatter sees


def test_lines_of_templates_are_short() -> None:
    """A line that must be longer in the output continues after `{# -#}`, which joins it with the next."""
    files = [path for path in sorted((ROOT / "templates").rglob("*")) if path.is_file()]
    assert len(files) > 50
    numbered = ((path, i, line) for path in files for i, line in enumerate(path.read_text("utf-8").splitlines(), 1))
    long = [f"{path.relative_to(ROOT)}:{i}: {len(line)} characters" for path, i, line in numbered if len(line) > 120]
    assert not long, f"lines of templates over 120 characters: {', '.join(long)}"


def test_templates_compute_nothing() -> None:
    """Sizes, offsets and numbers are those of the view; a template may join texts."""
    environment = jinja2.Environment(extensions=["jinja2.ext.do"])
    arithmetic = (nodes.Add, nodes.Sub, nodes.Mul, nodes.Div, nodes.FloorDiv, nodes.Mod, nodes.Pow)
    computing = []
    for path in sorted((ROOT / "templates").rglob("*.j2")):
        tree = environment.parse(path.read_text("utf-8"))
        computing += [f"{path.relative_to(ROOT)}:{x.lineno}" for kind in arithmetic for x in tree.find_all(kind)]
    assert not computing, f"templates that compute: {', '.join(computing)}"
