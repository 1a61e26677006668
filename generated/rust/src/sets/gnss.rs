//! GNSS commands (0x0E): Commands that describe and set up the internal GNSS receivers.
//!
//! Source: 3dm-cv7-gnss-ins: GNSS (0x0E).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x0E);

record! {
    /// Description of a GNSS receiver.
    ///
    /// Source: 3dm-cv7-gnss-ins: Info; mip-sdk-4: Receiver Info (0x0E,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ReceiverInfoEntry {
        /// Receiver, numbered as in `receiver_id`: 1 and 2 are internal, 4 and 5 external.
        ///
        /// Range: at least 1.
        pub receiver_id: u8,
        /// Descriptor set of this receiver's data.
        ///
        /// Range: 0x80 to 0xFE.
        pub mip_data_descriptor_set: crate::DescriptorSet,
        /// Module name or model and firmware version, separated by a comma.
        pub description: crate::Text<32>,
    }
}

item! { ReceiverInfoEntry { receiver_id mip_data_descriptor_set description } }
view! {
    ReceiverInfoEntry
    receiver_id: u8, at 0;
    mip_data_descriptor_set: crate::DescriptorSet, at 1;
    description: crate::Text<32>, at 2;
}

ranges! {
    ReceiverInfoEntry
    receiver_id "receiver_id" in "at least 1" From 1.0;
    mip_data_descriptor_set "mip_data_descriptor_set" in "0x80 to 0xFE" From 128.0 To 254.0;
}

constructors! {
    ReceiverInfoEntry

    /// Creates it from its values.
    fn new(
        receiver_id: u8,
        mip_data_descriptor_set: impl Into<crate::DescriptorSet>,
        description: crate::Text<32>,
    );
}

tuple! { ReceiverInfoEntry receiver_id: u8, mip_data_descriptor_set: crate::DescriptorSet, description: crate::Text<32> }

bitfield! {
    /// GPS signals that are enabled.
    GpsSignals: u8 {
        /// L1 C/A. Bit 0.
        L1CA: bool = 0,
            l1ca, set_l1ca, with_l1ca;
        /// L2c. Bit 1.
        L2C: bool = 1,
            l2c, set_l2c, with_l2c;
        /// L5. Bit 2.
        L5: bool = 2,
            l5, set_l5, with_l5;
    }
}

bitfield! {
    /// GLONASS signals that are enabled.
    GlonassSignals: u8 {
        /// L1of. Bit 0.
        L1OF: bool = 0,
            l1of, set_l1of, with_l1of;
        /// L2of. Bit 1.
        L2OF: bool = 1,
            l2of, set_l2of, with_l2of;
    }
}

bitfield! {
    /// Galileo signals that are enabled.
    GalileoSignals: u8 {
        /// E1. Bit 0.
        E1: bool = 0,
            e1, set_e1, with_e1;
        /// E5b. Bit 1.
        E5B: bool = 1,
            e5b, set_e5b, with_e5b;
        /// E5a. Bit 2.
        E5A: bool = 2,
            e5a, set_e5a, with_e5a;
    }
}

bitfield! {
    /// BeiDou signals that are enabled.
    BeidouSignals: u8 {
        /// B1. Bit 0.
        B1: bool = 0,
            b1, set_b1, with_b1;
        /// B2. Bit 1.
        B2: bool = 1,
            b2, set_b2, with_b2;
        /// B2a. Bit 2.
        B2A: bool = 2,
            b2a, set_b2a, with_b2a;
    }
}

open_enum! {
    /// A GNSS receiver.
    ///
    /// Source: mip-sdk-4: Receiver Reset (0x0E,0x03).
    ReceiverId: u8 {
        /// Every receiver; only for commands that accept it.
        ALL = 0, "all";
        /// The first receiver inside the device.
        INTERNAL_RECEIVER_1 = 1, "internal_receiver_1";
        /// The second receiver inside the device.
        INTERNAL_RECEIVER_2 = 2, "internal_receiver_2";
        /// The first external receiver.
        USER_RECEIVER_1 = 4, "user_receiver_1";
        /// The second external receiver.
        USER_RECEIVER_2 = 5, "user_receiver_2";
    }
}

open_enum! {
    /// Extent of a receiver restart.
    ///
    /// Source: mip-sdk-4: Receiver Reset (0x0E,0x03).
    ReceiverResetType: u8 {
        /// Resets the hardware of the receiver.
        HARDWARE = 1, "hardware";
        /// Restarts all software of the receiver.
        COLD = 2, "cold";
        /// Restarts the positioning engine only. Uncertain: An earlier branch of the SDK calls 3
        /// hot and 4 warm, with the same descriptions of the two numbers. GNSS receivers usually
        /// keep their satellite data in a hot start and lose it in a warm one.
        WARM = 3, "warm";
        /// Restarts the positioning engine and clears its ephemerides and almanacs. Uncertain: An
        /// earlier branch of the SDK swaps this name with that of 3.
        HOT = 4, "hot";
    }
}

open_enum! {
    /// Strategy for fixing the RTK carrier phase ambiguities to whole numbers.
    ///
    /// Uncertain: The descriptions of `conservative` and `moderate` are inferred from their names.
    ///
    /// Source: mip-sdk-4: Rtk Configuration (0x0E,0x04).
    AmbiguityFixMode: u8 {
        /// Never fixes them. The solution remains a float solution.
        OFF = 1, "off";
        /// Fixes them late, so that few fixes are wrong.
        CONSERVATIVE = 2, "conservative";
        /// Between conservative and aggressive.
        MODERATE = 3, "moderate";
        /// Fixes them as soon as possible.
        AGGRESSIVE = 4, "aggressive";
    }
}

open_enum! {
    /// Channel that delivers SPARTN corrections.
    SpartnConnection: u8 {
        /// No connection.
        NONE = 0, "none";
        /// Over a network.
        NETWORK = 1, "network";
        /// By satellite in the L band.
        L_BAND = 2, "l_band";
    }
}

record! {
    /// Receiver info (0x0E,0x01).
    ///
    /// Gets the GNSS receivers of the device.
    ///
    /// Response: [`ReceiverInfoResponse`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ReceiverInfo;
}

constructors! {
    ReceiverInfo

    /// Creates the command from its parameters.
    fn new();
}

field! {
    ReceiverInfo: 0x01, "gnss.receiver_info";
    in [0x0E];
}

command! {
    ReceiverInfo -> ReceiverInfoResponse;
    responds ReceiverInfoResponse;
}

record! {
    /// Signal configuration (0x0E,0x02).
    ///
    /// Selects the GNSS signals that the device uses.
    ///
    /// Also called `signal_configuration`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`SignalConfigResponse`]. Probably affects
    /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo),
    /// [`gnss_data::SatelliteStatus`](crate::gnss_data::SatelliteStatus) and
    /// [`gnss_data::Raw`](crate::gnss_data::Raw). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more. Requires
    /// firmware later than 1.0.10 on the [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// - A device accepts only certain combinations.
    /// - The 3DM-CV7-GNSS/INS needs GPS or Galileo, and rejects GPS L1 with BeiDou L1 alone. For
    ///   GPS and BeiDou it accepts none, L1, or L1 and L5; for Galileo none, or L1 and L5; for
    ///   GLONASS none or L1.
    ///
    /// Source: 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02); 3dm-cv7-gnss-ins: GNSS.
    #[derive(Copy, Eq, Hash)]
    pub struct SignalConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// GPS signals.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub gps_enable: Option<GpsSignals>,
        /// GLONASS signals.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub glonass_enable: Option<GlonassSignals>,
        /// Galileo signals.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub galileo_enable: Option<GalileoSignals>,
        /// BeiDou signals.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub beidou_enable: Option<BeidouSignals>,
        /// Reserved: send 0. Required for [write](types::FunctionSelector::WRITE).
        pub reserved: Option<[u8; 4]>,
    }
    wire 9 {
        [function selects]
        [gps_enable for WRITE]
        [glonass_enable for WRITE]
        [galileo_enable for WRITE]
        [beidou_enable for WRITE]
        [reserved for WRITE]
    }
}

constructors! {
    SignalConfig

    /// Apply the new setting.
    fn write(
        gps_enable: GpsSignals,
        glonass_enable: GlonassSignals,
        galileo_enable: GalileoSignals,
        beidou_enable: BeidouSignals,
    ) -> WriteCall, reserved: [0; 4];

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
    SignalConfig: 0x02, "gnss.signal_config";
    in [0x0E];
}

command! {
    SignalConfig -> Option<SignalConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SignalConfigResponse;
    responds SignalConfigResponse for READ;
}

change! {
    SignalConfigResponse -> WriteCall SignalConfig
    [gps_enable glonass_enable galileo_enable beidou_enable] reserved: [0; 4],
}

record! {
    /// Receiver reset (0x0E,0x03).
    ///
    /// Resets a GNSS receiver of the device.
    ///
    /// Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The
    /// SDK names no device that supports it.
    ///
    /// - Only internal receivers can be reset.
    /// - Some devices do not support all reset types.
    ///
    /// Source: mip-sdk-4: Receiver reset (0x0E,0x03).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ReceiverReset {
        /// Receiver to reset.
        pub receiver_id: ReceiverId,
        /// Extent of the restart.
        pub reset_type: ReceiverResetType,
    }
}

constructors! {
    ReceiverReset

    /// Creates the command from its parameters.
    fn new(receiver_id: ReceiverId, reset_type: ReceiverResetType);
}

field! {
    ReceiverReset: 0x03, "gnss.receiver_reset";
    in [0x0E];
}

command! {
    ReceiverReset -> ();
}

record! {
    /// RTK configuration (0x0E,0x04).
    ///
    /// Sets how readily the device fixes the ambiguities of an RTK solution.
    ///
    /// Also called `rtk_configuration`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`RtkConfigResponse`]. Probably affects
    /// [`gnss_data::FixInfo`](crate::gnss_data::FixInfo) and
    /// [`gnss_data::LlhPosition`](crate::gnss_data::LlhPosition). Not listed in any device profile.
    /// Known only from the MicroStrain MIP SDK. Uncertain: No source lists the devices that support
    /// it. Users of the vendor's ROS driver report it as experimental on the 3DM-GQ7, which accepts
    /// `conservative` only.
    ///
    /// - The available modes differ by device.
    ///
    /// Source: mip-sdk-4: RTK configuration (0x0E,0x04).
    #[derive(Copy, Eq, Hash)]
    pub struct RtkConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Strategy for fixing ambiguities.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub ambiguity_fix_mode: Option<AmbiguityFixMode>,
        /// Reserved: send 0. Required for [write](types::FunctionSelector::WRITE).
        pub reserved: Option<[u8; 4]>,
    }
    wire 6 {
        [function selects]
        [ambiguity_fix_mode for WRITE]
        [reserved for WRITE]
    }
}

constructors! {
    RtkConfig

    /// Apply the new setting.
    fn write(ambiguity_fix_mode: AmbiguityFixMode) -> WriteCall, reserved: [0; 4];

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
    RtkConfig: 0x04, "gnss.rtk_config";
    in [0x0E];
}

command! {
    RtkConfig -> Option<RtkConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> RtkConfigResponse;
    responds RtkConfigResponse for READ;
}

change! {
    RtkConfigResponse -> WriteCall RtkConfig
    [ambiguity_fix_mode] reserved: [0; 4],
}

record! {
    /// RTK dongle configuration (0x0E,0x10).
    ///
    /// Switches the communication with a connected RTK dongle on or off.
    ///
    /// No device is known for certain to support it. Also called `rtk_dongle_configuration`.
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`RtkDongleConfigResponse`]. Probably
    /// affects [`gnss_data::RtkCorrectionsStatus`](crate::gnss_data::RtkCorrectionsStatus). Known
    /// only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: RTK dongle configuration (0x0E,0x10).
    #[derive(Copy, Eq, Hash)]
    pub struct RtkDongleConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 1 enables the dongle, 0 disables it.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
        /// Reserved: send 0. Required for [write](types::FunctionSelector::WRITE). Uncertain: No
        /// source states what to send; 0 is assumed.
        pub reserved: Option<[u8; 3]>,
    }
    wire 5 {
        [function selects]
        [enable for WRITE]
        [reserved for WRITE]
    }
}

ranges! {
    RtkDongleConfig
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    RtkDongleConfig

    /// Apply the new setting.
    fn write(enable: u8) -> WriteCall, reserved: [0; 3];

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
    RtkDongleConfig: 0x10, "gnss.rtk_dongle_config";
    in [0x0E];
}

command! {
    RtkDongleConfig -> Option<RtkDongleConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> RtkDongleConfigResponse;
    responds RtkDongleConfigResponse for READ;
    checks Ranged;
}

change! {
    RtkDongleConfigResponse -> WriteCall RtkDongleConfig
    [enable] reserved: [0; 3],
}

record! {
    /// SPARTN configuration (0x0E,0x20).
    ///
    /// Sets the source and the keys of SPARTN corrections.
    ///
    /// Also called `spartn_configuration`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`SpartnConfigResponse`]. Probably affects
    /// [`gnss_data::RtkCorrectionsStatus`](crate::gnss_data::RtkCorrectionsStatus). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS). Uncertain: The device may not accept lower
    /// case: the section on UART uses the digits 0-9 and A-F, the description of the command uses
    /// "bc" for 0xBC.
    ///
    /// - A change of `enable` or `type` takes effect only after a power cycle; keys can be changed
    ///   at any time.
    /// - While SPARTN corrections are enabled, RTCM corrections are blocked.
    /// - A key has 16 bytes, none of them 0. Send it as 32 hexadecimal digits in ASCII, two for
    ///   each byte.
    ///
    /// Source: 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20); 3dm-cv7-gnss-ins: SPARTN
    /// Corrections; 3dm-cv7-gnss-ins: SPARTN Corrections via UART.
    #[derive(Eq, Hash)]
    pub struct SpartnConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 1 enables SPARTN corrections, 0 disables them.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<u8>,
        /// Channel of the corrections.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: Option<SpartnConnection>,
        /// GPS time of week until which the current key is valid.
        ///
        /// Unit: s. Required for [write](types::FunctionSelector::WRITE).
        pub current_key_tow: Option<u32>,
        /// GPS week number until which the current key is valid.
        ///
        /// Unit: week. Required for [write](types::FunctionSelector::WRITE).
        pub current_key_week: Option<u16>,
        /// Current key in ASCII digits.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub current_key: Option<[u8; 32]>,
        /// GPS time of week until which the next key is valid.
        ///
        /// Unit: s. Required for [write](types::FunctionSelector::WRITE).
        pub next_key_tow: Option<u32>,
        /// GPS week number until which the next key is valid.
        ///
        /// Unit: week. Required for [write](types::FunctionSelector::WRITE).
        pub next_key_week: Option<u16>,
        /// Next key in ASCII digits.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub next_key: Option<[u8; 32]>,
    }
    wire 79 {
        [function selects]
        [enable for WRITE]
        [type_ "type" for WRITE]
        [current_key_tow for WRITE]
        [current_key_week for WRITE]
        [current_key for WRITE]
        [next_key_tow for WRITE]
        [next_key_week for WRITE]
        [next_key for WRITE]
    }
}

ranges! {
    SpartnConfig
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    SpartnConfig

    /// Apply the new setting.
    fn write(
        enable: u8,
        type_: SpartnConnection,
        current_key_tow: u32,
        current_key_week: u16,
        current_key: [u8; 32],
        next_key_tow: u32,
        next_key_week: u16,
        next_key: [u8; 32],
    ) -> WriteCall;

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
    SpartnConfig: 0x20, "gnss.spartn_config";
    in [0x0E];
}

command! {
    SpartnConfig -> Option<SpartnConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SpartnConfigResponse;
    responds SpartnConfigResponse for READ;
    checks Ranged;
}

change! {
    SpartnConfigResponse -> WriteCall SpartnConfig
    [enable type_ current_key_tow current_key_week current_key next_key_tow next_key_week next_key]
}

record! {
    /// Receiver safe mode (0x0E,0x60).
    ///
    /// Switches the safe mode of one receiver on or off. In safe mode, it sends no valid data.
    ///
    /// Affects gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known
    /// only from the MicroStrain MIP SDK, versions 1 to 3. Uncertain: The layout is that of version
    /// 1.0.0 of the SDK; later versions do not have it. Uncertain: No source lists the devices that
    /// support it.
    ///
    /// Source: mip-sdk-3: Receiver Safe Mode (0x0E,0x60), tag v1.0.0.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ReceiverSafeMode {
        /// Number of the receiver, from 1.
        ///
        /// Range: at least 1.
        pub receiver_id: u8,
        /// 1 switches safe mode on, 0 off.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
    }
}

ranges! {
    ReceiverSafeMode
    receiver_id "receiver_id" in "at least 1" From 1.0;
    enable "enable" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    ReceiverSafeMode

    /// Creates the command from its parameters.
    fn new(receiver_id: u8, enable: u8);
}

field! {
    ReceiverSafeMode: 0x60, "gnss.receiver_safe_mode";
    in [0x0E];
}

command! {
    ReceiverSafeMode -> ();
    checks Ranged;
}

record! {
    /// Receiver info response (0x0E,0x81).
    ///
    /// Response to [`ReceiverInfo`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 1 more.
    ///
    /// The wire format also contains `num_receivers`: Number of physical receivers. Counts the
    /// elements of [`receiver_info`](ReceiverInfoResponse::receiver_info).
    ///
    /// Source: 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01).
    #[derive(Default, Eq, Hash)]
    pub struct ReceiverInfoResponse {
        /// One entry for each receiver.
        pub receiver_info: crate::List<ReceiverInfoEntry, 7>,
    }
    wire 239 {
        [num_receivers: u8 counts receiver_info]
        [receiver_info by num_receivers]
    }
}

constructors! {
    ReceiverInfoResponse

    /// Creates it from its values.
    fn new(receiver_info: impl Into<crate::List<ReceiverInfoEntry, 7>>);
}

field! {
    ReceiverInfoResponse: 0x81, "gnss.receiver_info_response";
    in [0x0E];
    answers ReceiverInfo;
}

record! {
    /// Signal configuration response (0x0E,0x82).
    ///
    /// Also called `signal_configuration_response`. Response to [`SignalConfig`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02); 3dm-cv7-gnss-ins: GNSS.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SignalConfigResponse {
        /// GPS signals.
        pub gps_enable: GpsSignals,
        /// GLONASS signals.
        pub glonass_enable: GlonassSignals,
        /// Galileo signals.
        pub galileo_enable: GalileoSignals,
        /// BeiDou signals.
        pub beidou_enable: BeidouSignals,
        /// Reserved.
        pub reserved: [u8; 4],
    }
}

view! {
    SignalConfigResponse
    gps_enable: GpsSignals, at 0;
    glonass_enable: GlonassSignals, at 1;
    galileo_enable: GalileoSignals, at 2;
    beidou_enable: BeidouSignals, at 3;
    reserved: [u8; 4], at 4;
}

constructors! {
    SignalConfigResponse

    /// Creates it from its values.
    fn new(
        gps_enable: GpsSignals,
        glonass_enable: GlonassSignals,
        galileo_enable: GalileoSignals,
        beidou_enable: BeidouSignals,
    ), reserved: [0; 4];
}

field! {
    SignalConfigResponse: 0x82, "gnss.signal_config_response";
    in [0x0E];
    answers SignalConfig;
}

record! {
    /// RTK configuration response (0x0E,0x84).
    ///
    /// Also called `rtk_configuration_response`. Response to [`RtkConfig`]. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: RTK configuration (0x0E,0x04).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct RtkConfigResponse {
        /// Strategy for fixing ambiguities.
        pub ambiguity_fix_mode: AmbiguityFixMode,
        /// Reserved.
        pub reserved: [u8; 4],
    }
}

view! {
    RtkConfigResponse
    ambiguity_fix_mode: AmbiguityFixMode, at 0;
    reserved: [u8; 4], at 1;
}

constructors! {
    RtkConfigResponse

    /// Creates it from its values.
    fn new(ambiguity_fix_mode: AmbiguityFixMode), reserved: [0; 4];
}

field! {
    RtkConfigResponse: 0x84, "gnss.rtk_config_response";
    in [0x0E];
    answers RtkConfig;
}

record! {
    /// RTK dongle configuration response (0x0E,0x90).
    ///
    /// No device is known for certain to support it. Also called
    /// `rtk_dongle_configuration_response`. Response to [`RtkDongleConfig`]. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: RTK dongle configuration (0x0E,0x10).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct RtkDongleConfigResponse {
        /// 1 enables the dongle, 0 disables it.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Reserved. Uncertain: No source states what to send; 0 is assumed.
        pub reserved: [u8; 3],
    }
}

view! {
    RtkDongleConfigResponse
    enable: u8, at 0;
    reserved: [u8; 3], at 1;
}

constructors! {
    RtkDongleConfigResponse

    /// Creates it from its values.
    fn new(enable: u8), reserved: [0; 3];
}

field! {
    RtkDongleConfigResponse: 0x90, "gnss.rtk_dongle_config_response";
    in [0x0E];
    answers RtkDongleConfig;
}

record! {
    /// SPARTN configuration response (0x0E,0xA0).
    ///
    /// Also called `spartn_configuration_response`. Response to [`SpartnConfig`]. Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS).
    ///
    /// Source: 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20); 3dm-cv7-gnss-ins: SPARTN
    /// Corrections; 3dm-cv7-gnss-ins: SPARTN Corrections via UART.
    #[derive(Default, Eq, Hash)]
    pub struct SpartnConfigResponse {
        /// 1 enables SPARTN corrections, 0 disables them.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Channel of the corrections.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
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
    wire 78 {
        [enable]
        [type_ "type"]
        [current_key_tow]
        [current_key_week]
        [current_key]
        [next_key_tow]
        [next_key_week]
        [next_key]
    }
}

view! {
    SpartnConfigResponse
    enable: u8, at 0;
    type_: SpartnConnection, at 1;
    current_key_tow: u32, at 2;
    current_key_week: u16, at 6;
    current_key: [u8; 32], at 8;
    next_key_tow: u32, at 40;
    next_key_week: u16, at 44;
    next_key: [u8; 32], at 46;
}

constructors! {
    SpartnConfigResponse

    /// Creates it from its values.
    fn new(
        enable: u8,
        type_: SpartnConnection,
        current_key_tow: u32,
        current_key_week: u16,
        current_key: [u8; 32],
        next_key_tow: u32,
        next_key_week: u16,
        next_key: [u8; 32],
    );
}

field! {
    SpartnConfigResponse: 0xA0, "gnss.spartn_config_response";
    in [0x0E];
    answers SpartnConfig;
}
