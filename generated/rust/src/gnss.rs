//! GNSS commands (0x0E): Commands that describe and set up the internal GNSS receivers.
//!
//! - Manual 3dm-cv7-gnss-ins: GNSS (0x0E)

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x0E;

/// One GNSS receiver.
///
/// - Manual 3dm-cv7-gnss-ins: Info
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReceiverInfoEntry {
    /// Receiver, counted from 1.
    ///
    /// Range: at least 1.
    pub receiver_id: u8,
    /// Descriptor set of the data of this receiver.
    ///
    /// Range: 128 to 254.
    pub mip_data_descriptor_set: u8,
    /// Module name or model and firmware version, with a comma between.
    pub description: crate::Text<32>,
}

impl ReceiverInfoEntry {
    /// Puts the values together.
    #[must_use]
    pub fn new(receiver_id: u8, mip_data_descriptor_set: u8, description: crate::Text<32>) -> Self {
        Self { receiver_id, mip_data_descriptor_set, description }
    }
}

impl Wire for ReceiverInfoEntry {
    const SIZE: usize = 34;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let receiver_id = reader.read()?;
        let mip_data_descriptor_set = reader.read()?;
        let description = reader.read()?;
        Ok(Self { receiver_id, mip_data_descriptor_set, description })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.receiver_id)?;
        writer.write(&self.mip_data_descriptor_set)?;
        writer.write(&self.description)?;
        Ok(())
    }
}

bitfield! {
    /// GPS signals that are enabled.
    GpsSignals: u8 {
        /// L1 C/A.
        L1CA: bool = 0,
            "l1ca", l1ca, set_l1ca, with_l1ca;
        /// L2C.
        L2C: bool = 1,
            "l2c", l2c, set_l2c, with_l2c;
        /// L5.
        L5: bool = 2,
            "l5", l5, set_l5, with_l5;
    }
}

bitfield! {
    /// GLONASS signals that are enabled.
    GlonassSignals: u8 {
        /// L1OF.
        L1OF: bool = 0,
            "l1of", l1of, set_l1of, with_l1of;
        /// L2OF.
        L2OF: bool = 1,
            "l2of", l2of, set_l2of, with_l2of;
    }
}

bitfield! {
    /// Galileo signals that are enabled.
    GalileoSignals: u8 {
        /// E1.
        E1: bool = 0,
            "e1", e1, set_e1, with_e1;
        /// E5b.
        E5B: bool = 1,
            "e5b", e5b, set_e5b, with_e5b;
        /// E5a.
        E5A: bool = 2,
            "e5a", e5a, set_e5a, with_e5a;
    }
}

bitfield! {
    /// BeiDou signals that are enabled.
    BeidouSignals: u8 {
        /// B1.
        B1: bool = 0,
            "b1", b1, set_b1, with_b1;
        /// B2.
        B2: bool = 1,
            "b2", b2, set_b2, with_b2;
        /// B2a.
        B2A: bool = 2,
            "b2a", b2a, set_b2a, with_b2a;
    }
}

open_enum! {
    /// How SPARTN corrections come.
    SpartnConnection: u8 {
        /// No connection.
        NONE = 0, "none";
        /// By a network.
        NETWORK = 1, "network";
        /// By satellite in the L band.
        L_BAND = 2, "l_band";
    }
}

/// Receiver info (0x0E,0x01).
///
/// Asks which GNSS receivers the device has.
///
/// Response: [`ReceiverInfoResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReceiverInfo;

impl ReceiverInfo {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for ReceiverInfo {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for ReceiverInfo {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "gnss.receiver_info";
}

impl Command for ReceiverInfo {
    type Response = ReceiverInfoResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<ReceiverInfo> for ReceiverInfoResponse {}

/// Signal configuration (0x0E,0x02).
///
/// GNSS signals that the device uses.
///
/// - A device takes certain combinations only.
/// - The 3DM-CV7-GNSS/INS needs GPS or Galileo, and refuses GPS L1 with BeiDou L1 alone. It takes
///   for GPS and BeiDou none, L1, or L1 and L5; for Galileo none, or L1 and L5; for GLONASS none or
///   L1.
///
/// Functions: write, read, save, load, default. Response: [`SignalConfigurationResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
/// - Manual 3dm-cv7-gnss-ins: GNSS
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SignalConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// GPS signals.
    pub gps_enable: Option<GpsSignals>,
    /// GLONASS signals.
    pub glonass_enable: Option<GlonassSignals>,
    /// Galileo signals.
    pub galileo_enable: Option<GalileoSignals>,
    /// BeiDou signals.
    pub beidou_enable: Option<BeidouSignals>,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: Option<[u8; 4]>,
}

impl SignalConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        gps_enable: GpsSignals,
        glonass_enable: GlonassSignals,
        galileo_enable: GalileoSignals,
        beidou_enable: BeidouSignals,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            gps_enable: Some(gps_enable),
            glonass_enable: Some(glonass_enable),
            galileo_enable: Some(galileo_enable),
            beidou_enable: Some(beidou_enable),
            reserved: Some([0; 4]),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            gps_enable: None,
            glonass_enable: None,
            galileo_enable: None,
            beidou_enable: None,
            reserved: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            gps_enable: None,
            glonass_enable: None,
            galileo_enable: None,
            beidou_enable: None,
            reserved: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            gps_enable: None,
            glonass_enable: None,
            galileo_enable: None,
            beidou_enable: None,
            reserved: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            gps_enable: None,
            glonass_enable: None,
            galileo_enable: None,
            beidou_enable: None,
            reserved: None,
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

impl Wire for SignalConfiguration {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let gps_enable = reader.group(required >= 1, Reader::read)?;
        let glonass_enable = reader.group(required >= 2, Reader::read)?;
        let galileo_enable = reader.group(required >= 3, Reader::read)?;
        let beidou_enable = reader.group(required >= 4, Reader::read)?;
        let reserved = reader.group(required >= 5, Reader::read)?;
        Ok(Self { function, gps_enable, glonass_enable, galileo_enable, beidou_enable, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.gps_enable)?;
        writer.some(required >= 2, &self.glonass_enable)?;
        writer.some(required >= 3, &self.galileo_enable)?;
        writer.some(required >= 4, &self.beidou_enable)?;
        writer.some(required >= 5, &self.reserved)?;
        Ok(())
    }
}

impl Field for SignalConfiguration {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "gnss.signal_configuration";
}

impl Command for SignalConfiguration {
    type Response = SignalConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SignalConfiguration> for SignalConfigurationResponse {}

/// RTK dongle configuration (0x0E,0x10).
///
/// Whether the device talks to the RTK dongle that is connected to it.
///
/// Functions: write, read, save, load, default. Response: [`RtkDongleConfigurationResponse`].
///
/// - Manual mip-sdk-4: Rtk Dongle Configuration (0x0E,0x10)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RtkDongleConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 1 enables the dongle, 0 disables it.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: Option<[u8; 3]>,
}

impl RtkDongleConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: u8) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable),
            reserved: Some([0; 3]),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None, reserved: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None, reserved: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None, reserved: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None, reserved: None }
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

impl Wire for RtkDongleConfiguration {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let reserved = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, enable, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.reserved)?;
        Ok(())
    }
}

impl Field for RtkDongleConfiguration {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x10;
    const NAME: &'static str = "gnss.rtk_dongle_configuration";
}

impl Command for RtkDongleConfiguration {
    type Response = RtkDongleConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<RtkDongleConfiguration> for RtkDongleConfigurationResponse {}

/// SPARTN configuration (0x0E,0x20).
///
/// Source and keys of SPARTN corrections.
///
/// - A change of enable or type has an effect after a power cycle only; keys can be changed while
///   running.
/// - While SPARTN corrections are enabled, RTCM corrections are blocked.
/// - A key of 16 bytes, none of them 0, is sent as 32 ASCII digits 0-9 and A-F, two for each byte.
///
/// Functions: write, read, save, load, default. Response: [`SpartnConfigurationResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
/// - Manual 3dm-cv7-gnss-ins: SPARTN Corrections
/// - Manual 3dm-cv7-gnss-ins: SPARTN Corrections via UART
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SpartnConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 1 enables SPARTN corrections, 0 disables them.
    ///
    /// Range: 0 to 1.
    pub enable: Option<u8>,
    /// How the corrections come.
    pub type_: Option<SpartnConnection>,
    /// GPS time of week until which the current key is valid.
    ///
    /// Unit: s.
    pub current_key_tow: Option<u32>,
    /// GPS week number until which the current key is valid.
    ///
    /// Unit: week.
    pub current_key_week: Option<u16>,
    /// Current key in ASCII digits.
    pub current_key: Option<[u8; 32]>,
    /// GPS time of week until which the next key is valid.
    ///
    /// Unit: s.
    pub next_key_tow: Option<u32>,
    /// GPS week number until which the next key is valid.
    ///
    /// Unit: week.
    pub next_key_week: Option<u16>,
    /// Next key in ASCII digits.
    pub next_key: Option<[u8; 32]>,
}

impl SpartnConfiguration {
    /// Apply the new setting.
    #[must_use]
    #[allow(clippy::too_many_arguments)]
    pub fn write(
        enable: u8,
        type_: SpartnConnection,
        current_key_tow: u32,
        current_key_week: u16,
        current_key: [u8; 32],
        next_key_tow: u32,
        next_key_week: u16,
        next_key: [u8; 32],
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable: Some(enable),
            type_: Some(type_),
            current_key_tow: Some(current_key_tow),
            current_key_week: Some(current_key_week),
            current_key: Some(current_key),
            next_key_tow: Some(next_key_tow),
            next_key_week: Some(next_key_week),
            next_key: Some(next_key),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            enable: None,
            type_: None,
            current_key_tow: None,
            current_key_week: None,
            current_key: None,
            next_key_tow: None,
            next_key_week: None,
            next_key: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            enable: None,
            type_: None,
            current_key_tow: None,
            current_key_week: None,
            current_key: None,
            next_key_tow: None,
            next_key_week: None,
            next_key: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            enable: None,
            type_: None,
            current_key_tow: None,
            current_key_week: None,
            current_key: None,
            next_key_tow: None,
            next_key_week: None,
            next_key: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            enable: None,
            type_: None,
            current_key_tow: None,
            current_key_week: None,
            current_key: None,
            next_key_tow: None,
            next_key_week: None,
            next_key: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 8,
            _ => 0,
        }
    }
}

impl Wire for SpartnConfiguration {
    const SIZE: usize = 79;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        let type_ = reader.group(required >= 2, Reader::read)?;
        let current_key_tow = reader.group(required >= 3, Reader::read)?;
        let current_key_week = reader.group(required >= 4, Reader::read)?;
        let current_key = reader.group(required >= 5, Reader::read)?;
        let next_key_tow = reader.group(required >= 6, Reader::read)?;
        let next_key_week = reader.group(required >= 7, Reader::read)?;
        let next_key = reader.group(required >= 8, Reader::read)?;
        Ok(Self {
            function,
            enable,
            type_,
            current_key_tow,
            current_key_week,
            current_key,
            next_key_tow,
            next_key_week,
            next_key,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        writer.some(required >= 2, &self.type_)?;
        writer.some(required >= 3, &self.current_key_tow)?;
        writer.some(required >= 4, &self.current_key_week)?;
        writer.some(required >= 5, &self.current_key)?;
        writer.some(required >= 6, &self.next_key_tow)?;
        writer.some(required >= 7, &self.next_key_week)?;
        writer.some(required >= 8, &self.next_key)?;
        Ok(())
    }
}

impl Field for SpartnConfiguration {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x20;
    const NAME: &'static str = "gnss.spartn_configuration";
}

impl Command for SpartnConfiguration {
    type Response = SpartnConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SpartnConfiguration> for SpartnConfigurationResponse {}

/// Receiver info response (0x0E,0x81).
///
/// Answers Receiver info (0x0E,0x01).
///
/// Command: [`ReceiverInfo`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReceiverInfoResponse {
    /// The receivers.
    pub receiver_info: crate::List<ReceiverInfoEntry, 7>,
}

impl Wire for ReceiverInfoResponse {
    const SIZE: usize = 239;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let num_receivers = reader.read::<u8>()?;
        let receiver_info = reader.list(num_receivers)?;
        Ok(Self { receiver_info })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.receiver_info.len())?;
        self.receiver_info.encode_items(writer)?;
        Ok(())
    }
}

impl Field for ReceiverInfoResponse {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x81;
    const NAME: &'static str = "gnss.receiver_info_response";
}

/// Signal configuration response (0x0E,0x82).
///
/// Answers Signal configuration (0x0E,0x02).
///
/// Command: [`SignalConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
/// - Manual 3dm-cv7-gnss-ins: GNSS
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SignalConfigurationResponse {
    /// GPS signals.
    pub gps_enable: GpsSignals,
    /// GLONASS signals.
    pub glonass_enable: GlonassSignals,
    /// Galileo signals.
    pub galileo_enable: GalileoSignals,
    /// BeiDou signals.
    pub beidou_enable: BeidouSignals,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: [u8; 4],
}

impl Wire for SignalConfigurationResponse {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let gps_enable = reader.read()?;
        let glonass_enable = reader.read()?;
        let galileo_enable = reader.read()?;
        let beidou_enable = reader.read()?;
        let reserved = reader.read()?;
        Ok(Self { gps_enable, glonass_enable, galileo_enable, beidou_enable, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.gps_enable)?;
        writer.write(&self.glonass_enable)?;
        writer.write(&self.galileo_enable)?;
        writer.write(&self.beidou_enable)?;
        writer.write(&self.reserved)?;
        Ok(())
    }
}

impl Field for SignalConfigurationResponse {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "gnss.signal_configuration_response";
}

/// RTK dongle configuration response (0x0E,0x90).
///
/// Answers RTK dongle configuration (0x0E,0x10).
///
/// Command: [`RtkDongleConfiguration`].
///
/// - Manual mip-sdk-4: Rtk Dongle Configuration (0x0E,0x10)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RtkDongleConfigurationResponse {
    /// 1 enables the dongle, 0 disables it.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: [u8; 3],
}

impl Wire for RtkDongleConfigurationResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let reserved = reader.read()?;
        Ok(Self { enable, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.reserved)?;
        Ok(())
    }
}

impl Field for RtkDongleConfigurationResponse {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "gnss.rtk_dongle_configuration_response";
}

/// SPARTN configuration response (0x0E,0xA0).
///
/// Answers SPARTN configuration (0x0E,0x20).
///
/// Command: [`SpartnConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
/// - Manual 3dm-cv7-gnss-ins: SPARTN Corrections
/// - Manual 3dm-cv7-gnss-ins: SPARTN Corrections via UART
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SpartnConfigurationResponse {
    /// 1 enables SPARTN corrections, 0 disables them.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// How the corrections come.
    pub type_: SpartnConnection,
    /// GPS time of week until which the current key is valid.
    ///
    /// Unit: s.
    pub current_key_tow: u32,
    /// GPS week number until which the current key is valid.
    ///
    /// Unit: week.
    pub current_key_week: u16,
    /// Current key in ASCII digits.
    pub current_key: [u8; 32],
    /// GPS time of week until which the next key is valid.
    ///
    /// Unit: s.
    pub next_key_tow: u32,
    /// GPS week number until which the next key is valid.
    ///
    /// Unit: week.
    pub next_key_week: u16,
    /// Next key in ASCII digits.
    pub next_key: [u8; 32],
}

impl Wire for SpartnConfigurationResponse {
    const SIZE: usize = 78;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        let type_ = reader.read()?;
        let current_key_tow = reader.read()?;
        let current_key_week = reader.read()?;
        let current_key = reader.read()?;
        let next_key_tow = reader.read()?;
        let next_key_week = reader.read()?;
        let next_key = reader.read()?;
        Ok(Self {
            enable,
            type_,
            current_key_tow,
            current_key_week,
            current_key,
            next_key_tow,
            next_key_week,
            next_key,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        writer.write(&self.type_)?;
        writer.write(&self.current_key_tow)?;
        writer.write(&self.current_key_week)?;
        writer.write(&self.current_key)?;
        writer.write(&self.next_key_tow)?;
        writer.write(&self.next_key_week)?;
        writer.write(&self.next_key)?;
        Ok(())
    }
}

impl Field for SpartnConfigurationResponse {
    const SET: u8 = 0x0E;
    const DESCRIPTOR: u8 = 0xA0;
    const NAME: &'static str = "gnss.spartn_configuration_response";
}
