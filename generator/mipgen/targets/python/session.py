"""The commands that start the data of a device, as expressions of Python."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower

from . import names


@dataclass(frozen=True, slots=True)
class Older:
    """Those of an older device for one set."""

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
    """None if the specification, or the part of it, does not have all of these commands."""
    found = lower.session(model)
    if found is None:
        return None
    item = found.entries.item.struct
    assert item is not None
    used: list[m.Type | m.Field] = [found.base_rate.command, found.format, item, found.stream, found.resume]
    used += [f for x in found.older for f in (x.base_rate.command, x.format)]
    return Session(
        modules=tuple(sorted({names.home(thing) for thing in used})),
        base_rate=_call(found.base_rate.command),
        rate=names.member(found.base_rate.parameter.name),
        format=_call(found.format),
        item=names.qualified(item),
        stream=_call(found.stream),
        resume=_call(found.resume),
        older=tuple(
            Older(
                x.set, _call(x.base_rate.command), names.member(x.base_rate.parameter.name), _call(x.format), x.stream
            )
            for x in found.older
        ),
    )


def _call(f: m.Field) -> str:
    """What makes the command: its first function, as it is called with the parameters that this requires."""
    function = f.calls[0].function
    return names.qualified(f) + (f".{names.member(function.name)}" if function else "")
