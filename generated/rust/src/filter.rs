//! Filter commands (0x0D): Commands that set up, start and aid the navigation filter.
//!
//! - Manual 3dm-gx5-15: 4.3 Estimation Filter Commands
//! - Manual 3dm-cv7-gnss-ins: Filter (0x0D)

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x0D;

open_enum! {
    /// Kind of vehicle that the filter is tuned for.
    ///
    /// - Manual mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
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
    EstimatedStates: u16 {
        /// Estimate the gyroscope bias (recommended).
        GYRO_BIAS: bool = 0,
            "gyro_bias", gyro_bias, set_gyro_bias, with_gyro_bias;
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
        /// Tare roll.
        ROLL: bool = 0,
            "roll", roll, set_roll, with_roll;
        /// Tare pitch.
        PITCH: bool = 1,
            "pitch", pitch, set_pitch, with_pitch;
        /// Tare yaw.
        YAW: bool = 2,
            "yaw", yaw, set_yaw, with_yaw;
    }
}

bitfield! {
    /// Measurements that the filter uses.
    MeasurementFlags: u16 {
        /// Accelerometer measurements.
        ACCELEROMETER: bool = 0,
            "accelerometer", accelerometer, set_accelerometer, with_accelerometer;
        /// Magnetometer measurements, on models that have a magnetometer.
        MAGNETOMETER: bool = 1,
            "magnetometer", magnetometer, set_magnetometer, with_magnetometer;
    }
}

open_enum! {
    /// Where the declination, the inclination or the magnitude of the magnetic field comes from.
    MagParameterSource: u8 {
        /// No source.
        NONE = 1, "none";
        /// The World Magnetic Model, at the estimated position.
        WMM = 2, "wmm";
        /// The value that the command gives.
        MANUAL = 3, "manual";
    }
}

open_enum! {
    /// How measurements are weighted whose magnitude is not as expected.
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
    /// What aids the altitude.
    ///
    /// - Manual mip-sdk-4: Altitude Aiding (0x0D,0x47)
    AltitudeAidingSource: u8 {
        /// No aiding.
        NONE = 0, "none";
        /// The pressure sensor.
        PRESSURE = 1, "pressure";
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
    /// What the filter assumes about the acceleration.
    ///
    /// - Manual mip-sdk-4: Kinematic Constraint (0x0D,0x51)
    AccelConstraint: u8 {
        /// Nothing.
        NONE = 0, "none";
        /// It is zero.
        ZERO_ACCEL = 1, "zero_accel";
    }
}

open_enum! {
    /// What the filter assumes about the velocity.
    ///
    /// - Manual mip-sdk-4: Kinematic Constraint (0x0D,0x51)
    VelocityConstraint: u8 {
        /// Nothing.
        NONE = 0, "none";
        /// It is zero.
        ZERO_VELOCITY = 1, "zero_velocity";
        /// It is that of a wheeled vehicle.
        WHEELED_VEHICLE = 2, "wheeled_vehicle";
    }
}

open_enum! {
    /// What the filter assumes about the angular rate.
    ///
    /// - Manual mip-sdk-4: Kinematic Constraint (0x0D,0x51)
    AngularConstraint: u8 {
        /// Nothing.
        NONE = 0, "none";
        /// It is zero.
        ZERO_ANGULAR_RATE = 1, "zero_angular_rate";
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
        /// From the baseline between two GNSS antennas.
        DUAL_ANTENNA: bool = 0,
            "dual_antenna", dual_antenna, set_dual_antenna, with_dual_antenna;
        /// From the GNSS velocity; assumes motion along the positive x axis of the vehicle.
        KINEMATIC: bool = 1,
            "kinematic", kinematic, set_kinematic, with_kinematic;
        /// From the built-in magnetometer.
        MAGNETOMETER: bool = 2,
            "magnetometer", magnetometer, set_magnetometer, with_magnetometer;
        /// From the heading that the user sends.
        EXTERNAL: bool = 3,
            "external", external, set_external, with_external;
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

/// Reset navigation filter (0x0D,0x01).
///
/// Puts the filter back into its initialization state.
///
/// - If automatic initialization is off, the attitude or heading must be set before the filter runs
///   again.
/// - 3DM-CV7: send it after a large jump of the system time, for example when the PPS is first
///   found.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Reset Navigation Filter (0x0D,0x01)
/// - Manual 3dm-gx5-15: 4.3.1 Reset Filter (0x0D, 0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ResetNavigationFilter;

impl ResetNavigationFilter {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for ResetNavigationFilter {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for ResetNavigationFilter {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "filter.reset_navigation_filter";
}

impl Command for ResetNavigationFilter {
    type Response = ();
}

/// Set initial attitude (0x0D,0x02).
///
/// Gives the filter its initial attitude, the orientation of the sensor frame in the NED frame.
///
/// - Accepted only in the initialization state.
///
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.2 Set Initial Attitude (0x0D, 0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetInitialAttitude {
    /// Roll angle.
    ///
    /// Unit: rad; frame: ned; range: -3.141592653589793 to 3.141592653589793.
    pub roll: f32,
    /// Pitch angle.
    ///
    /// Unit: rad; frame: ned; range: -1.5707963267948966 to 1.5707963267948966.
    pub pitch: f32,
    /// Heading (yaw) angle.
    ///
    /// Unit: rad; frame: ned; range: -3.141592653589793 to 3.141592653589793.
    pub heading: f32,
}

impl SetInitialAttitude {
    /// The command with its parameters.
    #[must_use]
    pub fn new(roll: f32, pitch: f32, heading: f32) -> Self {
        Self { roll, pitch, heading }
    }
}

impl Wire for SetInitialAttitude {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let roll = reader.read()?;
        let pitch = reader.read()?;
        let heading = reader.read()?;
        Ok(Self { roll, pitch, heading })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.roll)?;
        writer.write(&self.pitch)?;
        writer.write(&self.heading)?;
        Ok(())
    }
}

impl Field for SetInitialAttitude {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "filter.set_initial_attitude";
}

impl Command for SetInitialAttitude {
    type Response = ();
}

/// Set initial heading (0x0D,0x03).
///
/// Gives the filter its initial heading; pitch and roll come from the accelerometers.
///
/// - 3DM-GX5: accepted only in the initialization state.
/// - 3DM-CV7: resets the estimated heading; if magnetometer aiding is on, the given heading is
///   ignored.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Set Initial Heading Control (0x0D,0x03)
/// - Manual 3dm-gx5-15: 4.3.3 Set Initial Heading (0x0D, 0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetInitialHeadingControl {
    /// Initial heading.
    ///
    /// Unit: rad; frame: ned; range: -3.141592653589793 to 3.141592653589793.
    pub heading: f32,
}

impl SetInitialHeadingControl {
    /// The command with its parameters.
    #[must_use]
    pub fn new(heading: f32) -> Self {
        Self { heading }
    }
}

impl Wire for SetInitialHeadingControl {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let heading = reader.read()?;
        Ok(Self { heading })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.heading)?;
        Ok(())
    }
}

impl Field for SetInitialHeadingControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "filter.set_initial_heading_control";
}

impl Command for SetInitialHeadingControl {
    type Response = ();
}

/// Run navigation filter (0x0D,0x05).
///
/// Starts a filter that was set up to wait for this command.
///
/// - The filter waits in its initialization state if `wait_for_run_command` of
///   `navigation_filter_initialization` is set.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Run Navigation Filter (0x0D,0x05)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RunNavigationFilter;

impl RunNavigationFilter {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for RunNavigationFilter {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for RunNavigationFilter {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x05;
    const NAME: &'static str = "filter.run_navigation_filter";
}

impl Command for RunNavigationFilter {
    type Response = ();
}

/// Vehicle dynamics mode (0x0D,0x10).
///
/// Kind of vehicle that the filter is tuned for.
///
/// Functions: write, read, save, load, default. Response: [`VehicleDynamicsModeResponse`].
///
/// - Manual mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VehicleDynamicsMode {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Kind of vehicle.
    pub mode: Option<DynamicsMode>,
}

impl VehicleDynamicsMode {
    /// Apply the new setting.
    #[must_use]
    pub fn write(mode: DynamicsMode) -> Self {
        Self { function: types::FunctionSelector::WRITE, mode: Some(mode) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, mode: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, mode: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, mode: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, mode: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for VehicleDynamicsMode {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let mode = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.mode)?;
        Ok(())
    }
}

impl Field for VehicleDynamicsMode {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x10;
    const NAME: &'static str = "filter.vehicle_dynamics_mode";
}

impl Command for VehicleDynamicsMode {
    type Response = VehicleDynamicsModeResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<VehicleDynamicsMode> for VehicleDynamicsModeResponse {}

/// Sensor to vehicle frame transformation (0x0D,0x11).
///
/// Euler angles of the rotation from the sensor frame to the vehicle frame (5-series).
///
/// - It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
///   velocity, and the orientation, compensated and linear acceleration, angular rate and gravity
///   vector of the filter.
/// - The 3DM-CV7 takes the inverse instead: `3dm.sensor_to_vehicle_frame_transformation_euler`.
///
/// Functions: write, read, save, load, default. Response:
/// [`SensorToVehicleFrameTransformationResponse`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformation {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Roll angle.
    ///
    /// Unit: rad.
    pub roll: Option<f32>,
    /// Pitch angle.
    ///
    /// Unit: rad.
    pub pitch: Option<f32>,
    /// Yaw angle.
    ///
    /// Unit: rad.
    pub yaw: Option<f32>,
}

impl SensorToVehicleFrameTransformation {
    /// Apply the new setting.
    #[must_use]
    pub fn write(roll: f32, pitch: f32, yaw: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            roll: Some(roll),
            pitch: Some(pitch),
            yaw: Some(yaw),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, roll: None, pitch: None, yaw: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, roll: None, pitch: None, yaw: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, roll: None, pitch: None, yaw: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, roll: None, pitch: None, yaw: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for SensorToVehicleFrameTransformation {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let roll = reader.group(required >= 1, Reader::read)?;
        let pitch = reader.group(required >= 2, Reader::read)?;
        let yaw = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, roll, pitch, yaw })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.roll)?;
        writer.some(required >= 2, &self.pitch)?;
        writer.some(required >= 3, &self.yaw)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformation {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x11;
    const NAME: &'static str = "filter.sensor_to_vehicle_frame_transformation";
}

impl Command for SensorToVehicleFrameTransformation {
    type Response = SensorToVehicleFrameTransformationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleFrameTransformation> for SensorToVehicleFrameTransformationResponse {}

/// Sensor to vehicle offset (0x0D,0x12).
///
/// Origin of the vehicle frame, as seen from the sensor.
///
/// - It shifts the estimated position (0x82,0x01) and nothing else.
/// - The shift is constant. It does not follow the attitude, as a lever arm would.
/// - The magnitude of the vector is limited to 10 m.
///
/// Functions: write, read, save, load, default. Response: [`SensorToVehicleOffsetResponse`].
///
/// - Manual mip-sdk-4: Sensor To Vehicle Offset (0x0D,0x12)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleOffset {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// From the sensor to the origin of the vehicle frame.
    ///
    /// Unit: m; frame: sensor; range: -10 to 10.
    pub offset: Option<types::Vector3f>,
}

impl SensorToVehicleOffset {
    /// Apply the new setting.
    #[must_use]
    pub fn write(offset: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, offset: Some(offset.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, offset: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, offset: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, offset: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, offset: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for SensorToVehicleOffset {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let offset = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.offset)?;
        Ok(())
    }
}

impl Field for SensorToVehicleOffset {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x12;
    const NAME: &'static str = "filter.sensor_to_vehicle_offset";
}

impl Command for SensorToVehicleOffset {
    type Response = SensorToVehicleOffsetResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleOffset> for SensorToVehicleOffsetResponse {}

/// GNSS antenna offset (0x0D,0x13).
///
/// Position of the GNSS antenna relative to the origin of the sensor.
///
/// - The magnitude of the vector is limited to 10.
/// - 7-series devices expect the vehicle frame, 5-series devices the sensor frame.
/// - On the 3DM-CV7 it is for GNSS data that come as NMEA; data that come by the aiding commands
///   use `aiding.frame_configuration`.
///
/// Functions: write, read, save, load, default. Response: [`GnssAntennaOffsetControlResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAntennaOffsetControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// From the sensor origin to the centre of the antenna.
    ///
    /// Unit: m; frame: vehicle; range: -10 to 10.
    pub offset: Option<types::Vector3f>,
}

impl GnssAntennaOffsetControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(offset: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, offset: Some(offset.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, offset: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, offset: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, offset: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, offset: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for GnssAntennaOffsetControl {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let offset = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.offset)?;
        Ok(())
    }
}

impl Field for GnssAntennaOffsetControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x13;
    const NAME: &'static str = "filter.gnss_antenna_offset_control";
}

impl Command for GnssAntennaOffsetControl {
    type Response = GnssAntennaOffsetControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssAntennaOffsetControl> for GnssAntennaOffsetControlResponse {}

/// Estimation control flags (0x0D,0x14).
///
/// Which states the filter estimates.
///
/// Functions: write, read, save, load, default. Response: [`EstimationControlFlagsResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EstimationControlFlags {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// States to estimate.
    pub flags: Option<EstimatedStates>,
}

impl EstimationControlFlags {
    /// Apply the new setting.
    #[must_use]
    pub fn write(flags: EstimatedStates) -> Self {
        Self { function: types::FunctionSelector::WRITE, flags: Some(flags) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, flags: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, flags: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, flags: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, flags: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for EstimationControlFlags {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let flags = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.flags)?;
        Ok(())
    }
}

impl Field for EstimationControlFlags {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x14;
    const NAME: &'static str = "filter.estimation_control_flags";
}

impl Command for EstimationControlFlags {
    type Response = EstimationControlFlagsResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<EstimationControlFlags> for EstimationControlFlagsResponse {}

/// GNSS aiding source (0x0D,0x15).
///
/// Which GNSS receiver aids the filter.
///
/// - A change while the filter runs may put it back into initialization until the new source gives
///   data.
///
/// Functions: write, read, save, load, default. Response: [`GnssAidingSourceControlResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAidingSourceControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the GNSS data.
    pub source: Option<GnssAidingSource>,
}

impl GnssAidingSourceControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(source: GnssAidingSource) -> Self {
        Self { function: types::FunctionSelector::WRITE, source: Some(source) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, source: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, source: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, source: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, source: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for GnssAidingSourceControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, source })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        Ok(())
    }
}

impl Field for GnssAidingSourceControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x15;
    const NAME: &'static str = "filter.gnss_aiding_source_control";
}

impl Command for GnssAidingSourceControl {
    type Response = GnssAidingSourceControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssAidingSourceControl> for GnssAidingSourceControlResponse {}

/// External GNSS update (0x0D,0x16).
///
/// Gives the filter one position and velocity of a GNSS receiver that the user provides.
///
/// - Refused unless the GNSS aiding source (0x0D,0x15) is the external one.
/// - The highest rate depends on the device.
/// - Manual mip-sdk-4: External Gnss Update (0x0D,0x16)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExternalGnssUpdate {
    /// GPS time of week.
    ///
    /// Unit: s.
    pub tow: f64,
    /// GPS week, counted without rollover.
    ///
    /// Unit: week.
    pub week_number: u16,
    /// Latitude.
    ///
    /// Unit: deg; frame: llh.
    pub latitude: f64,
    /// Longitude.
    ///
    /// Unit: deg; frame: llh.
    pub longitude: f64,
    /// Height above the ellipsoid.
    ///
    /// Unit: m; frame: llh.
    pub height: f64,
    /// Velocity.
    ///
    /// Unit: m/s; frame: ned.
    pub velocity: types::Vector3f,
    /// Standard deviation of the position.
    ///
    /// Unit: m; frame: ned.
    pub position_uncertainty: types::Vector3f,
    /// Standard deviation of the velocity.
    ///
    /// Unit: m/s; frame: ned.
    pub velocity_uncertainty: types::Vector3f,
}

impl ExternalGnssUpdate {
    /// The command with its parameters.
    #[must_use]
    #[allow(clippy::too_many_arguments)]
    pub fn new(
        tow: f64,
        week_number: u16,
        latitude: f64,
        longitude: f64,
        height: f64,
        velocity: impl Into<types::Vector3f>,
        position_uncertainty: impl Into<types::Vector3f>,
        velocity_uncertainty: impl Into<types::Vector3f>,
    ) -> Self {
        Self {
            tow,
            week_number,
            latitude,
            longitude,
            height,
            velocity: velocity.into(),
            position_uncertainty: position_uncertainty.into(),
            velocity_uncertainty: velocity_uncertainty.into(),
        }
    }
}

impl Wire for ExternalGnssUpdate {
    const SIZE: usize = 70;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let tow = reader.read()?;
        let week_number = reader.read()?;
        let latitude = reader.read()?;
        let longitude = reader.read()?;
        let height = reader.read()?;
        let velocity = reader.read()?;
        let position_uncertainty = reader.read()?;
        let velocity_uncertainty = reader.read()?;
        Ok(Self {
            tow,
            week_number,
            latitude,
            longitude,
            height,
            velocity,
            position_uncertainty,
            velocity_uncertainty,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.tow)?;
        writer.write(&self.week_number)?;
        writer.write(&self.latitude)?;
        writer.write(&self.longitude)?;
        writer.write(&self.height)?;
        writer.write(&self.velocity)?;
        writer.write(&self.position_uncertainty)?;
        writer.write(&self.velocity_uncertainty)?;
        Ok(())
    }
}

impl Field for ExternalGnssUpdate {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x16;
    const NAME: &'static str = "filter.external_gnss_update";
}

impl Command for ExternalGnssUpdate {
    type Response = ();
}

/// External heading update (0x0D,0x17).
///
/// Gives the filter one measurement of the heading of the sensor frame in the NED frame.
///
/// - Refused unless external heading updates are enabled, by `heading_update_control` on the
///   3DM-GX5 and by `aiding_measurement_control` on the 3DM-CV7.
/// - The 3DM-GX5-15 takes at most 20 updates per second.
/// - If the declination source is not valid, -25 models refuse true headings and -45 models
///   magnetic ones.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: External Heading Update (0x0D,0x17)
/// - Manual 3dm-gx5-15: 4.3.7 External Heading Update (0x0D, 0x17)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExternalHeadingUpdate {
    /// Heading relative to the north that `type` names.
    ///
    /// Unit: rad; frame: ned; range: -3.141592653589793 to 3.141592653589793.
    pub heading: f32,
    /// Standard deviation; the device refuses a value out of bounds.
    ///
    /// Unit: rad.
    pub heading_uncertainty: f32,
    /// North that the heading refers to.
    pub type_: HeadingType,
}

impl ExternalHeadingUpdate {
    /// The command with its parameters.
    #[must_use]
    pub fn new(heading: f32, heading_uncertainty: f32, type_: HeadingType) -> Self {
        Self { heading, heading_uncertainty, type_ }
    }
}

impl Wire for ExternalHeadingUpdate {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let heading = reader.read()?;
        let heading_uncertainty = reader.read()?;
        let type_ = reader.read()?;
        Ok(Self { heading, heading_uncertainty, type_ })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.heading)?;
        writer.write(&self.heading_uncertainty)?;
        writer.write(&self.type_)?;
        Ok(())
    }
}

impl Field for ExternalHeadingUpdate {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x17;
    const NAME: &'static str = "filter.external_heading_update";
}

impl Command for ExternalHeadingUpdate {
    type Response = ();
}

/// Heading update control (0x0D,0x18).
///
/// Source of the heading that aids the filter.
///
/// Functions: write, read, save, load, default. Response: [`HeadingUpdateControlResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HeadingUpdateControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the heading.
    pub enable: Option<HeadingUpdateSource>,
}

impl HeadingUpdateControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: HeadingUpdateSource) -> Self {
        Self { function: types::FunctionSelector::WRITE, enable: Some(enable) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for HeadingUpdateControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        Ok(())
    }
}

impl Field for HeadingUpdateControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x18;
    const NAME: &'static str = "filter.heading_update_control";
}

impl Command for HeadingUpdateControl {
    type Response = HeadingUpdateControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<HeadingUpdateControl> for HeadingUpdateControlResponse {}

/// Automatic initialization (0x0D,0x19).
///
/// Whether the filter initializes by itself when the device starts.
///
/// - It needs a valid heading source.
///
/// Functions: write, read, save, load, default. Response: [`AutoInitializationControlResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AutoInitializationControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
}

impl AutoInitializationControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8) -> Self {
        Self { function: types::FunctionSelector::WRITE, enable: Some(enable) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for AutoInitializationControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        Ok(())
    }
}

impl Field for AutoInitializationControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x19;
    const NAME: &'static str = "filter.auto_initialization_control";
}

impl Command for AutoInitializationControl {
    type Response = AutoInitializationControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AutoInitializationControl> for AutoInitializationControlResponse {}

/// Accelerometer noise (0x0D,0x1A).
///
/// Standard deviation of the accelerometer noise that the filter assumes (process noise).
///
/// - The factory values suit most laboratory conditions.
///
/// Functions: write, read, save, load, default. Response:
/// [`AccelerometerNoiseStandardDeviationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
/// - Manual 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AccelerometerNoiseStandardDeviation {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation per axis.
    ///
    /// Unit: m/s^2.
    pub noise: Option<types::Vector3f>,
}

impl AccelerometerNoiseStandardDeviation {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for AccelerometerNoiseStandardDeviation {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for AccelerometerNoiseStandardDeviation {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x1A;
    const NAME: &'static str = "filter.accelerometer_noise_standard_deviation";
}

impl Command for AccelerometerNoiseStandardDeviation {
    type Response = AccelerometerNoiseStandardDeviationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AccelerometerNoiseStandardDeviation>
    for AccelerometerNoiseStandardDeviationResponse
{
}

/// Gyroscope noise (0x0D,0x1B).
///
/// Standard deviation of the gyroscope noise that the filter assumes (process noise).
///
/// - The factory values suit most laboratory conditions.
///
/// Functions: write, read, save, load, default. Response:
/// [`GyroscopeNoiseStandardDeviationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
/// - Manual 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GyroscopeNoiseStandardDeviation {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation per axis.
    ///
    /// Unit: rad/s.
    pub noise: Option<types::Vector3f>,
}

impl GyroscopeNoiseStandardDeviation {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for GyroscopeNoiseStandardDeviation {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for GyroscopeNoiseStandardDeviation {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x1B;
    const NAME: &'static str = "filter.gyroscope_noise_standard_deviation";
}

impl Command for GyroscopeNoiseStandardDeviation {
    type Response = GyroscopeNoiseStandardDeviationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GyroscopeNoiseStandardDeviation> for GyroscopeNoiseStandardDeviationResponse {}

/// Accelerometer bias model (0x0D,0x1C).
///
/// Parameters of the model by which the accelerometer bias drifts.
///
/// Functions: write, read, save, load, default. Response:
/// [`AccelerometerBiasModelParametersResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AccelerometerBiasModelParameters {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Reciprocal of the correlation time per axis.
    ///
    /// Unit: 1/s.
    pub beta: Option<types::Vector3f>,
    /// Standard deviation of the noise per axis.
    ///
    /// Unit: m/s^2.
    pub noise: Option<types::Vector3f>,
}

impl AccelerometerBiasModelParameters {
    /// Apply the new setting.
    #[must_use]
    pub fn write(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            beta: Some(beta.into()),
            noise: Some(noise.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, beta: None, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, beta: None, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, beta: None, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, beta: None, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for AccelerometerBiasModelParameters {
    const SIZE: usize = 25;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let beta = reader.group(required >= 1, Reader::read)?;
        let noise = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, beta, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.beta)?;
        writer.some(required >= 2, &self.noise)?;
        Ok(())
    }
}

impl Field for AccelerometerBiasModelParameters {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x1C;
    const NAME: &'static str = "filter.accelerometer_bias_model_parameters";
}

impl Command for AccelerometerBiasModelParameters {
    type Response = AccelerometerBiasModelParametersResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AccelerometerBiasModelParameters> for AccelerometerBiasModelParametersResponse {}

/// Gyroscope bias model (0x0D,0x1D).
///
/// Parameters of the model by which the gyroscope bias drifts.
///
/// Functions: write, read, save, load, default. Response: [`GyroscopeBiasModelParametersResponse`].
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
/// - Manual 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GyroscopeBiasModelParameters {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Reciprocal of the correlation time per axis.
    ///
    /// Unit: 1/s.
    pub beta: Option<types::Vector3f>,
    /// Standard deviation of the noise per axis.
    ///
    /// Unit: rad/s.
    pub noise: Option<types::Vector3f>,
}

impl GyroscopeBiasModelParameters {
    /// Apply the new setting.
    #[must_use]
    pub fn write(beta: impl Into<types::Vector3f>, noise: impl Into<types::Vector3f>) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            beta: Some(beta.into()),
            noise: Some(noise.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, beta: None, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, beta: None, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, beta: None, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, beta: None, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for GyroscopeBiasModelParameters {
    const SIZE: usize = 25;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let beta = reader.group(required >= 1, Reader::read)?;
        let noise = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, beta, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.beta)?;
        writer.some(required >= 2, &self.noise)?;
        Ok(())
    }
}

impl Field for GyroscopeBiasModelParameters {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x1D;
    const NAME: &'static str = "filter.gyroscope_bias_model_parameters";
}

impl Command for GyroscopeBiasModelParameters {
    type Response = GyroscopeBiasModelParametersResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GyroscopeBiasModelParameters> for GyroscopeBiasModelParametersResponse {}

/// Automatic zero velocity update (0x0D,0x1E).
///
/// Lets the filter take the device as standing still while its GNSS speed is small.
///
/// - The update applies while the magnitude of the GNSS velocity vector is at or below the
///   threshold.
/// - The device refuses a negative threshold.
///
/// Functions: write, read, save, load, default. Response: [`AutoZuptResponse`].
///
/// - Manual mip-sdk-4: Auto Zupt (0x0D,0x1E)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AutoZupt {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
    /// Largest speed that is taken as zero.
    ///
    /// Unit: m/s; range: at least 0.
    pub threshold: Option<f32>,
}

impl AutoZupt {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8, threshold: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable),
            threshold: Some(threshold),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None, threshold: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None, threshold: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None, threshold: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None, threshold: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for AutoZupt {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let threshold = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, enable, threshold })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.threshold)?;
        Ok(())
    }
}

impl Field for AutoZupt {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x1E;
    const NAME: &'static str = "filter.auto_zupt";
}

impl Command for AutoZupt {
    type Response = AutoZuptResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AutoZupt> for AutoZuptResponse {}

/// External heading update with time (0x0D,0x1F).
///
/// Gives the filter one measurement of the heading of the sensor frame with its GPS time.
///
/// - Better than `external_heading_update` where the heading changes quickly; the time must be
///   accurate.
/// - Refused unless external heading updates are enabled, by `heading_update_control` on the
///   3DM-GX5 and by `aiding_measurement_control` on the 3DM-CV7.
/// - The 3DM-GX5-15 takes at most 20 updates per second.
/// - If the declination source is not valid, -25 models refuse true headings and -45 models
///   magnetic ones.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: External Heading Update With Time (0x0D,0x1F)
/// - Manual 3dm-gx5-15: 4.3.8 External Heading Update with Timestamp (0x0D, 0x1F)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    /// Unit: rad; frame: ned; range: -3.141592653589793 to 3.141592653589793.
    pub heading: f32,
    /// Standard deviation; the device refuses a value out of bounds.
    ///
    /// Unit: rad.
    pub heading_uncertainty: f32,
    /// North that the heading refers to.
    pub type_: HeadingType,
}

impl ExternalHeadingUpdateWithTime {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        gps_time: f64,
        gps_week: u16,
        heading: f32,
        heading_uncertainty: f32,
        type_: HeadingType,
    ) -> Self {
        Self { gps_time, gps_week, heading, heading_uncertainty, type_ }
    }
}

impl Wire for ExternalHeadingUpdateWithTime {
    const SIZE: usize = 19;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let gps_time = reader.read()?;
        let gps_week = reader.read()?;
        let heading = reader.read()?;
        let heading_uncertainty = reader.read()?;
        let type_ = reader.read()?;
        Ok(Self { gps_time, gps_week, heading, heading_uncertainty, type_ })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.gps_time)?;
        writer.write(&self.gps_week)?;
        writer.write(&self.heading)?;
        writer.write(&self.heading_uncertainty)?;
        writer.write(&self.type_)?;
        Ok(())
    }
}

impl Field for ExternalHeadingUpdateWithTime {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x1F;
    const NAME: &'static str = "filter.external_heading_update_with_time";
}

impl Command for ExternalHeadingUpdateWithTime {
    type Response = ();
}

/// Zero angular rate update (0x0D,0x20).
///
/// Lets the filter take the device as not rotating while its angular rate is small.
///
/// - The update applies while the magnitude of the angular rate vector is at or below the
///   threshold.
///
/// Functions: write, read, save, load, default. Response: [`ZeroAngularRateUpdateControlResponse`].
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
/// - Manual 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZeroAngularRateUpdateControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
    /// Largest angular rate that is taken as zero.
    ///
    /// Unit: rad/s; range: at least 0.
    pub threshold: Option<f32>,
}

impl ZeroAngularRateUpdateControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8, threshold: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable),
            threshold: Some(threshold),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None, threshold: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None, threshold: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None, threshold: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None, threshold: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for ZeroAngularRateUpdateControl {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let threshold = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, enable, threshold })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.threshold)?;
        Ok(())
    }
}

impl Field for ZeroAngularRateUpdateControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x20;
    const NAME: &'static str = "filter.zero_angular_rate_update_control";
}

impl Command for ZeroAngularRateUpdateControl {
    type Response = ZeroAngularRateUpdateControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ZeroAngularRateUpdateControl> for ZeroAngularRateUpdateControlResponse {}

/// Tare orientation (0x0D,0x21).
///
/// Makes the present orientation in the NED frame the sensor-to-vehicle transformation.
///
/// - Refused while the filter has no valid attitude.
///
/// Functions: write, read, save, load, default. Response: [`TareOrientationResponse`]. Supported by
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
/// - Manual mip-sdk-4: Tare Orientation (0x0D,0x21)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TareOrientation {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Axes to tare; 0 resets all axes.
    pub axes: Option<TareAxes>,
}

impl TareOrientation {
    /// Apply the new setting.
    #[must_use]
    pub fn write(axes: TareAxes) -> Self {
        Self { function: types::FunctionSelector::WRITE, axes: Some(axes) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, axes: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, axes: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, axes: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, axes: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for TareOrientation {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let axes = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, axes })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.axes)?;
        Ok(())
    }
}

impl Field for TareOrientation {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x21;
    const NAME: &'static str = "filter.tare_orientation";
}

impl Command for TareOrientation {
    type Response = TareOrientationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<TareOrientation> for TareOrientationResponse {}

/// Commanded zero velocity update (0x0D,0x22).
///
/// Tells the filter once that the device stands still.
///
/// - The highest rate depends on the device.
/// - Manual mip-sdk-4: Commanded Zupt (0x0D,0x22)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CommandedZupt;

impl CommandedZupt {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for CommandedZupt {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for CommandedZupt {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x22;
    const NAME: &'static str = "filter.commanded_zupt";
}

impl Command for CommandedZupt {
    type Response = ();
}

/// Commanded zero angular rate update (0x0D,0x23).
///
/// Tells the filter once that the device is not rotating.
///
/// - At most 10 per second.
///
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.17 Commanded Zero-Angular Rate Update (0x0D, 0x23)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CommandedZeroAngularRateUpdate;

impl CommandedZeroAngularRateUpdate {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for CommandedZeroAngularRateUpdate {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for CommandedZeroAngularRateUpdate {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x23;
    const NAME: &'static str = "filter.commanded_zero_angular_rate_update";
}

impl Command for CommandedZeroAngularRateUpdate {
    type Response = ();
}

/// Set reference position (0x0D,0x26).
///
/// Position for which the device computes gravity (WGS84) and the magnetic field (WMM2015).
///
/// Functions: write, read, save, load, default. Response: [`SetReferencePositionResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetReferencePosition {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
    /// Latitude.
    ///
    /// Unit: deg; frame: llh.
    pub latitude: Option<f64>,
    /// Longitude.
    ///
    /// Unit: deg; frame: llh.
    pub longitude: Option<f64>,
    /// Altitude.
    ///
    /// Unit: m; frame: llh.
    pub altitude: Option<f64>,
}

impl SetReferencePosition {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8, latitude: f64, longitude: f64, altitude: f64) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable),
            latitude: Some(latitude),
            longitude: Some(longitude),
            altitude: Some(altitude),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            enable: None,
            latitude: None,
            longitude: None,
            altitude: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            enable: None,
            latitude: None,
            longitude: None,
            altitude: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            enable: None,
            latitude: None,
            longitude: None,
            altitude: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            enable: None,
            latitude: None,
            longitude: None,
            altitude: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 4,
            _ => 0,
        }
    }
}

impl Wire for SetReferencePosition {
    const SIZE: usize = 26;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let latitude = reader.group(required >= 2, Reader::read)?;
        let longitude = reader.group(required >= 3, Reader::read)?;
        let altitude = reader.group(required >= 4, Reader::read)?;
        Ok(Self { function, enable, latitude, longitude, altitude })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.latitude)?;
        writer.some(required >= 3, &self.longitude)?;
        writer.some(required >= 4, &self.altitude)?;
        Ok(())
    }
}

impl Field for SetReferencePosition {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x26;
    const NAME: &'static str = "filter.set_reference_position";
}

impl Command for SetReferencePosition {
    type Response = SetReferencePositionResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SetReferencePosition> for SetReferencePositionResponse {}

/// Capture automatic magnetometer calibration (0x0D,0x27).
///
/// Makes the automatic magnetometer calibration part of the fixed one.
///
/// - A write combines the automatic calibration with the hard iron offset (0x0C,0x3A) and the soft
///   iron matrix (0x0C,0x3B), and resets it.
/// - A save does the same as the save of both of these commands.
///
/// Functions: write, save.
///
/// - Manual mip-sdk-4: Mag Capture Auto Cal (0x0D,0x27)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagCaptureAutoCal {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
}

impl MagCaptureAutoCal {
    /// Apply the new setting.
    #[must_use]
    pub fn write() -> Self {
        Self { function: types::FunctionSelector::WRITE }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE }
    }
}

impl Wire for MagCaptureAutoCal {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        Ok(Self { function })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.function)?;
        Ok(())
    }
}

impl Field for MagCaptureAutoCal {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x27;
    const NAME: &'static str = "filter.mag_capture_auto_cal";
}

impl Command for MagCaptureAutoCal {
    type Response = ();
}

/// Gravity noise (0x0D,0x28).
///
/// Standard deviation of the gravity noise that the filter assumes (process noise).
///
/// - The factory values suit most laboratory conditions.
///
/// Functions: write, read, save, load, default. Response:
/// [`GravityNoiseStandardDeviationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
/// - Manual 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GravityNoiseStandardDeviation {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation per axis.
    ///
    /// Unit: g.
    pub noise: Option<types::Vector3f>,
}

impl GravityNoiseStandardDeviation {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for GravityNoiseStandardDeviation {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for GravityNoiseStandardDeviation {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x28;
    const NAME: &'static str = "filter.gravity_noise_standard_deviation";
}

impl Command for GravityNoiseStandardDeviation {
    type Response = GravityNoiseStandardDeviationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GravityNoiseStandardDeviation> for GravityNoiseStandardDeviationResponse {}

/// Pressure altitude noise (0x0D,0x29).
///
/// Standard deviation of the noise of the pressure altitude model that the filter assumes.
///
/// - A small value follows the pressure faster, and takes weather and draughts for changes of
///   height.
///
/// Functions: write, read, save, load, default. Response: [`PressureAltitudeNoiseResponse`].
///
/// - Manual mip-sdk-4: Pressure Altitude Noise (0x0D,0x29)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PressureAltitudeNoise {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation.
    ///
    /// Unit: m.
    pub noise: Option<f32>,
}

impl PressureAltitudeNoise {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: f32) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for PressureAltitudeNoise {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for PressureAltitudeNoise {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x29;
    const NAME: &'static str = "filter.pressure_altitude_noise";
}

impl Command for PressureAltitudeNoise {
    type Response = PressureAltitudeNoiseResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<PressureAltitudeNoise> for PressureAltitudeNoiseResponse {}

/// Hard iron offset noise (0x0D,0x2B).
///
/// Standard deviation of the noise of the estimated hard iron offset (process noise).
///
/// Functions: write, read, save, load, default. Response: [`HardIronOffsetNoiseResponse`].
///
/// - Manual mip-sdk-4: Hard Iron Offset Noise (0x0D,0x2B)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HardIronOffsetNoise {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation per axis.
    ///
    /// Unit: gauss.
    pub noise: Option<types::Vector3f>,
}

impl HardIronOffsetNoise {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for HardIronOffsetNoise {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for HardIronOffsetNoise {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x2B;
    const NAME: &'static str = "filter.hard_iron_offset_noise";
}

impl Command for HardIronOffsetNoise {
    type Response = HardIronOffsetNoiseResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<HardIronOffsetNoise> for HardIronOffsetNoiseResponse {}

/// Soft iron matrix noise (0x0D,0x2C).
///
/// Standard deviation of the noise of the estimated soft iron matrix (process noise).
///
/// Functions: write, read, save, load, default. Response: [`SoftIronMatrixNoiseResponse`].
///
/// - Manual mip-sdk-4: Soft Iron Matrix Noise (0x0D,0x2C)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SoftIronMatrixNoise {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation per element.
    ///
    /// Unit: 1.
    pub noise: Option<types::Matrix3f>,
}

impl SoftIronMatrixNoise {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: impl Into<types::Matrix3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for SoftIronMatrixNoise {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for SoftIronMatrixNoise {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x2C;
    const NAME: &'static str = "filter.soft_iron_matrix_noise";
}

impl Command for SoftIronMatrixNoise {
    type Response = SoftIronMatrixNoiseResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SoftIronMatrixNoise> for SoftIronMatrixNoiseResponse {}

/// Enable or disable measurements (0x0D,0x41).
///
/// Which inertial measurements the filter uses.
///
/// Functions: write, read, save, load, default. Response: [`EnableDisableMeasurementsResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EnableDisableMeasurements {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Measurements to use.
    pub control: Option<MeasurementFlags>,
}

impl EnableDisableMeasurements {
    /// Apply the new setting.
    #[must_use]
    pub fn write(control: MeasurementFlags) -> Self {
        Self { function: types::FunctionSelector::WRITE, control: Some(control) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, control: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, control: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, control: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, control: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for EnableDisableMeasurements {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let control = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, control })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.control)?;
        Ok(())
    }
}

impl Field for EnableDisableMeasurements {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x41;
    const NAME: &'static str = "filter.enable_disable_measurements";
}

impl Command for EnableDisableMeasurements {
    type Response = EnableDisableMeasurementsResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<EnableDisableMeasurements> for EnableDisableMeasurementsResponse {}

/// Magnetometer noise (0x0D,0x42).
///
/// Standard deviation of the magnetometer noise that the filter assumes.
///
/// Functions: write, read, save, load, default. Response: [`MagNoiseResponse`].
///
/// - Manual mip-sdk-4: Mag Noise (0x0D,0x42)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagNoise {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Standard deviation per axis.
    ///
    /// Unit: gauss.
    pub noise: Option<types::Vector3f>,
}

impl MagNoise {
    /// Apply the new setting.
    #[must_use]
    pub fn write(noise: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, noise: Some(noise.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, noise: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, noise: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, noise: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, noise: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for MagNoise {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let noise = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.noise)?;
        Ok(())
    }
}

impl Field for MagNoise {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x42;
    const NAME: &'static str = "filter.mag_noise";
}

impl Command for MagNoise {
    type Response = MagNoiseResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagNoise> for MagNoiseResponse {}

/// Magnetic declination source (0x0D,0x43).
///
/// Source of the local declination of the magnetic field.
///
/// - Without a good declination source, keep automatic magnetometer calibration off.
///
/// Functions: write, read, save, load, default. Response:
/// [`MagneticFieldDeclinationSourceControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagneticFieldDeclinationSourceControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the declination.
    pub source: Option<MagParameterSource>,
    /// Declination; used only if `source` is manual.
    ///
    /// Unit: rad.
    pub declination: Option<f32>,
}

impl MagneticFieldDeclinationSourceControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(source: MagParameterSource, declination: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            source: Some(source),
            declination: Some(declination),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, source: None, declination: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, source: None, declination: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, source: None, declination: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, source: None, declination: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for MagneticFieldDeclinationSourceControl {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        let declination = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, source, declination })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        writer.some(required >= 2, &self.declination)?;
        Ok(())
    }
}

impl Field for MagneticFieldDeclinationSourceControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x43;
    const NAME: &'static str = "filter.magnetic_field_declination_source_control";
}

impl Command for MagneticFieldDeclinationSourceControl {
    type Response = MagneticFieldDeclinationSourceControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagneticFieldDeclinationSourceControl>
    for MagneticFieldDeclinationSourceControlResponse
{
}

/// Gravity magnitude error adaptive measurement (0x0D,0x44).
///
/// How far the filter trusts gravity measurements whose magnitude is not that of gravity.
///
/// - Also called accelerometer magnitude error adaptive measurement.
/// - All parameters after the selector keep their values if they are left out.
/// - Filter and limits take effect only with `fixed`.
/// - Raise the limits where vibration is strong, lower them where it is weak. High limits cost
///   pitch and roll accuracy under linear acceleration, low limits cost heading accuracy.
///
/// Functions: write, read, save, load, default. Response:
/// [`GravityMagnitudeErrorAdaptiveMeasurementResponse`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GravityMagnitudeErrorAdaptiveMeasurement {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Kind of adaptation.
    pub adaptive_measurement: Option<AdaptiveMeasurementSelector>,
    /// Cut-off frequency of the low-pass filter.
    ///
    /// Unit: Hz.
    pub frequency: Option<f32>,
    /// Lower limit of the error.
    ///
    /// Unit: m/s^2.
    pub low_limit: Option<f32>,
    /// Upper limit of the error.
    ///
    /// Unit: m/s^2.
    pub high_limit: Option<f32>,
    /// Standard deviation at the lower limit.
    ///
    /// Unit: m/s^2.
    pub low_limit_uncertainty: Option<f32>,
    /// Standard deviation at the upper limit.
    ///
    /// Unit: m/s^2.
    pub high_limit_uncertainty: Option<f32>,
    /// Smallest standard deviation.
    ///
    /// Unit: m/s^2.
    pub minimum_uncertainty: Option<f32>,
}

impl GravityMagnitudeErrorAdaptiveMeasurement {
    /// Apply the new setting.
    #[must_use]
    pub fn write(adaptive_measurement: AdaptiveMeasurementSelector) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            adaptive_measurement: Some(adaptive_measurement),
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// With `frequency`, which is optional.
    #[must_use]
    pub fn with_frequency(mut self, frequency: f32) -> Self {
        self.frequency = Some(frequency);
        self
    }

    /// With `low_limit`, which is optional.
    #[must_use]
    pub fn with_low_limit(mut self, low_limit: f32) -> Self {
        self.low_limit = Some(low_limit);
        self
    }

    /// With `high_limit`, which is optional.
    #[must_use]
    pub fn with_high_limit(mut self, high_limit: f32) -> Self {
        self.high_limit = Some(high_limit);
        self
    }

    /// With `low_limit_uncertainty`, which is optional.
    #[must_use]
    pub fn with_low_limit_uncertainty(mut self, low_limit_uncertainty: f32) -> Self {
        self.low_limit_uncertainty = Some(low_limit_uncertainty);
        self
    }

    /// With `high_limit_uncertainty`, which is optional.
    #[must_use]
    pub fn with_high_limit_uncertainty(mut self, high_limit_uncertainty: f32) -> Self {
        self.high_limit_uncertainty = Some(high_limit_uncertainty);
        self
    }

    /// With `minimum_uncertainty`, which is optional.
    #[must_use]
    pub fn with_minimum_uncertainty(mut self, minimum_uncertainty: f32) -> Self {
        self.minimum_uncertainty = Some(minimum_uncertainty);
        self
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for GravityMagnitudeErrorAdaptiveMeasurement {
    const SIZE: usize = 26;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let adaptive_measurement = reader.group(required >= 1, Reader::read)?;
        let frequency = reader.group(false, Reader::read)?;
        let low_limit = reader.group(false, Reader::read)?;
        let high_limit = reader.group(false, Reader::read)?;
        let low_limit_uncertainty = reader.group(false, Reader::read)?;
        let high_limit_uncertainty = reader.group(false, Reader::read)?;
        let minimum_uncertainty = reader.group(false, Reader::read)?;
        Ok(Self {
            function,
            adaptive_measurement,
            frequency,
            low_limit,
            high_limit,
            low_limit_uncertainty,
            high_limit_uncertainty,
            minimum_uncertainty,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.adaptive_measurement)?;
        writer.some(false, &self.frequency)?;
        writer.some(false, &self.low_limit)?;
        writer.some(false, &self.high_limit)?;
        writer.some(false, &self.low_limit_uncertainty)?;
        writer.some(false, &self.high_limit_uncertainty)?;
        writer.some(false, &self.minimum_uncertainty)?;
        Ok(())
    }
}

impl Field for GravityMagnitudeErrorAdaptiveMeasurement {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x44;
    const NAME: &'static str = "filter.gravity_magnitude_error_adaptive_measurement";
}

impl Command for GravityMagnitudeErrorAdaptiveMeasurement {
    type Response = GravityMagnitudeErrorAdaptiveMeasurementResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GravityMagnitudeErrorAdaptiveMeasurement>
    for GravityMagnitudeErrorAdaptiveMeasurementResponse
{
}

/// Magnetometer magnitude error adaptive measurement (0x0D,0x45).
///
/// How far the filter trusts a magnetic field whose magnitude is not as expected.
///
/// - The limits and the low-pass filter take effect only with `fixed`; with `auto` the device finds
///   limits.
/// - High limits suit high dynamics but let disturbances of the field through; low limits can spoil
///   the heading.
///
/// Functions: write, read, save, load, default. Response:
/// [`MagMagnitudeErrorAdaptiveMeasurementResponse`].
///
/// - Manual mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagMagnitudeErrorAdaptiveMeasurement {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Kind of adaptation.
    pub adaptive_measurement: Option<AdaptiveMeasurementSelector>,
    /// Cut-off frequency of the low-pass filter.
    ///
    /// Unit: Hz.
    pub frequency: Option<f32>,
    /// Lower limit of the error.
    ///
    /// Unit: gauss.
    pub low_limit: Option<f32>,
    /// Upper limit of the error.
    ///
    /// Unit: gauss.
    pub high_limit: Option<f32>,
    /// Standard deviation at the lower limit.
    ///
    /// Unit: gauss.
    pub low_limit_uncertainty: Option<f32>,
    /// Standard deviation at the upper limit.
    ///
    /// Unit: gauss.
    pub high_limit_uncertainty: Option<f32>,
    /// Smallest standard deviation.
    ///
    /// Unit: gauss.
    pub minimum_uncertainty: Option<f32>,
}

impl MagMagnitudeErrorAdaptiveMeasurement {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        adaptive_measurement: AdaptiveMeasurementSelector,
        frequency: f32,
        low_limit: f32,
        high_limit: f32,
        low_limit_uncertainty: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            adaptive_measurement: Some(adaptive_measurement),
            frequency: Some(frequency),
            low_limit: Some(low_limit),
            high_limit: Some(high_limit),
            low_limit_uncertainty: Some(low_limit_uncertainty),
            high_limit_uncertainty: Some(high_limit_uncertainty),
            minimum_uncertainty: Some(minimum_uncertainty),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            adaptive_measurement: None,
            frequency: None,
            low_limit: None,
            high_limit: None,
            low_limit_uncertainty: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 7,
            _ => 0,
        }
    }
}

impl Wire for MagMagnitudeErrorAdaptiveMeasurement {
    const SIZE: usize = 26;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let adaptive_measurement = reader.group(required >= 1, Reader::read)?;
        let frequency = reader.group(required >= 2, Reader::read)?;
        let low_limit = reader.group(required >= 3, Reader::read)?;
        let high_limit = reader.group(required >= 4, Reader::read)?;
        let low_limit_uncertainty = reader.group(required >= 5, Reader::read)?;
        let high_limit_uncertainty = reader.group(required >= 6, Reader::read)?;
        let minimum_uncertainty = reader.group(required >= 7, Reader::read)?;
        Ok(Self {
            function,
            adaptive_measurement,
            frequency,
            low_limit,
            high_limit,
            low_limit_uncertainty,
            high_limit_uncertainty,
            minimum_uncertainty,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.adaptive_measurement)?;
        writer.some(required >= 2, &self.frequency)?;
        writer.some(required >= 3, &self.low_limit)?;
        writer.some(required >= 4, &self.high_limit)?;
        writer.some(required >= 5, &self.low_limit_uncertainty)?;
        writer.some(required >= 6, &self.high_limit_uncertainty)?;
        writer.some(required >= 7, &self.minimum_uncertainty)?;
        Ok(())
    }
}

impl Field for MagMagnitudeErrorAdaptiveMeasurement {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x45;
    const NAME: &'static str = "filter.mag_magnitude_error_adaptive_measurement";
}

impl Command for MagMagnitudeErrorAdaptiveMeasurement {
    type Response = MagMagnitudeErrorAdaptiveMeasurementResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagMagnitudeErrorAdaptiveMeasurement>
    for MagMagnitudeErrorAdaptiveMeasurementResponse
{
}

/// Magnetometer dip angle error adaptive measurement (0x0D,0x46).
///
/// How far the filter trusts a magnetic field whose dip angle is not as expected.
///
/// - It has no effect while (0x0D,0x44) or (0x0D,0x45) is set to `auto`.
/// - High limits suit high dynamics but let disturbances of the field through; low limits can spoil
///   the heading.
///
/// Functions: write, read, save, load, default. Response:
/// [`MagDipAngleErrorAdaptiveMeasurementResponse`].
///
/// - Manual mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagDipAngleErrorAdaptiveMeasurement {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Whether the adaptation is on.
    pub enable: Option<crate::Bool>,
    /// Cut-off frequency of the low-pass filter.
    ///
    /// Unit: Hz.
    pub frequency: Option<f32>,
    /// Upper limit of the error.
    ///
    /// Unit: rad.
    pub high_limit: Option<f32>,
    /// Standard deviation at the upper limit.
    ///
    /// Unit: rad.
    pub high_limit_uncertainty: Option<f32>,
    /// Smallest standard deviation.
    ///
    /// Unit: rad.
    pub minimum_uncertainty: Option<f32>,
}

impl MagDipAngleErrorAdaptiveMeasurement {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        enable: bool,
        frequency: f32,
        high_limit: f32,
        high_limit_uncertainty: f32,
        minimum_uncertainty: f32,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable.into()),
            frequency: Some(frequency),
            high_limit: Some(high_limit),
            high_limit_uncertainty: Some(high_limit_uncertainty),
            minimum_uncertainty: Some(minimum_uncertainty),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            enable: None,
            frequency: None,
            high_limit: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            enable: None,
            frequency: None,
            high_limit: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            enable: None,
            frequency: None,
            high_limit: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            enable: None,
            frequency: None,
            high_limit: None,
            high_limit_uncertainty: None,
            minimum_uncertainty: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 5,
            _ => 0,
        }
    }
}

impl Wire for MagDipAngleErrorAdaptiveMeasurement {
    const SIZE: usize = 18;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let frequency = reader.group(required >= 2, Reader::read)?;
        let high_limit = reader.group(required >= 3, Reader::read)?;
        let high_limit_uncertainty = reader.group(required >= 4, Reader::read)?;
        let minimum_uncertainty = reader.group(required >= 5, Reader::read)?;
        Ok(Self {
            function,
            enable,
            frequency,
            high_limit,
            high_limit_uncertainty,
            minimum_uncertainty,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.frequency)?;
        writer.some(required >= 3, &self.high_limit)?;
        writer.some(required >= 4, &self.high_limit_uncertainty)?;
        writer.some(required >= 5, &self.minimum_uncertainty)?;
        Ok(())
    }
}

impl Field for MagDipAngleErrorAdaptiveMeasurement {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x46;
    const NAME: &'static str = "filter.mag_dip_angle_error_adaptive_measurement";
}

impl Command for MagDipAngleErrorAdaptiveMeasurement {
    type Response = MagDipAngleErrorAdaptiveMeasurementResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagDipAngleErrorAdaptiveMeasurement>
    for MagDipAngleErrorAdaptiveMeasurementResponse
{
}

/// Altitude aiding (0x0D,0x47).
///
/// What aids the altitude beside GNSS.
///
/// - GNSS stays the main source of altitude; the aid improves it and bridges outages.
/// - Weather and place shift the pressure altitude, at times by more than 40 m.
///
/// Functions: write, read, save, load, default. Response: [`AltitudeAidingResponse`].
///
/// - Manual mip-sdk-4: Altitude Aiding (0x0D,0x47)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AltitudeAiding {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the aiding.
    pub selector: Option<AltitudeAidingSource>,
}

impl AltitudeAiding {
    /// Apply the new setting.
    #[must_use]
    pub fn write(selector: AltitudeAidingSource) -> Self {
        Self { function: types::FunctionSelector::WRITE, selector: Some(selector) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, selector: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, selector: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, selector: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, selector: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for AltitudeAiding {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let selector = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, selector })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.selector)?;
        Ok(())
    }
}

impl Field for AltitudeAiding {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x47;
    const NAME: &'static str = "filter.altitude_aiding";
}

impl Command for AltitudeAiding {
    type Response = AltitudeAidingResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AltitudeAiding> for AltitudeAidingResponse {}

/// Pitch and roll aiding (0x0D,0x4B).
///
/// What aids pitch and roll while the motion is gentle.
///
/// Functions: write, read, save, load, default. Response: [`PitchRollAidingControlResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PitchRollAidingControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the aiding.
    pub aiding: Option<PitchRollAidingSource>,
}

impl PitchRollAidingControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(aiding: PitchRollAidingSource) -> Self {
        Self { function: types::FunctionSelector::WRITE, aiding: Some(aiding) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, aiding: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, aiding: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, aiding: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, aiding: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for PitchRollAidingControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let aiding = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, aiding })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.aiding)?;
        Ok(())
    }
}

impl Field for PitchRollAidingControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x4B;
    const NAME: &'static str = "filter.pitch_roll_aiding_control";
}

impl Command for PitchRollAidingControl {
    type Response = PitchRollAidingControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<PitchRollAidingControl> for PitchRollAidingControlResponse {}

/// Magnetic inclination source (0x0D,0x4C).
///
/// Source of the local inclination (dip angle) of the magnetic field.
///
/// - Without a good inclination source, keep automatic magnetometer calibration off.
///
/// Functions: write, read, save, load, default. Response: [`InclinationSourceResponse`].
///
/// - Manual mip-sdk-4: Inclination Source (0x0D,0x4C)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InclinationSource {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the inclination.
    pub source: Option<MagParameterSource>,
    /// Inclination; used only if `source` is manual.
    ///
    /// Unit: rad.
    pub inclination: Option<f32>,
}

impl InclinationSource {
    /// Apply the new setting.
    #[must_use]
    pub fn write(source: MagParameterSource, inclination: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            source: Some(source),
            inclination: Some(inclination),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, source: None, inclination: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, source: None, inclination: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, source: None, inclination: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, source: None, inclination: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for InclinationSource {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        let inclination = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, source, inclination })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        writer.some(required >= 2, &self.inclination)?;
        Ok(())
    }
}

impl Field for InclinationSource {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x4C;
    const NAME: &'static str = "filter.inclination_source";
}

impl Command for InclinationSource {
    type Response = InclinationSourceResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<InclinationSource> for InclinationSourceResponse {}

/// Magnetic field magnitude source (0x0D,0x4D).
///
/// Source of the local magnitude of the magnetic field.
///
/// - Without a good magnitude source, keep automatic magnetometer calibration off.
/// - The adaptive measurement (0x0D,0x45) relies on it too.
///
/// Functions: write, read, save, load, default. Response: [`MagFieldMagnitudeSourceResponse`].
///
/// - Manual mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagFieldMagnitudeSource {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the magnitude.
    pub source: Option<MagParameterSource>,
    /// Magnitude; used only if `source` is manual.
    ///
    /// Unit: gauss.
    pub magnitude: Option<f32>,
}

impl MagFieldMagnitudeSource {
    /// Apply the new setting.
    #[must_use]
    pub fn write(source: MagParameterSource, magnitude: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            source: Some(source),
            magnitude: Some(magnitude),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, source: None, magnitude: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, source: None, magnitude: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, source: None, magnitude: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, source: None, magnitude: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for MagFieldMagnitudeSource {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        let magnitude = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, source, magnitude })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        writer.some(required >= 2, &self.magnitude)?;
        Ok(())
    }
}

impl Field for MagFieldMagnitudeSource {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x4D;
    const NAME: &'static str = "filter.mag_field_magnitude_source";
}

impl Command for MagFieldMagnitudeSource {
    type Response = MagFieldMagnitudeSourceResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagFieldMagnitudeSource> for MagFieldMagnitudeSourceResponse {}

/// Sensor to vehicle rotation, matrix (0x0D,0x4E).
///
/// Rotation from the sensor frame to the vehicle frame as a direction cosine matrix.
///
/// - It is the inverse of the matrix that (0x0C,0x33) takes.
/// - It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
///   velocity, and the orientation, linear acceleration, angular rate and gravity vector of the
///   filter.
/// - The device refuses a matrix that is not orthonormal to 0.001.
/// - The device keeps a quaternion, so the elements read back may differ a little from those
///   written.
///
/// Functions: write, read, save, load, default. Response: [`SensorToVehicleRotationDcmResponse`].
///
/// - Manual mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleRotationDcm {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Rotation matrix in row-major order.
    ///
    /// Unit: 1.
    pub dcm: Option<types::Matrix3f>,
}

impl SensorToVehicleRotationDcm {
    /// Apply the new setting.
    #[must_use]
    pub fn write(dcm: impl Into<types::Matrix3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, dcm: Some(dcm.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, dcm: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, dcm: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, dcm: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, dcm: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for SensorToVehicleRotationDcm {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let dcm = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, dcm })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.dcm)?;
        Ok(())
    }
}

impl Field for SensorToVehicleRotationDcm {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x4E;
    const NAME: &'static str = "filter.sensor_to_vehicle_rotation_dcm";
}

impl Command for SensorToVehicleRotationDcm {
    type Response = SensorToVehicleRotationDcmResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleRotationDcm> for SensorToVehicleRotationDcmResponse {}

/// Sensor to vehicle rotation, quaternion (0x0D,0x4F).
///
/// Rotation from the sensor frame to the vehicle frame as a quaternion.
///
/// - It is the inverse of the quaternion that (0x0C,0x32) takes.
/// - It turns the scaled acceleration, angular rate and magnetic field, delta theta and delta
///   velocity, and the orientation, linear acceleration, angular rate and gravity vector of the
///   filter.
/// - The device refuses a quaternion whose length is not 1 to 0.001.
/// - The device normalizes it, so the elements read back may differ a little from those written.
///
/// Functions: write, read, save, load, default. Response:
/// [`SensorToVehicleRotationQuaternionResponse`].
///
/// - Manual mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleRotationQuaternion {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Unit quaternion, scalar part first.
    ///
    /// Unit: 1.
    pub quat: Option<types::Quatf>,
}

impl SensorToVehicleRotationQuaternion {
    /// Apply the new setting.
    #[must_use]
    pub fn write(quat: impl Into<types::Quatf>) -> Self {
        Self { function: types::FunctionSelector::WRITE, quat: Some(quat.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, quat: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, quat: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, quat: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, quat: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for SensorToVehicleRotationQuaternion {
    const SIZE: usize = 17;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let quat = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, quat })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.quat)?;
        Ok(())
    }
}

impl Field for SensorToVehicleRotationQuaternion {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x4F;
    const NAME: &'static str = "filter.sensor_to_vehicle_rotation_quaternion";
}

impl Command for SensorToVehicleRotationQuaternion {
    type Response = SensorToVehicleRotationQuaternionResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleRotationQuaternion> for SensorToVehicleRotationQuaternionResponse {}

/// Aiding measurement control (0x0D,0x50).
///
/// Enables or disables one source of aiding measurements.
///
/// Functions: write, read, save, load, default. Response: [`AidingMeasurementControlResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AidingMeasurementControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// The source; `all` is for save, load and default.
    pub aiding_source: Option<AidingSource>,
    /// Whether the filter uses the source.
    pub enable: Option<crate::Bool>,
}

impl AidingMeasurementControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(aiding_source: AidingSource, enable: bool) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            aiding_source: Some(aiding_source),
            enable: Some(enable.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(aiding_source: AidingSource) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            aiding_source: Some(aiding_source),
            enable: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(aiding_source: AidingSource) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            aiding_source: Some(aiding_source),
            enable: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(aiding_source: AidingSource) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            aiding_source: Some(aiding_source),
            enable: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(aiding_source: AidingSource) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            aiding_source: Some(aiding_source),
            enable: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for AidingMeasurementControl {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let aiding_source = reader.group(required >= 1, Reader::read)?;
        let enable = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, aiding_source, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.aiding_source)?;
        writer.some(required >= 2, &self.enable)?;
        Ok(())
    }
}

impl Field for AidingMeasurementControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x50;
    const NAME: &'static str = "filter.aiding_measurement_control";
}

impl Command for AidingMeasurementControl {
    type Response = AidingMeasurementControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AidingMeasurementControl> for AidingMeasurementControlResponse {}

/// Kinematic constraint (0x0D,0x51).
///
/// Assumptions about the motion that the filter uses as measurements.
///
/// Functions: write, read, save, load, default. Response: [`KinematicConstraintResponse`].
///
/// - Manual mip-sdk-4: Kinematic Constraint (0x0D,0x51)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct KinematicConstraint {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Assumption about the acceleration.
    ///
    /// Default: none.
    pub accel_constraint: Option<AccelConstraint>,
    /// Assumption about the velocity.
    ///
    /// Default: none.
    pub velocity_constraint: Option<VelocityConstraint>,
    /// Assumption about the angular rate.
    ///
    /// Default: none.
    pub angular_constraint: Option<AngularConstraint>,
}

impl KinematicConstraint {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        accel_constraint: AccelConstraint,
        velocity_constraint: VelocityConstraint,
        angular_constraint: AngularConstraint,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            accel_constraint: Some(accel_constraint),
            velocity_constraint: Some(velocity_constraint),
            angular_constraint: Some(angular_constraint),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            accel_constraint: None,
            velocity_constraint: None,
            angular_constraint: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            accel_constraint: None,
            velocity_constraint: None,
            angular_constraint: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            accel_constraint: None,
            velocity_constraint: None,
            angular_constraint: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            accel_constraint: None,
            velocity_constraint: None,
            angular_constraint: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for KinematicConstraint {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let accel_constraint = reader.group(required >= 1, Reader::read)?;
        let velocity_constraint = reader.group(required >= 2, Reader::read)?;
        let angular_constraint = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, accel_constraint, velocity_constraint, angular_constraint })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.accel_constraint)?;
        writer.some(required >= 2, &self.velocity_constraint)?;
        writer.some(required >= 3, &self.angular_constraint)?;
        Ok(())
    }
}

impl Field for KinematicConstraint {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x51;
    const NAME: &'static str = "filter.kinematic_constraint";
}

impl Command for KinematicConstraint {
    type Response = KinematicConstraintResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<KinematicConstraint> for KinematicConstraintResponse {}

/// Navigation filter initialization (0x0D,0x52).
///
/// Sources and values of the initial attitude, position and velocity of the filter.
///
/// - Single precision resolves the latitude and longitude of the initial position to about a metre
///   only.
/// - Kinematic alignment sets the heading once the speed reaches 2 m/s.
/// - External alignment needs a heading at least every 5 seconds.
///
/// Functions: write, read, save, load, default. Response:
/// [`NavigationFilterInitializationResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NavigationFilterInitialization {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 1: the filter starts only after `run_navigation_filter`; 0: as soon as it can.
    ///
    /// Range: 0 to 1.
    pub wait_for_run_command: Option<u8>,
    /// Which initial conditions are found and which are given.
    pub initial_cond_src: Option<InitialConditionSource>,
    /// Ways in which the initial heading may be found.
    pub auto_heading_alignment_selector: Option<HeadingAlignment>,
    /// Given heading.
    ///
    /// Unit: deg.
    pub initial_heading: Option<f32>,
    /// Given pitch.
    ///
    /// Unit: deg.
    pub initial_pitch: Option<f32>,
    /// Given roll.
    ///
    /// Unit: deg.
    pub initial_roll: Option<f32>,
    /// Given position.
    ///
    /// - If reference_frame_selector is ecef: unit m, frame ecef.
    /// - If reference_frame_selector is llh: unit deg, deg, m, frame llh.
    pub initial_position: Option<types::Vector3f>,
    /// Given velocity.
    ///
    /// Unit: m/s.
    ///
    /// - If reference_frame_selector is ecef: frame ecef.
    /// - If reference_frame_selector is llh: frame ned.
    pub initial_velocity: Option<types::Vector3f>,
    /// Frame of the given position and velocity.
    pub reference_frame_selector: Option<ReferenceFrame>,
}

impl NavigationFilterInitialization {
    /// Apply the new setting.
    #[must_use]
    #[allow(clippy::too_many_arguments)]
    pub fn write(
        wait_for_run_command: u8,
        initial_cond_src: InitialConditionSource,
        auto_heading_alignment_selector: HeadingAlignment,
        initial_heading: f32,
        initial_pitch: f32,
        initial_roll: f32,
        initial_position: impl Into<types::Vector3f>,
        initial_velocity: impl Into<types::Vector3f>,
        reference_frame_selector: ReferenceFrame,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            wait_for_run_command: Some(wait_for_run_command),
            initial_cond_src: Some(initial_cond_src),
            auto_heading_alignment_selector: Some(auto_heading_alignment_selector),
            initial_heading: Some(initial_heading),
            initial_pitch: Some(initial_pitch),
            initial_roll: Some(initial_roll),
            initial_position: Some(initial_position.into()),
            initial_velocity: Some(initial_velocity.into()),
            reference_frame_selector: Some(reference_frame_selector),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            wait_for_run_command: None,
            initial_cond_src: None,
            auto_heading_alignment_selector: None,
            initial_heading: None,
            initial_pitch: None,
            initial_roll: None,
            initial_position: None,
            initial_velocity: None,
            reference_frame_selector: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            wait_for_run_command: None,
            initial_cond_src: None,
            auto_heading_alignment_selector: None,
            initial_heading: None,
            initial_pitch: None,
            initial_roll: None,
            initial_position: None,
            initial_velocity: None,
            reference_frame_selector: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            wait_for_run_command: None,
            initial_cond_src: None,
            auto_heading_alignment_selector: None,
            initial_heading: None,
            initial_pitch: None,
            initial_roll: None,
            initial_position: None,
            initial_velocity: None,
            reference_frame_selector: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            wait_for_run_command: None,
            initial_cond_src: None,
            auto_heading_alignment_selector: None,
            initial_heading: None,
            initial_pitch: None,
            initial_roll: None,
            initial_position: None,
            initial_velocity: None,
            reference_frame_selector: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 9,
            _ => 0,
        }
    }
}

impl Wire for NavigationFilterInitialization {
    const SIZE: usize = 41;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let wait_for_run_command = reader.group(required >= 1, Reader::read)?;
        let initial_cond_src = reader.group(required >= 2, Reader::read)?;
        let auto_heading_alignment_selector = reader.group(required >= 3, Reader::read)?;
        let initial_heading = reader.group(required >= 4, Reader::read)?;
        let initial_pitch = reader.group(required >= 5, Reader::read)?;
        let initial_roll = reader.group(required >= 6, Reader::read)?;
        let initial_position = reader.group(required >= 7, Reader::read)?;
        let initial_velocity = reader.group(required >= 8, Reader::read)?;
        let reference_frame_selector = reader.group(required >= 9, Reader::read)?;
        Ok(Self {
            function,
            wait_for_run_command,
            initial_cond_src,
            auto_heading_alignment_selector,
            initial_heading,
            initial_pitch,
            initial_roll,
            initial_position,
            initial_velocity,
            reference_frame_selector,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.wait_for_run_command)?;
        writer.some(required >= 2, &self.initial_cond_src)?;
        writer.some(required >= 3, &self.auto_heading_alignment_selector)?;
        writer.some(required >= 4, &self.initial_heading)?;
        writer.some(required >= 5, &self.initial_pitch)?;
        writer.some(required >= 6, &self.initial_roll)?;
        writer.some(required >= 7, &self.initial_position)?;
        writer.some(required >= 8, &self.initial_velocity)?;
        writer.some(required >= 9, &self.reference_frame_selector)?;
        Ok(())
    }
}

impl Field for NavigationFilterInitialization {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x52;
    const NAME: &'static str = "filter.navigation_filter_initialization";
}

impl Command for NavigationFilterInitialization {
    type Response = NavigationFilterInitializationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<NavigationFilterInitialization> for NavigationFilterInitializationResponse {}

/// Adaptive filter control (0x0D,0x53).
///
/// How the filter adapts to measurements that do not fit its model.
///
/// Functions: write, read, save, load, default. Response: [`AdaptiveFilterControlResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AdaptiveFilterControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Strength of the adaptation.
    ///
    /// Default: 2.
    pub level: Option<AdaptiveLevel>,
    /// Longest time for which measurements are rejected before the filter recovers.
    ///
    /// Unit: ms.
    pub time_limit: Option<u16>,
}

impl AdaptiveFilterControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(level: AdaptiveLevel, time_limit: u16) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            level: Some(level),
            time_limit: Some(time_limit),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, level: None, time_limit: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, level: None, time_limit: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, level: None, time_limit: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, level: None, time_limit: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for AdaptiveFilterControl {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let level = reader.group(required >= 1, Reader::read)?;
        let time_limit = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, level, time_limit })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.level)?;
        writer.some(required >= 2, &self.time_limit)?;
        Ok(())
    }
}

impl Field for AdaptiveFilterControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x53;
    const NAME: &'static str = "filter.adaptive_filter_control";
}

impl Command for AdaptiveFilterControl {
    type Response = AdaptiveFilterControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AdaptiveFilterControl> for AdaptiveFilterControlResponse {}

/// GNSS multi-antenna offset (0x0D,0x54).
///
/// Position of the antenna of one receiver on devices with several antennas.
///
/// - The magnitude of the vector is limited to 10.
///
/// Functions: write, read, save, load, default. Response:
/// [`GnssMultiAntennaOffsetControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssMultiAntennaOffsetControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Number of the receiver, from 1.
    ///
    /// Range: at least 1.
    pub receiver_id: Option<u8>,
    /// From the sensor to the antenna.
    ///
    /// Unit: m; frame: vehicle; range: -10 to 10.
    pub antenna_offset: Option<types::Vector3f>,
}

impl GnssMultiAntennaOffsetControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(receiver_id: u8, antenna_offset: impl Into<types::Vector3f>) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            receiver_id: Some(receiver_id),
            antenna_offset: Some(antenna_offset.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(receiver_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            receiver_id: Some(receiver_id),
            antenna_offset: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(receiver_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            receiver_id: Some(receiver_id),
            antenna_offset: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(receiver_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            receiver_id: Some(receiver_id),
            antenna_offset: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(receiver_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            receiver_id: Some(receiver_id),
            antenna_offset: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for GnssMultiAntennaOffsetControl {
    const SIZE: usize = 14;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let receiver_id = reader.group(required >= 1, Reader::read)?;
        let antenna_offset = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, receiver_id, antenna_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.receiver_id)?;
        writer.some(required >= 2, &self.antenna_offset)?;
        Ok(())
    }
}

impl Field for GnssMultiAntennaOffsetControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x54;
    const NAME: &'static str = "filter.gnss_multi_antenna_offset_control";
}

impl Command for GnssMultiAntennaOffsetControl {
    type Response = GnssMultiAntennaOffsetControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssMultiAntennaOffsetControl> for GnssMultiAntennaOffsetControlResponse {}

/// Relative position configuration (0x0D,0x55).
///
/// Reference point of the relative position that the filter reports.
///
/// Functions: write, read, save, load, default. Response:
/// [`RelativePositionConfigurationResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RelativePositionConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the reference point.
    pub source: Option<RelativePositionSource>,
    /// Frame of the coordinates.
    pub reference_frame_selector: Option<ReferenceFrame>,
    /// Reference point.
    ///
    /// - If reference_frame_selector is ecef: unit m, frame ecef.
    /// - If reference_frame_selector is llh: unit deg, deg, m, frame llh.
    pub reference_coordinates: Option<types::Vector3d>,
}

impl RelativePositionConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        source: RelativePositionSource,
        reference_frame_selector: ReferenceFrame,
        reference_coordinates: impl Into<types::Vector3d>,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            source: Some(source),
            reference_frame_selector: Some(reference_frame_selector),
            reference_coordinates: Some(reference_coordinates.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            source: None,
            reference_frame_selector: None,
            reference_coordinates: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            source: None,
            reference_frame_selector: None,
            reference_coordinates: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            source: None,
            reference_frame_selector: None,
            reference_coordinates: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            source: None,
            reference_frame_selector: None,
            reference_coordinates: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for RelativePositionConfiguration {
    const SIZE: usize = 27;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        let reference_frame_selector = reader.group(required >= 2, Reader::read)?;
        let reference_coordinates = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, source, reference_frame_selector, reference_coordinates })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        writer.some(required >= 2, &self.reference_frame_selector)?;
        writer.some(required >= 3, &self.reference_coordinates)?;
        Ok(())
    }
}

impl Field for RelativePositionConfiguration {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x55;
    const NAME: &'static str = "filter.relative_position_configuration";
}

impl Command for RelativePositionConfiguration {
    type Response = RelativePositionConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<RelativePositionConfiguration> for RelativePositionConfigurationResponse {}

/// Reference point lever arm (0x0D,0x56).
///
/// Moves the point to which the position and the velocity of the filter refer.
///
/// - It shifts `llh_position`, `velocity_ned`, `ecef_position`, `ecef_velocity` and
///   `ned_relative_position` of set `filter_data`, depending on the attitude and, for velocities,
///   on the angular rate.
/// - The magnitude of the vector is limited to 10.
///
/// Functions: write, read, save, load, default. Response: [`ReferencePointLeverArmResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReferencePointLeverArm {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Point to move; it must be 1.
    pub ref_point_sel: Option<ReferencePoint>,
    /// From the sensor to the point.
    ///
    /// Unit: m; frame: vehicle; range: -10 to 10.
    pub lever_arm_offset: Option<types::Vector3f>,
}

impl ReferencePointLeverArm {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        ref_point_sel: ReferencePoint,
        lever_arm_offset: impl Into<types::Vector3f>,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            ref_point_sel: Some(ref_point_sel),
            lever_arm_offset: Some(lever_arm_offset.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            ref_point_sel: None,
            lever_arm_offset: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            ref_point_sel: None,
            lever_arm_offset: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            ref_point_sel: None,
            lever_arm_offset: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            ref_point_sel: None,
            lever_arm_offset: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for ReferencePointLeverArm {
    const SIZE: usize = 14;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let ref_point_sel = reader.group(required >= 1, Reader::read)?;
        let lever_arm_offset = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, ref_point_sel, lever_arm_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.ref_point_sel)?;
        writer.some(required >= 2, &self.lever_arm_offset)?;
        Ok(())
    }
}

impl Field for ReferencePointLeverArm {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x56;
    const NAME: &'static str = "filter.reference_point_lever_arm";
}

impl Command for ReferencePointLeverArm {
    type Response = ReferencePointLeverArmResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ReferencePointLeverArm> for ReferencePointLeverArmResponse {}

/// Speed measurement (0x0D,0x60).
///
/// Gives the filter one measurement of the forward speed of the vehicle (along its x axis).
///
/// - It must not be used together with the odometer of the device.
/// - Single precision resolves the time of week to 0.0625 s at the end of the week.
/// - Manual mip-sdk-4: Speed Measurement (0x0D,0x60)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SpeedMeasurement {
    /// Send 1.
    ///
    /// Send 1.
    pub source: u8,
    /// GPS time of week of the measurement.
    ///
    /// Unit: s.
    pub tow: f32,
    /// Speed, negative in reverse.
    ///
    /// Unit: m/s; frame: vehicle.
    pub speed: f32,
    /// Standard deviation of the speed.
    ///
    /// Unit: m/s.
    pub speed_uncertainty: f32,
}

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

impl SpeedMeasurement {
    /// The command with its parameters.
    #[must_use]
    pub fn new(tow: f32, speed: f32, speed_uncertainty: f32) -> Self {
        Self { source: 1, tow, speed, speed_uncertainty }
    }
}

impl Wire for SpeedMeasurement {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        let tow = reader.read()?;
        let speed = reader.read()?;
        let speed_uncertainty = reader.read()?;
        Ok(Self { source, tow, speed, speed_uncertainty })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        writer.write(&self.tow)?;
        writer.write(&self.speed)?;
        writer.write(&self.speed_uncertainty)?;
        Ok(())
    }
}

impl Field for SpeedMeasurement {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x60;
    const NAME: &'static str = "filter.speed_measurement";
}

impl Command for SpeedMeasurement {
    type Response = ();
}

/// Speed measurement lever arm (0x0D,0x61).
///
/// Position of the point whose speed is measured, such as the wheel that an odometer is on.
///
/// - It corrects for the speed that such a point has only because the vehicle turns.
///
/// Functions: write, read, save, load, default. Response: [`MeasurementSpeedLeverArmResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MeasurementSpeedLeverArm {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Send 1.
    ///
    /// Send 1.
    pub source: Option<u8>,
    /// From the sensor to the point of measurement.
    ///
    /// Unit: m; frame: vehicle.
    pub lever_arm_offset: Option<types::Vector3f>,
}

impl MeasurementSpeedLeverArm {
    /// Apply the new setting.
    #[must_use]
    pub fn write(lever_arm_offset: impl Into<types::Vector3f>) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            source: Some(1),
            lever_arm_offset: Some(lever_arm_offset.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, source: Some(1), lever_arm_offset: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, source: Some(1), lever_arm_offset: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, source: Some(1), lever_arm_offset: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, source: Some(1), lever_arm_offset: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for MeasurementSpeedLeverArm {
    const SIZE: usize = 14;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        let lever_arm_offset = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, source, lever_arm_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        writer.some(required >= 2, &self.lever_arm_offset)?;
        Ok(())
    }
}

impl Field for MeasurementSpeedLeverArm {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x61;
    const NAME: &'static str = "filter.measurement_speed_lever_arm";
}

impl Command for MeasurementSpeedLeverArm {
    type Response = MeasurementSpeedLeverArmResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MeasurementSpeedLeverArm> for MeasurementSpeedLeverArmResponse {}

/// Vertical gyro constraint (0x0D,0x62).
///
/// Lets the filter hold pitch and roll by the accelerometers while there is no GNSS.
///
/// - It takes the linear acceleration as zero.
///
/// Functions: write, read, save, load, default. Response:
/// [`VerticalGyroConstraintControlResponse`].
///
/// - Manual mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VerticalGyroConstraintControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
}

impl VerticalGyroConstraintControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8) -> Self {
        Self { function: types::FunctionSelector::WRITE, enable: Some(enable) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for VerticalGyroConstraintControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        Ok(())
    }
}

impl Field for VerticalGyroConstraintControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x62;
    const NAME: &'static str = "filter.vertical_gyro_constraint_control";
}

impl Command for VerticalGyroConstraintControl {
    type Response = VerticalGyroConstraintControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<VerticalGyroConstraintControl> for VerticalGyroConstraintControlResponse {}

/// Wheeled vehicle constraint (0x0D,0x63).
///
/// Lets the filter assume that the vehicle moves only along its x axis.
///
/// - It improves the heading of cars and the like, above all when GNSS comes and goes. It is wrong
///   for vehicles that move sideways, such as aircraft.
///
/// Functions: write, read, save, load, default. Response:
/// [`WheeledVehicleConstraintControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WheeledVehicleConstraintControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
}

impl WheeledVehicleConstraintControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8) -> Self {
        Self { function: types::FunctionSelector::WRITE, enable: Some(enable) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 1,
            _ => 0,
        }
    }
}

impl Wire for WheeledVehicleConstraintControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        Ok(())
    }
}

impl Field for WheeledVehicleConstraintControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x63;
    const NAME: &'static str = "filter.wheeled_vehicle_constraint_control";
}

impl Command for WheeledVehicleConstraintControl {
    type Response = WheeledVehicleConstraintControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<WheeledVehicleConstraintControl> for WheeledVehicleConstraintControlResponse {}

/// GNSS antenna offset calibration (0x0D,0x64).
///
/// Lets the filter track the error of the antenna offset.
///
/// Functions: write, read, save, load, default. Response:
/// [`GnssAntennaOffsetCalibrationControlResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
/// - Manual 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAntennaOffsetCalibrationControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
    /// Largest absolute error that is tracked; the limits are those of the 3DM-CV7.
    ///
    /// Unit: m; frame: vehicle; range: 0 to 0.5; default: 0.1.
    pub max_offset: Option<f32>,
}

impl GnssAntennaOffsetCalibrationControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8, max_offset: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable),
            max_offset: Some(max_offset),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None, max_offset: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None, max_offset: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None, max_offset: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None, max_offset: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            _ => 0,
        }
    }
}

impl Wire for GnssAntennaOffsetCalibrationControl {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let max_offset = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, enable, max_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.max_offset)?;
        Ok(())
    }
}

impl Field for GnssAntennaOffsetCalibrationControl {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x64;
    const NAME: &'static str = "filter.gnss_antenna_offset_calibration_control";
}

impl Command for GnssAntennaOffsetCalibrationControl {
    type Response = GnssAntennaOffsetCalibrationControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssAntennaOffsetCalibrationControl>
    for GnssAntennaOffsetCalibrationControlResponse
{
}

/// Vehicle dynamics mode response (0x0D,0x80).
///
/// Answers Vehicle dynamics mode (0x0D,0x10).
///
/// Command: [`VehicleDynamicsMode`].
///
/// - Manual mip-sdk-4: Vehicle Dynamics Mode (0x0D,0x10)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VehicleDynamicsModeResponse {
    /// Kind of vehicle.
    pub mode: DynamicsMode,
}

impl Wire for VehicleDynamicsModeResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mode = reader.read()?;
        Ok(Self { mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.mode)?;
        Ok(())
    }
}

impl Field for VehicleDynamicsModeResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x80;
    const NAME: &'static str = "filter.vehicle_dynamics_mode_response";
}

/// Sensor to vehicle frame transformation response (0x0D,0x81).
///
/// Answers Sensor to vehicle frame transformation (0x0D,0x11).
///
/// Command: [`SensorToVehicleFrameTransformation`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.4 Sensor to Vehicle Frame Transformation (0x0D, 0x11)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

impl Wire for SensorToVehicleFrameTransformationResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let roll = reader.read()?;
        let pitch = reader.read()?;
        let yaw = reader.read()?;
        Ok(Self { roll, pitch, yaw })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.roll)?;
        writer.write(&self.pitch)?;
        writer.write(&self.yaw)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x81;
    const NAME: &'static str = "filter.sensor_to_vehicle_frame_transformation_response";
}

/// Sensor to vehicle offset response (0x0D,0x82).
///
/// Answers Sensor to vehicle offset (0x0D,0x12).
///
/// Command: [`SensorToVehicleOffset`].
///
/// - Manual mip-sdk-4: Sensor To Vehicle Offset (0x0D,0x12)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleOffsetResponse {
    /// From the sensor to the origin of the vehicle frame.
    ///
    /// Unit: m; frame: sensor; range: -10 to 10.
    pub offset: types::Vector3f,
}

impl Wire for SensorToVehicleOffsetResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let offset = reader.read()?;
        Ok(Self { offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.offset)?;
        Ok(())
    }
}

impl Field for SensorToVehicleOffsetResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "filter.sensor_to_vehicle_offset_response";
}

/// GNSS antenna offset response (0x0D,0x83).
///
/// Answers GNSS antenna offset (0x0D,0x13).
///
/// Command: [`GnssAntennaOffsetControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Antenna Offset Control (0x0D,0x13)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAntennaOffsetControlResponse {
    /// From the sensor origin to the centre of the antenna.
    ///
    /// Unit: m; frame: vehicle; range: -10 to 10.
    pub offset: types::Vector3f,
}

impl Wire for GnssAntennaOffsetControlResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let offset = reader.read()?;
        Ok(Self { offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.offset)?;
        Ok(())
    }
}

impl Field for GnssAntennaOffsetControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x83;
    const NAME: &'static str = "filter.gnss_antenna_offset_control_response";
}

/// Estimation control flags response (0x0D,0x84).
///
/// Answers Estimation control flags (0x0D,0x14).
///
/// Command: [`EstimationControlFlags`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.5 Estimation Control Flags (0x0D, 0x14)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EstimationControlFlagsResponse {
    /// States to estimate.
    pub flags: EstimatedStates,
}

impl Wire for EstimationControlFlagsResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let flags = reader.read()?;
        Ok(Self { flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.flags)?;
        Ok(())
    }
}

impl Field for EstimationControlFlagsResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x84;
    const NAME: &'static str = "filter.estimation_control_flags_response";
}

/// GNSS aiding source response (0x0D,0x86).
///
/// Answers GNSS aiding source (0x0D,0x15).
///
/// Command: [`GnssAidingSourceControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Aiding Source Control (0x0D,0x15)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAidingSourceControlResponse {
    /// Source of the GNSS data.
    pub source: GnssAidingSource,
}

impl Wire for GnssAidingSourceControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        Ok(Self { source })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        Ok(())
    }
}

impl Field for GnssAidingSourceControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x86;
    const NAME: &'static str = "filter.gnss_aiding_source_control_response";
}

/// Heading update control response (0x0D,0x87).
///
/// Answers Heading update control (0x0D,0x18).
///
/// Command: [`HeadingUpdateControl`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.6 Heading Update Control (0x0D, 0x18)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HeadingUpdateControlResponse {
    /// Source of the heading.
    pub enable: HeadingUpdateSource,
}

impl Wire for HeadingUpdateControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        Ok(Self { enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        Ok(())
    }
}

impl Field for HeadingUpdateControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x87;
    const NAME: &'static str = "filter.heading_update_control_response";
}

/// Automatic initialization response (0x0D,0x88).
///
/// Answers Automatic initialization (0x0D,0x19).
///
/// Command: [`AutoInitializationControl`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.10 Auto-Initialization Control (0x0D, 0x19)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AutoInitializationControlResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
}

impl Wire for AutoInitializationControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        Ok(Self { enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        Ok(())
    }
}

impl Field for AutoInitializationControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x88;
    const NAME: &'static str = "filter.auto_initialization_control_response";
}

/// Accelerometer noise response (0x0D,0x89).
///
/// Answers Accelerometer noise (0x0D,0x1A).
///
/// Command: [`AccelerometerNoiseStandardDeviation`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Accelerometer Noise Standard Deviation (0x0D,0x1A)
/// - Manual 3dm-gx5-15: 4.3.12 Accelerometer Noise Standard Deviation (0x0D, 0x1A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AccelerometerNoiseStandardDeviationResponse {
    /// Standard deviation per axis.
    ///
    /// Unit: m/s^2.
    pub noise: types::Vector3f,
}

impl Wire for AccelerometerNoiseStandardDeviationResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for AccelerometerNoiseStandardDeviationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x89;
    const NAME: &'static str = "filter.accelerometer_noise_standard_deviation_response";
}

/// Gyroscope noise response (0x0D,0x8A).
///
/// Answers Gyroscope noise (0x0D,0x1B).
///
/// Command: [`GyroscopeNoiseStandardDeviation`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Gyroscope Noise Standard Deviation (0x0D,0x1B)
/// - Manual 3dm-gx5-15: 4.3.13 Gyroscope Noise Standard Deviation (0x0D, 0x1B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GyroscopeNoiseStandardDeviationResponse {
    /// Standard deviation per axis.
    ///
    /// Unit: rad/s.
    pub noise: types::Vector3f,
}

impl Wire for GyroscopeNoiseStandardDeviationResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for GyroscopeNoiseStandardDeviationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x8A;
    const NAME: &'static str = "filter.gyroscope_noise_standard_deviation_response";
}

/// Accelerometer bias model response (0x0D,0x8B).
///
/// Answers Accelerometer bias model (0x0D,0x1C).
///
/// Command: [`AccelerometerBiasModelParameters`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Accelerometer Bias Model Parameters (0x0D,0x1C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AccelerometerBiasModelParametersResponse {
    /// Reciprocal of the correlation time per axis.
    ///
    /// Unit: 1/s.
    pub beta: types::Vector3f,
    /// Standard deviation of the noise per axis.
    ///
    /// Unit: m/s^2.
    pub noise: types::Vector3f,
}

impl Wire for AccelerometerBiasModelParametersResponse {
    const SIZE: usize = 24;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let beta = reader.read()?;
        let noise = reader.read()?;
        Ok(Self { beta, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.beta)?;
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for AccelerometerBiasModelParametersResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x8B;
    const NAME: &'static str = "filter.accelerometer_bias_model_parameters_response";
}

/// Gyroscope bias model response (0x0D,0x8C).
///
/// Answers Gyroscope bias model (0x0D,0x1D).
///
/// Command: [`GyroscopeBiasModelParameters`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Gyroscope Bias Model Parameters (0x0D,0x1D)
/// - Manual 3dm-gx5-15: 4.3.14 Gyroscope Bias Model Parameters (0x0D, 0x1D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GyroscopeBiasModelParametersResponse {
    /// Reciprocal of the correlation time per axis.
    ///
    /// Unit: 1/s.
    pub beta: types::Vector3f,
    /// Standard deviation of the noise per axis.
    ///
    /// Unit: rad/s.
    pub noise: types::Vector3f,
}

impl Wire for GyroscopeBiasModelParametersResponse {
    const SIZE: usize = 24;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let beta = reader.read()?;
        let noise = reader.read()?;
        Ok(Self { beta, noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.beta)?;
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for GyroscopeBiasModelParametersResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x8C;
    const NAME: &'static str = "filter.gyroscope_bias_model_parameters_response";
}

/// Automatic zero velocity update response (0x0D,0x8D).
///
/// Answers Automatic zero velocity update (0x0D,0x1E).
///
/// Command: [`AutoZupt`].
///
/// - Manual mip-sdk-4: Auto Zupt (0x0D,0x1E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AutoZuptResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// Largest speed that is taken as zero.
    ///
    /// Unit: m/s; range: at least 0.
    pub threshold: f32,
}

impl Wire for AutoZuptResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let threshold = reader.read()?;
        Ok(Self { enable, threshold })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.threshold)?;
        Ok(())
    }
}

impl Field for AutoZuptResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x8D;
    const NAME: &'static str = "filter.auto_zupt_response";
}

/// Zero angular rate update response (0x0D,0x8E).
///
/// Answers Zero angular rate update (0x0D,0x20).
///
/// Command: [`ZeroAngularRateUpdateControl`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Zero Angular Rate Update Control (0x0D,0x20)
/// - Manual 3dm-gx5-15: 4.3.15 Zero Angular Rate Update Control (0x0D, 0x20)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ZeroAngularRateUpdateControlResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// Largest angular rate that is taken as zero.
    ///
    /// Unit: rad/s; range: at least 0.
    pub threshold: f32,
}

impl Wire for ZeroAngularRateUpdateControlResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let threshold = reader.read()?;
        Ok(Self { enable, threshold })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.threshold)?;
        Ok(())
    }
}

impl Field for ZeroAngularRateUpdateControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x8E;
    const NAME: &'static str = "filter.zero_angular_rate_update_control_response";
}

/// Set reference position response (0x0D,0x90).
///
/// Answers Set reference position (0x0D,0x26).
///
/// Command: [`SetReferencePosition`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.20 Set Reference Position (0x0D, 0x26)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetReferencePositionResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// Latitude.
    ///
    /// Unit: deg; frame: llh.
    pub latitude: f64,
    /// Longitude.
    ///
    /// Unit: deg; frame: llh.
    pub longitude: f64,
    /// Altitude.
    ///
    /// Unit: m; frame: llh.
    pub altitude: f64,
}

impl Wire for SetReferencePositionResponse {
    const SIZE: usize = 25;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let latitude = reader.read()?;
        let longitude = reader.read()?;
        let altitude = reader.read()?;
        Ok(Self { enable, latitude, longitude, altitude })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.latitude)?;
        writer.write(&self.longitude)?;
        writer.write(&self.altitude)?;
        Ok(())
    }
}

impl Field for SetReferencePositionResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "filter.set_reference_position_response";
}

/// Gravity noise response (0x0D,0x93).
///
/// Answers Gravity noise (0x0D,0x28).
///
/// Command: [`GravityNoiseStandardDeviation`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-cv7-gnss-ins: Gravity Noise Standard Deviation (0x0D,0x28)
/// - Manual 3dm-gx5-15: 4.3.11 Gravity Noise Standard Deviation (0x0D, 0x28)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GravityNoiseStandardDeviationResponse {
    /// Standard deviation per axis.
    ///
    /// Unit: g.
    pub noise: types::Vector3f,
}

impl Wire for GravityNoiseStandardDeviationResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for GravityNoiseStandardDeviationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x93;
    const NAME: &'static str = "filter.gravity_noise_standard_deviation_response";
}

/// Pressure altitude noise response (0x0D,0x94).
///
/// Answers Pressure altitude noise (0x0D,0x29).
///
/// Command: [`PressureAltitudeNoise`].
///
/// - Manual mip-sdk-4: Pressure Altitude Noise (0x0D,0x29)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PressureAltitudeNoiseResponse {
    /// Standard deviation.
    ///
    /// Unit: m.
    pub noise: f32,
}

impl Wire for PressureAltitudeNoiseResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for PressureAltitudeNoiseResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x94;
    const NAME: &'static str = "filter.pressure_altitude_noise_response";
}

/// Hard iron offset noise response (0x0D,0x96).
///
/// Answers Hard iron offset noise (0x0D,0x2B).
///
/// Command: [`HardIronOffsetNoise`].
///
/// - Manual mip-sdk-4: Hard Iron Offset Noise (0x0D,0x2B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HardIronOffsetNoiseResponse {
    /// Standard deviation per axis.
    ///
    /// Unit: gauss.
    pub noise: types::Vector3f,
}

impl Wire for HardIronOffsetNoiseResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for HardIronOffsetNoiseResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x96;
    const NAME: &'static str = "filter.hard_iron_offset_noise_response";
}

/// Soft iron matrix noise response (0x0D,0x97).
///
/// Answers Soft iron matrix noise (0x0D,0x2C).
///
/// Command: [`SoftIronMatrixNoise`].
///
/// - Manual mip-sdk-4: Soft Iron Matrix Noise (0x0D,0x2C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SoftIronMatrixNoiseResponse {
    /// Standard deviation per element.
    ///
    /// Unit: 1.
    pub noise: types::Matrix3f,
}

impl Wire for SoftIronMatrixNoiseResponse {
    const SIZE: usize = 36;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for SoftIronMatrixNoiseResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0x97;
    const NAME: &'static str = "filter.soft_iron_matrix_noise_response";
}

/// Tare orientation response (0x0D,0xA1).
///
/// Answers Tare orientation (0x0D,0x21).
///
/// Command: [`TareOrientation`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.16 Tare Orientation (0x0D, 0x21)
/// - Manual mip-sdk-4: Tare Orientation (0x0D,0x21)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TareOrientationResponse {
    /// Axes to tare; 0 resets all axes.
    pub axes: TareAxes,
}

impl Wire for TareOrientationResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let axes = reader.read()?;
        Ok(Self { axes })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.axes)?;
        Ok(())
    }
}

impl Field for TareOrientationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xA1;
    const NAME: &'static str = "filter.tare_orientation_response";
}

/// Enable or disable measurements response (0x0D,0xB0).
///
/// Answers Enable or disable measurements (0x0D,0x41).
///
/// Command: [`EnableDisableMeasurements`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.18 Enable/Disable Measurements (0x0D, 0x41)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EnableDisableMeasurementsResponse {
    /// Measurements to use.
    pub control: MeasurementFlags,
}

impl Wire for EnableDisableMeasurementsResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let control = reader.read()?;
        Ok(Self { control })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.control)?;
        Ok(())
    }
}

impl Field for EnableDisableMeasurementsResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB0;
    const NAME: &'static str = "filter.enable_disable_measurements_response";
}

/// Magnetometer noise response (0x0D,0xB1).
///
/// Answers Magnetometer noise (0x0D,0x42).
///
/// Command: [`MagNoise`].
///
/// - Manual mip-sdk-4: Mag Noise (0x0D,0x42)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagNoiseResponse {
    /// Standard deviation per axis.
    ///
    /// Unit: gauss.
    pub noise: types::Vector3f,
}

impl Wire for MagNoiseResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let noise = reader.read()?;
        Ok(Self { noise })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.noise)?;
        Ok(())
    }
}

impl Field for MagNoiseResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB1;
    const NAME: &'static str = "filter.mag_noise_response";
}

/// Magnetic declination source response (0x0D,0xB2).
///
/// Answers Magnetic declination source (0x0D,0x43).
///
/// Command: [`MagneticFieldDeclinationSourceControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetic Field Declination Source Control (0x0D,0x43)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagneticFieldDeclinationSourceControlResponse {
    /// Source of the declination.
    pub source: MagParameterSource,
    /// Declination; used only if `source` is manual.
    ///
    /// Unit: rad.
    pub declination: f32,
}

impl Wire for MagneticFieldDeclinationSourceControlResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        let declination = reader.read()?;
        Ok(Self { source, declination })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        writer.write(&self.declination)?;
        Ok(())
    }
}

impl Field for MagneticFieldDeclinationSourceControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB2;
    const NAME: &'static str = "filter.magnetic_field_declination_source_control_response";
}

/// Gravity magnitude error adaptive measurement response (0x0D,0xB3).
///
/// Answers Gravity magnitude error adaptive measurement (0x0D,0x44).
///
/// Command: [`GravityMagnitudeErrorAdaptiveMeasurement`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.19 Gravity Magnitude Error Adaptive Measurement (0x0D, 0x44)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

impl Wire for GravityMagnitudeErrorAdaptiveMeasurementResponse {
    const SIZE: usize = 25;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let adaptive_measurement = reader.read()?;
        let frequency = reader.read()?;
        let low_limit = reader.read()?;
        let high_limit = reader.read()?;
        let low_limit_uncertainty = reader.read()?;
        let high_limit_uncertainty = reader.read()?;
        let minimum_uncertainty = reader.read()?;
        Ok(Self {
            adaptive_measurement,
            frequency,
            low_limit,
            high_limit,
            low_limit_uncertainty,
            high_limit_uncertainty,
            minimum_uncertainty,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.adaptive_measurement)?;
        writer.write(&self.frequency)?;
        writer.write(&self.low_limit)?;
        writer.write(&self.high_limit)?;
        writer.write(&self.low_limit_uncertainty)?;
        writer.write(&self.high_limit_uncertainty)?;
        writer.write(&self.minimum_uncertainty)?;
        Ok(())
    }
}

impl Field for GravityMagnitudeErrorAdaptiveMeasurementResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB3;
    const NAME: &'static str = "filter.gravity_magnitude_error_adaptive_measurement_response";
}

/// Magnetometer magnitude error adaptive measurement response (0x0D,0xB4).
///
/// Answers Magnetometer magnitude error adaptive measurement (0x0D,0x45).
///
/// Command: [`MagMagnitudeErrorAdaptiveMeasurement`].
///
/// - Manual mip-sdk-4: Mag Magnitude Error Adaptive Measurement (0x0D,0x45)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagMagnitudeErrorAdaptiveMeasurementResponse {
    /// Kind of adaptation.
    pub adaptive_measurement: AdaptiveMeasurementSelector,
    /// Cut-off frequency of the low-pass filter.
    ///
    /// Unit: Hz.
    pub frequency: f32,
    /// Lower limit of the error.
    ///
    /// Unit: gauss.
    pub low_limit: f32,
    /// Upper limit of the error.
    ///
    /// Unit: gauss.
    pub high_limit: f32,
    /// Standard deviation at the lower limit.
    ///
    /// Unit: gauss.
    pub low_limit_uncertainty: f32,
    /// Standard deviation at the upper limit.
    ///
    /// Unit: gauss.
    pub high_limit_uncertainty: f32,
    /// Smallest standard deviation.
    ///
    /// Unit: gauss.
    pub minimum_uncertainty: f32,
}

impl Wire for MagMagnitudeErrorAdaptiveMeasurementResponse {
    const SIZE: usize = 25;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let adaptive_measurement = reader.read()?;
        let frequency = reader.read()?;
        let low_limit = reader.read()?;
        let high_limit = reader.read()?;
        let low_limit_uncertainty = reader.read()?;
        let high_limit_uncertainty = reader.read()?;
        let minimum_uncertainty = reader.read()?;
        Ok(Self {
            adaptive_measurement,
            frequency,
            low_limit,
            high_limit,
            low_limit_uncertainty,
            high_limit_uncertainty,
            minimum_uncertainty,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.adaptive_measurement)?;
        writer.write(&self.frequency)?;
        writer.write(&self.low_limit)?;
        writer.write(&self.high_limit)?;
        writer.write(&self.low_limit_uncertainty)?;
        writer.write(&self.high_limit_uncertainty)?;
        writer.write(&self.minimum_uncertainty)?;
        Ok(())
    }
}

impl Field for MagMagnitudeErrorAdaptiveMeasurementResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB4;
    const NAME: &'static str = "filter.mag_magnitude_error_adaptive_measurement_response";
}

/// Magnetometer dip angle error adaptive measurement response (0x0D,0xB5).
///
/// Answers Magnetometer dip angle error adaptive measurement (0x0D,0x46).
///
/// Command: [`MagDipAngleErrorAdaptiveMeasurement`].
///
/// - Manual mip-sdk-4: Mag Dip Angle Error Adaptive Measurement (0x0D,0x46)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagDipAngleErrorAdaptiveMeasurementResponse {
    /// Whether the adaptation is on.
    pub enable: crate::Bool,
    /// Cut-off frequency of the low-pass filter.
    ///
    /// Unit: Hz.
    pub frequency: f32,
    /// Upper limit of the error.
    ///
    /// Unit: rad.
    pub high_limit: f32,
    /// Standard deviation at the upper limit.
    ///
    /// Unit: rad.
    pub high_limit_uncertainty: f32,
    /// Smallest standard deviation.
    ///
    /// Unit: rad.
    pub minimum_uncertainty: f32,
}

impl Wire for MagDipAngleErrorAdaptiveMeasurementResponse {
    const SIZE: usize = 17;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let frequency = reader.read()?;
        let high_limit = reader.read()?;
        let high_limit_uncertainty = reader.read()?;
        let minimum_uncertainty = reader.read()?;
        Ok(Self { enable, frequency, high_limit, high_limit_uncertainty, minimum_uncertainty })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.frequency)?;
        writer.write(&self.high_limit)?;
        writer.write(&self.high_limit_uncertainty)?;
        writer.write(&self.minimum_uncertainty)?;
        Ok(())
    }
}

impl Field for MagDipAngleErrorAdaptiveMeasurementResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB5;
    const NAME: &'static str = "filter.mag_dip_angle_error_adaptive_measurement_response";
}

/// Altitude aiding response (0x0D,0xB7).
///
/// Answers Altitude aiding (0x0D,0x47).
///
/// Command: [`AltitudeAiding`].
///
/// - Manual mip-sdk-4: Altitude Aiding (0x0D,0x47)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AltitudeAidingResponse {
    /// Source of the aiding.
    pub selector: AltitudeAidingSource,
}

impl Wire for AltitudeAidingResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let selector = reader.read()?;
        Ok(Self { selector })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.selector)?;
        Ok(())
    }
}

impl Field for AltitudeAidingResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xB7;
    const NAME: &'static str = "filter.altitude_aiding_response";
}

/// Pitch and roll aiding response (0x0D,0xBB).
///
/// Answers Pitch and roll aiding (0x0D,0x4B).
///
/// Command: [`PitchRollAidingControl`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.3.9 Pitch/Roll Aiding Control (0x0D, 0x4B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PitchRollAidingControlResponse {
    /// Source of the aiding.
    pub aiding: PitchRollAidingSource,
}

impl Wire for PitchRollAidingControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let aiding = reader.read()?;
        Ok(Self { aiding })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.aiding)?;
        Ok(())
    }
}

impl Field for PitchRollAidingControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xBB;
    const NAME: &'static str = "filter.pitch_roll_aiding_control_response";
}

/// Magnetic inclination source response (0x0D,0xBC).
///
/// Answers Magnetic inclination source (0x0D,0x4C).
///
/// Command: [`InclinationSource`].
///
/// - Manual mip-sdk-4: Inclination Source (0x0D,0x4C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InclinationSourceResponse {
    /// Source of the inclination.
    pub source: MagParameterSource,
    /// Inclination; used only if `source` is manual.
    ///
    /// Unit: rad.
    pub inclination: f32,
}

impl Wire for InclinationSourceResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        let inclination = reader.read()?;
        Ok(Self { source, inclination })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        writer.write(&self.inclination)?;
        Ok(())
    }
}

impl Field for InclinationSourceResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xBC;
    const NAME: &'static str = "filter.inclination_source_response";
}

/// Magnetic field magnitude source response (0x0D,0xBD).
///
/// Answers Magnetic field magnitude source (0x0D,0x4D).
///
/// Command: [`MagFieldMagnitudeSource`].
///
/// - Manual mip-sdk-4: Mag Field Magnitude Source (0x0D,0x4D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagFieldMagnitudeSourceResponse {
    /// Source of the magnitude.
    pub source: MagParameterSource,
    /// Magnitude; used only if `source` is manual.
    ///
    /// Unit: gauss.
    pub magnitude: f32,
}

impl Wire for MagFieldMagnitudeSourceResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        let magnitude = reader.read()?;
        Ok(Self { source, magnitude })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        writer.write(&self.magnitude)?;
        Ok(())
    }
}

impl Field for MagFieldMagnitudeSourceResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xBD;
    const NAME: &'static str = "filter.mag_field_magnitude_source_response";
}

/// Sensor to vehicle rotation, matrix response (0x0D,0xBE).
///
/// Answers Sensor to vehicle rotation, matrix (0x0D,0x4E).
///
/// Command: [`SensorToVehicleRotationDcm`].
///
/// - Manual mip-sdk-4: Sensor To Vehicle Rotation Dcm (0x0D,0x4E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleRotationDcmResponse {
    /// Rotation matrix in row-major order.
    ///
    /// Unit: 1.
    pub dcm: types::Matrix3f,
}

impl Wire for SensorToVehicleRotationDcmResponse {
    const SIZE: usize = 36;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let dcm = reader.read()?;
        Ok(Self { dcm })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.dcm)?;
        Ok(())
    }
}

impl Field for SensorToVehicleRotationDcmResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xBE;
    const NAME: &'static str = "filter.sensor_to_vehicle_rotation_dcm_response";
}

/// Sensor to vehicle rotation, quaternion response (0x0D,0xBF).
///
/// Answers Sensor to vehicle rotation, quaternion (0x0D,0x4F).
///
/// Command: [`SensorToVehicleRotationQuaternion`].
///
/// - Manual mip-sdk-4: Sensor To Vehicle Rotation Quaternion (0x0D,0x4F)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleRotationQuaternionResponse {
    /// Unit quaternion, scalar part first.
    ///
    /// Unit: 1.
    pub quat: types::Quatf,
}

impl Wire for SensorToVehicleRotationQuaternionResponse {
    const SIZE: usize = 16;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let quat = reader.read()?;
        Ok(Self { quat })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.quat)?;
        Ok(())
    }
}

impl Field for SensorToVehicleRotationQuaternionResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xBF;
    const NAME: &'static str = "filter.sensor_to_vehicle_rotation_quaternion_response";
}

/// Aiding measurement control response (0x0D,0xD0).
///
/// Answers Aiding measurement control (0x0D,0x50).
///
/// Command: [`AidingMeasurementControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Aiding Measurement Control (0x0D,0x50)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AidingMeasurementControlResponse {
    /// The source; `all` is for save, load and default.
    pub aiding_source: AidingSource,
    /// Whether the filter uses the source.
    pub enable: crate::Bool,
}

impl Wire for AidingMeasurementControlResponse {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let aiding_source = reader.read()?;
        let enable = reader.read()?;
        Ok(Self { aiding_source, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.aiding_source)?;
        writer.write(&self.enable)?;
        Ok(())
    }
}

impl Field for AidingMeasurementControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD0;
    const NAME: &'static str = "filter.aiding_measurement_control_response";
}

/// Kinematic constraint response (0x0D,0xD1).
///
/// Answers Kinematic constraint (0x0D,0x51).
///
/// Command: [`KinematicConstraint`].
///
/// - Manual mip-sdk-4: Kinematic Constraint (0x0D,0x51)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct KinematicConstraintResponse {
    /// Assumption about the acceleration.
    ///
    /// Default: none.
    pub accel_constraint: AccelConstraint,
    /// Assumption about the velocity.
    ///
    /// Default: none.
    pub velocity_constraint: VelocityConstraint,
    /// Assumption about the angular rate.
    ///
    /// Default: none.
    pub angular_constraint: AngularConstraint,
}

impl Wire for KinematicConstraintResponse {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let accel_constraint = reader.read()?;
        let velocity_constraint = reader.read()?;
        let angular_constraint = reader.read()?;
        Ok(Self { accel_constraint, velocity_constraint, angular_constraint })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.accel_constraint)?;
        writer.write(&self.velocity_constraint)?;
        writer.write(&self.angular_constraint)?;
        Ok(())
    }
}

impl Field for KinematicConstraintResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD1;
    const NAME: &'static str = "filter.kinematic_constraint_response";
}

/// Navigation filter initialization response (0x0D,0xD2).
///
/// Answers Navigation filter initialization (0x0D,0x52).
///
/// Command: [`NavigationFilterInitialization`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Navigation Filter Initialization (0x0D,0x52)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    /// - If reference_frame_selector is ecef: unit m, frame ecef.
    /// - If reference_frame_selector is llh: unit deg, deg, m, frame llh.
    pub initial_position: types::Vector3f,
    /// Given velocity.
    ///
    /// Unit: m/s.
    ///
    /// - If reference_frame_selector is ecef: frame ecef.
    /// - If reference_frame_selector is llh: frame ned.
    pub initial_velocity: types::Vector3f,
    /// Frame of the given position and velocity.
    pub reference_frame_selector: ReferenceFrame,
}

impl Wire for NavigationFilterInitializationResponse {
    const SIZE: usize = 40;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let wait_for_run_command = reader.read()?;
        let initial_cond_src = reader.read()?;
        let auto_heading_alignment_selector = reader.read()?;
        let initial_heading = reader.read()?;
        let initial_pitch = reader.read()?;
        let initial_roll = reader.read()?;
        let initial_position = reader.read()?;
        let initial_velocity = reader.read()?;
        let reference_frame_selector = reader.read()?;
        Ok(Self {
            wait_for_run_command,
            initial_cond_src,
            auto_heading_alignment_selector,
            initial_heading,
            initial_pitch,
            initial_roll,
            initial_position,
            initial_velocity,
            reference_frame_selector,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.wait_for_run_command)?;
        writer.write(&self.initial_cond_src)?;
        writer.write(&self.auto_heading_alignment_selector)?;
        writer.write(&self.initial_heading)?;
        writer.write(&self.initial_pitch)?;
        writer.write(&self.initial_roll)?;
        writer.write(&self.initial_position)?;
        writer.write(&self.initial_velocity)?;
        writer.write(&self.reference_frame_selector)?;
        Ok(())
    }
}

impl Field for NavigationFilterInitializationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD2;
    const NAME: &'static str = "filter.navigation_filter_initialization_response";
}

/// Adaptive filter control response (0x0D,0xD3).
///
/// Answers Adaptive filter control (0x0D,0x53).
///
/// Command: [`AdaptiveFilterControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Adaptive Filter Control (0x0D,0x53)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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

impl Wire for AdaptiveFilterControlResponse {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let level = reader.read()?;
        let time_limit = reader.read()?;
        Ok(Self { level, time_limit })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.level)?;
        writer.write(&self.time_limit)?;
        Ok(())
    }
}

impl Field for AdaptiveFilterControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD3;
    const NAME: &'static str = "filter.adaptive_filter_control_response";
}

/// GNSS multi-antenna offset response (0x0D,0xD4).
///
/// Answers GNSS multi-antenna offset (0x0D,0x54).
///
/// Command: [`GnssMultiAntennaOffsetControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Multi-Antenna Offset Control (0x0D,0x54)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssMultiAntennaOffsetControlResponse {
    /// Number of the receiver, from 1.
    ///
    /// Range: at least 1.
    pub receiver_id: u8,
    /// From the sensor to the antenna.
    ///
    /// Unit: m; frame: vehicle; range: -10 to 10.
    pub antenna_offset: types::Vector3f,
}

impl Wire for GnssMultiAntennaOffsetControlResponse {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let receiver_id = reader.read()?;
        let antenna_offset = reader.read()?;
        Ok(Self { receiver_id, antenna_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.receiver_id)?;
        writer.write(&self.antenna_offset)?;
        Ok(())
    }
}

impl Field for GnssMultiAntennaOffsetControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD4;
    const NAME: &'static str = "filter.gnss_multi_antenna_offset_control_response";
}

/// Relative position configuration response (0x0D,0xD5).
///
/// Answers Relative position configuration (0x0D,0x55).
///
/// Command: [`RelativePositionConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Relative Position Configuration (0x0D,0x55)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RelativePositionConfigurationResponse {
    /// Source of the reference point.
    pub source: RelativePositionSource,
    /// Frame of the coordinates.
    pub reference_frame_selector: ReferenceFrame,
    /// Reference point.
    ///
    /// - If reference_frame_selector is ecef: unit m, frame ecef.
    /// - If reference_frame_selector is llh: unit deg, deg, m, frame llh.
    pub reference_coordinates: types::Vector3d,
}

impl Wire for RelativePositionConfigurationResponse {
    const SIZE: usize = 26;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        let reference_frame_selector = reader.read()?;
        let reference_coordinates = reader.read()?;
        Ok(Self { source, reference_frame_selector, reference_coordinates })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        writer.write(&self.reference_frame_selector)?;
        writer.write(&self.reference_coordinates)?;
        Ok(())
    }
}

impl Field for RelativePositionConfigurationResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD5;
    const NAME: &'static str = "filter.relative_position_configuration_response";
}

/// Reference point lever arm response (0x0D,0xD6).
///
/// Answers Reference point lever arm (0x0D,0x56).
///
/// Command: [`ReferencePointLeverArm`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Reference point lever arm (0x0D,0x56)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReferencePointLeverArmResponse {
    /// Point to move; it must be 1.
    pub ref_point_sel: ReferencePoint,
    /// From the sensor to the point.
    ///
    /// Unit: m; frame: vehicle; range: -10 to 10.
    pub lever_arm_offset: types::Vector3f,
}

impl Wire for ReferencePointLeverArmResponse {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let ref_point_sel = reader.read()?;
        let lever_arm_offset = reader.read()?;
        Ok(Self { ref_point_sel, lever_arm_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.ref_point_sel)?;
        writer.write(&self.lever_arm_offset)?;
        Ok(())
    }
}

impl Field for ReferencePointLeverArmResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xD6;
    const NAME: &'static str = "filter.reference_point_lever_arm_response";
}

/// Speed measurement lever arm response (0x0D,0xE1).
///
/// Answers Speed measurement lever arm (0x0D,0x61).
///
/// Command: [`MeasurementSpeedLeverArm`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Measurement speed lever arm (0x0D,0x61)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MeasurementSpeedLeverArmResponse {
    /// Send 1.
    ///
    /// Send 1.
    pub source: u8,
    /// From the sensor to the point of measurement.
    ///
    /// Unit: m; frame: vehicle.
    pub lever_arm_offset: types::Vector3f,
}

impl core::default::Default for MeasurementSpeedLeverArmResponse {
    fn default() -> Self {
        Self { source: 1, lever_arm_offset: core::default::Default::default() }
    }
}

impl Wire for MeasurementSpeedLeverArmResponse {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        let lever_arm_offset = reader.read()?;
        Ok(Self { source, lever_arm_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        writer.write(&self.lever_arm_offset)?;
        Ok(())
    }
}

impl Field for MeasurementSpeedLeverArmResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xE1;
    const NAME: &'static str = "filter.measurement_speed_lever_arm_response";
}

/// Vertical gyro constraint response (0x0D,0xE2).
///
/// Answers Vertical gyro constraint (0x0D,0x62).
///
/// Command: [`VerticalGyroConstraintControl`].
///
/// - Manual mip-sdk-4: Vertical Gyro Constraint Control (0x0D,0x62)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct VerticalGyroConstraintControlResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
}

impl Wire for VerticalGyroConstraintControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        Ok(Self { enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        Ok(())
    }
}

impl Field for VerticalGyroConstraintControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xE2;
    const NAME: &'static str = "filter.vertical_gyro_constraint_control_response";
}

/// Wheeled vehicle constraint response (0x0D,0xE3).
///
/// Answers Wheeled vehicle constraint (0x0D,0x63).
///
/// Command: [`WheeledVehicleConstraintControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Wheeled Vehicle Constraint Control (0x0D,0x63)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct WheeledVehicleConstraintControlResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
}

impl Wire for WheeledVehicleConstraintControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        Ok(Self { enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        Ok(())
    }
}

impl Field for WheeledVehicleConstraintControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xE3;
    const NAME: &'static str = "filter.wheeled_vehicle_constraint_control_response";
}

/// GNSS antenna offset calibration response (0x0D,0xE4).
///
/// Answers GNSS antenna offset calibration (0x0D,0x64).
///
/// Command: [`GnssAntennaOffsetCalibrationControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS Antenna Offset Calibration Control (0x0D,0x64)
/// - Manual 3dm-cv7-gnss-ins: Antenna Lever Arm Calibration
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAntennaOffsetCalibrationControlResponse {
    /// 0 disables, 1 enables.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// Largest absolute error that is tracked; the limits are those of the 3DM-CV7.
    ///
    /// Unit: m; frame: vehicle; range: 0 to 0.5; default: 0.1.
    pub max_offset: f32,
}

impl Wire for GnssAntennaOffsetCalibrationControlResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let max_offset = reader.read()?;
        Ok(Self { enable, max_offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.max_offset)?;
        Ok(())
    }
}

impl Field for GnssAntennaOffsetCalibrationControlResponse {
    const SET: u8 = 0x0D;
    const DESCRIPTOR: u8 = 0xE4;
    const NAME: &'static str = "filter.gnss_antenna_offset_calibration_control_response";
}
