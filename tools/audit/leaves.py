"""Flattens layouts of the model and of witnesses to numbers in wire order, so that they can be compared one by one.

A vector becomes its elements, a structure its members, and a fixed-length array its items. An item of a variable-length
array appears once, with the source of its count.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from mipgen import model as m

#: The length of an array: the name of its counter, or REST; None for a single number.
Repeat = str | None

#: Smallest and largest value, and exclusive bounds.
BOUNDS = ("minimum", "maximum", "above", "below")


@dataclass(frozen=True)
class Leaf:
    """One number. Facts that a witness does not state are None."""

    path: str
    scalar: str  # or "union", or "unknown" for a structure that the witness does not define
    repeat: Repeat = None
    types: tuple[Any, ...] = ()  # ours: enumerations and bitfields; of a witness: dictionaries with values or bits
    units: frozenset[str] | None = None
    frames: frozenset[str] | None = None
    bounds: tuple[tuple[str, float], ...] | None = None
    default: Any = None
    needed: str | None = None  # the functions that require it
    valid: frozenset[int] | None = None  # the bits that mark it as valid
    cases: Any = None  # of a union: its tag, and case number -> leaves
    optional: bool = False
    most: int | None = None  # of a witness: the capacity of the array that this number counts
    label: bool = False  # of a witness: its name is made of words from a text
    position: m.Position | None = None

    @property
    def name(self) -> str:
        return self.path.rpartition(".")[2]

    @property
    def top(self) -> str:
        return self.path.partition(".")[0]


# --------------------------------------------------------------------------- of the model


def of_field(field: m.Field) -> list[Leaf]:
    return [leaf for p in field.counted for leaf in _of_parameter(p, field.parameters, "", bool(field.functions))]


def _of_parameter(p: m.Parameter, record: Sequence[m.Parameter], before: str, selector: bool) -> list[Leaf]:
    path = before + p.name
    needed = m.letters(p.required_for).replace("A", "") if selector and not before else None
    base = Leaf(path, "", needed=needed, optional=p.optional, position=p.position, default=_default(p))
    if p.union is not None:
        cases = {c.tag.value: _of_parameter(c.parameter, (), "", False) if c.parameter else [] for c in p.cases}
        return [replace(base, scalar="union", cases=(p.union.tag, cases))]
    leaves = _of_element(p, record, base)
    if isinstance(p.length, int):
        return (
            leaves * p.length
            if len(p.units) < 2
            else [replace(x, units=_units(p, i)) for i, x in enumerate(leaves * p.length)]
        )
    return [replace(x, repeat=p.length) for x in leaves] if p.length is not None else leaves


def _of_element(p: m.Parameter, record: Sequence[m.Parameter], base: Leaf) -> list[Leaf]:
    base = replace(base, frames=_frames(p), bounds=_bounds(p))
    readings = tuple(v.type for v in p.readings)
    match p.element:
        case m.Scalar():
            named = replace(base, scalar=p.element.name, types=readings)
            return [replace(named, units=_units(p, 0), valid=_valid(p, record, 0))]
        case m.Enum() | m.Bitfield():
            scalar = p.element.scalar.name if p.element.scalar else "u8"
            leaf = replace(base, scalar=scalar, types=(p.element, *readings), units=_units(p, 0))
            leaf = replace(leaf, valid=_valid(p, record, 0))
            return [leaf] * (p.element.size if isinstance(p.element, m.Bitfield) and not p.element.scalar else 1)
        case m.Vector():
            return [
                replace(
                    base,
                    path=f"{base.path}.{name}",
                    scalar=p.element.scalar.name,
                    units=_units(p, i),
                    valid=_valid(p, record, i),
                    default=base.default[i] if isinstance(base.default, (list, tuple)) else base.default,
                )
                for i, name in enumerate(p.element.elements)
            ]
        case m.Struct():
            leaves = list[Leaf]()
            for member in p.element.parameters:
                own = tuple(replace(v, member="") for v in p.variants if v.member == member.name)
                full = replace(member, variants=(*member.variants, *own))
                leaves += _of_parameter(full, p.element.parameters, f"{base.path}.", False)
            outer = _valid(p, record, 0)
            return [replace(x, needed=base.needed, optional=base.optional, valid=x.valid or outer) for x in leaves]
    raise AssertionError(p.name)


def _default(p: m.Parameter) -> Any:
    """Returns the default, as a number if it is a named value; a device's default if there is no general one."""
    stated = (
        p.default if p.default is not None else next((v.default for v in p.variants if v.default is not None), None)
    )
    value = p.element.by_name(stated) if isinstance(p.element, m.Enum) and isinstance(stated, str) else None
    return value.value if value else stated


def _units(p: m.Parameter, index: int) -> frozenset[str]:
    varied = [v.units for v in p.variants if v.units and not v.member]
    lists = [p.units] if p.units else varied
    units = frozenset(u[index] if len(u) > 1 else u[0] for u in lists)
    return units or frozenset({"any"} if p.any_unit else ())


def _frames(p: m.Parameter) -> frozenset[str]:
    return frozenset(f for f in (p.frame, *(v.frame for v in p.variants)) if f)


def _bounds(p: m.Parameter) -> tuple[tuple[str, float], ...]:
    return tuple((name, float(getattr(p, name))) for name in BOUNDS if getattr(p, name) is not None)


def _valid(p: m.Parameter, record: Sequence[m.Parameter], index: int) -> frozenset[int]:
    """Returns the first bit of the flag that marks an element as valid; 0 for a bool."""
    if not p.valid:
        return frozenset()
    flags, _, name = (p.valid[index] if len(p.valid) > 1 else p.valid[0]).partition(".")
    holder = next((q for q in record if q.name == flags), None)
    bits = holder.element.bits if holder and isinstance(holder.element, m.Bitfield) else ()
    return frozenset(b.first for b in bits if b.name == name) or frozenset({0})


# --------------------------------------------------------------------------- of a witness

#: In place of parameters: those of the command to which the layout is the response.
AS_COMMAND = "as_command"


def commands_of(response: dict[str, Any], layouts: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Returns the commands that have this response, of the same witness."""
    number, _, descriptor = response["key"].partition(",")
    if response["role"] != "response":
        return []
    return [x for x in layouts if x["key"].startswith(number) and x.get("response") == descriptor]


def as_command(command: dict[str, Any]) -> list[dict[str, Any]]:
    """Returns the parameters of a command's response that has the same ones."""
    return [{key: value for key, value in p.items() if key != "for"} for p in command["parameters"]]


def written_out(facts: dict[str, Any]) -> dict[str, Any]:
    """Returns the facts of a witness with the parameters of all layouts."""
    layouts = [
        {**x, "parameters": as_command(commands_of(x, facts["layouts"])[0])} if x["parameters"] == AS_COMMAND else x
        for x in facts["layouts"]
    ]
    return {**facts, "layouts": layouts}


class Reader:
    """Converts layouts of witnesses to leaves. It knows the types of all, as manuals use types that only others
    define."""

    def __init__(self, witnesses: Iterable[dict[str, Any]]) -> None:
        self.vectors: dict[str, Any] = {}
        self.structs: dict[str, Any] = {}
        self.types: dict[str, Any] = {}
        self.symbols: dict[str, str] = {}
        for facts in witnesses:
            self.symbols |= {token: symbol for symbol, tokens in facts.get("units", {}).items() for token in tokens}
            self.vectors |= facts.get("vectors", {})
            self.structs |= facts.get("structs", {})
            self.types |= facts.get("enums", {}) | facts.get("bitfields", {})
        short = [name.rpartition("::")[2] for name in self.structs]
        self.structs |= {s: x for s, x in zip(short, list(self.structs.values()), strict=True) if short.count(s) == 1}

    def layout(self, layout: dict[str, Any], symbols: dict[str, str]) -> list[Leaf]:
        about = frozenset(layout["frames"]) if "frames" in layout else None
        return self._record(layout["parameters"], "", about, symbols)

    def _record(
        self, record: list[dict[str, Any]], before: str, about: frozenset[str] | None, symbols: dict[str, str]
    ) -> list[Leaf]:
        most = {before + p["by"]: p["max"] for p in record if "max" in p and "by" in p}
        leaves = [leaf for p in record for leaf in self._parameter(p, before, about, symbols)]
        return [replace(x, most=most[x.path]) if x.path in most else x for x in leaves]

    def _parameter(
        self, p: dict[str, Any], before: str, about: frozenset[str] | None, symbols: dict[str, str]
    ) -> list[Leaf]:
        base = Leaf(
            before + (p.get("name") or p["label"]),
            p["type"],
            units=frozenset({(self.symbols | symbols)[p["unit"]]}) if "unit" in p else None,
            frames=frozenset(p["frames"]) if "frames" in p else about,
            bounds=_stated_bounds(p) if _switch(p) or "range" in p or "above" in p else None,
            default=p.get("default"),
            needed=p.get("for"),
            valid=frozenset({p["valid"]}) if "valid" in p else None,
            label="label" in p,
        )
        if p["type"] == "union":
            cases = {case["when"][1]: self._parameter(case, "", None, symbols) for case in p["cases"]}
            return [replace(base, cases=(p["by"], cases))]
        count = p.get("count")
        if "of" in p:
            scalar, elements = self.vectors[p["of"]]
            leaves = [replace(base, path=f"{base.path}.{e}", scalar=scalar) for e in elements]
            count = count // len(elements) if isinstance(count, int) else count
        elif p["type"] != "struct":
            leaves = [replace(base, types=tuple(self._types(p)))]
        elif p["struct"] in self.structs:
            inside = self._record(self.structs[p["struct"]], f"{base.path}.", None, symbols)
            leaves = [replace(x, needed=base.needed) for x in inside]
        else:
            leaves = [replace(base, scalar="unknown")]
        if "by" in p or count == m.REST:
            return [replace(x, repeat=p.get("by", m.REST)) for x in leaves]
        return leaves * (1 if count is None else count)

    def _types(self, p: dict[str, Any]) -> Iterable[dict[str, Any]]:
        for key in ("enum", "bitfield"):
            if key in p:
                yield {**self.types[p[key]], "name": p[key]}
        for key in ("values", "bits"):
            if key in p:
                yield {"type": p["type"], key: p[key], "name": "its table", "loose": True}


def _stated_bounds(p: dict[str, Any]) -> tuple[tuple[str, float], ...]:
    """Returns the bounds: 0 and 1 for a byte that has only these values."""
    low, high = p.get("range", (None, None))
    if _switch(p):
        low, high = 0, 1
    bounds = {"minimum": low, "maximum": high, "above": p.get("above")}
    return tuple((name, float(value)) for name, value in bounds.items() if value is not None)


def _switch(p: dict[str, Any]) -> bool:
    return p["type"] == "u8" and set(p.get("values", {}).values()) == {0, 1}
