"""The reference manual as its readers see it: Markdown taken apart, and what should be there."""

from __future__ import annotations

import dataclasses
import functools
import html
import re
from collections.abc import Iterator
from typing import Any

import pytest
import yaml
from mipgen import model as m
from mipgen.emit import render
from mipgen.facts import describe
from mipgen.facts.sample_values import SampleValues
from support import generated, heavy, model

#: For tests that take long, as they compile each program or build the site: the real one in `make test-all` only.
real_site = heavy("programs and site of the real reference")
REAL = pytest.param("real", marks=real_site)
small = pytest.mark.parametrize("manual", ["invented", REAL], indirect=True)

ANCHOR = re.compile(r'<a id="([^"]*)"></a>')
LINK = re.compile(r"(?<!\\)!?\[((?:\\.|`[^`]*`|[^\[\]\\`])*)\]\(([^()\s]*)(?: \"[^\"]*\")?\)")


# --------------------------------------------------------------------------- reading Markdown


def words(cell: str) -> str:
    """What a reader sees of some Markdown."""
    cell = LINK.sub(r"\1", ANCHOR.sub("", cell)).replace("**", "")
    parts = re.split(r"`([^`]*)`|<code>(.*?)</code>", cell)
    seen = ""
    for i in range(0, len(parts), 3):
        seen += html.unescape(re.sub(r"\\([!-/:-@\[-`{-~])", r"\1", parts[i]))
        if i + 2 < len(parts):
            seen += parts[i + 1] if parts[i + 1] is not None else html.unescape(parts[i + 2])
    return seen


def cells(line: str) -> list[str]:
    return [c.strip() for c in re.split(r"(?<!\\)\|", line)[1:-1]]


def tables(text: str) -> Iterator[list[dict[str, str]]]:
    """Every table, as rows by their headings."""
    for block in re.findall(r"(?:^\|.*\n?)+", text, re.M):
        head, _, *rows = block.strip().split("\n")
        yield [dict(zip(cells(head), cells(row), strict=True)) for row in rows]


def table_with(text: str, *headings: str) -> list[dict[str, str]]:
    return next((t for t in tables(text) if t and set(headings) <= t[0].keys()), [])


def rows_of(text: str) -> list[list[str]]:
    return [[words(c) for c in cells(line)] for line in text.split("\n") if line.startswith("|")]


def bullets(text: str) -> list[str]:
    return [words(line[2:]) for line in text.split("\n") if line.startswith("- ")]


def without_code(text: str) -> str:
    return re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)


# --------------------------------------------------------------------------- what should be there


def number(f: m.Field) -> str:
    """Its set and its descriptor; where the set is not certain, its descriptor."""
    several = len(f.occurrences) > 1 or not f.set
    return f"(0x{f.descriptor:02X})" if several else f"(0x{f.set:02X},0x{f.descriptor:02X})"


def heading(s: m.Set) -> str:
    return f"{s.title} (0x{s.number:02X})"


def family(s: m.Set, of: m.Model) -> m.Family:
    return next(x for x in of.families if x.name == s.family)


def seen(text: describe.Text, prefix: str = "") -> str:
    """The words that a reader should see for a text of `describe`; `prefix`: the path of the record that it names."""

    def ref(r: describe.Ref) -> str:
        match r.thing:
            case m.Field() if r.words == r.thing.full_name:
                return f"{r.thing.title} {number(r.thing)}"
            case m.EnumValue():
                return f"{r.words} ({r.thing.value})"
            case m.Parameter() | m.Bits():
                return prefix + r.words
        return r.words

    return " ".join(re.sub(r"`([^`|]+)`", r"\1", describe.say(text, ref)).split())


def prose(text: str, of: m.Model) -> str:
    """What a reader should see of a text of the specification: backticks make code, fields have their titles."""
    return seen(describe.prose(text, of))


def limited(limit: m.Limit) -> str:
    """The value of a limit."""
    unit = "bytes" if limit.unit == "byte" and limit.value != 1 else limit.unit or ""
    firmware = f"({describe.firmware(limit.firmware)})" if limit.firmware else ""
    return " ".join(x for x in (f"{limit.value:.15g}", unit, firmware) if x)


@dataclasses.dataclass(frozen=True)
class Place:
    """A parameter in a table: its path, and the record that it belongs to."""

    path: str
    prefix: str  # of its record
    parameter: m.Parameter | None  # None: an empty alternative
    record: m.Record
    case: tuple[m.Case, m.Parameter] | None = None


def places(record: m.Record, prefix: str = "", depth: int = 0) -> Iterator[Place]:
    """All parameters of a record with those of the structures and unions in it."""
    for p in record.parameters:
        yield Place(prefix + p.name, prefix, p, record)
        yield from _inside(p, prefix + p.name, depth)
        for c in p.cases:
            path = f"{prefix}{p.name}.{c.parameter.name}" if c.parameter else prefix + p.name
            yield Place(path, prefix, c.parameter, record, (c, p))
            if c.parameter:
                yield from _inside(c.parameter, path, depth)


def _inside(p: m.Parameter, path: str, depth: int) -> Iterator[Place]:
    if isinstance(p.element, m.Struct):
        index = "" if p.length is None else f"[{'ijklmn'[depth]}]"
        yield from places(p.element, f"{path}{index}.", depth + bool(index))


# --------------------------------------------------------------------------- the manual


def path_of(f: m.Field) -> str:
    """The page of a command or a data field; a response is on that of its command."""
    return f"fields/{f.family}/{f.command if f.role == m.RESPONSE else f.name}.md"


@dataclasses.dataclass
class Manual:
    model: m.Model
    files: dict[str, bytes]

    @functools.cached_property
    def samples(self) -> SampleValues:
        return SampleValues(self.model)

    @functools.cached_property
    def pages(self) -> dict[str, str]:
        return {path: data.decode("utf-8") for path, data in self.files.items() if path.endswith(".md")}

    @functools.cached_property
    def sections(self) -> dict[tuple[str, str], str]:
        """(page, anchor) -> what follows, up to the next anchor on a line of its own."""
        found = {}
        for path, text in self.pages.items():
            parts = re.split(r'^<a id="([^"]*)"></a>$', text, flags=re.M)
            found.update({(path, parts[i]): parts[i + 1] for i in range(1, len(parts), 2)})
        return found

    def page(self, path: str) -> str:
        return self.pages[f"docs/{path}"]

    def section(self, path: str, anchor: str) -> str:
        return self.sections[f"docs/{path}", anchor]

    def field(self, f: m.Field) -> str:
        """The text about a field: its page without its responses; for a response, its section of that page."""
        if f.family == "protocol":
            return self.section("packets.md", f.full_name)
        if f.role == m.RESPONSE:
            return "".join(re.split(r"^(?=## )", self.section(path_of(f), f.full_name), flags=re.M)[:2])
        first, *others = re.split(r'^<a id="[^"]*"></a>\n\n## ', self.page(path_of(f)), flags=re.M)
        after = others[-1].partition("\n## ")[2] if others else ""
        return first.partition(f'<a id="{f.full_name}"></a>')[2] + (f"\n## {after}" if after else "")

    def parameters(self, f: m.Field) -> tuple[str, int]:
        """The section that has the table of its parameters, and by how much its offsets are smaller than there."""
        section = self.field(f)
        if "\nParameters: as in the command" not in section:
            return section, 0
        command = self.model.commands(f)[0]
        return self.field(command), 1 if command.selector else 0

    def example(self, e: m.Example) -> str:
        return self.section(f"examples/{e.manual}.md", f"example.{e.id}")

    def type(self, t: m.Type) -> str:
        owner = getattr(t, "owner", None)
        return self.section(f"types/{owner}.md" if owner else "types.md", f"{owner or 'types'}.{t.name}")

    @property
    def fields(self) -> list[m.Field]:
        return [*self.model.fields, self.model.protocol.acknowledge]


def made(of: m.Model) -> Manual:
    return Manual(of, render.render("markdown", of))


@functools.cache
def manual_of(spec: str) -> Manual:
    return Manual(model(spec), generated("markdown", spec))


def navigation(manual: Manual) -> list[tuple[str, str]]:
    """The title and the path of every page of the site."""

    def leaves(entry: Any) -> Iterator[tuple[str, str]]:
        for child in entry:
            for title, inside in child.items():
                yield from [(title, inside)] if isinstance(inside, str) else leaves(inside)

    return list(leaves(yaml.safe_load(manual.files["mkdocs.yml"])["nav"]))
