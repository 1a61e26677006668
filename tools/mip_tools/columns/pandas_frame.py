"""Frames of pandas."""

from __future__ import annotations

from typing import Any

import numpy as np

from .frames import Series, library, objects, titled
from .general import Ragged


def made(series: list[Series], units: bool) -> Any:
    """A frame; what is missing is NaN or NaT, in integers NA."""
    pandas = library("pandas")
    return pandas.DataFrame({titled(one, units): _column(pandas, one) for one in series})


def _column(pandas: Any, one: Series) -> Any:
    values, mask = one.values, one.mask
    if isinstance(values, Ragged) or values.ndim > 1 or values.dtype == object:
        return pandas.Series(objects(one), dtype=object)
    if values.dtype.kind == "M":
        return pandas.Series(values).dt.tz_localize("UTC")
    if mask is None:
        return pandas.Series(values)
    if values.dtype.kind == "f":
        return pandas.Series(np.where(mask, np.nan, values).astype(values.dtype))
    return pandas.Series(pandas.arrays.IntegerArray(np.array(values), np.array(mask)))
