"""Hardware: what a device has, what fields and values require of it, and what it therefore cannot have."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest


def hardware(node: Node) -> m.Hardware:
    """Returns the hardware of a profile."""
    sensors = tuple(node["sensors"].plain()) if "sensors" in node else None
    return m.Hardware(sensors, *(node.scalar(key) for key in m.COUNTED))


def needed_hardware(f: m.Field, of: m.Set | None) -> tuple[str, ...]:
    """Returns the hardware that a field requires in a set."""
    return (*(of.needs if of else ()), *f.needs)


def check_needs(profiles: Iterable[Node], needed: Iterable[Node], problems: Problems) -> None:
    """Requires that what a field needs is hardware that some device has, so that no need is misspelled."""
    sensors = {s for node in profiles for s in (node["sensors"].plain() if "sensors" in node else ())}
    counted = {word for pair in m.COUNTED.items() for word in pair}
    for entry in needed:
        number, _, word = entry.value.rpartition(" ")
        choices = counted if number else sensors | counted
        if sensors and word not in choices:
            problems.add(entry.position, f"no device has '{word}'{nearest(word, choices)}")


def check_able(name: str, lacked: str | None, entry: Node, problems: Problems) -> None:
    """Reports an entry that requires hardware which the device lacks."""
    if lacked is not None:
        problems.add(entry.position, f"'{name}' requires {m.worded(lacked)}, which the device lacks; remove it")


def left(t: object, has: m.Hardware, among: tuple[m.EnumValue | m.Bits, ...] = ()) -> tuple[m.EnumValue | m.Bits, ...]:
    """Returns the values or bits of a type that the hardware of a device permits; nothing if it permits all."""
    every = among or (t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ())
    left = tuple(x for x in every if has.lacking(x.needs) is None)
    return left if len(left) < len(every) else ()
