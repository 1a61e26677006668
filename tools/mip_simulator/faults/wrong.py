"""Makes answers and fields that deviate from the specification. All choices come from the caller's random generator."""

from __future__ import annotations

from functools import cache
from random import Random

from mip_tools.binding import (
    MAX_PAYLOAD,
    AckCode,
    Acknowledge,
    DecodeError,
    Field,
    RawField,
    Response,
    all_types,
    chosen,
    types,
)

ACKNOWLEDGE = Acknowledge.DESCRIPTOR


def answer(
    kind: str, command: RawField, fields: list[RawField], seen: dict[tuple[int, int], RawField], random: Random
) -> tuple[list[RawField], str]:
    """Returns an answer with a fault, and a description of the fault; the fields are unchanged if it is not applicable.

    `seen`: earlier responses, by set and descriptor.
    """
    if kind == "lose_answer":
        return [], "the answer is missing"
    if not fields or fields[0].descriptor != ACKNOWLEDGE:
        return fields, ""  # another fault has removed the acknowledge field
    ack, rest = fields[0], fields[1:]
    if kind == "refuse":
        code = random.choice([c for c in AckCode if c])
        made = ack._replace(data=bytes((command.descriptor, code)))
        return [made], f"the command is refused with code {int(code)}"
    if kind == "wrong_ack":
        other = random.choice([d for d in range(1, 0x80) if d != command.descriptor])
        made = ack._replace(data=bytes((other,)) + ack.data[1:])
        return [made, *rest], f"the acknowledge names command 0x{other:02X}"
    if not rest:
        return fields, ""
    if kind == "lose_ack":
        return rest, "the acknowledge is missing"
    if kind == "lose_response":
        return [ack], "the response is missing"
    made = _response(kind, rest[0], seen, random)
    if made == rest[0]:
        return fields, ""
    what = f"0x{made.set:02X},0x{made.descriptor:02X} with {len(made.data)} bytes of data"
    return [ack, made, *rest[1:]], f"the response is {what}"


def _response(kind: str, raw: RawField, seen: dict[tuple[int, int], RawField], random: Random) -> RawField:
    if kind == "wrong_descriptor":
        return unused_response(raw, random)
    if kind == "other_response":
        return other_response(raw, seen, random)
    if kind == "wrong_size":
        return shorter(raw, random)
    return raw._replace(data=random.randbytes(len(raw.data)))  # garbage


def room(fields: list[RawField]) -> int:
    """Returns the number of free bytes in a packet with these fields."""
    return MAX_PAYLOAD - sum(len(f.data) + 2 for f in fields)


def unknown_field(set_number: int, fields: list[RawField], random: Random) -> RawField | None:
    """Makes a field with a descriptor that the set does not define; None if the packet is full."""
    size = min(room(fields) - 2, random.randrange(24))
    if size < 0:
        return None
    first, last = (0x80, 0xF0) if set_number < 0x80 else (0x01, 0xCF)
    free = [d for d in range(first, last + 1) if not types(set_number, d)]
    return RawField(set_number, random.choice(free), random.randbytes(size)) if free else None


def longer(fields: list[RawField], places: range, most: int, random: Random) -> tuple[int, RawField] | None:
    """Adds bytes after the known parameters of a field, as newer firmware may. Returns its index, and the field.

    The extra bytes must not be ambiguous, so fields that end with an array of any length, and fields whose
    size selects the layout, are excluded. Returns None if there is no other field, or no room.
    """
    for at in random.sample(places, len(places)):
        raw = fields[at]
        count = min(random.randint(1, most), room(fields), 253 - len(raw.data))
        made = raw._replace(data=raw.data + random.randbytes(max(count, 0)))
        old, new = _left_over(raw), _left_over(made)
        if count > 0 and old is not None and new is not None and new - old == count:
            return at, made
    return None


def _left_over(raw: RawField) -> int | None:
    kind = chosen(types(raw.set, raw.descriptor), raw)
    try:
        return None if kind is None else kind.decode_with_trailing(raw.data)[1]
    except DecodeError:
        return None


def shorter(raw: RawField, random: Random) -> RawField:
    """Shortens a response below the size of all its layouts; unchanged if that is impossible."""
    for size in random.sample(range(len(raw.data)), len(raw.data)):
        made = raw._replace(data=raw.data[:size])
        if all(_truncated(t, made.data) for t in types(raw.set, raw.descriptor)):
            return made
    return raw


def _truncated(kind: type[Field], data: bytes) -> bool:
    try:
        kind.decode(data)
    except DecodeError:
        return True
    return False


@cache
def wrong_responses(set_number: int) -> tuple[type[Response], ...]:
    return tuple(t for n, t in all_types() if n == set_number and issubclass(t, Response))


def other_response(raw: RawField, seen: dict[tuple[int, int], RawField], random: Random) -> RawField:
    """Returns the response to another command: one that was sent before, else random data with its descriptor."""
    sent = [f for (n, d), f in sorted(seen.items()) if n == raw.set and d != raw.descriptor]
    if sent:
        return random.choice(sent)
    descriptors = sorted({t.DESCRIPTOR for t in wrong_responses(raw.set)} - {raw.descriptor})
    descriptor = random.choice(descriptors) if descriptors else raw.descriptor ^ 1
    return RawField(raw.set, descriptor, random.randbytes(len(raw.data)))


def unused_response(raw: RawField, random: Random) -> RawField:
    """Returns the same data with a descriptor that no response of the set has."""
    used = {t.DESCRIPTOR for t in wrong_responses(raw.set)} | {ACKNOWLEDGE}
    free = [d for d in range(0x80, 0xF0) if d not in used]
    return raw._replace(descriptor=random.choice(free))
