"""The parameters of a field or a structure: a table, and texts that are too long for it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.facts import describe
from mipgen.facts.describe import Fact, Ref

from . import examples, types
from .fields import on_page
from .offsets import Row, layout
from .packets import path
from .places import Page, place
from .text import code, inline, table

#: Columns of facts: heading -> their topics. All other facts are sentences.
COLUMNS = {
    "Required for": ("required", "optional"),
    "Unit": ("unit",),
    "Frame": ("frame",),
    "Range": ("range",),
    "Default": ("default",),
    "Valid flag": ("valid",),
}
#: Facts below the table.
BELOW = ("variant", "note")


@dataclass(frozen=True, slots=True)
class _Row:
    """A row on a page, with the facts of its parameter."""

    page: Page
    row: Row
    facts: list[Fact]
    anchor: str  # empty in a structure, which is a part of several fields

    @property
    def same(self) -> tuple[object, ...]:
        """The statements about it that do not depend on its offset."""
        p = self.row.parameter
        facts = [(x.topic, self.say(x.sentence)) for x in self.facts if x.topic not in ("required", "optional")]
        return (self.row.name, p and p.element, p and p.length, p and p.description, facts)

    def ref(self, r: Ref) -> str:
        """Writes a reference; other parameters of the record get their full names."""
        if isinstance(r.thing, m.Bits) or (isinstance(r.thing, m.Parameter) and r.within is self.row.record):
            r = replace(r, words=self.row.beside(r.words))
        return self.page.ref(r)

    def say(self, text: describe.Text) -> str:
        return self.page.say(text, self.ref)

    def column(self, topics: tuple[str, ...]) -> str:
        return " ".join(self.say(f.value or f.sentence) for f in describe.topics(self.facts, *topics))

    def description(self) -> str:
        """Writes its description, and the facts that have no column."""
        p = self.row.parameter
        elsewhere = {topic for topics in COLUMNS.values() for topic in topics} | {*BELOW}
        said = [(f.topic, self.say(f.sentence)) for f in self.facts if f.topic not in elsewhere]
        before = [sentence for topic, sentence in said if topic == "case"]
        after = [sentence for topic, sentence in said if topic != "case"]
        return " ".join([*before, *([self.page.prose(p.description)] if p and p.description else []), *after])


def _rows(page: Page, record: m.Record) -> Iterator[_Row]:
    for row in layout(record):
        case = [describe.case(*row.case, row.record)] if row.case else []
        facts = describe.parameter(row.parameter, row.record, page.model) if row.parameter else []
        anchor = parameter_anchor(record, row) if isinstance(record, m.Field) and row.parameter else ""
        yield _Row(page, row, case + facts, anchor)


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


# --------------------------------------------------------------------------- the table


@dataclass(frozen=True, slots=True)
class Parameters:
    """The parameters of a record."""

    table: str
    notes: list[str]  # differences by device or by a sibling, and notes, a line for each


#: The maximum number of array elements in the example of a row; further ones are similar.
SHOWN = 3


def parameter_list(page: Page, record: m.Record) -> Parameters:
    rows = list(_rows(page, record))
    headings = ["Offset", "Bytes", "Name", "Type", "Example", *COLUMNS, "Description"]
    shown: dict[str, list[str]] = {}
    if isinstance(record, m.Field) and record.set:
        for piece in examples.pieces(page, record):
            shown.setdefault(path(piece), []).append(piece.value)
    notes = [f"{code(r.row.name)}: {r.say(fact.sentence)}" for r in rows for fact in describe.topics(r.facts, *BELOW)]
    return Parameters(table((_cells(page, r, shown.get(_path(r.row), [])) for r in rows), headings), notes)


def as_command(page: Page, r: m.Field) -> str:
    """Lists the parameters of a response in one sentence if its command has the same ones; otherwise empty."""
    command = page.model.commands(r)[0]
    others = [x for x in _rows(page, command) if not (x.row.parameter and x.row.parameter.selector)]
    rows = list(_rows(page, r))
    if not rows or r.command != command.name or [x.same for x in rows] != [x.same for x in others]:
        return ""
    names = ", ".join(f'<a id="{x.anchor}"></a>{code(x.row.name)}' for x in rows if x.anchor)
    place = "starting at offset 0, without the function selector" if command.selector else "at the same offsets"
    return f"Parameters: as in the command, {place}: {names}."


def _cells(page: Page, r: _Row, shown: list[str]) -> list[str]:
    example = "; ".join(shown[:SHOWN]) + (" …" if len(shown) > SHOWN else "")
    facts = [*(r.column(topics) for topics in COLUMNS.values()), r.description()]
    anchor = f'<a id="{r.anchor}"></a>' if r.anchor else ""
    return [_extent(str(r.row.offset)), _size(r.row), anchor + code(r.row.name), _type(page, r.row), example, *facts]


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


# --------------------------------------------------------------------------- below the table


@dataclass(frozen=True, slots=True)
class Values:
    """The values or bits of a type on a page that uses it."""

    anchor: str  # prefix of the anchors of its values and bits
    type: m.Enum | m.Bitfield
    users: list[str]  # the parameters, as Markdown
    table: str


def parameter_values(page: Page, record: m.Record) -> list[Values]:
    """Returns the values and bits that the parameters of a record may have, one entry for each type."""
    return _values(page, [record])


def field_values(page: Page, f: m.Field) -> list[Values]:
    """Returns the values and bits on the page of a command or a data field."""
    return _values(page, on_page(page, f))


def _values(page: Page, records: Sequence[m.Record]) -> list[Values]:
    typed: dict[tuple[str, str], tuple[m.Enum | m.Bitfield, str, dict[str, None]]] = {}
    for record in records:
        for row in layout(record):
            p = row.parameter
            for t in [p.element, *(v.type for v in p.readings)] if p and not p.selector else []:
                if isinstance(t, (m.Enum, m.Bitfield)):
                    anchor = f"{parameter_anchor(record, row)}.{t.name}" if isinstance(record, m.Field) else ""
                    typed.setdefault(place(t, page.model), (t, anchor, {}))[2][code(row.name)] = None
    return [
        Values(
            anchor, t, list(users), types.values(page, t, anchor) if t.kind == "enum" else types.bits(page, t, anchor)
        )
        for t, anchor, users in typed.values()
    ]
