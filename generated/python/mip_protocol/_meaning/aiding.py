"""What the types of `aiding` mean."""

from __future__ import annotations

from .. import aiding, protocol
from ..info import BitInfo, BitsInfo, EnumInfo, FieldInfo, Info, SetInfo, StructureInfo, ValueInfo
from ..parameter import Flag, Parameter

# fmt: off
SET = SetInfo("aiding", number=0x13, title="Aiding commands", description="Measurements of external sensors for the navigation filter, and the frames of the sensors.", sources=("3dm-cv7-gnss-ins: Aiding (0x13)", "3dm-cv7-gnss-ins: Filter Aiding Measurements"))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "AidingFrameFormat": EnumInfo(
        "aiding.aiding_frame_format", type=aiding.AidingFrameFormat, description="How the rotation of an aiding frame is given.", sources=("3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)",),
        values=(
            ValueInfo("euler", value=1, description="Euler angles: roll, pitch, yaw."),
            ValueInfo("quaternion", value=2, description="Quaternion: w, x, y, z."),
        ),
    ),
    "AidingEchoMode": EnumInfo(
        "aiding.aiding_echo_mode", type=aiding.AidingEchoMode, description="How the device answers aiding measurements.", sources=("3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)",),
        values=(
            ValueInfo("suppress_ack", value=0, description="No acknowledge."),
            ValueInfo("standard", value=1, description="Acknowledge as for any command."),
            ValueInfo("response", value=2, description="The data is returned in a response."),
        ),
    ),
    "Timebase": EnumInfo(
        "aiding.timebase", type=aiding.Timebase, description="Clock of the time of a measurement.",
        values=(
            ValueInfo("internal_reference", value=1, description="Internal reference clock of the device."),
            ValueInfo("external_time", value=2, description="External clock, with which the PPS synchronizes the device."),
            ValueInfo("time_of_arrival", value=3, description="Latency relative to the arrival of the command."),
        ),
    ),
    "MeasurementTime": StructureInfo(
        "aiding.measurement_time", type=aiding.MeasurementTime, description="When a measurement was taken.",
        parameters=(
            Parameter("timebase", "timebase", "scalar", description="Clock of the time.", scalar="u8", type=aiding.Timebase),
            Parameter("reserved", "reserved", "scalar", facts=("Reserved: send 1.",), scalar="u8", default=1, reserved=True),
            Parameter("nanoseconds", "nanoseconds", "scalar", description="Time by that clock.", facts=("Unit: ns.",), scalar="u64", units=("ns",)),
        ),
    ),
    "AxisFlags": BitsInfo(
        "aiding.axis_flags", type=aiding.AxisFlags, description="Which axes of a measurement are valid; the others are ignored.",
        bits=(
            BitInfo("x", first=0, last=0, description="First axis."),
            BitInfo("y", first=1, last=1, description="Second axis."),
            BitInfo("z", first=2, last=2, description="Third axis."),
        ),
    ),
    "LlhAxisFlags": BitsInfo(
        "aiding.llh_axis_flags", type=aiding.LlhAxisFlags, description="Which coordinates of a position are valid; the others are ignored.",
        bits=(
            BitInfo("latitude", first=0, last=0, description="Latitude and its uncertainty."),
            BitInfo("longitude", first=1, last=1, description="Longitude and its uncertainty."),
            BitInfo("height", first=2, last=2, description="Height and its uncertainty."),
        ),
    ),
    "FrameConfig": FieldInfo(
        "aiding.frame_config", type=aiding.FrameConfig,
        title="Frame configuration",
        description="Where and how an external sensor is mounted on the vehicle.",
        facts=("Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `aiding.FrameConfigResponse`.", "Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.", "Aiding measurements name the frame by its number.", "`p_vehicle = R * p_frame + t`, with the rotation R and the translation t.", "For GNSS positions and velocities the rotation does not matter. Send one that does not turn: Euler angles 0, 0, 0 or the quaternion 1, 0, 0, 0.", "A read selects the format of the answer."),
        sources=("3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)", "3dm-cv7-gnss-ins: Aiding Frames"),
        functions=("write", "read", "save", "load", "default"),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("frame_id", "frame_id", "scalar", description="Number of the frame.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4, required=("write", "read", "save", "load", "default")),
            Parameter("format", "format", "scalar", description="How the rotation is given.", facts=("Required for `write` and `read`.",), scalar="u8", required=("write", "read"), type=aiding.AidingFrameFormat),
            Parameter("tracking_enabled", "tracking_enabled", "scalar", description="Whether the filter estimates the errors of the frame.", facts=("Required for `write`.",), scalar="bool", required=("write",)),
            Parameter("translation", "translation", "array", description="Origin of the frame in the vehicle.", facts=("Elements: x, y, z.", "Unit: m.", "Frame: vehicle.", "Required for `write`."), scalar="float", elements=("x", "y", "z"), units=("m",), frame="vehicle", required=("write",)),
            Parameter("rotation", "rotation", "switch", description="Rotation from the frame to the vehicle.", facts=("Selected by `format`.", "Required for `write`."), tag="format", required=("write",), cases={1: Parameter("euler", "euler", "array", description="Roll, pitch and yaw.", facts=("If `format` is `aiding.AidingFrameFormat.EULER`.", "Elements: x, y, z.", "Unit: rad.", "Range: -3.141592653589793 to 3.141592653589793."), scalar="float", elements=("x", "y", "z"), units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793), 2: Parameter("quaternion", "quaternion", "array", description="Quaternion, scalar part first.", facts=("If `format` is `aiding.AidingFrameFormat.QUATERNION`.", "Elements: w, x, y, z.", "Unit: 1."), scalar="float", elements=("w", "x", "y", "z"), units=("1",)), }),
        ),
    ),
    "EchoControl": FieldInfo(
        "aiding.echo_control", type=aiding.EchoControl,
        title="Echo control",
        description="How the device answers aiding measurements.",
        facts=("Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `aiding.EchoControlResponse`.", "Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.", "The manual does not give the layout of the responses that carry the data back."),
        sources=("3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)", "3dm-cv7-gnss-ins: Aiding Command Echo Control"),
        functions=("write", "read", "save", "load", "default"),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", description="How the measurements are answered.", facts=("Required for `write`.",), scalar="u8", required=("write",), type=aiding.AidingEchoMode),
        ),
    ),
    "EcefPosition": FieldInfo(
        "aiding.ecef_position", type=aiding.EcefPosition,
        title="ECEF position",
        description="A measured position in Earth-fixed coordinates.",
        facts=("Also called `pos_ecef`.", "Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "Use only one form of position: ECEF or LLH.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: ECEF Position (0x13,0x21)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Position"),
        also=("pos_ecef",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("position", "position", "array", description="Position.", facts=("Elements: x, y, z.", "Unit: m.", "Frame: ecef.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="double", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", description="Uncertainty of the position.", facts=("Elements: x, y, z.", "Unit: m.", "Frame: ecef.", "Range: greater than 0.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which axes are valid.", scalar="u16", type=aiding.AxisFlags),
        ),
    ),
    "LlhPosition": FieldInfo(
        "aiding.llh_position", type=aiding.LlhPosition,
        title="LLH position",
        description="A measured position as latitude, longitude and height.",
        facts=("Also called `pos_llh`.", "Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "Use only one form of position: ECEF or LLH.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: LLH Position (0x13,0x22)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > LLH Position"),
        also=("pos_llh",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("latitude", "latitude", "scalar", description="Latitude.", facts=("Unit: deg.", "Frame: llh.", "Valid if `aiding.LlhAxisFlags.LATITUDE` of `valid_flags` is set."), scalar="double", units=("deg",), valid=("valid_flags.latitude",), frame="llh", flags=(Flag("valid_flags.latitude", "valid_flags", 0x1),)),
            Parameter("longitude", "longitude", "scalar", description="Longitude.", facts=("Unit: deg.", "Frame: llh.", "Valid if `aiding.LlhAxisFlags.LONGITUDE` of `valid_flags` is set."), scalar="double", units=("deg",), valid=("valid_flags.longitude",), frame="llh", flags=(Flag("valid_flags.longitude", "valid_flags", 0x2),)),
            Parameter("height", "height", "scalar", description="Height above the ellipsoid.", facts=("Unit: m.", "Frame: llh.", "Valid if `aiding.LlhAxisFlags.HEIGHT` of `valid_flags` is set."), scalar="double", units=("m",), valid=("valid_flags.height",), frame="llh", flags=(Flag("valid_flags.height", "valid_flags", 0x4),)),
            Parameter("uncertainty", "uncertainty", "array", description="Uncertainty of the position.", facts=("Elements: north, east, down.", "Unit: m.", "Frame: ned.", "Range: greater than 0.", "Each element has its own valid flag. north: `aiding.LlhAxisFlags.LATITUDE` of `valid_flags`, east: `aiding.LlhAxisFlags.LONGITUDE` of `valid_flags`, down: `aiding.LlhAxisFlags.HEIGHT` of `valid_flags`."), scalar="float", elements=("north", "east", "down"), units=("m",), valid=("valid_flags.latitude", "valid_flags.longitude", "valid_flags.height"), frame="ned", above=0, flags=(Flag("valid_flags.latitude", "valid_flags", 0x1), Flag("valid_flags.longitude", "valid_flags", 0x2), Flag("valid_flags.height", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which coordinates are valid.", scalar="u16", type=aiding.LlhAxisFlags),
        ),
    ),
    "HeightAboveEllipsoid": FieldInfo(
        "aiding.height_above_ellipsoid", type=aiding.HeightAboveEllipsoid,
        title="Height above ellipsoid",
        description="A measured height.",
        facts=("Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("height", "height", "scalar", description="Height above the ellipsoid.", facts=("Unit: m.", "Frame: llh."), scalar="float", units=("m",), frame="llh"),
            Parameter("uncertainty", "uncertainty", "scalar", description="Uncertainty of the height.", facts=("Unit: m.",), scalar="float", units=("m",)),
            Parameter("valid_flags", "valid_flags", "scalar", description="Not 0: the measurement is valid.", scalar="u16"),
        ),
    ),
    "EcefVelocity": FieldInfo(
        "aiding.ecef_velocity", type=aiding.EcefVelocity,
        title="ECEF velocity",
        description="A measured velocity in Earth-fixed coordinates.",
        facts=("Also called `vel_ecef`.", "Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "Use only one form of velocity: ECEF or NED.", "Not for a sensor that is fixed to the vehicle; for such a sensor, use `aiding.BodyFrameVelocity`.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > ECEF Velocity"),
        also=("vel_ecef",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("velocity", "velocity", "array", description="Velocity.", facts=("Elements: x, y, z.", "Unit: m/s.", "Frame: ecef.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", description="Uncertainty of the velocity.", facts=("Elements: x, y, z.", "Unit: m/s.", "Frame: ecef.", "Range: greater than 0.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ecef", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which axes are valid.", scalar="u16", type=aiding.AxisFlags),
        ),
    ),
    "NedVelocity": FieldInfo(
        "aiding.ned_velocity", type=aiding.NedVelocity,
        title="NED velocity",
        description="A measured velocity in the local level frame.",
        facts=("Also called `vel_ned`.", "Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "Use only one form of velocity: ECEF or NED.", "Not for a sensor that is fixed to the vehicle; for such a sensor, use `aiding.BodyFrameVelocity`.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: NED Velocity (0x13,0x29)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > NED Velocity"),
        also=("vel_ned",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("velocity", "velocity", "array", description="Velocity.", facts=("Elements: north, east, down.", "Unit: m/s.", "Frame: ned.", "Each element has its own valid flag. north: `aiding.AxisFlags.X` of `valid_flags`, east: `aiding.AxisFlags.Y` of `valid_flags`, down: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("north", "east", "down"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ned", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", description="Uncertainty of the velocity.", facts=("Elements: north, east, down.", "Unit: m/s.", "Frame: ned.", "Range: greater than 0.", "Each element has its own valid flag. north: `aiding.AxisFlags.X` of `valid_flags`, east: `aiding.AxisFlags.Y` of `valid_flags`, down: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("north", "east", "down"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="ned", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which axes are valid.", scalar="u16", type=aiding.AxisFlags),
        ),
    ),
    "BodyFrameVelocity": FieldInfo(
        "aiding.body_frame_velocity", type=aiding.BodyFrameVelocity,
        title="Body frame velocity",
        description="A measured velocity of the vehicle in the frame of the sensor.",
        facts=("Also called `vel_body_frame`.", "Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "The device supports up to four sensors of this kind.", "A wheeled vehicle constraint is a velocity of 0 with only y valid, sent at least once per second.", "With z also valid and 0, motion is constrained to a plane (2D mode).", "A zero velocity update is a velocity of 0, sent while the GNSS speed is below a threshold chosen by the user.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > Body Frame Velocity", "3dm-cv7-gnss-ins: Filter Kinematic Constraints"),
        also=("vel_body_frame",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("velocity", "velocity", "array", description="Velocity.", facts=("Elements: x, y, z.", "Unit: m/s.", "Frame: aiding.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", description="Standard deviation of the velocity.", facts=("Elements: x, y, z.", "Unit: m/s.", "Frame: aiding.", "Range: greater than 0.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which axes are valid.", scalar="u16", type=aiding.AxisFlags),
        ),
    ),
    "TrueHeading": FieldInfo(
        "aiding.true_heading", type=aiding.TrueHeading,
        title="True heading",
        description="A measured heading relative to true north.",
        facts=("Also called `heading_true`.", "Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: True Heading (0x13,0x31)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > True Heading"),
        also=("heading_true",),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("heading", "heading", "scalar", description="Heading.", facts=("Unit: rad.", "Frame: ned.", "Range: -3.141592653589793 to 3.141592653589793."), scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
            Parameter("uncertainty", "uncertainty", "scalar", description="Uncertainty of the heading.", facts=("Unit: rad.", "Range: greater than 0."), scalar="float", units=("rad",), above=0),
            Parameter("valid_flags", "valid_flags", "scalar", description="Not 0: the measurement is valid.", scalar="u16"),
        ),
    ),
    "MagneticField": FieldInfo(
        "aiding.magnetic_field", type=aiding.MagneticField,
        title="Magnetic field",
        description="A magnetic field measured by an external magnetometer.",
        facts=("Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS.", "The magnetometer must be calibrated.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: Magnetic Field (0x13,0x32)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > External Magnetometer"),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("magnetic_field", "magnetic_field", "array", description="Magnetic field.", facts=("Elements: x, y, z.", "Unit: gauss.", "Frame: aiding.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("uncertainty", "uncertainty", "array", description="Standard deviation of the magnetic field.", facts=("Elements: x, y, z.", "Unit: gauss.", "Frame: aiding.", "Range: greater than 0.", "Each element has its own valid flag. x: `aiding.AxisFlags.X` of `valid_flags`, y: `aiding.AxisFlags.Y` of `valid_flags`, z: `aiding.AxisFlags.Z` of `valid_flags`."), scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.x", "valid_flags.y", "valid_flags.z"), frame="aiding", above=0, flags=(Flag("valid_flags.x", "valid_flags", 0x1), Flag("valid_flags.y", "valid_flags", 0x2), Flag("valid_flags.z", "valid_flags", 0x4))),
            Parameter("valid_flags", "valid_flags", "scalar", description="Which axes are valid.", scalar="u16", type=aiding.AxisFlags),
        ),
    ),
    "Pressure": FieldInfo(
        "aiding.pressure", type=aiding.Pressure,
        title="Pressure",
        description="A static air pressure measured by an external sensor.",
        facts=("Not acknowledged if `mode` of `aiding.EchoControl` is `aiding.AidingEchoMode.SUPPRESS_ACK`.", "Supported by 3DM-CV7-GNSS/INS.", "In mode `response` of `aiding.EchoControl`, the device sends the data back in a response of unknown layout."),
        sources=("3dm-cv7-gnss-ins: Pressure (0x13,0x33)", "3dm-cv7-gnss-ins: Filter Aiding Measurements > External Pressure"),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("time", "time", "struct", description="When the measurement was taken.", type=aiding.MeasurementTime),
            Parameter("frame_id", "frame_id", "scalar", description="Frame of the sensor, as `aiding.FrameConfig` defines it.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("pressure", "pressure", "scalar", description="Air pressure.", facts=("Unit: mbar.",), scalar="float", units=("mbar",)),
            Parameter("uncertainty", "uncertainty", "scalar", description="Standard deviation of the pressure.", facts=("Unit: mbar.", "Range: greater than 0."), scalar="float", units=("mbar",), above=0),
            Parameter("valid_flags", "valid_flags", "scalar", description="Not 0: the measurement is valid.", scalar="u16"),
        ),
    ),
    "FrameConfigResponse": FieldInfo(
        "aiding.frame_config_response", type=aiding.FrameConfigResponse,
        title="Frame configuration response",
        facts=("Answers `aiding.FrameConfig`.", "Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)", "3dm-cv7-gnss-ins: Aiding Frames"),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"),
        parameters=(
            Parameter("frame_id", "frame_id", "scalar", description="Number of the frame.", facts=("Range: 1 to 4.",), scalar="u8", minimum=1, maximum=4),
            Parameter("format", "format", "scalar", description="How the rotation is given.", scalar="u8", type=aiding.AidingFrameFormat),
            Parameter("tracking_enabled", "tracking_enabled", "scalar", description="Whether the filter estimates the errors of the frame.", scalar="bool"),
            Parameter("translation", "translation", "array", description="Origin of the frame in the vehicle.", facts=("Elements: x, y, z.", "Unit: m.", "Frame: vehicle."), scalar="float", elements=("x", "y", "z"), units=("m",), frame="vehicle"),
            Parameter("rotation", "rotation", "switch", description="Rotation from the frame to the vehicle.", facts=("Selected by `format`.",), tag="format", cases={1: Parameter("euler", "euler", "array", description="Roll, pitch and yaw.", facts=("If `format` is `aiding.AidingFrameFormat.EULER`.", "Elements: x, y, z.", "Unit: rad.", "Range: -3.141592653589793 to 3.141592653589793."), scalar="float", elements=("x", "y", "z"), units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793), 2: Parameter("quaternion", "quaternion", "array", description="Quaternion, scalar part first.", facts=("If `format` is `aiding.AidingFrameFormat.QUATERNION`.", "Elements: w, x, y, z.", "Unit: 1."), scalar="float", elements=("w", "x", "y", "z"), units=("1",)), }),
        ),
    ),
    "EchoControlResponse": FieldInfo(
        "aiding.echo_control_response", type=aiding.EchoControlResponse,
        title="Echo control response",
        facts=("Answers `aiding.EchoControl`.", "Supported by 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)", "3dm-cv7-gnss-ins: Aiding Command Echo Control"),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"),
        parameters=(
            Parameter("mode", "mode", "scalar", description="How the measurements are answered.", scalar="u8", type=aiding.AidingEchoMode),
        ),
    ),
}
