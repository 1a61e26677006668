"""Checks whether a device accepts the values of a command: ranges, named values, instances."""

from __future__ import annotations

import math
from enum import IntEnum
from typing import Any

from ..binding import Command, Device, Parameter, Structure, lookup, reflection, single_from_bits, single_to_bits
from .codes import INVALID_PARAMETER, READ, SETS, Refused
from .facts import AFFECTED, COMMANDS, DATA_SETS, PORTS, Behavior, Difference, difference_on
from .profiles import data_sets

NOTHING = Behavior()
SAME = Difference()


def check_value(command: Command, profile: Device, keys: tuple[str, ...]) -> None:
    """Raises Refused if the device rejects a value.

    `keys` select an instance of a setting. Values that the function does not require may be placeholders.
    """
    function = getattr(command, "function", None) if command.REQUIRED else None
    required = 0 if function is None else command.REQUIRED.get(function, 0)
    for number, p in enumerate(reflection.info(type(command)).parameters):
        value = _value(p, command)
        if value is None or (command.REQUIRED and p.name == "function"):
            continue
        if value == COMMANDS.get(command.NAME, NOTHING).all.get(p.attribute):
            if not meaning_all(command, p.attribute, value, function):
                raise Refused(INVALID_PARAMETER)
            continue
        if function is None or function in SETS or p.attribute in keys or number <= required:
            reading = profile.readings.get(f"{command.NAME}.{p.name}")
            _parameter(p, value, command, difference_on(p, profile.id), reading, profile)
    _instances(command, profile, function)


def _value(p: Parameter, record: Structure) -> Any:
    """Returns the value of a parameter; None if it has none, or is a constant."""
    if p.counts:
        counted = getattr(record, p.counts)
        return None if counted is None else len(counted)
    return None if p.kind == "constant" else getattr(record, p.attribute)


def meaning_all(command: Command, name: str, value: Any, function: int | None) -> bool:
    """Does the value select all instances, and does this function permit that?"""
    behavior = COMMANDS.get(command.NAME, NOTHING)
    everything = behavior.all.get(name)
    without = (None, READ) if behavior.writes_all else (None, READ, *SETS)
    return everything is not None and value == everything and function not in without


def affected_fields(command: Command, name: str, profile: Device) -> list[dict[str, int]]:
    """Returns the instances that a command with the instances AFFECTED selects: a field, all of a set, or all.

    Each is a value of the parameter `name`, and of the one beside it for the set, if there is one.
    """
    behavior, p = COMMANDS.get(command.NAME, NOTHING), reflection.info(type(command))[name]
    number, value = set_of(p, command), getattr(command, name)
    everything, all_sets = behavior.all.get(name), behavior.all.get(p.fields_of)
    return [
        {name: descriptor, **({p.fields_of: set_number} if hasattr(command, p.fields_of) else {})}
        for set_number, descriptor in sorted(behavior.affected & profile.fields)
        if (number == set_number and value in (descriptor, everything)) or (value == everything and number == all_sets)
    ]


def set_of(p: Parameter, record: Any) -> int | None:
    """Returns the set of a field descriptor: the value of another parameter, or a fixed set; None if it is unknown."""
    if not p.fields_of:
        return None
    beside = getattr(record, p.fields_of, None)
    return lookup.set_number(p.fields_of) if beside is None else int(beside)


def _instances(command: Command, profile: Device, function: int | None) -> None:
    behavior = COMMANDS.get(command.NAME, NOTHING)
    for name, what in behavior.instances.items():
        value: Any = getattr(command, name)
        if value is None or (what != AFFECTED and meaning_all(command, name, value, function)):
            continue
        value = behavior.translate.get(name, {}).get(value, value)
        if what == DATA_SETS:
            exists = value in data_sets(profile) or not data_sets(profile)  # a profile may not list them
        elif what == PORTS:
            exists = any(port.id == value for port in profile.ports) or not profile.ports
        elif what == AFFECTED:
            exists = bool(affected_fields(command, name, profile))
        else:
            limit = profile.limits.get(what)
            exists = limit is None or 1 <= value <= limit.value
        if not exists:
            raise Refused(INVALID_PARAMETER)


def _parameter(p: Parameter, value: Any, record: Structure, differs: Difference, reading: Any, profile: Device) -> None:
    if p.kind == "array" and not p.elements:
        for item in value:
            _element(p, item, record, differs, reading, profile)
    elif p.kind == "switch":
        case = p.cases.get(getattr(record, p.tag))
        if case is not None:
            _parameter(case, value, record, SAME, None, profile)
    else:
        _element(p, value, record, differs, reading, profile)


def _element(p: Parameter, value: Any, record: Structure, differs: Difference, reading: Any, profile: Device) -> None:
    if isinstance(value, Structure):
        for member in reflection.info(type(value)).parameters:
            member_value = _value(member, value)
            if member_value is not None:
                _parameter(member, member_value, value, SAME, None, profile)
        return
    if isinstance(value, tuple):
        least, most = p.magnitude
        if not (least or 0) <= math.hypot(*value) <= (math.inf if most is None else most) and (least, most) != (
            None,
            None,
        ):
            raise Refused(INVALID_PARAMETER)
    elif not _named(p, value, record, differs, reading):
        raise Refused(INVALID_PARAMETER)
    for number in value if isinstance(value, tuple) else (value,):
        if isinstance(number, (int, float)) and not in_limits(p, number, differs):
            raise Refused(INVALID_PARAMETER)


def _named(p: Parameter, value: Any, record: Structure, differs: Difference, reading: Any) -> bool:
    """Is the value defined, if the parameter is an enumeration, or a bitfield of which the device has some bits?"""
    if differs.values is not None:
        return value in differs.values
    if differs.bits is not None:
        return not value & ~differs.bits
    kind = p.type or p.of(record).type or reading
    if not (isinstance(kind, type) and issubclass(kind, IntEnum)):
        return True
    return any(value == member for member in kind)


def in_limits(p: Parameter, value: float, differs: Difference) -> bool:
    """Is the value within the limits of a parameter?"""
    least = p.minimum if differs.minimum is None else differs.minimum
    most = p.maximum if differs.maximum is None else differs.maximum
    if p.scalar == "float":  # limits are rounded as the parameter's values are: pi is rounded up
        least, most = (None if x is None else single_from_bits(single_to_bits(float(x))) for x in (least, most))
    return (
        math.isfinite(value)
        and (least is None or value >= least)
        and (most is None or value <= most)
        and (p.above is None or value > p.above)
        and (p.below is None or value < p.below)
        and (differs.constant is None or value == differs.constant)
    )
