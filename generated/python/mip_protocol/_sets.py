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

#: Descriptor set -> name, title.
SETS: dict[int, tuple[str, ...]] = {
    0x01: ("base", "Base"),
    0x0C: ("3dm", "3DM"),
    0x0D: ("filter", "Filter commands"),
    0x0E: ("gnss", "GNSS commands"),
    0x0F: ("rtk", "RTK commands"),
    0x11: ("displacement", "Displacement commands"),
    0x13: ("aiding", "Aiding commands"),
    0x7F: ("system", "System"),
    0x80: ("sensor", "Sensor data"),
    0x81: ("gnss_data", "GNSS data"),
    0x82: ("filter_data", "Filter data"),
    0x90: ("displacement_data", "Displacement data"),
    0x91: ("gnss_1", "GNSS receiver 1 data"),
    0x92: ("gnss_2", "GNSS receiver 2 data"),
    0x93: ("gnss_corrections", "GNSS corrections data"),
    0x94: ("gnss_external", "External GNSS data"),
    0x95: ("gnss_external_2", "External GNSS data 2"),
    0xA0: ("system_data", "System data"),
    0xFF: ("shared", "Shared data"),
}
