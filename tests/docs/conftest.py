from __future__ import annotations

import pytest
from reference import Manual, manual_of
from support import heavy

#: The small specification has every kind of fact; the real one has each of them many times.
REAL = pytest.param("real", marks=heavy("every fact of the real reference"))


@pytest.fixture(params=["invented", REAL])
def manual(request: pytest.FixtureRequest) -> Manual:
    return manual_of(request.param)
