"""The numbers of which parameters consist."""

from __future__ import annotations

from typing import NamedTuple


class Scalar(NamedTuple):
    """A number on the wire, always big-endian."""

    size: int  # in bytes
    kind: str  # "unsigned", "signed", "float", "bool" or "char"
    letter: str  # in the formats of `struct`


#: The `scalar` of a parameter -> what it is.
SCALARS = {
    "u8": Scalar(1, "unsigned", "B"),
    "u16": Scalar(2, "unsigned", "H"),
    "u32": Scalar(4, "unsigned", "I"),
    "u64": Scalar(8, "unsigned", "Q"),
    "s8": Scalar(1, "signed", "b"),
    "s16": Scalar(2, "signed", "h"),
    "s32": Scalar(4, "signed", "i"),
    "s64": Scalar(8, "signed", "q"),
    "float": Scalar(4, "float", "f"),
    "double": Scalar(8, "float", "d"),
    "bool": Scalar(1, "bool", "B"),
    "char": Scalar(1, "char", "B"),
}
