"""Ports: serial ports (by pyserial), TCP connections, and a thread that reads any port."""

from __future__ import annotations

import errno
import inspect
import os
import re
import selectors
import socket
import threading
import time
import warnings
import weakref
from collections.abc import Callable
from importlib import import_module
from typing import Any, ParamSpec, Protocol
from urllib.parse import urlsplit

from .exceptions import MissingExtra, PortError

#: The factory default baud rate.
USUAL = 115200
#: Seconds that a read waits for the first byte, on ports that this module opens.
READ_TIMEOUT = 0.05
#: Seconds after which a write fails because the other end accepts no data.
WRITE_TIMEOUT = 5.0
#: Seconds until an attempt to connect by TCP fails.
CONNECT_TIMEOUT = 10.0
#: The largest number of bytes read at once.
AT_ONCE = 4096
#: Seconds within which bytes that wait at a port are handled before a command is sent.
SETTLE = 0.05
#: Seconds to wait before reading again a port that returns immediately without data.
PAUSE = 0.002

#: Why an existing serial port cannot be opened.
IN_USE = (
    "the port is in use by another program, or by an open device of this program; close it first"
)

_HOST = re.compile(r"(\[[0-9A-Fa-f:]+\]|[\w.-]+):\d{1,5}")


#: `select` supports only file descriptors below 1024, and epoll needs a file descriptor of its own.
_Selector: Any = getattr(selectors, "PollSelector", selectors.SelectSelector)


class Port(Protocol):
    """The connection to a device: a serial port of pyserial, or your own object.

    `read` returns up to `size` received bytes, or none; it may block for any time. If either method
    raises an exception, the port is lost. `in_waiting`, `cancel_read` and `baudrate` are used if
    they exist, as in pyserial.
    """

    def read(self, size: int, /) -> bytes | None: ...
    def write(self, data: bytes, /) -> int | None: ...


class SocketPort:
    """A TCP connection as a port."""

    def __init__(self, connection: socket.socket) -> None:
        self._socket = connection
        connection.setblocking(True)

    def read(self, size: int) -> bytes:
        """Returns received bytes, or none after a short wait. Raises ConnectionError when the other
        end has closed the connection."""
        if not self._ready(selectors.EVENT_READ, READ_TIMEOUT):
            return b""
        data = self._socket.recv(size)
        if not data:
            raise ConnectionResetError("the other end has closed the connection")
        return data

    def waits(self) -> bool:
        """Do bytes, or the end of the connection, wait?"""
        return bool(self._ready(selectors.EVENT_READ, 0))

    def write(self, data: bytes) -> int:
        if not self._ready(selectors.EVENT_WRITE, WRITE_TIMEOUT):
            raise TimeoutError("the other end accepts no data")
        return self._socket.send(data)

    def close(self) -> None:
        self._socket.close()

    def _ready(self, event: int, seconds: float) -> bool:
        with _Selector() as selector:  # one per call: threads read and write at the same time
            selector.register(self._socket, event)
            return bool(selector.select(seconds))


def open_url(url: str | os.PathLike[str], baud: int) -> Any:
    """Opens a port by name: a path, COM3, HOST:PORT, socket://HOST:PORT, or another URL that
    pyserial supports.

    A serial port is opened exclusively. Raises PortError if it cannot be opened, and MissingExtra
    without pyserial, which TCP connections do not need.
    """
    check_baud(baud)
    url = os.fspath(url)
    host = address(url)
    try:
        if host is not None:
            return SocketPort(socket.create_connection(host, CONNECT_TIMEOUT))
        return _serial(url, baud)
    except (OSError, ValueError) as error:
        raise cannot_open(url, error) from error


def check_baud(baud: int) -> None:
    """Raises TypeError or ValueError for what cannot be a baud rate."""
    if not isinstance(baud, int):
        raise TypeError(f"baud rate {baud!r}: must be a whole number, such as 115200")
    if baud < 1:
        raise ValueError(f"baud rate {baud}: must be at least 1")


def cannot_open(url: str | os.PathLike[str], error: Exception) -> PortError:
    """Returns the error for a port that cannot be opened; pyserial's may be a ValueError."""
    number = getattr(error, "errno", None)
    if number in (errno.EAGAIN, errno.EBUSY):  # from the lock, from the driver
        number, why = errno.EBUSY, IN_USE
    elif isinstance(error, socket.gaierror):  # whose numbers and texts vary between systems
        number, why = None, "unknown host"
    else:  # without pyserial's text, which repeats the port's name
        why = os.strerror(number) if number else str(error)
    kind = "port" if isinstance(error, OSError) else "url"
    return PortError(kind, f"{os.fspath(url)} cannot be opened: {why}", number)


def _serial(url: str, baud: int) -> Any:
    try:
        serial: Any = import_module("serial")
    except ImportError:
        raise MissingExtra("pyserial", "serial") from None
    # Exclusive, because two readers of one port would each receive only part of the data.
    return serial.serial_for_url(
        url, baudrate=baud, timeout=READ_TIMEOUT, write_timeout=WRITE_TIMEOUT, exclusive=True
    )


def address(url: str | os.PathLike[str]) -> tuple[str, int] | None:
    """Parses HOST:PORT, socket://… and tcp://…; None for other URLs. Raises PortError."""
    url = os.fspath(url)
    scheme, separator, rest = url.partition("://")
    if not separator and _HOST.fullmatch(url):
        scheme, separator, rest = "socket", "://", url
    if not separator or scheme.lower() not in ("socket", "tcp"):
        return None
    parts = urlsplit(f"//{rest}")
    try:
        number = parts.port
    except ValueError:
        number = None
    if not parts.hostname or not number:
        raise PortError("url", f"{url!r} is not a TCP port; write HOST:PORT")
    return parts.hostname, number


def as_port(port: Any) -> Any:
    """Returns an argument as a port: wraps sockets, and raises TypeError for what is not a port."""
    if isinstance(port, socket.socket):
        return SocketPort(port)
    if not (callable(getattr(port, "read", None)) and callable(getattr(port, "write", None))):
        raise TypeError(f"{port!r} is not a port: it needs `read` and `write`")
    try:
        inspect.signature(port.read).bind(AT_ONCE)
    except TypeError:
        raise TypeError(f"{port!r} is not a port: its `read` must accept a size") from None
    except ValueError:  # a function in C without a signature, for example
        pass
    return port


def read_some(port: Any) -> bytes:
    """Returns received bytes as soon as there are any. To ask for more would block."""
    waiting = getattr(port, "in_waiting", None)
    if waiting is not None:
        return port.read(min(max(1, waiting), AT_ONCE)) or b""
    read = getattr(port, "read1", port.read)  # `read` of a buffered file would wait for all bytes
    return read(AT_ONCE) or b""


def waits(port: Any) -> bool:
    """Do bytes wait at a port, as far as it can tell?"""
    try:
        check = getattr(port, "waits", None)
        return bool(check() if check else getattr(port, "in_waiting", 0))
    except Exception:  # the port is lost, which the reader reports
        return False


def write_all(port: Any, data: bytes, wait: Callable[[float], object] = time.sleep) -> None:
    """Writes all bytes, in several calls if the port accepts fewer at once.

    While the port accepts none, calls `wait` with a number of seconds. Raises TimeoutError if it
    accepts none for `WRITE_TIMEOUT`, or if `wait` returns true.
    """
    end: float | None = None
    while data:
        count = port.write(data)
        if count is None:
            return
        data = data[count:]
        if count:
            end = None
        elif data:
            now = time.monotonic()
            end = now + WRITE_TIMEOUT if end is None else end
            if now >= end or wait(PAUSE):
                raise TimeoutError("the other end accepts no data")


P = ParamSpec("P")


def weakly(method: Callable[P, object]) -> Callable[P, None]:
    """Returns a function that calls a method while its object exists, without keeping it alive."""
    reference = weakref.WeakMethod(method)

    def call(*args: P.args, **options: P.kwargs) -> None:
        found = reference()
        if found is not None:
            found(*args, **options)

    return call


def warn_unclosed(device: object) -> None:
    """Warns that a device was dropped without being closed."""
    warnings.warn(f"{device!r} is not closed", ResourceWarning, 3, source=device)


class Reader(threading.Thread):
    """Reads a port until it is stopped or the port is lost.

    `on_data(data, monotonic, clock)` is called with received bytes and their time, and without
    bytes when none have arrived for a moment. `on_end(error)` is called last; `error` is None if
    the reader was stopped.
    """

    def __init__(
        self,
        port: Any,
        on_data: Callable[[bytes, float, float], object],
        on_end: Callable[[BaseException | None], object],
    ) -> None:
        super().__init__(name="mip-reader", daemon=True)
        self._port = port
        self._on_data = on_data
        self._on_end = on_end
        self._stopped = threading.Event()
        self._handling = False

    def run(self) -> None:
        error: BaseException | None = None
        try:
            while not self._stopped.is_set():
                before = time.monotonic()
                self._handling = waits(self._port)  # before they are taken: bytes are never nowhere
                data = read_some(self._port)
                self._handling = True
                now = time.monotonic()
                self._on_data(data, now, time.time())
                self._handling = False
                if not data and now - before < PAUSE:
                    self._stopped.wait(PAUSE)
        except BaseException as caught:  # ports and callbacks may raise anything
            error = None if self._stopped.is_set() else caught
        self._on_end(error)

    def settle(self) -> None:
        """Waits for a moment until the bytes that have already arrived are handled."""
        end = time.monotonic() + SETTLE
        while (self._handling or waits(self._port)) and time.monotonic() < end:
            time.sleep(0.0005)

    def write(self, data: bytes) -> None:
        """Writes all bytes to the port, unless the reader is stopped before it accepts them."""
        write_all(self._port, data, self._stopped.wait)

    def stop(self) -> None:
        """Ends the thread, even if it is blocked, and closes the port."""
        self._stopped.set()
        here = threading.current_thread() is self
        if not here:
            cancel = getattr(self._port, "cancel_read", None)
            if cancel is not None:
                try:
                    cancel()
                except Exception:  # the port may already be lost
                    pass
            self.join(1.0)
        close = getattr(self._port, "close", None)
        if close is not None:
            try:
                close()
            except Exception:
                pass
        if not here:
            self.join(1.0)
