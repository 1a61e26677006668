"""The commands that start the data of a device."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .streaming import Session


def session() -> Session | None:
    """Imports the modules of these commands and returns the commands; None if the specification names none."""
    from . import base, mip_3dm, types
    from .streaming import Older, Session

    return Session(
        base_rate=mip_3dm.GetBaseRate,
        rate=lambda answer: answer.rate,
        format=mip_3dm.MessageFormat.write,
        item=types.DescriptorRate,
        stream=mip_3dm.DataStreamControl.write,
        resume=base.Resume,
        identify=base.GetDeviceInfo,
        descriptors=(base.GetDeviceDescriptors, base.GetExtendedDescriptors),
        older={
            0x80: Older(
                mip_3dm.GetImuBaseRate,
                lambda answer: answer.rate,
                mip_3dm.ImuMessageFormat.write,
                1,
            ),
            0x81: Older(
                mip_3dm.GetGnssBaseRate,
                lambda answer: answer.rate,
                mip_3dm.GnssMessageFormat.write,
                2,
            ),
            0x82: Older(
                mip_3dm.GetFilterBaseRate,
                lambda answer: answer.rate,
                mip_3dm.FilterMessageFormat.write,
                3,
            ),
        },
        timestamps=(
            (0, 0xD5),
            (0, 0xD7),
            (0x81, 0x09),
            (0x91, 0x09),
            (0x92, 0x09),
            (0x94, 0x09),
            (0x95, 0x09),
            (0x82, 0x11),
            (0x80, 0x12),
            (0, 0xD3),
        ),
    )
