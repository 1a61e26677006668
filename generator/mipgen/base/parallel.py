"""Runs a function on several items in parallel, in forked processes where that is safe."""

from __future__ import annotations

import gc
import os
import signal
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any, TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")

#: In a forked process: the function and the items, which need not be sent to it.
_work: list[Any] = []


def each(function: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    """Returns the results in the order of the items, which are started in this order: the slowest should be first.
    Raises the exception of the first item that fails."""
    count = min(len(items), _processors())
    unsafe = not hasattr(os, "fork") or sys.platform == "darwin"
    if count < 2 or unsafe:
        return [function(item) for item in items]
    gc.freeze()  # processes share the existing objects; marking them would copy them
    try:
        with ProcessPoolExecutor(count, get_context("fork"), _begin, (function, items)) as pool:
            return list(pool.map(_result, range(len(items))))
    finally:
        gc.unfreeze()


def _begin(*work: Any) -> None:
    gc.disable()
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # an interrupted process ends without a word
    _work[:] = work


def _result(number: int) -> Any:
    function, items = _work
    return function(items[number])


def _processors() -> int:
    """Returns the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
