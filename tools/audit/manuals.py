"""Reads a manual's text and lists everything in it that the specification does not cover.

The manuals are not part of the project; anybody who has them can check the specification against them. It looks for
headings with descriptors, printed packets, and references to descriptors such as (0x0C,0x28). Conversely, each section
that the specification may cite must be in the manual.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from mipgen import model as m

_HEX = r"[0-9A-Fa-f]"
_REFERENCE = re.compile(rf"\(?0x({_HEX}{{2}})[,.]\s*(?:0x)?({_HEX}{{2}})\b(?!{_HEX})\)?")
_HEADING = re.compile(rf"^(?:#+ |\d+\.\d+\.\d+ )(?:\*\*)?(.*\(0x({_HEX}{{2}}), ?0x({_HEX}{{2}})\))(?:\*\*)?\s*$")
_STRING = re.compile(rf"(?<!{_HEX})75\s?65(?:\s?{_HEX}{{2}}){{2}}(?:\s?{_HEX}+)*(?!{_HEX})")
_CELL = re.compile(rf"(?:<b>)?0x({_HEX}{{2}})(?:</b>)?$")


@dataclass(frozen=True, slots=True, order=True)
class Finding:
    """A difference between the specification and a line of another source."""

    file: str
    line: int
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.message}"


def audit_manuals(model: m.Model, manual: str, path: Path) -> list[Finding]:
    lines = path.read_text("utf-8", errors="replace").splitlines()
    findings = [
        *_sections(model, manual, lines),
        *_headings(model, manual, lines),
        *_references(model, manual, lines),
        *_packets(model, manual, lines),
    ]
    return sorted(Finding(path.name, line, message) for line, message in set(findings))


# --------------------------------------------------------------------------- sections


def _sections(model: m.Model, manual: str, lines: list[str]) -> Iterator[tuple[int, str]]:
    """Checks that each listed section is a line of the manual; "Page > Heading" is two lines, in this order."""
    places: dict[str, list[int]] = {}
    for number, line in enumerate(lines, 1):
        places.setdefault(_plain(line), []).append(number)
    for section in next(x.sections for x in model.protocol.manuals if x.id == manual):
        at = 0
        for part in section.split(" > "):
            below = [number for number in places.get(_plain(part), ()) if number > at]
            if not below:
                yield at or 1, f"the manual has no section '{section}'"
                break
            at = below[0]


# --------------------------------------------------------------------------- descriptors


def _headings(model: m.Model, manual: str, lines: list[str]) -> Iterator[tuple[int, str]]:
    """Checks that each heading with a descriptor is cited by the field that it defines."""
    places = ((o, f.descriptor) for f in model.fields for o in f.occurrences)
    cited = {(o.set, d, _plain(s.section)) for o, d in places for s in o.sources if s.manual == manual}
    for number, line in enumerate(lines, 1):
        heading = _HEADING.match(line)
        if heading:
            key = (int(heading[2], 16), int(heading[3], 16), _plain(heading[1]))
            if not any(k[:2] == key[:2] and key[2] in k[2] for k in cited):
                yield number, f"no field cites the heading {heading[1]}"


def _plain(heading: str) -> str:
    """Returns a heading without numbering, punctuation and spaces, which differ between converters and authors."""
    return re.sub(r"^[\W_]*(\d+(\.\d+)*\.? )?|[\W_]", "", heading).lower()


def _references(model: m.Model, manual: str, lines: list[str]) -> Iterator[tuple[int, str]]:
    """Checks that each (set,descriptor) is defined, or that an erratum reports it as undefined."""
    undefined = {c.subject for e in model.errata if e.manual == manual for c in e.claims if c.kind == "reference"}
    for number, line in enumerate(lines, 1):
        for match in _REFERENCE.finditer(line):
            if not match[0].startswith("("):
                continue
            pair = (int(match[1], 16), int(match[2], 16))
            name = f"0x{pair[0]:02X},0x{pair[1]:02X}"
            if pair != model.protocol.sync and not model.candidates(*pair) and name not in undefined:
                yield number, f"({name}) is not defined, and no erratum reports this"


# --------------------------------------------------------------------------- packets


def _packets(model: m.Model, manual: str, lines: list[str]) -> Iterator[tuple[int, str]]:
    """Checks that each packet in the manual is an example, as often as the manual prints it."""
    examples = [e for e in model.examples if e.manual == manual]
    strings = Counter("".join(e.string.split()).lower() for e in examples if e.string is not None)
    tables = Counter(_head(e.table) for e in examples if e.table is not None and e.role != "field")
    for number, line in enumerate(lines, 1):
        for match in _STRING.finditer(line):
            digits = "".join(match[0].split()).lower()
            if strings[digits] == 0:
                yield number, f"no example contains the string {match[0]}"
            strings[digits] -= 1
        row = _row(line)
        if row is not None:
            if tables[row] == 0:
                yield (
                    number,
                    f"no example has a table that begins {' '.join('??' if b is None else f'{b:02X}' for b in row)}",
                )
            tables[row] -= 1


def _row(line: str) -> tuple[int | None, ...] | None:
    """Returns the first six bytes of the packet in a table row; None if the line is not such a row."""
    cells = [c.strip() for c in line.split("\t")]
    for i, cell in enumerate(cells):
        if cell == "0x75" and i + 1 < len(cells) and cells[i + 1] == "0x65":
            matches = [_CELL.match(c) for c in cells[i : i + 6]]
            return tuple(int(x[1], 16) if x else None for x in matches)
    return None


def _head(table: tuple[int | None, ...]) -> tuple[int | None, ...]:
    return table[:6]
