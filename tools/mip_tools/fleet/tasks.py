"""The tasks of workers."""

from __future__ import annotations

from typing import Any

from .. import binding
from .pack import write_packed
from .sources import Log
from .work import Pack, Work


def decode_log(work: Work, log: Log, identity: str) -> dict[str, Any]:
    """Makes the fragments of a log. Returns its facts, or, as `failed`, the reason why there are none."""
    binding.use(work.package)
    from .decode import decode_to_fragments

    return decode_to_fragments(work, log, identity)


def pack(work: Pack) -> tuple[int, int]:
    """Makes a file of rows. Returns their number, and their size in memory."""
    return write_packed(work)
