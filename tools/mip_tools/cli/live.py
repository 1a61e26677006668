"""Writes a stream from a port or a pipe as a table or as messages, while it arrives."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import IO, TYPE_CHECKING, Any

from ..errors import Failure
from ..occurrence import Occurrence
from . import inputs, table_options
from .clocks import CLOCKS, dated
from .samples import kept, samples, survey
from .scan import Piece
from .selection import Selection

if TYPE_CHECKING:
    from ..columns.tables import Form
    from .foxglove import Server

#: The data that is read before the first line, to find the clock and the columns: seconds, and bytes, from the first
#: packet on.
PREVIEW = 1.0
_MOST = 1 << 20

#: Formats that are written to the output.
FORMATS = ("jsonl", "csv", "mcap")


def write(
    out: IO[bytes],
    form: str,
    arriving: Iterator[Piece | None],
    options: argparse.Namespace,
    selection: Selection,
    types: Sequence[Occurrence] = (),
) -> None:
    """Writes the fields of a stream until it ends. `types`: the columns of CSV; by default the fields in the preview.

    The rows are the same as those of `mip export`, except that an instant that arrives in two pieces has two rows.
    Raises Failure if the stream ends without any of the fields.
    """
    if form != "mcap":
        inputs.need_numpy()
    seen, found, clock = _begun(arriving, options, selection)
    if form == "mcap":
        from .export_mcap import Message, encoded, write_mcap

        packets = kept(samples(_flushing(chain(seen, arriving), out), None, selection, clock), options.invalid)
        every = chain.from_iterable(packets)
        made = (Message(one.kind, one.time, one.own, one.packet, encoded(one.value, options.named)) for one in every)
        write_mcap(out, made, clock, options.named, live=True)
        return
    if form == "csv" and not (types or found):
        raise Failure("no field arrived, so the columns are unknown; name the fields")
    _write_table(out, form, chain([seen], inputs.batches(arriving)), options, selection, clock, types or found)


def serve(server: Server, arriving: Iterator[Piece | None], options: argparse.Namespace, selection: Selection) -> None:
    """Serves the fields of a stream to Foxglove until it ends."""
    from . import foxglove

    seen, _, clock = _begun(arriving, options, selection)
    pieces = (piece for piece in chain(seen, arriving) if piece is not None)
    foxglove.write(server, kept(samples(pieces, None, selection, clock), options.invalid), clock, options.named)


def _begun(
    arriving: Iterator[Piece | None], options: argparse.Namespace, selection: Selection
) -> tuple[list[Piece], list[Occurrence], str | None]:
    """Reads the preview. Returns its pieces, the types of its fields, and the clock of the times."""
    seen = _preview(arriving)
    found, clock = survey(seen, selection)
    if options.time in ("utc", "unix"):  # the device may learn the date later
        clock = next(filter(dated, CLOCKS), None)
    elif options.time == "none":
        clock = None
    return seen, found, clock


def _write_table(
    out: IO[bytes],
    form: str,
    batches: Iterator[list[Piece]],
    options: argparse.Namespace,
    selection: Selection,
    clock: str | None,
    types: Sequence[Occurrence],
) -> None:
    from ..columns import read_log, tables
    from . import writers

    wanted = tables.Form(
        options.by, clock or "", options.time != "none", options.invalid, named=options.named, wanted=selection.has
    )
    started = table_options.Time(options.time, clock or "")
    left_out: set[str] = set()
    try:
        with writers.FORMS[form](out) as write:
            for batch in batches:
                with read_log(b"".join(piece.data for piece in batch if piece.packet is not None)) as log:
                    kinds = _kinds(log, wanted)
                    if form == "csv":  # the columns are always the same
                        left_out |= {one.name for one in kinds if one not in types}
                        kinds = list(types)
                    if kinds:
                        for table, _ in tables.parts(log, kinds, wanted):
                            write(started.of(table.columns))
                out.flush()
    finally:
        if left_out:
            names = ", ".join(sorted(left_out))
            print(f"mip {options.command}: no columns for fields that came later: {names}; name them", file=sys.stderr)


def _kinds(log: Any, form: Form) -> list[Occurrence]:
    from ..columns import tables

    return [Occurrence(*one) for one in tables.survey(log, form)[0]]


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


def _flushing(pieces: Iterator[Piece | None], out: IO[bytes]) -> Iterator[Piece]:
    """Flushes the output before it waits for more."""
    for piece in pieces:
        if piece is None:
            out.flush()
        else:
            yield piece


__all__ = ["FORMATS", "PREVIEW", "serve", "write"]
