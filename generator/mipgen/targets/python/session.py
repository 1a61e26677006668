"""The commands that start a device's data, as Python expressions."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower

from . import names


@dataclass(frozen=True, slots=True)
class Older:
    """The commands of an older device for one set."""

    set: int
    base_rate: str
    rate: str
    format: str
    stream: int


@dataclass(frozen=True, slots=True)
class Session:
    modules: tuple[str, ...]
    base_rate: str
    rate: str
    format: str
    item: str
    stream: str
    resume: str
    older: tuple[Older, ...]


def of(model: m.Model) -> Session | None:
    """Returns the commands; None if the specification, or the selected part of it, lacks one of them."""
    start = lower.session(model)
    if start is None:
        return None
    item = start.entries.item.struct
    assert item is not None
    used: list[m.Type | m.Field] = [start.base_rate.command, start.format, item, start.stream, start.resume]
    used += [f for x in start.older for f in (x.base_rate.command, x.format)]
    return Session(
        modules=tuple(sorted({names.home(thing) for thing in used})),
        base_rate=_call(start.base_rate.command),
        rate=names.member(start.base_rate.parameter.name),
        format=_call(start.format),
        item=names.qualified(item),
        stream=_call(start.stream),
        resume=_call(start.resume),
        older=tuple(
            Older(
                x.set, _call(x.base_rate.command), names.member(x.base_rate.parameter.name), _call(x.format), x.stream
            )
            for x in start.older
        ),
    )


def _call(f: m.Field) -> str:
    """Returns the constructor of a command for its first function; calls pass the parameters that this function
    requires."""
    function = f.calls[0].function
    return names.qualified(f) + (f".{names.member(function.name)}" if function else "")
