"""Exceptions that have nothing to do with commands; `errors` has all of them.

All except `MissingExtra` derive from `MipError`, which is a `ValueError`.
"""

from __future__ import annotations


class MipError(ValueError):
    """An error of this package; `kind` names it in one word."""

    def __init__(self, kind: str, detail: str) -> None:
        # `args` keeps the arguments of the class's constructor, so that errors can be pickled.
        self.kind = kind
        self.detail = detail

    def __str__(self) -> str:
        return f"{self.kind}: {self.detail}"


class DecodeError(MipError):
    """Bytes that cannot be decoded."""


class Truncated(DecodeError):
    """The data ends too early."""

    def __init__(self, wanted: int, left: int) -> None:
        super().__init__("truncated", f"{wanted} bytes needed, {left} left")


class PacketError(DecodeError):
    """Bytes that are not a packet (`sync`, `length`, `checksum`) or a field (`field_length`)."""


class MissingResponse(MipError):
    """A command that requests a response was acknowledged without one."""

    def __init__(self, command: str) -> None:
        super().__init__("missing_response", f"{command} was acknowledged without its response")


class EncodeError(MipError):
    """A value that cannot be sent.

    Kinds: `missing`: a required value is None. `range`: a number does not fit. `count`: the number
    of elements is wrong. `tag`: a union's member is not the one that its tag selects. `length`: the
    field or packet is too long. `set`: the descriptor set is not the packet's, or does not exist.
    """


class UnknownName(MipError, LookupError):
    """A name that is unknown (`unknown_name`) or has several meanings (`ambiguous`); `near` lists
    the names that may be meant."""

    def __init__(self, kind: str, detail: str, near: tuple[str, ...] = ()) -> None:
        super().__init__(kind, detail)
        self.near = near

    def __str__(self) -> str:
        return self.detail


class PortError(OSError, MipError):
    """A port that cannot be opened. `kind` is `port`, and `errno` the reason, or `kind` is `url` if
    the name is wrong."""

    def __init__(self, kind: str, detail: str, errno: int | None = None) -> None:
        MipError.__init__(self, kind, detail)
        self.args = (kind, detail, errno)
        self.errno = errno

    def __str__(self) -> str:
        return self.detail


class PortClosed(MipError, ConnectionError):
    """The port of a device is closed, or the other end has closed it."""

    def __init__(self, why: str) -> None:
        super().__init__("closed", why)
        self.args = (why,)


class NoDevice(MipError, ConnectionError):
    """No device answers at a port, whatever the baud rate."""

    def __init__(self, why: str) -> None:
        super().__init__("no_device", why)
        self.args = (why,)


class MissingExtra(ImportError):
    """A package that this one needs only for an extra is not installed."""

    def __init__(self, package: str, extra: str) -> None:
        super().__init__(f"{package} is missing; pip install {package}", name=package)
        self.args = (package, extra)
