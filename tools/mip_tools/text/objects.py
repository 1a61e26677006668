"""Formats packets as JSON objects, one per line."""

from __future__ import annotations

import json
from collections.abc import Iterable
from functools import cache
from typing import Any

from ..binding import Packet
from . import show, values
from .decoding import DecodedField, malformed, name_of
from .references import references


def packet(offset: int, message: Packet, fields: Iterable[DecodedField], reads: show.Reads, raw: bool = False) -> str:
    """Formats a packet with these fields, and with its bytes if `raw` is set."""
    wrong = malformed(message)
    rest = {**({"malformed": wrong} if wrong else {}), **({"raw": bytes(message).hex()} if raw else {})}
    return packet_object(offset, message.set, [field_object(each, reads) for each in fields], rest)


def packet_object(offset: int, number: int, fields: Iterable[str], rest: dict[str, str] | None = None) -> str:
    """Formats a packet from the texts of its fields; `rest` are the keys after them."""
    head = f'{{"offset": {offset}, "set": {_set(number)}, "fields": [{", ".join(fields)}]'
    return head + "".join([f", {json.dumps(name)}: {json.dumps(text)}" for name, text in (rest or {}).items()]) + "}"


@cache
def _set(number: int) -> str:
    return json.dumps(show.set_name(number))


def field_object(decoded: DecodedField, reads: show.Reads) -> str:
    """Formats a field with its values, and with its bytes if they cannot be decoded or if some are left over."""
    content: dict[str, Any] = {"field": name_of(decoded)}
    if decoded.value is not None:
        inside = references(decoded.value, decoded.raw.set)
        content["values"] = values.to_plain(decoded.value, True, reads(type(decoded.value)), inside)
    if decoded.value is None or decoded.trailing:
        content["data"] = decoded.raw.data.hex()
    return json.dumps(content | ({"error": decoded.error} if decoded.error else {}), allow_nan=False)
