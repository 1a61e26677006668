"""Runs a function for each of several items at once, where that is cheap: in copies of this process."""

from __future__ import annotations

import os
import pickle
import sys
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

from . import resources
from .errors import Failure

Item = TypeVar("Item")
Result = TypeVar("Result")


def each(function: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    """The results in the order of the items; what the first one that fails raises, is raised here."""
    one = len(items) < 2 or _processors() < 2
    unsafe = not hasattr(os, "fork") or sys.platform == "darwin"
    archive = not isinstance(resources.root(), Path)  # copies of a process cannot read one open file at once
    if one or unsafe or archive:
        return [function(item) for item in items]
    children = [_start(function, item) for item in items]
    answers = [_finish(*child) for child in children]
    for kind, value in answers:
        if kind == "failure":
            raise Failure(*value)
        if kind == "crash":
            raise RuntimeError(f"in another process:\n{value}")
    return [value for _, value in answers]


def _processors() -> int:
    """Those that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _start(function: Callable[[Item], Result], item: Item) -> tuple[int, int]:
    here, there = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child:
        os.close(there)
        return child, here
    status = 1
    try:
        os.close(here)
        try:
            answer: tuple[str, Any] = ("done", function(item))
        except Failure as failure:
            answer = ("failure", failure.args)
        except BaseException:
            answer = ("crash", traceback.format_exc())
        with os.fdopen(there, "wb") as pipe:
            pickle.dump(answer, pipe)
        status = 0
    finally:
        os._exit(status)


def _finish(child: int, pipe: int) -> tuple[str, Any]:
    with os.fdopen(pipe, "rb") as answer:
        data = answer.read()
    _, status = os.waitpid(child, 0)
    if status != 0 or not data:
        return "crash", f"it ended with status {status}"
    found: tuple[str, Any] = pickle.loads(data)
    return found
