"""Composes the responses to commands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from mip_tools.binding import Command, Parameter, Response, Structure, reflection
from mip_tools.devices.checks import NOTHING
from mip_tools.devices.facts import COMMANDS, VALUES, FieldValues, Value
from mip_tools.devices.names import value_named
from mip_tools.devices.settings import arguments, filled, is_setting

from ..state import DeviceState
from ..world.quantities import quantity
from . import knowledge

EMPTY = FieldValues()


def compose_response(device: DeviceState, command: Command) -> Response | None:
    """Composes the response to a command that was carried out; None if it requests none."""
    kind = _layout(device, command)
    if kind is None:
        return None
    kept = device.settings.current(command) if is_setting(type(command)) else command
    stored = {p.name: getattr(kept, p.attribute, None) for p in reflection.info(type(kept)).parameters}
    source = VALUES.get(kind.NAME, EMPTY)
    context = {**stored, **arguments(command)}
    values: dict[str, Any] = {}
    for p in reflection.info(kind).parameters:
        if p.kind not in ("constant", "counter"):
            values[p.attribute] = _value(device, p, p.name, source, context, stored, values)
    made: Response = kind(**values)
    return made


def _layout(device: DeviceState, command: Command) -> Any:
    """Chooses the layout for this device if there are several, else the first that is not limited to some devices."""
    layouts = command.expected
    of = COMMANDS.get(command.NAME, NOTHING).answers
    own = [kind for kind in layouts if device.profile.id in of.get(kind.NAME.partition(".")[2], ())]
    others = [kind for kind in layouts if kind.NAME.partition(".")[2] not in of]
    return next(iter([*own, *others, *layouts]), None)


def _value(
    device: DeviceState,
    p: Parameter,
    path: str,
    source: FieldValues,
    context: dict[str, Any],
    stored: dict[str, Any],
    beside: dict[str, Any],
) -> Any:
    value = source.parameters.get(path)
    if value is not None:
        return stored[value.parameter] if value.parameter else _shown(device, p, value, context)
    if any(name.startswith(f"{path}.") for name in source.parameters):
        members: dict[str, Any] = {}
        for member in reflection.info(p.type).parameters:
            if member.kind not in ("constant", "counter"):
                members[member.attribute] = _value(
                    device, member, f"{path}.{member.name}", source, context, stored, members
                )
        return p.type(**members)
    if stored.get(path) is not None:
        return stored[path]
    return filled(p, beside, p.default)


def _shown(device: DeviceState, p: Parameter, value: Value, context: dict[str, Any]) -> Any:
    if value.text is not None:
        return value.text.ljust(p.length) if isinstance(p.length, int) else value.text
    if value.number is not None:
        return value.number
    if value.names or value.bits:
        return value_named(p.type, value.names or value.bits)
    shown = _quantity(device, value.quantity, context)
    if p.type is not None and isinstance(p.type, type) and issubclass(p.type, Structure):
        return tuple(p.type(*item) for item in shown)
    if isinstance(shown, Sequence) or p.kind == "text":
        return shown
    scaled = shown * value.factor
    return float(scaled) if p.scalar in ("float", "double") else bool(scaled) if p.scalar == "bool" else int(scaled)


def _quantity(device: DeviceState, name: str, context: dict[str, Any]) -> Any:
    """Returns a value of the device itself, else of the world around it."""
    own = knowledge.QUANTITIES.get(name)
    return quantity(device.world, name, context) if own is None else own(device, context)
