"""WebSocket servers, and which pages in a browser may connect: one rule for all. A server is on this machine unless the
user chooses otherwise, but any page in a browser on this machine can reach it."""

from __future__ import annotations

import ipaddress
import logging
import socket
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib import import_module
from typing import Any

from ..binding import MissingExtra
from ..errors import Failure

#: Foxglove in a browser, and its application.
FOXGLOVE = ("https://app.foxglove.dev", "https://studio.foxglove.dev", "file://")


#: Seconds within which a browser must send its request, and close its end.
PATIENCE = 5.0
#: Connections at the same time; one more is rejected.
CONNECTIONS = 16


def host_is_known(header: str, own: str) -> bool:
    """Is the host of a request an address, localhost, or the name at which the server listens? A page of another site
    whose name was made to resolve to this machine (DNS rebinding) sends that name."""
    name = header.rpartition(":")[0] if header.rpartition(":")[2].isdigit() else header
    name = name.strip("[]").lower()
    if name in ("localhost", own.lower()):
        return True
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def origin_is_allowed(origin: str | None, allowed: Sequence[str]) -> bool:
    """May a page of this origin connect? Programs other than browsers send none."""
    return origin is None or "*" in allowed or origin.lower() in (origin_allowed.lower() for origin_allowed in allowed)


def terminal_safe(text: str) -> str:
    """Returns a text from a request for a terminal: without escape sequences, and short."""
    return ascii(text[:80])


def listening(
    extra: str, talk: Callable[[Any], None], place: tuple[str, int], rejection: Callable[[Any], str | None], **more: Any
) -> Any:
    """Makes a WebSocket server, which serves each page with `talk`. `rejection` returns why a request is rejected.

    At most CONNECTIONS clients are connected, and each must send its request within PATIENCE.

    Raises Failure without `websockets`, and OSError.
    """
    try:
        serve = import_module("websockets.sync.server").serve
    except ImportError:
        raise Failure(str(MissingExtra("websockets", extra))) from None

    def check(connection: Any, request: Any) -> Any:
        reason = rejection(request)
        return connection.respond(403, f"{reason}\n") if reason else None

    quiet = logging.getLogger(__name__)
    quiet.addHandler(logging.NullHandler())
    quiet.propagate = False
    timeouts = {"open_timeout": PATIENCE, "close_timeout": PATIENCE}
    server = serve(talk, *place, process_request=check, logger=quiet, **timeouts, **more)
    places, answer = threading.BoundedSemaphore(CONNECTIONS), server.handler

    def accept(client: socket.socket, address: Any) -> None:
        if not places.acquire(blocking=False):
            with client, suppress(OSError):
                client.sendall(b"HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n")
            return
        try:
            answer(client, address)
        finally:
            places.release()

    server.handler = accept
    return server
