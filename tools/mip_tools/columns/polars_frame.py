"""Makes Polars data frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .frames import library, objects, titled
from .tables import Series


def made(series: Sequence[Series], units: bool) -> Any:
    """Makes a frame; missing values are null."""
    polars = library("polars")
    return polars.DataFrame([_column(polars, one, titled(one, units)) for one in series])


def _column(polars: Any, one: Series, name: str) -> Any:
    values, mask = one.values, one.mask
    if values.ndim > 1 or values.dtype == object:
        return polars.Series(name, objects(one))
    series = polars.Series(name, np.ascontiguousarray(values))
    if values.dtype.kind == "M":
        series = series.dt.replace_time_zone("UTC")
    return series if mask is None else series.scatter(np.flatnonzero(mask), None)
