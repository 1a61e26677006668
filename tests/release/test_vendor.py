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
TAG, LATER = "v0.1.0", "v0.2.0"
FOLDERS = ("generated/c/", "generated/javascript/", "generated/python/", "generated/rust/", "tests/rust/", "tools/")
pytestmark = [packaging, pytest.mark.xdist_group("vendor")]  # a repository that is made once


@cache
def repository() -> str:
    """A repository whose tag has the files as they are now."""
    where = BUILD / "vendor/repository"
    shutil.rmtree(where, ignore_errors=True)
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in listed.split("\0"):
        if name.startswith(FOLDERS):
            target = where / name
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, target)
    for command in ("init -q -b main", "add -A -f", "commit -q -m all", f"tag {TAG}"):
        git(*command.split(), cwd=where)
    (where / "LATER").touch()
    for command in ("add LATER", "commit -q -m later", f"tag {LATER}"):
        git(*command.split(), cwd=where)
    return f"file://{where}"


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
    """A block of the page, for this repository."""
    text = PAGE.partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    blocks = re.findall(r"```\w+\n(.*?)```", text, re.S)
    return re.sub(r"(?<!\w)REPOSITORY", repository(), str(blocks[number]))


def test_cmake_fetches_c(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text(shown("C and C++"), "utf-8")
    shutil.copyfile(ROOT / "generated/c/quickstart.c", tmp_path / "main.c")
    run("cmake -S . -B build >log && cmake --build build --target app >>log", tmp_path)
    assert " g" in run("./build/app", tmp_path)


def test_cargo_finds_the_crate(tmp_path: Path) -> None:
    head = '[package]\nname = "app"\nversion = "0.0.0"\nedition = "2021"\n\n'
    (tmp_path / "Cargo.toml").write_text(head + shown("Rust") + "\n[workspace]\n", "utf-8")
    (tmp_path / "src").mkdir()
    shutil.copyfile(ROOT / "generated/rust/examples/quickstart.rs", tmp_path / "src/main.rs")
    out = run("cargo run --quiet", tmp_path, CARGO_HOME=str(tmp_path / "cargo"), CARGO_TARGET_DIR=str(tmp_path / "t"))
    assert " g along x" in out


def test_pip_installs_packages(tmp_path: Path) -> None:
    commands = shown("Python").replace("pip install", f"{sys.executable} -m pip install --no-deps --no-build-isolation")
    run(commands, tmp_path, PIP_TARGET=str(tmp_path / "site"), MIP_TOOLS_PURE="1")
    assert (tmp_path / "site/mip_tools/__main__.py").is_file()
    quickstart = ROOT / "generated/python/quickstart.py"
    assert " g" in run(f"{sys.executable} {quickstart}", tmp_path, PYTHONPATH=str(tmp_path / "site"))


def test_git_submodule_and_subtree(tmp_path: Path) -> None:
    for name, number in (("module", 0), ("tree", 1)):
        project = tmp_path / name
        project.mkdir()
        run("git init -q -b main && git commit -q --allow-empty -m first", project)
        run(shown("Any language, with Git", number), project)
        assert (project / "external/mipgen/generated/c/CMakeLists.txt").is_file()
        assert git("status", "--porcelain", cwd=project) == ""
    copy = tmp_path / "copy"
    run(f"git clone -q --recurse-submodules file://{tmp_path / 'module'} {copy}", tmp_path)
    assert (copy / "external/mipgen/generated/c/CMakeLists.txt").is_file()
    use_folders(tmp_path / "tree")


def use_folders(project: Path) -> None:
    """A later version of the subtree, in CMake and in npm."""
    run(shown("Any language, with Git", 2), project)
    assert (project / "external/mipgen/LATER").is_file()
    (project / "CMakeLists.txt").write_text(shown("Any language, with Git", 3), "utf-8")
    shutil.copyfile(ROOT / "generated/c/quickstart.c", project / "main.c")
    run("cmake -S . -B build >log && cmake --build build --target app >>log", project)
    assert " g" in run("./build/app", project)
    run(shown("Any language, with Git", 4), project, npm_config_offline="true")
    shutil.copyfile(ROOT / "generated/javascript/quickstart.mjs", project / "first.mjs")
    assert " g" in run("node first.mjs", project)
