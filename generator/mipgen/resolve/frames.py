"""Frames of reference: the directions of their axes, and the conversion of vectors to other conventions."""

from __future__ import annotations

from mipgen import model as m
from mipgen.read.nodes import Node
from mipgen.read.problems import Problems

from .vocabulary import Vocabulary, sources_of_node

#: Groups of parallel or perpendicular directions, each with the number of its line, negative for the opposite one.
#: The first three of a group are right-handed.
GROUPS = (
    {"forward": 1, "right": 2, "down": 3, "backward": -1, "left": -2, "up": -3},
    {"north": 1, "east": 2, "down": 3, "south": -1, "west": -2, "up": -3},
    {"prime_meridian": 1, "east_meridian": 2, "north_pole": 3},
)

#: The right-handed orders of three lines, if an even number of directions is negative.
EVEN = ([1, 2, 3], [2, 3, 1], [3, 1, 2])


def resolve(node: Node, vocabulary: Vocabulary, problems: Problems) -> tuple[m.Word, ...]:
    return tuple(_frame(symbol, n, vocabulary, problems) for symbol, n in node.items())


def _frame(symbol: str, node: Node, vocabulary: Vocabulary, problems: Problems) -> m.Word:
    axes = _axes(node, problems) if "axes" in node else ()
    if "conversions" in node and "axes" not in node:
        problems.add(node.keys["conversions"], f"'{symbol}' has no axes, so vectors cannot be converted; add 'axes'")
    return m.Word(
        symbol,
        node["title"].value,
        node.scalar("description", ""),
        elements=tuple(node["elements"].plain()) if "elements" in node else (),
        axes=axes,
        origin=node.scalar("origin", ""),
        conversions=tuple(
            _conversion(name, n, axes, problems)
            for name, n in (node["conversions"].items() if "conversions" in node else ())
        ),
        sources=sources_of_node(node, vocabulary, problems),
    )


def _axes(node: Node, problems: Problems) -> tuple[str, ...]:
    """Resolves axes: three directions that are perpendicular and right-handed."""
    listed = node["axes"]
    axes = tuple(listed.plain())
    lines = next(([g[a] for a in axes] for g in GROUPS if g.keys() >= {*axes}), None)
    order = [abs(line) for line in lines or ()]
    if lines is None or sorted(order) != [1, 2, 3]:
        groups = "; ".join(", ".join(g) for g in GROUPS)
        problems.add(listed.position, f"axes must be three perpendicular directions from one of these groups: {groups}")
        return ()
    if (order in EVEN) != (sum(line < 0 for line in lines) % 2 == 0):
        problems.add(listed.position, f"the axes {', '.join(axes)} are left-handed; reverse one of them")
    return axes


def _conversion(name: str, node: Node, axes: tuple[str, ...], problems: Problems) -> m.Conversion:
    """Resolves a conversion: each element in the other frame is one in this frame, perhaps negated."""
    own, values = _axes(node, problems), list[str]()
    group = next((g for g in GROUPS if g.keys() >= {*axes, *own}), {})
    if own and axes and not group:
        problems.add(node["axes"].position, f"'{name}' and its frame have no directions in common")
    for axis in own if axes and group else ():
        at = [abs(group[a]) for a in axes].index(abs(group[axis]))
        values.append(("" if axes[at] == axis else "-") + "xyz"[at])
    return m.Conversion(name, node["title"].value, own, tuple(values), node.scalar("description", ""))
