"""Fields: facts about them, their packets and replies, and lists of them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec
from mipgen.lower.extent import Extent, totals

from .places import Page
from .text import code, hexadecimal, inline, opening, table

#: Facts that are in tables, and facts with sections of their own.
TABLED = ("functions", "responses")
RELATIONS = ("affects", "may_affect", "affected", "flags")
DEVICES = ("devices", "perhaps", "refused", "deprecation", "firmware", "support")


def facts(page: Page, f: m.Field) -> str:
    """Writes the facts about a field besides its description. Its only command is omitted, as the page begins with
    it."""
    above = ["commands"] if f.role == m.RESPONSE and len(page.model.commands(f)) == 1 else []
    tabled = (*TABLED, *RELATIONS, *DEVICES, "note", *above)
    facts = (x for x in describe.field(f, page.model) if x.topic not in tabled)
    said = [(x.topic, page.say(x.sentence)) for x in facts]
    return " ".join(f"**{sentence}**" if topic == "deprecated" else sentence for topic, sentence in said)


def notes(page: Page, f: m.Field) -> list[str]:
    return _listed(page, f, "note")


def relations(page: Page, f: m.Field) -> list[str]:
    """Lists the fields that a field changes, the fields that change it, and the flags that concern it."""
    return _listed(page, f, *RELATIONS)


def on_devices(page: Page, f: m.Field) -> list[str]:
    """Lists the devices that support a field, and their differences."""
    return _listed(page, f, *DEVICES)


def _listed(page: Page, f: m.Field, *topics: str) -> list[str]:
    return [opening(page.say(x.sentence)) for x in describe.topics(describe.field(f, page.model), *topics)]


def changed(page: Page, s: m.Set) -> list[str]:
    """Lists the commands that may change every field of a set."""
    return [opening(page.say(x.sentence)) for x in describe.changed(s, page.model)]


# --------------------------------------------------------------------------- lengths


def length(parameters: Sequence[m.Parameter], head: int = 2) -> str:
    """Writes the length of a field with these parameters after `head` bytes."""
    lengths = [code(e) if e.terms else str(e) for e in totals(parameters, Extent(head))]
    return " or ".join([", ".join(lengths[:-1]), lengths[-1]] if len(lengths) > 1 else lengths)


def field_length(f: m.Field) -> str:
    """Writes the length of a field without a function selector."""
    (call,) = f.calls
    required, whole = length(call.required), length(f.parameters)
    return whole if required == whole else f"{required}; {whole} with all optional parameters"


# --------------------------------------------------------------------------- packets


def whole_packet(model: m.Model, f: m.Field, c: m.Call) -> bytes | None:
    """Builds the packet of a form without selectable values; None if it has some."""
    if any(p.constant is None for p in c.required):
        return None
    values = {"function": c.function.value} if c.function else {}
    return codec.build(model, f.set, [(f.descriptor, codec.encode(f, values))])


def checksum_steps(model: m.Model) -> list[dict[str, Any]]:
    """Computes the checksum of the first command without selectable values, byte by byte."""
    calls = ((f, c) for f in model.fields if f.role == m.COMMAND for c in f.calls)
    packet = next((p for f, c in calls if (p := whole_packet(model, f, c)) is not None), b"")
    sums = [codec.checksum(packet[: i + 1]) for i in range(len(packet[:-2]))]
    return [{"byte": byte, "a": a, "b": b} for byte, (a, b) in zip(packet, sums)]


# --------------------------------------------------------------------------- lists of fields

ENTRY = ["Descriptor", "Field", "Functions", "Responses"]


def entry(page: Page, f: m.Field, functions: Sequence[m.Function], d: m.Device | None = None) -> list[str]:
    """Writes a row about a field with these functions; for a device, with the responses that it sends."""
    asks = not f.functions or any(x.responds for x in functions)
    responses = (page.model.answers(f, d.id) if d else page.model.responses(f)) if asks else ()
    marks = [word for word, holds in (("advanced", f.advanced), ("deprecated", f.deprecated)) if holds]
    return [
        code(hexadecimal(f.descriptor)),
        page.link(f, inline(f.title)) + (f" ({', '.join(marks)})" if marks else ""),
        code(m.letters(functions)) if functions else "",
        ", ".join(page.link(r, code(hexadecimal(r.descriptor))) for r in responses),
    ]


def contents(page: Page, s: m.Set, listed: bool = True) -> str:
    """Lists the commands or data fields of a set that some device supports, or the others; may be empty."""
    rows = [
        [
            *entry(page, f, f.functions),
            size(f),
            *([page.links(page.model.devices_of(f, number=s.number))] if listed else []),
            first_sentence(page, f),
        ]
        for f in asked(page.model.fields_in(s))
        if _listed_in(page.model, f, s) == listed
    ]
    return table(rows, [*ENTRY, "Field length", *(["Supported by"] if listed else []), "Description"]) if rows else ""


def _listed_in(model: m.Model, f: m.Field, s: m.Set) -> bool:
    """True if a device certainly or probably supports the field in this set, or if the model has no devices."""
    has = any(model.devices_of(f, certain, s.number) for certain in (True, False))
    return has or not model.devices


def first_sentence(page: Page, f: m.Field) -> str:
    """Describes a field in one line."""
    return page.prose(re.split(r"(?<=\w\w[.!?]) (?=[A-Z`])", " ".join(f.description.split()))[0])


def size(f: m.Field) -> str:
    """Writes the length of a field, from the shortest form to the longest."""
    low = min(_shortest(c) for c in f.calls) if f.role == m.COMMAND else f.min_size
    return f"{low + 2}" if low == f.max_size else f"{low + 2} to {f.max_size + 2}"


def _shortest(c: m.Call) -> int:
    """Returns the size of the shortest data of a form."""
    return totals(c.required, Extent(1 if c.function else 0))[0].fixed


def named(page: Page, s: m.Set) -> str:
    """Lists the descriptors that sources name without a layout; empty if there are none."""
    rows = []
    family = page.model.family(s.family)
    for x in family.named if family else ():
        links = {
            c.manual: page.link(next(k for k in page.model.protocol.manuals if k.id == c.manual)) for c in x.sources
        }
        role = [x.role] if s.kind == "command" else []
        where = "; ".join(f"{links[c.manual]}: {inline(c.section)}" for c in x.sources)
        rows.append([code(hexadecimal(x.descriptor)), inline(x.title), code(f"{s.name}.{x.name}"), *role, where])
    headings = ["Descriptor", "Title", "Name", *(["Role"] if s.kind == "command" else []), "Sources"]
    return table(rows, headings) if rows else ""


def uncertain(page: Page, thing: m.Set | m.Family | m.Type) -> list[str]:
    """Lists the uncertainties about a set or a type; those about a field are among its facts."""
    return [opening(page.say(x.sentence)) for x in describe.uncertain(thing, page.model)]


def asked(fields: Sequence[m.Field]) -> list[m.Field]:
    """Returns the fields that are not responses; responses are shown with their commands."""
    return [f for f in fields if f.role != m.RESPONSE]


def on_page(page: Page, f: m.Field) -> list[m.Field]:
    """Returns the fields on the page of a command or a data field: the field, and the responses that it defines."""
    return [f, *own_responses(page, f)]


def own_responses(page: Page, f: m.Field) -> list[m.Field]:
    """Returns the responses that a command defines, which are described on its page."""
    return [r for r in page.model.responses(f) if r.command == f.name]
