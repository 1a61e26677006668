"""Names of sets, fields and devices."""

from __future__ import annotations

#: Descriptor sets -> name, title.
SETS: dict[int, tuple[str, ...]] = {
    0x01: ("tools", "Tools"),
    0x0C: ("3d", "Awkward names"),
    0x80: ("measurements", "Measurements"),
    0x81: ("more", "More measurements"),
    0x92: ("copy", "Copied measurements"),
    0xFF: ("shared", "Shared"),
}

#: Names of sets -> the family, which is the prefix of their fields' names, if its name differs.
FAMILIES: dict[str, str] = {"more": "measurements", "copy": "measurements"}

#: Full names of fields -> module, class, role, title, other names.
FIELDS: dict[str, tuple[str, str, str, str, tuple[str, ...]]] = {
    "tools.ping": ("tools", "Ping", "command", "Ping", ()),
    "tools.settings": ("tools", "Settings", "command", "Settings", ()),
    "tools.set_time": ("tools", "SetTime", "command", "Set time", ()),
    "tools.status": ("tools", "Status", "command", "Status", ()),
    "tools.bias": ("tools", "Bias", "command", "Bias", ()),
    "tools.capture_bias": ("tools", "CaptureBias", "command", "Capture bias", ()),
    "tools.formats": ("tools", "Formats", "command", "Formats", ()),
    "tools.choice": ("tools", "Choice", "command", "Choice", ()),
    "tools.list": ("tools", "List", "command", "List", ()),
    "tools.inventory": ("tools", "Inventory", "command", "Inventory", ()),
    "tools.pin": ("tools", "Pin", "command", "Pin", ()),
    "tools.hello": ("tools", "Hello", "command", "Hello", ("keep_alive",)),
    "tools.readings": ("tools", "Readings", "command", "Readings", ()),
    "tools.poll": ("tools", "Poll", "command", "Poll", ()),
    "tools.settings_response": ("tools", "SettingsResponse", "response", "Settings response", ()),
    "tools.set_time_fast_response": (
        "tools",
        "SetTimeFastResponse",
        "response",
        "Set time response",
        (),
    ),
    "tools.set_time_slow_response": (
        "tools",
        "SetTimeSlowResponse",
        "response",
        "Set time response",
        (),
    ),
    "tools.choice_response": ("tools", "ChoiceResponse", "response", "Choice response", ()),
    "tools.list_response": ("tools", "ListResponse", "response", "List response", ()),
    "tools.inventory_response": (
        "tools",
        "InventoryResponse",
        "response",
        "Inventory response",
        (),
    ),
    "tools.pin_response": ("tools", "PinResponse", "response", "Pin response", ()),
    "tools.hello_response": (
        "tools",
        "HelloResponse",
        "response",
        "Hello response",
        ("keep_alive_response", "welcome"),
    ),
    "tools.readings_response": ("tools", "ReadingsResponse", "response", "Readings response", ()),
    "tools.status_paged": ("tools", "StatusPaged", "response", "Status response", ()),
    "tools.status_short": ("tools", "StatusShort", "response", "Status response", ()),
    "tools.status_long": ("tools", "StatusLong", "response", "Status response", ()),
    "tools.status_old": ("tools", "StatusOld", "response", "Status response", ()),
    "tools.status_full": ("tools", "StatusFull", "response", "Status response", ()),
    "tools.bias_vector": ("tools", "BiasVector", "response", "Bias response", ()),
    "3d.default": ("mip_3d", "Default", "command", "Default", ()),
    "measurements.accel": ("measurements", "Accel", "data", "Acceleration", ()),
    "measurements.numbers": ("measurements", "Numbers", "data", "Numbers", ()),
    "measurements.strings": ("measurements", "Strings", "data", "Strings", ()),
    "measurements.health": ("measurements", "Health", "data", "Health", ()),
    "measurements.arrays": ("measurements", "Arrays", "data", "Arrays", ()),
    "measurements.growing": ("measurements", "Growing", "data", "Growing", ()),
    "measurements.radio": ("measurements", "Radio", "data", "Radio", ("modem", "rf")),
    "measurements.own": ("measurements", "Own", "data", "Own", ()),
    "measurements.cloud": ("measurements", "Cloud", "data", "Cloud", ()),
    "measurements.gust": ("measurements", "Gust", "data", "Gust", ()),
    "measurements.breeze": ("measurements", "Breeze", "data", "Breeze", ()),
    "shared.timestamp": ("shared", "Timestamp", "data", "Timestamp", ()),
    "protocol.acknowledge": ("protocol", "Acknowledge", "response", "Acknowledge", ()),
}

#: Ids of devices -> title, other names.
DEVICES: dict[str, tuple[str, ...]] = {
    "model-a": ("Model A",),
    "model-b": ("Model B",),
    "model-c": ("Model C", "Model See", "c"),
    "old-1": ("Old 1", "First"),
    "old-2": ("Old 2",),
}
