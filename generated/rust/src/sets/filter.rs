//! Filter commands (0x0D): Commands that set up, start and aid the navigation filter.
//!
//! Source: 3dm-gx5-15: 4.3 Estimation Filter Commands; 3dm-cv7-gnss-ins: Filter (0x0D).

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x0D;

bitfield! {
    /// States that the filter estimates.
    EstimatedStates: u16 {
        /// Estimate the gyroscope bias (recommended). Bit 0.
        GYRO_BIAS: bool = 0,
            gyro_bias, set_gyro_bias, with_gyro_bias;
    }
}

open_enum! {
    /// Where the filter takes GNSS data from.
    GnssAidingSource: u8 {
        /// All internal receivers.
        ALL_INT = 1, "all_int";
        /// GNSS measurements that the user sends.
        EXT = 2, "ext";
        /// Internal receiver 1 only.
        INT_1 = 3, "int_1";
        /// Internal receiver 2 only.
        INT_2 = 4, "int_2";
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
    /// Where the filter takes heading updates from.
    HeadingUpdateSource: u8 {
        /// No heading updates.
        NONE = 0, "none";
        /// The heading messages that the user sends.
        EXTERNAL = 3, "external";
    }
}

bitfield! {
    /// Axes to tare; 0 resets all axes.
    TareAxes: u8 {
        /// Tare roll. Bit 0.
        ROLL: bool = 0,
            roll, set_roll, with_roll;
        /// Tare pitch. Bit 1.
        PITCH: bool = 1,
            pitch, set_pitch, with_pitch;
        /// Tare yaw. Bit 2.
        YAW: bool = 2,
            yaw, set_yaw, with_yaw;
    }
}

bitfield! {
    /// Measurements that the filter uses.
    MeasurementFlags: u16 {
        /// Accelerometer measurements. Bit 0.
        ACCELEROMETER: bool = 0,
            accelerometer, set_accelerometer, with_accelerometer;
        /// Magnetometer measurements, on models that have a magnetometer. Bit 1.
        MAGNETOMETER: bool = 1,
            magnetometer, set_magnetometer, with_magnetometer;
    }
}

open_enum! {
    /// Where the declination of the magnetic field comes from.
    DeclinationSource: u8 {
        /// No source.
        NONE = 1, "none";
        /// The World Magnetic Model, at the estimated position.
        WMM = 2, "wmm";
        /// The angle that the command gives.
        MANUAL = 3, "manual";
    }
}

open_enum! {
    /// How measurements of the gravity direction are weighted.
    AdaptiveMeasurementSelector: u8 {
        /// No adaptation.
        DISABLED = 0, "disabled";
        /// Adapted by the limits that the command gives.
        FIXED = 1, "fixed";
        /// Adapted by the filter itself; the limits are ignored. 3DM-GX5 and later.
        AUTO = 2, "auto";
    }
}

open_enum! {
    /// What aids pitch and roll.
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
        /// GNSS position and velocity.
        GNSS_POS_VEL = 0, "gnss_pos_vel";
        /// GNSS heading of two antennas.
        GNSS_HEADING = 1, "gnss_heading";
        /// Built-in pressure altimeter.
        ALTIMETER = 2, "altimeter";
        /// Speed sensor or odometer.
        SPEED = 3, "speed";
        /// Built-in magnetometer.
        MAGNETOMETER = 4, "magnetometer";
        /// Heading that the user sends.
        EXTERNAL_HEADING = 5, "external_heading";
        /// Pressure altitude that the user sends.
        EXTERNAL_ALTIMETER = 6, "external_altimeter";
        /// Magnetic field that the user sends.
        EXTERNAL_MAGNETOMETER = 7, "external_magnetometer";
        /// Velocity in the vehicle that the user sends.
        BODY_FRAME_VEL = 8, "body_frame_vel";
        /// All sources, for save, load and default.
        ALL = 65535, "all";
    }
}

open_enum! {
    /// Which initial conditions the device finds itself and which the user gives.
    InitialConditionSource: u8 {
        /// Position, velocity and attitude are found.
        AUTO_POS_VEL_ATT = 0, "auto_pos_vel_att";
        /// Position, velocity, pitch and roll are found; the heading is given.
        AUTO_POS_VEL_PITCH_ROLL = 1, "auto_pos_vel_pitch_roll";
        /// Position and velocity are found; the attitude is given.
        AUTO_POS_VEL = 2, "auto_pos_vel";
        /// Position, velocity and attitude are given.
        MANUAL = 3, "manual";
    }
}

bitfield! {
    /// Ways in which the device may find its initial heading.
    HeadingAlignment: u8 {
        /// From the baseline between two GNSS antennas. Bit 0.
        DUAL_ANTENNA: bool = 0,
            dual_antenna, set_dual_antenna, with_dual_antenna;
        /// From the GNSS velocity; assumes motion along the positive x axis of the vehicle. Bit 1.
        KINEMATIC: bool = 1,
            kinematic, set_kinematic, with_kinematic;
        /// From the built-in magnetometer. Bit 2.
        MAGNETOMETER: bool = 2,
            magnetometer, set_magnetometer, with_magnetometer;
        /// From the heading that the user sends. Bit 3.
        EXTERNAL: bool = 3,
            external, set_external, with_external;
    }
}

open_enum! {
    /// Frame in which a position is given.
    ReferenceFrame: u8 {
        /// Earth-centred, Earth-fixed coordinates (WGS84).
        ECEF = 1, "ecef";
        /// Latitude, longitude and height above the ellipsoid (WGS84).
        LLH = 2, "llh";
    }
}

open_enum! {
    /// How strongly the filter adapts to measurements that do not fit.
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
    /// Where the reference of relative positions comes from.
    RelativePositionSource: u8 {
        /// The base station of the RTK corrections.
        AUTO = 0, "auto";
        /// The coordinates that the command gives.
        MANUAL = 1, "manual";
    }
}

open_enum! {
    /// A point of reference.
    ReferencePoint: u8 {
        /// The origin of the vehicle.
        VEH = 1, "veh";
    }
}

record! {
    /// Reset navigation filter (0x0D,0x01).
    ///
    /// Puts the filter back into its initialization state.
    ///
    /// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - If automatic initialization is off, the attitude or heading must be set before the filter
    ///   runs again.
    /// - 3DM-CV7: send it after a large jump of the system time, for example when the PPS is first
    ///   found.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01); 3dm-gx5-15: 4.3.1 Reset
    /// Filter (0x0D, 0x01).
    #[derive(Default)]
    pub struct ResetNavigationFilter;
}

constructors! {
    ResetNavigationFilter

    /// The command with its parameters.
    fn new();
}

field! {
    ResetNavigationFilter: 0x0D, 0x01, "filter.reset_navigation_filter";
}

command! {
    ResetNavigationFilter -> ();
}

record! {
    /// Set initial attitude (0x0D,0x02).
    ///
    /// Gives the filter its initial attitude, the orientation of the sensor frame in the NED frame.
    ///
    /// Supported by 3DM-GX5-15.
    ///
    /// - Accepted only in the initialization state.
    ///
    /// Source: 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02).
    #[derive(Default)]
    pub struct SetInitialAttitude {
        /// Roll angle.
        ///
        /// Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
        pub roll: f32,
        /// Pitch angle.
        ///
        /// Unit: rad. Frame: ned. Range: -1.5707963267948966 to 1.5707963267948966.
        pub pitch: f32,
        /// Heading (yaw) angle.
        ///
        /// Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
        pub heading: f32,
    }
}

constructors! {
    SetInitialAttitude

    /// The command with its parameters.
    fn new(
        roll: f32,
        pitch: f32,
        heading: f32,
    );
}

field! {
    SetInitialAttitude: 0x0D, 0x02, "filter.set_initial_attitude";
}

command! {
    SetInitialAttitude -> ();
}

record! {
    /// Set initial heading (0x0D,0x03).
    ///
    /// Gives the filter its initial heading; pitch and roll come from the accelerometers.
    ///
    /// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - 3DM-GX5: accepted only in the initialization state.
    /// - 3DM-CV7: resets the estimated heading; if magnetometer aiding is on, the given heading is
    ///   ignored.
    ///
    /// Source: 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03); 3dm-gx5-15: 4.3.3 Set
    /// Initial Heading (0x0D, 0x03).
    #[derive(Default)]
    pub struct SetInitialHeadingControl {
        /// Initial heading.
        ///
        /// Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
        pub heading: f32,
    }
}

constructors! {
    SetInitialHeadingControl

    /// The command with its parameters.
    fn new(heading: f32);
}

field! {
    SetInitialHeadingControl: 0x0D, 0x03, "filter.set_initial_heading_control";
}

command! {
    SetInitialHeadingControl -> ();
}

record! {
    /// Run navigation filter (0x0D,0x05).
    ///
    /// Starts a filter that was set up to wait for this command.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - The filter waits in its initialization state if `wait_for_run_command` of
    ///   `navigation_filter_initialization` is set.
    ///
    /// Source: 3dm-cv7-gnss-ins: Run Navigation Filter (0x0D,0x05).
    #[derive(Default)]
    pub struct RunNavigationFilter;
}

constructors! {
    RunNavigationFilter

    /// The command with its parameters.
    fn new();
}

field! {
    RunNavigationFilter: 0x0D, 0x05, "filter.run_navigation_filter";
}

command! {
    RunNavigationFilter -> ();
}

record! {
    /// Sensor to vehicle frame transformation (0x0D,0x11).
    ///
    /// Euler angles of the rotation from the sensor frame to the vehicle frame (5-series).
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`SensorToVehicleFrameTransformationResponse`]. Supported by 3DM-GX5-15.
    ///
    /// - It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
    ///   velocity, and the orientation, compensated and linear acceleration, angular rate and
    ///   gravity vector of the filter.
    /// - The 3DM-CV7 takes the inverse instead: `3dm.sensor_to_vehicle_frame_transformation_euler`.
    ///
    /// Source: 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11).
    pub struct SensorToVehicleFrameTransformation {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Roll angle.
        ///
        /// Unit: rad. Required for write.
        pub roll: Option<f32>,
        /// Pitch angle.
        ///
        /// Unit: rad. Required for write.
        pub pitch: Option<f32>,
        /// Yaw angle.
        ///
        /// Unit: rad. Required for write.
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
    SensorToVehicleFrameTransformation

    /// Apply the new setting.
    fn write(
        roll: f32,
        pitch: f32,
        yaw: f32,
    ) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    SensorToVehicleFrameTransformation: 0x0D, 0x11, "filter.sensor_to_vehicle_frame_transformation";
}

command! {
    SensorToVehicleFrameTransformation -> SensorToVehicleFrameTransformationResponse;
    responds for READ;
}

record! {
    /// GNSS antenna offset (0x0D,0x13).
    ///
    /// Position of the GNSS antenna relative to the origin of the sensor.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GnssAntennaOffsetControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - The magnitude of the vector is limited to 10.
    /// - 7-series devices expect the vehicle frame, 5-series devices the sensor frame.
    /// - On the 3DM-CV7 it is for GNSS data that come as NMEA; data that come by the aiding
    ///   commands use `aiding.frame_configuration`.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13).
    pub struct GnssAntennaOffsetControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// From the sensor origin to the centre of the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: -10 to 10. Required for write.
        pub offset: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [offset for WRITE]
    }
}

constructors! {
    GnssAntennaOffsetControl

    /// Apply the new setting.
    fn write(offset: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    GnssAntennaOffsetControl: 0x0D, 0x13, "filter.gnss_antenna_offset_control";
}

command! {
    GnssAntennaOffsetControl -> GnssAntennaOffsetControlResponse;
    responds for READ;
}

record! {
    /// Estimation control flags (0x0D,0x14).
    ///
    /// Which states the filter estimates.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`EstimationControlFlagsResponse`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14).
    pub struct EstimationControlFlags {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// States to estimate.
        ///
        /// Required for write.
        pub flags: Option<EstimatedStates>,
    }
    wire 3 {
        [function selects]
        [flags for WRITE]
    }
}

constructors! {
    EstimationControlFlags

    /// Apply the new setting.
    fn write(flags: EstimatedStates) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    EstimationControlFlags: 0x0D, 0x14, "filter.estimation_control_flags";
}

command! {
    EstimationControlFlags -> EstimationControlFlagsResponse;
    responds for READ;
}

record! {
    /// GNSS aiding source (0x0D,0x15).
    ///
    /// Which GNSS receiver aids the filter.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GnssAidingSourceControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - A change while the filter runs may put it back into initialization until the new source
    ///   gives data.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15).
    pub struct GnssAidingSourceControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Source of the GNSS data.
        ///
        /// Required for write.
        pub source: Option<GnssAidingSource>,
    }
    wire 2 {
        [function selects]
        [source for WRITE]
    }
}

constructors! {
    GnssAidingSourceControl

    /// Apply the new setting.
    fn write(source: GnssAidingSource) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    GnssAidingSourceControl: 0x0D, 0x15, "filter.gnss_aiding_source_control";
}

command! {
    GnssAidingSourceControl -> GnssAidingSourceControlResponse;
    responds for READ;
}

record! {
    /// External heading update (0x0D,0x17).
    ///
    /// Gives the filter one measurement of the heading of the sensor frame in the NED frame.
    ///
    /// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - Refused unless external heading updates are enabled, by `heading_update_control` on the
    ///   3DM-GX5 and by `aiding_measurement_control` on the 3DM-CV7.
    /// - The 3DM-GX5-15 takes at most 20 updates per second.
    /// - If the declination source is not valid, -25 models refuse true headings and -45 models
    ///   magnetic ones.
    ///
    /// Source: 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17); 3dm-gx5-15: 4.3.7 External
    /// Heading Update (0x0D, 0x17).
    #[derive(Default)]
    pub struct ExternalHeadingUpdate {
        /// Heading relative to the north that `type` names.
        ///
        /// Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
        pub heading: f32,
        /// Standard deviation; it must be greater than 0, other values are refused.
        ///
        /// Unit: rad.
        pub heading_uncertainty: f32,
        /// North that the heading refers to.
        pub type_: HeadingType,
    }
    wire 9 {
        [heading]
        [heading_uncertainty]
        [type_ "type"]
    }
}

constructors! {
    ExternalHeadingUpdate

    /// The command with its parameters.
    fn new(
        heading: f32,
        heading_uncertainty: f32,
        type_: HeadingType,
    );
}

field! {
    ExternalHeadingUpdate: 0x0D, 0x17, "filter.external_heading_update";
}

command! {
    ExternalHeadingUpdate -> ();
}

record! {
    /// Heading update control (0x0D,0x18).
    ///
    /// Source of the heading that aids the filter.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`HeadingUpdateControlResponse`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18).
    pub struct HeadingUpdateControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Source of the heading.
        ///
        /// Required for write.
        pub enable: Option<HeadingUpdateSource>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

constructors! {
    HeadingUpdateControl

    /// Apply the new setting.
    fn write(enable: HeadingUpdateSource) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    HeadingUpdateControl: 0x0D, 0x18, "filter.heading_update_control";
}

command! {
    HeadingUpdateControl -> HeadingUpdateControlResponse;
    responds for READ;
}

record! {
    /// Automatic initialization (0x0D,0x19).
    ///
    /// Whether the filter initializes by itself when the device starts.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`AutoInitializationControlResponse`]. Supported by 3DM-GX5-15.
    ///
    /// - It needs a valid heading source.
    ///
    /// Source: 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19).
    pub struct AutoInitializationControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for write.
        pub enable: Option<u8>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

constructors! {
    AutoInitializationControl

    /// Apply the new setting.
    fn write(enable: u8) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    AutoInitializationControl: 0x0D, 0x19, "filter.auto_initialization_control";
}

command! {
    AutoInitializationControl -> AutoInitializationControlResponse;
    responds for READ;
}

record! {
    /// Accelerometer noise (0x0D,0x1A).
    ///
    /// Standard deviation of the accelerometer noise that the filter assumes (process noise).
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`AccelerometerNoiseStandardDeviationResponse`]. Supported by 3DM-CV7-GNSS/INS and
    /// 3DM-GX5-15.
    ///
    /// - Every value must be greater than 0. The factory values suit most laboratory conditions.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A); 3dm-gx5-15:
    /// 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A).
    pub struct AccelerometerNoiseStandardDeviation {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Required for write.
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

constructors! {
    AccelerometerNoiseStandardDeviation

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    AccelerometerNoiseStandardDeviation: 0x0D, 0x1A, "filter.accelerometer_noise_standard_deviation";
}

command! {
    AccelerometerNoiseStandardDeviation -> AccelerometerNoiseStandardDeviationResponse;
    responds for READ;
}

record! {
    /// Gyroscope noise (0x0D,0x1B).
    ///
    /// Standard deviation of the gyroscope noise that the filter assumes (process noise).
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GyroscopeNoiseStandardDeviationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - Every value must be greater than 0. The factory values suit most laboratory conditions.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B); 3dm-gx5-15: 4.3.13
    /// Gyroscope Noise Standard Deviation (0x0D, 0x1B).
    pub struct GyroscopeNoiseStandardDeviation {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Required for write.
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

constructors! {
    GyroscopeNoiseStandardDeviation

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    GyroscopeNoiseStandardDeviation: 0x0D, 0x1B, "filter.gyroscope_noise_standard_deviation";
}

command! {
    GyroscopeNoiseStandardDeviation -> GyroscopeNoiseStandardDeviationResponse;
    responds for READ;
}

record! {
    /// Accelerometer bias model (0x0D,0x1C).
    ///
    /// Parameters of the model by which the accelerometer bias drifts.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`AccelerometerBiasModelParametersResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - Every noise value must be greater than 0.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C).
    pub struct AccelerometerBiasModelParameters {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s. Required for write.
        pub beta: Option<types::Vector3f>,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Required for write.
        pub noise: Option<types::Vector3f>,
    }
    wire 25 {
        [function selects]
        [beta for WRITE]
        [noise for WRITE]
    }
}

constructors! {
    AccelerometerBiasModelParameters

    /// Apply the new setting.
    fn write(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    AccelerometerBiasModelParameters: 0x0D, 0x1C, "filter.accelerometer_bias_model_parameters";
}

command! {
    AccelerometerBiasModelParameters -> AccelerometerBiasModelParametersResponse;
    responds for READ;
}

record! {
    /// Gyroscope bias model (0x0D,0x1D).
    ///
    /// Parameters of the model by which the gyroscope bias drifts.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GyroscopeBiasModelParametersResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - Every noise value must be greater than 0.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D); 3dm-gx5-15: 4.3.14
    /// Gyroscope Bias Model Parameters (0x0D, 0x1D).
    pub struct GyroscopeBiasModelParameters {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s. Required for write.
        pub beta: Option<types::Vector3f>,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s. Required for write.
        pub noise: Option<types::Vector3f>,
    }
    wire 25 {
        [function selects]
        [beta for WRITE]
        [noise for WRITE]
    }
}

constructors! {
    GyroscopeBiasModelParameters

    /// Apply the new setting.
    fn write(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    GyroscopeBiasModelParameters: 0x0D, 0x1D, "filter.gyroscope_bias_model_parameters";
}

command! {
    GyroscopeBiasModelParameters -> GyroscopeBiasModelParametersResponse;
    responds for READ;
}

record! {
    /// External heading update with time (0x0D,0x1F).
    ///
    /// Gives the filter one measurement of the heading of the sensor frame with its GPS time.
    ///
    /// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - Better than `external_heading_update` where the heading changes quickly; the time must be
    ///   accurate.
    /// - Refused unless external heading updates are enabled, by `heading_update_control` on the
    ///   3DM-GX5 and by `aiding_measurement_control` on the 3DM-CV7.
    /// - The 3DM-GX5-15 takes at most 20 updates per second.
    /// - If the declination source is not valid, -25 models refuse true headings and -45 models
    ///   magnetic ones.
    ///
    /// Source: 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F); 3dm-gx5-15: 4.3.8
    /// External Heading Update with Timestamp (0x0D, 0x1F).
    #[derive(Default)]
    pub struct ExternalHeadingUpdateWithTime {
        /// GPS time of week of the measurement.
        ///
        /// Unit: s.
        pub gps_time: f64,
        /// GPS week, counted without rollover.
        ///
        /// Unit: week.
        pub gps_week: u16,
        /// Heading relative to the north that `type` names.
        ///
        /// Unit: rad. Frame: ned. Range: -3.141592653589793 to 3.141592653589793.
        pub heading: f32,
        /// Standard deviation; it must be greater than 0, other values are refused.
        ///
        /// Unit: rad.
        pub heading_uncertainty: f32,
        /// North that the heading refers to.
        pub type_: HeadingType,
    }
    wire 19 {
        [gps_time]
        [gps_week]
        [heading]
        [heading_uncertainty]
        [type_ "type"]
    }
}

constructors! {
    ExternalHeadingUpdateWithTime

    /// The command with its parameters.
    fn new(
        gps_time: f64,
        gps_week: u16,
        heading: f32,
        heading_uncertainty: f32,
        type_: HeadingType,
    );
}

field! {
    ExternalHeadingUpdateWithTime: 0x0D, 0x1F, "filter.external_heading_update_with_time";
}

command! {
    ExternalHeadingUpdateWithTime -> ();
}

record! {
    /// Zero angular rate update (0x0D,0x20).
    ///
    /// Lets the filter take the device as not rotating while its angular rate is small.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`ZeroAngularRateUpdateControlResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - The update applies while the magnitude of the angular rate vector is at or below the
    ///   threshold.
    ///
    /// Source: 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20); 3dm-gx5-15: 4.3.15
    /// Zero Angular Rate Update Control (0x0D, 0x20).
    pub struct ZeroAngularRateUpdateControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for write.
        pub enable: Option<u8>,
        /// Largest angular rate that is taken as zero.
        ///
        /// Unit: rad/s. Range: at least 0. Required for write.
        pub threshold: Option<f32>,
    }
    wire 6 {
        [function selects]
        [enable for WRITE]
        [threshold for WRITE]
    }
}

constructors! {
    ZeroAngularRateUpdateControl

    /// Apply the new setting.
    fn write(enable: u8, threshold: f32) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    ZeroAngularRateUpdateControl: 0x0D, 0x20, "filter.zero_angular_rate_update_control";
}

command! {
    ZeroAngularRateUpdateControl -> ZeroAngularRateUpdateControlResponse;
    responds for READ;
}

record! {
    /// Tare orientation (0x0D,0x21).
    ///
    /// Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
    ///
    /// Functions: write, save, load and default. Supported by 3DM-GX5-15.
    ///
    /// - Refused while the filter has no valid attitude.
    ///
    /// Source: 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21).
    pub struct TareOrientation {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Axes to tare; 0 resets all axes.
        ///
        /// Required for write.
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
    fn write(axes: TareAxes) = WRITE;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    TareOrientation: 0x0D, 0x21, "filter.tare_orientation";
}

command! {
    TareOrientation -> ();
}

record! {
    /// Commanded zero angular rate update (0x0D,0x23).
    ///
    /// Tells the filter once that the device is not rotating.
    ///
    /// Supported by 3DM-GX5-15.
    ///
    /// - At most 10 per second.
    ///
    /// Source: 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23).
    #[derive(Default)]
    pub struct CommandedZeroAngularRateUpdate;
}

constructors! {
    CommandedZeroAngularRateUpdate

    /// The command with its parameters.
    fn new();
}

field! {
    CommandedZeroAngularRateUpdate: 0x0D, 0x23, "filter.commanded_zero_angular_rate_update";
}

command! {
    CommandedZeroAngularRateUpdate -> ();
}

record! {
    /// Set reference position (0x0D,0x26).
    ///
    /// Position for which the device computes gravity (WGS84) and the magnetic field (WMM2015).
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`SetReferencePositionResponse`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26).
    pub struct SetReferencePosition {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for write.
        pub enable: Option<u8>,
        /// Latitude.
        ///
        /// Unit: deg. Frame: llh. Required for write.
        pub latitude: Option<f64>,
        /// Longitude.
        ///
        /// Unit: deg. Frame: llh. Required for write.
        pub longitude: Option<f64>,
        /// Altitude.
        ///
        /// Unit: m. Frame: llh. Required for write.
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

constructors! {
    SetReferencePosition

    /// Apply the new setting.
    fn write(
        enable: u8,
        latitude: f64,
        longitude: f64,
        altitude: f64,
    ) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    SetReferencePosition: 0x0D, 0x26, "filter.set_reference_position";
}

command! {
    SetReferencePosition -> SetReferencePositionResponse;
    responds for READ;
}

record! {
    /// Gravity noise (0x0D,0x28).
    ///
    /// Standard deviation of the gravity noise that the filter assumes (process noise).
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GravityNoiseStandardDeviationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// - Every value must be greater than 0. The factory values suit most laboratory conditions.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28); 3dm-gx5-15: 4.3.11
    /// Gravity Noise Standard Deviation (0x0D, 0x28).
    pub struct GravityNoiseStandardDeviation {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: g. Required for write.
        pub noise: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [noise for WRITE]
    }
}

constructors! {
    GravityNoiseStandardDeviation

    /// Apply the new setting.
    fn write(noise: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    GravityNoiseStandardDeviation: 0x0D, 0x28, "filter.gravity_noise_standard_deviation";
}

command! {
    GravityNoiseStandardDeviation -> GravityNoiseStandardDeviationResponse;
    responds for READ;
}

record! {
    /// Enable or disable measurements (0x0D,0x41).
    ///
    /// Which inertial measurements the filter uses.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`EnableDisableMeasurementsResponse`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41).
    pub struct EnableDisableMeasurements {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Measurements to use.
        ///
        /// Required for write.
        pub control: Option<MeasurementFlags>,
    }
    wire 3 {
        [function selects]
        [control for WRITE]
    }
}

constructors! {
    EnableDisableMeasurements

    /// Apply the new setting.
    fn write(control: MeasurementFlags) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    EnableDisableMeasurements: 0x0D, 0x41, "filter.enable_disable_measurements";
}

command! {
    EnableDisableMeasurements -> EnableDisableMeasurementsResponse;
    responds for READ;
}

record! {
    /// Magnetic declination source (0x0D,0x43).
    ///
    /// Source of the local declination of the magnetic field.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`MagneticFieldDeclinationSourceControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - Without a good declination source, keep automatic magnetometer calibration off.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43).
    pub struct MagneticFieldDeclinationSourceControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Source of the declination.
        ///
        /// Required for write.
        pub source: Option<DeclinationSource>,
        /// Declination; used only if `source` is manual.
        ///
        /// Unit: rad. Required for write.
        pub declination: Option<f32>,
    }
    wire 6 {
        [function selects]
        [source for WRITE]
        [declination for WRITE]
    }
}

constructors! {
    MagneticFieldDeclinationSourceControl

    /// Apply the new setting.
    fn write(source: DeclinationSource, declination: f32) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    MagneticFieldDeclinationSourceControl: 0x0D, 0x43, "filter.magnetic_field_declination_source_control";
}

command! {
    MagneticFieldDeclinationSourceControl -> MagneticFieldDeclinationSourceControlResponse;
    responds for READ;
}

record! {
    /// Gravity magnitude error adaptive measurement (0x0D,0x44).
    ///
    /// How far the filter trusts gravity measurements whose magnitude is not that of gravity.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GravityMagnitudeErrorAdaptiveMeasurementResponse`]. Supported by 3DM-GX5-15.
    ///
    /// - Also called accelerometer magnitude error adaptive measurement.
    /// - All parameters after the selector keep their values if they are left out.
    /// - Filter and limits take effect only with `fixed`.
    /// - Raise the limits where vibration is strong, lower them where it is weak. High limits cost
    ///   pitch and roll accuracy under linear acceleration, low limits cost heading accuracy.
    ///
    /// Source: 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44).
    pub struct GravityMagnitudeErrorAdaptiveMeasurement {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Kind of adaptation.
        ///
        /// Required for write.
        pub adaptive_measurement: Option<AdaptiveMeasurementSelector>,
        /// Cut-off frequency of the low-pass filter.
        ///
        /// Unit: Hz. Optional.
        pub frequency: Option<f32>,
        /// Lower limit of the error.
        ///
        /// Unit: m/s^2. Optional.
        pub low_limit: Option<f32>,
        /// Upper limit of the error.
        ///
        /// Unit: m/s^2. Optional.
        pub high_limit: Option<f32>,
        /// Standard deviation at the lower limit.
        ///
        /// Unit: m/s^2. Optional.
        pub low_limit_uncertainty: Option<f32>,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: m/s^2. Optional.
        pub high_limit_uncertainty: Option<f32>,
        /// Smallest standard deviation.
        ///
        /// Unit: m/s^2. Optional.
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

constructors! {
    GravityMagnitudeErrorAdaptiveMeasurement

    /// Apply the new setting.
    fn write(adaptive_measurement: AdaptiveMeasurementSelector) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

setters! {
    GravityMagnitudeErrorAdaptiveMeasurement
    fn with_frequency(frequency: f32);
    fn with_low_limit(low_limit: f32);
    fn with_high_limit(high_limit: f32);
    fn with_low_limit_uncertainty(low_limit_uncertainty: f32);
    fn with_high_limit_uncertainty(high_limit_uncertainty: f32);
    fn with_minimum_uncertainty(minimum_uncertainty: f32);
}

field! {
    GravityMagnitudeErrorAdaptiveMeasurement: 0x0D, 0x44, "filter.gravity_magnitude_error_adaptive_measurement";
}

command! {
    GravityMagnitudeErrorAdaptiveMeasurement -> GravityMagnitudeErrorAdaptiveMeasurementResponse;
    responds for READ;
}

record! {
    /// Pitch and roll aiding (0x0D,0x4B).
    ///
    /// What aids pitch and roll while the motion is gentle.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`PitchRollAidingControlResponse`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B).
    pub struct PitchRollAidingControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Source of the aiding.
        ///
        /// Required for write.
        pub aiding: Option<PitchRollAidingSource>,
    }
    wire 2 {
        [function selects]
        [aiding for WRITE]
    }
}

constructors! {
    PitchRollAidingControl

    /// Apply the new setting.
    fn write(aiding: PitchRollAidingSource) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    PitchRollAidingControl: 0x0D, 0x4B, "filter.pitch_roll_aiding_control";
}

command! {
    PitchRollAidingControl -> PitchRollAidingControlResponse;
    responds for READ;
}

record! {
    /// Aiding measurement control (0x0D,0x50).
    ///
    /// Enables or disables one source of aiding measurements.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`AidingMeasurementControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50).
    pub struct AidingMeasurementControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// The source; `all` is for save, load and default.
        pub aiding_source: Option<AidingSource>,
        /// Whether the filter uses the source.
        ///
        /// Required for write.
        pub enable: Option<crate::Bool>,
    }
    wire 4 {
        [function selects]
        [aiding_source for WRITE READ SAVE LOAD DEFAULT]
        [enable for WRITE]
    }
}

constructors! {
    AidingMeasurementControl

    /// Apply the new setting.
    fn write(aiding_source: AidingSource, enable: bool) = WRITE;

    /// Send the current setting back in a response.
    fn read(aiding_source: AidingSource) = READ;

    /// Save the current setting to non-volatile memory.
    fn save(aiding_source: AidingSource) = SAVE;

    /// Load the saved setting.
    fn load(aiding_source: AidingSource) = LOAD;

    /// Load the factory default setting.
    fn load_default(aiding_source: AidingSource) = DEFAULT;
}

field! {
    AidingMeasurementControl: 0x0D, 0x50, "filter.aiding_measurement_control";
}

command! {
    AidingMeasurementControl -> AidingMeasurementControlResponse;
    responds for READ;
}

record! {
    /// Navigation filter initialization (0x0D,0x52).
    ///
    /// Sources and values of the initial attitude, position and velocity of the filter.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`NavigationFilterInitializationResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - Single precision resolves the latitude and longitude of the initial position to about a
    ///   metre only.
    /// - Kinematic alignment sets the heading once the speed reaches 2 m/s.
    /// - External alignment needs a heading at least every 5 seconds.
    ///
    /// Source: 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52).
    pub struct NavigationFilterInitialization {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// 1: the filter starts only after `run_navigation_filter`; 0: as soon as it can.
        ///
        /// Range: 0 to 1. Required for write.
        pub wait_for_run_command: Option<u8>,
        /// Which initial conditions are found and which are given.
        ///
        /// Required for write.
        pub initial_cond_src: Option<InitialConditionSource>,
        /// Ways in which the initial heading may be found.
        ///
        /// Required for write.
        pub auto_heading_alignment_selector: Option<HeadingAlignment>,
        /// Given heading.
        ///
        /// Unit: deg. Required for write.
        pub initial_heading: Option<f32>,
        /// Given pitch.
        ///
        /// Unit: deg. Required for write.
        pub initial_pitch: Option<f32>,
        /// Given roll.
        ///
        /// Unit: deg. Required for write.
        pub initial_roll: Option<f32>,
        /// Given position.
        ///
        /// Elements: x, y, z. Required for write. If `reference_frame_selector` is
        /// [`ReferenceFrame::ECEF`]: unit m; frame ecef. If `reference_frame_selector` is
        /// [`ReferenceFrame::LLH`]: unit deg, deg, m; frame llh.
        pub initial_position: Option<types::Vector3f>,
        /// Given velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. Required for write. If `reference_frame_selector` is
        /// [`ReferenceFrame::ECEF`]: frame ecef. If `reference_frame_selector` is
        /// [`ReferenceFrame::LLH`]: frame ned.
        pub initial_velocity: Option<types::Vector3f>,
        /// Frame of the given position and velocity.
        ///
        /// Required for write.
        pub reference_frame_selector: Option<ReferenceFrame>,
    }
    wire 41 {
        [function selects]
        [wait_for_run_command for WRITE]
        [initial_cond_src for WRITE]
        [auto_heading_alignment_selector for WRITE]
        [initial_heading for WRITE]
        [initial_pitch for WRITE]
        [initial_roll for WRITE]
        [initial_position for WRITE]
        [initial_velocity for WRITE]
        [reference_frame_selector for WRITE]
    }
}

constructors! {
    NavigationFilterInitialization

    /// Apply the new setting.
    fn write(
        wait_for_run_command: u8,
        initial_cond_src: InitialConditionSource,
        auto_heading_alignment_selector: HeadingAlignment,
        initial_heading: f32,
        initial_pitch: f32,
        initial_roll: f32,
        initial_position: impl Into<types::Vector3f>,
        initial_velocity: impl Into<types::Vector3f>,
        reference_frame_selector: ReferenceFrame,
    ) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    NavigationFilterInitialization: 0x0D, 0x52, "filter.navigation_filter_initialization";
}

command! {
    NavigationFilterInitialization -> NavigationFilterInitializationResponse;
    responds for READ;
}

record! {
    /// Adaptive filter control (0x0D,0x53).
    ///
    /// How the filter adapts to measurements that do not fit its model.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`AdaptiveFilterControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53).
    pub struct AdaptiveFilterControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Strength of the adaptation.
        ///
        /// Default: 2. Required for write.
        pub level: Option<AdaptiveLevel>,
        /// Longest time for which measurements are rejected before the filter recovers.
        ///
        /// Unit: ms. Required for write.
        pub time_limit: Option<u16>,
    }
    wire 4 {
        [function selects]
        [level for WRITE]
        [time_limit for WRITE]
    }
}

constructors! {
    AdaptiveFilterControl

    /// Apply the new setting.
    fn write(level: AdaptiveLevel, time_limit: u16) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    AdaptiveFilterControl: 0x0D, 0x53, "filter.adaptive_filter_control";
}

command! {
    AdaptiveFilterControl -> AdaptiveFilterControlResponse;
    responds for READ;
}

record! {
    /// GNSS multi-antenna offset (0x0D,0x54).
    ///
    /// Position of the antenna of one receiver on devices with several antennas.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GnssMultiAntennaOffsetControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - The magnitude of the vector is limited to 10.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54).
    pub struct GnssMultiAntennaOffsetControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Number of the receiver, from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: Option<u8>,
        /// From the sensor to the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: -10 to 10. Required for write.
        pub antenna_offset: Option<types::Vector3f>,
    }
    wire 14 {
        [function selects]
        [receiver_id for WRITE READ SAVE LOAD DEFAULT]
        [antenna_offset for WRITE]
    }
}

constructors! {
    GnssMultiAntennaOffsetControl

    /// Apply the new setting.
    fn write(receiver_id: u8, antenna_offset: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read(receiver_id: u8) = READ;

    /// Save the current setting to non-volatile memory.
    fn save(receiver_id: u8) = SAVE;

    /// Load the saved setting.
    fn load(receiver_id: u8) = LOAD;

    /// Load the factory default setting.
    fn load_default(receiver_id: u8) = DEFAULT;
}

field! {
    GnssMultiAntennaOffsetControl: 0x0D, 0x54, "filter.gnss_multi_antenna_offset_control";
}

command! {
    GnssMultiAntennaOffsetControl -> GnssMultiAntennaOffsetControlResponse;
    responds for READ;
}

record! {
    /// Relative position configuration (0x0D,0x55).
    ///
    /// Reference point of the relative position that the filter reports.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`RelativePositionConfigurationResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55).
    pub struct RelativePositionConfiguration {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Source of the reference point.
        ///
        /// Required for write.
        pub source: Option<RelativePositionSource>,
        /// Frame of the coordinates.
        ///
        /// Required for write.
        pub reference_frame_selector: Option<ReferenceFrame>,
        /// Reference point.
        ///
        /// Elements: x, y, z. Required for write. If `reference_frame_selector` is
        /// [`ReferenceFrame::ECEF`]: unit m; frame ecef. If `reference_frame_selector` is
        /// [`ReferenceFrame::LLH`]: unit deg, deg, m; frame llh.
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
    RelativePositionConfiguration

    /// Apply the new setting.
    fn write(
        source: RelativePositionSource,
        reference_frame_selector: ReferenceFrame,
        reference_coordinates: impl Into<types::Vector3d>,
    ) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    RelativePositionConfiguration: 0x0D, 0x55, "filter.relative_position_configuration";
}

command! {
    RelativePositionConfiguration -> RelativePositionConfigurationResponse;
    responds for READ;
}

record! {
    /// Reference point lever arm (0x0D,0x56).
    ///
    /// Moves the point to which the position and the velocity of the filter refer.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`ReferencePointLeverArmResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - It shifts `llh_position`, `velocity_ned`, `ecef_position`, `ecef_velocity` and
    ///   `ned_relative_position` of set `filter_data`, depending on the attitude and, for
    ///   velocities, on the angular rate.
    /// - The magnitude of the vector is limited to 10.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56).
    pub struct ReferencePointLeverArm {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Point to move; it must be 1.
        ///
        /// Required for write.
        pub ref_point_sel: Option<ReferencePoint>,
        /// From the sensor to the point.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: -10 to 10. Required for write.
        pub lever_arm_offset: Option<types::Vector3f>,
    }
    wire 14 {
        [function selects]
        [ref_point_sel for WRITE]
        [lever_arm_offset for WRITE]
    }
}

constructors! {
    ReferencePointLeverArm

    /// Apply the new setting.
    fn write(ref_point_sel: ReferencePoint, lever_arm_offset: impl Into<types::Vector3f>) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    ReferencePointLeverArm: 0x0D, 0x56, "filter.reference_point_lever_arm";
}

command! {
    ReferencePointLeverArm -> ReferencePointLeverArmResponse;
    responds for READ;
}

record! {
    /// Speed measurement lever arm (0x0D,0x61).
    ///
    /// Position of the point whose speed is measured, such as the wheel that an odometer is on.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`MeasurementSpeedLeverArmResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - It corrects for the speed that such a point has only because the vehicle turns.
    ///
    /// Source: 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61).
    pub struct MeasurementSpeedLeverArm {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Send 1.
        ///
        /// Reserved: send 1.
        pub source: Option<u8>,
        /// From the sensor to the point of measurement.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Required for write.
        pub lever_arm_offset: Option<types::Vector3f>,
    }
    wire 14 {
        [function selects]
        [source for WRITE READ SAVE LOAD DEFAULT]
        [lever_arm_offset for WRITE]
    }
}

constructors! {
    MeasurementSpeedLeverArm

    /// Apply the new setting.
    fn write(lever_arm_offset: impl Into<types::Vector3f>) = WRITE, source: 1;

    /// Send the current setting back in a response.
    fn read() = READ, source: 1;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE, source: 1;

    /// Load the saved setting.
    fn load() = LOAD, source: 1;

    /// Load the factory default setting.
    fn load_default() = DEFAULT, source: 1;
}

field! {
    MeasurementSpeedLeverArm: 0x0D, 0x61, "filter.measurement_speed_lever_arm";
}

command! {
    MeasurementSpeedLeverArm -> MeasurementSpeedLeverArmResponse;
    responds for READ;
}

record! {
    /// Wheeled vehicle constraint (0x0D,0x63).
    ///
    /// Lets the filter assume that the vehicle moves only along its x axis.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`WheeledVehicleConstraintControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - It improves the heading of cars and the like, above all when GNSS comes and goes. It is
    ///   wrong for vehicles that move sideways, such as aircraft.
    ///
    /// Source: 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63).
    pub struct WheeledVehicleConstraintControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for write.
        pub enable: Option<u8>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

constructors! {
    WheeledVehicleConstraintControl

    /// Apply the new setting.
    fn write(enable: u8) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    WheeledVehicleConstraintControl: 0x0D, 0x63, "filter.wheeled_vehicle_constraint_control";
}

command! {
    WheeledVehicleConstraintControl -> WheeledVehicleConstraintControlResponse;
    responds for READ;
}

record! {
    /// GNSS antenna offset calibration (0x0D,0x64).
    ///
    /// Lets the filter track the error of the antenna offset.
    ///
    /// Functions: write, read, save, load and default. Answered by
    /// [`GnssAntennaOffsetCalibrationControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64);
    /// 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration.
    pub struct GnssAntennaOffsetCalibrationControl {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1. Required for write.
        pub enable: Option<u8>,
        /// Largest absolute error that is tracked; the limits are those of the 3DM-CV7.
        ///
        /// Unit: m. Frame: vehicle. Range: 0 to 0.5. Default: 0.1. Required for write.
        pub max_offset: Option<f32>,
    }
    wire 6 {
        [function selects]
        [enable for WRITE]
        [max_offset for WRITE]
    }
}

constructors! {
    GnssAntennaOffsetCalibrationControl

    /// Apply the new setting.
    fn write(enable: u8, max_offset: f32) = WRITE;

    /// Send the current setting back in a response.
    fn read() = READ;

    /// Save the current setting to non-volatile memory.
    fn save() = SAVE;

    /// Load the saved setting.
    fn load() = LOAD;

    /// Load the factory default setting.
    fn load_default() = DEFAULT;
}

field! {
    GnssAntennaOffsetCalibrationControl: 0x0D, 0x64, "filter.gnss_antenna_offset_calibration_control";
}

command! {
    GnssAntennaOffsetCalibrationControl -> GnssAntennaOffsetCalibrationControlResponse;
    responds for READ;
}

record! {
    /// Sensor to vehicle frame transformation response (0x0D,0x81).
    ///
    /// Answers [`SensorToVehicleFrameTransformation`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11).
    #[derive(Default)]
    pub struct SensorToVehicleFrameTransformationResponse {
        /// Roll angle.
        ///
        /// Unit: rad.
        pub roll: f32,
        /// Pitch angle.
        ///
        /// Unit: rad.
        pub pitch: f32,
        /// Yaw angle.
        ///
        /// Unit: rad.
        pub yaw: f32,
    }
}

field! {
    SensorToVehicleFrameTransformationResponse: 0x0D, 0x81, "filter.sensor_to_vehicle_frame_transformation_response";
    answers SensorToVehicleFrameTransformation;
}

record! {
    /// GNSS antenna offset response (0x0D,0x83).
    ///
    /// Answers [`GnssAntennaOffsetControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13).
    #[derive(Default)]
    pub struct GnssAntennaOffsetControlResponse {
        /// From the sensor origin to the centre of the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: -10 to 10.
        pub offset: types::Vector3f,
    }
}

field! {
    GnssAntennaOffsetControlResponse: 0x0D, 0x83, "filter.gnss_antenna_offset_control_response";
    answers GnssAntennaOffsetControl;
}

record! {
    /// Estimation control flags response (0x0D,0x84).
    ///
    /// Answers [`EstimationControlFlags`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14).
    #[derive(Default)]
    pub struct EstimationControlFlagsResponse {
        /// States to estimate.
        pub flags: EstimatedStates,
    }
}

field! {
    EstimationControlFlagsResponse: 0x0D, 0x84, "filter.estimation_control_flags_response";
    answers EstimationControlFlags;
}

record! {
    /// GNSS aiding source response (0x0D,0x86).
    ///
    /// Answers [`GnssAidingSourceControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15).
    #[derive(Default)]
    pub struct GnssAidingSourceControlResponse {
        /// Source of the GNSS data.
        pub source: GnssAidingSource,
    }
}

field! {
    GnssAidingSourceControlResponse: 0x0D, 0x86, "filter.gnss_aiding_source_control_response";
    answers GnssAidingSourceControl;
}

record! {
    /// Heading update control response (0x0D,0x87).
    ///
    /// Answers [`HeadingUpdateControl`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18).
    #[derive(Default)]
    pub struct HeadingUpdateControlResponse {
        /// Source of the heading.
        pub enable: HeadingUpdateSource,
    }
}

field! {
    HeadingUpdateControlResponse: 0x0D, 0x87, "filter.heading_update_control_response";
    answers HeadingUpdateControl;
}

record! {
    /// Automatic initialization response (0x0D,0x88).
    ///
    /// Answers [`AutoInitializationControl`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19).
    #[derive(Default)]
    pub struct AutoInitializationControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
    }
}

field! {
    AutoInitializationControlResponse: 0x0D, 0x88, "filter.auto_initialization_control_response";
    answers AutoInitializationControl;
}

record! {
    /// Accelerometer noise response (0x0D,0x89).
    ///
    /// Answers [`AccelerometerNoiseStandardDeviation`]. Supported by 3DM-CV7-GNSS/INS and
    /// 3DM-GX5-15.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A); 3dm-gx5-15:
    /// 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A).
    #[derive(Default)]
    pub struct AccelerometerNoiseStandardDeviationResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2.
        pub noise: types::Vector3f,
    }
}

field! {
    AccelerometerNoiseStandardDeviationResponse: 0x0D, 0x89, "filter.accelerometer_noise_standard_deviation_response";
    answers AccelerometerNoiseStandardDeviation;
}

record! {
    /// Gyroscope noise response (0x0D,0x8A).
    ///
    /// Answers [`GyroscopeNoiseStandardDeviation`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B); 3dm-gx5-15: 4.3.13
    /// Gyroscope Noise Standard Deviation (0x0D, 0x1B).
    #[derive(Default)]
    pub struct GyroscopeNoiseStandardDeviationResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s.
        pub noise: types::Vector3f,
    }
}

field! {
    GyroscopeNoiseStandardDeviationResponse: 0x0D, 0x8A, "filter.gyroscope_noise_standard_deviation_response";
    answers GyroscopeNoiseStandardDeviation;
}

record! {
    /// Accelerometer bias model response (0x0D,0x8B).
    ///
    /// Answers [`AccelerometerBiasModelParameters`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C).
    #[derive(Default)]
    pub struct AccelerometerBiasModelParametersResponse {
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s.
        pub beta: types::Vector3f,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: m/s^2.
        pub noise: types::Vector3f,
    }
}

field! {
    AccelerometerBiasModelParametersResponse: 0x0D, 0x8B, "filter.accelerometer_bias_model_parameters_response";
    answers AccelerometerBiasModelParameters;
}

record! {
    /// Gyroscope bias model response (0x0D,0x8C).
    ///
    /// Answers [`GyroscopeBiasModelParameters`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D); 3dm-gx5-15: 4.3.14
    /// Gyroscope Bias Model Parameters (0x0D, 0x1D).
    #[derive(Default)]
    pub struct GyroscopeBiasModelParametersResponse {
        /// Reciprocal of the correlation time per axis.
        ///
        /// Elements: x, y, z. Unit: 1/s.
        pub beta: types::Vector3f,
        /// Standard deviation of the noise per axis.
        ///
        /// Elements: x, y, z. Unit: rad/s.
        pub noise: types::Vector3f,
    }
}

field! {
    GyroscopeBiasModelParametersResponse: 0x0D, 0x8C, "filter.gyroscope_bias_model_parameters_response";
    answers GyroscopeBiasModelParameters;
}

record! {
    /// Zero angular rate update response (0x0D,0x8E).
    ///
    /// Answers [`ZeroAngularRateUpdateControl`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// Source: 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20); 3dm-gx5-15: 4.3.15
    /// Zero Angular Rate Update Control (0x0D, 0x20).
    #[derive(Default)]
    pub struct ZeroAngularRateUpdateControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Largest angular rate that is taken as zero.
        ///
        /// Unit: rad/s. Range: at least 0.
        pub threshold: f32,
    }
}

field! {
    ZeroAngularRateUpdateControlResponse: 0x0D, 0x8E, "filter.zero_angular_rate_update_control_response";
    answers ZeroAngularRateUpdateControl;
}

record! {
    /// Set reference position response (0x0D,0x90).
    ///
    /// Answers [`SetReferencePosition`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26).
    #[derive(Default)]
    pub struct SetReferencePositionResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Latitude.
        ///
        /// Unit: deg. Frame: llh.
        pub latitude: f64,
        /// Longitude.
        ///
        /// Unit: deg. Frame: llh.
        pub longitude: f64,
        /// Altitude.
        ///
        /// Unit: m. Frame: llh.
        pub altitude: f64,
    }
}

field! {
    SetReferencePositionResponse: 0x0D, 0x90, "filter.set_reference_position_response";
    answers SetReferencePosition;
}

record! {
    /// Gravity noise response (0x0D,0x93).
    ///
    /// Answers [`GravityNoiseStandardDeviation`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
    ///
    /// Source: 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28); 3dm-gx5-15: 4.3.11
    /// Gravity Noise Standard Deviation (0x0D, 0x28).
    #[derive(Default)]
    pub struct GravityNoiseStandardDeviationResponse {
        /// Standard deviation per axis.
        ///
        /// Elements: x, y, z. Unit: g.
        pub noise: types::Vector3f,
    }
}

field! {
    GravityNoiseStandardDeviationResponse: 0x0D, 0x93, "filter.gravity_noise_standard_deviation_response";
    answers GravityNoiseStandardDeviation;
}

record! {
    /// Enable or disable measurements response (0x0D,0xB0).
    ///
    /// Answers [`EnableDisableMeasurements`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41).
    #[derive(Default)]
    pub struct EnableDisableMeasurementsResponse {
        /// Measurements to use.
        pub control: MeasurementFlags,
    }
}

field! {
    EnableDisableMeasurementsResponse: 0x0D, 0xB0, "filter.enable_disable_measurements_response";
    answers EnableDisableMeasurements;
}

record! {
    /// Magnetic declination source response (0x0D,0xB2).
    ///
    /// Answers [`MagneticFieldDeclinationSourceControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43).
    #[derive(Default)]
    pub struct MagneticFieldDeclinationSourceControlResponse {
        /// Source of the declination.
        pub source: DeclinationSource,
        /// Declination; used only if `source` is manual.
        ///
        /// Unit: rad.
        pub declination: f32,
    }
}

field! {
    MagneticFieldDeclinationSourceControlResponse: 0x0D, 0xB2, "filter.magnetic_field_declination_source_control_response";
    answers MagneticFieldDeclinationSourceControl;
}

record! {
    /// Gravity magnitude error adaptive measurement response (0x0D,0xB3).
    ///
    /// Answers [`GravityMagnitudeErrorAdaptiveMeasurement`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44).
    #[derive(Default)]
    pub struct GravityMagnitudeErrorAdaptiveMeasurementResponse {
        /// Kind of adaptation.
        pub adaptive_measurement: AdaptiveMeasurementSelector,
        /// Cut-off frequency of the low-pass filter.
        ///
        /// Unit: Hz.
        pub frequency: f32,
        /// Lower limit of the error.
        ///
        /// Unit: m/s^2.
        pub low_limit: f32,
        /// Upper limit of the error.
        ///
        /// Unit: m/s^2.
        pub high_limit: f32,
        /// Standard deviation at the lower limit.
        ///
        /// Unit: m/s^2.
        pub low_limit_uncertainty: f32,
        /// Standard deviation at the upper limit.
        ///
        /// Unit: m/s^2.
        pub high_limit_uncertainty: f32,
        /// Smallest standard deviation.
        ///
        /// Unit: m/s^2.
        pub minimum_uncertainty: f32,
    }
}

field! {
    GravityMagnitudeErrorAdaptiveMeasurementResponse: 0x0D, 0xB3, "filter.gravity_magnitude_error_adaptive_measurement_response";
    answers GravityMagnitudeErrorAdaptiveMeasurement;
}

record! {
    /// Pitch and roll aiding response (0x0D,0xBB).
    ///
    /// Answers [`PitchRollAidingControl`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B).
    #[derive(Default)]
    pub struct PitchRollAidingControlResponse {
        /// Source of the aiding.
        pub aiding: PitchRollAidingSource,
    }
}

field! {
    PitchRollAidingControlResponse: 0x0D, 0xBB, "filter.pitch_roll_aiding_control_response";
    answers PitchRollAidingControl;
}

record! {
    /// Aiding measurement control response (0x0D,0xD0).
    ///
    /// Answers [`AidingMeasurementControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50).
    #[derive(Default)]
    pub struct AidingMeasurementControlResponse {
        /// The source; `all` is for save, load and default.
        pub aiding_source: AidingSource,
        /// Whether the filter uses the source.
        pub enable: crate::Bool,
    }
}

field! {
    AidingMeasurementControlResponse: 0x0D, 0xD0, "filter.aiding_measurement_control_response";
    answers AidingMeasurementControl;
}

record! {
    /// Navigation filter initialization response (0x0D,0xD2).
    ///
    /// Answers [`NavigationFilterInitialization`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52).
    #[derive(Default)]
    pub struct NavigationFilterInitializationResponse {
        /// 1: the filter starts only after `run_navigation_filter`; 0: as soon as it can.
        ///
        /// Range: 0 to 1.
        pub wait_for_run_command: u8,
        /// Which initial conditions are found and which are given.
        pub initial_cond_src: InitialConditionSource,
        /// Ways in which the initial heading may be found.
        pub auto_heading_alignment_selector: HeadingAlignment,
        /// Given heading.
        ///
        /// Unit: deg.
        pub initial_heading: f32,
        /// Given pitch.
        ///
        /// Unit: deg.
        pub initial_pitch: f32,
        /// Given roll.
        ///
        /// Unit: deg.
        pub initial_roll: f32,
        /// Given position.
        ///
        /// Elements: x, y, z. If `reference_frame_selector` is [`ReferenceFrame::ECEF`]: unit m;
        /// frame ecef. If `reference_frame_selector` is [`ReferenceFrame::LLH`]: unit deg, deg, m;
        /// frame llh.
        pub initial_position: types::Vector3f,
        /// Given velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. If `reference_frame_selector` is [`ReferenceFrame::ECEF`]:
        /// frame ecef. If `reference_frame_selector` is [`ReferenceFrame::LLH`]: frame ned.
        pub initial_velocity: types::Vector3f,
        /// Frame of the given position and velocity.
        pub reference_frame_selector: ReferenceFrame,
    }
}

field! {
    NavigationFilterInitializationResponse: 0x0D, 0xD2, "filter.navigation_filter_initialization_response";
    answers NavigationFilterInitialization;
}

record! {
    /// Adaptive filter control response (0x0D,0xD3).
    ///
    /// Answers [`AdaptiveFilterControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53).
    #[derive(Default)]
    pub struct AdaptiveFilterControlResponse {
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

field! {
    AdaptiveFilterControlResponse: 0x0D, 0xD3, "filter.adaptive_filter_control_response";
    answers AdaptiveFilterControl;
}

record! {
    /// GNSS multi-antenna offset response (0x0D,0xD4).
    ///
    /// Answers [`GnssMultiAntennaOffsetControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54).
    #[derive(Default)]
    pub struct GnssMultiAntennaOffsetControlResponse {
        /// Number of the receiver, from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: u8,
        /// From the sensor to the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: -10 to 10.
        pub antenna_offset: types::Vector3f,
    }
}

field! {
    GnssMultiAntennaOffsetControlResponse: 0x0D, 0xD4, "filter.gnss_multi_antenna_offset_control_response";
    answers GnssMultiAntennaOffsetControl;
}

record! {
    /// Relative position configuration response (0x0D,0xD5).
    ///
    /// Answers [`RelativePositionConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55).
    #[derive(Default)]
    pub struct RelativePositionConfigurationResponse {
        /// Source of the reference point.
        pub source: RelativePositionSource,
        /// Frame of the coordinates.
        pub reference_frame_selector: ReferenceFrame,
        /// Reference point.
        ///
        /// Elements: x, y, z. If `reference_frame_selector` is [`ReferenceFrame::ECEF`]: unit m;
        /// frame ecef. If `reference_frame_selector` is [`ReferenceFrame::LLH`]: unit deg, deg, m;
        /// frame llh.
        pub reference_coordinates: types::Vector3d,
    }
}

field! {
    RelativePositionConfigurationResponse: 0x0D, 0xD5, "filter.relative_position_configuration_response";
    answers RelativePositionConfiguration;
}

record! {
    /// Reference point lever arm response (0x0D,0xD6).
    ///
    /// Answers [`ReferencePointLeverArm`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56).
    #[derive(Default)]
    pub struct ReferencePointLeverArmResponse {
        /// Point to move; it must be 1.
        pub ref_point_sel: ReferencePoint,
        /// From the sensor to the point.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle. Range: -10 to 10.
        pub lever_arm_offset: types::Vector3f,
    }
}

field! {
    ReferencePointLeverArmResponse: 0x0D, 0xD6, "filter.reference_point_lever_arm_response";
    answers ReferencePointLeverArm;
}

record! {
    /// Speed measurement lever arm response (0x0D,0xE1).
    ///
    /// Answers [`MeasurementSpeedLeverArm`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61).
    pub struct MeasurementSpeedLeverArmResponse {
        /// Send 1.
        ///
        /// Reserved.
        pub source: u8,
        /// From the sensor to the point of measurement.
        ///
        /// Elements: x, y, z. Unit: m. Frame: vehicle.
        pub lever_arm_offset: types::Vector3f,
    }
}

#[rustfmt::skip]
impl core::default::Default for MeasurementSpeedLeverArmResponse {
    fn default() -> Self {
        Self {
            source: 1,
            lever_arm_offset: core::default::Default::default(),
        }
    }
}

field! {
    MeasurementSpeedLeverArmResponse: 0x0D, 0xE1, "filter.measurement_speed_lever_arm_response";
    answers MeasurementSpeedLeverArm;
}

record! {
    /// Wheeled vehicle constraint response (0x0D,0xE3).
    ///
    /// Answers [`WheeledVehicleConstraintControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63).
    #[derive(Default)]
    pub struct WheeledVehicleConstraintControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
    }
}

field! {
    WheeledVehicleConstraintControlResponse: 0x0D, 0xE3, "filter.wheeled_vehicle_constraint_control_response";
    answers WheeledVehicleConstraintControl;
}

record! {
    /// GNSS antenna offset calibration response (0x0D,0xE4).
    ///
    /// Answers [`GnssAntennaOffsetCalibrationControl`]. Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64);
    /// 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration.
    #[derive(Default)]
    pub struct GnssAntennaOffsetCalibrationControlResponse {
        /// 0 disables, 1 enables.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Largest absolute error that is tracked; the limits are those of the 3DM-CV7.
        ///
        /// Unit: m. Frame: vehicle. Range: 0 to 0.5. Default: 0.1.
        pub max_offset: f32,
    }
}

field! {
    GnssAntennaOffsetCalibrationControlResponse: 0x0D, 0xE4, "filter.gnss_antenna_offset_calibration_control_response";
    answers GnssAntennaOffsetCalibrationControl;
}
