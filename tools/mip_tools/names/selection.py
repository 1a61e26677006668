"""The fields named on the command line."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ..binding import UnknownName, registry
from ..errors import Misuse
from .occurrence import Occurrence, occurrence_in, occurrences_named, sets_of
from .search import finds_any, numbered

_NUMBERS = re.compile(r"(0[xX][0-9A-Fa-f]{1,2}|\d{1,3})(?:[:,](0[xX][0-9A-Fa-f]{1,2}|\d{1,3}))?")

#: (set, descriptor) of fields; without a descriptor, all fields of the set.
Key = tuple[int, int | None]


def resolve_keys(name: str) -> list[Key]:
    """Resolves a name: a field, a set, or numbers such as 0x80 or 0x80:0x04. Raises Failure."""
    numbers = _NUMBERS.fullmatch(name)
    if numbers is not None:
        set_number, descriptor = (None if n is None else int(n, 0) for n in numbers.groups())
        if set_number is None or set_number > 255 or (descriptor or 0) > 255:
            raise Misuse(f"'{name}' has a number above 255; use 0 to 255")
        return [(set_number, descriptor)]
    try:
        return [(registry.set_by_name(name), None)]
    except UnknownName:
        return [(number, kind.DESCRIPTOR) for number, kind in matching_fields(name)]


def matching_fields(name: str) -> list[Occurrence]:
    """Finds the fields with this name; several if it is ambiguous or several sets have it. Raises Failure."""
    numbers = _NUMBERS.fullmatch(name)
    if numbers is not None and numbers[2]:
        set_number = int(numbers[1], 0)
        kinds = registry.types(set_number, int(numbers[2], 0))
        if not kinds:
            raise Misuse(f"{name} is not a field; `mip fields` lists them")
        return [occurrence_in(set_number, kind) for kind in kinds]
    if found := numbered(name):
        return found
    try:
        return occurrences_named(name)
    except UnknownName as error:
        if error.kind == "ambiguous":
            return [occurrence for near in error.near for occurrence in occurrences_named(near)]
        more = f"`mip fields --search {name}` finds more" if finds_any(name) else "`mip fields` lists the sets"
        raise Misuse(f"{error}{'' if str(error).endswith('?') else ';'} {more}") from None


def near(name: str) -> str:
    """Suggests names of sets or fields similar to this one; empty if there are none."""
    for find in (registry.set_by_name, registry.by_name):
        try:
            find(name)
        except UnknownName as error:
            if "did you mean" in error.detail:
                return " or ".join(error.near)
    return ""


def one_field(name: str) -> Occurrence:
    """Finds the only field with this name. Raises Failure if several sets have one."""
    kinds = matching_fields(name)
    if len(kinds) > 1:
        raise Misuse(f"'{name}' is in several sets; write {' or '.join(k.name for k in kinds)}")
    return kinds[0]


class Selection:
    """The selected fields: all, or only those in `only`, and none of those in `without`.

    `data`: if `only` is empty, only data fields are selected, neither commands nor responses.
    """

    def __init__(self, only: Iterable[str] = (), without: Iterable[str] = (), data: bool = False) -> None:
        self._only = _all(only)
        self._without = _all(without)
        self._least = 0x80 if data and not self._only else 0  # the first set that is selected
        self._cache: dict[tuple[int, int], bool] = {}

    @property
    def has_names(self) -> bool:
        """Does the selection name fields?"""
        return bool(self._only)

    @property
    def everything(self) -> bool:
        return not self._only and not self._without

    def has(self, set_number: int, descriptor: int) -> bool:
        """Is this field selected in packets of this set?"""
        is_selected = self._cache.get((set_number, descriptor))
        if is_selected is None:
            is_selected = not self._only or _within(self._only, set_number, descriptor)
            is_selected = is_selected and set_number >= self._least
            is_selected = is_selected and not _within(self._without, set_number, descriptor)
            self._cache[set_number, descriptor] = is_selected
        return is_selected


def _all(names: Iterable[str]) -> set[Key]:
    """Resolves names; each text may contain several, separated by commas."""
    chosen: set[Key] = set()
    for text in names:
        if _NUMBERS.fullmatch(text):
            chosen.update(resolve_keys(text))
            continue
        for name in filter(None, (part.strip() for part in text.split(","))):
            chosen.update(resolve_keys(name))
    return chosen


def _within(wanted: set[Key], number: int, descriptor: int) -> bool:
    if (number, None) in wanted or (number, descriptor) in wanted:
        return True
    if number < 0x80:  # the acknowledge field belongs to no set
        return (0, descriptor) in wanted
    shared = not any(sets_of(t) for t in registry.types(number, descriptor))
    return shared and ((0xFF, descriptor) in wanted or (0xFF, None) in wanted)
