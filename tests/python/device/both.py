"""Devices of both kinds behind one interface, and the other end of their ports."""

from __future__ import annotations

import asyncio
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from mip_protocol import Packet, PacketBuilder, Parser, aio, base
from mip_protocol import device as sync
from support import PATIENCE


def until(condition: Callable[[], Any]) -> Any:
    """Waits for something, not for a time."""
    end = time.monotonic() + PATIENCE
    while not (found := condition()):
        assert time.monotonic() < end, "it did not happen"
        time.sleep(0.002)
    return found


@contextmanager
def running(*functions: Callable[[], Any]) -> Iterator[None]:
    """Runs each in a thread of its own, and waits for its end."""
    threads = [threading.Thread(target=function, daemon=True) for function in functions]
    for thread in threads:
        thread.start()
    yield
    for thread in threads:
        thread.join(PATIENCE)
        assert not thread.is_alive()


def url(server: socket.socket) -> str:
    return f"socket://localhost:{server.getsockname()[1]}"


class Awaited:
    """A device for asyncio, in a loop of its own; its methods wait for the results."""

    def __init__(self, make: Callable[[], Any]) -> None:
        self.loop = asyncio.new_event_loop()
        self.thread = threading.Thread(target=self.loop.run_forever, daemon=True)
        self.thread.start()
        try:
            self.device = self.run(self._made(make))
        except BaseException:
            self._end()
            raise

    async def _made(self, make: Callable[[], Any]) -> Any:
        made = make()
        return await made if isinstance(made, aio.open_port) else made

    def run(self, what: Any) -> Any:
        return asyncio.run_coroutine_threadsafe(what, self.loop).result(PATIENCE)

    def __getattr__(self, name: str) -> Any:
        found = getattr(self.device, name)
        if not callable(found):
            return found
        if not asyncio.iscoroutinefunction(found):
            return found
        return lambda *a, **k: self.run(found(*a, **k))

    def __iter__(self) -> Iterator[Any]:
        return self._taken(self.device.__aiter__())

    def fields(self, *kinds: Any, **options: Any) -> Iterator[Any]:
        return self._taken(self.device.fields(*kinds, **options))

    def _taken(self, source: Any) -> Iterator[Any]:
        while True:
            try:
                yield self.run(source.__anext__())
            except StopAsyncIteration:
                return

    def __enter__(self) -> Awaited:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
        self._end()

    def _end(self) -> None:
        self.loop.call_soon_threadsafe(self.loop.stop)
        self.thread.join(PATIENCE)
        self.loop.close()


class Kind:
    """Makes devices of one kind."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.waits = name == "asyncio"

    def at(self, port: Any, **options: Any) -> Any:
        return Awaited(lambda: aio.Device(port, **options)) if self.waits else sync.Device(port, **options)

    def open(self, url: str, *given: Any, **options: Any) -> Any:
        if self.waits:
            return Awaited(lambda: aio.open_port(url, *given, **options))
        return sync.open_port(url, *given, **options)


class Peer:
    """The other end of a connection: receives commands, and sends the replies of the test."""

    def __init__(self) -> None:
        self.near, self.far = socket.socketpair()
        self.far.settimeout(PATIENCE)
        self.parser = Parser()
        self.commands: list[Packet] = []

    def command(self) -> Packet:
        """The next packet that the host has sent."""
        while not self.commands:
            data = self.far.recv(4096)
            assert data, "the host has closed the connection"
            self.commands += self.parser.feed(data)
        return self.commands.pop(0)

    def send(self, *data: bytes) -> None:
        self.far.sendall(b"".join(data))

    def answering(self, *answers: bytes | list[bytes]) -> threading.Thread:
        """Answers each command in turn, in a thread; the parts of a list are sent one by one."""

        def run() -> None:
            for answer in answers:
                self.command()
                for part in [answer] if isinstance(answer, bytes) else answer:
                    self.send(part)

        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        return thread

    def close(self) -> None:
        self.far.close()


def packet(number: int, *fields: str) -> bytes:
    """A packet of these fields: descriptor and data, in hexadecimal."""
    builder = PacketBuilder(number)
    for text in fields:
        data = bytes.fromhex(text)
        builder.add(data[0], data[1:])
    return bytes(builder.build())


def acknowledge(number: int, descriptor: int, code: int = 0) -> bytes:
    return packet(number, f"f1 {descriptor:02x} {code:02x}")


DATA = packet(0x80, "04 3e7a63a0 bb8e3b29 7fe5bf7f")
PING = base.Ping()
