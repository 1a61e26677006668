"""Exceptions. All except `MissingExtra` derive from `MipError`, which is a `ValueError`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from .client import Outcome
from .exceptions import (
    DecodeError,
    EncodeError,
    MipError,
    MissingExtra,
    MissingResponse,
    NoDevice,
    PacketError,
    PortClosed,
    PortError,
    Truncated,
    UnknownName,
)
from .field import Command, Field
from .types import AckCode


@dataclass(frozen=True)
class Cause:
    """The field for which a device has rejected a command, or the command that it has instead; the
    command itself if a value is out of range."""

    index: int  # in the list of the command
    set: int
    descriptor: int  # 0: the whole set
    #: "other_command", "absent", "decimation", "too_many", "range", "undefined" or "unlisted"
    reason: str
    text: str  # "3DM-CV7-AR has no GNSS receiver"


class Refused(MipError):
    """The device has rejected a command; `code` is the reason.

    `outcomes`: the outcome of each command in the same packet, as `Device.exchange` returns them.
    `cause`: the field for which the device has rejected a command that lists fields, the command
    that it has instead, or the value that is out of its documented range, if that is found.
    """

    def __init__(
        self,
        command: Command,
        code: AckCode,
        outcomes: Sequence[Outcome | None] = (),
        cause: Cause | None = None,
    ) -> None:
        words = code.name.lower().replace("_", " ")
        why = f": {cause.text}" if cause else ""
        super().__init__("refused", f"{command.NAME} rejected ({words}){why}")
        self.command = command
        self.code = code
        self.outcomes = tuple(outcomes)
        self.cause = cause

    def __str__(self) -> str:
        return self.detail


class NoAnswer(MipError, TimeoutError):
    """The device has not answered a command in time; it may have carried it out."""

    def __init__(self, command: Command, outcomes: Sequence[Outcome | None] = ()) -> None:
        super().__init__("no_answer", f"the device has not answered {command.NAME} in time")
        self.args = (command, outcomes)
        self.command = command
        self.outcomes = tuple(outcomes)


class NoData(MipError, TimeoutError):
    """None of the fields for which a program waits has arrived in time."""

    def __init__(self, kinds: Sequence[type[Field]], timeout: float) -> None:
        names = ", ".join(kind.NAME for kind in kinds)
        hint = "`stream` starts data, and a device that is idle must resume"
        super().__init__("no_data", f"no {names} within {timeout:g} s; {hint}")
        self.args = (kinds, timeout)

    def __str__(self) -> str:
        return self.detail


class NoSuchRate(MipError):
    """Rates that a device does not support, because it divides its base rate by whole numbers;
    nothing was changed. `nearest`: each requested field -> the nearest rate, in Hz."""

    def __init__(
        self, base: int, wanted: Mapping[type[Field], float], nearest: Mapping[type[Field], float]
    ) -> None:
        asked = [f"{k.NAME} at {w:g} Hz (nearest: {nearest[k]:.5g})" for k, w in wanted.items()]
        super().__init__("rate", f"{', '.join(asked)}; the base rate is {base} Hz")
        self.args = (base, wanted, nearest)
        self.nearest = dict(nearest)


__all__ = [
    "Cause",
    "DecodeError",
    "EncodeError",
    "MipError",
    "MissingExtra",
    "MissingResponse",
    "NoAnswer",
    "NoData",
    "NoDevice",
    "NoSuchRate",
    "PacketError",
    "PortClosed",
    "PortError",
    "Refused",
    "Truncated",
    "UnknownName",
]
