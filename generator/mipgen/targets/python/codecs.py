"""The functions that read and write a record, as lines of Python. What they call is in the package's module `codec`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, groupby

from mipgen import model as m
from mipgen.lower import extent
from mipgen.lower.runs import run

from .members import Member
from .names import SCALARS, home, reference

#: A sum of so many floats is written out.
_FEW = 4
#: The width of a line in a method.
_WIDTH = 92


@dataclass(frozen=True)
class Row:
    """A parameter as it is on the wire."""

    of: m.Parameter
    member: Member  # itself, or the union of which it is an alternative

    @property
    def name(self) -> str:
        return self.member.name

    @cached_property
    def letters(self) -> str:
        """The letters for `struct` if it is a fixed number of numbers, at least one; else none."""
        numbers = None if self.of.kind == "text" else run(self.of)
        return SCALARS[numbers.scalar.name] * (1 if numbers.count is None else numbers.count) if numbers else ""

    @property
    def where(self) -> str:
        return home(self.member.record)

    @property
    def slot(self) -> str:
        """The attribute that its value is stored in. That of a vector creates it from numbers when it is first read."""
        return f"self._{self.name}" if self.member.vectors and self.member.of.length is None else f"self.{self.name}"

    def value(self, first: int, total: int, v: str = "v") -> str:
        """Writes the value that some of the numbers in the variable `v` make, from the number `first` on."""
        last = first + len(self.letters)
        several = v if last - first == total and total > 1 else f"{v}[{first}:{last}]" if first else f"{v}[:{last}]"
        p, where = self.of, self.where
        if p.vector:
            return several if self.member.vectors == [p.vector] else f"{reference(p.vector, where)}._make({several})"
        if p.kind == "bits":
            number = f'int.from_bytes(bytes({several}), "little")'
            return f"{reference(p.named, where)}({number})" if p.named else number
        convert = self.conversion
        if p.kind == "array":
            return f"tuple([{convert}[x] for x in {several}])" if convert else several
        return f"{convert}[{v}[{first}]]" if convert else f"{v}[{first}]"

    @property
    def conversion(self) -> str:
        """The table that converts a number to a value; empty if the number is the value."""
        leaf = self.of.leaf
        if leaf.named is not None:
            return f"codec.KNOWN[{reference(leaf.named, self.where)}]"
        return "codec.TRUTH" if leaf.kind == "scalar" and leaf.scalar.kind == "bool" else ""

    @property
    def argument(self) -> str:
        """Writes the numbers of its value."""
        p, own, count = self.of, f"self.{self.name}", len(self.letters)
        if p.counts is not None:
            (array,) = (q for q in self.member.record.parameters if q.name == p.counts)
            name = Member(array, self.member.record).name
            return f'codec.count("{name}", self.{name}, {array.capacity})'
        if p.constant is not None:
            return str(p.constant)
        if p.kind == "bits":
            return f'*codec.little("{self.name}", {own}, {count})'
        if p.vector:
            return f'*codec.elements("{self.name}", {own}, {count})'
        return f'*codec.exactly("{self.name}", {own}, {count})' if p.kind == "array" else own


class Codec:
    """The functions of one record. Empty lines of code mean that its base class does the same."""

    def __init__(self, record: m.Record) -> None:
        self.record = record
        self.where = home(record)
        #: The formats of the blocks that the functions use.
        self.blocks: set[str] = set()
        self.reads = [*self._read()] if record.parameters else []
        self.writes = [*self._write()] if record.parameters else []

    @cached_property
    def rows(self) -> list[Row]:
        return self._rows(self.record.parameters)

    def _rows(self, parameters: Iterable[m.Parameter]) -> list[Row]:
        return [Row(p, Member(p, self.record)) for p in parameters]

    @cached_property
    def size(self) -> int | None:
        """The size of a record of plain numbers at fixed offsets, which need no further check; None for others."""
        plain = not self.record.optional and all(x.letters and not x.of.derived for x in self.rows)
        return sum(extent.size(x.of)[0] for x in self.rows) if plain else None

    @cached_property
    def groups(self) -> list[tuple[int, list[Row]]]:
        """Parameters that may be absent, together: the number of the last, and their rows."""
        return [(group.last, self._rows(group.parameters)) for group in self.record.groups]

    @property
    def selects(self) -> bool:
        """True if a function selector determines which parameters are required."""
        return bool(getattr(self.record, "selector", None))

    @property
    def required(self) -> str:
        return "self.REQUIRED.get(self.function, 0)" if self.selects else str(len(self.record.always))

    @property
    def are_single(self) -> bool:
        """True if all parameters that may be absent are numbers, at fixed offsets."""
        return all(len(rows) == 1 and rows[0].letters and not rows[0].of.derived for _, rows in self.groups)

    def block(self, letters: str) -> str:
        """Returns the name of the block for numbers with these letters."""
        layout = "".join(f"{n if n > 1 else ''}{letter}" for letter, n in _runs(letters))
        self.blocks.add(layout)
        return f"_{layout}"

    # ----------------------------------------------------------------- reading

    def _read(self) -> Iterator[str]:
        if self.size is not None:
            yield from self._plain()
            return
        always = self._rows(self.record.always)
        yield from self._read_rows(always)
        if not self.groups:
            yield "return at"
            return
        if self.are_single:
            yield from self._read_singles()
            return
        absent = [x.slot for _, rows in self.groups for x in rows if not x.of.derived]
        yield f"{' = '.join(absent)} = None"
        yield f"required = {self.required}"
        yield f"done, end = {0 if self.selects else len(self.record.always)}, at"
        yield "try:"
        for last, rows in self.groups:
            yield f"    codec.check_more(raw, at, required < {last})"
            yield from _indented(self._read_rows(rows))
            yield f"    done, end = {last}, at"
        yield "except codec.Truncated:"
        yield "    if done < required:"
        yield "        raise"
        for last, rows in self.groups:
            if cut := [x.slot for x in rows[:-1] if not x.of.derived]:
                yield f"if done < {last}:"
                yield f"    {' = '.join(cut)} = None"
        yield "return end"

    def _plain(self) -> Iterator[str]:
        letters = "".join(x.letters for x in self.rows)
        block = self.block(letters)
        read = f"{block}.unpack(raw, at)"
        singles = [i for i, letter in enumerate(letters) if letter == "f"]
        if singles:  # Python changes the bits of some NaNs; if there is one, the sum is NaN, too
            yield f"v = {read}"
            first, last = singles[0], singles[-1] + 1
            dense = "v" if last - first == len(letters) else f"v[{first}:{last}]"
            total = " + ".join(f"v[{i}]" for i in singles) if len(singles) <= _FEW else f"sum({dense})"
            yield f"if {total} != {total}:" if len(singles) == 1 else f"if (total := {total}) != total:"
            yield f"    v = {block}.keep_nan_bits(v, raw, at)"
        yield from self._values(self.rows, "v" if singles else read)
        yield f"return at + {self.size}"

    def _values(self, rows: Sequence[Row], numbers: str = "v") -> Iterator[str]:
        """Yields the lines that store values, given their numbers: a variable, or how they are read."""
        total, first = sum(len(x.letters) for x in rows), 0
        if total > 1 and all(len(x.letters) == 1 and not x.of.derived and not x.conversion for x in rows):
            yield f"{', '.join(x.slot for x in rows)} = {numbers}"
            return
        if len(rows) == 1 and not rows[0].of.derived:
            yield f"{rows[0].slot} = {rows[0].value(0, total, numbers)}"
            return
        if numbers != "v":
            yield f"v = {numbers}"
        for x in rows:
            if x.of.counts is not None:
                yield f"n_{x.name} = v[{first}]"
            elif x.of.constant is not None:
                yield f"codec.constant(v[{first}], {x.of.constant})"
            else:
                yield f"{x.slot} = {x.value(first, total)}"
            first += len(x.letters)

    def _read_singles(self) -> Iterator[str]:
        """Yields a line for each parameter that may be absent, if all are numbers."""
        ends = [0, *accumulate(extent.size(x.of)[0] for _, (x,) in self.groups)]
        required = self.required if self.selects else 0
        yield f"there, end = codec.find_present(raw, at, {required}, {tuple(ends)!r})"
        for number, (_, (x,)) in enumerate(self.groups, 1):
            place = f"at + {ends[number - 1]}" if number > 1 else "at"
            numbers = f"{self.block(x.letters)}.read(raw, {place})"
            yield f"{x.slot} = {x.value(0, len(x.letters), numbers)} if there >= {number} else None"
        yield "return end"

    def _read_rows(self, rows: Sequence[Row]) -> Iterator[str]:
        for part in _parts(rows):
            if letters := "".join(x.letters for x in part):
                yield from self._values(part, f"{self.block(letters)}.read(raw, at)")
                yield f"at += {sum(extent.size(x.of)[0] for x in part)}"
            else:
                yield from self._read_one(part[0])

    def _read_one(self, x: Row) -> Iterator[str]:
        p, item = x.of, x.of.item
        if p.struct:
            yield f"{x.slot}, at = {reference(p.struct, self.where)}._decoded(raw, at)"
            return
        if p.union:
            yield f"{x.slot} = None"
            for number, case in self._cases(x):
                yield f"if {number}:"
                yield from _indented(self._read_rows([case]))
            return
        size = extent.size(item)[0] if p.kind != "text" else 1
        if p.counter:
            counter = Member(next(q for q in self.record.parameters if q.name == p.counter), self.record).name
            yield f"n = codec.counted(raw, at, n_{counter}, {size}, {p.capacity})"
        else:
            yield f"n = {p.count if p.count is not None else f'codec.remaining(raw, at, {size})'}"
        if p.kind == "text":
            yield f'{x.slot} = codec.take(raw, at, n).decode("latin-1")'
        elif item.struct:
            yield f"{x.slot}, at = codec.read_structures({reference(item.struct, self.where)}, raw, at, n)"
            return
        elif item.vector:
            vector = reference(item.vector, self.where)
            letter, width = SCALARS[item.scalar.name], item.capacity
            yield f'{x.slot} = codec.read_vectors({vector}, "{letter}", {width}, raw, at, n)'
        else:
            numbers = f'codec.read_numbers("{SCALARS[item.scalar.name]}", raw, at, n)'
            yield f"{x.slot} = " + (f"tuple([{x.conversion}[x] for x in {numbers}])" if x.conversion else numbers)
        yield f"at += n * {size}" if size > 1 else "at += n"

    def _cases(self, x: Row) -> Iterator[tuple[str, Row]]:
        """Yields the condition under which a union has an alternative, and that."""
        assert x.of.union
        tag = next(y.name for y in self.rows if y.of.name == x.of.union.tag)
        for case in x.of.cases:
            if case.parameter is not None:
                yield f"self.{tag} == {case.tag.value}", Row(case.parameter, x.member)

    # ----------------------------------------------------------------- writing

    def _write(self) -> Iterator[str]:
        always = self._rows(self.record.always)
        parts = [*_parts(always)]
        if not self.groups and len(parts) == 1 and parts[0][0].letters:
            yield f"return {self._packed(parts[0])}"
            return
        lines = [*self._write_rows(always)]
        if lines and lines[0].startswith("out += "):
            yield lines.pop(0).replace("+=", "=", 1)
        else:
            yield 'out = b""'
        yield from lines
        if self.groups:
            table = []
            for last, rows in self.groups:
                union = "?" * any(x.of.union is not None for x in rows)
                names = " ".join(x.name for x in rows if not x.of.derived)
                table.append(f'({last}, "{names}{union}")')
            yield f"there = codec.count_present(self, {self.required}, {', '.join(table)})"
            for last, rows in self.groups:
                lines = [*self._write_rows(rows)]
                whole = f'{lines[0]} if there >= {last} else b""'
                if len(lines) == 1 and len(whole) <= _WIDTH:
                    yield whole
                else:
                    yield f"if there >= {last}:"
                    yield from _indented(lines)
        yield "return codec.finished(out)" if isinstance(self.record, m.Field) else "return out"

    def _write_rows(self, rows: Sequence[Row]) -> Iterator[str]:
        for part in _parts(rows):
            if part[0].letters:
                yield f"out += {self._packed(part)}"
            else:
                yield from self._write_one(part[0])

    def _packed(self, rows: Sequence[Row]) -> str:
        letters = "".join(x.letters for x in rows)
        names = " ".join(f"{x.name}*{len(x.letters)}" if len(x.letters) > 1 else x.name for x in rows)
        return f'{self.block(letters)}.write("{names}", {", ".join(x.argument for x in rows)})'

    def _write_one(self, x: Row) -> Iterator[str]:
        p, item, name, own = x.of, x.of.item, f'"{x.name}"', f"self.{x.name}"
        if p.struct:
            yield f"out += codec.structure({name}, {own}, {reference(p.struct, self.where)})"
            return
        if p.union:
            yield from self._write_union(x)
            return
        if p.kind == "text" and p.count is not None:
            yield f"out += codec.padded({name}, {own}, {p.count})"
            return
        check = "at_most" if p.count is None else "exactly"
        values = f"codec.{check}({name}, {own}, {p.capacity if p.count is None else p.count})"
        if p.kind == "text":
            yield values
            yield f"out += codec.text({name}, {own})"
        elif item.struct:
            yield f"out += codec.write_structures({name}, {values}, {reference(item.struct, self.where)})"
        elif item.vector:
            letter, width = SCALARS[item.scalar.name], item.capacity
            yield f'out += codec.write_vectors({name}, "{letter}", {width}, {values})'
        else:
            yield f'out += codec.write_numbers({name}, "{SCALARS[item.scalar.name]}", {values})'

    def _write_union(self, x: Row) -> Iterator[str]:
        own, choice = f"self.{x.name}", "if"
        assert x.of.union
        tag = next(y.name for y in self.rows if y.of.name == x.of.union.tag)
        for condition, case in self._cases(x):
            struct = case.of.struct
            kind = reference(struct, self.where) if struct else "None"
            yield f"{choice} {condition}:"
            yield f'    codec.check_selected("{x.name}", {own}, self.{tag}, {kind})'
            yield from _indented(self._write_rows([case]))
            choice = "elif"
        yield "else:"
        yield f'    codec.check_unselected("{x.name}", {own}, self.{tag})'


def _runs(letters: str) -> Iterator[tuple[str, int]]:
    return ((letter, len([*same])) for letter, same in groupby(letters))


def _indented(lines: Iterable[str]) -> Iterator[str]:
    return (f"    {line}" for line in lines)


def _parts(rows: Sequence[Row]) -> Iterator[list[Row]]:
    """Groups neighbouring rows of numbers. A constant ends a group, so that a wrong one is reported before later
    errors."""
    joined: list[Row] = []
    for x in rows:
        if x.letters:
            joined.append(x)
            if x.of.constant is None:
                continue
        if joined:
            yield joined
            joined = []
        if not x.letters:
            yield [x]
    if joined:
        yield joined
