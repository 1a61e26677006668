"""Signals that end the program: Ctrl-C, an ordinary kill, the end of the terminal."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

Handler = Callable[[int, "FrameType | None"], None]


@contextmanager
def handled(handler: Handler) -> Iterator[None]:
    """Sets the handler of these signals, except of those that are ignored, for example by nohup."""
    before = {}
    try:
        for name in ("SIGINT", "SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is None or threading.current_thread() is not threading.main_thread():
                continue
            if signal.getsignal(number) is not signal.SIG_IGN:
                before[number] = signal.signal(number, handler)
        yield
    finally:
        for number, earlier in before.items():
            signal.signal(number, earlier)


def interrupt(number: int, frame: FrameType | None) -> None:
    """Raises KeyboardInterrupt at each signal."""
    raise KeyboardInterrupt


class Deferred:
    """A handler that raises KeyboardInterrupt at the first signal, but only while `open`; else the signal waits."""

    def __init__(self) -> None:
        self.open = False
        self.waits = False
        self._raised = False

    def __call__(self, number: int, frame: FrameType | None) -> None:
        self.waits = not self.open and not self._raised
        if self.open:
            self.open, self._raised = False, True
            raise KeyboardInterrupt
