"""What the templates print: the tables that the dissector interprets, as rows in Lua, and examples of filters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import extent, validity
from mipgen.lower.session import session

from . import names

#: Topics that the tree shows itself, or that do not help to read a packet.
_LEFT_OUT = ("elements", "tag", "counts", "constant", "required", "optional")


@dataclass(frozen=True, slots=True)
class Type:
    """The names of an enumeration's values or of a bitfield's bits, or a structure's parameters."""

    name: str
    rows: list[str]
    margin: str = "\n  "  # before each row


@dataclass(frozen=True, slots=True)
class Field:
    field: m.Field
    doc: str
    attributes: list[str]  # those that only some fields have, and the required parameters
    rows: list[str]
    places: str  # the sets in which it occurs


@dataclass(frozen=True, slots=True)
class Identity:
    field: str
    paths: tuple[str, ...]  # names of the texts that begin with the model number


@dataclass(frozen=True)
class Dissector:
    model: m.Model
    prefix = names.PREFIX
    parts = names.PARTS

    @cached_property
    def types(self) -> list[Type]:
        """Every enumeration and bitfield once."""
        listed = [self.model.protocol.function_selector, self.model.protocol.ack_code, *self.model.all_types]
        types = {t.full_name: t for t in listed if isinstance(t, (m.Enum, m.Bitfield))}
        return [Type(_named(t), _parts(t, self.model), "\n  " if t.kind == "bitfield" else " ") for t in types.values()]

    @cached_property
    def structs(self) -> list[Type]:
        """Every structure, each after those that it contains."""
        structs = m.structs(self.model.all_types)
        return [Type(_named(t), [row(p, t, self.model) for p in t.parameters]) for t in structs]

    @cached_property
    def acknowledge(self) -> Field:
        return _field(self.model.protocol.acknowledge, self.model)

    @cached_property
    def fields(self) -> list[Field]:
        return [_field(f, self.model) for f in self.model.fields]

    @cached_property
    def sets(self) -> list[tuple[m.Set, str]]:
        """Each set, with the titles of the fields of which only the names are known."""
        families = ((s, self.model.family(s.family)) for s in self.model.sets)
        return [(s, _list(f"[{hexadecimal(n.descriptor)}] = {string(n.title)}" for n in x.named))
                for s, x in families if x]  # fmt: skip

    @property
    def groups(self) -> list[tuple[str, ...]]:
        """The devices that share a reading of flags."""
        return self.model.derived(_groups)

    @cached_property
    def identity(self) -> Identity:
        """The reply with which a device identifies itself; without a field if the specification has none."""
        start = session(self.model)
        if start is None:
            return Identity("", ())
        (reply,) = self.model.responses(start.identify)
        return Identity(reply.full_name, tuple(path.split(".")[-1] for path in start.model_numbers))

    @cached_property
    def examples(self) -> list[str]:
        return names.examples(self.model)


# --------------------------------------------------------------------------- rows


def row(p: m.Parameter, record: m.Record | None, model: m.Model) -> str:
    """Writes a parameter as a row. An item of an array has no record: its meaning is with the array."""
    layout: dict[str, object] = {}
    content: dict[str, object] = {}
    match p.kind:
        case "scalar":
            layout = {"type": string(p.scalar.name), "size": p.size, **_names(p.named)}
        case "constant":
            layout = {"type": string(p.scalar.name), "size": p.size, "value": octets(p.octets)}
        case "counter":
            layout = {"type": string(p.scalar.name), "size": p.size}
        case "bits":
            layout = {"size": p.size, **_names(p.named)}
        case "text":
            layout = _length(p)
        case "array":
            layout = {
                **_length(p),
                "size": extent.item_size(p),
                "elements": _texts(p.vector.elements if p.vector else ()),
            }
            content = {"item": row(p.item, None, model)}
        case "struct":
            layout = {"record": _named(p.struct)}
        case "switch":
            layout = {"tag": string(p.tag or "")}
            content = {"cases": "{" + "".join(f"\n      {_case(c, record, model)}," for c in p.cases) + " }"}
    meaning = _meaning(p, record, model) if record else {}
    return lua_table({"kind": string(p.kind), "name": string(p.name), **layout, **meaning, **content})


def _case(c: m.Case, record: m.Record | None, model: m.Model) -> str:
    item = row(c.parameter, record, model) if c.parameter else ""
    return f"[{lua_number(c.tag.value)}] = {lua_table({'label': string(c.tag.name), 'item': item})}"


def _length(p: m.Parameter) -> dict[str, object]:
    counter = string(p.counter) if p.count is None and p.counter else ""
    return {"count": "" if p.count is None else p.count, "counter": counter, "capacity": p.capacity}


def _meaning(p: m.Parameter, record: m.Record, model: m.Model) -> dict[str, object]:
    facts = [fact for fact in describe.parameter(p, record, model) if fact.topic not in _LEFT_OUT]
    readings = [lua_table(_reading(v)).replace("{ ", "{", 1) for v in p.variants if v.type or v.units]
    valid = [_validity(r, model) for r in validity.readings([p], record)]
    return {
        "units": _units(p.units),
        "doc": string(_doc(p.description, facts, model)),
        "readings": _list(readings) if readings else "",
        "valid": _list(valid) if valid else "",
    }


def _groups(model: m.Model) -> list[tuple[str, ...]]:
    records: list[m.Field | m.Struct] = [*model.fields, *m.structs(model.all_types)]
    found = {r.devices for record in records for p in record.parameters for r in validity.readings([p], record)}
    return sorted(found - {()})


def _validity(r: validity.Reading, model: m.Model) -> str:
    """Writes the flags that mark a value as valid: of some devices, or of all others."""
    group = f"G[{model.derived(_groups).index(r.devices) + 1}]" if r.devices else ""
    flags = _list(lua_table({"name": string(x.parameter), "mask": lua_number(x.mask)}) for x in r.flags)
    return lua_table({"devices": group, "fewer": r.fewer or "", "flags": flags})


def _reading(v: m.Variant) -> dict[str, object]:
    condition = {"device": string(v.key)} if v.by_device else {"by": string(v.by), "value": lua_number(v.value or 0)}
    member = string(v.member) if v.member else ""
    return {**condition, "member": member, "units": _units(v.units), **_names(v.type)}


def _units(units: tuple[m.Unit, ...]) -> str:
    return _texts("" if unit == "1" else unit.symbol for unit in units) if set(units) - {"1"} else ""


def _field(f: m.Field, model: m.Model) -> Field:
    groups = [
        lua_table(
            {"kind": '"group"', "first": g.first, "last": g.last, "body": _list(row(p, f, model) for p in g.parameters)}
        )
        for g in f.groups
    ]
    rows = [*(row(p, f, model) for p in f.always), *groups]
    places = _list(
        lua_table({"set": hexadecimal(o.set), "name": string(f.name_in(o.set)), "title": string(o.title)})
        for o in f.occurrences
    )
    return Field(f, _doc(f.description, describe.caveats(f, model), model), list(_attributes(f)), rows, places)


def _attributes(f: m.Field) -> Iterator[str]:
    if f.functions:
        required = _list(f"[{x.value}] = {f.required(x.value)}" for x in f.functions)
        yield f"required = {required}, silent = {_list(f'[{x.value}] = true' for x in f.functions if not x.reply)}"
    else:
        yield f"always = {f.required()}"
    if f.signature:
        yield f"constants = {_list(lua_table({'at': at, 'value': octets(value)}) for at, value in f.signature)}"
    if f.silent_when:
        conditions = (lua_table({"name": string(c.parameter), "value": lua_number(c.value)}) for c in f.silent_when)
        yield f"silent_when = {_list(conditions)}"
    if names.is_plain(f):
        yield "plain = true"
    if f.sent_by == "device":
        yield "from_device = true"
    if f.timeout:
        yield f"timeout = {f.timeout}"


# --------------------------------------------------------------------------- names of values and bits


def _named(t: m.Type | None) -> str:
    """Writes the element of the table that contains a type."""
    assert t is not None
    return f"{ {'enum': 'E', 'bitfield': 'F', 'struct': 'S'}[t.kind] }[{string(t.full_name)}]"


def _names(t: m.Type | None) -> dict[str, object]:
    return {"enum" if t.kind == "enum" else "flags": _named(t)} if t else {}


def _parts(t: m.Enum | m.Bitfield, model: m.Model) -> list[str]:
    if isinstance(t, m.Enum):
        return [f"[{lua_number(v.value)}] = {string(v.name)}" for v in t.values]
    return [_bits(b, t, model) for b in t.bits]


def _bits(b: m.Bits, t: m.Bitfield, model: m.Model) -> str:
    place = place_of(b, t)
    attributes = {"name": string(b.name), "at": place.at, "size": place.size, "mask": place.mask, "shift": place.shift}
    attributes |= {"width": b.width, "little": "true" if place.little else "", "enum": _named(b.enum) if b.enum else ""}
    return lua_table(attributes | {"doc": string(_doc(b.description, describe.uncertain(b, model), model))})


@dataclass(frozen=True, slots=True)
class Place:
    """The position of bits: offset and size of some bytes of the bitfield, and a mask in the number that they form."""

    at: int
    size: int
    mask: int
    little: bool = False  # the bytes of the number are in reverse order

    @property
    def shift(self) -> int:
        return (self.mask & -self.mask).bit_length() - 1


def place_of(b: m.Bits, t: m.Bitfield) -> Place:
    """Returns the bytes that Wireshark shows for bits: all of a short bitfield, as few as possible of a long one.

    >>> health = m.Bitfield("h", None, 16, (), "", None)
    >>> place_of(m.Bits("a", 20, 23, "", False), health), place_of(m.Bits("b", 30, 33, "", False), health)
    (Place(at=2, size=1, mask=240, little=False), Place(at=3, size=2, mask=960, little=True))
    >>> place_of(m.Bits("c", 9, 9, "", False), m.Bitfield("i", m.SCALARS["u16"], 2, (), "", None))
    Place(at=0, size=2, mask=512, little=False)
    """
    if t.scalar is not None and t.size <= 4:
        return Place(0, t.size, b.mask)
    first, last = b.first // 8, b.last // 8
    size = last - first + 1
    mask = b.mask >> (8 * first)
    if t.scalar is None:
        return Place(first, size, mask, size > 1)
    return Place(t.size - 1 - last, size, mask)


# --------------------------------------------------------------------------- Lua


def lua_table(attributes: Mapping[str, object]) -> str:
    """
    >>> lua_table({"name": string("x"), "doc": "", "size": 0})
    '{ name = "x", size = 0 }'
    """
    return f"{{ {', '.join(f'{name} = {value}' for name, value in attributes.items() if value != '')} }}"


def _list(rows: Iterable[str]) -> str:
    return "{" + "".join(f" {each}," for each in rows) + " }"


def _texts(texts: Iterable[str]) -> str:
    listed = "".join(f"{string(text)}, " for text in texts)
    return listed and f"{{{listed}}}"


def string(text: str) -> str:
    r"""
    >>> string('a "b" \\ c')
    '"a \\"b\\" \\\\ c"'
    """
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def octets(values: Iterable[int]) -> str:
    """Writes bytes as a Lua string.

    >>> octets(b"\\x18n")
    '"\\\\24\\\\110"'
    """
    return '"' + "".join(f"\\{byte}" for byte in values) + '"'


def lua_number(value: int) -> str:
    """Writes a number in the form in which `decode.lua` reads it: its bytes, if Lua's numbers are not exact."""
    return str(value) if value < 1 << 53 else octets(value.to_bytes(8, "big"))


def hexadecimal(number: int) -> str:
    return f"0x{number:02X}"


def _doc(words: str, facts: list[describe.Fact], model: m.Model) -> str:
    return " ".join(filter(None, (plain(describe.prose(words, model)), *(plain(f.sentence) for f in facts))))


def plain(text: describe.Text) -> str:
    return describe.say(text, lambda ref: ref.words)
