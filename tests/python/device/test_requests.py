"""Devices at a port, with a peer that sends the test's replies: the same for threads and for asyncio."""

from __future__ import annotations

import asyncio
import errno
import math
import pickle
import queue
import socket
import subprocess
import sys
import time
from typing import Any

import mip_protocol as mip
import pytest
from both import DATA, PING, Kind, Peer, acknowledge, packet, running, until, url
from mip_protocol import Parser, aiding, aio, base, gnss_data, mip_3dm, port, sensor, types
from mip_protocol import device as sync
from mip_simulator.device import VirtualDevice
from mip_tools.sentences import Sentences
from support import PATIENCE, ROOT, simulated

INFO = packet(0x01, "f1 03 00", "81" + "20" * 82)

# --------------------------------------------------------------------------- requests


def test_responses(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.answering(INFO, acknowledge(1, 1), packet(0x0C, "f1 0e 00", "8e 80 03e8"))
        assert device.request(base.GetDeviceInfo()).device_info.model_name == " " * 16
        assert device.request(PING) is None
        assert device.request(mip_3dm.GetBaseRate(0x80)).rate == 1000
        assert device.waiting == device.dropped == device.skipped == 0


def test_refusals(kind: Kind, peer: Peer) -> None:
    command = mip_3dm.PpsSourceControl.read()
    with kind.at(peer.near) as device:
        peer.answering(acknowledge(0x0C, 0x28, 3))
        with pytest.raises(mip.Refused, match=r"3dm.pps_source_control rejected \(invalid parameter\)") as caught:
            device.request(command)
    error = caught.value
    assert error.code is types.AckCode.INVALID_PARAMETER and error.command is command and error.kind == "refused"
    assert [o.code for o in error.outcomes] == [3]
    copy = pickle.loads(pickle.dumps(error))
    assert (str(copy), copy.code) == (str(error), error.code)


def test_no_answer(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near, timeout=0.05) as device:
        with pytest.raises(mip.NoAnswer, match=r"no_answer: the device has not answered base\.ping in time") as caught:
            device.request(PING)
        with pytest.raises(TimeoutError):
            device.request(base.BuiltInTest(), timeout=0.05)  # it would take ten seconds
        peer.command()
        peer.send(acknowledge(1, 1))  # too late: nobody waits for it
        assert device.next(5).packet == mip.Packet(acknowledge(1, 1))
    assert caught.value.command is PING and isinstance(caught.value, mip.MipError)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


class Counted(port.SocketPort):
    """It counts how often it is read."""

    reads = 0

    def read(self, size: int) -> bytes:
        self.reads += 1
        return super().read(size)


LATE = packet(0x0C, "f1 0e 00", "8e 82 0007")
#: The reply to the two pings that are sent in front of a command that follows one without a reply.
BARRIER = packet(0x01, "f1 01 00", "f1 01 00")


def comes_late(peer: Peer, port: Counted) -> int:
    """Sends the late reply to one command; then answers the next one."""
    peer.command()
    reads = port.reads
    peer.send(LATE)
    peer.answering(BARRIER + packet(0x0C, "f1 0e 00", "8e 80 03e8"))
    return reads


def test_a_copy_of_a_reply_that_waits_is_not_that_of_the_next_command(monkeypatch: pytest.MonkeyPatch) -> None:
    """As with UDP: two datagrams wait at once, and each read returns one."""
    monkeypatch.setattr(port, "SETTLE", PATIENCE)  # on a busy machine, the reader may not run for long
    datagrams: queue.SimpleQueue[bytes] = queue.SimpleQueue()

    class Taken(bytes):
        def __bool__(self) -> bool:  # while the reader has taken bytes, and has not handled them, other threads run
            time.sleep(0.001)
            return True

    class Datagrams:
        @property
        def in_waiting(self) -> int:
            return 84 * datagrams.qsize()

        def read(self, size: int) -> bytes:
            try:
                return Taken(datagrams.get(timeout=0.05))
            except queue.Empty:
                return b""

        def write(self, data: bytes) -> int:
            for _ in range(2):
                datagrams.put(packet(0x0C, "f1 0e 00", f"8e {data[6]:02x} 03e8"))
            return len(data)

    with sync.Device(Datagrams()) as device:
        for i in range(100):
            wanted = (0x80, 0x82, 0x91)[i % 3]
            assert device.request(mip_3dm.GetBaseRate(wanted)).descriptor_set == wanted


def test_a_late_answer_is_not_that_of_the_next_command(peer: Peer) -> None:
    with sync.Device(counted := Counted(peer.near), timeout=0.05) as device:
        with pytest.raises(mip.NoAnswer):
            device.request(mip_3dm.GetBaseRate(0x82))
        reads = comes_late(peer, counted)
        until(lambda: counted.reads > reads + 1)
        assert device.request(mip_3dm.GetBaseRate(0x80), timeout=PATIENCE).rate == 1000
        assert device.next(5).packet == mip.Packet(LATE)


@pytest.mark.parametrize("streams", [False, True])
def test_a_late_answer_while_the_loop_is_busy(peer: Peer, streams: bool) -> None:
    """The reply has arrived, but is not processed until the loop runs again, which sends the next command first."""

    async def main() -> None:
        counted = Counted(peer.near)
        link = await asyncio.open_connection(sock=peer.near) if streams else counted
        async with aio.Device(link, timeout=0.05) as device:
            with pytest.raises(mip.NoAnswer):
                await device.request(mip_3dm.GetBaseRate(0x82))
            reads = comes_late(peer, counted)
            until(lambda: streams or counted.reads > reads + 1)  # the loop does not run
            rate = await device.request(mip_3dm.GetBaseRate(0x80), timeout=PATIENCE)
            assert rate.rate == 1000
            assert (await device.next(5)).packet == mip.Packet(LATE)

    asyncio.run(main())


def test_answers_without_a_usable_response(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.answering(acknowledge(1, 3), packet(0x01, "f1 03 00", "81 00"))
        with pytest.raises(mip.MissingResponse):
            device.request(base.GetDeviceInfo())
        with pytest.raises(mip.DecodeError):
            device.request(base.GetDeviceInfo())


def test_what_does_not_fit_is_not_sent(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        for commands in ((), (PING, mip_3dm.GetBaseRate(0x80)), (PING,) * 128):
            with pytest.raises(mip.EncodeError):
                device.request_all(*commands)
        peer.answering(acknowledge(1, 1))
        device.request(PING)  # the first that has arrived


def test_several_commands_in_one_packet(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        both = packet(0x01, "f1 01 00", "f1 03 00", "81" + "20" * 82)
        peer.answering(both, [acknowledge(1, 1), DATA, INFO])
        for _ in range(2):  # in one packet, and split over several
            nothing, info = device.request_all(PING, base.GetDeviceInfo())
            assert nothing is None and isinstance(info, base.GetDeviceInfoResponse)
        assert device.next(5).packet == mip.Packet(DATA)


def test_one_failure_of_several(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        answers = packet(0x01, "f1 01 00", "f1 05 04", "f1 02 00")
        peer.answering(answers, answers)
        outcomes = device.exchange(PING, base.BuiltInTest(), base.SetIdle())
        assert [o.code for o in outcomes] == [0, 4, 0]
        with pytest.raises(mip.Refused) as caught:
            device.request_all(PING, base.BuiltInTest(), base.SetIdle())
    assert isinstance(caught.value.command, base.BuiltInTest) and len(caught.value.outcomes) == 3


@pytest.mark.parametrize("noise", [b"ue\x80\xff", b"ueue\x01\xffue\x80\xf0", b"$GPZDA,ue*", bytes(300)])
def test_noise_before_an_acknowledge(kind: Kind, peer: Peer, noise: bytes) -> None:
    """What looks like the start of a long packet does not hold back the answer until it is too late."""
    with kind.at(peer.near, timeout=PATIENCE) as device:
        peer.answering(noise + acknowledge(1, 1))
        started = time.monotonic()
        device.request(PING)
        assert time.monotonic() - started < PATIENCE / 2
        assert device.skipped == len(noise)


def test_commands_that_are_not_acknowledged(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near, timeout=PATIENCE) as device:
        assert device.request(mip_3dm.PollData(0x80, True, (4,))) is None
        assert device.exchange(mip_3dm.PollData(0x80, True, (4,))) == [None]
        assert peer.command() == peer.command()


def test_sending_without_waiting(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        device.send(PING, base.SetIdle())
        assert [raw.descriptor for raw in peer.command()] == [1, 2]
        peer.send(packet(0x01, "f1 01 00", "f1 02 00"))
        assert [raw.data for raw in device.next(5).fields] == [b"\x01\0", b"\x02\0"]


def test_bytes_that_are_no_commands(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        device.write(b"\xd3\0\0 no packet")
        device.send(PING)
        assert [raw.descriptor for raw in peer.command()] == [1]
        assert peer.parser.skipped == 13
        device.close()
        with pytest.raises(mip.PortClosed, match="the device has been closed"):
            device.write(b"")


AIDING = aiding.Pressure(aiding.MeasurementTime(aiding.Timebase(1), 0), 1, 1.0, 1.0, 1)


def asked(packet: mip.Packet) -> list[tuple[int, int]]:
    return [(raw.set, raw.descriptor) for raw in packet]


def test_commands_that_a_setting_silences(kind: Kind, peer: Peer) -> None:
    """The setting is read once and then known, even after it is changed; no command waits in vain."""
    mode = aiding.AidingEchoMode
    ack = acknowledge(0x13, AIDING.DESCRIPTOR)
    with kind.at(peer.near, timeout=PATIENCE) as device:
        peer.answering(packet(0x13, "f1 1f 00", f"9f {mode.SUPPRESS_ACK:02x}"))
        device.request(AIDING)
        assert asked(peer.command()) == [(0x13, AIDING.DESCRIPTOR)]
        device.request(AIDING)
        assert asked(peer.command()) == [(0x13, AIDING.DESCRIPTOR)]
        peer.answering(acknowledge(0x13, 0x1F), ack, acknowledge(0x13, 0x1F))
        device.request(aiding.EchoControl.write(mode.STANDARD))
        assert device.exchange(AIDING)[0].accepted
        device.request(aiding.EchoControl.write(mode.SUPPRESS_ACK))
        assert device.exchange(AIDING) == [None]
        peer.command()
        peer.answering(acknowledge(0x13, 0x1F), packet(0x13, "f1 1f 00", f"9f {mode.RESPONSE:02x}"), ack)
        device.request(aiding.EchoControl.default())  # whatever that is
        assert device.exchange(AIDING)[0].accepted


def test_a_device_without_that_setting(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near, timeout=PATIENCE) as device:
        ack = acknowledge(0x13, AIDING.DESCRIPTOR)
        peer.answering(acknowledge(0x13, 0x1F, 1), ack, ack)
        device.request(AIDING)
        device.request(AIDING)


# --------------------------------------------------------------------------- data


def test_data_come_in_order_with_their_times(kind: Kind, peer: Peer) -> None:
    others = [packet(0x80, f"04 {n:024x}") for n in range(5)]
    before, start = time.time(), time.monotonic()
    with kind.at(peer.near) as device:
        peer.answering([*others[:2], acknowledge(1, 1), *others[2:]])
        device.request(PING)  # nothing is lost meanwhile
        arrivals = [device.next(5) for _ in others]
        assert [bytes(a.packet) for a in arrivals] == others
        assert before <= arrivals[0].time <= arrivals[-1].time <= time.time()
        assert start <= arrivals[0].monotonic <= arrivals[-1].monotonic <= time.monotonic()
        assert arrivals[1].find(sensor.ScaledAccel) == arrivals[1].decode()[0]
        assert device.next(0) is None and device.next(0.01) is None


SATELLITE = gnss_data.SatelliteStatus(
    1, 3, 0.0, 0, types.GnssConstellation.GPS, 7, 45.0, 90.0, True, gnss_data.SatelliteStatusFlags(0)
)


def satellites(*numbers: int) -> bytes:
    fields = [SATELLITE.__replace__(satellite_id=n) for n in numbers]
    return packet(0x91, *(f"{f.DESCRIPTOR:02x} {f.encode().hex()}" for f in fields))


def test_all_fields_of_a_type_in_a_packet(kind: Kind, peer: Peer) -> None:
    """There is one field for each satellite."""
    with kind.at(peer.near) as device:
        peer.send(satellites(5, 3, 9), DATA, satellites(4))
        found = device.fields(gnss_data.SatelliteStatus, sensor.ScaledAccel)
        fields = [next(found)[1] for _ in range(5)]
        assert [getattr(f, "satellite_id", None) for f in fields] == [5, 3, 9, None, 4]
        peer.send(satellites(1, 2))
        arrival = device.next(5)
        assert [f.satellite_id for f in arrival.find_all(gnss_data.SatelliteStatus)] == [1, 2]
        assert arrival.find(gnss_data.SatelliteStatus).satellite_id == 1
        assert list(arrival.find_all(sensor.ScaledAccel)) == []


def test_fields_that_do_not_arrive(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.send(DATA, satellites(1))
        found = device.fields(sensor.ScaledAccel, timeout=0.05)
        assert next(found)
        with pytest.raises(TimeoutError, match=r"no sensor.scaled_accel within 0.05 s; `stream` starts data") as caught:
            next(found)
        assert isinstance(caught.value, mip.NoData)


def test_settings_are_read_changed_and_written(kind: Kind) -> None:
    """Settings with plain values, with a number that selects one, and with a union."""
    trigger, gpio = mip_3dm.EventTriggerConfig.read(2), types.EventTriggerGpio
    with simulated("--tcp", "0") as place, kind.open(place, timeout=PATIENCE) as device:
        for read, values in (
            (mip_3dm.ComplementaryFilter.read(), {"pitch_roll_time_constant": 5.0}),
            (mip_3dm.MessageFormat.read(0x80), {"descriptors": [types.DescriptorRate(4, 10)]}),
            (trigger, {"type": types.EventTriggerType.GPIO, "parameters": gpio(1, types.EventTriggerGpioMode(1))}),
            (trigger, {"parameters": gpio(1, types.EventTriggerGpioMode(2))}),
        ):
            before = device.request(read)
            device.request(mip.change(before, **values))
            after = device.request(read)
            assert after == before.__replace__(**values) != before
        with pytest.raises(TypeError, match="unexpected keyword argument 'nothing'"):
            mip.change(after, nothing=1)
        with pytest.raises(TypeError, match="get_device_info_response is not the setting"):
            mip.change(device.request(base.GetDeviceInfo()))


def test_a_value_out_of_range_is_named(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.answering(*[acknowledge(0x0C, 0x51, 3)] * 2)
        with pytest.raises(mip.Refused, match=r"r\): pitch_roll_time_constant is 1e\+09, its range is 1 to 1000$"):
            device.request(mip_3dm.ComplementaryFilter.write(True, True, 1e9, 3))
        with pytest.raises(mip.Refused, match=r"parameter\)$"):
            device.request(mip_3dm.ComplementaryFilter.write(True, True, 1, 1000))


def test_the_fields_before_one_that_cannot_be_decoded(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.send(packet(0x80, "04" + "00" * 12, "04 00"))
        found = device.fields(sensor.ScaledAccel)
        assert next(found)[1] == sensor.ScaledAccel((0, 0, 0))
        with pytest.raises(mip.DecodeError):
            next(found)


def test_the_oldest_are_dropped_and_counted(kind: Kind, peer: Peer) -> None:
    others = [packet(0x80, f"04 {n:024x}") for n in range(10)]
    with kind.at(peer.near, capacity=4) as device:
        peer.answering([*others, acknowledge(1, 1)])
        device.request(PING)
        assert (device.waiting, device.dropped) == (4, 6)
        assert [bytes(device.next(5).packet) for _ in range(4)] == others[6:]
        peer.send(DATA)
        until(lambda: device.waiting)
        device.clear()
        assert device.waiting == 0 and device.dropped == 6


def test_what_is_between_packets_is_handed_over(kind: Kind, peer: Peer) -> None:
    seen, read = bytearray(), bytearray()
    sentences = Sentences()
    nmea = b"$GPZDA,010203.00,01,02,2024,00,00*61\r\n"
    with kind.at(peer.near, on_skipped=seen.extend, on_bytes=read.extend) as device:
        stream = [b"noise", DATA, nmea, DATA, b"ue\x80\x04", nmea, acknowledge(1, 1)]
        peer.answering(stream)
        device.request(PING)
        assert device.waiting == 2 and device.skipped == len(seen)
    assert bytes(seen) == b"noise" + nmea + b"ue\x80\x04" + nmea and bytes(read) == b"".join(stream)
    assert sentences.feed(bytes(seen)) == [nmea.decode().strip()] * 2


def test_callbacks_must_not_use_a_device_of_threads(peer: Peer) -> None:
    with Kind("threads").at(peer.near, on_skipped=lambda data: device.request(PING)) as device:
        peer.send(b"noise")
        with pytest.raises(mip.PortClosed, match="must not use the device"):
            device.next(5)


# --------------------------------------------------------------------------- several at once


def test_requests_from_many_threads_while_another_takes_data(kind: Kind, peer: Peer) -> None:
    taken: list[Any] = []

    def answer() -> None:
        for n in range(40):
            (raw,) = peer.command()
            peer.send(packet(0x80, f"04 {n:024x}"), packet(0x0C, "f1 0e 00", f"8e {raw.data[0]:02x} {raw.data[0]:04x}"))

    def take() -> None:
        taken.extend(device)

    def ask(number: int) -> None:
        for _ in range(10):
            response = device.request(mip_3dm.GetBaseRate(number))
            right.append(response.rate == response.descriptor_set == number)

    right: list[bool] = []
    with kind.at(peer.near, timeout=PATIENCE) as device, running(take):
        with running(answer, *[lambda: ask(0x80)] * 4):
            pass
        until(lambda: len(taken) == 40)
        device.close()
    assert right == [True] * 40
    assert [a.packet for a in taken] == [mip.Packet(packet(0x80, f"04 {n:024x}")) for n in range(40)]


# --------------------------------------------------------------------------- the end of a port


def test_the_end_of_a_connection(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.send(DATA, b"ue\x80\xff", DATA)
        peer.close()
        assert bytes(device.next(5).packet) == bytes(device.next(5).packet) == DATA  # data that arrived comes first
        for use in (lambda: device.next(5), lambda: list(device), lambda: device.request(PING)):
            with pytest.raises(mip.PortClosed, match="closed: the port is gone: the other end has closed") as caught:
                use()
            assert isinstance(caught.value, ConnectionError)
        assert device.closed
    assert pickle.loads(pickle.dumps(caught.value)).kind == "closed"


def test_closing_wakes_those_who_wait(kind: Kind, peer: Peer) -> None:
    ends: list[Any] = []

    def ask() -> None:
        try:
            device.request(PING)
        except mip.PortClosed as error:
            ends.append(error)

    with kind.at(peer.near, timeout=PATIENCE) as device:
        with running(ask, lambda: ends.append(list(device))):
            peer.command()
            device.close()
        assert sorted(str(e) for e in ends) == ["[]", "closed: the device has been closed"]
        assert device.next(1) is None and list(device) == []
        with pytest.raises(mip.PortClosed, match="the device has been closed"):
            device.request(PING)
        with pytest.raises(ValueError, match="open_port"):
            device.reopen()


def test_what_was_known_of_a_device_is_asked_again_when_it_is_back(kind: Kind, server: socket.socket) -> None:
    """It may have restarted, with other settings."""
    heard: list[tuple[int, int]] = []

    def serve() -> None:
        for _ in range(2):
            connection, _ = server.accept()
            with connection:
                parser = Parser()
                while not heard or heard[-1] != (0x13, AIDING.DESCRIPTOR):
                    for command in parser.feed(connection.recv(100)):
                        heard.extend(asked(command))
                        refused = heard[-1] == (0x13, 0x1F)
                        connection.sendall(acknowledge(*heard[-1], code=1 if refused else 0))
            heard.append((0, 0))  # the end of a connection

    with running(serve), kind.open(url(server)) as device:
        device.request(AIDING)
        until(lambda: device.closed)
        device.reopen()
        device.request(AIDING)
    assert heard == [(0x13, 0x1F), (0x13, AIDING.DESCRIPTOR), (0, 0)] * 2


def inside(device: Any) -> Any:
    """The device itself, of either kind."""
    return getattr(device, "device", device)


def test_a_device_that_is_closed_while_its_port_is_away(kind: Kind, server: socket.socket) -> None:
    with kind.open(url(server)) as device:
        server.accept()[0].close()
        server.close()
        until(lambda: device.closed)
        ends: list[BaseException] = []

        def again() -> None:
            try:
                device.reopen(within=60)
            except mip.PortClosed as error:
                ends.append(error)

        with running(again):
            until(lambda: inside(device)._opening.locked())
            device.close()
        assert [str(e) for e in ends] == ["closed: the device was closed while it was being opened again"]
        assert device.closed and list(device) == []


def test_a_command_that_could_not_be_written_is_not_sent_later(monkeypatch: pytest.MonkeyPatch) -> None:
    """When the other end reads again, it gets no bytes of a command that has failed."""
    monkeypatch.setattr(aio, "WRITE_TIMEOUT", 0.2)

    async def talk() -> None:
        near, far = socket.socketpair()
        near.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 4096)
        far.setblocking(False)
        device = aio.Device(await asyncio.open_connection(sock=near))
        sent, parser, arrived = 0, Parser(), 0
        with pytest.raises(mip.PortClosed):
            while True:
                await device.send(PING)
                sent += 1
        while data := await asyncio.get_running_loop().sock_recv(far, 4096):
            arrived += len(parser.feed(data))
            assert arrived <= sent
        assert arrived == sent
        await device.close()
        far.close()

    asyncio.run(asyncio.wait_for(talk(), 20))


@pytest.mark.parametrize(
    ("url", "number", "message"),
    [
        ("socket://localhost", None, "'socket://localhost' is not a TCP port; write HOST:PORT"),
        ("socket://localhost:99999", None, "write HOST:PORT"),
        ("localhost:99999", None, "write HOST:PORT"),
        ("nothing://localhost:1", None, "nothing://localhost:1 cannot be opened: invalid URL, protocol 'nothing'"),
        ("localhost:1", errno.ECONNREFUSED, "localhost:1 cannot be opened: Connection refused"),
        ("socket://localhost:1", errno.ECONNREFUSED, "//localhost:1 cannot be opened: Connection refused"),
        ("/no/such/port", errno.ENOENT, "/no/such/port cannot be opened: No such file or directory$"),
    ],
)
def test_ports_that_cannot_be_opened(kind: Kind, url: str, number: int | None, message: str) -> None:
    with pytest.raises(mip.PortError, match=message) as caught:
        kind.open(url)
    error = pickle.loads(pickle.dumps(caught.value))
    assert isinstance(error, OSError) and isinstance(error, mip.MipError)
    assert (error.errno, error.kind, str(error)) == (number, "port" if number else "url", str(caught.value))


def test_a_host_that_is_unknown(kind: Kind) -> None:
    with pytest.raises(mip.PortError, match=r"^port: nohost.invalid:1 cannot be opened: unknown host$|^nohost.*host$"):
        kind.open("nohost.invalid:1")


def test_wrong_arguments(kind: Kind, peer: Peer) -> None:
    with pytest.raises(TypeError, match="it needs `read` and `write`"):
        kind.at(object())
    with pytest.raises(TypeError, match="its `read` must accept a size"):
        kind.at(VirtualDevice("3dm-cv7-gnss-ins").connect())
    for options in ({"capacity": 0}, {"timeout": 0}, {"timeout": math.nan}):
        with pytest.raises(ValueError, match=r"at least 1 packet|needs time|a number of seconds"):
            kind.at(peer.near, **options)
    with kind.at(peer.near) as device, pytest.raises(ValueError, match="baud rate"):
        device.change_baud(mip_3dm.UartBaudRate.write(9600))
    with pytest.raises(TypeError, match="baud rate '115200': must be a whole number, such as 115200"):
        kind.open("localhost:1", "115200")


# --------------------------------------------------------------------------- the package


def python(code: str, *options: str, executable: str = sys.executable) -> str:
    folder = str(ROOT / "generated/python")
    done = subprocess.run(
        [executable, *options, "-c", f"import sys; sys.path.insert(0, {folder!r})\n{code}"],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_a_missing_package_is_named() -> None:
    code = "sys.modules['serial'] = None\nfrom mip_protocol import open_port\n"
    code += "try: open_port('/dev/ttyS0')\nexcept ImportError as e: print(type(e).__name__, e)"
    assert python(code) == "MissingExtra pyserial is missing; pip install pyserial"


# --------------------------------------------------------------------------- what went wrong before


def test_an_answer_that_comes_while_a_command_is_sent_is_data(kind: Kind) -> None:
    """`send` takes no reply, however early it arrives."""

    class Quick:
        def __init__(self) -> None:
            self.coming: queue.SimpleQueue[bytes] = queue.SimpleQueue()

        def read(self, size: int) -> bytes:
            try:
                return self.coming.get(timeout=0.01)
            except queue.Empty:
                return b""

        def write(self, data: bytes) -> int:
            self.coming.put(packet(0x01, "f1 01 00"))
            time.sleep(0.002)  # as long as serial ports take to send the bytes
            return len(data)

    with kind.at(Quick()) as device:
        for _ in range(20):
            device.send(PING)
        for _ in range(20):
            assert device.next(5) is not None


def test_one_command_in_two_requests(kind: Kind, peer: Peer) -> None:
    """The time-out of one does not end the other."""
    with kind.at(peer.near) as device:
        ended: list[type[BaseException] | None] = []

        def patient() -> None:
            try:
                device.request(PING, timeout=PATIENCE)
                ended.append(None)
            except mip.MipError as error:
                ended.append(type(error))

        with running(patient):
            peer.command()
            with pytest.raises(mip.NoAnswer) as caught:
                device.request(PING, timeout=0.05)
            assert caught.value.command is PING and not ended
            peer.command()
            peer.send(acknowledge(1, 1))
        assert ended == [None]


def test_times_without_end(kind: Kind, peer: Peer) -> None:
    with kind.at(peer.near) as device:
        peer.answering(acknowledge(1, 1))
        assert device.request(PING, timeout=math.inf) is None


@pytest.mark.parametrize("how", ["request", "request_all", "exchange", "next", "reopen"])
def test_times_that_are_invalid(kind: Kind, server: socket.socket, how: str) -> None:
    """They are rejected, and nothing else happens."""
    with kind.open(url(server)) as device:
        commands = [PING] if how in ("request", "request_all", "exchange") else []
        name = "within" if how == "reopen" else "timeout"
        for wrong in (math.nan, -1):
            with pytest.raises(ValueError, match=f"{name} {wrong}: must be a number of seconds, 0 or more"):
                getattr(device, how)(*commands, **{name: wrong})
        with pytest.raises(TypeError, match=f"{name} '1': must be a number of seconds"):
            getattr(device, how)(*commands, **{name: "1"})
        assert not device.closed


def test_a_callback_that_exits_ends_the_device(peer: Peer) -> None:
    def leave(data: bytes) -> None:
        raise SystemExit

    with Kind("threads").at(peer.near, on_bytes=leave) as device:
        peer.send(DATA)
        with pytest.raises(mip.PortClosed):
            device.next(10)
        assert device.closed


def test_a_packet_is_not_lost_by_a_callback_that_fails(kind: Kind, peer: Peer) -> None:
    def fail(data: bytes) -> None:
        raise RuntimeError("no")

    with kind.at(peer.near, on_skipped=fail) as device:
        peer.send(b"noise" + DATA)
        until(lambda: device.closed)
        assert device.next(5).packet == mip.Packet(DATA)
