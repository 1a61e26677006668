"""Facts about parameters that differ on a device, or with the value of a sibling parameter."""

from __future__ import annotations

from collections.abc import Sequence

from mipgen import model as m

from .measures import measures, numeral, validity
from .texts import Fact, Ref, Text, device_refs, interleaved, joined, prose


def variants(p: m.Parameter, record: m.Record, model: m.Model) -> list[tuple[tuple[m.Variant, ...], Fact]]:
    """Returns the differences on devices, or with values of another parameter: one fact for all devices that share
    it."""
    groups: list[list[m.Variant]] = []
    for v in p.variants:
        same = next((g for g in groups if v.by_device and g[0].alike(v)), None)
        if same is None:
            groups.append([v])
        else:
            same.append(v)
    facts = []
    for group in groups:
        text = variant_text(group[0], p, record, model)
        sentence = (*_condition(group, record, model), ": ", *text, ".")
        facts.append((tuple(group), Fact("variant", text, sentence)))
    return facts


def variant_text(v: m.Variant, p: m.Parameter, record: m.Record, model: m.Model) -> Text:
    """Words a variant, which may be about a member of a structure."""
    within = p.element if v.member and isinstance(p.element, m.Struct) else None
    if within is not None:
        p = next(q for q in within.parameters if q.name == v.member)
    parts: list[Text] = []
    if v.unknown:
        parts.append(("the values are unknown",))
    if v.type is not None:
        parts.append(("values of ", Ref(v.type, v.type.name)))
    if v.only:
        named = v.type or p.element
        assert isinstance(named, (m.Enum, m.Bitfield))
        parts.append(("only ", *joined([(Ref(x, x.name, named),) for x in v.only])))
    if v.constant is not None:
        parts.append((f"always {numeral(p, v.constant)}",))
    for measure in measures(v, p, model):
        parts.append((f"{measure.topic} ", *measure.value))
    if v.valid is not None:
        parts.append(_validity(v.valid, v.key if v.by_device else None, p, record))
    if v.deprecated is not None:
        parts.append(("deprecated" if v.deprecated else "not deprecated",))
    text = interleaved(parts, "; ")
    if within is not None:
        text = (Ref(p, p.name, within), " has " if parts else ": ", *text)
    if v.description:
        text = (*text, *([". "] if parts else []), *prose(v.description.rstrip("."), model))
    if v.inferred:
        why = v.inferred.rstrip(".")
        text = (*text, " (inferred: ", *prose(why[:1].lower() + why[1:], model), ")")
    return text


def usual_text(v: m.Variant, p: m.Parameter, record: m.Record, model: m.Model) -> Text:
    """Words the general case of a parameter, as far as a variant differs from it."""
    if v.member:
        return ("as on its page",)
    parts: list[Text] = []
    if v.type is not None or v.unknown or v.only:
        if isinstance(p.element, (m.Enum, m.Bitfield)):
            parts.append(("values of ", Ref(p.element, p.element.name)))
        else:
            parts.append(("numbers of descriptor sets" if p.shown == "set" else "any number",))
    if v.constant is not None:
        parts.append(("any value",))
    general = {x.topic: x for x in measures(p, p, model)}
    for topic in (x.topic for x in measures(v, p, model)):
        parts.append((f"{topic} ", *general[topic].value) if topic in general else (f"{topic} unknown",))
    if v.valid is not None:
        parts.append(_validity(p.valid, None, p, record))
    if v.deprecated is not None:
        parts.append(("not deprecated" if v.deprecated else "deprecated",))
    if v.description:
        parts.append(prose(p.description.rstrip("."), model))
    return interleaved(parts, "; ")


def _validity(valid: tuple[str, ...], device: str | None, p: m.Parameter, record: m.Record) -> Text:
    """Words the flag that marks the value as valid, on one device or in general."""
    if not valid:
        return ("no flag marks it as valid",)
    vouching = validity(valid, p, record, device)
    many = len(set(valid)) > 1
    state = "" if many else " is set" if "." in valid[0] else " is true"
    return ("valid flags " if many else "valid if ", *vouching.value, *([state] if state else []))


def _condition(group: Sequence[m.Variant], record: m.Record, model: m.Model) -> Text:
    """Words the condition of variants: "On the 3DM-GX5-15", "If mode is fast"."""
    v = group[0]
    if v.by_device:
        devices = [d for x in group if (d := model.device(x.key)) is not None]  # a partial specification may lack them
        return ("On the ", *(device_refs(devices) or joined([(x.key,) for x in group])))
    p = next(q for q in record.parameters if q.name == v.by)
    assert isinstance(p.element, m.Enum)
    value = p.element.by_name(v.key)
    assert value is not None
    return ("If ", Ref(p, p.name, record), " is ", Ref(value, value.name, p.element))
