"""Random values of fields, for any layout: any that may be sent; limits of types and named values are frequent."""

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


def number(chance: random.Random, p: m.Parameter) -> Any:
    bits = 8 * p.size
    if p.scalar.kind == "float":
        special = [0, 1 << (bits - 1), 0x7FE5BF7F if bits == 32 else 0x7FF8000000000001, (1 << bits) - 1,
                   0x7F800001 if bits == 32 else 0x7FF0000000000001]  # fmt: skip
        pattern = chance.choice(special) if chance.random() < 0.5 else chance.getrandbits(bits)
        return f"0x{pattern:0{bits // 4}x}"
    if isinstance(p.named, m.Enum) and chance.random() < 0.5:
        return chance.choice([v.value for v in p.named.values])
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if p.scalar.kind == "signed" else (0, (1 << bits) - 1)
    limits = [low, high, 0, 1, min(high, 1 << chance.randrange(bits))]
    return chance.choice(limits) if chance.random() < 0.4 else chance.randint(low, high)


def items(chance: random.Random, p: m.Parameter, count: int) -> Any:
    if p.kind == "text":
        return "".join(chr(chance.randrange(256)) for _ in range(count))
    return [value(chance, p.item) for _ in range(count)]


def value(chance: random.Random, p: m.Parameter) -> Any:
    if p.struct:
        return record(chance, p.struct.parameters, 120)
    if p.several:
        return items(chance, p, p.capacity)
    return list(chance.randbytes(p.size)) if p.kind == "bits" else number(chance, p)


def record(chance: random.Random, parameters: tuple[m.Parameter, ...], room: int) -> Values:
    """Values of these parameters, arrays of open length taking no more than `room` bytes."""
    values: Values = {}
    arrays = sum(p.open for p in parameters)
    for p in parameters:
        add(chance, p, values, room // max(1, arrays))
    return values


def add(chance: random.Random, p: m.Parameter, values: Values, room: int) -> None:
    if p.constant is not None:
        return
    if p.counts:
        values[p.name] = None  # follows from its array
    elif p.union:
        values[p.name] = inner = Values()
        for q in (c.parameter for c in p.cases if c.parameter and c.tag.value == values[p.union.tag]):
            add(chance, q, inner, room // 2)
    elif p.open:
        most = min(p.capacity, room // extent.item_size(p))
        count = chance.choice((0, 1, most)) if most and chance.random() < 0.4 else chance.randint(0, most)
        values[p.name] = items(chance, p, count)
        if p.counter:
            values[p.counter] = count
    else:
        values[p.name] = value(chance, p)


def field_values(chance: random.Random, field: m.Field) -> Values:
    """Values of a field as they may be sent: those required, and perhaps more."""
    sized = (p for p in field.always if p.kind not in ("struct", "switch") and not p.open)
    least = sum(extent.size(p)[1] for p in sized)
    values = record(chance, field.parameters, max(0, 253 - max(least, field.min_size) - 60))
    if field.selector:
        known = [f.value for f in field.functions]
        values["function"] = chance.choice(known) if chance.random() < 0.7 else chance.randrange(256)
    required = field.required(values.get("function"))
    keep = chance.randint(0, len(field.groups))
    for i, group in enumerate(field.groups):
        if i >= keep and group.last > required:
            for p in group.parameters:
                values.pop(p.name, None)
    return values


def drawn(field: m.Field, examples: int) -> list[Values]:
    """Values of a field, the same in every run."""
    numbers = chance(field.full_name)
    return [field_values(numbers, field) for _ in range(examples)]
