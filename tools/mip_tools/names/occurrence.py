"""Occurrences of fields: a field is counted, shown and exported separately for each descriptor set that has it."""

from __future__ import annotations

import re
from typing import NamedTuple

from ..binding import SETS, Field, lookup, registry


class Occurrence(NamedTuple):
    """A set and a field, as in `registry.all_types`. A field of every set occurs once: in 0xFF, or, for the
    acknowledge, in 0."""

    set: int
    kind: type[Field]

    @property
    def name(self) -> str:
        """Its full name: "gnss_2.dop"."""
        return self.kind.name_in(self.set)


def sets_of(kind: type[Field]) -> tuple[int, ...]:
    """Returns the sets that have a field; empty for shared fields and the acknowledge."""
    return () if isinstance(kind.SETS, range) else tuple(kind.SETS)


def occurrence_in(set_number: int, kind: type[Field]) -> Occurrence:
    """Returns the occurrence of a field in packets of this set."""
    return Occurrence(set_number if sets_of(kind) else kind.SET, kind)


def every(kind: type[Field]) -> list[Occurrence]:
    """Returns a field's occurrences, one for each of its sets; a field of every set has one occurrence."""
    return [occurrence_in(number, kind) for number in sets_of(kind) or (0,)]


def occurrences_named(name: str) -> list[Occurrence]:
    """Finds the field with this name, in the set with which the name begins, or in each of its sets if it names none.

    Raises UnknownName.
    """
    kind = registry.by_name(name)
    wanted = named_set(name, kind)
    return every(kind) if wanted is None else [Occurrence(wanted, kind)]


def named_set(name: str, kind: type[Field]) -> int | None:
    """Returns the set that a field's name states: "gnss_2.dop", "Gnss2.Dop" or "0x92,0x09"; None if it states none."""
    sets = sets_of(kind)
    if len(sets) == 1:
        return sets[0]
    number = re.match(r"\(?0x([0-9a-f]{1,2}) *,", name.strip(), re.I)
    if number and int(number[1], 16) in sets:
        return int(number[1], 16)
    letters = _letters(name).removeprefix(_letters(lookup.PREFIX))
    begins = [(len(word), n) for n in sets for word in map(_letters, SETS.get(n, ())) if letters.startswith(word)]
    return max(begins)[1] if begins else None


def _letters(name: str) -> str:
    return re.sub(r"[^a-z0-9]", "", name.lower())
