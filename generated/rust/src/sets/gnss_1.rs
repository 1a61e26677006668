//! GNSS receiver 1 data (0x91): Measurements and status of the first internal GNSS receiver.
//!
//! Source: 3dm-cv7-gnss-ins: GNSS Recv 1 (0x91).

#[allow(unused_imports)] // some sets name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: u8 = 0x91;

bitfield! {
    /// Which parts of the position are valid.
    GnssLlhPositionFlags: u16 {
        /// Latitude and longitude. Bit 0.
        LAT_LON: bool = 0,
            lat_lon, set_lat_lon, with_lat_lon;
        /// Height above the ellipsoid. Bit 1.
        ELLIPSOID_HEIGHT: bool = 1,
            ellipsoid_height, set_ellipsoid_height, with_ellipsoid_height;
        /// Height above mean sea level. Bit 2.
        MSL_HEIGHT: bool = 2,
            msl_height, set_msl_height, with_msl_height;
        /// Horizontal accuracy. Bit 3.
        HORIZONTAL_ACCURACY: bool = 3,
            horizontal_accuracy, set_horizontal_accuracy, with_horizontal_accuracy;
        /// Vertical accuracy. Bit 4.
        VERTICAL_ACCURACY: bool = 4,
            vertical_accuracy, set_vertical_accuracy, with_vertical_accuracy;
        /// All of them. Bits 0 to 4. Overlaps other bits.
        FLAGS: u8 = 0..=4,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which parts of the position are valid.
    GnssEcefPositionFlags: u16 {
        /// Position. Bit 0.
        POSITION: bool = 0,
            position, set_position, with_position;
        /// Accuracy of the position. Bit 1.
        POSITION_ACCURACY: bool = 1,
            position_accuracy, set_position_accuracy, with_position_accuracy;
        /// All of them. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which parts of the velocity are valid.
    NedVelocityFlags: u16 {
        /// Velocity vector. Bit 0.
        VELOCITY: bool = 0,
            velocity, set_velocity, with_velocity;
        /// Speed in space. Bit 1.
        SPEED_3D: bool = 1,
            speed_3d, set_speed_3d, with_speed_3d;
        /// Speed over ground. Bit 2.
        GROUND_SPEED: bool = 2,
            ground_speed, set_ground_speed, with_ground_speed;
        /// Heading. Bit 3.
        HEADING: bool = 3,
            heading, set_heading, with_heading;
        /// Accuracy of the speed. Bit 4.
        SPEED_ACCURACY: bool = 4,
            speed_accuracy, set_speed_accuracy, with_speed_accuracy;
        /// Accuracy of the heading. Bit 5.
        HEADING_ACCURACY: bool = 5,
            heading_accuracy, set_heading_accuracy, with_heading_accuracy;
        /// All of them. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which parts of the velocity are valid.
    GnssEcefVelocityFlags: u16 {
        /// Velocity. Bit 0.
        VELOCITY: bool = 0,
            velocity, set_velocity, with_velocity;
        /// Accuracy of the velocity. Bit 1.
        VELOCITY_ACCURACY: bool = 1,
            velocity_accuracy, set_velocity_accuracy, with_velocity_accuracy;
        /// All of them. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which dilutions of precision are valid.
    DopFlags: u16 {
        /// Geometric. Bit 0.
        GDOP: bool = 0,
            gdop, set_gdop, with_gdop;
        /// Position. Bit 1.
        PDOP: bool = 1,
            pdop, set_pdop, with_pdop;
        /// Horizontal. Bit 2.
        HDOP: bool = 2,
            hdop, set_hdop, with_hdop;
        /// Vertical. Bit 3.
        VDOP: bool = 3,
            vdop, set_vdop, with_vdop;
        /// Time. Bit 4.
        TDOP: bool = 4,
            tdop, set_tdop, with_tdop;
        /// Northing. Bit 5.
        NDOP: bool = 5,
            ndop, set_ndop, with_ndop;
        /// Easting. Bit 6.
        EDOP: bool = 6,
            edop, set_edop, with_edop;
        /// All of them. Bits 0 to 6. Overlaps other bits.
        FLAGS: u8 = 0..=6,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// How far the UTC time is valid.
    UtcTimeFlags: u16 {
        /// Date and time come from GNSS. Bit 0.
        GNSS_DATE_TIME: bool = 0,
            gnss_date_time, set_gnss_date_time, with_gnss_date_time;
        /// The leap seconds between GPS time and UTC are known. Bit 1.
        LEAP_SECONDS_KNOWN: bool = 1,
            leap_seconds_known, set_leap_seconds_known, with_leap_seconds_known;
        /// All of them. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which parts of the time are valid.
    GpsTimeFlags: u16 {
        /// Time of week. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// Week number. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// All of them. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// What the fix makes use of.
    FixFlags: u16 {
        /// Satellite based augmentation. Bit 0.
        SBAS_USED: bool = 0,
            sbas_used, set_sbas_used, with_sbas_used;
        /// Differential corrections. Bit 1.
        DGNSS_USED: bool = 1,
            dgnss_used, set_dgnss_used, with_dgnss_used;
    }
}

bitfield! {
    /// Which parts of the fix information are valid.
    FixInfoFlags: u16 {
        /// Type of the fix. Bit 0.
        FIX_TYPE: bool = 0,
            fix_type, set_fix_type, with_fix_type;
        /// Number of satellites. Bit 1.
        NUM_SV: bool = 1,
            num_sv, set_num_sv, with_num_sv;
        /// Fix flags. Bit 2.
        FIX_FLAGS: bool = 2,
            fix_flags, set_fix_flags, with_fix_flags;
        /// All of them. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Whether the receiver works.
    ReceiverState: u8 {
        /// Off.
        OFF = 0, "off";
        /// On.
        ON = 1, "on";
        /// Not known.
        UNKNOWN = 2, "unknown";
    }
}

open_enum! {
    /// State of the antenna.
    AntennaState: u8 {
        /// Being initialized.
        INIT = 1, "init";
        /// Short circuit.
        SHORT = 2, "short";
        /// Open circuit, no antenna.
        OPEN = 3, "open";
        /// Good.
        GOOD = 4, "good";
        /// Not known.
        UNKNOWN = 5, "unknown";
    }
}

open_enum! {
    /// Supply of the antenna.
    AntennaPower: u8 {
        /// Off.
        OFF = 0, "off";
        /// On.
        ON = 1, "on";
        /// Not known.
        UNKNOWN = 2, "unknown";
    }
}

bitfield! {
    /// Which parts of the hardware status are valid.
    GnssHardwareStatusFlags: u16 {
        /// State of the receiver. Bit 0.
        SENSOR_STATE: bool = 0,
            sensor_state, set_sensor_state, with_sensor_state;
        /// State of the antenna. Bit 1.
        ANTENNA_STATE: bool = 1,
            antenna_state, set_antenna_state, with_antenna_state;
        /// Supply of the antenna. Bit 2.
        ANTENNA_POWER: bool = 2,
            antenna_power, set_antenna_power, with_antenna_power;
        /// All of them. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which clock parameters are valid.
    ClockInfo2Flags: u16 {
        /// Bias. Bit 0.
        BIAS: bool = 0,
            bias, set_bias, with_bias;
        /// Drift. Bit 1.
        DRIFT: bool = 1,
            drift, set_drift, with_drift;
        /// Accuracy of the bias. Bit 2.
        BIAS_ACCURACY: bool = 2,
            bias_accuracy, set_bias_accuracy, with_bias_accuracy;
        /// Accuracy of the drift. Bit 3.
        DRIFT_ACCURACY: bool = 3,
            drift_accuracy, set_drift_accuracy, with_drift_accuracy;
        /// All of them. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Whether the leap seconds are valid. Bit 0 is not used.
    GpsLeapSecondsFlags: u16 {
        /// Leap seconds. Bit 1.
        LEAP_SECONDS: bool = 1,
            leap_seconds, set_leap_seconds, with_leap_seconds;
    }
}

open_enum! {
    /// Satellite based augmentation system.
    SbasSystem: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// North America.
        WAAS = 1, "waas";
        /// Europe.
        EGNOS = 2, "egnos";
        /// Japan.
        MSAS = 3, "msas";
        /// India.
        GAGAN = 4, "gagan";
    }
}

bitfield! {
    /// What the SBAS service offers.
    SbasStatus: u8 {
        /// Ranging is available. Bit 0.
        RANGE_AVAILABLE: bool = 0,
            range_available, set_range_available, with_range_available;
        /// Corrections are available. Bit 1.
        CORRECTIONS_AVAILABLE: bool = 1,
            corrections_available, set_corrections_available, with_corrections_available;
        /// Integrity information is available. Bit 2.
        INTEGRITY_AVAILABLE: bool = 2,
            integrity_available, set_integrity_available, with_integrity_available;
        /// The service is in test mode. Bit 3.
        TEST_MODE: bool = 3,
            test_mode, set_test_mode, with_test_mode;
    }
}

bitfield! {
    /// Which parts of the SBAS status are valid.
    SbasInfoFlags: u16 {
        /// Time of week. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// Week number. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// System. Bit 2.
        SBAS_SYSTEM: bool = 2,
            sbas_system, set_sbas_system, with_sbas_system;
        /// Satellite. Bit 3.
        SBAS_ID: bool = 3,
            sbas_id, set_sbas_id, with_sbas_id;
        /// Number of corrections. Bit 4.
        COUNT: bool = 4,
            count, set_count, with_count;
        /// Status of the service. Bit 5.
        SBAS_STATUS: bool = 5,
            sbas_status, set_sbas_status, with_sbas_status;
        /// All of them. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Which parts of the satellite status are valid.
    SatelliteStatusFlags: u16 {
        /// Time of week. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// Week number. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// Constellation. Bit 2.
        GNSS_ID: bool = 2,
            gnss_id, set_gnss_id, with_gnss_id;
        /// Satellite. Bit 3.
        SATELLITE_ID: bool = 3,
            satellite_id, set_satellite_id, with_satellite_id;
        /// Elevation. Bit 4.
        ELEVATION: bool = 4,
            elevation, set_elevation, with_elevation;
        /// Azimuth. Bit 5.
        AZIMUTH: bool = 5,
            azimuth, set_azimuth, with_azimuth;
        /// Health. Bit 6.
        HEALTH: bool = 6,
            health, set_health, with_health;
        /// All of them. Bits 0 to 6. Overlaps other bits.
        FLAGS: u8 = 0..=6,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// How well a signal is tracked.
    SignalQuality: u8 {
        /// No signal.
        NONE = 0, "none";
        /// The signal is searched.
        SEARCHING = 1, "searching";
        /// The signal is acquired.
        ACQUIRED = 2, "acquired";
        /// The signal is found but cannot be used.
        UNUSABLE = 3, "unusable";
        /// Locked in time.
        TIME_LOCKED = 4, "time_locked";
        /// Fully locked.
        FULLY_LOCKED = 5, "fully_locked";
    }
}

bitfield! {
    /// Which parts of the observation are valid.
    RawFlags: u16 {
        /// Time of week. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// Week number. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// Receiver or reference station. Bit 2.
        RECEIVER_ID: bool = 2,
            receiver_id, set_receiver_id, with_receiver_id;
        /// Tracking channel. Bit 3.
        TRACKING_CHANNEL: bool = 3,
            tracking_channel, set_tracking_channel, with_tracking_channel;
        /// Constellation. Bit 4.
        GNSS_ID: bool = 4,
            gnss_id, set_gnss_id, with_gnss_id;
        /// Satellite. Bit 5.
        SATELLITE_ID: bool = 5,
            satellite_id, set_satellite_id, with_satellite_id;
        /// Signal. Bit 6.
        SIGNAL_ID: bool = 6,
            signal_id, set_signal_id, with_signal_id;
        /// Signal strength. Bit 7.
        SIGNAL_STRENGTH: bool = 7,
            signal_strength, set_signal_strength, with_signal_strength;
        /// Signal quality. Bit 8.
        QUALITY: bool = 8,
            quality, set_quality, with_quality;
        /// Pseudorange. Bit 9.
        PSEUDORANGE: bool = 9,
            pseudorange, set_pseudorange, with_pseudorange;
        /// Carrier phase. Bit 10.
        CARRIER_PHASE: bool = 10,
            carrier_phase, set_carrier_phase, with_carrier_phase;
        /// Doppler shift. Bit 11.
        DOPPLER: bool = 11,
            doppler, set_doppler, with_doppler;
        /// Uncertainty of the pseudorange. Bit 12.
        RANGE_UNCERTAINTY: bool = 12,
            range_uncertainty, set_range_uncertainty, with_range_uncertainty;
        /// Uncertainty of the carrier phase. Bit 13.
        CARRIER_PHASE_UNCERTAINTY: bool = 13,
            carrier_phase_uncertainty, set_carrier_phase_uncertainty, with_carrier_phase_uncertainty;
        /// Uncertainty of the Doppler shift. Bit 14.
        DOPPLER_UNCERTAINTY: bool = 14,
            doppler_uncertainty, set_doppler_uncertainty, with_doppler_uncertainty;
        /// Lock time. Bit 15.
        LOCK_TIME: bool = 15,
            lock_time, set_lock_time, with_lock_time;
        /// All of them. Bits 0 to 15. Overlaps other bits.
        FLAGS: u16 = 0..=15,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// What an ephemeris of GPS, Galileo or BeiDou holds.
    EphemerisFlags: u16 {
        /// The ephemeris is valid. Bit 0.
        EPHEMERIS: bool = 0,
            ephemeris, set_ephemeris, with_ephemeris;
        /// The data of the modernized navigation message are included. Bit 1.
        MODERN_DATA: bool = 1,
            modern_data, set_modern_data, with_modern_data;
        /// isc_l2c is the correction for L5, not for L2. Bit 2.
        ISC_L5: bool = 2,
            isc_l5, set_isc_l5, with_isc_l5;
        /// All of them. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Generation of a GLONASS satellite.
    GlonassSatelliteType: u8 {
        /// GLONASS.
        GLONASS = 0, "glonass";
        /// GLONASS-M.
        GLONASS_M = 1, "glonass_m";
    }
}

bitfield! {
    /// Whether the ephemeris is valid.
    GlonassEphemerisFlags: u16 {
        /// The ephemeris is valid. Bit 0.
        EPHEMERIS: bool = 0,
            ephemeris, set_ephemeris, with_ephemeris;
        /// All of them. Bit 0. Overlaps other bits.
        FLAGS: bool = 0,
            flags, set_flags, with_flags;
    }
}

record! {
    /// GNSS LLH position (0x91,0x03).
    ///
    /// GNSS position as latitude, longitude and height.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS LLH Position (0x91,0x03).
    #[derive(Default)]
    pub struct GnssLlhPosition {
        /// Latitude.
        ///
        /// Unit: deg. Frame: llh. Valid if [`valid_flags.lat_lon`](GnssLlhPositionFlags::lat_lon)
        /// is set.
        pub latitude: f64,
        /// Longitude.
        ///
        /// Unit: deg. Frame: llh. Valid if [`valid_flags.lat_lon`](GnssLlhPositionFlags::lat_lon)
        /// is set.
        pub longitude: f64,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh. Valid if
        /// [`valid_flags.ellipsoid_height`](GnssLlhPositionFlags::ellipsoid_height) is set.
        pub ellipsoid_height: f64,
        /// Height above mean sea level.
        ///
        /// Unit: m. Valid if [`valid_flags.msl_height`](GnssLlhPositionFlags::msl_height) is set.
        pub msl_height: f64,
        /// Horizontal accuracy.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.horizontal_accuracy`](GnssLlhPositionFlags::horizontal_accuracy) is set.
        pub horizontal_accuracy: f32,
        /// Vertical accuracy.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.vertical_accuracy`](GnssLlhPositionFlags::vertical_accuracy) is set.
        pub vertical_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: GnssLlhPositionFlags,
    }
}

field! {
    GnssLlhPosition: 0x91, 0x03, "gnss_1.gnss_llh_position";
    in [0x91 | 0x92 | 0x94];
}

record! {
    /// GNSS ECEF position (0x91,0x04).
    ///
    /// GNSS position in Earth-fixed coordinates.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS ECEF Position (0x91,0x04).
    #[derive(Default)]
    pub struct GnssEcefPosition {
        /// Position.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.position`](GnssEcefPositionFlags::position) is set.
        pub x: types::Vector3d,
        /// Accuracy of the position.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.position_accuracy`](GnssEcefPositionFlags::position_accuracy) is set.
        pub x_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: GnssEcefPositionFlags,
    }
}

field! {
    GnssEcefPosition: 0x91, 0x04, "gnss_1.gnss_ecef_position";
    in [0x91 | 0x92];
}

record! {
    /// NED velocity (0x91,0x05).
    ///
    /// GNSS velocity in the local level frame.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: NED Velocity (0x91,0x05).
    #[derive(Default)]
    pub struct NedVelocity {
        /// Velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ned. Valid if
        /// [`valid_flags.velocity`](NedVelocityFlags::velocity) is set.
        pub v: types::Vector3f,
        /// Speed in space.
        ///
        /// Unit: m/s. Valid if [`valid_flags.speed_3d`](NedVelocityFlags::speed_3d) is set.
        pub speed: f32,
        /// Speed over ground.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ground_speed`](NedVelocityFlags::ground_speed) is set.
        pub ground_speed: f32,
        /// Direction of the motion over ground.
        ///
        /// Unit: deg. Frame: ned. Valid if [`valid_flags.heading`](NedVelocityFlags::heading) is
        /// set.
        pub heading: f32,
        /// Accuracy of the speed.
        ///
        /// Unit: m/s. Valid if [`valid_flags.speed_accuracy`](NedVelocityFlags::speed_accuracy) is
        /// set.
        pub speed_accuracy: f32,
        /// Accuracy of the heading.
        ///
        /// Unit: deg. Valid if [`valid_flags.heading_accuracy`](NedVelocityFlags::heading_accuracy)
        /// is set.
        pub heading_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: NedVelocityFlags,
    }
}

field! {
    NedVelocity: 0x91, 0x05, "gnss_1.ned_velocity";
    in [0x91 | 0x92 | 0x94];
}

record! {
    /// GNSS ECEF velocity (0x91,0x06).
    ///
    /// GNSS velocity in Earth-fixed coordinates.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x91,0x06).
    #[derive(Default)]
    pub struct GnssEcefVelocity {
        /// Velocity.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. Valid if
        /// [`valid_flags.velocity`](GnssEcefVelocityFlags::velocity) is set.
        pub v: types::Vector3f,
        /// Accuracy of the velocity.
        ///
        /// Unit: m/s. Valid if
        /// [`valid_flags.velocity_accuracy`](GnssEcefVelocityFlags::velocity_accuracy) is set.
        pub v_accuracy: f32,
        /// Which values are valid.
        pub valid_flags: GnssEcefVelocityFlags,
    }
}

field! {
    GnssEcefVelocity: 0x91, 0x06, "gnss_1.gnss_ecef_velocity";
    in [0x91 | 0x92];
}

record! {
    /// DOP (0x91,0x07).
    ///
    /// Dilution of precision of the satellite geometry.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: DOP (0x91,0x07).
    #[derive(Default)]
    pub struct Dop {
        /// Geometric dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.gdop`](DopFlags::gdop) is set.
        pub gdop: f32,
        /// Position dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.pdop`](DopFlags::pdop) is set.
        pub pdop: f32,
        /// Horizontal dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.hdop`](DopFlags::hdop) is set.
        pub hdop: f32,
        /// Vertical dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.vdop`](DopFlags::vdop) is set.
        pub vdop: f32,
        /// Time dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.tdop`](DopFlags::tdop) is set.
        pub tdop: f32,
        /// Northing dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.ndop`](DopFlags::ndop) is set.
        pub ndop: f32,
        /// Easting dilution.
        ///
        /// Unit: 1. Valid if [`valid_flags.edop`](DopFlags::edop) is set.
        pub edop: f32,
        /// Which values are valid.
        pub valid_flags: DopFlags,
    }
}

field! {
    Dop: 0x91, 0x07, "gnss_1.dop";
    in [0x91 | 0x92];
}

record! {
    /// UTC time (0x91,0x08).
    ///
    /// Coordinated universal time as the receiver knows it.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: UTC Time (0x91,0x08).
    #[derive(Default)]
    pub struct UtcTime {
        /// Year.
        ///
        /// Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is set.
        pub year: u16,
        /// Month.
        ///
        /// Range: 1 to 12. Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is
        /// set.
        pub month: u8,
        /// Day of the month.
        ///
        /// Range: 1 to 31. Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is
        /// set.
        pub day: u8,
        /// Hour.
        ///
        /// Range: 0 to 23. Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is
        /// set.
        pub hour: u8,
        /// Minute.
        ///
        /// Range: 0 to 59. Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is
        /// set.
        pub min: u8,
        /// Second.
        ///
        /// Unit: s. Range: 0 to 59. Valid if
        /// [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is set.
        pub sec: u8,
        /// Fraction of the second.
        ///
        /// Unit: ms. Range: 0 to 999. Valid if
        /// [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is set.
        pub msec: u32,
        /// How far the time is valid.
        pub valid_flags: UtcTimeFlags,
    }
}

field! {
    UtcTime: 0x91, 0x08, "gnss_1.utc_time";
    in [0x91 | 0x92 | 0x94];
}

record! {
    /// GPS time (0x91,0x09).
    ///
    /// GPS time as the receiver knows it.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Time (0x91,0x09).
    #[derive(Default)]
    pub struct GpsTime {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](GpsTimeFlags::tow) is set.
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](GpsTimeFlags::week_number) is set.
        pub week_number: u16,
        /// Which values are valid.
        pub valid_flags: GpsTimeFlags,
    }
}

field! {
    GpsTime: 0x91, 0x09, "gnss_1.gps_time";
    in [0x91 | 0x92];
}

record! {
    /// Fix info (0x91,0x0B).
    ///
    /// Type of the position fix and what it is made of.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B).
    #[derive(Default)]
    pub struct FixInfo {
        /// Type of the fix.
        ///
        /// Valid if [`valid_flags.fix_type`](FixInfoFlags::fix_type) is set.
        pub fix_type: types::GnssFixType,
        /// Number of satellites of the fix.
        ///
        /// Unit: 1. Valid if [`valid_flags.num_sv`](FixInfoFlags::num_sv) is set.
        pub num_sv: u8,
        /// Aids of the fix.
        ///
        /// Valid if [`valid_flags.fix_flags`](FixInfoFlags::fix_flags) is set.
        pub fix_flags: FixFlags,
        /// Which values are valid.
        pub valid_flags: FixInfoFlags,
    }
}

field! {
    FixInfo: 0x91, 0x0B, "gnss_1.fix_info";
    in [0x91 | 0x92 | 0x94];
}

record! {
    /// GNSS hardware status (0x91,0x0D).
    ///
    /// State of the receiver and of its antenna.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Hardware Status (0x91,0x0D).
    #[derive(Default)]
    pub struct GnssHardwareStatus {
        /// State of the receiver.
        ///
        /// Valid if [`valid_flags.sensor_state`](GnssHardwareStatusFlags::sensor_state) is set.
        pub receiver_state: ReceiverState,
        /// State of the antenna.
        ///
        /// Valid if [`valid_flags.antenna_state`](GnssHardwareStatusFlags::antenna_state) is set.
        pub antenna_state: AntennaState,
        /// Supply of the antenna.
        ///
        /// Valid if [`valid_flags.antenna_power`](GnssHardwareStatusFlags::antenna_power) is set.
        pub antenna_power: AntennaPower,
        /// Which values are valid.
        pub valid_flags: GnssHardwareStatusFlags,
    }
}

field! {
    GnssHardwareStatus: 0x91, 0x0D, "gnss_1.gnss_hardware_status";
    in [0x91 | 0x92];
}

record! {
    /// Clock info 2 (0x91,0x10).
    ///
    /// Bias and drift of the receiver clock.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - It supersedes an older field, which the manual does not define.
    ///
    /// Source: 3dm-cv7-gnss-ins: Clock Info 2 (0x91,0x10).
    #[derive(Default)]
    pub struct ClockInfo2 {
        /// Bias of the clock.
        ///
        /// Unit: s. Valid if [`valid_flags.bias`](ClockInfo2Flags::bias) is set.
        pub bias: f64,
        /// Drift of the clock.
        ///
        /// Unit: s/s. Valid if [`valid_flags.drift`](ClockInfo2Flags::drift) is set.
        pub drift: f64,
        /// Accuracy of the bias.
        ///
        /// Unit: s. Valid if [`valid_flags.bias_accuracy`](ClockInfo2Flags::bias_accuracy) is set.
        pub bias_accuracy_estimate: f64,
        /// Accuracy of the drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.drift_accuracy`](ClockInfo2Flags::drift_accuracy) is
        /// set.
        pub drift_accuracy_estimate: f64,
        /// Which values are valid.
        pub valid_flags: ClockInfo2Flags,
    }
}

field! {
    ClockInfo2: 0x91, 0x10, "gnss_1.clock_info_2";
    in [0x91 | 0x92];
}

record! {
    /// GPS leap seconds (0x91,0x11).
    ///
    /// Difference between GPS time and UTC.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Leap Seconds (0x91,0x11).
    #[derive(Default)]
    pub struct GpsLeapSeconds {
        /// GPS time minus UTC.
        ///
        /// Unit: s. Valid if [`valid_flags.leap_seconds`](GpsLeapSecondsFlags::leap_seconds) is
        /// set.
        pub leap_seconds: u8,
        /// Whether the value is valid.
        pub valid_flags: GpsLeapSecondsFlags,
    }
}

field! {
    GpsLeapSeconds: 0x91, 0x11, "gnss_1.gps_leap_seconds";
    in [0x91 | 0x92];
}

record! {
    /// SBAS info (0x91,0x12).
    ///
    /// Status of the satellite based augmentation.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// Source: 3dm-cv7-gnss-ins: SBAS Info (0x91,0x12).
    #[derive(Default)]
    pub struct SbasInfo {
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](SbasInfoFlags::tow) is set.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](SbasInfoFlags::week_number) is set.
        pub week_number: u16,
        /// System in use.
        ///
        /// Valid if [`valid_flags.sbas_system`](SbasInfoFlags::sbas_system) is set.
        pub sbas_system: SbasSystem,
        /// SBAS satellite.
        ///
        /// Valid if [`valid_flags.sbas_id`](SbasInfoFlags::sbas_id) is set.
        pub sbas_id: u8,
        /// Number of SBAS corrections.
        ///
        /// Unit: 1. Valid if [`valid_flags.count`](SbasInfoFlags::count) is set.
        pub count: u8,
        /// Status of the service.
        ///
        /// Valid if [`valid_flags.sbas_status`](SbasInfoFlags::sbas_status) is set.
        pub sbas_status: SbasStatus,
        /// Which values are valid.
        pub valid_flags: SbasInfoFlags,
    }
}

field! {
    SbasInfo: 0x91, 0x12, "gnss_1.sbas_info";
    in [0x91 | 0x92];
}

record! {
    /// Satellite status (0x91,0x20).
    ///
    /// Where one satellite stands, and its health.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - An epoch is sent as one field for each satellite; index and count number the fields.
    ///
    /// Source: 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20).
    #[derive(Default)]
    pub struct SatelliteStatus {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](SatelliteStatusFlags::tow) is set.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](SatelliteStatusFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// Constellation.
        ///
        /// Valid if [`valid_flags.gnss_id`](SatelliteStatusFlags::gnss_id) is set.
        pub gnss_id: types::GnssConstellation,
        /// Satellite within the constellation.
        ///
        /// Valid if [`valid_flags.satellite_id`](SatelliteStatusFlags::satellite_id) is set.
        pub satellite_id: u8,
        /// Elevation, as seen from the rover.
        ///
        /// Unit: deg. Valid if [`valid_flags.elevation`](SatelliteStatusFlags::elevation) is set.
        pub elevation: f32,
        /// Azimuth, as seen from the rover.
        ///
        /// Unit: deg. Valid if [`valid_flags.azimuth`](SatelliteStatusFlags::azimuth) is set.
        pub azimuth: f32,
        /// Whether the satellite is healthy.
        ///
        /// Valid if [`valid_flags.health`](SatelliteStatusFlags::health) is set.
        pub health: crate::Bool,
        /// Which values are valid.
        pub valid_flags: SatelliteStatusFlags,
    }
}

field! {
    SatelliteStatus: 0x91, 0x20, "gnss_1.satellite_status";
    in [0x91 | 0x92 | 0x94];
}

record! {
    /// Raw (0x91,0x22).
    ///
    /// Raw observation of one signal of one satellite.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - An epoch is sent as one field for each signal; index and count number the fields.
    /// - The greatest lock time depends on the receiver.
    ///
    /// Source: 3dm-cv7-gnss-ins: Raw (0x91,0x22).
    #[derive(Default)]
    pub struct Raw {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.tow`](RawFlags::tow) is set.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](RawFlags::week_number) is set.
        pub week_number: u16,
        /// Receiver, counted from 1; for a measurement from RTCM, the reference station.
        ///
        /// Valid if [`valid_flags.receiver_id`](RawFlags::receiver_id) is set.
        pub receiver_id: u16,
        /// Channel that tracks the satellite.
        ///
        /// Valid if [`valid_flags.tracking_channel`](RawFlags::tracking_channel) is set.
        pub tracking_channel: u8,
        /// Constellation.
        ///
        /// Valid if [`valid_flags.gnss_id`](RawFlags::gnss_id) is set.
        pub gnss_id: types::GnssConstellation,
        /// Satellite within the constellation.
        ///
        /// Valid if [`valid_flags.satellite_id`](RawFlags::satellite_id) is set.
        pub satellite_id: u8,
        /// Signal.
        ///
        /// Valid if [`valid_flags.signal_id`](RawFlags::signal_id) is set.
        pub signal_id: types::GnssSignal,
        /// Carrier to noise density ratio.
        ///
        /// Unit: dB-Hz. Valid if [`valid_flags.signal_strength`](RawFlags::signal_strength) is set.
        pub signal_strength: f32,
        /// How well the signal is tracked.
        ///
        /// Valid if [`valid_flags.quality`](RawFlags::quality) is set.
        pub quality: SignalQuality,
        /// Pseudorange.
        ///
        /// Unit: m. Valid if [`valid_flags.pseudorange`](RawFlags::pseudorange) is set.
        pub pseudorange: f64,
        /// Carrier phase.
        ///
        /// Unit: cycle. Valid if [`valid_flags.carrier_phase`](RawFlags::carrier_phase) is set.
        pub carrier_phase: f64,
        /// Doppler shift.
        ///
        /// Unit: Hz. Valid if [`valid_flags.doppler`](RawFlags::doppler) is set.
        pub doppler: f32,
        /// Uncertainty of the pseudorange.
        ///
        /// Unit: m. Valid if [`valid_flags.range_uncertainty`](RawFlags::range_uncertainty) is set.
        pub range_uncert: f32,
        /// Uncertainty of the carrier phase.
        ///
        /// Unit: cycle. Valid if
        /// [`valid_flags.carrier_phase_uncertainty`](RawFlags::carrier_phase_uncertainty) is set.
        pub phase_uncert: f32,
        /// Uncertainty of the Doppler shift.
        ///
        /// Unit: Hz. Valid if [`valid_flags.doppler_uncertainty`](RawFlags::doppler_uncertainty) is
        /// set.
        pub doppler_uncert: f32,
        /// Lower limit of the time that the carrier phase has been locked.
        ///
        /// Unit: s. Valid if [`valid_flags.lock_time`](RawFlags::lock_time) is set.
        pub lock_time: f32,
        /// Which values are valid.
        pub valid_flags: RawFlags,
    }
}

field! {
    Raw: 0x91, 0x22, "gnss_1.raw";
    in [0x91 | 0x92];
}

record! {
    /// GPS ephemeris (0x91,0x61).
    ///
    /// Broadcast orbit and clock of one GPS satellite.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - Iodec changes with the clock data; the manual has it roll over at 4.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Ephemeris (0x91,0x61).
    #[derive(Default)]
    pub struct GpsEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Health of satellite and signals.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Issue of data, clock.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iodec: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_gd: f64,
        /// Inter-signal correction for L1.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub isc_l1ca: f64,
        /// Inter-signal correction for L2, or for L5 if isc_l5 is set.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub a_dot: f64,
        /// Mean anomaly.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion_dot: f64,
        /// Eccentricity.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub eccentricity: f64,
        /// Argument of perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub omega_dot: f64,
        /// Inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_rs: f64,
        /// What the ephemeris holds.
        pub valid_flags: EphemerisFlags,
    }
}

field! {
    GpsEphemeris: 0x91, 0x61, "gnss_1.gps_ephemeris";
    in [0x91 | 0x92];
}

record! {
    /// GLONASS ephemeris (0x91,0x62).
    ///
    /// Broadcast orbit and clock of one GLONASS satellite.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - The interface control document of GLONASS explains p and ft.
    /// - A period of four years has 1461 days; the manual does not say how nt, a u8, counts them.
    ///
    /// Source: 3dm-cv7-gnss-ins: Glonass Ephemeris (0x91,0x62).
    #[derive(Default)]
    pub struct GlonassEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// GLONASS frequency number.
        ///
        /// Range: -7 to 24. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub freq_number: i8,
        /// Start of the frame within the day.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub tk: u32,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub tb: u32,
        /// Generation of the satellite (M).
        ///
        /// Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub sat_type: GlonassSatelliteType,
        /// Relative deviation of the carrier frequency from its nominal value.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub gamma: f64,
        /// Correction of the satellite time relative to GLONASS time.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub tau_n: f64,
        /// Position of the satellite in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m. Valid if
        /// [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub x: types::Vector3d,
        /// Velocity of the satellite in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m/s. Valid if
        /// [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub v: types::Vector3f,
        /// Acceleration of the satellite by perturbations, in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Valid if
        /// [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub a: types::Vector3f,
        /// Health (Bn); not 0 if the satellite fails.
        ///
        /// Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Mode of operation of the satellite.
        ///
        /// Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub p: u8,
        /// Day within a period of four years.
        ///
        /// Unit: day. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub nt: u8,
        /// Time difference between L1 and L2.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub delta_tau_n: f32,
        /// Code of the user range accuracy.
        ///
        /// Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub ft: u8,
        /// Age of the information.
        ///
        /// Unit: day. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub en: u8,
        /// Time between adjacent values of tb.
        ///
        /// Unit: min. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub p1: u8,
        /// 1 if tb is odd, 0 if it is even.
        ///
        /// Range: 0 to 1. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is
        /// set.
        pub p2: u8,
        /// Number of satellites in the almanac of the frame.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub p3: u8,
        /// Whether ephemeris parameters are present.
        ///
        /// Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub p4: u8,
        /// Whether the ephemeris is valid.
        pub valid_flags: GlonassEphemerisFlags,
    }
}

field! {
    GlonassEphemeris: 0x91, 0x62, "gnss_1.glonass_ephemeris";
    in [0x91 | 0x92];
}

record! {
    /// Galileo ephemeris (0x91,0x63).
    ///
    /// Broadcast orbit and clock of one Galileo satellite.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
    ///   corrections hold here.
    /// - Iodec changes with the clock data; the manual has it roll over at 4.
    ///
    /// Source: 3dm-cv7-gnss-ins: Galileo Ephemeris (0x91,0x63).
    #[derive(Default)]
    pub struct GalileoEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Health of satellite and signals.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Issue of data, clock.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iodec: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_gd: f64,
        /// Place of the inter-signal correction for L1 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub isc_l1ca: f64,
        /// Place of the inter-signal correction for L2 or L5 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub a_dot: f64,
        /// Mean anomaly.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion_dot: f64,
        /// Eccentricity.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub eccentricity: f64,
        /// Argument of perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub omega_dot: f64,
        /// Inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_rs: f64,
        /// What the ephemeris holds.
        pub valid_flags: EphemerisFlags,
    }
}

field! {
    GalileoEphemeris: 0x91, 0x63, "gnss_1.galileo_ephemeris";
    in [0x91 | 0x92];
}

record! {
    /// BeiDou ephemeris (0x91,0x64).
    ///
    /// Broadcast orbit and clock of one BeiDou satellite.
    ///
    /// Supported by 3DM-CV7-GNSS/INS.
    ///
    /// - The layout is that of the GPS ephemeris. The manual does not say what the two inter-signal
    ///   corrections hold here.
    /// - Iodec changes with the clock data; the manual has it roll over at 4.
    ///
    /// Source: 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x91,0x64).
    #[derive(Default)]
    pub struct BeidouEphemeris {
        /// Number of this field within the epoch.
        pub index: u8,
        /// How many of these fields the epoch has.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s.
        pub time_of_week: f64,
        /// GPS week number.
        ///
        /// Unit: week.
        pub week_number: u16,
        /// Satellite within the constellation.
        pub satellite_id: u8,
        /// Health of satellite and signals.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub health: u8,
        /// Issue of data, clock.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iodec: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_gd: f64,
        /// Place of the inter-signal correction for L1 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub isc_l1ca: f64,
        /// Place of the inter-signal correction for L2 or L5 of GPS.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub a_dot: f64,
        /// Mean anomaly.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub delta_mean_motion_dot: f64,
        /// Eccentricity.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub eccentricity: f64,
        /// Argument of perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub omega_dot: f64,
        /// Inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub c_rs: f64,
        /// What the ephemeris holds.
        pub valid_flags: EphemerisFlags,
    }
}

field! {
    BeidouEphemeris: 0x91, 0x64, "gnss_1.beidou_ephemeris";
    in [0x91 | 0x92];
}
