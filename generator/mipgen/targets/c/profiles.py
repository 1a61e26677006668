"""The tables of devices: see runtime/c/src/mip/extra/profile.h."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from mipgen import model as m
from mipgen.facts import describe

from .comments import Comments
from .literals import decimal, hexadecimal, string


@dataclass(frozen=True, slots=True)
class Table:
    """An array, which is not defined if it is empty."""

    type: str
    name: str
    count: int
    lines: list[str]
    title: str = ""  # of a member of struct mip_profile; empty if that has no such member


@dataclass(frozen=True, slots=True)
class Profile:
    """A device, and its tables in the order of the members of struct mip_profile."""

    of: m.Device
    doc: list[str]
    tables: list[Table]


def profiles(model: m.Model) -> list[Profile]:
    return [Profile(d, Comments(model).device(d), [*_tables(d, model)]) for d in model.devices]


def _tables(d: m.Device, model: m.Model) -> Iterator[Table]:
    name = d.name
    yield _table("char *const", f"{name}_also", map(string, d.also), "other names")
    yield _table("char *const", f"{name}_incomplete", map(string, d.incomplete), "what is not known")
    evidence = [
        (f"MIP_SUPPORT_{e.answer.upper()}", string(describe.why(e, model)), string(e.absence)) for e in d.evidence
    ]
    yield _structures("evidence", f"{name}_evidence", evidence)
    yield _structures("field", f"{name}_fields", _fields(d, d.supports), "fields")
    yield _structures("field", f"{name}_refuses", _fields(d, d.refuses), "refused fields")
    absent = [
        (hexadecimal(s.number), "0", '""', f"&{name}_evidence[{i}]") for i, e in enumerate(d.evidence) for s in e.sets
    ]
    yield _structures("field", f"{name}_absent_sets", absent, "absent sets")
    firmware = [(*_field(s), string(s.firmware)) for s in d.supports if s.firmware]
    yield _structures("firmware", f"{name}_firmware", firmware, "fields of some firmware")
    rates = [(hexadecimal(r.set.number), decimal(r.hertz)) for r in d.base_rates]
    yield _structures("rate", f"{name}_rates", rates, "base rates")
    readings = [(string(v.path), string(v.variant.type.full_name)) for v in d.variants if v.variant.type]
    yield _structures("reading", f"{name}_readings", readings, "readings")


def _table(of: str, name: str, items: Iterable[str], title: str = "") -> Table:
    lines = [f"{item}," for item in items]
    return Table(of, name, len(lines), lines, title)


def _structures(kind: str, name: str, rows: Iterable[Sequence[str]], title: str = "") -> Table:
    return _table(f"struct mip_profile_{kind}", name, (f"{{{', '.join(row)}}}" for row in rows), title)


def _field(s: m.Support) -> tuple[str, str]:
    return hexadecimal(s.set), hexadecimal(s.field.descriptor)


def _fields(d: m.Device, supports: Iterable[m.Support]) -> Iterator[Sequence[str]]:
    for s in supports:
        yield *_field(s), string(m.letters(s.functions)), f"&{d.name}_evidence[{d.evidence.index(s.evidence)}]"
