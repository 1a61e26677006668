//! 3DM (0x0C): Commands that set up the sensors, the outputs, the pins and the events of a device.
//!
//! Source: 3dm-gx5-15: 4.2 3DM Commands; 3dm-cv7-gnss-ins: 3DM (0x0C).

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x0C);

record! {
    /// A field requested by a poll.
    ///
    /// Source: 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct PollEntry {
        /// Field descriptor.
        pub descriptor: u8,
        /// Reserved; occupies the position of a decimation.
        ///
        /// Reserved: send 0.
        pub reserved: u16,
    }
}

item! { PollEntry { descriptor reserved } }
view! {
    PollEntry
    descriptor: u8, at 0;
    reserved: u16, at 1;
}

constructors! {
    PollEntry

    /// Creates it from its values.
    fn new(descriptor: u8), reserved: 0;
}

open_enum! {
    /// Treatment of the existing message formats.
    ///
    /// Source: 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10).
    FactoryStreamingAction: u8 {
        /// The formats are replaced.
        OVERWRITE = 0, "overwrite";
        /// The support fields are merged into the formats; the order may change.
        MERGE = 1, "merge";
        /// The support fields are appended to the formats; fields may occur twice.
        ADD = 2, "add";
    }
}

open_enum! {
    /// Constellation in receiver settings. The values differ from those of
    /// [`types::GnssConstellation`], which GNSS data uses.
    ///
    /// Source: mip-sdk-4: Constellation Settings (0x0C,0x21).
    ConstellationId: u8 {
        /// GPS, satellites G1 to G32.
        GPS = 0, "gps";
        /// SBAS, satellites S120 to S158.
        SBAS = 1, "sbas";
        /// Galileo, satellites E1 to E36.
        GALILEO = 2, "galileo";
        /// BeiDou, satellites B1 to B37.
        BEIDOU = 3, "beidou";
        /// QZSS, satellites Q1 to Q5.
        QZSS = 5, "qzss";
        /// GLONASS, satellites R1 to R32.
        GLONASS = 6, "glonass";
    }
}

bitfield! {
    /// Options of a constellation.
    ///
    /// Source: mip-sdk-4: Constellation Settings (0x0C,0x21).
    ConstellationOptions: u16 {
        /// The L1-SAIF signal; QZSS only. Bit 0.
        L1SAIF: bool = 0,
            l1saif, set_l1saif, with_l1saif;
    }
}

record! {
    /// Settings for the tracking of one constellation.
    ///
    /// Source: mip-sdk-4: Constellation Settings (0x0C,0x21).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ConstellationSettingsEntry {
        /// Constellation that this entry configures.
        pub constellation_id: ConstellationId,
        /// 1 enables the constellation, 0 disables it.
        ///
        /// Range: 0 to 1.
        pub enable: u8,
        /// Number of channels reserved for the constellation.
        ///
        /// Unit: 1. Range: 0 to 32.
        pub reserved_channels: u8,
        /// Maximum number of channels for the constellation.
        ///
        /// Unit: 1. Range: 0 to 32.
        pub max_channels: u8,
        /// Options of this constellation.
        pub option_flags: ConstellationOptions,
    }
}

item! { ConstellationSettingsEntry { constellation_id enable reserved_channels max_channels option_flags } }
view! {
    ConstellationSettingsEntry
    constellation_id: ConstellationId, at 0;
    enable: u8, at 1;
    reserved_channels: u8, at 2;
    max_channels: u8, at 3;
    option_flags: ConstellationOptions, at 4;
}

ranges! {
    ConstellationSettingsEntry
    enable "enable" in "0 to 1" From 0.0 To 1.0;
    reserved_channels "reserved_channels" in "0 to 32" From 0.0 To 32.0;
    max_channels "max_channels" in "0 to 32" From 0.0 To 32.0;
}

constructors! {
    ConstellationSettingsEntry

    /// Creates it from its values.
    fn new(
        constellation_id: ConstellationId,
        enable: u8,
        reserved_channels: u8,
        max_channels: u8,
        option_flags: ConstellationOptions,
    );
}

bitfield! {
    /// Purposes for which SBAS is used.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22).
    SbasOptions: u16 {
        /// SBAS pseudoranges are used in the position solution. Bit 0.
        ENABLE_RANGING: bool = 0,
            enable_ranging, set_enable_ranging, with_enable_ranging;
        /// SBAS differential corrections are applied. Bit 1.
        ENABLE_CORRECTIONS: bool = 1,
            enable_corrections, set_enable_corrections, with_enable_corrections;
        /// Only GPS satellites with SBAS integrity information are used. Bit 2.
        APPLY_INTEGRITY: bool = 2,
            apply_integrity, set_apply_integrity, with_apply_integrity;
    }
}

open_enum! {
    /// Use of a receiver's last fix at power-up.
    ///
    /// Source: mip-sdk-4: Gnss Assisted Fix (0x0C,0x23).
    AssistedFixOption: u8 {
        /// The receiver ignores its last fix.
        NONE = 0, "none";
        /// The receiver starts from its last fix.
        ENABLED = 1, "enabled";
    }
}

open_enum! {
    /// Source of the pulse per second.
    ///
    /// Source: 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28); 3dm-cv7-gnss-ins: RECEIVER Source.
    PpsSource: u8 {
        /// No pulse.
        DISABLED = 0, "disabled";
        /// From GNSS receiver 1. The external time is GPS time, and valid only while the receiver
        /// has a fix. Requires a receiver.
        RECEIVER_1 = 1, "receiver_1";
        /// From GNSS receiver 2. The external time is GPS time, and valid only while the receiver
        /// has a fix. Requires 2 receivers.
        RECEIVER_2 = 2, "receiver_2";
        /// From a GPIO pin that is configured as a PPS input.
        GPIO = 3, "gpio";
        /// From the oscillator of the device.
        GENERATED = 4, "generated";
    }
}

open_enum! {
    /// The part of the event system that is queried.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A).
    EventSupportQuery: u8 {
        /// Supported types of triggers.
        TRIGGER_TYPES = 1, "trigger_types";
        /// Supported types of actions.
        ACTION_TYPES = 2, "action_types";
    }
}

record! {
    /// Capacity of a device for one trigger or action type.
    ///
    /// Source: 3dm-cv7-gnss-ins: Info.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventSupportInfo {
        /// Trigger type or action type.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: u8,
        /// Maximum number of instances of this type.
        ///
        /// Unit: 1.
        pub count: u8,
    }
    wire 2 {
        [type_ "type"]
        [count]
    }
}

item! { EventSupportInfo { type_ count } }
view! {
    EventSupportInfo
    type_: u8, at 0;
    count: u8, at 1;
}

constructors! {
    EventSupportInfo

    /// Creates it from its values.
    fn new(type_: u8, count: u8);
}

tuple! { EventSupportInfo type_: u8, count: u8 }

record! {
    /// Type and state of one trigger.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventTriggerStatusEntry {
        /// Configured type.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: types::EventTriggerType,
        /// State.
        pub status: types::EventTriggerStatus,
    }
    wire 2 {
        [type_ "type"]
        [status]
    }
}

item! { EventTriggerStatusEntry { type_ status } }
view! {
    EventTriggerStatusEntry
    type_: types::EventTriggerType, at 0;
    status: types::EventTriggerStatus, at 1;
}

constructors! {
    EventTriggerStatusEntry

    /// Creates it from its values.
    fn new(type_: types::EventTriggerType, status: types::EventTriggerStatus);
}

tuple! { EventTriggerStatusEntry type_: types::EventTriggerType, status: types::EventTriggerStatus }

record! {
    /// Type and trigger of one action.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventActionStatusEntry {
        /// Configured type.
        pub action_type: types::EventActionType,
        /// Trigger instance that the action follows.
        pub trigger_id: u8,
    }
}

item! { EventActionStatusEntry { action_type trigger_id } }
view! {
    EventActionStatusEntry
    action_type: types::EventActionType, at 0;
    trigger_id: u8, at 1;
}

constructors! {
    EventActionStatusEntry

    /// Creates it from its values.
    fn new(action_type: types::EventActionType, trigger_id: u8);
}

tuple! { EventActionStatusEntry action_type: types::EventActionType, trigger_id: u8 }

open_enum! {
    /// Motion that a GNSS receiver assumes.
    ///
    /// Uncertain: The SDK of 2014 numbers the modes 0 to 8, but the list in its comments lacks
    /// `fixed`, which u-blox receivers do not have either. Uncertain: The sources list only names;
    /// the descriptions of the modes are inferred from them.
    ///
    /// Source: mip-sdk-2014: GPS Dynamics Mode (0x0C,0x34).
    ReceiverDynamics: u8 {
        /// Low accelerations; fits most applications.
        PORTABLE = 0, "portable";
        /// Fixed installation.
        FIXED = 1, "fixed";
        /// At rest.
        STATIONARY = 2, "stationary";
        /// Walking speed.
        PEDESTRIAN = 3, "pedestrian";
        /// Road vehicles.
        AUTOMOTIVE = 4, "automotive";
        /// Vessels at sea level.
        SEA = 5, "sea";
        /// Aircraft with accelerations below 1 g.
        AIRBORNE_1G = 6, "airborne_1g";
        /// Aircraft with accelerations below 2 g.
        AIRBORNE_2G = 7, "airborne_2g";
        /// Aircraft with accelerations below 4 g.
        AIRBORNE_4G = 8, "airborne_4g";
    }
}

bitfield! {
    /// Processing steps of 3-series devices.
    ///
    /// Uncertain: Bits 4, 5, 9 and 12 are from the single-byte protocol of the 3DM-GX3. MSCL has
    /// the quaternion as 0x10000, which exceeds 16 bits. Uncertain: The sources list only names;
    /// the descriptions of the bits are inferred from them.
    ///
    /// Source: mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35); mscl: IMU Signal Conditioning
    /// (0x0C,0x35).
    DataConditioningFlags: u16 {
        /// Computes the orientation. Bit 0.
        ORIENTATION_CALCULATION: bool = 0,
            orientation_calculation, set_orientation_calculation, with_orientation_calculation;
        /// Corrects coning and sculling. Bit 1.
        CONING_SCULLING: bool = 1,
            coning_sculling, set_coning_sculling, with_coning_sculling;
        /// Sends floats with the least significant byte first. Bit 4.
        LITTLE_ENDIAN_FLOATS: bool = 4,
            little_endian_floats, set_little_endian_floats, with_little_endian_floats;
        /// Suppresses values that are NaN (not a number). Bit 5.
        NAN_SUPPRESSED: bool = 5,
            nan_suppressed, set_nan_suppressed, with_nan_suppressed;
        /// Compensates for the distance between the accelerometers. Bit 6.
        FINITE_SIZE_CORRECTION: bool = 6,
            finite_size_correction, set_finite_size_correction, with_finite_size_correction;
        /// Switches the magnetometer off. Bit 8.
        DISABLE_MAG: bool = 8,
            disable_mag, set_disable_mag, with_disable_mag;
        /// Reduces the power of the magnetometer. Bit 9.
        MAG_LOW_POWER: bool = 9,
            mag_low_power, set_mag_low_power, with_mag_low_power;
        /// Disables the heading correction. Bit 10.
        DISABLE_NORTH_COMPENSATION: bool = 10,
            disable_north_compensation, set_disable_north_compensation, with_disable_north_compensation;
        /// Disables the pitch and roll correction. Bit 11.
        DISABLE_UP_COMPENSATION: bool = 11,
            disable_up_compensation, set_disable_up_compensation, with_disable_up_compensation;
        /// Computes the quaternion. Bit 12.
        QUATERNION_CALCULATION: bool = 12,
            quaternion_calculation, set_quaternion_calculation, with_quaternion_calculation;
    }
}

open_enum! {
    /// Bandwidth of the magnetometer of 3-series devices.
    ///
    /// Source: mip-sdk-2014: IMU Signal Conditioning (0x0C,0x35).
    MagBandwidth: u8 {
        /// High bandwidth.
        HIGH = 0, "high";
        /// Low bandwidth.
        LOW = 1, "low";
    }
}

open_enum! {
    /// A time counter of the sensor data.
    ///
    /// Source: mip-sdk-2014: IMU Timestamp (0x0C,0x36).
    ImuTimestampSelector: u8 {
        /// Seconds of the time beacon.
        BEACON_SECONDS = 1, "beacon_seconds";
        /// Nanoseconds of the time beacon.
        BEACON_NANOSECONDS = 2, "beacon_nanoseconds";
        /// Ticks of the internal clock. Uncertain: The source states 2 both for this value and for
        /// the nanoseconds.
        INTERNAL_TICKS = 3, "internal_ticks";
    }
}

open_enum! {
    /// Operating mode of the odometer input.
    ///
    /// Source: 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43).
    OdometerMode: u8 {
        /// Not used.
        DISABLED = 0, "disabled";
        /// Quadrature encoder on two pins.
        QUADRATURE = 2, "quadrature";
    }
}

open_enum! {
    /// A sensor whose range can be set.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52).
    SensorRangeType: u8 {
        /// All sensors; for save, load and default only.
        ALL = 0, "all";
        /// Accel.
        ACCEL = 1, "accel";
        /// Gyro.
        GYRO = 2, "gyro";
        /// On models with a magnetometer. Requires a magnetometer.
        MAG = 3, "mag";
        /// The pressure sensor. Requires a pressure sensor.
        PRESSURE = 4, "pressure";
    }
}

record! {
    /// A range that a sensor supports.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53).
    #[derive(Copy, Default)]
    pub struct SensorRangeEntry {
        /// Value for [`SensorRange`].
        pub setting: u8,
        /// Largest measurable value.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub range: f32,
    }
}

item! { SensorRangeEntry { setting range } }
view! {
    SensorRangeEntry
    setting: u8, at 0;
    range: f32, at 1;
}

constructors! {
    SensorRangeEntry

    /// Creates it from its values.
    fn new(setting: u8, range: f32);
}

tuple! { SensorRangeEntry setting: u8, range: f32 }

open_enum! {
    /// A sensor inside a 3-series device.
    ///
    /// Source: mip-sdk-2014: Device Power State (0x0C,0x61).
    InternalSensor: u8 {
        /// The inertial sensor.
        IMU = 1, "imu";
        /// The GNSS receiver. Requires a receiver.
        GNSS = 2, "gnss";
    }
}

open_enum! {
    /// Format of a data stream.
    ///
    /// Source: mip-sdk-2014: Data Stream Format (0x0C,0x60).
    StreamFormat: u8 {
        /// MIP data fields.
        STANDARD = 1, "standard";
        /// The sensor's own packets, each in a MIP field.
        WRAPPED_RAW = 2, "wrapped_raw";
    }
}

open_enum! {
    /// Power state of an internal sensor.
    ///
    /// Source: mip-sdk-2014: Device Power State (0x0C,0x61).
    SensorPowerState: u8 {
        /// Full power.
        ON = 1, "on";
        /// On with reduced power.
        LOW_POWER = 2, "low_power";
        /// Very low power; starts quickly.
        SLEEP = 3, "sleep";
        /// Off or in deep sleep.
        OFF = 4, "off";
    }
}

open_enum! {
    /// Level of detail of a device status.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64).
    DeviceStatusSelector: u8 {
        /// State and timer.
        BASIC = 1, "basic";
        /// State, timer, and the counters of streams and port.
        DIAGNOSTIC = 2, "diagnostic";
    }
}

open_enum! {
    /// A data stream of a device of the generations 3 to 5.
    ///
    /// Source: 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11).
    LegacyDataStream: u8 {
        /// All streams; for save, load and default only.
        ALL_STREAMS = 0, "all_streams";
        /// Sensor data (0x80).
        IMU = 1, "imu";
        /// GNSS data. Requires a receiver.
        GNSS = 2, "gnss";
        /// Estimation filter data (0x82).
        FILTER = 3, "filter";
    }
}

open_enum! {
    /// State of the system in the device status of the 3DM-GX4-45 and the 3DM-RQ1-45.
    ///
    /// Source: mip-sdk-2014: Device Status (0x0C,0x64).
    Gx4SystemState: u16 {
        /// The system is starting.
        INIT = 1, "init";
        /// The sensors are starting.
        SENSOR_STARTUP = 2, "sensor_startup";
        /// The system is running.
        RUNNING = 3, "running";
    }
}

record! {
    /// Poll IMU data (0x0C,0x01).
    ///
    /// Requests one sensor data packet (0x80) with the listed fields, in the listed order.
    ///
    /// Also called `poll_imu_message`. Not acknowledged if
    /// [`suppress_ack`](PollImuData::suppress_ack) is true. Devices without it may have
    /// [`PollData`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 15 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](PollImuData::descriptors).
    ///
    /// - An empty list polls the fields that [`ImuMessageFormat`] stores; if nothing is stored, the
    ///   device rejects the command.
    /// - Descriptors that the device does not know are ignored.
    /// - The data is sent in a separate packet after the reply.
    ///
    /// Source: 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01).
    #[derive(Default, Eq, Hash)]
    pub struct PollImuData {
        /// Send no acknowledge.
        pub suppress_ack: crate::Bool,
        /// Fields to send.
        ///
        /// Refers to fields of Sensor data.
        pub descriptors: crate::List<PollEntry, 83>,
    }
    wire 251 {
        [suppress_ack]
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    PollImuData

    /// Creates the command from its parameters.
    fn new(suppress_ack: bool, descriptors: impl Into<crate::List<PollEntry, 83>>);
}

field! {
    PollImuData: 0x01, "3dm.poll_imu_data";
    in [0x0C];
}

command! {
    PollImuData -> ();
    silent if suppress_ack = crate::Bool(1);
}

record! {
    /// Poll GNSS data (0x0C,0x02).
    ///
    /// Requests one GNSS data packet with the listed fields, in the listed order.
    ///
    /// Also called `poll_gnss_message`. Not acknowledged if
    /// [`suppress_ack`](PollGnssData::suppress_ack) is true. Devices without it may have
    /// [`PollData`]. Confirmed on [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 5 more. Known only from the
    /// MicroStrain MIP SDK. Requires a receiver.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](PollGnssData::descriptors). Range: 0 to 83.
    ///
    /// - An empty list polls the format stored by [`GnssMessageFormat`]; if none is stored, the
    ///   device rejects the command.
    /// - Descriptors that the device does not know are omitted.
    /// - The data is sent in a separate packet after the reply.
    ///
    /// Source: mip-sdk-4: Poll Gnss Message (0x0C,0x02).
    #[derive(Default, Eq, Hash)]
    pub struct PollGnssData {
        /// Send no acknowledge.
        pub suppress_ack: crate::Bool,
        /// Fields to send.
        ///
        /// Refers to fields of GNSS data. Uncertain: The SDK has a decimation in place of the
        /// reserved number and does not document how a poll uses it.
        pub descriptors: crate::List<PollEntry, 83>,
    }
    wire 251 {
        [suppress_ack]
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    PollGnssData

    /// Creates the command from its parameters.
    fn new(suppress_ack: bool, descriptors: impl Into<crate::List<PollEntry, 83>>);
}

field! {
    PollGnssData: 0x02, "3dm.poll_gnss_data";
    in [0x0C];
}

command! {
    PollGnssData -> ();
    silent if suppress_ack = crate::Bool(1);
}

record! {
    /// Poll estimation filter data (0x0C,0x03).
    ///
    /// Requests one filter data packet (0x82) with the listed fields, in the listed order.
    ///
    /// Also called `poll_filter_message`. Not acknowledged if
    /// [`suppress_ack`](PollFilterData::suppress_ack) is true. Devices without it may have
    /// [`PollData`]. Confirmed on [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 8 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](PollFilterData::descriptors).
    ///
    /// - An empty list polls the fields that [`FilterMessageFormat`] stores; if none are, the
    ///   device rejects the command.
    /// - Descriptors that the device does not know are ignored.
    /// - The data is sent in a separate packet after the reply.
    ///
    /// Source: 3dm-gx5-15: 4.2.2 Poll Estimation Filter Data (0x0C, 0x03).
    #[derive(Default, Eq, Hash)]
    pub struct PollFilterData {
        /// Send no acknowledge.
        pub suppress_ack: crate::Bool,
        /// Fields to send.
        ///
        /// Refers to fields of Filter data.
        pub descriptors: crate::List<PollEntry, 83>,
    }
    wire 251 {
        [suppress_ack]
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    PollFilterData

    /// Creates the command from its parameters.
    fn new(suppress_ack: bool, descriptors: impl Into<crate::List<PollEntry, 83>>);
}

field! {
    PollFilterData: 0x03, "3dm.poll_filter_data";
    in [0x0C];
}

command! {
    PollFilterData -> ();
    silent if suppress_ack = crate::Bool(1);
}

record! {
    /// Poll NMEA data (0x0C,0x04).
    ///
    /// Requests the listed NMEA sentences once.
    ///
    /// Also called `nmea_poll_data`. Not acknowledged if
    /// [`suppress_ack`](PollNmeaData::suppress_ack) is true. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// The wire format also contains `count`: Number of sentences. Counts the elements of
    /// [`format_entries`](PollNmeaData::format_entries).
    ///
    /// - An empty list polls the stored NMEA format; if none is stored, the device rejects the
    ///   command.
    /// - The sentences follow the reply as ordinary NMEA text, on the port of the command, even if
    ///   NMEA is disabled there.
    /// - A sentence is sent only if its data is valid.
    ///
    /// Source: 3dm-cv7-gnss-ins: Poll NMEA Data (0x0C,0x04).
    #[derive(Default, Eq, Hash)]
    pub struct PollNmeaData {
        /// Send no acknowledge.
        pub suppress_ack: crate::Bool,
        /// Sentences to send.
        pub format_entries: crate::List<types::NmeaMessage, 50>,
    }
    wire 252 {
        [suppress_ack]
        [count: u8 counts format_entries]
        [format_entries by count]
    }
}

constructors! {
    PollNmeaData

    /// Creates the command from its parameters.
    fn new(suppress_ack: bool, format_entries: impl Into<crate::List<types::NmeaMessage, 50>>);
}

field! {
    PollNmeaData: 0x04, "3dm.poll_nmea_data";
    in [0x0C];
}

command! {
    PollNmeaData -> ();
    silent if suppress_ack = crate::Bool(1);
}

record! {
    /// Get IMU data base rate (0x0C,0x06).
    ///
    /// Gets the base rate, which is divided by the decimations of [`ImuMessageFormat`].
    ///
    /// Also called `imu_get_base_rate`. Response: [`GetImuBaseRateResponse`]. Devices without it
    /// may have [`GetBaseRate`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 15 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetImuBaseRate;
}

constructors! {
    GetImuBaseRate

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetImuBaseRate: 0x06, "3dm.get_imu_base_rate";
    in [0x0C];
}

command! {
    GetImuBaseRate -> GetImuBaseRateResponse;
    responds GetImuBaseRateResponse;
}

record! {
    /// Get GNSS data base rate (0x0C,0x07).
    ///
    /// Gets the base rate, which is divided by the decimations of [`GnssMessageFormat`].
    ///
    /// Also called `gnss_get_base_rate`. Response: [`GetGnssBaseRateResponse`]. Devices without it
    /// may have [`GetBaseRate`]. Confirmed on [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 4 more. Known only from the MicroStrain MIP SDK. Requires a receiver.
    ///
    /// Source: mip-sdk-4: Gnss Get Base Rate (0x0C,0x07).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetGnssBaseRate;
}

constructors! {
    GetGnssBaseRate

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetGnssBaseRate: 0x07, "3dm.get_gnss_base_rate";
    in [0x0C];
}

command! {
    GetGnssBaseRate -> GetGnssBaseRateResponse;
    responds GetGnssBaseRateResponse;
}

record! {
    /// IMU message format (0x0C,0x08).
    ///
    /// Sets the fields of the sensor data packets (0x80), their order and their decimations.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ImuMessageFormatResponse`]. Devices
    /// without it may have [`MessageFormat`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 14 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](ImuMessageFormat::descriptors). Required for
    /// [write](types::FunctionSelector::WRITE).
    ///
    /// - The decimation is the base rate, as [`GetImuBaseRate`] reports it, divided by the desired
    ///   rate.
    /// - The list replaces the previous one. If any descriptor is unknown, the device rejects the
    ///   command and changes nothing.
    ///
    /// Source: 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08).
    #[derive(Eq, Hash)]
    pub struct ImuMessageFormat {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Fields and decimations.
        ///
        /// Refers to fields of Sensor data. Required for [write](types::FunctionSelector::WRITE).
        pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
    }
    wire 251 {
        [function selects]
        [(descriptors) for WRITE {
            [num_descriptors: u8 counts descriptors]
            [descriptors by num_descriptors]
        }]
    }
}

ranges! {
    ImuMessageFormat
    [descriptors];
}

constructors! {
    ImuMessageFormat

    /// Apply the new setting.
    fn write(descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> WriteCall;

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
    ImuMessageFormat: 0x08, "3dm.imu_message_format";
    in [0x0C];
}

command! {
    ImuMessageFormat -> Option<ImuMessageFormatResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ImuMessageFormatResponse;
    responds ImuMessageFormatResponse for READ;
    checks Ranged;
}

record! {
    /// GNSS message format (0x0C,0x09).
    ///
    /// Sets the fields of the GNSS data packets, their order and their decimations.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GnssMessageFormatResponse`].
    /// Devices without it may have [`MessageFormat`]. Confirmed on
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 4 more. Requires a
    /// receiver.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](GnssMessageFormat::descriptors). Range: 0 to 82. Required for
    /// [write](types::FunctionSelector::WRITE).
    ///
    /// - The decimation is the base rate, as [`GetGnssBaseRate`] reports it, divided by the desired
    ///   rate.
    ///
    /// Source: mip-sdk-4: GNSS message format (0x0C,0x09); 3dm-gx5-35: 4.2.6 GNSS Message Format
    /// (0x0C, 0x09).
    #[derive(Eq, Hash)]
    pub struct GnssMessageFormat {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Fields and decimations.
        ///
        /// Refers to fields of GNSS data. Required for [write](types::FunctionSelector::WRITE).
        pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
    }
    wire 251 {
        [function selects]
        [(descriptors) for WRITE {
            [num_descriptors: u8 counts descriptors]
            [descriptors by num_descriptors]
        }]
    }
}

ranges! {
    GnssMessageFormat
    [descriptors];
}

constructors! {
    GnssMessageFormat

    /// Apply the new setting.
    fn write(descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> WriteCall;

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
    GnssMessageFormat: 0x09, "3dm.gnss_message_format";
    in [0x0C];
}

command! {
    GnssMessageFormat -> Option<GnssMessageFormatResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GnssMessageFormatResponse;
    responds GnssMessageFormatResponse for READ;
    checks Ranged;
}

record! {
    /// Estimation filter message format (0x0C,0x0A).
    ///
    /// Sets the fields of the filter data packets (0x82), their order and their decimations.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`FilterMessageFormatResponse`].
    /// Devices without it may have [`MessageFormat`]. Confirmed on
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 9 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](FilterMessageFormat::descriptors). Required for
    /// [write](types::FunctionSelector::WRITE).
    ///
    /// - The decimation is the base rate, as [`GetFilterBaseRate`] reports it, divided by the
    ///   desired rate.
    /// - The list replaces the previous one. If any descriptor is unknown, the device rejects the
    ///   command and changes nothing.
    ///
    /// Source: 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A).
    #[derive(Eq, Hash)]
    pub struct FilterMessageFormat {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Fields and decimations.
        ///
        /// Refers to fields of Filter data. Required for [write](types::FunctionSelector::WRITE).
        pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
    }
    wire 251 {
        [function selects]
        [(descriptors) for WRITE {
            [num_descriptors: u8 counts descriptors]
            [descriptors by num_descriptors]
        }]
    }
}

ranges! {
    FilterMessageFormat
    [descriptors];
}

constructors! {
    FilterMessageFormat

    /// Apply the new setting.
    fn write(descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> WriteCall;

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
    FilterMessageFormat: 0x0A, "3dm.filter_message_format";
    in [0x0C];
}

command! {
    FilterMessageFormat -> Option<FilterMessageFormatResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> FilterMessageFormatResponse;
    responds FilterMessageFormatResponse for READ;
    checks Ranged;
}

record! {
    /// Get estimation filter data base rate (0x0C,0x0B).
    ///
    /// Gets the base rate, which is divided by the decimations of [`FilterMessageFormat`].
    ///
    /// Also called `filter_get_base_rate`. Response: [`GetFilterBaseRateResponse`]. Devices without
    /// it may have [`GetBaseRate`]. Confirmed on [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 9 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetFilterBaseRate;
}

constructors! {
    GetFilterBaseRate

    /// Creates the command from its parameters.
    fn new();
}

field! {
    GetFilterBaseRate: 0x0B, "3dm.get_filter_base_rate";
    in [0x0C];
}

command! {
    GetFilterBaseRate -> GetFilterBaseRateResponse;
    responds GetFilterBaseRateResponse;
}

record! {
    /// NMEA message format (0x0C,0x0C).
    ///
    /// Sets the NMEA sentences that the device streams.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`NmeaMessageFormatResponse`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 4 more.
    ///
    /// The wire format also contains `count`: Number of sentences. Counts the elements of
    /// [`format_entries`](NmeaMessageFormat::format_entries). Required for
    /// [write](types::FunctionSelector::WRITE).
    ///
    /// - A sentence may be listed several times with different talkers or sources.
    /// - A sentence is sent only while the device is not idle and the data of the source is valid.
    /// - The 3DM-CV7-GNSS/INS rejects the format if a sentence would be sent more than 10 times per
    ///   second, or, from a GNSS set, more than twice.
    ///
    /// Source: 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C).
    #[derive(Eq, Hash)]
    pub struct NmeaMessageFormat {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Sentences to stream.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub format_entries: Option<crate::List<types::NmeaMessage, 50>>,
    }
    wire 252 {
        [function selects]
        [(format_entries) for WRITE {
            [count: u8 counts format_entries]
            [format_entries by count]
        }]
    }
}

constructors! {
    NmeaMessageFormat

    /// Apply the new setting.
    fn write(format_entries: impl Into<crate::List<types::NmeaMessage, 50>>) -> WriteCall;

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
    NmeaMessageFormat: 0x0C, "3dm.nmea_message_format";
    in [0x0C];
}

command! {
    NmeaMessageFormat -> Option<NmeaMessageFormatResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> NmeaMessageFormatResponse;
    responds NmeaMessageFormatResponse for READ;
}

change! {
    NmeaMessageFormatResponse -> WriteCall NmeaMessageFormat
    [format_entries]
}

record! {
    /// Poll data (0x0C,0x0D).
    ///
    /// Requests one data packet of the descriptor set with the listed fields, in the listed order.
    ///
    /// Not acknowledged if [`suppress_ack`](PollData::suppress_ack) is true. Devices without it may
    /// have [`PollImuData`], [`PollGnssData`] and [`PollFilterData`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](PollData::descriptors).
    ///
    /// - An empty list polls the fields that [`MessageFormat`] stores; if nothing is stored, the
    ///   device rejects the command.
    /// - Descriptors that the device does not know are ignored.
    /// - The data is sent in a separate packet after the reply, on the port of the command.
    /// - List shared descriptors (0xD0 and up) before the others.
    ///
    /// Source: 3dm-cv7-gnss-ins: Poll Data (0x0C,0x0D).
    #[derive(Default, Eq, Hash)]
    pub struct PollData {
        /// Data descriptor set.
        ///
        /// Range: 0x80 to 0xFE.
        pub descriptor_set: crate::DescriptorSet,
        /// Send no acknowledge.
        pub suppress_ack: crate::Bool,
        /// Field descriptors.
        ///
        /// Refers to fields of [`descriptor_set`](PollData::descriptor_set).
        pub descriptors: crate::List<u8, 250>,
    }
    wire 253 {
        [descriptor_set]
        [suppress_ack]
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

ranges! {
    PollData
    descriptor_set "descriptor_set" in "0x80 to 0xFE" From 128.0 To 254.0;
}

constructors! {
    PollData

    /// Creates the command from its parameters.
    fn new(
        descriptor_set: impl Into<crate::DescriptorSet>,
        suppress_ack: bool,
        descriptors: impl Into<crate::List<u8, 250>>,
    );
}

field! {
    PollData: 0x0D, "3dm.poll_data";
    in [0x0C];
}

command! {
    PollData -> ();
    silent if suppress_ack = crate::Bool(1);
    checks Ranged;
}

record! {
    /// Get data base rate (0x0C,0x0E).
    ///
    /// Gets the base rate, which is divided by the decimations of a descriptor set.
    ///
    /// Response: [`GetBaseRateResponse`]. Devices without it may have [`GetImuBaseRate`],
    /// [`GetGnssBaseRate`] and [`GetFilterBaseRate`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 7 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetBaseRate {
        /// Data descriptor set.
        ///
        /// Range: 0x80 to 0xFE.
        pub descriptor_set: crate::DescriptorSet,
    }
}

ranges! {
    GetBaseRate
    descriptor_set "descriptor_set" in "0x80 to 0xFE" From 128.0 To 254.0;
}

constructors! {
    GetBaseRate

    /// Creates the command from its parameters.
    fn new(descriptor_set: impl Into<crate::DescriptorSet>);
}

field! {
    GetBaseRate: 0x0E, "3dm.get_base_rate";
    in [0x0C];
}

command! {
    GetBaseRate -> GetBaseRateResponse;
    responds GetBaseRateResponse;
    checks Ranged;
}

record! {
    /// Message format (0x0C,0x0F).
    ///
    /// Sets the fields of the data packets of a descriptor set, their order and their decimations.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`MessageFormatResponse`]. Devices
    /// without it may have [`ImuMessageFormat`], [`GnssMessageFormat`] and [`FilterMessageFormat`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](MessageFormat::descriptors). Required for
    /// [write](types::FunctionSelector::WRITE).
    ///
    /// - The decimation is the base rate, as [`GetBaseRate`] reports it, divided by the desired
    ///   rate.
    /// - List shared descriptors (0xD0 and up) under the set whose packets will contain them,
    ///   before the others.
    ///
    /// Source: 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F).
    #[derive(Eq, Hash)]
    pub struct MessageFormat {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Data descriptor set; 0 means all of them (save, load, default).
        pub descriptor_set: Option<crate::DescriptorSet>,
        /// Fields and decimations.
        ///
        /// Refers to fields of [`descriptor_set`](MessageFormat::descriptor_set). Required for
        /// [write](types::FunctionSelector::WRITE).
        pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
    }
    wire 252 {
        [function selects]
        [descriptor_set for WRITE READ SAVE LOAD DEFAULT]
        [(descriptors) for WRITE {
            [num_descriptors: u8 counts descriptors]
            [descriptors by num_descriptors]
        }]
    }
}

ranges! {
    MessageFormat
    [descriptors];
}

constructors! {
    MessageFormat

    /// Apply the new setting.
    fn write(descriptor_set: impl Into<crate::DescriptorSet>, descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> WriteCall;

    /// Return the current setting in a response.
    fn read(descriptor_set: impl Into<crate::DescriptorSet>) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(descriptor_set: impl Into<crate::DescriptorSet>) -> SaveCall;

    /// Load the saved setting.
    fn load(descriptor_set: impl Into<crate::DescriptorSet>) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(descriptor_set: impl Into<crate::DescriptorSet>) -> LoadDefaultCall;
}

field! {
    MessageFormat: 0x0F, "3dm.message_format";
    in [0x0C];
}

command! {
    MessageFormat -> Option<MessageFormatResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> MessageFormatResponse;
    responds MessageFormatResponse for READ;
    checks Ranged;
}

change! {
    MessageFormatResponse -> WriteCall MessageFormat
    [descriptor_set descriptors]
}

record! {
    /// Factory streaming (0x0C,0x10).
    ///
    /// Sets all message formats to those that technical support needs in a recording.
    ///
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct FactoryStreaming {
        /// Treatment of the existing formats.
        pub action: FactoryStreamingAction,
        /// Reserved: send 0.
        pub reserved: u8,
    }
}

constructors! {
    FactoryStreaming

    /// Creates the command from its parameters.
    fn new(action: FactoryStreamingAction), reserved: 0;
}

field! {
    FactoryStreaming: 0x10, "3dm.factory_streaming";
    in [0x0C];
}

command! {
    FactoryStreaming -> ();
}

record! {
    /// Data stream control (0x0C,0x11).
    ///
    /// Switches a data stream on or off.
    ///
    /// Also called `datastream_control`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`DataStreamControlResponse`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 25 more.
    ///
    /// - Devices of the generations 3 to 5 identify the stream by a number ([`LegacyDataStream`]),
    ///   other devices by its descriptor set.
    /// - A newly enabled stream starts with current data, without any from before.
    ///
    /// Source: 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11);
    /// 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11).
    #[derive(Copy, Eq, Hash)]
    pub struct DataStreamControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Data descriptor set; 0 means all streams (save, load, default).
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-GX3-15](crate::devices::GX3_15), [3DM-GX3-25](crate::devices::GX3_25),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX5-25](crate::devices::GX5_25) and [3DM-MV5-AR](crate::devices::MV5_AR): values of
        /// [`LegacyDataStream`]; only [`LegacyDataStream::ALL_STREAMS`], [`LegacyDataStream::IMU`]
        /// and [`LegacyDataStream::FILTER`]. On the [3DM-CX5-45](crate::devices::CX5_45),
        /// [3DM-DH3](crate::devices::DH3), [3DM-GQ4-45](crate::devices::GQ4_45),
        /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
        /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST)
        /// and [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of [`LegacyDataStream`]. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): values of [`LegacyDataStream`]; only
        /// [`LegacyDataStream::IMU`] and [`LegacyDataStream::FILTER`].
        pub descriptor_set: Option<u8>,
        /// True if the stream is sent.
        ///
        /// Default: true. Required for [write](types::FunctionSelector::WRITE).
        ///
        /// - The stream starts with current data. What was measured while it was disabled is not
        ///   sent.
        pub enable: Option<crate::Bool>,
    }
    wire 3 {
        [function selects]
        [descriptor_set for WRITE READ SAVE LOAD DEFAULT]
        [enable for WRITE]
    }
}

constructors! {
    DataStreamControl

    /// Apply the new setting.
    fn write(descriptor_set: impl Into<u8>, enable: bool) -> WriteCall;

    /// Return the current setting in a response.
    fn read(descriptor_set: impl Into<u8>) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(descriptor_set: impl Into<u8>) -> SaveCall;

    /// Load the saved setting.
    fn load(descriptor_set: impl Into<u8>) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(descriptor_set: impl Into<u8>) -> LoadDefaultCall;
}

#[rustfmt::skip]
impl DataStreamControl {
    /// Reads `descriptor_set` as [`LegacyDataStream`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
    /// [3DM-GX3-15](crate::devices::GX3_15), [3DM-GX3-25](crate::devices::GX3_25),
    /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
    /// [3DM-GX5-25](crate::devices::GX5_25) and [3DM-MV5-AR](crate::devices::MV5_AR): values of
    /// [`LegacyDataStream`]; only [`LegacyDataStream::ALL_STREAMS`], [`LegacyDataStream::IMU`] and
    /// [`LegacyDataStream::FILTER`]. On the [3DM-CX5-45](crate::devices::CX5_45),
    /// [3DM-DH3](crate::devices::DH3), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
    /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and
    /// [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of [`LegacyDataStream`]. On the
    /// [3DM-GX5-15](crate::devices::GX5_15): values of [`LegacyDataStream`]; only
    /// [`LegacyDataStream::IMU`] and [`LegacyDataStream::FILTER`].
    #[inline]
    #[must_use]
    pub fn descriptor_set_as_legacy_data_stream(&self) -> Option<LegacyDataStream> {
        self.descriptor_set.map(Into::into)
    }
}

field! {
    DataStreamControl: 0x11, "3dm.data_stream_control";
    in [0x0C];
}

command! {
    DataStreamControl -> Option<DataStreamControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> DataStreamControlResponse;
    responds DataStreamControlResponse for READ;
}

record! {
    /// Raw RTCM 2.3 message (0x0C,0x20).
    ///
    /// Sends RTCM 2.3 corrections to the GNSS receiver.
    ///
    /// Supported by [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST).
    /// Requires a receiver.
    ///
    /// - The receiver uses the RTCM messages 1, 2, 3 and 9.
    /// - A message may be split at any byte and sent with several of these commands.
    ///
    /// Source: 3dm-gx5-45: 4.2.26 Raw RTCM 2.3 Message (0x0C, 0x20); mip-sdk-2014: Raw RTCM 2.3
    /// message (0x0C,0x20); mscl: Raw RTCM 2.3 message (0x0C,0x20).
    #[derive(Default, Eq, Hash)]
    pub struct RawRtcm2_3Message {
        /// Bytes of the RTCM stream.
        pub data: crate::List<u8, 253>,
    }
}

constructors! {
    RawRtcm2_3Message

    /// Creates the command from its parameters.
    fn new(data: impl Into<crate::List<u8, 253>>);
}

field! {
    RawRtcm2_3Message: 0x20, "3dm.raw_rtcm_2_3_message";
    in [0x0C];
}

command! {
    RawRtcm2_3Message -> ();
}

record! {
    /// Constellation settings (0x0C,0x21).
    ///
    /// Selects the constellations that the GNSS receiver tracks, and their shares of its tracking
    /// channels.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ConstellationSettingsResponse`].
    /// Probably affects [`gnss_data::FixInfo`](crate::gnss_data::FixInfo),
    /// [`gnss_data::SvInfo`](crate::gnss_data::SvInfo) and
    /// [`gnss_data::SatelliteStatus`](crate::gnss_data::SatelliteStatus). Confirmed on
    /// [3DM-GQ4-45](crate::devices::GQ4_45) and [3DM-GX5-35](crate::devices::GX5_35); likely or
    /// assumed on 2 more. Requires a receiver. Uncertain: The factory default is doubtful: the SDK
    /// names only GPS and GLONASS as enabled, but has channels for SBAS and QZSS too.
    ///
    /// The wire format also contains `config_count`: Number of entries. Counts the elements of
    /// [`settings`](ConstellationSettings::settings). Range: 0 to 41. Required for
    /// [write](types::FunctionSelector::WRITE).
    ///
    /// - The device rejects entries that reserve more than 32 channels in total. The maximum of an
    ///   entry must not be less than the number of channels it reserves.
    /// - GLONASS and BeiDou cannot be used together.
    /// - If the antenna or its filter is made for GPS only, leave GLONASS and BeiDou off.
    /// - SBAS and QZSS improve the accuracy of GPS. SBAS does not make the device suitable for
    ///   safety-of-life use.
    /// - Factory default: GPS and GLONASS are enabled. Reserved and maximum channels: GPS 8 and 16,
    ///   GLONASS 8 and 14, SBAS 1 and 3, QZSS 0 and 3.
    ///
    /// Source: mip-sdk-4: Constellation settings (0x0C,0x21); 3dm-gx5-35: 4.2.8 GNSS Constellation
    /// Settings (0x0C, 0x21).
    #[derive(Eq, Hash)]
    pub struct ConstellationSettings {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Maximum number of tracking channels in use; at most the number that the response reports
        /// as available.
        ///
        /// Unit: 1. Required for [write](types::FunctionSelector::WRITE).
        pub max_channels: Option<u16>,
        /// One entry for each constellation.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub settings: Option<crate::List<ConstellationSettingsEntry, 41>>,
    }
    wire 250 {
        [function selects]
        [max_channels for WRITE]
        [(settings) for WRITE {
            [config_count: u8 counts settings]
            [settings by config_count]
        }]
    }
}

ranges! {
    ConstellationSettings
    [settings];
}

constructors! {
    ConstellationSettings

    /// Apply the new setting.
    fn write(max_channels: u16, settings: impl Into<crate::List<ConstellationSettingsEntry, 41>>) -> WriteCall;

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
    ConstellationSettings: 0x21, "3dm.constellation_settings";
    in [0x0C];
}

command! {
    ConstellationSettings -> Option<ConstellationSettingsResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ConstellationSettingsResponse;
    responds ConstellationSettingsResponse for READ;
    checks Ranged;
}

record! {
    /// GNSS SBAS settings (0x0C,0x22).
    ///
    /// Sets how the GNSS receivers use satellite-based augmentation (SBAS).
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GnssSbasSettingsResponse`].
    /// Probably affects [`gnss_data::SbasInfo`](crate::gnss_data::SbasInfo) and
    /// [`gnss_data::SbasCorrection`](crate::gnss_data::SbasCorrection). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 3 more. Requires a receiver.
    ///
    /// The wire format also contains `num_included_prns`: Number of satellites listed; 0 searches
    /// for all. Counts the elements of [`included_prns`](GnssSbasSettings::included_prns). Required
    /// for [write](types::FunctionSelector::WRITE).
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22).
    #[derive(Eq, Hash)]
    pub struct GnssSbasSettings {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// 1 enables SBAS, 0 disables it.
        ///
        /// Range: 0 to 1. Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-35](crate::devices::GX5_35): default 1.
        pub enable_sbas: Option<u8>,
        /// Purposes of SBAS.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-35](crate::devices::GX5_35): default
        /// [`enable_ranging`](SbasOptions::enable_ranging) and
        /// [`enable_corrections`](SbasOptions::enable_corrections).
        pub sbas_options: Option<SbasOptions>,
        /// PRN numbers of the SBAS satellites to search for.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub included_prns: Option<crate::List<u16, 124>>,
    }
    wire 253 {
        [function selects]
        [enable_sbas for WRITE]
        [sbas_options for WRITE]
        [(included_prns) for WRITE {
            [num_included_prns: u8 counts included_prns]
            [included_prns by num_included_prns]
        }]
    }
}

ranges! {
    GnssSbasSettings
    enable_sbas "enable_sbas" in "0 to 1" From 0.0 To 1.0;
}

constructors! {
    GnssSbasSettings

    /// Apply the new setting.
    fn write(
        enable_sbas: u8,
        sbas_options: SbasOptions,
        included_prns: impl Into<crate::List<u16, 124>>,
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
    GnssSbasSettings: 0x22, "3dm.gnss_sbas_settings";
    in [0x0C];
}

command! {
    GnssSbasSettings -> Option<GnssSbasSettingsResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GnssSbasSettingsResponse;
    responds GnssSbasSettingsResponse for READ;
    checks Ranged;
}

change! {
    GnssSbasSettingsResponse -> WriteCall GnssSbasSettings
    [enable_sbas sbas_options included_prns]
}

record! {
    /// GNSS assisted fix (0x0C,0x23).
    ///
    /// Sets whether the GNSS receiver keeps the data of its last fix and starts from it at the next
    /// power-up.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GnssAssistedFixResponse`].
    /// Confirmed on [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 2 more. Known only
    /// from the MicroStrain MIP SDK. Requires a receiver.
    ///
    /// - The last fix is kept in the flash memory and the FRAM of the receiver.
    /// - If you send the time with [`GnssTimeAssistance`] right after power-up, the first fix takes
    ///   1 s at best.
    /// - A change from enabled to none erases the flash memory of the receiver, which is rated for
    ///   100 000 erasures.
    /// - It slightly increases the power consumption.
    ///
    /// Source: mip-sdk-4: GNSS assisted fix (0x0C,0x23).
    #[derive(Copy, Eq, Hash)]
    pub struct GnssAssistedFix {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Storage of data for a faster first fix.
        ///
        /// Default: [`AssistedFixOption::NONE`]. Required for
        /// [write](types::FunctionSelector::WRITE). On the [3DM-GX5-35](crate::devices::GX5_35):
        /// default [`AssistedFixOption::NONE`].
        pub option: Option<AssistedFixOption>,
        /// Reserved: send 255. Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-35](crate::devices::GX5_35): default 255.
        pub flags: Option<u8>,
    }
    wire 3 {
        [function selects]
        [option for WRITE]
        [flags for WRITE]
    }
}

constructors! {
    GnssAssistedFix

    /// Apply the new setting.
    fn write(option: AssistedFixOption) -> WriteCall, flags: 255;

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
    GnssAssistedFix: 0x23, "3dm.gnss_assisted_fix";
    in [0x0C];
}

command! {
    GnssAssistedFix -> Option<GnssAssistedFixResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GnssAssistedFixResponse;
    responds GnssAssistedFixResponse for READ;
}

change! {
    GnssAssistedFixResponse -> WriteCall GnssAssistedFix
    [option] flags: 255,
}

record! {
    /// GNSS time assistance (0x0C,0x24).
    ///
    /// Sends the current GPS time to the GNSS receiver.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE) and
    /// [read](types::FunctionSelector::READ). Response: [`GnssTimeAssistanceResponse`]. Confirmed
    /// on [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 2 more. Known only from the
    /// MicroStrain MIP SDK. Requires a receiver.
    ///
    /// - It is needed right after power-up if [`GnssAssistedFix`] was on at power-off.
    ///
    /// Source: mip-sdk-4: GNSS time assistance (0x0C,0x24).
    #[derive(Copy)]
    pub struct GnssTimeAssistance {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub tow: Option<f64>,
        /// GPS week number since 1980.
        ///
        /// Unit: week. Required for [write](types::FunctionSelector::WRITE).
        pub week_number: Option<u16>,
        /// Estimated accuracy of the time that is sent.
        ///
        /// Unit: s. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub accuracy: Option<f32>,
    }
    wire 15 {
        [function selects]
        [tow for WRITE]
        [week_number for WRITE]
        [accuracy for WRITE]
    }
}

ranges! {
    GnssTimeAssistance
    tow "tow" in "at least 0, less than 604800" From 0.0 Below 604800.0;
    accuracy "accuracy" in "at least 0" From 0.0;
}

constructors! {
    GnssTimeAssistance

    /// Apply the new setting.
    fn write(
        tow: f64,
        week_number: u16,
        accuracy: f32,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;
}

field! {
    GnssTimeAssistance: 0x24, "3dm.gnss_time_assistance";
    in [0x0C];
}

command! {
    GnssTimeAssistance -> Option<GnssTimeAssistanceResponse>;
    for WRITE -> ();
    for READ -> GnssTimeAssistanceResponse;
    responds GnssTimeAssistanceResponse for READ;
    checks Ranged;
}

change! {
    GnssTimeAssistanceResponse -> WriteCall GnssTimeAssistance
    [tow week_number accuracy]
}

record! {
    /// PPS source control (0x0C,0x28).
    ///
    /// Selects the source of the pulse per second (PPS).
    ///
    /// Also called `pps_source`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`PpsSourceControlResponse`]. Affects
    /// [`system_data::TimeSyncStatus`](crate::system_data::TimeSyncStatus). Probably affects
    /// [`shared::GpsTimestamp`](crate::shared::GpsTimestamp),
    /// [`shared::ExternalTimestamp`](crate::shared::ExternalTimestamp) and
    /// [`sensor::GpsTimestamp`](crate::sensor::GpsTimestamp). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// - The pins are configured separately, by [`GpioConfig`].
    /// - The filter needs a valid pulse; `disabled` and `generated` are rarely useful.
    ///
    /// Source: 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28).
    #[derive(Copy, Eq, Hash)]
    pub struct PpsSourceControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Source of the pulse.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
        /// [3DM-CV7-INS](crate::devices::CV7_INS), [3DM-CX7-AHRS](crate::devices::CX7_AHRS),
        /// [3DM-CX7-AR](crate::devices::CX7_AR), [3DM-CX7-INS](crate::devices::CX7_INS),
        /// [3DM-GV7-AHRS](crate::devices::GV7_AHRS), [3DM-GV7-AR](crate::devices::GV7_AR) and
        /// [3DM-GV7-INS](crate::devices::GV7_INS): only [`PpsSource::DISABLED`],
        /// [`PpsSource::GPIO`] and [`PpsSource::GENERATED`]. On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): default [`PpsSource::RECEIVER_1`]. On
        /// the [3DM-GQ7-GNSS/INS](crate::devices::GQ7): only [`PpsSource::DISABLED`],
        /// [`PpsSource::RECEIVER_1`], [`PpsSource::RECEIVER_2`], [`PpsSource::GPIO`] and
        /// [`PpsSource::GENERATED`].
        pub source: Option<PpsSource>,
    }
    wire 2 {
        [function selects]
        [source for WRITE]
    }
}

constructors! {
    PpsSourceControl

    /// Apply the new setting.
    fn write(source: PpsSource) -> WriteCall;

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
    PpsSourceControl: 0x28, "3dm.pps_source_control";
    in [0x0C];
}

command! {
    PpsSourceControl -> Option<PpsSourceControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> PpsSourceControlResponse;
    responds PpsSourceControlResponse for READ;
}

change! {
    PpsSourceControlResponse -> WriteCall PpsSourceControl
    [source]
}

record! {
    /// Get supported events (0x0C,0x2A).
    ///
    /// Gets the types of event triggers or actions that the device supports, and the number of
    /// each.
    ///
    /// Response: [`GetEventSupportResponse`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetEventSupport {
        /// Triggers or actions.
        pub query: EventSupportQuery,
    }
}

constructors! {
    GetEventSupport

    /// Creates the command from its parameters.
    fn new(query: EventSupportQuery);
}

field! {
    GetEventSupport: 0x2A, "3dm.get_event_support";
    in [0x0C];
}

command! {
    GetEventSupport -> GetEventSupportResponse;
    responds GetEventSupportResponse;
}

record! {
    /// Event control (0x0C,0x2B).
    ///
    /// Enables, disables or tests an event trigger.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`EventControlResponse`]. Confirmed
    /// on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// - Triggers are disabled by default and after configuration.
    /// - A trigger of type none cannot be enabled.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B).
    #[derive(Copy, Eq, Hash)]
    pub struct EventControl {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Trigger instance; 0 means all configured triggers, except for read.
        pub instance: Option<u8>,
        /// New mode.
        ///
        /// Default: [`types::EventTriggerMode::DISABLED`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub mode: Option<types::EventTriggerMode>,
    }
    wire 3 {
        [function selects]
        [instance for WRITE READ SAVE LOAD DEFAULT]
        [mode for WRITE]
    }
}

constructors! {
    EventControl

    /// Apply the new setting.
    fn write(instance: u8, mode: types::EventTriggerMode) -> WriteCall;

    /// Return the current setting in a response.
    fn read(instance: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(instance: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(instance: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(instance: u8) -> LoadDefaultCall;
}

field! {
    EventControl: 0x2B, "3dm.event_control";
    in [0x0C];
}

command! {
    EventControl -> Option<EventControlResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> EventControlResponse;
    responds EventControlResponse for READ;
}

change! {
    EventControlResponse -> WriteCall EventControl
    [instance mode]
}

record! {
    /// Get event trigger status (0x0C,0x2C).
    ///
    /// Gets the type and the state of event triggers.
    ///
    /// Response: [`GetEventTriggerStatusResponse`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `requested_count`: Number of requested triggers; 0 requests
    /// all instances. Counts the elements of
    /// [`requested_instances`](GetEventTriggerStatus::requested_instances).
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C).
    #[derive(Default, Eq, Hash)]
    pub struct GetEventTriggerStatus {
        /// Numbers of the triggers to report; none for all.
        pub requested_instances: crate::List<u8, 252>,
    }
    wire 253 {
        [requested_count: u8 counts requested_instances]
        [requested_instances by requested_count]
    }
}

constructors! {
    GetEventTriggerStatus

    /// Creates the command from its parameters.
    fn new(requested_instances: impl Into<crate::List<u8, 252>>);
}

field! {
    GetEventTriggerStatus: 0x2C, "3dm.get_event_trigger_status";
    in [0x0C];
}

command! {
    GetEventTriggerStatus -> GetEventTriggerStatusResponse;
    responds GetEventTriggerStatusResponse;
}

record! {
    /// Get event action status (0x0C,0x2D).
    ///
    /// Gets the type and the trigger of event actions.
    ///
    /// Response: [`GetEventActionStatusResponse`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `requested_count`: Number of requested actions; 0 requests all
    /// instances. Counts the elements of
    /// [`requested_instances`](GetEventActionStatus::requested_instances).
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D).
    #[derive(Default, Eq, Hash)]
    pub struct GetEventActionStatus {
        /// Numbers of the actions to report; none for all.
        pub requested_instances: crate::List<u8, 252>,
    }
    wire 253 {
        [requested_count: u8 counts requested_instances]
        [requested_instances by requested_count]
    }
}

constructors! {
    GetEventActionStatus

    /// Creates the command from its parameters.
    fn new(requested_instances: impl Into<crate::List<u8, 252>>);
}

field! {
    GetEventActionStatus: 0x2D, "3dm.get_event_action_status";
    in [0x0C];
}

command! {
    GetEventActionStatus -> GetEventActionStatusResponse;
    responds GetEventActionStatusResponse;
}

record! {
    /// Event trigger configuration (0x0C,0x2E).
    ///
    /// Configures the kind and the condition of an event trigger.
    ///
    /// Also called `event_trigger`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`EventTriggerConfigResponse`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// - The trigger is disabled afterwards; [`EventControl`] enables it.
    /// - A GPIO trigger needs its pin configured by [`GpioConfig`].
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E).
    #[derive(Copy)]
    pub struct EventTriggerConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Trigger instance; 0 means all (save, load, default).
        pub instance: Option<u8>,
        /// Kind of trigger.
        ///
        /// Default: [`types::EventTriggerType::NONE`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: Option<types::EventTriggerType>,
        /// The condition.
        ///
        /// Selected by [`type_`](EventTriggerConfig::type_). Required for
        /// [write](types::FunctionSelector::WRITE).
        pub parameters: Option<EventTriggerConfigParameters>,
    }
    wire 23 {
        [function selects]
        [instance for WRITE READ SAVE LOAD DEFAULT]
        [type_ "type" for WRITE]
        [parameters as type_ for WRITE]
    }
}

union! {
    /// The alternatives of `parameters` in [`EventTriggerConfig`].
    #[derive(Copy)]
    pub enum EventTriggerConfigParameters: types::EventTriggerType {
        /// The instance is not in use: it is never active and cannot be enabled.
        ///
        /// Empty if [`type_`](EventTriggerConfig::type_) is [`types::EventTriggerType::NONE`].
        #[cfg_attr(feature = "serde", serde(rename = "none"))]
        NONE => None,
        /// Watches a GPIO pin.
        ///
        /// If [`type_`](EventTriggerConfig::type_) is [`types::EventTriggerType::GPIO`].
        #[cfg_attr(feature = "serde", serde(rename = "gpio"))]
        GPIO => Gpio(types::EventTriggerGpio) "gpio",
        /// Compares one value of a data field with thresholds.
        ///
        /// If [`type_`](EventTriggerConfig::type_) is [`types::EventTriggerType::THRESHOLD`].
        #[cfg_attr(feature = "serde", serde(rename = "threshold"))]
        THRESHOLD => Threshold(types::EventTriggerThreshold) "threshold",
        /// Combines up to four other triggers in a truth table.
        ///
        /// If [`type_`](EventTriggerConfig::type_) is [`types::EventTriggerType::COMBINATION`].
        #[cfg_attr(feature = "serde", serde(rename = "combination"))]
        COMBINATION => Combination(types::EventTriggerCombination) "combination",
    }
    default EventTriggerConfigParameters::None
}

union_ranges! { EventTriggerConfigParameters Gpio Threshold }

ranges! {
    EventTriggerConfig
    [parameters];
}

constructors! {
    EventTriggerConfig

    /// Apply the new setting.
    fn write(instance: u8, parameters: EventTriggerConfigParameters) -> WriteCall, type_: parameters.tag();

    /// Return the current setting in a response.
    fn read(instance: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(instance: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(instance: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(instance: u8) -> LoadDefaultCall;
}

field! {
    EventTriggerConfig: 0x2E, "3dm.event_trigger_config";
    in [0x0C];
}

command! {
    EventTriggerConfig -> Option<EventTriggerConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> EventTriggerConfigResponse;
    responds EventTriggerConfigResponse for READ;
    checks Ranged;
}

change! {
    EventTriggerConfigResponse -> WriteCall EventTriggerConfig
    [instance parameters] type_: parameters.tag(),
}

record! {
    /// Event action configuration (0x0C,0x2F).
    ///
    /// Configures the trigger and the effect of an event action.
    ///
    /// Also called `event_action`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`EventActionConfigResponse`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// - A packet holds one descriptor set; for several sets use several actions with the same
    ///   trigger.
    /// - A GPIO action needs its pin configured as an output with the gpio feature.
    /// - In each event cycle, the device updates all triggers first and then runs each action at
    ///   most once. The rate of the cycle is the base rate of the system data.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F); 3dm-cv7-gnss-ins: Event
    /// Cycle.
    #[derive(Eq, Hash)]
    pub struct EventActionConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Action instance; 0 means all (save, load, default).
        pub instance: Option<u8>,
        /// Trigger instance that the action follows.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub trigger: Option<u8>,
        /// Kind of action.
        ///
        /// Default: [`types::EventActionType::NONE`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: Option<types::EventActionType>,
        /// Effect of the action.
        ///
        /// Selected by [`type_`](EventActionConfig::type_). Required for
        /// [write](types::FunctionSelector::WRITE).
        pub parameters: Option<EventActionConfigParameters>,
    }
    wire 253 {
        [function selects]
        [instance for WRITE READ SAVE LOAD DEFAULT]
        [trigger for WRITE]
        [type_ "type" for WRITE]
        [parameters as type_ for WRITE]
    }
}

union! {
    /// The alternatives of `parameters` in [`EventActionConfig`].
    #[derive(Eq, Hash)]
    pub enum EventActionConfigParameters: types::EventActionType {
        /// The instance is not in use.
        ///
        /// Empty if [`type_`](EventActionConfig::type_) is [`types::EventActionType::NONE`].
        #[cfg_attr(feature = "serde", serde(rename = "none"))]
        NONE => None,
        /// Controls a GPIO pin.
        ///
        /// If [`type_`](EventActionConfig::type_) is [`types::EventActionType::GPIO`].
        #[cfg_attr(feature = "serde", serde(rename = "gpio"))]
        GPIO => Gpio(types::EventActionGpio) "gpio",
        /// Sends a data packet.
        ///
        /// If [`type_`](EventActionConfig::type_) is [`types::EventActionType::MESSAGE`].
        #[cfg_attr(feature = "serde", serde(rename = "message"))]
        MESSAGE => Message(types::EventActionMessage) "message",
    }
    default EventActionConfigParameters::None
}

union_ranges! { EventActionConfigParameters Gpio }

ranges! {
    EventActionConfig
    [parameters];
}

constructors! {
    EventActionConfig

    /// Apply the new setting.
    fn write(
        instance: u8,
        trigger: u8,
        parameters: EventActionConfigParameters,
    ) -> WriteCall, type_: parameters.tag();

    /// Return the current setting in a response.
    fn read(instance: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(instance: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(instance: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(instance: u8) -> LoadDefaultCall;
}

field! {
    EventActionConfig: 0x2F, "3dm.event_action_config";
    in [0x0C];
}

command! {
    EventActionConfig -> Option<EventActionConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> EventActionConfigResponse;
    responds EventActionConfigResponse for READ;
    checks Ranged;
}

change! {
    EventActionConfigResponse -> WriteCall EventActionConfig
    [instance trigger parameters] type_: parameters.tag(),
}

record! {
    /// Device start up settings (0x0C,0x30).
    ///
    /// Saves, loads or resets all settings of the device at once.
    ///
    /// Functions: [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). The device may take 2 s to reply. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 22 more.
    ///
    /// - A save may disturb the data output for a short time.
    /// - A save may take up to 1 s. Use a reply time-out of at least 2 s.
    ///
    /// Source: 3dm-gx5-15: 4.2.8 Device Startup Settings (0x0C, 0x30); 3dm-cv7-gnss-ins: Device
    /// Start Up Settings (0x0C,0x30).
    #[derive(Copy, Eq, Hash)]
    pub struct DeviceSettings {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
    }
    wire 1 {
        [function selects]
    }
}

constructors! {
    DeviceSettings

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    DeviceSettings: 0x30, "3dm.device_settings";
    in [0x0C];
}

command! {
    DeviceSettings -> ();
    for SAVE LOAD DEFAULT -> ();
    timeout 2000;
}

record! {
    /// Sensor-to-vehicle frame transformation Euler (0x0C,0x31).
    ///
    /// Sets the mounting of the sensor in the vehicle as Euler angles.
    ///
    /// Also called `sensor_2_vehicle_transform_euler`. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`SensorToVehicleTransformEulerResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`sensor::CompOrientationMatrix`](crate::sensor::CompOrientationMatrix),
    /// [`sensor::CompQuaternion`](crate::sensor::CompQuaternion),
    /// [`sensor::CompEulerAngles`](crate::sensor::CompEulerAngles),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate) and
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector). Probably affects
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel) and
    /// [`sensor::CompOrientationUpdateMatrix`](crate::sensor::CompOrientationUpdateMatrix).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 9 more.
    ///
    /// - [`SensorToVehicleTransformQuaternion`] and [`SensorToVehicleTransformDcm`] set the same
    ///   transformation; the value read back may be another form of it.
    /// - Starting aligned with the vehicle frame, the sensor is rotated by yaw, pitch and roll
    ///   about its own z, y and x axes, in this order.
    /// - `v_vehicle = Rz(yaw) * Ry(pitch) * Rx(roll) * v_sensor`
    /// - Every change resets the complementary filter, the estimation filter and all low-pass
    ///   filters.
    /// - On some older devices the setting is the inverse rotation.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31).
    #[derive(Copy)]
    pub struct SensorToVehicleTransformEuler {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Roll angle of the sensor relative to the vehicle.
        ///
        /// Unit: rad. Frame: vehicle. Positive: right side down. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub roll: Option<f32>,
        /// Pitch angle of the sensor relative to the vehicle.
        ///
        /// Unit: rad. Frame: vehicle. Positive: nose up. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub pitch: Option<f32>,
        /// Yaw angle of the sensor relative to the vehicle.
        ///
        /// Unit: rad. Frame: vehicle. Positive: clockwise seen from above. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub yaw: Option<f32>,
    }
    wire 13 {
        [function selects]
        [roll for WRITE]
        [pitch for WRITE]
        [yaw for WRITE]
    }
}

constructors! {
    SensorToVehicleTransformEuler

    /// Apply the new setting.
    fn write(
        roll: f32,
        pitch: f32,
        yaw: f32,
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
    SensorToVehicleTransformEuler: 0x31, "3dm.sensor_to_vehicle_transform_euler";
    in [0x0C];
}

command! {
    SensorToVehicleTransformEuler -> Option<SensorToVehicleTransformEulerResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleTransformEulerResponse;
    responds SensorToVehicleTransformEulerResponse for READ;
}

change! {
    SensorToVehicleTransformEulerResponse -> WriteCall SensorToVehicleTransformEuler
    [roll pitch yaw]
}

record! {
    /// Sensor-to-vehicle frame transformation quaternion (0x0C,0x32).
    ///
    /// Sets the mounting of the sensor in the vehicle as a quaternion.
    ///
    /// Also called `sensor_2_vehicle_transform_quaternion`. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`SensorToVehicleTransformQuaternionResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`sensor::CompOrientationMatrix`](crate::sensor::CompOrientationMatrix),
    /// [`sensor::CompQuaternion`](crate::sensor::CompQuaternion),
    /// [`sensor::CompEulerAngles`](crate::sensor::CompEulerAngles),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate) and
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector). Probably affects
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel) and
    /// [`sensor::CompOrientationUpdateMatrix`](crate::sensor::CompOrientationUpdateMatrix).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// - [`SensorToVehicleTransformEuler`] and [`SensorToVehicleTransformDcm`] set the same
    ///   transformation; the value read back may be another form of it.
    /// - `p_vehicle = q^-1 * p_sensor * q`, where the vectors are quaternions with the scalar part
    ///   0. This is the inverse of the quaternion that
    ///   [`filter::SensorToVehicleRotationQuaternion`](crate::filter::SensorToVehicleRotationQuaternion)
    ///   accepts.
    /// - Every change resets the complementary filter, the estimation filter and all low-pass
    ///   filters.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32).
    #[derive(Copy)]
    pub struct SensorToVehicleTransformQuaternion {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
        ///
        /// Elements: w, x, y, z. Unit: 1. Required for [write](types::FunctionSelector::WRITE).
        pub q: Option<types::Quatf>,
    }
    wire 17 {
        [function selects]
        [q for WRITE]
    }
}

constructors! {
    SensorToVehicleTransformQuaternion

    /// Apply the new setting.
    fn write(q: impl Into<types::Quatf>) -> WriteCall;

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
    SensorToVehicleTransformQuaternion: 0x32, "3dm.sensor_to_vehicle_transform_quaternion";
    in [0x0C];
}

command! {
    SensorToVehicleTransformQuaternion -> Option<SensorToVehicleTransformQuaternionResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleTransformQuaternionResponse;
    responds SensorToVehicleTransformQuaternionResponse for READ;
}

change! {
    SensorToVehicleTransformQuaternionResponse -> WriteCall SensorToVehicleTransformQuaternion
    [q]
}

record! {
    /// Sensor-to-vehicle frame transformation direction cosine matrix (0x0C,0x33).
    ///
    /// Sets the mounting of the sensor in the vehicle as a direction cosine matrix.
    ///
    /// Also called `sensor_2_vehicle_transform_dcm`. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response:
    /// [`SensorToVehicleTransformDcmResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`sensor::CompOrientationMatrix`](crate::sensor::CompOrientationMatrix),
    /// [`sensor::CompQuaternion`](crate::sensor::CompQuaternion),
    /// [`sensor::CompEulerAngles`](crate::sensor::CompEulerAngles),
    /// [`filter_data::AttitudeQuaternion`](crate::filter_data::AttitudeQuaternion),
    /// [`filter_data::AttitudeDcm`](crate::filter_data::AttitudeDcm),
    /// [`filter_data::EulerAngles`](crate::filter_data::EulerAngles),
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate) and
    /// [`filter_data::GravityVector`](crate::filter_data::GravityVector). Probably affects
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel) and
    /// [`sensor::CompOrientationUpdateMatrix`](crate::sensor::CompOrientationUpdateMatrix).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// - [`SensorToVehicleTransformEuler`] and [`SensorToVehicleTransformQuaternion`] set the same
    ///   transformation; the value read back may be another form of it.
    /// - `v_vehicle = dcm * v_sensor`. This is the inverse of the matrix that
    ///   [`filter::SensorToVehicleRotationDcm`](crate::filter::SensorToVehicleRotationDcm) accepts.
    /// - Every change resets the complementary filter, the estimation filter and all low-pass
    ///   filters.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix
    /// (0x0C,0x33).
    #[derive(Copy)]
    pub struct SensorToVehicleTransformDcm {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Rotates vectors of the sensor frame into the vehicle frame; row-major.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub dcm: Option<types::Matrix3f>,
    }
    wire 37 {
        [function selects]
        [dcm for WRITE]
    }
}

constructors! {
    SensorToVehicleTransformDcm

    /// Apply the new setting.
    fn write(dcm: impl Into<types::Matrix3f>) -> WriteCall;

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
    SensorToVehicleTransformDcm: 0x33, "3dm.sensor_to_vehicle_transform_dcm";
    in [0x0C];
}

command! {
    SensorToVehicleTransformDcm -> Option<SensorToVehicleTransformDcmResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorToVehicleTransformDcmResponse;
    responds SensorToVehicleTransformDcmResponse for READ;
}

change! {
    SensorToVehicleTransformDcmResponse -> WriteCall SensorToVehicleTransformDcm
    [dcm]
}

record! {
    /// GPS dynamics mode (0x0C,0x34).
    ///
    /// Sets the dynamics that the GNSS receiver assumes of the vehicle.
    ///
    /// No device is known for certain to support it. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GpsDynamicsModeResponse`]. Probably
    /// affects [`gnss_data::LlhPosition`](crate::gnss_data::LlhPosition) and
    /// [`gnss_data::NedVelocity`](crate::gnss_data::NedVelocity). Known only from the MIP SDK of
    /// 2014 and MicroStrain Communication Library. Requires a receiver. Uncertain: No source lists
    /// the devices that support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only.
    ///
    /// Source: mip-sdk-2014: GPS dynamics mode (0x0C,0x34); mscl: GPS dynamics mode (0x0C,0x34).
    #[derive(Copy, Eq, Hash)]
    pub struct GpsDynamicsMode {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Assumed dynamics.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub mode: Option<ReceiverDynamics>,
    }
    wire 2 {
        [function selects]
        [mode for WRITE]
    }
}

constructors! {
    GpsDynamicsMode

    /// Apply the new setting.
    fn write(mode: ReceiverDynamics) -> WriteCall;

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
    GpsDynamicsMode: 0x34, "3dm.gps_dynamics_mode";
    in [0x0C];
}

command! {
    GpsDynamicsMode -> Option<GpsDynamicsModeResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GpsDynamicsModeResponse;
    responds GpsDynamicsModeResponse for READ;
}

change! {
    GpsDynamicsModeResponse -> WriteCall GpsDynamicsMode
    [mode]
}

record! {
    /// IMU signal conditioning (0x0C,0x35).
    ///
    /// Configures the filters and the orientation algorithm of 3-series devices.
    ///
    /// No device is known for certain to support it. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ImuSignalConditioningResponse`].
    /// Affects [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity),
    /// [`sensor::CompOrientationMatrix`](crate::sensor::CompOrientationMatrix),
    /// [`sensor::CompQuaternion`](crate::sensor::CompQuaternion) and
    /// [`sensor::CompEulerAngles`](crate::sensor::CompEulerAngles). Probably affects
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag). Known only from the MIP SDK of 2014 and
    /// MicroStrain Communication Library. Uncertain: The ranges, the defaults and some of the flags
    /// are those of the single-byte protocol of the 3DM-GX3, which has the same record. Uncertain:
    /// No source lists the devices that support it; the SDK of 2014 uses it in its example for the
    /// 3DM-GX3-35 only. Uncertain: MSCL reads the response without `reserved`, so some devices may
    /// not send it.
    ///
    /// - The filters are moving averages; the first zero of their response is at 1000 Hz divided by
    ///   the width.
    ///
    /// Source: mip-sdk-2014: IMU signal conditioning (0x0C,0x35); mscl: IMU signal conditioning
    /// (0x0C,0x35).
    #[derive(Copy, Eq, Hash)]
    pub struct ImuSignalConditioning {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Divisor of 1000 Hz that sets the rate at which the orientation is computed.
        ///
        /// Unit: 1. Range: 1 to 1000. Required for [write](types::FunctionSelector::WRITE).
        pub orientation_decimation: Option<u16>,
        /// Processing steps.
        ///
        /// Default: 3. Required for [write](types::FunctionSelector::WRITE).
        pub data_conditioning_flags: Option<DataConditioningFlags>,
        /// Width of the accelerometer and gyroscope filter in samples.
        ///
        /// Unit: 1. Range: 1 to 32. Default: 15. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub inertial_filter_width: Option<u8>,
        /// Width of the magnetometer filter in samples.
        ///
        /// Unit: 1. Range: 1 to 32. Default: 17. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub mag_filter_width: Option<u8>,
        /// Time constant of the pitch and roll correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub up_compensation: Option<u16>,
        /// Time constant of the heading correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub north_compensation: Option<u16>,
        /// Bandwidth of the magnetometer of 3-series devices.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub mag_bandwidth: Option<MagBandwidth>,
        /// Reserved: send 0. Required for [write](types::FunctionSelector::WRITE).
        pub reserved: Option<u16>,
    }
    wire 14 {
        [function selects]
        [orientation_decimation for WRITE]
        [data_conditioning_flags for WRITE]
        [inertial_filter_width for WRITE]
        [mag_filter_width for WRITE]
        [up_compensation for WRITE]
        [north_compensation for WRITE]
        [mag_bandwidth for WRITE]
        [reserved for WRITE]
    }
}

ranges! {
    ImuSignalConditioning
    orientation_decimation "orientation_decimation" in "1 to 1000" From 1.0 To 1000.0;
    inertial_filter_width "inertial_filter_width" in "1 to 32" From 1.0 To 32.0;
    mag_filter_width "mag_filter_width" in "1 to 32" From 1.0 To 32.0;
    up_compensation "up_compensation" in "1 to 1000" From 1.0 To 1000.0;
    north_compensation "north_compensation" in "1 to 1000" From 1.0 To 1000.0;
}

constructors! {
    ImuSignalConditioning

    /// Apply the new setting.
    fn write(
        orientation_decimation: u16,
        data_conditioning_flags: DataConditioningFlags,
        inertial_filter_width: u8,
        mag_filter_width: u8,
        up_compensation: u16,
        north_compensation: u16,
        mag_bandwidth: MagBandwidth,
    ) -> WriteCall, reserved: 0;

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
    ImuSignalConditioning: 0x35, "3dm.imu_signal_conditioning";
    in [0x0C];
}

command! {
    ImuSignalConditioning -> Option<ImuSignalConditioningResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ImuSignalConditioningResponse;
    responds ImuSignalConditioningResponse for READ;
    checks Ranged;
}

change! {
    ImuSignalConditioningResponse -> WriteCall ImuSignalConditioning
    [orientation_decimation data_conditioning_flags inertial_filter_width mag_filter_width up_compensation north_compensation mag_bandwidth] reserved: 0,
}

record! {
    /// IMU timestamp (0x0C,0x36).
    ///
    /// Sets or reads a time counter of the sensor data.
    ///
    /// No device is known for certain to support it. Functions:
    /// [write](types::FunctionSelector::WRITE) and [read](types::FunctionSelector::READ). Response:
    /// [`ImuTimestampResponse`]. Known only from the MIP SDK of 2014. Uncertain: No source lists
    /// the devices that support it; the SDK of 2014 uses it in its example for the 3DM-GX3-35 only.
    /// Uncertain: A read is assumed to omit `time`, which the device would ignore.
    ///
    /// Source: mip-sdk-2014: IMU timestamp (0x0C,0x36).
    #[derive(Copy, Eq, Hash)]
    pub struct ImuTimestamp {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Counter to set or read.
        pub selector: Option<ImuTimestampSelector>,
        /// Value of the counter, in the unit that `selector` selects.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub time: Option<u32>,
    }
    wire 6 {
        [function selects]
        [selector for WRITE READ]
        [time for WRITE]
    }
}

constructors! {
    ImuTimestamp

    /// Apply the new setting.
    fn write(selector: ImuTimestampSelector, time: u32) -> WriteCall;

    /// Return the current setting in a response.
    fn read(selector: ImuTimestampSelector) -> ReadCall;
}

field! {
    ImuTimestamp: 0x36, "3dm.imu_timestamp";
    in [0x0C];
}

command! {
    ImuTimestamp -> Option<ImuTimestampResponse>;
    for WRITE -> ();
    for READ -> ImuTimestampResponse;
    responds ImuTimestampResponse for READ;
}

change! {
    ImuTimestampResponse -> WriteCall ImuTimestamp
    [selector time]
}

record! {
    /// Accelerometer bias configuration (0x0C,0x37).
    ///
    /// Sets the bias that is subtracted from the scaled acceleration.
    ///
    /// For advanced use. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD), [default](types::FunctionSelector::DEFAULT) and
    /// [apply](types::FunctionSelector::APPLY). Response: [`AccelBiasResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel). Probably affects
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity) and
    /// [`filter_data::AccelBias`](crate::filter_data::AccelBias). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 24 more. On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS):
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT) only.
    ///
    /// Source: 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37); 3dm-cv7-gnss-ins: Accelerometer Bias
    /// Configuration (0x0C,0x37).
    #[derive(Copy)]
    pub struct AccelBias {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Bias that the device subtracts from the measured acceleration.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor. Required for
        /// [write](types::FunctionSelector::WRITE) and [apply](types::FunctionSelector::APPLY).
        pub bias: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [bias for WRITE APPLY]
    }
}

constructors! {
    AccelBias

    /// Apply the new setting.
    fn write(bias: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;

    /// Apply the new setting without sending an ACK (5-series devices).
    fn apply(bias: impl Into<types::Vector3f>) -> ApplyCall;
}

field! {
    AccelBias: 0x37, "3dm.accel_bias";
    in [0x0C];
}

command! {
    AccelBias -> Option<AccelBiasResponse>;
    for WRITE SAVE LOAD DEFAULT APPLY -> ();
    for READ -> AccelBiasResponse;
    responds AccelBiasResponse for READ;
    silent for APPLY;
}

change! {
    AccelBiasResponse -> WriteCall AccelBias
    [bias]
}

record! {
    /// Gyroscope bias configuration (0x0C,0x38).
    ///
    /// Sets the bias that is subtracted from the scaled angular rate.
    ///
    /// For advanced use. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD), [default](types::FunctionSelector::DEFAULT) and
    /// [apply](types::FunctionSelector::APPLY). Response: [`GyroBiasResponse`]. Affects
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro). Probably affects
    /// [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`filter_data::GyroBias`](crate::filter_data::GyroBias) and
    /// [`filter_data::Status`](crate::filter_data::Status). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 23 more. On the
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS): [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT) only.
    /// On the [3DM-CV7-AR](crate::devices::CV7_AR): [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT) only.
    /// On the [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS):
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT) only.
    ///
    /// Source: 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38); 3dm-cv7-gnss-ins: Gyroscope Bias
    /// Configuration (0x0C,0x38).
    #[derive(Copy)]
    pub struct GyroBias {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Bias that the device subtracts from the measured angular rate.
        ///
        /// Elements: x, y, z. Unit: rad/s. Frame: sensor. Required for
        /// [write](types::FunctionSelector::WRITE) and [apply](types::FunctionSelector::APPLY).
        pub bias: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [bias for WRITE APPLY]
    }
}

constructors! {
    GyroBias

    /// Apply the new setting.
    fn write(bias: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;

    /// Apply the new setting without sending an ACK (5-series devices).
    fn apply(bias: impl Into<types::Vector3f>) -> ApplyCall;
}

field! {
    GyroBias: 0x38, "3dm.gyro_bias";
    in [0x0C];
}

command! {
    GyroBias -> Option<GyroBiasResponse>;
    for WRITE SAVE LOAD DEFAULT APPLY -> ();
    for READ -> GyroBiasResponse;
    responds GyroBiasResponse for READ;
    silent for APPLY;
}

change! {
    GyroBiasResponse -> WriteCall GyroBias
    [bias]
}

record! {
    /// Capture gyroscope bias (0x0C,0x39).
    ///
    /// Averages the angular rate of the device at rest and uses the result as the gyroscope bias.
    ///
    /// Response: [`GyroBiasResponse`]. Affects [`sensor::ScaledGyro`](crate::sensor::ScaledGyro).
    /// Probably affects [`sensor::DeltaTheta`](crate::sensor::DeltaTheta),
    /// [`filter_data::GyroBias`](crate::filter_data::GyroBias) and
    /// [`filter_data::Status`](crate::filter_data::Status). The device may take 31 s to reply.
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 21 more.
    ///
    /// - The device must be at rest, with as little vibration as possible, for the whole time.
    /// - The reply arrives after the averaging time.
    /// - The bias is not saved; to save it, send [`GyroBias`] with save.
    /// - The 3DM-GX5-15 also initializes its orientation from the samples.
    ///
    /// Source: 3dm-gx5-15: 4.2.11 Capture Gyro Bias (0x0C, 0x39); 3dm-cv7-gnss-ins: Capture
    /// Gyroscope Bias (0x0C,0x39).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct CaptureGyroBias {
        /// Time to average over.
        ///
        /// Unit: ms. Range: 1000 to 30000.
        pub averaging_time_ms: u16,
    }
}

ranges! {
    CaptureGyroBias
    averaging_time_ms "averaging_time_ms" in "1000 to 30000" From 1000.0 To 30000.0;
}

constructors! {
    CaptureGyroBias

    /// Creates the command from its parameters.
    fn new(averaging_time_ms: u16);
}

field! {
    CaptureGyroBias: 0x39, "3dm.capture_gyro_bias";
    in [0x0C];
}

command! {
    CaptureGyroBias -> GyroBiasResponse;
    responds GyroBiasResponse;
    timeout 31000;
    checks Ranged;
}

record! {
    /// Magnetometer hard iron offset (0x0C,0x3A).
    ///
    /// Sets the offset that corrects the scaled magnetic field for hard iron.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD),
    /// [default](types::FunctionSelector::DEFAULT) and [apply](types::FunctionSelector::APPLY).
    /// Response: [`MagHardIronOffsetResponse`]. Affects
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 14 more. On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS):
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT) only. On the
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT) only.
    /// Requires a magnetometer. Uncertain: The sources do not state the formula; it is inferred
    /// from the terms.
    ///
    /// - The values come from a calibration of the device as it is installed.
    /// - On some devices,
    ///   [`filter::MagCaptureAutoCalibration`](crate::filter::MagCaptureAutoCalibration) captures
    ///   them from the filter's automatic calibration.
    /// - Before it sends [`sensor::ScaledMag`](crate::sensor::ScaledMag), the device corrects the
    ///   field: the matrix times (measured - offset), with the matrix of [`MagSoftIronMatrix`].
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A); 3dm-gx5-45: (0x0C,
    /// 0x3A).
    #[derive(Copy)]
    pub struct MagHardIronOffset {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Offset that the device subtracts from the measured magnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor. Required for
        /// [write](types::FunctionSelector::WRITE) and [apply](types::FunctionSelector::APPLY). On
        /// the [3DM-GX5-45](crate::devices::GX5_45): default 0, 0, 0.
        pub offset: Option<types::Vector3f>,
    }
    wire 13 {
        [function selects]
        [offset for WRITE APPLY]
    }
}

constructors! {
    MagHardIronOffset

    /// Apply the new setting.
    fn write(offset: impl Into<types::Vector3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;

    /// Apply the new setting without sending an ACK (5-series devices).
    fn apply(offset: impl Into<types::Vector3f>) -> ApplyCall;
}

field! {
    MagHardIronOffset: 0x3A, "3dm.mag_hard_iron_offset";
    in [0x0C];
}

command! {
    MagHardIronOffset -> Option<MagHardIronOffsetResponse>;
    for WRITE SAVE LOAD DEFAULT APPLY -> ();
    for READ -> MagHardIronOffsetResponse;
    responds MagHardIronOffsetResponse for READ;
    silent for APPLY;
}

change! {
    MagHardIronOffsetResponse -> WriteCall MagHardIronOffset
    [offset]
}

record! {
    /// Magnetometer soft iron matrix (0x0C,0x3B).
    ///
    /// Sets the matrix that corrects the scaled magnetic field for soft iron.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD),
    /// [default](types::FunctionSelector::DEFAULT) and [apply](types::FunctionSelector::APPLY).
    /// Response: [`MagSoftIronMatrixResponse`]. Affects
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 14 more. On the [3DM-CV7-AHRS](crate::devices::CV7_AHRS):
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT) only. On the
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT) only.
    /// Requires a magnetometer. Uncertain: The sources do not state the formula; it is inferred
    /// from the terms.
    ///
    /// - The values come from a calibration of the device as it is installed.
    /// - On some devices,
    ///   [`filter::MagCaptureAutoCalibration`](crate::filter::MagCaptureAutoCalibration) captures
    ///   them from the filter's automatic calibration.
    /// - Before it sends [`sensor::ScaledMag`](crate::sensor::ScaledMag), the device corrects the
    ///   field: the matrix times (measured - offset), with the offset of [`MagHardIronOffset`].
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B); 3dm-gx5-35: (0x0C,
    /// 0x3B).
    #[derive(Copy)]
    pub struct MagSoftIronMatrix {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Soft iron matrix in row-major order.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: sensor. Required
        /// for [write](types::FunctionSelector::WRITE) and [apply](types::FunctionSelector::APPLY).
        pub matrix: Option<types::Matrix3f>,
    }
    wire 37 {
        [function selects]
        [matrix for WRITE APPLY]
    }
}

constructors! {
    MagSoftIronMatrix

    /// Apply the new setting.
    fn write(matrix: impl Into<types::Matrix3f>) -> WriteCall;

    /// Return the current setting in a response.
    fn read() -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;

    /// Apply the new setting without sending an ACK (5-series devices).
    fn apply(matrix: impl Into<types::Matrix3f>) -> ApplyCall;
}

field! {
    MagSoftIronMatrix: 0x3B, "3dm.mag_soft_iron_matrix";
    in [0x0C];
}

command! {
    MagSoftIronMatrix -> Option<MagSoftIronMatrixResponse>;
    for WRITE SAVE LOAD DEFAULT APPLY -> ();
    for READ -> MagSoftIronMatrixResponse;
    responds MagSoftIronMatrixResponse for READ;
    silent for APPLY;
}

change! {
    MagSoftIronMatrixResponse -> WriteCall MagSoftIronMatrix
    [matrix]
}

record! {
    /// Coning and sculling enable (0x0C,0x3E).
    ///
    /// Enables or disables coning and sculling compensation.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ConingScullingEnableResponse`].
    /// Probably affects [`sensor::DeltaTheta`](crate::sensor::DeltaTheta) and
    /// [`sensor::DeltaVelocity`](crate::sensor::DeltaVelocity). Confirmed on
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 15 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E).
    #[derive(Copy, Eq, Hash)]
    pub struct ConingScullingEnable {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// True if the compensation is on.
        ///
        /// Default: true. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<crate::Bool>,
    }
    wire 2 {
        [function selects]
        [enable for WRITE]
    }
}

constructors! {
    ConingScullingEnable

    /// Apply the new setting.
    fn write(enable: bool) -> WriteCall;

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
    ConingScullingEnable: 0x3E, "3dm.coning_sculling_enable";
    in [0x0C];
}

command! {
    ConingScullingEnable -> Option<ConingScullingEnableResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ConingScullingEnableResponse;
    responds ConingScullingEnableResponse for READ;
}

change! {
    ConingScullingEnableResponse -> WriteCall ConingScullingEnable
    [enable]
}

record! {
    /// UART baud rate (0x0C,0x40).
    ///
    /// Sets the baud rate of the main port.
    ///
    /// Also called `uart_baudrate`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`UartBaudRateResponse`]. Devices without it may have
    /// [`base::CommSpeed`](crate::base::CommSpeed). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 12 more.
    ///
    /// - The 3DM-GX5-15 replies at the old rate and accepts commands at the new rate 250 ms later.
    /// - The 3DM-CV7 applies the rate when the port is empty, after at most 250 ms; until then,
    ///   commands and data may be lost.
    /// - Set the device to idle first, send the command in a separate packet, and wait 250 ms
    ///   afterwards.
    ///
    /// Source: 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40); 3dm-cv7-gnss-ins: UART Baudrate
    /// (0x0C,0x40).
    #[derive(Copy, Eq, Hash)]
    pub struct UartBaudRate {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// New baud rate; the port must support it.
        ///
        /// Unit: Bd. Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-45](crate::devices::GX5_45): default
        /// 115200.
        pub baud: Option<u32>,
    }
    wire 5 {
        [function selects]
        [baud for WRITE]
    }
}

constructors! {
    UartBaudRate

    /// Apply the new setting.
    fn write(baud: u32) -> WriteCall;

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
    UartBaudRate: 0x40, "3dm.uart_baud_rate";
    in [0x0C];
}

command! {
    UartBaudRate -> Option<UartBaudRateResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> UartBaudRateResponse;
    responds UartBaudRateResponse for READ;
}

change! {
    UartBaudRateResponse -> WriteCall UartBaudRate
    [baud]
}

record! {
    /// GPIO configuration (0x0C,0x41).
    ///
    /// Sets the use of a GPIO pin.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`GpioConfigResponse`]. Probably
    /// affects [`system_data::GpioState`](crate::system_data::GpioState) and
    /// [`system_data::GpioAnalogValue`](crate::system_data::GpioAnalogValue). Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// - Not every pin has every feature.
    /// - For an output with a feature other than gpio, configure the function that drives it before
    ///   the pin; otherwise, the level of the pin is undefined in the meantime. For an input,
    ///   configure the pin before the function that uses it.
    /// - If only one pin can have a configuration, the last pin configured gets it, and the earlier
    ///   pin is reset.
    /// - With NMEA input at most one pin may be a UART input; set it to unused before another one
    ///   takes over.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41).
    #[derive(Copy, Eq, Hash)]
    pub struct GpioConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// GPIO pin, counted from 1; 0 means all pins (save, load, default).
        pub pin: Option<u8>,
        /// Use of the pin.
        ///
        /// Default: [`types::GpioFeature::UNUSED`]. Required for
        /// [write](types::FunctionSelector::WRITE).
        pub feature: Option<types::GpioFeature>,
        /// Role of the pin within the feature; 0 if the feature has no roles.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). If
        /// [`feature`](GpioConfig::feature) is [`types::GpioFeature::UNUSED`]: values of
        /// [`types::GpioUnusedBehavior`]. If [`feature`](GpioConfig::feature) is
        /// [`types::GpioFeature::GPIO`]: values of [`types::GpioBehavior`]. If
        /// [`feature`](GpioConfig::feature) is [`types::GpioFeature::PPS`]: values of
        /// [`types::GpioPpsBehavior`]. If [`feature`](GpioConfig::feature) is
        /// [`types::GpioFeature::ENCODER`]: values of [`types::GpioEncoderBehavior`]. If
        /// [`feature`](GpioConfig::feature) is [`types::GpioFeature::TIMESTAMP`]: values of
        /// [`types::GpioTimestampBehavior`]. If [`feature`](GpioConfig::feature) is
        /// [`types::GpioFeature::UART`]: values of [`types::GpioUartBehavior`].
        pub behavior: Option<u8>,
        /// Electrical options.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub pin_mode: Option<types::GpioPinMode>,
    }
    wire 5 {
        [function selects]
        [pin for WRITE READ SAVE LOAD DEFAULT]
        [feature for WRITE]
        [behavior for WRITE]
        [pin_mode for WRITE]
    }
}

constructors! {
    GpioConfig

    /// Apply the new setting.
    fn write(
        pin: u8,
        feature: types::GpioFeature,
        behavior: u8,
        pin_mode: types::GpioPinMode,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read(pin: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(pin: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(pin: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(pin: u8) -> LoadDefaultCall;
}

#[rustfmt::skip]
impl GpioConfig {
    /// Reads `behavior` as [`types::GpioUnusedBehavior`].
    ///
    /// If [`feature`](GpioConfig::feature) is [`types::GpioFeature::UNUSED`]: values of
    /// [`types::GpioUnusedBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_unused_behavior(&self) -> Option<types::GpioUnusedBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::UNUSED));
        self.behavior.filter(|_| named).map(Into::into)
    }

    /// Reads `behavior` as [`types::GpioBehavior`].
    ///
    /// If [`feature`](GpioConfig::feature) is [`types::GpioFeature::GPIO`]: values of
    /// [`types::GpioBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_behavior(&self) -> Option<types::GpioBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::GPIO));
        self.behavior.filter(|_| named).map(Into::into)
    }

    /// Reads `behavior` as [`types::GpioPpsBehavior`].
    ///
    /// If [`feature`](GpioConfig::feature) is [`types::GpioFeature::PPS`]: values of
    /// [`types::GpioPpsBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_pps_behavior(&self) -> Option<types::GpioPpsBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::PPS));
        self.behavior.filter(|_| named).map(Into::into)
    }

    /// Reads `behavior` as [`types::GpioEncoderBehavior`].
    ///
    /// If [`feature`](GpioConfig::feature) is [`types::GpioFeature::ENCODER`]: values of
    /// [`types::GpioEncoderBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_encoder_behavior(&self) -> Option<types::GpioEncoderBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::ENCODER));
        self.behavior.filter(|_| named).map(Into::into)
    }

    /// Reads `behavior` as [`types::GpioTimestampBehavior`].
    ///
    /// If [`feature`](GpioConfig::feature) is [`types::GpioFeature::TIMESTAMP`]: values of
    /// [`types::GpioTimestampBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_timestamp_behavior(&self) -> Option<types::GpioTimestampBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::TIMESTAMP));
        self.behavior.filter(|_| named).map(Into::into)
    }

    /// Reads `behavior` as [`types::GpioUartBehavior`].
    ///
    /// If [`feature`](GpioConfig::feature) is [`types::GpioFeature::UART`]: values of
    /// [`types::GpioUartBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_uart_behavior(&self) -> Option<types::GpioUartBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::UART));
        self.behavior.filter(|_| named).map(Into::into)
    }
}

field! {
    GpioConfig: 0x41, "3dm.gpio_config";
    in [0x0C];
}

command! {
    GpioConfig -> Option<GpioConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> GpioConfigResponse;
    responds GpioConfigResponse for READ;
}

change! {
    GpioConfigResponse -> WriteCall GpioConfig
    [pin feature behavior pin_mode]
}

record! {
    /// GPIO state (0x0C,0x42).
    ///
    /// Sets or reads the state of a GPIO pin.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE) and
    /// [read](types::FunctionSelector::READ). Response: [`GpioStateResponse`]. Affects
    /// [`system_data::GpioState`](crate::system_data::GpioState). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 9 more.
    ///
    /// - A read returns the level of the pin itself.
    /// - A write has an effect only on a pin that is configured as an output.
    /// - An event action of mode `active_high` or `active_low` on the pin overrides the written
    ///   state.
    /// - Reading is guaranteed to work only with the gpio feature.
    /// - [`GpioConfig`] determines the state at power-up.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42).
    #[derive(Copy, Eq, Hash)]
    pub struct GpioState {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// GPIO pin, counted from 1.
        ///
        /// Range: at least 1.
        pub pin: Option<u8>,
        /// True means high.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub state: Option<crate::Bool>,
    }
    wire 3 {
        [function selects]
        [pin for WRITE READ]
        [state for WRITE]
    }
}

ranges! {
    GpioState
    pin "pin" in "at least 1" From 1.0;
}

constructors! {
    GpioState

    /// Apply the new setting.
    fn write(pin: u8, state: bool) -> WriteCall;

    /// Return the current setting in a response.
    fn read(pin: u8) -> ReadCall;
}

field! {
    GpioState: 0x42, "3dm.gpio_state";
    in [0x0C];
}

command! {
    GpioState -> Option<GpioStateResponse>;
    for WRITE -> ();
    for READ -> GpioStateResponse;
    responds GpioStateResponse for READ;
    checks Ranged;
}

change! {
    GpioStateResponse -> WriteCall GpioState
    [pin state]
}

record! {
    /// Odometer configuration (0x0C,0x43).
    ///
    /// Configures the input from a wheel encoder.
    ///
    /// Also called `odometer`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`OdometerConfigResponse`]. Affects [`sensor::Odometer`](crate::sensor::Odometer).
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43).
    #[derive(Copy)]
    pub struct OdometerConfig {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Operation of the input.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub mode: Option<OdometerMode>,
        /// Pulses per distance travelled; negative if the encoder rotates backwards.
        ///
        /// Unit: pulse/m. Required for [write](types::FunctionSelector::WRITE).
        ///
        /// - Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub scaling: Option<f32>,
        /// Relative uncertainty of the scaling, 1 sigma.
        ///
        /// Unit: 1. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub uncertainty: Option<f32>,
    }
    wire 10 {
        [function selects]
        [mode for WRITE]
        [scaling for WRITE]
        [uncertainty for WRITE]
    }
}

ranges! {
    OdometerConfig
    uncertainty "uncertainty" in "at least 0" From 0.0;
}

constructors! {
    OdometerConfig

    /// Apply the new setting.
    fn write(
        mode: OdometerMode,
        scaling: f32,
        uncertainty: f32,
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
    OdometerConfig: 0x43, "3dm.odometer_config";
    in [0x0C];
}

command! {
    OdometerConfig -> Option<OdometerConfigResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> OdometerConfigResponse;
    responds OdometerConfigResponse for READ;
    checks Ranged;
}

change! {
    OdometerConfigResponse -> WriteCall OdometerConfig
    [mode scaling uncertainty]
}

record! {
    /// Advanced low-pass filter settings (0x0C,0x50).
    ///
    /// Configures the low-pass filter of one sensor data quantity.
    ///
    /// For advanced use. Also called `imu_lowpass_filter`. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ImuLowPassFilterResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag) and
    /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure). Devices without it may have
    /// [`LowPassFilter`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GQ7-GNSS/INS](crate::devices::GQ7),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 20 more. Deprecated on the
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS): use [`LowPassFilter`] instead. Deprecated on the
    /// [3DM-CV7-AR](crate::devices::CV7_AR): use [`LowPassFilter`] instead. Deprecated on the
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): use [`LowPassFilter`] instead. Deprecated
    /// on the [3DM-GQ7-GNSS/INS](crate::devices::GQ7): use [`LowPassFilter`] instead. Requires
    /// firmware up to 1.0.07 on the [3DM-CV7-AHRS](crate::devices::CV7_AHRS) and
    /// [3DM-CV7-AR](crate::devices::CV7_AR). Requires firmware up to 1.0.10 on the
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// - The filter has one pole. By default it is on and its cutoff is half the rate of the
    ///   message format.
    ///
    /// Source: 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50); 3dm-cv7-gnss-ins:
    /// Advanced Low-Pass Filter Settings (0x0C,0x50).
    #[derive(Copy, Eq, Hash)]
    pub struct ImuLowPassFilter {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
        /// magnetic field 0x06 or pressure 0x17.
        ///
        /// Refers to fields of Sensor data. On the
        /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS): Field descriptor in the sensor data
        /// set: scaled acceleration 0x04, angular rate 0x05, magnetic field 0x06 or pressure 0x17;
        /// 0 means all of them, except for read.
        pub target_descriptor: Option<u8>,
        /// True if the quantity is filtered.
        ///
        /// Default: true. Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<crate::Bool>,
        /// True uses `frequency`; false uses half the rate of the message format.
        ///
        /// Default: false. Required for [write](types::FunctionSelector::WRITE).
        pub manual: Option<crate::Bool>,
        /// Cutoff (-3 dB). It has no meaning if `manual` is false.
        ///
        /// Unit: Hz. Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-15](crate::devices::GX5_15): range at most 250.
        pub frequency: Option<u16>,
        /// Reserved: send 0. Required for [write](types::FunctionSelector::WRITE).
        pub reserved: Option<u8>,
    }
    wire 7 {
        [function selects]
        [target_descriptor for WRITE READ SAVE LOAD DEFAULT]
        [enable for WRITE]
        [manual for WRITE]
        [frequency for WRITE]
        [reserved for WRITE]
    }
}

constructors! {
    ImuLowPassFilter

    /// Apply the new setting.
    fn write(
        target_descriptor: u8,
        enable: bool,
        manual: bool,
        frequency: u16,
    ) -> WriteCall, reserved: 0;

    /// Return the current setting in a response.
    fn read(target_descriptor: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(target_descriptor: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(target_descriptor: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(target_descriptor: u8) -> LoadDefaultCall;
}

field! {
    ImuLowPassFilter: 0x50, "3dm.imu_low_pass_filter";
    in [0x0C];
}

command! {
    ImuLowPassFilter -> Option<ImuLowPassFilterResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ImuLowPassFilterResponse;
    responds ImuLowPassFilterResponse for READ;
}

change! {
    ImuLowPassFilterResponse -> WriteCall ImuLowPassFilter
    [target_descriptor enable manual frequency] reserved: 0,
}

record! {
    /// Complementary filter configuration (0x0C,0x51).
    ///
    /// Configures the complementary filter, which computes the attitude independently of the
    /// estimation filter.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`ComplementaryFilterResponse`].
    /// Affects [`sensor::CompOrientationMatrix`](crate::sensor::CompOrientationMatrix),
    /// [`sensor::CompQuaternion`](crate::sensor::CompQuaternion) and
    /// [`sensor::CompEulerAngles`](crate::sensor::CompEulerAngles). Probably affects
    /// [`sensor::NorthVector`](crate::sensor::NorthVector) and
    /// [`sensor::UpVector`](crate::sensor::UpVector). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-35](crate::devices::GX5_35); likely or
    /// assumed on 22 more.
    ///
    /// - Pitch and roll follow the accelerometers, on the assumption that the mean acceleration is
    ///   zero.
    /// - The heading follows the magnetometer, if the device has one.
    /// - The device rejects time constants out of range.
    /// - The attitude of the estimation filter is better; the 3DM-GX5-15 keeps this filter for
    ///   compatibility.
    ///
    /// Source: 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51); 3dm-cv7-gnss-ins:
    /// Complementary Filter Configuration (0x0C,0x51).
    #[derive(Copy)]
    pub struct ComplementaryFilter {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// True enables the pitch and roll correction, which 5-series manuals call up compensation.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-GX5-15](crate::devices::GX5_15): default true.
        pub pitch_roll_enable: Option<crate::Bool>,
        /// True enables the heading correction, which 5-series manuals call north compensation.
        ///
        /// Required for [write](types::FunctionSelector::WRITE). On the
        /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CX5-10](crate::devices::CX5_10) and [3DM-CX5-15](crate::devices::CX5_15): MSCL has
        /// no support for it. On the [3DM-GX5-15](crate::devices::GX5_15): default true.
        pub heading_enable: Option<crate::Bool>,
        /// Time constant of the pitch and roll correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub pitch_roll_time_constant: Option<f32>,
        /// Time constant of the heading correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10. Required for
        /// [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub heading_time_constant: Option<f32>,
    }
    wire 11 {
        [function selects]
        [pitch_roll_enable for WRITE]
        [heading_enable for WRITE]
        [pitch_roll_time_constant for WRITE]
        [heading_time_constant for WRITE]
    }
}

ranges! {
    ComplementaryFilter
    pitch_roll_time_constant "pitch_roll_time_constant" in "1 to 1000" From 1.0 To 1000.0;
    heading_time_constant "heading_time_constant" in "1 to 1000" From 1.0 To 1000.0;
}

constructors! {
    ComplementaryFilter

    /// Apply the new setting.
    fn write(
        pitch_roll_enable: bool,
        heading_enable: bool,
        pitch_roll_time_constant: f32,
        heading_time_constant: f32,
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
    ComplementaryFilter: 0x51, "3dm.complementary_filter";
    in [0x0C];
}

command! {
    ComplementaryFilter -> Option<ComplementaryFilterResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> ComplementaryFilterResponse;
    responds ComplementaryFilterResponse for READ;
    checks Ranged;
}

change! {
    ComplementaryFilterResponse -> WriteCall ComplementaryFilter
    [pitch_roll_enable heading_enable pitch_roll_time_constant heading_time_constant]
}

record! {
    /// Sensor range (0x0C,0x52).
    ///
    /// Sets the measuring range of a sensor.
    ///
    /// Functions: [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`SensorRangeResponse`]. Probably
    /// affects [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro) and
    /// [`sensor::OverrangeStatus`](crate::sensor::OverrangeStatus). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// - [`GetCalibratedSensorRanges`] lists the settings. The device may reject other settings, or
    ///   measure incorrectly with them.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52).
    #[derive(Copy, Eq, Hash)]
    pub struct SensorRange {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Sensor whose range is set or read.
        ///
        /// On the [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CX7-AR](crate::devices::CX7_AR) and
        /// [3DM-GV7-AR](crate::devices::GV7_AR): only [`SensorRangeType::ALL`],
        /// [`SensorRangeType::ACCEL`], [`SensorRangeType::GYRO`] and [`SensorRangeType::PRESSURE`].
        pub sensor: Option<SensorRangeType>,
        /// Number of the range.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub setting: Option<u8>,
    }
    wire 3 {
        [function selects]
        [sensor for WRITE READ SAVE LOAD DEFAULT]
        [setting for WRITE]
    }
}

constructors! {
    SensorRange

    /// Apply the new setting.
    fn write(sensor: SensorRangeType, setting: u8) -> WriteCall;

    /// Return the current setting in a response.
    fn read(sensor: SensorRangeType) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(sensor: SensorRangeType) -> SaveCall;

    /// Load the saved setting.
    fn load(sensor: SensorRangeType) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(sensor: SensorRangeType) -> LoadDefaultCall;
}

field! {
    SensorRange: 0x52, "3dm.sensor_range";
    in [0x0C];
}

command! {
    SensorRange -> Option<SensorRangeResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> SensorRangeResponse;
    responds SensorRangeResponse for READ;
}

change! {
    SensorRangeResponse -> WriteCall SensorRange
    [sensor setting]
}

record! {
    /// Get calibrated sensor ranges (0x0C,0x53).
    ///
    /// Gets the ranges that a sensor supports.
    ///
    /// Also called `calibrated_sensor_ranges`. Response: [`GetCalibratedSensorRangesResponse`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetCalibratedSensorRanges {
        /// Sensor to query; `all` is not allowed.
        ///
        /// On the [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CX7-AR](crate::devices::CX7_AR) and
        /// [3DM-GV7-AR](crate::devices::GV7_AR): only [`SensorRangeType::ALL`],
        /// [`SensorRangeType::ACCEL`], [`SensorRangeType::GYRO`] and [`SensorRangeType::PRESSURE`].
        pub sensor: SensorRangeType,
    }
}

constructors! {
    GetCalibratedSensorRanges

    /// Creates the command from its parameters.
    fn new(sensor: SensorRangeType);
}

field! {
    GetCalibratedSensorRanges: 0x53, "3dm.get_calibrated_sensor_ranges";
    in [0x0C];
}

command! {
    GetCalibratedSensorRanges -> GetCalibratedSensorRangesResponse;
    responds GetCalibratedSensorRangesResponse;
}

record! {
    /// Low-pass anti-aliasing filter (0x0C,0x54).
    ///
    /// Configures the low-pass filter of a data field.
    ///
    /// Also called `lowpass_filter`. Functions: [write](types::FunctionSelector::WRITE),
    /// [read](types::FunctionSelector::READ), [save](types::FunctionSelector::SAVE),
    /// [load](types::FunctionSelector::LOAD) and [default](types::FunctionSelector::DEFAULT).
    /// Response: [`LowPassFilterResponse`]. Affects
    /// [`sensor::ScaledAccel`](crate::sensor::ScaledAccel),
    /// [`sensor::ScaledGyro`](crate::sensor::ScaledGyro),
    /// [`sensor::ScaledMag`](crate::sensor::ScaledMag),
    /// [`sensor::ScaledPressure`](crate::sensor::ScaledPressure),
    /// [`filter_data::CompAccel`](crate::filter_data::CompAccel),
    /// [`filter_data::CompAngularRate`](crate::filter_data::CompAngularRate) and
    /// [`filter_data::LinearAccel`](crate::filter_data::LinearAccel). Devices without it may have
    /// [`ImuLowPassFilter`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 7 more. Requires firmware
    /// later than 1.0.07 on the [3DM-CV7-AHRS](crate::devices::CV7_AHRS) and
    /// [3DM-CV7-AR](crate::devices::CV7_AR). Requires firmware later than 1.0.10 on the
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// - Except for read, a field descriptor of 0 means all fields of the set; if both are 0, all
    ///   sets are meant.
    ///
    /// Source: 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54).
    #[derive(Copy)]
    pub struct LowPassFilter {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Descriptor set of the field.
        pub descriptor_set: Option<crate::DescriptorSet>,
        /// Field descriptor; 0 if the set is 0.
        ///
        /// Refers to fields of [`descriptor_set`](LowPassFilter::descriptor_set).
        pub field_descriptor: Option<u8>,
        /// True if the field is filtered.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub enable: Option<crate::Bool>,
        /// True uses `frequency`; false uses half the rate of the field in the message format.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub manual: Option<crate::Bool>,
        /// Cutoff; a write ignores it if `manual` is false, a read returns the cutoff in use.
        ///
        /// Unit: Hz. Range: at least 0. Required for [write](types::FunctionSelector::WRITE).
        #[cfg_attr(feature = "serde", serde(default, with = "crate::readable"))]
        pub frequency: Option<f32>,
    }
    wire 9 {
        [function selects]
        [descriptor_set for WRITE READ SAVE LOAD DEFAULT]
        [field_descriptor for WRITE READ SAVE LOAD DEFAULT]
        [enable for WRITE]
        [manual for WRITE]
        [frequency for WRITE]
    }
}

ranges! {
    LowPassFilter
    frequency "frequency" in "at least 0" From 0.0;
}

constructors! {
    LowPassFilter

    /// Apply the new setting.
    fn write(
        descriptor_set: impl Into<crate::DescriptorSet>,
        field_descriptor: u8,
        enable: bool,
        manual: bool,
        frequency: f32,
    ) -> WriteCall;

    /// Return the current setting in a response.
    fn read(descriptor_set: impl Into<crate::DescriptorSet>, field_descriptor: u8) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(descriptor_set: impl Into<crate::DescriptorSet>, field_descriptor: u8) -> SaveCall;

    /// Load the saved setting.
    fn load(descriptor_set: impl Into<crate::DescriptorSet>, field_descriptor: u8) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(descriptor_set: impl Into<crate::DescriptorSet>, field_descriptor: u8) -> LoadDefaultCall;
}

field! {
    LowPassFilter: 0x54, "3dm.low_pass_filter";
    in [0x0C];
}

command! {
    LowPassFilter -> Option<LowPassFilterResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> LowPassFilterResponse;
    responds LowPassFilterResponse for READ;
    checks Ranged;
}

change! {
    LowPassFilterResponse -> WriteCall LowPassFilter
    [descriptor_set field_descriptor enable manual frequency]
}

record! {
    /// Data stream format (0x0C,0x60).
    ///
    /// Selects MIP data or the raw data of a sensor for a stream.
    ///
    /// No device is known for certain to support it. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`DataStreamFormatResponse`]. Known
    /// only from the MIP SDK of 2014 and MicroStrain Communication Library. Uncertain: A comment in
    /// the SDK of 2014 restricts it to the 3DM-GX3-35; no other source lists devices. Uncertain:
    /// Functions other than write are assumed not to require `format`. The SDK of 2014 sends both
    /// parameters with every function, and a 0 in place of `format`.
    ///
    /// - In the wrapped format, packets of the sensor arrive in fields of the data sets:
    ///   `sensor.aspp` and `sensor.gxsb` for the IMU, `gnss_data.nmea` and `gnss_data.ubx` for the
    ///   receiver.
    ///
    /// Source: mip-sdk-2014: Data stream format (0x0C,0x60); mscl: Data stream format (0x0C,0x60).
    #[derive(Copy, Eq, Hash)]
    pub struct DataStreamFormat {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// Stream whose format is set or read.
        pub stream: Option<InternalSensor>,
        /// Format of a data stream.
        pub format: Option<StreamFormat>,
    }
    wire 3 {
        [function selects]
        [stream for WRITE READ SAVE LOAD DEFAULT]
        [format for WRITE READ SAVE LOAD DEFAULT]
    }
}

constructors! {
    DataStreamFormat

    /// Apply the new setting.
    fn write(stream: InternalSensor, format: StreamFormat) -> WriteCall;

    /// Return the current setting in a response.
    fn read(stream: InternalSensor, format: StreamFormat) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(stream: InternalSensor, format: StreamFormat) -> SaveCall;

    /// Load the saved setting.
    fn load(stream: InternalSensor, format: StreamFormat) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(stream: InternalSensor, format: StreamFormat) -> LoadDefaultCall;
}

field! {
    DataStreamFormat: 0x60, "3dm.data_stream_format";
    in [0x0C];
}

command! {
    DataStreamFormat -> Option<DataStreamFormatResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> DataStreamFormatResponse;
    responds DataStreamFormatResponse for READ;
}

change! {
    DataStreamFormatResponse -> WriteCall DataStreamFormat
    [stream format]
}

record! {
    /// Device power state (0x0C,0x61).
    ///
    /// Sets the power state of an internal sensor.
    ///
    /// No device is known for certain to support it. Functions:
    /// [write](types::FunctionSelector::WRITE), [read](types::FunctionSelector::READ),
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Response: [`DevicePowerStateResponse`]. The
    /// device may take 5 s to reply. Known only from the MIP SDK of 2014 and MicroStrain
    /// Communication Library. Uncertain: A comment in the SDK of 2014 names the 3DM-GX3-25 and the
    /// 3DM-GX3-35; no other source lists devices. Uncertain: The time-out of 5 s is assumed; the
    /// SDK of 2014 uses one that is longer than usual. Uncertain: Functions other than write are
    /// assumed not to require `state`. The SDK of 2014 sends `device` with every function, and a 0
    /// in place of `state`.
    ///
    /// Source: mip-sdk-2014: Device power state (0x0C,0x61); mscl: Device power state (0x0C,0x61).
    #[derive(Copy, Eq, Hash)]
    pub struct DevicePowerState {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
        /// The sensor.
        ///
        /// On the [3DM-GX3-15](crate::devices::GX3_15) and [3DM-GX3-25](crate::devices::GX3_25):
        /// only [`InternalSensor::IMU`].
        pub device: Option<InternalSensor>,
        /// Power state of an internal sensor.
        ///
        /// Required for [write](types::FunctionSelector::WRITE).
        pub state: Option<SensorPowerState>,
    }
    wire 3 {
        [function selects]
        [device for WRITE READ SAVE LOAD DEFAULT]
        [state for WRITE]
    }
}

constructors! {
    DevicePowerState

    /// Apply the new setting.
    fn write(device: InternalSensor, state: SensorPowerState) -> WriteCall;

    /// Return the current setting in a response.
    fn read(device: InternalSensor) -> ReadCall;

    /// Save the current setting to non-volatile memory.
    fn save(device: InternalSensor) -> SaveCall;

    /// Load the saved setting.
    fn load(device: InternalSensor) -> LoadCall;

    /// Load the factory default setting.
    fn load_default(device: InternalSensor) -> LoadDefaultCall;
}

field! {
    DevicePowerState: 0x61, "3dm.device_power_state";
    in [0x0C];
}

command! {
    DevicePowerState -> Option<DevicePowerStateResponse>;
    for WRITE SAVE LOAD DEFAULT -> ();
    for READ -> DevicePowerStateResponse;
    responds DevicePowerStateResponse for READ;
    timeout 5000;
}

change! {
    DevicePowerStateResponse -> WriteCall DevicePowerState
    [device state]
}

record! {
    /// GPS advanced settings (0x0C,0x62).
    ///
    /// Saves, loads or resets the settings of the GNSS receiver that were made in direct mode.
    ///
    /// No device is known for certain to support it. For advanced use. Functions:
    /// [save](types::FunctionSelector::SAVE), [load](types::FunctionSelector::LOAD) and
    /// [default](types::FunctionSelector::DEFAULT). Known only from the MIP SDK of 2014 and
    /// MicroStrain Communication Library. Requires a receiver. Uncertain: A comment in the SDK of
    /// 2014 names the 3DM-GX3-35; no other source lists devices.
    ///
    /// - In direct mode, your program configures the u-blox receiver with its own protocol; see
    ///   [`system::CommMode`](crate::system::CommMode).
    ///
    /// Source: mip-sdk-2014: GPS advanced settings (0x0C,0x62); mscl: GPS advanced settings
    /// (0x0C,0x62).
    #[derive(Copy, Eq, Hash)]
    pub struct GpsAdvancedSettings {
        /// Operation on the setting.
        pub function: types::FunctionSelector,
    }
    wire 1 {
        [function selects]
    }
}

constructors! {
    GpsAdvancedSettings

    /// Save the current setting to non-volatile memory.
    fn save() -> SaveCall;

    /// Load the saved setting.
    fn load() -> LoadCall;

    /// Load the factory default setting.
    fn load_default() -> LoadDefaultCall;
}

field! {
    GpsAdvancedSettings: 0x62, "3dm.gps_advanced_settings";
    in [0x0C];
}

command! {
    GpsAdvancedSettings -> ();
    for SAVE LOAD DEFAULT -> ();
}

record! {
    /// Device status (0x0C,0x64).
    ///
    /// Gets the state of the device, in basic form or with counters.
    ///
    /// For advanced use. Response: [`DeviceStatusBasicRq1ImuResponse`],
    /// [`DeviceStatusBasicResponse`], [`DeviceStatusBasicWithoutStateResponse`],
    /// [`DeviceStatusDiagnosticResponse`], [`DeviceStatusDiagnosticGnssResponse`],
    /// [`DeviceStatusDiagnosticGq4_45Response`], [`DeviceStatusDiagnosticRq1_45Response`],
    /// [`DeviceStatusDiagnosticGx4Response`], [`DeviceStatusDiagnosticImuResponse`],
    /// [`DeviceStatusDiagnosticGx4ImuResponse`], [`DeviceStatusDiagnosticRq1ImuResponse`],
    /// [`DeviceStatusBasicGx3Response`] or [`DeviceStatusDiagnosticGx3Response`]. Confirmed on
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 17 more.
    ///
    /// - The device expects its own model number, which
    ///   [`base::GetDeviceInfo`](crate::base::GetDeviceInfo) returns.
    /// - Device families reply in different layouts. The selector and the length distinguish them.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeviceStatus {
        /// Model number of the device that replies.
        ///
        /// On the [3DM-GX5-15](crate::devices::GX5_15): always 6254. On the
        /// [3DM-GX5-35](crate::devices::GX5_35): always 6252. On the
        /// [3DM-GX5-45](crate::devices::GX5_45): always 6251.
        pub model_number: u16,
        /// Level of detail of the reply.
        pub status_selector: DeviceStatusSelector,
    }
}

constructors! {
    DeviceStatus

    /// Creates the command from its parameters.
    fn new(model_number: u16, status_selector: DeviceStatusSelector);
}

field! {
    DeviceStatus: 0x64, "3dm.device_status";
    in [0x0C];
}

command! {
    DeviceStatus -> DeviceStatusResponses;
    responds DeviceStatusBasicRq1ImuResponse | DeviceStatusBasicResponse | DeviceStatusBasicWithoutStateResponse | DeviceStatusBasicGx3Response, if status_selector = DeviceStatusSelector::BASIC;
    responds DeviceStatusDiagnosticResponse | DeviceStatusDiagnosticGnssResponse | DeviceStatusDiagnosticGq4_45Response | DeviceStatusDiagnosticRq1_45Response | DeviceStatusDiagnosticGx4Response | DeviceStatusDiagnosticImuResponse | DeviceStatusDiagnosticGx4ImuResponse | DeviceStatusDiagnosticRq1ImuResponse | DeviceStatusDiagnosticGx3Response, if status_selector = DeviceStatusSelector::DIAGNOSTIC;
}

responses! {
    /// The response to [`DeviceStatus`].
    pub enum DeviceStatusResponses {
        /// The response [`DeviceStatusBasicRq1ImuResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_basic_rq1_imu_response"))]
        BasicRq1Imu(DeviceStatusBasicRq1ImuResponse),
        /// The response [`DeviceStatusBasicResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_basic_response"))]
        Basic(DeviceStatusBasicResponse),
        /// The response [`DeviceStatusBasicWithoutStateResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_basic_without_state_response"))]
        BasicWithoutState(DeviceStatusBasicWithoutStateResponse),
        /// The response [`DeviceStatusDiagnosticResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_response"))]
        Diagnostic(DeviceStatusDiagnosticResponse),
        /// The response [`DeviceStatusDiagnosticGnssResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_gnss_response"))]
        DiagnosticGnss(DeviceStatusDiagnosticGnssResponse),
        /// The response [`DeviceStatusDiagnosticGq4_45Response`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_gq4_45_response"))]
        DiagnosticGq4_45(DeviceStatusDiagnosticGq4_45Response),
        /// The response [`DeviceStatusDiagnosticRq1_45Response`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_rq1_45_response"))]
        DiagnosticRq1_45(DeviceStatusDiagnosticRq1_45Response),
        /// The response [`DeviceStatusDiagnosticGx4Response`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_gx4_response"))]
        DiagnosticGx4(DeviceStatusDiagnosticGx4Response),
        /// The response [`DeviceStatusDiagnosticImuResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_imu_response"))]
        DiagnosticImu(DeviceStatusDiagnosticImuResponse),
        /// The response [`DeviceStatusDiagnosticGx4ImuResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_gx4_imu_response"))]
        DiagnosticGx4Imu(DeviceStatusDiagnosticGx4ImuResponse),
        /// The response [`DeviceStatusDiagnosticRq1ImuResponse`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_rq1_imu_response"))]
        DiagnosticRq1Imu(DeviceStatusDiagnosticRq1ImuResponse),
        /// The response [`DeviceStatusBasicGx3Response`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_basic_gx3_response"))]
        BasicGx3(DeviceStatusBasicGx3Response),
        /// The response [`DeviceStatusDiagnosticGx3Response`].
        #[cfg_attr(feature = "serde", serde(rename = "device_status_diagnostic_gx3_response"))]
        DiagnosticGx3(DeviceStatusDiagnosticGx3Response),
    }
}

record! {
    /// IMU message format response (0x0C,0x80).
    ///
    /// Response to [`ImuMessageFormat`]. Confirmed on [3DM-CV5-10](crate::devices::CV5_10),
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 14 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](ImuMessageFormatResponse::descriptors).
    ///
    /// Source: 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08).
    #[derive(Default, Eq, Hash)]
    pub struct ImuMessageFormatResponse {
        /// Fields and decimations.
        ///
        /// Refers to fields of Sensor data.
        pub descriptors: crate::List<types::DescriptorRate, 84>,
    }
    wire 253 {
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    ImuMessageFormatResponse

    /// Creates it from its values.
    fn new(descriptors: impl Into<crate::List<types::DescriptorRate, 84>>);
}

field! {
    ImuMessageFormatResponse: 0x80, "3dm.imu_message_format_response";
    in [0x0C];
    answers ImuMessageFormat;
}

record! {
    /// GNSS message format response (0x0C,0x81).
    ///
    /// Response to [`GnssMessageFormat`]. Confirmed on [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 4 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](GnssMessageFormatResponse::descriptors). Range: 0 to 82.
    ///
    /// Source: mip-sdk-4: GNSS message format (0x0C,0x09); 3dm-gx5-35: 4.2.6 GNSS Message Format
    /// (0x0C, 0x09).
    #[derive(Default, Eq, Hash)]
    pub struct GnssMessageFormatResponse {
        /// Fields and decimations.
        ///
        /// Refers to fields of GNSS data.
        pub descriptors: crate::List<types::DescriptorRate, 84>,
    }
    wire 253 {
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    GnssMessageFormatResponse

    /// Creates it from its values.
    fn new(descriptors: impl Into<crate::List<types::DescriptorRate, 84>>);
}

field! {
    GnssMessageFormatResponse: 0x81, "3dm.gnss_message_format_response";
    in [0x0C];
    answers GnssMessageFormat;
}

record! {
    /// Estimation filter message format response (0x0C,0x82).
    ///
    /// Response to [`FilterMessageFormat`]. Confirmed on [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 9 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](FilterMessageFormatResponse::descriptors).
    ///
    /// Source: 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A).
    #[derive(Default, Eq, Hash)]
    pub struct FilterMessageFormatResponse {
        /// Fields and decimations.
        ///
        /// Refers to fields of Filter data.
        pub descriptors: crate::List<types::DescriptorRate, 84>,
    }
    wire 253 {
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    FilterMessageFormatResponse

    /// Creates it from its values.
    fn new(descriptors: impl Into<crate::List<types::DescriptorRate, 84>>);
}

field! {
    FilterMessageFormatResponse: 0x82, "3dm.filter_message_format_response";
    in [0x0C];
    answers FilterMessageFormat;
}

record! {
    /// Get IMU data base rate response (0x0C,0x83).
    ///
    /// Also called `imu_get_base_rate_response`. Response to [`GetImuBaseRate`]. Confirmed on
    /// [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CX5-10](crate::devices::CX5_10), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 15 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetImuBaseRateResponse {
        /// Base rate of the sensor data.
        ///
        /// Unit: Hz.
        pub rate: u16,
    }
}

view! {
    GetImuBaseRateResponse
    rate: u16, at 0;
}

constructors! {
    GetImuBaseRateResponse

    /// Creates it from its values.
    fn new(rate: u16);
}

field! {
    GetImuBaseRateResponse: 0x83, "3dm.get_imu_base_rate_response";
    in [0x0C];
    answers GetImuBaseRate;
}

record! {
    /// Get GNSS data base rate response (0x0C,0x84).
    ///
    /// Also called `gnss_get_base_rate_response`. Response to [`GetGnssBaseRate`]. Confirmed on
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-35](crate::devices::GX5_35),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 4 more. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss Get Base Rate (0x0C,0x07).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetGnssBaseRateResponse {
        /// Base rate of the GNSS data.
        ///
        /// Unit: Hz.
        pub rate: u16,
    }
}

view! {
    GetGnssBaseRateResponse
    rate: u16, at 0;
}

constructors! {
    GetGnssBaseRateResponse

    /// Creates it from its values.
    fn new(rate: u16);
}

field! {
    GetGnssBaseRateResponse: 0x84, "3dm.get_gnss_base_rate_response";
    in [0x0C];
    answers GetGnssBaseRate;
}

record! {
    /// Data stream control response (0x0C,0x85).
    ///
    /// Also called `datastream_control_response`. Response to [`DataStreamControl`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 25 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11);
    /// 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DataStreamControlResponse {
        /// Stream specified in the command.
        ///
        /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
        /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
        /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
        /// [3DM-GX3-15](crate::devices::GX3_15), [3DM-GX3-25](crate::devices::GX3_25),
        /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
        /// [3DM-GX5-25](crate::devices::GX5_25) and [3DM-MV5-AR](crate::devices::MV5_AR): values of
        /// [`LegacyDataStream`]; only [`LegacyDataStream::ALL_STREAMS`], [`LegacyDataStream::IMU`]
        /// and [`LegacyDataStream::FILTER`]. On the [3DM-CX5-45](crate::devices::CX5_45),
        /// [3DM-DH3](crate::devices::DH3), [3DM-GQ4-45](crate::devices::GQ4_45),
        /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
        /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
        /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
        /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST)
        /// and [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of [`LegacyDataStream`]. On the
        /// [3DM-GX5-15](crate::devices::GX5_15): values of [`LegacyDataStream`]; only
        /// [`LegacyDataStream::IMU`] and [`LegacyDataStream::FILTER`].
        pub descriptor_set: u8,
        /// True if the stream is sent.
        pub enabled: crate::Bool,
    }
}

view! {
    DataStreamControlResponse
    descriptor_set: u8, at 0;
    enabled: crate::Bool, at 1;
}

constructors! {
    DataStreamControlResponse

    /// Creates it from its values.
    fn new(descriptor_set: impl Into<u8>, enabled: bool);
}

#[rustfmt::skip]
impl DataStreamControlResponse {
    /// Reads `descriptor_set` as [`LegacyDataStream`].
    ///
    /// On the [3DM-CV5-10](crate::devices::CV5_10), [3DM-CV5-15](crate::devices::CV5_15),
    /// [3DM-CV5-25](crate::devices::CV5_25), [3DM-CX5-10](crate::devices::CX5_10),
    /// [3DM-CX5-15](crate::devices::CX5_15), [3DM-CX5-25](crate::devices::CX5_25),
    /// [3DM-GX3-15](crate::devices::GX3_15), [3DM-GX3-25](crate::devices::GX3_25),
    /// [3DM-GX4-15](crate::devices::GX4_15), [3DM-GX4-25](crate::devices::GX4_25),
    /// [3DM-GX5-25](crate::devices::GX5_25) and [3DM-MV5-AR](crate::devices::MV5_AR): values of
    /// [`LegacyDataStream`]; only [`LegacyDataStream::ALL_STREAMS`], [`LegacyDataStream::IMU`] and
    /// [`LegacyDataStream::FILTER`]. On the [3DM-CX5-45](crate::devices::CX5_45),
    /// [3DM-DH3](crate::devices::DH3), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX3-35](crate::devices::GX3_35), [3DM-GX3-45](crate::devices::GX3_45),
    /// [3DM-GX4-45](crate::devices::GX4_45), [3DM-GX4-IMU](crate::devices::GX4_IMU),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT), [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST) and
    /// [3DM-RQ1-IMU](crate::devices::RQ1_IMU): values of [`LegacyDataStream`]. On the
    /// [3DM-GX5-15](crate::devices::GX5_15): values of [`LegacyDataStream`]; only
    /// [`LegacyDataStream::IMU`] and [`LegacyDataStream::FILTER`].
    #[inline]
    #[must_use]
    pub fn descriptor_set_as_legacy_data_stream(&self) -> LegacyDataStream {
        self.descriptor_set.into()
    }
}

field! {
    DataStreamControlResponse: 0x85, "3dm.data_stream_control_response";
    in [0x0C];
    answers DataStreamControl;
}

record! {
    /// IMU signal conditioning response (0x0C,0x86).
    ///
    /// No device is known for certain to support it. Response to [`ImuSignalConditioning`]. Known
    /// only from the MIP SDK of 2014 and MicroStrain Communication Library.
    ///
    /// Source: mip-sdk-2014: IMU signal conditioning (0x0C,0x35); mscl: IMU signal conditioning
    /// (0x0C,0x35).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ImuSignalConditioningResponse {
        /// Divisor of 1000 Hz that sets the rate at which the orientation is computed.
        ///
        /// Unit: 1. Range: 1 to 1000.
        pub orientation_decimation: u16,
        /// Processing steps.
        ///
        /// Default: 3.
        pub data_conditioning_flags: DataConditioningFlags,
        /// Width of the accelerometer and gyroscope filter in samples.
        ///
        /// Unit: 1. Range: 1 to 32. Default: 15.
        pub inertial_filter_width: u8,
        /// Width of the magnetometer filter in samples.
        ///
        /// Unit: 1. Range: 1 to 32. Default: 17.
        pub mag_filter_width: u8,
        /// Time constant of the pitch and roll correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10.
        pub up_compensation: u16,
        /// Time constant of the heading correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10.
        pub north_compensation: u16,
        /// Bandwidth of the magnetometer of 3-series devices.
        pub mag_bandwidth: MagBandwidth,
        /// Reserved.
        pub reserved: u16,
    }
}

view! {
    ImuSignalConditioningResponse
    orientation_decimation: u16, at 0;
    data_conditioning_flags: DataConditioningFlags, at 2;
    inertial_filter_width: u8, at 4;
    mag_filter_width: u8, at 5;
    up_compensation: u16, at 6;
    north_compensation: u16, at 8;
    mag_bandwidth: MagBandwidth, at 10;
    reserved: u16, at 11;
}

constructors! {
    ImuSignalConditioningResponse

    /// Creates it from its values.
    fn new(
        orientation_decimation: u16,
        data_conditioning_flags: DataConditioningFlags,
        inertial_filter_width: u8,
        mag_filter_width: u8,
        up_compensation: u16,
        north_compensation: u16,
        mag_bandwidth: MagBandwidth,
    ), reserved: 0;
}

field! {
    ImuSignalConditioningResponse: 0x86, "3dm.imu_signal_conditioning_response";
    in [0x0C];
    answers ImuSignalConditioning;
}

record! {
    /// UART baud rate response (0x0C,0x87).
    ///
    /// Also called `uart_baudrate_response`. Response to [`UartBaudRate`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 12 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40); 3dm-cv7-gnss-ins: UART Baudrate
    /// (0x0C,0x40).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct UartBaudRateResponse {
        /// New baud rate; the port must support it.
        ///
        /// Unit: Bd.
        pub baud: u32,
    }
}

view! {
    UartBaudRateResponse
    baud: u32, at 0;
}

constructors! {
    UartBaudRateResponse

    /// Creates it from its values.
    fn new(baud: u32);
}

field! {
    UartBaudRateResponse: 0x87, "3dm.uart_baud_rate_response";
    in [0x0C];
    answers UartBaudRate;
}

record! {
    /// Data stream format response (0x0C,0x88).
    ///
    /// No device is known for certain to support it. Response to [`DataStreamFormat`]. Known only
    /// from the MIP SDK of 2014 and MicroStrain Communication Library.
    ///
    /// Source: mip-sdk-2014: Data stream format (0x0C,0x60); mscl: Data stream format (0x0C,0x60).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DataStreamFormatResponse {
        /// Stream whose format is set or read.
        pub stream: InternalSensor,
        /// Format of a data stream.
        pub format: StreamFormat,
    }
}

view! {
    DataStreamFormatResponse
    stream: InternalSensor, at 0;
    format: StreamFormat, at 1;
}

constructors! {
    DataStreamFormatResponse

    /// Creates it from its values.
    fn new(stream: InternalSensor, format: StreamFormat);
}

field! {
    DataStreamFormatResponse: 0x88, "3dm.data_stream_format_response";
    in [0x0C];
    answers DataStreamFormat;
}

record! {
    /// Device power state response (0x0C,0x89).
    ///
    /// No device is known for certain to support it. Response to [`DevicePowerState`]. Known only
    /// from the MIP SDK of 2014 and MicroStrain Communication Library.
    ///
    /// Source: mip-sdk-2014: Device power state (0x0C,0x61); mscl: Device power state (0x0C,0x61).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DevicePowerStateResponse {
        /// The sensor.
        pub device: InternalSensor,
        /// Power state of an internal sensor.
        pub state: SensorPowerState,
    }
}

view! {
    DevicePowerStateResponse
    device: InternalSensor, at 0;
    state: SensorPowerState, at 1;
}

constructors! {
    DevicePowerStateResponse

    /// Creates it from its values.
    fn new(device: InternalSensor, state: SensorPowerState);
}

field! {
    DevicePowerStateResponse: 0x89, "3dm.device_power_state_response";
    in [0x0C];
    answers DevicePowerState;
}

record! {
    /// Get estimation filter data base rate response (0x0C,0x8A).
    ///
    /// Also called `filter_get_base_rate_response`. Response to [`GetFilterBaseRate`]. Confirmed on
    /// [3DM-CV5-15](crate::devices::CV5_15), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 9 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetFilterBaseRateResponse {
        /// Base rate of the filter data.
        ///
        /// Unit: Hz.
        pub rate: u16,
    }
}

view! {
    GetFilterBaseRateResponse
    rate: u16, at 0;
}

constructors! {
    GetFilterBaseRateResponse

    /// Creates it from its values.
    fn new(rate: u16);
}

field! {
    GetFilterBaseRateResponse: 0x8A, "3dm.get_filter_base_rate_response";
    in [0x0C];
    answers GetFilterBaseRate;
}

record! {
    /// Advanced low-pass filter settings response (0x0C,0x8B).
    ///
    /// Also called `imu_lowpass_filter_response`. Response to [`ImuLowPassFilter`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 20 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50); 3dm-cv7-gnss-ins:
    /// Advanced Low-Pass Filter Settings (0x0C,0x50).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ImuLowPassFilterResponse {
        /// Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
        /// magnetic field 0x06 or pressure 0x17.
        ///
        /// Refers to fields of Sensor data.
        pub target_descriptor: u8,
        /// True if the quantity is filtered.
        ///
        /// Default: true.
        pub enable: crate::Bool,
        /// True uses `frequency`; false uses half the rate of the message format.
        ///
        /// Default: false.
        pub manual: crate::Bool,
        /// Cutoff (-3 dB). It has no meaning if `manual` is false.
        ///
        /// Unit: Hz.
        pub frequency: u16,
        /// Reserved.
        pub reserved: u8,
    }
}

view! {
    ImuLowPassFilterResponse
    target_descriptor: u8, at 0;
    enable: crate::Bool, at 1;
    manual: crate::Bool, at 2;
    frequency: u16, at 3;
    reserved: u8, at 5;
}

constructors! {
    ImuLowPassFilterResponse

    /// Creates it from its values.
    fn new(
        target_descriptor: u8,
        enable: bool,
        manual: bool,
        frequency: u16,
    ), reserved: 0;
}

field! {
    ImuLowPassFilterResponse: 0x8B, "3dm.imu_low_pass_filter_response";
    in [0x0C];
    answers ImuLowPassFilter;
}

record! {
    /// NMEA message format response (0x0C,0x8C).
    ///
    /// Response to [`NmeaMessageFormat`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 4 more.
    ///
    /// The wire format also contains `count`: Number of sentences. Counts the elements of
    /// [`format_entries`](NmeaMessageFormatResponse::format_entries).
    ///
    /// Source: 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C).
    #[derive(Default, Eq, Hash)]
    pub struct NmeaMessageFormatResponse {
        /// Sentences to stream.
        pub format_entries: crate::List<types::NmeaMessage, 50>,
    }
    wire 251 {
        [count: u8 counts format_entries]
        [format_entries by count]
    }
}

constructors! {
    NmeaMessageFormatResponse

    /// Creates it from its values.
    fn new(format_entries: impl Into<crate::List<types::NmeaMessage, 50>>);
}

field! {
    NmeaMessageFormatResponse: 0x8C, "3dm.nmea_message_format_response";
    in [0x0C];
    answers NmeaMessageFormat;
}

record! {
    /// Get data base rate response (0x0C,0x8E).
    ///
    /// Response to [`GetBaseRate`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR), [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 7 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GetBaseRateResponse {
        /// Data descriptor set specified in the command.
        pub descriptor_set: crate::DescriptorSet,
        /// Base rate; 0 if the rate is variable or unknown and data is sent as it arrives.
        ///
        /// Unit: Hz.
        pub rate: u16,
    }
}

view! {
    GetBaseRateResponse
    descriptor_set: crate::DescriptorSet, at 0;
    rate: u16, at 1;
}

constructors! {
    GetBaseRateResponse

    /// Creates it from its values.
    fn new(descriptor_set: impl Into<crate::DescriptorSet>, rate: u16);
}

field! {
    GetBaseRateResponse: 0x8E, "3dm.get_base_rate_response";
    in [0x0C];
    answers GetBaseRate;
}

record! {
    /// Message format response (0x0C,0x8F).
    ///
    /// Response to [`MessageFormat`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `num_descriptors`: Number of fields. Counts the elements of
    /// [`descriptors`](MessageFormatResponse::descriptors).
    ///
    /// Source: 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F).
    #[derive(Default, Eq, Hash)]
    pub struct MessageFormatResponse {
        /// Data descriptor set.
        pub descriptor_set: crate::DescriptorSet,
        /// Fields and decimations.
        ///
        /// Refers to fields of [`descriptor_set`](MessageFormatResponse::descriptor_set).
        pub descriptors: crate::List<types::DescriptorRate, 83>,
    }
    wire 251 {
        [descriptor_set]
        [num_descriptors: u8 counts descriptors]
        [descriptors by num_descriptors]
    }
}

constructors! {
    MessageFormatResponse

    /// Creates it from its values.
    fn new(descriptor_set: impl Into<crate::DescriptorSet>, descriptors: impl Into<crate::List<types::DescriptorRate, 83>>);
}

field! {
    MessageFormatResponse: 0x8F, "3dm.message_format_response";
    in [0x0C];
    answers MessageFormat;
}

record! {
    /// Basic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).
    ///
    /// Timer only, in microseconds.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::BASIC`].
    /// Uncertain: The SDK of 2014 lists the names of the values and the unit of the timer; the
    /// descriptions are inferred from the names.
    ///
    /// The wire format also contains `model_number`: Model number of the inertial sensor. Always
    /// 6238.
    ///
    /// The wire format also contains `status_selector`: Basic status. Always 1.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeviceStatusBasicRq1ImuResponse {
        /// Reserved.
        pub status_flags: u32,
        /// Time since start-up.
        ///
        /// Unit: us.
        pub system_timer: u64,
    }
    wire 15 {
        [model_number: u16 = 6238]
        [status_selector: u8 = 1]
        [status_flags]
        [system_timer]
    }
}

constructors! {
    DeviceStatusBasicRq1ImuResponse

    /// Creates it from its values.
    fn new(status_flags: u32, system_timer: u64);
}

field! {
    DeviceStatusBasicRq1ImuResponse: 0x90, "3dm.device_status_basic_rq1_imu_response";
    in [0x0C];
    constants [0: 24 94] [2: 1];
    sizes 15..=usize::MAX;
    answers DeviceStatus;
}

record! {
    /// Basic device status (0x0C,0x90).
    ///
    /// State and timer.
    ///
    /// Response to [`DeviceStatus`]. The size of its data distinguishes it from
    /// [`DeviceStatusBasicWithoutStateResponse`] and [`DeviceStatusBasicGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::BASIC`].
    /// Confirmed on [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-GX5-45](crate::devices::GX5_45),
    /// [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST);
    /// likely or assumed on 9 more.
    ///
    /// The wire format also contains `status_selector`: Basic status. Always 1.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeviceStatusBasicResponse {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// State of the system; the meaning of its values is not documented.
        ///
        /// On the [3DM-GX4-45](crate::devices::GX4_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT)
        /// and [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): values of [`Gx4SystemState`].
        pub system_state: u16,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
    }
    wire 13 {
        [model_number]
        [status_selector: u8 = 1]
        [status_flags]
        [system_state]
        [system_timer]
    }
}

constructors! {
    DeviceStatusBasicResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_state: u16,
        system_timer: u32,
    );
}

#[rustfmt::skip]
impl DeviceStatusBasicResponse {
    /// Reads `system_state` as [`Gx4SystemState`].
    ///
    /// On the [3DM-GX4-45](crate::devices::GX4_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST): values of [`Gx4SystemState`].
    #[inline]
    #[must_use]
    pub fn system_state_as_gx4_system_state(&self) -> Gx4SystemState {
        self.system_state.into()
    }
}

field! {
    DeviceStatusBasicResponse: 0x90, "3dm.device_status_basic_response";
    in [0x0C];
    constants [2: 1];
    sizes 13..=14;
    answers DeviceStatus;
}

record! {
    /// Basic device status (without state) (0x0C,0x90).
    ///
    /// Timer only.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusBasicResponse`] and
    /// [`DeviceStatusBasicGx3Response`]. Sent if [`status_selector`](DeviceStatus::status_selector)
    /// is [`DeviceStatusSelector::BASIC`]. Uncertain: MSCL uses it for the 3DM-GX4-15, 3DM-GX4-25,
    /// 3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10, the SDK of 2014 for the 3DM-GX4-15, the 3DM-GX4-25
    /// and the inertial sensor of the 3DM-GX4-45; that the 3DM-CL5-10 has it is inferred.
    /// Uncertain: The manual of the 3DM-GX5-45 documents it too, but for the model number of
    /// another device; MSCL uses the layout with a state for that device.
    ///
    /// The wire format also contains `status_selector`: Basic status. Always 1.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeviceStatusBasicWithoutStateResponse {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
    }
    wire 11 {
        [model_number]
        [status_selector: u8 = 1]
        [status_flags]
        [system_timer]
    }
}

constructors! {
    DeviceStatusBasicWithoutStateResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_timer: u32,
    );
}

field! {
    DeviceStatusBasicWithoutStateResponse: 0x90, "3dm.device_status_basic_without_state_response";
    in [0x0C];
    constants [2: 1];
    sizes 0..=12;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (0x0C,0x90).
    ///
    /// State, timer, and the counters of streams and port.
    ///
    /// Response to [`DeviceStatus`]. The size of its data distinguishes it from
    /// [`DeviceStatusDiagnosticGnssResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticGx4ImuResponse`],
    /// [`DeviceStatusDiagnosticRq1ImuResponse`] and [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Confirmed on [3DM-GX5-15](crate::devices::GX5_15); likely or assumed on 7 more.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeviceStatusDiagnosticResponse {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// State of the system; the meaning of its values is not documented.
        pub system_state: u16,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// True if filter data is streamed.
        pub filter_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// Filter data packets that were not sent.
        ///
        /// Unit: 1.
        pub filter_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
        /// IMU messages that could not be parsed.
        ///
        /// Unit: 1.
        pub imu_parser_errors: u32,
        /// IMU messages that were read.
        ///
        /// Unit: 1.
        pub imu_message_count: u32,
        /// System timer at the last IMU message.
        ///
        /// Unit: ms.
        pub imu_last_message_time: u32,
    }
    wire 51 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_state]
        [system_timer]
        [imu_stream_enabled]
        [filter_stream_enabled]
        [imu_dropped_packets]
        [filter_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
        [imu_parser_errors]
        [imu_message_count]
        [imu_last_message_time]
    }
}

constructors! {
    DeviceStatusDiagnosticResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_state: u16,
        system_timer: u32,
        imu_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: u32,
        filter_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
        imu_parser_errors: u32,
        imu_message_count: u32,
        imu_last_message_time: u32,
    );
}

field! {
    DeviceStatusDiagnosticResponse: 0x90, "3dm.device_status_diagnostic_response";
    in [0x0C];
    constants [2: 2];
    sizes 0..=59;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (with GNSS) (0x0C,0x90).
    ///
    /// State, timer, and the counters of pulses, streams, port and receiver.
    ///
    /// Response to [`DeviceStatus`]. The size of its data distinguishes it from
    /// [`DeviceStatusDiagnosticResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticGx4ImuResponse`],
    /// [`DeviceStatusDiagnosticRq1ImuResponse`] and [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Confirmed on [3DM-GX5-35](crate::devices::GX5_35) and [3DM-GX5-45](crate::devices::GX5_45);
    /// likely or assumed on 2 more. Uncertain: MSCL uses it for the 3DM-GX4-45 and the -35 and -45
    /// of GX5 and CX5; its length is from a manual. Uncertain: MSCL lists only the names of the
    /// values, from which the descriptions are inferred; the times are assumed to be in ms like the
    /// system timer.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Default, Eq, Hash)]
    pub struct DeviceStatusDiagnosticGnssResponse {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// State of the system; the meaning of its values is not documented.
        pub system_state: u16,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// Power state of the GNSS receiver.
        pub gnss_power_state: u8,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// True if GNSS data is streamed.
        pub gnss_stream_enabled: crate::Bool,
        /// True if filter data is streamed.
        pub filter_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// GNSS data packets that were not sent.
        ///
        /// Unit: 1.
        pub gnss_dropped_packets: u32,
        /// Filter data packets that were not sent.
        ///
        /// Unit: 1.
        pub filter_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
        /// IMU messages that could not be parsed.
        ///
        /// Unit: 1.
        pub imu_parser_errors: u32,
        /// IMU messages that were read.
        ///
        /// Unit: 1.
        pub imu_message_count: u32,
        /// System timer at the last IMU message.
        ///
        /// Unit: ms.
        pub imu_last_message_time: u32,
        /// Receiver messages that could not be parsed.
        ///
        /// Unit: 1.
        pub gnss_parser_errors: u32,
        /// Receiver messages that were read.
        ///
        /// Unit: 1.
        pub gnss_message_count: u32,
        /// System timer at the last receiver message.
        ///
        /// Unit: ms.
        pub gnss_last_message_time: u32,
    }
    wire 77 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_state]
        [system_timer]
        [gnss_power_state]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [gnss_stream_enabled]
        [filter_stream_enabled]
        [imu_dropped_packets]
        [gnss_dropped_packets]
        [filter_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
        [imu_parser_errors]
        [imu_message_count]
        [imu_last_message_time]
        [gnss_parser_errors]
        [gnss_message_count]
        [gnss_last_message_time]
    }
}

constructors! {
    DeviceStatusDiagnosticGnssResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_state: u16,
        system_timer: u32,
        gnss_power_state: u8,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        gnss_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: u32,
        gnss_dropped_packets: u32,
        filter_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
        imu_parser_errors: u32,
        imu_message_count: u32,
        imu_last_message_time: u32,
        gnss_parser_errors: u32,
        gnss_message_count: u32,
        gnss_last_message_time: u32,
    );
}

field! {
    DeviceStatusDiagnosticGnssResponse: 0x90, "3dm.device_status_diagnostic_gnss_response";
    in [0x0C];
    constants [2: 2];
    sizes 77..=79;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (3DM-GQ4-45) (0x0C,0x90).
    ///
    /// The layout with GNSS, plus flags for parts that could not be started.
    ///
    /// Response to [`DeviceStatus`]. The size of its data distinguishes it from
    /// [`DeviceStatusDiagnosticResponse`], [`DeviceStatusDiagnosticGnssResponse`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticGx4ImuResponse`],
    /// [`DeviceStatusDiagnosticRq1ImuResponse`] and [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Supported by [3DM-GQ4-45](crate::devices::GQ4_45). Uncertain: No known manual documents it.
    /// Uncertain: MSCL lists only the names of the values, from which the descriptions are
    /// inferred; the times are assumed to be in ms like the system timer.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Default, Eq, Hash)]
    pub struct DeviceStatusDiagnosticGq4_45Response {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// State of the system; the meaning of its values is not documented.
        pub system_state: u16,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// Power state of the GNSS receiver.
        pub gnss_power_state: u8,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// True if GNSS data is streamed.
        pub gnss_stream_enabled: crate::Bool,
        /// True if filter data is streamed.
        pub filter_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// GNSS data packets that were not sent.
        ///
        /// Unit: 1.
        pub gnss_dropped_packets: u32,
        /// Filter data packets that were not sent.
        ///
        /// Unit: 1.
        pub filter_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
        /// IMU messages that could not be parsed.
        ///
        /// Unit: 1.
        pub imu_parser_errors: u32,
        /// IMU messages that were read.
        ///
        /// Unit: 1.
        pub imu_message_count: u32,
        /// System timer at the last IMU message.
        ///
        /// Unit: ms.
        pub imu_last_message_time: u32,
        /// Receiver messages that could not be parsed.
        ///
        /// Unit: 1.
        pub gnss_parser_errors: u32,
        /// Receiver messages that were read.
        ///
        /// Unit: 1.
        pub gnss_message_count: u32,
        /// System timer at the last receiver message.
        ///
        /// Unit: ms.
        pub gnss_last_message_time: u32,
        /// True if the magnetometer could not be started.
        pub mag_init_failed: crate::Bool,
        /// True if the pressure sensor could not be started.
        pub pressure_init_failed: crate::Bool,
        /// True if the GNSS receiver could not be started.
        pub receiver_init_failed: crate::Bool,
    }
    wire 80 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_state]
        [system_timer]
        [gnss_power_state]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [gnss_stream_enabled]
        [filter_stream_enabled]
        [imu_dropped_packets]
        [gnss_dropped_packets]
        [filter_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
        [imu_parser_errors]
        [imu_message_count]
        [imu_last_message_time]
        [gnss_parser_errors]
        [gnss_message_count]
        [gnss_last_message_time]
        [mag_init_failed]
        [pressure_init_failed]
        [receiver_init_failed]
    }
}

constructors! {
    DeviceStatusDiagnosticGq4_45Response

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_state: u16,
        system_timer: u32,
        gnss_power_state: u8,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        gnss_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: u32,
        gnss_dropped_packets: u32,
        filter_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
        imu_parser_errors: u32,
        imu_message_count: u32,
        imu_last_message_time: u32,
        gnss_parser_errors: u32,
        gnss_message_count: u32,
        gnss_last_message_time: u32,
        mag_init_failed: bool,
        pressure_init_failed: bool,
        receiver_init_failed: bool,
    );
}

field! {
    DeviceStatusDiagnosticGq4_45Response: 0x90, "3dm.device_status_diagnostic_gq4_45_response";
    in [0x0C];
    constants [2: 2];
    sizes 80..=85;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (3DM-RQ1-45) (0x0C,0x90).
    ///
    /// The layout with GNSS, plus the temperature.
    ///
    /// Response to [`DeviceStatus`]. The size of its data distinguishes it from
    /// [`DeviceStatusDiagnosticResponse`], [`DeviceStatusDiagnosticGnssResponse`],
    /// [`DeviceStatusDiagnosticGq4_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticGx4ImuResponse`],
    /// [`DeviceStatusDiagnosticRq1ImuResponse`] and [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Supported by [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST). Uncertain: No known manual documents it.
    /// Uncertain: MSCL lists only the names of the values, from which the descriptions are
    /// inferred; the times are assumed to be in ms like the system timer.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Default)]
    pub struct DeviceStatusDiagnosticRq1_45Response {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// State of the system; the meaning of its values is not documented.
        pub system_state: u16,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// Power state of the GNSS receiver.
        pub gnss_power_state: u8,
        /// True if the receiver starts cold at power-up.
        pub cold_start_on_power_on: u8,
        /// Temperature of the board.
        ///
        /// Unit: degC. Uncertain: The unit is inferred.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub temperature: f32,
        /// System timer at the last temperature measurement.
        ///
        /// Unit: ms.
        pub temperature_last_time: u32,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// True if GNSS data is streamed.
        pub gnss_stream_enabled: crate::Bool,
        /// True if filter data is streamed.
        pub filter_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// GNSS data packets that were not sent.
        ///
        /// Unit: 1.
        pub gnss_dropped_packets: u32,
        /// Filter data packets that were not sent.
        ///
        /// Unit: 1.
        pub filter_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
        /// IMU messages that could not be parsed.
        ///
        /// Unit: 1.
        pub imu_parser_errors: u32,
        /// IMU messages that were read.
        ///
        /// Unit: 1.
        pub imu_message_count: u32,
        /// System timer at the last IMU message.
        ///
        /// Unit: ms.
        pub imu_last_message_time: u32,
        /// Receiver messages that could not be parsed.
        ///
        /// Unit: 1.
        pub gnss_parser_errors: u32,
        /// Receiver messages that were read.
        ///
        /// Unit: 1.
        pub gnss_message_count: u32,
        /// System timer at the last receiver message.
        ///
        /// Unit: ms.
        pub gnss_last_message_time: u32,
    }
    wire 86 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_state]
        [system_timer]
        [gnss_power_state]
        [cold_start_on_power_on]
        [temperature]
        [temperature_last_time]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [gnss_stream_enabled]
        [filter_stream_enabled]
        [imu_dropped_packets]
        [gnss_dropped_packets]
        [filter_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
        [imu_parser_errors]
        [imu_message_count]
        [imu_last_message_time]
        [gnss_parser_errors]
        [gnss_message_count]
        [gnss_last_message_time]
    }
}

constructors! {
    DeviceStatusDiagnosticRq1_45Response

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_state: u16,
        system_timer: u32,
        gnss_power_state: u8,
        cold_start_on_power_on: u8,
        temperature: f32,
        temperature_last_time: u32,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        gnss_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: u32,
        gnss_dropped_packets: u32,
        filter_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
        imu_parser_errors: u32,
        imu_message_count: u32,
        imu_last_message_time: u32,
        gnss_parser_errors: u32,
        gnss_message_count: u32,
        gnss_last_message_time: u32,
    );
}

field! {
    DeviceStatusDiagnosticRq1_45Response: 0x90, "3dm.device_status_diagnostic_rq1_45_response";
    in [0x0C];
    constants [2: 2];
    sizes 86..=104;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (3DM-GX4-15, 3DM-GX4-25) (0x0C,0x90).
    ///
    /// Timer, and counters of pulses, streams, port and USB.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusDiagnosticResponse`],
    /// [`DeviceStatusDiagnosticGnssResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticImuResponse`],
    /// [`DeviceStatusDiagnosticGx4ImuResponse`], [`DeviceStatusDiagnosticRq1ImuResponse`] and
    /// [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Uncertain: No known manual documents it for these devices; the offsets 49 to 69 in the
    /// manual of the 3DM-GX5-45 agree. Uncertain: MSCL lists only the names of the values, from
    /// which the descriptions are inferred; the times are assumed to be in ms like the system
    /// timer.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Default, Eq, Hash)]
    pub struct DeviceStatusDiagnosticGx4Response {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// True if filter data is streamed.
        pub filter_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// Filter data packets that were not sent.
        ///
        /// Unit: 1.
        pub filter_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
        /// Bytes sent over USB.
        ///
        /// Unit: byte.
        pub usb_bytes_written: u32,
        /// Bytes received over USB.
        ///
        /// Unit: byte.
        pub usb_bytes_read: u32,
        /// Overruns while writing to USB.
        ///
        /// Unit: 1.
        pub usb_write_overruns: u32,
        /// Overruns while reading from USB.
        ///
        /// Unit: 1.
        pub usb_read_overruns: u32,
        /// IMU messages that could not be parsed.
        ///
        /// Unit: 1.
        pub imu_parser_errors: u32,
        /// IMU messages that were read.
        ///
        /// Unit: 1.
        pub imu_message_count: u32,
        /// System timer at the last IMU message.
        ///
        /// Unit: ms.
        pub imu_last_message_time: u32,
    }
    wire 73 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_timer]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [filter_stream_enabled]
        [imu_dropped_packets]
        [filter_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
        [usb_bytes_written]
        [usb_bytes_read]
        [usb_write_overruns]
        [usb_read_overruns]
        [imu_parser_errors]
        [imu_message_count]
        [imu_last_message_time]
    }
}

constructors! {
    DeviceStatusDiagnosticGx4Response

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_timer: u32,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        filter_stream_enabled: bool,
        imu_dropped_packets: u32,
        filter_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
        usb_bytes_written: u32,
        usb_bytes_read: u32,
        usb_write_overruns: u32,
        usb_read_overruns: u32,
        imu_parser_errors: u32,
        imu_message_count: u32,
        imu_last_message_time: u32,
    );
}

field! {
    DeviceStatusDiagnosticGx4Response: 0x90, "3dm.device_status_diagnostic_gx4_response";
    in [0x0C];
    constants [2: 2];
    sizes 73..=76;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (IMU) (0x0C,0x90).
    ///
    /// Timer, available sensors, temperature, and the counters of pulses, stream and port.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusDiagnosticResponse`],
    /// [`DeviceStatusDiagnosticGnssResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticGx4ImuResponse`], [`DeviceStatusDiagnosticRq1ImuResponse`] and
    /// [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Uncertain: MSCL uses it for the 3DM-GX5-10, 3DM-CX5-10 and 3DM-CV5-10; no known manual
    /// documents it. Uncertain: MSCL lists only the names of the values, from which the
    /// descriptions are inferred; the times are assumed to be in ms like the system timer.
    /// Uncertain: The units of the ranges are not known.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default)]
    pub struct DeviceStatusDiagnosticImuResponse {
        /// Model number of the device.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// True if the device has a magnetometer.
        pub has_mag: crate::Bool,
        /// True if the device has a pressure sensor.
        pub has_pressure: crate::Bool,
        /// Power state of the sensors.
        pub power_state: u8,
        /// Largest measurable angular rate.
        pub gyro_range: u16,
        /// Largest measurable acceleration.
        pub accel_range: u16,
        /// Reserved.
        pub reserved: u32,
        /// Temperature of the board.
        ///
        /// Unit: degC. Uncertain: The unit is inferred.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub temperature: f32,
        /// System timer at the last temperature measurement.
        ///
        /// Unit: ms.
        pub temperature_last_time: u32,
        /// State of the temperature measurement.
        pub temperature_error: u8,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
    }
    wire 60 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_timer]
        [has_mag]
        [has_pressure]
        [power_state]
        [gyro_range]
        [accel_range]
        [reserved]
        [temperature]
        [temperature_last_time]
        [temperature_error]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [imu_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
    }
}

constructors! {
    DeviceStatusDiagnosticImuResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_timer: u32,
        has_mag: bool,
        has_pressure: bool,
        power_state: u8,
        gyro_range: u16,
        accel_range: u16,
        temperature: f32,
        temperature_last_time: u32,
        temperature_error: u8,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        imu_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
    ), reserved: 0;
}

field! {
    DeviceStatusDiagnosticImuResponse: 0x90, "3dm.device_status_diagnostic_imu_response";
    in [0x0C];
    constants [2: 2];
    sizes 60..=60;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (inertial sensor of the 3DM-GX4-45) (0x0C,0x90).
    ///
    /// Timer, available sensors and their ranges, temperature, and the counters of pulses, stream
    /// and port.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusDiagnosticResponse`],
    /// [`DeviceStatusDiagnosticGnssResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticRq1ImuResponse`] and
    /// [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Uncertain: The SDK of 2014 lists the names of the values and the units of temperature and
    /// times; the descriptions are inferred from the names. Uncertain: The units of the ranges are
    /// not known.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default)]
    pub struct DeviceStatusDiagnosticGx4ImuResponse {
        /// Model number of the inertial sensor.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// Time since start-up.
        ///
        /// Unit: ms.
        pub system_timer: u32,
        /// True if the device has a magnetometer.
        pub has_mag: crate::Bool,
        /// True if the device has a pressure sensor.
        pub has_pressure: crate::Bool,
        /// Largest measurable angular rate.
        pub gyro_range: u16,
        /// Largest measurable acceleration.
        pub accel_range: u8,
        /// Largest measurable magnetic field.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub mag_range: f32,
        /// Largest measurable pressure.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pressure_range: f32,
        /// Temperature of the board.
        ///
        /// Unit: degC. Uncertain: The unit is inferred.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub temperature: f32,
        /// System timer at the last temperature measurement.
        ///
        /// Unit: ms.
        pub temperature_last_time: u32,
        /// State of the temperature measurement; 0 is normal.
        pub temperature_error: u8,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
    }
    wire 62 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_timer]
        [has_mag]
        [has_pressure]
        [gyro_range]
        [accel_range]
        [mag_range]
        [pressure_range]
        [temperature]
        [temperature_last_time]
        [temperature_error]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [imu_dropped_packets]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
    }
}

constructors! {
    DeviceStatusDiagnosticGx4ImuResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_timer: u32,
        has_mag: bool,
        has_pressure: bool,
        gyro_range: u16,
        accel_range: u8,
        mag_range: f32,
        pressure_range: f32,
        temperature: f32,
        temperature_last_time: u32,
        temperature_error: u8,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        imu_dropped_packets: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
    );
}

field! {
    DeviceStatusDiagnosticGx4ImuResponse: 0x90, "3dm.device_status_diagnostic_gx4_imu_response";
    in [0x0C];
    constants [2: 2];
    sizes 62..=72;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (inertial sensor of the 3DM-RQ1-45) (0x0C,0x90).
    ///
    /// Timer, temperature and supply, and the counters of pulses, stream and port.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusDiagnosticResponse`],
    /// [`DeviceStatusDiagnosticGnssResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticGx4ImuResponse`] and
    /// [`DeviceStatusDiagnosticGx3Response`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Uncertain: The SDK of 2014 lists the names of the values and the units of temperature and
    /// times; the descriptions are inferred from the names.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default)]
    pub struct DeviceStatusDiagnosticRq1ImuResponse {
        /// Model number of the inertial sensor.
        pub model_number: u16,
        /// Reserved.
        pub status_flags: u32,
        /// Time since start-up.
        ///
        /// Unit: us.
        pub system_timer: u64,
        /// Temperature of the board.
        ///
        /// Unit: degC. Uncertain: The unit is inferred.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub temperature: f32,
        /// System timer at the last temperature measurement.
        ///
        /// Unit: ms.
        pub temperature_last_time: u32,
        /// True if a temperature sensor is faulty.
        pub bad_temperature_sensor_detected: crate::Bool,
        /// True if the temperature is too low.
        pub cold_temperature_detected: crate::Bool,
        /// True if a supply voltage is out of range.
        pub bad_voltage_detected: crate::Bool,
        /// Number of PPS pulses counted.
        ///
        /// Unit: 1.
        pub pps_count: u32,
        /// System timer at the last pulse.
        ///
        /// Unit: ms.
        pub pps_last_time: u32,
        /// True if sensor data is streamed.
        pub imu_stream_enabled: crate::Bool,
        /// Sensor data packets that were not sent.
        ///
        /// Unit: 1.
        pub imu_dropped_packets: u32,
        /// State of the port; the meaning of its values is not known.
        pub comm_port_state: u16,
        /// Present baud rate of the port.
        ///
        /// Unit: Bd.
        pub comm_port_baud_rate: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
    }
    wire 61 {
        [model_number]
        [status_selector: u8 = 2]
        [status_flags]
        [system_timer]
        [temperature]
        [temperature_last_time]
        [bad_temperature_sensor_detected]
        [cold_temperature_detected]
        [bad_voltage_detected]
        [pps_count]
        [pps_last_time]
        [imu_stream_enabled]
        [imu_dropped_packets]
        [comm_port_state]
        [comm_port_baud_rate]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
    }
}

constructors! {
    DeviceStatusDiagnosticRq1ImuResponse

    /// Creates it from its values.
    fn new(
        model_number: u16,
        status_flags: u32,
        system_timer: u64,
        temperature: f32,
        temperature_last_time: u32,
        bad_temperature_sensor_detected: bool,
        cold_temperature_detected: bool,
        bad_voltage_detected: bool,
        pps_count: u32,
        pps_last_time: u32,
        imu_stream_enabled: bool,
        imu_dropped_packets: u32,
        comm_port_state: u16,
        comm_port_baud_rate: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
    );
}

field! {
    DeviceStatusDiagnosticRq1ImuResponse: 0x90, "3dm.device_status_diagnostic_rq1_imu_response";
    in [0x0C];
    constants [2: 2];
    sizes 61..=61;
    answers DeviceStatus;
}

record! {
    /// Basic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).
    ///
    /// State of the port.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusBasicResponse`] and
    /// [`DeviceStatusBasicWithoutStateResponse`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::BASIC`].
    /// Uncertain: Only the SDK of 2014 contains it, with the names of the values; the descriptions
    /// are inferred from the names.
    ///
    /// The wire format also contains `status_selector`: Basic status. Always 1.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct DeviceStatusBasicGx3Response {
        /// Model number of the device.
        pub model_number: u16,
        /// Part of the device that the port is connected to.
        pub comm_mode: u8,
        /// Port in use.
        pub comm_device: u8,
        /// Settings of the data streams; the meaning of the bits is not known.
        pub settings_flags: u32,
        /// State of the port; the meaning of its values is not known.
        pub comm_state: u16,
        /// Baud rate of the port.
        ///
        /// Unit: Bd.
        pub comm_baud_rate: u32,
    }
    wire 15 {
        [model_number]
        [status_selector: u8 = 1]
        [comm_mode]
        [comm_device]
        [settings_flags]
        [comm_state]
        [comm_baud_rate]
    }
}

constructors! {
    DeviceStatusBasicGx3Response

    /// Creates it from its values.
    fn new(
        model_number: u16,
        comm_mode: u8,
        comm_device: u8,
        settings_flags: u32,
        comm_state: u16,
        comm_baud_rate: u32,
    );
}

field! {
    DeviceStatusBasicGx3Response: 0x90, "3dm.device_status_basic_gx3_response";
    in [0x0C];
    constants [2: 1];
    sizes 15..=usize::MAX;
    answers DeviceStatus;
}

record! {
    /// Diagnostic device status (3DM-GX3-35, 3DM-GX3-45) (0x0C,0x90).
    ///
    /// State of the port, and the counters of the port, USB, receiver and IMU.
    ///
    /// No device is known for certain to support it. Response to [`DeviceStatus`]. The size of its
    /// data distinguishes it from [`DeviceStatusDiagnosticResponse`],
    /// [`DeviceStatusDiagnosticGnssResponse`], [`DeviceStatusDiagnosticGq4_45Response`],
    /// [`DeviceStatusDiagnosticRq1_45Response`], [`DeviceStatusDiagnosticGx4Response`],
    /// [`DeviceStatusDiagnosticImuResponse`], [`DeviceStatusDiagnosticGx4ImuResponse`] and
    /// [`DeviceStatusDiagnosticRq1ImuResponse`]. Sent if
    /// [`status_selector`](DeviceStatus::status_selector) is [`DeviceStatusSelector::DIAGNOSTIC`].
    /// Uncertain: Only the SDK of 2014 contains it, with the names of the values; the descriptions
    /// are inferred from the names.
    ///
    /// The wire format also contains `status_selector`: Diagnostic status. Always 2.
    ///
    /// Source: 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64); 3dm-gx5-35: 4.2.22 Device Status
    /// (0x0C, 0x64); 3dm-gx5-45: 4.2.25 Device Status (0x0C, 0x64); mscl: Device status
    /// (0x0C,0x64).
    #[derive(Default, Eq, Hash)]
    pub struct DeviceStatusDiagnosticGx3Response {
        /// Model number of the device.
        pub model_number: u16,
        /// Part of the device that the port is connected to.
        pub comm_mode: u8,
        /// Port in use.
        pub comm_device: u8,
        /// Settings of the data streams; the meaning of the bits is not known.
        pub settings_flags: u32,
        /// State of the port; the meaning of its values is not known.
        pub comm_state: u16,
        /// Baud rate of the port.
        ///
        /// Unit: Bd.
        pub comm_baud_rate: u32,
        /// Bytes sent over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_written: u32,
        /// Bytes received over the port.
        ///
        /// Unit: byte.
        pub comm_port_bytes_read: u32,
        /// Overruns while writing to the port.
        ///
        /// Unit: 1.
        pub comm_port_write_overruns: u32,
        /// Overruns while reading from the port.
        ///
        /// Unit: 1.
        pub comm_port_read_overruns: u32,
        /// State of the USB port; the meaning of its values is not known.
        pub usb_state: u16,
        /// Bytes sent over USB.
        ///
        /// Unit: byte.
        pub usb_bytes_written: u32,
        /// Bytes received over USB.
        ///
        /// Unit: byte.
        pub usb_bytes_read: u32,
        /// Overruns while writing to USB.
        ///
        /// Unit: 1.
        pub usb_write_overruns: u32,
        /// Overruns while reading from USB.
        ///
        /// Unit: 1.
        pub usb_read_overruns: u32,
        /// State of the receiver's driver; the meaning of its values is not known.
        pub gnss_driver_state: u16,
        /// State of the port to the receiver; the meaning of its values is not known.
        pub gnss_port_state: u16,
        /// Bytes sent to the receiver.
        ///
        /// Unit: byte.
        pub gnss_bytes_written: u32,
        /// Bytes received from the receiver.
        ///
        /// Unit: byte.
        pub gnss_bytes_read: u32,
        /// Overruns while writing to the receiver.
        ///
        /// Unit: 1.
        pub gnss_write_overruns: u32,
        /// Overruns while reading from the receiver.
        ///
        /// Unit: 1.
        pub gnss_read_overruns: u32,
        /// Receiver messages that were read.
        ///
        /// Unit: 1.
        pub gnss_message_count: u32,
        /// Receiver messages that arrived late.
        ///
        /// Unit: 1.
        pub gnss_delayed_message_count: u32,
        /// State of the IMU's driver; the meaning of its values is not known.
        pub imu_driver_state: u16,
        /// State of the port to the IMU; the meaning of its values is not known.
        pub imu_port_state: u16,
        /// Bytes sent to the IMU.
        ///
        /// Unit: byte.
        pub imu_bytes_written: u32,
        /// Bytes received from the IMU.
        ///
        /// Unit: byte.
        pub imu_bytes_read: u32,
        /// Overruns while writing to the IMU.
        ///
        /// Unit: 1.
        pub imu_write_overruns: u32,
        /// Overruns while reading from the IMU.
        ///
        /// Unit: 1.
        pub imu_read_overruns: u32,
        /// IMU messages that were read.
        ///
        /// Unit: 1.
        pub imu_message_count: u32,
        /// IMU messages that arrived late.
        ///
        /// Unit: 1.
        pub imu_delayed_message_count: u32,
    }
    wire 105 {
        [model_number]
        [status_selector: u8 = 2]
        [comm_mode]
        [comm_device]
        [settings_flags]
        [comm_state]
        [comm_baud_rate]
        [comm_port_bytes_written]
        [comm_port_bytes_read]
        [comm_port_write_overruns]
        [comm_port_read_overruns]
        [usb_state]
        [usb_bytes_written]
        [usb_bytes_read]
        [usb_write_overruns]
        [usb_read_overruns]
        [gnss_driver_state]
        [gnss_port_state]
        [gnss_bytes_written]
        [gnss_bytes_read]
        [gnss_write_overruns]
        [gnss_read_overruns]
        [gnss_message_count]
        [gnss_delayed_message_count]
        [imu_driver_state]
        [imu_port_state]
        [imu_bytes_written]
        [imu_bytes_read]
        [imu_write_overruns]
        [imu_read_overruns]
        [imu_message_count]
        [imu_delayed_message_count]
    }
}

constructors! {
    DeviceStatusDiagnosticGx3Response

    /// Creates it from its values.
    fn new(
        model_number: u16,
        comm_mode: u8,
        comm_device: u8,
        settings_flags: u32,
        comm_state: u16,
        comm_baud_rate: u32,
        comm_port_bytes_written: u32,
        comm_port_bytes_read: u32,
        comm_port_write_overruns: u32,
        comm_port_read_overruns: u32,
        usb_state: u16,
        usb_bytes_written: u32,
        usb_bytes_read: u32,
        usb_write_overruns: u32,
        usb_read_overruns: u32,
        gnss_driver_state: u16,
        gnss_port_state: u16,
        gnss_bytes_written: u32,
        gnss_bytes_read: u32,
        gnss_write_overruns: u32,
        gnss_read_overruns: u32,
        gnss_message_count: u32,
        gnss_delayed_message_count: u32,
        imu_driver_state: u16,
        imu_port_state: u16,
        imu_bytes_written: u32,
        imu_bytes_read: u32,
        imu_write_overruns: u32,
        imu_read_overruns: u32,
        imu_message_count: u32,
        imu_delayed_message_count: u32,
    );
}

field! {
    DeviceStatusDiagnosticGx3Response: 0x90, "3dm.device_status_diagnostic_gx3_response";
    in [0x0C];
    constants [2: 2];
    sizes 105..=usize::MAX;
    answers DeviceStatus;
}

record! {
    /// GPS dynamics mode response (0x0C,0x92).
    ///
    /// No device is known for certain to support it. Response to [`GpsDynamicsMode`]. Known only
    /// from the MIP SDK of 2014 and MicroStrain Communication Library.
    ///
    /// Source: mip-sdk-2014: GPS dynamics mode (0x0C,0x34); mscl: GPS dynamics mode (0x0C,0x34).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpsDynamicsModeResponse {
        /// Assumed dynamics.
        pub mode: ReceiverDynamics,
    }
}

view! {
    GpsDynamicsModeResponse
    mode: ReceiverDynamics, at 0;
}

constructors! {
    GpsDynamicsModeResponse

    /// Creates it from its values.
    fn new(mode: ReceiverDynamics);
}

field! {
    GpsDynamicsModeResponse: 0x92, "3dm.gps_dynamics_mode_response";
    in [0x0C];
    answers GpsDynamicsMode;
}

record! {
    /// IMU timestamp response (0x0C,0x93).
    ///
    /// No device is known for certain to support it. Response to [`ImuTimestamp`]. Known only from
    /// the MIP SDK of 2014.
    ///
    /// Source: mip-sdk-2014: IMU timestamp (0x0C,0x36).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ImuTimestampResponse {
        /// Counter to set or read.
        pub selector: ImuTimestampSelector,
        /// Value of the counter, in the unit that `selector` selects.
        pub time: u32,
    }
}

view! {
    ImuTimestampResponse
    selector: ImuTimestampSelector, at 0;
    time: u32, at 1;
}

constructors! {
    ImuTimestampResponse

    /// Creates it from its values.
    fn new(selector: ImuTimestampSelector, time: u32);
}

field! {
    ImuTimestampResponse: 0x93, "3dm.imu_timestamp_response";
    in [0x0C];
    answers ImuTimestamp;
}

record! {
    /// Complementary filter configuration response (0x0C,0x97).
    ///
    /// Response to [`ComplementaryFilter`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15) and [3DM-GX5-35](crate::devices::GX5_35); likely or
    /// assumed on 22 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51); 3dm-cv7-gnss-ins:
    /// Complementary Filter Configuration (0x0C,0x51).
    #[derive(Copy, Default)]
    pub struct ComplementaryFilterResponse {
        /// True enables the pitch and roll correction, which 5-series manuals call up compensation.
        pub pitch_roll_enable: crate::Bool,
        /// True enables the heading correction, which 5-series manuals call north compensation.
        pub heading_enable: crate::Bool,
        /// Time constant of the pitch and roll correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch_roll_time_constant: f32,
        /// Time constant of the heading correction.
        ///
        /// Unit: s. Range: 1 to 1000. Default: 10.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading_time_constant: f32,
    }
}

view! {
    ComplementaryFilterResponse
    pitch_roll_enable: crate::Bool, at 0;
    heading_enable: crate::Bool, at 1;
    pitch_roll_time_constant: f32, at 2;
    heading_time_constant: f32, at 6;
}

constructors! {
    ComplementaryFilterResponse

    /// Creates it from its values.
    fn new(
        pitch_roll_enable: bool,
        heading_enable: bool,
        pitch_roll_time_constant: f32,
        heading_time_constant: f32,
    );
}

field! {
    ComplementaryFilterResponse: 0x97, "3dm.complementary_filter_response";
    in [0x0C];
    answers ComplementaryFilter;
}

record! {
    /// Accelerometer bias configuration response (0x0C,0x9A).
    ///
    /// Response to [`AccelBias`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS),
    /// [3DM-GQ4-45](crate::devices::GQ4_45), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 24 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37); 3dm-cv7-gnss-ins: Accelerometer Bias
    /// Configuration (0x0C,0x37).
    #[derive(Copy, Default)]
    pub struct AccelBiasResponse {
        /// Bias that the device subtracts from the measured acceleration.
        ///
        /// Elements: x, y, z. Unit: g. Frame: sensor.
        pub bias: types::Vector3f,
    }
}

view! {
    AccelBiasResponse
    bias: types::Vector3f, at 0;
}

constructors! {
    AccelBiasResponse

    /// Creates it from its values.
    fn new(bias: impl Into<types::Vector3f>);
}

field! {
    AccelBiasResponse: 0x9A, "3dm.accel_bias_response";
    in [0x0C];
    answers AccelBias;
}

record! {
    /// Gyroscope bias configuration response (0x0C,0x9B).
    ///
    /// The bias in use.
    ///
    /// Also called `capture_gyro_bias_response`. Response to [`GyroBias`] and [`CaptureGyroBias`].
    /// Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7), [3DM-GX5-15](crate::devices::GX5_15),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 21 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38); 3dm-cv7-gnss-ins: Gyroscope Bias
    /// Configuration (0x0C,0x38).
    #[derive(Copy, Default)]
    pub struct GyroBiasResponse {
        /// Bias that the device subtracts from the measured angular rate.
        ///
        /// Elements: x, y, z. Unit: rad/s. Frame: sensor.
        pub bias: types::Vector3f,
    }
}

view! {
    GyroBiasResponse
    bias: types::Vector3f, at 0;
}

constructors! {
    GyroBiasResponse

    /// Creates it from its values.
    fn new(bias: impl Into<types::Vector3f>);
}

field! {
    GyroBiasResponse: 0x9B, "3dm.gyro_bias_response";
    in [0x0C];
    answers GyroBias CaptureGyroBias;
}

record! {
    /// Magnetometer hard iron offset response (0x0C,0x9C).
    ///
    /// Response to [`MagHardIronOffset`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-45](crate::devices::GX5_45), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 14 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A); 3dm-gx5-45: (0x0C,
    /// 0x3A).
    #[derive(Copy, Default)]
    pub struct MagHardIronOffsetResponse {
        /// Offset that the device subtracts from the measured magnetic field.
        ///
        /// Elements: x, y, z. Unit: gauss. Frame: sensor.
        pub offset: types::Vector3f,
    }
}

view! {
    MagHardIronOffsetResponse
    offset: types::Vector3f, at 0;
}

constructors! {
    MagHardIronOffsetResponse

    /// Creates it from its values.
    fn new(offset: impl Into<types::Vector3f>);
}

field! {
    MagHardIronOffsetResponse: 0x9C, "3dm.mag_hard_iron_offset_response";
    in [0x0C];
    answers MagHardIronOffset;
}

record! {
    /// Magnetometer soft iron matrix response (0x0C,0x9D).
    ///
    /// Response to [`MagSoftIronMatrix`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-35](crate::devices::GX5_35), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 14 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B); 3dm-gx5-35: (0x0C,
    /// 0x3B).
    #[derive(Copy, Default)]
    pub struct MagSoftIronMatrixResponse {
        /// Soft iron matrix in row-major order.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1. Frame: sensor.
        pub matrix: types::Matrix3f,
    }
}

view! {
    MagSoftIronMatrixResponse
    matrix: types::Matrix3f, at 0;
}

constructors! {
    MagSoftIronMatrixResponse

    /// Creates it from its values.
    fn new(matrix: impl Into<types::Matrix3f>);
}

field! {
    MagSoftIronMatrixResponse: 0x9D, "3dm.mag_soft_iron_matrix_response";
    in [0x0C];
    answers MagSoftIronMatrix;
}

record! {
    /// Coning and sculling enable response (0x0C,0x9E).
    ///
    /// Response to [`ConingScullingEnable`]. Confirmed on [3DM-GQ4-45](crate::devices::GQ4_45),
    /// [3DM-GX5-15](crate::devices::GX5_15), [3DM-RQ1-45-LT](crate::devices::RQ1_45_LT) and
    /// [3DM-RQ1-45-ST](crate::devices::RQ1_45_ST); likely or assumed on 15 more.
    ///
    /// Source: 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct ConingScullingEnableResponse {
        /// True if the compensation is on.
        ///
        /// Default: true.
        pub enable: crate::Bool,
    }
}

view! {
    ConingScullingEnableResponse
    enable: crate::Bool, at 0;
}

constructors! {
    ConingScullingEnableResponse

    /// Creates it from its values.
    fn new(enable: bool);
}

field! {
    ConingScullingEnableResponse: 0x9E, "3dm.coning_sculling_enable_response";
    in [0x0C];
    answers ConingScullingEnable;
}

record! {
    /// Constellation settings response (0x0C,0xA0).
    ///
    /// Tracking channels of the receiver and the setting of each constellation.
    ///
    /// Response to [`ConstellationSettings`]. Confirmed on [3DM-GQ4-45](crate::devices::GQ4_45) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 2 more.
    ///
    /// The wire format also contains `config_count`: Number of entries. Counts the elements of
    /// [`settings`](ConstellationSettingsResponse::settings). Range: 0 to 41.
    ///
    /// Source: mip-sdk-4: Constellation settings (0x0C,0x21); 3dm-gx5-35: 4.2.8 GNSS Constellation
    /// Settings (0x0C, 0x21).
    #[derive(Default, Eq, Hash)]
    pub struct ConstellationSettingsResponse {
        /// Number of channels of the receiver.
        ///
        /// Unit: 1.
        pub max_channels_available: u16,
        /// Maximum number of channels in use.
        ///
        /// Unit: 1.
        pub max_channels_use: u16,
        /// One entry for each constellation.
        pub settings: crate::List<ConstellationSettingsEntry, 41>,
    }
    wire 251 {
        [max_channels_available]
        [max_channels_use]
        [config_count: u8 counts settings]
        [settings by config_count]
    }
}

constructors! {
    ConstellationSettingsResponse

    /// Creates it from its values.
    fn new(
        max_channels_available: u16,
        max_channels_use: u16,
        settings: impl Into<crate::List<ConstellationSettingsEntry, 41>>,
    );
}

field! {
    ConstellationSettingsResponse: 0xA0, "3dm.constellation_settings_response";
    in [0x0C];
    answers ConstellationSettings;
}

record! {
    /// GNSS SBAS settings response (0x0C,0xA1).
    ///
    /// Response to [`GnssSbasSettings`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ4-45](crate::devices::GQ4_45) and
    /// [3DM-GX5-35](crate::devices::GX5_35); likely or assumed on 3 more.
    ///
    /// The wire format also contains `num_included_prns`: Number of satellites listed; 0 searches
    /// for all. Counts the elements of [`included_prns`](GnssSbasSettingsResponse::included_prns).
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22).
    #[derive(Default, Eq, Hash)]
    pub struct GnssSbasSettingsResponse {
        /// 1 enables SBAS, 0 disables it.
        ///
        /// Range: 0 to 1.
        pub enable_sbas: u8,
        /// Purposes of SBAS.
        pub sbas_options: SbasOptions,
        /// PRN numbers of the SBAS satellites to search for.
        pub included_prns: crate::List<u16, 124>,
    }
    wire 252 {
        [enable_sbas]
        [sbas_options]
        [num_included_prns: u8 counts included_prns]
        [included_prns by num_included_prns]
    }
}

constructors! {
    GnssSbasSettingsResponse

    /// Creates it from its values.
    fn new(
        enable_sbas: u8,
        sbas_options: SbasOptions,
        included_prns: impl Into<crate::List<u16, 124>>,
    );
}

field! {
    GnssSbasSettingsResponse: 0xA1, "3dm.gnss_sbas_settings_response";
    in [0x0C];
    answers GnssSbasSettings;
}

record! {
    /// GNSS assisted fix response (0x0C,0xA2).
    ///
    /// Response to [`GnssAssistedFix`]. Confirmed on [3DM-GX5-35](crate::devices::GX5_35); likely
    /// or assumed on 2 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: GNSS assisted fix (0x0C,0x23).
    #[derive(Copy, Eq, Hash)]
    pub struct GnssAssistedFixResponse {
        /// Storage of data for a faster first fix.
        ///
        /// Default: [`AssistedFixOption::NONE`].
        pub option: AssistedFixOption,
        /// Reserved.
        pub flags: u8,
    }
}

#[rustfmt::skip]
impl core::default::Default for GnssAssistedFixResponse {
    fn default() -> Self {
        Self {
            option: core::default::Default::default(),
            flags: 255,
        }
    }
}

view! {
    GnssAssistedFixResponse
    option: AssistedFixOption, at 0;
    flags: u8, at 1;
}

constructors! {
    GnssAssistedFixResponse

    /// Creates it from its values.
    fn new(option: AssistedFixOption), flags: 255;
}

field! {
    GnssAssistedFixResponse: 0xA2, "3dm.gnss_assisted_fix_response";
    in [0x0C];
    answers GnssAssistedFix;
}

record! {
    /// GNSS time assistance response (0x0C,0xA3).
    ///
    /// Response to [`GnssTimeAssistance`]. Confirmed on [3DM-GX5-35](crate::devices::GX5_35);
    /// likely or assumed on 2 more. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: GNSS time assistance (0x0C,0x24).
    #[derive(Copy, Default)]
    pub struct GnssTimeAssistanceResponse {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number since 1980.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Estimated accuracy of the time that is sent.
        ///
        /// Unit: s. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub accuracy: f32,
    }
}

view! {
    GnssTimeAssistanceResponse
    tow: f64, at 0;
    week_number: u16, at 8;
    accuracy: f32, at 10;
}

constructors! {
    GnssTimeAssistanceResponse

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        accuracy: f32,
    );
}

field! {
    GnssTimeAssistanceResponse: 0xA3, "3dm.gnss_time_assistance_response";
    in [0x0C];
    answers GnssTimeAssistance;
}

record! {
    /// PPS source control response (0x0C,0xA8).
    ///
    /// Also called `pps_source_response`. Response to [`PpsSourceControl`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct PpsSourceControlResponse {
        /// Source of the pulse.
        pub source: PpsSource,
    }
}

view! {
    PpsSourceControlResponse
    source: PpsSource, at 0;
}

constructors! {
    PpsSourceControlResponse

    /// Creates it from its values.
    fn new(source: PpsSource);
}

field! {
    PpsSourceControlResponse: 0xA8, "3dm.pps_source_control_response";
    in [0x0C];
    answers PpsSourceControl;
}

record! {
    /// Sensor-to-vehicle frame transformation Euler response (0x0C,0xB1).
    ///
    /// Also called `sensor_2_vehicle_transform_euler_response`. Response to
    /// [`SensorToVehicleTransformEuler`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 9 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleTransformEulerResponse {
        /// Roll angle of the sensor relative to the vehicle.
        ///
        /// Unit: rad. Frame: vehicle. Positive: right side down.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub roll: f32,
        /// Pitch angle of the sensor relative to the vehicle.
        ///
        /// Unit: rad. Frame: vehicle. Positive: nose up.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pitch: f32,
        /// Yaw angle of the sensor relative to the vehicle.
        ///
        /// Unit: rad. Frame: vehicle. Positive: clockwise seen from above.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub yaw: f32,
    }
}

view! {
    SensorToVehicleTransformEulerResponse
    roll: f32, at 0;
    pitch: f32, at 4;
    yaw: f32, at 8;
}

constructors! {
    SensorToVehicleTransformEulerResponse

    /// Creates it from its values.
    fn new(
        roll: f32,
        pitch: f32,
        yaw: f32,
    );
}

field! {
    SensorToVehicleTransformEulerResponse: 0xB1, "3dm.sensor_to_vehicle_transform_euler_response";
    in [0x0C];
    answers SensorToVehicleTransformEuler;
}

record! {
    /// Sensor-to-vehicle frame transformation quaternion response (0x0C,0xB2).
    ///
    /// Also called `sensor_2_vehicle_transform_quaternion_response`. Response to
    /// [`SensorToVehicleTransformQuaternion`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleTransformQuaternionResponse {
        /// Rotates vectors of the vehicle frame into the sensor frame; unit quaternion, w first.
        ///
        /// Elements: w, x, y, z. Unit: 1.
        pub q: types::Quatf,
    }
}

view! {
    SensorToVehicleTransformQuaternionResponse
    q: types::Quatf, at 0;
}

constructors! {
    SensorToVehicleTransformQuaternionResponse

    /// Creates it from its values.
    fn new(q: impl Into<types::Quatf>);
}

field! {
    SensorToVehicleTransformQuaternionResponse: 0xB2, "3dm.sensor_to_vehicle_transform_quaternion_response";
    in [0x0C];
    answers SensorToVehicleTransformQuaternion;
}

record! {
    /// Sensor-to-vehicle frame transformation direction cosine matrix response (0x0C,0xB3).
    ///
    /// Also called `sensor_2_vehicle_transform_dcm_response`. Response to
    /// [`SensorToVehicleTransformDcm`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix
    /// (0x0C,0x33).
    #[derive(Copy, Default)]
    pub struct SensorToVehicleTransformDcmResponse {
        /// Rotates vectors of the sensor frame into the vehicle frame; row-major.
        ///
        /// Elements: m11, m12, m13, m21, m22, m23, m31, m32, m33. Unit: 1.
        pub dcm: types::Matrix3f,
    }
}

view! {
    SensorToVehicleTransformDcmResponse
    dcm: types::Matrix3f, at 0;
}

constructors! {
    SensorToVehicleTransformDcmResponse

    /// Creates it from its values.
    fn new(dcm: impl Into<types::Matrix3f>);
}

field! {
    SensorToVehicleTransformDcmResponse: 0xB3, "3dm.sensor_to_vehicle_transform_dcm_response";
    in [0x0C];
    answers SensorToVehicleTransformDcm;
}

record! {
    /// Get supported events response (0x0C,0xB4).
    ///
    /// Response to [`GetEventSupport`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 8 more.
    ///
    /// The wire format also contains `num_entries`: Number of types. Counts the elements of
    /// [`entries`](GetEventSupportResponse::entries).
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A).
    #[derive(Default, Eq, Hash)]
    pub struct GetEventSupportResponse {
        /// Query specified in the command.
        pub query: EventSupportQuery,
        /// Number of instances, which are numbered from 1.
        ///
        /// Unit: 1.
        pub max_instances: u8,
        /// The types.
        ///
        /// If [`query`](GetEventSupportResponse::query) is [`EventSupportQuery::TRIGGER_TYPES`]:
        /// [`type_`](EventSupportInfo::type_) has values of [`types::EventTriggerType`]. If
        /// [`query`](GetEventSupportResponse::query) is [`EventSupportQuery::ACTION_TYPES`]:
        /// [`type_`](EventSupportInfo::type_) has values of [`types::EventActionType`].
        pub entries: crate::List<EventSupportInfo, 125>,
    }
    wire 253 {
        [query]
        [max_instances]
        [num_entries: u8 counts entries]
        [entries by num_entries]
    }
}

constructors! {
    GetEventSupportResponse

    /// Creates it from its values.
    fn new(
        query: EventSupportQuery,
        max_instances: u8,
        entries: impl Into<crate::List<EventSupportInfo, 125>>,
    );
}

field! {
    GetEventSupportResponse: 0xB4, "3dm.get_event_support_response";
    in [0x0C];
    answers GetEventSupport;
}

record! {
    /// Event control response (0x0C,0xB5).
    ///
    /// Response to [`EventControl`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct EventControlResponse {
        /// Trigger instance.
        pub instance: u8,
        /// Mode of the trigger.
        ///
        /// Default: [`types::EventTriggerMode::DISABLED`].
        pub mode: types::EventTriggerMode,
    }
}

view! {
    EventControlResponse
    instance: u8, at 0;
    mode: types::EventTriggerMode, at 1;
}

constructors! {
    EventControlResponse

    /// Creates it from its values.
    fn new(instance: u8, mode: types::EventTriggerMode);
}

field! {
    EventControlResponse: 0xB5, "3dm.event_control_response";
    in [0x0C];
    answers EventControl;
}

record! {
    /// Get event trigger status response (0x0C,0xB6).
    ///
    /// Response to [`GetEventTriggerStatus`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `count`: Number of entries. Counts the elements of
    /// [`triggers`](GetEventTriggerStatusResponse::triggers).
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C).
    #[derive(Default, Eq, Hash)]
    pub struct GetEventTriggerStatusResponse {
        /// One entry per trigger, in the requested order, or by instance if all were requested.
        pub triggers: crate::List<EventTriggerStatusEntry, 126>,
    }
    wire 253 {
        [count: u8 counts triggers]
        [triggers by count]
    }
}

constructors! {
    GetEventTriggerStatusResponse

    /// Creates it from its values.
    fn new(triggers: impl Into<crate::List<EventTriggerStatusEntry, 126>>);
}

field! {
    GetEventTriggerStatusResponse: 0xB6, "3dm.get_event_trigger_status_response";
    in [0x0C];
    answers GetEventTriggerStatus;
}

record! {
    /// Get event action status response (0x0C,0xB7).
    ///
    /// Response to [`GetEventActionStatus`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `count`: Number of entries. Counts the elements of
    /// [`actions`](GetEventActionStatusResponse::actions).
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D).
    #[derive(Default, Eq, Hash)]
    pub struct GetEventActionStatusResponse {
        /// One entry per action, in the requested order, or by instance if all were requested.
        pub actions: crate::List<EventActionStatusEntry, 126>,
    }
    wire 253 {
        [count: u8 counts actions]
        [actions by count]
    }
}

constructors! {
    GetEventActionStatusResponse

    /// Creates it from its values.
    fn new(actions: impl Into<crate::List<EventActionStatusEntry, 126>>);
}

field! {
    GetEventActionStatusResponse: 0xB7, "3dm.get_event_action_status_response";
    in [0x0C];
    answers GetEventActionStatus;
}

record! {
    /// Event trigger configuration response (0x0C,0xB8).
    ///
    /// Also called `event_trigger_response`. Response to [`EventTriggerConfig`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E).
    #[derive(Copy, Default)]
    pub struct EventTriggerConfigResponse {
        /// Trigger instance.
        pub instance: u8,
        /// Kind of trigger.
        ///
        /// Default: [`types::EventTriggerType::NONE`].
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: types::EventTriggerType,
        /// The condition.
        ///
        /// Selected by [`type_`](EventTriggerConfigResponse::type_).
        pub parameters: EventTriggerConfigParameters,
    }
    wire 22 {
        [instance]
        [type_ "type"]
        [parameters as type_]
    }
}

constructors! {
    EventTriggerConfigResponse

    /// Creates it from its values.
    fn new(instance: u8, parameters: EventTriggerConfigParameters), type_: parameters.tag();
}

field! {
    EventTriggerConfigResponse: 0xB8, "3dm.event_trigger_config_response";
    in [0x0C];
    answers EventTriggerConfig;
}

record! {
    /// Event action configuration response (0x0C,0xB9).
    ///
    /// Also called `event_action_response`. Response to [`EventActionConfig`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR) and
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F); 3dm-cv7-gnss-ins: Event
    /// Cycle.
    #[derive(Default, Eq, Hash)]
    pub struct EventActionConfigResponse {
        /// Action instance.
        pub instance: u8,
        /// Trigger instance that the action follows.
        pub trigger: u8,
        /// Kind of action.
        ///
        /// Default: [`types::EventActionType::NONE`].
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: types::EventActionType,
        /// Effect of the action.
        ///
        /// Selected by [`type_`](EventActionConfigResponse::type_).
        pub parameters: EventActionConfigParameters,
    }
    wire 253 {
        [instance]
        [trigger]
        [type_ "type"]
        [parameters as type_]
    }
}

constructors! {
    EventActionConfigResponse

    /// Creates it from its values.
    fn new(
        instance: u8,
        trigger: u8,
        parameters: EventActionConfigParameters,
    ), type_: parameters.tag();
}

field! {
    EventActionConfigResponse: 0xB9, "3dm.event_action_config_response";
    in [0x0C];
    answers EventActionConfig;
}

record! {
    /// GPIO configuration response (0x0C,0xC1).
    ///
    /// Response to [`GpioConfig`]. Confirmed on [3DM-CV7-AHRS](crate::devices::CV7_AHRS),
    /// [3DM-CV7-AR](crate::devices::CV7_AR) and [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 8 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpioConfigResponse {
        /// GPIO pin, counted from 1.
        pub pin: u8,
        /// Use of the pin.
        ///
        /// Default: [`types::GpioFeature::UNUSED`].
        pub feature: types::GpioFeature,
        /// Role of the pin within the feature; 0 if the feature has no roles.
        ///
        /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::UNUSED`]: values of
        /// [`types::GpioUnusedBehavior`]. If [`feature`](GpioConfigResponse::feature) is
        /// [`types::GpioFeature::GPIO`]: values of [`types::GpioBehavior`]. If
        /// [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::PPS`]: values of
        /// [`types::GpioPpsBehavior`]. If [`feature`](GpioConfigResponse::feature) is
        /// [`types::GpioFeature::ENCODER`]: values of [`types::GpioEncoderBehavior`]. If
        /// [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::TIMESTAMP`]: values of
        /// [`types::GpioTimestampBehavior`]. If [`feature`](GpioConfigResponse::feature) is
        /// [`types::GpioFeature::UART`]: values of [`types::GpioUartBehavior`].
        pub behavior: u8,
        /// Electrical options.
        pub pin_mode: types::GpioPinMode,
    }
}

view! {
    GpioConfigResponse
    pin: u8, at 0;
    feature: types::GpioFeature, at 1;
    behavior: u8, at 2;
    pin_mode: types::GpioPinMode, at 3;
}

constructors! {
    GpioConfigResponse

    /// Creates it from its values.
    fn new(
        pin: u8,
        feature: types::GpioFeature,
        behavior: u8,
        pin_mode: types::GpioPinMode,
    );
}

#[rustfmt::skip]
impl GpioConfigResponse {
    /// Reads `behavior` as [`types::GpioUnusedBehavior`].
    ///
    /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::UNUSED`]: values of
    /// [`types::GpioUnusedBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_unused_behavior(&self) -> Option<types::GpioUnusedBehavior> {
        let named = matches!(self.feature, types::GpioFeature::UNUSED);
        named.then(|| self.behavior.into())
    }

    /// Reads `behavior` as [`types::GpioBehavior`].
    ///
    /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::GPIO`]: values of
    /// [`types::GpioBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_behavior(&self) -> Option<types::GpioBehavior> {
        let named = matches!(self.feature, types::GpioFeature::GPIO);
        named.then(|| self.behavior.into())
    }

    /// Reads `behavior` as [`types::GpioPpsBehavior`].
    ///
    /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::PPS`]: values of
    /// [`types::GpioPpsBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_pps_behavior(&self) -> Option<types::GpioPpsBehavior> {
        let named = matches!(self.feature, types::GpioFeature::PPS);
        named.then(|| self.behavior.into())
    }

    /// Reads `behavior` as [`types::GpioEncoderBehavior`].
    ///
    /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::ENCODER`]: values of
    /// [`types::GpioEncoderBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_encoder_behavior(&self) -> Option<types::GpioEncoderBehavior> {
        let named = matches!(self.feature, types::GpioFeature::ENCODER);
        named.then(|| self.behavior.into())
    }

    /// Reads `behavior` as [`types::GpioTimestampBehavior`].
    ///
    /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::TIMESTAMP`]: values of
    /// [`types::GpioTimestampBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_timestamp_behavior(&self) -> Option<types::GpioTimestampBehavior> {
        let named = matches!(self.feature, types::GpioFeature::TIMESTAMP);
        named.then(|| self.behavior.into())
    }

    /// Reads `behavior` as [`types::GpioUartBehavior`].
    ///
    /// If [`feature`](GpioConfigResponse::feature) is [`types::GpioFeature::UART`]: values of
    /// [`types::GpioUartBehavior`].
    #[inline]
    #[must_use]
    pub fn behavior_as_gpio_uart_behavior(&self) -> Option<types::GpioUartBehavior> {
        let named = matches!(self.feature, types::GpioFeature::UART);
        named.then(|| self.behavior.into())
    }
}

field! {
    GpioConfigResponse: 0xC1, "3dm.gpio_config_response";
    in [0x0C];
    answers GpioConfig;
}

record! {
    /// GPIO state response (0x0C,0xC2).
    ///
    /// Response to [`GpioState`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 9 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpioStateResponse {
        /// GPIO pin, counted from 1.
        ///
        /// Range: at least 1.
        pub pin: u8,
        /// True means high.
        pub state: crate::Bool,
    }
}

view! {
    GpioStateResponse
    pin: u8, at 0;
    state: crate::Bool, at 1;
}

constructors! {
    GpioStateResponse

    /// Creates it from its values.
    fn new(pin: u8, state: bool);
}

field! {
    GpioStateResponse: 0xC2, "3dm.gpio_state_response";
    in [0x0C];
    answers GpioState;
}

record! {
    /// Odometer configuration response (0x0C,0xC3).
    ///
    /// Also called `odometer_response`. Response to [`OdometerConfig`]. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43).
    #[derive(Copy, Default)]
    pub struct OdometerConfigResponse {
        /// Operation of the input.
        pub mode: OdometerMode,
        /// Pulses per distance travelled; negative if the encoder rotates backwards.
        ///
        /// Unit: pulse/m.
        ///
        /// - Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub scaling: f32,
        /// Relative uncertainty of the scaling, 1 sigma.
        ///
        /// Unit: 1. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
    }
}

view! {
    OdometerConfigResponse
    mode: OdometerMode, at 0;
    scaling: f32, at 1;
    uncertainty: f32, at 5;
}

constructors! {
    OdometerConfigResponse

    /// Creates it from its values.
    fn new(
        mode: OdometerMode,
        scaling: f32,
        uncertainty: f32,
    );
}

field! {
    OdometerConfigResponse: 0xC3, "3dm.odometer_config_response";
    in [0x0C];
    answers OdometerConfig;
}

record! {
    /// Sensor range response (0x0C,0xD2).
    ///
    /// Response to [`SensorRange`]. Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS);
    /// likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SensorRangeResponse {
        /// Sensor whose range is set or read.
        pub sensor: SensorRangeType,
        /// Number of the range.
        pub setting: u8,
    }
}

view! {
    SensorRangeResponse
    sensor: SensorRangeType, at 0;
    setting: u8, at 1;
}

constructors! {
    SensorRangeResponse

    /// Creates it from its values.
    fn new(sensor: SensorRangeType, setting: u8);
}

field! {
    SensorRangeResponse: 0xD2, "3dm.sensor_range_response";
    in [0x0C];
    answers SensorRange;
}

record! {
    /// Get calibrated sensor ranges response (0x0C,0xD3).
    ///
    /// Also called `calibrated_sensor_ranges_response`. Response to [`GetCalibratedSensorRanges`].
    /// Confirmed on [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// The wire format also contains `num_ranges`: Number of ranges. Counts the elements of
    /// [`ranges`](GetCalibratedSensorRangesResponse::ranges).
    ///
    /// Source: 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53).
    #[derive(Default)]
    pub struct GetCalibratedSensorRangesResponse {
        /// Sensor specified in the command.
        pub sensor: SensorRangeType,
        /// Ranges for which the sensor is calibrated.
        ///
        /// If [`sensor`](GetCalibratedSensorRangesResponse::sensor) is [`SensorRangeType::ACCEL`]:
        /// [`range`](SensorRangeEntry::range) has unit g. If
        /// [`sensor`](GetCalibratedSensorRangesResponse::sensor) is [`SensorRangeType::GYRO`]:
        /// [`range`](SensorRangeEntry::range) has unit deg/s. If
        /// [`sensor`](GetCalibratedSensorRangesResponse::sensor) is [`SensorRangeType::MAG`]:
        /// [`range`](SensorRangeEntry::range) has unit gauss. If
        /// [`sensor`](GetCalibratedSensorRangesResponse::sensor) is [`SensorRangeType::PRESSURE`]:
        /// [`range`](SensorRangeEntry::range) has unit mbar.
        pub ranges: crate::List<SensorRangeEntry, 50>,
    }
    wire 252 {
        [sensor]
        [num_ranges: u8 counts ranges]
        [ranges by num_ranges]
    }
}

constructors! {
    GetCalibratedSensorRangesResponse

    /// Creates it from its values.
    fn new(sensor: SensorRangeType, ranges: impl Into<crate::List<SensorRangeEntry, 50>>);
}

field! {
    GetCalibratedSensorRangesResponse: 0xD3, "3dm.get_calibrated_sensor_ranges_response";
    in [0x0C];
    answers GetCalibratedSensorRanges;
}

record! {
    /// Low-pass anti-aliasing filter response (0x0C,0xD4).
    ///
    /// Also called `lowpass_filter_response`. Response to [`LowPassFilter`]. Confirmed on
    /// [3DM-CV7-AHRS](crate::devices::CV7_AHRS), [3DM-CV7-AR](crate::devices::CV7_AR),
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 7 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54).
    #[derive(Copy, Default)]
    pub struct LowPassFilterResponse {
        /// Descriptor set of the field.
        pub descriptor_set: crate::DescriptorSet,
        /// Descriptor of the field that is filtered.
        ///
        /// Refers to fields of [`descriptor_set`](LowPassFilterResponse::descriptor_set).
        pub field_descriptor: u8,
        /// True if the field is filtered.
        pub enable: crate::Bool,
        /// True uses `frequency`; false uses half the rate of the field in the message format.
        pub manual: crate::Bool,
        /// Cutoff in use.
        ///
        /// Unit: Hz. Range: at least 0.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub frequency: f32,
    }
}

view! {
    LowPassFilterResponse
    descriptor_set: crate::DescriptorSet, at 0;
    field_descriptor: u8, at 1;
    enable: crate::Bool, at 2;
    manual: crate::Bool, at 3;
    frequency: f32, at 4;
}

constructors! {
    LowPassFilterResponse

    /// Creates it from its values.
    fn new(
        descriptor_set: impl Into<crate::DescriptorSet>,
        field_descriptor: u8,
        enable: bool,
        manual: bool,
        frequency: f32,
    );
}

field! {
    LowPassFilterResponse: 0xD4, "3dm.low_pass_filter_response";
    in [0x0C];
    answers LowPassFilter;
}
