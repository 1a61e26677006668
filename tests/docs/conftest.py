from __future__ import annotations

from collections.abc import Iterator

import browser
import pytest
from reference import Manual, manual_of
from support import SPECS


@pytest.fixture(params=sorted(SPECS))
def manual(request: pytest.FixtureRequest) -> Manual:
    return manual_of(request.param)


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    """A tab without network: anything that is not on disk is missed."""
    with browser.page() as opened:
        opened.call(
            "Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=-1, uploadThroughput=-1
        )
        yield opened
        assert opened.complaints == []
        asked = [url for url in opened.asked if not url.startswith(("data:", "about:"))]
        assert asked and all(url.startswith("file://") for url in asked), asked
