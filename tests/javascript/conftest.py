"""The live view is tested with the real package of Python, on which its virtual device is based."""

import sys

from support import SPECS

sys.path.insert(0, str(SPECS["real"][1] / "python"))
