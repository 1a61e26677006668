"""The program: help, errors, the specification."""

from __future__ import annotations

import json
import marshal
import re
import shlex
from pathlib import Path

import pytest
from mip_protocol import registry
from mip_protocol.devices import DEVICES
from mip_simulator import VirtualDevice
from mip_tools import __main__
from mip_tools.devices.profiles import device_named
from mip_tools.names import search
from program import ENVIRONMENT, RECOGNIZED, log, on_a_full_disk, run
from random_values import chance
from support import ROOT, rounds

ACCEL = "75 65 80 0E 0E 04 3E 7A 63 A0 BB 8E 3B 29 7F E5 BF 7F 84 EE"


@pytest.mark.parametrize("name", __main__.COMMANDS)
def test_help(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, error = run(capsys, name, "--help")
    text = __main__.COMMANDS[name]
    assert (code, error) == (0, "") and out.startswith("usage: mip ") and text[1:] in " ".join(out.split())
    assert name == "simulate" or all(len(line) <= 100 for line in out.splitlines()), max(out.splitlines(), key=len)
    assert "examples:" in out
    used = set(re.findall(r"(?<=\s)--?[a-z][a-z-]*", out.partition("examples:")[2]))
    assert used <= set(re.findall(r"--?[a-z][a-z-]*", out.partition("examples:")[0])) | {"--help"}


def test_exit_status_of_wrong_command_lines(capsys: pytest.CaptureFixture[str]) -> None:
    said = "'dumb' is not a command; did you mean 'dump'? `mip --help` lists them"
    assert run(capsys, "dumb") == (2, "", f"mip: {said}\n")
    assert run(capsys, "zzz") == (2, "", "mip: 'zzz' is not a command; `mip --help` lists them\n")
    for words in (["dump"], ["dump", "--speed"], ["cut", "x", "-o", "y", "--begin", "a"], ["send"]):
        code, out, error = run(capsys, *words)
        assert (code, out) == (2, "") and error.startswith("usage: ") and "error: " in error.splitlines()[-1]
    for words, required in (("send", "PORT"), ("export", "FILE, -o/--output")):
        assert run(capsys, words)[2].endswith(f"the following arguments are required: {required}\n")
    said = "the command is missing; `mip fields` lists the sets, `mip fields SET` their commands"
    assert run(capsys, "send", "PORT") == (2, "", f"mip send: {said}\n")
    _, _, error = run(capsys, "dump", "x", "--fast")
    assert error.splitlines()[-1] == "mip dump: error: --fast is not recognized; see --help"


@pytest.mark.parametrize(
    ("words", "same"),
    [
        ("export LOG --format csv -o - sensor.scaled_accel", "export LOG sensor.scaled_accel -o - --format csv"),
        (
            "export LOG sensor --only 0x82 -o - --time none filter_data",
            "export LOG sensor filter_data 0x82 -o - --time none",
        ),
        ("send 3dm.accel_bias --hex write -1,0,0", "send --hex 3dm.accel_bias write -1,0,0"),
        ("dump LOG --count 3 LOG", "dump LOG LOG --count 3"),
        ("dump --count 1 -- LOG", "dump LOG --count 1"),
    ],
)
def test_options_may_stand_between_the_words(
    words: str, same: str | None, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("LOG").write_bytes(log(0.3))
    code, out, error = run(capsys, *words.split())
    assert (code, error.replace(f"mip dump: {RECOGNIZED}\n", "")) == (0, "") and out
    if same is not None:
        assert out.splitlines() == run(capsys, *same.split())[1].splitlines()
    name, *others = words.split()
    code, _, error = run(capsys, name, "--fast", *others)
    assert code == 2 and error.endswith("--fast is not recognized; see --help\n")


#: Messages about the command line itself, not about files or results.
#: Commands that read or speak MIP, and where a device can be named.
OF_A_DEVICE = (
    "dump LOG", "info LOG", "doctor LOG", "export LOG -o OUT", "plot LOG sensor.scaled_accel -o OUT.png",
    "cut LOG -o OUT", "cut - -o OUT", "monitor LOG", "stream LOG", "send --hex base.ping", "fleet FOLDER -o OUT",
    "fields",
)  # fmt: skip
#: What is wrong with files and results; all other messages are about the command line itself.
FAILURES = ".*(cannot be (read|written)|no packet in|ODD has|is a folder|no field |LOG has|no window)"


@pytest.mark.parametrize(
    ("words", "error"),
    [
        ("dump NOWHERE", "dump: NOWHERE cannot be read: No such file or directory"),
        ("dump FOLDER", "dump: FOLDER cannot be read: Is a directory"),
        ("dump EMPTY", "dump: no packet in 0 bytes: no bytes; is the device on"),
        ("dump ODD", "dump: ODD has an odd number of hexadecimal digits; each byte needs two"),
        ("dump LOG --only sensr", "dump: 'sensr' is not a field; "),
        ("dump LOG --only 0x80:256", "dump: '0x80:256' has a number above 255; use 0 to 255"),
        *((f"{words} --device gx5", f"{words.split()[0]}: 'gx5' is not a device; ") for words in OF_A_DEVICE),
        ("simulate gx5", "simulate: 'gx5' is not a device; "),
        ("cut LOG -o FOLDER", "cut: FOLDER is a folder; name a file in it"),
        ("cut LOG -o NOWHERE/x", "cut: NOWHERE/x cannot be written: No such file or directory"),
        ("export LOG -o OUT.xls", "export: '.xls' is not a known format; use --format csv, jsonl, parquet, mcap"),
        ("export LOG gnss_2 -o OUT", "export: LOG has none of these fields; `mip info` lists its fields"),
        ("fields sensor.x", "fields: 'sensor.x' is not a field; "),
        ("fields nope", "fields: 'nope' is not a field; `mip fields` lists the sets"),
        ("fields temperature", "fields: 'temperature' is not a field; "),
        ("fields sensor --search banana", "fields: no field matches NAME, --search and --device together; leave one "),
        ("fields --search qqqq", "fields: no field has a word of 'qqqq'; `mip fields` lists the sets"),
        ("send --hex base.pink", "send: 'base.pink' is not a field; did you mean base.ping"),
        ("send --hex sensor.scaled_accel", "send: sensor.scaled_accel is not a command; `mip fields --search "),
        (
            "send --hex 3dm.message_format",
            "send: 3dm.message_format needs a function: write, read, save, load, default",
        ),
        ("send --hex 3dm.message_format wirte", "send: 3dm.message_format needs a function, not 'wirte': write, "),
        (
            "send --hex 3dm.message_format read",
            "send: 3dm.message_format needs descriptor_set; `mip fields 3dm.message_format` lists ",
        ),
        (
            "send --hex 3dm.message_format read 1 2",
            "send: '2' is one value too many; 3dm.message_format has descriptor_set",
        ),
        (
            "send --hex 3dm.message_format read set=1",
            "send: 3dm.message_format has no parameter 'set' here; it has descriptor_set",
        ),
        ("send --hex 3dm.message_format read descriptor_set=1 descriptor_set=2", "send: descriptor_set is given twice"),
        ("send --hex 3dm.message_format read fast", "send: descriptor_set: 'fast' is not a whole number"),
        (
            "send --hex 3dm.message_format write sensor scaled_acel:7",
            "send: descriptor: 'scaled_acel' is not a field of sensor; did ",
        ),
        (
            "send --hex 3dm.message_format write sensor dop:7",
            "send: descriptor: 'dop' is not a field of sensor; `mip fields sensor` ",
        ),
        (
            "send --hex 3dm.message_format read sensr",
            "send: descriptor_set: 'sensr' is neither a number nor a field; did you mean ",
        ),
        ("send --hex 3dm.message_format read 256", "send: 3dm.message_format cannot be sent: descriptor_set"),
        (
            "send --hex 3dm.message_format write 1 4:99999",
            "send: descriptors cannot be sent: decimation is 99999, needs 0 to 65535",
        ),
        (
            'send --hex 3dm.message_format write 1 \'[{"descriptor": 4, "decimation": -1}]\'',
            "send: descriptors cannot be sent: decimation",
        ),
        (
            "send --hex 3dm.message_format write 1 4:5:6",
            "send: descriptors: '4:5:6' has too many parts; write descriptor:decimation",
        ),
        (
            "send --hex 3dm.message_format write 1 4",
            "send: descriptors has parts that are missing; write descriptor:decimation",
        ),
        ("send --hex 3dm.message_format write 1 '[{'", "send: descriptors: '[{' is not JSON: "),
        (
            "send --hex 3dm.message_format write 1 '[{\"x\": 1}]'",
            "send: descriptors has no 'x'; it has descriptor, decimation",
        ),
        ("send --hex 3dm.message_format write 1 '[null]'", "send: descriptors cannot have the value null"),
        ("send --hex 3dm.data_stream_control write 1 maybe", "send: enable: 'maybe' is neither true nor false"),
        ("send --hex 3dm.pps_source_control write moon", "send: source: 'moon' is not one of disabled, "),
        ("plot LOG sensor.scaled_accel", "plot: no window can be opened here; write an image with -o FILE.png"),
        (
            "plot LOG sensor.scaled_accel -o t.gif",
            "plot: '.gif' is not a known format; name a file that ends in .png, .svg or .pdf",
        ),
        ("plot LOG sensor.scaled_accel.w -o t.png", "plot: sensor.scaled_accel has no element 'w'; it has x, y, z"),
        (
            "plot LOG sensor.scaled_accel.scaled_accel.w -o t.png",
            "plot: sensor.scaled_accel has no element 'w'; it has x, ",
        ),
        ("plot LOG base.ping -o t.png", "plot: base.ping is not a data field; `mip info` lists the fields of a log"),
        ("plot LOG gnss_2.llh_position -o t.png", "plot: LOG has no gnss_2.llh_position; `mip info` lists its fields"),
        ("plot LOG sensor.scaled -o t.png", "plot: 'sensor.scaled' is not a field; did you mean "),
        (f"dump {ACCEL[:-1]}", "dump: 'E' is not a byte in hexadecimal, which has two digits"),
        (f"dump '{ACCEL[:-1]}'", "dump: 'E' is not a byte in hexadecimal, which has two digits"),
        (f"dump {ACCEL.replace('80', 'zz')}", "dump: 'zz' is not a byte in hexadecimal, which has two digits"),
        ("dump 7565zz", "dump: 'zz' is not hexadecimal"),
        (f"dump {ACCEL.replace(' ', '')[:-1]}", "dump: an odd number of hexadecimal digits; each byte needs two"),
        ("stream localhost:1 --format foxglove -o x", "stream: with --format foxglove, no file is written; "),
        ("stream localhost:1 --listen localhost:1", "stream: --listen and --origin are for --format foxglove"),
        (
            "stream LOG --format foxglove",
            "stream: LOG is a log; `mip export LOG -o log.mcap` writes a file that Fox",
        ),
        (
            "stream localhost:1 --format foxglove --listen 8765",
            "stream: '8765' is not HOST:PORT; the default is ",
        ),
        ("export LOG --by packet -o x.mcap", "export: --by packet is for tables; mcap has messages for each field"),
        ("export LOG --by packet --format ros2 -o x", "export: --by packet is for tables; ros2 has messages for each"),
        ("stream LOG --by packet --format foxglove", "stream: --by packet is for tables; foxglove has messages for"),
        ("serve", "serve: error: the following arguments are required: PORT"),
        ("serve x --tcp x", "serve: error: argument --tcp: 'x' is not a TCP port; use a number up to 65535"),
        ("config pull", "config: error: the following arguments are required: PORT|FILE"),
        ("config push PORT", "config: `mip config push` needs PORT and FILE"),
        ("config pull PORT more", "config: `mip config pull` needs PORT"),
        ("config save PORT -o x", "config: -o is only for `mip config pull`"),
        ("config pul PORT", "config: error: argument ACTION: invalid choice: 'pul'"),
        (
            "corrections ftp://host/M nowhere",
            "corrections: 'ftp://host/M' is not a mount point of a caster; write ntrip://",
        ),
        ("corrections ntrip://host:x/M nowhere", "corrections: 'ntrip://host:x/M' is not a mount point"),
        ("corrections /dev/ttyACM0 ntrip://host/M", "corrections: the mount point comes first"),
    ],
)
def test_errors_are_one_line(
    words: str, error: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Behind the usage, if a command is used in a wrong way; and nothing is written."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    Path("FOLDER").mkdir()
    Path("EMPTY").touch()
    Path("ODD").write_text("75 65 0")
    Path("LOG").write_bytes(log(0.2))
    before = sorted(tmp_path.iterdir())
    code, out, said = run(capsys, *shlex.split(words))
    *usage, last = said.splitlines()
    assert (code, out) == (1 if re.match(FAILURES, error) else 2, "") and last.startswith(f"mip {error}"), said
    assert usage[:1] == [] or (usage[0].startswith("usage: ") and ": error: " in error), said
    assert sorted(tmp_path.iterdir()) == before


# --------------------------------------------------------------------------- fields


@pytest.mark.parametrize("name", ["3dm-cv7-ahrs", "3DM-CV7-AHRS", "cv7-ahrs", "CV7 AHRS"])
def test_a_device_has_one_set_of_names(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = ("fields", "sensor", "--device")
    assert run(capsys, *words, name) == run(capsys, *words, "3dm-cv7-ahrs")
    assert device_named(name).id == VirtualDevice(name).profile.id == "3dm-cv7-ahrs"


def test_the_site_leaves_out_the_same_words() -> None:
    text = (ROOT / "tools/workbench/rank.mjs").read_text().partition("FILLING = new Set(")[2].partition(".split")[0]
    assert {*"".join(re.findall('"([^"]*)"', text)).split()} == search.FILLING


def test_the_specification(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "fields")
    assert code == 0 and [int(line[:4], 16) for line in out.splitlines()] == list(registry.MODULES)
    out, types = run(capsys, "fields", "sensor")[1], sum(number == 0x80 for number, _ in registry.all_types())
    assert out.startswith("0x80,0x01  sensor.raw_accel ") and len(out.splitlines()) == types
    one = run(capsys, "fields", "sensor.scaled_accel")[1]
    assert one.startswith("sensor.scaled_accel (0x80,0x04), data\n") and "  scaled_accel: float[3] [g]\n" in one
    names = ("0x80:0x04", "0x80,4", "0x8004", "8004", "ScaledAccel")
    assert all(run(capsys, "fields", name)[1] == one for name in names)
    status = run(capsys, "fields", "filter_data.status")[1]
    assert "bit 12  init_no_attitude " in status and "Only while `filter_state` is `Gx5FilterState.INIT`" in status
    *_, flags = json.loads(run(capsys, "fields", "filter_data.status", "--json")[1])["parameters"]
    (five,) = (v for v in flags["variants"] if "3dm-gx5-15" in v["keys"])
    assert five["states"]["init_no_attitude"] == {"filter_state": [1]} and five["bits"]["init_no_attitude"] == 0x1000
    found = run(capsys, "fields", "--search", "TEMPERATURE", "--device", "3dm-gx5-15")[1]
    assert "sensor.temperature" in found or "sensor.scaled_pressure" in found
    assert "gnss_1" not in found
    first = {
        "bias gyro": "filter_data.gyro_bias",
        "accelerometre": "sensor.scaled_accel",
        "waas": "3dm.gnss_sbas_settings",
        "low_pass_filter_responses": "3dm.low_pass_filter ",
        "open drain": "3dm.gpio_config",
        "estimated gyro biases": "filter_data.gyro_bias",
        "what is 0x82,0x10": "filter_data.status",
        "82 10": "filter_data.status",
        "80D3": "shared.gps_timestamp",
        "gyrobias": "gyro_bias",
        "how do I set the baud rate of the uart": "baud",
        "rate of turn": "sensor.scaled_gyro",
        "imu temperature": "sensor.temperature_statistics",
    }
    lines = run(capsys, "fields", "--search", "hdop")[1].splitlines()  # a field of several sets is one result
    assert "gnss_data.dop" in lines[0] and lines[0].endswith("also in 0x91, 0x92, 0x93, 0x94, 0x95")
    assert not any("gnss_1" in line for line in lines)
    assert run(capsys, "fields", "82", "10")[1].startswith("0x82,0x10 ")
    assert run(capsys, "fields", "--search", "gimbal lock")[2] == "mip fields: nothing has 'gimbal'\n"
    assert run(capsys, "fields", "--search", "accelerometre")[2].endswith("; searched for 'accelerometer'\n")
    assert [search.missing(word)[0][1] for word in ("heave", "posix", "buad", "antena")] == ["", "", "baud", "antenna"]
    for text, field in first.items():
        assert field in run(capsys, "fields", "--search", text)[1].splitlines()[0], text
        assert run(capsys, "fields", "--search", *text.split()) == run(capsys, "fields", "--search", text)
    out = run(capsys, "fields", "3dm.message_format")[1]
    assert "mip send PORT 3dm.message_format write descriptor_set descriptors" in out


def test_every_field_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    names = [(kind.name_in(number), kind) for number, kind in registry.all_types()]
    for name, kind in chance("fields").sample(names, rounds(80, len(names))):
        code, out, error = run(capsys, "fields", name)
        assert (code, error) == (0, "") and out.startswith(f"{name} (0x") and f"\n{name} (0x" not in out
        for p in kind.INFO.parameters:
            assert f"  {p.name}: " in out
    found = [json.loads(line)["name"] for line in run(capsys, "fields", "--json")[1].splitlines()]
    assert found == [name for name, _ in names]
    found = [json.loads(line)["device"] for line in run(capsys, "fields", "--devices", "--json")[1].splitlines()]
    assert found == list(DEVICES)


def test_a_full_disk_cuts_no_compiled_module(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where nothing has been compiled yet, what tests of full disks leave can all be imported."""
    monkeypatch.setitem(ENVIRONMENT, "PYTHONPYCACHEPREFIX", str(tmp_path / "compiled"))
    (tmp_path / "log").write_bytes(log(1.0))
    assert on_a_full_disk(2_000, "export", tmp_path / "log", "-o", tmp_path / "out.csv")[0] == 1
    for path in tmp_path.glob("compiled/**/*.pyc"):
        marshal.loads(path.read_bytes()[16:])
