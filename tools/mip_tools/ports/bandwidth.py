"""The load of a line: the packets and bytes with which a device sends fields at their rates."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from ..binding import MAX_PAYLOAD, OVERHEAD, SCALARS, Data, Device, Field, Structure, info
from ..errors import Failure, Misuse
from ..names.selection import matching_fields, one_field, resolve_keys
from ..text import show

#: Bits on the line for each byte, with its start bit and stop bit.
BITS = 10


#: The longest repeating pattern of packets that is examined, in moments: the points in time at which fields are due.
MOST = 100_000


#: Rates that serial ports commonly have.
COMMON = (9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600, 1_000_000, 3_000_000)


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


def set_load(number: int, streams: list[Stream], base: float = 0) -> Load:
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
    item_size = SCALARS[p.scalar].size if p.scalar in SCALARS else p.size
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        inner = [_size(q, elements) for q in info(p.type).parameters]
        if None in inner:
            return None
        item_size = sum(size or 0 for size in inner)
    if p.kind == "array":
        many = p.length if isinstance(p.length, int) else len(p.elements) or elements
        if isinstance(p.length, int) and p.elements and p.length != len(p.elements):
            many = p.length * len(p.elements)
        return item_size * many
    if p.kind == "text":
        return p.length if isinstance(p.length, int) else elements
    return int(item_size)


def loads(streams: list[Stream], profile: Device | None) -> list[Load]:
    """Computes the load of each set at the rates that a device supports. Raises Failure if it lacks a field."""
    if profile is not None:
        streams = [_adjusted(stream, profile) for stream in streams]
    bases = profile.base_rates if profile else {}
    return [set_load(n, streams, bases.get(n, 0)) for n in dict.fromkeys(s.set for s in streams)]


def bauds(loads: list[Load]) -> int:
    """Returns the lowest baud rate that suffices."""
    return math.ceil(sum(load.bytes for load in loads) * BITS)


def stream(text: str) -> Stream:
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
    number, kind = _field(within, plain) if colon else one_field(name)
    if not issubclass(kind, Data):
        raise Misuse(f"{kind.NAME} is not a data field; only data is streamed")
    size = size_of(kind, elements)
    if size is None:
        raise Misuse(f"the size of {kind.NAME} varies; it cannot be computed")
    return Stream(number, kind.name_in(number), size, hz)


def _field(within: str, name: str) -> tuple[int, type[Field]]:
    """Finds a field of a set, which may be a shared one."""
    number, descriptor = resolve_keys(within)[0]
    if descriptor is not None or number < 0x80:
        raise Misuse(f"'{within}' is not a data set; write SET:NAME@HZ")
    kinds = [kind for set_number, kind in matching_fields(name) if set_number in (number, 0xFF)]
    if not kinds:
        raise Misuse(f"{within} has no field '{name}'")
    return number, kinds[0]


def _adjusted(stream: Stream, profile: Device) -> Stream:
    """Returns the stream with a rate that the device supports: its base rate divided by a whole number."""
    kind = one_field(stream.name).kind
    if not profile.has(stream.set, kind.DESCRIPTOR):
        raise Failure(f"{profile.title} does not send {stream.name} in {show.set_name(stream.set)}")
    base = profile.base_rates.get(stream.set, 0)
    if base <= 0:
        return stream
    if stream.rate > base * 1.000001:
        raise Failure(f"{profile.title} sends {show.set_name(stream.set)} at {base:g} Hz at most, not {stream.rate:g}")
    actual = base / profile.decimation(stream.set, stream.rate)
    return stream._replace(rate=actual)


def port_rates(profile: Device | None) -> list[tuple[str, tuple[int, ...]]]:
    ports = [(p.name, p.baud_rates) for p in profile.ports if p.baud_rates] if profile else []
    return ports or [("common rates", COMMON)]
