"""Names of the parts of a model in the bindings: for indexes of symbols."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from mipgen import model as m


@dataclass(frozen=True, slots=True)
class Symbols:
    """The name of a field's type, or of a type, in a language, with its functions and constants."""

    thing: m.Type | m.Field
    name: str
    others: tuple[str, ...]


def types_and_fields(model: m.Model) -> Iterator[m.Type | m.Field]:
    """Yields types and fields, first those of the protocol, then set by set."""
    protocol = (model.protocol.function_selector, *model.types, model.protocol.acknowledge)
    for group in (protocol, *((*x.types, *x.fields) for x in model.families)):
        yield from sorted(group, key=lambda x: x.name)


def named_parts(t: m.Type) -> Iterable[m.EnumValue | m.Bits]:
    return t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ()
