"""Facts that documentation states about the parts of a model, composed once for all targets.

A fact has a topic, a value ("m/s") and a sentence ("Unit: m/s."). Both are texts: words and references. This module is
the interface for targets; the module named after a part composes its facts.

The tests of every target look for every fact.
"""

from __future__ import annotations

from mipgen import model as m

from . import fields, parameters
from .devices import device, evidence, firmware, length_facts, summary, why
from .fields import changed, condition, conditions
from .measures import default_text, limits_text
from .parameters import bits, bits_place, case, type_facts, value
from .texts import (
    Fact,
    Ref,
    Text,
    Thing,
    fact,
    joined,
    measured,
    number,
    prose,
    quotation,
    say,
    sources,
    topics,
    uncertain,
)
from .variants import usual_text, variant_text, variants


class _Composed:
    """The facts of one model, each composed when it is first needed."""

    def __init__(self, model: m.Model) -> None:
        self.model = model
        self.alive: list[object] = []  # keeps the described objects, so that no other gets the same identity
        self.fields: dict[int, list[Fact]] = {}
        self.parameters: dict[tuple[int, int], list[Fact]] = {}

    def field(self, f: m.Field) -> list[Fact]:
        if id(f) not in self.fields:
            self.alive.append(f)
            self.fields[id(f)] = list(fields.field_facts(f, self.model))
        return list(self.fields[id(f)])

    def parameter(self, p: m.Parameter, record: m.Record) -> list[Fact]:
        key = id(p), id(record)
        if key not in self.parameters:
            self.alive += (p, record)
            self.parameters[key] = parameters.parameter_facts(p, record, self.model)
        return list(self.parameters[key])


def field(f: m.Field, model: m.Model) -> list[Fact]:
    """Returns the facts about a field besides its description."""
    return model.derived(_Composed).field(f)


#: Topics that need more lines than all others: only the reference, and the run-time metadata of bindings, contain them.
_LONG = ("likely", "assumed", "refused", "affected", "flags")


def in_code(f: m.Field, model: m.Model) -> list[Fact]:
    """Returns the facts for the comment of a field, besides its description."""
    unsure = not model.devices_of(f) and any(model.devices_of(f, answer) for answer in m.SUPPORTED)
    doubts = [fact("unsure", (), "No device is known for certain to support it.")] if unsure else []
    return doubts + [x for x in field(f, model) if x.topic not in _LONG]


def caveats(thing: m.Field | m.Type, model: m.Model) -> list[Fact]:
    """Returns the facts that every form contains: without them, a description seems certain and complete."""
    if not isinstance(thing, m.Field):
        return type_facts(thing, model)
    return topics(in_code(thing, model), "deprecated", "unsure", "note", "uncertain")


def parameter(p: m.Parameter, record: m.Record, model: m.Model) -> list[Fact]:
    """Returns the facts about a parameter, or the parameter of a union's case, besides its description."""
    return model.derived(_Composed).parameter(p, record)
