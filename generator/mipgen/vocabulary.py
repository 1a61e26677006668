"""What names of a specification may refer to, and what cites a manual."""

from __future__ import annotations

from dataclasses import dataclass

from . import model as m
from .nodes import Node
from .problems import Problems, nearest


@dataclass
class Vocabulary:
    """Units, frames, manuals, devices and function selectors."""

    units: set[str]
    frames: set[str]
    manuals: set[str]
    devices: set[str]
    functions: tuple[m.Function, ...]
    selector: m.Enum

    def letters(self, text: str) -> tuple[m.Function, ...]:
        """The functions with these letters, by value."""
        return tuple(f for f in self.functions if f.letter in text)


def sources(node: Node, vocabulary: Vocabulary, problems: Problems) -> tuple[m.Source, ...]:
    """The `sources` of a node, with unknown manuals reported."""
    found = []
    for entry in node.get("sources") or ():
        manual = entry["manual"].value
        if manual not in vocabulary.manuals:
            problems.add(entry["manual"].position, f"unknown manual '{manual}'{nearest(manual, vocabulary.manuals)}")
        length = entry.get("length")
        printed, place = (str(length.value), length.position) if length else (None, entry.position)
        found.append(m.Source(manual, entry["section"].value, printed, place))
    return tuple(found)
