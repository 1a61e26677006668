"""Layouts as JavaScript expressions, built from blocks of `mip/codec.mjs`, and further attributes of classes."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

from mipgen import model as m

from .names import class_name, constant, home, namespace, reference

#: Texts of JSON, which stay as they are, or whole numbers of at least 16 digits.
_LARGE = re.compile(r'"(?:[^"\\]|\\.)*"|(?<![\d.eE+-])(-?\d{16,})(?![\d.eE])')


def block(p: m.Parameter, record: m.Record) -> str:
    """Writes the block that decodes and encodes a parameter."""
    match p.kind:
        case "constant":
            return call("constant", _scalar(p), whole(p.constant or 0))
        case "counter":
            return call("counter", _scalar(p), json.dumps(p.counts))
        case "switch":
            cases = (f"[{whole(c.tag.value)}, {json.dumps(c.parameter.name)}, {block(c.parameter, record)}]"
                     for c in p.cases if c.parameter)  # fmt: skip
            return call("union", json.dumps(p.tag), f"[{', '.join(cases)}]")
    way = _several(p, record) if p.several and not p.vector else _one(p, record)
    return way if p.reserved is None else call("reserved", way, _initial(p))


def call(function: str, *arguments: str) -> str:
    """Writes a call of a function in `mip/codec.mjs`. Bundlers drop it if the result is not used."""
    return f"/* @__PURE__ */ codec.{function}({', '.join(arguments)})"


def _several(p: m.Parameter, record: m.Record) -> str:
    text = p.kind == "text"
    item = [] if text else [block(p.item, record)]
    if p.count is not None:
        return call("text" if text else "array", *item, str(p.count))
    if p.counter is None:
        return call("restText" if text else "rest", *item, str(p.capacity))
    return call("countedText" if text else "counted", json.dumps(p.counter), *item, str(p.capacity))


def _one(p: m.Parameter, record: m.Record) -> str:
    element = p.element
    if element is None or isinstance(element, m.Scalar):
        return _scalar(p)
    return reference(element, home(record))


def _scalar(p: m.Parameter) -> str:
    return f"codec.{p.scalar.name}"


def whole(value: int) -> str:
    """Writes a whole number: as a BigInt, if no Number is the same.

    >>> whole(9007199254740992), whole(9007199254740993)
    ('9007199254740992', '9007199254740993n')
    """
    return str(value) if int(float(value)) == value else f"{value}n"


def exact(document: str) -> str:
    """Returns a JSON document as an expression with the same numbers.

    >>> exact('{"a":9007199254740993,"b":"9007199254740993","c":0.9007199254740993,"d":1e30}')
    '{"a":9007199254740993n,"b":"9007199254740993","c":0.9007199254740993,"d":1e30}'
    """
    return _LARGE.sub(lambda match: match[0] if match[1] is None else whole(int(match[1])), document)


def _initial(p: m.Parameter) -> str:
    value = f"{p.reserved}n" if p.scalar.size == 8 and p.scalar.kind != "float" else str(p.reserved)
    return value if p.length is None else f"Array({p.length}).fill({value})"


def key(name: str) -> str:
    """Writes a name as the key of an object."""
    return json.dumps(name) if name[:1].isdigit() else name


def scalar_of(t: m.Enum | m.Bitfield) -> str:
    if isinstance(t, m.Bitfield) and t.scalar is None:
        return call("octets", str(t.size))
    assert t.scalar is not None
    return f"codec.{t.scalar.name}"


def bits(b: m.Bits) -> str:
    return f"{key(constant(b.name))}: [{b.first}, {b.last}]"


# --------------------------------------------------------------------------- further attributes


def sets(f: m.Field) -> str:
    if f.everywhere:
        return f"/* @__PURE__ */ field.every(0x{f.everywhere.start:02x}, 0x{f.everywhere.stop - 1:02x})"
    numbers = [f"0x{n:02x}" for n in f.sets]
    return numbers[0] if len(numbers) == 1 else f"[{', '.join(numbers)}]"


def more(f: m.Field, model: m.Model) -> list[str]:
    """Returns the attributes that only some classes of fields have."""
    return list(_more(f, model))


def _more(f: m.Field, model: m.Model) -> Iterator[str]:
    if f.groups and not f.selector:
        yield f"optional: {len(f.always)}"
    if len(model.layouts(f)) > 1:
        sizes = model.sizes(f)
        constants = ", ".join(f"[{at}, {list(octets)}]" for at, octets in f.signature)
        yield f"fits: [{sizes.start}, {sizes.stop - 1}, [{constants}]]"
    if f.functions:
        calls = (f"{c.function.value}: {len(c.required)}" for c in f.calls if c.function)
        yield f"calls: {{ {', '.join(calls)} }}"
    if f.role != m.COMMAND:
        return
    replies = [_reply(r, f) for r in model.replies(f)]
    if replies:
        yield f"REPLIES: [{', '.join(replies)}]"
    silent = [x.value for x in f.functions if not x.reply]
    if silent or f.silent_when:
        yield f"SILENT: [{silent}, {_conditions(f.silent_when)}]"
    if f.timeout:
        yield f"TIMEOUT: {f.timeout:g}"
    settings = list(_silenced_by(f, model))
    if settings:
        silencers = (f"[() => {_elsewhere(s, f)}, {json.dumps(c.parameter)}, {whole(c.value)}]" for c, s in settings)
        yield f"SILENCED_BY: [{', '.join(silencers)}]"


def _silenced_by(f: m.Field, model: m.Model) -> Iterator[tuple[m.Condition, m.Field]]:
    for c in f.silenced_by:
        setting = model.field(c.command or "")
        if setting is not None:
            yield c, setting


def _elsewhere(other: m.Field, f: m.Field) -> str:
    """Writes the name of a class, with its module if that belongs to another family."""
    name = class_name(other)
    return name if other.family == f.family else f"{namespace(other.family)}.{name}"


def needs(family: m.Family, model: m.Model) -> list[str]:
    """Returns the other families whose modules a family's module imports."""
    families = {s.family for f in family.fields if f.role == m.COMMAND for _, s in _silenced_by(f, model)}
    return sorted(families - {family.name})


def _reply(r: m.Reply, f: m.Field) -> str:
    functions = str([x.value for x in r.functions]) if f.functions else "null"
    return f"[{functions}, {_conditions(r.when)}, [{', '.join(reference(x, home(f)) for x in r.layouts)}]]"


def _conditions(conditions: tuple[m.Condition, ...]) -> str:
    rows = (f"[{json.dumps(c.parameter)}, {whole(c.value)}, {json.dumps(c.boolean)}]" for c in conditions)
    return f"[{', '.join(rows)}]"
