"""The JavaScript modules, in Node."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from support import ROOT, SPECS, heavy, need

pytestmark = [] if shutil.which("node") else heavy("node")
specs = pytest.mark.parametrize("spec", sorted(SPECS))
GENERATED = ROOT / "generated/javascript"


def node(*arguments: str | Path, **environment: str) -> str:
    done = subprocess.run(
        [need("node"), *map(str, arguments)], capture_output=True, text=True, env={**os.environ, **environment}
    )
    assert done.returncode == 0, done.stdout[-4000:] + done.stderr[-4000:]
    return done.stdout


@specs
def test_unit(spec: str) -> None:
    said = node("--test", ROOT / "tests/javascript/unit.test.mjs", FOLDER=str(SPECS[spec][1] / "javascript"))
    assert int(re.findall(r"^# pass (\d+)", said, re.M)[0]) > 0


def test_the_quickstart_runs() -> None:
    quickstart = (GENERATED / "quickstart.mjs").read_text("utf-8")
    assert f"```javascript\n{quickstart}```" in (GENERATED / "README.md").read_text("utf-8")
    assert node(GENERATED / "quickstart.mjs") == "75 65 01 02 02 03 e2 c8\n0.2445 g along x\n"


@specs
def test_every_file_is_javascript(spec: str) -> None:
    paths = sorted((SPECS[spec][1] / "javascript").rglob("*.mjs"))
    assert len(paths) > 5
    for path in paths:
        node("--check", path)


def test_every_export_is_in_the_readme() -> None:
    readme = (GENERATED / "README.md").read_text("utf-8")
    index = (GENERATED / "mip/index.mjs").read_text("utf-8")
    names = {name.strip() for inner in re.findall(r"export \{([^}]*)\}", index) for name in inner.split(",")}
    assert len(names) > 10
    for name in names:
        assert re.search(rf"\b{name}\b", readme), name


def test_the_package_exports_what_the_readme_names(tmp_path: Path) -> None:
    """For programs that find modules by the name of the package."""
    package = tmp_path / "node_modules/mip-protocol"
    package.parent.mkdir()
    package.symlink_to(GENERATED)
    program = tmp_path / "use.mjs"
    program.write_text(
        "import { Protocol } from 'mip-protocol'; import model from 'mip-protocol/model';"
        " console.log(new Protocol(model).field('base.ping').title);",
        "utf-8",
    )
    assert node(program) == "Ping\n"
