"""All tools as pages from disk: at three widths, without a server, with labels, and without findings of axe."""

from __future__ import annotations

from collections.abc import Iterator

import browser
import pytest
from support import SPECS, heavy
from workbench import workbench

pytestmark = heavy("Chromium")
PAGES = ("bandwidth.html", "builder.html", "finder.html", "inspector.html", "live.html")

#: What a page shows at first, if that is little.
SHOWN = {
    "finder.html": "#lever%20arm",
    "builder.html": "#3dm.event_action_config",
    "bandwidth.html": "#3dm-cv7-gnss-ins",
}


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with browser.page() as opened:
        yield opened


@pytest.mark.parametrize("spec", sorted(SPECS))
@pytest.mark.parametrize("name", PAGES)
def test_a_page(page: browser.Page, spec: str, name: str) -> None:
    page.complaints.clear()
    page.asked.clear()
    for width in (390, 1400, 1920):
        page.size(width)
        page.open("about:blank")  # another fragment alone loads nothing
        page.open((workbench(spec) / name).as_uri() + SHOWN.get(name, ""))
        page.run("document.querySelectorAll('details').forEach((part) => (part.open = true))")
        assert page.run("document.querySelector('#tool').children.length") > 0
        assert page.run("document.documentElement.scrollWidth") <= width
    assert page.complaints == []
    assert page.asked and all(url.startswith("file://") for url in page.asked)
    controls = "[...document.querySelectorAll('input, select, textarea')]"
    unnamed = f"{controls}.filter((one) => !one.labels.length && !one.ariaLabel).length"
    assert page.run(unnamed) == 0
    if name == "inspector.html":  # it begins with an example of this specification
        assert page.run("document.querySelectorAll('.mip-packet .mip-right').length") > 0
    links = page.run("[...document.querySelectorAll('nav a')].map((link) => link.getAttribute('href').split('#')[0])")
    assert links == list(PAGES)
    assert all((workbench(spec) / link).is_file() for link in links)


@pytest.mark.parametrize("fragment", ["%", "%E0%A4%A"])
@pytest.mark.parametrize("name", PAGES)
def test_any_fragment_is_an_address(page: browser.Page, name: str, fragment: str) -> None:
    page.complaints.clear()
    page.open("about:blank")
    page.open((workbench("real") / name).as_uri() + "#" + fragment)
    assert page.run("document.querySelector('#tool').children.length") > 0
    assert page.complaints == []


#: What pages show when they are in use.
IN_USE = {
    "inspector.html": "#bytes=75650C04042801041B55+75650C0704F1280003A801B681+75650C0404F128032AFD",
    "builder.html": "#device=3dm-cv7-gnss-ins&packet=75650C0B0B0F01820204000A05000A300C",
    "bandwidth.html": "#device=3dm-gx5-15&streams=sensor.scaled_accel@100",
    "finder.html": "#find=lever%20arm",
    "live.html": "#device=3dm-gx5-15&streams=sensor.scaled_accel@100",
}


@heavy("Chromium and npm")
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", PAGES)
def test_axe_finds_nothing(page: browser.Page, name: str, scheme: str) -> None:
    page.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
    page.size(1400)
    page.open("about:blank")
    page.open((workbench("real") / name).as_uri() + IN_USE[name])
    page.run("document.querySelectorAll('details:not(.mip-browse details)').forEach((part) => (part.open = true))")
    if name == "live.html":  # what is there after a connection
        page.run("document.querySelectorAll('#tool [hidden]').forEach((part) => (part.hidden = false))")
    page.run(f"{browser.axe()}; 0")
    found = page.run(
        "axe.run({ resultTypes: ['violations'] }).then(({ violations }) => violations.map(({ id, nodes }) =>"
        " `${id}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 160)).join(' | ')}`))"
    )
    assert found == []
