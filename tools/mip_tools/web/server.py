"""Serves a device to pages in a browser: WebSocket on this machine, for pages that know the token."""

from __future__ import annotations

import hmac
import secrets
import socket
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from typing import Any, Protocol

from ..errors import Failure
from ..files import pages

HOST = "127.0.0.1"
#: The maximum size of a message from a page, in bytes.
LONGEST = 1 << 16
#: Codes with which a connection ends.
_NORMAL, _GOING, _TRY_AGAIN = 1000, 1001, 1013
_AT_ONCE = 4096


class Port(Protocol):
    """A port to serve: one that `mip_protocol` opens, or a `LivePort`."""

    def read(self, size: int, /) -> bytes | None: ...
    def write(self, data: bytes, /) -> int | None: ...
    def close(self) -> None: ...


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
        self._pages: set[Any] = set()
        options = {"compression": None, "ping_interval": None, "max_size": LONGEST}
        try:
            self._listening = pages.listening("serve", self._serve, (HOST, number), self._rejection, **options)
        except OSError as error:
            raise Failure(f"TCP port {number} cannot be used: {error.strerror}; name another one with --tcp") from None
        self._closed: type[Exception] = import_module("websockets.exceptions").ConnectionClosed

    @property
    def number(self) -> int:
        return int(self._listening.socket.getsockname()[1])

    @property
    def address(self) -> str:
        """The address to which a page connects."""
        return f"ws://{HOST}:{self.number}/{self.token}"

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        """Stops, and waits until the pages have read the reason; those that never read it are cut off."""
        self.stop()
        end = time.monotonic() + pages.PATIENCE
        while self._pages and time.monotonic() < end:
            time.sleep(0.01)
        for page in list(self._pages):
            with suppress(OSError):
                page.socket.shutdown(socket.SHUT_RDWR)

    def run(self) -> None:
        """Serves until `stop`."""
        self._listening.serve_forever()

    def stop(self) -> None:
        """Makes `run` return; for signal handlers and other threads."""
        self._listening.shutdown()
        for page in list(self._pages):
            threading.Thread(target=_end, args=(page, _GOING, "mip serve has ended"), daemon=True).start()

    def _rejection(self, request: Any) -> str | None:
        """Returns why a request is rejected: it is not by a page that knows the token."""
        hosts, origins = request.headers.get_all("Host"), request.headers.get_all("Origin")
        if len(hosts) != 1 or not pages.host_is_known(hosts[0], HOST):
            return "This name is not that of the server."
        if hmac.compare_digest(request.path.encode(errors="surrogateescape"), f"/{self.token}".encode()):
            return None
        origin = pages.terminal_safe(origins[0]) if origins else "unknown origin"
        self._say(f"a page of {origin} was rejected: it does not know the token")
        return "This page does not know the token."

    def _serve(self, page: Any) -> None:
        self._pages.add(page)
        try:
            _end(page, *self._talk(page))
        finally:
            self._pages.discard(page)

    def _talk(self, page: Any) -> tuple[int, str]:
        """Passes bytes on in both directions. Returns the code and the reason with which the connection ends."""
        if not self._taken.acquire(blocking=False):
            return _TRY_AGAIN, "another page is connected; disconnect it first"
        try:
            try:
                port = self._open_port()
            except Failure as failure:
                self._say(str(failure))
                return _TRY_AGAIN, str(failure)
            self._say("a page is connected")
            try:
                return self._pass_on(page, port)
            finally:
                with suppress(Exception):
                    port.close()
                self._say("the page has left")
        finally:
            self._taken.release()

    def _pass_on(self, page: Any, port: Port) -> tuple[int, str]:
        ended = threading.Event()

        def to_page() -> None:
            try:
                while not ended.is_set():
                    if data := port.read(_AT_ONCE):
                        page.send(bytes(data))
            except self._closed:
                pass
            except Exception as error:  # the port failed
                _end(page, _GOING, f"the port is lost: {error}")

        reader = threading.Thread(target=to_page, daemon=True)
        reader.start()
        try:
            for data in page:
                if isinstance(data, bytes):
                    _write(port, data)
        except self._closed:
            pass
        except OSError as error:
            return _GOING, f"the port is lost: {error}"
        finally:
            ended.set()
            reader.join()
        return _NORMAL, ""


def _end(page: Any, code: int, reason: str) -> None:
    """Ends a connection; a reason has at most 123 bytes."""
    page.close(code, reason.encode()[:123].decode(errors="ignore"))


def _write(port: Port, data: bytes) -> None:
    while data:
        done = port.write(data)
        data = data[len(data) if done is None else done :]
