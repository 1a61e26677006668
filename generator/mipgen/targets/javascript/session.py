"""The commands that find a device and start its data, as JavaScript expressions."""

from __future__ import annotations

from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import session as lower
from mipgen.lower import validity

from . import names


@dataclass(frozen=True, slots=True)
class Rate:
    """The command that reads a base rate, and the response's member that contains the rate."""

    command: str
    member: str


@dataclass(frozen=True, slots=True)
class Older:
    set: int
    base_rate: Rate
    format: str
    stream: int


@dataclass(frozen=True, slots=True)
class Session:
    modules: tuple[tuple[str, str], ...]  # their names here, and their files
    bauds: tuple[int, ...]
    ping: str
    idle: str
    resume: str
    identify: str
    model_numbers: tuple[str, ...]  # paths in its response
    descriptors: tuple[str, ...]
    identity: tuple[str, str]  # the device's response: its module and its class
    base_rate: Rate
    format: str
    item: tuple[str, str]
    stream: str
    older: tuple[Older, ...]
    timestamps: tuple[tuple[int, tuple[str, ...], tuple[int, ...]], ...]  # descriptor, names of clocks, sets; none: all

    @property
    def clocks(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(name for _, names, _ in self.timestamps for name in names))


def session_commands(model: m.Model) -> Session | None:
    """Returns the commands; None if the specification, or the selected part of it, lacks one of them."""
    start = lower.session(model)
    if start is None:
        return None
    used = [*start.commands, *start.descriptors, *(f for x in start.older for f in (x.base_rate.command, x.format))]
    modules = {names.namespace(f.family): names.module(f.family) for f in used}
    (identity,) = model.responses(start.identify)
    known = {t.field: t for t in validity.timestamps(model)}
    stamps = [known[f] for f in dict.fromkeys(f for _, f in start.timestamps)]
    item = start.entries.item.struct
    assert item is not None
    descriptor, decimation = (names.member(p.name) for p in item.parameters)
    return Session(
        modules=tuple(sorted(modules.items())),
        bauds=start.bauds,
        ping=_call(start.ping),
        idle=_call(start.idle),
        resume=_call(start.resume),
        identify=_call(start.identify),
        model_numbers=tuple(".".join(map(names.member, path.split("."))) for path in start.model_numbers),
        descriptors=tuple(map(_call, start.descriptors)),
        identity=(names.module(identity.family), names.class_name(identity)),
        base_rate=_rate(start.base_rate, "set"),
        format=_call(start.format, "set", "items"),
        item=(descriptor, decimation),
        stream=_call(start.stream, "set", "true"),
        older=tuple(Older(x.set, _rate(x.base_rate), _call(x.format, "items"), x.stream) for x in start.older),
        timestamps=tuple(
            (t.field.descriptor, tuple(c.name for c in t.clocks), () if t.field.everywhere else t.sets) for t in stamps
        ),
    )


def _rate(rate: lower.Rate, *arguments: str) -> Rate:
    return Rate(_call(rate.command, *arguments), names.member(rate.parameter.name))


def _call(f: m.Field, *arguments: str) -> str:
    """Writes a command with its first function and these values of the parameters that the function requires."""
    way = f.calls[0]
    values = ", ".join(f"{names.member(p.name)}: {a}" for p, a in zip(way.values, arguments, strict=True))
    name = f"{names.namespace(f.family)}.{names.class_name(f)}"
    head = f"{name}.{names.camel(way.function.name)}" if way.function else f"new {name}"
    return f"{head}({{ {values} }})" if values else f"{head}()"
