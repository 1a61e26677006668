"""The meaning of the types of `aiding`."""

from __future__ import annotations

from .. import aiding, protocol
from ..info import BitsInfo, EnumInfo, FieldInfo, Info, StructureInfo
from ..parameter import Flag, Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "AidingFrameFormat": EnumInfo("aiding.aiding_frame_format", aiding.AidingFrameFormat),
    "AidingEchoMode": EnumInfo("aiding.aiding_echo_mode", aiding.AidingEchoMode),
    "Timebase": EnumInfo("aiding.timebase", aiding.Timebase),
    "MeasurementTime": StructureInfo("aiding.measurement_time", aiding.MeasurementTime, (
            Parameter("timebase", "timebase", "scalar", scalar="u8", type=aiding.Timebase),
            Parameter("reserved", "reserved", "scalar", scalar="u8", default=1, reserved=True),
            Parameter("nanoseconds", "nanoseconds", "scalar", scalar="u64", units=("ns",)),
        )),
    "AxisFlags": BitsInfo("aiding.axis_flags", aiding.AxisFlags),
    "LlhAxisFlags": BitsInfo("aiding.llh_axis_flags", aiding.LlhAxisFlags),
    "FrameConfig": FieldInfo(
        "aiding.frame_config", aiding.FrameConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cv7-ins"), likely=("3dm-gv7-ins",), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4, required=("write", "read", "save", "load", "default")),
            Parameter("format", "format", "scalar", scalar="u8", required=("write", "read"), type=aiding.AidingFrameFormat),
            Parameter("tracking_enabled", "tracking_enabled", "scalar", scalar="bool", required=("write",)),
            Parameter("translation", "translation", "array", scalar="float", elements=("x", "y", "z"), units=("m",), frame="vehicle", required=("write",)),
            Parameter("rotation", "rotation", "switch", tag="format", required=("write",), cases={1: Parameter("euler", "euler", "array", scalar="float", elements=("x", "y", "z"), units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="vehicle"), 2: Parameter("quaternion", "quaternion", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)), }),
        )),
    "SensorFrameMap": FieldInfo(
        "aiding.sensor_frame_map", aiding.SensorFrameMap, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("sensor_id", "sensor_id", "scalar", scalar="u8", minimum=1, required=("write",)),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4, default=1, required=("write",)),
        )),
    "EchoControl": FieldInfo(
        "aiding.echo_control", aiding.EchoControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", scalar="u8", required=("write",), type=aiding.AidingEchoMode),
        )),
    "EcefPosition": FieldInfo(
        "aiding.ecef_position", aiding.EcefPosition, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("position", "position", "array", scalar="double", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
        )),
    "LlhPosition": FieldInfo(
        "aiding.llh_position", aiding.LlhPosition, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), valid=("valid_flags.latitude",), minimum=-90, maximum=90, frame="llh", flags=(Flag("valid_flags.latitude", "valid_flags", 0x1),)),
            Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), valid=("valid_flags.longitude",), minimum=-180, maximum=180, frame="llh", flags=(Flag("valid_flags.longitude", "valid_flags", 0x2),)),
            Parameter("height", "height", "scalar", scalar="double", units=("m",), valid=("valid_flags.height",), frame="llh", flags=(Flag("valid_flags.height", "valid_flags", 0x4),)),
            Parameter("uncertainty", "uncertainty", "array", scalar="float", elements=("north", "east", "down"), units=("m",), valid=("valid_flags.latitude", "valid_flags.longitude", "valid_flags.height"), frame="ned", above=0, flags=(Flag("valid_flags.latitude", "valid_flags", 0x1), Flag("valid_flags.longitude", "valid_flags", 0x2), Flag("valid_flags.height", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.LlhAxisFlags),
        )),
    "HeightAboveEllipsoid": FieldInfo(
        "aiding.height_above_ellipsoid", aiding.HeightAboveEllipsoid, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("height", "height", "scalar", scalar="float", units=("m",), frame="llh"),
            Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("m",), minimum=0),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
        )),
    "PressureOld": FieldInfo(
        "aiding.pressure_old", aiding.PressureOld, parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("pressure", "pressure", "scalar", scalar="float", units=("mbar",)),
            Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("mbar",), above=0),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
        )),
    "EcefVelocity": FieldInfo(
        "aiding.ecef_velocity", aiding.EcefVelocity, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("velocity", "velocity", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
        )),
    "NedVelocity": FieldInfo(
        "aiding.ned_velocity", aiding.NedVelocity, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("velocity", "velocity", "array", scalar="float", elements=("north", "east", "down"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ned", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", scalar="float", elements=("north", "east", "down"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ned", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
        )),
    "BodyFrameVelocity": FieldInfo(
        "aiding.body_frame_velocity", aiding.BodyFrameVelocity, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("velocity", "velocity", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
        )),
    "TrueHeading": FieldInfo(
        "aiding.true_heading", aiding.TrueHeading, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
            Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("rad",), above=0),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
        )),
    "MagneticField": FieldInfo(
        "aiding.magnetic_field", aiding.MagneticField, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("magnetic_field", "magnetic_field", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=aiding.AxisFlags),
        )),
    "Pressure": FieldInfo(
        "aiding.pressure", aiding.Pressure, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("time", "time", "struct", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("pressure", "pressure", "scalar", scalar="float", units=("mbar",)),
            Parameter("uncertainty", "uncertainty", "scalar", scalar="float", units=("mbar",), above=0),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16"),
        )),
    "FrameConfigResponse": FieldInfo(
        "aiding.frame_config_response", aiding.FrameConfigResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cv7-ins"), likely=("3dm-gv7-ins",), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar"), parameters=(
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4),
            Parameter("format", "format", "scalar", scalar="u8", type=aiding.AidingFrameFormat),
            Parameter("tracking_enabled", "tracking_enabled", "scalar", scalar="bool"),
            Parameter("translation", "translation", "array", scalar="float", elements=("x", "y", "z"), units=("m",), frame="vehicle"),
            Parameter("rotation", "rotation", "switch", tag="format", cases={1: Parameter("euler", "euler", "array", scalar="float", elements=("x", "y", "z"), units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="vehicle"), 2: Parameter("quaternion", "quaternion", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)), }),
        )),
    "SensorFrameMapResponse": FieldInfo(
        "aiding.sensor_frame_map_response", aiding.SensorFrameMapResponse, parameters=(
            Parameter("sensor_id", "sensor_id", "scalar", scalar="u8", minimum=1),
            Parameter("frame_id", "frame_id", "scalar", scalar="u8", minimum=1, maximum=4, default=1),
        )),
    "EchoControlResponse": FieldInfo(
        "aiding.echo_control_response", aiding.EchoControlResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), assumed=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("mode", "mode", "scalar", scalar="u8", type=aiding.AidingEchoMode),
        )),
}
