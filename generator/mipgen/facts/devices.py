"""Facts about devices and their manuals, and the reasons to believe that a device has a field."""

from __future__ import annotations

from mipgen import model as m
from mipgen.lower.lengths import computed_length

from .remarks import uncertain
from .texts import Fact, Text, device_ref, fact, joined, prose, say

#: Kind of evidence -> its statement; if it is about other devices, their names follow.
_KINDS = {
    "documented": "Documented",
    "listed": "Listed by the device",
    "transcribed": "Transcribed from the manual by others",
    "example": "Used by the vendor's example for this model",
    "software": "Used by programs for this model",
    "family": "Supported by devices of the same generation",
    "sister": "Supported by nearly identical devices",
    "refused": "Rejected by the device",
}


def device(d: m.Device, model: m.Model) -> list[Fact]:
    """Returns the facts about a device besides its description, its fields, and its differences."""
    facts: list[Fact] = []
    if d.also:
        facts.append(fact("also", joined([(name,) for name in d.also]), "Also called {}."))
    if d.generation is not None:
        facts.append(fact("generation", (str(d.generation),), "Generation {}."))
    if d.model_number is not None:
        facts.append(fact("model_number", (str(d.model_number),), "Model number {}."))
    other = model.device(d.like) if d.like else None
    if other is not None:
        facts.append(fact("like", (device_ref(other),), "Same as the {}, except as stated here."))
    manual = next((x for x in model.protocol.manuals if x.id == d.manual), None)
    known = (f"{manual.title}, {manual.document}",) if manual else ()
    facts.append(fact("manual", known, "Manual: {}." if manual else "No manual is known."))
    facts += [
        fact("incomplete", prose(text.rstrip("."), model), "This profile is incomplete: {}.") for text in d.incomplete
    ]
    return facts + uncertain(d, model)


def evidence(e: m.Evidence, model: m.Model) -> Text:
    """Words the evidence that a device supports a field, or does not: its kind, its source, and the section."""
    known = {x.id: x.title for x in model.protocol.manuals}
    devices = [(device_ref(d),) for id in e.of if (d := model.device(id)) is not None]
    of: Text = (", ", *joined(devices)) if devices else ()
    asked = [f"firmware {e.firmware}"] if e.firmware else []
    asked += [e.date] if e.date else []
    cited = [f"{known.get(s.manual, s.manual)}: {s.section}" for s in e.sources]
    where = f" ({'; '.join(asked + cited)})" if asked or cited else ""
    note: Text = (" ", *prose(e.note, model)) if e.note else ()
    return (_KINDS[e.kind], *of, f"{where}.", *note)


def why(e: m.Evidence, model: m.Model) -> str:
    """Words the evidence as plain text."""
    return say(evidence(e, model), lambda ref: ref.words)


def known(d: m.Device) -> str:
    """Summarizes the knowledge about a device on one line: "3dm-gq7: 69 certain, 101 probable; there may be more"."""
    counts = [(len(d.certain), "certain"), (len(d.probable), "probable"), (len(d.refuses), "refused")]
    said = ", ".join(f"{n} {what}" for n, what in counts if n) or "nothing is known"
    return f"{d.id}: {said}{'; there may be more' if d.incomplete else ''}"


def lengths(manual: m.Manual, model: m.Model) -> Text:
    """States how a manual counts field lengths, and for how many fields that makes a difference."""
    if manual.lengths == "none":
        return ("not given",)
    if manual.lengths == "wire":
        return ("count every byte",)
    printed = [f for f in model.fields for s in f.sources if s.manual == manual.id and s.length is not None]
    short = [f for f in printed if computed_length(f, "scalars") != computed_length(f, "wire") or _has_union(f)]
    return (f"count only numbers and arrays of numbers; {len(short)} omit vectors, structures or unions",)


def _has_union(f: m.Field) -> bool:
    return any(p.cases for p in f.parameters)
