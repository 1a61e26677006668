"""A part of a specification: the selected fields and what they need.

The result is a model, so that a part is generated like the whole.
"""

from __future__ import annotations

from collections.abc import Container, Iterable
from dataclasses import dataclass, replace

from . import model as m
from .errors import Failure
from .guided import Guide
from .problems import nearest


@dataclass(frozen=True, slots=True)
class Selection:
    """A selection. Sets and fields add up; devices narrow them."""

    devices: tuple[str, ...] = ()
    sets: tuple[str, ...] = ()
    fields: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.devices or self.sets or self.fields)


def select(model: m.Model, selection: Selection) -> m.Model:
    """The part of the model that is selected."""
    _check(model, selection)
    names = _needed(model, _asked(model, selection), selection.devices)
    devices = tuple(d for d in model.devices if not selection.devices or d.id in selection.devices)
    return _only(model, names, devices)


def left_out(whole: m.Model, part: m.Model) -> str:
    """One line that says what was left out."""
    counts = [
        (len(whole.fields) - len(part.fields), "fields"),
        (len(whole.sets) - len(part.sets), "sets"),
        (len(whole.devices) - len(part.devices), "devices"),
        (len(whole.examples) - len(part.examples), "examples"),
    ]
    said = ", ".join(f"{n} {what if n > 1 else what[:-1]}" for n, what in counts if n)
    return f"a part of the specification; left out: {said or 'nothing'}"


def _check(model: m.Model, selection: Selection) -> None:
    known = {
        "device": (selection.devices, [d.id for d in model.devices]),
        "set": (selection.sets, [s.name for s in model.sets]),
        "field": (selection.fields, [f.full_name for f in model.fields]),
    }
    for what, (asked, names) in known.items():
        for name in asked:
            if name not in names:
                meant = " or ".join(f"'{d}'" for d in _meant(model, name)) if what == "device" else ""
                near = f", did you mean {meant}?" if meant else nearest(name.casefold(), names)
                raise Failure(f"unknown {what} '{name}'{near}")
    for what, asked in (("set", selection.sets), ("field", selection.fields)) if selection.devices else ():
        for name in asked:
            fields = [f for f in model.fields if name == (f.set_name if what == "set" else f.full_name)]
            having = {d.id for f in fields for d in (*model.devices_of(f), *model.devices_of(f, certain=False))}
            if having.isdisjoint(selection.devices):
                others = [d.id for d in model.devices if d.id in having]
                raise Failure(
                    f"the {what} '{name}' is of no selected device; leave it out, or "
                    + (f"name a device that has it: {', '.join(others)}" if others else "select no device")
                )


def _meant(model: m.Model, word: str) -> list[str]:
    """The devices that people call so: other names, a part of a name, the model number."""

    def plain(name: str) -> str:
        return "".join(c for c in name.casefold() if c.isalnum())

    found = []
    for d in model.devices:
        names = [plain(name) for name in (d.id, d.title, *d.also)]
        if plain(word) in (*names, str(d.model_number)):
            return [d.id]
        if plain(word) and any(plain(word) in name for name in names):
            found.append(d.id)
    return found


def _asked(model: m.Model, selection: Selection) -> list[m.Field]:
    """The fields selected by name, by set or by device; responses follow their commands.

    Shared fields belong to every data set, so any data field selects them.
    """
    every = not (selection.sets or selection.fields)
    supported = {s.field.full_name for d in model.devices if d.id in selection.devices for s in d.supports}
    offered = [f for f in model.fields if not selection.devices or f.full_name in supported]
    found = [f for f in offered if f.role != m.RESPONSE and (every or f.set_name in selection.sets)]
    found += [f for f in model.fields if f.full_name in selection.fields]
    if any(f.role == m.DATA for f in found):
        found += [f for f in offered if f.set == m.SHARED_SET]
    return found


def _needed(model: m.Model, asked: Iterable[m.Field], devices: tuple[str, ...]) -> set[str]:
    """The same with their responses or commands, and with the fields whose layout they repeat.

    Of several layouts of a response only those of the devices, if any are given.
    """
    names: set[str] = set()
    waiting = list(asked)
    while waiting:
        f = waiting.pop()
        if f.full_name not in names:
            names.add(f.full_name)
            layouts = [r for d in devices for r in model.answers(f, d)] if devices else model.responses(f)
            waiting += layouts
            waiting += model.commands(f) if f.role == m.RESPONSE else ()
            waiting.append(model.original(f))
            waiting += [s for c in f.silenced_by if (s := model.field(c.command or "")) is not None]
    return names


def _only(model: m.Model, names: set[str], devices: tuple[m.Device, ...]) -> m.Model:
    """The model without other fields, and without what only these need."""
    ids = {d.id for d in devices}
    acknowledge = _narrowed(model.protocol.acknowledge, ids, names)
    fields = {f.full_name: _narrowed(f, ids, names) for f in model.fields if f.full_name in names}
    types = _types([acknowledge, *fields.values()])
    sets = {
        s.name: replace(
            s,
            types=tuple(t for t in s.types if _key(t) in types),
            fields=tuple(fields[f.full_name] for f in s.fields if f.full_name in names),
        )
        for s in model.sets
    }
    sets = {name: s for name, s in sets.items() if s.fields}
    kept = {acknowledge.full_name: acknowledge, **fields}
    examples = tuple(e for e in model.examples if all(x.field is None or x.field in kept for x in e.fields))
    printed = {e.id for e in examples}
    whole = tuple(_device(d, sets, kept) for d in devices)
    return replace(
        model,
        protocol=replace(model.protocol, acknowledge=acknowledge),
        types=tuple(t for t in model.types if isinstance(t, m.Vector) or _key(t) in types),
        sets=tuple(sets.values()),
        devices=whole,
        examples=examples,
        errata=tuple(e for e in model.errata if _concerns(e, kept, printed)),
        simulation=model.simulation.only(kept),
        guides=_guides(model.guides, kept, whole),
        tastes=(),  # they may use any field
    )


def _guides(guides: tuple[Guide, ...], fields: dict[str, m.Field], devices: tuple[m.Device, ...]) -> tuple[Guide, ...]:
    """What remains of the guides; they name only each other."""
    found = [g for guide in guides if (g := guide.only(fields, {d.id: d for d in devices})) is not None]
    names = {g.name for g in found}
    return tuple(replace(g, see=tuple(x for x in g.see if "." in x or x in names)) for g in found)


def _device(d: m.Device, sets: dict[str, m.Set], fields: dict[str, m.Field]) -> m.Device:
    return replace(
        d,
        supports=tuple(replace(s, field=fields[s.field.full_name]) for s in d.supports if s.field.full_name in fields),
        base_rates=tuple(replace(r, set=sets[r.set.name]) for r in d.base_rates if r.set.name in sets),
        variants=tuple(replace(v, field=fields[v.field.full_name]) for v in d.variants if v.field.full_name in fields),
    )


def _narrowed(f: m.Field, devices: set[str], names: set[str]) -> m.Field:
    """The field without what differs on other devices, and without responses that are left out."""
    parameters = tuple(
        replace(p, variants=tuple(v for v in p.variants if not v.by_device or v.key in devices)) for p in f.parameters
    )
    responses = tuple(name for name in f.responses if f"{f.set_name}.{name}" in names)
    senders = tuple(d for d in f.devices if d in devices) or f.devices
    return replace(f, parameters=parameters, responses=responses, devices=senders)


def _concerns(e: m.Erratum, fields: Container[str], examples: Container[str]) -> bool:
    """Are all claims of an erratum about selected parts?"""
    known = {"length": fields, "example": examples}
    return all(c.subject in known[c.kind] for c in e.claims if c.kind in known)


# --------------------------------------------------------------------------- types

Key = tuple[str | None, str]


def _key(t: m.Type) -> Key:
    return (None if isinstance(t, m.Vector) else t.owner, t.name)


def _types(fields: Iterable[m.Field]) -> set[Key]:
    """The types that fields need, directly or inside others."""
    found: set[Key] = set()

    def need(t: m.Type) -> None:
        if _key(t) in found:
            return
        found.add(_key(t))
        if isinstance(t, m.Struct):
            for p in t.parameters:
                visit(p)
        elif isinstance(t, m.Bitfield):
            for b in t.bits:
                if b.enum is not None:
                    need(b.enum)

    def visit(p: m.Parameter) -> None:
        if p.element is not None and not isinstance(p.element, m.Scalar):
            need(p.element)
        for v in p.variants:
            if v.type is not None:
                need(v.type)
        for c in p.cases:
            if c.parameter is not None:
                visit(c.parameter)

    for f in fields:
        for p in f.parameters:
            visit(p)
    return found
