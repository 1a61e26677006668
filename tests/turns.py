"""The longest tests take turns: `make test-all` and `make test-cross` run a quarter of those that turns.txt names."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

LONG = Path(__file__).with_suffix(".txt")
TURNS = 4


def lines() -> list[str]:
    """Returns the test files and test functions that turns.txt names, the longest first."""
    return [line for line in LONG.read_text("ascii").splitlines() if not line.startswith("#")]


def waiting(items: Iterable[pytest.Item], turn: int) -> list[pytest.Item]:
    """Returns the tests whose turn is another one. A file is one unit, because its tests share what takes long; of a
    test function, each set of parameters is a unit."""
    units: dict[str, dict[str, list[pytest.Item]]] = {line: {} for line in lines()}
    for item in items:
        if item.get_closest_marker("heavy") is None and item.get_closest_marker("cross") is None:
            continue
        test = item.nodeid.partition("[")[0]
        file = test.partition("::")[0]
        if test in units:
            units[test][item.nodeid] = [item]
        elif file in units:
            units[file].setdefault(file, []).append(item)
    one_by_one = [unit for line in units.values() for unit in line.values()]
    return [item for i, unit in enumerate(one_by_one) if i % TURNS != turn % TURNS for item in unit]
