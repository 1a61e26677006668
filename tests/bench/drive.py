"""A log as a vehicle records it: sensor at 500 Hz, filter at 100 Hz, receiver at 4 Hz, NMEA sentences at 1 Hz."""

from __future__ import annotations

import math
import struct
from itertools import accumulate
from random import Random

WEEK = 2300


def packet(number: int, *fields: tuple[int, bytes]) -> bytes:
    payload = b"".join(bytes((len(data) + 2, descriptor)) + data for descriptor, data in fields)
    head = bytes((0x75, 0x65, number, len(payload))) + payload
    return head + bytes((sum(head) & 255, sum(accumulate(head)) & 255))


def _sentence(body: str) -> bytes:
    check = 0
    for byte in body.encode():
        check ^= byte
    return f"${body}*{check:02X}\r\n".encode()


def drive(size: int) -> bytes:
    """At least `size` bytes: about 44 kB for each second of the log."""
    random, out, step = Random(1), bytearray(), 0
    while len(out) < size:
        time = step / 500
        gps = 0xD3, struct.pack(">dHH", 345_600 + time, WEEK, 3)
        reference = 0xD5, struct.pack(">Q", step * 2_000_000 + 77)
        noise = [random.gauss(0, 0.02) for _ in range(9)]
        accel = struct.pack(">3f", math.sin(time) + noise[0], noise[1], noise[2] - 1)
        gyro = struct.pack(">3f", noise[3] / 10, noise[4] / 10, math.cos(time) / 3 + noise[5])
        out += packet(0x80, gps, reference, (0x04, accel), (0x05, gyro))
        if step % 5 == 0:
            angles = struct.pack(">3fH", noise[6], noise[7], math.remainder(time / 3, 2 * math.pi), 1)
            place = struct.pack(">3dH", 44.5 + time * 1e-5, -73.1 + noise[8] * 1e-6, 100 + noise[0], 1)
            speed = struct.pack(">3fH", 12 + noise[1], noise[2], noise[3], 1)
            spread = struct.pack(">3fH", 0.01, 0.01, 0.02, 1)
            fields = [(0x05, angles), (0x01, place), (0x02, speed), (0x10, struct.pack(">3H", 4, 1, 0)), (0x0A, spread)]
            out += packet(0x82, gps, reference, *fields)
            out += packet(0x82, gps, reference, (0x0D, accel + b"\0\1"), (0x0E, gyro + b"\0\1"))
        if step % 125 == 0:
            fix = struct.pack(">4d2fH", 44.5 + time * 1e-5, -73.1, 101, 100, 0.7, 1.1, 31)
            out += packet(0x91, gps, (0x03, fix), (0x0B, struct.pack(">BBHH", 0, 14, 3, 31)))
        if step % 500 == 0:
            second = int(time) % 86400
            clock = f"{second // 3600:02d}{second // 60 % 60:02d}{second % 60:02d}"
            out += _sentence(f"GPGGA,{clock}.00,4430.000,N,07306.000,W,4,14,0.7,101.0,M,1.0,M,1.2,0000")
        step += 1
    return bytes(out)
