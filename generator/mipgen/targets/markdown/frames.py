"""Frames of reference: where their axes point, and the frames that other software uses."""

from __future__ import annotations

from collections.abc import Iterable

from mipgen import model as m

from .places import Page
from .text import code, inline, table


def directions(axes: Iterable[str]) -> str:
    """
    >>> directions(("prime_meridian", "east_meridian", "north_pole"))
    'prime meridian, east meridian, north pole'
    """
    return ", ".join(axis.replace("_", " ") for axis in axes)


def conversions(page: Page, model: m.Model) -> str:
    rows = [
        [
            page.link(f, code(f.symbol)),
            inline(c.title),
            directions(c.axes),
            code(", ".join(c.values)),
            page.prose(c.description),
        ]
        for f in model.protocol.frames
        for c in f.conversions
    ]
    return table(rows, ["From", "To", "x, y, z point", "Elements", "Other values"]) if rows else ""
