"""Finds packets in a stream of bytes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from .checks import HEADS, has_checksum, is_correct
from .packet import NO_SETS, OVERHEAD, SYNC, Packet

if TYPE_CHECKING:
    from typing_extensions import Buffer

T = TypeVar("T")

#: Buffers other than bytes are copied and searched in pieces of this size.
PIECE = 1 << 20


class Scanner(Generic[T]):
    """The base of `Parser` and `Decoder`, which accept bytes and return packets or their fields."""

    def __init__(self) -> None:
        self._rest = b""  # less than one packet
        #: The number of bytes that are not part of a packet.
        self.skipped = 0
        #: The number of packet candidates with a wrong checksum.
        self.bad_checksums = 0

    @property
    def pending(self) -> int:
        """The number of bytes that may be the start of a packet."""
        return len(self._rest)

    def feed(self, data: Buffer) -> list[T]:
        """Returns the packets that these bytes complete. Any buffer is accepted: bytes, a
        memoryview, a mapped file, an array."""
        items: list[T] = []
        for piece in _pieces(data):
            self._scan(piece, items)
        return items

    def flush(self) -> list[T]:
        """Ends the stream, for example at the end of a file: returns the packets found within a
        last, incomplete one."""
        items: list[T] = []
        self._scan(b"", items, final=True)
        return items

    def feed_all(self, data: Buffer) -> list[T | bytes]:
        """Like `feed`, but also returns the bytes between packets, in order, so that no byte is
        lost.

        The bytes between two packets may be returned in several pieces.
        """
        items: list[T | bytes] = []
        for piece in _pieces(data):
            self._scan(piece, items, between=True)
        return items

    def flush_all(self) -> list[T | bytes]:
        """Like `flush`, but also returns the bytes between packets."""
        items: list[T | bytes] = []
        self._scan(b"", items, between=True, final=True)
        return items

    def look_behind(self) -> list[T]:
        """Discards an incomplete packet if a whole packet begins within it, because it was noise.

        Otherwise nothing changes.
        """
        return [item for item in self.look_behind_all() if not isinstance(item, bytes)]

    def look_behind_all(self) -> list[T | bytes]:
        """Like `look_behind`, but also returns the bytes between packets."""
        items: list[T | bytes] = []
        rest, at = self._rest, 0
        while (at := rest.find(SYNC, at + 1)) >= 0 and len(rest) - at >= OVERHEAD:
            end = at + rest[at + 3] + OVERHEAD
            if end <= len(rest) and rest[at + 2] not in NO_SETS and is_correct(rest[at:end]):
                self.skipped += at
                items.append(rest[:at])
                self._rest = rest[at:]
                self._scan(b"", items, between=True)
                break
        return items

    def _scan(
        self, data: bytes, items: list[Any], between: bool = False, final: bool = False
    ) -> None:
        """Appends to `items` the packets in the waiting bytes and in these, and, if requested, the
        bytes between them."""
        raise NotImplementedError

    def _find(self, buffer: bytes, at: int, final: bool) -> tuple[int, int]:
        """Returns begin and end of the next packet; end 0 if it is incomplete."""
        length = len(buffer)
        while True:
            found = buffer.find(SYNC, at)
            if found < 0:
                waits = not final and buffer.endswith(SYNC[:1], at)
                return length - waits, 0
            at = found
            if length - at > 2 and buffer[at + 2] in NO_SETS:
                at += 1
                continue
            size = buffer[at + 3] + OVERHEAD if length - at > 3 else OVERHEAD
            if length - at >= size:
                if is_correct(buffer[at : at + size]):
                    return at, at + size
                at = self._behind_bad(buffer, at, size)
            elif final:
                at += 1
            else:
                return at, 0

    def _behind_bad(self, buffer: bytes, at: int, size: int) -> int:
        """Returns where to continue after a bad packet. Noise may repeat itself; the repetitions
        are counted without checking each, because every one is equally bad."""
        self.bad_checksums += 1
        again = buffer.find(SYNC, at + 1)
        if again < 0 or buffer[again + 2 : again + 4] != buffer[at + 2 : at + 4]:
            return at + 1 if again < 0 else again
        if buffer[again : again + size] != buffer[at : at + size]:
            return again
        same, step = size, 4096
        while step:
            piece = buffer[again + same : again + same + step]
            if len(piece) == step and piece == buffer[at + same : at + same + step]:
                same += step
            else:
                step //= 4
        period = again - at
        repeated = (same - size) // period
        self.bad_checksums += repeated + 1
        return again + repeated * period + 1


class Parser(Scanner[Packet]):
    """Accepts bytes in pieces of any size and returns the packets in them.

    Anything else in the stream (NMEA sentences, noise, packets with a bad checksum) is skipped and
    counted in `skipped`. The result does not depend on the sizes of the pieces.

    >>> parser = Parser()
    >>> parser.feed(b"$GP*00" + bytes.fromhex("756501020201e0"))
    []
    >>> parser.feed(b"\\xc6")
    [Packet(756501020201e0c6)]
    >>> parser.skipped
    6
    """

    def _scan(
        self, data: bytes, items: list[Any], between: bool = False, final: bool = False
    ) -> None:
        buffer = self._rest + data if self._rest else data
        add, known, new = items.append, HEADS.get, object.__new__
        at, length = 0, len(buffer)
        while True:
            head = known(buffer[at : at + 4])
            if head is not None:
                end = at + head[0]
                if end <= length and has_checksum(buffer, at, head):
                    packet = new(Packet)
                    packet._data = buffer[at:end]
                    add(packet)
                    at = end
                    continue
            begin, end = self._find(buffer, at, final)
            if begin != at:
                self.skipped += begin - at
                if between:
                    add(buffer[at:begin])
            if not end:
                self._rest = buffer[begin:]
                return
            HEADS.add_header(buffer[begin : begin + 4])
            add(Packet._trusted(buffer[begin:end]))
            at = end


def _pieces(data: Buffer) -> Iterator[bytes]:
    if type(data) is bytes:
        yield data
        return
    view = memoryview(data)
    if view.nbytes <= PIECE or not view.c_contiguous:
        yield view.tobytes()
        return
    view = view.cast("B")
    for at in range(0, len(view), PIECE):
        yield view[at : at + PIECE].tobytes()
