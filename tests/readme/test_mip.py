"""docs/mip.md: its commands run as written and print what it shows, and it names every command."""

from __future__ import annotations

import os
import re
import shlex
import signal
import socket
import subprocess
import sys
from pathlib import Path

from support import PATIENCE, PYTHONPATH, ROOT

PAGE = (ROOT / "docs/mip.md").read_text("utf-8")


def section(title: str) -> str:
    found = PAGE.partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    assert found, title
    return found


def commands(title: str) -> list[str]:
    return re.findall(r"^    (mip .*)$", section(title), re.M)


def shell(command: str, folder: Path) -> str:
    environment = {**os.environ, "PYTHONPATH": PYTHONPATH}
    words = re.sub(r"(^|\| )mip ", rf"\1{shlex.quote(sys.executable)} -m mip_tools ", command)
    done = subprocess.run(["sh", "-c", words], cwd=folder, env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, ""), command
    return done.stdout


def test_every_command_is_named() -> None:
    from mip_tools.__main__ import COMMANDS, EPILOG

    assert sorted(re.findall(r"^\| `([a-z]+)` \|", PAGE, re.M)) == sorted(COMMANDS)
    said = re.findall(r"\b(\d+)(?= [a-z])", EPILOG.partition("exit status:")[2])
    assert re.findall(r"^\| (\d+) \|", section("Exit status"), re.M) == said


def test_one_packet(tmp_path: Path) -> None:
    (command,) = commands("One packet explained")
    assert f"```text\n{shell(command, tmp_path)}```" in PAGE


def test_from_a_device_to_a_table(tmp_path: Path) -> None:
    first, *others = commands("From a device to a table")
    (port,) = re.findall(r"--tcp (\d+) &", first)
    with socket.create_server(("127.0.0.1", 0)) as free:
        other = str(free.getsockname()[1])
    words = shlex.split(first.replace(port, other).rstrip("& "))[1:]
    environment = {**os.environ, "PYTHONPATH": PYTHONPATH}
    device = subprocess.Popen([sys.executable, "-m", "mip_tools", *words], env=environment, stdout=subprocess.PIPE)
    try:
        assert device.stdout is not None and device.stdout.readline()
        printed = {command: shell(command.replace(port, other), tmp_path) for command in others}
    finally:
        device.send_signal(signal.SIGINT)
        device.communicate(timeout=PATIENCE)
    assert len(printed) > 9 and all(printed[c] for c in others if not re.search(r"record|-o [a-z]|cut", c))
    assert (tmp_path / "log.csv").read_text().startswith("time,time_own,sensor.scaled_accel.x [g],")
    assert 0 < (tmp_path / "part.bin").stat().st_size < (tmp_path / "log.bin").stat().st_size
