"""The commands of docs/wireshark.md print what the page says, in a home without settings."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

from support import ROOT, heavy, need

pytestmark = heavy("tshark")

PAGE = (ROOT / "docs/wireshark.md").read_text("utf-8")


def words(text: str) -> list[str]:
    """Lines without the spaces of columns."""
    return [" ".join(line.split()) for line in text.splitlines() if line.strip()]


def test_the_commands_print_what_the_page_says(tmp_path: Path) -> None:
    for tool in ("tshark", "text2pcap", "od", "sed"):
        need(tool)
    shutil.copytree(ROOT / "generated/wireshark", tmp_path / "generated/wireshark")
    environment = {
        **os.environ,
        "HOME": str(tmp_path),
        "XDG_CONFIG_HOME": str(tmp_path / ".config"),
        "LC_ALL": "C.UTF-8",
    }
    blocks = re.findall(r"```(sh|text)\n(.*?)```", PAGE, re.S)
    assert [kind for kind, _ in blocks].count("text") == len(blocks) // 2
    printed: list[str] = []
    for kind, text in blocks:
        if kind == "sh":
            done = subprocess.run(
                ["sh", "-e"], input=text, capture_output=True, text=True, cwd=tmp_path, env=environment
            )
            assert done.returncode == 0, text + done.stderr
            printed = words(done.stdout)
        else:
            assert printed == words(text)


def test_the_page_names_what_is_generated() -> None:
    for path in re.findall(r"\]\(\.\./([^)]*)\)", PAGE):
        assert (ROOT / path).is_file(), path
