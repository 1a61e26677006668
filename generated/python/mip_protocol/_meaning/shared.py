"""What the types of `shared` mean."""

from __future__ import annotations

from .. import shared
from ..info import BitInfo, BitsInfo, FieldInfo, Info, SetInfo
from ..parameter import Flag, Parameter

# fmt: off
SET = SetInfo("shared", number=0xFF, title="Shared data", description="Fields that every data set can contain. No packet has this descriptor set: the fields are sent in packets of the other data sets.", sources=("3dm-cv7-gnss-ins: Shared (0xFF)", "3dm-cv7-gnss-ins: Shared Data Descriptors"))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "GpsTimestampFlags": BitsInfo(
        "shared.gps_timestamp_flags", type=shared.GpsTimestampFlags, description="Which parts of the GPS time are valid.",
        bits=(
            BitInfo("tow", first=0, last=0, description="The whole seconds of the time of week have been set."),
            BitInfo("week_number", first=1, last=1, description="The week number has been set."),
            BitInfo("time_valid", first=0, last=1, description="Both are set.", alias=True),
        ),
    ),
    "ExternalTimestampFlags": BitsInfo(
        "shared.external_timestamp_flags", type=shared.ExternalTimestampFlags, description="Whether the external time is valid.",
        bits=(
            BitInfo("nanoseconds", first=0, last=0, description="The time is valid."),
        ),
    ),
    "ExternalTimeDeltaFlags": BitsInfo(
        "shared.external_time_delta_flags", type=shared.ExternalTimeDeltaFlags, description="Whether the difference of external time is valid.",
        bits=(
            BitInfo("dt_nanos", first=0, last=0, description="The difference is valid."),
        ),
    ),
    "EventSource": FieldInfo(
        "shared.event_source", type=shared.EventSource,
        title="Event source",
        description="The event trigger that caused the packet.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "Put it first in the format of event messages, to distinguish their packets from scheduled ones."),
        sources=("3dm-cv7-gnss-ins: Event Source (0xFF,0xD0)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("trigger_id", "trigger_id", "scalar", description="Id of the trigger; 0 means that the packet was scheduled by `mip_3dm.MessageFormat`.", scalar="u8"),
        ),
    ),
    "Ticks": FieldInfo(
        "shared.ticks", type=shared.Ticks,
        title="Ticks",
        description="Base periods since power-up.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "A tick takes as long as one period at the base rate of the device.", "Uncertain: According to the SDK, the counter returns to 0 after about 50 days. That fits 2^32 ticks at 1000 Hz; at other rates it would take longer or shorter."),
        sources=("mip-sdk-4: Ticks (0xFF,0xD1)",),
        parameters=(
            Parameter("ticks", "ticks", "scalar", description="Ticks.", facts=("Unit: 1.",), scalar="u32", units=("1",)),
        ),
    ),
    "DeltaTicks": FieldInfo(
        "shared.delta_ticks", type=shared.DeltaTicks,
        title="Delta ticks",
        description="Base periods that have passed from the previous field of this kind to this one.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "A tick takes as long as one period at the base rate of the device.", "Uncertain: Whether each set and each event instance counts separately, as with `shared.DeltaTime`."),
        sources=("mip-sdk-4: Delta Ticks (0xFF,0xD2)",),
        parameters=(
            Parameter("ticks", "ticks", "scalar", description="Ticks.", facts=("Unit: 1.",), scalar="u32", units=("1",)),
        ),
    ),
    "GpsTimestamp": FieldInfo(
        "shared.gps_timestamp", type=shared.GpsTimestamp,
        title="GPS timestamp",
        description="External time of the data as GPS time of week and week number.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "In event messages it is the time of the trigger.", "It becomes valid after the PPS is locked and `base.GpsTimeUpdate` has set the time of week and the week number.", "With an internal GNSS receiver as PPS source, the device usually sets the time itself.", "With NMEA input, a ZDA sentence sets the time to UTC: the value is then behind GPS time by the leap seconds, which are 18 s since 2017. `base.GpsTimeUpdate` sets GPS time."),
        sources=("3dm-cv7-gnss-ins: GPS Timestamp (0xFF,0xD3)", "3dm-cv7-gnss-ins: Configure the External GNSS Receiver", "3dm-cv7-gnss-ins: RECEIVER Source"),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("tow", "tow", "scalar", description="GPS time of week.", facts=("Unit: s.", "Valid if `shared.GpsTimestampFlags.TOW` of `valid_flags` is set."), scalar="double", units=("s",), valid=("valid_flags.tow",), flags=(Flag("valid_flags.tow", "valid_flags", 0x1),)),
            Parameter("week_number", "week_number", "scalar", description="GPS week number.", facts=("Unit: week.", "Valid if `shared.GpsTimestampFlags.WEEK_NUMBER` of `valid_flags` is set."), scalar="u16", units=("week",), valid=("valid_flags.week_number",), flags=(Flag("valid_flags.week_number", "valid_flags", 0x2),)),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which parts are valid.", scalar="u16", type=shared.GpsTimestampFlags),
        ),
    ),
    "DeltaTime": FieldInfo(
        "shared.delta_time", type=shared.DeltaTime,
        title="Delta time",
        description="External time since this field was last sent in the same set and event instance.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "It is the same as `shared.ExternalTimeDelta`, in other units.", "Sending either restarts the counter that both share, so use only one of them."),
        sources=("3dm-cv7-gnss-ins: Delta Time (0xFF,0xD4)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("seconds", "seconds", "scalar", description="Time since the last output.", facts=("Unit: s.",), scalar="double", units=("s",)),
        ),
    ),
    "ReferenceTimestamp": FieldInfo(
        "shared.reference_timestamp", type=shared.ReferenceTimestamp,
        title="Reference timestamp",
        description="Time of the data by the internal reference clock.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "The clock starts at power-on, only moves forward and never jumps; the value is always valid.", "In event messages it is the time of the trigger."),
        sources=("3dm-cv7-gnss-ins: Reference Timestamp (0xFF,0xD5)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("nanoseconds", "nanoseconds", "scalar", description="Time since initialization.", facts=("Unit: ns.",), scalar="u64", units=("ns",)),
        ),
    ),
    "ReferenceTimeDelta": FieldInfo(
        "shared.reference_time_delta", type=shared.ReferenceTimeDelta,
        title="Reference time delta",
        description="Reference time since this field was last sent in the same set and event instance.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "The value is always valid."),
        sources=("3dm-cv7-gnss-ins: Reference Time Delta (0xFF,0xD6)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("dt_nanos", "dt_nanos", "scalar", description="Time since the last output.", facts=("Unit: ns.",), scalar="u64", units=("ns",)),
        ),
    ),
    "ExternalTimestamp": FieldInfo(
        "shared.external_timestamp", type=shared.ExternalTimestamp,
        title="External timestamp",
        description="Time of the data in the external clock domain.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "It is `shared.GpsTimestamp` in nanoseconds.", "In event messages it is the time of the trigger.", "It becomes valid when the external clock is synchronized through the PPS."),
        sources=("3dm-cv7-gnss-ins: External Timestamp (0xFF,0xD7)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("nanoseconds", "nanoseconds", "scalar", description="External time.", facts=("Unit: ns.", "Valid if `shared.ExternalTimestampFlags.NANOSECONDS` of `valid_flags` is set."), scalar="u64", units=("ns",), valid=("valid_flags.nanoseconds",), flags=(Flag("valid_flags.nanoseconds", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", description="Whether the time is valid.", scalar="u16", type=shared.ExternalTimestampFlags),
        ),
    ),
    "ExternalTimeDelta": FieldInfo(
        "shared.external_time_delta", type=shared.ExternalTimeDelta,
        title="External time delta",
        description="External time since this field was last sent in the same set and event instance.",
        facts=("Supported by 3DM-CV7-GNSS/INS.", "It is the same as `shared.DeltaTime`, in other units.", "Sending either restarts the counter that both share, so use only one of them."),
        sources=("3dm-cv7-gnss-ins: External Time Delta (0xFF,0xD8)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("dt_nanos", "dt_nanos", "scalar", description="Time since the last output.", facts=("Unit: ns.", "Valid if `shared.ExternalTimeDeltaFlags.DT_NANOS` of `valid_flags` is set."), scalar="u64", units=("ns",), valid=("valid_flags.dt_nanos",), flags=(Flag("valid_flags.dt_nanos", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", description="Whether the difference is valid.", scalar="u16", type=shared.ExternalTimeDeltaFlags),
        ),
    ),
}
