"""The generated package, for tests that import it as its users do."""

from __future__ import annotations

import sys

from support import ROOT

sys.path.insert(0, str(ROOT / "generated/python"))
