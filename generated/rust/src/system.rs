//! System (0x7F): Advanced commands of devices that are built from several intelligent parts.
//!
//! - Manual 3dm-gx5-15: 4.4 System Commands

use crate::macros::open_enum;
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x7F;

open_enum! {
    /// Which part of the device the host talks to, and in which protocol.
    ProtocolMode: u8 {
        /// The device itself, MIP.
        STANDARD = 1, "standard";
        /// The inertial sensor inside, MIP.
        SENSOR_DIRECT = 2, "sensor_direct";
        /// The GNSS receiver inside, NMEA and UBX; only on models that have one.
        GNSS_DIRECT = 3, "gnss_direct";
    }
}

/// Communication mode (0x7F,0x10).
///
/// Switches the port between the device and one of the sensors inside it.
///
/// - The acknowledge is sent in the old mode, just before the switch.
/// - In a direct mode only this command and device status (0x0C,0x64) of the device itself are
///   answered.
///
/// Functions: write, read, save, load, default. Response: [`CommunicationModeResponse`]. For
/// advanced use. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CommunicationMode {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Communication mode.
    ///
    /// Default: standard.
    pub mode: Option<ProtocolMode>,
}

impl CommunicationMode {
    /// Apply the new setting.
    #[must_use]
    pub fn write(mode: ProtocolMode) -> Self {
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

impl Wire for CommunicationMode {
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

impl Field for CommunicationMode {
    const SET: u8 = 0x7F;
    const DESCRIPTOR: u8 = 0x10;
    const NAME: &'static str = "system.communication_mode";
}

impl Command for CommunicationMode {
    type Response = CommunicationModeResponse;

    fn response_check(&self) -> Option<crate::ResponseCheck> {
        if !matches!(self.function, types::FunctionSelector::READ) {
            return None;
        }
        Some(crate::field::check::<CommunicationModeResponse>)
    }
}

impl ResponseOf<CommunicationMode> for CommunicationModeResponse {}

/// Communication mode response (0x7F,0x90).
///
/// Answers Communication mode (0x7F,0x10).
///
/// Command: [`CommunicationMode`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CommunicationModeResponse {
    /// Communication mode.
    ///
    /// Default: standard.
    pub mode: ProtocolMode,
}

impl Wire for CommunicationModeResponse {
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

impl Field for CommunicationModeResponse {
    const SET: u8 = 0x7F;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "system.communication_mode_response";
}
