"""docs/simulate.md and its reference: commands run as written, tables of motions and faults are complete."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from mip_simulator.faults.kinds import CHANCES, KINDS
from mip_simulator.motion import MOTIONS
from program import blocks, commands, mip, programs, section
from support import PATIENCE, PYTHONPATH, ROOT, heavy, need

PAGE, REFERENCE = ((ROOT / f"docs/{name}.md").read_text("utf-8") for name in ("simulate", "simulate-reference"))


@pytest.fixture
def shell(tmp_path: Path) -> Iterator[dict[str, str]]:
    """An environment with `mip`, `python` and `cc`; and a folder with the files that the page names."""
    tools = programs(tmp_path / "bin", mip="mip_tools", python="")
    (tools / "cc").symlink_to(need("cc"))
    for name in ("docs", "generated", "tools"):
        (tmp_path / name).symlink_to(ROOT / name)
    yield {
        **os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "PYTHONPATH": PYTHONPATH,
    }  # fmt: skip


def run(command: str, folder: Path, environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["sh", "-c", command], cwd=folder, env=environment, capture_output=True, text=True, timeout=PATIENCE
    )


@contextmanager
def device(
    command: str, folder: Path, environment: dict[str, str], ends: bool = False
) -> Iterator[subprocess.Popen[str]]:
    """Runs a command until it is interrupted or ends by itself; returns when it has printed where the device is."""
    process = subprocess.Popen(
        ["sh", "-c", f"exec {command}"], cwd=folder, env=environment, stdout=subprocess.PIPE, text=True
    )
    try:
        assert process.stdout is not None and process.stdout.readline().strip(), command
        yield process
    finally:
        if not ends:
            process.terminate()
        process.communicate(timeout=PATIENCE)
    assert process.returncode == 0


def test_the_c_program_is_exemplary() -> None:
    """It compiles without warnings, as strictly as the binding itself, and is formatted in the same way."""
    source = ROOT / "generated/c/examples/stream.c"
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-fsyntax-only"]
    folders = [f"-I{ROOT}/generated/c/{folder}" for folder in ("src", "ports")]
    subprocess.run([need("cc"), *strict, *folders, str(source)], check=True)
    style = f"--style=file:{ROOT}/generated/c/.clang-format"
    subprocess.run([need("clang-format"), style, "--dry-run", "-Werror", str(source)], check=True)


@heavy("commands of pages that build or run for long")
def test_a_c_client_without_a_device(tmp_path: Path, shell: dict[str, str]) -> None:
    start, build, client = commands(section(PAGE, "Develop a C firmware client without a device"))
    put = f"{tmp_path}/terminal"
    start, client = start.replace("/tmp/mip", put), client.replace("/tmp/mip", put)
    built = run(build, tmp_path, shell)
    assert built.returncode == 0 and not built.stderr, built.stderr
    lost = run(client, tmp_path, shell)
    assert lost.returncode == 1 and lost.stderr.startswith(put)  # no device yet
    for more in ("", " --fault lose_answer@2"):
        with device(f"{start} --duration 3{more}", tmp_path, shell, ends=True):
            done = run(client, tmp_path, shell)
            assert (done.returncode, done.stderr) == (0, "")
        first, *lines = done.stdout.splitlines()
        assert re.fullmatch(r"3DM-CV7-GNSS/INS *", first), first
        assert len(lines) > 50
        for line in lines:
            along, across, down = map(float, line.partition(": ")[2].removesuffix(" g").split())
            assert abs(along) < 0.02 and abs(across - 5**2 / 20 / 9.80665) < 0.02 and abs(down + 1) < 0.02


def free_port() -> str:
    with socket.create_server(("127.0.0.1", 0)) as found:
        return str(found.getsockname()[1])


@heavy("commands of pages that build or run for long")
def test_a_parser_against_faults(tmp_path: Path, shell: dict[str, str]) -> None:
    start, check = commands(section(PAGE, "Test your own parser against faults"))
    number = free_port()
    start, check = start.replace("5000", number), check.replace("5000", number)
    with device(start, tmp_path, shell, ends=True):
        done = run(check, tmp_path, shell)
    assert (done.returncode, done.stderr) == (0, "")
    sent, damaged, lost, invented = map(int, re.findall(r"\b\d+\b", done.stdout))
    assert sent > 5000 and 100 < damaged < sent // 10 and (lost, invented) == (0, 0)

    bad = "class Parser(Parser):\n    def feed(self, data):\n        return super().feed(data)[1:]\n"
    program = (ROOT / "docs/simulate/check_parser.py").read_text("utf-8")
    (tmp_path / "bad.py").write_text(program.replace("\nconnection = ", f"\n{bad}\nconnection = "))
    with device(start.replace("--duration 60", "--duration 5"), tmp_path, shell, ends=True):
        done = run(check.replace("docs/simulate/check_parser.py", "bad.py"), tmp_path, shell)
    assert done.returncode == 1 and ", 0 packets found that were never sent" in done.stdout


def test_the_first_command(tmp_path: Path, shell: dict[str, str]) -> None:
    (command,) = re.findall(r"^    (mip simulate .*--pty .*)$", PAGE.partition("\n## ")[0], re.M)
    with device(command.replace("/tmp/mip", f"{tmp_path}/terminal"), tmp_path, shell):
        assert (tmp_path / "terminal").is_symlink()
    assert not (tmp_path / "terminal").is_symlink()
    listed = re.findall(r"^    (mip \w+ --\w+)", PAGE, re.M)
    assert len(listed) == 2 and all(run(c, tmp_path, shell).returncode == 0 for c in listed)


def test_in_python() -> None:
    for program in blocks(section(PAGE, "In Python"), "python"):
        environment = {"PYTHONPATH": PYTHONPATH}
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=environment)
        assert done.returncode == 0, done.stderr


def test_every_fault_and_option_is_named() -> None:
    wanted = []
    for chance, text in CHANCES.items():
        wanted.append(f"| | **for each {text}** | |")
        for name, k in KINDS.items():
            amount = f"{k.amount:g} {k.unit}" if k.unit else ""
            wanted += [f"| `{name}` | {k.description} | {amount} |"] * (k.of == chance)
    rows = section(REFERENCE, "Faults").partition("|---|---|---|\n")[2].partition("\n\n")[0]
    assert rows.splitlines() == wanted
    text = mip("simulate", "--help")[1]
    known = {
        name
        for line in re.findall(r"^  (--.*)", text, re.M)
        for name in re.findall(r"^--[a-z-]+|(?<=, )--[a-z-]+", line)
    }
    named = set(re.findall(r"(--[a-z-]+)", re.sub(r"```.*?```", "", REFERENCE, flags=re.S)))
    assert "--pty" in known and named - {"--help", "---"} == known


def test_every_motion_is_named() -> None:
    table = section(REFERENCE, "Motion").partition("| Columns |")[0]
    rows = re.findall(r"^\| `.*?\|.*?\|(?= )", table, re.M)
    motions = [(row.split("|")[1], set(re.findall(r"`(\w+)`", row.split("|")[2]))) for row in rows]
    assert motions == [(f" `{name}` ", set(options)) for name, (_, options) in MOTIONS.items()]
