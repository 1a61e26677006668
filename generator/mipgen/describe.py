"""Facts that documentation states about fields, parameters and types, composed once for all targets.

A fact has a topic, a value ("m/s") and a sentence ("Unit: m/s."). Both are texts: words and
references. A target only decides what words and references look like in its language; see `say`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from . import descriptors
from . import model as m
from .checks import computed_length
from .references import DESCRIPTOR

Record = m.Field | m.Struct
Thing = (
    m.Field
    | m.Set
    | m.Enum
    | m.Bitfield
    | m.Struct
    | m.EnumValue
    | m.Bits
    | m.Parameter
    | m.Function
    | m.Device
    | m.Manual
    | m.Word
)


@dataclass(frozen=True, slots=True)
class Ref:
    """A reference to a part of the model."""

    thing: Thing
    words: str  # its name in the specification
    within: Record | m.Enum | m.Bitfield | None = None  # the record of a parameter; the type of a value or a bit


#: Words and references, in order.
Text = tuple["str | Ref", ...]


@dataclass(frozen=True, slots=True)
class Fact:
    """One fact about a field, a parameter, a value or a bit."""

    topic: str
    value: Text
    sentence: Text


def say(text: Iterable[str | Ref], ref: Callable[[Ref], str], words: Callable[[str], str] = str) -> str:
    """A text in a language.

    >>> say(("Default: ", Ref(m.EnumValue("off", 0, ""), "off"), "."), lambda r: f"`{r.words}`")
    'Default: `off`.'
    """
    return "".join(words(part) if isinstance(part, str) else ref(part) for part in text)


def topics(facts: Iterable[Fact], *wanted: str) -> list[Fact]:
    """The facts of some topics, in their order."""
    return [f for f in facts if f.topic in wanted]


#: What was composed before, and of what, by the identities of these: all targets ask for the same.
_known: dict[tuple[int, ...], tuple[tuple[Any, ...], list[Fact]]] = {}


def _once(compose: Callable[..., list[Fact]], *of: Any) -> list[Fact]:
    """The facts about a part of a model, the last of `of`; those about the parts of one model are kept."""
    key = tuple(map(id, of))
    if key not in _known:
        if _known and next(iter(_known.values()))[0][-1] is not of[-1]:
            _known.clear()
        _known[key] = (of, compose(*of))  # as long as it is here, nothing else has its identity
    return list(_known[key][1])


# --------------------------------------------------------------------------- fields


def field(f: m.Field, model: m.Model) -> list[Fact]:
    """The facts about a field besides its description."""
    return _once(_of_field, f, model)


def _of_field(f: m.Field, model: m.Model) -> list[Fact]:
    found: list[Fact] = []
    if f.deprecated:
        found.append(_fact("deprecated", prose(f.deprecated.rstrip("."), model), "Deprecated: {}."))
    if f.advanced:
        found.append(_fact("advanced", (), "For advanced use."))
    if f.definition:
        found.append(_fact("definition", (_field(model.original(f)),), "Has the layout of {}."))
    if f.also:
        found.append(_fact("also", joined([(f"`{name}`",) for name in f.also]), "Also called {}."))
    if f.functions:
        found.append(_fact("functions", _functions(f.functions), "Functions: {}."))
    if f.responses:
        answers = joined([(_field(r),) for r in model.responses(f)], "or")
        found.append(_fact("responses", answers, "Answered by {}."))
    if f.role == m.RESPONSE and model.commands(f):
        found.append(_fact("commands", joined([(_field(c),) for c in model.commands(f)]), "Answers {}."))
    others = [g for g in model.layouts(f) if g is not f and g.signature == f.signature]
    if others:
        found.append(
            _fact("layout", joined([(_field(g),) for g in others]), "Distinguished from {} by the size of its data.")
        )
    if f.when:
        command = next(c for c in model.commands(f) if c.name == f.command)
        found.append(_fact("when", conditions(f.when, command), "Sent if {}."))
    if f.silent_when:
        found.append(_fact("silent", conditions(f.silent_when, f), "Not acknowledged if {}."))
    found += [_fact("silent", _setting(c, model), "Not acknowledged if {}.") for c in f.silenced_by]
    if f.sent_by == "device":
        found.append(_fact("sent_by", (), "Sent by the device; the host answers."))
    if f.timeout:
        found.append(_fact("timeout", (f"{number(f.timeout)} s",), "The device may take {} to answer."))
    if f.max_rate:
        found.append(_fact("max_rate", (f"{number(f.max_rate)} Hz",), "Maximum rate: {}."))
    devices = model.devices_of(f)
    if devices:
        found.append(_fact("devices", joined([(_device(d),) for d in devices]), "Supported by {}."))
    perhaps = model.devices_of(f, certain=False)
    if perhaps:
        found.append(_fact("perhaps", joined([(_device(d),) for d in perhaps]), "May be supported by {}."))
    if model.devices and f.role != m.RESPONSE and not devices and not perhaps:
        found.append(_fact("devices", (), "Not listed in any device profile."))
    found += [_deprecation(d, s.deprecated, model) for d, s in model.supports(f) if s.deprecated]
    found += [_support(d, s) for d, s in model.supports(f) if s.differs]
    found += _evidence(f, model)
    return [*found, *_remarks(f, model)]


def _evidence(f: m.Field, model: m.Model) -> Iterator[Fact]:
    """Where no manual describes it: what else knows it."""
    names = {s.manual for s in f.sources}
    cited = [x for x in model.protocol.manuals if x.id in names]
    if cited and all(x.kind == "sdk" for x in cited):
        yield _fact("evidence", joined([(Ref(x, x.title),) for x in cited]), "Known only from the {}.")


def _remarks(of: m.Field | m.Parameter, model: m.Model) -> Iterator[Fact]:
    """Facts in the author's words: notes, and what is uncertain."""
    yield from (_fact("note", prose(note, model), "{}") for note in of.notes)
    yield from uncertain(of, model)


Doubtful = m.Field | m.Set | m.Parameter | m.Type | m.EnumValue | m.Bits | m.Device


def uncertain(of: Doubtful, model: m.Model) -> list[Fact]:
    """What is not sure, each with what is known and what is inferred."""
    return [_fact("uncertain", prose(text.rstrip("."), model), "Uncertain: {}.") for text in of.uncertain]


def _support(d: m.Device, s: m.Support) -> Fact:
    functions = _functions(s.functions)
    return Fact("support", functions, ("On the ", _device(d), ": ", *functions, " only."))


def _deprecation(d: m.Device, instead: str, model: m.Model) -> Fact:
    text = prose(instead.rstrip("."), model)
    return Fact("deprecation", text, ("Deprecated on the ", _device(d), ": ", *text, "."))


def conditions(found: Sequence[m.Condition], command: m.Field) -> Text:
    """Parameters of a command that have certain values."""
    return joined([condition(c, command) for c in found])


def condition(c: m.Condition, command: m.Field) -> Text:
    p = next(p for p in command.parameters if p.name == c.parameter)
    known = p.element.by_name(c.label) if isinstance(p.element, m.Enum) else None
    value: str | Ref = Ref(known, known.name, p.element) if known and isinstance(p.element, m.Enum) else c.label
    return (Ref(p, p.name, command), " is ", value)


def _setting(c: m.Condition, model: m.Model) -> Text:
    """The setting of another command, which a part of a specification may lack."""
    command = model.field(c.command or "")
    if command is None:
        return (f"{c.parameter} of {c.command} is {c.label}",)
    parameter, *rest = condition(c, command)
    return (parameter, " of ", _field(command), *rest)


# --------------------------------------------------------------------------- parameters


def parameter(p: m.Parameter, record: Record, model: m.Model) -> list[Fact]:
    """The facts about a parameter, or the parameter of a union's case, besides its description."""
    return _once(_of_parameter, p, record, model)


def _of_parameter(p: m.Parameter, record: Record, model: m.Model) -> list[Fact]:
    beside = {q.name: q for q in record.parameters}
    found: list[Fact] = []
    if p.deprecated:
        found.append(_fact("deprecated", (), "Deprecated."))
    if p.constant is not None:
        found.append(_fact("constant", (_number(p, p.constant),), "Always {}."))
    if p.reserved is not None:
        sent = not isinstance(record, m.Field) or record.role == m.COMMAND
        value = (str(p.reserved),) if sent else ()
        found.append(_fact("reserved", value, "Reserved: send {}." if sent else "Reserved."))
    if p.counts:
        found.append(_fact("counts", (Ref(beside[p.counts], p.counts, record),), "The number of elements of {}."))
    if p.tag:
        found.append(_fact("tag", (Ref(beside[p.tag], p.tag, record),), "Selected by {}."))
    if p.fields_of:
        found.append(_fact("fields_of", (_owner(p, beside, record, model),), "Refers to fields of {}."))
    found += _measures(p, p, model)
    if p.valid:
        found.append(_valid(p.valid, p, record))
    found += _presence(p, record)
    found += [fact for _, fact in variants(p, record, model)]
    return [*found, *_remarks(p, model)]


def _owner(p: m.Parameter, beside: dict[str, m.Parameter], record: Record, model: m.Model) -> str | Ref:
    """The set whose field descriptors a parameter holds, which a part of a specification may lack."""
    if p.fields_of in beside:
        return Ref(beside[p.fields_of], p.fields_of, record)
    found = next((s for s in model.sets if s.name == p.fields_of), None)
    return Ref(found, found.title) if found else p.fields_of


def _measures(of: m.Parameter | m.Variant, p: m.Parameter, model: m.Model) -> Iterator[Fact]:
    """Elements, unit, frame, range and default: of a parameter, or of a variant of it."""
    own = p.element.elements if isinstance(p.element, m.Vector) else ()
    elements = of.elements if isinstance(of, m.Variant) else own
    if elements:
        yield _fact("elements", (", ".join(elements),), "Elements: {}.")
    if of.units:
        yield _fact("unit", (", ".join(of.units),), "Unit: {}." if len(of.units) == 1 else "Units: {}.")
    if of.frame:
        word = next(w for w in model.protocol.frames if w.symbol == of.frame)
        yield _fact("frame", (Ref(word, word.symbol),), "Frame: {}.")
    above, below = (of.above, of.below) if isinstance(of, m.Parameter) else (None, None)
    bounds = limits(of.minimum, of.maximum, above, below, lambda x: _number(p, x))
    if isinstance(of, m.Parameter) and of.magnitude != (None, None):
        bounds = ", ".join(filter(None, (bounds, f"magnitude {limits(*of.magnitude)}")))
    if bounds:
        yield _fact("range", (bounds,), "Range: {}.")
    if of.default is not None:
        yield _fact("default", default(of.default, p), "Default: {}.")


Bound = float | int | None


def limits(
    low: Bound, high: Bound, above: Bound = None, below: Bound = None, text: Callable[[float | int], str] | None = None
) -> str:
    """Bounds in words; a value may be `low` and `high` themselves, but neither `above` nor `below`.

    >>> limits(1, 2.5), limits(0, None), limits(None, 10)
    ('1 to 2.5', 'at least 0', 'at most 10')
    >>> limits(None, 10, above=0), limits(None, None, below=1)
    ('greater than 0, at most 10', 'less than 1')
    """
    text = text or number
    if low is not None and high is not None:
        return f"{text(low)} to {text(high)}"
    words = (("at least", low), ("greater than", above), ("at most", high), ("less than", below))
    return ", ".join(f"{word} {text(bound)}" for word, bound in words if bound is not None)


def _number(p: m.Parameter, value: float | int) -> str:
    """A number of a parameter, in the form that people know."""
    return descriptors.hexadecimal(p, int(value)) if p.shown else number(value)


def default(value: object, p: m.Parameter) -> Text:
    """A factory default, with the names of values and bits."""
    if isinstance(value, bool):
        return (str(value).lower(),)
    if isinstance(value, str):
        known = p.element.by_name(value) if isinstance(p.element, m.Enum) else None
        return (Ref(known, value, p.element),) if known and isinstance(p.element, m.Enum) else (f'"{value}"',)
    if isinstance(value, (list, tuple)):
        if isinstance(p.element, m.Bitfield) and all(isinstance(v, str) for v in value):
            bits = {b.name: b for b in p.element.bits}
            return joined([(Ref(bits[name], name, p.element),) for name in value]) if value else ("0",)
        return _interleaved([default(v, p) for v in value], ", ")
    return (_number(p, value) if isinstance(value, (int, float)) else str(value),)


def _valid(paths: tuple[str, ...], p: m.Parameter, record: Record, device: str | None = None) -> Fact:
    """The bit that says that a value is valid, or one for each element."""
    refs = [_bit(path, record, device) for path in dict.fromkeys(paths)]
    if len(refs) == 1:
        return _fact("valid", (refs[0],), "Valid if {} is set." if "." in refs[0].words else "Valid if {} is true.")
    names = p.element.elements if isinstance(p.element, m.Vector) else tuple(map(str, range(len(paths))))
    each = [(f"{name}: ", _bit(path, record, device)) for name, path in zip(names, paths, strict=False)]
    return _fact("valid", _interleaved(each, ", "), "Each element has its own valid flag. {}.")


def _bit(path: str, record: Record, device: str | None) -> Ref:
    """A bit of a sibling, by the type that it has on a device."""
    name, _, bit = path.partition(".")
    flags = next(q for q in record.parameters if q.name == name)
    own = (v.type for v in flags.readings if v.by_device and v.key == device)
    e = next(own, None) or flags.element
    known = next((b for b in e.bits if b.name == bit), None) if isinstance(e, m.Bitfield) else None
    return Ref(known, path, e) if known and isinstance(e, m.Bitfield) else Ref(flags, path, record)


def _presence(p: m.Parameter, record: Record) -> Iterator[Fact]:
    """When it may be left out."""
    if p.optional:
        yield _fact("optional", (), "Optional.")
    elif isinstance(record, m.Field) and p in record.counted and len(p.required_for) < len(record.functions):
        yield _fact("required", _functions(p.required_for), "Required for {}.")


def case(c: m.Case, union: m.Parameter, record: Record) -> Fact:
    """When a union has one of its alternatives."""
    tag = next(q for q in record.parameters if q.name == union.tag)
    assert isinstance(tag.element, m.Enum)
    value = (Ref(tag, tag.name, record), " is ", Ref(c.tag, c.tag.name, tag.element))
    return _fact("case", value, "If {}." if c.parameter else "Empty if {}.")


def variants(p: m.Parameter, record: Record, model: m.Model) -> list[tuple[tuple[m.Variant, ...], Fact]]:
    """What is different on devices, or with values of a sibling: one fact for all devices where it is the same."""
    groups: list[list[m.Variant]] = []
    for v in p.variants:
        same = next((g for g in groups if v.by_device and replace(g[0], key=v.key) == v), None)
        if same is None:
            groups.append([v])
        else:
            same.append(v)
    found = []
    for group in groups:
        said = difference(group[0], p, record, model)
        sentence = (*_condition(group, record, model), ": ", *said, ".")
        found.append((tuple(group), Fact("variant", said, sentence)))
    return found


def difference(v: m.Variant, p: m.Parameter, record: Record, model: m.Model) -> Text:
    """What a variant says, in words; it may be about a member of a structure."""
    within = p.element if v.member and isinstance(p.element, m.Struct) else None
    if within is not None:
        p = next(q for q in within.parameters if q.name == v.member)
    parts: list[Text] = []
    if v.unknown:
        parts.append(("the values are not known",))
    if v.type is not None:
        parts.append(("values of ", Ref(v.type, v.type.name)))
    if v.only:
        named = v.type or p.element
        assert isinstance(named, (m.Enum, m.Bitfield))
        parts.append(("only ", *joined([(Ref(x, x.name, named),) for x in v.only])))
    if v.constant is not None:
        parts.append((f"always {_number(p, v.constant)}",))
    for fact in _measures(v, p, model):
        parts.append((f"{fact.topic} ", *fact.value))
    if v.valid is not None:
        parts.append(_validity(v.valid, v.key if v.by_device else None, p, record))
    if v.deprecated is not None:
        parts.append(("deprecated" if v.deprecated else "not deprecated",))
    said = _interleaved(parts, "; ")
    if within is not None:
        said = (Ref(p, p.name, within), " has " if parts else ": ", *said)
    if v.description:
        said = (*said, *([". "] if parts else []), *prose(v.description.rstrip("."), model))
    return said


def usual(v: m.Variant, p: m.Parameter, record: Record, model: m.Model) -> Text:
    """What a parameter has in general where a variant of it differs, in words."""
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
    general = {fact.topic: fact for fact in _measures(p, p, model)}
    for topic in (fact.topic for fact in _measures(v, p, model)):
        parts.append((f"{topic} ", *general[topic].value) if topic in general else (f"{topic} not known",))
    if v.valid is not None:
        parts.append(_validity(p.valid, None, p, record))
    if v.deprecated is not None:
        parts.append(("not deprecated" if v.deprecated else "deprecated",))
    if v.description:
        parts.append(prose(p.description.rstrip("."), model))
    return _interleaved(parts, "; ")


def _validity(valid: tuple[str, ...], device: str | None, p: m.Parameter, record: Record) -> Text:
    """What says that the value is valid, on one device or in general."""
    if not valid:
        return ("no flag says whether it is valid",)
    fact = _valid(valid, p, record, device)
    many = len(set(valid)) > 1
    state = "" if many else " is set" if "." in valid[0] else " is true"
    return ("valid flags " if many else "valid if ", *fact.value, *([state] if state else []))


def _condition(group: Sequence[m.Variant], record: Record, model: m.Model) -> Text:
    """Where variants hold: "On the 3DM-GX5-15", "If mode is fast"."""
    v = group[0]
    if v.by_device:
        devices = [(x.key, model.device(x.key)) for x in group]
        return ("On the ", *joined([(_device(d) if d else key,) for key, d in devices]))
    p = next(q for q in record.parameters if q.name == v.by)
    assert isinstance(p.element, m.Enum)
    value = p.element.by_name(v.key)
    assert value is not None
    return ("If ", Ref(p, p.name, record), " is ", Ref(value, value.name, p.element))


# --------------------------------------------------------------------------- types and their parts


def bits_place(b: m.Bits) -> str:
    """
    >>> bits_place(m.Bits("a", 3, 3, "", False)), bits_place(m.Bits("b", 4, 7, "", False))
    ('bit 3', 'bits 4 to 7')
    """
    return f"bit {b.first}" if b.width == 1 else f"bits {b.first} to {b.last}"


def type(t: m.Type, model: m.Model) -> list[Fact]:
    """The facts about a type besides its description."""
    return uncertain(t, model)


def bits(b: m.Bits, model: m.Model) -> list[Fact]:
    place = bits_place(b)
    found = [Fact("place", (place,), (f"{place.capitalize()}.",))]
    if b.enum is not None:
        found.append(_fact("values", (Ref(b.enum, b.enum.name),), "A value of {}."))
    if b.alias:
        found.append(_fact("alias", (), "Overlaps other bits."))
    return found + uncertain(b, model)


def value(v: m.EnumValue, model: m.Model) -> list[Fact]:
    return [*([_fact("deprecated", (), "Deprecated.")] if v.deprecated else []), *uncertain(v, model)]


# --------------------------------------------------------------------------- devices


def device(d: m.Device, model: m.Model) -> list[Fact]:
    """The facts about a device besides its description, its fields, and what differs there."""
    found: list[Fact] = []
    if d.also:
        found.append(_fact("also", joined([(name,) for name in d.also]), "Also called {}."))
    if d.generation is not None:
        found.append(_fact("generation", (str(d.generation),), "Generation {}."))
    if d.model_number is not None:
        found.append(_fact("model_number", (str(d.model_number),), "Model number {}."))
    other = model.device(d.like) if d.like else None
    if other is not None:
        found.append(_fact("like", (_device(other),), "Like the {}, except as stated here."))
    manual = next((x for x in model.protocol.manuals if x.id == d.manual), None)
    known = (f"{manual.title}, {manual.document}",) if manual else ()
    found.append(_fact("manual", known, "Manual: {}." if manual else "No manual is known."))
    found += [
        _fact("incomplete", prose(text.rstrip("."), model), "This profile is incomplete: {}.") for text in d.incomplete
    ]
    return found + uncertain(d, model)


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


def sources(thing: m.Field | m.Set | m.Enum | m.Bitfield | m.Struct | m.Device) -> list[str]:
    """Where manuals say it: "3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)"."""
    return [f"{s.manual}: {s.section}" for s in thing.sources]


# --------------------------------------------------------------------------- words

_CODE = re.compile(r"`([^`]*)`")


def prose(text: str, model: m.Model) -> Text:
    """A text of the specification. The name of a field or a type in backticks, `base.ping`, becomes a reference;
    other text between backticks stays as it is."""

    def named(match: re.Match[str]) -> Ref | None:
        f, t = model.field(match[1]), model.type(match[1])
        if f is not None:
            return _field(f)
        return None if t is None or isinstance(t, m.Vector) else Ref(t, t.name)

    return _referring(text, _CODE, named)


def quotation(text: str, model: m.Model) -> Text:
    """A quotation of a manual, which names fields by their descriptors, as (0x0C,0x28)."""

    def described(match: re.Match[str]) -> Ref | None:
        found = model.candidates(int(match["set"], 16), int(match["descriptor"], 16))
        return Ref(found[0], match[0]) if found else None

    return _referring(text, DESCRIPTOR, described)


def _referring(text: str, pattern: re.Pattern[str], refer: Callable[[re.Match[str]], Ref | None]) -> Text:
    """The text with references in place of what they are made of."""
    found: list[str | Ref] = []
    at = 0
    for match in pattern.finditer(text):
        ref = refer(match)
        if ref is not None:
            found += [text[at : match.start()], ref]
            at = match.end()
    return tuple(part for part in (*found, text[at:]) if part)


def number(value: object) -> str:
    """
    >>> number(2.50), number(10.0), number(7)
    ('2.5', '10', '7')
    """
    return str(int(value)) if isinstance(value, float) and value.is_integer() and abs(value) < 1e15 else str(value)


def measured(number: str, unit: str | None, model: m.Model) -> str:
    """A number, or several, with the unit, as one writes it: 3 m, week 2412, 253 bytes."""
    word = next((w for w in model.protocol.units if w.symbol == unit), None)
    if word is None or word.symbol == "1":
        return number
    if word.numbered:
        return f"{word.symbol} {number}"
    return f"{number} {word.plural if word.plural and number != '1' else word.symbol}"


def joined(items: Sequence[Text], last: str = "and") -> Text:
    """
    >>> joined([("a",), ("b",), ("c",)])
    ('a', ', ', 'b', ' and ', 'c')
    """
    if len(items) < 2:
        return items[0] if items else ()
    return (*_interleaved(items[:-1], ", "), f" {last} ", *items[-1])


def _interleaved(items: Sequence[Text], between: str) -> Text:
    found: list[str | Ref] = []
    for i, item in enumerate(items):
        found += [between, *item] if i else item
    return tuple(found)


def _fact(topic: str, value: Text, sentence: str) -> Fact:
    """A fact whose sentence holds its value at `{}`."""
    head, mark, tail = sentence.partition("{}")
    whole = (head, *value, tail) if mark else (sentence,)
    return Fact(topic, value, tuple(part for part in whole if part))


def _field(f: m.Field) -> Ref:
    return Ref(f, f.full_name)


def _device(d: m.Device) -> Ref:
    return Ref(d, d.title)


def _functions(found: Iterable[m.Function]) -> Text:
    return joined([(Ref(f, f.name),) for f in found])
