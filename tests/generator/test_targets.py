"""Properties of all targets: determinism, no needless writes, stale files, a new language."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import golden
import pytest
from mipgen import cli
from mipgen.base import resources
from mipgen.emit import discovery, output
from support import ROOT, SPECS, all_fields, heavy, model, parse_as, tree

SPEC = ("--spec", "tests/invented/spec")
OUTPUT = SPECS["invented"][1]


@heavy("a run in other surroundings")
def test_the_same_from_anywhere(tmp_path: Path) -> None:
    """Another folder, home, locale, hash seed and time zone; a copy of the project in another place."""
    copy = tmp_path / "copy"
    for part in ("generator", "templates", "runtime", "examples", "docs/parts", "spec/schema", "tests/invented/spec"):
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
    command = [sys.executable, "-m", "mipgen", "generate", "--spec", copy / SPEC[1], "--out", tmp_path / "out"]
    environment = os.environ | strange | {"PYTHONPATH": str(copy / "generator")}
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert done.returncode == 0, done.stderr
    assert tree(tmp_path / "out") == tree(OUTPUT)


def test_the_syntax_of_the_oldest_python() -> None:
    """What it accepts, newer ones accept."""
    parse_as("3.10", ROOT / "generator/mipgen")


def test_the_snapshot_is_what_the_invented_specification_gives(tmp_path: Path) -> None:
    """`make check` compares the output for the real one."""
    made = golden.snapshot()
    assert golden.differences(made) == []
    golden.write({**made, "c/old.h": b"stale"}, tmp_path)
    del made["markdown/docs/fields/measurements/arrays.md"]
    made["javascript/measurements.mjs"] += b"\n"
    made["c/new.h"] = b"missing"
    made[golden.DIGESTS] = made[golden.DIGESTS].replace(b"  json\n", b"  new\n")
    made[golden.DIGESTS] = b"x" + made[golden.DIGESTS][1:]
    assert golden.differences(made, tmp_path) == [
        f"{tmp_path}/{path}: error: {state}"
        for path, state in (
            ("c", "changed"), ("c/new.h", "missing"), ("c/old.h", "stale"), ("javascript/measurements.mjs", "changed"),
            ("json", "stale"), ("markdown/docs/fields/measurements/arrays.md", "stale"), ("new", "missing"),
        )
    ]  # fmt: skip
    golden.write(made, tmp_path)
    assert golden.differences(made, tmp_path) == []


def test_generated_text_says_nothing_of_the_machine() -> None:
    for name, data in tree(OUTPUT).items():
        text = data.decode("utf-8")
        assert "\r" not in text, name
        assert str(Path.home()) not in text and str(ROOT) not in text, name


def test_every_folder_stands_alone() -> None:
    for name in discovery.target_names():
        folder = OUTPUT / name
        assert (folder / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
        assert (folder / "README.md").is_file()
        listed = output.manifest(p for p in tree(folder) if p != resources.MANIFEST)
        assert (folder / resources.MANIFEST).read_bytes() == listed


def test_command_line_names_what_is_wrong(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert cli.main(["validate", "--spec", str(tmp_path)]) == 1
    assert "protocol.yaml is missing" in capsys.readouterr().err
    assert cli.main(["generate", "--spec", str(SPECS["real"][0]), "--target", "cobol"]) == 1
    assert f"unknown target 'cobol'; known: {', '.join(discovery.target_names())}" in capsys.readouterr().err


# --------------------------------------------------------------------------- counts, derived and held together


def test_counts_agree() -> None:
    """Each field of the specification is a type in each language and a section in the reference."""
    of = model("real")

    def count(pattern: str, folder: str, files: str) -> int:
        texts = (p.read_text("utf-8") for p in sorted((SPECS["real"][1] / folder).rglob(files)))
        return sum(len(re.findall(pattern, text, re.M)) for text in texts)

    each = len(all_fields(of))  # the acknowledge field, too
    assert count(r"^    DESCRIPTOR = .*\n    NAME = \"\w+\.", "python", "*.py") == each
    assert count(r"^MIP_FIELD\(mip_\w+, ", "c/src/mip", "*.h") == each
    assert count(r"^MIP_CODEC\(mip_\w+, ", "c/src/mip", "*.c") == each
    assert count(r"^field! \{", "rust/src/", "*.rs") == each
    assert count(r"^    -orig-id: ", "kaitai", "mip.ksy") == each
    assert count(r"^\{\"set\":", "json", "mip.json") == each
    anchors = "|".join(re.escape(f'<a id="{f.full_name}">') for f in all_fields(of))
    assert count(anchors, "markdown/docs", "*.md") == len(all_fields(of)) == each
