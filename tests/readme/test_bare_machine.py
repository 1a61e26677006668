"""The commands of CONTRIBUTING.md in a fresh copy, on a machine with little more than Python and a C compiler."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import bare
import pytest
from support import EVERYTHING, ROOT, heavy

#: Of `make test`, what calls compilers; all other tests find no more than this machine has, wherever they run.
TESTS = "tests/c/test_c_device.py tests/cpp tests/conformance/test_declarations.py tests/rust/test_rust_docs.py"


@pytest.fixture
def machine(tmp_path: Path) -> dict[str, str]:
    return {"PATH": bare.path(tmp_path / "bin", EVERYTHING), "HOME": str(tmp_path), "LANG": "C.UTF-8"}


def clone(folder: Path, machine: dict[str, str]) -> None:
    """A repository with the files as they are now, and the Python packages that make installs first."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    for name in filter(None, listed.stdout.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    for part in Path(sys.prefix).iterdir():
        (folder / ".venv").mkdir(exist_ok=True)
        if part.suffix != ".stamp":
            (folder / ".venv" / part.name).symlink_to(part)
    for name in ("generator", "development"):
        (folder / f".venv/{name}.stamp").touch()
    user = ("-c", "user.name=test", "-c", "user.email=test@example.com")
    for command in (["init", "-q"], ["add", "-A"], [*user, "commit", "-q", "-m", "all"]):
        subprocess.run(["git", *command], cwd=folder, env=machine, check=True)


def make(folder: Path, machine: dict[str, str], *words: str) -> tuple[int, list[str]]:
    done = subprocess.run(["make", *words], cwd=folder, env=machine, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout.decode().splitlines()


@heavy("all commands on a bare machine")
def test_commands_with_python_and_a_c_compiler(tmp_path: Path, machine: dict[str, str]) -> None:
    page = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    assert re.findall(r"^    make (\w+) +#.*needs? (.*)$", page, re.M) == [
        ("generate", "Python 3.10 or later"), ("test", "a C compiler"),
    ]  # fmt: skip
    folder = tmp_path / "clone"
    clone(folder, machine)
    assert make(folder, machine, "generate")[0] == 0
    changed = subprocess.run(["git", "status", "--porcelain"], cwd=folder, env=machine, capture_output=True)
    assert changed.stdout == b"", "what is committed is up to date"

    code, lines = make(folder, machine, "test", f"TESTS={TESTS}")
    assert code == 0, lines
    assert re.search(r"left out, because it is missing: what uses cargo \(curl .*\), g\+\+ \(apt-get .*\)", lines[-1])
    code, lines = make(folder, machine, "test", "TESTS=tests/json tests/rust/test_rust_docs.py", "STRICT=1")
    assert code != 0 and "an error with STRICT=1: what uses cargo" in "\n".join(lines)

    code, lines = make(folder, machine, "check")
    assert code == 0 and "left out: rustfmt (rustup component add rustfmt) biome (" in lines[-1], lines
    code, lines = make(folder, machine, "-n", "check", "STRICT=1")
    assert lines[-1].startswith('test -z "rustfmt ')
