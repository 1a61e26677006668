//! External GNSS data (0x94): Data that an external GNSS receiver sends to the device in NMEA
//! sentences. A field may need several sentences; a value that NMEA does not provide is not valid.
//! Times are those of the sentences.
//!
//! Uncertain: Which devices send the fields that no manual lists for this set. The SDK gives all
//! GNSS data sets the same fields.
//!
//! Source: 3dm-cv7-gnss-ins: GNSS External (0x94); 3dm-cv7-gnss-ins: NMEA Input.

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x94;

record! {
    /// GNSS LLH position (0x94,0x03).
    ///
    /// GNSS position as latitude, longitude and height.
    ///
    /// Has the layout of [`gnss_1::LlhPosition`](crate::gnss_1::LlhPosition). Also called
    /// `pos_llh`. Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS). May be supported
    /// by [3DM-CV7-INS](crate::devices::CV7_INS).
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03).
    #[derive(Copy, Default)]
    pub struct LlhPosition {
        /// Latitude.
        ///
        /// Unit: deg. Frame: llh. Valid if
        /// [`valid_flags.lat_lon`](crate::gnss_1::LlhPositionFlags::lat_lon) is set.
        pub latitude: f64,
        /// Longitude.
        ///
        /// Unit: deg. Frame: llh. Valid if
        /// [`valid_flags.lat_lon`](crate::gnss_1::LlhPositionFlags::lat_lon) is set.
        pub longitude: f64,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh. Valid if
        /// [`valid_flags.ellipsoid_height`](crate::gnss_1::LlhPositionFlags::ellipsoid_height) is
        /// set.
        pub ellipsoid_height: f64,
        /// Height above mean sea level.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.msl_height`](crate::gnss_1::LlhPositionFlags::msl_height) is set.
        pub msl_height: f64,
        /// Horizontal accuracy.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.horizontal_accuracy`](crate::gnss_1::LlhPositionFlags::horizontal_accuracy)
        /// is set.
        pub horizontal_accuracy: f32,
        /// Vertical accuracy.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.vertical_accuracy`](crate::gnss_1::LlhPositionFlags::vertical_accuracy) is
        /// set.
        pub vertical_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::LlhPositionFlags,
    }
}

field! {
    LlhPosition: 0x94, 0x03, "gnss_external.llh_position";
}

record! {
    /// GNSS ECEF position (0x94,0x04).
    ///
    /// GNSS position in Earth-fixed coordinates.
    ///
    /// Has the layout of [`gnss_1::EcefPosition`](crate::gnss_1::EcefPosition). Also called
    /// `pos_ecef`. May be supported by [3DM-CV7-INS](crate::devices::CV7_INS). Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct EcefPosition {
        /// Position.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.position`](crate::gnss_1::EcefPositionFlags::position) is set.
        pub position: types::Vector3d,
        /// Accuracy of the position.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.position_accuracy`](crate::gnss_1::EcefPositionFlags::position_accuracy)
        /// is set.
        pub position_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::EcefPositionFlags,
    }
}

field! {
    EcefPosition: 0x94, 0x04, "gnss_external.ecef_position";
}

record! {
    /// NED velocity (0x94,0x05).
    ///
    /// GNSS velocity in the local level frame.
    ///
    /// Has the layout of [`gnss_1::NedVelocity`](crate::gnss_1::NedVelocity). Also called
    /// `vel_ned`. Supported by [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS). May be supported
    /// by [3DM-CV7-INS](crate::devices::CV7_INS).
    ///
    /// Source: 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05).
    #[derive(Copy, Default)]
    pub struct NedVelocity {
        /// Velocity.
        ///
        /// Elements: north, east, down. Unit: m/s. Frame: ned. Valid if
        /// [`valid_flags.velocity`](crate::gnss_1::NedVelocityFlags::velocity) is set.
        pub velocity: types::Ned3f,
        /// Speed in space.
        ///
        /// Unit: m/s. Valid if [`valid_flags.speed_3d`](crate::gnss_1::NedVelocityFlags::speed_3d)
        /// is set.
        pub speed: f32,
        /// Speed over ground.
        ///
        /// Unit: m/s. Valid if
        /// [`valid_flags.ground_speed`](crate::gnss_1::NedVelocityFlags::ground_speed) is set.
        pub ground_speed: f32,
        /// Direction of the motion over ground.
        ///
        /// Unit: deg. Frame: ned. Valid if
        /// [`valid_flags.heading`](crate::gnss_1::NedVelocityFlags::heading) is set.
        pub heading: f32,
        /// Accuracy of the speed.
        ///
        /// Unit: m/s. Valid if
        /// [`valid_flags.speed_accuracy`](crate::gnss_1::NedVelocityFlags::speed_accuracy) is set.
        pub speed_accuracy: f32,
        /// Accuracy of the heading.
        ///
        /// Unit: deg. Valid if
        /// [`valid_flags.heading_accuracy`](crate::gnss_1::NedVelocityFlags::heading_accuracy) is
        /// set.
        pub heading_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::NedVelocityFlags,
    }
}

field! {
    NedVelocity: 0x94, 0x05, "gnss_external.ned_velocity";
}

record! {
    /// GNSS ECEF velocity (0x94,0x06).
    ///
    /// GNSS velocity in Earth-fixed coordinates.
    ///
    /// Has the layout of [`gnss_1::EcefVelocity`](crate::gnss_1::EcefVelocity). Also called
    /// `vel_ecef`. May be supported by [3DM-CV7-INS](crate::devices::CV7_INS). Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct EcefVelocity {
        /// Velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. Valid if
        /// [`valid_flags.velocity`](crate::gnss_1::EcefVelocityFlags::velocity) is set.
        pub velocity: types::Vector3f,
        /// Accuracy of the velocity.
        ///
        /// Unit: m/s. Valid if
        /// [`valid_flags.velocity_accuracy`](crate::gnss_1::EcefVelocityFlags::velocity_accuracy)
        /// is set.
        pub velocity_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::EcefVelocityFlags,
    }
}

field! {
    EcefVelocity: 0x94, 0x06, "gnss_external.ecef_velocity";
}

record! {
    /// DOP (0x94,0x07).
    ///
    /// Dilution of precision of the satellite geometry.
    ///
    /// Has the layout of [`gnss_1::Dop`](crate::gnss_1::Dop). May be supported by
    /// [3DM-CV7-INS](crate::devices::CV7_INS). Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct Dop {
        /// Geometric dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.gdop`](crate::gnss_1::DopFlags::gdop) is set.
        pub gdop: f32,
        /// Position dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.pdop`](crate::gnss_1::DopFlags::pdop) is set.
        pub pdop: f32,
        /// Horizontal dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.hdop`](crate::gnss_1::DopFlags::hdop) is set.
        pub hdop: f32,
        /// Vertical dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.vdop`](crate::gnss_1::DopFlags::vdop) is set.
        pub vdop: f32,
        /// Time dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.tdop`](crate::gnss_1::DopFlags::tdop) is set.
        pub tdop: f32,
        /// Northing dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.ndop`](crate::gnss_1::DopFlags::ndop) is set.
        pub ndop: f32,
        /// Easting dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.edop`](crate::gnss_1::DopFlags::edop) is set.
        pub edop: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::DopFlags,
    }
}

field! {
    Dop: 0x94, 0x07, "gnss_external.dop";
}

record! {
    /// UTC time (0x94,0x08).
    ///
    /// Coordinated universal time as the receiver knows it.
    ///
    /// Has the layout of [`gnss_1::UtcTime`](crate::gnss_1::UtcTime). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS). May be supported by
    /// [3DM-CV7-INS](crate::devices::CV7_INS).
    ///
    /// Source: 3dm-cv7-gnss-ins: UTC Time (0x94,0x08).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct UtcTime {
        /// Year.
        ///
        /// Valid if [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is
        /// set.
        pub year: u16,
        /// Month.
        ///
        /// Range: 1 to 12. Valid if
        /// [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is set.
        pub month: u8,
        /// Day of the month.
        ///
        /// Range: 1 to 31. Valid if
        /// [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is set.
        pub day: u8,
        /// Hour.
        ///
        /// Range: 0 to 23. Valid if
        /// [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is set.
        pub hour: u8,
        /// Minute.
        ///
        /// Range: 0 to 59. Valid if
        /// [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is set.
        pub min: u8,
        /// Second.
        ///
        /// Unit: s. Range: 0 to 59. Valid if
        /// [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is set.
        pub sec: u8,
        /// Fraction of the second.
        ///
        /// Unit: ms. Range: 0 to 999. Valid if
        /// [`valid_flags.gnss_date_time`](crate::gnss_1::UtcTimeFlags::gnss_date_time) is set.
        pub msec: u32,
        /// Which parts of the time are valid.
        pub valid_flags: crate::gnss_1::UtcTimeFlags,
    }
}

field! {
    UtcTime: 0x94, 0x08, "gnss_external.utc_time";
}

record! {
    /// GPS time (0x94,0x09).
    ///
    /// GPS time as the receiver knows it.
    ///
    /// Has the layout of [`gnss_1::GpsTime`](crate::gnss_1::GpsTime). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct GpsTime {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::GpsTimeFlags::tow) is set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::GpsTimeFlags::week_number) is set.
        pub week_number: u16,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::GpsTimeFlags,
    }
}

field! {
    GpsTime: 0x94, 0x09, "gnss_external.gps_time";
}

record! {
    /// Clock info (0x94,0x0A).
    ///
    /// Bias and drift of the receiver clock.
    ///
    /// Has the layout of [`gnss_1::ClockInfo`](crate::gnss_1::ClockInfo). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - Clock info 2 replaces it and gives more detail.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct ClockInfo {
        /// Bias of the clock.
        ///
        /// Unit: s. Valid if [`valid_flags.bias`](crate::gnss_1::ClockInfoFlags::bias) is set.
        pub bias: f64,
        /// Drift of the clock.
        ///
        /// Unit: s/s. Valid if [`valid_flags.drift`](crate::gnss_1::ClockInfoFlags::drift) is set.
        pub drift: f64,
        /// Estimated accuracy.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.accuracy_estimate`](crate::gnss_1::ClockInfoFlags::accuracy_estimate) is
        /// set.
        pub accuracy_estimate: f64,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::ClockInfoFlags,
    }
}

field! {
    ClockInfo: 0x94, 0x0A, "gnss_external.clock_info";
}

record! {
    /// Fix info (0x94,0x0B).
    ///
    /// Type of the position fix and what it is based on.
    ///
    /// Has the layout of [`gnss_1::FixInfo`](crate::gnss_1::FixInfo). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS). May be supported by
    /// [3DM-CV7-INS](crate::devices::CV7_INS).
    ///
    /// Source: 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct FixInfo {
        /// Type of the fix.
        ///
        /// Valid if [`valid_flags.fix_type`](crate::gnss_1::FixInfoFlags::fix_type) is set.
        pub fix_type: types::GnssFixType,
        /// Number of satellites used in the fix.
        ///
        /// Unit: 1. Valid if [`valid_flags.num_sv`](crate::gnss_1::FixInfoFlags::num_sv) is set.
        pub num_sv: u8,
        /// What the fix uses.
        ///
        /// Valid if [`valid_flags.fix_flags`](crate::gnss_1::FixInfoFlags::fix_flags) is set.
        pub fix_flags: crate::gnss_1::FixFlags,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::FixInfoFlags,
    }
}

field! {
    FixInfo: 0x94, 0x0B, "gnss_external.fix_info";
}

record! {
    /// Satellite info (0x94,0x0C).
    ///
    /// One satellite that is tracked.
    ///
    /// Has the layout of [`gnss_1::SvInfo`](crate::gnss_1::SvInfo). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK. Uncertain: Whether a packet holds one of
    /// these fields or several.
    ///
    /// - Each satellite is sent as one field, in packets separate from other GNSS data.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SvInfo {
        /// Channel of the receiver that tracks the satellite.
        ///
        /// Valid if [`valid_flags.channel`](crate::gnss_1::SvInfoFlags::channel) is set.
        pub channel: u8,
        /// Number of the satellite.
        ///
        /// Valid if [`valid_flags.satellite_id`](crate::gnss_1::SvInfoFlags::satellite_id) is set.
        pub satellite_id: u8,
        /// Carrier to noise density ratio.
        ///
        /// Unit: dB-Hz. Valid if
        /// [`valid_flags.carrier_noise_ratio`](crate::gnss_1::SvInfoFlags::carrier_noise_ratio) is
        /// set.
        pub carrier_noise_ratio: u16,
        /// Azimuth.
        ///
        /// Unit: deg. Valid if [`valid_flags.azimuth`](crate::gnss_1::SvInfoFlags::azimuth) is set.
        pub azimuth: i16,
        /// Elevation.
        ///
        /// Unit: deg. Valid if [`valid_flags.elevation`](crate::gnss_1::SvInfoFlags::elevation) is
        /// set.
        pub elevation: i16,
        /// State of the satellite.
        ///
        /// Valid if [`valid_flags.sv_flags`](crate::gnss_1::SvInfoFlags::sv_flags) is set.
        pub sv_flags: crate::gnss_1::SvFlags,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::SvInfoFlags,
    }
}

field! {
    SvInfo: 0x94, 0x0C, "gnss_external.sv_info";
}

record! {
    /// GNSS hardware status (0x94,0x0D).
    ///
    /// State of the receiver and of its antenna.
    ///
    /// Has the layout of [`gnss_1::HardwareStatus`](crate::gnss_1::HardwareStatus). Also called
    /// `hw_status`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct HardwareStatus {
        /// State of the receiver.
        ///
        /// Valid if [`valid_flags.sensor_state`](crate::gnss_1::HardwareStatusFlags::sensor_state)
        /// is set.
        pub receiver_state: crate::gnss_1::ReceiverState,
        /// State of the antenna.
        ///
        /// Valid if
        /// [`valid_flags.antenna_state`](crate::gnss_1::HardwareStatusFlags::antenna_state) is set.
        pub antenna_state: crate::gnss_1::AntennaState,
        /// Supply of the antenna.
        ///
        /// Valid if
        /// [`valid_flags.antenna_power`](crate::gnss_1::HardwareStatusFlags::antenna_power) is set.
        pub antenna_power: crate::gnss_1::AntennaPower,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::HardwareStatusFlags,
    }
}

field! {
    HardwareStatus: 0x94, 0x0D, "gnss_external.hardware_status";
}

record! {
    /// DGPS info (0x94,0x0E).
    ///
    /// State of the differential corrections.
    ///
    /// Has the layout of [`gnss_1::DgpsInfo`](crate::gnss_1::DgpsInfo). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK. Uncertain: The layout is from a manual of
    /// the 3DM-GX5-35 and from MSCL, another library of the vendor. It agrees with the valid flags.
    /// Uncertain: The SDK has another layout: u8, three floats and u16. It is that of
    /// [`gnss_1::DgpsChannel`](crate::gnss_1::DgpsChannel) and does not agree with its own valid
    /// flags (age, base station id, base station status, number of channels).
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct DgpsInfo {
        /// Age of the corrections.
        ///
        /// Unit: s. Valid if [`valid_flags.age`](crate::gnss_1::DgpsInfoFlags::age) is set.
        /// Uncertain: The unit, which follows from
        /// [`gnss_1::DgpsChannel`](crate::gnss_1::DgpsChannel).
        pub age: f32,
        /// Number of the base station.
        ///
        /// Valid if [`valid_flags.base_station_id`](crate::gnss_1::DgpsInfoFlags::base_station_id)
        /// is set.
        pub base_station_id: i16,
        /// State of the base station: 0 to 5 are factors of the user differential range error,
        /// which are 1.0, 0.75, 0.5, 0.3, 0.2 and 0.1; 6 is not monitored, 7 not working.
        ///
        /// Valid if
        /// [`valid_flags.base_station_status`](crate::gnss_1::DgpsInfoFlags::base_station_status)
        /// is set.
        pub base_station_status: i16,
        /// Number of channels that have corrections.
        ///
        /// Unit: 1. Valid if
        /// [`valid_flags.num_channels`](crate::gnss_1::DgpsInfoFlags::num_channels) is set.
        pub num_channels: u16,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::DgpsInfoFlags,
    }
}

field! {
    DgpsInfo: 0x94, 0x0E, "gnss_external.dgps_info";
}

record! {
    /// DGPS channel (0x94,0x0F).
    ///
    /// Differential correction for one satellite.
    ///
    /// Has the layout of [`gnss_1::DgpsChannel`](crate::gnss_1::DgpsChannel). Not listed in any
    /// device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - Each active satellite is sent as one field, all in one packet.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct DgpsChannel {
        /// Number of the satellite.
        ///
        /// Valid if [`valid_flags.satellite_id`](crate::gnss_1::DgpsChannelFlags::satellite_id) is
        /// set.
        pub satellite_id: u8,
        /// Age of the correction.
        ///
        /// Unit: s. Valid if [`valid_flags.age`](crate::gnss_1::DgpsChannelFlags::age) is set.
        pub age: f32,
        /// Correction of the range.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.range_correction`](crate::gnss_1::DgpsChannelFlags::range_correction) is
        /// set.
        pub range_correction: f32,
        /// Correction of the range rate.
        ///
        /// Unit: m/s. Valid if
        /// [`valid_flags.range_rate_correction`](crate::gnss_1::DgpsChannelFlags::range_rate_correction)
        /// is set.
        pub range_rate_correction: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::DgpsChannelFlags,
    }
}

field! {
    DgpsChannel: 0x94, 0x0F, "gnss_external.dgps_channel";
}

record! {
    /// Clock info 2 (0x94,0x10).
    ///
    /// Bias and drift of the receiver clock.
    ///
    /// Has the layout of [`gnss_1::ClockInfo2`](crate::gnss_1::ClockInfo2). May be supported by
    /// [3DM-CV7-INS](crate::devices::CV7_INS). Known only from the MicroStrain MIP SDK.
    ///
    /// - It supersedes clock info.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct ClockInfo2 {
        /// Bias of the clock.
        ///
        /// Unit: s. Valid if [`valid_flags.bias`](crate::gnss_1::ClockInfo2Flags::bias) is set.
        pub bias: f64,
        /// Drift of the clock.
        ///
        /// Unit: s/s. Valid if [`valid_flags.drift`](crate::gnss_1::ClockInfo2Flags::drift) is set.
        pub drift: f64,
        /// Accuracy of the bias.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.bias_accuracy`](crate::gnss_1::ClockInfo2Flags::bias_accuracy) is set.
        pub bias_accuracy_estimate: f64,
        /// Accuracy of the drift.
        ///
        /// Unit: s/s. Valid if
        /// [`valid_flags.drift_accuracy`](crate::gnss_1::ClockInfo2Flags::drift_accuracy) is set.
        pub drift_accuracy_estimate: f64,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::ClockInfo2Flags,
    }
}

field! {
    ClockInfo2: 0x94, 0x10, "gnss_external.clock_info_2";
}

record! {
    /// GPS leap seconds (0x94,0x11).
    ///
    /// Difference between GPS time and UTC.
    ///
    /// Has the layout of [`gnss_1::GpsLeapSeconds`](crate::gnss_1::GpsLeapSeconds). May be
    /// supported by [3DM-CV7-INS](crate::devices::CV7_INS). Known only from the MicroStrain MIP
    /// SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpsLeapSeconds {
        /// GPS time minus UTC.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.leap_seconds`](crate::gnss_1::GpsLeapSecondsFlags::leap_seconds) is set.
        pub leap_seconds: u8,
        /// Whether the value is valid.
        pub valid_flags: crate::gnss_1::GpsLeapSecondsFlags,
    }
}

field! {
    GpsLeapSeconds: 0x94, 0x11, "gnss_external.gps_leap_seconds";
}

record! {
    /// SBAS info (0x94,0x12).
    ///
    /// Status of the satellite based augmentation.
    ///
    /// Has the layout of [`gnss_1::SbasInfo`](crate::gnss_1::SbasInfo). Not listed in any device
    /// profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct SbasInfo {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::SbasInfoFlags::tow) is set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::SbasInfoFlags::week_number) is set.
        pub week_number: u16,
        /// System in use.
        ///
        /// Valid if [`valid_flags.sbas_system`](crate::gnss_1::SbasInfoFlags::sbas_system) is set.
        pub sbas_system: crate::gnss_1::SbasSystem,
        /// SBAS satellite.
        ///
        /// Valid if [`valid_flags.sbas_id`](crate::gnss_1::SbasInfoFlags::sbas_id) is set.
        pub sbas_id: u8,
        /// Number of SBAS corrections.
        ///
        /// Unit: 1. Valid if [`valid_flags.count`](crate::gnss_1::SbasInfoFlags::count) is set.
        pub count: u8,
        /// Status of the service.
        ///
        /// Valid if [`valid_flags.sbas_status`](crate::gnss_1::SbasInfoFlags::sbas_status) is set.
        pub sbas_status: crate::gnss_1::SbasStatus,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::SbasInfoFlags,
    }
}

field! {
    SbasInfo: 0x94, 0x12, "gnss_external.sbas_info";
}

record! {
    /// SBAS correction (0x94,0x13).
    ///
    /// SBAS correction for one satellite.
    ///
    /// Has the layout of [`gnss_1::SbasCorrection`](crate::gnss_1::SbasCorrection). Not listed in
    /// any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - An epoch is sent as one field for each satellite; `index` and `count` number the fields.
    /// - For `udrei` 0 to 13, the variances in m^2 are 0.0520, 0.0924, 0.1444, 0.2830, 0.4678,
    ///   0.8315, 1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct SbasCorrection {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week of the reception.
        ///
        /// Unit: s.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Constellation.
        pub gnss_id: types::GnssConstellation,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Indicator of the range error that remains after fast and long-term corrections, not
        /// counting the atmosphere; 14 is not monitored, 15 not usable.
        ///
        /// Range: 0 to 15. Valid if
        /// [`valid_flags.udrei`](crate::gnss_1::SbasCorrectionFlags::udrei) is set.
        pub udrei: u8,
        /// Correction of the pseudorange.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.pseudorange_correction`](crate::gnss_1::SbasCorrectionFlags::pseudorange_correction)
        /// is set.
        pub pseudorange_correction: f32,
        /// Correction of the ionospheric delay.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.iono_correction`](crate::gnss_1::SbasCorrectionFlags::iono_correction) is
        /// set.
        pub iono_correction: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::SbasCorrectionFlags,
    }
}

field! {
    SbasCorrection: 0x94, 0x13, "gnss_external.sbas_correction";
}

record! {
    /// RF error detection (0x94,0x14).
    ///
    /// Jamming and spoofing that the receiver detects in one band.
    ///
    /// Has the layout of [`gnss_1::RfErrorDetection`](crate::gnss_1::RfErrorDetection). May be
    /// supported by [3DM-CV7-INS](crate::devices::CV7_INS). Known only from the MicroStrain MIP
    /// SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct RfErrorDetection {
        /// Band.
        ///
        /// Valid if [`valid_flags.rf_band`](crate::gnss_1::RfErrorDetectionFlags::rf_band) is set.
        pub rf_band: crate::gnss_1::RfBand,
        /// Jamming.
        ///
        /// Valid if
        /// [`valid_flags.jamming_state`](crate::gnss_1::RfErrorDetectionFlags::jamming_state) is
        /// set.
        pub jamming_state: crate::gnss_1::JammingState,
        /// Spoofing.
        ///
        /// Valid if
        /// [`valid_flags.spoofing_state`](crate::gnss_1::RfErrorDetectionFlags::spoofing_state) is
        /// set.
        pub spoofing_state: crate::gnss_1::SpoofingState,
        /// Reserved.
        pub reserved: [u8; 4],
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::RfErrorDetectionFlags,
    }
}

field! {
    RfErrorDetection: 0x94, 0x14, "gnss_external.rf_error_detection";
}

record! {
    /// Satellite status (0x94,0x20).
    ///
    /// Direction to one satellite, and its health.
    ///
    /// Has the layout of [`gnss_1::SatelliteStatus`](crate::gnss_1::SatelliteStatus). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS). May be supported by
    /// [3DM-CV7-INS](crate::devices::CV7_INS).
    ///
    /// - An epoch is sent as one field for each satellite; `index` and `count` number the fields.
    ///
    /// Source: 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20).
    #[derive(Copy, Default)]
    pub struct SatelliteStatus {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::SatelliteStatusFlags::tow) is set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::SatelliteStatusFlags::week_number) is set.
        pub week_number: u16,
        /// Constellation.
        ///
        /// Valid if [`valid_flags.gnss_id`](crate::gnss_1::SatelliteStatusFlags::gnss_id) is set.
        pub gnss_id: types::GnssConstellation,
        /// Satellite within the constellation.
        ///
        /// Valid if [`valid_flags.satellite_id`](crate::gnss_1::SatelliteStatusFlags::satellite_id)
        /// is set.
        pub satellite_id: u8,
        /// Elevation, as seen from the rover.
        ///
        /// Unit: deg. Valid if
        /// [`valid_flags.elevation`](crate::gnss_1::SatelliteStatusFlags::elevation) is set.
        pub elevation: f32,
        /// Azimuth, as seen from the rover.
        ///
        /// Unit: deg. Valid if
        /// [`valid_flags.azimuth`](crate::gnss_1::SatelliteStatusFlags::azimuth) is set.
        pub azimuth: f32,
        /// Whether the satellite is healthy.
        ///
        /// Valid if [`valid_flags.health`](crate::gnss_1::SatelliteStatusFlags::health) is set.
        pub health: crate::Bool,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::SatelliteStatusFlags,
    }
}

field! {
    SatelliteStatus: 0x94, 0x20, "gnss_external.satellite_status";
}

record! {
    /// Raw (0x94,0x22).
    ///
    /// Raw observation of one signal of one satellite.
    ///
    /// Has the layout of [`gnss_1::Raw`](crate::gnss_1::Raw). Not listed in any device profile.
    /// Known only from the MicroStrain MIP SDK.
    ///
    /// - An epoch is sent as one field for each signal; `index` and `count` number the fields.
    /// - The greatest lock time depends on the receiver.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct Raw {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::RawFlags::tow) is set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](crate::gnss_1::RawFlags::week_number)
        /// is set.
        pub week_number: u16,
        /// Receiver, counted from 1; for a measurement from RTCM, the reference station.
        ///
        /// Valid if [`valid_flags.receiver_id`](crate::gnss_1::RawFlags::receiver_id) is set.
        pub receiver_id: u16,
        /// Channel that tracks the satellite.
        ///
        /// Valid if [`valid_flags.tracking_channel`](crate::gnss_1::RawFlags::tracking_channel) is
        /// set.
        pub tracking_channel: u8,
        /// Constellation.
        ///
        /// Valid if [`valid_flags.gnss_id`](crate::gnss_1::RawFlags::gnss_id) is set.
        pub gnss_id: types::GnssConstellation,
        /// Satellite within the constellation.
        ///
        /// Valid if [`valid_flags.satellite_id`](crate::gnss_1::RawFlags::satellite_id) is set.
        pub satellite_id: u8,
        /// Signal.
        ///
        /// Valid if [`valid_flags.signal_id`](crate::gnss_1::RawFlags::signal_id) is set.
        pub signal_id: types::GnssSignal,
        /// Carrier to noise density ratio.
        ///
        /// Unit: dB-Hz. Valid if
        /// [`valid_flags.signal_strength`](crate::gnss_1::RawFlags::signal_strength) is set.
        pub signal_strength: f32,
        /// How well the signal is tracked.
        ///
        /// Valid if [`valid_flags.quality`](crate::gnss_1::RawFlags::quality) is set.
        pub quality: crate::gnss_1::SignalQuality,
        /// Pseudorange.
        ///
        /// Unit: m. Valid if [`valid_flags.pseudorange`](crate::gnss_1::RawFlags::pseudorange) is
        /// set.
        pub pseudorange: f64,
        /// Carrier phase.
        ///
        /// Unit: cycle. Valid if
        /// [`valid_flags.carrier_phase`](crate::gnss_1::RawFlags::carrier_phase) is set.
        pub carrier_phase: f64,
        /// Doppler shift.
        ///
        /// Unit: Hz. Valid if [`valid_flags.doppler`](crate::gnss_1::RawFlags::doppler) is set.
        pub doppler: f32,
        /// Uncertainty of the pseudorange.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.range_uncertainty`](crate::gnss_1::RawFlags::range_uncertainty) is set.
        pub range_uncertainty: f32,
        /// Uncertainty of the carrier phase.
        ///
        /// Unit: cycle. Valid if
        /// [`valid_flags.carrier_phase_uncertainty`](crate::gnss_1::RawFlags::carrier_phase_uncertainty)
        /// is set.
        pub phase_uncertainty: f32,
        /// Uncertainty of the Doppler shift.
        ///
        /// Unit: Hz. Valid if
        /// [`valid_flags.doppler_uncertainty`](crate::gnss_1::RawFlags::doppler_uncertainty) is
        /// set.
        pub doppler_uncertainty: f32,
        /// Lower limit of the time that the carrier phase has been locked.
        ///
        /// Unit: s. Valid if [`valid_flags.lock_time`](crate::gnss_1::RawFlags::lock_time) is set.
        pub lock_time: f32,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::RawFlags,
    }
}

field! {
    Raw: 0x94, 0x22, "gnss_external.raw";
}

record! {
    /// Base station info (0x94,0x30).
    ///
    /// The base station of the corrections, from an RTCM message 1005 or 1006.
    ///
    /// Has the layout of [`gnss_1::BaseStationInfo`](crate::gnss_1::BaseStationInfo). Not listed in
    /// any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct BaseStationInfo {
        /// GPS time of week at which the message was received.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::BaseStationInfoFlags::tow) is set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::BaseStationInfoFlags::week_number) is set.
        pub week_number: u16,
        /// Position of the station.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.ecef_position`](crate::gnss_1::BaseStationInfoFlags::ecef_position) is
        /// set.
        pub ecef_position: types::Vector3d,
        /// Height of the antenna above the marker that was surveyed.
        ///
        /// Unit: m. Valid if [`valid_flags.height`](crate::gnss_1::BaseStationInfoFlags::height) is
        /// set.
        pub height: f32,
        /// Number of the station.
        ///
        /// Range: 0 to 4095. Valid if
        /// [`valid_flags.station_id`](crate::gnss_1::BaseStationInfoFlags::station_id) is set.
        pub station_id: u16,
        /// Properties of the station.
        ///
        /// Valid if [`valid_flags.indicators`](crate::gnss_1::BaseStationInfoFlags::indicators) is
        /// set.
        pub indicators: crate::gnss_1::BaseStationIndicators,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::BaseStationInfoFlags,
    }
}

field! {
    BaseStationInfo: 0x94, 0x30, "gnss_external.base_station_info";
}

record! {
    /// RTK corrections status (0x94,0x31).
    ///
    /// Which corrections are received, and how old they are.
    ///
    /// Has the layout of [`gnss_1::RtkCorrectionsStatus`](crate::gnss_1::RtkCorrectionsStatus). Not
    /// listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct RtkCorrectionsStatus {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::RtkCorrectionsStatusFlags::tow) is
        /// set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::RtkCorrectionsStatusFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// Corrections received during this epoch.
        ///
        /// Valid if
        /// [`valid_flags.epoch_status`](crate::gnss_1::RtkCorrectionsStatusFlags::epoch_status) is
        /// set.
        pub epoch_status: crate::gnss_1::RtkEpochStatus,
        /// Status flags of the RTK dongle; of use only with a dongle.
        ///
        /// Valid if
        /// [`valid_flags.dongle_status`](crate::gnss_1::RtkCorrectionsStatusFlags::dongle_status)
        /// is set.
        ///
        /// - The same word as in the response to
        ///   [`rtk::GetStatusFlags`](crate::rtk::GetStatusFlags), in one of its two forms.
        pub dongle_status: types::RtkStatusFlags,
        /// Latency of the last GPS correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.gps_latency`](crate::gnss_1::RtkCorrectionsStatusFlags::gps_latency) is
        /// set.
        pub gps_correction_latency: f32,
        /// Latency of the last GLONASS correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.glonass_latency`](crate::gnss_1::RtkCorrectionsStatusFlags::glonass_latency)
        /// is set.
        pub glonass_correction_latency: f32,
        /// Latency of the last Galileo correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.galileo_latency`](crate::gnss_1::RtkCorrectionsStatusFlags::galileo_latency)
        /// is set.
        pub galileo_correction_latency: f32,
        /// Latency of the last BeiDou correction.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.beidou_latency`](crate::gnss_1::RtkCorrectionsStatusFlags::beidou_latency)
        /// is set.
        pub beidou_correction_latency: f32,
        /// Reserved.
        pub reserved: [u32; 4],
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::RtkCorrectionsStatusFlags,
    }
}

field! {
    RtkCorrectionsStatus: 0x94, 0x31, "gnss_external.rtk_corrections_status";
}

record! {
    /// GPS ephemeris (0x94,0x61).
    ///
    /// Broadcast orbit and clock of one GPS satellite.
    ///
    /// Has the layout of [`gnss_1::GpsEphemeris`](crate::gnss_1::GpsEphemeris). Not listed in any
    /// device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - `iodc` changes with the clock data; according to the manual, it rolls over at 4.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Default)]
    pub struct GpsEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Health of satellite and signals.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Issue of data, clock.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub iodc: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_gd: f64,
        /// Inter-signal correction for L1.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub isc_l1ca: f64,
        /// Inter-signal correction for L2, or for L5 if `isc_l5` is set.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub a_dot: f64,
        /// Mean anomaly.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion_dot: f64,
        /// Eccentricity.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub eccentricity: f64,
        /// Argument of perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub omega_dot: f64,
        /// Inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub c_rs: f64,
        /// What the ephemeris holds.
        pub valid_flags: crate::gnss_1::EphemerisFlags,
    }
}

field! {
    GpsEphemeris: 0x94, 0x61, "gnss_external.gps_ephemeris";
}

record! {
    /// GLONASS ephemeris (0x94,0x62).
    ///
    /// Broadcast orbit and clock of one GLONASS satellite.
    ///
    /// Has the layout of [`gnss_1::GlonassEphemeris`](crate::gnss_1::GlonassEphemeris). Also called
    /// `glo_ephemeris`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - The interface control document of GLONASS explains p and ft.
    /// - A period of four years has 1461 days; no source says how nt, a u8, counts them.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Default)]
    pub struct GlonassEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// GLONASS frequency number.
        ///
        /// Range: -7 to 24. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub frequency_number: i8,
        /// Start of the frame within the day.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub tk: u32,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub tb: u32,
        /// Generation of the satellite (M).
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub satellite_type: crate::gnss_1::GlonassSatelliteType,
        /// Relative deviation of the carrier frequency from its nominal value.
        ///
        /// Unit: 1. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub gamma: f64,
        /// Correction of the satellite time relative to GLONASS time.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub tau_n: f64,
        /// Position of the satellite in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub position: types::Vector3d,
        /// Velocity of the satellite in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub velocity: types::Vector3f,
        /// Acceleration of the satellite due to perturbations, in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub accel: types::Vector3f,
        /// Health (Bn); not 0 if the satellite fails.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub health: u8,
        /// Mode of operation of the satellite.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub p: u8,
        /// Day within a period of four years.
        ///
        /// Unit: day. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub nt: u8,
        /// Time difference between L1 and L2.
        ///
        /// Unit: s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub delta_tau_n: f32,
        /// Code of the user range accuracy.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub ft: u8,
        /// Age of the information.
        ///
        /// Unit: day. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub en: u8,
        /// Time between adjacent values of tb.
        ///
        /// Unit: min. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub p1: u8,
        /// 1 if tb is odd, 0 if it is even.
        ///
        /// Range: 0 to 1. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub p2: u8,
        /// Number of satellites in the almanac of the frame.
        ///
        /// Unit: 1. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is set.
        pub p3: u8,
        /// Whether ephemeris parameters are present.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub p4: u8,
        /// Whether the ephemeris is valid.
        pub valid_flags: crate::gnss_1::GlonassEphemerisFlags,
    }
}

field! {
    GlonassEphemeris: 0x94, 0x62, "gnss_external.glonass_ephemeris";
}

record! {
    /// Galileo ephemeris (0x94,0x63).
    ///
    /// Broadcast orbit and clock of one Galileo satellite.
    ///
    /// Has the layout of [`gnss_1::GalileoEphemeris`](crate::gnss_1::GalileoEphemeris). Not listed
    /// in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - The layout is that of the GPS ephemeris. No source says what the two inter-signal
    ///   corrections mean here.
    /// - `iodc` changes with the clock data; according to the manual, it rolls over at 4.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Default)]
    pub struct GalileoEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Health of satellite and signals.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Issue of data, clock.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub iodc: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_gd: f64,
        /// Place of the inter-signal correction for L1 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub isc_l1ca: f64,
        /// Place of the inter-signal correction for L2 or L5 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub a_dot: f64,
        /// Mean anomaly.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion_dot: f64,
        /// Eccentricity.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub eccentricity: f64,
        /// Argument of perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub omega_dot: f64,
        /// Inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub c_rs: f64,
        /// What the ephemeris holds.
        pub valid_flags: crate::gnss_1::EphemerisFlags,
    }
}

field! {
    GalileoEphemeris: 0x94, 0x63, "gnss_external.galileo_ephemeris";
}

record! {
    /// BeiDou ephemeris (0x94,0x64).
    ///
    /// Broadcast orbit and clock of one BeiDou satellite.
    ///
    /// Has the layout of [`gnss_1::BeidouEphemeris`](crate::gnss_1::BeidouEphemeris). Not listed in
    /// any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// - The layout is that of the GPS ephemeris. No source says what the two inter-signal
    ///   corrections mean here.
    /// - `iodc` changes with the clock data; according to the manual, it rolls over at 4.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Default)]
    pub struct BeidouEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Health of satellite and signals.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Issue of data, clock.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub iodc: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_gd: f64,
        /// Place of the inter-signal correction for L1 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub isc_l1ca: f64,
        /// Place of the inter-signal correction for L2 or L5 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub a_dot: f64,
        /// Mean anomaly.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion_dot: f64,
        /// Eccentricity.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub eccentricity: f64,
        /// Argument of perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub omega_dot: f64,
        /// Inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if
        /// [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is set.
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris)
        /// is set.
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](crate::gnss_1::EphemerisFlags::ephemeris) is
        /// set.
        pub c_rs: f64,
        /// What the ephemeris holds.
        pub valid_flags: crate::gnss_1::EphemerisFlags,
    }
}

field! {
    BeidouEphemeris: 0x94, 0x64, "gnss_external.beidou_ephemeris";
}

record! {
    /// GPS ionospheric correction (0x94,0x71).
    ///
    /// Model of the ionosphere that GPS broadcasts.
    ///
    /// Has the layout of [`gnss_1::GpsIonoCorrection`](crate::gnss_1::GpsIonoCorrection). Also
    /// called `gps_iono_corr`. Not listed in any device profile. Known only from the MicroStrain
    /// MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Default)]
    pub struct GpsIonoCorrection {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::GpsIonoCorrectionFlags::tow) is
        /// set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::GpsIonoCorrectionFlags::week_number) is set.
        pub week_number: u16,
        /// Coefficients alpha 0 to 3.
        ///
        /// Valid if [`valid_flags.alpha`](crate::gnss_1::GpsIonoCorrectionFlags::alpha) is set.
        /// Uncertain: The units.
        pub alpha: [f64; 4],
        /// Coefficients beta 0 to 3.
        ///
        /// Valid if [`valid_flags.beta`](crate::gnss_1::GpsIonoCorrectionFlags::beta) is set.
        /// Uncertain: The units.
        pub beta: [f64; 4],
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::GpsIonoCorrectionFlags,
    }
}

field! {
    GpsIonoCorrection: 0x94, 0x71, "gnss_external.gps_iono_correction";
}

record! {
    /// Galileo ionospheric correction (0x94,0x73).
    ///
    /// Model of the ionosphere that Galileo broadcasts.
    ///
    /// Has the layout of [`gnss_1::GalileoIonoCorrection`](crate::gnss_1::GalileoIonoCorrection).
    /// Also called `galileo_iono_corr`. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Copy, Default)]
    pub struct GalileoIonoCorrection {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::GalileoIonoCorrectionFlags::tow) is
        /// set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::GalileoIonoCorrectionFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// The three coefficients of the model.
        ///
        /// Valid if [`valid_flags.alpha`](crate::gnss_1::GalileoIonoCorrectionFlags::alpha) is set.
        /// Uncertain: The units.
        pub alpha: [f64; 3],
        /// Ionospheric storms, one bit (1 to 5) for each of five regions.
        ///
        /// Valid if
        /// [`valid_flags.disturbance_flags`](crate::gnss_1::GalileoIonoCorrectionFlags::disturbance_flags)
        /// is set. Uncertain: Whether the bits count from 0 or from 1, and which region each
        /// represents.
        pub disturbance_flags: u8,
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::GalileoIonoCorrectionFlags,
    }
}

field! {
    GalileoIonoCorrection: 0x94, 0x73, "gnss_external.galileo_iono_correction";
}

record! {
    /// BeiDou ionospheric correction (0x94,0x74).
    ///
    /// Model of the ionosphere that BeiDou broadcasts.
    ///
    /// Has the layout of [`gnss_1::BeidouIonoCorrection`](crate::gnss_1::BeidouIonoCorrection).
    /// Also called `beidou_iono_corr`. Not listed in any device profile. Known only from the
    /// MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gnss4 Data (0x94).
    #[derive(Default)]
    pub struct BeidouIonoCorrection {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](crate::gnss_1::BeidouIonoCorrectionFlags::tow) is
        /// set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](crate::gnss_1::BeidouIonoCorrectionFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// Coefficients alpha 0 to 3.
        ///
        /// Valid if [`valid_flags.alpha`](crate::gnss_1::BeidouIonoCorrectionFlags::alpha) is set.
        /// Uncertain: The units.
        pub alpha: [f64; 4],
        /// Coefficients beta 0 to 3.
        ///
        /// Valid if [`valid_flags.beta`](crate::gnss_1::BeidouIonoCorrectionFlags::beta) is set.
        /// Uncertain: The units.
        pub beta: [f64; 4],
        /// Nine further coefficients of the delay.
        ///
        /// Valid if
        /// [`valid_flags.alpha_correction`](crate::gnss_1::BeidouIonoCorrectionFlags::alpha_correction)
        /// is set. Uncertain: The units.
        pub alpha_correction: [f64; 9],
        /// Which values are valid.
        pub valid_flags: crate::gnss_1::BeidouIonoCorrectionFlags,
    }
}

field! {
    BeidouIonoCorrection: 0x94, 0x74, "gnss_external.beidou_iono_correction";
}
