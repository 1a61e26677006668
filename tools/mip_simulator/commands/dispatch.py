"""Carries out the commands of a packet, one after another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from mip_tools.binding import Acknowledge, Command, DecodeError, Packet, PacketError, RawField, chosen, registry, types
from mip_tools.devices.checks import NOTHING, check_value, meaning_all
from mip_tools.devices.codes import (
    DEFAULT,
    INVALID_PARAMETER,
    LOAD,
    OK,
    SAVE,
    SETS,
    UNKNOWN_COMMAND,
    UNKNOWN_SET,
    Refused,
)
from mip_tools.devices.facts import COMMANDS, FUNCTIONS
from mip_tools.devices.settings import asking, instance_keys, is_setting, storage_place

from ..link import Link
from ..state import DeviceState
from .answers import compose_response
from .effects import DONE, Outcome, act

Group = Sequence[RawField]  # an acknowledge field, and a response if there is one

#: Commands that a device still accepts in a direct mode, in which the host communicates with an internal sensor.
ALWAYS = ("communication_mode", "device_status")


def carry_out(device: DeviceState, link: Link, packet: Packet) -> Iterator[tuple[RawField, Group, Outcome]]:
    """Carries out the commands of a packet. Yields each command, its answer, which may be empty, and its outcome."""
    try:
        for raw in packet:
            try:
                command = _command(device, raw)
                if command is None:
                    continue
                group, outcome = _done(device, link, command)
                yield raw, group, outcome
            except Refused as refusal:
                code = _defined_code(device, refusal.code)
                yield raw, [_acknowledge(raw.set, raw.descriptor, code)], DONE
    except PacketError:  # no field can be found after a malformed one
        return


def _defined_code(device: DeviceState, code: int) -> int:
    """Returns the code, or, if the device has no code for unknown sets, the one for an unknown command."""
    codes = device.profile.ack_codes
    return UNKNOWN_COMMAND if code == UNKNOWN_SET and codes and code not in codes else code


def _acknowledge(set_number: int, descriptor: int, code: int) -> RawField:
    return RawField(set_number, Acknowledge.DESCRIPTOR, bytes((descriptor, code)))


def _command(device: DeviceState, raw: RawField) -> Command | None:
    """Decodes the command in a field; None if the device does not answer it. Raises Refused."""
    if raw.descriptor == Acknowledge.DESCRIPTOR or raw.descriptor >= 0x80:
        return None  # an answer, not a command
    if all(set_number != raw.set for set_number, _ in device.field_keys):
        raise Refused(UNKNOWN_SET)
    if (raw.set, raw.descriptor) not in device.field_keys:
        raise Refused(UNKNOWN_COMMAND)
    kind = chosen(registry.types(raw.set, raw.descriptor), raw)
    if kind is None or not issubclass(kind, Command):
        raise Refused(UNKNOWN_COMMAND)
    if device.direct and COMMANDS.get(kind.NAME, NOTHING).effect not in ALWAYS:
        return None
    try:
        return kind.decode(raw.data)
    except DecodeError:
        raise Refused(INVALID_PARAMETER) from None


def _done(device: DeviceState, link: Link, command: Command) -> tuple[Group, Outcome]:
    kind = type(command)
    function = getattr(command, "function", None) if kind.REQUIRED else None
    if function is not None:
        letters = device.profile.functions.get((kind.SET, kind.DESCRIPTOR))
        if function not in kind.REQUIRED or (letters is not None and function not in {FUNCTIONS[x] for x in letters}):
            raise Refused(INVALID_PARAMETER)
    check_value(command, device.profile, instance_keys(kind))
    if is_setting(kind) and function in (SAVE, LOAD, DEFAULT):
        outcome = _kept(device, command, function)
    else:
        outcome = act(device, command, link, function)
        if is_setting(kind) and function in SETS:
            device.settings.write(_written(command))
    if not command.answered or _silenced(device, command):
        return (), outcome
    answer = [_acknowledge(kind.SET, kind.DESCRIPTOR, OK)]
    made = compose_response(device, command)
    if made is not None:
        answer.append(RawField(kind.SET, made.DESCRIPTOR, made.encode()))
    return answer, outcome


def _written(command: Command) -> Command:
    """Converts a command to the form in which it is stored: a write."""
    kind: Any = type(command)
    function = next(f for f in SETS if f in kind.REQUIRED)
    kept: Command = kind.decode(bytes((function,)) + command.encode()[1:])
    return kept


def _kept(device: DeviceState, command: Command, function: int) -> Outcome:
    """Saves, loads or resets a setting: one instance, or all."""
    at = storage_place(command)
    names = instance_keys(type(command))
    everything = any(meaning_all(command, name, getattr(command, name), function) for name in names)
    places = device.settings.places(at[0]) if everything else [at]
    if function == SAVE:
        device.settings.save(places)
        return DONE
    for changed in places:
        device.restore(changed, saved=function == LOAD)
    return DONE


def _silenced(device: DeviceState, command: Command) -> bool:
    """Does a setting suppress the acknowledge of this command?"""
    for set_number, descriptor, attribute, value in command.SILENCED_BY:
        kind: Any = types(set_number, descriptor)[0]
        if getattr(device.settings.current(asking(kind.NAME, [0] * len(instance_keys(kind)))), attribute) == value:
            return True
    return False
