"""Finds devices and ports by the names that people write."""

from __future__ import annotations

import difflib
from dataclasses import replace

from ..binding import DEVICES, Device, Port, Support, lookup
from ..errors import Misuse
from .checks import data_sets

#: The highest rate in Hz that is assumed if no device of the same generation has a known rate for a set.
UNKNOWN_RATE = 10.0


def device_named(name: str) -> Device:
    """Finds a device by its id, its title or another name; case is ignored. Raises Failure."""
    names = {alias.lower(): d for d in DEVICES.values() for alias in (d.id, d.title, *d.also)}
    wanted = name.lower()
    if wanted not in names and (named := lookup.only_named(name)):
        raise Misuse(str(named))
    if wanted not in names:
        near = [n for n in sorted(names) if wanted in n]  # a part of the name, else a similar one
        near = near or difflib.get_close_matches(wanted, names, 1, 0.5)
        hint = f"do you mean {names[near[0]].id}? " if near else ""
        raise Misuse(f"device '{name}' is unknown; {hint}`mip simulate --list` lists them all")
    return names[wanted]


def certain(profile: Device) -> Device:
    """Returns a profile with only the commands and data that the device certainly has."""
    return replace(profile, evidence=tuple(e for e in profile.evidence if e.answer is not Support.PROBABLE))


def assumed_rates(profile: Device) -> dict[int, float]:
    """Assumes the base rates that no source states: the lowest of the same generation, else a low one."""
    unknown = sorted(data_sets(profile) - profile.base_rates.keys())
    return {set: _lowest(set, profile.generation) for set in unknown}


def _lowest(set: int, generation: int | None) -> float:
    rates = {other.id: other.base_rates[set] for other in DEVICES.values() if set in other.base_rates}
    near = [rate for id, rate in rates.items() if DEVICES[id].generation == generation]
    return min(near) if near else min(*rates.values(), UNKNOWN_RATE, UNKNOWN_RATE)


def port_named(profile: Device, name: str) -> Port:
    """Finds a port of a device by name; case, spaces and underscores are ignored. Raises Failure."""
    for port in profile.ports:
        if _plain(port.name) == _plain(name):
            return port
    known = ", ".join(p.name for p in profile.ports) or "none are known"
    raise Misuse(f"{profile.title} has no port '{name}'; its ports: {known}")


def _plain(name: str) -> str:
    return name.lower().replace("_", "").replace(" ", "")


__all__ = ["assumed_rates", "certain", "device_named", "port_named"]
