"""The commands that find a device and start its data, as Rust expressions.

They are written as bytes, because a firmware with a function that encodes each type would be a tenth larger.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower
from mipgen.lower.extent import item_size

from . import names
from .view import Crate


@dataclass(frozen=True, slots=True)
class Sent:
    """A command, and the bytes of its data as expressions."""

    path: str
    data: str


@dataclass(frozen=True, slots=True)
class Start:
    """How the data of a set is started."""

    base_rate: Sent
    rate: str  # the member of its response
    format: Sent  # up to the list
    number: str  # of the stream


@dataclass(frozen=True, slots=True)
class Session:
    families: tuple[str, ...]  # features
    bauds: tuple[int, ...]
    ping: Sent
    idle: Sent
    resume: Sent
    identify: Sent
    model_numbers: tuple[str, ...]  # members of its response
    descriptors: tuple[tuple[Sent, str], ...]  # the commands that list what a device has, and their numbers in a list
    item: str  # of a message format
    start: Start
    older: tuple[tuple[int, Start], ...]  # by set
    timestamps: tuple[tuple[int, int], ...]  # set, 0 for all, and descriptor
    stream: Sent
    baud_changes: tuple[tuple[str, str], ...]  # commands that write a baud rate, and the rate

    @property
    def needs(self) -> str:
        """The condition for `cfg`."""
        return ", ".join(f'feature = "{name}"' for name in self.families)


def compose(model: m.Model) -> Session | None:
    """Returns the commands; None if the specification, or the selected part of it, lacks one of them."""
    commands = lower.session(model)
    if commands is None:
        return None
    crate = model.derived(Crate)

    def start(base_rate: lower.Rate, message_format: m.Field, number: str, *arguments: str) -> Start:
        return Start(
            _sent(base_rate.command, *arguments),
            names.member(base_rate.parameter.name),
            _sent(message_format, *arguments),
            number,
        )

    item = commands.entries.item.struct
    assert item is not None
    older = (f for x in commands.older for f in (x.base_rate.command, x.format))
    used = [*commands.commands, *commands.descriptors, *older]
    families = {f.family for f in used}
    return Session(
        families=tuple(sorted(map(names.module, families))),
        bauds=commands.bauds,
        ping=_sent(commands.ping),
        idle=_sent(commands.idle),
        resume=_sent(commands.resume),
        identify=_sent(commands.identify),
        model_numbers=tuple(".".join(map(names.member, x.split("."))) for x in commands.model_numbers),
        descriptors=tuple((_sent(f), f"0x{f.set:02X}{f.descriptor:02X}") for f in commands.descriptors),
        item=names.path(item, ""),
        start=start(commands.base_rate, commands.format, "set.0", "set.0"),
        older=tuple((x.set, start(x.base_rate, x.format, str(x.stream))) for x in commands.older),
        timestamps=tuple((number, f.descriptor) for number, f in commands.timestamps),
        stream=_sent(commands.stream, "number", "1"),
        baud_changes=tuple(_baud_changes(crate, families)),
    )


def _sent(f: m.Field, *values: str) -> Sent:
    """The command with its first function and these values, which have one byte each. An array follows the data."""
    call, rest = f.calls[0], iter(values)
    data = [str(call.function.value)] if call.function else []
    for p in call.required:
        if p.kind != "array":
            assert item_size(p) == 1, f"{f.full_name}: {p.name} has several bytes"
            data.append("count" if p.counts else next(rest))
    return Sent(names.path(f, ""), ", ".join(data))


def _baud_changes(crate: Crate, families: set[str]) -> Iterator[tuple[str, str]]:
    commands = [f for f in crate.model.fields if f.role == m.COMMAND and f.family in families]
    members = [(f, x) for f in commands for x in crate.record(f).members if x.parameter.units == ("Bd",)]
    for f, x in members:
        command = names.path(f, "")
        if not f.selector:
            yield command, f"self.{x.name}" if x.may_be_absent else f"Some(self.{x.name})"
        for function in (c.function for c in f.calls if x.parameter in c.required):
            if function and function.sets and function.reply:
                yield f"crate::protocol::{names.call_type(function)}<{command}>", f"self.{x.name}"
