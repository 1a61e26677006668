"""Fields as JSON messages: their topics, schemas and times."""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from ..binding import Described, Field, Parameter, Structure, info
from ..errors import Failure, Misuse
from ..names.occurrence import Occurrence
from ..text import values
from ..text.clocks import dated

if TYPE_CHECKING:
    from ..columns.scan import Array
    from ..columns.timeline import Clocks

#: The maximum number of messages that wait for the first time in a log.
HELD = 100_000

#: The separators in the JSON of messages.
SEPARATORS = (",", ":")

#: Why there are no messages of fields in whose sets no packet has a time.
NO_TIME = "these fields have no valid time, which messages need; csv and jsonl need none"

#: What the times of messages mean.
TIMES = {
    "dated": "UTC in ns since 1970, from the {} clock of the device",
    "undated": "ns since the origin of the {} clock of the device, which has no date",
    "host": "UTC in ns since 1970, when the host received it; the device has sent no time",
}


class Batch(NamedTuple):
    """Fields as messages, in their order: an item of each list or array for each message."""

    kinds: list[Occurrence | None]  # all of them, once; None for a gap, in which the port was lost
    kind: Array  # the number of the kind in this list
    time: Array  # in ns; NONE if it is not known
    own: Array  # does the packet have the time?
    packet: Array
    data: list[Any]  # as JSON or CDR


def with_gaps(batches: Iterable[Batch], gaps: list[tuple[int, float]]) -> Iterator[Batch]:
    """Yields messages, and before those of a packet the gap before it: the number of the packet, and seconds."""
    import numpy as np

    for batch in batches:
        while gaps and len(batch.data) and batch.packet[-1] >= gaps[0][0]:
            packet, seconds = gaps.pop(0)
            row = int(np.searchsorted(batch.packet, packet))
            kind = np.insert(batch.kind, row, len(batch.kinds))
            time, own, packets = (np.insert(each, row, each[row]) for each in (batch.time, batch.own, batch.packet))
            data = [*batch.data[:row], json.dumps({"seconds": round(seconds, 3)}).encode(), *batch.data[row:]]
            batch = Batch([*batch.kinds, None], kind, time, own, packets, data)
        yield batch


def clock_of(clocks: Clocks, options: argparse.Namespace) -> str:
    """Chooses the clock of messages: that of all packets, or the one with dates for `--time utc`. Raises Failure or
    Misuse if no clock provides the times that messages need."""
    if options.time not in (None, "utc", "clock"):
        raise Misuse(f"--time {options.time} is for tables; messages always have the time of the clock")
    if not clocks.best:
        raise Failure(NO_TIME)
    if options.time == "utc" and not clocks.dated:
        raise Failure("the log has no dates; use --time clock")
    return clocks.dated if options.time == "utc" else clocks.steady


def refuse_options_of_tables(options: argparse.Namespace, form: str) -> None:
    """Raises Misuse for options that concern rows. A live stream accepts the same ones as a log."""
    if options.by != "time":
        raise Misuse(f"--by {options.by} is for tables; {form} has messages for each field")


class Topic(NamedTuple):
    """The name of a field's messages, and their schema."""

    name: str
    schema_name: str
    schema: str

    @classmethod
    def of_gaps(cls) -> Topic:
        """Makes the topic of the gaps of a port."""
        seconds = {"type": "number", "description": "in s"}
        about = {"title": "gap", "description": "for how long the port was lost before this time"}
        return cls("/mip/gap", "mip.gap", json.dumps(about | {"type": "object", "properties": {"seconds": seconds}}))

    @classmethod
    def of_field(cls, kind: Occurrence, named: bool, device: str | None) -> Topic:
        """Makes the topic of a field of a device."""
        text = json.dumps(schema(kind.kind, named, device))
        return cls(f"/mip/{kind.name.replace('.', '/')}", f"mip.{kind.name}", text)


def encoded(field: Field, named: bool, device: str | None, masked: bool = False) -> bytes:
    """Encodes a message as JSON; `masked`: without the values that their flags mark as invalid."""
    return json.dumps(message_values(field, named, device, masked), separators=SEPARATORS, allow_nan=False).encode()


def clock_meaning(clock: str | None) -> str:
    """Describes the times of messages in a sentence."""
    return TIMES["host" if clock is None else "dated" if dated(clock) else "undated"].format(clock)


def timed(batches: Iterable[Batch], by_host: bool) -> Iterator[tuple[Batch, Array]]:
    """Yields messages with their times in ns, or else the last known one, or else the first. Raises Failure if there is
    none, or not soon."""
    import numpy as np

    from ..columns.stamps import NONE

    last: Array = np.zeros(0, np.int64)  # the last known time
    waiting: list[Batch] = []
    for batch in batches:
        moments = np.full(len(batch.data), time.time_ns()) if by_host else batch.time
        known = np.flatnonzero(moments != NONE)
        waiting.append(batch)
        if not len(last) and not len(known):
            if sum(len(each.data) for each in waiting) > HELD:
                raise Failure(f"the first {HELD} fields have no time; use --time clock, or jsonl")
            continue
        times = np.maximum(np.concatenate((last if len(last) else moments[known[:1]], moments[known])), 0)
        for earlier in waiting[:-1]:
            yield earlier, np.full(len(earlier.data), times[0])
        yield batch, times[np.searchsorted(known, np.arange(len(moments)), side="right")]
        waiting.clear()
        last = times[-1:]
    if any(len(each.data) for each in waiting):
        raise Failure(NO_TIME)


# --------------------------------------------------------------------------- messages and schemas


def message_values(field: Field, named: bool, device: str | None, masked: bool = False) -> dict[str, Any]:
    """Returns the values of a field as its schema describes them, without numbers that JSON cannot represent."""
    plain_values = values.to_plain(field, named, device)
    if masked:
        _mask(field, plain_values, device)
    return _object(field, plain_values)


def _mask(record: Described, plain_values: dict[str, Any], device: str | None) -> None:
    """Replaces the values that their flags mark as invalid by None: of a vector with a flag each, only these."""
    for p in info(type(record)).members:
        valid = [flag.holds(getattr(record, flag.attribute) or 0) for flag in p.flags_of(record, device)]
        value = plain_values[p.name]
        if isinstance(value, dict) and p.kind == "struct":
            _mask(getattr(record, p.attribute), value, device)
        elif valid and not any(valid):
            plain_values[p.name] = None
        elif isinstance(value, list) and len(valid) == len(value):
            plain_values[p.name] = [item if good else None for item, good in zip(value, valid)]


def _object(record: Described, plain_values: dict[str, Any]) -> dict[str, Any]:
    made = {}
    for p in info(type(record)).members:
        value = plain_values[p.name]
        if isinstance(value, list) and p.elements and p.length is None:
            value = dict(zip(p.elements, value))
        if isinstance(value, dict):
            value = {k: v for k, v in value.items() if v is not None}
        if value is not None:
            made[p.name] = value
    return made


def schema(kind: type[Field], named: bool, device: str | None) -> dict[str, Any]:
    """Makes the JSON Schema of a field's messages, as a device sends it."""
    about = info(kind)
    properties = {p.name: _of_parameter(p if device is None else p.on(device), named) for p in about.members}
    return {"title": about.name, "description": about.title, "type": "object", "properties": properties}


def _of_parameter(p: Parameter, named: bool) -> dict[str, Any]:
    notes = [*((f"in {p.unit}",) if p.unit not in ("", "1") else ()), *((f"frame: {p.frame}",) if p.frame else ())]
    description: dict[str, Any] = {"description": "; ".join(notes)} if notes else {}
    if p.kind == "text":
        return {"type": "string", **description}
    if p.kind in ("struct", "switch"):
        return {"type": "object", **description}
    item_schema = _item_schema(p, named)
    if p.kind == "array" and p.elements and p.length is None:
        return {"type": "object", "properties": dict.fromkeys(p.elements, item_schema), **description}
    if p.kind == "array":
        return {"type": "array", "items": item_schema, **description}
    return item_schema | description


def _item_schema(p: Parameter, named: bool) -> dict[str, Any]:
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        return {"type": "object"}
    if named and p.type is not None:
        return {} if hasattr(info(p.type), "bits") else {"type": "string"}
    if p.scalar in ("float", "double"):
        return {"type": "number"}
    return {"type": "boolean" if p.scalar == "bool" else "integer"}
