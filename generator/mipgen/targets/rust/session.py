"""The commands that find a device and start its data, as Rust expressions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower

from . import names
from .records import Records


@dataclass(frozen=True, slots=True)
class BaseRate:
    call: str
    rate: str  # the member of its response


@dataclass(frozen=True, slots=True)
class Older:
    """Like `Session`, for one data set of an older device."""

    set: int
    call: str
    rate: str
    format: str
    list: str
    stream: str


@dataclass(frozen=True, slots=True)
class BaudChange:
    """A command that writes a baud rate."""

    command: str
    value: str


@dataclass(frozen=True, slots=True)
class Session:
    families: tuple[str, ...]  # features
    bauds: tuple[int, ...]
    ping: str
    idle: str
    resume: str
    base_rate: BaseRate
    format: str  # without its arguments
    list: str
    item: str
    stream: str
    older: tuple[Older, ...]
    baud_changes: tuple[BaudChange, ...]

    @property
    def needs(self) -> str:
        """The condition for `cfg`."""
        return ", ".join(f'feature = "{name}"' for name in self.families)


def of(model: m.Model) -> Session | None:
    """Returns the commands; None if the specification, or the selected part of it, lacks one of them."""
    start = lower.session(model)
    if start is None:
        return None
    records = model.derived(Records)

    def called(f: m.Field, *arguments: str) -> str:
        return f"{_way(f, records)}({', '.join(arguments)})"

    def listed(f: m.Field) -> str:
        return records.rust(next(p for p in f.calls[0].required if p.kind == "array"), "")

    item = start.entries.item.struct
    assert item is not None
    used = [*start.commands, *(f for x in start.older for f in (x.base_rate.command, x.format))]
    families = {f.family for f in used}
    return Session(
        families=tuple(sorted(map(names.module, families))),
        bauds=start.bauds,
        ping=called(start.ping),
        idle=called(start.idle),
        resume=called(start.resume),
        base_rate=BaseRate(called(start.base_rate.command, "set"), names.member(start.base_rate.parameter.name)),
        format=_way(start.format, records),
        list=listed(start.format),
        item=_path(item),
        stream=called(start.stream, "set", "true"),
        older=tuple(
            Older(
                set=x.set,
                call=called(x.base_rate.command),
                rate=names.member(x.base_rate.parameter.name),
                format=_way(x.format, records),
                list=listed(x.format),
                stream=called(start.stream, f"{x.stream}", "true"),
            )
            for x in start.older
        ),
        baud_changes=tuple(_baud_changes(model, records, families)),
    )


def _baud_changes(model: m.Model, records: Records, families: set[str]) -> Iterator[BaudChange]:
    for f in model.fields:
        if f.role != m.COMMAND or f.family not in families:
            continue
        for x in records.members(f):
            if x.parameter.units != ("Bd",):
                continue
            if not f.selector:
                yield BaudChange(_path(f), f"self.{x.name}" if x.may_be_absent else f"Some(self.{x.name})")
            for function in (c.function for c in f.calls if x.parameter in c.required):
                if function and function.sets and function.reply:
                    call = f"crate::protocol::{names.call_type(function)}<{_path(f)}>"
                    yield BaudChange(call, f"self.{x.name}")


def _way(f: m.Field, records: Records) -> str:
    """Returns the constructor for the first function of a command."""
    return f"{_path(f)}::{records.constructors(f)[0].name}"


def _path(thing: m.Type | m.Field) -> str:
    return names.path(thing, "")
