"""Numbers of descriptor sets and fields as values of parameters: the set or field that such a number means."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mipgen import model as m


def set_of(p: m.Parameter, values: Mapping[str, Any], model: m.Model) -> int | None:
    """Returns the number of the set to which a parameter's field descriptors belong, given the record's values."""
    if p.fields_of in values:
        number = values[p.fields_of]
        return number if isinstance(number, int) else None
    named = model.set_named(p.fields_of)
    return named.number if named else None


def named_by_value(p: m.Parameter, value: int, set_number: int | None, model: m.Model) -> m.Set | m.Field | None:
    """Returns the data set or the field whose number is the value of a parameter, if that is known."""
    if p.shown == "set":
        data_set = model.set(value)
        return data_set if data_set is not None and data_set.kind == "data" else None
    if p.shown == "field" and set_number is not None:
        return next(iter(model.candidates(set_number, value)), None)
    return None


def hexadecimal(p: m.Parameter, value: int) -> str:
    """Writes a number in its usual notation, hexadecimal.

    >>> p = m.Parameter("a", m.SCALARS["u16"], None)
    >>> hexadecimal(p, 0x1F)
    '0x001F'
    """
    return f"0x{value:0{2 * p.size}X}"
