"""Every model: simulated, recorded and read by the tools and the workbench, with a source of time and without.

What must come out follows from the specification: the rates of each set, the clock that its timestamps have with and
without a date, and the flags that mark values as valid on this model. The tools find the model in the log. In C, Rust
and JavaScript, `timed_packets.cases_of_devices` has the flags of every model.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime, timedelta
from itertools import pairwise
from pathlib import Path
from threading import Thread
from typing import Any

import mip_tools
import numpy as np
import pytest
from c_build import run
from mip_protocol import Parser, base, mip_3dm, types
from mip_simulator import VirtualDevice
from mip_simulator.endpoints.endpoint import tcp_at
from mip_simulator.endpoints.serve import Server
from mip_simulator.streams import formats
from mip_tools.devices.known import read_by_device
from mipgen import model as m
from mipgen.lower import codec, validity
from program import mip
from support import heavy, later, model, need, uses
from workbench import workbench

mcap, rosbag2 = later("mcap.reader"), later("rosbags.rosbag2")

SPEC = model("real")
UNIX = datetime(1970, 1, 1)
NAMES = {s.number: s.name for s in SPEC.sets}
STAMPS = validity.timestamps(SPEC)
BEGIN = datetime(2024, 1, 6, 23, 59, 42)  # the default start, GPS week 2296, in UTC
SECONDS = 3
#: One model of each family.
SAMPLE = ("3dm-gx3-35", "3dm-gx4-45", "3dm-gq4-45", "3dm-cv5-10", "3dm-gx5-25", "3dm-gx5-45", "3dm-cv7-ahrs",
          "3dm-cv7-gnss-ins", "demod-dc")  # fmt: skip
MODELS = [
    pytest.param(d.id, sync, marks=() if d.id in SAMPLE else heavy("every model"))
    for d in sorted(SPEC.devices, key=lambda d: d.id)
    for sync in (True, False)
    if any(s.set >= 0x80 for s in d.supports)
]


@dataclass
class Sent:
    """A set that a model sends."""

    number: int
    fields: dict[int, m.Field]
    rate: float

    @property
    def stamps(self) -> list[validity.Timestamp]:
        return [t for t in STAMPS if self.fields.get(t.field.descriptor) is t.field]

    @property
    def data(self) -> list[m.Field]:
        return [f for f in self.fields.values() if not f.everywhere and not any(t.field is f for t in STAMPS)]

    def clock(self, sync: bool) -> str | None:
        """The clock of its times: with a date, else the first that has none; None if it has no times."""
        if sync and any(t.clocks[0].epoch for t in self.stamps):
            return "gps"
        order = [c.name for c in SPEC.protocol.clocks if c.epoch is None]
        found = {c.name for t in self.stamps for c in t.clocks if c.epoch is None and (sync or c.name != "external")}
        return min(found, key=order.index, default=None)


def known(name: str) -> m.Device:
    return next(d for d in SPEC.devices if d.id == name)


def plan(name: str, device: VirtualDevice) -> list[Sent]:
    """The timestamps of each set, and its first field, with and without flags, at 10 Hz or as close as possible."""
    profile = known(name)
    rates = {rate.set.number: rate.hertz for rate in profile.base_rates}
    plans = []
    for number in sorted({s.set for s in profile.supports if 0x80 <= s.set < 0xFF}):
        able = [s.field for s in profile.supports if s.set in (number, 0xFF)]
        able = [f for f in able if f.role == m.DATA and number in f.sets]
        stamps = [t.field for t in STAMPS]
        with_flags = [f for f in able if f not in stamps and any(readings(f, p) for p in f.parameters)]
        others = [f for f in able if f not in stamps and f not in with_flags]
        wanted = [f for f in able if f in stamps] + with_flags[:1] + others[:1]
        ticks = rates.get(number) or formats.ticks(device, number)
        decimation = max(1, round(ticks / 10))
        entries = tuple(types.DescriptorRate(f.descriptor, decimation) for f in wanted)
        device.settings.write(mip_3dm.MessageFormat.write(number, entries))
        plans.append(Sent(number, {f.descriptor: f for f in wanted}, ticks / decimation))
    return plans


def readings(f: m.Field, p: m.Parameter) -> tuple[validity.Reading, ...]:
    return validity.readings((p,), f)


def reading(name: str, f: m.Field, p: m.Parameter) -> validity.Reading | None:
    """How the flags of a value are read on a model."""
    found = readings(f, p)
    return next((r for r in found if name in r.devices), found[-1] if found else None)


def record(name: str, sync: bool, path: Path) -> list[Sent]:
    device = VirtualDevice(name, sync=sync)
    link = device.connect()
    link.write(bytes(base.GetDeviceInfo().packet()))
    device.advance(0.01)
    plans = plan(name, device)
    device.arrange()
    device.advance(SECONDS)
    path.write_bytes(link.read())
    return plans


def check_recognized(name: str, packets: list[Any]) -> None:
    """Without its reply, a model may remain unknown, but is never taken for one that is read in another way."""
    log = mip_tools.read_log(b"".join(map(bytes, packets)))
    for kind in {c.type for c in log.types() if c.type is not None}:
        device = log.reads(kind)
        for on in read_by_device(kind).values() if device else ():
            assert (on[device].type, on[device].flags) == (on[name].type, on[name].flags), (kind.NAME, device)


def times_of(plans: list[Sent], sync: bool, log: mip_tools.Log) -> dict[str, set[float]]:
    """The times of all sets by clock, as the specification says for the model, compared with those of the log."""
    clocks: dict[str, set[float]] = {}
    columns = {(c.set, c.descriptor): c for c in log.types() if c.type is not None}
    for sent in plans:
        clock = sent.clock(sync)
        if clock is not None:
            column = log.column(columns[sent.number, min(sent.fields)].type, sent.number)
            clocks.setdefault(clock, set()).update(check_times(column.time(clock).values, clock, sent.rate))
    return clocks


@pytest.mark.parametrize("name, sync", MODELS)
def test_every_model_is_read_as_specified(name: str, sync: bool, tmp_path: Path) -> None:
    path = tmp_path / "log.bin"
    plans = record(name, sync, path)
    packets = [p for p in Parser().feed(path.read_bytes()) if p.set >= 0x80]
    log = mip_tools.read_log(path)
    columns = {(c.set, c.descriptor): c for c in log.types() if c.type is not None}
    for sent in plans:
        own = [p for p in packets if p.set == sent.number]
        assert len(own) >= SECONDS - 1, sent
        for descriptor, f in sent.fields.items():
            raw = [r.data for p in own for r in p if r.descriptor == descriptor]
            check_values(name, sync, log.column(columns[sent.number, descriptor].type, sent.number), f, raw)
    clocks = times_of(plans, sync, log)
    check_recognized(name, packets)
    check_info(path, plans, packets, clocks)
    check_doctor(path, plans, sync)


@pytest.mark.parametrize("name, sync", MODELS)
def test_every_model_streams_at_a_port(name: str, sync: bool, tmp_path: Path) -> None:
    """Fields that are started at a port have the model's rates and clocks, and the rows that a log of them has."""
    places: list[str] = []
    data: list[bytes] = []
    device = VirtualDevice(name, sync=sync, trace=lambda _, packet: data.append(packet))
    plans = plan(name, device)
    device.arrange()
    rates = {f"{NAMES[s.number]}.{f.name}": s.rate for s in plans for f in s.data}
    words = [*map("{0[0]}@{0[1]}".format, rates.items()), *["--time", "utc"] * sync]
    with Server(device, [tcp_at("0")], 20.0, ready=places.append) as server:
        thread = Thread(target=server.run)
        thread.start()
        try:
            form = "--format", "jsonl", "--by", "packet", "--invalid", "mask"
            code, out, error = mip("stream", places[0], *words, *form, "--packets", 60)
        finally:
            server.stop()
            thread.join()
    assert code == 0, error
    (tmp_path / "log.bin").write_bytes(b"".join(data))
    logged = rows_of(mip("export", tmp_path / "log.bin", *rates, *form, "-o", "-")[1])
    rows = rows_of(out)
    assert len(rows) > 30 and all(row in logged for row in rows)
    for sent in plans:
        clock, prefix = sent.clock(sync), f"{NAMES[sent.number]}."
        own = [row for row in rows if len(plans) == 1 or any(key.startswith(prefix) for key in row)]
        times = [row.get("time" if clock == "gps" else "time_device") for row in own]
        assert own and all((x is not None) == (clock is not None) for x in times), sent
        if clock == "gps":
            times = [(datetime.fromisoformat(x[:26]) - BEGIN) / timedelta(seconds=1) for x in times]
        steps = [b - a for a, b in pairwise(times) if clock]
        assert steps == pytest.approx([1 / sent.rate] * len(steps), abs=1e-5), sent


def rows_of(text: str) -> list[dict[str, Any]]:
    """Lines of a stream or a log, without what only a stream has."""
    lines = map(json.loads, text.splitlines())
    return [{key: x for key, x in line.items() if key not in ("time_host", "time_own")} for line in lines]


@heavy("mcap, rosbags")
@pytest.mark.parametrize("name, sync", MODELS)
def test_messages_of_every_model(name: str, sync: bool, tmp_path: Path) -> None:
    """MCAP has a message for each field, and bags standard ones, at the times of a clock that all packets have."""
    path = tmp_path / "log.bin"
    plans = record(name, sync, path)
    packets = [p for p in Parser().feed(path.read_bytes()) if p.set >= 0x80]
    clocks = times_of(plans, sync, mip_tools.read_log(path))
    counts: Counter[str] = Counter()
    for sent in plans:
        found = Counter(r.descriptor for p in packets if p.set == sent.number for r in p)
        for descriptor, f in sent.fields.items():
            counts[f"/mip/{'shared' if f.everywhere else NAMES[sent.number]}/{f.name}"] += found[descriptor]
    for form, messages in (("mcap", of_mcap), ("ros2", of_bag)):
        out = path.with_suffix(f".{form}")
        code, _, error = mip("export", path, "--format", form, "-o", out)
        assert code == (not clocks), error
        times: dict[str, list[float]] = {}
        for topic, time in messages(out) if clocks else ():
            date = time >= (datetime(1990, 1, 1) - UNIX).total_seconds()
            assert date == (clocks.keys() == {"gps"}), (topic, time)
            times.setdefault(topic, []).append(round(time - (BEGIN - UNIX).total_seconds() * date, 6))
        of_fields = {topic: len(every) for topic, every in times.items() if topic.startswith("/mip/")}
        assert of_fields == (counts if clocks and form == "mcap" else {})
        stated = {0.0}.union(*clocks.values())
        assert all(time in stated for every in times.values() for time in every)


def check_times(values: Any, clock: str, rate: float) -> list[float]:
    """Every period since the start has a time; returns them in seconds."""
    begin = np.datetime64(BEGIN, "ns") if clock == "gps" else np.timedelta64(0, "ns")
    seconds = ((values - begin) / np.timedelta64(1, "s")).tolist()
    assert seconds[0] <= 1 / rate + 0.02
    assert seconds == pytest.approx([seconds[0] + k / rate for k in range(len(seconds))], abs=1e-6)
    return [round(x, 6) for x in seconds]


def check_values(name: str, sync: bool, column: Any, f: m.Field, raw: list[bytes]) -> None:
    """The values are those that the codec of the specification decodes, and valid as the flags say on this model."""
    decoded = [codec.decode(f, data)[0] for data in raw]
    for p in f.parameters:
        how = reading(name, f, p)
        if how is None or len(how.flags) != 1:
            continue
        (flag,) = how.flags
        bits = [int(values[flag.parameter]) for values in decoded]
        assert not any(b & how.undefined for b in bits), (f.full_name, p.name, bits)
        valid = [is_valid(name, f, p, values) for values in decoded]
        assert column.valid(p.name).tolist() == valid, (f.full_name, p.name)
        if any(t.field is f for t in STAMPS):
            assert valid == [sync] * len(valid), (f.full_name, p.name)


def check_info(path: Path, plans: list[Sent], packets: list[Any], clocks: dict[str, set[float]]) -> None:
    code, out, _ = mip("info", path)
    assert code == 0
    for sent in plans:
        (line,) = (x for x in out.splitlines() if f"(0x{sent.number:02X})" in x)
        count = sum(p.set == sent.number for p in packets)
        found = line.split(")")[1].split()
        assert found[:1] == [str(count)], line
        if clocks and (sent.clock("gps" in clocks)) in clocks:
            assert float(found[1]) == pytest.approx(sent.rate, rel=0.01), line
    assert ("gps clock" in out) == ("gps" in clocks), out
    assert bool(clocks) == ("\ntime: " in out), out


def check_doctor(path: Path, plans: list[Sent], sync: bool) -> None:
    """Without a source of time, what could have a date is not synchronized; nothing else is wrong with the times."""
    found = {finding["cause"] for finding in json.loads(mip("doctor", path, "--json")[1])["findings"]}
    undated = not sync and any(t.clocks[1:] for sent in plans for t in sent.stamps)
    assert ("not synchronized" in found) == undated, found
    assert not found & {"stuck", "reset", "no timestamps", "synchronization lost", "gap"} or any(
        not s.stamps for s in plans
    ), found


def of_mcap(path: Path) -> Iterator[tuple[str, float]]:
    with path.open("rb") as file:
        for _, channel, one in mcap.make_reader(file).iter_messages():
            yield channel.topic, one.log_time / 1e9


def of_bag(path: Path) -> Iterator[tuple[str, float]]:
    with rosbag2.Reader(path) as bag:
        for connection, time, _ in bag.messages():
            yield connection.topic, time / 1e9


@uses("npm")
@pytest.mark.parametrize("name, sync", MODELS)
def test_the_workbench_reads_every_model(name: str, sync: bool, tmp_path: Path) -> None:
    plans = record(name, sync, tmp_path / "log.bin")
    packets = [p for p in Parser().feed((tmp_path / "log.bin").read_bytes()) if p.set >= 0x80]
    (tmp_path / "unknown.bin").write_bytes(b"".join(map(bytes, packets)))  # without the reply that names the device
    program = [need("node"), Path(__file__).with_name("survey.mjs"), workbench("real") / "workbench.js"]
    logs = [tmp_path / "log.bin", tmp_path / "unknown.bin"]
    survey, unknown = map(json.loads, run(*program, *logs).splitlines())
    assert unknown["read"] == "; ".join(mip_tools.read_log(tmp_path / "unknown.bin").assumed())
    assert survey["device"] == name and len(survey["spans"]) == any(sent.clock(sync) for sent in plans)
    fields = {(x["set"], x["descriptor"]): x for x in survey["fields"]}
    for sent in plans:
        for descriptor, f in sent.fields.items():
            found = fields[sent.number, descriptor]
            raw = [r.data for p in packets if p.set == sent.number for r in p if r.descriptor == descriptor]
            assert found["count"] == len(raw), f.full_name
            flagged = [p for p in f.parameters if p.valid]
            if flagged:
                valid = [all(is_valid(name, f, p, codec.decode(f, data)[0]) for p in flagged) for data in raw]
                assert found["valid"] == sum(valid), (f.full_name, found)
            if sent.clock(sync) and len(raw) > 10 and len(raw) == sum(p.set == sent.number for p in packets):
                assert found["rate"] == pytest.approx(sent.rate, rel=0.01), f.full_name


def is_valid(name: str, f: m.Field, p: m.Parameter, values: dict[str, Any]) -> bool:
    """Is a value valid by all of its flags on a model?"""
    how = reading(name, f, p)
    assert how is not None
    return all(int(values[x.parameter]) & x.mask == x.mask if x.mask else values[x.parameter] for x in how.flags)
