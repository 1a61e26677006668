"""How the workbench is built: from any package, in one script, and nothing of it is committed twice."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from mipgen.targets.markdown.tools import TOOLS
from support import ROOT, SPECS, need, small, uses
from workbench import bundled, workbench

pytestmark = uses("npm")


@small("pages of the real workbench")
def test_unit(spec: str) -> None:
    environment = {"FOLDER": str(SPECS[spec][1] / "javascript"), "WORKBENCH": str(workbench(spec))}
    command = [need("node"), "--test", ROOT / "tests/javascript/workbench.test.mjs"]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **environment}, check=False)
    assert done.returncode == 0 and "# pass 0" not in done.stdout, done.stdout[-4000:] + done.stderr[-4000:]


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_what_is_built(spec: str, tmp_path: Path) -> None:
    """A page for each tool of the reference, under the same title; the same bytes each time."""
    folder = tmp_path / "workbench"
    done = bundled(SPECS[spec][1] / "javascript", folder)
    assert done.returncode == 0, done.stderr
    for tool in TOOLS:
        page = (folder / f"{tool.name}.html").read_text("utf-8")
        assert f"<title>{tool.title}</title>" in page and f"<h1>{tool.title}</h1>" in page
    names = sorted(path.name for path in folder.iterdir())
    pages, others = (f"{tool.name}.html" for tool in TOOLS), ("fields.js", "page.css", "tools.css", "workbench.js")
    assert names == sorted([*pages, *others])
    assert all((folder / name).read_bytes() == (workbench(spec) / name).read_bytes() for name in names)


def test_a_folder_that_is_no_package(tmp_path: Path) -> None:
    done = bundled(tmp_path, tmp_path / "out")
    assert done.returncode == 1 and not (tmp_path / "out").exists()
    assert done.stderr == f"bundle.mjs: {tmp_path}/package.json is missing; generate the target javascript first\n"
