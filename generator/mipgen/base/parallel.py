"""Runs a function on several items in parallel, in forked processes where that is safe."""

from __future__ import annotations

import gc
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

#: The outcome of an item: "done" and its result, "failure" and its arguments, or "crash" and the traceback.
Answer = tuple[str, Any]

_NUMBER = 2  # bytes of the number of an item in the queue


def each(function: Callable[[Item], Result], items: Sequence[Item]) -> list[Result]:
    """Returns the results in the order of the items, which are started in this order: the slowest should be first.
    Raises the exception of the first item that fails."""
    count = min(len(items), _processors())
    unsafe = not hasattr(os, "fork") or sys.platform == "darwin"
    archive = not isinstance(resources.root(), Path)  # forked processes share the offset of an open archive
    if count < 2 or unsafe or archive:
        return [function(item) for item in items]
    answers = _forked(function, items, count)
    for kind, value in (answers[i] for i in range(len(items))):
        if kind == "failure":
            raise Failure(*value)
        if kind == "crash":
            raise RuntimeError(f"in another process:\n{value}")
    return [answers[i][1] for i in range(len(items))]


def _processors() -> int:
    """Returns the number of processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _forked(function: Callable[[Item], Result], items: Sequence[Item], count: int) -> dict[int, Answer]:
    """Returns the outcome of each item. A process takes the next item when it has finished one."""
    queue, end = os.pipe()
    os.write(end, b"".join(i.to_bytes(_NUMBER, "big") for i in range(len(items))))
    os.close(end)
    gc.freeze()  # processes share the existing objects; marking them would copy them
    try:
        children = [_start(function, items, queue) for _ in range(count)]
    finally:
        gc.unfreeze()
        os.close(queue)
    parts = [_finish(*child) for child in children]
    answers: dict[int, Answer] = {}
    for status, data in parts:
        if status != 0 or not data:
            raise RuntimeError(f"in another process:\nit ended with status {status}")
        answers |= pickle.loads(data)
    return answers


def _start(function: Callable[[Item], Result], items: Sequence[Item], queue: int) -> tuple[int, int]:
    reader, writer = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child:
        os.close(writer)
        return child, reader
    status = 1
    try:
        os.close(reader)
        gc.disable()
        answers = {}
        while number := os.read(queue, _NUMBER):
            i = int.from_bytes(number, "big")
            answers[i] = _answer(function, items[i])
        with os.fdopen(writer, "wb") as pipe:
            pickle.dump(answers, pipe)
        status = 0
    finally:
        os._exit(status)


def _answer(function: Callable[[Item], Result], item: Item) -> Answer:
    try:
        return "done", function(item)
    except Failure as failure:
        return "failure", failure.args
    except BaseException:
        return "crash", traceback.format_exc()


def _finish(child: int, pipe: int) -> tuple[int, bytes]:
    with os.fdopen(pipe, "rb") as answer:
        data = answer.read()
    return os.waitpid(child, 0)[1], data
