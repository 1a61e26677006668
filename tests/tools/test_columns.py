"""Columns of logs have the values of objects: every field, any bytes, however a log is cut."""

from __future__ import annotations

import copy
import gzip
import io
import os
import pickle
import random
import re
import shutil
import struct
import subprocess
import sys
import zipfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from mipgen import model as m
from mipgen.lower import codec
from packages import REAL, real
from packages import mip as invented
from pairs import pairwise
from random_values import chance, drawn
from support import ROOT, all_fields, heavy, later, model, need, packaging, rounds
from timed_packets import framed, packet

np, pyarrow, dataset, parquet = (later(name) for name in ("numpy", "pyarrow", "pyarrow.dataset", "pyarrow.parquet"))

KERNEL = ROOT / "tools/mip_tools/columns/kernel.c"
PACKAGES = {"real": real, "invented": invented}


def read_log(*words: Any, **more: Any) -> Any:
    return real.mip_tools.columns.read_log(*words, **more)


def parsed(package: Any, stream: bytes) -> list[tuple[int, Any]]:
    """What `Parser` finds, and where."""
    parser, found, at = package.parser.Parser(), [], 0
    for part in (parser.feed(stream), parser.flush()):
        for one in part:
            at = stream.index(bytes(one), at)
            found.append((at, one))
            at += len(one)
    return found


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The compiled code, which both packages share."""
    path = tmp_path_factory.mktemp("kernel") / "_kernel.so"
    options = ["-std=c99", "-O3", "-shared", "-fPIC", "-o", str(path)]
    subprocess.run([need("gcc"), *options, str(KERNEL)], check=True)
    return path


def use(monkeypatch: pytest.MonkeyPatch, path: Path | None) -> None:
    """All that follows is with NumPy alone, or with the compiled code."""
    for package in PACKAGES.values():
        kernel = None if path is None else package.mip_tools.columns.native.Kernel(path)
        monkeypatch.setattr(package.mip_tools.columns.native, "kernel", kernel)


WAYS = ["numpy", "compiled"]


@pytest.fixture(params=WAYS)
def way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, request.getfixturevalue("built") if request.param == "compiled" else None)


# --------------------------------------------------------------------------- columns and objects


def leaves(package: Any, parameters: Any, value: Any, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """The cells of a row: the names of columns, and the values of the object."""
    structure = package.field.Structure
    for p in parameters:
        if p.kind == "counter" or p.constant is not None:
            continue
        held, name = None if value is None else getattr(value, p.attribute), prefix + p.attribute
        if p.kind == "switch":
            tag = None if value is None else getattr(value, p.tag)
            for own, case in p.cases.items():
                if case is not None:
                    chosen = held if own == tag else None
                    yield from leaf(package, structure, case, chosen, f"{name}.{case.attribute}")
        else:
            yield from leaf(package, structure, p, held, name)


def leaf(package: Any, structure: Any, p: Any, held: Any, name: str) -> Iterator[tuple[str, Any]]:
    nested = p.type is not None and issubclass(p.type, structure)
    if not nested:
        yield name, plain(p, held)
    elif p.length is None:
        yield from leaves(package, package.reflection.info(p.type).parameters, held, name + ".")
    else:
        parameters = package.reflection.info(p.type).parameters
        names = [key for key, _ in leaves(package, parameters, None, name + ".")]
        rows = None if held is None else [dict(leaves(package, parameters, item, name + ".")) for item in held]
        for key in names:
            yield key, None if rows is None else [row[key] for row in rows]


def plain(p: Any, value: Any) -> Any:
    """A value as bits, numbers and lists."""
    if value is None or isinstance(value, str):
        return value
    if p.scalar == "bits":
        return list(int(value).to_bytes(p.size, "little"))
    if isinstance(value, (tuple, list)):
        return [plain(p, item) for item in value]
    if p.scalar == "float":
        return real.codec.single_to_bits(value)
    return struct.unpack(">Q", struct.pack(">d", value))[0] if p.scalar == "double" else int(value)


def cell(column: Any, row: int) -> Any:
    """The same from a column."""
    if hasattr(column, "offsets"):
        if column.mask is not None and column.mask[row]:
            return None
        return [cell(column.values, i) for i in range(int(column.offsets[row]), int(column.offsets[row + 1]))]
    mask = np.ma.getmaskarray(column)[row] if isinstance(column, np.ma.MaskedArray) else False
    if np.any(mask):
        return None
    value = np.asarray(column)[row]
    if isinstance(value, str):
        return value
    bits = {"f4": "u4", "f8": "u8"}.get(np.asarray(column).dtype.str[1:])
    value = np.asarray(value).view(bits) if bits else np.asarray(value)
    return value.tolist()


def expected(package: Any, stream: bytes) -> dict[Any, list[tuple[int, int, int, Any]]]:
    """Type -> packet number, offset, set and object of each field."""
    found: dict[Any, list[tuple[int, int, int, Any]]] = {}
    for number, (at, one) in enumerate(parsed(package, stream)):
        for value in package.registry.decode_packet(one):
            if isinstance(value, package.field.Field):
                found.setdefault(type(value), []).append((number, at, one.set, value))
    return found


def compare(package: Any, stream: bytes) -> int:
    """All columns of a log against all objects; the number of values."""
    log, counted = package.mip_tools.columns.read_log(stream), package.mip_tools.columns.read_log(stream)
    packets = parsed(package, stream)
    assert counted.packets == len(packets)  # before their fields are known; in the other log, together with them
    assert counted.skipped == len(stream) - sum(len(one) for _, one in packets)
    wanted, seen = expected(package, stream), 0
    known = {kind for _, kind in package.registry.all_types()}
    for kind in wanted:
        assert kind in known
    for kind in known:
        rows = wanted.get(kind, [])
        column = log[kind]
        assert len(column) == len(rows), kind
        assert column.packet.tolist() == [row[0] for row in rows]
        assert column.offset.tolist() == [row[1] for row in rows]
        assert column.set.tolist() == [row[2] for row in rows]
        assert list(map(repr, column.objects())) == [repr(value) for *_, value in rows]
        for i, (*_, value) in enumerate(rows):
            held = dict(leaves(package, package.reflection.info(kind).parameters, value))
            assert list(held) == list(column.names) == list(column.parameters)
            for name, want in held.items():
                assert cell(column[name], i) == want, (kind, name, i)
                seen += 1
        if not rows:
            empty = list(dict(leaves(package, package.reflection.info(kind).parameters, None)))
            assert list(column.names) == empty
    assert {(c.set, c.type): c.count for c in counted.types() if c.type} == {
        (s, k): sum(row[2] == s for row in rows) for k, rows in wanted.items() for s in {row[2] for row in rows}
    }
    return seen


@cache
def fields(spec: str, examples: int) -> list[tuple[int, bytes]]:
    """Every field with random values: set and bytes."""
    of, found = model(spec), []
    for f in all_fields(of):
        for values in drawn(f, examples):
            number = f.set if f.set not in (0, m.SHARED_SET) else 0x01 if not f.set else 0x80
            data = codec.encode(f, values)
            if len(data) <= 253:
                found.append((number, bytes((len(data) + 2, f.descriptor)) + data))
    return found


def streams(spec: str, seed: int, count: int, examples: int = 8) -> bytes:
    """Packets with random fields, many of them damaged, with noise in between."""
    rng, out = chance(seed), bytearray()
    every = fields(spec, examples)
    by_set: dict[int, list[bytes]] = {}
    for number, field in every:
        by_set.setdefault(number, []).append(field)
    for _ in range(count):
        number = rng.choice(list(by_set))
        payload = b""
        for _ in range(rng.randrange(5)):
            field = bytearray(rng.choice(by_set[number]))
            if rng.random() < 0.3:
                field[rng.randrange(len(field))] = rng.randrange(256)
            if rng.random() < 0.2:
                field[0] = max(2, min(255, field[0] + rng.randrange(-3, 4)))
                del field[field[0] :]
                field += rng.randbytes(field[0] - len(field))
            if len(payload) + len(field) <= 255:
                payload += field
        if rng.random() < 0.1:
            payload += rng.randbytes(rng.randrange(min(4, 256 - len(payload))))
        one = bytearray(framed(number, payload))
        if rng.random() < 0.1:
            one[rng.randrange(len(one))] ^= 1 << rng.randrange(8)
        if rng.random() < 0.05:
            del one[rng.randrange(len(one)) :]
        out += one
        if rng.random() < 0.1:
            out += rng.choice([b"u", b"ue", b"ue\x80\xff", b"$GPGGA,1*00\r\n", rng.randbytes(9), packet(0, (1, b""))])
    return bytes(out)


@pytest.mark.usefixtures("way")
def test_columns_equal_objects_on_damaged_streams() -> None:
    """Value by value, bit by bit."""
    count = rounds(240, 3000)
    assert compare(invented, streams("invented", seed=1, count=count)) > 2 * count


@pytest.mark.usefixtures("way")
def test_packets_of_extreme_lengths() -> None:
    """They begin and end in one of the words that checksums are computed from; or their last data begin more than 255
    bytes behind the beginning of the packet."""
    short = (packet(0x01, (i % 2 + 1, b"")) + packet(0x80, (0xD0, b"x")) for i in range(200))
    assert compare(real, b"".join(short)) == 200
    full = [(1, b"")] * 124 + [(1, bytes(5))]
    ends = [[*full[:124], (1, b""), (2, bytes(3))], [*full[:124], (2, bytes(3)), (1, b"")], [(1, b"")] * 127]
    assert all(250 < len(packet(0x01, *fields)) - 6 <= 255 for fields in ends)
    compare(real, b"".join(packet(0x01, *fields) for fields in ends * 10))
    column = read_log(packet(0x01, *[(1, b"")] * 127) + packet(0x01, (1, b"")))["base.ping"]
    assert column.packet.tolist() == [0] * 127 + [1]


@pytest.mark.usefixtures("way")
@pytest.mark.parametrize("layouts", [2, 30])
def test_columns_equal_objects_if_packets_of_one_length_differ(layouts: int) -> None:
    rng = random.Random(layouts)
    kinds = [[rng.choice([4, 5, 6, 7, 8, 0x63]) for _ in range(3)] for _ in range(layouts)]
    out = []
    for _ in range(rounds(350, 3000)):
        payload = bytearray(b"".join(bytes((14, d)) + rng.randbytes(12) for d in rng.choice(kinds)))
        if rng.random() < 0.05:
            payload[rng.choice([0, 14, 28])] = rng.choice([0, 1, 2, 13, 15, 28, 30, 255])
        out.append(framed(0x80, bytes(payload)))
    assert compare(real, b"".join(out)) > 500


@pytest.mark.usefixtures("way")
def test_layouts_that_are_sorted_alike() -> None:
    """Packets are sorted by a sum of their fields' heads: 31 x 14 + 41 is 31 x 15 + 10."""
    one = packet(0x80, (4, bytes(12)), (5, bytes(39)))
    other = packet(0x80, (4, bytes(13)), (5, bytes(8)))
    assert compare(real, (one + other + one) * 30) == 150


@pytest.mark.usefixtures("way")
@pytest.mark.parametrize(("spec", "examples"), [("real", 1), ("invented", 8)])
def test_columns_equal_objects_for_every_field(spec: str, examples: int) -> None:
    every = fields(spec, rounds(examples, 8))
    stream = b"".join(packet(number, (field[1], field[2:])) for number, field in every)
    assert compare(PACKAGES[spec], stream) > 1000


@pytest.mark.usefixtures("way")
def test_objects_while_other_columns_are_requested(monkeypatch: pytest.MonkeyPatch) -> None:
    """Requests look at the same pieces, and must not disturb each other."""
    monkeypatch.setattr(real.mip_tools.columns.packets, "_PIECE", 5000)
    sent = [packet(0x80, (4, struct.pack(">3f", i, 0, 0)), (5, bytes(12))) for i in range(1000)]
    log = read_log(b"".join(sent))
    seen = []
    for n, one in enumerate(log.objects("sensor.scaled_accel")):
        if n == 9 or n == 500:
            assert len(log["sensor.scaled_gyro"]) == 1000
        seen.append(one.scaled_accel[0])
    assert seen == list(range(1000))
    both = zip(log.objects("sensor.scaled_accel"), log.objects("sensor.scaled_gyro"))
    assert [a.scaled_accel[0] for a, _ in both] == seen


# --------------------------------------------------------------------------- packets


def nested() -> bytes:
    """Packets in packets, so that the start of one decides which ones are found."""
    small = packet(0x80, (0x04, bytes(12)))
    chain = b""
    for i in range(40):
        inner = packet(0x80, (0x05, bytes([i]) * 12))
        chain += packet(0x82, (0x63, inner[:9])) + inner[9:]
    whole = packet(0x80, (0x63, packet(0x82, (0x63, small))))
    return chain + whole * 3 + whole[:40] + small + chain[5:] + packet(0x80, (0x63, b"\x00" * 250))


STREAMS = {
    "damaged": lambda: streams("real", seed=3, count=100),
    "nested": nested,
    "text": lambda: b"$GPGGA,1,2*33\r\n" * 50 + packet(0x80, (4, bytes(12))) + b"u" * 300,
    "syncs": lambda: b"ue" * 400 + packet(0x80, (4, bytes(12))) + b"\x75\x65\x01\xff" * 300,
    "random": lambda: random.Random(9).randbytes(20_000),
    "short": lambda: b"ue\x80",
    "empty": lambda: b"",
}


@pairwise(indirect=["way"], way=WAYS, name=sorted(STREAMS), piece=[7, 300, 1 << 22])
def test_packets_are_those_of_the_parser_however_a_log_is_cut(
    way: None, name: str, piece: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    columns = real.mip_tools.columns
    monkeypatch.setattr(columns.packets, "_PIECE", piece)
    monkeypatch.setattr(columns.scan, "_PART", 64)
    stream = STREAMS[name]()[: piece * rounds(150, 10_000)]
    places = [at for at, _ in parsed(real, stream)]

    def found(log: Any) -> list[int]:
        return sorted(at for c in log.columns() for at in c.offset.tolist())

    whole = columns.read_log(stream)
    assert whole.packets == len(places)
    offsets = found(whole)
    rng = chance(name, piece)
    for _ in range(rounds(3, 30)):
        cuts = sorted(rng.randrange(len(stream) + 1) for _ in range(rng.randrange(4)))
        parts = [columns.read_log(stream, a, b) for a, b in zip([0, *cuts], [*cuts, len(stream)])]
        assert [part.packets for part in parts] == [
            sum(a <= at < b for at in places) for a, b in zip([0, *cuts], [*cuts, len(stream)])
        ]
        assert [at for part in parts for at in found(part)] == offsets
        assert sum(part.skipped for part in parts) == whole.skipped
    sizes = [part.packets for part in whole.parts(max(1, len(stream) // 9))]
    assert sum(sizes) == len(places)


# --------------------------------------------------------------------------- sources


def test_every_kind_of_source(tmp_path: Path) -> None:
    stream = packet(0x80, (4, struct.pack(">3f", 1, 2, 3))) * 3
    path = tmp_path / "log.bin"
    path.write_bytes(stream)
    with open(path, "rb") as file:
        assert read_log(file).packets == 3
    with open(path, "rb", buffering=0) as raw:
        raw.seek(1)
        assert (read_log(raw).packets, read_log(raw).size) == (2, len(stream) - 1)
    with gzip.open(tmp_path / "log.gz", "wb") as packed:
        packed.write(stream)
    with gzip.open(tmp_path / "log.gz") as packed:
        assert read_log(packed).packets == 3
    (tmp_path / "empty").write_bytes(b"")
    assert read_log(tmp_path / "empty").packets == 0
    for given in (str(path), path, stream, bytearray(stream), memoryview(stream), np.frombuffer(stream, np.uint8)):
        assert read_log(given).packets == 3
    assert read_log(io.BytesIO(stream)).packets == 3
    reader, writer = os.pipe()
    os.write(writer, stream)
    os.close(writer)
    with open(reader, "rb") as pipe:
        assert read_log(pipe).packets == 3
    log = read_log(path)
    column = log["sensor.scaled_accel"]
    log.close()
    assert column["scaled_accel"].tolist() == [[1, 2, 3]] * 3
    with pytest.raises(ValueError, match="the log is closed"):
        log["sensor.scaled_gyro"]


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        ((5,), TypeError, "a log is a path, a binary file or bytes without gaps, not int"),
        ((io.StringIO("x"),), TypeError, "open the file in binary mode"),
        ((b"", -1), ValueError, "`begin` must be 0 or more"),
        ((b"", 5, 4), ValueError, "not after `end`"),
        (("/nowhere/log.bin",), FileNotFoundError, "/nowhere/log.bin"),
    ],
)
def test_what_is_no_log(arguments: tuple[Any, ...], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        read_log(*arguments)


def test_unknown_types_and_names() -> None:
    log = read_log(packet(0x80, (0x63, b"x"), (4, b"short")))
    with pytest.raises(LookupError, match=r"sensor.nothing"):
        log["sensor.nothing"]
    with pytest.raises(KeyError, match=r"set 0x82 has no field sensor.scaled_accel"):
        log.column("sensor.scaled_accel", 0x82)
    with pytest.raises(KeyError, match=r"sensor.scaled_accel has scaled_accel, not 'x'"):
        log["sensor.scaled_accel"]["x"]
    assert real.sensor.ScaledAccel not in log
    unknown = [(c.set, c.descriptor, c.type, c.name, c.count, c.rate) for c in log.types()]
    assert unknown == [(0x80, 0x04, None, "0x80,0x04", 1, None), (0x80, 0x63, None, "0x80,0x63", 1, None)]


# --------------------------------------------------------------------------- time


def gps(tow: float, week: int = 2300, flags: int = 3) -> tuple[int, bytes]:
    return 0xD3, struct.pack(">dHH", tow, week, flags)


def reference(nanoseconds: int) -> tuple[int, bytes]:
    return 0xD5, struct.pack(">Q", nanoseconds)


ACCEL = 4, bytes(12)


def test_the_time_of_a_row_is_that_of_its_packet_or_the_last_one_of_the_set() -> None:
    stream = b"".join([
        packet(0x80, ACCEL),
        packet(0x82, gps(50)),
        packet(0x80, ACCEL),
        packet(0x80, gps(100), ACCEL, ACCEL),
        packet(0x80, ACCEL),
        packet(0x80, ACCEL, gps(101, flags=1)),
        packet(0x80, ACCEL),
        packet(0x80, (0x12, struct.pack(">dHH", 102.5, 2300, 0x1F)), gps(103), ACCEL),
        packet(0x80, reference(5), ACCEL),
    ])  # fmt: skip
    column = read_log(stream)[real.sensor.ScaledAccel]
    clock, values, own = column.time()
    assert clock == "gps"
    first = np.datetime64("2024-02-04T00:00:00", "ns") + np.timedelta64(100 - 18, "s")
    later = first + np.timedelta64(2500, "ms")  # the first timestamp in the packet by its descriptor
    nat = np.datetime64("NaT")
    wanted = [nat, nat, first, first, first, nat, nat, later, later]
    assert np.array_equal(values, np.array(wanted, "datetime64[ns]"), equal_nan=True)
    assert own.tolist() == [False, False, True, True, False, True, False, True, False]
    clock, values, own = column.time("reference")
    assert values.dtype == "timedelta64[ns]"
    assert values[-1] == np.timedelta64(5, "ns")
    assert np.isnat(values[:-1]).all()
    assert column.time("external").clock == "external"
    with pytest.raises(ValueError, match="'utc' is not a clock; use one of gps, external, reference"):
        column.time("utc")


def test_leap_seconds() -> None:
    weeks = [(1, 0.0), (77, 259_200.0), (1930, 16.9), (1930, 17.5), (1930, 18.0), (2400, 1.25)]
    stream = b"".join(packet(0x80, gps(tow, week), ACCEL) for week, tow in weeks)
    times = read_log(stream)[real.sensor.ScaledAccel].time("gps").values.astype(str).tolist()
    assert times == [
        "1980-01-13T00:00:00.000000000",
        "1981-07-01T00:00:00.000000000",
        "2016-12-31T23:59:59.900000000",
        "2017-01-01T00:00:00.500000000",  # during the leap second the next second begins
        "2017-01-01T00:00:00.000000000",
        "2026-01-03T23:59:43.250000000",
    ]


@pytest.mark.parametrize("tow", [float("nan"), float("inf"), -float("inf"), 1e300, -1e300])
def test_times_that_cannot_be(tow: float) -> None:
    stream = packet(0x80, gps(tow), ACCEL)
    stream += b"".join(packet(0x80, reference(x), ACCEL) for x in (4 * 10**18, (1 << 64) - 1))
    column = read_log(stream)[real.sensor.ScaledAccel]
    assert np.isnat(column.time("gps").values).all()
    assert np.isnat(column.time("reference").values).all()
    assert column.time().clock == ""
    late = read_log(packet(0x80, gps(0, 65535), ACCEL))[real.sensor.ScaledAccel]
    assert np.isnat(late.time("gps").values).all()


# --------------------------------------------------------------------------- frames


def flagged() -> bytes:
    angles = [struct.pack(">3fH", 1, 2, 3, flag) for flag in (1, 0)]
    return b"".join(packet(0x82, (5, data), reference(i + 1)) for i, data in enumerate(angles)) + packet(
        0x82, (0x01, struct.pack(">3dH", 50, 8, 400, 1))
    )


def cells(frame: Any) -> dict[str, list[Any]]:
    """The columns of a frame of any library as lists, None where there is no value."""
    if hasattr(frame, "to_pydict"):
        return dict(frame.to_pydict())
    if hasattr(frame, "to_dicts"):
        return dict(frame.to_dict(as_series=False))
    return {c: [None if v is None or str(v) in ("nan", "NaT", "<NA>") else v for v in frame[c].tolist()] for c in frame}


@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_frames(library: str) -> None:
    log = read_log(flagged())
    unit = {"pandas": " [rad]", "polars": " [rad]", "pyarrow": ""}[library]
    plain = cells(log.frame("filter_data.euler_angles", library=library, time=None))
    assert plain == {f"{name}{unit}": [i, i] for i, name in enumerate(("roll", "pitch", "yaw"), 1)} | {
        "valid_flags": [1, 0]
    }
    masked = cells(log.frame(real.filter_data.EulerAngles, library=library, invalid="mask", units=False, position=True))
    assert list(masked) == ["time_device", "time_own", "packet", "set", "offset", "roll", "pitch", "yaw", "valid_flags"]
    assert masked["roll"] == [1, None]
    assert masked["offset"] == [0, 32]
    wide = cells(log.frame([real.filter_data.EulerAngles, "filter_data.llh_position"], library=library, units=False))
    assert wide["filter_data.euler_angles.roll"] == [1, 1, None]
    assert wide["filter_data.euler_angles.valid_flags"] == [1, 0, None]
    assert wide["filter_data.llh_position.latitude"] == [None, None, 50]
    assert wide["time_own"] == [True, True, False]


@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_a_frame_of_every_type(library: str) -> None:
    """Lists, texts and unions among them."""
    log = invented.mip_tools.columns.read_log(streams("invented", seed=8, count=150))
    for column in log.columns():
        found = cells(log.frame(column.type, library=library, invalid="mask", units=False, position=True))
        assert found["offset"] == column.offset.tolist()
        for name in set(column.names) & found.keys():
            values = column[name]
            if isinstance(values, np.ndarray) and values.ndim == 1 and values.dtype.kind in "iu":
                kept = [None if x is np.ma.masked else x for x in values.tolist()]
                assert column.parameters[name].valid or found[name] == kept, name
    assert len(log.columns()) > 20


@pytest.mark.parametrize("choice", [{"library": "excel"}, {"invalid": "hide"}, {"time": "noon"}], ids=lambda c: str(*c))
def test_choices_that_a_frame_does_not_have(choice: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=str(*choice)):
        read_log(flagged()).frame("filter_data.euler_angles", **choice)
    with pytest.raises(ValueError, match="at least one type"):
        read_log(b"").frame([])


@pytest.mark.parametrize("missing", ["pandas", "polars", "pyarrow"])
def test_a_missing_library_is_named(missing: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(ImportError, match=f"^{missing} is missing; pip install {missing}$") as caught:
        read_log(b"").frame("sensor.scaled_accel", library=missing)
    assert caught.value.name == missing


# --------------------------------------------------------------------------- compiled code


def test_more_kinds_of_fields_than_compiled_code_tells_apart(built: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, built)
    many = [packet(s, (d, bytes(3)), (d, b"")) for s in range(1, 40) for d in range(1, 30)] + [packet(0x80, ACCEL)]
    stream = b"".join(many)
    assert real.mip_tools.columns.native.kernel is not None
    data = np.frombuffer(stream + bytes(300), np.uint8)
    at, _ = real.mip_tools.columns.scan.find_packets(data, 0, len(stream), len(stream))
    assert real.mip_tools.columns.native.kernel.fields(data, at) is None
    compare(real, stream)


def test_bytes_that_change_while_compiled_code_reads_them(built: Path) -> None:
    """Another program writes to the file: packets are found, then there are other bytes in their places."""
    kernel = real.mip_tools.columns.native.Kernel(built)
    before = packet(0x01, (1, b"")) * 80
    at = np.array([i for i, _ in parsed(real, before)], np.int32)

    def read(after: bytes) -> list[tuple[int, list[int], list[int]]] | None:
        found = kernel.fields(np.frombuffer(after + bytes(300), np.uint8), at)
        if found is None:
            return None
        for one in found:
            assert ((one.packet >= 0) & (one.packet < len(at))).all()
            assert (one.offset + one.length <= 255).all()
        return [(one.descriptor, one.packet.tolist(), one.offset.tolist()) for one in found]

    assert read(before) == [(1, list(range(80)), [2] * 80)]
    assert read(b"\2" * len(before)) == [(2, list(range(80)), [2] * 80)]
    assert read(bytes((2, 2, 2, 254, 2, 2, 2, 2)) * 80) is None  # 127 fields in each: more than the bytes have room for
    rng = random.Random(6)
    for _ in range(200):
        read(rng.randbytes(len(before)))


def installed(folder: Path, pure: bool) -> tuple[str, str]:
    """The name of a wheel, and what its `mip --version` prints, installed where nobody may write."""
    source = folder / "source"
    names = ("README.md", "LICENSE", "pyproject.toml", "setup.py", "mip_tools")
    for name in names:
        path = ROOT / "tools" / name
        copy_of = shutil.copytree if path.is_dir() else shutil.copy
        source.mkdir(exist_ok=True)
        copy_of(path, source / name)
    environment = {**os.environ, "PYTHONPATH": str(REAL), **({"MIP_TOOLS_PURE": "1"} if pure else {})}
    wheel = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "--no-build-isolation", "-w", str(folder)]
    subprocess.run([*wheel, str(source)], check=True, env=environment)
    (made,) = folder.glob("*.whl")
    site = folder / "site"
    with zipfile.ZipFile(made) as archive:
        archive.extractall(site)
    before = sorted(site.rglob("*"))
    environment["PYTHONPATH"] += f"{os.pathsep}{site}"
    environment["PYTHONDONTWRITEBYTECODE"] = "1"
    command = [sys.executable, "-m", "mip_tools"]
    (folder / "log.bin").write_bytes(packet(0x80, ACCEL) * 3)
    for words in (["info", str(folder / "log.bin")], ["export", str(folder / "log.bin"), "-o", str(folder / "t.csv")]):
        subprocess.run([*command, *words], check=True, env=environment, capture_output=True)
    assert sorted(site.rglob("*")) == before  # nothing was written beside the package
    done = subprocess.run([*command, "--version"], capture_output=True, text=True, env=environment)
    return made.name, done.stdout


@packaging
@pytest.mark.parametrize(
    ("pure", "tag", "said"),
    [(False, "-cp310-abi3-", "NumPy and compiled code"), (True, "-py3-none-any.whl", "NumPy alone")],
)
def test_wheels_bring_compiled_code_or_none(pure: bool, tag: str, said: str, tmp_path: Path) -> None:
    """One for all versions of Python on this platform, and a pure one."""
    name, version = installed(tmp_path, pure)
    assert tag in name and version.endswith(f"; logs are read with {said}\n"), (name, version)


def test_the_version_without_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, f"{real.mip_tools.name}.columns.native", None)
    assert real.mip_tools.__getattr__("__main__")._version().endswith("; logs are read with nothing: NumPy is missing")


@pytest.mark.parametrize("content", [b"", b"no library"])
def test_what_is_no_compiled_code_is_left_alone(content: bytes, tmp_path: Path) -> None:
    assert real.mip_tools.columns.native.load_kernel(tmp_path) is None
    (tmp_path / "_kernel.abi3.so").write_bytes(content)
    assert real.mip_tools.columns.native.load_kernel(tmp_path) is None


@pytest.mark.parametrize("compiler", ["gcc", pytest.param("clang", marks=heavy("clang"))])
def test_compiled_code_is_clean(compiler: str, tmp_path: Path) -> None:
    options = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-c"]
    command = [need(compiler), *options, "-o", str(tmp_path / "kernel.o"), str(KERNEL)]
    subprocess.run(command, check=True)


# --------------------------------------------------------------------------- copies


def test_logs_and_columns_can_be_pickled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    stream = b"".join(packet(0x80, gps(i), ACCEL, (5, bytes(12))) for i in range(50))
    (tmp_path / "drive.bin").write_bytes(b"noise" + stream)
    monkeypatch.chdir(tmp_path)
    by_path = read_log("drive.bin", 100, 900, device="3dm-gx5-15")
    for log in (by_path, read_log(stream, 30), read_log(Path("drive.bin"))):
        column = log["sensor.scaled_accel"]
        shared = log["shared.gps_timestamp"]
        monkeypatch.chdir("/")  # as in another process
        for way in (lambda x: pickle.loads(pickle.dumps(x)), copy.copy, copy.deepcopy):
            other = way(log)
            for attribute in ("begin", "end", "device", "packets"):
                assert getattr(other, attribute) == getattr(log, attribute)
            for one in (column, shared):
                same = way(one)
                assert same.type is one.type and same.names == one.names and len(same) == len(one) > 0
                assert all((same[name] == one[name]).all() for name in one.names)
                for attribute in ("packet", "offset", "set", "sets"):
                    assert np.array_equal(getattr(same, attribute), getattr(one, attribute))
                assert same.time().values.tolist() == one.time().values.tolist()
                assert list(same.objects()) == list(one.objects())
        monkeypatch.chdir(tmp_path)
    with open("drive.bin", "rb") as file, pytest.raises(TypeError, match="read it from a path or from bytes"):
        pickle.dumps(read_log(file))
    assert repr(by_path) == f"<Log {str(tmp_path / 'drive.bin')!r}: bytes 100 to 900>"
    assert repr(read_log(b"abc")) == "<Log in memory: bytes 0 to 3>"


# --------------------------------------------------------------------------- types without parameters


@pytest.mark.parametrize("library", ["pandas", "polars", "pyarrow"])
def test_a_type_without_parameters_has_rows(library: str) -> None:
    ping, idle = (bytes(kind().packet()) for kind in (real.base.Ping, real.base.SetIdle))
    log = read_log(ping + idle + ping)
    frame = log.frame(real.base.Ping, library=library)
    assert len(frame) == 2 and cells(frame) == {"ping": [True, True]}
    both = cells(log.frame(["base.ping", "base.set_idle"], library=library))
    assert both == {"base.ping": [True, False, True], "base.set_idle": [False, True, False]}


@pytest.mark.parametrize("wrong", [4, None, int, real.types.DescriptorRate, real.types.AckCode, real.field.Command])
def test_what_is_no_field(wrong: Any) -> None:
    log = read_log(b"")
    for ask in (log.frame, log.column, log.__getitem__, log.__contains__, lambda kind: list(log.objects(kind))):
        with pytest.raises(LookupError, match="is not a field: a column needs a class such as"):
            ask(wrong)


def test_distinct_values() -> None:
    distinct = real.mip_tools.columns.distinct.distinct
    for parts in ([[]], [[3, 3, 5], []], [[1, 2, 2, 9], [0, 2, 9, 10]], [[-(2**63), 4, -(2**63), 1]]):
        arrays = [np.array(part, np.int64) for part in parts]
        assert distinct(*arrays).tolist() == sorted({value for part in parts for value in part})
        assert [array.tolist() for array in arrays] == parts
    # Without a further result, NumPy's own function hashes: sorted offsets of a log take 300 times as long.
    texts = {path: path.read_text("utf-8") for path in (ROOT / "tools/mip_tools").rglob("*.py")}
    assert not [path.name for path, text in texts.items() if re.search(r"np\.unique\((?!.*return_)|np\.union1d", text)]


# --------------------------------------------------------------------------- documentation


@pytest.mark.parametrize("page", ["docs/columns.md", "tools/README.md"])
def test_the_code_in_the_documentation_runs(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    stream = b"".join(packet(0x80, gps(i / 10), ACCEL, (5, bytes(12))) for i in range(50))
    (tmp_path / "drive.bin").write_bytes(stream)
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text("utf-8"), re.DOTALL)
    exec("\n".join(b for b in blocks if "read_log" in b or "log.parts" in b), {"__name__": "__main__"})
    assert "sensor.scaled_accel 50 10" in capsys.readouterr().out.replace("9.999", "10")
