"""The tables of the C library say what the model says: of every device, and of every parameter."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from mipgen import model as m
from support import SPECS, all_fields, model, need
from test_c import HERE, build, run


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_facts(spec: str, tmp_path: Path) -> None:
    need("gcc")
    printed = run(build(tmp_path, "gcc", spec, HERE / "unit/facts.c")).splitlines()
    of = model(spec)
    expected = [*device_facts(of), *(line for f in all_fields(of) for line in parameters(f.parameters, f.full_name))]
    assert sorted(printed) == sorted(expected)


def words(*parts: object) -> str:
    return "\t".join(" ".join(str("" if x is None else x).split()) for x in parts)


def device_facts(of: m.Model) -> Iterator[str]:
    numbers = {s.name: s.number for s in of.sets}
    data = [n for n in range(0x80, 0x100)]
    for d in of.devices:
        yield words("device", d.id, d.title, d.manual, d.description, d.model_number or 0)
        for name, rate in d.base_rates:
            yield words("rate", d.id, numbers[name], f"{rate:.17g}")
        letters = dict(d.functions)
        for name in d.fields:
            f = of.field(name)
            assert f is not None
            usual = "".join(x.letter for x in f.functions)
            for number in data if f.set == 0xFF else [f.set]:
                yield f"field\t{d.id}\t{number}\t{f.descriptor}\t{letters.get(name, usual)}"
        for p in d.ports:
            rates = "".join(f"{rate} " for rate in p.baud_rates)
            yield f"port\t{d.id}\t{p.name}\t{p.id or 0}\t{', '.join(p.protocols)}\t{rates}"
        for x in d.limits:
            yield words("limit", d.id, x.name, f"{x.value:.17g}", x.unit, x.description)
        for n in d.notes:
            columns = max((len(row) for row in n.rows), default=0)
            cells = [cell for row in n.rows for cell in row]
            yield words("note", d.id, n.name, n.title, n.description, len(n.rows), columns, *cells)
        for name, t in d.readings:
            yield words("reading", d.id, name, full_name(t))
        for code in d.ack_codes:
            yield words("code", d.id, code)


def full_name(t: m.Type) -> str:
    owner = getattr(t, "owner", None)
    return f"{owner}.{t.name}" if owner else t.name


def parameters(of: tuple[m.Parameter, ...], path: str) -> Iterator[str]:
    for p in of:
        name, op, e = f"{path}.{p.name}", p.operation, p.element
        capacity = op.capacity if isinstance(op, (m.ArrayOp, m.TextOp)) and p.length is not None else 1
        elements = len(e.elements) if isinstance(e, m.Vector) else 1
        named = full_name(e) if isinstance(e, (m.Enum, m.Bitfield)) else ""
        yield f"parameter\t{name}\t{', '.join(p.units)}\t{capacity}\t{elements}\t{named}"
        if isinstance(e, m.Struct):
            yield from parameters(e.parameters, name)
        for c in p.cases:
            if c.parameter is not None:
                yield from parameters((c.parameter,), name)
        for _, t in p.reading.types if p.reading else ():
            yield f"reading\t{name}\t{full_name(t)}"
