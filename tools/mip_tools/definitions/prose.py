"""Writes the texts of the definitions as Python source, from which the package reads its docstrings."""

from __future__ import annotations

from collections.abc import Iterator

from .document import Document, Item
from .records import derived, doc


def source(document: Document, home: str) -> str:
    """Writes the classes of a module with nothing but docstrings."""
    return "\n".join(_lines(document, home))


def _lines(document: Document, home: str) -> Iterator[str]:
    sets = [s for s in document.content["sets"] if document.module(s["family"]) == home]
    if sets:
        several = "\n".join(f"- {s['name']} (0x{s['number']:02X}): {s.get('description', '')}" for s in sets)
        yield repr(f"{sets[0]['title']}.\n\n{several if len(sets) > 1 else sets[0].get('description', '')}")
    for thing in (*document.content["types"], *document.content["fields"]):
        own, called = document.symbol(thing["name"])
        if own == home:
            yield f"class {called}:"
            yield f"    {doc(thing, 'field' if 'descriptor' in thing else '')!r}"
            yield from _members(document, thing)


def _members(document: Document, thing: Item) -> Iterator[str]:
    for x in (*thing.get("values", ()), *thing.get("bits", ())):
        yield f"    {document.constant(x['name'])} = 0\n    {x.get('description', '')!r}"
    for p in thing.get("parameters", ()):
        text = " ".join([p.get("description", ""), *p.get("notes", ())])
        if derived(p):
            yield f"    # On the wire only: {p['name']}. {' '.join(text.split())}"
        else:
            yield f"    {document.member(p['name'])}: int\n    {text!r}"
