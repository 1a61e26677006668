"""A device at a port, for asyncio: the same as `device`, with `await`.

    async with aio.open_port("/dev/ttyACM0", 115200) as device:
        info = await device.request(base.GetDeviceInfo())
        async for arrival in device:
            ...

TCP connections are asyncio streams; a thread reads any other port. Call all methods in the event
loop that created the device, from any number of tasks.
"""

from __future__ import annotations

import asyncio
import os
import sys
import threading
import time
from collections.abc import AsyncIterator, Callable, Coroutine, Generator, Mapping, Sequence
from functools import partial
from typing import Any, cast, overload

from ._session import session
from .baud import changing
from .client import Outcome, check_seconds
from .conversation import (
    CAPACITY,
    Arrival,
    AtPort,
    Conversation,
    Dialog,
    News,
    Stamp,
    T,
    Ticket,
    responses,
)
from .device import (
    CLOSED_MEANWHILE,
    F1,
    F2,
    F3,
    F4,
    R1,
    R2,
    R3,
    R4,
    Callback,
    F,
    connect,
    deadline_of,
    lost,
)
from .errors import Cause, NoData
from .exceptions import MipError, PortClosed
from .field import Command, Field, R, Response
from .port import (
    AT_ONCE,
    CONNECT_TIMEOUT,
    READ_TIMEOUT,
    USUAL,
    WRITE_TIMEOUT,
    Reader,
    address,
    as_port,
    cannot_open,
    check_baud,
    warn_unclosed,
    weakly,
)
from .rejected import ConnectedDevice, ask_and_find_cause, received, with_cause
from .streaming import steps

#: Turns of the event loop before a command is sent, so that bytes that have arrived are processed
#: even if the program has kept the loop busy. Streams take about five of them.
TURNS = 10
#: Seconds to wait for unsent bytes when a connection is closed; then they are discarded.
CLOSE_TIMEOUT = 1.0

OnData = Callable[[bytes, float, float], object]
OnEnd = Callable[[BaseException], object]
#: A function that opens a port at a baud rate.
Opening = Callable[[int], Coroutine[Any, Any, Any]]

# Nothing here uses `asyncio.wait_for` in a caller's task: until Python 3.12, it loses a
# cancellation that arrives in the same turn of the event loop as the result.


class Device(AtPort):
    """A device on an open port. An `async with` statement closes it at the end.

    A device that is garbage-collected while open is closed, with a ResourceWarning. A task that
    waits for the device can be cancelled at any time; a command that is being written at that
    moment is still written in full.
    """

    def __init__(
        self,
        port: Any,
        *,
        timeout: float = 1.0,
        capacity: int = CAPACITY,
        on_bytes: Callback | None = None,
        on_skipped: Callback | None = None,
    ) -> None:
        """The arguments are those of `device.Device`; `port` may also be a pair of a StreamReader
        and a StreamWriter. `on_bytes` and `on_skipped` are called in the event loop.
        """
        self._talk = Conversation(timeout, capacity, on_skipped)
        self._on_bytes = on_bytes
        self._loop = asyncio.get_running_loop()
        self._answered = self._loop.create_future()  # done at the next news
        self._arrived = self._loop.create_future()
        self._writing = asyncio.Lock()
        self._written: asyncio.Future[None] | None = None  # the latest packet
        self._opening = asyncio.Lock()
        self._again: Opening | None = None
        self._start(port)

    def _start(self, port: Any) -> None:
        kind = Streams if isinstance(port, tuple) else Threaded
        self._link: Streams | Threaded = kind(port, self._loop)
        self._port = self._link.port
        self._link.start(weakly(self._receive), weakly(self._lose))
        self._closed = False
        # needs: session
        self._target = ConnectedDevice()

    def __del__(self) -> None:
        if not self._closed and not sys.is_finalizing():
            warn_unclosed(self)
            self._link.abandon()

    async def __aenter__(self) -> Device:
        return self

    async def __aexit__(self, *error: object) -> None:
        await self.close()

    async def close(self) -> None:
        """Closes the port. Waiting callers get PortClosed; iterations end."""
        self._closes += 1
        self._closed = True
        self._end = self._end or PortClosed("the device has been closed")
        self._wake(News(True, True))
        await self._link.stop()

    async def reopen(self, within: float = 30.0) -> None:
        """Like `device.Device.reopen`."""
        check_seconds(within, "within")
        if self._again is None:
            raise ValueError("only a port that `open_port` has opened can be opened again")
        link, closes = self._link, self._closes
        async with self._opening:
            if self._link is link:  # otherwise another task has already reopened it
                await self._open_again(self._again, within, closes)

    async def _open_again(self, again: Opening, within: float, closes: int) -> None:
        rate = self.baud or USUAL
        try:
            await self._link.stop()
            port = await self._opened(again, rate, time.monotonic() + within, closes)
        except BaseException as error:
            self._give_up(error)
            raise
        if self._closes != closes:
            _close(port)
            raise PortClosed(CLOSED_MEANWHILE)
        self._talk.restart()
        self._end = None
        self._start(port)
        self._wake(News(True, True))

    async def _opened(self, again: Opening, rate: int, end: float, closes: int) -> Any:
        while True:
            try:
                return await again(rate)
            except OSError:
                if self._closes != closes:
                    raise PortClosed(CLOSED_MEANWHILE) from None
                if time.monotonic() >= end:
                    raise
                await asyncio.sleep(0.1)

    # ----------------------------------------------------------------- commands

    async def request(self, command: Command[R], timeout: float | None = None) -> R:
        """Sends a command, waits for the reply and returns the response, or None if it has none.

        Raises what `device.Device.request` raises.
        """
        (result,) = await self._answers((command,), timeout)
        return cast(R, result)

    @overload
    async def request_all(
        self, a: Command[R1], /, *, timeout: float | None = None
    ) -> tuple[R1]: ...
    @overload
    async def request_all(
        self, a: Command[R1], b: Command[R2], /, *, timeout: float | None = None
    ) -> tuple[R1, R2]: ...
    @overload
    async def request_all(
        self, a: Command[R1], b: Command[R2], c: Command[R3], /, *, timeout: float | None = None
    ) -> tuple[R1, R2, R3]: ...
    @overload
    async def request_all(
        self,
        a: Command[R1],
        b: Command[R2],
        c: Command[R3],
        d: Command[R4],
        /,
        *,
        timeout: float | None = None,
    ) -> tuple[R1, R2, R3, R4]: ...
    @overload
    async def request_all(
        self, *commands: Command, timeout: float | None = None
    ) -> tuple[Any, ...]: ...
    async def request_all(
        self, *commands: Command, timeout: float | None = None
    ) -> tuple[Any, ...]:
        """Sends commands of one set in one packet and returns the response of each.

        Raises what `device.Device.request_all` raises.
        """
        return await self._answers(commands, timeout)

    async def _answers(
        self, commands: Sequence[Command], timeout: float | None
    ) -> tuple[Response | None, ...]:
        tickets = await self._exchange(commands, timeout)
        # needs: session
        await self._follow(with_cause(received(tickets), self._target))
        return responses(tickets)

    # needs: session
    async def cause(self, command: Command) -> Cause | None:
        """Like `device.Device.cause`."""
        return await self._follow(ask_and_find_cause(command, self._target))

    async def exchange(
        self, *commands: Command, timeout: float | None = None
    ) -> list[Outcome | None]:
        """Sends commands of one set in one packet and returns the outcome of each.

        The outcome is None for a command that the device never acknowledges. Raises only PortClosed
        and EncodeError.
        """
        return [ticket.outcome for ticket in await self._exchange(commands, timeout)]

    async def send(self, *commands: Command) -> None:
        """Sends commands of one set in one packet, and does not wait for replies.

        Replies, if any arrive, are treated as data. Raises PortClosed and EncodeError.
        """
        await self._send(commands, None, wait=False)

    async def write(self, data: bytes) -> None:
        """Like `device.Device.write`."""
        async with self._writing:
            await self._wait_for_write()
            self._must_be_open()
            await self._put(data)

    async def _exchange(self, commands: Sequence[Command], timeout: float | None) -> list[Ticket]:
        for command in commands:
            question = self._talk.question(command)
            if question is not None:
                (outcome,) = await self.exchange(question)
                self._talk.settle(question, outcome)
        tickets = await self._send(commands, timeout)
        try:
            await self._wait(tickets)
        finally:
            self._talk.forget(tickets)
        return tickets

    async def _send(
        self, commands: Sequence[Command], timeout: float | None, wait: bool = True
    ) -> list[Ticket]:
        async with self._writing:  # replies must arrive in the order of the commands
            await self._wait_for_write()
            for _ in range(TURNS):  # a late reply must not be matched to this command
                await asyncio.sleep(0)
            self._must_be_open()
            packet, tickets = self._talk.send(commands, time.monotonic(), timeout, wait)
            try:
                await self._put(packet)
            except BaseException:
                self._talk.forget(tickets)
                raise
        return tickets

    async def _wait_for_write(self) -> None:
        if self._written is not None and not self._written.done():
            await asyncio.wait((self._written,))  # the task that was writing it was cancelled

    async def _put(self, data: bytes) -> None:
        try:
            self._written = self._link.write(data)
            await asyncio.shield(self._written)  # a partial packet would be noise
        except Exception as error:
            self._must_be_open()
            raise PortClosed(f"the port cannot write: {error}") from error

    async def _wait(self, tickets: list[Ticket]) -> None:
        while not all(ticket.done for ticket in tickets):
            self._must_be_open()
            deadline = self._talk.deadline
            left = 1.0 if deadline is None else deadline - time.monotonic()
            if left <= 0:
                self._wake(self._talk.poll(time.monotonic()))
            else:
                await asyncio.wait((self._answered,), timeout=left)

    # needs: session
    async def stream(
        self,
        rates: Mapping[type[F], float],
        *,
        set: int | None = None,
        timestamp: str | None = "auto",
    ) -> dict[type[Field], float]:
        """Like `device.Device.stream`."""
        known = self._talk.identified
        dialog = steps(session(), dict(rates.items()), set, timestamp, known, self.clear)
        return await self._follow(with_cause(dialog, self._target))

    # needs: baud rates
    async def change_baud(self, command: Command, attempts: int = 3) -> int:
        """Like `device.Device.change_baud`."""
        dialog = changing(self, command, attempts)
        # needs: session
        dialog = with_cause(dialog, self._target)
        return await self._follow(dialog)

    # needs: session or baud rates
    async def _follow(self, dialog: Dialog[T]) -> T:
        answer: Any = None
        failed: MipError | None = None
        while True:
            try:
                step = dialog.throw(failed) if failed else dialog.send(answer)
            except StopIteration as end:
                return cast(T, end.value)
            answer = failed = None
            try:
                if step.command is None:
                    await asyncio.sleep(step.seconds or 0)
                else:
                    (answer,) = responses(await self._exchange((step.command,), step.seconds))
            except MipError as error:
                failed = error

    # ----------------------------------------------------------------- data

    async def __aiter__(self) -> AsyncIterator[Arrival]:
        """Yields data packets as they arrive, until `close` closes the device.

        Raises PortClosed when the port is lost, after yielding all data received before.
        """
        while (arrival := await self._next(None)) is not None:
            yield arrival

    async def next(self, timeout: float | None = None) -> Arrival | None:
        """Returns the next data packet, or None if none arrives within `timeout` seconds or the
        device is closed.

        Raises PortClosed when the port is lost, once all data received before has been returned.
        """
        return await self._next(deadline_of(timeout))

    async def _next(self, deadline: float | None) -> Arrival | None:
        arrivals = self._talk.arrivals
        while not arrivals:
            if self._closed:
                return None
            self._must_be_open()
            left = None if deadline is None else deadline - time.monotonic()
            if left is not None and left <= 0:
                return None
            await asyncio.wait((self._arrived,), timeout=left)
        return arrivals.popleft()

    @overload
    def fields(
        self, a: type[F1], /, *, timeout: float | None = None
    ) -> AsyncIterator[tuple[Stamp, F1]]: ...
    @overload
    def fields(
        self, a: type[F1], b: type[F2], /, *, timeout: float | None = None
    ) -> AsyncIterator[tuple[Stamp, F1 | F2]]: ...
    @overload
    def fields(
        self, a: type[F1], b: type[F2], c: type[F3], /, *, timeout: float | None = None
    ) -> AsyncIterator[tuple[Stamp, F1 | F2 | F3]]: ...
    @overload
    def fields(
        self,
        a: type[F1],
        b: type[F2],
        c: type[F3],
        d: type[F4],
        /,
        *,
        timeout: float | None = None,
    ) -> AsyncIterator[tuple[Stamp, F1 | F2 | F3 | F4]]: ...
    @overload
    def fields(
        self, *kinds: type[F], timeout: float | None = None
    ) -> AsyncIterator[tuple[Stamp, F]]: ...
    async def fields(
        self, *kinds: type[Any], timeout: float | None = None
    ) -> AsyncIterator[tuple[Stamp, Any]]:
        """Like `device.Device.fields`."""
        deadline = deadline_of(timeout)
        while (arrival := await self._next(deadline)) is not None:
            stamp = arrival.stamp()
            for kind in kinds:
                for field in arrival.find_all(kind):
                    yield stamp, field
                    deadline = deadline_of(timeout)
        if timeout is not None and not self._closed:
            raise NoData(kinds, timeout)

    def clear(self, set: int | None = None) -> None:
        """Like `device.Device.clear`."""
        self._talk.clear(set)

    # ----------------------------------------------------------------- received bytes

    def _receive(self, data: bytes, monotonic: float, clock: float) -> None:
        if data and self._on_bytes is not None:
            self._on_bytes(data)
        self._wake(self._talk.receive(data, monotonic, clock))

    def _lose(self, error: BaseException) -> None:
        self._end = self._end or lost(error)
        try:
            self._talk.end(time.monotonic(), time.time())
        finally:
            self._wake(News(True, True))

    def _give_up(self, error: BaseException) -> None:
        self._end = self._end or lost(error)
        self._wake(News(True, True))

    def _wake(self, news: News) -> None:
        # Current waiters hold the old future; later ones wait for the new one.
        if news.answers:
            self._answered.set_result(None)
            self._answered = self._loop.create_future()
        if news.arrivals:
            self._arrived.set_result(None)
            self._arrived = self._loop.create_future()


# --------------------------------------------------------------------------- transfer of bytes


class Threaded:
    """Any port, read by a thread."""

    def __init__(self, port: Any, loop: asyncio.AbstractEventLoop) -> None:
        self.port = as_port(port)
        self._loop = loop
        self._stopped = False

    def start(self, on_data: OnData, on_end: OnEnd) -> None:
        self._on_data = on_data
        self._on_end = on_end
        self._reader = Reader(self.port, self._data, self._ended)
        self._reader.start()

    def _data(self, data: bytes, monotonic: float, clock: float) -> None:
        self._loop.call_soon_threadsafe(self._hand_over, data, monotonic, clock)

    def _hand_over(self, data: bytes, monotonic: float, clock: float) -> None:
        if self._stopped:
            return
        try:
            self._on_data(data, monotonic, clock)
        except Exception as error:
            self._finish(error)

    def _ended(self, error: BaseException | None) -> None:
        if error is None:  # it was stopped
            return
        try:
            self._loop.call_soon_threadsafe(self._finish, error)
        except RuntimeError:  # the loop is closed
            pass

    def _finish(self, error: BaseException) -> None:
        if not self._stopped:
            self._stopped = True
            self._on_end(error)

    def write(self, data: bytes) -> asyncio.Future[None]:
        return asyncio.ensure_future(asyncio.to_thread(self._reader.write, data))

    async def stop(self) -> None:
        self._stopped = True
        await asyncio.to_thread(self._reader.stop)

    def abandon(self) -> None:
        self._stopped = True
        self._reader.stop()


class Streams:
    """An asyncio connection: a StreamReader and a StreamWriter."""

    port: Any = None  # it has no baud rate

    def __init__(
        self,
        port: tuple[asyncio.StreamReader, asyncio.StreamWriter],
        loop: asyncio.AbstractEventLoop,
    ) -> None:
        self._reader, self._writer = port
        self._loop = loop
        # A write ends when the system has accepted the bytes, as with other ports.
        self._writer.transport.set_write_buffer_limits(0)

    def start(self, on_data: OnData, on_end: OnEnd) -> None:
        self._task = self._loop.create_task(self._run(on_data, on_end))

    async def _run(self, on_data: OnData, on_end: OnEnd) -> None:
        reading: asyncio.Task[bytes] | None = None
        try:
            while True:
                reading = reading or self._loop.create_task(self._reader.read(AT_ONCE))
                done, _ = await asyncio.wait({reading}, timeout=READ_TIMEOUT)
                data = reading.result() if done else b""
                if done:
                    reading = None
                    if not data:
                        raise ConnectionResetError("the other end has closed the connection")
                on_data(data, time.monotonic(), time.time())
        except Exception as error:
            on_end(error)
        finally:
            if reading is not None:
                reading.cancel()

    def write(self, data: bytes) -> asyncio.Future[None]:
        self._writer.write(data)
        return asyncio.ensure_future(self._drain())

    async def _drain(self) -> None:
        try:
            await asyncio.wait_for(self._writer.drain(), WRITE_TIMEOUT)
        except asyncio.TimeoutError:
            self._writer.transport.abort()  # else the failed command could still be sent
            raise TimeoutError("the other end accepts no data") from None

    async def stop(self) -> None:
        self._leave()
        ends = asyncio.gather(self._task, self._writer.wait_closed(), return_exceptions=True)
        try:
            await asyncio.wait((ends,), timeout=CLOSE_TIMEOUT)
        finally:
            if not ends.done():  # unsent bytes cannot be sent
                self._writer.transport.abort()

    def abandon(self) -> None:
        try:
            self._loop.call_soon_threadsafe(self._leave)
        except RuntimeError:  # the loop is closed
            pass

    def _leave(self) -> None:
        self._task.cancel()
        self._writer.close()


class open_port:  # noqa: N801  # named like the function of the other module
    """Opens the port of a device: `async with open_port(url) as device`, or `await open_port(url)`.

    The arguments and errors are those of `device.open_port`.
    """

    def __init__(
        self,
        url: str | os.PathLike[str],
        baud: int | None = USUAL,
        *,
        timeout: float = 1.0,
        capacity: int = CAPACITY,
        on_bytes: Callback | None = None,
        on_skipped: Callback | None = None,
    ) -> None:
        self._connect = partial(_connect, url)
        self._url, self._baud = os.fspath(url), baud
        self._device = partial(
            Device, timeout=timeout, capacity=capacity, on_bytes=on_bytes, on_skipped=on_skipped
        )

    def __await__(self) -> Generator[Any, None, Device]:
        return self._open().__await__()

    async def __aenter__(self) -> Device:
        self._opened = await self._open()
        return self._opened

    async def __aexit__(self, *error: object) -> None:
        await self._opened.close()

    async def _open(self) -> Device:
        device = self._device(await self._connect(self._baud))
        device._again, device._url = self._connect, self._url
        return device


async def _connect(url: str | os.PathLike[str], baud: int | None) -> Any:
    host = address(url)
    opening: asyncio.Future[Any]
    stop: Callable[[], object]
    seconds: float | None
    if host is not None:
        check_baud(USUAL if baud is None else baud)
        opening = asyncio.ensure_future(asyncio.open_connection(*host))
        stop, seconds = opening.cancel, CONNECT_TIMEOUT
    else:
        wanted = threading.Event()
        wanted.set()
        opening = asyncio.ensure_future(asyncio.to_thread(connect, url, baud, wanted.is_set))
        stop, seconds = wanted.clear, None
    try:
        done, _ = await asyncio.wait((opening,), timeout=seconds)
        if not done:
            raise cannot_open(url, TimeoutError("no answer"))
    except BaseException:
        stop()
        opening.add_done_callback(_discard)
        await asyncio.wait((opening,), timeout=CLOSE_TIMEOUT)  # then the port is free again
        raise
    error = opening.exception()
    if host is not None and isinstance(error, OSError):
        raise cannot_open(url, error) from error
    return opening.result()


def _discard(opening: asyncio.Future[Any]) -> None:
    if not opening.cancelled() and opening.exception() is None:
        _close(opening.result())


def _close(port: Any) -> None:
    """Closes a port that no device uses."""
    (port[1] if isinstance(port, tuple) else port).close()
