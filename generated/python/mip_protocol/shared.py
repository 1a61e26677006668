"""Shared data (0xFF).

Fields that every data set can contain. No packet has this descriptor set: the fields are sent in
packets of the other data sets.

- 3dm-cv7-gnss-ins: Shared (0xFF)
- 3dm-cv7-gnss-ins: Shared Data Descriptors
"""

from __future__ import annotations

from enum import IntFlag
from typing import Any

from . import codec
from .field import Data, Field, Shared

# Numbers that are read and written together, by their letters for `struct`.
_B = codec.Block("B")

_I = codec.Block("I")

_Q = codec.Block("Q")

_QH = codec.Block("QH")

_d = codec.Block("d")

_d2H = codec.Block("d2H")


@codec.open_flag(16)
class GpsTimestampFlags(IntFlag):
    """Validity flags for the GPS time."""

    TOW = 1 << 0
    """The whole seconds of the time of week have been set. Bit 0."""
    WEEK_NUMBER = 1 << 1
    """The week number has been set. Bit 1."""
    TIME_VALID = 0x3
    """The time of week and the week number have been set. Bits 0 to 1. Overlaps other bits."""


@codec.open_flag(16)
class ExternalTimestampFlags(IntFlag):
    """Validity of the external time."""

    NANOSECONDS = 1 << 0
    """The time is valid. Bit 0."""


@codec.open_flag(16)
class ExternalTimeDeltaFlags(IntFlag):
    """Validity of the external time difference."""

    DT_NANOS = 1 << 0
    """The difference is valid. Bit 0."""


class EventSource(Shared, Data):
    """Event source (0xFF,0xD0).

    The event trigger that caused the packet.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.

    Put it first in the format of event messages, to distinguish their packets from scheduled ones.

    - 3dm-cv7-gnss-ins: Event Source (0xFF,0xD0)
    """

    __slots__ = ("trigger_id",)
    __match_args__ = ("trigger_id",)

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD0
    NAME = "shared.event_source"
    _SIZE = 1

    trigger_id: int
    """Id of the trigger; 0 means that the packet was scheduled by `mip_3dm.MessageFormat`."""

    def __init__(self, trigger_id: int) -> None:
        self.trigger_id = trigger_id

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.trigger_id = _B.unpack(raw, at)[0]
        return at + 1

    def _write(self) -> bytes:
        return _B.write("trigger_id", self.trigger_id)


class Ticks(Shared, Data):
    """Ticks (0xFF,0xD1).

    Base periods since power-up.

    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: According
    to the SDK, the counter returns to 0 after about 50 days. That fits 2^32 ticks at 1000 Hz; at
    other rates that time would be longer or shorter.

    A tick is one period at the base rate of the device.

    - mip-sdk-4: Ticks (0xFF,0xD1)
    """

    __slots__ = ("ticks",)
    __match_args__ = ("ticks",)

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD1
    NAME = "shared.ticks"
    _SIZE = 4

    ticks: int
    """Base periods since the device started, modulo 2^32. Unit: 1."""

    def __init__(self, ticks: int) -> None:
        self.ticks = ticks

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.ticks = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("ticks", self.ticks)


class DeltaTicks(Shared, Data):
    """Delta ticks (0xFF,0xD2).

    Number of base periods between the previous field of this kind and this one.

    Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Each set
    and each event instance may count separately, as with `DeltaTime`.

    A tick is one period at the base rate of the device.

    - mip-sdk-4: Delta ticks (0xFF,0xD2)
    """

    __slots__ = ("ticks",)
    __match_args__ = ("ticks",)

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD2
    NAME = "shared.delta_ticks"
    _SIZE = 4

    ticks: int
    """Base periods since the previous field of this kind. Unit: 1."""

    def __init__(self, ticks: int) -> None:
        self.ticks = ticks

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.ticks = _I.unpack(raw, at)[0]
        return at + 4

    def _write(self) -> bytes:
        return _I.write("ticks", self.ticks)


class GpsTimestamp(Shared, Data):
    """GPS timestamp (0xFF,0xD3).

    External time of the data as GPS time of week and week number.

    Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed
    on 7 more.

    In event messages it is the time of the trigger. It becomes valid after the PPS is locked and
    `base.GpsTimeUpdate` has set the time of week and the week number. With an internal GNSS
    receiver as PPS source, the device usually sets the time itself. With NMEA input, a ZDA sentence
    sets the time to UTC: the value is then behind GPS time by the leap seconds, which are 18 s
    since 2017. `base.GpsTimeUpdate` sets GPS time.

    - 3dm-cv7-gnss-ins: GPS Timestamp (0xFF,0xD3)
    - 3dm-cv7-gnss-ins: Configure the External GNSS Receiver
    - 3dm-cv7-gnss-ins: RECEIVER Source
    """

    __slots__ = ("tow", "week_number", "valid_flags")
    __match_args__ = ("tow", "week_number", "valid_flags")

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD3
    NAME = "shared.gps_timestamp"
    _SIZE = 12

    tow: float
    """GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
    `GpsTimestampFlags.TOW` of `valid_flags` is set.
    """
    week_number: int
    """GPS week number. Unit: week. Valid if `GpsTimestampFlags.WEEK_NUMBER` of `valid_flags` is
    set.
    """
    valid_flags: GpsTimestampFlags
    """Validity flags for the timestamp."""

    def __init__(self, tow: float, week_number: int, valid_flags: GpsTimestampFlags) -> None:
        self.tow = tow
        self.week_number = week_number
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _d2H.unpack(raw, at)
        self.tow = v[0]
        self.week_number = v[1]
        self.valid_flags = codec.KNOWN[GpsTimestampFlags][v[2]]
        return at + 12

    def _write(self) -> bytes:
        return _d2H.write(
            "tow week_number valid_flags", self.tow, self.week_number, self.valid_flags
        )


class DeltaTime(Shared, Data):
    """Delta time (0xFF,0xD4).

    External time since this field was last sent in the same set and event instance.

    Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    It is the same as `ExternalTimeDelta`, in other units. Sending either restarts the counter that
    both share, so use only one of them.

    - 3dm-cv7-gnss-ins: Delta Time (0xFF,0xD4)
    """

    __slots__ = ("seconds",)
    __match_args__ = ("seconds",)

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD4
    NAME = "shared.delta_time"
    _SIZE = 8

    seconds: float
    """Time since the last output. Unit: s. Range: at least 0."""

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.seconds = _d.unpack(raw, at)[0]
        return at + 8

    def _write(self) -> bytes:
        return _d.write("seconds", self.seconds)


class ReferenceTimestamp(Shared, Data):
    """Reference timestamp (0xFF,0xD5).

    Time of the data by the internal reference clock.

    Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    The clock starts at power-on, only moves forward and never jumps; the value is always valid. In
    event messages it is the time of the trigger.

    - 3dm-cv7-gnss-ins: Reference Timestamp (0xFF,0xD5)
    """

    __slots__ = ("nanoseconds",)
    __match_args__ = ("nanoseconds",)

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD5
    NAME = "shared.reference_timestamp"
    _SIZE = 8

    nanoseconds: int
    """Time since initialization. Unit: ns."""

    def __init__(self, nanoseconds: int) -> None:
        self.nanoseconds = nanoseconds

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.nanoseconds = _Q.unpack(raw, at)[0]
        return at + 8

    def _write(self) -> bytes:
        return _Q.write("nanoseconds", self.nanoseconds)


class ReferenceTimeDelta(Shared, Data):
    """Reference time delta (0xFF,0xD6).

    Reference time since this field was last sent in the same set and event instance.

    Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    The value is always valid.

    - 3dm-cv7-gnss-ins: Reference Time Delta (0xFF,0xD6)
    """

    __slots__ = ("dt_nanos",)
    __match_args__ = ("dt_nanos",)

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD6
    NAME = "shared.reference_time_delta"
    _SIZE = 8

    dt_nanos: int
    """Time since the last output. Unit: ns."""

    def __init__(self, dt_nanos: int) -> None:
        self.dt_nanos = dt_nanos

    def _read(self: Any, raw: bytes, at: int) -> int:
        self.dt_nanos = _Q.unpack(raw, at)[0]
        return at + 8

    def _write(self) -> bytes:
        return _Q.write("dt_nanos", self.dt_nanos)


class ExternalTimestamp(Shared, Data):
    """External timestamp (0xFF,0xD7).

    Time of the data in the external clock domain.

    Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    It is `GpsTimestamp` in nanoseconds. In event messages it is the time of the trigger. It becomes
    valid when the external clock is synchronized through the PPS. Its epoch is the epoch of the
    time sent with `base.GpsTimeUpdate`: in most systems that of GPS time, but possibly another,
    such as the Unix epoch. Use `GpsTimestamp` for GPS time only. With a receiver as the source of
    the PPS (`mip_3dm.PpsSourceControl`), it is GPS time, and valid only while that receiver has a
    fix.

    - 3dm-cv7-gnss-ins: External Timestamp (0xFF,0xD7)
    - 3dm-cv7-gnss-ins: Timestamps
    - 3dm-cv7-gnss-ins: RECEIVER Source
    """

    __slots__ = ("nanoseconds", "valid_flags")
    __match_args__ = ("nanoseconds", "valid_flags")

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD7
    NAME = "shared.external_timestamp"
    _SIZE = 10

    nanoseconds: int
    """External time. Unit: ns. Valid if `ExternalTimestampFlags.NANOSECONDS` of `valid_flags` is
    set.
    """
    valid_flags: ExternalTimestampFlags
    """Validity of the time."""

    def __init__(self, nanoseconds: int, valid_flags: ExternalTimestampFlags) -> None:
        self.nanoseconds = nanoseconds
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _QH.unpack(raw, at)
        self.nanoseconds = v[0]
        self.valid_flags = codec.KNOWN[ExternalTimestampFlags][v[1]]
        return at + 10

    def _write(self) -> bytes:
        return _QH.write("nanoseconds valid_flags", self.nanoseconds, self.valid_flags)


class ExternalTimeDelta(Shared, Data):
    """External time delta (0xFF,0xD8).

    External time since this field was last sent in the same set and event instance.

    Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.

    It is the same as `DeltaTime`, in other units. Sending either restarts the counter that both
    share, so use only one of them.

    - 3dm-cv7-gnss-ins: External Time Delta (0xFF,0xD8)
    """

    __slots__ = ("dt_nanos", "valid_flags")
    __match_args__ = ("dt_nanos", "valid_flags")

    SET = 0xFF
    SETS = range(0x80, 0xFF)
    DESCRIPTOR = 0xD8
    NAME = "shared.external_time_delta"
    _SIZE = 10

    dt_nanos: int
    """Time since the last output. Unit: ns. Valid if `ExternalTimeDeltaFlags.DT_NANOS` of
    `valid_flags` is set.
    """
    valid_flags: ExternalTimeDeltaFlags
    """Validity of the difference."""

    def __init__(self, dt_nanos: int, valid_flags: ExternalTimeDeltaFlags) -> None:
        self.dt_nanos = dt_nanos
        self.valid_flags = valid_flags

    def _read(self: Any, raw: bytes, at: int) -> int:
        v = _QH.unpack(raw, at)
        self.dt_nanos = v[0]
        self.valid_flags = codec.KNOWN[ExternalTimeDeltaFlags][v[1]]
        return at + 10

    def _write(self) -> bytes:
        return _QH.write("dt_nanos valid_flags", self.dt_nanos, self.valid_flags)


#: Descriptor -> its types; several if constants or the size of the data distinguish layouts.
FIELDS: dict[int, tuple[type[Field], ...]] = {
    0xD0: (EventSource,),
    0xD1: (Ticks,),
    0xD2: (DeltaTicks,),
    0xD3: (GpsTimestamp,),
    0xD4: (DeltaTime,),
    0xD5: (ReferenceTimestamp,),
    0xD6: (ReferenceTimeDelta,),
    0xD7: (ExternalTimestamp,),
    0xD8: (ExternalTimeDelta,),
}
