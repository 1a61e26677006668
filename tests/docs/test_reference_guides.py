"""The pages of guides: every packet and answer is there; their programs are run with those of fields."""

from __future__ import annotations

import re

from mipgen.lower import codec
from mipgen.model.guides import Guide, Sequence
from mipgen.targets.markdown.snippets import LANGUAGES
from reference import Manual, cells, path_of, prose, tables, words

Play = tuple[str, Guide, Sequence]


def plays(manual: Manual) -> list[Play]:
    """Every sequence, and the name of its program."""
    return [
        (g.name if len(g.sequences) == 1 else f"{g.name}_{i}", g, s)
        for g in manual.model.guides
        for i, s in enumerate(g.sequences, 1)
    ]


def page_of(manual: Manual, guide: Guide) -> str:
    return manual.page(f"guides/{guide.name}.md")


def part_of(manual: Manual, guide: Guide, sequence: Sequence) -> str:
    """The part of the page about one sequence."""
    number = guide.sequences.index(sequence) + 1
    rest = page_of(manual, guide).partition(f'<a id="{guide.name}.{number}"></a>\n\n')[2]
    return rest[:3] + re.split(r"^## ", rest[3:], maxsplit=1, flags=re.M)[0]


def spaced(data: bytes) -> str:
    return data.hex(" ").upper()


# --------------------------------------------------------------------------- pages


def test_the_first_screen_has_the_packets(manual: Manual) -> None:
    for _, guide, sequence in plays(manual):
        part = part_of(manual, guide, sequence)
        rows = next(tables(part))
        assert [row["Step"] for row in rows] == [str(i + 1) for i in range(len(sequence.steps))]
        for row, step in zip(rows, sequence.steps, strict=True):
            sent, answer = words(row["Send"]), words(row["Reply"])
            assert sent in (spaced(step.packet), f"{len(step.packet)} bytes, see the step")
            assert answer in (spaced(step.answer), f"{len(step.answer)} bytes, see the step", "none")
            assert words(row["Command"]).startswith(step.command.title)
        before = page_of(manual, guide).partition(f'<a id="{guide.name}.1"></a>')[0]
        assert len(before.splitlines()) <= 20, f"{guide.name}: the packets are far from the beginning"


def test_every_step_is_told(manual: Manual) -> None:
    for _, guide, sequence in plays(manual):
        blocks = re.findall(r"^```text\n(.*?)\n```$", part_of(manual, guide, sequence), re.M | re.S)
        wanted = []
        for step in sequence.steps:
            wanted += [step.packet, *([step.answer] if step.answer else []), *(d.packet for d in step.data)]
            assert prose(step.why, manual.model) in words(part_of(manual, guide, sequence))
            if step.host:  # in the step, and in the program of each language
                page = part_of(manual, guide, sequence)
                assert len(re.findall(rf"(?://|#|/\*) {re.escape(step.host)}", page)) == len(LANGUAGES)
                assert f"Then {step.host[0].lower()}{step.host[1:]}" in page
        assert blocks == [spaced(w) for w in wanted]
        for packet in wanted:
            codec.split(manual.model, packet)


def test_tables_of_bytes_are_whole(manual: Manual) -> None:
    """The bytes of each table are those of the packet above it."""
    for guide in manual.model.guides:
        text = page_of(manual, guide)
        folded = re.findall(
            r"^```text\n([^`]*?)\n```\n\n<details markdown=\"1\">\n.*?\n\n(.*?)\n\n</details>", text, re.M | re.S
        )
        assert len(folded) == len(re.findall(r"^```text$", text, re.M))
        for packet, rows in folded:
            bytes_ = [words(cells(line)[0]) for line in rows.split("\n")[2:]]
            assert " ".join(bytes_) == packet


def test_the_contents_begin_with_the_guides(manual: Manual) -> None:
    for start in ("README.md", "docs/index.md"):
        section = manual.pages[start].partition("\n## I want to …\n\n")[2].partition("\n\n")[0]
        assert [words(line[2:]) for line in section.split("\n")] == [g.title for g in manual.model.guides]
        assert manual.pages[start].index("\n## I want to …\n") == manual.pages[start].index("\n## ")


def test_a_migration_names_all_that_is_lost(manual: Manual) -> None:
    for guide in manual.model.guides:
        if guide.migration is None:
            continue
        had, has = ({s.field.full_name for s in d.supports} for d in (guide.migration.before, guide.migration.after))
        told = page_of(manual, guide).partition("## Replacement commands")[2].partition("\n## ")[0]
        assert {f"#{name})" for name in had - has} <= set(re.findall(r"#[\w.]+\)", told))


def section(text: str, title: str) -> str:
    return text.partition(f"\n## {title}\n")[2].partition("\n## ")[0]


def test_a_migration_names_what_is_not_the_same(manual: Manual) -> None:
    """Values that have another meaning, those of responses included; functions that are not accepted; all that is
    new."""
    of = manual.model
    for move, guide in ((g.migration, g) for g in of.guides if g.migration is not None):
        page = page_of(manual, guide)
        taken = [
            {s.field.full_name: {x.name for x in s.functions} for s in d.certain} for d in (move.before, move.after)
        ]
        rows = {
            re.findall(r"#([\w.]+)\)", row["Command"])[0]: set(re.findall(r"`(\w+)`", row["Functions"]))
            for t in tables(section(page, "Functions no longer supported"))
            for row in t
        }
        both = taken[0].keys() & taken[1].keys()
        lost = {name: taken[0][name] - taken[1][name] for name in both}
        assert rows == {name: functions for name, functions in lost.items() if functions}
        new = {name for name in taken[1] if name not in {s.field.full_name for s in move.before.supports}}
        assert set(re.findall(r"#([\w.]+)\)", section(page, "New commands and data"))) == new
        told = words(section(page, "Different meanings"))
        for v in (v for d in (move.before, move.after) for v in d.variants):
            if {move.before.id, move.after.id} <= {d.id for d in of.devices_of(v.field)}:
                assert v.parameter.name in told, v.path


def test_rates_and_bandwidth(manual: Manual) -> None:
    """The formula of the manuals: 60 f + 10 (s1 f1 + s2 f2 + ...)."""
    for _, guide, sequence in plays(manual):
        part = words(part_of(manual, guide, sequence))
        baud = 0.0
        for stream in sequence.streams:
            if stream.rate:
                lengths = sum(len(data) + 2 for _, data in codec.split(manual.model, stream.packet))
                baud += 60 * stream.rate + 10 * lengths * stream.rate
                of_set = re.escape(f"The device sends a packet of {stream.set.title} (0x{stream.set.number:02X}) with ")
                assert re.search(rf"{of_set}.* at {stream.rate:g} Hz\.", part)
                for d in sequence.devices:
                    base = next(r.hertz for r in d.base_rates if r.set.name == stream.set.name)
                    assert f"{base} Hz / {stream.rate} Hz = decimation {base / stream.rate:g}" in part
        assert (f"which needs {baud:,.6g} baud." in part) == bool(baud)


def test_fields_name_their_guides(manual: Manual) -> None:
    for _, guide, sequence in plays(manual):
        for f in [s.command for s in sequence.steps] + [x.field for t in sequence.streams for x in t.fields]:
            told = re.findall(r"^- Guides: (.*)$", manual.page(path_of(f)), re.M)
            assert f"guides/{guide.name}.md)" in told[0], f.full_name
