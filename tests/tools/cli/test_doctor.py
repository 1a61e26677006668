"""`mip doctor`: planted causes in logs are named, and nothing else; ports with faults."""

from __future__ import annotations

import errno
import json
import random
import re
import select
import socket
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
from mip_protocol import PacketBuilder, Parser, base, mip_3dm, shared, types
from mip_tools.cli import log_report
from mip_tools.columns import read_log
from mip_tools.doctor import findings, stream
from mip_tools.doctor.events import Event, merged
from mip_tools.doctor.examined import Examined
from mip_tools.doctor.port import why_not_open
from mip_tools.simulator import VirtualDevice
from program import DEVICE, mip, simulated
from support import SEED

Rates = dict[int, tuple[tuple[int, int], ...]]
RATES: Rates = {
    0x80: ((0xD3, 10), (0xD5, 10), (0x04, 10), (0x05, 10), (0x06, 20)),
    0x82: ((0xD3, 50), (0xD5, 50), (0x05, 50), (0x10, 50)),
    0x91: ((0xD3, 1), (0xD5, 1), (0x03, 1)),
}


def started(device: Any, rates: Rates = RATES) -> Any:
    """A link with a device that sends these fields."""
    link = device.connect()
    commands: list[Any] = [base.SetIdle()]
    for number, fields in rates.items():
        formats = tuple(types.DescriptorRate(*field) for field in fields)
        commands += [mip_3dm.MessageFormat.write(number, formats), mip_3dm.DataStreamControl.write(number, True)]
    for c in [*commands, base.Resume()]:
        link.write(bytes(c.packet()))
        device.advance(0.05)
    link.read()
    return link


def sent(device: Any, link: Any, seconds: float) -> bytes:
    data = b""
    for _ in range(round(seconds * 10)):
        device.advance(0.1)
        data += link.read()
    return data


@cache
def clean(seconds: float = 8.0) -> bytes:
    device = VirtualDevice(DEVICE)
    return sent(device, started(device), seconds)


def packets() -> list[bytes]:
    return [bytes(packet) for packet in Parser().feed(clean())]


def examined(data: bytes, device: str | None = DEVICE) -> Examined:
    return stream.examine(read_log(data), device)


def without(numbers: Sequence[int]) -> bytes:
    return b"".join(packet for i, packet in enumerate(packets()) if i not in numbers)


def of_sensor() -> list[int]:
    return [i for i, packet in enumerate(packets()) if packet[2] == 0x80]


def stepped(packet: bytes, seconds: float) -> bytes:
    """The packet with another GPS time."""
    (parsed,) = Parser().feed(packet)
    builder = PacketBuilder(parsed.set)
    for raw in parsed:
        data = bytes(raw.data)
        if raw.descriptor == shared.GpsTimestamp.DESCRIPTOR:
            value = shared.GpsTimestamp.decode(data)
            value.tow += seconds
            data = value.encode()
        builder.add(raw.descriptor, data)
    return bytes(builder.build())


# --------------------------------------------------------------------------- planted causes

SENTENCE = b"$GPZDA,,,,,,*48\r\n"


def damaged() -> bytes:
    data = bytearray(clean())
    for at in (3000, 20000):
        data[at] ^= 0x55
    return bytes(data)


def reset() -> bytes:
    device = VirtualDevice(DEVICE)
    return clean() + sent(device, started(device), 6)


def another_format() -> bytes:
    device = VirtualDevice(DEVICE)
    first = sent(device, started(device), 6)
    slower = {0x80: ((0xD3, 20), (0xD5, 20), (0x04, 20), (0x05, 20))}
    return first + sent(device, started(device, slower), 6)


PLANTED: dict[str, tuple[Callable[[], bytes], list[tuple[str, set[int]]]]] = {
    "nothing": (clean, []),
    "NMEA, and an end within a packet": (
        lambda: b"".join(packets()[:300]) + SENTENCE + b"".join(packets()[300:]) + packets()[0][:10],
        [],
    ),
    "an end within a sentence": (lambda: clean() + SENTENCE[:9], []),
    "a sentence with a wrong checksum": (
        lambda: b"".join(packets()[:300]) + SENTENCE.replace(b",", b"1", 1) + b"".join(packets()[300:]),
        [("line damage", set())],
    ),
    "an end within the first bytes": (lambda: clean() + packets()[0][:3], []),
    "a begin within a packet": (lambda: clean()[7:], []),
    "damage": (damaged, [("line damage", {0x80}), ("line damage", {0x80})]),
    "single packets": (
        lambda: without([of_sensor()[i] for i in (100, 200, 201, 305)]),
        [("overload", {0x80})] * 3,
    ),
    "one set for a long time": (lambda: without(of_sensor()[100:250]), [("overload", {0x80})]),
    "all sets": (lambda: without(range(300, 500)), [("pause", {0x80, 0x82, 0x91})]),
    "reset": (reset, [("reset", {0x80, 0x82, 0x91})]),
    "another format": (another_format, [("changed format", {0x80})]),
    "a later time": (
        lambda: b"".join(p if i < 400 else stepped(p, 10) for i, p in enumerate(packets())),
        [("clock step", {0x80, 0x82, 0x91})],
    ),
    "an earlier time": (
        lambda: b"".join(p if i < 400 else stepped(p, -3) for i, p in enumerate(packets())),
        [("clock step", {0x80, 0x82, 0x91})],
    ),
}


@pytest.mark.parametrize("name", PLANTED)
def test_a_planted_cause_is_named_and_nothing_else(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """However the log is divided into parts."""
    make, causes = PLANTED[name]
    found = examined(make())
    assert [(e.cause, e.sets & {0x80} if e.cause == "changed format" else e.sets) for e in found.events] == causes
    assert [f.cause for f in findings.of(found)] == list(dict.fromkeys(cause for cause, _ in causes))
    monkeypatch.setattr(stream, "PART", 7000)
    parts = examined(make())
    assert parts.events == found.events and parts.rates == found.rates and findings.of(parts) == findings.of(found)


def test_where_and_how_long() -> None:
    found = examined(without(range(300, 500)))
    (event,) = found.events
    begin = sum(map(len, packets()[:300]))
    assert event.begin <= begin <= event.end and event.seconds == pytest.approx(1.6, abs=0.05)
    (first, second) = examined(damaged()).events
    assert first.begin <= 3000 < first.end and second.begin <= 20000 < second.end


@pytest.mark.parametrize("name, seconds", [("a later time", 10), ("an earlier time", -3)])
def test_a_step_of_a_clock_is_as_long_as_it_was_planted(name: str, seconds: float) -> None:
    make, _ = PLANTED[name]
    (event,) = examined(make()).events
    told = [float(number) for text in event.details for number in re.findall(r"by ([+-][\d.]+) s", text)]
    assert told and told == pytest.approx([seconds] * len(told), abs=0.01), event.details


def test_several_causes_in_one_log() -> None:
    data = bytearray(without([of_sensor()[100]]))
    data[40_000] ^= 1
    device = VirtualDevice(DEVICE)
    found = examined(bytes(data) + sent(device, started(device), 3))
    assert [e.cause for e in found.events] == ["overload", "line damage", "reset"]


def test_events_that_meet_are_merged() -> None:
    """The result is the same as comparing each event with all others, those that explain others first."""
    dice = random.Random(SEED)
    order = ["reset", "clock step", "line damage", "changed format", "pause", "overload"]
    seen: set[tuple[str, str]] = set()
    for _ in range(300):
        made = [(dice.choice(order), at := dice.randrange(60_000), at + dice.randrange(3000)) for _ in range(30)]
        groups: list[list[Any]] = []  # cause, begin, end, what it is made of or explains
        for cause, begin, end in sorted(made, key=lambda e: (order.index(e[0]), e[1])):
            for group in groups:
                slack = 4096 if cause == group[0] == "changed format" else 0
                if begin > group[2] + slack or group[1] > end + slack:
                    continue
                if cause == group[0]:
                    group[1:3] = min(begin, group[1]), max(end, group[2])
                elif cause not in ("pause", "overload") and (
                    group[0] != "reset" or cause not in ("clock step", "changed format")
                ):
                    continue
                group[3].add(begin)
                seen.add((group[0], cause))
                break
            else:
                groups.append([cause, begin, end, {begin}])
        found = merged(Event(cause, begin, end, None, sets={begin}) for cause, begin, end in made)
        wanted = sorted(groups, key=lambda group: group[1])
        assert [[e.cause, e.begin, e.end, e.sets] for e in found] == wanted
    assert len(seen) == 6 + 5 + 4 + 2


def test_without_a_time() -> None:
    device = VirtualDevice(DEVICE)
    found = examined(sent(device, started(device, {0x80: ((0x04, 10),)}), 2))
    assert [f.cause for f in findings.of(found)] == ["no timestamps"] and found.events == []


# --------------------------------------------------------------------------- the filter and the time


def with_status(flags: int, share: float = 1.0) -> bytes:
    """A log in which the filter has these flags at the end."""
    parts = []
    for i, packet in enumerate(packets()):
        (parsed,) = Parser().feed(packet)
        builder = PacketBuilder(parsed.set)
        for raw in parsed:
            data = bytes(raw.data)
            if (raw.set, raw.descriptor) == (0x82, 0x10) and i >= len(packets()) * (1 - share):
                data = data[:4] + flags.to_bytes(2, "big")
            builder.add(raw.descriptor, data)
        parts.append(bytes(builder.build()))
    return b"".join(parts)


def test_why_a_filter_does_not_run() -> None:
    found = findings.of(examined(with_status(1 | 1 << 3 | 1 << 9)))
    assert [f.cause for f in found] == ["heading_warning", "mounting_transform_warning"]
    heading, mounting = found
    assert "100% of filter_data.status, also at the end" in heading.text and "heading source" in heading.remedy
    assert heading.details == (
        "affects filter_data.attitude_quaternion, filter_data.attitude_dcm, filter_data.euler_angles",
    )
    assert "`mip fields 3dm.sensor_to_vehicle_transform_euler`" in mounting.details[0]
    (unknown,) = findings.of(examined(with_status(8), device=None))
    assert unknown.cause == "unknown device"


def test_which_bits_are_set_at_the_end() -> None:
    """Each bit by itself, wherever the log is divided."""
    begun, ended = with_status(1 | 1 << 3), with_status(1 | 1 << 9)
    heading, mounting = findings.of(examined(begun[: len(begun) // 2] + ended[len(begun) // 2 :]))
    assert (heading.cause, mounting.cause) == ("heading_warning", "mounting_transform_warning")
    assert ", not at the end" in heading.text and ", also at the end" in mounting.text


def test_sentences_without_packets() -> None:
    """All are counted, however long the log is."""
    (found,) = findings.of(examined(SENTENCE * 10_000))
    assert found.text == "no packet, but 10000 NMEA sentences"


def test_sentences_are_those_of_info() -> None:
    """In noise, too, as long as that has a sentence by chance only if its checksum is right."""
    noise = random.Random(1).randbytes(1 << 16) + b"$\n$GPZDA,,,,,,*49\r\n$GPZDA\n"
    data = SENTENCE + noise + b"ue\x80" + SENTENCE * 2
    assert len(re.findall(rb"\$[ -~]*\r?\n", data)) > 5
    assert examined(data).sentences == log_report.examine(read_log(data)).sentences == 3


def test_a_time_that_is_not_valid() -> None:
    data = b"".join(_invalid(packet) for packet in packets())
    found = findings.of(examined(data))
    assert [f.cause for f in found] == ["not in time sync"] * 3
    assert "sensor: 800 of 800 timestamps with a date are not valid" in found[0].text


def _invalid(packet: bytes) -> bytes:
    (parsed,) = Parser().feed(packet)
    builder = PacketBuilder(parsed.set)
    for raw in parsed:
        data = bytes(raw.data)
        builder.add(raw.descriptor, data[:-2] + b"\0\0" if raw.descriptor == 0xD3 else data)
    return bytes(builder.build())


# --------------------------------------------------------------------------- the program


def test_a_log(tmp_path: Path) -> None:
    path, page = tmp_path / "log.bin", tmp_path / "log.html"
    path.write_bytes(clean())
    assert mip("doctor", path, "--device", DEVICE) == (0, f"{path}: 1000 packets in 8.0 s\nnothing is wrong\n", "")
    path.write_bytes(damaged())
    code, out, _ = mip("doctor", path, "--device", DEVICE, "--html", page)
    assert code == 1 and "line damage: 2 times" in out and "check cable, baud rate and grounding" in out
    text = page.read_text("utf-8")
    assert "<svg" in text and text.count("<line ") == 2 and "line damage" in text and "http" not in text
    code, out, _ = mip("doctor", path, "--json")
    assert code == 1 and json.loads(out)["findings"][0]["cause"] == "line damage"
    assert mip("doctor", "-", data=clean())[0] == 0
    assert mip("doctor", path, "sensor.scaled_accel@10")[0] == 2


@pytest.fixture(scope="module")
def place() -> Iterator[str]:
    with simulated() as found:
        yield found


def test_a_device_and_its_rates(place: str) -> None:
    words = ("--duration", "3")
    code, out, error = mip("doctor", place, *words)
    assert (code, error) == (1, "") and "idle: the device answers, but sends no data" in out
    stream = ("sensor.scaled_accel@100", "reference_timestamp@100", "--packets", "1")
    assert mip("stream", place, *stream)[0] == 0
    code, out, _ = mip("doctor", place, *words, "sensor.scaled_accel@100")
    assert code == 0 and out.endswith("nothing is wrong\n")
    code, out, _ = mip("doctor", place, *words, "sensor.scaled_accel@300", "sensor.scaled_gyro@2000")
    assert code == 1
    assert "sensor.scaled_accel: 100 Hz instead of 300 Hz\n  rates are 1000 Hz divided by whole numbers" in out
    assert "sensor.scaled_gyro: 0 Hz instead of 2000 Hz\n  the base rate of sensor is 1000 Hz" in out


@pytest.mark.usefixtures("no_reply_comes")
@pytest.mark.parametrize(
    ("sends", "cause"),
    [(b"", "no device: nothing arrives"), (b"\x13\x37" * 20, "wrong port: bytes arrive, but no packets")],
    ids=["silence", "noise"],
)
def test_what_is_no_device(sends: bytes, cause: str) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            connection, _ = server.accept()
            with connection, suppress(OSError):
                while not select.select([connection], [], [], 0.02)[0] or connection.recv(100):
                    connection.sendall(sends)

        Thread(target=serve, daemon=True).start()
        code, out, _ = mip("doctor", f"127.0.0.1:{server.getsockname()[1]}", "--duration", "2")
    assert code == 1 and cause in out


@pytest.mark.parametrize(
    ("error", "cause"),
    [
        (OSError(errno.EBUSY, "busy"), "port in use"),
        (PermissionError(errno.EACCES, "denied"), "no permission"),
        (FileNotFoundError(errno.ENOENT, "no such file"), "no such port"),
        (ConnectionRefusedError(errno.ECONNREFUSED, "refused"), "wrong port"),
        (ImportError("pyserial is missing"), "missing extra"),
    ],
)
def test_a_port_that_cannot_be_opened(error: Exception, cause: str) -> None:
    found = why_not_open("COM9", error)
    assert found.cause == cause and found.remedy
