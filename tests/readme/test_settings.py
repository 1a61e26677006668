"""docs/settings.md: its commands run as written, and a device accepts its file."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from program import mip, printed, simulated
from support import ROOT

PAGE = (ROOT / "docs/settings.md").read_text("utf-8")


def test_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first, *others = re.findall(r"^    (mip .*)$", PAGE, re.M)
    (port,) = re.findall(r"^mip simulate 3dm-cv7-gnss-ins --tcp (\d+) &$", first)
    monkeypatch.chdir(tmp_path)
    with simulated() as place:
        for command in others:
            printed(command.replace(f"localhost:{port}", place), tmp_path)
        (sample,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.S)
        file = tmp_path / "settings.yaml"
        whole = file.read_text("utf-8")
        file.write_text(sample, "utf-8")
        code, out, error = mip("config", "push", place, "settings.yaml")
        assert (code, error) == (0, "") and ": 3 settings changed, 1 as before, 0 refused" in out
        (where, text) = re.findall(r"`settings\.yaml:(\d+:\d+): (.*?'\?)`", PAGE)[0]
        file.write_text(whole.replace("receiver_1}", "receiver_9}"), "utf-8")
        code, _, error = mip("config", "push", place, "settings.yaml")
        assert (code, error) == (1, f"mip config: settings.yaml:{where}: {text}\n")


def test_the_table_of_commands() -> None:
    named = re.findall(r"^\| `mip config (\w+) ", PAGE, re.M)
    assert f"  ACTION  {', '.join(named)}\n" in re.sub(r"(?m)^  ACTION +", "  ACTION  ", mip("config", "--help")[1])
