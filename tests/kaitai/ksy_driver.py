"""What the tests of mip.ksy share: its text as a tree, what the compiler makes of it, and a driver for any output."""

from __future__ import annotations

import os
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import yaml
from support import BUILD, ROOT, SPECS, Driver, locked, need

Tree = dict[str, Any]
COMPILED = ("python", "javascript")


class _Loader(yaml.CSafeLoader):
    """YAML as the compiler reads it, which knows `true` and `false` only, and no key twice."""

    def construct_mapping(self, node: Any, deep: bool = False) -> Any:
        keys = [self.construct_object(k, deep=True) for k, _ in node.value]
        assert len(keys) == len(set(keys)), f"a key twice, line {node.start_mark.line + 1}: {keys}"
        return super().construct_mapping(node, deep)


@cache
def ksy(path: Path) -> Tree:
    tree: Tree = yaml.load(path.read_text("utf-8"), Loader=_Loader)
    return tree


def file(spec: str) -> Path:
    return SPECS[spec][1] / "kaitai/mip.ksy"


def compiled(generated: Path, name: str, language: str) -> Path:
    """The folder of what the compiler makes of generated/kaitai, and the modules of Node beside it."""
    build_driver(generated, name, language)
    return BUILD / f"conformance-{name}-kaitai" / language


def built(generated: Path, name: str) -> Driver:
    command = build_driver(generated, name, "python").splitlines()[-1]
    return Driver("kaitai", command.split(), {})


def build_driver(generated: Path, name: str, language: str) -> str:
    build = BUILD / f"conformance-{name}-kaitai"
    with locked(build):
        done = subprocess.run(
            [str(ROOT / "tests/kaitai/build_driver.sh"), str(generated), str(build)],
            capture_output=True, text=True,
            env={**os.environ, "KAITAI_LANGUAGE": language, "PYTHON": need("python3")},
        )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
