"""The descriptor sets of the specification."""

from __future__ import annotations

#: Descriptor set -> module of this package.
MODULES: dict[int, str] = {
    0x01: "base",
    0x0C: "mip_3dm",
    0x0D: "filter",
    0x0E: "gnss",
    0x0F: "rtk",
    0x11: "displacement",
    0x13: "aiding",
    0x7F: "system",
    0x80: "sensor",
    0x81: "gnss_data",
    0x82: "filter_data",
    0x90: "displacement_data",
    0x91: "gnss_data",
    0x92: "gnss_data",
    0x93: "gnss_data",
    0x94: "gnss_data",
    0x95: "gnss_data",
    0xA0: "system_data",
    0xFF: "shared",
}

__all__ = ["MODULES"]
