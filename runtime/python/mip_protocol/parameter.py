"""The description of a parameter: one value of a field or of a structure."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from enum import IntEnum, IntFlag
from math import pi
from typing import Any, NamedTuple, overload

from . import prose
from .codec import with_article
from .described import Described
from .exceptions import EncodeError
from .text import bits_of, listed, json_value, number, several, with_unit, word

#: The differences for the members of a structure, by attribute.
Inside = dict[str, dict[str, Any]]


@dataclass(frozen=True)
class Flag:
    """A bit, or a bool, that shows whether a value is valid."""

    name: str  # its name in the specification: "valid_flags.tow"
    attribute: str  # the attribute of the same field or structure that contains it
    mask: int  # 0: that attribute is a bool

    @overload
    def holds(self, flags: int) -> bool: ...
    @overload
    def holds(self, flags: Any) -> Any: ...
    def holds(self, flags: Any) -> Any:
        """Is the bit set in a value of its attribute? For a NumPy array, the result is an array."""
        return (flags & self.mask) == self.mask if self.mask else flags != 0


class Reading(NamedTuple):
    """Which flags show on some devices whether a value is valid."""

    devices: tuple[str, ...]  # ids; empty for all without a reading of their own
    flags: tuple[Flag, ...]
    fewer: int  # the bits that others have in addition; one that is set excludes this reading


@dataclass(frozen=True)
class Variant:
    """A difference of a parameter on some devices, or for some values of another parameter."""

    by: str  # "device", or the attribute with the other value
    keys: tuple[str | int, ...]  # ids of devices, or values of that attribute
    changes: dict[str, Any]  # attributes of `Parameter` -> their values in that case
    member: str = ""  # for a structure: the attribute that differs, if not the whole


@dataclass(frozen=True)
class Parameter:
    """One value on the wire. `name` is its name in the specification."""

    name: str
    attribute: str
    kind: str  # scalar, constant, counter, bits, text, array, struct or switch
    scalar: str = ""  # u8 … s64, float, double, bool, char; bits: a bitfield in `size` bytes
    size: int = 0
    elements: tuple[str, ...] = ()  # of a vector
    length: int | str | None = None  # a number, the counter's name, or "rest"
    constant: int | None = None
    counts: str = ""  # attribute of the array that a counter counts
    type: Any = None  # enumeration, bitfield or structure
    tag: str = ""  # attribute that selects a union's member
    cases: dict[int, Parameter | None] = field(default_factory=dict)
    units: tuple[str, ...] = ()  # one for all elements, or one for each
    frame: str = ""
    valid: tuple[str, ...] = ()  # valid flags, "flags.bit" or a bool: one, or one per element
    flags: tuple[Flag, ...] = ()  # the same as objects; usual ones if they depend on the device
    minimum: float | None = None
    maximum: float | None = None
    above: float | None = None  # the value must be greater than this
    below: float | None = None
    magnitude: tuple[float | None, float | None] = (None, None)  # range of a vector's length
    default: Any = None  # factory default, or the value to send if reserved; a number, not a name
    required: tuple[str, ...] = ()  # in a command: the functions that require it
    optional: bool = False  # it may be left out
    reserved: bool = False
    deprecated: bool = False
    refers: str = ""  # "set" or "field": it is the number of a set, or a field descriptor
    fields_of: str = ""  # the set of these descriptors: its name, or the parameter that selects it
    only: tuple[str, ...] = ()  # the values or bits that apply here, if not all of its type
    variants: tuple[Variant, ...] = ()
    readings: tuple[Reading, ...] = ()  # if the flags depend on the device; the usual one is last
    owner: Any = field(default=None, compare=False, repr=False)  # the class that documents it

    @property
    def derived(self) -> bool:
        """Is it a constant or a counter, which objects do not contain?"""
        return self.constant is not None or bool(self.counts)

    @property
    def unit(self) -> str:
        """The unit of all elements, or of each: "m/s", "deg, deg, m"; "1" for a plain number."""
        return ", ".join(self.units)

    @property
    def range(self) -> str:
        """The allowed values: "0 to 8", "-pi to pi", "greater than 0, at most 10"; empty if all are allowed."""
        low, high, above, below = (
            "pi" if x == pi else "-pi" if x == -pi else x for x in (self.minimum, self.maximum, self.above, self.below)
        )
        if low is not None and high is not None:
            return f"{low} to {high}"
        words = (("at least", low), ("greater than", above), ("at most", high), ("less than", below))
        return ", ".join(f"{word} {x}" for word, x in words if x is not None)

    @property
    def layout(self) -> str:
        """Its type on the wire: "u16", "float[3]", "u8[num_points]", or a structure's class."""
        form = "union" if self.tag else self.scalar or self.type.__name__
        if self.scalar == "bits":
            form = f"u8[{self.size}]"
        counts = [self.length] if self.length is not None else []
        counts += [len(self.elements)] if self.elements else []
        return form + "".join(f"[{count}]" for count in counts)

    @property
    def text(self) -> str:
        """Its documentation; a union's includes that of its cases."""
        name = self.name if self.derived else self.attribute
        return prose.text(self.owner, name) if self.owner else ""

    def on(self, device: str) -> Parameter:
        """Returns the parameter as it is on a device, by id or name. Raises UnknownName."""
        from .lookup import device_id

        key = device_id(device)
        changes = self._changes("device", key)
        if self.readings:
            changes["flags"] = self._reading(key).flags
        return replace(self, **changes) if changes else self

    def of(self, holder: Described, device: str | None = None) -> Parameter:
        """Returns the parameter as it is in an object with other values, and on a device."""
        if device is not None:
            here = self.on(device)
        else:
            here = self.recognized(getattr(holder, self.holders[0])) if self.readings else self
        for by in {v.by: None for v in self.variants if v.by != "device"}:
            changes = self._changes(by, getattr(holder, by))
            here = replace(here, **changes) if changes else here
        return here

    def flags_of(self, holder: Described, device: str | None = None) -> tuple[Flag, ...]:
        """Returns the flags that mark its value in an object as valid, on a device by its id."""
        if not self.readings:
            return self.flags
        if device is not None:
            return self._reading(device).flags
        return self._recognized(getattr(holder, self.holders[0])).flags

    def recognized(self, bits: int) -> Parameter:
        """Returns the parameter as it is on an unknown device that has sent these bits as flags.

        A reading with fewer bits than the usual one holds if it defines all of these. To read all
        values of a log in the same way, combine their flags with `|`.
        """
        flags = self._recognized(bits).flags
        return replace(self, flags=flags, valid=tuple(f.name for f in flags))

    @property
    def holders(self) -> tuple[str, ...]:
        """The attribute with the flags, if they depend on the device."""
        return tuple({f.attribute: None for r in self.readings for f in r.flags})

    def _recognized(self, bits: Any) -> Reading:
        usual = self.readings[-1]
        if not isinstance(bits, int):  # an object can have any value
            return usual
        return next((r for r in self.readings if r.fewer and not bits & r.fewer), usual)

    def _reading(self, device: str) -> Reading:
        return next((r for r in self.readings if device in r.devices), self.readings[-1])

    def _changes(self, by: str, key: object) -> dict[str, Any]:
        changes: dict[str, Any] = {}
        for v in self._that_hold(by, key):
            changes |= {} if v.member else v.changes
        return changes

    def inside(self, holder: Described, device: str | None = None) -> Inside:
        """Returns how a structure's members differ in an object and on a device, by attribute."""
        members: Inside = {}
        for by in {v.by: None for v in self.variants if v.member}:
            for v in self._that_hold(by, device if by == "device" else getattr(holder, by)):
                members[v.member] = members.get(v.member, {}) | v.changes if v.member else {}
        return members

    def _that_hold(self, by: str, key: object) -> Iterator[Variant]:
        return (v for v in self.variants if v.by == by and key in v.keys)

    def format(self, value: Any) -> str:
        """Formats a value with units and names: "(x=0.1, y=0.2, z=-1.0) g", "lat_lon|height"."""
        return to_text(self, value, None, None)


# ------------------------------------------------------- the values of a parameter
# `holder` is the object with the value. The values of a structure in it are converted by its INFO.


def meant(p: Parameter, value: Any) -> Any:
    """Converts a value to its parameter's enumeration or bitfield, an array item by item. Other
    values are returned unchanged.

    Raises EncodeError if the value is not a number.
    """
    kind = p.type
    if value is None or not isinstance(kind, type) or not issubclass(kind, (IntEnum, IntFlag)):
        return value
    needs = with_article(kind)
    try:
        if not several(value):
            return kind(value)
        if p.scalar == "u8" and issubclass(kind, IntFlag) and bits_of(kind)[1] > 0xFF:
            needs = "numbers from 0 to 255"
            return kind(int.from_bytes(bytes(value), "little"))  # an array of bytes holds it
        return tuple(map(kind, value))
    except (TypeError, ValueError):
        raise EncodeError("range", f"{p.attribute} is {value!r}, needs {needs}") from None


def named(p: Parameter, value: Any, holder: object = None) -> Any:
    """Converts a value of an enumeration, a bitfield or a Boolean as `to_dict` does for JSON."""
    return json_value(meant(p, value), True, True, holder)


def here(p: Parameter, holder: Described, device: str | None, inside: Inside | None) -> Parameter:
    """Returns a parameter as it is in an object with its other values."""
    if p.variants or p.readings:
        p = p.of(holder, device)
    return replace(p, **inside[p.attribute]) if inside and p.attribute in inside else p


def _case(p: Parameter, holder: Described) -> Parameter | None:
    """Returns the case of a union that is present."""
    tag = getattr(holder, p.tag)
    return p.cases.get(tag) if isinstance(tag, int) else None


def _is_structure(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, Described)


def to_json(
    p: Parameter, value: Any, holder: Described, names: bool, json: bool, device: str | None
) -> Any:
    """Converts a value to JSON's types: dicts, lists, numbers, text."""
    if p.tag:
        case = _case(p, holder)
        return to_json(case, value, holder, names, json, device) if case else number(value, json)
    value = meant(p, value) if names else value
    alone = p.length is None
    if _is_structure(p.type):
        inside = p.inside(holder, device) if p.variants else None
        alone = alone or not several(value)
        dicts = [
            x.INFO.to_dict(x, names, json, device, inside) if isinstance(x, Described) else x
            for x in ((value,) if alone else value)
        ]
        return dicts[0] if alone else dicts
    if p.elements and several(value):
        vectors = [_vector(p, x, names, json) for x in ((value,) if alone else value)]
        return vectors[0] if alone else vectors
    if several(value):
        return [json_value(x, names, json) for x in value]
    return json_value(value, names, json, holder)


def _vector(p: Parameter, value: Any, names: bool, json: bool) -> Any:
    numbers = [number(x, json) for x in value] if several(value) else []
    if names and len(numbers) == len(p.elements):
        return dict(zip(p.elements, numbers))
    return numbers


def to_text(p: Parameter, value: Any, holder: Described | None, device: str | None) -> str:
    """Formats a value with units and names."""
    if value is None:
        return "-"
    if p.tag:
        case = _case(p, holder) if holder is not None else None
        return to_text(case, value, holder, device) if case else str(value)
    value = meant(p, value)
    if _is_structure(p.type):
        inside = p.inside(holder, device) if p.variants and holder is not None else None
        if p.length is None or not several(value):
            return _structure(value, device, inside)
        return listed(_structure(x, device, inside) for x in value)
    single, many = p.scalar == "float", len(set(p.units)) > 1  # a unit for each element
    if not several(value):
        return with_unit(word(value, single, holder), p.units)
    if p.elements:
        vectors = (value,) if p.length is None else value
        texts = [_elements(p, x, many) for x in vectors]
        text = texts[0] if p.length is None else listed(texts)
    else:
        units = p.units if many else ("",) * len(value)
        text = listed(with_unit(word(x, single), (unit,)) for x, unit in zip(value, units))
    return text if many else with_unit(text, p.units)


def _structure(value: Any, device: str | None, inside: Inside | None) -> str:
    if not isinstance(value, Described):
        return repr(value)
    return f"({value.INFO.words(value, device, inside)})"


def _elements(p: Parameter, value: Any, many: bool) -> str:
    """Formats a vector, or a matrix without its elements' names, which would only add noise."""
    if not several(value):
        return repr(value)
    texts = [word(x, p.scalar == "float") for x in value]
    if len(texts) != len(p.elements) or len(texts) > 4:
        return f"({', '.join(texts)})"
    units = p.units if many else ("",) * len(texts)
    words = (f"{name}={with_unit(x, (unit,))}" for name, x, unit in zip(p.elements, texts, units))
    return f"({', '.join(words)})"
