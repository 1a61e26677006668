"""The reference manual: Markdown that reads well on a plain Git host and builds into a searchable site.

`places` determines the pages and anchors; `view` has a class for what each template shows, and templates arrange it.

Where to change what, and its tests in `tests/docs`:

- the page of a field: `view/fields`, field.md.j2; `test_reference_facts.py`; packets byte by byte, with the names and
  colours in hooks.py, and drawings of frames: `ruler`, `view/frames`; `test_reference_things.py`
- first steps: `start`, first.* and stream.* in `examples`; `test_reference_start.py` follows the page in an empty
  folder
- comparison and indexes: `view/comparison`, `view/indexes`, filter.js; `test_reference_comparison.py`,
  `test_reference_indexes.py`, `test_reference_filter.py`
- what the site adds, such as search, tabs and tools: runtime/markdown, docs/site.md; `test_reference_site.py`; what a
  search finds: `keywords` in the specification, search.js, tools/workbench/find.mjs; `tests/searches.py`
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from jinja2 import pass_context
from jinja2.runtime import Context

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target

from . import places, start, text
from .index import Index
from .places import Page, Thing
from .snippets import Named, listings, of_field
from .tools import TOOLS
from .view.base import View
from .view.comparison import Comparison
from .view.contents import Contents
from .view.devices import Device
from .view.examples import Example
from .view.fields import Field
from .view.frames import CENTRE, Units, drawings
from .view.guides import Guide
from .view.indexes import INDEXES
from .view.manuals import Erratum, parts_of_errata, parts_of_examples
from .view.packets import Packets
from .view.sets import Set
from .view.types import Type


@dataclass(frozen=True, slots=True)
class Site:
    """What all pages share."""

    index: Index
    lists: dict[str, Any]  # of pages, and the first programs if there are any

    def at(self, path: str) -> Page:
        return Page(path, self.index)

    def file(self, page: Page, template: str, of: Any = None, **views: Any) -> File:
        return File(page.path, template, {"page": page, **self.lists, **views}, of)


def files(model: m.Model) -> Iterator[File]:
    compared = places.COMPARISON if model.devices else {}
    lists = {"comparison": compared, "indexes": INDEXES, "starts": start.starts(model), "tools": TOOLS}
    site = Site(Index(model), lists)
    for drawing in drawings(model):
        yield File(drawing.path, "frame.svg.j2", {"drawing": drawing, "centre": CENTRE})
    yield from _lists(site, model)
    yield from _things(site, model)


def _lists(site: Site, model: m.Model) -> Iterator[File]:
    """Yields the pages that every specification has, and the navigation."""
    at, file = site.at, site.file
    for path in (places.README, places.INDEX):
        yield file(p := at(path), "index.md.j2", contents=Contents(p))
    if site.lists["starts"]:
        yield file(at(places.START), "start.md.j2")
        yield file(at(places.PROGRAMS), "programs.md.j2", frames=start.frame_files(model))
    yield file(p := at(places.PACKETS), "packets.md.j2", packets=Packets(p))
    yield file(p := at(places.UNITS), "units.md.j2", units=Units(p))
    for path in site.lists["comparison"]:
        kind = path.rpartition("/")[2].removesuffix(".md")
        yield file(p := at(path), "compare.md.j2", devices=Comparison(p), kind=kind)
    for x in INDEXES:
        yield file(at(x.path), "index_page.md.j2", index=x)
    for tool in TOOLS:
        yield file(at(places.place(tool, model)[0]), "tool.md.j2", tool=tool)
    errata, examples = parts_of_errata(model), parts_of_examples(model)
    yield file(p := at(places.ERRATA), "errata.md.j2", parts=[(x, [Erratum(p, e) for e in x.entries]) for x in errata])
    yield file(at(places.EXAMPLES), "examples.md.j2", parts=examples)
    for manual in dict.fromkeys(x.manual for x in examples):
        p = at(places.examples_page(manual.id))
        parts = [(x, [Example(p, e) for e in x.entries]) for x in examples if x.manual == manual]
        yield file(p, "examples_of_manual.md.j2", manual=manual, parts=parts)
    programs = list(_programs(site, model))
    for title, path, named in programs:
        yield file(at(path), "other_programs.md.j2", title=title, listings=listings(site.index.samples, named))
    p = at(places.INDEX)  # paths in the navigation are relative to docs/
    views = {"page": p, **site.lists, "contents": Contents(p), "examples": examples}
    views["programs"] = programs
    yield File("mkdocs.yml", "mkdocs.yml.j2", views)


def _programs(site: Site, model: m.Model) -> Iterator[tuple[str, str, list[Named]]]:
    """Yields the pages with the programs of fields and guides: title, path, and the programs."""
    for x in model.families:
        if fields := [of_field(f) for f in x.fields if f.role != m.RESPONSE]:
            yield places.label(x), places.programs_page(x.name), fields
    guides = [Guide(site.at(places.GUIDE_PROGRAMS), g) for g in model.guides]
    if sequences := [s.named_program for g in guides for s in g.sequences]:
        yield "Guides", places.GUIDE_PROGRAMS, sequences


def _things(site: Site, model: m.Model) -> Iterator[File]:
    """Yields the pages that are each about one thing of the specification; responses are on the pages of commands."""
    fields = [f for f in model.fields if f.role != m.RESPONSE]
    kinds: list[tuple[type[View[Any]], Sequence[Any]]] = [
        (Set, model.sets), (Field, fields), (Device, model.devices), (Guide, model.guides),
    ]  # fmt: skip
    for guide in model.guides:
        if guide.picture:
            yield File(places.guide_picture(guide), "picture.svg.j2", {"picture": guide.picture})
    for view, things in kinds:
        name = view.__name__.lower()
        for x in things:
            page = site.at(places.place(x, model)[0])
            yield site.file(page, f"{name}.md.j2", x, **{name: view(page, x)})
    for family in (None, *(x for x in model.families if x.types)):
        page = site.at(places.types_page(family.name if family else None))
        types = [Type(page, t) for t in (family or model).types]
        yield site.file(page, "types.md.j2", family, family=family, types=types)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Yields the anchors, which must be unique on each page."""
    things: list[Thing] = [model.protocol.acknowledge, model.protocol.function_selector, *model.all_types]
    things += [*model.fields, *model.protocol.units, *model.protocol.frames, *model.examples, *model.errata]
    for thing in things:
        page, anchor = places.place(thing, model)
        yield Identifier(page, anchor, getattr(thing, "name", anchor), getattr(thing, "position", None))


def _of_page(function: Callable[..., Any]) -> Callable[..., Any]:
    @pass_context
    def on_page(context: Context, *arguments: Any) -> Any:
        return function(context["page"], *arguments)

    return on_page


#: Text, and links and references, which are relative to the page.
FILTERS = {
    **{f.__name__: f for f in (text.code, text.count, text.inline, text.spaced, places.label)},
    **{f.__name__: _of_page(f) for f in (Page.anchor, Page.link, Page.links, Page.prose, Page.quotation)},
    "hex": text.hexadecimal,
}

TARGET = Target(
    title="Reference manual in Markdown, a site with MkDocs",
    files=files,
    filters=FILTERS,
    identifiers=identifiers,
    rename=package.in_source,
    slow=True,
)
