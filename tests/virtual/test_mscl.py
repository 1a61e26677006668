"""MSCL, the vendor's library, against the virtual device: a client that this project has not written."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from support import BUILD, ROOT, heavy, locked, model
from virtual.test_live import simulated

pytestmark = heavy("MSCL, from PyPI")

HERE = Path(__file__).parent
PINNED = HERE / "mscl.txt"


def python_with_mscl() -> Path:
    """An environment with the pinned wheel."""
    folder = BUILD / "mscl"
    with locked(folder):
        mark = folder / "installed.txt"
        if not mark.exists() or mark.read_bytes() != PINNED.read_bytes():
            shutil.rmtree(folder, ignore_errors=True)
            subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
            pip = [str(folder / "bin/python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
            subprocess.run([*pip, "--require-hashes", "--only-binary", ":all:", "-r", str(PINNED)], check=True)
            shutil.copy(PINNED, mark)
    return folder / "bin/python"


@pytest.mark.parametrize("port", ["tcp", "pty"])
@pytest.mark.parametrize("name", ["3dm-gx5-15", "3dm-gx5-45", "3dm-cv7-gnss-ins"])
def test_mscl(name: str, port: str, tmp_path: Path) -> None:
    path = str(tmp_path / "port")
    place = ["--tcp", "localhost:0"] if port == "tcp" else ["--pty", path]
    with simulated(*place, device=name) as found:
        at = found if port == "tcp" else path
        command = [str(python_with_mscl()), str(HERE / "mscl_client.py"), at]
        done = subprocess.run(command, capture_output=True, text=True, timeout=100, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    result: dict[str, Any] = json.loads(done.stdout)
    device = next(d for d in model("real").devices if d.id == name)
    assert result["ping"] is True
    assert result["model"].startswith(str(device.model_number))
    for reads in (result["reads"], result["reads again"]):
        assert set(reads.values()) <= {"read", "not supported"}
        assert list(reads.values()).count("read") >= 8
    assert {rate.set.number for rate in device.base_rates if rate.hertz} <= {
        kind for kind, _, _ in result["classes"].values()
    }
    for kind, asked, active in result["classes"].values():
        packets, points = result["data"][str(kind)]
        assert active == asked > 0
        assert packets >= 2 and points >= packets
