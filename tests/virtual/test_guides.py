"""Each guide, played on the virtual device of each device that it names: answers and data, but those of events."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Iterable, Iterator
from typing import Any

import pytest
from mip_protocol import Parser
from mip_simulator.device import VirtualDevice
from mipgen import model as m
from mipgen.lower import codec
from mipgen.model import guides
from mipgen.model.guides import Sequence, Step, Stream
from support import model

#: Seconds for which data are counted.
LONG = 3.0

Played = tuple[guides.Guide, Sequence, m.Device]


def played() -> list[Played]:
    return [(g, s, d) for g in model("real").guides for s in g.sequences for d in s.devices]


class Conversation:
    """A host and a device, in simulated time."""

    def __init__(self, device: m.Device) -> None:
        self.virtual = VirtualDevice(device.id)
        self.link = self.virtual.connect()
        self.parser = Parser()

    def packets(self, seconds: float) -> Iterator[bytes]:
        self.virtual.advance(seconds)
        return (bytes(p) for p in self.parser.feed(self.link.read()))

    def data(self) -> list[bytes]:
        """The packets of some seconds."""
        return list(self.packets(LONG))

    def ask(self, packet: bytes, timeout: float) -> bytes:
        """The first packet of the command's set that comes back."""
        self.link.write(packet)
        for _ in range(round(timeout / 0.01)):
            found = [p for p in self.packets(0.01) if p[2] == packet[2]]
            if found:
                return found[0]
        raise AssertionError(f"no answer to {packet.hex(' ')}")


def fields(packet: bytes) -> list[tuple[int, bytes]]:
    return codec.split(model("real"), packet)


def plain(value: Any) -> Any:
    """Floats from the hexadecimal of their bits; other values are as they are."""
    if isinstance(value, str) and value.startswith("0x"):
        raw = bytes.fromhex(value[2:])
        return struct.unpack(">f" if len(raw) == 4 else ">d", raw)[0]
    return [plain(v) for v in value] if isinstance(value, list) else value


def check_answer(step: Step, answer: bytes) -> None:
    """An acknowledge, then the response, whose stated values are as stated."""
    acknowledge, *rest = fields(answer)
    assert acknowledge == (0xF1, bytes([step.command.descriptor, 0])), answer.hex(" ")
    if step.response is None:
        assert answer == step.answer
        return
    ((descriptor, data),) = rest
    f = step.response.field
    assert descriptor == f.descriptor
    values, trailing = codec.decode(f, data)
    assert trailing == 0
    for name in step.response.stated:
        assert plain(values[name]) == pytest.approx(plain(step.response.values[name]), abs=1e-5), name


def once(descriptors: Iterable[int]) -> list[int]:
    """Drops repetitions: a field about several things occurs once for each of them."""
    return [d for d, _ in itertools.groupby(descriptors)]


def check_data(streams: tuple[Stream, ...], packets: list[bytes]) -> None:
    for stream in streams:
        if stream.on_event:  # events are not simulated
            continue
        own = [p for p in packets if p[2] == stream.set.number]
        wanted = [x.field.descriptor for x in stream.fields]
        assert own and all(once(d for d, _ in fields(p)) == wanted for p in own), stream.set.name
        if stream.rate is not None:
            assert abs(len(own) - stream.rate * LONG) <= 1, (stream.set.name, len(own))


@pytest.mark.parametrize("case", played(), ids=lambda c: f"{c[0].name}/{c[1].title}/{c[2].id}")
def test_guide(case: Played) -> None:
    _, sequence, device = case
    conversation = Conversation(device)
    for step in sequence.steps:
        if step.answer:
            check_answer(step, conversation.ask(step.packet, step.command.timeout or 0.5))
        else:
            conversation.link.write(step.packet)
        if step.data:
            check_data(step.data, conversation.data())
