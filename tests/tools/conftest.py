"""The tests here import the real package as `mip_protocol`, and the tools on top of it."""

import sys

from support import SPECS

sys.path.insert(0, str(SPECS["real"][1] / "python"))
