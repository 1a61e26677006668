"""The different values of a column, in each state on which the meaning of their bits depends."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..binding import info
from .scan import Array

if TYPE_CHECKING:
    from .column import Column


def different(column: Column[Any], path: str, values: Array) -> tuple[list[tuple[Any, Any]], Array]:
    """Returns each different value of a parameter, with an object that has the attributes on which the meaning of its
    bits depends, and for each row the number of its value in this list."""
    numbers, place = _different(values)
    columns = [numbers]
    attributes = []
    for attribute, other in _states(column, path).items():
        states, state = _different(other)
        pairs, place = np.unique(place * len(states) + state, return_inverse=True)
        before, after = np.divmod(pairs, max(len(states), 1))
        columns = [*(one[before] for one in columns), states[after]]
        attributes.append(attribute)
    rows = zip(*(one.tolist() for one in columns))
    return [(value, SimpleNamespace(**dict(zip(attributes, states)))) for value, *states in rows], place.reshape(-1)


def _different(values: Array) -> tuple[Array, Array]:
    numbers, place = np.unique(values, return_inverse=True)
    return numbers, place.reshape(-1)


def _states(column: Column[Any], path: str) -> dict[str, Array]:
    """Returns the values on which the meaning of a parameter's bits depends, by attribute."""
    kind = column.parameters[path].type
    bits = getattr(info(kind), "states", {}) if kind is not None else {}
    attributes = sorted({attribute for attribute, _ in bits.values()})
    return {
        attribute: np.asarray(column[at])
        for attribute in attributes
        if (at := _beside(path, attribute)) in column.parameters
    }


def in_state(column: Column[Any], path: str, bit: Any) -> Array | bool:
    """Finds the rows in which a bit of a parameter has its meaning."""
    if bit.state is None:
        return True
    attribute, numbers = bit.state
    return np.isin(np.asarray(column[_beside(path, attribute)]), numbers)


def _beside(path: str, attribute: str) -> str:
    """Returns the path of another parameter of the same record."""
    return f"{path.rpartition('.')[0]}.{attribute}".lstrip(".")
