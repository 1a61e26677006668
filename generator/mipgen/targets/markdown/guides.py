"""Guides: their packets, the replies, the data that follows, and the programs that do the same."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Literal

from mipgen import model as m
from mipgen.facts import describe
from mipgen.facts.sample_values import GivenValues
from mipgen.lower import codec
from mipgen.model.guides import Guide, Question, Step, Stream
from mipgen.model.guides import Sequence as Steps

from . import examples
from .devices import hertz
from .places import Page
from .snippets import Program, sequences
from .text import code, inline, plain, spaced, table

#: Longer packets are shown only with their step, not in the overview.
SHORT = 36

#: Bits that a UART sends for each byte.
BITS = 10

Role = Literal["command", "reply", "data"]


def heading(guide: Guide) -> str:
    """Writes the title of a guide, which is the reader's goal, as a heading."""
    return plain(guide.title[0].upper() + guide.title[1:])


def named(page: Page, guide: Guide | Question) -> list[str]:
    """Returns links to the related guides and fields."""
    guides = {g.name: g for g in page.model.guides}
    fields = [page.model.field(name) for name in guide.see if name not in guides]
    return [page.link(guides[name]) for name in guide.see if name in guides] + [page.link(f) for f in fields if f]


def with_field(page: Page, f: m.Field) -> list[Guide]:
    """Returns the guides that use a field in a step or in data."""
    return page.index.guides.get(f.full_name, [])


# --------------------------------------------------------------------------- packets


def overview(page: Page, steps: Steps) -> str:
    """Lists all packets of a sequence, ready to be sent, and their replies."""
    rows = [
        [str(i), f"{page.link(s.command)}{_function(s)}", _bytes(s.packet), _bytes(s.answer) or "none"]
        for i, s in enumerate(steps.steps, 1)
    ]
    return table(rows, ["Step", "Command", "Send", "Reply"])


def _function(step: Step) -> str:
    function = _call(step).function
    return f", {code(function.name)}" if function else ""


def _bytes(packet: bytes) -> str:
    return code(spaced(packet)) if len(packet) <= SHORT else f"{len(packet)} bytes, see the step"


def title(step: Step) -> str:
    function = _call(step).function
    return inline(f"{step.command.title}, {function.name}" if function else step.command.title)


def sent(page: Page, step: Step, steps: Steps) -> str:
    """Explains each byte of a command."""
    return _table(page, "command", step.packet, [(step.command, step.values)], steps)


def answered(page: Page, step: Step, steps: Steps) -> str:
    """Explains each byte of the reply."""
    ack = page.model.protocol.acknowledge
    fields = [(ack, codec.decode(ack, bytes([step.command.descriptor, 0]))[0])]
    fields += [(step.response.field, step.response.values)] if step.response else []
    return _table(page, "reply", step.answer, fields, steps)


def come(page: Page, stream: Stream, steps: Steps) -> str:
    """Explains each byte of a data packet."""
    return _table(page, "data", stream.packet, [(x.field, x.values) for x in stream.fields], steps)


def _table(page: Page, role: Role, packet: bytes, fields: Iterable[tuple[m.Field, codec.Values]], steps: Steps) -> str:
    parts = tuple(
        m.ExampleField(f.full_name, f.descriptor, codec.encode(f, values), values, 0, None) for f, values in fields
    )
    shown = m.Example("", "", "", "", role, None, None, packet, parts, "", device=steps.devices[0])
    return examples.packet_table(page, shown)


# --------------------------------------------------------------------------- answers and data


def surely(step: Step) -> str:
    """States which values of the response are certain after the steps before it."""
    if step.response is None:
        return ""
    given = {p.name for p in step.response.field.parameters if not p.derived}
    sure = [code(name) for name in step.response.stated if name in given]
    if len(sure) == len(given):
        return "After these steps, the device replies with these values."
    if not sure:
        return "These are example values; other values will differ."
    return f"Only {' and '.join(sure)} {'is' if len(sure) == 1 else 'are'} fixed; other values will differ."


def streamed(page: Page, stream: Stream) -> str:
    """States the rate of data packets, and their contents."""
    *others, last = [page.link(x.field) for x in stream.fields]
    fields = f"{', '.join(others)} and {last}" if others else last
    sent = f"a packet of {page.link(stream.set)} with {fields}"
    if stream.rate is not None:
        return f"The device sends {sent} at {describe.number(stream.rate)} Hz."
    return (
        f"{inline(f'At {stream.on_event}')}, the device sends {sent}."
        if stream.on_event
        else f"The device then sends {sent}."
    )


def read(steps: Steps) -> list[m.Field]:
    """Returns the data fields that the sequence starts; their pages contain programs that read them."""
    return list({x.field.full_name: x.field for s in steps.streams for x in s.fields}.values())


def rates(page: Page, steps: Steps) -> list[str]:
    """Computes the rate of each stream, on each device."""
    rates = {
        f"{inline(d.title)}, {page.link(s.set)}: {hertz(r)} / {s.rate:g} Hz = decimation {r.hertz / s.rate:g}"
        for d in steps.devices
        for s in steps.streams
        for r in d.base_rates
        if s.rate and r.set.number == s.set.number and r.hertz
    }
    return sorted(rates)


def bandwidth(steps: Steps) -> str:
    """Computes the load of the streams on a UART."""
    streams = [s for s in steps.streams if s.rate]
    if not streams:
        return ""
    each = [f"{_number(s.rate)} × {len(s.packet)}" for s in streams]
    whole = sum((s.rate or 0) * len(s.packet) for s in streams)
    fitting = _fitting(steps.devices[0], whole * BITS)
    rate = (
        f" On {inline(fitting[0])} of the {inline(steps.devices[0].title)}, use {fitting[1]} or more."
        if fitting
        else ""
    )
    return f"{' + '.join(each)} = {_number(whole)} bytes per second, which needs {_number(whole * BITS)} baud.{rate}"


def _fitting(d: m.Device, bits: float) -> tuple[str, int] | None:
    """Returns the first port with baud rates, and the lowest sufficient one; None if there is none."""
    port = next((p for p in d.ports if p.baud_rates), None)
    rate = min((r for r in port.baud_rates if r >= bits), default=None) if port else None
    return (port.name, rate) if port and rate else None


def _number(value: float | None) -> str:
    return f"{value:,.6g}" if value is not None and value < 1e6 else f"{value:,.0f}"


def doubts(page: Page, steps: Steps) -> list[str]:
    """States why a device is only believed to support the fields of the sequence."""
    used = steps.used
    return [
        f"The {page.link(d)} probably supports {page.link(s.field)}. "
        f"{page.say(describe.evidence(s.evidence, page.model))}"
        for d in steps.devices
        for s in d.supports
        if not s.certain and s.field.full_name in used
    ]


# --------------------------------------------------------------------------- programs


def programs(page: Page, steps: Steps, guide: Guide) -> list[Program]:
    """Writes the sequence as a program in each language."""
    sent = [(s.command, _given(page, s)) for s in steps.steps]
    name = guide.name if len(guide.sequences) == 1 else f"{guide.name}_{guide.sequences.index(steps) + 1}"
    return sequences(page, name, sent)


def _given(page: Page, step: Step) -> GivenValues:
    return GivenValues(page.model, _call(step), step.values, step.host)


def _call(step: Step) -> m.Call:
    function = step.values.get("function")
    return next(x for x in step.command.calls if (x.function.value if x.function else None) == function)


# --------------------------------------------------------------------------- tables


def fact_table(page: Page, name: str) -> str:
    """Writes a table of one fact for all devices; `guides.TABLES` lists the names of the facts."""
    return {"base_rates": _base_rates, "baud_rates": _baud_rates}[name](page)


def _base_rates(page: Page) -> str:
    devices = [d for d in page.model.devices if any(r.hertz for r in d.base_rates)]
    sets = [s for s in page.model.sets if any(r.set.number == s.number for d in devices for r in d.base_rates)]
    rows = [
        [page.link(d), *(next((hertz(r) for r in d.base_rates if r.set.number == s.number), "") for s in sets)]
        for d in devices
    ]
    return table(rows, ["Device", *(page.link(s) for s in sets)])


def _baud_rates(page: Page) -> str:
    rows = [
        [page.link(d), inline(p.name), ", ".join(map(str, p.baud_rates))]
        for d in page.model.devices
        for p in d.ports
        if p.baud_rates
    ]
    return table(rows, ["Device", "Port", "Baud rates"])


def changes(page: Page, guide: Guide) -> str:
    """Lists the replacements of the fields that the new device lacks."""
    move = guide.migration
    assert move is not None
    rows = [
        [page.links(x.fields), page.links(x.by) or "nothing", page.prose(x.note) if x.note else ""]
        for x in move.changes
    ]
    return table(rows, [inline(move.before.title), inline(move.after.title), "What is different"])


def meanings(page: Page, guide: Guide) -> str:
    """Lists the parameters that both devices support, but with different meanings."""
    move = guide.migration
    assert move is not None
    both = {f.full_name for f in _both(page, guide)}
    told = [{v.path: v for v in d.variants} for d in (move.before, move.after)]
    rows = []
    for path in dict.fromkeys([*told[0], *told[1]]):
        one = told[0].get(path) or told[1][path]
        owners = [f"{x.full_name}.{one.parameter.name}" for x in page.model.commands(one.field)]
        if one.field.full_name in both and not any(x in t for x in owners for t in told):  # a row describes both
            said = [_reading(page, t.get(path), one) for t in told]
            rows.append([page.link(one.field), code(one.parameter.name), *said])
    return table(rows, ["Field", "Parameter", inline(move.before.title), inline(move.after.title)]) if rows else ""


def _both(page: Page, guide: Guide) -> list[m.Field]:
    """Returns the fields that both devices certainly support: commands, data and responses."""
    assert guide.migration is not None
    wanted = {guide.migration.before.id, guide.migration.after.id}
    return [f for f in page.model.fields if wanted <= {d.id for d in page.model.devices_of(f)}]


def refused(page: Page, guide: Guide) -> str:
    """Lists the commands of both devices for which the new device accepts fewer functions."""
    move = guide.migration
    assert move is not None
    taken = [{s.field.full_name: s.functions for s in d.supports} for d in (move.before, move.after)]
    rows = []
    for f in _both(page, guide):
        before, after = (t.get(f.full_name, ()) for t in taken)
        lost = [x for x in before if x not in after]
        if lost:
            rows.append([page.link(f), ", ".join(f"{code(x.name)} ({x.value})" for x in lost)])
    return table(rows, ["Command", "Functions"]) if rows else ""


def _reading(page: Page, v: m.DeviceVariant | None, other: m.DeviceVariant) -> str:
    """States the meaning of a parameter on a device: the usual one unless the device differs."""
    if v is None:
        return page.say(describe.usual(other.variant, other.parameter, other.field, page.model))
    return page.say(describe.difference(v.variant, v.parameter, v.field, page.model))


def added(page: Page, guide: Guide) -> Iterator[str]:
    """Lists the new fields, set by set."""
    move = guide.migration
    assert move is not None
    known = {s.field.full_name for s in move.before.supports}
    for s in page.model.sets:
        new: Sequence[m.Field] = [
            x.field for x in move.after.certain if x.set == s.number and x.field.full_name not in known
        ]
        if new:
            yield f"{page.link(s)}: {', '.join(page.link(f, inline(f.title)) for f in new)}"
