"""Derives the streams of a device from its settings: message formats and switches."""

from __future__ import annotations

from functools import partial
from typing import Any

from mip_tools.binding import MAX_PAYLOAD, reflection
from mip_tools.devices.codes import COMMAND_FAILED, WRITE, Refused
from mip_tools.devices.facts import COMMANDS
from mip_tools.devices.profiles import assumed_rates, data_sets
from mip_tools.devices.settings import command_type, instance_keys, stored_by

from ..state import DeviceState
from .stream import Stream

#: The rate in Hz of sets without a base rate, whose data a real device sends as it becomes available.
RATE_AS_THEY_ARISE = 1.0

#: The maximum size of a write of a setting: a response repeats all but the function, with its header and an ACK.
LONGEST_SETTING = MAX_PAYLOAD - 2 - 4 + 1
#: The maximum number of fields in a message format: three bytes each, after the function, the set and their number.
MOST_FIELDS = (LONGEST_SETTING - 3) // 3

#: The number of fields of each set in factory streaming, and their rate in Hz.
FACTORY_FIELDS, FACTORY_RATE = 4, 10


def rate(device: DeviceState, set_number: int) -> int:
    """Returns the base rate that commands report; 0 if the set has none."""
    base_rates = device.profile.base_rates
    return round(
        base_rates[set_number] if set_number in base_rates else assumed_rates(device.profile).get(set_number, 0)
    )


def ticks(device: DeviceState, set_number: int) -> float:
    """Returns the rate in Hz at which a set is sent without decimation."""
    return rate(device, set_number) or RATE_AS_THEY_ARISE


def of_set(device: DeviceState, set_number: int) -> list[tuple[int, int]]:
    """Returns the message format of a set: descriptors and decimations."""
    for setting in device.settings_of("format"):
        if setting["set"] == set_number:
            return [(entry.descriptor, entry.decimation) for entry in setting["fields"]]
    return []


def of_sentences(device: DeviceState) -> list[Any]:
    """Returns the streamed NMEA sentences."""
    return [entry for setting in device.settings_of("sentences") for entry in setting["entries"]]


def enabled(device: DeviceState, set_number: int) -> bool:
    """Is the stream of a set switched on?"""
    for setting in device.settings_of("switch"):
        if setting["set"] == set_number:
            return bool(setting["enable"])
    return True


def streams(device: DeviceState, begin: int) -> list[Stream]:
    """Makes the streams that the settings define, starting at `begin`."""
    streams = []
    for set_number in sorted(data_sets(device.profile)):
        chosen = of_set(device, set_number)
        if not chosen and _keeper(device, set_number) is None:  # the device sends all, at its own rate
            chosen = [(x, 1) for s, x in sorted(device.field_keys) if s == set_number]
        pairs = [(d, x) for x, d in chosen if device.sends(set_number, x)]
        items = [(d, device.encoder(set_number, x)) for d, x in pairs]
        if items and enabled(device, set_number):
            streams.append(_stream(device, set_number, items, partial(device.send_fields, set_number), begin))
    sentences = of_sentences(device)
    for set_number in sorted({entry.source_descriptor_set for entry in sentences}):
        entries = [(e.decimation, e) for e in sentences if e.source_descriptor_set == set_number]
        streams.append(_stream(device, set_number, entries, device.send_sentences, begin))
    return streams


def _stream(device: DeviceState, set_number: int, items: list[tuple[int, Any]], fire: Any, begin: int) -> Stream:
    return Stream(ticks(device, set_number), items, fire, device.booted, begin)


def _keeper(device: DeviceState, set_number: int) -> Any:
    """Returns the command that stores the message format of a set."""
    for name, behavior in COMMANDS.items():
        if behavior.effect == "format" and device.knows(name):
            kind = stored_by(command_type(name))
            if COMMANDS[kind.NAME].arguments["set"] == set_number or instance_keys(kind):
                return kind
    return None


def factory(device: DeviceState, action: str) -> None:
    """Sets message formats with the first fields of each set: "ADD" appends them to the current formats, and "MERGE"
    those that are not in them. Raises Refused, and changes nothing, if a format becomes too long."""
    formats = []
    for set_number in sorted(data_sets(device.profile)):
        kind = _keeper(device, set_number)
        if kind is None:
            continue
        at = COMMANDS[kind.NAME].arguments
        entry = next(p.type for p in reflection.info(kind).parameters if p.attribute == at["fields"])
        decimation = max(1, round(rate(device, set_number) / FACTORY_RATE))
        own = sorted(x for s, x in device.field_keys if s == set_number)[:FACTORY_FIELDS]
        kept = of_set(device, set_number) if action in ("ADD", "MERGE") else []
        there = {x for x, _ in kept} if action == "MERGE" else set()
        wanted = [*kept, *((x, decimation) for x in own if x not in there)]
        if len(wanted) > MOST_FIELDS:
            raise Refused(COMMAND_FAILED)
        values: dict[str, Any] = {str(at["fields"]): tuple(entry(*pair) for pair in wanted)}
        values |= {name: set_number for name in instance_keys(kind)}
        formats.append(kind(function=WRITE, **values))
    for setting in formats:
        device.settings.write(setting)
