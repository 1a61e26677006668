"""`mip doctor`: planted causes in logs are named, and nothing else; ports with faults."""

from __future__ import annotations

import errno
import json
import math
import random
import re
import select
import socket
import struct
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import cache, partial
from pathlib import Path
from threading import Thread

import mip_tools
import numpy as np
import pytest
import timed_packets
from mip_protocol import PacketBuilder, Parser, checksum, filter_data, sensor, shared
from mip_simulator import VirtualDevice
from mip_simulator.motion import parse_motion
from mip_tools.columns import read_log
from mip_tools.doctor import findings, stream
from mip_tools.doctor.events import Event, merged_events
from mip_tools.doctor.examined import Examined
from mip_tools.doctor.port import Patient, why_not_open
from mip_tools.doctor.values import _Channel
from mip_tools.logs import report
from mip_tools.logs.recognize import recognized
from program import DEVICE, Rates, mip, reply, sent, simulated, streaming

#: What the logs of these tests have.
RATES: Rates = {
    0x80: ((0xD3, 10), (0xD5, 10), (0x04, 10), (0x05, 10), (0x06, 20)),
    0x82: ((0xD3, 50), (0xD5, 50), (0x05, 50), (0x10, 50)),
    0x91: ((0xD3, 1), (0xD5, 1), (0x03, 1)),
}


@cache
def clean(seconds: float = 8.0) -> bytes:
    device = VirtualDevice(DEVICE)
    return sent(device, streaming(device, RATES), seconds)


def packets() -> list[bytes]:
    return [bytes(packet) for packet in Parser().feed(clean())]


def examined(data: bytes, device: str | None = DEVICE) -> Examined:
    return stream.examine_log(read_log(data, device=device))


def without(numbers: Sequence[int]) -> bytes:
    return b"".join(packet for i, packet in enumerate(packets()) if i not in numbers)


def of_sensor() -> list[int]:
    return [i for i, packet in enumerate(packets()) if packet[2] == 0x80]


def changed(packet: bytes, number: int, change: Callable[[bytes], bytes], number_of_set: int | None = None) -> bytes:
    """The packet with other data in the fields with this descriptor, of one set or of any."""
    (parsed,) = Parser().feed(packet)
    builder = PacketBuilder(parsed.set)
    for raw in parsed:
        data, concerned = bytes(raw.data), raw.descriptor == number and number_of_set in (None, raw.set)
        builder.add(raw.descriptor, change(data) if concerned else data)
    return bytes(builder.build())


def stepped(packet: bytes, seconds: float) -> bytes:
    """The packet with another GPS time."""

    def later(data: bytes) -> bytes:
        value = shared.GpsTimestamp.decode(data)
        value.tow += seconds
        return bytes(value.encode())

    return changed(packet, shared.GpsTimestamp.DESCRIPTOR, later)


# --------------------------------------------------------------------------- planted causes

SENTENCE = b"$GPZDA,,,,,,*48\r\n"


def damaged() -> bytes:
    data = bytearray(clean())
    for at in (3000, 20000):
        data[at] ^= 0x55
    return bytes(data)


def reset() -> bytes:
    device = VirtualDevice(DEVICE, seed=1)  # else it would send the same data again
    return clean() + sent(device, streaming(device, RATES), 6)


def another_format() -> bytes:
    device = VirtualDevice(DEVICE)
    first = sent(device, streaming(device, RATES), 6)
    slower = {0x80: ((0xD3, 20), (0xD5, 20), (0x04, 20), (0x05, 20))}
    return first + sent(device, streaming(device, slower), 6)


PLANTED: dict[str, tuple[Callable[[], bytes], list[tuple[str, set[int]]]]] = {
    "nothing": (clean, []),
    "NMEA, and an end within a packet": (
        lambda: b"".join(packets()[:300]) + SENTENCE + b"".join(packets()[300:]) + packets()[0][:10],
        [("cut off", set())],
    ),
    "an end within a sentence": (lambda: clean() + SENTENCE[:9], []),
    "a sentence with a wrong checksum": (
        lambda: b"".join(packets()[:300]) + SENTENCE.replace(b",", b"1", 1) + b"".join(packets()[300:]),
        [("line damage", set())],
    ),
    "an end within the first bytes": (lambda: clean() + packets()[0][:3], [("cut off", set())]),
    "a begin within a packet": (lambda: clean()[7:], []),
    "damage": (damaged, [("line damage", {0x80}), ("line damage", {0x80})]),
    "single packets": (lambda: without([of_sensor()[i] for i in (100, 200, 201, 305)]), [("overload", {0x80})] * 3),
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
    assert [f.cause for f in findings.in_stream(found)] == list(dict.fromkeys(cause for cause, _ in causes))
    with mip_tools.read_log(make()) as log:
        assert found.rates == {(x.set, x.descriptor): x.rate for x in log.types() if x.rate}
    monkeypatch.setattr(stream, "PART", 7000)
    parts = examined(make())
    assert (parts.events, parts.rates) == (found.events, found.rates)
    assert findings.in_stream(parts) == findings.in_stream(found)


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
    device = VirtualDevice(DEVICE, seed=1)
    found = examined(bytes(data) + sent(device, streaming(device, RATES), 3))
    assert [e.cause for e in found.events] == ["overload", "line damage", "reset"]


#: The causes, and what each explains at the same place.
GAPS = {"pause", "overload"}
EXPLAINED: dict[str, set[str]] = {
    "reset": {"clock step", "changed format", *GAPS},
    "clock step": GAPS,
    "line damage": GAPS,
    "changed format": GAPS,
    "pause": {"overload"},
    "overload": set(),
    "duplicated": GAPS,
    "out of order": GAPS,
    "frozen": set(),
}


def test_events_that_meet_are_merged() -> None:
    """What explains the other one remains, and two of one cause become one."""
    for first in EXPLAINED:
        for second in EXPLAINED:
            meeting = merged_events([Event(first, 0, 100, None), Event(second, 50, 150, None)])
            explained = EXPLAINED[first] & {second} | EXPLAINED[second] & {first}
            assert sorted(e.cause for e in meeting) == sorted({first, second} - explained)
            apart = merged_events([Event(first, 0, 100, None), Event(second, 9000, 9100, None)])
            assert [e.cause for e in apart] == [first, second]


def test_without_a_time() -> None:
    device = VirtualDevice(DEVICE)
    found = examined(sent(device, streaming(device, {0x80: ((0x04, 10),)}), 2))
    assert [f.cause for f in findings.in_stream(found)] == ["no timestamps"] and found.events == []


# --------------------------------------------------------------------------- damage of other kinds

Vector = tuple[float, float, float]


def vectors(descriptor: int, change: Callable[[int, float, float, float], Vector], first: int = 0) -> bytes:
    """The log with other vectors of a sensor, from a packet on."""

    def changed_at(i: int) -> Callable[[bytes], bytes]:
        return lambda data: struct.pack(">3f", *change(i, *struct.unpack(">3f", data)))

    return b"".join(
        changed(p, descriptor, changed_at(i)) if i >= first and p[2] == 0x80 else p for i, p in enumerate(packets())
    )


def held(first: int, *numbers: int) -> bytes:
    """The log in which these fields of each set keep the data that they had at a packet."""
    kept: dict[tuple[int, int], bytes] = {}

    def keeping(number_of_set: int, number: int) -> Callable[[bytes], bytes]:
        return lambda data: kept.setdefault((number_of_set, number), data)

    parts = []
    for i, packet in enumerate(packets()):
        for number in numbers if i >= first else ():
            packet = changed(packet, number, keeping(packet[2], number))
        parts.append(packet)
    return b"".join(parts)


def filtered(change: Callable[[int, bytes], bytes]) -> bytes:
    """The log with other Euler angles of the filter."""
    return b"".join(changed(p, 0x05, partial(change, i), 0x82) for i, p in enumerate(packets()))


def turning(i: int, data: bytes) -> bytes:
    return struct.pack(">3f", math.sin(min(i, 250)), 0.1, 0.2) + data[12:]


def flipped(packet: bytes, seed: int) -> bytes:
    data, at = bytearray(packet), random.Random(seed).randrange(len(packet))
    data[at] ^= 1 << seed % 8
    return bytes(data)


def moved(source: int, place: int) -> bytes:
    every = packets().copy()
    every.insert(place, every.pop(source))
    return b"".join(every)


def other_order() -> bytes:
    every = packets().copy()
    for at in range(20, len(every) - 1, 20):
        every[at], every[at + 1] = every[at + 1], every[at]
    return b"".join(every)


#: Damage -> the log, and its cause.
DAMAGE: dict[str, tuple[Callable[[], bytes], str]] = {
    "some packets twice": (lambda: b"".join(p * (1 + (i % 50 == 7)) for i, p in enumerate(packets())), "duplicated"),
    "each packet twice": (lambda: b"".join(p * 2 for p in packets()), "duplicated"),
    "a block twice": (lambda: b"".join(packets()[:500] + packets()[400:]), "duplicated"),
    "a packet later": (lambda: moved(101, 103), "out of order"),
    "a packet much earlier": (lambda: moved(230, 200), "out of order"),
    "other order": (other_order, "out of order"),
    "one axis frozen": (lambda: vectors(5, lambda i, x, y, z: (0.0123, y, z), 400), "frozen"),
    "a sensor frozen": (lambda: held(300, 0x05), "frozen"),
    "a sensor 0 from the middle on": (lambda: vectors(5, lambda i, x, y, z: (0, 0, 0), 500), "frozen"),
    "the filter frozen": (lambda: filtered(turning), "frozen"),
    "a sensor dead": (lambda: vectors(6, lambda i, x, y, z: (0, 0, 0)), "dead"),
    "one axis dead": (lambda: vectors(6, lambda i, x, y, z: (x, y, 0)), "dead"),
    "NaN": (lambda: vectors(5, lambda i, x, y, z: (x, math.nan if i % 97 == 0 else y, z)), "not a number"),
    "infinity": (lambda: vectors(6, lambda i, x, y, z: (math.inf if 400 < i < 410 else x, y, z)), "not a number"),
    "NaN of the filter": (lambda: filtered(lambda i, d: struct.pack(">f", math.nan) + d[4:]), "not a number"),
    "both ends of the range": (
        lambda: vectors(4, lambda i, x, y, z: (max(-8, min(8, 12 * math.sin(i / 9))), y, z)),
        "saturated",
    ),
    "one end of the range": (
        lambda: vectors(5, lambda i, x, y, z: (x, min(5.2, 6 * math.sin(i / 30) + x), z)),
        "saturated",
    ),
    "single values": (lambda: vectors(5, lambda i, x, y, z: (x, y + 50 * (i % 200 == 104), z)), "spikes"),
    "upside down": (lambda: vectors(4, lambda i, x, y, z: (x, y, -z)), "orientation"),
    "on its side": (lambda: vectors(4, lambda i, x, y, z: (z, y, x)), "orientation"),
    "in m/s²": (lambda: vectors(4, lambda i, x, y, z: (9.81 * x, 9.81 * y, 9.81 * z)), "scale"),
    "an end within a packet": (lambda: clean()[: len(clean()) // 2 + 5], "cut off"),
    "flipped bits": (
        lambda: b"".join(flipped(p, i) if i % 99 == 9 else p for i, p in enumerate(packets())),
        "line damage",
    ),
    "bytes lost": (lambda: b"".join(p[:-3] if i % 200 == 9 else p for i, p in enumerate(packets())), "line damage"),
    "zeros": (lambda: b"".join(packets()[:300]) + bytes(4096) + b"".join(packets()[300:]), "never written"),
    "each third packet missing": (
        lambda: b"".join(p for i, p in enumerate(p for p in packets() if p[2] == 0x80) if i % 3),
        "overload",
    ),
    "another byte order": (
        lambda: vectors(5, lambda i, *xyz: struct.unpack("<3f", struct.pack(">3f", *xyz))),
        "implausible",
    ),
    "0D before 0A": (lambda: clean().replace(b"\n", b"\r\n"), "no packets"),
    "as UTF-8": (lambda: clean().decode("latin-1").encode(), "no packets"),
    "clocks stuck": (lambda: held(300, 0xD3, 0xD5), "stuck"),
    "the filter never valid": (lambda: filtered(lambda i, data: data[:12] + b"\0\0"), "not valid"),
}


@pytest.mark.parametrize("name", DAMAGE)
def test_damage_is_named_by_its_cause(name: str) -> None:
    """And by nothing else, but for what follows from it."""
    make, cause = DAMAGE[name]
    found = [f.cause for f in findings.in_stream(examined(make()))]
    others = {*found} - {"stuck", "overload", "not a number", cause}
    assert cause in found and not others, found


def test_saturation_is_reported_where_it_begins() -> None:
    """Not where equal values are, such as a pause of the sensor, occur elsewhere."""
    values = np.random.default_rng(1).random(400)
    values[20:60] = 0.25
    values[[*range(100, 104), *range(200, 204)]] = 1.5
    channel = _Channel("x", True)
    channel.add(values, np.arange(400) * 10, lambda at: at)
    assert [(cause, run.offset) for cause, run, _ in channel.findings()] == [("saturated", 1000)]


def test_spikes_are_found_wherever_a_log_is_divided() -> None:
    values = np.random.default_rng(1).normal(size=300)
    values[150] = 1e4
    for seam in (149, 150, 151, 152):
        channel = _Channel("x", True)
        for part in (slice(seam), slice(seam, None)):
            channel.add(values[part], np.arange(300)[part], lambda at: at)
        assert [(cause, run.number, run.offset) for cause, run, _ in channel.findings()] == [("spikes", 1, 150)], seam


@pytest.mark.parametrize("device", ["3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-gq7", "3dm-cv7-gnss-ins"])
@pytest.mark.parametrize("motion", ["standing", "circle:radius=20,speed=5"])
def test_nothing_is_wrong_with_healthy_logs(device: str, motion: str) -> None:
    virtual = VirtualDevice(device, motion=parse_motion(motion), sync=True)
    rates: Rates = {0x80: RATES[0x80], 0x82: ((0xD3, 10), (0x05, 10), (0x10, 10))}
    assert [f.cause for f in findings.in_stream(examined(sent(virtual, streaming(virtual, rates), 4), device))] == []


# --------------------------------------------------------------------------- the filter and the time


def with_status(flags: int) -> bytes:
    """A log in which the filter has these flags."""
    return b"".join(changed(p, 0x10, lambda data: data[:4] + flags.to_bytes(2, "big"), 0x82) for p in packets())


def test_why_a_filter_does_not_run() -> None:
    found = findings.in_stream(examined(with_status(1 | 1 << 3 | 1 << 9)))
    assert [f.cause for f in found] == ["heading_warning", "mounting_transform_warning"]
    heading, mounting = found
    assert "100% of filter_data.status, also at the end" in heading.text and "heading source" in heading.remedy
    assert heading.details == (
        "affects filter_data.attitude_quaternion, filter_data.attitude_dcm, filter_data.euler_angles",
    )
    assert "`mip fields 3dm.sensor_to_vehicle_transform_euler`" in mounting.details[0]


def test_flags_that_depend_on_the_device() -> None:
    """They are known if all devices with these fields, and with these flags of times, have the same."""

    def causes(data: bytes) -> set[str]:
        return {found.cause for found in findings.in_stream(examined(data, device=None))}

    assert causes(with_status(8)) == {"heading_warning"}
    assert causes(with_status(8) + reply("3dm-gx5-25") + reply("3dm-cv7-ahrs")) == {"several devices"}
    status = bytes(filter_data.Status(2, 1, 9).packet())
    times = [bytes(sensor.GpsTimestamp(100 + i / 100, 2300, 7).packet()) for i in range(40)]
    assert causes(40 * status) == {"unknown device", "no timestamps"}
    assert causes(b"".join(time + status for time in times)) == {
        "run_imu_unavailable", "run_matrix_singularity", "no timestamps",
    }  # fmt: skip


def test_built_in_tests() -> None:
    """Of every device that has one; that a receiver has no position is no fault."""
    flags = sum(1 << bit for bit in (1, 40, 105, 108, 110))
    data = timed_packets.packet(0xA0, (0x01, flags.to_bytes(16, "little"))) * 3
    for device, more in (("3dm-cv7-gnss-ins", {"receiver_1_fault", "receiver_2_fault"}), ("3dm-cv7-ahrs", set[str]())):
        found = {f.cause: f for f in findings.in_stream(examined(data, device))}
        assert found.keys() - {"no timestamps"} == {"power_fault", "accel_general_fault"} | more
        assert found["accel_general_fault"].details == ("affects sensor.scaled_accel",)


def test_only_a_filter_that_starts_is_not_ready() -> None:
    for state, text in (
        (1, "the filter is not ready: filter_state 1 (init)"),
        (2, "filter_state 2 (run_solution_valid)"),
    ):
        status = struct.pack(">3H", state, 1, 0)
        data = timed_packets.packet(0x82, (0x05, struct.pack(">3fH", 0, 0, 0, 0)), (0x10, status)) * 3
        found = next(f for f in findings.in_stream(examined(data, "3dm-gx5-15")) if f.cause == "not valid")
        assert found.remedy == f"{text} at the end"


def test_which_bits_are_set_at_the_end() -> None:
    """Each bit by itself, wherever the log is divided."""
    begun, ended = with_status(1 | 1 << 3), with_status(1 | 1 << 9)
    heading, mounting = findings.in_stream(examined(begun[: len(begun) // 2] + ended[len(begun) // 2 :]))
    assert (heading.cause, mounting.cause) == ("heading_warning", "mounting_transform_warning")
    assert ", not at the end" in heading.text and ", also at the end" in mounting.text


def test_an_empty_log_says_nothing_about_fields(tmp_path: Path) -> None:
    (tmp_path / "log.bin").touch()
    code, out, _ = mip("doctor", tmp_path / "log.bin")
    assert code == 1 and "no packet in 0 bytes" in out and "examined" not in out


def test_packets_whose_fields_do_not_fit(tmp_path: Path) -> None:
    """Their checksums are right, so nothing else is wrong with them."""
    broken = b"ue\x80\x04\x06\x04\x01\x02"
    (tmp_path / "log.bin").write_bytes((broken + checksum(broken)) * 3)
    code, out, _ = mip("doctor", tmp_path / "log.bin")
    assert code == 1 and "malformed packets: 3 packets with a field that runs past the end\n" in out, out


def test_sentences_without_packets() -> None:
    """All are counted, however long the log is."""
    found = examined(SENTENCE * 10_000)
    assert found.sentences == 10_000
    assert [f.text for f in findings.in_stream(found)] == ["no packet in 170000 bytes: NMEA sentences"]


@pytest.mark.parametrize("name", ["GPGGA", "GNRMC", "HEHDT", "GIGSV", "PUBX", "PASHR"])
def test_sentences_with_wrong_checksums(name: str) -> None:
    """Of any talker and any maker."""
    found = recognized(f"${name},1,2*00\r\n".encode() * 5)
    assert found is not None and found.what == "NMEA sentences, with wrong checksums"


def test_sentences_are_those_of_info() -> None:
    """In noise, too, as long as that has a sentence by chance only if its checksum is right."""
    noise = random.Random(1).randbytes(1 << 16) + b"$\n$GPZDA,,,,,,*49\r\n$GPZDA\n"
    data = SENTENCE + noise + b"ue\x80" + SENTENCE * 2
    assert len(re.findall(rb"\$[ -~]*\r?\n", data)) > 5
    assert examined(data).sentences == report.report_on(read_log(data)).sentences == 3


def test_a_time_that_is_not_valid() -> None:
    data = b"".join(changed(p, 0xD3, lambda data: data[:-2] + b"\0\0") for p in packets())
    found = findings.in_stream(examined(data))
    assert [f.cause for f in found] == ["not synchronized"] * 3
    assert "sensor: none of 800 timestamps has a date" in found[0].text


def test_values_tell_which_devices_may_have_sent_a_field() -> None:
    """Bit 12 of the status, and a filter condition of 0, mean something on older devices only."""
    log = read_log(
        b"".join(
            timed_packets.packet(0x82, (0x05, struct.pack(">3fH", 0, 0, 0, 0)), (0x10, struct.pack(">3H", 1, 1, flags)))
            for flags in (0x1000,) * 3
        )
    )
    warned = stream.examine_log(log)
    assert [w.bit for w in warned.warned] == ["init_no_attitude"] and not warned.unnamed
    assert log.assumed() == ["filter_data.status: flags read as those of generations 4 and 5 (recognized)"]


# --------------------------------------------------------------------------- the program


def test_a_log(tmp_path: Path) -> None:
    path = tmp_path / "log.bin"
    path.write_bytes(clean())
    assert mip("doctor", path, "--device", DEVICE) == (
        0,
        f"{path}: 1000 packets in 8.0 s\n"
        "nothing is wrong; examined damage, gaps, clocks, flags and values of 12 fields in 3 sets\n",
        "",
    )
    path.write_bytes(damaged())
    code, out, _ = mip("doctor", path, "--device", DEVICE)
    assert code == 1 and "line damage: 2 times" in out and "check cable, baud rate and grounding" in out
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
    assert code == 1 and "idle: the device answers, but sends no data" in out
    assert error == "mip doctor: device 3DM-CV7-GNSS/INS (at the port)\n"
    stream = ("sensor.scaled_accel@100", "reference_timestamp@100", "--packets", "1")
    assert mip("stream", place, *stream)[0] == 0
    code, out, _ = mip("doctor", place, *words, "sensor.scaled_accel@100")
    assert code == 0 and "\nnothing is wrong; examined damage, gaps, clocks, flags and values of " in out
    code, out, _ = mip("doctor", place, *words, "sensor.scaled_accel@300", "sensor.scaled_gyro@2000")
    assert code == 1
    assert "sensor.scaled_accel: 100 Hz instead of 300 Hz\n  rates are 1000 Hz divided by whole numbers" in out
    assert "sensor.scaled_gyro: 0 Hz instead of 2000 Hz\n  the base rate of sensor is 1000 Hz" in out


def test_rates_of_an_older_device() -> None:
    with simulated(device="3dm-gx5-15") as place:
        assert mip("stream", place, "sensor.scaled_accel@100", "--packets", "1")[0] == 0
        out = mip("doctor", place, "--duration", "1", "sensor.scaled_accel@2000", "sensor.scaled_gyro@300")[1]
    assert "instead of 2000 Hz\n  the base rate of sensor is 1000 Hz" in out
    assert "instead of 300 Hz\n  rates are 1000 Hz divided by whole numbers; the nearest is 333.33 Hz" in out


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


def test_a_port_that_is_lost_says_nothing_about_the_device() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            connection, _ = server.accept()
            with connection:
                connection.recv(100)

        Thread(target=serve, daemon=True).start()
        name = f"127.0.0.1:{server.getsockname()[1]}"
        assert mip("doctor", name, "--duration", "0.1")[:2] == (
            1,
            f"{name}: 0 packets\nport lost: the port was closed meanwhile\n"
            "  check the connector and the power supply\n",
        )


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


@pytest.mark.parametrize(("size", "text"), [(9_000, None), (11_000, "95% of"), (11_600, "100% of"), (80_000, None)])
def test_a_line_is_full_only_if_its_rate_limits_it(size: int, text: str | None) -> None:
    """A USB port has any rate, and carries more."""
    patient = Patient("port", 115200)
    patient.data = bytes(size)
    patient.line(1)
    assert [f.text.startswith(str(text)) for f in patient.findings] == [True] * (text is not None)
