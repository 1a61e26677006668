"""Messages about a port that sends nothing, or nothing that can be decoded."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable

from ..errors import Failure
from .arguments import seconds

#: Seconds after which a port that sends nothing is reported.
PATIENCE = 2.0
#: Exit status when it stays silent.
SILENT = 4


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--timeout", type=seconds, metavar="S", help="fail after S seconds without data (default: wait on)"
    )


class Silence:
    """Watches what arrives at a port: reports a silence once, and ends it if there is a time-out."""

    def __init__(self, name: str, options: argparse.Namespace, say: Callable[[str], object] | None = None) -> None:
        """`say` is called with the report, which otherwise goes to standard error."""
        self._name = name
        self._say = say or self._print
        self._program = f"mip {options.command}"
        self._limit: float | None = getattr(options, "timeout", None)
        self._heard = self._understood = time.monotonic()
        self._reported = False

    def packet(self) -> None:
        """A packet has arrived."""
        self._heard = self._understood = time.monotonic()
        self._reported = False

    def data(self) -> None:
        """Bytes have arrived."""
        self._heard = time.monotonic()

    def check(self) -> None:
        """Reports a silence on standard error. Raises Failure after the time-out."""
        now = time.monotonic()
        spent = now - self._understood
        if self._limit is not None and spent >= self._limit:
            raise Failure(f"{self._name}: {self._said(now, self._limit)}", SILENT)
        if spent >= PATIENCE and not self._reported:
            self._reported = True
            self._say(self._said(now, PATIENCE))

    def _print(self, text: str) -> None:
        print(f"{self._program}: {text}", file=sys.stderr)

    def _said(self, now: float, waited: float) -> str:
        if now - self._heard < self._heard - self._understood:  # bytes arrive, but no packets
            return f"bytes arrive, but no packet for {waited:g} s: is the baud rate right? `--baud auto` finds it"
        resume = resume_command()
        remedy = f": `mip send {self._name} {resume}`" if resume else ""
        return f"no data for {waited:g} s: the device is idle, or the stream is off{remedy}"


def resume_command() -> str:
    """The name of the command that makes a device stream again; empty if the specification names none."""
    from ..binding import session

    commands = session()
    return "" if commands is None else str(commands.resume().NAME)


__all__ = ["PATIENCE", "SILENT", "Silence", "add_arguments", "resume_command"]
