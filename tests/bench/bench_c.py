"""C: speed, and instructions per byte. bench_c_board.py has sizes; bench_c_peer.py compares it with the vendor's SDK.

Times are processor times, the best of many rounds; instructions are counted by valgrind. `make bench README=1` writes
the result into the README.
"""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
from pathlib import Path

import streams
from mipgen.resolve.load import load_model

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
BUILD = ROOT / "build/bench"
SOURCES = ROOT / "generated/c/src"
README = ROOT / "docs/parts/bench_c.md"
SIZE = 1_000_000
ROUNDS, TURNS = 20, 4

#: What is measured: title, stream, function of speed.c.
ROWS = (
    ("parse, in pieces of 4 KiB", "log", "ours_parse"),
    ("parse, decode every known field: direct", "log", "ours_direct"),
    ("parse, decode every known field: by table", "log", "ours_table"),
    ("parse, find every field in the registry, decode", "log", "ours_registry"),
    ("build packets of three fields: direct", "log", "ours_build_direct"),
    ("build packets of three fields: by table", "log", "ours_build_table"),
    ("parse, three fields by handlers of `device.h`, in pieces of 64 bytes", "log", "ours_device"),
    ("parse, byte by byte", "log", "ours_bytewise"),
    ("skip random bytes", "noise", "ours_parse"),
    ("skip NMEA sentences", "text", "ours_parse"),
    ("parse packets among NMEA sentences", "mixed", "ours_parse"),
)
#: Rows that are measured with the portable checksum too.
CHECKSUM = {"ours_parse", "ours_direct", "ours_build_direct"}

#: The functions of the C library and of the compiler are not counted.
OUTSIDE = ("memcpy", "memmove", "memset", "memchr", "strcmp", "__aeabi_uldivmod")

Row = list[str]


def run(*command: str | Path) -> str:
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))[:300]}: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def library() -> list[str]:
    return [str(p) for p in sorted((SOURCES / "mip").glob("*/*.c"))]


def version(compiler: str) -> str:
    """GCC 12.2"""
    line = run(compiler, "--version").splitlines()[0]
    found = re.search(r"(\d+\.\d+)[.\d]*\b(?!.*\b\d+\.\d+\.\d+)", line)
    return f"{'Clang' if 'clang' in line else 'GCC'} {found[1] if found else '?'}"


# --------------------------------------------------------------------------- speed


def measure(stream: Path, functions: dict[str, Path], turns: int = TURNS, rounds: int = ROUNDS) -> dict[str, float]:
    """Functions, each with its program -> the nanoseconds of its best round. They take turns, so that all see the
    same disturbances."""
    best: dict[str, float] = {}
    found: dict[str, str] = {}
    for _ in range(turns):
        for name, program in functions.items():
            time, found[name] = run(program, stream, name, str(rounds)).split()
            best[name] = min(float(time), best.get(name, 1e18))
    assert len(set(found.values())) == 1, found  # all did the same work
    return best


def instructions(program: Path, stream: Path, function: str) -> float | None:
    """For each byte; None without valgrind."""
    if shutil.which("valgrind") is None:
        return None
    out = run("valgrind", "--tool=callgrind", f"--callgrind-out-file={BUILD}/callgrind.{function}.{stream.stem}",
              f"--toggle-collect={function}", program, stream, function, "1")  # fmt: skip
    collected = re.search(r"Collected : (\d+)", out)
    assert collected
    return int(collected[1]) / stream.stat().st_size


def speed() -> list[Row]:
    model = load_model(ROOT / "spec")
    packets, sentences = streams.log(model, SIZE), streams.text(SIZE)
    contents = {"log": packets, "noise": streams.noise(SIZE), "text": sentences}
    contents["mixed"] = streams.mixed(packets, sentences)
    for name, content in contents.items():
        (BUILD / f"{name}.bin").write_bytes(content)
    flags = ["-std=gnu99", "-O2", "-Wall", "-Wextra", f"-I{SOURCES}", f"-I{HERE}"]
    programs = {"": BUILD / "speed", ", portable checksum": BUILD / "speed-portable"}
    for suffix, program in programs.items():
        choice = ["-DMIP_CHECKSUM=MIP_CHECKSUM_WORDS"] if suffix else []
        run("cc", *flags, *choice, HERE / "speed.c", *library(), "-o", program)
    rows = []
    for title, stream, function in ROWS:
        path = BUILD / f"{stream}.bin"
        for suffix, program in programs.items():
            if suffix and (function not in CHECKSUM or stream != "log"):
                continue
            time, count = measure(path, {function: program})[function], instructions(program, path, function)
            rate = path.stat().st_size / time * 1000
            rows.append([title + suffix, f"{count:.2f}" if count is not None else "?", f"{rate:.0f}"])
    return rows


# --------------------------------------------------------------------------- report


def table(heads: list[str], rows: list[Row]) -> str:
    lines = [heads, ["---", *["---:"] * (len(heads) - 1)], *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def report(readme: bool = False) -> str:
    """As Markdown. The README omits times, which depend on the machine."""
    BUILD.mkdir(parents=True, exist_ok=True)
    columns = 2 if readme else 3
    machine = platform.machine().replace("_", "-")
    out = f"{version('cc')}, `-O2`, on {machine}; a log with packets of 44 bytes on average (`make bench`).\n\n"
    heads = ["Speed", "Instructions for each byte", "MB/s"]
    out += table(heads[:columns], [row[:columns] for row in speed()])
    if shutil.which("valgrind") is None:
        out += "\nInstructions are counted by valgrind, which is missing (Debian: apt-get install valgrind).\n"
    return out


def write_readme() -> None:
    if shutil.which("valgrind") is None:
        raise SystemExit("bench: the README needs valgrind (Debian: apt-get install valgrind)")
    README.write_text(report(readme=True), "utf-8")
    print(f"{README.relative_to(ROOT)} is written; now: make generate golden")
