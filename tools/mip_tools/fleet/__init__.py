"""Many logs as one partitioned Parquet data set, decoded in parallel with Dask.

An interrupted run continues where it stopped, and no row is there twice: docs/fleet.md of mipgen.
"""

from __future__ import annotations

from .dataset import Fleet, Manifest
from .dataset import open_fleet as open
from .run import Built, build

__all__ = ["Built", "Fleet", "Manifest", "build", "open"]
