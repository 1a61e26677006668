"""Differences by device, or by the value of a sibling parameter.

A variant states the same facts as a parameter (unit, frame, range, default, description, ...). It may
name the type that defines the meaning of a plain number, list the values that exist, or state that they are
unknown. Variants by sibling are in the set file, variants by device in the device's file. A member of a
structure may differ: if a parameter outside of the structure decides, the variant is stated where the
structure is used.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.lower.extent import size
from mipgen.read.nodes import Node
from mipgen.read.problems import nearest

from . import meaning
from .meaning import Problem
from .vocabulary import Vocabulary, texts_of_node

#: The keyword for a variant whose values are unknown.
UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class Scope:
    """The names to which a variant may refer."""

    words: Vocabulary
    find: Callable[[str, m.Position | None], m.Type | None]  # a type by its name
    problem: Problem


def differs_by_device(node: Node) -> bool:
    """True for `varies: device`: every device that supports the field states the values in its own file."""
    return bool(node.scalar("varies") == m.DEVICE)


def by_sibling(node: Node, p: m.Parameter, beside: Iterable[m.Parameter], scope: Scope) -> tuple[m.Variant, ...]:
    """Returns the variants for `varies: {mode: {fast: ..., slow: ...}}`, differences by an enumeration of the same
    record, or for `varies: {unit by mode: ...}`, those of a member of a structure."""
    spec = node.get("varies")
    if spec is None or spec.value == m.DEVICE:
        return ()
    siblings = {q.name: q for q in beside if q.name != p.name}
    key, cases = next(spec.items())
    member, _, by = key.rpartition(" by ")
    sibling, place = siblings.get(by), spec.keys[key]
    if sibling is None or not isinstance(sibling.element, m.Enum):
        near = nearest(by, [m.DEVICE, *(name for name, q in siblings.items() if isinstance(q.element, m.Enum))])
        scope.problem(place, f"'{by}' is not an enumeration beside '{p.name}'{near}")
        return ()
    what = _concerned(member, place, p, scope) if member else p
    if what is None:
        return ()
    variants = []
    for label, case in cases.items():
        value = sibling.element.by_name(label)
        if value is None:
            near = nearest(label, [v.name for v in sibling.element.values])
            scope.problem(cases.keys[label], f"'{sibling.element.name}' has no value '{label}'{near}")
        if case.scalar("valid") is not None:
            meaning.valid_bits(case, what, siblings.values(), scope.problem)
        v = resolve_variant(case, what, by, label, value.value if value else None, scope)
        variants.append(replace(v, member=member))
    return tuple(variants)


def _concerned(name: str, place: m.Position, p: m.Parameter, scope: Scope) -> m.Parameter | None:
    """Returns the member of the structure `p` that differs."""
    members = {q.name: q for q in p.element.parameters} if isinstance(p.element, m.Struct) else {}
    if name not in members:
        near = nearest(name, members) if members else "; only a structure has members"
        scope.problem(place, f"'{p.name}' has no member '{name}'{near}")
    return members.get(name)


def resolve_variant(node: Node, p: m.Parameter, by: str, key: str, value: int | None, scope: Scope) -> m.Variant:
    """Resolves one variant."""
    words, problem = scope.words, scope.problem
    if node.value == UNKNOWN:
        return m.Variant(by, key, value, unknown=True)
    limits = meaning.resolve_range(node, p, problem)
    reading = _reading(node, p, scope)
    frame = meaning.resolve_frame(node, words.frames, problem)
    return m.Variant(
        by=by,
        key=key,
        value=value,
        type=reading,
        units=meaning.resolve_units(node, replace(p, element=reading) if reading else p, words.units, problem),
        elements=meaning.frame_elements(p, frame, words.frames),
        frame=frame,
        **limits,
        default=meaning.resolve_default(
            node, replace(p, minimum=limits.get("minimum"), maximum=limits.get("maximum")), problem
        ),
        valid=meaning.resolve_valid(node) if "valid" in node else None,
        constant=_constant(node, p, problem),
        only=_only(node, p, reading or p.element, problem),
        deprecated=node.scalar("deprecated"),
        description=node.scalar("description", ""),
        inferred=" ".join(texts_of_node(node, "uncertain")),
    )


def _constant(node: Node, p: m.Parameter, problem: Problem) -> int | None:
    """Resolves `const`, the only value of a number."""
    if "const" not in node:
        return None
    value: int = node["const"].value
    if p.constant is not None:
        problem(node.keys["const"], f"'{p.name}' is always {p.constant} by its definition; remove const there or here")
    elif not (isinstance(p.element, m.Scalar) and p.element.kind == "unsigned" and p.length is None):
        problem(node.keys["const"], f"'{p.name}' is not one unsigned number, so it has no const; remove it")
    elif value >> p.element.width:
        problem(node["const"].position, f"{value} does not fit in {p.element.name}")
    return value


def _only(node: Node, p: m.Parameter, t: object, problem: Problem) -> tuple[m.EnumValue | m.Bits, ...]:
    """Resolves the values of an enumeration, or the bits of a bitfield, that a device has."""
    parts: list[m.EnumValue | m.Bits] = []
    for part, kind, what in (("values", m.Enum, "an enumeration"), ("bits", m.Bitfield, "a bitfield")):
        if part not in node:
            continue
        if not isinstance(t, kind):
            problem(node.keys[part], f"'{p.name}' is not {what}, so it has no {part}; remove them")
            continue
        by_name = {x.name: x for x in (t.values if isinstance(t, m.Enum) else t.bits)}
        for entry in node[part]:
            if entry.value in by_name:
                parts.append(by_name[entry.value])
            else:
                near = nearest(entry.value, by_name)
                problem(entry.position, f"'{t.name}' has no {part[:-1]} '{entry.value}'{near}")
    return tuple(parts)


def _reading(node: Node, p: m.Parameter, scope: Scope) -> m.Enum | m.Bitfield | None:
    """Resolves the type that names the values or bits of a number."""
    entry = node.get("type")
    if entry is None:
        return None
    named = scope.find(entry.value, entry.position)
    if named is None:
        return None
    if not isinstance(named, (m.Enum, m.Bitfield)):
        scope.problem(entry.position, f"'{named.name}' is neither an enumeration nor a bitfield")
        return None
    if isinstance(p.element, (m.Struct, m.Vector)) or (
        isinstance(p.element, m.Scalar) and p.element.kind != "unsigned"
    ):
        scope.problem(entry.position, f"'{p.name}' is not an unsigned number, so '{named.name}' cannot name its values")
        return None
    own, width = size(p)[1], named.scalar.size if isinstance(named, m.Enum) else named.size
    if own != width:
        scope.problem(entry.position, f"'{named.name}' has {8 * width} bits, but '{p.name}' has {8 * own}")
        return None
    return named
