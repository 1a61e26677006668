"""What is said about devices, and about the manuals that describe them."""

from __future__ import annotations

from mipgen import model as m
from mipgen.lower.lengths import computed_length

from .remarks import uncertain
from .texts import Fact, Text, device_ref, fact, joined, prose


def device(d: m.Device, model: m.Model) -> list[Fact]:
    """The facts about a device besides its description, its fields, and what differs there."""
    facts: list[Fact] = []
    if d.also:
        facts.append(fact("also", joined([(name,) for name in d.also]), "Also called {}."))
    if d.generation is not None:
        facts.append(fact("generation", (str(d.generation),), "Generation {}."))
    if d.model_number is not None:
        facts.append(fact("model_number", (str(d.model_number),), "Model number {}."))
    other = model.device(d.like) if d.like else None
    if other is not None:
        facts.append(fact("like", (device_ref(other),), "Like the {}, except as stated here."))
    manual = next((x for x in model.protocol.manuals if x.id == d.manual), None)
    known = (f"{manual.title}, {manual.document}",) if manual else ()
    facts.append(fact("manual", known, "Manual: {}." if manual else "No manual is known."))
    facts += [
        fact("incomplete", prose(text.rstrip("."), model), "This profile is incomplete: {}.") for text in d.incomplete
    ]
    return facts + uncertain(d, model)


def lengths(manual: m.Manual, model: m.Model) -> Text:
    """How a manual counts field lengths, and for how many fields that makes a difference."""
    if manual.lengths == "none":
        return ("not given",)
    if manual.lengths == "wire":
        return ("count every byte",)
    printed = [f for f in model.fields for s in f.sources if s.manual == manual.id and s.length is not None]
    short = [f for f in printed if computed_length(f, "scalars") != computed_length(f, "wire") or _has_union(f)]
    return (f"count only numbers and arrays of numbers; {len(short)} leave out vectors, structures or unions",)


def _has_union(f: m.Field) -> bool:
    return any(p.cases for p in f.parameters)
