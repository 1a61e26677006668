"""The programs of the folder examples, as their users run them."""

from __future__ import annotations

import json
import os
import re
import subprocess
from functools import cache
from pathlib import Path

import pytest
from crates import WORK, passes, rendered
from mipgen.lower import codec
from mipgen.targets import rust as target
from support import PATIENCE, heavy, need, nightly
from test_rust import EMBEDDED, embedded, workspace

FEATURES = "open,std,serde,tokio"
#: Sets that the programs need: all of them with `serde` take as long as everything else here. `make test-all` has them.
SETS = "base,mip_3dm,sensor,shared"

#: Noise, and accelerations from the manual.
ACCEL = bytes.fromhex("7565800e0e043e7a63a0bb8e3b297fe5bf7f84ee")
LOG = b"$GPGGA noise\r\n" + ACCEL


EXAMPLES = "the example programs of Rust"


def crate() -> Path:
    return workspace("real") / "mip-protocol"


@cache
def programs() -> Path:
    features = ("--no-default-features", "--features", f"{FEATURES},{SETS}")
    passes(crate(), "build", "--quiet", "--locked", "--examples", *features)
    return WORK / "target/debug/examples"


def ran(name: str, *arguments: object, given: bytes = b"") -> tuple[int, str, str]:
    done = subprocess.run([programs() / name, *map(str, arguments)], input=given, capture_output=True, timeout=PATIENCE)
    return done.returncode, done.stdout.decode("latin-1"), done.stderr.decode()


def packet(hexadecimal: str) -> bytes:
    """A packet of this header and payload."""
    data = bytes.fromhex(hexadecimal)
    return data + codec.checksum(data)


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "log.bin"
    path.write_bytes(LOG)
    return path


def test_the_examples_are_these() -> None:
    """Each is listed, has a first line that says what it does, and names the features that it needs."""
    found = {p.stem for p in (crate() / "examples").iterdir()}
    assert found == {*target.EXAMPLES, "embassy"}
    readme = rendered("real")["README.md"].decode()
    for name, needed in target.EXAMPLES.items():
        assert f"`examples/{name}.rs`" in readme, name
        text = (crate() / f"examples/{name}.rs").read_text("utf-8")
        if name != "quickstart":
            assert text.startswith("//! ")
        if needed:
            assert f"--example {name} --features {','.join(needed)} " in text, name
    assert "dev-dependencies" not in rendered("invented")["Cargo.toml"].decode()


@nightly("lints of the example programs of Rust")
def test_lints_of_examples() -> None:
    lint = ("clippy", "--quiet", "--locked", "--examples", "--features", FEATURES)
    passes(crate(), *lint, "--", "-D", "warnings")


@heavy(EXAMPLES)
def test_log_to_csv(log: Path) -> None:
    code, out, error = ran("log_to_csv", log)
    head, row = out.splitlines()
    assert (code, error) == (0, "14 bytes are not part of a packet\n")
    columns = head.split(",")
    assert columns[:3] == ["time", "time_device", "accel_x_g"] and head.count(",") == row.count(",") == 7
    assert row == ",,0.24452066,-0.0043405485,NaN,,,"
    accel = "0e04" + "3f80000000000000c0000000"
    tow, week = "40c1170000000000", "0001"  # 8750 s
    date = "1980-01-13T02:25:50.000000000Z,"
    times = {  # each kind of time, valid and not
        "0ed3" + tow + week + "0003": date, "0ed3" + tow + week + "0000": ",8750", "0e12" + tow + week + "0018": date,
        "0e12" + tow + week + "0004": date, "0e12" + tow + week + "0003": ",8750", "0ad5" + "0000000077359400": ",2",
    }  # fmt: skip
    for field, time in times.items():
        log.write_bytes(packet(f"756580{len(field + accel) // 2:02x}" + field + accel))
        code, out, error = ran("log_to_csv", log)
        assert (code, out.splitlines()[1]) == (0, f"{time},1,0,-2,,,"), error
    assert ran("log_to_csv")[0] == 1
    # A short field, and one that its packet cuts.
    for length in ("06", "0e"):
        log.write_bytes(packet("75658006" + length + "04" + "3e7a63a0"))
        code, out, error = ran("log_to_csv", log)
        assert code == 1 and "it needs 12 bytes and has 4" in error


@heavy(EXAMPLES)
def test_json(log: Path) -> None:
    log.write_bytes(LOG + packet("75658004" + "04fe0102"))
    code, out, error = ran("json", log)
    assert (code, error) == (0, "")
    accel, unknown = map(json.loads, out.splitlines())
    values = accel["fields"][0]["sensor.scaled_accel"]["scaled_accel"]
    assert (accel["set"], values[0], values[2]) == (128, pytest.approx(0.24452066), "NaN(0x7fe5bf7f)")
    assert unknown == {"set": 128, "fields": [{"descriptor": 254, "data": [1, 2]}]}
    assert '[0.24452066,-0.0043405485,"' in out  # as short as floats of 32 bits are
    # A field whose data are too short, and one that its packet cuts.
    log.write_bytes(packet("75658004" + "04040102") + packet("75658006" + "02fe" + "0e040102"))
    short, cut = (json.loads(line)["fields"] for line in ran("json", log)[1].splitlines())
    assert short == [{"descriptor": 4, "data": [1, 2], "error": "sensor.scaled_accel: it needs 12 bytes and has 2"}]
    assert cut[1] == {"error": "the length of a field does not fit into the packet"}


@heavy(EXAMPLES)
def test_nobody_reads_the_json(log: Path) -> None:
    """It ends with an error, without a panic, as with `json log.bin | head`."""
    log.write_bytes(LOG * 2000)
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([programs() / "json", log], stdout=writer, stderr=subprocess.PIPE, timeout=PATIENCE)
    os.close(writer)
    assert done.returncode == 1 and b"json: Broken pipe" in done.stderr and b"panicked" not in done.stderr


#: The packets that the firmware sends, and the replies.
RATE, STREAM = packet("75650c03" + "030e80"), packet("75650c05" + "0511018001")
RATE_IS = packet("75650c09" + "04f10e00" + "058e8003e8")


@heavy(EXAMPLES)
def test_firmware() -> None:
    answered = packet("75650c04" + "04f11100")
    code, out, error = ran("firmware", given=b"u" + RATE_IS + answered + LOG)
    assert code == 0 and error.splitlines() == ["1 1000", "3 0", "6 NaN"]
    assert out.encode("latin-1") == RATE + STREAM
    refused = packet("75650c04" + "04f10e03")
    assert ran("firmware", given=refused)[2].splitlines() == ["2 0"]


SMALL = {"OPT_LEVEL": "z", "LTO": "true", "CODEGEN_UNITS": "1", "PANIC": "abort"}
SMALL = {f"CARGO_PROFILE_RELEASE_{key}": value for key, value in SMALL.items()}


@heavy(EMBEDDED)
def test_firmware_is_small() -> None:
    """As the README says."""
    build = ("build", "--quiet", "--locked", "--release", "--example", "firmware", "--target", embedded())
    passes(crate(), *build, **SMALL)
    program = WORK / "target" / EMBEDDED / "release/examples/firmware"
    sizes = subprocess.run([need("size"), str(program)], capture_output=True, text=True, check=True).stdout
    text, data = map(int, sizes.splitlines()[1].split()[:2])
    (said,) = re.findall(r"byte by byte, in ([\d.]+) kB", rendered("real")["README.md"].decode())
    assert float(said) - 0.2 < (text + data) / 1000 <= float(said)


@heavy(EMBEDDED)
def test_embassy() -> None:
    """It is linked for a Cortex-M4."""
    machine = "thumbv7em-none-eabi"
    build = ("build", "--quiet", "--locked", "--release", "--target", embedded(machine))
    passes(crate() / "examples/embassy", *build, **SMALL)
    program = WORK / "target" / machine / "release/mip-protocol-embassy"
    sizes = subprocess.run([need("size"), str(program)], capture_output=True, text=True, check=True).stdout
    assert 5_000 < int(sizes.splitlines()[1].split()[0]) < 30_000
