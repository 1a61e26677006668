"""Tables: rows of instants and of packets, their names and types, in frames and in all files."""

from __future__ import annotations

import csv
import gc
import io
import json
import math
import struct
import weakref
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import registry, shared
from mip_protocol.reflection import info
from mip_protocol.timestamps import moments
from mip_tools import read_log
from mip_tools.__main__ import main
from mip_tools.columns import frames, instants, tables, text, timeline
from mip_tools.columns.tables import Form
from packages import real
from random_values import chance
from support import later, rounds
from test_columns import gps, parsed
from timed_packets import packet

np, pa, pq, pandas, polars = (later(name) for name in ("numpy", "pyarrow", "pyarrow.parquet", "pandas", "polars"))


def accel(x: float) -> tuple[int, bytes]:
    return 0x04, struct.pack(">3f", x, 2 * x, -1)


def angles(yaw: float, flags: int = 1) -> tuple[int, bytes]:
    return 0x05, struct.pack(">3fH", 0, 0, yaw, flags)


# --------------------------------------------------------------------------- the same in plain Python


def drawn(seed: int, count: int) -> bytes:
    """Packets of several sets, with equal, late and missing times, types twice in an instant, and damage."""
    rng = chance(seed)
    out, now = bytearray(), 100.0
    for i in range(count):
        now += rng.choice([0.0, 0.0, 0.5, 0.5, 0.5, -20.0 if rng.random() < 0.02 else 0.5])
        late = now - rng.choice([0, 0, 0, 0.5, 1.0])
        number = rng.choice([0x80, 0x80, 0x82, 0x91])
        fields: list[tuple[int, bytes]] = []
        if rng.random() < 0.85:
            fields.append(gps(late, flags=rng.choice([3, 3, 3, 3, 1])))
        if rng.random() < 0.3:
            fields.append((0xD6, struct.pack(">Q", i)))  # differs in each set
        for _ in range(rng.choice([1, 1, 1, 2])):
            fields += {
                0x80: [accel(i), (0x05, struct.pack(">3f", i, math.nan, 1e-7))][: rng.choice([1, 2])],
                0x82: [angles(i, rng.choice([0, 1]))],
                0x91: [(0x0B, struct.pack(">BBHH", 3, i % 40, 3, rng.choice([1, 3])))],
            }[number]
        one = bytearray(packet(number, *fields))
        if rng.random() < 0.05:
            one[-1] ^= 1
        out += one
    return bytes(out)


def rows_of(stream: bytes, by: str, near: int) -> list[dict[str, Any]]:
    """The rows of a table of all data: name -> value, without missing values."""
    last: dict[int, int | None] = {}
    opened: dict[int, list[Any]] = {}  # time -> the last instant with it: where it begins, its fields
    order: list[list[Any]] = []
    for at, one in parsed(real, stream):
        own = moments(one)
        if "gps" in own:
            last[one.set] = own["gps"]
        time = own.get("gps")
        instant = opened.get(time) if time is not None and by == "time" else None
        if instant is None or at - instant[0] > near:
            instant = [at, last.get(one.set), "gps" in own, {}]
            order.append(instant)
            if time is not None:
                opened[time] = instant
        for field in registry.decode_packet(one):
            if isinstance(field, tuple):
                continue
            set_name, name = field.name_in(one.set).split(".", 1)
            stamp = isinstance(field, shared.GpsTimestamp)
            if set_name == "shared" and not stamp and by == "time":
                set_name = {0x80: "sensor", 0x82: "filter_data", 0x91: "gnss_1"}[one.set]
            same = instant[3].setdefault((set_name, name), [])
            if not (stamp and same and by == "time"):
                same.append(field)
    rows = []
    for _, time, is_own, fields in order:
        for turn in range(max(map(len, fields.values()), default=0)):
            row = {"time": time, "time_own": is_own}
            for (set_name, name), several in fields.items():
                if turn < len(several):
                    row |= cells_of(f"{set_name}.{name}", several[turn])
            rows.append({k: v for k, v in row.items() if v is not None})
    return rows


def cells_of(name: str, field: Any) -> dict[str, Any]:
    cells = {}
    for p in info(type(field)).members:
        value = getattr(field, p.attribute)
        full = name if name.endswith(f".{p.name}") else f"{name}.{p.name}"
        if p.elements:
            cells |= {f"{full}.{element}": x for element, x in zip(p.elements, value)}
        else:
            cells[full] = int(value) if isinstance(value, int) else value
    return cells


def equal(a: Any, b: Any) -> bool:
    return a == b or (isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b))


def check(found: list[dict[str, Any]], wanted: list[dict[str, Any]]) -> None:
    assert len(found) == len(wanted)
    for row, other in zip(found, wanted):
        assert row.keys() == other.keys(), (row, other)
        assert all(equal(row[name], other[name]) for name in row), (row, other)


def all_data(log: Any, by: str) -> tuple[list[Any], Form]:
    form = Form(by, wanted=lambda set, descriptor: set >= 0x80)
    kinds, clocks = tables.survey_tables(log, form)
    assert clocks[:2] == ("gps", "device")
    return kinds, form._replace(dated="gps")


def as_rows(table: Any) -> list[dict[str, Any]]:
    """The rows of a table of Arrow; floats of four bytes as Python has them."""
    table = table.set_column(0, "time", table["time"].cast(pa.int64()))
    return [{k: v for k, v in row.items() if v is not None} for row in table.to_pylist()]


@pytest.mark.parametrize("by", ["time", "packet"])
@pytest.mark.parametrize("near", [1 << 16, 300])
def test_rows_are_those_that_plain_python_finds(by: str, near: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """In one table, and in parts of any size."""
    monkeypatch.setattr(instants, "TOGETHER", near)
    for seed in range(rounds(3, 40)):
        stream = drawn(seed, 250)
        log = read_log(stream)
        wanted = rows_of(stream, by, near)
        kinds, form = all_data(log, by)
        frame = log.frame([kind for _, kind in registry_order(kinds)], by=by, library="pyarrow", time="gps")
        check(as_rows(frame), wanted)
        for size in (200, 1500, 1 << 22):
            parts = [table for table, _ in tables.table_parts(log, kinds, form, size)]
            made = [tables_as_arrow(table) for table in parts]
            assert all(one.schema.equals(made[0].schema, check_metadata=True) for one in made)
            check(as_rows(pa.concat_tables(made)), wanted)


@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_frames_of_large_logs_are_the_same(library: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """They are made from parts."""
    kinds = ["sensor.scaled_accel", (0x80, shared.ReferenceTimeDelta), "filter_data.euler_angles", "gnss_1.fix_info"]
    log = read_log(drawn(4, 300))
    monkeypatch.setattr(instants, "TOGETHER", 300)
    for options in ({}, {"invalid": "mask"}, {"invalid": "drop", "position": True}, {"by": "packet", "time": None}):
        whole = log.frame(kinds, library=library, **options)
        with monkeypatch.context() as patch:
            patch.setattr(timeline, "PART", 1)
            patch.setattr(frames, "PART", 1500)
            patch.setattr(tables, "whole_table", None)
            made = log.frame(kinds, library=library, **options)
        assert made.equals(whole) and len(made) > 100, options
        assert library != "pandas" or made.attrs == whole.attrs


def registry_order(kinds: list[Any]) -> list[Any]:
    """The types, each once: a frame divides shared fields itself."""
    seen: dict[Any, Any] = {}
    for number, kind in kinds:
        seen.setdefault(kind, number)
    return [(number, kind) for kind, number in seen.items()]


def tables_as_arrow(table: Any) -> Any:
    from mip_tools.columns.frames import as_frame

    return as_frame(table.columns, "pyarrow", True)


def test_frames_of_all_libraries_and_all_files_have_one_schema(tmp_path: Path) -> None:
    """Names, units, types and every value, as docs/columns.md states them."""
    stream = drawn(5, 300)
    (tmp_path / "log.bin").write_bytes(stream)
    log = read_log(stream)
    for options in ({"by": "time"}, {"by": "packet"}, {"by": "time", "invalid": "mask"}):
        kinds, form = all_data(log, options["by"])
        form = form._replace(**options, undated="device")
        words = [w for name, value in options.items() for w in (f"--{name}", value)]
        base = tables_as_arrow(next(iter(tables.table_parts(log, kinds, form)))[0])
        assert base.num_rows > 100
        files = {}
        for form_ in ("parquet", "csv", "jsonl"):
            files[form_] = tmp_path / f"t.{form_}"
            assert main(["export", str(tmp_path / "log.bin"), "-o", str(files[form_]), *words]) == 0
        read = pq.read_table(files["parquet"])
        assert read.schema.equals(base.schema, check_metadata=True)
        assert repr(read.to_pydict()) == repr(base.to_pydict())
        units = {f.name: (f.metadata or {}).get(b"unit", b"").decode() for f in base.schema}
        wanted = as_rows(base)

        table = list(csv.reader(io.StringIO(files["csv"].read_text())))
        assert table[0] == [f"{name} [{unit}]" if unit else name for name, unit in units.items()]
        lines = files["jsonl"].read_text().splitlines()
        assert len(table) - 1 == len(lines) == len(wanted)
        for cells, line, row in zip(table[1:], lines, wanted):
            members = json.loads(line)
            assert list(members) == [name for name in units if name in row]
            for name, cell in zip(units, cells):
                assert (cell == "") == (name not in row)
                if name == "time" and name in row:
                    stamp = np.datetime64(row[name], "ns")
                    assert cell == members[name] == f"{stamp}Z"
                elif name in row:
                    value, single = row[name], base.schema.field(name).type == pa.float32()
                    assert members[name] is None if value != value else equal(read_number(members[name], single), value)
                    assert equal(read_number(json.loads(cell) if cell != "nan" else math.nan, single), value)

        if "invalid" in options or options["by"] == "packet":
            continue
        types = [kind for _, kind in registry_order(kinds)]
        whole = log.frame(types, library="pyarrow")
        assert sorted(whole.schema.names) == sorted(base.schema.names)
        by_pandas, by_polars = log.frame(types), log.frame(types, library="polars")
        titles = [f"{name} [{units[name]}]" if units[name] else name for name in whole.schema.names]
        assert list(by_pandas.columns) == titles == by_polars.columns
        assert str(by_pandas["time"].dtype) == "datetime64[ns, UTC]"
        assert by_polars["time"].dtype == polars.Datetime("ns", "UTC")
        for name, title in zip(whole.schema.names[1:], titles[1:]):
            values = whole[name].to_pylist()
            assert all(map(equal, by_polars[title].to_list(), values))
            there = [v for v in by_pandas[title].tolist() if not pandas.isna(v)]
            assert there == [v for v in values if v is not None and v == v]


def read_number(value: Any, single: bool) -> Any:
    """A number that was written with as few digits as a float of four bytes needs."""
    return float(np.float32(value)) if single and isinstance(value, (int, float)) else value


# --------------------------------------------------------------------------- instants


def test_what_belongs_to_one_instant_is_one_row() -> None:
    """A message in two packets, a set that arrives later, and a receiver that repeats the time."""
    stream = b"".join([
        packet(0x80, gps(10), accel(1)),
        packet(0x82, gps(10), angles(1)),
        packet(0x82, gps(10), (0x0D, struct.pack(">3fH", 1, 2, 3, 1))),
        packet(0x80, gps(11), accel(2)),
        packet(0x82, gps(11), angles(2)),
        packet(0x80, accel(3)),
    ])  # fmt: skip
    log = read_log(stream)
    kinds = ["sensor.scaled_accel", "filter_data.euler_angles", "filter_data.linear_accel", "shared.gps_timestamp"]
    frame = log.frame(kinds, units=False)
    assert frame["sensor.scaled_accel.x"].tolist() == [1, 2, 3]
    assert frame["filter_data.euler_angles.yaw"].tolist()[:2] == [1, 2]
    assert frame["filter_data.linear_accel.accel.x"].tolist()[0] == 1
    assert frame["shared.gps_timestamp.tow"].tolist()[:2] == [10, 11]
    assert frame["time_own"].tolist() == [True, True, False]
    assert len(log.frame(kinds, by="packet")) == 6
    assert len(log.frame(kinds, time=None)) == 3 and "time" not in log.frame(kinds, time=None)
    with pytest.raises(ValueError, match="by 'second': time or packet"):
        log.frame(kinds, by="second")


def test_parts_are_freed_as_they_are_passed() -> None:
    """Not only when Python looks for cycles, which it does too rarely for large arrays."""
    log, seen = read_log(drawn(3, 100)), []
    gc.disable()
    try:
        for part in log.parts(1000):
            assert len(part["shared.gps_timestamp"].time().values) == len(part["shared.gps_timestamp"])
            seen.append(weakref.ref(part))
        del part
        assert len(seen) > 3 and not any(ref() for ref in seen)
    finally:
        gc.enable()


# --------------------------------------------------------------------------- texts


def test_text_of_special_values() -> None:
    columns = [
        tables.Series("a%", np.array([0.1, np.nan, np.inf], np.float32), None, {"unit": "%"}),
        tables.Series("b", np.array(["x,y", 'q"', None], object), np.array([False, False, True]), {}),
        tables.Series("c", np.array([[1, 2], [3, 4], [5, 6]], np.uint8), None, {}),
        tables.time_column(np.array([-1, 10**9 + 1, 0]), "reference"),
        tables.Series("e", np.array([[0.1], [], [2.5]], object), None, {}, (1, "<f4")),
    ]
    assert text.csv_head(columns) == "a% [%],b,c,time_device [s],e\n"
    assert b"".join(text.csv_lines(columns)).decode().splitlines() == [
        '0.1,"x,y","[1,2]",-1e-09,[0.1]', 'nan,"q""","[3,4]",1.000000001,[]', 'inf,,"[5,6]",0.0,[2.5]',
    ]  # fmt: skip
    lines = [json.loads(line) for line in b"".join(text.json_lines(columns)).splitlines()]
    assert lines[0] == {"a%": 0.1, "b": "x,y", "c": [1, 2], "time_device": -1e-9, "e": [0.1]}
    assert lines[1]["a%"] is None and lines[2] == {"a%": None, "c": [5, 6], "time_device": 0, "e": [2.5]}


def test_frames_as_people_who_use_pandas_expect_them() -> None:
    pandas = pytest.importorskip("pandas")
    log = read_log(b"".join(packet(0x80, gps(1 + i / 8), (0x04, struct.pack(">3f", i, 0, -1))) for i in range(4)))
    frame = log.frame("sensor.scaled_accel", index="time", names="plain")
    assert isinstance(frame.index, pandas.DatetimeIndex) and frame.scaled_accel_x.tolist() == [0, 1, 2, 3]
    assert frame.resample("250ms").mean().scaled_accel_x.tolist() == [0.5, 2.5]
    assert frame.attrs["units"]["scaled_accel_x"] == "g"
    assert log.frame("sensor.scaled_accel").attrs["units"]["scaled_accel.x [g]"] == "g"
    indexed = {"index": "time"}
    for wrong in ({"names": "short"}, {"index": "x"}, indexed | {"library": "polars"}, indexed | {"time": None}):
        with pytest.raises(ValueError, match=f"^{next(iter(wrong))} "):
            log.frame("sensor.scaled_accel", **wrong)
    with pytest.raises(ValueError, match="twice"):
        log.frame(["sensor.scaled_accel", "sensor.scaled_accel"])


def test_text_is_the_same_without_pyarrow(monkeypatch: pytest.MonkeyPatch) -> None:
    """Numbers of all sizes, dates, texts and lists, with gaps."""
    rng, count = np.random.default_rng(rounds(1, 9)), 5000
    gaps = rng.random(count) < 0.3
    singles = rng.integers(0, 2**32, count, dtype=np.uint32).view(np.float32)
    numbers = np.concatenate(
        (rng.integers(0, 2**64, 999, np.uint64).view(float), rng.integers(-99, 99, count - 999) / 8)
    )
    dates = np.array(rng.integers(-(2**60), 2**60, count), "M8[ns]")
    texts = np.array([f"{''.join(map(chr, rng.integers(32, 256, 5)))}" for _ in range(count)], object)
    columns = [
        tables.Series(f"c{i}", values, mask, {})
        for i, values in enumerate(
            (singles, numbers, np.arange(count), singles > 0, dates, texts, singles.reshape(-1, 1))
        )
        for mask in (None, gaps)
    ]
    forms = (text.csv_lines, text.json_lines)
    both = [b"".join(form(columns)) for form in forms]
    monkeypatch.setattr(text, "pyarrow", lambda: None)
    assert [b"".join(form(columns)) for form in forms] == both
    monkeypatch.undo()
    one = [tables.Series("a", numbers[:3], np.array([True, False, True]), {})]
    assert [b"".join(form(one)).count(b"\n") for form in forms] == [3, 3]
