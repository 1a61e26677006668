"""The words that a specification may use, and citations of manuals."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems

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
