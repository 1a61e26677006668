"""What the types of `sensor` mean."""

from __future__ import annotations

from .. import sensor, types
from ..info import BitInfo, BitsInfo, FieldInfo, Info, SetInfo
from ..parameter import Flag, Parameter, Variant

# fmt: off
SET = SetInfo("sensor", number=0x80, title="Sensor data", description="Inertial, magnetic and pressure measurements, and the attitude of the complementary filter.", sources=("3dm-gx5-15: 5.1 IMU Data", "3dm-cv7-gnss-ins: Sensor (0x80)"))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "OverrangeFlags": BitsInfo(
        "sensor.overrange_flags", type=sensor.OverrangeFlags, description="Sensor axes that were near or outside their range.",
        bits=(
            BitInfo("accel_x", first=0, last=0, description="Accelerometer X axis."),
            BitInfo("accel_y", first=1, last=1, description="Accelerometer Y axis."),
            BitInfo("accel_z", first=2, last=2, description="Accelerometer Z axis."),
            BitInfo("gyro_x", first=4, last=4, description="Gyroscope X axis."),
            BitInfo("gyro_y", first=5, last=5, description="Gyroscope Y axis."),
            BitInfo("gyro_z", first=6, last=6, description="Gyroscope Z axis."),
            BitInfo("mag_x", first=8, last=8, description="Magnetometer X axis."),
            BitInfo("mag_y", first=9, last=9, description="Magnetometer Y axis."),
            BitInfo("mag_z", first=10, last=10, description="Magnetometer Z axis."),
            BitInfo("pressure", first=12, last=12, description="Pressure sensor."),
        ),
    ),
    "OdometerFlags": BitsInfo(
        "sensor.odometer_flags", type=sensor.OdometerFlags, description="Whether the odometer values are valid.",
        bits=(
            BitInfo("odometer", first=0, last=0, description="The odometer is configured."),
        ),
    ),
    "RawAccel": FieldInfo(
        "sensor.raw_accel", type=sensor.RawAccel,
        title="Raw accel",
        description="Raw acceleration in counts of the sensor, temperature compensated.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Raw Accel (0x80,0x01)",),
        parameters=(
            Parameter("raw_accel", "raw_accel", "array", description="Acceleration in counts.", facts=("Elements: x, y, z.", "Unit: 1.", "Frame: sensor."), scalar="float", elements=("x", "y", "z"), units=("1",), frame="sensor"),
        ),
    ),
    "RawGyro": FieldInfo(
        "sensor.raw_gyro", type=sensor.RawGyro,
        title="Raw gyro",
        description="Raw angular rate in counts of the sensor, temperature compensated.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Raw Gyro (0x80,0x02)",),
        parameters=(
            Parameter("raw_gyro", "raw_gyro", "array", description="Angular rate in counts.", facts=("Elements: x, y, z.", "Unit: 1.", "Frame: sensor."), scalar="float", elements=("x", "y", "z"), units=("1",), frame="sensor"),
        ),
    ),
    "RawMag": FieldInfo(
        "sensor.raw_mag", type=sensor.RawMag,
        title="Raw mag",
        description="Raw magnetic field in counts of the sensor, temperature compensated.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Raw Mag (0x80,0x03)",),
        parameters=(
            Parameter("raw_mag", "raw_mag", "array", description="Magnetic field in counts.", facts=("Elements: x, y, z.", "Unit: 1.", "Frame: vehicle.", "Uncertain: The frame. The SDK has the vehicle frame here, but the sensor frame for raw acceleration and raw angular rate."), scalar="float", elements=("x", "y", "z"), units=("1",), frame="vehicle"),
        ),
    ),
    "ScaledAccel": FieldInfo(
        "sensor.scaled_accel", type=sensor.ScaledAccel,
        title="Scaled accel",
        description="Measured acceleration, temperature compensated.",
        facts=("Supported by 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.",),
        sources=("3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04)", "3dm-cv7-gnss-ins: Scaled Accel (0x80,0x04)"),
        devices=("3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("scaled_accel", "scaled_accel", "array", description="Acceleration.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: vehicle."), scalar="float", elements=("x", "y", "z"), units=("g",), frame="vehicle"),
        ),
    ),
    "ScaledGyro": FieldInfo(
        "sensor.scaled_gyro", type=sensor.ScaledGyro,
        title="Scaled gyro",
        description="Measured angular rate, temperature compensated.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45.",),
        sources=("3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05)", "3dm-cv7-gnss-ins: Scaled Gyro (0x80,0x05)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("scaled_gyro", "scaled_gyro", "array", description="Angular rate.", facts=("Elements: x, y, z.", "Unit: rad/s.", "Frame: vehicle."), scalar="float", elements=("x", "y", "z"), units=("rad/s",), frame="vehicle"),
        ),
    ),
    "ScaledMag": FieldInfo(
        "sensor.scaled_mag", type=sensor.ScaledMag,
        title="Scaled mag",
        description="Measured magnetic field, temperature compensated.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-35 and 3DM-GX5-45.",),
        sources=("3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)",),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("scaled_mag", "scaled_mag", "array", description="Magnetic field.", facts=("Elements: x, y, z.", "Unit: gauss.", "Frame: vehicle."), scalar="float", elements=("x", "y", "z"), units=("gauss",), frame="vehicle"),
        ),
    ),
    "DeltaTheta": FieldInfo(
        "sensor.delta_theta", type=sensor.DeltaTheta,
        title="Delta theta",
        description="Time integral of the angular rate over the period that the message format sets.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45."),
        sources=("3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07)", "3dm-cv7-gnss-ins: Delta Theta (0x80,0x07)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("delta_theta", "delta_theta", "array", description="Integral of the angular rate.", facts=("Elements: x, y, z.", "Unit: rad.", "Frame: vehicle."), scalar="float", elements=("x", "y", "z"), units=("rad",), frame="vehicle"),
        ),
    ),
    "DeltaVelocity": FieldInfo(
        "sensor.delta_velocity", type=sensor.DeltaVelocity,
        title="Delta velocity",
        description="Time integral of the acceleration over the period that the message format sets.",
        facts=("Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45.", "Multiply by 9.80665 m/s^2 for a change of velocity in metres per second."),
        sources=("3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)", "3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("delta_velocity", "delta_velocity", "array", description="Integral of the acceleration.", facts=("Elements: x, y, z.", "Unit: g*s.", "Frame: vehicle."), scalar="float", elements=("x", "y", "z"), units=("g*s",), frame="vehicle"),
        ),
    ),
    "CompOrientationMatrix": FieldInfo(
        "sensor.comp_orientation_matrix", type=sensor.CompOrientationMatrix,
        title="Complementary filter orientation matrix",
        description="Attitude from the complementary filter as a direction cosine matrix, relative to the NED frame.",
        facts=("Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45.", "`v_vehicle = m * v_ned`; the sensor frame takes the place of the vehicle frame on the 3DM-GX5-15."),
        sources=("3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)", "3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("m", "m", "array", description="Rotation from the NED frame to the vehicle frame.", facts=("Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.", "Unit: 1.", "Frame: ned.", "On the 3DM-GX5-15: From the NED frame to the sensor frame."), scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",), frame="ned", variants=(Variant("device", ("3dm-gx5-15",), "On the 3DM-GX5-15: From the NED frame to the sensor frame.", {}),)),
        ),
    ),
    "CompQuaternion": FieldInfo(
        "sensor.comp_quaternion", type=sensor.CompQuaternion,
        title="Complementary filter quaternion",
        description="Attitude from the complementary filter as a quaternion, relative to the NED frame.",
        facts=("Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45.", "`v_vehicle = q^-1 * v_ned * q`; the sensor frame takes the place of the vehicle frame on the 3DM-GX5-15."),
        sources=("3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)", "3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("q", "q", "array", description="Rotation between the NED frame and the vehicle frame.", facts=("Elements: w, x, y, z.", "Unit: 1.", "Frame: ned.", "On the 3DM-GX5-15: Between NED and the sensor frame."), scalar="float", elements=("w", "x", "y", "z"), units=("1",), frame="ned", variants=(Variant("device", ("3dm-gx5-15",), "On the 3DM-GX5-15: Between NED and the sensor frame.", {}),)),
        ),
    ),
    "CompOrientationUpdateMatrix": FieldInfo(
        "sensor.comp_orientation_update_matrix", type=sensor.CompOrientationUpdateMatrix,
        title="Complementary filter orientation update matrix",
        description="Change of the attitude from the complementary filter as a matrix.",
        facts=("Deprecated: the SDK marks it as deprecated and names no replacement.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "Uncertain: The interval of the change and the frames. The SDK gives the name only."),
        sources=("mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B)",),
        deprecated="the SDK marks it as deprecated and names no replacement",
        parameters=(
            Parameter("m", "m", "array", description="Matrix in row-major order.", facts=("Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33.", "Unit: 1."), scalar="float", elements=("m11", "m12", "m13", "m21", "m22", "m23", "m31", "m32", "m33"), units=("1",)),
        ),
    ),
    "CompEulerAngles": FieldInfo(
        "sensor.comp_euler_angles", type=sensor.CompEulerAngles,
        title="Complementary filter Euler angles",
        description="Attitude from the complementary filter as Euler angles, relative to the NED frame.",
        facts=("Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45.", "The rotations are in the order yaw, pitch, roll (3-2-1)."),
        sources=("3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)", "3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15"),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("roll", "roll", "scalar", description="Roll angle.", facts=("Unit: rad.", "Frame: ned."), scalar="float", units=("rad",), frame="ned"),
            Parameter("pitch", "pitch", "scalar", description="Pitch angle.", facts=("Unit: rad.", "Frame: ned."), scalar="float", units=("rad",), frame="ned"),
            Parameter("yaw", "yaw", "scalar", description="Yaw angle.", facts=("Unit: rad.", "Frame: ned."), scalar="float", units=("rad",), frame="ned"),
        ),
    ),
    "OrientationRawTemperature": FieldInfo(
        "sensor.orientation_raw_temperature", type=sensor.OrientationRawTemperature,
        title="Orientation raw temperatures",
        description="Raw readings of four temperature sensors.",
        facts=("Deprecated: the SDK marks it as deprecated and names no replacement.", "Also called `orientation_raw_temp`.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Orientation Raw Temp (0x80,0x0D)",),
        also=("orientation_raw_temp",),
        deprecated="the SDK marks it as deprecated and names no replacement",
        parameters=(
            Parameter("raw_temperature", "raw_temperature", "array", description="Temperatures in counts.", facts=("Unit: 1.", "Uncertain: The scale, and which sensor is which."), scalar="u16", length=4, units=("1",)),
        ),
    ),
    "InternalTimestamp": FieldInfo(
        "sensor.internal_timestamp", type=sensor.InternalTimestamp,
        title="Internal timestamp",
        description="Free-running counter of the device.",
        facts=("Deprecated: the SDK marks it as deprecated and names no replacement.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Internal Timestamp (0x80,0x0E)",),
        deprecated="the SDK marks it as deprecated and names no replacement",
        parameters=(
            Parameter("counts", "counts", "scalar", description="Counter.", facts=("Unit: 1.", "Uncertain: The period of one count."), scalar="u32", units=("1",)),
        ),
    ),
    "PpsTimestamp": FieldInfo(
        "sensor.pps_timestamp", type=sensor.PpsTimestamp,
        title="PPS timestamp",
        description="Time counted by the pulse per second.",
        facts=("Deprecated: the SDK marks it as deprecated and names no replacement.", "Not listed in any device profile.", "Known only from the MicroStrain MIP SDK.", "Uncertain: The epoch."),
        sources=("mip-sdk-4: Pps Timestamp (0x80,0x0F)",),
        deprecated="the SDK marks it as deprecated and names no replacement",
        parameters=(
            Parameter("seconds", "seconds", "scalar", description="Whole seconds.", facts=("Unit: s.", "Uncertain: The unit; it follows from the name."), scalar="u32", units=("s",)),
            Parameter("useconds", "useconds", "scalar", description="Fraction of the second.", facts=("Unit: us.", "Uncertain: The unit; it follows from the name."), scalar="u32", units=("us",)),
        ),
    ),
    "NorthVector": FieldInfo(
        "sensor.north_vector", type=sensor.NorthVector,
        title="Complementary filter stabilized north vector",
        description="Estimate of the geomagnetic field by the complementary filter, free of short disturbances.",
        facts=("Supported by 3DM-GX5-15.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45.", "Without magnetic disturbance it equals the measured magnetic field, as long as that is in the sensor frame, too, which a sensor-to-vehicle transformation changes.", "A lasting disturbance is not compensated."),
        sources=("3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10)",),
        devices=("3dm-gx5-15",),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("stabilized_mag", "stabilized_mag", "array", description="Geomagnetic field.", facts=("Elements: x, y, z.", "Unit: gauss.", "Frame: sensor."), scalar="float", elements=("x", "y", "z"), units=("gauss",), frame="sensor"),
        ),
    ),
    "UpVector": FieldInfo(
        "sensor.up_vector", type=sensor.UpVector,
        title="Complementary filter stabilized up vector",
        description="Estimate of the vertical (up) by the complementary filter, free of linear acceleration.",
        facts=("Supported by 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45.", "At rest it equals the measured acceleration, as long as that is in the sensor frame, too, which a sensor-to-vehicle transformation changes."),
        sources=("3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11)",),
        devices=("3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("stabilized_accel", "stabilized_accel", "array", description="The part of the measured acceleration that gravity causes.", facts=("Elements: x, y, z.", "Unit: g.", "Frame: sensor."), scalar="float", elements=("x", "y", "z"), units=("g",), frame="sensor"),
        ),
    ),
    "GpsTimestamp": FieldInfo(
        "sensor.gps_timestamp", type=sensor.GpsTimestamp,
        title="GPS timestamp",
        description="GPS time of the sensor data.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45.", "Without a PPS the time runs on the internal clock and jumps when the PPS returns.", "The fraction of the time of week is the time since the last pulse.", "Without external synchronization it is the internal system time.", "Where the device has it, use `shared.GpsTimestamp` instead; this field may be deprecated."),
        sources=("3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)", "3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("tow", "tow", "scalar", description="GPS time of week.", facts=("Unit: s.", "Valid if `types.SensorGpsTimestampFlags.TOW_VALID` of `valid_flags` is set.", "On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `valid_flags` is set."), scalar="double", units=("s",), valid=("valid_flags.tow_valid",), flags=(Flag("valid_flags.tow_valid", "valid_flags", 0x8),), variants=(Variant("device", ("3dm-gx5-15", "3dm-gx5-35"), "On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `valid_flags` is set.", {"valid": ("valid_flags.time_initialized",)}),), flags_on={"3dm-gx5-15": (Flag("valid_flags.time_initialized", "valid_flags", 0x4),), "3dm-gx5-35": (Flag("valid_flags.time_initialized", "valid_flags", 0x4),)}),
            Parameter("week_number", "week_number", "scalar", description="GPS week number.", facts=("Unit: week.", "Valid if `types.SensorGpsTimestampFlags.WEEK_NUMBER_VALID` of `valid_flags` is set.", "On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `valid_flags` is set."), scalar="u16", units=("week",), valid=("valid_flags.week_number_valid",), flags=(Flag("valid_flags.week_number_valid", "valid_flags", 0x10),), variants=(Variant("device", ("3dm-gx5-15", "3dm-gx5-35"), "On the 3DM-GX5-15 and 3DM-GX5-35: valid if `types.Gx5SensorGpsTimestampFlags.TIME_INITIALIZED` of `valid_flags` is set.", {"valid": ("valid_flags.time_initialized",)}),), flags_on={"3dm-gx5-15": (Flag("valid_flags.time_initialized", "valid_flags", 0x4),), "3dm-gx5-35": (Flag("valid_flags.time_initialized", "valid_flags", 0x4),)}),
            Parameter("valid_flags", "valid_flags", "scalar", description="State of the time.", facts=("On the 3DM-GX5-15 and 3DM-GX5-35: values of `types.Gx5SensorGpsTimestampFlags`.",), scalar="u16", type=types.SensorGpsTimestampFlags, variants=(Variant("device", ("3dm-gx5-15", "3dm-gx5-35"), "On the 3DM-GX5-15 and 3DM-GX5-35: values of `types.Gx5SensorGpsTimestampFlags`.", {"type": types.Gx5SensorGpsTimestampFlags}),)),
        ),
    ),
    "TemperatureStatistics": FieldInfo(
        "sensor.temperature_statistics", type=sensor.TemperatureStatistics,
        title="Temperature statistics",
        description="Temperatures since the last power-on or reset.",
        facts=("Also called `temperature_abs`.", "Supported by 3DM-CV7-GNSS/INS.", "The values come from the inertial sensors, alone or together with sensors on the board."),
        sources=("3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14)",),
        also=("temperature_abs",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("min_temperature", "min_temperature", "scalar", description="Lowest temperature.", facts=("Unit: degC.",), scalar="float", units=("degC",)),
            Parameter("max_temperature", "max_temperature", "scalar", description="Highest temperature.", facts=("Unit: degC.",), scalar="float", units=("degC",)),
            Parameter("mean_temperature", "mean_temperature", "scalar", description="Mean temperature.", facts=("Unit: degC.",), scalar="float", units=("degC",)),
        ),
    ),
    "RawPressure": FieldInfo(
        "sensor.raw_pressure", type=sensor.RawPressure,
        title="Raw pressure",
        description="Raw ambient pressure in counts of the sensor, temperature compensated.",
        facts=("Not listed in any device profile.", "Known only from the MicroStrain MIP SDK."),
        sources=("mip-sdk-4: Raw Pressure (0x80,0x16)",),
        parameters=(
            Parameter("raw_pressure", "raw_pressure", "scalar", description="Pressure in counts.", facts=("Unit: 1.",), scalar="float", units=("1",)),
        ),
    ),
    "ScaledPressure": FieldInfo(
        "sensor.scaled_pressure", type=sensor.ScaledPressure,
        title="Scaled pressure",
        description="Measured ambient pressure, temperature compensated.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45."),
        sources=("3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)", "3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("scaled_pressure", "scaled_pressure", "scalar", description="Ambient pressure.", facts=("Unit: mbar.",), scalar="float", units=("mbar",)),
        ),
    ),
    "OverrangeStatus": FieldInfo(
        "sensor.overrange_status", type=sensor.OverrangeStatus,
        title="Overrange status",
        description="Which sensor axes are near or outside their range.",
        facts=("Supported by 3DM-CV7-GNSS/INS.",),
        sources=("3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("status", "status", "scalar", description="One bit for each axis.", scalar="u16", type=sensor.OverrangeFlags),
        ),
    ),
    "Odometer": FieldInfo(
        "sensor.odometer", type=sensor.Odometer,
        title="Odometer data",
        description="Speed measured by the wheel encoder.",
        facts=("Also called `odometer_data`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)",),
        also=("odometer_data",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("speed", "speed", "scalar", description="Average speed over the interval; negative values come from quadrature encoders only.", facts=("Unit: m/s.", "Valid if `sensor.OdometerFlags.ODOMETER` of `valid_flags` is set."), scalar="float", units=("m/s",), valid=("valid_flags.odometer",), flags=(Flag("valid_flags.odometer", "valid_flags", 0x1),)),
            Parameter("uncertainty", "uncertainty", "scalar", description="Uncertainty of the speed.", facts=("Unit: m/s.", "Valid if `sensor.OdometerFlags.ODOMETER` of `valid_flags` is set."), scalar="float", units=("m/s",), valid=("valid_flags.odometer",), flags=(Flag("valid_flags.odometer", "valid_flags", 0x1),)),
            Parameter("valid_flags", "valid_flags", "scalar", description="Whether the values are valid.", scalar="u16", type=sensor.OdometerFlags),
        ),
    ),
}
