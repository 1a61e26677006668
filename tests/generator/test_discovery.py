"""Targets and templates of a user's own folders."""

from __future__ import annotations

from pathlib import Path

import pytest
from bad_spec_files import BASE
from mipgen import cli
from mipgen.emit import discovery, output
from mipgen.resolve.load import load_model
from support import ROOT, tree

SPEC = BASE
TARGET = """\
from mipgen.emit.target import File, Target


def files(model):
    yield File("fields.csv", "fields.csv.j2")


TARGET = Target(title="a table of all fields", files=files, filters={"hex": lambda n: f"0x{n:02X}"})
"""
TEMPLATE = """\
set,descriptor,name,parameters
{% for f in model.fields %}
{{ f.set | hex }},{{ f.descriptor | hex }},{{ f.full_name }},{{ f.parameters | map(attribute="name") | join(" ") }}
{% endfor %}
"""
#: In place of a target of ours, with one more file.
CHANGED = """\
from dataclasses import replace

from mipgen.emit.target import File
from mipgen.targets import c


def files(model):
    yield from c.TARGET.files(model)
    yield File("fields.csv", "fields.csv.j2")


TARGET = replace(c.TARGET, files=files)
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with one target."""
    write(tmp_path / "targets/csv/target.py", TARGET)
    write(tmp_path / "targets/csv/fields.csv.j2", TEMPLATE)
    return tmp_path / "targets"


def generate(folder: Path, *more: str) -> int:
    out = str(folder.parent / "out")
    return cli.main(["generate", "--spec", str(SPEC), "--out", out, "--target-path", str(folder), *more])


def made(folder: Path, path: str) -> str:
    return (folder.parent / "out" / path).read_text("utf-8")


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def replace(folder: Path, text: str, other: str) -> None:
    target = folder / "csv/target.py"
    assert text in target.read_text()
    target.write_text(target.read_text().replace(text, other))


def test_a_new_language_is_one_folder(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert generate(folder) == 0
    rows = made(folder, "csv/fields.csv").splitlines()
    assert len(rows) == len(load_model(SPEC).fields) + 1
    assert "0x01,0x01,tools.ping," in rows
    assert made(folder, "csv/.manifest") == f"{output.HEADER}\nLICENSE\nfields.csv\n"
    assert {p.name for p in (folder.parent / "out").iterdir()} == {"csv", *discovery.target_names()}
    capsys.readouterr()
    assert cli.main(["targets", "--target-path", str(folder)]) == 0
    assert f"csv        a table of all fields  [{folder / 'csv'}]\n" in capsys.readouterr().out


def test_a_target_may_have_modules_and_files_beside_it(folder: Path) -> None:
    write(folder / "csv/words.py", "HEX = '{:#x}'\n")
    write(folder / "csv/runtime/read/me.txt", "read\n")
    target = folder / "csv/target.py"
    text = target.read_text().replace("from mipgen", "from . import words\nfrom mipgen")
    target.write_text(text.replace('f"0x{n:02X}"', "words.HEX.format(n)"))
    assert generate(folder, "--target", "csv") == 0
    assert "0x1,0x1,tools.ping," in made(folder, "csv/fields.csv")
    assert made(folder, "csv/read/me.txt") == "read\n"


def test_templates_and_runtime_of_ours_are_replaced_and_joined(tmp_path: Path) -> None:
    folder = tmp_path / "targets"
    write(folder / "c/README.md.j2", "C of {{ model.protocol.name }}\n")
    write(folder / "c/runtime/src/mip/core/error.c", "int   error;\n")
    write(folder / "c/runtime/Makefile", "all:\n")
    assert cli.main(["generate", "--spec", str(SPEC), "--out", str(tmp_path / "plain"), "--target", "c"]) == 0
    assert generate(folder, "--target", "c") == 0
    plain, there = tree(tmp_path / "plain/c"), tree(tmp_path / "out/c")
    assert {path for path in there if there[path] != plain.get(path)} == {
        "Makefile", "README.md", "src/mip/core/error.c", ".manifest"
    }  # fmt: skip
    assert plain.keys() == there.keys() - {"Makefile"}
    assert made(folder, "c/README.md") == "C of MIP\n"
    assert made(folder, "c/src/mip/core/error.c") == "int error;\n"


def test_a_file_of_the_runtime_that_a_template_includes_is_replaced(tmp_path: Path) -> None:
    folder = tmp_path / "targets"
    write(folder / "wireshark/runtime/tree.lua", "-- another tree\n")
    assert generate(folder, "--target", "wireshark") == 0
    text = made(folder, "wireshark/mip.lua")
    assert "-- another tree\n" in text
    assert (ROOT / "runtime/wireshark/decode.lua").read_text("utf-8") in text
    assert (ROOT / "runtime/wireshark/tree.lua").read_text("utf-8") not in text


def test_the_module_of_ours_is_replaced(tmp_path: Path) -> None:
    folder = tmp_path / "targets"
    write(folder / "c/target.py", CHANGED)
    write(folder / "c/fields.csv.j2", "{{ model.sets | length }} sets, {{ 'sensor' | module }}\n")
    assert generate(folder, "--target", "c") == 0
    assert made(folder, "c/fields.csv") == f"{len(load_model(SPEC).sets)} sets, sensor\n"
    assert made(folder, "c/README.md").startswith("# ")


def test_the_first_folder_goes_before(tmp_path: Path) -> None:
    write(tmp_path / "a/c/README.md.j2", "first\n")
    write(tmp_path / "b/c/README.md.j2", "second\n")
    write(tmp_path / "b/c/runtime/NOTES", "second\n")
    assert generate(tmp_path / "a", "--target", "c", "--target-path", str(tmp_path / "b")) == 0
    assert made(tmp_path / "a", "c/README.md") == "first\n"
    assert made(tmp_path / "a", "c/NOTES") == "second\n"


def test_a_change_of_a_target_is_seen(folder: Path) -> None:
    """Nothing that is kept between runs hides it: neither of a template nor of a filter."""
    template = folder / "csv/fields.csv.j2"
    template.write_text('{{ 31 | hex }} {{ "a" | title }}\n')
    assert generate(folder, "--target", "csv") == 0
    assert made(folder, "csv/fields.csv") == "0x1F A\n"
    target = folder / "csv/target.py"
    target.write_text(target.read_text().replace('f"0x{n:02X}"', 'f"{n}!"'))
    assert generate(folder, "--target", "csv") == 0
    assert made(folder, "csv/fields.csv") == "31! A\n"
    target.write_text(target.read_text().replace('"hex":', '"title": lambda text: "mine", "hex":'))
    assert generate(folder, "--target", "csv") == 0
    assert made(folder, "csv/fields.csv") == "31! mine\n"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda f: write(f / "csv/fields.csv.j2", "\n{{ model.fieldz }}\n"),
         "{f}/csv/fields.csv.j2:2: error: 'mipgen.model.specification.Model object' "
         "has no attribute 'fieldz' (for fields.csv)"),
        (lambda f: write(f / "csv/fields.csv.j2", "\n\n{% for %}\n"),
         "{f}/csv/fields.csv.j2:3: error: Expected an expression, got 'end of statement block' (for fields.csv)"),
        (lambda f: write(f / "csv/fields.csv.j2", "{{ 1 | hexx }}\n"),
         "{f}/csv/fields.csv.j2:1: error: No filter named 'hexx'. (for fields.csv)"),
        (lambda f: (f / "csv/fields.csv.j2").unlink(),
         "target csv: error: there is no template fields.csv.j2 (for fields.csv)"),
        (lambda f: write(f / "csv/runtime/fields.csv", ""), "target csv: error: fields.csv is made twice"),
        (lambda f: replace(f, '"fields.csv"', '".manifest"'), "target csv: error: .manifest is made twice"),
        (lambda f: replace(f, '"fields.csv"', '"a/../../b"'), "target csv: error: a/../../b is outside of its folder"),
        (lambda f: replace(f, '"fields.csv"', '"/tmp/b"'), "target csv: error: /tmp/b is outside of its folder"),
        (lambda f: write(f / "csv/target.py", "\nTARGET = = 'x'\n"),
         "{f}/csv/target.py:2: error: not Python: invalid syntax"),
        (lambda f: write(f / "csv/target.py", "TITLE = 'x'\ndef files(model): return ()\n"),
         "{f}/csv/target.py: error: TARGET is missing; add TARGET = Target(title=..., files=...)"),
        (lambda f: replace(f, "title=", "titel="), "{f}/csv/target.py:8: error: Target.__init__() got an unexpected "
         "keyword argument 'titel'"),
        (lambda f: replace(f, 'File("fields.csv", "fields.csv.j2")', '"fields.csv"'),
         "target csv: error: files yields 'fields.csv'; it must yield File(path, template)"),
        (lambda f: (f / "cc").mkdir(), "{f}/cc: error: target.py is missing, and there is no target 'cc', "
         "did you mean 'c'?"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(change: object, message: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert callable(change)
    change(folder)
    assert generate(folder, "--target", "csv") == 1
    assert capsys.readouterr().err == message.format(f=folder) + "\n"
    assert not (folder.parent / "out").exists()


def test_a_folder_without_targets_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert generate(tmp_path / "none") == 1
    assert f"{tmp_path / 'none'}: error: there is no such folder" in capsys.readouterr().err
    assert generate(tmp_path) == 1
    assert f"{tmp_path}: error: this folder contains no target" in capsys.readouterr().err


def test_a_fault_in_a_target_is_shown_with_its_place(folder: Path) -> None:
    write(folder / "csv/target.py", (folder / "csv/target.py").read_text().replace("yield", "1 / 0\n    yield"))
    for targets in (("csv",), ("csv", "c")):  # in this process, in another one
        with pytest.raises(ArithmeticError, match="division by zero"):
            generate(folder, *(x for t in targets for x in ("--target", t)))
    assert not (folder.parent / "out").exists()
