"""Columns of a log with NumPy, relative to a hand-written loop: `python tests/bench/bench_columns.py`.

The loop unpacks each field with a fixed struct, keeps the values in lists, and checks no checksum.
All run in turn, measured in the CPU time of this process; the median of the ratios counts. The compiled code is the
innermost loops, which platform wheels include.
"""

from __future__ import annotations

import random
import statistics
import struct
import subprocess
import sys
import time
from collections.abc import Callable
from itertools import accumulate
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "generated/python"))
sys.path.insert(0, str(Path(__file__).parents[2] / "tools"))

from mip_protocol import filter_data, sensor, shared
from mip_tools.columns import native, read_log

PACKETS = 600_000
ROUNDS = 7

FORMS = {(s, d): ">Q" for s in (0x80, 0x82, 0xA0) for d in (0xD5, 0xD6)} | {
    (0x80, 0x04): ">3f", (0x80, 0x05): ">3f", (0x80, 0x06): ">3f", (0x80, 0x0C): ">3f", (0x82, 0x05): ">3fH",
}  # fmt: skip
TYPES = (
    sensor.ScaledAccel, sensor.ScaledGyro, sensor.ScaledMag, sensor.CompEulerAngles, filter_data.EulerAngles,
    shared.ReferenceTimestamp, shared.ReferenceTimeDelta,
)  # fmt: skip


def packet(number: int, fields: list[bytes]) -> bytes:
    payload = b"".join(fields)
    head = bytes((0x75, 0x65, number, len(payload))) + payload
    return head + bytes((sum(head) & 255, sum(accumulate(head)) & 255))


def stream(packets: int, shuffled: bool = False) -> bytes:
    """Sensor packets of varying fields, filter and system packets, in turn or in any order; 44 bytes on average."""
    rng, out = random.Random(1), []
    for i in range(packets // 3):
        vectors = [
            bytes((14, d)) + struct.pack(">3f", *(rng.gauss(0, 1) for _ in range(3)))
            for d, share in ((0x04, 0.9), (0x05, 0.9), (0x06, 0.7), (0x0C, 0.7))
            if rng.random() < share
        ]
        now = b"\x0a\xd5" + struct.pack(">Q", i * 1_000_000)
        step = b"\x0a\xd6" + struct.pack(">Q", 1_000_000)
        out.append(packet(0x80, [*vectors, now, *([step] if rng.random() < 0.5 else [])]))
        out.append(packet(0x82, [b"\x10\x05" + struct.pack(">3fH", 0.1, 0.2, rng.random(), 1), now]))
        out.append(packet(0xA0, [now, step]))
    if shuffled:
        rng.shuffle(out)
    return b"".join(out)


def by_hand(data: bytes) -> dict[tuple[int, int], list[tuple[float, ...]]]:
    unpack = {key: struct.Struct(form).unpack_from for key, form in FORMS.items()}
    rows: dict[tuple[int, int], list[tuple[float, ...]]] = {key: [] for key in FORMS}
    at, end = 0, len(data)
    while at < end:
        number, place = data[at + 2], at + 4
        stop = place + data[at + 3]
        while place < stop:
            key = number, data[place + 1]
            rows[key].append(unpack[key](data, place + 2))
            place += data[place]
        at = stop + 2
    return rows


def three(data: bytes) -> object:
    columns = read_log(data).columns([sensor.ScaledAccel, sensor.ScaledGyro, filter_data.EulerAngles])
    return columns, [column.time("reference") for column in columns]


def frame(data: bytes) -> object:
    return read_log(data).frame([sensor.ScaledAccel, sensor.ScaledGyro])


TASKS: dict[str, tuple[Callable[[bytes], object], int]] = {
    "index: packets by set and length": (lambda data: read_log(data).packets, 14),
    "index, time and three fields": (three, 10),
    "all columns": (lambda data: read_log(data).columns(TYPES), 8),
    "pandas frame of two fields": (frame, 0),
    "types, counts and rates": (lambda data: read_log(data).types(), 0),
}


def seconds(task: Callable[[bytes], object], data: bytes) -> float:
    begin = time.process_time()
    kept = task(data)  # freed after the time is taken
    took = time.process_time() - begin
    del kept
    return took


def kernels() -> dict[str, native.Kernel | None]:
    """NumPy alone, and the compiled code if there is a compiler."""
    folder = Path(__file__).parents[2] / "build/bench"
    folder.mkdir(parents=True, exist_ok=True)
    source, made = Path(native.__file__).with_name("kernel.c"), folder / "_kernel.so"
    try:
        subprocess.run(["cc", "-std=c99", "-O3", "-shared", "-fPIC", "-o", made, source], check=True)
        return {"NumPy": None, "compiled": native.Kernel(made)}
    except (OSError, subprocess.CalledProcessError):
        return {"NumPy": None}


def report() -> str:
    lines, ways = [], kernels()
    for shuffled in (False, True):
        data = stream(PACKETS, shuffled)
        order = "shuffled packets" if shuffled else "packets in their order"
        lines += [f"\ncolumns, {len(data) / 1e6:.0f} MB of {order}, {len(data) / PACKETS:.0f} bytes each", ""]
        lines.append(f"{'':46}{'MB/s':>8}{'to loop':>9}{'aim':>6}")
        cases = [(f"{name}, {way}", task, aim, way) for name, (task, aim) in TASKS.items() for way in ways]
        ratios: dict[str, list[float]] = {name: [] for name, *_ in cases}
        speeds: dict[str, list[float]] = {name: [] for name, *_ in cases}
        loops = []
        for _ in range(ROUNDS):
            loops.append(seconds(by_hand, data))
            for name, task, _, way in cases:
                native.kernel = ways[way]
                took = seconds(task, data)
                ratios[name].append(loops[-1] / took)
                speeds[name].append(len(data) / took / 1e6)
        lines.append(f"{'loop written by hand':46}{len(data) / statistics.median(loops) / 1e6:8.0f}{1:9.1f}")
        for name, _, aim, _ in cases:
            figure = f"{statistics.median(speeds[name]):8.0f}{statistics.median(ratios[name]):9.1f}"
            lines.append(f"{name:46}{figure}{aim or '':>6}")
    return "\n".join(lines)


if __name__ == "__main__":
    print(report())
