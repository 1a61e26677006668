"""Real ports: the virtual device at pseudo-terminals and TCP, faults on the line, pyserial, user-defined ports."""

from __future__ import annotations

import fcntl
import io
import os
import queue
import resource
import socket
import subprocess
import sys
import time
import tty
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

import mip_protocol as mip
import pytest
import serial
from both import DATA, PING, Kind, Peer, acknowledge, running
from mip_protocol import base, mip_3dm, sensor, shared, timestamps, types
from mip_simulator import LivePort
from mip_simulator.device import VirtualDevice
from mip_simulator.endpoints.endpoint import Endpoint, pty_at, tcp_at
from mip_simulator.endpoints.serve import Server
from mip_simulator.faults import Faults
from mip_tools.sentences import Sentences
from support import PATIENCE, ROOT, expected_parse

DEVICE = "3dm-cv7-gnss-ins"
PACKAGE = ROOT / "generated/python"
FAULTS = {
    "lose": 0.03, "change": 0.03, "noise": 0.1, "nmea": 0.1, "false_header": 0.05, "double_packet": 0.03,
    "delay": (0.05, 0.02), "lose_answer": 0.05, "unknown_set": 0.02, "cut": 0.02,
}  # fmt: skip


@contextmanager
def serving(virtual: VirtualDevice, *endpoints: Endpoint, **options: Any) -> Iterator[list[str]]:
    """Serves a device in a thread; yields its URLs."""
    places: list[str] = []
    with Server(virtual, endpoints, ready=places.append, **options) as server, running(server.run):
        try:
            yield [place if place.startswith("/") else f"socket://{place}" for place in places]
        finally:
            server.stop()


def stream(device: Any, rate: int = 100) -> None:
    for command in (
        mip_3dm.MessageFormat.write(0x80, (types.DescriptorRate(0x04, 1000 // rate),)),
        mip_3dm.DataStreamControl.write(0x80, True),
    ):
        insist(device, command)


def insist(device: Any, command: Any) -> Any:
    """Repeats a command until the device answers; faults hit commands and replies."""
    for _ in range(20):
        try:
            return device.request(command)
        except mip.NoAnswer:
            pass
    raise AssertionError("no answer")


# --------------------------------------------------------------------------- faults


@pytest.mark.parametrize("place", ["tcp", "pty"])
def test_nothing_intact_is_lost(kind: Kind, place: str, tmp_path: Path) -> None:
    """All data packets that arrive are handed over in order, with all bytes between them, while commands run."""
    came, between = bytearray(), bytearray()
    virtual = VirtualDevice(DEVICE, faults=Faults(seed=3, **FAULTS))
    endpoint = tcp_at("localhost:0") if place == "tcp" else pty_at(str(tmp_path / "port"))
    options: dict[str, Any] = {"timeout": 0.2, "on_bytes": came.extend, "on_skipped": between.extend}
    with serving(virtual, endpoint) as (url,), kind.open(url, **options) as device:
        assert repr(getattr(device, "device", device)) == f"<Device at {url}>"
        stream(device)
        for _ in range(8):
            assert insist(device, base.GetDeviceInfo()).device_info.model_name.strip()
            assert insist(device, mip_3dm.GetBaseRate(0x80)).rate == 1000
            time.sleep(0.05)
        insist(device, base.SetIdle())
        arrivals = drain(device)
        assert device.dropped == 0
    assert repr(getattr(device, "device", device)).endswith(", closed>")
    found = expected_parse(bytes(came))
    data = [p for p in found["packets"] if int(p[4:6], 16) >= 0x80]
    assert [bytes(a.packet).hex() for a in arrivals if a.packet.set >= 0x80] == data and len(data) > 40
    assert len(between) == found["skipped"] > 0
    assert Sentences().feed(bytes(between))


def drain(device: Any) -> list[mip.Arrival]:
    found = []
    while (arrival := device.next(0.3)) is not None:
        found.append(arrival)
    return found


# --------------------------------------------------------------------------- pyserial


@pytest.mark.parametrize("timeout", [None, 0, 0.01, PATIENCE])
def test_serial_ports_with_any_time_out(kind: Kind, timeout: float | None, tmp_path: Path) -> None:
    """A reply is returned at once, and a missing one is noticed."""
    endpoint = pty_at(str(tmp_path / "port"))
    with (
        serving(VirtualDevice(DEVICE), endpoint) as (path,),
        kind.at(serial.Serial(path, timeout=timeout), timeout=PATIENCE) as device,
    ):
        started = time.monotonic()
        for _ in range(10):
            device.request(base.GetDeviceInfo())
        assert time.monotonic() - started < PATIENCE
        with pytest.raises(mip.NoAnswer):
            device.request(base.BuiltInTest(), timeout=0.0)  # takes two seconds, so its reply is certainly late
        stream(device)
        sets = [device.next(5).packet.set for _ in range(10)]
        assert sets == [1] + [0x80] * 9  # the answer that came too late is not lost


@pytest.mark.parametrize(("options", "answers"), [("", True), (", timeout=0", False), (", timeout=1000", True)])
def test_the_loop_of_the_readme_at_a_serial_port(options: str, answers: bool, tmp_path: Path) -> None:
    """It neither hangs nor waits for bytes that do not arrive, whatever the time-out of the port."""
    text = (PACKAGE / "README.md").read_text("utf-8")
    program = text.split("## Commands")[1].split("```python\n")[1].split("```")[0]
    opening = 'serial.Serial("/dev/ttyACM0", 115200)'
    assert opening in program
    faults = None if answers else Faults(lose_answer=1.0)
    with serving(VirtualDevice(DEVICE, faults=faults), pty_at(str(tmp_path / "port"))) as (path,):
        program = program.replace(opening, f'serial.Serial("{path}", 115200{options})')
        environment = {**os.environ, "PYTHONPATH": str(PACKAGE)}
        done = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, timeout=PATIENCE, env=environment
        )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("base.get_device_info_response: " if answers else "no answer to base.get_device_info")


def blocks() -> list[str]:
    section = (PACKAGE / "README.md").read_text("utf-8").split("## A device")[1].split("\n## ")[0]
    return [part.split("```")[0] for part in section.split("```python\n")[1:]]


@pytest.mark.parametrize("number", [0, 1])
def test_the_programs_of_the_readme(number: int) -> None:
    program = blocks()[number]
    virtual = VirtualDevice(DEVICE)
    link = virtual.connect()
    if number == 1:  # it reads what the device already sends
        link.write(bytes(mip_3dm.MessageFormat.write(0x80, (types.DescriptorRate(0x04, 100),)).packet()))
        link.write(bytes(mip_3dm.DataStreamControl.write(0x80, True).packet()))
    with serving(virtual, tcp_at("localhost:0")) as (url,):
        opened = '"/dev/ttyACM0"' if number == 0 else '"socket://localhost:5000"'
        assert opened in program
        process = subprocess.Popen(
            [sys.executable, "-uc", program.replace(opened, repr(url))], stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONPATH": str(PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"},
        )  # fmt: skip
        assert process.stdout is not None
        try:
            lines = [process.stdout.readline() for _ in range(4)]
        finally:
            process.terminate()
            process.communicate()
    assert lines[0].strip() == "3DM-CV7-GNSS/INS"
    assert all("-1.0" in line or "-0.99" in line for line in lines[1:]), lines


# --------------------------------------------------------------------------- baud rates


def at_rate(rate: int) -> VirtualDevice:
    """A device whose port has this baud rate."""
    virtual = VirtualDevice(DEVICE)
    link = virtual.connect("UART 1")
    link.write(bytes(base.CommSpeed.write(0x11, rate).packet()))
    virtual.advance(0.1)
    virtual.disconnect(link)
    return virtual


@pytest.mark.parametrize("rate", [115200, 230400])
def test_a_rate_is_found(kind: Kind, rate: int, tmp_path: Path) -> None:
    endpoint = pty_at(str(tmp_path / "port"), "UART 1")
    with serving(at_rate(rate), endpoint, strict_baud=True) as (path,), kind.open(path, None) as device:
        assert device.baud == rate
        device.request(PING)


@pytest.mark.parametrize("idle", [True, False])
def test_a_rate_is_changed(kind: Kind, idle: bool, tmp_path: Path) -> None:
    endpoint = pty_at(str(tmp_path / "port"), "UART 1")
    with serving(VirtualDevice(DEVICE), endpoint, strict_baud=True) as (path,), kind.open(path) as device:
        stream(device)
        if idle:
            device.request(base.SetIdle())
        assert device.change_baud(mip_3dm.UartBaudRate.write(921600)) == 921600 == device.baud
        assert device.change_baud(base.CommSpeed.write(0x11, 230400)) == 230400 == device.baud
        assert device.request(mip_3dm.UartBaudRate.read()).baud == 230400
        assert device.change_baud(base.CommSpeed.write(0x12, 4800), attempts=1) == 230400 == device.baud
        with pytest.raises(mip.Refused):
            device.change_baud(mip_3dm.UartBaudRate.write(77))
        with pytest.raises(ValueError, match="writes `baud`"):
            device.change_baud(PING)
        assert device.baud == 230400
        device.request(PING)


# --------------------------------------------------------------------------- ports of one's own


class Answering:
    """Answers each command at once. `read` returns at once, too."""

    nothing: Any = b""

    def __init__(self) -> None:
        self.out = b""

    def write(self, data: bytes) -> Any:
        self.out += acknowledge(data[2], data[5])

    def read(self, size: int) -> Any:
        data, self.out = self.out[:size], self.out[size:]
        return data or self.nothing


class WithoutWaiting(Answering):
    """Like raw files in non-blocking mode."""

    nothing = None


class Slowly(Answering):
    """Writes and reads one byte at a time."""

    def __init__(self) -> None:
        super().__init__()
        self.taken = b""

    def write(self, data: bytes) -> int:
        self.taken += data[:1]
        if len(self.taken) == 8:
            super().write(self.taken)
            self.taken = b""
        return 1

    def read(self, size: int) -> Any:
        return super().read(1)


class Blocking:
    """Waits for ever, until it is closed."""

    def __init__(self) -> None:
        self.queue: queue.Queue[bytes | None] = queue.Queue()

    def write(self, data: bytes) -> int:
        self.queue.put(acknowledge(data[2], data[5]) if data[5] == 1 else b"")
        return len(data)

    def read(self, size: int) -> bytes:
        data = self.queue.get()
        if data is None:
            raise OSError("closed")
        return data

    def close(self) -> None:
        self.queue.put(None)


class Changing(Answering):
    """Has a rate; notes when it is written to."""

    baudrate = 115200

    def __init__(self) -> None:
        super().__init__()
        self.written: list[float] = []

    def write(self, data: bytes) -> None:
        self.written.append(time.monotonic())
        super().write(data)


def test_a_device_has_time_to_change_its_rate(kind: Kind) -> None:
    """As the manuals require, nothing is sent meanwhile."""
    port = Changing()
    with kind.at(port) as device:
        assert device.change_baud(mip_3dm.UartBaudRate.write(921600)) == 921600 == port.baudrate
    command, ping = port.written
    assert ping - command >= 0.25


@pytest.mark.parametrize("port", [Answering, WithoutWaiting, Slowly, Blocking])
def test_ports_of_ones_own(kind: Kind, port: Any) -> None:
    with kind.at(port()) as device:
        for _ in range(3):
            device.request(PING)
    assert device.closed


def test_a_port_that_waits_for_ever(kind: Kind) -> None:
    """A missing answer is noticed while the port is being read."""
    with kind.at(Blocking(), timeout=0.05) as device, pytest.raises(mip.NoAnswer):
        device.request(base.SetIdle())


class Buffered:
    """Reads through a buffer."""

    def __init__(self, file: Any) -> None:
        reader = io.BufferedReader(file)
        self.read, self.read1, self.write, self.close = reader.read, reader.read1, file.write, file.close


@pytest.mark.parametrize("buffered", [False, True])
def test_files(kind: Kind, buffered: bool) -> None:
    """A terminal opened with `open`; a buffer must not wait for all bytes."""
    master, slave = os.openpty()
    tty.setraw(slave)
    file: Any = open(os.ttyname(slave), "r+b", buffering=0)  # noqa: SIM115  # the device closes it
    if buffered:
        file = Buffered(file)
    with kind.at(file) as device:
        with running(lambda: os.read(master, 100) and os.write(master, DATA + acknowledge(1, 1))):
            device.request(PING)
        assert bytes(device.next(5).packet) == DATA
        os.write(master, DATA)  # so that the read ends
        os.close(slave)
    os.close(master)


class Failing(Answering):
    def write(self, data: bytes) -> Any:
        raise OSError("cannot write")


def test_a_port_that_cannot_write(kind: Kind) -> None:
    with kind.at(Failing()) as device:
        with pytest.raises(mip.PortClosed, match="the port cannot write: cannot write"):
            device.request(PING)
        with pytest.raises(mip.PortClosed):
            device.send(PING)
        with pytest.raises(mip.PortClosed):
            device.write(b"x")


def test_a_socket_beyond_the_thousandth_file(peer: Peer) -> None:
    """`select` accepts no file descriptor from 1024 on; a program with many devices has such."""
    limits = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(limits[0], min(2048, limits[1])), limits[1]))
    near = socket.socket(fileno=fcntl.fcntl(peer.near, fcntl.F_DUPFD, 1024))
    try:
        peer.answering(acknowledge(0x01, 0x01))
        with mip.Device(near, timeout=PATIENCE) as device:
            assert device.request(PING) is None
    finally:
        near.close()
        peer.near.close()
        resource.setrlimit(resource.RLIMIT_NOFILE, limits)


# --------------------------------------------------------------------------- a simulated device without a connection


@pytest.mark.parametrize("speed", [1.0, 20.0])
def test_a_live_port(kind: Kind, speed: float) -> None:
    """Its time passes at its speed; bytes are neither lost nor late."""
    virtual = VirtualDevice(DEVICE)
    began, now = time.monotonic(), virtual.now
    with kind.at(LivePort(virtual, speed=speed)) as device:
        assert device.request(base.GetDeviceInfo()).device_info.model_name.strip()
        stream(device)
        fields = device.fields(sensor.ScaledAccel)
        for _ in range(30):
            next(fields)
            device.request(PING)
        advanced = (virtual.now - now) / 1e9
        assert 0.25 < advanced < (time.monotonic() - began) * speed
        assert device.dropped == device.skipped == 0
    assert virtual.links == [] and device.closed


def test_a_live_port_that_the_device_closes() -> None:
    virtual = VirtualDevice(DEVICE)
    with mip.Device(port := LivePort(virtual, "Main")) as device:
        device.request(PING)
        virtual.disconnect(port._link)
        with pytest.raises(mip.PortClosed):
            device.next(20)
    for speed in (0, -1, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="must be above 0"):
            LivePort(virtual, speed=speed)
    assert virtual.links == []


def test_a_live_port_reads_no_more_than_it_is_asked_for() -> None:
    port = LivePort(VirtualDevice(DEVICE))
    port.write(bytes(PING.packet()))
    parts = [port.read(4), port.read(100)]
    assert b"".join(parts) == acknowledge(1, 1) and len(parts[0]) == 4
    port.close()


# --------------------------------------------------------------------------- the time of the device


def test_the_time_of_the_device(kind: Kind) -> None:
    """In UTC if its clock has a date; otherwise since the start of the clock."""
    start = round(
        (datetime(2024, 5, 1, tzinfo=timezone.utc) - datetime(1980, 1, 6, tzinfo=timezone.utc)).total_seconds()
    )
    virtual = VirtualDevice(DEVICE, start=(start + 18) * 10**9)  # GPS time is ahead of UTC
    with kind.at(LivePort(virtual)) as device:
        entries = tuple(types.DescriptorRate(d, 100) for d in (0xD3, 0xD5, 0x04))
        device.request(mip_3dm.MessageFormat.write(0x80, entries))
        device.request(mip_3dm.DataStreamControl.write(0x80, True))
        arrival = device.next(20)
    stamp = arrival.find(shared.GpsTimestamp)
    utc = arrival.device_time()
    assert utc == timestamps.time_of(stamp) == timestamps.moments(arrival.packet)["gps"]
    day = datetime(2024, 5, 1, tzinfo=timezone.utc).timestamp() * 10**9
    assert day < utc < day + 60 * 10**9
    assert arrival.device_time("reference") == arrival.find(shared.ReferenceTimestamp).nanoseconds
    assert arrival.device_time("external") is None
    with pytest.raises(ValueError, match="'utc' is not a clock; use one of gps, external, reference"):
        arrival.device_time("utc")
    assert timestamps.time_of(stamp.__replace__(valid_flags=0)) is None
    with pytest.raises(ValueError, match=r"sensor.scaled_accel does not contain the time of its packet"):
        timestamps.time_of(arrival.find(sensor.ScaledAccel))
    assert mip.Arrival(mip.Packet(DATA), 0.0, 0.0).device_time() is None
