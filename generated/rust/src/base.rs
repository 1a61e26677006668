//! Base (0x01): Commands common to all devices: identity, supported descriptors, idle and resume,
//! self test, reset.
//!
//! - Manual 3dm-gx5-15: 4.1 Base Commands
//! - Manual 3dm-cv7-gnss-ins: Base (0x01)

use crate::macros::open_enum;
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x01;

/// Identity of a device. The strings are padded with spaces.
///
/// - Manual 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
/// - Manual 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BaseDeviceInfo {
    /// Firmware version as one decimal number: 1202 stands for 1.2.02.
    pub firmware_version: u16,
    /// Name of the model.
    pub model_name: crate::Text<16>,
    /// Part number of the model.
    pub model_number: crate::Text<16>,
    /// Serial number.
    pub serial_number: crate::Text<16>,
    /// Lot number; reserved and blank on some devices.
    pub lot_number: crate::Text<16>,
    /// Options of the unit, such as its sensor ranges.
    pub device_options: crate::Text<16>,
}

impl BaseDeviceInfo {
    /// Puts the values together.
    #[must_use]
    pub fn new(
        firmware_version: u16,
        model_name: crate::Text<16>,
        model_number: crate::Text<16>,
        serial_number: crate::Text<16>,
        lot_number: crate::Text<16>,
        device_options: crate::Text<16>,
    ) -> Self {
        Self {
            firmware_version,
            model_name,
            model_number,
            serial_number,
            lot_number,
            device_options,
        }
    }
}

impl Wire for BaseDeviceInfo {
    const SIZE: usize = 82;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let firmware_version = reader.read()?;
        let model_name = reader.read()?;
        let model_number = reader.read()?;
        let serial_number = reader.read()?;
        let lot_number = reader.read()?;
        let device_options = reader.read()?;
        Ok(Self {
            firmware_version,
            model_name,
            model_number,
            serial_number,
            lot_number,
            device_options,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.firmware_version)?;
        writer.write(&self.model_name)?;
        writer.write(&self.model_number)?;
        writer.write(&self.serial_number)?;
        writer.write(&self.lot_number)?;
        writer.write(&self.device_options)?;
        Ok(())
    }
}

open_enum! {
    /// The part of the GPS time that a value holds.
    GpsTimeField: u8 {
        /// Week number.
        WEEK_NUMBER = 1, "week_number";
        /// Time of week in whole seconds.
        TIME_OF_WEEK = 2, "time_of_week";
    }
}

/// Ping (0x01,0x01).
///
/// Asks whether a device is there and answers commands.
///
/// - A device that is not in a normal operating mode may refuse the command.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)
/// - Manual 3dm-cv7-gnss-ins: Ping (0x01,0x01)
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
    const NAME: &'static str = "base.ping";
}

impl Command for Ping {
    type Response = ();
}

/// Set to idle (0x01,0x02).
///
/// Stops all data streams, and wakes a sleeping device, so that it can be set up.
///
/// - The resume command restores the previous mode.
/// - While idle the device sends no NMEA sentences either.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.2 Set To Idle (0x01, 0x02)
/// - Manual 3dm-cv7-gnss-ins: Set to idle (0x01,0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SetToIdle;

impl SetToIdle {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for SetToIdle {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for SetToIdle {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "base.set_to_idle";
}

impl Command for SetToIdle {
    type Response = ();
}

/// Get device information (0x01,0x03).
///
/// Gets the firmware version and the identity strings of the device.
///
/// Response: [`GetDeviceInformationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
/// - Manual 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDeviceInformation;

impl GetDeviceInformation {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetDeviceInformation {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetDeviceInformation {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "base.get_device_information";
}

impl Command for GetDeviceInformation {
    type Response = GetDeviceInformationResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        Some(crate::field::check::<GetDeviceInformationResponse>)
    }
}

impl ResponseOf<GetDeviceInformation> for GetDeviceInformationResponse {}

/// Get device descriptors (0x01,0x04).
///
/// Gets the command and data descriptors that the device supports.
///
/// - When the list contains (0x01,0x07), more descriptors come from the extended command.
///
/// Response: [`GetDeviceDescriptorsResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
/// - Manual 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDeviceDescriptors;

impl GetDeviceDescriptors {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetDeviceDescriptors {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetDeviceDescriptors {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "base.get_device_descriptors";
}

impl Command for GetDeviceDescriptors {
    type Response = GetDeviceDescriptorsResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        Some(crate::field::check::<GetDeviceDescriptorsResponse>)
    }
}

impl ResponseOf<GetDeviceDescriptors> for GetDeviceDescriptorsResponse {}

/// Built-in test (0x01,0x05).
///
/// Runs the self test of the device and gets its result.
///
/// - The test interrupts normal operation for up to several seconds; no data is available
///   meanwhile.
/// - The device must be at rest; acceleration, rotation or vibration cause false failures.
/// - The continuous built-in test, where there is one, tells more about a failure.
///
/// Response: [`BuiltInTestResponse`]. The device may take 10.0 s. Supported by 3DM-CV7-GNSS/INS and
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
/// - Manual 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BuiltInTest;

impl BuiltInTest {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for BuiltInTest {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for BuiltInTest {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x05;
    const NAME: &'static str = "base.built_in_test";
}

impl Command for BuiltInTest {
    type Response = BuiltInTestResponse;
    const TIMEOUT_MS: Option<u32> = Some(10000);

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        Some(crate::field::check::<BuiltInTestResponse>)
    }
}

impl ResponseOf<BuiltInTest> for BuiltInTestResponse {}

/// Resume (0x01,0x06).
///
/// Ends idle mode and returns the device to the mode that it was in before.
///
/// - If the device was not idle, it enters its default mode (3DM-GX5-15).
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.6 Resume (0x01, 0x06)
/// - Manual 3dm-cv7-gnss-ins: Resume (0x01,0x06)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Resume;

impl Resume {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for Resume {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for Resume {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x06;
    const NAME: &'static str = "base.resume";
}

impl Command for Resume {
    type Response = ();
}

/// Get device descriptors (extended) (0x01,0x07).
///
/// Gets the supported descriptors that did not fit into the reply of get device descriptors.
///
/// - Only supported if get device descriptors lists (0x01,0x07).
///
/// Response: [`GetDeviceDescriptorsExtendedResponse`]. Supported by 3DM-CV7-GNSS/INS and
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
/// - Manual 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDeviceDescriptorsExtended;

impl GetDeviceDescriptorsExtended {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetDeviceDescriptorsExtended {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetDeviceDescriptorsExtended {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x07;
    const NAME: &'static str = "base.get_device_descriptors_extended";
}

impl Command for GetDeviceDescriptorsExtended {
    type Response = GetDeviceDescriptorsExtendedResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        Some(crate::field::check::<GetDeviceDescriptorsExtendedResponse>)
    }
}

impl ResponseOf<GetDeviceDescriptorsExtended> for GetDeviceDescriptorsExtendedResponse {}

/// Continuous built-in test (0x01,0x08).
///
/// Gets the flags of the tests that run all the time. It does not interrupt operation.
///
/// - It is less thorough than the built-in test command.
/// - Each flag stays set until it is reported by this command, apart from the copy of the streamed
///   field.
/// - The self-test flags change only when the built-in test command runs.
///
/// Response: [`ContinuousBuiltInTestResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ContinuousBuiltInTest;

impl ContinuousBuiltInTest {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for ContinuousBuiltInTest {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for ContinuousBuiltInTest {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x08;
    const NAME: &'static str = "base.continuous_built_in_test";
}

impl Command for ContinuousBuiltInTest {
    type Response = ContinuousBuiltInTestResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        Some(crate::field::check::<ContinuousBuiltInTestResponse>)
    }
}

impl ResponseOf<ContinuousBuiltInTest> for ContinuousBuiltInTestResponse {}

/// Comm port speed (0x01,0x09).
///
/// Baud rate of one communication port.
///
/// - The change waits until pending data is sent and received, at most 250 ms.
/// - Send it alone in a packet while the device is idle, and wait 250 ms before going on.
/// - Commands and data during the change may be lost or come at either rate.
///
/// Functions: write, read, save, load, default. Response: [`CommPortSpeedResponse`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CommPortSpeed {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Port id of the device; 0 means all ports, and is for save, load and default only.
    pub port: Option<u8>,
    /// Baud rate; one that the port supports.
    ///
    /// Unit: Bd.
    pub baud: Option<u32>,
}

impl CommPortSpeed {
    /// Apply the new setting.
    #[must_use]
    pub fn write(port: u8, baud: u32) -> Self {
        Self { function: types::FunctionSelector::WRITE, port: Some(port), baud: Some(baud) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(port: u8) -> Self {
        Self { function: types::FunctionSelector::READ, port: Some(port), baud: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(port: u8) -> Self {
        Self { function: types::FunctionSelector::SAVE, port: Some(port), baud: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(port: u8) -> Self {
        Self { function: types::FunctionSelector::LOAD, port: Some(port), baud: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(port: u8) -> Self {
        Self { function: types::FunctionSelector::DEFAULT, port: Some(port), baud: None }
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

impl Wire for CommPortSpeed {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let port = reader.group(required >= 1, Reader::read)?;
        let baud = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, port, baud })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.port)?;
        writer.some(required >= 2, &self.baud)?;
        Ok(())
    }
}

impl Field for CommPortSpeed {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x09;
    const NAME: &'static str = "base.comm_port_speed";
}

impl Command for CommPortSpeed {
    type Response = CommPortSpeedResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        if !matches!(self.function, types::FunctionSelector::READ) {
            return None;
        }
        Some(crate::field::check::<CommPortSpeedResponse>)
    }
}

impl ResponseOf<CommPortSpeed> for CommPortSpeedResponse {}

/// GPS time update (0x01,0x72).
///
/// Sets the week number or the time of week of the external (GPS) time.
///
/// - Send it once for the time of week and once for the week number after the PPS is locked.
/// - The PPS supplies the fraction of the second; send the whole second that began at its last
///   edge.
/// - Send it within 250 ms after the rising edge of the PPS.
/// - The 3DM-GX5-15 wants it once per second; the 3DM-CV7-GNSS/INS at least once.
/// - Send it again after a glitch of the PPS. An internal GNSS receiver as PPS source mostly makes
///   it needless.
///
/// Functions: write, read, apply. Response: one of [`GpsTimeUpdateResponses`]. Supported by
/// 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
/// - Manual 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpsTimeUpdate {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// What the value is.
    pub field_id: Option<GpsTimeField>,
    /// What field_id says.
    ///
    /// - If field_id is week_number: unit week; GPS week number since 6 January 1980.
    /// - If field_id is time_of_week: unit s; Whole seconds of the GPS week.
    pub value: Option<u32>,
}

impl GpsTimeUpdate {
    /// Apply the new setting.
    #[must_use]
    pub fn write(field_id: GpsTimeField, value: u32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            field_id: Some(field_id),
            value: Some(value),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(field_id: GpsTimeField) -> Self {
        Self { function: types::FunctionSelector::READ, field_id: Some(field_id), value: None }
    }

    /// Apply the new setting and send no acknowledge (5-series devices).
    #[must_use]
    pub fn apply(field_id: GpsTimeField, value: u32) -> Self {
        Self {
            function: types::FunctionSelector::APPLY,
            field_id: Some(field_id),
            value: Some(value),
        }
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

impl Wire for GpsTimeUpdate {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let field_id = reader.group(required >= 1, Reader::read)?;
        let value = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, field_id, value })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.field_id)?;
        writer.some(required >= 2, &self.value)?;
        Ok(())
    }
}

impl Field for GpsTimeUpdate {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x72;
    const NAME: &'static str = "base.gps_time_update";
}

impl Command for GpsTimeUpdate {
    type Response = GpsTimeUpdateResponses;

    fn expects_reply(&self) -> bool {
        !matches!(self.function, types::FunctionSelector::APPLY)
    }

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        if !matches!(self.function, types::FunctionSelector::READ) {
            return None;
        }
        if self.field_id == Some(GpsTimeField::WEEK_NUMBER) {
            return Some(crate::field::check::<GpsTimeUpdateWeekNumberResponse>);
        }
        if self.field_id == Some(GpsTimeField::TIME_OF_WEEK) {
            return Some(crate::field::check::<GpsTimeUpdateTimeOfWeekResponse>);
        }
        None
    }
}

impl ResponseOf<GpsTimeUpdate> for GpsTimeUpdateWeekNumberResponse {}

impl ResponseOf<GpsTimeUpdate> for GpsTimeUpdateTimeOfWeekResponse {}

crate::macros::responses! {
    /// What [`GpsTimeUpdate`] is answered with.
    GpsTimeUpdateResponses {
        /// The response [`GpsTimeUpdateWeekNumberResponse`].
        WeekNumber(GpsTimeUpdateWeekNumberResponse),
        /// The response [`GpsTimeUpdateTimeOfWeekResponse`].
        TimeOfWeek(GpsTimeUpdateTimeOfWeekResponse),
    }
}

/// Reset device (0x01,0x7E).
///
/// Acknowledges the command, then resets the device at once.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.9 Device Reset (0x01, 0x7E)
/// - Manual 3dm-cv7-gnss-ins: Reset device (0x01,0x7E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ResetDevice;

impl ResetDevice {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for ResetDevice {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for ResetDevice {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x7E;
    const NAME: &'static str = "base.reset_device";
}

impl Command for ResetDevice {
    type Response = ();
}

/// Get device information response (0x01,0x81).
///
/// Answers Get device information (0x01,0x03).
///
/// Command: [`GetDeviceInformation`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)
/// - Manual 3dm-cv7-gnss-ins: Get device information (0x01,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDeviceInformationResponse {
    /// Identity of the device.
    pub device_info: BaseDeviceInfo,
}

impl Wire for GetDeviceInformationResponse {
    const SIZE: usize = 82;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let device_info = reader.read()?;
        Ok(Self { device_info })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.device_info)?;
        Ok(())
    }
}

impl Field for GetDeviceInformationResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x81;
    const NAME: &'static str = "base.get_device_information_response";
}

/// Get device descriptors response (0x01,0x82).
///
/// Answers Get device descriptors (0x01,0x04).
///
/// Command: [`GetDeviceDescriptors`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)
/// - Manual 3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDeviceDescriptorsResponse {
    /// Supported descriptors: the descriptor set in the high byte, the field descriptor in the low
    /// byte.
    pub descriptors: crate::List<u16, 126>,
}

impl Wire for GetDeviceDescriptorsResponse {
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

impl Field for GetDeviceDescriptorsResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "base.get_device_descriptors_response";
}

/// Built-in test response (0x01,0x83).
///
/// Answers Built-in test (0x01,0x05).
///
/// Command: [`BuiltInTest`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)
/// - Manual 3dm-cv7-gnss-ins: Built in test (0x01,0x05)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BuiltInTestResponse {
    /// Failure flags, defined by each device. Zero means that every test passed.
    pub result: u32,
}

impl BuiltInTestResponse {
    /// The meaning of `result` on the 3DM-GX5-15.
    #[must_use]
    pub fn result_as_gx5_built_in_test(&self) -> types::Gx5BuiltInTest {
        types::Gx5BuiltInTest(self.result)
    }

    /// The meaning of `result` on the 3DM-CV7-GNSS/INS.
    #[must_use]
    pub fn result_as_cv7_built_in_test(&self) -> types::Cv7BuiltInTest {
        types::Cv7BuiltInTest(self.result)
    }
}

impl Wire for BuiltInTestResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let result = reader.read()?;
        Ok(Self { result })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.result)?;
        Ok(())
    }
}

impl Field for BuiltInTestResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x83;
    const NAME: &'static str = "base.built_in_test_response";
}

/// GPS time update, week number (0x01,0x84).
///
/// The current week number.
///
/// Command: [`GpsTimeUpdate`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
/// - Manual 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpsTimeUpdateWeekNumberResponse {
    /// GPS week number.
    ///
    /// Unit: week.
    pub week_number: u32,
}

impl Wire for GpsTimeUpdateWeekNumberResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let week_number = reader.read()?;
        Ok(Self { week_number })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.week_number)?;
        Ok(())
    }
}

impl Field for GpsTimeUpdateWeekNumberResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x84;
    const NAME: &'static str = "base.gps_time_update_week_number_response";
}

/// GPS time update, time of week (0x01,0x85).
///
/// The current time of week.
///
/// Command: [`GpsTimeUpdate`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)
/// - Manual 3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpsTimeUpdateTimeOfWeekResponse {
    /// GPS time of week in whole seconds.
    ///
    /// Unit: s.
    pub time_of_week: u32,
}

impl Wire for GpsTimeUpdateTimeOfWeekResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time_of_week = reader.read()?;
        Ok(Self { time_of_week })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time_of_week)?;
        Ok(())
    }
}

impl Field for GpsTimeUpdateTimeOfWeekResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x85;
    const NAME: &'static str = "base.gps_time_update_time_of_week_response";
}

/// Get device descriptors (extended) response (0x01,0x86).
///
/// Answers Get device descriptors (extended) (0x01,0x07).
///
/// Command: [`GetDeviceDescriptorsExtended`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)
/// - Manual 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDeviceDescriptorsExtendedResponse {
    /// Supported descriptors: the descriptor set in the high byte, the field descriptor in the low
    /// byte.
    pub descriptors: crate::List<u16, 126>,
}

impl Wire for GetDeviceDescriptorsExtendedResponse {
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

impl Field for GetDeviceDescriptorsExtendedResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x86;
    const NAME: &'static str = "base.get_device_descriptors_extended_response";
}

/// Continuous built-in test response (0x01,0x88).
///
/// Answers Continuous built-in test (0x01,0x08).
///
/// Command: [`ContinuousBuiltInTest`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ContinuousBuiltInTestResponse {
    /// Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second
    /// byte.
    pub result: [u8; 16],
}

impl ContinuousBuiltInTestResponse {
    /// The meaning of `result` on the 3DM-CV7-GNSS/INS.
    #[must_use]
    pub fn result_as_cv7_continuous_built_in_test(&self) -> types::Cv7ContinuousBuiltInTest {
        types::Cv7ContinuousBuiltInTest(self.result)
    }
}

impl Wire for ContinuousBuiltInTestResponse {
    const SIZE: usize = 16;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let result = reader.read()?;
        Ok(Self { result })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.result)?;
        Ok(())
    }
}

impl Field for ContinuousBuiltInTestResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x88;
    const NAME: &'static str = "base.continuous_built_in_test_response";
}

/// Comm port speed response (0x01,0x89).
///
/// Answers Comm port speed (0x01,0x09).
///
/// Command: [`CommPortSpeed`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CommPortSpeedResponse {
    /// Port id of the device; 0 means all ports, and is for save, load and default only.
    pub port: u8,
    /// Baud rate; one that the port supports.
    ///
    /// Unit: Bd.
    pub baud: u32,
}

impl Wire for CommPortSpeedResponse {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let port = reader.read()?;
        let baud = reader.read()?;
        Ok(Self { port, baud })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.port)?;
        writer.write(&self.baud)?;
        Ok(())
    }
}

impl Field for CommPortSpeedResponse {
    const SET: u8 = 0x01;
    const DESCRIPTOR: u8 = 0x89;
    const NAME: &'static str = "base.comm_port_speed_response";
}
