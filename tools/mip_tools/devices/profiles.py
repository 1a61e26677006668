"""Finds devices and ports by the names that people write."""

from __future__ import annotations

from dataclasses import replace

from ..binding import DEVICES, Device, Port, Support, UnknownName, lookup
from ..errors import Misuse

#: The highest rate in Hz that is assumed if no device of the same generation has a known rate for a set.
UNKNOWN_RATE = 10.0


def device_named(name: str) -> Device:
    """Finds a device by its id, its title, another name, or the last words of one. Raises Misuse."""
    try:
        return DEVICES[lookup.device_id(name)]
    except UnknownName as error:
        hint = f"{'' if str(error).endswith('?') else ';'} `mip fields --devices` lists them all"
        raise Misuse(f"{error}{'' if lookup.only_named(name) else hint}") from None


def data_sets(profile: Device) -> frozenset[int]:
    """Returns the data sets that a device sends."""
    return frozenset(set_number for set_number, _ in profile.fields if 0x80 <= set_number < 0xFF)


def certain(profile: Device) -> Device:
    """Returns a profile with only the commands and data that the device certainly has."""
    return replace(
        profile, evidence=tuple(e for e in profile.evidence if e.answer not in (Support.LIKELY, Support.ASSUMED))
    )


def assumed_rates(profile: Device) -> dict[int, float]:
    """Assumes the base rates that no source states: the lowest of the same generation, else a low one."""
    unknown = sorted(data_sets(profile) - profile.base_rates.keys())
    return {set_number: _lowest(set_number, profile.generation) for set_number in unknown}


def assumed_ports(profile: Device) -> tuple[Port, ...]:
    """Assumes ports and baud rates that no source states: all rates that some device has."""
    if any(port.baud_rates for port in profile.ports):
        return profile.ports
    usual = tuple(sorted({rate for d in DEVICES.values() for port in d.ports for rate in port.baud_rates}))
    ports = tuple(replace(p, baud_rates=usual) if p.name.startswith("UART") else p for p in profile.ports)
    return ports or (Port("Main", None, usual, ("MIP",), ("MIP", "NMEA")),)


def _lowest(set_number: int, generation: int | None) -> float:
    rates = {other.id: other.base_rates[set_number] for other in DEVICES.values() if set_number in other.base_rates}
    near = [rate for other_id, rate in rates.items() if DEVICES[other_id].generation == generation]
    return min(near) if near else min(*rates.values(), UNKNOWN_RATE, UNKNOWN_RATE)


def port_named(profile: Device, name: str) -> Port:
    """Finds a port of a device by name; case, spaces and underscores are ignored. Raises Failure."""
    for port in profile.ports:
        if _plain(port.name) == _plain(name):
            return port
    names = ", ".join(p.name for p in profile.ports) or "none are known"
    raise Misuse(f"{profile.title} has no port '{name}'; its ports: {names}")


def _plain(name: str) -> str:
    return name.lower().replace("_", "").replace(" ", "")
