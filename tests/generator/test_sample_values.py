"""Sample values: documentation shows values that a user would send or see."""

from __future__ import annotations

import dataclasses
import itertools
import math
import struct
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest
from mipgen import model as m
from mipgen.facts import descriptors
from mipgen.facts.sample_values import SampleValues
from mipgen.lower import codec
from support import model, some

#: What the real specification does not state, and why a simple number is right there.
_COUNTERS = "no source shows a value; counters of a device that was just switched on"
MADE_UP: dict[str, str] = {
    **{
        f"3dm.device_status_diagnostic_{sensor}_response.{name}": _COUNTERS
        for sensor in ("gx4_imu", "rq1_imu")
        for name in (
            "imu_stream_enabled", "comm_port_bytes_written", "comm_port_bytes_read", "comm_port_write_overruns",
        )
    },
    "3dm.device_status_diagnostic_gx4_imu_response.system_timer": _COUNTERS,
    "displacement_data.timestamp.flags": "no source says what its bits mean",
}  # fmt: skip


@cache
def samples(spec: str) -> SampleValues:
    return SampleValues(model(spec))


def every(spec: str) -> Iterator[tuple[m.Field, m.Call, codec.Values]]:
    for f in model(spec).fields:
        for call in f.calls:
            yield f, call, samples(spec).values(f, call)


def leaves(
    parameters: tuple[m.Parameter, ...], values: codec.Values
) -> Iterator[tuple[m.Parameter, Any, codec.Values]]:
    """Parameters with their values and the record that they are in, those of structures and unions, too."""
    for p in parameters:
        if p.name not in values:
            continue
        value = values[p.name]
        if isinstance(p.element, m.Struct):
            for one in value if isinstance(value, list) else [value]:
                yield from leaves(p.element.parameters, one)
        elif p.cases:
            yield from leaves(tuple(c.parameter for c in p.cases if c.parameter), value)
        yield p, value, values


def numbers(value: Any) -> list[float]:
    """Floats, from their bits."""
    if isinstance(value, list):
        return [x for one in value for x in numbers(one)]
    raw = [bytes.fromhex(value[2:])]
    return [struct.unpack(">f" if len(x) == 4 else ">d", x)[0] for x in raw]


def test_nothing_is_made_up() -> None:
    found = {f"{f.full_name}.{path}": "" for f, call, _ in every("real") for path in samples("real").made_up(f, call)}
    assert found.keys() == MADE_UP.keys()


@pytest.mark.parametrize("spec", ["real", "invented"])
def test_they_are_within_their_ranges(spec: str) -> None:
    for f, call, values in every(spec):
        codec.encode(f, values)
        assert {p.name for p in call.required if p.constant is None} | ({"function"} if f.selector else set()) == {
            *values
        }
        whole = samples(spec).whole(f, call)
        codec.encode(f, ({"function": call.function.value} if call.function else {}) | whole)
        for p, value, _ in leaves(f.parameters, whole) if spec == "real" else ():  # examples of the other break rules
            scalar = p.element.scalar if isinstance(p.element, m.Vector) else p.element
            if not isinstance(scalar, m.Scalar) or (isinstance(value, str) and scalar.kind == "char"):
                continue
            found = numbers(value) if scalar.kind == "float" else value if isinstance(value, list) else [value]
            for number in found:
                where = f"{f.full_name}.{p.name} = {number}"
                assert p.minimum is None or number >= p.minimum or math.isclose(number, p.minimum, rel_tol=1e-6), where
                assert p.maximum is None or number <= p.maximum or math.isclose(number, p.maximum, rel_tol=1e-6), where
                assert (p.above is None or number > p.above) and (p.below is None or number < p.below), where


def allows(v: m.Variant, p: m.Parameter, value: Any) -> bool:
    """Is it one of the values that a parameter may have, as a variant says?"""
    scalar = p.element.scalar if isinstance(p.element, m.Vector) else p.element
    found = numbers(value) if isinstance(scalar, m.Scalar) and scalar.kind == "float" else value
    each = found if isinstance(found, list) else [found]
    named = v.type or p.element
    if isinstance(named, m.Enum):
        known = {x.value for x in v.only or named.values}  # type: ignore[union-attr]
        return all(one in known for one in each)
    if isinstance(named, m.Bitfield):
        mask = sum(x.mask for x in v.only or named.bits if not x.alias)  # type: ignore[union-attr]
        return all(not one & ~mask for one in each)
    if v.constant is not None:
        return all(one == v.constant for one in each)
    return all(
        (v.minimum is None or one >= v.minimum or math.isclose(one, v.minimum, rel_tol=1e-6))
        and (v.maximum is None or one <= v.maximum or math.isclose(one, v.maximum, rel_tol=1e-6))
        for one in each
    )


def sent() -> Iterator[tuple[m.Field, list[m.Device], codec.Values]]:
    """Every command as pages show it, and the devices that certainly support it in this form."""
    of = model("real")
    for f in of.fields:
        for call in samples("real").sent(f) if f.role == m.COMMAND else []:
            takers = [
                d for d, s in of.supports(f) if s.certain and (call.function is None or call.function in s.functions)
            ]
            yield f, takers, samples("real").values(f, call)


def test_no_device_refuses_them() -> None:
    """Each device that takes a command allows the values. Those by which devices are told apart, their model number
    and the names of their streams, are right for one."""
    seen, refused = 0, []
    for f, takers, values in sent():
        for p in f.parameters:
            own = {v.key: v for v in p.variants if v.by_device}
            if p.name not in values or not own:
                continue
            allowed = {d.id: d.id not in own or allows(own[d.id], p, values[p.name]) for d in takers}
            read = {(own[d.id].constant, own[d.id].type) if d.id in own else (None, None) for d in takers}
            seen += len(own)
            if not (any if len(read) > 1 else all)(allowed.values()):
                refused.append(f"{f.full_name}.{p.name} = {values[p.name]}, not on {allowed}")
    assert seen > 20 and not refused, refused


def named(p: m.Parameter, value: Any) -> list[int]:
    """The field descriptors in a value."""
    each = value if isinstance(value, list) else [value]
    if isinstance(p.element, m.Struct):
        return [one[q.name] for one in each for q in p.element.parameters if q.shown == "field"]
    return each


def test_devices_have_what_they_name() -> None:
    """The fields of a format, a poll, a trigger: every device that takes the command has them, if its profile is
    whole and it has the set."""
    of, seen, missing = model("real"), 0, []
    for f, takers, values in sent():
        for p, value, record in leaves(f.parameters, values):
            number = descriptors.set_of(p, record, of) if p.fields_of else None
            for d in (d for d in takers if number and not d.incomplete):
                has = {s.field.descriptor for s in d.certain if s.field.set in (number, m.SHARED_SET)}
                seen += 1
                missing += [f"{f.full_name}: 0x{one:02X} on {d.id}" for one in named(p, value) if one not in {0, *has}]
    assert seen > 10 and not missing, missing


def test_ports_have_their_baud_rates() -> None:
    for name in ("base.comm_speed", "3dm.uart_baud_rate"):
        for f, takers, values in sent():
            for d in takers if f.full_name == name and "baud" in values else ():
                ports = [x for x in d.ports if x.baud_rates and values.get("port") in (None, x.id)]
                assert any(values["baud"] in x.baud_rates for x in ports) or not ports, (name, d.id)


def test_rotations_are_rotations() -> None:
    """Quaternions have the norm 1; matrices that turn vectors, columns of length 1 at right angles."""
    seen = set()
    for f, _, values in every("real"):
        for p, value, _ in leaves(f.parameters, values):
            if not isinstance(p.element, m.Vector) or "uncertainty" in f"{f.name} {p.name}":
                continue
            found = numbers(value)
            if p.element.name == "quatf":
                assert math.isclose(math.hypot(*found), 1, abs_tol=1e-5), f.full_name
                seen.add("quatf")
            elif p.name in ("dcm", "m") and p.element.name == "matrix3f":
                rows = [found[0:3], found[3:6], found[6:9]]
                for (i, a), (j, b) in itertools.product(enumerate(rows), repeat=2):
                    assert math.isclose(sum(x * y for x, y in zip(a, b)), i == j, abs_tol=1e-3), f.full_name
                seen.add("matrix3f")
    assert seen == {"quatf", "matrix3f"}


def test_descriptors_are_known() -> None:
    """The descriptors in typical values exist, except for numbers with a special meaning: 0 often means all."""
    of, seen = model("real"), 0
    for f, _, values in every("real"):
        for p, value, record in leaves(f.parameters, values):
            number = descriptors.set_of(p, record, of)
            for one in value if isinstance(value, list) else [value]:
                if p.shown == "set" and one >= 0x80:
                    assert descriptors.named_by_value(p, one, None, of), f.full_name
                    seen += 1
                if p.shown == "field" and number is not None:
                    assert number < 0x80 or one == 0 or descriptors.named_by_value(p, one, number, of), (
                        f.full_name,
                        one,
                    )
                    seen += 1
    assert seen > 30


@pytest.mark.parametrize("spec", ["real", "invented"])
def test_data_is_valid(spec: str) -> None:
    """The flags of a value are set: otherwise, a program that checks them would skip what a page shows."""
    seen = 0
    for f, call, _ in every(spec):
        for p, _, record in leaves(f.parameters, samples(spec).whole(f, call)):
            for path in p.valid:
                name, _, bit = path.partition(".")
                flags, held = next(q.element for q in record_of(f.parameters, p) if q.name == name), record[name]
                seen += 1
                if not bit:
                    assert held == 1, (f.full_name, path)
                    continue
                assert isinstance(flags, m.Bitfield)
                bits = next(b for b in flags.bits if b.name == bit.partition(".")[0])
                number = int.from_bytes(bytes(held), "little") if isinstance(held, list) else held
                assert number & bits.mask, (f.full_name, path)
    assert seen > (300 if spec == "real" else 8)


def record_of(parameters: tuple[m.Parameter, ...], p: m.Parameter) -> tuple[m.Parameter, ...]:
    """The parameters beside one: those of a field or a structure."""
    if p in parameters:
        return parameters
    inside = (q.element.parameters for q in parameters if isinstance(q.element, m.Struct))
    return next((found for one in inside if (found := record_of(one, p))), ())


def test_what_a_reader_would_send() -> None:
    f = some(model("real").field("3dm.message_format"))
    assert samples("real").packet(f).hex() == "75650c0b0b0f01800204000a05000aab00"


def test_the_better_known_a_value_is_the_sooner_it_is_taken() -> None:
    """A typical value before a printed one, then the value of a simulated device, and a default last."""

    def value(name: str, path: str, **given: Any) -> Any:
        of = model("invented")
        f = some(of.field(name))
        own = tuple(dataclasses.replace(p, **given) if p.name == path else p for p in f.parameters)
        changed = dataclasses.replace(f, parameters=own)
        return SampleValues(of).values(changed, changed.calls[0])[path]

    assert value("tools.settings", "baud", default=4800) == 9600  # is printed
    assert value("tools.settings", "baud", typical=300) == 300
    assert value("measurements.numbers", "u8", default=77) != 77  # is shown
    assert value("measurements.numbers", "u16", default=77) == 77
    assert value("measurements.numbers", "u8", default=77, typical=78) == 78
