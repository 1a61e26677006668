"""Rows of the field and device tables, and the literals in them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from mipgen import model as m

from .names import constant, feature


def quoted(text: str) -> str:
    """Writes a string literal.

    >>> print(quoted('say "µ"'))
    "say \\"µ\\""
    """
    escaped = " ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def decimal(value: float | int) -> str:
    """Writes a floating-point literal.

    >>> decimal(250), decimal(0.5)
    ('250.0', '0.5')
    """
    return repr(float(value))


def option(value: object | None) -> str:
    return "None" if value is None else f"Some({value})"


@dataclass(frozen=True, slots=True)
class Group:
    """The fields of a family."""

    when: str  # the feature that they need
    sets: Sequence[int]  # in which any of them occurs
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
    """Describes the parameters that are members of types: all that do not follow from others."""
    return tuple(
        Described(
            p.name, p.elements, m.unit_symbols(p.units), p.frame,
            described(_inside(p)),
        )
        for p in parameters
        if not p.derived
    )  # fmt: skip


def _inside(p: m.Parameter) -> Iterable[m.Parameter]:
    return p.item.struct.parameters if p.item.struct else p.alternatives


def sets(numbers: Sequence[int], separator: str) -> str:
    """Writes the numbers of descriptor sets: as a range, or one by one.

    >>> sets(range(1, 128), " "), sets((0x81, 0x91), " | ")
    ('0x01..=0x7F', '0x81 | 0x91')
    """
    if isinstance(numbers, range):
        return f"0x{numbers[0]:02X}..=0x{numbers[-1]:02X}"
    return separator.join(f"0x{n:02X}" for n in numbers)


def _group(when: str, fields: tuple[m.Field, ...]) -> Group:
    everywhere = fields[0].everywhere
    return Group(when, everywhere or tuple(sorted({n for f in fields for n in f.sets})), fields)


class Tables:
    def __init__(self, model: m.Model) -> None:
        self.model = model

    def groups(self) -> list[Group]:
        """Returns all fields in the order in which the registry searches them: by family, the acknowledge last."""
        groups = [_group(f'feature = "{feature(x)}"', x.fields) for x in self.model.families if x.fields]
        return [*groups, _group("all()", (self.model.protocol.acknowledge,))]

    def linked(self, f: m.Field) -> list[str]:
        """Returns the responses of a command, or the commands of a response."""
        return [x.full_name for x in (self.model.responses(f) or self.model.commands(f))]

    def layouts(self, f: m.Field) -> int:
        """Returns the number of layouts of the descriptor."""
        return len(self.model.layouts(f))

    def sizes(self, f: m.Field) -> str:
        """Writes the sizes that the data of a layout may have; empty if it may have any."""
        sizes = self.model.sizes(f)
        if sizes == range(m.MAX_FIELD_DATA + 1):
            return ""
        return f"{sizes.start}..={sizes.stop - 1 if sizes.stop <= m.MAX_FIELD_DATA else 'usize::MAX'}"

    def ack_codes(self, d: m.Device) -> list[str]:
        names = {v.value: constant(v.name) for v in self.model.protocol.ack_code.values}
        return [f"AckCode::{names[code]}" for code in d.ack_codes]
