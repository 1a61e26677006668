"""C: how much faster than code written by hand, how many instructions for each byte, how large.

The code written by hand is in plain.c. Times are of the processor, the best of many rounds; instructions are
counted by valgrind. `bench.py` says how to write the result into the README.
"""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
from pathlib import Path

import streams
from mipgen.resolve import load_model

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
BUILD = ROOT / "build/bench"
SOURCES = ROOT / "generated/c/src"
README = ROOT / "templates/c/bench.md"
SIZE = 1_000_000
ROUNDS, TURNS = 20, 4

#: What is measured: title, stream, our function, that of plain.c.
ROWS = (
    ("parse, in pieces of 4 KiB", "log", "ours_parse", "plain_parse"),
    ("parse, decode every known field: direct", "log", "ours_direct", "plain_both"),
    ("parse, decode every known field: by table", "log", "ours_table", "plain_both"),
    ("parse, find every field in the registry, decode", "log", "ours_registry", "plain_both"),
    ("build packets of three fields: direct", "log", "ours_build_direct", "plain_build"),
    ("build packets of three fields: by table", "log", "ours_build_table", "plain_build"),
    ("parse, byte by byte", "log", "ours_bytewise", "plain_bytewise"),
    ("skip random bytes", "noise", "ours_parse", "plain_parse"),
    ("skip NMEA sentences", "text", "ours_parse", "plain_parse"),
    ("parse packets among NMEA sentences", "mixed", "ours_parse", "plain_parse"),
)
#: Rows that are measured with the portable checksum too.
CHECKSUM = {"ours_parse", "ours_direct", "ours_build_direct"}

ARM = ["-mcpu=cortex-m4", "-mthumb", "-std=c99", "-Os", "-ffreestanding", "-ffunction-sections", "-fdata-sections"]
#: The functions of the C library are not counted.
LINK = ["-nostdlib", "-Wl,--gc-sections", *(f"-Wl,--defsym={f}=0" for f in ("memcpy", "memmove", "memset", "memchr"))]

CORE = """
#include "mip/core.h"
struct mip_parser parser;
uint8_t buffer[MIP_MAX_PACKET];
const uint8_t *volatile data;
volatile size_t size, fields;
int main(void) {
    mip_parser_init(&parser);
    const uint8_t *at = data;
    size_t left = size;
    struct mip_packet packet;
    struct mip_builder builder;
    while (mip_parser_next(&parser, &at, &left, &packet)) {
        struct mip_walk walk = mip_walk_packet(&packet);
        struct mip_field field;
        while (mip_walk_next(&walk, &field)) {
            fields = fields + field.size;
        }
    }
    mip_builder_start(&builder, buffer, sizeof(buffer), 1);
    mip_builder_add(&builder, 1, data, size);
    size = mip_builder_finish(&builder).size;
    return 0;
}
"""

#: The same with plain.c.
PLAIN = """
#include "plain.h"
struct plain_parser parser;
uint8_t buffer[261];
const uint8_t *volatile data;
volatile size_t size, fields;
int main(void) {
    plain_init(&parser);
    const uint8_t *at = data;
    size_t left = size;
    while (plain_next(&parser, &at, &left)) {
        size_t place = 4, length;
        uint8_t descriptor;
        const uint8_t *bytes;
        while (plain_field(&parser, &place, &descriptor, &bytes, &length)) {
            fields = fields + length;
        }
    }
    struct plain_builder builder;
    plain_start(&builder, buffer, sizeof(buffer), 1);
    plain_begin(&builder, 1, 8);
    plain_u64(&builder, (uint64_t)size);
    size = plain_finish(&builder);
    return 0;
}
"""

Row = list[str]


def run(*command: str | Path) -> str:
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))[:300]}: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def library() -> list[str]:
    return [str(p) for p in sorted((SOURCES / "mip").glob("*.c"))]


def version(compiler: str) -> str:
    """GCC 12.2"""
    line = run(compiler, "--version").splitlines()[0]
    found = re.search(r"(\d+\.\d+)[.\d]*\b(?!.*\b\d+\.\d+\.\d+)", line)
    return f"{'Clang' if 'clang' in line else 'GCC'} {found[1] if found else '?'}"


# --------------------------------------------------------------------------- speed


def measure(program: Path, stream: Path, functions: list[str]) -> dict[str, float]:
    """Function -> the nanoseconds of its best round. They take turns, so that all see the same disturbances."""
    best: dict[str, float] = {}
    found: dict[str, str] = {}
    for _ in range(TURNS):
        for name in functions:
            time, found[name] = run(program, stream, name, str(ROUNDS)).split()
            best[name] = min(float(time), best.get(name, 1e18))
    assert len(set(found.values())) == 1, found  # both did the same work
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
        run("cc", *flags, *choice, HERE / "speed.c", HERE / "plain.c", *library(), "-o", program)
    rows = []
    for title, stream, ours, plain in ROWS:
        path = BUILD / f"{stream}.bin"
        for suffix, program in programs.items():
            if suffix and (ours not in CHECKSUM or stream != "log"):
                continue
            times = measure(program, path, [ours, plain])
            counts = [instructions(program, path, f) for f in (ours, plain)]
            rates = [path.stat().st_size / times[f] * 1000 for f in (ours, plain)]
            rows.append([
                title + suffix, f"{times[plain] / times[ours]:.1f}",
                *(f"{c:.2f}" if c is not None else "no valgrind" for c in counts),
                *(f"{r:.0f}" for r in rates),
            ])  # fmt: skip
    return rows


# --------------------------------------------------------------------------- size


def linked(name: str, text: str, *flags: str) -> int:
    """Bytes of code and constants of a program for a Cortex-M4, without those of an empty one."""
    source, program = BUILD / f"{name}.c", BUILD / f"{name}.elf"
    source.write_text(text)
    run("arm-none-eabi-gcc", *ARM, *LINK, "-Wl,-e,main", f"-I{SOURCES}", f"-I{HERE}", source, *library(),
        HERE / "plain.c", *flags, "-o", program)  # fmt: skip
    text_, data = run("arm-none-eabi-size", program).splitlines()[1].split()[:2]
    return int(text_) + int(data)


def state(name: str, symbol: str) -> int:
    """Bytes of a variable of a linked program."""
    found = re.search(rf"^\S+ (\S+) \S {symbol}$", run("arm-none-eabi-nm", "-S", BUILD / f"{name}.elf"), re.M)
    assert found
    return int(found[1], 16)


def roots(*symbols: str) -> list[str]:
    """Options that link these and what they need."""
    path = BUILD / "roots"
    path.write_text("".join(f"-Wl,--undefined={s}\n" for s in symbols))
    return [f"@{path}"]


def sizes() -> list[Row]:
    if shutil.which("arm-none-eabi-gcc") is None:
        return []
    empty = linked("empty", "int main(void) { return 0; }\n")
    core, plain = linked("core", CORE) - empty, linked("plain", PLAIN) - empty
    headers = "".join(p.read_text("utf-8") for p in sorted((SOURCES / "mip").glob("*.h")))
    codecs = sorted(set(re.findall(r"extern (?:MIP_API )?const struct mip_codec (\w+);", headers)))
    ends = "int main(void) { return 0; }\n"
    tables = linked("tables", ends, *roots(*codecs, "mip_decode", "mip_encode")) - empty
    engine = linked("engine", ends, *roots("mip_decode", "mip_encode")) - empty
    inline = sorted(set(re.findall(r"(\w+)_decode_inline\(struct", headers)))
    straight = "".join(f'#include "mip/{p.name}"\n' for p in sorted((SOURCES / "mip").glob("*.h")))
    for name in inline:
        straight += (
            f"mip_error d_{name}(struct {name} *v, const struct mip_field *f);\n"
            f"mip_error d_{name}(struct {name} *v, const struct mip_field *f) {{ return {name}_decode_inline(v, f); }}\n"
            f"mip_error e_{name}(const struct {name} *v, struct mip_builder *b);\n"
            f"mip_error e_{name}(const struct {name} *v, struct mip_builder *b) {{ return {name}_encode_inline(v, b); }}\n"
        )
    functions = roots(*(f"{side}_{name}" for name in inline for side in "de"))
    by_hand = (linked("straight", straight + ends, *functions) - empty) / len(inline)
    names = linked("names", ends, *roots("mip_ack_code_name")) - empty
    each = tables / len(codecs)
    return [
        ["parser, walk and builder", f"{core / plain:.2f}", f"{core} B", f"{plain} B"],
        ["state of the parser", "", f"{state('core', 'parser')} B", f"{state('plain', 'parser')} B"],
        [f"encode and decode all {len(codecs)} layouts by table, each", f"{each / by_hand:.2f}",
         f"{each:.1f} B", f"{by_hand:.1f} B"],
        ["of these for all layouts together: what reads the tables", "", f"{engine} B", ""],
        ["names of one enumeration, those of acknowledge codes", "", f"{names} B", ""],
    ]  # fmt: skip


# --------------------------------------------------------------------------- report


def table(heads: list[str], rows: list[Row]) -> str:
    lines = [heads, ["---", *["---:"] * (len(heads) - 1)], *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def report(readme: bool) -> str:
    """As Markdown; for the README without bytes for each second, which depend on the machine."""
    BUILD.mkdir(parents=True, exist_ok=True)
    heads = ["", "times as fast", "instructions for each byte", "by hand", "MB/s", "by hand"]
    columns = 4 if readme else 6
    fast, small = speed(), sizes()
    counted = shutil.which("valgrind") is not None
    out = f"{version('cc')} -O2 on {platform.machine().replace('_', '-')}, against code written by hand, which reads"
    out += " and writes byte by byte:\n\n"
    out += table(heads[:columns], [row[:columns] for row in fast])
    if not counted:
        out += "\nInstructions are counted where valgrind is (Debian: apt-get install valgrind).\n"
    if not small:
        return out + "\nSizes need arm-none-eabi-gcc (Debian: apt-get install gcc-arm-none-eabi).\n"
    out += f"\n{version('arm-none-eabi-gcc')} -Os for a Cortex-M4, linked without the C library:\n\n"
    return out + table(["", "share", "bytes", "by hand"], small)


def write_readme() -> None:
    missing = [tool for tool in ("valgrind", "arm-none-eabi-gcc") if shutil.which(tool) is None]
    if missing:
        raise SystemExit(f"the table of the README needs {' and '.join(missing)} (Debian: apt-get install valgrind gcc-arm-none-eabi)")
    README.write_text(report(readme=True), "utf-8")


if __name__ == "__main__":
    print(report(readme=False))
