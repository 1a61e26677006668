"""Compares two specifications to find out whether the new one breaks programs written for the old one.

There is a verdict for each change, and one for the whole:

same           nothing that a program could notice changed, but perhaps the documentation or the simulated device:
               a guide, a typical value, an example, an erratum
compatible     something was added, or a text, range or default changed
source         a program must be changed to build again: something was renamed or removed
wire           the same bytes mean something else, or other bytes are sent

The class of a change is the kind of fact that changed: a unit, a default, the reading of a device, ...
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any, Final, Literal

from mipgen import model as m

Verdict = Literal["same", "compatible", "source", "wire"]

#: The classes of changes, which a list of changes to ignore may name.
CLASSES: Final = (
    "added", "affects", "bound", "concerns", "condition", "constant", "default", "deprecated", "description", "devices",
    "documentation", "frame", "functions", "language", "layout", "magnitude", "name", "profile", "range", "reading",
    "removed", "responses", "short name", "sign", "type", "typical value", "unit", "unknown", "valid", "value",
    "value to send", "values",
)  # fmt: skip

#: From harmless to worst.
VERDICTS: Final[tuple[Verdict, ...]] = ("same", "compatible", "source", "wire")


@dataclass(frozen=True, slots=True)
class Change:
    verdict: Verdict
    kind: str  # the class, one of `CLASSES`
    subject: str  # "3dm.gyro_bias", "ack_code.ok", "3dm-gx5-15"
    what: str
    position: m.Position | None = field(default=None, compare=False)  # in the new specification

    def __str__(self) -> str:
        return f"{self.verdict:10} {self.kind:13} {self.subject}: {self.what}"

    def plain(self) -> dict[str, Any]:
        at = self.position
        place = {"file": at.file, "line": at.line} if at else {}
        return {"verdict": self.verdict, "class": self.kind, "subject": self.subject, "what": self.what, **place}


@dataclass(frozen=True, slots=True)
class Report:
    old: str  # version
    new: str
    verdict: Verdict
    changes: tuple[Change, ...]
    ignored: tuple[tuple[Change, str], ...] = ()  # each with the reason; they do not count

    def moved(self, before: str, now: str) -> Report:
        """Returns the report with `before` replaced by `now` at the beginning of file names."""
        if not before:
            return self
        return replace(self, changes=tuple(
            replace(c, position=c.position._replace(file=c.position.file.replace(before, now, 1)))
            if c.position else c for c in self.changes
        ))  # fmt: skip

    def whole(self, name: str) -> str:
        """Writes the verdict on one line; `name` is the name of the old specification."""
        return f"{name} (version {self.old}) -> version {self.new}: {self.verdict}"

    def text(self, name: str) -> str:
        """Writes one line for each change, and one for the verdict."""
        ignored = (f"{'ignored':10} {c.kind:13} {c.subject}: {c.what} ({reason})" for c, reason in self.ignored)
        return "\n".join([*map(str, self.changes), *ignored, self.whole(name)])

    def plain(self) -> dict[str, Any]:
        """Converts the report to values for JSON."""
        return {
            "old": self.old,
            "new": self.new,
            "verdict": self.verdict,
            "changes": [c.plain() for c in self.changes],
            "ignored": [{**c.plain(), "reason": reason} for c, reason in self.ignored],
        }

    def github(self, name: str) -> str:
        """Writes workflow commands that annotate the files of a pull request on GitHub."""
        return "\n".join([*map(_annotation, self.changes), self.whole(name)])


#: Verdict -> the GitHub workflow command for a change.
LEVELS: Final[dict[Verdict, str]] = {"same": "notice", "compatible": "notice", "source": "warning", "wire": "error"}


def _annotation(c: Change) -> str:
    r"""
    >>> _annotation(Change("wire", "unit", "a.b", "unit %, was m", m.Position("spec/a,b.yaml", 3, 7)))
    '::error file=spec/a%2Cb.yaml,line=3,col=7,title=mipgen diff%3A wire%2C unit::a.b: unit %25, was m'
    """

    def escaped(text: str, *others: str) -> str:
        for c in ("%", "\r", "\n", *others):
            text = text.replace(c, f"%{ord(c):02X}")
        return text

    at = c.position
    place = f"file={escaped(at.file, ':', ',')},line={at.line},col={at.column}," if at else ""
    title = escaped(f"mipgen diff: {c.verdict}, {c.kind}", ":", ",")
    return f"::{LEVELS[c.verdict]} {place}title={title}::{escaped(f'{c.subject}: {c.what}')}"


def compare_models(old: m.Model, new: m.Model) -> Report:
    unplaced = sorted(
        {
            *_fields(old, new),
            *_types(old, new),
            *_devices(old, new),
            *_functions(old, new),
            *_package(old, new),
            *_documentation(old, new),
        },
        key=lambda c: (-VERDICTS.index(c.verdict), c.subject, c.what),
    )
    places = _places(new)
    changes = tuple(replace(c, position=_nearest(c.subject, places)) for c in unplaced)
    return Report(old.protocol.version, new.protocol.version, worst(changes), changes)


def worst(changes: Iterable[Change]) -> Verdict:
    return max((c.verdict for c in changes), key=VERDICTS.index, default=VERDICTS[0])


def _places(model: m.Model) -> dict[str, m.Position | None]:
    """Returns the position of the definition of each possible subject of a change."""
    places: dict[str, m.Position | None] = {s.name: s.position for s in model.sets}
    places |= {x.name: x.position for x in model.families} | {d.id: d.position for d in model.devices}
    for t in model.all_types:
        name = t.full_name
        places[name] = getattr(t, "position", None)
        members: Sequence[Any] = getattr(t, "values", None) or getattr(t, "bits", None) or ()
        if isinstance(t, m.Struct):
            members = t.parameters
        places |= {f"{name}.{x.name}": x.position for x in members}
    for f in model.fields:
        places[f.full_name] = f.position
        places |= {f"{f.full_name}.{p.name}": p.position for p in f.parameters}
    return places


def _nearest(subject: str, places: dict[str, m.Position | None]) -> m.Position | None:
    """Returns the position of a subject, or else of the definition that contains it."""
    subject, _, device = subject.partition(" on ")
    name = device or subject.partition(" with ")[0]
    while name and places.get(name) is None:
        name = name.rpartition(".")[0]
    return places.get(name)


def unreadable(version: str, new: m.Model) -> Report:
    """Returns the report for an old specification in a format that is no longer supported: anything may have
    changed."""
    change = Change(
        "wire",
        "language",
        "the specification",
        "the old specification uses a language version that this mipgen cannot read",
    )
    return Report(version, new.protocol.version, change.verdict, (change,))


def enough(report: Report) -> bool:
    """True if the version number was raised enough for the changes. Before 1.0.0, the second number is the major one.

    >>> enough(Report("0.1.3", "0.1.4", "compatible", ())), enough(Report("1.1.3", "1.1.4", "compatible", ()))
    (True, False)
    >>> enough(Report("0.1.3", "0.2.0", "wire", ())), enough(Report("1.1.3", "1.2.0", "source", ()))
    (True, False)
    """
    old, new = ([int(part) for part in v.split(".")] for v in (report.old, report.new))
    if old[0] == 0 == new[0]:
        old, new = old[1:], new[1:]
    wanted = {"same": 3, "compatible": 2, "source": 1, "wire": 1}[report.verdict]
    return new[:wanted] > old[:wanted] or (report.verdict == "same" and new == old)


# --------------------------------------------------------------------------- fields


def _fields(old: m.Model, new: m.Model) -> Iterator[Change]:
    """Compares fields. Fields are identified by set, descriptor, role and constants, and by their size if it
    distinguishes layouts."""
    shared = {key for model in (old, new) for key, n in Counter(map(_identity, model.fields)).items() if n > 1}

    def place(f: m.Field) -> tuple[object, ...]:
        key = _identity(f)
        return (key, f.min_size) if key in shared else (key,)

    theirs, ours = ({place(f): f for f in model.fields} for model in (old, new))
    devices = frozenset(d.id for d in old.devices) & frozenset(d.id for d in new.devices)
    for key, f in theirs.items():
        if key not in ours:
            yield Change("source", "removed", f.full_name, f"removed {_place(f)}")
    for key, f in ours.items():
        before = theirs.get(key)
        if before is None:
            yield Change("compatible", "added", f.full_name, f"added {_place(f)}")
        else:
            yield from _field(before, f, devices)


def _identity(f: m.Field) -> tuple[object, ...]:
    return (f.set, f.descriptor, f.role, f.signature)


def _place(f: m.Field, number: int | None = None) -> str:
    return f"(0x{f.set if number is None else number:02X},0x{f.descriptor:02X})"


def _field(old: m.Field, new: m.Field, devices: frozenset[str]) -> Iterator[Change]:
    name = new.full_name
    if old.full_name != name:
        yield Change("source", "name", name, f"was called {old.full_name}")
    for number in set(old.sets) - set(new.sets):
        yield Change("source", "removed", name, f"removed from the set 0x{number:02X}")
    for number in set(new.sets) - set(old.sets):
        yield Change("compatible", "added", name, f"added {_place(new, number)}")
    yield from _differences("source", name, {"short name": (old.short, new.short)})
    if _wire(old) != _wire(new):
        yield Change("wire", "layout", name, _first_difference(old, new))
        return  # parameters can no longer be matched by position
    yield from _parameters(name, old.parameters, new.parameters, devices)
    a, b = m.letters(old.functions), m.letters(new.functions)
    if a != b:
        fewer = set(a) - set(b)
        yield Change(
            "source" if fewer else "compatible", "functions", name, f"functions {_worded(b)}, were {_worded(a)}"
        )
    if old.responses != new.responses:
        lost = [r for r in old.responses if r not in new.responses]
        yield Change(
            "source" if lost else "compatible",
            "responses",
            name,
            f"responses: {', '.join(new.responses) or 'none'}",
        )
    if (old.silent_when, old.when) != (new.silent_when, new.when):
        yield Change("wire", "condition", name, "sent or acknowledged under different conditions")
    if old.devices != new.devices:
        yield Change("compatible", "devices", name, "layout used by different devices")
    relations: dict[str, tuple[object, object]] = {
        "affects": (old.affects, new.affects),
        "may affect": (old.may_affect, new.may_affect),
    }
    yield from _differences("compatible", name, relations, "affects")
    if old.deprecated != new.deprecated:
        yield Change("compatible", "deprecated", name, "deprecated" if new.deprecated else "no longer deprecated")
    if _texts(old) != _texts(new):
        yield Change("compatible", "description", name, "another description")


def _texts(f: m.Field) -> tuple[object, ...]:
    return (f.title, f.description, f.notes, f.advanced, f.timeout)


def _wire(record: m.Field | m.Struct) -> tuple[object, ...]:
    """Returns the layout on the wire, without names."""
    order = {p.name: i for i, p in enumerate(record.parameters)}
    forms: list[object] = [_shape(p, order) for p in record.parameters]
    if isinstance(record, m.Field):
        forms += [(f.value, record.required(f.value)) for f in record.functions] or [record.required()]
    return tuple(forms)


def _shape(p: m.Parameter, order: dict[str, int]) -> tuple[object, ...]:
    length = order[p.length] if isinstance(p.length, str) and p.length in order else p.length
    cases = tuple((c.tag.value, _shape(c.parameter, {}) if c.parameter else None) for c in p.cases)
    return (_element(p.element), length, p.constant, p.selector, order.get(p.tag or ""), cases)


def _element(e: m.Scalar | m.Type | None) -> object:
    match e:
        case m.Struct():
            return _wire(e)
        case m.Vector():
            return (e.scalar.name, len(e.elements))
        case m.Enum():
            return e.scalar.name
        case m.Bitfield():
            return e.scalar.name if e.scalar else f"{e.size} bytes"
        case m.Scalar():
            return e.name
    return None


def _first_difference(old: m.Field, new: m.Field) -> str:
    for a, b in zip(old.parameters, new.parameters, strict=False):
        if _shape(a, {}) != _shape(b, {}):
            return f"layout differs from {b.name} on"
    more = len(new.parameters) - len(old.parameters)
    if more:
        return f"layout with {abs(more)} parameter{'s' if abs(more) > 1 else ''} {'more' if more > 0 else 'fewer'}"
    return "functions require other parameters"


# --------------------------------------------------------------------------- parameters


def _parameters(
    of: str, old: Sequence[m.Parameter], new: Sequence[m.Parameter], devices: frozenset[str] = frozenset()
) -> Iterator[Change]:
    """Compares the parameters of one layout by position. `devices`: the devices in both specifications."""
    for a, b in zip(old, new, strict=True):
        subject = f"{of}.{b.name}"
        if a.name != b.name:
            yield Change("source", "name", subject, f"was called {a.name}")
        meaning: dict[str, tuple[object, object]] = {
            "unit": (a.units, b.units),
            "frame": (a.frame, b.frame),
            "valid": (a.valid, b.valid),
        }
        yield from _differences("wire", subject, meaning)
        verdict: Verdict = "wire" if a.at_rest or a.positive else "compatible"
        yield from _differences(
            verdict, subject, {"at rest": (a.at_rest, b.at_rest), "positive": (a.positive, b.positive)}, "sign"
        )
        harmless = {
            "range": ((a.minimum, a.maximum), (b.minimum, b.maximum)),
            "bound": ((a.above, a.below), (b.above, b.below)),
            "magnitude": (a.magnitude, b.magnitude),
            "default": (a.default, b.default),
            "value to send": (a.reserved, b.reserved),
        }
        yield from _differences("compatible", subject, harmless)
        yield from _differences("same", subject, {"typical value": (a.typical, b.typical)})
        if _type_name(a.element) != _type_name(b.element):
            yield Change("source", "type", subject, f"of type {_type_name(b.element)}, was {_type_name(a.element)}")
        yield from _variants(subject, a, b, devices)
        if (a.description, a.notes, a.deprecated) != (b.description, b.notes, b.deprecated):
            yield Change("compatible", "description", subject, "another description")
        for c, d in zip(a.cases, b.cases, strict=True):
            if c.parameter and d.parameter:
                yield from _parameters(subject, [c.parameter], [d.parameter], devices)


def _variants(subject: str, old: m.Parameter, new: m.Parameter, devices: frozenset[str]) -> Iterator[Change]:
    """Compares the differences on a device, or with a value of another parameter. For a new or a removed device, the
    device itself counts as the change."""

    def by_key(p: m.Parameter) -> dict[tuple[str, str, str], m.Variant]:
        return {(v.by, v.key, v.member): v for v in p.variants}

    before, now = by_key(old), by_key(new)
    for key in {**before, **now}:
        by, value, member = key
        if by == m.DEVICE and value not in devices:
            continue
        kind = "reading" if by == m.DEVICE else ""
        of = f"{subject}.{member}" if member else subject
        of += f" on {value}" if by == m.DEVICE else f" with {by} {value}"
        a, b = (variants.get(key) or m.Variant(by, value) for variants in (before, now))
        meaning: dict[str, tuple[object, object]] = {
            "type": (a.type and a.type.name, b.type and b.type.name),
            "unit": (a.units, b.units),
            "frame": (a.frame, b.frame),
            "valid": ("as usual" if a.valid is None else a.valid, "as usual" if b.valid is None else b.valid),
            "constant": (a.constant, b.constant),
        }
        yield from _differences("wire", of, meaning, kind)
        harmless: dict[str, tuple[object, object]] = {
            "range": ((a.minimum, a.maximum), (b.minimum, b.maximum)),
            "default": (a.default, b.default),
            "values": (tuple(x.name for x in a.only), tuple(x.name for x in b.only)),
            "deprecated": (a.deprecated, b.deprecated),
            "unknown": (a.unknown, b.unknown),
        }
        yield from _differences("compatible", of, harmless, kind)
        if a.description != b.description:
            yield Change("compatible", kind or "description", of, "another description")


def _differences(
    verdict: Verdict, subject: str, pairs: dict[str, tuple[object, object]], kind: str = ""
) -> Iterator[Change]:
    """Yields a change for each pair that differs; its class is `kind`, or else the name of the pair."""
    for what, (old, new) in pairs.items():
        if old != new:
            yield Change(verdict, kind or what, subject, f"{what} {_worded(new)}, was {_worded(old)}")


def _worded(value: object) -> str:
    if value is None or value in ((), ""):
        return "none"
    if isinstance(value, (tuple, list)):
        return ", ".join("open" if v is None else str(v) for v in value)
    return str(value)


def _type_name(e: m.Scalar | m.Type | None) -> str:
    return "union" if e is None else e.name


# --------------------------------------------------------------------------- types


def _types(old: m.Model, new: m.Model) -> Iterator[Change]:
    """Compares the values, bits and members of types with the same name."""
    theirs, ours = ({t.full_name: t for t in model.all_types} for model in (old, new))
    for name, t in theirs.items():
        if name not in ours:
            yield Change("source", "removed", name, "removed")
        else:
            yield from _type(name, t, ours[name])
    for name in ours.keys() - theirs.keys():
        yield Change("compatible", "added", name, "added")


def _type(name: str, old: m.Type, new: m.Type) -> Iterator[Change]:
    match old, new:
        case m.Enum(), m.Enum():
            yield from _named(name, {v.value: v.name for v in old.values}, {v.value: v.name for v in new.values})
            yield from _shortened(name, old.values, new.values)
        case m.Bitfield(), m.Bitfield():
            yield from _named(
                name, {(b.first, b.last): b.name for b in old.bits}, {(b.first, b.last): b.name for b in new.bits}
            )
            yield from _shortened(name, old.bits, new.bits)
            before = {b.name: b for b in old.bits}
            for b in new.bits:
                if b.name in before:
                    was = before[b.name]
                    changed: dict[str, tuple[object, object]] = {
                        "concerns": (was.concerns, b.concerns),
                        "when": (was.when, b.when),
                    }
                    yield from _differences("compatible", f"{name}.{b.name}", changed)
        case m.Struct(), m.Struct():
            if _wire(old) == _wire(new):  # otherwise the fields report it
                yield from _parameters(name, old.parameters, new.parameters)
        case m.Vector(), m.Vector():
            if old.elements != new.elements:
                yield Change(
                    "source", "name", name, f"elements {', '.join(new.elements)}, were {', '.join(old.elements)}"
                )
        case _:
            yield Change("source", "type", name, f"{new.kind}, was {old.kind}")
    if not isinstance(old, m.Vector) and not isinstance(new, m.Vector):
        yield from _differences("source", name, {"short name": (old.short, new.short)})
    if old.description != new.description:
        yield Change("compatible", "description", name, "another description")


def _shortened(of: str, old: Sequence[m.EnumValue | m.Bits], new: Sequence[m.EnumValue | m.Bits]) -> Iterator[Change]:
    """Compares the short names of values or bits that still exist."""
    before = {x.name: x.short for x in old}
    for x in new:
        if x.name in before:
            yield from _differences("source", f"{of}.{x.name}", {"short name": (before[x.name], x.short)})


def _named(of: str, old: dict[Any, str], new: dict[Any, str]) -> Iterator[Change]:
    """Compares the names of numbers or bits; a name that moved to another number is the dangerous change."""
    for number, name in old.items():
        if new.get(number) == name:
            continue
        if name in new.values():
            yield Change("wire", "value", f"{of}.{name}", f"is {_number(new, name)}, was {_shown(number)}")
        elif number in new:
            yield Change("source", "name", f"{of}.{new[number]}", f"was called {name}")
        else:
            yield Change("source", "removed", f"{of}.{name}", "removed")
    for number, name in new.items():
        if number not in old and name not in old.values():
            yield Change("compatible", "added", f"{of}.{name}", f"added: {_shown(number)}")


def _number(of: dict[Any, str], name: str) -> str:
    return next(_shown(number) for number, n in of.items() if n == name)


def _shown(number: object) -> str:
    return f"bits {number[0]}-{number[1]}" if isinstance(number, tuple) else str(number)


# --------------------------------------------------------------------------- devices and functions


def _devices(old: m.Model, new: m.Model) -> Iterator[Change]:
    def by_id(model: m.Model) -> dict[str, m.Device | m.NamedDevice]:
        return {d.id: d for d in model.devices} | {d.id: d for d in model.named}

    theirs, ours = by_id(old), by_id(new)
    for name in theirs.keys() - ours.keys():
        yield Change("source", "removed", name, "removed")
    for name, d in ours.items():
        before = theirs.get(name)
        if before is None:
            yield Change("compatible", "added", name, "added")
        elif isinstance(before, m.Device) and isinstance(d, m.Device):
            if _profiles(before, d):
                yield Change("compatible", "profile", name, f"profile differs: {', '.join(_profiles(before, d))}")
        elif isinstance(before, m.Device):
            yield Change("source", "profile", name, "profile removed: only the name is known")
        elif isinstance(d, m.Device):
            yield Change("compatible", "profile", name, "profile added: only the name was known")
        elif before != d:
            yield Change("compatible", "profile", name, "other names, or another device is most like it")


def _profiles(old: m.Device, new: m.Device) -> list[str]:
    """Names the differences between two profiles of a device."""
    a, b = _profile(old), _profile(new)
    return [what for what in a if a[what] != b[what]]


def _profile(d: m.Device) -> dict[str, object]:
    groups = tuple(
        (s.set, s.field.descriptor, m.letters(s.functions), s.evidence.kind, s.firmware, s.deprecated)
        for s in (*d.supports, *d.refuses)
    )
    return {
        "identity": (d.title, d.description, d.also, d.model_number, d.generation, d.manual),
        "fields": groups,
        "absent sets": tuple((s.number, e.needs) for e in d.evidence for s in e.sets),
        "base rates": tuple((r.set.number, r.hertz) for r in d.base_rates),
        "ports": d.ports,
        "limits": d.limits,
        "notes": d.notes,
        "codes": d.ack_codes,
        "uncertainties": (d.incomplete, d.uncertain),
    }


def _functions(old: m.Model, new: m.Model) -> Iterable[Change]:
    a, b = ({f.value: f.name for f in model.protocol.functions} for model in (old, new))
    return _named("function_selector", a, b)


def _package(old: m.Model, new: m.Model) -> Iterator[Change]:
    a, b = old.protocol.package, new.protocol.package
    if a != b:
        yield Change("source", "name", "the package", f"renamed from {a} to {b}")


# --------------------------------------------------------------------------- documentation


def _documentation(old: m.Model, new: m.Model) -> Iterator[Change]:
    """Yields the changes that no user's program notices."""

    def quantities(of: m.Model) -> dict[str, object]:
        return {q.name: (q.typical, q.description) for q in of.simulation.quantities}

    def simulated(of: m.Model) -> dict[str, object]:
        behaviors = {b.command.full_name: b for b in of.simulation.behaviors}
        sources = {s.field.full_name if s.set is None else s.field.name_in(s.set): s for s in of.simulation.sources}
        return {**sources, **behaviors}

    kinds: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
        "guide": ({g.name: g for g in old.guides}, {g.name: g for g in new.guides}),
        "example": ({e.id: e for e in old.examples}, {e.id: e for e in new.examples}),
        "erratum": ({e.id: e for e in old.errata}, {e.id: e for e in new.errata}),
        "quantity": (quantities(old), quantities(new)),
        "simulation": (simulated(old), simulated(new)),
    }
    for kind, (before, now) in kinds.items():
        for name in before.keys() | now.keys():
            if name not in now:
                yield Change("same", "documentation", name, f"{kind} removed")
            elif name not in before:
                yield Change("same", "documentation", name, f"{kind} added")
            elif _plain(before[name]) != _plain(now[name]):
                yield Change("same", "documentation", name, f"another {kind}")


def _plain(x: Any) -> object:
    """Returns the attributes of a thing; references are replaced by names."""
    match x:
        case m.Field():
            return x.full_name
        case m.Device():
            return x.id
        case m.Set() | m.Family():
            return x.name
        case list() | tuple():
            return [_plain(item) for item in x]
        case dict():
            return {key: _plain(value) for key, value in x.items()}
    if is_dataclass(x):
        return [_plain(getattr(x, f.name)) for f in fields(x) if f.compare]
    return x
