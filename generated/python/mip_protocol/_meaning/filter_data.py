"""The meaning of the types of `filter_data`."""

from __future__ import annotations

from .. import filter_data
from ..info import BitsInfo, EnumInfo, FieldInfo, Info
from ..parameter import Flag, Parameter, Variant

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "ValidFlags": BitsInfo("filter_data.valid_flags", filter_data.ValidFlags),
    "HeadingSourceFlags": BitsInfo("filter_data.heading_source_flags", filter_data.HeadingSourceFlags),
    "GnssAidingStatus": BitsInfo("filter_data.gnss_aiding_status", filter_data.GnssAidingStatus),
    "HeadingAidingType": EnumInfo("filter_data.heading_aiding_type", filter_data.HeadingAidingType),
    "AidingMeasurementType": EnumInfo("filter_data.aiding_measurement_type", filter_data.AidingMeasurementType),
    "AidingMeasurementIndicator": BitsInfo("filter_data.aiding_measurement_indicator", filter_data.AidingMeasurementIndicator),
    "DualAntennaFixType": EnumInfo("filter_data.dual_antenna_fix_type", filter_data.DualAntennaFixType),
    "DualAntennaStatusFlags": BitsInfo("filter_data.dual_antenna_status_flags", filter_data.DualAntennaStatusFlags),
    "Gx5FilterState": EnumInfo("filter_data.gx5_filter_state", filter_data.Gx5FilterState),
    "Cv7FilterState": EnumInfo("filter_data.cv7_filter_state", filter_data.Cv7FilterState),
    "Gx5DynamicsMode": EnumInfo("filter_data.gx5_dynamics_mode", filter_data.Gx5DynamicsMode),
    "Cv7DynamicsMode": EnumInfo("filter_data.cv7_dynamics_mode", filter_data.Cv7DynamicsMode),
    "Gx5StatusFlags": BitsInfo("filter_data.gx5_status_flags", filter_data.Gx5StatusFlags, aliases=("init_no_attitude", "init_no_position_velocity"), concerns={"run_imu_unavailable": ("sensor.scaled_accel", "sensor.scaled_gyro"), "run_gps_unavailable": ("filter_data.llh_position", "filter_data.ned_velocity"), "run_matrix_singularity": ("filter.reset",), "run_position_covariance_warning": ("filter_data.llh_position", "filter_data.llh_position_uncertainty"), "run_velocity_covariance_warning": ("filter_data.ned_velocity", "filter_data.ned_velocity_uncertainty"), "run_attitude_covariance_warning": ("filter_data.euler_angles", "filter_data.euler_angles_uncertainty"), "run_nan_in_solution_warning": ("filter.reset",), "run_gyro_bias_est_high_warning": ("filter_data.gyro_bias",), "run_accel_bias_est_high_warning": ("filter_data.accel_bias",), "run_gyro_scale_factor_est_high_warning": ("filter_data.gyro_scale_factor",), "run_accel_scale_factor_est_high_warning": ("filter_data.accel_scale_factor",), "run_mag_bias_est_high_warning": ("filter_data.mag_bias",), "run_antenna_offset_correction_est_high_warning": ("filter_data.antenna_offset_correction", "filter.antenna_offset"), "run_mag_hard_iron_est_high_warning": ("filter_data.mag_offset",), "run_mag_soft_iron_est_high_warning": ("filter_data.mag_matrix",), "init_no_attitude": ("filter_data.attitude_quaternion", "filter_data.attitude_dcm", "filter_data.euler_angles"), "init_no_position_velocity": ("filter_data.llh_position", "filter_data.ned_velocity")}, states={"run_imu_unavailable": ("filter_state", (2, 3)), "run_gps_unavailable": ("filter_state", (2, 3)), "run_matrix_singularity": ("filter_state", (2, 3)), "run_position_covariance_warning": ("filter_state", (2, 3)), "run_velocity_covariance_warning": ("filter_state", (2, 3)), "run_attitude_covariance_warning": ("filter_state", (2, 3)), "run_nan_in_solution_warning": ("filter_state", (2, 3)), "run_gyro_bias_est_high_warning": ("filter_state", (2, 3)), "run_accel_bias_est_high_warning": ("filter_state", (2, 3)), "run_gyro_scale_factor_est_high_warning": ("filter_state", (2, 3)), "run_accel_scale_factor_est_high_warning": ("filter_state", (2, 3)), "run_mag_bias_est_high_warning": ("filter_state", (2, 3)), "run_antenna_offset_correction_est_high_warning": ("filter_state", (2, 3)), "run_mag_hard_iron_est_high_warning": ("filter_state", (2, 3)), "run_mag_soft_iron_est_high_warning": ("filter_state", (2, 3)), "init_no_attitude": ("filter_state", (1,)), "init_no_position_velocity": ("filter_state", (1,))}),
    "FilterCondition": EnumInfo("filter_data.filter_condition", filter_data.FilterCondition),
    "Cv7StatusFlags": BitsInfo("filter_data.cv7_status_flags", filter_data.Cv7StatusFlags, concerns={"roll_pitch_warning": ("filter_data.attitude_quaternion", "filter_data.attitude_dcm", "filter_data.euler_angles"), "heading_warning": ("filter_data.attitude_quaternion", "filter_data.attitude_dcm", "filter_data.euler_angles"), "position_warning": ("filter_data.llh_position", "filter_data.ecef_position", "filter_data.ned_relative_position"), "velocity_warning": ("filter_data.ned_velocity", "filter_data.ecef_velocity"), "imu_bias_warning": ("filter_data.accel_bias", "filter_data.gyro_bias", "3dm.capture_gyro_bias"), "gnss_clock_warning": ("filter_data.timestamp", "filter_data.clock_correction"), "antenna_lever_arm_warning": ("filter_data.multi_antenna_offset_correction", "filter.multi_antenna_offset"), "mounting_transform_warning": ("3dm.sensor_to_vehicle_transform_euler", "3dm.sensor_to_vehicle_transform_dcm"), "time_sync_warning": ("3dm.pps_source_control",), "solution_error": ("filter.reset",)}, numbers={"filter_condition": filter_data.FilterCondition}),
    "LlhPosition": FieldInfo(
        "filter_data.llh_position", filter_data.LlhPosition, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-cx5-45", "3dm-gv7-ins", "3dm-gx3-45", "3dm-gx4-45", "3dm-gx5-45", "3dm-rq1-45-lt"), assumed=("3dm-cx7-ins", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("latitude", "latitude", "scalar", scalar="double", units=("deg",), valid=("valid_flags.valid",), minimum=-90, maximum=90, frame="llh", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("longitude", "longitude", "scalar", scalar="double", units=("deg",), valid=("valid_flags.valid",), minimum=-180, maximum=180, frame="llh", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("ellipsoid_height", "ellipsoid_height", "scalar", scalar="double", units=("m",), valid=("valid_flags.valid",), frame="llh", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "NedVelocity": FieldInfo(
        "filter_data.ned_velocity", filter_data.NedVelocity, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-cx5-45", "3dm-gv7-ins", "3dm-gx3-45", "3dm-gx4-45", "3dm-gx5-45", "3dm-rq1-45-lt"), assumed=("3dm-cx7-ins", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("north", "north", "scalar", scalar="float", units=("m/s",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("east", "east", "scalar", scalar="float", units=("m/s",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("down", "down", "scalar", scalar="float", units=("m/s",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AttitudeQuaternion": FieldInfo(
        "filter_data.attitude_quaternion", filter_data.AttitudeQuaternion, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15"), likely=("3dm-cv7-ins", "3dm-cx5-45", "3dm-gx4-25", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-45"), parameters=(
            Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AttitudeDcm": FieldInfo(
        "filter_data.attitude_dcm", filter_data.AttitudeDcm, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45"), parameters=(
            Parameter("dcm", "dcm", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "EulerAngles": FieldInfo(
        "filter_data.euler_angles", filter_data.EulerAngles, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-25", "3dm-rq1-45-lt"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq4-45", "3dm-rq1-45-st"), parameters=(
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=-1.5707963267948966, maximum=1.5707963267948966, frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GyroBias": FieldInfo(
        "filter_data.gyro_bias", filter_data.GyroBias, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gx5-15"), likely=("3dm-gx4-25", "3dm-gx5-25"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AccelBias": FieldInfo(
        "filter_data.accel_bias", filter_data.AccelBias, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins", "3dm-gx5-45"), parameters=(
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "LlhPositionUncertainty": FieldInfo(
        "filter_data.llh_position_uncertainty", filter_data.LlhPositionUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins",), assumed=("3dm-cx5-45", "3dm-cx7-ins", "3dm-gv7-ins", "3dm-gx5-45"), parameters=(
            Parameter("north", "north", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), frame="ned", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("east", "east", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), frame="ned", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("down", "down", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), frame="ned", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "NedVelocityUncertainty": FieldInfo(
        "filter_data.ned_velocity_uncertainty", filter_data.NedVelocityUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins",), assumed=("3dm-cx5-45", "3dm-cx7-ins", "3dm-gv7-ins", "3dm-gx5-45"), parameters=(
            Parameter("north", "north", "scalar", scalar="float", units=("m/s",), valid=("valid_flags.valid",), frame="ned", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("east", "east", "scalar", scalar="float", units=("m/s",), valid=("valid_flags.valid",), frame="ned", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("down", "down", "scalar", scalar="float", units=("m/s",), valid=("valid_flags.valid",), frame="ned", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "EulerAnglesUncertainty": FieldInfo(
        "filter_data.euler_angles_uncertainty", filter_data.EulerAnglesUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15"), likely=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-gx4-25", "3dm-gx5-25"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("roll", "roll", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("pitch", "pitch", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("yaw", "yaw", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GyroBiasUncertainty": FieldInfo(
        "filter_data.gyro_bias_uncertainty", filter_data.GyroBiasUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"), likely=("3dm-gx4-25", "3dm-gx5-25"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("bias_uncertainty", "bias_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AccelBiasUncertainty": FieldInfo(
        "filter_data.accel_bias_uncertainty", filter_data.AccelBiasUncertainty, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins", "3dm-gx5-45"), parameters=(
            Parameter("bias_uncertainty", "bias_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "LinearAccel": FieldInfo(
        "filter_data.linear_accel", filter_data.LinearAccel, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15"), likely=("3dm-cv7-ins", "3dm-gx5-25"), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("accel", "accel", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "CompAngularRate": FieldInfo(
        "filter_data.comp_angular_rate", filter_data.CompAngularRate, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx5-25"), assumed=("3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45"), parameters=(
            Parameter("gyro", "gyro", "array", scalar="float", elements=("x", "y", "z"), units=("rad/s",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "Wgs84GravityMagnitude": FieldInfo(
        "filter_data.wgs84_gravity_magnitude", filter_data.Wgs84GravityMagnitude, devices=("3dm-gx5-15",), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("gravity_magnitude", "gravity_magnitude", "scalar", scalar="float", units=("m/s^2",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "Status": FieldInfo(
        "filter_data.status", filter_data.Status, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45"), parameters=(
            Parameter("filter_state", "filter_state", "scalar", scalar="u16", variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-15", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"), {"type": filter_data.Gx5FilterState}), Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), {"type": filter_data.Cv7FilterState}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": filter_data.Cv7FilterState}), Variant("device", ("3dm-gx5-15",), {"type": filter_data.Gx5FilterState}),)),
            Parameter("dynamics_mode", "dynamics_mode", "scalar", scalar="u16", variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-15", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"), {"type": filter_data.Gx5DynamicsMode}), Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), {"type": filter_data.Cv7DynamicsMode}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": filter_data.Cv7DynamicsMode}), Variant("device", ("3dm-gx5-15",), {"type": filter_data.Gx5DynamicsMode}),)),
            Parameter("status_flags", "status_flags", "scalar", scalar="u16", variants=(Variant("device", ("3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-15", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"), {"type": filter_data.Gx5StatusFlags}), Variant("device", ("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins"), {"type": filter_data.Cv7StatusFlags}), Variant("device", ("3dm-cv7-gnss-ins",), {"type": filter_data.Cv7StatusFlags}), Variant("device", ("3dm-gx5-15",), {"type": filter_data.Gx5StatusFlags}),)),
        )),
    "Timestamp": FieldInfo(
        "filter_data.timestamp", filter_data.Timestamp, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-25", "3dm-gx5-45"), assumed=("3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="double", units=("s",), valid=("valid_flags.valid",), below=604800, minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("week_number", "week_number", "scalar", scalar="u16", units=("week",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "QuaternionAttitudeUncertainty": FieldInfo(
        "filter_data.quaternion_attitude_uncertainty", filter_data.QuaternionAttitudeUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("q", "q", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GravityVector": FieldInfo(
        "filter_data.gravity_vector", filter_data.GravityVector, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gx5-15"), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("gravity", "gravity", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "HeadingUpdateState": FieldInfo(
        "filter_data.heading_update_state", filter_data.HeadingUpdateState, devices=("3dm-gx5-15", "3dm-gx5-45"), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx4-25", "3dm-gx4-45"), parameters=(
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("source", "source", "scalar", scalar="u16", type=filter_data.HeadingSourceFlags, variants=(Variant("device", ("3dm-cv5-15", "3dm-cx5-15", "3dm-gx5-15"), {"only": ("external",)}), Variant("device", ("3dm-cv5-25", "3dm-cx5-25", "3dm-gx4-25", "3dm-gx5-25"), {"only": ("mag", "external")}),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagneticModel": FieldInfo(
        "filter_data.magnetic_model", filter_data.MagneticModel, devices=("3dm-cv7-gnss-ins",), likely=("3dm-gx5-25",), assumed=("3dm-cv5-25", "3dm-cv7-ins", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ins", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-45"), parameters=(
            Parameter("intensity_north", "intensity_north", "scalar", scalar="float", units=("gauss",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("intensity_east", "intensity_east", "scalar", scalar="float", units=("gauss",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("intensity_down", "intensity_down", "scalar", scalar="float", units=("gauss",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("inclination", "inclination", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=-1.5707963267948966, maximum=1.5707963267948966, frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("declination", "declination", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=-3.141592653589793, maximum=3.141592653589793, frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GyroScaleFactor": FieldInfo(
        "filter_data.gyro_scale_factor", filter_data.GyroScaleFactor, parameters=(
            Parameter("scale_factor", "scale_factor", "array", scalar="float", elements=("x", "y", "z"), units=("1",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AccelScaleFactor": FieldInfo(
        "filter_data.accel_scale_factor", filter_data.AccelScaleFactor, parameters=(
            Parameter("scale_factor", "scale_factor", "array", scalar="float", elements=("x", "y", "z"), units=("1",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GyroScaleFactorUncertainty": FieldInfo(
        "filter_data.gyro_scale_factor_uncertainty", filter_data.GyroScaleFactorUncertainty, parameters=(
            Parameter("scale_factor_uncertainty", "scale_factor_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("1",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AccelScaleFactorUncertainty": FieldInfo(
        "filter_data.accel_scale_factor_uncertainty", filter_data.AccelScaleFactorUncertainty, parameters=(
            Parameter("scale_factor_uncertainty", "scale_factor_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("1",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagBias": FieldInfo(
        "filter_data.mag_bias", filter_data.MagBias, parameters=(
            Parameter("bias", "bias", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagBiasUncertainty": FieldInfo(
        "filter_data.mag_bias_uncertainty", filter_data.MagBiasUncertainty, parameters=(
            Parameter("bias_uncertainty", "bias_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "CompAccel": FieldInfo(
        "filter_data.comp_accel", filter_data.CompAccel, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gq7", "3dm-gx5-15"), likely=("3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-15", "3dm-cx5-25", "3dm-gx5-25"), assumed=("3dm-cv7-ins", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-45"), parameters=(
            Parameter("accel", "accel", "array", scalar="float", elements=("x", "y", "z"), units=("m/s^2",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "StandardAtmosphere": FieldInfo(
        "filter_data.standard_atmosphere", filter_data.StandardAtmosphere, assumed=("3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("geometric_altitude", "geometric_altitude", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("geopotential_altitude", "geopotential_altitude", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("standard_temperature", "standard_temperature", "scalar", scalar="float", units=("degC",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("standard_pressure", "standard_pressure", "scalar", scalar="float", units=("mbar",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("standard_density", "standard_density", "scalar", scalar="float", units=("kg/m^3",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "PressureAltitude": FieldInfo(
        "filter_data.pressure_altitude", filter_data.PressureAltitude, devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"), likely=("3dm-gx5-25",), assumed=("3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-cx7-ahrs", "3dm-cx7-ar", "3dm-cx7-ins", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx5-45"), parameters=(
            Parameter("pressure_altitude", "pressure_altitude", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), maximum=84852, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "DensityAltitude": FieldInfo(
        "filter_data.density_altitude", filter_data.DensityAltitude, parameters=(
            Parameter("density_altitude", "density_altitude", "scalar", scalar="float", units=("m",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagOffset": FieldInfo(
        "filter_data.mag_offset", filter_data.MagOffset, likely=("3dm-gx5-25",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("hard_iron", "hard_iron", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagMatrix": FieldInfo(
        "filter_data.mag_matrix", filter_data.MagMatrix, likely=("3dm-gx5-25",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("soft_iron", "soft_iron", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), valid=("valid_flags.valid",), frame="sensor", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagOffsetUncertainty": FieldInfo(
        "filter_data.mag_offset_uncertainty", filter_data.MagOffsetUncertainty, likely=("3dm-gx5-25",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("hard_iron_uncertainty", "hard_iron_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagMatrixUncertainty": FieldInfo(
        "filter_data.mag_matrix_uncertainty", filter_data.MagMatrixUncertainty, likely=("3dm-gx5-25",), assumed=("3dm-cv5-25", "3dm-cx5-25", "3dm-cx5-45", "3dm-gx5-45"), parameters=(
            Parameter("soft_iron_uncertainty", "soft_iron_uncertainty", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), valid=("valid_flags.valid",), frame="sensor", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagCovarianceMatrix": FieldInfo(
        "filter_data.mag_covariance_matrix", filter_data.MagCovarianceMatrix, parameters=(
            Parameter("covariance", "covariance", "array", scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MagResidualVector": FieldInfo(
        "filter_data.mag_residual_vector", filter_data.MagResidualVector, parameters=(
            Parameter("residual", "residual", "array", scalar="float", elements=("x", "y", "z"), units=("gauss",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AntennaOffsetCorrection": FieldInfo(
        "filter_data.antenna_offset_correction", filter_data.AntennaOffsetCorrection, parameters=(
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AntennaOffsetCorrectionUncertainty": FieldInfo(
        "filter_data.antenna_offset_correction_uncertainty", filter_data.AntennaOffsetCorrectionUncertainty, parameters=(
            Parameter("offset_uncertainty", "offset_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.valid",), frame="vehicle", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "ClockCorrection": FieldInfo(
        "filter_data.clock_correction", filter_data.ClockCorrection, parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
            Parameter("bias", "bias", "scalar", scalar="float", units=("s",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("bias_drift", "bias_drift", "scalar", scalar="float", units=("s/s",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "ClockCorrectionUncertainty": FieldInfo(
        "filter_data.clock_correction_uncertainty", filter_data.ClockCorrectionUncertainty, parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8", minimum=1),
            Parameter("bias_uncertainty", "bias_uncertainty", "scalar", scalar="float", units=("s",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("bias_drift_uncertainty", "bias_drift_uncertainty", "scalar", scalar="float", units=("s/s",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MultiAntennaOffsetCorrection": FieldInfo(
        "filter_data.multi_antenna_offset_correction", filter_data.MultiAntennaOffsetCorrection, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
            Parameter("offset", "offset", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.valid",), frame="vehicle", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "MultiAntennaOffsetCorrectionUncertainty": FieldInfo(
        "filter_data.multi_antenna_offset_correction_uncertainty", filter_data.MultiAntennaOffsetCorrectionUncertainty, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-gq7",), parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
            Parameter("offset_uncertainty", "offset_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.valid",), frame="vehicle", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "EcefPositionUncertainty": FieldInfo(
        "filter_data.ecef_position_uncertainty", filter_data.EcefPositionUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("position_uncertainty", "position_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.valid",), frame="ecef", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "EcefVelocityUncertainty": FieldInfo(
        "filter_data.ecef_velocity_uncertainty", filter_data.EcefVelocityUncertainty, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("velocity_uncertainty", "velocity_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.valid",), frame="ecef", minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "EcefPosition": FieldInfo(
        "filter_data.ecef_position", filter_data.EcefPosition, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("position", "position", "array", scalar="double", elements=("x", "y", "z"), units=("m",), valid=("valid_flags.valid",), frame="ecef", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "EcefVelocity": FieldInfo(
        "filter_data.ecef_velocity", filter_data.EcefVelocity, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("velocity", "velocity", "array", scalar="float", elements=("x", "y", "z"), units=("m/s",), valid=("valid_flags.valid",), frame="ecef", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "NedRelativePosition": FieldInfo(
        "filter_data.ned_relative_position", filter_data.NedRelativePosition, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("relative_position", "relative_position", "array", scalar="double", elements=("north", "east", "down"), units=("m",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GnssPositionAidingStatus": FieldInfo(
        "filter_data.gnss_position_aiding_status", filter_data.GnssPositionAidingStatus, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("receiver_id", "receiver_id", "scalar", scalar="u8"),
            Parameter("tow", "tow", "scalar", scalar="float", units=("s",), maximum=604800, minimum=0),
            Parameter("status", "status", "scalar", scalar="u16", type=filter_data.GnssAidingStatus),
            Parameter("reserved", "reserved", "array", scalar="u8", length=8, reserved=True, default=0),
        )),
    "GnssAttitudeAidingStatus": FieldInfo(
        "filter_data.gnss_attitude_aiding_status", filter_data.GnssAttitudeAidingStatus, parameters=(
            Parameter("tow", "tow", "scalar", scalar="float", units=("s",), maximum=604800, minimum=0),
            Parameter("status", "status", "scalar", scalar="u16", type=filter_data.GnssAidingStatus),
            Parameter("reserved", "reserved", "array", scalar="u8", length=8, reserved=True, default=0),
        )),
    "HeadingAidingStatus": FieldInfo(
        "filter_data.heading_aiding_status", filter_data.HeadingAidingStatus, parameters=(
            Parameter("tow", "tow", "scalar", scalar="float", units=("s",), maximum=604800, minimum=0),
            Parameter("type", "type", "scalar", scalar="u8", type=filter_data.HeadingAidingType),
            Parameter("reserved", "reserved", "array", scalar="float", length=2, reserved=True, default=0.0),
        )),
    "AidingMeasurementSummary": FieldInfo(
        "filter_data.aiding_measurement_summary", filter_data.AidingMeasurementSummary, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), likely=("3dm-cv7-ins", "3dm-gv7-ins"), assumed=("3dm-cx7-ins",), parameters=(
            Parameter("tow", "tow", "scalar", scalar="float", units=("s",), maximum=604800, minimum=0),
            Parameter("source", "source", "scalar", scalar="u8"),
            Parameter("type", "type", "scalar", scalar="u8", type=filter_data.AidingMeasurementType),
            Parameter("indicator", "indicator", "scalar", scalar="u8", type=filter_data.AidingMeasurementIndicator),
        )),
    "OdometerScaleFactorError": FieldInfo(
        "filter_data.odometer_scale_factor_error", filter_data.OdometerScaleFactorError, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-gq7",), parameters=(
            Parameter("scale_factor_error", "scale_factor_error", "scalar", scalar="float", units=("1",), valid=("valid_flags.valid",), flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "OdometerScaleFactorErrorUncertainty": FieldInfo(
        "filter_data.odometer_scale_factor_error_uncertainty", filter_data.OdometerScaleFactorErrorUncertainty, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-gq7",), parameters=(
            Parameter("scale_factor_error_uncertainty", "scale_factor_error_uncertainty", "scalar", scalar="float", units=("1",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "GnssDualAntennaStatus": FieldInfo(
        "filter_data.gnss_dual_antenna_status", filter_data.GnssDualAntennaStatus, devices=("3dm-cv7-gnss-ins", "3dm-gq7"), parameters=(
            Parameter("tow", "tow", "scalar", scalar="float", units=("s",), valid=("valid_flags.valid",), maximum=604800, minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("heading", "heading", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), frame="ned", flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("heading_uncertainty", "heading_uncertainty", "scalar", scalar="float", units=("rad",), valid=("valid_flags.valid",), minimum=0, flags=(Flag("valid_flags.valid", "valid_flags", 0x1),)),
            Parameter("fix_type", "fix_type", "scalar", scalar="u8", type=filter_data.DualAntennaFixType),
            Parameter("status_flags", "status_flags", "scalar", scalar="u16", type=filter_data.DualAntennaStatusFlags),
            Parameter("valid_flags", "valid_flags", "scalar", scalar="u16", type=filter_data.ValidFlags),
        )),
    "AidingFrameConfigError": FieldInfo(
        "filter_data.aiding_frame_config_error", filter_data.AidingFrameConfigError, devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-cv7-ins"), assumed=("3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
            Parameter("translation", "translation", "array", scalar="float", elements=("x", "y", "z"), units=("m",)),
            Parameter("attitude", "attitude", "array", scalar="float", elements=("w", "x", "y", "z"), units=("1",)),
        )),
    "AidingFrameConfigErrorUncertainty": FieldInfo(
        "filter_data.aiding_frame_config_error_uncertainty", filter_data.AidingFrameConfigErrorUncertainty, devices=("3dm-cv7-gnss-ins",), assumed=("3dm-cv7-ins", "3dm-cx7-ins", "3dm-gv7-ins"), parameters=(
            Parameter("frame_id", "frame_id", "scalar", scalar="u8"),
            Parameter("translation_uncertainty", "translation_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("m",), minimum=0),
            Parameter("attitude_uncertainty", "attitude_uncertainty", "array", scalar="float", elements=("x", "y", "z"), units=("rad",), minimum=0),
        )),
}
