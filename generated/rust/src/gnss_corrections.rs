//! GNSS corrections data (0x93): What the device receives of RTK corrections. Data are sent as they
//! are received.
//!
//! - Manual 3dm-cv7-gnss-ins: GNSS Corrections (0x93)

use crate::macros::bitfield;
use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x93;

bitfield! {
    /// Properties of a base station, as its RTCM message gives them.
    BaseStationIndicators: u16 {
        /// GPS is supported.
        GPS: bool = 0,
            "gps", gps, set_gps, with_gps;
        /// GLONASS is supported.
        GLONASS: bool = 1,
            "glonass", glonass, set_glonass, with_glonass;
        /// Galileo is supported.
        GALILEO: bool = 2,
            "galileo", galileo, set_galileo, with_galileo;
        /// BeiDou is supported.
        BEIDOU: bool = 3,
            "beidou", beidou, set_beidou, with_beidou;
        /// Reference station indicator.
        REF_STATION: bool = 4,
            "ref_station", ref_station, set_ref_station, with_ref_station;
        /// Single receiver oscillator indicator.
        SINGLE_RECEIVER: bool = 5,
            "single_receiver", single_receiver, set_single_receiver, with_single_receiver;
        /// First bit of the quarter cycle indicator.
        QUARTER_CYCLE_BIT1: bool = 6,
            "quarter_cycle_bit1", quarter_cycle_bit1, set_quarter_cycle_bit1,
            with_quarter_cycle_bit1;
        /// Second bit of the quarter cycle indicator.
        QUARTER_CYCLE_BIT2: bool = 7,
            "quarter_cycle_bit2", quarter_cycle_bit2, set_quarter_cycle_bit2,
            with_quarter_cycle_bit2;
        /// Quarter cycle indicator.
        QUARTER_CYCLE_BITS: u8 = 6..=7,
            "quarter_cycle_bits", quarter_cycle_bits, set_quarter_cycle_bits,
            with_quarter_cycle_bits;
    }
}

bitfield! {
    /// Which values are valid.
    BaseStationInfoFlags: u16 {
        /// Time of week.
        TOW: bool = 0,
            "tow", tow, set_tow, with_tow;
        /// Week number.
        WEEK_NUMBER: bool = 1,
            "week_number", week_number, set_week_number, with_week_number;
        /// Position.
        ECEF_POSITION: bool = 2,
            "ecef_position", ecef_position, set_ecef_position, with_ecef_position;
        /// Antenna height.
        HEIGHT: bool = 3,
            "height", height, set_height, with_height;
        /// Station.
        STATION_ID: bool = 4,
            "station_id", station_id, set_station_id, with_station_id;
        /// Indicators.
        INDICATORS: bool = 5,
            "indicators", indicators, set_indicators, with_indicators;
        /// All of them.
        FLAGS: u8 = 0..=5,
            "flags", flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Corrections that came during an epoch.
    RtkEpochStatus: u16 {
        /// Antenna location.
        ANTENNA_LOCATION_RECEIVED: bool = 0,
            "antenna_location_received", antenna_location_received, set_antenna_location_received,
            with_antenna_location_received;
        /// Antenna description.
        ANTENNA_DESCRIPTION_RECEIVED: bool = 1,
            "antenna_description_received", antenna_description_received,
            set_antenna_description_received, with_antenna_description_received;
        /// GPS corrections.
        GPS_RECEIVED: bool = 2,
            "gps_received", gps_received, set_gps_received, with_gps_received;
        /// GLONASS corrections.
        GLONASS_RECEIVED: bool = 3,
            "glonass_received", glonass_received, set_glonass_received, with_glonass_received;
        /// Galileo corrections.
        GALILEO_RECEIVED: bool = 4,
            "galileo_received", galileo_received, set_galileo_received, with_galileo_received;
        /// BeiDou corrections.
        BEIDOU_RECEIVED: bool = 5,
            "beidou_received", beidou_received, set_beidou_received, with_beidou_received;
        /// GPS corrections come in MSM messages, not in the RTCM messages 1001-1004.
        USING_GPS_MSM_MESSAGES: bool = 6,
            "using_gps_msm_messages", using_gps_msm_messages, set_using_gps_msm_messages,
            with_using_gps_msm_messages;
        /// GLONASS corrections come in MSM messages, not in the RTCM messages 1009-1012.
        USING_GLONASS_MSM_MESSAGES: bool = 7,
            "using_glonass_msm_messages", using_glonass_msm_messages,
            set_using_glonass_msm_messages, with_using_glonass_msm_messages;
        /// The status of the dongle could not be read.
        DONGLE_STATUS_READ_FAILED: bool = 8,
            "dongle_status_read_failed", dongle_status_read_failed, set_dongle_status_read_failed,
            with_dongle_status_read_failed;
    }
}

bitfield! {
    /// Which values are valid.
    RtkCorrectionsStatusFlags: u16 {
        /// Time of week.
        TOW: bool = 0,
            "tow", tow, set_tow, with_tow;
        /// Week number.
        WEEK_NUMBER: bool = 1,
            "week_number", week_number, set_week_number, with_week_number;
        /// Epoch status.
        EPOCH_STATUS: bool = 2,
            "epoch_status", epoch_status, set_epoch_status, with_epoch_status;
        /// Status of the dongle.
        DONGLE_STATUS: bool = 3,
            "dongle_status", dongle_status, set_dongle_status, with_dongle_status;
        /// Latency of GPS corrections.
        GPS_LATENCY: bool = 4,
            "gps_latency", gps_latency, set_gps_latency, with_gps_latency;
        /// Latency of GLONASS corrections.
        GLONASS_LATENCY: bool = 5,
            "glonass_latency", glonass_latency, set_glonass_latency, with_glonass_latency;
        /// Latency of Galileo corrections.
        GALILEO_LATENCY: bool = 6,
            "galileo_latency", galileo_latency, set_galileo_latency, with_galileo_latency;
        /// Latency of BeiDou corrections.
        BEIDOU_LATENCY: bool = 7,
            "beidou_latency", beidou_latency, set_beidou_latency, with_beidou_latency;
        /// All of them.
        FLAGS: u8 = 0..=7,
            "flags", flags, set_flags, with_flags;
    }
}

/// Base station info (0x93,0x30).
///
/// The base station of the corrections, from an RTCM message 1005 or 1006.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BaseStationInfo {
    /// GPS time of week at which the message was received.
    ///
    /// Unit: s; valid if `valid_flags.tow` is set.
    pub time_of_week: f64,
    /// GPS week number.
    ///
    /// Unit: week; valid if `valid_flags.week_number` is set.
    pub week_number: u16,
    /// Position of the station.
    ///
    /// Unit: m; frame: ecef; valid if `valid_flags.ecef_position` is set.
    pub ecef_pos: types::Vector3d,
    /// Height of the antenna above the marker that was surveyed.
    ///
    /// Unit: m; valid if `valid_flags.height` is set.
    pub height: f32,
    /// Number of the station.
    ///
    /// Range: 0 to 4095; valid if `valid_flags.station_id` is set.
    pub station_id: u16,
    /// Properties of the station.
    ///
    /// Valid if `valid_flags.indicators` is set.
    pub indicators: BaseStationIndicators,
    /// Which values are valid.
    pub valid_flags: BaseStationInfoFlags,
}

impl Wire for BaseStationInfo {
    const SIZE: usize = 44;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time_of_week = reader.read()?;
        let week_number = reader.read()?;
        let ecef_pos = reader.read()?;
        let height = reader.read()?;
        let station_id = reader.read()?;
        let indicators = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self {
            time_of_week,
            week_number,
            ecef_pos,
            height,
            station_id,
            indicators,
            valid_flags,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time_of_week)?;
        writer.write(&self.week_number)?;
        writer.write(&self.ecef_pos)?;
        writer.write(&self.height)?;
        writer.write(&self.station_id)?;
        writer.write(&self.indicators)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for BaseStationInfo {
    const SET: u8 = 0x93;
    const DESCRIPTOR: u8 = 0x30;
    const NAME: &'static str = "gnss_corrections.base_station_info";
}

/// RTK corrections status (0x93,0x31).
///
/// Which corrections come, and how old they are.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RtkCorrectionsStatus {
    /// GPS time of week.
    ///
    /// Unit: s; valid if `valid_flags.tow` is set.
    pub time_of_week: f64,
    /// GPS week number.
    ///
    /// Unit: week; valid if `valid_flags.week_number` is set.
    pub week_number: u16,
    /// Corrections that came during this epoch.
    ///
    /// Valid if `valid_flags.epoch_status` is set.
    pub epoch_status: RtkEpochStatus,
    /// Status flags of the RTK dongle; of use only with a dongle.
    ///
    /// Valid if `valid_flags.dongle_status` is set.
    ///
    /// - The manual does not define the flags.
    pub dongle_status: u32,
    /// Latency of the last GPS correction.
    ///
    /// Unit: s; valid if `valid_flags.gps_latency` is set.
    pub gps_correction_latency: f32,
    /// Latency of the last GLONASS correction.
    ///
    /// Unit: s; valid if `valid_flags.glonass_latency` is set.
    pub glonass_correction_latency: f32,
    /// Latency of the last Galileo correction.
    ///
    /// Unit: s; valid if `valid_flags.galileo_latency` is set.
    pub galileo_correction_latency: f32,
    /// Latency of the last BeiDou correction.
    ///
    /// Unit: s; valid if `valid_flags.beidou_latency` is set.
    pub beidou_correction_latency: f32,
    /// Reserved.
    ///
    /// Send 0.
    pub reserved: [u32; 4],
    /// Which values are valid.
    pub valid_flags: RtkCorrectionsStatusFlags,
}

impl Wire for RtkCorrectionsStatus {
    const SIZE: usize = 50;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let time_of_week = reader.read()?;
        let week_number = reader.read()?;
        let epoch_status = reader.read()?;
        let dongle_status = reader.read()?;
        let gps_correction_latency = reader.read()?;
        let glonass_correction_latency = reader.read()?;
        let galileo_correction_latency = reader.read()?;
        let beidou_correction_latency = reader.read()?;
        let reserved = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self {
            time_of_week,
            week_number,
            epoch_status,
            dongle_status,
            gps_correction_latency,
            glonass_correction_latency,
            galileo_correction_latency,
            beidou_correction_latency,
            reserved,
            valid_flags,
        })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.time_of_week)?;
        writer.write(&self.week_number)?;
        writer.write(&self.epoch_status)?;
        writer.write(&self.dongle_status)?;
        writer.write(&self.gps_correction_latency)?;
        writer.write(&self.glonass_correction_latency)?;
        writer.write(&self.galileo_correction_latency)?;
        writer.write(&self.beidou_correction_latency)?;
        writer.write(&self.reserved)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for RtkCorrectionsStatus {
    const SET: u8 = 0x93;
    const DESCRIPTOR: u8 = 0x31;
    const NAME: &'static str = "gnss_corrections.rtk_corrections_status";
}
