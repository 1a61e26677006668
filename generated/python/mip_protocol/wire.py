"""Functions that read and write records, compiled from their layouts on first use.

A layout has a row for each parameter, in wire order: its name, the `struct` format letters of its
numbers, and what converts these to its value:

- None: the number is the value; a callable: converts one number;
- `tuple`, a vector: the numbers together; `Each`: converts each number to an element of a tuple;
- `Bits`: a bitfield in bytes, the least significant first;
- a number: the constant that is sent; `Counts`: the number of elements of an array;
- `Text`: characters; `Items`: elements that vary in number or are not plain numbers;
- a structure; `Union`: one of several rows, selected by another parameter.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from . import codec
from .errors import Truncated

#: A parameter's name, format letters, and what converts its numbers to its value.
Row = tuple[str, str, Any]
Layout = tuple[Row, ...]


class Each(NamedTuple):
    """An array of enumerations, bitfields or Booleans."""

    kind: Any


class Bits(NamedTuple):
    """A bitfield that is sent as bytes."""

    kind: Any


class Counts(NamedTuple):
    """A counter: the number of elements of an array, and the most that a field can contain."""

    array: str
    capacity: int


class Text(NamedTuple):
    """Characters: a fixed number, a number in another parameter, or up to the end of the field."""

    length: int | str | None
    capacity: int


class Items(NamedTuple):
    """Elements of an array: structures, vectors, or numbers, converted by `kind` if given."""

    kind: Any
    length: int | str | None
    capacity: int


class Union(NamedTuple):
    """A union: another parameter's value selects the row; without one, the value is None."""

    tag: str
    cases: dict[int, Row]


class Group(NamedTuple):
    """Parameters that are present or absent together: the number of the last, and their rows."""

    last: int
    rows: Layout


def is_structure(what: Any) -> bool:
    return isinstance(what, type) and hasattr(what, "_LAYOUT")


def is_vector(what: Any) -> bool:
    return isinstance(what, type) and issubclass(what, tuple) and hasattr(what, "_make")


def is_run(row: Row) -> bool:
    """Does the row consist of a fixed number of numbers, at least one?"""
    return bool(row[1]) and not isinstance(row[2], Items)


def size(layout: Layout) -> int:
    """Returns the size of a layout in bytes, without parts of variable size."""
    total = 0
    for _, letters, what in layout:
        if isinstance(what, Text):
            total += what.length if isinstance(what.length, int) else 0
        elif isinstance(what, Items):
            total += what.length * item_size(letters, what) if isinstance(what.length, int) else 0
        elif is_structure(what):
            total += size(what._LAYOUT)
        else:
            total += struct.calcsize(f">{letters}")
    return total


def item_size(letters: str, items: Items) -> int:
    return struct.calcsize(f">{letters}") if letters else size(items.kind._LAYOUT)


def plain(kind: Any) -> Layout | None:
    """Returns the layout of a record if it consists of numbers at fixed offsets, otherwise None."""
    rows: Layout = kind._LAYOUT
    if kind._ALWAYS is not None:
        return None
    held = all(is_run(row) and not isinstance(row[2], (int, Counts)) for row in rows)
    return rows if held else None


def late(kind: Any, member: str, what: Any) -> Any:
    """Returns `what`, or `tuple` for a vector, which its attribute creates when first read."""
    return tuple if kind._VECTORS.get(member) == (what,) else what


def value(numbers: Sequence[str], what: Any, name: str, names: dict[str, Any]) -> str:
    """Returns source that converts variables to a value. What it uses is added to `names`."""
    several = f"({', '.join(numbers)},)"
    if what is None:
        return numbers[0]
    if isinstance(what, Bits):
        names[name] = what.kind
        return f"{name}(int.from_bytes(bytes({several}), 'little'))"
    if isinstance(what, Each):
        names[name] = codec.known(what.kind)
        return f"({', '.join([f'{name}[{n}]' for n in numbers])},)"
    if what is tuple:
        return several
    if is_vector(what):
        names[name] = what
        return f"{name}._make({several})"
    names[name] = codec.known(what)
    return f"{name}[{numbers[0]}]"


def selects(kind: Any) -> bool:
    """Does a function selector determine which parameters are required?"""
    return bool(getattr(kind, "REQUIRED", None))


def groups(kind: Any) -> tuple[Layout, list[Group]]:
    """Returns the rows that are always present, and groups of others. Counters stay with arrays."""
    rows: Layout = kind._LAYOUT
    if kind._ALWAYS is None:
        return rows, []
    before = 0 if selects(kind) else kind._ALWAYS  # the selector is not counted
    made, group, arrays = [], list[Row](), set[str]()
    rest = rows[kind._ALWAYS :]
    names = {row[0] for row in rest}
    for number, row in enumerate(rest, before + 1):
        group.append(row)
        arrays.discard(row[0])
        if isinstance(row[2], Counts) and row[2].array in names:
            arrays.add(row[2].array)
        if not arrays:
            made.append(Group(number, tuple(group)))
            group = []
    return rows[: kind._ALWAYS], made


class _Codec:
    """Writes the source of a class's functions."""

    def __init__(self, kind: Any) -> None:
        self.kind = kind
        self.names: dict[str, Any] = {"codec": codec, "Truncated": Truncated, "new": object.__new__}
        self.always, self.groups = groups(kind)
        self.count = 0

    def name(self, thing: Any) -> str:
        """Returns the name that the source uses for an object."""
        self.count += 1
        name = f"k{self.count}"
        self.names[name] = thing
        return name

    def slot(self, member: str) -> str:
        return f"self._{member}" if member in self.kind._VECTORS else f"self.{member}"

    @property
    def required(self) -> str:
        always = str(self.kind._ALWAYS)
        return "self.REQUIRED.get(self.function, 0)" if selects(self.kind) else always

    def function(self, head: str, lines: Sequence[str]) -> Any:
        exec(f"{head}:\n " + "\n ".join(lines), self.names)
        return self.names[head[4 : head.index("(")]]

    # ----------------------------------------------------------------- reading

    def read(self) -> Any:
        lines = ["self = new(cls)", *self.read_rows(self.always)]
        if self.groups:
            absent = [self.slot(n) for g in self.groups for n in _held(g.rows)]
            lines += [f"{' = '.join(absent)} = None", f"required = {self.required}"]
            lines += [f"done, end = {0 if selects(self.kind) else self.kind._ALWAYS}, at", "try:"]
            for last, rows in self.groups:
                lines += [f" if at == len(raw) and required < {last}: raise Truncated(1, 0)"]
                lines += [" " + line for line in self.read_rows(rows)]
                lines += [f" done, end = {last}, at"]
            lines += ["except Truncated:", " if done < required: raise"]
            for last, rows in self.groups:
                cut = [self.slot(name) for name in _held(rows[:-1])]
                lines += [f" if done < {last}: {' = '.join(cut)} = None"] if cut else []
            lines += ["at = end"]
        return self.function("def read(cls, raw, at)", [*lines, "return self, at"])

    def read_rows(self, rows: Sequence[Row], member: str = "") -> Iterator[str]:
        for part in _parts(rows):
            if is_run(part[0]):
                yield from self.read_block(part, member)
            else:
                yield from self.read_one(part[0], member)

    def read_block(self, rows: Layout, member: str) -> Iterator[str]:
        letters = "".join([row[1] for row in rows])
        self.count += 1
        numbers = [f"v{self.count}_{i}" for i in range(len(letters))]
        block = self.name(codec.Block(letters).read)
        yield f"{', '.join(numbers)}, = {block}(raw, at)"
        yield f"at += {struct.calcsize(f'>{letters}')}"
        at = 0
        for name, own, what in rows:
            mine, at = numbers[at : at + len(own)], at + len(own)
            if isinstance(what, Counts):
                yield f"n_{name} = {mine[0]}"
            elif isinstance(what, int):
                yield f"codec.constant({mine[0]}, {what})"
            else:
                self.count += 1
                kind = late(self.kind, member or name, what)
                made = value(mine, kind, f"k{self.count}", self.names)
                yield f"{self.slot(member or name)} = {made}"

    def read_one(self, row: Row, member: str) -> Iterator[str]:
        name, letters, what = row
        slot = self.slot(member or name)
        if is_structure(what):
            yield f"{slot}, at = {self.name(what)}._read(raw, at)"
            return
        if isinstance(what, Union):
            yield f"{slot} = None"
            for number, case in what.cases.items():
                yield f"if self.{what.tag} == {number}:"
                yield from (" " + line for line in self.read_rows([case], member or name))
            return
        one = 1 if isinstance(what, Text) else item_size(letters, what)
        if isinstance(what.length, str):
            yield f"n = codec.counted(raw, at, n_{what.length}, {one}, {what.capacity})"
        else:
            yield f"n = {f'codec.remaining(raw, at, {one})' if what.length is None else what.length}"
        if isinstance(what, Text):
            yield f"{slot} = codec.take(raw, at, n).decode('latin-1')"
        elif is_structure(what.kind):
            yield f"{slot}, at = codec.read_structures({self.name(what.kind)}, raw, at, n)"
            return
        elif is_vector(what.kind):
            kind = self.name(what.kind)
            yield f"{slot} = codec.read_vectors({kind}, {letters[0]!r}, {len(letters)}, raw, at, n)"
        else:
            numbers = f"codec.read_numbers({letters!r}, raw, at, n)"
            made = f"tuple(map({self.name(what.kind)}, {numbers}))" if what.kind else numbers
            yield f"{slot} = {made}"
        yield f"at += n * {one}"

    # ----------------------------------------------------------------- writing

    def write(self) -> Any:
        lines = ["out = b''", *self.write_rows(self.always)]
        if self.groups:
            table = [
                (last, tuple(_held(rows)), any(isinstance(row[2], Union) for row in rows))
                for last, rows in self.groups
            ]
            lines += [f"there = codec.present(self, {self.required}, {tuple(table)!r})"]
            for last, rows in self.groups:
                lines += [f"if there >= {last}:", *(" " + line for line in self.write_rows(rows))]
        made = "codec.finished(out)" if hasattr(self.kind, "DESCRIPTOR") else "out"
        return self.function("def write(self)", [*lines, f"return {made}"])

    def write_rows(self, rows: Sequence[Row], member: str = "") -> Iterator[str]:
        for part in _parts(rows):
            if is_run(part[0]):
                yield self.write_block(part, member)
            else:
                yield from self.write_one(part[0], member)

    def write_block(self, rows: Layout, member: str) -> str:
        given, called = [], list[str]()
        for row in rows:
            name, letters, what = member or row[0], row[1], row[2]
            called += [name] * len(letters)
            if isinstance(what, Counts):
                given.append(f"codec.count({what.array!r}, self.{what.array}, {what.capacity})")
            elif isinstance(what, int):
                given.append(str(what))
            elif isinstance(what, Bits):
                given.append(f"*codec.little({name!r}, self.{name}, {len(letters)})")
            elif is_vector(what):
                given.append(f"*codec.elements({name!r}, self.{name}, {len(letters)})")
            elif what is tuple or isinstance(what, Each):
                given.append(f"*codec.exactly({name!r}, self.{name}, {len(letters)})")
            else:
                given.append(f"self.{name}")
        block = codec.Block("".join([row[1] for row in rows]), *called)
        return f"out += {self.name(block.write)}({', '.join(given)})"

    def write_one(self, row: Row, member: str) -> Iterator[str]:
        name, letters, what = member or row[0], row[1], row[2]
        if is_structure(what):
            yield f"out += codec.structure({name!r}, self.{name}, {self.name(what)})"
            return
        if isinstance(what, Union):
            yield from self.write_union(name, what)
            return
        check = "exactly" if isinstance(what.length, int) else "at_most"
        limit = what.length if isinstance(what.length, int) else what.capacity
        values = f"codec.{check}({name!r}, self.{name}, {limit})"
        if isinstance(what, Text) and isinstance(what.length, int):
            yield f"out += codec.padded({name!r}, self.{name}, {limit})"
        elif isinstance(what, Text):
            yield values
            yield f"out += codec.text({name!r}, self.{name})"
        elif is_structure(what.kind):
            yield f"out += codec.write_structures({name!r}, {values}, {self.name(what.kind)})"
        elif is_vector(what.kind):
            yield f"out += codec.write_vectors({name!r}, {letters[0]!r}, {len(letters)}, {values})"
        else:
            yield f"out += codec.write_numbers({name!r}, {letters!r}, {values})"

    def write_union(self, name: str, union: Union) -> Iterator[str]:
        from .field import Structure

        wrong = f" raise codec.mismatch({name!r}, self.{union.tag})"
        for number, case in union.cases.items():
            yield f"if self.{union.tag} == {number}:"
            if is_structure(case[2]):
                yield f" if not isinstance(self.{name}, {self.name(case[2])}):"
            else:
                yield f" if self.{name} is None or isinstance(self.{name}, {self.name(Structure)}):"
            yield " " + wrong
            yield from (" " + line for line in self.write_rows([case], name))
        selects = f"self.{union.tag} in {tuple(union.cases)!r}"
        yield f"if self.{name} is not None and not {selects}:"
        yield wrong


def _parts(rows: Sequence[Row]) -> Iterator[Layout]:
    """Groups neighbouring rows of numbers into runs. A constant ends a run, so that a wrong one is
    reported before later errors."""
    joined: list[Row] = []
    for row in rows:
        if is_run(row):
            joined.append(row)
            if not isinstance(row[2], int):
                continue
        if joined:
            yield tuple(joined)
            joined = []
        if not is_run(row):
            yield (row,)
    if joined:
        yield tuple(joined)


def _held(rows: Sequence[Row]) -> list[str]:
    """Returns the members for these rows. Constants and counters have none."""
    return [name for name, _, what in rows if not isinstance(what, (int, Counts))]


def make_reader(kind: Any) -> Any:
    """Compiles the function that reads a record. Its arguments: the class, bytes and an offset."""
    return _Codec(kind).read()


def make_writer(kind: Any) -> Any:
    """Compiles the function that writes a record."""
    return _Codec(kind).write()
