"""A virtual device, for development and tests without hardware.

What it sends and does follows from `spec/simulation`, which `targets/python/simulation` exports. In
`tests/tools/simulator`, `test_world.py` and `test_settings_act.py` compare it with the specification; `make interop
PEER=FOLDER` runs the vendor's example programs on it.
"""

from .device import VirtualDevice
from .faults import Faults, Injected
from .link import Link
from .live import LivePort
from .script import ScriptedEvent

__version__ = "0.2.0"

__all__ = ["Faults", "Injected", "Link", "LivePort", "ScriptedEvent", "VirtualDevice"]
