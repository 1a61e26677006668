"""For all tests."""

from __future__ import annotations

import os

from support import BUILD

# What is kept between runs is kept here: tests neither see nor change the cache of the user.
os.environ["MIPGEN_CACHE"] = str(BUILD / "cache")
