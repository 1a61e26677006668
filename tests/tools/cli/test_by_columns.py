"""`mip info` and `cut` do the same by columns as packet by packet; and parts of their code."""

from __future__ import annotations

import csv
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import PacketBuilder, filter_data, timestamps
from mip_protocol.text import shortest
from mip_tools.columns import intervals, read_log, text, timeline, times
from mip_tools.columns import packets as columns_packets
from mip_tools.columns.stamps import NONE, Stamps
from mip_tools.commands import cut, info
from mip_tools.formats import messages
from mip_tools.formats.json_messages import encoded
from mip_tools.logs import inputs, scan
from mip_tools.logs import report as log_report
from mip_tools.names.occurrence import occurrence_in
from mip_tools.names.selection import Selection
from mip_tools.sentences import Sentences
from mip_tools.text import clocks, decoding, row_texts
from mip_tools.text.decoding import decoded_field, raw_fields
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
    "dated, goes back": lambda: damaged(1796100900),
    **{f"damaged {seed}": lambda seed=seed: damaged(seed) for seed in range(SEED, SEED + rounds(1, 20))},
}


@pytest.fixture
def stream(request: pytest.FixtureRequest) -> bytes:
    data: bytes = STREAMS[request.param]()
    return data


def held(found: intervals.Intervals) -> dict[str, Any]:
    """All attributes of intervals; the longest ones are sorted."""
    return {**vars(found), "_longest": sorted(found._longest)}


class Plain(intervals.Intervals):
    """Intervals that are added one by one."""

    def add_all(self, times: Any, offsets: Any) -> None:
        for time, offset in zip(times.tolist(), offsets.tolist()):
            self.add(time, offset)


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
        seen = {}
        for raw in decoding.raw_fields(piece.packet):
            name = decoding.name_of(decoding.decoded_field(raw))
            report.fields.setdefault((raw.set, raw.descriptor), log_report.Kind(name)).count += 1
            seen[raw.descriptor] = np.zeros(1, np.int64)
        moments = timestamps.moments(piece.packet)
        for clock in report.clocks:
            stamped = np.zeros(int(clock in moments), np.int64)
            time = NONE if moments.get(clock) is None else moments[clock]
            if time != NONE or number in report.clocks[clock]:
                stamps = Stamps(stamped, stamped + time, lambda at=stamped + piece.offset: at)
                report.clocks[clock].setdefault(number, Plain()).add_set(np.zeros(1, np.int64), stamps, seen)
    damaged.end()
    report.runs, report.damaged = damaged.runs, damaged.count
    return report


each_stream = {"stream": sorted(STREAMS), "indirect": ["stream"]}
PIECES = [1000, 1 << 20]


@pairwise(**each_stream, piece=PIECES)
def test_info(stream: bytes, piece: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same by columns as packet by packet, however the log is divided."""
    monkeypatch.setattr(columns_packets, "_PIECE", piece)
    monkeypatch.setattr(log_report, "PART", 5 * piece)
    fast, slow = log_report.report_on(read_log(stream)), plain_report(stream)
    slow.timeline, slow.assumed = fast.timeline, fast.assumed  # see test_time.py
    slow.clocks["device"] = fast.clocks["device"]
    assert info.report_lines("log", fast) == info.report_lines("log", slow)
    assert info.as_json("log", fast) == info.as_json("log", slow)
    for clock, sets in slow.clocks.items():
        assert {n: held(i) for n, i in fast.clocks[clock].items()} == {n: held(i) for n, i in sets.items()}


@pytest.mark.parametrize("form", [[], ["--json"]])
def test_bits_that_depend_on_a_state(form: list[str], tmp_path: Path, capsys: Any) -> None:
    """The same flags in the different states of a filter have different names, in lines and in tables."""
    data = b""
    for state, flags in ((2, 0x1000), (1, 0x1000), (2, 1), (4, 1), (1, 0x1100), (2, 0x1000)):
        status = filter_data.Status(filter_state=state, dynamics_mode=1, status_flags=flags)
        data += bytes(PacketBuilder(0x82).add(status.DESCRIPTOR, status.encode()).build())
    (tmp_path / "log").write_bytes(data)
    device = ["--device", "3dm-gx5-15"]
    words = ["dump", tmp_path / "log", *device, *form]
    fast = run(capsys, *words)[1]
    run(capsys, "export", tmp_path / "log", "status", *device, "--names", "-o", tmp_path / "t.csv")
    first, *others = "run_mag_bias_est_high_warning", "init_no_attitude", "run_imu_unavailable", "0x1"
    names = [first, *others, "init_no_attitude|0x100", first]
    with (tmp_path / "t.csv").open(newline="") as file:
        assert [row[-1] for row in csv.reader(file)][1:] == names
    for word, line in zip(names, fast.splitlines()):
        assert all(part in line for part in word.split("|"))


Pieces = list[scan.Piece]


def cut_plainly(pieces: Pieces, options: dict[str, str]) -> bytes:
    """A part of a log packet by packet."""
    only = options.get("--only", "")
    since, until = (
        clocks.SECOND * float(options.get(word, late)) for word, late in (("--begin", "-inf"), ("--end", "inf"))
    )
    log = read_log(b"".join(piece.data for piece in pieces))
    line = timeline.of_log(log)
    clock = line.clocks(line.sets).steady
    if not clock and ("--begin" in options or "--end" in options):
        return b""
    moments = iter(times.of_packets(log, clock).tolist() if clock else [times.NONE] * len(pieces))
    added: Any = 0
    out, start, now = b"", None, None
    found = False
    for piece in pieces:
        if piece.packet is None:
            continue
        time = next(moments)
        if piece.offset in line.restarts(clock) and not clocks.dated(clock):  # a date is not moved
            added = None
        if time != times.NONE:
            added = now - time if added is None else added
            now = time + added
        start = now if start is None else start
        within = "--begin" not in options if now is None or start is None else since <= now - start < until
        fields = list(decoding.raw_fields(piece.packet))
        wanted = [raw for raw in fields if not only or (raw.set, raw.descriptor) in ((0x80, 4), (0x82, 5))]
        found = found or (within and (not only or bool(wanted)))
        if any((raw.set, raw.descriptor) == (0x01, 0x81) for raw in fields):  # of a file, also outside the bounds
            out += piece.data
            continue
        if not within or (only and not wanted):
            continue
        builder = PacketBuilder(piece.packet.set)
        for raw in wanted:
            builder.add(raw.descriptor, raw.data)
        out += piece.data if len(wanted) == len(fields) else bytes(builder.build())
    return out if found else b""


@pairwise(
    **each_stream,
    part=[{}, {"--begin": "0.5"}, {"--end": "1.5"}, {"--begin": "0", "--end": "1000"}],
    only=[{}, {"--only": "sensor.scaled_accel,filter_data.euler_angles"}],
    piece=PIECES,
    pipe=[False, True],
)
def test_cut(
    stream: bytes,
    part: dict[str, str],
    only: dict[str, str],
    piece: int,
    pipe: bool,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The same by columns as packet by packet, from a file and from a pipe."""
    monkeypatch.setattr(columns_packets, "_PIECE", piece)
    monkeypatch.setattr(cut, "PART", 5 * piece)
    monkeypatch.setattr(inputs, "_BATCH", 5 * piece)
    (tmp_path / "log").write_bytes(stream)
    scanner = scan.Scanner()
    wanted = cut_plainly([*scanner.feed(stream), *scanner.flush()], part | only)
    words = [*(word for option in (part | only).items() for word in option)]
    name, data = ("-", stream) if pipe else (tmp_path / "log", b"")
    code, _, error = mip("cut", name, "-o", tmp_path / "part", *words, data=data)
    assert (code, error.count("\n")) == (0, 0) if wanted else code == 1
    assert not wanted or (tmp_path / "part").read_bytes() == wanted


@pairwise(**each_stream, only=[[], ["sensor,filter_data"]], invalid=["keep", "drop"], named=[False, True], piece=PIECES)
def test_messages(
    stream: bytes, only: list[str], invalid: str, named: bool, piece: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same by columns as packet by packet, of all fields or of some."""
    monkeypatch.setattr(columns_packets, "_PIECE", piece)
    monkeypatch.setattr(messages, "PART", 3 * piece)
    monkeypatch.setattr(row_texts, "_MANY", 1)
    scanner = scan.Scanner()
    pieces = [*scanner.feed(stream), *scanner.flush()]
    selection = Selection(only, data=True)
    log = read_log(stream)
    kinds, both = messages.survey_messages(log, selection)
    clock = both.dated or None
    found = list(plainly(pieces, selection, clock))
    assert set(kinds) == {one[0] for one in found}
    for some in (kinds, kinds[::2]):
        wanted = [
            (kind, time, own, number, encoded(value, named, log.reads(type(value))))
            for kind, time, own, number, value in found
            if kind in some and (invalid == "keep" or messages.all_valid(value, log.reads(type(value))))
        ]
        batches = messages.Messages(some, selection, clock, invalid, messages.Json(named)).of_log(log)
        made = [
            (b.kinds[kind], None if time == NONE else time, own, number, data)
            for b in batches
            for kind, time, own, number, data in zip(*(a.tolist() for a in b[1:5]), b.data)
        ]
        assert made == wanted


def plainly(pieces: list[Any], selection: Selection, clock: str | None) -> Iterator[tuple[Any, ...]]:
    """The fields of each packet, with the time in it, or the last one of its set."""
    last: dict[int, tuple[int | None, int]] = {}
    for number, piece in enumerate(piece for piece in pieces if piece.packet is not None):
        times, set_number = timestamps.moments(piece.packet), piece.packet.set
        own = clock in times
        last[set_number] = (times[clock], piece.offset) if own else last.get(set_number, (None, 0))
        time, place = last[set_number]
        for raw in raw_fields(piece.packet):
            one = decoded_field(raw)
            if one.value is not None and one.kind is not None and selection.has(raw.set, raw.descriptor):
                near = own or piece.offset - place <= timestamps.REACH
                yield occurrence_in(raw.set, one.kind), time if near else None, own, number, one.value


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
    assert list(map(repr, text.shortest_decimals(numbers).tolist())) == [shortest(x) for x in numbers.tolist()]
    assert text.shortest_decimals(numbers[:0]).tolist() == []
