"""Python against Python: packets, objects and noise, relative to a hand-written loop.

The loop reads every field with a `struct.Struct` and checks nothing. All run in one process, in turn, over the same
stream that is made here: packets of 44 bytes on average, in the order of a device and shuffled.
"""

from __future__ import annotations

import gc
import os
import random
import statistics
import struct
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

try:
    import construct
except ImportError:  # a development tool; without it, its line is left out
    construct = None

from mip_protocol import Decoder, Parser, checksum, registry

SIZE = 1 << 21
CHUNK = 1 << 16
ROUNDS = 9

VECTOR, TIME, ATTITUDE = ">3f", ">Q", ">3fH"
FORMATS = {
    (0x80, 0x04): VECTOR, (0x80, 0x05): VECTOR, (0x80, 0x06): VECTOR, (0x80, 0x0C): VECTOR,
    (0x80, 0xD5): TIME, (0x80, 0xD6): TIME, (0x82, 0x05): ATTITUDE,
    (0x82, 0xD5): TIME, (0x82, 0xD6): TIME, (0xA0, 0xD5): TIME, (0xA0, 0xD6): TIME,
}  # fmt: skip
UNPACK = {key: struct.Struct(layout).unpack_from for key, layout in FORMATS.items()}


def packets(chance: random.Random) -> Iterator[bytes]:
    """Sensor packets of varying fields, filter packets, system packets."""
    while True:
        for set_number in (0x80, 0x80, 0x82, 0x80, 0x80, 0xA0):
            fields = [d for s, d in FORMATS if s == set_number]
            if set_number == 0x80:
                vectors = [d for d in fields if d < 0xD0 and chance.random() < 0.58] or [0x04]
                fields = vectors + [d for d in fields if d >= 0xD0 and chance.random() < 0.7]
            if set_number == 0x82:
                fields.remove(0xD6)
            payload = b""
            for descriptor in fields:
                layout = FORMATS[set_number, descriptor]
                numbers = [chance.uniform(-9, 9) for _ in range(layout.count("f") and 3)]
                whole = [chance.getrandbits(40)] if "Q" in layout else [chance.randrange(2)] if "H" in layout else []
                data = struct.pack(layout, *numbers, *whole)
                payload += bytes((len(data) + 2, descriptor)) + data
            head = b"ue" + bytes((set_number, len(payload))) + payload
            yield head + checksum(head)


def by_hand(data: bytes) -> list[tuple[int, list[tuple[int, tuple[object, ...]]]]]:
    found, at, end = [], 0, len(data)
    while at + 6 <= end:
        if data[at : at + 2] != b"ue":
            at = data.find(b"ue", at + 1)
            if at < 0:
                break
            continue
        set_number, length = data[at + 2], data[at + 3]
        stop = at + 4 + length
        if stop + 2 > end:
            break
        fields, i = [], at + 4
        while i < stop:
            size, descriptor = data[i], data[i + 1]
            unpack = UNPACK.get((set_number, descriptor))
            if unpack is not None:
                fields.append((descriptor, unpack(data, i + 2)))
            i += size
        found.append((set_number, fields))
        at = stop + 2
    return found


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
    kinds = {VECTOR: c.Float32b[3], TIME: c.Int64ub, ATTITUDE: c.Sequence(c.Float32b[3], c.Int16ub)}
    values = {s << 8 | d: kinds[layout] for (s, d), layout in FORMATS.items()}
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


def speed(work: Callable[[bytes], object], data: bytes) -> float:
    pieces = [data[at : at + CHUNK] for at in range(0, len(data), CHUNK)]
    gc.collect()
    begin = time.process_time()
    for piece in pieces:
        work(piece)
    return len(data) / (time.process_time() - begin) / 1e6


def imports(module: str) -> float:
    """CPU time of an import in a new process, in milliseconds, without the start of Python."""
    code = f"import time; t = time.process_time(); import {module}; print((time.process_time() - t) * 1e3)"
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    runs = [float(subprocess.check_output([sys.executable, "-c", code], env=environment)) for _ in range(ROUNDS)]
    return min(runs[1:])


def report() -> str:
    chance, made, length = random.Random(1), [], 0
    for packet in packets(chance):
        made.append(packet)
        length += len(packet)
        if length > SIZE:
            break
    original = b"".join(made)
    chance.shuffle(made)
    streams = {"original order": original, "shuffled": b"".join(made)}
    noise = {
        "noise 75 65 01 FF": b"ue\x01\xff" * (SIZE // 4),
        "noise, random bytes": random.Random(2).randbytes(SIZE),
        "noise, 75 65 every 22 bytes": dense(22),
        "noise, 75 65 every 8 bytes": dense(8),
        "noise, NMEA": b"$GPGGA,123519.00,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n" * (SIZE // 70),
    }
    lines: dict[str, tuple[Callable[[bytes], object], bytes]] = {}
    for order, stream in streams.items():
        for work in (by_hand, parse, objects, parse_and_decode):
            lines[f"{work.__name__}, {order}"] = (work, stream)
    lines |= {name: (parse, data) for name, data in noise.items()}
    slow = with_construct()
    if slow:
        lines["construct"] = (slow, original[: len(original) // 64])
    figures: dict[str, list[float]] = {name: [] for name in lines}
    for _ in range(ROUNDS):
        for name, (work, data) in lines.items():
            figures[name].append(speed(work, data))
    unit = statistics.median(figures["by_hand, original order"])
    said = [f"{len(made)} packets of {len(original) / len(made):.1f} bytes; in units of the loop written by hand\n"]
    for name, runs in figures.items():
        median = statistics.median(runs)
        said.append(f"{name:36}{median:10.1f} MB/s{median / unit:8.2f}")
    for module in ("mip_protocol", "mip_protocol.sensor", "mip_protocol.mip_3dm"):
        said.append(f"{'import ' + module:36}{imports(module):10.1f} ms")
    return "\n".join(said)


if __name__ == "__main__":
    sys.path[:] = [p for p in sys.path if p != str(Path(__file__).parent)]
    print(report())
