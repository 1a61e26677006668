"""`mip serve`: a device for pages that know the token, and for nobody else."""

from __future__ import annotations

import argparse
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from mip_protocol import base
from mip_simulator import LivePort, VirtualDevice
from mip_tools.errors import Failure
from mip_tools.files import pages
from mip_tools.files.pages import CONNECTIONS
from mip_tools.web.server import Server
from program import DEVICE, PATIENCE, running, simulated, until

PING_COMMAND = bytes(base.Ping().packet())
ACKNOWLEDGE = bytes.fromhex("7565010404f10100d56a")
KEY = "dGhlIHNhbXBsZSBub25jZQ=="
TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


def masked(kind: int, data: bytes = b"", final: bool = True, mask: bytes = b"\1\2\3\4") -> bytes:
    """A frame of a client."""
    size = len(data)
    head = bytes((0x80 * final | kind, 0x80 | size if size < 126 else 0x80 | 126))
    head += size.to_bytes(2, "big") if size >= 126 else b""
    return head + mask + bytes(x ^ mask[i % 4] for i, x in enumerate(data))


class Page:
    """The connection of a page in a browser."""

    def __init__(
        self,
        server: Any,
        path: str,
        host: str = "",
        key: str = KEY,
        method: str = "GET",
        protocol: str = "websocket",
    ) -> None:
        self.socket = socket.create_connection(("127.0.0.1", server.number), PATIENCE)
        own = host or f"127.0.0.1:{server.number}"
        lines = [f"{method} {path} HTTP/1.1", f"Host: {own}", "Origin: https://else.where"]
        lines += [f"Upgrade: {protocol}", "Connection: Upgrade", "Sec-WebSocket-Version: 13"]
        lines += [f"Sec-WebSocket-Key: {key}"] if key else []
        self.socket.sendall("\r\n".join([*lines, "", ""]).encode())
        self.held = b""
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            head += self.socket.recv(1)
        self.status = head.split()[1].decode()
        self.head = head.decode()

    def send(self, *frames: bytes) -> None:
        self.socket.sendall(b"".join(frames))

    def message(self) -> tuple[int, bytes]:
        """The next message of the server, which are short."""
        head = self.exactly(2)
        size = head[1] if head[1] < 126 else int.from_bytes(self.exactly(2), "big")
        return head[0] & 0x0F, self.exactly(size)

    def exactly(self, size: int) -> bytes:
        found = b""
        while len(found) < size:
            data = self.socket.recv(size - len(found))
            assert data, "the server has closed the connection"
            found += data
        return found

    def receive(self, wanted: bytes) -> None:
        found = b""
        while wanted not in found:
            kind, data = self.message()
            assert kind == BINARY, (kind, data)
            found += data

    def ping(self) -> None:
        self.send(masked(BINARY, PING_COMMAND))
        self.receive(ACKNOWLEDGE)

    def close(self) -> None:
        self.socket.close()


@contextmanager
def serving(opened: Callable[[], Any] | None = None, **options: Any) -> Iterator[Any]:
    device = VirtualDevice(DEVICE)
    said: list[str] = []
    with Server(opened or (lambda: LivePort(device)), say=said.append, **options) as server:
        thread = threading.Thread(target=server.run, daemon=True)
        thread.start()
        server.said = said  # type: ignore[attr-defined]
        yield server
    thread.join(PATIENCE)
    assert not thread.is_alive()


def test_a_page_that_knows_the_token_uses_the_device() -> None:
    with serving() as server:
        page = Page(server, f"/{server.token}")
        assert page.status == "101" and "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=" in page.head
        page.ping()
        page.send(masked(BINARY, PING_COMMAND[:3], final=False), masked(PING, b"x"), masked(0, PING_COMMAND[3:]))
        assert page.message() == (PONG, b"x")
        page.receive(ACKNOWLEDGE)
        page.send(masked(TEXT, b"no bytes of the port"), masked(CLOSE, b"\x03\xe8"))
        assert page.message() == (CLOSE, b"\x03\xe8")
        page.close()


@pytest.mark.parametrize(
    ("path", "host", "status", "more"),
    [
        ("/", "", "403", {}),
        ("/guess", "", "403", {}),
        ("/\u00ff", "", "403", {}),  # bytes beyond ASCII
        ("/{token}x", "", "403", {}),
        ("/{token}", "evil.example:{number}", "403", {}),  # a name that was made to lead here
        ("/{token}", "evil.example", "403", {}),
        ("/{token}", "", "426", {"protocol": "h2c"}),
        ("/{token}", "", "400", {"key": ""}),
        ("/{token}", "localhost:{number}", "101", {}),
    ],
)
def test_nobody_else_does(path: str, host: str, status: str, more: dict[str, str]) -> None:
    opened: list[Any] = []
    device = VirtualDevice(DEVICE)

    def open_port() -> LivePort:
        opened.append(device)
        return LivePort(device)

    with serving(open_port) as server:
        known = {"token": server.token, "number": server.number}
        page = Page(server, path.format(**known), host.format(**known), **{"key": KEY, **more})
        assert page.status == status
        if status == "101":
            page.ping()
        else:
            while page.socket.recv(4096):  # the reason, in words
                pass
            assert opened == []
            assert server.token not in "".join(server.said)
        page.close()


def test_it_listens_on_this_machine_only_and_each_token_is_new() -> None:
    with serving() as one, serving() as other:
        assert one._listening.socket.getsockname()[0] == "127.0.0.1"
        assert one.token != other.token and len(one.token) >= 20
        with pytest.raises(Failure, match=f"TCP port {one.number} cannot be used"):
            Server(lambda: None, one.number)


@pytest.mark.parametrize(
    ("header", "own", "known"),
    [
        ("127.0.0.1:8765", "127.0.0.1", True), ("localhost:8765", "127.0.0.1", True), ("[::1]:80", "127.0.0.1", True),
        ("robot.lan:8765", "robot.lan", True), ("192.168.1.2:8765", "0.0.0.0", True), ("LOCALHOST", "127.0.0.1", True),
        ("evil.example:8765", "127.0.0.1", False), ("127.0.0.1.evil.example", "127.0.0.1", False),
        ("", "0.0.0.0", False),
    ],
)  # fmt: skip
def test_hosts(header: str, own: str, known: bool) -> None:
    assert pages.host_is_known(header, own) == known


@pytest.mark.parametrize(
    ("origin", "allowed"),
    [
        (None, True), ("https://app.foxglove.dev", True), ("file://", True), ("https://own.example", True),
        ("https://evil.example", False), ("https://app.foxglove.dev.evil.example", False), ("null", False), ("", False),
    ],
)  # fmt: skip
def test_origins(origin: str | None, allowed: bool) -> None:
    assert pages.origin_is_allowed(origin, (*pages.FOXGLOVE, "https://own.example")) == allowed
    assert pages.origin_is_allowed(origin, ["*"])


def test_an_origin_cannot_write_to_the_terminal() -> None:
    with serving() as server:
        request = "GET /wrong HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: Upgrade\r\nOrigin: \x9b31mowned\r\n\r\n"
        with socket.create_connection(("127.0.0.1", server.number), PATIENCE) as client:
            client.sendall(request.encode("latin-1"))
            assert client.recv(100).startswith(b"HTTP/1.1 403")
        assert until(lambda: server.said)
        assert "\x9b" not in server.said[0] and "owned" in server.said[0]


def test_slow_and_many_clients_do_not_hold_the_server(monkeypatch: pytest.MonkeyPatch) -> None:
    """A request that never ends is given up after one deadline, whatever it sends meanwhile."""
    monkeypatch.setattr("mip_tools.files.pages.PATIENCE", 0.5)
    with serving() as server:
        slow = [socket.create_connection(("127.0.0.1", server.number), PATIENCE) for _ in range(CONNECTIONS)]
        for client in slow:
            client.sendall(b"GET / HTTP/1.1\r\n")
        with socket.create_connection(("127.0.0.1", server.number), PATIENCE) as next_one:
            assert next_one.recv(100).startswith(b"HTTP/1.1 503")
        begin = time.monotonic()
        while slow:
            assert time.monotonic() - begin < PATIENCE
            for client in list(slow):
                try:
                    client.sendall(b"X")
                except OSError:
                    slow.remove(client)
            time.sleep(0.05)

        def is_served() -> bool:
            page = Page(server, f"/{server.token}")
            page.close()
            return page.status == "101"

        assert until(is_served)


def test_one_page_at_a_time() -> None:
    with serving() as server:
        first = Page(server, f"/{server.token}")
        first.ping()
        second = Page(server, f"/{server.token}")
        kind, data = second.message()
        assert kind == CLOSE and data[2:] == b"another page is connected; disconnect it first"
        first.close()
        second.close()
        until(lambda: not server._taken.locked())  # until the first has left
        third = Page(server, f"/{server.token}")
        third.ping()
        third.close()


def test_a_port_that_is_lost_or_cannot_be_opened_is_reported_to_the_page() -> None:
    device = VirtualDevice(DEVICE)
    ports: list[LivePort] = []

    def open_port() -> LivePort:
        if ports:
            raise Failure("it is gone")
        ports.append(LivePort(device))
        return ports[0]

    with serving(open_port) as server:
        page = Page(server, f"/{server.token}")
        page.ping()
        ports[0].close()
        kind, data = page.message()
        assert kind == CLOSE and data[2:].startswith(b"the port is lost: ")
        page.close()
        until(lambda: not server._taken.locked())
        page = Page(server, f"/{server.token}")
        assert page.message() == (CLOSE, b"\x03\xf5it is gone")
        page.close()


@pytest.mark.parametrize("ending", ["the server", "the port"])
def test_a_page_that_is_sending_reads_why_it_ends(ending: str) -> None:
    """Its data would reset a connection that is closed at once, and the reason would be lost."""
    ports: list[LivePort] = []

    def open_port() -> LivePort:
        ports.append(LivePort(VirtualDevice(DEVICE)))
        return ports[0]

    with serving(open_port) as server:
        page = Page(server, f"/{server.token}")
        page.ping()
        (server.stop if ending == "the server" else ports[0].close)()
        for _ in range(5):
            page.send(masked(BINARY, PING_COMMAND))
            time.sleep(0.05)
        while (message := page.message())[0] != CLOSE:
            pass
        assert message[1][2:].startswith(b"mip serve has ended" if ending == "the server" else b"the port is lost")
        page.send(masked(CLOSE, message[1][:2]))
        assert page.socket.recv(1) == b""
        page.close()


def test_a_page_that_never_closes_its_end_is_cut_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mip_tools.files.pages.PATIENCE", 0.2)
    with serving() as server:
        page = Page(server, f"/{server.token}")
        page.ping()
    while page.message()[0] != CLOSE:
        pass
    assert page.socket.recv(1) == b""
    page.close()


def test_the_command() -> None:
    """Serves a port, here a virtual device over TCP; its first line is the address."""
    with simulated() as place, running("serve", place) as process:
        assert process.stdout is not None
        address = process.stdout.readline().decode().strip()
        assert address.startswith("ws://127.0.0.1:")
        number, _, token = address.rpartition(":")[2].partition("/")

        page = Page(argparse.Namespace(number=int(number)), f"/{token}")
        page.ping()
        process.terminate()
        while (message := page.message())[0] != CLOSE:
            pass
        assert message[1][2:] == b"mip serve has ended"
        page.close()
        assert process.wait(PATIENCE) == 0
