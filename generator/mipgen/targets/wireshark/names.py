"""Display filter names, which must not collide: `mip.<set>.<field>.<parameter>.<element or bit>`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from mipgen import model as m
from mipgen.base import resources
from mipgen.emit.naming import Grammar, Identifier
from mipgen.emit.render import language

#: The name of the protocol in display filters.
PREFIX = "mip"
#: The parts of the dissector in runtime/wireshark, each after those that it uses.
PARTS = ("filters", "decode", "tree", "exchange", "packets", "transports", "files")
GRAMMAR = Grammar(r"[a-z0-9_]+(\.[a-z0-9_]+)*")  # of display filters


def field_filter(f: m.Field, o: m.Occurrence | None = None) -> str:
    """Returns the filter name of a field in one of its sets, by default the first."""
    return f"{PREFIX}.{(o or f.occurrences[0]).set_name}.{f.name}"


def is_plain(f: m.Field) -> bool:
    """Does a value use the filter name of the field, so that the line of the field itself has none?"""
    return any(p.name == f.name and _is_leaf(p) for p in f.parameters)


def filter_name(within: str, name: str) -> str:
    """Returns the filter name of a part. A parameter with the name of its field does not repeat it.

    >>> filter_name("mip.sensor.scaled_accel", "scaled_accel"), filter_name("mip.sensor.scaled_accel", "x")
    ('mip.sensor.scaled_accel', 'mip.sensor.scaled_accel.x')
    """
    depth = PREFIX.count(".") + 3  # prefix, set and field
    return within if within.count(".") + 1 == depth and within.endswith(f".{name}") else f"{within}.{name}"


def examples(model: m.Model) -> list[str]:
    """Returns examples of filters: for an element of a vector, a bit, a function, and a rejected command."""
    filters: dict[str, str] = {}
    for f in model.fields:
        for p in f.parameters:
            path = filter_name(field_filter(f), p.name)
            if p.vector and f.role == m.DATA:
                filters.setdefault("vector", f"{path}.{p.elements[0]} > 0.5")
            elif isinstance(p.element, m.Bitfield) and f.role == m.DATA and p.element.bits[0].width == 1:
                filters.setdefault("bit", f"{path}.{p.element.bits[0].name} == 1")
            elif p.selector:
                filters.setdefault("function", f'{path} == "{f.functions[0].name}"')
    code = model.protocol.acknowledge.parameters[-1]
    return [*filters.values(), f"{field_filter(model.protocol.acknowledge)}.{code.name} != 0"]


def identifiers(model: m.Model) -> Iterator[Identifier]:
    for name in language("wireshark")["protocols"]:
        yield Identifier("the protocols", name, f"{name} of Wireshark", None)
    yield Identifier("the protocols", PREFIX, "the package", model.protocol.position)
    text = (resources.root() / "runtime/wireshark/filters.lua").read_text("utf-8")
    for kind, name in re.findall(r'(PREFIX \.\. "\.|= finding\(")([a-z_.]*[a-z])"', text):
        own = f"expert.{name}" if "finding" in kind else name
        yield _filter(f"{PREFIX}.{own}", f"{own} of the dissector", None)
    for f in (model.protocol.acknowledge, *model.fields):
        for o in f.occurrences:
            path = field_filter(f, o)
            if not is_plain(f):
                yield _filter(path, f.name_in(o.set), f.position)
            yield from _parts(f.parameters, path, f.position)


def _parts(parameters: tuple[m.Parameter, ...], path: str, place: m.Position | None) -> Iterator[Identifier]:
    for p in parameters:
        inner = filter_name(path, p.name)
        if inner != path or _is_leaf(p):
            yield _filter(inner, f"{path}.{p.name}", p.position or place)
        match p.element:
            case m.Vector():
                for name in p.element.elements:
                    yield _filter(f"{inner}.{name}", f"{p.name}.{name}", p.position or place)
            case m.Bitfield():
                for b in p.element.bits:
                    yield _filter(f"{inner}.{b.name}", f"{p.name}.{b.name}", p.position or place)
            case m.Struct():
                yield from _parts(p.element.parameters, inner, p.position or place)
        yield from _parts(alternatives(p), inner, p.position or place)


def alternatives(union: m.Parameter) -> tuple[m.Parameter, ...]:
    """Returns the alternatives of a union that have data; several cases may share one."""
    return tuple({(p.name, p.element, p.length): p for p in union.alternatives}.values())


def _is_leaf(p: m.Parameter) -> bool:
    """Does the name apply to single values? That of a vector, a structure or a union applies to all of its parts."""
    return not (p.elements or p.item.struct or p.cases)


def _filter(name: str, what: str, position: m.Position | None) -> Identifier:
    return Identifier("display filters", name, what, position)
