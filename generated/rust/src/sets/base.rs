//! Base (0x01): Commands common to all devices: identity, supported descriptors, idle and resume,
//! self test, reset.
//!
//! Source: 3dm-gx5-15: 4.1 Base Commands; 3dm-cv7-gnss-ins: Base (0x01).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x01);

record! {
    /// Identity of a device. The strings are padded with spaces.
    ///
    /// Source: 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03); 3dm-cv7-gnss-ins: Get device
    /// information (0x01,0x03).
    #[derive(Default, Eq, Hash)]
    pub struct BaseDeviceInfo {
        /// Firmware version as one decimal number: 1202 means 1.2.02.
        pub firmware_version: u16,
        /// Product name, such as 3DM-GQ7.
        pub model_name: crate::Text<16>,
        /// Part number of the model.
        pub model_number: crate::Text<16>,
        /// Serial number, which begins with the model number.
        pub serial_number: crate::Text<16>,
        /// Lot number; reserved and blank on some devices.
        pub lot_number: crate::Text<16>,
        /// Options of the unit, such as its sensor ranges.
        pub device_options: crate::Text<16>,
    }
}

item! { BaseDeviceInfo { firmware_version model_name model_number serial_number lot_number device_options } }
view! {
    BaseDeviceInfo
    firmware_version: u16, at 0;
    model_name: crate::Text<16>, at 2;
    model_number: crate::Text<16>, at 18;
    serial_number: crate::Text<16>, at 34;
    lot_number: crate::Text<16>, at 50;
    device_options: crate::Text<16>, at 66;
}

constructors! {
    BaseDeviceInfo

    /// Creates it from its values.
    fn new(
        firmware_version: u16,
        model_name: crate::Text<16>,
        model_number: crate::Text<16>,
        serial_number: crate::Text<16>,
        lot_number: crate::Text<16>,
        device_options: crate::Text<16>,
    );
}

open_enum! {
    /// The part of the GPS time that a value contains.
    GpsTimeField: u8 {
        /// Week number.
        WEEK_NUMBER = 1, "week_number";
        /// Time of week in whole seconds.
        TOW = 2, "tow";
    }
}

record! {
    /// Ping (0x01,0x01).
    ///
    /// Checks whether a device is present and replies to commands.
    ///
    /// Supported by all devices; confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-CX5-10](crate::devices::CX5_10), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// - A device that is not in a normal operating mode may reject the command.
    ///
    /// Source: 3dm-gx5-15: 4.1.1 Ping (0x01, 0x01); 3dm-cv7-gnss-ins: Ping (0x01,0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Ping;
}

constructors! {
    Ping

    /// Creates the command from its parameters.
    fn new();
}

field! {
    Ping: 0x01, "base.ping";
    in [0x01];
}

command! {
    Ping -> ();
}

record! {
    /// Set to idle (0x01,0x02).
    ///
    /// Stops all data streams, and wakes a sleeping device, so that it can be configured.
    ///
    /// Supported by all devices; confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-CX5-10](crate::devices::CX5_10), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// - [`Resume`] restores the previous mode.
    /// - While idle, the device does not send NMEA sentences either.
    ///
    /// Source: 3dm-gx5-15: 4.1.2 Set To Idle (0x01, 0x02); 3dm-cv7-gnss-ins: Set to idle
    /// (0x01,0x02).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SetIdle;
}

constructors! {
    SetIdle

    /// Creates the command from its parameters.
    fn new();
}

field! {
    SetIdle: 0x02, "base.set_idle";
    in [0x01];
}

command! {
    SetIdle -> ();
}

record! {
    /// Get device information (0x01,0x03).
    ///
    /// Gets the firmware version and the identity strings of the device.
    ///
    /// Response: [`GetDeviceInfoResponse`]. Supported by all devices; confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// Source: 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03); 3dm-cv7-gnss-ins: Get device
    /// information (0x01,0x03).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetDeviceInfo;
}

constructors! {
    GetDeviceInfo

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetDeviceInfo: 0x03, "base.get_device_info";
    in [0x01];
}

command! {
    GetDeviceInfo -> GetDeviceInfoResponse;
    responds GetDeviceInfoResponse;
}

record! {
    /// Get device descriptors (0x01,0x04).
    ///
    /// Gets the command and data descriptors that the device supports.
    ///
    /// Response: [`GetDeviceDescriptorsResponse`]. Supported by all devices; confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// - If the list contains the descriptor of [`GetExtendedDescriptors`], that command returns
    ///   further descriptors.
    ///
    /// Source: 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04); 3dm-cv7-gnss-ins: Get
    /// device descriptors (0x01,0x04).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetDeviceDescriptors;
}

constructors! {
    GetDeviceDescriptors

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetDeviceDescriptors: 0x04, "base.get_device_descriptors";
    in [0x01];
}

command! {
    GetDeviceDescriptors -> GetDeviceDescriptorsResponse;
    responds GetDeviceDescriptorsResponse;
}

record! {
    /// Built-in test (0x01,0x05).
    ///
    /// Runs the self test of the device and gets its result.
    ///
    /// Response: [`BuiltInTestResponse`]. The device may take 10 s to reply. Confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 27 more. Uncertain: The maximum duration of 10 s is assumed; the manual
    /// of the 3DM-CV7 states several seconds.
    ///
    /// - The test interrupts normal operation for up to several seconds; no data is available
    ///   meanwhile.
    /// - The device must be at rest; acceleration, rotation or vibration cause false failures.
    /// - The continuous built-in test, if the device has it, describes a failure in more detail.
    ///
    /// Source: 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05); 3dm-cv7-gnss-ins: Built in test
    /// (0x01,0x05); 3dm-cv7-gnss-ins: Commanded Built-in Test.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct BuiltInTest;
}

constructors! {
    BuiltInTest

    /// Creates the command from its parameters.
    fn new();
}

field! {
    BuiltInTest: 0x05, "base.built_in_test";
    in [0x01];
}

command! {
    BuiltInTest -> BuiltInTestResponse;
    responds BuiltInTestResponse;
    timeout 10000;
}

record! {
    /// Resume (0x01,0x06).
    ///
    /// Ends idle mode and returns the device to the mode that it was in before.
    ///
    /// Supported by all devices; confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-CX5-10](crate::devices::CX5_10), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// - If the device was not idle, it enters its default mode (3DM-GX5-15).
    ///
    /// Source: 3dm-gx5-15: 4.1.6 Resume (0x01, 0x06); 3dm-cv7-gnss-ins: Resume (0x01,0x06).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Resume;
}

constructors! {
    Resume

    /// Creates the command from its parameters.
    fn new();
}

field! {
    Resume: 0x06, "base.resume";
    in [0x01];
}

command! {
    Resume -> ();
}

record! {
    /// Get device descriptors (extended) (0x01,0x07).
    ///
    /// Gets the supported descriptors that did not fit into the reply of [`GetDeviceDescriptors`].
    ///
    /// Response: [`GetExtendedDescriptorsResponse`]. Confirmed on
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35) and [3DM-GX5-45](crate::devices::GX5_45); likely or
    /// assumed on 12 more.
    ///
    /// - Some devices lack this command; [`GetDeviceDescriptors`] lists it if the device has it.
    ///
    /// Source: 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07);
    /// 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetExtendedDescriptors;
}

constructors! {
    GetExtendedDescriptors

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetExtendedDescriptors: 0x07, "base.get_extended_descriptors";
    in [0x01];
}

command! {
    GetExtendedDescriptors -> GetExtendedDescriptorsResponse;
    responds GetExtendedDescriptorsResponse;
}

record! {
    /// Continuous built-in test (0x01,0x08).
    ///
    /// Gets the flags of the tests that run all the time. It does not interrupt operation.
    ///
    /// Also called `continuous_bit`. Response: [`ContinuousBuiltInTestResponse`]. Confirmed on
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 9 more.
    ///
    /// - It is less thorough than [`BuiltInTest`].
    /// - Each flag stays set until this command reports it; the streamed field has its own copy of
    ///   the flags.
    /// - The self-test flags change only when [`BuiltInTest`] runs.
    ///
    /// Source: 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ContinuousBuiltInTest;
}

constructors! {
    ContinuousBuiltInTest

    /// Creates the command from its parameters.
    fn new();
}

field! {
    ContinuousBuiltInTest: 0x08, "base.continuous_built_in_test";
    in [0x01];
}

command! {
    ContinuousBuiltInTest -> ContinuousBuiltInTestResponse;
    responds ContinuousBuiltInTestResponse;
}

record! {
    /// Comm port speed (0x01,0x09).
    ///
    /// Sets the baud rate of one communication port.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`CommSpeedResponse`]. Devices
    /// without it may have [`mip_3dm::UartBaudRate`](crate::mip_3dm::UartBaudRate). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 8 more.
    ///
    /// - The change takes effect once pending data is sent and received, after at most 250 ms.
    /// - Send it alone in a packet while the device is idle, and wait 250 ms before you continue.
    /// - Commands and data during the change may be lost, or sent at either rate.
    ///
    /// Source: 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09).
    #[derive(Copy, Eq, Hash)]
    pub struct CommSpeed {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Port id of the device; 0 means all ports, and is for save, load and default only.
        ///
        /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS), [3DM-CX7-AR](crate::devices::CX7_AR),
        /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS) and [3DM-GV7-AR](crate::devices::GV7_AR):
        /// values of [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
        /// [`types::CommInterface::UART_1`] and [`types::CommInterface::USB_1`]. On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`types::CommInterface`]. On
        /// the [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-CX7-INS](crate::devices::CX7_INS):
        /// values of [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
        /// [`types::CommInterface::UART_1`], [`types::CommInterface::UART_2`],
        /// [`types::CommInterface::UART_3`] and [`types::CommInterface::USB_1`]. On the
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7): 1 is the main port, 2 the auxiliary one. On the
        /// [3DM-GV7-INS](crate::devices::GV7_INS): values of [`types::CommInterface`]; only
        /// [`types::CommInterface::MAIN`], [`types::CommInterface::UART_1`],
        /// [`types::CommInterface::UART_2`] and [`types::CommInterface::USB_1`]. On the
        /// [3DM-RTK](crate::devices::RTK): the values are unknown.
        pub port: Option<u8>,
        /// New baud rate; the port must support it.
        ///
        /// Unit: Bd. Required for [write](types::FunctionSelector::WRITE).
        pub baud: Option<u32>,
    }
    wire 6 {
        [function selects]
        [port for WRITE READ SAVE LOAD DEFAULT]
        [baud for WRITE]
    }
}

constructors! {
    CommSpeed

    /// Apply the new setting.
    fn write(port: u8, baud: u32) -> WriteCall;

    /// Return the current setting in a response.
    fn read(port: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(port: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(port: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(port: u8) -> LoadDefaultCall;
}

#[rustfmt::skip]
impl CommSpeed {
    /// Reads `port` as [`types::CommInterface`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS), [3DM-CX7-AR](crate::devices::CX7_AR),
    /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS) and [3DM-GV7-AR](crate::devices::GV7_AR): values of
    /// [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
    /// [`types::CommInterface::UART_1`] and [`types::CommInterface::USB_1`]. On the
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`types::CommInterface`]. On the
    /// [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-CX7-INS](crate::devices::CX7_INS): values of
    /// [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
    /// [`types::CommInterface::UART_1`], [`types::CommInterface::UART_2`],
    /// [`types::CommInterface::UART_3`] and [`types::CommInterface::USB_1`]. On the
    /// [3DM-GV7-INS](crate::devices::GV7_INS): values of [`types::CommInterface`]; only
    /// [`types::CommInterface::MAIN`], [`types::CommInterface::UART_1`],
    /// [`types::CommInterface::UART_2`] and [`types::CommInterface::USB_1`].
    #[inline]
    #[must_use]
    pub fn port_as_comm_interface(&self) -> Option<types::CommInterface> {
        self.port.map(Into::into)
    }
}

field! {
    CommSpeed: 0x09, "base.comm_speed";
    in [0x01];
}

command! {
    CommSpeed -> Option<CommSpeedResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> CommSpeedResponse;
    responds CommSpeedResponse for READ;
}

change! {
    CommSpeedResponse -> WriteCall CommSpeed
    [port baud]
}

record! {
    /// GPS time update (0x01,0x72).
    ///
    /// Sets the week number or the time of week of the external (GPS) time.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ)
    /// and [apply](types::FunctionSelector::APPLY). Response: [`GpsTimeUpdateWeekNumberResponse`]
    /// or [`GpsTimeUpdateTowResponse`]. Affects
    /// [`filter_data::Timestamp`](crate::filter_data::Timestamp),
    /// [`sensor::GpsTimestamp`](crate::sensor::GpsTimestamp),
    /// [`shared::GpsTimestamp`](crate::shared::GpsTimestamp) and
    /// [`shared::ExternalTimestamp`](crate::shared::ExternalTimestamp). Confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 16 more. On the
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): [write](types::FunctionSelector::WRITE)
    /// only.
    ///
    /// - Send it once for the time of week and once for the week number after the PPS is locked.
    /// - On the 3DM-CV7-GNSS/INS, the time may have a different epoch from GPS time, for example
    ///   the Unix epoch; [`shared::ExternalTimestamp`](crate::shared::ExternalTimestamp) then has
    ///   the same epoch.
    /// - The PPS supplies the fraction of the second; send the whole second that began at its last
    ///   edge.
    /// - Send it within 250 ms after the rising edge of the PPS.
    /// - Once per second is recommended for the 3DM-GX5-15; the 3DM-CV7-GNSS/INS needs it at least
    ///   once.
    /// - Send it again after a PPS glitch. It is usually not needed if an internal GNSS receiver is
    ///   the PPS source.
    ///
    /// Source: 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72); 3dm-cv7-gnss-ins: GPS Time Update
    /// Command (0x01,0x72); 3dm-cv7-gnss-ins: Timestamps.
    #[derive(Copy, Eq, Hash)]
    pub struct GpsTimeUpdate {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Meaning of the value.
        pub field_id: Option<GpsTimeField>,
        /// Week or seconds, as selected by `field_id`.
        ///
        /// Required for [write](types::FunctionSelector::WRITE) and
        /// [apply](types::FunctionSelector::APPLY). If [`field_id`](GpsTimeUpdate::field_id) is
        /// [`GpsTimeField::WEEK_NUMBER`]: unit week. GPS week number since 6 January 1980. If
        /// [`field_id`](GpsTimeUpdate::field_id) is [`GpsTimeField::TOW`]: unit s. Whole seconds of
        /// the GPS week.
        pub value: Option<u32>,
    }
    wire 6 {
        [function selects]
        [field_id for WRITE READ APPLY]
        [value for WRITE APPLY]
    }
}

constructors! {
    GpsTimeUpdate

    /// Apply the new setting.
    fn write(field_id: GpsTimeField, value: u32) -> WriteCall;

    /// Return the current setting in a response.
    fn read(field_id: GpsTimeField) -> ReadCall;

    /// Apply the new setting without sending an ACK (5-series devices).
    fn apply(field_id: GpsTimeField, value: u32) -> ApplyCall;
}

field! {
    GpsTimeUpdate: 0x72, "base.gps_time_update";
    in [0x01];
}

command! {
    GpsTimeUpdate -> Option<GpsTimeUpdateResponses>;
    for WRITE APPLY -> ();
    for READ -> GpsTimeUpdateResponses;
    responds GpsTimeUpdateWeekNumberResponse for READ, if field_id = Some(GpsTimeField::WEEK_NUMBER);
    responds GpsTimeUpdateTowResponse for READ, if field_id = Some(GpsTimeField::TOW);
    silent for APPLY;
}

responses! {
    /// The response to [`GpsTimeUpdate`].
    #[derive(Copy, Eq, Hash)]
    pub enum GpsTimeUpdateResponses {
        /// The response [`GpsTimeUpdateWeekNumberResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "gps_time_update_week_number_response"))]
        WeekNumber(GpsTimeUpdateWeekNumberResponse),
        /// The response [`GpsTimeUpdateTowResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "gps_time_update_tow_response"))]
        Tow(GpsTimeUpdateTowResponse),
    }
}

record! {
    /// Reset device (0x01,0x7E).
    ///
    /// Acknowledges the command, then resets the device immediately.
    ///
    /// Confirmed on [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 18 more.
    ///
    /// Source: 3dm-gx5-15: 4.1.9 Device Reset (0x01, 0x7E); 3dm-cv7-gnss-ins: Reset device
    /// (0x01,0x7E).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SoftReset;
}

constructors! {
    SoftReset

    /// Creates the command from its parameters.
    fn new();
}

field! {
    SoftReset: 0x7E, "base.soft_reset";
    in [0x01];
}

command! {
    SoftReset -> ();
}

record! {
    /// Get device information response (0x01,0x81).
    ///
    /// Response to [`GetDeviceInfo`]. Supported by all devices; confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// Source: 3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03); 3dm-cv7-gnss-ins: Get device
    /// information (0x01,0x03).
    #[derive(Default, Eq, Hash)]
    pub struct GetDeviceInfoResponse {
        /// Identity of the device.
        pub device_info: BaseDeviceInfo,
    }
}

view! {
    GetDeviceInfoResponse
    device_info as BaseDeviceInfo, at 0;
}

constructors! {
    GetDeviceInfoResponse

    /// Creates it from its values.
    fn new(device_info: BaseDeviceInfo);
}

field! {
    GetDeviceInfoResponse: 0x81, "base.get_device_info_response";
    in [0x01];
    answers GetDeviceInfo;
}

record! {
    /// Get device descriptors response (0x01,0x82).
    ///
    /// Response to [`GetDeviceDescriptors`]. Supported by all devices; confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    ///
    /// Source: 3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04); 3dm-cv7-gnss-ins: Get
    /// device descriptors (0x01,0x04).
    #[derive(Default, Eq, Hash)]
    pub struct GetDeviceDescriptorsResponse {
        /// Supported descriptors: the descriptor set in the high byte, the field descriptor in the
        /// low byte.
        pub descriptors: crate::List<u16, 126>,
    }
}

constructors! {
    GetDeviceDescriptorsResponse

    /// Creates it from its values.
    fn new(descriptors: impl Into<crate::List<u16, 126>>);
}

field! {
    GetDeviceDescriptorsResponse: 0x82, "base.get_device_descriptors_response";
    in [0x01];
    answers GetDeviceDescriptors;
}

record! {
    /// Built-in test response (0x01,0x83).
    ///
    /// Response to [`BuiltInTest`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-CX5-10](crate::devices::CX5_10), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 27 more.
    ///
    /// Source: 3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05); 3dm-cv7-gnss-ins: Built in test
    /// (0x01,0x05); 3dm-cv7-gnss-ins: Commanded Built-in Test.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct BuiltInTestResponse {
        /// Failure flags, defined by each device. Zero means that every test passed.
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25) and
        /// [3DM-GX5-25](crate::devices::GX5_25): values of [`types::Gx5BuiltInTest`] (inferred: the
        /// 3DM-GX5-15 has it). On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
        /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-INS](crate::devices::CV7_INS),
        /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS), [3DM-CX7-AR](crate::devices::CX7_AR),
        /// [3DM-CX7-INS](crate::devices::CX7_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
        /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS), [3DM-GV7-AR](crate::devices::GV7_AR),
        /// [3DM-GV7-INS](crate::devices::GV7_INS) and [3DM-RTK](crate::devices::RTK): values of
        /// [`types::Cv7BuiltInTest`] (inferred: the 3DM-CV7-GNSS/INS has it). On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`types::Cv7BuiltInTest`].
        /// On the [3DM-CX5-45](crate::devices::CX5_45), [3DM-GQ4-45](crate::devices::GQ4_45),
        /// [3DM-GX3-15](crate::devices::GX3_15), [3DM-GX3-25](crate::devices::GX3_25),
        /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
        /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST)
        /// and [3DM-RQ1-IMU](crate::devices::RQ1_IMU): the values are unknown. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): values of [`types::Gx5BuiltInTest`].
        pub result: u32,
    }
}

view! {
    BuiltInTestResponse
    result: u32, at 0;
}

constructors! {
    BuiltInTestResponse

    /// Creates it from its values.
    fn new(result: u32);
}

#[rustfmt::skip]
impl BuiltInTestResponse {
    /// Reads `result` as [`types::Gx5BuiltInTest`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25) and
    /// [3DM-GX5-25](crate::devices::GX5_25): values of [`types::Gx5BuiltInTest`] (inferred: the
    /// 3DM-GX5-15 has it). On the [3DM-GX5-15](crate::devices::GX5_15): values of
    /// [`types::Gx5BuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_gx5_built_in_test(&self) -> types::Gx5BuiltInTest {
        self.result.into()
    }

    /// Reads `result` as [`types::Cv7BuiltInTest`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
    /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GV7-AHRS](crate::devices::GV7_AHRS),
    /// [3DM-GV7-AR](crate::devices::GV7_AR), [3DM-GV7-INS](crate::devices::GV7_INS) and
    /// [3DM-RTK](crate::devices::RTK): values of [`types::Cv7BuiltInTest`] (inferred: the
    /// 3DM-CV7-GNSS/INS has it). On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of
    /// [`types::Cv7BuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_cv7_built_in_test(&self) -> types::Cv7BuiltInTest {
        self.result.into()
    }
}

field! {
    BuiltInTestResponse: 0x83, "base.built_in_test_response";
    in [0x01];
    answers BuiltInTest;
}

record! {
    /// GPS time update, week number (0x01,0x84).
    ///
    /// The current week number.
    ///
    /// Response to [`GpsTimeUpdate`]. Sent if [`field_id`](GpsTimeUpdate::field_id) is
    /// [`GpsTimeField::WEEK_NUMBER`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 16 more.
    ///
    /// Source: 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72); 3dm-cv7-gnss-ins: GPS Time Update
    /// Command (0x01,0x72); 3dm-cv7-gnss-ins: Timestamps.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpsTimeUpdateWeekNumberResponse {
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u32,
    }
}

view! {
    GpsTimeUpdateWeekNumberResponse
    week_number: u32, at 0;
}

constructors! {
    GpsTimeUpdateWeekNumberResponse

    /// Creates it from its values.
    fn new(week_number: u32);
}

field! {
    GpsTimeUpdateWeekNumberResponse: 0x84, "base.gps_time_update_week_number_response";
    in [0x01];
    answers GpsTimeUpdate;
}

record! {
    /// GPS time update, time of week (0x01,0x85).
    ///
    /// The current time of week.
    ///
    /// Response to [`GpsTimeUpdate`]. Sent if [`field_id`](GpsTimeUpdate::field_id) is
    /// [`GpsTimeField::TOW`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 16 more.
    ///
    /// Source: 3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72); 3dm-cv7-gnss-ins: GPS Time Update
    /// Command (0x01,0x72); 3dm-cv7-gnss-ins: Timestamps.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpsTimeUpdateTowResponse {
        /// GPS time of week in whole seconds.
        ///
        /// Unit: s.
        pub tow: u32,
    }
}

view! {
    GpsTimeUpdateTowResponse
    tow: u32, at 0;
}

constructors! {
    GpsTimeUpdateTowResponse

    /// Creates it from its values.
    fn new(tow: u32);
}

field! {
    GpsTimeUpdateTowResponse: 0x85, "base.gps_time_update_tow_response";
    in [0x01];
    answers GpsTimeUpdate;
}

record! {
    /// Get device descriptors (extended) response (0x01,0x86).
    ///
    /// Response to [`GetExtendedDescriptors`]. Confirmed on [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 12 more.
    ///
    /// Source: 3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07);
    /// 3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07).
    #[derive(Default, Eq, Hash)]
    pub struct GetExtendedDescriptorsResponse {
        /// Supported descriptors: the descriptor set in the high byte, the field descriptor in the
        /// low byte.
        pub descriptors: crate::List<u16, 126>,
    }
}

constructors! {
    GetExtendedDescriptorsResponse

    /// Creates it from its values.
    fn new(descriptors: impl Into<crate::List<u16, 126>>);
}

field! {
    GetExtendedDescriptorsResponse: 0x86, "base.get_extended_descriptors_response";
    in [0x01];
    answers GetExtendedDescriptors;
}

record! {
    /// Continuous built-in test response (0x01,0x88).
    ///
    /// Also called `continuous_bit_response`. Response to [`ContinuousBuiltInTest`]. Confirmed on
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 9 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ContinuousBuiltInTestResponse {
        /// Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the
        /// second byte.
        ///
        /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
        /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
        /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS), [3DM-GV7-AR](crate::devices::GV7_AR) and
        /// [3DM-GV7-INS](crate::devices::GV7_INS): values of
        /// [`types::Cv7InertialContinuousBuiltInTest`]. On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of
        /// [`types::Cv7ContinuousBuiltInTest`]. On the [3DM-GQ7-GNSS/INS](crate::devices::GQ7):
        /// values of [`types::Gq7ContinuousBuiltInTest`] (inferred: the sources are about
        /// [`system_data::BuiltInTest`](crate::system_data::BuiltInTest), whose flags are the same
        /// on the 3DM-CV7-GNSS/INS).
        pub result: [u8; 16],
    }
}

view! {
    ContinuousBuiltInTestResponse
    result: [u8; 16], at 0;
}

constructors! {
    ContinuousBuiltInTestResponse

    /// Creates it from its values.
    fn new(result: [u8; 16]);
}

#[rustfmt::skip]
impl ContinuousBuiltInTestResponse {
    /// Reads `result` as [`types::Cv7InertialContinuousBuiltInTest`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
    /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
    /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS), [3DM-GV7-AR](crate::devices::GV7_AR) and
    /// [3DM-GV7-INS](crate::devices::GV7_INS): values of
    /// [`types::Cv7InertialContinuousBuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_cv7_inertial_continuous_built_in_test(&self) -> types::Cv7InertialContinuousBuiltInTest {
        self.result.into()
    }

    /// Reads `result` as [`types::Cv7ContinuousBuiltInTest`].
    ///
    /// On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of
    /// [`types::Cv7ContinuousBuiltInTest`].
    #[inline]
    #[must_use]
    pub fn result_as_cv7_continuous_built_in_test(&self) -> types::Cv7ContinuousBuiltInTest {
        self.result.into()
    }

    /// Reads `result` as [`types::Gq7ContinuousBuiltInTest`].
    ///
    /// On the [3DM-GQ7-GNSS/INS](crate::devices::GQ7): values of
    /// [`types::Gq7ContinuousBuiltInTest`] (inferred: the sources are about
    /// [`system_data::BuiltInTest`](crate::system_data::BuiltInTest), whose flags are the same on
    /// the 3DM-CV7-GNSS/INS).
    #[inline]
    #[must_use]
    pub fn result_as_gq7_continuous_built_in_test(&self) -> types::Gq7ContinuousBuiltInTest {
        self.result.into()
    }
}

field! {
    ContinuousBuiltInTestResponse: 0x88, "base.continuous_built_in_test_response";
    in [0x01];
    answers ContinuousBuiltInTest;
}

record! {
    /// Comm port speed response (0x01,0x89).
    ///
    /// Response to [`CommSpeed`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct CommSpeedResponse {
        /// Port id of the device.
        ///
        /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS), [3DM-CX7-AR](crate::devices::CX7_AR),
        /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS) and [3DM-GV7-AR](crate::devices::GV7_AR):
        /// values of [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
        /// [`types::CommInterface::UART_1`] and [`types::CommInterface::USB_1`]. On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`types::CommInterface`]. On
        /// the [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-CX7-INS](crate::devices::CX7_INS):
        /// values of [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
        /// [`types::CommInterface::UART_1`], [`types::CommInterface::UART_2`],
        /// [`types::CommInterface::UART_3`] and [`types::CommInterface::USB_1`]. On the
        /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7): 1 is the main port, 2 the auxiliary one. On the
        /// [3DM-GV7-INS](crate::devices::GV7_INS): values of [`types::CommInterface`]; only
        /// [`types::CommInterface::MAIN`], [`types::CommInterface::UART_1`],
        /// [`types::CommInterface::UART_2`] and [`types::CommInterface::USB_1`]. On the
        /// [3DM-RTK](crate::devices::RTK): the values are unknown.
        pub port: u8,
        /// Baud rate of the port.
        ///
        /// Unit: Bd.
        pub baud: u32,
    }
}

view! {
    CommSpeedResponse
    port: u8, at 0;
    baud: u32, at 1;
}

constructors! {
    CommSpeedResponse

    /// Creates it from its values.
    fn new(port: u8, baud: u32);
}

#[rustfmt::skip]
impl CommSpeedResponse {
    /// Reads `port` as [`types::CommInterface`].
    ///
    /// On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CX7-AHRS](crate::devices::CX7_AHRS), [3DM-CX7-AR](crate::devices::CX7_AR),
    /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS) and [3DM-GV7-AR](crate::devices::GV7_AR): values of
    /// [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
    /// [`types::CommInterface::UART_1`] and [`types::CommInterface::USB_1`]. On the
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): values of [`types::CommInterface`]. On the
    /// [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-CX7-INS](crate::devices::CX7_INS): values of
    /// [`types::CommInterface`]; only [`types::CommInterface::MAIN`],
    /// [`types::CommInterface::UART_1`], [`types::CommInterface::UART_2`],
    /// [`types::CommInterface::UART_3`] and [`types::CommInterface::USB_1`]. On the
    /// [3DM-GV7-INS](crate::devices::GV7_INS): values of [`types::CommInterface`]; only
    /// [`types::CommInterface::MAIN`], [`types::CommInterface::UART_1`],
    /// [`types::CommInterface::UART_2`] and [`types::CommInterface::USB_1`].
    #[inline]
    #[must_use]
    pub fn port_as_comm_interface(&self) -> types::CommInterface {
        self.port.into()
    }
}

field! {
    CommSpeedResponse: 0x89, "base.comm_speed_response";
    in [0x01];
    answers CommSpeed;
}
