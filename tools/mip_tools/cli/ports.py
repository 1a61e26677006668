"""Ports on the command line."""

from __future__ import annotations

import argparse
import os
import queue
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ..binding import MipError, PortError
from ..errors import Failure
from .scan import Piece, Scanner
from .silence import Silence

if TYPE_CHECKING:
    from ..binding import DeviceAtPort

    Begin = Callable[[DeviceAtPort], object]

#: Seconds without data after which an incomplete packet is discarded.
INCOMPLETE = 0.5
_TURN = 0.1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--baud",
        type=_baud,
        default=115200,
        metavar="BD",
        help="baud rate of a serial port; `auto` finds it (default: 115200)",
    )


def _baud(text: str) -> int | None:
    if text == "auto":
        return None
    if not text.isascii() or not text.isdigit() or not 0 < int(text) < 10**8:
        raise argparse.ArgumentTypeError(f"'{text.strip()}' is not a baud rate; use a number or `auto`")
    return int(text)


class Lost(Failure):
    """A port that has closed by itself."""


@contextmanager
def opened(name: str, options: argparse.Namespace, **more: Any) -> Iterator[DeviceAtPort]:
    """Opens the port of a device. Raises Failure if it cannot be opened."""
    from ..binding import open_port

    if os.path.isfile(name):
        raise Failure(f"{name} is a file, not a port")

    try:
        device = open_port(name, options.baud, **more)
    except (OSError, ImportError, MipError, ValueError) as error:
        raise Failure(why_not(name, error)) from None
    with device:
        yield device


def why_not(name: str, error: BaseException) -> str:
    """Describes why a port cannot be opened, with its name."""
    said = reason(error)
    return said if isinstance(error, PortError) else f"{name} cannot be opened: {said}"


def reason(error: BaseException) -> str:
    """Formats the message of an exception in one line."""
    said = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return " ".join(str(said).split())


def received(
    name: str, options: argparse.Namespace, seconds: float | None = None, begin: Begin | None = None
) -> Iterator[bytes]:
    """Yields the bytes received at a port as they arrive, until the time is over, and empty bytes during a pause.

    `begin` is called with the device as soon as the port is open. Raises Lost when the port closes, after all received
    bytes.
    """
    came: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    with opened(name, options, capacity=1, on_bytes=lambda data: came.put(bytes(data))) as device:
        if begin is not None:
            begin(device)
            while not came.empty():  # data from before `begin` ended
                came.get()
        end = None if seconds is None else time.monotonic() + seconds
        while True:
            left = _TURN if end is None else min(_TURN, end - time.monotonic())
            if left <= 0:
                return
            closed = device.closed  # read before the queue: if it is true, the queue contains the last data
            try:
                yield came.get(timeout=0 if closed else left)
            except queue.Empty:
                if closed:
                    raise Lost(f"{name} was closed") from None
                yield b""


def pieces(
    name: str,
    options: argparse.Namespace,
    seconds: float | None = None,
    begin: Begin | None = None,
    say: Callable[[str], object] | None = None,
) -> Iterator[Piece | None]:
    """Yields the packets received at a port, and the bytes between them; None when nothing more has arrived.

    A silence is reported, see `silence`, with `say` if it is not None. Raises Lost when the port closes, after all
    received data.
    """
    scanner = Scanner()
    silence: Silence | None = None
    last = time.monotonic()
    try:
        for data in received(name, options, seconds, begin):
            silence = silence or Silence(name, options, say)  # the port is open now
            if data:
                last = time.monotonic()
                silence.data()
                for piece in scanner.feed(data):
                    if piece.packet is not None:
                        silence.packet()
                    yield piece
            elif time.monotonic() - last > INCOMPLETE:
                yield from scanner.flush()
            silence.check()
            yield None
    except Lost:
        yield from scanner.flush()
        raise
    yield from scanner.flush()


__all__ = ["Lost", "add_arguments", "opened", "pieces", "reason", "received"]
