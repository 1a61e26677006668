"""A server for Foxglove: sends the fields of a stream to clients as they arrive."""

from __future__ import annotations

import json
import struct
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from typing import Any

from ..errors import Failure, Misuse
from ..files.pages import FOXGLOVE, host_is_known, listening, origin_is_allowed
from ..names.occurrence import Occurrence
from .json_messages import Batch, Topic, timed

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
            channel = {"id": number, "topic": topic.name, "encoding": "json", "schemaName": topic.schema_name}
            self._channels.append(channel | {"schema": topic.schema, "schemaEncoding": "jsonschema"})
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
            for request in connection:
                if isinstance(request, str):
                    with self._lock:
                        client.receive(json.loads(request))
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

    def receive(self, message: dict[str, Any]) -> None:
        """Handles subscriptions; other requests are for capabilities that the server does not offer."""
        if message["op"] == "subscribe":
            self.subscribed |= {
                int(subscription["id"]): int(subscription["channelId"]) for subscription in message["subscriptions"]
            }
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
                self._waiting = deque(queued for queued in self._waiting if not isinstance(queued, bytes))
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
def serving(server: Server, place: str, origins: Sequence[str] = FOXGLOVE) -> Iterator[str]:
    """Accepts clients at HOST:PORT, in a browser only pages of these origins; yields its URL. Raises Failure."""
    host, _, port = place.rpartition(":")
    if not host or not port.isdigit():
        raise Misuse(f"'{place}' is not HOST:PORT; the default is {USUAL}")

    def rejection(request: Any) -> str | None:
        hosts, sites = request.headers.get_all("Host"), request.headers.get_all("Origin")
        host_fits = len(hosts) == 1 and len(sites) <= 1 and host_is_known(hosts[0], host)
        if host_fits and origin_is_allowed(next(iter(sites), None), origins):
            return None
        return "This page may not connect; mip stream --origin allows its origin."

    try:
        address = host.strip("[]"), int(port)
        listener = listening("foxglove", server.talk, address, rejection, subprotocols=PROTOCOLS)
    except (OSError, OverflowError) as error:
        raise Failure(f"{place} cannot be used: {getattr(error, 'strerror', None) or error}") from None
    with listener:
        threading.Thread(target=listener.serve_forever, daemon=True).start()
        try:
            yield f"ws://{host}:{listener.socket.getsockname()[1]}"
        finally:
            server.close()


def serve(
    server: Server, messages: Iterable[Batch], clock: str | None, topic_of: Callable[[Occurrence | None], Topic]
) -> None:
    """Serves messages until they end. Without a clock, they have the time of the host."""
    channels: dict[Occurrence | None, int] = {}
    for batch, moments in timed(messages, clock is None):
        for number, moment, data in zip(batch.kind.tolist(), moments.tolist(), batch.data):
            kind = batch.kinds[number]
            if kind not in channels:
                channels[kind] = server.channel(topic_of(kind))
            if server.wanted(channels[kind]):
                server.send(channels[kind], moment, data)
