"""The words that a specification may use, and citations of manuals; hardware that devices have and fields require."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems, nearest

from . import meaning
from .beside import Lists


@dataclass
class Vocabulary:
    """Units, frames, manuals, devices and function selectors."""

    units: dict[str, m.Unit]
    frames: dict[str, tuple[str, ...]]  # frame -> the elements of its vectors, if not x, y, z
    manuals: dict[str, m.Manual]
    devices: set[str]
    functions: tuple[m.Function, ...]
    selector: m.Enum
    evidence: Lists
    keywords: Lists

    def letters(self, text: str) -> tuple[m.Function, ...]:
        """Returns the functions with these letters, by value."""
        return tuple(f for f in self.functions if f.letter in text)


def texts_of_node(node: Node, key: str) -> tuple[str, ...]:
    """Returns a list of sentences, such as `notes` or `uncertain`."""
    return tuple(node[key].plain()) if key in node else ()


def short_name(node: Node, name: str, problems: Problems) -> str | None:
    """Returns the `short` of a node: its name in languages that limit identifiers."""
    entry = node.get("short")
    if entry is None:
        return None
    if len(entry.value) >= len(name):
        problems.add(entry.position, f"'{entry.value}' is not shorter than the name '{name}'; shorten or remove it")
    return str(entry.value)


def sources_of_node(node: Node, vocabulary: Vocabulary, problems: Problems) -> tuple[m.Source, ...]:
    """Returns the `sources` of a node."""
    return _sources(node.get("sources") or (), vocabulary, problems, None)


def cited(name: str, vocabulary: Vocabulary, problems: Problems, heading: str | None = None) -> tuple[m.Source, ...]:
    """Returns the sources in evidence/ of what has this name; those of a field may omit the section if it is this
    heading."""
    return _sources(vocabulary.evidence.entries_of(name), vocabulary, problems, heading)


def _sources(
    entries: Iterable[Node], vocabulary: Vocabulary, problems: Problems, heading: str | None
) -> tuple[m.Source, ...]:
    cited = []
    for entry in entries:
        manual, section = meaning.resolve_citation(entry, vocabulary.manuals, problems.add, heading)
        length = entry.get("length")
        printed, place = (str(length.value), length.position) if length else (None, entry.position)
        cited.append(m.Source(manual, section, printed, place))
    return tuple(cited)


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
    left = tuple(x for x in every if not x.needs or has.lacking(x.needs) is None)
    return left if len(left) < len(every) else ()
