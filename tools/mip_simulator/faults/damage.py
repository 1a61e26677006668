"""Effects of faults on bytes. All choices come from the random generator of the caller."""

from __future__ import annotations

from random import Random

from mip_tools.binding import MAX_PAYLOAD, MODULES, SYNC, PacketBuilder, Parser
from mip_tools.sentences import nmea_sentence


def damage_packet(kind: str, packet: bytes, most: int, random: Random) -> tuple[bytes, str]:
    """Damages a packet. Returns the result, which is no longer valid, and a description of the damage."""
    for _ in range(100):
        size = random.randint(1, min(most, len(packet)))
        at = random.randrange(len(packet) - size + 1)
        if kind == "lose":
            made, what = packet[:at] + packet[at + size :], f"{size} bytes at {at} are lost"
        elif kind == "cut":
            at = random.randrange(1, len(packet))
            made, what = packet[:at], f"{len(packet) - at} bytes at the end are lost"
        elif kind == "double":
            made, what = packet[: at + size] + packet[at:], f"{size} bytes at {at} arrive twice"
        else:
            made, what = _changed(packet, size, random)
        if made != packet and not parsed_packets(made):
            return made, what
    return packet[:-1], "1 byte at the end is lost"


def _changed(packet: bytes, count: int, random: Random) -> tuple[bytes, str]:
    made = bytearray(packet)
    places = sorted(random.sample(range(len(packet)), count))
    for at in places:
        made[at] ^= random.randrange(1, 256)
    return bytes(made), f"bytes are changed at {', '.join(map(str, places))}"


def parsed_packets(stream: bytes) -> list[bytes]:
    """Returns the packets that a parser finds."""
    parser = Parser()
    return [bytes(p) for p in parser.feed(stream) + parser.flush()]


def noise(most: int, random: Random) -> bytes:
    """Makes random bytes that contain no packet, but more of the bytes that begin packets than by chance."""
    while True:
        made = bytearray(random.randbytes(random.randint(1, most)))
        if random.random() < 0.25:
            made[-2:] = SYNC
        if not parsed_packets(bytes(made)):
            return bytes(made)


def false_header(random: Random) -> bytes:
    """Makes the header of a packet with a known set and a plausible length; the start of a field may follow."""
    payload = random.randrange(2, MAX_PAYLOAD + 1)
    made = SYNC + bytes((random.choice(sorted(MODULES)), payload))
    field = bytes((random.randrange(2, payload + 1), random.randrange(1, 256)))
    return made + field[: random.randrange(3)]


def make_nmea(random: Random) -> bytes:
    """Makes an NMEA sentence, such as a GNSS receiver sends on the same line."""
    clock = f"{random.randrange(24):02}{random.randrange(60):02}{random.randrange(60):02}.00"
    north, east = random.randrange(9000), random.randrange(18000)
    text = random.choice(
        (
            f"GPZDA,{clock},01,01,2024,00,00",
            f"GPHDT,{random.randrange(3600) / 10:.1f},T",
            f"GPGGA,{clock},{north:04}.0000,N,{east:05}.0000,E,1,08,1.0,100.0,M,0.0,M,,",
        )
    )
    return nmea_sentence(text).encode()


def unknown_packet(random: Random) -> bytes:
    """Makes a valid packet with a descriptor set that the specification does not define."""
    number = random.choice([n for n in range(0x80, 0xFF) if n not in MODULES])
    builder = PacketBuilder(number)
    for _ in range(random.randint(1, 3)):
        builder.add(random.randrange(1, 0xD0), random.randbytes(random.randrange(24)))
    return bytes(builder.build())
