"""CSV and JSON lines, on the standard library, field by field in bounded memory."""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import IO, Any

from ..binding import Field
from ..errors import Failure
from ..occurrence import Occurrence
from . import clocks, inputs, outputs, values
from .selection import Selection
from .table import Column, Sample, cell, columns, heading, samples, survey


def require(form: str) -> None:
    """Nothing: these formats need the standard library only."""


class Job:
    """What is to be written of a log."""

    def __init__(
        self, name: str, form: str, options: argparse.Namespace, selection: Selection, aligned: Occurrence | None
    ) -> None:
        self._name, self._form, self._options, self._aligned = name, form, options, aligned
        self._selection = selection
        self.types, clock = self._survey()
        self._clock = None if options.time == "none" else clock
        self._time = time_of(options.time, self._clock)

    def _survey(self) -> tuple[list[Occurrence], str | None]:
        log = inputs.as_columns(self._name)
        if log is not None:
            from . import csv_columns

            with log:
                surveyed = csv_columns.survey(log, self._selection)
            if surveyed is not None:
                return surveyed
        return survey(self._name, self._selection)

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes fields of these types into a file: by columns if that is faster and NumPy is there."""
        log = inputs.as_columns(self._name)
        if log is not None and self._form == "csv" and self._aligned is None:
            from . import csv_columns

            lines = csv_columns.Lines(types, self._selection, self._options, self._clock, self._time)
            with log, outputs.whole(path) as out:
                out.write(head(types, self._time is not None))
                lines.write(out, log, self._name)
            return
        rows = samples(self._name, types, self._selection, self._clock)
        with outputs.whole(path) as out:
            if self._form == "csv":
                write_csv(out, types, self._kept(rows), self._time, self._options, self._aligned)
            else:
                write_jsonl(out, types, self._kept(rows), self._time, self._options, self._aligned)

    def _kept(self, packets: Iterator[list[Sample]]) -> Iterator[list[Sample]]:
        """Without fields of which a value is not valid, if these are to be dropped."""
        if self._options.invalid != "drop":
            return packets
        known: dict[Occurrence, list[Column]] = {}

        def whole(sample: Sample) -> bool:
            if sample.kind not in known:
                known[sample.kind] = columns(sample.kind.kind)
            own = known[sample.kind]
            return all(c.valid is None or c.valid(sample.value) for c in own)

        return (kept for p in packets if (kept := [s for s in p if whole(s)]))


def time_of(wanted: str | None, clock: str | None) -> Callable[[int | None], str | None] | None:
    """How a time is written, in the order of the log; None if it is not."""
    if wanted == "none" or (clock is None and wanted is None):
        return None
    if clock is None:
        raise Failure("the log has no valid times; use --time none")
    if wanted in ("utc", "unix") and not clocks.dated(clock):
        raise Failure("the log has no dates; use --time clock, --time start or --time none")
    first: list[int] = []

    def said(time: int | None) -> str | None:
        if time is None:
            return None
        if wanted in (None, "utc"):
            return clocks.stamp(clock, time)
        if wanted == "start":
            first[:] = first or [time]
            time -= first[0]
        return clocks.seconds(time)

    return said


# --------------------------------------------------------------------------- csv


def write_csv(
    out: IO[bytes],
    types: Sequence[Occurrence],
    packets: Iterator[list[Sample]],
    time: Callable[[int | None], str | None] | None,
    options: argparse.Namespace,
    aligned: Occurrence | None,
) -> None:
    """A row for each packet; more, if a packet has several fields of one type."""
    own = {one: columns(one.kind) for one in types}
    out.write(head(types, time is not None))
    writers = {kind: texts(own_columns, options) for kind, own_columns in own.items()}
    empty = {kind: [""] * len(own_columns) for kind, own_columns in own.items()}
    last = dict(empty)
    for packet in packets:
        if aligned is None:
            for row in rows((sample.kind, sample.value) for sample in packet):
                cells = [text for kind in types for text in (writers[kind](row[kind]) if kind in row else empty[kind])]
                out.write(line([*_times(packet, time), *cells]))
            continue
        for sample in sorted(packet, key=lambda s: s.kind == aligned):
            last[sample.kind] = writers[sample.kind](sample.value)
            if sample.kind == aligned:
                cells = [text for kind in types for text in last[kind]]
                out.write(line([*_times(packet, time), *cells]))


def head(types: Sequence[Occurrence], time: bool) -> bytes:
    """The first line: what is in the columns."""
    labels = ["time", "time_own"] if time else []
    for one in types:
        labels += [label(one, c, len(types) == 1) for c in columns(one.kind)]
    return line(labels)


def label(kind: Occurrence, column: Column, single: bool) -> str:
    """The heading of a column, with its unit."""
    unit = f" [{column.unit}]" if column.unit else ""
    return heading(kind, column.name, single) + unit


def rows(fields: Iterable[tuple[Occurrence, Field]]) -> Iterator[dict[Occurrence, Field]]:
    """The fields of a packet; a type that it has already begins another row."""
    row: dict[Occurrence, Field] = {}
    for kind, field in fields:
        if kind in row:
            yield row
            row = {}
        row[kind] = field
    yield row


def _times(packet: list[Sample], time: Callable[[int | None], str | None] | None) -> list[str]:
    if time is None:
        return []
    return [time(packet[0].time) or "", str(int(packet[0].own))]


def texts(columns: list[Column], options: argparse.Namespace) -> Callable[[Any], list[str]]:
    """The cells of a field."""
    mask, named = options.invalid == "mask", options.named

    def cells(field: Any) -> list[str]:
        return [
            "" if mask and c.valid is not None and not c.valid(field) else _text(cell(c, field, named), c)
            for c in columns
        ]

    return cells


def _text(value: Any, column: Column) -> str:
    if value is None:
        return ""
    if isinstance(value, float):
        return values.number(value, column.parameter.scalar)
    if isinstance(value, (list, dict)):
        return json.dumps(value, separators=(",", ":"), default=str)
    if isinstance(value, bool):
        return "true" if value else "false"
    return str(value)


def line(cells: list[str]) -> bytes:
    """A line of CSV (RFC 4180, but with a plain line feed)."""
    return (",".join(map(quoted, cells)) + "\n").encode()


def quoted(text: str) -> str:
    """A cell, in quotes if it needs them."""
    if text.isalnum() or not any(c in text for c in ',"\r\n'):
        return text
    return '"' + text.replace('"', '""') + '"'


# --------------------------------------------------------------------------- jsonl


def write_jsonl(
    out: IO[bytes],
    types: Sequence[Occurrence],
    packets: Iterator[list[Sample]],
    time: Callable[[int | None], str | None] | None,
    options: argparse.Namespace,
    aligned: Occurrence | None,
) -> None:
    """A line for each field; with `aligned`, for each field of that type with the last of the others."""
    known = {one: columns(one.kind) for one in types} if options.invalid == "mask" else {}
    last: dict[str, Any] = {one.name: None for one in types}
    for packet in packets:
        # That to align with comes last in its packet, behind what is new of the others.
        for sample in sorted(packet, key=lambda s: s.kind == aligned):
            kind = sample.kind
            held = values.plain(sample.value, options.named)
            if kind in known:
                _mask(held, known[kind], sample.value)
            last[kind.name] = held = _strict(held)
            if aligned not in (None, kind):
                continue
            line: dict[str, Any] = {}
            if time is not None:
                said = time(sample.time)
                line["time"] = said if said is None or said.endswith("Z") else float(said)
                line["time_own"] = sample.own
            line |= {"packet": sample.packet, "offset": sample.offset}
            line |= {"field": kind.name, "values": held} if aligned is None else {"fields": last}
            out.write(json.dumps(line, separators=(",", ":"), allow_nan=False).encode() + b"\n")


def _mask(held: dict[str, Any], columns: list[Column], field: Any) -> None:
    """Puts null in place of values that are not valid."""
    for c in columns:
        if c.valid is None or c.valid(field):
            continue
        *path, last = c.name.split(".")
        place: Any = held
        for name in path:
            place = place[name]
        if isinstance(place, dict):
            place[last] = None
        elif place is not None:
            labels = c.parameter.elements or tuple(map(str, range(len(place))))
            place[labels.index(last)] = None


def _strict(value: Any) -> Any:
    """Without numbers that JSON does not have."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {k: _strict(v) for k, v in value.items()}
    return [_strict(v) for v in value] if isinstance(value, list) else value
