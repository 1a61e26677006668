//! Tools (0x01): Commands of every shape.

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Union, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x01;

bitfield! {
    /// Of the model A.
    ModelAFaults: u32 {
        /// Clock.
        CLOCK: bool = 0,
            "clock", clock, set_clock, with_clock;
        /// Sensor.
        SENSOR: bool = 8,
            "sensor", sensor, set_sensor, with_sensor;
        /// Solution.
        SOLUTION: bool = 24,
            "solution", solution, set_solution, with_solution;
    }
}

bitfield! {
    /// Of the model B.
    ModelBFaults: u32 {
        /// General.
        GENERAL: bool = 0,
            "general", general, set_general, with_general;
        /// Overload.
        OVERLOAD: bool = 1,
            "overload", overload, set_overload, with_overload;
        /// Accel.
        ACCEL: bool = 12,
            "accel", accel, set_accel, with_accel;
    }
}

open_enum! {
    /// Which member the union has.
    Shape: u8 {
        /// None.
        NONE = 0, "none";
        /// Circle.
        CIRCLE = 1, "circle";
        /// Path.
        PATH = 2, "path";
        /// Turn.
        TURN = 3, "turn";
        /// Label.
        LABEL = 4, "label";
    }
}

open_enum! {
    /// How a circle is filled.
    Fill: u8 {
        /// Empty.
        EMPTY = 0, "empty";
        /// Solid.
        SOLID = 1, "solid";
        /// Striped.
        STRIPED = 2, "striped";
    }
}

/// Two numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stripes {
    /// Of a stripe.
    ///
    /// Unit: m.
    pub width: f64,
    /// Of all stripes.
    ///
    /// Unit: deg; range: -180 to 180.
    pub angle: f32,
}

impl Stripes {
    /// Puts the values together.
    #[must_use]
    pub fn new(width: f64, angle: f32) -> Self {
        Self { width, angle }
    }
}

impl Wire for Stripes {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let width = reader.read()?;
        let angle = reader.read()?;
        Ok(Self { width, angle })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.width)?;
        writer.write(&self.angle)?;
        Ok(())
    }
}

/// Ends in a union of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Circle {
    /// The middle.
    pub center: types::Point,
    /// Which member follows.
    pub fill: Fill,
    /// How it is filled.
    ///
    /// Selected by `fill`.
    pub filling: CircleFilling,
}

impl Circle {
    /// Puts the values together.
    #[must_use]
    pub fn new(center: types::Point, filling: CircleFilling) -> Self {
        Self { center, fill: filling.tag(), filling }
    }
}

impl Wire for Circle {
    const SIZE: usize = 17;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let center = reader.read()?;
        let fill = reader.read()?;
        let filling = reader.union(fill)?;
        Ok(Self { center, fill, filling })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.center)?;
        writer.write(&self.fill)?;
        writer.union(self.fill, &self.filling)?;
        Ok(())
    }
}

/// The alternatives of `filling` in [`Circle`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum CircleFilling {
    /// Empty.
    #[default]
    Empty,
    /// A colour.
    Solid(u32),
    /// Striped.
    Striped(Stripes),
    /// Nothing, for a tag that the specification does not know.
    Other(Fill),
}

impl CircleFilling {
    /// The tag that goes with it.
    #[must_use]
    pub const fn tag(&self) -> Fill {
        match self {
            Self::Empty => Fill::EMPTY,
            Self::Solid(_) => Fill::SOLID,
            Self::Striped(_) => Fill::STRIPED,
            Self::Other(tag) => *tag,
        }
    }
}

impl Union for CircleFilling {
    type Tag = Fill;

    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(match tag {
            Fill::EMPTY => Self::Empty,
            Fill::SOLID => Self::Solid(reader.read()?),
            Fill::STRIPED => Self::Striped(reader.read()?),
            other => Self::Other(other),
        })
    }

    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        if self.tag() != tag {
            return Err(EncodeError::Tag);
        }
        match self {
            Self::Empty => Ok(()),
            Self::Solid(value) => writer.write(value),
            Self::Striped(value) => writer.write(value),
            Self::Other(tag) if tag.name().is_some() => Err(EncodeError::Tag),
            Self::Other(_) => Ok(()),
        }
    }
}

/// A counted array at its end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Path {
    /// Does it return to its start?
    pub closed: crate::Bool,
    /// The points.
    pub points: crate::List<types::Point, 62>,
}

impl Path {
    /// Puts the values together.
    #[must_use]
    pub fn new(closed: bool, points: impl Into<crate::List<types::Point, 62>>) -> Self {
        Self { closed: closed.into(), points: points.into() }
    }
}

impl Wire for Path {
    const SIZE: usize = 250;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let closed = reader.read()?;
        let num_points = reader.read::<u8>()?;
        let points = reader.list(num_points)?;
        Ok(Self { closed, points })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.closed)?;
        writer.count::<u8>(self.points.len())?;
        self.points.encode_items(writer)?;
        Ok(())
    }
}

open_enum! {
    /// What drives a pin.
    Drive: u8 {
        /// Off.
        OFF = 0, "off";
        /// Pulse.
        PULSE = 1, "pulse";
        /// Serial.
        SERIAL = 2, "serial";
    }
}

open_enum! {
    /// Of a pulse.
    PulseUse: u8 {
        /// Input.
        INPUT = 1, "input";
        /// Output.
        OUTPUT = 2, "output";
    }
}

open_enum! {
    /// Of a serial line.
    SerialUse: u8 {
        /// Receive.
        RECEIVE = 1, "receive";
        /// Transmit.
        TRANSMIT = 33, "transmit";
    }
}

/// Ping (0x01,0x01).
///
/// Tests the line.
///
/// Supported by Model A and Model B.
///
/// - Manual guide: Ping
/// - Manual leaflet: Ping
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ping;

impl Ping {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for Ping {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for Ping {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "tools.ping";
}

impl Command for Ping {
    type Response = ();
}

/// Settings (0x01,0x02).
///
/// Every function, and a prefix of parameters for each.
///
/// Functions: write, read, save, load, default, apply. Response: [`SettingsResponse`]. Supported by
/// Model A and Model B.
///
/// - Manual guide: Settings
/// - Manual leaflet: Settings
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Settings {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Number of the port, 0 for all.
    ///
    /// Range: 0 to 8.
    pub port: Option<u8>,
    /// What to do.
    ///
    /// Default: fast.
    pub mode: Option<types::Mode>,
    /// Speed.
    ///
    /// Unit: Bd; default: 115200.
    pub baud: Option<u32>,
    /// Required by no function, not even by write.
    ///
    /// - If mode is fast: unit s, range 1 to 10, factory default 5.
    /// - If mode is slow: unit m.
    pub limit: Option<u16>,
    /// Reserved.
    ///
    /// Send 1.
    pub reserved: Option<u8>,
}

impl Settings {
    /// Apply the new setting.
    #[must_use]
    pub fn write(port: u8, mode: types::Mode, baud: u32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            port: Some(port),
            mode: Some(mode),
            baud: Some(baud),
            limit: None,
            reserved: None,
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(port: u8, mode: types::Mode) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            port: Some(port),
            mode: Some(mode),
            baud: None,
            limit: None,
            reserved: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(port: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            port: Some(port),
            mode: None,
            baud: None,
            limit: None,
            reserved: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(port: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            port: Some(port),
            mode: None,
            baud: None,
            limit: None,
            reserved: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(port: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            port: Some(port),
            mode: None,
            baud: None,
            limit: None,
            reserved: None,
        }
    }

    /// Apply the new setting and send no acknowledge (5-series devices).
    #[must_use]
    pub fn apply(port: u8, mode: types::Mode, baud: u32) -> Self {
        Self {
            function: types::FunctionSelector::APPLY,
            port: Some(port),
            mode: Some(mode),
            baud: Some(baud),
            limit: None,
            reserved: None,
        }
    }

    /// With `limit`, which is optional.
    #[must_use]
    pub fn with_limit(mut self, limit: u16) -> Self {
        self.limit = Some(limit);
        self
    }

    /// With `reserved`, which is optional.
    #[must_use]
    pub fn with_reserved(mut self, reserved: u8) -> Self {
        self.reserved = Some(reserved);
        self
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE | F::APPLY => 3,
            F::READ => 2,
            F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for Settings {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let port = reader.group(required >= 1, Reader::read)?;
        let mode = reader.group(required >= 2, Reader::read)?;
        let baud = reader.group(required >= 3, Reader::read)?;
        let limit = reader.group(false, Reader::read)?;
        let reserved = reader.group(false, Reader::read)?;
        Ok(Self { function, port, mode, baud, limit, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.port)?;
        writer.some(required >= 2, &self.mode)?;
        writer.some(required >= 3, &self.baud)?;
        writer.some(false, &self.limit)?;
        writer.some(false, &self.reserved)?;
        Ok(())
    }
}

impl Field for Settings {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "tools.settings";
}

impl Command for Settings {
    type Response = SettingsResponse;

    fn expects_reply(&self) -> bool {
        !matches!(self.function, types::FunctionSelector::APPLY)
    }

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<Settings> for SettingsResponse {}

/// Set time (0x01,0x03).
///
/// Two responses for one command.
///
/// - Send it once a second.
///
/// Functions: write, read, apply. Response: one of [`SetTimeResponses`]. Supported by Model A.
///
/// - Manual guide: Set time
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetTime {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Which half of the time.
    pub part: Option<types::Mode>,
    /// The new value.
    ///
    /// Unit: s.
    pub value: Option<u32>,
}

impl SetTime {
    /// Apply the new setting.
    #[must_use]
    pub fn write(part: types::Mode, value: u32) -> Self {
        Self { function: types::FunctionSelector::WRITE, part: Some(part), value: Some(value) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(part: types::Mode) -> Self {
        Self { function: types::FunctionSelector::READ, part: Some(part), value: None }
    }

    /// Apply the new setting and send no acknowledge (5-series devices).
    #[must_use]
    pub fn apply(part: types::Mode, value: u32) -> Self {
        Self { function: types::FunctionSelector::APPLY, part: Some(part), value: Some(value) }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE | F::APPLY => 2,
            F::READ => 1,
            _ => 0,
        }
    }
}

impl Wire for SetTime {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let part = reader.group(required >= 1, Reader::read)?;
        let value = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, part, value })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.part)?;
        writer.some(required >= 2, &self.value)?;
        Ok(())
    }
}

impl Field for SetTime {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "tools.set_time";
}

impl Command for SetTime {
    type Response = SetTimeResponses;

    fn expects_reply(&self) -> bool {
        !matches!(self.function, types::FunctionSelector::APPLY)
    }

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SetTime> for SetTimeFastResponse {}

impl ResponseOf<SetTime> for SetTimeSlowResponse {}

crate::macros::responses! {
    /// What [`SetTime`] is answered with.
    SetTimeResponses {
        /// The response [`SetTimeFastResponse`].
        Fast(SetTimeFastResponse),
        /// The response [`SetTimeSlowResponse`].
        Slow(SetTimeSlowResponse),
    }
}

/// Status (0x01,0x04).
///
/// Two layouts of one response, told apart by constants.
///
/// Response: one of [`StatusResponses`]. The device may take 2.5 s. For advanced use. Supported by
/// Model A and Model B.
///
/// - Manual guide: Status
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Status {
    /// Which layout.
    ///
    /// Range: 1 to 2.
    pub selector: u8,
}

impl Status {
    /// The command with its parameters.
    #[must_use]
    pub fn new(selector: u8) -> Self {
        Self { selector }
    }
}

impl Wire for Status {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.constant::<u16>(4711)?;
        let selector = reader.read()?;
        Ok(Self { selector })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write::<u16>(&4711)?;
        writer.write(&self.selector)?;
        Ok(())
    }
}

impl Field for Status {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "tools.status";
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[18, 103])];
}

impl Command for Status {
    type Response = StatusResponses;
    const TIMEOUT_MS: Option<u32> = Some(2500);

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<Status> for StatusShort {}

impl ResponseOf<Status> for StatusLong {}

crate::macros::responses! {
    /// What [`Status`] is answered with.
    StatusResponses {
        /// The response [`StatusShort`].
        Short(StatusShort),
        /// The response [`StatusLong`].
        Long(StatusLong),
    }
}

/// Bias (0x01,0x05).
///
/// Its response serves another command too.
///
/// Functions: write, read, save, load, default. Response: [`BiasVector`]. Supported by Model A.
///
/// - Manual guide: Bias
/// - Manual leaflet: Bias
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bias {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Taken off the measurement.
    ///
    /// Unit: g; frame: sensor.
    pub bias: Option<types::Vector3f>,
}

impl Bias {
    /// Apply the new setting.
    #[must_use]
    pub fn write(bias: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, bias: Some(bias.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, bias: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, bias: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, bias: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, bias: None }
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

impl Wire for Bias {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let bias = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, bias })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.bias)?;
        Ok(())
    }
}

impl Field for Bias {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x05;
    const NAME: &'static str = "tools.bias";
}

impl Command for Bias {
    type Response = BiasVector;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<Bias> for BiasVector {}

/// Capture bias (0x01,0x06).
///
/// Measures the bias.
///
/// Response: [`BiasVector`]. Supported by Model A.
///
/// - Manual guide: Capture bias
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CaptureBias {
    /// How long.
    ///
    /// Unit: s; range: 1 to 30.
    pub time: u16,
}

impl CaptureBias {
    /// The command with its parameters.
    #[must_use]
    pub fn new(time: u16) -> Self {
        Self { time }
    }
}

impl Wire for CaptureBias {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time = reader.read()?;
        Ok(Self { time })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time)?;
        Ok(())
    }
}

impl Field for CaptureBias {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x06;
    const NAME: &'static str = "tools.capture_bias";
}

impl Command for CaptureBias {
    type Response = BiasVector;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<CaptureBias> for BiasVector {}

/// Formats (0x01,0x07).
///
/// Counted arrays of structures and of numbers; not answered if told so.
///
/// Not acknowledged if `suppress_ack` is true. Supported by Model A.
///
/// - Manual guide: Formats
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Formats {
    /// Send no acknowledge.
    pub suppress_ack: crate::Bool,
    /// Between a counter and its array.
    pub checkpoint: u8,
    /// The segments.
    pub segments: crate::List<types::Segment, 25>,
}

impl Formats {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        suppress_ack: bool,
        checkpoint: u8,
        segments: impl Into<crate::List<types::Segment, 25>>,
    ) -> Self {
        Self { suppress_ack: suppress_ack.into(), checkpoint, segments: segments.into() }
    }
}

impl Wire for Formats {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let suppress_ack = reader.read()?;
        let num_segments = reader.read::<u8>()?;
        let checkpoint = reader.read()?;
        let segments = reader.list(num_segments)?;
        Ok(Self { suppress_ack, checkpoint, segments })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.suppress_ack)?;
        writer.count::<u8>(self.segments.len())?;
        writer.write(&self.checkpoint)?;
        self.segments.encode_items(writer)?;
        Ok(())
    }
}

impl Field for Formats {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x07;
    const NAME: &'static str = "tools.formats";
}

impl Command for Formats {
    type Response = ();

    fn expects_reply(&self) -> bool {
        !(self.suppress_ack == crate::Bool(1))
    }
}

/// Choice (0x01,0x08).
///
/// A tagged union with an empty variant, nested unions, arrays and strings in it.
///
/// Functions: write, read. Response: [`ChoiceResponse`]. Supported by Model A.
///
/// - Manual guide: Choice
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Choice {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Which one.
    pub instance: Option<u8>,
    /// Which member follows.
    pub shape: Option<Shape>,
    /// The member.
    ///
    /// Selected by `shape`.
    pub parameters: Option<ChoiceParameters>,
}

impl Choice {
    /// Apply the new setting.
    #[must_use]
    pub fn write(instance: u8, parameters: ChoiceParameters) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            instance: Some(instance),
            shape: Some(parameters.tag()),
            parameters: Some(parameters),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            instance: Some(instance),
            shape: None,
            parameters: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            F::READ => 1,
            _ => 0,
        }
    }
}

impl Wire for Choice {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let instance = reader.group(required >= 1, Reader::read)?;
        let shape = reader.group(required >= 2, Reader::read)?;
        let parameters = reader.some_union(required >= 3, shape)?;
        Ok(Self { function, instance, shape, parameters })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.instance)?;
        writer.some(required >= 2, &self.shape)?;
        writer.some_union(required >= 3, self.shape, &self.parameters)?;
        Ok(())
    }
}

/// The alternatives of `parameters` in [`Choice`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ChoiceParameters {
    /// None.
    #[default]
    None,
    /// Circle.
    Circle(Circle),
    /// Path.
    Path(Path),
    /// A rotation.
    Turn(types::Quatf),
    /// A name.
    Label(crate::Text<8>),
    /// Nothing, for a tag that the specification does not know.
    Other(Shape),
}

impl ChoiceParameters {
    /// The tag that goes with it.
    #[must_use]
    pub const fn tag(&self) -> Shape {
        match self {
            Self::None => Shape::NONE,
            Self::Circle(_) => Shape::CIRCLE,
            Self::Path(_) => Shape::PATH,
            Self::Turn(_) => Shape::TURN,
            Self::Label(_) => Shape::LABEL,
            Self::Other(tag) => *tag,
        }
    }
}

impl Union for ChoiceParameters {
    type Tag = Shape;

    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(match tag {
            Shape::NONE => Self::None,
            Shape::CIRCLE => Self::Circle(reader.read()?),
            Shape::PATH => Self::Path(reader.read()?),
            Shape::TURN => Self::Turn(reader.read()?),
            Shape::LABEL => Self::Label(reader.read()?),
            other => Self::Other(other),
        })
    }

    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        if self.tag() != tag {
            return Err(EncodeError::Tag);
        }
        match self {
            Self::None => Ok(()),
            Self::Circle(value) => writer.write(value),
            Self::Path(value) => writer.write(value),
            Self::Turn(value) => writer.write(value),
            Self::Label(value) => writer.write(value),
            Self::Other(tag) if tag.name().is_some() => Err(EncodeError::Tag),
            Self::Other(_) => Ok(()),
        }
    }
}

impl Field for Choice {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x08;
    const NAME: &'static str = "tools.choice";
}

impl Command for Choice {
    type Response = ChoiceResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<Choice> for ChoiceResponse {}

/// List (0x01,0x09).
///
/// Optional counted array; a read may carry a zero count.
///
/// Functions: write, read, save. Response: [`ListResponse`]. Supported by Model A.
///
/// - Manual guide: List
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct List {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// The items.
    pub items: Option<crate::List<u16, 125>>,
}

impl List {
    /// Apply the new setting.
    #[must_use]
    pub fn write(items: impl Into<crate::List<u16, 125>>) -> Self {
        Self { function: types::FunctionSelector::WRITE, items: Some(items.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, items: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, items: None }
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

impl Wire for List {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let items = reader.group(required >= 2, |reader| {
            let count = reader.read::<u8>()?;
            let items = reader.list(count)?;
            Ok(items)
        })?;
        Ok(Self { function, items })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        if let Some(items) = writer.optional(required >= 2, &self.items)? {
            writer.count::<u8>(items.len())?;
            items.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for List {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x09;
    const NAME: &'static str = "tools.list";
}

impl Command for List {
    type Response = ListResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<List> for ListResponse {}

/// Inventory (0x01,0x0A).
///
/// Answers with an array to the end of the field.
///
/// Response: [`InventoryResponse`]. Supported by Model A.
///
/// - Manual guide: Inventory
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Inventory;

impl Inventory {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for Inventory {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for Inventory {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x0A;
    const NAME: &'static str = "tools.inventory";
}

impl Command for Inventory {
    type Response = InventoryResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<Inventory> for InventoryResponse {}

/// Pin (0x01,0x0B).
///
/// The names of one number depend on another.
///
/// Functions: write, read. Response: [`PinResponse`]. Supported by Model A.
///
/// - Manual guide: Pin
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Pin {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// What drives it.
    pub drive: Option<Drive>,
    /// How it is used.
    pub use_: Option<u8>,
}

impl Pin {
    /// Apply the new setting.
    #[must_use]
    pub fn write(drive: Drive, use_: u8) -> Self {
        Self { function: types::FunctionSelector::WRITE, drive: Some(drive), use_: Some(use_) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(drive: Drive) -> Self {
        Self { function: types::FunctionSelector::READ, drive: Some(drive), use_: None }
    }

    /// The meaning of `use` when `drive` is pulse.
    #[must_use]
    pub fn use_as_pulse_use(&self) -> Option<PulseUse> {
        let named = matches!(self.drive, Some(Drive::PULSE));
        self.use_.filter(|_| named).map(PulseUse)
    }

    /// The meaning of `use` when `drive` is serial.
    #[must_use]
    pub fn use_as_serial_use(&self) -> Option<SerialUse> {
        let named = matches!(self.drive, Some(Drive::SERIAL));
        self.use_.filter(|_| named).map(SerialUse)
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ => 1,
            _ => 0,
        }
    }
}

impl Wire for Pin {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let drive = reader.group(required >= 1, Reader::read)?;
        let use_ = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, drive, use_ })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.drive)?;
        writer.some(required >= 2, &self.use_)?;
        Ok(())
    }
}

impl Field for Pin {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x0B;
    const NAME: &'static str = "tools.pin";
}

impl Command for Pin {
    type Response = PinResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<Pin> for PinResponse {}

/// Hello (0x01,0x0C).
///
/// The device asks and a host answers.
///
/// Response: [`HelloResponse`].
///
/// - Manual sheet: Hello
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hello {
    /// Reserved.
    ///
    /// Send 1.0.
    pub reserved: f32,
    /// Reserved.
    ///
    /// Send 0.0.
    pub later: Option<[f64; 2]>,
}

impl core::default::Default for Hello {
    fn default() -> Self {
        Self { reserved: 1.0, later: None }
    }
}

impl Hello {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self { reserved: 1.0, later: None }
    }

    /// With `later`, which is optional.
    #[must_use]
    pub fn with_later(mut self, later: [f64; 2]) -> Self {
        self.later = Some(later);
        self
    }
}

impl Wire for Hello {
    const SIZE: usize = 20;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let reserved = reader.read()?;
        let later = reader.group(false, Reader::read)?;
        Ok(Self { reserved, later })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.reserved)?;
        writer.some(false, &self.later)?;
        Ok(())
    }
}

impl Field for Hello {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x0C;
    const NAME: &'static str = "tools.hello";
}

impl Command for Hello {
    type Response = HelloResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<Hello> for HelloResponse {}

/// Settings response (0x01,0x82).
///
/// Answers Settings (0x01,0x02).
///
/// Command: [`Settings`]. Supported by Model A and Model B.
///
/// - Manual guide: Settings
/// - Manual leaflet: Settings
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SettingsResponse {
    /// Number of the port, 0 for all.
    ///
    /// Range: 0 to 8.
    pub port: u8,
    /// What to do.
    ///
    /// Default: fast.
    pub mode: types::Mode,
    /// Speed.
    ///
    /// Unit: Bd; default: 115200.
    pub baud: u32,
    /// Required by no function, not even by write.
    ///
    /// - If mode is fast: unit s, range 1 to 10, factory default 5.
    /// - If mode is slow: unit m.
    pub limit: u16,
    /// Reserved.
    ///
    /// Send 1.
    pub reserved: u8,
}

impl core::default::Default for SettingsResponse {
    fn default() -> Self {
        Self {
            port: core::default::Default::default(),
            mode: core::default::Default::default(),
            baud: core::default::Default::default(),
            limit: core::default::Default::default(),
            reserved: 1,
        }
    }
}

impl Wire for SettingsResponse {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let port = reader.read()?;
        let mode = reader.read()?;
        let baud = reader.read()?;
        let limit = reader.read()?;
        let reserved = reader.read()?;
        Ok(Self { port, mode, baud, limit, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.port)?;
        writer.write(&self.mode)?;
        writer.write(&self.baud)?;
        writer.write(&self.limit)?;
        writer.write(&self.reserved)?;
        Ok(())
    }
}

impl Field for SettingsResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "tools.settings_response";
}

/// Set time response (0x01,0x83).
///
/// Answers Set time (0x01,0x03).
///
/// Command: [`SetTime`]. Supported by Model A.
///
/// - Manual guide: Set time
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetTimeFastResponse {
    /// The fast half.
    ///
    /// Unit: s.
    pub value: u32,
}

impl Wire for SetTimeFastResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let value = reader.read()?;
        Ok(Self { value })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.value)?;
        Ok(())
    }
}

impl Field for SetTimeFastResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x83;
    const NAME: &'static str = "tools.set_time_fast_response";
}

/// Set time response (0x01,0x84).
///
/// Answers Set time (0x01,0x03).
///
/// Command: [`SetTime`]. Supported by Model A.
///
/// - Manual guide: Set time
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetTimeSlowResponse {
    /// The slow half.
    ///
    /// Unit: s.
    pub value: u32,
}

impl Wire for SetTimeSlowResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let value = reader.read()?;
        Ok(Self { value })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.value)?;
        Ok(())
    }
}

impl Field for SetTimeSlowResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x84;
    const NAME: &'static str = "tools.set_time_slow_response";
}

/// Choice response (0x01,0x88).
///
/// Answers Choice (0x01,0x08).
///
/// Command: [`Choice`]. Supported by Model A.
///
/// - Manual guide: Choice
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ChoiceResponse {
    /// Which one.
    pub instance: u8,
    /// Which member follows.
    pub shape: Shape,
    /// The member.
    ///
    /// Selected by `shape`.
    pub parameters: ChoiceParameters,
}

impl Wire for ChoiceResponse {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let instance = reader.read()?;
        let shape = reader.read()?;
        let parameters = reader.union(shape)?;
        Ok(Self { instance, shape, parameters })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.instance)?;
        writer.write(&self.shape)?;
        writer.union(self.shape, &self.parameters)?;
        Ok(())
    }
}

impl Field for ChoiceResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x88;
    const NAME: &'static str = "tools.choice_response";
}

/// List response (0x01,0x89).
///
/// Answers List (0x01,0x09).
///
/// Command: [`List`]. Supported by Model A.
///
/// - Manual guide: List
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ListResponse {
    /// The items.
    pub items: crate::List<u16, 126>,
}

impl Wire for ListResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let count = reader.read::<u8>()?;
        let items = reader.list(count)?;
        Ok(Self { items })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.items.len())?;
        self.items.encode_items(writer)?;
        Ok(())
    }
}

impl Field for ListResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x89;
    const NAME: &'static str = "tools.list_response";
}

/// Inventory response (0x01,0x8A).
///
/// Answers Inventory (0x01,0x0A).
///
/// Command: [`Inventory`]. Supported by Model A.
///
/// - Manual guide: Inventory
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InventoryResponse {
    /// As many as there are.
    pub descriptors: crate::List<u16, 126>,
}

impl Wire for InventoryResponse {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let descriptors = reader.rest()?;
        Ok(Self { descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for InventoryResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x8A;
    const NAME: &'static str = "tools.inventory_response";
}

/// Pin response (0x01,0x8B).
///
/// Answers Pin (0x01,0x0B).
///
/// Command: [`Pin`]. Supported by Model A.
///
/// - Manual guide: Pin
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PinResponse {
    /// What drives it.
    pub drive: Drive,
    /// How it is used.
    pub use_: u8,
}

impl PinResponse {
    /// The meaning of `use` when `drive` is pulse.
    #[must_use]
    pub fn use_as_pulse_use(&self) -> Option<PulseUse> {
        let named = matches!(self.drive, Drive::PULSE);
        Some(self.use_).filter(|_| named).map(PulseUse)
    }

    /// The meaning of `use` when `drive` is serial.
    #[must_use]
    pub fn use_as_serial_use(&self) -> Option<SerialUse> {
        let named = matches!(self.drive, Drive::SERIAL);
        Some(self.use_).filter(|_| named).map(SerialUse)
    }
}

impl Wire for PinResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let drive = reader.read()?;
        let use_ = reader.read()?;
        Ok(Self { drive, use_ })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.drive)?;
        writer.write(&self.use_)?;
        Ok(())
    }
}

impl Field for PinResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x8B;
    const NAME: &'static str = "tools.pin_response";
}

/// Hello response (0x01,0x8C).
///
/// Answers Hello (0x01,0x0C).
///
/// Command: [`Hello`].
///
/// - Manual sheet: Hello
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HelloResponse {
    /// When the device was seen.
    ///
    /// Unit: s.
    pub seen: u32,
}

impl Wire for HelloResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let seen = reader.read()?;
        Ok(Self { seen })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.seen)?;
        Ok(())
    }
}

impl Field for HelloResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x8C;
    const NAME: &'static str = "tools.hello_response";
}

/// Status response (0x01,0x90).
///
/// Answers Status (0x01,0x04).
///
/// Command: [`Status`]. Supported by Model A and Model B.
///
/// - Manual guide: Status
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StatusShort {
    /// Faults.
    pub flags: u32,
}

impl StatusShort {
    /// The meaning of `flags` on the Model A.
    #[must_use]
    pub fn flags_as_model_a_faults(&self) -> ModelAFaults {
        ModelAFaults(self.flags)
    }

    /// The meaning of `flags` on the Model B.
    #[must_use]
    pub fn flags_as_model_b_faults(&self) -> ModelBFaults {
        ModelBFaults(self.flags)
    }
}

impl Wire for StatusShort {
    const SIZE: usize = 7;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.constant::<u16>(4711)?;
        reader.constant::<u8>(1)?;
        let flags = reader.read()?;
        Ok(Self { flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write::<u16>(&4711)?;
        writer.write::<u8>(&1)?;
        writer.write(&self.flags)?;
        Ok(())
    }
}

impl Field for StatusShort {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "tools.status_short";
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[18, 103]), (2, &[1])];
}

/// Status response (0x01,0x90).
///
/// Answers Status (0x01,0x04).
///
/// Command: [`Status`]. Supported by Model A and Model B.
///
/// - Manual guide: Status
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StatusLong {
    /// Faults.
    pub flags: u32,
    /// Since start.
    ///
    /// Unit: s.
    pub uptime: u64,
}

impl StatusLong {
    /// The meaning of `flags` on the Model A.
    #[must_use]
    pub fn flags_as_model_a_faults(&self) -> ModelAFaults {
        ModelAFaults(self.flags)
    }

    /// The meaning of `flags` on the Model B.
    #[must_use]
    pub fn flags_as_model_b_faults(&self) -> ModelBFaults {
        ModelBFaults(self.flags)
    }
}

impl Wire for StatusLong {
    const SIZE: usize = 15;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.constant::<u16>(4711)?;
        reader.constant::<u8>(2)?;
        let flags = reader.read()?;
        let uptime = reader.read()?;
        Ok(Self { flags, uptime })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write::<u16>(&4711)?;
        writer.write::<u8>(&2)?;
        writer.write(&self.flags)?;
        writer.write(&self.uptime)?;
        Ok(())
    }
}

impl Field for StatusLong {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "tools.status_long";
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[18, 103]), (2, &[2])];
}

/// Bias response (0x01,0x9B).
///
/// Answers Bias (0x01,0x05).
///
/// Command: [`Bias`]. Command: [`CaptureBias`]. Supported by Model A.
///
/// - Manual guide: Bias
/// - Manual leaflet: Bias
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BiasVector {
    /// Taken off the measurement.
    ///
    /// Unit: g; frame: sensor.
    pub bias: types::Vector3f,
}

impl Wire for BiasVector {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let bias = reader.read()?;
        Ok(Self { bias })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.bias)?;
        Ok(())
    }
}

impl Field for BiasVector {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x9B;
    const NAME: &'static str = "tools.bias_vector";
}
