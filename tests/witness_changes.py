"""Changes one fact of the specification at a time, at random, and counts which changes `make check` finds.

    python tests/witness_changes.py [COUNT [SEED]]

Kinds take turns. A change is found by the validation of the specification, or else by a witness.
"""

from __future__ import annotations

import itertools
import random
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "generator"))

from mipgen.audit import witnesses  # noqa: E402
from mipgen.read import loader  # noqa: E402
from mipgen.read.documents import Document  # noqa: E402
from mipgen.read.nodes import Node  # noqa: E402
from mipgen.read.problems import Problems, SpecError  # noqa: E402
from mipgen.resolve import load  # noqa: E402

#: Scalars of the same size and another meaning.
SIGNS = {f"{a}{n}": f"{b}{n}" for a, b in (("u", "s"), ("s", "u")) for n in (8, 16, 32, 64)} | {
    "float": "u32",
    "double": "u64",
    "bool": "s8",
}


@dataclass(frozen=True)
class Place:
    """A fact: its kind, its node, and how to change it."""

    kind: str
    node: Node
    change: Callable[[random.Random], object]  # the new value of the node

    def __str__(self) -> str:
        return f"{self.kind} at {self.node.position.file}:{self.node.position.line}"


@cache
def documents() -> tuple[Document, ...]:
    problems = Problems()
    found = loader.load(ROOT / "spec", (), problems)
    problems.raise_if_any()
    return tuple(found)


def places() -> list[Place]:
    roots = [d.root for d in documents() if d.kind in ("set", "types")]
    protocol = next(d.root for d in documents() if d.kind == "protocol")
    units = [u for u in protocol["units"].value if u != "1"]
    frames = list(protocol["frames"].value)
    return [place for root in roots for place in _places(root, units, frames)]


def _places(node: Node, units: list[str], frames: list[str]) -> Iterator[Place]:
    if isinstance(node.value, list):
        yield from _order(node)
        for child in node:
            yield from _places(child, units, frames)
    if not isinstance(node.value, dict):
        return
    if "name" in node and ("type" in node or "reserved" in node):
        yield from _parameter(node, units, frames)
    if "enum" in node and "values" in node:
        numbers = {_number(v) for _, v in node["values"].items()}
        for _, value in node["values"].items():
            yield Place("value", value.get("value") or value, _another(numbers))
    if "bitfield" in node and "bits" in node:
        taken = {b["bit"].value for _, b in node["bits"].items() if "bit" in b}
        for _, bit in node["bits"].items():
            if "bit" in bit:
                yield Place("bit", bit["bit"], _another(taken))
    for _, child in node.items():
        yield from _places(child, units, frames)


def _number(value: Node) -> int:
    return int(value["value"].value if "value" in value else value.value)


def _another(taken: set[int]) -> Callable[[random.Random], object]:
    """The next unused number: as if one had been left out."""
    return lambda choice: next(n for n in itertools.count(choice.choice(sorted(taken))) if n not in taken)


def _order(node: Node) -> Iterator[Place]:
    """Neighbours in a list of parameters that are exchanged."""
    items = node.value
    for i, (a, b) in enumerate(itertools.pairwise(items)):
        if all("name" in x and "type" in x and "count" not in x for x in (a, b)):
            yield Place("order", node, lambda _, i=i: [*items[:i], items[i + 1], items[i], *items[i + 2 :]])


def _parameter(node: Node, units: list[str], frames: list[str]) -> Iterator[Place]:
    for key, others in (("unit", units), ("frame", frames)):
        if key in node and isinstance(node[key].value, str):
            yield Place(key, node[key], _other(others, node[key].value))
    if "type" in node and node["type"].value in SIGNS:
        yield Place("sign", node["type"], lambda _: SIGNS[node["type"].value])
    if "for" in node:
        yield Place("for", node["for"], lambda choice: _letters(node["for"].value, choice))
    if "count" in node and isinstance(node["count"].value, int):
        yield Place("count", node["count"], lambda choice: node["count"].value + choice.choice((-1, 1)) or 2)
    for key in ("above", "below"):
        if key in node:
            yield Place("range", node[key], lambda choice, key=key: node[key].value + choice.choice((-1, 1)))
    if "range" in node:
        for end in node["range"]:
            if end.value is not None:
                yield Place("range", end, lambda choice, end=end: end.value + choice.choice((-1, 1)))
    default = node.get("default")
    if default is not None and isinstance(default.value, bool):
        yield Place("default", default, lambda _: not default.value)
    elif default is not None and isinstance(default.value, (int, float)):
        yield Place("default", default, lambda _: default.value + 1)
    elif default is not None and isinstance(default.value, str):
        yield Place("default", default, _other(sorted(names_beside("values", default.value)), default.value))
    if "valid" in node and isinstance(node["valid"].value, str):
        flags, _, bit = node["valid"].value.partition(".")
        others = sorted(names_beside("bits", bit))
        yield Place("valid", node, lambda _: {k: v for k, v in node.items() if k != "valid"})
        if others:
            yield Place("valid", node["valid"], lambda choice: f"{flags}.{choice.choice(others)}")


def _other(names: list[str], name: str) -> Callable[[random.Random], object]:
    return lambda choice: choice.choice([x for x in names if x != name])


def _letters(letters: str, choice: random.Random) -> str:
    changed = choice.choice("WRSLD")
    return "".join(x for x in "WRSLD" if (x in letters) != (x == changed)) or "R"


@cache
def names_beside(key: str, name: str) -> frozenset[str]:
    """The other bits, or values, of the types that have a bit or value of this name."""
    found: set[str] = set()
    for root in (d.root for d in documents() if d.kind in ("set", "types")):
        for _, entry in root["types"].items() if "types" in root else ():
            if key in entry and name in entry[key]:
                found |= {other for other, _ in entry[key].items()}
    return frozenset(found - {name})


@contextmanager
def changed(place: Place, choice: random.Random) -> Iterator[None]:
    before = place.node.value
    place.node.value = place.change(choice)
    try:
        yield
    finally:
        place.node.value = before


def finder() -> str:
    """What finds a mistake in the current specification: validation, a witness, or nothing."""
    problems = Problems()
    try:
        model = load.resolve(documents(), problems)
        problems.raise_if_any()
    except SpecError:
        return "validation"
    return "witness" if witnesses.audit(model, ROOT / "spec/witness").lines() else ""


def run(count: int, seed: int) -> list[tuple[Place, str]]:
    """Random changes, each with what found it."""
    choice = random.Random(seed)
    every = places()
    kinds = sorted({p.kind for p in every})
    found = []
    for number in range(count):
        place = choice.choice([p for p in every if p.kind == kinds[number % len(kinds)]])
        with changed(place, choice):
            found.append((place, finder()))
    return found


def main(count: str = "200", seed: str = "1") -> None:
    found = run(int(count), int(seed))
    print(*(f"not found: {place}" for place, by in found if not by), sep="\n")
    for kind in sorted({p.kind for p, _ in found}):
        by = Counter(by for place, by in found if place.kind == kind)
        print(f"{kind:8} {by['validation']:3} by validation, {by['witness']:3} by a witness, {by['']:3} not found")
    print(f"{sum(bool(by) for _, by in found)} of {len(found)} changes are found, seed {seed}")


if __name__ == "__main__":
    main(*sys.argv[1:])
