"""The commands that find a device and start its data, as Rust expressions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower

from . import names
from .view import Crate


@dataclass(frozen=True, slots=True)
class Start:
    """How the data of a set is started."""

    base_rate: str
    rate: str  # the member of its response
    format: str  # with an empty list
    items: str  # that list, in a variable `format`
    stream: str


@dataclass(frozen=True, slots=True)
class Session:
    families: tuple[str, ...]  # features
    bauds: tuple[int, ...]
    ping: str
    idle: str
    resume: str
    identify: str
    model_numbers: tuple[str, ...]  # members of its response
    descriptors: tuple[tuple[str, str], ...]  # the commands that list what a device has, and their numbers in a list
    item: str  # of a message format
    start: Start
    older: tuple[tuple[int, Start], ...]  # by set
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

    def call(f: m.Field, *arguments: str) -> str:
        """Calls the constructor for the first function of a command."""
        return f"{names.path(f, '')}::{crate.record(f).constructors[0].name}({', '.join(arguments)})"

    def start(base_rate: lower.Rate, message_format: m.Field, stream: str, *arguments: str) -> Start:
        items = names.member(next(p for p in message_format.calls[0].required if p.kind == "array").name)
        if message_format.selector:  # the other functions have none
            items = f"command_mut().{items}.get_or_insert_with(List::new)"
        return Start(
            call(base_rate.command, *arguments),
            names.member(base_rate.parameter.name),
            call(message_format, *arguments, "List::new()"),
            f"format.{items}",
            call(commands.stream, stream, "true"),
        )

    item = commands.entries.item.struct
    assert item is not None
    older = (f for x in commands.older for f in (x.base_rate.command, x.format))
    used = [*commands.commands, *commands.descriptors, *older]
    families = {f.family for f in used}
    return Session(
        families=tuple(sorted(map(names.module, families))),
        bauds=commands.bauds,
        ping=call(commands.ping),
        idle=call(commands.idle),
        resume=call(commands.resume),
        identify=call(commands.identify),
        model_numbers=tuple(".".join(map(names.member, x.split("."))) for x in commands.model_numbers),
        descriptors=tuple((call(f), f"0x{f.set:02X}{f.descriptor:02X}") for f in commands.descriptors),
        item=names.path(item, ""),
        start=start(commands.base_rate, commands.format, "set", "set"),
        older=tuple((x.set, start(x.base_rate, x.format, str(x.stream))) for x in commands.older),
        baud_changes=tuple(_baud_changes(crate, families)),
    )


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
