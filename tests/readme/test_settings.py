"""docs/settings.md: its commands run as written, and a device accepts its file."""

from __future__ import annotations

import os
import re
import shlex
import socket
import subprocess
import sys
from pathlib import Path

from support import PYTHONPATH, ROOT

PAGE = (ROOT / "docs/settings.md").read_text("utf-8")
ENVIRONMENT = {**os.environ, "PYTHONPATH": PYTHONPATH}


def mip(command: str, folder: Path) -> tuple[int, str, str]:
    words = re.sub(r"^mip ", rf"{shlex.quote(sys.executable)} -m mip_tools ", command)
    done = subprocess.run(["sh", "-c", words], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def test_the_page(tmp_path: Path) -> None:
    first, *others = re.findall(r"^    (mip .*)$", PAGE, re.M)
    (port,) = re.findall(r"--tcp (\d+) &", first)
    with socket.create_server(("127.0.0.1", 0)) as free:
        other = str(free.getsockname()[1])
    words = shlex.split(first.replace(port, other).rstrip("& "))[1:]
    device = subprocess.Popen([sys.executable, "-m", "mip_tools", *words], env=ENVIRONMENT, stdout=subprocess.PIPE)
    try:
        assert device.stdout is not None and device.stdout.readline()
        for command in others:
            code, _, error = mip(command.replace(port, other), tmp_path)
            assert (code, error) == (0, ""), command
        (sample,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.S)
        whole = (tmp_path / "settings.yaml").read_text("utf-8")
        (tmp_path / "settings.yaml").write_text(sample, "utf-8")
        code, out, error = mip(f"mip config push localhost:{other} settings.yaml", tmp_path)
        assert (code, error) == (0, "") and ": 3 settings changed, 1 as before, 0 refused" in out
        (place, text) = re.findall(r"`settings\.yaml:(\d+:\d+): (.*?'\?)`", PAGE)[0]
        (tmp_path / "settings.yaml").write_text(whole.replace("receiver_1}", "receiver_9}"), "utf-8")
        code, _, error = mip(f"mip config push localhost:{other} settings.yaml", tmp_path)
        assert (code, error) == (1, f"mip config: settings.yaml:{place}: {text}\n")
    finally:
        device.kill()
        device.communicate()


def test_the_table_of_commands(tmp_path: Path) -> None:
    named = re.findall(r"^\| `mip config (\w+) ", PAGE, re.M)
    assert f"  ACTION  {', '.join(named)}\n" in re.sub(
        r"(?m)^  ACTION +", "  ACTION  ", mip("mip config --help", tmp_path)[1]
    )
