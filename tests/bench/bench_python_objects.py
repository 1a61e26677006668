"""Python against Python: packets, objects and noise, relative to the loop written by hand of bench_columns.py.

All run in one process, in turn, over the same streams.
"""

from __future__ import annotations

import os
import random
import statistics
import subprocess
import sys
from collections.abc import Callable

try:
    import construct
except ImportError:  # a development tool; without it, its line is left out
    construct = None

from bench_columns import FORMS, by_hand, seconds, stream
from mip_protocol import Decoder, Parser, registry

SIZE = 1 << 21
PACKETS = 48_000
ROUNDS = 9


def parse(data: bytes) -> object:
    return Parser().feed(data)


def objects(data: bytes) -> object:
    return Decoder().feed(data)


def parse_and_decode(data: bytes) -> object:
    return [registry.decode_packet(packet) for packet in Parser().feed(data)]


def with_construct() -> Callable[[bytes], object] | None:
    """The same packets, as `construct` describes them."""
    if construct is None:
        return None
    c = construct
    kinds = {">3f": c.Float32b[3], ">Q": c.Int64ub, ">3fH": c.Sequence(c.Float32b[3], c.Int16ub)}
    values = {s << 8 | d: kinds[layout] for (s, d), layout in FORMS.items()}
    field = c.Struct(
        "size" / c.Byte, "descriptor" / c.Byte,
        "value" / c.FixedSized(c.this.size - 2, c.Switch(lambda x: x._._.set << 8 | x.descriptor, values)),
    )  # fmt: skip
    packet = c.Struct(
        c.Const(b"ue"), "set" / c.Byte, "size" / c.Byte,
        "fields" / c.FixedSized(c.this.size, c.GreedyRange(field)), "checksum" / c.Int16ub,
    )  # fmt: skip
    return c.GreedyRange(packet).parse  # type: ignore[no-any-return]


def dense(gap: int) -> bytes:
    """Noise that does not repeat, with the start of a packet every `gap` bytes."""
    chance = random.Random(gap)
    return b"".join(b"ue" + chance.randbytes(gap - 2) for _ in range(SIZE // gap))


def imports(module: str) -> float:
    """CPU time of an import in a new process, in milliseconds, without the start of Python."""
    code = f"import time; t = time.process_time(); import {module}; print((time.process_time() - t) * 1e3)"
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    runs = [float(subprocess.check_output([sys.executable, "-c", code], env=environment)) for _ in range(ROUNDS)]
    return min(runs[1:])


def report() -> str:
    original = stream(PACKETS)
    noise = {
        "noise 75 65 01 FF": b"ue\x01\xff" * (SIZE // 4),
        "noise, random bytes": random.Random(2).randbytes(SIZE),
        "noise, 75 65 every 22 bytes": dense(22),
        "noise, 75 65 every 8 bytes": dense(8),
        "noise, NMEA": b"$GPGGA,123519.00,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n" * (SIZE // 70),
    }
    lines: dict[str, tuple[Callable[[bytes], object], bytes]] = {}
    for order, data in {"original order": original, "shuffled": stream(PACKETS, shuffled=True)}.items():
        for work in (by_hand, parse, objects, parse_and_decode):
            lines[f"{work.__name__}, {order}"] = (work, data)
    lines |= {name: (parse, data) for name, data in noise.items()}
    slow = with_construct()
    if slow:
        lines["construct"] = (slow, original[: len(original) // 64])
    figures: dict[str, list[float]] = {name: [] for name in lines}
    for _ in range(ROUNDS):
        for name, (work, data) in lines.items():
            figures[name].append(len(data) / seconds(work, data) / 1e6)
    unit = statistics.median(figures["by_hand, original order"])
    said = [f"{PACKETS} packets of {len(original) / PACKETS:.1f} bytes; in units of the loop written by hand\n"]
    for name, runs in figures.items():
        median = statistics.median(runs)
        said.append(f"{name:36}{median:10.1f} MB/s{median / unit:8.2f}")
    for module in ("mip_protocol", "mip_protocol.sensor", "mip_protocol.mip_3dm"):
        said.append(f"{'import ' + module:36}{imports(module):10.1f} ms")
    return "\n".join(said)


if __name__ == "__main__":
    print(report())
