"""What simulated devices show and do, by full names of fields."""

from __future__ import annotations

from .facts import Behavior, Difference, FieldValues

#: Letters of function selectors -> their numbers.
FUNCTIONS: dict[str, int] = {"W": 1, "R": 2, "S": 3, "L": 4, "D": 5, "A": 6}

#: Names of quantities -> unit.
QUANTITIES: dict[str, str | None] = {}

#: Names of effects -> their arguments.
EFFECTS: dict[str, tuple[str, ...]] = {}

#: Data fields and responses -> what their values show.
VALUES: dict[str, FieldValues] = {}

#: Commands -> what they do beside keeping a setting.
COMMANDS: dict[str, Behavior] = {}

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
