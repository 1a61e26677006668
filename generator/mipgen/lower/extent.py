"""Sizes on the wire: minimum, maximum, and formulas with counters.

All sizes follow from `extents`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

from mipgen import model as m


class Term(NamedTuple):
    """The bytes of an array whose length varies."""

    size: int  # of one element
    counter: str  # its path: "list.count"; or m.REST
    most: int = 0  # elements


@dataclass(frozen=True, slots=True)
class Extent:
    """A number of bytes. It may depend on counters, and on the index of an element.

    >>> str(Extent(4) + Extent(0, (Term(3, "count"),))), str(Extent(7)), str(Extent(0, (Term(1, "n"),)))
    ('4 + 3*count', '7', 'n')
    """

    fixed: int = 0
    terms: tuple[Term, ...] = ()

    def __add__(self, other: Extent) -> Extent:
        return Extent(self.fixed + other.fixed, self.terms + other.terms)

    def __str__(self) -> str:
        parts = [str(self.fixed)] if self.fixed or not self.terms else []
        parts += [t.counter if t.size == 1 else f"{t.size}*{t.counter}" for t in self.terms]
        return " + ".join(parts)

    @property
    def most(self) -> int:
        """The number of bytes with the maximum number of elements."""
        return self.fixed + sum(t.size * t.most for t in self.terms)

    @property
    def filling(self) -> bool:
        """True if it contains an array that ends with the field, without a counter."""
        return any(t.counter == m.REST for t in self.terms)

    @property
    def counted(self) -> Extent:
        """The extent without an array that fills the field."""
        return Extent(self.fixed, tuple(t for t in self.terms if t.counter != m.REST))


def extents(p: m.Parameter, prefix: str = "", unknown: bool = False) -> list[Extent]:
    """Returns the possible sizes of a parameter: one for each alternative of a union, the shortest first.

    `prefix` is the path to the parameter's record. `unknown`: a tag may have an undefined value.
    """
    if p.struct:
        return totals(p.struct.parameters, Extent(), f"{prefix}{p.name}.", unknown)
    if p.union:
        inner = f"{prefix}{p.name}."
        full = [e for q in p.alternatives for e in extents(q, inner, unknown)]
        empty = unknown or len(p.alternatives) < len(p.cases)
        return _distinct([*full, *([Extent()] if empty else [])])
    if not p.several:
        return [Extent(p.size)]
    if p.count is not None:
        return [Extent(p.count * item_size(p))]
    return [Extent(0, (Term(item_size(p), prefix + p.counter if p.counter else m.REST, p.capacity),))]


def totals(parameters: Iterable[m.Parameter], start: Extent, prefix: str = "", unknown: bool = False) -> list[Extent]:
    """Returns the possible total sizes of parameters, added to `start`."""
    sums = [start]
    for p in parameters:
        sums = [a + b for a in sums for b in extents(p, prefix, unknown)]
    return _distinct(sums)


def _distinct(several: Iterable[Extent]) -> list[Extent]:
    return sorted(dict.fromkeys(several), key=lambda e: (e.fixed, e.terms))


# --------------------------------------------------------------------------- what is asked of them


def exact_size(p: m.Parameter, prefix: str = "") -> Extent | None:
    """Returns the size of a parameter; None unless the parameters before it determine the size."""
    several = extents(p, prefix)
    return several[0] if len(several) == 1 and not several[0].filling else None


def shortest_size(parameters: Iterable[m.Parameter]) -> Extent:
    """Returns the minimum size of parameters, given their counters."""
    return totals(parameters, Extent(), unknown=True)[0]


def size(p: m.Parameter) -> tuple[int, int]:
    """Returns the minimum and maximum size of a parameter in bytes."""
    if p.struct:
        return p.struct.min_size, p.struct.max_size
    if not p.union and not p.several:
        return p.size, p.size
    several = extents(p, unknown=True)
    return min(e.fixed for e in several), max(e.most for e in several)


def fewest(parameters: Iterable[m.Parameter]) -> int:
    return sum(size(p)[0] for p in parameters)


def most(parameters: Iterable[m.Parameter]) -> int:
    """Returns the maximum size of parameters in bytes, limited to that of a field."""
    return min(m.MAX_FIELD_DATA, sum(size(p)[1] for p in parameters))


def item_size(p: m.Parameter) -> int:
    """Returns the size in bytes of one item of an array or string."""
    return size(p.item)[1]


def computed_length(f: m.Field, rule: str) -> str:
    """Returns the length of a whole field as a manual counts it: "14", or "4 + 3*count".

    `wire` counts every byte. `scalars` counts scalars and arrays of them, and counted arrays in
    formulas, but neither vectors nor structures nor unions.
    """
    counted = (p for p in f.parameters if rule == "wire" or p.open or _is_number(p))
    return str(Extent(2) + shortest_size(counted))


def _is_number(p: m.Parameter) -> bool:
    return isinstance(p.element, (m.Scalar, m.Enum, m.Bitfield))


def same(printed: str, computed: str) -> bool:
    """True if a printed length equals the computed one.

    >>> same("4 + 3*N", "4 + 3*N"), same("4+3*N", "4 + 3*N"), same("0x0E", "14"), same("5 + 1*n", "5 + n")
    (True, True, True, True)
    """
    if re.fullmatch(r"0x[0-9A-Fa-f]+", printed):
        printed = str(int(printed, 16))
    return re.sub(r"\b1\*|\s", "", printed) == re.sub(r"\s", "", computed)
