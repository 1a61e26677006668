//! GNSS corrections data (0x93): What the device receives of RTK corrections. Data are sent as they
//! are received.
//!
//! Source: 3dm-cv7-gnss-ins: GNSS Corrections (0x93).

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x93;

bitfield! {
    /// Properties of a base station, as its RTCM message gives them.
    BaseStationIndicators: u16 {
        /// GPS is supported. Bit 0.
        GPS: bool = 0,
            gps, set_gps, with_gps;
        /// GLONASS is supported. Bit 1.
        GLONASS: bool = 1,
            glonass, set_glonass, with_glonass;
        /// Galileo is supported. Bit 2.
        GALILEO: bool = 2,
            galileo, set_galileo, with_galileo;
        /// BeiDou is supported. Bit 3.
        BEIDOU: bool = 3,
            beidou, set_beidou, with_beidou;
        /// Reference station indicator. Bit 4.
        REF_STATION: bool = 4,
            ref_station, set_ref_station, with_ref_station;
        /// Single receiver oscillator indicator. Bit 5.
        SINGLE_RECEIVER: bool = 5,
            single_receiver, set_single_receiver, with_single_receiver;
        /// First bit of the quarter cycle indicator. Bit 6.
        QUARTER_CYCLE_BIT1: bool = 6,
            quarter_cycle_bit1, set_quarter_cycle_bit1, with_quarter_cycle_bit1;
        /// Second bit of the quarter cycle indicator. Bit 7.
        QUARTER_CYCLE_BIT2: bool = 7,
            quarter_cycle_bit2, set_quarter_cycle_bit2, with_quarter_cycle_bit2;
        /// Quarter cycle indicator. Bits 6 to 7. Overlaps other bits.
        QUARTER_CYCLE_BITS: u8 = 6..=7,
            quarter_cycle_bits, set_quarter_cycle_bits, with_quarter_cycle_bits;
    }
}

bitfield! {
    /// Which values are valid.
    BaseStationInfoFlags: u16 {
        /// Time of week. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// Week number. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// Position. Bit 2.
        ECEF_POSITION: bool = 2,
            ecef_position, set_ecef_position, with_ecef_position;
        /// Antenna height. Bit 3.
        HEIGHT: bool = 3,
            height, set_height, with_height;
        /// Station. Bit 4.
        STATION_ID: bool = 4,
            station_id, set_station_id, with_station_id;
        /// Indicators. Bit 5.
        INDICATORS: bool = 5,
            indicators, set_indicators, with_indicators;
        /// All of them. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Corrections that came during an epoch.
    RtkEpochStatus: u16 {
        /// Antenna location. Bit 0.
        ANTENNA_LOCATION_RECEIVED: bool = 0,
            antenna_location_received, set_antenna_location_received, with_antenna_location_received;
        /// Antenna description. Bit 1.
        ANTENNA_DESCRIPTION_RECEIVED: bool = 1,
            antenna_description_received, set_antenna_description_received, with_antenna_description_received;
        /// GPS corrections. Bit 2.
        GPS_RECEIVED: bool = 2,
            gps_received, set_gps_received, with_gps_received;
        /// GLONASS corrections. Bit 3.
        GLONASS_RECEIVED: bool = 3,
            glonass_received, set_glonass_received, with_glonass_received;
        /// Galileo corrections. Bit 4.
        GALILEO_RECEIVED: bool = 4,
            galileo_received, set_galileo_received, with_galileo_received;
        /// BeiDou corrections. Bit 5.
        BEIDOU_RECEIVED: bool = 5,
            beidou_received, set_beidou_received, with_beidou_received;
        /// GPS corrections come in MSM messages, not in the RTCM messages 1001-1004. Bit 6.
        USING_GPS_MSM_MESSAGES: bool = 6,
            using_gps_msm_messages, set_using_gps_msm_messages, with_using_gps_msm_messages;
        /// GLONASS corrections come in MSM messages, not in the RTCM messages 1009-1012. Bit 7.
        USING_GLONASS_MSM_MESSAGES: bool = 7,
            using_glonass_msm_messages, set_using_glonass_msm_messages, with_using_glonass_msm_messages;
        /// The status of the dongle could not be read. Bit 8.
        DONGLE_STATUS_READ_FAILED: bool = 8,
            dongle_status_read_failed, set_dongle_status_read_failed, with_dongle_status_read_failed;
    }
}

bitfield! {
    /// Which values are valid.
    RtkCorrectionsStatusFlags: u16 {
        /// Time of week. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// Week number. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// Epoch status. Bit 2.
        EPOCH_STATUS: bool = 2,
            epoch_status, set_epoch_status, with_epoch_status;
        /// Status of the dongle. Bit 3.
        DONGLE_STATUS: bool = 3,
            dongle_status, set_dongle_status, with_dongle_status;
        /// Latency of GPS corrections. Bit 4.
        GPS_LATENCY: bool = 4,
            gps_latency, set_gps_latency, with_gps_latency;
        /// Latency of GLONASS corrections. Bit 5.
        GLONASS_LATENCY: bool = 5,
            glonass_latency, set_glonass_latency, with_glonass_latency;
        /// Latency of Galileo corrections. Bit 6.
        GALILEO_LATENCY: bool = 6,
            galileo_latency, set_galileo_latency, with_galileo_latency;
        /// Latency of BeiDou corrections. Bit 7.
        BEIDOU_LATENCY: bool = 7,
            beidou_latency, set_beidou_latency, with_beidou_latency;
        /// All of them. Bits 0 to 7. Overlaps other bits.
        FLAGS: u8 = 0..=7,
            flags, set_flags, with_flags;
    }
}

record! {
    /// Base station info (0x93,0x30).
    ///
    /// The base station of the corrections, from an RTCM message 1005 or 1006.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30).
    #[derive(Default)]
    pub struct BaseStationInfo {
        /// GPS time of week at which the message was received.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](BaseStationInfoFlags::tow) is set.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](BaseStationInfoFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// Position of the station.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.ecef_position`](BaseStationInfoFlags::ecef_position) is set.
        pub ecef_pos: types::Vector3d,
        /// Height of the antenna above the marker that was surveyed.
        ///
        /// Unit: m. Valid if [`valid_flags.height`](BaseStationInfoFlags::height) is set.
        pub height: f32,
        /// Number of the station.
        ///
        /// Range: 0 to 4095. Valid if [`valid_flags.station_id`](BaseStationInfoFlags::station_id)
        /// is set.
        pub station_id: u16,
        /// Properties of the station.
        ///
        /// Valid if [`valid_flags.indicators`](BaseStationInfoFlags::indicators) is set.
        pub indicators: BaseStationIndicators,
        /// Which values are valid.
        pub valid_flags: BaseStationInfoFlags,
    }
}

field! {
    BaseStationInfo: 0x93, 0x30, "gnss_corrections.base_station_info";
}

record! {
    /// RTK corrections status (0x93,0x31).
    ///
    /// Which corrections come, and how old they are.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31).
    #[derive(Default)]
    pub struct RtkCorrectionsStatus {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](RtkCorrectionsStatusFlags::tow) is set.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](RtkCorrectionsStatusFlags::week_number)
        /// is set.
        pub week_number: u16,
        /// Corrections that came during this epoch.
        ///
        /// Valid if [`valid_flags.epoch_status`](RtkCorrectionsStatusFlags::epoch_status) is set.
        pub epoch_status: RtkEpochStatus,
        /// Status flags of the RTK dongle; of use only with a dongle.
        ///
        /// Valid if [`valid_flags.dongle_status`](RtkCorrectionsStatusFlags::dongle_status) is set.
        ///
        /// - The manual does not define the flags.
        pub dongle_status: u32,
        /// Latency of the last GPS correction.
        ///
        /// Unit: s. Valid if [`valid_flags.gps_latency`](RtkCorrectionsStatusFlags::gps_latency) is
        /// set.
        pub gps_correction_latency: f32,
        /// Latency of the last GLONASS correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.glonass_latency`](RtkCorrectionsStatusFlags::glonass_latency) is set.
        pub glonass_correction_latency: f32,
        /// Latency of the last Galileo correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.galileo_latency`](RtkCorrectionsStatusFlags::galileo_latency) is set.
        pub galileo_correction_latency: f32,
        /// Latency of the last BeiDou correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.beidou_latency`](RtkCorrectionsStatusFlags::beidou_latency) is set.
        pub beidou_correction_latency: f32,
        /// Reserved.
        pub reserved: [u32; 4],
        /// Which values are valid.
        pub valid_flags: RtkCorrectionsStatusFlags,
    }
}

field! {
    RtkCorrectionsStatus: 0x93, 0x31, "gnss_corrections.rtk_corrections_status";
}
