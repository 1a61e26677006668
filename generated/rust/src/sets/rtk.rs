//! RTK commands (0x0F): Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.
//!
//! Uncertain: The SDK describes hardly any of this set; most descriptions are inferred from the
//! names. Uncertain: No source states how strings are padded or terminated.
//!
//! Source: mip-sdk-4: Rtk Commands (0x0F).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x0F);

open_enum! {
    /// Type of device connected to a corrections modem.
    ///
    /// Source: mip-sdk-4: Connected Device Type (0x0F,0x06).
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
    /// Source: mip-sdk-4: Service Status (0x0F,0x0A).
    ServiceFlags: u8 {
        /// The server limits the rate. Bit 0.
        THROTTLE: bool = 0,
            throttle, set_throttle, with_throttle;
        /// There are no corrections. Bit 1.
        CORRECTIONS_UNAVAILABLE: bool = 1,
            corrections_unavailable, set_corrections_unavailable, with_corrections_unavailable;
    }
}

open_enum! {
    /// A storage medium of a corrections modem.
    ///
    /// Source: mip-sdk-4: Prod Erase Storage (0x0F,0x20).
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
    /// Source: mip-sdk-4: Led Control (0x0F,0x21).
    LedAction: u8 {
        /// No pattern.
        NONE = 0, "none";
        /// Flashing.
        FLASH = 1, "flash";
        /// Pulsating.
        PULSATE = 2, "pulsate";
    }
}

record! {
    /// Get status flags (0x0F,0x01).
    ///
    /// Gets the state of the modem and of the corrections.
    ///
    /// No device is known for certain to support it. Response: [`GetStatusFlagsResponse`]. Known
    /// only from the MicroStrain MIP SDK.
    ///
    /// - The status word in the response has two forms: [`types::RtkStatusFlags`] if its `version`
    ///   is not 0, and [`types::RtkStatusFlagsLegacy`] if it is.
    ///
    /// Source: mip-sdk-4: Get status flags (0x0F,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetStatusFlags;
}

constructors! {
    GetStatusFlags

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetStatusFlags: 0x01, "rtk.get_status_flags";
    in [0x0F];
}

command! {
    GetStatusFlags -> GetStatusFlagsResponse;
    responds GetStatusFlagsResponse;
}

record! {
    /// Get IMEI (0x0F,0x02).
    ///
    /// Gets the identity of the modem.
    ///
    /// Response: [`GetImeiResponse`]. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get IMEI (0x0F,0x02).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetImei;
}

constructors! {
    GetImei

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetImei: 0x02, "rtk.get_imei";
    in [0x0F];
}

command! {
    GetImei -> GetImeiResponse;
    responds GetImeiResponse;
}

record! {
    /// Get IMSI (0x0F,0x03).
    ///
    /// Gets the identity of the subscriber.
    ///
    /// Response: [`GetImsiResponse`]. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get IMSI (0x0F,0x03).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetImsi;
}

constructors! {
    GetImsi

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetImsi: 0x03, "rtk.get_imsi";
    in [0x0F];
}

command! {
    GetImsi -> GetImsiResponse;
    responds GetImsiResponse;
}

record! {
    /// Get ICCID (0x0F,0x04).
    ///
    /// Gets the number of the SIM card.
    ///
    /// Response: [`GetIccidResponse`]. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get ICCID (0x0F,0x04).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetIccid;
}

constructors! {
    GetIccid

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetIccid: 0x04, "rtk.get_iccid";
    in [0x0F];
}

command! {
    GetIccid -> GetIccidResponse;
    responds GetIccidResponse;
}

record! {
    /// Get RSSI (0x0F,0x05).
    ///
    /// Gets the strength of the cellular signal.
    ///
    /// Response: [`GetRssiResponse`]. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get RSSI (0x0F,0x05).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetRssi;
}

constructors! {
    GetRssi

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetRssi: 0x05, "rtk.get_rssi";
    in [0x0F];
}

command! {
    GetRssi -> GetRssiResponse;
    responds GetRssiResponse;
}

record! {
    /// Connected device type (0x0F,0x06).
    ///
    /// Sets the type of device that the modem is connected to.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ConnectedDeviceTypeResponse`]. Not
    /// listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Connected device type (0x0F,0x06).
    #[derive(Copy, Eq, Hash)]
    pub struct ConnectedDeviceType {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Type of device that the modem is connected to.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub device_type: Option<ConnectedDevice>,
    }
    wire 2 {
        [function selects]
        [device_type for WRITE]
    }
}

constructors! {
    ConnectedDeviceType

    /// Apply the new setting.
    fn write(device_type: ConnectedDevice) -> WriteCall;

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
    ConnectedDeviceType: 0x06, "rtk.connected_device_type";
    in [0x0F];
}

command! {
    ConnectedDeviceType -> Option<ConnectedDeviceTypeResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ConnectedDeviceTypeResponse;
    responds ConnectedDeviceTypeResponse for READ;
}

change! {
    ConnectedDeviceTypeResponse -> WriteCall ConnectedDeviceType
    [device_type]
}

record! {
    /// Get activation code (0x0F,0x07).
    ///
    /// Reads the code that activates the modem for its service.
    ///
    /// No device is known for certain to support it. Also called `get_act_code`. Response:
    /// [`GetActivationCodeResponse`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get Act Code (0x0F,0x07).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetActivationCode;
}

constructors! {
    GetActivationCode

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetActivationCode: 0x07, "rtk.get_activation_code";
    in [0x0F];
}

command! {
    GetActivationCode -> GetActivationCodeResponse;
    responds GetActivationCodeResponse;
}

record! {
    /// Get modem firmware version (0x0F,0x08).
    ///
    /// Gets the firmware version of the cellular modem.
    ///
    /// Response: [`GetModemFirmwareVersionResponse`]. Not listed in any device profile. Known only
    /// from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get modem firmware version (0x0F,0x08).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetModemFirmwareVersion;
}

constructors! {
    GetModemFirmwareVersion

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetModemFirmwareVersion: 0x08, "rtk.get_modem_firmware_version";
    in [0x0F];
}

command! {
    GetModemFirmwareVersion -> GetModemFirmwareVersionResponse;
    responds GetModemFirmwareVersionResponse;
}

record! {
    /// Service status (0x0F,0x0A).
    ///
    /// Queries a correction server about the connection, which also keeps it open.
    ///
    /// Response: [`ServiceStatusResponse`]. Sent by the device; the host replies. Not listed in any
    /// device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - The modem acts as the host and the server as the device.
    ///
    /// Source: mip-sdk-4: Service status (0x0F,0x0A).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ServiceStatus {
        /// Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed.
        pub reserved1: u32,
        /// Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed.
        pub reserved2: u32,
    }
}

constructors! {
    ServiceStatus

    /// Creates the command from its parameters.
    fn new(), reserved1: 0, reserved2: 0;
}

field! {
    ServiceStatus: 0x0A, "rtk.service_status";
    in [0x0F];
}

command! {
    ServiceStatus -> ServiceStatusResponse;
    responds ServiceStatusResponse;
}

record! {
    /// Erase storage (0x0F,0x20).
    ///
    /// Returns a storage medium to its raw state. Everything on it is erased.
    ///
    /// For advanced use. Also called `prod_erase_storage`. Not listed in any device profile. Known
    /// only from the MicroStrain MIP SDK.
    ///
    /// - All stored data is lost. The command is for production.
    /// - Accepted in calibration mode only.
    ///
    /// Source: mip-sdk-4: Prod Erase Storage (0x0F,0x20).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EraseStorage {
        /// The medium.
        pub media: StorageMedium,
    }
}

constructors! {
    EraseStorage

    /// Creates the command from its parameters.
    fn new(media: StorageMedium);
}

field! {
    EraseStorage: 0x20, "rtk.erase_storage";
    in [0x0F];
}

command! {
    EraseStorage -> ();
}

record! {
    /// LED control (0x0F,0x21).
    ///
    /// Sets the colours and the pattern of the LED.
    ///
    /// For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - Accepted in calibration mode and production test mode only.
    ///
    /// Source: mip-sdk-4: LED control (0x0F,0x21).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct LedControl {
        /// First colour.
        ///
        /// Uncertain: No source states the order of its parts; red, green, blue is likely.
        pub primary_color: [u8; 3],
        /// Second colour.
        ///
        /// Uncertain: No source states the order of its parts; red, green, blue is likely.
        pub alternate_color: [u8; 3],
        /// Pattern.
        pub action: LedAction,
        /// Period of the pattern.
        ///
        /// Uncertain: No source states the unit; ms is likely.
        pub period: u32,
    }
}

constructors! {
    LedControl

    /// Creates the command from its parameters.
    fn new(
        primary_color: [u8; 3],
        alternate_color: [u8; 3],
        action: LedAction,
        period: u32,
    );
}

field! {
    LedControl: 0x21, "rtk.led_control";
    in [0x0F];
}

command! {
    LedControl -> ();
}

record! {
    /// Modem hard reset (0x0F,0x22).
    ///
    /// Clears the flash memory of the modem.
    ///
    /// For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - It wears out the flash memory; use it rarely.
    /// - Accepted in calibration mode only.
    ///
    /// Source: mip-sdk-4: Modem hard reset (0x0F,0x22).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ModemHardReset;
}

constructors! {
    ModemHardReset

    /// Creates the command from its parameters.
    fn new();
}

field! {
    ModemHardReset: 0x22, "rtk.modem_hard_reset";
    in [0x0F];
}

command! {
    ModemHardReset -> ();
}

record! {
    /// Get status flags response (0x0F,0x81).
    ///
    /// No device is known for certain to support it. Response to [`GetStatusFlags`]. Known only
    /// from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get status flags (0x0F,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetStatusFlagsResponse {
        /// State of the modem and of the corrections.
        pub flags: types::RtkStatusFlags,
    }
}

view! {
    GetStatusFlagsResponse
    flags: types::RtkStatusFlags, at 0;
}

constructors! {
    GetStatusFlagsResponse

    /// Creates it from its values.
    fn new(flags: types::RtkStatusFlags);
}

field! {
    GetStatusFlagsResponse: 0x81, "rtk.get_status_flags_response";
    in [0x0F];
    answers GetStatusFlags;
}

record! {
    /// Get IMEI response (0x0F,0x82).
    ///
    /// Response to [`GetImei`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get IMEI (0x0F,0x02).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetImeiResponse {
        /// International mobile equipment identity.
        pub imei: crate::Text<32>,
    }
}

view! {
    GetImeiResponse
    imei: crate::Text<32>, at 0;
}

constructors! {
    GetImeiResponse

    /// Creates it from its values.
    fn new(imei: crate::Text<32>);
}

field! {
    GetImeiResponse: 0x82, "rtk.get_imei_response";
    in [0x0F];
    answers GetImei;
}

record! {
    /// Get IMSI response (0x0F,0x83).
    ///
    /// Response to [`GetImsi`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get IMSI (0x0F,0x03).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetImsiResponse {
        /// International mobile subscriber identity.
        pub imsi: crate::Text<32>,
    }
}

view! {
    GetImsiResponse
    imsi: crate::Text<32>, at 0;
}

constructors! {
    GetImsiResponse

    /// Creates it from its values.
    fn new(imsi: crate::Text<32>);
}

field! {
    GetImsiResponse: 0x83, "rtk.get_imsi_response";
    in [0x0F];
    answers GetImsi;
}

record! {
    /// Get ICCID response (0x0F,0x84).
    ///
    /// Response to [`GetIccid`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get ICCID (0x0F,0x04).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetIccidResponse {
        /// Number of the SIM card.
        pub iccid: crate::Text<32>,
    }
}

view! {
    GetIccidResponse
    iccid: crate::Text<32>, at 0;
}

constructors! {
    GetIccidResponse

    /// Creates it from its values.
    fn new(iccid: crate::Text<32>);
}

field! {
    GetIccidResponse: 0x84, "rtk.get_iccid_response";
    in [0x0F];
    answers GetIccid;
}

record! {
    /// Get RSSI response (0x0F,0x85).
    ///
    /// Response to [`GetRssi`]. Known only from the MicroStrain MIP SDK. Uncertain: That `valid`
    /// applies to the other values is inferred.
    ///
    /// Source: mip-sdk-4: Get RSSI (0x0F,0x05).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetRssiResponse {
        /// True if the modem is connected.
        pub valid: crate::Bool,
        /// Received signal strength.
        ///
        /// Valid if [`valid`](GetRssiResponse::valid) is true. Uncertain: No source states the
        /// unit; dBm is likely.
        pub rssi: i32,
        /// Quality of the modem's radio signal.
        ///
        /// Valid if [`valid`](GetRssiResponse::valid) is true. Uncertain: No source states the
        /// unit.
        pub signal_quality: i32,
    }
}

view! {
    GetRssiResponse
    valid: crate::Bool, at 0;
    rssi: i32, at 1;
    signal_quality: i32, at 5;
}

constructors! {
    GetRssiResponse

    /// Creates it from its values.
    fn new(
        valid: bool,
        rssi: i32,
        signal_quality: i32,
    );
}

valid! {
    GetRssiResponse
    rssi_is_valid "rssi": valid 0x0;
    signal_quality_is_valid "signal_quality": valid 0x0;
}

field! {
    GetRssiResponse: 0x85, "rtk.get_rssi_response";
    in [0x0F];
    answers GetRssi;
}

record! {
    /// Connected device type response (0x0F,0x86).
    ///
    /// Response to [`ConnectedDeviceType`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Connected device type (0x0F,0x06).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ConnectedDeviceTypeResponse {
        /// Type of device that the modem is connected to.
        pub device_type: ConnectedDevice,
    }
}

view! {
    ConnectedDeviceTypeResponse
    device_type: ConnectedDevice, at 0;
}

constructors! {
    ConnectedDeviceTypeResponse

    /// Creates it from its values.
    fn new(device_type: ConnectedDevice);
}

field! {
    ConnectedDeviceTypeResponse: 0x86, "rtk.connected_device_type_response";
    in [0x0F];
    answers ConnectedDeviceType;
}

record! {
    /// Get activation code response (0x0F,0x87).
    ///
    /// No device is known for certain to support it. Also called `get_act_code_response`. Response
    /// to [`GetActivationCode`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get Act Code (0x0F,0x07).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetActivationCodeResponse {
        /// Code that activates the modem for its service.
        pub activation_code: crate::Text<32>,
    }
}

view! {
    GetActivationCodeResponse
    activation_code: crate::Text<32>, at 0;
}

constructors! {
    GetActivationCodeResponse

    /// Creates it from its values.
    fn new(activation_code: crate::Text<32>);
}

field! {
    GetActivationCodeResponse: 0x87, "rtk.get_activation_code_response";
    in [0x0F];
    answers GetActivationCode;
}

record! {
    /// Get modem firmware version response (0x0F,0x88).
    ///
    /// Response to [`GetModemFirmwareVersion`]. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Get modem firmware version (0x0F,0x08).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetModemFirmwareVersionResponse {
        /// Firmware version of the modem, not of the dongle.
        pub modem_firmware_version: crate::Text<32>,
    }
}

view! {
    GetModemFirmwareVersionResponse
    modem_firmware_version: crate::Text<32>, at 0;
}

constructors! {
    GetModemFirmwareVersionResponse

    /// Creates it from its values.
    fn new(modem_firmware_version: crate::Text<32>);
}

field! {
    GetModemFirmwareVersionResponse: 0x88, "rtk.get_modem_firmware_version_response";
    in [0x0F];
    answers GetModemFirmwareVersion;
}

record! {
    /// Service status response (0x0F,0x8A).
    ///
    /// Connection status according to the server.
    ///
    /// Response to [`ServiceStatus`]. Known only from the MicroStrain MIP SDK. Uncertain: No source
    /// states what the counters count.
    ///
    /// Source: mip-sdk-4: Service status (0x0F,0x0A).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ServiceStatusResponse {
        /// State of the service.
        pub flags: ServiceFlags,
        /// Number of correction bytes that the service has sent.
        ///
        /// Unit: byte.
        pub received_bytes: u32,
        /// Number of bytes in the last transfer.
        ///
        /// Unit: byte.
        pub last_bytes: u32,
        /// Time of the last transfer.
        ///
        /// Uncertain: No source states the unit and the epoch.
        pub last_bytes_time: u64,
    }
}

view! {
    ServiceStatusResponse
    flags: ServiceFlags, at 0;
    received_bytes: u32, at 1;
    last_bytes: u32, at 5;
    last_bytes_time: u64, at 9;
}

constructors! {
    ServiceStatusResponse

    /// Creates it from its values.
    fn new(
        flags: ServiceFlags,
        received_bytes: u32,
        last_bytes: u32,
        last_bytes_time: u64,
    );
}

field! {
    ServiceStatusResponse: 0x8A, "rtk.service_status_response";
    in [0x0F];
    answers ServiceStatus;
}
