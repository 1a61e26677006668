"""All tools as pages from disk: at three widths, without a server, with labels, and without findings of axe."""

from __future__ import annotations

import urllib.parse
from collections.abc import Iterator

import browser
import pytest
from support import SPECS, heavy
from workbench import tab, visit, workbench

pytestmark = heavy("Chromium")
TOOLS = ("bandwidth", "builder", "finder", "inspector", "live")

#: The fragments with which pages are opened that show little without.
SHOWN = {"finder": "#lever%20arm", "builder": "#3dm.event_action_config", "bandwidth": "#3dm-cv7-gnss-ins"}


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with tab() as opened:
        yield opened


@pytest.mark.parametrize("spec", sorted(SPECS))
@pytest.mark.parametrize("name", TOOLS)
def test_a_page(page: browser.Page, spec: str, name: str) -> None:
    page.complaints.clear()
    page.asked.clear()
    for width in (390, 1400, 1920):
        page.size(width)
        visit(page, name, SHOWN.get(name, ""), spec)
        page.run("document.querySelectorAll('details').forEach((part) => (part.open = true))")
        assert page.run("document.querySelector('#tool').children.length") > 0
        assert page.run("document.documentElement.scrollWidth") <= width
    assert page.complaints == []
    assert page.asked and all(url.startswith("file://") for url in page.asked)
    controls = "[...document.querySelectorAll('input, select, textarea')]"
    unnamed = f"{controls}.filter((one) => !one.labels.length && !one.ariaLabel).length"
    assert page.run(unnamed) == 0
    if name == "inspector":  # it begins with an example of this specification
        assert page.run("document.querySelectorAll('.mip-packet .mip-right').length") > 0
    links = page.run("[...document.querySelectorAll('nav a')].map((link) => link.getAttribute('href').split('#')[0])")
    assert links == [f"{name}.html" for name in TOOLS]
    assert all((workbench(spec) / link).is_file() for link in links)


@pytest.mark.parametrize("name", TOOLS)
def test_a_phone(page: browser.Page, name: str) -> None:
    """No control is off the screen, the navigation has one line, and the page is not long."""
    page.size(390)
    visit(page, name, {**IN_USE, "inspector": ""}[name])
    controls = "[...document.querySelectorAll('#tool :is(input, select, textarea, button)')]"
    off = "one.offsetParent && one.getBoundingClientRect().right > innerWidth"
    assert page.run(f"{controls}.filter((one) => {off}).map((one) => one.outerHTML)") == []
    assert page.run("document.querySelector('nav').clientHeight") < 60
    assert page.run("document.documentElement.scrollHeight") <= 2500


@pytest.mark.parametrize("fragment", ["%", "%E0%A4%A"])
@pytest.mark.parametrize("name", TOOLS)
def test_any_fragment_is_an_address(page: browser.Page, name: str, fragment: str) -> None:
    page.complaints.clear()
    visit(page, name, f"#{fragment}")
    assert page.run("document.querySelector('#tool').children.length") > 0
    assert page.complaints == []


#: What pages show when they are in use.
IN_USE = {
    "inspector": "#bytes=75650C04042801041B55+75650C0704F1280003A801B681+75650C0404F128032AFD",
    "builder": "#device=3dm-cv7-gnss-ins&packet=75650C0B0B0F01820204000A05000A300C",
    "bandwidth": "#device=3dm-gx5-15&streams=sensor.scaled_accel@100",
    "finder": "#find=lever%20arm",
    "live": "#device=3dm-gx5-15&streams=sensor.scaled_accel@100",
}


@heavy("Chromium and npm")
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", TOOLS)
def test_axe_finds_nothing(page: browser.Page, name: str, scheme: str) -> None:
    page.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    page.size(1400)
    visit(page, name, IN_USE[name])
    page.run("document.querySelectorAll('details:not(.mip-browse details)').forEach((part) => (part.open = true))")
    if name == "live":  # what is there after a connection
        page.run("document.querySelectorAll('#tool [hidden]').forEach((part) => (part.hidden = false))")
    page.run(f"{browser.axe()}; 0")
    found = page.run(
        "axe.run({ resultTypes: ['violations'] }).then(({ violations }) => violations.map(({ id, nodes }) =>"
        " `${id}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(' | ')}`))"
    )
    assert found == []


#: Tool -> the actions of a user, and a part of the address afterwards.
ACTS = {
    "inspector": (
        "put('#mip-bytes', '75 65 0C 04 04 28 01 04 1B 55'); put('#mip-device', '3dm-cv7-gnss-ins')",
        "bytes=75",
    ),
    "finder": ("put('#mip-find', 'lever arm')", "find=lever"),
    "builder": (
        "put('#mip-device', '3dm-cv7-gnss-ins'); put('#mip-field', '3dm.message_format');"
        " document.querySelector('.mip-hits button').click();"
        " put('.mip-hertz', '250'); put('#mip-field', '')",
        "packet=75650C0B",
    ),
    "bandwidth": (
        "put('#mip-stream-device', '3dm-cv7-gnss-ins');"
        " document.querySelector('[id=\"mip-stream-sensor.scaled_accel\"]').click();"
        " document.querySelector('[data-set=sensor]').open = true;"
        " put('[aria-label=\"Rate of Scaled accel in Hz\"]', '250')",
        "streams=sensor.scaled_accel@250",
    ),
    "live": ("put('#mip-serve', 'ws://127.0.0.1:9/abc'); document.querySelector('form button').click()", "serve=ws"),
}

#: What a user sees.
SEEN = """[
    [...document.querySelectorAll("#tool :is(input, select, textarea)")].map((one) => [one.id, one.value, one.checked]),
    document.querySelector("#tool").innerText.replace(/Not connected.*/s, ""),
]"""


@pytest.fixture(scope="module")
def other() -> Iterator[browser.Page]:
    """Another browser, with a profile of its own."""
    with tab() as opened:
        yield opened


@pytest.mark.parametrize("tool", sorted(ACTS))
def test_a_link_opens_the_same_in_another_browser(page: browser.Page, other: browser.Page, tool: str) -> None:
    acts, wanted = ACTS[tool]
    page.size(1400)
    other.size(1400)
    visit(page, tool)
    page.run(f"{acts}; pause(800)")  # the address follows
    link = page.run("location.href")
    assert wanted in urllib.parse.unquote(link), link
    other.open("about:blank")
    other.open(link)
    other.run("pause(300)")
    seen, again = page.run(SEEN), other.run(SEEN)
    search = {"mip-field", "mip-add"}  # the address keeps what is chosen there, not what is typed
    assert [x for x in again[0] if x[0] not in search] == [x for x in seen[0] if x[0] not in search]
    assert again[1] == seen[1]
    page.complaints.clear()  # nothing listens at the address that the live view was given
