"""Names for values that are the number of a descriptor set or a field descriptor."""

from __future__ import annotations

from functools import cache
from typing import Any

from ..binding import SETS, Described, EnumInfo, OpenEnum, Parameter, Structure, Variant, info, lookup, registry

#: How the members of a structure differ, by attribute.
Inside = dict[str, dict[str, Any]]


def references(value: Described, set_number: int) -> Inside:
    """Returns how the parameters of a field differ if descriptors and sets have names; the field is in packets of this
    set."""
    inside: Inside = {}
    for p in info(type(value)).members:
        own = _set_of(p, value, set_number)
        if p.refers:
            inside[p.attribute] = {"type": _type(p, own)}
        elif p.fields_of:
            members = info(p.type).members if issubclass(p.type, Structure) else ()
            named = [Variant("device", _EVERY, {"type": _type(m, own)}, m.attribute) for m in members if m.refers]
            inside[p.attribute] = {"variants": (*p.variants, *named)}
    return inside


class _Every(tuple[Any, ...]):
    """The keys of what holds on all devices, also on an unknown one."""

    def __contains__(self, key: object) -> bool:
        return True


_EVERY = _Every()


def _set_of(p: Parameter, value: Described, set_number: int) -> int:
    """Returns the set of the descriptors: that of another parameter, a fixed one, or that of the field itself."""
    if not p.fields_of:
        return set_number
    beside = getattr(value, p.fields_of, None)
    return lookup.set_number(p.fields_of) if beside is None else int(beside)


def _type(p: Parameter, set_number: int) -> Any:
    return _sets() if p.refers == "set" else _fields(set_number)


@cache
def _sets() -> Any:
    return _enumeration({names[0]: number for number, names in SETS.items()})


@cache
def _fields(set_number: int) -> Any:
    numbers: dict[str, int] = {}
    for number in range(1, 256):
        for kind in registry.types(set_number, number)[:1]:
            name = kind.name_in(set_number)
            own = name.partition(".")[2]
            numbers[name if own in numbers else own] = number  # shared.gps_timestamp beside sensor.gps_timestamp
    return _enumeration(numbers)


def _enumeration(numbers: dict[str, int]) -> Any:
    if not numbers:
        return None
    make: Any = OpenEnum  # mypy knows only its call for a value
    kind = make("Number", numbers)
    kind.INFO = EnumInfo("", kind)
    return kind
