"""Names of the parts of a model in the bindings: for indexes of symbols, and for tools that write programs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
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


# --------------------------------------------------------------------------- words that programs need


def parameter_names(model: m.Model) -> list[str]:
    """Returns the names of all parameters, including those in unions."""
    every = (q for r in model.records for p in r.parameters for q in (p, *(c.parameter for c in p.cases)) if q)
    return sorted({q.name for q in every})


def constant_names(model: m.Model) -> list[str]:
    """Returns the names of all values and bits."""
    return sorted({x.name for t in (model.protocol.function_selector, *model.all_types) for x in named_parts(t)})


def tag_names(model: m.Model) -> list[str]:
    """Returns the names of the values that select an alternative of a union."""
    return sorted({c.tag.name for r in model.records for p in r.parameters for c in p.cases})


def named_parts(t: m.Type) -> Iterable[m.EnumValue | m.Bits]:
    return t.values if isinstance(t, m.Enum) else t.bits if isinstance(t, m.Bitfield) else ()


def unusual_names(
    names: Iterable[str], spelling: Callable[[str], str], usual: Callable[[str], str] = str
) -> dict[str, str]:
    """Returns the names whose spelling in a language differs from the usual one."""
    return {name: spelling(name) for name in names if spelling(name) != usual(name)}
