"""Runs tshark with the dissector and nothing of the user's settings, and writes captures: serial chunks, datagrams and
TCP streams, each with the headers that Wireshark expects.
"""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree


def need_tshark() -> str:
    found = shutil.which("tshark")
    if found is None:
        sys.exit("tshark is missing; install it (Debian: apt-get install tshark)")
    return found


@dataclass(frozen=True)
class Shark:
    plugin: Path

    def command(self, *arguments: str) -> list[str]:
        return [need_tshark(), *arguments, "-X", f"lua_script:{self.plugin}"]

    def run(self, *arguments: str) -> str:
        """The output of tshark."""
        with tempfile.TemporaryDirectory() as home:
            done = subprocess.run(
                self.command(*arguments), capture_output=True, text=True, encoding="utf-8", env=environment(home)
            )
        assert done.returncode == 0, done.stderr
        assert "Lua" not in done.stderr, done.stderr
        return done.stdout

    def types(self) -> dict[str, str]:
        """The type of each filter of the dissector."""
        rows = (line.split("\t") for line in self.run("-G", "fields").splitlines())
        return {row[2]: row[3] for row in rows if row[0] == "F" and row[4] in ("mip_protocol", "mip_stream")}

    def trees(self, capture: Path, *arguments: str) -> Iterator[ElementTree.Element]:
        """The tree of each frame, in order."""
        with tempfile.TemporaryDirectory() as home, tempfile.TemporaryFile() as complaints:
            run = subprocess.Popen(
                self.command("-n", "-r", str(capture), "-T", "pdml", *arguments),
                stdout=subprocess.PIPE, stderr=complaints, env=environment(home),
            )  # fmt: skip
            assert run.stdout is not None
            for _, element in ElementTree.iterparse(run.stdout):
                if element.tag == "packet":
                    check(element)
                    yield element
                    element.clear()
            code = run.wait()
            complaints.seek(0)
            said = complaints.read().decode()
        assert code == 0 and "Lua" not in said, said


def check(tree: ElementTree.Element) -> None:
    error = tree.find(".//field[@name='_ws.lua.error']")
    assert error is None, error.get("showname")


def environment(home: str) -> dict[str, str]:
    return {**os.environ, "HOME": home, "XDG_CONFIG_HOME": home, "WIRESHARK_CONFIG_DIR": home, "LC_ALL": "C.UTF-8"}


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
