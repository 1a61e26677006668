"""Encodes values of the world as data fields, as the specification defines."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from dataclasses import replace
from enum import IntEnum, IntFlag
from typing import Any

from mip_tools.binding import SCALARS, Device, Field, Parameter, reflection, registry
from mip_tools.devices.facts import FieldValues, Value, value_sources
from mip_tools.devices.names import value_named
from mip_tools.devices.settings import filled

from ..motion.replay import Replay
from ..surroundings.surroundings import Output
from ..world.quantities import INTERVALS, MEANS, QUANTITIES
from ..world.receivers import Function
from ..world.world import World

#: Returns the numbers of one parameter of an item.
Reader = Callable[[Any], "tuple[Any, ...]"]
Encoder = Callable[[], "list[bytes]"]

#: The largest float of four bytes.
LARGEST = (2 - 2**-23) * 2.0**127

#: Quantities of clocks. Fields that contain nothing else are not replayed from a log.
_CLOCKS = ("gps.", "clock.", "utc.", "reference.", "external.", "ticks.", "event.")


def encoder(kind: type[Field], profile: Device, world: World, set_number: int) -> Encoder:
    """Makes the encoder of a field, which returns the data of the fields to send now, without lengths and descriptors.

    `set_number` is the set of the packets.
    """
    if not all(_packs(p) for p, _ in _flat(kind)):
        unchanging = _defaults(kind)
        return lambda: [unchanging]
    source = _computed(value_sources(kind, set_number))
    simulated = _encoder(kind, profile, world, set_number, source)
    motion = world.motion
    if not isinstance(motion, Replay) or not _recorded(source):
        return simulated
    descriptor = kind.DESCRIPTOR
    return lambda: motion.recorded(set_number, descriptor, world.time) or simulated()


#: Sensor or estimate -> the quantity that a device with it has in its data fields.
_SENSES = {
    "mag": "measured.magnetic_field", "pressure": "measured.pressure", "position": "position.latitude",
    "gnss_1": "gnss_1.latitude", "gnss_2": "gnss_2.latitude",
}  # fmt: skip


def senses(profile: Device) -> frozenset[str]:
    """Returns the sensors of the device, and `position` if its filter estimates one."""
    quantities: set[str] = set()
    for number, kind in registry.all_types():
        if (number, kind.DESCRIPTOR) in profile.fields:
            quantities.update(v.quantity for v in value_sources(kind, number).parameters.values())
    return frozenset(sense for sense, quantity in _SENSES.items() if quantity in quantities)


def _packs(p: Parameter) -> bool:
    """Does the parameter consist of a fixed number of numbers?"""
    is_fixed = p.kind in ("scalar", "constant", "array") and isinstance(p.length, (int, type(None)))
    return is_fixed and p.scalar in SCALARS


def _defaults(kind: type[Field]) -> bytes:
    """Encodes defaults for a field that has texts, counted arrays, or arrays of structures."""
    values: dict[str, Any] = {}
    for p in reflection.info(kind).parameters:
        if p.kind not in ("constant", "counter"):
            values[p.attribute] = filled(p, values, p.default)
    return kind(**values).encode()


def _computed(source: FieldValues) -> FieldValues:
    """Leaves out quantities of another specification, which the world does not compute: their values are defaults."""

    def known(name: str) -> bool:
        return not name or name in QUANTITIES

    return replace(
        source,
        parameters={path: value for path, value in source.parameters.items() if known(value.quantity)},
        for_each=source.for_each if known(source.for_each) else "",
        valid_if=source.valid_if if known(source.valid_if) else "",
    )


def _recorded(source: FieldValues) -> bool:
    names = [v.quantity for v in source.parameters.values() if v.quantity]
    return not names or any(not name.startswith(_CLOCKS) for name in names)


def _encoder(kind: type[Field], profile: Device, world: World, set_number: int, source: FieldValues) -> Encoder:
    readers, layout = _readers(kind, profile, world, source)
    pack = _packer(layout)
    encode = _valid_encoder(kind, profile, world, set_number, source, readers, pack)
    if not source.valid_if:
        return encode
    valid, nothing = QUANTITIES[source.valid_if], bytes(struct.calcsize(">" + layout))
    return lambda: encode() if valid(world, None) else [nothing]


def _valid_encoder(
    kind: type[Field],
    profile: Device,
    world: World,
    set_number: int,
    source: FieldValues,
    readers: list[Reader],
    pack: Callable[..., bytes],
) -> Encoder:
    if source.for_each:
        items = QUANTITIES[source.for_each]
        return lambda: [pack(*_joined(readers, item)) for item in items(world, None)]
    rate = profile.base_rates.get(set_number) or 0.0
    counting = [v.quantity for v in source.parameters.values() if v.quantity in INTERVALS]
    means = any(v.quantity in MEANS for v in source.parameters.values())
    if not counting and not means:
        plain = Output(rate)
        if len(readers) == 1:
            (only,) = readers
            return lambda: [pack(*only(plain))]
        return lambda: [pack(*_joined(readers, plain))]
    output = world.output(set_number, counting[0], rate) if counting else Output(rate)

    def encode() -> list[bytes]:
        output.begin(world)
        chunks = [pack(*_joined(readers, output))]
        output.end(world)
        return chunks

    return encode


def _packer(layout: str) -> Callable[..., bytes]:
    pack = struct.Struct(">" + layout).pack

    def packed(*numbers: Any) -> bytes:
        try:
            return pack(*numbers)
        except OverflowError:  # a setting can lead beyond what a float of four bytes holds
            return pack(*(min(max(x, -LARGEST), LARGEST) for x in numbers))

    return packed


def _joined(readers: list[Reader], item: Any) -> tuple[Any, ...]:
    values: tuple[Any, ...] = ()
    for read in readers:
        values += read(item)
    return values


def _readers(kind: type[Field], profile: Device, world: World, source: FieldValues) -> tuple[list[Reader], str]:
    """Makes the readers of the parameters, with neighbouring constants in one, and their layout."""
    readers: list[Reader] = []
    constants: tuple[Any, ...] = ()
    layout = ""
    for p, path in _flat(kind):
        count = (p.length if isinstance(p.length, int) else 1) * (len(p.elements) or 1)
        letter = SCALARS[p.scalar].letter
        layout += letter * count
        type_ = profile.readings.get(f"{kind.NAME}.{path}") or p.type
        read = _reader(p, source.parameters.get(path), letter, count, type_, world)
        flags = source.parameters.get(path)
        if count == 1 and isinstance(type_, type) and issubclass(type_, IntFlag) and not (flags and flags.quantity):
            read = _with(read, _valid(kind, source, path, type_))
        if isinstance(read, tuple):
            constants += read
            continue
        if constants:
            readers.append(_always(constants))
            constants = ()
        readers.append(read)
    if constants:
        readers.append(_always(constants))
    return readers, layout


def _flat(kind: type, prefix: str = "") -> Iterator[tuple[Parameter, str]]:
    """Yields parameters with their paths; structures are replaced by their parameters."""
    for p in reflection.info(kind).parameters:
        if p.kind == "struct" and p.length is None:
            yield from _flat(p.type, f"{prefix}{p.name}.")
        else:
            yield p, prefix + p.name


def _always(values: tuple[Any, ...]) -> Reader:
    return lambda item: values


def _valid(kind: type[Field], source: FieldValues, flags: str, type_: type[IntFlag]) -> int:
    """Returns the valid flags of all parameters that have a source."""
    bits = 0
    for p in reflection.info(kind).parameters:
        for flag in p.valid if p.name in source.parameters else ():
            name, _, bit = flag.partition(".")
            if name == flags and bit:
                bits |= value_named(type_, (bit,))
    return bits


def _with(read: Reader | tuple[Any, ...], flags: int) -> Reader | tuple[Any, ...]:
    if isinstance(read, tuple):
        return (read[0] | flags,)
    return lambda item: (read(item)[0] | flags,)


def _reader(
    p: Parameter, value: Value | None, letter: str, count: int, type_: Any, world: World
) -> Reader | tuple[Any, ...]:
    """Makes the reader of a parameter; if its numbers never change, returns them instead."""
    if p.constant is not None:
        return (p.constant,) * count
    if value is None:
        return _numbers(p.default if p.default is not None else 0, letter, count)
    if not value.quantity:
        return _numbers(_constant(value, type_), letter, count)
    function, factor = QUANTITIES[value.quantity], value.factor
    if isinstance(type_, type) and issubclass(type_, (IntEnum, IntFlag)):
        return _names(function, type_, world)
    if letter not in "fd":
        return _whole(function, factor, letter, count, world)
    if count == 1:
        if factor == 1:
            return lambda item: (function(world, item),)
        return lambda item: (function(world, item) * factor,)
    if count == 3:
        return _vector(function, factor, world)
    return lambda item: tuple([x * factor for x in function(world, item)])


def _constant(value: Value, type_: Any) -> Any:
    """Returns the number or the text of a value that is not a quantity."""
    if value.text is not None:
        return tuple(value.text.encode("latin-1"))
    if value.number is not None:
        return value.number
    return value_named(type_, value.names or value.bits)


def _numbers(value: Any, letter: str, count: int) -> tuple[Any, ...]:
    """Returns one number for each element; a single number applies to all."""
    values = tuple(value) if isinstance(value, (tuple, list)) else (value,) * count
    kind = float if letter in "fd" else int
    return tuple(kind(x) for x in (values + (0,) * count)[:count])


def _vector(function: Function, factor: float, world: World) -> Reader:
    def read(item: Any) -> tuple[Any, ...]:
        x, y, z = function(world, item)
        return x * factor, y * factor, z * factor

    return read


def _whole(function: Function, factor: float, letter: str, count: int, world: World) -> Reader:
    """Makes a reader of integers, rounded, and limited to the range of the type."""
    bits = 8 * struct.calcsize(letter)
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if letter.islower() else (0, (1 << bits) - 1)

    def fitting(x: Any) -> int:
        whole: int = round(x * factor) if factor != 1 else round(x)
        return min(max(whole, low), high)

    if count == 1:
        return lambda item: (fitting(function(world, item)),)
    return lambda item: tuple([fitting(x) for x in function(world, item)])


def _names(function: Function, type_: type[IntEnum] | type[IntFlag], world: World) -> Reader:
    """Makes a reader that converts names to numbers; the quantity may also be a number."""

    def read(item: Any) -> tuple[Any, ...]:
        value = function(world, item)
        if isinstance(value, int):
            return (value,)
        return (value_named(type_, (value,) if isinstance(value, str) else tuple(value)),)

    return read
