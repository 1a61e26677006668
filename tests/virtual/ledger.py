"""Compares what a client reported with what the device did."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import zip_longest

from conformance.client_model import descriptors, walk, wanted_responses
from mipgen import model as m
from mipgen.lower import codec
from support import expected_decode, expected_parse, model
from virtual.commands import Trial
from virtual.session import START, Event, Session

#: How a command ends.
OUTCOMES = {"silent", "acknowledged", "refused", "timed_out", "missing_response", "undecodable"}
#: Those that an acknowledge field caused.
ANSWERS = OUTCOMES - {"silent", "timed_out"}


def check(session: Session) -> None:
    """Every command ended once and as the device answered it, and every intact packet was reported once."""
    packets = arrived(session)
    every_command_ends(session)
    data_are_whole(session.client.events, packets)
    fields_are_conserved(session, packets)
    answers_were_sent(session, packets)
    nobody_waits_in_vain(session)
    failures_have_a_reason(session)


def arrived(session: Session) -> list[bytes]:
    """The packets in what the client received: what the device sent, except for what is logged as spoiled."""
    witness = session.witness
    packets = [bytes.fromhex(p) for p in expected_parse(bytes(session.stream))["packets"]]
    late = expected_parse(bytes(session.stream) + session.link.on_the_way)["packets"]
    came, sent = Counter(bytes.fromhex(p) for p in late), Counter(packet for packet, _ in witness.packets)
    assert sent - came <= Counter(i.packet for i in witness.injected if i.damaged), "a loss is not logged"
    cut = Counter(i.packet for i in witness.injected if i.kind == "disconnect" and i.damaged)
    whole = Counter(packet for packet, carried in witness.packets if packet in carried)
    assert whole - came <= cut, "a packet is lost that no fault has spoiled"
    assert came - sent <= Counter(i.added for i in witness.injected if i.added), "nobody has sent a packet"
    return packets


def every_command_ends(session: Session) -> None:
    ends = Counter(e["command"] for e in session.client.events if e["event"] in OUTCOMES)
    assert dict(ends) == dict.fromkeys(range(len(session.trials)), 1)


def data_are_whole(events: list[Event], packets: list[bytes]) -> None:
    """All data, in order, with the values that the reference finds in them."""
    of = model("real")
    sent = ({"event": "received", **expected_decode(of, p)} for p in packets if p[2] >= 0x80)
    assert [e for e in events if e["event"] == "received" and e["set"] >= 0x80] == list(sent)


def fields_are_conserved(session: Session, packets: list[bytes]) -> None:
    """Each field of a reply is part of one answer, or of the reply to a barrier, or reported as received; only once."""
    events = session.client.events
    came = Counter(len(list(walk(p))) for p in packets if p[2] < 0x80)
    fields = sum(count * packets_ for count, packets_ in came.items())
    used = sum(1 + ("response" in e) for e in events if e["event"] in ANSWERS)
    rest = sum(len(e["fields"]) for e in events if e["event"] == "received" and e["set"] < 0x80)
    assert fields == used + rest + session.client.acknowledged


def replies(packets: list[bytes]) -> Iterator[tuple[int, int, int, int | None, bytes]]:
    """Each acknowledge: set, descriptor and code, and the descriptor and the data of the field behind it."""
    acknowledge = model("real").protocol.acknowledge.descriptor
    for packet in packets:
        fields = list(walk(packet)) if packet[2] < 0x80 else []
        for (descriptor, data), behind in zip_longest(fields, fields[1:], fillvalue=(None, b"")):
            if descriptor == acknowledge and len(data) >= 2:
                yield packet[2], data[0], data[1], *behind


def answers_were_sent(session: Session, packets: list[bytes]) -> None:
    """No answer that the device did not send, and none reported twice that arrived once."""
    left = Counter(replies(packets))
    for e in session.client.events:
        if e["event"] not in ANSWERS:
            continue
        command = session.trials[e["command"]].command
        head = (command.set, command.descriptor, e.get("code", 0))
        own = [r for r in left if left[r] > 0 and r[:3] == head and holds(e, command, r[3], r[4])]
        assert own, e
        left[own[0]] -= 1


def holds(event: Event, command: m.Field, descriptor: int | None, data: bytes) -> bool:
    """Does the event report these bytes, or none, as the response behind the acknowledge?"""
    response = event.get("response")
    if response is None:
        return event["event"] == "refused" or descriptor not in descriptors(model("real"), command)
    if response["descriptor"] != descriptor:
        return False
    if "raw" in response:
        return bool(response["raw"] == data.hex())
    f = model("real").field(response["name"])
    assert f is not None
    try:
        encoded = codec.encode(f, response["values"])
    except codec.CodecError:
        return False
    return data.startswith(encoded) and len(data) == len(encoded) + response["trailing"]


def nobody_waits_in_vain(session: Session) -> None:
    """No acknowledge is reported as answering nothing while a command waits for it."""
    of = model("real")
    acknowledge = of.protocol.acknowledge.full_name
    waiting: dict[int, Trial] = {}
    opened = session.client.opened
    for number, e in enumerate(session.client.events):
        if e["event"] == "sent":
            waiting |= {n: session.trials[n] for n in e["commands"]}
        waiting.pop(e.get("command", -1), None)
        if e["event"] != "received" or e["set"] >= 0x80:
            continue
        for f, behind in zip_longest(e["fields"], e["fields"][1:], fillvalue={}):
            if f.get("name") != acknowledge:
                continue
            for n, trial in waiting.items():
                if opened.get(n, number + 1) > number:
                    continue  # its barrier is not answered yet
                if (trial.command.set, trial.command.descriptor) == (e["set"], f["values"]["command"]):
                    # The response of another command with this descriptor, which timed out or was sent later.
                    assert f["values"]["code"] == 0 and behind, (trial, e)
                    assert not asks_for(of, trial, behind), (trial, e)


def asks_for(of: m.Model, trial: Trial, response: Event) -> bool:
    return any(f.full_name == response.get("name") for f in wanted_responses(of, trial.command, trial.values))


def failures_have_a_reason(session: Session) -> None:
    """A command without a right answer has a reason: a fault struck while it waited, or since the device last answered,
    as a damaged command holds back those behind it until it is complete; or the device was about to start."""
    faults = [i.now for i in session.witness.injected]
    sent: dict[int, int] = {}
    since = 0
    for e, when in zip(session.client.events, session.when, strict=True):
        if e["event"] == "sent":
            sent |= dict.fromkeys(e["commands"], when)
        if e["event"] in ("timed_out", "missing_response", "undecodable"):
            first = min(since, sent[e["command"]] - START * 1_000_000)
            assert any(first <= fault <= when for fault in faults), (session.trials[e["command"]], e)
        elif e["event"] in ANSWERS:
            since = when
