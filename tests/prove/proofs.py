"""Proves properties of the C library with CBMC: for all inputs within bounds, not for some.

    make prove                 every proof; what is unchanged is not proved again
    make prove PROOF=walk      those whose name begins so

What is proved holds for any layout whose codec is well-formed; `test_prove.py` looks whether all are.

A proof depends on its harness, the sources that it includes and the prover. A result is kept in build/prove/ under the
hash of these without their comments. A complete run writes the table in docs/proofs.md.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SOURCES = ROOT / "generated/c/src"
KEPT = ROOT / "build/prove"
TABLE = ROOT / "docs/proofs.md"
MEMORY = 6 << 30  # bytes
#: The marks around the table that `make prove` writes.
BEGIN, END = "<!-- written by make prove: the core -->", "<!-- end of the core -->"

#: What is proved of the core: bounds, and options of the prover. Everything else is of any size.
CORE = {
    "walk": ("any payload, from any place in it", "--unwind 1"),
    "walk_begins": ("any packet", "--unwind 1"),
    "builder": ("any packet that is being built, any field", "-DANY_CHECKSUM --unwind 4"),
    "packet": ("up to 16 bytes", "--unwind 17"),
    "checksum": ("up to 16 bytes, byte by byte", "--unwind 17"),
}
#: The same for the small stream parser.
PARSER = {
    "parser_init": ("the first state", "--unwind 1"),
    "parser_examine": ("up to 600 bytes", "--unwind 1"),
    "parser_next": ("any state, any piece of up to 600 bytes", "--unwind 3 -DEXAMINED"),
    "parser_flush": ("any state", "--unwind 3"),
}
#: The same for the fast one, part by part; a proof replaces what the ones before it have proved.
FAST = {
    "parser_copy": ("bytes up to the end of the buffer", "--unwind 3"),
    "parser_sum": ("any candidate after any other, in a piece of up to 600 bytes", "--unwind 3"),
    "parser_scan": ("an empty buffer, any piece of up to 600 bytes", "--unwind 3 -DREPLACED=1"),
    "parser_search": ("any state, any piece of up to 600 bytes", "--unwind 3 -DREPLACED=2"),
    "parser_next, fast": ("any state, any piece of up to 600 bytes", "--unwind 6 -DREPLACED=3"),
    "parser_flush, fast": ("any state", "--unwind 3 -DREPLACED=4"),
}
#: The same for the client. The first loop of most events tries all lists of requests.
CLIENT = {
    f"client_{event}": (bounds, f"--unwind 4 --unwindset client_{event}.0:9{loops}")
    for event, bounds, loops in (
        ("poll", "up to three requests, any time", ""),
        ("passes", "up to three requests, any packet", ",mip_client_passes.0:65"),
        ("next", "up to three requests, any fields", ""),
        ("cancel", "up to three requests", ""),
        ("wait", "up to three requests", ""),
        ("add", "a request that waits or not, any packet that is being built", ""),
        ("barrier", "up to three requests", ",mip_client_barrier.1:65"),
    )
}
#: The same for the interpreter of programs, one step of it at a time.
INTERPRETER = {
    "layout": ("the first step of any program", "--unwind 2"),
    "step_of_numbers": ("any program, any state", "--unwind 10 --unwindset run:2"),
    "step_of_counted_numbers": ("any program, any state; items of up to 4 numbers", "--unwind 10 --unwindset run:2"),
    "other_step": ("any program, any state", "--unwind 10 --unwindset run:2"),
    "read": ("any program, any field", "--unwind 10 --unwindset run:2"),
    "write": ("any program, any structure", "--unwind 10 --unwindset run:2"),
}
#: The same for decoding and encoding; each is compiled for speed and for size.
CODEC = {
    "decode": ("any codec, any field", "--unwind 3 --object-bits 10"),
    "encode": ("any codec, any structure, any packet that is being built", "-DANY_NUMBERS --unwind 3 --object-bits 10"),
    "moves": ("numbers of any kind, up to 255 bytes", "--unwind 3 --object-bits 10"),
}
#: Harnesses that include what they prove, and what they include besides core.h.
INCLUDED = {
    "core.c": ("core.c", "checksum.h"),
    "parser.c": ("parser.c", "parser.h", "parser_small.c", "parser_fast.c", "checksum.h"),
    "client.c": ("client.c", "client.h"),
    "interpreter.c": ("program.c", "program.h"),
    "codec.c": ("codec.c", "parser.h", "program.h"),
}


@dataclass(frozen=True)
class Proof:
    name: str
    bounds: str
    harness: str
    function: str
    options: tuple[str, ...]
    sources: tuple[str, ...]


@dataclass(frozen=True)
class Result:
    outcome: str  # "proved", "refuted", or "not proved" in the time or the memory
    seconds: int
    properties: int


def core() -> Iterator[Proof]:
    for source, group, given in (
        ("core.c", CORE, ("-DMIP_CHECKSUM=0", "-DLARGEST=16")),
        ("parser.c", PARSER, ("-DMIP_CHECKSUM=0", "-DLARGEST=600", "-DMIP_PARSER_SMALL")),
        ("parser.c", FAST, ("-DMIP_CHECKSUM=0", "-DLARGEST=600", "-DMIP_PARSER_FAST", "--object-bits", "10")),
        ("client.c", CLIENT, ()),
        ("interpreter.c", INTERPRETER, ()),
        ("codec.c", CODEC, ()),
        ("codec.c", {f"{name}, for size": proof for name, proof in CODEC.items()}, ("-D__OPTIMIZE_SIZE__",)),
    ):
        for name, (bounds, options) in group.items():
            function = name.partition(",")[0]
            yield Proof(name, bounds, source, function, (*given, *options.split()), (*INCLUDED[source], "core.h"))


# --------------------------------------------------------------------------- the prover


def prover() -> str | None:
    found = shutil.which("cbmc") or ROOT / "build/tools/cbmc/cbmc"
    return str(found) if Path(found).is_file() else None


def key(proof: Proof, sources: Path, cbmc: str) -> str:
    digest = hashlib.sha256(repr((proof.function, proof.options, version(cbmc))).encode())
    for path in (*harness(HERE / proof.harness), *(of_library(name, sources) for name in proof.sources)):
        digest.update(without_comments(path.read_text("utf-8")).encode())
    return digest.hexdigest()[:24]


def of_library(name: str, sources: Path = SOURCES) -> Path:
    return next((sources / "mip").rglob(name))


def harness(path: Path) -> Iterator[Path]:
    """A harness, and what it includes of this folder."""
    yield path
    for name in re.findall(r'#include "([a-z]+\.h)"', path.read_text("utf-8")):
        yield from harness(HERE / name)


def without_comments(source: str) -> str:
    """Returns C without its comments and the texts of #error."""
    return " ".join(re.sub(r"/\*.*?\*/|^#error [^\n]*", " ", source, flags=re.S | re.M).split())


def version(cbmc: str, known: dict[str, str] = {}) -> str:  # noqa: B006
    if cbmc not in known:
        known[cbmc] = subprocess.run([cbmc, "--version"], capture_output=True, text=True, check=True).stdout.split()[0]
    return known[cbmc]


def prove(proof: Proof, cbmc: str, seconds: int, sources: Path = SOURCES) -> Result:
    """Proves it, or finds what refutes it, within `seconds` of processor time."""
    command = [cbmc, HERE / proof.harness, "-I", sources, "--function", proof.function, "--json-ui",
               "--unwinding-assertions", "--drop-unused-functions", *proof.options]  # fmt: skip

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    began = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, preexec_fn=limit)
    spent = round(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - began)
    if done.returncode not in (0, 10):
        if done.returncode == 1 or "CONVERSION ERROR" in done.stdout or "PARSING ERROR" in done.stdout:
            sys.exit(f"{proof.name}: {done.stdout[-3000:]}{done.stderr[-2000:]}")
        return Result("not proved", spent, 0)
    found = next(x["result"] for x in json.loads(done.stdout) if "result" in x)
    refuted = [p for p in found if p["status"] == "FAILURE"]
    for p in refuted[:3]:
        print(f"  {p['description']} ({p.get('sourceLocation', {}).get('line', '?')})")
    return Result("refuted" if refuted else "proved", spent, len(found))


def place(proof: Proof, cbmc: str) -> Path:
    return KEPT / f"{key(proof, SOURCES, cbmc)}.json"


def found(proof: Proof, cbmc: str) -> Result | None:
    """The result of an earlier run, if all that it depends on is unchanged."""
    path = place(proof, cbmc)
    return Result(**json.loads(path.read_text("utf-8"))) if path.is_file() else None


def kept(proof: Proof, cbmc: str, seconds: int) -> Result:
    result = found(proof, cbmc)
    if result is None or (result.outcome == "not proved" and result.seconds + 2 < seconds):
        result = prove(proof, cbmc, seconds)
        if result.outcome != "refuted":
            KEPT.mkdir(parents=True, exist_ok=True)
            place(proof, cbmc).write_text(json.dumps(result.__dict__), "utf-8")
    return result


# --------------------------------------------------------------------------- planted bugs

#: For nearly each proof a change that it must refute, so that none is vacuous: file, old text, new text, proof.
PLANTS = [
    ("core.h", "length < 2 || length > left", "length < 2", "walk"),
    ("core.h", "packet->size >= MIP_HEADER_SIZE", "packet->size + 1 >= MIP_HEADER_SIZE", "walk_begins"),
    ("core.h", "capacity < MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE", "capacity < MIP_HEADER_SIZE", "builder"),
    ("core.c", "size < 2 || bytes[0]", "size < 1 || bytes[0]", "packet"),
    ("checksum.h", "s.b += s.a;", "s.b += bytes[0];", "checksum"),
    ("parser_small.c", "*size < missing ? *size : missing", "missing", "parser_next"),
    ("parser.c", "parser->skipped += parser->length;", "", "parser_flush"),
    ("parser_fast.c", "from + size - 16, 16", "from + size - 15, 16", "parser_copy"),
    ("parser_fast.c", "*--w.end", "*w.end--", "parser_sum"),
    ("parser_fast.c", "goal > left", "goal > left + 1", "parser_scan"),
    ("parser_fast.c", "left <= given - *size", "left <= given", "parser_search"),
    ("parser_fast.c", "sizeof(parser->buffer) - BLOCK", "sizeof(parser->buffer)", "parser_next, fast"),
    ("client.c", "*at = request->next;", "", "client_cancel"),
    ("client.c", "client->behind / 2U", "client->behind", "client_barrier"),
    ("client.c", "next < FIRST_BARRIER ? FIRST_BARRIER : next", "next", "client_poll"),
    ("client.c", "MIP_SENT;\n        return;", "MIP_SENT;", "client_wait"),
    ("client.c", "size == 0 || packet->descriptor_set", "packet->descriptor_set", "client_passes"),
    ("client.c", "&& packet->buffer[before + 2] == 0", "&& packet->buffer[before + 300] == 0", "client_add"),
    ("client.c", "if (field->size < 2) {\n        return NULL;\n    }", "", "client_next"),
    ("program.c", "size > (size_t)(s->end - bytes)", "size > (size_t)(s->end - bytes) + 1", "step_of_numbers"),
    ("program.c", "times = 1;\n            uint8_t", "uint8_t", "step_of_counted_numbers"),
    ("program.c", "times > of[1]", "times > of[1] + 1U", "other_step"),
    ("program.c", "size_t left = p[3]", "size_t left = p[3] + 1U", "layout"),
    ("program.c", "s.error == MIP_OK && s.counts", "s.error == MIP_OK", "read"),
    ("program.c", "*size = (size_t)(s.at - data);", "*size = (size_t)(s.at - data) + 1;", "write"),
    ("codec.c", "field->size >= codec->numbers &&", "", "decode"),
    ("codec.c", "codec->numbers > field->size", "codec->numbers > field->size + 1", "decode, for size"),
    ("codec.c", "start + size + MIP_CHECKSUM_SIZE > builder->capacity", "start + size > builder->capacity", "encode"),
    ("codec.c", "step >> 5, step & 31, writing", "step >> 5, 31, writing", "encode, for size"),
    ("codec.c", "memory += bits / 8;", "memory += bits / 4;", "moves"),
    ("codec.c", "memory + (i ^ flip)", "memory + (i + flip)", "moves, for size"),
]  # fmt: skip


def planted(number: int, cbmc: str) -> Result:
    """The result of the proof for a copy of the sources with this bug."""
    file, old, new, name = PLANTS[number]
    proof = next(p for p in core() if p.name == name)
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(SOURCES, folder, dirs_exist_ok=True)
        path = of_library(file, Path(folder))
        text = path.read_text("utf-8")
        if text.count(old) < 1:
            sys.exit(f"{file} no longer contains {old!r}: mend PLANTS")
        path.write_text(text.replace(old, new, 1), "utf-8")
        return prove(proof, cbmc, 60, Path(folder))


def run(proofs: list[Proof], cbmc: str, seconds: int) -> list[tuple[Proof, Result]]:
    results = []
    for proof in proofs:
        result = kept(proof, cbmc, seconds)
        results.append((proof, result))
        print(
            f"{proof.name}: {result.outcome} ({proof.bounds}; {result.properties} properties, {result.seconds} s)",
            flush=True,
        )
    return results


def write(results: list[tuple[Proof, Result]]) -> None:
    """Writes the table of docs/proofs.md."""
    git = ["git", "log", "-1", "--format=revision %h of %cs", "--abbrev=8", "--", "generated/c/src/mip", "tests/prove"]
    revision = subprocess.run(git, cwd=ROOT, capture_output=True, text=True).stdout.strip()
    rows = [
        f"| `{p.sources[0]}` | {p.name} | {p.bounds} | {r.outcome}, {r.properties} properties |" for p, r in results
    ]
    heads = ["| File | Proof | Scope | Result |", "|---|---|---|---|"]
    before, _, rest = TABLE.read_text("utf-8").partition(BEGIN)
    lines = [BEGIN, "", f"Sources of {revision or 'no revision'}.", "", *heads, *rows, "", END]
    TABLE.write_text(before + "\n".join(lines) + rest.partition(END)[2], "utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(prog="make prove")
    parser.add_argument("--proof", default="", help="the proofs whose name begins so; without it, all")
    parser.add_argument("--seconds", type=int, default=60, help="processor time for each proof (60)")
    parser.add_argument(
        "--plant", action="store_true", help="instead, plant each bug and look whether its proof sees it"
    )
    given = parser.parse_args()
    cbmc = prover()
    if cbmc is None:
        sys.exit("make: cbmc is missing; `make prove` says how to get it")
    if given.plant:
        unseen = 0
        for i, (file, old, new, name) in enumerate(PLANTS):
            outcome = planted(i, cbmc).outcome
            unseen += outcome != "refuted"
            print(f"{file}: {old} -> {new or 'nothing'}: {outcome} ({name})", flush=True)
        print(f"{len(PLANTS) - unseen} of {len(PLANTS)} planted bugs are seen")
        return 1 if unseen else 0
    began = time.monotonic()
    results = run([p for p in core() if p.name.startswith(given.proof)], cbmc, given.seconds)
    if not given.proof:
        write(results)
    counts = {o: sum(r.outcome == o for _, r in results) for o in ("proved", "refuted", "not proved")}
    print(", ".join(f"{n} {o}" for o, n in counts.items()) + f" in {time.monotonic() - began:.0f} s")
    return 1 if counts["refuted"] else 0


if __name__ == "__main__":
    sys.exit(main())
