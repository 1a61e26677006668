"""Which specification a test of the drivers is run with."""

from __future__ import annotations

from typing import Any

import pytest
from support import NIGHTLY, SPECS, offering


def each_of_the_small_one(*operations: str) -> Any:
    """For every language, with the small specification, which has all kinds of layouts; at night with the real one."""

    def mark(test: Any) -> Any:
        test = pytest.mark.parametrize("language", offering(*operations))(test)
        return pytest.mark.parametrize("spec", sorted(SPECS) if NIGHTLY else ["invented"])(test)

    return mark
