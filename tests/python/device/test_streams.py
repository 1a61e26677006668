"""Helpers without I/O: the bytes between packets, NMEA sentences, packets of one sample."""

from __future__ import annotations

import doctest
import random
from typing import Any

import mip_protocol as mip
import pytest
from both import packet
from mip_protocol import Packet, Parser, Samples, mip_3dm, samples, timestamps, types
from mip_protocol.sampling import MOST
from mip_simulator.device import VirtualDevice
from mip_tools import sentences
from mip_tools.sentences import Sentences


def test_the_examples_in_the_documentation() -> None:
    found = doctest.testmod(sentences)
    assert found.attempted and not found.failed


def noisy(chance: random.Random) -> bytes:
    """A stream of packets, parts and lookalikes of packets, sentences and noise."""
    parts = [b"ue", b"u", b"ue\x80\xff", b"ue\x00\x01", b"$GPZDA,,,,,,*48\r\n", b"uueue", bytes(300)]
    stream = bytearray()
    for _ in range(chance.randrange(30)):
        whole = packet(chance.choice((1, 0x80, 0x82)), f"04 {chance.getrandbits(96):024x}")
        stream += chance.choice((whole, whole, whole[: chance.randrange(len(whole))], *parts))
        if chance.random() < 0.1 and stream:
            stream[chance.randrange(len(stream))] ^= 1 << chance.randrange(8)
    return bytes(stream)


def test_the_bytes_between_packets_are_not_lost() -> None:
    chance = random.Random(5)
    for _ in range(400):
        stream, at = noisy(chance), 0
        parser, splitting = Parser(), Parser()
        packets: list[Packet] = []
        items: list[Packet | bytes] = []
        while at < len(stream):
            size = chance.choice((1, 3, 50, 1000))
            packets += parser.feed(stream[at : at + size])
            items += splitting.feed_all(stream[at : at + size])
            at += size
            if chance.random() < 0.1:
                packets += parser.look_behind()
                items += splitting.look_behind_all()
            assert (splitting.skipped, splitting.pending) == (parser.skipped, parser.pending)
            assert sum(map(len, items)) + splitting.pending == min(at, len(stream))
        packets += parser.flush()
        items += splitting.flush_all()
        assert b"".join(map(bytes, items)) == stream
        assert [i for i in items if isinstance(i, Packet)] == packets
        assert sum(len(i) for i in items if isinstance(i, bytes)) == parser.skipped
        assert all(items)


# --------------------------------------------------------------------------- sentences


@pytest.mark.parametrize(
    ("stream", "found"),
    [
        (b"$GPZDA,,,,,,*48\r\n", ["$GPZDA,,,,,,*48"]),
        (b"$GPZDA,,,,,,*48\n!AI*08\r\n", ["$GPZDA,,,,,,*48", "!AI*08"]),
        (b"ue$\x80$GP$GPZDA,,,,,,*48\r\n", ["$GPZDA,,,,,,*48"]),
        (b"ue$GNTXT,01,01,02,Ready!*39\r\n", ["$GNTXT,01,01,02,Ready!*39"]),
        (b"$GPZDA,,,,,,*49\r\n", []),  # a wrong checksum
        (b"$GPZDA,,,,,,*4\r\n$GPZDA,,,,,,\r\n*48\r\n$*00\n\n", []),
        (b"$GPZDA,\xff,,,,,*b7\r\n", []),
        (b"$GPZDA,,,,,,*48", []),  # the end of the line has not arrived
    ],
)
def test_sentences(stream: bytes, found: list[str]) -> None:
    assert Sentences().feed(stream) == found
    taker = Sentences()
    assert [s for byte in stream for s in taker.feed(bytes([byte]))] == found


def test_sentences_keep_no_more_than_a_line() -> None:
    taker = Sentences()
    for _ in range(100):
        assert taker.feed(b"$" * 10_000) == []
        assert len(taker._line) <= 1024
    assert taker.feed(b"\n$GPZDA,,,,,,*48\r\n") == ["$GPZDA,,,,,,*48"]


# --------------------------------------------------------------------------- samples


def data(number: int, *descriptors: int, time: int | None = None, size: int = 20) -> Packet:
    """A data packet with these fields, after a timestamp."""
    fields = [f"{d:02x} {'00' * size}" for d in descriptors]
    return Packet(packet(number, *([] if time is None else [f"d5 {time:016x}"]), *fields))


FULL = range(1, 12)  # eleven fields of 22 bytes: no room for another
WITH_TIME = range(1, 11)


def first(*fields: str) -> Packet:
    return Packet(packet(0x82, *fields))


#: What a stream is -> its packets, and how many of them each sample has.
STREAMS: dict[str, tuple[list[Packet], list[int]]] = {
    "continued in order": ([data(0x82, *FULL), data(0x82, 20, 21)] * 2, [2, 2]),
    "with room": ([data(0x82, 1, 2), data(0x82, 3), data(0x82, 1, 2)], [1, 1, 1]),
    "full and repeated": ([data(0x82, *FULL)] * 3, [1, 1, 1]),
    "one timestamp": ([data(0x82, 1, 2, time=5), data(0x82, 3, time=5), data(0x82, 4, time=5), data(0x82, 1, time=6)],
                      [3, 1]),
    "like a continuation, but later": ([data(0x82, *WITH_TIME, time=5), data(0x82, 20, time=6)], [1, 1]),
    "a clock that stands still, as before a fix": ([data(0x82, 1, 2, time=0), data(0x82, 3, time=0)] * 3, [2, 2, 2]),
    "full, and the clock stands still": ([data(0x82, *WITH_TIME, time=0)] * 3, [1, 1, 1]),
    "shared fields without a time": ([first("d0 01", f"{d:02x} 00") for d in (1, 2, 1)], [1, 1, 1]),
    "a list that goes on, as of satellites": (
        [data(0x91, *[0x20] * 11, time=1), data(0x91, *[0x20] * 3, time=1), data(0x91, *[0x20] * 11, time=2)], [2, 1]),
    "a list without end": ([data(0x82, 9, time=0, size=200)] * (2 * MOST + 3), [MOST, MOST, 3]),
    "no fields, and shared ones alone": ([first(), first("d5 0000000000000001"), first()], [1, 1, 1]),
    **{f"clock {clock[:2]}": ([first(clock, "01 00"), first(clock, "02 00")], [2])
       for clock in ("d3 0000000000000000 0000 0000", "d5 0000000000000005", "d7 0000000000000005 0000")},
}  # fmt: skip


@pytest.mark.parametrize("name", STREAMS)
def test_packets_of_one_sample(name: str) -> None:
    stream, sizes = STREAMS[name]
    found = list(samples(stream))
    assert [len(group) for group in found] == sizes and [p for group in found for p in group] == stream


def test_sets_do_not_disturb_each_other_nor_do_answers() -> None:
    a, b = [data(0x82, *FULL), data(0x82, 20)], [data(0x80, *FULL), data(0x80, 20)]
    answer = Packet(packet(0x01, "f1 01 00"))
    found = list(samples([a[0], b[0], answer, a[1], b[1], answer]))
    assert found == [[answer], [answer], a, b]


def test_the_push_form_takes_anything_with_a_packet() -> None:
    arrivals = [mip.Arrival(p, 1.0, 2.0) for p in (data(0x82, *FULL), data(0x82, 20), data(0x82, 1))]
    together: Samples[mip.Arrival] = Samples()
    assert [together.add(a) for a in arrivals] == [[], [], [arrivals[:2]]]
    assert together.flush() == [arrivals[2:]] and together.flush() == []


@pytest.mark.parametrize("stamped", [True, False])
@pytest.mark.parametrize("number", [0x82, 0x91])
def test_all_data_of_a_device(number: int, stamped: bool) -> None:
    """Every field that it has, of which each sample takes several packets."""
    virtual = VirtualDevice("3dm-cv7-gnss-ins")
    link = virtual.connect()
    known = sorted(d for s, d in virtual.profile.fields if s == number)
    if stamped:
        known.insert(0, 0xD5)
    decimation = round(virtual.profile.base_rates[number] / 5)
    entries = tuple(types.DescriptorRate(d, decimation) for d in known)
    for command in (mip_3dm.MessageFormat.write(number, entries), mip_3dm.DataStreamControl.write(number, True)):
        link.write(bytes(command.packet()))
    stream = bytearray()
    for _ in range(300):
        virtual.advance(0.01)
        stream += link.read()
    packets = [p for p in Parser().feed(bytes(stream)) if p.set == number]
    found = list(samples(packets))
    assert len(found) >= 9 and max(map(len, found)) > 1
    for group in found[1:-1]:
        own: list[Any] = [raw.descriptor for p in group for raw in p if raw.descriptor < 0xD0]
        assert sorted(set(own)) == [d for d in known if d < 0xD0]  # some come several times
        assert own.count(own[0]) == 1


@pytest.mark.parametrize(
    ("number", "clock", "descriptors"),
    [
        (0x80, "gps", [0x12, 0xD3]),
        (0x82, "gps", [0x11, 0xD3]),
        (0x91, "gps", [0x09, 0xD3]),
        (0x80, "reference", [0xD5]),
        (0x80, "external", [0xD7]),
    ],
)
def test_the_fields_that_contain_the_time_of_a_clock(number: int, clock: str, descriptors: list[int]) -> None:
    assert [kind.DESCRIPTOR for kind in timestamps.kinds(number, clock)] == descriptors
