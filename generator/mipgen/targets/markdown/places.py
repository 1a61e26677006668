"""Locations in the reference: pages, anchors, labels and links."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache

from mipgen import model as m
from mipgen.facts import describe
from mipgen.facts.describe import Ref
from mipgen.model.guides import Guide

from .index import Index
from .snippets import OTHERS
from .text import code, escaped_line, hexadecimal, inline, opening
from .tools import Tool

README = "README.md"
INDEX = "docs/index.md"
START = "docs/start.md"
PROGRAMS = "docs/programs.md"
GUIDE_PROGRAMS = "docs/programs/guides.md"
PACKETS = "docs/packets.md"
UNITS = "docs/units.md"
TYPES = "docs/types.md"
ERRATA = "docs/errata.md"
EXAMPLES = "docs/examples.md"
#: The pages of the comparison -> their titles; the first one lists all devices.
COMPARISON = {
    "docs/compare/overview.md": "Devices",
    "docs/compare/commands.md": "Commands",
    "docs/compare/data.md": "Data fields",
    "docs/compare/rates.md": "Rates, ports and limits",
    "docs/compare/meanings.md": "Meaning of values",
}

#: Things with a location in the reference; a string is the path of a page, perhaps with an anchor.
Thing = m.Set | m.Family | m.Field | m.Type | m.Device | m.Example | m.Erratum | m.Manual | m.Word | Guide | Tool | str


def field_page(f: m.Field) -> str:
    """Returns the page of a command or a data field; a response is on the page of the command that defines it."""
    return f"docs/fields/{f.family}/{f.command if f.role == m.RESPONSE else f.name}.md"


def programs_page(family: str) -> str:
    """Returns the page of the programs that use the fields of a family."""
    return f"docs/programs/{family}.md"


def on_page(f: m.Field, model: m.Model) -> list[m.Field]:
    """Returns the fields on the page of a command or a data field: the field, and the responses that it defines."""
    return [f, *(r for r in model.responses(f) if r.command == f.name)]


def types_page(owner: str | None) -> str:
    return f"docs/types/{owner}.md" if owner else TYPES


def examples_page(manual: str) -> str:
    """Returns the page of a manual's examples."""
    return f"docs/examples/{manual}.md"


def guide_picture(guide: Guide) -> str:
    return f"docs/assets/guides/{guide.name}.svg"


def place(thing: Thing, model: m.Model) -> tuple[str, str]:
    """Returns the page of a thing, and its anchor on that page."""
    match thing:
        case str():
            page, _, anchor = thing.partition("#")
            return page, anchor
        case m.Set() | Guide() | Tool():
            return f"docs/{type(thing).__name__.lower()}s/{thing.name}.md", ""
        case m.Family():
            return types_page(thing.name), ""
        case m.Device():
            return f"docs/devices/{thing.id}.md", ""
        case m.Field():
            page = PACKETS if thing.family == model.protocol.acknowledge.family else field_page(thing)
            return page, thing.full_name
        case m.Example():
            return examples_page(thing.manual), f"example.{thing.id}"
        case m.Erratum():
            return ERRATA, f"erratum.{thing.id}"
        case m.Manual():
            return INDEX, f"manual.{thing.id}"
        case m.Word():
            kind = "frame" if thing in model.protocol.frames else "unit"
            return UNITS, f"{kind}." + re.sub(r"[^a-z0-9]+", "-", thing.title.lower()).strip("-")
    if thing is model.protocol.function_selector:
        return PACKETS, "protocol.function_selector"
    owner = getattr(thing, "owner", None)
    return types_page(owner), f"{owner or 'types'}.{thing.name}"


def label(thing: Thing) -> str:
    """Returns the label of a thing, as Markdown."""
    match thing:
        case m.Set():
            return escaped_line(f"{thing.title} ({hexadecimal(thing.number)})")
        case m.Family():
            return escaped_line(f"{thing.title} ({', '.join(hexadecimal(s.number) for s in thing.sets)})")
        case m.Field():
            return escaped_line(f"{thing.title} ({descriptors(thing)})")
        case m.Device() | m.Word() | Tool():
            return escaped_line(thing.title)
        case Guide():
            return escaped_line(thing.title[0].upper() + thing.title[1:])
        case m.Example() | m.Erratum() | m.Manual():
            return escaped_line(thing.id)
        case str():
            return escaped_line(thing)
    return code(thing.name)


def descriptors(f: m.Field) -> str:
    """Writes set and descriptor of a field; for a field of several sets, only its descriptor."""
    several = len(f.occurrences) > 1 or not f.set
    return f"{'' if several else hexadecimal(f.set) + ','}{hexadecimal(f.descriptor)}"


def _relative(path: str, page: str) -> str:
    """Returns a path relative to a page."""
    if path == page:
        return ""
    folder, _, name = path.rpartition("/")
    return _up(folder, page.rpartition("/")[0]) + name


@cache
def _up(folder: str, start: str) -> str:
    """Returns the relative path between two folders, with a trailing slash. Cached: it is slow, and there are few."""
    way = posixpath.relpath(folder or ".", start or ".")
    return "" if way == "." else f"{way}/"


@dataclass(frozen=True)
class Page:
    """A page of the reference: links are relative to it."""

    path: str
    index: Index

    @property
    def model(self) -> m.Model:
        return self.index.model

    def anchor(self, thing: Thing) -> str:
        return f'<a id="{place(thing, self.model)[1]}"></a>'

    def url(self, thing: Thing) -> str:
        target, anchor = place(thing, self.model)
        path = _relative(target, self.path)
        return f"{path}#{anchor}" if anchor else path or posixpath.basename(self.path)

    def link(self, thing: Thing, words: str | None = None) -> str:
        """Writes a link to a thing; `words` are Markdown."""
        return f"[{label(thing) if words is None else words}]({self.url(thing)})"

    def picture(self, path: str, words: str) -> str:
        """Writes an image; `words` state what it shows."""
        return f"![{words}]({_relative(path, self.path)})"

    def others(self, path: str, name: str) -> str:
        """Writes links to the listings of a page that have a program in other languages."""
        *first, last = (f"[{x.title}]({self.url(f'{path}#programs.{x.name}')})" for x in OTHERS)
        return f"{code(name)} is also in the listings for {', '.join(first)} and {last}."

    def links(self, things: Iterable[Thing]) -> str:
        return ", ".join(self.link(t) for t in things)

    # ----------------------------------------------------------------------- text of the specification

    def prose(self, text: str) -> str:
        """Writes a text of the specification; references to fields become links."""
        return opening(self.markdown(describe.prose(text, self.model)))

    def quotation(self, text: str) -> str:
        """Writes a quotation of a manual; the descriptors in it become links."""
        return opening(self.markdown(describe.quotation(text, self.model)))

    def sentences(self, facts: Iterable[describe.Fact]) -> list[str]:
        """Writes each fact as a line of its own."""
        return [opening(self.markdown(fact.sentence)) for fact in facts]

    def markdown(self, text: describe.Text, ref: Callable[[Ref], str] | None = None) -> str:
        return describe.say(text, ref or self.ref, inline)

    def ref(self, r: Ref) -> str:
        """Writes a reference of `describe` as Markdown."""
        match r.thing:
            case m.Field():
                return self.link(r.thing, None if r.words == r.thing.full_name else inline(r.words))
            case m.Set() | m.Device() | m.Manual() | m.Word():
                return self.link(r.thing, inline(r.words))
            case m.EnumValue():
                return f"{code(r.words)} ({r.thing.value})"
            case m.Bits() if isinstance(r.within, m.Bitfield):
                return self.link(r.within, code(r.words))
            case m.Enum() | m.Bitfield() | m.Struct():
                return self.link(r.thing)
        return code(r.words)
