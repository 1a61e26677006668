"""Types: the kind of each, and its values or bits."""

from __future__ import annotations

from mipgen import model as m
from mipgen.facts import describe

from .fields import length
from .places import Page
from .text import code, hexadecimal, table


def nature(t: m.Type) -> str:
    """Describes the kind of a type, and its length."""
    match t:
        case m.Enum():
            return f"Enumeration, {code(t.scalar.name)}"
        case m.Bitfield():
            return f"Bitfield, {code(t.scalar.name) if t.scalar else f'{t.size} bytes, the least significant first'}"
        case m.Vector():
            return f"{len(t.elements)} × {code(t.scalar.name)}, {len(t.elements) * t.scalar.size} bytes"
        case m.Struct():
            return f"Structure, {length(t.parameters, 0)} bytes"


def values(page: Page, t: m.Enum, anchor: str = "") -> str:
    """Writes a table of the values; `anchor`, if given, is the prefix of the rows' anchors."""
    rows = [
        [
            str(v.value),
            code(hexadecimal(v.value, t.scalar.size)),
            _anchor(anchor, v.name) + code(v.name),
            _description(page, v.description, describe.value(v, page.model)),
        ]
        for v in t.values
    ]
    return table(rows, ["Value", "Hex", "Name", "Description"])


def bits(page: Page, t: m.Bitfield, anchor: str = "") -> str:
    """Writes a table of the bits, including bits that overlap others."""
    rows = []
    others = (1 << 8 * t.size) - 1
    for b in t.bits:
        others &= ~b.mask
        place, *facts = describe.bits(b, page.model)
        rows.append([
            page.say(place.value),
            code(hexadecimal(b.mask, t.size)) if t.scalar else "",
            "" if t.scalar else f"{b.first // 8}.{b.first % 8}",
            _anchor(anchor, b.name) + code(b.name),
            _description(page, b.description, facts),
        ])  # fmt: skip
    if others and t.scalar:
        rows.append(["other bits", code(hexadecimal(others, t.size)), "", "", "Reserved or unknown: ignore them."])
    return table(rows, ["Bits", "Mask", "Byte.bit", "Name", "Description"])


def _anchor(before: str, name: str) -> str:
    return f'<a id="{before}.{name}"></a>' if before else ""


def elements(t: m.Vector) -> str:
    rows = [[str(i * t.scalar.size), code(name)] for i, name in enumerate(t.elements)]
    return table(rows, ["Offset", "Element"])


def _description(page: Page, text: str, facts: list[describe.Fact]) -> str:
    return " ".join([*([page.prose(text)] if text else []), *(page.say(f.sentence) for f in facts)])
