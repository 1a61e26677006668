"""Building blocks of the generated codecs."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Collection, Mapping, Sequence, Set
from enum import IntEnum, IntFlag
from functools import lru_cache
from typing import Any, Protocol, TypeAlias, TypeVar

from .exceptions import DecodeError, EncodeError
from .exceptions import Truncated as Truncated

E = TypeVar("E", bound="OpenEnum")
T = TypeVar("T", bound=IntFlag)
S = TypeVar("S", bound="_Structure")

#: A vector, or what can be converted to one: a sequence or array of numbers, but not bytes or text.
Numbers: TypeAlias = Collection[float]
#: A matrix, or what can be converted to one: all elements row by row, or a sequence of rows.
Rows: TypeAlias = "Collection[float] | Collection[Collection[float]]"


class _Structure(Protocol):
    """The interface of `field.Structure`."""

    @classmethod
    def _decoded(cls: type[S], raw: bytes, at: int) -> tuple[S, int]: ...

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
    also caches an object for every combination of bits ever seen; this class does not.
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


class MemberCache(dict[int, Any]):
    """A bounded cache of members of an enumeration or a bitfield; faster than calling the type."""

    SIZE = 1024

    def __init__(self, kind: Callable[[int], Any]) -> None:
        super().__init__()
        self._kind = kind

    def __missing__(self, number: int) -> Any:
        if len(self) >= self.SIZE:
            self.clear()
        member = self[number] = self._kind(number)
        return member


class _Caches(dict[Any, MemberCache]):
    def __missing__(self, kind: Any) -> MemberCache:
        made = self[kind] = MemberCache(kind)
        return made


#: Enumeration or bitfield -> its members by number.
KNOWN = _Caches()
#: A byte -> its bool. Bytes other than 0 and 1 remain numbers.
TRUTH: tuple[Any, ...] = (False, True, *range(2, 256))


def fits(name: str, value: int, bits: int) -> int:
    """Returns a number if it fits into some bits of a bitfield; otherwise raises EncodeError."""
    if not 0 <= value < 1 << bits:
        raise EncodeError("range", f"{name}: {value} does not fit into {bits} bits")
    return value


class Block:
    """Numbers in a fixed layout, which are read and written together.

    Floats keep their bits. Python's conversion between four and eight bytes would change the bits
    of signalling NaNs.
    """

    __slots__ = ("_layout", "pack", "size", "unpack")

    def __init__(self, layout: str) -> None:
        codec = struct.Struct(">" + layout)
        self.pack, self.unpack, self.size = codec.pack, codec.unpack_from, codec.size
        self._layout = layout

    def read(self, data: bytes, at: int) -> tuple[Any, ...]:
        """Reads the numbers at an offset. Raises Truncated."""
        if self.size > len(data) - at:
            raise Truncated(self.size, len(data) - at)
        values = self.unpack(data, at)
        if "f" in self._layout and (total := sum(values)) != total:  # one of them may be NaN
            return self.keep_nan_bits(values, data, at)
        return values

    def keep_nan_bits(self, values: tuple[Any, ...], data: bytes, at: int) -> tuple[Any, ...]:
        """Returns the numbers that were read at an offset; NaNs of four bytes keep their bits."""
        made = list(values)
        for index, offset in _singles(self._layout):
            if values[index] != values[index]:
                start = at + offset
                made[index] = single_from_bits(int.from_bytes(data[start : start + 4], "big"))
        return tuple(made)

    def write(self, names: str, *values: Any) -> bytes:
        """Encodes numbers. The names of their parameters, as in "time accel*3", are for errors."""
        try:
            packed: bytes = self.pack(*values)
        except (struct.error, OverflowError, TypeError) as error:
            raise self._complaint(names.split(), values, error) from None
        for index, offset in _singles(self._layout):
            if values[index] != values[index]:
                bits = single_to_bits(values[index]).to_bytes(4, "big")
                packed = packed[:offset] + bits + packed[offset + 4 :]
        return packed

    def _complaint(
        self, names: Sequence[str], values: Sequence[Any], error: Exception
    ) -> EncodeError:
        paths: list[str] = []
        for name, star, count in (name.partition("*") for name in names):
            paths += [f"{name}[{i}]" for i in range(int(count))] if star else [name]
        missing = [path for path, value in zip(paths, values) if value is None]
        if missing:
            return EncodeError("missing", f"{missing[0]} is None")
        for path, letter, value in zip(paths, _expanded(self._layout), values):
            needs = _needs(letter, value)
            if needs:
                return EncodeError("range", f"{path} is {value!r}, needs {needs}")
        return EncodeError("range", f"{', '.join(names)}: {error}")


def _needs(letter: str, value: Any) -> str:
    """Returns the requirement of `struct` that a value violates, or an empty text."""
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


#: Begins the requirement for what is not a number; `typed` replaces it if it knows the type.
WHOLE = "a whole number from "


def typed(record: Any, error: EncodeError) -> EncodeError:
    """Returns the error with the type that the value should have, if it is of the wrong type."""
    info = getattr(record, "INFO", None)  # the user's own class has none
    for p in info.members if info else ():
        begin = f"{p.attribute} is {getattr(record, p.attribute)!r}, needs "
        if error.detail.startswith(begin + WHOLE):
            if p.scalar == "bool":
                return EncodeError(error.kind, f"{begin}True or False")
            if isinstance(p.type, type):
                return EncodeError(error.kind, begin + with_article(p.type))
    return error


def within(path: str, error: EncodeError) -> EncodeError:
    """Returns a part's error, with the part's path in front of the error's own."""
    joint = "." if path and error.detail[:1] not in ("[", " ") else ""
    return EncodeError(error.kind, f"{path}{joint}{error.detail}")


def with_article(kind: type) -> str:
    """Returns a type's name with its article: "an AckCode"."""
    return f"a{'n' * (kind.__name__[0] in 'AEIOU')} {kind.__name__}"


def _expanded(layout: str) -> str:
    """Writes out repetitions: "fff" for "3f"."""
    return re.sub(r"(\d+)(.)", lambda repeated: int(repeated[1]) * repeated[2], layout)


@lru_cache(maxsize=512)
def _singles(layout: str) -> tuple[tuple[int, int], ...]:
    """Returns index and offset of each four-byte float."""
    singles, offset = [], 0
    for index, letter in enumerate(_expanded(layout) if "f" in layout else ""):
        if letter == "f":
            singles.append((index, offset))
        offset += struct.calcsize(">" + letter)
    return tuple(singles)


def single_from_bits(bits: int) -> float:
    """Converts a four-byte pattern to a float; a NaN keeps its payload."""
    if bits & 0x7F800000 == 0x7F800000 and bits & 0x007FFFFF:
        wide = (bits >> 31) << 63 | 0x7FF << 52 | (bits & 0x007FFFFF) << 29
        value: float = struct.unpack(">d", wide.to_bytes(8, "big"))[0]
    else:
        value = struct.unpack(">f", bits.to_bytes(4, "big"))[0]
    return value


def single_to_bits(value: float) -> int:
    """Converts a float to its four-byte pattern."""
    if value != value:
        wide = int.from_bytes(struct.pack(">d", value), "big")
        return (wide >> 63) << 31 | 0xFF << 23 | ((wide >> 29) & 0x007FFFFF or 0x00400000)
    return int.from_bytes(struct.pack(">f", value), "big")


def take(data: bytes, at: int, size: int) -> bytes:
    if size > len(data) - at:
        raise Truncated(size, len(data) - at)
    return data[at : at + size]


def counted(data: bytes, at: int, count: int, size: int, capacity: int) -> int:
    """Returns `count` if that many elements of `size` bytes follow and a field can contain them;
    otherwise raises DecodeError."""
    if count * size > len(data) - at:
        raise DecodeError("count", f"{count} elements counted, {len(data) - at} bytes follow")
    if count > capacity:
        raise DecodeError("count", f"{count} elements counted, a field holds {capacity}")
    return count


def remaining(data: bytes, at: int, size: int) -> int:
    """Returns the number of elements of `size` bytes that follow."""
    return (len(data) - at) // size


@lru_cache(maxsize=256)
def _array(letter: str, count: int) -> Block:
    return Block(letter * count)


def read_numbers(letter: str, data: bytes, at: int, count: int) -> tuple[Any, ...]:
    return _array(letter, count).read(data, at)


def write_numbers(name: str, letter: str, values: Sequence[Any]) -> bytes:
    return _array(letter, len(values)).write(f"{name}*{len(values)}", *values)


def read_vectors(
    kind: type[Any], letter: str, width: int, data: bytes, at: int, count: int
) -> tuple[Any, ...]:
    values = _array(letter, width * count).read(data, at)
    return tuple([kind._make(values[i : i + width]) for i in range(0, width * count, width)])


def write_vectors(name: str, letter: str, width: int, values: Sequence[Any]) -> bytes:
    return _each(name, values, lambda v: write_numbers("", letter, elements("", v, width)))


def read_structures(kind: type[S], data: bytes, at: int, count: int) -> tuple[tuple[S, ...], int]:
    structures = []
    for _ in range(count):
        value, at = kind._decoded(data, at)
        structures.append(value)
    return tuple(structures), at


def structure(name: str, value: Any, kind: type[_Structure]) -> bytes:
    """Encodes a structure; raises EncodeError if it is not of the right kind."""
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
    """Encodes a bitfield in bytes, least significant byte first."""
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
    """Returns `value` as a sequence; raises EncodeError if it does not have `count` elements."""
    if len(sized(name, value)) != count:
        raise EncodeError("count", f"{name} has {len(value)} elements, needs {count}")
    return sized(name, value)


def at_most(name: str, value: Any, capacity: int) -> Sequence[Any]:
    """Returns `value` as a sequence; raises EncodeError if a field cannot contain so many."""
    if len(sized(name, value)) > capacity:
        raise EncodeError("count", f"{name} has {len(value)} elements, a field holds {capacity}")
    return sized(name, value)


def count(name: str, value: Any, capacity: int) -> int:
    """Returns the number of elements; raises EncodeError if a field cannot contain that many."""
    return len(at_most(name, value, capacity))


def sized(name: str, value: Any) -> Sequence[Any]:
    """Returns a sequence unchanged, and an array as a list; raises EncodeError otherwise."""
    if value is None:
        raise EncodeError("missing", f"{name} is None")
    items = value if isinstance(value, Sequence) else _listed(value)
    if not isinstance(items, Sequence):
        raise EncodeError("count", f"{name} is {value!r}, needs a sequence")
    return items


def elements(name: str, value: Any, count: int) -> Sequence[Any]:
    """Returns the elements of a vector; raises EncodeError if there are not `count` of them."""
    if value is None:
        raise EncodeError("missing", f"{name} is None")
    numbers = _numbers(value)
    if numbers is None:
        raise EncodeError("count", f"{name} is {value!r}, needs {count} numbers")
    return exactly(name, numbers, count)


def vector(value: Any, *kinds: type[Any]) -> Any:
    """Converts `value` to the first kind of vector with the same number of elements.

    Anything else is returned unchanged; it is rejected when it is encoded.
    """
    if type(value) in kinds or (numbers := _numbers(value)) is None:
        return value
    for kind in kinds:
        if len(numbers) == len(kind._fields):
            return kind._make(numbers)
    return value


def vectors(value: Any, *kinds: type[Any]) -> Any:
    """Converts each item of `value` as `vector` does."""
    items = _listed(value)
    return tuple([vector(v, *kinds) for v in items]) if isinstance(items, Sequence) else value


def several(value: Any) -> Any:
    """Converts an array to a tuple, also for decoders. Anything else is returned unchanged."""
    if type(value) is tuple:
        return value
    items = value if isinstance(value, (bytes, bytearray)) else _listed(value)
    return tuple(items) if isinstance(items, Sequence) else value


def element(matrix: tuple[float, ...], at: Any, columns: int) -> Any:
    """Returns an element of a matrix by row and column, from 0, or by index as in any tuple."""
    if isinstance(at, tuple):
        rows = len(matrix) // columns
        try:
            row, column = at
            at = range(rows)[row] * columns + range(columns)[column]
        except (IndexError, TypeError, ValueError) as error:
            kind = IndexError if isinstance(error, IndexError) else TypeError
            needs = f"needs one of {rows} rows and one of {columns} columns, from 0"
            raise kind(f"a matrix {needs}, not {at}; for whole rows, use `rows`") from None
    return tuple.__getitem__(matrix, at)


def _numbers(value: Any) -> Sequence[Any] | None:
    """Returns the numbers in a vector, or in a matrix row by row; None for anything else."""
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
    """Returns a sequence unchanged, a library's array as a list; None for bytes and text."""
    if isinstance(value, (str, bytes, bytearray, memoryview, Mapping, Set)):
        return None
    if isinstance(value, Sequence) or not hasattr(value, "__len__"):
        return value
    return value.tolist() if hasattr(value, "tolist") else None


def text(name: str, value: Any) -> bytes:
    """Encodes characters, one byte each."""
    if not isinstance(value, str):
        raise EncodeError("range", f"{name} is {value!r}, needs a str")
    try:
        return value.encode("latin-1")
    except UnicodeEncodeError:
        raise EncodeError("range", f"{name}: characters must be one byte each") from None


def padded(name: str, value: Any, count: int) -> bytes:
    """Encodes a text of fixed length; a shorter one is padded with spaces, as devices do."""
    return text(name, exactly(name, value.ljust(count) if isinstance(value, str) else value, count))


def check_selected(name: str, value: Any, tag: object, kind: type[Any] | None) -> None:
    """Raises EncodeError if the value of a union is not the structure or the number that its tag
    selects."""
    fits = isinstance(value, kind) if kind else value is not None and not hasattr(value, "_write")
    if not fits:
        raise _mismatch(name, tag)


def check_unselected(name: str, value: Any, tag: object) -> None:
    """Raises EncodeError if a union has a value although its tag selects none."""
    if value is not None:
        raise _mismatch(name, tag)


def _mismatch(name: str, tag: object) -> EncodeError:
    return EncodeError("tag", f"{name} is not the member that {tag!r} selects")


def check_more(data: bytes, at: int, optional: bool) -> None:
    """Raises Truncated at the end of the data if the next parameters may be absent."""
    if optional and at == len(data):
        raise Truncated(1, 0)


def find_present(data: bytes, at: int, required: int, ends: Sequence[int]) -> tuple[int, int]:
    """Returns the number of parameters that are present, given where each ends, and where the last
    one ends. Raises Truncated if required ones are absent."""
    left = len(data) - at
    count = next((n for n, end in enumerate(ends) if end > left), len(ends)) - 1
    if count < required:
        raise Truncated(ends[count + 1] - ends[count], left - ends[count])
    return count, at + ends[count]


def count_present(value: object, required: int, *groups: tuple[int, str]) -> int:
    """Returns the number of parameters that are present, up to the first group with a None.

    A group is the number of its last parameter and its names; "?" marks a union. A required union
    may be None, which means that it is empty.
    """
    last, ended = 0, ""
    for number, text in groups:
        names = text.rstrip("?").split()
        empty = text.endswith("?") and number <= required
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
