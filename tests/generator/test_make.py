"""What a fresh machine needs, and the messages if something is missing; the locks of the Python tools."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from support import ROOT

TOOLS = ROOT / "tests/tools.sh"
PLAIN = ("sh", "make", "grep", "ls", "awk", "env", "dirname", "cat", "mkdir", "chmod", "rm")  # on any machine
SHIMS = """#!/bin/sh
case "$0 $*" in
  */rustup*"target list"*) cat "$MACHINE/targets" 2>/dev/null ;;
  */rustup*"target add"*) echo "$4" >>"$MACHINE/targets" ;;
  */rustup*"component add"*) : >"$MACHINE/$4" ;;
  */cargo-clippy*) test -f "$MACHINE/clippy" ;;
  */rustfmt*) test -f "$MACHINE/rustfmt" ;;
esac
"""
RUST = ("cargo", "rustup", "rustfmt", "cargo-clippy")
TARGET = "thumbv7m-none-eabi"
#: cargo install --quiet --locked NAME --version VERSION --root FOLDER …
INSTALLS = """#!/bin/sh
mkdir -p "$8/bin"
printf '#!/bin/sh\\necho %s %s\\n' "$4" "$6" >"$8/bin/$4"
chmod +x "$8/bin/$4"
"""


@pytest.fixture
def machine(tmp_path: Path) -> Path:
    """A folder of programs: those of any machine, Python, cargo with rustup, and a C compiler."""
    for name in PLAIN:
        (tmp_path / name).symlink_to(str(shutil.which(name)))
    for name in (*RUST, "cc"):
        (tmp_path / name).write_text(SHIMS)
        (tmp_path / name).chmod(0o755)
    (tmp_path / "state").mkdir()
    return tmp_path


def run(machine: Path, *command: str | Path) -> subprocess.CompletedProcess[str]:
    environment = {"MACHINE": "state", "HOME": "", "TOOLS": "tools"}
    return subprocess.run(
        [str(c) for c in command], capture_output=True, text=True, cwd=ROOT,
        env={"PATH": str(machine), **{name: str(machine / place) for name, place in environment.items()}},
    )  # fmt: skip


def test_rustup_brings_what_tests_need(machine: Path) -> None:
    first, second = (run(machine, TOOLS, "all").stdout for _ in range(2))
    assert first == "installing rustfmt\ninstalling clippy\n" + f"installing {TARGET}\n" and second == ""


@pytest.mark.parametrize(("goal", "needless"), [("check", ("cc", *RUST)), ("test", RUST)])
def test_checks_and_tests_need_no_rust(goal: str, needless: tuple[str, ...], machine: Path) -> None:
    for name in needless:
        (machine / name).unlink()
    done = run(machine, TOOLS, goal)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("runner", ["test", "test-packaging", "test-all"])
def test_what_is_missing_is_named_with_its_remedy_before_anything_runs(runner: str, machine: Path) -> None:
    (machine / "cc").unlink()
    (machine / "cargo").unlink()
    done = run(machine, "make", runner)
    assert done.returncode != 0
    assert ("cargo is missing; install Rust: https://rustup.rs\n" in done.stderr) == (runner != "test")
    assert "a C compiler, cc, is missing; install one (Debian: apt-get install gcc libc6-dev)\n" in done.stderr
    assert "passed" not in done.stdout and "tests run" not in done.stdout


def test_a_compiler_that_cannot_link_is_noticed(machine: Path) -> None:
    (machine / "cc").write_text("#!/bin/sh\nexit 1\n")
    done = run(machine, TOOLS, "test")
    assert done.returncode == 1 and "cc must link with -fsanitize=address,undefined" in done.stderr


def test_comparing_crates_needs_a_tool_that_is_compiled_once(machine: Path) -> None:
    done = run(machine, TOOLS, "semver")  # its cargo installs nothing
    assert done.returncode == 1 and done.stdout.startswith("installing cargo-semver-checks")
    assert done.stderr.startswith("make: cargo-semver-checks is missing; it could not be compiled (rustup update;")
    (machine / "cargo").write_text(INSTALLS)
    first, second = (run(machine, TOOLS, "semver") for _ in range(2))
    assert (first.returncode, first.stderr) == (second.returncode, second.stderr) == (0, "")
    assert first.stdout.startswith("installing cargo-semver-checks") and second.stdout == ""
    (machine / "tools/bin/cargo-semver-checks").write_text("#!/bin/sh\necho cargo-semver-checks 0.1.0\n")
    assert run(machine, TOOLS, "semver").stdout == first.stdout


def test_fuzzing_needs_clang_with_its_libraries(machine: Path) -> None:
    assert "make: clang is missing; install it" in run(machine, TOOLS, "fuzz").stderr
    (machine / "clang").write_text("#!/bin/sh\nexit 1\n")
    (machine / "clang").chmod(0o755)
    done = run(machine, TOOLS, "fuzz")
    assert done.returncode == 1 and "libFuzzer is missing; clang must link with -fsanitize=fuzzer" in done.stderr


def test_every_target_of_make_says_what_it_is_for(machine: Path) -> None:
    makefile = (ROOT / "Makefile").read_text("utf-8")
    phony = set(" ".join(re.findall(r"^\.PHONY: (.*)$", makefile, re.M)).split())
    shown = set(re.findall(r"^  make ([a-z-]+) +\w", run(machine, "make").stdout, re.M))
    assert phony - shown == {name for name in phony if name.partition("-")[0] == "tools"}
    assert {"generate", "test", "test-all", "test-cross", "fuzz", "check", "quick", "lock", "semver"} <= shown


# --------------------------------------------------------------------------- locks


LOCKS = ("generator.txt", "development.txt", "all.txt")


def pinned(name: str) -> dict[str, str]:
    text = (ROOT / "requirements" / name).read_text("utf-8")
    return {canonicalize_name(n): v for n, v in re.findall(r"^([\w.-]+)==(\S+)", text, re.M)}


@pytest.mark.parametrize("name", LOCKS)
def test_locks_are_of_no_machine(name: str) -> None:
    """Pins and hashes alone: no folder, no address. A lock includes the smaller one."""
    lines = (ROOT / "requirements" / name).read_text("utf-8").splitlines()
    position = LOCKS.index(name)
    if position:
        assert lines.pop(0) == f"-r {LOCKS[position - 1]}"
    for line in lines:
        assert re.fullmatch(r"[\w.-]+==\S+( ; .*?)?( --hash=sha256:\w{64})+", line), line
        assert "/" not in line, line


def test_locks_hold_what_the_package_asks_for() -> None:
    lock = pinned("generator.txt")
    project = (ROOT / "pyproject.toml").read_text("utf-8").partition("\ndependencies = [")[2].partition("]")[0]
    needs = [Requirement(x) for x in re.findall(r'"(.*?)"', project)]
    assert {"ruff", "clang-format", "jinja2"} <= {n.name for n in needs}
    for need in needs:
        assert need.specifier.contains(lock[canonicalize_name(need.name)]), need


def test_locks_agree() -> None:
    """One environment is made from all of them, and each pin stands once."""
    names = [n for name in LOCKS for n in pinned(name)]
    assert len(set(names)) == len(names) > 50
