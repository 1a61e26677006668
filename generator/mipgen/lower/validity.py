"""Which flags mark a value as valid, on which device, and what a timestamp means with them.

The flags of a value may be other bits on other devices: readings. On a device that is not known, the usual reading
holds, unless one that has fewer bits defines all that are set. All bindings and tools follow this rule; for a log, the
bits of all its values count together.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import NamedTuple

from mipgen import model as m

from . import extent

#: Nanoseconds of the units of time. A timestamp is the sum of all parameters with one of them.
NANOSECONDS = {"week": 604_800 * 10**9, "s": 10**9, "ms": 10**6, "us": 1000, "ns": 1}


@dataclass(frozen=True, slots=True)
class Flag:
    """A bit, or a bool, that marks a value as valid."""

    path: str  # "valid_flags.tow"
    parameter: str  # the parameter of the same record that contains it
    mask: int  # 0: that parameter is a bool


@dataclass(frozen=True, slots=True)
class Reading:
    """The flags of a value on some devices: one, or one for each element."""

    devices: tuple[str, ...]  # ids; empty for all devices without another reading
    flags: tuple[Flag, ...]
    undefined: int  # the bits that the flags' type does not define
    fewer: int = 0  # the same if the usual reading defines some of them: devices whose flags have none of these bits


class Place(NamedTuple):
    """Where the data of a field contains a number: the size of the number, and the bytes before it."""

    size: int
    before: extent.Extent


@dataclass(frozen=True, slots=True)
class Timestamp:
    """A field that contains the time of its packet."""

    field: m.Field
    sets: tuple[int, ...]  # the numbers of the descriptor sets in which it does
    clocks: tuple[m.Clock, ...]  # that of a time that is valid, then that of a time of week that is not
    parts: tuple[tuple[m.Parameter, int], ...]  # each with the nanoseconds of its unit
    readings: tuple[Reading, ...]

    @property
    def undated_parts(self) -> tuple[tuple[m.Parameter, int], ...]:
        """The parts of a time without a date: all but weeks."""
        return tuple((p, n) for p, n in self.parts if n != NANOSECONDS["week"] or not self.clocks[0].epoch)

    def place(self, name: str) -> Place:
        """Returns the place of a number. No unions are before it."""
        parameters = self.field.parameters
        index = [p.name for p in parameters].index(name)
        (before,) = extent.totals(parameters[:index], extent.Extent())
        assert parameters[index].kind in ("scalar", "counter"), f"{name} is not a number"
        return Place(parameters[index].size, before)


def readings(parameters: Iterable[m.Parameter], record: m.Record) -> tuple[Reading, ...]:
    """Returns how the flags of these parameters are read, those with the fewest bits first, the usual one last; none if
    no flag marks the values."""
    parameters = tuple(parameters)
    own = [v for p in parameters for v in p.variants if v.by_device and v.valid is not None and not v.member]
    stated = [*(p.valid for p in parameters), *(v.valid or () for v in own)]
    paths = [path for valid in stated for path in valid]
    if not paths:
        return ()
    holders = [q for q in record.parameters if q.name in {path.partition(".")[0] for path in paths}]
    devices = dict.fromkeys((*(v.key for v in own), *(v.key for q in holders for v in q.readings if v.by_device)))
    usual, grouped = _reading(parameters, record, None), dict[Reading, list[str]]()
    for device in devices:
        grouped.setdefault(_reading(parameters, record, device), []).append(device)
    grouped.pop(usual, None)
    others = [
        replace(r, devices=tuple(ids), fewer=r.undefined if r.undefined & ~usual.undefined else 0)
        for r, ids in grouped.items()
    ]
    others.sort(key=lambda r: (-r.undefined.bit_count(), r.devices))
    return (*others, usual) if others or usual.flags else ()


def _reading(parameters: tuple[m.Parameter, ...], record: m.Record, device: str | None) -> Reading:
    """Returns the reading on one device, or the usual one, without devices."""
    all_flags: list[Flag] = []
    undefined = 0
    for p in parameters:
        own = [v.valid for v in p.variants if v.by_device and v.key == device and v.valid is not None and not v.member]
        places = flags_named((own[0] if own else p.valid) or (), record, device)
        all_flags += places
        for flag in places:
            bits = _named(_holder(flag.parameter, record), device)
            undefined |= _undefined(bits) if isinstance(bits, m.Bitfield) else 0
    return Reading((), tuple(all_flags if len(parameters) == 1 else dict.fromkeys(all_flags)), undefined)


def flags_named(paths: Iterable[str], record: m.Record, device: str | None = None) -> tuple[Flag, ...]:
    """Returns the flags with these names: one, or one for each element. None if the bit depends on the device, which is
    not known."""
    places = []
    for path in paths:
        name, _, bit = path.partition(".")
        types = _types(_holder(name, record), device, bit)
        masks = {b.mask for t in types for b in t.bits if b.name == bit} if bit else {0}
        if len(masks) != 1:
            return ()
        places.append(Flag(path, name, masks.pop()))
    return tuple(places)


def _holder(name: str, record: m.Record) -> m.Parameter:
    return next(q for q in record.parameters if q.name == name)


def _named(holder: m.Parameter, device: str | None) -> object:
    return next((v.type for v in holder.readings if v.by_device and v.key == device), holder.element)


def _types(holder: m.Parameter, device: str | None, bit: str) -> list[m.Bitfield]:
    """Returns the bitfields that define a bit: that of the device, else the usual one, else those of all devices."""
    own = _named(holder, device)
    if isinstance(own, m.Bitfield) and any(b.name == bit for b in own.bits):
        return [own]
    return [v.type for v in holder.readings if isinstance(v.type, m.Bitfield)] if own is holder.element else []


def _undefined(bits: m.Bitfield) -> int:
    undefined = (1 << bits.width) - 1
    for b in bits.bits:
        undefined &= ~b.mask
    return undefined


def timestamps(model: m.Model) -> tuple[Timestamp, ...]:
    """Returns the fields that contain the time of their packet, in the order of the clocks: those whose descriptor has
    no other layout. A time with week 0 is not valid as a date, and a time of week that is in no week is no time."""
    clocks: dict[str, list[m.Clock]] = {}
    for clock in model.protocol.clocks:
        for name in clock.timestamps:
            clocks.setdefault(name, []).append(clock)
    sets: dict[tuple[str, tuple[m.Clock, ...]], list[int]] = {}
    for name, both in clocks.items():
        f = model.field(name)
        if f is not None and len(model.layouts(f)) == 1:
            own = tuple(sorted(both, key=lambda c: c.epoch is None))
            sets.setdefault((f.full_name, own), []).append(model.set_of(name))
    stamps = []
    for (name, own), numbers in sets.items():
        f = model.field(name)
        assert f is not None
        parts = tuple((p, NANOSECONDS[p.units[0]]) for p in f.parameters if _is_time(p))
        stamps.append(Timestamp(f, tuple(numbers), own, parts, readings((p for p, _ in parts), f)))
    return tuple(stamps)


def device_clock(model: m.Model) -> str:
    """Returns the name of the clock of times that are not valid as a date; empty if there is none."""
    return next((t.clocks[1].name for t in timestamps(model) if t.clocks[1:]), "")


def _is_time(p: m.Parameter) -> bool:
    return len(p.units) == 1 and p.units[0] in NANOSECONDS
