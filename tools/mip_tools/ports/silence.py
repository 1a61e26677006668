"""Reports a port at which nothing arrives, or nothing that can be decoded."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import NamedTuple

from .. import binding
from ..errors import Failure
from ..logs.recognize import recognized

#: Seconds without data after which a silence is reported.
PATIENCE = 2.0
#: Bytes that are kept, to say what they are.
_MOST = 1 << 12
#: The exit status if the silence lasts until the time-out.
SILENT = 4


class Line(NamedTuple):
    """A port, and how a command uses it."""

    name: str
    baud: int | None  # None: the rate is looked for
    command: str  # of `mip`, for its messages
    timeout: float | None = None  # seconds without data
    reopen: bool = False  # if the port is lost
    gaps: list[float] | None = None  # the seconds for which it was lost are added here


class Silence:
    """Watches a port: reports a silence once, and raises Failure after the time-out, if there is one."""

    def __init__(self, line: Line, say: Callable[[str], object] | None = None) -> None:
        """`say` is called with the report, which otherwise goes to standard error."""
        self._line = line
        self._say = say or self._print
        self._heard = self._understood = self._checked = time.monotonic()
        self._reported = False
        self._bytes = b""  # since the last packet

    def packet(self) -> None:
        """Notes that a packet has arrived."""
        self._heard = self._understood = time.monotonic()
        self._bytes = b""
        self._reported = False

    def data(self, data: bytes) -> None:
        """Notes that bytes have arrived."""
        self._heard = time.monotonic()
        self._bytes = (self._bytes + data)[-_MOST:]

    def check(self) -> None:
        """Reports a silence on standard error. Raises Failure after the time-out."""
        now = time.monotonic()
        if now - self._checked > PATIENCE:  # the port was not open
            self._heard = self._understood = now
        self._checked = now
        spent = now - self._understood
        limit = self._line.timeout
        if limit is not None and spent >= limit:
            raise Failure(f"{self._line.name}: {self._report(now, limit)}", SILENT)
        if spent >= PATIENCE and not self._reported:
            self._reported = True
            self._say(self._report(now, PATIENCE))

    def _print(self, text: str) -> None:
        print(f"mip {self._line.command}: {text}", file=sys.stderr)

    def _report(self, now: float, waited: float) -> str:
        if now - self._heard < self._heard - self._understood:  # bytes arrive, but no packets
            what = recognized(self._bytes)
            remedy = " `--baud auto` finds it" * what.remedy.endswith("the baud rate right?")
            return f"bytes arrive, but no packet for {waited:g} s: {what}{remedy}"
        resume = resume_command()
        remedy = f": `mip send {self._line.name} {resume}`" if resume else ""
        return f"no data for {waited:g} s: the device is idle, or the stream is off{remedy}"


def resume_command() -> str:
    """Returns the name of the command that resumes streams; empty if the specification names none."""
    commands = binding.session()
    return "" if commands is None else str(commands.resume().NAME)
