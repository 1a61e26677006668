"""Frames of reference: drawings of their axes, and the frames of other software."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from mipgen import model as m

from ..places import Page
from ..text import code, inline, table


@dataclass(frozen=True)
class Units:
    """The page of units and frames."""

    page: Page

    @property
    def drawings(self) -> str:
        """All frames as images, each with a description."""
        return "\n".join(self.page.picture(x.path, x.words) for x in drawings(self.page.model))

    @property
    def conversions(self) -> str:
        rows = [
            [
                self.page.link(f, code(f.symbol)),
                inline(c.title),
                directions(c.axes),
                code(", ".join(c.values)),
                self.page.prose(c.description),
            ]
            for f in self.page.model.protocol.frames
            for c in f.conversions
        ]
        return table(rows, ["From", "To", "x, y, z point", "Elements", "Other values"])


def directions(axes: Iterable[str]) -> str:
    """
    >>> directions(("prime_meridian", "east_meridian", "north_pole"))
    'prime meridian, east meridian, north pole'
    """
    return ", ".join(axis.replace("_", " ") for axis in axes)


# --------------------------------------------------------------------------- drawings

#: Direction of an axis -> its direction on paper, seen from behind, above and the left.
PAPER = {
    "forward": (0.8, -0.5), "north": (0.8, -0.5), "prime_meridian": (-0.45, 0.7),
    "right": (0.8, 0.45), "east": (0.8, 0.45), "east_meridian": (0.45, 0.4),
    "down": (0.0, 0.9), "north_pole": (0.0, -0.95),
}  # fmt: skip
OPPOSITE = {"left": "right", "up": "down", "backward": "forward", "south": "north", "west": "east"}
CENTRE = (150, 105)
LENGTH = 80
COLOURS = {"x": "#b3261e", "y": "#1b6e3c", "z": "#1a56b0"}


@dataclass(frozen=True, slots=True)
class Arrow:
    """An axis of a drawing: its end, and the text there."""

    name: str
    direction: str
    x: int
    y: int
    text_x: int
    text_y: int
    anchor: str  # the alignment of the text
    colour: str


def arrows(axes: Iterable[str]) -> list[Arrow]:
    """Returns the axes of a frame on paper; none if one of them cannot be drawn."""
    ends = [_on_paper(axis) for axis in axes]
    if not all(ends):
        return []
    return [_arrow(name, axis, end) for name, axis, end in zip("xyz", axes, ends, strict=False) if end]


def _on_paper(axis: str) -> tuple[float, float] | None:
    opposite = PAPER.get(OPPOSITE.get(axis, ""))
    return (-opposite[0], -opposite[1]) if opposite else PAPER.get(axis)


def _arrow(name: str, axis: str, end: tuple[float, float]) -> Arrow:
    """
    >>> _arrow("z", "down", (0.0, 0.9))
    Arrow(name='z', direction='down', x=150, y=177, text_x=150, text_y=196, anchor='middle', \
colour='#1a56b0')
    """
    x, y = (round(centre + LENGTH * part) for centre, part in zip(CENTRE, end, strict=True))
    anchor = "start" if end[0] > 0 else "end" if end[0] < 0 else "middle"
    aside = {"start": 8, "end": -8, "middle": 0}[anchor]
    below = 4 if aside else 19 if end[1] > 0 else -10
    return Arrow(name, directions([axis]), x, y, x + aside, y + below, anchor, COLOURS[name])


@dataclass(frozen=True, slots=True)
class Drawing:
    """A frame that can be drawn."""

    name: str
    title: str
    axes: list[Arrow]

    @property
    def path(self) -> str:
        return f"docs/assets/frames/{self.name}.svg"

    @property
    def words(self) -> str:
        """What the picture shows."""
        return f"{inline(self.title)}: {', '.join(f'{a.name} {a.direction}' for a in self.axes)}"


def drawings(model: m.Model) -> list[Drawing]:
    """Returns the frames that can be drawn, then frames of other software."""
    frames = [(f.symbol, f.title, f.axes) for f in model.protocol.frames]
    others = {(c.title, c.axes) for f in model.protocol.frames for c in f.conversions}
    frames += [("-".join(axes), title, axes) for title, axes in sorted(others)]
    drawn = [Drawing(name, title, arrows(axes)) for name, title, axes in frames]
    return [drawing for drawing in drawn if drawing.axes]
