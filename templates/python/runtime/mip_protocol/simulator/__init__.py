"""A simulated device, for development and tests without hardware."""

from .device import VirtualDevice
from .link import Link

__all__ = ["Link", "VirtualDevice"]
