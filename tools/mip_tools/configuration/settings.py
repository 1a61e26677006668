"""The commands that are settings, and the instances of them that a device has."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from functools import cache
from itertools import product
from typing import Any

from ..binding import DEVICES, Command, Device, Evidence, Parameter, Port, Support, info, registry
from ..devices.checks import NOTHING, set_of
from ..devices.codes import READ, SAVE, WRITE
from ..devices.facts import AFFECTED, COMMANDS, DATA_SETS, FUNCTIONS, PORTS, VALUES, Behavior, difference_on
from ..devices.profiles import data_sets
from ..devices.settings import Key, instance_keys, stored_by

#: Effects of settings in the order in which they are changed: streams after the data that they contain, and last the
#: settings that may cut the connection.
STREAMS = ("format", "sentences", "switch")
LINK = ("protocols", "communication_mode", "baud_rate")
_ORDER = (*STREAMS, *LINK)


@dataclass(frozen=True)
class Place:
    """One setting: a command, and the values that select an instance of it."""

    command: str
    key: Key = ()

    @property
    def kind(self) -> Any:
        return settings()[self.command]

    @property
    def keys(self) -> tuple[str, ...]:
        return instance_keys(self.kind)

    @property
    def selected(self) -> dict[str, int]:
        """The values that select this instance, by attribute."""
        return dict(zip(self.keys, self.key))

    @staticmethod
    def selected_by(command: str, selected: Mapping[str, int]) -> Place:
        """Returns the instance that these values select. The values that are not given are fixed."""
        kind = settings()[command]
        return Place(
            command, tuple(int(selected.get(name, info(kind)[name].default or 0)) for name in instance_keys(kind))
        )

    def reading(self, beside: Command | None = None) -> Any:
        """Returns the command that reads this setting; if it has several forms, in the form of the command `beside`."""
        values = {name: v for name, v in self.selected.items() if not info(self.kind)[name].reserved}
        for p in own_parameters(self.kind):
            if "read" in p.required and p.attribute not in values:
                forms = info(p.type).values if p.type is not None else ()
                values[p.attribute] = getattr(beside, p.attribute) if beside else forms[0].value if forms else 0
        return self.kind.read(**values)

    def saving(self) -> Any:
        return self.kind.save(**{n: v for n, v in self.selected.items() if not info(self.kind)[n].reserved})


def behavior(kind: type[Command]) -> Behavior:
    return COMMANDS.get(kind.NAME, NOTHING)


@cache
def settings() -> dict[str, type[Command]]:
    """Returns the commands that can be written, read and saved, by name.

    A command that acts only once is not a setting, and neither is a command whose values all select an instance.
    """
    kinds: dict[str, type[Command]] = {}
    for _, kind in registry.all_types():
        if issubclass(kind, Command) and kind.REQUIRED.keys() >= {WRITE, READ, SAVE} and not behavior(kind).once:
            values = [p for p in own_parameters(kind) if p.attribute not in instance_keys(kind)]
            kinds |= {kind.NAME: kind} if values else {}
    return kinds


def own_parameters(kind: type[Any]) -> list[Parameter]:
    """Returns the parameters of a setting, without the function selector and without derived and reserved ones."""
    return [p for p in info(kind).parameters if p.name != "function" and not p.derived and not p.reserved]


def stored_settings(profile: Device) -> list[type[Command]]:
    """Returns the settings of a device. Of several commands for one setting, only the one that stores it counts."""
    own = [kind for kind in settings().values() if (kind.SET, kind.DESCRIPTOR) in profile.fields]
    readable = [kind for kind in own if {"W", "R"} <= _letters(kind, profile)]
    chosen: dict[tuple[str, tuple[tuple[str, int], ...]], type[Command]] = {}
    for kind in sorted(readable, key=lambda kind: stored_by(kind) is not kind):
        chosen.setdefault((stored_by(kind).NAME, tuple(behavior(kind).key.items())), kind)
    kept = {name for name, _ in chosen if any(name == kind.NAME for kind in readable)}
    return [k for k in readable if k in chosen.values() and (stored_by(k) is k or stored_by(k).NAME not in kept)]


def saves_all(profile: Device) -> Any:
    """Returns the command that saves all settings of a device at once; None if the device has none."""
    commands = (kind for _, kind in registry.all_types() if issubclass(kind, Command))
    whole = (kind for kind in commands if behavior(kind).effect == "all_settings" and can(kind, profile, SAVE))
    return next((kind for kind in whole if (kind.SET, kind.DESCRIPTOR) in profile.fields), None)


def can(kind: type[Command], profile: Device, function: int) -> bool:
    """Does the device support this function of a command?"""
    return any(FUNCTIONS[letter] == function for letter in _letters(kind, profile))


def _letters(kind: type[Command], profile: Device) -> set[str]:
    usual = {letter for letter, number in FUNCTIONS.items() if number in kind.REQUIRED}
    return set(profile.functions.get((kind.SET, kind.DESCRIPTOR), usual)) & usual


def in_order(places: Iterable[Place]) -> list[Place]:
    """Sorts settings into the order in which they are changed."""

    def rank(place: Place) -> int:
        effect = behavior(place.kind).effect
        return _ORDER.index(effect) + 1 if effect in _ORDER else 0

    return sorted(places, key=rank)


def ends_talk(place: Place) -> bool:
    """Can a change of this setting cut the connection to the device?"""
    return behavior(place.kind).effect in LINK


def response_names(response: type[Any]) -> dict[str, str]:
    """Name in the command -> name in the response, of parameters for which they differ."""
    shown = VALUES.get(response.NAME)
    return {v.parameter: name for name, v in shown.parameters.items() if v.parameter} if shown else {}


# --------------------------------------------------------------------------- instances


def requested_places(kind: type[Command], profile: Device) -> Iterator[tuple[Place, bool]]:
    """Yields the instances to request from a device. True means: if the device rejects this one, there are no more."""
    names = instance_keys(kind)
    values: list[list[int]] = []
    for name in names:
        choices = _values(info(kind)[name], kind, profile)
        values.append(choices)
    limits = (behavior(kind).instances.get(name) for name in names)
    open_end = any(limit not in (None, PORTS, DATA_SETS, AFFECTED, *profile.limits) for limit in limits)
    for key in product(*values):
        if all(_affects(kind, dict(zip(names, key)), profile)):
            yield Place(kind.NAME, tuple(key)), open_end


def _values(p: Parameter, kind: type[Command], profile: Device) -> list[int]:
    """Returns the values of a parameter that select an instance of a setting on a device."""
    rules = behavior(kind)
    source, everything = rules.instances.get(p.name), rules.all.get(p.name)
    translate = rules.translate.get(p.name, {})
    if p.reserved:
        return [int(p.default or 0)]
    if source == PORTS and profile.ports:
        ports = _with_baud_rates(profile) if rules.effect == "baud_rate" else profile.ports
        return [port.id for port in ports if port.id is not None]
    names = value_names(p, profile)
    if names:
        values = [v for v in names if v != everything]
    elif source == DATA_SETS and p.refers == "set":
        return sorted(data_sets(profile))
    elif translate:
        values = list(translate)
    elif source == AFFECTED:
        return sorted({descriptor for _, descriptor in rules.affected})
    elif p.refers == "set":
        return sorted({number for number, _ in rules.affected})
    else:
        return list(range(1, _most(source, profile) + 1))
    if source == DATA_SETS and data_sets(profile):
        values = [v for v in values if translate.get(v, v) in data_sets(profile)]
    return values


def _with_baud_rates(profile: Device) -> Sequence[Port]:
    """Returns the ports whose baud rate can be set; all, if no rates are known. Beside ports with rates, Main without
    rates is one of these by a second name; the rates of others may only be unknown."""
    if not any(port.baud_rates for port in profile.ports):
        return profile.ports
    return [port for port in profile.ports if port.baud_rates or not port.name.startswith(("USB", "Main"))]


def value_names(p: Parameter, profile: Device) -> dict[int, str]:
    """Returns the names of the enumeration values that a device has, by number; empty for other types."""
    kind = on(p, profile).type
    if not (isinstance(kind, type) and issubclass(kind, IntEnum)):
        return {}
    only = difference_on(p, profile.id).values
    return {v.value: v.name for v in info(kind).values if not only or v.value in only}


def on(p: Parameter, profile: Device) -> Parameter:
    """Returns the parameter as a device interprets it; unchanged if the package does not know the device."""
    return p.on(profile.id) if profile.id in DEVICES else p


def _most(limit: str | None, profile: Device) -> int:
    """Returns the number of instances that a device may have. If its profile does not state it, it is the largest
    number that any other device has."""
    own = profile.limits.get(limit or "")
    if own is not None:
        return int(own.value)
    return max((int(d.limits[limit].value) for d in DEVICES.values() if limit in d.limits), default=0) if limit else 0


def _affects(kind: type[Command], key: dict[str, int], profile: Device) -> Iterator[bool]:
    """Yields for each descriptor in the key whether the device has this data in its set."""
    for name, source in behavior(kind).instances.items():
        if source == AFFECTED:
            number = set_of(info(kind)[name], _Record(key))
            yield (number, key[name]) in behavior(kind).affected & profile.fields


class _Record:
    def __init__(self, values: dict[str, int]) -> None:
        self.__dict__.update(values)


# --------------------------------------------------------------------------- devices

#: A device of which nothing is known.
UNKNOWN = Device("", "", "", None, (), {})


def listed_profile(profile: Device | None, title: str, descriptors: Iterable[tuple[int, int]]) -> Device:
    """Makes a profile that has only the descriptors that the device itself lists."""
    by_set: dict[int, bytes] = {}
    for number, descriptor in descriptors:
        by_set[number] = by_set.get(number, b"") + bytes((descriptor,))
    evidence = Evidence(Support.YES, "listed", "", by_set)
    return replace(profile or replace(UNKNOWN, title=title), evidence=(evidence,), incomplete=())
