"""Makes the columns of the tables of an export."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..columns import tables, timeline
from ..columns.tables import Series
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

    def tables(self, options: argparse.Namespace) -> Iterator[Sequence[Series]]:
        """Yields the columns of each part."""
        started = Time(options.time)
        progress = inputs.Progress(self.log.size)
        for table, end in tables.table_parts(self.log, self.kinds, self.form):
            progress.at(end)
            yield started.converted(table, self.log)
        progress.clear()


def table_export(options: argparse.Namespace, selection: Selection, log: Log) -> TableExport:
    """Surveys a log."""
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
