"""The connection of a host to a port of the device: bytes in both directions, some of them
delayed."""

from __future__ import annotations

import heapq
from collections.abc import Callable

from mip_tools.binding import Parser
from mip_tools.rtcm import Frames


class Link:
    """The connection of one host to one port, made by `VirtualDevice.connect`. The host calls `write` and `read`.

    Time does not pass by itself, so it is not a port for `Device`; use a `LivePort` for that.
    """

    def __init__(self, port: str, receive: Callable[[Link, bytes], None], capacity: int | None) -> None:
        self.port = port
        self.baud: int | None = None  # None: the port has no baud rate
        self.takes = self.gives = ~0  # protocols of the port, as bits
        self.closed = False
        self.dropped = 0  # packets for which there was no room
        self.parser = Parser()
        self.rtcm = Frames()
        self.heard = 0  # when the host has last sent something
        self._late: list[tuple[int, int, bytes]] = []  # time, order, bytes on the way
        self._unsent: list[tuple[int, int, bytes]] = []  # the same, for bytes that the device has not sent yet
        self._receive = receive
        self._capacity = capacity
        self._ready = bytearray()
        self._order = 0

    def write(self, data: bytes) -> None:
        """Sends bytes from the host; the device acts at once."""
        if self.closed:
            raise ConnectionError(f"the device has closed the link to its port '{self.port}'; connect again")
        self._receive(self, bytes(data))

    def read(self) -> bytes:
        """Returns the bytes that have arrived since the last call."""
        data = bytes(self._ready)
        self._ready.clear()
        return data

    @property
    def waiting(self) -> int:
        """Bytes that the host has not read."""
        return len(self._ready)

    @property
    def on_the_way(self) -> bytes:
        """Returns the bytes that the device has sent and that have not arrived yet; on a slow port, they are many."""
        return b"".join(data for _, _, data in sorted(self._late))

    @property
    def next(self) -> int | None:
        """Returns the next time at which delayed bytes arrive or are sent."""
        return min((queue[0][0] for queue in (self._late, self._unsent) if queue), default=None)

    def reply_delay(self, now: int) -> int:
        """Returns the time that the device needs to send everything before its next reply."""
        return max((time - now for time, _, _ in self._unsent), default=0)

    def hold(self, time: int, data: bytes) -> None:
        """Stores bytes that the device sends at this time."""
        self._order += 1
        heapq.heappush(self._unsent, (time, self._order, data))

    def due(self, now: int) -> list[bytes]:
        """Returns the stored bytes that the device sends by now."""
        due = []
        while self._unsent and self._unsent[0][0] <= now:
            due.append(heapq.heappop(self._unsent)[2])
        return due

    def send(self, now: int, parts: list[tuple[int, bytes]]) -> None:
        """Sends parts from the device, each after a delay in nanoseconds. Drops all of them if there is no room."""
        size = sum(len(data) for _, data in parts)
        if self.closed or (self._capacity is not None and self.waiting + size > self._capacity):
            self.dropped += 1
            return
        for delay, data in parts:
            if delay <= 0:
                self._ready += data
            else:
                self._order += 1
                heapq.heappush(self._late, (now + delay, self._order, data))

    def arrive(self, now: int) -> None:
        """Delivers the delayed bytes that are due."""
        while self._late and self._late[0][0] <= now:
            self._ready += heapq.heappop(self._late)[2]

    def clear(self) -> None:
        """Discards the bytes that the device has not sent yet, as in a reset; bytes in transit still arrive."""
        self._unsent.clear()
        self.parser = Parser()
