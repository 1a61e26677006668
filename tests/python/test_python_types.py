"""What type checkers report to users of the installed package: on its programs, and on arguments of constructors."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import sysconfig
import venv
from collections.abc import Sequence
from pathlib import Path

from packages import REAL
from support import ROOT, heavy, mypy

PAGES = ("README.md", "docs/columns.md", "docs/fleet.md", "docs/simulate.md", "generated/python/README.md")

#: Each line with a comment is wrong.
ARRAYS = """\
from pathlib import Path
from typing_extensions import assert_type
from mip_protocol import FunctionSelector, aio, gnss, mip_3dm, open_port, types

open_port(Path("/dev/ttyACM0"))
aio.open_port(Path("/dev/ttyACM0"))

rate = types.DescriptorRate(4, 10)
command = mip_3dm.MessageFormat.write(0x80, [rate])
assert_type(command.descriptors, tuple[types.DescriptorRate, ...] | None)
mip_3dm.MessageFormat.write(0x80, (rate, rate))
gnss.RtkDongleConfig(FunctionSelector.WRITE, 1, [0, 0, 0])
mip_3dm.MessageFormat.write(0x80, None)  # not optional
mip_3dm.MessageFormat.write(0x80, [4])  # not a rate
mip_3dm.MessageFormat.write(0x80, rate)  # not a sequence
"""


def programs(folder: Path) -> list[Path]:
    """Every program that the pages show, each in a file."""
    found = []
    for page in PAGES:
        shown = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text("utf-8"), re.S)
        for number, code in enumerate(shown):
            found.append(folder / f"{page.removesuffix('.md').replace('/', '_')}_{number}.py")
            found[-1].write_text(code, "utf-8")
    assert len(found) > 12
    return found


def wrong_lines(source: str) -> set[int]:
    return {number for number, line in enumerate(source.splitlines(), 1) if "# " in line}


def test_mypy(tmp_path: Path) -> None:
    """It finds nothing in the programs of the documentation; arrays are made of any sequence, and of nothing else."""
    (tmp_path / "arrays.py").write_text(ARRAYS)
    files = [*programs(tmp_path), tmp_path / "arrays.py"]
    # pyserial has no types, and the tools are checked with their own settings
    done = mypy(REAL, "--disable-error-code=import-untyped", "--follow-imports=silent", *files)
    errors = re.findall(r"(\w+\.py):(\d+): error", done.stdout)
    assert set(errors) == {("arrays.py", str(n)) for n in wrong_lines(ARRAYS)}, done.stdout


def pyright(folder: Path, files: Sequence[Path]) -> list[tuple[str, int, str]]:
    """File, line and message of each error, for users who have installed the package."""
    venv.create(folder / "env", symlinks=True)
    python = folder / "env/bin/python"
    (packages,) = (folder / "env/lib").glob("python3*/site-packages")
    (packages / "installed.pth").write_text(f"{REAL}\n{ROOT / 'tools'}\n{sysconfig.get_path('purelib')}\n")
    settings = {"include": [str(f) for f in files], "typeCheckingMode": "standard", "pythonPlatform": "All"}
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "basedpyright", "--outputjson", "--project", folder, "--pythonpath", python]
    done = subprocess.run(command, capture_output=True, text=True)
    found = json.loads(done.stdout)
    assert found["summary"]["filesAnalyzed"] == len(files), done.stdout
    return [
        (Path(x["file"]).name, x["range"]["start"]["line"] + 1, x["message"])
        for x in found["generalDiagnostics"]
        if x["severity"] == "error"
    ]


@heavy("pyright")
def test_pyright_finds_nothing_in_the_programs_of_the_documentation(tmp_path: Path) -> None:
    assert not pyright(tmp_path, programs(tmp_path))


@heavy("pyright")
def test_arrays_are_made_of_any_sequence_for_pyright(tmp_path: Path) -> None:
    file = tmp_path / "arrays.py"
    file.write_text(ARRAYS)
    found = pyright(tmp_path, [file])
    assert {line for _, line, _ in found} == wrong_lines(ARRAYS), found
