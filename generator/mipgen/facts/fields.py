"""Facts about fields: their exchange, devices and limits."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from mipgen import model as m

from .devices import firmware
from .texts import (
    Fact,
    Ref,
    Text,
    device_ref,
    device_refs,
    fact,
    field_ref,
    functions,
    interleaved,
    joined,
    number,
    prose,
    remarks,
    thing_ref,
)


def field_facts(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """Yields the facts about a field besides its description."""
    yield from _status(f, model)
    yield from _exchange(f, model)
    yield from _conditions(f, model)
    yield from _relations(f, model)
    yield from _limits(f)
    yield from _devices(f, model)
    yield from _evidence(f, model)
    yield from remarks(f, model)


def _status(f: m.Field, model: m.Model) -> Iterator[Fact]:
    if f.deprecated:
        yield fact("deprecated", prose(f.deprecated.rstrip("."), model), "Deprecated: {}.")
    if f.advanced:
        yield fact("advanced", (), "For advanced use.")
    if len(f.occurrences) > 1:
        sets = [s for s in model.sets if s.number in f.sets]
        yield fact("sets", joined([(thing_ref(s),) for s in sets]), "Occurs in {}.")
    if f.also:
        yield fact("also", joined([(f"`{name}`",) for name in f.also]), "Also called {}.")


def _exchange(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """States the response that the field requests, and the command that it answers."""
    if f.functions:
        yield fact("functions", functions(f.functions), "Functions: {}.")
    if f.responses:
        yield fact("responses", joined([(field_ref(r),) for r in model.responses(f)], "or"), "Response: {}.")
    if f.role == m.RESPONSE and model.commands(f):
        yield fact("commands", joined([(field_ref(c),) for c in model.commands(f)]), "Response to {}.")
    others = [g for g in model.layouts(f) if g is not f and g.signature == f.signature]
    if others:
        names = joined([(field_ref(g),) for g in others])
        yield fact("layout", names, "The size of its data distinguishes it from {}.")


def _conditions(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """States the conditions under which a field is sent, and those under which a command is not acknowledged."""
    if f.when:
        command = next(c for c in model.commands(f) if c.name == f.command)
        yield fact("when", conditions(f.when, command), "Sent if {}.")
    if f.silent_when:
        yield fact("silent", conditions(f.silent_when, f), "Not acknowledged if {}.")
    for c in f.silenced_by:
        yield fact("silent", _setting(c, model), "Not acknowledged if {}.")
    if f.sent_by == "device":
        yield fact("sent_by", (), "Sent by the device; the host replies.")


def _relations(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """States the fields that a field changes, the fields that change it, and the flags that concern it."""
    for certain, topic, word in ((True, "affects", "Affects"), (False, "may_affect", "Probably affects")):
        things = model.affected(f, certain)
        if things:
            yield fact(topic, joined([(thing_ref(x),) for x in things]), f"{word} {{}}.")
    others = [x for name in f.alternatives if (x := model.field(name))]
    if others:
        yield fact("alternatives", joined([(thing_ref(x),) for x in others]), "Devices without it may have {}.")
    yield from changed(f, model)
    flags = model.flagged_by(f)
    if flags:
        of_types: list[Text] = []
        for _, group in groupby(flags, lambda pair: (pair[0].owner, pair[0].name)):
            pairs = list(group)
            t = pairs[0][0]
            of_types.append((*joined([(Ref(b, b.name, t),) for _, b in pairs]), " of ", Ref(t, t.name)))
        yield fact("flags", interleaved(of_types, "; "), "Status flags about it: {}.")


def changed(thing: m.Field | m.Set, model: m.Model) -> Iterator[Fact]:
    """States the commands that change a data field, or all fields of a set."""
    for certain, word in ((True, "affect"), (False, "probably affect")):
        commands = model.changed_by(thing, certain)
        if commands:
            yield fact("affected", joined([(field_ref(c),) for c in commands]), f"Settings that {word} it: {{}}.")


def _limits(f: m.Field) -> Iterator[Fact]:
    if f.timeout:
        yield fact("timeout", (f"{number(f.timeout)} s",), "The device may take {} to reply.")


def _devices(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """States the devices that support a field, and their differences."""
    certain, likely, assumed = (model.devices_of(f, answer) for answer in m.SUPPORTED)
    others = len(likely) + len(assumed)
    if certain:
        text = "Supported by {}."
        if others and len(certain) + others == len(model.devices):
            text = "Supported by all devices; confirmed on {}."
        elif others:
            text = f"Confirmed on {{}}; likely or assumed on {others} more."
        yield fact("devices", device_refs(certain), text)
    for topic, devices in (("likely", likely), ("assumed", assumed)):
        if devices:
            yield fact(topic, device_refs(devices), f"{topic.capitalize()} on {{}}.")
    refusing = model.refusing(f)
    if refusing:
        yield fact("refused", device_refs(refusing), "Not supported by {}.")
    if model.devices and f.role != m.RESPONSE and not certain and not others:
        yield fact("devices", (), "Not listed in any device profile.")
    yield from (_deprecation(d, s.deprecated, model) for d, s in model.supports(f) if s.deprecated)
    versions = dict.fromkeys(s.firmware for _, s in model.supports(f) if s.firmware)
    yield from (_firmware([d for d, s in model.supports(f) if s.firmware == x], x) for x in versions)
    yield from (_support(d, s) for d, s in model.supports(f) if s.differs)


def _evidence(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """States the sources of a field that no manual describes."""
    names = {s.manual for s in f.sources}
    cited = [x for x in model.protocol.manuals if x.id in names]
    if cited and all(x.kind == "sdk" for x in cited):
        yield fact("evidence", joined([(Ref(x, x.title),) for x in cited]), "Known only from the {}.")


def _support(d: m.Device, s: m.Support) -> Fact:
    taken = functions(s.functions)
    return Fact("support", taken, ("On the ", device_ref(d), ": ", *taken, " only."))


def _firmware(devices: list[m.Device], versions: str) -> Fact:
    which = firmware(versions)
    return Fact("firmware", (which,), (f"Requires {which} on the ", *device_refs(devices), "."))


def _deprecation(d: m.Device, instead: str, model: m.Model) -> Fact:
    text = prose(instead.rstrip("."), model)
    return Fact("deprecation", text, ("Deprecated on the ", device_ref(d), ": ", *text, "."))


def conditions(of: Sequence[m.Condition], command: m.Field) -> Text:
    """Words conditions on the parameters of a command."""
    return joined([condition(c, command) for c in of])


def condition(c: m.Condition, command: m.Field) -> Text:
    p = next(p for p in command.parameters if p.name == c.parameter)
    entry = p.element.by_name(c.label) if isinstance(p.element, m.Enum) else None
    value: str | Ref = Ref(entry, entry.name, p.element) if entry and isinstance(p.element, m.Enum) else c.label
    return (Ref(p, p.name, command), " is ", value)


def _setting(c: m.Condition, model: m.Model) -> Text:
    """Words a setting of another command, which a partial specification may lack."""
    command = model.field(c.command or "")
    if command is None:
        return (f"{c.parameter} of {c.command} is {c.label}",)
    parameter, *rest = condition(c, command)
    return (parameter, " of ", field_ref(command), *rest)
