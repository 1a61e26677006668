"""Facts about simulated devices, by full name of a field, from `simulation.json` of the package."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass, field
from enum import IntEnum
from functools import reduce
from operator import or_
from typing import Any

from ..binding import Field, Parameter, data, info


@dataclass(frozen=True)
class Value:
    """The source of a parameter's value: a quantity times `factor`, a constant, or a parameter of the command."""

    quantity: str = ""
    factor: float = 1.0
    names: tuple[str, ...] = ()  # names of values, of which the first that the enumeration has is used
    bits: tuple[str, ...] = ()
    number: float | None = None
    text: str | None = None
    parameter: str = ""  # in a response, the parameter of the command whose setting it reports


@dataclass(frozen=True)
class FieldValues:
    """The sources of a field's values. `parameters`: parameter, or parameter.member of a structure -> value."""

    for_each: str = ""  # a list quantity: the field is sent once for each item
    valid_if: str = ""  # a quantity that states whether the values are valid; if not, all of them are 0
    parameters: dict[str, Value] = field(default_factory=dict)


#: Kinds of instances that are not numbers up to a limit: ports, data sets, and the data that the command affects.
PORTS, DATA_SETS, AFFECTED = "ports", "data_sets", "affected"


@dataclass(frozen=True)
class Behavior:
    """The effects of a command besides storing a setting, and the way the setting is stored."""

    effect: str = ""
    arguments: dict[str, str | int] = field(default_factory=dict)  # parameter, parameter.member, or a number
    all: dict[str, int] = field(default_factory=dict)  # parameter -> the value that means all
    writes_all: bool = False  # a write may select all, too
    instances: dict[str, str] = field(default_factory=dict)  # parameter -> limit, or one of the words below
    translate: dict[str, dict[int, int]] = field(default_factory=dict)  # number -> number of a set
    setting: str = ""  # the command that owns the setting, if it is another one
    key: dict[str, int] = field(default_factory=dict)  # the instance of that setting
    initial: dict[str, Any] = field(default_factory=dict)  # values on a new device
    once: bool = False  # a write acts only at that moment; its own values are no setting
    affected: frozenset[tuple[int, int]] = frozenset()  # set and descriptor of the data that AFFECTED selects from
    answers: dict[str, tuple[str, ...]] = field(default_factory=dict)  # response -> devices with this layout


@dataclass(frozen=True)
class Difference:
    """The difference of a parameter on a device."""

    default: Any = None
    minimum: float | None = None
    maximum: float | None = None
    values: frozenset[int] | None = None  # the only values that the device has
    bits: int | None = None  # the only bits that the device has
    constant: int | None = None


def difference_on(p: Parameter, device: str) -> Difference:
    """Returns how a parameter differs on the device with this id."""
    changes: dict[str, Any] = {}
    for v in p.variants:
        if v.by == "device" and device in v.keys and not v.member:
            changes |= {k: x for k, x in v.changes.items() if k in ("default", "minimum", "maximum", "constant")}
            only, kind = v.changes.get("only", ()), v.changes.get("type", p.type)
            if only and issubclass(kind, IntEnum):
                changes["values"] = frozenset(x.value for x in info(kind).values if x.name in only)
            elif only:
                changes["bits"] = mask_of(kind, only)
    return Difference(**changes)


def mask_of(kind: Any, only: Container[str]) -> int:
    """Returns the mask of the bits with these names."""
    return reduce(or_, (b.mask for b in info(kind).bits if b.name in only), 0)


def _tuples(value: Any) -> Any:
    """Converts lists in a JSON value to tuples."""
    if isinstance(value, dict):
        return {k: _tuples(x) for k, x in value.items()}
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def _shown(row: dict[str, Any]) -> FieldValues:
    return FieldValues(
        row.get("for_each", ""),
        row.get("valid_if", ""),
        {path: Value(**x) for path, x in row.get("parameters", {}).items()},
    )


def _behavior(row: dict[str, Any]) -> Behavior:
    translate = {name: {int(k): x for k, x in pairs.items()} for name, pairs in row.pop("translate", {}).items()}
    affected = frozenset(row.pop("affected", ()))
    return Behavior(**row, translate=translate, affected=affected)


_KNOWN = _tuples(data("simulation.json"))

#: Letters of function selectors -> their numbers.
FUNCTIONS: dict[str, int] = _KNOWN["functions"]
#: Quantities -> the noise of the sensors that measure them: density, drift, period.
NOISE: dict[str, dict[str, float]] = _KNOWN["noise"]
#: Data fields and responses -> their values.
VALUES = {name: _shown(row) for name, row in _KNOWN["values"].items()}
#: Commands -> their effects besides storing a setting.
COMMANDS = {name: _behavior(row) for name, row in _KNOWN["commands"].items()}


_NOTHING = FieldValues()


def value_sources(kind: type[Field], set_number: int) -> FieldValues:
    """Returns the sources of a field's values in packets of a set: those for this set, else those for all sets."""
    return VALUES.get(kind.name_in(set_number)) or VALUES.get(kind.NAME) or _NOTHING
