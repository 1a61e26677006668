"""Every set, command, type, device, erratum, unit and frame has its place in the reference."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import pytest
from mipgen import model as m
from mipgen.facts import describe
from mipgen.lower import codec, extent
from reference import (
    ANCHOR,
    Manual,
    bullets,
    heading,
    limited,
    number,
    path_of,
    prose,
    rows_of,
    seen,
    table_with,
    tables,
    words,
)


def letters(functions: tuple[m.Function, ...]) -> str:
    return "".join(x.letter for x in functions)


# --------------------------------------------------------------------------- texts, sets, devices, errata


def texts_by_place(manual: Manual) -> Iterator[tuple[str, object]]:
    """The text in which readers look for a thing, and the thing; facts of fields and types have tests of their own."""
    of, protocol = manual.model, manual.model.protocol
    for x in of.families:
        yield from ((manual.page(f"sets/{s.name}.md"), thing) for s in x.sets for thing in (s, s if s.title else x))
    yield from ((manual.type(t), t) for t in of.all_types)
    for d in of.devices:
        things = (d, *d.limits, *d.notes, *(s for s in d.supports if s.deprecated))
        yield from ((manual.page(f"devices/{d.id}.md"), thing) for thing in things)
    yield from ((manual.section("errata.md", f"erratum.{e.id}"), e) for e in of.errata)
    for word in (*protocol.units, *protocol.frames):
        yield from ((manual.page("units.md"), thing) for thing in (word, *word.conversions))
    yield from ((manual.page("packets.md"), thing) for thing in (*protocol.notes, *protocol.functions))
    for g in of.guides:
        yield from ((manual.page(f"guides/{g.name}.md"), thing) for thing in (g, *g.questions))


#: The attributes that are prose; `text` is that of a chapter.
PROSE = (
    "description", "uncertain", "incomplete", "notes", "printed", "right", "reason", "origin", "deprecated", "text",
    "question", "answer", "before",
)  # fmt: skip


def test_every_text_of_the_specification_is_in_its_place(manual: Manual) -> None:
    seen_ = set()
    for place, thing in texts_by_place(manual):
        text = words(place)
        for attribute in PROSE:
            value = getattr(thing, attribute, None) or ()
            for said in (value,) if isinstance(value, str) else value:
                if isinstance(said, str):
                    said = prose(said, manual.model).removesuffix("." if isinstance(thing, m.Limit) else "")
                    assert said in text, (attribute, said)
                    seen_.add(attribute)
        assert not isinstance(thing, m.Limit) or limited(thing) in text
        for cited in () if place == manual.page("units.md") else getattr(thing, "sources", ()):
            assert f"{cited.manual}: {cited.section}" in text
    assert seen_ >= {*PROSE} - {"before"}


def test_every_set_lists_its_fields(manual: Manual) -> None:
    """With their sizes; those that no known device has come last."""
    of = manual.model
    for s in of.sets:
        page = manual.page(f"sets/{s.name}.md")
        known, _, others = page.partition("\n## Contents\n")[2].partition("\n### On no known device\n")
        rows = table_with(known, "Descriptor") + table_with(others.partition("\n## ")[0], "Descriptor")
        fields = [f for f in of.fields_in(s) if f.role != m.RESPONSE]
        fields.sort(key=lambda f: bool(of.devices) and not any(of.devices_of(f, x, s.number) for x in m.SUPPORTED))
        assert len(rows) == len(fields)
        for f, row in zip(fields, rows, strict=True):
            assert f"../{path_of(f)}#{f.full_name})" in row["Field"]
            assert words(row["Descriptor"]) == f"0x{f.descriptor:02X}"
            assert re.findall(r"#([\w.]+)", row.get("Responses", "")) == [f"{f.family}.{name}" for name in f.responses]
            assert words(row["Field length"]) == " to ".join(map(str, dict.fromkeys(sizes(f))))


@pytest.mark.parametrize(
    ("title", "wanted_of"),
    [
        ("Supported fields", lambda d: d.certain),
        ("Likely fields", lambda d: list(d.likely)),
        ("Assumed fields", lambda d: list(d.assumed)),
        ("Fields not supported", lambda d: [x for x in d.refuses if not x.evidence.needs]),
    ],
)
def test_what_a_device_supports_or_refuses(
    manual: Manual, title: str, wanted_of: Callable[[m.Device], list[m.Support]]
) -> None:
    """Each field, its functions there and its responses; where it is not certain, the evidence above its table."""
    of = manual.model
    for d in of.devices:
        page = manual.page(f"devices/{d.id}.md").partition(f"\n## {title}\n")[2].partition("\n## ")[0]
        wanted = wanted_of(d)
        rows = [row for t in tables(page) for row in t] if title == "Supported fields" else []
        listed = [row["Field"] for row in rows] or re.findall(r"^- \[.*", page, re.M)
        assert sorted(re.findall(r"#([\w.]+)\)", "".join(listed))) == sorted(s.field.full_name for s in wanted)
        for s, row in zip(wanted, rows, strict=True) if rows else ():
            assert f"#{s.field.full_name})" in row["Field"] and words(row.get("Functions", "")) == letters(s.functions)
            answers = of.answers(s.field, d.id) if s.responds else ()
            assert re.findall(r"#([\w.]+)\)", row.get("Responses", "")) == [r.full_name for r in answers]
        for s in wanted:
            assert f"(../../devices/{d.id}.md)" in manual.field(s.field)
            assert s.certain or seen(describe.evidence(s.evidence, of)) in words(page)


def test_fields_that_require_hardware_are_in_one_list(manual: Manual) -> None:
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md")
        for x in (x for x in d.refuses if x.evidence.needs):
            anchor = f"requires.{x.evidence.needs.replace(' ', '_')}"
            assert f"(../compare/overview.md#{anchor}), which the device lacks." in page
            assert f"#{x.field.full_name})" in manual.section("compare/overview.md", anchor)
            assert f"(../../devices/{d.id}.md)" in manual.field(x.field)


def test_errata_and_what_they_are_about_lead_to_each_other(manual: Manual) -> None:
    of = manual.model
    for e in of.errata:
        section = manual.section("errata.md", f"erratum.{e.id}")
        for c in e.claims:
            f = of.field(c.subject)
            shown = next((x for x in of.examples if c.kind == "example" and x.id == c.subject), None)
            assert f"#{'example.' if shown else ''}{c.subject})" in section or c.subject in words(section)
            if f is not None and c.kind == "length":
                assert f"#{c.subject})" in section and f"#erratum.{e.id})" in manual.field(f)
            if shown:
                assert f"#erratum.{e.id})" in manual.example(shown)


# --------------------------------------------------------------------------- packets and replies


def test_responses_are_with_their_command(manual: Manual) -> None:
    for command in (f for f in manual.model.fields if f.role == m.COMMAND):
        page = manual.page(path_of(command))
        at = {a: page.index(f'<a id="{a}"></a>') for a in ANCHOR.findall(page)}
        for response in manual.model.responses(command):
            if response.command == command.name:
                assert at[response.full_name] < page.index("\n## Try it\n")
            else:
                assert f"#{response.full_name})" in manual.field(command)
                assert f"#{command.full_name})" in manual.field(response)


def test_replies(manual: Manual) -> None:
    """A packet for each form of a command, acknowledged, with its response if that is short; and what a device without
    the command replies, unless every device has it."""
    of = manual.model
    ok, first = of.protocol.ack_code.values[:2]
    for f in (f for f in of.fields if f.role == m.COMMAND):
        page = manual.field(f)
        layouts = {r.descriptor for r in of.responses(f)}
        for c, row in zip(f.calls, table_with(page, "Send", "Reply"), strict=True):
            for data in re.findall(r"`(75 65 [0-9A-F ]+)`", row["Reply"]):
                acknowledge, *others = codec.split(of, bytes.fromhex(data))
                assert acknowledge == (0xF1, bytes([f.descriptor, ok.value])), f.full_name
                assert {number for number, _ in others} <= layouts and (
                    not others or c.function is None or c.function.responds
                )
        replies = any(c.function is None or c.function.reply for c in f.calls)
        supporting = {d.id for x in m.SUPPORTED for d in of.devices_of(f, x)}
        rejected = re.findall(r"A device without this command replies `([0-9A-F ]+)`: \[`(\w+)`\]", page)
        wanted = replies and len(supporting) < len(of.devices)
        assert len(rejected) == wanted, f.full_name
        for data, name in rejected:
            assert codec.split(of, bytes.fromhex(data)) == [(0xF1, bytes([f.descriptor, first.value]))]
            assert name == first.name


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


# --------------------------------------------------------------------------- forms of commands


def test_every_form_of_a_command_has_its_row(manual: Manual) -> None:
    """A packet, what it must have, its length, and how it is answered."""
    for f in (f for f in manual.model.fields if f.role == m.COMMAND):
        rows = table_with(manual.field(f), "Send", "Reply")
        for c, row in zip(f.calls, rows, strict=True):
            cells = {key: words(value) for key, value in row.items()}
            if c.function:
                assert cells["Function"] == f"{c.function.name} ({c.function.letter}, {c.function.value})"
            check_answer(manual, f, c, row["Reply"])
            if not any(x is c for x in manual.samples.sent(f)):
                assert cells["Send"] == "no device is known to accept it"
                continue
            packet = bytes.fromhex(cells["Send"])
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
    acknowledge = "ACK or none" if f.silent_when or f.silenced_by else "ACK"
    asks = c.function is None or c.function.responds
    responses = [f"{r.title} {number(r)}" for r in manual.model.responses(f)] if asks else []
    wanted = ", ".join([acknowledge, *([" or ".join(responses)] if responses else [])])
    shown = re.sub(r"^75 65 [0-9A-F ]{6,} ", "", words(answer)).partition(": ")[0]
    assert shown == ("none" if c.function and not c.function.reply else wanted), f.full_name
    assert re.findall(r"#([\w.]+)", answer.partition(": ")[0]) == (
        [f"{f.family}.{r}" for r in f.responses] if responses else []
    )


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


# --------------------------------------------------------------------------- devices


def test_nothing_is_ready_to_be_sent_that_no_device_takes(manual: Manual) -> None:
    for f in (f for f in manual.model.fields if f.role == m.COMMAND and f.functions):
        taken = {x.name for _, s in manual.model.supports(f) for x in s.functions} or {x.name for x in f.functions}
        rows = [row for row in table_with(manual.field(f), "Send", "Function") if row["Send"].startswith("`")]
        assert {words(row["Function"]).partition(" ")[0] for row in rows} == taken, f.full_name


def test_base_rates(manual: Manual) -> None:
    for d in manual.model.devices:
        page = manual.page(f"devices/{d.id}.md")
        for r in d.base_rates:
            shown = f"{r.hertz:g} Hz" if r.hertz else "sent as it arrives"
            of_set = heading(r.set)
            assert [of_set, shown] in rows_of(page)
            listed = not d.incomplete and any(s.set == r.set.number for s in d.certain)
            assert (f"### {of_set}\n\nBase rate: {shown}.\n" in words(page)) == listed
            assert [d.title, shown] in rows_of(manual.page(f"sets/{r.set.name}.md"))


# --------------------------------------------------------------------------- errata, units


def test_errata_that_name_a_field(manual: Manual) -> None:
    """Its page links to them, whatever section of the manual they are in."""
    for e in manual.model.errata:
        for name in re.findall(r"`([^`]+)`", f"{e.right} {e.reason}"):
            f = manual.model.field(name)
            if f is not None and f.set and f.role != m.RESPONSE:
                assert f"#erratum.{e.id})" in manual.page(path_of(f)), (e.id, name)


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
