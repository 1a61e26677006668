"""`mip export` to Parquet, Arrow and NumPy files, and `mip plot`: what other libraries read from them."""

from __future__ import annotations

import csv
import io
import json
import math
import random
import struct
import subprocess
import sys
import zlib
from contextlib import suppress
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import (
    EncodeError,
    Packet,
    PacketBuilder,
    Parser,
    base,
    gnss_data,
    registry,
    sensor,
    shared,
)
from mip_tools import columns
from mip_tools.columns import read_log, tables
from program import ENVIRONMENT, log, mip, run
from support import later

np, polars, pa, pq = (later(name) for name in ("numpy", "polars", "pyarrow", "pyarrow.parquet"))


@pytest.fixture
def path(tmp_path: Path) -> Path:
    (tmp_path / "log.bin").write_bytes(b"noise" + log() + b"\x75\x65\x80")
    return tmp_path / "log.bin"


def varied(seed: int) -> bytes:
    """Packets of any data fields, twice in a packet at times, with valid and invalid times or without."""
    rng = random.Random(seed)
    kinds = [(n, t) for n, t in registry.all_types() if 0x80 <= n < 0xFF]
    chosen = rng.sample(kinds, 12)
    found = b""
    for i in range(400):
        number, kind = rng.choice(chosen)
        builder = PacketBuilder(number)
        if rng.random() < 0.6:
            flags = rng.choice((0, 1, 3, 3, 3))
            builder.add(0xD3, shared.GpsTimestamp(i / 10, 2296, shared.GpsTimestampFlags(flags)).encode())
        for _ in range(rng.choice((1, 1, 2))):
            with suppress(EncodeError):  # it is full
                builder.add(kind.DESCRIPTOR, rng.randbytes(rng.choice((kind_size(kind), kind_size(kind) + 1, 3))))
        found += bytes(builder.build())
    return found


def kind_size(kind: Any) -> int:
    """The bytes of a field, if its lists are short."""
    size = 0
    for p in kind.INFO.parameters:
        one = {"u8": 1, "s8": 1, "bool": 1, "char": 1, "u16": 2, "s16": 2, "u32": 4, "s32": 4, "float": 4}.get(
            p.scalar, 8
        )
        size += one * (len(p.elements) or 1) * (p.length if isinstance(p.length, int) else 1)
    return size


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize(
    "words", [[], ["--invalid", "mask"], ["--invalid", "drop"], ["--time", "start"], ["--time", "none"]]
)
def test_the_same_as_csv(seed: int, words: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The same columns, rows and values from columns of NumPy as from objects."""
    (tmp_path / "log").write_bytes(varied(seed))
    assert run(capsys, "export", tmp_path / "log", "-o", tmp_path / "t.csv", *words) == (0, "", "")
    assert run(capsys, "export", tmp_path / "log", "-o", tmp_path / "t.parquet", *words) == (0, "", "")
    compare(tmp_path)


def compare(folder: Path) -> None:
    rows = list(csv.reader(io.StringIO((folder / "t.csv").read_text())))
    table = pq.read_table(folder / "t.parquet")
    assert table.num_rows == len(rows) - 1 > 10
    names = [name.partition(" [")[0] for name in rows[0]]
    assert table.schema.names == names
    for name in names:
        if name == "time" and pa.types.is_timestamp(table.schema.field(name).type):
            continue  # below
        for text, value in zip([row[names.index(name)] for row in rows[1:]], table[name].to_pylist(), strict=True):
            assert same(text, value), (name, text, value)
    if "time" in names and pa.types.is_timestamp(table.schema.field("time").type):
        nanoseconds = table["time"].cast(pa.int64()).to_pylist()
        for row, value in zip(rows[1:], nanoseconds, strict=True):
            assert (
                row[0] == ""
                if value is None
                else polars.Series([row[0][:-1]]).str.to_datetime(time_unit="ns").cast(polars.Int64)[0] == value
            )


def same(text: str, value: Any) -> bool:
    if text == "" or value is None:
        return text == "" and value in (None, "")
    if isinstance(value, bool):
        return text in (str(int(value)), str(value).lower())
    if isinstance(value, float):
        return float(text) == pytest.approx(value, rel=1e-6) or (math.isnan(value) and text in ("nan", "-nan"))
    if isinstance(value, list):
        return len(json.loads(text)) == len(value)
    return text in (str(value), str(value).strip("\0 ")) or (text in ("true", "false") and value == (text == "true"))


def test_align(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """In one part and in many, as from objects."""
    words = ["sensor.scaled_accel", "filter_data", "scaled_mag", "--align", "sensor.scaled_accel"]
    assert run(capsys, "export", path, *words, "-o", tmp_path / "t.csv")[0] == 0
    for size in (1 << 25, 1000):
        monkeypatch.setattr(tables, "PART", size)
        assert run(capsys, "export", path, *words, "-o", tmp_path / "t.parquet")[0] == 0
        compare(tmp_path)


def test_in_parts(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for words in ([], ["--time", "start"], ["gnss_1"]):
        assert run(capsys, "export", path, *words, "-o", tmp_path / "whole.arrow")[0] == 0
        with monkeypatch.context() as patch:
            patch.setattr(tables, "PART", 777)
            assert run(capsys, "export", path, *words, "-o", tmp_path / "parts.arrow")[0] == 0
        first, second = (pa.ipc.open_file(tmp_path / f"{name}.arrow").read_all() for name in ("whole", "parts"))
        assert first.equals(second) and first.schema.equals(second.schema, check_metadata=True)


@pytest.mark.parametrize("form", ["csv", "jsonl", "npz"])
def test_an_export_does_not_keep_where_the_packets_are(
    form: str, path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of a log of 2 GB, that would be 160 MB."""
    seen = []
    monkeypatch.setattr(columns, "read_log", lambda *given: seen.append(read_log(*given)) or seen[-1])
    assert run(capsys, "export", path, "-o", tmp_path / f"out.{form}")[0] == 0
    assert len(seen) == 1 and not seen[0]._kept


def test_units_are_in_the_metadata(path: Path, tmp_path: Path) -> None:
    assert mip("export", path, "sensor.scaled_accel", "-o", tmp_path / "t.parquet") == (0, "", "")
    schema = pq.read_schema(tmp_path / "t.parquet")
    assert schema.names == ["time", "time_own", "scaled_accel.x", "scaled_accel.y", "scaled_accel.z"]
    assert schema.field("scaled_accel.x").metadata[b"unit"] == b"g"
    frame = polars.read_parquet(tmp_path / "t.parquet")
    expected = [a.scaled_accel for p in _packets() if (a := sensor.ScaledAccel.find(p))]
    assert frame.select("scaled_accel.x", "scaled_accel.y", "scaled_accel.z").rows() == [tuple(v) for v in expected]
    assert str(frame["time"].dtype) == "Datetime(time_unit='ns', time_zone='UTC')"


def _packets() -> list[Packet]:
    return Parser().feed(log())


def test_numpy_files(path: Path, tmp_path: Path) -> None:
    assert mip("export", path, "filter_data", "gnss_1.llh_position", "-o", tmp_path / "t.npz") == (0, "", "")
    with np.load(tmp_path / "t.npz") as found:
        position = [f for p in _packets() if (f := gnss_data.LlhPosition.find(p))]
        latitude, there = (found[f"gnss_1.llh_position.latitude{end}"] for end in ("", "/valid"))
        assert latitude[there].tolist() == [f.latitude for f in position]
        assert found["time"].dtype == "datetime64[ns]" and "time/valid" not in found


def test_lists_and_texts_in_numpy_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Lists of any length are two arrays, in parts of the log too."""
    rows = [[2, 5, 1], [], [7], [1, 2]]
    replies = [base.GetDeviceDescriptorsResponse(tuple(row)) for row in rows]
    names = [base.GetDeviceInfoResponse(base_info(name)) for name in ("", "CV7", "a long name")]
    data = b"".join(bytes(PacketBuilder(1).add(f.DESCRIPTOR, f.encode()).build()) for f in (*replies, *names))
    (tmp_path / "log").write_bytes(data)
    for size in (1 << 22, 40):
        monkeypatch.setattr(tables, "PART", size)
        assert mip("export", tmp_path / "log", "base", "-o", tmp_path / "t.npz") == (0, "", "")
        with np.load(tmp_path / "t.npz") as found:
            lists = "base.get_device_descriptors_response.descriptors"
            offsets = found[f"{lists}/offsets"]
            cells = [found[lists][a:b].tolist() for a, b in pairwise(offsets)]
            assert cells == [*rows, [], [], []]
            model = found["base.get_device_info_response.device_info.model_name"]
            assert model.tolist() == [""] * 5 + ["CV7", "a long name"]


def base_info(name: str) -> base.BaseDeviceInfo:
    return base.BaseDeviceInfo(1, name.ljust(16), *["x" * 16] * 4)


def test_a_table_in_a_pipe(path: Path) -> None:
    command = [
        sys.executable,
        "-m",
        "mip_tools",
        "export",
        "-",
        "sensor.scaled_accel",
        "--format",
        "arrow",
        "-o",
        "-",
    ]
    done = subprocess.run(command, input=path.read_bytes(), capture_output=True, env=ENVIRONMENT)
    assert done.returncode == 0 and pa.ipc.open_file(done.stdout).read_all().num_rows > 300


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["export", "log.bin", "-o", "t.parquet"], "export: numpy is missing; pip install numpy"),
        (["info", "log.bin"], "info: numpy is missing; pip install numpy"),
        (["cut", "log.bin", "-o", "t.npz"], "cut: numpy is missing; pip install numpy"),
        (["export", "log.bin", "-o", "t.npz"], "export: numpy is missing; pip install numpy"),
        (["plot", "log.bin", "sensor", "-o", "t.png"], "plot: matplotlib is missing; pip install matplotlib"),
    ],
)
def test_missing_extras(words: list[str], error: str, path: Path) -> None:
    words = [str(path.with_name(w)) if w in ("log.bin", "t.parquet", "t.npz", "t.png") else w for w in words]
    code, out, said = mip(*words, extras=False)
    assert (code, out) == (1, "") and said.startswith(f"mip {error}") and said.count("\n") == 1
    assert [p.name for p in path.parent.iterdir()] == ["log.bin"]


# --------------------------------------------------------------------------- plot


def colours(data: bytes) -> tuple[int, int, set[bytes]]:
    """Width, height and the colours of a PNG with eight bits and alpha."""
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        size, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert (depth, colour) == (8, 6)
        packed += body if kind == b"IDAT" else b""
        at += size + 12
    raw, rows, before = zlib.decompress(packed), set(), bytes(width * 4)
    for y in range(height):
        kind, line = raw[y * (width * 4 + 1)], bytearray(raw[y * (width * 4 + 1) + 1 : (y + 1) * (width * 4 + 1)])
        for x in range(width * 4):
            left = line[x - 4] if x > 3 else 0
            up, corner = before[x], before[x - 4] if x > 3 else 0
            guess = left + up - corner
            near = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            line[x] = (line[x] + (0, left, up, (left + up) // 2, near)[kind]) & 0xFF
        before = bytes(line)
        rows.update(before[i : i + 4] for i in range(0, width * 4, 4))
    return width, height, rows


def test_a_picture(path: Path, tmp_path: Path) -> None:
    words = ("sensor.scaled_accel", "filter_data.llh_position.ellipsoid_height")
    assert mip("plot", path, *words, "-o", tmp_path / "t.png", "--size", "5x3") == (0, "", "")
    width, height, found = colours((tmp_path / "t.png").read_bytes())
    assert (width, height) == (600, 360)
    # The first three colours of matplotlib, perhaps blended with white; blue is also the second diagram.
    assert any(b - r > 60 for r, _, b, _ in found)
    assert any(r - b > 100 for r, _, b, _ in found)
    assert any(g - max(r, b) > 60 for r, g, b, _ in found)
    assert mip("plot", path, "sensor.scaled_accel.z", "--together", "-o", tmp_path / "t.svg")[0] == 0
    text = (tmp_path / "t.svg").read_text()
    assert text.startswith("<?xml") and text.count("#2ca02c") == 0


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["sensor.scaled_accel"], "no window can be opened here; write an image with -o FILE.png"),
        (
            ["sensor.scaled_accel", "-o", "t.gif"],
            "'.gif' is not a known format; name a file that ends in .png, .svg or .pdf",
        ),
        (
            ["sensor.scaled_accel.w", "-o", "t.png"],
            "sensor.scaled_accel has no element 'w'; it has x, y, z",
        ),
        (
            ["sensor.scaled_accel.scaled_accel.w", "-o", "t.png"],
            "sensor.scaled_accel has no element 'w'; it has x, ",
        ),
        (["base.ping", "-o", "t.png"], "base.ping is not a data field; `mip info` lists the fields of a log"),
        (["gnss_2.llh_position", "-o", "t.png"], "log.bin has no gnss_2.llh_position; `mip info` lists its fields"),
        (["sensor.scaled", "-o", "t.png"], "'sensor.scaled' is not a field; did you mean "),
    ],
)
def test_errors_of_plots(
    words: list[str], error: str, path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(path.parent)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    code, out, said = run(capsys, "plot", "log.bin", *words)
    status = 1 if "no window" in error or "log.bin has no" in error else 2
    assert (code, out) == (status, "") and said.startswith(f"mip plot: {error}") and said.count("\n") == 1, said
    assert [p.name for p in path.parent.iterdir()] == ["log.bin"]
