"""How records are read and written: their operations, with neighbouring numbers joined into blocks.

A block is one `codec.Block` of the package, which has one `struct.Struct`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from mipgen import model as m
from mipgen.emit.naming import upper
from mipgen.lower import extent
from mipgen.lower.runs import Run, run

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
        arrays = (p.operation for p in record.parameters)
        self.capacities = {op.member: op.capacity for op in arrays if isinstance(op, (m.ArrayOp, m.TextOp))}
        self.blocks: list[Block] = []

    def steps(self, operations: Iterable[m.Operation], union: str = "") -> tuple[Step, ...]:
        """`union`: the member that a case of a union goes to, whatever its own name is."""
        found: list[Step] = []
        joined: list[Run] = []
        for op in operations:
            numbers = None if op.kind == "text" else run(op)
            if numbers:
                joined.append(numbers)
                if op.kind != "constant":  # a wrong constant is the first thing to say of a record
                    continue
            found += self.block(joined, union)
            joined = []
            if not numbers:
                found.append(self.step(op, union))
        return (*found, *self.block(joined, union))

    def block(self, joined: Sequence[Run], union: str) -> list[Step]:
        if not joined:
            return []
        layout, values = "", []
        for numbers in joined:
            values.append(self.value(numbers, union, len(layout)))
            layout += _letter(numbers.scalar) * values[-1].count
        size = sum(numbers.size for numbers in joined)
        block = Block(f"_{self.name}_{len(self.blocks)}", layout, size, tuple(values))
        self.blocks.append(block)
        return [block]

    def value(self, numbers: Run, union: str, at: int) -> Value:
        op, count = numbers.op, 1 if numbers.count is None else numbers.count
        match op:
            case m.ConstantOp():
                return Value("constant", member(op.member), at, count, constant=op.value)
            case m.CounterOp():
                array, capacity = member(op.array), self.capacities[op.array]
                return Value("counter", member(op.member), at, count, array=array, capacity=capacity)
            case m.ArrayOp(vector=m.Vector() as vector):
                return Value("vector", union or member(op.member), at, count, reference(vector, self.home))
        kind: Literal["number", "array", "bits"] = (
            "bits" if op.kind == "bits" else "array" if op.kind == "array" else "number"
        )
        return Value(kind, union or member(op.member), at, count, self.convert(op.leaf))

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
        shape = (name, op.count, counter, op.capacity, extent.element(op))
        match op:
            case m.ArrayOp(item=m.StructOp(struct=struct)):
                return Items("structures", *shape, convert=reference(struct, self.home))
            case m.ArrayOp(item=m.ArrayOp(item=m.ScalarOp(scalar=scalar), count=int(width), vector=m.Vector() as kind)):
                return Items("vectors", *shape, _letter(scalar), width, reference(kind, self.home))
            case m.ArrayOp(item=m.ScalarOp() as item):
                return Items("numbers", *shape, _letter(item.scalar), convert=self.convert(item))
        return Items("text", *shape)

    def convert(self, op: m.Operation) -> str:
        if op.named is not None:
            return reference(op.named, self.home)
        return "codec.truth" if isinstance(op, m.ScalarOp) and op.scalar.kind == "bool" else ""

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


def _letter(scalar: m.Scalar) -> str:
    return SCALARS[scalar.name][0]
