"""The crate `microstrain-inertial`, of others, against the virtual device: a ping, a message format, and data."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from support import BUILD, heavy, locked, model, need, nightly, simulated
from virtual.commands import commands

pytestmark = heavy("the crate microstrain-inertial, from crates.io")

HERE = Path(__file__).parent / "crate"

#: One model of each generation.
MODELS = ("3dm-gx3-25", "3dm-gx4-25", "3dm-gx5-45", "3dm-cv7-gnss-ins")
REST = [
    pytest.param(d.id, marks=nightly("the crate microstrain-inertial, with every model"))
    for d in model("real").devices
    if commands(d) and d.id not in MODELS
]


def peer() -> Path:
    folder = BUILD / "crate"
    with locked(folder):
        shutil.copytree(HERE, folder, dirs_exist_ok=True)
        flags = {**os.environ, "CARGO_TARGET_DIR": str(folder / "target")}
        subprocess.run([need("cargo"), "build", "--quiet"], cwd=folder, env=flags, check=True)
    return folder / "target/debug/peer"


@pytest.mark.parametrize("name", [*MODELS, *REST])
def test_it_reads_data(name: str, tmp_path: Path) -> None:
    """It takes no answer for a rejection: from models without its command for the format, only the ping is answered."""
    program, path = peer(), str(tmp_path / "port")
    with simulated("--pty", path, device=name):
        done = subprocess.run([str(program), path], capture_output=True, text=True, timeout=100)
    first, *lines = done.stdout.splitlines()
    assert first == "Ack", done.stderr
    device = next(d for d in model("real").devices if d.id == name)
    has_format = any(s.field.full_name == "3dm.message_format" for s in device.supports)
    assert (done.returncode == 0) == has_format, done.stderr
    at_rest = [line for line in lines if re.fullmatch(r"accel .* z: -(?:0\.9|1\.0)\d+ }", line)]
    assert len(at_rest) == 10 * has_format
    assert sum(line.startswith("gyro ") for line in lines) == 10 * has_format
