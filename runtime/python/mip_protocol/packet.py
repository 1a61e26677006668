"""Packets: `75 65 set length fields… checksum`."""

from __future__ import annotations

from collections.abc import Iterator
from operator import index
from typing import Any, NamedTuple

from .checks import checksum as checksum
from .exceptions import DecodeError, EncodeError, PacketError

SYNC = b"\x75\x65"
MAX_PAYLOAD = 255
OVERHEAD = 6
#: Sets that no packet has: in the specification, they denote every command set and every data set.
NO_SETS = b"\x00\xff"


def as_bytes(data: Any) -> bytes:
    """Returns the bytes of any buffer. Raises TypeError, with the remedy, for text and lists."""
    try:
        return bytes(memoryview(data))
    except TypeError:
        is_text, is_list = isinstance(data, str), isinstance(data, (list, tuple))
        remedy = f"; write bytes{'.fromhex' * is_text}({data!r})" if is_text or is_list else ""
        kind = "text" if is_text else type(data).__name__
        raise TypeError(f"must be bytes, not {kind}{remedy}") from None


class RawField(NamedTuple):
    """An undecoded field of a packet."""

    set: int
    descriptor: int
    data: bytes

    @property
    def error(self) -> DecodeError | None:
        """Why it was not decoded; None if there was no error, or its descriptor is unknown."""
        return None


class Undecoded(RawField):
    """A field that cannot be decoded. It equals a `RawField` with the same bytes."""

    _error: DecodeError | None = None

    @classmethod
    def because(cls, raw: RawField, error: DecodeError) -> Undecoded:
        undecoded = cls(*raw)
        undecoded._error = error
        return undecoded

    @property
    def error(self) -> DecodeError | None:
        return self._error

    def __repr__(self) -> str:
        return f"{super().__repr__()[:-1]}, error={self._error!s})"


class Packet:
    """One complete packet with a correct checksum.

    >>> packet = Packet(bytes.fromhex("75650104 04f10100 d56a"))
    >>> packet.set, [(f.descriptor, f.data) for f in packet]
    (1, [(241, b'\\x01\\x00')])
    """

    __slots__ = ("_data",)

    def __init__(self, data: bytes | bytearray | memoryview) -> None:
        """Raises PacketError of kind `sync`, `length` or `checksum`."""
        data = data if type(data) is bytes else as_bytes(data)  # a bytearray may change later
        if data[:2] != SYNC:
            raise PacketError("sync", f"begins with {data[:2].hex() or 'nothing'}, not with 7565")
        if len(data) < OVERHEAD or len(data) != data[3] + OVERHEAD or data[2] in NO_SETS:
            raise PacketError("length", f"{len(data)} bytes do not make a packet")
        if checksum(data[:-2]) != data[-2:]:
            right = checksum(data[:-2]).hex()
            raise PacketError("checksum", f"{data[-2:].hex()} should be {right}")
        self._data = data

    @classmethod
    def _trusted(cls, data: bytes) -> Packet:
        """Makes a packet without checks, for the parser, which has checked the data."""
        packet = cls.__new__(cls)
        packet._data = data
        return packet

    @property
    def set(self) -> int:
        """The descriptor set."""
        return self._data[2]

    @property
    def payload(self) -> bytes:
        """The bytes of all fields."""
        return self._data[4:-2]

    def __bytes__(self) -> bytes:
        return self._data

    def __len__(self) -> int:
        return len(self._data)

    def __eq__(self, other: object) -> bool:
        return self._data == other._data if isinstance(other, Packet) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._data)

    def __repr__(self) -> str:
        return f"Packet({self._data.hex()})"

    @property
    def fields(self) -> tuple[RawField, ...]:
        """The fields in order, up to a malformed one."""
        return self._walk()[0]

    @property
    def malformed(self) -> PacketError | None:
        """The error of the malformed field after `fields`; None if there is none."""
        return self._walk()[1]

    def _walk(self) -> tuple[tuple[RawField, ...], PacketError | None]:
        fields: list[RawField] = []
        try:
            fields.extend(self)
        except PacketError as error:
            return tuple(fields), error
        return tuple(fields), None

    def __iter__(self) -> Iterator[RawField]:
        """Yields the fields in order; raises PacketError (`field_length`) at a malformed one."""
        data, at, end = self._data, 4, len(self._data) - 2
        number = data[2]
        while at < end:
            length = data[at]
            if length < 2 or length > end - at:
                raise PacketError("field_length", f"a field of length {length} in {end - at} bytes")
            yield RawField(number, data[at + 1], data[at + 2 : at + length])
            at += length


class PacketBuilder:
    """Puts fields into a packet of one descriptor set.

    >>> PacketBuilder(0x01).add(0x01).build()
    Packet(756501020201e0c6)
    """

    def __init__(self, set: int) -> None:
        try:
            self._set = index(set)
        except TypeError:
            self._set = 0
        if not 1 <= self._set <= 254:
            raise EncodeError("set", f"{set!r} is not a descriptor set; use 1 to 254")
        self._payload = bytearray()

    def add(self, descriptor: int, data: bytes | bytearray | memoryview = b"") -> PacketBuilder:
        """Adds a field. Raises EncodeError (`length`), and changes nothing, if it does not fit."""
        try:
            number = index(descriptor)
        except TypeError:
            number = -1
        if not 0 <= number <= 255:
            raise EncodeError("range", f"{descriptor!r} is not a descriptor; use 0 to 255")
        data = data if type(data) is bytes else as_bytes(data)
        size = len(data) + 2
        if size > 255 or len(self._payload) + size > MAX_PAYLOAD:
            raise EncodeError("length", f"another {size} bytes do not fit into the payload of 255")
        self._payload += bytes((size, number)) + data
        return self

    def build(self) -> Packet:
        head = SYNC + bytes((self._set, len(self._payload))) + self._payload
        return Packet._trusted(head + checksum(head))
