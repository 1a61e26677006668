"""`mip send`, `record` and `monitor`: at a virtual device, on TCP and a terminal."""

from __future__ import annotations

import fcntl
import json
import os
import pty
import re
import select
import signal
import socket
import struct
import subprocess
import termios
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Thread
from types import SimpleNamespace
from typing import Any

import pytest
import support
from mip_protocol import Parser, base, mip_3dm, registry, types
from mip_protocol.field import Command, Structure
from mip_protocol.parameter import Parameter
from mip_tools.columns import read_log
from mip_tools.commands import ports
from mip_tools.names import typed
from mip_tools.ports import connection
from program import DEVICE, ENVIRONMENT, PATIENCE, command, log, mip, on_a_full_disk, run, running, simulated, until
from serial.tools import list_ports


@pytest.fixture(scope="module")
def place() -> Iterator[str]:
    """A device that streams accelerations at 100 Hz."""
    with simulated() as found:
        words = ("3dm.message_format", "write", "sensor", "gps_timestamp_shared:10,scaled_accel:10")
        assert mip("send", found, *words)[0] == 2  # no such field
        assert mip("send", found, *words[:3], "0xD3:10,scaled_accel:10") == (0, "acknowledged\n", "")
        assert mip("send", found, "3dm.data_stream_control", "write", "sensor", "on")[0] == 0
        yield found


# --------------------------------------------------------------------------- send


def test_an_answer(place: str) -> None:
    code, out, error = mip("send", place, "base.get_device_info", extras=False)
    assert (code, error) == (0, "") and "  model_name = '3DM-CV7-GNSS/INS'\n" in out
    assert mip("send", f"socket://{place}", "base.ping") == (0, "acknowledged\n", "")
    code, out, _ = mip("send", place, "message_format", "read", "descriptor_set=sensor", "--json")
    assert code == 0
    rates = [{"descriptor": "shared.gps_timestamp", "decimation": 10}, {"descriptor": "scaled_accel", "decimation": 10}]
    assert json.loads(out) == {
        "command": "3dm.message_format",
        "outcome": "acknowledged",
        "response": {"descriptor_set": "sensor", "descriptors": rates},
    }


def test_a_new_baud_rate_is_followed(tmp_path: Path) -> None:
    port = tmp_path / "port"
    with support.simulated("--pty", str(port), "--strict-baud", device=DEVICE):
        words = ("send", port, "base.comm_speed", "write", "1")
        assert mip(*words, "460800") == (0, "acknowledged; use --baud 460800 from now on\n", "")
        assert mip("send", port, "base.ping", "--baud", "460800") == (0, "acknowledged\n", "")
        for rate, now in (("115200", "460800"), ("460800", "115200")):
            assert json.loads(mip(*words, rate, "--baud", now, "--json")[1])["baud"] == int(rate)
        code, _, error = mip(*words[:-1], "9", "115200", "--baud", "460800")
        assert code == 3 and error == "mip send: base.comm_speed rejected (invalid parameter)\n"


def test_a_rejected_baud_rate_names_the_command_of_the_device() -> None:
    with simulated("--tcp", "0", device="3dm-gx5-25") as older:
        for words in (("read", "1"), ("write", "1", "460800")):
            code, _, error = mip("send", older, "base.comm_speed", *words)
            text = "base.comm_speed rejected (unknown command): 3DM-GX5-25 has 3dm.uart_baud_rate instead"
            assert (code, error) == (3, f"mip send: {text}\n")


def test_what_becomes_of_commands_is_in_the_exit_status(place: str) -> None:
    refused = "mip send: base.comm_speed rejected (invalid parameter)\n"
    assert mip("send", place, "base.comm_speed", "read", "9") == (3, "", refused)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        where = f"127.0.0.1:{silent.getsockname()[1]}"
        code, out, error = mip("send", where, "base.ping", "--timeout", "0.1")
    assert (code, out) == (4, "")
    assert error == f"mip send: {where} did not answer base.ping; check the port and --baud\n"
    code, _, error = mip("send", where, "base.ping")
    assert code == 1 and error == f"mip send: {where} cannot be opened: Connection refused\n"


def test_what_is_at_the_port_in_place_of_the_device(no_reply_comes: None) -> None:
    """Commands that wait for an answer say what arrives instead."""

    def sends_sentences(server: socket.socket) -> None:
        while True:
            with suppress(OSError):
                client, _ = server.accept()
                client.sendall(b"$GPZDA,,,,,,*48\r\n" * 9)
                kept.append(client)

    kept: list[socket.socket] = []
    server = socket.create_server(("127.0.0.1", 0))
    Thread(target=sends_sentences, args=(server,), daemon=True).start()
    where = f"127.0.0.1:{server.getsockname()[1]}"
    sent = "but sends NMEA sentences; enable MIP on the port, or use another port of the device"
    for words, asked in (
        (("send", where, "base.ping"), "base.ping"),
        (("stream", where, "sensor.scaled_accel@10"), "3dm.get_base_rate"),
        (("config", "pull", where), "base.ping"),
    ):
        assert mip(*words) == (4, "", f"mip {words[0]}: {where} did not answer {asked}, {sent}\n")
    assert mip("ports", where)[1].splitlines()[1].endswith("no reply, but NMEA sentences")


def test_ports_and_their_devices(place: str, monkeypatch: pytest.MonkeyPatch) -> None:
    code, out, error = mip("ports", place, "127.0.0.1:9")
    head, device, nothing = out.splitlines()
    assert (code, error) == (0, "") and head.split() == ["port", "model", "serial", "number", "firmware"]
    assert re.fullmatch(rf"{place} +3DM-CV7-GNSS/INS +\S+ +\d\.\d\.\d\d", device)
    assert nothing.endswith("Connection refused")

    def port(name: str, vendor: int | None, serial: str | None = None, location: str = "") -> SimpleNamespace:
        return SimpleNamespace(device=name, vid=vendor, serial_number=serial, location=location, description="a port")

    main, second = port("a", 0x199B, "1", "1-1:1.0"), port("b", 0x199B, "1", "1-1:1.2")
    known = [second, port("c", 0x1234, "1"), main, port("d", None)]
    monkeypatch.setattr(list_ports, "comports", lambda: known)
    rows = [line.split("  ")[0] + line.rsplit("  ", 1)[1] for line in mip("ports")[1].splitlines()[1:]]
    assert sorted(rows) == ["aNo such file or directory", "bNo such file or directory", "cnot asked", "dnot asked"]
    roles = [(one.name, one.role) for one in ports._system()]
    assert roles == [("d", ""), ("c", ""), ("a", "main"), ("b", "auxiliary")]
    monkeypatch.setattr(list_ports, "comports", list)
    assert mip("ports")[:2] == (1, "")


def test_a_serial_port_needs_an_extra() -> None:
    code, out, error = mip("send", "/dev/tty", "base.ping", extras=False)
    assert (code, out) == (1, "")
    assert error == "mip send: /dev/tty cannot be opened: pyserial is missing; pip install pyserial\n"


@pytest.mark.parametrize(
    ("words", "made"),
    [
        (["base.ping"], base.Ping()),
        (["ping"], base.Ping()),
        (
            ["3dm.message_format", "write", "sensor", "scaled_accel:10,0x05:0x14"],
            mip_3dm.MessageFormat.write(0x80, (types.DescriptorRate(4, 10), types.DescriptorRate(5, 20))),
        ),
        (
            ["3dm.message_format", "write", "0x80", '[{"descriptor": 4, "decimation": 10}]'],
            mip_3dm.MessageFormat.write(0x80, (types.DescriptorRate(4, 10),)),
        ),
        (
            ["3dm.message_format", "write", "filter_data", "gps_timestamp:10,ned_velocity:10"],  # not that of aiding
            mip_3dm.MessageFormat.write(0x82, (types.DescriptorRate(0xD3, 10), types.DescriptorRate(0x02, 10))),
        ),
        (
            ["3dm.message_format", "write", "filter_data", '[{"descriptor": "ned_velocity", "decimation": 10}]'],
            mip_3dm.MessageFormat.write(0x82, (types.DescriptorRate(0x02, 10),)),
        ),
        (["3dm.message_format", "READ", "descriptor_set=128"], mip_3dm.MessageFormat.read(0x80)),
        (["3dm.data_stream_control", "write", "128", "off"], mip_3dm.DataStreamControl.write(0x80, False)),
        (["3dm.pps_source_control", "write", "receiver_1"], mip_3dm.PpsSourceControl.write(mip_3dm.PpsSource(1))),
        (["3dm.pps_source_control", "write", "0xF0"], mip_3dm.PpsSourceControl.write(mip_3dm.PpsSource(0xF0))),
    ],
)
def test_bytes_without_a_device(words: list[str], made: Command, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(capsys, "send", "--hex", *words) == (0, bytes(made.packet()).hex(" ") + "\n", "")


def test_every_command_and_function_can_be_typed() -> None:
    """`send` accepts what `fields` lists for a command, with the values of a decoded one."""
    count = 0
    for _, kind in registry.all_types():
        if not issubclass(kind, Command):
            continue
        for function in typed.constructor_functions(kind) or [""]:
            wanted = [name for name in typed.value_names(kind, function) if not name.startswith("[")]
            words = [f"{name}={_typed(kind, name)}" for name in wanted]
            made = typed.command(kind, [function, *words] if function else words)
            again = kind.decode(made.encode())
            assert again == made, (kind.NAME, function)
            count += 1
    assert count > 400


def _typed(kind: type[Command], name: str) -> str:
    """Some value of a parameter, as a person types it: 1 for all numbers."""
    value = _value(kind.INFO[name])
    if isinstance(value, list) and not any(isinstance(v, (list, dict)) for v in value):
        return ",".join(map(str, value))
    return json.dumps(value) if isinstance(value, (list, dict)) else str(value)


def _value(p: Parameter) -> Any:
    if p.kind == "switch":
        case = p.cases[1]
        assert case is not None
        return _value(case)
    one: Any = "A" if p.scalar == "char" else 1
    if isinstance(p.type, type) and issubclass(p.type, Structure):
        one = {m.name: _value(m) for m in p.type.INFO.parameters if not m.derived}
    if p.elements:
        one = [1] * len(p.elements)
    if p.kind == "text" or p.length is None:
        return one
    return [one] * (p.length if isinstance(p.length, int) else 1)


# --------------------------------------------------------------------------- record


def test_a_recording(place: str, tmp_path: Path) -> None:
    out = tmp_path / "log"
    assert mip("record", place, "-o", out, "--packets", "20", extras=False) == (0, "", "")
    parser = Parser()
    assert len(parser.feed(out.read_bytes())) == 20 and parser.pending == 0
    kept = out.read_bytes()
    error = f"mip record: {out} exists; name another file, or replace it with --force\n"
    assert mip("record", place, "-o", out, "--duration", "1") == (1, "", error) and out.read_bytes() == kept
    assert read_log(out).device == DEVICE  # its reply is in the log
    named = ("--duration", "1", "--force", "--device", DEVICE)  # and is not asked for
    assert mip("record", place, "-o", out, *named) == (0, "", "") and read_log(out).device is None
    assert out.read_bytes() != kept and Parser().feed(out.read_bytes())
    assert [p.name for p in tmp_path.iterdir()] == ["log"]


def test_a_recording_of_fields_at_rates(tmp_path: Path) -> None:
    with simulated() as place:
        words = ("record", place, "sensor.scaled_gyro@50", "filter_data.euler_angles@10", "-o", tmp_path / "log.bin")
        assert mip(*words, "--packets", "80")[0] == 0
        assert mip("record", place, "sensor.scaled_gyro", "-o", tmp_path / "other.bin") == (
            2,
            "",
            "mip record: sensor.scaled_gyro needs a rate, as in sensor.scaled_gyro@100\n",
        )
    found = {one.name: one.rate for one in read_log(tmp_path / "log.bin").types()}
    assert found["sensor.scaled_gyro"] == pytest.approx(50) and found["filter_data.euler_angles"] == pytest.approx(10)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_recording_ends_by_a_signal(number: int, place: str, tmp_path: Path) -> None:
    def heed() -> None:  # what `nohup` ignores is ignored by all that it starts
        signal.signal(number, signal.SIG_DFL)

    with running("record", place, "-o", tmp_path / "log", preexec_fn=heed) as process:
        until(lambda: any(p.stat().st_size for p in tmp_path.glob("log.*.part")), process)
        process.send_signal(number)
        assert process.communicate(timeout=PATIENCE) == (b"", b"") and process.returncode == 0
    assert [p.name for p in tmp_path.iterdir()] == ["log"] and Parser().feed((tmp_path / "log").read_bytes())


def test_a_recording_of_nothing(tmp_path: Path) -> None:
    """Nothing is written, and an older recording is kept."""
    out = tmp_path / "log"
    with socket.create_server(("127.0.0.1", 0)) as silent:
        where = f"127.0.0.1:{silent.getsockname()[1]}"
        words = ("record", where, "-o", out, "--duration", "0.2", "--force")
        assert mip(*words) == (1, "", f"mip record: {where} has sent nothing\n")
        assert list(tmp_path.iterdir()) == []
        out.write_bytes(b"older")
        assert mip(*words) == (1, "", f"mip record: {where} has sent nothing; {out} is unchanged\n")
    assert [(p.name, p.read_bytes()) for p in tmp_path.iterdir()] == [("log", b"older")]


def test_a_recording_that_cannot_get_its_name(place: str, tmp_path: Path) -> None:
    out = tmp_path / "log"
    with running("record", place, "-o", out) as process:
        until(lambda: any(p.stat().st_size for p in tmp_path.glob("log.*.part")), process)
        out.mkdir()
        process.send_signal(signal.SIGINT)
        error = process.communicate(timeout=PATIENCE)[1].decode()
    (part,) = tmp_path.glob("log.*.part")
    assert process.returncode == 1 and Parser().feed(part.read_bytes())
    assert error == f"mip record: {out} cannot be written: Is a directory; the bytes are in {part}\n"


@contextmanager
def sending(data: bytes) -> Iterator[str]:
    """A port that sends these bytes and closes."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            with server.accept()[0] as client:
                client.sendall(data)

        thread = Thread(target=serve)
        thread.start()
        yield f"127.0.0.1:{server.getsockname()[1]}"
        thread.join(PATIENCE)


@pytest.mark.parametrize("name", ["record", "dump", "monitor"])
def test_what_came_before_a_port_was_closed_is_kept_or_shown(name: str, tmp_path: Path) -> None:
    """Including a packet that is recognized only at the end of the bytes, as a longer one seemed to have begun."""
    packet = bytes(base.Ping().packet())
    data = packet + b"\x75\x65\x01\x40" + packet
    with sending(data) as where:
        code, out, error = mip(name, where, *["-o", tmp_path / "log"] * (name == "record"))
    what = f" after {len(data)} B, which are kept" if name == "record" else ""
    assert (code, error) == (1, f"mip {name}: {where} was closed{what}\n")
    if name == "record":
        assert (tmp_path / "log").read_bytes() == data
    else:
        assert out.count("ping") == 2 if name == "dump" else "2 packets, 4 bytes skipped" in out


def test_a_recording_into_a_pipe(place: str) -> None:
    with (
        subprocess.Popen(
            command("record", place, "-o", "-"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=ENVIRONMENT
        ) as first,
        subprocess.Popen(
            command("dump", "-", "--count", "3"), stdin=first.stdout, stdout=subprocess.PIPE, env=ENVIRONMENT
        ) as second,
    ):
        assert first.stdout is not None and first.stderr is not None and second.stdout is not None
        first.stdout.close()
        assert len(second.stdout.read().splitlines()) == 3
        assert first.stderr.read() == b"" and first.wait(PATIENCE) == 141


# --------------------------------------------------------------------------- monitor


def test_values_in_a_pipe(place: str) -> None:
    code, out, error = mip("monitor", place, "sensor.scaled_accel", "--duration", "2", "--rate", "5")
    assert (code, error) == (0, "")
    shown = out.strip().split("\n\n")
    assert len(shown) <= 12 and "timestamp" not in out and "\x1b" not in out
    assert re.search(r"^  scaled_accel +\S+ Hz$", shown[-1], re.M)
    assert re.search(r"scaled_accel = \(x=\S+, y=\S+, z=-[01]\.\S+\) g$", shown[-1], re.M)


def test_values_on_a_terminal(place: str) -> None:
    """With the standard library alone: shown in place of each other until Ctrl-C, then the screen is as before."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 100, 0, 0))
    words, environment = command("monitor", place, extras=False), {**ENVIRONMENT, "TERM": "xterm"}
    seen = b""
    with subprocess.Popen(words, stdin=slave, stdout=slave, stderr=slave, env=environment) as process:
        os.close(slave)
        while b"Hz" not in seen:
            assert select.select([master], [], [], PATIENCE)[0]
            seen += os.read(master, 4096)
        process.send_signal(signal.SIGINT)
        with suppress(OSError):  # the other end is closed
            while select.select([master], [], [], PATIENCE)[0] and (more := os.read(master, 4096)):
                seen += more
        assert process.wait(PATIENCE) == 0
    os.close(master)
    assert seen.startswith(b"\x1b[?1049h\x1b[?25l") and b"\x1b[H" in seen
    _, restored, last = seen.rpartition(b"\x1b[?25h\x1b[?1049l")
    assert restored and b"scaled_accel = (x=" in last and b"Traceback" not in seen


def test_a_device_on_a_terminal(tmp_path: Path) -> None:
    """The same at a serial port, as far as a pseudo-terminal is one."""
    port = str(tmp_path / "mip")
    with support.simulated("--pty", port, device=DEVICE):
        code, out, error = mip("send", port, "base.get_device_info", "--baud", "460800")
        assert (code, error) == (0, "") and "3DM-CV7" in out
        code, out, error = mip("send", port, "base.ping", "--baud", "auto")
        assert (code, out) == (0, "acknowledged\n"), error


def test_a_recording_is_kept_when_the_disk_is_full(place: str, tmp_path: Path) -> None:
    target = tmp_path / "log.bin"
    code, error = on_a_full_disk(2_000, "record", place, "-o", target, "--duration", 20)
    assert code == 1 and b"the part before is kept" in error
    assert 1_000 < target.stat().st_size <= 2_000 and [p.name for p in tmp_path.iterdir()] == ["log.bin"]


def test_a_recording_goes_on_when_hang_ups_are_ignored(place: str, tmp_path: Path) -> None:
    target = tmp_path / "log.bin"
    ignoring = {"preexec_fn": lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)}
    with running("record", place, "-o", target, "--packets", 150, **ignoring) as process:
        until(lambda: any(p.stat().st_size for p in tmp_path.glob("*.part")), process)
        process.send_signal(signal.SIGHUP)
        process.communicate(timeout=PATIENCE)
        assert process.returncode == 0
    assert len(Parser().feed(target.read_bytes())) == 150


@pytest.mark.parametrize("values", ["-1,0,0", "-inf,0,0", "-INF,0,0", "-nan,0,0", "-Infinity,0,0", "-.5,0,0"])
def test_lists_that_begin_with_a_negative_number(values: str, capsys: pytest.CaptureFixture[str]) -> None:
    named = run(capsys, "send", "--hex", "3dm.accel_bias", "write", f"bias={values}")
    assert named[0] == 0
    assert run(capsys, "send", "--hex", "3dm.accel_bias", "write", values) == named


def test_a_duration_begins_when_the_port_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """Opening a serial port takes time, above all with `--baud auto`."""
    now = 0.0

    class Device:
        closed = False

    @contextmanager
    def opened(line: connection.Line, **more: Any) -> Iterator[Any]:
        nonlocal now
        now += 10
        more["on_bytes"](b"first")
        yield Device

    monkeypatch.setattr(connection, "opened", opened)
    monkeypatch.setattr(time, "monotonic", lambda: now)
    found = connection.received_bytes(connection.Line("port", None, "record"), 1.0)
    assert next(found) == b"first"
    now += 2
    assert list(found) == []


def test_files_and_ports_are_not_confused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "log.bin").write_bytes(log(0.1))
    for words in (["send", "log.bin", "base.ping"], ["record", "log.bin", "-o", "other.bin"]):
        assert run(capsys, *words) == (1, "", f"mip {words[0]}: log.bin is a file, not a port\n")
    for port in ("localhost:1", "/dev/zero", "COM3", "socket://host:1"):
        for name, *words in (["info", port], ["export", port, "-o", "x.csv"], ["cut", port, "-o", "x.bin"]):
            error = f"mip {name}: {port} is a port, not a log; `mip record` records a log from it\n"
            assert run(capsys, name, *words) == (1, "", error)
    error = "mip send: /dev/ttyNONE cannot be opened: No such file or directory\n"
    assert run(capsys, "send", "/dev/ttyNONE", "base.ping") == (1, "", error)
    assert [p.name for p in tmp_path.iterdir()] == ["log.bin"]
