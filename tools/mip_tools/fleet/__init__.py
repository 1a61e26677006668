"""Decodes many logs into one partitioned Parquet data set, in parallel.

A run continues where an interrupted one stopped, and no row is duplicated: see docs/fleet.md of mipgen.

`tests/tools/cli/test_fleet.py` kills workers and runs.
"""

from __future__ import annotations

from .dataset import Fleet, Manifest
from .dataset import open_fleet as open
from .run import Built, build_dataset

__all__ = ["Built", "Fleet", "Manifest", "build_dataset", "open"]
