from __future__ import annotations

import pytest
from reference import Manual, manual_of
from support import SPECS


@pytest.fixture(params=SPECS)
def manual(request: pytest.FixtureRequest) -> Manual:
    return manual_of(request.param)
