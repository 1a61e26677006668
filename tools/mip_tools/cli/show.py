"""Formats packets as lines and trees."""

from __future__ import annotations

from collections.abc import Iterator
from enum import IntFlag

from ..binding import OVERHEAD, SETS, SYNC, Acknowledge, Described, Packet, PacketError, Structure, items, meant
from .decoding import Found, decoded, malformed, name_of, raw_fields
from .inputs import counted
from .selection import Selection


def set_name(number: int) -> str:
    """Returns the name of a descriptor set, or its number if it is unknown."""
    return SETS[number][0] if number in SETS else f"0x{number:02X}"


def spaced(data: bytes, most: int = 0) -> str:
    """Formats bytes in hexadecimal, at most this many."""
    if most and len(data) > most:
        return data[:most].hex(" ") + " …"
    return data.hex(" ")


def selected(packet: Packet, selection: Selection) -> list[Found]:
    """Decodes the selected fields of a packet."""
    raws = raw_fields(packet)
    if selection.everything:
        return [decoded(raw) for raw in raws]
    return [decoded(raw) for raw in raws if selection.has(raw.set, raw.descriptor)]


# --------------------------------------------------------------------------- a line


def line(packet: Packet, fields: list[Found], device: str | None) -> str:
    """Formats a packet in one line: its set, and each field with its values in parentheses."""
    set = set_name(packet.set)
    parts = [f"{short(f, set)}{inside(f, device)}" for f in fields]
    wrong = malformed(packet)
    if wrong:
        parts.append(f"malformed({wrong})")
    return " ".join([f"{set}:", *parts])


def short(found: Found, set: str) -> str:
    """Returns the name of a field without the set of its packet."""
    name = name_of(found)
    return name[len(set) + 1 :] if name.startswith(f"{set}.") else name


def inside(found: Found, device: str | None) -> str:
    """Formats the values of a field in one line, in parentheses; a unit may follow."""
    if found.value is None:
        said = found.raw.data.hex()
        return f"({said}: {found.error})" if found.error else f"({said})"
    own = found.value.NAME.partition(".")[2]
    parts = []
    for item in items(found.value, device):
        label = "" if item.parameter.name == own else f"{item.parameter.name}="
        parts.append(f"{label}{item.text}{'' if item.valid else ' (invalid)'}")
    if found.trailing:
        parts.append(f"and {counted(found.trailing, 'more byte')}: {found.raw.data[-found.trailing :].hex()}")
    one = len(parts) == 1 and parts[0].startswith("(")
    return parts[0] if one else f"({', '.join(parts)})"


# --------------------------------------------------------------------------- a tree


def tree(packet: Packet, fields: list[Found], device: str | None) -> Iterator[str]:
    """Formats a packet, its fields and their values in indented lines, with their bytes."""
    raw = bytes(packet)
    count = sum(1 for _ in raw_fields(packet))
    yield (
        f"{set_name(packet.set)} (0x{packet.set:02X}), {count} field{'s' * (count != 1)}, "
        f"{len(raw)} bytes: {spaced(raw[:4])} … checksum {spaced(raw[-2:])}"
    )
    for f in fields:
        yield from (f"  {text}" for text in branch(f, device))
    wrong = malformed(packet)
    if wrong:
        yield f"  malformed: {wrong}; the rest cannot be read"


def branch(found: Found, device: str | None) -> Iterator[str]:
    """Formats a field and its values in indented lines."""
    raw, kind = found.raw, found.kind
    numbers = f"0x{0 if kind is Acknowledge else raw.set:02X},0x{raw.descriptor:02X}"
    head = f"{name_of(found)} ({numbers})" if kind else f"unknown field ({numbers})"
    role = f" {kind.ROLE}," if kind is not None else ""
    begin = bytes((len(raw.data) + 2, raw.descriptor)) + raw.data
    yield f"{head}{',' if role else ''}{role.rstrip(',')}: {spaced(begin, 24)}"
    if found.error:
        yield f"  cannot be decoded: {found.error}"
    if found.value is None:
        return
    yield from (f"  {text}" for text in leaves(found.value, device))
    if found.trailing:
        more = counted(found.trailing, "more byte")
        yield f"  and {more}: {spaced(raw.data[-found.trailing :])}"


def leaves(value: Described, device: str | None) -> Iterator[str]:
    """Formats the values of a field or structure, one per line."""
    for item in items(value, device):
        name, held = item.parameter.name, item.value
        inner = held if isinstance(held, (list, tuple)) else (held,)
        if inner and all(isinstance(v, Structure) for v in inner):
            for i, one in enumerate(inner):
                yield name if one is held else f"{name}[{i}]"
                yield from (f"  {text}" for text in leaves(one, device))
            continue
        said = item.text
        if isinstance(held, int) and not isinstance(held, bool) and item.parameter.type:
            bits = isinstance(meant(item.parameter, held), IntFlag)
            said += f" (0x{int(held):X})" if bits else f" ({int(held)})" if not said.isdigit() else ""
        yield f"{name} = {said}{'' if item.valid else ' (invalid)'}"


# --------------------------------------------------------------------------- no packet


def skipped(data: bytes) -> str:
    """Describes bytes outside packets, with the reason if they look like a packet."""
    reason = damage(data)
    return f"{counted(len(data), 'byte')} outside packets{', ' * bool(reason)}{reason}: {_as_text(data)}"


def damage(data: bytes) -> str:
    """Describes what is wrong with bytes that look like a packet; empty if they do not."""
    at = data.find(SYNC)
    if at < 0 or len(data) - at < 4:
        return ""
    size = data[at + 3] + OVERHEAD
    missing = size - (len(data) - at)
    if missing > 0:
        are = "is" if missing == 1 else "are"
        return f"{counted(missing, 'byte')} {are} missing at the end of a packet"
    try:
        Packet(data[at : at + size])
    except PacketError as error:
        return f"checksum {error.detail}" if error.kind == "checksum" else error.detail
    return ""


def _as_text(data: bytes) -> str:
    if data and all(32 <= b < 127 or b in b"\r\n\t" for b in data):
        return repr(data.decode("ascii"))
    return spaced(data, 32)


__all__ = ["branch", "damage", "inside", "leaves", "line", "selected", "set_name", "skipped", "spaced", "tree"]
