"""The commands that list data, and the places of sets and field descriptors in their bytes.

With these places, each language finds the field for which a device rejects a command, or the command that it has
instead; see "Rejected fields" in spec/README.md. A list behind a parameter of variable size has no fixed place and is
left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace

from mipgen import model as m

from .extent import exact_size
from .session import session


@dataclass(frozen=True, slots=True)
class Listing:
    """A list of fields in a command, or a single field, or only a set. Offsets count from the beginning of the data."""

    command: m.Field
    set: int | None = None  # the set of all fields; None: the byte at `set_at`
    set_at: int = 0
    count_at: int | None = None  # the byte with the number of entries; None: there is one
    first: int | None = None  # the descriptor in the first entry; None: only a set is named
    stride: int = 1
    most: int | None = None  # entries
    decimation_at: int | None = None  # in an entry, from its descriptor: a u16 that must not be 0
    tag_at: int | None = None  # the byte that must be `tag`, or the list is not there
    tag: int = 0

    @property
    def row(self) -> tuple[int, ...]:
        """All of it in numbers, in the order of the attributes; -1 for None."""
        values = (getattr(self, f.name) for f in fields(self) if f.name != "command")
        return tuple(-1 if x is None else x for x in values)


def listings(model: m.Model) -> tuple[Listing, ...]:
    """Returns the lists of all commands, by set and descriptor."""
    start = session(model)
    older = {x.base_rate.command: x.set for x in start.older} if start else {}
    found: list[Listing] = []
    for f in (f for f in model.fields if f.role == m.COMMAND):
        found += (Listing(f, older[f]),) if f in older else _in_record(f.parameters, Listing(f), 0, model)
    return tuple(found)


def by_command(model: m.Model) -> dict[m.Field, list[Listing]]:
    lists: dict[m.Field, list[Listing]] = {}
    for x in listings(model):
        lists.setdefault(x.command, []).append(x)
    return lists


def alternatives(model: m.Model) -> dict[m.Field, list[m.Field]]:
    """Returns the commands with which devices that lack a command do the same."""
    found = {f: [x for name in f.alternatives if (x := model.field(name))] for f in model.fields}
    return {f: others for f, others in found.items() if others}


def defined(model: m.Model) -> dict[int, tuple[int, ...]]:
    """Returns the descriptors that are defined as data, by set; those of 0xFF may be in each data set."""
    sets: dict[int, set[int]] = {}
    for f in model.fields:
        for place in f.occurrences if f.role == m.DATA else ():
            sets.setdefault(place.set, set()).add(f.descriptor)
    return {number: tuple(sorted(sets[number])) for number in sorted(sets)}


def _in_record(parameters: tuple[m.Parameter, ...], of: Listing, at: int, model: m.Model) -> Iterator[Listing]:
    """Yields the lists in a record that begins at this offset."""
    places: dict[str, int] = {}
    has_list = False
    for p in parameters:
        places[p.name] = at
        if p.union:
            for c in p.cases:
                if c.parameter is not None and c.parameter.struct and p.tag in places:
                    inside = replace(of, tag_at=places[p.tag], tag=c.tag.value)
                    yield from _in_record(c.parameter.struct.parameters, inside, at, model)
        elif p.fields_of:
            named = model.set_named(p.fields_of)
            listed = replace(of, set=named.number if named else None, set_at=places.get(p.fields_of, 0))
            has_list = True
            yield _entries(p, listed, at, places, parameters)
        size = exact_size(p)
        if size is None or size.terms:
            return
        at += size.fixed
    sets = [places[p.name] for p in parameters if p.shown == "set"]
    if not has_list and len(sets) == 1:
        yield replace(of, set_at=sets[0])


def _entries(
    p: m.Parameter, of: Listing, at: int, places: dict[str, int], parameters: tuple[m.Parameter, ...]
) -> Listing:
    """Returns the list that a parameter contains."""
    counter = next((q for q in parameters if q.counts == p.name), None)
    of = replace(of, first=at, stride=p.item.max_size if isinstance(p.item, m.Struct) else 1)
    if counter is not None:
        of = replace(of, count_at=places[counter.name], most=None if counter.maximum is None else int(counter.maximum))
    inside = 0
    for q in p.item.struct.parameters if p.item.struct else ():
        if q.shown == "field":
            of = replace(of, first=at + inside)
        elif q.minimum == 1 and q.size == 2:
            of = replace(of, decimation_at=inside)
        inside += q.size
    return replace(of, stride=inside or 1)
