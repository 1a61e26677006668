"""Makes pandas data frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .frames import library, objects, titled
from .tables import Series


def made(series: Sequence[Series], units: bool) -> Any:
    """Makes a frame; missing values are NaN or NaT, and NA in columns of integers."""
    pandas = library("pandas")
    frame = pandas.DataFrame({titled(one, units): _column(pandas, one) for one in series})
    if series and series[0].name == "time":
        frame.attrs.update({name: fact for name, fact in series[0].facts.items() if name != "unit"})
    return frame


def _column(pandas: Any, one: Series) -> Any:
    values, mask = one.values, one.mask
    if values.ndim > 1 or values.dtype == object:
        return pandas.Series(objects(one), dtype=object)
    if values.dtype.kind == "M":
        return pandas.Series(values).dt.tz_localize("UTC")
    if mask is None or values.dtype.kind == "m":
        return pandas.Series(values)
    if values.dtype.kind == "f":
        return pandas.Series(np.where(mask, np.nan, values).astype(values.dtype))
    return pandas.Series(pandas.arrays.IntegerArray(np.array(values), np.array(mask)))
