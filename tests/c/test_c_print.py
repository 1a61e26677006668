"""Compares the output of C's printer for fields and packets with the model."""

from __future__ import annotations

import math
import os
import random
import struct
import subprocess
from collections.abc import Iterator
from decimal import Decimal
from functools import cache, reduce
from pathlib import Path
from typing import Any

from c_build import HERE, SANITIZED, compiled
from mipgen import model as m
from mipgen.lower import codec
from random_values import drawn
from support import BUILD, SEED, all_fields, locked, model, rounds, set_of, small

ENOUGH = 1 << 17
Request = tuple[str, str, int, bytes]


@cache
def printer(spec: str) -> Path:
    out = BUILD / f"print-{spec}"
    with locked(out):
        made = compiled(out.with_suffix(f".{os.getpid()}"), spec, "cc", HERE / "unit/print.c", *SANITIZED)
        return made.replace(out)  # another process may be running it


def ask(spec: str, requests: list[Request]) -> list[tuple[int, str]]:
    """For each request (what, device, room, bytes): the length of the whole text, and the text in that room."""
    lines = "".join(f"{what} {device} {room} {data.hex()}\n" for what, device, room, data in requests)
    done = subprocess.run([str(printer(spec))], input=lines.encode(), capture_output=True)
    assert done.returncode == 0, done.stderr.decode()[-4000:]
    found, rest = [], done.stdout
    for _ in requests:
        head, _, rest = rest.partition(b"\n")
        length, size = map(int, head.split())
        found.append((length, rest[:size].decode("ascii")))
        rest = rest[size:]
    assert not rest
    return found


def texts(spec: str, what: str, data: list[bytes], device: str = "-") -> list[str]:
    found = ask(spec, [(what, device, ENOUGH, d) for d in data])
    assert found and all(length == len(text) for length, text in found)
    return [text for _, text in found]


# --------------------------------------------------------------------------- what should be printed


def real(bits: str) -> str:
    """A float or a double by its bits, as short as possible."""
    data = bytes.fromhex(bits.removeprefix("0x"))
    form = ">f" if len(data) == 4 else ">d"
    (value,) = struct.unpack(form, data)
    if not math.isfinite(value):
        return f"{value:g}"
    text = repr(value)  # all digits that a double needs
    for digits in range(9 if len(data) == 4 else 0):
        text = f"{value:.{digits}e}"
        try:
            if struct.pack(form, float(text)) == data:
                break
        except OverflowError:  # rounded up beyond the largest
            continue
    number = Decimal(text).normalize()
    if -4 <= number.adjusted() < 16:
        return f"{number:f}"
    return f"{number.scaleb(-number.adjusted()).normalize():f}e{number.adjusted()}"


def in_state(t: m.Bitfield, values: dict[str, Any]) -> list[m.Bits]:
    return [b for b in t.bits if b.when is None or values[b.when.parameter] in b.when.numbers]


def flags(t: m.Bitfield, value: int, size: int, values: dict[str, Any]) -> str:
    parts, bits = [], in_state(t, values)
    for b in bits:
        number = (value & b.mask) >> b.first
        if b.enum is not None:
            parts.append(f"{b.name}: {named(b.enum, number)}")
        elif b.width > 1:
            parts.append(f"{b.name}: {number}")
        elif number:
            parts.append(b.name)
    unknown = reduce(lambda left, b: left & ~b.mask, bits, value)
    if unknown:
        parts.append(f"0x{unknown:0{2 * size}X}")
    return f"0x{value:0{2 * size}X}" + (" = " if parts else "") + " | ".join(parts)


def named(t: m.Enum, value: int) -> str:
    known = next((v for v in t.values if v.value == value), None)
    return f"{known.name} ({value})" if known else str(value)


def quoted(text: str) -> str:
    out = ""
    for c in text:
        out += "\\" + c if c in '"\\' else c if " " <= c <= "~" else f"\\x{ord(c):02X}"
    return f'"{out}"'


def scalar(value: Any, s: m.Scalar, t: m.Type | m.Scalar | None, values: dict[str, Any]) -> str:
    if s.kind == "float":
        return real(value)
    if isinstance(t, (m.Enum, m.Bitfield)):
        unsigned = value % (1 << 8 * s.size)
        return named(t, unsigned) if isinstance(t, m.Enum) else flags(t, unsigned, s.size, values)
    if s.kind == "bool":
        return ("true" if value else "false") + (f" ({value})" if value > 1 else "")
    return quoted(chr(value)) if s.kind == "char" else str(value)


def meaning(p: m.Parameter, values: dict[str, Any], device: str) -> Any:
    for v in p.readings:
        if v.key == device if v.by_device else values.get(v.by, 0) == v.value:
            return v.type
    return p.element


def item(p: m.Parameter, value: Any, t: Any, values: dict[str, Any]) -> str:
    if p.kind == "text":
        return quoted(value)
    if p.kind == "bits" or (p.kind == "array" and isinstance(t, m.Bitfield) and t.scalar is None):
        return flags(t, int.from_bytes(bytes(value), "little"), t.size, values)
    if p.kind == "array":
        return "[" + ", ".join(item(p.item, v, t, values) for v in value) + "]"
    return scalar(value, p.scalar, t, values)


def lines(p: m.Parameter, values: dict[str, Any], device: str) -> Iterator[str]:
    """The lines of one parameter; those inside of it are indented."""
    if p.constant is not None:
        yield f"{p.name}: {p.constant}"
        return
    value = values[p.name]
    if p.element is None:
        case = next((c for c in p.cases if c.parameter is not None and c.parameter.name in value), None)
        yield f"{p.name}:" + ("" if case else " none")
        if case is not None and case.parameter is not None:
            yield from (f"  {line}" for line in lines(case.parameter, value, device))
    elif isinstance(p.element, m.Struct):
        if value == []:
            yield f"{p.name}: none"
        for i, one in enumerate([value] if p.length is None else value):
            yield f"{p.name}:" if p.length is None else f"{p.name}[{i}]:"
            for q in p.element.parameters:
                yield from (f"  {line}" for line in lines(q, one, device))
    else:
        unit = ", ".join(p.units)
        yield f"{p.name}: {item(p, value, meaning(p, values, device), values)}" + (
            f" {unit}" if unit not in ("", "1") else ""
        )


def hexadecimal(data: bytes) -> str:
    return "".join(f" {byte:02X}" for byte in data)


def field_text(of: m.Model, number: int, descriptor: int, data: bytes, device: str = "-") -> str:
    place = f"(0x{number:02X},0x{descriptor:02X})"
    candidates = of.candidates(number, descriptor)
    f = codec.choose(candidates, data)
    if f is None:
        error = "  error: layout\n" if candidates else ""
        return f"unknown {place}\n{error}  raw:{hexadecimal(data)}\n"
    head = f"{f.name_in(number)}: {f.role} {place}\n"
    try:
        values, trailing = codec.decode(f, data)
    except codec.CodecError as error:
        return f"{head}  error: {error.kind}\n  raw:{hexadecimal(data)}\n"
    body = [
        line for p in f.parameters if p.constant is not None or p.name in values for line in lines(p, values, device)
    ]
    if trailing:
        body.append(f"trailing:{hexadecimal(data[-trailing:])}")
    return head + "".join(f"  {line}\n" for line in body)


def packet_text(of: m.Model, packet: bytes) -> str:
    known = of.set(packet[2])
    name = f" {known.name}" if known else ""
    out = f"packet (0x{packet[2]:02X}){name}, {len(packet)} bytes\n"
    payload = packet[4:-2]
    while payload:
        size = payload[0]
        if size < 2 or size > len(payload):
            return f"{out}  error: field_length\n  raw:{hexadecimal(payload)}\n"
        text = field_text(of, packet[2], payload[1], payload[2:size])
        out += "".join(f"  {line}\n" for line in text.splitlines())
        payload = payload[size:]
    return out


# --------------------------------------------------------------------------- numbers


def test_numbers() -> None:
    """Special values, powers of two and of ten, the ends of subnormals, and many random bits."""
    of = random.Random(SEED)
    step = rounds(5, 1)  # a prime: each place of a bit is there
    singles = [n << 23 | tail for n in range(0, 256, step) for tail in (0, 1, 0x7FFFFF)]
    singles += [1, 2, 3, 0x7FFFFF, *(of.getrandbits(32) for _ in range(rounds(200, 20_000)))]
    doubles = [n << 52 | (0, 1, (1 << 52) - 1)[(n + SEED) % 3] for n in range(0, 2048, step)]
    doubles += [1, 2, 3, *(of.getrandbits(64) for _ in range(rounds(200, 20_000)))]
    doubles += [of.getrandbits(52) for _ in range(50)]
    readable = [*(float(f"1e{n}") for n in range(-323, 309, step)), *(n / 1000 for n in range(0, 3000, 7 * step))]
    readable += [2.0**53 + 2, 123456.789]
    doubles += [struct.unpack(">Q", struct.pack(">d", value))[0] for value in readable]
    for what, size, numbers in (("float", 4, singles), ("double", 8, doubles)):
        data = [(n ^ sign).to_bytes(size, "big") for n in numbers for sign in (0, 1 << 8 * size - 1)]
        for bits, text in zip(data, texts("invented", what, data), strict=True):
            wanted = real(bits.hex())
            if wanted == "nan":
                assert text == "nan"
                continue
            if size == 8 or (bits[1] << 1 | bits[2] | bits[3]) & 0xFF:
                assert text == wanted, bits.hex()
            assert struct.pack(">f" if size == 4 else ">d", float(text)) == bits, (bits.hex(), text)
            assert len(figures(text)) <= len(figures(wanted)), (text, wanted)


def figures(text: str) -> str:
    return text.lstrip("-").partition("e")[0].replace(".", "").strip("0")


def test_whole_numbers() -> None:
    values = [0, 1, -1, 9, 10, -10, (1 << 63) - 1, -(1 << 63), 12345678901234567]
    assert texts("invented", "signed", [v.to_bytes(8, "big", signed=True) for v in values]) == list(map(str, values))


# --------------------------------------------------------------------------- fields and packets


@small("programs of the real C library")
def test_every_example(spec: str) -> None:
    of = model(spec)
    packets = [e.packet for e in of.examples]
    assert len(packets) > 5
    assert texts(spec, "packet", packets) == [packet_text(of, p) for p in packets]


def packets(of: m.Model, fields: list[m.Field], count: int) -> Iterator[tuple[m.Field, bytes]]:
    for f in fields:
        for values in drawn(f, count):
            try:
                data = codec.encode(f, values)
                for number in (o.set for o in f.occurrences) if f.everywhere is None else [set_of(f, of)]:
                    yield f, codec.build(of, number, [(f.descriptor, data)])
            except codec.CodecError:
                continue  # too long for a field


@small("programs of the real C library")
def test_every_field(spec: str) -> None:
    """With random values, on every device that gives some values of it a meaning, and with trailing bytes."""
    of = model(spec)
    found = list(packets(of, all_fields(of), rounds(8, 40)))
    assert {f.full_name for f, _ in found} == {f.full_name for f in all_fields(of)}
    requests: list[Request] = []
    wanted = []
    for f, packet in found:
        devices = {v.key for p in f.parameters for v in p.readings if v.by_device}
        for device in ("-", "no-such-device", *sorted(devices)):
            for more in (b"", b"\x00\xff"):
                data = packet[6:-2] + more
                if len(data) <= m.MAX_FIELD_DATA:
                    whole = codec.build(of, packet[2], [(packet[5], data)])
                    requests.append(("field", device, ENOUGH, whole))
                    wanted.append(field_text(of, packet[2], packet[5], data, device))
    assert any("trailing:" in text for text in wanted)
    answers = ask(spec, requests)
    for request, text, (_, answer) in zip(requests, wanted, answers, strict=True):
        assert answer == text, request


@small("programs of the real C library")
def test_every_name(spec: str) -> None:
    """Every value of every enumeration, and every bit, wherever a field has it by itself."""
    of = model(spec)
    requests: list[Request] = []
    wanted: list[list[str]] = []
    for f in all_fields(of):
        values = max(drawn(f, 8), key=len)
        for p in f.parameters:
            if p.name not in values or p.length is not None:
                continue
            for key, t in [("-", p.element), *((v.key, v.type) for v in p.readings if v.by_device)]:
                for number, names in named_values(t, values):
                    packet = with_value(of, f, values, p, number)
                    if packet is not None:
                        requests.append(("field", key, ENOUGH, packet))
                        wanted.append(names)
    assert len(requests) > (400 if spec == "real" else 40)
    for (_, text), names in zip(ask(spec, requests), wanted, strict=True):
        assert all(name in text for name in names), (names, text)


def named_values(t: Any, values: dict[str, Any]) -> Iterator[tuple[Any, list[str]]]:
    if isinstance(t, m.Enum):
        yield from ((v.value, [f" {v.name} ({v.value})"]) for v in t.values)
    elif isinstance(t, m.Bitfield):
        ones = (1 << 8 * t.size) - 1
        yield (ones if t.scalar else [255] * t.size), [f" {b.name}" for b in in_state(t, values)]


def with_value(of: m.Model, f: m.Field, values: dict[str, Any], p: m.Parameter, value: Any) -> bytes | None:
    """A packet with that value; None if it selects or requires something else that is not there."""
    try:
        return codec.build(of, set_of(f, of), [(f.descriptor, codec.encode(f, {**values, p.name: value}))])
    except codec.CodecError:
        return None


# --------------------------------------------------------------------------- what is wrong


@small("programs of the real C library")
def test_garbage(spec: str) -> None:
    """Whatever the payload is: fields with random data, and with impossible lengths."""
    of, dice = model(spec), random.Random(5)
    numbers = [s.number for s in of.sets] + [0x7F]
    places = [(o.set, f.descriptor) for f in of.fields if f.everywhere is None for o in f.occurrences]
    made = []
    for _ in range(1500):
        number, descriptor = dice.choice(places) if dice.random() < 0.8 else (dice.choice(numbers), dice.randrange(256))
        fields = [(descriptor, dice.randbytes(dice.randrange(60))), (dice.randrange(256), dice.randbytes(3))]
        whole = bytearray(codec.build(of, number, fields))
        made.append(bytes(whole))
        whole[4] = dice.choice([0, 1, 255, len(whole) - 3])
        made.append(bytes(whole))
    answers = texts(spec, "packet", made)
    for data, text in zip(made, answers, strict=True):
        assert text == packet_text(of, data), data.hex()
    together = "".join(answers)
    for word in ("truncated", "constant", "layout", "field_length", "unknown", "trailing"):
        assert word in together or (spec, word) == ("real", "constant"), word


def test_a_buffer_that_is_too_small() -> None:
    """It gets the beginning, in whole characters, and the caller the length of the whole text."""
    of = model("invented")
    packet = of.examples[0].packet
    whole = packet_text(of, packet)
    rooms = [*range(len(whole) + 3), 10 * len(whole)]
    answers = ask("invented", [("packet", "-", room, packet) for room in rooms])
    assert answers == [(len(whole), whole[: max(0, room - 1)]) for room in rooms]
