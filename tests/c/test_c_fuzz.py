"""The fuzz targets without libFuzzer: the seeds, the kept corpus, and inputs made from them at random."""

from __future__ import annotations

import os
import random
import subprocess
import sys
from pathlib import Path

import c_build
import pytest
from c_build import SANITIZED
from support import SEED, heavy, need, rounds

HERE = Path(__file__).parent
sys.path.append(str(HERE.parent / "fuzz"))
import fuzz  # noqa: E402

#: How many inputs are made of the known ones.
MADE = rounds(5_000, 50_000)


def replay(program: Path, inputs: list[bytes], count: int) -> subprocess.CompletedProcess[str]:
    file = fuzz.hexadecimal(program.with_suffix(".hex"), inputs)
    return subprocess.run(
        [str(program), str(file), str(count)], capture_output=True, text=True, env={**os.environ, **fuzz.LIMITS}
    )


@pytest.mark.parametrize("name", fuzz.C)
def test_replay(name: str, tmp_path: Path) -> None:
    program, inputs = tmp_path / "replay", [*fuzz.begin(name), *fuzz.known(name)]
    _, source, spec = fuzz.TARGETS[name]
    for parser in ([], [c_build.small_parser(spec, "cc", *SANITIZED)])[: 2 if name.startswith("parser") else 1]:
        also = [HERE / "fuzz/replay.c", *parser]
        c_build.compiled(program, spec, "cc", HERE / f"fuzz/{source}.c", *SANITIZED, also=also)
        done = replay(program, inputs, MADE)
        assert done.returncode == 0, done.stderr[-6000:]
        assert done.stdout == f"{len(inputs)} inputs and {MADE} that were made from them\n"


FAILURES = {
    "a wrong answer": "CHECK(size < 3 || data[2] != 0x42);",
    "a read beyond the input": "if (size == 3) { CHECK(data[3] != 1 || data[0] != 1); }",
    "an endless loop": "while (size > 2 && data[2] == 0x42) { }",
}


@pytest.mark.parametrize("failure", FAILURES)
def test_replay_shows_what_fails(failure: str, tmp_path: Path) -> None:
    program, target = tmp_path / "replay", tmp_path / "target.c"
    target.write_text(
        f'#include "fuzz.h"\nint LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {{ {FAILURES[failure]} '
        "return 0; }\n"
    )
    flags = [*SANITIZED, "-DREPLAY_PATIENCE=1", f"-I{HERE}/fuzz"]
    c_build.run(need("cc"), *flags, HERE / "fuzz/replay.c", target, "-o", program)
    done = replay(program, [b"\x01\x02", b"\x01\x02\x42"], 0)
    assert done.returncode == 3 and done.stderr.endswith(":\n010242\n"), done.stderr


OVERFLOW = """#include "fuzz.h"
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    return (size == 3 && data[2] == 0x42 ? INT32_MAX : 0) + (int)size > 0;
}
"""


@heavy("clang")
def test_random_inputs_are_counted_and_one_that_traps_is_shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fuzz, "BUILD", tmp_path)
    monkeypatch.setattr(fuzz, "SLICE", 20_000)
    counted = fuzz.at_random("parser-random", 3600, random.Random(SEED))
    assert [next(counted), next(counted)] == [20_000, 20_000]

    def wrong(name: str, program: Path, flags: list[str]) -> Path:
        program.with_suffix(".c").write_text(OVERFLOW)
        sources = (HERE / "fuzz/replay.c", program.with_suffix(".c"))
        c_build.run(need("clang"), *fuzz.TRAPS, f"-I{HERE}/fuzz", *sources, "-o", program)
        return program

    monkeypatch.setattr(fuzz, "build_replay", wrong)
    monkeypatch.setattr(fuzz, "known", lambda name: [b"\x01\x02\x42"])
    with pytest.raises(SystemExit, match=r"/checked /.*/inputs 20000 \d+\nthe target failed with:\n....42\n$"):
        next(fuzz.at_random("parser-random", 3600, random.Random(SEED)))


@heavy("clang")
@pytest.mark.parametrize("name", fuzz.C)
def test_libfuzzer(name: str, tmp_path: Path) -> None:
    """Runs briefly what `make fuzz` builds; the kept corpus is well-formed and small."""
    program = fuzz.build(name, tmp_path / "program")
    kept = fuzz.write(tmp_path / "kept", fuzz.kept(name))
    done = subprocess.run([str(program), "-runs=2000", str(kept)], capture_output=True, text=True)
    assert done.returncode == 0 and "Done 2000 runs" in done.stderr, done.stderr[-6000:]


def test_a_fresh_clone_has_the_invented_library_when_it_is_fuzzed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, found = tmp_path / "invented", []
    monkeypatch.setattr(fuzz, "generate_invented", lambda: out.mkdir() or "")
    monkeypatch.setattr(fuzz, "fuzz", lambda name, seconds: found.append(out.is_dir()) or [1])
    monkeypatch.setattr(sys, "argv", ["fuzz.py", "--targets", "fields-invented"])
    fuzz.main()
    assert found == [True]
