"""The meaning of the types of `filter`."""

from __future__ import annotations

from .. import filter, protocol
from ..info import BitsInfo, EnumInfo, FieldInfo, Info
from ..parameter import Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "DynamicsMode": EnumInfo("filter.dynamics_mode", filter.DynamicsMode),
    "EstimatedStates": BitsInfo("filter.estimated_states", filter.EstimatedStates),
    "GnssAidingSource": EnumInfo("filter.gnss_aiding_source", filter.GnssAidingSource),
    "HeadingType": EnumInfo("filter.heading_type", filter.HeadingType),
    "HeadingUpdateSource": EnumInfo("filter.heading_update_source", filter.HeadingUpdateSource),
    "TareAxes": BitsInfo("filter.tare_axes", filter.TareAxes),
    "MeasurementFlags": BitsInfo("filter.measurement_flags", filter.MeasurementFlags),
    "MagParameterSource": EnumInfo("filter.mag_parameter_source", filter.MagParameterSource),
    "AdaptiveMeasurementSelector": EnumInfo("filter.adaptive_measurement_selector", filter.AdaptiveMeasurementSelector),
    "AltitudeAidingSource": EnumInfo("filter.altitude_aiding_source", filter.AltitudeAidingSource),
    "PitchRollAidingSource": EnumInfo("filter.pitch_roll_aiding_source", filter.PitchRollAidingSource),
    "AidingSource": EnumInfo("filter.aiding_source", filter.AidingSource),
    "AccelConstraint": EnumInfo("filter.accel_constraint", filter.AccelConstraint),
    "VelocityConstraint": EnumInfo("filter.velocity_constraint", filter.VelocityConstraint),
    "AngularConstraint": EnumInfo("filter.angular_constraint", filter.AngularConstraint),
    "InitialConditionSource": EnumInfo("filter.initial_condition_source", filter.InitialConditionSource),
    "HeadingAlignment": BitsInfo("filter.heading_alignment", filter.HeadingAlignment),
    "ReferenceFrame": EnumInfo("filter.reference_frame", filter.ReferenceFrame),
    "AdaptiveLevel": EnumInfo("filter.adaptive_level", filter.AdaptiveLevel),
    "RelativePositionSource": EnumInfo("filter.relative_position_source", filter.RelativePositionSource),
    "ReferencePoint": EnumInfo("filter.reference_point", filter.ReferencePoint),
    "Reset": FieldInfo(
        "filter.reset", filter.Reset, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45"), parameters=(
        )),
    "SetInitialAttitude": FieldInfo(
        "filter.set_initial_attitude", filter.SetInitialAttitude, devices=("3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45"), parameters=(
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), minimum=-1.5707963267948966, maximum=1.5707963267948966, frame="ned"),
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
        )),
    "SetInitialHeading": FieldInfo(
        "filter.set_initial_heading", filter.SetInitialHeading, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
        )),
    "SetInitialAttitudeFromImu": FieldInfo(
        "filter.set_initial_attitude_from_imu", filter.SetInitialAttitudeFromImu, likely=("3dm-gx3-45",), parameters=(
            Parameter("declination", "declination", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
        )),
    "Run": FieldInfo(
        "filter.run", filter.Run, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
        )),
    "VehicleDynamicsMode": FieldInfo(
        "filter.vehicle_dynamics_mode", filter.VehicleDynamicsMode, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), likely=("3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("mode", "mode", "scalar", scalar="u8", required=("write",), type=filter.DynamicsMode, variants=(Variant("device", ("3dm-gx3-45",), {"only": ("portable", "automotive", "airborne")}),)),
        )),
    "SensorToVehicleRotationEuler": FieldInfo(
        "filter.sensor_to_vehicle_rotation_euler", filter.SensorToVehicleRotationEuler, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), frame="sensor", required=("write",)),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), frame="sensor", required=("write",)),
            Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",), frame="sensor", required=("write",)),
        )),
    "SensorToVehicleOffset": FieldInfo(
        "filter.sensor_to_vehicle_offset", filter.SensorToVehicleOffset, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), likely=("3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="sensor", required=("write",)),
        )),
    "AntennaOffset": FieldInfo(
        "filter.antenna_offset", filter.AntennaOffset, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-cv7-ins", "3dm-gx5-45"), likely=("3dm-cx5-45", "3dm-gv7-ins", "3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx7-ins", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="vehicle", required=("write",), variants=(Variant("device", ("3dm-cx5-45",), {"frame": "sensor"}), Variant("device", ("3dm-gx5-45",), {"frame": "sensor"}),)),
        )),
    "EstimationControl": FieldInfo(
        "filter.estimation_control", filter.EstimationControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("flags", "flags", "scalar", scalar="u16", required=("write",), type=filter.EstimatedStates, variants=(Variant("device", ("3dm-cv5-15", "3dm-cx5-15", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx5-15"), {"only": ("gyro_bias",)}), Variant("device", ("3dm-cv5-25", "3dm-cx5-25", "3dm-gx5-25"), {"only": ("gyro_bias", "auto_hard_iron", "auto_soft_iron")}), Variant("device", ("3dm-gq4-45", "3dm-gx4-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), {"only": ("gyro_bias", "accel_bias", "gyro_scale_factor", "accel_scale_factor", "antenna_offset")}),)),
        )),
    "GnssSource": FieldInfo(
        "filter.gnss_source", filter.GnssSource, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-45"), likely=("3dm-cv7-ins", "3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=filter.GnssAidingSource, variants=(Variant("device", ("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), {"only": ("external",)}), Variant("device", ("3dm-cx5-45", "3dm-gq4-45", "3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), {"only": ("all_internal", "external", "internal_1")}), Variant("device", ("3dm-gx5-45",), {"only": ("all_internal", "external")}),)),
        )),
    "ExternalGnssUpdate": FieldInfo(
        "filter.external_gnss_update", filter.ExternalGnssUpdate, devices=("3dm-gx5-45",), likely=("3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), below=604800, minimum=0),
            Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
            Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), minimum=-90, maximum=90, frame="llh"),
            Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), minimum=-180, maximum=180, frame="llh"),
            Parameter("height", "height", "scalar", scalar="double", units=("m",), frame="llh"),
            Parameter("velocity", "velocity", "array", scalar="float", elements=("north", "east", "down"), units=("m/s",), frame="ned"),
            Parameter("position_uncertainty", "position_uncertainty", "array", scalar="float", elements=("north", "east", "down"), units=("m",), frame="ned", minimum=0),
            Parameter("velocity_uncertainty", "velocity_uncertainty", "array", scalar="float", elements=("north", "east", "down"), units=("m/s",), frame="ned", minimum=0),
        )),
    "ExternalHeadingUpdate": FieldInfo(
        "filter.external_heading_update", filter.ExternalHeadingUpdate, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ins", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
            Parameter("heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",), above=0),
            Parameter("type", "type", "scalar", scalar="u8", type=filter.HeadingType),
        )),
    "HeadingSource": FieldInfo(
        "filter.heading_source", filter.HeadingSource, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cx5-15", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=filter.HeadingUpdateSource, variants=(Variant("device", ("3dm-cv5-15", "3dm-cx5-15", "3dm-gx5-15"), {"only": ("none", "external")}), Variant("device", ("3dm-cv5-25", "3dm-cx5-25", "3dm-gx4-25", "3dm-gx5-25"), {"only": ("none", "mag", "external")}), Variant("device", ("3dm-gq4-45", "3dm-gx3-45", "3dm-gx4-45"), {"only": ("none", "mag", "gnss_velocity", "external")}), Variant("device", ("3dm-rq1-45-lt", "3dm-rq1-45-st"), {"only": ("none", "gnss_velocity", "external")}),)),
        )),
    "AutoInitializationControl": FieldInfo(
        "filter.auto_initialization_control", filter.AutoInitializationControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
        )),
    "AccelNoise": FieldInfo(
        "filter.accel_noise", filter.AccelNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), required=("write",), above=0),
        )),
    "GyroNoise": FieldInfo(
        "filter.gyro_noise", filter.GyroNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), required=("write",), above=0),
        )),
    "AccelBiasModel": FieldInfo(
        "filter.accel_bias_model", filter.AccelBiasModel, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gx5-45"), likely=("3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv7-ins", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",), required=("write",)),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), required=("write",), above=0),
        )),
    "GyroBiasModel": FieldInfo(
        "filter.gyro_bias_model", filter.GyroBiasModel, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",), required=("write",)),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), required=("write",), above=0),
        )),
    "AutoZupt": FieldInfo(
        "filter.auto_zupt", filter.AutoZupt, functions=("write", "read", "save", "load", "default"), devices=("3dm-gq7", "3dm-gx5-45"), likely=("3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("threshold", "threshold", "scalar", scalar="float", units=("m/s",), required=("write",), minimum=0),
        )),
    "ExternalHeadingUpdateWithTime": FieldInfo(
        "filter.external_heading_update_with_time", filter.ExternalHeadingUpdateWithTime, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ins", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), below=604800, minimum=0),
            Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",)),
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
            Parameter("heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",), above=0),
            Parameter("type", "type", "scalar", scalar="u8", type=filter.HeadingType),
        )),
    "AutoAngularZupt": FieldInfo(
        "filter.auto_angular_zupt", filter.AutoAngularZupt, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-cv7-ins", "3dm-cx5-25", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cx5-15", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("threshold", "threshold", "scalar", scalar="float", units=("rad/s",), required=("write",), minimum=0),
        )),
    "TareOrientation": FieldInfo(
        "filter.tare_orientation", filter.TareOrientation, functions=("write", "read", "save", "load", "default"), devices=("3dm-cx5-25", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("axes", "axes", "scalar", scalar="u8", required=("write",), type=filter.TareAxes),
        )),
    "CommandedZupt": FieldInfo(
        "filter.commanded_zupt", filter.CommandedZupt, devices=("3dm-gx5-45",), likely=("3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
        )),
    "CommandedAngularZupt": FieldInfo(
        "filter.commanded_angular_zupt", filter.CommandedAngularZupt, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
        )),
    "ReferencePosition": FieldInfo(
        "filter.reference_position", filter.ReferencePosition, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15",), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), minimum=-90, maximum=90, frame="llh", required=("write",)),
            Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), minimum=-180, maximum=180, frame="llh", required=("write",)),
            Parameter("altitude", "altitude", "scalar", scalar="double", units=("m",), required=("write",)),
        )),
    "MagCaptureAutoCalibration": FieldInfo(
        "filter.mag_capture_auto_calibration", filter.MagCaptureAutoCalibration, functions=("write", "save"), devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        )),
    "GravityNoise": FieldInfo(
        "filter.gravity_noise", filter.GravityNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("g",), required=("write",), above=0),
        )),
    "PressureAltitudeNoise": FieldInfo(
        "filter.pressure_altitude_noise", filter.PressureAltitudeNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "scalar", scalar="float", units=("m",), required=("write",), above=0),
        )),
    "HardIronOffsetNoise": FieldInfo(
        "filter.hard_iron_offset_noise", filter.HardIronOffsetNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), required=("write",), above=0),
        )),
    "SoftIronMatrixNoise": FieldInfo(
        "filter.soft_iron_matrix_noise", filter.SoftIronMatrixNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), required=("write",), above=0),
        )),
    "EnableMeasurements": FieldInfo(
        "filter.enable_measurements", filter.EnableMeasurements, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15",), likely=("3dm-gx4-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("control", "control", "scalar", scalar="u16", required=("write",), type=filter.MeasurementFlags, variants=(Variant("device", ("3dm-cv5-15", "3dm-cx5-15", "3dm-gx5-15"), {"only": ("accel",)}),)),
        )),
    "MagNoise": FieldInfo(
        "filter.mag_noise", filter.MagNoise, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), required=("write",), above=0),
        )),
    "MagneticDeclinationSource": FieldInfo(
        "filter.magnetic_declination_source", filter.MagneticDeclinationSource, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-45"), likely=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ins", "3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=filter.MagParameterSource, variants=(Variant("device", ("3dm-cx7-ahrs", "3dm-gv7-ahrs"), {"only": ("none", "manual")}), Variant("device", ("3dm-gq7",), {"only": ("wmm", "manual")}),)),
            Parameter("declination", "declination", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned", required=("write",)),
        )),
    "AccelMagnitudeErrorAdaptiveMeasurement": FieldInfo(
        "filter.accel_magnitude_error_adaptive_measurement", filter.AccelMagnitudeErrorAdaptiveMeasurement, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("adaptive_measurement", "adaptive_measurement", "scalar", scalar="u8", required=("write",), type=filter.AdaptiveMeasurementSelector, variants=(Variant("device", ("3dm-gq4-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), {"only": ("disabled", "fixed")}),)),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), optional=True, minimum=0),
            Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("m/s^2",), optional=True),
            Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("m/s^2",), optional=True),
            Parameter("low_limit_uncertainty", "low_limit_uncertainty", "scalar", scalar="float", units=("m/s^2",), optional=True, minimum=0),
            Parameter("high_limit_uncertainty", "high_limit_uncertainty", "scalar", scalar="float", units=("m/s^2",), optional=True, minimum=0),
            Parameter("minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("m/s^2",), optional=True, minimum=0),
        )),
    "MagMagnitudeErrorAdaptiveMeasurement": FieldInfo(
        "filter.mag_magnitude_error_adaptive_measurement", filter.MagMagnitudeErrorAdaptiveMeasurement, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), likely=("3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("adaptive_measurement", "adaptive_measurement", "scalar", scalar="u8", required=("write",), type=filter.AdaptiveMeasurementSelector, variants=(Variant("device", ("3dm-gq4-45", "3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), {"only": ("disabled", "fixed")}),)),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), required=("write",), minimum=0),
            Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("gauss",), required=("write",)),
            Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("gauss",), required=("write",)),
            Parameter("low_limit_uncertainty", "low_limit_uncertainty", "scalar", scalar="float", units=("gauss",), required=("write",), minimum=0),
            Parameter("high_limit_uncertainty", "high_limit_uncertainty", "scalar", scalar="float", units=("gauss",), required=("write",), minimum=0),
            Parameter("minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("gauss",), required=("write",), minimum=0),
        )),
    "MagDipAngleErrorAdaptiveMeasurement": FieldInfo(
        "filter.mag_dip_angle_error_adaptive_measurement", filter.MagDipAngleErrorAdaptiveMeasurement, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="bool", required=("write",)),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), required=("write",), minimum=0),
            Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("rad",), required=("write",), minimum=0),
            Parameter("high_limit_uncertainty", "high_limit_uncertainty", "scalar", scalar="float", units=("rad",), required=("write",), minimum=0),
            Parameter("minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("rad",), required=("write",), minimum=0),
        )),
    "AltitudeAiding": FieldInfo(
        "filter.altitude_aiding", filter.AltitudeAiding, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("selector", "selector", "scalar", scalar="u8", required=("write",), type=filter.AltitudeAidingSource),
        )),
    "PitchRollAiding": FieldInfo(
        "filter.pitch_roll_aiding", filter.PitchRollAiding, functions=("write", "read", "save", "load", "default"), devices=("3dm-gx5-15", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("aiding", "aiding", "scalar", scalar="u8", required=("write",), type=filter.PitchRollAidingSource),
        )),
    "MagneticInclinationSource": FieldInfo(
        "filter.magnetic_inclination_source", filter.MagneticInclinationSource, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=filter.MagParameterSource),
            Parameter("inclination", "inclination", "scalar", scalar="float", units=("rad",), minimum=-1.5707963267948966, maximum=1.5707963267948966, frame="ned", required=("write",)),
        )),
    "MagneticMagnitudeSource": FieldInfo(
        "filter.magnetic_magnitude_source", filter.MagneticMagnitudeSource, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=filter.MagParameterSource),
            Parameter("magnitude", "magnitude", "scalar", scalar="float", units=("gauss",), required=("write",), minimum=0),
        )),
    "SensorToVehicleRotationDcm": FieldInfo(
        "filter.sensor_to_vehicle_rotation_dcm", filter.SensorToVehicleRotationDcm, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("dcm", "dcm", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), required=("write",)),
        )),
    "SensorToVehicleRotationQuaternion": FieldInfo(
        "filter.sensor_to_vehicle_rotation_quaternion", filter.SensorToVehicleRotationQuaternion, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",), magnitude=(0.999, 1.001), required=("write",)),
        )),
    "AidingMeasurementEnable": FieldInfo(
        "filter.aiding_measurement_enable", filter.AidingMeasurementEnable, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("aiding_source", "aiding_source", "scalar", scalar="u16", required=("write", "read", "save", "load", "default"), type=filter.AidingSource, variants=(Variant("device", ("3dm-cv7-ahrs", "3dm-cx7-ahrs", "3dm-gv7-ahrs"), {"only": ("mag", "external_heading", "all")}), Variant("device", ("3dm-cv7-ar", "3dm-cx7-ar", "3dm-gv7-ar"), {"only": ("external_heading", "all")}), Variant("device", ("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), {"only": ("gnss_position_velocity", "altimeter", "mag", "external_heading", "external_altimeter", "external_mag", "body_frame_velocity", "all")}), Variant("device", ("3dm-gq7",), {"only": ("gnss_position_velocity", "gnss_heading", "altimeter", "speed", "mag", "external_heading", "all")}),)),
            Parameter("enable", "enable", "scalar", scalar="bool", required=("write",)),
        )),
    "KinematicConstraint": FieldInfo(
        "filter.kinematic_constraint", filter.KinematicConstraint, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("accel_constraint", "accel_constraint", "scalar", scalar="u8", required=("write",), default=0, type=filter.AccelConstraint),
            Parameter("velocity_constraint", "velocity_constraint", "scalar", scalar="u8", required=("write",), default=0, type=filter.VelocityConstraint),
            Parameter("angular_constraint", "angular_constraint", "scalar", scalar="u8", required=("write",), default=0, type=filter.AngularConstraint),
        )),
    "InitializationConfig": FieldInfo(
        "filter.initialization_config", filter.InitializationConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-cv7-ins", "3dm-gq7"), likely=("3dm-gv7-ins",), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("wait_for_run_command", "wait_for_run_command", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("initial_condition_source", "initial_condition_source", "scalar", scalar="u8", required=("write",), type=filter.InitialConditionSource),
            Parameter("auto_heading_alignment_selector", "auto_heading_alignment_selector", "scalar", scalar="u8", required=("write",), type=filter.HeadingAlignment, variants=(Variant("device", ("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), {"only": ("kinematic", "mag", "external")}), Variant("device", ("3dm-gq7",), {"only": ("dual_antenna", "kinematic", "mag")}),)),
            Parameter("initial_heading", "initial_heading", "scalar", scalar="float", units=("deg",), frame="ned", required=("write",)),
            Parameter("initial_pitch", "initial_pitch", "scalar", scalar="float", units=("deg",), frame="ned", required=("write",)),
            Parameter("initial_roll", "initial_roll", "scalar", scalar="float", units=("deg",), frame="ned", required=("write",)),
            Parameter("initial_position", "initial_position", "array", scalar="float", elements=("x", "y", "z"), required=("write",), variants=(Variant("reference_frame_selector", (1,), {"units": ("m",), "frame": "ecef"}), Variant("reference_frame_selector", (2,), {"elements": ("latitude", "longitude", "height"), "units": ("deg", "deg", "m"), "frame": "llh"}),)),
            Parameter("initial_velocity", "initial_velocity", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), required=("write",), variants=(Variant("reference_frame_selector", (1,), {"frame": "ecef"}), Variant("reference_frame_selector", (2,), {"elements": ("north", "east", "down"), "frame": "ned"}),)),
            Parameter("reference_frame_selector", "reference_frame_selector", "scalar", scalar="u8", required=("write",), type=filter.ReferenceFrame),
        )),
    "AdaptiveFilterOptions": FieldInfo(
        "filter.adaptive_filter_options", filter.AdaptiveFilterOptions, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-45"), assumed=("3dm-cx5-45",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("level", "level", "scalar", scalar="u8", default=2, required=("write",), type=filter.AdaptiveLevel, variants=(Variant("device", ("3dm-gx5-45",), {"only": ("off", "moderate")}),)),
            Parameter("time_limit", "time_limit", "scalar", scalar="u16", units=("ms",), required=("write",)),
        )),
    "MultiAntennaOffset": FieldInfo(
        "filter.multi_antenna_offset", filter.MultiAntennaOffset, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1, required=("write", "read", "save", "load", "default")),
            Parameter("antenna_offset", "antenna_offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="vehicle", required=("write",)),
        )),
    "RelativePositionConfig": FieldInfo(
        "filter.relative_position_config", filter.RelativePositionConfig, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ins", "3dm-gq7", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", required=("write",), type=filter.RelativePositionSource),
            Parameter("reference_frame_selector", "reference_frame_selector", "scalar", scalar="u8", required=("write",), type=filter.ReferenceFrame),
            Parameter("reference_coordinates", "reference_coordinates", "array", scalar="double", elements=("x", "y", "z"), required=("write",), variants=(Variant("reference_frame_selector", (1,), {"units": ("m",), "frame": "ecef"}), Variant("reference_frame_selector", (2,), {"elements": ("latitude", "longitude", "height"), "units": ("deg", "deg", "m"), "frame": "llh"}),)),
        )),
    "ReferencePointLeverArm": FieldInfo(
        "filter.reference_point_lever_arm", filter.ReferencePointLeverArm, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("reference_point", "reference_point", "scalar", scalar="u8", required=("write",), type=filter.ReferencePoint),
            Parameter("lever_arm_offset", "lever_arm_offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="vehicle", required=("write",)),
        )),
    "SpeedMeasurement": FieldInfo(
        "filter.speed_measurement", filter.SpeedMeasurement, parameters=(
            Parameter("source", "source", "scalar", scalar="u8", default=1, reserved=True),
            Parameter("tow", "tow", "scalar", scalar="float", units=("s",), maximum=604800, minimum=0),
            Parameter("speed", "speed", "scalar", scalar="float", units=("m/s",), frame="vehicle"),
            Parameter("speed_uncertainty", "speed_uncertainty", "scalar", scalar="float", units=("m/s",), minimum=0),
        )),
    "SpeedLeverArm": FieldInfo(
        "filter.speed_lever_arm", filter.SpeedLeverArm, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("source", "source", "scalar", scalar="u8", default=1, required=("write", "read", "save", "load", "default"), reserved=True),
            Parameter("lever_arm_offset", "lever_arm_offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), frame="vehicle", required=("write",)),
        )),
    "VerticalGyroConstraintControl": FieldInfo(
        "filter.vertical_gyro_constraint_control", filter.VerticalGyroConstraintControl, functions=("write", "read", "save", "load", "default"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
        )),
    "WheeledVehicleConstraintControl": FieldInfo(
        "filter.wheeled_vehicle_constraint_control", filter.WheeledVehicleConstraintControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
        )),
    "GnssAntennaCalibrationControl": FieldInfo(
        "filter.gnss_antenna_calibration_control", filter.GnssAntennaCalibrationControl, functions=("write", "read", "save", "load", "default"), devices=("3dm-cv7-gnss-ins", "3dm-gq7"), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, required=("write",), minimum=0),
            Parameter("max_offset", "max_offset", "scalar", scalar="float", units=("m",), frame="vehicle", required=("write",), minimum=0, variants=(Variant("device", ("3dm-cv7-gnss-ins",), {"minimum": 0, "maximum": 0.5, "default": 0.1}),)),
        )),
    "VehicleDynamicsModeResponse": FieldInfo(
        "filter.vehicle_dynamics_mode_response", filter.VehicleDynamicsModeResponse, devices=("3dm-gx5-45",), likely=("3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("mode", "mode", "scalar", scalar="u8", type=filter.DynamicsMode),
        )),
    "SensorToVehicleRotationEulerResponse": FieldInfo(
        "filter.sensor_to_vehicle_rotation_euler_response", filter.SensorToVehicleRotationEulerResponse, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), frame="sensor"),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), frame="sensor"),
            Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",), frame="sensor"),
        )),
    "SensorToVehicleOffsetResponse": FieldInfo(
        "filter.sensor_to_vehicle_offset_response", filter.SensorToVehicleOffsetResponse, devices=("3dm-gx5-45",), likely=("3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="sensor"),
        )),
    "AntennaOffsetResponse": FieldInfo(
        "filter.antenna_offset_response", filter.AntennaOffsetResponse, devices=("3dm-cv7-gnss-ins", "3dm-cv7-ins", "3dm-gx5-45"), likely=("3dm-cx5-45", "3dm-gv7-ins", "3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx7-ins", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="vehicle", variants=(Variant("device", ("3dm-cx5-45",), {"frame": "sensor"}), Variant("device", ("3dm-gx5-45",), {"frame": "sensor"}),)),
        )),
    "EstimationControlResponse": FieldInfo(
        "filter.estimation_control_response", filter.EstimationControlResponse, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("flags", "flags", "scalar", scalar="u16", type=filter.EstimatedStates),
        )),
    "GnssSourceResponse": FieldInfo(
        "filter.gnss_source_response", filter.GnssSourceResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-45"), likely=("3dm-cv7-ins", "3dm-gx3-45", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=filter.GnssAidingSource),
        )),
    "HeadingSourceResponse": FieldInfo(
        "filter.heading_source_response", filter.HeadingSourceResponse, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cx5-15", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=filter.HeadingUpdateSource),
        )),
    "AutoInitializationControlResponse": FieldInfo(
        "filter.auto_initialization_control_response", filter.AutoInitializationControlResponse, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
        )),
    "AccelNoiseResponse": FieldInfo(
        "filter.accel_noise_response", filter.AccelNoiseResponse, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), above=0),
        )),
    "GyroNoiseResponse": FieldInfo(
        "filter.gyro_noise_response", filter.GyroNoiseResponse, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), above=0),
        )),
    "AccelBiasModelResponse": FieldInfo(
        "filter.accel_bias_model_response", filter.AccelBiasModelResponse, devices=("3dm-cv7-gnss-ins", "3dm-gx5-45"), likely=("3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv7-ins", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), above=0),
        )),
    "GyroBiasModelResponse": FieldInfo(
        "filter.gyro_bias_model_response", filter.GyroBiasModelResponse, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("beta", "beta", "array", scalar="float", elements=("x", "y", "z"), units=("1/s",)),
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), above=0),
        )),
    "AutoZuptResponse": FieldInfo(
        "filter.auto_zupt_response", filter.AutoZuptResponse, devices=("3dm-gq7", "3dm-gx5-45"), likely=("3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("threshold", "threshold", "scalar", scalar="float", units=("m/s",), minimum=0),
        )),
    "AutoAngularZuptResponse": FieldInfo(
        "filter.auto_angular_zupt_response", filter.AutoAngularZuptResponse, devices=("3dm-cv7-gnss-ins", "3dm-cv7-ins", "3dm-cx5-25", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cx5-15", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-rq1-45-st"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("threshold", "threshold", "scalar", scalar="float", units=("rad/s",), minimum=0),
        )),
    "ReferencePositionResponse": FieldInfo(
        "filter.reference_position_response", filter.ReferencePositionResponse, devices=("3dm-gx5-15",), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), minimum=-90, maximum=90, frame="llh"),
            Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), minimum=-180, maximum=180, frame="llh"),
            Parameter("altitude", "altitude", "scalar", scalar="double", units=("m",)),
        )),
    "GravityNoiseResponse": FieldInfo(
        "filter.gravity_noise_response", filter.GravityNoiseResponse, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25"), parameters=(
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("g",), above=0),
        )),
    "PressureAltitudeNoiseResponse": FieldInfo(
        "filter.pressure_altitude_noise_response", filter.PressureAltitudeNoiseResponse, devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("noise", "noise", "scalar", scalar="float", units=("m",), above=0),
        )),
    "HardIronOffsetNoiseResponse": FieldInfo(
        "filter.hard_iron_offset_noise_response", filter.HardIronOffsetNoiseResponse, devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), above=0),
        )),
    "SoftIronMatrixNoiseResponse": FieldInfo(
        "filter.soft_iron_matrix_noise_response", filter.SoftIronMatrixNoiseResponse, devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("noise", "noise", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), above=0),
        )),
    "TareOrientationResponse": FieldInfo(
        "filter.tare_orientation_response", filter.TareOrientationResponse, devices=("3dm-cx5-25",), likely=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("axes", "axes", "scalar", scalar="u8", type=filter.TareAxes),
        )),
    "EnableMeasurementsResponse": FieldInfo(
        "filter.enable_measurements_response", filter.EnableMeasurementsResponse, devices=("3dm-gx5-15",), likely=("3dm-gx4-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx5-25"), parameters=(
            Parameter("control", "control", "scalar", scalar="u16", type=filter.MeasurementFlags),
        )),
    "MagNoiseResponse": FieldInfo(
        "filter.mag_noise_response", filter.MagNoiseResponse, devices=("3dm-gx5-45",), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("noise", "noise", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), above=0),
        )),
    "MagneticDeclinationSourceResponse": FieldInfo(
        "filter.magnetic_declination_source_response", filter.MagneticDeclinationSourceResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-45"), likely=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ins", "3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
            Parameter("declination", "declination", "scalar", scalar="float", units=("rad",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned"),
        )),
    "AccelMagnitudeErrorAdaptiveMeasurementResponse": FieldInfo(
        "filter.accel_magnitude_error_adaptive_measurement_response", filter.AccelMagnitudeErrorAdaptiveMeasurementResponse, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("adaptive_measurement", "adaptive_measurement", "scalar", scalar="u8", type=filter.AdaptiveMeasurementSelector),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), minimum=0),
            Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("m/s^2",)),
            Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("m/s^2",)),
            Parameter("low_limit_uncertainty", "low_limit_uncertainty", "scalar", scalar="float", units=("m/s^2",), minimum=0),
            Parameter("high_limit_uncertainty", "high_limit_uncertainty", "scalar", scalar="float", units=("m/s^2",), minimum=0),
            Parameter("minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("m/s^2",), minimum=0),
        )),
    "MagMagnitudeErrorAdaptiveMeasurementResponse": FieldInfo(
        "filter.mag_magnitude_error_adaptive_measurement_response", filter.MagMagnitudeErrorAdaptiveMeasurementResponse, devices=("3dm-gx5-45",), likely=("3dm-gx3-45", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("adaptive_measurement", "adaptive_measurement", "scalar", scalar="u8", type=filter.AdaptiveMeasurementSelector),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), minimum=0),
            Parameter("low_limit", "low_limit", "scalar", scalar="float", units=("gauss",)),
            Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("gauss",)),
            Parameter("low_limit_uncertainty", "low_limit_uncertainty", "scalar", scalar="float", units=("gauss",), minimum=0),
            Parameter("high_limit_uncertainty", "high_limit_uncertainty", "scalar", scalar="float", units=("gauss",), minimum=0),
            Parameter("minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("gauss",), minimum=0),
        )),
    "MagDipAngleErrorAdaptiveMeasurementResponse": FieldInfo(
        "filter.mag_dip_angle_error_adaptive_measurement_response", filter.MagDipAngleErrorAdaptiveMeasurementResponse, devices=("3dm-gx5-45",), likely=("3dm-gx4-25", "3dm-gx4-45", "3dm-rq1-45-lt"), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gq4-45", "3dm-gx5-25", "3dm-rq1-45-st"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="bool"),
            Parameter("frequency", "frequency", "scalar", scalar="float", units=("Hz",), minimum=0),
            Parameter("high_limit", "high_limit", "scalar", scalar="float", units=("rad",), minimum=0),
            Parameter("high_limit_uncertainty", "high_limit_uncertainty", "scalar", scalar="float", units=("rad",), minimum=0),
            Parameter("minimum_uncertainty", "minimum_uncertainty", "scalar", scalar="float", units=("rad",), minimum=0),
        )),
    "AltitudeAidingResponse": FieldInfo(
        "filter.altitude_aiding_response", filter.AltitudeAidingResponse, devices=("3dm-gx5-45",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("selector", "selector", "scalar", scalar="u8", type=filter.AltitudeAidingSource),
        )),
    "PitchRollAidingResponse": FieldInfo(
        "filter.pitch_roll_aiding_response", filter.PitchRollAidingResponse, devices=("3dm-gx5-15", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25"), parameters=(
            Parameter("aiding", "aiding", "scalar", scalar="u8", type=filter.PitchRollAidingSource),
        )),
    "MagneticInclinationSourceResponse": FieldInfo(
        "filter.magnetic_inclination_source_response", filter.MagneticInclinationSourceResponse, parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
            Parameter("inclination", "inclination", "scalar", scalar="float", units=("rad",), minimum=-1.5707963267948966, maximum=1.5707963267948966, frame="ned"),
        )),
    "MagneticMagnitudeSourceResponse": FieldInfo(
        "filter.magnetic_magnitude_source_response", filter.MagneticMagnitudeSourceResponse, parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=filter.MagParameterSource),
            Parameter("magnitude", "magnitude", "scalar", scalar="float", units=("gauss",), minimum=0),
        )),
    "SensorToVehicleRotationDcmResponse": FieldInfo(
        "filter.sensor_to_vehicle_rotation_dcm_response", filter.SensorToVehicleRotationDcmResponse, parameters=(
            Parameter("dcm", "dcm", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",)),
        )),
    "SensorToVehicleRotationQuaternionResponse": FieldInfo(
        "filter.sensor_to_vehicle_rotation_quaternion_response", filter.SensorToVehicleRotationQuaternionResponse, parameters=(
            Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",), magnitude=(0.999, 1.001)),
        )),
    "AidingMeasurementEnableResponse": FieldInfo(
        "filter.aiding_measurement_enable_response", filter.AidingMeasurementEnableResponse, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins"), likely=("3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), parameters=(
            Parameter("aiding_source", "aiding_source", "scalar", scalar="u16", type=filter.AidingSource),
            Parameter("enable", "enable", "scalar", scalar="bool"),
        )),
    "KinematicConstraintResponse": FieldInfo(
        "filter.kinematic_constraint_response", filter.KinematicConstraintResponse, parameters=(
            Parameter("accel_constraint", "accel_constraint", "scalar", scalar="u8", default=0, type=filter.AccelConstraint),
            Parameter("velocity_constraint", "velocity_constraint", "scalar", scalar="u8", default=0, type=filter.VelocityConstraint),
            Parameter("angular_constraint", "angular_constraint", "scalar", scalar="u8", default=0, type=filter.AngularConstraint),
        )),
    "InitializationConfigResponse": FieldInfo(
        "filter.initialization_config_response", filter.InitializationConfigResponse, devices=("3dm-cv7-gnss-ins", "3dm-cv7-ins", "3dm-gq7"), likely=("3dm-gv7-ins",), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("wait_for_run_command", "wait_for_run_command", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("initial_condition_source", "initial_condition_source", "scalar", scalar="u8", type=filter.InitialConditionSource),
            Parameter("auto_heading_alignment_selector", "auto_heading_alignment_selector", "scalar", scalar="u8", type=filter.HeadingAlignment),
            Parameter("initial_heading", "initial_heading", "scalar", scalar="float", units=("deg",), frame="ned"),
            Parameter("initial_pitch", "initial_pitch", "scalar", scalar="float", units=("deg",), frame="ned"),
            Parameter("initial_roll", "initial_roll", "scalar", scalar="float", units=("deg",), frame="ned"),
            Parameter("initial_position", "initial_position", "array", scalar="float", elements=("x", "y", "z"), variants=(Variant("reference_frame_selector", (1,), {"units": ("m",), "frame": "ecef"}), Variant("reference_frame_selector", (2,), {"elements": ("latitude", "longitude", "height"), "units": ("deg", "deg", "m"), "frame": "llh"}),)),
            Parameter("initial_velocity", "initial_velocity", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), variants=(Variant("reference_frame_selector", (1,), {"frame": "ecef"}), Variant("reference_frame_selector", (2,), {"elements": ("north", "east", "down"), "frame": "ned"}),)),
            Parameter("reference_frame_selector", "reference_frame_selector", "scalar", scalar="u8", type=filter.ReferenceFrame),
        )),
    "AdaptiveFilterOptionsResponse": FieldInfo(
        "filter.adaptive_filter_options_response", filter.AdaptiveFilterOptionsResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-45"), assumed=("3dm-cx5-45",), parameters=(
            Parameter("level", "level", "scalar", scalar="u8", default=2, type=filter.AdaptiveLevel),
            Parameter("time_limit", "time_limit", "scalar", scalar="u16", units=("ms",)),
        )),
    "MultiAntennaOffsetResponse": FieldInfo(
        "filter.multi_antenna_offset_response", filter.MultiAntennaOffsetResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
            Parameter("antenna_offset", "antenna_offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="vehicle"),
        )),
    "RelativePositionConfigResponse": FieldInfo(
        "filter.relative_position_config_response", filter.RelativePositionConfigResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-cv7-ins", "3dm-gq7", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("source", "source", "scalar", scalar="u8", type=filter.RelativePositionSource),
            Parameter("reference_frame_selector", "reference_frame_selector", "scalar", scalar="u8", type=filter.ReferenceFrame),
            Parameter("reference_coordinates", "reference_coordinates", "array", scalar="double", elements=("x", "y", "z"), variants=(Variant("reference_frame_selector", (1,), {"units": ("m",), "frame": "ecef"}), Variant("reference_frame_selector", (2,), {"elements": ("latitude", "longitude", "height"), "units": ("deg", "deg", "m"), "frame": "llh"}),)),
        )),
    "ReferencePointLeverArmResponse": FieldInfo(
        "filter.reference_point_lever_arm_response", filter.ReferencePointLeverArmResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("reference_point", "reference_point", "scalar", scalar="u8", type=filter.ReferencePoint),
            Parameter("lever_arm_offset", "lever_arm_offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), magnitude=(None, 10), frame="vehicle"),
        )),
    "SpeedLeverArmResponse": FieldInfo(
        "filter.speed_lever_arm_response", filter.SpeedLeverArmResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("source", "source", "scalar", scalar="u8", default=1, reserved=True),
            Parameter("lever_arm_offset", "lever_arm_offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), frame="vehicle"),
        )),
    "VerticalGyroConstraintControlResponse": FieldInfo(
        "filter.vertical_gyro_constraint_control_response", filter.VerticalGyroConstraintControlResponse, parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
        )),
    "WheeledVehicleConstraintControlResponse": FieldInfo(
        "filter.wheeled_vehicle_constraint_control_response", filter.WheeledVehicleConstraintControlResponse, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gq7",), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
        )),
    "GnssAntennaCalibrationControlResponse": FieldInfo(
        "filter.gnss_antenna_calibration_control_response", filter.GnssAntennaCalibrationControlResponse, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), parameters=(
            Parameter("enable", "enable", "scalar", scalar="u8", maximum=1, minimum=0),
            Parameter("max_offset", "max_offset", "scalar", scalar="float", units=("m",), frame="vehicle", minimum=0),
        )),
}
