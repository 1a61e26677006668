"""Evidence from the manuals: example packets, and mistakes."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from mipgen.read.problems import Position

from .devices import Device


@dataclass(frozen=True, slots=True)
class ExampleField:
    """A field in an example packet; values have the form of the conformance drivers."""

    field: str | None  # full name; None for an undefined descriptor
    descriptor: int
    data: bytes
    values: dict[str, object] | None
    trailing: int
    stated: dict[str, object] | None  # values that the manual states


@dataclass(frozen=True, slots=True)
class Example:
    id: str
    manual: str
    section: str
    title: str
    role: Literal["command", "reply", "data", "field"]
    string: str | None  # the manual's copy-and-paste string, with its misprints
    table: tuple[int | None, ...] | None  # as in the manual's table; None for an unspecified byte
    packet: bytes  # the correct bytes
    fields: tuple[ExampleField, ...]
    note: str
    device: Device | None = None  # that sends or receives it; None if the manual is for several and none is named
    synthetic: bool = False  # the manual states only the values, not the bytes
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
    severity: Literal["wire", "meaning"]
    printed: str
    right: str
    reason: str
    claims: tuple[Claim, ...]
    named: tuple[str, ...] = ()  # what the texts name in backticks: fields, and other words
    position: Position | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Manual:
    id: str
    title: str
    document: str
    lengths: Literal["wire", "scalars", "none"]  # how it counts field lengths
    sections: tuple[str, ...] = ()  # the headings that may be cited; empty: any
    #: sdk: source code of the vendor, not a text for readers; software: programs that use devices.
    kind: Literal["manual", "sdk", "software"] = "manual"
