"""Evidence in the manuals: example packets, and the mistakes found in them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from mipgen.read.position import Position

from .details import Detail, Prose
from .devices import Device


@dataclass(frozen=True, slots=True)
class ExampleField:
    """A field inside an example packet; values in the form that the conformance drivers use."""

    field: str | None  # full name, None for a descriptor that the specification does not know
    descriptor: int
    data: Detail[bytes]
    values: Detail[dict[str, object] | None]
    trailing: int
    stated: Detail[dict[str, object] | None]  # values that the manual states


@dataclass(frozen=True, slots=True)
class Example:
    id: str
    manual: str
    section: Prose
    title: Prose
    role: Literal["command", "reply", "data", "field"]
    string: Detail[str | None]  # the copy-and-paste string of the manual, with its misprints
    table: Detail[tuple[int | None, ...] | None]  # as in a table of the manual; None for a byte that is left open
    packet: Detail[bytes]  # always the right bytes
    fields: tuple[ExampleField, ...]
    note: Prose
    device: Device | None = None  # that sends or receives it; None if its manual is for several, and it names none
    synthetic: bool = False  # given by its parameters only, not as bytes
    position: Position | None = field(default=None, compare=False)

    @property
    def set(self) -> int:
        return self.packet[2]


@dataclass(frozen=True, slots=True)
class Claim:
    """A mistake in a manual that `mipgen` can verify."""

    kind: Literal["length", "example", "reference"]
    subject: str
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Erratum:
    id: str
    manual: str
    section: str
    severity: Literal["wire", "meaning", "editorial"]
    printed: Prose
    right: Prose
    reason: Prose
    claims: tuple[Claim, ...]
    named: tuple[str, ...] = ()  # what the texts name in backticks: fields, and other words
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Manual:
    id: str
    title: Prose
    document: Prose
    lengths: Literal["wire", "scalars", "none"]  # how it counts field lengths
    sections: tuple[str, ...] = ()  # its headings that may be cited; none: any
    #: sdk: source code of the vendor, not a text for readers; software: programs that use devices.
    kind: Literal["manual", "sdk", "software"] = "manual"
