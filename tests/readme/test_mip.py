"""docs/mip.md: its commands run as written and print what it shows, and it names every command."""

from __future__ import annotations

import re
from pathlib import Path

from program import printed, simulated
from support import ROOT

PAGE = (ROOT / "docs/mip.md").read_text("utf-8")


def section(title: str) -> str:
    found = PAGE.partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    assert found, title
    return found


def commands(title: str) -> list[str]:
    return re.findall(r"^    (mip .*)$", section(title), re.M)


def test_every_command_is_named() -> None:
    from mip_tools.__main__ import COMMANDS, EPILOG

    assert sorted(re.findall(r"^\| `([a-z]+)` \|", PAGE, re.M)) == sorted(COMMANDS)
    said = re.findall(r"\b(\d+)(?= [a-z])", EPILOG.partition("exit status:")[2])
    assert re.findall(r"^\| (\d+) \|", section("Exit status"), re.M) == said


def test_one_packet(tmp_path: Path) -> None:
    (command,) = commands("One packet explained")
    assert f"```text\n{printed(command, tmp_path)}```" in PAGE


def test_from_a_device_to_a_table(tmp_path: Path) -> None:
    first, *others = commands("From a device to a table")
    (port,) = re.findall(r"^mip simulate 3dm-cv7-gnss-ins --tcp (\d+) &$", first)
    with simulated() as place:
        other = place.rpartition(":")[2]
        shown = {command: printed(command.replace(port, other), tmp_path) for command in others}
    assert len(shown) > 9 and all(shown[c] for c in others if not re.search(r"record|-o [a-z]|cut", c))
    assert (tmp_path / "log.csv").read_text().startswith("time,time_own,sensor.scaled_accel.x [g],")
    assert 0 < (tmp_path / "part.bin").stat().st_size < (tmp_path / "log.bin").stat().st_size
