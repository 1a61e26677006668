"""The first part of the package's README: its commands and programs run unchanged, at a simulated device."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from program import ENVIRONMENT, printed, simulated
from support import SPECS

PORT = "/dev/ttyACM0"
PAGE = (SPECS["real"][1] / "python/README.md").read_text("utf-8")
FIRST = PAGE.partition("\n## Common tasks\n")[2].partition("\n## ")[0]


def section(title: str) -> tuple[list[str], str]:
    """The commands and the program of a section."""
    text = FIRST.partition(f"### {title}\n")[2].partition("\n### ")[0]
    commands, (program,) = (
        re.findall(r"^    (mip .*)$", text, re.M),
        re.findall(r"```python\n(.*?)```", text, re.S) or ("",),
    )
    return commands, program


def run(program: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> str:
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        exec(program, {"__name__": "__main__"})
    return capsys.readouterr().out


def test_it_begins_with_what_people_come_for() -> None:
    titles = ["A log to CSV", "A log to a DataFrame", "Live data", "One command", "One packet explained"]
    assert re.findall(r"^### (.*)$", FIRST, re.M) == titles
    assert re.findall(r"^## (.*)$", PAGE, re.M)[:3] == ["Install", "Common tasks", "How to import"]


def test_one_packet_explained(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (command,), program = section("One packet explained")
    assert "scaled_accel = (x=0.24452066, y=-0.0043405485, z=nan) g" in printed(command, tmp_path)
    assert run(program, tmp_path, capsys).startswith("sensor.scaled_accel: scaled_accel = (x=0.24452066")


def test_from_live_data_to_a_data_frame(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A recording of the commands under *Live data* is the log of the others."""
    with simulated() as port:
        assert re.fullmatch(r"\w+:\d+", port)

        def at_port(text: str) -> str:
            assert PORT in text
            return text.replace(PORT, port)

        commands, program = section("Live data")
        shown = [printed(at_port(c), tmp_path) for c in commands]
        assert "scaled_gyro = " in shown[3] and len(commands) == 5
        process = subprocess.Popen(
            [sys.executable, "-uc", at_port(program)], env=ENVIRONMENT, stdout=subprocess.PIPE, text=True
        )
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(3)]
        process.terminate()
        process.communicate()
        assert all(re.fullmatch(r"\d+\.\d+ -?\d+\.\d+(e-\d+)? g\n", line) for line in lines), lines

        (fields, send), program = section("One command")
        assert "descriptor" in printed(fields, tmp_path) and "3DM-CV7-GNSS/INS" in printed(at_port(send), tmp_path)
        assert run(at_port(program), tmp_path, capsys) == "3DM-CV7-GNSS/INS\n"
    (info, whole, some), program = section("A log to CSV")
    assert not program and "sensor.scaled_gyro" in printed(info, tmp_path)
    printed(whole, tmp_path)
    printed(some, tmp_path)
    rows = (tmp_path / "imu.csv").read_text().splitlines()
    assert rows[0].startswith("time,") and "scaled_gyro.z" in rows[0] and len(rows) > 50
    assert len((tmp_path / "drive.csv").read_text().splitlines()) == len(rows)
    commands, program = section("A log to a DataFrame")
    frame, mean = run(program, tmp_path, capsys).split("[8 rows x 6 columns]\n")
    assert not commands and f"{len(rows) - 1:.6f}" in frame.splitlines()[1]
    assert re.match(r"\[.* -(0\.9|1\.0)\S*\]$", mean), mean
