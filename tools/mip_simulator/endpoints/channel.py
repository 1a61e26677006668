"""Passes data between one client and the device, through a bounded queue at the rate of the line."""

from __future__ import annotations

import math
import selectors
from collections import deque
from typing import Protocol

from mip_tools.binding import Parser

from .endpoint import Scramble

#: Bytes that may wait for a slow client; beyond that, the oldest packets are dropped.
CAPACITY = 32768
#: How much an idle line may send at once, in seconds at its baud rate.
BURST = 0.005
#: Bytes that are written at once.
AT_ONCE = 4096


class Link(Protocol):
    """A connection to the device inside this process, as `VirtualDevice.connect` makes it."""

    closed: bool
    baud: int | None

    def read(self) -> bytes: ...
    def write(self, data: bytes) -> None: ...


class Peer(Protocol):
    """The client's side: a pseudo-terminal or a connection."""

    @property
    def speed(self) -> int | None: ...
    @property
    def unread(self) -> int: ...
    def fileno(self) -> int: ...
    def read(self) -> bytes: ...
    def write(self, data: bytes | memoryview) -> int: ...
    def flushed(self) -> bool: ...
    def set_speed(self, baud: int) -> None: ...
    def close(self) -> None: ...


class Channel:
    """One client and its link."""

    def __init__(self, peer: Peer, link: Link, garble: Scramble | None, pace: float, capacity: int = CAPACITY) -> None:
        """`garble`: how a wrong baud rate changes bytes; None: rates are ignored.

        `pace`: simulated seconds per real second, if the baud rate limits the data; 0: no limit.
        """
        self.peer = peer
        self.link = link
        self.dropped = 0  # packets
        self.waits: float | None = math.inf  # the last result of `send`
        self.wanted = selectors.EVENT_READ
        self.until = 0.0  # until when a closed link waits for the client to read
        self._garble = garble
        self._pace = pace
        self._capacity = capacity
        self._queue: deque[bytes] = deque()
        self._size = 0
        self._started = 0  # bytes of the first chunk that are sent
        self._free = 0.0  # when the line will have sent all earlier bytes
        self._baud: int | None = None

    @property
    def size(self) -> int:
        """Bytes that wait for the client."""
        return self._size

    def collect(self) -> None:
        """Collects the bytes that the device has sent. If there is no room, drops the oldest packets."""
        chunk = self.link.read()
        if self._baud is None:
            self._follow()
        if chunk and self._garble and self._mismatch:
            chunk = self._garble(chunk)
        self._follow()  # the ACK of a change was sent at the old rate
        if not chunk:
            return
        self._queue.append(chunk)
        self._size += len(chunk)
        while self._size > self._capacity and len(self._queue) > 1:
            first = 1 if self._started else 0  # a chunk that is sent in part is finished
            lost = self._queue[first]
            if lost is self._queue[-1]:
                break
            del self._queue[first]
            self._size -= len(lost)
            self.dropped += len(Parser().feed(lost)) or 1

    def _follow(self) -> None:
        """Adopts the baud rate of the device."""
        if self.link.baud != self._baud:
            self._baud = self.link.baud
            if self._baud and self._garble is None:
                self.peer.set_speed(self._baud)

    @property
    def _mismatch(self) -> bool:
        speed = self.peer.speed
        return speed is not None and self._baud is not None and speed != self._baud

    def send(self, now: float) -> float | None:
        """Writes as many bytes as possible.

        Returns when to continue: a time if the baud rate limits the data, infinity if nothing is left, None
        for as soon as the client has room. Raises OSError if the client is gone.
        """
        if self.peer.flushed():  # the queued bytes are as old as the discarded ones
            self._queue.clear()
            self._size = self._started = 0
        rate = self._baud / 10 * self._pace if self._baud else 0.0  # 8N1: ten bits for a byte
        while self._queue:
            chunk = memoryview(self._front())[self._started :]
            if rate:
                self._free = max(self._free, now - BURST)
                allowed = int((now - self._free) * rate)
                if allowed < 1:
                    return self._free + max(1 / rate, 0.001)
                chunk = chunk[:allowed]
            try:
                done = self.peer.write(chunk)
            except BlockingIOError:
                return None
            if rate:
                self._free += done / rate
            self._size -= done
            self._started += done
            while self._queue and self._started >= len(self._queue[0]):
                self._started -= len(self._queue.popleft())
        return math.inf

    def _front(self) -> bytes:
        """Returns the bytes to write next: the first chunk, and following ones while they are small."""
        if len(self._queue) == 1:
            return self._queue[0]
        front: list[bytes] = []
        size = 0
        for chunk in self._queue:
            size += len(chunk)
            if front and size > AT_ONCE:
                break
            front.append(chunk)
        return b"".join(front)

    def receive(self) -> bool:
        """Passes on the bytes that the client has sent; False if it has disconnected."""
        try:
            data = self.peer.read()
        except BlockingIOError:
            return True
        except OSError:
            return False
        if data and not self.link.closed:
            self.link.write(self._garble(data) if self._garble and self._mismatch else data)
        return bool(data)
