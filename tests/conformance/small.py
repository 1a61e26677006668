"""Which specification a test of the drivers is run with."""

from __future__ import annotations

from typing import Any

import pytest
from support import offering, small


def each_of_the_small_one(*operations: str) -> Any:
    """For every language, with the small specification, which has all kinds of layouts; `make test-all`: both."""

    def mark(test: Any) -> Any:
        return small("every layout of the real specification")(
            pytest.mark.parametrize("language", offering(*operations))(test)
        )

    return mark
