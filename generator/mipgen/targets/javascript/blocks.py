"""Layouts as JavaScript expressions, built from blocks of `mip/codec.mjs`, and further attributes of classes."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator

from mipgen import model as m
from mipgen.lower import validity
from mipgen.lower.runs import runs

from .names import class_name, home, member, namespace, reference

#: Texts of JSON, which stay as they are, or whole numbers of at least 16 digits.
_LARGE = re.compile(r'"(?:[^"\\]|\\.)*"|(?<![\d.eE+-])(-?\d{16,})(?![\d.eE])')


def block(p: m.Parameter, where: str) -> str:
    """Writes the block that decodes and encodes a parameter, in the module `where`."""
    match p.kind:
        case "constant":
            return call("constant", scalar(p.scalar), whole_number(p.constant or 0))
        case "counter":
            return call("counter", scalar(p.scalar), quoted(p.counts))
        case "switch":
            cases = (f"[{whole_number(c.tag.value)}, {quoted(c.parameter.name)}, {block(c.parameter, where)}]"
                     for c in p.cases if c.parameter)  # fmt: skip
            return call("union", quoted(p.tag), f"[{', '.join(cases)}]")
    if p.several and not p.vector:
        expression = _several(p, where)
    elif p.element is None or isinstance(p.element, m.Scalar):
        expression = scalar(p.scalar)
    else:
        expression = reference(p.element, where)
    return expression if p.reserved is None else call("reserved", expression, _initial(p))


def quoted(name: str | None) -> str:
    """Writes the name of a member as a text."""
    return json.dumps(member(name or ""))


def call(function: str, *arguments: str) -> str:
    """Writes a call of a function in `mip/codec.mjs`. Bundlers drop it if the result is not used."""
    return f"/* @__PURE__ */ codec.{function}({', '.join(arguments)})"


def opening(function: str, *arguments: str) -> str:
    """Writes such a call up to its last argument."""
    return f"/* @__PURE__ */ codec.{function}({''.join(f'{x}, ' for x in arguments)}"


def _several(p: m.Parameter, where: str) -> str:
    text = p.kind == "text"
    item = [] if text else [block(p.item, where)]
    if p.count is not None:
        return call("text" if text else "array", *item, str(p.count))
    if p.counter is None:
        return call("restText" if text else "rest", *item, str(p.capacity))
    return call("countedText" if text else "counted", quoted(p.counter), *item, str(p.capacity))


def scalar(of: m.Scalar) -> str:
    return f"codec.{of.name}"


def whole_number(value: int) -> str:
    """Writes a whole number: as a BigInt, if no Number is the same.

    >>> whole_number(9007199254740992), whole_number(9007199254740993)
    ('9007199254740992', '9007199254740993n')
    """
    return str(value) if int(float(value)) == value else f"{value}n"


def exact_json(document: str) -> str:
    """Returns a JSON document as an expression with the same numbers.

    >>> exact_json('{"a":9007199254740993,"b":"9007199254740993","c":0.9007199254740993,"d":1e30}')
    '{"a":9007199254740993n,"b":"9007199254740993","c":0.9007199254740993,"d":1e30}'
    """
    return _LARGE.sub(lambda match: match[0] if match[1] is None else whole_number(int(match[1])), document)


def _initial(p: m.Parameter) -> str:
    value = f"{p.reserved}n" if p.scalar.size == 8 and p.scalar.kind != "float" else str(p.reserved)
    return value if p.length is None else f"Array({p.length}).fill({value})"


def object_key(name: str) -> str:
    """Writes a name as the key of an object."""
    return json.dumps(name) if name[:1].isdigit() else name


def reading(f: m.Field) -> list[tuple[str, str]]:
    """Returns the members of data that consists of numbers and vectors at fixed offsets, and what reads each; none for
    other data."""
    found = []
    for r in runs(f) if f.role == m.DATA else ():
        p = r.parameter
        if p.reserved is not None or len(r.path) > 1 or not (p.vector or p.kind == "scalar"):
            return []
        block = reference(p.vector, home(f)) if p.vector else scalar(p.scalar)
        found.append((member(p.name), f"{block}(reader, {r.offset})"))
    return found


def vector(t: m.Vector) -> str:
    """Writes the block of a vector."""
    offsets = ("at", *(f"at + {i * t.scalar.size}" for i in range(1, len(t.elements))))
    items = [f"{scalar(t.scalar)}(reader, {at})" for at in offsets]
    lines = f"[{', '.join(items)}]" if len(items) < 4 else "[" + "".join(f"\n    {x}," for x in items) + "\n]"
    return call("vector", f"(reader, at) => {lines}")


# --------------------------------------------------------------------------- further attributes


def sets(f: m.Field) -> str:
    if f.everywhere:
        return f"/* @__PURE__ */ field.every(0x{f.everywhere.start:02x}, 0x{f.everywhere.stop - 1:02x})"
    return f"0x{f.sets[0]:02x}" if len(f.sets) == 1 else numbers(f.sets)


def numbers(sets: Iterable[int]) -> str:
    return f"[{', '.join(f'0x{n:02x}' for n in sets)}]"


def class_attributes(f: m.Field, model: m.Model) -> Iterator[str]:
    """Yields the attributes that only some classes of fields have."""
    if f.groups and not f.selector:
        yield f"optional: {len(f.always)}"
    if len(model.layouts(f)) > 1:
        sizes = model.sizes(f)
        constants = ", ".join(f"[{at}, {list(octets)}]" for at, octets in f.signature)
        yield f"fits: [{sizes.start}, {sizes.stop - 1}, [{constants}]]"
    if f.functions:
        required = {c.function.value: f" {len(c.required)}" for c in f.calls if c.function}
        yield f"calls: [{','.join(required.get(i, '') for i in range(max(required) + 1))}]"
    if valid := _validity(f):
        yield f"VALID: {valid}"
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
    silencers = [
        f"[() => {_elsewhere(setting, f)}, {quoted(c.parameter)}, {whole_number(c.value)}]"
        for c, setting in silenced_by(f, model)
    ]
    if silencers:
        yield f"SILENCED_BY: [{', '.join(silencers)}]"


def _validity(f: m.Field) -> str:
    """Writes the flags that mark values as valid, and those of devices that have others; nothing without flags."""
    usual: dict[str, validity.Reading] = {}
    others: dict[tuple[tuple[str, ...], int, str], dict[str, validity.Reading]] = {}
    for p in f.parameters:
        readings = validity.readings([p], f)
        usual |= {member(p.name): x for x in readings[-1:]}
        for r in readings[:-1]:
            holder = next(flag.parameter for x in readings for flag in x.flags)
            others.setdefault((r.devices, r.fewer, member(holder)), {})[member(p.name)] = r
    rows = [
        f"\n        [{json.dumps(devices)}, 0x{fewer:x}, {json.dumps(holder)}, {_flags(flags, holder)}],"
        for (devices, fewer, holder), flags in others.items()
    ]
    more = f", [{''.join(rows)}\n    ]" if rows else ""
    return f"/* @__PURE__ */ field.validity({_flags(usual)}{more})" if usual else ""


def _flags(of: dict[str, validity.Reading], usual: str = "") -> str:
    """Writes masks by the parameter that contains the flags, and by the value; a list has one for each element, and
    none for a value without flags, which is by the `usual` parameter."""
    masks: dict[str, dict[str, str]] = {}
    for name, reading in of.items():
        for holder in dict.fromkeys([flag.parameter for flag in reading.flags] or filter(None, [usual])):
            own = [f"0x{x.mask:x}" if x.parameter == holder else "null" for x in reading.flags]
            masks.setdefault(member(holder), {})[name] = own[0] if len(own) == 1 else f"[{', '.join(own)}]"
    return _mapping({holder: _mapping(own) for holder, own in masks.items()})


def _mapping(entries: dict[str, str]) -> str:
    return f"{{ {', '.join(f'{name}: {value}' for name, value in entries.items())} }}"


def silenced_by(f: m.Field, model: m.Model) -> Iterator[tuple[m.Condition, m.Field]]:
    """Yields the conditions under which a command gets no reply, with the setting that each concerns."""
    for c in f.silenced_by:
        setting = model.field(c.command or "")
        if setting is not None:
            yield c, setting


def _elsewhere(other: m.Field, f: m.Field) -> str:
    """Writes the name of a class, with its module if that belongs to another family."""
    name = class_name(other)
    return name if other.family == f.family else f"{namespace(other.family)}.{name}"


def _reply(r: m.Reply, f: m.Field) -> str:
    functions = str([x.value for x in r.functions]) if f.functions else "null"
    return f"[{functions}, {_conditions(r.when)}, [{', '.join(reference(x, home(f)) for x in r.layouts)}]]"


def _conditions(conditions: tuple[m.Condition, ...]) -> str:
    rows = (f"[{quoted(c.parameter)}, {whole_number(c.value)}, {json.dumps(c.boolean)}]" for c in conditions)
    return f"[{', '.join(rows)}]"
