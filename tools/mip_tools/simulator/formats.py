"""Derives the streams of a device from its settings: message formats and switches."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from ..binding import reflection
from .checks import data_sets
from .codes import WRITE
from .facts import COMMANDS
from .profiles import assumed_rates
from .settings import command_type, home, keys
from .streams import Stream

if TYPE_CHECKING:
    from .device import VirtualDevice

#: The rate in Hz of sets without a base rate, whose data a real device sends as it becomes available.
RATE_AS_THEY_ARISE = 1.0

#: The number of fields of each set in factory streaming, and their rate in Hz.
FACTORY_FIELDS, FACTORY_RATE = 4, 10


def rate(device: VirtualDevice, set: int) -> int:
    """Returns the base rate that commands report; 0 if the set has none."""
    known = device.profile.base_rates
    return round(known[set] if set in known else assumed_rates(device.profile).get(set, 0))


def ticks(device: VirtualDevice, set: int) -> float:
    """Returns the rate in Hz at which a set is sent without decimation."""
    return rate(device, set) or RATE_AS_THEY_ARISE


def of_set(device: VirtualDevice, set: int) -> list[tuple[int, int]]:
    """Returns the message format of a set: descriptors and decimations."""
    for given in device.settings_of("format"):
        if given["set"] == set:
            return [(entry.descriptor, entry.decimation) for entry in given["fields"]]
    return []


def of_sentences(device: VirtualDevice) -> list[Any]:
    """Returns the streamed NMEA sentences."""
    return [entry for given in device.settings_of("sentences") for entry in given["entries"]]


def enabled(device: VirtualDevice, set: int) -> bool:
    """Is the stream of a set switched on?"""
    for given in device.settings_of("switch"):
        if given["set"] == set:
            return bool(given["enable"])
    return True


def streams(device: VirtualDevice, begin: int) -> list[Stream]:
    """Makes the streams that the settings define, starting at `begin`."""
    streams = []
    for set in sorted(data_sets(device.profile)):
        known = [(d, x) for x, d in of_set(device, set) if device.sends(set, x)]
        items = [(d, device.encoder(set, x)) for d, x in known]
        if items and enabled(device, set):
            streams.append(_stream(device, set, items, partial(device.send_fields, set), begin))
    sentences = of_sentences(device)
    for set in sorted({entry.source_descriptor_set for entry in sentences}):
        entries = [(e.decimation, e) for e in sentences if e.source_descriptor_set == set]
        streams.append(_stream(device, set, entries, device.send_sentences, begin))
    return streams


def _stream(device: VirtualDevice, set: int, items: list[tuple[int, Any]], fire: Any, begin: int) -> Stream:
    return Stream(ticks(device, set), items, fire, device.booted, begin)


def _keeper(device: VirtualDevice, set: int) -> Any:
    """Returns the command that stores the message format of a set."""
    for name, behavior in COMMANDS.items():
        if behavior.effect == "format" and device.knows(name):
            kind = home(command_type(name))
            if COMMANDS[kind.NAME].arguments["set"] == set or keys(kind):
                return kind
    return None


def factory(device: VirtualDevice, keep: bool) -> None:
    """Sets message formats with the first fields of each set; `keep` appends them to the current formats."""
    for set in sorted(data_sets(device.profile)):
        kind = _keeper(device, set)
        if kind is None:
            continue
        at = COMMANDS[kind.NAME].arguments
        entry = next(p.type for p in reflection.info(kind).parameters if p.attribute == at["fields"])
        decimation = max(1, round(rate(device, set) / FACTORY_RATE))
        own = sorted(x for s, x in device.known if s == set)[:FACTORY_FIELDS]
        wanted = [*(of_set(device, set) if keep else ()), *((x, decimation) for x in own)]
        given: dict[str, Any] = {str(at["fields"]): tuple(entry(*pair) for pair in wanted)}
        given |= {name: set for name in keys(kind)}
        device.settings.write(kind(function=WRITE, **given))


__all__ = ["enabled", "factory", "of_sentences", "of_set", "rate", "streams", "ticks"]
