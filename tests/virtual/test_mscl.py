"""MSCL, the vendor's library, against the virtual device: a client that this project has not written."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from support import BUILD, ROOT, heavy, locked, model, nightly, simulated

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


#: The models that MSCL does not support, and what it says.
FAILS = {"demod-dc": "is not supported"}
#: What a read may end with, beside the value.
NOT_READ = ("not supported", "MSCL support for Device Status (0x0C, 0x64) is not currently implemented")
READ_FAILS = {"3dm-rtk": "The CommPortSpeed command has failed"}


def used(at: str) -> subprocess.CompletedProcess[str]:
    """Tries several times: MSCL waits for an answer for less than half a second, which a busy machine may take."""
    command = [str(python_with_mscl()), str(HERE / "mscl_client.py"), at]
    for _ in range(4):
        done = subprocess.run(command, capture_output=True, text=True, timeout=100, cwd=ROOT)
        if "Failed to communicate" not in done.stdout + done.stderr:
            break
    return done


#: Models that MSCL has to read some settings of, and to stream all sets with a rate from, at both kinds of ports.
SURE = ("3dm-gx5-15", "3dm-gx5-45", "3dm-cv7-gnss-ins")
CASES = [(name, port) for name in SURE for port in ("tcp", "pty")] + [
    (name, "tcp") for name in ("3dm-gx3-25", "3dm-gx4-25")
]
REST = [
    pytest.param(d.id, "tcp", marks=nightly("MSCL, from PyPI, with every model"))
    for d in model("real").devices
    if d.model_number and d.id not in dict(CASES)
]


@pytest.mark.parametrize(("name", "port"), [*CASES, *REST])
def test_mscl(name: str, port: str, tmp_path: Path) -> None:
    """It connects, reads what it can, configures and streams each class of data that the model has a rate for."""
    path = str(tmp_path / "port")
    place = ["--tcp", "localhost:0"] if port == "tcp" else ["--pty", path]
    with simulated(*place, device=name) as found:
        done = used(found if port == "tcp" else path)
    if name in FAILS:
        assert done.returncode != 0 and FAILS[name] in done.stderr
        return
    assert done.returncode == 0, done.stderr
    result: dict[str, Any] = json.loads(done.stdout)
    device = next(d for d in model("real").devices if d.id == name)
    assert result["ping"] is True and result["model"].startswith(str(device.model_number))
    allowed = (*NOT_READ, READ_FAILS.get(name, NOT_READ[0]))
    for reads in (result["reads"], result["reads again"]):
        assert all(said == "read" or said.startswith(allowed) for said in reads.values()), reads
        assert list(reads.values()).count("read") >= 8 * (name in SURE)
    rates = {rate.set.number for rate in device.base_rates if rate.hertz}
    assert name not in SURE or rates <= {kind for kind, _, _ in result["classes"].values()}
    for kind, asked, active in result["classes"].values():
        packets, points = result["data"][str(kind)]
        assert active == asked > 0 and packets >= 2 and points >= packets * (name in SURE)
