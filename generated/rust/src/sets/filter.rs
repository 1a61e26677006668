//! Filter commands (0x0D): Commands that set up, start and aid the navigation filter.
//!
//! Source: 3dm-gx5-15: 4.3 Estimation Filter Commands; 3dm-cv7-gnss-ins: Filter (0x0D).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x0D);

open_enum! {
    /// Motion that the filter expects, depending on the kind of vehicle.
    ///
    /// Uncertain: The SDK lists only the names of the modes, from which the descriptions are
    /// inferred. Uncertain: [`filter_data::Status`](crate::filter_data::Status) reports a mode too,
    /// but is known to have the values 1 to 3 only.
    ///
    /// Source: mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10).
    DynamicsMode: u8 {
        /// Carried by hand.
        PORTABLE = 1, "portable";
        /// Ground vehicle.
        AUTOMOTIVE = 2, "automotive";
        /// Aircraft.
        AIRBORNE = 3, "airborne";
        /// Aircraft under high acceleration.
        AIRBORNE_HIGH_G = 4, "airborne_high_g";
    }
}

bitfield! {
    /// States that the filter estimates.
    ///
    /// Source: 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14); mip-sdk-4: Estimation
    /// Control (0x0D,0x14).
    EstimatedStates: u16 {
        /// Estimate the gyroscope bias (recommended). Bit 0.
        GYRO_BIAS: bool = 0,
            gyro_bias, set_gyro_bias, with_gyro_bias;
        /// Estimate the accelerometer bias. Bit 1.
        ACCEL_BIAS: bool = 1,
            accel_bias, set_accel_bias, with_accel_bias;
        /// Estimate the scale factor of the gyroscope. Bit 2.
        GYRO_SCALE_FACTOR: bool = 2,
            gyro_scale_factor, set_gyro_scale_factor, with_gyro_scale_factor;
        /// Estimate the scale factor of the accelerometer. Bit 3.
        ACCEL_SCALE_FACTOR: bool = 3,
            accel_scale_factor, set_accel_scale_factor, with_accel_scale_factor;
        /// Estimate the offset of the GNSS antenna. Bit 4.
        ANTENNA_OFFSET: bool = 4,
            antenna_offset, set_antenna_offset, with_antenna_offset;
        /// Estimate the hard iron offset of the magnetometer. Bit 5. Requires a magnetometer.
        AUTO_HARD_IRON: bool = 5,
            auto_hard_iron, set_auto_hard_iron, with_auto_hard_iron;
        /// Estimate the soft iron matrix of the magnetometer. Bit 6. Requires a magnetometer.
        AUTO_SOFT_IRON: bool = 6,
            auto_soft_iron, set_auto_soft_iron, with_auto_soft_iron;
    }
}

open_enum! {
    /// Source of the GNSS data that aids the filter.
    GnssAidingSource: u8 {
        /// All internal receivers. Requires a receiver.
        ALL_INTERNAL = 1, "all_internal";
        /// GNSS measurements that your program sends.
        EXTERNAL = 2, "external";
        /// Internal receiver 1 only. Requires a receiver.
        INTERNAL_1 = 3, "internal_1";
        /// Internal receiver 2 only. Requires 2 receivers.
        INTERNAL_2 = 4, "internal_2";
    }
}

open_enum! {
    /// The north that a heading refers to.
    HeadingType: u8 {
        /// True north.
        TRUE_HEADING = 1, "true_heading";
        /// Magnetic north.
        MAGNETIC_HEADING = 2, "magnetic_heading";
    }
}

open_enum! {
    /// Source of the heading updates that aid the filter.
    ///
    /// Source: 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18); 3dm-gx5-45: (0x0D, 0x18);
    /// mip-sdk-4: Heading Source (0x0D,0x18).
    HeadingUpdateSource: u8 {
        /// No heading updates.
        NONE = 0, "none";
        /// The device's own magnetometer. Requires a magnetometer.
        MAG = 1, "mag";
        /// The velocity that the GNSS receiver measures. Requires a receiver.
        GNSS_VELOCITY = 2, "gnss_velocity";
        /// The heading messages that your program sends.
        EXTERNAL = 3, "external";
        /// The course over ground and the magnetometer. Requires a receiver and a magnetometer.
        GNSS_VELOCITY_AND_MAG = 4, "gnss_velocity_and_mag";
        /// GNSS velocity and your program's heading messages. Requires a receiver.
        GNSS_VELOCITY_AND_EXTERNAL = 5, "gnss_velocity_and_external";
        /// Magnetometer and your program's heading messages. Requires a magnetometer.
        MAG_AND_EXTERNAL = 6, "mag_and_external";
        /// GNSS, magnetometer and external heading. Requires a receiver and a magnetometer.
        ALL = 7, "all";
    }
}

bitfield! {
    /// Axes to tare; 0 resets all axes.
    TareAxes: u8 {
        /// The present roll becomes zero. Bit 0.
        ROLL: bool = 0,
            roll, set_roll, with_roll;
        /// The present pitch becomes zero. Bit 1.
        PITCH: bool = 1,
            pitch, set_pitch, with_pitch;
        /// The present yaw becomes zero. Bit 2.
        YAW: bool = 2,
            yaw, set_yaw, with_yaw;
    }
}

bitfield! {
    /// Measurements that the filter uses.
    MeasurementFlags: u16 {
        /// Accelerometer measurements. Bit 0.
        ACCEL: bool = 0,
            accel, set_accel, with_accel;
        /// Magnetometer measurements. Bit 1. Requires a magnetometer.
        MAG: bool = 1,
            mag, set_mag, with_mag;
    }
}

open_enum! {
    /// Source of the declination, the inclination or the magnitude of the magnetic field.
    MagParameterSource: u8 {
        /// No source. Uncertain: No source states what the device does without a declination.
        NONE = 1, "none";
        /// The World Magnetic Model, at the estimated position.
        WMM = 2, "wmm";
        /// The value specified by the command.
        MANUAL = 3, "manual";
    }
}

open_enum! {
    /// Weighting of measurements whose magnitude is not as expected.
    AdaptiveMeasurementSelector: u8 {
        /// No adaptation.
        DISABLED = 0, "disabled";
        /// The limits in the command determine the weights.
        FIXED = 1, "fixed";
        /// The filter determines the weights; the limits are ignored. 3DM-GX5 and later.
        AUTO = 2, "auto";
    }
}

open_enum! {
    /// Source that aids the altitude.
    ///
    /// Source: mip-sdk-4: Altitude Aiding (0x0D,0x47).
    AltitudeAidingSource: u8 {
        /// No aiding.
        NONE = 0, "none";
        /// The pressure sensor. Requires a pressure sensor.
        PRESSURE = 1, "pressure";
    }
}

open_enum! {
    /// Source that aids pitch and roll.
    PitchRollAidingSource: u8 {
        /// No aiding.
        NONE = 0, "none";
        /// The measured gravity vector.
        GRAVITY_VECTOR = 1, "gravity_vector";
    }
}

open_enum! {
    /// A source of aiding measurements.
    AidingSource: u16 {
        /// Position and velocity of the GNSS receivers.
        GNSS_POSITION_VELOCITY = 0, "gnss_position_velocity";
        /// GNSS heading from two antennas. Requires 2 antennas.
        GNSS_HEADING = 1, "gnss_heading";
        /// Built-in pressure altimeter. Requires a pressure sensor.
        ALTIMETER = 2, "altimeter";
        /// Speed sensor or odometer.
        SPEED = 3, "speed";
        /// Built-in magnetometer. Requires a magnetometer.
        MAG = 4, "mag";
        /// Heading that your program sends.
        EXTERNAL_HEADING = 5, "external_heading";
        /// Pressure altitude that your program sends.
        EXTERNAL_ALTIMETER = 6, "external_altimeter";
        /// Magnetic field that your program sends.
        EXTERNAL_MAG = 7, "external_mag";
        /// Velocity in the body (vehicle) frame that your program sends.
        BODY_FRAME_VELOCITY = 8, "body_frame_velocity";
        /// All sources, for save, load and default.
        ALL = 65535, "all";
    }
}

open_enum! {
    /// Assumption of the filter about the acceleration.
    ///
    /// Source: mip-sdk-4: Kinematic Constraint (0x0D,0x51).
    AccelConstraint: u8 {
        /// No assumption.
        NONE = 0, "none";
        /// The filter assumes no acceleration.
        ZERO_ACCEL = 1, "zero_accel";
    }
}

open_enum! {
    /// Assumption of the filter about the velocity.
    ///
    /// Source: mip-sdk-4: Kinematic Constraint (0x0D,0x51).
    VelocityConstraint: u8 {
        /// No assumption.
        NONE = 0, "none";
        /// The filter assumes that the device does not move.
        ZERO_VELOCITY = 1, "zero_velocity";
        /// The filter assumes the motion of a wheeled vehicle.
        WHEELED_VEHICLE = 2, "wheeled_vehicle";
    }
}

open_enum! {
    /// Assumption of the filter about the angular rate.
    ///
    /// Source: mip-sdk-4: Kinematic Constraint (0x0D,0x51).
    AngularConstraint: u8 {
        /// No assumption.
        NONE = 0, "none";
        /// The filter assumes no rotation.
        ZERO_ANGULAR_RATE = 1, "zero_angular_rate";
    }
}

open_enum! {
    /// Initial conditions that your program provides instead of the device.
    InitialConditionSource: u8 {
        /// Position, velocity and attitude are automatic.
        AUTO_POSITION_VELOCITY_ATTITUDE = 0, "auto_position_velocity_attitude";
        /// Position, velocity, pitch and roll are automatic; your program provides the heading.
        AUTO_POSITION_VELOCITY_PITCH_ROLL = 1, "auto_position_velocity_pitch_roll";
        /// Position and velocity are automatic; your program provides the attitude.
        AUTO_POSITION_VELOCITY = 2, "auto_position_velocity";
        /// Your program provides position, velocity and attitude.
        MANUAL = 3, "manual";
    }
}

bitfield! {
    /// Methods that the device may use to determine its initial heading.
    HeadingAlignment: u8 {
        /// From the baseline between two GNSS antennas. Bit 0. Requires 2 antennas.
        DUAL_ANTENNA: bool = 0,
            dual_antenna, set_dual_antenna, with_dual_antenna;
        /// From the GNSS velocity; assumes motion along the positive x axis of the vehicle. Bit 1.
        KINEMATIC: bool = 1,
            kinematic, set_kinematic, with_kinematic;
        /// From the built-in magnetometer. Bit 2. Requires a magnetometer.
        MAG: bool = 2,
            mag, set_mag, with_mag;
        /// From the heading that your program sends. Bit 3.
        EXTERNAL: bool = 3,
            external, set_external, with_external;
    }
}

open_enum! {
    /// Frame of a position.
    ReferenceFrame: u8 {
        /// Earth-centred, Earth-fixed coordinates (WGS84).
        ECEF = 1, "ecef";
        /// Latitude, longitude and height above the ellipsoid (WGS84).
        LLH = 2, "llh";
    }
}

open_enum! {
    /// Strength of the adaptation to inconsistent measurements.
    AdaptiveLevel: u8 {
        /// No adaptation.
        OFF = 0, "off";
        /// Little adaptation.
        CONSERVATIVE = 1, "conservative";
        /// Moderate adaptation.
        MODERATE = 2, "moderate";
        /// Strong adaptation.
        AGGRESSIVE = 3, "aggressive";
    }
}

open_enum! {
    /// Source of the reference point for relative positions.
    RelativePositionSource: u8 {
        /// The base station of the RTK corrections.
        AUTO = 0, "auto";
        /// The coordinates specified by the command.
        MANUAL = 1, "manual";
    }
}

open_enum! {
    /// Point that a lever arm moves.
    ReferencePoint: u8 {
        /// The origin of the vehicle.
        VEHICLE = 1, "vehicle";
    }
}

record! {
    /// Reset navigation filter (0x0D,0x01).
    ///
    /// Returns the filter to its initialization state.
    ///
    /// Affects filter_data (0x82). Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 20 more.
    ///
    /// - If automatic initialization is off, the attitude or heading must be set before the filter
    ///   runs again.
    /// - 3DM-CV7: send it after a large jump of the system time, for example when the PPS is first
    ///   detected.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01); 3dm-gx5-15: 4.3.1 Reset
    /// Filter (0x0D, 0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Reset;
}

constructors! {
    Reset

    /// Creates the command from its parameters.
    fn new();
}

field! {
    Reset: 0x01, "filter.reset";
    in [0x0D];
}

command! {
    Reset -> ();
}

record! {
    /// Set initial attitude (0x0D,0x02).
    ///
    /// Sets the initial attitude of the filter: the orientation of the sensor frame in the NED
    /// frame.
    ///
    /// Affects [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 12 more.
    ///
    /// - Accepted only in the initialization state.
    ///
    /// Source: 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02).
    #[derive(Copy, Default)]
    pub struct SetInitialAttitude {
        /// Roll angle.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: right side down.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub roll: f32,
        /// Pitch angle.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: nose
        /// up.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch: f32,
        /// Heading (yaw) angle.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
    }
}

ranges! {
    SetInitialAttitude
    roll "roll" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
    pitch "pitch" in "-1.5707963267948966 to 1.5707963267948966" From -1.5707963267948966 To 1.5707963267948966;
    heading "heading" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
}

constructors! {
    SetInitialAttitude

    /// Creates the command from its parameters.
    fn new(
        roll: f32,
        pitch: f32,
        heading: f32,
    );
}

field! {
    SetInitialAttitude: 0x02, "filter.set_initial_attitude";
    in [0x0D];
}

command! {
    SetInitialAttitude -> ();
    checks Ranged;
}

record! {
    /// Set initial heading (0x0D,0x03).
    ///
    /// Sets the initial heading of the filter. Pitch and roll come from the accelerometers.
    ///
    /// Affects [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 19 more.
    ///
    /// - 3DM-GX5: accepted only in the initialization state.
    /// - 3DM-CV7: resets the estimated heading; if magnetometer aiding is on, the value of this
    ///   command is ignored.
    ///
    /// Source: 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03); 3dm-gx5-15: 4.3.3 Set
    /// Initial Heading (0x0D, 0x03).
    #[derive(Copy, Default)]
    pub struct SetInitialHeading {
        /// Initial heading.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
    }
}

ranges! {
    SetInitialHeading
    heading "heading" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
}

constructors! {
    SetInitialHeading

    /// Creates the command from its parameters.
    fn new(heading: f32);
}

field! {
    SetInitialHeading: 0x03, "filter.set_initial_heading";
    in [0x0D];
}

command! {
    SetInitialHeading -> ();
    checks Ranged;
}

record! {
    /// Set initial attitude from IMU (0x0D,0x04).
    ///
    /// Initializes the filter's attitude from the complementary filter.
    ///
    /// No device is known for certain to support it. Also called `set_initial_heading_from_mag`.
    /// Affects [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Known only from the MIP SDK
    /// of 2014, MicroStrain Communication Library and MicroStrain MIP SDK. Uncertain: The SDK calls
    /// it set initial heading from mag, without a layout; the SDK of 2014 has this layout in its
    /// example for the 3DM-GX3-45. Uncertain: No source lists the devices that support it.
    ///
    /// Source: mip-sdk-4: Set Initial Heading From Mag (0x0D,0x04); mip-sdk-2014: Set Initial
    /// Attitude From AHRS (0x0D,0x04); mscl: Set Initial Attitude From AHRS (0x0D,0x04).
    #[derive(Copy, Default)]
    pub struct SetInitialAttitudeFromImu {
        /// Angle from true north to magnetic north.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is east of true north.
        /// Uncertain: The sign is the usual one; no source states it.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub declination: f32,
    }
}

ranges! {
    SetInitialAttitudeFromImu
    declination "declination" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
}

constructors! {
    SetInitialAttitudeFromImu

    /// Creates the command from its parameters.
    fn new(declination: f32);
}

field! {
    SetInitialAttitudeFromImu: 0x04, "filter.set_initial_attitude_from_imu";
    in [0x0D];
}

command! {
    SetInitialAttitudeFromImu -> ();
    checks Ranged;
}

record! {
    /// Run navigation filter (0x0D,0x05).
    ///
    /// Starts a filter that is configured to wait for this command.
    ///
    /// Affects [`filter_data::Status`](crate::filter_data::Status). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// - The filter waits in its initialization state if `wait_for_run_command` of
    ///   [`InitializationConfig`] is set.
    ///
    /// Source: 3dm-cv7-gnss-ins: Run Navigation Filter (0x0D,0x05).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Run;
}

constructors! {
    Run

    /// Creates the command from its parameters.
    fn new();
}

field! {
    Run: 0x05, "filter.run";
    in [0x0D];
}

command! {
    Run -> ();
}

record! {
    /// Vehicle dynamics mode (0x0D,0x10).
    ///
    /// Adapts the filter to the expected motion.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`VehicleDynamicsModeResponse`].
    /// Probably affects filter_data (0x82). Confirmed on [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 6 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Vehicle dynamics mode (0x0D,0x10).
    #[derive(Copy, Eq, Hash)]
    pub struct VehicleDynamicsMode {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Kind of vehicle.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX3-45](crate::devices::GX3_45): only [`DynamicsMode::PORTABLE`],
        /// [`DynamicsMode::AUTOMOTIVE`] and [`DynamicsMode::AIRBORNE`].
        pub mode: Option<DynamicsMode>,
    }
    wire 2 {
        [function selects]
        [mode for WRITE]
    }
}

constructors! {
    VehicleDynamicsMode

    /// Apply the new setting.
    fn write(mode: DynamicsMode) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    VehicleDynamicsMode: 0x10, "filter.vehicle_dynamics_mode";
    in [0x0D];
}

command! {
    VehicleDynamicsMode -> Option<VehicleDynamicsModeResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> VehicleDynamicsModeResponse;
    responds VehicleDynamicsModeResponse for READ;
}

change! {
    VehicleDynamicsModeResponse -> WriteCall VehicleDynamicsMode
    [mode]
}

record! {
    /// Sensor to vehicle frame transformation (0x0D,0x11).
    ///
    /// Sets the rotation from the sensor frame to the vehicle frame as Euler angles (5-series).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`SensorToVehicleRotationEulerResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate),
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector) and
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel). Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 12 more. Uncertain: The text of the manual lacks the formula; it is the inverse
    /// of that of
    /// [`mip_3dm::SensorToVehicleTransformEuler`](crate::mip_3dm::SensorToVehicleTransformEuler),
    /// which the 3DM-CV7 manual states.
    ///
    /// - The 3DM-CV7 uses the inverse instead:
    ///   [`mip_3dm::SensorToVehicleTransformEuler`](crate::mip_3dm::SensorToVehicleTransformEuler).
    /// - `v_sensor = Rz(yaw) * Ry(pitch) * Rx(roll) * v_vehicle`
    ///
    /// Source: 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11).
    #[derive(Copy)]
    pub struct SensorToVehicleRotationEuler {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Roll angle of the vehicle relative to the sensor.
        ///
        /// Unit: rad. Frame: sensor. Positive: right side down. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub roll: Option<f32>,
        /// Pitch angle of the vehicle relative to the sensor.
        ///
        /// Unit: rad. Frame: sensor. Positive: nose up. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub pitch: Option<f32>,
        /// Yaw angle of the vehicle relative to the sensor.
        ///
        /// Unit: rad. Frame: sensor. Positive: clockwise seen from above. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub yaw: Option<f32>,
    }
    wire 13 {
        [function selects]
        [roll for WRITE]
        [pitch for WRITE]
        [yaw for WRITE]
    }
}

constructors! {
    SensorToVehicleRotationEuler

    /// Apply the new setting.
    fn write(
        roll: f32,
        pitch: f32,
        yaw: f32,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    SensorToVehicleRotationEuler: 0x11, "filter.sensor_to_vehicle_rotation_euler";
    in [0x0D];
}

command! {
    SensorToVehicleRotationEuler -> Option<SensorToVehicleRotationEulerResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleRotationEulerResponse;
    responds SensorToVehicleRotationEulerResponse for READ;
}

change! {
    SensorToVehicleRotationEulerResponse -> WriteCall SensorToVehicleRotationEuler
    [roll pitch yaw]
}

record! {
    /// Sensor to vehicle offset (0x0D,0x12).
    ///
    /// Sets the origin of the vehicle frame relative to the sensor.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`SensorToVehicleOffsetResponse`].
    /// Affects [`filter_data::LlhPosition`](crate::filter_data::LlhPosition). Confirmed on
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 6 more. Known only from the
    /// MicroStrain MIP SDK. Uncertain: The direction, from the sensor to the origin of the vehicle
    /// frame, is inferred from the name.
    ///
    /// - The shift is constant. It does not follow the attitude, as a lever arm would.
    ///
    /// Source: mip-sdk-4: Sensor to vehicle offset (0x0D,0x12).
    #[derive(Copy)]
    pub struct SensorToVehicleOffset {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Vector from the sensor to the origin of the vehicle frame.
        ///
        /// Elements: x, y, z. Unit: m. Frame: sensor. Range: magnitude at most 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub offset: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [offset for WRITE]
    }
}

constructors! {
    SensorToVehicleOffset

    /// Apply the new setting.
    fn write(offset: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    SensorToVehicleOffset: 0x12, "filter.sensor_to_vehicle_offset";
    in [0x0D];
}

command! {
    SensorToVehicleOffset -> Option<SensorToVehicleOffsetResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleOffsetResponse;
    responds SensorToVehicleOffsetResponse for READ;
}

change! {
    SensorToVehicleOffsetResponse -> WriteCall SensorToVehicleOffset
    [offset]
}

record! {
    /// GNSS antenna offset (0x0D,0x13).
    ///
    /// Sets the position of the GNSS antenna relative to the origin of the sensor.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AntennaOffsetResponse`]. Probably
    /// affects [`filter_data::LlhPosition`](crate::filter_data::LlhPosition),
    /// [`filter_data::EcefPosition`](crate::filter_data::EcefPosition),
    /// [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity) and
    /// [`filter_data::AntennaOffsetCorrection`](crate::filter_data::AntennaOffsetCorrection).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 8 more.
    ///
    /// - 5-series devices expect the sensor frame.
    /// - On the 3DM-CV7 it applies to GNSS data received as NMEA; data from the aiding commands
    ///   uses [`aiding::FrameConfig`](crate::aiding::FrameConfig).
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13).
    #[derive(Copy)]
    pub struct AntennaOffset {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Vector from the sensor origin to the phase centre of the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10. Required for
        /// [write](types::FunctionSelector::WRITE). On the [3DM-CX5-45](crate::devices::CX5_45):
        /// frame sensor (inferred: the manual of the 3DM-GX5-45 states it). On the
        /// [3DM-GX5-45](crate::devices::GX5_45): frame sensor.
        pub offset: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [offset for WRITE]
    }
}

constructors! {
    AntennaOffset

    /// Apply the new setting.
    fn write(offset: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AntennaOffset: 0x13, "filter.antenna_offset";
    in [0x0D];
}

command! {
    AntennaOffset -> Option<AntennaOffsetResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AntennaOffsetResponse;
    responds AntennaOffsetResponse for READ;
}

change! {
    AntennaOffsetResponse -> WriteCall AntennaOffset
    [offset]
}

record! {
    /// Estimation control flags (0x0D,0x14).
    ///
    /// Selects the states that the filter estimates.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`EstimationControlResponse`].
    /// Affects [`filter_data::GyroBias`](crate::filter_data::GyroBias),
    /// [`filter_data::AccelBias`](crate::filter_data::AccelBias),
    /// [`filter_data::GyroScaleFactor`](crate::filter_data::GyroScaleFactor),
    /// [`filter_data::AccelScaleFactor`](crate::filter_data::AccelScaleFactor),
    /// [`filter_data::AntennaOffsetCorrection`](crate::filter_data::AntennaOffsetCorrection),
    /// [`filter_data::MagOffset`](crate::filter_data::MagOffset) and
    /// [`filter_data::MagMatrix`](crate::filter_data::MagMatrix). Probably affects
    /// [`filter_data::GyroBiasUncertainty`](crate::filter_data::GyroBiasUncertainty),
    /// [`filter_data::AccelBiasUncertainty`](crate::filter_data::AccelBiasUncertainty),
    /// [`filter_data::GyroScaleFactorUncertainty`](crate::filter_data::GyroScaleFactorUncertainty),
    /// [`filter_data::AccelScaleFactorUncertainty`](crate::filter_data::AccelScaleFactorUncertainty),
    /// [`filter_data::AntennaOffsetCorrectionUncertainty`](crate::filter_data::AntennaOffsetCorrectionUncertainty),
    /// [`filter_data::MagOffsetUncertainty`](crate::filter_data::MagOffsetUncertainty) and
    /// [`filter_data::MagMatrixUncertainty`](crate::filter_data::MagMatrixUncertainty). Confirmed
    /// on [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 13 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14).
    #[derive(Copy, Eq, Hash)]
    pub struct EstimationControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// States to estimate.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-15](crate::devices::CX5_15),
        /// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-15](crate::devices::GX4_15),
        /// [3DM-GX4-25](crate::devices::GX4_25) and [3DM-GX5-15](crate::devices::GX5_15): only
        /// [`gyro_bias`](EstimatedStates::gyro_bias). On the [3DM-CV5-25](crate::devices::CV5_25),
        /// [3DM-CX5-25](crate::devices::CX5_25) and [3DM-GX5-25](crate::devices::GX5_25): only
        /// [`gyro_bias`](EstimatedStates::gyro_bias),
        /// [`auto_hard_iron`](EstimatedStates::auto_hard_iron) and
        /// [`auto_soft_iron`](EstimatedStates::auto_soft_iron). On the
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX4-45](crate::devices::GX4_45),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): only
        /// [`gyro_bias`](EstimatedStates::gyro_bias), [`accel_bias`](EstimatedStates::accel_bias),
        /// [`gyro_scale_factor`](EstimatedStates::gyro_scale_factor),
        /// [`accel_scale_factor`](EstimatedStates::accel_scale_factor) and
        /// [`antenna_offset`](EstimatedStates::antenna_offset).
        pub flags: Option<EstimatedStates>,
    }
    wire 3 {
        [function selects]
        [flags for WRITE]
    }
}

constructors! {
    EstimationControl

    /// Apply the new setting.
    fn write(flags: EstimatedStates) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    EstimationControl: 0x14, "filter.estimation_control";
    in [0x0D];
}

command! {
    EstimationControl -> Option<EstimationControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> EstimationControlResponse;
    responds EstimationControlResponse for READ;
}

change! {
    EstimationControlResponse -> WriteCall EstimationControl
    [flags]
}

record! {
    /// GNSS aiding source (0x0D,0x15).
    ///
    /// Selects the GNSS receiver that aids the filter.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GnssSourceResponse`]. Probably
    /// affects [`filter_data::LlhPosition`](crate::filter_data::LlhPosition),
    /// [`filter_data::EcefPosition`](crate::filter_data::EcefPosition),
    /// [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity) and
    /// [`filter_data::GnssPositionAidingStatus`](crate::filter_data::GnssPositionAidingStatus).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 9 more.
    ///
    /// - A change while the filter is running may return it to initialization until the new source
    ///   provides data.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15).
    #[derive(Copy, Eq, Hash)]
    pub struct GnssSource {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the GNSS data.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-INS](crate::devices::CX7_INS) and
        /// [3DM-GV7-INS](crate::devices::GV7_INS): only [`GnssAidingSource::EXTERNAL`]. On the
        /// [3DM-CX5-45](crate::devices::CX5_45), [3DM-GQ4-45](crate::devices::GQ4_45),
        /// [3DM-GX3-45](crate::devices::GX3_45), [3DM-GX4-45](crate::devices::GX4_45),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): only [`GnssAidingSource::ALL_INTERNAL`],
        /// [`GnssAidingSource::EXTERNAL`] and [`GnssAidingSource::INTERNAL_1`]. On the
        /// [3DM-GX5-45](crate::devices::GX5_45): only [`GnssAidingSource::ALL_INTERNAL`] and
        /// [`GnssAidingSource::EXTERNAL`].
        pub source: Option<GnssAidingSource>,
    }
    wire 2 {
        [function selects]
        [source for WRITE]
    }
}

constructors! {
    GnssSource

    /// Apply the new setting.
    fn write(source: GnssAidingSource) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    GnssSource: 0x15, "filter.gnss_source";
    in [0x0D];
}

command! {
    GnssSource -> Option<GnssSourceResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GnssSourceResponse;
    responds GnssSourceResponse for READ;
}

change! {
    GnssSourceResponse -> WriteCall GnssSource
    [source]
}

record! {
    /// External GNSS update (0x0D,0x16).
    ///
    /// Sends one position and velocity measurement from your own GNSS receiver to the filter.
    ///
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 5 more. Known only
    /// from the MicroStrain MIP SDK.
    ///
    /// - The device rejects this command unless [`GnssSource`] selects the external source.
    /// - The maximum rate depends on the device.
    ///
    /// Source: mip-sdk-4: External GNSS update (0x0D,0x16).
    #[derive(Default)]
    pub struct ExternalGnssUpdate {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week, counted without rollover.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Geodetic latitude.
        ///
        /// Unit: deg. Frame: llh. Range: -90 to 90. Positive: north.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub latitude: f64,
        /// Geodetic longitude.
        ///
        /// Unit: deg. Frame: llh. Range: -180 to 180. Positive: east.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub longitude: f64,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub height: f64,
        /// Velocity of the antenna.
        ///
        /// Elements: north, east, down. Unit: m/s. Frame: ned.
        pub velocity: types::Ned3f,
        /// Standard deviation of the position.
        ///
        /// Elements: north, east, down. Unit: m. Frame: ned. Range: at least 0.
        pub position_uncertainty: types::Ned3f,
        /// Standard deviation of the velocity.
        ///
        /// Elements: north, east, down. Unit: m/s. Frame: ned. Range: at least 0.
        pub velocity_uncertainty: types::Ned3f,
    }
}

ranges! {
    ExternalGnssUpdate
    tow "tow" in "at least 0, less than 604800" From 0.0 Below 604800.0;
    latitude "latitude" in "-90 to 90" From -90.0 To 90.0;
    longitude "longitude" in "-180 to 180" From -180.0 To 180.0;
    position_uncertainty "position_uncertainty" in "at least 0" From 0.0;
    velocity_uncertainty "velocity_uncertainty" in "at least 0" From 0.0;
}

constructors! {
    ExternalGnssUpdate

    /// Creates the command from its parameters.
    fn new(
        tow: f64,
        week_number: u16,
        latitude: f64,
        longitude: f64,
        height: f64,
        velocity: impl Into<types::Ned3f>,
        position_uncertainty: impl Into<types::Ned3f>,
        velocity_uncertainty: impl Into<types::Ned3f>,
    );
}

field! {
    ExternalGnssUpdate: 0x16, "filter.external_gnss_update";
    in [0x0D];
}

command! {
    ExternalGnssUpdate -> ();
    checks Ranged;
}

record! {
    /// External heading update (0x0D,0x17).
    ///
    /// Sends one measurement of the heading of the sensor frame in the NED frame to the filter.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 15 more.
    ///
    /// - The device rejects this command unless external heading updates are enabled, by
    ///   [`HeadingSource`] on the 3DM-GX5 and by [`AidingMeasurementEnable`] on the 3DM-CV7.
    /// - The 3DM-GX5-15 accepts at most 20 updates per second.
    /// - If the declination source is not valid, -25 models reject true headings and -45 models
    ///   magnetic ones.
    ///
    /// Source: 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17); 3dm-gx5-15: 4.3.7 External
    /// Heading Update (0x0D, 0x17).
    #[derive(Copy, Default)]
    pub struct ExternalHeadingUpdate {
        /// Heading relative to the north selected by `type`.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Standard deviation; the device rejects values out of range.
        ///
        /// Unit: rad. Range: greater than 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading_uncertainty: f32,
        /// North that the heading refers to.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: HeadingType,
    }
    wire 9 {
        [heading]
        [heading_uncertainty]
        [type_ "type"]
    }
}

ranges! {
    ExternalHeadingUpdate
    heading "heading" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
    heading_uncertainty "heading_uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    ExternalHeadingUpdate

    /// Creates the command from its parameters.
    fn new(
        heading: f32,
        heading_uncertainty: f32,
        type_: HeadingType,
    );
}

field! {
    ExternalHeadingUpdate: 0x17, "filter.external_heading_update";
    in [0x0D];
}

command! {
    ExternalHeadingUpdate -> ();
    checks Ranged;
}

record! {
    /// Heading update control (0x0D,0x18).
    ///
    /// Selects the source of the heading that aids the filter.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`HeadingSourceResponse`]. Affects
    /// [`filter_data::HeadingUpdateState`](crate::filter_data::HeadingUpdateState). Probably
    /// affects [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 12 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18).
    #[derive(Copy, Eq, Hash)]
    pub struct HeadingSource {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the heading.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-15](crate::devices::CX5_15) and
        /// [3DM-GX5-15](crate::devices::GX5_15): only [`HeadingUpdateSource::NONE`] and
        /// [`HeadingUpdateSource::EXTERNAL`]. On the [3DM-CV5-25](crate::devices::CV5_25),
        /// [3DM-CX5-25](crate::devices::CX5_25), [3DM-GX4-25](crate::devices::GX4_25) and
        /// [3DM-GX5-25](crate::devices::GX5_25): only [`HeadingUpdateSource::NONE`],
        /// [`HeadingUpdateSource::MAG`] and [`HeadingUpdateSource::EXTERNAL`]. On the
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-45](crate::devices::GX3_45) and
        /// [3DM-GX4-45](crate::devices::GX4_45): only [`HeadingUpdateSource::NONE`],
        /// [`HeadingUpdateSource::MAG`], [`HeadingUpdateSource::GNSS_VELOCITY`] and
        /// [`HeadingUpdateSource::EXTERNAL`]. On the [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): only [`HeadingUpdateSource::NONE`],
        /// [`HeadingUpdateSource::GNSS_VELOCITY`] and [`HeadingUpdateSource::EXTERNAL`].
        pub source: Option<HeadingUpdateSource>,
    }
    wire 2 {
        [function selects]
        [source for WRITE]
    }
}

constructors! {
    HeadingSource

    /// Apply the new setting.
    fn write(source: HeadingUpdateSource) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    HeadingSource: 0x18, "filter.heading_source";
    in [0x0D];
}

command! {
    HeadingSource -> Option<HeadingSourceResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> HeadingSourceResponse;
    responds HeadingSourceResponse for READ;
}

change! {
    HeadingSourceResponse -> WriteCall HeadingSource
    [source]
}

record! {
    /// Automatic initialization (0x0D,0x19).
    ///
    /// Sets whether the filter initializes automatically at power-up.
    ///
    /// Also called `auto_init_control`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`AutoInitializationControlResponse`]. Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 13 more.
    ///
    /// - Automatic initialization needs a valid heading source.
    ///
    /// Source: 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19).
    #[derive(Copy, Eq, Hash)]
    pub struct AutoInitializationControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

ranges! {
    AutoInitializationControl
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    AutoInitializationControl

    /// Apply the new setting.
    fn write(enable: u8) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AutoInitializationControl: 0x19, "filter.auto_initialization_control";
    in [0x0D];
}

command! {
    AutoInitializationControl -> Option<AutoInitializationControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AutoInitializationControlResponse;
    responds AutoInitializationControlResponse for READ;
    checks Ranged;
}

change! {
    AutoInitializationControlResponse -> WriteCall AutoInitializationControl
    [enable]
}

record! {
    /// Accelerometer noise (0x0D,0x1A).
    ///
    /// Sets the standard deviation of the accelerometer noise that the filter assumes (process
    /// noise).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AccelNoiseResponse`]. Probably
    /// affects [`filter_data::LlhPositionUncertainty`](crate::filter_data::LlhPositionUncertainty),
    /// [`filter_data::EcefPositionUncertainty`](crate::filter_data::EcefPositionUncertainty),
    /// [`filter_data::NedVelocityUncertainty`](crate::filter_data::NedVelocityUncertainty),
    /// [`filter_data::EcefVelocityUncertainty`](crate::filter_data::EcefVelocityUncertainty) and
    /// [`filter_data::AccelBiasUncertainty`](crate::filter_data::AccelBiasUncertainty). Confirmed
    /// on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GX5-15](crate::devices::GX5_15)
    /// and [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 23 more.
    ///
    /// - The factory values suit most laboratory conditions.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A); 3dm-gx5-15:
    /// 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A).
    #[derive(Copy)]
    pub struct AccelNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    AccelNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    AccelNoise

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AccelNoise: 0x1A, "filter.accel_noise";
    in [0x0D];
}

command! {
    AccelNoise -> Option<AccelNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AccelNoiseResponse;
    responds AccelNoiseResponse for READ;
    checks Ranged;
}

change! {
    AccelNoiseResponse -> WriteCall AccelNoise
    [noise]
}

record! {
    /// Gyroscope noise (0x0D,0x1B).
    ///
    /// Sets the standard deviation of the gyroscope noise that the filter assumes (process noise).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GyroNoiseResponse`]. Probably
    /// affects [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty),
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty)
    /// and [`filter_data::GyroBiasUncertainty`](crate::filter_data::GyroBiasUncertainty). Confirmed
    /// on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GX5-15](crate::devices::GX5_15)
    /// and [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 23 more.
    ///
    /// - The factory values suit most laboratory conditions.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B); 3dm-gx5-15: 4.3.13
    /// Gyroscope Noise Standard Deviation (0x0D, 0x1B).
    #[derive(Copy)]
    pub struct GyroNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    GyroNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    GyroNoise

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    GyroNoise: 0x1B, "filter.gyro_noise";
    in [0x0D];
}

command! {
    GyroNoise -> Option<GyroNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GyroNoiseResponse;
    responds GyroNoiseResponse for READ;
    checks Ranged;
}

change! {
    GyroNoiseResponse -> WriteCall GyroNoise
    [noise]
}

record! {
    /// Accelerometer bias model (0x0D,0x1C).
    ///
    /// Sets the parameters of the accelerometer bias drift model.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AccelBiasModelResponse`]. Probably
    /// affects [`filter_data::AccelBias`](crate::filter_data::AccelBias) and
    /// [`filter_data::AccelBiasUncertainty`](crate::filter_data::AccelBiasUncertainty). Confirmed
    /// on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 9 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C).
    #[derive(Copy)]
    pub struct AccelBiasModel {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s. Required for [write](types::FunctionSelector::WRITE).
        pub beta: Option<types::Vector3f>,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 25 {
        [function selects]
        [beta for WRITE]
        [noise for WRITE]
    }
}

ranges! {
    AccelBiasModel
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    AccelBiasModel

    /// Apply the new setting.
    fn write(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AccelBiasModel: 0x1C, "filter.accel_bias_model";
    in [0x0D];
}

command! {
    AccelBiasModel -> Option<AccelBiasModelResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AccelBiasModelResponse;
    responds AccelBiasModelResponse for READ;
    checks Ranged;
}

change! {
    AccelBiasModelResponse -> WriteCall AccelBiasModel
    [beta noise]
}

record! {
    /// Gyroscope bias model (0x0D,0x1D).
    ///
    /// Sets the parameters of the gyroscope bias drift model.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GyroBiasModelResponse`]. Probably
    /// affects [`filter_data::GyroBias`](crate::filter_data::GyroBias) and
    /// [`filter_data::GyroBiasUncertainty`](crate::filter_data::GyroBiasUncertainty). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 23 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D); 3dm-gx5-15: 4.3.14
    /// Gyroscope Bias Model Parameters (0x0D, 0x1D).
    #[derive(Copy)]
    pub struct GyroBiasModel {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s. Required for [write](types::FunctionSelector::WRITE).
        pub beta: Option<types::Vector3f>,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 25 {
        [function selects]
        [beta for WRITE]
        [noise for WRITE]
    }
}

ranges! {
    GyroBiasModel
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    GyroBiasModel

    /// Apply the new setting.
    fn write(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    GyroBiasModel: 0x1D, "filter.gyro_bias_model";
    in [0x0D];
}

command! {
    GyroBiasModel -> Option<GyroBiasModelResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GyroBiasModelResponse;
    responds GyroBiasModelResponse for READ;
    checks Ranged;
}

change! {
    GyroBiasModelResponse -> WriteCall GyroBiasModel
    [beta noise]
}

record! {
    /// Automatic zero velocity update (0x0D,0x1E).
    ///
    /// Sets whether the filter assumes that the device is at rest while its GNSS speed is low.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AutoZuptResponse`]. Probably
    /// affects [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity),
    /// [`filter_data::NedVelocityUncertainty`](crate::filter_data::NedVelocityUncertainty) and
    /// [`filter_data::EcefVelocityUncertainty`](crate::filter_data::EcefVelocityUncertainty).
    /// Confirmed on [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 6 more. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// - The update applies while the magnitude of the GNSS velocity vector is at or below the
    ///   threshold.
    ///
    /// Source: mip-sdk-4: Auto Zupt (0x0D,0x1E).
    #[derive(Copy)]
    pub struct AutoZupt {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
        /// Highest speed that is treated as zero.
        ///
        /// Unit: m/s. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub threshold: Option<f32>,
    }
    wire 6 {
        [function selects]
        [enable for WRITE]
        [threshold for WRITE]
    }
}

ranges! {
    AutoZupt
    enable "enable" in "0 to 1" From 0.0 To 1.0;
    threshold "threshold" in "at least 0" From 0.0;
}

constructors! {
    AutoZupt

    /// Apply the new setting.
    fn write(enable: u8, threshold: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AutoZupt: 0x1E, "filter.auto_zupt";
    in [0x0D];
}

command! {
    AutoZupt -> Option<AutoZuptResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AutoZuptResponse;
    responds AutoZuptResponse for READ;
    checks Ranged;
}

change! {
    AutoZuptResponse -> WriteCall AutoZupt
    [enable threshold]
}

record! {
    /// External heading update with time (0x0D,0x1F).
    ///
    /// Sends one measurement of the heading of the sensor frame with its GPS time to the filter.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 15 more.
    ///
    /// - It is better than [`ExternalHeadingUpdate`] if the heading changes quickly; the time must
    ///   be accurate.
    /// - The device rejects this command unless external heading updates are enabled, by
    ///   [`HeadingSource`] on the 3DM-GX5 and by [`AidingMeasurementEnable`] on the 3DM-CV7.
    /// - The 3DM-GX5-15 accepts at most 20 updates per second.
    /// - If the declination source is not valid, -25 models reject true headings and -45 models
    ///   magnetic ones.
    ///
    /// Source: 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F); 3dm-gx5-15: 4.3.8
    /// External Heading Update with Timestamp (0x0D, 0x1F).
    #[derive(Copy, Default)]
    pub struct ExternalHeadingUpdateWithTime {
        /// GPS time of week of the measurement.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week, counted without rollover.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Heading relative to the north selected by `type`.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Standard deviation; the device rejects values out of range.
        ///
        /// Unit: rad. Range: greater than 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading_uncertainty: f32,
        /// North that the heading refers to.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: HeadingType,
    }
    wire 19 {
        [tow]
        [week_number]
        [heading]
        [heading_uncertainty]
        [type_ "type"]
    }
}

ranges! {
    ExternalHeadingUpdateWithTime
    tow "tow" in "at least 0, less than 604800" From 0.0 Below 604800.0;
    heading "heading" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
    heading_uncertainty "heading_uncertainty" in "greater than 0" Above 0.0;
}

constructors! {
    ExternalHeadingUpdateWithTime

    /// Creates the command from its parameters.
    fn new(
        tow: f64,
        week_number: u16,
        heading: f32,
        heading_uncertainty: f32,
        type_: HeadingType,
    );
}

field! {
    ExternalHeadingUpdateWithTime: 0x1F, "filter.external_heading_update_with_time";
    in [0x0D];
}

command! {
    ExternalHeadingUpdateWithTime -> ();
    checks Ranged;
}

record! {
    /// Zero angular rate update (0x0D,0x20).
    ///
    /// Sets whether the filter assumes that the device is not rotating while its angular rate is
    /// low.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AutoAngularZuptResponse`]. Probably
    /// affects [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::GyroBias`](crate::filter_data::GyroBias) and
    /// [`filter_data::GyroBiasUncertainty`](crate::filter_data::GyroBiasUncertainty). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS),
    /// [3DM-CX5-25](crate::devices::CX5_25), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 19 more.
    ///
    /// - The update applies while the magnitude of the angular rate vector is at or below the
    ///   threshold.
    ///
    /// Source: 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20); 3dm-gx5-15: 4.3.15
    /// Zero Angular Rate Update Control (0x0D, 0x20).
    #[derive(Copy)]
    pub struct AutoAngularZupt {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
        /// Highest angular rate that is treated as zero.
        ///
        /// Unit: rad/s. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub threshold: Option<f32>,
    }
    wire 6 {
        [function selects]
        [enable for WRITE]
        [threshold for WRITE]
    }
}

ranges! {
    AutoAngularZupt
    enable "enable" in "0 to 1" From 0.0 To 1.0;
    threshold "threshold" in "at least 0" From 0.0;
}

constructors! {
    AutoAngularZupt

    /// Apply the new setting.
    fn write(enable: u8, threshold: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AutoAngularZupt: 0x20, "filter.auto_angular_zupt";
    in [0x0D];
}

command! {
    AutoAngularZupt -> Option<AutoAngularZuptResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AutoAngularZuptResponse;
    responds AutoAngularZuptResponse for READ;
    checks Ranged;
}

change! {
    AutoAngularZuptResponse -> WriteCall AutoAngularZupt
    [enable threshold]
}

record! {
    /// Tare orientation (0x0D,0x21).
    ///
    /// Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`TareOrientationResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate),
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector) and
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel). Confirmed on
    /// [3DM-CX5-25](crate::devices::CX5_25), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 11 more. On the
    /// [3DM-GX5-15](crate::devices::GX5_15): [write](types::FunctionSelector::WRITE),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT) only. On the
    /// [3DM-GX5-45](crate::devices::GX5_45): [write](types::FunctionSelector::WRITE),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT) only.
    ///
    /// - The device rejects this command while the filter has no valid attitude.
    ///
    /// Source: 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21); mip-sdk-4: Tare orientation
    /// (0x0D,0x21).
    #[derive(Copy, Eq, Hash)]
    pub struct TareOrientation {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Axes to tare; 0 resets all axes.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub axes: Option<TareAxes>,
    }
    wire 2 {
        [function selects]
        [axes for WRITE]
    }
}

constructors! {
    TareOrientation

    /// Apply the new setting.
    fn write(axes: TareAxes) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    TareOrientation: 0x21, "filter.tare_orientation";
    in [0x0D];
}

command! {
    TareOrientation -> Option<TareOrientationResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> TareOrientationResponse;
    responds TareOrientationResponse for READ;
}

change! {
    TareOrientationResponse -> WriteCall TareOrientation
    [axes]
}

record! {
    /// Commanded zero velocity update (0x0D,0x22).
    ///
    /// Informs the filter once that the device is at rest.
    ///
    /// Probably affects [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity),
    /// [`filter_data::NedVelocityUncertainty`](crate::filter_data::NedVelocityUncertainty) and
    /// [`filter_data::EcefVelocityUncertainty`](crate::filter_data::EcefVelocityUncertainty).
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 5 more. Known only
    /// from the MicroStrain MIP SDK.
    ///
    /// - The maximum rate depends on the device.
    ///
    /// Source: mip-sdk-4: Commanded Zupt (0x0D,0x22).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct CommandedZupt;
}

constructors! {
    CommandedZupt

    /// Creates the command from its parameters.
    fn new();
}

field! {
    CommandedZupt: 0x22, "filter.commanded_zupt";
    in [0x0D];
}

command! {
    CommandedZupt -> ();
}

record! {
    /// Commanded zero angular rate update (0x0D,0x23).
    ///
    /// Informs the filter once that the device is not rotating.
    ///
    /// Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::GyroBias`](crate::filter_data::GyroBias) and
    /// [`filter_data::GyroBiasUncertainty`](crate::filter_data::GyroBiasUncertainty). Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 12 more.
    ///
    /// - At most 10 per second.
    ///
    /// Source: 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct CommandedAngularZupt;
}

constructors! {
    CommandedAngularZupt

    /// Creates the command from its parameters.
    fn new();
}

field! {
    CommandedAngularZupt: 0x23, "filter.commanded_angular_zupt";
    in [0x0D];
}

command! {
    CommandedAngularZupt -> ();
}

record! {
    /// Set reference position (0x0D,0x26).
    ///
    /// Sets the position for which the device computes gravity (WGS84) and the magnetic field
    /// (WMM2015).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ReferencePositionResponse`].
    /// Affects [`filter_data::Wgs84GravityMagnitude`](crate::filter_data::Wgs84GravityMagnitude)
    /// and [`filter_data::MagneticModel`](crate::filter_data::MagneticModel). Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 8 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26).
    #[derive(Copy)]
    pub struct ReferencePosition {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
        /// Geodetic latitude.
        ///
        /// Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub latitude: Option<f64>,
        /// Geodetic longitude.
        ///
        /// Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub longitude: Option<f64>,
        /// Altitude of the reference position.
        ///
        /// Unit: m. Required for [write](types::FunctionSelector::WRITE). Uncertain: The reference,
        /// ellipsoid or sea level, is inferred. The manual does not state it; its glossary counts
        /// altitudes from sea level.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub altitude: Option<f64>,
    }
    wire 26 {
        [function selects]
        [enable for WRITE]
        [latitude for WRITE]
        [longitude for WRITE]
        [altitude for WRITE]
    }
}

ranges! {
    ReferencePosition
    enable "enable" in "0 to 1" From 0.0 To 1.0;
    latitude "latitude" in "-90 to 90" From -90.0 To 90.0;
    longitude "longitude" in "-180 to 180" From -180.0 To 180.0;
}

constructors! {
    ReferencePosition

    /// Apply the new setting.
    fn write(
        enable: u8,
        latitude: f64,
        longitude: f64,
        altitude: f64,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    ReferencePosition: 0x26, "filter.reference_position";
    in [0x0D];
}

command! {
    ReferencePosition -> Option<ReferencePositionResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ReferencePositionResponse;
    responds ReferencePositionResponse for READ;
    checks Ranged;
}

change! {
    ReferencePositionResponse -> WriteCall ReferencePosition
    [enable latitude longitude altitude]
}

record! {
    /// Capture automatic magnetometer calibration (0x0D,0x27).
    ///
    /// Moves the result of the automatic magnetometer calibration into the fixed calibration.
    ///
    /// Also called `mag_capture_auto_cal`. Functions: [write](types::FunctionSelector::WRITE) and
    /// [save](types::FunctionSelector::SAVE). Affects
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`filter_data::MagOffset`](crate::filter_data::MagOffset) and
    /// [`filter_data::MagMatrix`](crate::filter_data::MagMatrix). Confirmed on
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 4 more. Known only from the
    /// MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// - A write combines the automatic calibration with
    ///   [`mip_3dm::MagHardIronOffset`](crate::mip_3dm::MagHardIronOffset) and
    ///   [`mip_3dm::MagSoftIronMatrix`](crate::mip_3dm::MagSoftIronMatrix), then resets the
    ///   automatic calibration.
    /// - A save has the same effect as saving both of these settings.
    ///
    /// Source: mip-sdk-4: Mag Capture Auto Cal (0x0D,0x27).
    #[derive(Copy, Eq, Hash)]
    pub struct MagCaptureAutoCalibration {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
    }
    wire 1 {
        [function selects]
    }
}

constructors! {
    MagCaptureAutoCalibration

    /// Apply the new setting.
    fn write() -> WriteCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;
}

field! {
    MagCaptureAutoCalibration: 0x27, "filter.mag_capture_auto_calibration";
    in [0x0D];
}

command! {
    MagCaptureAutoCalibration -> ();
    for WRITE SAVE -> ();
}

record! {
    /// Gravity noise (0x0D,0x28).
    ///
    /// Sets the standard deviation of the gravity noise that the filter assumes (process noise).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GravityNoiseResponse`]. Probably
    /// affects [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty)
    /// and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 16 more.
    ///
    /// - The factory values suit most laboratory conditions.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28); 3dm-gx5-15: 4.3.11
    /// Gravity Noise Standard Deviation (0x0D, 0x28).
    #[derive(Copy)]
    pub struct GravityNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: g. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    GravityNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    GravityNoise

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    GravityNoise: 0x28, "filter.gravity_noise";
    in [0x0D];
}

command! {
    GravityNoise -> Option<GravityNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GravityNoiseResponse;
    responds GravityNoiseResponse for READ;
    checks Ranged;
}

change! {
    GravityNoiseResponse -> WriteCall GravityNoise
    [noise]
}

record! {
    /// Pressure altitude noise (0x0D,0x29).
    ///
    /// Sets the standard deviation of the pressure altitude noise that the filter assumes.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`PressureAltitudeNoiseResponse`].
    /// Probably affects [`filter_data::LlhPosition`](crate::filter_data::LlhPosition) and
    /// [`filter_data::LlhPositionUncertainty`](crate::filter_data::LlhPositionUncertainty).
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 4 more. Known only
    /// from the MicroStrain MIP SDK. Requires a pressure sensor.
    ///
    /// - With a small value, the altitude follows the pressure faster, but weather and draughts
    ///   appear as changes of height.
    ///
    /// Source: mip-sdk-4: Pressure altitude noise (0x0D,0x29).
    #[derive(Copy)]
    pub struct PressureAltitudeNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation of the pressure altitude noise.
        ///
        /// Unit: m. Range: greater than 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub noise: Option<f32>,
    }
    wire 5 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    PressureAltitudeNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    PressureAltitudeNoise

    /// Apply the new setting.
    fn write(noise: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    PressureAltitudeNoise: 0x29, "filter.pressure_altitude_noise";
    in [0x0D];
}

command! {
    PressureAltitudeNoise -> Option<PressureAltitudeNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> PressureAltitudeNoiseResponse;
    responds PressureAltitudeNoiseResponse for READ;
    checks Ranged;
}

change! {
    PressureAltitudeNoiseResponse -> WriteCall PressureAltitudeNoise
    [noise]
}

record! {
    /// Hard iron offset noise (0x0D,0x2B).
    ///
    /// Sets the standard deviation of the noise of the estimated hard iron offset (process noise).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`HardIronOffsetNoiseResponse`].
    /// Probably affects [`filter_data::MagOffset`](crate::filter_data::MagOffset) and
    /// [`filter_data::MagOffsetUncertainty`](crate::filter_data::MagOffsetUncertainty). Confirmed
    /// on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 4 more. Known only from the
    /// MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Hard iron offset noise (0x0D,0x2B).
    #[derive(Copy)]
    pub struct HardIronOffsetNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: gauss. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    HardIronOffsetNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    HardIronOffsetNoise

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    HardIronOffsetNoise: 0x2B, "filter.hard_iron_offset_noise";
    in [0x0D];
}

command! {
    HardIronOffsetNoise -> Option<HardIronOffsetNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> HardIronOffsetNoiseResponse;
    responds HardIronOffsetNoiseResponse for READ;
    checks Ranged;
}

change! {
    HardIronOffsetNoiseResponse -> WriteCall HardIronOffsetNoise
    [noise]
}

record! {
    /// Soft iron matrix noise (0x0D,0x2C).
    ///
    /// Sets the standard deviation of the noise of the estimated soft iron matrix (process noise).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`SoftIronMatrixNoiseResponse`].
    /// Probably affects [`filter_data::MagMatrix`](crate::filter_data::MagMatrix) and
    /// [`filter_data::MagMatrixUncertainty`](crate::filter_data::MagMatrixUncertainty). Confirmed
    /// on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 4 more. Known only from the
    /// MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// Source: mip-sdk-4: Soft iron matrix noise (0x0D,0x2C).
    #[derive(Copy)]
    pub struct SoftIronMatrixNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per element.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Range: greater than 0.
        /// Required for [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Matrix3f>,
    }
    wire 37 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    SoftIronMatrixNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    SoftIronMatrixNoise

    /// Apply the new setting.
    fn write(noise: impl Into<types::Matrix3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    SoftIronMatrixNoise: 0x2C, "filter.soft_iron_matrix_noise";
    in [0x0D];
}

command! {
    SoftIronMatrixNoise -> Option<SoftIronMatrixNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SoftIronMatrixNoiseResponse;
    responds SoftIronMatrixNoiseResponse for READ;
    checks Ranged;
}

change! {
    SoftIronMatrixNoiseResponse -> WriteCall SoftIronMatrixNoise
    [noise]
}

record! {
    /// Enable or disable measurements (0x0D,0x41).
    ///
    /// Selects the inertial measurements that the filter uses.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`EnableMeasurementsResponse`].
    /// Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty) and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 6 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41).
    #[derive(Copy, Eq, Hash)]
    pub struct EnableMeasurements {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Measurements to use.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-15](crate::devices::CX5_15) and
        /// [3DM-GX5-15](crate::devices::GX5_15): only [`accel`](MeasurementFlags::accel).
        pub control: Option<MeasurementFlags>,
    }
    wire 3 {
        [function selects]
        [control for WRITE]
    }
}

constructors! {
    EnableMeasurements

    /// Apply the new setting.
    fn write(control: MeasurementFlags) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    EnableMeasurements: 0x41, "filter.enable_measurements";
    in [0x0D];
}

command! {
    EnableMeasurements -> Option<EnableMeasurementsResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> EnableMeasurementsResponse;
    responds EnableMeasurementsResponse for READ;
}

change! {
    EnableMeasurementsResponse -> WriteCall EnableMeasurements
    [control]
}

record! {
    /// Magnetometer noise (0x0D,0x42).
    ///
    /// Sets the standard deviation of the magnetometer noise that the filter assumes.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`MagNoiseResponse`]. Probably
    /// affects [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty)
    /// and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 9 more. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer. Uncertain: The SDK calls it process
    /// noise, although the noise is that of a measurement.
    ///
    /// Source: mip-sdk-4: Mag Noise (0x0D,0x42).
    #[derive(Copy)]
    pub struct MagNoise {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: gauss. Range: greater than 0. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

ranges! {
    MagNoise
    noise "noise" in "greater than 0" Above 0.0;
}

constructors! {
    MagNoise

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    MagNoise: 0x42, "filter.mag_noise";
    in [0x0D];
}

command! {
    MagNoise -> Option<MagNoiseResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MagNoiseResponse;
    responds MagNoiseResponse for READ;
    checks Ranged;
}

change! {
    MagNoiseResponse -> WriteCall MagNoise
    [noise]
}

record! {
    /// Magnetic declination source (0x0D,0x43).
    ///
    /// Selects the source of the local declination of the magnetic field.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`MagneticDeclinationSourceResponse`]. Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 14 more. Requires a magnetometer.
    ///
    /// - Without a good declination source, keep automatic magnetometer calibration off.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43); 3dm-gq7:
    /// Magnetic Field Declination Source Control (0x0D,0x43).
    #[derive(Copy)]
    pub struct MagneticDeclinationSource {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the declination.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS) and [3DM-GV7-AHRS](crate::devices::GV7_AHRS):
        /// only [`MagParameterSource::NONE`] and [`MagParameterSource::MANUAL`]. On the
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7): only [`MagParameterSource::WMM`] and
        /// [`MagParameterSource::MANUAL`].
        pub source: Option<MagParameterSource>,
        /// Angle from true north to magnetic north; used only if `source` is manual.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is east of true north.
        /// Required for [write](types::FunctionSelector::WRITE). Uncertain: The sign is the usual
        /// one; no source states it. Uncertain: The manuals, that of the 3DM-GQ7 included, require
        /// it only if `source` is manual, but state one length, with the value. Always send it.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub declination: Option<f32>,
    }
    wire 6 {
        [function selects]
        [source for WRITE]
        [declination for WRITE]
    }
}

ranges! {
    MagneticDeclinationSource
    declination "declination" in "-pi to pi" From -3.141592653589793 To 3.141592653589793;
}

constructors! {
    MagneticDeclinationSource

    /// Apply the new setting.
    fn write(source: MagParameterSource, declination: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    MagneticDeclinationSource: 0x43, "filter.magnetic_declination_source";
    in [0x0D];
}

command! {
    MagneticDeclinationSource -> Option<MagneticDeclinationSourceResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MagneticDeclinationSourceResponse;
    responds MagneticDeclinationSourceResponse for READ;
    checks Ranged;
}

change! {
    MagneticDeclinationSourceResponse -> WriteCall MagneticDeclinationSource
    [source declination]
}

record! {
    /// Gravity magnitude error adaptive measurement (0x0D,0x44).
    ///
    /// Sets how far the filter trusts gravity measurements whose magnitude is not as expected.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`AccelMagnitudeErrorAdaptiveMeasurementResponse`]. Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty) and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 13 more.
    ///
    /// - Also called accelerometer magnitude error adaptive measurement.
    /// - All parameters after the selector keep their values if they are omitted.
    /// - The low-pass filter and the limits take effect only with `fixed`.
    /// - Raise the limits where vibration is strong, lower them where it is weak. High limits
    ///   reduce the accuracy of pitch and roll under linear acceleration, low limits reduce the
    ///   accuracy of the heading.
    ///
    /// Source: 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44).
    #[derive(Copy)]
    pub struct AccelMagnitudeErrorAdaptiveMeasurement {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Kind of adaptation.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): only
        /// [`AdaptiveMeasurementSelector::DISABLED`] and [`AdaptiveMeasurementSelector::FIXED`].
        pub adaptive_measurement: Option<AdaptiveMeasurementSelector>,
        /// Cutoff frequency of the low-pass filter.
        ///
        /// Unit: Hz. Range: at least 0. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub frequency: Option<f32>,
        /// Lower limit of the gravity magnitude error.
        ///
        /// Unit: m/s^2. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub low_limit: Option<f32>,
        /// Upper limit of the gravity magnitude error.
        ///
        /// Unit: m/s^2. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub high_limit: Option<f32>,
        /// Standard deviation at the lower limit.
        ///
        /// Unit: m/s^2. Range: at least 0. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub low_limit_uncertainty: Option<f32>,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: m/s^2. Range: at least 0. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub high_limit_uncertainty: Option<f32>,
        /// Smallest standard deviation.
        ///
        /// Unit: m/s^2. Range: at least 0. Optional.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub minimum_uncertainty: Option<f32>,
    }
    wire 26 {
        [function selects]
        [adaptive_measurement for WRITE]
        [frequency optional]
        [low_limit optional]
        [high_limit optional]
        [low_limit_uncertainty optional]
        [high_limit_uncertainty optional]
        [minimum_uncertainty optional]
    }
}

ranges! {
    AccelMagnitudeErrorAdaptiveMeasurement
    frequency "frequency" in "at least 0" From 0.0;
    low_limit_uncertainty "low_limit_uncertainty" in "at least 0" From 0.0;
    high_limit_uncertainty "high_limit_uncertainty" in "at least 0" From 0.0;
    minimum_uncertainty "minimum_uncertainty" in "at least 0" From 0.0;
}

constructors! {
    AccelMagnitudeErrorAdaptiveMeasurement

    /// Apply the new setting.
    fn write(adaptive_measurement: AdaptiveMeasurementSelector) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

setters! {
    call AccelMagnitudeErrorAdaptiveMeasurement
    fn with_frequency(frequency: f32);
    fn with_low_limit(low_limit: f32);
    fn with_high_limit(high_limit: f32);
    fn with_low_limit_uncertainty(low_limit_uncertainty: f32);
    fn with_high_limit_uncertainty(high_limit_uncertainty: f32);
    fn with_minimum_uncertainty(minimum_uncertainty: f32);
}

field! {
    AccelMagnitudeErrorAdaptiveMeasurement: 0x44, "filter.accel_magnitude_error_adaptive_measurement";
    in [0x0D];
}

command! {
    AccelMagnitudeErrorAdaptiveMeasurement -> Option<AccelMagnitudeErrorAdaptiveMeasurementResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AccelMagnitudeErrorAdaptiveMeasurementResponse;
    responds AccelMagnitudeErrorAdaptiveMeasurementResponse for READ;
    checks Ranged;
}

change! {
    AccelMagnitudeErrorAdaptiveMeasurementResponse -> WriteCall AccelMagnitudeErrorAdaptiveMeasurement
    [adaptive_measurement]
}

record! {
    /// Magnetometer magnitude error adaptive measurement (0x0D,0x45).
    ///
    /// Sets how far the filter trusts a magnetic field whose magnitude is not as expected.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`MagMagnitudeErrorAdaptiveMeasurementResponse`]. Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty) and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 10 more. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer. Uncertain: The parameters after the
    /// selector can possibly be omitted on write, like those of
    /// [`AccelMagnitudeErrorAdaptiveMeasurement`].
    ///
    /// - The limits and the low-pass filter take effect only with `fixed`; with `auto` the device
    ///   determines the limits.
    /// - High limits suit high dynamics but do not reject disturbances of the field; low limits can
    ///   degrade the heading.
    ///
    /// Source: mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45).
    #[derive(Copy)]
    pub struct MagMagnitudeErrorAdaptiveMeasurement {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Kind of adaptation.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX4-45](crate::devices::GX4_45),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
        /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): only
        /// [`AdaptiveMeasurementSelector::DISABLED`] and [`AdaptiveMeasurementSelector::FIXED`].
        pub adaptive_measurement: Option<AdaptiveMeasurementSelector>,
        /// Cutoff frequency of the low-pass filter.
        ///
        /// Unit: Hz. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub frequency: Option<f32>,
        /// Lower limit of the magnetic field magnitude error.
        ///
        /// Unit: gauss. Required for [write](types::FunctionSelector::WRITE). Uncertain: The unit
        /// gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the
        /// command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub low_limit: Option<f32>,
        /// Upper limit of the magnetic field magnitude error.
        ///
        /// Unit: gauss. Required for [write](types::FunctionSelector::WRITE). Uncertain: The unit
        /// gauss is inferred: the SDK states m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the
        /// command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub high_limit: Option<f32>,
        /// Standard deviation at the lower limit.
        ///
        /// Unit: gauss. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the
        /// 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub low_limit_uncertainty: Option<f32>,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: gauss. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the
        /// 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub high_limit_uncertainty: Option<f32>,
        /// Smallest standard deviation.
        ///
        /// Unit: gauss. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of the
        /// 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub minimum_uncertainty: Option<f32>,
    }
    wire 26 {
        [function selects]
        [adaptive_measurement for WRITE]
        [frequency for WRITE]
        [low_limit for WRITE]
        [high_limit for WRITE]
        [low_limit_uncertainty for WRITE]
        [high_limit_uncertainty for WRITE]
        [minimum_uncertainty for WRITE]
    }
}

ranges! {
    MagMagnitudeErrorAdaptiveMeasurement
    frequency "frequency" in "at least 0" From 0.0;
    low_limit_uncertainty "low_limit_uncertainty" in "at least 0" From 0.0;
    high_limit_uncertainty "high_limit_uncertainty" in "at least 0" From 0.0;
    minimum_uncertainty "minimum_uncertainty" in "at least 0" From 0.0;
}

constructors! {
    MagMagnitudeErrorAdaptiveMeasurement

    /// Apply the new setting.
    fn write(
        adaptive_measurement: AdaptiveMeasurementSelector,
        frequency: f32,
        low_limit: f32,
        high_limit: f32,
        low_limit_uncertainty: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    MagMagnitudeErrorAdaptiveMeasurement: 0x45, "filter.mag_magnitude_error_adaptive_measurement";
    in [0x0D];
}

command! {
    MagMagnitudeErrorAdaptiveMeasurement -> Option<MagMagnitudeErrorAdaptiveMeasurementResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MagMagnitudeErrorAdaptiveMeasurementResponse;
    responds MagMagnitudeErrorAdaptiveMeasurementResponse for READ;
    checks Ranged;
}

change! {
    MagMagnitudeErrorAdaptiveMeasurementResponse -> WriteCall MagMagnitudeErrorAdaptiveMeasurement
    [adaptive_measurement frequency low_limit high_limit low_limit_uncertainty high_limit_uncertainty minimum_uncertainty]
}

record! {
    /// Magnetometer dip angle error adaptive measurement (0x0D,0x46).
    ///
    /// Sets how far the filter trusts a magnetic field whose dip angle is not as expected.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`MagDipAngleErrorAdaptiveMeasurementResponse`]. Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty) and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 9 more. Known only
    /// from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// - It has no effect while [`AccelMagnitudeErrorAdaptiveMeasurement`] or
    ///   [`MagMagnitudeErrorAdaptiveMeasurement`] is set to `auto`.
    /// - High limits suit high dynamics but do not reject disturbances of the field; low limits can
    ///   degrade the heading.
    ///
    /// Source: mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46).
    #[derive(Copy)]
    pub struct MagDipAngleErrorAdaptiveMeasurement {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// True if the adaptation is on.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<crate::Bool>,
        /// Cutoff frequency of the low-pass filter.
        ///
        /// Unit: Hz. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub frequency: Option<f32>,
        /// Upper limit of the dip angle error.
        ///
        /// Unit: rad. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub high_limit: Option<f32>,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: rad. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub high_limit_uncertainty: Option<f32>,
        /// Smallest standard deviation.
        ///
        /// Unit: rad. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: The unit rad is inferred from the quantity; the SDK states m/s^2.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub minimum_uncertainty: Option<f32>,
    }
    wire 18 {
        [function selects]
        [enable for WRITE]
        [frequency for WRITE]
        [high_limit for WRITE]
        [high_limit_uncertainty for WRITE]
        [minimum_uncertainty for WRITE]
    }
}

ranges! {
    MagDipAngleErrorAdaptiveMeasurement
    frequency "frequency" in "at least 0" From 0.0;
    high_limit "high_limit" in "at least 0" From 0.0;
    high_limit_uncertainty "high_limit_uncertainty" in "at least 0" From 0.0;
    minimum_uncertainty "minimum_uncertainty" in "at least 0" From 0.0;
}

constructors! {
    MagDipAngleErrorAdaptiveMeasurement

    /// Apply the new setting.
    fn write(
        enable: bool,
        frequency: f32,
        high_limit: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    MagDipAngleErrorAdaptiveMeasurement: 0x46, "filter.mag_dip_angle_error_adaptive_measurement";
    in [0x0D];
}

command! {
    MagDipAngleErrorAdaptiveMeasurement -> Option<MagDipAngleErrorAdaptiveMeasurementResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MagDipAngleErrorAdaptiveMeasurementResponse;
    responds MagDipAngleErrorAdaptiveMeasurementResponse for READ;
    checks Ranged;
}

change! {
    MagDipAngleErrorAdaptiveMeasurementResponse -> WriteCall MagDipAngleErrorAdaptiveMeasurement
    [enable frequency high_limit high_limit_uncertainty minimum_uncertainty]
}

record! {
    /// Altitude aiding (0x0D,0x47).
    ///
    /// Selects the source that aids the altitude in addition to GNSS.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AltitudeAidingResponse`]. Probably
    /// affects [`filter_data::LlhPosition`](crate::filter_data::LlhPosition) and
    /// [`filter_data::LlhPositionUncertainty`](crate::filter_data::LlhPositionUncertainty).
    /// Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 4 more. Known only
    /// from the MicroStrain MIP SDK. Requires a pressure sensor.
    ///
    /// - GNSS remains the main source of altitude; the aid improves it and bridges outages.
    /// - Weather and location shift the pressure altitude, sometimes by more than 40 m.
    ///
    /// Source: mip-sdk-4: Altitude aiding (0x0D,0x47).
    #[derive(Copy, Eq, Hash)]
    pub struct AltitudeAiding {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the aiding.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub selector: Option<AltitudeAidingSource>,
    }
    wire 2 {
        [function selects]
        [selector for WRITE]
    }
}

constructors! {
    AltitudeAiding

    /// Apply the new setting.
    fn write(selector: AltitudeAidingSource) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AltitudeAiding: 0x47, "filter.altitude_aiding";
    in [0x0D];
}

command! {
    AltitudeAiding -> Option<AltitudeAidingResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AltitudeAidingResponse;
    responds AltitudeAidingResponse for READ;
}

change! {
    AltitudeAidingResponse -> WriteCall AltitudeAiding
    [selector]
}

record! {
    /// Pitch and roll aiding (0x0D,0x4B).
    ///
    /// Selects the source that aids pitch and roll while the motion is gentle.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`PitchRollAidingResponse`]. Probably
    /// affects [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::EulerAnglesUncertainty`](crate::filter_data::EulerAnglesUncertainty) and
    /// [`filter_data::QuaternionAttitudeUncertainty`](crate::filter_data::QuaternionAttitudeUncertainty).
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 6 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B).
    #[derive(Copy, Eq, Hash)]
    pub struct PitchRollAiding {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the aiding.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub aiding: Option<PitchRollAidingSource>,
    }
    wire 2 {
        [function selects]
        [aiding for WRITE]
    }
}

constructors! {
    PitchRollAiding

    /// Apply the new setting.
    fn write(aiding: PitchRollAidingSource) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    PitchRollAiding: 0x4B, "filter.pitch_roll_aiding";
    in [0x0D];
}

command! {
    PitchRollAiding -> Option<PitchRollAidingResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> PitchRollAidingResponse;
    responds PitchRollAidingResponse for READ;
}

change! {
    PitchRollAidingResponse -> WriteCall PitchRollAiding
    [aiding]
}

record! {
    /// Magnetic inclination source (0x0D,0x4C).
    ///
    /// Selects the source of the local inclination (dip angle) of the magnetic field.
    ///
    /// Also called `inclination_source`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`MagneticInclinationSourceResponse`]. Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// - Without a good inclination source, keep automatic magnetometer calibration off.
    ///
    /// Source: mip-sdk-4: Inclination Source (0x0D,0x4C).
    #[derive(Copy)]
    pub struct MagneticInclinationSource {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the inclination.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub source: Option<MagParameterSource>,
        /// Angle of the field below the horizontal plane; used only if `source` is manual.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: the
        /// field points down. Required for [write](types::FunctionSelector::WRITE). Uncertain: The
        /// sign is the usual one; no source states it. Uncertain: It can possibly be omitted if
        /// `source` is not manual, as with [`MagneticDeclinationSource`]. The SDK always sends it.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub inclination: Option<f32>,
    }
    wire 6 {
        [function selects]
        [source for WRITE]
        [inclination for WRITE]
    }
}

ranges! {
    MagneticInclinationSource
    inclination "inclination" in "-1.5707963267948966 to 1.5707963267948966" From -1.5707963267948966 To 1.5707963267948966;
}

constructors! {
    MagneticInclinationSource

    /// Apply the new setting.
    fn write(source: MagParameterSource, inclination: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    MagneticInclinationSource: 0x4C, "filter.magnetic_inclination_source";
    in [0x0D];
}

command! {
    MagneticInclinationSource -> Option<MagneticInclinationSourceResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MagneticInclinationSourceResponse;
    responds MagneticInclinationSourceResponse for READ;
    checks Ranged;
}

change! {
    MagneticInclinationSourceResponse -> WriteCall MagneticInclinationSource
    [source inclination]
}

record! {
    /// Magnetic field magnitude source (0x0D,0x4D).
    ///
    /// Selects the source of the local magnitude of the magnetic field.
    ///
    /// Also called `mag_field_magnitude_source`. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`MagneticMagnitudeSourceResponse`].
    /// Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK. Requires a magnetometer.
    ///
    /// - Without a good magnitude source, keep automatic magnetometer calibration off.
    /// - [`MagMagnitudeErrorAdaptiveMeasurement`] relies on it too.
    ///
    /// Source: mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D).
    #[derive(Copy)]
    pub struct MagneticMagnitudeSource {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the magnitude.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub source: Option<MagParameterSource>,
        /// Magnitude; used only if `source` is manual.
        ///
        /// Unit: gauss. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        /// Uncertain: It can possibly be omitted if `source` is not manual, as with
        /// [`MagneticDeclinationSource`]. The SDK always sends it.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub magnitude: Option<f32>,
    }
    wire 6 {
        [function selects]
        [source for WRITE]
        [magnitude for WRITE]
    }
}

ranges! {
    MagneticMagnitudeSource
    magnitude "magnitude" in "at least 0" From 0.0;
}

constructors! {
    MagneticMagnitudeSource

    /// Apply the new setting.
    fn write(source: MagParameterSource, magnitude: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    MagneticMagnitudeSource: 0x4D, "filter.magnetic_magnitude_source";
    in [0x0D];
}

command! {
    MagneticMagnitudeSource -> Option<MagneticMagnitudeSourceResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MagneticMagnitudeSourceResponse;
    responds MagneticMagnitudeSourceResponse for READ;
    checks Ranged;
}

change! {
    MagneticMagnitudeSourceResponse -> WriteCall MagneticMagnitudeSource
    [source magnitude]
}

record! {
    /// Sensor to vehicle rotation, matrix (0x0D,0x4E).
    ///
    /// Sets the rotation from the sensor frame to the vehicle frame as a direction cosine matrix.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`SensorToVehicleRotationDcmResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate) and
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector). Probably affects
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel). Not listed in any device profile.
    /// Known only from the MicroStrain MIP SDK.
    ///
    /// - It is the inverse of the matrix that
    ///   [`mip_3dm::SensorToVehicleTransformDcm`](crate::mip_3dm::SensorToVehicleTransformDcm)
    ///   accepts.
    /// - The device rejects a matrix that is not orthonormal to within 0.001.
    /// - The device keeps a quaternion, so the elements read back may differ slightly from those
    ///   written.
    ///
    /// Source: mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E).
    #[derive(Copy)]
    pub struct SensorToVehicleRotationDcm {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Rotates vectors of the vehicle frame into the sensor frame; row-major.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub dcm: Option<types::Matrix3f>,
    }
    wire 37 {
        [function selects]
        [dcm for WRITE]
    }
}

constructors! {
    SensorToVehicleRotationDcm

    /// Apply the new setting.
    fn write(dcm: impl Into<types::Matrix3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    SensorToVehicleRotationDcm: 0x4E, "filter.sensor_to_vehicle_rotation_dcm";
    in [0x0D];
}

command! {
    SensorToVehicleRotationDcm -> Option<SensorToVehicleRotationDcmResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleRotationDcmResponse;
    responds SensorToVehicleRotationDcmResponse for READ;
}

change! {
    SensorToVehicleRotationDcmResponse -> WriteCall SensorToVehicleRotationDcm
    [dcm]
}

record! {
    /// Sensor to vehicle rotation, quaternion (0x0D,0x4F).
    ///
    /// Sets the rotation from the sensor frame to the vehicle frame as a quaternion.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`SensorToVehicleRotationQuaternionResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate) and
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector). Probably affects
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel). Not listed in any device profile.
    /// Known only from the MicroStrain MIP SDK.
    ///
    /// - It is the inverse of the quaternion that
    ///   [`mip_3dm::SensorToVehicleTransformQuaternion`](crate::mip_3dm::SensorToVehicleTransformQuaternion)
    ///   accepts.
    /// - The device normalizes it, so the elements read back may differ slightly from those
    ///   written.
    ///
    /// Source: mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F).
    #[derive(Copy)]
    pub struct SensorToVehicleRotationQuaternion {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first.
        ///
        /// Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to 1.001. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub q: Option<types::Quatf>,
    }
    wire 17 {
        [function selects]
        [q for WRITE]
    }
}

constructors! {
    SensorToVehicleRotationQuaternion

    /// Apply the new setting.
    fn write(q: impl Into<types::Quatf>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    SensorToVehicleRotationQuaternion: 0x4F, "filter.sensor_to_vehicle_rotation_quaternion";
    in [0x0D];
}

command! {
    SensorToVehicleRotationQuaternion -> Option<SensorToVehicleRotationQuaternionResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleRotationQuaternionResponse;
    responds SensorToVehicleRotationQuaternionResponse for READ;
}

change! {
    SensorToVehicleRotationQuaternionResponse -> WriteCall SensorToVehicleRotationQuaternion
    [q]
}

record! {
    /// Aiding measurement control (0x0D,0x50).
    ///
    /// Enables or disables one source of aiding measurements.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AidingMeasurementEnableResponse`].
    /// Affects
    /// [`filter_data::AidingMeasurementSummary`](crate::filter_data::AidingMeasurementSummary).
    /// Probably affects filter_data (0x82). Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50).
    #[derive(Copy, Eq, Hash)]
    pub struct AidingMeasurementEnable {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// The source; `all` is for save, load and default.
        ///
        /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
        /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS) and [3DM-GV7-AHRS](crate::devices::GV7_AHRS):
        /// only [`AidingSource::MAG`], [`AidingSource::EXTERNAL_HEADING`] and
        /// [`AidingSource::ALL`]. On the [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CX7-AR](crate::devices::CX7_AR) and [3DM-GV7-AR](crate::devices::GV7_AR): only
        /// [`AidingSource::EXTERNAL_HEADING`] and [`AidingSource::ALL`]. On the
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-INS](crate::devices::CX7_INS) and
        /// [3DM-GV7-INS](crate::devices::GV7_INS): only [`AidingSource::GNSS_POSITION_VELOCITY`],
        /// [`AidingSource::ALTIMETER`], [`AidingSource::MAG`], [`AidingSource::EXTERNAL_HEADING`],
        /// [`AidingSource::EXTERNAL_ALTIMETER`], [`AidingSource::EXTERNAL_MAG`],
        /// [`AidingSource::BODY_FRAME_VELOCITY`] and [`AidingSource::ALL`]. On the
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7): only [`AidingSource::GNSS_POSITION_VELOCITY`],
        /// [`AidingSource::GNSS_HEADING`], [`AidingSource::ALTIMETER`], [`AidingSource::SPEED`],
        /// [`AidingSource::MAG`], [`AidingSource::EXTERNAL_HEADING`] and [`AidingSource::ALL`].
        pub aiding_source: Option<AidingSource>,
        /// True if the filter uses the source.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<crate::Bool>,
    }
    wire 4 {
        [function selects]
        [aiding_source for WRITE READ SAVE LOAD DEFAULT]
        [enable for WRITE]
    }
}

constructors! {
    AidingMeasurementEnable

    /// Apply the new setting.
    fn write(aiding_source: AidingSource, enable: bool) -> WriteCall;

    /// Return the current setting in a response.
    fn read(aiding_source: AidingSource) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(aiding_source: AidingSource) -> SaveCall;

    /// Load the saved setting.
    fn load(aiding_source: AidingSource) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(aiding_source: AidingSource) -> LoadDefaultCall;
}

field! {
    AidingMeasurementEnable: 0x50, "filter.aiding_measurement_enable";
    in [0x0D];
}

command! {
    AidingMeasurementEnable -> Option<AidingMeasurementEnableResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AidingMeasurementEnableResponse;
    responds AidingMeasurementEnableResponse for READ;
}

change! {
    AidingMeasurementEnableResponse -> WriteCall AidingMeasurementEnable
    [aiding_source enable]
}

record! {
    /// Kinematic constraint (0x0D,0x51).
    ///
    /// Sets the assumptions about the motion that the filter uses in place of measurements.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`KinematicConstraintResponse`].
    /// Probably affects [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK. Uncertain: There may be further values,
    /// because the SDK uses plain numbers and lists values in comments only.
    ///
    /// Source: mip-sdk-4: Kinematic constraint (0x0D,0x51).
    #[derive(Copy, Eq, Hash)]
    pub struct KinematicConstraint {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Assumption about the acceleration.
        ///
        /// Default: [`AccelConstraint::NONE`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub accel_constraint: Option<AccelConstraint>,
        /// Assumption about the velocity.
        ///
        /// Default: [`VelocityConstraint::NONE`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub velocity_constraint: Option<VelocityConstraint>,
        /// Assumption about the angular rate.
        ///
        /// Default: [`AngularConstraint::NONE`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub angular_constraint: Option<AngularConstraint>,
    }
    wire 4 {
        [function selects]
        [accel_constraint for WRITE]
        [velocity_constraint for WRITE]
        [angular_constraint for WRITE]
    }
}

constructors! {
    KinematicConstraint

    /// Apply the new setting.
    fn write(
        accel_constraint: AccelConstraint,
        velocity_constraint: VelocityConstraint,
        angular_constraint: AngularConstraint,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    KinematicConstraint: 0x51, "filter.kinematic_constraint";
    in [0x0D];
}

command! {
    KinematicConstraint -> Option<KinematicConstraintResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> KinematicConstraintResponse;
    responds KinematicConstraintResponse for READ;
}

change! {
    KinematicConstraintResponse -> WriteCall KinematicConstraint
    [accel_constraint velocity_constraint angular_constraint]
}

record! {
    /// Navigation filter initialization (0x0D,0x52).
    ///
    /// Sets the sources and values of the initial attitude, position and velocity of the filter.
    ///
    /// Also called `initialization_configuration`. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`InitializationConfigResponse`].
    /// Probably affects [`filter_data::Status`](crate::filter_data::Status),
    /// [`filter_data::LlhPosition`](crate::filter_data::LlhPosition),
    /// [`filter_data::EcefPosition`](crate::filter_data::EcefPosition),
    /// [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 2 more.
    ///
    /// - The initial angles are in degrees, unlike those of [`SetInitialAttitude`], which are in
    ///   radians.
    /// - Single precision resolves the latitude and longitude of the initial position to about a
    ///   metre only.
    /// - Kinematic alignment sets the heading once the speed reaches 2 m/s.
    /// - External alignment needs a heading at least every 5 seconds.
    /// - A change takes effect at the next start of the filter: after [`Reset`] or a power cycle.
    ///
    /// Source: 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52).
    #[derive(Copy)]
    pub struct InitializationConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 1: the filter starts only after [`Run`]; 0: it starts as soon as it can.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub wait_for_run_command: Option<u8>,
        /// Initial conditions that your program provides instead of the device.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub initial_condition_source: Option<InitialConditionSource>,
        /// Methods that may be used to determine the initial heading.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-INS](crate::devices::CX7_INS) and
        /// [3DM-GV7-INS](crate::devices::GV7_INS): only [`kinematic`](HeadingAlignment::kinematic),
        /// [`mag`](HeadingAlignment::mag) and [`external`](HeadingAlignment::external). On the
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7): only
        /// [`dual_antenna`](HeadingAlignment::dual_antenna),
        /// [`kinematic`](HeadingAlignment::kinematic) and [`mag`](HeadingAlignment::mag).
        pub auto_heading_alignment_selector: Option<HeadingAlignment>,
        /// Initial heading relative to true north.
        ///
        /// Unit: deg. Frame: ned. Positive: clockwise seen from above. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub initial_heading: Option<f32>,
        /// Initial pitch angle.
        ///
        /// Unit: deg. Frame: ned. Positive: nose up. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub initial_pitch: Option<f32>,
        /// Initial roll angle.
        ///
        /// Unit: deg. Frame: ned. Positive: right side down. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub initial_roll: Option<f32>,
        /// Initial position that your program provides.
        ///
        /// Elements: x, y, z. Required for [write](types::FunctionSelector::WRITE). If
        /// [`reference_frame_selector`](InitializationConfig::reference_frame_selector) is
        /// [`ReferenceFrame::ECEF`]: unit m; frame ecef. If
        /// [`reference_frame_selector`](InitializationConfig::reference_frame_selector) is
        /// [`ReferenceFrame::LLH`]: elements latitude, longitude, height; unit deg, deg, m; frame
        /// llh.
        pub initial_position: Option<types::Vector3f>,
        /// Initial velocity that your program provides.
        ///
        /// Elements: x, y, z. Unit: m/s. Required for [write](types::FunctionSelector::WRITE). If
        /// [`reference_frame_selector`](InitializationConfig::reference_frame_selector) is
        /// [`ReferenceFrame::ECEF`]: frame ecef. If
        /// [`reference_frame_selector`](InitializationConfig::reference_frame_selector) is
        /// [`ReferenceFrame::LLH`]: elements north, east, down; frame ned.
        pub initial_velocity: Option<types::Vector3f>,
        /// Frame of the initial position and velocity.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub reference_frame_selector: Option<ReferenceFrame>,
    }
    wire 41 {
        [function selects]
        [wait_for_run_command for WRITE]
        [initial_condition_source for WRITE]
        [auto_heading_alignment_selector for WRITE]
        [initial_heading for WRITE]
        [initial_pitch for WRITE]
        [initial_roll for WRITE]
        [initial_position for WRITE]
        [initial_velocity for WRITE]
        [reference_frame_selector for WRITE]
    }
}

ranges! {
    InitializationConfig
    wait_for_run_command "wait_for_run_command" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    InitializationConfig

    /// Apply the new setting.
    fn write(
        wait_for_run_command: u8,
        initial_condition_source: InitialConditionSource,
        auto_heading_alignment_selector: HeadingAlignment,
        initial_heading: f32,
        initial_pitch: f32,
        initial_roll: f32,
        initial_position: impl Into<types::Vector3f>,
        initial_velocity: impl Into<types::Vector3f>,
        reference_frame_selector: ReferenceFrame,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    InitializationConfig: 0x52, "filter.initialization_config";
    in [0x0D];
}

command! {
    InitializationConfig -> Option<InitializationConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> InitializationConfigResponse;
    responds InitializationConfigResponse for READ;
    checks Ranged;
}

change! {
    InitializationConfigResponse -> WriteCall InitializationConfig
    [wait_for_run_command initial_condition_source auto_heading_alignment_selector initial_heading initial_pitch initial_roll initial_position initial_velocity reference_frame_selector]
}

record! {
    /// Adaptive filter control (0x0D,0x53).
    ///
    /// Sets how the filter adapts to measurements that do not fit its model.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`AdaptiveFilterOptionsResponse`].
    /// Probably affects filter_data (0x82). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 12 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53).
    #[derive(Copy, Eq, Hash)]
    pub struct AdaptiveFilterOptions {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Strength of the adaptation.
        ///
        /// Default: 2. Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-45](crate::devices::GX5_45): only [`AdaptiveLevel::OFF`] and
        /// [`AdaptiveLevel::MODERATE`].
        pub level: Option<AdaptiveLevel>,
        /// Longest time for which measurements are rejected before the filter recovers.
        ///
        /// Unit: ms. Required for [write](types::FunctionSelector::WRITE).
        pub time_limit: Option<u16>,
    }
    wire 4 {
        [function selects]
        [level for WRITE]
        [time_limit for WRITE]
    }
}

constructors! {
    AdaptiveFilterOptions

    /// Apply the new setting.
    fn write(level: AdaptiveLevel, time_limit: u16) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    AdaptiveFilterOptions: 0x53, "filter.adaptive_filter_options";
    in [0x0D];
}

command! {
    AdaptiveFilterOptions -> Option<AdaptiveFilterOptionsResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> AdaptiveFilterOptionsResponse;
    responds AdaptiveFilterOptionsResponse for READ;
}

change! {
    AdaptiveFilterOptionsResponse -> WriteCall AdaptiveFilterOptions
    [level time_limit]
}

record! {
    /// GNSS multi-antenna offset (0x0D,0x54).
    ///
    /// Sets the position of the antenna of one receiver on devices with several antennas.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`MultiAntennaOffsetResponse`].
    /// Probably affects [`filter_data::LlhPosition`](crate::filter_data::LlhPosition),
    /// [`filter_data::EcefPosition`](crate::filter_data::EcefPosition),
    /// [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::MultiAntennaOffsetCorrection`](crate::filter_data::MultiAntennaOffsetCorrection)
    /// and [`filter_data::GnssDualAntennaStatus`](crate::filter_data::GnssDualAntennaStatus).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    /// Requires a receiver.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54).
    #[derive(Copy)]
    pub struct MultiAntennaOffset {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Number of the receiver, from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: Option<u8>,
        /// Lever arm from the sensor to the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub antenna_offset: Option<types::Vector3f>,
    }
    wire 14 {
        [function selects]
        [receiver_id for WRITE READ SAVE LOAD DEFAULT]
        [antenna_offset for WRITE]
    }
}

ranges! {
    MultiAntennaOffset
    receiver_id "receiver_id" in "at least 1" From 1.0;
}

constructors! {
    MultiAntennaOffset

    /// Apply the new setting.
    fn write(receiver_id: u8, antenna_offset: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read(receiver_id: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(receiver_id: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(receiver_id: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(receiver_id: u8) -> LoadDefaultCall;
}

field! {
    MultiAntennaOffset: 0x54, "filter.multi_antenna_offset";
    in [0x0D];
}

command! {
    MultiAntennaOffset -> Option<MultiAntennaOffsetResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MultiAntennaOffsetResponse;
    responds MultiAntennaOffsetResponse for READ;
    checks Ranged;
}

change! {
    MultiAntennaOffsetResponse -> WriteCall MultiAntennaOffset
    [receiver_id antenna_offset]
}

record! {
    /// Relative position configuration (0x0D,0x55).
    ///
    /// Sets the reference point of the relative position that the filter reports.
    ///
    /// Also called `rel_pos_configuration`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`RelativePositionConfigResponse`]. Affects
    /// [`filter_data::NedRelativePosition`](crate::filter_data::NedRelativePosition). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 4 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55).
    #[derive(Copy)]
    pub struct RelativePositionConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the reference point.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub source: Option<RelativePositionSource>,
        /// Frame of the coordinates.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub reference_frame_selector: Option<ReferenceFrame>,
        /// Reference point.
        ///
        /// Elements: x, y, z. Required for [write](types::FunctionSelector::WRITE). If
        /// [`reference_frame_selector`](RelativePositionConfig::reference_frame_selector) is
        /// [`ReferenceFrame::ECEF`]: unit m; frame ecef. If
        /// [`reference_frame_selector`](RelativePositionConfig::reference_frame_selector) is
        /// [`ReferenceFrame::LLH`]: elements latitude, longitude, height; unit deg, deg, m; frame
        /// llh.
        pub reference_coordinates: Option<types::Vector3d>,
    }
    wire 27 {
        [function selects]
        [source for WRITE]
        [reference_frame_selector for WRITE]
        [reference_coordinates for WRITE]
    }
}

constructors! {
    RelativePositionConfig

    /// Apply the new setting.
    fn write(
        source: RelativePositionSource,
        reference_frame_selector: ReferenceFrame,
        reference_coordinates: impl Into<types::Vector3d>,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    RelativePositionConfig: 0x55, "filter.relative_position_config";
    in [0x0D];
}

command! {
    RelativePositionConfig -> Option<RelativePositionConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> RelativePositionConfigResponse;
    responds RelativePositionConfigResponse for READ;
}

change! {
    RelativePositionConfigResponse -> WriteCall RelativePositionConfig
    [source reference_frame_selector reference_coordinates]
}

record! {
    /// Reference point lever arm (0x0D,0x56).
    ///
    /// Moves the point to which the position and the velocity of the filter refer.
    ///
    /// Also called `ref_point_lever_arm`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`ReferencePointLeverArmResponse`]. Affects
    /// [`filter_data::LlhPosition`](crate::filter_data::LlhPosition),
    /// [`filter_data::EcefPosition`](crate::filter_data::EcefPosition),
    /// [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity) and
    /// [`filter_data::NedRelativePosition`](crate::filter_data::NedRelativePosition). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 4 more.
    ///
    /// - The shift in position depends on the attitude; the shift in velocity also depends on the
    ///   angular rate.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56).
    #[derive(Copy)]
    pub struct ReferencePointLeverArm {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Point to move; it must be 1.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub reference_point: Option<ReferencePoint>,
        /// Lever arm from the sensor to the point.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub lever_arm_offset: Option<types::Vector3f>,
    }
    wire 14 {
        [function selects]
        [reference_point for WRITE]
        [lever_arm_offset for WRITE]
    }
}

constructors! {
    ReferencePointLeverArm

    /// Apply the new setting.
    fn write(reference_point: ReferencePoint, lever_arm_offset: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    ReferencePointLeverArm: 0x56, "filter.reference_point_lever_arm";
    in [0x0D];
}

command! {
    ReferencePointLeverArm -> Option<ReferencePointLeverArmResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ReferencePointLeverArmResponse;
    responds ReferencePointLeverArmResponse for READ;
}

change! {
    ReferencePointLeverArmResponse -> WriteCall ReferencePointLeverArm
    [reference_point lever_arm_offset]
}

record! {
    /// Speed measurement (0x0D,0x60).
    ///
    /// Sends one measurement of the forward speed of the vehicle (along its x axis) to the filter.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The
    /// SDK names a response, `filter.speed_measurement_response`, but has no layout of it.
    ///
    /// - Do not use it together with the device's odometer.
    /// - Single precision resolves the time of week to 0.0625 s at the end of the week.
    ///
    /// Source: mip-sdk-4: Speed measurement (0x0D,0x60).
    #[derive(Copy)]
    pub struct SpeedMeasurement {
        /// Send 1.
        ///
        /// Reserved: send 1.
        pub source: u8,
        /// GPS time of week of the measurement.
        ///
        /// Unit: s. Range: 0 to 604800. Uncertain: The unit is inferred; the SDK states none.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f32,
        /// Speed along the x axis of the vehicle.
        ///
        /// Unit: m/s. Frame: vehicle. Positive: forward.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub speed: f32,
        /// Standard deviation of the speed.
        ///
        /// Unit: m/s. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub speed_uncertainty: f32,
    }
}

#[rustfmt::skip]
impl core::default::Default for SpeedMeasurement {
    fn default() -> Self {
        Self {
            source: 1,
            tow: core::default::Default::default(),
            speed: core::default::Default::default(),
            speed_uncertainty: core::default::Default::default(),
        }
    }
}

ranges! {
    SpeedMeasurement
    tow "tow" in "0 to 604800" From 0.0 To 604800.0;
    speed_uncertainty "speed_uncertainty" in "at least 0" From 0.0;
}

constructors! {
    SpeedMeasurement

    /// Creates the command from its parameters.
    fn new(
        tow: f32,
        speed: f32,
        speed_uncertainty: f32,
    ), source: 1;
}

field! {
    SpeedMeasurement: 0x60, "filter.speed_measurement";
    in [0x0D];
}

command! {
    SpeedMeasurement -> ();
    checks Ranged;
}

record! {
    /// Speed measurement lever arm (0x0D,0x61).
    ///
    /// Sets the position of the point whose speed is measured, such as the wheel that drives the
    /// odometer.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`SpeedLeverArmResponse`]. Probably
    /// affects [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity) and
    /// [`filter_data::OdometerScaleFactorError`](crate::filter_data::OdometerScaleFactorError).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - It corrects for the part of the speed at that point that is due to the rotation of the
    ///   vehicle.
    ///
    /// Source: 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61).
    #[derive(Copy)]
    pub struct SpeedLeverArm {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Reserved: send 1.
        pub source: Option<u8>,
        /// Lever arm from the sensor to the point of measurement.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub lever_arm_offset: Option<types::Vector3f>,
    }
    wire 14 {
        [function selects]
        [source for WRITE READ SAVE LOAD DEFAULT]
        [lever_arm_offset for WRITE]
    }
}

constructors! {
    SpeedLeverArm

    /// Apply the new setting.
    fn write(lever_arm_offset: impl Into<types::Vector3f>) -> WriteCall, source: 1;

    /// Return the current setting in a response.
    fn read() -> ReadCall, source: 1;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall, source: 1;

    /// Load the saved setting.
    fn load() -> LoadCall, source: 1;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall, source: 1;
}

field! {
    SpeedLeverArm: 0x61, "filter.speed_lever_arm";
    in [0x0D];
}

command! {
    SpeedLeverArm -> Option<SpeedLeverArmResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SpeedLeverArmResponse;
    responds SpeedLeverArmResponse for READ;
}

change! {
    SpeedLeverArmResponse -> WriteCall SpeedLeverArm
    [lever_arm_offset] source: 1,
}

record! {
    /// Vertical gyro constraint (0x0D,0x62).
    ///
    /// Sets whether the filter maintains pitch and roll with the accelerometers while there is no
    /// GNSS.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`VerticalGyroConstraintControlResponse`]. Probably affects
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - It assumes that the linear acceleration is zero.
    ///
    /// Source: mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62).
    #[derive(Copy, Eq, Hash)]
    pub struct VerticalGyroConstraintControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

ranges! {
    VerticalGyroConstraintControl
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    VerticalGyroConstraintControl

    /// Apply the new setting.
    fn write(enable: u8) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    VerticalGyroConstraintControl: 0x62, "filter.vertical_gyro_constraint_control";
    in [0x0D];
}

command! {
    VerticalGyroConstraintControl -> Option<VerticalGyroConstraintControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> VerticalGyroConstraintControlResponse;
    responds VerticalGyroConstraintControlResponse for READ;
    checks Ranged;
}

change! {
    VerticalGyroConstraintControlResponse -> WriteCall VerticalGyroConstraintControl
    [enable]
}

record! {
    /// Wheeled vehicle constraint (0x0D,0x63).
    ///
    /// Sets whether the filter assumes that the vehicle moves only along its x axis.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`WheeledVehicleConstraintControlResponse`]. Probably affects
    /// [`filter_data::NedVelocity`](crate::filter_data::NedVelocity),
    /// [`filter_data::EcefVelocity`](crate::filter_data::EcefVelocity),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm) and
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - It improves the heading of cars and similar vehicles, especially with intermittent GNSS.
    ///   Do not use it for vehicles that move sideways, such as aircraft.
    ///
    /// Source: 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63).
    #[derive(Copy, Eq, Hash)]
    pub struct WheeledVehicleConstraintControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

ranges! {
    WheeledVehicleConstraintControl
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    WheeledVehicleConstraintControl

    /// Apply the new setting.
    fn write(enable: u8) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    WheeledVehicleConstraintControl: 0x63, "filter.wheeled_vehicle_constraint_control";
    in [0x0D];
}

command! {
    WheeledVehicleConstraintControl -> Option<WheeledVehicleConstraintControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> WheeledVehicleConstraintControlResponse;
    responds WheeledVehicleConstraintControlResponse for READ;
    checks Ranged;
}

change! {
    WheeledVehicleConstraintControlResponse -> WriteCall WheeledVehicleConstraintControl
    [enable]
}

record! {
    /// GNSS antenna offset calibration (0x0D,0x64).
    ///
    /// Enables antenna offset calibration.
    ///
    /// Also called `gnss_antenna_cal_control`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`GnssAntennaCalibrationControlResponse`]. Affects
    /// [`filter_data::MultiAntennaOffsetCorrection`](crate::filter_data::MultiAntennaOffsetCorrection).
    /// Probably affects
    /// [`filter_data::MultiAntennaOffsetCorrectionUncertainty`](crate::filter_data::MultiAntennaOffsetCorrectionUncertainty).
    /// Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7). Requires a receiver.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64);
    /// 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration.
    #[derive(Copy)]
    pub struct GnssAntennaCalibrationControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
        /// Largest absolute error that is tracked.
        ///
        /// Unit: m. Frame: vehicle. Range: at least 0. Required for
        /// [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): range 0 to 0.5; default 0.1.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub max_offset: Option<f32>,
    }
    wire 6 {
        [function selects]
        [enable for WRITE]
        [max_offset for WRITE]
    }
}

ranges! {
    GnssAntennaCalibrationControl
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    GnssAntennaCalibrationControl

    /// Apply the new setting.
    fn write(enable: u8, max_offset: f32) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    GnssAntennaCalibrationControl: 0x64, "filter.gnss_antenna_calibration_control";
    in [0x0D];
}

command! {
    GnssAntennaCalibrationControl -> Option<GnssAntennaCalibrationControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GnssAntennaCalibrationControlResponse;
    responds GnssAntennaCalibrationControlResponse for READ;
    checks Ranged;
}

change! {
    GnssAntennaCalibrationControlResponse -> WriteCall GnssAntennaCalibrationControl
    [enable max_offset]
}

record! {
    /// Vehicle dynamics mode response (0x0D,0x80).
    ///
    /// Response to [`VehicleDynamicsMode`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 6 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Vehicle dynamics mode (0x0D,0x10).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct VehicleDynamicsModeResponse {
        /// Kind of vehicle.
        pub mode: DynamicsMode,
    }
}

view! {
    VehicleDynamicsModeResponse
    mode: DynamicsMode, at 0;
}

constructors! {
    VehicleDynamicsModeResponse

    /// Creates it from its values.
    fn new(mode: DynamicsMode);
}

field! {
    VehicleDynamicsModeResponse: 0x80, "filter.vehicle_dynamics_mode_response";
    in [0x0D];
    answers VehicleDynamicsMode;
}

record! {
    /// Sensor to vehicle frame transformation response (0x0D,0x81).
    ///
    /// Response to [`SensorToVehicleRotationEuler`]. Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 12 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleRotationEulerResponse {
        /// Roll angle of the vehicle relative to the sensor.
        ///
        /// Unit: rad. Frame: sensor. Positive: right side down.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub roll: f32,
        /// Pitch angle of the vehicle relative to the sensor.
        ///
        /// Unit: rad. Frame: sensor. Positive: nose up.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch: f32,
        /// Yaw angle of the vehicle relative to the sensor.
        ///
        /// Unit: rad. Frame: sensor. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub yaw: f32,
    }
}

view! {
    SensorToVehicleRotationEulerResponse
    roll: f32, at 0;
    pitch: f32, at 4;
    yaw: f32, at 8;
}

constructors! {
    SensorToVehicleRotationEulerResponse

    /// Creates it from its values.
    fn new(
        roll: f32,
        pitch: f32,
        yaw: f32,
    );
}

field! {
    SensorToVehicleRotationEulerResponse: 0x81, "filter.sensor_to_vehicle_rotation_euler_response";
    in [0x0D];
    answers SensorToVehicleRotationEuler;
}

record! {
    /// Sensor to vehicle offset response (0x0D,0x82).
    ///
    /// Response to [`SensorToVehicleOffset`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 6 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Sensor to vehicle offset (0x0D,0x12).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleOffsetResponse {
        /// Vector from the sensor to the origin of the vehicle frame.
        ///
        /// Elements: x, y, z. Unit: m. Frame: sensor. Range: magnitude at most 10.
        pub offset: types::Vector3f,
    }
}

view! {
    SensorToVehicleOffsetResponse
    offset: types::Vector3f, at 0;
}

constructors! {
    SensorToVehicleOffsetResponse

    /// Creates it from its values.
    fn new(offset: impl Into<types::Vector3f>);
}

field! {
    SensorToVehicleOffsetResponse: 0x82, "filter.sensor_to_vehicle_offset_response";
    in [0x0D];
    answers SensorToVehicleOffset;
}

record! {
    /// GNSS antenna offset response (0x0D,0x83).
    ///
    /// Response to [`AntennaOffset`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13).
    #[derive(Copy, Default)]
    pub struct AntennaOffsetResponse {
        /// Vector from the sensor origin to the phase centre of the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10. On the
        /// [3DM-CX5-45](crate::devices::CX5_45): frame sensor (inferred: the manual of the
        /// 3DM-GX5-45 states it). On the [3DM-GX5-45](crate::devices::GX5_45): frame sensor.
        pub offset: types::Vector3f,
    }
}

view! {
    AntennaOffsetResponse
    offset: types::Vector3f, at 0;
}

constructors! {
    AntennaOffsetResponse

    /// Creates it from its values.
    fn new(offset: impl Into<types::Vector3f>);
}

field! {
    AntennaOffsetResponse: 0x83, "filter.antenna_offset_response";
    in [0x0D];
    answers AntennaOffset;
}

record! {
    /// Estimation control flags response (0x0D,0x84).
    ///
    /// Response to [`EstimationControl`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 13 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EstimationControlResponse {
        /// States to estimate.
        pub flags: EstimatedStates,
    }
}

view! {
    EstimationControlResponse
    flags: EstimatedStates, at 0;
}

constructors! {
    EstimationControlResponse

    /// Creates it from its values.
    fn new(flags: EstimatedStates);
}

field! {
    EstimationControlResponse: 0x84, "filter.estimation_control_response";
    in [0x0D];
    answers EstimationControl;
}

record! {
    /// GNSS aiding source response (0x0D,0x86).
    ///
    /// Response to [`GnssSource`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 9 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GnssSourceResponse {
        /// Source of the GNSS data.
        pub source: GnssAidingSource,
    }
}

view! {
    GnssSourceResponse
    source: GnssAidingSource, at 0;
}

constructors! {
    GnssSourceResponse

    /// Creates it from its values.
    fn new(source: GnssAidingSource);
}

field! {
    GnssSourceResponse: 0x86, "filter.gnss_source_response";
    in [0x0D];
    answers GnssSource;
}

record! {
    /// Heading update control response (0x0D,0x87).
    ///
    /// Response to [`HeadingSource`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 12 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct HeadingSourceResponse {
        /// Source of the heading.
        pub source: HeadingUpdateSource,
    }
}

view! {
    HeadingSourceResponse
    source: HeadingUpdateSource, at 0;
}

constructors! {
    HeadingSourceResponse

    /// Creates it from its values.
    fn new(source: HeadingUpdateSource);
}

field! {
    HeadingSourceResponse: 0x87, "filter.heading_source_response";
    in [0x0D];
    answers HeadingSource;
}

record! {
    /// Automatic initialization response (0x0D,0x88).
    ///
    /// Also called `auto_init_control_response`. Response to [`AutoInitializationControl`].
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 13 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct AutoInitializationControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
    }
}

view! {
    AutoInitializationControlResponse
    enable: u8, at 0;
}

constructors! {
    AutoInitializationControlResponse

    /// Creates it from its values.
    fn new(enable: u8);
}

field! {
    AutoInitializationControlResponse: 0x88, "filter.auto_initialization_control_response";
    in [0x0D];
    answers AutoInitializationControl;
}

record! {
    /// Accelerometer noise response (0x0D,0x89).
    ///
    /// Response to [`AccelNoise`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 23 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A); 3dm-gx5-15:
    /// 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A).
    #[derive(Copy, Default)]
    pub struct AccelNoiseResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    AccelNoiseResponse
    noise: types::Vector3f, at 0;
}

constructors! {
    AccelNoiseResponse

    /// Creates it from its values.
    fn new(noise: impl Into<types::Vector3f>);
}

field! {
    AccelNoiseResponse: 0x89, "filter.accel_noise_response";
    in [0x0D];
    answers AccelNoise;
}

record! {
    /// Gyroscope noise response (0x0D,0x8A).
    ///
    /// Response to [`GyroNoise`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 23 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B); 3dm-gx5-15: 4.3.13
    /// Gyroscope Noise Standard Deviation (0x0D, 0x1B).
    #[derive(Copy, Default)]
    pub struct GyroNoiseResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    GyroNoiseResponse
    noise: types::Vector3f, at 0;
}

constructors! {
    GyroNoiseResponse

    /// Creates it from its values.
    fn new(noise: impl Into<types::Vector3f>);
}

field! {
    GyroNoiseResponse: 0x8A, "filter.gyro_noise_response";
    in [0x0D];
    answers GyroNoise;
}

record! {
    /// Accelerometer bias model response (0x0D,0x8B).
    ///
    /// Response to [`AccelBiasModel`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 9 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C).
    #[derive(Copy, Default)]
    pub struct AccelBiasModelResponse {
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s.
        pub beta: types::Vector3f,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    AccelBiasModelResponse
    beta: types::Vector3f, at 0;
    noise: types::Vector3f, at 12;
}

constructors! {
    AccelBiasModelResponse

    /// Creates it from its values.
    fn new(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>);
}

field! {
    AccelBiasModelResponse: 0x8B, "filter.accel_bias_model_response";
    in [0x0D];
    answers AccelBiasModel;
}

record! {
    /// Gyroscope bias model response (0x0D,0x8C).
    ///
    /// Response to [`GyroBiasModel`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 23 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D); 3dm-gx5-15: 4.3.14
    /// Gyroscope Bias Model Parameters (0x0D, 0x1D).
    #[derive(Copy, Default)]
    pub struct GyroBiasModelResponse {
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s.
        pub beta: types::Vector3f,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    GyroBiasModelResponse
    beta: types::Vector3f, at 0;
    noise: types::Vector3f, at 12;
}

constructors! {
    GyroBiasModelResponse

    /// Creates it from its values.
    fn new(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>);
}

field! {
    GyroBiasModelResponse: 0x8C, "filter.gyro_bias_model_response";
    in [0x0D];
    answers GyroBiasModel;
}

record! {
    /// Automatic zero velocity update response (0x0D,0x8D).
    ///
    /// Response to [`AutoZupt`]. Confirmed on [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 6 more. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Auto Zupt (0x0D,0x1E).
    #[derive(Copy, Default)]
    pub struct AutoZuptResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Highest speed that is treated as zero.
        ///
        /// Unit: m/s. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub threshold: f32,
    }
}

view! {
    AutoZuptResponse
    enable: u8, at 0;
    threshold: f32, at 1;
}

constructors! {
    AutoZuptResponse

    /// Creates it from its values.
    fn new(enable: u8, threshold: f32);
}

field! {
    AutoZuptResponse: 0x8D, "filter.auto_zupt_response";
    in [0x0D];
    answers AutoZupt;
}

record! {
    /// Zero angular rate update response (0x0D,0x8E).
    ///
    /// Response to [`AutoAngularZupt`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS),
    /// [3DM-CX5-25](crate::devices::CX5_25), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 19 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20); 3dm-gx5-15: 4.3.15
    /// Zero Angular Rate Update Control (0x0D, 0x20).
    #[derive(Copy, Default)]
    pub struct AutoAngularZuptResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Highest angular rate that is treated as zero.
        ///
        /// Unit: rad/s. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub threshold: f32,
    }
}

view! {
    AutoAngularZuptResponse
    enable: u8, at 0;
    threshold: f32, at 1;
}

constructors! {
    AutoAngularZuptResponse

    /// Creates it from its values.
    fn new(enable: u8, threshold: f32);
}

field! {
    AutoAngularZuptResponse: 0x8E, "filter.auto_angular_zupt_response";
    in [0x0D];
    answers AutoAngularZupt;
}

record! {
    /// Set reference position response (0x0D,0x90).
    ///
    /// Response to [`ReferencePosition`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15); likely
    /// or assumed on 8 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26).
    #[derive(Copy, Default)]
    pub struct ReferencePositionResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Geodetic latitude.
        ///
        /// Unit: deg. Frame: llh. Range: -90 to 90. Positive: north.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub latitude: f64,
        /// Geodetic longitude.
        ///
        /// Unit: deg. Frame: llh. Range: -180 to 180. Positive: east.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub longitude: f64,
        /// Altitude of the reference position.
        ///
        /// Unit: m. Uncertain: The reference, ellipsoid or sea level, is inferred. The manual does
        /// not state it; its glossary counts altitudes from sea level.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub altitude: f64,
    }
}

view! {
    ReferencePositionResponse
    enable: u8, at 0;
    latitude: f64, at 1;
    longitude: f64, at 9;
    altitude: f64, at 17;
}

constructors! {
    ReferencePositionResponse

    /// Creates it from its values.
    fn new(
        enable: u8,
        latitude: f64,
        longitude: f64,
        altitude: f64,
    );
}

field! {
    ReferencePositionResponse: 0x90, "filter.reference_position_response";
    in [0x0D];
    answers ReferencePosition;
}

record! {
    /// Gravity noise response (0x0D,0x93).
    ///
    /// Response to [`GravityNoise`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 16 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28); 3dm-gx5-15: 4.3.11
    /// Gravity Noise Standard Deviation (0x0D, 0x28).
    #[derive(Copy, Default)]
    pub struct GravityNoiseResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: g. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    GravityNoiseResponse
    noise: types::Vector3f, at 0;
}

constructors! {
    GravityNoiseResponse

    /// Creates it from its values.
    fn new(noise: impl Into<types::Vector3f>);
}

field! {
    GravityNoiseResponse: 0x93, "filter.gravity_noise_response";
    in [0x0D];
    answers GravityNoise;
}

record! {
    /// Pressure altitude noise response (0x0D,0x94).
    ///
    /// Response to [`PressureAltitudeNoise`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 4 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Pressure altitude noise (0x0D,0x29).
    #[derive(Copy, Default)]
    pub struct PressureAltitudeNoiseResponse {
        /// Standard deviation of the pressure altitude noise.
        ///
        /// Unit: m. Range: greater than 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub noise: f32,
    }
}

view! {
    PressureAltitudeNoiseResponse
    noise: f32, at 0;
}

constructors! {
    PressureAltitudeNoiseResponse

    /// Creates it from its values.
    fn new(noise: f32);
}

field! {
    PressureAltitudeNoiseResponse: 0x94, "filter.pressure_altitude_noise_response";
    in [0x0D];
    answers PressureAltitudeNoise;
}

record! {
    /// Hard iron offset noise response (0x0D,0x96).
    ///
    /// Response to [`HardIronOffsetNoise`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 4 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Hard iron offset noise (0x0D,0x2B).
    #[derive(Copy, Default)]
    pub struct HardIronOffsetNoiseResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: gauss. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    HardIronOffsetNoiseResponse
    noise: types::Vector3f, at 0;
}

constructors! {
    HardIronOffsetNoiseResponse

    /// Creates it from its values.
    fn new(noise: impl Into<types::Vector3f>);
}

field! {
    HardIronOffsetNoiseResponse: 0x96, "filter.hard_iron_offset_noise_response";
    in [0x0D];
    answers HardIronOffsetNoise;
}

record! {
    /// Soft iron matrix noise response (0x0D,0x97).
    ///
    /// Response to [`SoftIronMatrixNoise`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 4 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Soft iron matrix noise (0x0D,0x2C).
    #[derive(Copy, Default)]
    pub struct SoftIronMatrixNoiseResponse {
        /// Standard deviation per element.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Range: greater than 0.
        pub noise: types::Matrix3f,
    }
}

view! {
    SoftIronMatrixNoiseResponse
    noise: types::Matrix3f, at 0;
}

constructors! {
    SoftIronMatrixNoiseResponse

    /// Creates it from its values.
    fn new(noise: impl Into<types::Matrix3f>);
}

field! {
    SoftIronMatrixNoiseResponse: 0x97, "filter.soft_iron_matrix_noise_response";
    in [0x0D];
    answers SoftIronMatrixNoise;
}

record! {
    /// Tare orientation response (0x0D,0xA1).
    ///
    /// Response to [`TareOrientation`]. Confirmed on [3DM-CX5-25](crate::devices::CX5_25); likely
    /// or assumed on 11 more. Uncertain: The SDK reads the setting back; the manuals of the
    /// 3DM-GX5-15 and 3DM-GX5-45 have neither the read function nor the response.
    ///
    /// Source: 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21); mip-sdk-4: Tare orientation
    /// (0x0D,0x21).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct TareOrientationResponse {
        /// Axes that are tared.
        pub axes: TareAxes,
    }
}

view! {
    TareOrientationResponse
    axes: TareAxes, at 0;
}

constructors! {
    TareOrientationResponse

    /// Creates it from its values.
    fn new(axes: TareAxes);
}

field! {
    TareOrientationResponse: 0xA1, "filter.tare_orientation_response";
    in [0x0D];
    answers TareOrientation;
}

record! {
    /// Enable or disable measurements response (0x0D,0xB0).
    ///
    /// Response to [`EnableMeasurements`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15);
    /// likely or assumed on 6 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EnableMeasurementsResponse {
        /// Measurements to use.
        pub control: MeasurementFlags,
    }
}

view! {
    EnableMeasurementsResponse
    control: MeasurementFlags, at 0;
}

constructors! {
    EnableMeasurementsResponse

    /// Creates it from its values.
    fn new(control: MeasurementFlags);
}

field! {
    EnableMeasurementsResponse: 0xB0, "filter.enable_measurements_response";
    in [0x0D];
    answers EnableMeasurements;
}

record! {
    /// Magnetometer noise response (0x0D,0xB1).
    ///
    /// Response to [`MagNoise`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 9 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Mag Noise (0x0D,0x42).
    #[derive(Copy, Default)]
    pub struct MagNoiseResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: gauss. Range: greater than 0.
        pub noise: types::Vector3f,
    }
}

view! {
    MagNoiseResponse
    noise: types::Vector3f, at 0;
}

constructors! {
    MagNoiseResponse

    /// Creates it from its values.
    fn new(noise: impl Into<types::Vector3f>);
}

field! {
    MagNoiseResponse: 0xB1, "filter.mag_noise_response";
    in [0x0D];
    answers MagNoise;
}

record! {
    /// Magnetic declination source response (0x0D,0xB2).
    ///
    /// Response to [`MagneticDeclinationSource`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 14 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43); 3dm-gq7:
    /// Magnetic Field Declination Source Control (0x0D,0x43).
    #[derive(Copy, Default)]
    pub struct MagneticDeclinationSourceResponse {
        /// Source of the declination.
        pub source: MagParameterSource,
        /// Angle from true north to magnetic north; used only if `source` is manual.
        ///
        /// Unit: rad. Frame: ned. Range: -pi to pi. Positive: magnetic north is east of true north.
        /// Uncertain: The sign is the usual one; no source states it. Uncertain: The manuals, that
        /// of the 3DM-GQ7 included, require it only if `source` is manual, but state one length,
        /// with the value. Always send it.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub declination: f32,
    }
}

view! {
    MagneticDeclinationSourceResponse
    source: MagParameterSource, at 0;
    declination: f32, at 1;
}

constructors! {
    MagneticDeclinationSourceResponse

    /// Creates it from its values.
    fn new(source: MagParameterSource, declination: f32);
}

field! {
    MagneticDeclinationSourceResponse: 0xB2, "filter.magnetic_declination_source_response";
    in [0x0D];
    answers MagneticDeclinationSource;
}

record! {
    /// Gravity magnitude error adaptive measurement response (0x0D,0xB3).
    ///
    /// Response to [`AccelMagnitudeErrorAdaptiveMeasurement`]. Confirmed on
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 13 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44).
    #[derive(Copy, Default)]
    pub struct AccelMagnitudeErrorAdaptiveMeasurementResponse {
        /// Kind of adaptation.
        pub adaptive_measurement: AdaptiveMeasurementSelector,
        /// Cutoff frequency of the low-pass filter.
        ///
        /// Unit: Hz. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub frequency: f32,
        /// Lower limit of the gravity magnitude error.
        ///
        /// Unit: m/s^2.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub low_limit: f32,
        /// Upper limit of the gravity magnitude error.
        ///
        /// Unit: m/s^2.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_limit: f32,
        /// Standard deviation at the lower limit.
        ///
        /// Unit: m/s^2. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub low_limit_uncertainty: f32,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: m/s^2. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_limit_uncertainty: f32,
        /// Smallest standard deviation.
        ///
        /// Unit: m/s^2. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub minimum_uncertainty: f32,
    }
}

view! {
    AccelMagnitudeErrorAdaptiveMeasurementResponse
    adaptive_measurement: AdaptiveMeasurementSelector, at 0;
    frequency: f32, at 1;
    low_limit: f32, at 5;
    high_limit: f32, at 9;
    low_limit_uncertainty: f32, at 13;
    high_limit_uncertainty: f32, at 17;
    minimum_uncertainty: f32, at 21;
}

constructors! {
    AccelMagnitudeErrorAdaptiveMeasurementResponse

    /// Creates it from its values.
    fn new(
        adaptive_measurement: AdaptiveMeasurementSelector,
        frequency: f32,
        low_limit: f32,
        high_limit: f32,
        low_limit_uncertainty: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    );
}

field! {
    AccelMagnitudeErrorAdaptiveMeasurementResponse: 0xB3, "filter.accel_magnitude_error_adaptive_measurement_response";
    in [0x0D];
    answers AccelMagnitudeErrorAdaptiveMeasurement;
}

record! {
    /// Magnetometer magnitude error adaptive measurement response (0x0D,0xB4).
    ///
    /// Response to [`MagMagnitudeErrorAdaptiveMeasurement`]. Confirmed on
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 10 more. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45).
    #[derive(Copy, Default)]
    pub struct MagMagnitudeErrorAdaptiveMeasurementResponse {
        /// Kind of adaptation.
        pub adaptive_measurement: AdaptiveMeasurementSelector,
        /// Cutoff frequency of the low-pass filter.
        ///
        /// Unit: Hz. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub frequency: f32,
        /// Lower limit of the magnetic field magnitude error.
        ///
        /// Unit: gauss. Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of
        /// the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub low_limit: f32,
        /// Upper limit of the magnetic field magnitude error.
        ///
        /// Unit: gauss. Uncertain: The unit gauss is inferred: the SDK states m/s^2, the manual of
        /// the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_limit: f32,
        /// Standard deviation at the lower limit.
        ///
        /// Unit: gauss. Range: at least 0. Uncertain: The unit gauss is inferred: the SDK states
        /// m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub low_limit_uncertainty: f32,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: gauss. Range: at least 0. Uncertain: The unit gauss is inferred: the SDK states
        /// m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_limit_uncertainty: f32,
        /// Smallest standard deviation.
        ///
        /// Unit: gauss. Range: at least 0. Uncertain: The unit gauss is inferred: the SDK states
        /// m/s^2, the manual of the 3DM-GX5-45 m/s^2 in the command and gauss in the response.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub minimum_uncertainty: f32,
    }
}

view! {
    MagMagnitudeErrorAdaptiveMeasurementResponse
    adaptive_measurement: AdaptiveMeasurementSelector, at 0;
    frequency: f32, at 1;
    low_limit: f32, at 5;
    high_limit: f32, at 9;
    low_limit_uncertainty: f32, at 13;
    high_limit_uncertainty: f32, at 17;
    minimum_uncertainty: f32, at 21;
}

constructors! {
    MagMagnitudeErrorAdaptiveMeasurementResponse

    /// Creates it from its values.
    fn new(
        adaptive_measurement: AdaptiveMeasurementSelector,
        frequency: f32,
        low_limit: f32,
        high_limit: f32,
        low_limit_uncertainty: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    );
}

field! {
    MagMagnitudeErrorAdaptiveMeasurementResponse: 0xB4, "filter.mag_magnitude_error_adaptive_measurement_response";
    in [0x0D];
    answers MagMagnitudeErrorAdaptiveMeasurement;
}

record! {
    /// Magnetometer dip angle error adaptive measurement response (0x0D,0xB5).
    ///
    /// Response to [`MagDipAngleErrorAdaptiveMeasurement`]. Confirmed on
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 9 more. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46).
    #[derive(Copy, Default)]
    pub struct MagDipAngleErrorAdaptiveMeasurementResponse {
        /// True if the adaptation is on.
        pub enable: crate::Bool,
        /// Cutoff frequency of the low-pass filter.
        ///
        /// Unit: Hz. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub frequency: f32,
        /// Upper limit of the dip angle error.
        ///
        /// Unit: rad. Range: at least 0. Uncertain: The unit rad is inferred from the quantity; the
        /// SDK states m/s^2.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_limit: f32,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: rad. Range: at least 0. Uncertain: The unit rad is inferred from the quantity; the
        /// SDK states m/s^2.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub high_limit_uncertainty: f32,
        /// Smallest standard deviation.
        ///
        /// Unit: rad. Range: at least 0. Uncertain: The unit rad is inferred from the quantity; the
        /// SDK states m/s^2.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub minimum_uncertainty: f32,
    }
}

view! {
    MagDipAngleErrorAdaptiveMeasurementResponse
    enable: crate::Bool, at 0;
    frequency: f32, at 1;
    high_limit: f32, at 5;
    high_limit_uncertainty: f32, at 9;
    minimum_uncertainty: f32, at 13;
}

constructors! {
    MagDipAngleErrorAdaptiveMeasurementResponse

    /// Creates it from its values.
    fn new(
        enable: bool,
        frequency: f32,
        high_limit: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    );
}

field! {
    MagDipAngleErrorAdaptiveMeasurementResponse: 0xB5, "filter.mag_dip_angle_error_adaptive_measurement_response";
    in [0x0D];
    answers MagDipAngleErrorAdaptiveMeasurement;
}

record! {
    /// Altitude aiding response (0x0D,0xB7).
    ///
    /// Response to [`AltitudeAiding`]. Confirmed on [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 4 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Altitude aiding (0x0D,0x47).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct AltitudeAidingResponse {
        /// Source of the aiding.
        pub selector: AltitudeAidingSource,
    }
}

view! {
    AltitudeAidingResponse
    selector: AltitudeAidingSource, at 0;
}

constructors! {
    AltitudeAidingResponse

    /// Creates it from its values.
    fn new(selector: AltitudeAidingSource);
}

field! {
    AltitudeAidingResponse: 0xB7, "filter.altitude_aiding_response";
    in [0x0D];
    answers AltitudeAiding;
}

record! {
    /// Pitch and roll aiding response (0x0D,0xBB).
    ///
    /// Response to [`PitchRollAiding`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 6 more.
    ///
    /// Source: 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct PitchRollAidingResponse {
        /// Source of the aiding.
        pub aiding: PitchRollAidingSource,
    }
}

view! {
    PitchRollAidingResponse
    aiding: PitchRollAidingSource, at 0;
}

constructors! {
    PitchRollAidingResponse

    /// Creates it from its values.
    fn new(aiding: PitchRollAidingSource);
}

field! {
    PitchRollAidingResponse: 0xBB, "filter.pitch_roll_aiding_response";
    in [0x0D];
    answers PitchRollAiding;
}

record! {
    /// Magnetic inclination source response (0x0D,0xBC).
    ///
    /// Also called `inclination_source_response`. Response to [`MagneticInclinationSource`]. Known
    /// only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Inclination Source (0x0D,0x4C).
    #[derive(Copy, Default)]
    pub struct MagneticInclinationSourceResponse {
        /// Source of the inclination.
        pub source: MagParameterSource,
        /// Angle of the field below the horizontal plane; used only if `source` is manual.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966. Positive: the
        /// field points down. Uncertain: The sign is the usual one; no source states it. Uncertain:
        /// It can possibly be omitted if `source` is not manual, as with
        /// [`MagneticDeclinationSource`]. The SDK always sends it.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination: f32,
    }
}

view! {
    MagneticInclinationSourceResponse
    source: MagParameterSource, at 0;
    inclination: f32, at 1;
}

constructors! {
    MagneticInclinationSourceResponse

    /// Creates it from its values.
    fn new(source: MagParameterSource, inclination: f32);
}

field! {
    MagneticInclinationSourceResponse: 0xBC, "filter.magnetic_inclination_source_response";
    in [0x0D];
    answers MagneticInclinationSource;
}

record! {
    /// Magnetic field magnitude source response (0x0D,0xBD).
    ///
    /// Also called `mag_field_magnitude_source_response`. Response to [`MagneticMagnitudeSource`].
    /// Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D).
    #[derive(Copy, Default)]
    pub struct MagneticMagnitudeSourceResponse {
        /// Source of the magnitude.
        pub source: MagParameterSource,
        /// Magnitude; used only if `source` is manual.
        ///
        /// Unit: gauss. Range: at least 0. Uncertain: It can possibly be omitted if `source` is not
        /// manual, as with [`MagneticDeclinationSource`]. The SDK always sends it.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub magnitude: f32,
    }
}

view! {
    MagneticMagnitudeSourceResponse
    source: MagParameterSource, at 0;
    magnitude: f32, at 1;
}

constructors! {
    MagneticMagnitudeSourceResponse

    /// Creates it from its values.
    fn new(source: MagParameterSource, magnitude: f32);
}

field! {
    MagneticMagnitudeSourceResponse: 0xBD, "filter.magnetic_magnitude_source_response";
    in [0x0D];
    answers MagneticMagnitudeSource;
}

record! {
    /// Sensor to vehicle rotation, matrix response (0x0D,0xBE).
    ///
    /// Response to [`SensorToVehicleRotationDcm`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleRotationDcmResponse {
        /// Rotates vectors of the vehicle frame into the sensor frame; row-major.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1.
        pub dcm: types::Matrix3f,
    }
}

view! {
    SensorToVehicleRotationDcmResponse
    dcm: types::Matrix3f, at 0;
}

constructors! {
    SensorToVehicleRotationDcmResponse

    /// Creates it from its values.
    fn new(dcm: impl Into<types::Matrix3f>);
}

field! {
    SensorToVehicleRotationDcmResponse: 0xBE, "filter.sensor_to_vehicle_rotation_dcm_response";
    in [0x0D];
    answers SensorToVehicleRotationDcm;
}

record! {
    /// Sensor to vehicle rotation, quaternion response (0x0D,0xBF).
    ///
    /// Response to [`SensorToVehicleRotationQuaternion`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleRotationQuaternionResponse {
        /// Rotates vectors of the sensor frame into the vehicle frame; unit quaternion, w first.
        ///
        /// Elements: w, x, y, z. Unit: 1. Range: magnitude 0.999 to 1.001.
        pub q: types::Quatf,
    }
}

view! {
    SensorToVehicleRotationQuaternionResponse
    q: types::Quatf, at 0;
}

constructors! {
    SensorToVehicleRotationQuaternionResponse

    /// Creates it from its values.
    fn new(q: impl Into<types::Quatf>);
}

field! {
    SensorToVehicleRotationQuaternionResponse: 0xBF, "filter.sensor_to_vehicle_rotation_quaternion_response";
    in [0x0D];
    answers SensorToVehicleRotationQuaternion;
}

record! {
    /// Aiding measurement control response (0x0D,0xD0).
    ///
    /// Response to [`AidingMeasurementEnable`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct AidingMeasurementEnableResponse {
        /// Aiding source that the setting is for.
        pub aiding_source: AidingSource,
        /// True if the filter uses the source.
        pub enable: crate::Bool,
    }
}

view! {
    AidingMeasurementEnableResponse
    aiding_source: AidingSource, at 0;
    enable: crate::Bool, at 2;
}

constructors! {
    AidingMeasurementEnableResponse

    /// Creates it from its values.
    fn new(aiding_source: AidingSource, enable: bool);
}

field! {
    AidingMeasurementEnableResponse: 0xD0, "filter.aiding_measurement_enable_response";
    in [0x0D];
    answers AidingMeasurementEnable;
}

record! {
    /// Kinematic constraint response (0x0D,0xD1).
    ///
    /// Response to [`KinematicConstraint`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Kinematic constraint (0x0D,0x51).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct KinematicConstraintResponse {
        /// Assumption about the acceleration.
        ///
        /// Default: [`AccelConstraint::NONE`].
        pub accel_constraint: AccelConstraint,
        /// Assumption about the velocity.
        ///
        /// Default: [`VelocityConstraint::NONE`].
        pub velocity_constraint: VelocityConstraint,
        /// Assumption about the angular rate.
        ///
        /// Default: [`AngularConstraint::NONE`].
        pub angular_constraint: AngularConstraint,
    }
}

view! {
    KinematicConstraintResponse
    accel_constraint: AccelConstraint, at 0;
    velocity_constraint: VelocityConstraint, at 1;
    angular_constraint: AngularConstraint, at 2;
}

constructors! {
    KinematicConstraintResponse

    /// Creates it from its values.
    fn new(
        accel_constraint: AccelConstraint,
        velocity_constraint: VelocityConstraint,
        angular_constraint: AngularConstraint,
    );
}

field! {
    KinematicConstraintResponse: 0xD1, "filter.kinematic_constraint_response";
    in [0x0D];
    answers KinematicConstraint;
}

record! {
    /// Navigation filter initialization response (0x0D,0xD2).
    ///
    /// Also called `initialization_configuration_response`. Response to [`InitializationConfig`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely
    /// or assumed on 2 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52).
    #[derive(Copy, Default)]
    pub struct InitializationConfigResponse {
        /// 1: the filter starts only after [`Run`]; 0: it starts as soon as it can.
        ///
        /// Range: 0 to 1.
        pub wait_for_run_command: u8,
        /// Initial conditions that your program provides instead of the device.
        pub initial_condition_source: InitialConditionSource,
        /// Methods that may be used to determine the initial heading.
        pub auto_heading_alignment_selector: HeadingAlignment,
        /// Initial heading relative to true north.
        ///
        /// Unit: deg. Frame: ned. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub initial_heading: f32,
        /// Initial pitch angle.
        ///
        /// Unit: deg. Frame: ned. Positive: nose up.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub initial_pitch: f32,
        /// Initial roll angle.
        ///
        /// Unit: deg. Frame: ned. Positive: right side down.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub initial_roll: f32,
        /// Initial position that your program provides.
        ///
        /// Elements: x, y, z. If
        /// [`reference_frame_selector`](InitializationConfigResponse::reference_frame_selector) is
        /// [`ReferenceFrame::ECEF`]: unit m; frame ecef. If
        /// [`reference_frame_selector`](InitializationConfigResponse::reference_frame_selector) is
        /// [`ReferenceFrame::LLH`]: elements latitude, longitude, height; unit deg, deg, m; frame
        /// llh.
        pub initial_position: types::Vector3f,
        /// Initial velocity that your program provides.
        ///
        /// Elements: x, y, z. Unit: m/s. If
        /// [`reference_frame_selector`](InitializationConfigResponse::reference_frame_selector) is
        /// [`ReferenceFrame::ECEF`]: frame ecef. If
        /// [`reference_frame_selector`](InitializationConfigResponse::reference_frame_selector) is
        /// [`ReferenceFrame::LLH`]: elements north, east, down; frame ned.
        pub initial_velocity: types::Vector3f,
        /// Frame of the initial position and velocity.
        pub reference_frame_selector: ReferenceFrame,
    }
}

view! {
    InitializationConfigResponse
    wait_for_run_command: u8, at 0;
    initial_condition_source: InitialConditionSource, at 1;
    auto_heading_alignment_selector: HeadingAlignment, at 2;
    initial_heading: f32, at 3;
    initial_pitch: f32, at 7;
    initial_roll: f32, at 11;
    initial_position: types::Vector3f, at 15;
    initial_velocity: types::Vector3f, at 27;
    reference_frame_selector: ReferenceFrame, at 39;
}

constructors! {
    InitializationConfigResponse

    /// Creates it from its values.
    fn new(
        wait_for_run_command: u8,
        initial_condition_source: InitialConditionSource,
        auto_heading_alignment_selector: HeadingAlignment,
        initial_heading: f32,
        initial_pitch: f32,
        initial_roll: f32,
        initial_position: impl Into<types::Vector3f>,
        initial_velocity: impl Into<types::Vector3f>,
        reference_frame_selector: ReferenceFrame,
    );
}

field! {
    InitializationConfigResponse: 0xD2, "filter.initialization_config_response";
    in [0x0D];
    answers InitializationConfig;
}

record! {
    /// Adaptive filter control response (0x0D,0xD3).
    ///
    /// Response to [`AdaptiveFilterOptions`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 12 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct AdaptiveFilterOptionsResponse {
        /// Strength of the adaptation.
        ///
        /// Default: 2.
        pub level: AdaptiveLevel,
        /// Longest time for which measurements are rejected before the filter recovers.
        ///
        /// Unit: ms.
        pub time_limit: u16,
    }
}

view! {
    AdaptiveFilterOptionsResponse
    level: AdaptiveLevel, at 0;
    time_limit: u16, at 1;
}

constructors! {
    AdaptiveFilterOptionsResponse

    /// Creates it from its values.
    fn new(level: AdaptiveLevel, time_limit: u16);
}

field! {
    AdaptiveFilterOptionsResponse: 0xD3, "filter.adaptive_filter_options_response";
    in [0x0D];
    answers AdaptiveFilterOptions;
}

record! {
    /// GNSS multi-antenna offset response (0x0D,0xD4).
    ///
    /// Response to [`MultiAntennaOffset`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54).
    #[derive(Copy, Default)]
    pub struct MultiAntennaOffsetResponse {
        /// Number of the receiver, from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: u8,
        /// Lever arm from the sensor to the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10.
        pub antenna_offset: types::Vector3f,
    }
}

view! {
    MultiAntennaOffsetResponse
    receiver_id: u8, at 0;
    antenna_offset: types::Vector3f, at 1;
}

constructors! {
    MultiAntennaOffsetResponse

    /// Creates it from its values.
    fn new(receiver_id: u8, antenna_offset: impl Into<types::Vector3f>);
}

field! {
    MultiAntennaOffsetResponse: 0xD4, "filter.multi_antenna_offset_response";
    in [0x0D];
    answers MultiAntennaOffset;
}

record! {
    /// Relative position configuration response (0x0D,0xD5).
    ///
    /// Also called `rel_pos_configuration_response`. Response to [`RelativePositionConfig`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 4 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55).
    #[derive(Copy, Default)]
    pub struct RelativePositionConfigResponse {
        /// Source of the reference point.
        pub source: RelativePositionSource,
        /// Frame of the coordinates.
        pub reference_frame_selector: ReferenceFrame,
        /// Reference point.
        ///
        /// Elements: x, y, z. If
        /// [`reference_frame_selector`](RelativePositionConfigResponse::reference_frame_selector)
        /// is [`ReferenceFrame::ECEF`]: unit m; frame ecef. If
        /// [`reference_frame_selector`](RelativePositionConfigResponse::reference_frame_selector)
        /// is [`ReferenceFrame::LLH`]: elements latitude, longitude, height; unit deg, deg, m;
        /// frame llh.
        pub reference_coordinates: types::Vector3d,
    }
}

view! {
    RelativePositionConfigResponse
    source: RelativePositionSource, at 0;
    reference_frame_selector: ReferenceFrame, at 1;
    reference_coordinates: types::Vector3d, at 2;
}

constructors! {
    RelativePositionConfigResponse

    /// Creates it from its values.
    fn new(
        source: RelativePositionSource,
        reference_frame_selector: ReferenceFrame,
        reference_coordinates: impl Into<types::Vector3d>,
    );
}

field! {
    RelativePositionConfigResponse: 0xD5, "filter.relative_position_config_response";
    in [0x0D];
    answers RelativePositionConfig;
}

record! {
    /// Reference point lever arm response (0x0D,0xD6).
    ///
    /// Also called `ref_point_lever_arm_response`. Response to [`ReferencePointLeverArm`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 4 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56).
    #[derive(Copy, Default)]
    pub struct ReferencePointLeverArmResponse {
        /// Point to which the lever arm leads.
        pub reference_point: ReferencePoint,
        /// Lever arm from the sensor to the point.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: magnitude at most 10.
        pub lever_arm_offset: types::Vector3f,
    }
}

view! {
    ReferencePointLeverArmResponse
    reference_point: ReferencePoint, at 0;
    lever_arm_offset: types::Vector3f, at 1;
}

constructors! {
    ReferencePointLeverArmResponse

    /// Creates it from its values.
    fn new(reference_point: ReferencePoint, lever_arm_offset: impl Into<types::Vector3f>);
}

field! {
    ReferencePointLeverArmResponse: 0xD6, "filter.reference_point_lever_arm_response";
    in [0x0D];
    answers ReferencePointLeverArm;
}

record! {
    /// Speed measurement lever arm response (0x0D,0xE1).
    ///
    /// Response to [`SpeedLeverArm`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61).
    #[derive(Copy)]
    pub struct SpeedLeverArmResponse {
        /// Reserved.
        pub source: u8,
        /// Lever arm from the sensor to the point of measurement.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle.
        pub lever_arm_offset: types::Vector3f,
    }
}

#[rustfmt::skip]
impl core::default::Default for SpeedLeverArmResponse {
    fn default() -> Self {
        Self {
            source: 1,
            lever_arm_offset: core::default::Default::default(),
        }
    }
}

view! {
    SpeedLeverArmResponse
    source: u8, at 0;
    lever_arm_offset: types::Vector3f, at 1;
}

constructors! {
    SpeedLeverArmResponse

    /// Creates it from its values.
    fn new(lever_arm_offset: impl Into<types::Vector3f>), source: 1;
}

field! {
    SpeedLeverArmResponse: 0xE1, "filter.speed_lever_arm_response";
    in [0x0D];
    answers SpeedLeverArm;
}

record! {
    /// Vertical gyro constraint response (0x0D,0xE2).
    ///
    /// Response to [`VerticalGyroConstraintControl`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct VerticalGyroConstraintControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
    }
}

view! {
    VerticalGyroConstraintControlResponse
    enable: u8, at 0;
}

constructors! {
    VerticalGyroConstraintControlResponse

    /// Creates it from its values.
    fn new(enable: u8);
}

field! {
    VerticalGyroConstraintControlResponse: 0xE2, "filter.vertical_gyro_constraint_control_response";
    in [0x0D];
    answers VerticalGyroConstraintControl;
}

record! {
    /// Wheeled vehicle constraint response (0x0D,0xE3).
    ///
    /// Response to [`WheeledVehicleConstraintControl`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct WheeledVehicleConstraintControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
    }
}

view! {
    WheeledVehicleConstraintControlResponse
    enable: u8, at 0;
}

constructors! {
    WheeledVehicleConstraintControlResponse

    /// Creates it from its values.
    fn new(enable: u8);
}

field! {
    WheeledVehicleConstraintControlResponse: 0xE3, "filter.wheeled_vehicle_constraint_control_response";
    in [0x0D];
    answers WheeledVehicleConstraintControl;
}

record! {
    /// GNSS antenna offset calibration response (0x0D,0xE4).
    ///
    /// Also called `gnss_antenna_cal_control_response`. Response to
    /// [`GnssAntennaCalibrationControl`]. Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64);
    /// 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration.
    #[derive(Copy, Default)]
    pub struct GnssAntennaCalibrationControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Largest absolute error that is tracked.
        ///
        /// Unit: m. Frame: vehicle. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub max_offset: f32,
    }
}

view! {
    GnssAntennaCalibrationControlResponse
    enable: u8, at 0;
    max_offset: f32, at 1;
}

constructors! {
    GnssAntennaCalibrationControlResponse

    /// Creates it from its values.
    fn new(enable: u8, max_offset: f32);
}

field! {
    GnssAntennaCalibrationControlResponse: 0xE4, "filter.gnss_antenna_calibration_control_response";
    in [0x0D];
    answers GnssAntennaCalibrationControl;
}
