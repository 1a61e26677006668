"""Every set, command, type, device, erratum, unit and frame has its place in the reference."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec, extent
from reference import (
    ANCHOR,
    Manual,
    bullets,
    cells,
    family,
    heading,
    limited,
    manual_of,
    number,
    path_of,
    prose,
    rows_of,
    seen,
    table_with,
    tables,
    words,
)
from support import model


def asked(s: m.Set, of: m.Model) -> list[m.Field]:
    return [f for f in of.fields_in(s) if f.role != m.RESPONSE]


def letters(functions: tuple[m.Function, ...]) -> str:
    return "".join(x.letter for x in functions)


# --------------------------------------------------------------------------- contents and sets


def test_contents(manual: Manual) -> None:
    of = manual.model
    for path in ("README.md", "docs/index.md"):
        rows = rows_of(manual.pages[path])
        for s in of.sets:
            assert [f"0x{s.number:02X}", s.title, str(len(asked(s, of))), prose(s.description, of)] in rows, s.name
        for d in of.devices:
            row = [d.title, *d.also, str(d.model_number or "")]
            if not d.certain and d.incomplete:
                found = [
                    line
                    for line in bullets(manual.pages[path])
                    if re.search(rf"[ ,]{re.escape(d.title)}[ ,(]|{re.escape(d.title)}$", line)
                ]
                assert found and all(part in found[0] for part in row), d.id
                continue
            row = [d.title, ", ".join(d.also), str(d.model_number or ""), str(len(d.certain))]
            row += [str(len(d.probable))] * bool(d.incomplete) + [prose(d.description, of)]
            assert [cell for cell in row if cell] in [[cell for cell in found if cell] for found in rows], d.id
        for x in of.protocol.manuals:
            errata = sum(e.manual == x.id for e in of.errata)
            examples = sum(e.manual == x.id for e in of.examples)
            lengths = seen(describe.lengths(x, of))
            assert [x.id, x.title, x.document, lengths, str(errata), str(examples)] in rows, x.id


def test_every_set_has_its_page(manual: Manual) -> None:
    for s in manual.model.sets:
        page, fields = manual.page(f"sets/{s.name}.md"), asked(s, manual.model)
        assert page.startswith(f"# {heading(s)}\n")
        assert prose(s.description, manual.model) in words(page)
        assert [line for line in bullets(page.partition("\n## ")[0]) if "hanged by" in line] == [
            seen(x.sentence) for x in describe.changed(s, manual.model)
        ]
        assert ("\n## Contents\n" in page) == bool(fields)
        known, _, others = page.partition("\n## Contents\n")[2].partition("\n### On no known device\n")
        listed = {
            f.full_name
            for f in fields
            for c in (True, False)
            if manual.model.devices_of(f, c, s.number) or not manual.model.devices
        }
        contents = table_with(known, "Descriptor") + table_with(others.partition("\n## ")[0], "Descriptor")
        assert len(contents) == len(fields)
        assert len(table_with(known, "Descriptor")) == len(listed)
        fields = sorted(fields, key=lambda f: f.full_name not in listed)
        for f, row in zip(fields, contents, strict=True):
            marks = [word for word, holds in (("advanced", f.advanced), ("deprecated", f.deprecated)) if holds]
            cells = {key: words(value) for key, value in row.items()}
            assert cells["Descriptor"] == f"0x{f.descriptor:02X}" and f"../{path_of(f)}#{f.full_name})" in row["Field"]
            assert cells["Field"] == f.title + (f" ({', '.join(marks)})" if marks else "")
            assert cells.get("Functions", "") == letters(f.functions)
            assert re.findall(r"#([\w.]+)", row.get("Responses", "")) == [f"{f.family}.{name}" for name in f.responses]
            short = sizes(f)
            assert cells["Field length"] == (f"{short[0]} to {short[1]}" if short[0] != short[1] else f"{short[0]}")
            assert cells["Description"] and prose(f.description, manual.model).startswith(cells["Description"])
            assert cells.get("Supported by", "") == ", ".join(
                d.title for d in manual.model.devices_of(f, number=s.number)
            )


def test_responses_are_with_their_command(manual: Manual) -> None:
    for command in (f for f in manual.model.fields if f.role == m.COMMAND):
        page = manual.page(path_of(command))
        at = {a: page.index(f'<a id="{a}"></a>') for a in ANCHOR.findall(page)}
        for response in manual.model.responses(command):
            if response.command == command.name:
                assert page.index("\n## Packets\n") < at[response.full_name] < page.index("\n## Programs\n")
            else:
                assert f"#{response.full_name})" in manual.field(command)
                assert f"#{command.full_name})" in manual.field(response)


def test_replies(manual: Manual) -> None:
    """A packet for each way in which a command may be answered: acknowledged, with a response, or rejected."""
    of = manual.model
    ok, first = of.protocol.ack_code.values[:2]
    for f in (f for f in of.fields if f.role == m.COMMAND):
        page = manual.page(path_of(f))
        answered = not f.functions or any(x.reply for x in f.functions)
        assert answered == ("The device does not reply." not in page), f.full_name
        found = re.findall(r"^(Acknowledged|Rejected)(.*?): `([0-9A-F ]+)`\.", page.replace(". Rej", ".\nRej"), re.M)
        packets = {(kind, tuple(codec.split(of, bytes.fromhex(data)))) for kind, _, data in found}
        rejected = [fields for kind, fields in packets if kind == "Rejected"]
        assert rejected == [((0xF1, bytes([f.descriptor, first.value])),)] * answered, f.full_name
        assert not answered or f"such as `{first.name}` (0x{first.value:02X})" in page
        plain = [fields for kind, fields in packets if kind == "Acknowledged" and len(fields) == 1]
        assert all(fields == ((0xF1, bytes([f.descriptor, ok.value])),) for fields in plain)
        others = [what for kind, what, _ in found if kind == "Acknowledged" and "[" in what]
        seen = {r.full_name for r in of.responses(f) if r.command == f.name}
        assert {re.findall(r"#([\w.]+)", what)[0] for what in others} | seen == {r.full_name for r in of.responses(f)}
        assert plain or others or seen or not answered, f.full_name


RULER = re.compile(r"`75 65` [^;\n]*?`[0-9A-F]{2} [0-9A-F]{2}`(?=[;.])")


def test_packets_byte_by_byte(manual: Manual) -> None:
    """Each byte of a packet that has the field; those of a parameter lead to its row, where its value is."""
    for f in manual.model.fields:
        section = manual.field(f)
        if not f.parameters and f.role == m.COMMAND:
            continue
        (ruler,) = RULER.findall(section)
        *before, (descriptor, data) = codec.split(manual.model, bytes.fromhex(words(ruler)))
        assert descriptor == f.descriptor and len(before) == (f.role == m.RESPONSE), f.full_name
        values, trailing = codec.decode(f, data)
        assert trailing == 0
        linked = [(x, bytes.fromhex(words(b))) for b, x in re.findall(r"\[(`[0-9A-F ]+`)\]\(#([\w.]+)\)", ruler)]
        linked = [(anchor, part) for anchor, part in linked if anchor.startswith(f"{f.full_name}.")]
        assert b"".join(part for _, part in linked) == data, f.full_name
        anchors = ANCHOR.findall(section)
        assert all(anchor in anchors for anchor, _ in linked), f.full_name
        named = [row for row in table_with(section, "Offset", "Name") if "<a" in row["Name"]]
        rows = {ANCHOR.findall(row["Name"])[0]: row for row in named}
        for p in f.parameters:
            value, row = values.get(p.name), rows.get(f"{f.full_name}.{p.name}")
            if row and isinstance(value, int) and not isinstance(value, bool):
                said = words(row["Example"])
                assert re.search(rf"(?<!\w)-?{abs(value)}\b|0x0*{value:X}\b", said), (f.full_name, p.name, said)


def test_where_the_specification_says_it(manual: Manual) -> None:
    for f in (f for f in manual.model.fields if f.role != m.RESPONSE):
        assert f.position is not None
        said = f" In the specification: {'/'.join(f.position.file.split('/')[-2:])}, name: {f.name}\n"
        assert words(manual.page(path_of(f))).endswith(said)


def test_descriptors_without_a_layout(manual: Manual) -> None:
    for s in manual.model.sets:
        rows = rows_of(manual.page(f"sets/{s.name}.md").partition("\n## Descriptors without a layout\n")[2])
        for x in family(s, manual.model).named:
            role = [x.role] if s.kind == "command" else []
            cited = "; ".join(f"{c.manual}: {c.section}" for c in x.sources)
            assert [f"0x{x.descriptor:02X}", x.title, f"{s.name}.{x.name}", *role, cited] in rows, x.name


def test_what_is_uncertain_of_sets_and_types(manual: Manual) -> None:
    """For fields, parameters, values and bits, this is among their facts."""
    of = manual.model
    pages: list[tuple[str, list[m.Family | m.Set | m.Type]]] = [(manual.type(t), [t]) for t in of.all_types]
    for x in of.families:
        several = len(x.sets) > 1
        pages += [(manual.page(f"sets/{s.name}.md"), [x, s] if several else [x]) for s in x.sets]
    for text, things in pages:
        said = [seen(f.sentence) for thing in things for f in describe.uncertain(thing, of)]
        found = [b for b in bullets(text.partition("\n## Contents")[0]) if b.startswith("Uncertain: ")]
        assert found == said, things[-1].name


# --------------------------------------------------------------------------- forms of commands


def test_every_form_of_a_command_has_its_row(manual: Manual) -> None:
    """A packet, what it must have, its length, and how it is answered."""
    for f in (f for f in manual.model.fields if f.role == m.COMMAND):
        rows = table_with(manual.field(f), "Packet", "Reply")
        for c, row in zip(f.calls, rows, strict=True):
            cells = {key: words(value) for key, value in row.items()}
            if c.function:
                assert cells["Function"] == f"{c.function.name} ({c.function.letter}, 0x{c.function.value:02X})"
            assert cells.get("Required parameters", "") == ", ".join(p.name for p in c.required)
            assert cells.get("Optional parameters", "") == ", ".join(p.name for p in c.optional)
            check_answer(manual, f, c, row["Reply"])
            if not any(x is c for x in manual.samples.sent(f)):
                assert cells["Packet"] == "no device is known to accept it"
                continue
            packet = bytes.fromhex(cells["Packet"])
            ((descriptor, data),) = codec.split(manual.model, packet)
            values, trailing = codec.decode(f, data)
            assert (packet[2], descriptor, trailing) == (f.set, f.descriptor, 0)
            assert values.get("function") == (c.function.value if c.function else None)
            assert not cells["Field length"].isdigit() or int(cells["Field length"]) == len(data) + 2
            assert list(values) == [
                p.name for p in f.parameters if p.selector or (p in c.required and p.constant is None)
            ]


def sizes(f: m.Field) -> tuple[int, int]:
    """The lengths of the shortest form of a field and of the longest."""
    if f.role != m.COMMAND:
        return f.min_size + 2, f.max_size + 2
    shortest = min(sum(least(p) for p in f.parameters if p in f.always or p in c.required) for c in f.calls)
    return shortest + 2, f.max_size + 2


def least(p: m.Parameter) -> int:
    if p.open:
        return 0
    if p.cases:
        return min(extent.size(c.parameter)[0] if c.parameter else 0 for c in p.cases)
    return extent.size(p)[0]


def check_answer(manual: Manual, f: m.Field, c: m.Call, answer: str) -> None:
    acknowledge = "acknowledge or none" if f.silent_when or f.silenced_by else "acknowledge"
    asks = c.function is None or c.function.responds
    responses = [f"{r.title} {number(r)}" for r in manual.model.responses(f)] if asks else []
    wanted = ", ".join([acknowledge, *([" or ".join(responses)] if responses else [])])
    assert words(answer) == ("none" if c.function and not c.function.reply else wanted), f.full_name
    assert re.findall(r"#([\w.]+)", answer) == ([f"{f.family}.{r}" for r in f.responses] if responses else [])


def test_packets(manual: Manual) -> None:
    """The page on packets: frame, checksum, acknowledges, function selectors."""
    protocol, page = manual.model.protocol, manual.page("packets.md")
    assert f"`{bytes(protocol.sync).hex(' ').upper()}`" in page and f"0 to {protocol.max_payload}:" in page
    steps = [[int(c, 16) for c in row] for row in rows_of(page.partition("For example:")[2].partition("\n## ")[0])[2:]]
    packet = bytes(step[0] for step in steps)
    assert [bytes(step[1:]) for step in steps] == [codec.checksum(packet[: i + 1]) for i in range(len(packet))]
    end = re.search(r"The packet ends with `([0-9A-F ]+)`", page)
    assert end and codec.split(manual.model, packet + bytes.fromhex(end[1]))
    for d in (d for d in manual.model.devices if d.ack_codes):
        assert f"{d.title} sends the codes {', '.join(map(str, d.ack_codes))}." in bullets(page)
    rows = rows_of(manual.section("packets.md", "protocol.function_selector"))
    for x in protocol.functions:
        answer = "none" if not x.reply else "acknowledge and response" if x.responds else "acknowledge"
        assert [str(x.value), x.letter, x.name, prose(x.description, manual.model), answer] in rows


# --------------------------------------------------------------------------- types


def test_every_type_has_its_section(manual: Manual) -> None:
    for t in manual.model.all_types:
        section = manual.type(t)
        seen_ = words(section)
        assert f"## {t.name}\n" in seen_ and prose(t.description, manual.model) in seen_, t.name
        if isinstance(t, m.Vector):
            assert [row[1] for row in rows_of(section)[2:]] == list(t.elements)
        for cited in describe.sources(t) if not isinstance(t, m.Vector) else ():
            assert cited in bullets(section), t.name


def test_every_type_names_its_users(manual: Manual) -> None:
    for f in manual.fields:
        for p in f.parameters:
            for t in (p.element, *(v.type for v in p.readings)):
                if isinstance(t, (m.Enum, m.Bitfield, m.Struct)) and not p.selector:
                    assert f"#{f.full_name})" in manual.type(t).partition("Used by ")[2], f"{f.full_name}.{p.name}"


# --------------------------------------------------------------------------- devices


def test_nothing_is_ready_to_be_sent_that_no_device_takes(manual: Manual) -> None:
    for f in (f for f in manual.model.fields if f.role == m.COMMAND and f.functions):
        taken = {x.name for _, s in manual.model.supports(f) for x in s.functions} or {x.name for x in f.functions}
        rows = [row for row in table_with(manual.field(f), "Packet", "Function") if row["Packet"].startswith("`")]
        assert {words(row["Function"]).partition(" ")[0] for row in rows} == taken, f.full_name


def test_every_device_has_its_page(manual: Manual) -> None:
    of = manual.model
    for d in of.devices:
        page = manual.page(f"devices/{d.id}.md")
        text, rows = words(page), rows_of(page)
        assert page.startswith(f"# {d.title}\n") and prose(d.description, of) in text
        assert [d.ack_codes] * bool(d.ack_codes) == [
            tuple(map(int, row[1].partition(" (")[0].split(", "))) for row in rows if row[0] == "Acknowledge codes"
        ]
        facts = describe.device(d, of)
        assert [seen(x.sentence) for x in describe.topics(facts, "incomplete", "uncertain")] == [
            b for b in bullets(page) if b.startswith(("This profile is incomplete: ", "Uncertain: "))
        ]
        properties = {row[0]: row[1] for row in rows if len(row) == 2}
        assert properties.get("Also called", "") == ", ".join(d.also)
        assert properties.get("Generation") == (str(d.generation) if d.generation is not None else None)
        assert properties.get("Similar to") == (of.device(d.like).title if d.like else None)  # type: ignore[union-attr]
        assert (properties["Manual"] == "none known") == (d.manual is None)
        assert properties.get("Sources", "") == "; ".join(describe.sources(d))
        for port in d.ports:
            later = {f.protocol: f" (firmware {f.versions})" for f in port.firmware}
            receives, sends = (", ".join(x + later.get(x, "") for x in names) for names in (port.receives, port.sends))
            wanted = {port.name, ", ".join(map(str, port.baud_rates)), receives, sends}
            wanted |= {f"0x{port.id:02X}"} if port.id is not None else set()
            assert any(wanted <= {*row, ""} for row in rows), port.name
        for limit in d.limits:
            assert [prose(limit.description.rstrip("."), of), limit.name, limited(limit)] in rows
        for note in d.notes:
            assert f"### {note.title}" in text and prose(note.description, of) in text
            for line in note.rows:
                assert any(found[: len(line)] == list(line) for found in rows), note.name


def test_what_a_device_supports(manual: Manual) -> None:
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md").partition("\n## Supported fields\n")[2].partition("\n## ")[0]
        rows = [row for t in tables(page) for row in t]
        assert len(rows) == len(d.certain)
        for s, row in zip(d.certain, rows, strict=True):
            assert f"#{s.field.full_name})" in row["Field"] and words(row["Field"]).startswith(s.field.title)
            assert words(row.get("Functions", "")) == letters(s.functions)
            answers = manual.model.answers(s.field, d.id) if s.responds else ()
            assert re.findall(r"#([\w.]+)\)", row.get("Responses", "")) == [r.full_name for r in answers]
            assert f"(../../devices/{d.id}.md)" in manual.field(s.field)


@pytest.mark.parametrize(
    ("heading_", "wanted_of"),
    [
        ("Fields probably supported", lambda d: [s for s in d.supports if not s.certain]),
        ("Fields not supported", lambda d: d.refuses),
    ],
)
def test_what_a_device_probably_supports_or_refuses(
    manual: Manual, heading_: str, wanted_of: Callable[[m.Device], list[m.Support]]
) -> None:
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md").partition(f"\n## {heading_}\n")[2].partition("\n## ")[0]
        wanted = wanted_of(d)
        rows = [row for t in tables(page) for row in t]
        assert len(rows) == len(wanted)
        for s in wanted:
            of = manual.model.set(s.set)
            assert of is not None
            (line,) = [x for x in page.splitlines() if f"(../sets/{of.name}.md)" in x and f"#{s.field.full_name})" in x]
            assert words(cells(line)[0]) == heading(of)
            before = page[: page.index(line)].strip().split("\n\n")
            why = words(next(x for x in before[::-1] if x[0] != "|"))
            assert why == seen(describe.evidence(s.evidence, manual.model))
            assert f"(../../devices/{d.id}.md)" in manual.field(s.field)


def test_what_differs_on_a_device(manual: Manual) -> None:
    for d in manual.model.devices:
        rows = rows_of(manual.page(f"devices/{d.id}.md"))
        functions = [s for s in d.supports if s.differs]
        wanted = [
            [f"{s.field.title} {number(s.field)}", letters(s.functions), letters(s.field.functions)] for s in functions
        ]
        assert [row for row in rows if row[0] == "Command"][:1] == (
            [["Command", "Functions on this device", "All functions"]] if wanted else []
        )
        assert all(row in rows for row in wanted)
        for v in d.variants:
            said = describe.difference(v.variant, v.parameter, v.field, manual.model)
            assert [f"{v.field.title} {number(v.field)}", v.parameter.name, seen(said)] in rows, v.path
        for s in (s for s in d.supports if s.deprecated):
            assert [f"{s.field.title} {number(s.field)}", prose(s.deprecated or "", manual.model)] in rows


def test_base_rates(manual: Manual) -> None:
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md")
        for r in d.base_rates:
            shown = f"{r.hertz:g} Hz" if r.hertz else "sent as it arrives"
            of_set = heading(r.set)
            assert [of_set, shown] in rows_of(page)
            listed = any(s.set == r.set.number for s in d.certain)  # a poorly known device may have none
            assert (f"### {of_set}\n\nBase rate: {shown}.\n" in words(page)) == listed
            assert [d.title, shown] in rows_of(manual.page(f"sets/{r.set.name}.md"))


# --------------------------------------------------------------------------- errata, units


def test_every_erratum_has_its_section(manual: Manual) -> None:
    """On the page of its manual and severity, which the list of all leads to."""
    of, lists = manual.model, manual.page("errata.md")
    for e in of.errata:
        path = f"errata/{e.manual}/{e.severity}.md"
        section = manual.section(path, f"erratum.{e.id}")
        text = words(section)
        assert f"## {e.id}\n" in text and bullets(section)[0] == f"Section: {e.section}", e.id
        listed = [
            f"{key}: {prose(value, of)}"
            for key, value in (("Published", e.printed), ("Correct", e.right), ("Reason", e.reason))
        ]
        assert bullets(section)[1:4] == listed, e.id
        title = next(x.title for x in of.protocol.manuals if x.id == e.manual)
        count = sum((x.manual, x.severity) == (e.manual, e.severity) for x in of.errata)
        assert [title, e.severity.capitalize(), str(count)] in rows_of(lists) and f"]({path})" in lists
        assert re.search(rf"^Mistakes .*, in {re.escape(title)}\.", words(manual.page(path)), re.M)
        for c in e.claims:
            if c.kind == "length":
                f = of.field(c.subject)
                assert f is not None and f"#{c.subject})" in section and f"#erratum.{e.id})" in manual.field(f)
            elif c.kind == "example":
                assert f"#example.{c.subject})" in section
                shown = next(x for x in of.examples if x.id == c.subject)
                assert f"#erratum.{e.id})" in manual.example(shown)
            else:
                assert c.subject in text


def test_errata_that_name_a_field(manual: Manual) -> None:
    """Its page links to them, whatever section of the manual they are in."""
    for e in manual.model.errata:
        for name in re.findall(r"`([^`]+)`", f"{e.right} {e.reason}"):
            f = manual.model.field(name)
            if f is not None and f.set and f.role != m.RESPONSE:
                assert f"#erratum.{e.id})" in manual.page(path_of(f)), (e.id, name)


def test_mean_motion_is_wrong_for_all_systems() -> None:
    for name in ("gnss_1.galileo_ephemeris", "gnss_1.beidou_ephemeris", "gnss_2.galileo_ephemeris"):
        f = model("real").field(name)
        assert f is not None
        assert "#erratum.cv7-ephemeris-delta-mean-motion)" in manual_of("real").page(path_of(f))


def test_every_unit_and_frame_has_its_row(manual: Manual) -> None:
    rows, of = rows_of(manual.page("units.md")), manual.model
    for word in of.protocol.units:
        assert [word.symbol, word.title, prose(word.description, of)] in rows
    for word in of.protocol.frames:
        axes = ", ".join(word.axes).replace("_", " ")
        assert [word.symbol, word.title, axes, prose(word.origin, of), prose(word.description, of)] in rows
        for c in word.conversions:
            axes, values = ", ".join(c.axes).replace("_", " "), ", ".join(c.values)
            assert [word.symbol, c.title, axes, values, prose(c.description, of)] in rows


def test_vectors_become_those_of_other_software() -> None:
    """As REP-103 has them: x forward and z up, in a world whose x points east."""
    frames = {f.symbol: {c.name: c.values for c in f.conversions} for f in model("real").protocol.frames}
    assert frames["vehicle"] == frames["sensor"] == {"rep_103": ("x", "-y", "-z")}
    assert frames["ned"] == {"enu": ("y", "x", "-z")}


def test_frames_are_drawn(manual: Manual) -> None:
    """Each axis of each frame with its direction, and what the image shows in words."""
    page = manual.page("units.md")
    shown = dict(re.findall(r"!\[([^\]]*)\]\(assets/frames/([^)]+)\.svg\)", page))
    for frame in manual.model.protocol.frames:
        for title, axes in [(frame.title, frame.axes), *((c.title, c.axes) for c in frame.conversions)]:
            if axes:
                words = [axis.replace("_", " ") for axis in axes]
                name = shown[f"{title}: " + ", ".join(f"{x} {word}" for x, word in zip("xyz", words, strict=True))]
                drawing = manual.files[f"docs/assets/frames/{name}.svg"].decode()
                assert re.findall(r"<tspan[^>]*>(\w)</tspan> ([\w ]+)</text>", drawing) == [*zip("xyz", words)]
