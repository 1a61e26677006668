"""Writes the fields of a log as an MCAP file."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from ..files import outputs
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..names.occurrence import Occurrence
from ..names.selection import Selection
from .json_messages import clock_of
from .mcap_file import require as require  # `mip export` calls it, as that of each format of messages
from .mcap_file import write_mcap
from .messages import Json, Messages, survey_messages


class Job:
    """The output for a log."""

    def __init__(self, name: str, options: argparse.Namespace, selection: Selection) -> None:
        self._name, self._options, self._selection = name, options, selection
        with inputs.open_columns(name, options.device) as log:
            self.types, clocks = survey_messages(log, selection)
            self._clock = clock_of(clocks, options)
            print_assumptions("export", log)

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes fields of these types into a file."""
        form = Json(self._options.named)
        made = Messages(types, self._selection, self._clock, self._options.invalid, form)
        with outputs.whole(path) as out, inputs.open_columns(self._name, self._options.device) as log:
            write_mcap(out, made.of_log(log), self._clock, form.topic)
