"""The facts of the specification about simulated devices; `_facts` has the tables."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Value:
    """What a parameter shows: a quantity times `factor`, or a constant."""

    quantity: str = ""
    factor: float = 1.0
    names: tuple[str, ...] = ()  # of values: the first one that the enumeration has
    bits: tuple[str, ...] = ()
    number: float | None = None
    text: str | None = None


@dataclass(frozen=True)
class FieldValues:
    """What a field shows. `parameters`: parameter, or parameter.member of a structure -> value."""

    for_each: str = ""  # a quantity that is a list: the field is sent once for each item
    parameters: dict[str, Value] = field(default_factory=dict)


@dataclass(frozen=True)
class Behavior:
    """What a command does besides storing a setting, and how the setting is stored."""

    effect: str = ""
    arguments: dict[str, str | int] = field(
        default_factory=dict
    )  # a parameter, a member of one: parameter.member, or a number
    all: dict[str, int] = field(default_factory=dict)  # parameter -> the value that means all
    instances: dict[str, str] = field(
        default_factory=dict
    )  # parameter -> limit, "ports" or "data_sets"
    translate: dict[str, dict[int, int]] = field(default_factory=dict)  # number -> number of a set
    setting: str = ""  # the command whose setting it is, if not its own
    key: dict[str, int] = field(default_factory=dict)  # which instance of that setting
    initial: dict[str, Any] = field(default_factory=dict)  # values on a new device
    answers: dict[str, tuple[str, ...]] = field(
        default_factory=dict
    )  # response -> devices with this layout


@dataclass(frozen=True)
class Difference:
    """How a parameter differs on a device."""

    default: Any = None
    minimum: float | None = None
    maximum: float | None = None
    values: frozenset[int] | None = None  # the only ones that there are
    constant: int | None = None


__all__ = ["Behavior", "Difference", "FieldValues", "Value"]
