"""Fast decoders for packets whose layout, the sequence of their fields, occurs often.

A device repeatedly sends packets of a few layouts. A frequent layout gets its own function, which
reads all numbers of the packet at once and creates the objects from them. The first bytes of a
packet and its length select the function, which checks the field headers. Everything else is
decoded the general way, by each field's `decode`, with the same result: unknown fields, fields of
variable layout, other headers, and floats that are NaN.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from typing import Any

from .checks import check_source, function
from .errors import DecodeError
from .field import Field, Shared, chosen
from .packet import Packet, RawField, Undecoded
from .wire import Layout, late, plain, size, value

#: The fields of a packet.
Fields = tuple["Field | RawField", ...]
#: Decodes the packet at an offset; returns None if it must be decoded the general way.
Decode = Callable[[bytes, int], "Fields | None"]

#: The number of first bytes that select a packet's layout: up to the first field's header.
KEY = 6
#: A layout gets its function when it has occurred this many times.
OFTEN = 8
#: The largest number of layouts with their own function.
MOST = 512


class Layouts:
    """Decodes packets, and keeps the functions compiled so far."""

    def __init__(self, types: Callable[[int, int], tuple[type[Field], ...]]) -> None:
        self._types = types
        #: Key -> size and function, which also checks the checksum.
        self.unchecked: dict[bytes, tuple[int, Decode]] = {}
        #: Key -> function for packets that have been checked.
        self.checked: dict[bytes, Decode] = {}
        #: Key -> headers of all fields -> both functions.
        self._made: dict[bytes, dict[bytes, tuple[Decode, Decode]]] = {}
        self._counts: dict[bytes, int] = {}

    def decode(self, packet: Packet) -> Fields:
        """Decodes the fields of a packet; those that are unknown or cannot be decoded stay raw.

        Stops at a malformed field, because no field can be found after it.
        """
        data = bytes(packet)
        decode = self.checked.get(data[:KEY])
        fields = None if decode is None else decode(data, 0)
        return self.decode_slowly(packet) if fields is None else fields

    def decode_slowly(self, packet: Packet) -> Fields:
        """Like `decode`, the general way."""
        raws = packet.fields
        if raws and packet.malformed is None:
            self._count(packet, raws)
        return tuple([self.field(raw) for raw in raws])

    def field(self, raw: RawField) -> Field | RawField:
        kind = chosen(self._types(raw.set, raw.descriptor), raw)
        if kind is None:
            return raw
        try:
            return kind._received(raw)
        except DecodeError as error:
            return Undecoded.because(raw, error)

    def _count(self, packet: Packet, raws: Sequence[RawField]) -> None:
        """Counts a packet's layout, and compiles its function when it has occurred often enough."""
        data = bytes(packet)
        headers = b"".join([bytes((len(raw.data) + 2, raw.descriptor)) for raw in raws])
        layout = data[:4] + headers
        count = self._counts[layout] = self._counts.get(layout, 0) + 1
        if len(self._counts) > 4 * MOST:
            self._counts.clear()
        if count != OFTEN:
            return
        if sum(map(len, self._made.values())) >= MOST:
            self._made.clear()
            self.unchecked.clear()
            self.checked.clear()
        key = data[:KEY]
        made = self._made.setdefault(key, {})
        made[headers] = self._functions(data[:4], raws)
        self.unchecked[key] = (len(data), _chosen({h: both[0] for h, both in made.items()}, 0, 4))
        self.checked[key] = _chosen({h: both[1] for h, both in made.items()}, 0, 4)

    def _functions(self, header: bytes, raws: Sequence[RawField]) -> tuple[Decode, Decode]:
        """Compiles two functions for packets with such fields: with and without a checksum test."""
        source = _Source()
        for raw in raws:
            types = self._types(raw.set, raw.descriptor)
            layout = plain(types[0]) if len(types) == 1 else None
            rest = 0 if layout is None else len(raw.data) - size(layout)
            if layout is None or rest < 0:
                source.add_any(raw, self.field)
            else:
                source.add_numbers(raw, types[0], layout, rest)
        lines, condition = check_source(header, source.names)
        check = [*lines, f"if not ({condition}): return None"]
        return source.function(check), source.function([])


class _Source:
    """The source of a function, built field by field."""

    def __init__(self) -> None:
        self.format = ">6x"  # up to the end of the first header
        self.values: list[str] = []  # what unpacking returns
        self.headers: list[str] = []  # conditions
        self.singles: list[str] = []  # floats of four bytes
        self.lines: list[str] = []
        self.objects: list[str] = []
        self.names: dict[str, Any] = {"new": object.__new__}

    def add_numbers(self, raw: RawField, kind: type[Field], layout: Layout, rest: int) -> None:
        """Adds a field whose values are numbers at fixed offsets."""
        made, cls = self._begin(raw)
        self.names[cls] = kind
        self.lines.append(f"{made} = new({cls})")
        for attribute, letters, what in layout:
            numbers = [f"v{len(self.values) + i}" for i in range(len(letters))]
            self.values += numbers
            self.format += letters
            self.singles += [n for n, letter in zip(numbers, letters) if letter == "f"]
            slot = f"_{attribute}" if attribute in kind._VECTORS else attribute
            source = value(numbers, late(kind, attribute, what), f"K{len(self.values)}", self.names)
            self.lines.append(f"{made}.{slot} = {source}")
        if issubclass(kind, Shared):
            self.lines.append(f"{made}._packet_set = {raw.set}")
        self.format += f"{rest}x"

    def add_any(self, raw: RawField, decode: Callable[[RawField], Field | RawField]) -> None:
        """Adds any other field, which its own `decode` reads."""
        made, how = self._begin(raw)
        value = f"v{len(self.values)}"
        self.values.append(value)
        self.format += f"{len(raw.data)}s"
        self.names |= {how: decode, "RawField": RawField}
        self.lines.append(f"{made} = {how}(RawField({raw.set}, {raw.descriptor}, {value}))")

    def function(self, check: Sequence[str]) -> Decode:
        lines = [*check]
        if self.values:
            lines.append(f"{', '.join(self.values)}, = unpack(buffer, at)")
        if self.headers:
            lines.append(f"if {' or '.join(self.headers)}: return None")
        if self.singles:
            # Python changes the bits of some NaNs. If there is one, the sum is NaN, too.
            lines += [f"total = {' + '.join(self.singles)}", "if total != total: return None"]
        lines += [*self.lines, f"return {', '.join(self.objects)},"]
        self.names["unpack"] = struct.Struct(self.format).unpack_from
        made: Decode = function("decode", lines, dict(self.names))
        return made

    def _begin(self, raw: RawField) -> tuple[str, str]:
        """Adds a field's header. Returns the names of the next object and of what creates it."""
        number = len(self.objects)
        if number:  # the first one is the key
            self.format += "H"
            self.values.append(f"h{number}")
            self.headers.append(f"h{number} != {len(raw.data) + 2 << 8 | raw.descriptor}")
        self.objects.append(f"f{number}")
        return f"f{number}", f"F{number}"


def _chosen(made: dict[bytes, Decode], at: int, offset: int) -> Decode:
    """Returns one function for layouts that differ after their first field.

    The layouts are equal up to the field header at `at` in the keys and at `offset` in the packet.
    """
    if len(made) == 1:
        return next(iter(made.values()))
    some = next(iter(made))
    while all(headers[at : at + 2] == some[at : at + 2] for headers in made):
        offset += some[at]
        at += 2
    groups: dict[bytes, dict[bytes, Decode]] = {}
    for headers, one in made.items():
        groups.setdefault(headers[at : at + 2], {})[headers] = one
    choose = {h: _chosen(group, at, offset) for h, group in groups.items()}.get

    def decode(buffer: bytes, start: int) -> Fields | None:
        chosen = choose(buffer[start + offset : start + offset + 2])
        return None if chosen is None else chosen(buffer, start)

    return decode
