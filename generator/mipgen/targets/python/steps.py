"""How records are read and written: their parameters, with neighbouring numbers joined into blocks.

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


#: What a block calls the parameters that are not single numbers.
_BLOCK_KINDS: dict[str, Literal["number", "array", "bits"]] = {"array": "array", "bits": "bits"}


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


def plan(record: m.Record) -> Plan:
    planner = _Planner(record)
    always = planner.steps(record.always)
    groups = [Group(group.last, planner.steps(group.parameters)) for group in record.groups]
    return Plan((*always, *groups), tuple(planner.blocks))


class _Planner:
    """Joins neighbouring numbers into blocks and numbers these."""

    def __init__(self, record: m.Record) -> None:
        self.home = home(record)
        self.name = upper(record.name)
        self.capacities = {p.name: p.capacity for p in record.parameters}
        self.blocks: list[Block] = []

    def steps(self, parameters: Iterable[m.Parameter], union: str = "") -> tuple[Step, ...]:
        """`union`: the member that a case of a union goes to, whatever its own name is."""
        steps: list[Step] = []
        joined: list[Run] = []
        for p in parameters:
            numbers = None if p.kind == "text" else run(p)
            if numbers:
                joined.append(numbers)
                if p.kind != "constant":  # a wrong constant is the first thing to say of a record
                    continue
            steps += self.block(joined, union)
            joined = []
            if not numbers:
                steps.append(self.step(p, union))
        return (*steps, *self.block(joined, union))

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
        p, count = numbers.parameter, numbers.count or 1
        if p.constant is not None:
            return Value("constant", member(p.name), at, count, constant=p.constant)
        if p.counts is not None:
            return Value("counter", member(p.name), at, count, "", member(p.counts), self.capacities[p.counts])
        if p.vector:
            return Value("vector", union or member(p.name), at, count, reference(p.vector, self.home))
        kind = _BLOCK_KINDS.get(p.kind, "number")
        return Value(kind, union or member(p.name), at, count, self.convert(p.leaf))

    def step(self, p: m.Parameter, union: str) -> Step:
        name = union or member(p.name)
        if p.struct:
            return Structure(name, reference(p.struct, self.home))
        if p.union:
            cases = (
                Case(c.tag.value, self.steps([c.parameter], name), self.case_type(c.parameter))
                for c in p.cases
                if c.parameter
            )
            return Switch(name, member(p.union.tag), tuple(cases))
        return self.items(p, name)

    def items(self, p: m.Parameter, name: str) -> Items:
        item, counter = p.item, member(p.counter) if p.counter else ""
        shape = (name, p.count, counter, p.capacity, extent.element(p))
        if item.struct:
            return Items("structures", *shape, convert=reference(item.struct, self.home))
        if item.vector:
            return Items("vectors", *shape, _letter(item.scalar), item.capacity, reference(item.vector, self.home))
        if p.kind == "array":
            return Items("numbers", *shape, _letter(item.scalar), convert=self.convert(item))
        return Items("text", *shape)

    def convert(self, p: m.Parameter) -> str:
        if p.named is not None:
            return reference(p.named, self.home)
        return "codec.truth" if p.kind == "scalar" and p.scalar.kind == "bool" else ""

    def case_type(self, p: m.Parameter) -> str:
        return reference(p.struct, self.home) if p.struct else ""


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
