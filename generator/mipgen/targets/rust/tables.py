"""Rows of the tables of fields and devices, and the literals in them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from ... import model as m
from .names import constant, feature


def quoted(text: str) -> str:
    """A string literal.

    >>> print(quoted('say "µ"'))
    "say \\"µ\\""
    """
    escaped = " ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def decimal(value: float | int) -> str:
    """A floating-point literal.

    >>> decimal(250), decimal(0.5)
    ('250.0', '0.5')
    """
    return repr(float(value))


def option(value: object | None) -> str:
    return "None" if value is None else f"Some({value})"


def octets(op: m.ConstantOp) -> list[int]:
    """The bytes of a constant."""
    return list(op.value.to_bytes(op.size, "big", signed=op.value < 0))


@dataclass(frozen=True, slots=True)
class Group:
    """Fields that packets of the same sets may hold."""

    when: str  # the feature that they need
    sets: tuple[int, int]
    fields: tuple[m.Field, ...]


@dataclass(frozen=True, slots=True)
class Described:
    """A value as the registry describes it."""

    name: str
    elements: tuple[str, ...]
    units: tuple[str, ...]
    frame: str | None
    members: tuple[Described, ...]  # of a structure; the alternatives of a union


def described(parameters: Iterable[m.Parameter]) -> tuple[Described, ...]:
    """Those that types hold: whatever does not follow from others."""
    return tuple(
        Described(
            p.name, p.element.elements if isinstance(p.element, m.Vector) else (), p.units, p.frame,
            described(_inside(p)),
        )
        for p in parameters
        if not p.derived
    )  # fmt: skip


def _inside(p: m.Parameter) -> Iterable[m.Parameter]:
    if isinstance(p.element, m.Struct):
        return p.element.parameters
    return (c.parameter for c in p.cases if c.parameter)


class Tables:
    def __init__(self, model: m.Model) -> None:
        self.model = model

    def groups(self) -> list[Group]:
        """All fields as the registry looks for them: by set, those that many sets may hold last."""
        ack = self.model.protocol.acknowledge
        found = []
        for s in sorted(self.model.sets, key=lambda s: s.number):
            if s.fields:
                found.append(Group(f'feature = "{feature(s)}"', self.set_range(s.fields[0]), s.fields))
        return [*found, Group("all()", self.set_range(ack), (ack,))]

    def set_range(self, f: m.Field) -> tuple[int, int]:
        """The sets whose packets can hold the field."""
        if f is self.model.protocol.acknowledge:
            return 0x01, 0x7F
        return (0x80, 0xFF) if f.set == 0xFF else (f.set, f.set)

    def set_pattern(self, f: m.Field) -> str:
        """The sets of a field as a pattern, if it has others besides its own."""
        first, last = self.set_range(f)
        if first != last:
            return f"0x{first:02X}..=0x{last:02X}"
        return ""

    def linked(self, f: m.Field) -> list[str]:
        """The responses of a command, or the commands of a response."""
        return [x.full_name for x in (self.model.responses(f) or self.model.commands(f))]

    def layouts(self, f: m.Field) -> int:
        """How many layouts the descriptor has."""
        return len(self.model.candidates(f.set, f.descriptor))

    def sizes(self, f: m.Field) -> str:
        """The sizes of data that a layout may have; empty if it may have any."""
        found = self.model.sizes(f)
        if found == range(m.MAX_FIELD_DATA + 1):
            return ""
        return f"{found.start}..={found.stop - 1 if found.stop <= m.MAX_FIELD_DATA else 'usize::MAX'}"

    def ack_codes(self, d: m.Device) -> list[str]:
        names = {v.value: constant(v.name) for v in self.model.protocol.ack_code.values}
        return [f"AckCode::{names[code]}" for code in d.ack_codes]
