"""The programs on the pages of fields and guides: all of a language run as one program, which sends their packets."""

from __future__ import annotations

import json
import os
import posixpath
import re
import subprocess
import sys
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import crates
import pytest
from c_build import run
from mipgen import model as m
from mipgen.facts.sample_values import SampleValues
from mipgen.lower import codec
from reference import Manual, path_of, small, table_with, words
from support import SPECS, mypy, need, uses
from test_reference_guides import plays

ACKNOWLEDGE = 0xF1


@dataclass(frozen=True)
class Program:
    """A program of a page: its imports and its statements."""

    name: str  # of a field or a guide
    needs: list[str]
    body: str
    given: list[bytes]  # replies; packets for one that decodes data, which must reject all but the first
    of: str  # m.COMMAND, m.DATA or "guide"


def asked(manual: Manual) -> list[m.Field]:
    return [f for f in manual.model.fields if f.role != m.RESPONSE]


def programs(manual: Manual, language: str) -> Iterator[Program]:
    """Those of all fields and guides."""
    for f in asked(manual):
        data = f.role == m.DATA
        given = [sample(manual, f), *broken(manual, f)] if data else [reply(manual, p) for p in ready(manual, f)]
        parts = shown(manual, path_of(f), manual.page(path_of(f)), f.full_name, language)
        yield Program(f.full_name, *parts, given, f.role)
    for name, guide, sequence in plays(manual):
        path = f"guides/{guide.name}.md"
        section = manual.section(path, f"{guide.name}.{guide.sequences.index(sequence) + 1}")
        answers = [s.answer for s in sequence.steps]
        yield Program(name, *shown(manual, path, section, name, language), answers, "guide")


def shown(manual: Manual, path: str, part: str, name: str, language: str) -> tuple[list[str], str]:
    """A program in Python, or in another language, in the listing to which the part of a page leads."""
    if language == "python":
        (block,) = re.findall(r"^```python\n(.*?)^```$", part, re.M | re.S)
        return split(block)
    (target,) = re.findall(rf"^`{re.escape(name)}` is also in .*\]\(([^)#]*)#programs\.{language}\)", part, re.M)
    page = manual.page(posixpath.normpath(posixpath.join(posixpath.dirname(path), target)))
    (block,) = re.findall(rf"^```{language}\n(.*?)^```$", page, re.M | re.S)
    before, *parts = re.split(r"^(?://|/\*) ([\w.]+)(?: \*/)?\n", block, flags=re.M)
    return split(before + dict(zip(parts[::2], parts[1::2], strict=True))[name])


def split(block: str) -> tuple[list[str], str]:
    lines = block.splitlines()
    needs = [x for x in lines if x.startswith(("#include", "use ", "from ", "import "))]
    return needs, "".join(f"{x}\n" for x in lines if x not in needs)


def ready(manual: Manual, f: m.Field) -> list[bytes]:
    """The packets that the program of a command sends: the first on the page, and the first with a response."""
    rows = [words(row["Send"]) for row in table_with(manual.field(f), "Send", "Reply")]
    packets = [bytes.fromhex(x) for x in rows if x.startswith("75")]
    shown = manual.samples.shown(f)
    return [packets[i] for i, c in enumerate(manual.samples.sent(f)) if any(c is x for x in shown)]


def reply(manual: Manual, packet: bytes) -> bytes:
    """The reply of a device: an acknowledge, and the response that the command requests."""
    ((descriptor, data),) = codec.split(manual.model, packet)
    (f,) = (x for x in manual.model.candidates(packet[2], descriptor) if x.role == m.COMMAND)
    values, _ = codec.decode(f, data)
    call = next(c for c in f.calls if (c.function and c.function.value) == values.get("function"))
    samples = manual.samples
    answers = [(r.layouts[0].descriptor, samples.data(r.layouts[0])) for r in samples.replies(f, call)]
    return codec.build(manual.model, packet[2], [(ACKNOWLEDGE, bytes([descriptor, 0])), *answers])


def questions(manual: Manual) -> dict[str, str]:
    """Packets of all commands and guides, any of which a program may send, and the replies."""
    commands = [f for f in asked(manual) if f.role == m.COMMAND]
    packets = [manual.samples.packet(f, c) for f in commands for c in f.calls]
    packets += [p for f in commands for p in ready(manual, f)]
    return {p.hex(): reply(manual, p).hex() for p in packets} | answers_of_guides(manual)


def sample(manual: Manual, f: m.Field) -> bytes:
    return manual.samples.packet(f)


def broken(manual: Manual, f: m.Field) -> list[bytes]:
    """Packets whose program must report an error: the field lacks a byte, or the packet cuts off its last one."""
    data = manual.samples.data(f)
    number = sample(manual, f)[2]
    lengths = [f.min_size] if f.min_size and manual.model.layouts(f) == (f,) else []
    cut = bytes([len(data) + 2, f.descriptor]) + data[:-1] if data else bytes([3, f.descriptor])
    payloads = [bytes([n + 1, f.descriptor]) + data[: n - 1] for n in lengths] + [cut]
    heads = [bytes((*manual.model.protocol.sync, number, len(x))) + x for x in payloads]
    return [head + codec.checksum(head) for head in heads]


def check(manual: Manual, output: str) -> None:
    """Each line: the name of a field, and what its program sent, or that it decoded data, or rejected broken data; or
    the name of a guide, and what its program sent, or that it came to its end."""
    found: dict[str, list[str]] = {}
    for line in output.splitlines():
        name, what = line.split()
        found.setdefault(name, []).append(what)
    for f in asked(manual):
        if f.role == m.COMMAND:
            wanted = [*(p.hex() for p in ready(manual, f)), "done"]
        else:
            wanted = ["done", *["refused"] * len(broken(manual, f))]
        assert found.get(f.full_name) == wanted, f.full_name
    others = asked_by_clients(manual)
    for name, _, sequence in plays(manual):
        sent = [what for what in found.get(name, ()) if what not in others]
        assert sent == [*(s.packet.hex() for s in sequence.steps), "done"], name


def answers_of_guides(manual: Manual) -> dict[str, str]:
    """The packets of all guides and the replies, which are the same in each guide."""
    answers: dict[str, str] = {}
    for step in (step for _, _, sequence in plays(manual) for step in sequence.steps):
        assert answers.setdefault(step.packet.hex(), step.answer.hex()) == step.answer.hex(), step.command.full_name
    return answers


def asked_by_clients(manual: Manual) -> set[str]:
    """Packets that a client may send by itself: they read whether another command is acknowledged."""
    found = set()
    for _, _, sequence in plays(manual):
        for f in (manual.model.field(c.command or "") for s in sequence.steps for c in s.command.silenced_by):
            assert f is not None
            call = next(c for c in f.calls if c.function and c.function.responds)
            found.add(SampleValues(manual.model).packet(f, call).hex())
    return found - answers_of_guides(manual).keys()


@pytest.fixture
def generated(manual: Manual, request: pytest.FixtureRequest) -> Path:
    return SPECS[request.node.callspec.params["manual"]][1]


def strings(given: list[bytes]) -> str:
    """The initializer of an array in C."""
    return ", ".join(['"' + x.hex() + '"' for x in given] + ['""'])


# --------------------------------------------------------------------------- C

C_HEAD = """
#include <stdio.h>
#include <string.h>
static const char *name;
static uint8_t answer[MIP_MAX_PACKET];
static const char *const *answers;
static bool done;
static uint8_t digit(char c) { return (uint8_t)(c <= '9' ? c - '0' : c - 'a' + 10); }
static size_t bytes_of(const char *hex, uint8_t *bytes) {
    size_t size = 0;
    for (; hex[2 * size]; size++) {
        bytes[size] = (uint8_t)(digit(hex[2 * size]) << 4 | digit(hex[2 * size + 1]));
    }
    return size;
}
static bool put(void *user, const uint8_t *bytes, size_t size) {
    (void)user;
    printf("%s ", name);
    for (size_t i = 0; i < size; i++) {
        printf("%02x", bytes[i]);
    }
    printf("\\n");
    return true;
}
static bool take(void *user, uint8_t *bytes, size_t size, size_t *count) {
    (void)user;
    *count = bytes_of(*answers++, answer);
    memcpy(bytes, answer, *count);
    return size >= *count;
}
static uint32_t now(void *user) { (void)user; return 0; }
static const struct mip_port port = {take, put, now, NULL};
static struct mip_device device_;
static struct mip_device *const device = &device_;
"""


#: The field of a packet.
DATA = """
uint8_t buffer[MIP_MAX_PACKET];
struct mip_packet packet;
struct mip_field field;
struct mip_walk walk;
if (mip_packet_check(buffer, bytes_of(hex, buffer), &packet) != MIP_OK) {
    return;
}
walk = mip_walk_packet(&packet);
if (!mip_walk_next(&walk, &field)) {
    printf("%s %s\\n", name, walk.error == MIP_OK ? "nothing" : "refused");
    return;
}
"""


@small
def test_programs_in_c(manual: Manual, generated: Path, tmp_path: Path) -> None:
    includes, functions, calls = {'#include "mip/device.h"'}, [], []
    for p in programs(manual, "c"):
        includes |= set(p.needs)
        name = f"f_{len(functions)}"
        if p.of == "guide":
            assert f"struct mip_result {p.name}(struct mip_device *device)" in p.body
            functions.append("static " + p.body)
            runs = [f"done = mip_succeeded({p.name}(device));"]
        elif p.of == m.COMMAND:
            body = p.body.replace("printf(", "fprintf(stderr, ")
            refused = "if (!mip_succeeded(result)) { puts(mip_result_reason(result)); return; }"
            functions.append(f"static void {name}(void) {{ \n{body}\n{refused} done = true; }}\n")
            runs = [f"{name}();"]
        else:
            body = p.body.replace("printf(", "done = true; fprintf(stderr, ")
            refused = 'if (!done) { printf("%s refused\\n", name); }'
            functions.append(f"static void {name}(const char *hex) {{ {DATA}\n{body}\n{refused} }}\n")
            runs = [f'{name}("{x.hex()}");' for x in p.given]
        begin = f'static const char *const a[] = {{{strings(p.given)}}}; answers = a; name = "{p.name}";'
        calls += [f'{{ {begin} done = false; {x} if (done) printf("%s done\\n", name); }}' for x in runs]
    source = tmp_path / "programs.c"
    main = ["int main(void) {", "mip_device_init(device, &port, 0, NULL);", *calls, "return 0; }"]
    source.write_text("\n".join([*sorted(includes), C_HEAD, *functions, *main]), "utf-8")
    flags = ["-std=c99", "-O0", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    library = sorted((generated / "c/src/mip").glob("*/*.c"))
    run(need("cc"), *flags, f"-I{generated}/c/src", source, *library, "-o", tmp_path / "programs")
    check(manual, run(tmp_path / "programs"))


# --------------------------------------------------------------------------- C++

CPP_HEAD = """
struct Port {
    std::optional<std::size_t> read(mip::span<std::uint8_t> room) {
        return bytes_of(*answers++, room.data());
    }
    bool write(mip::bytes packet) { return put(nullptr, packet.data(), packet.size()); }
    std::uint32_t now() { return 0; }
};
static Port port_;
static mip::device<> device_cpp(port_);
"""


@uses("g++")
@small
def test_programs_in_cpp(manual: Manual, generated: Path, tmp_path: Path) -> None:
    includes, functions, calls = {'#include "mip/cpp/device.hpp"'}, [], []
    for p in programs(manual, "cpp"):
        includes |= set(p.needs)
        name = f"f_{len(functions)}"
        if p.of == "guide":
            functions.append("static " + p.body)
            runs = [f"done = bool({p.name}(device_cpp));"]
        elif p.of == m.COMMAND:
            body = p.body.replace("std::cout", "std::cerr")
            for result in re.findall(r"const auto (result|answer) =", body):
                body += f'\nif (!{result}) {{ printf("%s\\n", {result}.reason().data()); return; }}'
            functions.append(f"static void {name}() {{ auto &device = device_cpp;\n{body}\ndone = true; }}\n")
            runs = [f"{name}();"]
        else:
            body = p.body.replace("std::cout", "done = true; std::cerr")
            refused = 'if (!done) { printf("%s refused\\n", name); }'
            functions.append(f"static void {name}(const mip::field &field) {{\n{body}\n{refused}\n}}\n")
            runs = [
                f'{{ const size_t n = bytes_of("{x.hex()}", buffer); const auto p = *mip::packet::from({{buffer, n}});'
                f' auto at = p.begin(); if (at == p.end()) printf("%s refused\\n", name); else {name}(*at); }}'
                for x in p.given
            ]
        begin = f'static const char *const a[] = {{{strings(p.given)}}}; answers = a; name = "{p.name}";'
        calls += [f'{{ {begin} done = false; {x} if (done) printf("%s done\\n", name); }}' for x in runs]
    main = ["int main() {", "uint8_t buffer[MIP_MAX_PACKET];", *calls, "return 0; }"]
    for x in sorted((generated / "c/src/mip").glob("*/*.c")):
        run(need("cc"), "-std=c99", "-O0", f"-I{generated}/c/src", "-c", x, "-o", tmp_path / f"{x.stem}.o")
    head = re.sub(r"static bool take.*", "", C_HEAD, flags=re.S)
    source = tmp_path / "programs.cpp"
    parts = [*sorted(includes), "#include <iostream>", head, CPP_HEAD, *functions, *main]
    source.write_text("\n".join(parts), "utf-8")
    flags = ["-std=c++17", "-pedantic-errors", "-O0", "-Wall", "-Wextra", "-Werror", "-Wno-unused"]
    flags.append(f"-I{generated}/c/src")
    if generated == SPECS["real"][1]:
        run(need("clang++"), *flags, "-fsyntax-only", source)
    run(need("g++"), *flags, source, *sorted(tmp_path.glob("*.o")), "-o", tmp_path / "programs")
    check(manual, run(tmp_path / "programs"))


# --------------------------------------------------------------------------- Python

PY_HEAD = """
import json
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from mip_protocol import DecodeError, Device, Packet, Stamp

ANSWERS: dict[str, str] = json.load(open(sys.argv[1]))
name = ""


class Port:
    def __init__(self) -> None:
        self.waiting: list[bytes] = []

    def write(self, data: Any) -> int:
        print(name, bytes(data).hex(), file=sys.stderr)
        self.waiting.append(bytes.fromhex(ANSWERS[bytes(data).hex()]))
        return len(data)

    def read(self, size: int) -> bytes:
        import time

        for _ in range(200):
            if self.waiting:
                return self.waiting.pop(0)
            time.sleep(0.001)
        return b""


class Source:
    \"\"\"Has one packet, as a device that was closed then.\"\"\"

    def __init__(self, packet: str) -> None:
        self.packet = Packet(bytes.fromhex(packet))

    def fields(self, kind: Any) -> Iterator[tuple[Stamp, Any]]:
        yield Stamp(0.0, "", 0.0), kind.find(self.packet)
"""


def called(p: Program) -> list[str]:
    """What a program in Python or JavaScript is called with."""
    return [f'source("{x.hex()}")' for x in p.given] if p.of == m.DATA else ["device"]


@small
def test_programs_in_python(manual: Manual, generated: Path, tmp_path: Path) -> None:
    functions, calls = [], []
    for p in programs(manual, "python"):
        name = f"f_{len(functions)}"
        lines = textwrap.indent("\n".join([*p.needs, p.body]), "    ")
        functions.append(f"def {name}(device: Device) -> None:\n{lines}\n")
        calls.append(f'    name = "{p.name}"\n')
        calls += [f"    attempt({name}, {device})\n" for device in called(p)]
    main = (
        "def source(packet: str) -> Any:\n    return Source(packet)\n\n\n"
        "def attempt(program: Any, device: Any) -> None:\n"
        "    try:\n        program(device)\n        print(name, 'done', file=sys.stderr)\n"
        "    except DecodeError:\n        print(name, 'refused', file=sys.stderr)\n\n\n"
        "if __name__ == '__main__':\n    device = Device(Port())\n"
        + "".join(calls)
        + "    import os\n\n    os._exit(0)\n"
    )
    path = tmp_path / "programs.py"
    path.write_text("\n\n".join([PY_HEAD, *functions, main]), "utf-8")
    (tmp_path / "answers.json").write_text(json.dumps(questions(manual)))
    done = subprocess.run(
        [sys.executable, path, tmp_path / "answers.json"],
        env={**os.environ, "PYTHONPATH": str(generated / "python")}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-4000:]
    check(manual, done.stderr)
    checked = mypy(generated / "python", path)
    assert checked.returncode == 0, checked.stdout


# --------------------------------------------------------------------------- Rust

RUST_HEAD = """
#![allow(warnings)]
use mip_protocol::device::{Device, DeviceError, Port};
use mip_protocol::{packets, DecodeError, Packet};

struct Table {
    name: &'static str,
    answers: Vec<Vec<u8>>,
}

impl Port for Table {
    type Error = ();
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, ()> {
        let answer = if self.answers.is_empty() { Vec::new() } else { self.answers.remove(0) };
        buffer[..answer.len()].copy_from_slice(&answer);
        Ok(answer.len())
    }
    fn write(&mut self, bytes: &[u8]) -> Result<(), ()> {
        let hex: String = bytes.iter().map(|b| format!("{b:02x}")).collect();
        eprintln!("{} {hex}", self.name);
        Ok(())
    }
    fn now_ms(&mut self) -> u32 {
        0
    }
}

type Outcome = Result<(), DeviceError<()>>;

fn table(name: &'static str, answers: &[&[u8]]) -> Device<Table> {
    Device::new(Table { name, answers: answers.iter().map(|a| a.to_vec()).collect() })
}
"""


def rust_bytes(data: bytes) -> str:
    return f"&[{', '.join(map(str, data))}]"


@pytest.mark.xdist_group("cargo")
@small
def test_programs_in_rust(manual: Manual, request: pytest.FixtureRequest) -> None:
    functions, calls = [], []
    for p in programs(manual, "rust"):
        name, lines = f"f_{len(functions)}", "\n".join([*p.needs, p.body])
        if p.of == m.DATA:
            seen = lines.rstrip().removesuffix("}") + f'eprintln!("{p.name} done");\n}}'
            assert lines.rstrip().endswith("}")
            functions.append(f"fn {name}(packet: Packet) -> Result<(), DecodeError> {{\n{seen}\nOk(())\n}}")
            good, *bad = map(rust_bytes, p.given)
            calls.append(f"{name}(Packet::new({good}).unwrap()).unwrap();")
            refused = f'.unwrap()).is_err() {{ eprintln!("{p.name} refused"); }}'
            calls += [f"if {name}(Packet::new({x}){refused}" for x in bad]
        else:
            functions.append(f"fn {name}(mut device: Device<Table>) -> Outcome {{\n{lines}\nOk(())\n}}")
            answers = ", ".join(map(rust_bytes, p.given))
            calls.append(f'{name}(table("{p.name}", &[{answers}])).unwrap(); eprintln!("{p.name} done");')
    source = "\n".join([RUST_HEAD, *functions, "fn main() {", *calls, "}"])
    target = '[[bin]]\nname = "reference"\npath = "reference.rs"\ntest = false\n'
    spec = request.node.callspec.params["manual"]
    folder = crates.project(spec, "reference", target, files={"reference.rs": source.encode()})
    done = crates.cargo(folder, "run", "--offline", "--quiet")
    assert done.returncode == 0, done.stderr[-6000:]
    check(manual, done.stderr)


# --------------------------------------------------------------------------- JavaScript

JS_HEAD = """
import fs from "node:fs";
import { Device, fromHex, MipError, Packet, toHex } from "mip-protocol";
let name = "";
const said = (...words) => process.stderr.write(`${name} ${words.join(" ")}\\n`);
const answers = JSON.parse(fs.readFileSync("answers.json", "utf8"));
/** A device that gives these answers. */
async function opened() {
    const waiting = [];
    let wake = () => {};
    const port = {
        async *bytes() {
            for (;;) {
                if (waiting.length) yield waiting.shift();
                else await new Promise((resolve) => { wake = resolve; });
                if (waiting.at(-1) === null) return;
            }
        },
        async write(bytes) {
            said(toHex(bytes));
            waiting.push(fromHex(answers[toHex(bytes)]));
            wake();
        },
        async close() {
            waiting.push(null);
            wake();
        },
    };
    return Device.open(async () => port);
}
/** Has one packet, as a device that was closed then. */
const source = (hex) => ({
    async *fields(kind) {
        yield* Packet.from(fromHex(hex)).findAll(kind);
    },
});
async function attempt(program, device) {
    try {
        await program(device);
        said("done");
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        said("refused");
    }
}
const device = await opened();
"""


@uses("node")
@small
def test_programs_in_javascript(manual: Manual, generated: Path, tmp_path: Path) -> None:
    (tmp_path / "answers.json").write_text(json.dumps(questions(manual)))
    (tmp_path / "node_modules").mkdir()
    (tmp_path / "node_modules/mip-protocol").symlink_to(generated / "javascript")
    main = [JS_HEAD]
    for i, p in enumerate(programs(manual, "javascript")):
        needs, inner = "\n".join(p.needs), textwrap.indent(p.body, "    ")
        (tmp_path / f"program_{i}.mjs").write_text(f"{needs}\nexport async function program(device) {{\n{inner}\n}}\n")
        main.append(f'name = "{p.name}";')
        main += [f'await attempt((await import("./program_{i}.mjs")).program, {device});' for device in called(p)]
    main.append("await device.close();")
    (tmp_path / "main.mjs").write_text("\n".join(main), "utf-8")
    done = subprocess.run([need("node"), "main.mjs"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-4000:]
    check(manual, done.stderr)
