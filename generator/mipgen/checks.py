"""Judges a resolved model. Every check is one function that reports all it finds."""

from __future__ import annotations

import re
from collections.abc import Iterator

from . import codec
from . import model as m
from .problems import Problems, nearest

RESPONSE_DESCRIPTORS = range(0x80, 0xF1)
COMMAND_DESCRIPTORS = range(0x01, 0x80)
DATA_DESCRIPTORS = range(0x01, 0xD0)
SHARED_DESCRIPTORS = range(0xD0, 0x100)


def check(model: m.Model, problems: Problems) -> None:
    for one in (set_numbers, descriptors, names, enumerations, bitfields, layouts, replies, devices,
                printed_lengths, printed_bytes, references):  # fmt: skip
        one(model, problems)


# --------------------------------------------------------------------------- sets and names


def set_numbers(model: m.Model, problems: Problems) -> None:
    seen: dict[int, m.Set] = {}
    for s in model.sets:
        if s.number in seen:
            problems.add(s.position, f"0x{s.number:02X} is the set '{seen[s.number].name}' already; give '{s.name}' its own")
        seen[s.number] = s


def descriptors(model: m.Model, problems: Problems) -> None:
    for s in model.sets:
        seen: dict[int, m.Field] = {}
        for f in s.fields:
            _descriptor_range(s, f, problems)
            other = seen.setdefault(f.descriptor, f)
            if other is not f and not _told_apart(other, f):
                problems.add(
                    f.position,
                    f"duplicate descriptor 0x{f.descriptor:02X}: '{other.name}' and '{f.name}' of the set '{s.name}'; "
                    "two layouts of one descriptor need a const that differs at the same place",
                )


def _descriptor_range(s: m.Set, f: m.Field, problems: Problems) -> None:
    allowed = (
        RESPONSE_DESCRIPTORS if f.role == m.RESPONSE
        else COMMAND_DESCRIPTORS if f.role == m.COMMAND
        else SHARED_DESCRIPTORS if s.kind == "shared"
        else DATA_DESCRIPTORS
    )  # fmt: skip
    if f.descriptor not in allowed:
        what = "shared data" if s.kind == "shared" else f.role
        span = f"0x{allowed.start:02X} to 0x{allowed.stop - 1:02X}"
        problems.add(f.position, f"'{f.name}': 0x{f.descriptor:02X} is no {what} descriptor; those are {span}")


def _told_apart(a: m.Field, b: m.Field) -> bool:
    if a.role != m.RESPONSE or b.role != m.RESPONSE:
        return False
    mine = {(at, op.size): op.value for at, op in a.constants}
    return any(mine.get((at, op.size), op.value) != op.value for at, op in b.constants)


def names(model: m.Model, problems: Problems) -> None:
    for s in model.sets:
        seen: set[str] = set()
        for name, place in [(t.name, getattr(t, "position", s.position)) for t in s.types] + [
            (f.name, f.position) for f in s.fields
        ]:
            if name in seen:
                problems.add(place, f"the name '{name}' stands twice in the set '{s.name}'; rename one")
            seen.add(name)


# --------------------------------------------------------------------------- types


def _all_types(model: m.Model) -> Iterator[m.Type]:
    yield from model.types
    for s in model.sets:
        yield from s.types


def enumerations(model: m.Model, problems: Problems) -> None:
    for t in _all_types(model):
        if not isinstance(t, m.Enum):
            continue
        seen: dict[int, str] = {}
        for v in t.values:
            if v.value >> (8 * t.scalar.size):
                problems.add(t.position, f"'{t.name}': {v.name} = {v.value} does not fit into {t.scalar.name}")
            if v.value in seen:
                problems.add(t.position, f"'{t.name}': {seen[v.value]} and {v.name} are both {v.value}; drop one")
            seen[v.value] = v.name


def bitfields(model: m.Model, problems: Problems) -> None:
    for t in _all_types(model):
        if not isinstance(t, m.Bitfield):
            continue
        used = 0
        for b in t.bits:
            if not b.alias and used & b.mask:
                problems.add(t.position, f"'{t.name}': {b.name} overlaps other bits; if that is meant, add alias: true")
            if not b.alias:
                used |= b.mask
            wide = [v for v in b.enum.values if v.value >> b.width] if b.enum else []
            if wide:
                problems.add(t.position, f"'{t.name}': {wide[0].name} = {wide[0].value} does not fit into the {b.width} bits of {b.name}")


# --------------------------------------------------------------------------- fields


def layouts(model: m.Model, problems: Problems) -> None:
    for f in model.fields:
        if f.min_size > m.MAX_FIELD_DATA:
            problems.add(f.position, f"'{f.name}': {f.min_size} bytes do not fit into the {m.MAX_FIELD_DATA} data bytes of a field")
        for p in f.parameters:
            _values_fit(p, problems)


def _values_fit(p: m.Parameter, problems: Problems) -> None:
    if not isinstance(p.element, m.Scalar) or p.element.kind not in ("unsigned", "signed"):
        return
    bits = 8 * p.element.size
    low, high = (0, (1 << bits) - 1) if p.element.kind == "unsigned" else (-(1 << bits - 1), (1 << bits - 1) - 1)
    for what, value in (("reserved", p.reserved), ("the range", p.minimum), ("the range", p.maximum)):
        if value is not None and not low <= value <= high:
            problems.add(p.position, f"'{p.name}': {value} ({what}) does not fit into {p.element.name}")
    if isinstance(p.default, (int, float)) and not isinstance(p.default, bool) and p.length is None:
        low, high = (p.minimum if p.minimum is not None else low), (p.maximum if p.maximum is not None else high)  # type: ignore[assignment]
        if not low <= p.default <= high:
            problems.add(p.position, f"'{p.name}': the default {p.default} lies outside of {low} to {high}")


def replies(model: m.Model, problems: Problems) -> None:
    """A command that can be read needs a response to read it from, and the reverse."""
    for f in model.fields:
        if f.role != m.COMMAND or not f.functions:
            continue
        reads = any(x.responds for x in f.functions)
        if reads and not f.responses:
            problems.add(f.position, f"'{f.name}' can be read, but has no response; add one, or drop R from functions")
        if f.responses and not reads:
            problems.add(f.position, f"'{f.name}' has a response, but no function asks for it; add R to functions")


# --------------------------------------------------------------------------- devices


def devices(model: m.Model, problems: Problems) -> None:
    seen: dict[str, m.Device] = {}
    known = {t.name for t in _all_types(model)}
    for d in model.devices:
        for name in (d.id, d.name):
            if name in seen and seen[name] is not d:
                problems.add(d.position, f"there are two devices called '{name}'; rename one")
            seen[name] = d
        for name, _ in d.functions:
            if name not in d.fields:
                problems.add(d.position, f"functions: the device does not support '{name}'; add it to supports")
        rated = {name for name, _ in d.base_rates}
        for name in sorted({f.partition(".")[0] for f in d.fields}):
            s = next(s for s in model.sets if s.name == name)
            if s.kind == "data" and name not in rated:
                problems.add(d.position, f"base_rates: the rate of '{name}' is missing (0 if data are sent as they come)")
        for name, _ in d.readings:
            if "." not in name and name not in known:
                problems.add(d.position, f"readings: unknown type '{name}'{nearest(name, known)}")


# --------------------------------------------------------------------------- evidence


def printed_lengths(model: m.Model, problems: Problems) -> None:
    """A printed length either follows from the manual's own rule or has an erratum."""
    rules = {x.id: x.lengths for x in model.protocol.manuals}
    claims = {c.subject: c for e in model.errata for c in e.claims if c.kind == "length"}
    claimed_by = {(e.manual, c.subject) for e in model.errata for c in e.claims if c.kind == "length"}
    differing = set()
    for f in (*model.fields, model.protocol.acknowledge):
        for source in f.sources:
            if source.length is None or source.length == "unavailable":
                continue
            expected = computed_length(f, rules.get(source.manual, "wire"))
            if _same_length(source.length, expected):
                continue
            differing.add((source.manual, f.full_name))
            if (source.manual, f.full_name) not in claimed_by:
                place = source.position if f.role != m.RESPONSE else f.position
                problems.add(
                    place,
                    f"{source.manual} prints the length {source.length} for '{f.full_name}', "
                    f"but its rule gives {expected}; correct it, or add an erratum that claims length: {f.full_name}",
                )
    names_ = {f.full_name for f in model.fields} | {model.protocol.acknowledge.full_name}
    for e in model.errata:
        for c in e.claims:
            if c.kind != "length":
                continue
            if c.subject not in names_:
                problems.add(c.position, f"unknown field '{c.subject}'{nearest(c.subject, names_)}")
            elif (e.manual, c.subject) not in differing:
                problems.add(c.position, f"the length that {e.manual} prints for '{c.subject}' is right (or not given); drop the claim")
    del claims


def computed_length(f: m.Field, rule: str) -> str:
    """The length of the full field as a manual counts it: "14", or "4 + 3*count".

    `wire` counts every byte. `scalars` counts scalars and arrays of them, and counted arrays in
    formulas, but neither vectors nor structures nor unions.
    """
    fixed, formula = 2, ""
    for p in f.parameters:
        op = p.operation
        match op:
            case m.ScalarOp() | m.ConstantOp() | m.CounterOp() | m.BitsOp():
                fixed += op.size
            case m.TextOp() | m.ArrayOp():
                item = 1 if isinstance(op, m.TextOp) else codec.size_of(op.item)
                if op.count is None:
                    formula = f" + {item}*{op.counter or 'rest'}"
                elif rule == "wire" or not isinstance(p.element, (m.Vector, m.Struct)):
                    fixed += item * op.count
            case m.StructOp() if rule == "wire":
                fixed += op.struct.max_size if op.struct.fixed else op.struct.min_size
            case _:
                pass
    return f"{fixed}{formula}"


def _same_length(printed: str, expected: str) -> bool:
    """
    >>> _same_length("4 + 3*N", "4 + 3*N"), _same_length("4+3*N", "4 + 3*N"), _same_length("0x0E", "14")
    (True, True, True)
    """
    if re.fullmatch(r"0x[0-9A-Fa-f]+", printed):
        printed = str(int(printed, 16))
    return "".join(printed.split()) == "".join(expected.split())


def printed_bytes(model: m.Model, problems: Problems) -> None:
    """A print that differs from the right bytes has an erratum, and the reverse."""
    claimed = {c.subject for e in model.errata for c in e.claims if c.kind == "example"}
    by_id = {e.id: e for e in model.examples}
    differing = {e.id for e in model.examples if differences(e)}
    for name in sorted(differing - claimed):
        e = by_id[name]
        problems.add(e.position, f"the print of '{name}' is wrong ({'; '.join(differences(e))}); add an erratum that claims example: {name}")
    for e in model.errata:
        for c in e.claims:
            if c.kind != "example":
                continue
            if c.subject not in by_id:
                problems.add(c.position, f"unknown example '{c.subject}'{nearest(c.subject, by_id)}")
            elif c.subject not in differing:
                problems.add(c.position, f"the prints of '{c.subject}' are right; drop the claim")


def differences(e: m.Example) -> list[str]:
    """How the prints of an example differ from its right bytes."""
    right = e.packet[4:-2] if e.role == "field" else e.packet
    found = []
    if e.string is not None:
        digits = "".join(e.string.split())
        if len(digits) % 2:
            found.append(f"string has an odd number of digits, {len(digits)}")
        elif bytes.fromhex(digits) != right:
            found.append(f"string {_where(tuple(bytes.fromhex(digits)), right)}")
    if e.table is not None and (
        len(e.table) != len(right) or any(a is not None and a != b for a, b in zip(e.table, right, strict=False))
    ):
        found.append(f"table {_where(e.table, right)}")
    return found


def _where(printed: tuple[int | None, ...], right: bytes) -> str:
    for i, (a, b) in enumerate(zip(printed, right, strict=False)):
        if a is not None and a != b:
            return f"byte {i} is {a:02X}, should be {b:02X}"
    return f"has {len(printed)} bytes, should have {len(right)}"


def references(model: m.Model, problems: Problems) -> None:
    """An erratum that calls a reference undefined must be right."""
    for e in model.errata:
        for c in e.claims:
            if c.kind == "reference":
                number, descriptor = (int(x, 16) for x in c.subject.split(","))
                if model.candidates(number, descriptor):
                    problems.add(c.position, f"({c.subject}) is defined; drop the claim")
