"""The full-screen view of `mip monitor`."""

from __future__ import annotations

import argparse
import asyncio
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from mip_protocol import PacketBuilder
from mip_tools.errors import Failure
from mip_tools.logs.scan import Piece, Scanner
from mip_tools.monitor.latest import Latest
from mip_tools.names.selection import Selection
from program import PATIENCE, log
from support import heavy


def view(events: list[Any], end: Failure | None = None) -> Any:
    """The view with these events: bytes that arrive, texts of notices, and waiting until one is set."""
    from mip_tools.monitor.screen import MonitorScreen

    def pieces(options: argparse.Namespace, latest: Latest, say: Callable[[str], object]) -> Iterator[Piece | None]:
        scanner = Scanner()
        for event in events:
            if isinstance(event, bytes):
                yield from scanner.feed(event)
            elif isinstance(event, str):
                say(event)
            else:
                event.wait(PATIENCE)
            yield None
        if end is not None:
            raise end

    options = argparse.Namespace(input="port", rate=20.0)
    return MonitorScreen(options, Latest(Selection(), None), pieces)


@pytest.mark.parametrize(("timed", "rate"), [(True, "100 Hz"), (False, "50 Hz")])
def test_the_rate_is_that_of_the_device(timed: bool, rate: str) -> None:
    """Packets may arrive in bursts; only without a time do arrivals count."""
    latest = Latest(Selection(["sensor.scaled_accel"]), None)
    packets = [p.packet for p in Scanner().feed(log(1.0)) if p.packet is not None and p.packet.set == 0x80]
    for i, packet in enumerate(packets):
        builder = PacketBuilder(packet.set)
        for raw in packet:
            if timed or raw.descriptor == 0x04:
                builder.add(raw.descriptor, raw.data)
        latest.add(Piece(0, b"", builder.build()), 0.1 * (i // 5) if timed else 0.02 * i)
    (one,) = latest.shown(0.02 * len(packets))
    assert (one.name, one.hertz, one.old) == ("scaled_accel", rate, "")


async def seen(pilot: Any, true: Callable[[], bool]) -> None:
    limit = time.monotonic() + PATIENCE
    while not true():
        assert time.monotonic() < limit
        await pilot.pause(0.02)


@heavy("textual")
def test_what_the_keys_do() -> None:
    from textual.widgets import DataTable, Static

    more, done = threading.Event(), threading.Event()
    app = view([log(0.5), "no data for 2 s", more, log(1.0), done])

    async def session() -> None:
        async with app.run_test(size=(120, 12)) as pilot:
            table = app.query_one(DataTable)

            def cells() -> list[list[str]]:
                return [[str(cell) for cell in table.get_row_at(i)] for i in range(table.row_count)]

            def values() -> list[list[str]]:
                return [[*row[:2], row[4]] for row in cells()]

            def said() -> str:
                return str(app.query_one("#said", Static).content)

            await seen(pilot, lambda: "no data for 2 s" in said())
            every = values()
            accel = next(row for row in cells() if row[1] == "scaled_accel")
            assert accel[0] == "sensor" and accel[2].endswith(" Hz") and accel[4].startswith("scaled_accel = (x=")
            assert len(every) > 12  # more than fit; the table learns it when it is laid out
            await seen(pilot, lambda: table.max_scroll_y > 0)
            await pilot.press("pagedown", "pagedown")
            await seen(pilot, lambda: table.scroll_y > 0)
            await pilot.press("slash", *"gyro", "enter")
            await seen(pilot, lambda: [row[1] for row in cells()] == ["scaled_gyro"])
            await pilot.press("escape")
            await seen(pilot, lambda: values() == every)
            await pilot.press("space")
            before = said().partition(" packets")[0]
            more.set()
            await seen(pilot, lambda: said().partition(" packets")[0] != before and " · held" in said())
            assert values() == every and "no data" not in said()
            await pilot.press("space")
            await seen(pilot, lambda: values() != every)
            await pilot.press("q")

    asyncio.run(session())
    assert app.failure is None and app._latest.packets > 100
    done.set()


@heavy("textual")
def test_old_values_are_marked_and_a_lost_port_ends_it(monkeypatch: pytest.MonkeyPatch) -> None:
    from mip_tools.monitor import latest
    from textual.widgets import DataTable

    monkeypatch.setattr(latest, "STALE", 0.2)
    done = threading.Event()
    app = view([log(0.2), done], Failure("port was closed"))

    async def session() -> None:
        async with app.run_test() as pilot:
            table = app.query_one(DataTable)
            await seen(pilot, lambda: table.row_count > 0 and "s ago" in str(table.get_row_at(0)[3]))
            assert table.get_row_at(0)[2] == ""
            done.set()
            await seen(pilot, lambda: app.failure is not None)

    asyncio.run(session())
    assert str(app.failure) == "port was closed"
