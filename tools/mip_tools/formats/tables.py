"""Makes the columns of the tables of an export."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..columns import between, resample, tables, timeline
from ..columns.tables import Series
from ..errors import Failure
from ..logs import inputs
from ..logs.assumed import no_date
from ..names.occurrence import Occurrence
from ..names.selection import Selection
from .row_times import Time, shown_clocks

if TYPE_CHECKING:
    from ..columns import Log


class TableExport(NamedTuple):
    """The output for a log."""

    log: Log
    kinds: list[Occurrence]
    form: Any

    def tables(self, options: argparse.Namespace, aligned: Occurrence | None) -> Iterator[Sequence[Series]]:
        """Yields the columns of each part."""
        started = Time(options.time)
        if options.rate:
            columns = self.log.columns(self.kinds)
            every = resample.parse_step(options.rate)
            form = self.form._replace(invalid="mask")
            try:
                yield started.converted(resample.resampled(self.log, columns, every, options.method or "linear", form))
            except ValueError as error:
                raise Failure(f"{options.file}: {error}") from None
            return
        rows = tables.Aligned(self.kinds.index(aligned)) if aligned else None
        progress = inputs.Progress(self.log.size)
        for table, end in tables.table_parts(self.log, self.kinds, self.form):
            progress.at(end)
            yield started.converted((rows.aligned(table) if rows else table).columns)
        progress.clear()


def table_export(options: argparse.Namespace, selection: Selection, log: Log) -> TableExport:
    """Surveys a log. Raises Failure if it has no packets."""
    if not any(part.packets for part in log.parts(tables.PART)):  # log.packets would store the offset of each one
        raise Failure(f"{options.file} has no packets")
    form = tables.Form(
        options.by,
        invalid=options.invalid,
        position=options.position,
        named=options.named,
        wanted=selection.has,
    )
    kinds, clocks = tables.survey_tables(log, form)
    columns = shown_clocks(options.time, clocks, no_date(timeline.of_log(log)))
    return TableExport(log, [Occurrence(*kind) for kind in kinds], form._replace(**clocks._asdict(), shown=columns))


def nmea_table(options: argparse.Namespace, log: Log) -> Sequence[Series]:
    """Returns the columns of the NMEA sentences. Raises Failure if there are none."""
    clocks = timeline.of_log(log).clocks(n for n in log.sets() if n >= 0x80)
    columns = shown_clocks(options.time, clocks, no_date(timeline.of_log(log)))
    table = between.nmea_table(log, [c for c in clocks[:2] if columns is None or c in columns])
    if not len(table):
        raise Failure(f"{options.file} has no NMEA sentences with a correct checksum")
    return Time(options.time).converted(table.columns)
