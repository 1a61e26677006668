"""The pages of guides: every packet and answer is there; their programs are run with those of fields. The formulas for
NED, ENU and REP-103, evaluated and compared with rotation matrices."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence as Numbers
from xml.etree import ElementTree

from mipgen.lower import codec
from mipgen.model.guides import Guide, Sequence
from mipgen.targets.markdown.snippets import LANGUAGES
from random_values import chance
from reference import Manual, manual_of, path_of, prose, table_with, tables, words
from rotations import of_euler, of_quaternion, product, times, transposed

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


def test_a_guide_is_short_and_begins_with_its_steps(manual: Manual) -> None:
    for _, guide, sequence in plays(manual):
        steps = re.findall(r"^(\d+)\. \[([^\]]*)\]\([^)]*\): (.*)$", part_of(manual, guide, sequence), re.M)
        assert [int(i) for i, _, _ in steps] == list(range(1, len(sequence.steps) + 1))
        for (_, title, why), step in zip(steps, sequence.steps, strict=True):
            assert words(title).startswith(step.command.title)
            then = f" Then {step.host[0].lower()}{step.host[1:]}" if step.host else ""
            assert words(why) == prose(step.reason, manual.model) + then
        before, _, rest = page_of(manual, guide).partition(f'<a id="{guide.name}.1"></a>')
        assert len(before.splitlines()) <= 20, f"{guide.name}: the steps are far from the beginning"
        assert len((before + rest).splitlines()) <= 400, guide.name


def test_every_byte_of_a_guide(manual: Manual) -> None:
    """Each packet, its reply and the data; those of values lead to their parameters, and state the value."""
    for _, guide, sequence in plays(manual):
        part = part_of(manual, guide, sequence)
        rows = table_with(part, "Step", "Send")
        shown = [re.match(r"([0-9A-F]{2}( |$))*", words(row[x]))[0].strip() for row in rows for x in ("Send", "Reply")]  # type: ignore[index]
        shown += [words(x) for x in re.findall(r"^Data: (.*)$", part, re.M)]
        wanted = [packet for step in sequence.steps for packet in (step.packet, step.answer)]
        wanted += [stream.packet for step in sequence.steps for stream in step.data]
        assert shown == [spaced(packet) for packet in wanted]
        for packet in filter(None, wanted):
            codec.split(manual.model, packet)
        titles = re.findall(r"\]\([^ )]*#([\w.]+) \"([^\"]*)\"\)", part)
        assert all(title.split(":")[0].split("[")[0] in anchor for anchor, title in titles)
        values = [step.values.get("function") for step in sequence.steps if "function" in step.values]
        functions = [title for _, title in titles if title.startswith("function: ")]
        assert [int(re.findall(r"\((\d+)\)", x)[0]) for x in functions] == values


def test_hosts_act_in_the_programs_too(manual: Manual) -> None:
    for _, guide, sequence in plays(manual):
        page = manual.page("programs/guides.md")
        for host in {step.host for step in sequence.steps if step.host}:
            assert len(re.findall(rf"(?://|#|/\*) {re.escape(host)}", page)) % (len(LANGUAGES) - 1) == 0
            assert f"# {host}" in part_of(manual, guide, sequence)


def test_pictures_say_what_they_show(manual: Manual) -> None:
    for guide in (g for g in manual.model.guides if g.picture):
        page, path = page_of(manual, guide), f"assets/guides/{guide.name}.svg"
        assert f"]({'../' + path})" in page and words(guide.picture.shows) in page.replace("\\", "")  # type: ignore[union-attr]
        root = ElementTree.fromstring(manual.files[f"docs/{path}"])
        assert root.tag.endswith("svg") and not [x for x in root.iter() if x.tag.endswith(("script", "image"))]


def test_the_contents_begin_with_the_guides(manual: Manual) -> None:
    for start in ("README.md", "docs/index.md"):
        section = manual.pages[start].partition("\n## Guides\n\n")[2].partition("\n\n")[0]
        titles = [g.title[0].upper() + g.title[1:] for g in manual.model.guides]
        assert [words(line[2:]) for line in section.split("\n")] == titles
        assert manual.pages[start].index("\n## Guides\n") == manual.pages[start].index("\n## ")


def test_a_migration_names_all_that_is_lost(manual: Manual) -> None:
    for guide in manual.model.guides:
        if guide.migration is None:
            continue
        had, has = ({s.field.full_name for s in d.supports} for d in (guide.migration.before, guide.migration.after))
        told = page_of(manual, guide).partition("## Replacement commands")[2].partition("\n## ")[0]
        assert {f"#{name})" for name in had - has} <= set(re.findall(r"#[\w.]+\)", told))
        replacements = [list(row.values())[1] for table in tables(told) for row in table]
        for change, shown in zip(guide.migration.changes, replacements, strict=True):
            assert re.findall(r"#([\w.]+)\)", shown) == [f.full_name for f in change.by]
            assert change.by or shown == "nothing"


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


# --------------------------------------------------------------------------- frames

#: The axes of the other frame in the frame of MIP, as rows: east, north, up in NED; forward, left, up in the vehicle.
ENU = (0, 1, 0, 1, 0, 0, 0, 0, -1)
FLU = (1, 0, 0, 0, -1, 0, 0, 0, -1)


def attitude(roll: float, pitch: float, yaw: float) -> tuple[float, ...]:
    """The matrix from vectors of the vehicle to those of the world."""
    return transposed(of_euler(roll, pitch, yaw))


def quaternion(roll: float, pitch: float, yaw: float) -> tuple[float, ...]:
    """The quaternion from half angles, as devices send it."""
    (a, b, c), (d, e, f) = ([g(angle / 2) for angle in (roll, pitch, yaw)] for g in (math.cos, math.sin))
    return a * b * c + d * e * f, d * b * c - a * e * f, a * e * c + d * b * f, a * b * f - d * e * c


def near(a: Numbers[float], b: Numbers[float]) -> bool:
    return math.dist(a, b) < 1e-11


def evaluated(formula: str, **values: float) -> float:
    """A formula of the page: names, signs, the four operations and pi."""
    assert re.fullmatch(r"[-+*/(). \w]+", formula)
    return float(eval(formula, {"__builtins__": {}}, {"pi": math.pi, "sqrt": math.sqrt, **values}))


def test_formulas_of_the_pages() -> None:
    chances = chance("frames")
    pages = [words(manual_of("real").page(page)) for page in ("guides/axes_and_signs.md", "units.md")]
    quaternions = [re.search(r"becomes \(([^()]*)\) / sqrt\(2\)", page) for page in pages]
    yaws = [re.search(r"yaw becomes (pi/2 - yaw)", page) for page in pages]
    elements = re.search(r"\| ned \|.*?\| (y, x, -z) \|", pages[1])
    body = re.search(r"\| vehicle \|.*?\| (x, -y, -z) \|", pages[1])
    assert all(quaternions) and all(yaws) and elements and body
    assert "east = NED y, north = NED x, up = -NED z" in pages[0] and "x is unchanged, y and z change sign" in pages[0]
    for _ in range(50):
        roll, yaw = (chances.uniform(-math.pi, math.pi) for _ in range(2))
        pitch = chances.uniform(-math.pi / 2, math.pi / 2)
        ned = attitude(roll, pitch, yaw)
        w, x, y, z = quaternion(roll, pitch, yaw)
        assert near(transposed(of_quaternion((w, x, y, z))), ned)
        wanted = product(product(ENU, ned), transposed(FLU))
        for found in quaternions:
            assert found
            made = [evaluated(part, w=w, x=x, y=y, z=z) / math.sqrt(2) for part in found[1].split(",")]
            assert math.isclose(sum(q * q for q in made), 1) and near(transposed(of_quaternion(made)), wanted)
        for found in yaws:
            assert found
            assert near(attitude(roll, -pitch, evaluated(found[1], yaw=yaw)), wanted)
        vector = tuple(chances.uniform(-9, 9) for _ in range(3))
        for found, axes in ((elements, ENU), (body, FLU)):
            made = [evaluated(part, **dict(zip("xyz", vector, strict=True))) for part in found[1].split(",")]
            assert near(made, times(axes, vector))
