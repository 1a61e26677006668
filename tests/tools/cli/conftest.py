"""For devices whose time runs fast, and for machines that are busy."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from mip_protocol import device
from mip_simulator import live
from program import PATIENCE

#: The functions whose default is the time-out for replies.
PATIENT: list[Any] = [device.open_port, device.Device.__init__]


@pytest.fixture(autouse=True)
def no_time_is_made_up_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a busy machine, a device that is 50 times as fast would have to send the data of a minute at once; that takes
    longer than a reply may, and then there is even more to make up for."""
    monkeypatch.setattr(live, "LATE", 0.005)


@pytest.fixture(autouse=True, scope="session")
def replies_may_take_long() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        for function in PATIENT:
            patch.setitem(function.__kwdefaults__, "timeout", PATIENCE)
        yield


@pytest.fixture
def no_reply_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    for function in PATIENT:
        monkeypatch.setitem(function.__kwdefaults__, "timeout", 0.5)
