"""How `reflection` describes the parameters of fields and structures."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Parameter:
    """One value on the wire. `name` is that of the specification."""

    name: str
    attribute: str
    kind: str  # scalar, constant, counter, bits, text, array, struct or switch
    scalar: str = ""  # u8 … s64, float, double, bool, char; bits: a bitfield in `size` bytes
    size: int = 0
    elements: tuple[str, ...] = ()  # of a vector
    length: int | str | None = None  # a number, the counter's name, or "rest"
    constant: int | None = None
    counts: str = ""  # attribute of the array that a counter counts
    type: Any = None  # enumeration, bitfield or structure
    tag: str = ""  # attribute that selects a union's member
    cases: dict[int, Parameter | None] = field(default_factory=dict)
    units: tuple[str, ...] = ()  # one for all elements, or one for each
    frame: str = ""
    valid: tuple[str, ...] = ()  # what says that it is valid: "flags.bit" or a bool; one, or each's
    minimum: float | None = None
    maximum: float | None = None
    above: float | None = None  # the value is greater, not equal
    below: float | None = None
    magnitude: tuple[float | None, float | None] = (None, None)  # least and most of a vector
    default: Any = (
        None  # factory default, or the value to send for a reserved one; names as numbers
    )
