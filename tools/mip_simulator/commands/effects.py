"""Effects of commands besides storing a setting, by their names in `spec/simulation`.

The effect of a plain command takes place when the command arrives. The effect of a setting takes place
whenever the setting changes, before it is stored; it may reject the change.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from mip_tools.binding import Command
from mip_tools.devices import views
from mip_tools.devices.checks import NOTHING
from mip_tools.devices.codes import COMMAND_FAILED, INVALID_PARAMETER, READ, SETS, Refused
from mip_tools.devices.facts import COMMANDS
from mip_tools.devices.profiles import data_sets
from mip_tools.devices.settings import arguments, command_type, stored_by
from mip_tools.geometry import earth
from mip_tools.geometry.attitude import euler, euler_rotation
from mip_tools.geometry.earth import LAST_WEEK, SECOND, WEEK
from mip_tools.geometry.rotations import transposed

from ..link import Link
from ..state import DeviceState
from ..streams import formats
from ..surroundings.surroundings import IDENTITY
from . import knowledge, ports
from .filter_effects import FILTER_EFFECTS, names_of_bits


@dataclass(frozen=True)
class Outcome:
    """How a command continues: the delay of its answer, and an action after it."""

    delay: int = 0  # nanoseconds until the answer
    after: Callable[[], None] | None = None  # done once it is sent
    stored: bool = True  # a value that it writes is a setting


@dataclass(frozen=True)
class Call:
    """A command, or a setting, that takes effect: `values` are the arguments of the effect."""

    command: Command
    values: dict[str, Any]
    link: Link | None  # None: a setting that changes without a command
    function: int | None

    @property
    def writes(self) -> bool:
        return self.function in SETS


Effect = Callable[[DeviceState, Call], Outcome]
DONE = Outcome()

SELF_TEST_TIME = 2 * SECOND


# --------------------------------------------------------------------------- modes


def _idle(idle: bool) -> Effect:
    def effect(device: DeviceState, call: Call) -> Outcome:
        device.idle = idle
        device.arrange()
        return DONE

    return effect


def _self_test(device: DeviceState, call: Call) -> Outcome:
    device.pause(SELF_TEST_TIME)
    return Outcome(delay=SELF_TEST_TIME)


def _communication_mode(device: DeviceState, call: Call) -> Outcome:
    def switch() -> None:
        device.direct = call.values["mode"] != 1
        device.arrange()

    return Outcome(after=switch)


# --------------------------------------------------------------------------- streams


def _format(device: DeviceState, call: Call) -> Outcome:
    """Rejects fields that the device does not send with the set."""
    set_number, entries = call.values["set"], call.values["fields"] or ()
    if call.writes:
        if set_number not in data_sets(device.profile):
            raise Refused(INVALID_PARAMETER)
        for entry in entries:
            if not device.sends(set_number, entry.descriptor) or entry.decimation < 1:
                raise Refused(INVALID_PARAMETER)
    return Outcome(after=device.arrange)


def _sentences(device: DeviceState, call: Call) -> Outcome:
    for entry in call.values["entries"] or () if call.writes else ():
        if not knowledge.sentence(device, entry):
            raise Refused(INVALID_PARAMETER)
    return Outcome(after=device.arrange)


def _poll(device: DeviceState, call: Call) -> Outcome:
    """Sends one packet with these fields, or, without any, with those of the message format."""
    set_number, wanted = call.values["set"], call.values["fields"]
    descriptors = [getattr(entry, "descriptor", entry) for entry in wanted]
    if set_number not in data_sets(device.profile):
        raise Refused(INVALID_PARAMETER)
    if not wanted:
        descriptors = [descriptor for descriptor, _ in formats.of_set(device, set_number)]
        if not descriptors:
            raise Refused(COMMAND_FAILED)
    return Outcome(after=lambda: device.send_data(set_number, descriptors, call.link))


def _poll_sentences(device: DeviceState, call: Call) -> Outcome:
    entries = call.values["entries"] or formats.of_sentences(device)
    if not entries:
        raise Refused(COMMAND_FAILED)
    return Outcome(after=lambda: device.send_sentences(entries, call.link))


def _factory_streaming(device: DeviceState, call: Call) -> Outcome:
    """Sets formats with a few fields of each set, which replace the current formats or are appended to them."""
    formats.factory(device, call.values["action"].name)
    return Outcome(after=device.arrange)


# --------------------------------------------------------------------------- settings


def _all_settings(device: DeviceState, call: Call) -> Outcome:
    assert call.function is not None
    device.all_settings(call.function)
    return Outcome(after=device.arrange)


def _baud_rate(device: DeviceState, call: Call) -> Outcome:
    """Changes the baud rate after the answer, which is sent at the old rate."""
    port = ports.with_baud_rates(device, call.values.get("port"))
    baud = call.values["baud"]
    if call.writes and (port is None or (port.baud_rates and baud not in port.baud_rates)):
        raise Refused(INVALID_PARAMETER)
    return Outcome(after=lambda: ports.arrange(device))


def _mounting(device: DeviceState, call: Call) -> Outcome:
    effect = COMMANDS[call.command.NAME].effect
    matrix = views.vehicle_matrix(effect, call.values)
    if call.writes and not views.is_rotation(matrix):
        raise Refused(INVALID_PARAMETER)
    newer = not call.values.get("inverse")
    device.world.sensor_to_vehicle = matrix
    device.world.complementary_turns = newer
    if device.world.started and newer:  # as the manual of the 3DM-CV7 states
        device.world.filter.reset()
    return DONE


def _tare(device: DeviceState, call: Call) -> Outcome:
    """Makes the roll, pitch or yaw of the vehicle 0 by the setting of the mounting; without axes, resets it."""
    if not call.writes:  # saved by an older version
        return DONE
    world, axes = device.world, names_of_bits(call.values["axes"])
    world.advance()
    if not world.filter.level:
        raise Refused(COMMAND_FAILED)
    matrix = IDENTITY
    if axes:
        angles = (0.0 if name in axes else x for name, x in zip(("roll", "pitch", "yaw"), euler(world.dcm)))
        matrix = earth.product(euler_rotation(*angles)[1], transposed(world.state.dcm))
    world.sensor_to_vehicle = matrix
    setting: Any = stored_by(type(call.command))
    if setting is not type(call.command):  # a package of a part may lack it
        behavior = COMMANDS[setting.NAME]
        values = views.orientation_values(behavior.effect, matrix, bool(behavior.arguments.get("inverse")))
        angles_of = {str(behavior.arguments[name]): value for name, value in values.items()}
        made = replace(device.settings.factory(setting, call.command), **angles_of)
        device.settings.write(setting.decode(made.encode()))
    return Outcome(stored=False)


def _bias(name: str) -> Effect:
    def effect(device: DeviceState, call: Call) -> Outcome:
        setattr(device.world, name, tuple(call.values["bias"]))
        return DONE

    return effect


def _capture(device: DeviceState, call: Call) -> Outcome:
    """Sets the bias setting to the true bias of the sensor, even if the device moves."""
    setting: Any = command_type(COMMANDS[call.command.NAME].setting)
    parameter = str(COMMANDS[setting.NAME].arguments["bias"])
    factory: Any = device.settings.factory(setting, call.command)
    kept = replace(factory, **{parameter: device.world.gyro_error})
    device.settings.write(setting.decode(kept.encode()))
    device.world.gyro_bias = device.world.gyro_error
    return Outcome(delay=call.values["milliseconds"] * SECOND // 1000)


def _gps_time(device: DeviceState, call: Call) -> Outcome:
    """Sets the clock of the simulated world."""
    value = call.values["value"]
    if call.writes and call.values["field"] == 1:
        if value > LAST_WEEK:
            raise Refused(INVALID_PARAMETER)
        device.world.set_gps(week=value)
    elif call.writes:
        if value * SECOND >= WEEK:
            raise Refused(INVALID_PARAMETER)
        device.world.set_gps(tow=value)
    return DONE


def _protocols(device: DeviceState, call: Call) -> Outcome:
    if call.writes:
        ports.check_protocols(device, call.values, call.link)
    return Outcome(after=lambda: ports.arrange(device))


# --------------------------------------------------------------------------- events and pins


def _trigger(device: DeviceState, call: Call) -> Outcome:
    """Disables a trigger that is configured. Rejects one that watches data that the device does not send."""
    if call.writes:
        watched = call.values["set"]
        if watched is not None and not device.sends(watched, call.values["field"]):
            raise Refused(INVALID_PARAMETER)
        if not knowledge.has_room(device, "trigger", call.values):
            raise Refused(COMMAND_FAILED)
        device.disable_trigger(call.values["instance"])
    return DONE


def _action(device: DeviceState, call: Call) -> Outcome:
    """Rejects fields that the device does not send with the set."""
    set_number = call.values["set"]
    if call.writes and set_number is not None:
        has_set = set_number in data_sets(device.profile)
        if not has_set or not all(device.sends(set_number, x) for x in call.values["fields"]):
            raise Refused(INVALID_PARAMETER)
    if call.writes and not knowledge.has_room(device, "action", call.values):
        raise Refused(COMMAND_FAILED)
    return DONE


def _trigger_mode(device: DeviceState, call: Call) -> Outcome:
    """Enables, disables or tests a trigger; a test of one cycle does not change its mode."""
    instance, mode = call.values["instance"], call.values["mode"]
    if call.writes and mode and not knowledge.trigger_type(device, instance):
        raise Refused(COMMAND_FAILED)
    return Outcome(stored=mode.name != "TEST_PULSE")


def _pin(device: DeviceState, call: Call) -> Outcome:
    """Sets a new output to the level of its behavior; an input with a pull-up is high."""
    pin, behavior = call.values["pin"], call.values["behavior"].name
    options = names_of_bits(call.values["options"])
    if call.writes and {"pullup", "pulldown"} <= options:
        raise Refused(INVALID_PARAMETER)
    if call.values["feature"].name == "GPIO" and behavior in ("OUTPUT_LOW", "OUTPUT_HIGH"):
        device.world.pins[pin] = behavior == "OUTPUT_HIGH"
    else:
        device.world.pins.pop(pin, None)
    if "pullup" in options:
        device.world.pulled_up.add(pin)
    else:
        device.world.pulled_up.discard(pin)
    return DONE


def _pin_state(device: DeviceState, call: Call) -> Outcome:
    pin = call.values["pin"]
    if call.writes and pin in device.world.pins:  # an output
        device.world.pins[pin] = bool(call.values["state"])
    return DONE


def _of_filter(name: str) -> Effect:
    """Makes an effect with two more arguments: the kind of aiding measurement of a command, and whether it writes."""

    def effect(device: DeviceState, call: Call) -> Outcome:
        kind = call.command.NAME.replace(".", "_")
        device.world.advance()
        FILTER_EFFECTS[name](device, {"kind": kind, "writes": call.writes, **call.values})
        return DONE

    return effect


EFFECTS: dict[str, Effect] = {
    **{name: _of_filter(name) for name in FILTER_EFFECTS},
    "accel_bias": _bias("accel_bias"),
    "action": _action,
    "all_settings": _all_settings,
    "baud_rate": _baud_rate,
    "capture": _capture,
    "communication_mode": _communication_mode,
    "device_status": lambda device, call: DONE,
    "factory_streaming": _factory_streaming,
    "format": _format,
    "frame_rotation": lambda device, call: DONE,
    "gps_time": _gps_time,
    "gyro_bias": _bias("gyro_bias"),
    "idle": _idle(True),
    "orientation_dcm": _mounting,
    "orientation_euler": _mounting,
    "orientation_quaternion": _mounting,
    "pin": _pin,
    "pin_state": _pin_state,
    "poll": _poll,
    "poll_sentences": _poll_sentences,
    "protocols": _protocols,
    "restart": lambda device, call: Outcome(after=device.reset),
    "resume": _idle(False),
    "self_test": _self_test,
    "sentences": _sentences,
    "switch": lambda device, call: Outcome(after=device.arrange),
    "tare": _tare,
    "trigger": _trigger,
    "trigger_mode": _trigger_mode,
}


def act(device: DeviceState, command: Command, link: Link | None, function: int | None) -> Outcome:
    """Runs the effect of a command, if it has one for this function."""
    effect = COMMANDS.get(command.NAME, NOTHING).effect
    if not effect or function == READ:
        return DONE
    return EFFECTS[effect](device, Call(command, arguments(command), link, function))
