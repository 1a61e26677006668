"""What simulated devices show and do, by full names of fields."""

from __future__ import annotations

from .facts import Behavior, Difference, FieldValues, Value

#: Letters of function selectors -> their numbers.
FUNCTIONS: dict[str, int] = {"W": 1, "R": 2, "S": 3, "L": 4, "D": 5, "A": 6}

#: Names of quantities -> unit.
QUANTITIES: dict[str, str | None] = {
    "specific_force": "m/s^2",
    "device.uptime": "s",
    "satellites": None,
    "satellite.number": None,
    "wind.angle": "rad",
}

#: Names of effects -> their arguments.
EFFECTS: dict[str, tuple[str, ...]] = {
    "idle": (),
    "format": ("set", "fields"),
    "switch": ("set", "enable"),
}

#: Data fields and responses -> what their values show.
VALUES: dict[str, FieldValues] = {
    "measurements.accel": FieldValues(
        "",
        {
            "scaled_accel": Value(quantity="specific_force", factor=0.10197162129779283),
            "valid_flags": Value(bits=("hot", "mode.fast")),
        },
    ),
    "measurements.numbers": FieldValues(
        "satellites", {"u8": Value(quantity="satellite.number"), "double": Value(number=1.5)}
    ),
    "measurements.strings": FieldValues("", {"model": Value(text="Model")}),
    "measurements.health": FieldValues("", {"result": Value(bits=("clock",))}),
    "measurements.gust": FieldValues("", {"place.x": Value(number=1), "height": Value(number=-2)}),
    "tools.status_long": FieldValues("", {"uptime": Value(quantity="device.uptime")}),
    "tools.status_short": FieldValues("", {"flags": Value(bits=("clock", "general"))}),
    "more.strings": FieldValues("", {"model": Value(text="Other")}),
    "more.own": FieldValues("", {"mode": Value(names=("slow", "fast"))}),
}
VALUES["more.accel"] = VALUES["measurements.accel"]
VALUES["copy.accel"] = VALUES["measurements.accel"]
VALUES["copy.numbers"] = VALUES["measurements.numbers"]
VALUES["copy.strings"] = VALUES["measurements.strings"]
VALUES["copy.health"] = VALUES["measurements.health"]
VALUES["copy.gust"] = VALUES["measurements.gust"]

#: Commands -> what they do besides storing a setting.
COMMANDS: dict[str, Behavior] = {
    "tools.ping": Behavior(effect="idle"),
    "tools.settings": Behavior(
        effect="switch",
        arguments={"set": "port", "enable": 1},
        all={"port": 0},
        instances={"port": "segments"},
        translate={"port": {1: 128, 2: 129}},
        initial={"mode": 1, "baud": 9600},
    ),
    "tools.pin": Behavior(
        instances={"drive": "ports"}, setting="tools.settings", key={"port": 128}
    ),
    "tools.choice": Behavior(instances={"instance": "data_sets"}),
    "tools.bias": Behavior(initial={"bias": (0.5, 0.25, 0.0)}),
    "tools.status": Behavior(
        arguments={"set": 128}, answers={"status_old": ("model-a",), "status_full": ("model-c",)}
    ),
}

#: Commands that are not acknowledged while the setting of another command has a value: (command, parameter, value).
SILENCED: dict[str, tuple[tuple[str, str, int], ...]] = {
    "3d.default": (("tools.settings", "mode", 1),)
}

#: Devices -> parameters of commands and responses that differ there.
DIFFERENCES: dict[str, dict[str, Difference]] = {
    "model-c": {
        "tools.settings.mode": Difference(values=frozenset({0, 1})),
        "tools.status.selector": Difference(constant=2),
    }
}
