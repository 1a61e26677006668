"""The site that is built from the pages: what is on it, its search and its tools in Chromium, from disk."""

from __future__ import annotations

import html
import importlib.util
import json
import os
import posixpath
import re
import shutil
import subprocess
import sys
from functools import cache
from importlib.metadata import version
from pathlib import Path
from urllib.parse import unquote

import browser
import pytest
from c_build import run
from mipgen import model as m
from mipgen.base.cache import key as cache_key
from mipgen.emit import output
from mipgen.targets.markdown.snippets import LANGUAGES
from random_values import chance
from reference import REAL, manual_of, navigation, real_site
from searches import FIELDS, QUESTIONS, TASKS, WORDS
from searches import PAGES as WANTED_PAGES
from support import BUILD, NIGHTLY, ROOT, heavy, locked, model, need, nightly, rounds, some, tree, uses
from workbench import workbench

pytestmark = [pytest.mark.xdist_group("site"), uses("npm")]  # the site is built once, with the workbench
each_spec = pytest.mark.parametrize("spec", ["invented", REAL])
in_browser = heavy("Chromium")

#: One page of each kind, and those with the widest tables.
PAGES = (
    "index.html", "packets.html", "errata.html", "units.html", "examples/3dm-gx5-15.html",
    "sets/3dm.html", "sets/filter_data.html", "types/3dm.html",
    "devices/3dm-cv7-gnss-ins.html", "devices/3dm-gx5-15.html",
    "fields/3dm/pps_source_control.html", "fields/3dm/event_trigger_config.html", "fields/3dm/message_format.html",
    "fields/base/continuous_built_in_test.html", "fields/filter_data/status.html",
    "fields/gnss_data/satellite_status.html",
    "tools/inspector.html", "tools/builder.html#3dm.event_trigger_config", "tools/bandwidth.html#3dm-cv7-gnss-ins",
    "tools/finder.html#lever%20arm", "guides/stream_imu_data.html", "guides/migrate_from_gx5_15_to_cv7.html",
    "compare/commands.html", "compare/rates.html", "indexes/descriptors.html", "indexes/names.html",
)  # fmt: skip


@cache
def project_pages() -> Path:
    """The pages of the project itself, as `make docs` adds them; each process has its own: they are made
    anew while others are read."""
    folder = BUILD / "site-project-pages" / os.environ.get("PYTEST_XDIST_WORKER", "alone")
    subprocess.run([sys.executable, ROOT / "docs/pages.py", folder], check=True)
    return folder


@cache
def built(spec: str, tools: bool = True) -> Path:
    """The site of a copy of the folder, which has nothing beside it, with or without the workbench.

    It is kept until its pages or the workbench change.
    """
    files, bench = manual_of(spec).files, workbench(spec)
    project = tools and spec == "real"
    pages = project_pages() if project else None
    given = [*sorted(files.items()), *(sorted(tree(bench).items()) if tools else ())]
    given += sorted(tree(pages).items()) if pages else []
    key = cache_key(version("mkdocs-material"), *(part for name, data in given for part in (name, data)))
    folder = BUILD / f"site-{spec}-{'with' if tools else 'without'}-workbench"
    source, site, mark = folder / "markdown", folder / "site", folder / "key"
    with locked(folder):
        if not mark.is_file() or mark.read_text() != key:
            mark.unlink(missing_ok=True)
            shutil.rmtree(site, ignore_errors=True)
            output.write(files, source)
            environment = {"NO_MKDOCS_2_WARNING": "1", "MIP_WORKBENCH": str(bench) if tools else ""}
            environment["MIP_PAGES"] = str(pages or "")
            done = subprocess.run(
                [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(site)],
                cwd=source, capture_output=True, text=True, env={**os.environ, **environment}, check=False,
            )  # fmt: skip
            assert done.returncode == 0, done.stdout + done.stderr
            mark.write_text(key)
    return site


def page_of(field: str) -> str:
    """The address of a field, as the reference of the generator has it."""
    of = model("real")
    f = next(f for f in [*of.fields, of.protocol.acknowledge] if f.full_name == field)
    page = "packets" if not f.set else f"fields/{f.family}/{f.command or f.name}"
    return f"{page}.html#{field}"


# --------------------------------------------------------------------------- files


@each_spec
def test_site_builds(spec: str) -> None:
    manual, site = manual_of(spec), built(spec)
    titles, descriptions = {}, {}
    for _, path in navigation(manual):
        page = (site / path[:-3]).with_suffix(".html").read_text("utf-8")
        titles[path] = re.findall(r"<title>(.*?)</title>", page)[0]
        described = re.findall(r'<meta name="description" content="([^"]+)"', page)
        descriptions[path] = html.unescape(described[0])
        text = manual.pages[f"docs/{path}"]
        for anchor in re.findall(r'^<a id="([^"]*)"></a>\n\n#', text, re.M):  # permalink, outline and search use it
            assert re.search(rf'<h[1-4] id="{re.escape(anchor)}">', page), (path, anchor)
        assert not re.search(r"<th[^>]*>\s*</th>", page), path
        if '<div class="filter' in text:
            assert 'class="filter' in page and re.search(r'<script src="(\.\./)*assets/filter\.js"', page), path
        programs = []
        if path.startswith("programs."):
            programs += re.findall(r"^```(?:c|cpp|python|rust|javascript)$", text, re.M)
        elif path.startswith(("fields/", "guides/")):  # the site has all languages
            programs += re.findall(r"^```python$", text, re.M) * len(LANGUAGES)
        if path.startswith("fields/"):
            assert page.count('class="mip-ruler"') == len(re.findall(r"`75 65` ", text)), path
        assert len(re.findall(r'<div class="tabbed-block">', page)) == len(programs), path
    assert len(set(titles.values())) == len(titles)
    assert len(set(descriptions.values())) == len(descriptions) and max(map(len, descriptions.values())) <= 160


@each_spec
def test_pages_load_nothing_from_elsewhere(spec: str) -> None:
    for path in built(spec).rglob("*.html"):
        if path.name == "404.html":  # its addresses are those of a server
            continue
        page = path.read_text("utf-8")
        loaded = re.findall(r"<(?:script|img|iframe|source)\b[^>]*\bsrc=[\"']?([^\"'\s>]+)", page)
        loaded += re.findall(r"<link\b(?![^>]*rel=\"canonical\")[^>]*\bhref=[\"']?([^\"'\s>]+)", page)
        for address in loaded:
            there = posixpath.normpath(path.parent / unquote(address.partition("#")[0].partition("?")[0]))
            assert Path(there).is_file() or Path(there).is_dir(), (path.name, address)


@each_spec
def test_contents_of_a_page_are_its_sections(spec: str) -> None:
    """The sections of two levels below the title; each heading links to itself."""
    for page in ("packets.html", "types.html"):
        text = (built(spec) / page).read_text("utf-8")
        contents = text.partition('class="md-nav md-nav--secondary"')[2].partition('<div class="md-content"')[0]
        headings = re.findall(r'<h([1-6]) id="([^"]+)"', text)
        assert re.findall(r'class="headerlink" href="#([^"]+)"', text) == [place for _, place in headings]
        listed = dict.fromkeys(re.findall(r'<a href="#([^"]+)" class="md-nav__link"', contents))  # it is there twice
        assert [*listed] == [place for level, place in headings if level in "23"]


@real_site
def test_pages_of_the_project() -> None:
    """Documents, READMEs and the help of `mip` are pages, in the contents and in the search; a link leads to a page."""
    site, pages = built("real"), json.loads((project_pages() / "pages.json").read_text())
    names = [name for section in pages.values() for name in section]
    contents = (site / "index.html").read_text("utf-8")
    assert all(f'href="project/{name[:-3]}.html"' in contents for section in pages.values() for name in [*section][:1])
    for name in names:
        page = (site / f"project/{name[:-3]}.html").read_text("utf-8")
        for target in re.findall(r'href="((?:\.\./)*[\w/.-]+\.(?:html|md))', page):
            assert (site / "project" / target).is_file(), (name, target)
    commands = (site / "project/commands.html").read_text("utf-8")
    assert all(f'<h2 id="{name}">' in commands for name in ("dump", "export", "simulate"))
    wanted = {"mcap": "project/robots.html", "arduino": "project/c.html", "wireshark": "project/wireshark.html"}
    found = searched([*wanted])
    assert {word for word, page in wanted.items() if page not in {x.split("#")[0] for x in found[word][:3]}} == set()


@each_spec
def test_text_for_the_search(spec: str) -> None:
    """Each page with its sections, whose anchors are on it."""
    manual, site = manual_of(spec), built(spec)
    script = (site / "assets/text.js").read_text("utf-8")
    texts = json.loads(script.removeprefix("globalThis.mipText = ").removesuffix(";\n"))
    repeating = ("indexes/", "programs/")
    listed = (path for _, path in navigation(manual) if not path.startswith(repeating))
    of_the_manual = sorted(url for url, _, _ in texts if not url.startswith("project/"))
    assert of_the_manual == sorted(f"{path[:-3]}.html" for path in listed)
    titles = [title for _, title, _ in texts]
    assert all(titles) and len(set(titles)) == len(titles)
    for url, _, sections in texts:
        page = (site / url).read_text("utf-8")
        assert all(f'id="{anchor}"' in page for anchor, _, _ in sections[1:]), url
        assert all(heading and "¶" not in heading and "<" not in heading for _, heading, _ in sections[1:]), url
    everything = " ".join(text for _, _, sections in texts for _, _, text in sections)
    assert all(f.full_name in everything for f in manual.fields)


#: Bytes that a page loads for its first search.
FIRST_SEARCH = 600_000


@real_site
def test_the_first_search_is_small() -> None:
    assets = built("real") / "assets"
    assert sum((assets / name).stat().st_size for name in ("search.js", "fields.js", "text.js")) <= FIRST_SEARCH


def searched(queries: list[str]) -> dict[str, list[str]]:
    """The addresses that the search of the site finds, in their order, without a browser."""
    program = (
        "const [search, fields, text] = process.argv.slice(1); require(search); require(fields); require(text);"
        " const index = mip.indexOf(new mip.Protocol(mip.model));"
        " const addresses = (query) => mipSearch.search(index, mipText, query).groups.flatMap("
        "({ items }) => items.flatMap(({ href = [] }) => href));"
        " const queries = JSON.parse(require('node:fs').readFileSync(0));"
        " console.log(JSON.stringify(queries.map((query) => [query, addresses(query)])));"
    )
    assets = built("real") / "assets"
    command = [need("node"), "-e", program, *(assets / name for name in ("search.js", "fields.js", "text.js"))]
    done = subprocess.run(command, input=json.dumps(queries), capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout))


@real_site
def test_everything_is_on_one_page() -> None:
    """Every field, parameter and value; links between parts stay on the page, others lead to pages of the site."""
    spec = some(importlib.util.spec_from_file_location("everything", ROOT / "docs/everything.py"))
    everything = importlib.util.module_from_spec(spec)
    some(spec.loader).exec_module(everything)
    page = everything.whole(built("real"))
    anchors = set(re.findall(r'\bid="([^"]+)"', page))
    assert {f.full_name for f in model("real").fields} <= anchors
    assert {f"{f.full_name}.{p.name}" for f in model("real").fields for p in f.parameters} <= anchors
    assert "<code>0x80</code>" in page and "overflow-wrap: anywhere" not in page  # on paper, codes stay whole
    assert "filter_<wbr>data.<wbr>status" in page
    links = set(re.findall(r'href="(?!https?:|data:)([^"]*)"', page))
    assert {x for x in links if x.startswith("#") and x[1:] not in anchors} == set()
    others = {x.partition("#")[0].partition("?")[0] for x in links if not x.startswith("#")}
    assert [x for x in others if not (built("real") / unquote(x)).exists()] == []


@real_site
def test_what_people_type_leads_to_the_page() -> None:
    """Within the first three: that of a field always, others in 95 % of searches."""
    exact = {query: page_of(field) for query, field in FIELDS.items()} | WANTED_PAGES
    exact |= {query: page for query, page, _ in TASKS.values()} | {
        query: page for query, (page, _) in QUESTIONS.items()
    }
    wanted = {query: [page] for query, page in exact.items()} | WORDS
    assert len(wanted) > 200
    found = searched(list(wanted))
    missed = {
        query: (found[query][:3], pages)
        for query, pages in wanted.items()
        if not any(address in pages or re.split("[#?]", address)[0] in pages for address in found[query][:3])
    }
    assert not missed.keys() & FIELDS.keys() and len(missed) <= len(wanted) / 20, missed
    for page, _, anchor in {page.partition("#") for pages in wanted.values() for page in pages}:
        assert not anchor or f'id="{anchor}"' in (built("real") / page).read_text("utf-8"), (page, anchor)
        assert (built("real") / page.partition("?")[0]).is_file(), page


@real_site
def test_text_of_pages_is_found_and_collections_are_not_first() -> None:
    wanted = {
        "big-endian": "packets.html#numbers",
        "units and frames": "units.html",
        "3DM-CV7-GNSS/INS": "devices/3dm-cv7-gnss-ins.html",
        "cv7-pps-disabled": "errata.html#erratum.cv7-pps-disabled",
    }
    found = searched([*wanted, "checksum", "event trigger", "baud rate", "gnss"])
    assert {query: page for query, page in wanted.items() if page not in found.pop(query)} == {}
    for query, addresses in found.items():
        collected = [address.startswith(("errata.", "examples/")) for address in addresses]
        assert addresses and not any(collected[:3]), query


# --------------------------------------------------------------------------- in a browser


def go(page: browser.Page, address: str, spec: str = "real") -> None:
    path, _, fragment = address.partition("#")
    page.open("about:blank")  # another fragment alone loads nothing
    page.open((built(spec) / path).as_uri() + (f"#{fragment}" if fragment else ""))
    if path.startswith("tools/"):
        wait(page, "document.querySelector('.mip-tool :is(input, select, textarea)')")


def wait(page: browser.Page, condition: str) -> None:
    page.run(
        "new Promise((done, failed) => { const end = Date.now() + 60000; const look = () => {"
        f" if ({condition}) done(); else if (Date.now() > end) failed(Error('in vain')); else setTimeout(look, 20); }};"
        " look(); })"
    )


def typed(page: browser.Page, text: str) -> None:
    """Types into the search of the page, and waits until pages are found, too."""
    page.run(
        "(() => { const input = document.querySelector('.mip-search input'); input.focus();"
        f" input.value = {json.dumps(text)}; input.dispatchEvent(new Event('input')); }})()"
    )
    wait(
        page, "globalThis.mipText && document.querySelector('.mip-search [role=status]').textContent.includes('found')"
    )


def results(page: browser.Page) -> list[str]:
    """The addresses of what is found, within the site."""
    hrefs: list[str] = page.run("[...document.querySelectorAll('.mip-search a')].map((link) => link.href)")
    return [unquote(href.removeprefix(f"{built('real').as_uri()}/")) for href in hrefs]


@in_browser
@pytest.mark.parametrize("address", PAGES)
def test_every_page_has_the_search(page: browser.Page, address: str) -> None:
    go(page, address)
    assert page.run("document.querySelectorAll('header .mip-search input').length") == 1
    typed(page, "0x0D13")
    assert results(page)[0] == "fields/filter/antenna_offset.html#filter.antenna_offset"


@in_browser
def test_a_packet_is_for_the_inspector(page: browser.Page) -> None:
    go(page, "index.html")
    typed(page, "7565 0102 0201 E0C6")
    assert results(page)[0] == "tools/inspector.html#75 65 01 02 02 01 E0 C6"
    first = page.run("document.querySelector('.mip-search a').textContent")
    assert first == "Packet: open in the inspector"


@in_browser
def test_search_by_keyboard(page: browser.Page) -> None:
    go(page, "fields/base/ping.html")

    def press(key: str) -> None:
        page.run(
            "document.activeElement.dispatchEvent(new KeyboardEvent('keydown',"
            f" {{ key: {key!r}, bubbles: true, cancelable: true }}))"
        )

    press("/")
    assert page.run("document.activeElement.matches('.mip-search input')")
    typed(page, "0xF1")
    press("ArrowDown")
    focused = page.run("document.activeElement.getAttribute('href')")
    assert focused.endswith("packets.html#protocol.acknowledge")
    press("ArrowUp")
    press("Escape")
    assert page.run("document.querySelector('.mip-search__output').hidden")
    assert page.run("document.activeElement.matches('.mip-search input')")
    page.run("document.querySelector('.mip-search').requestSubmit(); 0")
    page.browser.wait_for("Page.loadEventFired")
    assert page.run("location.href").endswith("packets.html#protocol.acknowledge")


@in_browser
def test_my_device_is_remembered(page: browser.Page) -> None:
    """Chosen on its page; filters lists and values, and is chosen in search, tools and comparison."""
    press, device_id = "document.querySelector('.mip-choose').click()", "3dm-gx5-15"
    go(page, "devices/3dm-gx5-15.html")
    page.run(press)
    for field, said in (
        ("base/ping", "supported"), ("sensor/scaled_accel", "supported"),
        ("3dm/pps_source_control", "not supported"),
    ):  # fmt: skip
        go(page, f"fields/{field}.html")
        wait(page, "document.querySelector('article .mip-mine')")
        assert page.run("document.querySelector('.mip-mine').textContent") == f"On my device, 3DM-GX5-15: {said}."
    typed(page, "0x0C28")
    assert "not supported" in page.run("document.querySelector('.mip-search .mip-mine').textContent")
    go(page, "sets/3dm.html")
    wait(page, "document.querySelector('article .mip-mine')")
    rows = "[...document.querySelectorAll('.mip-other')]"
    others: list[str] = page.run(f"{rows}.map((row) => row.querySelector('a[href*=\"fields/\"]').hash.slice(1))")
    device = next(d for d in model("real").devices if d.id == "3dm-gx5-15")
    has = {s.field.full_name for s in device.supports}
    fields = [f for f in model("real").fields if f.family == "3dm" and f.role == m.COMMAND]
    wanted = {f.full_name for f in fields} - has
    assert wanted and {name for name in others if not name.endswith("_response")} == wanted
    assert page.run(f"{rows}.every((row) => row.hidden)")
    page.run("document.querySelector('article label input').click()")
    assert page.run(f"{rows}.every((row) => row.checkVisibility())")
    go(page, "fields/filter_data/status.html")
    wait(page, "document.querySelector('article .mip-mine')")
    values = (
        "[...document.querySelectorAll('article h2')].filter((h) => h.textContent.startsWith('Values of') && !h.hidden)"
    )
    shown_values: list[str] = page.run(
        f"{values}.map((heading) => heading.querySelector('code:last-of-type').textContent)"
    )
    assert shown_values == ["gx5_filter_state", "gx5_dynamics_mode", "gx5_status_flags"]
    assert page.run("[...document.querySelectorAll('article li')].some((line) => line.hidden)")
    for tool in ("inspector.html#75 65 01 02 02 01 E0 C6", "builder.html#3dm.message_format", "builder.html"):
        go(page, f"tools/{tool}")
        assert page.run("document.querySelector('.mip-tool #mip-device').value") == device_id, tool
    go(page, "compare/commands.html")
    assert page.run("[...document.querySelectorAll('fieldset input:checked')].map((box) => box.value)") == [device_id]
    assert page.run("location.search") == f"?devices={device_id}"
    go(page, "tools/bandwidth.html")
    assert "3DM-GX5-15" in page.run("document.querySelector('.mip-tool select').selectedOptions[0].textContent")
    go(page, "devices/3dm-gx5-15.html")
    page.run(press)
    go(page, "fields/base/ping.html")
    assert page.run("document.querySelector('.mip-mine')") is None


def shown(page: browser.Page, selector: str) -> list[str]:
    """Links of a tool, whose pages and anchors are there."""
    hrefs: list[str] = page.run(f"[...document.querySelectorAll({selector!r})].map((link) => link.href)")
    found = []
    for href in hrefs:
        address = unquote(href.removeprefix(f"{built('real').as_uri()}/"))
        path, _, anchor = address.partition("#")
        assert f'id="{anchor}"' in (built("real") / path).read_text("utf-8"), address
        found.append(address)
    return found


@in_browser
def test_inspector_links_to_the_reference(page: browser.Page) -> None:
    """A command, its acknowledge and its response, and the errata of the field."""
    go(page, "tools/inspector.html#75650C04042801041B55" + "75650C0704F1280003A801B681")
    found = shown(page, ".mip-field h3 a")
    assert found[0] == page_of("3dm.pps_source_control") and found[1] == page_of("protocol.acknowledge")
    assert found[2] == page_of("3dm.pps_source_control_response")
    assert "errata.html#erratum.cv7-pps-disabled" in shown(page, ".mip-note a")


@in_browser
@pytest.mark.parametrize("name", ["3dm.message_format", "gnss_data.llh_position"])
def test_a_program_becomes_a_complete_file(page: browser.Page, name: str, tmp_path: Path) -> None:
    """Its lines replace those of another page, and it compiles where that needs no library."""
    go(page, page_of(name))
    frames = json.loads((built("real") / "assets/frames.js").read_text("utf-8").partition(" = ")[2].rstrip(";\n"))
    kind = frames["command" if name.startswith("3dm") else "data"]
    for i, (language, frame) in enumerate(kind.items()):
        lines = (
            page.run(f"document.querySelectorAll('article .tabbed-block code')[{i}].textContent").strip().split("\n")
        )
        page.run(f"document.querySelectorAll('.mip-whole')[{i}].click()")
        text = page.run(
            "new Promise((done) => setTimeout(() => done(document.querySelector('dialog pre').textContent), 300))"
        )
        file = page.run("document.querySelector('dialog a').download")
        page.run("document.querySelector('dialog').close()")
        assert all(re.search(rf"^\s*{re.escape(line)}$", text, re.M) for line in lines), (language, text)
        assert not re.search(r"Ping|_ping|::ping|scaled_?accel", text, re.I), text
        assert len(frame.splitlines()) <= len(text.splitlines()) + 6, language
        if "0x80" in frame:
            assert "0x81" in text and not re.search(r"0x80|0x04\b", text), text
        if language == "python":
            compile(text, file, "exec")
        if language in ("c", "cpp"):
            (tmp_path / file).write_text(text)
            need("cc" if language == "c" else "c++")
            flags = ["-std=c99"] if language == "c" else ["-std=c++17"]
            folders = [f"-I{ROOT}/generated/c/{x}" for x in ("src", "ports")]
            command = ["cc" if language == "c" else "c++", *flags, "-fsyntax-only", *folders, tmp_path / file]
            run(*command)


@in_browser
def test_pages_lead_to_the_tools(page: browser.Page) -> None:
    go(page, "fields/3dm/pps_source_control.html")
    builder = page.run("document.querySelector('article p > a[href*=\"tools/builder\"]').href")
    assert builder.endswith("/tools/builder.html#3dm.pps_source_control")
    bytes_ = page.run("document.querySelector('.mip-packet-cell code').textContent")
    inspector = unquote(page.run("document.querySelector('.mip-open a').href"))
    assert inspector.endswith(f"/tools/inspector.html#{bytes_}") and bytes_.startswith("75 65 0C")
    go(page, f"tools/builder.html#{builder.partition('#')[2]}")
    assert page_of("3dm.pps_source_control") in shown(page, ".mip-tool h2 a")
    go(page, f"tools/inspector.html#{inspector.partition('#')[2]}")
    assert page.run("document.querySelector('.mip-packet').dataset.bytes") == bytes_
    go(page, "tools/finder.html#0xF1")
    assert shown(page, ".mip-results a")[0] == page_of("protocol.acknowledge")


@in_browser
@pytest.mark.parametrize(
    ("address", "bytes_"),
    [
        ("fields/3dm/message_format.html", "75 65 0C 0B 0B 0F 01 80 02 04 00 0A 05 00 0A AB 00"),
        ("fields/sensor/scaled_accel.html", ""),
        ("guides/stream_imu_data.html", "75 65 0C 0E 0E 0F 01 80 03 D5 00 0A 04 00 0A 05 00 0A 91 CE"),
    ],
)
def test_packets_of_pages_open_in_the_builder(page: browser.Page, address: str, bytes_: str) -> None:
    """With their values, which build the same packet."""
    go(page, address)
    links = "[...document.querySelectorAll('.mip-open a[href*=\"tools/builder\"]')]"
    packets = [unquote(href.partition("#")[2]) for href in page.run(f"{links}.map((link) => link.href)")]
    assert packets and bytes_ in ["", *packets]
    assert not [text for text in packets if re.match("75 65 [0-7]. .. .. F1", text)], "answers are not for sending"
    wanted = bytes_ or packets[0]
    (href,) = set(
        page.run(f"{links}.map((link) => link.href).filter((href) => decodeURIComponent(href).endsWith('#{wanted}'))")
    )
    go(page, href.removeprefix(f"{built('real').as_uri()}/"))
    assert page.run("document.querySelector('.mip-packet-bytes').textContent") == wanted
    assert page.run("document.querySelector('.mip-tool > .mip-wrong')") is None


@in_browser
@pytest.mark.parametrize("tool", ["inspector", "live"])
def test_an_anchor_of_the_page_is_not_for_the_tool(tool: str, page: browser.Page) -> None:
    """A link to a heading leaves the tool as it is, and those of the live view leave its page."""
    inside = "document.querySelector('.mip-tool')"
    go(page, f"tools/{tool}.html#bytes=756501020201E0C6")
    page.run(f"{inside}.firstChild.kept = true")
    page.run("document.querySelector('article h1 .headerlink').click()")
    wait(page, "document.getElementById(location.hash.slice(1))")
    page.run("new Promise((done) => setTimeout(done, 500))")
    assert page.run(f"{inside}.firstChild.kept")
    page.run("location.hash = '#bytes=75650C04042801041B55'")
    wait(page, f"!{inside}.firstChild.kept")
    targets = set(page.run(f"[...{inside}.querySelectorAll('a')].map((link) => link.target)"))
    assert targets == ({"_blank"} if tool == "live" else {""}), targets


@in_browser
def test_tools_of_another_specification(page: browser.Page) -> None:
    for name in ("inspector", "builder", "bandwidth", "finder", "live"):
        go(page, f"tools/{name}.html", "invented")
        assert page.run("document.querySelector('.mip-tool').children.length") > 0


@in_browser
def test_a_site_without_the_workbench(page: browser.Page) -> None:
    """The folder alone: its pages say how to get the tools, and the search finds text."""
    site = built("invented", tools=False)
    for name in ("inspector", "builder", "bandwidth", "finder", "live"):
        page.open(site / f"tools/{name}.html")
        assert f"build/workbench/{name}.html" in page.run("document.querySelector('.mip-tool').textContent")
    page.open(site / "index.html")
    typed(page, "specific force")
    found = page.run("[...document.querySelectorAll('.mip-search a')].map((link) => link.href)")
    assert found and found[0].startswith(site.as_uri()) and "accel" in "".join(found)


#: Elements that are wider than the window, except those that scroll; and tables that neither fit nor scroll.
WIDE = """
(() => {
    const scrolls = ".md-typeset__scrollwrap, .mip-scroll, pre > code, .tabbed-labels";
    const wide = [...document.querySelectorAll("article *")].filter(
        (one) => one.getBoundingClientRect().right > innerWidth + 1 && !one.parentElement.closest(scrolls),
    );
    const stuck = [...document.querySelectorAll("article table")].filter((table) => {
        const box = table.closest(scrolls) ?? table.parentElement;
        return box.scrollWidth > box.clientWidth + 1 && !/auto|scroll/.test(getComputedStyle(box).overflowX);
    });
    return [...wide, ...stuck].slice(0, 5).map((one) => one.outerHTML.slice(0, 120));
})()
"""


@in_browser
@pytest.mark.parametrize("width", [390, 1400, 1920])
def test_pages_fit_the_window(page: browser.Page, width: int) -> None:
    page.size(width)
    try:
        for address in PAGES:
            go(page, address)
            page.run("document.querySelectorAll('details').forEach((part) => (part.open = true))")
            assert page.run("document.documentElement.scrollWidth") <= width, address
            assert page.run(WIDE) == [], address
    finally:
        page.size(1400)


#: Tables that need more than the window.
SCROLLING = (
    "[...document.querySelectorAll('article .md-typeset__scrollwrap')]"
    ".filter((box) => box.scrollWidth > box.clientWidth).map((box) => box.textContent.trim().slice(0, 60))"
)


@in_browser
def test_wide_tables_break_names(page: browser.Page) -> None:
    """Only where they would have to scroll, and between the words of a name."""
    page.size(1400)
    for address in (*PAGES, "fields/filter/mag_dip_angle_error_adaptive_measurement.html", "fields/gnss_data/dop.html"):
        if address.startswith(("tools/", "compare/", "guides/")):
            continue
        go(page, address)
        page.run("document.querySelectorAll('details').forEach((part) => (part.open = true))")
        page.run("new Promise((done) => requestAnimationFrame(() => setTimeout(done, 50)))")
        assert page.run(SCROLLING) == [], address
    go(page, "fields/base/ping.html")
    assert page.run("document.querySelectorAll('article table wbr').length") == 0
    go(page, "fields/3dm/event_trigger_config.html")
    wait(page, "document.querySelector('article table wbr')")
    before = page.run("[...new Set([...document.querySelectorAll('wbr')].map((x) => x.previousSibling.data.at(-1)))]")
    assert set(before) <= set("_.*") | set("abcdefghijklmnopqrstuvwxyz"), before


#: Rows of a long table that is far below the window, and of one that is folded.
FAR = (
    "fields/gnss_data/raw.html#gnss_data.raw.signal_id.gnss_signal.beidou_b2q",
    "fields/3dm/device_status.html#3dm.device_status_diagnostic_gx3_response.imu_bytes_read",
)


@in_browser
@pytest.mark.parametrize("address", FAR)
def test_links_lead_to_rows_far_away_and_folded(page: browser.Page, address: str) -> None:
    """What is folded opens."""
    page.size(1400)
    go(page, address)
    row = f"document.getElementById({address.partition('#')[2]!r}).closest('tr').getBoundingClientRect()"
    wait(page, f"{row}.height > 0 && {row}.top > 0 && {row}.bottom < innerHeight")


@in_browser
def test_printed_tables_fit_the_paper(page: browser.Page) -> None:
    """They cannot scroll there."""
    page.call("Emulation.setEmulatedMedia", media="print")
    page.size(703)  # A4 without its margins, at 96 dots per inch
    try:
        for address in PAGES:
            if address.startswith("tools/"):
                continue
            go(page, address)
            edge = "document.querySelector('article').getBoundingClientRect().right + 1"
            tables = "[...document.querySelectorAll('article table')]"
            over = f"{tables}.filter((table) => table.getBoundingClientRect().right > {edge})"
            assert page.run(f"{over}.map((table) => table.outerHTML.slice(0, 120))") == [], address
    finally:
        page.call("Emulation.setEmulatedMedia", media="")
        page.size(1400)


@in_browser
def test_nothing_is_folded_on_paper(page: browser.Page) -> None:
    go(page, "fields/3dm/device_status.html")
    page.run("document.querySelector('article details').open = true")
    page.run("""
        window.seen = () => [...document.querySelectorAll("article details")].map((box) => box.open);
        addEventListener("beforeprint", () => { window.printed = seen(); });
    """)
    before = page.run("seen()")
    page.call("Page.printToPDF")
    assert before.count(False) > 3 and page.run("printed.every(Boolean)")
    wait(page, f"JSON.stringify(seen()) === {json.dumps(json.dumps(before, separators=(',', ':')))}")


@in_browser
def test_the_scheme_is_switched_and_kept(page: browser.Page) -> None:
    """By its button; the next page has it too."""
    scheme = "document.body.dataset.mdColorScheme"
    button = "[...document.querySelectorAll('.md-header [data-md-component=palette] label')].find((one) => !one.hidden)"
    go(page, "fields/3dm/message_format.html")
    seen = []
    try:
        for _ in range(3):
            wait(page, button)
            page.run(f"{button}.click()")
            chosen = page.run(scheme)
            seen.append(chosen)
            for address in ("fields/3dm/message_format.html", "compare/commands.html", "tools/builder.html#base.ping"):
                go(page, address)
                assert page.run(scheme) == chosen, address
        assert {"default", "slate"} <= set(seen)
    finally:
        page.run("localStorage.clear()")


#: Pages with very many tables, of a kind that other pages have, too.
MANY = {"examples/3dm-gx5-15.html", "errata.html", "compare/commands.html", "indexes/descriptors.html"}

#: Widths and colour schemes in which a page is seen.
WAYS = ((1400, "default"), (390, "default"), (390, "slate"))


@heavy("chromium and npm")
def test_no_serious_findings_of_axe(page: browser.Page) -> None:
    """In both schemes, wide and narrow. It takes seconds for a large page, so that the seed draws half of the pages,
    and one of these ways for each; nightly all."""
    axe = browser.axe()
    look = (
        "axe.run(document, { resultTypes: ['violations'], preload: false,"
        " rules: { 'target-size': { enabled: true } } })"
        ".then(({ violations }) => violations.filter(({ id, impact }) => id === 'landmark-unique' ||"
        " ['serious', 'critical'].includes(impact)).map(({ id, nodes }) =>"
        " `${id}: ${nodes.length}: ${nodes[0].html.slice(0, 160)}`))"
    )
    still = "*, ::before, ::after { transition: none !important }"  # colours that change slowly are not findings
    found = []
    few = [address for address in PAGES if address not in MANY]
    for address in PAGES if NIGHTLY else chance("axe").sample(few, len(few) // 2):
        page.size(1400)
        go(page, address)
        page.run(
            f"{axe}; document.head.append(Object.assign(document.createElement('style'), {{ textContent: {still!r} }}))"
        )
        for width, scheme in chance("axe", address).sample(WAYS, rounds(1, len(WAYS))):
            page.size(width)
            page.run(f"document.body.dataset.mdColorScheme = {scheme!r}")
            page.run("new Promise((done) => requestAnimationFrame(() => setTimeout(done)))")
            found += [(address, width, scheme, finding) for finding in page.run(look)]
    page.size(1400)
    assert found == []


@nightly("pictures of the site")
@in_browser
def test_pictures_can_be_taken(tmp_path: Path) -> None:
    """`make pictures` takes them; it fails if a script of a page does, or if a picture is too large."""
    path = os.pathsep.join(str(ROOT / name) for name in ("generator", "tests"))
    script = ROOT / "docs/pictures/pages.py"
    subprocess.run([sys.executable, script, built("real"), tmp_path], env=os.environ | {"PYTHONPATH": path}, check=True)
    names = {picture.name for picture in tmp_path.iterdir()}
    committed = set((ROOT / "docs/pictures").glob("*.png"))
    assert {p.name for p in committed} <= names and all(p.stat().st_size <= 300_000 for p in committed)
