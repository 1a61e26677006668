"""The device that sends data, as far as it is known: named by the user, asked at the port, or found in the data."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache, reduce
from operator import or_
from typing import Any

from ..binding import (
    DEVICES,
    BitsInfo,
    DecodeError,
    Field,
    MipError,
    Packet,
    PacketError,
    Parameter,
    UnknownName,
    device_id,
    identify,
    info,
    registry,
)

#: The field with which a device identifies itself, and its command.
IDENTITY, _COMMAND = "base.get_device_info_response", "base.get_device_info"
#: Seconds to wait for a reply. Ports may also be those of programs that only send.
_PATIENCE = 1.0


def in_words(names: Sequence[str]) -> str:
    """Lists names in a sentence: `a`, `a and b`, `a, b and c`."""
    return " and ".join([", ".join(names[:-1])] * (len(names) > 1) + [*names[-1:]])


def identity_type() -> Any:
    """Returns the type of the field with which a device identifies itself; None if the specification has none."""
    try:
        return registry.by_name(IDENTITY)
    except UnknownName:
        return None


# The cached functions are apart, because mypy takes a class of fields for something without a hash.


def read_by_device(kind: Any) -> dict[str, dict[str, Parameter]]:
    """Returns the parameters whose flags or names depend on the device, by attribute, as they are on each device."""
    return _read_by_device(kind)


@cache
def _read_by_device(kind: Any) -> dict[str, dict[str, Parameter]]:
    made = {p.attribute: {device: p.on(device) for device in DEVICES} for p in info(kind).parameters}
    return {name: on for name, on in made.items() if len({(p.type, p.flags) for p in on.values()}) > 1}


def named_by_device(kind: Any) -> dict[str, dict[str, Any]]:
    """Returns the parameters whose names depend on the device, by attribute, with their types on each device."""
    return _named_by_device(kind)


@cache
def _named_by_device(kind: Any) -> dict[str, dict[str, Any]]:
    types = {name: {device: p.type for device, p in on.items()} for name, on in read_by_device(kind).items()}
    return {name: on for name, on in types.items() if len(set(on.values())) > 1}


class KnownDevice:
    """What is known of the device so far.

    If it is unknown, all its fields, flags and values so far decide together how they are read: as on the devices that
    explain most of them.
    """

    def __init__(self, named: str | None = None, at_port: str | None = None) -> None:
        """`at_port` is the id of the device that replied at a port."""
        #: The id of the device that was named.
        self.named = None if named is None else device_id(named)
        self._devices = {at_port: "at the port"} if at_port else {}  # id -> where it was found
        self._reported: set[str] = set()
        # The fields that a device does not have, and the parameters whose values have no meaning on it.
        self._against: dict[str, set[Any]] = {device: set() for device in DEVICES}
        self._fields: set[tuple[int, int]] = set()
        self._values: dict[tuple[type[Field], str], set[int]] = {}
        self._alike: dict[type[Field], list[str]] = {}  # the results of `_readers`

    @property
    def id(self) -> str | None:
        """The id of the device; None if it is not known, or if several sent the data."""
        return self.named or (next(iter(self._devices)) if len(self._devices) == 1 else None)

    @property
    def titles(self) -> list[str]:
        """The names of the devices that have replied."""
        return [DEVICES[device].title for device in self._devices]

    def ask(self, port: Any) -> bool:
        """Asks the device at an open port, which may not reply. Returns True: what it sends meanwhile is kept."""
        if self.named is None and identity_type() is not None:
            try:
                self.add_reply(port.request(registry.by_name(_COMMAND)(), timeout=_PATIENCE), "at the port")
            except (MipError, OSError):
                pass
        return True

    def learn(self, packet: Packet) -> None:
        """Searches a packet that has arrived."""
        identity = identity_type()
        if self.named is None and identity is not None and packet.set == identity.SET:
            for field in registry.decode_packet(packet):
                if isinstance(field, identity):
                    self.add_reply(field, "from the log")
        elif self.id is None and packet.set >= 0x80:
            try:
                for raw in packet:
                    self.add_fields([(raw.set, raw.descriptor)])
                    for kind in registry.types(raw.set, raw.descriptor):
                        if named_by_device(kind):
                            value = kind.decode(raw.data)
                            self.add_values(kind, {name: [_number(value, name)] for name in named_by_device(kind)})
            except (DecodeError, PacketError):
                pass

    def add_fields(self, fields: Iterable[tuple[int, int]]) -> None:
        """Adds data fields that the device sends, by set and descriptor."""
        for key in set(fields) - self._fields:
            self._fields.add(key)
            for device, reasons in self._against.items():
                if not DEVICES[device].has(*key):
                    reasons.add(key)
            self._alike.clear()

    def add_values(self, kind: type[Field], values: dict[str, Iterable[int]]) -> None:
        """Adds values of the parameters of a field that are `named_by_device`, by attribute."""
        for name, numbers in values.items():
            key, types = (kind, name), named_by_device(kind)[name]
            seen = self._values.setdefault(key, set())
            for value in set(numbers) - seen:
                seen.add(value)
                meant = {each: each is not None and _means(info(each), value) for each in set(types.values())}
                for device, reasons in self._against.items():
                    if not meant[types[device]]:
                        reasons.add(key)
                self._alike.clear()

    # ----------------------------------------------------------------- how fields are read

    def reads(self, kind: type[Field]) -> str | None:
        """Returns the id of the device as which a field is read: the device itself, else one that stands for all that
        may have sent the data, if they read the field alike."""
        if self.id is not None or len(self._devices) > 1 or not read_by_device(kind):
            return self.id
        return next(iter(self._readers(kind)), None)

    def recognized(self, kind: type[Field], p: Parameter) -> Parameter:
        """Returns a parameter of a field as it is read."""
        device = self.reads(kind)
        if device is not None:
            return p.on(device)
        return p.recognized(self._bits(kind, p)) if p.readings else p

    def _bits(self, kind: type[Field], p: Parameter) -> int:
        """Returns all flags for a parameter so far."""
        return reduce(or_, (value for name in p.holders for value in self._values.get((kind, name), ())), 0)

    def _readers(self, kind: type[Field]) -> list[str]:
        """Returns the devices that may have sent the data if they read a field alike, else none."""
        if kind not in self._alike:
            types = named_by_device(kind).values()
            likely = [device for device in self._likely() if all(each[device] is not None for each in types)]
            same = all(len({(on[d].type, on[d].flags) for d in likely}) == 1 for on in read_by_device(kind).values())
            self._alike[kind] = likely if same else []
        return self._alike[kind]

    def _likely(self) -> list[str]:
        """Returns the devices that explain most of the data."""
        against = {device: len(reasons) for device, reasons in self._against.items()}
        for kind in {kind for kind, _ in self._values}:
            others = self._flagged(kind)
            for device in against if others else ():
                against[device] += device not in others
        return [device for device, count in against.items() if count == min(against.values())]

    def _flagged(self, kind: type[Field]) -> tuple[str, ...]:
        """Returns the devices on which the flags in a field mark values as valid, if these are not the usual ones."""
        for p in info(kind).parameters:
            bits = self._bits(kind, p)
            here = p.recognized(bits).flags if bits else p.flags
            if here != p.flags:
                return next(r.devices for r in p.readings if r.flags == here)
        return ()

    def _assumed(self, names: bool) -> dict[type[Field], tuple[str, ...]]:
        """Returns the devices as which fields are read, if that makes a difference: to `names`, or only to validity."""
        assumed = {}
        for kind in dict.fromkeys(kind for kind, _ in self._values):
            device = self.reads(kind)
            usual = {p.attribute: p for p in info(kind).parameters}
            if device is None:
                devices = self._flagged(kind)
            else:
                here = [(on[device], usual[name]) for name, on in read_by_device(kind).items()]
                differs = any(p.flags != q.flags or (names and p.type != q.type) for p, q in here)
                devices = tuple(self._readers(kind) if differs else ())
            if devices:
                assumed[kind] = devices
        return assumed

    def add_reply(self, reply: Any, where: str) -> None:
        """Adds what a device replied."""
        profile = identify(reply.device_info) if hasattr(reply, "device_info") else None
        if profile is not None:
            self._devices.setdefault(profile.id, where)

    def lines(self, names: bool = True) -> list[str]:
        """Says in a line what is assumed about the device; `names`: does the output name values?"""
        others = [title for title in self.titles if self.named is None or title != DEVICES[self.named].title]
        found = in_words(others)
        if self.named is not None:
            where = next(iter(self._devices.values()), "")
            title = DEVICES[self.named].title
            return [f"device {title} (named), although it is a {found} {where}"] if others else []
        if len(others) > 1:
            return [f"{len(others)} devices in the log, {found}: flags are read as those of no known device"]
        if others:
            return [f"device {found} ({next(iter(self._devices.values()))})"]
        fields: dict[str, list[str]] = {}
        for kind, devices in self._assumed(names).items():
            fields.setdefault(_those_of(devices), []).append(kind.NAME)
        return [f"{', '.join(kinds)}: flags read as those of {those} (recognized)" for those, kinds in fields.items()]

    def news(self, names: bool = True) -> list[str]:
        """Returns the lines that no earlier call has returned."""
        new = [text for text in self.lines(names) if text not in self._reported]
        self._reported.update(new)
        return new


def _number(value: Field, name: str) -> int:
    number = getattr(value, name)
    return number if isinstance(number, int) else int.from_bytes(bytes(number), "little")


def _means(about: Any, value: int) -> bool:
    """Has a value of an enumeration, or each part of a bitfield, a meaning?"""
    if not isinstance(about, BitsInfo):
        return value in about.names
    parts = [(bit.type, (value & bit.mask) >> bit.first) for bit in about.bits if bit.type is not None]
    known = sum(bit.mask for bit in about.bits if not bit.alias)
    return not value & ~known and all(part in info(kind).names for kind, part in parts)


def _those_of(devices: tuple[str, ...]) -> str:
    """Names devices by their generations."""
    generations = sorted({DEVICES[device].generation or 0 for device in devices})
    if not all(generations):
        return in_words([DEVICES[device].title for device in devices])
    return f"generation{'s' * (len(generations) > 1)} {in_words([*map(str, generations)])}"


__all__ = ["IDENTITY", "KnownDevice", "identity_type", "in_words", "named_by_device", "read_by_device"]
