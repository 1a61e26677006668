"""The commands that start the data of a device, as expressions of Python."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m

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
    given = model.protocol.session
    if given is None or not all(model.field(name) for name in given.commands):
        return None
    base_rate, message_format, stream, resume = (
        _field(name, model) for name in (given.base_rate, given.format, given.stream, given.resume)
    )
    item = next(p.item.struct for p in message_format.parameters if p.kind == "array")
    assert item is not None
    older = [x for x in given.older if model.field(x.base_rate) and model.field(x.format)]
    used: list[m.Type | m.Field] = [base_rate, message_format, stream, resume, item]
    used += [_field(name, model) for x in older for name in (x.base_rate, x.format)]
    return Session(
        modules=tuple(sorted({names.home(thing) for thing in used})),
        base_rate=_call(base_rate),
        rate=_rate(base_rate, model),
        format=_call(message_format),
        item=names.qualified(item),
        stream=_call(stream),
        resume=_call(resume),
        older=tuple(_older(x, model) for x in older),
    )


def _older(older: m.Older, model: m.Model) -> Older:
    base_rate, message_format = _field(older.base_rate, model), _field(older.format, model)
    (number,) = (s.number for s in model.sets if s.name == older.set)
    return Older(number, _call(base_rate), _rate(base_rate, model), _call(message_format), older.stream)


def _field(name: str, model: m.Model) -> m.Field:
    found = model.field(name)
    assert found is not None
    return found


def _call(f: m.Field) -> str:
    """What makes the command: its first function, as it is called with the parameters that this requires."""
    function = f.calls[0].function
    return names.qualified(f) + (f".{names.member(function.name)}" if function else "")


def _rate(f: m.Field, model: m.Model) -> str:
    """The member of the response that is in Hz."""
    (response,) = model.responses(f)
    return next(names.member(p.name) for p in response.parameters if p.units == ("Hz",))
