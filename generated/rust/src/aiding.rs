//! Aiding commands (0x13): Measurements of external sensors for the navigation filter, and the
//! frames of the sensors.
//!
//! - Manual 3dm-cv7-gnss-ins: Aiding (0x13)
//! - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Union, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x13;

open_enum! {
    /// How the rotation of an aiding frame is given.
    ///
    /// - Manual 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
    AidingFrameFormat: u8 {
        /// Euler angles: roll, pitch, yaw.
        EULER = 1, "euler";
        /// Quaternion: w, x, y, z.
        QUATERNION = 2, "quaternion";
    }
}

open_enum! {
    /// How the device answers aiding measurements.
    ///
    /// - Manual 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
    AidingEchoMode: u8 {
        /// No acknowledge.
        SUPPRESS_ACK = 0, "suppress_ack";
        /// Acknowledge as for any command.
        STANDARD = 1, "standard";
        /// The data come back in a response.
        RESPONSE = 2, "response";
    }
}

open_enum! {
    /// Clock of the time of a measurement.
    Timebase: u8 {
        /// Internal reference clock of the device.
        INTERNAL_REFERENCE = 1, "internal_reference";
        /// External clock, with which the PPS synchronizes the device.
        EXTERNAL_TIME = 2, "external_time";
        /// Latency relative to the arrival of the command.
        TIME_OF_ARRIVAL = 3, "time_of_arrival";
    }
}

/// When a measurement was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MeasurementTime {
    /// Clock of the time.
    pub timebase: Timebase,
    /// Reserved.
    ///
    /// Send 1.
    pub reserved: u8,
    /// Time by that clock.
    ///
    /// Unit: ns.
    pub nanoseconds: u64,
}

impl core::default::Default for MeasurementTime {
    fn default() -> Self {
        Self {
            timebase: core::default::Default::default(),
            reserved: 1,
            nanoseconds: core::default::Default::default(),
        }
    }
}

impl MeasurementTime {
    /// Puts the values together.
    #[must_use]
    pub fn new(timebase: Timebase, nanoseconds: u64) -> Self {
        Self { timebase, reserved: 1, nanoseconds }
    }
}

impl Wire for MeasurementTime {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let timebase = reader.read()?;
        let reserved = reader.read()?;
        let nanoseconds = reader.read()?;
        Ok(Self { timebase, reserved, nanoseconds })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.timebase)?;
        writer.write(&self.reserved)?;
        writer.write(&self.nanoseconds)?;
        Ok(())
    }
}

bitfield! {
    /// Which axes of a measurement are valid; the others are ignored.
    AxisFlags: u16 {
        /// First axis.
        X: bool = 0,
            "x", x, set_x, with_x;
        /// Second axis.
        Y: bool = 1,
            "y", y, set_y, with_y;
        /// Third axis.
        Z: bool = 2,
            "z", z, set_z, with_z;
    }
}

bitfield! {
    /// Which coordinates of a position are valid; the others are ignored.
    LlhAxisFlags: u16 {
        /// Latitude and its uncertainty.
        LATITUDE: bool = 0,
            "latitude", latitude, set_latitude, with_latitude;
        /// Longitude and its uncertainty.
        LONGITUDE: bool = 1,
            "longitude", longitude, set_longitude, with_longitude;
        /// Height and its uncertainty.
        HEIGHT: bool = 2,
            "height", height, set_height, with_height;
    }
}

/// Frame configuration (0x13,0x01).
///
/// Where and how an external sensor is mounted on the vehicle.
///
/// - Aiding measurements name the frame by its number.
/// - p_vehicle = R \* p_frame + t, with the rotation R and the translation t.
/// - The rotation does not matter for GNSS positions and velocities; set it to zero.
/// - A read names the format that the answer shall have.
///
/// Functions: write, read, save, load, default. Response: [`FrameConfigurationResponse`]. Supported
/// by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
/// - Manual 3dm-cv7-gnss-ins: Aiding Frames
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrameConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Number of the frame.
    ///
    /// Range: 1 to 4.
    pub frame_id: Option<u8>,
    /// How the rotation is given.
    pub format: Option<AidingFrameFormat>,
    /// Whether the filter estimates the errors of the frame.
    pub tracking_enabled: Option<crate::Bool>,
    /// Origin of the frame in the vehicle.
    ///
    /// Unit: m; frame: vehicle.
    pub translation: Option<types::Vector3f>,
    /// Rotation from the frame to the vehicle.
    ///
    /// Selected by `format`.
    pub rotation: Option<FrameConfigurationRotation>,
}

impl FrameConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        frame_id: u8,
        tracking_enabled: bool,
        translation: impl Into<types::Vector3f>,
        rotation: FrameConfigurationRotation,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            frame_id: Some(frame_id),
            format: Some(rotation.tag()),
            tracking_enabled: Some(tracking_enabled.into()),
            translation: Some(translation.into()),
            rotation: Some(rotation),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(frame_id: u8, format: AidingFrameFormat) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            frame_id: Some(frame_id),
            format: Some(format),
            tracking_enabled: None,
            translation: None,
            rotation: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(frame_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            frame_id: Some(frame_id),
            format: None,
            tracking_enabled: None,
            translation: None,
            rotation: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(frame_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            frame_id: Some(frame_id),
            format: None,
            tracking_enabled: None,
            translation: None,
            rotation: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(frame_id: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            frame_id: Some(frame_id),
            format: None,
            tracking_enabled: None,
            translation: None,
            rotation: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 5,
            F::READ => 2,
            F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for FrameConfiguration {
    const SIZE: usize = 32;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let frame_id = reader.group(required >= 1, Reader::read)?;
        let format = reader.group(required >= 2, Reader::read)?;
        let tracking_enabled = reader.group(required >= 3, Reader::read)?;
        let translation = reader.group(required >= 4, Reader::read)?;
        let rotation = reader.some_union(required >= 5, format)?;
        Ok(Self { function, frame_id, format, tracking_enabled, translation, rotation })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.frame_id)?;
        writer.some(required >= 2, &self.format)?;
        writer.some(required >= 3, &self.tracking_enabled)?;
        writer.some(required >= 4, &self.translation)?;
        writer.some_union(required >= 5, self.format, &self.rotation)?;
        Ok(())
    }
}

/// The alternatives of `rotation` in [`FrameConfiguration`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FrameConfigurationRotation {
    /// Roll, pitch and yaw.
    Euler(types::Vector3f),
    /// Quaternion, scalar part first.
    Quaternion(types::Quatf),
    /// Nothing, for a tag that the specification does not know.
    Other(AidingFrameFormat),
}

impl core::default::Default for FrameConfigurationRotation {
    fn default() -> Self {
        Self::Other(AidingFrameFormat(0))
    }
}

impl FrameConfigurationRotation {
    /// The tag that goes with it.
    #[must_use]
    pub const fn tag(&self) -> AidingFrameFormat {
        match self {
            Self::Euler(_) => AidingFrameFormat::EULER,
            Self::Quaternion(_) => AidingFrameFormat::QUATERNION,
            Self::Other(tag) => *tag,
        }
    }
}

impl Union for FrameConfigurationRotation {
    type Tag = AidingFrameFormat;

    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(match tag {
            AidingFrameFormat::EULER => Self::Euler(reader.read()?),
            AidingFrameFormat::QUATERNION => Self::Quaternion(reader.read()?),
            other => Self::Other(other),
        })
    }

    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        if self.tag() != tag {
            return Err(EncodeError::Tag);
        }
        match self {
            Self::Euler(value) => writer.write(value),
            Self::Quaternion(value) => writer.write(value),
            Self::Other(tag) if tag.name().is_some() => Err(EncodeError::Tag),
            Self::Other(_) => Ok(()),
        }
    }
}

impl Field for FrameConfiguration {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "aiding.frame_configuration";
}

impl Command for FrameConfiguration {
    type Response = FrameConfigurationResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        if !matches!(self.function, types::FunctionSelector::READ) {
            return None;
        }
        Some(crate::field::check::<FrameConfigurationResponse>)
    }
}

impl ResponseOf<FrameConfiguration> for FrameConfigurationResponse {}

/// Echo control (0x13,0x1F).
///
/// How the device answers aiding measurements.
///
/// - The manual does not give the layout of the responses that carry the data back.
///
/// Functions: write, read, save, load, default. Response: [`EchoControlResponse`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
/// - Manual 3dm-cv7-gnss-ins: Aiding Command Echo Control
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EchoControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// How they are answered.
    pub mode: Option<AidingEchoMode>,
}

impl EchoControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(mode: AidingEchoMode) -> Self {
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

impl Wire for EchoControl {
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

impl Field for EchoControl {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x1F;
    const NAME: &'static str = "aiding.echo_control";
}

impl Command for EchoControl {
    type Response = EchoControlResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        if !matches!(self.function, types::FunctionSelector::READ) {
            return None;
        }
        Some(crate::field::check::<EchoControlResponse>)
    }
}

impl ResponseOf<EchoControl> for EchoControlResponse {}

/// ECEF position (0x13,0x21).
///
/// A measured position in Earth-fixed coordinates.
///
/// - Use only one form of position: ECEF or LLH.
/// - The uncertainty of a valid axis must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: ECEF Position (0x13,0x21)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> ECEF Position
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EcefPosition {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Position.
    ///
    /// Unit: m; frame: ecef; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub position: types::Vector3d,
    /// Uncertainty of the position.
    ///
    /// Unit: m; frame: ecef; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub uncertainty: types::Vector3f,
    /// Which axes are valid.
    pub valid_flags: AxisFlags,
}

impl EcefPosition {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        position: impl Into<types::Vector3d>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    ) -> Self {
        Self {
            time,
            frame_id,
            position: position.into(),
            uncertainty: uncertainty.into(),
            valid_flags,
        }
    }
}

impl Wire for EcefPosition {
    const SIZE: usize = 49;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let position = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, position, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.position)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for EcefPosition {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x21;
    const NAME: &'static str = "aiding.ecef_position";
}

impl Command for EcefPosition {
    type Response = ();
}

/// LLH position (0x13,0x22).
///
/// A measured position as latitude, longitude and height.
///
/// - Use only one form of position: ECEF or LLH.
/// - The uncertainty of a valid axis must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: LLH Position (0x13,0x22)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> LLH Position
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LlhPosition {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Latitude.
    ///
    /// Unit: deg; frame: llh; valid if `valid_flags.latitude` is set.
    pub latitude: f64,
    /// Longitude.
    ///
    /// Unit: deg; frame: llh; valid if `valid_flags.longitude` is set.
    pub longitude: f64,
    /// Height above the ellipsoid.
    ///
    /// Unit: m; frame: llh; valid if `valid_flags.height` is set.
    pub height: f64,
    /// Uncertainty along north, east and down.
    ///
    /// Unit: m; frame: ned; valid if `valid_flags.latitude, valid_flags.longitude,
    /// valid_flags.height` is set.
    pub uncertainty: types::Vector3f,
    /// Which coordinates are valid.
    pub valid_flags: LlhAxisFlags,
}

impl LlhPosition {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        latitude: f64,
        longitude: f64,
        height: f64,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: LlhAxisFlags,
    ) -> Self {
        Self {
            time,
            frame_id,
            latitude,
            longitude,
            height,
            uncertainty: uncertainty.into(),
            valid_flags,
        }
    }
}

impl Wire for LlhPosition {
    const SIZE: usize = 49;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let latitude = reader.read()?;
        let longitude = reader.read()?;
        let height = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, latitude, longitude, height, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.latitude)?;
        writer.write(&self.longitude)?;
        writer.write(&self.height)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for LlhPosition {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x22;
    const NAME: &'static str = "aiding.llh_position";
}

impl Command for LlhPosition {
    type Response = ();
}

/// Height above ellipsoid (0x13,0x23).
///
/// A measured height.
///
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Height Above Ellipsoid (0x13,0x23)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HeightAboveEllipsoid {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Height above the ellipsoid.
    ///
    /// Unit: m; frame: llh.
    pub height: f32,
    /// Uncertainty of the height.
    ///
    /// Unit: m.
    pub uncertainty: f32,
    /// Not 0: the measurement is valid.
    pub valid_flags: u16,
}

impl HeightAboveEllipsoid {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        height: f32,
        uncertainty: f32,
        valid_flags: u16,
    ) -> Self {
        Self { time, frame_id, height, uncertainty, valid_flags }
    }
}

impl Wire for HeightAboveEllipsoid {
    const SIZE: usize = 21;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let height = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, height, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.height)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for HeightAboveEllipsoid {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x23;
    const NAME: &'static str = "aiding.height_above_ellipsoid";
}

impl Command for HeightAboveEllipsoid {
    type Response = ();
}

/// ECEF velocity (0x13,0x28).
///
/// A measured velocity in Earth-fixed coordinates.
///
/// - Use only one form of velocity: ECEF or NED.
/// - Not for a sensor that is fixed to the vehicle; that takes body_frame_velocity.
/// - The uncertainty of a valid axis must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: ECEF Velocity (0x13,0x28)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> ECEF Velocity
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EcefVelocity {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Velocity.
    ///
    /// Unit: m/s; frame: ecef; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub velocity: types::Vector3f,
    /// Uncertainty of the velocity.
    ///
    /// Unit: m/s; frame: ecef; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub uncertainty: types::Vector3f,
    /// Which axes are valid.
    pub valid_flags: AxisFlags,
}

impl EcefVelocity {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        velocity: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    ) -> Self {
        Self {
            time,
            frame_id,
            velocity: velocity.into(),
            uncertainty: uncertainty.into(),
            valid_flags,
        }
    }
}

impl Wire for EcefVelocity {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let velocity = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, velocity, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.velocity)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for EcefVelocity {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x28;
    const NAME: &'static str = "aiding.ecef_velocity";
}

impl Command for EcefVelocity {
    type Response = ();
}

/// NED velocity (0x13,0x29).
///
/// A measured velocity in the local level frame.
///
/// - Use only one form of velocity: ECEF or NED.
/// - Not for a sensor that is fixed to the vehicle; that takes body_frame_velocity.
/// - The uncertainty of a valid axis must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: NED Velocity (0x13,0x29)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> NED Velocity
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NedVelocity {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Velocity.
    ///
    /// Unit: m/s; frame: ned; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub velocity: types::Vector3f,
    /// Uncertainty of the velocity.
    ///
    /// Unit: m/s; frame: ned; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub uncertainty: types::Vector3f,
    /// Which axes are valid.
    pub valid_flags: AxisFlags,
}

impl NedVelocity {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        velocity: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    ) -> Self {
        Self {
            time,
            frame_id,
            velocity: velocity.into(),
            uncertainty: uncertainty.into(),
            valid_flags,
        }
    }
}

impl Wire for NedVelocity {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let velocity = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, velocity, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.velocity)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for NedVelocity {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x29;
    const NAME: &'static str = "aiding.ned_velocity";
}

impl Command for NedVelocity {
    type Response = ();
}

/// Body frame velocity (0x13,0x2A).
///
/// A measured velocity of the vehicle in the frame of the sensor.
///
/// - An uncertainty of a valid axis that is not greater than 0 is refused as an invalid parameter.
/// - The device takes up to four sensors of this kind.
/// - A wheeled vehicle constraint is a velocity of 0 with y valid only, sent at least once in a
///   second.
/// - A zero velocity update is a velocity of 0, sent while the GNSS speed is below a threshold of
///   the user.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Body Frame Velocity (0x13,0x2A)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> Body Frame Velocity
/// - Manual 3dm-cv7-gnss-ins: Filter Kinematic Constraints
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BodyFrameVelocity {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Velocity in the frame of the sensor.
    ///
    /// Unit: m/s; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub velocity: types::Vector3f,
    /// Standard deviation of the velocity.
    ///
    /// Unit: m/s; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub uncertainty: types::Vector3f,
    /// Which axes are valid.
    pub valid_flags: AxisFlags,
}

impl BodyFrameVelocity {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        velocity: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    ) -> Self {
        Self {
            time,
            frame_id,
            velocity: velocity.into(),
            uncertainty: uncertainty.into(),
            valid_flags,
        }
    }
}

impl Wire for BodyFrameVelocity {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let velocity = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, velocity, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.velocity)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for BodyFrameVelocity {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x2A;
    const NAME: &'static str = "aiding.body_frame_velocity";
}

impl Command for BodyFrameVelocity {
    type Response = ();
}

/// True heading (0x13,0x31).
///
/// A measured heading relative to true north.
///
/// - The uncertainty of a valid measurement must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: True Heading (0x13,0x31)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> True Heading
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TrueHeading {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Heading.
    ///
    /// Unit: rad; frame: ned; range: -3.141592653589793 to 3.141592653589793.
    pub heading: f32,
    /// Uncertainty of the heading.
    ///
    /// Unit: rad.
    pub uncertainty: f32,
    /// Not 0: the measurement is valid.
    pub valid_flags: u16,
}

impl TrueHeading {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        heading: f32,
        uncertainty: f32,
        valid_flags: u16,
    ) -> Self {
        Self { time, frame_id, heading, uncertainty, valid_flags }
    }
}

impl Wire for TrueHeading {
    const SIZE: usize = 21;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let heading = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, heading, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.heading)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for TrueHeading {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x31;
    const NAME: &'static str = "aiding.true_heading";
}

impl Command for TrueHeading {
    type Response = ();
}

/// Magnetic field (0x13,0x32).
///
/// A magnetic field measured by an external magnetometer.
///
/// - The magnetometer must be calibrated.
/// - The uncertainty of a valid axis must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetic Field (0x13,0x32)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> External Magnetometer
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagneticField {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Magnetic field in the frame of the sensor.
    ///
    /// Unit: gauss; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub magnetic_field: types::Vector3f,
    /// Standard deviation of the magnetic field.
    ///
    /// Unit: gauss; valid if `valid_flags.x, valid_flags.y, valid_flags.z` is set.
    pub uncertainty: types::Vector3f,
    /// Which axes are valid.
    pub valid_flags: AxisFlags,
}

impl MagneticField {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        magnetic_field: impl Into<types::Vector3f>,
        uncertainty: impl Into<types::Vector3f>,
        valid_flags: AxisFlags,
    ) -> Self {
        Self {
            time,
            frame_id,
            magnetic_field: magnetic_field.into(),
            uncertainty: uncertainty.into(),
            valid_flags,
        }
    }
}

impl Wire for MagneticField {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let magnetic_field = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, magnetic_field, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.magnetic_field)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for MagneticField {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x32;
    const NAME: &'static str = "aiding.magnetic_field";
}

impl Command for MagneticField {
    type Response = ();
}

/// Pressure (0x13,0x33).
///
/// A static air pressure measured by an external sensor.
///
/// - The uncertainty of a valid measurement must be greater than 0.
/// - The echo control (0x13,0x1F) decides how the device answers.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Pressure (0x13,0x33)
/// - Manual 3dm-cv7-gnss-ins: Filter Aiding Measurements \> External Pressure
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pressure {
    /// When the measurement was taken.
    pub time: MeasurementTime,
    /// Frame of the sensor.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// Air pressure.
    ///
    /// Unit: mbar.
    pub pressure: f32,
    /// Standard deviation of the pressure.
    ///
    /// Unit: mbar.
    pub uncertainty: f32,
    /// Not 0: the measurement is valid.
    pub valid_flags: u16,
}

impl Pressure {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        time: MeasurementTime,
        frame_id: u8,
        pressure: f32,
        uncertainty: f32,
        valid_flags: u16,
    ) -> Self {
        Self { time, frame_id, pressure, uncertainty, valid_flags }
    }
}

impl Wire for Pressure {
    const SIZE: usize = 21;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        let frame_id = reader.read()?;
        let pressure = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { time, frame_id, pressure, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        writer.write(&self.frame_id)?;
        writer.write(&self.pressure)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for Pressure {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x33;
    const NAME: &'static str = "aiding.pressure";
}

impl Command for Pressure {
    type Response = ();
}

/// Frame configuration response (0x13,0x81).
///
/// Answers Frame configuration (0x13,0x01).
///
/// Command: [`FrameConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Frame Configuration (0x13,0x01)
/// - Manual 3dm-cv7-gnss-ins: Aiding Frames
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrameConfigurationResponse {
    /// Number of the frame.
    ///
    /// Range: 1 to 4.
    pub frame_id: u8,
    /// How the rotation is given.
    pub format: AidingFrameFormat,
    /// Whether the filter estimates the errors of the frame.
    pub tracking_enabled: crate::Bool,
    /// Origin of the frame in the vehicle.
    ///
    /// Unit: m; frame: vehicle.
    pub translation: types::Vector3f,
    /// Rotation from the frame to the vehicle.
    ///
    /// Selected by `format`.
    pub rotation: FrameConfigurationRotation,
}

impl Wire for FrameConfigurationResponse {
    const SIZE: usize = 31;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let frame_id = reader.read()?;
        let format = reader.read()?;
        let tracking_enabled = reader.read()?;
        let translation = reader.read()?;
        let rotation = reader.union(format)?;
        Ok(Self { frame_id, format, tracking_enabled, translation, rotation })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.frame_id)?;
        writer.write(&self.format)?;
        writer.write(&self.tracking_enabled)?;
        writer.write(&self.translation)?;
        writer.union(self.format, &self.rotation)?;
        Ok(())
    }
}

impl Field for FrameConfigurationResponse {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x81;
    const NAME: &'static str = "aiding.frame_configuration_response";
}

/// Echo control response (0x13,0x9F).
///
/// Answers Echo control (0x13,0x1F).
///
/// Command: [`EchoControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Echo Control (0x13,0x1F)
/// - Manual 3dm-cv7-gnss-ins: Aiding Command Echo Control
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EchoControlResponse {
    /// How they are answered.
    pub mode: AidingEchoMode,
}

impl Wire for EchoControlResponse {
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

impl Field for EchoControlResponse {
    const SET: u8 = 0x13;
    const DESCRIPTOR: u8 = 0x9F;
    const NAME: &'static str = "aiding.echo_control_response";
}
