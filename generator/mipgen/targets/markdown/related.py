"""Fields that are related to a field."""

from __future__ import annotations

from collections.abc import Iterator

from mipgen import model as m
from mipgen.facts import describe

from .fields import on_page
from .places import Page, field_page


def related(page: Page, f: m.Field) -> list[m.Field]:
    """Returns the fields that share a field's descriptor or response, suppress its acknowledge, or are named in its
    texts."""
    fields: dict[str, m.Field] = {}
    for g in _related(page, f):
        if g.role != m.RESPONSE and g.set and field_page(g) != field_page(f):
            fields.setdefault(g.full_name, g)
    return sorted(fields.values(), key=lambda g: (g.set, g.descriptor, g.name))


def _related(page: Page, f: m.Field) -> Iterator[m.Field]:
    model = page.model
    yield from model.layouts(f)
    for r in model.responses(f):
        yield from model.commands(r)
    for c in f.silenced_by:
        command = model.field(c.command or "")
        if command is not None:
            yield command
    for record in on_page(page, f):
        texts = [record.description, *record.notes, *(p.description for p in record.parameters)]
        texts += [note for p in record.parameters for note in p.notes]
        for text in texts:
            if "`" in text:
                yield from (
                    r.thing
                    for r in describe.prose(text, model)
                    if isinstance(r, describe.Ref) and isinstance(r.thing, m.Field)
                )
