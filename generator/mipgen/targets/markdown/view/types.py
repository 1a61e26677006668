"""Types: the kind of each, and its values or bits."""

from __future__ import annotations

from mipgen import model as m
from mipgen.facts import describe

from ..index import User
from ..offsets import length
from ..text import code, table
from .base import View
from .parameters import Parameters, Values, bit_table, value_table, values_of


class Type(View[m.Type]):
    @property
    def nature(self) -> str:
        return nature(self.of)

    @property
    def uncertain(self) -> list[str]:
        return self.page.sentences(describe.uncertain(self.of, self.model))

    @property
    def parameters(self) -> Parameters | None:
        """The parameters of a structure."""
        return Parameters(self.page, self.of) if isinstance(self.of, m.Struct) else None

    @property
    def values(self) -> list[Values]:
        """The values and bits of the parameters of a structure."""
        return values_of(self.page, [self.of]) if isinstance(self.of, m.Struct) else []

    @property
    def table(self) -> str:
        """The values, bits or elements of another type."""
        match self.of:
            case m.Enum():
                return value_table(self.page, self.of)
            case m.Bitfield():
                return bit_table(self.page, self.of)
            case m.Vector():
                size = self.of.scalar.size
                rows = [[str(i * size), code(name)] for i, name in enumerate(self.of.elements)]
                return table(rows, ["Offset", "Element"])
        return ""

    @property
    def users(self) -> list[User]:
        """The fields and types that use the type; a vector has too many."""
        return [] if isinstance(self.of, m.Vector) else self.page.index.users(self.of)


def nature(t: m.Type) -> str:
    """Describes the kind of a type, and its length."""
    match t:
        case m.Enum():
            return f"Enumeration, {code(t.scalar.name)}"
        case m.Bitfield():
            return f"Bitfield, {code(t.scalar.name) if t.scalar else f'{t.size} bytes, the least significant first'}"
        case m.Vector():
            return f"{len(t.elements)} × {code(t.scalar.name)}, {len(t.elements) * t.scalar.size} bytes"
        case m.Struct():
            return f"Structure, {length(t.parameters, 0)} bytes"
