"""Facts that documentation states about the parts of a model, composed once for all targets.

A fact has a topic, a value ("m/s") and a sentence ("Unit: m/s."). Both are texts: words and references. This module is
what targets ask; what is said of each part is in the module of that name.
"""

from __future__ import annotations

from dataclasses import dataclass
from dataclasses import field as attribute
from typing import Any

from mipgen import model as m

from . import fields, parameters
from .devices import device, lengths
from .fields import condition, conditions
from .measures import default, limits
from .parameters import case
from .parts import bits, bits_place, type, value
from .remarks import sources, uncertain
from .texts import Fact, Ref, Text, Thing, joined, measured, number, prose, quotation, say, topics
from .variants import difference, usual, variants

__all__ = [
    "Fact",
    "Ref",
    "Text",
    "Thing",
    "bits",
    "bits_place",
    "case",
    "condition",
    "conditions",
    "default",
    "device",
    "difference",
    "field",
    "joined",
    "lengths",
    "limits",
    "measured",
    "number",
    "parameter",
    "prose",
    "quotation",
    "say",
    "sources",
    "topics",
    "type",
    "uncertain",
    "usual",
    "value",
    "variants",
]


@dataclass
class _Composed:
    """The facts of one model, each composed when it is first needed."""

    model: m.Model
    known: dict[tuple[int, ...], tuple[Any, list[Fact]]] = attribute(default_factory=dict)

    def field(self, f: m.Field) -> list[Fact]:
        if (id(f),) not in self.known:
            self.known[(id(f),)] = f, list(fields.facts(f, self.model))  # kept, so that nothing else has its identity
        return list(self.known[(id(f),)][1])

    def parameter(self, p: m.Parameter, record: m.Record) -> list[Fact]:
        key = id(p), id(record)
        if key not in self.known:
            self.known[key] = (p, record), parameters.facts(p, record, self.model)
        return list(self.known[key][1])


def field(f: m.Field, model: m.Model) -> list[Fact]:
    """The facts about a field besides its description."""
    return model.derived(_Composed).field(f)


def parameter(p: m.Parameter, record: m.Record, model: m.Model) -> list[Fact]:
    """The facts about a parameter, or the parameter of a union's case, besides its description."""
    return model.derived(_Composed).parameter(p, record)
