"""Carries out the commands of a packet, one after another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from mip_tools.binding import (
    MAX_PAYLOAD,
    Acknowledge,
    Command,
    DecodeError,
    EncodeError,
    Packet,
    PacketError,
    RawField,
    chosen,
    registry,
    types,
)
from mip_tools.devices.checks import NOTHING, affected_fields, check_value, meaning_all
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
from mip_tools.devices.facts import AFFECTED, COMMANDS, FUNCTIONS
from mip_tools.devices.settings import Place, asking, instance_keys, is_setting, storage_place

from ..link import Link
from ..state import DeviceState
from ..streams.formats import LONGEST_SETTING
from .answers import compose_response
from .effects import DONE, Outcome, act
from .knowledge import configured

Group = Sequence[RawField]  # an acknowledge field, and a response if there is one

#: Commands that a device still accepts in a direct mode, in which the host communicates with an internal sensor.
ALWAYS = ("communication_mode", "device_status")


def carry_out(device: DeviceState, link: Link, packet: Packet) -> Iterator[tuple[RawField, Group, Outcome]]:
    """Carries out the commands of a packet. Yields each command, its answer, which may be empty, and its outcome."""
    try:
        for raw in packet:
            command = None
            try:
                command = _command(device, raw)
                if command is None:
                    continue
                group, outcome = _done(device, link, command)
            except Refused as refusal:
                group, outcome = [_acknowledge(raw.set, raw.descriptor, _defined_code(device, refusal.code))], DONE
            yield raw, () if command is not None and _is_silent(device, command) else group, outcome
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
        command = kind.decode(raw.data)
    except DecodeError:
        raise Refused(INVALID_PARAMETER) from None
    function = _function(command)
    if function is not None:
        letters = device.profile.functions.get((kind.SET, kind.DESCRIPTOR))
        if function not in kind.REQUIRED or (letters is not None and function not in {FUNCTIONS[x] for x in letters}):
            raise Refused(INVALID_PARAMETER)
    return command


def _function(command: Command) -> int | None:
    return getattr(command, "function", None) if command.REQUIRED else None


def _done(device: DeviceState, link: Link, command: Command) -> tuple[Group, Outcome]:
    kind, function = type(command), _function(command)
    check_value(command, device.profile, instance_keys(kind))
    if is_setting(kind) and function in (SAVE, LOAD, DEFAULT):
        outcome = _kept(device, command, function)
    else:
        writes, outcome = is_setting(kind) and function in SETS, DONE
        if writes and len(command.encode()) > LONGEST_SETTING:
            raise Refused(INVALID_PARAMETER)
        for each in _instances(device, command, function):
            outcome = act(device, each, link, function)
            if writes and outcome.stored:
                device.settings.write(_written(each))
    return _answer(device, command), outcome


def _answer(device: DeviceState, command: Command) -> Group:
    """Composes the ACK and the response. Raises Refused if they do not fit into a packet."""
    answer = [_acknowledge(command.SET, command.DESCRIPTOR, OK)]
    try:
        made = compose_response(device, command)
        if made is not None:
            answer.append(RawField(command.SET, made.DESCRIPTOR, made.encode()))
    except EncodeError:
        raise Refused(INVALID_PARAMETER) from None
    if sum(len(field.data) + 2 for field in answer) > MAX_PAYLOAD:
        raise Refused(INVALID_PARAMETER)
    return answer


def _instances(device: DeviceState, command: Command, function: int | None) -> list[Command]:
    """Returns the command for each instance of its setting, if it writes all fields, or all triggers."""
    name, what = next(iter(COMMANDS.get(command.NAME, NOTHING).instances.items()), ("", ""))
    if function not in SETS or not name or not meaning_all(command, name, getattr(command, name), function):
        return [command]
    if what == AFFECTED:
        return [replace(command, **keys) for keys in affected_fields(command, name, device.profile)]
    return [replace(command, **{name: instance}) for instance in configured(device, "trigger")]


def _written(command: Command) -> Command:
    """Converts a command to the form in which it is stored: a write."""
    kind: Any = type(command)
    function = next(f for f in SETS if f in kind.REQUIRED)
    kept: Command = kind.decode(bytes((function,)) + command.encode()[1:])
    return kept


def _kept(device: DeviceState, command: Command, function: int) -> Outcome:
    """Saves, loads or resets a setting: one instance, or all."""
    places = _places(device, command, function)
    if function == SAVE:
        device.settings.save(places)
        return DONE
    for changed in places:
        device.restore(changed, saved=function == LOAD)
    return DONE


def _places(device: DeviceState, command: Command, function: int) -> list[Place]:
    """Returns the instances of the setting that a command selects."""
    name, key = storage_place(command)
    names = instance_keys(type(command))
    every = [meaning_all(command, x, getattr(command, x), function) for x in names]
    if not any(every):
        return [(name, key)]
    places = device.settings.places(name)
    return [at for at in places if all(e or a == b for e, a, b in zip(every, at[1], key))]


def _is_silent(device: DeviceState, command: Command) -> bool:
    """Does the command, or a setting, suppress its acknowledge?"""
    if not command.answered:
        return True
    for set_number, descriptor, attribute, value in command.SILENCED_BY:
        kind: Any = types(set_number, descriptor)[0]
        if getattr(device.settings.current(asking(kind.NAME, [0] * len(instance_keys(kind)))), attribute) == value:
            return True
    return False
