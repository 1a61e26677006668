"""Finds and changes the baud rate of a device."""

from __future__ import annotations

import time
from collections.abc import Iterable
from typing import Any

from .conversation import AtPort, Dialog, Step
from .errors import NoAnswer, NoDevice, Refused
from .field import Command
from .parser import Parser
from .port import READ_TIMEOUT, USUAL, as_port, read_some, write_all

#: Seconds that a device takes to change its rate, until it answers at the new one.
CHANGE = 0.25
#: Seconds to listen at each rate.
LISTEN = 0.3


class Ping(Command[None]):
    """The command that every device answers, whatever the specification of this package."""

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
    """The rates of all known devices, the usual one first, then in descending order."""
    from .devices import DEVICES

    known = {rate for d in DEVICES.values() for port in d.ports for rate in port.baud_rates}
    return (USUAL, *sorted(known - {USUAL}, reverse=True))


def detect_baud(port: Any, candidates: Iterable[int] | None = None, listen: float = LISTEN) -> int:
    """Sets a serial port to the rate at which a device answers, and returns the rate.

    Any packet is sufficient: the answer to a ping, or data. Data that arrives meanwhile is lost.
    `candidates`: the rates to try, in order; by default those of all known devices. `listen`:
    seconds for each. Raises NoDevice, and restores the rate; OSError if the port is lost.
    """
    port = as_port(port)
    first = getattr(port, "baudrate", None)
    if first is None:
        raise NoDevice(f"{port!r} has no baud rate to be found")
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
    """Does a packet arrive at the current rate? Tries twice: earlier bytes may damage the first answer."""
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
    """The steps of `Device.change_baud`."""
    new, old = getattr(command, "baud", None), device.baud
    if new is None or old is None:
        raise ValueError("it takes a command that writes `baud`, and a port with a baud rate")
    try:
        yield Step(command)
    except NoAnswer:  # its answer may have arrived at the new rate
        pass
    yield Step(None, CHANGE)
    for rate in (new, old):
        device.baud = rate
        for _ in range(attempts):
            try:
                yield Step(Ping(), LISTEN)
            except NoAnswer:
                continue
            except Refused:  # by a device that answers
                pass
            return int(rate)
    raise NoAnswer(command)
