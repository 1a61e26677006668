"""Devices with and without a date: each made-up log gives the same times in all commands.

What is right follows from how a log is made: its packets have instants, and their timestamps say what the device knew.
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
import struct
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import sensor
from mip_tools import read_log
from mip_tools.columns import tables
from mip_tools.columns.raw_times import raw
from mip_tools.columns.stamps import NONE
from mip_tools.doctor.stream import examine_log
from mip_tools.formats import live
from mip_tools.logs import inputs
from program import mip, reply, simulated
from support import heavy, later
from timed_packets import cases_of_devices, packet

np, mcap = later("numpy"), later("mcap.reader")

WEEK, TOW = 2300, 345_600.0
#: UTC at that time of week, in seconds since 1970.
DATE = 1_707_350_382.0
COUNT, STEP = 60, 0.01
TIMES = [i * STEP for i in range(COUNT)]
Field = tuple[int, bytes]


def stamp(descriptor: int, tow: float, week: int, flags: int) -> Field:
    return descriptor, struct.pack(">dHH", tow, week, flags)


def reference(seconds: float) -> Field:
    return 0xD5, struct.pack(">Q", round(seconds * 1e9))


def external(seconds: float, flags: int) -> Field:
    return 0xD7, struct.pack(">QH", round(seconds * 1e9), flags)


@dataclass
class Case:
    """A log with an acceleration per packet of the set 0x80, and what is right for each."""

    packets: list[bytes]
    dates: list[float | None] = field(default_factory=lambda: [None] * COUNT)  # UTC in s since 1970
    device: list[float | None] = field(default_factory=lambda: [None] * COUNT)  # by the clock without a date
    clock: str = "device"
    rate: float | None = 100.0
    info: tuple[str, ...] = ()  # parts of the text
    doctor: tuple[str, ...] = ()  # causes
    dated_only: bool = False  # all times are dates, so there is no other column


def sensed(stamps: Iterable[list[Field]]) -> list[bytes]:
    return [
        packet(0x80, *own, (0x04, struct.pack(">3f", i, i * 7 % 11 / 1e3, -1 + i * 5 % 13 / 1e3)))
        for i, own in enumerate(stamps)
    ]


def dates(begin: float = DATE) -> list[float | None]:
    return [begin + t for t in TIMES]


def timeless(packets: list[bytes], why: str, cause: str) -> Case:
    """A log without any valid time."""
    return Case(packets, clock="", rate=None, info=(f"no date: {why}",), doctor=(cause,))


def cases() -> dict[str, Case]:
    on = [12.5 + t for t in TIMES]  # since power-on
    week = [TOW + t for t in TIMES]
    third = COUNT // 3
    late = [i >= third for i in range(COUNT)]
    lost = [third <= i < 2 * third for i in range(COUNT)]
    restarted = [5 + t if t < 0.3 else 0.7 + t - 0.3 for t in TIMES]
    unsynchronized, never = ("no date: not synchronized",), ("not synchronized",)
    undated = ("no date: no timestamp with a date is in the packets",)
    none_is_valid = "60 timestamps of which none is valid"
    angles = (0x05, struct.pack(">3fH", 0, 0, 0, 0))
    in_no_week = {
        "never synchronized": (0x12, 0, 0), "time of week without a week": (0xD3, 0, 1),
        "week without a time of week": (0xD3, WEEK, 2), "week 0 with flags set": (0xD3, 0, 3),
    }  # fmt: skip
    return {
        "three flags": Case(sensed([stamp(0x12, t, WEEK, 7)] for t in week), dates(), dated_only=True),
        "five flags": Case(sensed([stamp(0x12, t, WEEK, 0x1D)] for t in week), dates(), dated_only=True),
        "five flags, first with three set": Case(
            sensed([stamp(0x12, t, WEEK, 0x1D if i else 7)] for i, t in enumerate(week)),
            [None, *dates()[1:]],
            week,
            doctor=never,
        ),
        **{
            name: Case(sensed([stamp(number, t, w, flags)] for t in on), device=on, info=unsynchronized, doctor=never)
            for name, (number, w, flags) in in_no_week.items()
        },
        "no timestamps": timeless(sensed([] for _ in TIMES), "no timestamps", "no timestamps"),
        "only intervals": timeless(
            sensed([(0xD6, struct.pack(">Q", 10_000_000))] for _ in TIMES), "no timestamps", "no timestamps"
        ),
        "only the reference clock": Case(
            sensed([reference(t)] for t in on), device=on, clock="reference", info=undated
        ),
        "reference clock and no date": Case(
            sensed([stamp(0xD3, 0, 0, 0), reference(t)] for t in on),
            device=on,
            clock="reference",
            info=("no date: not synchronized",),
            doctor=("not synchronized", "stuck"),
        ),
        "not a number": timeless(sensed([stamp(0xD3, math.nan, 0, 0)] for _ in TIMES), none_is_valid, "no valid time"),
        "time of week that is in no week": timeless(
            sensed([stamp(0xD3, 604_801 + t, WEEK, 3)] for t in TIMES), none_is_valid, "no valid time"
        ),
        "week far in the future": Case(
            sensed([stamp(0xD3, w, 0xFFFF, 3)] for w in week), device=week, info=unsynchronized, doctor=never
        ),
        "only the external clock": Case(
            sensed([external(t, 1)] for t in on), device=on, clock="external", info=undated
        ),
        "external clock without pulses": timeless(sensed([external(t, 0)] for t in on), "", "no valid time"),
        "receiver without a fix": Case(
            [
                one
                for i, made in enumerate(sensed([reference(t)] for t in on))
                for one in (made, *([packet(0x91, stamp(0x09, 99.0, 0, 0))] if i % 10 == 0 else []))
            ],
            device=on,
            clock="reference",
            info=("no date: ",),
            doctor=("no valid time",),
        ),
        "timestamps in another set only": Case(
            [
                one
                for t, made in zip(on, sensed([] for _ in TIMES))
                for one in (packet(0x82, stamp(0x11, t, 0, 0), angles), made)
            ],
            clock="",
            rate=None,
            info=("no date: not synchronized", "(device clock)"),
            doctor=("not synchronized", "no timestamps", "not valid"),
        ),
        "dates in one set, the reference clock in another": Case(
            [
                one
                for i, (w, made) in enumerate(zip(week, sensed([stamp(0xD3, w, WEEK, 3)] for w in week)))
                for one in (made, *[packet(0x82, reference(12.5 + TIMES[i]), angles)] * (i % 10 == 0))
            ],
            dates(),
            clock="",
            doctor=("not valid",),
            dated_only=True,
        ),
        "synchronized in the middle": Case(
            sensed([stamp(0x12, w if ok else t, WEEK * ok, 7 * ok)] for ok, w, t in zip(late, week, on)),
            [date if ok else None for ok, date in zip(late, dates())],
            on,
            info=("(device clock)", "date: 2024-02-07T23:59:42.200Z to "),
            doctor=never,
        ),
        "synchronization lost, time of week goes on": Case(
            sensed([stamp(0x12, w, WEEK, 1 if gone else 7)] for gone, w in zip(lost, week)),
            [None if gone else date for gone, date in zip(lost, dates())],
            week,
            info=("synchronization lost for 0.2 s",),
            doctor=("synchronization lost",),
        ),
        "synchronization lost, time since power-on": Case(
            sensed(
                [stamp(0x12, t if i < 9 or gone else w, WEEK, 1 if i < 9 or gone else 7)]
                for i, (gone, w, t) in enumerate(zip(lost, week, on))
            ),
            [None if i < 9 or gone else date for i, (gone, date) in enumerate(zip(lost, dates()))],
            on,
            info=("synchronization lost for 0.2 s",),
            doctor=("synchronization lost",),
        ),
        "synchronization lost, time since power-on, after dates only": Case(
            sensed([stamp(0x12, t if gone else w, WEEK, 1 if gone else 7)] for gone, w, t in zip(lost, week, on)),
            [None if gone else date for gone, date in zip(lost, dates())],
            week,
            info=("synchronization lost for 0.2 s",),
            doctor=("synchronization lost",),
        ),
        "stuck with a date": Case(
            sensed([stamp(0xD3, TOW, WEEK, 3)] for _ in TIMES),
            [DATE] * COUNT,
            rate=None,
            info=("the gps clock of sensor is stuck at 2024-02-07",),
            doctor=("stuck",),
            dated_only=True,
        ),
        "stuck": Case(
            sensed([stamp(0xD3, 12.5, 0, 0)] for _ in TIMES),
            device=[12.5] * COUNT,
            rate=None,
            info=("the device clock of sensor is stuck at 12.500",),
            doctor=("not synchronized", "stuck"),
        ),
        "restarted": Case(
            sensed([stamp(0xD3, t, 0, 0)] for t in restarted),
            device=restarted,
            info=("time: 5.000 to 5.290, then 0.700 to 0.990, 0.580 s (device clock, which restarts 1 time)",),
            doctor=("not synchronized", "reset"),
        ),
        "reference clock restarted": Case(
            sensed([reference(t)] for t in restarted),
            device=restarted,
            clock="reference",
            info=("time: 5.000 to 5.290, then 0.700 to 0.990, 0.580 s (reference clock, which restarts 1 time)",),
            doctor=("reset",),
        ),
        "next week": Case(
            sensed([stamp(0xD3, (604_799.8 + t) % 604_800, WEEK + (t > 0.195), 3)] for t in TIMES),
            dates(DATE - TOW + 604_799.8),
            dated_only=True,
        ),
        "next week without a date": Case(
            sensed([stamp(0xD3, (604_799.8 + t) % 604_800, 0, 1)] for t in TIMES),
            device=[604_799.8 + t for t in TIMES],
            doctor=never,
        ),
    }


CASES = cases()


@pytest.fixture(params=CASES)
def case(request: pytest.FixtureRequest) -> Case:
    return CASES[request.param]


@pytest.fixture
def path(case: Case, tmp_path: Path) -> Path:
    (tmp_path / "log.bin").write_bytes(b"".join(case.packets))
    return tmp_path / "log.bin"


def near(found: Iterable[Any], wanted: Iterable[float | None], unit: float = 1) -> None:
    """Are these the same times? NaN and None are none."""
    numbers = [None if x is None or x != x else float(x) / unit for x in found]
    expected = list(wanted)
    assert [x is None for x in numbers] == [x is None for x in expected]
    there = [x for x in numbers if x is not None]
    assert there == pytest.approx([x for x in expected if x is not None], abs=2e-6)


def seconds(text: str) -> float | None:
    return float(np.datetime64(text.removesuffix("Z"), "ns").astype(np.int64)) / 1e9 if text else None


def of_rows(case: Case, rows: list[dict[str, str]]) -> None:
    assert len(rows) == COUNT
    assert ("time" in rows[0]) == any(date is not None for date in case.dates)
    assert ("time_device [s]" in rows[0]) == any(time is not None for time in case.device)
    near([seconds(row.get("time", "")) for row in rows], case.dates)
    near([float(row.get("time_device [s]") or math.nan) for row in rows], case.device)


def test_info(case: Case, path: Path) -> None:
    code, out, _ = mip("info", path, "--json")
    found = json.loads(out)
    own = next(one for one in found["sets"] if one["set"] == 0x80)
    assert code == 0 and (own["rate"] is None) == (case.rate is None)
    assert case.rate is None or own["rate"] == pytest.approx(case.rate, rel=1e-3)
    assert own["gaps"]["count"] == 0
    no_dates = all(date is None for date in case.dates)
    assert (found["clock"] == "gps") != no_dates and (found["no_date"] is None) != no_dates
    text = mip("info", path)[1]
    assert all(part in text for part in case.info), text


def test_export(case: Case, path: Path) -> None:
    words = ("export", path, "sensor.scaled_accel", "-o", "-")
    code, out, error = mip(*words)
    assert code == 0 and ("no date: " in error) == all(date is None for date in case.dates)
    of_rows(case, list(csv.DictReader(io.StringIO(out))))
    piped = mip("export", "-", *words[2:], "--format", "jsonl", data=path.read_bytes())[1]
    rows = [json.loads(line) for line in piped.splitlines()]
    near([seconds(row.get("time", "")) for row in rows], case.dates)
    near([row.get("time_device") for row in rows], case.device)


def test_stream(case: Case, path: Path) -> None:
    code, out, _ = mip("stream", path, "sensor.scaled_accel", "--format", "csv")
    assert code == 0
    rows = list(csv.DictReader(io.StringIO(out)))
    near([seconds(row.get("time", "")) for row in rows], case.dates)
    near([float(row.get("time_device [s]") or math.nan) for row in rows], case.device)


@pytest.mark.parametrize("size", [1 << 30, 300])
def test_read_log_and_its_parts(case: Case, size: int) -> None:
    log = read_log(b"".join(case.packets))
    clock = case.clock if any(time is not None for time in case.device) else None
    found: list[Any] = []
    others: list[Any] = []
    for part in log.parts(size):
        column = part[sensor.ScaledAccel]
        values = column.time("gps").values
        found += np.where(np.isnat(values), np.nan, values.astype(np.int64) / 1e9).tolist()
        if clock:
            values = column.time(clock).values
            others += np.where(np.isnat(values), np.nan, values.astype(np.int64) / 1e9).tolist()
    near(found, case.dates)
    assert not clock or near(others, case.device) is None
    (rate,) = (one.rate for one in log.types() if one.type is sensor.ScaledAccel)
    assert (rate is None) == (case.rate is None) and (rate is None or rate == pytest.approx(case.rate, rel=1e-3))


def test_times_of_devices() -> None:
    for device, data, *wanted in cases_of_devices():
        log = read_log(data, device=device)
        stamps = [raw(log, data[2], clock).value for clock in ("gps", "device")]
        found = [None if not len(own) or own[0] == NONE else int(own[0]) for own in stamps]
        assert found == wanted, (device, data.hex())


@heavy("mcap")
def test_mcap(case: Case, path: Path) -> None:
    steady = case.dates if case.dated_only else case.device
    out = path.with_suffix(".mcap")
    code = mip("export", path, "sensor.scaled_accel", "-o", out)[0]
    assert code == (not any(time is not None for time in steady))
    if code:
        return
    with open(out, "rb") as file:
        messages = mcap.make_reader(file).iter_messages(log_time_order=False)
        near([message.log_time for *_, message in messages], steady, 1e9)


def test_cut(case: Case, path: Path) -> None:
    code, _, error = mip("cut", path, "-o", path.with_suffix(".cut"), "--only", "0x80", "--end", "0.255")
    assert code == 0 or "has no valid times" in error
    if case.rate:
        size = sum(len(one) for one in case.packets if one[2] == 0x80)
        assert len(path.with_suffix(".cut").read_bytes()) * COUNT == pytest.approx(26 * size)


def test_doctor(case: Case, path: Path) -> None:
    _, out, _ = mip("doctor", path, "--json")
    assert sorted(one["cause"] for one in json.loads(out)["findings"]) == sorted(case.doctor)


@pytest.mark.parametrize("words", [("info",), ("export", "-o", "-"), ("stream", "--format", "csv")])
def test_a_named_device_reads_flags_as_its_own(words: tuple[str, ...], tmp_path: Path) -> None:
    """A 3DM-CV7 has five flags, of which these three do not mark a date."""
    (tmp_path / "log.bin").write_bytes(b"".join(CASES["three flags"].packets))
    for device, date in (("3dm-cv7-ahrs", False), ("3dm-gx5-25", True)):
        code, out, _ = mip(words[0], tmp_path / "log.bin", *words[1:], "--device", device)
        assert code == 0 and ("2024-02-07T23:59:42" in out) == date


def written(tmp_path: Path, *packets: bytes) -> Path:
    (tmp_path / "log.bin").write_bytes(b"".join(packets))
    return tmp_path / "log.bin"


def test_a_cut_keeps_the_reply_of_the_device(tmp_path: Path) -> None:
    """Flags 7 mark no date on a 3DM-CV7."""
    path = written(tmp_path, reply("3dm-cv7-ahrs"), *CASES["three flags"].packets)
    for words in (["--begin", "0.2"], ["--only", "0x80"], ["--only", "sensor.scaled_accel"]):
        assert mip("cut", path, "-o", tmp_path / "part.bin", *words)[0] == 0
        assert read_log(tmp_path / "part.bin").device == "3dm-cv7-ahrs", words
    code, _, error = mip("cut", path, "-o", tmp_path / "none.bin", "--begin", "99")
    assert code == 1 and "the part has no packets" in error


@pytest.mark.parametrize("more", [(), ("--tree",), ("--raw",), ("--count", "99")])
def test_dump_reads_flags_by_the_device_in_each_log(more: tuple[str, ...], tmp_path: Path) -> None:
    """Flags 7 mark a date on a 3DM-GX5, but not on a 3DM-CV7."""
    words = ("--only", "sensor.gps_timestamp", *more)
    paths = []
    for device, valid in (("3dm-gx5-25", True), ("3dm-cv7-ahrs", False)):
        paths.append(tmp_path / device)
        paths[-1].write_bytes(b"".join([reply(device), *CASES["three flags"].packets]))
        code, out, error = mip("dump", "-", *words, data=paths[-1].read_bytes())
        assert code == 0 and ("invalid" not in out) == valid and "(from the log)" in error, out
    code, out, error = mip("dump", *paths, *words)
    assert code == 0 and "3DM-GX5-25 (from the log)" in error and "3DM-CV7-AHRS (from the log)" in error
    if not {"--tree", "--count"} & {*more}:
        assert ["(invalid)" in line for line in out.splitlines() if ": " in line] == [False] * 60 + [True] * 60


_RECOGNIZED = "flags read as those of generations 4 and 5 (recognized)"


def status(*values: int) -> Field:
    return 0x10, struct.pack(">3H", *values)


_OLD, _NEW = stamp(0x11, 100, 0, 0), stamp(0xD3, 100, 0, 0)
#: Data without information about the device, and its filter's status by name.
STATUS = {
    # Bit 12 has a meaning in this state only, and only on older devices.
    "a filter in initialization": ([_OLD, status(1, 1, 0x1000)], "init portable init_no_attitude"),
    "position and velocity": ([_OLD, (0x02, bytes(14)), status(2, 3, 0)], "run_solution_valid airborne"),
    "a later filter": ([_NEW, status(4, 1, 1)], "full_nav default filter_condition=stable"),
    "a field of later devices": (
        [_NEW, (0x46, bytes(7)), status(2, 1, 1)],
        "vertical_gyro default filter_condition=stable",
    ),
    "of any device": ([_OLD, status(2, 1, 1)], "2 1 1"),
}


@pytest.mark.parametrize("fields", STATUS)
@pytest.mark.parametrize(
    "words",
    [
        "dump LOG", "dump LOG --tree", "dump LOG --json", "dump - --json", "monitor - --duration 1", "info LOG",
        "doctor LOG",
        "export LOG -o - --names", "export - -o - --names --format jsonl", "stream LOG --names",
        "stream LOG --names --format csv", "export LOG -o OUT.parquet --names",
        pytest.param("export LOG -o OUT.mcap --names", marks=heavy("mcap")),
    ],
)  # fmt: skip
def test_a_device_is_recognized_alike_by_all_commands(words: str, fields: str, tmp_path: Path) -> None:
    packets, wanted = STATUS[fields]
    data = packet(0x82, *packets) * 3
    path, out = written(tmp_path, data), next((w for w in words.split() if w.startswith("OUT")), "")
    _, text, error = mip(*(path if w == "LOG" else tmp_path / w if w == out else w for w in words.split()), data=data)
    if out.endswith(".mcap"):
        with open(tmp_path / out, "rb") as file:
            text = " ".join(message.data.decode() for *_, message in mcap.make_reader(file).iter_messages())
    elif out:
        text = " ".join(map(str, later("pyarrow.parquet").read_table(tmp_path / out).to_pylist()))
    named = wanted[0].isalpha()
    generations = "4 and 5" if "portable" in wanted or "airborne" in wanted else "7"
    assert ("filter_data.status: flags read as those of generation" in text + error) == named
    assert f"{generations} (recognized)" in text + error or not named
    if not words.startswith(("info", "doctor")):
        assert all(word in text for word in wanted.replace("=", " ").split()), text
    assert read_log(data).assumed() == re.findall("filter_data.status: flags.*\\)", text + error)[:1]


def test_what_is_assumed_is_known_from_the_beginning(tmp_path: Path) -> None:
    assumed = {name: read_log(b"".join(CASES[name].packets)).assumed() for name in ("three flags", "five flags")}
    assert [text.partition(": ")[2] for text in assumed["three flags"]] == [_RECOGNIZED]
    for more in ((), ("--raw",)):
        assert _RECOGNIZED in mip("dump", written(tmp_path, *CASES["three flags"].packets), *more)[2]
    assert assumed["five flags"] == []
    assert read_log(b"".join(sensed([stamp(0x12, t, 0, 0)] for t in TIMES))).assumed() == []  # no bits, no knowledge


@pytest.mark.parametrize("words", [("info",), ("dump",), ("dump", "--raw"), ("stream",), ("export", "-o", "-")])
@pytest.mark.parametrize(
    ("devices", "names"),
    [
        (["3dm-cv7-ahrs", "3dm-gx5-25"], "2 devices in the log, 3DM-CV7-AHRS and 3DM-GX5-25:"),
        (
            ["3dm-cv7-ahrs", "3dm-gx5-25", "3dm-gq7"],
            "3 devices in the log, 3DM-CV7-AHRS, 3DM-GX5-25 and 3DM-GQ7-GNSS/INS:",
        ),
    ],
)
def test_several_devices_in_a_log_are_named(
    devices: list[str], names: str, words: tuple[str, ...], tmp_path: Path
) -> None:
    path = written(tmp_path, *map(reply, devices), *CASES["three flags"].packets)
    code, out, error = mip(words[0], path, *words[1:])
    assert code == 0 and names in out + error, error


def test_a_device_that_appears_later_is_named_in_a_stream(tmp_path: Path) -> None:
    packets = CASES["three flags"].packets * 800  # longer than the part that is read before the first line
    code, _, error = mip("stream", written(tmp_path, reply("3dm-gx5-25"), *packets, reply("3dm-cv7-ahrs")))
    assert code == 0 and re.findall("device.*", error)[0] == "device 3DM-GX5-25 (from the log)"
    assert "2 devices in the log, 3DM-GX5-25 and 3DM-CV7-AHRS" in error


def test_a_receiver_with_a_date_beside_a_clock_without(tmp_path: Path) -> None:
    sensor_packets = CASES["never synchronized"].packets
    dated = [packet(0x91, stamp(0x09, TOW + i / 10, WEEK, 3)) for i in range(6)]
    together = [x for i, one in enumerate(sensor_packets) for x in ([dated[i // 10]] if i % 10 == 0 else []) + [one]]
    assert "time: 12.500 to 13.090, 0.590 s (device clock)" in mip("info", written(tmp_path, *together))[1]


def test_one_timestamp(tmp_path: Path) -> None:
    out = mip("info", written(tmp_path, CASES["stuck"].packets[0]))[1]
    assert "not synchronized; 1 of 1 timestamp without a date" in out


def test_a_live_port_is_asked_for_its_device() -> None:
    with simulated(device="3dm-gx5-25") as port:
        for words in (
            ("stream", port, "sensor.scaled_accel@50", "--packets", "3"),
            ("dump", port, "--count", "3"),
            ("monitor", port, "--duration", "1"),
        ):
            code, out, error = mip(*words)
            assert code == 0 and "device 3DM-GX5-25 (at the port)" in out + error, words
        told = "mip send: device 3DM-GX5-25 (at the port)\n"  # the bits of its reply are those of the model
        assert mip("send", port, "base.built_in_test") == (0, "result = 0 (0x0)\n", told)
        for named in ((), ("--device", "3dm-gx5-25")):
            found = json.loads(mip("send", port, "base.built_in_test", "--json", *named)[1])
            assert found["response"] == {"result": []}


def test_the_rate_of_a_field_is_one_in_all_tools(tmp_path: Path) -> None:
    """A field in each tenth packet of the second half, after a gap; two in each of these packets. An instant may have
    two packets, and a packet no timestamp."""
    angles = (0x05, struct.pack(">3fH", 0, 0, 0, 1))
    twice = [[angles] * (2 * (i >= 30 and i % 10 == 0)) for i in range(80)]
    stamps = [reference(i * STEP + (i > 40)) for i in range(80)]
    packets = [packet(0x82, stamp, *more, (0x10, bytes(6))) for stamp, more in zip(stamps, twice)]
    state, acceleration = (0x10, bytes(6)), (0x04, bytes(12))
    halves = [packet(0x82, stamp, own) for stamp in stamps[:40] for own in (angles, state)]
    no_fix = [packet(0x91, stamp(0x09, TOW, WEEK, 0), (0x03, bytes(44))), packet(0x91, (0x04, bytes(32)))]
    fix = [packet(0x91, stamp(0x09, TOW + i, WEEK, 3), (own, bytes(44))) for i in range(9) for own in (3, 4)]
    tenth = [packet(0x80, *[reference(i * STEP)] * (i % 10 == 0), acceleration) for i in range(205)]
    for logged, rates in (
        (packets, {"filter_data": 100, "filter_data.status": 100, "filter_data.euler_angles": 10}),
        (halves, {"filter_data": 100, "filter_data.status": 100, "filter_data.euler_angles": 100}),
        (no_fix * 5 + fix, {"gnss_1": 1, "gnss_1.llh_position": 1, "gnss_1.ecef_position": 1}),
        (tenth, {"sensor": 100, "sensor.scaled_accel": 100, "shared.reference_timestamp": 10}),
    ):
        path = written(tmp_path, *logged)
        report = json.loads(mip("info", path, "--json")[1])
        found = {field["name"]: field["rate"] for field in report["fields"]}
        assert {one.name: one.rate for one in read_log(path).types()} == pytest.approx(found)
        examined = examine_log(read_log(path))
        assert {examined.names[key]: rate for key, rate in examined.rates.items()} == pytest.approx(found)
        found |= {one["name"]: one["rate"] for one in report["sets"]}
        assert {name: found[name] for name in rates} == pytest.approx(rates, rel=0.2 if logged is packets else 1e-6)


@pytest.mark.parametrize("name", ["restarted", "reference clock restarted"])
@pytest.mark.parametrize("words", [("export", "-o", "-"), ("stream", "--format", "csv")])
@pytest.mark.parametrize("part", [1 << 20, 500, 26 * 3])
def test_time_continues_when_the_clock_restarts(
    name: str, words: tuple[str, ...], part: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Seconds from the start, as `cut` counts them; the duration is that of both spans."""
    monkeypatch.setattr(tables, "PART", part)
    monkeypatch.setattr(live, "_MOST", part)  # each batch of a stream is a log of its own
    monkeypatch.setattr(inputs, "_BATCH", part)
    path = written(tmp_path, *CASES[name].packets)
    rows = csv.DictReader(io.StringIO(mip(words[0], path, *words[1:], "--time", "start")[1]))
    near([float(row["time_device [s]"]) for row in rows], [t if t < 0.295 else t - STEP for t in TIMES])
    assert "60 packets in 0.6 s" in mip("doctor", path)[1]
    (own,) = json.loads(mip("info", path, "--json")[1])["sets"]
    assert own["seconds"] == pytest.approx(0.58)


def test_many_packets_of_one_time_are_no_stuck_clock(tmp_path: Path) -> None:
    """Receivers send their signals in many packets; the first and the last instant may be cut."""
    many = [packet(0x91, stamp(0x09, TOW + i, WEEK, 3), (0x03, bytes(44))) for i in range(9) for _ in range(14)]
    for logged, stuck in (
        (many, False),
        (many[:15], False),
        (many[9:30], False),
        (many + many[-1:] * 50, True),
        (many[:14] * 4, True),
        (many[:42] + many[42:43] * 60 + many[60:], True),
    ):
        path = written(tmp_path, *logged)
        assert ("stuck: the gps clock" in mip("info", path)[1]) == stuck == ("\nstuck:" in mip("doctor", path)[1])


def test_fleet(case: Case, path: Path) -> None:
    from mip_tools.fleet.decode import _facts
    from mip_tools.logs.report import report_on

    log = read_log(path)
    (own,) = (one for one in _facts(log, report_on(log))["sets"] if one["set"] == "sensor")
    assert own.get("rate") == (None if case.rate is None else pytest.approx(case.rate, rel=1e-3))


def test_a_log_of_two_devices_is_the_log_of_neither(tmp_path: Path) -> None:
    from mip_tools.fleet.decode import _identity

    one, other = reply("3dm-cv7-ahrs"), reply("3dm-gx5-25")
    assert _identity(read_log(one + one))["model"] == "3DM-CV7-AHRS"
    assert "model" not in _identity(read_log(one + other))
