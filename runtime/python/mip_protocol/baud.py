"""Finds and changes the baud rate of a device."""

from __future__ import annotations

import time
from collections.abc import Iterable
from typing import Any

from ._index import BAUD_RATES
from .conversation import AtPort, Dialog, Step
from .errors import NoAnswer, Refused
from .exceptions import NoDevice
from .field import Command
from .parser import Parser
from .port import READ_TIMEOUT, USUAL, as_port, read_some, write_all

#: Seconds that a device takes to change its rate, until it answers at the new one.
CHANGE = 0.25
#: Seconds to listen at each rate.
LISTEN = 0.3


class Ping(Command[None]):
    """A ping, which every device answers, whether or not this package's specification has it."""

    __slots__ = ()

    SET = 0x01
    SETS = (0x01,)
    DESCRIPTOR = 0x01
    NAME = "ping"
    ROLE = "command"

    def _write(self) -> bytes:
        return b""


PING = bytes(Ping().packet())


def rates() -> tuple[int, ...]:
    """Returns the rates of all known devices: the default one, then the others, highest first."""
    return (USUAL, *(rate for rate in BAUD_RATES if rate != USUAL))


def detect_baud(port: Any, candidates: Iterable[int] | None = None, listen: float = LISTEN) -> int:
    """Sets a serial port to the rate at which a device answers, and returns the rate.

    Any packet is sufficient: the reply to a ping, or data. Data that arrives during the search is
    discarded.
    `candidates`: the rates to try, in order; by default those of all known devices. `listen`:
    seconds for each. Raises NoDevice, and restores the rate; OSError if the port is lost.
    """
    port = as_port(port)
    first = getattr(port, "baudrate", None)
    if first is None:
        raise NoDevice(f"{port!r} has no baud rate that could be detected")
    timeout, tried = getattr(port, "timeout", None), []
    port.timeout = READ_TIMEOUT
    try:
        for rate in rates() if candidates is None else candidates:  # one by one: they may end early
            if rate in tried:
                continue
            tried.append(rate)
            port.baudrate = rate
            if answers(port, listen):
                return rate
        port.baudrate = first
    finally:
        port.timeout = timeout
    listed = ", ".join(map(str, tried)) or "no rate"
    raise NoDevice(f"no device answers at {listed} Bd; is it switched on, and on this port?")


def answers(port: Any, listen: float) -> bool:
    """Does a packet arrive at the current rate? Pings twice: bytes sent earlier may spoil the
    first."""
    clear = getattr(port, "reset_input_buffer", None)
    if clear is not None:
        clear()
    parser = Parser()
    end = time.monotonic() + listen
    again = end - listen / 2
    write_all(port, PING)
    while (now := time.monotonic()) < end:
        if parser.feed(read_some(port)) or parser.look_behind():
            return True
        if now >= again:
            again = end
            write_all(port, PING)
    return False


def changing(device: AtPort, command: Command[Any], attempts: int) -> Dialog[int]:
    """Yields the steps of `Device.change_baud`."""
    new, old = getattr(command, "baud", None), device.baud
    if new is None or old is None:
        raise ValueError("needs a command that writes `baud`, and a port with a baud rate")
    try:
        yield Step(command)
    except NoAnswer:  # its reply may have been sent at the new rate
        pass
    yield Step(None, CHANGE)
    for rate in (new, old):
        device.baud = rate
        for _ in range(attempts):
            try:
                yield Step(Ping(), LISTEN)
            except NoAnswer:
                continue
            except Refused:  # a NACK is a reply, too
                pass
            return int(rate)
    raise NoAnswer(command)
