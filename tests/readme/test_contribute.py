"""docs/contribute-a-device.md: its commands run as they are, at a virtual device, and write the file that it shows."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from program import commands, programs, section
from support import PATIENCE, PYTHONPATH, ROOT, heavy, simulated

PAGE = (ROOT / "docs/contribute-a-device.md").read_text("utf-8")


@pytest.fixture
def device() -> Iterator[str]:
    with simulated("--tcp", "0", device="3dm-gx4-25") as place:
        yield place


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of the specification, with the programs in a folder of their own and a repository."""
    folder = tmp_path / "project"
    shutil.copytree(ROOT / "spec", folder / "spec")
    programs(tmp_path / "bin", mip="mip_tools", mipgen="mipgen")
    subprocess.run(["git", "init", "-q"], cwd=folder, check=True)
    return folder


def run(command: str, folder: Path) -> str:
    paths = os.pathsep.join((PYTHONPATH, str(ROOT / "generator")))
    name = {f"GIT_{who}_{what}": "a@b.example" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
    environment = {
        **os.environ, **name, "PYTHONPATH": "" if "--package" in command else paths,
        "PATH": f"{folder.parent}/bin:{os.environ['PATH']}",
    }  # fmt: skip
    if "--package" in command:
        environment["PYTHONPATH"] = str(ROOT / "tools")
    done = subprocess.run(
        ["sh", "-c", command], cwd=folder, env=environment, capture_output=True, text=True, timeout=PATIENCE
    )
    assert done.returncode == 0, (command, done.stderr)
    return done.stdout + done.stderr


def test_two_commands(device: str, project: Path) -> None:
    ask, validate = commands(PAGE.partition("\n## ")[0])
    assert ask.startswith("mip profile /dev/ttyACM0 ") and validate == "mipgen validate"
    run(ask.replace("/dev/ttyACM0", device), project)
    written = (project / "spec/devices/3dm-gx4-25.yaml").read_text("utf-8")
    (shown,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.S)
    first, last = shown.split("      # … and so on for each set\n")
    written = re.sub(r"date: \S+", "date: 2026-01-31", written)
    assert written.startswith(first) and written.endswith(last)
    assert re.search(r"; \d+ devices, ", run(validate, project))
    for command in commands(section(PAGE, "Send it")):
        run(command, project)
    listed = subprocess.run(["git", "ls-files"], cwd=project, capture_output=True, text=True, check=True).stdout
    assert "spec/devices/3dm-gx4-25.yaml" in listed


@heavy("commands of pages that build or run for long")
def test_used_right_away(device: str, project: Path) -> None:
    folder, ask, generate, simulate = commands(section(PAGE, "Use it right away"))
    for command in (folder, ask.replace("/dev/ttyACM0", device), generate):
        run(command, project)
    said = run(simulate, project)
    fields = (project / "mine/devices/3dm-gx4-25.yaml").read_text("utf-8").partition("fields:")[2]
    number = len(re.findall(r"[a-z_0-9]+(?=[],])", fields.partition("base_rates")[0]))
    assert f"3DM-GX4-25: {number} commands and data fields are certain, 0 likely, 0 assumed\n" in said
