"""Ports on the command line."""

from __future__ import annotations

import os
import queue
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime
from typing import TYPE_CHECKING, Any

from .. import binding
from ..binding import MipError, NoAnswer, PortError
from ..errors import Failure
from ..logs.recognize import recognized
from ..logs.scan import Piece, Scanner
from .silence import SILENT, Line, Silence

if TYPE_CHECKING:
    from ..binding import DeviceAtPort


Begin = Callable[["DeviceAtPort"], bool]
#: Seconds without data after which an incomplete packet is discarded.
INCOMPLETE = 0.5
_TURN = 0.1


class Lost(Failure):
    """A port that has closed by itself."""


class Silent(Failure):
    """A device that does not answer; `sent` says what arrives in place of MIP, if anything does."""

    def __init__(self, name: str, error: NoAnswer, skipped: bytes) -> None:
        found = recognized(skipped) if skipped else None
        self.sent = found.what if found else ""
        hint = f", but sends {found}" if found else "; check the port and --baud"
        super().__init__(f"{name} did not answer {error.command.NAME}{hint}", SILENT)


@contextmanager
def opened(line: Line, **more: Any) -> Iterator[DeviceAtPort]:
    """Opens the port of a device. Raises Failure if it cannot be opened, and for errors of the device from within."""
    if os.path.isfile(line.name):
        raise Failure(f"{line.name} is a file, not a port")
    skipped: deque[bytes] = deque(maxlen=100)
    try:
        device = binding.open_port(line.name, line.baud, on_skipped=skipped.append, **more)
    except (OSError, ImportError, MipError, ValueError) as error:
        raise Failure(why_not(line.name, error)) from None
    with device:
        try:
            yield device
        except NoAnswer as error:
            only = not device.waiting and not device.dropped  # no MIP packets besides
            raise Silent(line.name, error, b"".join(skipped) if only else b"") from None
        except MipError as error:
            raise Failure(f"{line.name}: {reason(error)}") from None


def why_not(name: str, error: BaseException) -> str:
    """Describes why a port cannot be opened, with its name."""
    message = reason(error)
    return message if isinstance(error, PortError) else f"{name} cannot be opened: {message}"


def reason(error: BaseException) -> str:
    """Formats the message of an exception in one line."""
    message = getattr(error, "strerror", None) or getattr(error, "detail", None) or str(error) or type(error).__name__
    return " ".join(str(message).split())


def received_bytes(line: Line, seconds: float | None = None, begin: Begin | None = None) -> Iterator[bytes]:
    """Yields the bytes received at a port as they arrive, until the time is over, and empty bytes during a pause.

    `begin` is called with the device as soon as the port is open; if it returns False, data from before are dropped.
    When the port closes, after all received bytes, it is opened again if `line` says so; else, raises Lost.
    """
    came: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    with opened(line, capacity=1, on_bytes=lambda data: came.put(bytes(data))) as device:
        if begin is not None:
            keep = begin(device)
            while not keep and not came.empty():
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
                if closed and not line.reopen:
                    raise Lost(f"{line.name} was closed") from None
                if closed and not _back(device, line, begin, end):
                    return
                yield b""


def _back(device: DeviceAtPort, line: Line, begin: Begin | None, end: float | None) -> bool:
    """Waits until a lost port is open again and `begin` has succeeded; False if the time is over before.

    Raises Failure after the time-out.
    """
    lost = time.monotonic()
    while end is None or time.monotonic() < end:
        if line.timeout is not None and time.monotonic() - lost >= line.timeout:
            raise Failure(f"{line.name} was lost, and is not back after {line.timeout:g} s", SILENT)
        try:
            if device.closed:
                device.reopen(_TURN)
            if begin is not None:
                begin(device)
        except (OSError, MipError, Failure):
            time.sleep(_TURN)
            continue
        gap, now = time.monotonic() - lost, datetime.now()
        if line.gaps is not None:
            line.gaps.append(max(gap, 0.001))  # written in milliseconds: not as 0, which is no gap
        print(f"mip {line.command}: {line.name} was lost for {gap:.1f} s, until {now:%H:%M:%S}", file=sys.stderr)
        return True
    return False


def port_pieces(
    line: Line,
    seconds: float | None = None,
    begin: Begin | None = None,
    say: Callable[[str], object] | None = None,
) -> Iterator[Piece | None]:
    """Yields the packets received at a port, and the bytes between them; None when nothing more has arrived.

    A silence is reported, see `silence`, with `say` if it is not None. Raises Lost when the port closes, and Failure
    after the time-out, after all received data.
    """
    scanner = Scanner()
    silence: Silence | None = None
    last = time.monotonic()
    try:
        for data in received_bytes(line, seconds, begin):
            silence = silence or Silence(line, say)  # the port is open now
            if data:
                last = time.monotonic()
                silence.data(data)
                for piece in scanner.feed(data):
                    if piece.packet is not None:
                        silence.packet()
                    yield piece
            elif time.monotonic() - last > INCOMPLETE:
                yield from scanner.flush()
            silence.check()
            yield None
    except Failure:
        yield from scanner.flush()
        raise
    yield from scanner.flush()
