"""Formats packets as JSON objects, one per line."""

from __future__ import annotations

import json
from collections.abc import Iterable
from functools import cache
from typing import Any

from ..binding import Packet
from . import show, values
from .decoding import Found, malformed, name_of


def packet(offset: int, given: Packet, fields: Iterable[Found], device: str | None, raw: bool = False) -> str:
    """Formats a packet with these fields, and with its bytes if `raw` is set."""
    wrong = malformed(given)
    rest = {**({"malformed": wrong} if wrong else {}), **({"raw": bytes(given).hex()} if raw else {})}
    return joined(offset, given.set, [field(found, device) for found in fields], rest)


def joined(offset: int, number: int, fields: Iterable[str], rest: dict[str, str] | None = None) -> str:
    """Formats a packet from the texts of its fields; `rest` are the keys after them."""
    head = f'{{"offset": {offset}, "set": {_set(number)}, "fields": [{", ".join(fields)}]'
    return head + "".join([f", {json.dumps(name)}: {json.dumps(text)}" for name, text in (rest or {}).items()]) + "}"


@cache
def _set(number: int) -> str:
    return json.dumps(show.set_name(number))


def field(found: Found, device: str | None) -> str:
    """Formats a field with its values, and with its bytes if they cannot be decoded or if some are left over."""
    said: dict[str, Any] = {"field": name_of(found)}
    if found.value is not None:
        said["values"] = values.plain(found.value, True, device)
    if found.value is None or found.trailing:
        said["data"] = found.raw.data.hex()
    return json.dumps(said | ({"error": found.error} if found.error else {}), allow_nan=False)


__all__ = ["field", "joined", "packet"]
