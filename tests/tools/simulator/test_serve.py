"""Serving: terminals, connections, time, slow clients, baud rates; the command line."""

from __future__ import annotations

import os
import re
import select
import shlex
import signal
import socket
import subprocess
import sys
import termios
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from mip_protocol import Parser, base, devices, mip_3dm, registry, types
from mip_protocol.devices import Device
from mip_protocol.field import Command, Data, Response
from mip_protocol.protocol import VERSION
from mip_simulator.device import VirtualDevice
from mip_simulator.endpoints.channel import CAPACITY, Channel
from mip_simulator.endpoints.endpoint import Endpoint, Pty, pty_at, tcp_at
from mip_simulator.endpoints.serve import Server
from mip_simulator.faults import Faults
from mip_tools import __main__, __version__, commands
from mip_tools.errors import Failure
from program import DEVICE, PATIENCE, mip, run, running, until
from support import PYTHONPATH

SURE = len(devices.DEVICES[DEVICE].certain)
CERTAIN = f"mip simulate: 3DM-CV7-GNSS/INS: {SURE} commands and data fields are certain, 0 likely, 0 assumed"
PING = bytes(base.Ping().packet())
ACKNOWLEDGE = bytes.fromhex("7565010404f10100d56a")


def stream(rate: int = 100) -> bytes:
    """Commands that start a stream."""
    entry = types.DescriptorRate(0x04, 1000 // rate)
    wanted = (mip_3dm.MessageFormat.write(0x80, (entry,)), mip_3dm.DataStreamControl.write(0x80, True))
    return b"".join(bytes(command.packet()) for command in wanted)


@contextmanager
def serving(device: Any, *endpoints: Endpoint, speed: float = 1.0, **options: Any) -> Iterator[Any]:
    """A server in a thread. Its `places` are where clients find it, its `complaints` are its messages."""
    places: list[str] = []
    complaints: list[str] = []
    failures: list[BaseException] = []
    server: Any = Server(device, endpoints, speed, ready=places.append, complain=complaints.append, **options)
    server.places, server.complaints = places, complaints

    def run() -> None:
        try:
            server.run()
            server.close()
        except BaseException as error:  # shown at the end
            failures.append(error)

    with server:
        thread = Thread(target=run, daemon=True)
        thread.start()
        server.thread = thread
        try:
            yield server
        finally:
            server.stop()
            thread.join(PATIENCE)
    assert not thread.is_alive() and not failures, failures


def said(lines: Iterable[str]) -> list[str]:
    """The messages, without those of a machine that is too busy for real time."""
    return [line for line in lines if not re.search(r"cannot keep up|simulated time ends", line)]


class Client:
    """A program at a terminal or a connection."""

    def __init__(self, place: str, room: int = 0) -> None:
        """`room`: how many bytes the system should buffer for it; 0: its default."""
        self.socket = None
        if place.startswith("/"):
            self.file = os.open(place, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        else:
            host, _, number = place.rpartition(":")
            self.socket = socket.socket()
            if room:
                self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, room)
            self.socket.connect((host, int(number)))
            self.socket.setblocking(False)
            self.file = self.socket.fileno()
        self.parser = Parser()
        self.received = b""
        self.packets: list[bytes] = []

    def __enter__(self) -> Client:
        return self

    def __exit__(self, *_: object) -> None:
        if self.socket is not None:
            self.socket.close()
        else:
            os.close(self.file)

    def send(self, data: bytes) -> None:
        assert os.write(self.file, data) == len(data)

    def read(self) -> bytes | None:
        """What has arrived; None at the end."""
        if not select.select([self.file], [], [], 0.05)[0]:
            return b""
        try:
            data = os.read(self.file, 65536)
        except BlockingIOError:
            return b""
        except OSError:
            return None
        self.received += data
        self.packets += [bytes(p) for p in self.parser.feed(data)]
        return data or None

    def wait(self, condition: Callable[[], Any]) -> None:
        until(lambda: (self.read(), condition())[1])

    def ask(self, data: bytes, answer: bytes = ACKNOWLEDGE) -> None:
        before = self.packets.count(answer)
        self.send(data)
        self.wait(lambda: self.packets.count(answer) > before)

    def at_end(self) -> bool:
        return until(lambda: self.read() is None)


# --------------------------------------------------------------------------- terminals


class EchoLink:
    def __init__(self, baud: int | None) -> None:
        self.closed = False
        self.baud = baud
        self.waiting = b""

    def write(self, data: bytes) -> None:
        self.waiting += data

    def read(self) -> bytes:
        data, self.waiting = self.waiting, b""
        return data


def test_a_terminal_shows_the_baud_rate() -> None:
    device = VirtualDevice(DEVICE)
    with serving(device, Endpoint("pty", port="UART 1")) as server, Client(server.places[0]) as client:
        rate = until(lambda: device.links and device.links[0].baud)
        until(lambda: termios.tcgetattr(client.file)[5] == getattr(termios, f"B{rate}"))
        client.send(bytes(mip_3dm.UartBaudRate.write(921600).packet()))  # of the main port, or of this one
        client.send(bytes(base.CommSpeed.write(0x11, 921600).packet()))
        client.wait(lambda: termios.tcgetattr(client.file)[5] == termios.B921600)


# --------------------------------------------------------------------------- connections


def test_several_clients_of_several_ports() -> None:
    device = VirtualDevice(DEVICE)
    with serving(device, tcp_at("0"), tcp_at("127.0.0.1:0", "USB 1"), pty_at("")) as server:
        first, second, third = server.places
        assert re.fullmatch(r"localhost:\d+", first) and re.fullmatch(r"127\.0\.0\.1:\d+", second)
        with Client(first) as a, Client(first) as b, Client(second) as c, Client(third) as d:
            for client in (a, b, c, d):
                client.ask(PING)
            assert sorted(link.port for link in device.links) == ["Main", "Main", "Main", "USB 1"]
            assert [x.packets for x in (a, b, c, d)] == [[ACKNOWLEDGE]] * 4  # replies go to the client that has asked
            a.send(stream())
            for client in (a, b, c, d):  # data go to all
                client.wait(lambda client=client: len(client.packets) > 5)
        until(lambda: len(device.links) == 1)  # those who left are forgotten; the terminal stays


def test_too_many_clients_are_turned_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mip_simulator.endpoints.serve.CLIENTS", 1)
    with serving(VirtualDevice(DEVICE), tcp_at("0")) as server, Client(server.places[0]) as first:
        first.ask(PING)
        with Client(server.places[0]) as second:
            assert second.at_end()
        first.ask(PING)
        assert "is turned away: 1 clients are connected" in said(server.complaints)[0]


def test_a_link_that_a_killed_simulator_has_left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The system may assign the same terminal again, to which the old link then leads."""
    files = os.openpty()
    path = tmp_path / "mip"
    path.symlink_to(os.ttyname(files[1]))
    with pytest.raises(Failure, match="perhaps of another simulator"):
        Pty(str(path))
    monkeypatch.setattr(os, "openpty", lambda: files)
    terminal = Pty(str(path))
    assert os.readlink(path) == terminal.name
    terminal.close()
    assert not path.is_symlink()


# --------------------------------------------------------------------------- slow clients


def test_a_client_that_never_reads(tmp_path: Path) -> None:
    """Its queue is bounded, it is reported, and others lose nothing; the packets that it reads are whole."""
    device = VirtualDevice(DEVICE)
    with serving(device, tcp_at("0"), pty_at(""), speed=50) as server:  # noqa: SIM117
        with Client(server.places[0]) as reader, Client(server.places[0]) as idle, Client(server.places[1]) as terminal:
            reader.send(stream(1000))
            lazy = until(lambda: [c for c in server._channels if c.dropped > 300])
            reader.wait(lambda: len(reader.packets) > 5000)
            assert all(c.size <= CAPACITY for c in server._channels)
            for client in (idle, terminal):
                client.wait(lambda client=client: len(client.packets) > 100)
                assert client.parser.skipped == 0 and reader.parser.skipped == 0
            assert lazy
    assert any(re.search(r": \d+ packets dropped, as no client read them in time$", x) for x in server.complaints)


class Peer:
    """A client that accepts as much as the test allows."""

    speed: int | None = None
    unread = 0

    def flushed(self) -> bool:
        return False

    def __init__(self, room: int = 0) -> None:
        self.room = room
        self.received = b""
        self.shown: list[int] = []

    def write(self, data: Any) -> int:
        taken = bytes(data)[: self.room]
        if not taken:
            raise BlockingIOError
        self.room -= len(taken)
        self.received += taken
        return len(taken)

    def read(self) -> bytes:
        return b"\x55" * 8

    def set_speed(self, baud: int) -> None:
        self.shown.append(baud)


def numbered(number: int) -> bytes:
    return bytes(mip_3dm.GetBaseRate(number % 256).packet()) * 10


def test_what_came_while_nobody_had_a_terminal_open_is_discarded() -> None:
    """A client that opens it, and clears its buffer as pyserial does, gets what is sent from then on."""
    terminal, link = Pty(""), EchoLink(None)
    channel = Channel(terminal, link, None, 0.0)

    def turn(number: int) -> None:
        link.write(numbered(number))
        channel.collect()
        channel.send(0.0)

    for number in range(1300):  # more than the system may buffer
        turn(number % 255)
    turn(255)
    assert channel.size > 5_000
    with Client(terminal.name) as client:
        client.wait(lambda: numbered(0) in client.received)
        assert channel.size > 5_000
        termios.tcflush(client.file, termios.TCIFLUSH)
        client.received = b""
        turn(77)
        assert channel.size < 5_000
        turn(78)
        # Perhaps after what the system had already buffered, but not after the queue.
        client.wait(lambda: client.received.endswith(numbered(78)))
        assert numbered(255) not in client.received
        client.send(b"to the device")
        until(lambda: select.select([terminal], [], [], 0)[0])
        assert channel.receive() and link.read() == b"to the device"
    terminal.close()


def test_dropped_packets_are_counted_and_whole() -> None:
    peer, link = Peer(15), EchoLink(None)
    channel = Channel(peer, link, None, 0.0, capacity=10 * len(numbered(0)))
    for number in range(100):
        link.write(numbered(number))
        channel.collect()
        assert channel.send(0.0) is None and channel.size <= 10 * len(numbered(0))
    assert channel.dropped == 10 * (100 - 10)  # of a hundred pieces, the first has begun, and nine of the last fit
    peer.room = 10**6
    assert channel.send(0.0) == float("inf") and channel.size == 0
    kept = [number for number in range(100) if numbered(number) in peer.received]
    assert peer.received == b"".join(numbered(number) for number in kept) and kept == [0, *range(91, 100)]


# --------------------------------------------------------------------------- baud rates


def test_the_baud_rate_limits_what_passes() -> None:
    """11520 bytes in a second, and no more than a moment's worth at once."""
    peer, link = Peer(10**6), EchoLink(115200)
    channel = Channel(peer, link, lambda data: data, pace=1.0)
    link.write(bytes(20000))
    now, goes = 0.0, 0
    channel.collect()
    while (more := channel.send(now)) != float("inf"):
        assert more is not None and now < more < now + 0.1
        assert len(peer.received) <= 11520 * (now + 0.006)
        now, goes = more, goes + 1
    assert 1.7 < now < 1.75 and goes > 100
    peer.received = b""
    link.write(bytes(20000))
    channel.collect()
    channel.send(1000.0)
    assert len(peer.received) <= 11520 * 0.006, "a line that was idle saves nothing up"


def test_a_wrong_baud_rate_garbles_both_ways() -> None:
    peer, link = Peer(10**6), EchoLink(115200)
    channel = Channel(peer, link, lambda data: b"?" * len(data), pace=0.0)
    for speed, data in ((9600, b"?" * 8), (115200, b"\x55" * 8), (None, b"\x55" * 8)):
        peer.speed, peer.received = speed, b""
        channel.collect()
        assert channel.receive() and link.waiting == data
        channel.collect()
        channel.send(0.0)
        assert peer.received == data and not peer.shown  # the rate is the client's own
    peer.speed, peer.received, link.waiting, link.baud = 115200, b"", b"ACK", 9600
    channel.collect()
    link.waiting = b"data"
    channel.collect()
    channel.send(0.0)
    assert peer.received == b"ACK????", "the ACK of a change still has the old rate"


def test_strict_rates_of_a_terminal() -> None:
    device = VirtualDevice(DEVICE)
    with (
        serving(device, Endpoint("pty", port="UART 1"), strict_baud=True) as server,
        Client(server.places[0]) as client,
    ):
        rate = until(lambda: device.links and device.links[0].baud)
        mode = termios.tcgetattr(client.file)
        for speed, good in ((termios.B9600, False), (getattr(termios, f"B{rate}"), True)):
            mode[4] = mode[5] = speed
            termios.tcsetattr(client.file, termios.TCSANOW, mode)
            received = device.bytes_received
            if good:
                client.ask(bytes(64) + PING)  # zeros end what garbage may have begun
            else:
                client.send(PING)
                until(lambda received=received: device.bytes_received == received + len(PING))
                assert ACKNOWLEDGE not in client.packets


# --------------------------------------------------------------------------- time


@pytest.mark.parametrize(("speed", "duration", "least"), [(40, 8.0, 0.2), (0, 0.3, 0.3)])
def test_time_passes_at_the_speed_that_is_wanted(speed: float, duration: float, least: float) -> None:
    """As fast as clients read, it is real while there is nothing to read."""
    device = VirtualDevice(DEVICE)
    begun = time.monotonic()
    with serving(device, tcp_at("0"), speed=speed, duration=duration) as server:
        server.thread.join(PATIENCE)
    assert device.now == round(duration * 1e9) and time.monotonic() - begun >= least


def test_as_fast_as_clients_read() -> None:
    """No packet is dropped, however slow the client is: time stands still while it does not read."""
    device = VirtualDevice(DEVICE)
    with serving(device, tcp_at("0"), speed=0, duration=40.0) as server, Client(server.places[0], 4096) as client:
        client.send(stream(500))
        (channel,) = until(lambda: [c for c in server._channels if c.size >= CAPACITY // 2])
        now = until(lambda: (device.now, time.sleep(0.05))[0] == device.now and device.now)
        assert 0 < now < 40e9 and channel.size < CAPACITY
        assert client.at_end()
        data = [p for p in client.packets if p[2] == 0x80]
        assert 19000 <= len(data) <= 20000 and client.parser.skipped == 0 and not server.complaints
        assert device.now == 40_000_000_000


def test_time_that_cannot_be_caught_up_is_given_up() -> None:
    ahead = 0.0
    device = VirtualDevice(DEVICE)
    with serving(device, tcp_at("0"), clock=lambda: time.monotonic() + ahead) as server:  # noqa: SIM117
        with Client(server.places[0]) as client:
            client.send(stream(1000))
            client.wait(lambda: len(client.packets) > 10)
            ahead = 86400.0  # the machine was asleep
            client.ask(PING)
            until(lambda: server.complaints)
            now = device.now
            until(lambda: device.now > now + 3e8)
            assert device.now < 60e9  # it goes on from where it was, at its own pace
    # Reported once; the client does not read meanwhile, which may be reported, too.
    assert server.complaints.count("the machine cannot keep up; simulated time is late from here on") == 1
    (ended,) = (x for x in server.complaints if "ends" in x)
    assert re.fullmatch(r"simulated time ends 86\d{3}\.\d s late", ended)


# --------------------------------------------------------------------------- disconnection


@pytest.mark.parametrize("endpoint", [tcp_at("0"), pty_at("")])
def test_the_device_disconnects_and_comes_back(endpoint: Endpoint) -> None:
    """Everything that was sent before can be read."""
    log: list[Any] = []
    faults = Faults(log=log.append, every_packet=True, script=["disconnect@3"])
    device = VirtualDevice(DEVICE, faults=faults)
    with serving(device, endpoint) as server, Client(server.places[0]) as client:
        client.send(stream(1000))
        assert client.at_end()
        sent = [entry.packet for entry in log if entry.kind == "sent"]
        kinds = [entry.kind for entry in log]
        assert client.packets == sent[: kinds.index("disconnect")] and len(client.packets) > 10
        place = server.places[0] if endpoint.kind == "tcp" else until(lambda: server.places[1:])[0]
        with Client(place) as again:
            again.ask(PING)


# --------------------------------------------------------------------------- command line


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_the_program_ends_cleanly(number: int, tmp_path: Path) -> None:
    path = tmp_path / "mip"
    with running("simulate", DEVICE, "--pty", path, "--tcp", "0", "--storage", tmp_path / "kept", text=True) as process:
        assert process.stdout is not None
        places = [process.stdout.readline().strip() for _ in range(2)]
        assert places[0] == str(path)
        for place in places:
            with Client(place) as client:
                client.ask(PING)
        process.send_signal(number)
        out, error = process.communicate(timeout=PATIENCE)
        assert (out, said(error.splitlines()), process.returncode) == ("", [CERTAIN], 0)
    assert not path.is_symlink() and not list(tmp_path.glob("*.part"))


def test_faults_of_the_program(tmp_path: Path) -> None:
    log = tmp_path / "log"
    options = ["--fault", "lose_answer@1,nmea=1", "--fault", "unknown_set@2", "--strict-baud", "--noise", "0"]
    with running("simulate", DEVICE, "--tcp", "0", *options, "--fault-log", log, "--log-packets", text=True) as process:
        assert process.stdout is not None
        with Client(process.stdout.readline().strip()) as client:
            client.send(PING)
            until(lambda: "lose_answer" in log.read_text())
            client.send(PING + PING)
            client.wait(lambda: len(client.packets) > 2)
        process.terminate()
        process.wait(PATIENCE)
    text = log.read_text()
    assert [kind in text for kind in ('"sent"', '"nmea"', '"unknown_set"')] == [True] * 3
    assert all(line.startswith('{"time": ') for line in text.splitlines())


def counts(device: Device) -> str:
    """The numbers of commands and data fields that a device may have, in words."""
    listed = device.fields
    roles = {(number, t.DESCRIPTOR): t for number, t in registry.all_types() if not issubclass(t, Response)}
    commands = sum(issubclass(roles[key], Command) for key in listed)
    data = sum(issubclass(roles[key], Data) for key in listed)
    return f"{commands} command{'s' * (commands != 1)}, {data} data field{'s' * (data != 1)}"


def test_the_list_of_devices(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "fields", "--devices")
    lines = out.splitlines()
    assert code == 0 and [line.split()[0] for line in lines] == list(devices.DEVICES)
    for line, device in zip(lines, devices.DEVICES.values(), strict=True):
        incomplete = f" (incomplete: {counts(device)})" if device.incomplete else ""
        assert line.endswith(device.title + incomplete)


def test_an_incomplete_profile_is_said_to_be_so(capsys: pytest.CaptureFixture[str]) -> None:
    known = next(d for d in devices.DEVICES.values() if d.incomplete)
    code, out, error = run(capsys, "simulate", known.id, "--tcp", "0", "--duration", "0.01")
    assert code == 0 and out.startswith("localhost:")
    line = f"the profile of {known.title} is incomplete ({counts(known)}): {' '.join(known.incomplete)}"
    assert error.splitlines()[1] == f"mip simulate: {line}"


def test_help(capsys: pytest.CaptureFixture[str]) -> None:
    """What stands beside the help of each command, which test_program.py has."""
    code, out, _ = run(capsys)
    assert code == 0 and all(f"  {name} " in out and text in out for name, text in __main__.COMMANDS.items())
    version = f"mip {__version__}, mip_protocol {VERSION}; logs are read with NumPy"
    assert run(capsys, "--version")[1].startswith(version)
    examples = re.findall(r'^  mip simulate (\S+) .*?--port "(.*?)=', run(capsys, "simulate", "--help")[1], re.M)
    assert examples and all(port in {p.name for p in devices.DEVICES[device_id].ports} for device_id, port in examples)


def test_it_starts_with_the_standard_library_alone() -> None:
    """NumPy, which only the replay of a log needs, takes as long to import as all else."""
    assert "--motion" in mip("simulate", "--help", extras=False)[1]


def test_without_the_simulator(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """It is a distribution of its own; what reads logs is installed without it."""

    def absent(*_: Any) -> None:
        raise ModuleNotFoundError(name="mip_simulator")

    monkeypatch.setattr(commands, "import_module", absent)
    line = "mip-simulator is missing; pip install mip-simulator, or from a checkout ./tools/mip_simulator"
    assert run(capsys, "simulate", DEVICE) == (1, "", f"mip simulate: {line}\n")


def test_an_interrupt_while_it_starts(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    def interrupted(*_: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(commands, "import_module", interrupted)
    assert run(capsys, "simulate", DEVICE) == (130, "", "")


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ("", "the device is missing; `mip fields --devices` lists them"),
        ("3dm-gx5-16", "'3dm-gx5-16' is not a device; did you mean 3dm-gx5-15, "),
        ("CV7-GNSS", "'CV7-GNSS' is not a device; did you mean 3dm-cv7-gnss-ins or "),
        ("3DM-GX5-10", "only the name of the 3DM-GX5-10 is known; choose 3dm-cx5-10, the device most like it"),
        ("toaster", "'toaster' is not a device; `mip fields --devices` lists them all"),
        ("DEVICE --tcp 70000", "'70000' is not a TCP port; write PORT or HOST:PORT"),
        ("DEVICE --tcp localhost", "'localhost' is not a TCP port; "),
        ("DEVICE --tcp 'no such host:1'", "host 'no such host' is unknown; use localhost"),
        ("DEVICE --tcp 192.0.2.1:0", "192.0.2.1 is not an address of this machine; use localhost"),
        ("DEVICE --tcp A_PORT", "TCP port A_PORT is in use; end the program that uses it, or choose another: --tcp "),
        ("DEVICE --pty A_FILE", "A_FILE exists; choose another path, or remove it"),
        ("DEVICE --pty A_LINK", "A_LINK is a link to something else; choose another path, or remove it"),
        ("DEVICE --pty A_TERMINAL", "A_TERMINAL leads to /dev/tty, perhaps of another simulator; end that one, "),
        ("DEVICE --pty A_FILE/x", "A_FILE/x cannot be created: Not a directory; choose another path"),
        ("DEVICE --pty x --port 'USB 1=pty:x'", "x is given for two terminals; choose different paths"),
        ("DEVICE --port 'USB 9=tcp:0'", "3DM-CV7-GNSS/INS has no port 'USB 9'; its ports: Main, UART 1, "),
        ("DEVICE --port 'USB 1'", "'USB 1' cannot be read; write NAME=pty:PATH, NAME=tcp:[HOST:]PORT or NAME=udp"),
        ("DEVICE --fault loose=1", "fault 'loose' is unknown; do you mean 'lose'? known faults: "),
        ("DEVICE --log-packets", "--log-packets needs a file; add --fault-log FILE"),
        ("DEVICE --fault-log A_FILE", "A_FILE is not a log of faults; name another file"),
        ("DEVICE --fault-log A_FILE/x", "A_FILE/x cannot be written: Not a directory"),
        ("DEVICE --storage A_FILE/x", "A_FILE/x cannot be written: Not a directory; name another file"),
        ("DEVICE --storage NOWHERE/x", "NOWHERE/x cannot be written: No such file or directory; name another"),
        (
            "DEVICE --motion trajectory:file=NOWHERE",
            "--motion trajectory: cannot read NOWHERE: No such file or directory\n",
        ),
        ("DEVICE --motion replay:file=NOWHERE", "--motion replay: cannot read NOWHERE: No such file or directory\n"),
        ("DEVICE --motion swim", "--motion 'swim' is not a motion; use one of "),
    ],
)
def test_errors_are_one_line_with_a_remedy(
    arguments: str, error: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    taken = socket.create_server(("127.0.0.1", 0))
    (tmp_path / "file").write_text("mine")
    (tmp_path / "link").symlink_to(tmp_path / "file")
    (tmp_path / "terminal").symlink_to("/dev/tty")
    put = {
        "DEVICE": DEVICE,
        "A_TERMINAL": str(tmp_path / "terminal"),
        "A_FILE": str(tmp_path / "file"),
        "A_LINK": str(tmp_path / "link"),
        "NOWHERE": str(tmp_path / "none"),
        "A_PORT": str(taken.getsockname()[1]),
    }
    for name, place in put.items():
        arguments, error = arguments.replace(name, place), error.replace(name, place)
    before = sorted(tmp_path.iterdir())
    with taken:
        code, out, text = run(capsys, "simulate", *shlex.split(arguments), "--duration", "0.01")
    wrong = r"(the dev|dev|only |fault|'USB|--log)|.* (is not a (TCP port|motion|dev)|two term|has no port)"
    status = 2 if re.match(wrong, error) else 1
    assert (code, out) == (status, "") and text.startswith(f"mip simulate: {error}") and text.count("\n") == 1
    assert sorted(tmp_path.iterdir()) == before and (tmp_path / "file").read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ("--speed -1", "'-1' is not a speed; use 1 for real time"),
        ("--duration 0", "'0' is not a duration in seconds; use a number above 0"),
        ("--start yesterday", "'yesterday' is not a time; write 2024-05-01T12:00:00"),
        ("--start 1970-01-01", "is before GPS time, which began on 1980-01-06"),
        ("--start 3001-01-01", "is too late; use a year up to 3000"),
        ("--start 0001-01-01T00:00:00+14:00", "is not a time; write 2024-05-01T12:00:00"),
        ("--speed fast", "'fast' is not a speed; use 1 for real time"),
    ],
)
def test_values_are_checked(arguments: str, error: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, _, text = run(capsys, "simulate", DEVICE, *arguments.split())
    assert code == 2 and error in text.splitlines()[-1]


def test_without_pseudo_terminals() -> None:
    """As on Windows: the program starts, says what `--pty` needs, and serves TCP."""
    code = f"""
import sys
sys.modules.update(dict.fromkeys(("fcntl", "pty", "termios", "tty")))
from mip_tools.__main__ import main
assert main(["simulate", "{DEVICE}", "--pty", "x"]) == 1
assert main(["simulate", "{DEVICE}", "--tcp", "0", "--duration", "0.01"]) == 0
"""
    done = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": PYTHONPATH}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stderr == f"mip simulate: this system has no pseudo-terminals; use --tcp\n{CERTAIN}\n"
