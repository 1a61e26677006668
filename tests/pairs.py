"""Options of a test, combined in pairs."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations, product
from typing import Any

import pytest
from support import nightly

#: The places of two values: which option, and which of its values.
Pair = tuple[tuple[int, int], ...]


def pairwise(indirect: Iterable[str] = (), **options: Iterable[Any]) -> pytest.MarkDecorator:
    """Parametrizes a test so that each value of an option meets each value of every other one, in as few sets as this
    takes; `make nightly` has the other sets, too."""
    axes = [list(values) for values in options.values()]
    every = list(product(*(range(len(axis)) for axis in axes)))
    missing = {pair for one in every for pair in _pairs(one)}
    chosen = set()
    while missing:
        best = max(every, key=lambda one: len(_pairs(one) & missing))
        missing -= _pairs(best)
        chosen.add(best)
    rest = nightly("all combinations of options, not each two of them alone")
    sets = [
        pytest.param(*(axis[i] for axis, i in zip(axes, one)), marks=() if one in chosen else rest) for one in every
    ]
    return pytest.mark.parametrize(list(options), sets, indirect=list(indirect))


def _pairs(one: Iterable[int]) -> set[Pair]:
    return set(combinations(enumerate(one), 2))
