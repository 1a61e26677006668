"""Runs tshark with the dissector, and nothing of the user's settings."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree


def need_tshark() -> str:
    found = shutil.which("tshark")
    if found is None:
        sys.exit("tshark is missing; install it (Debian: apt-get install tshark)")
    return found


@dataclass(frozen=True)
class Shark:
    plugin: Path

    def command(self, *arguments: str) -> list[str]:
        return [need_tshark(), *arguments, "-X", f"lua_script:{self.plugin}"]

    def run(self, *arguments: str) -> str:
        """The output of tshark."""
        with tempfile.TemporaryDirectory() as home:
            done = subprocess.run(
                self.command(*arguments), capture_output=True, text=True, encoding="utf-8", env=environment(home)
            )
        assert done.returncode == 0, done.stderr
        assert "Lua" not in done.stderr, done.stderr
        return done.stdout

    def types(self) -> dict[str, str]:
        """The type of each filter of the dissector."""
        rows = (line.split("\t") for line in self.run("-G", "fields").splitlines())
        return {row[2]: row[3] for row in rows if row[0] == "F" and row[4] in ("mip_protocol", "mip_stream")}

    def trees(self, capture: Path, *arguments: str) -> Iterator[ElementTree.Element]:
        """The tree of each frame, in order."""
        with tempfile.TemporaryDirectory() as home, tempfile.TemporaryFile() as complaints:
            run = subprocess.Popen(
                self.command("-n", "-r", str(capture), "-T", "pdml", *arguments),
                stdout=subprocess.PIPE, stderr=complaints, env=environment(home),
            )  # fmt: skip
            assert run.stdout is not None
            for _, element in ElementTree.iterparse(run.stdout):
                if element.tag == "packet":
                    check(element)
                    yield element
                    element.clear()
            code = run.wait()
            complaints.seek(0)
            said = complaints.read().decode()
        assert code == 0 and "Lua" not in said, said


def check(tree: ElementTree.Element) -> None:
    error = tree.find(".//field[@name='_ws.lua.error']")
    assert error is None, error.get("showname")


def environment(home: str) -> dict[str, str]:
    return {**os.environ, "HOME": home, "XDG_CONFIG_HOME": home, "WIRESHARK_CONFIG_DIR": home, "LC_ALL": "C.UTF-8"}
