"""A stream of an NTRIP caster, versions 1 and 2: the reply to one HTTP request, which does not end."""

from __future__ import annotations

import base64
import queue
import socket
import ssl
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from difflib import get_close_matches
from http.client import HTTPException, HTTPResponse
from types import SimpleNamespace
from typing import Any, NamedTuple, cast
from urllib.parse import unquote, urlsplit

from .. import __version__
from ..errors import Failure, Misuse
from .connection import reason

FORM = "ntrip://USER:PASSWORD@HOST:PORT/MOUNT"
_PORTS = {"ntrip": 2101, "http": 80, "https": 443}
_PATIENCE = 10.0
#: The largest table of mount points, in bytes.
_TABLE = 1 << 22
_AT_ONCE = 4096
_SHOWN = 8


class Source(NamedTuple):
    """A mount point of a caster."""

    scheme: str
    host: str
    number: int
    mount: str
    login: str  # user:password

    def __str__(self) -> str:
        return f"{self.host}:{self.number}/{self.mount}"


def source_of(url: str) -> Source:
    """Parses the URL of a mount point. Raises Misuse."""
    try:
        parts = urlsplit(url if "://" in url else f"ntrip://{url}")
        usual = _PORTS[parts.scheme]
        host, number = parts.hostname, parts.port or usual
    except (ValueError, KeyError):
        host, number = None, 0
    if not host:
        raise Misuse(f"'{url}' is not a mount point of a caster; write {FORM}, or https://…")
    login = "" if parts.username is None else f"{unquote(parts.username)}:{unquote(parts.password or '')}"
    return Source(parts.scheme, host, number, parts.path.lstrip("/"), login)


class Stream:
    """An open stream, which a thread reads."""

    def __init__(self, connection: socket.socket, body: Any) -> None:
        self._connection = connection
        self._body = body
        self._came: queue.SimpleQueue[bytes] = queue.SimpleQueue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        with suppress(OSError, ValueError, HTTPException):
            while data := self._body.read1(_AT_ONCE):
                self._came.put(data)
        self._came.put(b"")

    def read(self, seconds: float) -> bytes | None:
        """Returns what has arrived, none if the stream has ended, or None if nothing arrives in this time."""
        try:
            return self._came.get(timeout=seconds)
        except queue.Empty:
            return None

    def send(self, text: str) -> None:
        with suppress(OSError):  # the end of the stream is found when it is read
            self._connection.sendall(text.encode("ascii"))


@contextmanager
def opened(source: Source) -> Iterator[Stream]:
    """Opens the stream of a mount point. Raises Failure."""
    with _connected(source) as connection:
        status, table, body = _reply(source, connection)
        if "200" not in status.split()[:2] or table:
            raise Failure(f"{source}: {_why_not(source, status, table)}")
        connection.settimeout(None)
        try:
            yield Stream(connection, body)
        finally:
            with suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)  # ends the thread


def _connected(source: Source) -> socket.socket:
    try:
        connection = socket.create_connection((source.host, source.number), _PATIENCE)
        if source.scheme == "https":
            return ssl.create_default_context().wrap_socket(connection, server_hostname=source.host)
        return connection
    except socket.gaierror:
        raise Failure(f"host '{source.host}' is unknown") from None
    except OSError as error:
        raise Failure(f"{source.host}:{source.number} cannot be reached: {reason(error)}") from None


def _reply(source: Source, connection: socket.socket) -> tuple[str, bool, Any]:
    """Requests a mount point. Returns the status, whether a table of mount points follows, and what follows."""
    lines = [
        f"GET /{source.mount} HTTP/1.1",
        f"Host: {source.host}:{source.number}",
        "Ntrip-Version: Ntrip/2.0",
        f"User-Agent: NTRIP mip-tools/{__version__}",
        "Connection: close",
    ]
    if source.login:
        lines.append(f"Authorization: Basic {base64.b64encode(source.login.encode()).decode()}")
    try:
        connection.sendall("\r\n".join([*lines, "", ""]).encode())
        file = connection.makefile("rb")
        if not file.peek(1).startswith(b"H"):  # of version 1: ICY, SOURCETABLE or ERROR, and no other line
            status = file.readline(_AT_ONCE).decode("latin-1").strip()
            return status, status.startswith("SOURCETABLE"), file
        reply = HTTPResponse(cast(Any, SimpleNamespace(makefile=lambda mode: file)))
        reply.begin()
    except (OSError, HTTPException) as error:
        raise Failure(f"{source.host}:{source.number} is not a caster: {reason(error)}") from None
    table = "sourcetable" in reply.headers.get("Content-Type", "")
    return f"{reply.status} {reply.reason}", table, reply


def _why_not(source: Source, status: str, table: bool) -> str:
    if "401" in status or "403" in status or "password" in status.lower():
        return f"the caster rejects the login{'' if source.login else f'; write {FORM}'}"
    if not table and "404" not in status:
        return f"the caster replies: {status or 'nothing'}"
    names = _mounts(source)
    near = get_close_matches(source.mount, names, n=_SHOWN) or names
    others = f"; it has {', '.join(near[:_SHOWN])}{' …' * (len(near) > _SHOWN)}" if names else ""
    return f"the caster has no mount point '{source.mount}'{others}" if source.mount else f"name a mount point{others}"


def _mounts(source: Source) -> list[str]:
    """Returns the mount points of a caster; none if it does not list them."""
    with suppress(Failure, OSError, HTTPException), _connected(source) as connection:
        text = _reply(source._replace(mount=""), connection)[2].read(_TABLE).decode("utf-8", "replace")
        return [line.split(";")[1] for line in text.splitlines() if line.startswith("STR;")]
    return []
