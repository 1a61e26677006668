"""A simulated device, for development and tests without hardware."""

from .device import VirtualDevice
from .faults import Faults, Injected
from .link import Link
from .live import LivePort
from .script import ScriptedEvent

__all__ = ["Faults", "Injected", "Link", "LivePort", "ScriptedEvent", "VirtualDevice"]
