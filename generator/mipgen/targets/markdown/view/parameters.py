"""The parameters of a field or a structure: a table, texts that are too long for it, and tables of their values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe
from mipgen.facts.describe import Fact, Ref

from ..offsets import Row, parameter_offsets
from ..places import Page, place
from ..text import code, hexadecimal, inline, table
from .base import View
from .examples import Piece, typical_pieces

#: Columns of facts: heading -> their topics. All other facts are sentences.
COLUMNS = {
    "Unit": ("unit",),
    "Frame": ("frame",),
    "Range": ("range",),
    "Default": ("default",),
    "Required for": ("required", "optional"),
    "Valid flag": ("valid",),
}
#: Facts below the table.
BELOW = ("variant", "note")
#: The maximum number of array elements in the example of a row; further ones are similar.
SHOWN = 3


@dataclass(frozen=True, slots=True)
class _Row:
    """A row on a page, with the facts of its parameter."""

    page: Page
    row: Row
    facts: list[Fact]
    anchor: str  # empty in a structure, which is a part of several fields

    @property
    def comparable(self) -> tuple[object, ...]:
        """The statements about it that do not depend on its offset."""
        p = self.row.parameter
        facts = [(x.topic, self.markdown(x.sentence)) for x in self.facts if x.topic not in ("required", "optional")]
        return (self.row.name, p and p.element, p and p.length, p and p.description, facts)

    def ref(self, r: Ref) -> str:
        """Writes a reference; other parameters of the record get their full names."""
        if isinstance(r.thing, m.Bits) or (isinstance(r.thing, m.Parameter) and r.within is self.row.record):
            r = replace(r, words=self.row.beside(r.words))
        return self.page.ref(r)

    def markdown(self, text: describe.Text) -> str:
        return self.page.markdown(text, self.ref)

    def column(self, topics: tuple[str, ...]) -> str:
        return " ".join(self.markdown(f.value or f.sentence) for f in describe.topics(self.facts, *topics))

    def description(self) -> str:
        """Writes its description, and the facts that have no column."""
        p = self.row.parameter
        elsewhere = {topic for topics in COLUMNS.values() for topic in topics} | {*BELOW}
        sentences = [(f.topic, self.markdown(f.sentence)) for f in self.facts if f.topic not in elsewhere]
        before = [sentence for topic, sentence in sentences if topic == "case"]
        after = [sentence for topic, sentence in sentences if topic != "case"]
        return " ".join([*before, *([self.page.prose(p.description)] if p and p.description else []), *after])

    def cells(self, values: Sequence[str]) -> list[str]:
        shown = "; ".join(values[:SHOWN]) + (" …" if len(values) > SHOWN else "")
        unit, *facts = (self.column(topics) for topics in COLUMNS.values())
        name = (f'<a id="{self.anchor}"></a>' if self.anchor else "") + code(self.row.name)
        means = [name, _type(self.page, self.row), unit, self.description(), *facts]
        return [*means, _extent(str(self.row.offset)), _size(self.row), shown]


def parameter_anchor(f: m.Field, row: Row) -> str:
    """
    >>> f = m.Field("base", (), "ping", 1, "command", "", "", (), (), 0, 0, ())
    >>> parameter_anchor(f, Row("list[i].rate", None, None, None, f))
    'base.ping.list.rate'
    """
    return f"{f.full_name}.{_path(row)}"


def _path(row: Row) -> str:
    """Returns the name of a parameter without indices."""
    return re.sub(r"\[[a-z]\]", "", row.name)


class Parameters(View[m.Record]):
    """The parameters of a record."""

    @cached_property
    def rows(self) -> list[_Row]:
        rows = []
        for row in parameter_offsets(self.of):
            facts = [describe.case(*row.case, row.record)] if row.case else []
            facts += describe.parameter(row.parameter, row.record, self.model) if row.parameter else []
            anchor = parameter_anchor(self.of, row) if isinstance(self.of, m.Field) and row.parameter else ""
            rows.append(_Row(self.page, row, facts, anchor))
        return rows

    @cached_property
    def pieces(self) -> list[Piece]:
        """The bytes of each parameter of a field, with typical values."""
        f = self.of
        return typical_pieces(self.page, f) if isinstance(f, m.Field) and f.set else []

    @property
    def table(self) -> str:
        values: dict[str, list[str]] = {}
        for piece in self.pieces:
            values.setdefault(piece.path, []).append(piece.shown(self.page))
        unit, *others = COLUMNS
        headings = ["Name", "Type", unit, "Description", *others, "Offset", "Bytes", "Example"]
        return table((r.cells(values.get(_path(r.row), [])) for r in self.rows), headings)

    @property
    def notes(self) -> list[str]:
        """Differences by device or by a sibling, and notes, a line for each."""
        facts = [(r, fact) for r in self.rows for fact in describe.topics(r.facts, *BELOW)]
        return [f"{code(r.row.name)}: {r.markdown(fact.sentence)}" for r, fact in facts]

    def as_in(self, command: Parameters) -> str:
        """Lists the parameters of a response in one sentence if its command has the same ones; otherwise empty."""
        others = [r for r in command.rows if not (r.row.parameter and r.row.parameter.selector)]
        if not self.rows or [r.comparable for r in self.rows] != [r.comparable for r in others]:
            return ""
        names = ", ".join(f'<a id="{r.anchor}"></a>{code(r.row.name)}' for r in self.rows if r.anchor)
        place = (
            "starting at offset 0, without the function selector"
            if len(others) < len(command.rows)
            else "at the same offsets"
        )
        return f"Parameters: as in the command, {place}: {names}."


def _extent(bytes_: str) -> str:
    return bytes_ if bytes_.isdigit() else code(bytes_)


def _size(row: Row) -> str:
    if row.size is not None:
        return _extent(str(row.size))
    return m.REST if row.parameter and row.parameter.fills else "depends"


def _type(page: Page, row: Row) -> str:
    p = row.parameter
    if p is None:
        return ""
    e, many = p.element, ""
    if e is None:
        return "union"
    if p.length is not None:
        elements = "" if p.fills else row.beside(p.length) if isinstance(p.length, str) else p.length
        many = inline(f"[{elements}]")
    if isinstance(e, m.Scalar):
        return code(e.name) + many
    under = f" {code(e.scalar.name)}" if isinstance(e, (m.Enum, m.Bitfield)) and e.scalar else ""
    return page.link(e) + many + under


# --------------------------------------------------------------------------- values and bits


@dataclass(frozen=True, slots=True)
class Values:
    """The values or bits of a type on a page that uses it."""

    heading: str  # the parameters that use the type, and its name if that is another
    type: m.Enum | m.Bitfield
    table: str
    sentence: str = ""  # instead, if it has one bit

    @property
    def line(self) -> str:
        return f"{self.heading}: {self.sentence}"


def values_of(page: Page, records: Sequence[m.Record]) -> list[Values]:
    """Returns the values and bits that the parameters of records may have, one entry for each type."""
    users: dict[tuple[str, str], tuple[m.Enum | m.Bitfield, str, dict[str, None]]] = {}
    for record in records:
        for row in parameter_offsets(record):
            p = row.parameter
            for t in [p.element, *(v.type for v in p.readings)] if p and not p.selector else []:
                if isinstance(t, (m.Enum, m.Bitfield)):
                    anchor = f"{parameter_anchor(record, row)}.{t.name}" if isinstance(record, m.Field) else ""
                    users.setdefault(place(t, page.model), (t, anchor, {}))[2][code(row.name)] = None
    return [
        Values(
            ", ".join(names) + (f" ({code(t.name)})" if [*names] != [code(t.name)] else ""),
            t,
            value_table(page, t, anchor) if isinstance(t, m.Enum) else bit_table(page, t, anchor),
            _only_bit(page, t, anchor) if isinstance(t, m.Bitfield) and len(t.bits) == 1 and t.scalar else "",
        )
        for t, anchor, names in users.values()
    ]


def value_table(page: Page, t: m.Enum, anchor: str = "") -> str:
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


def bit_table(page: Page, t: m.Bitfield, anchor: str = "") -> str:
    """Writes a table of the bits, including bits that overlap others."""
    rows = []
    others = (1 << t.width) - 1
    for b in t.bits:
        others &= ~b.mask
        place, *facts = describe.bits(b, page.model)
        rows.append([
            page.markdown(place.value),
            code(hexadecimal(b.mask, t.size)) if t.scalar else "",
            "" if t.scalar else f"{b.first // 8}.{b.first % 8}",
            _anchor(anchor, b.name) + code(b.name),
            _description(page, b.description, facts),
        ])  # fmt: skip
    if others and t.scalar:
        rows.append(["other bits", code(hexadecimal(others, t.size)), "", "", "Reserved or unknown: ignore them."])
    return table(rows, ["Bits", "Mask", "Byte.bit", "Name", "Description"])


def _only_bit(page: Page, t: m.Bitfield, anchor: str) -> str:
    [b] = t.bits
    place, *facts = describe.bits(b, page.model)
    name = f"{_anchor(anchor, b.name)}{code(b.name)} ({code(hexadecimal(b.mask, t.size))})"
    about = _description(page, b.description, facts)
    return f"{page.markdown(place.value)}, {name}: {about} Ignore the other bits. Type: {page.link(t)}."


def _anchor(before: str, name: str) -> str:
    return f'<a id="{before}.{name}"></a>' if before else ""


def _description(page: Page, text: str, facts: list[describe.Fact]) -> str:
    return " ".join([*([page.prose(text)] if text else []), *(page.markdown(f.sentence) for f in facts)])
