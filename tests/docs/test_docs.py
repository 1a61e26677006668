"""The reference manual says all that the model knows, its links lead somewhere, and its bytes are right."""

from __future__ import annotations

import dataclasses
import functools
import html
import importlib
import itertools
import os
import posixpath
import random
import re
import struct
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from mipgen import codec, naming, render
from mipgen import model as m
from mipgen.problems import Problems
from mipgen.resolve import load_model
from mipgen.targets import markdown

ROOT = Path(__file__).parents[2]
SPECS = {"invented": ROOT / "tests/invented/spec", "real": ROOT / "spec"}

ANCHOR = re.compile(r'<a id="([^"]*)"></a>')
LINK = re.compile(r"(?<!\\)\[((?:\\.|`[^`]*`|[^\[\]\\`])*)\]\(([^()\s]*)\)")


# --------------------------------------------------------------------------- reading Markdown


def words(cell: str) -> str:
    """What a reader sees of some Markdown."""
    cell = LINK.sub(r"\1", ANCHOR.sub("", cell))
    parts = re.split(r"`([^`]*)`|<code>(.*?)</code>", cell)
    seen = ""
    for i in range(0, len(parts), 3):
        seen += html.unescape(re.sub(r"\\([!-/:-@\[-`{-~])", r"\1", parts[i]))
        if i + 2 < len(parts):
            seen += parts[i + 1] if parts[i + 1] is not None else html.unescape(parts[i + 2])
    return seen


def prose(text: str) -> str:
    """What a reader should see of a text of the specification: backticks make code."""
    return re.sub(r"`([^`|]+)`", r"\1", " ".join(text.split()))


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


def without_code(text: str) -> str:
    return re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)


@dataclasses.dataclass
class Manual:
    model: m.Model
    files: dict[str, bytes]

    @functools.cached_property
    def pages(self) -> dict[str, str]:
        return {path: data.decode("utf-8") for path, data in self.files.items() if path.endswith(".md")}

    @functools.cached_property
    def sections(self) -> dict[tuple[str, str], str]:
        """(page, anchor) -> what stands from there to the next anchor on a line of its own."""
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
        page = "packets.md" if f.set_name == "protocol" else f"sets/{f.set_name}.md"
        return self.section(page, f.full_name)

    def type(self, t: m.Type) -> str:
        owner = getattr(t, "owner", None)
        return self.section(f"types/{owner}.md" if owner else "types.md", f"{owner or 'types'}.{t.name}")

    @property
    def fields(self) -> list[m.Field]:
        return [*self.model.fields, self.model.protocol.acknowledge]

    @property
    def types(self) -> list[m.Type]:
        return [*self.model.types, *(t for s in self.model.sets for t in s.types)]


@functools.cache
def made(name: str) -> Manual:
    model = load_model(SPECS[name])
    return Manual(model, render.render("markdown", model))


@pytest.fixture(params=SPECS)
def manual(request: pytest.FixtureRequest) -> Manual:
    return made(request.param)


# --------------------------------------------------------------------------- pages


def test_pages_are_neat(manual: Manual) -> None:
    faults = []
    for path, text in manual.pages.items():
        plain = without_code(text)
        if len(re.findall(r"^# ", plain, re.M)) != 1 or not text.startswith("# "):
            faults.append(f"{path}: not one heading of level 1 at its begin")
        levels = [len(x) for x in re.findall(r"^(#+) ", plain, re.M)]
        if any(b > a + 1 for a, b in itertools.pairwise(levels)):
            faults.append(f"{path}: skips a level of headings")
        if re.search(r"^#+ *$", plain, re.M):
            faults.append(f"{path}: an empty heading")
        if "\r" in text or "\n\n\n" in text or re.search(r"[ \t]$", text, re.M) or not text.endswith("\n"):
            faults.append(f"{path}: untidy white space")
    assert not faults


def test_no_placeholders(manual: Manual) -> None:
    bad = re.compile(
        r"\b(TODO|TBD|FIXME|XXX|todo|tbd|lorem)\b|\{\{|\{%|Undefined|mipgen\.|object at 0x|\| None \||`None`|\(\)"
    )
    found = [(path, x[0]) for path, text in manual.pages.items() if (x := bad.search(text))]
    assert not found


def test_tables_are_whole(manual: Manual) -> None:
    faults = []
    for path, text in manual.pages.items():
        for block in re.findall(r"(?:^\|.*\n?)+", text, re.M):
            lines = block.strip().split("\n")
            widths = {len(cells(line)) for line in lines}
            if len(widths) != 1 or not re.fullmatch(r"\|( --- \|)+", lines[1]):
                faults.append(f"{path}: {lines[0]}")
    assert not faults


def test_links_lead_somewhere(manual: Manual) -> None:
    anchors = {path: ANCHOR.findall(text) for path, text in manual.pages.items()}
    faults = [f"{path}: an anchor twice" for path, found in anchors.items() if len(found) != len(set(found))]
    for path, text in manual.pages.items():
        for label, target in LINK.findall(without_code(text)):
            page, _, anchor = target.partition("#")
            to = posixpath.normpath(posixpath.join(posixpath.dirname(path), page)) if page else path
            if to not in anchors or (anchor and anchor not in anchors[to]) or not label:
                faults.append(f"{path}: [{label}]({target})")
            elif path.startswith("docs/") and not to.startswith("docs/"):
                faults.append(f"{path}: [{label}]({target}) leads out of the site")
        if re.search(r"(?<!\\)\]\(", LINK.sub("", without_code(text))):
            faults.append(f"{path}: a link that is none")
        if "://" in text:
            faults.append(f"{path}: an absolute link")
    assert not faults


def test_every_page_can_be_reached(manual: Manual) -> None:
    for start in ("README.md", "docs/index.md"):
        seen, todo = set(), [start]
        while todo:
            path = todo.pop()
            if path in seen:
                continue
            seen.add(path)
            targets = [t.partition("#")[0] for _, t in LINK.findall(without_code(manual.pages[path]))]
            todo += [posixpath.normpath(posixpath.join(posixpath.dirname(path), t)) for t in targets if t]
        assert {p for p in manual.pages if p.startswith("docs/")} <= seen | {"docs/index.md"}


def test_navigation_lists_every_page(manual: Manual) -> None:
    def leaves(entry: Any) -> Iterator[str]:
        if isinstance(entry, str):
            yield entry
        else:
            for child in entry.values() if isinstance(entry, dict) else entry:
                yield from leaves(child)

    listed = list(leaves(yaml.safe_load(manual.files["mkdocs.yml"])["nav"]))
    assert sorted(listed) == sorted(p[5:] for p in manual.pages if p.startswith("docs/"))


def test_anchors_do_not_collide(manual: Manual) -> None:
    problems = Problems()
    naming.collisions("markdown", markdown.identifiers(manual.model), problems)
    assert not problems
    there = {(path, anchor) for path, text in manual.pages.items() for anchor in ANCHOR.findall(text)}
    assert {(i.scope, i.name) for i in markdown.identifiers(manual.model)} <= there


def test_output_is_deterministic() -> None:
    first = render.render("markdown", load_model(SPECS["invented"]))
    assert first == render.render("markdown", load_model(SPECS["invented"])) == made("invented").files


# --------------------------------------------------------------------------- completeness


def test_contents(manual: Manual) -> None:
    for path in ("README.md", "docs/index.md"):
        index = manual.pages[path]
        rows = rows_of(index)
        for s in manual.model.sets:
            assert any(row[0] == f"0x{s.number:02X}" and row[1] == s.title for row in rows), s.name
        for d in manual.model.devices:
            assert any(row[0] == d.title for row in rows), d.id
        for x in manual.model.protocol.manuals:
            assert any(row[:3] == [x.id, x.title, x.document] for row in rows), x.id


def test_every_set_has_its_page(manual: Manual) -> None:
    for s in manual.model.sets:
        page = manual.page(f"sets/{s.name}.md")
        assert page.startswith(f"# {s.title} (0x{s.number:02X})\n")
        assert prose(s.description) in words(page)
        contents = table_with(page.partition("\n## Contents\n")[2], "Descriptor")
        fields = [f for f in s.fields if f.role != m.RESPONSE]
        assert [words(row["Descriptor"]) for row in contents] == [f"0x{f.descriptor:02X}" for f in fields]
        assert all(f"(#{f.full_name})" in "".join(row.values()) for f, row in zip(fields, contents, strict=True))


def test_every_field_has_its_section(manual: Manual) -> None:
    faults = []
    for f in manual.fields:
        section = manual.field(f)
        seen = words(section)
        heading = seen.strip().split("\n")[0]
        number = f"0x{f.descriptor:02X}" if f.set_name == "protocol" else f"(0x{f.set:02X},0x{f.descriptor:02X})"
        level = "### " if f.role == m.RESPONSE and f.set_name != "protocol" else "## "
        said = [f.full_name, prose(f.description), *map(prose, f.notes)]
        said += [f"{f.timeout:g} s"] if f.timeout else []
        said += [f"{f.max_rate:g} Hz"] if f.max_rate else []
        said += [prose(f.deprecated)] if f.deprecated else []
        said += ["Advanced"] if f.advanced else []
        said += [f"Sent if {' and '.join(conditions(f.when))}."] if f.when else []
        said += [f"Not acknowledged if {' and '.join(conditions(f.silent_when))}."] if f.silent_when else []
        if not (heading.startswith(level + f.title) and number in heading):
            faults.append(f"{f.full_name}: heading {heading}")
        faults += [f"{f.full_name}: {text}" for text in said if text not in seen]
        if f.role != m.RESPONSE:
            faults += [
                f"{f.full_name}: {s.section}" for s in f.sources if f"{s.manual}: {prose(s.section)}" not in seen
            ]
    assert not faults


def conditions(found: tuple[m.Condition, ...]) -> list[str]:
    return [f"{c.parameter} is {c.label}" + (f" ({c.value})" if c.label != str(c.value) else "") for c in found]


def test_responses_stand_below_their_command(manual: Manual) -> None:
    for s in manual.model.sets:
        page = manual.page(f"sets/{s.name}.md")
        at = {a: page.index(f'<a id="{a}"></a>') for a in ANCHOR.findall(page)}
        commands = [f for f in s.fields if f.role != m.RESPONSE]
        ends = [at[f.full_name] for f in commands[1:]] + [len(page)]
        for command, end in zip(commands, ends, strict=True):
            for name in command.responses:
                response = next(f for f in s.fields if f.name == name)
                if response.command == command.name:
                    assert at[command.full_name] < at[response.full_name] < end
                else:
                    assert f"(#{response.full_name})" in manual.field(command)
                    assert f"(#{command.full_name})" in manual.field(response)


def test_every_parameter_has_its_row(manual: Manual) -> None:
    faults = []
    for f in manual.fields:
        rows: dict[str, dict[str, str]] = {}
        for row in table_with(manual.field(f), "Offset", "Name"):
            rows.setdefault(words(row["Name"]), row)  # an empty union bears the name of the union
        for p in f.parameters:
            if p.name not in rows:
                faults.append(f"{f.full_name}.{p.name}")
                continue
            row = rows[p.name]
            kind = p.element.name if p.element is not None else "union"
            wants = {
                "Type": kind, "Unit": ", ".join(p.units), "Frame": p.frame or "",
                "Valid if": p.valid_when or "", "Description": prose(p.description),
            }  # fmt: skip
            faults += [f"{f.full_name}.{p.name}: {k}" for k, v in wants.items() if v not in words(row.get(k, ""))]
            for value in (p.minimum, p.maximum):
                if value is not None and str(value).removesuffix(".0") not in row["Range"]:
                    faults.append(f"{f.full_name}.{p.name}: range")
            if (p.default is not None) != bool(row.get("Default")):
                faults.append(f"{f.full_name}.{p.name}: default")
            if p.constant is not None and f"Always {p.constant} " not in row["Description"]:
                faults.append(f"{f.full_name}.{p.name}: constant")
            if f.role == m.COMMAND and p.reserved is not None and f"Send {p.reserved}." not in row["Description"]:
                faults.append(f"{f.full_name}.{p.name}: reserved")
            faults += [
                f"{f.full_name}.{p.name}: {note}" for note in p.notes if prose(note) not in words(manual.field(f))
            ]
            for _, t in p.reading.types if p.reading else ():
                if f".{t.name})" not in manual.field(f):
                    faults.append(f"{f.full_name}.{p.name}: reading {t.name}")
    assert not faults


def test_every_function_has_its_row(manual: Manual) -> None:
    model = manual.model
    for f in model.fields:
        rows = table_with(manual.field(f), "Function", "Then follow") or table_with(manual.field(f), "Function")
        assert [int(row["Value"]) for row in rows] == [x.value for x in f.functions], f.full_name
        for x, row in zip(f.functions, rows, strict=True):
            needed = [p.name for p in f.counted_parameters[: dict(f.required)[x.value]]]
            assert words(row.get("Then follow", "")) == ", ".join(needed)
            assert words(row["Function"]) == f"{x.letter} {x.name}"
            assert words(row["Field begins"]).split()[1:] == [f"{f.descriptor:02X}", f"{x.value:02X}"]
            assert ("none" in row["Answer"]) == (not x.reply)
            assert all((f"(#{f.set_name}.{name})" in row["Answer"]) == x.responds for name in f.responses)
            packet = words(row.get("Whole packet", ""))
            assert bool(packet) == (not needed)
            if packet:
                raw = bytes.fromhex(packet)
                assert raw[2] == f.set
                assert codec.split(model, raw) == [(f.descriptor, bytes([x.value]))]
                assert words(row["Field length"]) == str(raw[4])
            length = words(row["Field length"])
            head = words(row["Field begins"]).split()[0]
            assert head == (f"{int(length):02X}" if length.isdigit() else "LL")
    for x in model.protocol.functions:
        section = manual.section("packets.md", "protocol.function_selector")
        assert [str(x.value), x.letter, x.name, prose(x.description)] in [row[:4] for row in rows_of(section)]


def test_frame_and_checksum(manual: Manual) -> None:
    protocol, page = manual.model.protocol, manual.page("packets.md")
    assert f"`{bytes(protocol.sync).hex(' ').upper()}`" in page and f"0 to {protocol.max_payload}:" in page
    steps = [[int(c, 16) for c in row] for row in rows_of(page.partition("For example:")[2].partition("\n## ")[0])[2:]]
    packet = bytes(step[0] for step in steps)
    assert [bytes(step[1:]) for step in steps] == [codec.checksum(packet[: i + 1]) for i in range(len(packet))]
    end = re.search(r"The packet ends with `([0-9A-F ]+)`", page)
    assert end and codec.split(manual.model, packet + bytes.fromhex(end[1]))
    for d in manual.model.devices:
        assert f"{d.title} sends the codes {', '.join(map(str, d.ack_codes))}." in words(page)


def test_whole_packets_of_commands_without_parameters(manual: Manual) -> None:
    found = 0
    for f in manual.model.fields:
        match = re.search(r"The whole packet: `([0-9A-F ]+)`", manual.field(f))
        assert bool(match) == (f.role == m.COMMAND and all(p.constant is not None for p in f.parameters)), f.full_name
        if match:
            ((descriptor, data),) = codec.split(manual.model, bytes.fromhex(match[1]))
            assert (descriptor, codec.decode(f, data)) == (f.descriptor, ({}, 0))
            found += 1
    assert found


def test_every_type_has_its_section(manual: Manual) -> None:
    faults = []
    for t in manual.types:
        section = manual.type(t)
        rows = rows_of(section)
        where = f"{getattr(t, 'owner', None)}.{t.name}"
        if f"## {t.name}" not in words(section) or prose(t.description) not in words(section):
            faults.append(where)
        if isinstance(t, m.Enum):
            for v in t.values:
                row = next(
                    (r for r in rows if r[:3] == [str(v.value), f"0x{v.value:0{2 * t.scalar.size}X}", v.name]), None
                )
                if row is None or prose(v.description) not in row[-1] or v.deprecated != ("Deprecated." in row[-1]):
                    faults.append(f"{where}.{v.name}")
        elif isinstance(t, m.Bitfield):
            for b in t.bits:
                span = str(b.first) if b.first == b.last else f"{b.first}–{b.last}"
                place = f"0x{b.mask:0{2 * t.size}X}" if t.scalar else f"{b.first // 8}.{b.first % 8}"
                row = next((r for r in rows if r[:3] == [span, place, b.name]), None)
                said = [prose(b.description), f"A value of {b.enum.name}." if b.enum else ""]
                alias = row is not None and "Overlaps other bits." in row[-1]
                if row is None or any(text not in " ".join(row) for text in said) or b.alias != alias:
                    faults.append(f"{where}.{b.name}")
        elif isinstance(t, m.Vector):
            if [r[1] for r in rows[2:]] != list(t.elements):
                faults.append(where)
        else:
            faults += [f"{where}.{p.name}" for p in t.parameters if not any(p.name in r for r in rows)]
    assert not faults


def test_every_type_names_its_users(manual: Manual) -> None:
    for f in manual.fields:
        for p in f.parameters:
            if isinstance(p.element, (m.Enum, m.Bitfield, m.Struct)) and not p.selector:
                assert f"#{f.full_name})" in manual.type(p.element), f"{f.full_name}.{p.name}"


def test_every_device_has_its_page(manual: Manual) -> None:
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md")
        seen, rows = words(page), rows_of(page)
        assert page.startswith(f"# {d.title}\n")
        assert prose(d.description) in seen
        for name in d.fields:
            f = manual.model.field(name)
            assert f is not None
            assert f"(../sets/{f.set_name}.md#{name})" in page, name
            assert f"(../devices/{d.id}.md)" in manual.field(f), name
        fields = {f.full_name for f in manual.model.fields if f.role != m.RESPONSE} - set(d.fields)
        assert not [name for name in fields if f"sets/{name.partition('.')[0]}.md#{name})" in supported(page)]
        for name, letters in d.functions:
            f = manual.model.field(name)
            assert f is not None
            assert any(row[1:] == [letters, "".join(x.letter for x in f.functions)] for row in rows)
            assert f"`{letters}` only" in manual.field(f)
        for name, rate in d.base_rates:
            s = next(s for s in manual.model.sets if s.name == name)
            shown = f"{rate:g} Hz" if rate else "sent as it comes"
            assert [f"{s.title} (0x{s.number:02X})", shown] in rows
            assert [d.title, shown] in rows_of(manual.page(f"sets/{name}.md"))
        for port in d.ports:
            wanted = {port.name, ", ".join(map(str, port.baud_rates)), ", ".join(port.protocols)}
            wanted |= {f"0x{port.id:02X}"} if port.id is not None else set()
            assert any(wanted <= {*row, ""} for row in rows), port.name
        for limit in d.limits:
            value = f"{limit.value:.15g}{' ' + limit.unit if limit.unit else ''}"
            assert [limit.name.replace("_", " "), value, prose(limit.description)] in rows
        for note in d.notes:
            assert f"### {note.title}" in seen and prose(note.description) in seen
            for row in note.rows:
                assert any(found[: len(row)] == [prose(c) for c in row] for found in rows), note.name
        for _, t in d.readings:
            assert f".{t.name})" in page
        assert any(
            row[0] == "Acknowledge codes" and row[1].startswith(", ".join(map(str, d.ack_codes))) for row in rows
        )


def supported(page: str) -> str:
    return page.partition("\n## Supported fields\n")[2].partition("\n## ")[0]


def test_every_erratum_has_its_section(manual: Manual) -> None:
    page = manual.page("errata.md")
    for e in manual.model.errata:
        section = manual.section("errata.md", f"erratum.{e.id}")
        seen = words(section)
        for text in (f"### {e.id}", e.severity.capitalize(), *map(prose, (e.section, e.printed, e.right, e.reason))):
            assert text in seen, e.id
        title = next(x.title for x in manual.model.protocol.manuals if x.id == e.manual)
        before = words(page[: page.index(f'"erratum.{e.id}"')])
        assert re.findall(r"^## (.*)$", before, re.M)[-1] == title
        for c in e.claims:
            if c.kind == "length":
                assert f"#{c.subject})" in section
                f = next(f for f in manual.fields if f.full_name == c.subject)
                assert f"#erratum.{e.id})" in manual.field(f)
            elif c.kind == "example":
                assert f"(examples.md#example.{c.subject})" in section
                assert f"#erratum.{e.id})" in manual.section("examples.md", f"example.{c.subject}")
            else:
                assert c.subject in seen


def test_printed_lengths_that_differ_are_named(manual: Manual) -> None:
    """A fixed field whose printed length is not its length on the wire says so."""
    for f in manual.model.fields:
        for s in f.sources:
            if f.min_size == f.max_size and s.length is not None and s.length.isdigit():
                said = f"prints the length {s.length}," in words(manual.field(f))
                others = [x for x in f.sources if x is not s and x.length == s.length]
                assert said == (int(s.length) != f.max_size + 2) or others, f.full_name


def test_every_unit_and_frame_has_its_row(manual: Manual) -> None:
    rows = rows_of(manual.page("units.md"))
    for word in (*manual.model.protocol.units, *manual.model.protocol.frames):
        assert [word.symbol, word.title, prose(word.description)] in rows


# --------------------------------------------------------------------------- examples


def shown(e: m.Example) -> bytes:
    return e.packet[4:-2] if e.role == "field" else e.packet


def test_every_example_has_its_section(manual: Manual) -> None:
    for e in manual.model.examples:
        section = manual.section("examples.md", f"example.{e.id}")
        seen = words(section)
        (block,) = re.findall(r"^```text\n(.*)\n```$", section, re.M)
        rows = table_with(section, "Bytes", "What")
        assert bytes.fromhex(block) == shown(e)
        assert bytes.fromhex(" ".join(words(row["Bytes"]) for row in rows)) == shown(e), e.id
        assert f"### {e.id}" in seen and prose(e.title) in seen and prose(e.section) in seen and prose(e.note) in seen
        if e.string is not None:
            assert f"Printed to copy: {e.string}" in seen
        if e.table is not None:
            assert f"in a table: {' '.join('??' if b is None else f'{b:02X}' for b in e.table)}" in seen
        check_values(manual.model, e, rows)


def test_examples_stand_with_their_fields(manual: Manual) -> None:
    model = manual.model
    for e in model.examples:
        for x in e.fields:
            about = [x.field] if x.field else []
            if x.field == model.protocol.acknowledge.full_name:
                own = model.set(e.set)
                commands = [f for f in own.fields if f.role == m.COMMAND and f.descriptor == x.data[0]] if own else []
                about = [f.full_name for f in commands]
            for name in about:
                f = model.field(name)
                assert f is not None
                parts = re.split(r"^\*\*Example\*\*", manual.field(f), flags=re.M)
                mine = [part for part in parts if f"#example.{e.id})" in part]
                assert len(mine) == 1, (e.id, name)
                assert " ".join(f"{b:02X}" for b in shown(e)) in mine[0]
                raw = bytes([len(x.data) + 2, x.descriptor]) + x.data
                found = [bytes.fromhex(" ".join(words(row["Bytes"]) for row in t)) for t in tables(mine[0])]
                assert raw in found, (e.id, name)


def flat(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Single values by their paths; lists of numbers stay whole."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from flat(inner, f"{path}.{name}" if path else name)
    elif isinstance(value, list) and value and isinstance(value[0], (dict, list)):
        for i, inner in enumerate(value):
            yield from flat(inner, f"{path}[{i}]")
    else:
        yield path, value


def check_values(model: m.Model, e: m.Example, rows: list[dict[str, str]]) -> None:
    """The decoded values stand in the table, in order."""
    values = [pair for x in e.fields if x.values is not None for pair in flat(x.values, "")]
    at = 0
    for path, value in values:
        if value == [] or value == "" or value == {}:
            continue
        while words(rows[at]["What"]) != path:
            at += 1
            assert at < len(rows), (e.id, path)
        text = words(rows[at]["Value"])
        at += 1
        for one in value if isinstance(value, list) and "0x" not in text else [value]:
            if isinstance(one, int):
                assert re.search(rf"(?<!\w){one}(?!\w)|0x0*{one:X}(?!\w)", text), (e.id, path)
            elif isinstance(one, str) and re.fullmatch(r"0x([0-9a-f]{8}){1,2}", one):
                raw = bytes.fromhex(one[2:])
                form = ">f" if len(raw) == 4 else ">d"
                numbers = re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]\d+)?(?![\w.])", text)
                assert raw in [struct.pack(form, float(n)) for n in numbers] or raw.hex().upper() in text, (e.id, path)


# --------------------------------------------------------------------------- offsets


class Filler:
    """Random values for a record, and the bytes that each of them should become, by path."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.bytes: dict[str, bytes] = {}
        self.counts: dict[str, int] = {}

    def record(self, parameters: tuple[m.Parameter, ...], prefix: str = "") -> dict[str, Any]:
        values: dict[str, Any] = {}
        counters = {p.counts: p.name for p in parameters if p.counts}
        tags = {p.tag for p in parameters if p.tag}
        for p in parameters:
            path = prefix + p.name
            if p.counts or p.name in tags:
                assert isinstance(p.operation, (m.CounterOp, m.ScalarOp))
                value = self.random.randrange(3)
                if p.name in tags:
                    union = next(q for q in parameters if q.tag == p.name)
                    value = self.random.choice(union.cases).tag.value
                else:
                    self.counts[path] = value
                values[p.name] = value
                self.bytes[path] = value.to_bytes(p.operation.size, "big")
            elif p.constant is not None:
                assert isinstance(p.operation, m.ConstantOp)
                self.bytes[path] = p.constant.to_bytes(p.operation.size, "big")
            elif p.tag:
                case = next(c for c in p.cases if c.tag.value == values[p.tag])
                q = case.parameter
                values[p.name] = {q.name: self.one(q.operation, f"{path}.{q.name}", None)} if q else {}
                self.bytes[path] = self.bytes[f"{path}.{q.name}"] if q else b""
            else:
                counter = counters.get(p.name)
                values[p.name] = self.one(p.operation, path, values[counter] if counter else None)
        return values

    def one(self, op: m.Operation, path: str, count: int | None) -> Any:
        match op:
            case m.ScalarOp() | m.BitsOp():
                raw = self.random.randbytes(op.size)
                self.bytes[path] = raw
                if isinstance(op, m.BitsOp):
                    return list(raw)
                if op.scalar.kind == "float":
                    return "0x" + raw.hex()
                return int.from_bytes(raw, "big", signed=op.scalar.kind == "signed")
            case m.TextOp():
                n = self.elements(op, count)
                self.bytes[path] = self.random.randbytes(n)
                return self.bytes[path].decode("latin-1")
            case m.ArrayOp():
                n = self.elements(op, count)
                found = [self.one(op.item, f"{path}[{i}]", None) for i in range(n)]
                self.bytes[path] = b"".join(self.bytes.pop(f"{path}[{i}]") for i in range(n))
                return found
            case m.StructOp():
                before = set(self.bytes)
                found_ = self.record(op.struct.parameters, f"{path}.")
                new = [k for k in self.bytes if k not in before]
                inner = [f"{path}.{p.name}" for p in op.struct.parameters]
                self.bytes[path] = b"".join(self.bytes[k] for k in new if k in inner)
                return found_
        raise AssertionError(op)

    def elements(self, op: m.TextOp | m.ArrayOp, count: int | None) -> int:
        if op.count is not None or count is not None:
            return op.count if op.count is not None else int(count or 0)
        self.counts["rest"] = self.random.randrange(3)
        return self.counts["rest"]


def evaluate(expression: str, names: dict[str, int]) -> int:
    """The number that "4 + 3*count" is."""
    total = 0
    for term in expression.split(" + "):
        factor, _, name = term.rpartition("*")
        total += int(factor or 1) * (names[name] if not name.isdigit() else int(name))
    return total


def lengths(text: str, names: dict[str, int]) -> set[int]:
    """The numbers that "5, 7 or 10 + 3*count" are; those whose counters are not there are left out."""
    found = re.split(r", | or ", text)
    return {evaluate(x, names) for x in found if set(re.findall(r"[a-z_][\w.]*", x)) <= names.keys()}


def indexed(path: str) -> tuple[str, dict[str, int]]:
    """
    >>> indexed("a[2].b[1].c")
    ('a[i].b[j].c', {'i': 2, 'j': 1})
    """
    names: dict[str, int] = {}

    def letter(match: re.Match[str]) -> str:
        name = "ijklmn"[len(names)]
        names[name] = int(match[1])
        return f"[{name}]"

    return re.sub(r"\[(\d+)\]", letter, path), names


def test_offsets_are_those_of_the_bytes(manual: Manual) -> None:
    """Random values of every field are encoded; what stands at each documented offset is that value."""
    for f in manual.fields:
        rows = [(words(r["Name"]), r) for r in table_with(manual.field(f), "Offset", "Name")]
        unseen = {name for name, _ in rows}
        for seed in range(200):
            filler = Filler(seed)
            values = filler.record(f.parameters)
            if f.functions:
                values["function"] = filler.random.choice(f.functions).value
                filler.bytes["function"] = bytes([values["function"]])
            data = codec.encode(f, values)
            assert len(data) + 2 in documented_lengths(manual, f, values, filler), f.full_name
            for path, raw in filler.bytes.items():
                name, indices = indexed(path)
                row = next((r for n, r in rows if n == name), None)
                assert row is not None, f"{f.full_name}: {name}"
                names = {**filler.counts, **indices}
                offset = evaluate(words(row["Offset"]), names)
                assert data[offset : offset + len(raw)] == raw, f"{f.full_name}: {name}"
                if words(row["Bytes"]) not in ("rest", "by case"):
                    assert evaluate(words(row["Bytes"]), names) == len(raw), f"{f.full_name}: {name}"
                unseen.discard(name)
            if not unseen:
                break
        assert not unseen, f.full_name


def documented_lengths(manual: Manual, f: m.Field, values: dict[str, Any], filler: Filler) -> set[int]:
    """The field lengths that the section gives; for a command with functions, after a look at its shortest form."""
    section = manual.field(f)
    if f.set_name == "protocol":
        return {f.max_size + 2}
    if not f.functions:
        (text,) = re.findall(r"^Field length: (.*?)\.(?: The whole packet: .*)?$", words(section), re.M)
        return lengths(text.replace(" with all optional parameters", ""), filler.counts)
    rows = {int(row["Value"]): row for row in table_with(section, "Function", "Field length")}
    needed = [p.name for p in f.counted_parameters[: dict(f.required)[values["function"]]]]
    short = codec.encode(f, {k: v for k, v in values.items() if k == "function" or k in needed})
    text = words(rows[values["function"]]["Field length"])
    assert len(short) + 2 in lengths(text, filler.counts), f.full_name
    return {len(codec.encode(f, values)) + 2}


# --------------------------------------------------------------------------- text and the site

NASTY = 'a|b <b>x</b> *c* _d_ [e](f) `g` \\h & &amp; $i$ ~~j~~ #k 1. "l"'


def nasty(model: m.Model) -> m.Model:
    """The model with awkward texts in all places where prose stands."""
    fields = [dataclasses.replace(f, description=NASTY, notes=(NASTY,)) for f in model.sets[0].fields]
    sets = (dataclasses.replace(model.sets[0], fields=tuple(fields), description=NASTY), *model.sets[1:])
    errata = tuple(
        dataclasses.replace(e, printed=NASTY, right=NASTY, reason=NASTY, section=NASTY) for e in model.errata
    )
    note = m.Note("n", NASTY, NASTY, ((NASTY, NASTY), (NASTY,)))
    devices = tuple(dataclasses.replace(d, description=NASTY, notes=(note,)) for d in model.devices)
    return dataclasses.replace(model, sets=sets, errata=errata, devices=devices)


def test_text_is_never_markup() -> None:
    model = nasty(load_model(SPECS["invented"]))
    manual = Manual(model, render.render("markdown", model))
    test_tables_are_whole(manual)
    test_links_lead_somewhere(manual)
    f = model.sets[0].fields[0]
    assert words(manual.field(f)).count(prose(NASTY)) == 2
    markdown_ = importlib.import_module("markdown")  # comes with mkdocs
    for path in (f"sets/{f.set_name}.md", "errata.md", f"devices/{model.devices[0].id}.md"):
        page = markdown_.markdown(manual.page(path), extensions=["tables", "fenced_code"])
        assert not re.search(r"<b>|<em>[cd]</em>|href=\"f\"", page)
        assert prose(NASTY) in html.unescape(re.sub(r"</?code>", "", page)), path


def test_site_builds(manual: Manual, tmp_path: Path) -> None:
    source, site = tmp_path / "markdown", tmp_path / "site"
    render.write(manual.files, source)
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(site)],
        cwd=source, capture_output=True, text=True, env={**os.environ, "NO_MKDOCS_2_WARNING": "1"}, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    for path in manual.pages:
        if path.startswith("docs/"):
            assert (site / path[5:-3]).with_suffix(".html").is_file(), path
    index = (site / "search/search_index.json").read_text("utf-8")
    assert all(f.full_name in index for f in manual.fields)


def test_site_needs_what_is_tested() -> None:
    """The versions that the folder asks for are those that the project pins for its tests."""
    pinned = (ROOT / "templates/markdown/runtime/requirements.txt").read_text("utf-8").split()
    locked = (ROOT / "requirements-dev.txt").read_text("utf-8")
    assert [p.partition("==")[0] for p in pinned] == ["mkdocs", "mkdocs-material"]
    assert all(re.search(rf"^{re.escape(p)} ", locked, re.M) for p in pinned)
