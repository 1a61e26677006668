//! 3DM (0x0C): Commands that set up the sensors, the outputs, the pins and the events of a device.
//!
//! - Manual 3dm-gx5-15: 4.2 3DM Commands
//! - Manual 3dm-cv7-gnss-ins: 3DM (0x0C)

use crate::macros::{bitfield, open_enum};
use crate::types;
use crate::{Command, DecodeError, EncodeError, Field, Reader, ResponseOf, Union, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x0C;

/// A field that a poll asks for.
///
/// - Manual 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PollEntry {
    /// Field descriptor.
    pub descriptor: u8,
    /// In place of a decimation.
    ///
    /// Send 0.
    pub reserved: u16,
}

impl PollEntry {
    /// Puts the values together.
    #[must_use]
    pub fn new(descriptor: u8) -> Self {
        Self { descriptor, reserved: 0 }
    }
}

impl Wire for PollEntry {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let descriptor = reader.read()?;
        let reserved = reader.read()?;
        Ok(Self { descriptor, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.descriptor)?;
        writer.write(&self.reserved)?;
        Ok(())
    }
}

open_enum! {
    /// What happens to the message formats that are set.
    ///
    /// - Manual 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
    FactoryStreamingAction: u8 {
        /// The formats are replaced.
        OVERWRITE = 0, "overwrite";
        /// The support fields are merged into the formats; the order may change.
        MERGE = 1, "merge";
        /// The support fields are added behind the formats; fields may occur twice.
        ADD = 2, "add";
    }
}

open_enum! {
    /// A data stream of a 5-series device.
    ///
    /// - Manual 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
    LegacyDataStream: u8 {
        /// All streams; for save, load and default only.
        ALL_STREAMS = 0, "all_streams";
        /// Sensor data (0x80).
        IMU = 1, "imu";
        /// GNSS data.
        GNSS = 2, "gnss";
        /// Estimation filter data (0x82).
        FILTER = 3, "filter";
    }
}

open_enum! {
    /// Constellation in the settings of a receiver. The values are not those of gnss_constellation,
    /// which GNSS data use.
    ///
    /// - Manual mip-sdk-4: Constellation Settings (0x0C,0x21)
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
    /// - Manual mip-sdk-4: Constellation Settings (0x0C,0x21)
    ConstellationOptions: u16 {
        /// The L1-SAIF signal; QZSS only.
        L1SAIF: bool = 0,
            "l1saif", l1saif, set_l1saif, with_l1saif;
    }
}

/// How a receiver tracks one constellation.
///
/// - Manual mip-sdk-4: Constellation Settings (0x0C,0x21)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConstellationSettingsEntry {
    /// Constellation.
    pub constellation_id: ConstellationId,
    /// 1 switches it on, 0 off.
    ///
    /// Range: 0 to 1.
    pub enable: u8,
    /// Channels that are kept for it.
    ///
    /// Unit: 1; range: 0 to 32.
    pub reserved_channels: u8,
    /// Channels that it takes at most.
    ///
    /// Unit: 1; range: 0 to 32.
    pub max_channels: u8,
    /// Options.
    pub option_flags: ConstellationOptions,
}

impl ConstellationSettingsEntry {
    /// Puts the values together.
    #[must_use]
    pub fn new(
        constellation_id: ConstellationId,
        enable: u8,
        reserved_channels: u8,
        max_channels: u8,
        option_flags: ConstellationOptions,
    ) -> Self {
        Self { constellation_id, enable, reserved_channels, max_channels, option_flags }
    }
}

impl Wire for ConstellationSettingsEntry {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let constellation_id = reader.read()?;
        let enable = reader.read()?;
        let reserved_channels = reader.read()?;
        let max_channels = reader.read()?;
        let option_flags = reader.read()?;
        Ok(Self { constellation_id, enable, reserved_channels, max_channels, option_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.constellation_id)?;
        writer.write(&self.enable)?;
        writer.write(&self.reserved_channels)?;
        writer.write(&self.max_channels)?;
        writer.write(&self.option_flags)?;
        Ok(())
    }
}

bitfield! {
    /// How SBAS is used.
    ///
    /// - Manual 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
    SbasOptions: u16 {
        /// SBAS pseudoranges take part in the position solution.
        ENABLE_RANGING: bool = 0,
            "enable_ranging", enable_ranging, set_enable_ranging, with_enable_ranging;
        /// SBAS differential corrections are applied.
        ENABLE_CORRECTIONS: bool = 1,
            "enable_corrections", enable_corrections, set_enable_corrections,
            with_enable_corrections;
        /// Only GPS satellites with SBAS integrity information are used.
        APPLY_INTEGRITY: bool = 2,
            "apply_integrity", apply_integrity, set_apply_integrity, with_apply_integrity;
    }
}

open_enum! {
    /// Whether a receiver keeps its last fix.
    ///
    /// - Manual mip-sdk-4: Gnss Assisted Fix (0x0C,0x23)
    AssistedFixOption: u8 {
        /// The receiver starts without it.
        NONE = 0, "none";
        /// The receiver starts from its last fix.
        ENABLED = 1, "enabled";
    }
}

open_enum! {
    /// Where the pulse per second comes from.
    ///
    /// - Manual 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
    PpsSource: u8 {
        /// No pulse.
        DISABLED = 0, "disabled";
        /// From GNSS receiver 1.
        RECEIVER_1 = 1, "receiver_1";
        /// From GNSS receiver 2.
        RECEIVER_2 = 2, "receiver_2";
        /// From a GPIO pin that is configured as a PPS input.
        GPIO = 3, "gpio";
        /// From the oscillator of the device.
        GENERATED = 4, "generated";
    }
}

open_enum! {
    /// Which part of the event system is asked about.
    ///
    /// - Manual 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
    SupportedEventsQuery: u8 {
        /// Triggers.
        TRIGGER_TYPES = 1, "trigger_types";
        /// Actions.
        ACTION_TYPES = 2, "action_types";
    }
}

/// How many instances of one trigger or action type a device can have.
///
/// - Manual 3dm-cv7-gnss-ins: Info
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SupportedEventInfo {
    /// A value of event_trigger_type if triggers were asked about, else of event_action_type.
    pub type_: u8,
    /// Instances of this type at most.
    ///
    /// Unit: 1.
    pub count: u8,
}

impl SupportedEventInfo {
    /// Puts the values together.
    #[must_use]
    pub fn new(type_: u8, count: u8) -> Self {
        Self { type_, count }
    }
}

impl Wire for SupportedEventInfo {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let type_ = reader.read()?;
        let count = reader.read()?;
        Ok(Self { type_, count })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.type_)?;
        writer.write(&self.count)?;
        Ok(())
    }
}

/// Type and state of one trigger.
///
/// - Manual 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventTriggerStatusEntry {
    /// Configured type.
    pub type_: types::EventTriggerType,
    /// State.
    pub status: types::EventTriggerStatus,
}

impl EventTriggerStatusEntry {
    /// Puts the values together.
    #[must_use]
    pub fn new(type_: types::EventTriggerType, status: types::EventTriggerStatus) -> Self {
        Self { type_, status }
    }
}

impl Wire for EventTriggerStatusEntry {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let type_ = reader.read()?;
        let status = reader.read()?;
        Ok(Self { type_, status })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.type_)?;
        writer.write(&self.status)?;
        Ok(())
    }
}

/// Type and trigger of one action.
///
/// - Manual 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventActionStatusEntry {
    /// Configured type.
    pub action_type: types::EventActionType,
    /// Trigger instance that the action follows.
    pub trigger_id: u8,
}

impl EventActionStatusEntry {
    /// Puts the values together.
    #[must_use]
    pub fn new(action_type: types::EventActionType, trigger_id: u8) -> Self {
        Self { action_type, trigger_id }
    }
}

impl Wire for EventActionStatusEntry {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let action_type = reader.read()?;
        let trigger_id = reader.read()?;
        Ok(Self { action_type, trigger_id })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.action_type)?;
        writer.write(&self.trigger_id)?;
        Ok(())
    }
}

open_enum! {
    /// How the odometer input works.
    ///
    /// - Manual 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
    OdometerMode: u8 {
        /// Not used.
        DISABLED = 0, "disabled";
        /// Quadrature encoder on two pins.
        QUADRATURE = 2, "quadrature";
    }
}

open_enum! {
    /// A sensor whose range can be set, which also decides the unit of the range.
    ///
    /// - Manual 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
    SensorRangeType: u8 {
        /// All sensors; for save, load and default only.
        ALL = 0, "all";
        /// Accelerometer; standard gravities.
        ACCEL = 1, "accel";
        /// Gyroscope; degrees per second.
        GYRO = 2, "gyro";
        /// Magnetometer; gauss.
        MAG = 3, "mag";
        /// Pressure sensor; hectopascals, that is millibars.
        PRESS = 4, "press";
    }
}

/// A range that a sensor supports.
///
/// - Manual 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorRangeEntry {
    /// Value for the sensor range command.
    pub setting: u8,
    /// Largest measurable value; sensor_range_type gives the unit.
    pub range: f32,
}

impl SensorRangeEntry {
    /// Puts the values together.
    #[must_use]
    pub fn new(setting: u8, range: f32) -> Self {
        Self { setting, range }
    }
}

impl Wire for SensorRangeEntry {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let setting = reader.read()?;
        let range = reader.read()?;
        Ok(Self { setting, range })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.setting)?;
        writer.write(&self.range)?;
        Ok(())
    }
}

open_enum! {
    /// How much a device status tells.
    ///
    /// - Manual 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
    DeviceStatusSelector: u8 {
        /// State and timer.
        BASIC = 1, "basic";
        /// State and timer with the counters of streams and port.
        DIAGNOSTIC = 2, "diagnostic";
    }
}

/// Poll IMU Data (0x0C,0x01).
///
/// Asks for one sensor data packet (0x80) with the fields listed, in their order.
///
/// - An empty list polls the stored message format; without one the device refuses.
/// - Descriptors that the device does not know are ignored.
/// - The data comes in a packet of its own behind the reply.
///
/// Not acknowledged if `suppress_ack` is true. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.1 Poll IMU Data (0x0C, 0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PollImuData {
    /// Send no acknowledge.
    pub suppress_ack: crate::Bool,
    /// Fields to send.
    pub descriptors: crate::List<PollEntry, 83>,
}

impl PollImuData {
    /// The command with its parameters.
    #[must_use]
    pub fn new(suppress_ack: bool, descriptors: impl Into<crate::List<PollEntry, 83>>) -> Self {
        Self { suppress_ack: suppress_ack.into(), descriptors: descriptors.into() }
    }
}

impl Wire for PollImuData {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let suppress_ack = reader.read()?;
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { suppress_ack, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.suppress_ack)?;
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for PollImuData {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "3dm.poll_imu_data";
}

impl Command for PollImuData {
    type Response = ();

    fn expects_reply(&self) -> bool {
        !(self.suppress_ack == crate::Bool(1))
    }
}

/// Poll GNSS Data (0x0C,0x02).
///
/// Asks for one GNSS data packet with the fields listed, in their order.
///
/// - An empty list polls the stored GNSS message format (0x0C,0x09); without one the device
///   refuses.
/// - Descriptors that the device does not know are left out.
/// - The data comes in a packet of its own behind the reply.
///
/// Not acknowledged if `suppress_ack` is true.
///
/// - Manual mip-sdk-4: Poll Gnss Message (0x0C,0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PollGnssData {
    /// Send no acknowledge.
    pub suppress_ack: crate::Bool,
    /// Fields to send.
    pub descriptors: crate::List<PollEntry, 83>,
}

impl PollGnssData {
    /// The command with its parameters.
    #[must_use]
    pub fn new(suppress_ack: bool, descriptors: impl Into<crate::List<PollEntry, 83>>) -> Self {
        Self { suppress_ack: suppress_ack.into(), descriptors: descriptors.into() }
    }
}

impl Wire for PollGnssData {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let suppress_ack = reader.read()?;
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { suppress_ack, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.suppress_ack)?;
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for PollGnssData {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "3dm.poll_gnss_data";
}

impl Command for PollGnssData {
    type Response = ();

    fn expects_reply(&self) -> bool {
        !(self.suppress_ack == crate::Bool(1))
    }
}

/// Poll Estimation Filter Data (0x0C,0x03).
///
/// Asks for one filter data packet (0x82) with the fields listed, in their order.
///
/// - An empty list polls the stored message format; without one the device refuses.
/// - Descriptors that the device does not know are ignored.
/// - The data comes in a packet of its own behind the reply.
///
/// Not acknowledged if `suppress_ack` is true. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.2 Poll Estimation Filter Data (0x0C, 0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PollEstimationFilterData {
    /// Send no acknowledge.
    pub suppress_ack: crate::Bool,
    /// Fields to send.
    pub descriptors: crate::List<PollEntry, 83>,
}

impl PollEstimationFilterData {
    /// The command with its parameters.
    #[must_use]
    pub fn new(suppress_ack: bool, descriptors: impl Into<crate::List<PollEntry, 83>>) -> Self {
        Self { suppress_ack: suppress_ack.into(), descriptors: descriptors.into() }
    }
}

impl Wire for PollEstimationFilterData {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let suppress_ack = reader.read()?;
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { suppress_ack, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.suppress_ack)?;
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for PollEstimationFilterData {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "3dm.poll_estimation_filter_data";
}

impl Command for PollEstimationFilterData {
    type Response = ();

    fn expects_reply(&self) -> bool {
        !(self.suppress_ack == crate::Bool(1))
    }
}

/// Poll NMEA Data (0x0C,0x04).
///
/// Asks for the NMEA sentences listed, once.
///
/// - An empty list polls the stored NMEA format; without one the device refuses.
/// - The sentences follow the reply as ordinary NMEA text, on the port of the command even if NMEA
///   is off there.
/// - A sentence is sent only if its data is valid.
///
/// Not acknowledged if `suppress_ack` is true. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Poll NMEA Data (0x0C,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PollNmeaData {
    /// Send no acknowledge.
    pub suppress_ack: crate::Bool,
    /// Sentences to send.
    pub format_entries: crate::List<types::NmeaMessage, 50>,
}

impl PollNmeaData {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        suppress_ack: bool,
        format_entries: impl Into<crate::List<types::NmeaMessage, 50>>,
    ) -> Self {
        Self { suppress_ack: suppress_ack.into(), format_entries: format_entries.into() }
    }
}

impl Wire for PollNmeaData {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let suppress_ack = reader.read()?;
        let count = reader.read::<u8>()?;
        let format_entries = reader.list(count)?;
        Ok(Self { suppress_ack, format_entries })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.suppress_ack)?;
        writer.count::<u8>(self.format_entries.len())?;
        self.format_entries.encode_items(writer)?;
        Ok(())
    }
}

impl Field for PollNmeaData {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "3dm.poll_nmea_data";
}

impl Command for PollNmeaData {
    type Response = ();

    fn expects_reply(&self) -> bool {
        !(self.suppress_ack == crate::Bool(1))
    }
}

/// Get IMU Data Base Rate (0x0C,0x06).
///
/// Asks for the rate that the decimations of the IMU message format divide.
///
/// Response: [`GetImuDataBaseRateResponse`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetImuDataBaseRate;

impl GetImuDataBaseRate {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetImuDataBaseRate {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetImuDataBaseRate {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x06;
    const NAME: &'static str = "3dm.get_imu_data_base_rate";
}

impl Command for GetImuDataBaseRate {
    type Response = GetImuDataBaseRateResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetImuDataBaseRate> for GetImuDataBaseRateResponse {}

/// Get GNSS Data Base Rate (0x0C,0x07).
///
/// Asks for the rate that the decimations of the GNSS message format divide.
///
/// Response: [`GetGnssDataBaseRateResponse`].
///
/// - Manual mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetGnssDataBaseRate;

impl GetGnssDataBaseRate {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetGnssDataBaseRate {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetGnssDataBaseRate {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x07;
    const NAME: &'static str = "3dm.get_gnss_data_base_rate";
}

impl Command for GetGnssDataBaseRate {
    type Response = GetGnssDataBaseRateResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetGnssDataBaseRate> for GetGnssDataBaseRateResponse {}

/// IMU Message Format (0x0C,0x08).
///
/// Fields of the sensor data packets (0x80), in order, with their decimations.
///
/// - The decimation is the base rate, as the get IMU data base rate command reports it, divided by
///   the wanted rate.
/// - The list replaces the one before. If any descriptor is unknown the device refuses and changes
///   nothing.
///
/// Functions: write, read, save, load, default. Response: [`ImuMessageFormatResponse`]. Supported
/// by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ImuMessageFormat {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Fields and decimations.
    pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
}

impl ImuMessageFormat {
    /// Apply the new setting.
    #[must_use]
    pub fn write(descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> Self {
        Self { function: types::FunctionSelector::WRITE, descriptors: Some(descriptors.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, descriptors: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, descriptors: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, descriptors: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, descriptors: None }
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

impl Wire for ImuMessageFormat {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let descriptors = reader.group(required >= 2, |reader| {
            let num_descriptors = reader.read::<u8>()?;
            let descriptors = reader.list(num_descriptors)?;
            Ok(descriptors)
        })?;
        Ok(Self { function, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        if let Some(descriptors) = writer.optional(required >= 2, &self.descriptors)? {
            writer.count::<u8>(descriptors.len())?;
            descriptors.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for ImuMessageFormat {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x08;
    const NAME: &'static str = "3dm.imu_message_format";
}

impl Command for ImuMessageFormat {
    type Response = ImuMessageFormatResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ImuMessageFormat> for ImuMessageFormatResponse {}

/// GNSS Message Format (0x0C,0x09).
///
/// Fields of the GNSS data packets, in order, with their decimations.
///
/// - The decimation is the base rate, as the get GNSS data base rate command reports it, divided by
///   the wanted rate.
///
/// Functions: write, read, save, load, default. Response: [`GnssMessageFormatResponse`].
///
/// - Manual mip-sdk-4: Gnss Message Format (0x0C,0x09)
/// - Manual 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssMessageFormat {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Fields and decimations.
    pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
}

impl GnssMessageFormat {
    /// Apply the new setting.
    #[must_use]
    pub fn write(descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> Self {
        Self { function: types::FunctionSelector::WRITE, descriptors: Some(descriptors.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, descriptors: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, descriptors: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, descriptors: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, descriptors: None }
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

impl Wire for GnssMessageFormat {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let descriptors = reader.group(required >= 2, |reader| {
            let num_descriptors = reader.read::<u8>()?;
            let descriptors = reader.list(num_descriptors)?;
            Ok(descriptors)
        })?;
        Ok(Self { function, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        if let Some(descriptors) = writer.optional(required >= 2, &self.descriptors)? {
            writer.count::<u8>(descriptors.len())?;
            descriptors.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for GnssMessageFormat {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x09;
    const NAME: &'static str = "3dm.gnss_message_format";
}

impl Command for GnssMessageFormat {
    type Response = GnssMessageFormatResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssMessageFormat> for GnssMessageFormatResponse {}

/// Estimation Filter Message Format (0x0C,0x0A).
///
/// Fields of the filter data packets (0x82), in order, with their decimations.
///
/// - The decimation is the base rate, as the get estimation filter data base rate command reports
///   it, divided by the wanted rate.
/// - The list replaces the one before. If any descriptor is unknown the device refuses and changes
///   nothing.
///
/// Functions: write, read, save, load, default. Response:
/// [`EstimationFilterMessageFormatResponse`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EstimationFilterMessageFormat {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Fields and decimations.
    pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
}

impl EstimationFilterMessageFormat {
    /// Apply the new setting.
    #[must_use]
    pub fn write(descriptors: impl Into<crate::List<types::DescriptorRate, 83>>) -> Self {
        Self { function: types::FunctionSelector::WRITE, descriptors: Some(descriptors.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, descriptors: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, descriptors: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, descriptors: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, descriptors: None }
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

impl Wire for EstimationFilterMessageFormat {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let descriptors = reader.group(required >= 2, |reader| {
            let num_descriptors = reader.read::<u8>()?;
            let descriptors = reader.list(num_descriptors)?;
            Ok(descriptors)
        })?;
        Ok(Self { function, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        if let Some(descriptors) = writer.optional(required >= 2, &self.descriptors)? {
            writer.count::<u8>(descriptors.len())?;
            descriptors.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for EstimationFilterMessageFormat {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x0A;
    const NAME: &'static str = "3dm.estimation_filter_message_format";
}

impl Command for EstimationFilterMessageFormat {
    type Response = EstimationFilterMessageFormatResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<EstimationFilterMessageFormat> for EstimationFilterMessageFormatResponse {}

/// Get Estimation Filter Data Base Rate (0x0C,0x0B).
///
/// Asks for the rate that the decimations of the estimation filter message format divide.
///
/// Response: [`GetEstimationFilterDataBaseRateResponse`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetEstimationFilterDataBaseRate;

impl GetEstimationFilterDataBaseRate {
    /// The command with its parameters.
    #[must_use]
    pub fn new() -> Self {
        Self
    }
}

impl Wire for GetEstimationFilterDataBaseRate {
    const SIZE: usize = 0;

    fn decode_from(_: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }

    fn encode_to(&self, _: &mut Writer<'_>) -> Result<(), EncodeError> {
        Ok(())
    }
}

impl Field for GetEstimationFilterDataBaseRate {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x0B;
    const NAME: &'static str = "3dm.get_estimation_filter_data_base_rate";
}

impl Command for GetEstimationFilterDataBaseRate {
    type Response = GetEstimationFilterDataBaseRateResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetEstimationFilterDataBaseRate> for GetEstimationFilterDataBaseRateResponse {}

/// NMEA Message Format (0x0C,0x0C).
///
/// NMEA sentences that the device streams.
///
/// - A sentence may be listed several times with different talkers or sources.
/// - A sentence is sent only while the device is not idle and the data of the source is valid.
///
/// Functions: write, read, save, load, default. Response: [`NmeaMessageFormatResponse`]. Supported
/// by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NmeaMessageFormat {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Sentences to stream.
    pub format_entries: Option<crate::List<types::NmeaMessage, 50>>,
}

impl NmeaMessageFormat {
    /// Apply the new setting.
    #[must_use]
    pub fn write(format_entries: impl Into<crate::List<types::NmeaMessage, 50>>) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            format_entries: Some(format_entries.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, format_entries: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, format_entries: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, format_entries: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, format_entries: None }
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

impl Wire for NmeaMessageFormat {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let format_entries = reader.group(required >= 2, |reader| {
            let count = reader.read::<u8>()?;
            let format_entries = reader.list(count)?;
            Ok(format_entries)
        })?;
        Ok(Self { function, format_entries })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        if let Some(format_entries) = writer.optional(required >= 2, &self.format_entries)? {
            writer.count::<u8>(format_entries.len())?;
            format_entries.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for NmeaMessageFormat {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x0C;
    const NAME: &'static str = "3dm.nmea_message_format";
}

impl Command for NmeaMessageFormat {
    type Response = NmeaMessageFormatResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<NmeaMessageFormat> for NmeaMessageFormatResponse {}

/// Poll Data (0x0C,0x0D).
///
/// Asks for one data packet of the descriptor set with the fields listed, in their order.
///
/// - An empty list polls the stored message format; without one the device refuses.
/// - Descriptors that the device does not know are ignored.
/// - The data comes in a packet of its own behind the reply, on the port of the command.
/// - Shared descriptors (0xD0 and up) belong in front of the others.
///
/// Not acknowledged if `suppress_ack` is true. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Poll Data (0x0C,0x0D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PollData {
    /// Data descriptor set.
    ///
    /// Range: 128 to 254.
    pub desc_set: u8,
    /// Send no acknowledge.
    pub suppress_ack: crate::Bool,
    /// Field descriptors.
    pub descriptors: crate::List<u8, 250>,
}

impl PollData {
    /// The command with its parameters.
    #[must_use]
    pub fn new(
        desc_set: u8,
        suppress_ack: bool,
        descriptors: impl Into<crate::List<u8, 250>>,
    ) -> Self {
        Self { desc_set, suppress_ack: suppress_ack.into(), descriptors: descriptors.into() }
    }
}

impl Wire for PollData {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let desc_set = reader.read()?;
        let suppress_ack = reader.read()?;
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { desc_set, suppress_ack, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.desc_set)?;
        writer.write(&self.suppress_ack)?;
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for PollData {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x0D;
    const NAME: &'static str = "3dm.poll_data";
}

impl Command for PollData {
    type Response = ();

    fn expects_reply(&self) -> bool {
        !(self.suppress_ack == crate::Bool(1))
    }
}

/// Get Data Base Rate (0x0C,0x0E).
///
/// Asks for the rate that the decimations of a descriptor set divide.
///
/// Response: [`GetDataBaseRateResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDataBaseRate {
    /// Data descriptor set.
    ///
    /// Range: 128 to 254.
    pub desc_set: u8,
}

impl GetDataBaseRate {
    /// The command with its parameters.
    #[must_use]
    pub fn new(desc_set: u8) -> Self {
        Self { desc_set }
    }
}

impl Wire for GetDataBaseRate {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let desc_set = reader.read()?;
        Ok(Self { desc_set })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.desc_set)?;
        Ok(())
    }
}

impl Field for GetDataBaseRate {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x0E;
    const NAME: &'static str = "3dm.get_data_base_rate";
}

impl Command for GetDataBaseRate {
    type Response = GetDataBaseRateResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetDataBaseRate> for GetDataBaseRateResponse {}

/// Message Format (0x0C,0x0F).
///
/// Fields of the data packets of a descriptor set, in order, with their decimations.
///
/// - The decimation is the base rate, as the get data base rate command reports it, divided by the
///   wanted rate.
/// - Shared descriptors (0xD0 and up) are listed under the set that they shall be sent with, in
///   front of the others.
///
/// Functions: write, read, save, load, default. Response: [`MessageFormatResponse`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MessageFormat {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Data descriptor set; 0 means all of them (save, load, default).
    pub desc_set: Option<u8>,
    /// Fields and decimations.
    pub descriptors: Option<crate::List<types::DescriptorRate, 83>>,
}

impl MessageFormat {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        desc_set: u8,
        descriptors: impl Into<crate::List<types::DescriptorRate, 83>>,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            desc_set: Some(desc_set),
            descriptors: Some(descriptors.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(desc_set: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            desc_set: Some(desc_set),
            descriptors: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(desc_set: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            desc_set: Some(desc_set),
            descriptors: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(desc_set: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            desc_set: Some(desc_set),
            descriptors: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(desc_set: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            desc_set: Some(desc_set),
            descriptors: None,
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

impl Wire for MessageFormat {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let desc_set = reader.group(required >= 1, Reader::read)?;
        let descriptors = reader.group(required >= 3, |reader| {
            let num_descriptors = reader.read::<u8>()?;
            let descriptors = reader.list(num_descriptors)?;
            Ok(descriptors)
        })?;
        Ok(Self { function, desc_set, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.desc_set)?;
        if let Some(descriptors) = writer.optional(required >= 3, &self.descriptors)? {
            writer.count::<u8>(descriptors.len())?;
            descriptors.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for MessageFormat {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x0F;
    const NAME: &'static str = "3dm.message_format";
}

impl Command for MessageFormat {
    type Response = MessageFormatResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MessageFormat> for MessageFormatResponse {}

/// Factory Streaming (0x0C,0x10).
///
/// Sets all message formats to those that technical support wants to have recorded.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Factory Streaming (0x0C,0x10)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FactoryStreaming {
    /// What happens to the present formats.
    pub action: FactoryStreamingAction,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: u8,
}

impl FactoryStreaming {
    /// The command with its parameters.
    #[must_use]
    pub fn new(action: FactoryStreamingAction) -> Self {
        Self { action, reserved: 0 }
    }
}

impl Wire for FactoryStreaming {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let action = reader.read()?;
        let reserved = reader.read()?;
        Ok(Self { action, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.action)?;
        writer.write(&self.reserved)?;
        Ok(())
    }
}

impl Field for FactoryStreaming {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x10;
    const NAME: &'static str = "3dm.factory_streaming";
}

impl Command for FactoryStreaming {
    type Response = ();
}

/// Data Stream Control (0x0C,0x11).
///
/// Switches a data stream on or off.
///
/// - 5-series devices name the stream by a number of their own (legacy_data_stream), others by its
///   descriptor set.
///
/// Functions: write, read, save, load, default. Response: [`DataStreamControlResponse`]. Supported
/// by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
/// - Manual 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DataStreamControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Data descriptor set; 0 means all streams (save, load, default).
    pub desc_set: Option<u8>,
    /// Whether the stream is sent.
    ///
    /// Default: true.
    pub enable: Option<crate::Bool>,
}

impl DataStreamControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(desc_set: u8, enable: bool) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            desc_set: Some(desc_set),
            enable: Some(enable.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(desc_set: u8) -> Self {
        Self { function: types::FunctionSelector::READ, desc_set: Some(desc_set), enable: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(desc_set: u8) -> Self {
        Self { function: types::FunctionSelector::SAVE, desc_set: Some(desc_set), enable: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(desc_set: u8) -> Self {
        Self { function: types::FunctionSelector::LOAD, desc_set: Some(desc_set), enable: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(desc_set: u8) -> Self {
        Self { function: types::FunctionSelector::DEFAULT, desc_set: Some(desc_set), enable: None }
    }

    /// The meaning of `desc_set` on the 3DM-GX5-15.
    #[must_use]
    pub fn desc_set_as_legacy_data_stream(&self) -> Option<LegacyDataStream> {
        self.desc_set.map(LegacyDataStream)
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for DataStreamControl {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let desc_set = reader.group(required >= 1, Reader::read)?;
        let enable = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, desc_set, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.desc_set)?;
        writer.some(required >= 2, &self.enable)?;
        Ok(())
    }
}

impl Field for DataStreamControl {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x11;
    const NAME: &'static str = "3dm.data_stream_control";
}

impl Command for DataStreamControl {
    type Response = DataStreamControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<DataStreamControl> for DataStreamControlResponse {}

/// Constellation Settings (0x0C,0x21).
///
/// Constellations that the GNSS receiver tracks, and how its tracking channels are shared.
///
/// - The device refuses entries whose reserved channels exceed 32 in all. No entry may have fewer
///   channels at most than it reserves.
/// - GLONASS and BeiDou exclude each other.
/// - If the antenna or its filter is made for GPS alone, leave GLONASS and BeiDou off.
/// - SBAS and QZSS improve the accuracy of GPS. SBAS does not make the device fit for
///   safety-of-life use.
/// - Factory default: GPS and GLONASS are enabled. Channels reserved and at most: GPS 8 and 16,
///   GLONASS 8 and 14, SBAS 1 and 3, QZSS 0 and 3.
///
/// Functions: write, read, save, load, default. Response: [`ConstellationSettingsResponse`].
///
/// - Manual mip-sdk-4: Constellation Settings (0x0C,0x21)
/// - Manual 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConstellationSettings {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Tracking channels in use at most; no more than the response reports as available.
    ///
    /// Unit: 1.
    pub max_channels: Option<u16>,
    /// One entry for each constellation.
    pub settings: Option<crate::List<ConstellationSettingsEntry, 41>>,
}

impl ConstellationSettings {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        max_channels: u16,
        settings: impl Into<crate::List<ConstellationSettingsEntry, 41>>,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            max_channels: Some(max_channels),
            settings: Some(settings.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, max_channels: None, settings: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, max_channels: None, settings: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, max_channels: None, settings: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, max_channels: None, settings: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for ConstellationSettings {
    const SIZE: usize = 250;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let max_channels = reader.group(required >= 1, Reader::read)?;
        let settings = reader.group(required >= 3, |reader| {
            let config_count = reader.read::<u8>()?;
            let settings = reader.list(config_count)?;
            Ok(settings)
        })?;
        Ok(Self { function, max_channels, settings })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.max_channels)?;
        if let Some(settings) = writer.optional(required >= 3, &self.settings)? {
            writer.count::<u8>(settings.len())?;
            settings.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for ConstellationSettings {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x21;
    const NAME: &'static str = "3dm.constellation_settings";
}

impl Command for ConstellationSettings {
    type Response = ConstellationSettingsResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ConstellationSettings> for ConstellationSettingsResponse {}

/// GNSS SBAS Settings (0x0C,0x22).
///
/// How the GNSS receivers use satellite based augmentation.
///
/// Functions: write, read, save, load, default. Response: [`GnssSbasSettingsResponse`]. Supported
/// by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssSbasSettings {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// 1 switches SBAS on, 0 off.
    ///
    /// Range: 0 to 1.
    pub enable_sbas: Option<u8>,
    /// What SBAS is used for.
    pub sbas_options: Option<SbasOptions>,
    /// PRN numbers of the SBAS satellites to search for.
    pub included_prns: Option<crate::List<u16, 124>>,
}

impl GnssSbasSettings {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        enable_sbas: u8,
        sbas_options: SbasOptions,
        included_prns: impl Into<crate::List<u16, 124>>,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            enable_sbas: Some(enable_sbas),
            sbas_options: Some(sbas_options),
            included_prns: Some(included_prns.into()),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            enable_sbas: None,
            sbas_options: None,
            included_prns: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            enable_sbas: None,
            sbas_options: None,
            included_prns: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            enable_sbas: None,
            sbas_options: None,
            included_prns: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            enable_sbas: None,
            sbas_options: None,
            included_prns: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 4,
            _ => 0,
        }
    }
}

impl Wire for GnssSbasSettings {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable_sbas = reader.group(required >= 1, Reader::read)?;
        let sbas_options = reader.group(required >= 2, Reader::read)?;
        let included_prns = reader.group(required >= 4, |reader| {
            let num_included_prns = reader.read::<u8>()?;
            let included_prns = reader.list(num_included_prns)?;
            Ok(included_prns)
        })?;
        Ok(Self { function, enable_sbas, sbas_options, included_prns })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable_sbas)?;
        writer.some(required >= 2, &self.sbas_options)?;
        if let Some(included_prns) = writer.optional(required >= 4, &self.included_prns)? {
            writer.count::<u8>(included_prns.len())?;
            included_prns.encode_items(writer)?;
        }
        Ok(())
    }
}

impl Field for GnssSbasSettings {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x22;
    const NAME: &'static str = "3dm.gnss_sbas_settings";
}

impl Command for GnssSbasSettings {
    type Response = GnssSbasSettingsResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssSbasSettings> for GnssSbasSettingsResponse {}

/// GNSS Assisted Fix (0x0C,0x23).
///
/// Whether the GNSS receiver keeps the data of its last fix to start from at the next power-up.
///
/// - The last fix is kept in the flash memory and the FRAM of the receiver.
/// - With the time of GNSS time assistance (0x0C,0x24) right after power-up, the first fix takes 1
///   s at best.
/// - A change from enabled to none erases the flash memory of the receiver, which stands 100 000
///   erasures.
/// - It takes slightly more power.
///
/// Functions: write, read, save, load, default. Response: [`GnssAssistedFixResponse`].
///
/// - Manual mip-sdk-4: Gnss Assisted Fix (0x0C,0x23)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAssistedFix {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Assisted fix.
    ///
    /// Default: none.
    pub option: Option<AssistedFixOption>,
    /// Reserved.
    ///
    /// Send 255.
    pub flags: Option<u8>,
}

impl GnssAssistedFix {
    /// Apply the new setting.
    #[must_use]
    pub fn write(option: AssistedFixOption) -> Self {
        Self { function: types::FunctionSelector::WRITE, option: Some(option), flags: Some(255) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, option: None, flags: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, option: None, flags: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, option: None, flags: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, option: None, flags: None }
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

impl Wire for GnssAssistedFix {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let option = reader.group(required >= 1, Reader::read)?;
        let flags = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, option, flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.option)?;
        writer.some(required >= 2, &self.flags)?;
        Ok(())
    }
}

impl Field for GnssAssistedFix {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x23;
    const NAME: &'static str = "3dm.gnss_assisted_fix";
}

impl Command for GnssAssistedFix {
    type Response = GnssAssistedFixResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssAssistedFix> for GnssAssistedFixResponse {}

/// GNSS Time Assistance (0x0C,0x24).
///
/// Tells the GNSS receiver the present GPS time.
///
/// - It is needed right after power-up if the assisted fix (0x0C,0x23) was on at power-off.
///
/// Functions: write, read. Response: [`GnssTimeAssistanceResponse`].
///
/// - Manual mip-sdk-4: Gnss Time Assistance (0x0C,0x24)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssTimeAssistance {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// GPS time of week.
    ///
    /// Unit: s.
    pub tow: Option<f64>,
    /// GPS week number since 1980.
    ///
    /// Unit: week.
    pub week_number: Option<u16>,
    /// Accuracy of the time.
    ///
    /// Unit: s.
    pub accuracy: Option<f32>,
}

impl GnssTimeAssistance {
    /// Apply the new setting.
    #[must_use]
    pub fn write(tow: f64, week_number: u16, accuracy: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            tow: Some(tow),
            week_number: Some(week_number),
            accuracy: Some(accuracy),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            tow: None,
            week_number: None,
            accuracy: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for GnssTimeAssistance {
    const SIZE: usize = 15;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let tow = reader.group(required >= 1, Reader::read)?;
        let week_number = reader.group(required >= 2, Reader::read)?;
        let accuracy = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, tow, week_number, accuracy })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.tow)?;
        writer.some(required >= 2, &self.week_number)?;
        writer.some(required >= 3, &self.accuracy)?;
        Ok(())
    }
}

impl Field for GnssTimeAssistance {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x24;
    const NAME: &'static str = "3dm.gnss_time_assistance";
}

impl Command for GnssTimeAssistance {
    type Response = GnssTimeAssistanceResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GnssTimeAssistance> for GnssTimeAssistanceResponse {}

/// PPS Source Control (0x0C,0x28).
///
/// Where the device takes its pulse per second from.
///
/// - The pins are configured apart from this by the GPIO configuration command.
/// - The filter needs a valid pulse. disabled and generated are seldom what is wanted.
///
/// Functions: write, read, save, load, default. Response: [`PpsSourceControlResponse`]. Supported
/// by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PpsSourceControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Source of the pulse.
    ///
    /// Default: receiver_1.
    pub source: Option<PpsSource>,
}

impl PpsSourceControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(source: PpsSource) -> Self {
        Self { function: types::FunctionSelector::WRITE, source: Some(source) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, source: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, source: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, source: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, source: None }
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

impl Wire for PpsSourceControl {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let source = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, source })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.source)?;
        Ok(())
    }
}

impl Field for PpsSourceControl {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x28;
    const NAME: &'static str = "3dm.pps_source_control";
}

impl Command for PpsSourceControl {
    type Response = PpsSourceControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<PpsSourceControl> for PpsSourceControlResponse {}

/// Get Supported Events (0x0C,0x2A).
///
/// Asks which types of event triggers or actions there are and how many of each.
///
/// Response: [`GetSupportedEventsResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetSupportedEvents {
    /// Triggers or actions.
    pub query: SupportedEventsQuery,
}

impl GetSupportedEvents {
    /// The command with its parameters.
    #[must_use]
    pub fn new(query: SupportedEventsQuery) -> Self {
        Self { query }
    }
}

impl Wire for GetSupportedEvents {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let query = reader.read()?;
        Ok(Self { query })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.query)?;
        Ok(())
    }
}

impl Field for GetSupportedEvents {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x2A;
    const NAME: &'static str = "3dm.get_supported_events";
}

impl Command for GetSupportedEvents {
    type Response = GetSupportedEventsResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetSupportedEvents> for GetSupportedEventsResponse {}

/// Event Control (0x0C,0x2B).
///
/// Enables, disables or tests an event trigger.
///
/// - Triggers are disabled by default and after configuration.
/// - A trigger of type none cannot be enabled.
///
/// Functions: write, read, save, load, default. Response: [`EventControlResponse`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventControl {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Trigger instance; 0 means all configured triggers, except for read.
    pub instance: Option<u8>,
    /// New mode.
    ///
    /// Default: disabled.
    pub mode: Option<types::EventTriggerMode>,
}

impl EventControl {
    /// Apply the new setting.
    #[must_use]
    pub fn write(instance: u8, mode: types::EventTriggerMode) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            instance: Some(instance),
            mode: Some(mode),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(instance: u8) -> Self {
        Self { function: types::FunctionSelector::READ, instance: Some(instance), mode: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(instance: u8) -> Self {
        Self { function: types::FunctionSelector::SAVE, instance: Some(instance), mode: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(instance: u8) -> Self {
        Self { function: types::FunctionSelector::LOAD, instance: Some(instance), mode: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(instance: u8) -> Self {
        Self { function: types::FunctionSelector::DEFAULT, instance: Some(instance), mode: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for EventControl {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let instance = reader.group(required >= 1, Reader::read)?;
        let mode = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, instance, mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.instance)?;
        writer.some(required >= 2, &self.mode)?;
        Ok(())
    }
}

impl Field for EventControl {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x2B;
    const NAME: &'static str = "3dm.event_control";
}

impl Command for EventControl {
    type Response = EventControlResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<EventControl> for EventControlResponse {}

/// Get Event Trigger Status (0x0C,0x2C).
///
/// Asks for the type and the state of event triggers.
///
/// Response: [`GetEventTriggerStatusResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetEventTriggerStatus {
    /// Trigger instances.
    pub requested_instances: crate::List<u8, 252>,
}

impl GetEventTriggerStatus {
    /// The command with its parameters.
    #[must_use]
    pub fn new(requested_instances: impl Into<crate::List<u8, 252>>) -> Self {
        Self { requested_instances: requested_instances.into() }
    }
}

impl Wire for GetEventTriggerStatus {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let requested_count = reader.read::<u8>()?;
        let requested_instances = reader.list(requested_count)?;
        Ok(Self { requested_instances })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.requested_instances.len())?;
        self.requested_instances.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GetEventTriggerStatus {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x2C;
    const NAME: &'static str = "3dm.get_event_trigger_status";
}

impl Command for GetEventTriggerStatus {
    type Response = GetEventTriggerStatusResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetEventTriggerStatus> for GetEventTriggerStatusResponse {}

/// Get Event Action Status (0x0C,0x2D).
///
/// Asks for the type and the trigger of event actions.
///
/// Response: [`GetEventActionStatusResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetEventActionStatus {
    /// Action instances.
    pub requested_instances: crate::List<u8, 252>,
}

impl GetEventActionStatus {
    /// The command with its parameters.
    #[must_use]
    pub fn new(requested_instances: impl Into<crate::List<u8, 252>>) -> Self {
        Self { requested_instances: requested_instances.into() }
    }
}

impl Wire for GetEventActionStatus {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let requested_count = reader.read::<u8>()?;
        let requested_instances = reader.list(requested_count)?;
        Ok(Self { requested_instances })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.requested_instances.len())?;
        self.requested_instances.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GetEventActionStatus {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x2D;
    const NAME: &'static str = "3dm.get_event_action_status";
}

impl Command for GetEventActionStatus {
    type Response = GetEventActionStatusResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetEventActionStatus> for GetEventActionStatusResponse {}

/// Event Trigger Configuration (0x0C,0x2E).
///
/// Kind and condition of an event trigger.
///
/// - The trigger is disabled afterwards; the event control command enables it.
/// - A GPIO trigger needs its pin configured by the GPIO configuration command.
///
/// Functions: write, read, save, load, default. Response: [`EventTriggerConfigurationResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventTriggerConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Trigger instance; 0 means all (save, load, default).
    pub instance: Option<u8>,
    /// Kind of trigger.
    ///
    /// Default: none.
    pub type_: Option<types::EventTriggerType>,
    /// The condition.
    ///
    /// Selected by `type`.
    pub parameters: Option<EventTriggerConfigurationParameters>,
}

impl EventTriggerConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(instance: u8, parameters: EventTriggerConfigurationParameters) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            instance: Some(instance),
            type_: Some(parameters.tag()),
            parameters: Some(parameters),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            instance: Some(instance),
            type_: None,
            parameters: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            instance: Some(instance),
            type_: None,
            parameters: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            instance: Some(instance),
            type_: None,
            parameters: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            instance: Some(instance),
            type_: None,
            parameters: None,
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

impl Wire for EventTriggerConfiguration {
    const SIZE: usize = 23;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let instance = reader.group(required >= 1, Reader::read)?;
        let type_ = reader.group(required >= 2, Reader::read)?;
        let parameters = reader.some_union(required >= 3, type_)?;
        Ok(Self { function, instance, type_, parameters })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.instance)?;
        writer.some(required >= 2, &self.type_)?;
        writer.some_union(required >= 3, self.type_, &self.parameters)?;
        Ok(())
    }
}

/// The alternatives of `parameters` in [`EventTriggerConfiguration`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum EventTriggerConfigurationParameters {
    /// The slot is free. It is never active and cannot be enabled.
    #[default]
    None,
    /// Watches a GPIO pin.
    Gpio(types::EventTriggerGpio),
    /// Compares one value of a data field with thresholds.
    Threshold(types::EventTriggerThreshold),
    /// Combines up to four other triggers by a truth table.
    Combination(types::EventTriggerCombination),
    /// Nothing, for a tag that the specification does not know.
    Other(types::EventTriggerType),
}

impl EventTriggerConfigurationParameters {
    /// The tag that goes with it.
    #[must_use]
    pub const fn tag(&self) -> types::EventTriggerType {
        match self {
            Self::None => types::EventTriggerType::NONE,
            Self::Gpio(_) => types::EventTriggerType::GPIO,
            Self::Threshold(_) => types::EventTriggerType::THRESHOLD,
            Self::Combination(_) => types::EventTriggerType::COMBINATION,
            Self::Other(tag) => *tag,
        }
    }
}

impl Union for EventTriggerConfigurationParameters {
    type Tag = types::EventTriggerType;

    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(match tag {
            types::EventTriggerType::NONE => Self::None,
            types::EventTriggerType::GPIO => Self::Gpio(reader.read()?),
            types::EventTriggerType::THRESHOLD => Self::Threshold(reader.read()?),
            types::EventTriggerType::COMBINATION => Self::Combination(reader.read()?),
            other => Self::Other(other),
        })
    }

    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        if self.tag() != tag {
            return Err(EncodeError::Tag);
        }
        match self {
            Self::None => Ok(()),
            Self::Gpio(value) => writer.write(value),
            Self::Threshold(value) => writer.write(value),
            Self::Combination(value) => writer.write(value),
            Self::Other(tag) if tag.name().is_some() => Err(EncodeError::Tag),
            Self::Other(_) => Ok(()),
        }
    }
}

impl Field for EventTriggerConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x2E;
    const NAME: &'static str = "3dm.event_trigger_configuration";
}

impl Command for EventTriggerConfiguration {
    type Response = EventTriggerConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<EventTriggerConfiguration> for EventTriggerConfigurationResponse {}

/// Event Action Configuration (0x0C,0x2F).
///
/// Trigger and effect of an event action.
///
/// - A packet holds one descriptor set; for several sets use several actions with the same trigger.
/// - A GPIO action needs its pin configured as an output with the gpio feature.
///
/// Functions: write, read, save, load, default. Response: [`EventActionConfigurationResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventActionConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Action instance; 0 means all (save, load, default).
    pub instance: Option<u8>,
    /// Trigger instance that the action follows.
    pub trigger: Option<u8>,
    /// Kind of action.
    ///
    /// Default: none.
    pub type_: Option<types::EventActionType>,
    /// The effect.
    ///
    /// Selected by `type`.
    pub parameters: Option<EventActionConfigurationParameters>,
}

impl EventActionConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        instance: u8,
        trigger: u8,
        parameters: EventActionConfigurationParameters,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            instance: Some(instance),
            trigger: Some(trigger),
            type_: Some(parameters.tag()),
            parameters: Some(parameters),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            instance: Some(instance),
            trigger: None,
            type_: None,
            parameters: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            instance: Some(instance),
            trigger: None,
            type_: None,
            parameters: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            instance: Some(instance),
            trigger: None,
            type_: None,
            parameters: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(instance: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            instance: Some(instance),
            trigger: None,
            type_: None,
            parameters: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 4,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for EventActionConfiguration {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let instance = reader.group(required >= 1, Reader::read)?;
        let trigger = reader.group(required >= 2, Reader::read)?;
        let type_ = reader.group(required >= 3, Reader::read)?;
        let parameters = reader.some_union(required >= 4, type_)?;
        Ok(Self { function, instance, trigger, type_, parameters })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.instance)?;
        writer.some(required >= 2, &self.trigger)?;
        writer.some(required >= 3, &self.type_)?;
        writer.some_union(required >= 4, self.type_, &self.parameters)?;
        Ok(())
    }
}

/// The alternatives of `parameters` in [`EventActionConfiguration`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum EventActionConfigurationParameters {
    /// The slot is free.
    #[default]
    None,
    /// Controls a GPIO pin.
    Gpio(types::EventActionGpio),
    /// Sends a data packet.
    Message(types::EventActionMessage),
    /// Nothing, for a tag that the specification does not know.
    Other(types::EventActionType),
}

impl EventActionConfigurationParameters {
    /// The tag that goes with it.
    #[must_use]
    pub const fn tag(&self) -> types::EventActionType {
        match self {
            Self::None => types::EventActionType::NONE,
            Self::Gpio(_) => types::EventActionType::GPIO,
            Self::Message(_) => types::EventActionType::MESSAGE,
            Self::Other(tag) => *tag,
        }
    }
}

impl Union for EventActionConfigurationParameters {
    type Tag = types::EventActionType;

    fn decode_as(tag: Self::Tag, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(match tag {
            types::EventActionType::NONE => Self::None,
            types::EventActionType::GPIO => Self::Gpio(reader.read()?),
            types::EventActionType::MESSAGE => Self::Message(reader.read()?),
            other => Self::Other(other),
        })
    }

    fn encode_as(&self, tag: Self::Tag, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        if self.tag() != tag {
            return Err(EncodeError::Tag);
        }
        match self {
            Self::None => Ok(()),
            Self::Gpio(value) => writer.write(value),
            Self::Message(value) => writer.write(value),
            Self::Other(tag) if tag.name().is_some() => Err(EncodeError::Tag),
            Self::Other(_) => Ok(()),
        }
    }
}

impl Field for EventActionConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x2F;
    const NAME: &'static str = "3dm.event_action_configuration";
}

impl Command for EventActionConfiguration {
    type Response = EventActionConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<EventActionConfiguration> for EventActionConfigurationResponse {}

/// Device Start Up Settings (0x0C,0x30).
///
/// Saves, loads or resets all settings of the device at once.
///
/// - A save may disturb the data output for a short time.
///
/// Functions: save, load, default. The device may take 1.0 s. Supported by 3DM-CV7-GNSS/INS and
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.8 Device Startup Settings (0x0C, 0x30)
/// - Manual 3dm-cv7-gnss-ins: Device Start Up Settings (0x0C,0x30)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeviceStartUpSettings {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
}

impl DeviceStartUpSettings {
    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT }
    }
}

impl Wire for DeviceStartUpSettings {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        Ok(Self { function })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.function)?;
        Ok(())
    }
}

impl Field for DeviceStartUpSettings {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x30;
    const NAME: &'static str = "3dm.device_start_up_settings";
}

impl Command for DeviceStartUpSettings {
    type Response = ();
    const TIMEOUT_MS: Option<u32> = Some(1000);
}

/// Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31).
///
/// Mounting of the sensor in the vehicle as Euler angles.
///
/// - The three transformation commands (0x31, 0x32, 0x33) set the same thing; the value read back
///   may be another form of it.
/// - The mounting is reached from the vehicle frame by turning about the sensor's own z, y and x
///   axes by yaw, pitch and roll.
/// - A vector in the vehicle frame is Rz(yaw) Ry(pitch) Rx(roll) times the vector in the sensor
///   frame.
/// - It applies to the sensor data, the complementary filter and the attitude, acceleration, rate
///   and gravity of the filter.
/// - A change resets the low-pass filters, the complementary filter and the estimation filter.
/// - On some older products the setting means the inverse rotation.
///
/// Functions: write, read, save, load, default. Response:
/// [`SensorToVehicleFrameTransformationEulerResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformationEuler {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Rotation about the x axis.
    ///
    /// Unit: rad.
    pub roll: Option<f32>,
    /// Rotation about the y axis.
    ///
    /// Unit: rad.
    pub pitch: Option<f32>,
    /// Rotation about the z axis.
    ///
    /// Unit: rad.
    pub yaw: Option<f32>,
}

impl SensorToVehicleFrameTransformationEuler {
    /// Apply the new setting.
    #[must_use]
    pub fn write(roll: f32, pitch: f32, yaw: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            roll: Some(roll),
            pitch: Some(pitch),
            yaw: Some(yaw),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, roll: None, pitch: None, yaw: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, roll: None, pitch: None, yaw: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, roll: None, pitch: None, yaw: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, roll: None, pitch: None, yaw: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for SensorToVehicleFrameTransformationEuler {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let roll = reader.group(required >= 1, Reader::read)?;
        let pitch = reader.group(required >= 2, Reader::read)?;
        let yaw = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, roll, pitch, yaw })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.roll)?;
        writer.some(required >= 2, &self.pitch)?;
        writer.some(required >= 3, &self.yaw)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationEuler {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x31;
    const NAME: &'static str = "3dm.sensor_to_vehicle_frame_transformation_euler";
}

impl Command for SensorToVehicleFrameTransformationEuler {
    type Response = SensorToVehicleFrameTransformationEulerResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleFrameTransformationEuler>
    for SensorToVehicleFrameTransformationEulerResponse
{
}

/// Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32).
///
/// Mounting of the sensor in the vehicle as a quaternion.
///
/// - The three transformation commands (0x31, 0x32, 0x33) set the same thing; the value read back
///   may be another form of it.
/// - A change resets the low-pass filters, the complementary filter and the estimation filter.
///
/// Functions: write, read, save, load, default. Response:
/// [`SensorToVehicleFrameTransformationQuaternionResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformationQuaternion {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Unit quaternion that transforms vectors from the sensor frame to the vehicle frame.
    ///
    /// Unit: 1.
    pub q: Option<types::Quatf>,
}

impl SensorToVehicleFrameTransformationQuaternion {
    /// Apply the new setting.
    #[must_use]
    pub fn write(q: impl Into<types::Quatf>) -> Self {
        Self { function: types::FunctionSelector::WRITE, q: Some(q.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, q: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, q: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, q: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, q: None }
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

impl Wire for SensorToVehicleFrameTransformationQuaternion {
    const SIZE: usize = 17;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let q = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, q })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.q)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationQuaternion {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x32;
    const NAME: &'static str = "3dm.sensor_to_vehicle_frame_transformation_quaternion";
}

impl Command for SensorToVehicleFrameTransformationQuaternion {
    type Response = SensorToVehicleFrameTransformationQuaternionResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleFrameTransformationQuaternion>
    for SensorToVehicleFrameTransformationQuaternionResponse
{
}

/// Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33).
///
/// Mounting of the sensor in the vehicle as a direction cosine matrix.
///
/// - The three transformation commands (0x31, 0x32, 0x33) set the same thing; the value read back
///   may be another form of it.
/// - A vector in the vehicle frame is this matrix times the vector in the sensor frame.
/// - A change resets the low-pass filters, the complementary filter and the estimation filter.
///
/// Functions: write, read, save, load, default. Response:
/// [`SensorToVehicleFrameTransformationDirectionCosineMatrixResponse`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix
///   (0x0C,0x33)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformationDirectionCosineMatrix {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// The matrix in row-major order.
    ///
    /// Unit: 1.
    pub dcm: Option<types::Matrix3f>,
}

impl SensorToVehicleFrameTransformationDirectionCosineMatrix {
    /// Apply the new setting.
    #[must_use]
    pub fn write(dcm: impl Into<types::Matrix3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, dcm: Some(dcm.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, dcm: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, dcm: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, dcm: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, dcm: None }
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

impl Wire for SensorToVehicleFrameTransformationDirectionCosineMatrix {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let dcm = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, dcm })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.dcm)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationDirectionCosineMatrix {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x33;
    const NAME: &'static str = "3dm.sensor_to_vehicle_frame_transformation_direction_cosine_matrix";
}

impl Command for SensorToVehicleFrameTransformationDirectionCosineMatrix {
    type Response = SensorToVehicleFrameTransformationDirectionCosineMatrixResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorToVehicleFrameTransformationDirectionCosineMatrix>
    for SensorToVehicleFrameTransformationDirectionCosineMatrixResponse
{
}

/// Accelerometer Bias Configuration (0x0C,0x37).
///
/// Bias that is subtracted from the scaled acceleration.
///
/// Functions: write, read, save, load, default, apply. Response:
/// [`AccelerometerBiasConfigurationResponse`]. For advanced use. Supported by 3DM-CV7-GNSS/INS and
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
/// - Manual 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AccelerometerBiasConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Accelerometer bias.
    ///
    /// Unit: g; frame: sensor.
    pub bias: Option<types::Vector3f>,
}

impl AccelerometerBiasConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(bias: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, bias: Some(bias.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, bias: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, bias: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, bias: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, bias: None }
    }

    /// Apply the new setting and send no acknowledge (5-series devices).
    #[must_use]
    pub fn apply(bias: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::APPLY, bias: Some(bias.into()) }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE | F::APPLY => 1,
            _ => 0,
        }
    }
}

impl Wire for AccelerometerBiasConfiguration {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let bias = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, bias })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.bias)?;
        Ok(())
    }
}

impl Field for AccelerometerBiasConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x37;
    const NAME: &'static str = "3dm.accelerometer_bias_configuration";
}

impl Command for AccelerometerBiasConfiguration {
    type Response = AccelerometerBiasConfigurationResponse;

    fn expects_reply(&self) -> bool {
        !matches!(self.function, types::FunctionSelector::APPLY)
    }

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AccelerometerBiasConfiguration> for AccelerometerBiasConfigurationResponse {}

/// Gyroscope Bias Configuration (0x0C,0x38).
///
/// Bias that is subtracted from the scaled angular rate.
///
/// Functions: write, read, save, load, default, apply. Response:
/// [`GyroscopeBiasConfigurationResponse`]. For advanced use. Supported by 3DM-CV7-GNSS/INS and
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
/// - Manual 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GyroscopeBiasConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Gyroscope bias.
    ///
    /// Unit: rad/s; frame: sensor.
    pub bias: Option<types::Vector3f>,
}

impl GyroscopeBiasConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(bias: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, bias: Some(bias.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, bias: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, bias: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, bias: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, bias: None }
    }

    /// Apply the new setting and send no acknowledge (5-series devices).
    #[must_use]
    pub fn apply(bias: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::APPLY, bias: Some(bias.into()) }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE | F::APPLY => 1,
            _ => 0,
        }
    }
}

impl Wire for GyroscopeBiasConfiguration {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let bias = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, bias })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.bias)?;
        Ok(())
    }
}

impl Field for GyroscopeBiasConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x38;
    const NAME: &'static str = "3dm.gyroscope_bias_configuration";
}

impl Command for GyroscopeBiasConfiguration {
    type Response = GyroscopeBiasConfigurationResponse;

    fn expects_reply(&self) -> bool {
        !matches!(self.function, types::FunctionSelector::APPLY)
    }

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GyroscopeBiasConfiguration> for GyroscopeBiasConfigurationResponse {}

/// Capture Gyroscope Bias (0x0C,0x39).
///
/// Averages the angular rate of the device at rest and takes the result as the gyroscope bias.
///
/// - The device must stand still, with as little vibration as possible, for the whole time.
/// - The reply comes after the averaging time.
/// - The bias is not saved; the gyroscope bias configuration command with save does it.
/// - The 3DM-GX5-15 also initializes its orientation from the samples.
///
/// Response: [`GyroscopeBiasConfigurationResponse`]. The device may take 31.0 s. Supported by
/// 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.11 Capture Gyro Bias (0x0C, 0x39)
/// - Manual 3dm-cv7-gnss-ins: Capture Gyroscope Bias (0x0C,0x39)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CaptureGyroscopeBias {
    /// Time to average over.
    ///
    /// Unit: ms; range: 1000 to 30000.
    pub averaging_time_ms: u16,
}

impl CaptureGyroscopeBias {
    /// The command with its parameters.
    #[must_use]
    pub fn new(averaging_time_ms: u16) -> Self {
        Self { averaging_time_ms }
    }
}

impl Wire for CaptureGyroscopeBias {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let averaging_time_ms = reader.read()?;
        Ok(Self { averaging_time_ms })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.averaging_time_ms)?;
        Ok(())
    }
}

impl Field for CaptureGyroscopeBias {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x39;
    const NAME: &'static str = "3dm.capture_gyroscope_bias";
}

impl Command for CaptureGyroscopeBias {
    type Response = GyroscopeBiasConfigurationResponse;
    const TIMEOUT_MS: Option<u32> = Some(31000);

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<CaptureGyroscopeBias> for GyroscopeBiasConfigurationResponse {}

/// Magnetometer Hard Iron Offset (0x0C,0x3A).
///
/// Offset that corrects the scaled magnetic field for hard iron.
///
/// - The values come from a calibration of the device as it is installed.
///
/// Functions: write, read, save, load, default. Response: [`MagnetometerHardIronOffsetResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagnetometerHardIronOffset {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Hard iron offset.
    ///
    /// Unit: gauss; frame: sensor.
    pub offset: Option<types::Vector3f>,
}

impl MagnetometerHardIronOffset {
    /// Apply the new setting.
    #[must_use]
    pub fn write(offset: impl Into<types::Vector3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, offset: Some(offset.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, offset: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, offset: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, offset: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, offset: None }
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

impl Wire for MagnetometerHardIronOffset {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let offset = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.offset)?;
        Ok(())
    }
}

impl Field for MagnetometerHardIronOffset {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x3A;
    const NAME: &'static str = "3dm.magnetometer_hard_iron_offset";
}

impl Command for MagnetometerHardIronOffset {
    type Response = MagnetometerHardIronOffsetResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagnetometerHardIronOffset> for MagnetometerHardIronOffsetResponse {}

/// Magnetometer Soft Iron Matrix (0x0C,0x3B).
///
/// Matrix that corrects the scaled magnetic field for soft iron.
///
/// - The values come from a calibration of the device as it is installed.
///
/// Functions: write, read, save, load, default. Response: [`MagnetometerSoftIronMatrixResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagnetometerSoftIronMatrix {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Soft iron matrix in row-major order.
    ///
    /// Unit: 1; frame: sensor.
    pub offset: Option<types::Matrix3f>,
}

impl MagnetometerSoftIronMatrix {
    /// Apply the new setting.
    #[must_use]
    pub fn write(offset: impl Into<types::Matrix3f>) -> Self {
        Self { function: types::FunctionSelector::WRITE, offset: Some(offset.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, offset: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, offset: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, offset: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, offset: None }
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

impl Wire for MagnetometerSoftIronMatrix {
    const SIZE: usize = 37;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let offset = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.offset)?;
        Ok(())
    }
}

impl Field for MagnetometerSoftIronMatrix {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x3B;
    const NAME: &'static str = "3dm.magnetometer_soft_iron_matrix";
}

impl Command for MagnetometerSoftIronMatrix {
    type Response = MagnetometerSoftIronMatrixResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<MagnetometerSoftIronMatrix> for MagnetometerSoftIronMatrixResponse {}

/// Coning and Sculling Enable (0x0C,0x3E).
///
/// Switches the compensation of coning and sculling on or off.
///
/// Functions: write, read, save, load, default. Response: [`ConingAndScullingEnableResponse`].
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConingAndScullingEnable {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Whether the compensation is on.
    ///
    /// Default: true.
    pub enable: Option<crate::Bool>,
}

impl ConingAndScullingEnable {
    /// Apply the new setting.
    #[must_use]
    pub fn write(enable: bool) -> Self {
        Self { function: types::FunctionSelector::WRITE, enable: Some(enable.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, enable: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, enable: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, enable: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, enable: None }
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

impl Wire for ConingAndScullingEnable {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let enable = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.enable)?;
        Ok(())
    }
}

impl Field for ConingAndScullingEnable {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x3E;
    const NAME: &'static str = "3dm.coning_and_sculling_enable";
}

impl Command for ConingAndScullingEnable {
    type Response = ConingAndScullingEnableResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ConingAndScullingEnable> for ConingAndScullingEnableResponse {}

/// UART Baud Rate (0x0C,0x40).
///
/// Baud rate of the main port.
///
/// - The 3DM-GX5-15 replies at the old rate and takes commands at the new one 250 ms later.
/// - The 3DM-CV7 applies the rate when the port is empty, after 250 ms at most; until then nothing
///   is certain.
/// - Set the device to idle first, send the command in a packet of its own and wait 250 ms
///   afterwards.
///
/// Functions: write, read, save, load, default. Response: [`UartBaudRateResponse`]. Supported by
/// 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
/// - Manual 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UartBaudRate {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Baud rate.
    ///
    /// Unit: Bd.
    ///
    /// - On 3dm-gx5-15: factory default 115200.
    pub baud: Option<u32>,
}

impl UartBaudRate {
    /// Apply the new setting.
    #[must_use]
    pub fn write(baud: u32) -> Self {
        Self { function: types::FunctionSelector::WRITE, baud: Some(baud) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self { function: types::FunctionSelector::READ, baud: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self { function: types::FunctionSelector::SAVE, baud: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self { function: types::FunctionSelector::LOAD, baud: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self { function: types::FunctionSelector::DEFAULT, baud: None }
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

impl Wire for UartBaudRate {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let baud = reader.group(required >= 1, Reader::read)?;
        Ok(Self { function, baud })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.baud)?;
        Ok(())
    }
}

impl Field for UartBaudRate {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x40;
    const NAME: &'static str = "3dm.uart_baud_rate";
}

impl Command for UartBaudRate {
    type Response = UartBaudRateResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<UartBaudRate> for UartBaudRateResponse {}

/// GPIO Configuration (0x0C,0x41).
///
/// What a GPIO pin is used for.
///
/// - Not every pin has every feature.
/// - Configure the function behind an output before its pin, and the pin of an input before its
///   function.
/// - A configuration that only one pin can have passes to the latest pin; the earlier pin is reset.
/// - With NMEA input at most one pin may be a UART input; set it to unused before another one takes
///   over.
///
/// Functions: write, read, save, load, default. Response: [`GpioConfigurationResponse`]. Supported
/// by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpioConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// GPIO pin, counted from 1; 0 means all pins (save, load, default).
    pub pin: Option<u8>,
    /// Use of the pin.
    ///
    /// Default: unused.
    pub feature: Option<types::GpioFeature>,
    /// Role of the pin within the feature; 0 where the feature names none.
    pub behavior: Option<u8>,
    /// Electrical options.
    pub pin_mode: Option<types::GpioPinMode>,
}

impl GpioConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        pin: u8,
        feature: types::GpioFeature,
        behavior: u8,
        pin_mode: types::GpioPinMode,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            pin: Some(pin),
            feature: Some(feature),
            behavior: Some(behavior),
            pin_mode: Some(pin_mode),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(pin: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            pin: Some(pin),
            feature: None,
            behavior: None,
            pin_mode: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(pin: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            pin: Some(pin),
            feature: None,
            behavior: None,
            pin_mode: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(pin: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            pin: Some(pin),
            feature: None,
            behavior: None,
            pin_mode: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(pin: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            pin: Some(pin),
            feature: None,
            behavior: None,
            pin_mode: None,
        }
    }

    /// The meaning of `behavior` when `feature` is unused.
    #[must_use]
    pub fn behavior_as_gpio_unused_behavior(&self) -> Option<types::GpioUnusedBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::UNUSED));
        self.behavior.filter(|_| named).map(types::GpioUnusedBehavior)
    }

    /// The meaning of `behavior` when `feature` is gpio.
    #[must_use]
    pub fn behavior_as_gpio_behavior(&self) -> Option<types::GpioBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::GPIO));
        self.behavior.filter(|_| named).map(types::GpioBehavior)
    }

    /// The meaning of `behavior` when `feature` is pps.
    #[must_use]
    pub fn behavior_as_gpio_pps_behavior(&self) -> Option<types::GpioPpsBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::PPS));
        self.behavior.filter(|_| named).map(types::GpioPpsBehavior)
    }

    /// The meaning of `behavior` when `feature` is encoder.
    #[must_use]
    pub fn behavior_as_gpio_encoder_behavior(&self) -> Option<types::GpioEncoderBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::ENCODER));
        self.behavior.filter(|_| named).map(types::GpioEncoderBehavior)
    }

    /// The meaning of `behavior` when `feature` is timestamp.
    #[must_use]
    pub fn behavior_as_gpio_timestamp_behavior(&self) -> Option<types::GpioTimestampBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::TIMESTAMP));
        self.behavior.filter(|_| named).map(types::GpioTimestampBehavior)
    }

    /// The meaning of `behavior` when `feature` is uart.
    #[must_use]
    pub fn behavior_as_gpio_uart_behavior(&self) -> Option<types::GpioUartBehavior> {
        let named = matches!(self.feature, Some(types::GpioFeature::UART));
        self.behavior.filter(|_| named).map(types::GpioUartBehavior)
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 4,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for GpioConfiguration {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let pin = reader.group(required >= 1, Reader::read)?;
        let feature = reader.group(required >= 2, Reader::read)?;
        let behavior = reader.group(required >= 3, Reader::read)?;
        let pin_mode = reader.group(required >= 4, Reader::read)?;
        Ok(Self { function, pin, feature, behavior, pin_mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.pin)?;
        writer.some(required >= 2, &self.feature)?;
        writer.some(required >= 3, &self.behavior)?;
        writer.some(required >= 4, &self.pin_mode)?;
        Ok(())
    }
}

impl Field for GpioConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x41;
    const NAME: &'static str = "3dm.gpio_configuration";
}

impl Command for GpioConfiguration {
    type Response = GpioConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GpioConfiguration> for GpioConfigurationResponse {}

/// GPIO State (0x0C,0x42).
///
/// Sets or reads the state of a GPIO pin.
///
/// - What is read is the level of the pin itself.
/// - Writing shows only on a pin that is configured as an output.
/// - An event action of mode active_high or active_low on the pin overrides what is written.
/// - Reading is sure to work only with the gpio feature.
/// - The state at power-up is a matter of the GPIO configuration command.
///
/// Functions: write, read. Response: [`GpioStateResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpioState {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// GPIO pin, counted from 1.
    ///
    /// Range: at least 1.
    pub pin: Option<u8>,
    /// True is high.
    pub state: Option<crate::Bool>,
}

impl GpioState {
    /// Apply the new setting.
    #[must_use]
    pub fn write(pin: u8, state: bool) -> Self {
        Self { function: types::FunctionSelector::WRITE, pin: Some(pin), state: Some(state.into()) }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(pin: u8) -> Self {
        Self { function: types::FunctionSelector::READ, pin: Some(pin), state: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ => 1,
            _ => 0,
        }
    }
}

impl Wire for GpioState {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let pin = reader.group(required >= 1, Reader::read)?;
        let state = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, pin, state })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.pin)?;
        writer.some(required >= 2, &self.state)?;
        Ok(())
    }
}

impl Field for GpioState {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x42;
    const NAME: &'static str = "3dm.gpio_state";
}

impl Command for GpioState {
    type Response = GpioStateResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<GpioState> for GpioStateResponse {}

/// Odometer Configuration (0x0C,0x43).
///
/// Input from a wheel encoder.
///
/// Functions: write, read, save, load, default. Response: [`OdometerConfigurationResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OdometerConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// How the input works.
    pub mode: Option<OdometerMode>,
    /// Pulses over the distance travelled; negative if the encoder turns backwards.
    ///
    /// Unit: pulse/m.
    ///
    /// - Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
    pub scaling: Option<f32>,
    /// Relative uncertainty of the scaling, 1 sigma.
    ///
    /// Unit: 1.
    pub uncertainty: Option<f32>,
}

impl OdometerConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(mode: OdometerMode, scaling: f32, uncertainty: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            mode: Some(mode),
            scaling: Some(scaling),
            uncertainty: Some(uncertainty),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            mode: None,
            scaling: None,
            uncertainty: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            mode: None,
            scaling: None,
            uncertainty: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            mode: None,
            scaling: None,
            uncertainty: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            mode: None,
            scaling: None,
            uncertainty: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 3,
            _ => 0,
        }
    }
}

impl Wire for OdometerConfiguration {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let mode = reader.group(required >= 1, Reader::read)?;
        let scaling = reader.group(required >= 2, Reader::read)?;
        let uncertainty = reader.group(required >= 3, Reader::read)?;
        Ok(Self { function, mode, scaling, uncertainty })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.mode)?;
        writer.some(required >= 2, &self.scaling)?;
        writer.some(required >= 3, &self.uncertainty)?;
        Ok(())
    }
}

impl Field for OdometerConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x43;
    const NAME: &'static str = "3dm.odometer_configuration";
}

impl Command for OdometerConfiguration {
    type Response = OdometerConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<OdometerConfiguration> for OdometerConfigurationResponse {}

/// Advanced Low-Pass Filter Settings (0x0C,0x50).
///
/// Low-pass filter of one quantity of the sensor data.
///
/// - The filter has one pole. By default it is on and its cutoff is half the rate of the message
///   format.
///
/// Functions: write, read, save, load, default. Response:
/// [`AdvancedLowPassFilterSettingsResponse`]. For advanced use. Supported by 3DM-CV7-GNSS/INS and
/// 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
/// - Manual 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[deprecated(note = "use 3dm.low_pass_anti_aliasing_filter where the device has it")]
pub struct AdvancedLowPassFilterSettings {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
    /// magnetic field 0x06 or pressure 0x17.
    ///
    /// - On 3dm-cv7-gnss-ins: Field descriptor in the sensor data set: scaled acceleration 0x04,
    ///   angular rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for
    ///   read.
    pub target_descriptor: Option<u8>,
    /// Whether the quantity is filtered.
    ///
    /// Default: true.
    pub enable: Option<crate::Bool>,
    /// True uses the frequency; false follows half the rate of the message format.
    ///
    /// Default: false.
    pub manual: Option<crate::Bool>,
    /// Cutoff (-3 dB). It has no meaning if manual is false.
    ///
    /// Unit: Hz.
    ///
    /// - On 3dm-gx5-15: at most 250.
    pub frequency: Option<u16>,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: Option<u8>,
}

impl AdvancedLowPassFilterSettings {
    /// Apply the new setting.
    #[must_use]
    pub fn write(target_descriptor: u8, enable: bool, manual: bool, frequency: u16) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            target_descriptor: Some(target_descriptor),
            enable: Some(enable.into()),
            manual: Some(manual.into()),
            frequency: Some(frequency),
            reserved: Some(0),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(target_descriptor: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            target_descriptor: Some(target_descriptor),
            enable: None,
            manual: None,
            frequency: None,
            reserved: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(target_descriptor: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            target_descriptor: Some(target_descriptor),
            enable: None,
            manual: None,
            frequency: None,
            reserved: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(target_descriptor: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            target_descriptor: Some(target_descriptor),
            enable: None,
            manual: None,
            frequency: None,
            reserved: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(target_descriptor: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            target_descriptor: Some(target_descriptor),
            enable: None,
            manual: None,
            frequency: None,
            reserved: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 5,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for AdvancedLowPassFilterSettings {
    const SIZE: usize = 7;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let target_descriptor = reader.group(required >= 1, Reader::read)?;
        let enable = reader.group(required >= 2, Reader::read)?;
        let manual = reader.group(required >= 3, Reader::read)?;
        let frequency = reader.group(required >= 4, Reader::read)?;
        let reserved = reader.group(required >= 5, Reader::read)?;
        Ok(Self { function, target_descriptor, enable, manual, frequency, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.target_descriptor)?;
        writer.some(required >= 2, &self.enable)?;
        writer.some(required >= 3, &self.manual)?;
        writer.some(required >= 4, &self.frequency)?;
        writer.some(required >= 5, &self.reserved)?;
        Ok(())
    }
}

impl Field for AdvancedLowPassFilterSettings {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x50;
    const NAME: &'static str = "3dm.advanced_low_pass_filter_settings";
}

impl Command for AdvancedLowPassFilterSettings {
    type Response = AdvancedLowPassFilterSettingsResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<AdvancedLowPassFilterSettings> for AdvancedLowPassFilterSettingsResponse {}

/// Complementary Filter Configuration (0x0C,0x51).
///
/// Corrections of the complementary filter, which makes attitudes apart from the estimation filter.
///
/// - Pitch and roll follow the accelerometers, which takes the mean acceleration to be zero.
/// - The heading follows the magnetometer, if the device has one.
/// - The device refuses time constants out of range.
/// - The estimation filter gives better attitudes; the 3DM-GX5-15 keeps this filter for
///   compatibility.
///
/// Functions: write, read, save, load, default. Response:
/// [`ComplementaryFilterConfigurationResponse`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
/// - Manual 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterConfiguration {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Corrects pitch and roll (up, in terms of the 5-series).
    ///
    /// - On 3dm-gx5-15: factory default true.
    pub pitch_roll_enable: Option<crate::Bool>,
    /// Corrects the heading (north, in terms of the 5-series).
    ///
    /// - On 3dm-gx5-15: factory default true.
    pub heading_enable: Option<crate::Bool>,
    /// Time constant of the correction of pitch and roll.
    ///
    /// Unit: s; range: 1 to 1000; default: 10.
    pub pitch_roll_time_constant: Option<f32>,
    /// Time constant of the correction of the heading.
    ///
    /// Unit: s; range: 1 to 1000; default: 10.
    pub heading_time_constant: Option<f32>,
}

impl ComplementaryFilterConfiguration {
    /// Apply the new setting.
    #[must_use]
    pub fn write(
        pitch_roll_enable: bool,
        heading_enable: bool,
        pitch_roll_time_constant: f32,
        heading_time_constant: f32,
    ) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            pitch_roll_enable: Some(pitch_roll_enable.into()),
            heading_enable: Some(heading_enable.into()),
            pitch_roll_time_constant: Some(pitch_roll_time_constant),
            heading_time_constant: Some(heading_time_constant),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read() -> Self {
        Self {
            function: types::FunctionSelector::READ,
            pitch_roll_enable: None,
            heading_enable: None,
            pitch_roll_time_constant: None,
            heading_time_constant: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save() -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            pitch_roll_enable: None,
            heading_enable: None,
            pitch_roll_time_constant: None,
            heading_time_constant: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load() -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            pitch_roll_enable: None,
            heading_enable: None,
            pitch_roll_time_constant: None,
            heading_time_constant: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default() -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            pitch_roll_enable: None,
            heading_enable: None,
            pitch_roll_time_constant: None,
            heading_time_constant: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 4,
            _ => 0,
        }
    }
}

impl Wire for ComplementaryFilterConfiguration {
    const SIZE: usize = 11;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let pitch_roll_enable = reader.group(required >= 1, Reader::read)?;
        let heading_enable = reader.group(required >= 2, Reader::read)?;
        let pitch_roll_time_constant = reader.group(required >= 3, Reader::read)?;
        let heading_time_constant = reader.group(required >= 4, Reader::read)?;
        Ok(Self {
            function,
            pitch_roll_enable,
            heading_enable,
            pitch_roll_time_constant,
            heading_time_constant,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.pitch_roll_enable)?;
        writer.some(required >= 2, &self.heading_enable)?;
        writer.some(required >= 3, &self.pitch_roll_time_constant)?;
        writer.some(required >= 4, &self.heading_time_constant)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterConfiguration {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x51;
    const NAME: &'static str = "3dm.complementary_filter_configuration";
}

impl Command for ComplementaryFilterConfiguration {
    type Response = ComplementaryFilterConfigurationResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<ComplementaryFilterConfiguration> for ComplementaryFilterConfigurationResponse {}

/// Sensor Range (0x0C,0x52).
///
/// Measuring range of a sensor.
///
/// - The get calibrated sensor ranges command lists the settings. The device may refuse others or
///   measure wrongly.
///
/// Functions: write, read, save, load, default. Response: [`SensorRangeResponse`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorRange {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// The sensor.
    pub sensor: Option<SensorRangeType>,
    /// Number of the range.
    pub setting: Option<u8>,
}

impl SensorRange {
    /// Apply the new setting.
    #[must_use]
    pub fn write(sensor: SensorRangeType, setting: u8) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            sensor: Some(sensor),
            setting: Some(setting),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(sensor: SensorRangeType) -> Self {
        Self { function: types::FunctionSelector::READ, sensor: Some(sensor), setting: None }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(sensor: SensorRangeType) -> Self {
        Self { function: types::FunctionSelector::SAVE, sensor: Some(sensor), setting: None }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(sensor: SensorRangeType) -> Self {
        Self { function: types::FunctionSelector::LOAD, sensor: Some(sensor), setting: None }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(sensor: SensorRangeType) -> Self {
        Self { function: types::FunctionSelector::DEFAULT, sensor: Some(sensor), setting: None }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 2,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 1,
            _ => 0,
        }
    }
}

impl Wire for SensorRange {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let sensor = reader.group(required >= 1, Reader::read)?;
        let setting = reader.group(required >= 2, Reader::read)?;
        Ok(Self { function, sensor, setting })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.sensor)?;
        writer.some(required >= 2, &self.setting)?;
        Ok(())
    }
}

impl Field for SensorRange {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x52;
    const NAME: &'static str = "3dm.sensor_range";
}

impl Command for SensorRange {
    type Response = SensorRangeResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<SensorRange> for SensorRangeResponse {}

/// Get Calibrated Sensor Ranges (0x0C,0x53).
///
/// Asks for the ranges that a sensor supports.
///
/// Response: [`GetCalibratedSensorRangesResponse`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetCalibratedSensorRanges {
    /// The sensor; not all.
    pub sensor: SensorRangeType,
}

impl GetCalibratedSensorRanges {
    /// The command with its parameters.
    #[must_use]
    pub fn new(sensor: SensorRangeType) -> Self {
        Self { sensor }
    }
}

impl Wire for GetCalibratedSensorRanges {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let sensor = reader.read()?;
        Ok(Self { sensor })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.sensor)?;
        Ok(())
    }
}

impl Field for GetCalibratedSensorRanges {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x53;
    const NAME: &'static str = "3dm.get_calibrated_sensor_ranges";
}

impl Command for GetCalibratedSensorRanges {
    type Response = GetCalibratedSensorRangesResponse;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<GetCalibratedSensorRanges> for GetCalibratedSensorRangesResponse {}

/// Low-Pass Anti-Aliasing Filter (0x0C,0x54).
///
/// Low-pass filter of a data field.
///
/// - Except for read, a field descriptor of 0 means all fields of the set, and both 0 mean all
///   sets.
///
/// Functions: write, read, save, load, default. Response: [`LowPassAntiAliasingFilterResponse`].
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LowPassAntiAliasingFilter {
    /// What to do with the setting.
    pub function: types::FunctionSelector,
    /// Descriptor set of the field.
    pub desc_set: Option<u8>,
    /// Field descriptor; 0 if the set is 0.
    pub field_desc: Option<u8>,
    /// Whether the field is filtered.
    pub enable: Option<crate::Bool>,
    /// True uses the frequency; false follows half the rate of the field in the message format.
    pub manual: Option<crate::Bool>,
    /// Cutoff; a write ignores it if manual is false, a read gives the cutoff in use.
    ///
    /// Unit: Hz.
    pub frequency: Option<f32>,
}

impl LowPassAntiAliasingFilter {
    /// Apply the new setting.
    #[must_use]
    pub fn write(desc_set: u8, field_desc: u8, enable: bool, manual: bool, frequency: f32) -> Self {
        Self {
            function: types::FunctionSelector::WRITE,
            desc_set: Some(desc_set),
            field_desc: Some(field_desc),
            enable: Some(enable.into()),
            manual: Some(manual.into()),
            frequency: Some(frequency),
        }
    }

    /// Send the current setting back in a response.
    #[must_use]
    pub fn read(desc_set: u8, field_desc: u8) -> Self {
        Self {
            function: types::FunctionSelector::READ,
            desc_set: Some(desc_set),
            field_desc: Some(field_desc),
            enable: None,
            manual: None,
            frequency: None,
        }
    }

    /// Save the current setting to non-volatile memory.
    #[must_use]
    pub fn save(desc_set: u8, field_desc: u8) -> Self {
        Self {
            function: types::FunctionSelector::SAVE,
            desc_set: Some(desc_set),
            field_desc: Some(field_desc),
            enable: None,
            manual: None,
            frequency: None,
        }
    }

    /// Load the saved setting.
    #[must_use]
    pub fn load(desc_set: u8, field_desc: u8) -> Self {
        Self {
            function: types::FunctionSelector::LOAD,
            desc_set: Some(desc_set),
            field_desc: Some(field_desc),
            enable: None,
            manual: None,
            frequency: None,
        }
    }

    /// Load the factory default setting.
    #[must_use]
    pub fn load_default(desc_set: u8, field_desc: u8) -> Self {
        Self {
            function: types::FunctionSelector::DEFAULT,
            desc_set: Some(desc_set),
            field_desc: Some(field_desc),
            enable: None,
            manual: None,
            frequency: None,
        }
    }

    /// How many parameters a function needs.
    fn required(function: types::FunctionSelector) -> u8 {
        use types::FunctionSelector as F;
        match function {
            F::WRITE => 5,
            F::READ | F::SAVE | F::LOAD | F::DEFAULT => 2,
            _ => 0,
        }
    }
}

impl Wire for LowPassAntiAliasingFilter {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let function = reader.read()?;
        let required = Self::required(function);
        let desc_set = reader.group(required >= 1, Reader::read)?;
        let field_desc = reader.group(required >= 2, Reader::read)?;
        let enable = reader.group(required >= 3, Reader::read)?;
        let manual = reader.group(required >= 4, Reader::read)?;
        let frequency = reader.group(required >= 5, Reader::read)?;
        Ok(Self { function, desc_set, field_desc, enable, manual, frequency })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        let required = Self::required(self.function);
        writer.write(&self.function)?;
        writer.some(required >= 1, &self.desc_set)?;
        writer.some(required >= 2, &self.field_desc)?;
        writer.some(required >= 3, &self.enable)?;
        writer.some(required >= 4, &self.manual)?;
        writer.some(required >= 5, &self.frequency)?;
        Ok(())
    }
}

impl Field for LowPassAntiAliasingFilter {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x54;
    const NAME: &'static str = "3dm.low_pass_anti_aliasing_filter";
}

impl Command for LowPassAntiAliasingFilter {
    type Response = LowPassAntiAliasingFilterResponse;

    fn expects_response(&self) -> bool {
        matches!(self.function, types::FunctionSelector::READ)
    }
}

impl ResponseOf<LowPassAntiAliasingFilter> for LowPassAntiAliasingFilterResponse {}

/// Device Status (0x0C,0x64).
///
/// Asks for the state of the device, in one of two layouts.
///
/// - The layouts hold for this model number only; other models answer with layouts of their own.
///
/// Response: one of [`DeviceStatusResponses`]. For advanced use. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeviceStatus {
    /// Layout of the answer.
    pub status_selector: DeviceStatusSelector,
}

impl DeviceStatus {
    /// The command with its parameters.
    #[must_use]
    pub fn new(status_selector: DeviceStatusSelector) -> Self {
        Self { status_selector }
    }
}

impl Wire for DeviceStatus {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.constant::<u16>(6254)?;
        let status_selector = reader.read()?;
        Ok(Self { status_selector })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write::<u16>(&6254)?;
        writer.write(&self.status_selector)?;
        Ok(())
    }
}

impl Field for DeviceStatus {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x64;
    const NAME: &'static str = "3dm.device_status";
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[24, 110])];
}

impl Command for DeviceStatus {
    type Response = DeviceStatusResponses;

    fn expects_response(&self) -> bool {
        true
    }
}

impl ResponseOf<DeviceStatus> for DeviceStatusBasicResponse {}

impl ResponseOf<DeviceStatus> for DeviceStatusDiagnosticResponse {}

crate::macros::responses! {
    /// What [`DeviceStatus`] is answered with.
    DeviceStatusResponses {
        /// The response [`DeviceStatusBasicResponse`].
        Basic(DeviceStatusBasicResponse),
        /// The response [`DeviceStatusDiagnosticResponse`].
        Diagnostic(DeviceStatusDiagnosticResponse),
    }
}

/// IMU Message Format response (0x0C,0x80).
///
/// Answers IMU Message Format (0x0C,0x08).
///
/// Command: [`ImuMessageFormat`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.5 IMU Message Format (0x0C, 0x08)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ImuMessageFormatResponse {
    /// Fields and decimations.
    pub descriptors: crate::List<types::DescriptorRate, 84>,
}

impl Wire for ImuMessageFormatResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for ImuMessageFormatResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x80;
    const NAME: &'static str = "3dm.imu_message_format_response";
}

/// GNSS Message Format response (0x0C,0x81).
///
/// Answers GNSS Message Format (0x0C,0x09).
///
/// Command: [`GnssMessageFormat`].
///
/// - Manual mip-sdk-4: Gnss Message Format (0x0C,0x09)
/// - Manual 3dm-gx5-35: 4.2.6 GNSS Message Format (0x0C, 0x09)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssMessageFormatResponse {
    /// Fields and decimations.
    pub descriptors: crate::List<types::DescriptorRate, 84>,
}

impl Wire for GnssMessageFormatResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GnssMessageFormatResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x81;
    const NAME: &'static str = "3dm.gnss_message_format_response";
}

/// Estimation Filter Message Format response (0x0C,0x82).
///
/// Answers Estimation Filter Message Format (0x0C,0x0A).
///
/// Command: [`EstimationFilterMessageFormat`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.6 Estimation Filter Message Format (0x0C, 0x0A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EstimationFilterMessageFormatResponse {
    /// Fields and decimations.
    pub descriptors: crate::List<types::DescriptorRate, 84>,
}

impl Wire for EstimationFilterMessageFormatResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for EstimationFilterMessageFormatResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x82;
    const NAME: &'static str = "3dm.estimation_filter_message_format_response";
}

/// Get IMU Data Base Rate response (0x0C,0x83).
///
/// Answers Get IMU Data Base Rate (0x0C,0x06).
///
/// Command: [`GetImuDataBaseRate`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.3 Get IMU Data Base Rate (0x0C, 0x06)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetImuDataBaseRateResponse {
    /// Base rate of the sensor data.
    ///
    /// Unit: Hz.
    pub rate: u16,
}

impl Wire for GetImuDataBaseRateResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let rate = reader.read()?;
        Ok(Self { rate })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.rate)?;
        Ok(())
    }
}

impl Field for GetImuDataBaseRateResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x83;
    const NAME: &'static str = "3dm.get_imu_data_base_rate_response";
}

/// Get GNSS Data Base Rate response (0x0C,0x84).
///
/// Answers Get GNSS Data Base Rate (0x0C,0x07).
///
/// Command: [`GetGnssDataBaseRate`].
///
/// - Manual mip-sdk-4: Gnss Get Base Rate (0x0C,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetGnssDataBaseRateResponse {
    /// Base rate of the GNSS data.
    ///
    /// Unit: Hz.
    pub rate: u16,
}

impl Wire for GetGnssDataBaseRateResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let rate = reader.read()?;
        Ok(Self { rate })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.rate)?;
        Ok(())
    }
}

impl Field for GetGnssDataBaseRateResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x84;
    const NAME: &'static str = "3dm.get_gnss_data_base_rate_response";
}

/// Data Stream Control response (0x0C,0x85).
///
/// Answers Data Stream Control (0x0C,0x11).
///
/// Command: [`DataStreamControl`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.7 Enable/Disable Continuous Data Stream (0x0C, 0x11)
/// - Manual 3dm-cv7-gnss-ins: Data Stream Control (0x0C,0x11)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DataStreamControlResponse {
    /// Stream of the command.
    pub desc_set: u8,
    /// Whether the stream is sent.
    pub enabled: crate::Bool,
}

impl DataStreamControlResponse {
    /// The meaning of `desc_set` on the 3DM-GX5-15.
    #[must_use]
    pub fn desc_set_as_legacy_data_stream(&self) -> LegacyDataStream {
        LegacyDataStream(self.desc_set)
    }
}

impl Wire for DataStreamControlResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let desc_set = reader.read()?;
        let enabled = reader.read()?;
        Ok(Self { desc_set, enabled })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.desc_set)?;
        writer.write(&self.enabled)?;
        Ok(())
    }
}

impl Field for DataStreamControlResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x85;
    const NAME: &'static str = "3dm.data_stream_control_response";
}

/// UART Baud Rate response (0x0C,0x87).
///
/// Answers UART Baud Rate (0x0C,0x40).
///
/// Command: [`UartBaudRate`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.13 UART Baud Rate (0x0C, 0x40)
/// - Manual 3dm-cv7-gnss-ins: UART Baudrate (0x0C,0x40)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UartBaudRateResponse {
    /// Baud rate.
    ///
    /// Unit: Bd.
    ///
    /// - On 3dm-gx5-15: factory default 115200.
    pub baud: u32,
}

impl Wire for UartBaudRateResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let baud = reader.read()?;
        Ok(Self { baud })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.baud)?;
        Ok(())
    }
}

impl Field for UartBaudRateResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x87;
    const NAME: &'static str = "3dm.uart_baud_rate_response";
}

/// Get Estimation Filter Data Base Rate response (0x0C,0x8A).
///
/// Answers Get Estimation Filter Data Base Rate (0x0C,0x0B).
///
/// Command: [`GetEstimationFilterDataBaseRate`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.4 Get Estimation Filter Data Base Rate (0x0C, 0x0B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetEstimationFilterDataBaseRateResponse {
    /// Base rate of the filter data.
    ///
    /// Unit: Hz.
    pub rate: u16,
}

impl Wire for GetEstimationFilterDataBaseRateResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let rate = reader.read()?;
        Ok(Self { rate })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.rate)?;
        Ok(())
    }
}

impl Field for GetEstimationFilterDataBaseRateResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x8A;
    const NAME: &'static str = "3dm.get_estimation_filter_data_base_rate_response";
}

/// Advanced Low-Pass Filter Settings response (0x0C,0x8B).
///
/// Answers Advanced Low-Pass Filter Settings (0x0C,0x50).
///
/// Command: [`AdvancedLowPassFilterSettings`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.14 Advanced Low-Pass Filter Settings (0x0C, 0x50)
/// - Manual 3dm-cv7-gnss-ins: Advanced Low-Pass Filter Settings (0x0C,0x50)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AdvancedLowPassFilterSettingsResponse {
    /// Field descriptor in the sensor data set: scaled acceleration 0x04, angular rate 0x05,
    /// magnetic field 0x06 or pressure 0x17.
    ///
    /// - On 3dm-cv7-gnss-ins: Field descriptor in the sensor data set: scaled acceleration 0x04,
    ///   angular rate 0x05, magnetic field 0x06 or pressure 0x17; 0 means all of them, except for
    ///   read.
    pub target_descriptor: u8,
    /// Whether the quantity is filtered.
    ///
    /// Default: true.
    pub enable: crate::Bool,
    /// True uses the frequency; false follows half the rate of the message format.
    ///
    /// Default: false.
    pub manual: crate::Bool,
    /// Cutoff (-3 dB). It has no meaning if manual is false.
    ///
    /// Unit: Hz.
    ///
    /// - On 3dm-gx5-15: at most 250.
    pub frequency: u16,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: u8,
}

impl Wire for AdvancedLowPassFilterSettingsResponse {
    const SIZE: usize = 6;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let target_descriptor = reader.read()?;
        let enable = reader.read()?;
        let manual = reader.read()?;
        let frequency = reader.read()?;
        let reserved = reader.read()?;
        Ok(Self { target_descriptor, enable, manual, frequency, reserved })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.target_descriptor)?;
        writer.write(&self.enable)?;
        writer.write(&self.manual)?;
        writer.write(&self.frequency)?;
        writer.write(&self.reserved)?;
        Ok(())
    }
}

impl Field for AdvancedLowPassFilterSettingsResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x8B;
    const NAME: &'static str = "3dm.advanced_low_pass_filter_settings_response";
}

/// NMEA Message Format response (0x0C,0x8C).
///
/// Answers NMEA Message Format (0x0C,0x0C).
///
/// Command: [`NmeaMessageFormat`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: NMEA Message Format (0x0C,0x0C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NmeaMessageFormatResponse {
    /// Sentences to stream.
    pub format_entries: crate::List<types::NmeaMessage, 50>,
}

impl Wire for NmeaMessageFormatResponse {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let count = reader.read::<u8>()?;
        let format_entries = reader.list(count)?;
        Ok(Self { format_entries })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.format_entries.len())?;
        self.format_entries.encode_items(writer)?;
        Ok(())
    }
}

impl Field for NmeaMessageFormatResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x8C;
    const NAME: &'static str = "3dm.nmea_message_format_response";
}

/// Get Data Base Rate response (0x0C,0x8E).
///
/// Answers Get Data Base Rate (0x0C,0x0E).
///
/// Command: [`GetDataBaseRate`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Data Base Rate (0x0C,0x0E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetDataBaseRateResponse {
    /// Data descriptor set of the command.
    pub desc_set: u8,
    /// Base rate; 0 if the rate is variable or unknown and data is sent as it comes.
    ///
    /// Unit: Hz.
    pub rate: u16,
}

impl Wire for GetDataBaseRateResponse {
    const SIZE: usize = 3;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let desc_set = reader.read()?;
        let rate = reader.read()?;
        Ok(Self { desc_set, rate })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.desc_set)?;
        writer.write(&self.rate)?;
        Ok(())
    }
}

impl Field for GetDataBaseRateResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x8E;
    const NAME: &'static str = "3dm.get_data_base_rate_response";
}

/// Message Format response (0x0C,0x8F).
///
/// Answers Message Format (0x0C,0x0F).
///
/// Command: [`MessageFormat`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Message Format (0x0C,0x0F)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MessageFormatResponse {
    /// Data descriptor set; 0 means all of them (save, load, default).
    pub desc_set: u8,
    /// Fields and decimations.
    pub descriptors: crate::List<types::DescriptorRate, 83>,
}

impl Wire for MessageFormatResponse {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let desc_set = reader.read()?;
        let num_descriptors = reader.read::<u8>()?;
        let descriptors = reader.list(num_descriptors)?;
        Ok(Self { desc_set, descriptors })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.desc_set)?;
        writer.count::<u8>(self.descriptors.len())?;
        self.descriptors.encode_items(writer)?;
        Ok(())
    }
}

impl Field for MessageFormatResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x8F;
    const NAME: &'static str = "3dm.message_format_response";
}

/// Basic Device Status (0x0C,0x90).
///
/// State and timer.
///
/// Command: [`DeviceStatus`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeviceStatusBasicResponse {
    /// Reserved.
    pub status_flags: u32,
    /// State of the system; its values are not documented.
    pub system_state: u16,
    /// Time since start-up.
    ///
    /// Unit: ms.
    pub system_timer: u32,
}

impl Wire for DeviceStatusBasicResponse {
    const SIZE: usize = 13;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.constant::<u16>(6254)?;
        reader.constant::<u8>(1)?;
        let status_flags = reader.read()?;
        let system_state = reader.read()?;
        let system_timer = reader.read()?;
        Ok(Self { status_flags, system_state, system_timer })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write::<u16>(&6254)?;
        writer.write::<u8>(&1)?;
        writer.write(&self.status_flags)?;
        writer.write(&self.system_state)?;
        writer.write(&self.system_timer)?;
        Ok(())
    }
}

impl Field for DeviceStatusBasicResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "3dm.device_status_basic_response";
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[24, 110]), (2, &[1])];
}

/// Diagnostic Device Status (0x0C,0x90).
///
/// State and timer with the counters of streams and port.
///
/// Command: [`DeviceStatus`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.16 Device Status (0x0C, 0x64)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeviceStatusDiagnosticResponse {
    /// Reserved.
    pub status_flags: u32,
    /// State of the system; its values are not documented.
    pub system_state: u16,
    /// Time since start-up.
    ///
    /// Unit: ms.
    pub system_timer: u32,
    /// Whether sensor data is streamed.
    pub imu_stream_enabled: crate::Bool,
    /// Whether filter data is streamed.
    pub filter_stream_enabled: crate::Bool,
    /// Sensor data packets that were not sent.
    ///
    /// Unit: 1.
    pub imu_dropped_packets: u32,
    /// Filter data packets that were not sent.
    ///
    /// Unit: 1.
    pub filter_dropped_packets: u32,
    /// Bytes written to the port.
    ///
    /// Unit: byte.
    pub com_port_bytes_written: u32,
    /// Bytes read from the port.
    ///
    /// Unit: byte.
    pub com_port_bytes_read: u32,
    /// Overruns while writing to the port.
    ///
    /// Unit: 1.
    pub com_port_write_overruns: u32,
    /// Overruns while reading from the port.
    ///
    /// Unit: 1.
    pub com_port_read_overruns: u32,
    /// Messages of the IMU that could not be parsed.
    ///
    /// Unit: 1.
    pub imu_parser_errors: u32,
    /// Messages of the IMU that were read.
    ///
    /// Unit: 1.
    pub imu_message_count: u32,
    /// System timer at the last message of the IMU.
    ///
    /// Unit: ms.
    pub imu_last_message_time: u32,
}

impl Wire for DeviceStatusDiagnosticResponse {
    const SIZE: usize = 51;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.constant::<u16>(6254)?;
        reader.constant::<u8>(2)?;
        let status_flags = reader.read()?;
        let system_state = reader.read()?;
        let system_timer = reader.read()?;
        let imu_stream_enabled = reader.read()?;
        let filter_stream_enabled = reader.read()?;
        let imu_dropped_packets = reader.read()?;
        let filter_dropped_packets = reader.read()?;
        let com_port_bytes_written = reader.read()?;
        let com_port_bytes_read = reader.read()?;
        let com_port_write_overruns = reader.read()?;
        let com_port_read_overruns = reader.read()?;
        let imu_parser_errors = reader.read()?;
        let imu_message_count = reader.read()?;
        let imu_last_message_time = reader.read()?;
        Ok(Self {
            status_flags,
            system_state,
            system_timer,
            imu_stream_enabled,
            filter_stream_enabled,
            imu_dropped_packets,
            filter_dropped_packets,
            com_port_bytes_written,
            com_port_bytes_read,
            com_port_write_overruns,
            com_port_read_overruns,
            imu_parser_errors,
            imu_message_count,
            imu_last_message_time,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write::<u16>(&6254)?;
        writer.write::<u8>(&2)?;
        writer.write(&self.status_flags)?;
        writer.write(&self.system_state)?;
        writer.write(&self.system_timer)?;
        writer.write(&self.imu_stream_enabled)?;
        writer.write(&self.filter_stream_enabled)?;
        writer.write(&self.imu_dropped_packets)?;
        writer.write(&self.filter_dropped_packets)?;
        writer.write(&self.com_port_bytes_written)?;
        writer.write(&self.com_port_bytes_read)?;
        writer.write(&self.com_port_write_overruns)?;
        writer.write(&self.com_port_read_overruns)?;
        writer.write(&self.imu_parser_errors)?;
        writer.write(&self.imu_message_count)?;
        writer.write(&self.imu_last_message_time)?;
        Ok(())
    }
}

impl Field for DeviceStatusDiagnosticResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x90;
    const NAME: &'static str = "3dm.device_status_diagnostic_response";
    const CONSTANTS: &'static [(usize, &'static [u8])] = &[(0, &[24, 110]), (2, &[2])];
}

/// Complementary Filter Configuration response (0x0C,0x97).
///
/// Answers Complementary Filter Configuration (0x0C,0x51).
///
/// Command: [`ComplementaryFilterConfiguration`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.15 Complementary Filter Settings (0x0C, 0x51)
/// - Manual 3dm-cv7-gnss-ins: Complementary Filter Configuration (0x0C,0x51)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterConfigurationResponse {
    /// Corrects pitch and roll (up, in terms of the 5-series).
    ///
    /// - On 3dm-gx5-15: factory default true.
    pub pitch_roll_enable: crate::Bool,
    /// Corrects the heading (north, in terms of the 5-series).
    ///
    /// - On 3dm-gx5-15: factory default true.
    pub heading_enable: crate::Bool,
    /// Time constant of the correction of pitch and roll.
    ///
    /// Unit: s; range: 1 to 1000; default: 10.
    pub pitch_roll_time_constant: f32,
    /// Time constant of the correction of the heading.
    ///
    /// Unit: s; range: 1 to 1000; default: 10.
    pub heading_time_constant: f32,
}

impl Wire for ComplementaryFilterConfigurationResponse {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let pitch_roll_enable = reader.read()?;
        let heading_enable = reader.read()?;
        let pitch_roll_time_constant = reader.read()?;
        let heading_time_constant = reader.read()?;
        Ok(Self {
            pitch_roll_enable,
            heading_enable,
            pitch_roll_time_constant,
            heading_time_constant,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.pitch_roll_enable)?;
        writer.write(&self.heading_enable)?;
        writer.write(&self.pitch_roll_time_constant)?;
        writer.write(&self.heading_time_constant)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x97;
    const NAME: &'static str = "3dm.complementary_filter_configuration_response";
}

/// Accelerometer Bias Configuration response (0x0C,0x9A).
///
/// Answers Accelerometer Bias Configuration (0x0C,0x37).
///
/// Command: [`AccelerometerBiasConfiguration`]. Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.9 Accel Bias (0x0C, 0x37)
/// - Manual 3dm-cv7-gnss-ins: Accelerometer Bias Configuration (0x0C,0x37)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AccelerometerBiasConfigurationResponse {
    /// Accelerometer bias.
    ///
    /// Unit: g; frame: sensor.
    pub bias: types::Vector3f,
}

impl Wire for AccelerometerBiasConfigurationResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let bias = reader.read()?;
        Ok(Self { bias })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.bias)?;
        Ok(())
    }
}

impl Field for AccelerometerBiasConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x9A;
    const NAME: &'static str = "3dm.accelerometer_bias_configuration_response";
}

/// Gyroscope Bias Configuration response (0x0C,0x9B).
///
/// The bias in use. The capture gyroscope bias command answers with it too.
///
/// Command: [`GyroscopeBiasConfiguration`]. Command: [`CaptureGyroscopeBias`]. Supported by
/// 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.10 Gyro Bias (0x0C, 0x38)
/// - Manual 3dm-cv7-gnss-ins: Gyroscope Bias Configuration (0x0C,0x38)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GyroscopeBiasConfigurationResponse {
    /// Gyroscope bias.
    ///
    /// Unit: rad/s; frame: sensor.
    pub bias: types::Vector3f,
}

impl Wire for GyroscopeBiasConfigurationResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let bias = reader.read()?;
        Ok(Self { bias })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.bias)?;
        Ok(())
    }
}

impl Field for GyroscopeBiasConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x9B;
    const NAME: &'static str = "3dm.gyroscope_bias_configuration_response";
}

/// Magnetometer Hard Iron Offset response (0x0C,0x9C).
///
/// Answers Magnetometer Hard Iron Offset (0x0C,0x3A).
///
/// Command: [`MagnetometerHardIronOffset`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetometer Hard Iron Offset (0x0C,0x3A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagnetometerHardIronOffsetResponse {
    /// Hard iron offset.
    ///
    /// Unit: gauss; frame: sensor.
    pub offset: types::Vector3f,
}

impl Wire for MagnetometerHardIronOffsetResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let offset = reader.read()?;
        Ok(Self { offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.offset)?;
        Ok(())
    }
}

impl Field for MagnetometerHardIronOffsetResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x9C;
    const NAME: &'static str = "3dm.magnetometer_hard_iron_offset_response";
}

/// Magnetometer Soft Iron Matrix response (0x0C,0x9D).
///
/// Answers Magnetometer Soft Iron Matrix (0x0C,0x3B).
///
/// Command: [`MagnetometerSoftIronMatrix`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Magnetometer Soft Iron Matrix (0x0C,0x3B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MagnetometerSoftIronMatrixResponse {
    /// Soft iron matrix in row-major order.
    ///
    /// Unit: 1; frame: sensor.
    pub offset: types::Matrix3f,
}

impl Wire for MagnetometerSoftIronMatrixResponse {
    const SIZE: usize = 36;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let offset = reader.read()?;
        Ok(Self { offset })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.offset)?;
        Ok(())
    }
}

impl Field for MagnetometerSoftIronMatrixResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x9D;
    const NAME: &'static str = "3dm.magnetometer_soft_iron_matrix_response";
}

/// Coning and Sculling Enable response (0x0C,0x9E).
///
/// Answers Coning and Sculling Enable (0x0C,0x3E).
///
/// Command: [`ConingAndScullingEnable`]. Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 4.2.12 Coning and Sculling Enable (0x0C, 0x3E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConingAndScullingEnableResponse {
    /// Whether the compensation is on.
    ///
    /// Default: true.
    pub enable: crate::Bool,
}

impl Wire for ConingAndScullingEnableResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable = reader.read()?;
        Ok(Self { enable })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable)?;
        Ok(())
    }
}

impl Field for ConingAndScullingEnableResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x9E;
    const NAME: &'static str = "3dm.coning_and_sculling_enable_response";
}

/// Constellation Settings response (0x0C,0xA0).
///
/// Tracking channels of the receiver and the setting of each constellation.
///
/// Command: [`ConstellationSettings`].
///
/// - Manual mip-sdk-4: Constellation Settings (0x0C,0x21)
/// - Manual 3dm-gx5-35: 4.2.8 GNSS Constellation Settings (0x0C, 0x21)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ConstellationSettingsResponse {
    /// Channels that the receiver has.
    ///
    /// Unit: 1.
    pub max_channels_available: u16,
    /// Channels in use at most.
    ///
    /// Unit: 1.
    pub max_channels_use: u16,
    /// One entry for each constellation.
    pub settings: crate::List<ConstellationSettingsEntry, 41>,
}

impl Wire for ConstellationSettingsResponse {
    const SIZE: usize = 251;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let max_channels_available = reader.read()?;
        let max_channels_use = reader.read()?;
        let config_count = reader.read::<u8>()?;
        let settings = reader.list(config_count)?;
        Ok(Self { max_channels_available, max_channels_use, settings })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.max_channels_available)?;
        writer.write(&self.max_channels_use)?;
        writer.count::<u8>(self.settings.len())?;
        self.settings.encode_items(writer)?;
        Ok(())
    }
}

impl Field for ConstellationSettingsResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xA0;
    const NAME: &'static str = "3dm.constellation_settings_response";
}

/// GNSS SBAS Settings response (0x0C,0xA1).
///
/// Answers GNSS SBAS Settings (0x0C,0x22).
///
/// Command: [`GnssSbasSettings`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GNSS SBAS Settings (0x0C,0x22)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssSbasSettingsResponse {
    /// 1 switches SBAS on, 0 off.
    ///
    /// Range: 0 to 1.
    pub enable_sbas: u8,
    /// What SBAS is used for.
    pub sbas_options: SbasOptions,
    /// PRN numbers of the SBAS satellites to search for.
    pub included_prns: crate::List<u16, 124>,
}

impl Wire for GnssSbasSettingsResponse {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let enable_sbas = reader.read()?;
        let sbas_options = reader.read()?;
        let num_included_prns = reader.read::<u8>()?;
        let included_prns = reader.list(num_included_prns)?;
        Ok(Self { enable_sbas, sbas_options, included_prns })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.enable_sbas)?;
        writer.write(&self.sbas_options)?;
        writer.count::<u8>(self.included_prns.len())?;
        self.included_prns.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GnssSbasSettingsResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xA1;
    const NAME: &'static str = "3dm.gnss_sbas_settings_response";
}

/// GNSS Assisted Fix response (0x0C,0xA2).
///
/// Answers GNSS Assisted Fix (0x0C,0x23).
///
/// Command: [`GnssAssistedFix`].
///
/// - Manual mip-sdk-4: Gnss Assisted Fix (0x0C,0x23)
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssAssistedFixResponse {
    /// Assisted fix.
    ///
    /// Default: none.
    pub option: AssistedFixOption,
    /// Reserved.
    ///
    /// Send 255.
    pub flags: u8,
}

impl core::default::Default for GnssAssistedFixResponse {
    fn default() -> Self {
        Self { option: core::default::Default::default(), flags: 255 }
    }
}

impl Wire for GnssAssistedFixResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let option = reader.read()?;
        let flags = reader.read()?;
        Ok(Self { option, flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.option)?;
        writer.write(&self.flags)?;
        Ok(())
    }
}

impl Field for GnssAssistedFixResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xA2;
    const NAME: &'static str = "3dm.gnss_assisted_fix_response";
}

/// GNSS Time Assistance response (0x0C,0xA3).
///
/// Answers GNSS Time Assistance (0x0C,0x24).
///
/// Command: [`GnssTimeAssistance`].
///
/// - Manual mip-sdk-4: Gnss Time Assistance (0x0C,0x24)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GnssTimeAssistanceResponse {
    /// GPS time of week.
    ///
    /// Unit: s.
    pub tow: f64,
    /// GPS week number since 1980.
    ///
    /// Unit: week.
    pub week_number: u16,
    /// Accuracy of the time.
    ///
    /// Unit: s.
    pub accuracy: f32,
}

impl Wire for GnssTimeAssistanceResponse {
    const SIZE: usize = 14;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let tow = reader.read()?;
        let week_number = reader.read()?;
        let accuracy = reader.read()?;
        Ok(Self { tow, week_number, accuracy })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.tow)?;
        writer.write(&self.week_number)?;
        writer.write(&self.accuracy)?;
        Ok(())
    }
}

impl Field for GnssTimeAssistanceResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xA3;
    const NAME: &'static str = "3dm.gnss_time_assistance_response";
}

/// PPS Source Control response (0x0C,0xA8).
///
/// Answers PPS Source Control (0x0C,0x28).
///
/// Command: [`PpsSourceControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: PPS Source Control (0x0C,0x28)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PpsSourceControlResponse {
    /// Source of the pulse.
    ///
    /// Default: receiver_1.
    pub source: PpsSource,
}

impl Wire for PpsSourceControlResponse {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let source = reader.read()?;
        Ok(Self { source })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.source)?;
        Ok(())
    }
}

impl Field for PpsSourceControlResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xA8;
    const NAME: &'static str = "3dm.pps_source_control_response";
}

/// Sensor-to-Vehicle Frame Transformation Euler response (0x0C,0xB1).
///
/// Answers Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31).
///
/// Command: [`SensorToVehicleFrameTransformationEuler`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Euler (0x0C,0x31)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformationEulerResponse {
    /// Rotation about the x axis.
    ///
    /// Unit: rad.
    pub roll: f32,
    /// Rotation about the y axis.
    ///
    /// Unit: rad.
    pub pitch: f32,
    /// Rotation about the z axis.
    ///
    /// Unit: rad.
    pub yaw: f32,
}

impl Wire for SensorToVehicleFrameTransformationEulerResponse {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let roll = reader.read()?;
        let pitch = reader.read()?;
        let yaw = reader.read()?;
        Ok(Self { roll, pitch, yaw })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.roll)?;
        writer.write(&self.pitch)?;
        writer.write(&self.yaw)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationEulerResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB1;
    const NAME: &'static str = "3dm.sensor_to_vehicle_frame_transformation_euler_response";
}

/// Sensor-to-Vehicle Frame Transformation Quaternion response (0x0C,0xB2).
///
/// Answers Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32).
///
/// Command: [`SensorToVehicleFrameTransformationQuaternion`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Quaternion (0x0C,0x32)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformationQuaternionResponse {
    /// Unit quaternion that transforms vectors from the sensor frame to the vehicle frame.
    ///
    /// Unit: 1.
    pub q: types::Quatf,
}

impl Wire for SensorToVehicleFrameTransformationQuaternionResponse {
    const SIZE: usize = 16;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let q = reader.read()?;
        Ok(Self { q })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.q)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationQuaternionResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB2;
    const NAME: &'static str = "3dm.sensor_to_vehicle_frame_transformation_quaternion_response";
}

/// Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix response (0x0C,0xB3).
///
/// Answers Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix (0x0C,0x33).
///
/// Command: [`SensorToVehicleFrameTransformationDirectionCosineMatrix`]. Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor-to-Vehicle Frame Transformation Direction Cosine Matrix
///   (0x0C,0x33)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorToVehicleFrameTransformationDirectionCosineMatrixResponse {
    /// The matrix in row-major order.
    ///
    /// Unit: 1.
    pub dcm: types::Matrix3f,
}

impl Wire for SensorToVehicleFrameTransformationDirectionCosineMatrixResponse {
    const SIZE: usize = 36;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let dcm = reader.read()?;
        Ok(Self { dcm })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.dcm)?;
        Ok(())
    }
}

impl Field for SensorToVehicleFrameTransformationDirectionCosineMatrixResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB3;
    const NAME: &'static str =
        "3dm.sensor_to_vehicle_frame_transformation_direction_cosine_matrix_response";
}

/// Get Supported Events response (0x0C,0xB4).
///
/// Answers Get Supported Events (0x0C,0x2A).
///
/// Command: [`GetSupportedEvents`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Supported Events (0x0C,0x2A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetSupportedEventsResponse {
    /// Query of the command.
    pub query: SupportedEventsQuery,
    /// Number of slots; instances go from 1 to this.
    ///
    /// Unit: 1.
    pub max_instances: u8,
    /// The types.
    pub entries: crate::List<SupportedEventInfo, 125>,
}

impl Wire for GetSupportedEventsResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let query = reader.read()?;
        let max_instances = reader.read()?;
        let num_entries = reader.read::<u8>()?;
        let entries = reader.list(num_entries)?;
        Ok(Self { query, max_instances, entries })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.query)?;
        writer.write(&self.max_instances)?;
        writer.count::<u8>(self.entries.len())?;
        self.entries.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GetSupportedEventsResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB4;
    const NAME: &'static str = "3dm.get_supported_events_response";
}

/// Event Control response (0x0C,0xB5).
///
/// Answers Event Control (0x0C,0x2B).
///
/// Command: [`EventControl`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Control (0x0C,0x2B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventControlResponse {
    /// Trigger instance; 0 means all configured triggers, except for read.
    pub instance: u8,
    /// New mode.
    ///
    /// Default: disabled.
    pub mode: types::EventTriggerMode,
}

impl Wire for EventControlResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let instance = reader.read()?;
        let mode = reader.read()?;
        Ok(Self { instance, mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.instance)?;
        writer.write(&self.mode)?;
        Ok(())
    }
}

impl Field for EventControlResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB5;
    const NAME: &'static str = "3dm.event_control_response";
}

/// Get Event Trigger Status response (0x0C,0xB6).
///
/// Answers Get Event Trigger Status (0x0C,0x2C).
///
/// Command: [`GetEventTriggerStatus`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Event Trigger Status (0x0C,0x2C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetEventTriggerStatusResponse {
    /// One entry per trigger, in the order asked for, or by instance if all were asked for.
    pub triggers: crate::List<EventTriggerStatusEntry, 126>,
}

impl Wire for GetEventTriggerStatusResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let count = reader.read::<u8>()?;
        let triggers = reader.list(count)?;
        Ok(Self { triggers })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.triggers.len())?;
        self.triggers.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GetEventTriggerStatusResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB6;
    const NAME: &'static str = "3dm.get_event_trigger_status_response";
}

/// Get Event Action Status response (0x0C,0xB7).
///
/// Answers Get Event Action Status (0x0C,0x2D).
///
/// Command: [`GetEventActionStatus`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Event Action Status (0x0C,0x2D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetEventActionStatusResponse {
    /// One entry per action, in the order asked for, or by instance if all were asked for.
    pub actions: crate::List<EventActionStatusEntry, 126>,
}

impl Wire for GetEventActionStatusResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let count = reader.read::<u8>()?;
        let actions = reader.list(count)?;
        Ok(Self { actions })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.count::<u8>(self.actions.len())?;
        self.actions.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GetEventActionStatusResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB7;
    const NAME: &'static str = "3dm.get_event_action_status_response";
}

/// Event Trigger Configuration response (0x0C,0xB8).
///
/// Answers Event Trigger Configuration (0x0C,0x2E).
///
/// Command: [`EventTriggerConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Trigger Configuration (0x0C,0x2E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventTriggerConfigurationResponse {
    /// Trigger instance; 0 means all (save, load, default).
    pub instance: u8,
    /// Kind of trigger.
    ///
    /// Default: none.
    pub type_: types::EventTriggerType,
    /// The condition.
    ///
    /// Selected by `type`.
    pub parameters: EventTriggerConfigurationParameters,
}

impl Wire for EventTriggerConfigurationResponse {
    const SIZE: usize = 22;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let instance = reader.read()?;
        let type_ = reader.read()?;
        let parameters = reader.union(type_)?;
        Ok(Self { instance, type_, parameters })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.instance)?;
        writer.write(&self.type_)?;
        writer.union(self.type_, &self.parameters)?;
        Ok(())
    }
}

impl Field for EventTriggerConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB8;
    const NAME: &'static str = "3dm.event_trigger_configuration_response";
}

/// Event Action Configuration response (0x0C,0xB9).
///
/// Answers Event Action Configuration (0x0C,0x2F).
///
/// Command: [`EventActionConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Action Configuration (0x0C,0x2F)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventActionConfigurationResponse {
    /// Action instance; 0 means all (save, load, default).
    pub instance: u8,
    /// Trigger instance that the action follows.
    pub trigger: u8,
    /// Kind of action.
    ///
    /// Default: none.
    pub type_: types::EventActionType,
    /// The effect.
    ///
    /// Selected by `type`.
    pub parameters: EventActionConfigurationParameters,
}

impl Wire for EventActionConfigurationResponse {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let instance = reader.read()?;
        let trigger = reader.read()?;
        let type_ = reader.read()?;
        let parameters = reader.union(type_)?;
        Ok(Self { instance, trigger, type_, parameters })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.instance)?;
        writer.write(&self.trigger)?;
        writer.write(&self.type_)?;
        writer.union(self.type_, &self.parameters)?;
        Ok(())
    }
}

impl Field for EventActionConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xB9;
    const NAME: &'static str = "3dm.event_action_configuration_response";
}

/// GPIO Configuration response (0x0C,0xC1).
///
/// Answers GPIO Configuration (0x0C,0x41).
///
/// Command: [`GpioConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GPIO Configuration (0x0C,0x41)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpioConfigurationResponse {
    /// GPIO pin, counted from 1; 0 means all pins (save, load, default).
    pub pin: u8,
    /// Use of the pin.
    ///
    /// Default: unused.
    pub feature: types::GpioFeature,
    /// Role of the pin within the feature; 0 where the feature names none.
    pub behavior: u8,
    /// Electrical options.
    pub pin_mode: types::GpioPinMode,
}

impl GpioConfigurationResponse {
    /// The meaning of `behavior` when `feature` is unused.
    #[must_use]
    pub fn behavior_as_gpio_unused_behavior(&self) -> Option<types::GpioUnusedBehavior> {
        let named = matches!(self.feature, types::GpioFeature::UNUSED);
        Some(self.behavior).filter(|_| named).map(types::GpioUnusedBehavior)
    }

    /// The meaning of `behavior` when `feature` is gpio.
    #[must_use]
    pub fn behavior_as_gpio_behavior(&self) -> Option<types::GpioBehavior> {
        let named = matches!(self.feature, types::GpioFeature::GPIO);
        Some(self.behavior).filter(|_| named).map(types::GpioBehavior)
    }

    /// The meaning of `behavior` when `feature` is pps.
    #[must_use]
    pub fn behavior_as_gpio_pps_behavior(&self) -> Option<types::GpioPpsBehavior> {
        let named = matches!(self.feature, types::GpioFeature::PPS);
        Some(self.behavior).filter(|_| named).map(types::GpioPpsBehavior)
    }

    /// The meaning of `behavior` when `feature` is encoder.
    #[must_use]
    pub fn behavior_as_gpio_encoder_behavior(&self) -> Option<types::GpioEncoderBehavior> {
        let named = matches!(self.feature, types::GpioFeature::ENCODER);
        Some(self.behavior).filter(|_| named).map(types::GpioEncoderBehavior)
    }

    /// The meaning of `behavior` when `feature` is timestamp.
    #[must_use]
    pub fn behavior_as_gpio_timestamp_behavior(&self) -> Option<types::GpioTimestampBehavior> {
        let named = matches!(self.feature, types::GpioFeature::TIMESTAMP);
        Some(self.behavior).filter(|_| named).map(types::GpioTimestampBehavior)
    }

    /// The meaning of `behavior` when `feature` is uart.
    #[must_use]
    pub fn behavior_as_gpio_uart_behavior(&self) -> Option<types::GpioUartBehavior> {
        let named = matches!(self.feature, types::GpioFeature::UART);
        Some(self.behavior).filter(|_| named).map(types::GpioUartBehavior)
    }
}

impl Wire for GpioConfigurationResponse {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let pin = reader.read()?;
        let feature = reader.read()?;
        let behavior = reader.read()?;
        let pin_mode = reader.read()?;
        Ok(Self { pin, feature, behavior, pin_mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.pin)?;
        writer.write(&self.feature)?;
        writer.write(&self.behavior)?;
        writer.write(&self.pin_mode)?;
        Ok(())
    }
}

impl Field for GpioConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xC1;
    const NAME: &'static str = "3dm.gpio_configuration_response";
}

/// GPIO State response (0x0C,0xC2).
///
/// Answers GPIO State (0x0C,0x42).
///
/// Command: [`GpioState`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GPIO State (0x0C,0x42)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpioStateResponse {
    /// GPIO pin, counted from 1.
    ///
    /// Range: at least 1.
    pub pin: u8,
    /// True is high.
    pub state: crate::Bool,
}

impl Wire for GpioStateResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let pin = reader.read()?;
        let state = reader.read()?;
        Ok(Self { pin, state })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.pin)?;
        writer.write(&self.state)?;
        Ok(())
    }
}

impl Field for GpioStateResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xC2;
    const NAME: &'static str = "3dm.gpio_state_response";
}

/// Odometer Configuration response (0x0C,0xC3).
///
/// Answers Odometer Configuration (0x0C,0x43).
///
/// Command: [`OdometerConfiguration`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Odometer Configuration (0x0C,0x43)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OdometerConfigurationResponse {
    /// How the input works.
    pub mode: OdometerMode,
    /// Pulses over the distance travelled; negative if the encoder turns backwards.
    ///
    /// Unit: pulse/m.
    ///
    /// - Pulses on line A per turn of the wheel, divided by the circumference of the wheel.
    pub scaling: f32,
    /// Relative uncertainty of the scaling, 1 sigma.
    ///
    /// Unit: 1.
    pub uncertainty: f32,
}

impl Wire for OdometerConfigurationResponse {
    const SIZE: usize = 9;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mode = reader.read()?;
        let scaling = reader.read()?;
        let uncertainty = reader.read()?;
        Ok(Self { mode, scaling, uncertainty })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.mode)?;
        writer.write(&self.scaling)?;
        writer.write(&self.uncertainty)?;
        Ok(())
    }
}

impl Field for OdometerConfigurationResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xC3;
    const NAME: &'static str = "3dm.odometer_configuration_response";
}

/// Sensor Range response (0x0C,0xD2).
///
/// Answers Sensor Range (0x0C,0x52).
///
/// Command: [`SensorRange`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Sensor Range (0x0C,0x52)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SensorRangeResponse {
    /// The sensor.
    pub sensor: SensorRangeType,
    /// Number of the range.
    pub setting: u8,
}

impl Wire for SensorRangeResponse {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let sensor = reader.read()?;
        let setting = reader.read()?;
        Ok(Self { sensor, setting })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.sensor)?;
        writer.write(&self.setting)?;
        Ok(())
    }
}

impl Field for SensorRangeResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xD2;
    const NAME: &'static str = "3dm.sensor_range_response";
}

/// Get Calibrated Sensor Ranges response (0x0C,0xD3).
///
/// Answers Get Calibrated Sensor Ranges (0x0C,0x53).
///
/// Command: [`GetCalibratedSensorRanges`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Get Calibrated Sensor Ranges (0x0C,0x53)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GetCalibratedSensorRangesResponse {
    /// Sensor of the command.
    pub sensor: SensorRangeType,
    /// The ranges.
    pub ranges: crate::List<SensorRangeEntry, 50>,
}

impl Wire for GetCalibratedSensorRangesResponse {
    const SIZE: usize = 252;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let sensor = reader.read()?;
        let num_ranges = reader.read::<u8>()?;
        let ranges = reader.list(num_ranges)?;
        Ok(Self { sensor, ranges })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.sensor)?;
        writer.count::<u8>(self.ranges.len())?;
        self.ranges.encode_items(writer)?;
        Ok(())
    }
}

impl Field for GetCalibratedSensorRangesResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xD3;
    const NAME: &'static str = "3dm.get_calibrated_sensor_ranges_response";
}

/// Low-Pass Anti-Aliasing Filter response (0x0C,0xD4).
///
/// Answers Low-Pass Anti-Aliasing Filter (0x0C,0x54).
///
/// Command: [`LowPassAntiAliasingFilter`]. Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Low-Pass Anti-Aliasing Filter (0x0C,0x54)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LowPassAntiAliasingFilterResponse {
    /// Descriptor set of the field.
    pub desc_set: u8,
    /// Field descriptor; 0 if the set is 0.
    pub field_desc: u8,
    /// Whether the field is filtered.
    pub enable: crate::Bool,
    /// True uses the frequency; false follows half the rate of the field in the message format.
    pub manual: crate::Bool,
    /// Cutoff; a write ignores it if manual is false, a read gives the cutoff in use.
    ///
    /// Unit: Hz.
    pub frequency: f32,
}

impl Wire for LowPassAntiAliasingFilterResponse {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let desc_set = reader.read()?;
        let field_desc = reader.read()?;
        let enable = reader.read()?;
        let manual = reader.read()?;
        let frequency = reader.read()?;
        Ok(Self { desc_set, field_desc, enable, manual, frequency })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.desc_set)?;
        writer.write(&self.field_desc)?;
        writer.write(&self.enable)?;
        writer.write(&self.manual)?;
        writer.write(&self.frequency)?;
        Ok(())
    }
}

impl Field for LowPassAntiAliasingFilterResponse {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0xD4;
    const NAME: &'static str = "3dm.low_pass_anti_aliasing_filter_response";
}
