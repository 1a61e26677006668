//! System (0x7F): Advanced commands of devices that consist of several intelligent parts.
//!
//! Source: 3dm-gx5-15: 4.4 System Commands.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x7F);

bitfield! {
    /// Protocols of a port.
    ///
    /// Source: mip-sdk-4: Interface Control (0x7F,0x02).
    CommProtocols: u32 {
        /// Mip. Bit 0.
        MIP: bool = 0,
            mip, set_mip, with_mip;
        /// NMEA-0183. Bit 8.
        NMEA: bool = 8,
            nmea, set_nmea, with_nmea;
        /// RTCM corrections. Bit 9.
        RTCM: bool = 9,
            rtcm, set_rtcm, with_rtcm;
        /// SPARTN corrections. Bit 24.
        SPARTN: bool = 24,
            spartn, set_spartn, with_spartn;
        /// SBF, the binary format of Septentrio receivers. Bit 29.
        SBF: bool = 29,
            sbf, set_sbf, with_sbf;
    }
}

open_enum! {
    /// Part of the device that the host communicates with, and its protocol.
    ProtocolMode: u8 {
        /// The device itself; the protocol is MIP.
        STANDARD = 1, "standard";
        /// The internal inertial sensor; the protocol is MIP.
        SENSOR_DIRECT = 2, "sensor_direct";
        /// The internal GNSS receiver; the protocols are NMEA and UBX. Requires a receiver.
        GNSS_DIRECT = 3, "gnss_direct";
    }
}

record! {
    /// Interface control (0x7F,0x02).
    ///
    /// Sets the protocols that a port receives and sends.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`InterfaceControlResponse`].
    /// Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS).
    ///
    /// - Accepted on the main port only. The main port always keeps MIP in both directions.
    /// - The change takes effect before the ACK, which is sent on the main port. Bytes that arrive
    ///   during the change may be lost.
    /// - The device rejects protocols that it or the port does not support, and settings that need
    ///   more parsers than it has. A rejected command changes nothing.
    /// - Replies to an incoming protocol are sent on the same port, even if the protocol is not an
    ///   outgoing one.
    /// - Devices differ in how many protocols they receive and send at a time.
    ///
    /// Source: mip-sdk-4: Interface control (0x7F,0x02); 3dm-cv7-gnss-ins: Ports.
    #[derive(Copy, Eq, Hash)]
    pub struct InterfaceControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Port whose protocols are set or read.
        ///
        /// Uncertain: No source states whether write and read accept `all`.
        pub port: Option<types::CommInterface>,
        /// Protocols that the port receives.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub protocols_incoming: Option<CommProtocols>,
        /// Protocols that the port sends.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub protocols_outgoing: Option<CommProtocols>,
    }
    wire 10 {
        [function selects]
        [port for WRITE READ SAVE LOAD DEFAULT]
        [protocols_incoming for WRITE]
        [protocols_outgoing for WRITE]
    }
}

constructors! {
    InterfaceControl

    /// Apply the new setting.
    fn write(
        port: types::CommInterface,
        protocols_incoming: CommProtocols,
        protocols_outgoing: CommProtocols,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read(port: types::CommInterface) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(port: types::CommInterface) -> SaveCall;

    /// Load the saved setting.
    fn load(port: types::CommInterface) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(port: types::CommInterface) -> LoadDefaultCall;
}

field! {
    InterfaceControl: 0x02, "system.interface_control";
    in [0x7F];
}

command! {
    InterfaceControl -> Option<InterfaceControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> InterfaceControlResponse;
    responds InterfaceControlResponse for READ;
}

change! {
    InterfaceControlResponse -> WriteCall InterfaceControl
    [port protocols_incoming protocols_outgoing]
}

record! {
    /// Communication mode (0x7F,0x10).
    ///
    /// Switches the port between the device and one of its internal sensors.
    ///
    /// For advanced use. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`CommModeResponse`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 17 more.
    ///
    /// - The ACK is sent in the old mode, just before the switch.
    /// - In a direct mode, the device itself replies only to this command and
    ///   [`mip_3dm::DeviceStatus`](crate::mip_3dm::DeviceStatus).
    ///
    /// Source: 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10).
    #[derive(Copy, Eq, Hash)]
    pub struct CommMode {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Communication mode.
        ///
        /// Default: [`ProtocolMode::STANDARD`]. Required for
        /// [write](types::FunctionSelector::WRITE). On the [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-15](crate::devices::CX5_15),
        /// [3DM-CX5-25](crate::devices::CX5_25), [3DM-GX4-15](crate::devices::GX4_15),
        /// [3DM-GX4-25](crate::devices::GX4_25), [3DM-GX5-15](crate::devices::GX5_15) and
        /// [3DM-GX5-25](crate::devices::GX5_25): only [`ProtocolMode::STANDARD`] and
        /// [`ProtocolMode::SENSOR_DIRECT`]. On the [3DM-GX5-35](crate::devices::GX5_35): default
        /// [`ProtocolMode::STANDARD`].
        pub mode: Option<ProtocolMode>,
    }
    wire 2 {
        [function selects]
        [mode for WRITE]
    }
}

constructors! {
    CommMode

    /// Apply the new setting.
    fn write(mode: ProtocolMode) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    CommMode: 0x10, "system.comm_mode";
    in [0x7F];
}

command! {
    CommMode -> Option<CommModeResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> CommModeResponse;
    responds CommModeResponse for READ;
}

change! {
    CommModeResponse -> WriteCall CommMode
    [mode]
}

record! {
    /// Interface control response (0x7F,0x82).
    ///
    /// Response to [`InterfaceControl`]. Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS).
    ///
    /// Source: mip-sdk-4: Interface control (0x7F,0x02); 3dm-cv7-gnss-ins: Ports.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct InterfaceControlResponse {
        /// Port whose protocols are set or read.
        ///
        /// Uncertain: No source states whether write and read accept `all`.
        pub port: types::CommInterface,
        /// Protocols that the port receives.
        pub protocols_incoming: CommProtocols,
        /// Protocols that the port sends.
        pub protocols_outgoing: CommProtocols,
    }
}

view! {
    InterfaceControlResponse
    port: types::CommInterface, at 0;
    protocols_incoming: CommProtocols, at 1;
    protocols_outgoing: CommProtocols, at 5;
}

constructors! {
    InterfaceControlResponse

    /// Creates it from its values.
    fn new(
        port: types::CommInterface,
        protocols_incoming: CommProtocols,
        protocols_outgoing: CommProtocols,
    );
}

field! {
    InterfaceControlResponse: 0x82, "system.interface_control_response";
    in [0x7F];
    answers InterfaceControl;
}

record! {
    /// Communication mode response (0x7F,0x90).
    ///
    /// Response to [`CommMode`]. Confirmed on [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 17 more.
    ///
    /// Source: 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct CommModeResponse {
        /// Communication mode.
        ///
        /// Default: [`ProtocolMode::STANDARD`].
        pub mode: ProtocolMode,
    }
}

view! {
    CommModeResponse
    mode: ProtocolMode, at 0;
}

constructors! {
    CommModeResponse

    /// Creates it from its values.
    fn new(mode: ProtocolMode);
}

field! {
    CommModeResponse: 0x90, "system.comm_mode_response";
    in [0x7F];
    answers CommMode;
}
