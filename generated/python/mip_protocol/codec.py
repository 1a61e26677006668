"""Building blocks of the generated codecs."""

from __future__ import annotations

import struct
from collections.abc import Callable, Collection, Mapping, Sequence, Set
from enum import IntEnum, IntFlag
from functools import cache, lru_cache
from typing import Any, Protocol, TypeAlias, TypeVar

from .errors import DecodeError, EncodeError, Truncated

E = TypeVar("E", bound="OpenEnum")
T = TypeVar("T", bound=IntFlag)
S = TypeVar("S", bound="_Structure")
Groups = tuple[tuple[int, tuple[str, ...], bool], ...]

#: What a vector can be created from: a sequence or an array of numbers, but not bytes or text.
Numbers: TypeAlias = Collection[float]
#: And a matrix: the same row by row, or its rows.
Rows: TypeAlias = "Collection[float] | Collection[Collection[float]]"


class _Structure(Protocol):
    """The interface of `field.Structure`."""

    @classmethod
    def _read(cls: type[S], raw: bytes, at: int) -> tuple[S, int]: ...

    def _write(self) -> bytes: ...


class OpenEnum(IntEnum):
    """An enumeration that accepts unnamed values, which newer devices may send."""

    @classmethod
    def _missing_(cls: type[E], value: object) -> E | None:
        if not isinstance(value, int):
            return None
        member = int.__new__(cls, value)
        member._name_ = f"UNKNOWN_{value}"
        member._value_ = value
        return member


def open_flag(bits: int) -> Callable[[type[T]], type[T]]:
    """Makes `~` invert all bits of a bitfield, so that `flags & ~Flags.X` clears only X.

    Python itself inverts only the named bits or, in older versions, returns a negative number. It
    also keeps an object for every combination of bits that it ever sees; here they are not kept.
    """

    def opened(kind: type[T]) -> type[T]:
        every = (1 << bits) - 1
        combine, kept = kind._missing_, kind._value2member_map_
        named = frozenset(kept)

        def missing(cls: type[T], value: object) -> Any:
            flags = combine(value)
            number = getattr(flags, "_value_", None)
            if number not in named:
                kept.pop(number, None)
            return flags

        kind._missing_ = classmethod(missing)  # type: ignore[assignment]
        kind.__invert__ = lambda self: type(self)(int(self) ^ every)  # type: ignore[method-assign]
        return kind

    return opened


class Known(dict[int, Any]):
    """Numbers as members of an enumeration or a bitfield: faster than looking up each, and bounded."""

    SIZE = 1024

    def __init__(self, kind: Callable[[int], Any]) -> None:
        super().__init__()
        self._kind = kind

    def __missing__(self, number: int) -> Any:
        if len(self) >= self.SIZE:
            self.clear()
        member = self[number] = self._kind(number)
        return member


@cache
def known(kind: Callable[[int], Any]) -> Known:
    """The one of a type."""
    return Known(kind)


def fits(name: str, value: int, bits: int) -> int:
    """A number for some bits of a bitfield, if they can hold it."""
    if not 0 <= value < 1 << bits:
        raise EncodeError("range", f"{name}: {value} does not fit into {bits} bits")
    return value


class Block:
    """A run of numbers with a fixed layout, read and written at once.

    Floats keep their bits, even those of signalling NaNs, which Python's conversion between four
    and eight bytes would change.
    """

    __slots__ = ("_codec", "_names", "_singles", "size")

    def __init__(self, layout: str, *names: str) -> None:
        self._codec = struct.Struct(">" + layout)
        self._names = names
        self.size = self._codec.size
        self._singles = _singles(layout)

    def read(self, data: bytes, at: int) -> tuple[Any, ...]:
        try:
            values = self._codec.unpack_from(data, at)
        except struct.error:
            raise Truncated(self.size, len(data) - at) from None
        if self._singles:
            total = 0.0
            for index, _ in self._singles:
                total += values[index]
            if total != total:
                return self._read_exactly(values, data, at)
        return values

    def _read_exactly(self, values: tuple[Any, ...], data: bytes, at: int) -> tuple[Any, ...]:
        exact = list(values)
        for index, offset in self._singles:
            start = at + offset
            exact[index] = single_from_bits(int.from_bytes(data[start : start + 4], "big"))
        return tuple(exact)

    def write(self, *values: Any) -> bytes:
        try:
            packed = self._codec.pack(*values)
        except (struct.error, OverflowError, TypeError) as error:
            raise self._complaint(values, error) from None
        for index, offset in self._singles:
            if values[index] != values[index]:
                bits = single_to_bits(values[index]).to_bytes(4, "big")
                packed = packed[:offset] + bits + packed[offset + 4 :]
        return packed

    def _complaint(self, values: Sequence[Any], error: Exception) -> EncodeError:
        numbers = [n for n, value in enumerate(values) if value is None]
        if numbers:
            return EncodeError("missing", f"{self._path(numbers[0])} is None")
        for n, (letter, value) in enumerate(zip(self._codec.format[1:], values)):
            needs = _needs(letter, value)
            if needs:
                return EncodeError("range", f"{self._path(n)} is {value!r}, needs {needs}")
        return EncodeError("range", f"{', '.join(dict.fromkeys(self._names))}: {error}")

    def _path(self, number: int) -> str:
        """The name of a value, with its index if it is one of several."""
        name = self._names[min(number, len(self._names) - 1)]
        if name.endswith("[]"):
            return f"{name[:-1]}{number}]"
        index = self._names[:number].count(name)
        return f"{name}[{index}]" if self._names.count(name) > 1 else name


def _needs(letter: str, value: Any) -> str:
    """The requirement of `struct` that a value violates; empty if there is none."""
    try:
        struct.pack(">" + letter, value)
        return ""
    except (struct.error, OverflowError, TypeError):
        pass
    if letter in "fd":
        number = isinstance(value, (int, float))
        return "-3.4028235e+38 to 3.4028235e+38" if number and letter == "f" else "a number"
    bits = 8 * struct.calcsize(">" + letter)
    least = 0 if letter.isupper() else -(2 ** (bits - 1))
    most = least + 2**bits - 1
    return f"{'' if isinstance(value, int) else WHOLE}{least} to {most}"


#: The requirement for what is not a number; `typed` is more exact if it knows the type.
WHOLE = "a whole number from "


def typed(record: Any, error: EncodeError) -> EncodeError:
    """An error of a value of a field or structure, with the type that the value should have."""
    from .reflection import info

    for p in info(type(record)).members:
        begin = f"{p.attribute} is {getattr(record, p.attribute)!r}, needs "
        if error.detail.startswith(begin + WHOLE):
            if p.scalar == "bool":
                return EncodeError(error.kind, f"{begin}True or False")
            if isinstance(p.type, type):
                return EncodeError(error.kind, begin + with_article(p.type))
    return error


def within(path: str, error: EncodeError) -> EncodeError:
    """An error of a part, with the path to the part before its own."""
    joint = "." if path and error.detail[:1] not in ("[", " ") else ""
    return EncodeError(error.kind, f"{path}{joint}{error.detail}")


def with_article(kind: type) -> str:
    """A type with its article: "an AckCode"."""
    return f"a{'n' * (kind.__name__[0] in 'AEIOU')} {kind.__name__}"


def _singles(layout: str) -> tuple[tuple[int, int], ...]:
    """Index and offset of each four-byte float."""
    singles, offset = [], 0
    for index, letter in enumerate(layout):
        if letter == "f":
            singles.append((index, offset))
        offset += struct.calcsize(">" + letter)
    return tuple(singles)


def single_from_bits(bits: int) -> float:
    """The float of a four-byte pattern; a NaN keeps its payload."""
    if bits & 0x7F800000 == 0x7F800000 and bits & 0x007FFFFF:
        wide = (bits >> 31) << 63 | 0x7FF << 52 | (bits & 0x007FFFFF) << 29
        value: float = struct.unpack(">d", wide.to_bytes(8, "big"))[0]
    else:
        value = struct.unpack(">f", bits.to_bytes(4, "big"))[0]
    return value


def single_to_bits(value: float) -> int:
    """The four-byte pattern of a float."""
    if value != value:
        wide = int.from_bytes(struct.pack(">d", value), "big")
        return (wide >> 63) << 31 | 0xFF << 23 | ((wide >> 29) & 0x007FFFFF or 0x00400000)
    return int.from_bytes(struct.pack(">f", value), "big")


def truth(value: int) -> bool:
    """A byte as a bool. Bytes other than 0 and 1 remain numbers."""
    return bool(value) if value < 2 else value  # type: ignore[return-value]


def take(data: bytes, at: int, size: int) -> bytes:
    if size > len(data) - at:
        raise Truncated(size, len(data) - at)
    return data[at : at + size]


def counted(data: bytes, at: int, count: int, size: int, capacity: int) -> int:
    """`count`, if as many elements of `size` bytes follow, and a field can hold them."""
    if count * size > len(data) - at:
        raise DecodeError("count", f"{count} elements counted, {len(data) - at} bytes follow")
    if count > capacity:
        raise DecodeError("count", f"{count} elements counted, a field holds {capacity}")
    return count


def remaining(data: bytes, at: int, size: int) -> int:
    """The number of elements of `size` bytes that follow."""
    return (len(data) - at) // size


@lru_cache(maxsize=256)
def _array(name: str, letter: str, count: int) -> Block:
    return Block(letter * count, f"{name}[]")


def read_numbers(letter: str, data: bytes, at: int, count: int) -> tuple[Any, ...]:
    return _array("", letter, count).read(data, at)


def write_numbers(name: str, letter: str, values: Sequence[Any]) -> bytes:
    return _array(name, letter, len(values)).write(*values)


def read_vectors(
    kind: type[Any], letter: str, width: int, data: bytes, at: int, count: int
) -> tuple[Any, ...]:
    values = _array("", letter, width * count).read(data, at)
    return tuple([kind._make(values[i : i + width]) for i in range(0, width * count, width)])


def write_vectors(name: str, letter: str, width: int, values: Sequence[Any]) -> bytes:
    return _each(name, values, lambda v: write_numbers("", letter, elements("", v, width)))


def read_structures(kind: type[S], data: bytes, at: int, count: int) -> tuple[tuple[S, ...], int]:
    read, structures = kind._read, []
    for _ in range(count):
        value, at = read(data, at)
        structures.append(value)
    return tuple(structures), at


def structure(name: str, value: _Structure | None, kind: type[_Structure]) -> bytes:
    """The bytes of a structure, if it is one of the right kind."""
    if value is None:
        raise EncodeError("missing", f"{name} is None")
    if not isinstance(value, kind):
        raise EncodeError("range", f"{name} is {value!r}, needs {with_article(kind)}")
    try:
        return value._write()
    except EncodeError as error:
        raise within(name, typed(value, error)) from None


def write_structures(name: str, values: Sequence[Any], kind: type[_Structure]) -> bytes:
    return _each(name, values, lambda v: structure("", v, kind))


def _each(name: str, values: Sequence[Any], write: Callable[[Any], bytes]) -> bytes:
    out: list[bytes] = []
    for v in values:
        try:
            out.append(write(v))
        except EncodeError as error:
            raise within(f"{name}[{len(out)}]", error) from None
    return b"".join(out)


def little(name: str, value: int, size: int) -> bytes:
    """A bitfield in bytes, least significant byte first."""
    if value is None:
        raise EncodeError("missing", f"{name} is None")
    limits = f"0 to {256**size - 1}"
    if not isinstance(value, int):
        raise EncodeError("range", f"{name} is {value!r}, needs {WHOLE}{limits}")
    try:
        return value.to_bytes(size, "little")
    except OverflowError:
        raise EncodeError("range", f"{name} is {value}, needs {limits}") from None


def constant(number: int, wanted: int) -> None:
    if number != wanted:
        raise DecodeError("constant", f"{number} should be {wanted}")


def exactly(name: str, value: Any, count: int) -> Sequence[Any]:
    """`value`, if it has as many elements as it must have."""
    if len(sized(name, value)) != count:
        raise EncodeError("count", f"{name} has {len(value)} elements, needs {count}")
    return sized(name, value)


def at_most(name: str, value: Any, capacity: int) -> Sequence[Any]:
    """`value`, if it has no more elements than a field can hold."""
    if len(sized(name, value)) > capacity:
        raise EncodeError("count", f"{name} has {len(value)} elements, a field holds {capacity}")
    return sized(name, value)


def count(name: str, value: Any, capacity: int) -> int:
    """The number of elements, if a field can hold them."""
    return len(at_most(name, value, capacity))


def sized(name: str, value: Any) -> Sequence[Any]:
    """`value`, if it is a sequence, or its elements, if it is an array."""
    if value is None:
        raise EncodeError("missing", f"{name} is None")
    items = value if isinstance(value, Sequence) else _listed(value)
    if not isinstance(items, Sequence):
        raise EncodeError("count", f"{name} is {value!r}, needs a sequence")
    return items


def elements(name: str, value: Any, count: int) -> Sequence[Any]:
    """The elements of a vector, if they are as many as they must be."""
    if value is None:
        raise EncodeError("missing", f"{name} is None")
    numbers = _numbers(value)
    if numbers is None:
        raise EncodeError("count", f"{name} is {value!r}, needs {count} numbers")
    return exactly(name, numbers, count)


def vector(value: Any, *kinds: type[Any]) -> Any:
    """`value` as a vector of the first kind that has as many elements.

    Anything else is returned unchanged; it is rejected when it is sent.
    """
    if type(value) in kinds or (numbers := _numbers(value)) is None:
        return value
    for kind in kinds:
        if len(numbers) == len(kind._fields):
            return kind._make(numbers)
    return value


def vectors(value: Any, *kinds: type[Any]) -> Any:
    """Several vectors, as `vector` makes each of them."""
    items = _listed(value)
    return tuple([vector(v, *kinds) for v in items]) if isinstance(items, Sequence) else value


def several(value: Any) -> Any:
    """An array as the tuple that a decoder makes; anything else is returned unchanged, as by `vector`."""
    if type(value) is tuple:
        return value
    items = value if isinstance(value, (bytes, bytearray)) else _listed(value)
    return tuple(items) if isinstance(items, Sequence) else value


def element(matrix: tuple[float, ...], at: Any, columns: int) -> Any:
    """An element of a matrix by row and column, counted from 0; else as of any tuple."""
    if isinstance(at, tuple):
        rows = len(matrix) // columns
        try:
            row, column = at
            at = range(rows)[row] * columns + range(columns)[column]
        except (IndexError, TypeError, ValueError) as error:
            kind = IndexError if isinstance(error, IndexError) else TypeError
            needs = f"needs one of {rows} rows and one of {columns} columns, from 0"
            raise kind(f"a matrix {needs}, not {at}; `rows` has whole rows") from None
    return tuple.__getitem__(matrix, at)


def _numbers(value: Any) -> Sequence[Any] | None:
    """The numbers that a vector is made of, or those of a matrix, row by row."""
    numbers = _listed(value)
    if not isinstance(numbers, Sequence):
        return None
    if any(hasattr(v, "__len__") for v in numbers):
        rows = [_listed(v) for v in numbers]
        if not all(isinstance(row, Sequence) for row in rows):
            return None
        return [number for row in rows for number in row]
    return numbers


def _listed(value: Any) -> Any:
    """The elements of a sequence, or of an array of numbers of another library; bytes and text have none."""
    if isinstance(value, (str, bytes, bytearray, memoryview, Mapping, Set)):
        return None
    if isinstance(value, Sequence) or not hasattr(value, "__len__"):
        return value
    return value.tolist() if hasattr(value, "tolist") else None


def text(name: str, value: Any) -> bytes:
    """Characters, one byte each."""
    if not isinstance(value, str):
        raise EncodeError("range", f"{name} is {value!r}, needs a str")
    try:
        return value.encode("latin-1")
    except UnicodeEncodeError:
        raise EncodeError("range", f"{name}: characters must be one byte each") from None


def padded(name: str, value: Any, count: int) -> bytes:
    """The characters of a text of fixed length; a shorter one ends with spaces, as those of devices do."""
    return text(name, exactly(name, value.ljust(count) if isinstance(value, str) else value, count))


def mismatch(name: str, tag: object) -> EncodeError:
    return EncodeError("tag", f"{name} is not the member that {tag!r} selects")


def present(value: object, required: int, groups: Groups) -> int:
    """The number of parameters that are present: those up to the first group with a None.

    A group is the number of its last parameter, its names, and whether it is a union, which
    may be None where it is required: then it is empty.
    """
    last, ended = 0, ""
    for number, names, union in groups:
        empty = union and number <= required
        absent = [] if empty else [name for name in names if getattr(value, name) is None]
        if absent and (number <= required or len(absent) < len(names)):
            raise EncodeError("missing", f"{absent[0]} is None")
        if absent:
            ended = ended or absent[0]
        elif ended:
            raise EncodeError("missing", f"{ended} is None, but {names[0]} is not")
        else:
            last = number
    return last


def finished(data: bytes) -> bytes:
    if len(data) > 253:
        raise EncodeError("length", f"{len(data)} bytes, a field holds 253")
    return data
