"""The bytes that the C programs are measured with: always the same ones."""

from __future__ import annotations

from random import Random

from mipgen import model as m
from mipgen.lower import codec

#: The packets of one cycle of a log, as an inertial sensor with a filter sends them; 44 bytes on average.
CYCLE = (
    ("sensor.scaled_accel", "sensor.scaled_gyro", "sensor.gps_timestamp"),
    ("sensor.delta_theta", "sensor.delta_velocity"),
    ("filter_data.timestamp", "filter_data.attitude_quaternion"),
    ("filter_data.llh_position", "filter_data.ned_velocity"),
    ("filter_data.linear_accel", "filter_data.comp_angular_rate", "filter_data.status"),
)

#: The packets of one cycle of a recording. As in practice, shared fields have the time of most packets: they are 43 %
#: of all fields.
RECORDED = (
    ("shared.gps_timestamp", "shared.reference_timestamp", "sensor.scaled_accel", "sensor.scaled_gyro"),
    ("shared.reference_timestamp", "shared.reference_time_delta", "sensor.delta_theta", "sensor.delta_velocity"),
    ("shared.gps_timestamp", "shared.reference_timestamp", "filter_data.attitude_quaternion", "filter_data.status"),
    ("shared.gps_timestamp", "filter_data.llh_position", "filter_data.ned_velocity"),
    ("shared.event_source", "shared.reference_timestamp", "filter_data.linear_accel", "filter_data.comp_angular_rate"),
    ("sensor.scaled_accel", "sensor.scaled_gyro"),
)

#: Receivers rarely send lower case, but the first sync byte of MIP is a lower-case u.
SENTENCES = (
    "GPGGA,{:06d}.00,4807.{:04d},N,01131.{:04d},E,4,12,0.9,545.4,M,46.9,M,1.2,0000",
    "GPRMC,{:06d}.00,A,4807.{:04d},N,01131.{:04d},E,022.4,084.4,230394,003.1,W",
    "GPGSV,3,1,12,{:06d},{:04d},{:04d},46,21,67,301,45,10,12,055,34,31,22,120,41",
    "GNTXT,01,01,02,u-blox AG - www.u-blox.com {:06d} {:04d} {:04d}",
)


def log(model: m.Model, size: int, cycle: tuple[tuple[str, ...], ...] = CYCLE) -> bytes:
    """Packets with random values; each has the descriptor set of its last field."""
    random, out = Random(1), bytearray()
    fields = {f.full_name: f for f in model.fields}
    while len(out) < size:
        for names in cycle:
            parts = [(fields[n].descriptor, random.randbytes(fields[n].min_size)) for n in names]
            out += codec.build(model, fields[names[-1]].set, parts)
    return bytes(out)


def recording(model: m.Model, size: int) -> bytes:
    """Many different packets, repeated as often as needed: building every packet would take minutes."""
    part = log(model, 1_000_000, RECORDED)
    return part * -(-size // len(part))


def noise(size: int) -> bytes:
    return Random(2).randbytes(size)


def syncs(size: int) -> bytes:
    """The worst noise: each sync announces a packet of 107 bytes, which only its checksum refutes."""
    return b"ue" * (size // 2)


def text(size: int) -> bytes:
    random, out = Random(3), bytearray()
    while len(out) < size:
        body = random.choice(SENTENCES).format(*(random.randrange(10_000) for _ in range(3))).encode()
        check = 0
        for byte in body:
            check ^= byte
        out += b"$%b*%02X\r\n" % (body, check)
    return bytes(out)


def mixed(packets: bytes, sentences: bytes) -> bytes:
    """A sentence after every third packet."""
    out, at, lines = bytearray(), 0, sentences.splitlines(keepends=True)
    for number, line in enumerate(lines):
        for _ in range(3):
            size = packets[at + 3] + 6 if at < len(packets) else 0
            out += packets[at : at + size]
            at += size
        out += line if number else b""
    return bytes(out)


def shuffled(packets: bytes) -> bytes:
    """The same packets in random order."""
    parts, at = [], 0
    while at < len(packets):
        size = packets[at + 3] + 6
        parts.append(packets[at : at + size])
        at += size
    Random(4).shuffle(parts)
    return b"".join(parts)
