//! GNSS receiver 2 data (0x92): Measurements and status of the second internal GNSS receiver.
//!
//! Source: 3dm-cv7-gnss-ins: GNSS Recv 2 (0x92).

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x92;

/// GNSS LLH position (0x92,0x03).
///
/// GNSS position as latitude, longitude and height.
///
/// Has the layout of [`gnss_1::GnssLlhPosition`](crate::gnss_1::GnssLlhPosition). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GNSS LLH Position (0x92,0x03).
pub type GnssLlhPosition = crate::gnss_1::GnssLlhPosition;

/// GNSS ECEF position (0x92,0x04).
///
/// GNSS position in Earth-fixed coordinates.
///
/// Has the layout of [`gnss_1::GnssEcefPosition`](crate::gnss_1::GnssEcefPosition). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GNSS ECEF Position (0x92,0x04).
pub type GnssEcefPosition = crate::gnss_1::GnssEcefPosition;

/// NED velocity (0x92,0x05).
///
/// GNSS velocity in the local level frame.
///
/// Has the layout of [`gnss_1::NedVelocity`](crate::gnss_1::NedVelocity). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: NED Velocity (0x92,0x05).
pub type NedVelocity = crate::gnss_1::NedVelocity;

/// GNSS ECEF velocity (0x92,0x06).
///
/// GNSS velocity in Earth-fixed coordinates.
///
/// Has the layout of [`gnss_1::GnssEcefVelocity`](crate::gnss_1::GnssEcefVelocity). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06).
pub type GnssEcefVelocity = crate::gnss_1::GnssEcefVelocity;

/// DOP (0x92,0x07).
///
/// Dilution of precision of the satellite geometry.
///
/// Has the layout of [`gnss_1::Dop`](crate::gnss_1::Dop). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: DOP (0x92,0x07).
pub type Dop = crate::gnss_1::Dop;

/// UTC time (0x92,0x08).
///
/// Coordinated universal time as the receiver knows it.
///
/// Has the layout of [`gnss_1::UtcTime`](crate::gnss_1::UtcTime). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: UTC Time (0x92,0x08).
pub type UtcTime = crate::gnss_1::UtcTime;

/// GPS time (0x92,0x09).
///
/// GPS time as the receiver knows it.
///
/// Has the layout of [`gnss_1::GpsTime`](crate::gnss_1::GpsTime). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GPS Time (0x92,0x09).
pub type GpsTime = crate::gnss_1::GpsTime;

/// Fix info (0x92,0x0B).
///
/// Type of the position fix and what it is made of.
///
/// Has the layout of [`gnss_1::FixInfo`](crate::gnss_1::FixInfo). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B).
pub type FixInfo = crate::gnss_1::FixInfo;

/// GNSS hardware status (0x92,0x0D).
///
/// State of the receiver and of its antenna.
///
/// Has the layout of [`gnss_1::GnssHardwareStatus`](crate::gnss_1::GnssHardwareStatus). Supported
/// by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GNSS Hardware Status (0x92,0x0D).
pub type GnssHardwareStatus = crate::gnss_1::GnssHardwareStatus;

/// Clock info 2 (0x92,0x10).
///
/// Bias and drift of the receiver clock.
///
/// Has the layout of [`gnss_1::ClockInfo2`](crate::gnss_1::ClockInfo2). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - It supersedes an older field, which the manual does not define.
///
/// Source: 3dm-cv7-gnss-ins: Clock Info 2 (0x92,0x10).
pub type ClockInfo2 = crate::gnss_1::ClockInfo2;

/// GPS leap seconds (0x92,0x11).
///
/// Difference between GPS time and UTC.
///
/// Has the layout of [`gnss_1::GpsLeapSeconds`](crate::gnss_1::GpsLeapSeconds). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: GPS Leap Seconds (0x92,0x11).
pub type GpsLeapSeconds = crate::gnss_1::GpsLeapSeconds;

/// SBAS info (0x92,0x12).
///
/// Status of the satellite based augmentation.
///
/// Has the layout of [`gnss_1::SbasInfo`](crate::gnss_1::SbasInfo). Supported by 3DM-CV7-GNSS/INS.
///
/// Source: 3dm-cv7-gnss-ins: SBAS Info (0x92,0x12).
pub type SbasInfo = crate::gnss_1::SbasInfo;

/// Satellite status (0x92,0x20).
///
/// Where one satellite stands, and its health.
///
/// Has the layout of [`gnss_1::SatelliteStatus`](crate::gnss_1::SatelliteStatus). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - An epoch is sent as one field for each satellite; index and count number the fields.
///
/// Source: 3dm-cv7-gnss-ins: Satellite Status (0x92,0x20).
pub type SatelliteStatus = crate::gnss_1::SatelliteStatus;

/// Raw (0x92,0x22).
///
/// Raw observation of one signal of one satellite.
///
/// Has the layout of [`gnss_1::Raw`](crate::gnss_1::Raw). Supported by 3DM-CV7-GNSS/INS.
///
/// - An epoch is sent as one field for each signal; index and count number the fields.
/// - The greatest lock time depends on the receiver.
///
/// Source: 3dm-cv7-gnss-ins: Raw (0x92,0x22).
pub type Raw = crate::gnss_1::Raw;

/// GPS ephemeris (0x92,0x61).
///
/// Broadcast orbit and clock of one GPS satellite.
///
/// Has the layout of [`gnss_1::GpsEphemeris`](crate::gnss_1::GpsEphemeris). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - Iodec changes with the clock data; the manual has it roll over at 4.
///
/// Source: 3dm-cv7-gnss-ins: GPS Ephemeris (0x92,0x61).
pub type GpsEphemeris = crate::gnss_1::GpsEphemeris;

/// GLONASS ephemeris (0x92,0x62).
///
/// Broadcast orbit and clock of one GLONASS satellite.
///
/// Has the layout of [`gnss_1::GlonassEphemeris`](crate::gnss_1::GlonassEphemeris). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - The interface control document of GLONASS explains p and ft.
/// - A period of four years has 1461 days; the manual does not say how nt, a u8, counts them.
///
/// Source: 3dm-cv7-gnss-ins: Glonass Ephemeris (0x92,0x62).
pub type GlonassEphemeris = crate::gnss_1::GlonassEphemeris;

/// Galileo ephemeris (0x92,0x63).
///
/// Broadcast orbit and clock of one Galileo satellite.
///
/// Has the layout of [`gnss_1::GalileoEphemeris`](crate::gnss_1::GalileoEphemeris). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
///   corrections hold here.
/// - Iodec changes with the clock data; the manual has it roll over at 4.
///
/// Source: 3dm-cv7-gnss-ins: Galileo Ephemeris (0x92,0x63).
pub type GalileoEphemeris = crate::gnss_1::GalileoEphemeris;

/// BeiDou ephemeris (0x92,0x64).
///
/// Broadcast orbit and clock of one BeiDou satellite.
///
/// Has the layout of [`gnss_1::BeidouEphemeris`](crate::gnss_1::BeidouEphemeris). Supported by
/// 3DM-CV7-GNSS/INS.
///
/// - The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
///   corrections hold here.
/// - Iodec changes with the clock data; the manual has it roll over at 4.
///
/// Source: 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x92,0x64).
pub type BeidouEphemeris = crate::gnss_1::BeidouEphemeris;
