"""Finds out why there is no connection to a device, or why data arrive at a lower rate than requested."""

from __future__ import annotations

import errno
import os
import time
from collections.abc import Mapping
from importlib import import_module
from typing import Any

from ..binding import MipError, NoAnswer, Parser, PortClosed, Refused, identify, module, open_port, session
from ..logs.recognize import UNKNOWN, recognized
from ..names.occurrence import Occurrence
from ..ports.connection import why_not
from ..ports.silence import resume_command
from ..text import show
from ..text.numbers import hertz
from .examined import Examined
from .findings import Finding

#: Bits on a serial line per byte.
_BITS = 10
#: The share of the baud rate above which a line counts as full.
FULL = 0.9
#: The share of the baud rate, measured, that no line carries that is limited by it.
_IMPOSSIBLE = 1.1
#: The share of a requested rate that counts as reaching it.
_REACHED = 0.95


class Patient:
    """A device at a port, and the data that it sends while it is watched."""

    def __init__(self, name: str, baud: int | None) -> None:
        self.name = name
        self.findings: list[Finding] = []
        self.model: str | None = None
        self.data = b""
        self.bases: dict[int, float] = {}  # set -> base rate, for the sets with requested rates
        self._baud = baud

    def watch(self, seconds: float, rates: Mapping[Occurrence, float]) -> None:
        """Opens the port, reads the identity and the base rates of the device, and collects the data that it sends."""
        came: list[bytes] = []
        try:
            device = open_port(self.name, self._baud, capacity=1, on_bytes=lambda data: came.append(bytes(data)))
        except (OSError, ImportError, MipError, ValueError) as error:
            self.findings.append(why_not_open(self.name, error))
            return
        with device:
            self._baud = device.baud
            answers = self._ask(device, rates)
            came.clear()
            time.sleep(seconds)
            self.data = b"".join(came)
            lost = device.closed
        if lost:  # what did not arrive proves nothing about the device
            self._find("port lost", "the port was closed meanwhile", "check the connector and the power supply")
            return
        parser = Parser()
        self._connection(answers, bool(parser.feed(self.data) or parser.flush()), seconds)

    def _ask(self, device: Any, rates: Mapping[Occurrence, float]) -> bool:
        """Queries the identity and the base rates. Does the device answer?"""
        commands = session()
        if commands is None:
            return False
        try:
            reply = device.request(module("base").GetDeviceInfo())
            profile = identify(reply.device_info)
            self.model = profile.id if profile is not None else None
        except Refused:
            pass
        except (NoAnswer, PortClosed):
            return False
        except (MipError, AttributeError):
            pass
        for number in dict.fromkeys(occurrence.set for occurrence in rates):
            try:
                self.bases[number] = _base_rate(device, commands, number)
            except MipError:
                continue  # a device without this set
        return True

    def _find(self, cause: str, text: str, remedy: str = "", *details: str) -> None:
        self.findings.append(Finding(cause, text, remedy, details))

    def _connection(self, answers: bool, packets: bool, seconds: float) -> None:
        serial = self._baud is not None
        if answers and not packets:
            remedy = f"`mip send {self.name} {resume_command()}`, or start data: `mip stream {self.name} NAME@HZ`"
            self._find("idle", f"the device answers, but sends no data in {seconds:g} s", remedy)
        elif not answers and packets:
            self._find("no answers", "data arrive, but commands are not answered", "check the line from host to device")
        elif not answers and self.data:
            what, remedy = recognized(self.data)
            if what == UNKNOWN.what:
                remedy = (
                    f"`mip doctor {self.name} --baud auto` finds the rate" if serial else "check the host and the port"
                )
            at = f" at {self._baud} Bd" if serial else ""
            cause = "wrong baud rate" if serial and what == UNKNOWN.what else "wrong port"
            self._find(cause, f"bytes arrive{at}, but no packets: {what}", remedy)
        elif not answers:
            more = f"; `mip doctor {self.name} --baud auto` tries all rates" if serial else ""
            self._find("no device", "nothing arrives and nothing answers", f"wrong port, or no power{more}")

    def line(self, seconds: float) -> None:
        """Adds a finding if the line is full. USB and others that carry more than their rate are not limited by it."""
        if self._baud is None or not self.data:
            return
        used = len(self.data) * _BITS / (self._baud * seconds)
        if FULL < used < _IMPOSSIBLE:
            text = f"{min(used, 1):.0%} of {self._baud} Bd are used"
            self._find("line is full", text, "raise the baud rate, or send less")

    def rates(self, wanted: Mapping[Occurrence, float], examined: Examined) -> None:
        """Adds a finding for each rate that is not reached, with the reason."""
        for occurrence, rate in wanted.items():
            real = examined.rates.get((occurrence.set, occurrence.kind.DESCRIPTOR), 0.0)
            if real >= _REACHED * rate:
                continue
            base = self.bases.get(occurrence.set)
            remedy = f"`mip stream {self.name} {occurrence.name}@{rate:g}` starts it"
            if base and rate > base:
                remedy = f"the base rate of {show.set_name(occurrence.set)} is {base:g} Hz; no higher rate is possible"
            elif base and abs(base / rate - round(base / rate)) > 1e-9:
                near = base / max(round(base / rate), 1)
                remedy = f"rates are {base:g} Hz divided by whole numbers; the nearest is {hertz(near)} Hz"
            elif any(e.cause == "overload" for e in examined.events) or any(
                f.cause == "line is full" for f in self.findings
            ):
                remedy = "the line cannot carry it: raise the baud rate"
            self._find("rate not reached", f"{occurrence.name}: {hertz(real)} Hz instead of {rate:g} Hz", remedy)


def _base_rate(device: Any, commands: Any, number: int) -> float:
    """Reads the base rate of a set, with the command of older devices if the device rejects the usual one."""
    try:
        return float(commands.rate(device.request(commands.base_rate(number))))
    except Refused:
        older = commands.older.get(number)
        if older is None:
            raise
        return float(older.rate(device.request(older.base_rate())))


def why_not_open(name: str, error: BaseException) -> Finding:
    """Explains why a port cannot be opened."""
    number = getattr(error, "errno", None)
    message = why_not(name, error)
    if isinstance(error, ImportError):
        return Finding("missing extra", message, "install the extra `serial`: pip install pyserial")
    if number == errno.EBUSY:
        return Finding("port in use", message, "close the program that uses it; on Linux, `fuser -v PORT` names it")
    if number == errno.EACCES:
        return Finding("no permission", message, "on Linux, join the group that owns the port: dialout or uucp")
    if number == errno.ENOENT or (os.sep in name and not os.path.exists(name)):
        return Finding("no such port", message, _others())
    if number == errno.ECONNREFUSED:
        return Finding("wrong port", message, "nothing listens there; check host and number")
    if getattr(error, "kind", "") == "no_device":
        return Finding("no device", message, "wrong port, no power, or another protocol on the port")
    return Finding("cannot be opened", message, "check its name")


def _others() -> str:
    """Lists the existing serial ports, as a remedy."""
    try:
        listing: Any = import_module("serial.tools.list_ports")
    except ImportError:
        return "check its name"
    names = ", ".join(sorted(port.device for port in listing.comports()))
    return f"there are {names}" if names else "there is no serial port; plug in the device"
