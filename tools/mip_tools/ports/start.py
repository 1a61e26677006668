"""Starts fields at a device, each at its rate, with a timestamp."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..binding import CLOCKS, DEVICES, MipError, NoAnswer, Refused, session
from ..devices.profiles import data_sets
from ..errors import Failure, Misuse
from ..names.occurrence import Occurrence
from ..text import show
from ..text.clocks import dated
from . import connection
from .listing import REFUSED

if TYPE_CHECKING:
    from ..binding import DeviceAtPort, Field
    from ..devices.known import KnownDevice


def start(
    device: DeviceAtPort, rates: Mapping[Occurrence, float], time: str | None, model: str | None = None
) -> list[str]:
    """Starts fields at their rates, set by set. Shared fields are started in each of these sets.

    A timestamp is added if none is named, unless `time` is "none". Returns a line for each set that the device with the
    id `model` sends at a rate of its own.
    """
    own_rates = []
    if session() is None:
        raise Failure("the specification of this package names no commands that start data")
    shared = {occurrence.kind: rate for occurrence, rate in rates.items() if isinstance(occurrence.kind.SETS, range)}
    sets: dict[int, dict[type[Field], float]] = {}
    for occurrence, rate in rates.items():
        if occurrence.kind not in shared:
            sets.setdefault(occurrence.set, {})[occurrence.kind] = rate
    if not sets:
        raise Misuse("a shared field is sent in the packets of other fields; add one of a data set")
    timestamp = next(filter(dated, CLOCKS), None) if time in ("utc", "unix") else None if time == "none" else "auto"
    for number, own in sets.items():
        try:
            try:
                device.stream({**shared, **own}, set=number, timestamp=timestamp)
            except Refused:
                if timestamp in (None, "auto"):
                    raise
                device.stream({**shared, **own}, set=number)  # the device may lack this clock
        except NoAnswer:
            raise
        except (OSError, MipError) as error:
            if isinstance(error, Refused) and _has_own_rate(model, number):
                own_rates.append(f"{DEVICES[model or ''].title} sends {show.set_name(number)} at a rate of its own")
                continue
            code = REFUSED if isinstance(error, Refused) else 1
            raise Failure(f"{show.set_name(number)} cannot be started: {connection.reason(error)}", code) from None
    return own_rates


def ask_and_start(
    device: DeviceAtPort, known: KnownDevice, rates: Mapping[Occurrence, float], time: str | None, command: str
) -> None:
    """Asks a device what it is, and starts fields, if any; `command` of `mip` reports sets with rates of their own."""
    known.ask(device)
    for text in start(device, rates, time, known.id) if rates else ():
        print(f"mip {command}: {text}", file=sys.stderr)


def _has_own_rate(model: str | None, number: int) -> bool:
    """Does a device send a set although it has no command for its message format?"""
    profile, commands = DEVICES.get(model or ""), session()
    if profile is None or commands is None:
        return False
    older = commands.older.get(number)
    formats: list[Any] = [commands.format, *([older.format] if older else [])]
    known = any(profile.has(make.__self__.SET, make.__self__.DESCRIPTOR) for make in formats)
    return number in data_sets(profile) and not known
