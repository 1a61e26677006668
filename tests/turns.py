"""The longest tests take turns: a run of `make test`, `make test-all` or `make test-cross` has some of those that
turns.txt names."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

LONG = Path(__file__).with_suffix(".txt")
#: The number of runs that have each of them once.
TURNS = 6


def sections() -> dict[str, list[str]]:
    """Returns the test files and test functions that turns.txt names for each target of make, the longest first."""
    found: dict[str, list[str]] = {}
    for line in LONG.read_text("ascii").splitlines():
        if line.startswith("["):
            named = found[line.strip("[]")] = []
        elif not line.startswith("#"):
            named.append(line)
    return found


def waiting(items: Iterable[pytest.Item], turn: int) -> list[pytest.Item]:
    """Returns the tests whose turn is another one. A file is one unit, because its tests share what takes long; of a
    test function, each set of parameters is a unit."""
    units: dict[tuple[str, str], dict[str, list[pytest.Item]]] = {
        (target, line): {} for target, lines in sections().items() for line in lines
    }
    for item in items:
        light = item.get_closest_marker("heavy") is None and item.get_closest_marker("cross") is None
        target = "test" if light else "test-all"
        test = item.nodeid.partition("[")[0]
        file = test.partition("::")[0]
        if (target, test) in units:
            units[target, test][item.nodeid] = [item]
        elif (target, file) in units:
            units[target, file].setdefault(file, []).append(item)
    one_by_one = [unit for line in units.values() for unit in line.values()]
    return [item for i, unit in enumerate(one_by_one) if i % TURNS != turn % TURNS for item in unit]
