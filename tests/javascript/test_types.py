"""The declarations for TypeScript, and what bundlers make of the package."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest
from javascript.test_javascript import GENERATED
from support import ROOT, SPECS, heavy, node_modules

HERE = Path(__file__).parent
pytestmark = [heavy("npm with TypeScript and esbuild"), pytest.mark.xdist_group("npm")]


def project(folder: Path, package: Path = GENERATED) -> Path:
    """A folder for programs that import the package by its name."""
    home = folder / "node_modules"
    home.mkdir()
    name = json.loads((package / "package.json").read_text("utf-8"))["name"]
    (home / name).symlink_to(package)
    (home / "@types").symlink_to(node_modules() / "@types")
    return folder


def compiled(folder: Path) -> str:
    """The compiler's messages on all programs of a folder, including the declarations of the package."""
    options = {
        "strict": True, "noUncheckedIndexedAccess": True, "exactOptionalPropertyTypes": True, "skipLibCheck": False,
        "module": "nodenext", "target": "es2022", "lib": ["es2022", "dom"], "types": ["node"], "noEmit": True,
    }  # fmt: skip
    (folder / "tsconfig.json").write_text(json.dumps({"compilerOptions": options, "include": ["*.mts"]}), "utf-8")
    done = subprocess.run([node_modules() / ".bin/tsc", "-p", folder], capture_output=True, text=True, timeout=300)
    return done.stdout + done.stderr


def modules_of(package: Path) -> str:
    """A program that imports everything."""
    about = json.loads((package / "package.json").read_text("utf-8"))
    names = [f"{about['name']}{path[1:]}" for path in about["exports"] if path != "./package.json"]
    assert len(names) > 10
    return "".join(f'export * as x{i} from "{n}";\n' for i, n in enumerate(names))


def test_right_programs_compile_and_wrong_ones_do_not(tmp_path: Path) -> None:
    folder = project(tmp_path)
    for program in (*HERE.glob("types/*.mts"), ROOT / "examples/typed.mts"):
        shutil.copy(program, folder)
    (folder / "all.mts").write_text(modules_of(GENERATED), "utf-8")
    assert (folder / "wrong.mts").read_text("utf-8").count("// @ts-expect-error ") > 15
    assert compiled(folder) == ""  # each `@ts-expect-error` marks an error, or it would be one


def test_every_module_of_the_invented_specification_is_declared(tmp_path: Path) -> None:
    package = SPECS["invented"][1] / "javascript"
    folder = project(tmp_path, package)
    (folder / "all.mts").write_text(modules_of(package), "utf-8")
    assert compiled(folder) == ""


#: A program, and the most bytes that it may have.
BUNDLES = {
    'export { Parser } from "mip-protocol";': 6_000,
    'export { ScaledAccel } from "mip-protocol/sensor"; export { Parser } from "mip-protocol";': 12_500,
    'export * from "mip-protocol/sensor"; export { Parser } from "mip-protocol";': 20_000,
    'export * from "mip-protocol/filter_data"; export { Parser } from "mip-protocol";': 30_000,
    'export * from "mip-protocol/gnss_data"; export { Parser } from "mip-protocol";': 32_000,
    'export * from "mip-protocol/filter"; export { Parser } from "mip-protocol";': 30_000,
    'export { Client } from "mip-protocol"; export * from "mip-protocol/sensor";': 22_000,
    'export { openSerial } from "mip-protocol/serial"; export { EulerAngles } from "mip-protocol/filter_data";': 34_200,
}


def test_a_bundle_has_only_what_its_program_uses(tmp_path: Path) -> None:
    folder = project(tmp_path)
    command = [node_modules() / ".bin/esbuild", "--bundle", "--minify", "--format=esm", "--target=es2022"]
    for program, most in BUNDLES.items():
        made = subprocess.run(command, input=program.encode(), cwd=folder, stdout=subprocess.PIPE, check=True)
        assert len(made.stdout) < most, program
