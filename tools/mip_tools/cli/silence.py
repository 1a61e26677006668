"""Reports a port at which nothing arrives, or nothing that can be decoded."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable

from ..errors import Failure
from .arguments import seconds

#: Seconds without data after which a silence is reported.
PATIENCE = 2.0
#: The exit status if the silence lasts until the time-out.
SILENT = 4


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--timeout", type=seconds, metavar="S", help="fail after S seconds without data (default: keep waiting)"
    )


class Silence:
    """Watches a port: reports a silence once, and raises Failure after the time-out, if there is one."""

    def __init__(self, name: str, options: argparse.Namespace, say: Callable[[str], object] | None = None) -> None:
        """`say` is called with the report, which otherwise goes to standard error."""
        self._name = name
        self._say = say or self._print
        self._program = f"mip {options.command}"
        self._limit: float | None = getattr(options, "timeout", None)
        self._heard = self._understood = time.monotonic()
        self._reported = False

    def packet(self) -> None:
        """Notes that a packet has arrived."""
        self._heard = self._understood = time.monotonic()
        self._reported = False

    def data(self) -> None:
        """Notes that bytes have arrived."""
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
    """Returns the name of the command that resumes streams; empty if the specification names none."""
    from ..binding import session

    commands = session()
    return "" if commands is None else str(commands.resume().NAME)


__all__ = ["PATIENCE", "SILENT", "Silence", "add_arguments", "resume_command"]
