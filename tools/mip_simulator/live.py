"""A port of a virtual device on which simulated time passes automatically."""

from __future__ import annotations

import threading
import time

from mip_tools.binding import READ_TIMEOUT
from mip_tools.geometry.earth import SECOND

from .device import VirtualDevice

#: The longest real time, in seconds, that is caught up at once; more is lost, for example in a debugger.
LATE = 1.0


class LivePort:
    """A port that `Device` and `aio.Device` of this package accept, without a file or a network.

        with Device(LivePort(VirtualDevice("3dm-cv7-gnss-ins"))) as device:
            device.request(Ping())

    While the port is open, other threads use the virtual device: do not use it directly. A virtual device can have
    only one such port at a time.
    """

    def __init__(self, device: VirtualDevice, port: str | None = None, *, speed: float = 1.0) -> None:
        """`port`: the name of the port, as for `VirtualDevice.connect`. `speed`: simulated seconds per real second."""
        if not 0 < speed < float("inf"):
            raise ValueError(f"speed {speed}: simulated seconds per real second must be above 0")
        self._device = device
        self._speed = speed
        self._link = device.connect(port)
        self._wake = threading.Condition()  # the device and its link are used by one thread at a time
        self._now = time.monotonic()
        self._rest = b""

    def read(self, size: int) -> bytes:
        """Returns the bytes that the device has sent; empty after a short wait. Raises ConnectionError if the port is
        closed."""
        with self._wake:
            self._pass()
            if not self._rest:
                self._wake.wait(self._pause())
                self._pass()
            if self._link.closed and not self._rest:
                raise ConnectionError(f"port '{self._link.port}' of the device is closed")
            data, self._rest = self._rest[:size], self._rest[size:]
        return data

    def write(self, data: bytes) -> int:
        with self._wake:
            self._pass()
            self._link.write(data)
            self._wake.notify()
        return len(data)

    def close(self) -> None:
        with self._wake:
            self._device.disconnect(self._link)
            self._wake.notify()

    def _pass(self) -> None:
        """Advances the device to the present, and reads the bytes that it has sent."""
        now = time.monotonic()
        self._device.advance(min(now - self._now, LATE) * self._speed)
        self._now = now
        self._rest += self._link.read()

    def _pause(self) -> float:
        """Returns the time until the next known event."""
        then = self._device.next
        if then is None:
            return READ_TIMEOUT
        return min(max(then - self._device.now, 0) / SECOND / self._speed, READ_TIMEOUT)
