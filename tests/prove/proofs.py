"""Proves properties of the C library with CBMC: for all inputs within bounds, not for some.

    make prove                              the core and every layout; what is unchanged is not proved again
    make prove FIELD=base.comm_speed        one layout
    make prove COUNT=10 SEED=3              the core and ten layouts drawn by the seed; COUNT=0: the core

What is proved of the core holds for any layout whose codec is well-formed; `test_prove.py` looks whether all are. The
proof of a layout shows more: that what is decoded is encoded to the same bytes.

A proof depends on its harness, the sources that it includes and the prover. A result is kept in build/prove/ under the
hash of these without their comments. A run of the core writes its table in docs/proofs.md, a complete one both.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "generator"), str(ROOT / "tests")]

from mipgen import model as m  # noqa: E402
from mipgen.targets.c import bytecode, names  # noqa: E402
from support import all_fields, model, set_of  # noqa: E402

SOURCES = ROOT / "generated/c/src"
KEPT = ROOT / "build/prove"
TABLE = ROOT / "docs/proofs.md"
MEMORY = 6 << 30  # bytes
#: The marks around a table that `make prove` writes.
BEGIN, END = "<!-- written by make prove: {} -->", "<!-- end of {} -->"

#: What is proved of the core: bounds, and options of the prover. Everything else is of any size.
CORE = {
    "walk": ("any payload, from any place in it", "--unwind 1"),
    "walk_begins": ("any packet", "--unwind 1"),
    "builder": ("any packet that is being built, any field", "-DANY_CHECKSUM --unwind 4"),
    "packet": ("up to 16 bytes", "--unwind 17"),
    "checksum": ("up to 16 bytes, byte by byte", "--unwind 17"),
}
#: The same for the stream parser as it is compiled for size.
PARSER = {
    "parser_init": ("the first state", "--unwind 1"),
    "parser_next": ("any state, any piece of up to 600 bytes", "--unwind 3"),
    "parser_flush": ("any state", "--unwind 3"),
}
#: The same as it is compiled for speed, part by part; a proof replaces what the ones before it have proved.
FAST = {
    "parser_copy": ("bytes up to the end of the buffer", "--unwind 3"),
    "parser_sum": ("any candidate after any other, in a piece of up to 600 bytes", "--unwind 3"),
    "parser_scan": ("an empty buffer, any piece of up to 600 bytes", "--unwind 3 -DREPLACED=1"),
    "parser_search": ("any state, any piece of up to 600 bytes", "--unwind 3 -DREPLACED=2"),
    "parser_next, for speed": ("any state, any piece of up to 600 bytes", "--unwind 6 -DREPLACED=3"),
    "parser_flush, for speed": ("any state", "--unwind 3 -DREPLACED=4"),
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
    "parser.c": ("parser.c", "checksum.h"),
    "client.c": ("client.c", "client.h"),
    "interpreter.c": ("program.c", "program.h"),
    "codec.c": ("codec.c", "program.h"),
}
#: The harness tries arrays of variable length with at most this many items.
ITEMS = 3


@dataclass(frozen=True)
class Proof:
    name: str  # of a layout: "base.ping"
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
        ("parser.c", PARSER, ("-DMIP_CHECKSUM=0", "-DLARGEST=600", "-D__OPTIMIZE_SIZE__")),
        ("parser.c", FAST, ("-DMIP_CHECKSUM=0", "-DLARGEST=600", "--object-bits", "10")),
        ("client.c", CLIENT, ()),
        ("interpreter.c", INTERPRETER, ()),
        ("codec.c", CODEC, ()),
        ("codec.c", {f"{name}, for size": proof for name, proof in CODEC.items()}, ("-D__OPTIMIZE_SIZE__",)),
    ):
        for name, (bounds, options) in group.items():
            function = name.partition(",")[0]
            yield Proof(name, bounds, source, function, (*given, *options.split()), (*INCLUDED[source], "core.h"))


def layouts() -> Iterator[Proof]:
    of = model("real")
    for f in all_fields(of):
        yield layout(f, of)


def layout(f: m.Field, of: m.Model) -> Proof:
    numbers = bytecode.is_numbers(f, of.layouts(f))
    module = names.module(f.family) if f.family in {x.name for x in of.families} else "protocol"
    structure = names.field_name(f)
    open_array = next((p for p in f.parameters if p.open), None)
    if numbers:
        largest, bounds = m.MAX_FIELD_DATA, "any size"
    elif open_array is None:
        largest, bounds = f.max_size + 1, f"up to {f.max_size + 1} bytes"
    else:
        item = open_array.item.struct.max_size if open_array.item.struct else sum(q.size for q in [open_array.leaf])
        largest = f.min_size + sum(p.size for p in f.parameters if p is not open_array and p.kind == "scalar")
        largest = largest + ITEMS * item + 1
        bounds = f"up to {ITEMS} items of `{open_array.name}`"
    largest = min(largest, m.MAX_FIELD_DATA)
    given = [
        "-DMIP_CHECKSUM=0", f'-DHEADER="mip/{module}.h"', f"-DTYPE=struct {structure}", f"-DCODEC={structure}_codec",
        f"-DSET={set_of(f, of)}", f"-DLARGEST={largest}", "--unwind", str(max(270, 4 * largest)),
        "--max-field-sensitivity-array-size", "1000", "--object-bits", "16",
    ]  # fmt: skip
    if not numbers:
        given += ["--unwindset", "run:3", "--slice-formula"]
        given += [f"-DWIRE={joined(wire(f))}"]
    harness = "numbers.c" if numbers else "program.c"
    interpreter = [] if numbers else ["program.c"]
    sources = ("core.c", "codec.c", *interpreter, "double.c", f"{module}.c", "core.h", "program.h", f"{module}.h")
    return Proof(f.full_name, bounds, harness, "decode", tuple(given), sources)


def deciding(f: m.Field) -> Iterator[tuple[m.Parameter, list[int]]]:
    """The bytes that decide how others are read, with the values to try: all that have a meaning, and one that
    has none."""
    tags = {p.union.tag: p.union for p in f.parameters if p.union}
    for p in f.parameters:
        if p.selector:
            yield p, [0, *(x.value for x in f.functions), 255]
        elif p.kind == "counter":
            yield p, [*range(ITEMS + 1), 255]
        elif p.name in tags and p.size == 1:
            yield p, [*(c.tag.value for c in tags[p.name].cases), 255]


def wire(f: m.Field) -> Iterator[tuple[str, list[int]]]:
    values, at = dict(deciding(f)), 0
    for p in f.parameters:
        if p in values:
            yield str(at), values[p]
        if p.open or p.union or p.struct:
            break  # what follows has no fixed place
        at += p.size if p.count is None else p.count * p.item.size


def joined(splits: Iterable[tuple[str, list[int]]]) -> str:
    return "".join(f"{{{at}, {len(v)}, {{{', '.join(map(str, v))}}}}}, " for at, v in splits)


# --------------------------------------------------------------------------- the prover


def prover() -> str | None:
    found = shutil.which("cbmc") or ROOT / "build/tools/cbmc/cbmc"
    return str(found) if Path(found).is_file() else None


def key(proof: Proof, sources: Path, cbmc: str) -> str:
    digest = hashlib.sha256(repr((proof.function, proof.options, version(cbmc))).encode())
    for path in (*harness(HERE / proof.harness), *(sources / "mip" / name for name in proof.sources)):
        digest.update(without_comments(path.read_text("utf-8")).encode())
    return digest.hexdigest()[:24]


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
    linked = [] if proof.harness in INCLUDED else [n for n in proof.sources if n.endswith(".c")]
    also = [sources / "mip" / name for name in linked]
    command = [cbmc, HERE / proof.harness, *also, "-I", sources, "--function", proof.function, "--json-ui",
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

#: File, old text, new text, and the proof that must refute the change.
PLANTS = [
    ("core.h", "if (left == 0) {", "if (walk->error != MIP_OK) {", "walk"),
    ("core.h", "walk->at = walk->end;", "", "walk"),
    ("core.h", "length < 2 || length > left", "length < 2", "walk"),
    ("core.h", "length < 2 || length > left", "length < 1 || length > left", "walk"),
    ("core.h", "length < 2 || length > left", "length < 2 || length >= left", "walk"),
    ("core.h", "length < 2 || length > left", "length < 2 || length > left + 1", "walk"),
    ("core.h", "field->data = walk->at + 2;", "field->data = walk->at + 1;", "walk"),
    ("core.h", "field->size = (uint8_t)(length - 2);", "field->size = length;", "walk"),
    ("core.h", "field->descriptor = walk->at[1];", "field->descriptor = walk->at[0];", "walk"),
    ("core.h", "walk->error = MIP_ERROR_FIELD_LENGTH;", "", "walk"),
    ("core.h", "packet->size >= MIP_HEADER_SIZE", "packet->size + 1 >= MIP_HEADER_SIZE", "walk_begins"),
    ("core.h", "walk.end += packet->size - MIP_CHECKSUM_SIZE;", "walk.end += packet->size;", "walk_begins"),
    ("core.h", "capacity < MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE", "capacity < MIP_HEADER_SIZE", "builder"),
    ("core.h", "capacity < MIP_MAX_PACKET ? capacity", "capacity > MIP_MAX_PACKET ? capacity", "builder"),
    ("core.h", "end + MIP_CHECKSUM_SIZE > builder->capacity", "end > builder->capacity", "builder"),
    ("core.h", "end + MIP_CHECKSUM_SIZE > builder->capacity", "end + 1 > builder->capacity", "builder"),
    ("core.h", "at[0] = (uint8_t)(size + 2);", "at[0] = (uint8_t)size;", "builder"),
    ("core.h", "(uint8_t)(end - MIP_HEADER_SIZE);", "(uint8_t)end;", "builder"),
    ("core.c", "size > MIP_MAX_FIELD_DATA", "size >= MIP_MAX_FIELD_DATA", "builder"),
    ("core.c", "memmove(to, data, size);", "memmove(to, data, size - 1);", "builder"),
    ("core.c", "size < 2 || bytes[0]", "size < 1 || bytes[0]", "packet"),
    ("core.c", "!mip_set_valid(bytes[2]) ||", "", "packet"),
    ("core.c", "bytes[size - 1] != (sum & 0xFFU)", "false", "packet"),
    ("core.c", "bytes[size - 2] != sum >> 8", "bytes[size - 2] != (sum & 0xFFU)", "packet"),
    ("core.c", "mip_checksum(bytes, size - MIP_CHECKSUM_SIZE)", "mip_checksum(bytes, size - 1)", "packet"),
    ("checksum.h", "s.b += s.a;", "s.b += bytes[i];", "checksum"),
    ("checksum.h", "size_t i = 0; i < size; i++", "size_t i = 1; i < size; i++", "checksum"),
    ("checksum.h", "(s.a & 0xFFU) << 8 | (s.b & 0xFFU)", "(s.b & 0xFFU) << 8 | (s.a & 0xFFU)", "checksum"),
    ("parser.c", "*size < missing ? *size : missing", "missing", "parser_next"),
    ("parser.c", "(uint16_t)(left + count)", "(uint16_t)(left + missing)", "parser_next"),
    ("parser.c", "(uint16_t)(parser->done + goal)", "(uint16_t)(parser->done + goal + 1)", "parser_next"),
    ("parser.c", "goal > 0 && goal <= size", "goal > 0", "parser_next"),
    ("parser.c", "parser->skipped++;", "", "parser_next"),
    ("parser.c", "+ MIP_HEADER_SIZE + MIP_CHECKSUM_SIZE;", "+ MIP_HEADER_SIZE;", "parser_next"),
    ("parser.c", "parser->skipped += parser->length;", "", "parser_flush"),
    ("parser.c", "(uint16_t)(at + goal)", "(uint16_t)goal", "parser_flush"),
    ("parser.c", "from + size - 16, 16", "from + size - 15, 16", "parser_copy"),
    ("parser.c", "*--w.end", "*w.end--", "parser_sum"),
    ("parser.c", "goal > left", "goal > left + 1", "parser_scan"),
    ("parser.c", "left <= given - *size", "left <= given", "parser_search"),
    ("parser.c", "sizeof(parser->buffer) - BLOCK", "sizeof(parser->buffer)", "parser_next, for speed"),
    ("parser.c", "parser->missing - *size", "parser->missing", "parser_next, for speed"),
    ("parser.c", "parser->length = 0;\n    describe", "describe", "parser_next, for speed"),
    ("client.c", "*at = request->next;", "", "client_cancel"),
    ("client.c", "client->behind / 2U", "client->behind", "client_barrier"),
    ("client.c", "next < FIRST_BARRIER ? FIRST_BARRIER : next", "next", "client_poll"),
    ("client.c", "MIP_REQUEST_SILENT;\n        return;", "MIP_REQUEST_SILENT;", "client_wait"),
    ("client.c", "size == 0 || packet->descriptor_set", "packet->descriptor_set", "client_passes"),
    ("client.c", "field += 4;\n        if", "field += 5;\n        if", "client_passes"),
    ("client.c", "&& packet->buffer[before + 2] == 0", "&& packet->buffer[before + 300] == 0", "client_add"),
    ("client.c", "r->at < field[0] ? field[r->at] : 0", "field[r->at]", "client_add"),
    ("client.c", "*answered = NULL;", "", "client_next"),
    ("client.c", "r->behind != 0 || r->exchange", "r->exchange", "client_next"),
    ("program.c", "size > (size_t)(s->end - bytes)", "size > (size_t)(s->end - bytes) + 1", "step_of_numbers"),
    ("program.c", "n << (kind & 3)", "n", "step_of_numbers"),
    ("program.c", "times = 1;\n            uint8_t", "uint8_t", "step_of_counted_numbers"),
    ("program.c", "*p++) * times;", "*p++) * (times + 1);", "step_of_counted_numbers"),
    ("program.c", "times > of[1]", "times > of[1] + 1U", "other_step"),
    ("program.c", "same = *program++ == bytes[i] && same;", "same = same && *program++ == bytes[i];", "other_step"),
    ("program.c", "(size_t)of[1] << 8 | of[2]", "((size_t)of[1] << 8 | of[2]) + 1", "other_step"),
    ("program.c", "p += of[3];", "p += of[2];", "other_step"),
    ("program.c", "index < functions ? p[index] : 0", "p[index]", "other_step"),
    ("program.c", "s->cut = true;", "s->cut = true, s->mark = s->end + 1;", "other_step"),
    ("program.c", "size_t left = p[3]", "size_t left = p[3] + 1U", "layout"),
    ("program.c", "s.error == MIP_OK && s.counts", "s.error == MIP_OK", "read"),
    ("program.c", "*size = (size_t)(s.at - data);", "*size = (size_t)(s.at - data) + 1;", "write"),
    ("codec.c", "field->size >= codec->numbers &&", "", "decode"),
    ("codec.c", "codec->numbers > field->size", "codec->numbers > field->size + 1", "decode, for size"),
    ("codec.c", "*(codec->program - i)", "*(codec->program - i - 1)", "decode"),
    ("codec.c", "MOVE_1(16, 24);", "MOVE_1(16, 26);", "decode"),
    ("codec.c", "start + size + MIP_CHECKSUM_SIZE > builder->capacity", "start + size > builder->capacity", "encode"),
    ("codec.c", "step >> 5, step & 31, writing", "step >> 5, 31, writing", "encode, for size"),
    ("codec.c", "memory += bits / 8;", "memory += bits / 4;", "moves"),
    ("codec.c", "memory + (i ^ flip)", "memory + (i + flip)", "moves, for size"),
    ("codec.c", "codec->numbers > field->size", "codec->numbers > field->size + 1", "sensor.scaled_accel"),
    ("codec.c", "left -= codec->numbers;", "left -= 1;", "sensor.scaled_accel"),
    ("codec.c", "start + size + MIP_CHECKSUM_SIZE > builder->capacity", "start + size > builder->capacity + 1",
     "encode, for size"),
    ("core.h", "(uint32_t)from[0] << 24 | (uint32_t)from[1] << 16", "(uint32_t)from[1] << 24 | (uint32_t)from[0] << 16",
     "sensor.scaled_accel"),
    ("sensor.c", "32_BITS(3, MIP_AT(struct mip_sensor_scaled_accel", "32_BITS(4, MIP_AT(struct mip_sensor_scaled_accel",
     "sensor.scaled_accel"),
    ("program.c", "s->at = bytes + size;", "s->at = bytes;", "filter.heading_source"),
    ("program.c", "*counter = (uint8_t)number;", "*counter = (uint8_t)(number + 1);",
     "base.get_device_descriptors_response"),
    ("program.c", "s->last = last;", "s->last = before;", "filter.heading_source"),
    ("program.c", "s->optional = last > s->required;", "s->optional = true;", "filter.heading_source"),
    ("program.c", "s->stopped = s->optional && s->at == s->end;", "s->stopped = s->at == s->end;",
     "filter.heading_source"),
]  # fmt: skip


def planted(number: int, cbmc: str) -> Result:
    """The result of the proof for a copy of the sources with this bug."""
    file, old, new, name = PLANTS[number]
    proof = next(p for p in (*core(), *layouts()) if p.name == name)
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(SOURCES, folder, dirs_exist_ok=True)
        path = Path(folder) / "mip" / file
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


def write(title: str, rows: list[str]) -> None:
    """Writes a table of docs/proofs.md."""
    git = ["git", "log", "-1", "--format=revision %h of %cs", "--abbrev=8", "--", "generated/c/src/mip", "tests/prove"]
    revision = subprocess.run(git, cwd=ROOT, capture_output=True, text=True).stdout.strip()
    begin, end = BEGIN.format(title), END.format(title)
    text = TABLE.read_text("utf-8")
    before, _, rest = text.partition(begin)
    lines = [begin, "", f"Sources of {revision or 'no revision'}.", "", *rows, "", end]
    TABLE.write_text(before + "\n".join(lines) + rest.partition(end)[2], "utf-8")


def write_core(results: list[tuple[Proof, Result]]) -> None:
    rows = [
        f"| `{p.sources[0]}` | {p.name} | {p.bounds} | {r.outcome}, {r.properties} properties |" for p, r in results
    ]
    write("the core", ["| File | Proof | Scope | Result |", "|---|---|---|---|", *rows])


def write_layouts(results: list[tuple[Proof, Result]]) -> None:
    groups: dict[str, list[str]] = {}
    for p, r in results:
        kind = "numbers only" if p.bounds == "any size" else "arrays" if "items" in p.bounds else "others"
        groups.setdefault(kind, []).append(r.outcome)
    bounds = {"numbers only": "fields of any size", "others": "all sizes up to one more than the longest",
              "arrays": f"all sizes up to {ITEMS} items"}  # fmt: skip
    rows = ["| Layouts | Scope | Proved | Not proved yet |", "|---|---|---|---|"]
    for kind, outcomes in sorted(groups.items(), reverse=True):
        rows.append(f"| {kind} | {bounds[kind]} | {outcomes.count('proved')} | {outcomes.count('not proved')} |")
    if late := [f"`{p.name}`" for p, r in results if r.outcome == "not proved"]:
        rows += ["", f"Not proved yet, because the prover needs more time: {', '.join(late)}."]
    write("layouts", rows)


def main() -> int:
    parser = argparse.ArgumentParser(prog="make prove")
    parser.add_argument("--field", default="", help="the layouts whose name begins so; without it, the core and all")
    parser.add_argument("--count", type=int, help="the core, and so many layouts drawn by the seed")
    parser.add_argument("--seed", type=int, default=1)
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
    proofs = [p for p in layouts() if p.name.startswith(given.field)]
    if given.count is not None:
        proofs = random.Random(given.seed).sample(proofs, given.count)
        print(f"seed {given.seed}")
    began = time.monotonic()
    results = []
    if not given.field:
        results = run([*core()], cbmc, given.seconds)
        write_core(results)
    of_layouts = run(proofs, cbmc, given.seconds)
    if not given.field and given.count is None:
        write_layouts(of_layouts)
    results += of_layouts
    counts = {o: sum(r.outcome == o for _, r in results) for o in ("proved", "refuted", "not proved")}
    print(", ".join(f"{n} {o}" for o, n in counts.items()) + f" in {time.monotonic() - began:.0f} s")
    return 1 if counts["refuted"] else 0


if __name__ == "__main__":
    sys.exit(main())
