"""`mip stream --format foxglove`: what clients of Foxglove's protocol receive."""

from __future__ import annotations

import json
import signal
import socket
import struct
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise
from typing import Any

import jsonschema_rs
import pytest
from mip_tools.formats import foxglove
from program import PATIENCE, running, simulated, until
from support import heavy

NAMES = ("sensor.scaled_accel@100", "sensor.scaled_gyro@50", "reference_timestamp@100")


@contextmanager
def serving(*words: object) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """The URL of `mip stream` at a virtual device."""
    with (
        simulated() as place,
        running("stream", place, "--format", "foxglove", "--listen", "127.0.0.1:0", *words) as one,
    ):
        assert one.stderr is not None
        said = one.stderr.readline().decode()
        assert said.startswith("mip stream: open ws://127.0.0.1:") and said.endswith(" in Foxglove\n")
        yield said.split()[3], one


class Client:
    """A client that knows the protocol and nothing of MIP."""

    def __init__(self, line: Any) -> None:
        self.line = line
        self.info = self.said()
        self.channels: dict[str, dict[str, Any]] = {}

    def said(self) -> dict[str, Any]:
        message = self.line.recv(PATIENCE)
        assert isinstance(message, str), "no subscription"
        return dict(json.loads(message))

    def advertised(self, *topics: str) -> None:
        """Waits for channels."""
        while not self.channels.keys() >= set(topics):
            said = self.said()
            assert said["op"] == "advertise"
            self.channels |= {one["topic"]: one for one in said["channels"]}

    def ask(self, op: str, **more: Any) -> None:
        self.line.send(json.dumps({"op": op, **more}))

    def message(self) -> tuple[int, int, dict[str, Any]]:
        """Subscription, time and values."""
        while isinstance(data := self.line.recv(PATIENCE), str):
            pass
        op, subscription, moment = struct.unpack_from("<BIQ", data)
        assert op == 1
        return subscription, moment, json.loads(data[13:])


@contextmanager
def connected(url: str, protocol: str = "foxglove.websocket.v1") -> Iterator[Client]:
    from websockets.sync.client import connect

    with connect(url, subprotocols=[protocol]) as line:
        assert line.subprotocol == protocol
        yield Client(line)


@heavy("websockets")
def test_clients_get_what_they_ask_for() -> None:
    accel, gyro = "/mip/sensor/scaled_accel", "/mip/sensor/scaled_gyro"
    with serving(*NAMES) as (url, process), connected(url) as first, connected(url, "foxglove.sdk.v1") as second:
        assert first.info["op"] == "serverInfo" and first.info["capabilities"] == []
        first.advertised(accel, gyro)
        second.advertised(accel)
        channel = first.channels[accel]
        assert (channel["encoding"], channel["schemaEncoding"]) == ("json", "jsonschema")
        first.ask("subscribe", subscriptions=[{"id": 7, "channelId": channel["id"]}])
        messages = [first.message() for _ in range(20)]
        assert {number for number, *_ in messages} == {7}
        assert {b - a for (_, a, _), (_, b, _) in pairwise(messages)} == {10_000_000}  # in device time
        for *_, values in messages:
            jsonschema_rs.validate(json.loads(channel["schema"]), values)
            assert values["scaled_accel"].keys() == {"x", "y", "z"}
        first.ask("subscribe", subscriptions=[{"id": 8, "channelId": first.channels[gyro]["id"]}])
        first.ask("unsubscribe", subscriptionIds=[7])
        while first.message()[0] != 8:
            pass
        until(lambda: {first.message()[0] for _ in range(5)} == {8})
        second.ask("nothing")  # is for capabilities that the server does not have
        second.line.send("[]")
        from websockets.exceptions import ConnectionClosed

        with pytest.raises(ConnectionClosed) as closed:
            while True:
                second.line.recv(PATIENCE)
        assert closed.value.rcvd.code == 1008
        process.send_signal(signal.SIGINT)
        assert process.wait(PATIENCE) == 0
        assert process.stderr is not None and b"(at the port)" in process.stderr.read()


@heavy("websockets")
def test_only_pages_of_foxglove_may_connect() -> None:
    from websockets.exceptions import InvalidStatus
    from websockets.sync.client import connect

    with serving(*NAMES, "--origin", "https://own.example") as (url, _):
        for origin in ("https://app.foxglove.dev", "https://own.example", None):
            connect(url, origin=origin, subprotocols=["foxglove.sdk.v1"]).close()  # type: ignore[arg-type]
        other = url.replace("127.0.0.1", "evil.example")
        for place, origin in ((url, "https://evil.example"), (other, "https://app.foxglove.dev")):
            line = socket.create_connection(("127.0.0.1", int(url.rpartition(":")[2])))
            with pytest.raises(InvalidStatus) as rejected:
                connect(place, sock=line, origin=origin, subprotocols=["foxglove.sdk.v1"])  # type: ignore[arg-type]
            assert rejected.value.response.status_code == 403


def test_a_slow_client_loses_values_and_no_channels(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(foxglove._Client, "_write", lambda self: None)
    monkeypatch.setattr(foxglove, "_WAITING", 10)
    client = foxglove._Client(None)
    client.receive({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 5}]})
    client.put("channels")
    for i in range(25):
        client.message(5, i, b"{}")
    client.message(6, 0, b"not asked for")
    kept = [client._next() for _ in range(len(client._waiting))]
    assert kept[0] == "channels" and [struct.unpack_from("<BIQ", one)[2] for one in kept[1:]] == list(range(18, 25))
