"""The kinds of faults, and how they are written on the command line."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from mip_tools.errors import Misuse


@dataclass(frozen=True)
class Kind:
    """One kind of fault: what it affects, and its maximum amount by default."""

    of: str
    description: str
    amount: float = 0.0
    unit: str = ""


#: The targets of faults. A rate is the probability for each of these.
CHANCES = {
    "packet": "packet that the device sends",
    "data": "data packet, before its checksum is computed",
    "answer": "answer to a command, before its checksum is computed",
    "response": "answer that has a response",
    "byte": "byte on the way to the device",
    "tick": "100 ms of simulated time",
}

KINDS: dict[str, Kind] = {
    "lose": Kind("packet", "consecutive bytes of a packet are lost", 4, "bytes"),
    "cut": Kind("packet", "the end of a packet is lost"),
    "change": Kind("packet", "bytes of a packet are changed", 4, "bytes"),
    "double": Kind("packet", "consecutive bytes of a packet arrive twice", 4, "bytes"),
    "lose_packet": Kind("packet", "a whole packet is lost"),
    "double_packet": Kind("packet", "a whole packet arrives twice"),
    "repeat_packet": Kind("packet", "a whole packet arrives again, later", 0.1, "s"),
    "reorder_packet": Kind("packet", "a whole packet arrives later than packets that follow it", 0.1, "s"),
    "delay": Kind("packet", "the rest of a packet arrives later", 0.1, "s"),
    "delay_packet": Kind("packet", "a whole packet, and what follows it, arrives later", 0.1, "s"),
    "noise": Kind("packet", "random bytes precede a packet", 64, "bytes"),
    "nmea": Kind("packet", "an NMEA sentence precedes a packet"),
    "false_header": Kind("packet", "bytes that look like the start of a packet precede a packet"),
    "unknown_set": Kind("packet", "a packet with an unknown descriptor set precedes a packet"),
    "unknown_field": Kind("data", "a data packet has an additional field with an unknown descriptor"),
    "longer": Kind("data", "a data field has bytes after its known parameters", 8, "bytes"),
    "late_answer": Kind("answer", "an answer arrives late", 2.0, "s"),
    "lose_answer": Kind("answer", "ACK and response are missing"),
    "refuse": Kind("answer", "the device carries out a command, but NACKs it with a random code"),
    "wrong_ack": Kind("answer", "the ACK names another command"),
    "unknown_field_in_answer": Kind("answer", "an unknown field follows the answer"),
    "lose_ack": Kind("response", "the response arrives without an ACK"),
    "lose_response": Kind("response", "the ACK arrives without the response"),
    "wrong_descriptor": Kind("response", "the response has an unknown descriptor"),
    "wrong_size": Kind("response", "the response is shorter than any layout of it"),
    "other_response": Kind("response", "the response belongs to another command"),
    "garbage": Kind("response", "the response contains random data, in a packet with a correct checksum"),
    "longer_response": Kind("response", "bytes follow the parameters of the response", 8, "bytes"),
    "command_lose": Kind("byte", "a byte is lost on the way to the device"),
    "command_change": Kind("byte", "a byte is changed on the way to the device"),
    "command_double": Kind("byte", "a byte reaches the device twice"),
    "reset": Kind("tick", "the device restarts, as after a power loss"),
    "disconnect": Kind("tick", "all connections are closed"),
}


@dataclass(frozen=True)
class Plan:
    """When a fault occurs: with a probability, and at numbered opportunities, counted from 1 (`places`)."""

    rate: float = 0.0
    amount: float = 0.0
    places: frozenset[int] = field(default_factory=frozenset)


def plan(kind: str, rate: float = 0.0, amount: float | None = None, places: Iterable[int] = ()) -> Plan:
    """Makes a plan for a kind of fault. Raises Failure if a value is wrong."""
    fault = KINDS.get(kind)
    if fault is None:
        near = difflib.get_close_matches(kind, KINDS, 1)
        hint = f"do you mean {near[0]!r}? " if near else ""
        raise Misuse(f"fault {kind!r} is unknown; {hint}known faults: {', '.join(KINDS)}")
    if not 0 <= rate <= 1:
        raise Misuse(f"fault {kind}: rate {rate:g} is not a probability; use 0 to 1")
    if amount is not None and not fault.unit:
        raise Misuse(f"fault {kind} has no amount; write {kind}={rate:g}")
    if (amount is not None and not (0 < amount <= 1e6)) or (amount and fault.unit == "bytes" and amount < 1):
        least = "at least 1 byte" if fault.unit == "bytes" else "above 0 s"
        raise Misuse(f"fault {kind}: amount {amount:g} must be {least}, and at most 1e6")
    numbers = frozenset(places)
    if any(n < 1 for n in numbers):
        raise Misuse(f"fault {kind}: numbers begin with {kind}@1")
    return Plan(rate, fault.amount if amount is None else amount, numbers)


_PART = re.compile(r"(?P<kind>[a-z_]+)(?:=(?P<rate>[^:@]+)(?::(?P<amount>[^:@]+))?|@(?P<place>[0-9]+))\Z")


def parse_faults(text: str) -> dict[str, Plan]:
    """Parses faults of the command line: "lose=0.001,noise=0.01:16,lose_answer@3". Raises Failure.

    KIND=RATE is a probability, KIND=RATE:AMOUNT also limits the amount, KIND@N happens at the Nth
    chance. `all` stands for every kind.

    >>> parse_faults("noise=0.01:16,noise@3")
    {'noise': Plan(rate=0.01, amount=16.0, places=frozenset({3}))}
    """
    plans: dict[str, Plan] = {}
    for part in filter(None, (p.strip() for p in text.split(","))):
        match = _PART.match(part)
        if match is None:
            raise Misuse(f"fault {part!r} cannot be read; write KIND=RATE, KIND=RATE:AMOUNT or KIND@N")
        kind, place = match["kind"], match["place"]
        for name in KINDS if kind == "all" else (kind,):
            old = plans.get(name)
            rate = _number(match["rate"], part) if match["rate"] else old.rate if old else 0.0
            amount = _number(match["amount"], part) if match["amount"] else None
            if amount is None and old is not None and KINDS[name].unit:
                amount = old.amount
            places = (old.places if old else frozenset()) | ({int(place)} if place else set())
            plans[name] = plan(name, rate, amount, places)
    return plans


def _number(text: str, part: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise Misuse(f"fault {part!r}: {text!r} is not a number") from None


def kinds_table() -> str:
    """Lists all kinds, for the help of the command line."""
    lines = []
    for chance, text in CHANCES.items():
        lines.append(f"for each {text}:")
        for name, kind in KINDS.items():
            if kind.of == chance:
                most = f" (at most {kind.amount:g} {kind.unit})" if kind.unit else ""
                lines.append(f"  {name:<24}{kind.description}{most}")
    return "\n".join(lines)
