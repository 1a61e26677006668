"""The layout of a field as a program, which codec.c runs; runtime/c/src/mip/program.h has the steps.

How many bytes a part of a program has is known here; the place of a member in memory, only to the C compiler.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.lower import extent, memory
from mipgen.lower.presence import groups

from .direct import direct
from .literals import hexadecimal
from .members import home
from .names import member, record_name, type_name
from .tables import required

#: The most numbers that the first byte of a step can count.
_FEW = 31

#: The most parameters of a group that the first byte of a step can count.
_GROUP = 16

#: In the arguments of a step: the bytes of the program that follows it.
LENGTH = object()


@dataclass(frozen=True, slots=True)
class Step:
    """One step: a macro and its arguments."""

    macro: str
    arguments: tuple[object, ...]
    size: int  # bytes, without those of the place
    place: tuple[str, str] | None = None  # a structure, and one of its members; the last argument

    def line(self, far: bool) -> str:
        at = [f"MIP_{'FAR_' if far else ''}AT({', '.join(self.place)})"] if self.place else []
        arguments = ", ".join([*map(str, self.arguments), *at])
        return f"{self.macro}({arguments})," if arguments else f"{self.macro},"

    def length(self, far: bool) -> int:
        return self.size + (0 if self.place is None else 2 if far else 1)


@dataclass(frozen=True, slots=True)
class Numbers:
    """Numbers that follow each other in memory without a gap."""

    macro: str
    count: int
    place: tuple[str, str]
    joins: bool  # may others of the kind follow without a gap?

    def line(self, far: bool) -> str:
        at = f"MIP_{'FAR_' if far else ''}AT({', '.join(self.place)})"
        return f"{self.macro}(0, MIP_MANY({self.count}, {at}))," if self._many else f"{self.macro}({self.count}, {at}),"

    def length(self, far: bool) -> int:
        return 1 + self._many + 1 + far

    @property
    def _many(self) -> bool:
        return self.count > _FEW


@dataclass(frozen=True, slots=True)
class Part:
    """A program inside another one, after a step whose arguments count its bytes."""

    step: Step
    steps: tuple[Step | Numbers | Part, ...]


def program(f: m.Field, layouts: Sequence[m.Field], sizes: range) -> list[str]:
    """The lines of the program of a field: `layouts` are those of its descriptor, `sizes` those of this one."""
    steps: list[Step | Numbers | Part] = [_layout(f, sizes)] if len(layouts) > 1 else []
    far = _is_far(f)
    if far:
        steps.append(Step("MIP_FAR", (), 1))
    operations = f.operations
    if f.optional:
        steps.append(_optional(f))
        operations = operations[len(f.functions) and 1 :]  # the function selector is part of this step
    steps += _steps(operations, f"struct {record_name(f)}", "")
    return _source(steps, far)[0]


def numbers(f: m.Field, layouts: Sequence[m.Field]) -> int:
    """The bytes of a layout that is nothing but a few numbers, without texts, which end with a NUL; 0 for another."""
    steps = _joined([*_steps(f.operations, "", "")])
    plain = all(isinstance(s, Numbers) and s.count <= _FEW for s in steps)
    plain = plain and not _is_far(f) and len(layouts) == 1
    return f.max_size if plain and not any(a.text for a in direct(f)) else 0


def _is_far(f: m.Field) -> bool:
    """Do places need two bytes?"""
    return memory.record(f, memory.widest).last > 0xFF


def _layout(f: m.Field, sizes: range) -> Step:
    told = [(at + i, byte) for at, op in f.constants for i, byte in enumerate(op.value.to_bytes(op.size, "big"))]
    bytes_ = [f"{at}, {hexadecimal(byte)}" for at, byte in told]
    if not told:
        return Step("MIP_SIZES", (sizes.start, sizes.stop - 1), 4)
    return Step("MIP_LAYOUT", (sizes.start, sizes.stop - 1, len(told), *bytes_), 4 + 2 * len(told))


def _optional(f: m.Field) -> Step:
    if not f.functions:
        before = groups(f)[0].first - 1
        return Step("MIP_OPTIONAL", (before,), 3)
    table = required(f)[1:]
    while table[-1:] == [0] and len(table) > 1:  # what an unknown function requires, too
        table.pop()
    return Step("MIP_REQUIRED", (len(table), *table), 2 + len(table))


def _source(steps: Sequence[Step | Numbers | Part], far: bool) -> tuple[list[str], int]:
    """The lines of a program, up to its end, and how many bytes it has."""
    lines, size = [], 1
    for s in _joined(steps):
        if isinstance(s, Part):
            inner, length = _source(s.steps, far)
            lines += [
                replace(s.step, arguments=tuple(length if a is LENGTH else a for a in s.step.arguments)).line(far)
            ]
            lines += [f"    {line}" for line in inner]
            size += s.step.length(far) + length
        else:
            lines.append(s.line(far))
            size += s.length(far)
    return [*lines, "MIP_END,"], size


def _joined(steps: Sequence[Step | Numbers | Part]) -> list[Step | Numbers | Part]:
    """Neighbours of one kind are one step."""
    found: list[Step | Numbers | Part] = []
    for s in steps:
        last = found[-1] if found else None
        if isinstance(s, Numbers) and isinstance(last, Numbers) and s.macro == last.macro and last.joins:
            found[-1] = replace(last, count=last.count + s.count, joins=s.joins)
        else:
            found.append(s)
    return found


def _steps(ops: Sequence[m.Operation], base: str, record: str) -> Iterator[Step | Numbers | Part]:
    """`base`: the structure where places begin; `record`: what leads from there to the record of the operations."""
    for op in ops:
        yield from _step(op, base, record, record)


def _step(op: m.Operation, base: str, record: str, of: str) -> Iterator[Step | Numbers | Part]:
    """`of`: what comes before the member; it differs from `record` in a union."""
    match op:
        case m.GroupOp():
            count = op.last - op.first + 1
            yield Step("MIP_GROUP", (count,), 1) if count <= _GROUP else Step("MIP_LARGE_GROUP", (count,), 2)
            yield from _steps(op.body, base, record)
        case m.ScalarOp() | m.CounterOp():
            yield _numbers(op.scalar, 1, (base, of + member(op.member)))
        case m.ConstantOp():
            yield Step("MIP_CONSTANT", (op.size, *map(hexadecimal, op.value.to_bytes(op.size, "big"))), 2 + op.size)
        case m.BitsOp():
            yield replace(_numbers(m.SCALARS["u8"], op.size, (base, of + member(op.member))), joins=False)
        case m.StructOp():
            inside = [*_steps(op.struct.operations, base, f"{of}{member(op.member)}.")]
            yield from (replace(s, joins=False) if isinstance(s, Numbers) and s is inside[-1] else s for s in inside)
        case m.TextOp() | m.ArrayOp():
            yield from _items(op, base, record, of)
        case m.SwitchOp():
            yield from _switch(op, base, record, of)


def _numbers(scalar: m.Scalar, count: int, place: tuple[str, str]) -> Numbers:
    return Numbers("MIP_DOUBLES" if scalar.name == "double" else f"MIP_{8 * scalar.size}_BITS", count, place, True)


def _items(op: m.TextOp | m.ArrayOp, base: str, record: str, of: str) -> Iterator[Step | Numbers | Part]:
    """The elements of an array, or the characters of a text, which is followed by a NUL."""
    place = (base, of + member(op.member))
    wire = extent.element(op)
    if op.counter is not None:
        counter = (base, record + member(op.counter))
        yield Step("MIP_COUNTED", (f"MIP_SIZE({', '.join(counter)})", op.capacity, wire), 4, counter)
    elif op.count is None:
        yield Step("MIP_REST", (op.capacity, wire), 4, (base, f"{of}{member(op.member)}_count"))
    fixed, item = op.count or 1, m.ScalarOp("", m.SCALARS["u8"], None, 1) if isinstance(op, m.TextOp) else op.item
    if isinstance(item, m.StructOp):
        name = f"struct {type_name(item.struct)}"
        each = Step("MIP_EACH", (fixed, name, LENGTH), 5, place)
        yield Part(each, (*_steps(item.struct.operations, name, ""),))
        return
    while isinstance(item, m.ArrayOp):
        fixed, item = fixed * (item.count or 1), item.item
    assert isinstance(item, m.ScalarOp)
    yield replace(_numbers(item.scalar, fixed, place), joins=isinstance(op, m.ArrayOp) and op.count is not None)


def _switch(op: m.SwitchOp, base: str, record: str, of: str) -> Iterator[Step | Numbers | Part]:
    cases = [c for c in op.cases if c.operation is not None]
    size = op.tag_type.scalar.size
    yield Step("MIP_SWITCH", (size, len(cases)), 3, (base, record + member(op.tag)))
    for c in cases:
        assert c.operation is not None and c.parameter is not None
        steps = _step(c.operation, base, record, f"{of}{member(op.member)}.{home(c.parameter)}")
        value = map(hexadecimal, c.tag.value.to_bytes(size, "big"))
        yield Part(Step("MIP_CASE", (LENGTH, *value), size + 1), (*steps,))
