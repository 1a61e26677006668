"""Recognizes bytes: MIP as text in any notation, MIP that is damaged or wrapped, and what else arrives at a port."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from .. import sentences
from ..binding import OVERHEAD, SYNC, Packet, Parser, checksum
from ..errors import Failure

#: Bytes that are examined.
MOST = 1 << 16
#: Bytes in which packets are searched at once.
_PART = 1 << 22
_TEXT = frozenset({*b"\t\n\f\r", *range(0x20, 0x7F)})


class Recognized(NamedTuple):
    """What bytes are, and what to do next."""

    what: str
    remedy: str

    def __str__(self) -> str:
        return f"{self.what}; {self.remedy}"


def recognized(data: bytes) -> Recognized:
    """Says what bytes without MIP packets are."""
    data = data[:MOST]
    return next(filter(None, (ask(data) for ask in _QUESTIONS)), UNKNOWN)


def no_packets(name: str, begin: bytes) -> Failure:
    """Returns the error that says what a log without packets is."""
    return Failure(f"{'standard input' if name == '-' else name} has no packets: {recognized(begin)}")


def begin_of(log: Any) -> bytes:
    """Returns the first bytes of an open log."""
    begin: bytes = log.source.piece(0, min(log.size, MOST), 0)[0].tobytes()
    return begin


def need_packets(name: str, log: Any) -> None:
    """Raises Failure if an open log has no packets."""
    if not any(part.packets for part in log.parts(_PART)):  # log.packets would store the offset of each one
        raise no_packets(name, begin_of(log))


UNKNOWN = Recognized("neither MIP nor a known protocol", "is the baud rate right?")


def count_packets(data: bytes) -> int:
    """Counts the packets in bytes."""
    parser = Parser()
    return len(parser.feed(data)) + len(parser.flush())


def without_checksum(data: bytes) -> Packet | None:
    """Completes a packet of which only the checksum is missing; None if the bytes are anything else."""
    if not data.startswith(SYNC) or len(data) < 4 or len(data) != data[3] + OVERHEAD - 2:
        return None
    packet = Packet(data + checksum(data))
    return packet if packet.malformed is None else None


# --------------------------------------------------------------------------- MIP as text


def from_text(text: bytes) -> bytes | None:
    """Converts bytes that a program, a language or a terminal has printed; None if this is no such text.

    What a notation makes of it counts if it begins as a packet, or else contains one. The end of the text may be cut
    off.
    """
    text = text.removeprefix(b"\xef\xbb\xbf")
    begin = text[:MOST]
    if begin[:2] in (b"\xff\xfe", b"\xfe\xff"):  # of PowerShell
        return from_text(text.decode("utf-16", "replace").encode("ascii", "replace"))
    if not begin or not _TEXT.issuperset(begin):
        return None
    return _first(text.decode("ascii", "replace"), _NOTATIONS)


def _first(text: str, notations: Sequence[Callable[[str], bytes | None]]) -> bytes | None:
    begun: bytes | None = None  # a log may begin within a packet, and an offset looks like bytes
    for notation in notations:
        try:
            data = notation(text)
        except (ValueError, TypeError, StopIteration, RecursionError):  # as JSON with too many brackets
            continue
        if data is not None and data.startswith(SYNC):
            return data
        if begun is None and data is not None and count_packets(data):
            begun = data
    return begun


def _hex(words: Iterable[str]) -> bytes:
    """Converts words of one or two digits, or of whole bytes."""
    plain = [word.removeprefix("0x").removeprefix("0X") for word in words]
    return bytes.fromhex("".join(word.zfill(2) for word in plain))


def _words(text: str) -> bytes:
    """`75 65 80 E`, `0x75, 0x65`, `75-65-80`, `75:65`, `75.65`, `7565 800e`, `0x7565_800e`."""
    return _hex(re.findall(r"[^\s,;:._-]+", text))


def _numbers(text: str) -> bytes:
    """`[117, 101, 128]`, `117 101 128`; negative ones are signed bytes."""
    return bytes(int(word) & 0xFF for word in re.findall(r"[^\s,;\[\](){}]+", text.rstrip("-")))


def _items(text: str) -> bytes:
    """Numbers of a list among words: `array([117, 101], dtype=uint8)`, `[117u8, 101]`, lines with `- 117` of YAML."""
    return bytes(int(word) & 0xFF for word in re.findall(r"(?<![\w.])(-?\d{1,3})(?:u8)?(?![\w.])", text))


def _prefixed(text: str) -> bytes:
    """Bytes with a prefix among offsets, indexes and times without one: `buf[12] = 0x75`, `0x7ffe40: 0x75 0x65`."""
    find = re.compile(r"(?:\b0x|&h)([0-9a-f]{1,2})(?!\w)", re.I).findall
    return _hex(find(re.sub(r"//.*|/\*(?s:.*?)\*/", "", text)) or find(text))


def _array(text: str) -> bytes | None:
    """`uint8_t packet[] = { 0x75, 'e', (byte)0x80 };  // comment`."""
    inner = re.search(r"[{\[(]([^{}\[\]()]*)(?:[}\])]\s*;?\s*)?\Z", re.sub(r"//.*|/\*.*?\*/|\(\w+\)", "", text))
    words = re.findall(r"0[xX][0-9a-fA-F]{1,2}|'.'|\b\d{1,3}\b", inner[1]) if inner else []
    return bytes(ord(w[1]) if w[0] == "'" else int(w, 0) for w in words) or None


def _escapes(text: str) -> bytes | None:
    r"""`b'ue\x80\x0e'` of Python, `"\x75\x65"` of C, `ue\200\016` of a shell."""
    if "\\" not in text:
        return None
    inner = re.search(r"""(['"])(.*)\1""", text, re.S)
    single = {"n": 10, "r": 13, "t": 9, "a": 7, "b": 8, "f": 12, "v": 11, "e": 27}

    def plain(match: re.Match[str]) -> str:
        hexadecimal, octal, letter = match.groups()
        return chr(int(hexadecimal, 16) if hexadecimal else int(octal, 8) if octal else single.get(letter, ord(letter)))

    joined = re.sub(r"""["']\s+b?["']""", "", inner[2] if inner else text.strip())
    return re.sub(r"\\(?:x([0-9a-fA-F]{1,2})|([0-7]{1,3})|(.))", plain, joined).encode("latin-1")


def _base64(text: str) -> bytes:
    plain = "".join(text.split())
    return base64.b64decode(plain[: len(plain) & ~3], validate=True)


def _json(text: str) -> bytes | None:
    """A list of numbers or a text, in any object, as Node prints a buffer."""
    try:
        found = json.loads(text)
    except ValueError:  # the end may be missing
        cut = re.search(r'\[([\d,\s]*)\Z|"([^"\\]*)\Z', text)
        return _first(cut[1] or cut[2][: len(cut[2]) & ~3], _PLAIN) if cut else None
    while isinstance(found, dict) and found:
        found = found["data"] if "data" in found else next(iter(found.values()))
    if isinstance(found, list):
        return bytes(found)
    return _first(found, _PLAIN) if isinstance(found, str) else None


def _buffer(text: str) -> bytes | None:
    """`<Buffer 75 65 80>` of Node, `bytearray(b'…')`, `QByteArray("…")`: what is inside."""
    inner = re.fullmatch(r"\s*(?:<\w+ ([^<>]*)>?|\w+\((.*?)\)?)\s*", text, re.S)
    return _first(inner[1] or inner[2] or "", _PLAIN) if inner else None


#: Bytes or groups of them, before the end of a line or a column of text.
_DUMPED = re.compile(r"((?:[0-9a-fA-F]{2})+(?:(?: {1,2}| ?- ?)(?:[0-9a-fA-F]{2})+)*)(?=\s*$|\s{2,}|\s*[|>;])")
#: What precedes them: an offset, a time or a name.
_PREFIX = re.compile(
    r"[0-9a-fA-F`]{4,17}h?:?\s{1,4}(?=[0-9a-fA-F]{2})|(?:[\])>#:=]|//|\s-\s)\s*(?=[0-9a-fA-F]{2})|^\s*(?=[0-9a-fA-F]{2})"
)
_TIME = re.compile(r"\d\d?:\d\d:\d\d[.,\d]*(?:Z|[+-]\d\d:?\d\d)?(?=\s)")


#: Characters in which a prefix begins: to try each place of a long line would take minutes.
_MOST_PREFIX = 120
_OFFSET = re.compile(r"\s*(?:0x)?([0-9a-fA-F`]{4,17})(?=h?[:\s]|\Z)")


def _dump(text: str) -> bytes | None:
    """Lines of `xxd`, `hexdump -C`, Wireshark, `candump` or a terminal: an offset, a time or a name, and bytes.

    Half of the lines may be other text, such as a heading.
    """
    rows: list[tuple[int, bytes]] = []  # with their offsets, if these are offsets
    repeated = set()
    lines = [line for line in text.splitlines() if line.strip()]
    others = 0
    for number, line in enumerate(lines):
        if line.strip() == "*" and rows:  # the last row is repeated up to the next offset
            repeated.add(len(rows) - 1)
            continue
        prefixed = _OFFSET.match(line)
        offset = int(prefixed[1].replace("`", ""), 16) if prefixed else 0
        alone = rows and re.fullmatch(r"\s*[0-9a-fA-F]{4,16}\s*", line)
        if alone and (len(line.strip()) > 6 or offset == rows[-1][0] + len(rows[-1][1])):
            rows.append((offset, b""))  # the size at the end
            continue
        line = _TIME.sub("]", line)
        found = (_DUMPED.match(line, prefix.end()) for prefix in _PREFIX.finditer(line, 0, _MOST_PREFIX))
        row = max((match[1] for match in found if match), key=len, default=None)
        if row is None and rows and number == len(lines) - 1 and not text.endswith("\n"):
            break  # the line is cut off
        if row is None:
            others += 1
            continue
        rows.append((offset, bytes.fromhex(row.replace("-", ""))))
    if others > len(rows):
        return None
    data, size = bytearray(), 0
    for number, ((offset, row), (following, _)) in enumerate(pairwise([*rows, (0, b"")])):
        size = following - offset if number < len(rows) - 1 else size
        if number in repeated and row:
            row *= max(size // len(row), 1)
        elif size <= len(row) <= size + size // 2:
            row = row[:size]  # without hexadecimal digits of the column of text
        data += row
    return bytes(data)


def _intel(text: str) -> bytes:
    """Records of Intel HEX."""
    records = [bytes.fromhex(line[1:]) for line in text.split() if line.startswith(":")]
    return b"".join(record[4:-1] for record in records if len(record) > 4 and record[3] == 0)


_PLAIN: tuple[Callable[[str], bytes | None], ...] = (
    _words, _dump, _numbers, _escapes, _array, _base64, _intel, _prefixed, _items,
)  # fmt: skip
_NOTATIONS = (*_PLAIN, _json, _buffer)


# --------------------------------------------------------------------------- MIP that is damaged or wrapped


def _damaged(data: bytes) -> Recognized | None:
    """MIP that a program on its way has changed in a regular way."""
    if (plain := from_text(data)) is not None:
        return Recognized(f"MIP as text, {len(plain)} bytes", "`mip dump` shows it")
    for change, what, remedy in _CHANGES:
        try:
            found = count_packets(change(data))
        except (ValueError, IndexError):
            continue
        if found > count_packets(data):
            return Recognized(what, remedy)
    if (packet := without_checksum(data)) is not None:
        return Recognized("a packet without its checksum", f"it would be {bytes(packet)[-2:].hex(' ')}")
    syncs = data.count(SYNC)
    if syncs > 1 and data.count(b"\xef\xbf\xbd") > syncs:
        return Recognized("MIP that was read as UTF-8 text, and has lost bytes", "read the port in binary mode")
    if syncs > 1 and max(data) < 0x80:
        return Recognized("MIP without the upper bit of each byte", "set the port to 8 data bits, no parity")
    for lost, who, remedy in _LOST if syncs > 1 else ():
        others = [(byte + away) & 0xFF for byte in lost for away in (-1, 1) if (byte + away) & 0xFF not in lost]
        if not any(byte in data for byte in lost) and min(map(data.count, others)) > 8:
            return Recognized(
                f"MIP without the byte{'s' * (len(lost) > 1)} {lost.hex(' ').upper()}, which {who}", remedy
            )
    return None


#: Bytes that a program or a driver removes, which, and what to do.
_LOST = (
    (b"\x11\x13", "software flow control (XON/XOFF) has removed", "turn it off at the port"),
    (b"\r", "a text mode has removed", "read and transfer it in binary mode"),
    (b"\n", "a text mode has removed", "read and transfer it in binary mode"),
    (b"\0", "a program that reads text has removed", "read the port in binary mode"),
)


def _swapped(data: bytes) -> bytes:
    swapped = bytearray(data[: len(data) & ~1])
    swapped[::2], swapped[1::2] = data[1::2], data[: len(data) & ~1 : 2]
    return bytes(swapped)


_BINARY = "transfer the log in binary mode; `mip cut` keeps what is intact"
#: A change that makes more packets of the bytes, what it shows, and what to do.
_CHANGES: tuple[tuple[Callable[[bytes], bytes], str, str], ...] = (
    (lambda data: data.replace(b"\r\n", b"\n"), "MIP with 0D before each 0A, as a text mode inserts it", _BINARY),
    (lambda data: data.replace(b"\r\0", b"\r"), "MIP with 00 behind each 0D, as Telnet inserts it", "use raw TCP"),
    (lambda data: data.replace(b"\xff\xff", b"\xff"), "MIP with FF doubled, as Telnet does it", "use raw TCP"),
    (lambda data: data.decode("utf-8").encode("latin-1"), "MIP encoded as UTF-8 text", "write it in binary mode"),
    (lambda data: data[::2], "MIP with a byte inserted behind each byte", "write bytes, not 16-bit characters"),
    (lambda data: data[1::2], "MIP with a byte inserted before each byte", "write bytes, not 16-bit characters"),
    (_swapped, "MIP with the bytes of each 16-bit word swapped", "write bytes, not 16-bit words"),
    (lambda data: bytes(b ^ 0xFF for b in data), "MIP with all bits inverted", "convert RS-232 levels to TTL"),
    (
        lambda data: data.replace(b"\xc0", b"").replace(b"\xdb\xdc", b"\xc0").replace(b"\xdb\xdd", b"\xdb"),
        "MIP in SLIP frames",
        "decode SLIP first",
    ),
)  # fmt: skip


# --------------------------------------------------------------------------- anything else

_FILES = {
    b"\x1f\x8b": ("a gzip file", "`gunzip -c FILE | mip info -`"),
    b"PK\3\4": ("a ZIP file", "unpack it"),
    b"\x28\xb5\x2f\xfd": ("a Zstandard file", "`zstd -dc FILE | mip info -`"),
    b"\xfd7zXZ": ("an XZ file", "`xz -dc FILE | mip info -`"),
    b"BZh": ("a bzip2 file", "`bunzip2 -c FILE | mip info -`"),
    b"\x89MCAP0": ("an MCAP file", "it is read by Foxglove, not by mip"),
    b"PAR1": ("a Parquet file", "it is read by pandas, not by mip"),
    b"ARROW1": ("an Arrow file", "it is read by pandas, not by mip"),
    b"#ROSBAG": ("a ROS 1 bag", "its messages are not MIP"),
    b"SQLite format 3\0": ("a SQLite file, such as a ROS 2 bag", "its messages are not MIP"),
    b"\xd4\xc3\xb2\xa1": ("a network capture", "open it in Wireshark, and save the payload"),
    b"\x0a\x0d\x0d\x0a": ("a network capture", "open it in Wireshark, and save the payload"),
    b"\x93NUMPY": ("a NumPy array", "`numpy.load` reads it"),
    b"<?xml": ("XML", "save the bytes that the device sends"),
    b"<!DOCTYPE": ("a web page", "the download was not the log"),
    b"\x7fELF": ("a program", "name the log"),
}


def _file(data: bytes) -> Recognized | None:
    return next((Recognized(*about) for magic, about in _FILES.items() if data.startswith(magic)), None)


def _same(data: bytes) -> Recognized | None:
    if not data:
        return Recognized("no bytes", "is the device on, and does it stream?")
    if len(set(data)) == 1 and len(data) > 3:
        idle = data[0] in (0, 0xFF)
        remedy = "no signal, or a break: check the wiring and the levels" if idle else "is the baud rate right?"
        return Recognized(f"nothing but the byte {data[0]:02X}", remedy)
    return None


def _frames(data: bytes, sync: bytes, size: Callable[[bytes, int], int]) -> int:
    """Counts frames that follow each other: each begins with the sync, and the next one behind it."""
    count, at = 0, data.find(sync)
    while 0 <= at < len(data) - len(sync) - 8:
        following = at + size(data, at)
        if following > at and data[following : following + len(sync)] == sync:
            count += 1
            at = following
        else:
            at = data.find(sync, at + 1)
    return count


def _little(at: int, extra: int) -> Callable[[bytes, int], int]:
    return lambda data, begin: int.from_bytes(data[begin + at : begin + at + 2], "little") + extra


_CORRECTIONS = "corrections are for a receiver: route them to an input of the device"
_RECEIVER = "a GNSS receiver sends this: connect the port of the inertial sensor"
_PROTOCOLS: tuple[tuple[bytes, Callable[[bytes, int], int], str, str], ...] = (
    (b"\xd3", lambda d, at: 0 if d[at + 1] > 3 else (d[at + 1] << 8 | d[at + 2]) + 6, "RTCM 3", _CORRECTIONS),
    (b"\xb5\x62", _little(4, 8), "UBX of a u-blox receiver", _RECEIVER),
    (b"$@", _little(6, 0), "SBF of a Septentrio receiver", _RECEIVER),
    (
        b"\xaa\x44\x12",
        lambda d, at: d[at + 3] + int.from_bytes(d[at + 8 : at + 10], "little") + 4,
        "the OEM format of a NovAtel receiver",
        _RECEIVER,
    ),
    (b"\xff\x5a", _little(4, 9), "SBG's sbgECom", "another make of sensor: connect the MIP device"),
    (b"\xfa\xff", lambda d, at: d[at + 3] + 5, "Xsens's Xbus", "another make of sensor: connect the MIP device"),
)  # fmt: skip


def _protocol(data: bytes) -> Recognized | None:
    counts = {(what, remedy): _frames(data, sync, size) for sync, size, what, remedy in _PROTOCOLS}
    best = max(counts, key=lambda about: counts[about])
    return Recognized(*best) if counts[best] > 1 else None


def _single_byte(data: bytes) -> Recognized | None:
    """Two records of a 3DM-GX1 to GX3 in continuous mode: the last two bytes of each are the sum of the others."""

    def is_record(record: bytes) -> bool:
        return sum(record[:-2]) & 0xFFFF == int.from_bytes(record[-2:], "big")

    for at in range(min(len(data), 512)):
        for size in range(11, 112, 4) if 0xC0 <= data[at] < 0xE0 else ():
            one, other = data[at : at + size], data[at + size : at + 2 * size]
            if other[:1] == one[:1] and is_record(one) and is_record(other):
                remedy = "a device in a direct mode returns to MIP with `mip send PORT system.comm_mode write standard`"
                return Recognized("the single-byte protocol of a 3DM-GX3 or older", remedy)
    return None


def _sentences(data: bytes) -> Recognized | None:
    remedy = "enable MIP on the port, or use another port of the device"
    count = len(sentences.Sentences().feed(data + b"\n"))
    if count and data.count(b"$") + data.count(b"!") <= 4 * count:
        return Recognized("NMEA sentences", remedy)
    if re.search(rb"(?:^|\n)\$[A-Z]{4,6},[^\n]*\*[0-9A-F]{2}\r?(?:\n|$)", data):
        return Recognized("NMEA sentences, with wrong checksums", remedy)
    return None


def _text(data: bytes) -> Recognized | None:
    if len(data) < 8 or not _TEXT.issuperset(data):
        return None
    lines = data.splitlines()
    first = lines[0].decode("ascii")
    if len(lines) > 1 and first.count(",") > 1 and lines[1].count(b",") == lines[0].count(b","):
        return Recognized("a table of text", "name the log from which it was made")
    return Recognized(f"text: {first[:40]!r}", "name a log, or the port of a device")


_QUESTIONS: tuple[Callable[[bytes], Recognized | None], ...] = (
    _same, _file, _damaged, _sentences, _single_byte, _protocol, _text,
)  # fmt: skip


__all__ = ["MOST", "Recognized", "count_packets", "from_text", "recognized"]
