"""The description of a parameter: one value of a field or of a structure."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, overload

if TYPE_CHECKING:
    from .described import Described


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
    flags: tuple[Flag, ...] = ()  # the same as objects; empty if they depend on the device
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
    flags_on: dict[str, tuple[Flag, ...]] = field(default_factory=dict)  # by the device's id
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
        """The allowed values: "0 to 8", "greater than 0, at most 10"; empty if all are allowed."""
        low, high = self.minimum, self.maximum
        if low is not None and high is not None:
            return f"{low} to {high}"
        least = (("at least", low), ("greater than", self.above))
        most = (("at most", high), ("less than", self.below))
        return ", ".join(f"{word} {x}" for word, x in (*least, *most) if x is not None)

    @property
    def layout(self) -> str:
        """Its type on the wire: "u16", "float[3]", "u8[num_points]", or a structure's class."""
        one = "union" if self.tag else self.scalar or self.type.__name__
        if self.scalar == "bits":
            one = f"u8[{self.size}]"
        counts = [self.length] if self.length is not None else []
        counts += [len(self.elements)] if self.elements else []
        return one + "".join(f"[{count}]" for count in counts)

    @property
    def text(self) -> str:
        """Its documentation; a union's includes that of its cases."""
        from . import prose

        name = self.name if self.derived else self.attribute
        return prose.text(self.owner, name) if self.owner else ""

    def on(self, device: str) -> Parameter:
        """Returns the parameter as it is on a device, by id or name. Raises UnknownName."""
        from .lookup import device_id

        key = device_id(device)
        changes = self._changes("device", key)
        if key in self.flags_on:
            changes["flags"] = self.flags_on[key]
        return replace(self, **changes) if changes else self

    def of(self, holder: Described, device: str | None = None) -> Parameter:
        """Returns the parameter as it is in an object with other values, and on a device."""
        here = self if device is None else self.on(device)
        for by in {v.by: None for v in self.variants if v.by != "device"}:
            changes = self._changes(by, getattr(holder, by))
            here = replace(here, **changes) if changes else here
        return here

    def _changes(self, by: str, key: object) -> dict[str, Any]:
        changes: dict[str, Any] = {}
        for v in self._that_hold(by, key):
            changes |= {} if v.member else v.changes
        return changes

    def inside(self, holder: Described, device: str | None = None) -> dict[str, dict[str, Any]]:
        """Returns how a structure's members differ in an object and on a device, by attribute."""
        members: dict[str, dict[str, Any]] = {}
        for by in {v.by: None for v in self.variants if v.member}:
            for v in self._that_hold(by, device if by == "device" else getattr(holder, by)):
                members[v.member] = members.get(v.member, {}) | v.changes if v.member else {}
        return members

    def _that_hold(self, by: str, key: object) -> Iterator[Variant]:
        return (v for v in self.variants if v.by == by and key in v.keys)

    def format(self, value: Any) -> str:
        """Formats a value with units and names: "(x=0.1, y=0.2, z=-1.0) g", "lat_lon|height"."""
        from .text import formatted

        return formatted(self, value)
