"""Facts of a specification about simulated devices, by full names of fields: `simulation.json` of its package."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

from ..binding import Field, Parameter, data, info


@dataclass(frozen=True)
class Value:
    """The value of a parameter: a quantity times `factor`, a constant, or a parameter of the command."""

    quantity: str = ""
    factor: float = 1.0
    names: tuple[str, ...] = ()  # of values: the first one that the enumeration has
    bits: tuple[str, ...] = ()
    number: float | None = None
    text: str | None = None
    parameter: str = ""  # of a response: the parameter of its command whose setting it shows


@dataclass(frozen=True)
class FieldValues:
    """The values of a field. `parameters`: parameter, or parameter.member of a structure -> value."""

    for_each: str = ""  # a quantity that is a list: the field is sent once for each item
    valid_if: str = ""  # a quantity that shows whether the values are valid; else all of them are 0
    parameters: dict[str, Value] = field(default_factory=dict)


#: Instances that are not numbers up to a limit: ports, data sets, and the data that the command affects.
PORTS, DATA_SETS, AFFECTED = "ports", "data_sets", "affected"


@dataclass(frozen=True)
class Behavior:
    """The effects of a command besides storing a setting, and the way the setting is stored."""

    effect: str = ""
    arguments: dict[str, str | int] = field(default_factory=dict)  # parameter, parameter.member, or a number
    all: dict[str, int] = field(default_factory=dict)  # parameter -> the value that means all
    instances: dict[str, str] = field(default_factory=dict)  # parameter -> limit, or one of the words below
    translate: dict[str, dict[int, int]] = field(default_factory=dict)  # number -> number of a set
    setting: str = ""  # the command whose setting it is, if not its own
    key: dict[str, int] = field(default_factory=dict)  # which instance of that setting
    initial: dict[str, Any] = field(default_factory=dict)  # values on a new device
    once: bool = False  # a write acts at that moment: what it wrote is not a setting to be restored
    affected: frozenset[tuple[int, int]] = frozenset()  # set and descriptor of the data that AFFECTED selects from
    answers: dict[str, tuple[str, ...]] = field(default_factory=dict)  # response -> devices with this layout


@dataclass(frozen=True)
class Difference:
    """The difference of a parameter on a device."""

    default: Any = None
    minimum: float | None = None
    maximum: float | None = None
    values: frozenset[int] | None = None  # the only ones that there are
    constant: int | None = None


def difference(p: Parameter, device: str) -> Difference:
    """The whole difference on a device (its id)."""
    changes: dict[str, Any] = {}
    for v in p.variants:
        if v.by == "device" and device in v.keys and not v.member:
            changes |= {k: x for k, x in v.changes.items() if k in ("default", "minimum", "maximum", "constant")}
            only, kind = v.changes.get("only", ()), v.changes.get("type", p.type)
            if only and issubclass(kind, IntEnum):
                changes["values"] = frozenset(x.value for x in info(kind).values if x.name in only)
    return Difference(**changes)


def _tuples(value: Any) -> Any:
    """A value of JSON with tuples in place of lists."""
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


def shown(kind: type[Field], set: int) -> FieldValues:
    """The values of a field in packets of a set: as stated for that set, else for all sets."""
    return VALUES.get(kind.name_in(set)) or VALUES.get(kind.NAME) or _NOTHING


__all__ = [
    "AFFECTED",
    "COMMANDS",
    "DATA_SETS",
    "FUNCTIONS",
    "NOISE",
    "PORTS",
    "VALUES",
    "Behavior",
    "Difference",
    "FieldValues",
    "Value",
    "difference",
    "shown",
]
