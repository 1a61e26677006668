"""What bytes are: MIP in the notations of tools and languages, MIP damaged on its way, and what else arrives."""

from __future__ import annotations

import base64
import gzip
import json
import random
import struct
from pathlib import Path

import pytest
from mip_tools.logs import inputs
from mip_tools.logs.recognize import UNKNOWN, count_packets, from_text, recognized, without_checksum
from program import log, mip
from support import ROOT

STREAM = log(0.2)
HEX = STREAM.hex()
PAIRS = [f"{byte:02x}" for byte in STREAM]


def lines(form: str, size: int = 16, data: bytes = STREAM) -> str:
    """A dump with a line for each 16 bytes."""
    parts = [(at, data[at : at + size]) for at in range(0, len(data), size)]
    return "".join(
        form.format(
            at=at,
            hex=part.hex(" "),
            words=f"{part.hex(' ', -2):<39}",
            halves=f"{part[:8].hex(' '):<23}  {part[8:].hex(' ')}",
            text="".join(chr(b) if 32 <= b < 127 else "." for b in part),
            size=len(part),
            plain=part.hex(),
        )
        + "\n"
        for at, part in parts
    )


#: How tools dump bytes.
FORMS = {
    "xxd": "{at:08x}: {words}  {text}",
    "hexdump -C": "{at:08x}  {halves}  |{text}|",
    "Wireshark": "{at:04x}   {hex}   {text}",
}
#: How a tool, a language or a terminal shows bytes.
NOTATIONS = {
    "hex": HEX,
    "upper hex": " ".join(PAIRS).upper(),
    "0x and commas": ", ".join(f"0x{pair}" for pair in PAIRS),
    "without leading zeros": " ".join(f"{byte:X}" for byte in STREAM),
    ".NET": "-".join(PAIRS).upper(),
    "colons": ":".join(PAIRS),
    "semicolons": ";".join(PAIRS),
    "decimal": " ".join(map(str, STREAM)),
    "list of Python": str(list(STREAM)),
    "signed bytes of Java": str([byte - 256 if byte > 127 else byte for byte in STREAM]),
    "bytes of Python": repr(STREAM),
    "bytearray of Python": repr(bytearray(STREAM)),
    "string of C": '"' + "".join(f"\\x{pair}" for pair in PAIRS) + '"',
    "octal of a shell": "$'" + "".join(f"\\{byte:03o}" for byte in STREAM) + "'",
    "array of C": "static const uint8_t packet[] = { " + ", ".join(f"0x{b:X}" for b in STREAM) + " };  // a log\n",
    "array of Rust": "let packet: [u8; 9] = [" + ", ".join(map(str, STREAM)) + "];",
    "base64": base64.b64encode(STREAM).decode(),
    "JSON": json.dumps({"type": "Buffer", "data": list(STREAM)}),
    "hex in JSON": json.dumps({"payload": HEX}),
    "base64 in JSON": json.dumps({"data": base64.b64encode(STREAM).decode()}),
    "Node": "<Buffer " + " ".join(PAIRS) + ">",
    "xxd": lines(FORMS["xxd"]),
    "xxd -p": lines("{plain}", 30),
    "hexdump -C": lines(FORMS["hexdump -C"]) + f"{len(STREAM):08x}\n",
    "Wireshark": lines(FORMS["Wireshark"]),
    "candump": lines("  can0  123   [{size}]  {hex}", 8),
    "a terminal": lines("[12:00:01.250] RX: {hex}"),
    "a log with names": lines("2024-05-01 INFO > {hex}"),
    "PowerShell": "\ufeff" + " ".join(PAIRS),
    "Notepad": "\ufeff" + " ".join(PAIRS),
}


@pytest.mark.parametrize("name", NOTATIONS)
def test_notations_of_bytes_are_read(name: str, tmp_path: Path) -> None:
    """They are recognized by their beginning, wherever a read of a long log ends."""
    encoding = {"PowerShell": "utf-16-le", "Notepad": "utf-8"}.get(name, "ascii")
    text = NOTATIONS[name]
    for size in range(len(text) // 2, len(text) // 2 + 50):
        assert inputs._is_text(text[:size].encode(encoding)), text[:size][-50:]
    assert from_text(text.encode(encoding)) == STREAM
    (tmp_path / "log.txt").write_bytes(text.encode(encoding))
    assert mip("dump", tmp_path / "log.txt", "--line")[1] == mip("dump", "-", "--line", data=STREAM)[1]
    assert mip("info", tmp_path / "log.txt", "--json")[1].count('"packets"') > 1


def test_texts_that_the_workbench_reads_too() -> None:
    for wanted, texts in json.loads((ROOT / "tests/pasted.json").read_text("utf-8")).items():
        for text in texts:
            data = from_text(text.encode())
            assert data is not None and data.hex() == wanted, text


def test_long_texts_are_read_as_a_whole(tmp_path: Path) -> None:
    data = STREAM * (1 + 40_000 // len(STREAM))
    for text in (
        "const uint8_t log[] = {\n" + ", ".join(f"0x{byte:02x}" for byte in data) + "\n};\n",
        json.dumps({"type": "Buffer", "data": list(data)}),
        json.dumps({"payload": data.hex()}),
        f"<Buffer {data.hex(' ')}>",
    ):
        (tmp_path / "log.txt").write_text(text)
        assert len(text) > 1 << 16 and b"".join(inputs.chunks(str(tmp_path / "log.txt"))) == data, text[:40]


def test_dumps_of_any_bytes() -> None:
    """The column of text is not part of the bytes, whatever it contains."""
    data = b"ue" + random.Random(7).randbytes(70_000) + bytes(range(0x30, 0x3A)) * 500 + bytes(3)
    for name in ("xxd", "hexdump -C", "Wireshark"):
        assert from_text(lines(FORMS[name], data=data).encode()) == data, name
    zeros = b"00000000  75 65 80 00  ..|\n00000004  00 00 00 00  ..|\n*\n00000010\n"
    assert from_text(zeros) == b"ue\x80" + bytes(13)


#: Text of a console or of another program.
TEXTS = [
    "123", "12345.5", '"123"', '{"a":5}', "boot at 12 :30\nready", "1024.5\r\n", "12:30 :30 ok\r\n", "{}", "null",
    "[1]", "1e999", '""', "f(f(7))", "<a 7>", ":", ":00", "'",
    "7565 " * 13000 + "zz", "f(" * 9000, "[" * 9000, '{"a":' * 9000, "-", "0x", "* 1", "\\",
]  # fmt: skip


def test_ordinary_text_is_no_notation(tmp_path: Path) -> None:
    chance = random.Random(11)
    printable = [chr(byte) for byte in (*range(0x20, 0x7F), 10, 10, 34, 34, 58, 58, 91, 123)]
    for text in TEXTS + ["".join(chance.choices(printable, k=chance.randrange(1, 60))) for _ in range(200)]:
        assert from_text(text.encode()) is None, text[:40]
        assert not recognized(text.encode()).what.startswith("MIP"), text[:40]
    for text in TEXTS[:7]:
        (tmp_path / "log.txt").write_text(text)
        for command in ("info", "dump", "doctor"):
            code, _, error = mip(command, tmp_path / "log.txt")
            assert code == 1 and "Error:" not in error, error


def test_what_is_no_notation() -> None:
    for data in (b"", b"\n", b"hello, world", b"1,2,3\n4,5,6\n", (ROOT / "README.md").read_bytes(), STREAM, bytes(99)):
        assert from_text(data) is None, data[:40]


def ubx(size: int) -> bytes:
    return b"\xb5\x62\x01\x07" + struct.pack("<H", size) + bytes(size) + b"\x12\x34"


def single_byte(body: bytes) -> bytes:
    return body + struct.pack(">H", sum(body) & 0xFFFF)


def swapped(data: bytes) -> bytes:
    return b"".join(data[at : at + 2][::-1] for at in range(0, len(data), 2))


OTHERS = {
    "no bytes": b"",
    "nothing but the byte 00": bytes(500),
    "nothing but the byte FF": b"\xff" * 500,
    "a gzip file": gzip.compress(STREAM),
    "a network capture": b"\xd4\xc3\xb2\xa1" + bytes(99),
    "NMEA": b"$GPZDA,,,,,,*48\r\n" * 9,
    "NMEA sentences, with wrong": b"$GPZDA,,,,,,*49\r\n" * 9,
    "UBX": ubx(92) + ubx(8) + ubx(92) + ubx(20),
    "RTCM 3": (b"\xd3\x00\x13" + b"\x3e" * 19 + b"abc") * 4,
    "SBF": (b"$@\x12\x34\xa7\x0f" + struct.pack("<H", 40) + bytes(32)) * 4,
    "the single-byte protocol": b"xx"
    + b"".join(single_byte(b"\xcc" + random.Random(i).randbytes(76)) for i in range(4)),
    "text: 'rebooting the modem'": b"rebooting the modem\nready\n",
    "a table of text": b"time,x,y\n1,2,3\n4,5,6\n",
    "MIP as text": " ".join(PAIRS).encode(),
    "MIP with 0D before each 0A": (STREAM + log(3)).replace(b"\n", b"\r\n"),
    "MIP encoded as UTF-8 text": STREAM.decode("latin-1").encode("utf-8"),
    "MIP that was read as UTF-8": STREAM.decode("utf-8", "replace").encode("utf-8"),
    "MIP without the upper bit": bytes(byte & 0x7F for byte in STREAM),
    "MIP with a byte inserted behind": STREAM.decode("latin-1").encode("utf-16-le"),
    "MIP with a byte inserted before": STREAM.decode("latin-1").encode("utf-16-be"),
    "MIP with the bytes of each 16-bit word swapped": swapped(STREAM),
    "MIP with all bits inverted": bytes(byte ^ 0xFF for byte in STREAM),
    "neither MIP nor a known protocol": random.Random(3).randbytes(2000),
}


@pytest.mark.parametrize("what", OTHERS)
def test_what_is_no_log_is_named_with_the_next_step(what: str, tmp_path: Path) -> None:
    found = recognized(OTHERS[what])
    assert found.what.startswith(what) and found.remedy, found
    (tmp_path / "log.bin").write_bytes(OTHERS[what])
    if what != "MIP as text" and not count_packets(OTHERS[what]):
        for command in ("info", "dump", "doctor"):
            code, out, error = mip(command, tmp_path / "log.bin")
            assert code == 1 and (found is UNKNOWN or found.what in out + error), out + error


def test_noise_is_nothing_known() -> None:
    for seed in range(20):
        assert recognized(random.Random(seed).randbytes(5000)) is UNKNOWN


def test_a_packet_without_its_checksum() -> None:
    packet = without_checksum(bytes.fromhex("7565 0102 0201"))
    assert packet is not None and bytes(packet).hex() == "756501020201e0c6"  # as printed in the manual
    assert without_checksum(bytes.fromhex("7565 0102 0301")) is None  # a field that does not fit
    code, out, error = mip("dump", "75 65 01 02 02 01")
    assert code == 0 and "base.ping (0x01,0x01)" in out and error == "mip dump: without checksum; it would be e0 c6\n"
    assert "1 packet, none with these fields" in mip("dump", "756501020201", "--only", "sensor")[2]
