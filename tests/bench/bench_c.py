"""C: speed, instructions per byte, and size. bench_c_peer.py compares it with the vendor's SDK.

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

ARM = ["-mcpu=cortex-m4", "-mthumb", "-std=c99", "-Os", "-ffreestanding", "-ffunction-sections", "-fdata-sections"]
#: The functions of the C library and of the compiler are not counted.
OUTSIDE = ("memcpy", "memmove", "memset", "memchr", "strcmp", "__aeabi_uldivmod")
LINK = ["-nostdlib", "-Wl,--gc-sections", *(f"-Wl,--defsym={f}=0" for f in OUTSIDE)]

#: Optional parts: a header, and a function that links its tables.
OPTIONAL = (
    ("device", "mip_device_call"),
    ("extra/registry", "mip_registry_find"),
    ("extra/profiles", "mip_profile_find"),
    ("extra/reflect", "mip_reflect"),
    ("extra/print", "mip_print_packet"),
)
STATES = '#include "mip/core.h"\nstruct mip_parser mip_parser;\n'

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


# --------------------------------------------------------------------------- size


def linked(name: str, symbols: list[str], text: str = "") -> int:
    """Bytes of code and constants that some functions and tables, and all that they need, take on a Cortex-M4."""
    source, program, options = (BUILD / f"{name}.{suffix}" for suffix in ("c", "elf", "options"))
    source.write_text(text + "int main(void) { return 0; }\n")
    options.write_text("".join(f"-Wl,--undefined={s}\n" for s in symbols))
    run("arm-none-eabi-gcc", *ARM, *LINK, "-Wl,-e,main", f"-I{SOURCES}", f"-I{HERE}", source,
        *library(), f"@{options}", "-o", program)  # fmt: skip
    code, data = run("arm-none-eabi-size", program).splitlines()[1].split()[:2]
    return int(code) + int(data) - (linked("empty", []) if symbols else 0)


def state(symbol: str) -> int:
    """Size of a variable of the program that holds the states."""
    found = re.search(rf"^\S+ (\S+) \S {symbol}$", run("arm-none-eabi-nm", "-S", BUILD / "states.elf"), re.M)
    assert found
    return int(found[1], 16)


def sizes() -> list[Row]:
    if shutil.which("arm-none-eabi-gcc") is None:
        return []
    paths = sorted((SOURCES / "mip").glob("*.h"))
    headers = "".join(p.read_text("utf-8") for p in paths)
    codecs = [f"{name}_codec" for name in sorted(set(re.findall(r"^MIP_FIELD\((\w+),", headers, re.M)))]
    linked("states", ["mip_parser"], STATES)
    table = linked("tables", [*codecs, "mip_decode", "mip_encode"]) / len(codecs)
    return [
        ["state of the parser, in RAM", f"{state('mip_parser')} B"],
        ["decode and encode all layouts, for each", f"{table:.1f} B"],
        ["of that, shared by all: the table reader", f"{linked('reader', ['mip_decode', 'mip_encode'])} B"],
        ["names of the acknowledge codes", f"{linked('names', ['mip_ack_code_name'])} B"],
        *([f"optional, all of `{name}.h`", f"{linked(s, [s]) / 1000:.0f} kB"] for name, s in OPTIONAL),
    ]


# --------------------------------------------------------------------------- by source

BY_SOURCE = ROOT / "docs/parts/bench_c_sources.md"
#: The sources that programs link most often.
PARTS = ("core", "parser", "parser_small", "parser_fast", "codec", "program", "value", "stream", "client", "device",
         "connect")  # fmt: skip
FUNCTION = re.compile(r"^[A-Za-z_][^;{}#=]*?\b(\w+)\([^;{}]*\)\s*\{\n(.*?)^\}", re.S | re.M)


def complexity(source: str) -> tuple[int, str]:
    """The largest cyclomatic complexity of a function, which is one more than its decisions, and the function."""
    code = re.sub(r"/\*.*?\*/|//[^\n]*|^#.*?$|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'", "", source, flags=re.S | re.M)
    return max(
        (1 + len(re.findall(r"\b(?:if|for|while|case)\b|&&|\|\||\?", body)), name)
        for name, body in FUNCTION.findall(code)
    )


def by_source() -> str:
    """Size of each source on a Cortex-M4 before unused code is removed, and its most complex function, as Markdown."""
    BUILD.mkdir(parents=True, exist_ok=True)
    rows, totals = [], [0, 0]
    for name in PARTS:
        (source,), sizes, stack = (SOURCES / "mip").glob(f"*/{name}.c"), [], 0
        for level in ("-O2", "-Os"):
            made = BUILD / f"{name}{level}.o"
            flags = [flag for flag in ARM if flag != "-Os"]
            choice = [f"-DMIP_{name.upper()}"] if name.startswith("parser_") else []
            run("arm-none-eabi-gcc", *flags, level, *choice, "-fstack-usage", f"-I{SOURCES}", "-c",
                source, "-o", made)  # fmt: skip
            code, data = run("arm-none-eabi-size", made).splitlines()[1].split()[:2]
            sizes.append(int(code) + int(data))
            stack = max(int(line.split("\t")[1]) for line in made.with_suffix(".su").read_text("utf-8").splitlines())
        most, function = complexity(source.read_text("utf-8"))
        if name != "parser_fast":
            totals = [a + b for a, b in zip(totals, sizes, strict=True)]
        decisions = str(most) if most <= 10 else f"{most} (`{function}`)"
        rows.append([f"`{name}.c`", *(f"{size} B" for size in sizes), f"{stack} B", decisions])
    rows.append(["all, with the small parser", *(f"{size} B" for size in totals), "", ""])
    heads = ["Source", "Size, `-O2`", "Size, `-Os`", "Stack, `-Os`", "Complexity"]
    return f"{version('arm-none-eabi-gcc')}, for a Cortex-M4.\n\n" + table(heads, rows)


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
    small = sizes()
    if not small:
        return out + "\nSizes need arm-none-eabi-gcc, which is missing (Debian: apt-get install gcc-arm-none-eabi).\n"
    out += f"\n{version('arm-none-eabi-gcc')}, `-Os`, for a Cortex-M4, without the C library.\n\n"
    return out + table(["Size", "Code and constants"], small)


def write_readme() -> None:
    missing = [tool for tool in ("valgrind", "arm-none-eabi-gcc") if shutil.which(tool) is None]
    if missing:
        needs = " and ".join(missing)
        raise SystemExit(f"bench: the README needs {needs} (Debian: apt-get install valgrind gcc-arm-none-eabi)")
    README.write_text(report(readme=True), "utf-8")
    BY_SOURCE.write_text(by_source(), "utf-8")
    print(f"{README.relative_to(ROOT)} and {BY_SOURCE.name} are written; now: make generate golden")
