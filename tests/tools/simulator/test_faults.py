"""Faults: each kind happens, is logged, repeats with its seed, and damages what the log says and nothing else."""

from __future__ import annotations

import io
import json
from collections import Counter
from collections.abc import Callable
from functools import cached_property
from operator import itemgetter
from random import Random
from typing import Any

import pytest
from mip_protocol import DecodeError, Packet, PacketBuilder, Parser, RawField, base, mip_3dm, registry, sensor, types
from mip_simulator.device import VirtualDevice
from mip_simulator.faults import Faults, Injected, json_log
from mip_simulator.faults.kinds import KINDS, parse_faults, plan
from mip_tools.errors import Failure
from random_values import chance
from support import rounds

MILLISECOND = 1_000_000


def kinds(*chances: str) -> list[str]:
    return [name for name, kind in KINDS.items() if kind.of in chances]


def stream(count: int, seed: int = 0) -> list[bytes]:
    """Packets of data, all different, of many sizes; the start of a packet may be in their payload."""
    random, made = Random(seed), []
    for number in range(count):
        builder = PacketBuilder(random.choice((0x80, 0x82))).add(0x04, number.to_bytes(4, "big"))
        builder.add(0x05, random.choice((b"", b"\x75\x65", b"ue\x80\x0e")) + random.randbytes(random.randrange(40)))
        made.append(bytes(builder.build()))
    return made


#: Faults that add packets; faults after which a packet does not keep its place.
WHOLE = ("double_packet", "repeat_packet", "unknown_set")
MOVED = {"repeat_packet", "reorder_packet"}


class Run:
    """A stream that is sent through `Faults`, and what arrives."""

    def __init__(self, sent: list[bytes], seed: int = 0, **options: Any) -> None:
        self.log: list[Injected] = []
        self.sent = sent
        faults = Faults(seed=seed, log=self.log.append, **options)
        parts = [
            (number * MILLISECOND + delay, part)
            for number, packet in enumerate(sent)
            for delay, part in faults.transmit(number * MILLISECOND, packet)
        ]
        self.parts = sorted(parts, key=itemgetter(0)) if MOVED & options.keys() else parts
        self.bytes = b"".join(part for _, part in self.parts)
        parser = Parser()
        self.found = [bytes(p) for p in parser.feed(self.bytes) + parser.flush()]

    @cached_property
    def damaged(self) -> Counter[bytes]:
        return Counter(entry.packet for entry in self.log if entry.damaged and entry.packet is not None)

    @cached_property
    def intact(self) -> Counter[bytes]:
        """What must arrive, by the log."""
        return Counter(self.sent) - self.damaged

    @cached_property
    def added(self) -> Counter[bytes]:
        return Counter(entry.added for entry in self.log if entry.kind in WHOLE)

    def check(self) -> None:
        found = Counter(self.found)
        assert not self.intact - found, "an intact packet was lost"
        # Bytes that are lost and noise in their place may make a damaged packet whole again.
        assert not found - Counter(self.sent) - self.added, "a packet came that nobody sent"
        moved = {entry.packet for entry in self.log if entry.kind == "reorder_packet"}
        order = [p for p in dict.fromkeys(self.found) if p in self.intact and p not in moved]
        assert order == [p for p in dict.fromkeys(self.sent) if p in order], "the order has changed"


# --------------------------------------------------------------------------- packets


def _sentence(data: bytes) -> bool:
    """NMEA with a right checksum."""
    text, _, check = data.decode("ascii").partition("*")
    value = 0
    for byte in text[1:].encode():
        value ^= byte
    return text[0] == "$" and check == f"{value:02X}\r\n"


#: What a fault puts between the packets.
ADDED: dict[str, Callable[[bytes], bool]] = {
    "noise": lambda data: 1 <= len(data) <= 64,
    "nmea": _sentence,
    "false_header": lambda data: data[:2] == b"ue" and data[2] in registry.MODULES and 4 <= len(data) <= 6,
    "unknown_set": lambda data: Packet(data).set not in registry.MODULES and len(list(Packet(data))) >= 1,
    "double_packet": bool,
    "repeat_packet": bool,
}


@pytest.mark.parametrize("kind", kinds("packet"))
def test_each_fault_of_packets_happens_and_is_logged(kind: str) -> None:
    run = Run(stream(400), **{kind: 0.2})
    run.check()
    log = [entry for entry in run.log if "by chance" not in entry.detail]
    assert 40 < len(log) < 130 and {entry.kind for entry in log} == {kind}
    touched = Counter(entry.packet for entry in log)
    changes_bytes = not kind.startswith("delay")
    assert (run.bytes == b"".join(run.sent)) is not changes_bytes
    if kind in ("lose", "cut", "change", "double", "lose_packet"):
        assert run.damaged == touched and sum(touched.values()) == len(log)
        assert len(run.found) == len(run.sent) - len(log)  # all of them, and no other
    else:
        assert not run.damaged
        assert sum((run.intact + run.added).values()) == len(run.found)
    if kind in ADDED:
        assert all(ADDED[kind](entry.added) for entry in log)
        assert len(run.bytes) == sum(map(len, run.sent)) + sum(len(entry.added) for entry in run.log)
    if kind == "false_header":
        assert max(entry.added[3] for entry in run.log) > 200  # some hold back several packets


def test_all_intact_packets_are_found() -> None:
    numbers, known = chance("faults"), [kind for kind in kinds("packet") if kind not in MOVED]
    cases = [(681, ["noise", "lose", "lose_packet"], 0.34375)]
    for _ in range(rounds(20, 400)):
        struck = numbers.sample(known, numbers.randint(1, len(known)))
        cases.append((numbers.getrandbits(32), struck, numbers.uniform(0.01, 0.5)))
    for seed, struck, rate in cases:
        Run(stream(120, seed), seed, **dict.fromkeys(struck, rate)).check()


def test_a_false_start_is_never_complete_by_chance() -> None:
    """So many false headers that one would be completed: the log then states which bytes were put in between."""
    run = Run(stream(3000), 9, false_header=0.5, cut=0.2)
    run.check()
    assert any("by chance" in entry.detail for entry in run.log)


@pytest.mark.parametrize("kind", ["delay", "delay_packet"])
def test_delays_keep_the_order(kind: str) -> None:
    run = Run(stream(300), **{kind: (0.05, 0.02)})
    times = [time for time, _ in run.parts]
    assert times == sorted(times) and run.bytes == b"".join(run.sent)
    late = max(time - time // MILLISECOND * MILLISECOND for time in times)
    assert late > 0 and max(times) > 0
    waits = [float(entry.detail.split(" s late")[0].split()[-1]) for entry in run.log]
    assert waits and all(0 < wait <= 0.02 for wait in waits)


def test_sentences_of_the_device_pass_unharmed() -> None:
    """Faults affect packets only; other bytes that the device sends keep their order."""
    faults = Faults(lose_packet=1.0, delay=0.5)
    text = b"$GPZDA,000000.00,01,01,2024,00,00*6F\r\n"
    assert faults.transmit(0, text) == [(0, text)]


def test_lines_do_not_disturb_each_other() -> None:
    """A delay on one line holds nothing back on another, and a line that was cut leaves nothing behind."""
    packet = stream(1)[0]
    faults = Faults(script=["delay_packet@1"])
    (late,) = faults.transmit(0, packet, "one")
    assert late[0] > 0 and late[1] == packet
    assert faults.transmit(0, packet, "two") == [(0, packet)]
    assert faults.transmit(0, packet, "one")[0][0] >= late[0]
    faults.forget(0, "one")
    assert faults.transmit(0, packet, "one") == [(0, packet)]


# --------------------------------------------------------------------------- seeds, places, log


def test_the_same_seed_gives_the_same_faults() -> None:
    """Those of a kind do not depend on the others."""
    rates = dict.fromkeys(kinds("packet"), 0.1)
    one, again, other = (Run(stream(300), seed, **rates) for seed in (3, 3, 4))
    assert one.parts == again.parts and one.log == again.log
    assert one.parts != other.parts
    lost = [entry.packet for entry in Run(stream(300), lose_packet=0.1).log]
    among = Run(stream(300), lose_packet=0.1, noise=0.5, delay=0.3)
    assert lost and [entry.packet for entry in among.log if entry.kind == "lose_packet"] == lost


def test_exact_places() -> None:
    run = Run(stream(10), script=["lose_packet@3", "noise@5", "lose_packet@10"])
    run.check()
    assert [(entry.kind, entry.now // MILLISECOND) for entry in run.log] == [
        ("lose_packet", 2),
        ("noise", 4),
        ("lose_packet", 9),
    ]
    assert list(run.damaged) == [run.sent[2], run.sent[9]]


def test_the_log_as_json() -> None:
    file = io.StringIO()
    log = json_log(file)
    log(Injected(1_500_000_000, "cut", "2 bytes", packet=b"\x75\x65", damaged=True))
    log(Injected(0, "noise", "1 byte", added=b"\x00"))
    log(Injected(0, "lose_answer", "missing", command=RawField(1, 2, b"\x03")))
    assert [json.loads(line) for line in file.getvalue().splitlines()] == [
        {"time": 1.5, "kind": "cut", "detail": "2 bytes", "packet": "7565", "damaged": True},
        {"time": 0.0, "kind": "noise", "detail": "1 byte", "added": "00"},
        {"time": 0.0, "kind": "lose_answer", "detail": "missing",
         "command": {"set": 1, "descriptor": 2, "data": "03"}},
    ]  # fmt: skip


# --------------------------------------------------------------------------- answers

COMMAND = RawField(0x01, base.GetDeviceInfo.DESCRIPTOR, b"")
ACK = RawField(0x01, 0xF1, bytes((base.GetDeviceInfo.DESCRIPTOR, 0)))
INFO = base.GetDeviceInfo.RESPONSES[0]
RESPONSE = RawField(0x01, INFO.DESCRIPTOR, b"\x04\x4d" + b"3DM             " * 5)


def wrong(
    kind: str, seed: int = 0, answer: tuple[RawField, ...] = (ACK, RESPONSE)
) -> tuple[int, list[RawField], list[Injected]]:
    log: list[Injected] = []
    delay, fields = Faults(seed=seed, log=log.append, **{kind: 1.0}).answer(7, COMMAND, list(answer))
    return delay, fields, log


def _decodes(raw: RawField) -> bool:
    try:
        return registry.decode(raw) is not None
    except DecodeError:
        return False


#: The effect of each on a reply with a response.
ANSWERS: dict[str, Callable[[int, list[RawField]], bool]] = {
    "late_answer": lambda delay, fields: 0 < delay <= 2e9 and fields == [ACK, RESPONSE],
    "lose_answer": lambda delay, fields: not fields,
    "refuse": lambda delay, fields: [f[:2] for f in fields] == [ACK[:2]] and fields[0].data[1] != 0,
    "wrong_ack": lambda delay, fields: fields[0].data[0] != ACK.data[0] and fields[1] == RESPONSE,
    "unknown_field_in_answer": lambda delay, fields: fields[:2] == [ACK, RESPONSE]
    and not registry.types(*fields[2][:2]),
    "lose_ack": lambda delay, fields: fields == [RESPONSE],
    "lose_response": lambda delay, fields: fields == [ACK],
    "wrong_descriptor": lambda delay, fields: not registry.types(*fields[1][:2]) and fields[1].data == RESPONSE.data,
    "wrong_size": lambda delay, fields: fields[1][:2] == RESPONSE[:2] and not _decodes(fields[1]),
    "other_response": lambda delay, fields: fields[1].descriptor != RESPONSE.descriptor,
    "garbage": lambda delay, fields: fields[1][:2] == RESPONSE[:2]
    and len(fields[1].data) == len(RESPONSE.data)
    and fields[1].data != RESPONSE.data,
    "longer_response": lambda delay, fields: INFO.decode_with_trailing(fields[1].data)
    == (INFO.decode(RESPONSE.data), len(fields[1].data) - len(RESPONSE.data)),
}  # fmt: skip


@pytest.mark.parametrize("kind", sorted(kinds("answer", "response")))
@pytest.mark.parametrize("seed", range(rounds(2, 20)))
def test_each_fault_of_answers(kind: str, seed: int) -> None:
    delay, fields, log = wrong(kind, seed)
    assert ANSWERS[kind](delay, fields), fields
    assert (delay == 0) is (kind != "late_answer")
    (entry,) = log
    assert (entry.now, entry.kind, entry.damaged) == (7, kind, False)
    assert entry.command == (None if kind.startswith(("unknown", "longer")) else COMMAND)
    assert wrong(kind, seed) == (delay, fields, log)


@pytest.mark.parametrize("kind", kinds("response"))
def test_what_has_no_response_keeps_its_acknowledge(kind: str) -> None:
    assert wrong(kind, answer=(ACK,)) == (0, [ACK], [])


def test_bytes_are_added_only_where_they_mean_nothing() -> None:
    """Not to an array that reaches to the end of the field, where they would be more elements."""
    kind = base.GetDeviceDescriptors.RESPONSES[0]
    response = RawField(0x01, kind.DESCRIPTOR, bytes.fromhex("01010102"))
    assert kind.decode_with_trailing(response.data + b"\x00\x00")[1] == 0
    assert wrong("longer_response", answer=(ACK, response)) == (0, [ACK, response], [])


def test_the_response_of_another_command_is_one_that_was_sent() -> None:
    faults = Faults(script=["other_response@2"])
    other = RawField(0x01, 0x83, b"\x00" * 4)
    faults.answer(0, RawField(0x01, 0x05, b""), [ACK, other])
    assert faults.answer(0, COMMAND, [ACK, RESPONSE]) == (0, [ACK, other])


# --------------------------------------------------------------------------- data, commands, events


def test_newer_layouts_keep_what_is_known() -> None:
    """Bytes are added behind the known ones, and unknown fields behind the known fields."""
    log: list[Injected] = []
    faults = Faults(log=log.append, longer=1.0)
    accel = sensor.ScaledAccel((1.0, 2.0, 3.0))
    known = RawField(0x80, accel.DESCRIPTOR, accel.encode())
    for _ in range(20):
        (raw,) = faults.data(0, 0x80, [known])
        value, more = sensor.ScaledAccel.decode_with_trailing(raw.data)
        assert value == accel and 1 <= more <= 8
    assert {entry.kind for entry in log} == {"longer"} and not any(entry.damaged for entry in log)
    first, unknown = Faults(unknown_field=1.0).data(0, 0x80, [known])
    assert first == known and not registry.types(unknown.set, unknown.descriptor)


@pytest.mark.parametrize("kind", kinds("data"))
def test_a_full_packet_stays_within_its_size(kind: str) -> None:
    faults = Faults(**{kind: 1.0})
    for left in range(12):
        fields = [RawField(0x80, 0x04, bytes(12))] * 17
        fields.append(RawField(0x80, 0x77, bytes(255 - 17 * 14 - 2 - left)))
        made = faults.data(0, 0x80, fields)
        assert sum(len(f.data) + 2 for f in made) <= 255
        assert (made == fields) is (left == 0 or (kind == "unknown_field" and left < 2))


@pytest.mark.parametrize("kind", kinds("byte"))
@pytest.mark.parametrize("size", [1, 7, 1000])
def test_the_way_to_the_device(kind: str, size: int) -> None:
    """The same, however the stream is cut; the log says which bytes."""
    sent, log = bytes(range(256)) * 4, []
    faults = Faults(log=log.append, **{kind: 0.05})
    received = b"".join(faults.receive(0, sent[at : at + size]) for at in range(0, len(sent), size))
    places = [int(entry.detail.split()[1]) - 1 for entry in log]
    assert 20 < len(places) < 100
    if kind == "command_lose":
        assert received == bytes(b for at, b in enumerate(sent) if at not in places)
    elif kind == "command_double":
        assert received == b"".join(bytes([b]) * (1 + (at in places)) for at, b in enumerate(sent))
    else:
        assert [at for at, pair in enumerate(zip(sent, received, strict=True)) if pair[0] != pair[1]] == places
    whole = Faults(**{kind: 0.05})
    assert whole.receive(0, sent) == received


@pytest.mark.parametrize("kind", kinds("tick"))
def test_events(kind: str) -> None:
    log: list[Injected] = []
    faults = Faults(log=log.append, script=[f"{kind}@2"])
    assert [faults.event(now) for now in range(4)] == ["", kind, "", ""]
    assert [(entry.now, entry.kind) for entry in log] == [(1, kind)]


# --------------------------------------------------------------------------- command line


def test_what_the_command_line_says() -> None:
    found = parse_faults("lose=0.001, noise=0.01:16,lose_answer@3,lose_answer@5,lose_answer=0.5")
    assert found == {
        "lose": plan("lose", 0.001),
        "noise": plan("noise", 0.01, 16),
        "lose_answer": plan("lose_answer", 0.5, places=(3, 5)),
    }
    assert parse_faults("") == {}
    every = parse_faults("all=0.25,noise=1")
    assert set(every) == set(KINDS) and every["noise"].rate == 1 and every["lose"].rate == 0.25


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("looose=0.1", "fault 'looose' is unknown; do you mean 'lose'? known faults: lose, cut, "),
        ("xyz@1", "fault 'xyz' is unknown; known faults: "),
        ("lose=2", "fault lose: rate 2 is not a probability; use 0 to 1"),
        ("lose=-1", "fault lose: rate -1 is not a probability"),
        ("lose=nan", "fault lose: rate nan is not a probability"),
        ("lose=often", "fault 'lose=often': 'often' is not a number"),
        ("lose", "fault 'lose' cannot be read; write KIND=RATE, KIND=RATE:AMOUNT or KIND@N"),
        ("lose@0", "fault lose: numbers begin with lose@1"),
        ("nmea=0.1:3", "fault nmea has no amount; write nmea=0.1"),
        ("lose=0.1:0.5", "fault lose: amount 0.5 must be at least 1 byte, and at most 1e6"),
        ("delay=0.1:0", "fault delay: amount 0 must be above 0 s, and at most 1e6"),
        ("delay=0.1:nan", "fault delay: amount nan must be above 0 s"),
    ],
)
def test_what_cannot_be_read(text: str, error: str) -> None:
    with pytest.raises(Failure) as raised:
        parse_faults(text)
    assert str(raised.value).startswith(error)


# --------------------------------------------------------------------------- a device


def test_a_late_answer_does_not_hold_back_data() -> None:
    """It comes later than data that are sent after it, and never inside a packet whose rest is delayed."""
    log: list[Injected] = []
    faults = Faults(log=log.append, every_packet=True, script=("late_answer@3",), delay=0.3)
    device = VirtualDevice("3dm-cv7-gnss-ins", faults=faults)
    fields = tuple(types.DescriptorRate(d, 10) for d in (0xD3, 0x04, 0x05))
    link, parser = device.connect(), Parser()
    found: list[tuple[bytes, float]] = []
    for command in (
        mip_3dm.MessageFormat.write(0x80, fields), mip_3dm.DataStreamControl.write(0x80, True), base.GetDeviceInfo()
    ):  # fmt: skip
        link.write(bytes(command.packet()))
    for _ in range(200):
        device.advance(0.02)
        found += [(bytes(p), device.now / 1e9) for p in parser.feed(link.read())]
    (late,) = [entry for entry in log if entry.kind == "late_answer"]
    (answered,) = [time for packet, time in found if packet[2] == 0x01]
    assert answered >= float(late.detail.split()[0]) > 0.2
    assert sum(packet[2] == 0x80 and time < answered for packet, time in found) > 20
    came = [packet for packet, _ in found if packet[2] == 0x80]
    sent = [entry.packet for entry in log if entry.kind == "sent" and entry.packet and entry.packet[2] == 0x80]
    assert came == sent[: len(came)], "the last ones are on the way"
