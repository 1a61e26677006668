//! External GNSS data (0x94): What an external GNSS receiver tells the device by NMEA sentences. A
//! field may need several sentences; a value that NMEA does not give is not valid. Times are those
//! of the sentences.
//!
//! Uncertain: Which devices send the fields that no manual lists for this set. The SDK gives all
//! GNSS data sets the same fields.
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
/// Has the layout of [`gnss_1::LlhPosition`](crate::gnss_1::LlhPosition). Also called `pos_llh`.
/// Supported by 3DM-CV7-GNSS/INS. May be supported by 3DM-CV7-INS.
///
/// Source: 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03).
pub type LlhPosition = crate::gnss_1::LlhPosition;

/// GNSS ECEF position (0x94,0x04).
///
/// GNSS position in Earth-fixed coordinates.
///
/// Has the layout of [`gnss_1::EcefPosition`](crate::gnss_1::EcefPosition). Also called `pos_ecef`.
/// May be supported by 3DM-CV7-INS. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type EcefPosition = crate::gnss_1::EcefPosition;

/// NED velocity (0x94,0x05).
///
/// GNSS velocity in the local level frame.
///
/// Has the layout of [`gnss_1::NedVelocity`](crate::gnss_1::NedVelocity). Also called `vel_ned`.
/// Supported by 3DM-CV7-GNSS/INS. May be supported by 3DM-CV7-INS.
///
/// Source: 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05).
pub type NedVelocity = crate::gnss_1::NedVelocity;

/// GNSS ECEF velocity (0x94,0x06).
///
/// GNSS velocity in Earth-fixed coordinates.
///
/// Has the layout of [`gnss_1::EcefVelocity`](crate::gnss_1::EcefVelocity). Also called `vel_ecef`.
/// May be supported by 3DM-CV7-INS. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type EcefVelocity = crate::gnss_1::EcefVelocity;

/// DOP (0x94,0x07).
///
/// Dilution of precision of the satellite geometry.
///
/// Has the layout of [`gnss_1::Dop`](crate::gnss_1::Dop). May be supported by 3DM-CV7-INS. Known
/// from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type Dop = crate::gnss_1::Dop;

/// UTC time (0x94,0x08).
///
/// Coordinated universal time as the receiver knows it.
///
/// Has the layout of [`gnss_1::UtcTime`](crate::gnss_1::UtcTime). Supported by 3DM-CV7-GNSS/INS.
/// May be supported by 3DM-CV7-INS.
///
/// Source: 3dm-cv7-gnss-ins: UTC Time (0x94,0x08).
pub type UtcTime = crate::gnss_1::UtcTime;

/// GPS time (0x94,0x09).
///
/// GPS time as the receiver knows it.
///
/// Has the layout of [`gnss_1::GpsTime`](crate::gnss_1::GpsTime). No device profile lists it. Known
/// from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GpsTime = crate::gnss_1::GpsTime;

/// Clock info (0x94,0x0A).
///
/// Bias and drift of the receiver clock.
///
/// Has the layout of [`gnss_1::ClockInfo`](crate::gnss_1::ClockInfo). No device profile lists it.
/// Known from the MicroStrain MIP SDK only.
///
/// - Clock info 2 replaces it and tells more.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type ClockInfo = crate::gnss_1::ClockInfo;

/// Fix info (0x94,0x0B).
///
/// Type of the position fix and what it is made of.
///
/// Has the layout of [`gnss_1::FixInfo`](crate::gnss_1::FixInfo). Supported by 3DM-CV7-GNSS/INS.
/// May be supported by 3DM-CV7-INS.
///
/// Source: 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B).
pub type FixInfo = crate::gnss_1::FixInfo;

/// Satellite info (0x94,0x0C).
///
/// One satellite that is tracked.
///
/// Has the layout of [`gnss_1::SvInfo`](crate::gnss_1::SvInfo). No device profile lists it. Known
/// from the MicroStrain MIP SDK only. Uncertain: Whether a packet holds one of these fields or
/// several.
///
/// - The satellites come as one field each, in packets apart from other GNSS data.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type SvInfo = crate::gnss_1::SvInfo;

/// GNSS hardware status (0x94,0x0D).
///
/// State of the receiver and of its antenna.
///
/// Has the layout of [`gnss_1::HardwareStatus`](crate::gnss_1::HardwareStatus). Also called
/// `hw_status`. No device profile lists it. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type HardwareStatus = crate::gnss_1::HardwareStatus;

/// DGPS info (0x94,0x0E).
///
/// State of the differential corrections.
///
/// Has the layout of [`gnss_1::DgpsInfo`](crate::gnss_1::DgpsInfo). No device profile lists it.
/// Known from the MicroStrain MIP SDK only. Uncertain: The layout is that of a manual of the
/// 3DM-GX5-35 and of MSCL, another library of the vendor. It agrees with the valid flags.
/// Uncertain: The SDK has another one, u8, three floats and u16, which is that of
/// [`gnss_1::DgpsChannel`](crate::gnss_1::DgpsChannel) and does not agree with its own valid flags
/// (age, base station id, base station status, number of channels).
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type DgpsInfo = crate::gnss_1::DgpsInfo;

/// DGPS channel (0x94,0x0F).
///
/// Differential correction for one satellite.
///
/// Has the layout of [`gnss_1::DgpsChannel`](crate::gnss_1::DgpsChannel). No device profile lists
/// it. Known from the MicroStrain MIP SDK only.
///
/// - The active satellites come as one field each, all in one packet.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type DgpsChannel = crate::gnss_1::DgpsChannel;

/// Clock info 2 (0x94,0x10).
///
/// Bias and drift of the receiver clock.
///
/// Has the layout of [`gnss_1::ClockInfo2`](crate::gnss_1::ClockInfo2). May be supported by
/// 3DM-CV7-INS. Known from the MicroStrain MIP SDK only.
///
/// - It supersedes clock info.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type ClockInfo2 = crate::gnss_1::ClockInfo2;

/// GPS leap seconds (0x94,0x11).
///
/// Difference between GPS time and UTC.
///
/// Has the layout of [`gnss_1::GpsLeapSeconds`](crate::gnss_1::GpsLeapSeconds). May be supported by
/// 3DM-CV7-INS. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GpsLeapSeconds = crate::gnss_1::GpsLeapSeconds;

/// SBAS info (0x94,0x12).
///
/// Status of the satellite based augmentation.
///
/// Has the layout of [`gnss_1::SbasInfo`](crate::gnss_1::SbasInfo). No device profile lists it.
/// Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type SbasInfo = crate::gnss_1::SbasInfo;

/// SBAS correction (0x94,0x13).
///
/// SBAS correction for one satellite.
///
/// Has the layout of [`gnss_1::SbasCorrection`](crate::gnss_1::SbasCorrection). No device profile
/// lists it. Known from the MicroStrain MIP SDK only.
///
/// - An epoch is sent as one field for each satellite; index and count number the fields.
/// - Udrei 0 to 13 are these variances in m^2: 0.0520, 0.0924, 0.1444, 0.2830, 0.4678, 0.8315,
///   1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type SbasCorrection = crate::gnss_1::SbasCorrection;

/// RF error detection (0x94,0x14).
///
/// Jamming and spoofing as the receiver detects them in one band.
///
/// Has the layout of [`gnss_1::RfErrorDetection`](crate::gnss_1::RfErrorDetection). May be
/// supported by 3DM-CV7-INS. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type RfErrorDetection = crate::gnss_1::RfErrorDetection;

/// Satellite status (0x94,0x20).
///
/// Where one satellite stands, and its health.
///
/// Has the layout of [`gnss_1::SatelliteStatus`](crate::gnss_1::SatelliteStatus). Supported by
/// 3DM-CV7-GNSS/INS. May be supported by 3DM-CV7-INS.
///
/// - An epoch is sent as one field for each satellite; index and count number the fields.
///
/// Source: 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20).
pub type SatelliteStatus = crate::gnss_1::SatelliteStatus;

/// Raw (0x94,0x22).
///
/// Raw observation of one signal of one satellite.
///
/// Has the layout of [`gnss_1::Raw`](crate::gnss_1::Raw). No device profile lists it. Known from
/// the MicroStrain MIP SDK only.
///
/// - An epoch is sent as one field for each signal; index and count number the fields.
/// - The greatest lock time depends on the receiver.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type Raw = crate::gnss_1::Raw;

/// Base station info (0x94,0x30).
///
/// The base station of the corrections, from an RTCM message 1005 or 1006.
///
/// Has the layout of [`gnss_1::BaseStationInfo`](crate::gnss_1::BaseStationInfo). No device profile
/// lists it. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type BaseStationInfo = crate::gnss_1::BaseStationInfo;

/// RTK corrections status (0x94,0x31).
///
/// Which corrections come, and how old they are.
///
/// Has the layout of [`gnss_1::RtkCorrectionsStatus`](crate::gnss_1::RtkCorrectionsStatus). No
/// device profile lists it. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type RtkCorrectionsStatus = crate::gnss_1::RtkCorrectionsStatus;

/// GPS ephemeris (0x94,0x61).
///
/// Broadcast orbit and clock of one GPS satellite.
///
/// Has the layout of [`gnss_1::GpsEphemeris`](crate::gnss_1::GpsEphemeris). No device profile lists
/// it. Known from the MicroStrain MIP SDK only.
///
/// - `iodc` changes with the clock data; the manual has it roll over at 4.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GpsEphemeris = crate::gnss_1::GpsEphemeris;

/// GLONASS ephemeris (0x94,0x62).
///
/// Broadcast orbit and clock of one GLONASS satellite.
///
/// Has the layout of [`gnss_1::GlonassEphemeris`](crate::gnss_1::GlonassEphemeris). Also called
/// `glo_ephemeris`. No device profile lists it. Known from the MicroStrain MIP SDK only.
///
/// - The interface control document of GLONASS explains p and ft.
/// - A period of four years has 1461 days; the manual does not say how nt, a u8, counts them.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GlonassEphemeris = crate::gnss_1::GlonassEphemeris;

/// Galileo ephemeris (0x94,0x63).
///
/// Broadcast orbit and clock of one Galileo satellite.
///
/// Has the layout of [`gnss_1::GalileoEphemeris`](crate::gnss_1::GalileoEphemeris). No device
/// profile lists it. Known from the MicroStrain MIP SDK only.
///
/// - The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
///   corrections hold here.
/// - `iodc` changes with the clock data; the manual has it roll over at 4.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GalileoEphemeris = crate::gnss_1::GalileoEphemeris;

/// BeiDou ephemeris (0x94,0x64).
///
/// Broadcast orbit and clock of one BeiDou satellite.
///
/// Has the layout of [`gnss_1::BeidouEphemeris`](crate::gnss_1::BeidouEphemeris). No device profile
/// lists it. Known from the MicroStrain MIP SDK only.
///
/// - The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
///   corrections hold here.
/// - `iodc` changes with the clock data; the manual has it roll over at 4.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type BeidouEphemeris = crate::gnss_1::BeidouEphemeris;

/// GPS ionospheric correction (0x94,0x71).
///
/// Model of the ionosphere that GPS broadcasts.
///
/// Has the layout of [`gnss_1::GpsIonoCorrection`](crate::gnss_1::GpsIonoCorrection). Also called
/// `gps_iono_corr`. No device profile lists it. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GpsIonoCorrection = crate::gnss_1::GpsIonoCorrection;

/// Galileo ionospheric correction (0x94,0x73).
///
/// Model of the ionosphere that Galileo broadcasts.
///
/// Has the layout of [`gnss_1::GalileoIonoCorrection`](crate::gnss_1::GalileoIonoCorrection). Also
/// called `galileo_iono_corr`. No device profile lists it. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type GalileoIonoCorrection = crate::gnss_1::GalileoIonoCorrection;

/// BeiDou ionospheric correction (0x94,0x74).
///
/// Model of the ionosphere that BeiDou broadcasts.
///
/// Has the layout of [`gnss_1::BeidouIonoCorrection`](crate::gnss_1::BeidouIonoCorrection). Also
/// called `beidou_iono_corr`. No device profile lists it. Known from the MicroStrain MIP SDK only.
///
/// Source: mip-sdk-4: Gnss4 Data (0x94).
pub type BeidouIonoCorrection = crate::gnss_1::BeidouIonoCorrection;
