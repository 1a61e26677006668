"""Each printed packet, built in Rust as a user would: values by their names, options where they may be absent."""

from __future__ import annotations

from typing import Any

import everything
import pytest
from mipgen import model as m
from mipgen.targets.rust import names as rust
from mipgen.targets.rust.records import Records
from support import SPECS, model
from test_rust import passes, project

HEAD = """//! Made by test_rust_examples.py.

#![allow(deprecated)]

#[allow(unused_imports)]
use mip_protocol::{Bool, List, PacketBuilder, Text, VarText};
"""


@pytest.mark.parametrize("spec", sorted(SPECS))
def test_examples_built_by_hand(spec: str) -> None:
    of = model(spec)
    writer = _Writer(of)
    source = "\n".join([HEAD, *(everything.test(e.id.replace("-", "_"), writer.example(e)) for e in of.examples)])
    target = '[[test]]\nname = "examples"\npath = "examples.rs"\n'
    folder = project(spec, "examples", target, files={"examples.rs": source.encode()})
    out = passes(folder, "test", "--offline", "--quiet", "--test", "examples")
    assert f"test result: ok. {len(of.examples)} passed" in out


class _Writer:
    def __init__(self, of: m.Model) -> None:
        self.model = of
        self.records = Records(of)

    def example(self, e: m.Example) -> Any:
        yield f"let mut b = PacketBuilder::new({e.set});"
        for f in e.fields:
            field = self.model.field(f.field) if f.field else None
            if field is None or f.trailing:
                yield f"b.push_raw({f.descriptor}, {everything.data_literal(f.data)}).unwrap();"
            else:
                yield f"b.push(&{self.record(field, f.values or {})}).unwrap();"
        yield f"assert_eq!(b.bytes(), {everything.data_literal(e.packet)});"

    def record(self, record: rust.Record, values: dict[str, Any]) -> str:
        members = {x.parameter.name: x for x in self.records.members(record)}
        written = []
        for p in record.parameters:
            if p.derived:
                continue
            x = members[p.name]
            if p.name not in values:
                written.append(f"{x.name}: None")
                continue
            expression = self.value(p.operation, record, values[p.name], values)
            written.append(f"{x.name}: Some({expression})" if x.may_be_absent else f"{x.name}: {expression}")
        return f"{everything.path(record)} {{ {', '.join(written)} }}"

    def value(self, op: m.Operation, record: rust.Record, value: Any, siblings: dict[str, Any]) -> str:
        match op:
            case m.ScalarOp():
                return number(op, value)
            case m.BitsOp():
                return f"{everything.path(op.type)}({value})"
            case m.TextOp():
                octets = everything.data_literal(value.encode("latin-1"))
                return f"Text(*{octets})" if op.count is not None else f"VarText(List::from({octets}))"
            case m.ArrayOp():
                array = f"[{', '.join(self.value(op.item, record, v, {}) for v in value)}]"
                if op.vector is not None:
                    return f"{everything.path(op.vector)}::from({array})"
                return f"List::from({array})" if op.count is None else array
            case m.StructOp():
                return self.record(op.struct, value)
            case m.SwitchOp():
                case = next((c for c in op.cases if c.tag.value == siblings[op.tag]), None)
                home = rust.home(record)
                union = f"mip_protocol::{home}::{self.records.union(op, home).name}"
                assert case is not None
                if case.operation is None:
                    return f"{union}::{rust.variant(case.tag.name)}"
                assert not isinstance(case.operation, m.GroupOp)
                inner = self.value(case.operation, record, value[case.operation.member], {})
                return f"{union}::{rust.variant(case.tag.name)}({inner})"
        raise AssertionError(op)


def number(op: m.ScalarOp, value: Any) -> str:
    if op.scalar.kind == "float":
        return f"f{8 * op.size}::from_bits({value})"
    if op.scalar.kind == "bool":
        return f"Bool({value})"
    if isinstance(op.type, m.Enum):
        known = next((v for v in op.type.values if v.value == value), None)
        return (
            f"{everything.path(op.type)}::{rust.constant(known.name)}"
            if known
            else f"{everything.path(op.type)}({value})"
        )
    if isinstance(op.type, m.Bitfield):
        return f"{everything.path(op.type)}({value})"
    return str(value)
