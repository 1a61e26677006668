"""`mip info`, `dump` and `cut` do the same by columns as packet by packet; and parts of their code."""

from __future__ import annotations

import random
import struct
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import Packet, PacketBuilder
from mip_protocol.text import shortest
from mip_tools.cli import (
    clocks,
    cut,
    decoding,
    dump,
    info,
    inputs,
    intervals,
    lines,
    log_report,
    messages,
    samples,
    scan,
)
from mip_tools.cli.export_mcap import encoded
from mip_tools.cli.selection import Selection
from mip_tools.columns import log as columns_log
from mip_tools.columns import read_log, text, times
from mip_tools.sentences import Sentences
from pairs import pairwise
from program import log, mip, run
from support import SEED, later, rounds
from test_columns import streams
from test_log_tables import drawn

np, pq = later("numpy"), later("pyarrow.parquet")

GOOD = b"$GPZDA,,,,,,*48\r\n"
WRONG = b"$GPZDA,,,,,,*49\r\n"


def damaged(seed: int) -> bytes:
    """Packets of any fields, and packets with times that jump, cut anywhere, with sentences and noise in between."""
    rng, found = random.Random(seed), b"\r\n"
    left, right = streams("real", seed, 120, 1), drawn(seed, 120)
    while left or right:
        size = rng.randrange(1500)
        between = rng.choice([GOOD, WRONG, b"u", b"ue", b"ue\x80\xff", b"ue\x80\x02" + bytes(40), rng.randbytes(99)])
        found += left[:size] + between + right[:size]
        left, right = left[size:], right[size:]
    return found + b"ue\x80"


STREAMS = {
    "recorded": lambda: log(2.0),
    "empty": bytes,
    "noise": lambda: random.Random(1).randbytes(3000) + b"\x75\x65\x80\x20" * 20_000 + b"no end" * 20_000 + GOOD * 3,
    "sentences": lambda: (GOOD + WRONG) * 5000,
    **{f"damaged {seed}": lambda seed=seed: damaged(seed) for seed in range(SEED, SEED + rounds(1, 20))},
}


@pytest.fixture
def stream(request: pytest.FixtureRequest) -> bytes:
    data: bytes = STREAMS[request.param]()
    return data


def held(found: intervals.Intervals) -> dict[str, Any]:
    """All attributes of intervals; the longest ones are sorted."""
    return {**vars(found), "_longest": sorted(found._longest)}


def plain_report(stream: bytes) -> log_report.Report:
    """The same packet by packet."""
    report, damaged, sentences, scanner = log_report.Report(len(stream)), scan.Damaged(), Sentences(), scan.Scanner()
    for piece in (*scanner.feed(stream), *scanner.flush()):
        if piece.packet is None:
            report.skipped += len(piece.data)
            damaged.feed(piece.data)
            report.sentences += len(sentences.feed(piece.data))
            continue
        damaged.end()
        report.packets += 1
        number = piece.packet.set
        report.sets[number] = report.sets.get(number, 0) + 1
        report.malformed += bool(decoding.malformed(piece.packet))
        seen = set()
        for raw in decoding.raw_fields(piece.packet):
            name = decoding.name_of(decoding.decoded(raw))
            kind = report.fields.setdefault((raw.set, raw.descriptor), log_report.Kind(name))
            kind.count += 1
            kind.packets += raw.descriptor not in seen
            seen.add(raw.descriptor)
        for clock, time in clocks.moments(piece.packet).items():
            if time is not None:
                report.clocks[clock].setdefault(number, intervals.Intervals()).add(time, piece.offset)
    damaged.end()
    report.runs, report.damaged = damaged.runs, damaged.count
    return report


each_stream = {"stream": sorted(STREAMS), "indirect": ["stream"]}
PIECES = [1000, 1 << 20]


@pairwise(**each_stream, piece=PIECES)
def test_info(stream: bytes, piece: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same by columns as packet by packet, however the log is divided."""
    monkeypatch.setattr(columns_log, "_PIECE", piece)
    monkeypatch.setattr(log_report, "PART", 5 * piece)
    fast, slow = log_report.examine(read_log(stream)), plain_report(stream)
    assert info.lines("log", fast) == info.lines("log", slow)
    assert info.as_json("log", fast) == info.as_json("log", slow)
    for clock, sets in slow.clocks.items():
        assert {n: held(i) for n, i in fast.clocks[clock].items()} == {n: held(i) for n, i in sets.items()}


@pairwise(
    **each_stream,
    form=[[], ["--json"]],
    device=[[], ["--device", "3dm-gx5-15"]],
    fields=[[], ["--only", "sensor,shared"], ["--without", "0x82"]],
)
def test_dump(
    stream: bytes,
    form: list[str],
    device: list[str],
    fields: list[str],
    tmp_path: Path,
    capsys: Any,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The same lines by columns as packet by packet."""
    (tmp_path / "log.bin").write_bytes(stream)
    seen = []
    monkeypatch.setattr(lines, "PART", 3000)
    whole = lines.lines
    monkeypatch.setattr(lines, "lines", lambda *given: seen.append(1) or whole(*given))
    words = ["dump", tmp_path / "log.bin", *form, *device, *fields]
    fast = run(capsys, *words)
    monkeypatch.setattr(dump, "_by_columns", lambda *given: False)
    assert fast == run(capsys, *words)
    assert len(seen) == 1


Pieces = list[scan.Piece]


def cut_plainly(pieces: Pieces, options: dict[str, str], skipped: bool) -> bytes:
    """A part of a log packet by packet."""
    only = options.get("--only", "")
    first, end = (int(n or 10**9) for n in options.get("--bytes", "0:").split(":"))
    since, until = (
        clocks.SECOND * float(options.get(word, late)) for word, late in (("--begin", "-inf"), ("--end", "inf"))
    )
    moments = [clocks.moments(piece.packet) for piece in pieces if piece.packet]
    known = {clock for said in moments for clock, time in said.items() if time is not None}
    clock = next((clock for clock in clocks.CLOCKS if clock in known), "")
    if not clock and ("--begin" in options or "--end" in options):
        return b""
    within, out, start, now = first == 0 and "--begin" not in options, b"", None, None
    for piece in pieces:
        if piece.packet is None:
            out += piece.data * (within and skipped)
            continue
        now = next((t for c, t in clocks.moments(piece.packet).items() if c == clock and t is not None), now)
        start = now if start is None else start
        timed = "--begin" not in options if now is None or start is None else since <= now - start < until
        within = first <= piece.offset < end and timed
        fields = list(decoding.raw_fields(piece.packet))
        wanted = [raw for raw in fields if not only or (raw.set, raw.descriptor) in ((0x80, 4), (0x82, 5))]
        if not within or (only and not wanted):
            continue
        builder = PacketBuilder(piece.packet.set)
        for raw in wanted:
            builder.add(raw.descriptor, raw.data)
        out += piece.data if len(wanted) == len(fields) else bytes(builder.build())
    return out


@pairwise(
    **each_stream,
    part=[{}, {"--bytes": "300:9000"}, {"--begin": "0.5"}, {"--end": "1.5"}, {"--begin": "0", "--end": "1000"}],
    only=[{}, {"--only": "sensor.scaled_accel,filter_data.euler_angles"}],
    skipped=[False, True],
    piece=PIECES,
    pipe=[False, True],
)
def test_cut(
    stream: bytes,
    part: dict[str, str],
    only: dict[str, str],
    skipped: bool,
    piece: int,
    pipe: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The same by columns as packet by packet, from a file and from a pipe."""
    monkeypatch.setattr(columns_log, "_PIECE", piece)
    monkeypatch.setattr(cut, "PART", 5 * piece)
    monkeypatch.setattr(inputs, "_BATCH", 5 * piece)
    (tmp_path / "log").write_bytes(stream)
    scanner = scan.Scanner()
    wanted = cut_plainly([*scanner.feed(stream), *scanner.flush()], part | only, skipped)
    words = [*(word for option in (part | only).items() for word in option), *["--keep-skipped"] * skipped]
    name, data = ("-", stream) if pipe else (tmp_path / "log", b"")
    code, _, error = mip("cut", name, "-o", tmp_path / "part", *words, data=data)
    assert (code, error.count("\n")) == (0, 0) if wanted else code == 1
    assert not wanted or (tmp_path / "part").read_bytes() == wanted


@pairwise(**each_stream, only=[[], ["sensor,filter_data"]], invalid=["keep", "drop"], named=[False, True], piece=PIECES)
def test_messages(
    stream: bytes, only: list[str], invalid: str, named: bool, piece: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same by columns as packet by packet, of all fields or of some."""
    monkeypatch.setattr(columns_log, "_PIECE", piece)
    monkeypatch.setattr(messages, "PART", 3 * piece)
    scanner = scan.Scanner()
    pieces = [*scanner.feed(stream), *scanner.flush()]
    selection = Selection(only, data=True)
    log = read_log(stream)
    kinds, clock = messages.survey(log, selection)
    seen, best = samples.survey(pieces, selection)
    assert (set(kinds), clock) == (set(seen), best)
    for some in (kinds, kinds[::2]):
        found = samples.kept(samples.samples(pieces, some, selection, clock), invalid)
        wanted = [(s.kind, s.time, s.own, s.packet, encoded(s.value, named)) for packet in found for s in packet]
        assert list(messages.Messages(some, selection, clock, invalid, messages.Json(named)).of(log)) == wanted


def test_decimals_of_numbers_of_four_bytes() -> None:
    rng, count = np.random.default_rng(1), rounds(4000, 20_000)
    tens, twos = np.float32(10) ** np.arange(-12, 13, dtype=np.float32), np.float32(2) ** np.arange(-140, 127)
    numbers = np.concatenate(
        [
            rng.integers(0, 1 << 32, count, np.uint32).view(np.float32),
            rng.normal(size=count).astype(np.float32),
            (10 ** rng.uniform(-6, 10, count)).astype(np.float32),
            (rng.integers(-(10**6), 10**6, count) / 1000).astype(np.float32),
            *(np.nextafter(x, np.float32(end)).astype(np.float32) for x in (tens, twos) for end in (0, np.inf)),
            tens,
            twos.astype(np.float32),
            np.array([0, -0.0, np.nan, np.inf, -np.inf], np.float32),
        ]
    )
    assert list(map(repr, text.shortest(numbers).tolist())) == [shortest(x) for x in numbers.tolist()]
    assert text.shortest(numbers[:0]).tolist() == []


KINDS = {
    # Their digits end in 5, between two shorter decimals; logs of quantized values have many.
    "binary fractions": np.arange(-50_000, 50_000, 7, dtype=np.float32) / 64,
    "small": (10 ** np.linspace(-12.9, -5, 4000)).astype(np.float32),
    "large": (10 ** np.linspace(9, 20.9, 4000)).astype(np.float32),
}


@pytest.mark.parametrize("kind", KINDS)
def test_hardly_any_decimals_are_computed_alone(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Alone, they take ten times as long."""
    numbers = KINDS[kind]
    right = [shortest(x) for x in numbers.tolist()]
    alone: list[float] = []
    monkeypatch.setattr(text, "shortest_text", lambda x: alone.append(x) or shortest(x))
    assert list(map(repr, text.shortest(numbers).tolist())) == right
    assert len(alone) < len(numbers) / 50


@pytest.mark.parametrize("most", [3, 10**9, 2**52, 8 * 10**18])
@pytest.mark.parametrize("cut", [1, 7, 10_000])
def test_intervals_of_arrays(most: int, cut: int) -> None:
    rng = random.Random(most)
    moments = [rng.randrange(-most, most) for _ in range(300)] + [10**9 * i for i in range(300)]
    one, all_ = intervals.Intervals(), intervals.Intervals()
    for at in range(0, len(moments), cut):
        part = moments[at : at + cut]
        all_.add_all(np.array(part, np.int64), np.arange(at, at + len(part)) * 40)
    for i, moment in enumerate(moments):
        one.add(moment, i * 40)
    assert held(one) == held(all_)


@pytest.mark.parametrize("value", [0, 4 * 10**18 - 1, 4 * 10**18, 4 * 10**18 - 200, 2**64 - 1])
def test_times_have_one_rule(value: int) -> None:
    packet = bytes(PacketBuilder(0x80).add(0xD5, struct.pack(">Q", value)).add(4, bytes(12)).build())
    (found,) = read_log(packet)["sensor.scaled_accel"].time("reference").values.view(np.int64).tolist()
    assert clocks.moments(Packet(packet)) == {"reference": None if found == times.NONE else found}
    assert (found == times.NONE) == (value >= 4 * 10**18)


@pytest.mark.parametrize("chunk", [1, 7, 1000, 1 << 20])
def test_damaged_packets_are_counted_however_the_bytes_come(chunk: int) -> None:
    rng = random.Random(5)
    parts = [rng.choice([b"ue\x80\x05", b"u", b"e", b"ue\x80\xff", bytes(9), b"ue\x00"]) for _ in range(40_000)]
    data = b"".join(parts)
    assert len(data) > 3 * (1 << 16) / 2
    whole, cut = scan.Damaged(), scan.Damaged()
    whole._run += data
    whole.end()
    for at in range(0, len(data), chunk):
        cut.feed(data[at : at + chunk])
    cut.end()
    assert (cut.count, cut.runs) == (whole.count, 1) and cut.count > 4000


def test_hexadecimal_digits_can_be_exported_by_columns(tmp_path: Path, capsys: Any) -> None:
    packet = bytes(PacketBuilder(0x80).add(4, struct.pack(">3f", 1, 2, 3)).build())
    (tmp_path / "log.txt").write_text(packet.hex(" "))
    assert run(capsys, "export", tmp_path / "log.txt", "-o", tmp_path / "out.parquet")[0] == 0
    assert pq.read_table(tmp_path / "out.parquet").num_rows == 1
    assert run(capsys, "export", tmp_path / "log.txt", "-o", tmp_path / "out.csv")[0] == 0
    assert (tmp_path / "out.csv").read_text().endswith("\n1.0,2.0,3.0\n")
