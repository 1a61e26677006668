"""Rust: how fast beside a plain safe loop that uses no library, this project's C, and another crate; how large in
firmware.

All are measured in one run, in turns, and the best of many rounds counts. The plain loops are in speed.rs; their
checksum is the simplest one that compilers make fast. The other crate, in peer.rs, comes from crates.io, for this
measurement only. `make bench README=1` writes the result into the README of the crate.
"""

from __future__ import annotations

import os
import platform
import re
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import streams
from bench_c import BUILD, HERE, ROOT, SOURCES, Row, library, measure, run, table, version
from mipgen.resolve.load import load_model

CRATE = ROOT / "generated/rust"
README = ROOT / "docs/parts/bench_rust.md"
#: Bytes of a stream: more than a cache holds; and for counting instructions.
SIZE, COUNTED = 16_000_000, 1_000_000
#: Many short turns, over the whole run: the processor is shared, and each function needs some when the rest is idle.
ROUNDS, TURNS = 3, 50
EMBEDDED = "thumbv7em-none-eabi"

#: The other crate.
PEER, PEER_VERSION = "microstrain-inertial", "0.0.2"


class Measured(NamedTuple):
    title: str
    ours: str
    #: The plain loop that does the same; empty if there is none.
    plain: str
    #: Functions of speed.c and of peer.rs that do the same; empty if none does.
    c: str = ""
    peer: str = ""


ROWS = (
    Measured("parse a slice: `packets`", "slice", "bare", "ours_whole", "peer"),
    Measured("parse, in chunks of 4 KiB: `Parser::feed`", "parse", "bare_parse", "ours_parse", "peer"),
    Measured("parse, in chunks of 64 bytes", "small", "bare_small", "ours_small", "peer"),
    Measured("parse, byte by byte", "bytewise", "", "ours_bytewise", "peer"),
    Measured("parse: `PacketReader`", "reader", "bare_parse", "ours_read", "peer"),
    Measured("parse: `Device::next_packet`", "device", "bare_parse", "", "peer"),
    Measured("parse, decode every field: `get`", "get", "bare_get", peer="peer_get"),
    Measured("parse, decode every field: `Visitor`", "visitor", "bare_get", "ours_registry", "peer_get"),
    Measured("parse, decode every field: `AnyField`", "any", "bare_get", "ours_registry", "peer_get"),
    Measured("parse, three fields: `find`", "find", "bare_find"),
    Measured("build packets of three fields: `clear`, `push`", "encode", "bare_encode"),
)
FIRMWARE = """#![no_std]
#![no_main]
use core::panic::PanicInfo;
{uses}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {{
    loop {{}}
}}

/// Where bytes come from and go to.
#[inline(never)]
fn port() -> &'static mut [u8] {{
    let place = core::hint::black_box(0x2000_0000 as *mut u8);
    unsafe {{ core::slice::from_raw_parts_mut(place, 64) }}
}}

#[no_mangle]
pub extern "C" fn _start() -> ! {{
    {start}
    loop {{
        let bytes = port();
        {work}
        core::hint::black_box(bytes);
    }}
}}
"""

PARSE = "let mut rest = &*bytes; while let Some(packet) = parser.next(&mut rest) {{ {each} }}"
FIELDS = "".join(
    f"if let Ok(Some(v)) = field.get::<sensor::{name}>() {{ core::hint::black_box(v); }}"
    for name in ("ScaledAccel", "ScaledGyro", "GpsTimestamp")
)
CLIENT = """
        let Ok((ping, packet)) = client.send(&base::Ping::new(), 0) else { continue };
        core::hint::black_box(packet.bytes());
        let Ok((info, packet)) = client.send(&base::GetDeviceInfo::new(), 0) else { continue };
        core::hint::black_box(packet.bytes());
        let mut received = &*port();
        while let Some(packet) = parser.next(&mut received) {
            for event in client.receive(&packet) {
                if let Some(Ok(response)) = event.answer(&ping) {
                    core::hint::black_box(response);
                }
                if let Some(Ok(response)) = event.view(&info) {
                    core::hint::black_box(response);
                }
            }
        }
        while let Some(packet) = client.poll(parser, 1_000) {
            core::hint::black_box(client.receive(&packet).count());
        }
"""

#: Where bytes come from and go to, as a port with a baud rate.
PORT = """
struct Uart;

impl Port for Uart {
    type Error = ();

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, ()> {
        Ok(core::hint::black_box(buffer).len())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), ()> {
        core::hint::black_box(bytes);
        Ok(())
    }

    fn now_ms(&mut self) -> u32 {
        core::hint::black_box(0)
    }

    fn set_baud(&mut self, rate: u32) -> Result<bool, ()> {
        core::hint::black_box(rate);
        Ok(true)
    }
}
"""
RATES = """
        core::hint::black_box(device.connect(&[115_200, 921_600]).is_ok());
        let rates = [Rate::of::<ScaledAccel>(100.0), Rate::of::<ScaledGyro>(100.0)];
        core::hint::black_box(device.stream(sensor::SET, &rates).is_ok());
"""

#: They are static, as in firmware: the start-up code clears the memory.
PARSER = "static mut PARSER: Parser = Parser::new();"
PARSER_AND_CLIENT = f"{PARSER}\nstatic mut CLIENT: Client<2> = Client::with_timeout(1000);"
DEVICE = "static mut DEVICE: Device<Uart, 1, 600> = Device::with_client(Uart, Client::with_timeout(1000));"
BORROW = "let {} = unsafe {{ &mut *core::ptr::addr_of_mut!({}) }};\n    "
FIRMWARES = {
    "empty": ("", "", ""),
    "parser": (
        f"use mip_protocol::Parser;\n{PARSER}",
        BORROW.format("parser", "PARSER"),
        PARSE.format(each="core::hint::black_box(packet.set());"),
    ),
    "parser, three fields": (
        f"use mip_protocol::{{sensor, Parser}};\n{PARSER}",
        BORROW.format("parser", "PARSER"),
        PARSE.format(each=f"for field in packet.fields().flatten() {{ {FIELDS} }}"),
    ),
    "parser, client, two commands": (
        f"use mip_protocol::{{base, Client, Parser}};\n{PARSER_AND_CLIENT}",
        BORROW.format("parser", "PARSER") + BORROW.format("client", "CLIENT"),
        CLIENT,
    ),
    "device: `connect`, `stream`": (
        "use mip_protocol::{device::{Device, Port}, sensor::{self, ScaledAccel, ScaledGyro}, session::Rate, Client};"
        f"\n{PORT}\n{DEVICE}",
        BORROW.format("device", "DEVICE"),
        RATES,
    ),
}  # fmt: skip


def project(name: str, manifest: str, files: dict[str, str]) -> Path:
    folder = BUILD / name
    (folder / "src").mkdir(parents=True, exist_ok=True)
    head = f'[package]\nname = "{name}"\nversion = "0.0.0"\nedition = "2021"\n\n[workspace]\n\n[dependencies]\n'
    (folder / "Cargo.toml").write_text(f"{head}{manifest}")
    for file, text in files.items():
        (folder / "src" / file).write_text(text)
    return folder


def cargo(folder: Path, *arguments: str) -> None:
    command = ["cargo", arguments[0], "--quiet", *arguments[1:]]
    environment = {**os.environ, "CARGO_TARGET_DIR": str(BUILD / "target")}
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment)
    if done.returncode:
        raise SystemExit(f"{' '.join(command)}: {done.stderr[-3000:]}")


# --------------------------------------------------------------------------- speed


def programs() -> tuple[Path, Path, str]:
    """The program in Rust, the one in C, and why the other crate is not in the first one."""
    flags = ["-std=gnu99", "-O2", f"-I{SOURCES}", f"-I{HERE}"]
    run("cc", *flags, HERE / "speed.c", *library(), "-o", BUILD / "speed")
    ours = f'mip-protocol = {{ path = "{CRATE}", features = ["std"] }}\n'
    peer = f'{PEER} = {{ version = "={PEER_VERSION}", default-features = false, features = ["std"] }}\n'
    files = {name: (HERE / name).read_text() for name in ("speed.rs", "peer.rs")}
    files["main.rs"] = files.pop("speed.rs")
    folder = project("speed-rust", f"{ours}{peer}\n[features]\ndefault = ['peer']\npeer = []\n", files)
    missing = subprocess.run(["cargo", "fetch"], cwd=folder, capture_output=True, text=True)
    if missing.returncode:
        project("speed-rust", f"{ours}\n[features]\npeer = []\n", files)
    cargo(folder, "build", "--release")
    return BUILD / "target/release/speed-rust", BUILD / "speed", missing.stderr if missing.returncode else ""


def instructions(program: Path, stream: Path, function: str) -> float:
    """The instructions of one round; NaN without valgrind."""
    if shutil.which("valgrind") is None:
        return float("nan")
    counts = []
    for rounds in "12":
        out = run("valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, stream, function, rounds)
        (count,) = re.findall(r"Collected : (\d+)", out)
        counts.append(int(count))
    return float(counts[1] - counts[0])


def ratio(other: float | None, own: float) -> str:
    """How many times as long the other one takes."""
    if other is None or other != other or own != own:
        return ""
    return f"{other / own:.{2 if other < 10 * own else 0}f}"


def speed() -> tuple[list[Row], dict[str, float], str]:
    """The rows of the table; the times with the recording; why the columns of the other crate are empty."""
    recording = streams.recording(load_model(ROOT / "spec"), SIZE)
    contents = {"recording": recording, "shuffled": streams.shuffled(recording), "counted": recording[:COUNTED]}
    paths = {name: BUILD / f"{name}.bin" for name in contents}
    for name, content in contents.items():
        paths[name].write_bytes(content)
    rust, c, missing = programs()
    times: dict[str, dict[str, float]] = {"recording": {}, "shuffled": {}}
    for name, found in [*times.items()] * TURNS:
        turn: dict[str, float] = {}
        for plain in dict.fromkeys(row.plain for row in ROWS):
            rows = [row for row in ROWS if row.plain == plain]  # they all return the same
            functions = {f: rust for row in rows for f in (row.ours, row.plain) if f}
            if name == "recording":
                functions |= {row.c: c for row in rows if row.c}
                functions |= {} if missing else {row.peer: rust for row in rows if row.peer}
            turn |= measure(paths[name], {f: p for f, p in functions.items() if f not in turn}, 1, ROUNDS)
        found |= {function: min(time, found.get(function, time)) for function, time in turn.items()}
    names = dict.fromkeys(f for row in ROWS for f in (row.ours, row.plain, "" if missing else row.peer) if f)
    counts = {name: instructions(rust, paths["counted"], name) for name in names}
    out = []
    for row in ROWS:
        line = [ratio(times[name].get(row.plain), times[name][row.ours]) for name in times]
        line.append(ratio(counts.get(row.plain), counts[row.ours]))
        line += [ratio(times["recording"].get(other), times["recording"][row.ours]) for other in (row.c, row.peer)]
        line.append(ratio(counts.get(row.peer), counts[row.ours]))
        line += [f"{len(contents[name]) / times[name][row.ours]:.2f}" for name in times]
        out.append([row.title, *line])
    return out, times["recording"], missing


# --------------------------------------------------------------------------- size


def sizes() -> list[Row]:
    """Bytes of code and constants above an empty program, and how many of them only copy and clear memory."""
    installed = run("rustup", "target", "list", "--installed")
    if EMBEDDED not in installed.split() or shutil.which("arm-none-eabi-nm") is None:
        return []
    found = {}
    for name, (uses, start, work) in FIRMWARES.items():
        manifest = f'mip-protocol = {{ path = "{CRATE}" }}\n\n[profile.release]\nopt-level = "z"\nlto = true\n'
        manifest += 'codegen-units = 1\npanic = "abort"\n'
        source = FIRMWARE.format(uses=uses, start=start, work=work)
        folder = project("firmware", manifest, {"main.rs": source})
        cargo(folder, "rustc", "--release", "--target", EMBEDDED, "--", "-Clink-arg=--gc-sections")
        program = BUILD / f"target/{EMBEDDED}/release/firmware"
        found[name] = loaded(program), runtime(program)
    (empty, _) = found.pop("empty")
    return [[name, f"{size - empty} B", f"{own} B"] for name, (size, own) in found.items()]


def loaded(program: Path) -> int:
    """Sizes of .text, .rodata and .data."""
    sections = run("arm-none-eabi-size", "-A", program)
    return sum(int(size) for size in re.findall(r"^\.(?:text|rodata|data)\b\S* +(\d+)", sections, re.M))


def runtime(program: Path) -> int:
    """Sizes of memcpy and the like, which belong to Rust and are there once in a program."""
    symbols = run("arm-none-eabi-nm", "-S", program)
    found = re.findall(r"^(\w+) (\w+) \w \S*mem(?:cpy|move|set|clr)", symbols, re.M)
    return sum(int(size, 16) for size in dict(found).values())


# --------------------------------------------------------------------------- report


def report(readme: bool = False) -> str:
    """As Markdown. The last two columns depend on the machine: the README omits them."""
    BUILD.mkdir(parents=True, exist_ok=True)
    heads = ["Speed", "Plain loop", "shuffled", "instructions", "C", "Other crate", "instructions"]
    heads += ["GB/s", "GB/s, shuffled"]
    columns = 7 if readme else 9
    machine = platform.machine().replace("_", "-")
    compiler = run("rustc", "--version").split()[1]
    rows, times, missing = speed()
    if missing and readme:
        raise SystemExit(f"bench: the README needs the crate {PEER}: {missing}")
    out = f"Rust {compiler}, default release profile, on {machine}; C by {version('cc')}, `-O2`. The ratios say\n"
    out += "how many times as fast the crate is as a plain safe loop without any library, as C from the same\n"
    out += f"specification, and as another crate, [{PEER}](https://crates.io/crates/{PEER}) {PEER_VERSION},\n"
    out += "which takes single bytes; or how many times as many instructions those execute. The stream is like a\n"
    out += f"recording: {SIZE // 1_000_000} MB, more than a cache holds, and 43 % of its fields are shared ones.\n"
    out += "Shuffled, its packets are in random order, so that branches cannot be predicted.\n\n"
    out += "The plain loop has all bytes in memory. In the rows for chunks, `PacketReader` and `Device`, it\n"
    out += "joins chunks in a `Vec`. Where fields are decoded, the plain loop has all bytes, and the crate gets\n"
    out += "chunks of 4 KiB. The crate copies a packet that a chunk cuts: parsing in chunks of 64 bytes takes\n"
    out += f"{ratio(times['small'], times['slice'])} times as long as parsing one slice.\n\n"
    out += table(heads[:columns], [row[:columns] for row in rows])
    if missing:
        out += f"\nThe other crate, {PEER}, cannot be fetched, and its columns are empty: {missing}\n"
    small = sizes()
    if not small:
        return out + f"\nSizes need the target {EMBEDDED}, which is missing (rustup target add {EMBEDDED}).\n"
    out += f'\nFor {EMBEDDED}, `opt-level = "z"` and `lto = true`; above an empty program. `memcpy` and the\n'
    out += "like are those of Rust.\n\n"
    return out + table(["Size", "Code and constants", "of that, `memcpy` and the like"], small)


def write_readme() -> None:
    if EMBEDDED not in run("rustup", "target", "list", "--installed").split():
        raise SystemExit(f"bench: the README needs the target {EMBEDDED} (rustup target add {EMBEDDED})")
    README.write_text(report(readme=True), "utf-8")
    print(f"{README.relative_to(ROOT)} is written; now: make generate golden")


if __name__ == "__main__":
    print(report())
