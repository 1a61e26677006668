"""A page of the workbench in Chromium, for all tests of a module: that of its TOOL."""

from __future__ import annotations

from collections.abc import Iterator

import browser
import pytest
from workbench import tab, visit


@pytest.fixture(scope="module")
def page(request: pytest.FixtureRequest) -> Iterator[browser.Page]:
    with tab() as opened:
        visit(opened, request.module.TOOL)
        yield opened
        assert opened.complaints == []
        assert all(url.startswith(("file://", "about:")) for url in opened.asked), opened.asked
