"""All tools as pages from disk: at three widths, without a server, and with labels."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import browser
import pytest
from support import SPECS, heavy

pytestmark = [] if browser.installed() else heavy("chromium")
PAGES = sorted((SPECS["real"][1] / "javascript/tools").glob("*.html"))


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with browser.page() as opened:
        yield opened


@pytest.mark.parametrize("spec", sorted(SPECS))
@pytest.mark.parametrize("name", [path.name for path in PAGES])
def test_a_page(page: browser.Page, spec: str, name: str) -> None:
    page.complaints.clear()
    page.asked.clear()
    for width in (390, 1400, 1920):
        page.size(width)
        page.open(SPECS[spec][1] / "javascript/tools" / name)
        assert page.run("document.querySelector('#tool').children.length") > 0
        assert page.run("document.documentElement.scrollWidth") <= width
    assert page.complaints == []
    assert page.asked and all(url.startswith("file://") for url in page.asked)
    unnamed = "[...document.querySelectorAll('input, select, textarea')].filter((one) => !one.labels.length).length"
    assert page.run(unnamed) == 0
    links = page.run("[...document.querySelectorAll('nav a')].map((link) => link.getAttribute('href'))")
    assert links == [path.name for path in PAGES]
    assert all((Path(SPECS[spec][1]) / "javascript/tools" / link).is_file() for link in links)
