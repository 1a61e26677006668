"""Makes the classes of types and fields, as in a generated package."""

from __future__ import annotations

from collections import namedtuple
from collections.abc import Callable, Iterator
from enum import IntFlag
from importlib import import_module
from types import ModuleType
from typing import Any

from .document import BITS, ELEMENTS, Document, Item


def doc(thing: Item, title: str = "") -> str:
    """Composes a docstring: title, description, notes and sources."""
    notes = " ".join(thing.get("notes", ()))
    sources = "\n".join(f"- {s['manual']}: {s['section']}" for s in thing.get("sources", ()) if "section" in s)
    return "\n\n".join(filter(None, (title, thing.get("description", ""), notes, sources)))


class Records:
    """Makes the classes of one module."""

    def __init__(self, document: Document, module: ModuleType) -> None:
        self.document, self.module = document, module
        self.codec = import_module(f"{document.package}.codec")
        self.wire = import_module(f"{document.package}.wire")
        self.field = import_module(f"{document.package}.field")
        self.scalars = import_module(f"{document.package}._scalars").SCALARS

    def add(self, name: str, bases: tuple[type, ...], content: dict[str, Any]) -> type:
        """Adds a class to the module."""
        made = type(name, bases, {"__module__": self.module.__name__, "__qualname__": name, **content})
        setattr(self.module, name, made)
        return made

    # ----------------------------------------------------------------- types

    def type(self, t: Item) -> None:
        kinds: dict[str, Callable[[Item, str], None]] = {
            "enum": self.enumeration, "bitfield": self.bitfield, "vector": self.vector, "struct": self.structure,
        }  # fmt: skip
        kinds[t["kind"]](t, self.document.symbol(t["name"])[1])

    def enumeration(self, t: Item, name: str) -> None:
        values = [(self.document.constant(v["name"]), v["value"]) for v in t["values"]]
        self._enum(self.codec.OpenEnum, t, name, values)

    def bitfield(self, t: Item, name: str) -> None:
        values = [(self.document.constant(b["name"]), mask(b)) for b in t["bits"]]
        kind = self.codec.open_flag(8 * t["size"])(self._enum(IntFlag, t, name, values))
        for b in t["bits"]:
            if b["last"] > b["first"] and not b.get("alias"):
                number = self.document.get(b["enum"]) if b.get("enum") else int
                setattr(kind, self.document.member(b["name"], BITS), property(_bits(b, number)))
                setattr(kind, f"with_{self.document.checked(b['name'])}", self._with(b))

    def _enum(self, base: Any, t: Item, name: str, values: list[tuple[str, int]]) -> Any:
        kind = base(name, values, module=self.module.__name__, qualname=name)
        kind.__doc__ = doc(t)
        setattr(self.module, name, kind)
        return kind

    def _with(self, b: Item) -> Any:
        fits = self.codec.fits

        def with_bits(self: Any, value: int) -> Any:
            given = fits(b["name"], value, b["last"] - b["first"] + 1)
            return type(self)(int(self) & ~mask(b) | given << b["first"])

        return with_bits

    def vector(self, t: Item, name: str) -> None:
        elements = [self.document.member(e, ELEMENTS) for e in t["elements"]]
        plain: Any = namedtuple(name, elements)  # type: ignore[misc]
        content: dict[str, Any] = {"__slots__": (), "__doc__": doc(t)}
        columns = _columns(t["elements"])
        if columns:
            element, count = self.codec.element, len(elements)
            content["rows"] = property(
                lambda self: tuple([tuple.__getitem__(self, slice(i, i + columns)) for i in range(0, count, columns)])
            )
            content["__getitem__"] = lambda self, at: element(self, at, columns)
        self.add(name, (plain,), content)

    def structure(self, t: Item, name: str) -> None:
        self.add(name, (self.field.Structure,), {"__doc__": doc(t), **self.record(t)})

    # ----------------------------------------------------------------- what structures and fields have in common

    def record(self, r: Item) -> dict[str, Any]:
        self.capacities = {p["member"]: p["capacity"] for p in operations(r) if "capacity" in p}
        rows, always = self.layout(r["operations"])
        selector = any(p.get("selector") for p in r["parameters"])
        held = [p for p in r["parameters"] if not derived(p)]
        absent = {p["name"] for p in held if (not p.get("selector") if selector else p.get("optional"))}
        named = self.document.member
        content: dict[str, Any] = {
            "__slots__": tuple(named(p["name"]) for p in held),
            "_LAYOUT": rows,
            "_VECTORS": {
                named(p["name"]): kinds for p in held if "length" not in p and (kinds := tuple(self.vectors(p)))
            },
        }
        if always is not None:
            content["_ALWAYS"] = always
        if held:
            content["__init__"] = self.initializer(held, absent)
            content["__match_args__"] = tuple(
                named(p["name"]) for i, p in enumerate(held) if not by_name(held, absent, i)
            )
        return content

    def vectors(self, p: Item) -> Iterator[Any]:
        """Yields the vector types that a value, or each item of an array, may have."""
        found = [p, *(c["parameter"] for c in p.get("cases", ()) if "parameter" in c)]
        names = [q["type"] for q in found if self.document.types.get(q.get("type", ""), {}).get("kind") == "vector"]
        return (self.document.get(name) for name in dict.fromkeys(names))

    def initializer(self, held: list[Item], absent: set[str]) -> Any:
        """Makes the constructor, with the same parameters as in a generated package."""
        names: dict[str, Any] = {"codec": self.codec}
        given, keywords, lines = ["self"], list[str](), list[str]()
        for i, p in enumerate(held):
            name, value = self.document.member(p["name"]), default(p, p["name"] in absent)
            parameter = name if value is _NONE else f"{name}=_d{i}"
            names[f"_d{i}"] = value
            (keywords if by_name(held, absent, i) else given).append(parameter)
            kinds = [f"_k{i}_{n}" for n, _ in enumerate(self.vectors(p))]
            names |= dict(zip(kinds, self.vectors(p)))
            kept = name
            if kinds:
                kept = f"codec.vector{'s' * ('length' in p)}({name}, {', '.join(kinds)})"
            elif "length" in p and p.get("type") != "char":
                kept = f"codec.several({name})"
            lines.append(f" self.{name} = {kept}")
        head = ", ".join([*given, *(["*", *keywords] if keywords else [])])
        exec(f"def __init__({head}):\n" + "\n".join(lines), names)
        return names["__init__"]

    # ----------------------------------------------------------------- layouts

    def layout(self, operations: list[Item]) -> tuple[tuple[Any, ...], int | None]:
        """Makes the rows of a layout. Also returns how many are always present; None if all are."""
        rows, always = list[Any](), None
        for o in operations:
            if o["kind"] == "group":
                always = len(rows) if always is None else always
                rows += [self.row(inner) for inner in o["body"]]
            else:
                rows.append(self.row(o))
        return tuple(rows), always

    def row(self, o: Item) -> tuple[str, str, Any]:
        wire, name, kind = self.wire, self.document.member(o["member"]), o["kind"]
        if kind in ("scalar", "constant", "counter"):
            what: Any = self.convert(o)
            if kind == "constant":
                what = int(o["value"])
            elif kind == "counter":
                what = wire.Counts(self.document.member(o["array"]), self.capacities[o["array"]])
            return name, self.scalars[o["scalar"]].letter, what
        if kind == "bits":
            return name, "B" * o["size"], wire.Bits(self.convert(o))
        if kind == "struct":
            return name, "", self.document.get(o["struct"])
        if kind == "switch":
            cases = {c["value"]: self.row(c["operation"]) for c in o["cases"] if "operation" in c}
            return name, "", wire.Union(self.document.member(o["tag"]), cases)
        length = self.document.member(o["counter"]) if "counter" in o else o.get("count")
        if kind == "text":
            return name, "", wire.Text(length, o["capacity"])
        return self.array(name, o, length)

    def array(self, name: str, o: Item, length: int | str | None) -> tuple[str, str, Any]:
        wire, item = self.wire, o["item"]
        if item["kind"] == "struct":
            return name, "", wire.Items(self.document.get(item["struct"]), length, o["capacity"])
        if item["kind"] == "array":  # an array of vectors
            letters = self.scalars[item["item"]["scalar"]].letter * item["count"]
            return name, letters, wire.Items(self.document.get(item["vector"]), length, o["capacity"])
        letter, kind = self.scalars[item["scalar"]].letter, self.convert(item)
        if not isinstance(length, int):
            return name, letter, wire.Items(kind, length, o["capacity"])
        if "vector" in o:
            return name, letter * length, self.document.get(o["vector"])
        return name, letter * length, wire.Each(kind) if kind else tuple

    def convert(self, o: Item) -> Any:
        if "type" in o:
            return self.document.get(o["type"])
        return self.codec.truth if o.get("scalar") == "bool" else None

    #: Array in the current record -> the maximum number of items in a field.
    capacities: dict[str, int]


def operations(r: Item) -> list[Item]:
    """Returns the operations of all parameters, without groups."""
    return [inner for o in r["operations"] for inner in o.get("body", [o])]


def mask(b: Item) -> int:
    first, last = int(b["first"]), int(b["last"])
    return ((1 << (last - first + 1)) - 1) << first


def derived(p: Item) -> bool:
    return "constant" in p or "counts" in p


class _None:
    pass


_NONE = _None()


def default(p: Item, absent: bool) -> Any:
    """Returns the value of a member that the caller omits; _NONE if it must not be omitted."""
    if absent or "cases" in p:
        return None
    if "reserved" not in p:
        return _NONE
    return (p["reserved"],) * p["length"] if "length" in p else p["reserved"]


def by_name(held: list[Item], absent: set[str], i: int) -> bool:
    """Does a member have a default, although a member after it has none? It is then a keyword-only parameter."""
    p = held[i]
    later = (default(q, q["name"] in absent) for q in held[i + 1 :])
    return default(p, p["name"] in absent) is not _NONE and any(value is _NONE for value in later)


def _bits(b: Item, number: Any) -> Any:
    return lambda self: number((int(self) & mask(b)) >> b["first"])


def _columns(elements: list[str]) -> int:
    """Returns the number of columns of a matrix; 0 for other vectors."""
    count = round(len(elements) ** 0.5)
    places = [f"m{row}{column}" for row in range(1, count + 1) for column in range(1, count + 1)]
    return count if count > 1 and places == elements else 0
