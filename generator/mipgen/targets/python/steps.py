"""How records are read and written: their operations, with neighbouring numbers joined into blocks.

A block is one `codec.Block` of the package, which has one `struct.Struct`.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from ... import model as m
from ...naming import upper
from .members import Record
from .names import SCALARS, home, member, reference


@dataclass(frozen=True, slots=True)
class Value:
    """One value of a block: what it is made from, and what it becomes."""

    kind: Literal["number", "array", "vector", "bits", "counter", "constant"]
    member: str
    first: int  # its place among the numbers of the block
    count: int  # how many of them it takes
    convert: str = ""  # what makes the value from a number; empty if the number is the value
    array: str = ""  # of a counter: the array that it counts
    capacity: int = 0  # of that array
    constant: int = 0

    @property
    def end(self) -> int:
        return self.first + self.count


@dataclass(frozen=True, slots=True)
class Block:
    """A run of numbers with a fixed layout."""

    name: str
    layout: str
    size: int
    values: tuple[Value, ...]
    kind: Literal["block"] = "block"

    @property
    def names(self) -> list[str]:
        """What errors call each of its numbers, as Python writes it."""
        return [f'*["{v.member}"] * {v.count}' if v.count > 1 else f'"{v.member}"' for v in self.values]


@dataclass(frozen=True, slots=True)
class Items:
    """Text, or an array whose length varies or whose items are no numbers."""

    kind: Literal["text", "numbers", "structures", "vectors"]
    member: str
    count: int | None
    counter: str  # the variable that holds the count; empty if the array fills the field
    capacity: int
    size: int  # of one item
    letter: str = ""
    width: int = 0  # of a vector
    convert: str = ""


@dataclass(frozen=True, slots=True)
class Structure:
    member: str
    type: str
    kind: Literal["structure"] = "structure"


@dataclass(frozen=True, slots=True)
class Case:
    value: int
    steps: tuple[Step, ...]
    type: str  # the class that the member must be of, if it is a structure


@dataclass(frozen=True, slots=True)
class Switch:
    member: str
    tag: str
    cases: tuple[Case, ...]  # without the empty ones
    kind: Literal["switch"] = "switch"


@dataclass(frozen=True, slots=True)
class Group:
    """What is there or absent together."""

    last: int  # number of its last parameter
    steps: tuple[Step, ...]
    kind: Literal["group"] = "group"

    @property
    def cut(self) -> list[str]:
        """The members that may have been read already when the data end within the group."""
        return [name for step in self.steps[:-1] for name in _held(step)]


Step = Block | Items | Structure | Switch | Group


@dataclass(frozen=True, slots=True)
class Plan:
    """The codec of a record."""

    steps: tuple[Step, ...]
    blocks: tuple[Block, ...]

    @property
    def always(self) -> list[Step]:
        return [s for s in self.steps if s.kind != "group"]

    @property
    def groups(self) -> list[Step]:
        return [s for s in self.steps if s.kind == "group"]


def plan(record: Record) -> Plan:
    planner = _Planner(record)
    steps = planner.steps(record.operations)
    return Plan(steps, tuple(planner.blocks))


class _Planner:
    """Joins neighbouring numbers into blocks and numbers these."""

    def __init__(self, record: Record) -> None:
        self.home = home(record)
        self.name = upper(record.name)
        arrays = [p.operation for p in record.parameters if isinstance(p.operation, (m.ArrayOp, m.TextOp))]
        self.capacities = {op.member: op.capacity for op in arrays}
        self.blocks: list[Block] = []

    def steps(self, operations: Iterable[m.Operation], union: str = "") -> tuple[Step, ...]:
        """`union`: the member that a case of a union goes to, whatever its own name is."""
        found: list[Step] = []
        run: list[m.Operation] = []
        for op in operations:
            if _is_numbers(op):
                run.append(op)
                if not isinstance(op, m.ConstantOp):  # a wrong constant is the first thing to say of a record
                    continue
            found += self.block(run, union)
            run = []
            if not _is_numbers(op):
                found.append(self.step(op, union))
        return (*found, *self.block(run, union))

    def block(self, run: Sequence[m.Operation], union: str) -> list[Step]:
        if not run:
            return []
        layout, values = "", []
        for op in run:
            letters, value = self.value(op, union, len(layout))
            layout += letters
            values.append(value)
        size = sum(struct.calcsize(f">{letter}") for letter in layout)
        block = Block(f"_{self.name}_{len(self.blocks)}", layout, size, tuple(values))
        self.blocks.append(block)
        return [block]

    def value(self, op: m.Operation, union: str, at: int) -> tuple[str, Value]:
        """The letters of a value in the layout of a block, and the value."""
        match op:
            case m.ConstantOp():
                return _letter(op.scalar), Value("constant", member(op.member), at, 1, constant=op.value)
            case m.CounterOp():
                array, capacity = member(op.array), self.capacities[op.array]
                return _letter(op.scalar), Value("counter", member(op.member), at, 1, array=array, capacity=capacity)
            case m.BitsOp():
                convert = reference(op.type, self.home)
                return "B" * op.size, Value("bits", union or member(op.member), at, op.size, convert)
            case m.ScalarOp():
                return _letter(op.scalar), Value("number", union or member(op.member), at, 1, self.convert(op))
            case m.ArrayOp(item=m.ScalarOp() as item, count=int(count)):
                name = union or member(op.member)
                if op.vector:
                    return _letter(item.scalar) * count, Value(
                        "vector", name, at, count, reference(op.vector, self.home)
                    )
                value = Value("array", name, at, count, self.convert(item))
                return _letter(item.scalar) * count, value
        raise AssertionError(op)

    def step(self, op: m.Operation, union: str) -> Step:
        match op:
            case m.GroupOp():
                return Group(op.last, self.steps(op.body))
            case m.StructOp():
                return Structure(union or member(op.member), reference(op.struct, self.home))
            case m.SwitchOp():
                name = union or member(op.member)
                cases = [
                    Case(c.tag.value, self.steps([c.operation], name), self.case_type(c))
                    for c in op.cases
                    if c.operation
                ]
                return Switch(name, member(op.tag), tuple(cases))
            case m.ArrayOp() | m.TextOp():
                return self.items(op, union or member(op.member))
        raise AssertionError(op)

    def items(self, op: m.ArrayOp | m.TextOp, name: str) -> Items:
        counter = member(op.counter) if op.counter else ""
        match op:
            case m.TextOp():
                return Items("text", name, op.count, counter, op.capacity, size=1)
            case m.ArrayOp(item=m.StructOp(struct=struct_)):
                kind = reference(struct_, self.home)
                return Items("structures", name, op.count, counter, op.capacity, struct_.max_size, convert=kind)
            case m.ArrayOp(item=m.ArrayOp(item=m.ScalarOp(scalar=scalar), count=int(width), vector=m.Vector() as kind)):
                size, letter, made = scalar.size * width, _letter(scalar), reference(kind, self.home)
                return Items("vectors", name, op.count, counter, op.capacity, size, letter, width, made)
            case m.ArrayOp(item=m.ScalarOp() as item):
                letter, convert = _letter(item.scalar), self.convert(item)
                return Items("numbers", name, op.count, counter, op.capacity, item.size, letter, convert=convert)
        raise AssertionError(op)

    def convert(self, op: m.ScalarOp) -> str:
        if op.type is not None:
            return reference(op.type, self.home)
        return "codec.truth" if op.scalar.kind == "bool" else ""

    def case_type(self, case: m.Case) -> str:
        element = case.parameter.element if case.parameter else None
        return reference(element, self.home) if isinstance(element, m.Struct) else ""


def _held(step: Step) -> list[str]:
    """The members that a step reads."""
    match step:
        case Block():
            return [v.member for v in step.values if v.kind not in ("counter", "constant")]
        case Group():
            return [name for inner in step.steps for name in _held(inner)]
        case _:
            return [step.member]


def _is_numbers(op: m.Operation) -> bool:
    """Is it made of a fixed number of numbers?"""
    if isinstance(op, m.ArrayOp):
        return op.count is not None and isinstance(op.item, m.ScalarOp)
    return isinstance(op, (m.ScalarOp, m.ConstantOp, m.CounterOp, m.BitsOp))


def _letter(scalar: m.Scalar) -> str:
    return SCALARS[scalar.name][0]
