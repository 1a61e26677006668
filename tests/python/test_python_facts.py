"""The tables of the Python package say what the model says: of every device, and of every parameter."""

from __future__ import annotations

from typing import Any

import pytest
from mipgen import model as m
from mipgen.targets import python as target
from support import SPECS, all_fields, model
from test_python import Package, mip, real

both = pytest.mark.parametrize("spec", sorted(SPECS))


def package(spec: str) -> Package:
    return mip if spec == "invented" else real


def named(t: m.Type | None, of: Package) -> Any:
    """The class of a type."""
    if not isinstance(t, (m.Enum, m.Bitfield, m.Struct)):
        return None
    if t.name == "function_selector":
        return of.protocol.FunctionSelector
    home = target.module(t.owner) if t.owner else "types"
    return getattr(getattr(of, home), target.class_name(t))


@both
def test_devices(spec: str) -> None:
    of, generated = model(spec), package(spec).devices
    numbers = {s.name: s.number for s in of.sets}
    assert list(generated.DEVICES) == [d.id for d in of.devices]
    for d in of.devices:
        found = generated.DEVICES[d.id]
        assert (found.id, found.title, found.description, found.model_number) == (
            d.id, d.title, d.description, d.model_number
        )  # fmt: skip
        known = {name: of.field(name) for name in d.fields}
        places = {name: (f.set, f.descriptor) for name, f in known.items() if f}
        assert found.fields == frozenset(places.values()) and len(places) == len(d.fields)
        assert found.functions == {places[name]: letters for name, letters in d.functions}
        assert found.base_rates == {numbers[name]: rate for name, rate in d.base_rates}
        assert [(p.name, p.id, p.baud_rates, p.protocols) for p in found.ports] == [
            (p.name, p.id, p.baud_rates, p.protocols) for p in d.ports
        ]
        assert {k: (x.value, x.unit, x.description) for k, x in found.limits.items()} == {
            x.name: (x.value, x.unit, x.description) for x in d.limits
        }
        assert {k: (n.title, n.description, n.rows) for k, n in found.notes.items()} == {
            n.name: (n.title, n.description, n.rows) for n in d.notes
        }
        assert found.readings == {name: named(t, package(spec)) for name, t in d.readings}
        assert found.ack_codes == set(d.ack_codes)


@both
def test_decimations(spec: str) -> None:
    of = model(spec)
    for d in of.devices:
        device, rates = package(spec).devices.DEVICES[d.id], dict(d.base_rates)
        for s in of.sets:
            base = rates.get(s.name, 0)
            if base:
                assert [device.decimation(s.number, base / n) for n in (1, 2, 10)] == [1, 2, 10]
            else:
                with pytest.raises(ValueError, match="no fixed rate"):
                    device.decimation(s.number, 1)


@both
def test_every_parameter(spec: str) -> None:
    of, generated = model(spec), package(spec)
    records: list[m.Field | m.Struct] = all_fields(of)
    records += [t for t in (*of.types, *(t for s in of.sets for t in s.types)) if isinstance(t, m.Struct)]
    table = generated.reflection.PARAMETERS
    assert len(table) == len(records)
    for r in records:
        if isinstance(r, m.Struct):
            kind = named(r, generated)
        else:
            home = target.module(r.set_name) if r.set else "protocol"
            kind = getattr(getattr(generated, home), target.class_name(r))
        check(table[kind], r.parameters, generated)


def check(found: tuple[Any, ...], parameters: tuple[m.Parameter, ...], of: Package) -> None:
    names = {p.name: x.attribute for x, p in zip(found, parameters, strict=True)}
    for x, p in zip(found, parameters, strict=True):
        e = p.element
        bits = isinstance(e, m.Bitfield) and e.scalar is None
        scalar = e if isinstance(e, m.Scalar) else getattr(e, "scalar", None)
        assert (x.name, x.kind, x.length, x.constant) == (p.name, p.operation.kind, p.length, p.constant)
        assert x.units == p.units, p.name
        assert (x.scalar, x.size) == (("bits", e.size) if bits else (scalar.name if scalar else "", 0))  # type: ignore[union-attr]
        assert x.elements == (e.elements if isinstance(e, m.Vector) else ())
        assert x.type is named(None if isinstance(e, (m.Scalar, m.Vector)) else e, of)
        assert (x.counts, x.tag) == (names[p.counts] if p.counts else "", names[p.tag] if p.tag else "")
        assert set(x.cases) == {c.tag.value for c in p.cases}
        for c in p.cases:
            inner = x.cases[c.tag.value]
            assert (inner is None) == (c.parameter is None)
            if c.parameter is not None:
                check((inner,), (c.parameter,), of)
