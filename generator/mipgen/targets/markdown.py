"""The reference manual: Markdown that reads well on a plain Git host and builds into a searchable site.

Works out what stands in the tables: byte offsets, lengths, the bytes of examples and their meaning,
and where every link leads. Cells come out of here as finished Markdown; templates lay them out.
"""

from __future__ import annotations

import posixpath
import re
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from jinja2 import pass_context
from jinja2.runtime import Context

from .. import codec
from .. import model as m
from ..checks import computed_length, differences
from ..naming import Identifier
from ..render import File

TITLE = "Reference manual in Markdown, a site with MkDocs"

INDEX = "docs/index.md"
PACKETS = "docs/packets.md"
UNITS = "docs/units.md"
TYPES = "docs/types.md"
ERRATA = "docs/errata.md"
EXAMPLES = "docs/examples.md"

SEVERITIES = ("wire", "meaning", "editorial")

#: So many values of an enumeration, or bits, are listed beside a parameter; more stand with the type only.
LISTED = 16

_ENTRY = ["Descriptor", "Field", "Functions", "Responses"]

#: What has a place in the manual; a string is the path of a page, maybe with an anchor.
Thing = m.Set | m.Field | m.Type | m.Device | m.Example | m.Erratum | m.Manual | m.Word | str


def files(model: m.Model) -> Iterator[File]:
    def page(path: str, template: str, **context: Any) -> File:
        return File(path, template, {"page": path, **context})

    yield page("README.md", "index.md.j2")
    yield page("mkdocs.yml", "mkdocs.yml.j2")
    yield page(INDEX, "index.md.j2")
    yield page(PACKETS, "packets.md.j2")
    yield page(UNITS, "units.md.j2")
    yield page(TYPES, "types.md.j2", set=None)
    yield page(ERRATA, "errata.md.j2")
    yield page(EXAMPLES, "examples.md.j2")
    for s in model.sets:
        yield page(set_page(s.name), "set.md.j2", set=s)
        if s.types:
            yield page(types_page(s.name), "types.md.j2", set=s)
    for d in model.devices:
        yield page(device_page(d), "device.md.j2", device=d)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Anchors: two things of a page must not have the same."""
    things: list[Thing] = [model.protocol.acknowledge, model.protocol.function_selector, *model.types]
    things += [*model.protocol.units, *model.protocol.frames, *model.examples, *model.errata]
    for s in model.sets:
        things += [*s.types, *s.fields]
    manual = _Manual(model)
    for thing in things:
        page, anchor = manual.place(thing)
        yield Identifier(page, anchor, getattr(thing, "name", anchor), getattr(thing, "position", None))


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    manual = _Manual(model)
    return {
        "anchor": manual.anchor,
        "link": manual.link,
        "links": manual.links,
        "text": manual.text,
        "inline": inline,
        "code": code,
        "hex": hexadecimal,
        "spaced": spaced,
        "words": lambda name: name.replace("_", " "),
        "count": count,
        "number": number,
        "label": manual.label,
        "parameter_table": manual.parameter_table,
        "parameter_values": manual.parameter_values,
        "parameter_notes": manual.parameter_notes,
        "function_table": manual.function_table,
        "optional": lambda f: [p for p in f.counted_parameters if p.optional],
        "form_length": manual.form_length,
        "definition": lambda f: manual.fields[f.definition],
        "contents": manual.contents,
        "supported": manual.supported,
        "differing": lambda d: [(manual.fields[name], letters) for name, letters in d.functions],
        "rates": lambda d: [(manual.sets[name], rate) for name, rate in d.base_rates],
        "rate_of": lambda d, s: dict(d.base_rates).get(s.name),
        "ports": ports,
        "own_readings": manual.own_readings,
        "note_table": note_table,
        "nature": manual.nature,
        "bits": manual.bits,
        "whole_packet": manual.whole_packet,
        "commands": lambda s: [f for f in s.fields if f.role != m.RESPONSE],
        "responses": manual.responses,
        "owned_responses": lambda f: [r for r in manual.responses(f) if r.command == f.name],
        "commands_of": manual.commands_of,
        "condition": manual.condition,
        "devices": manual.devices,
        "citations": manual.citations,
        "length_remarks": manual.length_remarks,
        "errata": manual.errata_of,
        "examples": manual.examples_of,
        "example_rows": manual.example_rows,
        "field_rows": manual.field_rows,
        "prints": manual.prints,
        "subjects": manual.subjects,
        "readings": manual.readings_of,
        "users": manual.users,
        "demonstration": manual.demonstration,
        "severities": lambda errata: [(s, [e for e in errata if e.severity == s]) for s in SEVERITIES],
        "of_manual": lambda things, manual_: [t for t in things if t.manual == manual_.id],
        "fields_of": lambda names, s: [f for f in s.fields if f.full_name in names],
        "device_functions": manual.device_functions,
        "letters": lambda f: "".join(x.letter for x in f.functions),
        "path": lambda thing: manual.place(thing)[0],
        "base_rates": lambda s: [
            (d, dict(d.base_rates)[s.name]) for d in model.devices if s.name in dict(d.base_rates)
        ],
    }


def set_page(name: str) -> str:
    return f"docs/sets/{name}.md"


def types_page(name: str) -> str:
    return f"docs/types/{name}.md"


def device_page(d: m.Device) -> str:
    return f"docs/devices/{d.id}.md"


# --------------------------------------------------------------------------- text

_SPECIAL = re.compile(r"[\\`*\[\]|<~$]|(?<![A-Za-z0-9])_|_(?![A-Za-z0-9])|&(?=#?\w+;)")
_FIELD = re.compile(
    r"\(0x(?P<set>[0-9A-Fa-f]{2}),\s?0x(?P<descriptor>[0-9A-Fa-f]{2})\)|(?<![\w.])(?P<name>\w+\.\w+)(?![\w*])"
)
_ENTITIES = {"<": "&lt;", "&": "&amp;", "~": "&#126;", "$": "&#36;"}


def plain(text: object) -> str:
    r"""Text as it is: nothing in it is taken for Markdown or HTML, not even in a table.

    >>> print(plain("4 + 3*a | <b> _c_ d_e"))
    4 + 3\*a \| &lt;b> \_c\_ d_e
    >>> print(plain("1. a"), plain("- b"), plain("3.1 c"))
    1\. a \- b 3.1 c
    """
    escaped = re.sub(r"^(\d+)([.)])(?= |$)", r"\1\\\2", inline(text))
    return re.sub(r"^([-+#>=])", r"\\\1", escaped)


def inline(text: object) -> str:
    r"""The same inside a line, where a number or a dash is no list. Authors mark code by backticks.

    >>> print(inline("state `a_b*c` and `"))
    state `a_b*c` and \`
    """
    parts = re.split(r"(`[^`|]+`)", " ".join(str(text).split()))
    escaped = (_SPECIAL.sub(lambda x: _ENTITIES.get(x[0], "\\" + x[0]), part) for part in parts[::2])
    return "".join(a + b for a, b in zip(escaped, [*parts[1::2], ""], strict=True))


def code(text: object) -> str:
    """
    >>> code("a_b*c"), code("a|b")
    ('`a_b*c`', '<code>a&#124;b</code>')
    """
    whole = str(text)
    if "`" in whole or "|" in whole or whole != whole.strip() or not whole:
        for character, entity in (
            ("&", "&amp;"),
            ("<", "&lt;"),
            ("|", "&#124;"),
            ("`", "&#96;"),
            ("*", "&#42;"),
            ("_", "&#95;"),
        ):
            whole = whole.replace(character, entity)
        return f"<code>{whole}</code>"
    return f"`{whole}`"


def hexadecimal(number_: int, size: int = 1) -> str:
    """
    >>> hexadecimal(10), hexadecimal(1, 2)
    ('0x0A', '0x0001')
    """
    return f"0x{number_:0{2 * size}X}"


def spaced(data: Iterable[int | None]) -> str:
    """
    >>> spaced([0x75, 0x65, None])
    '75 65 ??'
    """
    return " ".join("??" if b is None else f"{b:02X}" for b in data)


def number(value: object) -> str:
    """
    >>> number(2.50), number(10.0), number(7)
    ('2.5', '10', '7')
    """
    if isinstance(value, float):
        text = repr(value)
        return text[:-2] if text.endswith(".0") else text
    return str(value)


def count(things: Sequence[object] | int, word: str, several: str = "") -> str:
    """
    >>> count(1, "bit"), count([], "entry", "entries")
    ('1 bit', '0 entries')
    """
    n = things if isinstance(things, int) else len(things)
    return f"{n} {word if n == 1 else several or word + 's'}"


def decimal(bits: str) -> str:
    """The shortest decimal that has these bits.

    >>> decimal("0x3dcccccd"), decimal("0x3fb999999999999a"), decimal("0xbf800000"), decimal("0x7fe5bf7f")
    ('0.1', '0.1', '-1', 'NaN (0x7FE5BF7F)')
    """
    raw = bytes.fromhex(bits[2:])
    form = ">f" if len(raw) == 4 else ">d"
    value = struct.unpack(form, raw)[0]
    if value != value:
        return f"NaN (0x{raw.hex().upper()})"
    for digits in range(6, 18):
        text = f"{value:.{digits}g}"
        try:
            if struct.pack(form, float(text)) == raw:
                return text
        except OverflowError:
            continue
    raise AssertionError(bits)


def table(rows: Iterable[Sequence[str]], headings: Sequence[str]) -> str:
    """A table of finished cells; columns that are empty throughout are left out."""
    found = [list(row) for row in rows]
    keep = [i for i in range(len(headings)) if i == 0 or any(row[i] for row in found)]
    lines = [[headings[i] for i in keep], ["---"] * len(keep), *([row[i] for i in keep] for row in found)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def ports(d: m.Device) -> str:
    rows = [
        [
            inline(p.name),
            "" if p.id is None else code(hexadecimal(p.id)),
            ", ".join(map(str, p.baud_rates)),
            ", ".join(map(inline, p.protocols)),
        ]
        for p in d.ports
    ]
    return table(rows, ["Port", "Id", "Baud rates", "Protocols"])


def note_table(note: m.Note) -> str:
    """The rows of a note, the first as the heading; short rows are filled up."""
    width = max(map(len, note.rows))
    head, *rows = [[*map(inline, row), *[""] * (width - len(row))] for row in note.rows]
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * width, *rows])


# --------------------------------------------------------------------------- offsets


@dataclass(frozen=True, slots=True)
class Extent:
    """A number of bytes. It may depend on counters, and on the number of an element.

    >>> str(Extent(4) + Extent(0, ((3, "count"),))), str(Extent(7)), str(Extent(0, ((1, "n"),)))
    ('4 + 3*count', '7', 'n')
    """

    fixed: int = 0
    terms: tuple[tuple[int, str], ...] = ()

    def __add__(self, other: Extent) -> Extent:
        return Extent(self.fixed + other.fixed, self.terms + other.terms)

    def __str__(self) -> str:
        parts = [str(self.fixed)] if self.fixed or not self.terms else []
        parts += [name if size == 1 else f"{size}*{name}" for size, name in self.terms]
        return " + ".join(parts)


@dataclass(frozen=True, slots=True)
class Row:
    """A parameter at its place."""

    name: str  # with those of the records around it: "parameters.gpio.pin"
    offset: Extent
    size: Extent | None  # None: it reaches to the end of the field, or is a union
    parameter: m.Parameter | None  # None: the empty alternative of a union
    record: Sequence[m.Parameter]  # the record that it stands in
    case: tuple[str, m.EnumValue] | None = None  # the tag, and the value that selects this alternative

    def beside(self, name: str) -> str:
        """The full name of a parameter of the same record."""
        return self.name.rpartition(".")[0] + "." + name if "." in self.name else name


#: Stands for the number of elements of an array that fills the field, as in the specification.
REST = "rest"


def extents(op: m.Operation, prefix: str = "") -> list[Extent]:
    """The bytes that an operation may have: one for each alternative of a union."""
    match op:
        case m.ScalarOp() | m.ConstantOp() | m.CounterOp() | m.BitsOp():
            return [Extent(op.size)]
        case m.TextOp() | m.ArrayOp():
            item = 1 if isinstance(op, m.TextOp) else codec.size_of(op.item)
            if op.count is not None:
                return [Extent(op.count * item)]
            return [Extent(0, ((item, prefix + op.counter if op.counter is not None else REST),))]
        case m.StructOp():
            return totals([p.operation for p in op.struct.parameters], Extent(), f"{prefix}{op.member}.")
        case m.SwitchOp():
            members = [c.operation for c in op.cases]
            inner = f"{prefix}{op.member}."
            return _distinct(e for one in members for e in (extents(one, inner) if one is not None else [Extent()]))
        case m.GroupOp():
            return totals(op.body, Extent(), prefix)


def totals(operations: Iterable[m.Operation], start: Extent, prefix: str = "") -> list[Extent]:
    found = [start]
    for op in operations:
        found = [a + b for a in found for b in extents(op, prefix)]
    return _distinct(found)


def _distinct(found: Iterable[Extent]) -> list[Extent]:
    return sorted(dict.fromkeys(found), key=lambda e: (e.fixed, e.terms))


def extent(op: m.Operation, prefix: str = "") -> Extent | None:
    """The bytes of an operation, if what comes before it tells."""
    found = extents(op, prefix)
    return found[0] if len(found) == 1 and all(name != REST for _, name in found[0].terms) else None


def layout(record: Sequence[m.Parameter], at: Extent = Extent(), prefix: str = "", depth: int = 0) -> Iterator[Row]:
    """Every parameter with its place, and what is inside structures and unions."""
    for p in record:
        row = Row(prefix + p.name, at, extent(p.operation, prefix), p, record)
        yield row
        yield from _inside(row, p, depth)
        if row.size is not None:  # else nothing follows
            at += row.size


def _inside(row: Row, p: m.Parameter, depth: int) -> Iterator[Row]:
    match p.operation:
        case m.StructOp(struct=inner):
            yield from layout(inner.parameters, row.offset, f"{row.name}.", depth)
        case m.ArrayOp(item=m.StructOp(struct=inner)):
            index = "ijklmn"[depth]
            step = Extent(0, ((inner.max_size, index),))
            yield from layout(inner.parameters, row.offset + step, f"{row.name}[{index}].", depth + 1)
        case m.SwitchOp(tag=tag, cases=cases):
            for c in cases:
                q = c.parameter
                name = f"{row.name}.{q.name}" if q else row.name
                size = extent(q.operation, f"{row.name}.") if q else Extent()
                member = Row(name, row.offset, size, q, row.record, (row.beside(tag), c.tag))
                yield member
                if q is not None:
                    yield from _inside(member, q, depth)
        case _:
            pass


# --------------------------------------------------------------------------- the manual


@dataclass(frozen=True, slots=True)
class Piece:
    """Some bytes of an example, and what they are."""

    data: bytes
    name: str  # Markdown
    value: str  # Markdown


class _Manual:
    """Knows where everything stands and what leads where."""

    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.sets = {s.name: s for s in model.sets}
        self.fields = {f.full_name: f for f in (*model.fields, model.protocol.acknowledge)}
        self.manuals = {x.id: x for x in model.protocol.manuals}
        self.frames = {x.symbol: x for x in model.protocol.frames}
        self.examples_by_id = {e.id: e for e in model.examples}
        self.devices_by_id = {d.id: d for d in model.devices}
        self.device_by_manual = {d.manual: d for d in model.devices}
        self.erratum_of_example: dict[str, list[m.Erratum]] = {}
        self.erratum_of_length: dict[tuple[str, str], list[m.Erratum]] = {}
        self.errata_of_section: dict[tuple[str, str], list[m.Erratum]] = {}
        for e in model.errata:
            section = e.section.partition(" > ")[0]
            self.errata_of_section.setdefault((e.manual, section), []).append(e)
            for c in e.claims:
                if c.kind == "example":
                    self.erratum_of_example.setdefault(c.subject, []).append(e)
                elif c.kind == "length":
                    self.erratum_of_length.setdefault((e.manual, c.subject), []).append(e)
        self._users = self._find_users()
        self._examples = self._find_examples()

    # ----------------------------------------------------------------------- places and links

    def place(self, thing: Thing) -> tuple[str, str]:
        """The page of a thing, and its anchor there."""
        match thing:
            case str():
                page, _, anchor = thing.partition("#")
                return page, anchor
            case m.Set():
                return set_page(thing.name), ""
            case m.Field():
                page = PACKETS if thing is self.model.protocol.acknowledge else set_page(thing.set_name)
                return page, thing.full_name
            case m.Device():
                return device_page(thing), ""
            case m.Example():
                return EXAMPLES, f"example.{thing.id}"
            case m.Erratum():
                return ERRATA, f"erratum.{thing.id}"
            case m.Manual():
                return INDEX, f"manual.{thing.id}"
            case m.Word():
                kind = "frame" if thing in self.model.protocol.frames else "unit"
                return UNITS, f"{kind}." + re.sub(r"[^a-z0-9]+", "-", thing.title.lower()).strip("-")
        if thing is self.model.protocol.function_selector:
            return PACKETS, "protocol.function_selector"
        owner = getattr(thing, "owner", None)
        return types_page(owner) if owner else TYPES, f"{owner or 'types'}.{thing.name}"

    def label(self, thing: Thing) -> str:
        """What a thing is called, as Markdown."""
        match thing:
            case m.Set():
                return plain(f"{thing.title} ({hexadecimal(thing.number)})")
            case m.Field():
                of_set = "" if thing is self.model.protocol.acknowledge else hexadecimal(thing.set) + ","
                return plain(f"{thing.title} ({of_set}{hexadecimal(thing.descriptor)})")
            case m.Device() | m.Word():
                return plain(thing.title)
            case m.Example() | m.Erratum() | m.Manual():
                return plain(thing.id)
            case str():
                return plain(thing)
        return code(thing.name)

    def anchor(self, thing: Thing) -> str:
        return f'<a id="{self.place(thing)[1]}"></a>'

    def url(self, thing: Thing, page: str) -> str:
        target, anchor = self.place(thing)
        path = "" if target == page else posixpath.relpath(target, posixpath.dirname(page))
        return f"{path}#{anchor}" if anchor else path or posixpath.basename(page)

    @pass_context
    def link(self, context: Context, thing: Thing, label: str | None = None) -> str:
        """A link to a thing; `label` is Markdown."""
        return self._link(thing, context["page"], label)

    @pass_context
    def links(self, context: Context, things: Iterable[Thing]) -> str:
        return ", ".join(self._link(t, context["page"]) for t in things)

    def _link(self, thing: Thing, page: str, label: str | None = None) -> str:
        return f"[{label if label is not None else self.label(thing)}]({self.url(thing, page)})"

    @pass_context
    def text(self, context: Context, text: str) -> str:
        """Prose of the specification. What it says of fields, as (0x0C,0x28) or base.ping, becomes links."""
        return self._text(text, context["page"])

    def _text(self, text: str, page: str) -> str:
        def linked(match: re.Match[str]) -> str:
            field = self._named_field(match)
            return f"[{match[0]}]({self.url(field, page)})" if field is not None else match[0]

        return _FIELD.sub(linked, plain(text))

    def _named_field(self, match: re.Match[str]) -> m.Field | None:
        if match["name"] is not None:
            return self.fields.get(match["name"])
        found = self.model.candidates(int(match["set"], 16), int(match["descriptor"], 16))
        return found[0] if found else None

    # ----------------------------------------------------------------------- parameters

    @pass_context
    def parameter_table(self, context: Context, record: m.Field | m.Struct) -> str:
        rows = [self._parameter_row(row, record, context["page"]) for row in layout(record.parameters)]
        headings = ["Offset", "Bytes", "Name", "Type", "Required for", "Unit", "Frame", "Range", "Default", "Valid if"]
        return table(rows, [*headings, "Description"])

    def _parameter_row(self, row: Row, record: m.Field | m.Struct, page: str) -> list[str]:
        p = row.parameter
        when = f"If {code(row.case[0])} is {self._value(row.case[1])}" if row.case else ""
        if p is None:
            return [_bytes(row.offset), "0", code(row.name), *[""] * 7, f"{when}: nothing."]
        return [
            _bytes(row.offset),
            _bytes(row.size) if row.size else "rest" if p.length == "rest" else "by case",
            code(row.name),
            f"union by {code(row.beside(p.tag))}" if p.tag else self._type(p, page),
            self._required(p, record)
            if isinstance(record, m.Field) and row.record is record.parameters and not row.case
            else "",
            ", ".join(map(inline, p.units)),
            self._link(self.frames[p.frame], page, inline(p.frame)) if p.frame else "",
            _range(p),
            self._default(p),
            self._valid(p, row, page) if p.valid_when else "",
            self._description(p, when, page, sent=not isinstance(record, m.Field) or record.role == m.COMMAND),
        ]

    def _value(self, v: m.EnumValue) -> str:
        return f"{code(v.name)} ({v.value})"

    def _type(self, p: m.Parameter, page: str) -> str:
        e = p.element
        assert e is not None
        many = "" if p.length is None else inline(f"[{'' if p.length == 'rest' else p.length}]")
        if isinstance(e, m.Scalar):
            return code(e.name) + many
        under = f" {code(e.scalar.name)}" if isinstance(e, (m.Enum, m.Bitfield)) and e.scalar else ""
        return self._link(e, page) + many + under

    def _required(self, p: m.Parameter, f: m.Field) -> str:
        """The letters of the functions that a parameter is required for."""
        if p.selector:
            return code("".join(x.letter for x in f.functions))
        place = f.counted_parameters.index(p) + 1
        if f.functions:
            needed = dict(f.required)
            letters = "".join(x.letter for x in f.functions if place <= needed.get(x.value, 0))
            return code(letters) if letters else "optional"
        return "optional" if place > f.required_count else "always" if f.optional else ""

    def _default(self, p: m.Parameter) -> str:
        if p.default is None:
            return ""
        if isinstance(p.default, (list, tuple)):
            return ", ".join(code(number(v)) for v in p.default) or code("0")
        if isinstance(p.default, bool):
            return code(int(p.default))
        value = p.element.by_name(str(p.default)) if isinstance(p.element, m.Enum) else None
        return self._value(value) if value else code(number(p.default))

    def _valid(self, p: m.Parameter, row: Row, page: str) -> str:
        assert p.valid_when is not None
        flags = next((q for q in row.record if q.name == p.valid_when.partition(".")[0]), None)
        if flags is not None and isinstance(flags.element, m.Bitfield):
            return self._link(flags.element, page, code(p.valid_when))
        return code(p.valid_when)

    def _description(self, p: m.Parameter, when: str, page: str, sent: bool) -> str:
        parts = [f"{when}."] if when else []
        if p.deprecated:
            parts.append("Deprecated.")
        if p.description:
            parts.append(self._text(p.description, page))
        if p.constant is not None:
            assert isinstance(p.element, m.Scalar)
            parts.append(f"Always {p.constant} ({code(hexadecimal(p.constant, p.element.size))}).")
        if p.reserved is not None and sent:
            parts.append(f"Send {p.reserved}.")
        if p.counts:
            parts.append(f"The number of elements of {code(p.counts)}.")
        return " ".join(parts)

    @pass_context
    def parameter_values(self, context: Context, record: m.Field | m.Struct) -> list[str]:
        """The values and bits that the parameters may have, a line for each type."""
        page = context["page"]
        typed: dict[tuple[str, str], tuple[m.Enum | m.Bitfield, list[str]]] = {}
        read = []
        for row in layout(record.parameters):
            p = row.parameter
            if p is None or p.selector:
                continue
            if isinstance(p.element, (m.Enum, m.Bitfield)):
                typed.setdefault(self.place(p.element), (p.element, []))[1].append(code(row.name))
            for key, t in p.reading.types if p.reading else ():
                read.append(f"{code(row.name)} {self._read_when(row, p, key, page)}, {self._listed(t, page)}")
        return [f"{', '.join(names)}, {self._listed(t, page)}" for t, names in typed.values()] + read

    def _read_when(self, row: Row, p: m.Parameter, key: str, page: str) -> str:
        assert p.reading is not None
        if p.reading.by == "device":
            return f"on the {self._link(self.devices_by_id[key], page)}"
        return f"if {code(row.beside(p.reading.by))} is {code(key)}"

    def _listed(self, t: m.Enum | m.Bitfield, page: str) -> str:
        """A type and what it holds, in short."""
        head = self._link(t, page)
        if isinstance(t, m.Enum):
            if len(t.values) > LISTED:
                return f"{head}: {count(t.values, 'value')}."
            return f"{head}: " + ", ".join(f"{v.value} {code(v.name)}" for v in t.values) + "."
        bits = [b for b in t.bits if not b.alias]
        if len(bits) > LISTED:
            return f"{head}: {count(bits, 'entry', 'entries')}."
        more = "." if len(bits) == len(t.bits) else ", and some that overlap these."
        return f"{head}: " + ", ".join(f"{self.span(b)} {code(b.name)}" for b in bits) + more

    @staticmethod
    def span(b: m.Bits) -> str:
        return f"bit {b.first}" if b.width == 1 else f"bits {b.first}–{b.last}"

    @pass_context
    def parameter_notes(self, context: Context, record: m.Field | m.Struct) -> list[str]:
        page = context["page"]
        rows = [(row.name, row.parameter) for row in layout(record.parameters)]
        return [f"{code(name)}: {self._text(note, page)}" for name, p in rows if p is not None for note in p.remarks]

    # ----------------------------------------------------------------------- forms of a command

    def length(self, parameters: Sequence[m.Parameter], head: int = 2) -> str:
        """The field length of a form that carries these parameters."""
        found = [_bytes(e) for e in totals((p.operation for p in parameters), Extent(head))]
        return " or ".join([", ".join(found[:-1]), found[-1]] if len(found) > 1 else found)

    def form_length(self, f: m.Field) -> str:
        """The field length of a field without a selector."""
        required, whole = self.length(f.parameters[: f.required_count]), self.length(f.parameters)
        return whole if required == whole else f"{required}, {whole} with all optional parameters"

    @pass_context
    def function_table(self, context: Context, f: m.Field) -> str:
        page, rows = context["page"], []
        responses = self.responses(f)
        for x in f.functions:
            needed = f.counted_parameters[: dict(f.required).get(x.value, 0)]
            length = self.length(needed, 3)
            first = f"{int(length):02X}" if length.isdigit() else "LL"
            head = f"{first} {f.descriptor:02X} {x.value:02X}"
            packet = b"" if needed else codec.build(self.model, f.set, [(f.descriptor, bytes([x.value]))])
            answer = "none" if not x.reply else "acknowledge"
            if x.responds and responses:
                answer += ", " + " or ".join(self._link(r, page) for r in responses)
            rows.append([
                f"{code(x.letter)} {code(x.name)}", str(x.value), code(head),
                ", ".join(code(p.name) for p in needed), length,
                code(spaced(packet)) if packet else "", answer,
            ])  # fmt: skip
        headings = ["Function", "Value", "Field begins", "Then follow", "Field length", "Whole packet", "Answer"]
        return table(rows, headings)

    def whole_packet(self, f: m.Field) -> bytes | None:
        """The only packet of a command that leaves nothing to choose."""
        if f.role != m.COMMAND or any(p.constant is None for p in f.parameters):
            return None
        return codec.build(self.model, f.set, [(f.descriptor, codec.encode(f, {}))])

    def demonstration(self, _: m.Model) -> list[dict[str, Any]]:
        """The checksum of the first command that leaves nothing to choose, byte by byte."""
        packet = next((p for f in self.model.fields if (p := self.whole_packet(f)) is not None), None)
        a = b = 0
        steps = []
        for byte in packet[:-2] if packet else b"":
            a = (a + byte) & 0xFF
            b = (b + a) & 0xFF
            steps.append({"byte": byte, "a": a, "b": b})
        return steps

    # ----------------------------------------------------------------------- commands and responses

    def responses(self, f: m.Field) -> list[m.Field]:
        return [self.fields[f"{f.set_name}.{name}"] for name in f.responses]

    def commands_of(self, f: m.Field) -> list[m.Field]:
        """The commands that a response answers."""
        return [c for c in self.sets[f.set_name].fields if f.name in c.responses] if f.role == m.RESPONSE else []

    def condition(self, c: m.Condition) -> str:
        shown = code(c.label) if c.label == str(c.value) else f"{code(c.label)} ({c.value})"
        return f"{code(c.parameter)} is {shown}"

    def devices(self, f: m.Field) -> list[m.Device]:
        return [d for d in self.model.devices if f.full_name in d.fields]

    def device_functions(self, d: m.Device, f: m.Field) -> str:
        """The letters of the functions that a device takes, where they differ."""
        return dict(d.functions).get(f.full_name, "")

    @pass_context
    def contents(self, context: Context, s: m.Set) -> str:
        """All fields of a set."""
        fields = [f for f in s.fields if f.role != m.RESPONSE]
        what = "Command" if s.kind == "command" else "Data"
        return table((self._entry(f, context["page"]) for f in fields), [*_ENTRY, "Supported by"]).replace(
            "Field", what, 1
        )

    def _entry(self, f: m.Field, page: str) -> list[str]:
        letters = "".join(x.letter for x in f.functions)
        answers = [self._link(r, page, code(hexadecimal(r.descriptor))) for r in self.responses(f)]
        marks = [word for word, holds in (("advanced", f.advanced), ("deprecated", f.deprecated)) if holds]
        row = [
            code(hexadecimal(f.descriptor)),
            self._link(f, page, inline(f.title)) + (f" ({', '.join(marks)})" if marks else ""),
            code(letters) if letters else "",
            ", ".join(answers),
        ]
        return [*row, ", ".join(self._link(d, page) for d in self.devices(f))]

    @pass_context
    def supported(self, context: Context, d: m.Device, s: m.Set) -> str:
        """The fields of a set that a device supports, with the functions that it takes."""
        rows = []
        for f in s.fields:
            if f.full_name in d.fields:
                row = self._entry(f, context["page"])[:4]
                own = self.device_functions(d, f)
                rows.append([*row[:2], code(own) if own else row[2], row[3]])
        return table(rows, _ENTRY)

    @pass_context
    def own_readings(self, context: Context, d: m.Device) -> list[tuple[str, m.Type]]:
        """What a device reads in its own way: a parameter, or all values of a type."""
        page = context["page"]
        found: list[tuple[str, m.Type]] = []
        types = [*self.model.types, *(t for s in self.model.sets for t in s.types)]
        for key, own in d.readings:
            name, _, parameter = key.rpartition(".")
            of = [t for t in types if t.name == key]
            if name in self.fields:
                found.append((f"{code(parameter)} of {self._link(self.fields[name], page)}", own))
            else:
                found.append((", ".join(self._link(t, page) for t in of) or code(key), own))
        return found

    # ----------------------------------------------------------------------- manuals and errata

    @pass_context
    def citations(self, context: Context, thing: m.Field | m.Type | m.Set) -> list[str]:
        """Where the manuals say it, a line for each."""
        page = context["page"]
        lines = []
        for s in getattr(thing, "sources", ()):
            line = f"{self._link(self.manuals[s.manual], page)}: {inline(s.section)}"
            remark = self._length_remark(thing, s, page) if isinstance(thing, m.Field) else ""
            lines.append(line + (f" — {remark}" if remark else ""))
        return lines

    @pass_context
    def length_remarks(self, context: Context, f: m.Field) -> list[str]:
        """Only those citations that print another length."""
        page = context["page"]
        remarks = [(s.manual, self._length_remark(f, s, page)) for s in f.sources]
        found = [f"{self._link(self.manuals[name], page)} {remark}" for name, remark in remarks if remark]
        return list(dict.fromkeys(found))  # a manual may be cited twice

    def _length_remark(self, f: m.Field, s: m.Source, page: str) -> str:
        if s.length is None or s.length == "unavailable":
            return ""
        right = self.length(f.parameters)
        wrong = self.erratum_of_length.get((s.manual, f.full_name), [])
        if wrong:
            by = ", ".join(self._link(e, page, f"erratum {self.label(e)}") for e in wrong)
            return f"prints the length {code(s.length)}, the field has {right} ({by})"
        if "".join(s.length.split()) in ("".join(x.split()) for x in (right.strip("`"), computed_length(f, "wire"))):
            return ""
        return (
            f"prints the length {code(s.length)}, which leaves out vectors, structures and unions; "
            f"the field has {right}"
        )

    def errata_of(self, f: m.Field) -> list[m.Erratum]:
        """What is wrong in the sections that a field cites, in its printed lengths and in its examples."""
        found = [
            e for s in f.sources if f.role != m.RESPONSE for e in self.errata_of_section.get((s.manual, s.section), [])
        ]
        found += [e for s in f.sources for e in self.erratum_of_length.get((s.manual, f.full_name), [])]
        found += [e for x in self.examples_of(f) for e in self.erratum_of_example.get(x.id, [])]
        return sorted({e.id: e for e in found}.values(), key=lambda e: e.id)

    @pass_context
    def subjects(self, context: Context, e: m.Erratum) -> list[str]:
        """What an erratum is about: links to fields and examples."""
        page = context["page"]
        found = []
        for c in e.claims:
            if c.kind == "length":
                found.append("length of " + self._link(self.fields[c.subject], page))
            elif c.kind == "example":
                found.append("example " + self._link(self.examples_by_id[c.subject], page))
            else:
                found.append(f"reference to {inline(f'({c.subject})')}, which no manual defines")
        section = e.section.partition(" > ")[0]
        for f in self.model.fields:
            claimed = any(c.kind == "length" and c.subject == f.full_name for c in e.claims)
            if (
                f.role != m.RESPONSE
                and not claimed
                and any((s.manual, s.section) == (e.manual, section) for s in f.sources)
            ):
                found.append(self._link(f, page))
        return found

    # ----------------------------------------------------------------------- types

    def _find_users(self) -> dict[tuple[str, str], list[Thing]]:
        found: dict[tuple[str, str], list[Thing]] = {}

        def use(t: m.Type, by: Thing) -> None:
            users = found.setdefault(self.place(t), [])
            if by not in users:
                users.append(by)

        def visit(parameters: Iterable[m.Parameter], by: Thing) -> None:
            for p in parameters:
                if p.element is not None and not isinstance(p.element, m.Scalar):
                    use(p.element, by)
                for _, t in p.reading.types if p.reading else ():
                    use(t, by)
                visit([c.parameter for c in p.cases if c.parameter is not None], by)

        owners = [*self.model.types, *(t for s in self.model.sets for t in s.types)]
        for t in owners:
            if isinstance(t, m.Struct):
                visit(t.parameters, t)
            elif isinstance(t, m.Bitfield):
                for b in t.bits:
                    if b.enum is not None:
                        use(b.enum, t)
        visit(self.model.protocol.acknowledge.parameters, self.model.protocol.acknowledge)
        for f in self.model.fields:
            visit(f.parameters, f)
        for d in self.model.devices:
            for _, t in d.readings:
                use(t, d)
        return found

    def nature(self, t: m.Type) -> str:
        """What kind of type it is, and how long."""
        match t:
            case m.Enum():
                return f"Enumeration, {code(t.scalar.name)}"
            case m.Bitfield():
                return (
                    f"Bitfield, {code(t.scalar.name) if t.scalar else f'{t.size} bytes, the least significant first'}"
                )
            case m.Vector():
                return f"{len(t.elements)} × {code(t.scalar.name)}, {len(t.elements) * t.scalar.size} bytes"
            case m.Struct():
                return f"Structure, {self.length(t.parameters, 0)} bytes"

    @pass_context
    def bits(self, context: Context, t: m.Bitfield) -> str:
        rows = []
        for b in t.bits:
            span = str(b.first) if b.width == 1 else f"{b.first}–{b.last}"
            parts = [self._text(b.description, context["page"])] if b.description else []
            if b.enum is not None:
                parts.append(f"A value of {self._link(b.enum, context['page'])}.")
            if b.alias:
                parts.append("Overlaps other bits.")
            mask = code(hexadecimal(b.mask, t.size)) if t.scalar else ""
            place = "" if t.scalar else f"{b.first // 8}.{b.first % 8}"
            rows.append([span, mask, place, code(b.name), " ".join(parts)])
        return table(rows, ["Bit", "Mask", "Byte.bit", "Name", "Description"])

    def users(self, t: m.Type) -> list[Thing]:
        return self._users.get(self.place(t), [])

    def readings_of(self, t: m.Type) -> list[tuple[m.Device, m.Type]]:
        """The devices that read a type in their own way."""
        return [(d, own) for d in self.model.devices for key, own in d.readings if key == t.name]

    # ----------------------------------------------------------------------- examples

    def _find_examples(self) -> dict[str, list[m.Example]]:
        found: dict[str, list[m.Example]] = {}
        for e in self.model.examples:
            for name in dict.fromkeys(n for x in e.fields for n in self._about(e, x)):
                found.setdefault(name, []).append(e)
        return found

    def _about(self, e: m.Example, x: m.ExampleField) -> list[str]:
        """The fields that a field of an example shows: itself; of an acknowledge, the command too."""
        if x.field != self.model.protocol.acknowledge.full_name:
            return [x.field] if x.field else []
        own = self.model.set(e.set)
        echo = x.data[0] if x.data else None
        return [f.full_name for f in own.fields if f.role == m.COMMAND and f.descriptor == echo] if own else []

    def examples_of(self, f: m.Field) -> list[m.Example]:
        return self._examples.get(f.full_name, [])

    def shown(self, e: m.Example) -> bytes:
        """The right bytes: those of the field, if the manual prints no packet around it."""
        return e.packet[4:-2] if e.role == "field" else e.packet

    @pass_context
    def prints(self, context: Context, e: m.Example) -> dict[str, Any]:
        """An example as it is printed, and as it should be."""
        return {
            "string": e.string,
            "table": spaced(e.table) if e.table is not None else None,
            "right": spaced(self.shown(e)),
            "differences": [plain(d) for d in differences(e)],
            "errata": self.erratum_of_example.get(e.id, []),
        }

    @pass_context
    def example_rows(self, context: Context, e: m.Example) -> str:
        """Every byte of an example, and what it means."""
        pieces: list[Piece] = []
        if e.role != "field":
            own = self.model.set(e.set)
            name = self._link(own, context["page"]) if own else "unknown"
            pieces += [
                Piece(e.packet[:2], "sync", ""),
                Piece(e.packet[2:3], "descriptor set", name),
                Piece(e.packet[3:4], "payload length", str(e.packet[3])),
            ]
        for x in e.fields:
            pieces += self._field_pieces(e, x, context["page"])
        if e.role != "field":
            pieces.append(Piece(e.packet[-2:], "checksum", ""))
        return self._pieces(pieces)

    @pass_context
    def field_rows(self, context: Context, e: m.Example, f: m.Field) -> list[str]:
        """The bytes of those fields of an example that show a field."""
        shown = [x for x in e.fields if f.full_name in self._about(e, x)]
        return [self._pieces(self._field_pieces(e, x, context["page"])) for x in shown]

    def _pieces(self, pieces: Iterable[Piece]) -> str:
        return table([[code(spaced(p.data)), p.name, p.value] for p in pieces], ["Bytes", "What", "Value"])

    def _field_pieces(self, e: m.Example, x: m.ExampleField, page: str) -> Iterator[Piece]:
        head = bytes([len(x.data) + 2, x.descriptor])
        if x.field is None:
            yield Piece(head, "field length, descriptor", "unknown")
            if x.data:
                yield Piece(x.data, "data", "")
            return
        field = self.fields[x.field]
        yield Piece(head, "field length, descriptor", self._link(field, page))
        at = 0
        around = _Around(field.parameters, x.values or {}, self.device_by_manual.get(e.manual))
        for piece in self._record(around, x.data, ""):
            at += len(piece.data)
            yield piece
        if x.data[at:]:
            yield Piece(x.data[at:], "left over", "")

    def _record(self, around: _Around, data: bytes, prefix: str) -> Iterator[Piece]:
        """The parameters of a record, in order, each with its bytes."""
        at = 0
        for p in around.parameters:
            if p.constant is None and p.name not in around.values:
                return
            value = p.constant if p.constant is not None else around.values[p.name]
            for piece in self._parameter(p, value, around, data[at:], prefix + p.name):
                at += len(piece.data)
                yield piece

    def _parameter(self, p: m.Parameter, value: Any, around: _Around, data: bytes, name: str) -> Iterator[Piece]:
        match p.operation:
            case m.StructOp(struct=inner):
                yield from self._record(_Around(inner.parameters, value, around.device), data, f"{name}.")
            case m.ArrayOp(item=m.StructOp(struct=inner)):
                for i, one in enumerate(value):
                    rest = data[i * inner.max_size :]
                    yield from self._record(_Around(inner.parameters, one, around.device), rest, f"{name}[{i}].")
            case m.ArrayOp(item=m.ArrayOp() as item):
                size = codec.size_of(item)
                for i, one in enumerate(value):
                    yield Piece(data[i * size : (i + 1) * size], code(f"{name}[{i}]"), _numbers(p, one))
            case m.SwitchOp():
                for q in (c.parameter for c in p.cases if c.parameter is not None and c.parameter.name in value):
                    yield from self._parameter(q, value[q.name], around, data, f"{name}.{q.name}")
            case m.TextOp():
                yield Piece(data[: len(value)], code(name), code(f'"{_printable(value)}"'))
            case m.ArrayOp(item=m.ScalarOp() as item):
                yield Piece(data[: len(value) * item.size], code(name), self._shown(p, value, around))
            case m.ScalarOp() | m.ConstantOp() | m.CounterOp() | m.BitsOp() as op:
                yield Piece(data[: op.size], code(name), self._shown(p, value, around))
            case op:
                raise AssertionError(op)

    def _shown(self, p: m.Parameter, value: Any, around: _Around) -> str:
        """A value or a list of values, with its names and units."""
        t = _meaning(p, around)
        if t is None:
            return _numbers(p, value if isinstance(value, list) else [value])
        if isinstance(t, m.Bitfield) and t.scalar is None:
            return _flags(t, int.from_bytes(bytes(value), "little"))
        return ", ".join(self._named(t, v) for v in (value if isinstance(value, list) else [value]))

    def _named(self, t: m.Enum | m.Bitfield, value: int) -> str:
        if isinstance(t, m.Bitfield):
            return _flags(t, value)
        known = next((v for v in t.values if v.value == value), None)
        return self._value(known) if known else str(value)


@dataclass(frozen=True, slots=True)
class _Around:
    """The record of an example that a value stands in, and the device that sends or takes it."""

    parameters: Sequence[m.Parameter]
    values: Mapping[str, Any]
    device: m.Device | None


def _meaning(p: m.Parameter, around: _Around) -> m.Enum | m.Bitfield | None:
    """The type that names a value, be it by a sibling or by the device."""
    if isinstance(p.element, (m.Enum, m.Bitfield)):
        own = dict(around.device.readings) if around.device else {}
        return own.get(p.element.name, p.element)
    if p.reading is None:
        return None
    types = dict(p.reading.types)
    if p.reading.by == "device":
        return types.get(around.device.id) if around.device else None
    sibling = next(q for q in around.parameters if q.name == p.reading.by)
    assert isinstance(sibling.element, m.Enum)
    value = around.values.get(sibling.name)
    return next((types.get(v.name) for v in sibling.element.values if v.value == value), None)


def _bytes(n: Extent) -> str:
    return code(n) if n.terms else str(n)


def _range(p: m.Parameter) -> str:
    low, high = p.minimum, p.maximum
    if low is None:
        return "" if high is None else f"≤ {number(high)}"
    return f"≥ {number(low)}" if high is None else f"{number(low)} to {number(high)}"


def _numbers(p: m.Parameter, values: Sequence[Any]) -> str:
    shown = [decimal(v) if isinstance(v, str) else str(v) for v in values]
    if isinstance(p.element, m.Vector) and len(p.element.elements) == len(shown) <= 4:
        shown = [f"{name} {v}" for name, v in zip(p.element.elements, shown, strict=True)]
    if len(p.units) == len(shown) > 1:
        return inline(", ".join(f"{v} {_unit(u)}".strip() for v, u in zip(shown, p.units, strict=True)))
    return inline(f"{', '.join(shown)} {_unit(p.units[0]) if p.units else ''}")


def _unit(symbol: str) -> str:
    return "" if symbol == "1" else symbol


def _printable(text: str) -> str:
    return "".join(c if " " <= c <= "~" else f"\\x{ord(c):02x}" for c in text)


def _flags(t: m.Bitfield, value: int) -> str:
    """
    >>> bits = (m.Bits("on", 0, 0, "", False), m.Bits("level", 4, 6, "", False))
    >>> _flags(m.Bitfield("state", m.SCALARS["u8"], 1, bits, "", None), 0xB1)
    '`0xB1`: `on`, `level` 3, unnamed bits `0x80`'
    """
    parts, rest = [], value
    for b in t.bits:
        found = (value & b.mask) >> b.first
        if b.alias:
            continue
        rest &= ~b.mask
        if b.width > 1 and found:
            known = next((v for v in b.enum.values if v.value == found), None) if b.enum else None
            parts.append(f"{code(b.name)} {f'{code(known.name)} ({found})' if known else found}")
        elif found:
            parts.append(code(b.name))
    if rest:
        parts.append(f"unnamed bits {code(hexadecimal(rest, t.size))}")
    shown = code(hexadecimal(value, t.size))
    return f"{shown}: {', '.join(parts)}" if parts else shown
