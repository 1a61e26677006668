"""A vendored part of the C library: folders that are left out, by hand and by `mipgen generate --without`."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from c_build import WARNINGS, folder, headers, run
from support import need, small, uses

COMBINATIONS = ["core", "core sets", "core sets extra", "core sets cpp", "core sets extra cpp"]


def builds(made: Path, included: list[str]) -> None:
    """All sources compile and link without warnings, each with all that it calls, and so does each header."""
    program = made / "main.c"
    program.write_text("".join(f'#include "{name}"\n' for name in included) + "int main(void) { return 0; }\n")
    flags = [*WARNINGS, f"-I{made}/src"]
    run(need("cc"), "-std=c99", *flags, program, *sorted(made.glob("src/mip/*/*.c")), "-o", made / "main")


def builds_in_cpp(made: Path) -> None:
    program = made / "main.cpp"
    program.write_text("".join(f'#include "{name}"\n' for name in headers(made, ".hpp")) + "int main() {}\n")
    run(need("g++"), "-std=c++17", *WARNINGS, f"-I{made}/src", "-fsyntax-only", program)


@small("each part of the real C library")
@pytest.mark.parametrize("parts", [pytest.param(x, marks=uses("g++")) if "cpp" in x else x for x in COMBINATIONS])
def test_folders_are_parts(parts: str, spec: str, tmp_path: Path) -> None:
    source, copy = folder(spec) / "src/mip", tmp_path / "src/mip"
    copy.mkdir(parents=True)
    for path in source.iterdir():
        if path.is_file():
            shutil.copyfile(path, copy / path.name)
        elif path.name in parts.split():
            shutil.copytree(path, copy / path.name)
    builds(tmp_path, headers(tmp_path))
    if "cpp" in parts:
        builds_in_cpp(tmp_path)
