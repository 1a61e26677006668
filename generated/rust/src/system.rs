//! System (0x7F): Advanced commands of devices that are built from several intelligent parts.
//!
//! - Manual 3dm-gx5-15: 4.4 System Commands

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x7F;

open_enum! {
    /// A port of a device.
    ///
    /// - Manual mip-sdk-4: Interface Control (0x7F,0x02)
    CommsInterface: u8 {
        /// All ports.
        ALL = 0, "all";
        /// The main port: USB while it is connected, else the main UART.
        MAIN = 1, "main";
        /// The first port that is a UART or can be one.
        UART_1 = 17, "uart_1";
        /// The second UART.
        UART_2 = 18, "uart_2";
        /// The third UART.
        UART_3 = 19, "uart_3";
        /// First virtual serial port of USB.
        USB_1 = 33, "usb_1";
        /// Second virtual serial port of USB; on GNSS/INS models, made for NMEA and RTCM.
        USB_2 = 34, "usb_2";
    }
}

bitfield! {
    /// Protocols of a port.
    ///
    /// - Manual mip-sdk-4: Interface Control (0x7F,0x02)
    CommsProtocols: u32 {
        /// MIP.
        MIP: bool = 0,
            "mip", mip, set_mip, with_mip;
        /// NMEA-0183.
        NMEA: bool = 8,
            "nmea", nmea, set_nmea, with_nmea;
        /// RTCM corrections.
        RTCM: bool = 9,
            "rtcm", rtcm, set_rtcm, with_rtcm;
        /// SPARTN corrections.
        SPARTN: bool = 24,
            "spartn", spartn, set_spartn, with_spartn;
    }
}

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

/// Interface control (0x7F,0x02).
///
/// Protocols that a port takes in and gives out.
///
/// - Accepted on the main port only. The main port always keeps MIP in both directions.
/// - The acknowledge comes on that port after the change; what arrives meanwhile may be lost.
/// - The device refuses protocols that it or the port does not have, and more parsers than it has;
///   then nothing is changed.
/// - Answers in an incoming protocol leave by the same port, even if the protocol is not an
///   outgoing one.
/// - How many parsers and streams there are depends on the device.
///
/// Functions: write, read, save, load, default. Response: [`InterfaceControlResponse`].
///
/// - Manual mip-sdk-4: Interface Control (0x7F,0x02)
/// - Manual 3dm-cv7-gnss-ins: Ports
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InterfaceControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// The port.
    pub port: Option<CommsInterface>,
    /// Protocols that it takes in.
    pub protocols_incoming: Option<CommsProtocols>,
    /// Protocols that it gives out.
    pub protocols_outgoing: Option<CommsProtocols>,
}

impl InterfaceControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        port: CommsInterface,
        protocols_incoming: CommsProtocols,
        protocols_outgoing: CommsProtocols,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            port: Some(port),
            protocols_incoming: Some(protocols_incoming),
            protocols_outgoing: Some(protocols_outgoing),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(port: CommsInterface) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            port: Some(port),
            protocols_incoming: None,
            protocols_outgoing: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(port: CommsInterface) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            port: Some(port),
            protocols_incoming: None,
            protocols_outgoing: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(port: CommsInterface) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            port: Some(port),
            protocols_incoming: None,
            protocols_outgoing: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(port: CommsInterface) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            port: Some(port),
            protocols_incoming: None,
            protocols_outgoing: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for InterfaceControl {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let port = reader.group(required >= 1, Reader::read)?;
        let protocols_incoming = reader.group(required >= 2, Reader::read)?;
        let protocols_outgoing = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, port, protocols_incoming, protocols_outgoing })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.port)?;
        writer.some(required >= 2, &self.protocols_incoming)?;
        writer.some(required >= 3, &self.protocols_outgoing)?;
        Ok(())
    }
}

impl Field for InterfaceControl {
    const SET: u8 = 0x7F;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "system.interface_control";
}

impl Command for InterfaceControl {
    type Response = InterfaceControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<InterfaceControl> for InterfaceControlResponse {}

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

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<CommunicationMode> for CommunicationModeResponse {}

/// Interface control response (0x7F,0x82).
///
/// Answers Interface control (0x7F,0x02).
///
/// Command: [`InterfaceControl`].
///
/// - Manual mip-sdk-4: Interface Control (0x7F,0x02)
/// - Manual 3dm-cv7-gnss-ins: Ports
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InterfaceControlResponse {
    /// The port.
    pub port: CommsInterface,
    /// Protocols that it takes in.
    pub protocols_incoming: CommsProtocols,
    /// Protocols that it gives out.
    pub protocols_outgoing: CommsProtocols,
}

impl Wire for InterfaceControlResponse {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let port = reader.read()?;
        let protocols_incoming = reader.read()?;
        let protocols_outgoing = reader.read()?;
        Ok(Self { port, protocols_incoming, protocols_outgoing })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.port)?;
        writer.write(&self.protocols_incoming)?;
        writer.write(&self.protocols_outgoing)?;
        Ok(())
    }
}

impl Field for InterfaceControlResponse {
    const SET: u8 = 0x7F;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "system.interface_control_response";
}

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
