"""Encodes messages as little-endian CDR."""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..binding import SECOND

HEAD = b"\0\1\0\0"
_STAMP = struct.Struct("<iI")
_BODY = len(HEAD) + _STAMP.size


def stamped(message: bytes, moment: int) -> bytes:
    """Inserts a time in ns into a message that begins with a header."""
    return HEAD + _STAMP.pack(*divmod(moment, SECOND)) + message[_BODY:]


class Layout(NamedTuple):
    """The encoding of messages with fixed texts, so that all have the same length."""

    dtype: np.dtype[Any]  # the values of inner messages have paths as names: `header.stamp.sec`
    empty: bytes  # a message of zeros, with the texts

    def messages(self, count: int, values: Mapping[str, Any]) -> list[bytes]:
        """Encodes messages with these values, without their times."""
        made = np.frombuffer(bytearray(self.empty * count), self.dtype)
        for path, value in values.items():
            made[path] = value
        data, size = made.tobytes(), len(self.empty)
        return [HEAD + data[at : at + size] for at in range(0, len(data), size)]


def cdr_layout(definitions: Any, name: str, texts: Mapping[str, str]) -> Layout | None:
    """Computes the layout of messages with these texts; None if their length varies."""
    names, types, offsets, values, end = [], [], [], {}, 0
    for path, base, count in _leaves(definitions, name, ""):
        if not base:
            return None
        if base == "string":
            text = texts.get(path, "").encode() + b"\0"
            kind, align = np.dtype([("size", "<u4"), ("text", f"S{len(text)}")]), 4
            values[path] = len(text), text
        else:
            element = np.dtype({"octet": "u1", "byte": "u1", "char": "u1"}.get(base, base)).newbyteorder("<")
            kind, align = np.dtype((element, (count,))) if count else element, element.itemsize
        end = -(-end // align) * align
        names.append(path)
        types.append(kind)
        offsets.append(end)
        end += kind.itemsize
    made = np.zeros((), np.dtype({"names": names, "formats": types, "offsets": offsets, "itemsize": end}))
    for path, value in values.items():
        made[path] = value
    return Layout(made.dtype, made.tobytes())


def _leaves(definitions: Any, name: str, prefix: str) -> Iterator[tuple[str, str, int]]:
    """Yields the values of a message: path, type ("" if its length varies), and array length."""
    for member, (node, detail) in definitions[name][1]:
        if node == 1:
            yield prefix + member, detail[0], 0
        elif node == 2:
            yield from _leaves(definitions, detail, f"{prefix}{member}.")
        else:
            (inner, inside), count = detail
            fixed = node == 3 and inner == 1 and inside[0] != "string"
            yield prefix + member, inside[0] if fixed else "", count
