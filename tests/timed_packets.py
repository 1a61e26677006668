"""Packets with timestamps of all kinds, at random and of known devices, and leap seconds: for all languages."""

from __future__ import annotations

import random
import re
import struct
from collections.abc import Iterator
from datetime import datetime, timedelta

import random_values
from mipgen import model as m
from mipgen.lower import codec
from support import ROOT, model, some

SECOND = 10**9
UNIX, GPS = datetime(1970, 1, 1), datetime(1980, 1, 6)


def framed(number: int, payload: bytes) -> bytes:
    head = bytes([0x75, 0x65, number, len(payload)]) + payload
    return head + codec.checksum(head)


def packet(number: int, *fields: tuple[int, bytes]) -> bytes:
    return framed(number, b"".join(bytes([len(data) + 2, descriptor]) + data for descriptor, data in fields))


SPECIAL = [0.0, -0.5, 0.5e-9, 1.5e-9, 2.5e-9, 604799.9999999999, 604800.0, float("nan"), float("inf"), 4e9, -4e9, 1e300]


def stamp(luck: random.Random, f: m.Field) -> bytes:
    """Random data of a timestamp: often a plausible one, seldom a piece."""
    data = bytearray(codec.encode(f, random_values.record(luck, f.parameters, 40)))
    at = 0
    for p in f.parameters:
        if p.scalar.name == "double":
            time = luck.choice(SPECIAL) if luck.random() < 0.3 else luck.uniform(0, 604800)
            data[at : at + 8] = struct.pack(">d", time)
        elif p.named and luck.random() < 0.8:
            data[at : at + 2] = struct.pack(">H", luck.randrange(32))
        at += p.size
    return bytes(data[: luck.randrange(len(data))] if luck.random() < 0.05 else data)


def random_packet(luck: random.Random, of: m.Model, stamps: list[m.Field]) -> bytes:
    number = luck.choice([s for f in stamps for s in f.sets if s >= 0x80])
    here = [f for f in stamps if number in f.sets]
    fields = [(f.descriptor, stamp(luck, f)) for f in luck.choices(here, k=luck.randint(1, 4))]
    fields.insert(luck.randrange(len(fields) + 1), (luck.randrange(1, 256), luck.randbytes(4)))
    whole = packet(number, *fields)
    if luck.random() < 0.05:  # the last field is cut
        return framed(number, whole[4:-3])
    return whole


def random_packets(luck: random.Random, of: m.Model, count: int) -> Iterator[tuple[str, bytes]]:
    """A device or "-", and a packet, for all clocks, kinds of timestamps and flags."""
    found = (of.field(name) for clock in of.protocol.clocks for name in clock.timestamps)
    stamps = list({f.full_name: f for f in found if f}.values())
    devices = ["-", "-", *(d.id for d in of.devices)]
    for _ in range(count):
        yield luck.choice(devices), random_packet(luck, of, stamps)


#: A device, a packet, and its times in nanoseconds: in UTC by the clock gps, and by the clock device.
Case = tuple[str | None, bytes, int | None, int | None]


def cases_of_devices() -> list[Case]:
    """What devices of generation 5 send, in sync and never in sync, and later ones."""
    week = (GPS - UNIX) // timedelta(seconds=1) * SECOND + (2300 * 604_800 - 18) * SECOND
    sync, on = 345_600_010_000_000, 12_500_000_000  # the time of week; since power-on

    def one(device: str | None, date: int | None, other: int | None, *stamp: float, number: int = 0x12) -> Case:
        return device, packet(0x80, (number, struct.pack(">dHH", *stamp))), date, other

    return [
        one(None, week + sync, None, 345_600.01, 2300, 5),  # PPS and initialized: three bits, valid
        one(None, week + sync, None, 345_600.01, 2300, 7),
        one("3dm-gx5-15", week + sync, None, 345_600.01, 2300, 4),
        one("3dm-cv7-ahrs", None, sync, 345_600.01, 2300, 7),
        one(None, None, on, 12.5, 0, 0),
        one(None, None, on, 12.5, 0, 3),
        one(None, None, on, 12.5, 2300, 0x0D),  # time of week without week
        one(None, None, on, 12.5, 2300, 0x15),  # week without time of week
        one(None, week + sync, None, 345_600.01, 2300, 0x1D),
        one(None, week + 604_799_990_000_000, None, 604_799.99, 2300, 0x1F),
        # Week 0 is no date, and a time of week that is in no week no time.
        one(None, None, on, 12.5, 0, 0x1F),
        one(None, week + 604_800 * SECOND, None, 604_800.0, 2300, 0x1F),
        one(None, None, None, 604_800.5, 2300, 0x1F),
        one(None, None, None, 604_800.5, 0, 0),
        one(None, None, None, -0.5, 2300, 0x1F),
        one(None, None, None, float("nan"), 2300, 0x1F),
        one(None, None, None, float("nan"), 0, 0),
        one(None, None, 8 * SECOND, 8.0, 2300, 1, number=0xD3),
        one(None, week + 8 * SECOND, None, 8.0, 2300, 3, number=0xD3),
        # Filter in initialization, and a receiver without a fix.
        (None, packet(0x82, (0x11, struct.pack(">dHH", 7.25, 0, 0))), None, 7_250_000_000),
        (None, packet(0x91, (0x09, struct.pack(">dHH", 7.25, 0, 0))), None, None),
        (None, packet(0x91, (0x09, struct.pack(">dHH", 8.0, 0, 3))), None, None),
        (None, packet(0x80, (0x04, bytes(12))), None, None),
        # All flags that a model may set, read as the specification says for the model.
        *(
            one(device.id, *((week + sync, None) if dated(device, flags) else (None, sync)), 345_600.01, 2300, flags)
            for device in model("real").devices
            for flags in range(32)
        ),
    ]


def dated(device: m.Device, flags: int) -> bool:
    """Do these flags of a sensor's GPS timestamp mark a date on a model?"""
    values = some(model("real").field("sensor.gps_timestamp")).parameters
    for p in values:
        valid = next((v.valid for v in p.variants if v.by_device and v.key == device.id and v.valid), p.valid)
        for holder, bit in (path.split(".") for path in valid):
            (holding,) = (q for q in values if q.name == holder)
            kinds = [v.type for v in holding.readings if v.by_device and v.key == device.id] or [holding.element]
            masks = [b.mask for kind in kinds if isinstance(kind, m.Bitfield) for b in kind.bits if b.name == bit]
            if not any(flags & mask for mask in masks):
                return False
    return True


def leap_seconds() -> list[tuple[int, int]]:
    """GPS times in nanoseconds, and the same in UTC: a second before, at and after each leap second.

    The days are those of the text of the specification."""
    text = (ROOT / "spec/protocol.yaml").read_text("utf-8").partition("\nleap_seconds:\n")[2]
    leaps = [(datetime.fromisoformat(day), int(n)) for day, n in re.findall(r'^  "([\d-]+)": (\d+)$', text, re.M)]
    assert len(leaps) >= 18 and leaps[0][1] == 1
    found = []
    for day, ahead in leaps:
        for seconds in (-86400, -2, -1, 0, 1, 86400):
            utc = day + timedelta(seconds=seconds)
            since = (utc - GPS) // timedelta(seconds=1) + ahead - (1 if seconds < 0 else 0)
            found.append((since * SECOND + 7, (utc - UNIX) // timedelta(seconds=1) * SECOND + 7))
        # The leap second itself becomes the second after it.
        since = (day - GPS) // timedelta(seconds=1) + ahead - 1
        found.append((since * SECOND, (day - UNIX) // timedelta(seconds=1) * SECOND))
    return found
