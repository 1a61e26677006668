"""The commands that find a device and start its data, as named in the specification, with their responses.

Each language uses them in its own way: C in connect.c.j2, Rust in session.rs.j2, Python in streaming.py, JavaScript
in streaming.mjs. Tests on virtual devices of two generations: `test_c_first_day.py`, `test_rust_first_day.py`,
`test_start.py`, `test_javascript.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m

from . import validity


@dataclass(frozen=True, slots=True)
class Rate:
    """A command that reads a base rate, its response, and the response's parameter that contains the rate in Hz."""

    command: m.Field
    response: m.Field
    parameter: m.Parameter


@dataclass(frozen=True, slots=True)
class Older:
    """The commands of older devices for the data of one set."""

    set: int
    base_rate: Rate
    format: m.Field
    stream: int  # its number for the stream, instead of the set


@dataclass(frozen=True, slots=True)
class Session:
    bauds: tuple[int, ...]  # of all devices: first the rate of a new device, then in descending order
    model_numbers: tuple[str, ...]  # paths in the response of `identify`
    ping: m.Field
    idle: m.Field
    resume: m.Field
    identify: m.Field
    base_rate: Rate
    format: m.Field
    entries: m.Parameter  # of `format`: an array of descriptors and decimations
    stream: m.Field
    older: tuple[Older, ...]
    descriptors: tuple[m.Field, ...]  # list what the device has
    timestamps: tuple[tuple[int, m.Field], ...]  # to add to a stream, in this order: with their sets, 0 for all

    @property
    def commands(self) -> tuple[m.Field, ...]:
        """The commands that are sent to every device."""
        return (self.ping, self.idle, self.resume, self.identify, self.base_rate.command, self.format, self.stream)


def session(model: m.Model) -> Session | None:
    """Resolves the session; None if the specification, or the selected part of it, lacks one of the commands."""
    names = model.protocol.session
    fields = [f for name in names.commands if (f := model.field(name))] if names else []
    if names is None or len(fields) < len(names.commands):
        return None
    ping, idle, resume, identify, base_rate, message_format, stream = fields
    entries = next(p for p in message_format.calls[0].required if p.kind == "array")
    older = tuple(x for each in names.older if (x := _older(each, model)))
    rate = _rate(base_rate, model)
    rates = {rate for d in model.devices for port in d.ports for rate in port.baud_rates}
    descriptors = tuple(f for name in names.descriptors if (f := model.field(name)))
    bauds = (names.baud, *sorted(rates - {names.baud}, reverse=True))
    return Session(
        bauds, names.model_numbers, ping, idle, resume, identify, rate, message_format, entries, stream, older,
        descriptors, _timestamps(model),
    )  # fmt: skip


def _timestamps(model: m.Model) -> tuple[tuple[int, m.Field], ...]:
    """Returns the timestamps that streams try until a device accepts one: first those that are always valid, then a
    set's own, which older devices have, then those that all sets share."""

    def order(t: validity.Timestamp) -> tuple[bool, bool]:
        return any(c.epoch for c in t.clocks), t.field.everywhere is not None

    known = sorted(reversed(validity.timestamps(model)), key=order)
    return tuple((number, t.field) for t in known for number in ((0,) if t.field.everywhere else t.sets))


def _older(older: m.Older, model: m.Model) -> Older | None:
    """Resolves the commands of older devices; None if a partial specification lacks the set or a command."""
    data_set = model.set_named(older.set)
    base_rate, message_format = model.field(older.base_rate), model.field(older.format)
    if data_set is None or base_rate is None or message_format is None:
        return None
    return Older(data_set.number, _rate(base_rate, model), message_format, older.stream)


def _rate(f: m.Field, model: m.Model) -> Rate:
    (response,) = model.responses(f)
    return Rate(f, response, next(p for p in response.parameters if p.units == ("Hz",)))
