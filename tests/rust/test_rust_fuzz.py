"""What C is fuzzed with, in Rust: the seeds, the kept corpus, and inputs that are made from them by chance.

Rust has nothing to read behind an array, so that the search for inputs that reach new code is left to C; what is
compared here is each target with a plain one, and what must hold whatever the input is.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from crates import WORK, passes, project
from support import ROOT, heavy, rounds

HERE = Path(__file__).parent
sys.path += [str(ROOT / "tests/c"), str(ROOT / "tests/c/fuzz")]
import fuzz  # noqa: E402

#: Names of the corpora of C, with the specification of each.
SPECS = {
    "parser": "invented",
    "fields-invented": "invented",
    "client-invented": "invented",
    "fields": "real",
    "client": "real",
}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=heavy("the real Rust crate")) if SPECS[n] == "real" else n for n in SPECS]
)
def test_replay(name: str) -> None:
    target, inputs = fuzz.TARGETS[name][0], [*fuzz.begin(name), *fuzz.kept(name)]
    replay = f'[[test]]\nname = "replay"\npath = "{HERE / "fuzz/replay.rs"}"\n'
    folder = project(SPECS[name], "fuzz", replay)
    file = WORK / f"{name}.hex"
    file.write_text("".join(f"{data.hex()}\n" for data in inputs if data))
    count = rounds(20_000, 2_000_000)
    arguments = ("test", "--offline", "--quiet", "--test", "replay", "--", "--nocapture")
    out = passes(folder, *arguments, TARGET=target, INPUTS=str(file), COUNT=str(count))
    assert f"{len([i for i in inputs if i])} inputs and {count} that were made from them\n" in out


def test_all_corpora_are_replayed() -> None:
    assert SPECS.keys() == fuzz.TARGETS.keys()
