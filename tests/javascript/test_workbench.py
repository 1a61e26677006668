"""How the workbench is built: from any package, in one script, and nothing of it is committed twice."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from mipgen.targets.markdown.tools import TOOLS
from support import ROOT, SPECS, need, small, uses
from workbench import BUILD, workbench

SOURCES = ROOT / "tools/workbench"
specs = pytest.mark.parametrize("spec", sorted(SPECS))
with_node = uses("node")


def build(*arguments: str | Path, script: Path = BUILD) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-S", script, *arguments]  # no package but the standard library
    return subprocess.run(command, capture_output=True, text=True, check=False)


@small("pages of the real workbench")
@with_node
def test_unit(spec: str) -> None:
    environment = {"FOLDER": str(SPECS[spec][1] / "javascript"), "WORKBENCH": str(workbench(spec))}
    command = [need("node"), "--test", ROOT / "tests/javascript/workbench.test.mjs"]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **environment}, check=False)
    assert done.returncode == 0 and "# pass 0" not in done.stdout, done.stdout[-4000:] + done.stderr[-4000:]


@specs
def test_what_is_built(spec: str, tmp_path: Path) -> None:
    """A page for each tool of the reference, under the same title; the same bytes each time."""
    folder = tmp_path / "workbench"
    done = build(SPECS[spec][1] / "javascript", folder)
    pages = sorted(folder / f"{tool.name}.html" for tool in TOOLS)
    assert (done.returncode, done.stdout.splitlines()) == (0, list(map(str, pages))), done.stderr
    for tool in TOOLS:
        page = (folder / f"{tool.name}.html").read_text("utf-8")
        assert f"<title>{tool.title}</title>" in page and f"<h1>{tool.title}</h1>" in page
    names = sorted(path.name for path in folder.iterdir())
    assert names == sorted([*(path.name for path in pages), "fields.js", "page.css", "tools.css", "workbench.js"])
    assert all((folder / name).read_bytes() == (workbench(spec) / name).read_bytes() for name in names)


def test_a_folder_that_is_no_package(tmp_path: Path) -> None:
    done = build(tmp_path, tmp_path / "out")
    assert done.returncode == 1 and not (tmp_path / "out").exists()
    assert done.stderr == f"build.py: {tmp_path} has no package.json; generate the target javascript first\n"


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        (
            "import './dom.mjs';",
            "finder.mjs:3: error: a statement that cannot be bundled: import './dom.mjs';",
        ),
        ("export let last = 0;", "finder.mjs:3: error: a statement that cannot be bundled: export let last = 0;"),
        ('import { a } from "left-pad";', "finder.mjs: error: left-pad is not in the codec at "),
        ('import { a } from "mip-protocol/other";', "finder.mjs: error: mip-protocol/other is not in the codec at "),
        ('import { a } from "./gone.mjs";', "gone.mjs is missing"),
        ('import { a } from "./index.mjs";', "index.mjs imports itself through "),
    ],
)
def test_what_cannot_be_bundled(statement: str, said: str, tmp_path: Path) -> None:
    copy = tmp_path / "workbench"
    shutil.copytree(SOURCES, copy)
    changed = copy / "finder.mjs"
    first, _, rest = changed.read_text("utf-8").partition("\n\n")
    changed.write_text(f"{first}\n\n{statement}\n{rest}", "utf-8")
    done = build(SPECS["real"][1] / "javascript", tmp_path / "out", script=copy / "build.py")
    assert done.returncode == 1 and said in done.stderr, done.stderr
