"""The page where people begin: its commands and its programs, in an empty folder, on a virtual device."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from c_build import run
from mipgen.targets.markdown.start import STARTS, Start
from reference import manual_of
from support import ROOT, need, packaging, simulated

VALUES = re.compile(r"\s*-?\d+\.\d+\s+-?\d+\.\d+\s+-(?:0\.9|1\.0)\d+ g")


def section(start: Start) -> dict[str, list[str]]:
    """The fenced blocks of a language, by what they are in."""
    page = manual_of("real").pages["docs/start.md"]
    text = page.partition(f'<a id="start.{start.name}"></a>')[2].partition("\n<a id=")[0]
    found: dict[str, list[str]] = {}
    for language, block in re.findall(r"```(\w+)\n(.*?)```", text, re.S):
        found.setdefault(language, []).append(block)
    return found


@pytest.fixture
def device() -> Iterator[str]:
    """A virtual device, started as the page says, at another port; HOST:PORT."""
    page = manual_of("real").pages["docs/start.md"]
    name, *options = re.findall(r"^mip simulate (.*) 5005$", page, re.M)[0].split()
    with simulated(*options, "0", device=name) as place:
        yield place


def first_lines(count: int, command: str, folder: Path, environment: dict[str, str]) -> list[str]:
    """What a program prints first, which would go on."""
    words = ["sh", "-ec", f"exec {command}"]
    with subprocess.Popen(words, cwd=folder, env=environment, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        lines = [running.stdout.readline() for _ in range(count)]
        running.kill()
    return lines


@pytest.mark.parametrize(
    "start",
    [pytest.param(x, id=x.name, marks=() if x.name == "python" else packaging) for x in STARTS],
)
def test_get_started(start: Start, device: str, tmp_path: Path) -> None:
    """Install, save, run: the program prints the model and values of a device at rest."""
    need({"c": "cc", "cpp": "c++", "rust": "cargo", "javascript": "npm"}.get(start.name, "python3"))
    folder = tmp_path / "empty"
    folder.mkdir()
    (tmp_path / "mipgen").symlink_to(ROOT)
    blocks = section(start)
    (program,) = blocks[start.name]
    install, launch = blocks["sh"]
    environment = {**os.environ, "CARGO_NET_OFFLINE": "true"}
    if start.name == "python":  # what is installed is the folder; pip itself is tested with the package
        environment["PYTHONPATH"] = f"{ROOT}/generated/python"
        launch = launch.replace("python ", f"{sys.executable} -u ", 1)
    else:
        run("sh", "-ec", install, cwd=folder, **environment)
    place = folder / start.file
    place.parent.mkdir(exist_ok=True)
    place.write_text(program)
    *build, last = launch.replace("localhost:5005", device).strip().splitlines()
    for command in build:
        run("sh", "-ec", command, cwd=folder, **environment)
    lines = first_lines(4, last, folder, environment)
    assert lines[0].strip().endswith("3DM-CV7-GNSS/INS"), lines
    assert all(VALUES.search(line) for line in lines[1:]), lines
    for name, said in (("command", "acknowledged"), ("data", "0.99|1.00|12 bytes")):
        whole_program(start.name, name, said, folder, environment, device)


#: How a program of "complete programs" is built and run beside the first one.
WHOLE = {
    "python": ("whole.py", "", f"{sys.executable} -u whole.py"),
    "c": ("whole.c", "cc -std=c99 -Wall -Wextra -Werror -Imip/src -Imip/ports -c whole.c", ""),
    "cpp": (
        "whole.cpp",
        "c++ -std=c++17 -Wall -Wextra -Werror -Imip/src -Imip/ports whole.cpp *.o -o whole",
        "./whole",
    ),
    "rust": ("src/bin/whole.rs", "cargo build --quiet --bin whole", "target/debug/whole"),
    "javascript": ("whole.mjs", "", "node whole.mjs"),
}


def whole_program(language: str, kind: str, said: str, folder: Path, environment: dict[str, str], device: str) -> None:
    """One of the complete programs; that in C is compiled only, as its library is not kept."""
    text = manual_of("real").pages["docs/programs.md"].partition(f'<a id="programs.{kind}"></a>')[2]
    (program,) = re.findall(rf"^```{language}\n(.*?)^```$", text.partition("<a id")[0], re.M | re.S)
    name, build, launch = WHOLE[language]
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text(program)
    run("sh", "-ec", build, cwd=folder, **environment)
    if not launch:
        return
    place = f"tcp:{device}" if language == "rust" else device
    (line,) = first_lines(1, f"{launch} {place} 2>&1", folder, environment)
    assert re.search(said, line), (language, kind, line)
