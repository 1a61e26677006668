"""Random values of fields, for any layout: what a sender may give, with the limits of types and named values often."""

from __future__ import annotations

import random
from typing import Any

from mipgen import model as m
from mipgen.lower import extent
from support import SEED

Values = dict[str, Any]


def chance(*of: object) -> random.Random:
    """The same numbers in every run with the same seed."""
    return random.Random(f"{SEED} {of}")


def number(chance: random.Random, op: m.ScalarOp | m.CounterOp) -> Any:
    bits = 8 * op.size
    if op.scalar.kind == "float":
        special = [0, 1 << (bits - 1), 0x7FE5BF7F if bits == 32 else 0x7FF8000000000001, (1 << bits) - 1,
                   0x7F800001 if bits == 32 else 0x7FF0000000000001]  # fmt: skip
        pattern = chance.choice(special) if chance.random() < 0.5 else chance.getrandbits(bits)
        return f"0x{pattern:0{bits // 4}x}"
    if isinstance(op, m.ScalarOp) and isinstance(op.type, m.Enum) and chance.random() < 0.5:
        return chance.choice([v.value for v in op.type.values])
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if op.scalar.kind == "signed" else (0, (1 << bits) - 1)
    limits = [low, high, 0, 1, min(high, 1 << chance.randrange(bits))]
    return chance.choice(limits) if chance.random() < 0.4 else chance.randint(low, high)


def items(chance: random.Random, op: m.Operation, count: int) -> Any:
    if isinstance(op, m.TextOp):
        return "".join(chr(chance.randrange(256)) for _ in range(count))
    assert isinstance(op, m.ArrayOp)
    return [value(chance, op.item) for _ in range(count)]


def value(chance: random.Random, op: m.Operation) -> Any:
    match op:
        case m.ScalarOp():
            return number(chance, op)
        case m.BitsOp():
            return list(chance.randbytes(op.size))
        case m.ArrayOp() | m.TextOp() if op.count is not None:
            return items(chance, op, op.count)
        case m.StructOp():
            return record(chance, op.struct.operations, 120)
    raise AssertionError(op)


def record(chance: random.Random, operations: tuple[m.Operation, ...], room: int) -> Values:
    """Values of these operations, arrays of open length taking no more than `room` bytes."""
    values: Values = {}
    flat = [i for op in operations for i in (op.body if isinstance(op, m.GroupOp) else (op,))]
    arrays = sum(isinstance(op, (m.ArrayOp, m.TextOp)) and op.count is None for op in flat)
    for op in flat:
        add(chance, op, values, room // max(1, arrays))
    return values


def add(chance: random.Random, op: m.Operation, values: Values, room: int) -> None:
    match op:
        case m.ConstantOp() | m.GroupOp():
            return
        case m.CounterOp():
            values[op.member] = None  # its array says
        case m.SwitchOp():
            case = next((c for c in op.cases if c.tag.value == values[op.tag]), None)
            member = case.operation if case else None
            inner: Values = {}
            if member is not None:
                add(chance, member, inner, room // 2)
            values[op.member] = inner
        case m.ArrayOp() | m.TextOp() if op.count is None:
            most = min(op.capacity, room // extent.element(op))
            count = chance.choice((0, 1, most)) if most and chance.random() < 0.4 else chance.randint(0, most)
            values[op.member] = items(chance, op, count)
            if op.counter:
                values[op.counter] = count
        case _:
            values[op.member] = value(chance, op)


def field_values(chance: random.Random, field: m.Field) -> Values:
    """Values of a field as a sender may give them: what is required, and perhaps more."""
    least = sum(extent.size(o)[1] for o in field.operations if _sized(o))
    values = record(chance, field.operations, max(0, 253 - max(least, field.min_size) - 60))
    if field.selector:
        known = [f.value for f in field.functions]
        values["function"] = chance.choice(known) if chance.random() < 0.7 else chance.randrange(256)
    required = field.required(values.get("function"))
    groups = [op for op in field.operations if isinstance(op, m.GroupOp)]
    keep = chance.randint(0, len(groups))
    for i, group in enumerate(groups):
        if i >= keep and group.last > required:
            for inner in group.body:
                if not isinstance(inner, m.GroupOp):
                    values.pop(inner.member, None)
    return values


def _sized(op: m.Operation) -> bool:
    return isinstance(op, (m.ScalarOp, m.ConstantOp, m.CounterOp, m.BitsOp)) or (
        isinstance(op, (m.ArrayOp, m.TextOp)) and op.count is not None
    )


def drawn(field: m.Field, examples: int) -> list[Values]:
    """Values of a field, the same in every run."""
    numbers = chance(field.full_name)
    return [field_values(numbers, field) for _ in range(examples)]
