"""Operations: a layout as the ordered steps of one codec.

A template has one branch per `Operation.kind` and computes nothing. Whoever wants to know just one thing of an
operation asks for a property of all of them, and needs no branches.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, cast

from .parameters import Case
from .types import Bitfield, Enum, Scalar, Struct, Vector


class _Operation:
    """What every operation can be asked."""

    __slots__ = ()

    @property
    def named(self) -> Enum | Bitfield | None:
        """The type that names its values or bits."""
        return None

    @property
    def inside(self) -> tuple[Operation, ...]:
        """The operations that it consists of."""
        return ()

    @property
    def leaf(self) -> Operation:
        """Of an array the operation of one item, also if these are vectors; of any other operation itself."""
        return cast("Operation", self)

    @property
    def several(self) -> bool:
        """Is it an array or a text?"""
        return False

    @property
    def open(self) -> bool:
        """Is it an array or a text whose length varies?"""
        return False


@dataclass(frozen=True, slots=True)
class ScalarOp(_Operation):
    """One number. `type` names its values or bits, if it has any."""

    member: str
    scalar: Scalar
    type: Enum | Bitfield | None
    size: int
    kind: Literal["scalar"] = "scalar"

    @property
    def named(self) -> Enum | Bitfield | None:
        return self.type


@dataclass(frozen=True, slots=True)
class ConstantOp(_Operation):
    """A constant: written by encode, checked by decode, not stored."""

    member: str
    scalar: Scalar
    value: int
    size: int
    kind: Literal["constant"] = "constant"


@dataclass(frozen=True, slots=True)
class CounterOp(_Operation):
    """The number of elements of `array`, which comes later in the same record."""

    member: str
    scalar: Scalar
    array: str
    size: int
    kind: Literal["counter"] = "counter"


@dataclass(frozen=True, slots=True)
class BitsOp(_Operation):
    """A bitfield in `size` bytes, least significant byte first."""

    member: str
    type: Bitfield
    size: int
    kind: Literal["bits"] = "bits"

    @property
    def named(self) -> Enum | Bitfield | None:
        return self.type


@dataclass(frozen=True, slots=True)
class TextOp(_Operation):
    """Characters, one byte each: `count` of them, as many as `counter` says, or the rest."""

    member: str
    count: int | None
    counter: str | None
    capacity: int
    kind: Literal["text"] = "text"

    @property
    def several(self) -> bool:
        return True

    @property
    def open(self) -> bool:
        return self.count is None


@dataclass(frozen=True, slots=True)
class ArrayOp(_Operation):
    """Items of one kind: `count` of them, as many as `counter` says, or as many as still fit.

    `item` is a ScalarOp, a StructOp or an ArrayOp (of vectors) whose member is "item";
    `vector` names the elements when the array is a vector, matrix or quaternion.
    """

    member: str
    item: ScalarOp | StructOp | ArrayOp
    count: int | None
    counter: str | None
    capacity: int
    vector: Vector | None = None
    kind: Literal["array"] = "array"

    @property
    def inside(self) -> tuple[Operation, ...]:
        return (self.item,)

    @property
    def leaf(self) -> Operation:
        return self.item.leaf

    @property
    def several(self) -> bool:
        return True

    @property
    def open(self) -> bool:
        return self.count is None


@dataclass(frozen=True, slots=True)
class StructOp(_Operation):
    member: str
    struct: Struct
    kind: Literal["struct"] = "struct"

    @property
    def inside(self) -> tuple[Operation, ...]:
        return self.struct.operations


@dataclass(frozen=True, slots=True)
class SwitchOp(_Operation):
    """The one alternative that the enumeration in `tag` selects; nothing for an unknown tag.

    Always the last operation of its record, so that nothing after an unknown tag is lost.
    """

    member: str
    tag: str
    tag_type: Enum
    cases: tuple[Case, ...]
    kind: Literal["switch"] = "switch"

    @property
    def inside(self) -> tuple[Operation, ...]:
        return tuple(c.operation for c in self.cases if c.operation)


@dataclass(frozen=True, slots=True)
class GroupOp(_Operation):
    """Parameters that are present or absent together: one, or a counter up to its array.

    The parameters are numbers `first` to `last` (from 1, the function selector not counted).
    The group is required when `last` <= the number that the selected function requires;
    otherwise it is read only if it is wholly there.
    """

    first: int
    last: int
    body: tuple[ValueOp, ...]
    kind: Literal["group"] = "group"

    @property
    def inside(self) -> tuple[Operation, ...]:
        return self.body


#: What reads and writes one parameter: everything but a group, which only fields have.
ValueOp = ScalarOp | ConstantOp | CounterOp | BitsOp | TextOp | ArrayOp | StructOp | SwitchOp
Operation = ValueOp | GroupOp
