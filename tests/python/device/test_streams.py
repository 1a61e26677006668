"""Helpers without I/O: the bytes between packets, NMEA sentences, packets of one sample."""

from __future__ import annotations

import doctest
import random
from typing import Any

import mip_protocol as mip
import pytest
from both import packet
from mip_protocol import Packet, Parser, Samples, mip_3dm, samples, types
from mip_protocol.sampling import MOST
from mip_tools import sentences
from mip_tools.sentences import Sentences
from mip_tools.simulator.device import VirtualDevice


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


def test_continuation_packets_without_a_time_are_recognized_by_their_order() -> None:
    stream = [data(0x82, *FULL), data(0x82, 20, 21), data(0x82, *FULL), data(0x82, 20, 21)]
    assert list(samples(stream)) == [stream[:2], stream[2:]]


def test_packets_with_room_are_not_continued() -> None:
    stream = [data(0x82, 1, 2), data(0x82, 3), data(0x82, 1, 2)]
    assert list(samples(stream)) == [[p] for p in stream]


def test_a_full_packet_that_is_repeated_is_not_continued() -> None:
    stream = [data(0x82, *FULL)] * 3
    assert list(samples(stream)) == [[p] for p in stream]


def test_the_same_timestamp_tells_what_belongs_together() -> None:
    stream = [data(0x82, 1, 2, time=5), data(0x82, 3, time=5), data(0x82, 4, time=5), data(0x82, 1, 2, time=6)]
    assert list(samples(stream)) == [stream[:3], stream[3:]]
    full = [data(0x82, *FULL[:-1], time=5), data(0x82, 20, time=6)]  # it looks like a continuation, but is later
    assert list(samples(full)) == [[p] for p in full]


def test_a_clock_that_stands_still() -> None:
    """As before a fix: samples are separated by the fields that repeat."""
    stream = [data(0x82, 1, 2, time=0), data(0x82, 3, time=0)] * 3
    assert list(samples(stream)) == [stream[:2]] * 3
    full = [data(0x82, *FULL[:-1], time=0)] * 3
    assert list(samples(full)) == [[p] for p in full]


def test_shared_fields_that_tell_no_time() -> None:
    source = [Packet(packet(0x82, "d0 01", f"{d:02x} 00")) for d in (1, 2, 1)]
    assert list(samples(source)) == [[p] for p in source]
    other = [Packet(packet(0x82, "d0 01", *(f"{d:02x} {'00' * 20}" for d in FULL))),
             Packet(packet(0x82, "d0 02", f"20 {'00' * 20}"))]  # fmt: skip
    assert list(samples(other)) == [[p] for p in other]


@pytest.mark.parametrize("field", ["d3 0000000000000000 0000 0000", "d5 0000000000000005", "d7 0000000000000005 0000"])
def test_each_clock_tells_what_belongs_together(field: str) -> None:
    stream = [Packet(packet(0x82, field, "01 00")), Packet(packet(0x82, field, "02 00"))]
    assert list(samples(stream)) == [stream]


def test_a_list_goes_on_in_the_next_packet() -> None:
    """Such as one field for each satellite."""
    stream = [data(0x91, *[0x20] * 11, time=1), data(0x91, *[0x20] * 3, time=1), data(0x91, *[0x20] * 11, time=2)]
    assert list(samples(stream)) == [stream[:2], stream[2:]]


def test_sets_do_not_disturb_each_other_nor_do_answers() -> None:
    a, b = [data(0x82, *FULL), data(0x82, 20)], [data(0x80, *FULL), data(0x80, 20)]
    answer = Packet(packet(0x01, "f1 01 00"))
    found = list(samples([a[0], b[0], answer, a[1], b[1], answer]))
    assert found == [[answer], [answer], a, b]


def test_malformed_fields_and_packets_of_shared_fields_alone() -> None:
    odd = [Packet(packet(0x82)), Packet(packet(0x82, "d5 0000000000000001")), Packet(packet(0x82))]
    odd.append(Packet(bytes.fromhex("756582030904008ad9")[:-2] + mip.checksum(bytes.fromhex("75658203090400"))))
    assert list(samples(odd)) == [[p] for p in odd]


def test_a_list_without_end_is_given_out() -> None:
    stream = [data(0x82, 9, time=0, size=200)] * (2 * MOST + 3)
    assert [len(s) for s in samples(stream)] == [MOST, MOST, 3]


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
