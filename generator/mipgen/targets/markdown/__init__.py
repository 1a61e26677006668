"""The reference manual: Markdown that reads well on a plain Git host and builds into a searchable site.

`places` determines the pages and anchors, each other module writes the Markdown for its subject, and templates arrange
it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from jinja2 import pass_context
from jinja2.runtime import Context

from mipgen import model as m
from mipgen.emit import package
from mipgen.emit.target import File, Identifier, Target

from . import (
    comparison,
    devices,
    examples,
    fields,
    frames,
    guides,
    indexes,
    packets,
    parameters,
    places,
    related,
    snippets,
    sources,
    start,
    text,
    tools,
    types,
)
from .index import Index
from .places import Page, Thing


def files(model: m.Model) -> Iterator[File]:
    index = Index(model)
    comparisons = places.COMPARISON if model.devices else {}
    starts = start.starts(model)
    lists = {"comparison": comparisons, "indexes": places.INDEXES, "starts": starts}

    def page(path: str, template: str, of: Any = None, **context: Any) -> File:
        return File(path, template, {"page": Page(path, index), **lists, **context}, of)

    printed, wrong = examples.parts(model), sources.parts(model)
    navigation = {"page": Page(places.INDEX, index), **lists, "examples": printed, "errata": wrong}
    yield File("mkdocs.yml", "mkdocs.yml.j2", navigation)  # its paths are relative to docs/
    yield page(places.README, "index.md.j2")
    yield page(places.INDEX, "index.md.j2")
    if starts:
        yield page(places.START, "start.md.j2")
        yield page(places.PROGRAMS, "programs.md.j2", frames=start.frames(model))
    yield page(places.PACKETS, "packets.md.j2")
    yield page(places.UNITS, "units.md.j2")
    for name, title, axes in frames.drawn(model):
        yield File(frames.drawing(name), "frame.svg.j2", {"title": title, "axes": axes, "centre": frames.CENTRE})
    yield page(places.ERRATA, "errata.md.j2", parts=wrong)
    for part in wrong:
        yield page(part.path, "errata_of_manual.md.j2", part=part)
    yield page(places.EXAMPLES, "examples.md.j2", parts=printed)
    for group in printed:
        yield page(group.path, "examples_of_set.md.j2", part=group)
    for name in comparisons:
        yield page(places.comparison_page(name), f"compare/{name}.md.j2")
    for name in places.INDEXES:
        yield page(places.index_page(name), f"indexes/{name}.md.j2")
    yield from _things(model, page)


def _things(model: m.Model, page: Callable[..., File]) -> Iterator[File]:
    """Yields the pages that are each about one thing."""
    for tool in tools.TOOLS:
        yield page(places.tool_page(tool), "tool.md.j2", tool=tool)
    for s in model.sets:
        yield page(places.set_page(s.name), "set.md.j2", s, set=s, family=model.family(s.family))
    yield page(places.TYPES, "types.md.j2", family=None)
    for x in model.families:
        if x.types:
            yield page(places.types_page(x.name), "types.md.j2", x, family=x)
        for f in fields.asked(x.fields):
            yield page(places.field_page(f), "field.md.j2", f, field=f)
    for d in model.devices:
        yield page(places.device_page(d), "device.md.j2", d, device=d)
    for g in model.guides:
        yield page(places.guide_page(g), "guide.md.j2", g, guide=g)


def identifiers(model: m.Model) -> Iterator[Identifier]:
    """Yields the anchors, which must be unique on each page."""
    things: list[Thing] = [model.protocol.acknowledge, model.protocol.function_selector, *model.all_types]
    things += [*model.fields, *model.protocol.units, *model.protocol.frames, *model.examples, *model.errata]
    for thing in things:
        page, anchor = places.place(thing, model)
        yield Identifier(page, anchor, getattr(thing, "name", anchor), getattr(thing, "position", None))


# --------------------------------------------------------------------------- filters of the templates

Filters = dict[str, Callable[..., Any]]

FILTERS: Filters = {
    "code": text.code,
    "count": text.count,
    "hex": text.hexadecimal,
    "inline": text.inline,
    "spaced": text.spaced,
    "label": places.label,
    "descriptors": places.descriptors,
    "types_page": places.types_page,
    "comparison_page": places.comparison_page,
    "index_page": places.index_page,
    "asked": fields.asked,
    "field_length": fields.field_length,
    "checksum_steps": fields.checksum_steps,
    "directions": frames.directions,
    "nature": types.nature,
    "elements": types.elements,
    "ports": devices.ports,
    "base_rate": devices.base_rate,
    "note_table": devices.note_table,
    "of_manual": sources.of_manual,
    "defined": sources.defined,
    "heading": guides.heading,
    "step_title": guides.title,
    "bandwidth": guides.bandwidth,
    "surely": guides.surely,
    "read": guides.read,
    "right_bytes": examples.right_bytes,
    "misprints": examples.misprints,
    "tools": lambda _: tools.TOOLS,
}

#: Filters that need the page where they are used: links are relative to it.
FILTERS_OF_PAGE: Filters = {
    "anchor": Page.anchor,
    "link": Page.link,
    "links": Page.links,
    "prose": Page.prose,
    "quotation": Page.quotation,
    "facts": fields.facts,
    "notes": fields.notes,
    "relations": fields.relations,
    "on_devices": fields.on_devices,
    "conversions": frames.conversions,
    "drawings": frames.drawings,
    "changed": fields.changed,
    "own_responses": fields.own_responses,
    "forms": packets.forms,
    "ruler": packets.ruler,
    "replies": packets.replies,
    "printed": examples.printed,
    "as_command": parameters.as_command,
    "programs": snippets.programs,
    "related": related.related,
    "field_values": parameters.field_values,
    "contents": fields.contents,
    "occurrences": sources.occurrences,
    "named": fields.named,
    "uncertain": fields.uncertain,
    "parameter_list": parameters.parameter_list,
    "parameter_values": parameters.parameter_values,
    "values": types.values,
    "bits": types.bits,
    "supported": devices.supported,
    "evident": devices.evident,
    "witnesses": devices.witnesses,
    "differing": devices.differing,
    "deprecated": devices.deprecated,
    "limits": devices.limits,
    "remarks": devices.remarks,
    "devices": lambda page, _: devices.listed(page),
    "base_rates": devices.base_rates,
    "rates_of_set": devices.rates_of_set,
    "variants": devices.variants,
    "generations": lambda page, _: comparison.generations(page),
    "compared": comparison.fields,
    "other_devices": lambda page, _: comparison.others(page.model),
    "perhaps_of_others": comparison.perhaps,
    "compared_rates": lambda page, _: comparison.rates(page),
    "compared_meanings": lambda page, _: comparison.meanings(page),
    "index_of": indexes.index,
    "citations": sources.citations,
    "field_lengths": sources.field_lengths,
    "length_remarks": sources.length_remarks,
    "subjects": sources.subjects,
    "device": examples.device,
    "packet_table": examples.packet_table,
    "overview": guides.overview,
    "streamed": guides.streamed,
    "guide_programs": guides.programs,
    "rates": guides.rates,
    "doubts": guides.doubts,
    "sent": guides.sent,
    "answered": guides.answered,
    "come": guides.come,
    "changes": guides.changes,
    "meanings": guides.meanings,
    "refused": guides.refused,
    "added": guides.added,
    "fact_table": guides.fact_table,
    "see": guides.named,
    "start_program": lambda page, x: x.text(page.model),
    "guides_with": guides.with_field,
}


def filters(model: m.Model) -> Mapping[str, Callable[..., Any]]:
    return {**FILTERS, **{name: _of_page(function) for name, function in FILTERS_OF_PAGE.items()}}


def _of_page(function: Callable[..., Any]) -> Callable[..., Any]:
    @pass_context
    def on_page(context: Context, *arguments: Any) -> Any:
        return function(context["page"], *arguments)

    return on_page


TARGET = Target(
    title="Reference manual in Markdown, a site with MkDocs",
    files=files,
    filters=filters,
    identifiers=identifiers,
    rename=package.in_source,
    slow=True,
)
