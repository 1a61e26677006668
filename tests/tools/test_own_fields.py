"""Fields of one's own, which an overlay adds, in the tools."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from mipgen import cli
from packages import real
from support import PYTHONPATH, ROOT, SPECS


@pytest.fixture(scope="module")
def overlaid(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The Python package of the specification with an overlay."""
    folder = tmp_path_factory.mktemp("overlay")
    words = ["--spec", str(SPECS["real"][0]), "--spec", str(ROOT / "tests/overlay"), "--target", "python"]
    assert cli.main(["generate", *words, "--out", str(folder)]) == 0
    return folder / "python"


ENVIRONMENT = {k: v for k, v in os.environ.items() if k != "MIP_PACKAGE"} | {"PYTHONPATH": PYTHONPATH}


def tool(*words: object, data: bytes = b"", **environment: str) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, "-m", "mip_tools", *map(str, words)], input=data, capture_output=True,
        env=ENVIRONMENT | environment,
    )  # fmt: skip
    return done.returncode, done.stdout.decode(), done.stderr.decode()


LIGHT = struct.pack(">4fB", 250.0, 0.5, 0.25, 0.125, 1)


def log(packets: int = 3) -> bytes:
    """Packets with a field of the overlay, and one of the specification."""
    builder = real.packet.PacketBuilder(0x80).add(0x7A, LIGHT).add(0x04, struct.pack(">3f", 1, 2, 3))
    return bytes(builder.build()) * packets


def test_an_own_field_in_dump_export_and_columns(overlaid: Path, tmp_path: Path) -> None:
    code, out, error = tool("dump", "--package", overlaid, "-", data=log(1))
    assert (code, error) == (0, "") and "illuminance=250.0 lx" in out and "lamp=on" in out
    file = tmp_path / "log.bin"
    file.write_bytes(log())
    words = ("export", file, "ambient_light", "scaled_accel", "-o", "-")
    code, out, error = tool(*words, MIP_PACKAGE=str(overlaid))
    assert code == 0 and error.endswith("no date: no timestamps; add one to the message format\n")
    heading, *rows = out.splitlines()
    assert "sensor.ambient_light.bend.x [rad]" in heading and len(rows) == 3 and "250.0,0.5,0.25,0.125" in rows[0]
    code = f"import mip_tools; mip_tools.use({str(overlaid)!r}); log = mip_tools.read_log({str(file)!r})\n"
    code += "print(log['sensor.ambient_light']['illuminance'].tolist(), log['sensor.scaled_accel']['scaled_accel'][0])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=ENVIRONMENT)
    assert (done.stdout, done.stderr) == ("[250.0, 250.0, 250.0] [1. 2. 3.]\n", "")


def test_an_own_command_is_sent_to_a_virtual_device(overlaid: Path) -> None:
    words = ["simulate", "3dm-cv7-gnss-ins", "--tcp", "0", "--package", overlaid]
    with subprocess.Popen(
        [sys.executable, "-m", "mip_tools", *map(str, words)], stdout=subprocess.PIPE, env=ENVIRONMENT
    ) as process:
        assert process.stdout is not None
        place = process.stdout.readline().decode().strip()
        for words, said in (["write", "state=on"], ""), (["read"], "state = on"):
            code, out, error = tool("send", place, "payload.lamp", *words, "--package", overlaid)
            assert (code, error) == (0, "") and said in out
        process.kill()
