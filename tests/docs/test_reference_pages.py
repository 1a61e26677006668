"""The pages of the reference manual: their form, their links, and what they need to become a site."""

from __future__ import annotations

import collections
import dataclasses
import doctest
import html
import importlib.util
import itertools
import posixpath
import re
import statistics

import pytest
from mipgen import model as m
from mipgen.emit import naming
from mipgen.lower import codec
from mipgen.read.problems import Problems
from mipgen.targets import markdown
from reference import (
    ANCHOR,
    LINK,
    Manual,
    cells,
    made,
    manual_of,
    navigation,
    path_of,
    prose,
    without_code,
    words,
)
from searches import QUESTIONS, TASKS
from support import ROOT, SPECS, model, some


@pytest.fixture(params=sorted(SPECS))
def manual(request: pytest.FixtureRequest) -> Manual:
    """The real pages, too: whether one is broken depends on the words of the specification."""
    return manual_of(request.param)


def test_a_link_to_a_device_has_its_name(manual: Manual) -> None:
    names = {of.id: str(of.title) for of in manual.model.devices}
    found = [
        (path, name, of)
        for path, text in manual.pages.items()
        for name, of in re.findall(r"\[([^\[\]]*)\]\([./\w]*devices/([\w-]+)\.md\)", text)
    ]
    assert {of for _, _, of in found} == names.keys()
    series = {of: "-".join(name.split("-")[:2]) for of, name in names.items()}  # the first of a list has its name
    assert [one for one in found if names[one[2]] not in (one[1], series[one[2]] + one[1])] == []


def test_a_link_to_a_field_has_its_name(manual: Manual) -> None:
    """Its title, perhaps with a descriptor or a function, or its symbol; bytes of a packet may be links, too."""
    fields = {f"{o.set_name}.{f.name}": (f, o.set) for f in manual.model.fields for o in f.occurrences}
    seen: set[str] = set()
    for path, text in manual.pages.items():
        for name, anchor in re.findall(r"\[([^\[\]]*)\]\([^()\s]*#([\w.]+)\)", text):
            if anchor not in fields or not re.search("[^0-9A-Fx, ()]", name.strip("`")):
                continue
            f, set_ = fields[anchor]
            title, _, numbers = name.strip("`").partition(" (0x")
            titles = {str(f.title), anchor, f.name, *(f"{f.title}, {c.function.name}" for c in f.calls if c.function)}
            assert title in titles, (path, name, anchor)
            assert numbers in {"", f"{set_:02X},0x{f.descriptor:02X})", f"{f.descriptor:02X})"}, (path, name, anchor)
            seen.add(anchor)
    assert len(seen) > len(fields) / 2


def test_packets_are_whole(manual: Manual) -> None:
    """Those that a manual prints with a mistake are on the pages of examples, beside the right ones."""
    shown = 0
    for path, text in manual.pages.items():
        for data in re.findall(r"`([0-9A-F]{2}(?: [0-9A-F]{2}){5,})`", text):
            if data.startswith(bytes(manual.model.protocol.sync).hex(" ").upper()) and "examples/" not in path:
                codec.split(manual.model, bytes.fromhex(data))
                shown += 1
    assert shown > len(manual.model.fields)


def test_pages_are_neat(manual: Manual) -> None:
    faults = []
    for path, text in manual.pages.items():
        plain = without_code(text)
        if len(re.findall(r"^# ", plain, re.M)) != 1 or not re.match(r'(<a id="[^"]*"></a>\n\n)?# ', text):
            faults.append(f"{path}: not one heading of level 1 at its start")
        levels = [len(x) for x in re.findall(r"^(#+) ", plain, re.M)]
        if any(b > a + 1 for a, b in itertools.pairwise(levels)):
            faults.append(f"{path}: skips a level of headings")
        if re.search(r"^#+ *$", plain, re.M):
            faults.append(f"{path}: an empty heading")
        if "\r" in text or "\n\n\n" in text or re.search(r"[ \t]$", text, re.M) or not text.endswith("\n"):
            faults.append(f"{path}: untidy white space")
    assert not faults


def test_no_placeholders(manual: Manual) -> None:
    """Programs have empty calls and braces of their own, the index of C++ has names of functions."""
    anywhere = re.compile(
        r"\b(TODO|TBD|FIXME|XXX|todo|tbd|lorem)\b|\{%|Undefined|mipgen\.|object at 0x|\| None \||`None`"
    )
    in_text = re.compile(r"\{\{|(?<!\w)\(\)")
    found = [(path, x[0]) for path, text in manual.pages.items() if (x := anywhere.search(text))]
    found += [(path, x[0]) for path, text in manual.pages.items() if (x := in_text.search(without_code(text)))]
    assert not found


def test_tables_are_whole(manual: Manual) -> None:
    faults = []
    for path, text in manual.pages.items():
        for block in re.findall(r"(?:^\|.*\n?)+", text, re.M):
            lines = block.strip().split("\n")
            widths = {len(cells(line)) for line in lines}
            if len(widths) != 1 or not re.fullmatch(r"\|( --- \|)+", lines[1]) or "" in cells(lines[0]):
                faults.append(f"{path}: {lines[0]}")
    assert not faults


def test_lists_stay_apart(manual: Manual) -> None:
    """Two lists with nothing but a blank line between them become one."""
    found = [path for path, text in manual.pages.items() if re.search(r"^- .*\n\n- ", without_code(text), re.M)]
    assert not found


#: Lines that the page of any field needs: fences, edges and headings of tables, brackets in programs, sections, folds.
FRAME = re.compile(r"```\w*|</?details.*>|[| -]+|[ })\];]+|## [A-Z][a-z ]+|(?:\| [A-Z][a-z ]+)+\|")


def test_pages_of_fields_are_short() -> None:
    """Half of them have at most 90 lines, and at most a quarter of their text is on another one, too."""
    pages = [text.splitlines() for path, text in manual_of("real").pages.items() if path.startswith("docs/fields/")]
    assert statistics.median(map(len, pages)) <= 90
    said = [[line for line in page if line and not FRAME.fullmatch(line)] for page in pages]
    counts = collections.Counter(line for page in said for line in set(page))
    shares = [sum(counts[line] > 1 for line in page) / len(page) for page in said]
    assert statistics.median(shares) <= 0.25, statistics.median(shares)


# --------------------------------------------------------------------------- links and titles


def test_links_lead_somewhere(manual: Manual) -> None:
    anchors = {path: ANCHOR.findall(text) for path, text in manual.pages.items()}
    faults = [f"{path}: an anchor twice" for path, found in anchors.items() if len(found) != len(set(found))]
    for path, text in manual.pages.items():
        for label, target in LINK.findall(without_code(text)):
            page, anchor = re.fullmatch(r"([^?#]*)(?:\?[^#]*)?#?(.*)", target).groups()  # type: ignore[union-attr]
            to = posixpath.normpath(posixpath.join(posixpath.dirname(path), page)) if page else path
            if to.endswith(".svg"):
                faults += [] if to in manual.files and label else [f"{path}: [{label}]({target})"]
            elif to not in anchors or (anchor and anchor not in anchors[to]) or not label:
                faults.append(f"{path}: [{label}]({target})")
            elif path.startswith("docs/") and not to.startswith("docs/"):
                faults.append(f"{path}: [{label}]({target}) leads out of the site")
        if re.search(r"(?<!\\)\]\(", LINK.sub("", without_code(text))):
            faults.append(f"{path}: a link that is not one")
        if "://" in text:
            faults.append(f"{path}: an absolute link")
    assert not faults


def test_code_is_not_taken_for_a_link(manual: Manual) -> None:
    """A link between backticks would be shown as its characters."""
    for path, text in manual.pages.items():
        spans = [code for line in text.split("\n") for code in re.findall(r"`([^`]*)`", line.replace("\\`", ""))]
        assert not [code for code in spans if "](" in code], path


def test_fields_and_types_between_backticks_are_links() -> None:
    text = "As `tools.ping` and `tools.shape`; (0x01,0x01), `tools.bias.x`."
    first, *others = model("invented").families
    f = dataclasses.replace(first.fields[0], description=text, notes=(text,))
    first = dataclasses.replace(first, fields=(f, *first.fields[1:]))
    manual = made(dataclasses.replace(model("invented"), families=(first, *others)))
    links = "[Ping (0x01,0x01)](#tools.ping) and [`shape`](../../types/tools.md#tools.shape)"
    assert manual.field(f).count(f"As {links}; (0x01,0x01), `tools.bias.x`.") == 2


def test_descriptors_in_quotations_are_links() -> None:
    errata = manual_of("invented").page("errata.md")
    assert "- Published: See (0x01,0x7F)." in errata
    text = "The text refers to `tools.ping` by (0x01,0x01)."
    quoting = dataclasses.replace(model("invented").errata[0], printed=text, right=text, reason=text)
    manual = made(dataclasses.replace(model("invented"), errata=(quoting,)))
    page = manual.page("errata.md")
    quoted = "The text refers to `tools.ping` by [(0x01,0x01)](fields/tools/ping.md#tools.ping)."
    assert f"- Published: {quoted}\n- Correct: {quoted}\n" in page
    reason = "The text refers to [Ping (0x01,0x01)](fields/tools/ping.md#tools.ping) by (0x01,0x01)."
    assert f"- Reason: {reason}" in page


def test_every_page_can_be_reached(manual: Manual) -> None:
    for start in ("README.md", "docs/index.md"):
        seen, todo = set(), [start]
        while todo:
            path = todo.pop()
            if path in seen:
                continue
            seen.add(path)
            targets = [re.split("[?#]", t)[0] for _, t in LINK.findall(without_code(manual.pages[path]))]
            todo += [
                posixpath.normpath(posixpath.join(posixpath.dirname(path), t)) for t in targets if t.endswith(".md")
            ]
        assert {p for p in manual.pages if p.startswith("docs/")} <= seen | {"docs/index.md"}


#: What readers want to know, and what users asked in public: the page, and words on it.
ANSWERED = [(task, page, said) for task, (_, page, said) in TASKS.items()] + [
    (q, *rest) for q, rest in QUESTIONS.items()
]


def linked(path: str) -> set[str]:
    """The pages to which a page of the Markdown links."""
    text, folder = manual_of("real").pages[path], posixpath.dirname(path)
    links = {link.partition("#")[0].partition("?")[0] for _, link in LINK.findall(text)}
    return {posixpath.normpath(posixpath.join(folder, link)) for link in links if link.endswith(".md")}


@pytest.mark.parametrize("home", ["README.md", "docs/index.md"])
def test_each_answer_is_two_steps_away(home: str) -> None:
    one = linked(home)
    two = one.union(*(linked(path) for path in one))
    for task, page, said in ANSWERED:
        path = f"docs/{page.replace('.html', '.md')}"
        assert path in two, task
        assert said in words(manual_of("real").pages[path]), (task, said)


def test_navigation_lists_every_page(manual: Manual) -> None:
    listed = [path for _, path in navigation(manual)]
    assert sorted(listed) == sorted(p[5:] for p in manual.pages if p.startswith("docs/"))


def test_no_two_pages_have_one_title(manual: Manual) -> None:
    """Neither in the navigation and the results of a search, nor at the top of the page."""
    titles = [title for title, _ in navigation(manual)]
    headings = [re.findall(r"^# .*", text, re.M)[0] for path, text in manual.pages.items() if path != "README.md"]
    assert len(titles) == len(set(titles)) and len(headings) == len(set(headings))


def test_anchors_do_not_collide(manual: Manual) -> None:
    problems = Problems()
    naming.collisions("markdown", markdown.identifiers(manual.model), problems)
    assert not problems
    there = {(path, anchor) for path, text in manual.pages.items() for anchor in ANCHOR.findall(text)}
    assert {(i.scope, i.name) for i in markdown.identifiers(manual.model)} <= there


# --------------------------------------------------------------------------- text


NASTY = 'a|b <b>x</b> *c* _d_ [e](f) `g` \\h & &amp; $i$ ~~j~~ #k 1. "l"'


def nasty(model: m.Model) -> m.Model:
    """The model with awkward texts wherever there is prose."""
    first, *others = model.families
    fields = tuple(dataclasses.replace(f, description=NASTY, notes=(NASTY,)) for f in first.fields)
    sets = tuple(dataclasses.replace(s, description=NASTY) for s in first.sets)
    families = (dataclasses.replace(first, fields=fields, sets=sets, description=NASTY), *others)
    errata = tuple(
        dataclasses.replace(e, printed=NASTY, right=NASTY, reason=NASTY, section=NASTY) for e in model.errata
    )
    note = m.Note("n", NASTY, NASTY, ((NASTY, NASTY), (NASTY,)))
    devices = tuple(dataclasses.replace(d, description=NASTY, notes=(note,)) for d in model.devices)
    return dataclasses.replace(model, families=families, errata=errata, devices=devices)


def test_text_is_never_markup() -> None:
    awkward = nasty(model("invented"))
    manual = made(awkward)
    test_tables_are_whole(manual)
    test_links_lead_somewhere(manual)
    f = awkward.families[0].fields[0]
    assert words(manual.field(f)).count(prose(NASTY, awkward)) == 2
    markdown_ = importlib.import_module("markdown")  # comes with mkdocs
    for path in (path_of(f), f"sets/{f.family}.md", "errata.md", f"devices/{awkward.devices[0].id}.md"):
        page = markdown_.markdown(manual.page(path), extensions=["tables", "fenced_code"])
        assert not re.search(r"<b>|<em>[cd]</em>|href=\"f\"", page)
        assert prose(NASTY, awkward) in html.unescape(re.sub(r"</?code>", "", page)), path


# --------------------------------------------------------------------------- the folder and the site


@pytest.mark.parametrize("path", ["generated/markdown/hooks.py", "docs/pages.py"])
def test_hooks_of_the_site(path: str) -> None:
    spec = some(importlib.util.spec_from_file_location("hooks", ROOT / path))
    assert spec.loader is not None
    hooks = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(hooks)
    done = doctest.testmod(hooks)
    assert done.attempted and not done.failed


def test_site_needs_what_is_tested() -> None:
    """The versions that the folder asks for are those that the project pins for its tests."""
    pinned = (ROOT / "runtime/markdown/requirements.txt").read_text("utf-8").split()
    locked = (ROOT / "requirements/development.txt").read_text("utf-8")
    assert [p.partition("==")[0] for p in pinned] == ["mkdocs", "mkdocs-material"]
    assert all(re.search(rf"^{re.escape(p)} ", locked, re.M) for p in pinned)
