"""The meaning of the types of `shared`."""

from __future__ import annotations

from .. import shared
from ..info import BitsInfo, FieldInfo, Info
from ..parameter import Flag, Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "GpsTimestampFlags": BitsInfo("shared.gps_timestamp_flags", shared.GpsTimestampFlags, aliases=("time_valid",)),
    "ExternalTimestampFlags": BitsInfo("shared.external_timestamp_flags", shared.ExternalTimestampFlags),
    "ExternalTimeDeltaFlags": BitsInfo("shared.external_time_delta_flags", shared.ExternalTimeDeltaFlags),
    "EventSource": FieldInfo(
        "shared.event_source", shared.EventSource, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-gv7-ahrs", "3dm-gv7-ar"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins"), parameters=(
            Parameter("trigger_id", "trigger_id", "scalar", scalar="u8"),
        )),
    "Ticks": FieldInfo(
        "shared.ticks", shared.Ticks, parameters=(
            Parameter("ticks", "ticks", "scalar", scalar="u32", units=("1",)),
        )),
    "DeltaTicks": FieldInfo(
        "shared.delta_ticks", shared.DeltaTicks, parameters=(
            Parameter("ticks", "ticks", "scalar", scalar="u32", units=("1",)),
        )),
    "GpsTimestamp": FieldInfo(
        "shared.gps_timestamp", shared.GpsTimestamp, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.tow",), below=604800, minimum=0, flags=(Flag("valid_flags.tow", "valid_flags", 0x1),)),
            Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",), valid=("valid_flags.week_number",), flags=(Flag("valid_flags.week_number", "valid_flags", 0x2),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.GpsTimestampFlags),
        )),
    "DeltaTime": FieldInfo(
        "shared.delta_time", shared.DeltaTime, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("seconds", "seconds", "scalar", scalar="double", units=("s",), minimum=0),
        )),
    "ReferenceTimestamp": FieldInfo(
        "shared.reference_timestamp", shared.ReferenceTimestamp, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",)),
        )),
    "ReferenceTimeDelta": FieldInfo(
        "shared.reference_time_delta", shared.ReferenceTimeDelta, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("dt_nanos", "dt_nanos", "scalar", scalar="u64", units=("ns",)),
        )),
    "ExternalTimestamp": FieldInfo(
        "shared.external_timestamp", shared.ExternalTimestamp, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",), valid=("valid_flags.nanoseconds",), flags=(Flag("valid_flags.nanoseconds", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.ExternalTimestampFlags),
        )),
    "ExternalTimeDelta": FieldInfo(
        "shared.external_time_delta", shared.ExternalTimeDelta, devices=("3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ahrs", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("dt_nanos", "dt_nanos", "scalar", scalar="u64", units=("ns",), valid=("valid_flags.dt_nanos",), flags=(Flag("valid_flags.dt_nanos", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=shared.ExternalTimeDeltaFlags),
        )),
}
