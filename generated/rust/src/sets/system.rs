//! System (0x7F): Advanced commands of devices that are built from several intelligent parts.
//!
//! Source: 3dm-gx5-15: 4.4 System Commands.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

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

record! {
    /// Communication mode (0x7F,0x10).
    ///
    /// Switches the port between the device and one of the sensors inside it.
    ///
    /// For advanced use. Functions: write, read, save, load and default. Answered by
    /// [`CommunicationModeResponse`]. Supported by 3DM-GX5-15.
    ///
    /// - The acknowledge is sent in the old mode, just before the switch.
    /// - In a direct mode only this command and device status
    ///   [(0x0C,0x64)](crate::mip_3dm::DeviceStatus) of the device itself are answered.
    ///
    /// Source: 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10).
    pub struct CommunicationMode {
        /// What to do with the setting.
        pub function: types::FunctionSelector,
        /// Communication mode.
        ///
        /// Default: [`ProtocolMode::STANDARD`]. Required for write.
        pub mode: Option<ProtocolMode>,
    }
    wire 2 {
        [function selects]
        [mode for WRITE]
    }
}

constructors! {
    CommunicationMode

    /// Apply the new setting.
    fn write(mode: ProtocolMode) = WRITE;

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
    CommunicationMode: 0x7F, 0x10, "system.communication_mode";
}

command! {
    CommunicationMode -> CommunicationModeResponse;
    responds for READ;
}

record! {
    /// Communication mode response (0x7F,0x90).
    ///
    /// Answers [`CommunicationMode`]. Supported by 3DM-GX5-15.
    ///
    /// Source: 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10).
    #[derive(Default)]
    pub struct CommunicationModeResponse {
        /// Communication mode.
        ///
        /// Default: [`ProtocolMode::STANDARD`].
        pub mode: ProtocolMode,
    }
}

field! {
    CommunicationModeResponse: 0x7F, 0x90, "system.communication_mode_response";
    answers CommunicationMode;
}
