"""Serves devices to programs outside this one, in real time or in simulated time."""

from __future__ import annotations

import math
import os
import selectors
import socket
import time
from collections.abc import Callable, Iterable
from typing import Any, Protocol

from .channel import CAPACITY, Channel, Link, Peer
from .endpoint import Endpoint, Listener, Pty, Udp, scrambler

SECOND = 1_000_000_000
#: Real seconds for which the device may be advanced before clients are served again.
TURN = 0.02
#: Real seconds by which simulated time may be late before it stops catching up, and for which clients may read the
#: remaining data at the end.
LATE = 1.0
#: Real seconds by which data may be late, so that it is sent in fewer pieces at high rates.
GRAIN = 0.004

#: Simulated nanoseconds after which the data sent by the device is collected.
SLICE = SECOND // 100
#: The maximum number of clients of one TCP port.
CLIENTS = 64


class Device(Protocol):
    """The device that is served: see `VirtualDevice`."""

    @property
    def now(self) -> int: ...
    @property
    def next(self) -> int | None: ...
    @property
    def busy(self) -> bool: ...
    @property
    def plugged(self) -> bool: ...
    def advance(self, seconds: float) -> None: ...
    def connect(self, port: str | None = None) -> Any: ...  # a `channel.Link`
    def disconnect(self, link: Any) -> None: ...


class Server:
    """A device at its endpoints. Use it in a `with` statement, which opens and closes them."""

    def __init__(
        self,
        device: Device,
        endpoints: Iterable[Endpoint],
        speed: float = 1.0,
        *,
        clock: Callable[[], float] = time.monotonic,
        duration: float | None = None,
        strict_baud: bool = False,
        seed: int = 0,
        capacity: int = CAPACITY,
        ready: Callable[[str], None] = lambda text: None,
        complain: Callable[[str], None] = lambda text: None,
    ) -> None:
        """`speed`: simulated seconds per real second; 0: as fast as clients read the data, and in real time while
        the device sends nothing.

        `duration`: simulated seconds until `run` returns. `ready` is called with each endpoint.
        """
        self._device = device
        self._endpoints = tuple(endpoints)
        self._speed = speed
        self._clock = clock
        self._end = math.inf if duration is None else self._device.now + round(duration * SECOND)
        self._garble = scrambler(seed) if strict_baud else None
        self._pace = speed if strict_baud else 0.0
        self._capacity = capacity
        self._ready = ready
        self._complain = complain
        self._selector = selectors.DefaultSelector()
        self._listeners: dict[Endpoint, Listener] = {}
        self._channels: dict[Channel, Endpoint] = {}
        self._plugged: set[Endpoint] = set()
        self._numbers: dict[Endpoint, int] = {}  # port numbers that the system chose
        self._stopped = False
        self._lost = 0.0  # real seconds that simulated time has not caught up
        self._origin = 0.0
        self._wake, self._woken = socket.socketpair()

    # ----------------------------------------------------------------- open and close

    def __enter__(self) -> Server:
        """Opens all endpoints, or none. Raises Failure."""
        self._wake.setblocking(False)
        self._selector.register(self._woken, selectors.EVENT_READ, self._wakened)
        try:
            for endpoint in self._endpoints:
                self._open(endpoint)
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _open(self, endpoint: Endpoint) -> None:
        self._plugged.add(endpoint)
        number = self._numbers.get(endpoint, endpoint.number)
        if endpoint.kind == "tcp":
            listener = Listener(endpoint.host, number)
            self._listeners[endpoint] = listener
            self._numbers[endpoint] = listener.number
            self._selector.register(listener, selectors.EVENT_READ, lambda _: self._accept(listener, endpoint))
            self._ready(str(listener))
            return
        peer: Pty | Udp
        if endpoint.kind == "pty":
            peer = Pty(endpoint.path)
        else:
            peer = Udp(endpoint.host, number)
            self._numbers[endpoint] = peer.number
        self._add(peer, endpoint)
        self._ready(str(peer))

    def _plug(self) -> None:
        """Closes the ports of an unplugged device, and opens them when it is plugged in again."""
        for endpoint in self._endpoints:
            plugged = self._device.plugged
            if plugged and endpoint not in self._plugged:
                for channel in [c for c, e in self._channels.items() if e is endpoint]:
                    self._remove(channel, again=False)
                self._open(endpoint)
            elif not plugged and endpoint in self._plugged:
                self._plugged.remove(endpoint)
                listener = self._listeners.pop(endpoint, None)
                if listener is not None:
                    self._selector.unregister(listener)
                    listener.close()

    def _accept(self, listener: Listener, endpoint: Endpoint) -> None:
        client = listener.accept()
        if client is None:
            return
        if sum(e is endpoint for e in self._channels.values()) >= CLIENTS:
            self._complain(f"{client} is turned away: {CLIENTS} clients are connected")
            client.close()
            return
        self._add(client, endpoint)

    def _add(self, peer: Peer, endpoint: Endpoint) -> None:
        link: Link = self._device.connect(endpoint.port)
        channel = Channel(peer, link, self._garble, self._pace, self._capacity)
        self._channels[channel] = endpoint
        self._selector.register(peer, selectors.EVENT_READ, lambda events: self._serve(channel, events))

    def _remove(self, channel: Channel, again: bool = True) -> None:
        endpoint = self._channels.pop(channel, None)
        if endpoint is None:
            return
        self._selector.unregister(channel.peer)
        if channel.dropped:
            # There may be no client: the simulator cannot tell whether a terminal is open.
            packets = f"{channel.dropped} packet{'s' * (channel.dropped != 1)}"
            self._complain(f"{channel.peer}: {packets} dropped, as no client read them in time")
        self._device.disconnect(channel.link)
        channel.peer.close()
        if again and endpoint.kind != "tcp" and self._device.plugged:  # the same path leads to a new terminal
            self._open(endpoint)

    def close(self) -> None:
        """Closes all connections and removes the links to terminals."""
        for channel in list(self._channels):
            self._remove(channel, again=False)
        for listener in self._listeners.values():
            listener.close()
        self._listeners.clear()
        self._selector.close()
        self._wake.close()
        self._woken.close()

    def stop(self) -> None:
        """Makes `run` return soon; for signal handlers and other threads."""
        self._stopped = True
        try:
            self._wake.send(b"\0")
        except OSError:  # already awake, or closed
            pass

    def _wakened(self, _: int) -> None:
        self._woken.recv(64)

    # ----------------------------------------------------------------- time

    def run(self) -> None:
        """Serves until `stop` or the end of the duration."""
        self._origin = self._clock() - self._simulated(self._device.now)
        while not self._stopped and self._device.now < self._end:
            self._advance()
            for key, events in self._selector.select(self._patience()):
                key.data(events)
        if self._lost:
            self._complain(f"simulated time ends {self._lost:.1f} s late")
        self._drain()

    def _simulated(self, nanoseconds: float) -> float:
        """Converts simulated nanoseconds to real seconds."""
        return nanoseconds / SECOND / (self._speed or 1.0)

    @property
    def _free(self) -> bool:
        """Does simulated time pass as fast as clients read?"""
        return not self._speed and self._device.busy

    def _target(self) -> float:
        """Returns the simulated time that the device should have now."""
        if self._free:
            return self._end if self._hungry() else self._device.now
        target = int((self._clock() - self._origin) * (self._speed or 1.0) * SECOND)
        return min(target, self._end)

    def _hungry(self) -> bool:
        """Can every client receive more? Without clients, time does not pass."""
        return bool(self._channels) and all(c.size < self._capacity // 2 for c in self._channels)

    def _advance(self) -> None:
        """Advances the devices to the present, and passes their data to the clients."""
        device, turn = self._device, self._clock() + TURN
        target = self._target()
        while self._clock() < turn:
            now, following = device.now, device.next
            if following is None or following > target:
                device.advance(max(target - now, 0) / SECOND if target < math.inf else 0.0)
                break
            if self._free:
                device.advance(max(following - now, 1) / SECOND)
                self._origin = self._clock() - self._simulated(device.now)
                self._pump()
                target = self._target()
            else:  # everything that is due by now, in pieces
                until = min(target, max(following, now + SLICE))
                device.advance(max(until - now, 1) / SECOND)
                for channel in self._channels:
                    channel.collect()
        self._plug()
        self._pump()
        self._slip()

    def _slip(self) -> None:
        """Skips time that cannot be caught up, because the machine was asleep or is too slow."""
        behind = self._clock() - self._origin - self._simulated(self._device.now)
        if self._free:
            self._origin += behind
        elif behind > LATE and self._device.now < self._end:
            self._origin += behind
            if not self._lost:
                self._complain("the machine cannot keep up; simulated time is late from here on")
            self._lost += behind

    def _patience(self) -> float | None:
        """Returns how long to wait for clients; None: until one connects."""
        if self._stopped:
            return 0.0
        waits = [c.waits for c in self._channels if c.waits is not None]
        now = self._clock()
        if not self._free:
            then = min(self._end, math.inf if self._device.next is None else self._device.next)
            waits += [self._origin + self._simulated(then)]
        elif self._hungry():
            return 0.0
        first = min(waits, default=math.inf)
        if os.name != "posix":  # on other systems, a signal does not end the wait
            first = min(first, now + 0.5)
        return None if first == math.inf else min(max(first - now, GRAIN), 3600.0)

    # ----------------------------------------------------------------- clients

    def _pump(self) -> None:
        for channel in list(self._channels):
            channel.collect()
            self._write(channel)

    def _write(self, channel: Channel) -> None:
        try:
            channel.waits = channel.send(self._clock())
        except OSError:
            self._remove(channel)
            return
        if channel.link.closed and self._read_out(channel):
            self._remove(channel)
            return
        wanted = selectors.EVENT_READ
        if channel.waits is None:
            wanted |= selectors.EVENT_WRITE
        if wanted != channel.wanted:
            channel.wanted = wanted
            self._selector.modify(channel.peer, wanted, self._selector.get_key(channel.peer).data)

    def _read_out(self, channel: Channel) -> bool:
        """Has the client read all data sent before the link was closed, or has its time to do so run out?"""
        now = self._clock()
        channel.until = channel.until or now + LATE
        if now < channel.until and (channel.size or channel.peer.unread):
            channel.waits = now + 0.005
            return False
        return True

    def _serve(self, channel: Channel, events: int) -> None:
        if channel not in self._channels:
            return
        if events & selectors.EVENT_READ:
            self._advance()
            if channel in self._channels and not channel.receive():
                self._remove(channel)

    def _drain(self) -> None:
        """Gives clients a moment to read the remaining data."""
        until = self._clock() + LATE
        while not self._stopped and self._clock() < until:
            if not any(c.size or c.peer.unread for c in self._channels):
                return
            self._pump()
            for key, events in self._selector.select(0.01):
                key.data(events)
