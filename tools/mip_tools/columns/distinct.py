"""Distinct values of arrays that are usually sorted, such as offsets, packets and times."""

from __future__ import annotations

import numpy as np

from .scan import Array


def distinct(*parts: Array) -> Array:
    """Returns the values of some arrays of integers, sorted, each once.

    `numpy.unique` hashes since NumPy 2.3, which takes 300 times as long as comparing neighbours does.
    """
    others = [part for part in parts[1:] if not np.array_equal(part, parts[0])]  # often, all are the same
    values = np.concatenate((parts[0], *others)) if others else parts[0]
    if not (values[1:] >= values[:-1]).all():
        values = np.sort(values, kind="stable")  # merges parts that are sorted
    new = np.ones(len(values), bool)
    np.not_equal(values[1:], values[:-1], out=new[1:])
    return values if new.all() else np.compress(new, values)


def taken(values: Array, rows: Array) -> Array:
    """Returns some of the values; `rows` has each number at most once, in order, and often all of them."""
    return values if len(rows) == len(values) else values[rows]


def places_among(sorted_values: Array, values: Array) -> Array:
    """Returns the place of each value, all of which are among the sorted values. Often, both are the same."""
    if np.array_equal(sorted_values, values):
        return np.arange(len(values))
    return np.searchsorted(sorted_values, values)
