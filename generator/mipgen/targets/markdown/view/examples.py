"""Examples, byte by byte, with the meaning of each value."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from mipgen import model as m
from mipgen.facts import describe, descriptors
from mipgen.facts.examples import misprint_text
from mipgen.facts.texts import Ref, field_ref
from mipgen.lower import codec, extent

from ..places import Page
from ..text import code, decimal, escaped_line, hexadecimal, spaced, table
from .base import View

#: The names of parameters, and the numbers of elements, that lead to a value.
Place = tuple[str | int, ...]
#: What a title of a link, within a cell of a table, cannot contain.
_UNFIT = str.maketrans("", "", '"\\|`')


@dataclass(frozen=True, slots=True)
class Code:
    text: str


#: Words, references, and what is shown as code.
Value = tuple["str | Ref | Code", ...]


@dataclass(frozen=True, slots=True)
class Piece:
    """Some bytes of an example, and their meaning."""

    data: bytes
    what: str | Place  # words, or a parameter
    value: Value = ()

    @property
    def name(self) -> str:
        """
        >>> Piece(b"", ("list", 2, "rate")).name
        'list[2].rate'
        """
        if isinstance(self.what, str):
            return self.what
        return "".join(f"[{x}]" if isinstance(x, int) else f".{x}" for x in self.what).removeprefix(".")

    @property
    def heading(self) -> str:
        """Its name in Markdown."""
        return self.what if isinstance(self.what, str) else code(self.name)

    @property
    def title(self) -> str:
        """Its name and its value, as the title of a link."""
        parts = (x if isinstance(x, str) else x.text if isinstance(x, Code) else x.words for x in self.value)
        return (f"{self.name}: {''.join(parts)}" if self.value else self.name).translate(_UNFIT)

    def shown(self, page: Page) -> str:
        """Its value in Markdown."""
        parts = (code(x.text) if isinstance(x, Code) else page.markdown((x,)) for x in self.value)
        return "".join(parts)

    @property
    def path(self) -> str:
        """The path of the parameter whose value or element it shows: `list.rate`."""
        return ".".join(x for x in self.what if isinstance(x, str))


@dataclass(frozen=True, slots=True)
class Scope:
    """The record around a value, and the device that sends or receives it."""

    parameters: Sequence[m.Parameter]
    values: Mapping[str, Any]
    device: m.Device | None
    page: Page
    fields_of: int | None = None  # the set to which the record's field descriptors belong

    def inside(self, p: m.Parameter, inner: m.Struct, values: Mapping[str, Any]) -> Scope:
        """Returns the surroundings of the values in a nested structure."""
        number = descriptors.set_of(p, self.values, self.page.model)
        return replace(self, parameters=inner.parameters, values=values, fields_of=number)


class Example(View[m.Example]):
    @property
    def device(self) -> m.Device | None:
        """The device that sends or receives the example; None also if a partial specification lacks it."""
        return self.page.model.device(self.of.device.id) if self.of.device else None

    @property
    def kind(self) -> str:
        return "one field, without a packet" if self.of.role == "field" else self.of.role

    @property
    def bytes(self) -> str:
        """The correct bytes: only the field's bytes if the manual shows it without a packet."""
        return spaced(self.of.packet[4:-2] if self.of.role == "field" else self.of.packet)

    @property
    def table(self) -> str:
        return packet_table(self.page, self.of)

    @property
    def misprints(self) -> str:
        """The differences between the bytes in the manual and the correct ones, and the errata about them."""
        errata = self.page.links(self.page.index.errata_of_example(self.of))
        misprints = "; ".join(escaped_line(difference) for difference in misprint_text(self.of))
        return misprints and f"{misprints}. See {errata}."


def packet_table(page: Page, x: m.Example) -> str:
    """Explains every byte of an example."""
    pieces = [piece for part in x.fields for piece in _field(page, x, part)]
    if x.role != "field":
        s = page.model.set(x.set)
        header = Piece(
            x.packet[:4],
            "header",
            (Ref(s, f"{s.title} ({hexadecimal(s.number)})") if s else "unknown set", f", payload length {x.packet[3]}"),
        )
        pieces = [header, *pieces, Piece(x.packet[-2:], "checksum")]
    return table([[code(spaced(p.data)), p.heading, p.shown(page)] for p in pieces], ["Bytes", "Part", "Value"])


def packet_ruler(page: Page, x: m.Example) -> str:
    """Writes the bytes of an example in one line; those of a value lead to its parameter, with the value as title."""
    s = page.model.set(x.set)
    number = code(spaced(x.packet[2:3]))
    parts = [code(spaced(x.packet[:2])), page.link(s, number) if s else number, code(spaced(x.packet[3:4]))]
    for part in x.fields:
        f = page.model.field(part.field or "")
        head = bytes([len(part.data) + 2, part.descriptor])
        if f is None or f is page.model.protocol.acknowledge:
            parts.append(page.link(page.model.protocol.acknowledge, code(spaced(head + part.data))))
            continue
        parts.append(page.link(f, code(spaced(head))))
        address = page.url(f).partition("#")[0]
        for piece in _record(Scope(f.parameters, part.values or {}, x.device, page), part.data, ()):
            if piece.data:
                parts.append(f'[{code(spaced(piece.data))}]({address}#{f.full_name}.{piece.path} "{piece.title}")')
    return " ".join([*parts, code(spaced(x.packet[-2:]))])


def typical_pieces(page: Page, f: m.Field) -> list[Piece]:
    """Returns the parameters of a field with typical values."""
    values = page.index.samples.values(f, page.index.typical(f))
    return list(_record(Scope(f.parameters, values, None, page), codec.encode(f, dict(values)), ()))


def _field(page: Page, x: m.Example, part: m.ExampleField) -> Iterator[Piece]:
    head = bytes([len(part.data) + 2, part.descriptor])
    f = page.model.field(part.field) if part.field else None
    yield Piece(head, "field length, descriptor", (field_ref(f) if f else "unknown",))
    pieces = _record(Scope(f.parameters, part.values or {}, x.device, page), part.data, ()) if f else ()
    acknowledged = page.index.shown(x, part) if f is page.model.protocol.acknowledge else []
    at = 0
    for piece in pieces:
        if at == 0 and acknowledged:  # an acknowledge begins with the descriptor of its command
            commands = [f for f in map(page.model.field, acknowledged) if f]
            piece = replace(piece, value=_listed((field_ref(f),) for f in commands))
        at += len(piece.data)
        yield piece
    if part.data[at:]:
        yield Piece(part.data[at:], "extra bytes" if f else "data")


def _record(scope: Scope, data: bytes, prefix: Place) -> Iterator[Piece]:
    """Yields the parameters of a record that are present, in order, each with its bytes."""
    at = 0
    for p in scope.parameters:
        if p.constant is None and p.name not in scope.values:
            return
        value = p.constant if p.constant is not None else scope.values[p.name]
        for piece in _parameter(p, value, scope, data[at:], (*prefix, p.name)):
            at += len(piece.data)
            yield piece


def _parameter(p: m.Parameter, value: Any, scope: Scope, data: bytes, place: Place) -> Iterator[Piece]:
    item = p.item
    if p.struct:
        yield from _record(scope.inside(p, p.struct, value), data, place)
    elif item.struct:
        for i, values in enumerate(value):
            rest = data[i * item.struct.max_size :]
            yield from _record(scope.inside(p, item.struct, values), rest, (*place, i))
    elif item.several:
        size = extent.item_size(p)
        for i, elements in enumerate(value):
            yield Piece(data[i * size : (i + 1) * size], (*place, i), (_numbers(p, elements, scope),))
    elif p.union:
        for q in (q for q in p.alternatives if q.name in value):
            yield from _parameter(q, value[q.name], scope, data, (*place, q.name))
    elif p.kind == "text":
        yield Piece(data[: len(value)], place, (Code(f'"{_printable(value)}"'),))
    else:
        size = len(value) * item.size if p.kind == "array" else p.size
        yield Piece(data[:size], place, _value(p, value, scope))


# --------------------------------------------------------------------------- values


def _value(p: m.Parameter, value: Any, scope: Scope) -> Value:
    """Writes a value or a list of values, with names and units."""
    t = _type(p, scope)
    each = value if isinstance(value, list) else [value]
    if t is None and not p.shown:
        return (_numbers(p, each, scope),)
    if isinstance(t, m.Bitfield) and t.scalar is None:
        return _flags(t, int.from_bytes(bytes(value), "little"))
    parts = (
        _hexadecimal(p, v, scope) if t is None else _flags(t, v) if isinstance(t, m.Bitfield) else _name(t, v)
        for v in each
    )
    return _listed(parts)


def _listed(values: Iterable[Value]) -> Value:
    return tuple(x for i, value in enumerate(values) for x in ((", ", *value) if i else value))


def _hexadecimal(p: m.Parameter, value: int, scope: Scope) -> Value:
    """Writes a number in hexadecimal, with the set or the field that it identifies."""
    model = scope.page.model
    number = descriptors.set_of(p, scope.values, model) or scope.fields_of
    meant = descriptors.named_by_value(p, value, number, model)
    shown = Code(descriptors.hexadecimal(p, value))
    return (shown, " ", Ref(meant, meant.title)) if meant else (shown,)


def _variants(p: m.Parameter, scope: Scope) -> list[m.Variant]:
    """Returns the variants that apply here, by the device or by the value of another parameter."""
    device = scope.device.id if scope.device else None
    return [v for v in p.variants if (v.key == device if v.by_device else v.value == scope.values.get(v.by))]


def _type(p: m.Parameter, scope: Scope) -> m.Enum | m.Bitfield | None:
    """Returns the type that names a value; another parameter or the device may select it."""
    named = next((v.type for v in _variants(p, scope) if v.type is not None), None)
    return named or (p.leaf.named)


def _numbers(p: m.Parameter, values: Sequence[Any], scope: Scope) -> str:
    units = next((v.units for v in _variants(p, scope) if v.units), p.units)
    model = scope.page.model
    shown = [decimal(v) if isinstance(v, str) else str(v) for v in values]
    elements = next((v.elements for v in _variants(p, scope) if v.elements), p.elements)
    if len(elements) == len(shown) <= 4:
        shown = [f"{name} {v}" for name, v in zip(elements, shown, strict=True)]
    if len(units) == len(shown) > 1:
        return ", ".join(describe.measured(v, u, model) for v, u in zip(shown, units, strict=True))
    return describe.measured(", ".join(shown), units[0] if units else None, model)


def _printable(text: str) -> str:
    return "".join(c if " " <= c <= "~" else f"\\x{ord(c):02x}" for c in text)


def _name(t: m.Enum, value: int) -> Value:
    member = next((v for v in t.values if v.value == value), None)
    return (Code(member.name), f" ({value})") if member else (str(value),)


def _flags(t: m.Bitfield, value: int) -> Value:
    """
    >>> bits = (m.Bits("on", 0, 0, "", False), m.Bits("level", 4, 6, "", False))
    >>> Piece(b"", "b", _flags(m.Bitfield("state", m.SCALARS["u8"], 1, bits, "", None), 0xB1)).title
    'b: 0xB1: on, level 3, unnamed bits 0x80'
    """
    parts: list[Value] = []
    rest = value
    for b in t.bits:
        number = (value & b.mask) >> b.first
        if b.alias:
            continue
        rest &= ~b.mask
        if b.width > 1 and number:
            parts.append((Code(b.name), " ", *(_name(b.enum, number) if b.enum else (str(number),))))
        elif number:
            parts.append((Code(b.name),))
    if rest:
        parts.append(("unnamed bits ", Code(hexadecimal(rest, t.size))))
    shown = Code(hexadecimal(value, t.size))
    return (shown, ": ", *_listed(parts)) if parts else (shown,)
