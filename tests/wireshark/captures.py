"""Writes captures: serial chunks, datagrams and TCP streams, each with the headers that Wireshark expects."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Sequence

USER0, RAW_IP = 147, 101
HOST, DEVICE = b"\x0a\0\0\1", b"\x0a\0\0\2"
HOST_PORT = 40000


def capture(link: int, frames: Iterable[bytes], interval: float = 0.001) -> bytes:
    """A pcap file; one frame each `interval` seconds."""
    out = [struct.pack("<IHHIIII", 0xA1B2C3D4, 2, 4, 0, 0, 262144, link)]
    for i, frame in enumerate(frames):
        microseconds = round(i * interval * 1e6)
        head = struct.pack("<IIII", microseconds // 1000000, microseconds % 1000000, len(frame), len(frame))
        out += [head, frame]
    return b"".join(out)


def chunks(data: bytes, size: int) -> list[bytes]:
    return [data[at : at + size] for at in range(0, len(data), size)]


def serial(parts: Iterable[bytes], interval: float = 0.001) -> bytes:
    return capture(USER0, parts, interval)


def datagrams(payloads: Iterable[bytes], port: int) -> bytes:
    return capture(RAW_IP, (udp(payload, port) for payload in payloads))


def udp(payload: bytes, port: int, from_device: bool = True) -> bytes:
    ports = (port, HOST_PORT) if from_device else (HOST_PORT, port)
    return ip(17, struct.pack(">HHHH", *ports, len(payload) + 8, 0) + payload, from_device)


def ip(protocol: int, payload: bytes, from_device: bool) -> bytes:
    ends = (DEVICE, HOST) if from_device else (HOST, DEVICE)
    head = struct.pack(">BBHHHBBH", 0x45, 0, len(payload) + 20, 0, 0, 64, protocol, 0) + ends[0] + ends[1]
    total = sum(struct.unpack(">10H", head))
    total = (total & 0xFFFF) + (total >> 16)
    total = (total & 0xFFFF) + (total >> 16)
    return head[:10] + struct.pack(">H", ~total & 0xFFFF) + head[12:] + payload


def tcp(segments: Sequence[tuple[bool, bytes]], port: int, interval: float = 0.001) -> bytes:
    return capture(RAW_IP, connection(segments, port), interval)


def connection(segments: Sequence[tuple[bool, bytes]], port: int) -> list[bytes]:
    """The handshake of a connection, then segments, each from the device (True) or from the host."""
    numbers = {True: 5000, False: 1000}
    frames = []

    def frame(from_device: bool, flags: int, payload: bytes) -> None:
        ports = (port, HOST_PORT) if from_device else (HOST_PORT, port)
        acknowledged = numbers[not from_device] if flags & 0x10 else 0
        head = struct.pack(">HHIIBBHHH", *ports, numbers[from_device], acknowledged, 0x50, flags, 65535, 0, 0)
        frames.append(ip(6, head + payload, from_device))
        numbers[from_device] += len(payload) + (flags & 0x02) // 0x02

    frame(False, 0x02, b"")
    frame(True, 0x12, b"")
    frame(False, 0x10, b"")
    for from_device, payload in segments:
        frame(from_device, 0x18, payload)
    return frames
