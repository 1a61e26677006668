"""Common to all command sets: function selectors and the acknowledge field."""

from __future__ import annotations

from typing import Any

from . import codec, types
from .field import Response, Shared
from .types import AckCode

#: The version of the specification that this package was generated from.
VERSION = "0.2.0"

#: Set and descriptor of the command that `Client` uses as a barrier; 0, 0 if the specification
#: names none.
BARRIER = (0x01, 0x01)


# Numbers that are read and written together, by their letters for `struct`.
_2B = codec.Block("2B")


class FunctionSelector(codec.OpenEnum):
    """The operation that a settings command requests."""

    WRITE = 1
    """Apply the new setting."""
    READ = 2
    """Return the current setting in a response."""
    SAVE = 3
    """Save the current setting to non-volatile memory."""
    LOAD = 4
    """Load the saved setting."""
    DEFAULT = 5
    """Load the factory default setting."""
    APPLY = 6
    """Apply the new setting without sending an ACK (5-series devices)."""


class Acknowledge(Shared, Response):
    """Acknowledge (0x00,0xF1).

    Replies to one command field. A response, if there is one, follows it in the same packet.

    - 3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet
    - 3dm-cv7-gnss-ins: Ack/Nack Field Specification
    """

    __slots__ = ("command", "code")
    __match_args__ = ("command", "code")

    SET = 0x00
    SETS = range(0x01, 0x80)
    DESCRIPTOR = 0xF1
    NAME = "protocol.acknowledge"
    _SIZE = 2

    command: int
    """Descriptor of the acknowledged command."""
    code: types.AckCode
    """0 (ACK) if the device carried out the command, otherwise the reason why it did not (NACK)."""

    def __init__(self, command: int, code: types.AckCode) -> None:
        self.command = command
        self.code = code

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _2B.unpack(raw, at)
        self.command = v[0]
        self.code = codec.KNOWN[types.AckCode][v[1]]
        return at + 2

    def _write(self) -> bytes:
        return _2B.write("command code", self.command, self.code)


__all__ = ["VERSION", "AckCode", "Acknowledge", "FunctionSelector"]
