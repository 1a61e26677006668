"""What holds for all targets: determinism, no needless writes, stale files, a new language."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from mipgen import cli, render
from support import ROOT, SPECS, all_fields, model

CSV_TARGET = '''"""CSV: one row for each field."""

from ..render import File

TITLE = "a table of all fields"


def files(model):
    yield File("fields.csv", "fields.csv.j2")


def identifiers(model):
    return ()


def filters(model):
    return {"hex": lambda n: f"0x{n:02X}"}
'''
CSV_TEMPLATE = """set,descriptor,name,parameters
{% for f in model.fields %}
{{ f.set | hex }},{{ f.descriptor | hex }},{{ f.full_name }},{{ f.parameters | map(attribute="name") | join(" ") }}
{% endfor %}
"""


def mipgen(*arguments: str, root: Path = ROOT, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "mipgen", *arguments], capture_output=True, text=True, cwd="/",
        env={**os.environ, "PYTHONPATH": str(root / "generator"), **environment},
    )  # fmt: skip


def tree(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("first")
    done = mipgen("generate", "--out", str(out))
    assert done.returncode == 0, done.stderr
    return out


def test_the_same_from_anywhere(first: Path, tmp_path: Path) -> None:
    """Another folder, home, locale, hash seed and time zone; a copy of the project in another place."""
    copy = tmp_path / "copy"
    for part in ("generator", "templates", "spec"):
        shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "LICENSE", copy)
    strange = {
        "LC_ALL": "C",
        "LANG": "C",
        "HOME": str(tmp_path),
        "PYTHONHASHSEED": "7",
        "TZ": "Asia/Tokyo",
        "USER": "x",
    }
    done = mipgen("generate", "--out", str(tmp_path / "out"), root=copy, **strange)
    assert done.returncode == 0, done.stderr
    assert tree(tmp_path / "out") == tree(first)


@pytest.mark.parametrize("version", ["3.10", "3.12", "3.13"])
def test_the_same_from_another_python(first: Path, tmp_path: Path, version: str) -> None:
    """Where another Python is on the machine; the syntax is checked for 3.10 in any case."""
    import ast

    minor = int(version.partition(".")[2])
    for path in sorted((ROOT / "generator/mipgen").rglob("*.py")):
        ast.parse(path.read_text("utf-8"), feature_version=(3, minor))
    pythons = sorted((Path.home() / ".pyenv/versions").glob(f"{version}.*/bin/python"))
    site = next((p for p in map(Path, sys.path) if p.name == "site-packages" and (p / "jinja2").is_dir()), None)
    if not pythons or site is None:
        return
    # The compiled wheels of this Python do not fit the other one: it runs on the pure Python parts.
    pure = tmp_path / "site"
    pure.mkdir()
    for name in (
        "jinja2",
        "yaml",
        "jsonschema",
        "jsonschema_specifications",
        "referencing",
        "attrs",
        "attr",
        "typing_extensions.py",
        "markupsafe",
    ):
        source = site / name
        if source.is_dir():
            shutil.copytree(source, pure / name, ignore=shutil.ignore_patterns("__pycache__", "*.so"))
        elif source.is_file():
            shutil.copy(source, pure)
    (pure / "rpds.py").write_text(RPDS)
    code = "import sys; from mipgen.cli import main; sys.exit(main())"
    done = subprocess.run(
        [str(pythons[0]), "-c", code, "generate", "--out", str(tmp_path / "out")], capture_output=True, text=True,
        env={"PATH": os.environ["PATH"], "PYTHONPATH": f"{ROOT / 'generator'}:{pure}", "PYTHONDONTWRITEBYTECODE": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert tree(tmp_path / "out") == tree(first)


#: As much of rpds as `referencing` needs, in plain Python.
RPDS = """
class HashTrieMap(dict):
    @classmethod
    def convert(cls, value): return value if isinstance(value, cls) else cls(value)
    def insert(self, key, value): return HashTrieMap({**self, key: value})
    def remove(self, key): return HashTrieMap({k: v for k, v in self.items() if k != key})
    def discard(self, key): return self.remove(key)
    def update(self, other): return HashTrieMap({**self, **dict(other)})
    def __hash__(self): return id(self)
class HashTrieSet(frozenset):
    @classmethod
    def convert(cls, value): return cls(value)
    def insert(self, value): return HashTrieSet(self | {value})
    def remove(self, value): return HashTrieSet(self - {value})
    def discard(self, value): return HashTrieSet(self - {value})
    def update(self, *others): return HashTrieSet(self.union(*others))
class List(tuple):
    def __new__(cls, *items):
        return super().__new__(cls, items[0] if len(items) == 1 and not isinstance(items[0], str) else items)
    def push_front(self, value): return List([value, *self])
    @property
    def first(self): return self[0]
    @property
    def rest(self): return List(self[1:])
"""


def test_a_second_run_touches_nothing(first: Path) -> None:
    before = {p: p.stat().st_mtime_ns for p in first.rglob("*")}
    done = mipgen("generate", "--out", str(first))
    assert done.returncode == 0 and " 0 changed" in done.stdout
    assert {p: p.stat().st_mtime_ns for p in first.rglob("*")} == before


def test_stale_files_go_and_others_stay(first: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    shutil.copytree(first, out)
    old = out / "python/mip_protocol/old.py"
    old.write_text("gone\n")
    manifest = out / "python" / render.MANIFEST
    manifest.write_text(manifest.read_text() + "mip_protocol/old.py\n")
    mine = out / "python/mine.txt"
    mine.write_text("kept\n")
    done = mipgen("check", "--out", str(out))
    assert done.returncode == 1
    assert "old.py: error: stale" in done.stderr and "mine.txt: error: untracked" in done.stderr
    assert mipgen("generate", "--out", str(out)).returncode == 0
    assert not old.exists() and mine.read_text() == "kept\n"


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_what_is_committed_is_what_the_specification_gives(spec: str) -> None:
    source, out = SPECS[spec]
    done = mipgen("check", "--spec", str(source), "--out", str(out))
    assert done.returncode == 0, done.stderr


def test_a_missing_or_changed_file_is_noticed(first: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    shutil.copytree(first, out)
    (out / "python/LICENSE").unlink()
    (out / "python/README.md").write_text("changed\n")
    done = mipgen("check", "--out", str(out))
    assert done.returncode == 1
    assert "LICENSE: error: missing" in done.stderr and "README.md: error: changed" in done.stderr


def test_a_new_language_is_one_folder_and_one_file(tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    for part in ("generator", "templates"):
        shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "LICENSE", copy)
    (copy / "generator/mipgen/targets/csv.py").write_text(CSV_TARGET)
    (copy / "templates/csv").mkdir()
    (copy / "templates/csv/fields.csv.j2").write_text(CSV_TEMPLATE)
    done = mipgen(
        "generate", "--spec", str(ROOT / "spec"), "--out", str(tmp_path / "out"), "--target", "csv", root=copy
    )
    assert done.returncode == 0, done.stderr
    rows = (tmp_path / "out/csv/fields.csv").read_text("utf-8").splitlines()
    assert len(rows) == len(model("real").fields) + 1
    assert "0x01,0x01,base.ping," in rows
    assert "csv" in mipgen("generate", "--help", root=copy).stdout


def test_the_readme_shows_that_language() -> None:
    guide = (ROOT / "docs/new-language.md").read_text("utf-8")
    assert CSV_TARGET in guide and CSV_TEMPLATE in guide


def test_a_typo_in_a_template_fails_at_once(tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    for part in ("generator", "templates"):
        shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "LICENSE", copy)
    template = copy / "templates/python/registry.py.j2"
    template.write_text(template.read_text("utf-8").replace("s.number", "s.nubmer"))
    done = mipgen("generate", "--spec", str(ROOT / "spec"), "--out", str(tmp_path / "out"), root=copy)
    assert done.returncode != 0 and "nubmer" in done.stderr
    assert not (tmp_path / "out").exists()


def test_generated_text_says_nothing_of_the_machine(first: Path) -> None:
    for name, data in tree(first).items():
        text = data.decode("utf-8")
        assert "\r" not in text, name
        assert str(Path.home()) not in text and str(ROOT) not in text, name


def test_every_folder_stands_alone(first: Path) -> None:
    for name in render.names():
        folder = first / name
        assert (folder / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
        assert (folder / "README.md").is_file()
        assert (folder / render.MANIFEST).read_text().splitlines() == sorted(
            p for p in tree(folder) if p != render.MANIFEST
        )


def test_command_line_names_what_is_wrong(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert cli.main(["validate", "--spec", str(tmp_path)]) == 1
    assert "protocol.yaml is missing" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli.main(["generate", "--target", "cobol"])
    assert "cobol" in capsys.readouterr().err


# --------------------------------------------------------------------------- counts, derived and held together


def test_counts_agree(first: Path) -> None:
    """Each field of the specification is a type in each language and a section in the reference."""
    of = model("real")
    own = [f for s in of.sets for f in s.own_fields]

    def count(pattern: str, folder: str, files: str) -> int:
        texts = (p.read_text("utf-8") for p in sorted((first / folder).rglob(files)))
        return sum(len(re.findall(pattern, text, re.M)) for text in texts)

    each = len(own) + 1  # and the acknowledge field
    assert count(r"^    DESCRIPTOR = ", "python", "*.py") == each
    assert count(r"^mip_error mip_\w+_decode\(\s*struct mip_", "c/include/mip", "*.h") == each
    assert count(r"^field! \{", "rust/src/", "*.rs") == each
    anchors = "|".join(re.escape(f'<a id="{f.full_name}">') for f in all_fields(of))
    assert count(anchors, "markdown/docs", "*.md") == len(all_fields(of)) == len(of.fields) + 1
    assert len(all_fields(of)) - each == sum(f.definition is not None for f in of.fields)
