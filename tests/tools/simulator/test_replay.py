"""A replayed log: recorded values come back at their times, the rest follows from the recorded motion."""

from __future__ import annotations

from math import dist
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import PacketBuilder
from mip_simulator.motion import Circle, Motion, MotionError, Replay, Standing, parse_motion
from mip_simulator.surroundings.surroundings import START
from mip_tools.geometry.earth import WEEK
from simulated import SETS, TYPES, Shown

SECOND = 10**9
MOTION = ["filter_data.llh_position", "filter_data.ned_velocity", "filter_data.attitude_quaternion"]


def record(
    path: Path, motion: Motion, formats: dict[str, list[str]], seconds: float = 10, rate: int = 20, noise: str = ""
) -> Shown:
    """Writes a log at a rate; each value of `formats` lists the fields of a packet."""
    shown = Shown(motion)
    log = bytearray()
    for i in range(round(seconds * rate)):
        shown.at(i / rate)
        for names in formats.values():
            number = next(SETS[n] for n in names if not n.startswith("shared."))
            builder = PacketBuilder(number)
            for name in names:
                for data in shown.raw(name):
                    builder.add(TYPES[name].DESCRIPTOR, data)
            log += bytes(builder.build()) + noise.encode()
    path.write_bytes(log)
    return shown


@pytest.fixture
def log(tmp_path: Path) -> Path:
    return tmp_path / "log.bin"


def pressure(value: float) -> bytes:
    kind: Any = TYPES["sensor.scaled_pressure"]
    return bytes(PacketBuilder(0x80).add(0x17, kind(float(value)).encode()).build())


def test_recorded_values_come_back(log: Path) -> None:
    """Byte for byte at their times, and until the next one; other bytes between the packets do not matter."""
    recorded = record(
        log,
        Circle(),
        {"f": ["shared.gps_timestamp", *MOTION], "s": ["shared.gps_timestamp", "sensor.scaled_accel"]},
        noise="$GPGGA,noise*00\r\n",
    )
    replay = Replay(log)
    shown = Shown(replay)
    assert replay.start == START and replay.duration == pytest.approx(10 - 1 / 20)
    for t in (0.0, 0.05, 3.35, 9.95):
        wanted = [recorded.at(t).raw(name) for name in (*MOTION, "sensor.scaled_accel")]
        for later in (0.0, 0.049):
            assert [shown.at(t + later).raw(name) for name in (*MOTION, "sensor.scaled_accel")] == wanted


def test_a_log_without_a_motion_is_at_rest(log: Path) -> None:
    record(log, Circle(), {"s": ["shared.reference_timestamp", "sensor.scaled_mag"]})
    replay = Replay(log)
    s, rest = replay.at(3), Standing().at(3)
    assert (s.velocity, s.acceleration, s.rate) == ((0, 0, 0),) * 3 and replay.start is None
    assert dist((s.latitude, s.longitude, s.height), (rest.latitude, rest.longitude, rest.height)) < 1e-12


def test_the_end_of_a_log(log: Path) -> None:
    """The last values stay and the device rests; or the log begins anew."""
    recorded = record(log, Circle(), {"f": ["shared.gps_timestamp", *MOTION]})
    once, again = Shown(Replay(log)), Shown(Replay(log, loop=True))
    last, third = recorded.at(9.95).raw(MOTION[0]), recorded.at(0.15).raw(MOTION[0])
    assert once.at(500).raw(MOTION[0]) == last and once.world.state.velocity == (0, 0, 0) == once.world.state.rate
    assert again.at(9.95 * 7 + 0.16).raw(MOTION[0]) == third


def test_times_are_those_of_the_simulation(log: Path) -> None:
    """The simulation begins when the log does; the clocks of the log are not replayed."""
    record(log, Circle(), {"f": ["shared.gps_timestamp", "filter_data.timestamp", *MOTION]})
    shown = Shown(Replay(log)).at(500)
    assert shown("filter_data.timestamp").tow == 500 == shown("shared.gps_timestamp").tow
    assert shown("shared.gps_timestamp").week_number == START // WEEK
    later = Shown(Replay(log), start=START + WEEK).at(500)
    assert later("shared.gps_timestamp").week_number == START // WEEK + 1


def test_fields_of_one_epoch_come_together(log: Path) -> None:
    """All of one time are sent."""
    shown = Shown(Circle())
    log_bytes = bytearray()
    for t in (0.0, 0.5, 1.0):
        stamp = shown.at(t).raw("shared.gps_timestamp")[0]
        for data in shown.raw("gnss_1.satellite_status"):
            log_bytes += bytes(PacketBuilder(0x91).add(0xD3, stamp).add(0x20, data).build())
    log.write_bytes(log_bytes)
    replayed = Shown(Replay(log))
    for t in (0.0, 0.5, 1.0):
        assert replayed.at(t + 0.2).raw("gnss_1.satellite_status") == shown.at(t).raw("gnss_1.satellite_status")


def test_packets_without_a_time_are_spread(log: Path) -> None:
    """Between those with a time, in equal steps; setting the clock makes no gap."""
    shown = Shown(Standing())
    builder = bytearray()
    for i in range(20):
        if i % 10 == 0:
            shown.world.ahead += 1000 * SECOND if i else 0
            builder += bytes(PacketBuilder(0x80).add(0xD3, shown.at(i / 10).raw("shared.gps_timestamp")[0]).build())
        builder += pressure(900 + i)
    builder += bytes(PacketBuilder(0x80).add(0xD3, shown.at(2.0).raw("shared.gps_timestamp")[0]).build())
    log.write_bytes(builder)
    replay = Replay(log)
    assert replay.duration == pytest.approx(1.0), "the jump of 1000 s counts nothing"
    wanted: Any = TYPES["sensor.scaled_pressure"]
    shown_at = [wanted.decode(replay.recorded(0x80, 0x17, i / 10 + 0.095)[0]).scaled_pressure for i in range(10)]
    assert shown_at == [910.0 + i for i in range(10)]


def test_a_log_without_times_needs_a_rate(log: Path) -> None:
    log.write_bytes(b"".join(map(pressure, range(50))))
    with pytest.raises(MotionError) as error:
        Replay(log)
    assert str(error.value) == f"replay: {log} has no times; add the rate of its packets: rate=HZ"
    replay = parse_motion(f"replay:file={log},rate=10,loop=yes")
    assert isinstance(replay, Replay) and replay.duration == pytest.approx(4.9)
    assert TYPES["sensor.scaled_pressure"].decode(replay.recorded(0x80, 0x17, 2.05)[0]).scaled_pressure == 20  # type: ignore[attr-defined]


def test_a_clock_that_is_not_valid_runs_nevertheless(log: Path) -> None:
    """As on a device that is not synchronized: the log has times, but no date at which it begins."""
    stamp: Any = TYPES["sensor.gps_timestamp"]
    for week in (0, 2300):
        log.write_bytes(
            b"".join(bytes(PacketBuilder(0x80).add(0x12, stamp(7.0 + i, week, 0).encode()).build()) for i in range(4))
        )
        replay = Replay(log)
        assert replay.duration == 3 and replay.start is None


@pytest.mark.parametrize(
    "content, message",
    [(None, "replay: cannot read "), (b"", "has no data packets"), (b"hello" * 99, "has no data packets")],
)
def test_logs_that_are_none(log: Path, content: bytes | None, message: str) -> None:
    if content is not None:
        log.write_bytes(content)
    with pytest.raises(MotionError, match=message):
        parse_motion(f"replay:file={log}")
