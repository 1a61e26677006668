"""A device at a port: requests with typed responses, and the data that it sends.

    with open_port("/dev/ttyACM0", 115200) as device:
        info = device.request(base.GetDeviceInfo())
        for arrival in device:
            ...

A thread reads all data as soon as it arrives. Any thread may send requests, even while another
thread iterates over the data; each data packet goes to only one of the threads that iterate.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import takewhile
from typing import Any, TypeVar, cast, overload

from ._session import session
from .baud import changing, detect_baud, rates
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
from .errors import Cause, NoData
from .exceptions import MipError, PortClosed
from .field import Command, Field, R, Response
from .port import USUAL, Reader, as_port, open_url, warn_unclosed, weakly
from .rejected import ConnectedDevice, ask_and_find_cause, received, with_cause
from .streaming import steps

F = TypeVar("F", bound=Field)
F1 = TypeVar("F1", bound=Field)
F2 = TypeVar("F2", bound=Field)
F3 = TypeVar("F3", bound=Field)
F4 = TypeVar("F4", bound=Field)
R1 = TypeVar("R1", bound="Response | None")
R2 = TypeVar("R2", bound="Response | None")
R3 = TypeVar("R3", bound="Response | None")
R4 = TypeVar("R4", bound="Response | None")
Callback = Callable[[bytes], object]

#: Why a port is closed although it was reopened.
CLOSED_MEANWHILE = "the device was closed while it was being opened again"


class Device(AtPort):
    """A device on an open port. A `with` statement closes it at the end.

    A device that is garbage-collected while open is closed, with a ResourceWarning.
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
        """`port`: a serial port of pyserial with any time-outs, a socket, or your own object with
        `read(size)` and `write(data)`; see `port.Port`. It is closed with the device.

        `timeout`: seconds to wait for a reply, unless the specification states more for a command.
        A reply that arrives later is data: after a command without a reply, a barrier precedes the
        next command (see `Client`), so that the late reply is not matched to that.
        `capacity`: the number of packets that can wait to be read; beyond that, the oldest are
        dropped and counted. `on_bytes` receives all bytes, `on_skipped` the bytes between packets,
        such as NMEA sentences, in order and in pieces of any size. The reading thread calls both:
        they must not block or use the device. If they raise an exception, the device is closed.
        """
        self._talk = Conversation(timeout, capacity, on_skipped)
        self._on_bytes = on_bytes
        self._lock = threading.RLock()
        self._answered = threading.Condition(self._lock)
        self._arrived = threading.Condition(self._lock)
        self._writing = threading.Lock()
        self._opening = threading.Lock()
        self._again: Callable[[int], Any] | None = None  # opens the same port at this baud rate
        self._start(as_port(port))

    def _start(self, port: Any) -> None:
        self._port = port
        self._reader = Reader(port, weakly(self._receive), weakly(self._lose))
        self._reader.start()
        self._closed = False  # by `close`
        # needs: session
        self._target = ConnectedDevice()

    def __del__(self) -> None:
        # When Python exits, the thread no longer runs and cannot be waited for.
        if not self._closed and not sys.is_finalizing():
            warn_unclosed(self)
            self._reader.stop()

    def __enter__(self) -> Device:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes the port. Waiting callers get PortClosed; iterations end."""
        with self._lock:
            self._closes += 1
            self._closed = True
            self._end = self._end or PortClosed("the device has been closed")
            self._tell(News(True, True))
        self._reader.stop()

    def reopen(self, within: float = 30.0) -> None:
        """Opens the port again after it was lost or closed, trying for `within` seconds.

        Waiting commands end without a reply. Data already received is kept, and iterations of other
        threads that have not ended continue. Raises OSError if the port is not available in time,
        PortClosed if the device is closed meanwhile, and ValueError if the port was not opened by
        `open_port`.
        """
        check_seconds(within, "within")
        if self._again is None:
            raise ValueError("only a port that `open_port` has opened can be opened again")
        reader, closes = self._reader, self._closes
        with self._opening:
            if self._reader is reader:  # otherwise another thread has already reopened it
                self._open_again(self._again, within, closes)

    def _open_again(self, again: Callable[[int], Any], within: float, closes: int) -> None:
        rate = self.baud or USUAL
        self._reader.stop()
        try:
            port = self._opened(partial(again, rate), time.monotonic() + within, closes)
        except BaseException as error:
            self._give_up(error)
            raise
        with self._lock:
            meanwhile = self._closes != closes
            if not meanwhile:
                self._talk.restart()
                self._end = None
                self._start(port)
                self._answered.notify_all()
        if meanwhile:
            port.close()
            raise PortClosed(CLOSED_MEANWHILE)

    def _opened(self, again: Callable[[], Any], end: float, closes: int) -> Any:
        while True:
            try:
                return again()
            except OSError:
                if self._closes != closes:
                    raise PortClosed(CLOSED_MEANWHILE) from None
                if time.monotonic() >= end:
                    raise
                time.sleep(0.1)

    # ----------------------------------------------------------------- commands

    def request(self, command: Command[R], timeout: float | None = None) -> R:
        """Sends a command, waits for the reply and returns the response, or None if it has none.

        `timeout`: seconds to wait for this command. Raises Refused; NoAnswer; MissingResponse if
        the device acknowledges the command without its response; DecodeError if the response cannot
        be decoded; PortClosed; and EncodeError, before anything is sent, if the command cannot be
        encoded.
        """
        (result,) = self._answers((command,), timeout)
        return cast(R, result)

    @overload
    def request_all(self, a: Command[R1], /, *, timeout: float | None = None) -> tuple[R1]: ...
    @overload
    def request_all(
        self, a: Command[R1], b: Command[R2], /, *, timeout: float | None = None
    ) -> tuple[R1, R2]: ...
    @overload
    def request_all(
        self, a: Command[R1], b: Command[R2], c: Command[R3], /, *, timeout: float | None = None
    ) -> tuple[R1, R2, R3]: ...
    @overload
    def request_all(
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
    def request_all(self, *commands: Command, timeout: float | None = None) -> tuple[Any, ...]: ...
    def request_all(self, *commands: Command, timeout: float | None = None) -> tuple[Any, ...]:
        """Sends commands of one set in one packet and returns the response of each.

        If a command fails, raises the error of the first that did, once each has been answered or
        has timed out. `outcomes` of Refused and NoAnswer contains the outcomes of all.
        """
        return self._answers(commands, timeout)

    def _answers(
        self, commands: Sequence[Command], timeout: float | None
    ) -> tuple[Response | None, ...]:
        tickets = self._exchange(commands, timeout)
        # needs: session
        self._follow(with_cause(received(tickets), self._target))
        return responses(tickets)

    # needs: session
    def cause(self, command: Command) -> Cause | None:
        """Returns the field for which the device has rejected a command that lists fields; None if
        nothing shows it. On first use, asks the device what it is and what it sends.

        The errors of `request` and `stream` contain it.
        """
        return self._follow(ask_and_find_cause(command, self._target))

    def exchange(self, *commands: Command, timeout: float | None = None) -> list[Outcome | None]:
        """Sends commands of one set in one packet and returns the outcome of each.

        The outcome is None for a command that the device never acknowledges. Raises only PortClosed
        and EncodeError.
        """
        return [ticket.outcome for ticket in self._exchange(commands, timeout)]

    def send(self, *commands: Command) -> None:
        """Sends commands of one set in one packet, and does not wait for replies.

        Replies, if any arrive, are treated as data. Raises PortClosed and EncodeError.
        """
        self._send(commands, None, wait=False)

    def write(self, data: bytes) -> None:
        """Writes bytes that are not commands, such as RTCM corrections, never into a command.

        Raises PortClosed.
        """
        with self._writing:
            with self._lock:
                self._must_be_open()
            self._put(data)

    def _exchange(self, commands: Sequence[Command], timeout: float | None) -> list[Ticket]:
        self._ask_for_settings(commands)
        tickets = self._send(commands, timeout)
        try:
            with self._lock:
                self._wait(tickets)
        finally:
            with self._lock:
                self._talk.forget(tickets)
        return tickets

    def _ask_for_settings(self, commands: Sequence[Command]) -> None:
        """Reads the device settings that decide whether these commands are acknowledged."""
        for command in commands:
            question = self._talk.question(command)
            if question is not None:
                (outcome,) = self.exchange(question)
                self._talk.settle(question, outcome)

    def _send(
        self, commands: Sequence[Command], timeout: float | None, wait: bool = True
    ) -> list[Ticket]:
        if threading.current_thread() is self._reader:
            raise RuntimeError("called from on_bytes or on_skipped, which must not use the device")
        with self._writing:  # replies must arrive in the order of the commands
            self._reader.settle()  # the copy of an earlier reply must not be matched to this command
            with self._lock:
                self._must_be_open()
                packet, tickets = self._talk.send(commands, time.monotonic(), timeout, wait)
            try:
                self._put(packet)
            except BaseException:
                with self._lock:
                    self._talk.forget(tickets)
                raise
        return tickets

    def _put(self, data: bytes) -> None:
        try:
            self._reader.write(data)
        except Exception as error:
            with self._lock:
                self._must_be_open()
            raise PortClosed(f"the port cannot write: {error}") from error

    def _wait(self, tickets: list[Ticket]) -> None:
        while not all(ticket.done for ticket in tickets):
            self._must_be_open()
            deadline = self._talk.deadline
            left = 1.0 if deadline is None else deadline - time.monotonic()
            if left > 0:
                self._answered.wait(min(left, threading.TIMEOUT_MAX))
            else:
                self._tell(self._talk.poll(time.monotonic()))

    # needs: session
    def stream(
        self,
        rates: Mapping[type[F], float],
        *,
        set: int | None = None,
        timestamp: str | None = "auto",
    ) -> dict[type[Field], float]:
        """Starts streaming: `stream({sensor.ScaledAccel: 100, sensor.ScaledGyro: 100})`. Rates are
        in Hz; 0 is the highest that the device supports. Replaces the message format of the set,
        enables its stream and resumes.

        `set`: the descriptor set, if the fields occur in several. `timestamp`: the clock of the
        timestamp that is added, unless `rates` has one; "auto" for the first that the device
        accepts, if any, None for none. Packets of the set that still wait in the old format are
        discarded. Returns the rates, also that of the timestamp. Raises
        NoSuchRate, before anything is changed, if a rate is not the base rate divided by a whole
        number; Refused, too, if the device has no timestamp of the clock that `timestamp` names;
        ValueError and EncodeError if the fields have no set in common; and whatever `request`
        raises.
        """
        known = self._talk.identified
        dialog = steps(session(), dict(rates.items()), set, timestamp, known, self.clear)
        return self._follow(with_cause(dialog, self._target))

    # needs: baud rates
    def change_baud(self, command: Command, attempts: int = 3) -> int:
        """Sends a command that changes the device's baud rate (one with `baud`), and sets the port
        to the new rate.

        The device replies at the old rate and changes 250 ms later; some reply at either. Set it to
        idle first. Returns the rate at which the device then replies to a ping, and to which the
        port is set: the old one if the command is for another port of the device. Raises
        ValueError if the command or the port has no rate; Refused; and NoAnswer if the device
        replies at neither rate, in which case the port keeps the old one.
        """
        dialog = changing(self, command, attempts)
        # needs: session
        dialog = with_cause(dialog, self._target)
        return self._follow(dialog)

    # needs: session or baud rates
    def _follow(self, dialog: Dialog[T]) -> T:
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
                    time.sleep(step.seconds or 0)
                else:
                    (answer,) = responses(self._exchange((step.command,), step.seconds))
            except MipError as error:
                failed = error

    # ----------------------------------------------------------------- data

    def __iter__(self) -> Iterator[Arrival]:
        """Yields data packets as they arrive, until `close` closes the device.

        Raises PortClosed when the port is lost, after yielding all data received before.
        """
        while (arrival := self._next(None)) is not None:
            yield arrival

    def next(self, timeout: float | None = None) -> Arrival | None:
        """Returns the next data packet, or None if none arrives within `timeout` seconds or the
        device is closed.

        Raises PortClosed when the port is lost, once all data received before has been returned.
        """
        return self._next(deadline_of(timeout))

    def _next(self, deadline: float | None) -> Arrival | None:
        if threading.current_thread() is self._reader:
            raise RuntimeError("called from on_bytes or on_skipped, which must not use the device")
        arrivals = self._talk.arrivals
        with self._lock:
            while not arrivals:
                if self._closed:
                    return None
                self._must_be_open()
                left = None if deadline is None else deadline - time.monotonic()
                if left is not None and left <= 0:
                    return None
                self._arrived.wait(None if left is None else min(left, threading.TIMEOUT_MAX))
            return arrivals.popleft()

    @overload
    def fields(
        self, a: type[F1], /, *, timeout: float | None = None
    ) -> Iterator[tuple[Stamp, F1]]: ...
    @overload
    def fields(
        self, a: type[F1], b: type[F2], /, *, timeout: float | None = None
    ) -> Iterator[tuple[Stamp, F1 | F2]]: ...
    @overload
    def fields(
        self, a: type[F1], b: type[F2], c: type[F3], /, *, timeout: float | None = None
    ) -> Iterator[tuple[Stamp, F1 | F2 | F3]]: ...
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
    ) -> Iterator[tuple[Stamp, F1 | F2 | F3 | F4]]: ...
    @overload
    def fields(
        self, *kinds: type[F], timeout: float | None = None
    ) -> Iterator[tuple[Stamp, F]]: ...
    def fields(
        self, *kinds: type[Any], timeout: float | None = None
    ) -> Iterator[tuple[Stamp, Any]]:
        """Yields the fields of these types as they arrive, each with its time: `stamp.device` is
        that in its packet, by the device's `stamp.clock`, and `stamp.arrived` that of arrival.

        The fields of one packet are in the order of `kinds`, and several of one type in the order
        of the packet. Raises DecodeError at a field that cannot be decoded, and NoData if none of
        these fields arrives within `timeout` seconds: a device that is new or idle sends nothing.
        """
        deadline = deadline_of(timeout)
        while (arrival := self._next(deadline)) is not None:
            stamp = arrival.stamp()
            for kind in kinds:
                for field in arrival.find_all(kind):
                    yield stamp, field
                    deadline = deadline_of(timeout)
        if timeout is not None and not self._closed:
            raise NoData(kinds, timeout)

    def clear(self, set: int | None = None) -> None:
        """Discards the data that has not been read yet, of one descriptor set or of all, without
        counting it as dropped."""
        with self._lock:
            self._talk.clear(set)

    # ----------------------------------------------------------------- in the reading thread

    def _receive(self, data: bytes, monotonic: float, clock: float) -> None:
        if data and self._on_bytes is not None:
            self._on_bytes(data)
        with self._lock:
            self._tell(self._talk.receive(data, monotonic, clock))

    def _lose(self, error: BaseException | None) -> None:
        with self._lock:
            if threading.current_thread() is not self._reader:  # of an earlier port
                return
            if error is not None:  # otherwise it was stopped, to close or to reopen the port
                self._give_up(error)
            try:
                self._talk.end(time.monotonic(), time.time())
            finally:
                self._tell(News(True, True))

    def _give_up(self, error: BaseException) -> None:
        with self._lock:
            self._end = self._end or lost(error)
            self._tell(News(True, True))

    def _tell(self, news: News) -> None:
        if news.answers:
            self._answered.notify_all()
        if news.arrivals:
            self._arrived.notify_all()


def deadline_of(timeout: float | None) -> float | None:
    """Returns the time at which a time-out that begins now ends; None for None."""
    if timeout is None:
        return None
    check_seconds(timeout)
    return time.monotonic() + timeout


def lost(error: BaseException) -> PortClosed:
    """Returns the error for a lost port."""
    closed = PortClosed(f"the port is gone: {str(error) or type(error).__name__}")
    closed.__cause__ = error
    return closed


def open_port(
    url: str | os.PathLike[str],
    baud: int | None = USUAL,
    *,
    timeout: float = 1.0,
    capacity: int = CAPACITY,
    on_bytes: Callback | None = None,
    on_skipped: Callback | None = None,
) -> Device:
    """Opens the port of a device: /dev/ttyACM0, COM3, HOST:PORT, rfc2217://HOST:PORT, …

    `baud`: the baud rate; None detects it, if the specification lists rates. The other arguments
    are those of `Device`. All except TCP connections need pyserial, which the extra `serial`
    installs. A serial port is opened exclusively. Raises PortError, an OSError, if the port cannot
    be opened or is in use; NoDevice if no baud rate is found; and MissingExtra without pyserial.
    """
    port = connect(url, baud)
    device = Device(
        port, timeout=timeout, capacity=capacity, on_bytes=on_bytes, on_skipped=on_skipped
    )
    device._again, device._url = partial(open_url, url), os.fspath(url)
    return device


def connect(
    url: str | os.PathLike[str], baud: int | None, wanted: Callable[[], bool] = lambda: True
) -> Any:
    """Opens a URL at the device's baud rate, which is searched until `wanted` returns False."""
    port = open_url(url, USUAL if baud is None else baud)
    # needs: baud rates
    try:
        if baud is None and hasattr(port, "baudrate"):
            detect_baud(port, takewhile(lambda _: wanted(), rates()))
    except BaseException:
        port.close()
        raise
    return port
