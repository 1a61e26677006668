"""Checks a resolved model. Each check is a function that reports everything it finds."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import PurePath

from mipgen import model as m
from mipgen.facts.examples import misprint_text
from mipgen.facts.simulated_values import parameter_at
from mipgen.lower.extent import computed_length, same
from mipgen.lower.validity import NANOSECONDS
from mipgen.read.problems import Problems, nearest

RESPONSE_DESCRIPTORS = range(0x80, 0xF1)
COMMAND_DESCRIPTORS = range(0x01, 0x80)
DATA_DESCRIPTORS = range(0x01, 0xD0)


#: Command of a session -> the types of its parameters, and the parameters in words.
SESSION = {
    "ping": ((), "no parameters"),
    "idle": ((), "no parameters"),
    "resume": ((), "no parameters"),
    "identify": ((), "no parameters"),
    "base_rate": (("u8",), "a descriptor set"),
    "format": (("u8", "u8", "[u8 u16]"), "a descriptor set, a count, and that many descriptors with decimations"),
    "stream": (("u8", "bool"), "a descriptor set, and whether its data is sent"),
}

#: The same for commands for one set.
OLDER = {
    "base_rate": ((), "no parameters"),
    "format": (("u8", "[u8 u16]"), "a count, and that many descriptors with decimations"),
}

#: Command of a session -> the required content of its response.
ANSWERS = {
    "identify": "the texts of `model_numbers`",
    "base_rate": "one parameter in Hz",
    "descriptors": "an array of u16, `descriptors`",
}


def check_definitions(model: m.Model, problems: Problems) -> None:
    for check in (
        check_any_field,
        set_numbers,
        check_descriptors,
        check_named,
        check_names,
        titles,
        check_words,
        enumerations,
        bitfields,
        check_lengths,
        check_replies,
        check_clocks,
        check_session,
        fields_of,
    ):
        check(model, problems)


def check_evidence(model: m.Model, problems: Problems) -> None:
    """Runs the checks that need correct definitions."""
    for check in (check_package, descriptions, check_units, states, printed_lengths, printed_bytes, check_errata):
        check(model, problems)


def check_any_field(model: m.Model, problems: Problems) -> None:
    """Requires at least one field: pages and packages begin with one."""
    if not model.fields:
        problems.add(model.protocol.acknowledge.position, "no set contains a field; add one to a file in sets/")


def fields_of(model: m.Model, problems: Problems) -> None:
    """Checks `fields_of`, the set to which field descriptors belong: a parameter beside them, or the name of a set."""
    for record in model.records:
        choices = {s.name for s in model.sets} | {p.name for p in record.parameters if p.shown == "set"}
        for p in record.parameters:
            if p.fields_of and p.fields_of not in choices:
                near = nearest(p.fields_of, choices)
                message = f"'{p.fields_of}' is neither the name of a set nor a parameter with shown: set{near}"
                problems.add(p.position, message)


# --------------------------------------------------------------------------- sets and names


def set_numbers(model: m.Model, problems: Problems) -> None:
    seen: dict[int, m.Set] = {}
    for s in model.sets:
        if s.number in seen:
            problems.add(
                s.position,
                f"0x{s.number:02X} is already the set '{seen[s.number].name}' at {seen[s.number].position}; "
                f"give '{s.name}' another number",
            )
        seen[s.number] = s


def check_descriptors(model: m.Model, problems: Problems) -> None:
    for s in model.families:
        seen: dict[int, list[m.Field]] = {}
        for f in s.fields:
            if not _descriptor_range(s, f, problems):
                continue
            layouts = seen.setdefault(f.descriptor, [])
            beside = (g for g in layouts if not set(g.sets).isdisjoint(f.sets))
            other = next((g for g in beside if not _told_apart(g, f)), None)
            if other is None:
                layouts.append(f)
                continue
            apart = ", or a const or a fixed size that distinguishes the layouts" if f.role != m.COMMAND else ""
            problems.add(
                f.position,
                f"'{f.name}' has the descriptor 0x{f.descriptor:02X} of '{other.name}'; give it another{apart}",
            )


def _descriptor_range(s: m.Family, f: m.Field | m.Named, problems: Problems) -> bool:
    allowed = (
        RESPONSE_DESCRIPTORS if f.role == m.RESPONSE
        else COMMAND_DESCRIPTORS if f.role == m.COMMAND
        else m.SHARED_DESCRIPTORS if s.kind == "shared"
        else DATA_DESCRIPTORS
    )  # fmt: skip
    if f.descriptor not in allowed:
        what = "shared data" if s.kind == "shared" else f.role
        span = f"0x{allowed.start:02X} to 0x{allowed.stop - 1:02X}"
        problems.add(f.position, f"'{f.name}': 0x{f.descriptor:02X} is not a {what} descriptor; use {span}")
    return f.descriptor in allowed


def _told_apart(a: m.Field, b: m.Field) -> bool:
    """True if layouts can be distinguished: by a constant that differs, or that only the first one contains, which is
    tried first; or, with the same constants, by their sizes. A command has one layout."""
    if m.COMMAND in (a.role, b.role):
        return False
    mine = {(at, len(constant)): constant for at, constant in a.signature}
    if any(mine.get((at, len(constant)), constant) != constant for at, constant in b.signature):
        return True
    fixed = a.min_size == a.max_size and b.min_size == b.max_size
    differ = a.min_size != b.min_size if a.signature == b.signature else set(a.signature) > set(b.signature)
    return fixed and differ


def check_named(model: m.Model, problems: Problems) -> None:
    """Requires that a descriptor is either defined or only named."""
    for s in model.families:
        seen = {f.descriptor: f.name for f in s.fields}
        for x in s.named:
            if _descriptor_range(s, x, problems) and x.descriptor in seen:
                problems.add(
                    x.position,
                    f"'{x.name}' has the descriptor 0x{x.descriptor:02X} of '{seen[x.descriptor]}'; "
                    "remove it from the named ones",
                )
            seen.setdefault(x.descriptor, x.name)


def check_names(model: m.Model, problems: Problems) -> None:
    """Requires unique names for the types and fields of a set, including their other names."""
    for s in model.families:
        fields = [(f.name, f.position) for f in s.fields]
        others = [(x.name, x.position) for x in s.named] + [(name, f.position) for f in s.fields for name in f.also]
        for entries in ([(t.name, t.position) for t in s.types] + fields, fields + others):
            used: set[str] = set()
            for name, place in entries:
                if name in used:
                    problems.add(place, f"the name '{name}' is used twice in the set '{s.name}'; rename one")
                used.add(name)


def titles(model: m.Model, problems: Problems) -> None:
    """Requires unique titles for the commands and data fields of a set: pages and search results show only titles.

    Responses may share the title of their command.
    """
    for s in model.families:
        used: dict[tuple[str, str], str] = {}
        for f in s.fields:
            for o in f.occurrences if f.role != m.RESPONSE else ():
                other = used.setdefault((o.set_name, o.title), f.name)
                if other != f.name:
                    problems.add(o.position, f"'{f.name}' has the title '{o.title}' of '{other}'; give it another")


def check_words(model: m.Model, problems: Problems) -> None:
    """Requires the words of the vocabulary in names; names in an overlay are free."""
    vocabulary = model.protocol.vocabulary
    usual = {other: usage.word for usage in vocabulary for other in usage.instead_of}
    folders = {PurePath(usage.position.file).parent for usage in vocabulary if usage.position}
    unusual = re.compile(rf"(?<![^_])({'|'.join(map(re.escape, usual))})(?![^_])")
    for name, place in _all_names(model) if usual else ():
        for match in unusual.finditer(name):
            if place is not None and not any(PurePath(place.file).is_relative_to(folder) for folder in folders):
                continue
            word = usual[match[1]]
            problems.add(place, f"the name '{name}': the vocabulary uses '{word}' for '{match[1]}'; write '{word}'")


#: What `emit.package` replaces in the output.
_RENAMED = re.compile(r"\b(?:mip(?![_-]tools\b|_simulator\b)|Mip|MIP(?=_))(?![A-Za-z0-9])")


def check_package(model: m.Model, problems: Problems) -> None:
    """Rejects names that begin with `mip` in a package with another name, and values that contain it: they would be
    renamed, too."""
    own, package = m.OWN_PACKAGE, model.protocol.package
    if package == own:
        return
    devices = ((d.name, d.position) for d in model.devices)
    for name, place in (*_all_names(model), *_names_of(model.protocol.acknowledge.parameters), *devices):
        if name == own or name.startswith(f"{own}_"):
            renamed = package + name.removeprefix(own)
            problems.add(place, f"the name '{name}' would become '{renamed}' in the package '{package}'; rename it")
    for text, place in _values(model):
        if found := _RENAMED.search(text):
            message = f"'{text}' contains '{found[0]}', which the package '{package}' replaces by its own name"
            problems.add(place, f"{message}; write it differently")


def check_clocks(model: m.Model, problems: Problems) -> None:
    """Requires timestamps to be data fields that contain a time, of one clock each, or of one with an epoch and one
    without."""
    names = {f.name_in(o.set) for f in model.fields if f.role == m.DATA for o in f.occurrences}
    seen: dict[tuple[str, bool], str] = {}
    for clock in model.protocol.clocks:
        dated = clock.epoch is not None
        for name in clock.timestamps:
            f = model.field(name)
            if f is None or f.role != m.DATA:
                problems.add(clock.position, f"no data field '{name}'{nearest(name, names)}")
            elif (name, dated) in seen:
                other = seen[name, dated]
                problems.add(clock.position, f"'{name}' is already a timestamp of the clock '{other}'; remove one")
            elif not any(set(p.units) & NANOSECONDS.keys() for p in f.parameters):
                units = ", ".join(sorted(NANOSECONDS))
                problems.add(clock.position, f"'{name}' is not a timestamp: none of its parameters is in {units}")
            seen.setdefault((name, dated), clock.name)


def check_session(model: m.Model, problems: Problems) -> None:
    """Requires session commands whose parameters and responses programs can handle."""
    session = model.protocol.session
    if session is None:
        return
    for role, (types, words) in SESSION.items():
        if problem := _role_problem(role, getattr(session, role), types, words, model, session):
            problems.add(session.position, problem)
    for name in session.descriptors:
        if problem := _role_problem("descriptors", name, (), "no parameters", model, session):
            problems.add(session.position, problem)
    sets = {s.name for s in model.sets if s.kind == "data"}
    for older in session.older:
        if older.set not in sets:
            problems.add(older.position, f"`older`: no data set '{older.set}'{nearest(older.set, sets)}")
        for role, (types, words) in OLDER.items():
            if problem := _role_problem(role, getattr(older, role), types, words, model, session):
                problems.add(older.position, problem)


def _role_problem(
    role: str, name: str, types: tuple[str, ...], words: str, model: m.Model, session: m.Session
) -> str | None:
    """Returns the reason why a command cannot have a role in a session; None if it can."""
    f = model.field(name)
    if f is None or f.role != m.COMMAND:
        names = {x.full_name for x in model.fields if x.role == m.COMMAND}
        return f"`{role}`: no command '{name}'{nearest(name, names)}"
    if tuple(_type(p) for p in f.calls[0].required) != types:
        return f"`{role}`: '{name}' must accept {words}"
    if role in ANSWERS and not _answers(role, model.responses(f), session):
        return f"`{role}`: '{name}' must have one response, with {ANSWERS[role]}"
    return None


def _answers(role: str, responses: tuple[m.Field, ...], session: m.Session) -> bool:
    """True if a session command has the response that programs read."""
    if len(responses) != 1:
        return False
    (response,) = responses
    if role == "base_rate":
        return sum(p.units == ("Hz",) for p in response.parameters) == 1
    if role == "descriptors":
        return any((p.name, p.kind, p.leaf.scalar.name) == ("descriptors", "array", "u16") for p in response.parameters)
    texts = [parameter_at(response.parameters, path) for path in session.model_numbers]
    return all(p is not None and p.kind == "text" for p in texts)


def _type(p: m.Parameter) -> str:
    """Returns the type of a parameter; for an array of structures, the types of their members."""
    if p.kind == "array" and p.item.struct:
        return f"[{' '.join(_type(q) for q in p.item.struct.parameters)}]"
    return p.scalar.name if p.kind in ("scalar", "counter") else p.kind


def _all_names(model: m.Model) -> Iterator[tuple[str, m.Position | None]]:
    """Yields every name that an author has chosen."""
    for t in model.all_types:
        yield t.name, t.position
        match t:
            case m.Enum():
                yield from ((v.name, v.position) for v in t.values)
            case m.Bitfield():
                yield from ((b.name, b.position) for b in t.bits)
            case m.Struct():
                yield from _names_of(t.parameters)
    for s in model.sets:
        yield s.name, s.position
    for f in model.fields:
        yield f.name, f.position
        yield from _names_of(f.parameters)


def _names_of(parameters: tuple[m.Parameter, ...]) -> Iterator[tuple[str, m.Position | None]]:
    for p in parameters:
        yield p.name, p.position
        yield from _names_of(p.alternatives)


def _values(model: m.Model) -> Iterator[tuple[str, m.Position | None]]:
    """Yields the titles, other names and ids that programs show or search."""
    yield model.protocol.title, model.protocol.position
    for x in model.families:
        yield from ((title, x.position) for title in (x.title, *(s.title for s in x.sets)))
        yield from ((named.title, named.position) for named in x.named)
    for f in model.fields:
        yield from ((text, f.position) for text in (*(o.title for o in f.occurrences), *f.also))
    for d in model.devices:
        ports = (text for p in d.ports for text in (p.name, *p.receives, *p.sends))
        yield from ((text, d.position) for text in (d.id, d.title, *d.also, *ports, *(n.title for n in d.notes)))


# --------------------------------------------------------------------------- types


def enumerations(model: m.Model, problems: Problems) -> None:
    for t in model.all_types:
        if not isinstance(t, m.Enum):
            continue
        seen: dict[int, str] = {}
        for v in t.values:
            if v.value >> t.scalar.width:
                problems.add(v.position, f"'{t.name}': {v.name} = {v.value} does not fit in {t.scalar.name}")
            if v.value in seen:
                problems.add(v.position, f"'{t.name}': {seen[v.value]} and {v.name} are both {v.value}; remove one")
            seen.setdefault(v.value, v.name)


def bitfields(model: m.Model, problems: Problems) -> None:
    for t in model.all_types:
        if not isinstance(t, m.Bitfield):
            continue
        used: list[m.Bits] = []
        for b in t.bits:
            other = next((o for o in used if o.mask & b.mask), None)
            if other is not None and not b.alias:
                problems.add(
                    b.position, f"'{t.name}': {b.name} overlaps {other.name}; add alias: true if it is meant to"
                )
            if not b.alias:
                used.append(b)
            for v in b.enum.values if b.enum else ():
                if v.value >> b.width:
                    problems.add(
                        b.position,
                        f"'{t.name}': {v.name} = {v.value} of '{b.enum.name if b.enum else ''}' "
                        f"does not fit in {b.name}, whose range is 0 to {b.mask >> b.first}",
                    )
                    break


# --------------------------------------------------------------------------- fields


def check_lengths(model: m.Model, problems: Problems) -> None:
    """Requires that the shortest form of each field fits in a packet, that of a response behind its acknowledge.
    Fields that no packet can contain were reported with the parameter that is too much."""
    most = model.protocol.max_payload
    for f in model.fields:
        used = 2 + f.min_size + (4 if f.role == m.RESPONSE else 0)
        if used > most and f.min_size <= m.MAX_FIELD_DATA:
            beside = " with its acknowledge" if f.role == m.RESPONSE else ""
            problems.add(f.position, f"'{f.full_name}' has {used} bytes{beside}; max_payload is {most}")


def check_replies(model: m.Model, problems: Problems) -> None:
    """Requires a response for each command that can be read, and a read function for each such response."""
    for f in model.fields:
        if f.role != m.COMMAND or not f.functions:
            continue
        reads = any(x.responds for x in f.functions)
        if reads and not f.responses:
            problems.add(
                f.position, f"'{f.name}' can be read, but has no response; add one, or remove R from functions"
            )
        if f.responses and not reads:
            problems.add(f.position, f"'{f.name}' has a response, but no function requests it; add R to functions")


def _parameters(model: m.Model) -> Iterator[m.Parameter]:
    """Yields the parameters of all fields and structures, except reserved ones."""
    for record in (model.protocol.acknowledge, *model.records):
        yield from (p for p in record.parameters if p.reserved is None)


def descriptions(model: m.Model, problems: Problems) -> None:
    for p in _parameters(model):
        if not p.description:
            problems.add(p.position, f"'{p.name}' has no description; add one")
        for case in p.cases:
            # The type of a case describes it; a plain number or a text has no type of its own.
            if case.parameter and isinstance(case.parameter.element, m.Scalar) and not case.parameter.description:
                problems.add(case.parameter.position, f"the case '{case.tag.name}' has no description; add one")


def check_units(model: m.Model, problems: Problems) -> None:
    """Requires a unit for each float, even if it is "1"; otherwise a forgotten unit would go unnoticed."""
    for parameter in _parameters(model):
        for p in (parameter, *(case.parameter for case in parameter.cases if case.parameter)):
            scalar = p.element.scalar if isinstance(p.element, m.Vector) else p.element
            varies = p.variants and all(v.units for v in p.variants)
            if isinstance(scalar, m.Scalar) and scalar.kind == "float" and not (p.units or p.any_unit or varies):
                remedy = 'add one ("1" for a plain number, ~ if another value determines it or it is unknown)'
                problems.add(p.position, f"'{p.name}' has no unit; {remedy}")


def states(model: m.Model, problems: Problems) -> None:
    """Requires beside each bitfield with states a parameter that has them."""
    for record in model.records:
        named = {p.name: {t.full_name for t in _types(p)} for p in record.parameters}
        for t in (t for p in record.parameters for t in _types(p) if isinstance(t, m.Bitfield)):
            for b in t.bits:
                if b.when and b.when.type not in named.get(b.when.parameter, ()):
                    wanted = f"'{t.name}' needs a parameter '{b.when.parameter}' of type '{b.when.type}' beside it"
                    problems.add(b.position, f"'{b.name}': {wanted}; correct `when`")


def _types(p: m.Parameter) -> Iterator[m.Enum | m.Bitfield]:
    """Yields the type of a parameter, and those that it has on some devices or with some values."""
    for t in (p.element, *(v.type for v in p.variants)):
        if isinstance(t, (m.Enum, m.Bitfield)):
            yield t


# --------------------------------------------------------------------------- evidence


def printed_lengths(model: m.Model, problems: Problems) -> None:
    """Requires an erratum for each printed length that does not follow from the manual's own rule."""
    rules = {x.id: x.lengths for x in model.protocol.manuals}
    claimed_by = {(e.manual, c.subject) for e in model.errata for c in e.claims if c.kind == "length"}
    differing = set()
    for name, f, source in _printed(model):
        if rules.get(source.manual) == "none":
            problems.add(source.position, f"{source.manual} states no lengths; remove the length of '{name}'")
            continue
        expected = computed_length(f, rules.get(source.manual, "wire"))
        if same(source.length or "", expected):
            continue
        differing.add((source.manual, name))
        if (source.manual, name) not in claimed_by:
            problems.add(
                source.position,
                f"{source.manual} states the length {source.length} for '{name}', but its rule yields "
                f"{expected}; correct it, or add an erratum that claims length: {name}",
            )
    every = (*model.fields, model.protocol.acknowledge)
    names_ = {f.name_in(o.set) for f in every for o in f.occurrences}
    for e in model.errata:
        for c in e.claims:
            if c.kind != "length":
                continue
            if c.subject not in names_:
                problems.add(c.position, f"unknown field '{c.subject}'{nearest(c.subject, names_)}")
            elif (e.manual, c.subject) not in differing:
                problems.add(
                    c.position,
                    f"the length that {e.manual} states for '{c.subject}' is correct (or not given); remove the claim",
                )


def _printed(model: m.Model) -> Iterator[tuple[str, m.Field, m.Source]]:
    """Yields the lengths that manuals print, each with the field's name in the set for which it is printed."""
    for f in (*model.fields, model.protocol.acknowledge):
        for o in f.occurrences:
            for source in o.sources:
                if source.length not in (None, "unavailable"):
                    yield f.name_in(o.set), f, source


def printed_bytes(model: m.Model, problems: Problems) -> None:
    """Requires an erratum for each example whose printed bytes are wrong, and wrong bytes for each such erratum."""
    claimed = {c.subject for e in model.errata for c in e.claims if c.kind == "example"}
    by_id = {e.id: e for e in model.examples}
    differing = {e.id for e in model.examples if misprint_text(e)}
    for name in sorted(differing - claimed):
        what = "; ".join(misprint_text(by_id[name]))
        problems.add(
            by_id[name].position,
            f"the bytes of '{name}' in the manual are wrong ({what}); add an erratum that claims example: {name}",
        )
    for e in model.errata:
        for c in e.claims:
            if c.kind != "example":
                continue
            if c.subject not in by_id:
                problems.add(c.position, f"unknown example '{c.subject}'{nearest(c.subject, by_id)}")
            elif c.subject not in differing:
                problems.add(c.position, f"the bytes of '{c.subject}' in the manual are correct; remove the claim")


def check_errata(model: m.Model, problems: Problems) -> None:
    """Rejects an erratum that calls a reference undefined if it is defined."""
    for e in model.errata:
        for c in e.claims:
            if c.kind == "reference":
                number, descriptor = (int(x, 16) for x in c.subject.split(","))
                if model.candidates(number, descriptor):
                    problems.add(c.position, f"({c.subject}) is defined; remove the claim")
