"""Which values of a field are valid, and the time of a packet, as C sees them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import validity

from . import names
from .members import CFunction

#: Both are readings besides those of the specification.
UNKNOWN, USUAL = 0, 1
_FIELD = "value"


@dataclass(frozen=True)
class Devices:
    """Groups of devices that read all flags in the same way; the others read them as usual."""

    groups: tuple[tuple[str, ...], ...]

    def readings(self, reading: validity.Reading) -> list[int]:
        """Returns the numbers of the groups that have a reading."""
        return [n for n, ids in enumerate(self.groups, USUAL + 1) if ids[0] in reading.devices]

    def of(self, device: m.Device) -> int:
        return next((n for n, ids in enumerate(self.groups, USUAL + 1) if device.id in ids), USUAL)


def reading_devices(model: m.Model) -> Devices:
    by_device: dict[str, set[int]] = {}
    own = {r.devices for f in model.fields for p in f.parameters for r in validity.readings([p], f) if r.devices}
    for n, ids in enumerate(sorted(own)):
        for device in ids:
            by_device.setdefault(device, set()).add(n)
    groups: dict[frozenset[int], list[str]] = {}
    for device, numbers in sorted(by_device.items()):
        groups.setdefault(frozenset(numbers), []).append(device)
    return Devices(tuple(map(tuple, groups.values())))


# --------------------------------------------------------------------------- values


def validity_functions(f: m.Field, model: m.Model) -> Iterator[CFunction]:
    """Yields the functions that tell whether the values of a field are valid: one, if the same flags mark all."""
    flagged = [(p, validity.readings([p], f)) for p in f.parameters]
    flagged = [(p, readings) for p, readings in flagged if readings] if f.role != m.COMMAND else []
    together = len({readings for _, readings in flagged}) == 1
    for p, readings in flagged[:1] if together else flagged:
        name = names.field_name(f) if together else f"{names.field_name(f)}_{names.member(p.name)}"
        what = f"Are the values of {f.full_name} valid?" if together else f"Is `{names.member(p.name)}` valid?"
        arguments = [f"const struct {names.field_name(f)} *{_FIELD}"]
        if len(readings) > 1:
            arguments.append("uint8_t reading")
        body = [*_body(f, readings, model.derived(reading_devices))]
        yield CFunction(f"{name}_valid", [what], "static inline bool", arguments, body)


def _body(f: m.Field, readings: tuple[validity.Reading, ...], of: Devices) -> Iterator[str]:
    *others, usual = readings
    for r in others:
        is_read = [f"reading == {n}U" for n in of.readings(r)]
        if r.fewer:
            bits = f"{_FIELD}->{names.member((r.flags or usual.flags)[0].parameter)}"
            is_read.append(f"(reading == {UNKNOWN}U && ({bits} & 0x{r.fewer:X}U) == 0)")
        yield f"if ({' || '.join(is_read)}) {{"
        yield f"    return {_all(r)};"
        yield "}"
    yield f"return {_all(usual)};"


def _all(r: validity.Reading) -> str:
    masks: dict[str, int] = {}
    for flag in r.flags:
        masks[flag.parameter] = masks.get(flag.parameter, 0) | flag.mask
    tests = [
        f"mip_has({_FIELD}->{names.member(name)}, 0x{mask:X}U)" if mask else f"{_FIELD}->{names.member(name)} != 0"
        for name, mask in masks.items()
    ]
    return " && ".join(tests) or "true"


# --------------------------------------------------------------------------- times


@dataclass(frozen=True)
class Source:
    """A field that contains the time of its packet."""

    of: validity.Timestamp
    count_at: int  # of the number of elements that are before the parts
    element: int  # the size of one; 0 if there is no such array
    place: int  # of the flags
    width: int  # of the flags; 0 if none mark the time
    parts: list[str]  # rows of struct part
    readings: list[str]  # rows of struct reading

    @property
    def clock(self) -> str:
        return clock_constant(self.of.clocks[0])

    @property
    def other(self) -> str:
        """The clock of a time of week that is not valid as a date."""
        return clock_constant(self.of.clocks[1]) if self.of.clocks[1:] else "NO_CLOCK"


def clock_constant(clock: m.Clock) -> str:
    return f"MIP_CLOCK_{clock.name.upper()}"


def clock_sources(model: m.Model) -> Iterator[Source]:
    of = model.derived(reading_devices)
    for t in validity.timestamps(model):
        places = {p.name: t.place(p.name) for p, _ in t.parts}
        arrays = {place.before.terms for place in places.values()}
        holders = {flag.parameter for r in t.readings for flag in r.flags}
        if len(arrays) > 1 or any(len(terms) > 1 for terms in arrays):
            raise ValueError(f"{t.field.full_name}: C finds a timestamp only behind one array")
        if len(holders) > 1 or (holders and any(arrays)) or any(not f.mask for r in t.readings for f in r.flags):
            raise ValueError(f"{t.field.full_name}: C reads the flags of a timestamp from one bitfield")
        array = [(t.place(term.counter).before.fixed, term.size) for terms in arrays for term in terms] or [(0, 0)]
        flags = [(place.before.fixed, place.size) for place in map(t.place, holders)] or [(0, 0)]
        undated = {p.name for p, _ in t.undated_parts}
        parts = []
        for p, scale in t.parts:
            assert isinstance(p.element, m.Scalar) and (p.element.kind == "unsigned" or scale < 1 << 32), p.name
            kind = "true" if p.element.kind == "float" else "false"
            at = places[p.name].before.fixed
            parts.append(f"{{{at}, {p.element.size}, {kind}, {str(p.name in undated).lower()}, {scale}U}}")
        rows = []
        for r in t.readings:
            mask = 0
            for flag in r.flags:
                mask |= flag.mask
            bits = sum(1 << n for n in of.readings(r))
            rows.append(f"{{0x{bits:X}, 0x{mask:X}, 0x{r.fewer:X}}}" if r.devices else f"{{0xFFFF, 0x{mask:X}, 0}}")
        yield Source(t, *array[0], *flags[0], parts, rows)
