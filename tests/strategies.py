"""Hypothesis strategies that know the layout of every field."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from pathlib import Path
from typing import Any

import hypothesis
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from mipgen import codec
from mipgen import model as m
from support import BUILD

Values = dict[str, Any]


def relaxed(examples: int) -> Any:
    """The same values in every run, and nothing but values: they are sent to the drivers in one batch."""
    return settings(
        max_examples=examples,
        deadline=None,
        database=None,
        derandomize=True,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )


def numbers(op: m.ScalarOp | m.CounterOp) -> st.SearchStrategy[Any]:
    """Any number of the type; named values come up often."""
    bits = 8 * op.size
    if op.scalar.kind == "float":
        special = [0, 1 << (bits - 1), 0x7FE5BF7F if bits == 32 else 0x7FF8000000000001, (1 << bits) - 1,
                   0x7F800001 if bits == 32 else 0x7FF0000000000001]  # fmt: skip
        return st.one_of(st.sampled_from(special), st.integers(0, (1 << bits) - 1)).map(
            lambda n: f"0x{n:0{bits // 4}x}"
        )
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if op.scalar.kind == "signed" else (0, (1 << bits) - 1)
    plain = st.integers(low, high)
    if isinstance(op, m.ScalarOp) and isinstance(op.type, m.Enum):
        return st.one_of(st.sampled_from([v.value for v in op.type.values]), plain)
    return plain


def items(op: m.Operation, count: int) -> st.SearchStrategy[Any]:
    if isinstance(op, m.TextOp):
        return st.text(st.characters(min_codepoint=0, max_codepoint=255), min_size=count, max_size=count)
    assert isinstance(op, m.ArrayOp)
    return st.lists(one(op.item), min_size=count, max_size=count)


def one(op: m.Operation) -> st.SearchStrategy[Any]:
    match op:
        case m.ScalarOp():
            return numbers(op)
        case m.BitsOp():
            return st.lists(st.integers(0, 255), min_size=op.size, max_size=op.size)
        case m.ArrayOp() | m.TextOp() if op.count is not None:
            return items(op, op.count)
        case m.StructOp():
            return record(op.struct.operations, 120)
    raise AssertionError(op)


@st.composite
def record(draw: Any, operations: tuple[m.Operation, ...], room: int) -> Values:
    """Values of these operations, arrays of open length taking no more than `room` bytes."""
    values: Values = {}
    flat = [i for op in operations for i in (op.body if isinstance(op, m.GroupOp) else (op,))]
    arrays = sum(isinstance(op, (m.ArrayOp, m.TextOp)) and op.count is None for op in flat)
    for op in flat:
        draw_into(draw, op, values, room // max(1, arrays))
    return values


def draw_into(draw: Any, op: m.Operation, values: Values, room: int) -> None:
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
                draw_into(draw, member, inner, room // 2)
            values[op.member] = inner
        case m.ArrayOp() | m.TextOp() if op.count is None:
            size = 1 if isinstance(op, m.TextOp) else codec.size_of(op.item)
            count = draw(st.integers(0, min(op.capacity, room // size)))
            values[op.member] = draw(items(op, count))
            if op.counter:
                values[op.counter] = count
        case _:
            values[op.member] = draw(one(op))


@st.composite
def field_values(draw: Any, field: m.Field) -> Values:
    """Values of a field as a sender may give them: what is required, and perhaps more."""
    least = sum(codec.size_of(o) for o in field.operations if _sized(o))
    values: Values = draw(record(field.operations, max(0, 253 - max(least, field.min_size) - 60)))
    if field.selector:
        known = [f.value for f in field.functions]
        values["function"] = draw(st.one_of(st.sampled_from(known), st.integers(0, 255)))
    required = field.required(values.get("function"))
    groups = [op for op in field.operations if isinstance(op, m.GroupOp)]
    keep = draw(st.integers(0, len(groups)))
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


#: What was drawn: several tests ask for the same, and drawing takes longer than most of them.
_drawn: dict[tuple[int, int], tuple[m.Field, list[Values]]] = {}
#: Between runs and processes it is kept here, by all that it depends on.
KEPT = BUILD / "drawn"
HOW = f"{hypothesis.__version__} {sys.version} ".encode() + Path(__file__).read_bytes()


def drawn(f: m.Field, examples: int) -> list[Values]:
    """Values of a field, the same in every run."""
    key = (id(f), examples)
    if key not in _drawn:
        _drawn[key] = (f, _kept(f, examples))
    return _drawn[key][1]


def _kept(f: m.Field, examples: int) -> list[Values]:
    path = KEPT / hashlib.sha256(HOW + f"{examples} {f!r}".encode()).hexdigest()
    if not path.is_file():
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_suffix(f".{os.getpid()}")
        part.write_text(json.dumps(_draw(f, examples)))
        part.replace(path)
    found: list[Values] = json.loads(path.read_text())
    return found


def _draw(f: m.Field, examples: int) -> list[Values]:
    found: list[Values] = []

    @relaxed(examples)
    @given(field_values(f))
    def draw(values: Values) -> None:
        found.append(values)

    draw()
    return found
