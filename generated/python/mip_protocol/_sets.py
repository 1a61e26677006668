"""The descriptor sets of the specification."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from . import (
        aiding,
        base,
        filter,
        filter_data,
        gnss,
        gnss_1,
        gnss_2,
        gnss_corrections,
        gnss_data,
        gnss_external,
        gnss_external_2,
        mip_3dm,
        rtk,
        sensor,
        shared,
        system,
        system_data,
    )

#: Descriptor set -> module of this package.
MODULES: dict[int, str] = {
    0x01: "base",
    0x0C: "mip_3dm",
    0x0D: "filter",
    0x0E: "gnss",
    0x0F: "rtk",
    0x13: "aiding",
    0x7F: "system",
    0x80: "sensor",
    0x81: "gnss_data",
    0x82: "filter_data",
    0x91: "gnss_1",
    0x92: "gnss_2",
    0x93: "gnss_corrections",
    0x94: "gnss_external",
    0x95: "gnss_external_2",
    0xA0: "system_data",
    0xFF: "shared",
}

__all__ = [
    "MODULES",
    "base",
    "mip_3dm",
    "filter",
    "gnss",
    "rtk",
    "aiding",
    "system",
    "sensor",
    "gnss_data",
    "filter_data",
    "gnss_1",
    "gnss_2",
    "gnss_corrections",
    "gnss_external",
    "gnss_external_2",
    "system_data",
    "shared",
]
