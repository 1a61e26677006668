"""Writes MCAP files that Foxglove can open: a channel for each field, with JSON messages and their schemas."""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module
from typing import IO, Any, NamedTuple, Protocol, TypeVar

from .. import __version__
from ..binding import Described, Field, MissingExtra, Parameter, Structure, info
from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from . import inputs, outputs, values
from .clocks import dated
from .selection import Selection

#: The maximum number of messages that wait for the first time in a log.
HELD = 100_000

#: The separators in the JSON of messages.
SEPARATORS = (",", ":")

#: What the times of messages mean.
TIMES = {
    "dated": "UTC in ns since 1970, from the {} clock of the device",
    "undated": "ns since the origin of the {} clock of the device, which has no date",
    "host": "UTC in ns since 1970, when the host received it; the device has sent no time",
}


def require(form: str) -> Any:
    """Returns the module that writes MCAP. Raises Failure if it is not installed."""
    try:
        return import_module("mcap.writer")
    except ImportError:
        raise Failure(f"{MissingExtra('mcap', 'mcap')}; csv and jsonl need no extra") from None


class Message(NamedTuple):
    """A field as a message."""

    kind: Occurrence
    time: int | None
    own: bool  # does its packet have the time?
    packet: int
    data: Any  # as JSON or CDR


class _Timed(Protocol):
    """A sample or a message."""

    @property
    def time(self) -> int | None: ...


T = TypeVar("T", bound=_Timed)


class Job:
    """The output for a log."""

    def __init__(self, name: str, options: argparse.Namespace, selection: Selection) -> None:
        from .messages import survey

        self._name, self._options, self._selection = name, options, selection
        with inputs.columns(name) as log:
            self.types, self._clock = survey(log, selection)
        check(self._clock, options)

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes fields of these types into a file."""
        from .messages import Json, Messages

        named = self._options.named
        made = Messages(types, self._selection, self._clock, self._options.invalid, Json(named))
        with outputs.whole(path) as out, inputs.columns(self._name) as log:
            write_mcap(out, made.of(log), self._clock, named)


def check(clock: str | None, options: argparse.Namespace) -> None:
    """Raises Failure or Misuse if no clock provides the times that messages need."""
    if options.time not in (None, "utc", "clock"):
        raise Misuse(f"--time {options.time} is for tables; messages always have the time of the clock")
    if clock is None:
        raise Failure("the log has no packet with a valid time, which messages need; use csv or jsonl")
    if options.time == "utc" and not dated(clock):
        raise Failure("the log has no dates; use --time clock")


def write_mcap(out: IO[bytes], messages: Iterable[Message], clock: str | None, named: bool, live: bool = False) -> None:
    """Writes messages. The file is complete even after an interrupt.

    `live`: without a clock, messages have the time of the host.
    """
    module = require("mcap")
    writer = module.Writer(_Counted(out))
    writer.start(profile="", library=f"mip-tools {__version__}")
    meaning = clock_meaning(clock)
    writer.add_metadata("mip", {"clock": clock or "host", "time": meaning})
    channels: dict[Occurrence, int] = {}
    try:
        for one, moment in timed(messages, live and clock is None):
            kind = one.kind
            if kind not in channels:
                topic = Topic.of(kind, named)
                known = writer.register_schema(topic.schema_name, "jsonschema", topic.schema.encode())
                about = {"descriptor": f"0x{kind.set:02X},0x{kind.kind.DESCRIPTOR:02X}", "time": meaning}
                channels[kind] = writer.register_channel(topic.name, "json", known, about)
            writer.add_message(channels[kind], moment, one.data, moment, one.packet & 0xFFFFFFFF)
    finally:
        writer.finish()


class Topic(NamedTuple):
    """The name of a field's messages, and their schema."""

    name: str
    schema_name: str
    schema: str

    @classmethod
    def of(cls, kind: Occurrence, named: bool) -> Topic:
        """Makes the topic of a field."""
        text = json.dumps(schema(kind.kind, named))
        return cls(f"/mip/{kind.name.replace('.', '/')}", f"mip.{kind.name}", text)


def encoded(field: Field, named: bool) -> bytes:
    """Encodes a message as JSON."""
    return json.dumps(message(field, named), separators=SEPARATORS, allow_nan=False).encode()


class _Counted:
    """An output that knows its position, even if it is a pipe."""

    def __init__(self, out: IO[bytes]) -> None:
        self._out, self._size = out, 0

    def write(self, data: bytes) -> int:
        self._size += len(data)
        return self._out.write(data)

    def tell(self) -> int:
        return self._size

    def flush(self) -> None:
        self._out.flush()


def clock_meaning(clock: str | None) -> str:
    """Describes the times of messages in a sentence."""
    return TIMES["host" if clock is None else "dated" if dated(clock) else "undated"].format(clock)


def timed(samples: Iterable[T], by_host: bool) -> Iterator[tuple[T, int]]:
    """Yields each sample with its time in ns, or else the last known one, or else the first. Raises Failure if no
    sample has a time."""
    last: int | None = None
    waiting: list[T] = []
    for sample in samples:
        moment = time.time_ns() if by_host else sample.time
        last = last if moment is None else max(moment, 0)
        waiting.append(sample)
        if last is not None:
            yield from ((one, max(last if one.time is None else one.time, 0)) for one in waiting)
            waiting.clear()
        elif len(waiting) > HELD:
            raise Failure(f"the first {HELD} fields have no time; use --time clock, or jsonl")


# --------------------------------------------------------------------------- messages and schemas


def message(field: Field, named: bool) -> dict[str, Any]:
    """Returns the values of a field as its schema describes them, without numbers that JSON cannot represent."""
    return _object(field, values.plain(field, named))


def _object(record: Described, held: dict[str, Any]) -> dict[str, Any]:
    made = {}
    for p in info(type(record)).members:
        value = held[p.name]
        if isinstance(value, list) and p.elements and p.length is None:
            value = dict(zip(p.elements, value))
        if isinstance(value, dict):
            value = {k: v for k, v in value.items() if v is not None}
        if value is not None:
            made[p.name] = value
    return made


def schema(kind: type[Field], named: bool) -> dict[str, Any]:
    """Makes the JSON Schema of a field's messages."""
    found = info(kind)
    properties = {p.name: _of_parameter(p, named) for p in found.members}
    return {"title": found.name, "description": found.title, "type": "object", "properties": properties}


def _of_parameter(p: Parameter, named: bool) -> dict[str, Any]:
    notes = [*((f"in {p.unit}",) if p.unit not in ("", "1") else ()), *((f"frame: {p.frame}",) if p.frame else ())]
    said: dict[str, Any] = {"description": "; ".join(notes)} if notes else {}
    if p.kind == "text":
        return {"type": "string", **said}
    if p.kind in ("struct", "switch"):
        return {"type": "object", **said}
    one = _one(p, named)
    if p.kind == "array" and p.elements and p.length is None:
        return {"type": "object", "properties": dict.fromkeys(p.elements, one), **said}
    if p.kind == "array":
        return {"type": "array", "items": one, **said}
    return one | said


def _one(p: Parameter, named: bool) -> dict[str, Any]:
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        return {"type": "object"}
    if named and p.type is not None:
        return {} if hasattr(info(p.type), "bits") else {"type": "string"}
    if p.scalar in ("float", "double"):
        return {"type": "number"}
    return {"type": "boolean" if p.scalar == "bool" else "integer"}


__all__ = [
    "SEPARATORS",
    "Job",
    "Message",
    "Topic",
    "check",
    "clock_meaning",
    "encoded",
    "message",
    "require",
    "schema",
    "timed",
    "write_mcap",
]
