"""`mip dump`: packets explained; files, pipes, hexadecimal text, ports; anything else in between."""

from __future__ import annotations

import random
from collections import Counter
from pathlib import Path

import pytest
from mip_protocol import PacketBuilder, Parser, checksum, registry
from program import RECOGNIZED, log, mip, run
from support import rounds

#: Set -> how many fields and commands it has.
TYPES = Counter(number for number, _ in registry.all_types())

ACCEL = "75 65 80 0E 0E 04 3E 7A 63 A0 BB 8E 3B 29 7F E5 BF 7F 84 EE"
EXPLAINED = """\
sensor (0x80), 1 field, 20 bytes: 75 65 80 0e … checksum 84 ee
  sensor.scaled_accel (0x80,0x04), data: 0e 04 3e 7a 63 a0 bb 8e 3b 29 7f e5 bf 7f
    scaled_accel = (x=0.24452066, y=-0.0043405485, z=nan) g
"""
LINE = "sensor: scaled_accel(x=0.24452066, y=-0.0043405485, z=nan) g\n"


def test_one_packet_explained() -> None:
    assert mip("dump", *ACCEL.split(), extras=False) == (0, EXPLAINED, "")
    assert mip("dump", ACCEL)[1] == EXPLAINED
    assert mip("dump", ACCEL.replace(" ", "").lower(), "--line")[1] == LINE
    assert mip("dump", "0x75,0x65,0x01,0x02,0x02,0x01,0xE0,0xC6", "--line", "--raw")[1] == (
        "base: ping()\n  75 65 01 02 02 01 e0 c6\n"
    )


def test_what_is_wrong_with_a_packet() -> None:
    code, out, error = mip("dump", ACCEL.replace("84 EE", "84 EF"))
    assert code == 1 and "20 bytes outside packets, checksum 84ef should be 84ee: 75 65 80" in out
    assert error == "mip dump: no packet in 20 bytes: checksum 84ef should be 84ee\n"
    missing = "no packet in 17 bytes: 3 bytes are missing at the end of a packet"
    code, out, error = mip("dump", ACCEL[:-9])
    assert "3 bytes are missing at the end of a packet: 75 65" in out and missing in error
    assert "in 19 bytes: 1 byte is missing at the end of a packet\n" in mip("dump", ACCEL[:-3])[2]
    assert "in 1 byte: packets begin with 75 65\n" in mip("dump", "75")[2]
    body = bytes.fromhex("7565800405040102")
    code, out, _ = mip("dump", (body + checksum(body)).hex())
    assert code == 0 and "malformed: a field of length 5 in 4 bytes" in out
    unknown = bytes(PacketBuilder(0x80).add(0x79, b"\1\2").add(0x04, b"\0").build())
    code, out, _ = mip("dump", unknown.hex())
    assert "unknown field (0x80,0x79): 04 79 01 02" in out and "cannot be decoded: 12 bytes needed, 1 left" in out


@pytest.mark.parametrize("way", ["file", "pipe", "hexadecimal file", "hexadecimal pipe"])
def test_the_same_from_everywhere(way: str, tmp_path: Path) -> None:
    stream = b"$GPGGA,noise*00\r\n" + log(0.5) + b"\x75\x65\x80"
    data = stream.hex(" ").encode() if way.startswith("hex") else stream
    path = tmp_path / "log"
    path.write_bytes(data)
    code, out, error = mip("dump", path) if way.endswith("file") else mip("dump", "-", data=data)
    lines = out.splitlines()
    assert (code, error) == (0, f"mip dump: {RECOGNIZED}\n")
    parser = Parser()
    packets = parser.feed(stream)
    assert len(lines) == len(packets) > 40
    at = 0
    for line, packet in zip(lines, packets, strict=True):
        at = stream.index(bytes(packet), at)
        assert line.startswith(f"{at:08x} ") and all(
            f.NAME.partition(".")[2] in line for f in registry.decode_packet(packet) if not isinstance(f, tuple)
        )


def test_selection_and_bytes_in_between(tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(b"$GPGGA,noise*00\r\n" + log(0.5) + b"\x75\x65\x80")
    code, out, _ = mip("dump", path, "--only", "filter_data,0x80:0x06", "--without", "shared", "--skipped")
    assert code == 0
    lines = out.splitlines()
    assert lines[0] == "00000000 17 bytes outside packets: '$GPGGA,noise*00\\r\\n'"
    assert lines[-1].endswith("3 bytes outside packets: 75 65 80")
    assert {line.split()[1] for line in lines[1:-1]} == {"sensor:", "filter_data:"}
    assert not any("scaled_accel" in line or "timestamp" in line for line in lines)
    code, out, error = mip("dump", path, "--only", "gnss_2")
    assert (code, out) == (0, "") and error.endswith("packets, none with these fields\n")
    assert len(mip("dump", path, "--count", "3")[1].splitlines()) == 3


def test_any_bytes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Every command that reads logs ends with 0, with two remarks at most, or with 1 and one line of errors."""
    rng = random.Random(7)
    base = log(0.3)
    path = tmp_path / "log"
    for turn in range(rounds(8, 200)):
        data = bytearray(base[: rng.randrange(1, 2000)])
        for _ in range(rng.randrange(30)):
            data[rng.randrange(len(data))] = rng.choice((0, 0x75, 0x65, 0xFF, rng.randrange(256)))
        if turn % 4 == 0:
            data = bytearray(b"\x75\x65" * rng.randrange(500)) + rng.randbytes(rng.randrange(300))
        if turn % 4 == 1:  # fields of random lengths and contents, in packets that are in order
            data = bytearray()
            for _ in range(20):
                number = rng.choice([n for n in registry.MODULES if TYPES[n] > 1])
                builder = PacketBuilder(0x80 if number == 0xFF else number)
                for kind in rng.sample([t for n, t in registry.all_types() if n == number], 2):
                    builder.add(kind.DESCRIPTOR, rng.randbytes(rng.randrange(90)))
                data += bytes(builder.build())
        path.write_bytes(data)
        for words in (
            ["dump", path, "--skipped"],
            ["dump", path, "--tree", "--device", "3dm-gx5-15"],
            ["info", path],
            ["info", path, "--json"],
            ["cut", path, "-o", tmp_path / "part", "--only", "sensor"],
            ["cut", path, "-o", tmp_path / "part", "--begin", "0.1"],
            ["export", path, "-o", tmp_path / "out.csv", "--invalid", "mask", "--names"],
            ["export", path, "-o", tmp_path / "out.jsonl", "--time", "none"],
        ):
            code, _, error = run(capsys, *words)
            lines = error.count("\n")
            assert (code == 0 and lines <= 2) or (code, lines) == (1, 1), words
