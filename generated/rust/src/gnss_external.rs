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

/// (0x94,0x05) NED velocity: the same as [`gnss_1.ned_velocity`](crate::gnss_1::NedVelocity).
///
/// - Manual 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
pub type NedVelocity = crate::gnss_1::NedVelocity;

/// (0x94,0x08) UTC time: the same as [`gnss_1.utc_time`](crate::gnss_1::UtcTime).
///
/// - Manual 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
pub type UtcTime = crate::gnss_1::UtcTime;

/// (0x94,0x0B) Fix info: the same as [`gnss_1.fix_info`](crate::gnss_1::FixInfo).
///
/// - Manual 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
pub type FixInfo = crate::gnss_1::FixInfo;

/// (0x94,0x20) Satellite status: the same as
/// [`gnss_1.satellite_status`](crate::gnss_1::SatelliteStatus).
///
/// - Manual 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
pub type SatelliteStatus = crate::gnss_1::SatelliteStatus;
