"""Exceptions. All but `Failure` are `MipError`, which is a `ValueError`."""

from __future__ import annotations


class MipError(ValueError):
    """`kind` names the error in one word."""

    def __init__(self, kind: str, detail: str) -> None:
        # `args` keeps the arguments of the class, so that errors can be pickled.
        self.kind = kind
        self.detail = detail

    def __str__(self) -> str:
        return f"{self.kind}: {self.detail}"


class DecodeError(MipError):
    """Bytes that cannot be decoded."""


class Truncated(DecodeError):
    """The data end too early."""

    def __init__(self, wanted: int, left: int) -> None:
        super().__init__("truncated", f"{wanted} bytes wanted, {left} left")


class PacketError(DecodeError):
    """Not a packet (`sync`, `length`, `checksum`), or a malformed field in it (`field_length`)."""


class MissingResponse(MipError):
    """A command that asks for a response was acknowledged without one."""

    def __init__(self, command: str) -> None:
        super().__init__("missing_response", f"{command} was acknowledged without its response")


class EncodeError(MipError):
    """A value that cannot be sent.

    `missing`: a required value is None. `range`: a number does not fit. `count`: a wrong number of
    elements. `tag`: a union's member is not the one that its tag selects. `length`: too long.
    `set`: not of the descriptor set of the packet.
    """


class UnknownName(MipError, LookupError):
    """A name of nothing (`unknown_name`), or of several things (`ambiguous`); `near` has those that may be meant."""

    def __init__(self, kind: str, detail: str, near: tuple[str, ...] = ()) -> None:
        super().__init__(kind, detail)
        self.near = near

    def __str__(self) -> str:
        return self.detail


class Failure(Exception):
    """What a command line says in one line before it gives up: what is wrong, and the remedy."""

    def __init__(self, text: str, status: int = 1) -> None:
        super().__init__(text)
        self.status = status
