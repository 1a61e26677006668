"""The commands in docs/vendor.md, run with a repository on this machine."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from support import BUILD, ROOT, packaging

PAGE = (ROOT / "docs/vendor.md").read_text("utf-8")
FOLDERS = ("generated/c/", "generated/javascript/", "generated/python/", "generated/rust/", "tests/rust/", "tools/")
pytestmark = [packaging, pytest.mark.xdist_group("vendor")]  # a repository that is made once


@cache
def repository() -> str:
    """A repository with the files as they are now."""
    where = BUILD / "vendor/repository"
    shutil.rmtree(where, ignore_errors=True)
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in listed.split("\0"):
        if name.startswith(FOLDERS):
            target = where / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, target)
    for command in ("init -q -b main", "add -A -f", "commit -q -m all"):
        git(*command.split(), cwd=where)
    return str(where)


def git(*command: str, cwd: Path) -> str:
    return run(f"git {' '.join(command)}", cwd)


def run(script: str, cwd: Path, **environment: str) -> str:
    given = {
        "GIT_CONFIG_COUNT": "3",
        "GIT_CONFIG_KEY_0": "protocol.file.allow", "GIT_CONFIG_VALUE_0": "always",  # a submodule on this machine
        "GIT_CONFIG_KEY_1": "user.name", "GIT_CONFIG_VALUE_1": "test",
        "GIT_CONFIG_KEY_2": "user.email", "GIT_CONFIG_VALUE_2": "test@example.com",
    }  # fmt: skip
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["sh", "-e", "-c", script], cwd=cwd, capture_output=True, text=True,
        env={**os.environ, **given, "PATH": path, **environment},
    )  # fmt: skip
    assert done.returncode == 0, f"{script}\n{done.stdout[-2000:]}{done.stderr[-2000:]}"
    return done.stdout


def shown(section: str, number: int = 0) -> str:
    """A block of the page."""
    text = PAGE.partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    return str(re.findall(r"```\w+\n(.*?)```", text, re.S)[number])


def test_cmake_fetches_c(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(shown("C and C++"), "utf-8")
    shutil.copyfile(ROOT / "generated/c/quickstart.c", tmp_path / "main.c")
    run("cmake -S . -B build >log && cmake --build build --target app >>log", tmp_path, MIPGEN=repository())
    assert " g" in run("./build/app", tmp_path)


@pytest.mark.parametrize("way", [0, 1], ids=["submodule", "subtree"])
def test_git_brings_the_folders(tmp_path: Path, way: int) -> None:
    project, clone = tmp_path / "project", tmp_path / "clone"
    project.mkdir()
    run("git init -q -b main && git commit -q --allow-empty -m first", project)
    run(shown("Any language, with Git", way), project, MIPGEN=repository())
    assert git("status", "--porcelain", cwd=project) == ""
    run(f"git clone -q --recurse-submodules file://{project} {clone}", tmp_path)
    assert (clone / "external/mipgen/generated/c/CMakeLists.txt").is_file()


def test_folders_are_used(tmp_path: Path) -> None:
    """Those of a subtree, after it was pulled once more."""
    cmake, cargo, pip, npm = (shown("Any language, with Git", number) for number in range(3, 7))
    run("git init -q -b main && git commit -q --allow-empty -m first", tmp_path)
    run(shown("Any language, with Git", 1), tmp_path, MIPGEN=repository())
    git("commit", "-q", "--allow-empty", "-m", "later", cwd=Path(repository()))
    run(shown("Any language, with Git", 2), tmp_path, MIPGEN=repository())

    (tmp_path / "CMakeLists.txt").write_text(cmake, "utf-8")
    shutil.copyfile(ROOT / "generated/c/quickstart.c", tmp_path / "main.c")
    run("cmake -S . -B build >log && cmake --build build --target app >>log", tmp_path)
    assert " g" in run("./build/app", tmp_path)

    head = '[package]\nname = "app"\nversion = "0.0.0"\nedition = "2021"\n\n'
    (tmp_path / "Cargo.toml").write_text(f"{head}{cargo}\n[workspace]\n", "utf-8")
    (tmp_path / "src").mkdir()
    shutil.copyfile(ROOT / "generated/rust/examples/quickstart.rs", tmp_path / "src/main.rs")
    assert " g along x" in run("cargo run --quiet --offline", tmp_path, CARGO_TARGET_DIR=str(tmp_path / "target"))

    pip = pip.replace("pip install", f"{sys.executable} -m pip install --no-deps --no-build-isolation")
    run(pip, tmp_path, PIP_TARGET=str(tmp_path / "site"), MIP_TOOLS_PURE="1")
    assert (tmp_path / "site/mip_tools/__main__.py").is_file()
    assert (tmp_path / "site/mip_simulator/command.py").is_file()
    shutil.copyfile(ROOT / "generated/python/quickstart.py", tmp_path / "quickstart.py")
    assert " g" in run(f"{sys.executable} quickstart.py", tmp_path, PYTHONPATH=str(tmp_path / "site"))

    run(npm, tmp_path, npm_config_offline="true")
    shutil.copyfile(ROOT / "generated/javascript/quickstart.mjs", tmp_path / "first.mjs")
    assert " g" in run("node first.mjs", tmp_path)
