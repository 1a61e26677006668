"""Examples, byte by byte, with the meaning of each value."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from mipgen import model as m
from mipgen.facts import describe, descriptors
from mipgen.facts.misprints import differences
from mipgen.lower import codec, extent

from .fields import on_page
from .places import Page, examples_page, label
from .text import code, decimal, hexadecimal, inline, plain, spaced, table


@dataclass(frozen=True, slots=True)
class Piece:
    """Some bytes of an example, and their meaning."""

    data: bytes
    name: str  # Markdown
    value: str  # Markdown


@dataclass(frozen=True, slots=True)
class Around:
    """The record around a value, and the device that sends or receives it."""

    parameters: Sequence[m.Parameter]
    values: Mapping[str, Any]
    device: m.Device | None
    model: m.Model
    page: Page
    fields_of: int | None = None  # the set to which the record's field descriptors belong

    def inside(self, p: m.Parameter, inner: m.Struct, values: Mapping[str, Any]) -> Around:
        """Returns the surroundings of the values in a nested structure."""
        number = descriptors.set_of(p, self.values, self.model)
        return replace(self, parameters=inner.parameters, values=values, fields_of=number)


# --------------------------------------------------------------------------- bytes


def device(page: Page, x: m.Example) -> m.Device | None:
    """Returns the device that sends or receives an example; None also if a partial specification lacks it."""
    return page.model.device(x.device.id) if x.device else None


def right_bytes(x: m.Example) -> str:
    """Returns the correct bytes: only the field's bytes if the manual shows it without a packet."""
    return spaced(x.packet[4:-2] if x.role == "field" else x.packet)


def misprints(x: m.Example) -> list[str]:
    """Lists the differences between the bytes in the manual and the correct ones."""
    return [plain(d) for d in differences(x)]


@dataclass(frozen=True, slots=True)
class Part:
    """The examples of a page."""

    path: str
    manual: m.Manual
    title: str  # Markdown
    examples: tuple[m.Example, ...]


def parts(model: m.Model) -> list[Part]:
    """Returns one page for each manual and family. The examples are in the order of the manual's sections."""
    found = []
    for manual in model.protocol.manuals:
        order = {section: i for i, section in enumerate(manual.sections)}
        own = sorted((x for x in model.examples if x.manual == manual.id), key=lambda x: order.get(x.section, -1))
        for path in sorted({examples_page(x, model) for x in own}):
            shown = tuple(x for x in own if examples_page(x, model) == path)
            s = model.set(shown[0].set)
            family = model.family(s.family) if s else None
            found.append(Part(path, manual, label(family) if family else hexadecimal(shown[0].set), shown))
    return found


# --------------------------------------------------------------------------- tables of bytes


def packet_table(page: Page, x: m.Example) -> str:
    """Explains every byte of an example."""
    pieces = [piece for part in x.fields for piece in _field(page, x, part)]
    if x.role != "field":
        s = page.model.set(x.set)
        head = [
            Piece(x.packet[:2], "sync", ""),
            Piece(x.packet[2:3], "descriptor set", page.link(s) if s else "unknown"),
            Piece(x.packet[3:4], "payload length", str(x.packet[3])),
        ]
        pieces = [*head, *pieces, Piece(x.packet[-2:], "checksum", "")]
    return _table(pieces)


def typical(page: Page, f: m.Field) -> m.Call:
    """Returns the form whose typical values a page shows: for a command, the first that a device accepts."""
    return page.index.samples.sent(f)[0] if f.role == m.COMMAND else f.calls[0]


def pieces(page: Page, f: m.Field) -> list[Piece]:
    """Returns the parameters of a field with typical values."""
    values = page.index.samples.values(f, typical(page, f))
    return list(_record(Around(f.parameters, values, None, page.model, page), codec.encode(f, dict(values)), ""))


def printed(page: Page, f: m.Field) -> list[m.Example]:
    """Returns the manuals' examples of a command or a data field, and of its responses."""
    return list({x.id: x for g in on_page(page, f) for x in page.index.examples(g)}.values())


def _table(pieces: Iterable[Piece]) -> str:
    return table([[code(spaced(p.data)), p.name, p.value] for p in pieces], ["Bytes", "Part", "Value"])


def _field(page: Page, x: m.Example, part: m.ExampleField) -> Iterator[Piece]:
    head = bytes([len(part.data) + 2, part.descriptor])
    f = page.model.field(part.field) if part.field else None
    yield Piece(head, "field length, descriptor", page.link(f) if f else "unknown")
    pieces = _record(Around(f.parameters, part.values or {}, x.device, page.model, page), part.data, "") if f else ()
    answered = page.index.shown(x, part) if f is page.model.protocol.acknowledge else []
    at = 0
    for piece in pieces:
        if at == 0 and answered:  # an acknowledge begins with the descriptor of its command
            piece = replace(piece, value=page.links(filter(None, map(page.model.field, answered))))
        at += len(piece.data)
        yield piece
    if part.data[at:]:
        yield Piece(part.data[at:], "extra bytes" if f else "data", "")


def _record(around: Around, data: bytes, prefix: str) -> Iterator[Piece]:
    """Yields the parameters of a record that are present, in order, each with its bytes."""
    at = 0
    for p in around.parameters:
        if p.constant is None and p.name not in around.values:
            return
        value = p.constant if p.constant is not None else around.values[p.name]
        for piece in _parameter(p, value, around, data[at:], prefix + p.name):
            at += len(piece.data)
            yield piece


def _parameter(p: m.Parameter, value: Any, around: Around, data: bytes, name: str) -> Iterator[Piece]:
    item = p.item
    if p.struct:
        yield from _record(around.inside(p, p.struct, value), data, f"{name}.")
    elif item.struct:
        for i, one in enumerate(value):
            rest = data[i * item.struct.max_size :]
            yield from _record(around.inside(p, item.struct, one), rest, f"{name}[{i}].")
    elif item.several:
        size = extent.element(p)
        for i, one in enumerate(value):
            yield Piece(data[i * size : (i + 1) * size], code(f"{name}[{i}]"), _numbers(p, one, around))
    elif p.union:
        for q in (q for q in p.alternatives if q.name in value):
            yield from _parameter(q, value[q.name], around, data, f"{name}.{q.name}")
    elif p.kind == "text":
        yield Piece(data[: len(value)], code(name), code(f'"{_printable(value)}"'))
    else:
        size = len(value) * item.size if p.kind == "array" else p.size
        yield Piece(data[:size], code(name), _value(p, value, around))


# --------------------------------------------------------------------------- values


def _value(p: m.Parameter, value: Any, around: Around) -> str:
    """Writes a value or a list of values, with names and units."""
    t = _type(p, around)
    if t is None:
        each = value if isinstance(value, list) else [value]
        return ", ".join(_hexadecimal(p, v, around) for v in each) if p.shown else _numbers(p, each, around)
    if isinstance(t, m.Bitfield) and t.scalar is None:
        return _flags(t, int.from_bytes(bytes(value), "little"))
    each = value if isinstance(value, list) else [value]
    return ", ".join(_flags(t, v) if isinstance(t, m.Bitfield) else _name(t, v) for v in each)


def _hexadecimal(p: m.Parameter, value: int, around: Around) -> str:
    """Writes a number in hexadecimal, with the set or the field that it identifies."""
    number = descriptors.set_of(p, around.values, around.model) or around.fields_of
    meant = descriptors.meant(p, value, number, around.model)
    shown = code(descriptors.hexadecimal(p, value))
    return f"{shown} {around.page.link(meant, inline(meant.title))}" if meant else shown


def _variants(p: m.Parameter, around: Around) -> list[m.Variant]:
    """Returns the variants that apply here, by the device or by the value of another parameter."""
    device = around.device.id if around.device else None
    return [v for v in p.variants if (v.key == device if v.by_device else v.value == around.values.get(v.by))]


def _type(p: m.Parameter, around: Around) -> m.Enum | m.Bitfield | None:
    """Returns the type that names a value; another parameter or the device may select it."""
    named = next((v.type for v in _variants(p, around) if v.type is not None), None)
    return named or (p.leaf.named)


def _numbers(p: m.Parameter, values: Sequence[Any], around: Around) -> str:
    units = next((v.units for v in _variants(p, around) if v.units), p.units)
    model = around.model
    shown = [decimal(v) if isinstance(v, str) else str(v) for v in values]
    elements = next((v.elements for v in _variants(p, around) if v.elements), p.elements)
    if len(elements) == len(shown) <= 4:
        shown = [f"{name} {v}" for name, v in zip(elements, shown, strict=True)]
    if len(units) == len(shown) > 1:
        return inline(", ".join(describe.measured(v, u, model) for v, u in zip(shown, units, strict=True)))
    return inline(describe.measured(", ".join(shown), units[0] if units else None, model))


def _printable(text: str) -> str:
    return "".join(c if " " <= c <= "~" else f"\\x{ord(c):02x}" for c in text)


def _name(t: m.Enum, value: int) -> str:
    known = next((v for v in t.values if v.value == value), None)
    return f"{code(known.name)} ({value})" if known else str(value)


def _flags(t: m.Bitfield, value: int) -> str:
    """
    >>> bits = (m.Bits("on", 0, 0, "", False), m.Bits("level", 4, 6, "", False))
    >>> _flags(m.Bitfield("state", m.SCALARS["u8"], 1, bits, "", None), 0xB1)
    '`0xB1`: `on`, `level` 3, unnamed bits `0x80`'
    """
    parts, rest = [], value
    for b in t.bits:
        number = (value & b.mask) >> b.first
        if b.alias:
            continue
        rest &= ~b.mask
        if b.width > 1 and number:
            parts.append(f"{code(b.name)} {_name(b.enum, number) if b.enum else number}")
        elif number:
            parts.append(code(b.name))
    if rest:
        parts.append(f"unnamed bits {code(hexadecimal(rest, t.size))}")
    shown = code(hexadecimal(value, t.size))
    return f"{shown}: {', '.join(parts)}" if parts else shown
