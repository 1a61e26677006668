//! External GNSS data (0x94): What an external GNSS receiver tells the device by NMEA sentences. A
//! field may need several sentences; a value that NMEA does not give is not valid. Times are those
//! of the sentences.
//!
//! Source: 3dm-cv7-gnss-ins: GNSS External (0x94); 3dm-cv7-gnss-ins: NMEA Input.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x94;

/// GNSS LLH position (0x94,0x03).
///
/// GNSS position as latitude, longitude and height.
///
/// Has the layout of [`gnss_1::GnssLlhPosition`](crate::gnss_1::GnssLlhPosition). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03).
pub type GnssLlhPosition = crate::gnss_1::GnssLlhPosition;

/// NED velocity (0x94,0x05).
///
/// GNSS velocity in the local level frame.
///
/// Has the layout of [`gnss_1::NedVelocity`](crate::gnss_1::NedVelocity). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05).
pub type NedVelocity = crate::gnss_1::NedVelocity;

/// UTC time (0x94,0x08).
///
/// Coordinated universal time as the receiver knows it.
///
/// Has the layout of [`gnss_1::UtcTime`](crate::gnss_1::UtcTime). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: UTC Time (0x94,0x08).
pub type UtcTime = crate::gnss_1::UtcTime;

/// Fix info (0x94,0x0B).
///
/// Type of the position fix and what it is made of.
///
/// Has the layout of [`gnss_1::FixInfo`](crate::gnss_1::FixInfo). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B).
pub type FixInfo = crate::gnss_1::FixInfo;

/// Satellite status (0x94,0x20).
///
/// Where one satellite stands, and its health.
///
/// Has the layout of [`gnss_1::SatelliteStatus`](crate::gnss_1::SatelliteStatus). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - An epoch is sent as one field for each satellite; index and count number the fields.
///
/// Source: 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20).
pub type SatelliteStatus = crate::gnss_1::SatelliteStatus;
