"""The knowledge and behaviour of a simulated device: the part of the model that `spec/simulation` defines.

The simulated world, such as a motion, is not described here. Its *quantities* have names, and each value of a data
field or a response shows one of them. Likewise, a command names its *effect*.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import Field, Unit


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of the simulation, in one unit: a number, several numbers, a text, or a list."""

    name: str
    unit: Unit | None
    elements: int
    description: str
    typical: Any = None  # a typical value: a number, several numbers, a text, or a list
    noise: tuple[tuple[str, float], ...] = ()  # noise of the sensor that measures it: density, drift, period


@dataclass(frozen=True, slots=True)
class Effect:
    name: str
    arguments: tuple[str, ...]
    description: str


@dataclass(frozen=True, slots=True)
class Value:
    """The value of a parameter: a quantity, times `factor`, a constant, or a parameter of the command."""

    path: str  # parameter, or parameter.member of a structure
    quantity: str = ""
    factor: float = 1.0
    names: tuple[str, ...] = ()  # of values: the first one in the enumeration, which may depend on the device
    bits: tuple[str, ...] = ()
    number: float | int | None = None
    text: str | None = None
    parameter: str = ""  # of a response: the parameter of its command whose setting it shows


@dataclass(frozen=True, slots=True)
class Source:
    """The source of the values of a data field or a response, in one set or in all sets without their own source."""

    field: Field
    set: int | None
    for_each: str  # a quantity that is a list: the field is sent once for each item
    values: tuple[Value, ...]
    valid_if: str = ""  # a quantity that shows whether the values are valid; else all of them are 0


@dataclass(frozen=True, slots=True)
class Behavior:
    """The effects of a command besides storing a setting, and the way the setting is stored."""

    command: Field
    effect: str = ""
    arguments: tuple[tuple[str, str | int], ...] = ()  # of the effect: a parameter, parameter.member, or a number
    all: tuple[tuple[str, int], ...] = ()  # parameter -> the value that means all instances
    writes_all: bool = False  # a write may select all, too
    instances: tuple[tuple[str, str], ...] = ()  # parameter -> its values: a limit, PORTS, SETS, AFFECTED
    translate: tuple[tuple[str, tuple[tuple[int, int], ...]], ...] = ()  # parameter -> number -> number of a set
    setting: str = ""  # the command whose setting it is, if not its own
    key: tuple[tuple[str, int], ...] = ()  # the instance of that setting
    initial: tuple[tuple[str, object], ...] = ()  # values on a new device
    once: bool = False  # a write acts once: its own values are no setting
    affected: tuple[tuple[int, int], ...] = ()  # set and descriptor of the data from which AFFECTED selects
    answers: tuple[tuple[str, tuple[str, ...]], ...] = ()  # response -> the devices that have this layout


#: Instances other than numbers up to a limit: the ports of the device, its data sets, and the data fields that the
#: command certainly affects.
PORTS = "ports"
SETS = "data_sets"
AFFECTED = "affected"


@dataclass(frozen=True, slots=True)
class Simulation:
    quantities: tuple[Quantity, ...] = ()
    effects: tuple[Effect, ...] = ()
    sources: tuple[Source, ...] = ()
    behaviors: tuple[Behavior, ...] = ()

    def only(self, fields: dict[str, Field]) -> Simulation:
        """Returns the part about these fields.

        Commands whose common setting is not among them share it as before: the first one keeps it.
        """
        behaviors: list[Behavior] = []
        keepers: dict[tuple[str, tuple[tuple[str, int], ...]], str] = {}
        for b in self.behaviors:
            command = fields.get(b.command.full_name)
            if command is None:
                continue
            layouts = ((name, fields.get(f"{command.family}.{name}")) for name, _ in b.answers)
            b = replace(b, command=command, answers=tuple((name, f.devices) for name, f in layouts if f is not None))
            if not b.setting or b.setting in fields:
                behaviors.append(b)
            elif command.functions:  # else it only acts on the setting, which does not exist
                keeper = keepers.setdefault((b.setting, b.key), command.full_name)
                behaviors.append(replace(b, setting="" if keeper == command.full_name else keeper, key=()))
        sources = tuple(
            replace(s, field=f)
            for s in self.sources
            if (f := fields.get(s.field.full_name)) is not None and (s.set is None or s.set in f.sets)
        )
        return Simulation(self.quantities, self.effects, sources, tuple(behaviors))
