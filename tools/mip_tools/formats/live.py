"""Writes a stream from a port or a pipe as a table or as messages, while it arrives."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from typing import IO, TYPE_CHECKING, Any

from ..binding import CLOCKS
from ..devices.known import KnownDevice
from ..errors import Failure
from ..logs import inputs
from ..logs.scan import Piece
from ..names.occurrence import Occurrence
from ..names.selection import Selection
from ..text.clocks import dated
from .json_messages import Batch, Topic, with_gaps
from .mcap_file import write_mcap
from .row_times import Time, shown_clocks

if TYPE_CHECKING:
    from ..columns import Log
    from ..columns.tables import Form
    from ..columns.timeline import Clocks

#: The data that is read before the first line, to find the clock and the columns: seconds, and bytes, from the first
#: packet on.
PREVIEW = 1.0
_MOST = 1 << 20

#: Formats that are written to the output.
FORMATS = ("jsonl", "csv", "mcap")


def write_stream(
    out: IO[bytes],
    form: str,
    arriving: Iterator[Piece | None],
    options: argparse.Namespace,
    selection: Selection,
    types: Sequence[Occurrence] = (),
    device: str | KnownDevice | None = None,
    host: bool = False,
    gaps: list[float] | None = None,
) -> bool:
    """Writes the fields of a stream until it ends. Has it any? `types`: the columns of CSV; by default the fields in
    the preview. `host`: with a column of the times when the packets arrive. `gaps`: the seconds, which are added here,
    for which the port was lost before a packet, as a column or as messages.

    The rows are the same as those of `mip export`, except that an instant that arrives in two pieces has two rows.
    Raises Failure if the columns of CSV are unknown.
    """
    if form == "mcap":
        return write_mcap(out, *messages(arriving, options, selection, out.flush, device, gaps), live=True)
    return _write_table(out, form, arriving, options, selection, types, device, host, gaps)


def messages(
    arriving: Iterator[Piece | None],
    options: argparse.Namespace,
    selection: Selection,
    flush: Callable[[], object] = lambda: None,
    device: str | KnownDevice | None = None,
    gaps: list[float] | None = None,
) -> tuple[Iterator[Batch], str | None, Callable[[Occurrence | None], Topic]]:
    """Returns the fields and the gaps of a stream as messages, the clock of their times, and what makes their topic."""
    inputs.need_numpy()
    from .messages import Json, Messages

    arrivals: list[tuple[int, float]] = []
    logs = _logs(_noted(arriving, arrivals, gaps), device, options.command, options.named)
    first = next(logs, None)
    clocks = _clocks(first, options, selection)
    clock = None if options.time == "none" else (clocks.dated if options.time == "utc" else clocks.steady) or None
    form = Json(options.named, options.invalid == "mask")
    made = Messages(None, selection, clock, options.invalid, form)

    def messages_of_logs() -> Iterator[Batch]:
        number, lost = 0, []
        for log in chain([] if first is None else [first], logs):
            lost += [(number + i, seconds) for i, (_, seconds) in enumerate(arrivals[: log.packets]) if seconds]
            yield from with_gaps(made.of_log(log, number), lost)
            number += log.packets
            del arrivals[: log.packets]
            flush()

    return messages_of_logs(), clock, form.topic


def _logs(
    arriving: Iterator[Piece | None], device: str | KnownDevice | None, command: str, named: bool
) -> Iterator[Log]:
    """Yields a stream as logs, of which each continues the times and the flags of the one before."""
    inputs.need_numpy()
    from ..columns import read_log
    from ..columns.sender import Sender
    from ..columns.timeline import Timeline

    sender, line = Sender(device), Timeline()
    for batch in chain([_preview(arriving)], inputs.batches(arriving)):
        with read_log(b"".join(piece.data for piece in batch if piece.packet is not None), device=sender) as log:
            line = line.following()
            line.add(log)
            sender.survey(log)
            log.source.notes["timeline"] = line
            yield log
            for text in sender.news(named):
                print(f"mip {command}: {text}", file=sys.stderr)


def _clocks(first: Log | None, options: argparse.Namespace, selection: Selection | None = None) -> Clocks:
    """Chooses the clocks of a stream by its first data: those of the sets with selected fields, if any has arrived. The
    device may learn the date later, or lose it."""
    from ..columns import contents, timeline

    line = timeline.Timeline() if first is None else timeline.of_log(first)
    found = () if first is None or selection is None else contents.decodable(first)
    own = {n for n, kind in found if n >= 0x80 and selection is not None and selection.has(n, kind.DESCRIPTOR)}
    clocks = line.clocks(own or line.sets)
    date = next(filter(dated, CLOCKS), "")
    if clocks.undated == timeline.DEVICE or options.time in ("utc", "unix"):
        return clocks._replace(dated=date)
    return clocks


def _write_table(
    out: IO[bytes],
    form: str,
    arriving: Iterator[Piece | None],
    options: argparse.Namespace,
    selection: Selection,
    types: Sequence[Occurrence],
    device: str | KnownDevice | None,
    host: bool,
    gaps: list[float] | None,
) -> bool:
    inputs.need_numpy()
    import numpy as np

    from ..columns import tables, timeline
    from . import writers

    arrivals: list[tuple[int, float]] = []
    arriving = _noted(arriving, arrivals, gaps) if host or gaps is not None else arriving
    logs = _logs(arriving, device, options.command, options.named)
    first = next(logs, None)
    clocks = _clocks(first, options)
    wanted = tables.Form(
        options.by,
        *clocks,
        shown=shown_clocks(options.time, clocks, "no time arrived"),
        invalid=options.invalid,
        named=options.named,
        wanted=selection.has,
    )
    if form != "csv" and clocks.dated and not clocks.undated and timeline.DEVICE in CLOCKS:
        wanted = wanted._replace(undated=timeline.DEVICE)  # absent until the date is lost
    if form == "csv" and not types:
        types = [] if first is None else _kinds(first, wanted)
        if not types:
            raise Failure("no field arrived, so the columns are unknown; name the fields")
    started = Time(options.time)
    left_out: set[str] = set()
    found = False
    try:
        with writers.FORMS[form](out) as write:
            for log in chain([] if first is None else [first], logs):
                kinds = _kinds(log, wanted)
                found = found or bool(kinds)
                if form == "csv":  # the columns are always the same
                    left_out |= {kind.name for kind in kinds if kind not in types}
                    kinds = list(types)
                times, lost = zip(*arrivals[: log.packets]) if arrivals else ((), ())
                if host:
                    wanted = wanted._replace(arrivals=np.array(times, np.int64))
                if gaps is not None:
                    wanted = wanted._replace(gaps=np.array(lost))
                del arrivals[: log.packets]
                if kinds:
                    for table, _ in tables.table_parts(log, kinds, wanted):
                        write(started.converted(table, log))
                out.flush()
    finally:
        if left_out:
            names = ", ".join(sorted(left_out))
            print(f"mip {options.command}: no columns for fields that came later: {names}; name them", file=sys.stderr)
    return found


def _noted(
    arriving: Iterator[Piece | None], arrivals: list[tuple[int, float]], gaps: list[float] | None
) -> Iterator[Piece | None]:
    """Yields the pieces, and notes when each packet arrived, and for how long the port was lost before."""
    for piece in arriving:
        if piece is not None and piece.packet is not None:
            arrivals.append((time.time_ns(), sum(gaps or ())))
            if gaps:
                gaps.clear()
        yield piece


def _kinds(log: Any, form: Form) -> list[Occurrence]:
    from ..columns import tables

    return [Occurrence(*pair) for pair in tables.survey_tables(log, form)[0]]


def _preview(arriving: Iterator[Piece | None]) -> list[Piece]:
    """Reads the pieces of the first second, or fewer if that is much data."""
    seen: list[Piece] = []
    end: float | None = None
    size = 0
    for piece in arriving:
        if piece is not None:
            seen.append(piece)
            size += len(piece.data)
            if end is None and piece.packet is not None:
                end = time.monotonic() + PREVIEW
        if size > _MOST or (end is not None and time.monotonic() >= end):
            break
    return seen
