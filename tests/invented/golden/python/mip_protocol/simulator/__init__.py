"""A simulated device, for development and tests without hardware."""

from .device import VirtualDevice
from .faults import Faults, Injected
from .link import Link

__all__ = ["Faults", "Injected", "Link", "VirtualDevice"]
