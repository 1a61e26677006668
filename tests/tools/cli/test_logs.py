"""`mip info`, `cut`, `export` and `plot`: what is in a log, parts of it, tables, pictures."""

from __future__ import annotations

import csv
import io
import json
import os
import random
import re
import signal
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import Packet, PacketBuilder, Parser, base, filter_data, registry, sensor, shared
from mip_tools.errors import Failure
from mip_tools.files import outputs
from program import (
    DEVICE,
    ENVIRONMENT,
    PATIENCE,
    RATES,
    RECOGNIZED,
    command,
    log,
    mip,
    on_a_full_disk,
    run,
    running,
    until,
)
from support import heavy, later, rounds

np, pq, pyplot = later("numpy"), later("pyarrow.parquet"), later("matplotlib.pyplot")

NOISE = b"$GPGGA,123519,4807.038,N*27\r\n"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A log with noise, a damaged packet and a packet that has no end."""
    packets = Parser().feed(log())
    damaged = bytearray(bytes(packets[7]))
    damaged[-1] ^= 1
    data = b"".join(map(bytes, packets[:10])) + NOISE + bytes(damaged) + b"".join(map(bytes, packets[10:]))
    (tmp_path / "log.bin").write_bytes(data + b"\x75\x65\x80\x20\x04")
    return tmp_path / "log.bin"


def packets(data: bytes) -> list[Packet]:
    parser = Parser()
    return [*parser.feed(data), *parser.flush()]


def stamped(seconds: float, week: int = 2296, flags: int = 3) -> bytes:
    """A packet of sensor data with a time."""
    stamp = shared.GpsTimestamp(seconds, week, shared.GpsTimestampFlags(flags))
    builder = PacketBuilder(0x80).add(0xD3, stamp.encode())
    return bytes(builder.add(0x04, sensor.ScaledAccel((seconds, 0.1, -1.0)).encode()).build())


# --------------------------------------------------------------------------- info


def test_what_is_in_a_log(path: Path) -> None:
    code, out, error = mip("info", path)
    assert (code, error) == (0, "")
    lines = out.splitlines()
    count = len(packets(path.read_bytes()))
    damaged = len(bytes(Parser().feed(log())[7]))
    assert lines[0] == f"{path}: {path.stat().st_size / 1000:.3g} kB, {count} packets"
    assert lines[1].startswith("time: 2024-01-06T23:59:42.") and lines[1].endswith("0 s (gps clock, as UTC)")
    assert lines[2] == RECOGNIZED
    assert lines[3].startswith(f"skipped: {len(NOISE) + damaged + 5} bytes (")
    assert lines[3].endswith(" in 2 places: 2 damaged packets, 1 NMEA sentence")
    table = {line.split("  ")[0].strip(): line.split()[-2:] for line in lines[5:] if line}
    for number, fields in RATES.items():
        (name,) = (key for key in table if f"(0x{number:02X})" in key)
        fastest = min(decimation for _, decimation in fields)
        base = 1000 if number < 0x90 else 5
        assert float(table[name][1]) == pytest.approx(base / fastest, rel=0.01)


def test_the_report_for_programs(path: Path) -> None:
    code, out, _ = mip("info", "-", "--json", data=path.read_bytes())
    assert code == 0
    found = json.loads(out)
    expected = Counter((p.set, raw.descriptor) for p in packets(path.read_bytes()) for raw in p)
    assert {(f["set"], f["descriptor"]): f["count"] for f in found["fields"]} == expected
    assert found["clock"] == "gps" and found["bytes"] == path.stat().st_size
    assert found["skipped"]["damaged"] == 2 and found["skipped"]["nmea"] == 1
    assert [s["name"] for s in found["sets"]] == ["sensor", "filter_data", "gnss_1"]


def test_gaps_and_jumps(tmp_path: Path) -> None:
    times = [i * 0.01 for i in range(500)]
    del times[200:230], times[400]
    times[300:] = [t - 1000.0 + 1000.5 for t in times[300:]]
    back = [*times[:100], *(t - 0.25 for t in times[100:])]
    (tmp_path / "gaps").write_bytes(b"".join(stamped(t) for t in times))
    (tmp_path / "back").write_bytes(b"".join(stamped(t) for t in back))
    lines = mip("info", tmp_path / "gaps")[1].splitlines()
    assert float(lines[5].split()[-1]) == pytest.approx(100, rel=1e-3)
    (at,) = (i for i, line in enumerate(lines) if line.startswith("sensor: 3 gaps, "))
    assert lines[at].startswith("sensor: 3 gaps, 0.810 s are missing") and len(lines) == at + 4
    size = len(stamped(0))
    assert lines[at + 1] == f"  +0.31 s before 2024-01-06T23:59:44.300Z, byte {200 * size}"
    lines = mip("info", tmp_path / "back")[1].splitlines()
    assert "sensor: time goes back 1 time:" in lines
    assert any(line.startswith("  -0.24 s before ") and line.endswith(f"byte {100 * size}") for line in lines)


def test_memory_is_bounded() -> None:
    """A hundred megabytes in a pipe: noise that looks like packets, packets, zeros."""
    block = b"\x75\x65\x01\xff" * 1000 + log(0.2) + bytes(1 << 20)
    code = """
import re, sys
from mip_tools.__main__ import main
code = main(["info", "-"])
(most,) = re.findall(r"VmHWM:\\s+(\\d+) kB", open("/proc/self/status").read())
sys.exit(code or (int(most) > 80_000 and f"{most} kB"))
"""
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    with subprocess.Popen([sys.executable, "-c", code], env=ENVIRONMENT, **pipes) as process:
        assert process.stdin is not None and process.stdout is not None and process.stderr is not None
        for _ in range(100):
            process.stdin.write(block)
        process.stdin.close()
        assert b"standard input: 105 MB, " in process.stdout.read()
        assert process.stderr.read() == b"" and process.wait(PATIENCE) == 0


# --------------------------------------------------------------------------- cut


def test_by_time(path: Path, tmp_path: Path) -> None:
    def cut(*words: str) -> list[Packet]:
        assert mip("cut", path, "-o", tmp_path / "part", *words)[0] == 0
        return packets((tmp_path / "part").read_bytes())

    def seconds(found: list[Packet]) -> list[float]:
        return [t.tow for p in found if p.set == 0x80 and (t := shared.GpsTimestamp.find(p))]

    start = seconds(packets(log()))[0]
    whole = cut("--begin", "1", "--end", "2.5")
    assert seconds(whole)[0] == pytest.approx(start + 1) and seconds(whole)[-1] == pytest.approx(start + 2.49)
    assert cut("--end", "1") + whole + cut("--begin", "0:02.5") == packets(log())
    utc = cut("--begin", "2024-01-06T23:59:43", "--end", "2024-01-06T23:59:44Z")
    assert seconds(utc)[0] == pytest.approx(1.0) and seconds(utc)[-1] == pytest.approx(1.99)


@pytest.mark.parametrize(
    ("words", "code", "error"),
    [
        ("--begin 3 --end 1", 2, "--begin is after --end\n"),
        ("--begin 2024-01-06T23:59:44 --end 2024-01-06T23:59:43", 2, "--begin is after --end\n"),
        ("--begin 100", 1, "the part has no packets; log.bin lasts 3.99 s\n"),
        ("--begin 1 --end 1", 1, "the part has no packets; log.bin lasts 3.99 s\n"),
        ("--end 2000-01-01", 1, "log.bin begins at 2024-01-06T23:59:42.41Z and lasts 3.99 s\n"),
        ("--only gnss_2", 1, "the part has no packets; log.bin has only other fields there; `mip info` lists them\n"),
    ],
)
def test_a_part_is_not_empty(words: str, code: int, error: str, path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An older file of this name is kept."""
    monkeypatch.chdir(path.parent)
    Path("part").write_bytes(b"older")
    found = mip("cut", "log.bin", "-o", "part", *words.split())
    assert found[:2] == (code, "") and found[2].endswith(error) and "mip cut: " in found[2]
    assert Path("part").read_bytes() == b"older"


def test_fields_are_taken_out(path: Path) -> None:
    code, _, _ = mip("cut", path, "-o", path.with_name("part"), "--only", "sensor", "--without", "shared,scaled_mag")
    found = packets(path.with_name("part").read_bytes())
    assert code == 0 and {(p.set, raw.descriptor) for p in found for raw in p} == {(0x80, 0x04), (0x80, 0x05)}
    kept = [sensor.ScaledAccel.find(p) for p in found]
    assert kept == [sensor.ScaledAccel.find(p) for p in packets(log()) if p.set == 0x80]


# --------------------------------------------------------------------------- export


def table(out: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(out)))


def test_times_of_a_set_without_its_own(tmp_path: Path) -> None:
    bare = bytes(PacketBuilder(0x80).add(0x04, sensor.ScaledAccel((1.0, 2.0, 3.0)).encode()).build())
    (tmp_path / "log").write_bytes(bare + stamped(5.5) + bare + stamped(6.5, flags=1) + bare)
    for how, name, first in (
        ("utc", "time", "2024-01-06T23:59:47.500000000Z"), ("unix", "time [s]", "1704585587.5"),
        ("start", "time_device [s]", "0.0"),
    ):  # fmt: skip
        rows = table(mip("export", tmp_path / "log", "sensor.scaled_accel", "--time", how, "-o", "-")[1])
        times = [(r[name], r["time_own"]) for r in rows]
        later = "1.0" if how == "start" else ""
        assert times == [("", "false"), (first, "true"), (first, "false"), (later, "true"), (later, "false")]
    rows = table(mip("export", tmp_path / "log", "sensor.scaled_accel", "--time", "none", "-o", "-")[1])
    assert "time" not in rows[0]


def test_values_that_are_not_valid(tmp_path: Path) -> None:
    (tmp_path / "log").write_bytes(stamped(1.5) + stamped(2.5, flags=1) + stamped(3.5, flags=0))
    words = ("export", tmp_path / "log", "gps_timestamp", "--time", "none", "-o", "-")
    kept = [("1.5", "2296", "3"), ("2.5", "2296", "1"), ("3.5", "2296", "0")]
    assert [tuple(r.values()) for r in table(mip(*words)[1])] == kept
    masked = [("1.5", "2296", "3"), ("2.5", "", "1"), ("", "", "0")]
    assert [tuple(r.values()) for r in table(mip(*words, "--invalid", "mask")[1])] == masked
    assert [tuple(r.values()) for r in table(mip(*words, "--invalid", "drop")[1])] == kept[:1]
    lines = mip(*words, "--invalid", "mask", "--format", "jsonl")[1].splitlines()
    assert json.loads(lines[1]) == {"tow": 2.5, "valid_flags": 1}


def test_json_lines(path: Path) -> None:
    words = ("export", path, "-o", "-", "--format", "jsonl", "--names", "--by", "packet", "--position")
    out = mip(*words)[1].splitlines()
    expected = packets(log())
    assert len(out) == len(expected)
    data = path.read_bytes()
    for number, (line, packet) in enumerate(zip(out, expected, strict=True)):
        found = json.loads(line)
        assert (found["packet"], found["set"]) == (number, packet.set)
        assert data[found["offset"] :][: len(packet)] == bytes(packet)
        if accel := sensor.ScaledAccel.find(packet):
            vector = tuple(found[f"sensor.scaled_accel.{axis}"] for axis in "xyz")
            assert sensor.ScaledAccel(vector).encode() == accel.encode()
        if status := filter_data.Status.find(packet):
            assert found["filter_data.status.filter_state"] == status.to_dict(device=DEVICE)["filter_state"]


def test_any_field_can_be_exported(tmp_path: Path) -> None:
    """Lists, unions, structures and text have a place in all formats, whatever is in them."""
    rng = random.Random(1)
    data, count = b"", 0
    for number, kind in registry.all_types():
        for _ in range(rounds(1, 10)):
            raw = bytes(rng.choice((0, 1, 2, rng.randrange(256))) for _ in range(rng.randrange(200)))
            builder = PacketBuilder(number if 0 < number < 0xFF else 0x80).add(kind.DESCRIPTOR, raw)
            packet = builder.build()
            data += bytes(packet)
            count += sum(not isinstance(f, tuple) for f in registry.decode_packet(packet))
    (tmp_path / "log").write_bytes(data)
    for form, more in (("csv", ["--names"]), ("jsonl", []), ("parquet", [])):
        out = tmp_path / f"t.{form}"
        words = ["export", tmp_path / "log", *map(str, range(1, 255)), "-o", out, "--invalid", "mask", *more]
        code, printed, error = mip(*words)
        assert (code, printed) == (0, "")
        assert re.fullmatch(
            r"(mip export: .*recognized\)\n)?(mip export: .*no date: .*\n)?", error
        )  # what is in it decides whether any time is a date
        if form == "jsonl":
            assert len([json.loads(line) for line in out.read_text().splitlines()]) == count > 200
        elif form == "csv":
            rows = list(csv.reader(io.StringIO(out.read_text())))
            assert len(rows) == count + 1 and len({len(row) for row in rows}) == 1
        elif form == "parquet":
            assert pq.read_table(out).num_rows == count


ANSWERS = bytes(base.Ping().packet()) + bytes.fromhex("7565010404f10100d56a")


@pytest.mark.parametrize("form", ["csv", "parquet", pytest.param("mcap", marks=heavy("mcap"))])
def test_a_log_of_commands_and_answers_is_not_exported_in_silence(form: str, tmp_path: Path) -> None:
    log = tmp_path / "log.bin"
    log.write_bytes(ANSWERS)
    what = "no data (commands and replies must be named); `mip info` lists its fields"
    assert mip("export", log, "-o", tmp_path / f"t.{form}") == (1, "", f"mip export: {log} has {what}\n")


@pytest.mark.parametrize("form", ["jsonl", "csv", pytest.param("mcap", marks=heavy("mcap"))])
def test_a_pipe_without_the_fields_is_not_exported_in_silence(form: str, tmp_path: Path) -> None:
    out = tmp_path / f"t.{form}"
    said = "mip export: - has none of these fields; `mip info` lists its fields\n"
    assert mip("export", "-", "gnss_1", "-o", out, data=stamped(1)) == (1, "", said)
    assert not out.exists()


@pytest.mark.parametrize("form", ["csv", "parquet"])
def test_commands_and_answers_are_exported_if_they_are_named(form: str, path: Path, tmp_path: Path) -> None:
    """A recording may have them, between the data that its user wants."""
    plain, mixed = tmp_path / "plain.bin", tmp_path / "mixed.bin"
    plain.write_bytes(log(0.5))
    mixed.write_bytes(log(0.5) + ANSWERS)
    out = [tmp_path / f"{x.stem}.{form}" for x in (plain, mixed)]
    for source, target in zip((plain, mixed), out):
        assert mip("export", source, "-o", target) == (0, "", "")
    assert out[0].read_bytes() == out[1].read_bytes()
    for names in (["acknowledge"], ["base"], ["--only", "0x01"]):
        assert mip("export", mixed, *names, "-o", out[1]) == (0, "", ""), names
        assert out[1].read_bytes() != out[0].read_bytes()


WITHOUT_PACKETS = {
    "csv": "export LOG --format csv -o OUT",
    "mcap": pytest.param("export LOG --format mcap -o OUT", marks=heavy("mcap")),
    "plot": pytest.param("plot LOG sensor.scaled_accel -o OUT.png", marks=heavy("matplotlib")),
    "part": "cut LOG --begin 1 -o OUT",
    "fields": "cut LOG --only sensor -o OUT",
    "stream": "stream LOG -o OUT",
    "columns": "stream LOG --format csv -o OUT",
    "monitor": "monitor LOG",
    "noise": "noise LOG",
    "magnetometer": "calibrate-mag LOG",
    "pipe": "export - --format jsonl -o OUT",
    "cut pipe": "cut - -o OUT",
}


@pytest.mark.parametrize("words", WITHOUT_PACKETS.values(), ids=WITHOUT_PACKETS)
def test_a_log_without_packets(words: str, tmp_path: Path) -> None:
    """Whatever is to be done with it, what it is comes before what it lacks."""
    path = tmp_path / "log.bin"
    path.write_bytes(b"no MIP")
    made = words.replace("LOG", str(path)).replace("OUT", str(tmp_path / "out"))
    code, out, error = mip(*made.split(), data=path.read_bytes())
    assert code == 1 and (out == "" or words.startswith("monitor")), out
    name = "standard input" if " - " in words else path
    assert f" {name} has no packets: neither MIP nor a known protocol" in error, error
    assert list(tmp_path.iterdir()) == [path]


# --------------------------------------------------------------------------- whole files, or none


def test_nothing_half_written(path: Path, tmp_path: Path) -> None:
    target = tmp_path / "out.csv"
    target.write_text("mine")
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    abandoned, other = (tmp_path / f"out.csv.{number}.part" for number in (gone.pid, os.getpid()))
    for part in (abandoned, other):  # by a killed run, by one that still writes
        part.touch()
    big = tmp_path / "big"
    big.write_bytes(log() * 200)
    with running("export", big, "-o", target) as process:
        until(lambda: any(p.stat().st_size for p in tmp_path.glob("out.csv.*.part")), process)
        process.send_signal(signal.SIGINT)
        out, error = process.communicate(timeout=PATIENCE)
        assert (process.returncode, out, error) == (130, b"", b"")
    assert target.read_text() == "mine" and set(tmp_path.glob("*.part")) == {other}


@pytest.mark.parametrize("name", ["log.bin", "./log.bin", "link", "hard"])
def test_no_log_is_replaced_by_what_is_made_of_it(name: str, path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = path.read_bytes()
    path.with_name("link").symlink_to("log.bin")
    path.with_name("hard").hardlink_to(path)
    out = f"{path.parent}/{name}"
    for words in (["cut"], ["cut", "--begin", "1"], ["export", "--format", "csv"], ["export", "--format", "jsonl"]):
        for source, output in ((path, out), (out, path)):
            code, said, error = run(capsys, words[0], source, "-o", output, *words[1:])
            wanted = f"mip {words[0]}: {output} is the log itself; name another file\n"
            assert (code, said, error) == (2, "", wanted)
    assert path.read_bytes() == before


def test_no_log_is_replaced_under_other_conditions(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = path.read_bytes()
    with path.open("rb") as file:
        done = subprocess.run(command("cut", "-", "-o", path), stdin=file, capture_output=True, env=ENVIRONMENT)
    assert done.returncode == 2 and b"is the log itself" in done.stderr
    with path.open("ab") as file:
        done = subprocess.run(command("cut", path, "-o", "-"), stdout=file, stderr=subprocess.PIPE, env=ENVIRONMENT)
    assert done.returncode == 2 and b"standard output is the log itself" in done.stderr
    words = ("simulate", "3dm-gx5-15", "--duration", 1, "--motion", f"replay:file={path}", "--fault-log", path)
    code, _, error = run(capsys, *words)
    assert code == 2 and "is the log itself" in error
    assert path.read_bytes() == before
    assert run(capsys, "export", path, "-o", "/dev/null", "--format", "csv")[0] == 0


def test_what_is_in_several_logs(tmp_path: Path) -> None:
    """Each has its report; one without packets sets the exit status, whatever its place."""
    paths = [tmp_path / name for name in ("a.bin", "none.bin", "b.bin")]
    for path, count in zip(paths, (3, 0, 5)):
        path.write_bytes(bytes(base.Ping().packet()) * count)
    for order, reports in ((paths, ["3 packets", "0 packets", "5 packets"]), (paths[:2], ["3 packets", "0 packets"])):
        code, out, error = mip("info", *order)
        assert code == 1 and error.startswith(f"mip info: {paths[1]} has no packets")
        assert [text.partition(", ")[2].splitlines()[0] for text in out.split("\n\n") if ".bin: " in text] == reports
    code, out, _ = mip("info", paths[0], paths[2], "--json")
    assert code == 0 and [json.loads(line)["file"] for line in out.splitlines()] == [str(paths[0]), str(paths[2])]
    assert mip("info", paths[0], tmp_path / "missing.bin")[0] == 1


def test_a_recording_that_has_appeared_meanwhile_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "log.bin"
    with (
        pytest.raises(Failure, match="has appeared meanwhile; the bytes are in "),
        outputs.whole(str(path), keep=True, replace=False) as file,
    ):
        file.write(b"mine")
        path.write_bytes(b"theirs")
    (part,) = tmp_path.glob("*.part")
    assert (part.read_bytes(), path.read_bytes()) == (b"mine", b"theirs")


@pytest.mark.parametrize("keep", [True, False])
def test_an_error_keeps_only_recordings(keep: bool, tmp_path: Path) -> None:
    path = tmp_path / "log.bin"
    for data in (b"", b"all"):
        with pytest.raises(Failure, match="timed out"), outputs.whole(str(path), keep=keep) as file:
            file.write(data)
            raise Failure("timed out", 4)
        kept = [path] if keep and data else []
        assert list(tmp_path.iterdir()) == kept and all(each.read_bytes() == data for each in kept)


@pytest.mark.parametrize("keep", [True, False])
def test_an_interrupt_at_any_moment(keep: bool, tmp_path: Path) -> None:
    """Each time in another line of the code that opens, closes and names the file: it is complete or absent."""
    path = tmp_path / "log.bin"
    left = at = 0

    def interrupt(frame: Any, event: str, argument: Any) -> Any:
        nonlocal left
        if not frame.f_code.co_filename.endswith(("outputs.py", "contextlib.py", "signals.py")):
            return None
        left -= 1
        if left == 0:
            signal.raise_signal(signal.SIGINT)
        return interrupt

    def write() -> None:
        with outputs.whole(str(path), keep=keep) as file:
            file.write(b"all")

    before = sys.gettrace()
    while left <= 0:
        at += 1
        left = at
        sys.settrace(interrupt)
        try:
            write()
        except KeyboardInterrupt:  # not `suppress`, which would be interrupted, too
            pass
        finally:
            sys.settrace(before)
        assert list(tmp_path.iterdir()) == [path] * path.exists(), at
        if path.exists():
            assert path.read_bytes() == b"all", at
            path.unlink()
    assert at > 50
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_names_of_any_length(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("x" * 251 + ".csv", "ä" * 125 + ".csv"):
        assert run(capsys, "export", path, "-o", path.with_name(name)) == (0, "", "")
        assert path.with_name(name).stat().st_size > 1000
    for name, reason in (
        ("x" * 252 + ".csv", "File name too long"),
        ("log.bin/x.csv", "Not a directory"),
        ("no/x.csv", "No such file or directory"),
    ):
        out = f"{path.parent}/{name}"
        assert run(capsys, "export", path, "-o", out) == (1, "", f"mip export: {out} cannot be written: {reason}\n")
    assert run(capsys, "export", path, "-o", "") == (2, "", "mip export: the name of the output file is empty\n")
    assert "is a folder" in run(capsys, "export", path, "--format", "csv", "-o", f"{path.parent}/new/")[2]
    assert len(list(path.parent.iterdir())) == 3


def test_an_output_that_is_a_link_or_has_permissions(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The target of a link is written, even if it does not exist yet; an older file keeps its permissions."""
    (path.parent / "folder").mkdir()
    target, link = path.parent / "folder/real.csv", path.with_name("link.csv")
    link.symlink_to("folder/real.csv")
    for _ in range(2):
        assert run(capsys, "export", path, "-o", link) == (0, "", "")
        assert link.is_symlink() and target.stat().st_size > 1000
        target.write_text("older")
        target.chmod(0o600)
    assert run(capsys, "export", path, "-o", link) == (0, "", "")
    assert target.stat().st_mode & 0o777 == 0o600 and target.stat().st_size > 1000
    assert [p.name for p in target.parent.iterdir()] == ["real.csv"]
    loop = path.with_name("loop.csv")
    loop.symlink_to("loop.csv")
    code, _, error = run(capsys, "export", path, "-o", loop)
    assert code == 1 and "cannot be written: Too many levels of symbolic links" in error


def test_the_name_of_standard_output(path: Path) -> None:
    """What is in the file already is kept."""
    out = path.with_name("all.csv")
    out.write_bytes(b"before\n")
    link = path.with_name("stdout.csv")
    link.symlink_to("/dev/stdout")
    words = command("export", path, "sensor.scaled_accel", "-o", link)
    with out.open("ab") as file:
        assert subprocess.run(words, stdout=file, env=ENVIRONMENT).returncode == 0
    piped = subprocess.run(words, stdout=subprocess.PIPE, env=ENVIRONMENT).stdout
    assert out.read_bytes() == b"before\n" + piped and len(piped) > 1000
    assert link.is_symlink()


def test_a_full_disk(path: Path, tmp_path: Path) -> None:
    for words in (["export", path, "-o", tmp_path / "o.csv"], ["cut", path, "-o", tmp_path / "o.bin"]):
        code, error = on_a_full_disk(10_000, *words)
        assert code == 1 and b"cannot be written: File too large" in error
        assert error.count(b"\n") == 1 and [p.name for p in tmp_path.iterdir()] == ["log.bin"]


def test_an_output_that_accepts_nothing(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One line, and no traceback."""
    for words in (["fields"], ["cut", path, "-o", "-"]):
        with open("/dev/full", "wb") as full:
            done = subprocess.run(command(*words), stdout=full, stderr=subprocess.PIPE, env=ENVIRONMENT)
        error = f"mip {words[0]}: standard output cannot be written: No space left on device\n"
        assert (done.returncode, done.stderr.decode()) == (1, error), words
    error = "mip cut: /dev/full cannot be written: No space left on device\n"
    assert run(capsys, "cut", path, "-o", "/dev/full") == (1, "", error)


# --------------------------------------------------------------------------- extras and plots


@pytest.mark.parametrize("form", ["csv", "jsonl", "parquet"])
def test_no_export_imports_pandas(form: str, path: Path) -> None:
    """`pyarrow.array` does so where pandas is installed, which takes longer than most exports."""
    program = "import sys; from mip_tools.__main__ import main; main(sys.argv[1:]); sys.exit('pandas' in sys.modules)"
    words = ["export", path, "-o", path.with_suffix(f".{form}"), "--names"]
    assert subprocess.run([sys.executable, "-c", program, *words], env=ENVIRONMENT).returncode == 0


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ("export {}/log.bin -o {}/t.parquet", "export: numpy is missing; pip install numpy"),
        ("plot {}/log.bin sensor -o {}/t.png", "plot: matplotlib is missing; pip install matplotlib"),
    ],
)
def test_missing_extras(words: str, error: str, path: Path) -> None:
    code, out, said = mip(*words.replace("{}", str(path.parent)).split(), extras=False)
    assert (code, out) == (1, "") and said.startswith(f"mip {error}") and said.count("\n") == 1
    assert [p.name for p in path.parent.iterdir()] == ["log.bin"]


def test_a_picture(path: Path, tmp_path: Path) -> None:
    words = ("sensor.scaled_accel", "filter_data.llh_position.ellipsoid_height")
    assert mip("plot", path, *words, "-o", tmp_path / "t.png") == (0, "", "")
    red, green, blue, _ = np.moveaxis(pyplot.imread(tmp_path / "t.png"), 2, 0)
    assert red.shape[1] == 1200
    # The first three colours of matplotlib, perhaps blended with white; blue is also the second diagram.
    for more, less in ((blue, red), (red, blue), (green, np.maximum(red, blue))):
        assert (more - less > 0.24).any()
    assert mip("plot", path, "sensor.scaled_accel.z", "--together", "-o", tmp_path / "t.svg")[0] == 0
    text = (tmp_path / "t.svg").read_text()
    assert text.startswith("<?xml") and text.count("#2ca02c") == 0
