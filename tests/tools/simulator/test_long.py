"""Streaming for long: constant memory, and times that do not drift."""

from __future__ import annotations

import sys
from itertools import pairwise

from mip_protocol import mip_3dm, types
from mip_tools.simulator import VirtualDevice
from mip_tools.simulator.endpoints import tcp_at
from soak import soak
from support import nightly
from test_serve import Client, serving

CV7 = "3dm-cv7-gnss-ins"
SECOND = 10**9
DAY = 86400 * SECOND

#: Shared times, sensor, filter and GNSS data, and a field of several items.
FORMATS = {
    0x80: (0xD5, 0xD6, 0x04, 0x05, 0x07, 0x08, 0x0A, 0x0C),
    0x82: (0xD3, 0x01, 0x02, 0x05, 0x10),
    0x91: (0x03, 0x07, 0x0B, 0x20),
}

#: How many objects may come and go.
SOME = 500


def streaming(formats: dict[int, tuple[int, ...]], decimation: int) -> VirtualDevice:
    device = VirtualDevice(CV7)
    link = device.connect(capacity=0)  # all is dropped, as if a host had read it
    for set, fields in formats.items():
        wanted = tuple(types.DescriptorRate(x, decimation) for x in fields)
        link.write(bytes(mip_3dm.MessageFormat.write(set, wanted).packet()))
    return device


def grown(device: VirtualDevice, until: int) -> int:
    before = sys.getallocatedblocks()
    device.run_until(until)
    return sys.getallocatedblocks() - before


def test_memory_does_not_grow() -> None:
    device = streaming(FORMATS, 1)
    device.advance(2.0)
    assert grown(device, 6 * SECOND) < SOME, "8,000 packets and more"


def test_two_sets_of_thirteen_fields_arrive_whole() -> None:
    """At 1 kHz, as fast as the program reads: nothing is lost, and nothing is late."""
    device = VirtualDevice(CV7)
    commands = []
    for set, fields in {
        0x80: (0xD5, 0x04, 0x05, 0x06, 0x07, 0x08, 0x0C),
        0x82: (0xD5, 0x01, 0x02, 0x05, 0x0D, 0x10),
    }.items():
        entries = tuple(types.DescriptorRate(x, 1) for x in fields)
        commands += [mip_3dm.MessageFormat.write(set, entries), mip_3dm.DataStreamControl.write(set, True)]
    with serving(device, tcp_at("0"), speed=0, duration=3) as server, Client(server.places[0]) as client:
        client.send(b"".join(bytes(command.packet()) for command in commands))
        assert client.at_end() and client.parser.skipped == 0 and not server.complaints
    for set in (0x80, 0x82):
        times = [int.from_bytes(p[6:14]) for p in client.packets if p[2] == set]
        assert len(times) > 2900 and {b - a for a, b in pairwise(times)} == {SECOND // 1000}


@nightly("ten minutes of 1 kHz in real time")
def test_what_cannot_be_kept_is_told() -> None:
    """Even on a busy machine."""
    found = soak(600)
    assert found.packets > 0 and found.missing <= found.reported
    assert found.behind < found.late + 1.5
    assert found.memory[1] < 1.05 * found.memory[0]
