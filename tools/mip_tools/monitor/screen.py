"""The full-screen view of `mip monitor`, with Textual."""

from __future__ import annotations

import argparse
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any, ClassVar

from textual.app import App, ComposeResult
from textual.binding import Binding
from textual.coordinate import Coordinate
from textual.widgets import DataTable, Footer, Input, Static

from ..errors import Failure
from ..logs.scan import Piece
from ..text import show
from .latest import Latest, Shown

Pieces = Callable[[argparse.Namespace, Latest, Callable[[str], object] | None], Iterator[Piece | None]]


def fill(options: argparse.Namespace, latest: Latest, pieces: Pieces) -> None:
    """Shows what arrives until the user ends it or the time is over. Raises Failure."""
    screen = MonitorScreen(options, latest, pieces)
    screen.run()
    if screen.failure is not None:
        raise screen.failure


class MonitorScreen(App[None]):
    """Shows a row for each value: its field, the value, its rate, and its age."""

    CSS = """
    #said { height: 1; background: $panel; padding: 0 1; }
    #filter { display: none; height: 3; }
    #filter.on { display: block; }
    DataTable { height: 1fr; }
    """
    BINDINGS: ClassVar[list[Any]] = [
        ("q", "quit", "Quit"),
        ("slash", "filter", "Filter"),
        ("escape", "clear", "All"),
        ("space", "hold", "Hold"),
        Binding("ctrl+c", "quit", show=False, priority=True),
    ]
    ENABLE_COMMAND_PALETTE = False

    def __init__(self, options: argparse.Namespace, latest: Latest, pieces: Pieces) -> None:
        super().__init__()
        self._options, self._latest, self._pieces = options, latest, pieces
        self._lock = threading.Lock()
        self._over = False  # the view is closed
        self._on_hold = False
        self._notice = ""
        self._rows: list[tuple[str, ...]] = []
        self.failure: Failure | None = None

    def compose(self) -> ComposeResult:
        yield Static(id="said", markup=False)
        yield Input(id="filter", placeholder="part of a name or a value; Enter keeps it, Escape shows all")
        yield DataTable(cursor_type="row", zebra_stripes=True)
        yield Footer()

    def on_mount(self) -> None:
        table = self.query_one(DataTable)
        table.add_columns("Set", "Field", "Rate", "Age", "Value")
        table.focus()
        self.set_interval(1 / self._options.rate, self.draw)
        threading.Thread(target=self._receive, daemon=True).start()

    def on_unmount(self) -> None:
        self._over = True

    def _receive(self) -> None:
        try:
            for piece in self._pieces(self._options, self._latest, self._say):
                if self._over:
                    return
                if piece is not None:
                    with self._lock:
                        self._latest.add(piece, time.monotonic())
                    if piece.packet is not None:
                        self._notice = ""
        except Failure as failure:
            self.failure = failure
        if not self._over:
            self.call_from_thread(self.exit)

    def _say(self, text: str) -> None:
        self._notice = text

    def draw(self) -> None:
        """Shows the latest values."""
        hold_mark = " · held" if self._on_hold else ""
        self.query_one("#said", Static).update(
            f"{self._options.input}: {self._latest.summary}{hold_mark}{' · ' + self._notice if self._notice else ''}"
        )
        if self._on_hold:
            return
        with self._lock:
            fields = list(self._latest.shown(time.monotonic()))
        wanted = self.query_one("#filter", Input).value.lower()
        self._show([row for shown in fields for row in _rows(shown) if wanted in " ".join(row).lower()])

    def _show(self, rows: list[tuple[str, ...]]) -> None:
        """Replaces only what has changed, so that the cursor and the view stay where they are."""
        table = self.query_one(DataTable)
        while len(self._rows) > len(rows):
            self._rows.pop()
            table.remove_row(str(len(self._rows)))
        for i, row in enumerate(rows):
            if i == len(self._rows):
                table.add_row(*row, key=str(i))
                self._rows.append(row)
            elif row != self._rows[i]:
                for j, (old, new) in enumerate(zip(self._rows[i], row)):
                    if old != new:
                        table.update_cell_at(Coordinate(i, j), new, update_width=True)
                self._rows[i] = row

    def action_filter(self) -> None:
        """Opens the input for a filter: a part of a name or a value."""
        wanted = self.query_one("#filter", Input)
        wanted.add_class("on")
        wanted.focus()

    def action_clear(self) -> None:
        """Removes the filter."""
        wanted = self.query_one("#filter", Input)
        wanted.value = ""
        wanted.remove_class("on")
        self.query_one(DataTable).focus()

    def action_hold(self) -> None:
        """Pauses the values, or resumes them."""
        self._on_hold = not self._on_hold
        self.draw()

    def on_input_changed(self) -> None:
        self.draw()

    def on_input_submitted(self) -> None:
        self.query_one(DataTable).focus()


def _rows(shown: Shown) -> Iterator[tuple[str, ...]]:
    """Yields a row for each of the values; the first also describes the field."""
    for i, value in enumerate(shown.values or [""]):
        set_number = show.set_name(shown.set)
        yield set_number, shown.name, shown.hertz if i == 0 else "", shown.old, value
