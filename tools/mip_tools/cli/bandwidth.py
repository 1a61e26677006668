"""`mip bandwidth`: the baud rate that streams need."""

from __future__ import annotations

import argparse
import math
from typing import Any, NamedTuple

from ..binding import MAX_PAYLOAD, OVERHEAD, SCALARS, Data, Field, Structure, info
from ..errors import Failure, Misuse
from . import show
from .arguments import hertz
from .selection import field as named
from .selection import fields, keys

EPILOG = """\
examples:
  mip bandwidth sensor.scaled_accel@100 sensor.scaled_gyro@100
  mip bandwidth sensor:shared.gps_timestamp@500 sensor.scaled_accel@500 --device 3dm-cv7-gnss-ins

The device sends fields of a set in one packet as far as their rates allow. A byte takes ten bits on
a serial line. Allow headroom for replies to commands: 80 % of the line is a good limit.
"""

#: Rates that serial ports commonly have.
COMMON = (9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600, 1_000_000, 3_000_000)
#: Bits on the line for each byte, with its start bit and stop bit.
BITS = 10
#: The longest repeating pattern of packets that is examined, in moments: the points in time at which fields are due.
MOST = 100_000


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add(
        "streams",
        nargs="+",
        metavar="NAME@HZ",
        help="a field and its rate; SET:NAME@HZ for a shared field; NAME@HZ*N with N elements",
    )
    add("--device", metavar="DEVICE", help="check rates and ports of this device")
    add("--baud", type=hertz, metavar="BD", help="show how much of this rate is used")


class Stream(NamedTuple):
    set: int
    name: str
    size: int  # in the packet, with length and descriptor
    rate: float


class Load(NamedTuple):
    """The load of one set."""

    set: int
    streams: list[Stream]
    packets: float  # in a second
    bytes: float  # in a second


def run(options: argparse.Namespace) -> int:
    streams = [_stream(text) for text in options.streams]
    for stream in streams:
        if stream.set == 0xFF:
            raise Misuse(f"{stream.name} is in every data set; name one: sensor:{stream.name}@{stream.rate:g}")
    profile = None
    if options.device is not None:
        from ..simulator.profiles import device_named

        profile = device_named(options.device)
        streams = [_adjusted(stream, profile) for stream in streams]
    bases = profile.base_rates if profile else {}
    loads = [load(n, streams, bases.get(n, 0)) for n in dict.fromkeys(s.set for s in streams)]
    need = math.ceil(sum(one.bytes for one in loads) * BITS)
    if options.baud is not None and need > options.baud:
        raise Failure(f"{options.baud:.0f} Bd are not enough; {need} are needed")
    rows = [("", "bytes", "Hz", "bytes/s")]
    for one in loads:
        rows += [(f"  {s.name}", str(s.size), f"{s.rate:g}", f"{s.size * s.rate:.0f}") for s in one.streams]
        rows.append(
            (f"{show.set_name(one.set)}: packets", str(OVERHEAD), f"{one.packets:g}", f"{one.packets * OVERHEAD:.0f}")
        )
    rows.append(("all", "", "", f"{sum(one.bytes for one in loads):.0f}"))
    widths = [max(len(row[i]) for row in rows) for i in range(4)]
    for row in rows:
        print(f"{row[0]:<{widths[0]}}", *(f"{t:>{w}}" for t, w in zip(row[1:], widths[1:])), sep="  ")
    print(f"\nminimum baud rate: {need}")
    for port, rates in _ports(profile):
        fits = next((r for r in sorted(rates) if r >= need), None)
        if fits is None:
            print(f"{port}: none of its rates is sufficient; the highest is {max(rates)}")
        else:
            print(f"{port}: {fits} ({need / fits:.0%} used)")
    if options.baud is not None:
        print(f"{options.baud:.0f}: {need / options.baud:.0%} used")
    return 0


def load(number: int, streams: list[Stream], base: float = 0) -> Load:
    """Computes the load of a set. Fields that are due at the same moment share packets as far as they fit.

    `base` is the rate of the moments; 0 means the rate of the fastest field.
    """
    own = [s for s in streams if s.set == number]
    packets = 0.0
    rates = sorted({s.rate for s in own}, reverse=True)
    base = base or rates[0]
    steps = [round(base / rate) for rate in rates]
    period = math.lcm(*steps)
    if all(abs(base / rate - step) < 1e-6 for rate, step in zip(rates, steps)) and period <= MOST:
        for tick in range(period):
            due = sum(s.size for s in own if tick % round(base / s.rate) == 0)
            packets += math.ceil(due / MAX_PAYLOAD)
        packets *= base / period
    else:  # the rates are not aligned: at worst, the fields of each rate are in separate packets
        packets = sum(rates)
    return Load(number, own, packets, packets * OVERHEAD + sum(s.size * s.rate for s in own))


def size_of(kind: type[Field], elements: int) -> int | None:
    """Returns the size of a field in a packet, with this number of elements in its list; None if the size varies."""
    total = 2
    for p in info(kind).parameters:
        size = _size(p, elements)
        if size is None:
            return None
        total += size
    return total


def _size(p: Any, elements: int) -> int | None:
    if p.kind == "switch":
        return None
    one = SCALARS[p.scalar].size if p.scalar in SCALARS else p.size
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        inner = [_size(q, elements) for q in info(p.type).parameters]
        if None in inner:
            return None
        one = sum(size or 0 for size in inner)
    if p.kind == "array":
        many = p.length if isinstance(p.length, int) else len(p.elements) or elements
        if isinstance(p.length, int) and p.elements and p.length != len(p.elements):
            many = p.length * len(p.elements)
        return one * many
    if p.kind == "text":
        return p.length if isinstance(p.length, int) else elements
    return int(one)


def _stream(text: str) -> Stream:
    name, at, rest = text.rpartition("@")
    rate, _, count = rest.partition("*")
    try:
        hz = float(rate)
        elements = int(count or 1)
        if not at or not 0 < hz <= 1e6 or not 0 <= elements <= 255:
            raise ValueError
    except ValueError:
        raise Misuse(f"'{text}' is not a stream; write NAME@HZ, as in sensor.scaled_accel@100") from None
    within, colon, plain = name.partition(":")
    number, kind = _field(within, plain) if colon else named(name)
    if not issubclass(kind, Data):
        raise Misuse(f"{kind.NAME} is not a data field; only data is streamed")
    size = size_of(kind, elements)
    if size is None:
        raise Misuse(f"the size of {kind.NAME} varies; it cannot be computed")
    return Stream(number, kind.name_in(number), size, hz)


def _field(within: str, name: str) -> tuple[int, type[Field]]:
    """Finds a field of a set, which may be a shared one."""
    number, descriptor = keys(within)[0]
    if descriptor is not None or number < 0x80:
        raise Misuse(f"'{within}' is not a data set; write SET:NAME@HZ")
    known = [kind for set, kind in fields(name) if set in (number, 0xFF)]
    if not known:
        raise Misuse(f"{within} has no field '{name}'")
    return number, known[0]


def _adjusted(stream: Stream, profile: Any) -> Stream:
    """Returns the stream with a rate that the device supports: its base rate divided by a whole number."""
    kind = named(stream.name).kind
    if not profile.has(stream.set, kind.DESCRIPTOR):
        raise Failure(f"{profile.title} does not send {stream.name} in {show.set_name(stream.set)}")
    base = profile.base_rates.get(stream.set, 0)
    if base <= 0:
        return stream
    if stream.rate > base * 1.000001:
        raise Failure(f"{profile.title} sends {show.set_name(stream.set)} at {base:g} Hz at most, not {stream.rate:g}")
    actual = base / profile.decimation(stream.set, stream.rate)
    return stream._replace(rate=actual)


def _ports(profile: Any) -> list[tuple[str, tuple[int, ...]]]:
    ports = [(p.name, p.baud_rates) for p in profile.ports if p.baud_rates] if profile else []
    return ports or [("common rates", COMMON)]
