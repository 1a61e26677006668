"""The data of two receivers has the same class, and is never mixed: columns, tables, reports and the simulator."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from mip_protocol import Parser, gnss_data, registry
from mip_simulator import VirtualDevice
from mip_tools.columns import read_log
from mip_tools.devices.facts import VALUES, FieldValues, value_sources
from program import run

Dop = gnss_data.Dop
ONE, TWO = 0x91, 0x92
BOTH = (
    "gnss_data.dop in several sets: gnss_1.dop, gnss_2.dop; "
    "select one, for example log['gnss_1.dop'] or log.column(Dop, 0x91)"
)


def dop(set_number: int, value: float) -> bytes:
    made = Dop(value, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, Dop.INFO["valid_flags"].type(1))
    return bytes(made.packet(set_number))


def stream(*sets: int) -> bytes:
    """Three fields of each set; the value is the set plus a quarter of the turn."""
    return b"".join(dop(set_number, set_number + turn / 4) for turn in range(3) for set_number in sets)


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "log.bin"
    path.write_bytes(stream(ONE, TWO))
    return path


# --------------------------------------------------------------------------- columns


def test_a_set_has_its_own_column() -> None:
    log = read_log(stream(ONE, TWO))
    assert [(c.name, c.sets, c["gdop"].tolist()) for c in log.columns()] == [
        ("gnss_1.dop", [ONE], [145, 145.25, 145.5]),
        ("gnss_2.dop", [TWO], [146, 146.25, 146.5]),
    ]
    two = log.column(Dop, TWO)
    for kind in ("gnss_2.dop", "gnss_2.Dop", "Gnss2.Dop", "gnss2 dop", "mip_gnss_2.dop", "0x92,0x07", (TWO, Dop)):
        assert log[kind].name == "gnss_2.dop" and (log[kind]["gdop"] == two["gdop"]).all(), kind
    assert [d.gdop for d in two.objects()] == [d.gdop for d in log.objects(Dop, TWO)] == [146, 146.25, 146.5]
    assert {d.packet_set for d in two.objects()} == {TWO}
    assert not len(log["gnss_external.dop"]) and not len(log["gnss_data.dop"])
    assert [count.name for count in log.types()] == ["gnss_1.dop", "gnss_2.dop"]


def test_a_class_alone_is_refused_if_several_sets_have_it() -> None:
    log = read_log(stream(ONE, TWO))
    for ask in (log.column, log.__getitem__, log.frame, lambda kind: list(log.objects(kind))):
        for kind in (Dop, "dop") if ask != log.objects else (Dop,):
            with pytest.raises(LookupError) as error:
                ask(kind)
            assert BOTH in str(error.value)
    assert Dop in log and "gnss_2.dop" in log and "gnss_external.dop" not in log and gnss_data.GpsTime not in log


def test_a_class_alone_finds_the_only_set() -> None:
    log = read_log(stream(TWO))
    for kind in (Dop, "dop"):
        assert log[kind].name == "gnss_2.dop" and log[kind].sets == [TWO] and len(log[kind]) == 3
    assert len(list(log.objects(Dop))) == len(list(log[Dop].objects())) == 3
    assert not len(read_log(b"")[Dop])


# --------------------------------------------------------------------------- the command line


def test_an_export_has_both_receivers(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, error = run(capsys, "export", log, "-o", "-")
    assert code == 0 and error.endswith("no date: no timestamps; add one to the message format\n")
    rows = list(csv.DictReader(out.splitlines()))
    assert [r["gnss_2.dop.gdop"] for r in rows if r["gnss_2.dop.gdop"]] == ["146.0", "146.25", "146.5"]
    assert [r["gnss_1.dop.gdop"] for r in rows if r["gnss_1.dop.gdop"]] == ["145.0", "145.25", "145.5"]
    code, out, error = run(capsys, "export", log, "-o", "-", "--format", "jsonl")
    found = [json.loads(line) for line in out.splitlines()]
    for name, wanted in (("gnss_1.dop.gdop", [145, 145.25, 145.5]), ("gnss_2.dop.gdop", [146, 146.25, 146.5])):
        assert [line[name] for line in found if name in line] == wanted


def test_an_export_of_one_receiver(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words in (["gnss_2"], ["gnss_2.dop"], ["0x92:0x07"], ["--without", "gnss_1.dop"]):
        out = run(capsys, "export", log, "-o", "-", "--time", "none", *words)[1]
        assert [line.split(",")[0] for line in out.splitlines()] == ["gdop", "146.0", "146.25", "146.5"]


def test_reports_have_both_receivers(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = json.loads(run(capsys, "info", log, "--json")[1])
    assert [(f["name"], f["count"]) for f in report["fields"]] == [("gnss_1.dop", 3), ("gnss_2.dop", 3)]
    lines = run(capsys, "dump", log)[1].splitlines()
    assert "gnss_1: dop(gdop=145.0" in lines[0] and "gnss_2: dop(gdop=146.0" in lines[1]
    assert "gnss_2.dop (0x92,0x07)" in run(capsys, "dump", log, "--tree")[1]
    assert run(capsys, "fields", "gnss_2.dop")[1].startswith("gnss_2.dop (0x92,0x07), data\n")
    out = run(capsys, "fields", "gnss_2")[1]
    assert "0x92,0x07  gnss_2.dop " in out and "gnss_1" not in out


def test_a_name_of_both_receivers_is_refused(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, error = run(capsys, "plot", log, "dop.gdop", "-o", log.with_name("t.png"))
    assert (code, out) == (2, "") and "in several sets; write gnss_data.dop or gnss_1.dop or gnss_2.dop" in error


# --------------------------------------------------------------------------- the virtual device


def test_a_set_shows_its_own_values_else_those_of_the_family(monkeypatch: pytest.MonkeyPatch) -> None:
    position = gnss_data.LlhPosition
    one, two = value_sources(position, ONE), value_sources(position, TWO)
    assert one is VALUES["gnss_data.llh_position"] and two is VALUES["gnss_2.llh_position"] and one != two
    assert value_sources(Dop, TWO) is VALUES["gnss_data.dop"]
    assert value_sources(registry.by_name("sensor.scaled_accel"), 0x80) is VALUES["sensor.scaled_accel"]
    monkeypatch.delitem(VALUES, "gnss_data.dop")
    assert value_sources(Dop, TWO) == FieldValues()


def test_two_receivers_of_a_device_differ() -> None:
    device = VirtualDevice("3dm-cv7-gnss-ins")
    link = device.connect()
    found = []
    for set_number in (ONE, TWO):
        device.send_data(set_number, [gnss_data.LlhPosition.DESCRIPTOR])
        found += [gnss_data.LlhPosition.find(p) for p in Parser().feed(link.read())]
    one, two = found
    assert one is not None and two is not None and (one.packet_set, two.packet_set) == (ONE, TWO)
    assert (one.latitude, one.longitude) != (two.latitude, two.longitude)
