"""Writes the fields of a log as an MCAP file."""

from __future__ import annotations

from collections.abc import Sequence

from ..files import outputs
from ..logs import inputs
from ..names.occurrence import Occurrence
from .mcap_file import require as require  # `mip export` calls it, as that of each format of messages
from .mcap_file import write_mcap
from .messages import Json, MessageExport, Messages


class Job(MessageExport):
    """The output for a log."""

    def write(self, path: str, types: Sequence[Occurrence]) -> None:
        """Writes fields of these types into a file."""
        form = Json(self._options.named, self._options.invalid == "mask")
        made = Messages(types, self._selection, self._clock, self._options.invalid, form)
        with outputs.whole(path) as out, inputs.open_columns(self._name, self._options.device) as log:
            write_mcap(out, made.of_log(log), self._clock, form.topic)
