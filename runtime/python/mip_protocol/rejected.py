"""Which field a device rejected a command for, and why: the rule of "Rejected fields" in the
specification's README."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import NamedTuple

from ._clocks import TIMESTAMPS
from ._index import information
from ._lists import ALTERNATIVES, LISTS
from ._session import session
from ._sets import SETS
from .conversation import Dialog, Step, T, Ticket, responses
from .errors import Cause, Refused
from .exceptions import MipError
from .field import Command, Response
from .profile import Device, Support
from .registry import types
from .timestamps import clocks_of

SHARED_SET = 0xFF

#: Why a device rejects a command or a field, in the order of their authority.
OTHER_COMMAND = "other_command"  # the device has another command for it
ABSENT = "absent"  # the device does not send it
DECIMATION = "decimation"  # its decimation is 0
TOO_MANY = "too_many"  # the list is longer than permitted
RANGE = "range"  # a value is out of its documented range
UNDEFINED = "undefined"  # it is not data of the set
UNLISTED = "unlisted"  # no source states that this model sends it


class Listing(NamedTuple):
    """A list of fields in a command. Offsets count from the beginning of its data; -1: none."""

    set: int  # of all fields
    set_at: int  # else, where its number is
    count_at: int  # the number of entries; without it, there is one
    first: int  # the descriptor in the first entry; without it, the command names only a set
    stride: int
    most: int  # entries
    decimation_at: int  # in an entry: a u16 that must not be 0
    tag_at: int
    tag: int  # which the list requires there


@dataclass
class ConnectedDevice:
    """What is known about the connected device."""

    profile: Device | None = None
    descriptors: Collection[tuple[int, int]] = ()  # set and descriptor of all that it lists
    asked: bool = False

    def sends(self, set: int, descriptor: int) -> bool | None:
        """Does the device have this field, or with descriptor 0, any of the set? None if unknown."""
        fields = self.descriptors or (self.profile.fields if self.profile else ())
        if any(s == set and d == descriptor or not descriptor and s == set for s, d in fields):
            return True
        if self.descriptors:
            return (SHARED_SET, descriptor) in self.descriptors
        if self.profile is None or self.profile.support(set, descriptor) is Support.UNKNOWN:
            return None
        return self.profile.has(set, descriptor)


def listed(command: Command) -> Iterator[tuple[Listing, int, int, int | None]]:
    """Yields the data that a command lists: the list, the set, the descriptor, and the decimation.

    If the list is empty or the command names only a set, the descriptor is 0.
    """
    data = command.encode()

    def number(at: int) -> int:
        return data[at] if 0 <= at < len(data) else 0

    for row in LISTS.get((command.SET, command.DESCRIPTOR), ()):
        place = Listing(*row)
        set = place.set if place.set >= 0 else number(place.set_at)
        if set < 0x80 or (place.tag_at >= 0 and number(place.tag_at) != place.tag):
            continue
        count = number(place.count_at) if place.count_at >= 0 else 1
        entries = range(place.first, place.first + count * place.stride, place.stride)
        for at in entries if place.first >= 0 and count else (-1,):
            by = at + place.decimation_at
            decimates = at >= 0 and place.decimation_at >= 0
            yield place, set, number(at), number(by) << 8 | number(by + 1) if decimates else None


def find_cause(command: Command, target: ConnectedDevice) -> Cause | None:
    """Returns the field for which a device has rejected a command, or the command that it has
    instead; None if nothing shows it."""
    key = (command.SET, command.DESCRIPTOR)
    fields = list(listed(command))
    for set, descriptor in ALTERNATIVES.get(key, ()) if target.sends(*key) is False else ():
        # Some are for the data of one set, which must be that of the command.
        only = {row[0] for row in LISTS.get((set, descriptor), ()) if row[0] >= 0}
        if target.sends(set, descriptor) and (not only or any(s in only for _, s, _, _ in fields)):
            text = f"{_title(target)} has {data_name(set, descriptor)} instead"
            return Cause(0, set, descriptor, OTHER_COMMAND, text)
    for index, (_, set, descriptor, _) in enumerate(fields):
        if target.sends(set, descriptor) is False:
            return Cause(index, set, descriptor, ABSENT, _absent(target, set, descriptor))
    for index, (place, set, descriptor, decimation) in enumerate(fields):
        if decimation == 0:
            text = f"the decimation of {data_name(set, descriptor)} is 0"
            return Cause(index, set, descriptor, DECIMATION, text)
        if 0 <= place.most <= index:
            text = f"{len(fields)} fields are listed, at most {place.most} are possible"
            return Cause(index, set, descriptor, TOO_MANY, text)
    unknown = [(i, s, d) for i, (_, s, d, _) in enumerate(fields) if target.sends(s, d) is None]
    for index, set, descriptor in unknown:
        if descriptor and not types(set, descriptor) and not types(SHARED_SET, descriptor):
            text = f"0x{descriptor:02X} is not a field of {data_name(set, 0)}"
            return Cause(index, set, descriptor, UNDEFINED, text)
    for index, set, descriptor in unknown if target.profile else ():
        text = f"{_title(target)} is not known to send {data_name(set, descriptor)}"
        return Cause(index, set, descriptor, UNLISTED, text)
    return None


def _absent(target: ConnectedDevice, set: int, descriptor: int) -> str:
    why = target.profile.why(set, descriptor) if target.profile else None
    absence = why.absence if why else ""
    return f"{_title(target)} {absence or f'does not send {data_name(set, descriptor)}'}"


def _title(target: ConnectedDevice) -> str:
    return target.profile.title if target.profile else "the device"


def data_name(set: int, descriptor: int) -> str:
    """Returns the name of a field, or with descriptor 0, of a set; numbers if it has none."""
    of = SETS[set][0] if set in SETS else f"set 0x{set:02X}"
    if not descriptor:
        return of
    kinds = types(set, descriptor)
    return kinds[0].name_in(set) if kinds else f"{of} 0x{descriptor:02X}"


def ask_and_find_cause(command: Command, target: ConnectedDevice) -> Dialog[Cause | None]:
    """Asks the device what it is and what it sends, once, and returns the cause of a rejection."""
    key = (command.SET, command.DESCRIPTOR)
    if key not in ALTERNATIVES and not any(True for _ in listed(command)):
        return None
    start = session()
    if start is not None and not target.asked:
        from .devices import identify  # imports most sets

        target.asked = True
        try:
            about = information((yield Step(start.identify())))
            target.profile = target.profile or identify(about)
            fields: set[tuple[int, int]] = set()
            for kind in (make() for make in start.descriptors):
                if not fields or (kind.SET, kind.DESCRIPTOR) in fields:
                    reply = yield Step(kind)
                    fields |= {divmod(number, 0x100) for number in reply.descriptors}
            target.descriptors = fields
        except MipError:  # the profile helps alone; a list of which a part is missing shows nothing
            pass
    return find_cause(command, target)


def with_cause(dialog: Dialog[T], target: ConnectedDevice) -> Dialog[T]:
    """Does what a dialog does, and adds the cause to its error if the device rejects a command."""
    try:
        return (yield from dialog)
    except Refused as refused:
        why = yield from ask_and_find_cause(refused.command, target)
        if why is not None and why.reason == ABSENT:
            why = replace(why, text=why.text + _clocks(why, target))
        # By name: a specification may have no such code.
        elif why is None and refused.code.name == "INVALID_PARAMETER":
            why = _out_of_range(refused.command)
        raise Refused(refused.command, refused.code, refused.outcomes, why) from None


def _clocks(why: Cause, target: ConnectedDevice) -> str:
    """Says which clocks the device has, if the field that it lacks is a timestamp."""
    missing = clocks_of(why.set, why.descriptor)
    if not missing:
        return ""
    sent = [d for s, d in TIMESTAMPS if s in (why.set, SHARED_SET) and target.sends(why.set, d)]
    has = dict.fromkeys(clock for d in sent for clock in clocks_of(why.set, d))
    return f" (clock: {' or '.join(missing)}); it has the clocks: {', '.join(has) or 'none'}"


def _out_of_range(command: Command) -> Cause | None:
    """Returns the first value that is out of its documented range, which is not known where it
    depends on the device."""
    for p in command.INFO.parameters:
        limits = {x for v in p.variants if v.by == "device" for x in v.changes}
        varies = limits & {"minimum", "maximum", "above", "below"}
        if p.derived or varies or not (here := p.of(command)).range:
            continue
        low = max((x for x in (here.minimum, here.above) if x is not None), default=-inf)
        high = min((x for x in (here.maximum, here.below) if x is not None), default=inf)
        value = getattr(command, p.attribute)
        for number in value if isinstance(value, tuple) else (value,):
            # Limits are rounded as the values are: pi is rounded up.
            if isinstance(number, (int, float)) and not (
                low - abs(low) * 1e-6 <= number <= high + abs(high) * 1e-6
                and number not in (here.above, here.below)
            ):
                text = f"{p.attribute} is {number:g}, its range is {here.range}"
                return Cause(0, command.SET, command.DESCRIPTOR, RANGE, text)
    return None


def received(tickets: Sequence[Ticket]) -> Dialog[tuple[Response | None, ...]]:
    """Like `responses`, for `with_cause`."""
    yield from ()
    return responses(tickets)
