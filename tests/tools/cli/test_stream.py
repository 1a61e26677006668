"""`mip stream`, pipes that are not held back, and ports that stay silent: at a virtual device on TCP."""

from __future__ import annotations

import csv
import io
import json
import re
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator
from datetime import datetime, timedelta, timezone
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from mip_protocol import PacketBuilder
from mip_tools.errors import Failure
from mip_tools.logs.scan import Piece, Scanner
from mip_tools.monitor.latest import Latest
from mip_tools.names.selection import Selection
from mip_tools.ports import silence
from program import ENVIRONMENT, PATIENCE, command, log, mip, running, simulated
from support import heavy, later

#: What is said of a device at a port. On a busy machine, its data comes late.
TOLD = re.compile(r"mip stream: device 3DM-.* \(at the port\)\n(mip stream: no data for .*\n)*")


@pytest.fixture(scope="module")
def place() -> Iterator[str]:
    """A device that is told to stream by the tests."""
    with simulated() as found:
        yield found


def lines(text: str) -> list[dict[str, Any]]:
    return [json.loads(line) for line in text.splitlines()]


def test_fields_at_rates(place: str) -> None:
    words = ("sensor.scaled_accel", "sensor.scaled_gyro@50", "reference_timestamp")
    code, out, error = mip("stream", place, *words, "--rate", "100", "--packets", "20")
    assert code == 0 and TOLD.fullmatch(error)
    found = lines(out)
    assert all({"sensor.scaled_accel.x", "shared.reference_timestamp.nanoseconds"} <= one.keys() for one in found)
    # In device time: each row 10 ms after the last, and the gyroscope in every second one.
    times = [float(one["time_device"]) for one in found]
    assert len(found) == 20 and [round(b - a, 6) for a, b in pairwise(times)] == [0.01] * 19
    assert sum("sensor.scaled_gyro.x" in one for one in found) == 10


def test_a_time_comes_along(place: str) -> None:
    """Data is streamed with the time of a clock that is always valid, although nobody has requested it."""
    words = ("stream", place, "sensor.scaled_accel@50", "--packets", "3")
    code, out, error = mip(*words, "--format", "csv")
    assert code == 0 and TOLD.fullmatch(error)
    head, *rows = csv.reader(io.StringIO(out))
    assert head[:4] == ["time_device [s]", "time_own", "time_host", "scaled_accel.x [g]"] and len(head) == 6
    hosts = [datetime.fromisoformat(row[2][:26]) for row in rows]
    now = datetime.now(timezone.utc).replace(tzinfo=None)
    assert now - timedelta(minutes=5) < hosts[0] and hosts == sorted(hosts) and hosts[-1] < now
    assert [round(float(b[0]) - float(a[0]), 6) for a, b in pairwise(rows)] == [0.02] * 2
    code, out, _ = mip(*words, "--time", "utc")
    assert code == 0 and all(one["time"].endswith("Z") and one["time_own"] for one in lines(out))
    code, out, _ = mip(*words, "--time", "none")
    assert code == 0 and not any("time" in one for one in lines(out))


def test_a_time_of_an_older_device() -> None:
    """It has no reference clock, and another field for the time of GPS."""
    with simulated(device="3dm-gx5-45") as place:
        code, out, error = mip("stream", place, "sensor.scaled_accel@50", "--packets", "2")
    assert code == 0 and TOLD.fullmatch(error) and all(one["time_own"] for one in lines(out))


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["sensor.scaled_accel", "--rate", "333"], "sensor cannot be started: sensor.scaled_accel at 333 Hz"),
        (["base.ping@10"], "base.ping is not a data field, and only these have a rate"),
        (["sensor.scaled_accel@x"], "'x' is not a rate in Hz"),
        (["--rate", "10"], "--rate needs fields;"),
        (["reference_timestamp@10"], "a shared field is sent in the packets of other fields; add one of a data set"),
        (["dop@1"], "'dop' is in several sets; write gnss_data.dop or"),
    ],
)
def test_what_cannot_be(words: list[str], error: str, place: str) -> None:
    code, out, said = mip("stream", place, *words)
    assert code in (1, 2) and out == "" and error in said


@pytest.mark.parametrize(
    ("device", "words", "error"),
    [
        ("3dm-cv7-ahrs", ["stream", "filter_data.status@10", "filter_data.llh_position@10"],
         "filter_data cannot be started: 3dm.message_format rejected (invalid parameter): 3DM-CV7-AHRS does not send"
         " filter_data.llh_position"),
        ("3dm-cv7-ar", ["stream", "gnss_1.llh_position@1"],
         "gnss_1 cannot be started: 3dm.get_base_rate rejected (invalid parameter): 3DM-CV7-AR has no GNSS receiver"),
        ("3dm-gx5-15", ["stream", "sensor.scaled_accel@10", "sensor.scaled_mag@10"],
         "sensor cannot be started: 3dm.imu_message_format rejected (invalid parameter):"
         " 3DM-GX5-15 has no magnetometer"),
        ("3dm-gx5-15", ["stream", "gnss_data.llh_position@1"],
         "gnss_data cannot be started: 3dm.get_base_rate rejected (unknown command): 3DM-GX5-15 has no GNSS receiver"),
        ("3dm-cv7-ahrs", ["send", "3dm.message_format", "write", "sensor", "scaled_accel:0"],
         "3dm.message_format rejected (invalid parameter): the decimation of sensor.scaled_accel is 0"),
        ("3dm-cv7-ar", ["send", "3dm.poll_data", "gnss_1", "no", "0x03"],
         "3dm.poll_data rejected (invalid parameter): 3DM-CV7-AR has no GNSS receiver"),
    ],
)  # fmt: skip
def test_which_field_a_device_rejects(device: str, words: list[str], error: str) -> None:
    name, *more = words
    with simulated(device=device) as found:
        assert mip(name, found, *more) == (3, "", f"mip {name}: {error}\n")


def test_a_set_at_a_rate_of_its_own() -> None:
    """It has no message format, so its fields cannot be started."""
    with simulated(device="demod-dc") as place:
        code, out, error = mip("stream", place, "displacement_data.displacement@100", "--packets", "3")
        assert code == 0 and [one["displacement"] for one in lines(out)] == [12.5] * 3
        assert error.startswith("mip stream: DEMOD-DC sends displacement_data at a rate of its own\n")


@pytest.mark.parametrize(
    ("name", "more"),
    [("record", ()), ("stream", ()), pytest.param("stream", ("--format", "mcap"), marks=heavy("mcap"))],
)
def test_a_lost_port_is_opened_again(name: str, more: tuple[str, ...], tmp_path: Path) -> None:
    """The time without it is reported, and nothing that arrived is lost, not even a part of a packet."""
    data, output = log(0.5), tmp_path / "output"
    server = socket.create_server(("127.0.0.1", 0))
    place = "{0[0]}:{0[1]}".format(server.getsockname())

    def serve() -> None:
        for part in (data[:77], data[77:1000], data[1000:]):
            client, _ = server.accept()
            with client:
                client.sendall(part)

    threading.Thread(target=serve, daemon=True).start()
    with server:
        words = (name, place, "--reopen", "--device", "3dm-cv7-gnss-ins", "-o", output, "--duration", "3", *more)
        code, _, error = mip(*words)
    lost = rf"mip {name}: {place} was lost for \d\.\d s, until [\d:]+\n"
    assert code == 0 and re.match(f"({lost}){{2}}", error), error
    if name == "record":
        assert output.read_bytes() == data
    elif more:
        with open(output, "rb") as file:
            found = [*later("mcap.reader").make_reader(file).iter_messages(log_time_order=False)]
        gaps = [i for i, (_, channel, _) in enumerate(found) if channel.topic == "/mip/gap"]
        assert len(gaps) == 2 and all(json.loads(found[i][2].data)["seconds"] > 0 for i in gaps)
        assert all(found[i][2].log_time == found[i + 1][2].log_time for i in gaps)
    else:
        written = lines(output.read_text())
        assert len(written) == len(lines(mip("stream", "-", data=data)[1]))
        assert len([line for line in written if line.get("gap", 0) > 0]) == 2


@pytest.mark.parametrize("name", ["record", "stream"])
def test_a_lost_port_is_not_waited_for_longer_than_the_time_out(name: str, tmp_path: Path) -> None:
    data, output = log(0.5), tmp_path / "output"
    server = socket.create_server(("127.0.0.1", 0))
    place = "{0[0]}:{0[1]}".format(server.getsockname())

    def serve() -> None:
        client, _ = server.accept()
        server.close()
        with client:
            client.sendall(data)

    threading.Thread(target=serve, daemon=True).start()
    words = ("--reopen", "--timeout", "1", "--duration", str(PATIENCE), "--device", "3dm-cv7-gnss-ins")
    code, _, error = mip(name, place, "-o", output, *words)
    assert (code, error) == (4, f"mip {name}: {place} was lost, and is not back after 1 s\n")
    assert output.read_bytes() == data if name == "record" else lines(output.read_text())


def test_a_log_has_no_rates(tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(log(0.5))
    assert mip("stream", path, "sensor.scaled_accel@10")[0] == 2
    code, out, _ = mip("stream", path, "sensor.scaled_accel")
    assert code == 0 and out == mip("export", path, "sensor.scaled_accel", "--format", "jsonl", "-o", "-")[1]


def test_it_ends_cleanly(place: str) -> None:
    """By Ctrl-C, and when the reader stops."""
    words = ("stream", place, "sensor.scaled_accel@100")
    with running(*words) as process:
        assert process.stdout is not None and process.stderr is not None
        assert b"scaled_accel" in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        rest, error = process.communicate(timeout=PATIENCE)
        assert process.returncode == 0 and (not error or TOLD.fullmatch(error.decode().rstrip("\n") + "\n"))
        assert not rest or rest.endswith(b"\n")
    with running(*words) as process:
        assert process.stdout is not None and process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert process.wait(PATIENCE) == 141 and TOLD.fullmatch(process.stderr.read().decode())


@pytest.mark.parametrize(
    "words", [("export", "-", "--format", "jsonl", "-o", "-"), ("dump", "-", "--json"), ("stream", "-")]
)
def test_a_pipe_is_not_held_back(words: tuple[str, ...]) -> None:
    """Lines are written while the pipe is open, a moment after their packets."""
    process = subprocess.Popen(
        command(*words), stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=ENVIRONMENT
    )
    assert process.stdin is not None and process.stdout is not None
    data = log(1.0)
    try:
        for part in (data[:2000], data[2000:4000]):
            process.stdin.write(part)
            process.stdin.flush()
            time.sleep(0.7)  # in total, longer than the preview
        process.stdin.write(data[4000:5000])
        process.stdin.flush()
        assert json.loads(process.stdout.readline())
        process.stdin.close()
        assert process.wait(PATIENCE) == 0
    finally:
        process.kill()
        process.wait()


def test_packets_as_json(tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(b"$GPGGA\r\n" + log(0.5))
    code, out, _ = mip("dump", path, "--json", "--skipped", "--raw", "--count", "2")
    first, second, _ = lines(out)
    assert code == 0 and first == {"offset": 0, "skipped": b"$GPGGA\r\n".hex()}
    assert second["set"] == "sensor" and second["offset"] == 8 and second["raw"].startswith("756580")
    assert {f["field"] for f in second["fields"]} >= {"sensor.scaled_accel", "shared.gps_timestamp"}
    assert set(second["fields"][1]["values"]["scaled_accel"]) == {"x", "y", "z"}


@pytest.mark.parametrize("words", [("stream",), ("dump",), ("monitor",), ("record", "-o", "-")])
def test_a_silent_port(words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    """The possible cause is reported once, and the command ends if `--timeout` says so."""
    monkeypatch.setattr(silence, "PATIENCE", 0.2)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        where = f"127.0.0.1:{silent.getsockname()[1]}"
        code, _, error = mip(words[0], where, *words[1:], "--timeout", "3")
    cause = f"the device is idle, or the stream is off: `mip send {where} base.resume`\n"
    assert code == 4
    assert error == f"mip {words[0]}: no data for 0.2 s: {cause}mip {words[0]}: {where}: no data for 3 s: {cause}"


@pytest.mark.parametrize("name", ["record", "stream"])
@pytest.mark.parametrize("closes", [True, False])
def test_what_came_before_the_end_is_kept(name: str, closes: bool, tmp_path: Path) -> None:
    """The port closes, or the device falls silent."""
    data, output = log(0.5), tmp_path / "output"
    server = socket.create_server(("127.0.0.1", 0))
    place = "{0[0]}:{0[1]}".format(server.getsockname())
    done = threading.Event()

    def serve() -> None:
        client, _ = server.accept()
        with client:
            client.sendall(data)
            if not closes:
                done.wait(PATIENCE)

    threading.Thread(target=serve, daemon=True).start()
    with server:
        code, _, error = mip(name, place, "--device", "3dm-cv7-gnss-ins", "-o", output, "--timeout", "3")
        done.set()
    assert code == (1 if closes else 4) and ("was closed" if closes else "no data for 3 s") in error
    if name == "record":
        assert output.read_bytes() == data
    else:
        assert len(lines(output.read_text())) == len(lines(mip("stream", "-", data=data)[1]))
    assert list(tmp_path.iterdir()) == [output]


def test_noise_is_no_silence(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    now = 0.0
    monkeypatch.setattr(time, "monotonic", lambda: now)
    watch = silence.Silence(silence.Line("PORT", None, "stream", 10.0))
    said = "bytes arrive, but no packet for"
    while now < 9:
        now += 1
        watch.data(b"x")
        watch.check()
    assert capsys.readouterr().err.startswith(
        f"mip stream: {said} 2 s: neither MIP nor a known protocol; is the baud rate right?"
    )
    now = 10.0
    watch.data(b"x")
    with pytest.raises(Failure, match=f"^PORT: {said} 10 s"):
        watch.check()


@pytest.mark.parametrize(("timed", "rate"), [(True, "100 Hz"), (False, "50 Hz")])
def test_the_rate_that_monitor_shows_is_that_of_the_device(timed: bool, rate: str) -> None:
    """Packets may arrive in bursts; only without a time do arrivals count."""
    latest = Latest(Selection(["sensor.scaled_accel"]), None)
    packets = [p.packet for p in Scanner().feed(log(1.0)) if p.packet is not None and p.packet.set == 0x80]
    for i, packet in enumerate(packets):
        builder = PacketBuilder(packet.set)
        for raw in packet:
            if timed or raw.descriptor == 0x04:
                builder.add(raw.descriptor, raw.data)
        latest.add(Piece(0, b"", builder.build()), 0.1 * (i // 5) if timed else 0.02 * i)
    (one,) = latest.shown(0.02 * len(packets))
    assert (one.name, one.hertz, one.old) == ("scaled_accel", rate, "")
