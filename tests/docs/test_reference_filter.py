"""The filter of long tables in Chromium, from disk: rows, columns by device, differences, the address, the keyboard."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import browser
import markdown  # comes with mkdocs
import pytest
from mipgen import model as m
from reference import manual_of
from support import ROOT, heavy, model, some
from test_reference_comparison import expected, known_of

pytestmark = heavy("Chromium")

ASSETS = ROOT / "generated/markdown/docs/assets"
PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>{name}</title>
<link rel="stylesheet" href="{assets}/filter.css"><article class="md-typeset md-content__inner">{body}</article>
<script src="{assets}/filter.js"></script></html>"""

ROWS = "[...document.querySelectorAll('tbody tr')].filter((row) => row.checkVisibility())"
COLUMNS = "[...document.querySelectorAll('thead')].map((head) => [...head.rows[0].cells].filter((c) => !c.hidden))"
GX5, CV7 = "3dm-gx5-15", "3dm-cv7-gnss-ins"


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The pages as a site shows them, without its theme."""
    folder = tmp_path_factory.mktemp("site")
    for path, text in manual_of("real").pages.items():
        if re.match(r"docs/(compare|indexes)/", path):
            body = re.sub(r'(href="[^"]*)\.md(["#?])', r"\1.html\2", markdown.markdown(text, extensions=["tables"]))
            out = folder / path.replace(".md", ".html")
            out.parent.mkdir(parents=True, exist_ok=True)
            out.write_text(PAGE.format(name=out.stem, assets=ASSETS.as_uri(), body=body), "utf-8")
    return folder / "docs"


def open_(page: browser.Page, site: Path, path: str) -> None:
    page.open("about:blank")
    page.open(f"{(site / path.partition('?')[0]).as_uri()}?{path.partition('?')[2]}")


def type_(page: browser.Page, text: str) -> None:
    page.run(
        f"(() => {{ const input = document.querySelector('input[type=search]'); input.value = {text!r};"
        " input.dispatchEvent(new Event('input')); })()"
    )


def choose(page: browser.Page, *devices: str) -> None:
    for d in devices:
        page.run(f"document.querySelector('input[value=\"{d}\"]').click()")


def press(page: browser.Page, key: str, code: int) -> None:
    for kind in ("keyDown", "keyUp"):
        text = {"text": key} if len(key) == 1 and kind == "keyDown" else {}
        page.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, **text)


def shown(page: browser.Page) -> list[str]:
    """The fields of the visible rows, by their links."""
    links: list[str] = page.run(
        f"{ROWS}.flatMap((row) => row.querySelector('a[href*=\"#\"]')?.getAttribute('href') ?? [])"
    )
    return [link.rpartition("#")[2] for link in links]


def columns(page: browser.Page) -> list[Any]:
    found: list[Any] = page.run(f"{COLUMNS}.map((cells) => cells.map((cell) => cell.textContent))")
    return found


def commands() -> list[m.Field]:
    return [f for f in model("real").fields if f.role == m.COMMAND]


def device(device_id: str) -> m.Device:
    return some(model("real").device(device_id))


def test_at_first_everything_is_shown(page: browser.Page, site: Path) -> None:
    open_(page, site, "compare/commands.html")
    known = [d.title for d in model("real").devices if d.certain]
    assert shown(page)[: len(commands())] == [f.full_name for f in commands()]
    assert all(sorted(found[2:]) == sorted(known) for found in columns(page)[:-1])
    total = page.run("document.querySelectorAll('tbody tr').length")
    assert page.run("document.querySelector('output').textContent") == f"{total} rows"
    assert page.run("document.querySelectorAll('fieldset input').length") == len(model("real").devices)
    names = page.run("[...document.querySelectorAll('form input')].map((input) => input.labels[0]?.textContent.trim())")
    assert all(names) and len(names) == len(set(names))


def test_rows(page: browser.Page, site: Path) -> None:
    open_(page, site, "compare/commands.html")
    type_(page, "PPS")
    wanted = [f.full_name for f in commands() if "pps" in f.title.lower()]
    # Then come the devices without certain fields that have such a command.
    assert wanted and shown(page)[: len(wanted)] == wanted
    visible = "[...document.querySelectorAll('h2')].filter((heading) => heading.checkVisibility())"
    sets = [s for s in model("real").sets if any(name.startswith(f"{s.name}.") for name in wanted)]
    assert page.run(f"{visible}.map((heading) => heading.textContent)") == [
        *(f"{s.title} (0x{s.number:02X})" for s in sets), "Devices without certain fields"
    ]  # fmt: skip
    type_(page, "xyzzy")
    assert shown(page) == [] and page.run("document.querySelector('output').textContent") == "0 rows"
    type_(page, "")
    assert len(shown(page)) >= len(commands())


def test_differences(page: browser.Page, site: Path) -> None:
    open_(page, site, "compare/commands.html")
    choose(page, GX5, CV7)
    titles = [device(GX5).title, device(CV7).title]
    assert all(sorted(found[2:]) == sorted(titles) for found in columns(page)[:-1])
    page.run("[...document.querySelectorAll('form label')].find((l) => l.textContent.includes('difference')).click()")
    known = {d: known_of(device(d)) for d in (GX5, CV7)}
    said = {d: [expected(device(d), f, f.set, known[d]) for f in commands()] for d in (GX5, CV7)}
    differing = [f.full_name for f, one, other in zip(commands(), said[GX5], said[CV7], strict=True) if one != other]
    assert 0 < len(differing) < len(commands()) and shown(page) == differing
    address = page.run("location.search")
    assert address == f"?devices={GX5}%2C{CV7}&differences="
    links = page.run("[...document.querySelectorAll('p a')].map((a) => a.getAttribute('href')).slice(0, 4)")
    assert [link.rpartition("/")[2] for link in links] == [
        f"{name}.html{address}" for name in ("overview", "data", "rates", "meanings")
    ]
    open_(page, site, f"compare/commands.html{address}")
    assert shown(page) == differing
    page.run("document.querySelector('fieldset button').click()")
    assert len(columns(page)[0]) == 2 + sum(bool(d.certain) for d in model("real").devices)


def test_a_device_known_by_name_gets_a_column(page: browser.Page, site: Path) -> None:
    of = device("3dm-gx5-25")
    open_(page, site, f"compare/commands.html?devices={of.id}")
    sections = "[...document.querySelectorAll('table')].slice(0, -1)"  # the last one lists what such devices may have
    cells = page.run(
        f"Object.fromEntries({sections}.flatMap((table) => [...table.tBodies[0].rows].map((row) =>"
        " [row.querySelector('a').getAttribute('href').split('#')[1],"
        " [...row.cells].filter((cell) => !cell.hidden).at(-1).textContent])))"
    )
    said = {s.field.full_name: s.evidence.answer for s in of.supports} | {s.field.full_name: "no" for s in of.refuses}
    assert not of.certain and {"likely", "no"} <= {said.get(f.full_name) for f in commands()}
    assert cells == {f.full_name: said.get(f.full_name, "?") for f in commands()}
    open_(page, site, f"compare/rates.html?devices={of.id}")
    assert set(page.run(f"{ROWS}.map((row) => [...row.cells].filter((cell) => !cell.hidden).at(-1).textContent)")) == {
        "?"
    }


def test_where_devices_have_no_columns(page: browser.Page, site: Path) -> None:
    of = model("real")
    open_(page, site, f"compare/meanings.html?devices={GX5}")
    assert set(shown(page)) == {v.field.full_name for v in device(GX5).variants}
    choose(page, CV7)
    assert set(shown(page)) == {v.field.full_name for device_id in (GX5, CV7) for v in device(device_id).variants}
    assert len(of.devices) > 2


def test_keyboard(page: browser.Page, site: Path) -> None:
    """Typing, then the tab key: the check box for differences, the list of devices, its first box."""
    open_(page, site, "compare/commands.html")
    page.run("document.querySelector('input[type=search]').focus()")
    for letter in "pps":
        press(page, letter, ord(letter.upper()))
    wanted = [f.full_name for f in commands() if "pps" in f.title.lower()]
    assert shown(page)[: len(wanted)] == wanted and len(shown(page)) < len(commands())
    press(page, "Tab", 9)
    press(page, " ", 32)
    assert page.run("document.activeElement.checked")
    press(page, "Tab", 9)
    assert page.run("document.activeElement.tagName") == "SUMMARY"
    press(page, " ", 32)
    assert page.run("document.querySelector('details').open")
    press(page, "Tab", 9)
    press(page, " ", 32)
    assert page.run("document.activeElement.value") in page.run("location.search")
    page.run("window.kept = true; document.querySelector('input[type=search]').focus()")
    press(page, "\r", 13)
    assert page.run("window.kept")  # the page is not loaded again


def test_indexes_have_rows_only(page: browser.Page, site: Path) -> None:
    open_(page, site, "indexes/descriptors.html?filter=0x0D13")
    assert shown(page) == ["filter.antenna_offset"]
    assert page.run("document.querySelectorAll('form input').length") == 1
    open_(page, site, "indexes/names.html")
    type_(page, "PPS source control")
    assert shown(page)[0] == "3dm.pps_source_control"


def test_narrow(page: browser.Page, site: Path) -> None:
    page.size(390)
    open_(page, site, f"compare/commands.html?devices={GX5}")
    assert page.run("document.querySelector('form').getBoundingClientRect().right") <= 390
    page.size(1400)
