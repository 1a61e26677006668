"""`make bench`: the same stream through all languages, side by side. Figures to read, never a test.

Each program runs several times, in turn with the others; the median of its runs counts, and the
ratio to C. A hand-written loop with struct.unpack shows the best that Python could do. Before that, C and Rust are
compared with hand-written code: bench_c.py, bench_rust.py.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import struct
import subprocess
import sys
from pathlib import Path

import bench_c
import bench_c_peer
import bench_rust

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
BUILD = ROOT / "build/bench"
PACKETS = 20_000
ROUNDS = 7

BY_HAND = """
import struct, sys, time
data = open(sys.argv[1], 'rb').read()
unpack, size, total = struct.Struct('>3f').unpack_from, 34, 0.0
begin = time.perf_counter_ns()
for at in range(0, len(data), size):
    total += unpack(data, at + 6)[0] + unpack(data, at + 20)[0]
print('nan', (time.perf_counter_ns() - begin) / (len(data) // size))
"""


def stream() -> bytes:
    """Accelerations and angular rates, as a device sends them."""
    out = bytearray()
    for i in range(PACKETS):
        fields = b"".join(bytes((14, d)) + struct.pack(">3f", 1.0, i, -i) for d in (4, 5))
        head = b"ue\x80" + bytes([len(fields)]) + fields
        a = b = 0
        for byte in head:
            a = (a + byte) & 255
            b = (b + a) & 255
        out += head + bytes((a, b))
    return bytes(out)


def programs() -> dict[str, list[str]]:
    """Name -> command, built for speed."""
    c, rust = ROOT / "generated/c", ROOT / "generated/rust"
    flags = ["-std=gnu99", "-O2", f"-I{c}/src"]
    sources = [str(p) for p in sorted((c / "src/mip").glob("*.c"))]
    subprocess.run(["cc", *flags, str(HERE / "bench.c"), *sources, "-o", str(BUILD / "bench-c")], check=True)
    crate = BUILD / "rust"
    (crate / "src").mkdir(parents=True, exist_ok=True)
    shutil.copy(HERE / "bench.rs", crate / "src/main.rs")
    (crate / "Cargo.toml").write_text(
        '[package]\nname = "bench"\nversion = "0.0.0"\nedition = "2021"\n\n[workspace]\n\n'
        f'[dependencies]\nmip-protocol = {{ path = "{rust}" }}\n'
    )
    environment = {**os.environ, "CARGO_TARGET_DIR": str(BUILD / "target")}
    subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=crate, check=True, env=environment)
    return {
        "C": [str(BUILD / "bench-c")],
        "Rust": [str(BUILD / "target/release/bench")],
        "Python": [sys.executable, str(HERE / "bench_python.py")],
        "Python, struct by hand": [sys.executable, "-c", BY_HAND],
    }


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--readme", action="store_true")
    arguments.add_argument("--peer", type=Path, help="a folder of the vendor's SDK: this comparison only")
    given = arguments.parse_args()
    if given.peer:
        text = bench_c_peer.report(given.peer)
        print(text)
        if given.readme:
            (ROOT / "docs/parts/bench_c_peer.md").write_text(text, "utf-8")
        return
    if given.readme:
        bench_c.write_readme()
        bench_rust.write_readme()
        return
    print(bench_c.report())
    print(bench_rust.report())
    subprocess.run([sys.executable, str(HERE / "bench_columns.py")], check=True)
    BUILD.mkdir(parents=True, exist_ok=True)
    log = BUILD / "stream.bin"
    log.write_bytes(stream())
    commands = programs()
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT / "tools"), str(ROOT / "generated/python")))}
    figures: dict[str, list[tuple[float, float]]] = {name: [] for name in commands}
    for _ in range(ROUNDS):
        for name, command in commands.items():
            done = subprocess.run([*command, str(log)], capture_output=True, text=True, check=True, env=environment)
            parse, both = map(float, done.stdout.split())
            figures[name].append((parse, both))
    print(f"{PACKETS} packets of 34 bytes, two fields each; median of {ROUNDS} runs, nanoseconds for each packet\n")
    print(f"{'':24}{'parse':>10}{'to C':>8}{'and decode':>14}{'to C':>8}")
    base = [statistics.median(column) for column in zip(*figures["C"], strict=True)]
    for name, runs in figures.items():
        parse, both = (statistics.median(column) for column in zip(*runs, strict=True))
        first = f"{parse:10.0f}{parse / base[0]:8.1f}" if parse == parse else f"{'-':>10}{'-':>8}"
        print(f"{name:24}{first}{both:14.0f}{both / base[1]:8.1f}")
    print("\nPython: " + subprocess.check_output([sys.executable, str(HERE / "bench_python_objects.py")], text=True,
                                                   env=environment))  # fmt: skip
    live = [sys.executable, str(HERE / "bench_live.py")]
    print(subprocess.check_output(live, text=True, env=environment), end="")
    device = [sys.executable, str(HERE / "bench_device.py")]
    shares = [subprocess.check_output(device, text=True, env=environment) for _ in range(ROUNDS)]
    share = statistics.median(map(float, shares))
    print(f"\nthe virtual device, six fields at 1 kHz: {share:.1f} % of a core")


if __name__ == "__main__":
    main()
