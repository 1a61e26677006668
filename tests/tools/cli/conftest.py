"""Devices whose time is fast."""

from __future__ import annotations

import pytest
from mip_tools.simulator import live


@pytest.fixture(autouse=True)
def no_time_is_made_up_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """A device that is 50 times as fast would have to send what it sends in a minute at once, on a busy machine; that
    takes it longer than an answer may, and then there is more to make up for."""
    monkeypatch.setattr(live, "LATE", 0.005)
