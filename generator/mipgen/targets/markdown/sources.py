"""What the manuals say, and where they are wrong: citations and errata."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ... import describe
from ... import model as m
from ...checks import computed_length
from ...guided import Guide
from .fields import length
from .places import Page, label
from .text import code, inline

SEVERITIES = ("wire", "meaning", "editorial")


def of_manual(things: Sequence[Any], manual: m.Manual) -> list[Any]:
    """Examples or errata of a manual."""
    return [t for t in things if t.manual == manual.id]


# --------------------------------------------------------------------------- citations


def citations(page: Page, thing: m.Field | m.Type | m.Set | m.Chapter | m.Device | Guide) -> list[str]:
    """Where the manuals describe a thing, a line for each."""
    lines = []
    for s in getattr(thing, "sources", ()):
        remark = _length_remark(page, thing, s) if isinstance(thing, m.Field) else ""
        lines.append(f"{_manual(page, s)}: {inline(s.section)}{f' ({remark})' if remark else ''}")
    return lines


def field_lengths(page: Page, manual: m.Manual) -> str:
    """What the lengths of fields in a manual are."""
    return page.say(describe.lengths(manual, page.model))


def length_remarks(page: Page, f: m.Field) -> list[str]:
    """The manuals that give another length for a response; it cites the sections of its command."""
    remarks = [(_manual(page, s), _length_remark(page, f, s)) for s in f.sources]
    return list(dict.fromkeys(f"{manual}: {remark}" for manual, remark in remarks if remark))


def _manual(page: Page, s: m.Source) -> str:
    return page.link(next(x for x in page.model.protocol.manuals if x.id == s.manual))


def _length_remark(page: Page, f: m.Field, s: m.Source) -> str:
    if s.length is None or s.length == "unavailable":
        return ""
    right = length(f.parameters)
    wrong = page.index.errata_of_length(f, s.manual)
    if wrong:
        by = ", ".join(page.link(e, f"erratum {label(e)}") for e in wrong)
        return f"length given as {code(s.length)} instead of {right}: {by}"
    if "".join(s.length.split()) in ("".join(x.split()) for x in (right.strip("`"), computed_length(f, "wire"))):
        return ""
    return f"length given as {code(s.length)} instead of {right}, not counting vectors, structures and unions"


def own_lines(thing: m.Field) -> str:
    """Where the specification itself defines a field: a file of its folder, and a line."""
    if thing.position is None:
        return ""
    return f"{code('/'.join(thing.position.file.split('/')[-2:]))}, line {thing.position.line}"


# --------------------------------------------------------------------------- errata


def severities(errata: Sequence[m.Erratum]) -> list[tuple[str, list[m.Erratum]]]:
    """Errata by severity, the worst first."""
    return [(s, [e for e in errata if e.severity == s]) for s in SEVERITIES]


def subjects(page: Page, e: m.Erratum) -> list[str]:
    """What an erratum is about: links to fields and examples."""
    model, found = page.model, []
    examples = {x.id: x for x in model.examples}
    for c in e.claims:
        f = model.field(c.subject)
        if c.kind == "length" and f is not None:
            found.append("length of " + page.link(f))
        elif c.kind == "example":
            found.append("example " + page.link(examples[c.subject]))
        elif c.kind == "reference":
            found.append(f"reference to {inline(f'({c.subject})')}, which no manual defines")
    claimed = {c.subject for c in e.claims if c.kind == "length"}
    fields = {f.full_name: f for f in page.index.fields_of_section(e)}
    return found + [page.link(f) for name, f in fields.items() if name not in claimed]
