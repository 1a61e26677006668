"""The descriptor sets of the specification."""

from __future__ import annotations

#: Descriptor set -> module of this package.
MODULES: dict[int, str] = {
    0x01: "tools",
    0x0C: "mip_3d",
    0x80: "measurements",
    0x81: "measurements",
    0x92: "measurements",
    0xFF: "shared",
}

__all__ = ["MODULES"]
