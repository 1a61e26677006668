"""`make fuzz`: libFuzzer on each target for a while; inputs that reach new code are kept in corpus/, as text.

    make fuzz TIME=60 TARGETS="parser fields-invented-random" SEED=2

The targets of C are in tests/c/fuzz, those of Rust in tests/rust/fuzz. Inputs of one source have the same form in both
languages, and each language begins with what was found in the other one. An input that fails is shown as hexadecimal:
after the repair, add it to corpus/, as a line of its own. `…-random` changes the known inputs at random, which is much
faster, because nothing observes which code they reach. Python (tests/python/fuzz.py, with Atheris)
begins with these inputs, too, and keeps none.
"""

from __future__ import annotations

import argparse
import os
import random
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).parent
TESTS = HERE.parent
sys.path += [str(TESTS), str(TESTS / "c"), str(TESTS.parent / "generator")]

import c_build  # noqa: E402
import crates  # noqa: E402
from seeds import seeds  # noqa: E402
from support import BUILD, generate_invented, model  # noqa: E402


class Target(NamedTuple):
    language: str
    #: What it tries, which determines the form of its inputs.
    source: str
    #: The specification whose library it runs. The parser is the same in both.
    spec: str


TARGETS = {
    "parser": Target("c", "parser", "real"),
    "fields": Target("c", "fields", "real"),
    "fields-invented": Target("c", "fields", "invented"),
    "rust-parser": Target("rust", "parser", "real"),
    # Each field has code of its own: inputs that reach it all would be more than all others together, and are not kept.
    "rust-fields-invented": Target("rust", "fields", "invented"),
}
C = [name for name, target in TARGETS.items() if target.language == "c"]
RUST = [name for name, target in TARGETS.items() if target.language == "rust"]

#: Programs that change the known inputs at random, each with the target whose inputs they are.
RANDOM = {f"{name}-random": name for name in TARGETS}
SLICE = 1_000_000  # executions with one seed, which are then counted
TRAPS = ["-std=c99", "-O2", "-fsanitize=undefined", "-fsanitize-trap=undefined"]
LIMITS = {"ASAN_OPTIONS": "abort_on_error=1", "UBSAN_OPTIONS": "abort_on_error=1:print_stacktrace=1"}

#: Targets without stored inputs, and the sources of Python's.
PYTHON = {"python-parser": "parser", "python-fields": "fields"}
OTHERS = [*RANDOM, *PYTHON]
ATHERIS = "3.0.0"

FLAGS = ["-std=c99", "-g", "-O1", "-fsanitize=fuzzer-no-link,address,undefined", "-fno-sanitize-recover=all"]
LARGEST = {"parser": 800, "fields": 260}  # bytes of an input, so that the corpus stays small

#: The options of clang's fuzzer-no-link, in the form that Rust's stable compiler accepts; clang links libFuzzer.
COVERAGE = ["level=4", "inline-8bit-counters", "pc-table", "trace-compares"]
CHECKS = "-Cdebug-assertions"  # and with them, of overflow; as a setting of cargo's profile it would leave these out
RUSTFLAGS = " ".join([
    CHECKS, "-Cpasses=sancov-module", *(f"-Cllvm-args=-sanitizer-coverage-{flag}" for flag in COVERAGE),
    "-Clinker=clang", "-Clink-arg=-fsanitize=fuzzer",
])  # fmt: skip


def begin(name: str) -> list[bytes]:
    """The inputs that need no search."""
    return seeds(TARGETS[name].source, model(TARGETS[name].spec))


def kept(name: str) -> list[bytes]:
    """The inputs of the kept corpus."""
    path = HERE / f"corpus/{name}.hex"
    lines = path.read_text("ascii").splitlines() if path.exists() else ()
    return [bytes.fromhex(line) for line in lines if line and not line.startswith("#")]


def known(name: str) -> list[bytes]:
    """The inputs of all targets with inputs of the same form and specification."""
    return [i for other, target in TARGETS.items() if target[1:] == TARGETS[name][1:] for i in kept(other)]


def keep(name: str, inputs: list[bytes]) -> None:
    head = f"# Inputs for {name} that reach what the seeds do not, found by `make fuzz`; one per line.\n"
    lines = sorted({i.hex() for i in inputs}, key=lambda line: (len(line), line))
    (HERE / f"corpus/{name}.hex").write_text(head + "".join(f"{line}\n" for line in lines), "ascii")


def build(name: str, program: Path) -> Path:
    language, source, spec = TARGETS[name]
    if language == "rust":
        return build_rust(source, spec, program, "libfuzzer", RUSTFLAGS)
    library = c_build.archive(spec, "clang", *FLAGS)
    path = TESTS / f"c/fuzz/{source}.c"
    return c_build.compiled(program, spec, "clang", path, *FLAGS, "-fsanitize=fuzzer", library=library)


def build_replay(name: str, program: Path, flags: list[str]) -> Path:
    language, source, spec = TARGETS[name]
    if language == "rust":
        return build_rust(source, spec, program, "replay", CHECKS)
    path = TESTS / "c/fuzz"
    return c_build.compiled(program, spec, "clang", path / f"{source}.c", *flags, also=[path / "replay.c"])


def binary(name: str) -> str:
    return f'[[bin]]\nname = "{name}"\npath = "{TESTS / f"rust/fuzz/{name}.rs"}"\ntest = false\n'


def build_rust(source: str, spec: str, program: Path, name: str, flags: str) -> Path:
    folder = crates.project(spec, name, binary(name))
    machine = crates.passes(folder, "-vV").partition("host: ")[2].split()[0]
    arguments = ("build", "--offline", "--quiet", "--release", "--target", machine)
    profile = {"CARGO_PROFILE_RELEASE_LTO": "off", "CARGO_PROFILE_RELEASE_PANIC": "unwind"}
    crates.passes(folder, *arguments, TARGET=source, RUSTFLAGS=flags, **profile)
    shutil.copy2(crates.WORK / f"target/{machine}/release/{name}", program)
    return program


def write(folder: Path, inputs: list[bytes]) -> Path:
    folder.mkdir()
    for i, data in enumerate(inputs):
        (folder / f"{i:05}").write_bytes(data)
    return folder


def run(folder: Path, *arguments: str | Path) -> str:
    """The fuzzer, with a failure shown."""
    command = [folder / "program", f"-artifact_prefix={folder}/failure-", "-timeout=20", *arguments]
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        shown = [f"{path.name}: {path.read_bytes().hex()}" for path in sorted(folder.glob("failure-*"))]
        sys.exit("\n".join([done.stderr[-4000:], *shown]))
    return done.stderr


def executions(output: str) -> int:
    return int(re.findall(r"Done (\d+) runs", output)[-1])


def empty(name: str) -> Path:
    folder = BUILD / f"fuzz/{name}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def fuzz(name: str, seconds: int) -> Iterator[int]:
    folder = empty(name)
    build(name, folder / "program")
    first = write(folder / "seeds", begin(name))
    before = write(folder / "known", known(name))
    found = write(folder / "found", [])
    largest = LARGEST[TARGETS[name].source]
    output = run(folder, f"-max_total_time={seconds}", f"-max_len={largest}", found, first, before)
    # Keeps inputs that reach edges which the seeds do not, the smallest for each; how often does not matter.
    merged = write(folder / "merged", begin(name))
    seeded = {p.name for p in merged.iterdir()}
    run(folder, "-merge=1", "-use_counters=0", merged, before, found)
    if name != "rust-fields-invented":
        keep(name, [p.read_bytes() for p in merged.iterdir() if p.name not in seeded])
        print(f"{name}: {len(kept(name))} inputs kept")
    yield executions(output)


def hexadecimal(path: Path, inputs: list[bytes]) -> Path:
    path.write_text("".join(f"{data.hex()}\n" for data in inputs if data), "ascii")
    return path


def at_random(name: str, seconds: int, chance: random.Random) -> Iterator[int]:
    folder, of = empty(name), RANDOM[name]
    inputs = hexadecimal(folder / "inputs", [*begin(of), *known(of)])
    source = [TARGETS[of].source] if TARGETS[of].language == "rust" else []
    fast = build_replay(of, folder / "program", TRAPS)
    checked = fast if source else build_replay(of, folder / "checked", c_build.SANITIZED)
    number, end = 0, time.monotonic() + seconds
    while time.monotonic() < end:
        program = checked if number % 10 == 0 else fast
        command = [program, *source, inputs, SLICE, chance.getrandbits(63)]
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True, env={**os.environ, **LIMITS})
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))}\n{done.stderr[-4000:]}")
        number += 1
        yield SLICE


def fuzz_python(name: str, seconds: int) -> Iterator[int]:
    """Atheris is not part of the lock: it is available for few Pythons and systems."""
    source, tool, folder = PYTHON[name], BUILD / "tools/atheris", empty(name)
    if not (tool / f"atheris-{ATHERIS}.dist-info").is_dir():
        pip = [sys.executable, "-m", "pip", "install", "--quiet", "--upgrade", "--target", tool, f"atheris=={ATHERIS}"]
        if subprocess.run([str(c) for c in pip], capture_output=True).returncode != 0:
            sys.exit(f"make: atheris {ATHERIS} cannot be installed for this Python; leave out {' '.join(PYTHON)}")
    first = write(folder / "seeds", [*begin(source), *known(source)])
    limits = [f"-artifact_prefix={folder}/failure-", f"-max_total_time={seconds}", f"-max_len={LARGEST[source]}"]
    done = subprocess.run(
        [sys.executable, str(TESTS / "python/fuzz.py"), source, *limits, str(first)],
        capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(tool)},
    )  # fmt: skip
    if done.returncode != 0:
        sys.exit(done.stdout[-4000:] + done.stderr[-4000:])
    yield executions(done.stderr)


def run_target(name: str, seconds: int, chance: random.Random) -> Iterator[int]:
    if name in TARGETS:
        return fuzz(name, seconds)
    return fuzz_python(name, seconds) if name in PYTHON else at_random(name, seconds, chance)


def main() -> None:
    parser = argparse.ArgumentParser(prog="make fuzz")
    parser.add_argument("--time", type=int, default=60, metavar="SECONDS", help="for each target")
    parser.add_argument("--seed", type=int, default=time.time_ns(), help="of what is drawn at random")
    every = [*TARGETS, *OTHERS]
    parser.add_argument("--targets", nargs="*", default=every, choices=every)
    parser.add_argument("--record", action="store_true", help="note the counts in docs/proofs.md")
    given = parser.parse_args()
    if problem := generate_invented():  # as before all tests
        sys.exit(problem)
    print(f"seed {given.seed}")
    chance = random.Random(given.seed)
    totals = {}
    for name in given.targets:
        totals[name] = sum(run_target(name, given.time, chance))
        print(f"{name}: {totals[name]:,} executions", flush=True)
    if given.record:
        record(totals, given.time, given.seed)


def record(totals: dict[str, int], seconds: int, seed: int) -> None:
    table = TESTS.parent / "docs/proofs.md"
    begin, end = "<!-- written by make fuzz RECORD=1 -->", "<!-- end of fuzzing -->"
    rows = [f"| `{name}` | {total:,} |" for name, total in totals.items()]
    lines = [begin, "", f"{seconds} seconds each, seed {seed}.", "", "| Program | Executions |", "|---|---:|", *rows]
    before, _, rest = table.read_text("utf-8").partition(begin)
    table.write_text("\n".join([before + lines[0], *lines[1:], "", end]) + rest.partition(end)[2], "utf-8")


if __name__ == "__main__":
    main()
