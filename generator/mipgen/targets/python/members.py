"""Parameters as Python writes them: the members of objects, their types and defaults."""

from __future__ import annotations

import math
from dataclasses import dataclass

from mipgen import model as m
from mipgen.lower import calls

from .names import ANNOTATIONS, home, member, reference


@dataclass(frozen=True, slots=True)
class Member:
    """A parameter of a structure or a field."""

    of: m.Parameter
    record: m.Record

    @property
    def name(self) -> str:
        return member(self.of.name)

    @property
    def is_array(self) -> bool:
        """True for several elements in a tuple; a text or a vector is one value."""
        return self.of.kind == "array" and not self.of.vector

    @property
    def may_be_absent(self) -> bool:
        """True if it can be None because it was not sent; a union is None if its alternative is empty, too."""
        return self.of.name in self.record.present_with

    @property
    def annotation(self) -> str:
        """The type of its value when it is present."""
        element = self._element
        if not self.is_array:
            return element
        few = self._few_elements
        return f"tuple[{', '.join([element] * few)}]" if few else f"tuple[{element}, ...]"

    @property
    def hint(self) -> str:
        """The type of the attribute."""
        return self._optional(self.annotation)

    @property
    def required_argument(self) -> str:
        """The type of an argument that must be passed: a vector accepts any numbers, an array any sequence."""
        accepted = self._element if self.is_array else self.annotation
        if vectors := self.vectors:
            accepted += " | codec.Rows" if any(matrix_columns(v) for v in vectors) else " | codec.Numbers"
        return f"Sequence[{accepted}]" if self.is_array else accepted

    @property
    def argument(self) -> str:
        """The type of the argument."""
        return self._optional(self.required_argument)

    @property
    def default(self) -> str | None:
        """The value if the caller omits it; None if it must be passed."""
        if self.may_be_absent or self.of.element is None:
            return "None"
        return None if self.of.reserved is None else self.reserved

    @property
    def declaration(self) -> str:
        """The parameter of `__init__`."""
        return f"{self.name}: {self.argument}" + ("" if self.default is None else f" = {self.default}")

    @property
    def reserved(self) -> str:
        """The value that a reserved parameter has."""
        if self.of.length is None:
            return str(self.of.reserved)
        few = self._few_elements
        return repr((self.of.reserved,) * few) if few else f"({self.of.reserved},) * {self.of.length}"

    @property
    def keyword_only(self) -> bool:
        """True if it has a default and precedes a member without one, and is therefore passed only by name."""
        members = calls.members(self.record)
        later = members[members.index(self.of) + 1 :]
        return self.default is not None and any(Member(p, self.record).default is None for p in later)

    @property
    def stored(self) -> str:
        """The value that the object stores for the argument."""
        if vectors := self.vector_classes:
            return f"codec.{'vectors' if self.is_array else 'vector'}({self.name}, {', '.join(vectors)})"
        return f"codec.several({self.name})" if self.is_array else self.name

    @property
    def vectors(self) -> list[m.Vector]:
        """The vectors that it, or its elements, may be."""
        if self.of.element is None:
            return list(dict.fromkeys(v for p in self.of.alternatives for v in Member(p, self.record).vectors))
        return [self.of.element] if isinstance(self.of.element, m.Vector) else []

    @property
    def vector_classes(self) -> list[str]:
        """The classes of these vectors."""
        return [reference(v, home(self.record)) for v in self.vectors]

    @property
    def _few_elements(self) -> int:
        """The length of an array whose tuple type lists each element; 0 for any other type."""
        plain = self.is_array and not (self.of.leaf.named or self.of.leaf.struct)
        return self.of.capacity if plain and not self.of.open and self.of.capacity <= 4 else 0

    @property
    def _element(self) -> str:
        match self.of.element:
            case m.Scalar() as scalar:
                return "str" if scalar.kind == "char" and self.of.length is not None else ANNOTATIONS[scalar.kind]
            case None:
                kinds = [Member(p, self.record).annotation for p in self.of.alternatives]
                return " | ".join([*dict.fromkeys(kinds), "None"])
            case t:
                return reference(t, home(self.record))

    def _optional(self, annotation: str) -> str:
        return f"{annotation} | None" if self.may_be_absent and self.of.element is not None else annotation


def matrix_columns(v: m.Vector) -> int:
    """Returns the number of columns of a matrix, whose elements are named by row and column, m11, m12 …; else 0.

    >>> matrix_columns(m.Vector("matrix2f", m.SCALARS["float"], ("m11", "m12", "m21", "m22"), ""))
    2
    """
    count = math.isqrt(len(v.elements))
    places = [f"m{row}{column}" for row in range(1, count + 1) for column in range(1, count + 1)]
    return count if count > 1 and places == list(v.elements) else 0
