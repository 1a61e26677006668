"""A server for Foxglove: sends the fields of a stream to clients as they arrive."""

from __future__ import annotations

import json
import logging
import struct
import threading
import time
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from itertools import chain
from typing import Any

from ..binding import MissingExtra
from ..errors import Failure, Misuse
from ..occurrence import Occurrence
from .export_mcap import Topic, encoded, timed
from .samples import Sample

#: The WebSocket subprotocols that clients request.
PROTOCOLS = ["foxglove.websocket.v1", "foxglove.sdk.v1"]
#: The address at which Foxglove expects a server.
USUAL = "127.0.0.1:8765"
#: The number of messages that may wait for a slow client; one more, and all that wait are dropped.
_WAITING = 4096
_DATA = struct.Struct("<BIQ")


class Server:
    """Advertises channels, and sends clients the messages to which they have subscribed."""

    def __init__(self, name: str) -> None:
        session = str(time.time_ns())
        self._hello = {"op": "serverInfo", "name": name, "capabilities": [], "metadata": {}, "sessionId": session}
        self._lock = threading.Lock()
        self._channels: list[dict[str, Any]] = []
        self._clients: list[_Client] = []

    def channel(self, topic: Topic) -> int:
        """Adds a channel, and returns its number."""
        with self._lock:
            number = len(self._channels) + 1
            said = {"id": number, "topic": topic.name, "encoding": "json", "schemaName": topic.schema_name}
            self._channels.append(said | {"schema": topic.schema, "schemaEncoding": "jsonschema"})
            for client in self._clients:
                client.put(_advertised(self._channels[-1:]))
            return number

    def send(self, channel: int, moment: int, data: bytes) -> None:
        """Sends a message to the clients that have subscribed to its channel."""
        with self._lock:
            for client in self._clients:
                client.message(channel, moment, data)

    def wanted(self, channel: int) -> bool:
        """Has any client subscribed to it?"""
        with self._lock:
            return any(channel in client.subscribed.values() for client in self._clients)

    def close(self) -> None:
        """Sends the queued messages, and disconnects all clients."""
        with self._lock:
            for client in self._clients:
                client.end()

    def talk(self, connection: Any) -> None:
        """Serves one client until it leaves."""
        client = _Client(connection)
        with self._lock:
            client.put(json.dumps(self._hello))
            client.put(_advertised(self._channels))
            self._clients.append(client)
        closed = import_module("websockets.exceptions").ConnectionClosed
        try:
            for said in connection:
                if isinstance(said, str):
                    with self._lock:
                        client.said(json.loads(said))
        except (ValueError, KeyError, TypeError):
            connection.close(1008, "not a message of the protocol")
        except closed:  # without a closing handshake
            pass
        finally:
            with self._lock:
                self._clients.remove(client)
            client.end()


class _Client:
    """The subscriptions of one client, and the messages that wait for it."""

    def __init__(self, connection: Any) -> None:
        self._connection = connection
        self.subscribed: dict[int, int] = {}  # the client's number of a subscription -> channel
        self._waiting: deque[str | bytes | None] = deque()
        self._some = threading.Condition()
        threading.Thread(target=self._write, daemon=True).start()

    def said(self, message: dict[str, Any]) -> None:
        """Handles subscriptions; other requests are for capabilities that the server does not offer."""
        if message["op"] == "subscribe":
            self.subscribed |= {int(one["id"]): int(one["channelId"]) for one in message["subscriptions"]}
        elif message["op"] == "unsubscribe":
            for number in message["subscriptionIds"]:
                self.subscribed.pop(number, None)

    def message(self, channel: int, moment: int, data: bytes) -> None:
        for number, wanted in self.subscribed.items():
            if wanted == channel:
                self.put(_DATA.pack(1, number, moment) + data)

    def put(self, item: str | bytes | None) -> None:
        """Queues a message; None ends the queue."""
        with self._some:
            if len(self._waiting) >= _WAITING:
                self._waiting = deque(one for one in self._waiting if not isinstance(one, bytes))
            self._waiting.append(item)
            self._some.notify()

    def end(self) -> None:
        """Ends the connection after the queued messages."""
        self.put(None)

    def _write(self) -> None:
        closed = import_module("websockets.exceptions").ConnectionClosed
        try:
            while (item := self._next()) is not None:
                self._connection.send(item)
            self._connection.close()
        except closed:
            pass

    def _next(self) -> str | bytes | None:
        with self._some:
            self._some.wait_for(lambda: self._waiting)
            return self._waiting.popleft()


def _advertised(channels: list[dict[str, Any]]) -> str:
    return json.dumps({"op": "advertise", "channels": channels})


@contextmanager
def serving(server: Server, place: str) -> Iterator[str]:
    """Accepts clients at HOST:PORT; yields its URL. Raises Failure."""
    host, _, port = place.rpartition(":")
    if not host or not port.isdigit():
        raise Misuse(f"'{place}' is not HOST:PORT; the default is {USUAL}")
    try:
        serve = import_module("websockets.sync.server").serve
    except ImportError:
        raise Failure(str(MissingExtra("websockets", "foxglove"))) from None
    try:
        quiet = logging.getLogger(__name__)
        quiet.addHandler(logging.NullHandler())
        quiet.propagate = False
        listening = serve(server.talk, host.strip("[]"), int(port), subprotocols=PROTOCOLS, logger=quiet)
    except (OSError, OverflowError) as error:
        raise Failure(f"{place} cannot be used: {getattr(error, 'strerror', None) or error}") from None
    with listening:
        threading.Thread(target=listening.serve_forever, daemon=True).start()
        try:
            yield f"ws://{host}:{listening.socket.getsockname()[1]}"
        finally:
            server.close()


def write(server: Server, packets: Iterator[list[Sample]], clock: str | None, named: bool) -> None:
    """Serves samples until they end. Without a clock, they have the time of the host."""
    channels: dict[Occurrence, int] = {}
    for sample, moment in timed(chain.from_iterable(packets), clock is None):
        kind = sample.kind
        if kind not in channels:
            channels[kind] = server.channel(Topic.of(kind, named))
        if server.wanted(channels[kind]):
            server.send(channels[kind], moment, encoded(sample.value, named))


__all__ = ["PROTOCOLS", "USUAL", "Server", "serving", "write"]
