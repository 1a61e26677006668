"""The fuzz targets of Rust: the seeds, the kept corpus of all languages, and inputs made from them at random.

Each target is compared with a plain one, and with what must hold whatever the input is; `make fuzz` searches.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from crates import WORK, passes, project
from support import ROOT, heavy, rounds

HERE = Path(__file__).parent
sys.path.append(str(ROOT / "tests/fuzz"))
import fuzz  # noqa: E402

#: Names of targets with the inputs, and the specification of the crate: the parser is the same in both.
SPECS = {"parser": "invented", "fields-invented": "invented", "fields": "real"}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=heavy("the real Rust crate")) if SPECS[n] == "real" else n for n in SPECS]
)
def test_replay(name: str) -> None:
    inputs = [data for data in [*fuzz.begin(name), *fuzz.known(name)] if data]
    folder = project(SPECS[name], "fuzz", fuzz.binary("replay"))
    file = fuzz.hexadecimal(WORK / f"{name}.hex", inputs)
    count = rounds(20_000, 2_000_000)
    arguments = ("run", "--offline", "--quiet", "--", fuzz.TARGETS[name].source, str(file), str(count))
    out = passes(folder, *arguments)
    assert f"{len(inputs)} inputs and {count} that were made from them\n" in out


def test_all_targets_are_replayed() -> None:
    assert SPECS.keys() >= {name.removeprefix("rust-") for name in fuzz.RUST}


@heavy("clang")
@pytest.mark.parametrize("name", fuzz.RUST)
def test_libfuzzer(name: str, tmp_path: Path) -> None:
    """Runs briefly what `make fuzz` builds, with the small specification: it sees which code an input reaches."""
    source = fuzz.TARGETS[name].source
    program = fuzz.build_rust(source, "invented", tmp_path / "program", "libfuzzer", fuzz.RUSTFLAGS)
    kept = fuzz.write(tmp_path / "kept", fuzz.known(name))
    done = subprocess.run([str(program), "-runs=2000", str(kept)], capture_output=True, text=True)
    assert done.returncode == 0 and "Done 2000 runs" in done.stderr, done.stderr[-6000:]
    assert "NEW" in done.stderr
