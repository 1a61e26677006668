"""Facts about devices and their manuals, and the reasons to believe that a device has a field."""

from __future__ import annotations

from mipgen import model as m
from mipgen.lower.extent import computed_length

from .texts import Fact, Text, device_ref, fact, joined, prose, say, thing_ref, uncertain

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
    "unlisted": "Not in the manual, whose list of the set is complete",
    "hardware": "Requires hardware that the device lacks",
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
    facts += hardware_facts(d.hardware)
    if d.complete:
        sets = joined([(thing_ref(s),) for s in d.complete])
        facts.append(fact("complete", sets, "Sets known completely from the manual: {}."))
    manual = next((x for x in model.protocol.manuals if x.id == d.manual), None)
    document = (f"{manual.title}, {manual.document}",) if manual else ()
    facts.append(fact("manual", document, "Manual: {}." if manual else "No manual is known."))
    facts += [
        fact("incomplete", prose(text.rstrip("."), model), "This profile is incomplete: {}.") for text in d.incomplete
    ]
    return facts + uncertain(d, model)


def hardware_facts(has: m.Hardware) -> list[Fact]:
    """Returns the facts about the hardware of a device, as far as it is known."""
    facts = []
    if has.sensors is not None:
        facts.append(fact("sensors", (", ".join(s.replace("_", " ") for s in has.sensors) or "none",), "Sensors: {}."))
    for several in m.COUNTED:
        if (number := getattr(has, several)) is not None:
            facts.append(fact(several, (str(number or "none"),), f"GNSS {several}: {{}}."))
    return facts


def evidence(e: m.Evidence, model: m.Model) -> Text:
    """Words the evidence that a device supports a field, or does not: its kind, its source, and the section."""
    if e.needs:
        return (f"Requires {m.worded(e.needs)}, which the device lacks.",)
    titles = {x.id: x.title for x in model.protocol.manuals}
    devices = [(device_ref(d),) for device_id in e.of if (d := model.device(device_id)) is not None]
    of: Text = (", ", *joined(devices)) if devices else ()
    asked = [f"firmware {e.firmware}"] if e.firmware else []
    asked += [e.date] if e.date else []
    cited = [f"{titles.get(s.manual, s.manual)}: {s.section}" for s in e.sources]
    where = f" ({'; '.join(asked + cited)})" if asked or cited else ""
    note: Text = (" ", *prose(e.note, model)) if e.note else ()
    return (_KINDS[e.kind], *of, f"{where}.", *note)


def firmware(versions: str) -> str:
    """
    >>> firmware("> 1.0.07"), firmware(">= 1.0, < 1.1")
    ('firmware later than 1.0.07', 'firmware 1.0 or later and before 1.1')
    """
    forms = {">": "later than {}", ">=": "{} or later", "<": "before {}", "<=": "up to {}"}
    parts = (part.split() for part in versions.split(", "))
    return "firmware " + " and ".join(forms[sign].format(version) for sign, version in parts)


def why(e: m.Evidence, model: m.Model) -> str:
    """Words the evidence as plain text."""
    return say(evidence(e, model), lambda ref: ref.words)


def summary(d: m.Device) -> str:
    """Summarizes the knowledge about a device: "3dm-gq7: 69 certain, 27 likely, 74 assumed; there may be more"."""
    counts = [(len(d.certain), "certain")]
    counts += [(len(d.likely), "likely"), (len(d.assumed), "assumed"), (len(d.refuses), "not supported")]
    parts = ", ".join(f"{n} {what}" for n, what in counts if n) or "nothing is known"
    return f"{d.id}: {parts}{'; there may be more' if d.incomplete else ''}"


def length_facts(manual: m.Manual, model: m.Model) -> Text:
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
