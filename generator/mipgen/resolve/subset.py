"""Partial specifications: the selected fields and what they need.

The result is a model, so that a part is generated like the whole.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.base.errors import Failure
from mipgen.model.guides import Guide
from mipgen.read.problems import nearest


@dataclass(frozen=True, slots=True)
class Selection:
    """A selection: the union of the sets and fields, restricted to the devices."""

    devices: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    fields: tuple[str, ...] = ()
    certain: bool = False  # only what a device certainly supports

    def __bool__(self) -> bool:
        return bool(self.devices or self.sets or self.fields or self.certain)


def select(model: m.Model, selection: Selection) -> m.Model:
    """Returns the selected part of the model."""
    if selection.certain:
        if not selection.devices:
            raise Failure("--certain requires a device; add --device")
        model = replace(model, devices=tuple(replace(d, supports=d.certain) for d in model.devices))
    selection = replace(selection, sets=tuple(_set_name(model, word) for word in selection.sets))
    _check(model, selection)
    needed = _needed(model, _asked(model, selection), selection.devices)
    devices = tuple(d for d in model.devices if not selection.devices or d.id in selection.devices)
    if not needed:
        named = ", ".join(d.title for d in devices)
        what = "certain: leave out --certain, or add" if selection.certain else "known: add"
        raise Failure(f"no command or data field of {named} is {what} another --device")
    return _only(model, needed, devices)


def _set_name(model: m.Model, word: str) -> str:
    """Finds the name of a set given by name, or by number as manuals print it: 0x80."""
    if not re.fullmatch("0[xX][0-9A-Fa-f]{1,2}", word):
        return word
    number = int(word, 16)
    s = next((s for s in model.sets if s.number == number), None)
    if s is None:
        choices = ", ".join(f"0x{s.number:02X}" for s in sorted(model.sets, key=lambda s: s.number))
        raise Failure(f"no set has the number 0x{number:02X}; known: {choices}")
    return s.name


def left_out(whole: m.Model, part: m.Model) -> str:
    """Lists what was omitted, on one line."""
    counts = [
        (len(whole.fields) - len(part.fields), "fields"),
        (len(whole.sets) - len(part.sets), "sets"),
        (len(whole.devices) - len(part.devices), "devices"),
        (len(whole.examples) - len(part.examples), "examples"),
    ]
    parts = ", ".join(f"{n} {what if n > 1 else what[:-1]}" for n, what in counts if n)
    return f"a part of the specification; left out: {parts or 'nothing'}"


def _check(model: m.Model, selection: Selection) -> None:
    by_kind = {
        "device": (selection.devices, [d.id for d in model.devices]),
        "set": (selection.sets, [s.name for s in model.sets]),
        "field": (selection.fields, list(model.names)),
    }
    for what, (asked, names) in by_kind.items():
        for name in asked:
            if name not in names:
                similar = _meant(model, name) if what == "device" else []
                if len(similar) == 1 and isinstance(similar[0], m.NamedDevice):
                    raise Failure(similar[0].sentence)
                meant = " or ".join(f"'{d.id}'" for d in similar if isinstance(d, m.Device))
                near = f", did you mean {meant}?" if meant else nearest(name.casefold(), names)
                raise Failure(f"unknown {what} '{name}'{near}")
    for what, asked in (("set", selection.sets), ("field", selection.fields)) if selection.devices else ():
        for name in asked:
            having = {
                d.id
                for f, number in _places(model, what, name)
                for answer in m.SUPPORTED
                for d in model.devices_of(f, answer, number)
            }
            if having.isdisjoint(selection.devices):
                others = [d.id for d in model.devices if d.id in having]
                raise Failure(
                    f"no selected device has the {what} '{name}'; remove it, or "
                    + (f"select a device that has it: {', '.join(others)}" if others else "select no device")
                )


def _places(model: m.Model, what: str, name: str) -> Iterator[tuple[m.Field, int]]:
    """Yields the fields of a set, or with a name, each with the number of its set."""
    for f in model.fields:
        for o in f.occurrences:
            if name in ((o.set_name,) if what == "set" else (f.full_name, f.name_in(o.set))):
                yield f, o.set


def _meant(model: m.Model, word: str) -> list[m.Device | m.NamedDevice]:
    """Returns the devices that a user may mean by another name, a part of a name, or the model number."""

    def plain(name: str) -> str:
        return "".join(c for c in name.casefold() if c.isalnum())

    devices: tuple[m.Device | m.NamedDevice, ...] = (*model.devices, *model.named)
    near = []
    for d in devices:
        names = [plain(name) for name in (d.id, d.title, *d.also)]
        if plain(word) in (*names, str(d.model_number)):
            return [d]
        if plain(word) and any(plain(word) in name for name in names):
            near.append(d)
    return near


def _asked(model: m.Model, selection: Selection) -> dict[str, m.Field]:
    """Returns the fields selected by name, by set or by device, in the sets in which they occur; responses follow their
    commands. Shared fields belong to every data set, so any data field selects them.
    """
    every = not (selection.sets or selection.fields)
    supported = {s.name for d in model.devices if d.id in selection.devices for s in d.supports}
    asked: dict[str, m.Field] = {}
    for f in model.fields:
        names = {o: f.name_in(o.set) for o in f.occurrences}
        offered = [o for o in names if not selection.devices or f.role == m.RESPONSE or names[o] in supported]
        in_sets = [o for o in offered if f.role != m.RESPONSE and (every or o.set_name in selection.sets)]
        by_name = [o for o in offered if not {f.full_name, names[o]}.isdisjoint(selection.fields)]
        if in_sets or by_name:
            asked[f.full_name] = replace(f, occurrences=tuple(o for o in names if o in (*in_sets, *by_name)))
    if any(f.role == m.DATA for f in asked.values()):
        shared = (f for f in model.fields if f.everywhere)
        asked |= {f.full_name: f for f in shared if not selection.devices or f.full_name in supported}
    return asked


def _needed(model: m.Model, asked: dict[str, m.Field], devices: tuple[str, ...]) -> dict[str, m.Field]:
    """Adds the responses or commands of fields.

    If devices are given, only their layouts of a response are added.
    """
    needed: dict[str, m.Field] = {}
    waiting = list(asked.values())
    while waiting:
        f = waiting.pop()
        if f.full_name not in needed:
            needed[f.full_name] = asked.get(f.full_name, f)
            layouts = [r for d in devices for r in model.answers(f, d)] if devices else model.responses(f)
            waiting += layouts
            waiting += model.commands(f) if f.role == m.RESPONSE else ()
            waiting += [s for c in f.silenced_by if (s := model.field(c.command or "")) is not None]
    return needed


def _only(model: m.Model, needed: dict[str, m.Field], devices: tuple[m.Device, ...]) -> m.Model:
    """Returns the model without other fields, and without what only those need."""
    ids = {d.id for d in devices}
    acknowledge = _narrowed(model.protocol.acknowledge, ids, needed)
    fields = {name: _narrowed(f, ids, needed) for name, f in needed.items()}
    types = _types([acknowledge, *fields.values()])
    families = [
        replace(
            x,
            sets=tuple(s for s in x.sets if any(o.set == s.number for f in own for o in f.occurrences)),
            types=tuple(t for t in x.types if _key(t) in types),
            fields=tuple(own),
        )
        for x in model.families
        if (own := [fields[f.full_name] for f in x.fields if f.full_name in fields])
    ]
    kept = {f.name_in(o.set): f for f in (acknowledge, *fields.values()) for o in f.occurrences}
    examples = tuple(e for e in model.examples if all(x.field is None or x.field in kept for x in e.fields))
    printed = {e.id for e in examples}
    sets = {s.name: s for x in families for s in x.sets}
    whole = tuple(_device(d, sets, kept) for d in devices)
    by_name = {**kept, acknowledge.full_name: acknowledge, **fields}
    return replace(
        model,
        protocol=replace(model.protocol, acknowledge=acknowledge),
        types=tuple(t for t in model.types if isinstance(t, m.Vector) or _key(t) in types),
        families=tuple(families),
        devices=whole,
        examples=examples,
        errata=tuple(e for e in model.errata if _concerns(e, kept, printed)),
        simulation=model.simulation.only(by_name),
        guides=_guides(model.guides, by_name, whole),
        named=(),
        programs=(),  # they may use any field
    )


def _guides(guides: tuple[Guide, ...], fields: dict[str, m.Field], devices: tuple[m.Device, ...]) -> tuple[Guide, ...]:
    """Returns the remaining guides, without references to the others."""
    kept = [g for guide in guides if (g := guide.only(fields, {d.id: d for d in devices})) is not None]
    names = {g.name for g in kept}
    return tuple(replace(g, see=tuple(x for x in g.see if "." in x or x in names)) for g in kept)


def _device(d: m.Device, sets: dict[str, m.Set], fields: dict[str, m.Field]) -> m.Device:
    named = {f.full_name: f for f in fields.values()}
    supports, refuses = (
        tuple(replace(s, field=fields[s.name]) for s in part if s.name in fields) for part in (d.supports, d.refuses)
    )
    return replace(
        d,
        evidence=tuple(e for e in d.evidence if any(s.evidence == e for s in (*supports, *refuses))),
        supports=supports,
        refuses=refuses,
        complete=tuple(sets[s.name] for s in d.complete if s.name in sets),
        base_rates=tuple(replace(r, set=sets[r.set.name]) for r in d.base_rates if r.set.name in sets),
        variants=tuple(replace(v, field=named[v.field.full_name]) for v in d.variants if v.field.full_name in named),
    )


def _narrowed(f: m.Field, devices: set[str], names: Container[str]) -> m.Field:
    """Returns the field with only the variants, devices and responses of the subset."""
    parameters = tuple(
        replace(p, variants=tuple(v for v in p.variants if not v.by_device or v.key in devices)) for p in f.parameters
    )
    responses = tuple(name for name in f.responses if f"{f.family}.{name}" in names)
    senders = tuple(d for d in f.devices if d in devices) or f.devices
    return replace(f, parameters=parameters, responses=responses, devices=senders)


def _concerns(e: m.Erratum, fields: Container[str], examples: Container[str]) -> bool:
    """True if all claims of an erratum are about selected parts."""
    kinds = {"length": fields, "example": examples}
    return all(c.subject in kinds[c.kind] for c in e.claims if c.kind in kinds)


# --------------------------------------------------------------------------- types

Key = tuple[str | None, str]


def _key(t: m.Type) -> Key:
    return t.owner, t.name


def _types(fields: Iterable[m.Field]) -> set[Key]:
    """Returns the types that fields need, directly or inside other types."""
    needed: set[Key] = set()
    waiting = [t for f in fields for p in f.parameters for t in p.types]
    while waiting:
        t = waiting.pop()
        if _key(t) not in needed:
            needed.add(_key(t))
            waiting += _inside(t)
    return needed


def _inside(t: m.Type) -> Iterator[m.Type]:
    match t:
        case m.Struct():
            yield from (inner for p in t.parameters for inner in p.types)
        case m.Bitfield():
            yield from (b.enum for b in t.bits if b.enum is not None)
