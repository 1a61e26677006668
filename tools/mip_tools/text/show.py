"""Formats packets as lines and trees."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import IntFlag

from ..binding import (
    OVERHEAD,
    SETS,
    SYNC,
    Acknowledge,
    Described,
    Field,
    Item,
    Packet,
    PacketError,
    Structure,
    info,
    meant,
)
from ..names.selection import Selection
from ..text.numbers import count_text
from .decoding import DecodedField, decoded_field, malformed, name_of, raw_fields
from .references import Inside, references


def set_name(number: int) -> str:
    """Returns the name of a descriptor set, or its number if it is unknown."""
    return SETS[number][0] if number in SETS else f"0x{number:02X}"


def spaced_bytes(data: bytes, most: int = 0) -> str:
    """Formats bytes in hexadecimal, at most this many."""
    if most and len(data) > most:
        return data[:most].hex(" ") + " …"
    return data.hex(" ")


def selected(packet: Packet, selection: Selection) -> list[DecodedField]:
    """Decodes the selected fields of a packet."""
    raws = raw_fields(packet)
    if selection.everything:
        return [decoded_field(raw) for raw in raws]
    return [decoded_field(raw) for raw in raws if selection.has(raw.set, raw.descriptor)]


# --------------------------------------------------------------------------- a line


#: Returns the id of the device as which a field is read; None if it is not known.
Reads = Callable[[type[Field]], "str | None"]


def line(packet: Packet, fields: list[DecodedField], reads: Reads) -> str:
    """Formats a packet in one line: its set, and each field with its values in parentheses."""
    set_number = set_name(packet.set)
    parts = [f"{short(f, set_number)}{inside(f, reads)}" for f in fields]
    wrong = malformed(packet)
    if wrong:
        parts.append(f"malformed({wrong})")
    return " ".join([f"{set_number}:", *parts])


def short(field: DecodedField, set_number: str) -> str:
    """Returns the name of a field without the set of its packet."""
    name = name_of(field)
    return name[len(set_number) + 1 :] if name.startswith(f"{set_number}.") else name


def inside(field: DecodedField, reads: Reads) -> str:
    """Formats the values of a field in one line, in parentheses; a unit may follow."""
    if field.value is None:
        text = field.raw.data.hex()
        return f"({text}: {field.error})" if field.error else f"({text})"
    own = field.value.NAME.partition(".")[2]
    parts = []
    for item in field_items(field.value, field.raw.set, reads(type(field.value))):
        label = "" if item.parameter.name == own else f"{item.parameter.name}="
        parts.append(f"{label}{item.text}{'' if item.valid else ' (invalid)'}")
    if field.trailing:
        parts.append(f"and {count_text(field.trailing, 'more byte')}: {field.raw.data[-field.trailing :].hex()}")
    is_vector = len(parts) == 1 and parts[0].startswith("(")
    return parts[0] if is_vector else f"({', '.join(parts)})"


# --------------------------------------------------------------------------- a tree


def tree(packet: Packet, fields: list[DecodedField], reads: Reads) -> Iterator[str]:
    """Formats a packet, its fields and their values in indented lines, with their bytes."""
    raw = bytes(packet)
    count = sum(1 for _ in raw_fields(packet))
    yield (
        f"{set_name(packet.set)} (0x{packet.set:02X}), {count} field{'s' * (count != 1)}, "
        f"{len(raw)} bytes: {spaced_bytes(raw[:4])} … checksum {spaced_bytes(raw[-2:])}"
    )
    for f in fields:
        yield from (f"  {text}" for text in branch(f, reads))
    wrong = malformed(packet)
    if wrong:
        yield f"  malformed: {wrong}; the rest cannot be read"


def branch(field: DecodedField, reads: Reads) -> Iterator[str]:
    """Formats a field and its values in indented lines."""
    raw, kind = field.raw, field.kind
    numbers = f"0x{0 if kind is Acknowledge else raw.set:02X},0x{raw.descriptor:02X}"
    head = f"{name_of(field)} ({numbers})" if kind else f"unknown field ({numbers})"
    role = f" {kind.ROLE}," if kind is not None else ""
    begin = bytes((len(raw.data) + 2, raw.descriptor)) + raw.data
    yield f"{head}{',' if role else ''}{role.rstrip(',')}: {spaced_bytes(begin, 24)}"
    if field.error:
        yield f"  cannot be decoded: {field.error}"
    if field.value is None:
        return
    yield from (f"  {text}" for text in leaves(field.value, reads(type(field.value)), references(field.value, raw.set)))
    if field.trailing:
        more = count_text(field.trailing, "more byte")
        yield f"  and {more}: {spaced_bytes(raw.data[-field.trailing :])}"


def field_items(value: Described, set_number: int, device: str | None) -> list[Item]:
    """Returns the values of a field in packets of this set."""
    made: list[Item] = info(type(value)).items(value, device, references(value, set_number))
    return made


def leaves(value: Described, device: str | None, inside: Inside) -> Iterator[str]:
    """Formats the values of a field or structure, one per line; `inside` are the differences of its members."""
    for item in info(type(value)).items(value, device, inside):
        name, member_value = item.parameter.name, item.value
        inner = member_value if isinstance(member_value, (list, tuple)) else (member_value,)
        if inner and all(isinstance(v, Structure) for v in inner):
            for i, structure in enumerate(inner):
                yield name if structure is member_value else f"{name}[{i}]"
                yield from (f"  {text}" for text in leaves(structure, device, item.parameter.inside(value, device)))
            continue
        text = item.text
        if isinstance(member_value, int) and not isinstance(member_value, bool) and item.parameter.type:
            if item.parameter.refers:
                text += f" (0x{member_value:02X})"
            elif isinstance(meant(item.parameter, member_value), IntFlag):
                text += f" (0x{member_value:X})"
            elif not text.isdigit():
                text += f" ({int(member_value)})"
        yield f"{name} = {text}{'' if item.valid else ' (invalid)'}"


# --------------------------------------------------------------------------- no packet


def skipped(data: bytes) -> str:
    """Describes bytes outside packets, with the reason if they look like a packet."""
    reason = damage_text(data)
    return f"{count_text(len(data), 'byte')} outside packets{', ' * bool(reason)}{reason}: {_as_text(data)}"


def damage_text(data: bytes) -> str:
    """Describes what is wrong with bytes that look like a packet; empty if they do not."""
    at = data.find(SYNC)
    if at < 0 or len(data) - at < 4:
        return ""
    size = data[at + 3] + OVERHEAD
    missing = size - (len(data) - at)
    if missing > 0:
        are = "is" if missing == 1 else "are"
        return f"{count_text(missing, 'byte')} {are} missing at the end of a packet"
    try:
        Packet(data[at : at + size])
    except PacketError as error:
        return f"checksum {error.detail}" if error.kind == "checksum" else error.detail
    return ""


def _as_text(data: bytes) -> str:
    if data and all(32 <= b < 127 or b in b"\r\n\t" for b in data):
        return repr(data.decode("ascii"))
    return spaced_bytes(data, 32)
