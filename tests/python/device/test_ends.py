"""The end of devices and of waits for them: dropped, closed, reopened, cancelled, at ports that accept no bytes."""

from __future__ import annotations

import asyncio
import fcntl
import gc
import os
import socket
import threading
import time
from typing import Any

import mip_protocol as mip
import pytest
import serial
from both import DATA, PING, Kind, running, until, url
from mip_protocol import aio, base, port
from support import PATIENCE, another_python, heavy
from test_requests import inside, python


class Silent:
    """A port at which nothing arrives; it accepts one byte of a packet at a time."""

    def __init__(self, seconds: float = 0.0) -> None:
        self.sent = bytearray()
        self.closed = False
        self.seconds = seconds

    def read(self, size: int) -> bytes:
        time.sleep(0.002)
        return b""

    def write(self, data: bytes) -> int:
        time.sleep(self.seconds)
        self.sent += data[:1]
        return 1

    def close(self) -> None:
        self.closed = True


class Stuck(Silent):
    def write(self, data: bytes) -> int:
        return 0


# --------------------------------------------------------------------------- devices that are not closed


def test_a_dropped_device_closes_its_port(server: socket.socket) -> None:
    """No thread goes on reading the port, which would take data from the next device."""
    device: Any = mip.open_port(url(server), on_skipped=lambda data: None)
    reader = device._reader
    with server.accept()[0] as connection:
        with pytest.warns(ResourceWarning, match="<Device at socket://localhost:.*> is not closed"):
            device = None
        assert not reader.is_alive()
        assert connection.recv(1) == b""


def test_a_dropped_device_for_asyncio_closes_its_port(server: socket.socket) -> None:
    async def main() -> None:
        before = asyncio.all_tasks()
        device: Any = await aio.open_port(url(server), on_skipped=lambda data: None)
        connection, _ = server.accept()
        connection.settimeout(PATIENCE)
        with connection:
            with pytest.warns(ResourceWarning, match="<Device at socket://localhost:.*> is not closed"):
                device = None
            while asyncio.all_tasks() - before:
                await asyncio.sleep(0)
            assert connection.recv(1) == b""
        device = aio.Device(silent := Silent())  # read by a thread
        await device.send(PING)
        with pytest.warns(ResourceWarning, match="is not closed"):
            device = None
            gc.collect()  # the frames of the write refer to the device
        assert silent.closed

    asyncio.run(asyncio.wait_for(main(), 20))


def test_a_device_that_was_not_made_is_not_unclosed(kind: Kind, recwarn: pytest.WarningsRecorder) -> None:
    for wrong in ((object(), {}), (Silent(), {"capacity": 0})):
        with pytest.raises((TypeError, ValueError)):
            kind.at(wrong[0], **wrong[1])
    gc.collect()
    assert not [w for w in recwarn if "Device object" in str(w.message)]


def test_the_end_of_a_program_does_not_wait_for_a_device() -> None:
    code = "from mip_protocol import Device\nimport time\n"
    code += "class Port:\n def read(self, n): time.sleep(0.01); return b''\n def write(self, data): pass\n"
    code += "device = Device(Port())\nprint('end')"
    assert python(code, "-W", "error") == "end"


def test_a_serial_port_is_opened_once(kind: Kind) -> None:
    """Two readers of one port, such as a notebook cell that runs twice, would each get a part of what arrives."""
    master, slave = os.openpty()
    path = os.ttyname(slave)
    try:
        with kind.open(path):
            with pytest.raises(OSError, match="in use by another program, or by an open device of this program"):
                kind.open(path)
            with pytest.raises(serial.SerialException):
                serial.Serial(path, exclusive=True)
        with kind.open(path):
            pass
    finally:
        os.close(slave)
        os.close(master)


# --------------------------------------------------------------------------- ports that take nothing


def test_a_port_that_accepts_no_bytes(kind: Kind, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(port, "WRITE_TIMEOUT", 0.1)
    with kind.at(Stuck()) as device, pytest.raises(mip.PortClosed, match="cannot write: the other end accepts no data"):
        device.request(PING)


def test_a_device_that_is_closed_while_its_port_accepts_no_bytes(kind: Kind, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(port, "WRITE_TIMEOUT", PATIENCE)
    with kind.at(Stuck()) as device:
        ends: list[str] = []

        def ask() -> None:
            with pytest.raises(mip.PortClosed) as caught:
                device.request(PING)
            ends.append(str(caught.value))

        with running(ask):
            until(lambda: inside(device)._writing.locked())
            device.close()
            until(lambda: ends)
        assert ends == ["closed: the device has been closed"]


# --------------------------------------------------------------------------- a healthy port that is opened again


def test_a_healthy_port_that_is_opened_again(kind: Kind, server: socket.socket) -> None:
    """Iterations go on; requests that wait end without an answer."""
    device = kind.open(url(server), timeout=60.0)
    ends: list[Any] = []
    taken: list[Any] = []

    def ask() -> None:
        with pytest.raises(mip.NoAnswer) as caught:
            device.request(PING)
        ends.append(caught.value)

    def take() -> None:
        try:
            taken.extend(device)
        except mip.PortClosed as error:
            ends.append(error)

    with device, server.accept()[0] as first:
        threads = [threading.Thread(target=ask), threading.Thread(target=take)]
        for thread in threads:
            thread.start()
        assert first.recv(100)
        first.sendall(DATA)
        until(lambda: taken)
        if not kind.waits:  # long enough for all threads to see that the port is not there
            again = device._again
            device._again = lambda *rate: (time.sleep(0.1), again(*rate))[1]
        device.reopen()
        with server.accept()[0] as second:
            threads[0].join(PATIENCE)
            assert [e.kind for e in ends] == ["no_answer"] and not device.closed
            second.sendall(DATA)
            until(lambda: len(taken) == 2)
            server.close()
            with pytest.raises(OSError):
                device.reopen(within=0.1)
            threads[1].join(PATIENCE)  # the wait for data ends
            assert device.closed and [e.kind for e in ends] == ["no_answer", "closed"]


# --------------------------------------------------------------------------- cancellations


def test_a_command_that_is_cancelled_is_written_whole() -> None:
    async def main() -> None:
        slow = Silent(0.01)
        async with aio.Device(slow, timeout=PATIENCE) as device:
            first, second = bytes(PING.packet()), bytes(base.SetIdle().packet())
            task = asyncio.ensure_future(device.request(PING))
            while not slow.sent:
                await asyncio.sleep(0.001)
            task.cancel()
            with pytest.raises(asyncio.CancelledError):
                await task
            assert len(slow.sent) < len(first)  # it does not wait for the port
            await device.send(base.SetIdle())
            assert bytes(slow.sent) == first + second

    asyncio.run(main())


def test_opening_that_is_cancelled_ends() -> None:
    """The port is closed again, and no further rate is tried."""
    master, slave = os.openpty()
    written: list[bytes] = []

    def take() -> None:
        try:
            while data := os.read(master, 100):
                written.append(data)
        except OSError:
            pass

    async def main() -> None:
        opening = asyncio.ensure_future(aio.open_port(os.ttyname(slave), None)._open())
        while not written:
            await asyncio.sleep(0.001)
        opening.cancel()
        with pytest.raises(asyncio.CancelledError):
            await opening
        # A lock fails as long as another has the port.
        with open(os.ttyname(slave), "rb") as terminal:
            fcntl.flock(terminal, fcntl.LOCK_EX | fcntl.LOCK_NB)
        await asyncio.sleep(0.7)
        assert len(b"".join(written)) <= 2 * len(bytes(PING.packet()))

    thread = threading.Thread(target=take, daemon=True)
    thread.start()
    try:
        asyncio.run(main())
    finally:
        os.close(slave)
        thread.join(PATIENCE)
        os.close(master)


CANCELLED = """
import asyncio
from mip_protocol import aio, base, sensor

DATA = bytes(sensor.ScaledAccel((1, 2, 3)).packet())

class Writer:
    transport = property(lambda self: self)
    def set_write_buffer_limits(self, high): pass
    def write(self, data): pass
    def close(self): pass
    def abort(self): pass
    async def drain(self): pass
    async def wait_closed(self): pass

# Is a task cancelled so many turns of the loop after data has arrived?
async def cancelled(turns, wait):
    loop, task = asyncio.get_running_loop(), None

    def later(left):
        if left:
            loop.call_soon(later, left - 1)
        else:
            task.cancel()

    reader, seen = asyncio.StreamReader(), []

    def on_bytes(data):
        if not seen:
            seen.append(data)
            later(turns)

    async with aio.Device((reader, Writer()), on_bytes=on_bytes) as device:

        async def run():
            while True:
                await wait(device)

        task = asyncio.ensure_future(run())
        await asyncio.sleep(0.01)
        reader.feed_data(DATA)
        done, _ = await asyncio.wait([task], timeout=20)
        while not task.done():
            task.cancel()
            await asyncio.sleep(0)
        return bool(done)

async def take(device):
    async for _ in device:
        pass

async def main():
    for wait in (take, lambda device: device.next(5)):
        found = []
        for turns in range(7):
            found.append(await cancelled(turns, wait))
        print(found.count(True))

asyncio.run(main())
"""


def test_cancellations_are_not_dropped() -> None:
    """Not even in the turn of the event loop in which the awaited event occurs."""
    assert python(CANCELLED) == "7\n7"


@heavy("other Pythons")
@pytest.mark.parametrize("version", ["3.10", "3.11", "3.12", "3.13"])
def test_cancellations_are_not_dropped_by_others(version: str) -> None:
    assert python(CANCELLED, executable=another_python(version)) == "7\n7"
