"""Guides: the part of the model that `spec/guides` defines.

A guide states how to achieve a purpose: the packets to send, their order and reasons, and the replies. Packets and
replies are computed from the author's values.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mipgen.read.problems import Position

    from . import Device, Field, Set, Source


@dataclass(frozen=True, slots=True)
class Shown:
    """A field in a packet, with all its values in the form of the codec."""

    field: Field
    values: dict[str, Any]
    data: bytes
    stated: tuple[str, ...] = ()  # the parameters whose values are certain; the other values are examples


@dataclass(frozen=True, slots=True)
class Stream:
    """Data packets that a step causes."""

    set: Set
    fields: tuple[Shown, ...]
    packet: bytes
    rate: float | int | None = None  # Hz; None: one packet, or one at each event
    on_event: str = ""  # the event at which the device sends one


@dataclass(frozen=True, slots=True)
class Step:
    """One command, its purpose, and the reply."""

    reason: str
    command: Field
    values: dict[str, Any]
    packet: bytes
    answer: bytes  # acknowledge, and response
    host: str = ""  # what a program then does besides commands
    response: Shown | None = None
    data: tuple[Stream, ...] = ()


@dataclass(frozen=True, slots=True)
class Sequence:
    """An ordered list of steps, for certain devices."""

    title: str
    devices: tuple[Device, ...]
    steps: tuple[Step, ...]
    notes: tuple[str, ...] = ()

    @property
    def streams(self) -> tuple[Stream, ...]:
        return tuple(s for step in self.steps for s in step.data)

    @property
    def used(self) -> set[str]:
        """The full names of the commands sent, and of the data fields received."""
        return {f.full_name for s in self.steps for f in (s.command, *(x.field for t in s.data for x in t.fields))}


@dataclass(frozen=True, slots=True)
class Change:
    """Fields of one device, and their replacement on another."""

    fields: tuple[Field, ...]
    by: tuple[Field, ...]
    note: str


@dataclass(frozen=True, slots=True)
class Migration:
    """A migration from one device to another: every field that the other lacks is in one of the changes."""

    before: Device
    after: Device
    changes: tuple[Change, ...]


@dataclass(frozen=True, slots=True)
class Picture:
    shows: str  # what it shows, for readers who do not see it
    svg: str


@dataclass(frozen=True, slots=True)
class Question:
    """A question that people ask, or a symptom of a problem, with the answer."""

    question: str
    answer: str
    see: tuple[str, ...] = ()  # names of guides and full names of fields

    def only(self, fields: dict[str, Field]) -> Question:
        """Returns the question without references to fields that a partial specification lacks."""
        return replace(self, see=_seen(self.see, fields))


@dataclass(frozen=True, slots=True)
class Guide:
    name: str
    title: str  # the purpose: "stream IMU data at 100 Hz"
    question: str
    answer: str
    sequences: tuple[Sequence, ...]
    picture: Picture | None = None
    lead: str = ""  # the question on the first page that leads to it
    before: tuple[str, ...] = ()  # prerequisites
    questions: tuple[Question, ...] = ()
    notes: tuple[str, ...] = ()
    tables: tuple[str, ...] = ()  # tables of facts about all devices: base_rates, baud_rates
    migration: Migration | None = None
    see: tuple[str, ...] = ()  # names of guides and full names of fields
    sources: tuple[Source, ...] = ()
    position: Position | None = field(default=None, compare=False)

    def only(self, fields: dict[str, Field], devices: dict[str, Device]) -> Guide | None:
        """Returns the part about these fields and devices; None if nothing remains."""
        sequences = [_only(s, fields, devices) for s in self.sequences]
        kept = tuple(s for s in sequences if s is not None)
        m = self.migration
        if (self.sequences and not kept) or (m is not None and _lost(m, fields, devices)):
            return None
        questions = tuple(q.only(fields) for q in self.questions)
        moved = m and _moved(m, fields, devices)
        return replace(self, sequences=kept, questions=questions, see=_seen(self.see, fields), migration=moved)


def _seen(see: tuple[str, ...], fields: dict[str, Field]) -> tuple[str, ...]:
    return tuple(name for name in see if "." not in name or name in fields)


def _only(s: Sequence, fields: dict[str, Field], devices: dict[str, Device]) -> Sequence | None:
    """Returns the sequence for the remaining devices; None if one of its fields is missing."""
    used = [step.command for step in s.steps] + [x.field for t in s.streams for x in t.fields]
    used += [step.response.field for step in s.steps if step.response is not None]
    left = tuple(devices[d.id] for d in s.devices if d.id in devices)
    if not left or any(f.full_name not in fields for f in used):
        return None
    if any(t.set.number not in fields[x.field.full_name].sets for t in s.streams for x in t.fields):
        return None
    return replace(s, devices=left, steps=tuple(_step(step, fields) for step in s.steps))


def _step(step: Step, fields: dict[str, Field]) -> Step:
    """Returns the step with the fields of the partial specification."""
    response = step.response and _shown(step.response, fields)
    data = tuple(replace(t, fields=tuple(_shown(x, fields) for x in t.fields)) for t in step.data)
    return replace(step, command=fields[step.command.full_name], response=response, data=data)


def _shown(shown: Shown, fields: dict[str, Field]) -> Shown:
    return replace(shown, field=fields[shown.field.full_name])


def _lost(m: Migration, fields: dict[str, Field], devices: dict[str, Device]) -> bool:
    named = [f for c in m.changes for f in (*c.fields, *c.by)]
    return not {m.before.id, m.after.id} <= devices.keys() or any(f.full_name not in fields for f in named)


def _moved(m: Migration, fields: dict[str, Field], devices: dict[str, Device]) -> Migration:
    changes = tuple(
        Change(tuple(fields[f.full_name] for f in c.fields), tuple(fields[f.full_name] for f in c.by), c.note)
        for c in m.changes
    )
    return Migration(devices[m.before.id], devices[m.after.id], changes)
