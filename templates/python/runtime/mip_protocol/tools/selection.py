"""The fields that names on the command line mean."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from difflib import get_close_matches

from .. import registry
from ..errors import Failure
from ..field import Field

_NUMBERS = re.compile(r"(0[xX][0-9A-Fa-f]{1,2}|\d{1,3})(?:[:,](0[xX][0-9A-Fa-f]{1,2}|\d{1,3}))?")

#: (set, descriptor) of fields; without a descriptor, all fields of the set.
Key = tuple[int, int | None]


def keys(name: str) -> list[Key]:
    """What a name means: a field, a set, or numbers such as 0x80 and 0x80:0x04. Raises Failure."""
    numbers = _NUMBERS.fullmatch(name)
    if numbers is not None:
        set, descriptor = (None if n is None else int(n, 0) for n in numbers.groups())
        if set is None or set > 255 or (descriptor or 0) > 255:
            raise Failure(f"'{name}' has numbers above 255")
        return [(set, descriptor)]
    sets = {module: number for number, module in registry.MODULES.items()}
    sets |= {kind.NAME.partition(".")[0]: number for number, kind in _first_types()}
    if name in sets:
        return [(sets[name], None)]
    return [(set, kind.DESCRIPTOR) for set, kind in fields(name)]


def fields(name: str) -> list[tuple[int, type[Field]]]:
    """The (set, type) of a field, several if it has several layouts. Raises Failure."""
    wanted = name.lower().replace("-", "_")
    known = registry.all_types()
    found = [(set, kind) for set, kind in known if wanted in (kind.NAME, kind.__name__.lower())]
    if not found:
        found = [(set, kind) for set, kind in known if kind.NAME.partition(".")[2] == wanted]
    if not found:
        raise Failure(f"'{name}' is no field{nearest(name)}; `mip fields` lists them all")
    return found


def field(name: str) -> tuple[int, type[Field]]:
    """The one field of this name. Raises Failure if several sets have one."""
    found = fields(name)
    places = list(dict.fromkeys(kind.NAME for _, kind in found))
    if len(places) > 1:
        raise Failure(f"'{name}' is in several sets; write {' or '.join(places)}")
    return found[0]


def nearest(name: str) -> str:
    """`; do you mean …?` with names that are close."""
    names = [kind.NAME for _, kind in registry.all_types()]
    short = {full.partition(".")[2]: full for full in names}
    close = get_close_matches(name.lower(), names, 3, 0.6)
    close += [short[s] for s in get_close_matches(name.lower(), short, 3, 0.75)]
    close += [full for full in names if len(name) > 3 and name.lower() in full]
    close = list(dict.fromkeys(close))[:4]
    return f"; do you mean {' or '.join(close)}?" if close else ""


def _first_types() -> Iterator[tuple[int, type[Field]]]:
    seen: set[int] = set()
    for number, kind in registry.all_types():
        if number not in seen:
            seen.add(number)
            yield number, kind


class Selection:
    """The fields that are wanted: all, or those of `only`, and none of `without`."""

    def __init__(self, only: Iterable[str] = (), without: Iterable[str] = ()) -> None:
        self._only = _all(only)
        self._without = _all(without)
        self._known: dict[tuple[int, int], bool] = {}

    @property
    def everything(self) -> bool:
        return not self._only and not self._without

    def has(self, set: int, descriptor: int) -> bool:
        """Is this field of a packet of this set wanted?"""
        known = self._known.get((set, descriptor))
        if known is None:
            known = not self._only or _within(self._only, set, descriptor)
            known = known and not _within(self._without, set, descriptor)
            self._known[set, descriptor] = known
        return known


def _all(names: Iterable[str]) -> set[Key]:
    """The keys of names, each perhaps several with commas between."""
    found: set[Key] = set()
    for text in names:
        if _NUMBERS.fullmatch(text):
            found.update(keys(text))
            continue
        for name in filter(None, (part.strip() for part in text.split(","))):
            found.update(keys(name))
    return found


def _within(wanted: set[Key], number: int, descriptor: int) -> bool:
    if (number, None) in wanted or (number, descriptor) in wanted:
        return True
    if number < 0x80:  # the acknowledge is of no set
        return (0, descriptor) in wanted
    shared = not any(t.SET == number for t in registry.types(number, descriptor))
    return shared and ((0xFF, descriptor) in wanted or (0xFF, None) in wanted)


__all__ = ["Key", "Selection", "field", "fields", "keys", "nearest"]
