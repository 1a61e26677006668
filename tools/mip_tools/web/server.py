"""Serves a device to pages in a browser: WebSocket on this machine, for pages that know the token."""

from __future__ import annotations

import hmac
import re
import secrets
import selectors
import socket
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Protocol

from ..errors import Failure
from .frames import BINARY, CLOSE, GOING, NORMAL, PING, PONG, TRY_AGAIN, Frames, Wrong, accept_key, closing, frame

HOST = "127.0.0.1"
#: Seconds within which a browser must send its request, read sent data, and close its end.
PATIENCE = 5.0
#: The maximum size of a request in bytes, far above what browsers send.
_LONGEST = 16384
_AT_ONCE = 4096
_HEADER = re.compile(r"([^:\s]+):\s*(.*?)\s*$")


class Port(Protocol):
    """A port to serve: one that `mip_protocol` opens, or a `LivePort`."""

    def read(self, size: int, /) -> bytes | None: ...
    def write(self, data: bytes, /) -> int | None: ...
    def close(self) -> None: ...


class Refused(Exception):
    """A request that is rejected with this HTTP status."""


class Server:
    """Serves a port to one page at a time. Use it in a `with` statement, and call `run`."""

    def __init__(
        self,
        open_port: Callable[[], Any],
        number: int = 0,
        *,
        token: str | None = None,
        say: Callable[[str], None] = lambda text: None,
    ) -> None:
        """`open_port` opens the port for each page. Raises Failure if TCP port `number` cannot be used."""
        self._open_port = open_port
        self._say = say
        self.token = token or secrets.token_urlsafe(16)
        self._taken = threading.Lock()
        self._stopped = False
        self._pages: set[Connection] = set()
        self._listener = socket.socket()
        try:
            self._listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            self._listener.bind((HOST, number))
            self._listener.listen()
        except OSError as error:
            self._listener.close()
            raise Failure(f"TCP port {number} cannot be used: {error.strerror}; name another one with --tcp") from None

    @property
    def number(self) -> int:
        return int(self._listener.getsockname()[1])

    @property
    def address(self) -> str:
        """The address to which a page connects."""
        return f"ws://{HOST}:{self.number}/{self.token}"

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        """Stops, and waits until the pages have read the reason."""
        self.stop()
        end = time.monotonic() + PATIENCE
        for page in list(self._pages):
            if not page.left.wait(max(0, end - time.monotonic())):
                page.cut()

    def run(self) -> None:
        """Serves until `stop`."""
        while not self._stopped:
            try:
                client, _ = self._listener.accept()
            except OSError:
                return
            threading.Thread(target=self._serve, args=(client,), daemon=True).start()

    def stop(self) -> None:
        """Makes `run` return; for signal handlers and other threads."""
        self._stopped = True
        with suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        for page in list(self._pages):
            with suppress(OSError):
                page.end(closing(GOING, "mip serve has ended"))

    def _serve(self, client: socket.socket) -> None:
        with client:
            client.settimeout(PATIENCE)
            client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            try:
                key = self._key(_request(client))
            except Refused as refused:
                with suppress(OSError):
                    client.sendall(f"HTTP/1.1 {refused}\r\nConnection: close\r\nContent-Length: 0\r\n\r\n".encode())
                return
            except OSError:
                return
            with suppress(OSError):
                client.sendall(
                    "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                    f"Sec-WebSocket-Accept: {accept_key(key)}\r\n\r\n".encode()
                )
                page = Connection(client)
                self._pages.add(page)
                try:
                    page.end(self._talk(page))
                    page.drain()
                finally:
                    self._pages.discard(page)
                    page.left.set()

    def _key(self, lines: list[str]) -> str:
        """Returns the key of a handshake by a page that knows the token. Raises Refused."""
        method, _, rest = lines[0].partition(" ")
        path = rest.rpartition(" ")[0]
        headers = {m[1].lower(): m[2] for m in map(_HEADER.fullmatch, lines[1:]) if m}
        # A page of another site whose name was made to resolve to this machine (DNS rebinding) sends that name.
        host = headers.get("host", "")
        if host not in (f"{HOST}:{self.number}", f"localhost:{self.number}"):
            raise Refused("403 Forbidden")
        if not hmac.compare_digest(path.encode(), f"/{self.token}".encode()):
            self._say(f"a page of {headers.get('origin', 'unknown origin')} was rejected: it does not know the token")
            raise Refused("403 Forbidden")
        key = headers.get("sec-websocket-key", "")
        if method != "GET" or headers.get("upgrade", "").lower() != "websocket" or not key:
            raise Refused("426 Upgrade Required")
        return key

    def _talk(self, page: Connection) -> bytes:
        """Passes bytes on in both directions. Returns the last message, which states why the connection ends."""
        if not self._taken.acquire(blocking=False):
            return closing(TRY_AGAIN, "another page is connected; disconnect it first")
        try:
            try:
                port = self._open_port()
            except Failure as failure:
                self._say(str(failure))
                return closing(TRY_AGAIN, str(failure))
            self._say("a page is connected")
            try:
                return self._pass_on(page, port)
            finally:
                with suppress(Exception):
                    port.close()
                self._say("the page has left")
        finally:
            self._taken.release()

    def _pass_on(self, page: Connection, port: Port) -> bytes:
        ended = threading.Event()

        def to_page() -> None:
            try:
                while not ended.is_set():
                    if data := port.read(_AT_ONCE):
                        page.send(frame(BINARY, bytes(data)))
            except Exception as error:  # the port failed, or the page reads nothing
                with suppress(OSError):
                    page.end(closing(GOING, f"the port is lost: {error}"))
                if not ended.wait(PATIENCE):
                    page.cut()

        reader = threading.Thread(target=to_page, daemon=True)
        reader.start()
        try:
            return self._from_page(page, port)
        finally:
            ended.set()
            reader.join()

    def _from_page(self, page: Connection, port: Port) -> bytes:
        frames = Frames()
        with selectors.DefaultSelector() as selector:
            selector.register(page.client, selectors.EVENT_READ)
            while True:
                selector.select()
                data = page.client.recv(_AT_ONCE)
                if not data:
                    return b""
                try:
                    for kind, payload in frames.feed(data):
                        if kind == CLOSE:
                            return closing(NORMAL)
                        if kind == PING:
                            page.send(frame(PONG, payload))
                        if kind == BINARY:
                            _write(port, payload)
                except Wrong as wrong:
                    return closing(wrong.code, str(wrong))
                except OSError as error:
                    return closing(GOING, f"the port is lost: {error}")


class Connection:
    """The connection to a page. Several threads may send frames; nothing follows the frame that ends it."""

    def __init__(self, client: socket.socket) -> None:
        self.client = client
        self.left = threading.Event()
        self._sending = threading.Lock()
        self._ended = False

    def send(self, data: bytes) -> None:
        with self._sending:
            if not self._ended:
                self.client.sendall(data)

    def end(self, last: bytes) -> None:
        with self._sending:
            if not self._ended:
                self._ended = True
                self.client.sendall(last)

    def drain(self) -> None:
        """Reads until the page closes its end: a socket that is closed with unread data resets the connection, and the
        page loses the message with the reason."""
        self.client.shutdown(socket.SHUT_WR)
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end and self.client.recv(_AT_ONCE):
            pass

    def cut(self) -> None:
        """Ends the connection to a page that does not close its end."""
        with suppress(OSError):
            self.client.shutdown(socket.SHUT_RDWR)


def _request(client: socket.socket) -> list[str]:
    """Reads the lines of a request. Raises Refused."""
    held = b""
    while b"\r\n\r\n" not in held:
        data = client.recv(_AT_ONCE)
        if not data or len(held) > _LONGEST:
            raise Refused("400 Bad Request")
        held += data
    return held.partition(b"\r\n\r\n")[0].decode("latin-1").split("\r\n")


def _write(port: Port, data: bytes) -> None:
    while data:
        done = port.write(data)
        data = data[len(data) if done is None else done :]


__all__ = ["HOST", "Connection", "Port", "Server"]
