"""Fills the modules of `_meaning`: facts about types and fields at run time."""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from typing import Any

from .document import Document, Item
from .records import mask

#: Attributes that have the same name in a parameter and in its variants.
_PLAIN = ("minimum", "maximum", "above", "below", "deprecated", "optional", "fields_of", "frame")


def of_module(document: Document, module: Any) -> None:
    """Fills a module of `_meaning`."""
    home, meaning = module.__name__.rpartition(".")[2], Meaning(document)
    known = {}
    for t in document.content["types"]:
        if t["kind"] != "vector" and document.symbol(t["name"])[0] == home:
            known[document.symbol(t["name"])[1]] = meaning.type(t)
    for f in document.content["fields"]:
        if document.symbol(f["name"])[0] == home:
            known[document.symbol(f["name"])[1]] = meaning.field(f)
    module.TYPES = known


class Meaning:
    def __init__(self, document: Document) -> None:
        self.document = document
        self.info = import_module(f"{document.package}.info")
        self.parameters = import_module(f"{document.package}.parameter")

    def type(self, t: Item) -> Any:
        name, kind = t["name"], self.document.get(t["name"])
        if t["kind"] == "struct":
            return self.info.StructureInfo(name, kind, self.all(t))
        items = t["values"] if t["kind"] == "enum" else t["bits"]
        constants = {x["name"]: self.document.constant(x["name"]) for x in items}
        spelled = {called: x for x, called in constants.items() if called.lower() != x}
        if t["kind"] == "enum":
            deprecated = tuple(v["name"] for v in items if v.get("deprecated"))
            return self.info.EnumInfo(name, kind, deprecated=deprecated, spelled=spelled)
        return self.info.BitsInfo(
            name,
            kind,
            spelled=spelled,
            aliases=tuple(b["name"] for b in items if b.get("alias")),
            concerns={b["name"]: tuple(b["concerns"]) for b in items if b.get("concerns")},
            numbers={b["name"]: self.document.get(b["enum"]) for b in items if b.get("enum")},
        )

    def field(self, f: Item) -> Any:
        certain, probable = self.document.devices_of(f)
        return self.info.FieldInfo(
            f["name"],
            self.document.get(f["name"]),
            functions=tuple(self.document.member(c["function"]) for c in f.get("calls", ())),
            devices=certain,
            perhaps=probable,
            deprecated=bool(f.get("deprecated")),
            advanced=f.get("advanced", False),
            max_rate=f.get("max_rate"),
            parameters=self.all(f),
        )

    def all(self, record: Item) -> tuple[Any, ...]:
        return tuple(self.parameter(p, record) for p in record["parameters"])

    # ----------------------------------------------------------------- parameters

    def parameter(self, p: Item, record: Item) -> Any:
        t = self.document.types.get(p.get("type", ""), {})
        kind = _kind(p, t)
        scalar = "bits" if kind == "bits" else t.get("scalar", "") if t else p.get("type", "")
        valid = tuple(p.get("valid", ()))
        values: dict[str, Any] = {
            "scalar": scalar,
            "size": t["size"] if kind == "bits" else 0,
            "elements": tuple(t.get("elements", ())),
            "length": p.get("length"),
            "constant": p.get("constant"),
            "counts": self.document.member(p["counts"]) if "counts" in p else "",
            "type": self.document.get(t["name"]) if t and t["kind"] != "vector" else None,
            "tag": self.document.member(p["tag"]) if "tag" in p else "",
            "units": tuple(p.get("units", ())),
            "valid": valid,
            "flags": self.flags(valid, record),
            "default": p.get("reserved") if "default" not in p else self.numbers(p["default"], t),
            "required": tuple(self.document.member(name) for name in p.get("required_for", ())),
            "reserved": "reserved" in p,
            "refers": p["shown"] if p.get("shown") in ("set", "field") else "",
            "variants": self.variants(p, record),
            "flags_on": self.flags_on(p, record),
            **{name: p[name] for name in _PLAIN if name in p},
        }
        if "magnitude" in p:
            values["magnitude"] = tuple(p["magnitude"])
        if "cases" in p:
            tag = self.document.types[next(q for q in record["parameters"] if q["name"] == p["tag"])["type"]]
            numbers = {v["name"]: v["value"] for v in tag["values"]}
            values["cases"] = {
                numbers[c["tag"]]: self.parameter(c["parameter"], record) if "parameter" in c else None
                for c in p["cases"]
            }
        return self.parameters.Parameter(p["name"], self.document.member(p["name"]), kind, **values)

    def numbers(self, value: Any, t: Item) -> Any:
        """Converts a default: named values and bits to numbers, lists to tuples."""
        if t.get("kind") == "enum" and isinstance(value, str):
            return next((v["value"] for v in t["values"] if v["name"] == value), 0)
        if t.get("kind") == "bitfield" and isinstance(value, list) and all(isinstance(x, str) for x in value):
            return sum({b["name"]: mask(b) for b in t["bits"]}.get(x, 0) for x in value)
        return tuple(self.numbers(x, t) for x in value) if isinstance(value, list) else value

    def variants(self, p: Item, record: Item) -> tuple[Any, ...]:
        """Makes the variants of a parameter, by device or by another parameter; devices that agree share one."""
        groups: list[list[Item]] = []
        for v in p.get("variants", ()):
            same = next((g for g in groups if v["by"] == "device" and {**g[0], "key": v["key"]} == v), None)
            if same is None:
                groups.append([v])
            else:
                same.append(v)
        return tuple(self.variant(g, p, record) for g in groups)

    def variant(self, group: list[Item], p: Item, record: Item) -> Any:
        v, by_device = group[0], group[0]["by"] == "device"
        if "member" in v:
            inner = self.document.types[p["type"]]["parameters"]
            p = next(q for q in inner if q["name"] == v["member"])
        named = self.document.types.get(str(v.get("type") or p.get("type")), {})
        changes: dict[str, Any] = {
            name: v[name] for name in ("frame", "minimum", "maximum", "constant", "deprecated") if name in v
        }
        changes |= {name: tuple(v[name]) for name in ("elements", "units", "only") if v.get(name)}
        if "default" in v:
            changes["default"] = self.numbers(v["default"], named)
        if "valid" in v:
            changes["valid"] = tuple(v["valid"])
        if "type" in v:
            changes["type"] = self.document.get(v["type"])
        elif v.get("unknown"):
            changes["type"] = None
        if "valid" in v and not by_device:
            changes["flags"] = self.flags(v["valid"], record)
        keys = tuple(x["key"] for x in group) if by_device else (v["value"],)
        by = "device" if by_device else self.document.member(v["by"])
        member = self.document.member(v["member"]) if "member" in v else ""
        return self.parameters.Variant(by, keys, changes, member)

    # ----------------------------------------------------------------- valid flags

    def flags(self, paths: Iterable[str], record: Item, device: str | None = None) -> tuple[Any, ...]:
        """Returns the flags that mark a value as valid; none if the bit depends on the device, which is unknown."""
        found = []
        for path in paths:
            name, _, bit = path.partition(".")
            holder = next(q for q in record["parameters"] if q["name"] == name)
            number = self.mask(holder, bit, device) if bit else 0
            if number is None:
                return ()
            found.append(self.parameters.Flag(path, self.document.member(name), number))
        return tuple(found)

    def mask(self, holder: Item, bit: str, device: str | None) -> int | None:
        """Returns the mask of a bit on the device; None if it depends on the device, which is unknown."""
        readings = _readings(holder)
        own = next((v["type"] for v in readings if v["by"] == "device" and v["key"] == device), None)
        types = [own or holder.get("type", "")]
        if own is None and not self.masks(types, bit):
            types = [v["type"] for v in readings]
        masks = set(self.masks(types, bit))
        return masks.pop() if len(masks) == 1 else None

    def masks(self, names: Iterable[str], bit: str) -> list[int]:
        known = [self.document.types.get(name, {}) for name in names]
        return [mask(b) for t in known if t.get("kind") == "bitfield" for b in t["bits"] if b["name"] == bit]

    def flags_on(self, p: Item, record: Item) -> dict[str, tuple[Any, ...]]:
        """Device -> flags, for devices on which a parameter has another valid flag, or the flag is another bit."""
        valid: list[str] = p.get("valid", [])
        own: dict[str, Any] = {
            v["key"]: v["valid"]
            for v in p.get("variants", ())
            if v["by"] == "device" and "valid" in v and "member" not in v
        }
        holders = {path.partition(".")[0] for paths in (valid, *own.values()) for path in paths}
        readings = [
            v for q in record["parameters"] if q["name"] in holders for v in _readings(q) if v["by"] == "device"
        ]
        usual = self.flags(valid, record)
        by_device = {
            d: self.flags(own.get(d, valid), record, d) for d in dict.fromkeys((*own, *(v["key"] for v in readings)))
        }
        return {d: found for d, found in by_device.items() if found != usual}


def _readings(p: Item) -> list[Item]:
    """Returns the variants that define other values or bits."""
    return [v for v in p.get("variants", ()) if "type" in v and "member" not in v]


def _kind(p: Item, t: Item) -> str:
    if "constant" in p:
        return "constant"
    if "counts" in p:
        return "counter"
    if "tag" in p:
        return "switch"
    if "length" in p:
        return "text" if p["type"] == "char" else "array"
    if t.get("kind") == "bitfield" and "scalar" not in t:
        return "bits"
    return {"struct": "struct", "vector": "array"}.get(t.get("kind", ""), "scalar")
