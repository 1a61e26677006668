"""The properties of a device: identity, descriptors, rates, events, pins. The world around it is in `world`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from mip_tools.devices.profiles import data_sets

from ..state import DeviceState, firmware
from ..streams import formats, nmea
from . import ports

#: The maximum number of descriptors in one response, with room for its acknowledge.
MOST_DESCRIPTORS = 124

Context = dict[str, Any]  # the values of the command, and the arguments of its effect
Quantity = Callable[[DeviceState, Context], Any]


# --------------------------------------------------------------------------- identity


def _padded(text: str) -> str:
    """Pads an identity string at its beginning, as devices do."""
    return text[:16].rjust(16)


def _number(device: DeviceState, last: str) -> str:
    return _padded(f"{device.profile.model_number or 0:04d}{last}")


def all_descriptors(device: DeviceState) -> list[int]:
    """Lists set and descriptor of all commands and data, in order; shared data has its own set."""
    return sorted(set_number << 8 | descriptor for set_number, descriptor in device.field_keys)


# --------------------------------------------------------------------------- events


def configured(device: DeviceState, effect: str) -> dict[int, Context]:
    """Instance -> configuration, of the configured triggers or actions."""
    return {setting["instance"]: setting for setting in device.settings_of(effect) if setting["type"]}


def trigger_type(device: DeviceState, instance: int) -> int:
    return int(configured(device, "trigger").get(instance, FREE)["type"])


def _slots(device: DeviceState, limit: str) -> int:
    count = device.profile.limits.get(limit)
    return 0 if count is None else int(count.value)


def _event_types(device: DeviceState, context: Context) -> Sequence[tuple[int, int]]:
    """Returns the types of triggers or actions, each with its number of instances."""
    names = TRIGGER_LIMITS if context["query"] == 1 else ACTION_LIMITS
    counts = [(number, _slots(device, limit)) for number, limit in names.items()]
    return [(number, count) for number, count in counts if count]


#: A slot without configuration.
FREE: Context = {"type": 0, "trigger": 0}

TRIGGERS, ACTIONS = "event_triggers", "event_actions"
TRIGGER_LIMITS = {1: "event_gpio_triggers", 2: "event_threshold_triggers", 3: "event_combination_triggers"}
ACTION_LIMITS = {1: "event_gpio_actions", 2: "event_message_actions"}


def has_room(device: DeviceState, effect: str, setting: Context) -> bool:
    """Does the device permit one more trigger or action of this type? It replaces the one in its slot."""
    names = TRIGGER_LIMITS if effect == "trigger" else ACTION_LIMITS
    most = device.profile.limits.get(names.get(setting["type"], ""))
    others = configured(device, effect)
    others.pop(setting["instance"], None)
    return most is None or sum(x["type"] == setting["type"] for x in others.values()) < most.value


def _asked(device: DeviceState, context: Context, limit: str) -> Sequence[int]:
    return context["instances"] or range(1, _slots(device, limit) + 1)


def _trigger_status(device: DeviceState, context: Context) -> Sequence[tuple[int, int]]:
    """Returns the type and the state of each trigger. Only one in a test mode is active."""
    modes = {setting["instance"]: setting["mode"] for setting in device.settings_of("trigger_mode")}
    rows = []
    for instance in _asked(device, context, TRIGGERS):
        mode = modes.get(instance, 0)
        state = {0: 0, 1: 0b010}.get(mode, 0b111)
        rows.append((trigger_type(device, instance), state))
    return rows


def _action_status(device: DeviceState, context: Context) -> Sequence[tuple[int, int]]:
    """Returns the type and the trigger of each action."""
    actions = configured(device, "action")
    asked = (actions.get(instance, FREE) for instance in _asked(device, context, ACTIONS))
    return [(int(action["type"]), int(action["trigger"])) for action in asked]


# --------------------------------------------------------------------------- others

#: Type of a sensor -> its ranges: setting and largest value in g, degrees per second, gauss or mbar.
RANGES: dict[int, Sequence[tuple[int, float]]] = {
    1: ((1, 2.0), (2, 4.0), (3, 8.0), (4, 10.0)),
    2: ((1, 75.0), (2, 150.0), (3, 300.0), (4, 1000.0)),
    3: ((3, 8.0),),
    4: ((3, 1100.0),),
}


def _receivers(device: DeviceState, context: Context) -> Sequence[tuple[int, int, str]]:
    """Returns the number, the data set and the description of each receiver."""
    sets = sorted(data_sets(device.profile) & {context["only"], context["first"], context["second"]})
    return [(i, set_number, f"Simulated receiver {i}".ljust(32)) for i, set_number in enumerate(sets, 1)]


def sentence(device: DeviceState, entry: Any) -> bool:
    """Can the device stream this NMEA sentence, as often?"""
    source = entry.source_descriptor_set
    if entry.decimation < 1 or source not in data_sets(device.profile) or not nmea.is_supported(entry):
        return False
    most = device.profile.limits.get("nmea_gnss_rate" if nmea.is_gnss(source) else "nmea_rate")
    return most is None or formats.rate(device, source) <= most.value * entry.decimation


def _port_protocols(way: int) -> Quantity:
    def value(device: DeviceState, context: Context) -> int:
        port = ports.by_number(device, context["port"])
        return 0 if port is None else ports.port_protocols(device, port)[way]

    return value


def _stream(name: str) -> Quantity:
    """Makes a quantity: is the data set in this argument streamed?"""

    def value(device: DeviceState, context: Context) -> bool:
        return formats.enabled(device, context[name]) and bool(formats.of_set(device, context[name]))

    return value


QUANTITIES: dict[str, Quantity] = {
    "device.firmware_version": lambda device, context: firmware(device.profile),
    "device.model_name": lambda device, context: _padded(device.profile.title),
    "device.model_number": lambda device, context: _number(device, "-4220"),
    "device.serial_number": lambda device, context: _number(device, f".{device.seed % 100000:05d}"),
    "device.lot_number": lambda device, context: _padded(""),
    "device.options": lambda device, context: _padded("4g, 300d/s"),
    "device.number": lambda device, context: device.profile.model_number or 0,
    "device.descriptors": lambda device, context: all_descriptors(device)[:MOST_DESCRIPTORS],
    "device.further_descriptors": lambda device, context: all_descriptors(device)[MOST_DESCRIPTORS:][:MOST_DESCRIPTORS],
    "device.uptime": lambda device, context: (device.now - device.booted) % (10**6 << 32) / 1e9,  # 32 bits of ms
    "device.bytes_sent": lambda device, context: device.bytes_sent & 0xFFFFFFFF,
    "device.bytes_received": lambda device, context: device.bytes_received & 0xFFFFFFFF,
    "device.packets_dropped": lambda device, context: device.dropped & 0xFFFFFFFF,
    "stream.base_rate": lambda device, context: formats.rate(device, context["set"]),
    "stream.sensor": _stream("sensor"),
    "stream.gnss": _stream("gnss"),
    "stream.filter": _stream("filter"),
    "event.slots": lambda device, context: _slots(device, TRIGGERS if context["query"] == 1 else ACTIONS),
    "event.types": _event_types,
    "event.triggers": _trigger_status,
    "event.actions": _action_status,
    "port.incoming": _port_protocols(0),
    "port.outgoing": _port_protocols(1),
    "pin.level": lambda device, context: device.world.level(context["pin"]),
    "sensor.ranges": lambda device, context: RANGES.get(context["sensor"], ()),
    "receiver.list": _receivers,
}
