"""The commands that start a device's data, as Python expressions."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower

from . import names


@dataclass(frozen=True, slots=True)
class Older:
    """The commands of an older device for one set."""

    descriptor_set: int
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
    identity: m.Field
    identify: str
    information: str  # the path from its response to the parameters with the model's number
    descriptors: tuple[str, ...]
    older: tuple[Older, ...]
    timestamps: tuple[tuple[int, int], ...]  # set, 0 for all, and descriptor


def session_commands(model: m.Model) -> Session | None:
    """Returns the commands; None if the specification, or the selected part of it, lacks one of them."""
    start = lower.session(model)
    if start is None:
        return None
    item = start.entries.item.struct
    assert item is not None
    used: list[m.Type | m.Field] = [start.base_rate.command, start.format, item, start.stream, start.resume]
    used += [start.identify, *start.descriptors]
    used += [f for x in start.older for f in (x.base_rate.command, x.format)]
    return Session(
        tuple(sorted({names.home(thing) for thing in used})),
        *_data(start.base_rate, start.format),
        names.qualified(item),
        _call(start.stream),
        _call(start.resume),
        start.identify,
        _call(start.identify),
        ".".join(map(names.member, start.model_numbers[0].split(".")[:-1])),
        tuple(map(_call, start.descriptors)),
        tuple(Older(x.set, *_data(x.base_rate, x.format), x.stream) for x in start.older),
        tuple((number, f.descriptor) for number, f in start.timestamps),
    )


def _data(rate: lower.Rate, message_format: m.Field) -> tuple[str, str, str]:
    """Returns the command that reads a base rate, the rate in its response, and the command for the format."""
    return _call(rate.command), names.member(rate.parameter.name), _call(message_format)


def _call(f: m.Field) -> str:
    """Returns the constructor of a command for its first function; calls pass the parameters that this function
    requires."""
    function = f.calls[0].function
    return names.qualified(f) + (f".{names.member(function.name)}" if function else "")
