"""Processes that decode logs."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from typing import Any

from .. import binding
from .sources import Log

#: Of a log whose worker ended by itself.
CRASHED = "the worker that read it crashed: out of memory, or the file changed meanwhile"


def decoded(jobs: Sequence[tuple[Any, Log, str]], workers: int | None) -> Iterator[tuple[str, dict[str, Any]]]:
    """Decodes logs. Yields their names and facts, or, as `failed`, why there are none.

    If a worker dies, the next log is decoded alone, to find out which one it was, and then the rest.
    """
    waiting = list(jobs)
    alone = False
    while waiting:
        count = 1 if alone else min(workers or os.cpu_count() or 1, len(waiting))
        context = multiprocessing.get_context("spawn")
        pool = ProcessPoolExecutor(count, context, _begin, (binding.use_argument(),))
        crashed = False
        try:
            futures = {pool.submit(_decode, *job): job for job in (waiting[:1] if alone else waiting)}
            for future in as_completed(futures):
                error = future.exception()
                if isinstance(error, BrokenProcessPool):
                    crashed = True
                    if not alone:
                        continue
                facts = future.result() if error is None else {"failed": CRASHED if crashed else _reason(error)}
                waiting.remove(futures[future])
                yield futures[future][1].name, facts
        except BaseException:
            for child in multiprocessing.active_children():
                child.terminate()
            raise
        finally:
            pool.shutdown(cancel_futures=True)
        alone = crashed and not alone


def _reason(error: BaseException) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())


def _begin(package: str) -> None:
    """Prepares a worker: it ends with its parent, which alone is interrupted."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    binding.use(package)


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    os._exit(1)


def _decode(work: Any, log: Log, identity: str) -> dict[str, Any]:
    from .decode import decode_log

    return decode_log(work, log, identity)
