"""What faults do to bytes and to fields. All choices come from the random generator of the caller."""

from __future__ import annotations

from functools import cache
from random import Random

from ..errors import DecodeError
from ..field import Field, Response, chosen
from ..packet import MAX_PAYLOAD, SYNC, PacketBuilder, RawField
from ..parser import Parser
from ..protocol import AckCode, Acknowledge
from ..registry import MODULES, all_types, types

ACKNOWLEDGE = Acknowledge.DESCRIPTOR

# --------------------------------------------------------------------------- bytes


def damage(kind: str, packet: bytes, most: int, random: Random) -> tuple[bytes, str]:
    """A packet that is one no longer, and what happened to it."""
    for _ in range(100):
        size = random.randint(1, min(most, len(packet)))
        at = random.randrange(len(packet) - size + 1)
        if kind == "lose":
            made, what = packet[:at] + packet[at + size :], f"{size} bytes at {at} are lost"
        elif kind == "cut":
            at = random.randrange(1, len(packet))
            made, what = packet[:at], f"{len(packet) - at} bytes at the end are lost"
        elif kind == "double":
            made, what = packet[: at + size] + packet[at:], f"{size} bytes at {at} come twice"
        else:
            made, what = _changed(packet, size, random)
        if made != packet and not packets(made):
            return made, what
    return packet[:-1], "1 byte at the end is lost"


def _changed(packet: bytes, count: int, random: Random) -> tuple[bytes, str]:
    made = bytearray(packet)
    places = sorted(random.sample(range(len(packet)), count))
    for at in places:
        made[at] ^= random.randrange(1, 256)
    return bytes(made), f"bytes are changed at {', '.join(map(str, places))}"


def packets(stream: bytes) -> list[bytes]:
    """The packets that a parser finds."""
    parser = Parser()
    return [bytes(p) for p in parser.feed(stream) + parser.flush()]


def noise(most: int, random: Random) -> bytes:
    """Random bytes, with what packets begin with more often than by chance; no packet is in them."""
    while True:
        made = bytearray(random.randbytes(random.randint(1, most)))
        if random.random() < 0.25:
            made[-2:] = SYNC
        if not packets(bytes(made)):
            return bytes(made)


def false_header(random: Random) -> bytes:
    """The start of a packet of a known set, with a plausible length; perhaps the start of a field."""
    payload = random.randrange(2, MAX_PAYLOAD + 1)
    made = SYNC + bytes((random.choice(sorted(MODULES)), payload))
    field = bytes((random.randrange(2, payload + 1), random.randrange(1, 256)))
    return made + field[: random.randrange(3)]


def nmea(random: Random) -> bytes:
    """An NMEA sentence as a receiver beside the device may send it."""
    clock = f"{random.randrange(24):02}{random.randrange(60):02}{random.randrange(60):02}.00"
    north, east = random.randrange(9000), random.randrange(18000)
    text = random.choice(
        (
            f"GPZDA,{clock},01,01,2024,00,00",
            f"GPHDT,{random.randrange(3600) / 10:.1f},T",
            f"GPGGA,{clock},{north:04}.0000,N,{east:05}.0000,E,1,08,1.0,100.0,M,0.0,M,,",
        )
    )
    check = 0
    for byte in text.encode():
        check ^= byte
    return f"${text}*{check:02X}\r\n".encode()


def unknown_packet(random: Random) -> bytes:
    """A right packet of a descriptor set that the specification does not have."""
    number = random.choice([n for n in range(0x80, 0xFF) if n not in MODULES])
    builder = PacketBuilder(number)
    for _ in range(random.randint(1, 3)):
        builder.add(random.randrange(1, 0xD0), random.randbytes(random.randrange(24)))
    return bytes(builder.build())


# --------------------------------------------------------------------------- fields


def room(fields: list[RawField]) -> int:
    """The bytes that a packet with these fields has left."""
    return MAX_PAYLOAD - sum(len(f.data) + 2 for f in fields)


def unknown_field(set: int, fields: list[RawField], random: Random) -> RawField | None:
    """A field with a descriptor that the set does not have; None if the packet is full."""
    size = min(room(fields) - 2, random.randrange(24))
    if size < 0:
        return None
    first, last = (0x80, 0xF0) if set < 0x80 else (0x01, 0xCF)
    free = [d for d in range(first, last + 1) if not types(set, d)]
    return RawField(set, random.choice(free), random.randbytes(size)) if free else None


def longer(
    fields: list[RawField], places: range, most: int, random: Random
) -> tuple[int, RawField] | None:
    """A field with bytes after its known parameters, as newer firmware sends it, and its place.

    Only where the bytes can be nothing else: not in arrays that reach to the end of the field, nor
    where the size chooses between layouts. None if there is no such field, or no room.
    """
    for at in random.sample(places, len(places)):
        raw = fields[at]
        count = min(random.randint(1, most), room(fields), 253 - len(raw.data))
        made = raw._replace(data=raw.data + random.randbytes(max(count, 0)))
        old, new = _left_over(raw), _left_over(made)
        if count > 0 and old is not None and new is not None and new - old == count:
            return at, made
    return None


def _left_over(raw: RawField) -> int | None:
    kind = chosen(types(raw.set, raw.descriptor), raw)
    try:
        return None if kind is None else kind.decode_with_trailing(raw.data)[1]
    except DecodeError:
        return None


def shorter(raw: RawField, random: Random) -> RawField | None:
    """A response that is too short for every layout of it; None if it cannot be."""
    for size in random.sample(range(len(raw.data)), len(raw.data)):
        made = raw._replace(data=raw.data[:size])
        if all(_truncated(t, made.data) for t in types(raw.set, raw.descriptor)):
            return made
    return None


def _truncated(kind: type[Field], data: bytes) -> bool:
    try:
        kind.decode(data)
    except DecodeError:
        return True
    return False


def refusal(command: RawField, random: Random) -> RawField:
    code = random.choice([c for c in AckCode if c])
    return acknowledge(command.set, command.descriptor, code)


def acknowledge(set: int, descriptor: int, code: int) -> RawField:
    return RawField(set, ACKNOWLEDGE, bytes((descriptor, code)))


def other_descriptor(not_these: set[int], random: Random) -> int:
    """The descriptor of another command, known or not."""
    return random.choice([d for d in range(1, 0x80) if d not in not_these])


@cache
def responses(set: int) -> tuple[type[Response], ...]:
    return tuple(t for n, t in all_types() if n == set and issubclass(t, Response))


def other_response(raw: RawField, seen: dict[int, RawField], random: Random) -> RawField:
    """The response of another command: one that was sent before, else one of that descriptor."""
    sent = [f for d, f in sorted(seen.items()) if d != raw.descriptor and f.set == raw.set]
    if sent:
        return random.choice(sent)
    known = sorted({t.DESCRIPTOR for t in responses(raw.set)} - {raw.descriptor})
    descriptor = random.choice(known) if known else raw.descriptor ^ 1
    return RawField(raw.set, descriptor, random.randbytes(len(raw.data)))


def unused_response(raw: RawField, random: Random) -> RawField:
    """The same data under a descriptor that no response of the set has."""
    used = {t.DESCRIPTOR for t in responses(raw.set)} | {ACKNOWLEDGE}
    free = [d for d in range(0x80, 0xF0) if d not in used]
    return raw._replace(descriptor=random.choice(free))


def garbage(raw: RawField, random: Random) -> RawField:
    """Other data of the same size."""
    while True:
        made = raw._replace(data=random.randbytes(len(raw.data)))
        if made != raw or not raw.data:
            return made
