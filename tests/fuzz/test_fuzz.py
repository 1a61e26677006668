"""What `make fuzz` does beside libFuzzer: languages are compared, and executions counted."""

from __future__ import annotations

import datetime
import random
import re
import sys
from itertools import islice
from pathlib import Path
from typing import Any

import counts
import differential
import fuzz
import pytest
import streams
from support import SEED, Driver, heavy, rounds


class Wrong(Driver):
    """Sees one packet fewer in a stream with this byte, and ends at a packet with the other one."""

    def ask(self, requests: list[dict[str, Any]]) -> list[dict[str, Any]]:
        assert not any("fe" in r.get("packet", "") for r in requests)
        return [{"packets": [] if "ee" in r.get("stream", "") else [r]} for r in requests]


class Right(Driver):
    def ask(self, requests: list[dict[str, Any]]) -> list[dict[str, Any]]:
        return [{"packets": [r]} for r in requests]


RIGHT, WRONG = Right("c", [], {}), Wrong("python", [], {})
PARSE = [{"op": "parse", "stream": s, "chunk": 1} for s in ("11" * 90, "22" * 70 + "ee" + "33" * 40)]


def test_a_difference_is_shown_and_small() -> None:
    differential.different(PARSE[:1], [(d, differential.of(d, PARSE[:1])) for d in (RIGHT, WRONG)])
    with pytest.raises(SystemExit, match=r'^\{"op": "parse", "stream": "ee", "chunk": 1\}\nc: .*\npython: '):
        differential.different(PARSE, [(d, differential.of(d, PARSE)) for d in (RIGHT, WRONG)])


def test_the_request_that_ends_a_driver_is_found() -> None:
    packets = [{"op": "decode", "packet": p} for p in ("01", "02", "fe", "03")]
    given = differential.of(WRONG, packets)
    assert ["ended" in a for a in given] == [False, False, True, False]


def test_what_a_driver_does_not_offer_is_not_asked() -> None:
    given = differential.of(Right("cpp", [], {}), [*PARSE, {"op": "client", "steps": []}])
    assert [a is None for a in given] == [False, False, True]


@heavy("the drivers of all languages")
def test_all_languages_give_the_same_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(differential, "BATCH", rounds(300, 4000))
    assert differential.Session(str(SEED)).run(0.01) >= 300


@heavy("an optimized Rust crate")
def test_all_languages_find_the_same_in_streams(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(streams, "BATCH", rounds(1000, 100_000))
    session = streams.Session("invented", tmp_path)
    assert all(count > streams.BATCH for count in islice(session.run(3600, random.Random(SEED)), 2))
    right = (streams.TESTS / "python/answers.py").read_text("utf-8")
    encoded, wrong = "value.encode().hex()", tmp_path / "answers.py"
    session.commands["python"][-1] = wrong
    for other, shown in {
        f"{encoded}.replace('ff', 'fe')": ".*=.*fe.*",
        f"{encoded} if 0x47 not in raw.data else sys.exit('no')": "ended: no",
    }.items():
        wrong.write_text(right.replace(encoded, other))
        found = rf"^\d+ [0-9a-f]*(ff|47)[0-9a-f]*\nc: (.*)\npython: {shown}\nrust: \2\njavascript: \2$"
        with pytest.raises(SystemExit, match=found):
            list(session.run(3600, random.Random(SEED)))


def test_the_first_stream_with_different_answers_is_shown() -> None:
    asked, same = [b"0 75", b"0 65", b"0 66"], [b"1", b"2", b"3"]
    streams.different(asked, {"c": same, "rust": same})
    for other, shown in (
        ([b"1", b"4", b"5"], "0 65\nc: 2\nrust: 4"),
        ([b"1", b"ended: signal"], "0 65\nc: 2\nrust: ended: signal"),
        ([b"1"], "0 65\nc: 2\nrust: nothing"),
        ([b"1", b"2", b"3", b"4"], "nothing\nc: nothing\nrust: 4"),
    ):
        with pytest.raises(SystemExit, match=f"^{shown}$"):
            streams.different(asked, {"c": same, "rust": other})


def test_inputs_become_requests() -> None:
    chance = random.Random(SEED)
    stream = differential.changed(chance, b"\x05\x00ue\x80\x00", [b"abc"], 8)
    assert len(stream) <= 8
    assert differential.request("parser", b"\x05\x00ue") == {"op": "parse", "stream": "7565", "chunk": 5}
    asked = differential.request("fields", bytes.fromhex("00011f00"))
    assert asked and asked["packet"].startswith("75650102021f")
    assert differential.request("fields", bytes.fromhex("00ff1f00")) is None


def test_the_table_is_that_of_the_counts() -> None:
    page = counts.PAGE.read_text("utf-8")
    assert counts.page(page) == page


def test_the_table_shows_the_revision_of_the_last_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of two runs on one day, too, whatever their revisions are."""
    page = tmp_path / "page"
    page.write_text(f"{counts.BEGIN}{counts.END}")
    monkeypatch.setattr(counts, "PAGE", page)
    monkeypatch.setattr(counts, "COUNTS", tmp_path / "counts.txt")
    today = datetime.date.today().isoformat()
    for earlier in ("00000000", "zzzzzzzz"):
        counts.COUNTS.write_text(f"# head\nparser {earlier} {today} 5\n")
        counts.add("parser", 2)
        counts.add("parser", 3)
        shown = re.search(r"^\| `parser` \| 10 \| \S+ \| (\w+) \|$", page.read_text(), re.MULTILINE)
        assert shown is not None and shown[1] != earlier


def test_a_fresh_clone_has_the_invented_library_when_it_is_fuzzed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, found = tmp_path / "invented", []
    monkeypatch.setattr(fuzz, "generate_invented", lambda: out.mkdir() or "")
    monkeypatch.setattr(fuzz, "fuzz", lambda name, seconds: found.append(out.is_dir()) or [1])
    monkeypatch.setattr(counts, "add", lambda *given: None)
    monkeypatch.setattr(sys, "argv", ["fuzz.py", "--targets", "fields-invented"])
    fuzz.main()
    assert found == [True]
