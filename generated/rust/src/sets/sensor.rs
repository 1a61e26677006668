//! Sensor data (0x80): Inertial, magnetic and pressure measurements, and the attitude of the
//! complementary filter.
//!
//! Source: 3dm-gx5-15: 5.1 IMU Data; 3dm-cv7-gnss-ins: Sensor (0x80).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x80);

bitfield! {
    /// Sensor axes that were near or outside their range.
    OverrangeFlags: u16 {
        /// The accelerometer x axis is near or outside its range. Bit 0. Affects [`ScaledAccel`].
        ACCEL_X: bool = 0,
            accel_x, set_accel_x, with_accel_x;
        /// The accelerometer y axis is near or outside its range. Bit 1. Affects [`ScaledAccel`].
        ACCEL_Y: bool = 1,
            accel_y, set_accel_y, with_accel_y;
        /// The accelerometer z axis is near or outside its range. Bit 2. Affects [`ScaledAccel`].
        ACCEL_Z: bool = 2,
            accel_z, set_accel_z, with_accel_z;
        /// The gyroscope x axis is near or outside its range. Bit 4. Affects [`ScaledGyro`].
        GYRO_X: bool = 4,
            gyro_x, set_gyro_x, with_gyro_x;
        /// The gyroscope y axis is near or outside its range. Bit 5. Affects [`ScaledGyro`].
        GYRO_Y: bool = 5,
            gyro_y, set_gyro_y, with_gyro_y;
        /// The gyroscope z axis is near or outside its range. Bit 6. Affects [`ScaledGyro`].
        GYRO_Z: bool = 6,
            gyro_z, set_gyro_z, with_gyro_z;
        /// The magnetometer x axis is near or outside its range. Bit 8. Affects [`ScaledMag`].
        /// Requires a magnetometer.
        MAG_X: bool = 8,
            mag_x, set_mag_x, with_mag_x;
        /// The magnetometer y axis is near or outside its range. Bit 9. Affects [`ScaledMag`].
        /// Requires a magnetometer.
        MAG_Y: bool = 9,
            mag_y, set_mag_y, with_mag_y;
        /// The magnetometer z axis is near or outside its range. Bit 10. Affects [`ScaledMag`].
        /// Requires a magnetometer.
        MAG_Z: bool = 10,
            mag_z, set_mag_z, with_mag_z;
        /// The pressure sensor is near or outside its range. Bit 12. Affects [`ScaledPressure`].
        /// Requires a pressure sensor.
        PRESSURE: bool = 12,
            pressure, set_pressure, with_pressure;
    }
}

bitfield! {
    /// Validity of the odometer values.
    OdometerFlags: u16 {
        /// Set if an odometer is configured; its values are then valid. Bit 0.
        ODOMETER: bool = 0,
            odometer, set_odometer, with_odometer;
    }
}

record! {
    /// Raw accel (0x80,0x01).
    ///
    /// Raw acceleration in sensor counts, temperature compensated.
    ///
    /// Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP
    /// SDK.
    ///
    /// Source: mip-sdk-4: Raw accel (0x80,0x01); mip-sdk-2014: Raw accel (0x80,0x01).
    #[derive(Copy, Default)]
    pub struct RawAccel {
        /// Acceleration in counts.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: sensor.
        pub raw_accel: types::Vector3f,
    }
}

view! {
    RawAccel
    raw_accel: types::Vector3f, at 0;
}

constructors! {
    RawAccel

    /// Creates it from its values.
    fn new(raw_accel: impl Into<types::Vector3f>);
}

field! {
    RawAccel: 0x01, "sensor.raw_accel";
    in [0x80];
}

record! {
    /// Raw gyro (0x80,0x02).
    ///
    /// Raw angular rate in sensor counts, temperature compensated.
    ///
    /// Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP
    /// SDK.
    ///
    /// Source: mip-sdk-4: Raw gyro (0x80,0x02); mip-sdk-2014: Raw gyro (0x80,0x02).
    #[derive(Copy, Default)]
    pub struct RawGyro {
        /// Angular rate in counts.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: sensor.
        pub raw_gyro: types::Vector3f,
    }
}

view! {
    RawGyro
    raw_gyro: types::Vector3f, at 0;
}

constructors! {
    RawGyro

    /// Creates it from its values.
    fn new(raw_gyro: impl Into<types::Vector3f>);
}

field! {
    RawGyro: 0x02, "sensor.raw_gyro";
    in [0x80];
}

record! {
    /// Raw mag (0x80,0x03).
    ///
    /// Raw magnetic field in sensor counts, temperature compensated.
    ///
    /// Not listed in any device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP
    /// SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Raw mag (0x80,0x03); mip-sdk-2014: Raw mag (0x80,0x03).
    #[derive(Copy, Default)]
    pub struct RawMag {
        /// Magnetic field in counts.
        ///
        /// Elements: x, y, z. Unit: 1. Frame: vehicle. Uncertain: The frame is doubtful: the SDK
        /// has the vehicle frame here, but the sensor frame for raw acceleration and raw angular
        /// rate.
        pub raw_mag: types::Vector3f,
    }
}

view! {
    RawMag
    raw_mag: types::Vector3f, at 0;
}

constructors! {
    RawMag

    /// Creates it from its values.
    fn new(raw_mag: impl Into<types::Vector3f>);
}

field! {
    RawMag: 0x03, "sensor.raw_mag";
    in [0x80];
}

record! {
    /// Scaled accel (0x80,0x04).
    ///
    /// Specific force, temperature compensated: about -1 g on z when level and at rest.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-45](crate::devices::CX5_45),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 24 more.
    ///
    /// - At rest, it is the opposite of the gravity vector.
    ///
    /// Source: 3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04); 3dm-cv7-gnss-ins: Scaled
    /// Accel (0x80,0x04).
    #[derive(Copy, Default)]
    pub struct ScaledAccel {
        /// Specific force: acceleration minus gravity.
        ///
        /// Elements: x, y, z. Unit: g. Frame: vehicle. At rest and level: x 0, y 0, z -1.
        pub scaled_accel: types::Vector3f,
    }
}

view! {
    ScaledAccel
    scaled_accel: types::Vector3f, at 0;
}

constructors! {
    ScaledAccel

    /// Creates it from its values.
    fn new(scaled_accel: impl Into<types::Vector3f>);
}

field! {
    ScaledAccel: 0x04, "sensor.scaled_accel";
    in [0x80];
}

record! {
    /// Scaled gyro (0x80,0x05).
    ///
    /// Measured angular rate, temperature compensated.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-45](crate::devices::CX5_45),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 24 more.
    ///
    /// Source: 3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05); 3dm-cv7-gnss-ins: Scaled Gyro
    /// (0x80,0x05).
    #[derive(Copy, Default)]
    pub struct ScaledGyro {
        /// Angular rate about each axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Frame: vehicle. At rest and level: x 0, y 0, z 0.
        /// Positive: right side down, nose up, clockwise seen from above.
        pub scaled_gyro: types::Vector3f,
    }
}

view! {
    ScaledGyro
    scaled_gyro: types::Vector3f, at 0;
}

constructors! {
    ScaledGyro

    /// Creates it from its values.
    fn new(scaled_gyro: impl Into<types::Vector3f>);
}

field! {
    ScaledGyro: 0x05, "sensor.scaled_gyro";
    in [0x80];
}

record! {
    /// Scaled mag (0x80,0x06).
    ///
    /// Measured magnetic field, temperature compensated.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-45](crate::devices::CX5_45),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-35](crate::devices::GX5_35) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 16 more. Requires a magnetometer.
    ///
    /// Source: 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06).
    #[derive(Copy, Default)]
    pub struct ScaledMag {
        /// Magnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: vehicle.
        pub scaled_mag: types::Vector3f,
    }
}

view! {
    ScaledMag
    scaled_mag: types::Vector3f, at 0;
}

constructors! {
    ScaledMag

    /// Creates it from its values.
    fn new(scaled_mag: impl Into<types::Vector3f>);
}

field! {
    ScaledMag: 0x06, "sensor.scaled_mag";
    in [0x80];
}

record! {
    /// Delta theta (0x80,0x07).
    ///
    /// Time integral of the angular rate over the period set by the message format.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 21 more.
    ///
    /// Source: 3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07); 3dm-cv7-gnss-ins: Delta Theta
    /// (0x80,0x07).
    #[derive(Copy, Default)]
    pub struct DeltaTheta {
        /// Integral of the angular rate.
        ///
        /// Elements: x, y, z. Unit: rad. Frame: vehicle. At rest and level: x 0, y 0, z 0.
        /// Positive: right side down, nose up, clockwise seen from above.
        pub delta_theta: types::Vector3f,
    }
}

view! {
    DeltaTheta
    delta_theta: types::Vector3f, at 0;
}

constructors! {
    DeltaTheta

    /// Creates it from its values.
    fn new(delta_theta: impl Into<types::Vector3f>);
}

field! {
    DeltaTheta: 0x07, "sensor.delta_theta";
    in [0x80];
}

record! {
    /// Delta velocity (0x80,0x08).
    ///
    /// Time integral of the specific force over the period set by the message format.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-15](crate::devices::GX5_15); likely or
    /// assumed on 22 more.
    ///
    /// - Multiply by 9.80665 m/s^2 for a change of velocity in metres per second.
    /// - Divided by the period, z is -1 g on a device that is level and at rest.
    ///
    /// Source: 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08); 3dm-cv7-gnss-ins: Delta
    /// Velocity (0x80,0x08).
    #[derive(Copy, Default)]
    pub struct DeltaVelocity {
        /// Integral of the specific force: acceleration minus gravity.
        ///
        /// Elements: x, y, z. Unit: g\*s. Frame: vehicle. At rest and level: x 0, y 0.
        pub delta_velocity: types::Vector3f,
    }
}

view! {
    DeltaVelocity
    delta_velocity: types::Vector3f, at 0;
}

constructors! {
    DeltaVelocity

    /// Creates it from its values.
    fn new(delta_velocity: impl Into<types::Vector3f>);
}

field! {
    DeltaVelocity: 0x08, "sensor.delta_velocity";
    in [0x80];
}

record! {
    /// Complementary filter orientation matrix (0x80,0x09).
    ///
    /// Attitude from the complementary filter as a direction cosine matrix, relative to the NED
    /// frame.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 21 more.
    ///
    /// - `v_vehicle = m * v_ned`; the 3DM-GX5-15 uses the sensor frame in place of the vehicle
    ///   frame.
    ///
    /// Source: 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09); 3dm-cv7-gnss-ins:
    /// Complementary Filter Orientation Matrix (0x80,0x09).
    #[derive(Copy, Default)]
    pub struct CompOrientationMatrix {
        /// Rotates vectors of the NED frame into the vehicle frame; row-major.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: ned. At rest and
        /// level: m13 0, m23 0, m31 0, m32 0, m33 1. On the [3DM-GX5-15](crate::devices::GX5_15):
        /// Rotates vectors of the NED frame into the sensor frame; row-major.
        pub m: types::Matrix3f,
    }
}

view! {
    CompOrientationMatrix
    m: types::Matrix3f, at 0;
}

constructors! {
    CompOrientationMatrix

    /// Creates it from its values.
    fn new(m: impl Into<types::Matrix3f>);
}

field! {
    CompOrientationMatrix: 0x09, "sensor.comp_orientation_matrix";
    in [0x80];
}

record! {
    /// Complementary filter quaternion (0x80,0x0A).
    ///
    /// Attitude from the complementary filter as a quaternion, relative to the NED frame.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7)
    /// and [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 18 more.
    ///
    /// - The 3DM-GX5-15 uses the sensor frame in place of the vehicle frame.
    /// - `v_ned = q * v_vehicle * q^-1`
    ///
    /// Source: 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A); 3dm-cv7-gnss-ins: Complementary Filter
    /// Quaternion (0x80,0x0A).
    #[derive(Copy, Default)]
    pub struct CompQuaternion {
        /// Rotates vectors of the vehicle frame into the NED frame; Hamilton quaternion, w first.
        ///
        /// Elements: w, x, y, z. Unit: 1. Frame: ned. At rest and level: x 0, y 0. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): Rotates vectors of the sensor frame into the NED
        /// frame; Hamilton quaternion, w first.
        pub q: types::Quatf,
    }
}

view! {
    CompQuaternion
    q: types::Quatf, at 0;
}

constructors! {
    CompQuaternion

    /// Creates it from its values.
    fn new(q: impl Into<types::Quatf>);
}

field! {
    CompQuaternion: 0x0A, "sensor.comp_quaternion";
    in [0x80];
}

record! {
    /// Complementary filter orientation update matrix (0x80,0x0B).
    ///
    /// Change in the complementary filter's attitude, as a matrix.
    ///
    /// Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any
    /// device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: No
    /// source states the interval of the change and the frames; the SDKs state only the name and
    /// the layout.
    ///
    /// Source: mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B); mip-sdk-2014: Orientation
    /// Update Matrix (0x80,0x0B).
    #[derive(Copy, Default)]
    #[deprecated(note = "the SDK marks it as deprecated and names no replacement")]
    pub struct CompOrientationUpdateMatrix {
        /// Matrix in row-major order.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1.
        pub m: types::Matrix3f,
    }
}

view! {
    CompOrientationUpdateMatrix
    m: types::Matrix3f, at 0;
}

constructors! {
    CompOrientationUpdateMatrix

    /// Creates it from its values.
    fn new(m: impl Into<types::Matrix3f>);
}

field! {
    CompOrientationUpdateMatrix: 0x0B, "sensor.comp_orientation_update_matrix";
    in [0x80];
}

record! {
    /// Complementary filter Euler angles (0x80,0x0C).
    ///
    /// Attitude from the complementary filter as Euler angles, relative to the NED frame.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-GX5-15](crate::devices::GX5_15);
    /// likely or assumed on 19 more. Uncertain: The ranges of the angles are inferred; no source
    /// states them.
    ///
    /// Source: 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C); 3dm-cv7-gnss-ins: Complementary
    /// Filter Euler Angles (0x80,0x0C).
    #[derive(Copy, Default)]
    pub struct CompEulerAngles {
        /// Roll angle, applied after yaw and pitch (order 3-2-1).
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. At rest and level: 0. Positive: right side
        /// down.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub roll: f32,
        /// Pitch angle.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. At rest and
        /// level: 0. Positive: nose up.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch: f32,
        /// Yaw angle.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub yaw: f32,
    }
}

view! {
    CompEulerAngles
    roll: f32, at 0;
    pitch: f32, at 4;
    yaw: f32, at 8;
}

constructors! {
    CompEulerAngles

    /// Creates it from its values.
    fn new(
        roll: f32,
        pitch: f32,
        yaw: f32,
    );
}

field! {
    CompEulerAngles: 0x0C, "sensor.comp_euler_angles";
    in [0x80];
}

record! {
    /// Orientation raw temperatures (0x80,0x0D).
    ///
    /// Raw readings of four temperature sensors.
    ///
    /// Deprecated: the SDK marks it as deprecated and names no replacement. Also called
    /// `orientation_raw_temp`. Not listed in any device profile. Known only from the MIP SDK of
    /// 2014 and MicroStrain MIP SDK.
    ///
    /// - The first sensor belongs to the magnetometer, the second to gyroscope 3 and accelerometer
    ///   3, the third to gyroscope 2 and accelerometers 1 and 2, the fourth to gyroscope 1.
    ///
    /// Source: mip-sdk-4: Orientation Raw Temp (0x80,0x0D); mip-sdk-2014: Raw Temperature
    /// (0x80,0x0D).
    #[derive(Copy, Default, Eq, Hash)]
    #[deprecated(note = "the SDK marks it as deprecated and names no replacement")]
    pub struct OrientationRawTemperature {
        /// Temperatures in counts.
        ///
        /// Unit: 1. Uncertain: No source states the scale, or the axes of the numbers 1 to 3.
        pub raw_temperature: [u16; 4],
    }
}

view! {
    OrientationRawTemperature
    raw_temperature: [u16; 4], at 0;
}

constructors! {
    OrientationRawTemperature

    /// Creates it from its values.
    fn new(raw_temperature: [u16; 4]);
}

field! {
    OrientationRawTemperature: 0x0D, "sensor.orientation_raw_temperature";
    in [0x80];
}

record! {
    /// Internal timestamp (0x80,0x0E).
    ///
    /// Free-running counter of the device.
    ///
    /// Deprecated: the SDK marks it as deprecated and names no replacement. Not listed in any
    /// device profile. Known only from the MIP SDK of 2014 and MicroStrain MIP SDK. Uncertain: No
    /// source lists the devices that send it; the SDK of 2014 is for devices of the 3-series and
    /// 4-series.
    ///
    /// Source: mip-sdk-4: Internal timestamp (0x80,0x0E); mip-sdk-2014: Internal timestamp
    /// (0x80,0x0E).
    #[derive(Copy, Default, Eq, Hash)]
    #[deprecated(note = "the SDK marks it as deprecated and names no replacement")]
    pub struct InternalTimestamp {
        /// Counter: 62 500 counts per second, 16 us each.
        ///
        /// Unit: 1.
        pub counts: u32,
    }
}

view! {
    InternalTimestamp
    counts: u32, at 0;
}

constructors! {
    InternalTimestamp

    /// Creates it from its values.
    fn new(counts: u32);
}

field! {
    InternalTimestamp: 0x0E, "sensor.internal_timestamp";
    in [0x80];
}

record! {
    /// PPS timestamp (0x80,0x0F).
    ///
    /// Time counted by the pulse per second.
    ///
    /// Deprecated: the SDK marks it as deprecated and names no replacement. The size of its data
    /// distinguishes it from [`PpsTimestampWithFlags`]. Not listed in any device profile. Known
    /// only from the MicroStrain MIP SDK. Uncertain: Possibly no device sends it;
    /// [`PpsTimestampWithFlags`] has more sources. Uncertain: No source states the epoch.
    ///
    /// - The sources contradict each other. Only the SDK has this layout.
    ///
    /// Source: mip-sdk-4: PPS timestamp (0x80,0x0F).
    #[derive(Copy, Default, Eq, Hash)]
    #[deprecated(note = "the SDK marks it as deprecated and names no replacement")]
    pub struct PpsTimestamp {
        /// Whole seconds.
        ///
        /// Unit: s. Uncertain: The unit is inferred from the name.
        pub seconds: u32,
        /// Fraction of the second.
        ///
        /// Unit: us. Uncertain: The unit is inferred from the name.
        pub useconds: u32,
    }
}

view! {
    PpsTimestamp
    seconds: u32, at 0;
    useconds: u32, at 4;
}

constructors! {
    PpsTimestamp

    /// Creates it from its values.
    fn new(seconds: u32, useconds: u32);
}

field! {
    PpsTimestamp: 0x0F, "sensor.pps_timestamp";
    in [0x80];
    sizes 0..=8;
}

record! {
    /// PPS timestamp with flags (0x80,0x0F).
    ///
    /// Time counted by the pulse per second, with its state and nanoseconds.
    ///
    /// Deprecated: the SDK marks the descriptor as deprecated and names no replacement. The size of
    /// its data distinguishes it from [`PpsTimestamp`]. Not listed in any device profile. Known
    /// only from the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: No source
    /// lists the devices that send it; the SDK of 2014 dates from the time of the 3DM-GX3.
    /// Uncertain: No source states the epoch.
    ///
    /// - The sources disagree on the layout; this one is from MSCL and the SDK of 2014.
    ///
    /// Source: mscl: 1PPS Timestamp (0x80,0x0F); mip-sdk-2014: 1PPS Timestamp (0x80,0x0F).
    #[derive(Copy, Default, Eq, Hash)]
    #[deprecated(note = "the SDK marks the descriptor as deprecated and names no replacement")]
    pub struct PpsTimestampWithFlags {
        /// State of the time.
        ///
        /// Uncertain: No source states the meaning of the bits.
        pub flags: u8,
        /// Whole seconds.
        ///
        /// Unit: s.
        pub seconds: u32,
        /// Fraction of the second.
        ///
        /// Unit: ns.
        pub nanoseconds: u32,
    }
}

view! {
    PpsTimestampWithFlags
    flags: u8, at 0;
    seconds: u32, at 1;
    nanoseconds: u32, at 5;
}

constructors! {
    PpsTimestampWithFlags

    /// Creates it from its values.
    fn new(
        flags: u8,
        seconds: u32,
        nanoseconds: u32,
    );
}

field! {
    PpsTimestampWithFlags: 0x0F, "sensor.pps_timestamp_with_flags";
    in [0x80];
    sizes 9..=usize::MAX;
}

record! {
    /// Complementary filter stabilized north vector (0x80,0x10).
    ///
    /// Estimate of the geomagnetic field by the complementary filter, free of short disturbances.
    ///
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 11 more.
    ///
    /// - Without magnetic disturbance it equals the measured magnetic field, unless a
    ///   sensor-to-vehicle transformation moves the latter out of the sensor frame.
    /// - A lasting disturbance is not compensated.
    ///
    /// Source: 3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10).
    #[derive(Copy, Default)]
    pub struct NorthVector {
        /// Geomagnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor. Uncertain: The frame is doubtful: the SDK
        /// has the vehicle frame, but the lists of what the sensor-to-vehicle transformation
        /// changes lack this vector.
        pub stabilized_mag: types::Vector3f,
    }
}

view! {
    NorthVector
    stabilized_mag: types::Vector3f, at 0;
}

constructors! {
    NorthVector

    /// Creates it from its values.
    fn new(stabilized_mag: impl Into<types::Vector3f>);
}

field! {
    NorthVector: 0x10, "sensor.north_vector";
    in [0x80];
}

record! {
    /// Complementary filter stabilized up vector (0x80,0x11).
    ///
    /// Estimate of the vertical (up) by the complementary filter, free of linear acceleration.
    ///
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-35](crate::devices::GX5_35);
    /// likely or assumed on 10 more.
    ///
    /// - At rest it equals the measured acceleration, unless a sensor-to-vehicle transformation
    ///   moves the latter out of the sensor frame.
    ///
    /// Source: 3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11); mip-sdk-4: Complementary
    /// filter stabilized up vector (0x80,0x11).
    #[derive(Copy, Default)]
    pub struct UpVector {
        /// Opposite of the gravity vector, as the accelerometers measure it.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor. At rest and level: x 0, y 0, z -1. Uncertain:
        /// The frame is doubtful: the SDK has the vehicle frame, but the lists of what the
        /// sensor-to-vehicle transformation changes lack this vector.
        pub stabilized_accel: types::Vector3f,
    }
}

view! {
    UpVector
    stabilized_accel: types::Vector3f, at 0;
}

constructors! {
    UpVector

    /// Creates it from its values.
    fn new(stabilized_accel: impl Into<types::Vector3f>);
}

field! {
    UpVector: 0x11, "sensor.up_vector";
    in [0x80];
}

record! {
    /// GPS timestamp (0x80,0x12).
    ///
    /// GPS time of the sensor data.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 12 more.
    ///
    /// - Without a PPS the time runs on the internal clock and jumps when the PPS returns.
    /// - The fraction of the time of week is the time since the last pulse.
    /// - Without external synchronization it is the internal system time.
    /// - Where the device has it, use [`shared::GpsTimestamp`](crate::shared::GpsTimestamp)
    ///   instead; this field may be deprecated.
    ///
    /// Source: 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12); 3dm-cv7-gnss-ins: GPS
    /// Timestamp (0x80,0x12).
    #[derive(Copy, Default)]
    pub struct GpsTimestamp {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow_valid`](types::SensorGpsTimestampFlags::tow_valid) is set. On the
        /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
        /// [3DM-GX3-25](crate::devices::GX3_25), [3DM-GX3-35](crate::devices::GX3_35),
        /// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-15](crate::devices::GX4_15),
        /// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX4-45](crate::devices::GX4_45),
        /// [3DM-GX4-IMU](crate::devices::GX4_IMU), [3DM-GX5-25](crate::devices::GX5_25),
        /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-MV5-AR](crate::devices::MV5_AR),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST)
        /// and [3DM-RQ1-IMU](crate::devices::RQ1_IMU): valid if
        /// [`valid_flags.time_initialized`](types::Gx5SensorGpsTimestampFlags::time_initialized) is
        /// set (inferred: the 3DM-GX5-15 has it). On the [3DM-GX5-15](crate::devices::GX5_15) and
        /// [3DM-GX5-35](crate::devices::GX5_35): valid if
        /// [`valid_flags.time_initialized`](types::Gx5SensorGpsTimestampFlags::time_initialized) is
        /// set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number_valid`](types::SensorGpsTimestampFlags::week_number_valid) is
        /// set. On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
        /// [3DM-GX3-25](crate::devices::GX3_25), [3DM-GX3-35](crate::devices::GX3_35),
        /// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-15](crate::devices::GX4_15),
        /// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX4-45](crate::devices::GX4_45),
        /// [3DM-GX4-IMU](crate::devices::GX4_IMU), [3DM-GX5-25](crate::devices::GX5_25),
        /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-MV5-AR](crate::devices::MV5_AR),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST)
        /// and [3DM-RQ1-IMU](crate::devices::RQ1_IMU): valid if
        /// [`valid_flags.time_initialized`](types::Gx5SensorGpsTimestampFlags::time_initialized) is
        /// set (inferred: the 3DM-GX5-15 has it). On the [3DM-GX5-15](crate::devices::GX5_15) and
        /// [3DM-GX5-35](crate::devices::GX5_35): valid if
        /// [`valid_flags.time_initialized`](types::Gx5SensorGpsTimestampFlags::time_initialized) is
        /// set.
        pub week_number: u16,
        /// State of the time.
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
        /// [3DM-GX3-25](crate::devices::GX3_25), [3DM-GX3-35](crate::devices::GX3_35),
        /// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-15](crate::devices::GX4_15),
        /// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX4-45](crate::devices::GX4_45),
        /// [3DM-GX4-IMU](crate::devices::GX4_IMU), [3DM-GX5-25](crate::devices::GX5_25),
        /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-MV5-AR](crate::devices::MV5_AR),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST)
        /// and [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of
        /// [`types::Gx5SensorGpsTimestampFlags`] (inferred: the 3DM-GX5-15 has it). On the
        /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-35](crate::devices::GX5_35): values of
        /// [`types::Gx5SensorGpsTimestampFlags`].
        pub valid_flags: types::SensorGpsTimestampFlags,
    }
}

view! {
    GpsTimestamp
    tow: f64, at 0;
    week_number: u16, at 8;
    valid_flags: types::SensorGpsTimestampFlags, at 10;
}

constructors! {
    GpsTimestamp

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        valid_flags: types::SensorGpsTimestampFlags,
    );
}

#[rustfmt::skip]
impl GpsTimestamp {
    /// Reads `valid_flags` as [`types::Gx5SensorGpsTimestampFlags`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
    /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-DH3](crate::devices::DH3),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-15](crate::devices::GX3_15),
    /// [3DM-GX3-25](crate::devices::GX3_25), [3DM-GX3-35](crate::devices::GX3_35),
    /// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-15](crate::devices::GX4_15),
    /// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX4-45](crate::devices::GX4_45),
    /// [3DM-GX4-IMU](crate::devices::GX4_IMU), [3DM-GX5-25](crate::devices::GX5_25),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-MV5-AR](crate::devices::MV5_AR),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and
    /// [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of [`types::Gx5SensorGpsTimestampFlags`]
    /// (inferred: the 3DM-GX5-15 has it). On the [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-35](crate::devices::GX5_35): values of [`types::Gx5SensorGpsTimestampFlags`].
    #[inline]
    #[must_use]
    pub fn valid_flags_as_gx5_sensor_gps_timestamp_flags(&self) -> types::Gx5SensorGpsTimestampFlags {
        self.valid_flags.into()
    }
}

#[rustfmt::skip]
impl GpsTimestamp {
    /// Is `tow` valid, as its flags say?
    ///
    /// They depend on the device, and are recognized by the bits that are set.
    #[inline]
    #[must_use]
    pub fn tow_is_valid(&self) -> bool {
        if flags!(self valid_flags) & 0xFFF8 == 0 {
            return flag!(self valid_flags 0x4);
        }
        flag!(self valid_flags 0x8)
    }

    /// Is `tow` valid on this device, as its flags say?
    #[cfg(feature = "devices")]
    #[must_use]
    pub fn tow_is_valid_on(&self, device: &crate::devices::Profile) -> bool {
        match device.id {
            "3dm-cv5-10"
            | "3dm-cv5-15"
            | "3dm-cv5-25"
            | "3dm-cx5-10"
            | "3dm-cx5-15"
            | "3dm-cx5-25"
            | "3dm-cx5-45"
            | "3dm-dh3"
            | "3dm-gq4-45"
            | "3dm-gx3-15"
            | "3dm-gx3-25"
            | "3dm-gx3-35"
            | "3dm-gx3-45"
            | "3dm-gx4-15"
            | "3dm-gx4-25"
            | "3dm-gx4-45"
            | "3dm-gx4-imu"
            | "3dm-gx5-15"
            | "3dm-gx5-25"
            | "3dm-gx5-35"
            | "3dm-gx5-45"
            | "3dm-mv5-ar"
            | "3dm-rq1-45-lt"
            | "3dm-rq1-45-st"
            | "3dm-rq1-imu" => {
                flag!(self valid_flags 0x4)
            }
            _ => {
                flag!(self valid_flags 0x8)
            }
        }
    }

    /// Is `week_number` valid, as its flags say?
    ///
    /// They depend on the device, and are recognized by the bits that are set.
    #[inline]
    #[must_use]
    pub fn week_number_is_valid(&self) -> bool {
        if flags!(self valid_flags) & 0xFFF8 == 0 {
            return flag!(self valid_flags 0x4);
        }
        flag!(self valid_flags 0x10)
    }

    /// Is `week_number` valid on this device, as its flags say?
    #[cfg(feature = "devices")]
    #[must_use]
    pub fn week_number_is_valid_on(&self, device: &crate::devices::Profile) -> bool {
        match device.id {
            "3dm-cv5-10"
            | "3dm-cv5-15"
            | "3dm-cv5-25"
            | "3dm-cx5-10"
            | "3dm-cx5-15"
            | "3dm-cx5-25"
            | "3dm-cx5-45"
            | "3dm-dh3"
            | "3dm-gq4-45"
            | "3dm-gx3-15"
            | "3dm-gx3-25"
            | "3dm-gx3-35"
            | "3dm-gx3-45"
            | "3dm-gx4-15"
            | "3dm-gx4-25"
            | "3dm-gx4-45"
            | "3dm-gx4-imu"
            | "3dm-gx5-15"
            | "3dm-gx5-25"
            | "3dm-gx5-35"
            | "3dm-gx5-45"
            | "3dm-mv5-ar"
            | "3dm-rq1-45-lt"
            | "3dm-rq1-45-st"
            | "3dm-rq1-imu" => {
                flag!(self valid_flags 0x4)
            }
            _ => {
                flag!(self valid_flags 0x10)
            }
        }
    }
}

field! {
    GpsTimestamp: 0x12, "sensor.gps_timestamp";
    in [0x80];
}

record! {
    /// Temperature statistics (0x80,0x14).
    ///
    /// Temperatures since the last power-on or reset.
    ///
    /// Also called `temperature_abs`. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS)
    /// and [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 9 more.
    ///
    /// - The values come from the inertial sensors, alone or together with sensors on the board.
    ///
    /// Source: 3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14).
    #[derive(Copy, Default)]
    pub struct TemperatureStatistics {
        /// Lowest temperature.
        ///
        /// Unit: degC.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub min_temperature: f32,
        /// Highest temperature.
        ///
        /// Unit: degC.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub max_temperature: f32,
        /// Mean of the temperatures inside the device.
        ///
        /// Unit: degC.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub mean_temperature: f32,
    }
}

view! {
    TemperatureStatistics
    min_temperature: f32, at 0;
    max_temperature: f32, at 4;
    mean_temperature: f32, at 8;
}

constructors! {
    TemperatureStatistics

    /// Creates it from its values.
    fn new(
        min_temperature: f32,
        max_temperature: f32,
        mean_temperature: f32,
    );
}

field! {
    TemperatureStatistics: 0x14, "sensor.temperature_statistics";
    in [0x80];
}

record! {
    /// Raw pressure (0x80,0x16).
    ///
    /// Raw ambient pressure in sensor counts, temperature compensated.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Requires a
    /// pressure sensor.
    ///
    /// Source: mip-sdk-4: Raw pressure (0x80,0x16).
    #[derive(Copy, Default)]
    pub struct RawPressure {
        /// Pressure in counts.
        ///
        /// Unit: 1.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub raw_pressure: f32,
    }
}

view! {
    RawPressure
    raw_pressure: f32, at 0;
}

constructors! {
    RawPressure

    /// Creates it from its values.
    fn new(raw_pressure: f32);
}

field! {
    RawPressure: 0x16, "sensor.raw_pressure";
    in [0x80];
}

record! {
    /// Scaled pressure (0x80,0x17).
    ///
    /// Measured ambient pressure, temperature compensated.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-35](crate::devices::GX5_35); likely or
    /// assumed on 17 more. Requires a pressure sensor.
    ///
    /// Source: 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17); 3dm-cv7-gnss-ins: Scaled
    /// Pressure (0x80,0x17).
    #[derive(Copy, Default)]
    pub struct ScaledPressure {
        /// Ambient pressure.
        ///
        /// Unit: mbar. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub scaled_pressure: f32,
    }
}

view! {
    ScaledPressure
    scaled_pressure: f32, at 0;
}

constructors! {
    ScaledPressure

    /// Creates it from its values.
    fn new(scaled_pressure: f32);
}

field! {
    ScaledPressure: 0x17, "sensor.scaled_pressure";
    in [0x80];
}

record! {
    /// Overrange status (0x80,0x18).
    ///
    /// Sensor axes that are near or outside their range.
    ///
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 7 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct OverrangeStatus {
        /// One bit for each axis.
        ///
        /// On the [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CX7-AR](crate::devices::CX7_AR) and
        /// [3DM-GV7-AR](crate::devices::GV7_AR): only [`accel_x`](OverrangeFlags::accel_x),
        /// [`accel_y`](OverrangeFlags::accel_y), [`accel_z`](OverrangeFlags::accel_z),
        /// [`gyro_x`](OverrangeFlags::gyro_x), [`gyro_y`](OverrangeFlags::gyro_y),
        /// [`gyro_z`](OverrangeFlags::gyro_z) and [`pressure`](OverrangeFlags::pressure).
        pub status: OverrangeFlags,
    }
}

view! {
    OverrangeStatus
    status: OverrangeFlags, at 0;
}

constructors! {
    OverrangeStatus

    /// Creates it from its values.
    fn new(status: OverrangeFlags);
}

field! {
    OverrangeStatus: 0x18, "sensor.overrange_status";
    in [0x80];
}

record! {
    /// Odometer data (0x80,0x40).
    ///
    /// Speed measured by the wheel encoder.
    ///
    /// Also called `odometer_data`. Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS)
    /// and [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// Source: 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40).
    #[derive(Copy, Default)]
    pub struct Odometer {
        /// Average speed over the interval; negative values come from quadrature encoders only.
        ///
        /// Unit: m/s. Frame: vehicle. Positive: forward. Valid if
        /// [`valid_flags.odometer`](OdometerFlags::odometer) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub speed: f32,
        /// Uncertainty of the speed.
        ///
        /// Unit: m/s. Range: at least 0. Valid if [`valid_flags.odometer`](OdometerFlags::odometer)
        /// is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
        /// Validity of the measured values.
        pub valid_flags: OdometerFlags,
    }
}

view! {
    Odometer
    speed: f32, at 0;
    uncertainty: f32, at 4;
    valid_flags: OdometerFlags, at 8;
}

constructors! {
    Odometer

    /// Creates it from its values.
    fn new(
        speed: f32,
        uncertainty: f32,
        valid_flags: OdometerFlags,
    );
}

valid! {
    Odometer
    speed_is_valid "speed": valid_flags 0x1;
    uncertainty_is_valid "uncertainty": valid_flags 0x1;
}

field! {
    Odometer: 0x40, "sensor.odometer";
    in [0x80];
}
