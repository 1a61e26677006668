//! RTK commands (0x0F): Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.
//!
//! - Manual mip-sdk-4: Rtk Commands (0x0F)

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x0F;

open_enum! {
    /// A device that a corrections modem serves.
    ///
    /// - Manual mip-sdk-4: Connected Device Type (0x0F,0x06)
    ConnectedDevice: u8 {
        /// Any device.
        GENERIC = 0, "generic";
        /// 3DM-GQ7.
        GQ7 = 1, "gq7";
    }
}

bitfield! {
    /// State of the correction service.
    ///
    /// - Manual mip-sdk-4: Service Status (0x0F,0x0A)
    ServiceFlags: u8 {
        /// The server limits the rate.
        THROTTLE: bool = 0,
            "throttle", throttle, set_throttle, with_throttle;
        /// There are no corrections.
        CORRECTIONS_UNAVAILABLE: bool = 1,
            "corrections_unavailable", corrections_unavailable, set_corrections_unavailable,
            with_corrections_unavailable;
    }
}

open_enum! {
    /// A storage medium of a corrections modem.
    ///
    /// - Manual mip-sdk-4: Prod Erase Storage (0x0F,0x20)
    StorageMedium: u8 {
        /// External flash memory.
        EXTERNAL_FLASH = 0, "external_flash";
        /// SD card.
        SD = 1, "sd";
    }
}

open_enum! {
    /// Pattern of an LED.
    ///
    /// - Manual mip-sdk-4: Led Control (0x0F,0x21)
    LedAction: u8 {
        /// No pattern.
        NONE = 0, "none";
        /// Flashing.
        FLASH = 1, "flash";
        /// Pulsating.
        PULSATE = 2, "pulsate";
    }
}

/// Get status flags (0x0F,0x01).
///
/// Asks for the state of the modem and of the corrections.
///
/// - The word of the response has two forms, rtk_status_flags and rtk_status_flags_legacy.
///
/// Response: [`GetStatusFlagsResponse`].
///
/// - Manual mip-sdk-4: Get Status Flags (0x0F,0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetStatusFlags;

impl GetStatusFlags {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetStatusFlags {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetStatusFlags {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "rtk.get_status_flags";
}

impl Command for GetStatusFlags {
    type Response = GetStatusFlagsResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetStatusFlags> for GetStatusFlagsResponse {}

/// Get IMEI (0x0F,0x02).
///
/// Asks for the identity of the modem.
///
/// Response: [`GetImeiResponse`].
///
/// - Manual mip-sdk-4: Get Imei (0x0F,0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetImei;

impl GetImei {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetImei {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetImei {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "rtk.get_imei";
}

impl Command for GetImei {
    type Response = GetImeiResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetImei> for GetImeiResponse {}

/// Get IMSI (0x0F,0x03).
///
/// Asks for the identity of the subscriber.
///
/// Response: [`GetImsiResponse`].
///
/// - Manual mip-sdk-4: Get Imsi (0x0F,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetImsi;

impl GetImsi {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetImsi {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetImsi {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "rtk.get_imsi";
}

impl Command for GetImsi {
    type Response = GetImsiResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetImsi> for GetImsiResponse {}

/// Get ICCID (0x0F,0x04).
///
/// Asks for the number of the SIM card.
///
/// Response: [`GetIccidResponse`].
///
/// - Manual mip-sdk-4: Get Iccid (0x0F,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetIccid;

impl GetIccid {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetIccid {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetIccid {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "rtk.get_iccid";
}

impl Command for GetIccid {
    type Response = GetIccidResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetIccid> for GetIccidResponse {}

/// Get RSSI (0x0F,0x05).
///
/// Asks for the strength of the cellular signal.
///
/// Response: [`GetRssiResponse`].
///
/// - Manual mip-sdk-4: Get Rssi (0x0F,0x05)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetRssi;

impl GetRssi {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetRssi {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetRssi {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x05;
    const NAME: &'static str = "rtk.get_rssi";
}

impl Command for GetRssi {
    type Response = GetRssiResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetRssi> for GetRssiResponse {}

/// Connected device type (0x0F,0x06).
///
/// The device that the modem serves.
///
/// Functions: write, read, save, load, default. Response: [`ConnectedDeviceTypeResponse`].
///
/// - Manual mip-sdk-4: Connected Device Type (0x0F,0x06)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConnectedDeviceType {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Type of the device.
    pub device_type: Option<ConnectedDevice>,
}

impl ConnectedDeviceType {
    /// Apply the new setting.
    #[must_use]
    pub fn write(device_type: ConnectedDevice) -> Self {
        Self { function: types::FunctionSelector::WRITE, device_type: Some(device_type) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, device_type: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, device_type: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, device_type: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, device_type: None }
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

impl Wire for ConnectedDeviceType {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let device_type = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, device_type })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.device_type)?;
        Ok(())
    }
}

impl Field for ConnectedDeviceType {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x06;
    const NAME: &'static str = "rtk.connected_device_type";
}

impl Command for ConnectedDeviceType {
    type Response = ConnectedDeviceTypeResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ConnectedDeviceType> for ConnectedDeviceTypeResponse {}

/// Get activation code (0x0F,0x07).
///
/// Asks for the activation code.
///
/// Response: [`GetActivationCodeResponse`].
///
/// - Manual mip-sdk-4: Get Act Code (0x0F,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetActivationCode;

impl GetActivationCode {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetActivationCode {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetActivationCode {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x07;
    const NAME: &'static str = "rtk.get_activation_code";
}

impl Command for GetActivationCode {
    type Response = GetActivationCodeResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetActivationCode> for GetActivationCodeResponse {}

/// Get modem firmware version (0x0F,0x08).
///
/// Asks for the firmware version of the cellular modem.
///
/// Response: [`GetModemFirmwareVersionResponse`].
///
/// - Manual mip-sdk-4: Get Modem Firmware Version (0x0F,0x08)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetModemFirmwareVersion;

impl GetModemFirmwareVersion {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetModemFirmwareVersion {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetModemFirmwareVersion {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x08;
    const NAME: &'static str = "rtk.get_modem_firmware_version";
}

impl Command for GetModemFirmwareVersion {
    type Response = GetModemFirmwareVersionResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetModemFirmwareVersion> for GetModemFirmwareVersionResponse {}

/// Service status (0x0F,0x0A).
///
/// Asks a correction server about the connection, and so keeps it open.
///
/// - The modem sends it as a host would, and the server answers as a device would.
///
/// Response: [`ServiceStatusResponse`].
///
/// - Manual mip-sdk-4: Service Status (0x0F,0x0A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ServiceStatus {
    /// Reserved.
    ///
    /// Send 0.
    pub reserved1: u32,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved2: u32,
}

impl ServiceStatus {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self { reserved1: 0, reserved2: 0 }
    }
}

impl Wire for ServiceStatus {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let reserved1 = reader.read()?;
        let reserved2 = reader.read()?;
        Ok(Self { reserved1, reserved2 })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.reserved1)?;
        writer.write(&self.reserved2)?;
        Ok(())
    }
}

impl Field for ServiceStatus {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x0A;
    const NAME: &'static str = "rtk.service_status";
}

impl Command for ServiceStatus {
    type Response = ServiceStatusResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<ServiceStatus> for ServiceStatusResponse {}

/// Erase storage (0x0F,0x20).
///
/// Erases a storage medium down to its raw state.
///
/// - All that is stored is lost. The command is for production.
/// - Accepted in calibration mode only.
///
/// For advanced use.
///
/// - Manual mip-sdk-4: Prod Erase Storage (0x0F,0x20)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EraseStorage {
    /// The medium.
    pub media: StorageMedium,
}

impl EraseStorage {
    /// The command with its parameters.
    #[must_use]
    pub fn new(media: StorageMedium) -> Self {
        Self { media }
    }
}

impl Wire for EraseStorage {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let media = reader.read()?;
        Ok(Self { media })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.media)?;
        Ok(())
    }
}

impl Field for EraseStorage {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x20;
    const NAME: &'static str = "rtk.erase_storage";
}

impl Command for EraseStorage {
    type Response = ();
}

/// LED control (0x0F,0x21).
///
/// Colours and pattern of the LED.
///
/// - Accepted in calibration mode and production test mode only.
///
/// For advanced use.
///
/// - Manual mip-sdk-4: Led Control (0x0F,0x21)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LedControl {
    /// First colour.
    pub primary_color: [u8; 3],
    /// Second colour.
    pub alternate_color: [u8; 3],
    /// Pattern.
    pub action: LedAction,
    /// Period of the pattern.
    pub period: u32,
}

impl LedControl {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        primary_color: [u8; 3],
        alternate_color: [u8; 3],
        action: LedAction,
        period: u32,
    ) -> Self {
        Self { primary_color, alternate_color, action, period }
    }
}

impl Wire for LedControl {
    const SIZE: usize = 11;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let primary_color = reader.read()?;
        let alternate_color = reader.read()?;
        let action = reader.read()?;
        let period = reader.read()?;
        Ok(Self { primary_color, alternate_color, action, period })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.primary_color)?;
        writer.write(&self.alternate_color)?;
        writer.write(&self.action)?;
        writer.write(&self.period)?;
        Ok(())
    }
}

impl Field for LedControl {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x21;
    const NAME: &'static str = "rtk.led_control";
}

impl Command for LedControl {
    type Response = ();
}

/// Modem hard reset (0x0F,0x22).
///
/// Clears the flash memory of the modem.
///
/// - It wears the flash memory out; use it rarely.
/// - Accepted in calibration mode only.
///
/// For advanced use.
///
/// - Manual mip-sdk-4: Modem Hard Reset (0x0F,0x22)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ModemHardReset;

impl ModemHardReset {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for ModemHardReset {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for ModemHardReset {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x22;
    const NAME: &'static str = "rtk.modem_hard_reset";
}

impl Command for ModemHardReset {
    type Response = ();
}

/// Get status flags response (0x0F,0x81).
///
/// Answers Get status flags (0x0F,0x01).
///
/// Command: [`GetStatusFlags`].
///
/// - Manual mip-sdk-4: Get Status Flags (0x0F,0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetStatusFlagsResponse {
    /// State of the modem and of the corrections.
    pub flags: types::RtkStatusFlags,
}

impl Wire for GetStatusFlagsResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let flags = reader.read()?;
        Ok(Self { flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.flags)?;
        Ok(())
    }
}

impl Field for GetStatusFlagsResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x81;
    const NAME: &'static str = "rtk.get_status_flags_response";
}

/// Get IMEI response (0x0F,0x82).
///
/// Answers Get IMEI (0x0F,0x02).
///
/// Command: [`GetImei`].
///
/// - Manual mip-sdk-4: Get Imei (0x0F,0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetImeiResponse {
    /// International mobile equipment identity.
    pub imei: crate::Text<32>,
}

impl Wire for GetImeiResponse {
    const SIZE: usize = 32;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let imei = reader.read()?;
        Ok(Self { imei })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.imei)?;
        Ok(())
    }
}

impl Field for GetImeiResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "rtk.get_imei_response";
}

/// Get IMSI response (0x0F,0x83).
///
/// Answers Get IMSI (0x0F,0x03).
///
/// Command: [`GetImsi`].
///
/// - Manual mip-sdk-4: Get Imsi (0x0F,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetImsiResponse {
    /// International mobile subscriber identity.
    pub imsi: crate::Text<32>,
}

impl Wire for GetImsiResponse {
    const SIZE: usize = 32;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let imsi = reader.read()?;
        Ok(Self { imsi })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.imsi)?;
        Ok(())
    }
}

impl Field for GetImsiResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x83;
    const NAME: &'static str = "rtk.get_imsi_response";
}

/// Get ICCID response (0x0F,0x84).
///
/// Answers Get ICCID (0x0F,0x04).
///
/// Command: [`GetIccid`].
///
/// - Manual mip-sdk-4: Get Iccid (0x0F,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetIccidResponse {
    /// Number of the SIM card.
    pub iccid: crate::Text<32>,
}

impl Wire for GetIccidResponse {
    const SIZE: usize = 32;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let iccid = reader.read()?;
        Ok(Self { iccid })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.iccid)?;
        Ok(())
    }
}

impl Field for GetIccidResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x84;
    const NAME: &'static str = "rtk.get_iccid_response";
}

/// Get RSSI response (0x0F,0x85).
///
/// Answers Get RSSI (0x0F,0x05).
///
/// Command: [`GetRssi`].
///
/// - Manual mip-sdk-4: Get Rssi (0x0F,0x05)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetRssiResponse {
    /// Whether the modem is connected.
    pub valid: crate::Bool,
    /// Received signal strength.
    ///
    /// Valid if `valid` is set.
    pub rssi: i32,
    /// Signal quality.
    ///
    /// Valid if `valid` is set.
    pub signal_quality: i32,
}

impl Wire for GetRssiResponse {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let valid = reader.read()?;
        let rssi = reader.read()?;
        let signal_quality = reader.read()?;
        Ok(Self { valid, rssi, signal_quality })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.valid)?;
        writer.write(&self.rssi)?;
        writer.write(&self.signal_quality)?;
        Ok(())
    }
}

impl Field for GetRssiResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x85;
    const NAME: &'static str = "rtk.get_rssi_response";
}

/// Connected device type response (0x0F,0x86).
///
/// Answers Connected device type (0x0F,0x06).
///
/// Command: [`ConnectedDeviceType`].
///
/// - Manual mip-sdk-4: Connected Device Type (0x0F,0x06)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConnectedDeviceTypeResponse {
    /// Type of the device.
    pub device_type: ConnectedDevice,
}

impl Wire for ConnectedDeviceTypeResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let device_type = reader.read()?;
        Ok(Self { device_type })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.device_type)?;
        Ok(())
    }
}

impl Field for ConnectedDeviceTypeResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x86;
    const NAME: &'static str = "rtk.connected_device_type_response";
}

/// Get activation code response (0x0F,0x87).
///
/// Answers Get activation code (0x0F,0x07).
///
/// Command: [`GetActivationCode`].
///
/// - Manual mip-sdk-4: Get Act Code (0x0F,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetActivationCodeResponse {
    /// Activation code.
    pub activation_code: crate::Text<32>,
}

impl Wire for GetActivationCodeResponse {
    const SIZE: usize = 32;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let activation_code = reader.read()?;
        Ok(Self { activation_code })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.activation_code)?;
        Ok(())
    }
}

impl Field for GetActivationCodeResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x87;
    const NAME: &'static str = "rtk.get_activation_code_response";
}

/// Get modem firmware version response (0x0F,0x88).
///
/// Answers Get modem firmware version (0x0F,0x08).
///
/// Command: [`GetModemFirmwareVersion`].
///
/// - Manual mip-sdk-4: Get Modem Firmware Version (0x0F,0x08)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetModemFirmwareVersionResponse {
    /// Firmware version.
    pub modem_firmware_version: crate::Text<32>,
}

impl Wire for GetModemFirmwareVersionResponse {
    const SIZE: usize = 32;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let modem_firmware_version = reader.read()?;
        Ok(Self { modem_firmware_version })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.modem_firmware_version)?;
        Ok(())
    }
}

impl Field for GetModemFirmwareVersionResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x88;
    const NAME: &'static str = "rtk.get_modem_firmware_version_response";
}

/// Service status response (0x0F,0x8A).
///
/// What the server knows of the connection.
///
/// Command: [`ServiceStatus`].
///
/// - Manual mip-sdk-4: Service Status (0x0F,0x0A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ServiceStatusResponse {
    /// State of the service.
    pub flags: ServiceFlags,
    /// Bytes received.
    ///
    /// Unit: byte.
    pub received_bytes: u32,
    /// Bytes of the last transfer.
    ///
    /// Unit: byte.
    pub last_bytes: u32,
    /// Time of the last transfer.
    pub last_bytes_time: u64,
}

impl Wire for ServiceStatusResponse {
    const SIZE: usize = 17;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let flags = reader.read()?;
        let received_bytes = reader.read()?;
        let last_bytes = reader.read()?;
        let last_bytes_time = reader.read()?;
        Ok(Self { flags, received_bytes, last_bytes, last_bytes_time })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.flags)?;
        writer.write(&self.received_bytes)?;
        writer.write(&self.last_bytes)?;
        writer.write(&self.last_bytes_time)?;
        Ok(())
    }
}

impl Field for ServiceStatusResponse {
    const SET: u8 = 0x0F;
    const DESCRIPTOR: u8 = 0x8A;
    const NAME: &'static str = "rtk.service_status_response";
}
