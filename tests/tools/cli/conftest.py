"""For devices whose time runs fast."""

from __future__ import annotations

import pytest
from mip_tools.simulator import live


@pytest.fixture(autouse=True)
def no_time_is_made_up_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a busy machine, a device that is 50 times as fast would have to send the data of a minute at once; that takes
    longer than a reply may, and then there is even more to make up for."""
    monkeypatch.setattr(live, "LATE", 0.005)
