"""Compiles the layout of a field to a program for codec.c or program.c; program.h beside them defines the steps.

The length of each part of a program is known here; the offset of a member in memory is known only to the C compiler.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from mipgen import model as m
from mipgen.lower import extent, memory

from .literals import hexadecimal
from .members import capacity, union_prefix
from .names import member, symbol, type_name
from .tables import required

#: The maximum count of numbers that the first byte of a step can contain.
_FEW = 31

#: Step -> width in bits of its numbers.
_WIDTHS = {"MIP_DOUBLES": 64, "MIP_64_BITS": 64, "MIP_32_BITS": 32, "MIP_16_BITS": 16, "MIP_8_BITS": 8}

#: The maximum counts of 64, 32 and 16-bit numbers in MIP_SHAPE.
_SHAPE = (4, 9, 4)

#: The maximum count of a group's parameters that the first byte of a step can contain.
_GROUP = 16

#: Placeholder in the arguments of a step: the length in bytes of the program that follows it.
LENGTH = object()


@dataclass(frozen=True, slots=True)
class Step:
    """A step: a macro and its arguments."""

    macro: str
    arguments: tuple[object, ...]
    size: int  # bytes, without the place
    place: tuple[str, str] | None = None  # the last argument: a structure and one of its members

    def line(self, far: bool) -> str:
        at = [f"MIP_{'FAR_' if far else ''}AT({', '.join(self.place)})"] if self.place else []
        arguments = ", ".join([*map(str, self.arguments), *at])
        return f"{self.macro}({arguments})," if arguments else f"{self.macro},"

    def length(self, far: bool) -> int:
        return self.size + (0 if self.place is None else 2 if far else 1)


@dataclass(frozen=True, slots=True)
class Numbers:
    """Numbers that follow each other in memory without gaps."""

    macro: str
    count: int
    place: tuple[str, str]
    joins: bool  # may numbers of the same kind follow without a gap?

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
    """A nested program, after a step whose arguments contain its length."""

    step: Step
    steps: tuple[Step | Numbers | Part, ...]


@dataclass(frozen=True, slots=True)
class Codec:
    """How a field is read and written, see `mip_codec` in core.h."""

    program: list[str]
    interpreter: str  # the function that runs the program; NULL if it needs none
    numbers_only: int  # the size of a field without an interpreter, else 0
    shape: str  # the counts of 64, 32 and 16-bit numbers, if they are few, in this order and without gaps; otherwise 0


def codec(f: m.Field, model: m.Model) -> Codec:
    layouts = model.layouts(f)
    program = _program(f, layouts, model.sizes(f))
    if is_numbers(f, layouts):
        return Codec(program, "NULL", f.min_size, _shape(f))
    return Codec(program, "&mip_layout" if len(layouts) > 1 else "&mip_program", 0, "0")


def _program(f: m.Field, layouts: Sequence[m.Field], sizes: range) -> list[str]:
    """Writes a field's program: `layouts` are all those of its descriptor, `sizes` the sizes of this one."""
    steps: list[Step | Numbers | Part] = [_layout(f, sizes)] if len(layouts) > 1 else []
    far = _is_far(f)
    if far:
        steps.append(Step("MIP_FAR", (), 1))
    base = f"struct {symbol(f)}"
    if f.optional:
        steps.append(_optional(f))
    steps += _steps((p for p in f.always if not (f.optional and p.selector)), base)  # the selector is part of that step
    for group in f.groups:
        reserved = [Step("MIP_RESERVED", (), 1)] if any(p.reserved for p in group.parameters) else []
        steps += [_group(len(group.parameters)), *reserved, *_steps(group.parameters, base)]
    return _source(steps, far)[0]


def is_numbers(f: m.Field, layouts: Sequence[m.Field]) -> bool:
    """True if the layout consists only of a few numbers, so that it needs no interpreter."""
    plain = all(isinstance(s, Numbers) and s.count <= _FEW for s in _joined([*_steps(f.parameters, "")]))
    return plain and not (f.groups or _is_far(f)) and len(layouts) == 1


def _shape(f: m.Field) -> str:
    numbers = [s for s in _joined([*_steps(f.parameters, "")]) if isinstance(s, Numbers)]
    widths = [w for s in numbers for w in [_WIDTHS[s.macro]] * s.count]
    counts = [widths.count(w) for w in (64, 32, 16)]
    simple = widths == sorted(widths, reverse=True) and 8 not in widths and not memory.has_gaps(f)
    most = zip(counts, _SHAPE, strict=True)
    return f"MIP_SHAPE({', '.join(map(str, counts))})" if simple and all(n <= limit for n, limit in most) else "0"


def _is_far(f: m.Field) -> bool:
    """Do offsets in memory need two bytes?"""
    return memory.record_memory(f, memory.widest).last > 0xFF


def _layout(f: m.Field, sizes: range) -> Step:
    constants = [(at + i, byte) for at, constant in f.signature for i, byte in enumerate(constant)]
    tests = [f"{at}, {hexadecimal(byte)}" for at, byte in constants]
    if not tests:
        return Step("MIP_SIZES", (sizes.start, sizes.stop - 1), 4)
    return Step("MIP_LAYOUT", (sizes.start, sizes.stop - 1, len(tests), *tests), 4 + 2 * len(tests))


def _optional(f: m.Field) -> Step:
    if not f.functions:
        before = f.groups[0].first - 1
        return Step("MIP_OPTIONAL", (before,), 3)
    table = required(f)[1:]
    while table[-1:] == [0] and len(table) > 1:  # unknown functions require 0, too
        table.pop()
    return Step("MIP_REQUIRED", (len(table), *table), 2 + len(table))


def _source(steps: Sequence[Step | Numbers | Part], far: bool) -> tuple[list[str], int]:
    """Writes the lines of a program, including its end, and returns them with its length in bytes."""
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
    """Joins adjacent numbers of the same kind into one step."""
    joined: list[Step | Numbers | Part] = []
    for s in steps:
        last = joined[-1] if joined else None
        if isinstance(s, Numbers) and isinstance(last, Numbers) and s.macro == last.macro and last.joins:
            joined[-1] = replace(last, count=last.count + s.count, joins=s.joins)
        else:
            joined.append(s)
    return joined


def _steps(parameters: Iterable[m.Parameter], base: str, record: str = "") -> Iterator[Step | Numbers | Part]:
    """Yields the steps of parameters. Places are relative to the structure `base`; `record` is the path from there to
    the parameters."""
    for p in parameters:
        yield from _step(p, base, record, record)


def _step(p: m.Parameter, base: str, record: str, of: str) -> Iterator[Step | Numbers | Part]:
    """Yields the steps of a parameter. `of` is the path to its member, which differs from `record` in a union."""
    name = of + member(p.name)
    if p.kind == "constant":
        yield Step("MIP_CONSTANT", (p.size, *map(hexadecimal, p.octets)), 2 + p.size)
    elif p.struct:
        inside = [*_steps(p.struct.parameters, base, f"{name}.")]
        yield from (replace(s, joins=False) if isinstance(s, Numbers) and s is inside[-1] else s for s in inside)
    elif p.union:
        yield from _switch(p.union, (base, record + member(p.union.tag)), base, record, f"{name}.")
    elif p.several:
        yield from _items(p, base, record, name)
    else:
        yield _numbers(p, p.size if p.kind == "bits" else 1, (base, name), joins=p.kind != "bits")


def _group(count: int) -> Step:
    return Step("MIP_GROUP", (count,), 1) if count <= _GROUP else Step("MIP_LARGE_GROUP", (count,), 2)


def _numbers(p: m.Parameter, count: int, place: tuple[str, str], joins: bool) -> Numbers:
    macro = "MIP_DOUBLES" if p.scalar.name == "double" else f"MIP_{p.scalar.width}_BITS"
    return Numbers(macro, count, place, joins)


def _items(p: m.Parameter, base: str, record: str, name: str) -> Iterator[Step | Numbers | Part]:
    """Yields the steps for the elements of an array, or for the characters of a text, which a NUL follows."""
    wire, item, fixed = extent.item_size(p), p.item, p.count or 1
    if p.counter is not None:
        counter = (base, record + member(p.counter))
        yield Step("MIP_COUNTED", (f"MIP_SIZE({', '.join(counter)})", capacity(p), wire), 4, counter)
    elif p.fills:
        yield Step("MIP_REST", (p.capacity, wire), 4, (base, f"{name}_count"))
    if item.struct:
        of = f"struct {type_name(item.struct)}"
        yield Part(Step("MIP_EACH", (fixed, of, LENGTH), 5, (base, name)), (*_steps(item.struct.parameters, of),))
    else:
        count = fixed * (item.count or 1)
        yield _numbers(p.leaf, count, (base, name), joins=p.kind == "array" and not p.open)


def _switch(union: m.Union, tag: tuple[str, str], base: str, record: str, of: str) -> Iterator[Step | Numbers | Part]:
    cases = [(c.tag.value, c.parameter) for c in union.cases if c.parameter is not None]
    size = union.type.scalar.size
    yield Step("MIP_SWITCH", (size, len(cases)), 3, tag)
    for value, p in cases:
        step = Step("MIP_CASE", (LENGTH, *map(hexadecimal, value.to_bytes(size, "big"))), size + 1)
        yield Part(step, (*_step(p, base, record, of + union_prefix(p)),))
