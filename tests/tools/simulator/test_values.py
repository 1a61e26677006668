"""Encoders: every data field of every device is there, within its ranges, with correct valid flags."""

from __future__ import annotations

from collections.abc import Iterator
from enum import IntEnum, IntFlag
from math import isclose, isfinite
from typing import Any

import pytest
from mip_protocol import devices, reflection
from mip_protocol.parameter import Parameter
from mip_protocol.profile import Device
from mip_simulator.commands import knowledge
from mip_simulator.motion import Circle, Motion, Standing
from mip_simulator.streams.values import encoder
from mip_simulator.world import quantities
from mip_simulator.world.world import World
from mip_tools.devices import facts
from mip_tools.devices.names import value_named
from random_values import chance
from simulated import SETS, TYPES, profile
from support import model, rounds

PROFILES = list(devices.DEVICES.values())

#: Parameters without a value, as the comment of spec/simulation/values.yaml says; except reserved ones and flags.
WITHOUT = {
    "system_data.built_in_test.result",
    "sensor.pps_timestamp_with_flags.flags",
    "displacement_data.timestamp.time",
    "gnss_data.gps_iono_correction.alpha",
    "gnss_data.gps_iono_correction.beta",
    "gnss_data.galileo_iono_correction.alpha",
    "gnss_data.galileo_iono_correction.disturbance_flags",
    "gnss_data.beidou_iono_correction.alpha",
    "gnss_data.beidou_iono_correction.beta",
    "gnss_data.beidou_iono_correction.alpha_correction",
}


UNITS = {q.name: q.unit for q in model("real").simulation.quantities}


def test_the_runtime_has_the_quantities_of_the_specification() -> None:
    """The runtime has the quantities of the world and those of the device, and no others."""
    assert set(quantities.QUANTITIES) | set(knowledge.QUANTITIES) == set(UNITS)
    assert not set(quantities.QUANTITIES) & set(knowledge.QUANTITIES)
    assert facts.NOISE.keys() | quantities.INTERVALS | quantities.MEANS <= quantities.QUANTITIES.keys()


def test_every_parameter_shows_something() -> None:
    own = [f for f in model("real").fields if f.role == "data"]
    missing = set()
    for f in own:
        shown = facts.VALUES.get(f.full_name)
        flags = {name.partition(".")[0] for p in f.parameters for name in p.valid}
        for p in f.parameters:
            if p.reserved is None and p.name not in flags and (shown is None or p.name not in shown.parameters):
                missing.add(f"{f.full_name}.{p.name}")
    assert missing == WITHOUT


# --------------------------------------------------------------------------- every field of every device


def sent(device: Device) -> Iterator[tuple[int, Any]]:
    """Sets and types of the data fields that the device has, including those that it may have."""
    sets = sorted({s for s, _ in device.fields if 0x80 <= s < 0xFF})
    for name, kind in TYPES.items():
        if (SETS[name], kind.DESCRIPTOR) in device.fields:
            yield (sets[0] if SETS[name] == 0xFF else SETS[name]), kind


def numbers(value: Any, p: Parameter) -> Iterator[float]:
    """All numbers of a parameter."""
    if isinstance(value, (tuple, list)):
        for item in value:
            yield from numbers(item, p)
    else:
        yield value


def check_ranges(name: str, value: Any, p: Parameter) -> None:
    for x in numbers(value, p):
        assert isfinite(x), name
        assert p.minimum is None or x >= p.minimum, (name, x)
        assert p.maximum is None or x <= p.maximum, (name, x)
        assert p.above is None or x > p.above, (name, x)
        assert p.below is None or x < p.below, (name, x)
    if "uncertainty" in p.name or "accuracy" in p.name:
        assert all(x > 0 for x in numbers(value, p)), name


def check_names(name: str, value: Any, kind: Any) -> None:
    """Enumerations have only values with names, bitfields only bits with names."""
    if isinstance(kind, type) and issubclass(kind, IntEnum):
        assert value in [member.value for member in kind], (name, value)
    elif isinstance(kind, type) and issubclass(kind, IntFlag) and isinstance(value, int):
        every = 0
        for member in kind.__members__.values():
            every |= member
        assert not int(value) & ~int(every), (name, value)


def check_flags(name: str, source: facts.FieldValues, field: Any, device: Device) -> None:
    """Flags are set exactly for what has a value, as far as the device has the flags."""
    for p in reflection.info(type(field)).parameters:
        for said in p.valid:
            flags, _, bit = said.partition(".")
            value = getattr(field, flags)
            kind = device.readings.get(f"{name}.{flags}") or type(value)
            mask = value_named(kind, (bit,)) if bit else 1
            assert kind is not type(value) or mask, said
            assert not mask or bool(value & mask) == (p.name in source.parameters), (name, said)


#: The device with the most data. Models of one family send nearly the same fields, so that it and a few that the seed
#: draws find what all would.
FULL = "3dm-cv7-gnss-ins"
DRAWN = [profile(FULL), *chance("devices with values").sample(PROFILES, rounds(2, len(PROFILES)))]


@pytest.mark.parametrize("motion", [Standing(), Circle(25, 8, -35.0, -120.0, 2000.0)], ids=["standing", "circle"])
@pytest.mark.parametrize("device", DRAWN, ids=lambda d: d.id)
def test_every_data_field_of_every_device(device: Device, motion: Motion) -> None:
    world = World(motion, seed=7)
    encoders = [(set_number, kind, encoder(kind, device, world, set_number)) for set_number, kind in sent(device)]
    assert device.id != FULL or len(encoders) > 100
    for time in (0, 1_000_000, 3_600_000_000_000, 86_400 * 365 * 10**9):
        world.move_to(time)
        for set_number, kind, encode in encoders:
            found, full = encode(), kind.name_in(set_number)
            assert found, full
            for data in found:
                field, trailing = kind.decode_with_trailing(data)
                assert trailing == 0 and field.encode() == data
                source = facts.value_sources(kind, set_number)
                if source.valid_if and not quantities.quantity(world, source.valid_if):
                    assert not any(data), f"{full}: values that are not valid"
                    continue
                if not source.parameters:
                    assert not any(data), f"{full}: zeros without a value"
                    continue
                check_flags(kind.NAME, source, field, device)
                for p in reflection.info(kind).parameters:
                    name = f"{kind.NAME}.{p.name}"
                    value = getattr(field, p.attribute)
                    check_ranges(name, value, p)
                    check_names(name, value, device.readings.get(name) or p.type)


# --------------------------------------------------------------------------- particular rules


def test_values_of_the_device_itself() -> None:
    """The state of the filter is that of the device's own enumeration."""
    for name, wanted in (("3dm-cv7-gnss-ins", (4, 1, 1)), ("3dm-gx5-15", (2, 1, 0))):
        world = World(Standing())
        kind = TYPES["filter_data.status"]
        s = kind.decode(encoder(kind, profile(name), world, SETS["filter_data.status"])()[0])
        assert (s.filter_state, s.dynamics_mode, s.status_flags) == wanted, name
    kind = TYPES["sensor.gps_timestamp"]
    flags = [
        kind.decode(encoder(kind, profile(name), World(Standing()), SETS["sensor.gps_timestamp"])()[0]).valid_flags
        for name in ("3dm-gx5-15", "3dm-cv7-gnss-ins")
    ]
    assert [int(f) for f in flags] == [0b00101, 0b11101], "5-series devices have no bits for the values"


def test_names_of_bits_and_values() -> None:
    status = reflection.info(TYPES["filter_data.status"]).parameters[2]
    kind = profile().readings["filter_data.status.status_flags"]
    assert status.type is None and value_named(kind, ("filter_condition.stable",)) == 1
    assert value_named(kind, ("filter_condition.unstable", "heading_warning", "nothing")) == 0b1011
    assert value_named(kind, ("nothing.stable",)) == 0 == value_named(None, ("stable",))
    fix = reflection.info(TYPES["gnss_1.fix_info"]).parameters[0].type
    assert value_named(fix, ("unheard_of", "fix_rtk_float", "fix_3d")) == 5


#: Unit on the wire and of the quantity -> what the quantity is multiplied by; all others have one unit.
FACTORS = {
    ("g", "m/s^2"): 1 / 9.80665,
    ("g*s", "m/s"): 1 / 9.80665,
    ("deg", "rad"): 57.29577951308232,
    ("s", "ns"): 1e-9,
}


def test_factors_of_units() -> None:
    used = set()
    for name, source in facts.VALUES.items():
        if name not in TYPES:
            continue
        parameters = {p.name: p for p in reflection.info(TYPES[name]).parameters}
        for path, value in source.parameters.items():
            if not value.quantity:
                continue
            units = set(parameters[path].units)
            unit = UNITS[value.quantity]
            if units and unit is not None and units != {unit}:
                (pair,) = {(u, unit) for u in units}
                used.add(pair)
                assert isclose(value.factor, FACTORS[pair], rel_tol=1e-12), (name, path)
            else:
                assert value.factor == 1, (name, path)
    assert used == FACTORS.keys()
