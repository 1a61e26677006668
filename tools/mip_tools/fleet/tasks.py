"""The tasks of workers."""

from __future__ import annotations

from typing import Any

from .. import binding
from .pack import packed
from .sources import Log
from .work import Pack, Work


def decode(work: Work, log: Log, identity: str) -> dict[str, Any]:
    """Makes the fragments of a log. Returns its facts, or, as `failed`, the reason why there are none."""
    binding.use(work.package)
    from .decode import decoded

    return decoded(work, log, identity)


def pack(work: Pack) -> tuple[int, int]:
    """Makes a file of rows. Returns their number, and their size in memory."""
    return packed(work)
