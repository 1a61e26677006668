//! External GNSS data (0x94): What an external GNSS receiver tells the device by NMEA sentences. A
//! field may need several sentences; a value that NMEA does not give is not valid. Times are those
//! of the sentences.
//!
//! - Manual 3dm-cv7-gnss-ins: GNSS External (0x94)
//! - Manual 3dm-cv7-gnss-ins: NMEA Input

/// The number of the descriptor set.
pub const SET: u8 = 0x94;

/// (0x94,0x03) GNSS LLH position: the same as
/// [`gnss_1.gnss_llh_position`](crate::gnss_1::GnssLlhPosition).
///
/// - Manual 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
pub type GnssLlhPosition = crate::gnss_1::GnssLlhPosition;

/// (0x94,0x04) GNSS ECEF position: the same as
/// [`gnss_1.gnss_ecef_position`](crate::gnss_1::GnssEcefPosition).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GnssEcefPosition = crate::gnss_1::GnssEcefPosition;

/// (0x94,0x05) NED velocity: the same as [`gnss_1.ned_velocity`](crate::gnss_1::NedVelocity).
///
/// - Manual 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
pub type NedVelocity = crate::gnss_1::NedVelocity;

/// (0x94,0x06) GNSS ECEF velocity: the same as
/// [`gnss_1.gnss_ecef_velocity`](crate::gnss_1::GnssEcefVelocity).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GnssEcefVelocity = crate::gnss_1::GnssEcefVelocity;

/// (0x94,0x07) DOP: the same as [`gnss_1.dop`](crate::gnss_1::Dop).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type Dop = crate::gnss_1::Dop;

/// (0x94,0x08) UTC time: the same as [`gnss_1.utc_time`](crate::gnss_1::UtcTime).
///
/// - Manual 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
pub type UtcTime = crate::gnss_1::UtcTime;

/// (0x94,0x09) GPS time: the same as [`gnss_1.gps_time`](crate::gnss_1::GpsTime).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GpsTime = crate::gnss_1::GpsTime;

/// (0x94,0x0A) Clock info: the same as [`gnss_1.clock_info`](crate::gnss_1::ClockInfo).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type ClockInfo = crate::gnss_1::ClockInfo;

/// (0x94,0x0B) Fix info: the same as [`gnss_1.fix_info`](crate::gnss_1::FixInfo).
///
/// - Manual 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
pub type FixInfo = crate::gnss_1::FixInfo;

/// (0x94,0x0C) Satellite info: the same as [`gnss_1.sv_info`](crate::gnss_1::SvInfo).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type SvInfo = crate::gnss_1::SvInfo;

/// (0x94,0x0D) GNSS hardware status: the same as
/// [`gnss_1.gnss_hardware_status`](crate::gnss_1::GnssHardwareStatus).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GnssHardwareStatus = crate::gnss_1::GnssHardwareStatus;

/// (0x94,0x0E) DGPS info: the same as [`gnss_1.dgps_info`](crate::gnss_1::DgpsInfo).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type DgpsInfo = crate::gnss_1::DgpsInfo;

/// (0x94,0x0F) DGPS channel: the same as [`gnss_1.dgps_channel`](crate::gnss_1::DgpsChannel).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type DgpsChannel = crate::gnss_1::DgpsChannel;

/// (0x94,0x10) Clock info 2: the same as [`gnss_1.clock_info_2`](crate::gnss_1::ClockInfo2).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type ClockInfo2 = crate::gnss_1::ClockInfo2;

/// (0x94,0x11) GPS leap seconds: the same as
/// [`gnss_1.gps_leap_seconds`](crate::gnss_1::GpsLeapSeconds).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GpsLeapSeconds = crate::gnss_1::GpsLeapSeconds;

/// (0x94,0x12) SBAS info: the same as [`gnss_1.sbas_info`](crate::gnss_1::SbasInfo).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type SbasInfo = crate::gnss_1::SbasInfo;

/// (0x94,0x13) SBAS correction: the same as
/// [`gnss_1.sbas_correction`](crate::gnss_1::SbasCorrection).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type SbasCorrection = crate::gnss_1::SbasCorrection;

/// (0x94,0x14) RF error detection: the same as
/// [`gnss_1.rf_error_detection`](crate::gnss_1::RfErrorDetection).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type RfErrorDetection = crate::gnss_1::RfErrorDetection;

/// (0x94,0x20) Satellite status: the same as
/// [`gnss_1.satellite_status`](crate::gnss_1::SatelliteStatus).
///
/// - Manual 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
pub type SatelliteStatus = crate::gnss_1::SatelliteStatus;

/// (0x94,0x22) Raw: the same as [`gnss_1.raw`](crate::gnss_1::Raw).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type Raw = crate::gnss_1::Raw;

/// (0x94,0x30) Base station info: the same as
/// [`gnss_1.base_station_info`](crate::gnss_1::BaseStationInfo).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type BaseStationInfo = crate::gnss_1::BaseStationInfo;

/// (0x94,0x31) RTK corrections status: the same as
/// [`gnss_1.rtk_corrections_status`](crate::gnss_1::RtkCorrectionsStatus).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type RtkCorrectionsStatus = crate::gnss_1::RtkCorrectionsStatus;

/// (0x94,0x61) GPS ephemeris: the same as [`gnss_1.gps_ephemeris`](crate::gnss_1::GpsEphemeris).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GpsEphemeris = crate::gnss_1::GpsEphemeris;

/// (0x94,0x62) GLONASS ephemeris: the same as
/// [`gnss_1.glonass_ephemeris`](crate::gnss_1::GlonassEphemeris).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GlonassEphemeris = crate::gnss_1::GlonassEphemeris;

/// (0x94,0x63) Galileo ephemeris: the same as
/// [`gnss_1.galileo_ephemeris`](crate::gnss_1::GalileoEphemeris).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GalileoEphemeris = crate::gnss_1::GalileoEphemeris;

/// (0x94,0x64) BeiDou ephemeris: the same as
/// [`gnss_1.beidou_ephemeris`](crate::gnss_1::BeidouEphemeris).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type BeidouEphemeris = crate::gnss_1::BeidouEphemeris;

/// (0x94,0x71) GPS ionospheric correction: the same as
/// [`gnss_1.gps_iono_correction`](crate::gnss_1::GpsIonoCorrection).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GpsIonoCorrection = crate::gnss_1::GpsIonoCorrection;

/// (0x94,0x73) Galileo ionospheric correction: the same as
/// [`gnss_1.galileo_iono_correction`](crate::gnss_1::GalileoIonoCorrection).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type GalileoIonoCorrection = crate::gnss_1::GalileoIonoCorrection;

/// (0x94,0x74) BeiDou ionospheric correction: the same as
/// [`gnss_1.beidou_iono_correction`](crate::gnss_1::BeidouIonoCorrection).
///
/// - Manual mip-sdk-4: Gnss4 Data (0x94)
pub type BeidouIonoCorrection = crate::gnss_1::BeidouIonoCorrection;
