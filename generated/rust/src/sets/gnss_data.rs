//! GNSS data (0x81, 0x91, 0x92, 0x93, 0x94, 0x95): Measurements and status of GNSS receivers. Each
//! receiver has a descriptor set; all have the same fields.
//!
//! Uncertain: Some devices may not send a field in every set: the SDK lists the same fields for all
//! GNSS data sets, the manuals fewer.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// GNSS data (0x81): Measurements and status of the GNSS receiver of 4-series and 5-series devices.
///
/// Source: mip-sdk-4: Gnss Data (0x81).
pub const GNSS_DATA_SET: crate::DescriptorSet = crate::DescriptorSet(0x81);

/// GNSS receiver 1 data (0x91): Measurements and status of the first internal GNSS receiver.
///
/// Source: 3dm-cv7-gnss-ins: GNSS Recv 1 (0x91).
pub const GNSS_1_SET: crate::DescriptorSet = crate::DescriptorSet(0x91);

/// GNSS receiver 2 data (0x92): Measurements and status of the second internal GNSS receiver.
///
/// Source: 3dm-cv7-gnss-ins: GNSS Recv 2 (0x92).
pub const GNSS_2_SET: crate::DescriptorSet = crate::DescriptorSet(0x92);

/// GNSS corrections data (0x93): RTK corrections that the device receives. Data is sent as it is
/// received.
///
/// Source: 3dm-cv7-gnss-ins: GNSS Corrections (0x93).
pub const GNSS_CORRECTIONS_SET: crate::DescriptorSet = crate::DescriptorSet(0x93);

/// External GNSS data (0x94): Data that an external GNSS receiver sends to the device in NMEA
/// sentences. A field may need several sentences; a value that NMEA does not provide is not valid.
/// Times are taken from the sentences.
///
/// Source: 3dm-cv7-gnss-ins: GNSS External (0x94); 3dm-cv7-gnss-ins: NMEA Input.
pub const GNSS_EXTERNAL_SET: crate::DescriptorSet = crate::DescriptorSet(0x94);

/// External GNSS data 2 (0x95): Data that a second external GNSS receiver sends to the device.
///
/// Uncertain: The name is from a page on the 3DM-CV7-INS that the vendor published for trial; the
/// SDK calls the set GNSS 5.
///
/// Source: mip-sdk-4: Gnss5 Data (0x95).
pub const GNSS_EXTERNAL_2_SET: crate::DescriptorSet = crate::DescriptorSet(0x95);

bitfield! {
    /// Validity flags for the position.
    LlhPositionFlags: u16 {
        /// `latitude` and `longitude` are valid. Bit 0.
        LAT_LON: bool = 0,
            lat_lon, set_lat_lon, with_lat_lon;
        /// `ellipsoid_height` is valid. Bit 1.
        ELLIPSOID_HEIGHT: bool = 1,
            ellipsoid_height, set_ellipsoid_height, with_ellipsoid_height;
        /// `msl_height` is valid. Bit 2.
        MSL_HEIGHT: bool = 2,
            msl_height, set_msl_height, with_msl_height;
        /// `horizontal_accuracy` is valid. Bit 3.
        HORIZONTAL_ACCURACY: bool = 3,
            horizontal_accuracy, set_horizontal_accuracy, with_horizontal_accuracy;
        /// `vertical_accuracy` is valid. Bit 4.
        VERTICAL_ACCURACY: bool = 4,
            vertical_accuracy, set_vertical_accuracy, with_vertical_accuracy;
        /// All values are valid. Bits 0 to 4. Overlaps other bits.
        FLAGS: u8 = 0..=4,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the position.
    EcefPositionFlags: u16 {
        /// `position` is valid. Bit 0.
        POSITION: bool = 0,
            position, set_position, with_position;
        /// `position_accuracy` is valid. Bit 1.
        POSITION_ACCURACY: bool = 1,
            position_accuracy, set_position_accuracy, with_position_accuracy;
        /// All values are valid. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the velocity.
    NedVelocityFlags: u16 {
        /// `velocity` is valid. Bit 0.
        VELOCITY: bool = 0,
            velocity, set_velocity, with_velocity;
        /// `speed` is valid. Bit 1.
        SPEED_3D: bool = 1,
            speed_3d, set_speed_3d, with_speed_3d;
        /// `ground_speed` is valid. Bit 2.
        GROUND_SPEED: bool = 2,
            ground_speed, set_ground_speed, with_ground_speed;
        /// `heading` is valid. Bit 3.
        HEADING: bool = 3,
            heading, set_heading, with_heading;
        /// `speed_accuracy` is valid. Bit 4.
        SPEED_ACCURACY: bool = 4,
            speed_accuracy, set_speed_accuracy, with_speed_accuracy;
        /// `heading_accuracy` is valid. Bit 5.
        HEADING_ACCURACY: bool = 5,
            heading_accuracy, set_heading_accuracy, with_heading_accuracy;
        /// All values are valid. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the velocity.
    EcefVelocityFlags: u16 {
        /// `velocity` is valid. Bit 0.
        VELOCITY: bool = 0,
            velocity, set_velocity, with_velocity;
        /// `velocity_accuracy` is valid. Bit 1.
        VELOCITY_ACCURACY: bool = 1,
            velocity_accuracy, set_velocity_accuracy, with_velocity_accuracy;
        /// All values are valid. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the dilutions of precision.
    DopFlags: u16 {
        /// `gdop` is valid. Bit 0.
        GDOP: bool = 0,
            gdop, set_gdop, with_gdop;
        /// `pdop` is valid. Bit 1.
        PDOP: bool = 1,
            pdop, set_pdop, with_pdop;
        /// `hdop` is valid. Bit 2.
        HDOP: bool = 2,
            hdop, set_hdop, with_hdop;
        /// `vdop` is valid. Bit 3.
        VDOP: bool = 3,
            vdop, set_vdop, with_vdop;
        /// `tdop` is valid. Bit 4.
        TDOP: bool = 4,
            tdop, set_tdop, with_tdop;
        /// `ndop` is valid. Bit 5.
        NDOP: bool = 5,
            ndop, set_ndop, with_ndop;
        /// `edop` is valid. Bit 6.
        EDOP: bool = 6,
            edop, set_edop, with_edop;
        /// All values are valid. Bits 0 to 6. Overlaps other bits.
        FLAGS: u8 = 0..=6,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the UTC time.
    UtcTimeFlags: u16 {
        /// Date and time come from GNSS. Bit 0.
        GNSS_DATE_TIME: bool = 0,
            gnss_date_time, set_gnss_date_time, with_gnss_date_time;
        /// The leap seconds between GPS time and UTC are known. Bit 1.
        LEAP_SECONDS_KNOWN: bool = 1,
            leap_seconds_known, set_leap_seconds_known, with_leap_seconds_known;
        /// Date and time come from GNSS, and the leap seconds are known. Bits 0 to 1. Overlaps
        /// other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the time.
    GpsTimeFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// All values are valid. Bits 0 to 1. Overlaps other bits.
        FLAGS: u8 = 0..=1,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the clock parameters.
    ClockInfoFlags: u16 {
        /// `bias` is valid. Bit 0.
        BIAS: bool = 0,
            bias, set_bias, with_bias;
        /// `drift` is valid. Bit 1.
        DRIFT: bool = 1,
            drift, set_drift, with_drift;
        /// `accuracy_estimate` is valid. Bit 2.
        ACCURACY_ESTIMATE: bool = 2,
            accuracy_estimate, set_accuracy_estimate, with_accuracy_estimate;
        /// All values are valid. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Corrections and satellite systems of the fix.
    FixFlags: u16 {
        /// SBAS corrections were used in the fix. Bit 0.
        SBAS_USED: bool = 0,
            sbas_used, set_sbas_used, with_sbas_used;
        /// Differential corrections were used in the fix. Bit 1.
        DGNSS_USED: bool = 1,
            dgnss_used, set_dgnss_used, with_dgnss_used;
    }
}

bitfield! {
    /// Validity flags for the fix information.
    FixInfoFlags: u16 {
        /// `fix_type` is valid. Bit 0.
        FIX_TYPE: bool = 0,
            fix_type, set_fix_type, with_fix_type;
        /// `num_sv` is valid. Bit 1.
        NUM_SV: bool = 1,
            num_sv, set_num_sv, with_num_sv;
        /// `fix_flags` is valid. Bit 2.
        FIX_FLAGS: bool = 2,
            fix_flags, set_fix_flags, with_fix_flags;
        /// All values are valid. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// State of a satellite.
    SvFlags: u16 {
        /// The satellite is used in the position fix. Bit 0.
        USED_FOR_NAVIGATION: bool = 0,
            used_for_navigation, set_used_for_navigation, with_used_for_navigation;
        /// The satellite reports that its signals can be used. Bit 1.
        HEALTHY: bool = 1,
            healthy, set_healthy, with_healthy;
    }
}

bitfield! {
    /// Validity flags for the satellite info.
    SvInfoFlags: u16 {
        /// `channel` is valid. Bit 0.
        CHANNEL: bool = 0,
            channel, set_channel, with_channel;
        /// `satellite_id` is valid. Bit 1.
        SATELLITE_ID: bool = 1,
            satellite_id, set_satellite_id, with_satellite_id;
        /// `carrier_noise_ratio` is valid. Bit 2.
        CARRIER_NOISE_RATIO: bool = 2,
            carrier_noise_ratio, set_carrier_noise_ratio, with_carrier_noise_ratio;
        /// `azimuth` is valid. Bit 3.
        AZIMUTH: bool = 3,
            azimuth, set_azimuth, with_azimuth;
        /// `elevation` is valid. Bit 4.
        ELEVATION: bool = 4,
            elevation, set_elevation, with_elevation;
        /// `sv_flags` is valid. Bit 5.
        SV_FLAGS: bool = 5,
            sv_flags, set_sv_flags, with_sv_flags;
        /// All values are valid. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Operating state of a GNSS receiver.
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
    /// Electrical condition of a GNSS antenna.
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
    /// State of the antenna's power supply.
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
    /// Validity flags for the hardware status.
    HardwareStatusFlags: u16 {
        /// `receiver_state` is valid. Bit 0.
        SENSOR_STATE: bool = 0,
            sensor_state, set_sensor_state, with_sensor_state;
        /// `antenna_state` is valid. Bit 1.
        ANTENNA_STATE: bool = 1,
            antenna_state, set_antenna_state, with_antenna_state;
        /// `antenna_power` is valid. Bit 2.
        ANTENNA_POWER: bool = 2,
            antenna_power, set_antenna_power, with_antenna_power;
        /// All values are valid. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the state of the corrections.
    DgpsInfoFlags: u16 {
        /// `age` is valid. Bit 0.
        AGE: bool = 0,
            age, set_age, with_age;
        /// `base_station_id` is valid. Bit 1.
        BASE_STATION_ID: bool = 1,
            base_station_id, set_base_station_id, with_base_station_id;
        /// `base_station_status` is valid. Bit 2.
        BASE_STATION_STATUS: bool = 2,
            base_station_status, set_base_station_status, with_base_station_status;
        /// `num_channels` is valid. Bit 3.
        NUM_CHANNELS: bool = 3,
            num_channels, set_num_channels, with_num_channels;
        /// All values are valid. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for a differential correction.
    DgpsChannelFlags: u16 {
        /// `satellite_id` is valid. Bit 0.
        SATELLITE_ID: bool = 0,
            satellite_id, set_satellite_id, with_satellite_id;
        /// `age` is valid. Bit 1.
        AGE: bool = 1,
            age, set_age, with_age;
        /// `range_correction` is valid. Bit 2.
        RANGE_CORRECTION: bool = 2,
            range_correction, set_range_correction, with_range_correction;
        /// `range_rate_correction` is valid. Bit 3.
        RANGE_RATE_CORRECTION: bool = 3,
            range_rate_correction, set_range_rate_correction, with_range_rate_correction;
        /// All values are valid. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the clock parameters.
    ClockInfo2Flags: u16 {
        /// `bias` is valid. Bit 0.
        BIAS: bool = 0,
            bias, set_bias, with_bias;
        /// `drift` is valid. Bit 1.
        DRIFT: bool = 1,
            drift, set_drift, with_drift;
        /// `bias_accuracy_estimate` is valid. Bit 2.
        BIAS_ACCURACY: bool = 2,
            bias_accuracy, set_bias_accuracy, with_bias_accuracy;
        /// `drift_accuracy_estimate` is valid. Bit 3.
        DRIFT_ACCURACY: bool = 3,
            drift_accuracy, set_drift_accuracy, with_drift_accuracy;
        /// All values are valid. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity of the leap seconds. Bit 0 is not used.
    GpsLeapSecondsFlags: u16 {
        /// `leap_seconds` is valid. Bit 1.
        LEAP_SECONDS: bool = 1,
            leap_seconds, set_leap_seconds, with_leap_seconds;
    }
}

open_enum! {
    /// Satellite-based augmentation system (SBAS).
    SbasSystem: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// WAAS, the North American system.
        WAAS = 1, "waas";
        /// EGNOS, the European system.
        EGNOS = 2, "egnos";
        /// MSAS, the Japanese system.
        MSAS = 3, "msas";
        /// GAGAN, the Indian system.
        GAGAN = 4, "gagan";
    }
}

bitfield! {
    /// Services of an SBAS system.
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
    /// Validity flags for the SBAS status.
    SbasInfoFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `sbas_system` is valid. Bit 2.
        SBAS_SYSTEM: bool = 2,
            sbas_system, set_sbas_system, with_sbas_system;
        /// `sbas_id` is valid. Bit 3.
        SBAS_ID: bool = 3,
            sbas_id, set_sbas_id, with_sbas_id;
        /// `count` is valid. Bit 4.
        COUNT: bool = 4,
            count, set_count, with_count;
        /// `sbas_status` is valid. Bit 5.
        SBAS_STATUS: bool = 5,
            sbas_status, set_sbas_status, with_sbas_status;
        /// All values are valid. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for an SBAS correction.
    SbasCorrectionFlags: u16 {
        /// `udrei` is valid. Bit 0.
        UDREI: bool = 0,
            udrei, set_udrei, with_udrei;
        /// `pseudorange_correction` is valid. Bit 1.
        PSEUDORANGE_CORRECTION: bool = 1,
            pseudorange_correction, set_pseudorange_correction, with_pseudorange_correction;
        /// `iono_correction` is valid. Bit 2.
        IONO_CORRECTION: bool = 2,
            iono_correction, set_iono_correction, with_iono_correction;
        /// All values are valid. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Frequency band of GNSS signals.
    RfBand: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// L1.
        L1 = 1, "l1";
        /// L2.
        L2 = 2, "l2";
        /// L5.
        L5 = 5, "l5";
    }
}

open_enum! {
    /// Severity of jamming.
    JammingState: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// Not jammed.
        NONE = 1, "none";
        /// Partly jammed.
        PARTIAL = 2, "partial";
        /// Heavily jammed.
        SIGNIFICANT = 3, "significant";
    }
}

open_enum! {
    /// Severity of spoofing.
    SpoofingState: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// Not spoofed.
        NONE = 1, "none";
        /// Partly spoofed.
        PARTIAL = 2, "partial";
        /// Heavily spoofed.
        SIGNIFICANT = 3, "significant";
    }
}

bitfield! {
    /// Validity flags for the detection.
    RfErrorDetectionFlags: u16 {
        /// `rf_band` is valid. Bit 0.
        RF_BAND: bool = 0,
            rf_band, set_rf_band, with_rf_band;
        /// `jamming_state` is valid. Bit 1.
        JAMMING_STATE: bool = 1,
            jamming_state, set_jamming_state, with_jamming_state;
        /// `spoofing_state` is valid. Bit 2.
        SPOOFING_STATE: bool = 2,
            spoofing_state, set_spoofing_state, with_spoofing_state;
        /// `frequency` is valid; set only by firmware that sends the frequency. Bit 3.
        FREQUENCY: bool = 3,
            frequency, set_frequency, with_frequency;
        /// All values are valid. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Resolution of the carrier phase ambiguities for a heading.
    HeadingFixType: u8 {
        /// Not known.
        UNKNOWN = 0, "unknown";
        /// The ambiguities are real numbers, which is less accurate.
        FLOAT = 1, "float";
        /// The ambiguities are fixed to whole numbers of cycles.
        FIXED = 2, "fixed";
    }
}

bitfield! {
    /// Validity flags for the heading.
    HeadingFlags: u16 {
        /// `heading` is valid. Bit 0.
        HEADING: bool = 0,
            heading, set_heading, with_heading;
        /// `uncertainty` is valid. Bit 1.
        UNCERTAINTY: bool = 1,
            uncertainty, set_uncertainty, with_uncertainty;
        /// `fix_type` is valid. Bit 2.
        FIX_TYPE: bool = 2,
            fix_type, set_fix_type, with_fix_type;
        /// All values are valid. Bits 0 to 2. Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the satellite status.
    SatelliteStatusFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `gnss_id` is valid. Bit 2.
        GNSS_ID: bool = 2,
            gnss_id, set_gnss_id, with_gnss_id;
        /// `satellite_id` is valid. Bit 3.
        SATELLITE_ID: bool = 3,
            satellite_id, set_satellite_id, with_satellite_id;
        /// `elevation` is valid. Bit 4.
        ELEVATION: bool = 4,
            elevation, set_elevation, with_elevation;
        /// `azimuth` is valid. Bit 5.
        AZIMUTH: bool = 5,
            azimuth, set_azimuth, with_azimuth;
        /// `health` is valid. Bit 6.
        HEALTH: bool = 6,
            health, set_health, with_health;
        /// All values are valid. Bits 0 to 6. Overlaps other bits.
        FLAGS: u8 = 0..=6,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Tracking quality of a signal.
    SignalQuality: u8 {
        /// No signal.
        NONE = 0, "none";
        /// The signal is being searched for.
        SEARCHING = 1, "searching";
        /// The signal is acquired.
        ACQUIRED = 2, "acquired";
        /// The signal is found but cannot be used.
        UNUSABLE = 3, "unusable";
        /// Time-locked.
        TIME_LOCKED = 4, "time_locked";
        /// Fully locked.
        FULLY_LOCKED = 5, "fully_locked";
    }
}

bitfield! {
    /// Validity flags for the observation.
    RawFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `receiver_id` is valid. Bit 2.
        RECEIVER_ID: bool = 2,
            receiver_id, set_receiver_id, with_receiver_id;
        /// `tracking_channel` is valid. Bit 3.
        TRACKING_CHANNEL: bool = 3,
            tracking_channel, set_tracking_channel, with_tracking_channel;
        /// `gnss_id` is valid. Bit 4.
        GNSS_ID: bool = 4,
            gnss_id, set_gnss_id, with_gnss_id;
        /// `satellite_id` is valid. Bit 5.
        SATELLITE_ID: bool = 5,
            satellite_id, set_satellite_id, with_satellite_id;
        /// `signal_id` is valid. Bit 6.
        SIGNAL_ID: bool = 6,
            signal_id, set_signal_id, with_signal_id;
        /// `signal_strength` is valid. Bit 7.
        SIGNAL_STRENGTH: bool = 7,
            signal_strength, set_signal_strength, with_signal_strength;
        /// `quality` is valid. Bit 8.
        QUALITY: bool = 8,
            quality, set_quality, with_quality;
        /// `pseudorange` is valid. Bit 9.
        PSEUDORANGE: bool = 9,
            pseudorange, set_pseudorange, with_pseudorange;
        /// `carrier_phase` is valid. Bit 10.
        CARRIER_PHASE: bool = 10,
            carrier_phase, set_carrier_phase, with_carrier_phase;
        /// `doppler` is valid. Bit 11.
        DOPPLER: bool = 11,
            doppler, set_doppler, with_doppler;
        /// `range_uncertainty` is valid. Bit 12.
        RANGE_UNCERTAINTY: bool = 12,
            range_uncertainty, set_range_uncertainty, with_range_uncertainty;
        /// `phase_uncertainty` is valid. Bit 13.
        CARRIER_PHASE_UNCERTAINTY: bool = 13,
            carrier_phase_uncertainty, set_carrier_phase_uncertainty, with_carrier_phase_uncertainty;
        /// `doppler_uncertainty` is valid. Bit 14.
        DOPPLER_UNCERTAINTY: bool = 14,
            doppler_uncertainty, set_doppler_uncertainty, with_doppler_uncertainty;
        /// `lock_time` is valid. Bit 15.
        LOCK_TIME: bool = 15,
            lock_time, set_lock_time, with_lock_time;
        /// All values are valid. Bits 0 to 15. Overlaps other bits.
        FLAGS: u16 = 0..=15,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Properties of a base station, as in its RTCM message.
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
        REFERENCE_STATION: bool = 4,
            reference_station, set_reference_station, with_reference_station;
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
    /// Valid values.
    BaseStationInfoFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `ecef_position` is valid. Bit 2.
        ECEF_POSITION: bool = 2,
            ecef_position, set_ecef_position, with_ecef_position;
        /// `height` is valid. Bit 3.
        HEIGHT: bool = 3,
            height, set_height, with_height;
        /// `station_id` is valid. Bit 4.
        STATION_ID: bool = 4,
            station_id, set_station_id, with_station_id;
        /// `indicators` is valid. Bit 5.
        INDICATORS: bool = 5,
            indicators, set_indicators, with_indicators;
        /// All values are valid. Bits 0 to 5. Overlaps other bits.
        FLAGS: u8 = 0..=5,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Corrections received during an epoch.
    RtkEpochStatus: u16 {
        /// The position of the base station's antenna has arrived. Bit 0.
        ANTENNA_LOCATION_RECEIVED: bool = 0,
            antenna_location_received, set_antenna_location_received, with_antenna_location_received;
        /// The description of the base station's antenna has arrived. Bit 1.
        ANTENNA_DESCRIPTION_RECEIVED: bool = 1,
            antenna_description_received, set_antenna_description_received, with_antenna_description_received;
        /// GPS corrections have arrived. Bit 2.
        GPS_RECEIVED: bool = 2,
            gps_received, set_gps_received, with_gps_received;
        /// GLONASS corrections have arrived. Bit 3.
        GLONASS_RECEIVED: bool = 3,
            glonass_received, set_glonass_received, with_glonass_received;
        /// Galileo corrections have arrived. Bit 4.
        GALILEO_RECEIVED: bool = 4,
            galileo_received, set_galileo_received, with_galileo_received;
        /// BeiDou corrections have arrived. Bit 5.
        BEIDOU_RECEIVED: bool = 5,
            beidou_received, set_beidou_received, with_beidou_received;
        /// GPS corrections are received in MSM messages, not in the RTCM messages 1001-1004. Bit 6.
        USING_GPS_MSM_MESSAGES: bool = 6,
            using_gps_msm_messages, set_using_gps_msm_messages, with_using_gps_msm_messages;
        /// GLONASS corrections are received in MSM messages, not in the RTCM messages 1009-1012.
        /// Bit 7.
        USING_GLONASS_MSM_MESSAGES: bool = 7,
            using_glonass_msm_messages, set_using_glonass_msm_messages, with_using_glonass_msm_messages;
        /// The status of the dongle could not be read. Bit 8.
        DONGLE_STATUS_READ_FAILED: bool = 8,
            dongle_status_read_failed, set_dongle_status_read_failed, with_dongle_status_read_failed;
    }
}

bitfield! {
    /// Valid values.
    RtkCorrectionsStatusFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `epoch_status` is valid. Bit 2.
        EPOCH_STATUS: bool = 2,
            epoch_status, set_epoch_status, with_epoch_status;
        /// `dongle_status` is valid. Bit 3.
        DONGLE_STATUS: bool = 3,
            dongle_status, set_dongle_status, with_dongle_status;
        /// `gps_correction_latency` is valid. Bit 4.
        GPS_LATENCY: bool = 4,
            gps_latency, set_gps_latency, with_gps_latency;
        /// `glonass_correction_latency` is valid. Bit 5.
        GLONASS_LATENCY: bool = 5,
            glonass_latency, set_glonass_latency, with_glonass_latency;
        /// `galileo_correction_latency` is valid. Bit 6.
        GALILEO_LATENCY: bool = 6,
            galileo_latency, set_galileo_latency, with_galileo_latency;
        /// `beidou_correction_latency` is valid. Bit 7.
        BEIDOU_LATENCY: bool = 7,
            beidou_latency, set_beidou_latency, with_beidou_latency;
        /// All values are valid. Bits 0 to 7. Overlaps other bits.
        FLAGS: u8 = 0..=7,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Contents of a GPS, Galileo or BeiDou ephemeris.
    EphemerisFlags: u16 {
        /// The ephemeris is valid. Bit 0.
        EPHEMERIS: bool = 0,
            ephemeris, set_ephemeris, with_ephemeris;
        /// Data of the modernized navigation message is included. Bit 1.
        MODERN_DATA: bool = 1,
            modern_data, set_modern_data, with_modern_data;
        /// `isc_l2c` is the correction for L5, not for L2. Bit 2.
        ISC_L5: bool = 2,
            isc_l5, set_isc_l5, with_isc_l5;
        /// The ephemeris is valid, with modernized data and the correction for L5. Bits 0 to 2.
        /// Overlaps other bits.
        FLAGS: u8 = 0..=2,
            flags, set_flags, with_flags;
    }
}

open_enum! {
    /// Generation of a GLONASS satellite.
    GlonassSatelliteType: u8 {
        /// Glonass.
        GLONASS = 0, "glonass";
        /// Glonass m.
        GLONASS_M = 1, "glonass_m";
    }
}

bitfield! {
    /// Validity of the ephemeris.
    GlonassEphemerisFlags: u16 {
        /// The ephemeris is valid. Bit 0.
        EPHEMERIS: bool = 0,
            ephemeris, set_ephemeris, with_ephemeris;
        /// All values are valid. Bit 0. Overlaps other bits.
        FLAGS: bool = 0,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the model.
    GpsIonoCorrectionFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `alpha` is valid. Bit 2.
        ALPHA: bool = 2,
            alpha, set_alpha, with_alpha;
        /// `beta` is valid. Bit 3.
        BETA: bool = 3,
            beta, set_beta, with_beta;
        /// All values are valid. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the model.
    GalileoIonoCorrectionFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `alpha` is valid. Bit 2.
        ALPHA: bool = 2,
            alpha, set_alpha, with_alpha;
        /// `disturbance_flags` is valid. Bit 3.
        DISTURBANCE_FLAGS: bool = 3,
            disturbance_flags, set_disturbance_flags, with_disturbance_flags;
        /// All values are valid. Bits 0 to 3. Overlaps other bits.
        FLAGS: u8 = 0..=3,
            flags, set_flags, with_flags;
    }
}

bitfield! {
    /// Validity flags for the model.
    BeidouIonoCorrectionFlags: u16 {
        /// `tow` is valid. Bit 0.
        TOW: bool = 0,
            tow, set_tow, with_tow;
        /// `week_number` is valid. Bit 1.
        WEEK_NUMBER: bool = 1,
            week_number, set_week_number, with_week_number;
        /// `alpha` is valid. Bit 2.
        ALPHA: bool = 2,
            alpha, set_alpha, with_alpha;
        /// `beta` is valid. Bit 3.
        BETA: bool = 3,
            beta, set_beta, with_beta;
        /// `alpha_correction` is valid. Bit 4.
        ALPHA_CORRECTION: bool = 4,
            alpha_correction, set_alpha_correction, with_alpha_correction;
        /// All values are valid. Bits 0 to 4. Overlaps other bits.
        FLAGS: u8 = 0..=4,
            flags, set_flags, with_flags;
    }
}

record! {
    /// GNSS LLH position (0x03).
    ///
    /// GNSS position as latitude, longitude and height.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `pos_llh`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 11 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS LLH Position (0x91,0x03); 3dm-cv7-gnss-ins: GNSS LLH Position
    /// (0x92,0x03); 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03).
    #[derive(Copy, Default)]
    pub struct LlhPosition {
        /// Geodetic latitude.
        ///
        /// Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if
        /// [`valid_flags.lat_lon`](LlhPositionFlags::lat_lon) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub latitude: f64,
        /// Geodetic longitude.
        ///
        /// Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
        /// [`valid_flags.lat_lon`](LlhPositionFlags::lat_lon) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub longitude: f64,
        /// Height above the ellipsoid.
        ///
        /// Unit: m. Frame: llh. Valid if
        /// [`valid_flags.ellipsoid_height`](LlhPositionFlags::ellipsoid_height) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub ellipsoid_height: f64,
        /// Height above mean sea level.
        ///
        /// Unit: m. Valid if [`valid_flags.msl_height`](LlhPositionFlags::msl_height) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub msl_height: f64,
        /// Estimated error of latitude and longitude.
        ///
        /// Unit: m. Range: at least 0. Valid if
        /// [`valid_flags.horizontal_accuracy`](LlhPositionFlags::horizontal_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub horizontal_accuracy: f32,
        /// Estimated error of the heights.
        ///
        /// Unit: m. Range: at least 0. Valid if
        /// [`valid_flags.vertical_accuracy`](LlhPositionFlags::vertical_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub vertical_accuracy: f32,
        /// Validity flags for the position.
        pub valid_flags: LlhPositionFlags,
    }
}

view! {
    LlhPosition
    latitude: f64, at 0;
    longitude: f64, at 8;
    ellipsoid_height: f64, at 16;
    msl_height: f64, at 24;
    horizontal_accuracy: f32, at 32;
    vertical_accuracy: f32, at 36;
    valid_flags: LlhPositionFlags, at 40;
}

constructors! {
    LlhPosition

    /// Creates it from its values.
    fn new(
        latitude: f64,
        longitude: f64,
        ellipsoid_height: f64,
        msl_height: f64,
        horizontal_accuracy: f32,
        vertical_accuracy: f32,
        valid_flags: LlhPositionFlags,
    );
}

valid! {
    LlhPosition
    latitude_is_valid "latitude": valid_flags 0x1;
    longitude_is_valid "longitude": valid_flags 0x1;
    ellipsoid_height_is_valid "ellipsoid_height": valid_flags 0x2;
    msl_height_is_valid "msl_height": valid_flags 0x4;
    horizontal_accuracy_is_valid "horizontal_accuracy": valid_flags 0x8;
    vertical_accuracy_is_valid "vertical_accuracy": valid_flags 0x10;
}

field! {
    LlhPosition: 0x03, "gnss_data.llh_position";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GNSS ECEF position (0x04).
    ///
    /// GNSS position in Earth-fixed coordinates.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `pos_ecef`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 3 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS ECEF Position (0x91,0x04); 3dm-cv7-gnss-ins: GNSS ECEF
    /// Position (0x92,0x04).
    #[derive(Copy, Default)]
    pub struct EcefPosition {
        /// Position of the antenna.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.position`](EcefPositionFlags::position) is set.
        pub position: types::Vector3d,
        /// Estimated error of the position.
        ///
        /// Unit: m. Range: at least 0. Valid if
        /// [`valid_flags.position_accuracy`](EcefPositionFlags::position_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub position_accuracy: f32,
        /// Validity flags for the position.
        pub valid_flags: EcefPositionFlags,
    }
}

view! {
    EcefPosition
    position: types::Vector3d, at 0;
    position_accuracy: f32, at 24;
    valid_flags: EcefPositionFlags, at 28;
}

constructors! {
    EcefPosition

    /// Creates it from its values.
    fn new(
        position: impl Into<types::Vector3d>,
        position_accuracy: f32,
        valid_flags: EcefPositionFlags,
    );
}

valid! {
    EcefPosition
    position_is_valid "position": valid_flags 0x1;
    position_accuracy_is_valid "position_accuracy": valid_flags 0x2;
}

field! {
    EcefPosition: 0x04, "gnss_data.ecef_position";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// NED velocity (0x05).
    ///
    /// GNSS velocity in the local level frame.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `vel_ned`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 11 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: NED Velocity (0x91,0x05); 3dm-cv7-gnss-ins: NED Velocity
    /// (0x92,0x05); 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05).
    #[derive(Copy, Default)]
    pub struct NedVelocity {
        /// Velocity of the antenna.
        ///
        /// Elements: north, east, down. Unit: m/s. Frame: ned. At rest and level: north 0, east 0,
        /// down 0. Valid if [`valid_flags.velocity`](NedVelocityFlags::velocity) is set.
        pub velocity: types::Ned3f,
        /// Speed in space.
        ///
        /// Unit: m/s. Range: at least 0. Valid if
        /// [`valid_flags.speed_3d`](NedVelocityFlags::speed_3d) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub speed: f32,
        /// Speed over ground.
        ///
        /// Unit: m/s. Range: at least 0. Valid if
        /// [`valid_flags.ground_speed`](NedVelocityFlags::ground_speed) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub ground_speed: f32,
        /// Direction of the motion over ground.
        ///
        /// Unit: deg. Frame: ned. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.heading`](NedVelocityFlags::heading) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Estimated error of the speed.
        ///
        /// Unit: m/s. Range: at least 0. Valid if
        /// [`valid_flags.speed_accuracy`](NedVelocityFlags::speed_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub speed_accuracy: f32,
        /// Estimated error of the heading.
        ///
        /// Unit: deg. Range: at least 0. Valid if
        /// [`valid_flags.heading_accuracy`](NedVelocityFlags::heading_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading_accuracy: f32,
        /// Validity flags for the velocity.
        pub valid_flags: NedVelocityFlags,
    }
}

view! {
    NedVelocity
    velocity: types::Ned3f, at 0;
    speed: f32, at 12;
    ground_speed: f32, at 16;
    heading: f32, at 20;
    speed_accuracy: f32, at 24;
    heading_accuracy: f32, at 28;
    valid_flags: NedVelocityFlags, at 32;
}

constructors! {
    NedVelocity

    /// Creates it from its values.
    fn new(
        velocity: impl Into<types::Ned3f>,
        speed: f32,
        ground_speed: f32,
        heading: f32,
        speed_accuracy: f32,
        heading_accuracy: f32,
        valid_flags: NedVelocityFlags,
    );
}

valid! {
    NedVelocity
    velocity_is_valid "velocity": valid_flags 0x1;
    speed_is_valid "speed": valid_flags 0x2;
    ground_speed_is_valid "ground_speed": valid_flags 0x4;
    heading_is_valid "heading": valid_flags 0x8;
    speed_accuracy_is_valid "speed_accuracy": valid_flags 0x10;
    heading_accuracy_is_valid "heading_accuracy": valid_flags 0x20;
}

field! {
    NedVelocity: 0x05, "gnss_data.ned_velocity";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GNSS ECEF velocity (0x06).
    ///
    /// GNSS velocity in Earth-fixed coordinates.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `vel_ecef`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS),
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7) and [3DM-GX5-35](crate::devices::GX5_35); likely or
    /// assumed on 2 more.
    ///
    /// Source: 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06); 3dm-cv7-gnss-ins: GNSS ECEF Velocity
    /// (0x91,0x06); 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06).
    #[derive(Copy, Default)]
    pub struct EcefVelocity {
        /// Velocity of the antenna.
        ///
        /// Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and level: x 0, y 0, z 0. Valid if
        /// [`valid_flags.velocity`](EcefVelocityFlags::velocity) is set.
        pub velocity: types::Vector3f,
        /// Estimated error of the velocity.
        ///
        /// Unit: m/s. Range: at least 0. Valid if
        /// [`valid_flags.velocity_accuracy`](EcefVelocityFlags::velocity_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub velocity_accuracy: f32,
        /// Validity flags for the velocity.
        pub valid_flags: EcefVelocityFlags,
    }
}

view! {
    EcefVelocity
    velocity: types::Vector3f, at 0;
    velocity_accuracy: f32, at 12;
    valid_flags: EcefVelocityFlags, at 16;
}

constructors! {
    EcefVelocity

    /// Creates it from its values.
    fn new(
        velocity: impl Into<types::Vector3f>,
        velocity_accuracy: f32,
        valid_flags: EcefVelocityFlags,
    );
}

valid! {
    EcefVelocity
    velocity_is_valid "velocity": valid_flags 0x1;
    velocity_accuracy_is_valid "velocity_accuracy": valid_flags 0x2;
}

field! {
    EcefVelocity: 0x06, "gnss_data.ecef_velocity";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// DOP (0x07).
    ///
    /// Dilution of precision of the satellite geometry.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 4 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: DOP (0x91,0x07); 3dm-cv7-gnss-ins: DOP (0x92,0x07).
    #[derive(Copy, Default)]
    pub struct Dop {
        /// Geometric dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.gdop`](DopFlags::gdop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub gdop: f32,
        /// Position dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.pdop`](DopFlags::pdop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pdop: f32,
        /// Horizontal dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.hdop`](DopFlags::hdop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub hdop: f32,
        /// Vertical dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.vdop`](DopFlags::vdop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub vdop: f32,
        /// Time dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.tdop`](DopFlags::tdop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tdop: f32,
        /// Northing dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.ndop`](DopFlags::ndop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub ndop: f32,
        /// Easting dilution.
        ///
        /// Unit: 1. Range: at least 0. Valid if [`valid_flags.edop`](DopFlags::edop) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub edop: f32,
        /// Validity flags for the dilutions of precision.
        pub valid_flags: DopFlags,
    }
}

view! {
    Dop
    gdop: f32, at 0;
    pdop: f32, at 4;
    hdop: f32, at 8;
    vdop: f32, at 12;
    tdop: f32, at 16;
    ndop: f32, at 20;
    edop: f32, at 24;
    valid_flags: DopFlags, at 28;
}

constructors! {
    Dop

    /// Creates it from its values.
    fn new(
        gdop: f32,
        pdop: f32,
        hdop: f32,
        vdop: f32,
        tdop: f32,
        ndop: f32,
        edop: f32,
        valid_flags: DopFlags,
    );
}

valid! {
    Dop
    gdop_is_valid "gdop": valid_flags 0x1;
    pdop_is_valid "pdop": valid_flags 0x2;
    hdop_is_valid "hdop": valid_flags 0x4;
    vdop_is_valid "vdop": valid_flags 0x8;
    tdop_is_valid "tdop": valid_flags 0x10;
    ndop_is_valid "ndop": valid_flags 0x20;
    edop_is_valid "edop": valid_flags 0x40;
}

field! {
    Dop: 0x07, "gnss_data.dop";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// UTC time (0x08).
    ///
    /// Coordinated universal time (UTC) according to the receiver.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 6 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: UTC Time (0x91,0x08); 3dm-cv7-gnss-ins: UTC Time (0x92,0x08);
    /// 3dm-cv7-gnss-ins: UTC Time (0x94,0x08).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct UtcTime {
        /// Year with four digits.
        ///
        /// Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is set.
        pub year: u16,
        /// Month, 1 for January.
        ///
        /// Range: 1 to 12. Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is
        /// set.
        pub month: u8,
        /// Day of the month.
        ///
        /// Range: 1 to 31. Valid if [`valid_flags.gnss_date_time`](UtcTimeFlags::gnss_date_time) is
        /// set.
        pub day: u8,
        /// Hour of the day.
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
        /// Validity flags for the time.
        pub valid_flags: UtcTimeFlags,
    }
}

view! {
    UtcTime
    year: u16, at 0;
    month: u8, at 2;
    day: u8, at 3;
    hour: u8, at 4;
    min: u8, at 5;
    sec: u8, at 6;
    msec: u32, at 7;
    valid_flags: UtcTimeFlags, at 11;
}

constructors! {
    UtcTime

    /// Creates it from its values.
    fn new(
        year: u16,
        month: u8,
        day: u8,
        hour: u8,
        min: u8,
        sec: u8,
        msec: u32,
        valid_flags: UtcTimeFlags,
    );
}

valid! {
    UtcTime
    year_is_valid "year": valid_flags 0x1;
    month_is_valid "month": valid_flags 0x1;
    day_is_valid "day": valid_flags 0x1;
    hour_is_valid "hour": valid_flags 0x1;
    min_is_valid "min": valid_flags 0x1;
    sec_is_valid "sec": valid_flags 0x1;
    msec_is_valid "msec": valid_flags 0x1;
}

field! {
    UtcTime: 0x08, "gnss_data.utc_time";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GPS time (0x09).
    ///
    /// GPS time according to the receiver.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 10 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Time (0x91,0x09); 3dm-cv7-gnss-ins: GPS Time (0x92,0x09).
    #[derive(Copy, Default)]
    pub struct GpsTime {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](GpsTimeFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](GpsTimeFlags::week_number) is set.
        pub week_number: u16,
        /// Validity flags for the time.
        pub valid_flags: GpsTimeFlags,
    }
}

view! {
    GpsTime
    tow: f64, at 0;
    week_number: u16, at 8;
    valid_flags: GpsTimeFlags, at 10;
}

constructors! {
    GpsTime

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        valid_flags: GpsTimeFlags,
    );
}

valid! {
    GpsTime
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
}

field! {
    GpsTime: 0x09, "gnss_data.gps_time";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Clock info (0x0A).
    ///
    /// Bias and drift of the receiver clock.
    ///
    /// No device is known for certain to support it. Occurs in gnss_data (0x81), gnss_1 (0x91),
    /// gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and gnss_external_2 (0x95).
    /// Known only from the MicroStrain MIP SDK.
    ///
    /// - Clock info 2 supersedes it and is more detailed.
    ///
    /// Source: mip-sdk-4: Clock Info (0x81,0x0A).
    #[derive(Copy, Default)]
    pub struct ClockInfo {
        /// Bias of the clock.
        ///
        /// Unit: s. Valid if [`valid_flags.bias`](ClockInfoFlags::bias) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias: f64,
        /// Drift of the clock.
        ///
        /// Unit: s/s. Valid if [`valid_flags.drift`](ClockInfoFlags::drift) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub drift: f64,
        /// Estimated error of the bias.
        ///
        /// Unit: s. Range: at least 0. Valid if
        /// [`valid_flags.accuracy_estimate`](ClockInfoFlags::accuracy_estimate) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub accuracy_estimate: f64,
        /// Validity flags for the clock parameters.
        pub valid_flags: ClockInfoFlags,
    }
}

view! {
    ClockInfo
    bias: f64, at 0;
    drift: f64, at 8;
    accuracy_estimate: f64, at 16;
    valid_flags: ClockInfoFlags, at 24;
}

constructors! {
    ClockInfo

    /// Creates it from its values.
    fn new(
        bias: f64,
        drift: f64,
        accuracy_estimate: f64,
        valid_flags: ClockInfoFlags,
    );
}

valid! {
    ClockInfo
    bias_is_valid "bias": valid_flags 0x1;
    drift_is_valid "drift": valid_flags 0x2;
    accuracy_estimate_is_valid "accuracy_estimate": valid_flags 0x4;
}

field! {
    ClockInfo: 0x0A, "gnss_data.clock_info";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Fix info (0x0B).
    ///
    /// Type of the position fix, with the satellites and corrections used.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-CV7-INS](crate::devices::CV7_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7); likely or assumed on 5 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B); 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B);
    /// 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct FixInfo {
        /// Quantities that the receiver can determine at present.
        ///
        /// Valid if [`valid_flags.fix_type`](FixInfoFlags::fix_type) is set.
        pub fix_type: types::GnssFixType,
        /// Number of satellites used in the fix.
        ///
        /// Unit: 1. Valid if [`valid_flags.num_sv`](FixInfoFlags::num_sv) is set.
        pub num_sv: u8,
        /// Corrections and satellite systems of the fix.
        ///
        /// Valid if [`valid_flags.fix_flags`](FixInfoFlags::fix_flags) is set.
        pub fix_flags: FixFlags,
        /// Validity flags for the fix information.
        pub valid_flags: FixInfoFlags,
    }
}

view! {
    FixInfo
    fix_type: types::GnssFixType, at 0;
    num_sv: u8, at 1;
    fix_flags: FixFlags, at 2;
    valid_flags: FixInfoFlags, at 4;
}

constructors! {
    FixInfo

    /// Creates it from its values.
    fn new(
        fix_type: types::GnssFixType,
        num_sv: u8,
        fix_flags: FixFlags,
        valid_flags: FixInfoFlags,
    );
}

valid! {
    FixInfo
    fix_type_is_valid "fix_type": valid_flags 0x1;
    num_sv_is_valid "num_sv": valid_flags 0x2;
    fix_flags_is_valid "fix_flags": valid_flags 0x4;
}

field! {
    FixInfo: 0x0B, "gnss_data.fix_info";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Satellite info (0x0C).
    ///
    /// State of one tracked satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 2 more. Known only from the
    /// MicroStrain MIP SDK. Uncertain: It is not known whether a packet contains one of these
    /// fields or several.
    ///
    /// - Each satellite is sent as one field, in packets separate from other GNSS data.
    ///
    /// Source: mip-sdk-4: Sv Info (0x81,0x0C).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct SvInfo {
        /// Channel of the receiver that tracks the satellite.
        ///
        /// Valid if [`valid_flags.channel`](SvInfoFlags::channel) is set.
        pub channel: u8,
        /// Number of the satellite.
        ///
        /// Valid if [`valid_flags.satellite_id`](SvInfoFlags::satellite_id) is set.
        pub satellite_id: u8,
        /// Carrier to noise density ratio.
        ///
        /// Unit: dB-Hz. Valid if
        /// [`valid_flags.carrier_noise_ratio`](SvInfoFlags::carrier_noise_ratio) is set.
        pub carrier_noise_ratio: u16,
        /// Direction of the satellite, from true north.
        ///
        /// Unit: deg. Frame: ned. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.azimuth`](SvInfoFlags::azimuth) is set.
        pub azimuth: i16,
        /// Angle between the horizon and the satellite.
        ///
        /// Unit: deg. Frame: ned. Range: -90 to 90. Positive: above the horizon. Valid if
        /// [`valid_flags.elevation`](SvInfoFlags::elevation) is set.
        pub elevation: i16,
        /// State of the satellite.
        ///
        /// Valid if [`valid_flags.sv_flags`](SvInfoFlags::sv_flags) is set.
        pub sv_flags: SvFlags,
        /// Validity flags for the satellite info.
        pub valid_flags: SvInfoFlags,
    }
}

view! {
    SvInfo
    channel: u8, at 0;
    satellite_id: u8, at 1;
    carrier_noise_ratio: u16, at 2;
    azimuth: i16, at 4;
    elevation: i16, at 6;
    sv_flags: SvFlags, at 8;
    valid_flags: SvInfoFlags, at 10;
}

constructors! {
    SvInfo

    /// Creates it from its values.
    fn new(
        channel: u8,
        satellite_id: u8,
        carrier_noise_ratio: u16,
        azimuth: i16,
        elevation: i16,
        sv_flags: SvFlags,
        valid_flags: SvInfoFlags,
    );
}

valid! {
    SvInfo
    channel_is_valid "channel": valid_flags 0x1;
    satellite_id_is_valid "satellite_id": valid_flags 0x2;
    carrier_noise_ratio_is_valid "carrier_noise_ratio": valid_flags 0x4;
    azimuth_is_valid "azimuth": valid_flags 0x8;
    elevation_is_valid "elevation": valid_flags 0x10;
    sv_flags_is_valid "sv_flags": valid_flags 0x20;
}

field! {
    SvInfo: 0x0C, "gnss_data.sv_info";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GNSS hardware status (0x0D).
    ///
    /// State of the receiver and of its antenna.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `hw_status`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS), [3DM-GQ7-GNSS/INS](crate::devices::GQ7)
    /// and [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 2 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GNSS Hardware Status (0x91,0x0D); 3dm-cv7-gnss-ins: GNSS Hardware
    /// Status (0x92,0x0D).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct HardwareStatus {
        /// Operating state of the receiver.
        ///
        /// Valid if [`valid_flags.sensor_state`](HardwareStatusFlags::sensor_state) is set.
        pub receiver_state: ReceiverState,
        /// Electrical condition of the antenna.
        ///
        /// Valid if [`valid_flags.antenna_state`](HardwareStatusFlags::antenna_state) is set.
        pub antenna_state: AntennaState,
        /// State of the antenna's power supply.
        ///
        /// Valid if [`valid_flags.antenna_power`](HardwareStatusFlags::antenna_power) is set.
        pub antenna_power: AntennaPower,
        /// Validity flags for the hardware status.
        pub valid_flags: HardwareStatusFlags,
    }
}

view! {
    HardwareStatus
    receiver_state: ReceiverState, at 0;
    antenna_state: AntennaState, at 1;
    antenna_power: AntennaPower, at 2;
    valid_flags: HardwareStatusFlags, at 3;
}

constructors! {
    HardwareStatus

    /// Creates it from its values.
    fn new(
        receiver_state: ReceiverState,
        antenna_state: AntennaState,
        antenna_power: AntennaPower,
        valid_flags: HardwareStatusFlags,
    );
}

valid! {
    HardwareStatus
    receiver_state_is_valid "receiver_state": valid_flags 0x1;
    antenna_state_is_valid "antenna_state": valid_flags 0x2;
    antenna_power_is_valid "antenna_power": valid_flags 0x4;
}

field! {
    HardwareStatus: 0x0D, "gnss_data.hardware_status";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// DGPS info (0x0E).
    ///
    /// State of the differential corrections.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). The size of its data distinguishes it from
    /// [`DgpsInfoSatellite`]. Confirmed on [3DM-GX5-35](crate::devices::GX5_35) and
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 1 more. Uncertain: Devices could
    /// also send [`DgpsInfoSatellite`], the layout of the SDK, but only this one agrees with the
    /// valid flags, which are the same in all sources.
    ///
    /// - The sources contradict each other. This layout is in a manual of the 3DM-GX5-35, in MSCL
    ///   and in the SDK of 2014.
    ///
    /// Source: 3dm-gx5-35: 5.2.12 DGNSS Information (0x81, 0x0E); mscl: DGPS Info (0x81,0x0E);
    /// mip-sdk-2014: DGPS Info (0x81,0x0E).
    #[derive(Copy, Default)]
    pub struct DgpsInfo {
        /// Age of the corrections.
        ///
        /// Unit: s. Range: at least 0. Valid if [`valid_flags.age`](DgpsInfoFlags::age) is set.
        /// Uncertain: The unit is that of [`DgpsChannel`]; no source states it here.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub age: f32,
        /// Number of the base station.
        ///
        /// Valid if [`valid_flags.base_station_id`](DgpsInfoFlags::base_station_id) is set.
        pub base_station_id: i16,
        /// State of the base station: 0 to 5 are factors of the user differential range error,
        /// which are 1.0, 0.75, 0.5, 0.3, 0.2 and 0.1; 6 is not monitored, 7 not working.
        ///
        /// Valid if [`valid_flags.base_station_status`](DgpsInfoFlags::base_station_status) is set.
        pub base_station_status: i16,
        /// Number of channels that have corrections.
        ///
        /// Unit: 1. Valid if [`valid_flags.num_channels`](DgpsInfoFlags::num_channels) is set.
        pub num_channels: u16,
        /// Validity flags for the state of the corrections.
        pub valid_flags: DgpsInfoFlags,
    }
}

view! {
    DgpsInfo
    age: f32, at 0;
    base_station_id: i16, at 4;
    base_station_status: i16, at 6;
    num_channels: u16, at 8;
    valid_flags: DgpsInfoFlags, at 10;
}

constructors! {
    DgpsInfo

    /// Creates it from its values.
    fn new(
        age: f32,
        base_station_id: i16,
        base_station_status: i16,
        num_channels: u16,
        valid_flags: DgpsInfoFlags,
    );
}

valid! {
    DgpsInfo
    age_is_valid "age": valid_flags 0x1;
    base_station_id_is_valid "base_station_id": valid_flags 0x2;
    base_station_status_is_valid "base_station_status": valid_flags 0x4;
    num_channels_is_valid "num_channels": valid_flags 0x8;
}

field! {
    DgpsInfo: 0x0E, "gnss_data.dgps_info";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
    sizes 0..=14;
}

record! {
    /// DGPS info for one satellite (0x0E).
    ///
    /// Differential correction for one satellite, in the SDK's layout of DGPS info.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). The size of its data distinguishes it from
    /// [`DgpsInfo`]. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
    /// Uncertain: Possibly no device sends it: the values are those of [`DgpsChannel`], but the
    /// flags those of [`DgpsInfo`], so a mistake in the SDK is likely.
    ///
    /// - The sources contradict each other. The manual of the 3DM-GX5-35 and MSCL document
    ///   [`DgpsInfo`] instead.
    /// - The flags of `base_station_id`, `base_station_status` and `num_channels` correspond to no
    ///   value in this layout.
    ///
    /// Source: mip-sdk-4: Dgps Info (0x81,0x0E).
    #[derive(Copy, Default)]
    pub struct DgpsInfoSatellite {
        /// Number of the satellite.
        pub satellite_id: u8,
        /// Age of the correction.
        ///
        /// Unit: s. Range: at least 0. Valid if [`valid_flags.age`](DgpsInfoFlags::age) is set.
        /// Uncertain: The unit is that of [`DgpsChannel`]; no source states it here.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub age: f32,
        /// Differential correction of the pseudorange.
        ///
        /// Unit: m. Uncertain: The unit is that of [`DgpsChannel`]; no source states it here.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub range_correction: f32,
        /// Rate of change of the correction.
        ///
        /// Unit: m/s. Uncertain: The unit is that of [`DgpsChannel`]; no source states it here.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub range_rate_correction: f32,
        /// Validity flags for the state of the corrections.
        pub valid_flags: DgpsInfoFlags,
    }
}

view! {
    DgpsInfoSatellite
    satellite_id: u8, at 0;
    age: f32, at 1;
    range_correction: f32, at 5;
    range_rate_correction: f32, at 9;
    valid_flags: DgpsInfoFlags, at 13;
}

constructors! {
    DgpsInfoSatellite

    /// Creates it from its values.
    fn new(
        satellite_id: u8,
        age: f32,
        range_correction: f32,
        range_rate_correction: f32,
        valid_flags: DgpsInfoFlags,
    );
}

valid! {
    DgpsInfoSatellite
    age_is_valid "age": valid_flags 0x1;
}

field! {
    DgpsInfoSatellite: 0x0E, "gnss_data.dgps_info_satellite";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
    sizes 15..=usize::MAX;
}

record! {
    /// DGPS channel (0x0F).
    ///
    /// Differential correction for one satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-GX5-45](crate::devices::GX5_45); likely or assumed on 2 more. Known only from the MIP
    /// SDK of 2014, MicroStrain Communication Library and MicroStrain MIP SDK.
    ///
    /// - Each active satellite is sent as one field, all in one packet.
    ///
    /// Source: mip-sdk-4: Dgps Channel (0x81,0x0F); mscl: DGPS Channel Status (0x81,0x0F);
    /// mip-sdk-2014: DGPS Channel (0x81,0x0F).
    #[derive(Copy, Default)]
    pub struct DgpsChannel {
        /// Number of the satellite.
        ///
        /// Valid if [`valid_flags.satellite_id`](DgpsChannelFlags::satellite_id) is set.
        pub satellite_id: u8,
        /// Age of the correction.
        ///
        /// Unit: s. Range: at least 0. Valid if [`valid_flags.age`](DgpsChannelFlags::age) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub age: f32,
        /// Differential correction of the pseudorange.
        ///
        /// Unit: m. Valid if [`valid_flags.range_correction`](DgpsChannelFlags::range_correction)
        /// is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub range_correction: f32,
        /// Rate of change of the correction.
        ///
        /// Unit: m/s. Valid if
        /// [`valid_flags.range_rate_correction`](DgpsChannelFlags::range_rate_correction) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub range_rate_correction: f32,
        /// Validity flags for a differential correction.
        pub valid_flags: DgpsChannelFlags,
    }
}

view! {
    DgpsChannel
    satellite_id: u8, at 0;
    age: f32, at 1;
    range_correction: f32, at 5;
    range_rate_correction: f32, at 9;
    valid_flags: DgpsChannelFlags, at 13;
}

constructors! {
    DgpsChannel

    /// Creates it from its values.
    fn new(
        satellite_id: u8,
        age: f32,
        range_correction: f32,
        range_rate_correction: f32,
        valid_flags: DgpsChannelFlags,
    );
}

valid! {
    DgpsChannel
    satellite_id_is_valid "satellite_id": valid_flags 0x1;
    age_is_valid "age": valid_flags 0x2;
    range_correction_is_valid "range_correction": valid_flags 0x4;
    range_rate_correction_is_valid "range_rate_correction": valid_flags 0x8;
}

field! {
    DgpsChannel: 0x0F, "gnss_data.dgps_channel";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Clock info 2 (0x10).
    ///
    /// Bias and drift of the receiver clock.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 1 more. Uncertain: The units are inferred from those of the
    /// ephemerides; no source states them.
    ///
    /// - It supersedes clock info.
    ///
    /// Source: 3dm-cv7-gnss-ins: Clock Info 2 (0x91,0x10); 3dm-cv7-gnss-ins: Clock Info 2
    /// (0x92,0x10).
    #[derive(Copy, Default)]
    pub struct ClockInfo2 {
        /// Bias of the clock.
        ///
        /// Unit: s. Valid if [`valid_flags.bias`](ClockInfo2Flags::bias) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias: f64,
        /// Drift of the clock.
        ///
        /// Unit: s/s. Valid if [`valid_flags.drift`](ClockInfo2Flags::drift) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub drift: f64,
        /// Estimated error of the bias.
        ///
        /// Unit: s. Range: at least 0. Valid if
        /// [`valid_flags.bias_accuracy`](ClockInfo2Flags::bias_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub bias_accuracy_estimate: f64,
        /// Estimated error of the drift.
        ///
        /// Unit: s/s. Range: at least 0. Valid if
        /// [`valid_flags.drift_accuracy`](ClockInfo2Flags::drift_accuracy) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub drift_accuracy_estimate: f64,
        /// Validity flags for the clock parameters.
        pub valid_flags: ClockInfo2Flags,
    }
}

view! {
    ClockInfo2
    bias: f64, at 0;
    drift: f64, at 8;
    bias_accuracy_estimate: f64, at 16;
    drift_accuracy_estimate: f64, at 24;
    valid_flags: ClockInfo2Flags, at 32;
}

constructors! {
    ClockInfo2

    /// Creates it from its values.
    fn new(
        bias: f64,
        drift: f64,
        bias_accuracy_estimate: f64,
        drift_accuracy_estimate: f64,
        valid_flags: ClockInfo2Flags,
    );
}

valid! {
    ClockInfo2
    bias_is_valid "bias": valid_flags 0x1;
    drift_is_valid "drift": valid_flags 0x2;
    bias_accuracy_estimate_is_valid "bias_accuracy_estimate": valid_flags 0x4;
    drift_accuracy_estimate_is_valid "drift_accuracy_estimate": valid_flags 0x8;
}

field! {
    ClockInfo2: 0x10, "gnss_data.clock_info_2";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GPS leap seconds (0x11).
    ///
    /// Difference between GPS time and UTC.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 1 more.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Leap Seconds (0x91,0x11); 3dm-cv7-gnss-ins: GPS Leap Seconds
    /// (0x92,0x11).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct GpsLeapSeconds {
        /// GPS time minus UTC.
        ///
        /// Unit: s. Valid if [`valid_flags.leap_seconds`](GpsLeapSecondsFlags::leap_seconds) is
        /// set.
        pub leap_seconds: u8,
        /// Validity of the leap seconds.
        pub valid_flags: GpsLeapSecondsFlags,
    }
}

view! {
    GpsLeapSeconds
    leap_seconds: u8, at 0;
    valid_flags: GpsLeapSecondsFlags, at 1;
}

constructors! {
    GpsLeapSeconds

    /// Creates it from its values.
    fn new(leap_seconds: u8, valid_flags: GpsLeapSecondsFlags);
}

valid! {
    GpsLeapSeconds
    leap_seconds_is_valid "leap_seconds": valid_flags 0x2;
}

field! {
    GpsLeapSeconds: 0x11, "gnss_data.gps_leap_seconds";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// SBAS info (0x12).
    ///
    /// Status of the satellite-based augmentation (SBAS).
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// Source: 3dm-cv7-gnss-ins: SBAS Info (0x91,0x12); 3dm-cv7-gnss-ins: SBAS Info (0x92,0x12).
    #[derive(Copy, Default)]
    pub struct SbasInfo {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](SbasInfoFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        /// Validity flags for the SBAS status.
        pub valid_flags: SbasInfoFlags,
    }
}

view! {
    SbasInfo
    tow: f64, at 0;
    week_number: u16, at 8;
    sbas_system: SbasSystem, at 10;
    sbas_id: u8, at 11;
    count: u8, at 12;
    sbas_status: SbasStatus, at 13;
    valid_flags: SbasInfoFlags, at 14;
}

constructors! {
    SbasInfo

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        sbas_system: SbasSystem,
        sbas_id: u8,
        count: u8,
        sbas_status: SbasStatus,
        valid_flags: SbasInfoFlags,
    );
}

valid! {
    SbasInfo
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    sbas_system_is_valid "sbas_system": valid_flags 0x4;
    sbas_id_is_valid "sbas_id": valid_flags 0x8;
    count_is_valid "count": valid_flags 0x10;
    sbas_status_is_valid "sbas_status": valid_flags 0x20;
}

field! {
    SbasInfo: 0x12, "gnss_data.sbas_info";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// SBAS correction (0x13).
    ///
    /// SBAS correction for one satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known
    /// only from the MicroStrain MIP SDK.
    ///
    /// - An epoch is sent as one field for each satellite; `index` and `count` number the fields.
    /// - For `udrei` 0 to 13, the variances in m^2 are 0.0520, 0.0924, 0.1444, 0.2830, 0.4678,
    ///   0.8315, 1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870, 230.9661, 2078.695.
    ///
    /// Source: mip-sdk-4: Sbas Correction (0x81,0x13).
    #[derive(Copy, Default)]
    pub struct SbasCorrection {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week of the reception.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
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
        /// Range: 0 to 15. Valid if [`valid_flags.udrei`](SbasCorrectionFlags::udrei) is set.
        pub udrei: u8,
        /// Correction of the pseudorange by the augmentation system.
        ///
        /// Unit: m. Valid if
        /// [`valid_flags.pseudorange_correction`](SbasCorrectionFlags::pseudorange_correction) is
        /// set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pseudorange_correction: f32,
        /// Correction of the ionospheric delay.
        ///
        /// Unit: m. Valid if [`valid_flags.iono_correction`](SbasCorrectionFlags::iono_correction)
        /// is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub iono_correction: f32,
        /// Validity flags for an SBAS correction.
        pub valid_flags: SbasCorrectionFlags,
    }
}

view! {
    SbasCorrection
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    gnss_id: types::GnssConstellation, at 12;
    satellite_id: u8, at 13;
    udrei: u8, at 14;
    pseudorange_correction: f32, at 15;
    iono_correction: f32, at 19;
    valid_flags: SbasCorrectionFlags, at 23;
}

constructors! {
    SbasCorrection

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        gnss_id: types::GnssConstellation,
        satellite_id: u8,
        udrei: u8,
        pseudorange_correction: f32,
        iono_correction: f32,
        valid_flags: SbasCorrectionFlags,
    );
}

valid! {
    SbasCorrection
    udrei_is_valid "udrei": valid_flags 0x1;
    pseudorange_correction_is_valid "pseudorange_correction": valid_flags 0x2;
    iono_correction_is_valid "iono_correction": valid_flags 0x4;
}

field! {
    SbasCorrection: 0x13, "gnss_data.sbas_correction";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// RF error detection (0x14).
    ///
    /// Jamming and spoofing that the receiver detects in one band.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Supported by
    /// [3DM-CV7-INS](crate::devices::CV7_INS) and [3DM-GQ7-GNSS/INS](crate::devices::GQ7). Known
    /// only from the MicroStrain MIP SDK.
    ///
    /// - Version 4.0.0 of the SDK reserves the two bytes of `frequency`. Firmware from that time
    ///   sends 0 there and does not set its flag.
    ///
    /// Source: mip-sdk-4: Rf Error Detection (0x81,0x14).
    #[derive(Copy, Default, Eq, Hash)]
    pub struct RfErrorDetection {
        /// Band to which the states apply.
        ///
        /// Valid if [`valid_flags.rf_band`](RfErrorDetectionFlags::rf_band) is set.
        pub rf_band: RfBand,
        /// State of jamming in this band.
        ///
        /// Valid if [`valid_flags.jamming_state`](RfErrorDetectionFlags::jamming_state) is set.
        pub jamming_state: JammingState,
        /// State of spoofing in this band.
        ///
        /// Valid if [`valid_flags.spoofing_state`](RfErrorDetectionFlags::spoofing_state) is set.
        pub spoofing_state: SpoofingState,
        /// Centre frequency of the band.
        ///
        /// Unit: MHz. Valid if [`valid_flags.frequency`](RfErrorDetectionFlags::frequency) is set.
        pub frequency: u16,
        /// Reserved.
        pub reserved: [u8; 2],
        /// Validity flags for the detection.
        pub valid_flags: RfErrorDetectionFlags,
    }
}

view! {
    RfErrorDetection
    rf_band: RfBand, at 0;
    jamming_state: JammingState, at 1;
    spoofing_state: SpoofingState, at 2;
    frequency: u16, at 3;
    reserved: [u8; 2], at 5;
    valid_flags: RfErrorDetectionFlags, at 7;
}

constructors! {
    RfErrorDetection

    /// Creates it from its values.
    fn new(
        rf_band: RfBand,
        jamming_state: JammingState,
        spoofing_state: SpoofingState,
        frequency: u16,
        valid_flags: RfErrorDetectionFlags,
    ), reserved: [0; 2];
}

valid! {
    RfErrorDetection
    rf_band_is_valid "rf_band": valid_flags 0x1;
    jamming_state_is_valid "jamming_state": valid_flags 0x2;
    spoofing_state_is_valid "spoofing_state": valid_flags 0x4;
    frequency_is_valid "frequency": valid_flags 0x8;
}

field! {
    RfErrorDetection: 0x14, "gnss_data.rf_error_detection";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GNSS heading (0x15).
    ///
    /// Heading that the receiver computes from its antennas.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Not listed in any device profile. Known
    /// only from the MicroStrain MIP SDK. Uncertain: The SDK names no device that sends it.
    ///
    /// Source: mip-sdk-4: Heading (0x81,0x15).
    #[derive(Copy, Default)]
    pub struct Heading {
        /// Heading of the baseline between the antennas, from true north.
        ///
        /// Unit: deg. Frame: ned. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.heading`](HeadingFlags::heading) is set. Uncertain: Clockwise from true
        /// north is usual; the SDK only states degrees, and no range. Uncertain: No source states
        /// from which antenna to which the baseline points. The opposite one differs by 180
        /// degrees.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub heading: f32,
        /// Uncertainty of the heading.
        ///
        /// Unit: deg. Range: at least 0. Valid if
        /// [`valid_flags.uncertainty`](HeadingFlags::uncertainty) is set. Uncertain: It is not
        /// known whether this is one standard deviation.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub uncertainty: f32,
        /// Kind of the fix.
        ///
        /// Valid if [`valid_flags.fix_type`](HeadingFlags::fix_type) is set.
        pub fix_type: HeadingFixType,
        /// Validity flags for the heading.
        pub valid_flags: HeadingFlags,
    }
}

view! {
    Heading
    heading: f32, at 0;
    uncertainty: f32, at 4;
    fix_type: HeadingFixType, at 8;
    valid_flags: HeadingFlags, at 9;
}

constructors! {
    Heading

    /// Creates it from its values.
    fn new(
        heading: f32,
        uncertainty: f32,
        fix_type: HeadingFixType,
        valid_flags: HeadingFlags,
    );
}

valid! {
    Heading
    heading_is_valid "heading": valid_flags 0x1;
    uncertainty_is_valid "uncertainty": valid_flags 0x2;
    fix_type_is_valid "fix_type": valid_flags 0x4;
}

field! {
    Heading: 0x15, "gnss_data.heading";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Satellite status (0x20).
    ///
    /// Direction to one satellite, and its health.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and [3DM-CV7-INS](crate::devices::CV7_INS);
    /// likely or assumed on 3 more.
    ///
    /// - An epoch is sent as one field for each satellite; `index` and `count` number the fields.
    ///
    /// Source: 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20); 3dm-cv7-gnss-ins: Satellite Status
    /// (0x92,0x20); 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20).
    #[derive(Copy, Default)]
    pub struct SatelliteStatus {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](SatelliteStatusFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        /// Angle between the horizon and the satellite, seen from the rover.
        ///
        /// Unit: deg. Frame: ned. Range: -90 to 90. Positive: above the horizon. Valid if
        /// [`valid_flags.elevation`](SatelliteStatusFlags::elevation) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub elevation: f32,
        /// Direction of the satellite from the rover, from true north.
        ///
        /// Unit: deg. Frame: ned. Positive: clockwise seen from above. Valid if
        /// [`valid_flags.azimuth`](SatelliteStatusFlags::azimuth) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub azimuth: f32,
        /// True if the satellite is healthy.
        ///
        /// Valid if [`valid_flags.health`](SatelliteStatusFlags::health) is set.
        pub health: crate::Bool,
        /// Validity flags for the satellite status.
        pub valid_flags: SatelliteStatusFlags,
    }
}

view! {
    SatelliteStatus
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    gnss_id: types::GnssConstellation, at 12;
    satellite_id: u8, at 13;
    elevation: f32, at 14;
    azimuth: f32, at 18;
    health: crate::Bool, at 22;
    valid_flags: SatelliteStatusFlags, at 23;
}

constructors! {
    SatelliteStatus

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        gnss_id: types::GnssConstellation,
        satellite_id: u8,
        elevation: f32,
        azimuth: f32,
        health: bool,
        valid_flags: SatelliteStatusFlags,
    );
}

valid! {
    SatelliteStatus
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    gnss_id_is_valid "gnss_id": valid_flags 0x4;
    satellite_id_is_valid "satellite_id": valid_flags 0x8;
    elevation_is_valid "elevation": valid_flags 0x10;
    azimuth_is_valid "azimuth": valid_flags 0x20;
    health_is_valid "health": valid_flags 0x40;
}

field! {
    SatelliteStatus: 0x20, "gnss_data.satellite_status";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Raw (0x22).
    ///
    /// Raw observation of one signal of one satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - An epoch is sent as one field for each signal; `index` and `count` number the fields.
    /// - The greatest lock time depends on the receiver.
    ///
    /// Source: 3dm-cv7-gnss-ins: Raw (0x91,0x22); 3dm-cv7-gnss-ins: Raw (0x92,0x22).
    #[derive(Copy, Default)]
    pub struct Raw {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](RawFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        /// Signal of the satellite that was tracked.
        ///
        /// Valid if [`valid_flags.signal_id`](RawFlags::signal_id) is set.
        pub signal_id: types::GnssSignal,
        /// Carrier to noise density ratio.
        ///
        /// Unit: dB-Hz. Valid if [`valid_flags.signal_strength`](RawFlags::signal_strength) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub signal_strength: f32,
        /// Tracking quality of the signal.
        ///
        /// Valid if [`valid_flags.quality`](RawFlags::quality) is set.
        pub quality: SignalQuality,
        /// Measured distance, with the clock errors of receiver and satellite.
        ///
        /// Unit: m. Range: at least 0. Valid if [`valid_flags.pseudorange`](RawFlags::pseudorange)
        /// is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub pseudorange: f64,
        /// Accumulated phase of the carrier; its initial number of cycles is arbitrary.
        ///
        /// Unit: cycle. Valid if [`valid_flags.carrier_phase`](RawFlags::carrier_phase) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub carrier_phase: f64,
        /// Doppler shift.
        ///
        /// Unit: Hz. Valid if [`valid_flags.doppler`](RawFlags::doppler) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub doppler: f32,
        /// Uncertainty of the pseudorange.
        ///
        /// Unit: m. Range: at least 0. Valid if
        /// [`valid_flags.range_uncertainty`](RawFlags::range_uncertainty) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub range_uncertainty: f32,
        /// Uncertainty of the carrier phase.
        ///
        /// Unit: cycle. Range: at least 0. Valid if
        /// [`valid_flags.carrier_phase_uncertainty`](RawFlags::carrier_phase_uncertainty) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub phase_uncertainty: f32,
        /// Uncertainty of the Doppler shift.
        ///
        /// Unit: Hz. Range: at least 0. Valid if
        /// [`valid_flags.doppler_uncertainty`](RawFlags::doppler_uncertainty) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub doppler_uncertainty: f32,
        /// Minimum time for which the carrier phase has been locked.
        ///
        /// Unit: s. Range: at least 0. Valid if [`valid_flags.lock_time`](RawFlags::lock_time) is
        /// set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub lock_time: f32,
        /// Validity flags for the observation.
        pub valid_flags: RawFlags,
    }
}

view! {
    Raw
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    receiver_id: u16, at 12;
    tracking_channel: u8, at 14;
    gnss_id: types::GnssConstellation, at 15;
    satellite_id: u8, at 16;
    signal_id: types::GnssSignal, at 17;
    signal_strength: f32, at 18;
    quality: SignalQuality, at 22;
    pseudorange: f64, at 23;
    carrier_phase: f64, at 31;
    doppler: f32, at 39;
    range_uncertainty: f32, at 43;
    phase_uncertainty: f32, at 47;
    doppler_uncertainty: f32, at 51;
    lock_time: f32, at 55;
    valid_flags: RawFlags, at 59;
}

constructors! {
    Raw

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        receiver_id: u16,
        tracking_channel: u8,
        gnss_id: types::GnssConstellation,
        satellite_id: u8,
        signal_id: types::GnssSignal,
        signal_strength: f32,
        quality: SignalQuality,
        pseudorange: f64,
        carrier_phase: f64,
        doppler: f32,
        range_uncertainty: f32,
        phase_uncertainty: f32,
        doppler_uncertainty: f32,
        lock_time: f32,
        valid_flags: RawFlags,
    );
}

valid! {
    Raw
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    receiver_id_is_valid "receiver_id": valid_flags 0x4;
    tracking_channel_is_valid "tracking_channel": valid_flags 0x8;
    gnss_id_is_valid "gnss_id": valid_flags 0x10;
    satellite_id_is_valid "satellite_id": valid_flags 0x20;
    signal_id_is_valid "signal_id": valid_flags 0x40;
    signal_strength_is_valid "signal_strength": valid_flags 0x80;
    quality_is_valid "quality": valid_flags 0x100;
    pseudorange_is_valid "pseudorange": valid_flags 0x200;
    carrier_phase_is_valid "carrier_phase": valid_flags 0x400;
    doppler_is_valid "doppler": valid_flags 0x800;
    range_uncertainty_is_valid "range_uncertainty": valid_flags 0x1000;
    phase_uncertainty_is_valid "phase_uncertainty": valid_flags 0x2000;
    doppler_uncertainty_is_valid "doppler_uncertainty": valid_flags 0x4000;
    lock_time_is_valid "lock_time": valid_flags 0x8000;
}

field! {
    Raw: 0x22, "gnss_data.raw";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Base station info (0x30).
    ///
    /// Base station that sends the corrections, from RTCM message 1005 or 1006.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// Source: mip-sdk-4: Base Station Info (0x81,0x30); 3dm-cv7-gnss-ins: Base Station Info
    /// (0x93,0x30).
    #[derive(Copy, Default)]
    pub struct BaseStationInfo {
        /// GPS time of week at which the message was received.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](BaseStationInfoFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](BaseStationInfoFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// Position of the station.
        ///
        /// Elements: x, y, z. Unit: m. Frame: ecef. Valid if
        /// [`valid_flags.ecef_position`](BaseStationInfoFlags::ecef_position) is set.
        pub ecef_position: types::Vector3d,
        /// Height of the antenna above the surveyed marker.
        ///
        /// Unit: m. Valid if [`valid_flags.height`](BaseStationInfoFlags::height) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
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
        /// Valid values.
        pub valid_flags: BaseStationInfoFlags,
    }
}

view! {
    BaseStationInfo
    tow: f64, at 0;
    week_number: u16, at 8;
    ecef_position: types::Vector3d, at 10;
    height: f32, at 34;
    station_id: u16, at 38;
    indicators: BaseStationIndicators, at 40;
    valid_flags: BaseStationInfoFlags, at 42;
}

constructors! {
    BaseStationInfo

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        ecef_position: impl Into<types::Vector3d>,
        height: f32,
        station_id: u16,
        indicators: BaseStationIndicators,
        valid_flags: BaseStationInfoFlags,
    );
}

valid! {
    BaseStationInfo
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    ecef_position_is_valid "ecef_position": valid_flags 0x4;
    height_is_valid "height": valid_flags 0x8;
    station_id_is_valid "station_id": valid_flags 0x10;
    indicators_is_valid "indicators": valid_flags 0x20;
}

field! {
    BaseStationInfo: 0x30, "gnss_data.base_station_info";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// RTK corrections status (0x31).
    ///
    /// Received corrections and their age.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Supported by
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS) and
    /// [3DM-GQ7-GNSS/INS](crate::devices::GQ7).
    ///
    /// Source: mip-sdk-4: Rtk Corrections Status (0x81,0x31); 3dm-cv7-gnss-ins: RTK Corrections
    /// Status (0x93,0x31).
    #[derive(Copy, Default)]
    pub struct RtkCorrectionsStatus {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](RtkCorrectionsStatusFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](RtkCorrectionsStatusFlags::week_number)
        /// is set.
        pub week_number: u16,
        /// Corrections received during this epoch.
        ///
        /// Valid if [`valid_flags.epoch_status`](RtkCorrectionsStatusFlags::epoch_status) is set.
        pub epoch_status: RtkEpochStatus,
        /// Status flags of the RTK dongle, meaningful only if one is connected.
        ///
        /// Valid if [`valid_flags.dongle_status`](RtkCorrectionsStatusFlags::dongle_status) is set.
        ///
        /// - The same word as in the response to
        ///   [`rtk::GetStatusFlags`](crate::rtk::GetStatusFlags), in one of its two forms.
        pub dongle_status: types::RtkStatusFlags,
        /// Latency of the last GPS correction.
        ///
        /// Unit: s. Range: at least 0. Valid if
        /// [`valid_flags.gps_latency`](RtkCorrectionsStatusFlags::gps_latency) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub gps_correction_latency: f32,
        /// Latency of the last GLONASS correction.
        ///
        /// Unit: s. Range: at least 0. Valid if
        /// [`valid_flags.glonass_latency`](RtkCorrectionsStatusFlags::glonass_latency) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub glonass_correction_latency: f32,
        /// Latency of the last Galileo correction.
        ///
        /// Unit: s. Range: at least 0. Valid if
        /// [`valid_flags.galileo_latency`](RtkCorrectionsStatusFlags::galileo_latency) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub galileo_correction_latency: f32,
        /// Latency of the last BeiDou correction.
        ///
        /// Unit: s. Range: at least 0. Valid if
        /// [`valid_flags.beidou_latency`](RtkCorrectionsStatusFlags::beidou_latency) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub beidou_correction_latency: f32,
        /// Reserved.
        pub reserved: [u32; 4],
        /// Valid values.
        pub valid_flags: RtkCorrectionsStatusFlags,
    }
}

view! {
    RtkCorrectionsStatus
    tow: f64, at 0;
    week_number: u16, at 8;
    epoch_status: RtkEpochStatus, at 10;
    dongle_status: types::RtkStatusFlags, at 12;
    gps_correction_latency: f32, at 16;
    glonass_correction_latency: f32, at 20;
    galileo_correction_latency: f32, at 24;
    beidou_correction_latency: f32, at 28;
    reserved: [u32; 4], at 32;
    valid_flags: RtkCorrectionsStatusFlags, at 48;
}

constructors! {
    RtkCorrectionsStatus

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        epoch_status: RtkEpochStatus,
        dongle_status: types::RtkStatusFlags,
        gps_correction_latency: f32,
        glonass_correction_latency: f32,
        galileo_correction_latency: f32,
        beidou_correction_latency: f32,
        valid_flags: RtkCorrectionsStatusFlags,
    ), reserved: [0; 4];
}

valid! {
    RtkCorrectionsStatus
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    epoch_status_is_valid "epoch_status": valid_flags 0x4;
    dongle_status_is_valid "dongle_status": valid_flags 0x8;
    gps_correction_latency_is_valid "gps_correction_latency": valid_flags 0x10;
    glonass_correction_latency_is_valid "glonass_correction_latency": valid_flags 0x20;
    galileo_correction_latency_is_valid "galileo_correction_latency": valid_flags 0x40;
    beidou_correction_latency_is_valid "beidou_correction_latency": valid_flags 0x80;
}

field! {
    RtkCorrectionsStatus: 0x31, "gnss_data.rtk_corrections_status";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GPS ephemeris (0x61).
    ///
    /// Broadcast orbit and clock of one GPS satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - `iodc` changes with the clock data; according to the manual, it rolls over at 4.
    ///
    /// Source: 3dm-cv7-gnss-ins: GPS Ephemeris (0x91,0x61); 3dm-cv7-gnss-ins: GPS Ephemeris
    /// (0x92,0x61).
    #[derive(Default)]
    pub struct GpsEphemeris {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        pub iodc: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_gd: f64,
        /// Inter-signal correction for L1.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub isc_l1ca: f64,
        /// Inter-signal correction for L2, or for L5 if `isc_l5` is set.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Range: greater than 0. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub a_dot: f64,
        /// Mean anomaly at the reference time.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub delta_mean_motion_dot: f64,
        /// Eccentricity of the orbit.
        ///
        /// Unit: 1. Range: at least 0, less than 1. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub eccentricity: f64,
        /// Angle from the ascending node to the perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub omega_dot: f64,
        /// Inclination of the orbit at the reference time.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_rs: f64,
        /// Contents of the ephemeris.
        pub valid_flags: EphemerisFlags,
    }
}

view! {
    GpsEphemeris
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    satellite_id: u8, at 12;
    health: u8, at 13;
    iodc: u8, at 14;
    iode: u8, at 15;
    t_oc: f64, at 16;
    af0: f64, at 24;
    af1: f64, at 32;
    af2: f64, at 40;
    t_gd: f64, at 48;
    isc_l1ca: f64, at 56;
    isc_l2c: f64, at 64;
    t_oe: f64, at 72;
    a: f64, at 80;
    a_dot: f64, at 88;
    mean_anomaly: f64, at 96;
    delta_mean_motion: f64, at 104;
    delta_mean_motion_dot: f64, at 112;
    eccentricity: f64, at 120;
    argument_of_perigee: f64, at 128;
    omega: f64, at 136;
    omega_dot: f64, at 144;
    inclination: f64, at 152;
    inclination_dot: f64, at 160;
    c_ic: f64, at 168;
    c_is: f64, at 176;
    c_uc: f64, at 184;
    c_us: f64, at 192;
    c_rc: f64, at 200;
    c_rs: f64, at 208;
    valid_flags: EphemerisFlags, at 216;
}

constructors! {
    GpsEphemeris

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        satellite_id: u8,
        health: u8,
        iodc: u8,
        iode: u8,
        t_oc: f64,
        af0: f64,
        af1: f64,
        af2: f64,
        t_gd: f64,
        isc_l1ca: f64,
        isc_l2c: f64,
        t_oe: f64,
        a: f64,
        a_dot: f64,
        mean_anomaly: f64,
        delta_mean_motion: f64,
        delta_mean_motion_dot: f64,
        eccentricity: f64,
        argument_of_perigee: f64,
        omega: f64,
        omega_dot: f64,
        inclination: f64,
        inclination_dot: f64,
        c_ic: f64,
        c_is: f64,
        c_uc: f64,
        c_us: f64,
        c_rc: f64,
        c_rs: f64,
        valid_flags: EphemerisFlags,
    );
}

valid! {
    GpsEphemeris
    health_is_valid "health": valid_flags 0x1;
    iodc_is_valid "iodc": valid_flags 0x1;
    iode_is_valid "iode": valid_flags 0x1;
    t_oc_is_valid "t_oc": valid_flags 0x1;
    af0_is_valid "af0": valid_flags 0x1;
    af1_is_valid "af1": valid_flags 0x1;
    af2_is_valid "af2": valid_flags 0x1;
    t_gd_is_valid "t_gd": valid_flags 0x1;
    isc_l1ca_is_valid "isc_l1ca": valid_flags 0x1;
    isc_l2c_is_valid "isc_l2c": valid_flags 0x1;
    t_oe_is_valid "t_oe": valid_flags 0x1;
    a_is_valid "a": valid_flags 0x1;
    a_dot_is_valid "a_dot": valid_flags 0x1;
    mean_anomaly_is_valid "mean_anomaly": valid_flags 0x1;
    delta_mean_motion_is_valid "delta_mean_motion": valid_flags 0x1;
    delta_mean_motion_dot_is_valid "delta_mean_motion_dot": valid_flags 0x1;
    eccentricity_is_valid "eccentricity": valid_flags 0x1;
    argument_of_perigee_is_valid "argument_of_perigee": valid_flags 0x1;
    omega_is_valid "omega": valid_flags 0x1;
    omega_dot_is_valid "omega_dot": valid_flags 0x1;
    inclination_is_valid "inclination": valid_flags 0x1;
    inclination_dot_is_valid "inclination_dot": valid_flags 0x1;
    c_ic_is_valid "c_ic": valid_flags 0x1;
    c_is_is_valid "c_is": valid_flags 0x1;
    c_uc_is_valid "c_uc": valid_flags 0x1;
    c_us_is_valid "c_us": valid_flags 0x1;
    c_rc_is_valid "c_rc": valid_flags 0x1;
    c_rs_is_valid "c_rs": valid_flags 0x1;
}

field! {
    GpsEphemeris: 0x61, "gnss_data.gps_ephemeris";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GLONASS ephemeris (0x62).
    ///
    /// Broadcast orbit and clock of one GLONASS satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `glo_ephemeris`. Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - The GLONASS interface control document explains p and ft.
    /// - A period of four years has 1461 days; no source states how nt, a u8, counts them.
    ///
    /// Source: 3dm-cv7-gnss-ins: Glonass Ephemeris (0x91,0x62); 3dm-cv7-gnss-ins: Glonass Ephemeris
    /// (0x92,0x62).
    #[derive(Default)]
    pub struct GlonassEphemeris {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        pub frequency_number: i8,
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
        pub satellite_type: GlonassSatelliteType,
        /// Relative deviation of the carrier frequency from its nominal value.
        ///
        /// Unit: 1. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub gamma: f64,
        /// Correction of the satellite time relative to GLONASS time.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tau_n: f64,
        /// Position of the satellite in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m. Valid if
        /// [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub position: types::Vector3d,
        /// Velocity of the satellite in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m/s. Valid if
        /// [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub velocity: types::Vector3f,
        /// Acceleration of the satellite due to perturbations, in PZ-90.
        ///
        /// Elements: x, y, z. Unit: m/s^2. Valid if
        /// [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub accel: types::Vector3f,
        /// Health (Bn); nonzero if the satellite is malfunctioning.
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
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
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
        /// Presence of ephemeris parameters.
        ///
        /// Valid if [`valid_flags.ephemeris`](GlonassEphemerisFlags::ephemeris) is set.
        pub p4: u8,
        /// Validity of the ephemeris.
        pub valid_flags: GlonassEphemerisFlags,
    }
}

view! {
    GlonassEphemeris
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    satellite_id: u8, at 12;
    frequency_number: i8, at 13;
    tk: u32, at 14;
    tb: u32, at 18;
    satellite_type: GlonassSatelliteType, at 22;
    gamma: f64, at 23;
    tau_n: f64, at 31;
    position: types::Vector3d, at 39;
    velocity: types::Vector3f, at 63;
    accel: types::Vector3f, at 75;
    health: u8, at 87;
    p: u8, at 88;
    nt: u8, at 89;
    delta_tau_n: f32, at 90;
    ft: u8, at 94;
    en: u8, at 95;
    p1: u8, at 96;
    p2: u8, at 97;
    p3: u8, at 98;
    p4: u8, at 99;
    valid_flags: GlonassEphemerisFlags, at 100;
}

constructors! {
    GlonassEphemeris

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        satellite_id: u8,
        frequency_number: i8,
        tk: u32,
        tb: u32,
        satellite_type: GlonassSatelliteType,
        gamma: f64,
        tau_n: f64,
        position: impl Into<types::Vector3d>,
        velocity: impl Into<types::Vector3f>,
        accel: impl Into<types::Vector3f>,
        health: u8,
        p: u8,
        nt: u8,
        delta_tau_n: f32,
        ft: u8,
        en: u8,
        p1: u8,
        p2: u8,
        p3: u8,
        p4: u8,
        valid_flags: GlonassEphemerisFlags,
    );
}

valid! {
    GlonassEphemeris
    frequency_number_is_valid "frequency_number": valid_flags 0x1;
    tk_is_valid "tk": valid_flags 0x1;
    tb_is_valid "tb": valid_flags 0x1;
    satellite_type_is_valid "satellite_type": valid_flags 0x1;
    gamma_is_valid "gamma": valid_flags 0x1;
    tau_n_is_valid "tau_n": valid_flags 0x1;
    position_is_valid "position": valid_flags 0x1;
    velocity_is_valid "velocity": valid_flags 0x1;
    accel_is_valid "accel": valid_flags 0x1;
    health_is_valid "health": valid_flags 0x1;
    p_is_valid "p": valid_flags 0x1;
    nt_is_valid "nt": valid_flags 0x1;
    delta_tau_n_is_valid "delta_tau_n": valid_flags 0x1;
    ft_is_valid "ft": valid_flags 0x1;
    en_is_valid "en": valid_flags 0x1;
    p1_is_valid "p1": valid_flags 0x1;
    p2_is_valid "p2": valid_flags 0x1;
    p3_is_valid "p3": valid_flags 0x1;
    p4_is_valid "p4": valid_flags 0x1;
}

field! {
    GlonassEphemeris: 0x62, "gnss_data.glonass_ephemeris";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Galileo ephemeris (0x63).
    ///
    /// Broadcast orbit and clock of one Galileo satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - It has the layout of the GPS ephemeris. No source states what the two inter-signal
    ///   corrections mean here.
    /// - `iodc` changes with the clock data; according to the manual, it rolls over at 4.
    ///
    /// Source: 3dm-cv7-gnss-ins: Galileo Ephemeris (0x91,0x63); 3dm-cv7-gnss-ins: Galileo Ephemeris
    /// (0x92,0x63).
    #[derive(Default)]
    pub struct GalileoEphemeris {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        pub iodc: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_gd: f64,
        /// Value in the position of the GPS inter-signal correction for L1.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub isc_l1ca: f64,
        /// Value in the position of the GPS inter-signal correction for L2 or L5.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Range: greater than 0. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub a_dot: f64,
        /// Mean anomaly at the reference time.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub delta_mean_motion_dot: f64,
        /// Eccentricity of the orbit.
        ///
        /// Unit: 1. Range: at least 0, less than 1. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub eccentricity: f64,
        /// Angle from the ascending node to the perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub omega_dot: f64,
        /// Inclination of the orbit at the reference time.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_rs: f64,
        /// Contents of the ephemeris.
        pub valid_flags: EphemerisFlags,
    }
}

view! {
    GalileoEphemeris
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    satellite_id: u8, at 12;
    health: u8, at 13;
    iodc: u8, at 14;
    iode: u8, at 15;
    t_oc: f64, at 16;
    af0: f64, at 24;
    af1: f64, at 32;
    af2: f64, at 40;
    t_gd: f64, at 48;
    isc_l1ca: f64, at 56;
    isc_l2c: f64, at 64;
    t_oe: f64, at 72;
    a: f64, at 80;
    a_dot: f64, at 88;
    mean_anomaly: f64, at 96;
    delta_mean_motion: f64, at 104;
    delta_mean_motion_dot: f64, at 112;
    eccentricity: f64, at 120;
    argument_of_perigee: f64, at 128;
    omega: f64, at 136;
    omega_dot: f64, at 144;
    inclination: f64, at 152;
    inclination_dot: f64, at 160;
    c_ic: f64, at 168;
    c_is: f64, at 176;
    c_uc: f64, at 184;
    c_us: f64, at 192;
    c_rc: f64, at 200;
    c_rs: f64, at 208;
    valid_flags: EphemerisFlags, at 216;
}

constructors! {
    GalileoEphemeris

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        satellite_id: u8,
        health: u8,
        iodc: u8,
        iode: u8,
        t_oc: f64,
        af0: f64,
        af1: f64,
        af2: f64,
        t_gd: f64,
        isc_l1ca: f64,
        isc_l2c: f64,
        t_oe: f64,
        a: f64,
        a_dot: f64,
        mean_anomaly: f64,
        delta_mean_motion: f64,
        delta_mean_motion_dot: f64,
        eccentricity: f64,
        argument_of_perigee: f64,
        omega: f64,
        omega_dot: f64,
        inclination: f64,
        inclination_dot: f64,
        c_ic: f64,
        c_is: f64,
        c_uc: f64,
        c_us: f64,
        c_rc: f64,
        c_rs: f64,
        valid_flags: EphemerisFlags,
    );
}

valid! {
    GalileoEphemeris
    health_is_valid "health": valid_flags 0x1;
    iodc_is_valid "iodc": valid_flags 0x1;
    iode_is_valid "iode": valid_flags 0x1;
    t_oc_is_valid "t_oc": valid_flags 0x1;
    af0_is_valid "af0": valid_flags 0x1;
    af1_is_valid "af1": valid_flags 0x1;
    af2_is_valid "af2": valid_flags 0x1;
    t_gd_is_valid "t_gd": valid_flags 0x1;
    isc_l1ca_is_valid "isc_l1ca": valid_flags 0x1;
    isc_l2c_is_valid "isc_l2c": valid_flags 0x1;
    t_oe_is_valid "t_oe": valid_flags 0x1;
    a_is_valid "a": valid_flags 0x1;
    a_dot_is_valid "a_dot": valid_flags 0x1;
    mean_anomaly_is_valid "mean_anomaly": valid_flags 0x1;
    delta_mean_motion_is_valid "delta_mean_motion": valid_flags 0x1;
    delta_mean_motion_dot_is_valid "delta_mean_motion_dot": valid_flags 0x1;
    eccentricity_is_valid "eccentricity": valid_flags 0x1;
    argument_of_perigee_is_valid "argument_of_perigee": valid_flags 0x1;
    omega_is_valid "omega": valid_flags 0x1;
    omega_dot_is_valid "omega_dot": valid_flags 0x1;
    inclination_is_valid "inclination": valid_flags 0x1;
    inclination_dot_is_valid "inclination_dot": valid_flags 0x1;
    c_ic_is_valid "c_ic": valid_flags 0x1;
    c_is_is_valid "c_is": valid_flags 0x1;
    c_uc_is_valid "c_uc": valid_flags 0x1;
    c_us_is_valid "c_us": valid_flags 0x1;
    c_rc_is_valid "c_rc": valid_flags 0x1;
    c_rs_is_valid "c_rs": valid_flags 0x1;
}

field! {
    GalileoEphemeris: 0x63, "gnss_data.galileo_ephemeris";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// BeiDou ephemeris (0x64).
    ///
    /// Broadcast orbit and clock of one BeiDou satellite.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Confirmed on
    /// [3DM-CV7-GNSS/INS](crate::devices::CV7_GNSS_INS); likely or assumed on 1 more.
    ///
    /// - It has the layout of the GPS ephemeris. No source states what the two inter-signal
    ///   corrections mean here.
    /// - `iodc` changes with the clock data; according to the manual, it rolls over at 4.
    ///
    /// Source: 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x91,0x64); 3dm-cv7-gnss-ins: BeiDou Ephemeris
    /// (0x92,0x64).
    #[derive(Default)]
    pub struct BeidouEphemeris {
        /// Index of this field within the epoch.
        pub index: u8,
        /// Number of such fields in the epoch.
        pub count: u8,
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
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
        pub iodc: u8,
        /// Issue of data, ephemeris.
        ///
        /// Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        pub iode: u8,
        /// Reference time of the clock data.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_oc: f64,
        /// Clock bias.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af0: f64,
        /// Clock drift.
        ///
        /// Unit: s/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af1: f64,
        /// Clock drift rate.
        ///
        /// Unit: s/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub af2: f64,
        /// Group delay.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_gd: f64,
        /// Value in the position of the GPS inter-signal correction for L1.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub isc_l1ca: f64,
        /// Value in the position of the GPS inter-signal correction for L2 or L5.
        ///
        /// Unit: s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub isc_l2c: f64,
        /// Reference time of the ephemeris.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub t_oe: f64,
        /// Semi-major axis.
        ///
        /// Unit: m. Range: greater than 0. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub a: f64,
        /// Rate of the semi-major axis.
        ///
        /// Unit: m/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub a_dot: f64,
        /// Mean anomaly at the reference time.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub mean_anomaly: f64,
        /// Correction of the mean motion.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub delta_mean_motion: f64,
        /// Rate of the correction of the mean motion.
        ///
        /// Unit: rad/s^2. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub delta_mean_motion_dot: f64,
        /// Eccentricity of the orbit.
        ///
        /// Unit: 1. Range: at least 0, less than 1. Valid if
        /// [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub eccentricity: f64,
        /// Angle from the ascending node to the perigee.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub argument_of_perigee: f64,
        /// Longitude of the ascending node.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub omega: f64,
        /// Rate of the right ascension.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub omega_dot: f64,
        /// Inclination of the orbit at the reference time.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination: f64,
        /// Rate of the inclination.
        ///
        /// Unit: rad/s. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub inclination_dot: f64,
        /// Cosine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_ic: f64,
        /// Sine harmonic correction of the inclination.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_is: f64,
        /// Cosine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_uc: f64,
        /// Sine harmonic correction of the argument of latitude.
        ///
        /// Unit: rad. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_us: f64,
        /// Cosine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_rc: f64,
        /// Sine harmonic correction of the orbit radius.
        ///
        /// Unit: m. Valid if [`valid_flags.ephemeris`](EphemerisFlags::ephemeris) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub c_rs: f64,
        /// Contents of the ephemeris.
        pub valid_flags: EphemerisFlags,
    }
}

view! {
    BeidouEphemeris
    index: u8, at 0;
    count: u8, at 1;
    tow: f64, at 2;
    week_number: u16, at 10;
    satellite_id: u8, at 12;
    health: u8, at 13;
    iodc: u8, at 14;
    iode: u8, at 15;
    t_oc: f64, at 16;
    af0: f64, at 24;
    af1: f64, at 32;
    af2: f64, at 40;
    t_gd: f64, at 48;
    isc_l1ca: f64, at 56;
    isc_l2c: f64, at 64;
    t_oe: f64, at 72;
    a: f64, at 80;
    a_dot: f64, at 88;
    mean_anomaly: f64, at 96;
    delta_mean_motion: f64, at 104;
    delta_mean_motion_dot: f64, at 112;
    eccentricity: f64, at 120;
    argument_of_perigee: f64, at 128;
    omega: f64, at 136;
    omega_dot: f64, at 144;
    inclination: f64, at 152;
    inclination_dot: f64, at 160;
    c_ic: f64, at 168;
    c_is: f64, at 176;
    c_uc: f64, at 184;
    c_us: f64, at 192;
    c_rc: f64, at 200;
    c_rs: f64, at 208;
    valid_flags: EphemerisFlags, at 216;
}

constructors! {
    BeidouEphemeris

    /// Creates it from its values.
    fn new(
        index: u8,
        count: u8,
        tow: f64,
        week_number: u16,
        satellite_id: u8,
        health: u8,
        iodc: u8,
        iode: u8,
        t_oc: f64,
        af0: f64,
        af1: f64,
        af2: f64,
        t_gd: f64,
        isc_l1ca: f64,
        isc_l2c: f64,
        t_oe: f64,
        a: f64,
        a_dot: f64,
        mean_anomaly: f64,
        delta_mean_motion: f64,
        delta_mean_motion_dot: f64,
        eccentricity: f64,
        argument_of_perigee: f64,
        omega: f64,
        omega_dot: f64,
        inclination: f64,
        inclination_dot: f64,
        c_ic: f64,
        c_is: f64,
        c_uc: f64,
        c_us: f64,
        c_rc: f64,
        c_rs: f64,
        valid_flags: EphemerisFlags,
    );
}

valid! {
    BeidouEphemeris
    health_is_valid "health": valid_flags 0x1;
    iodc_is_valid "iodc": valid_flags 0x1;
    iode_is_valid "iode": valid_flags 0x1;
    t_oc_is_valid "t_oc": valid_flags 0x1;
    af0_is_valid "af0": valid_flags 0x1;
    af1_is_valid "af1": valid_flags 0x1;
    af2_is_valid "af2": valid_flags 0x1;
    t_gd_is_valid "t_gd": valid_flags 0x1;
    isc_l1ca_is_valid "isc_l1ca": valid_flags 0x1;
    isc_l2c_is_valid "isc_l2c": valid_flags 0x1;
    t_oe_is_valid "t_oe": valid_flags 0x1;
    a_is_valid "a": valid_flags 0x1;
    a_dot_is_valid "a_dot": valid_flags 0x1;
    mean_anomaly_is_valid "mean_anomaly": valid_flags 0x1;
    delta_mean_motion_is_valid "delta_mean_motion": valid_flags 0x1;
    delta_mean_motion_dot_is_valid "delta_mean_motion_dot": valid_flags 0x1;
    eccentricity_is_valid "eccentricity": valid_flags 0x1;
    argument_of_perigee_is_valid "argument_of_perigee": valid_flags 0x1;
    omega_is_valid "omega": valid_flags 0x1;
    omega_dot_is_valid "omega_dot": valid_flags 0x1;
    inclination_is_valid "inclination": valid_flags 0x1;
    inclination_dot_is_valid "inclination_dot": valid_flags 0x1;
    c_ic_is_valid "c_ic": valid_flags 0x1;
    c_is_is_valid "c_is": valid_flags 0x1;
    c_uc_is_valid "c_uc": valid_flags 0x1;
    c_us_is_valid "c_us": valid_flags 0x1;
    c_rc_is_valid "c_rc": valid_flags 0x1;
    c_rs_is_valid "c_rs": valid_flags 0x1;
}

field! {
    BeidouEphemeris: 0x64, "gnss_data.beidou_ephemeris";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// GPS ionospheric correction (0x71).
    ///
    /// Ionospheric model that GPS broadcasts.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `gps_iono_corr`. Not listed in
    /// any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Gps Iono Corr (0x81,0x71).
    #[derive(Default)]
    pub struct GpsIonoCorrection {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](GpsIonoCorrectionFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](GpsIonoCorrectionFlags::week_number) is
        /// set.
        pub week_number: u16,
        /// Coefficients alpha 0 to 3.
        ///
        /// Valid if [`valid_flags.alpha`](GpsIonoCorrectionFlags::alpha) is set. Uncertain: No
        /// source states the units.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub alpha: [f64; 4],
        /// Coefficients beta 0 to 3.
        ///
        /// Valid if [`valid_flags.beta`](GpsIonoCorrectionFlags::beta) is set. Uncertain: No source
        /// states the units.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub beta: [f64; 4],
        /// Validity flags for the model.
        pub valid_flags: GpsIonoCorrectionFlags,
    }
}

view! {
    GpsIonoCorrection
    tow: f64, at 0;
    week_number: u16, at 8;
    alpha: [f64; 4], at 10;
    beta: [f64; 4], at 42;
    valid_flags: GpsIonoCorrectionFlags, at 74;
}

constructors! {
    GpsIonoCorrection

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        alpha: [f64; 4],
        beta: [f64; 4],
        valid_flags: GpsIonoCorrectionFlags,
    );
}

valid! {
    GpsIonoCorrection
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    alpha_is_valid "alpha": valid_flags 0x4;
    beta_is_valid "beta": valid_flags 0x8;
}

field! {
    GpsIonoCorrection: 0x71, "gnss_data.gps_iono_correction";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// Galileo ionospheric correction (0x73).
    ///
    /// Ionospheric model that Galileo broadcasts.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `galileo_iono_corr`. Not listed
    /// in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Galileo Iono Corr (0x81,0x73).
    #[derive(Copy, Default)]
    pub struct GalileoIonoCorrection {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](GalileoIonoCorrectionFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if
        /// [`valid_flags.week_number`](GalileoIonoCorrectionFlags::week_number) is set.
        pub week_number: u16,
        /// The three coefficients of the model.
        ///
        /// Valid if [`valid_flags.alpha`](GalileoIonoCorrectionFlags::alpha) is set. Uncertain: No
        /// source states the units.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub alpha: [f64; 3],
        /// Ionospheric storms, one bit (1 to 5) for each of five regions.
        ///
        /// Valid if
        /// [`valid_flags.disturbance_flags`](GalileoIonoCorrectionFlags::disturbance_flags) is set.
        /// Uncertain: No source states whether the bits count from 0 or from 1, or the region of
        /// each.
        pub disturbance_flags: u8,
        /// Validity flags for the model.
        pub valid_flags: GalileoIonoCorrectionFlags,
    }
}

view! {
    GalileoIonoCorrection
    tow: f64, at 0;
    week_number: u16, at 8;
    alpha: [f64; 3], at 10;
    disturbance_flags: u8, at 34;
    valid_flags: GalileoIonoCorrectionFlags, at 35;
}

constructors! {
    GalileoIonoCorrection

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        alpha: [f64; 3],
        disturbance_flags: u8,
        valid_flags: GalileoIonoCorrectionFlags,
    );
}

valid! {
    GalileoIonoCorrection
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    alpha_is_valid "alpha": valid_flags 0x4;
    disturbance_flags_is_valid "disturbance_flags": valid_flags 0x8;
}

field! {
    GalileoIonoCorrection: 0x73, "gnss_data.galileo_iono_correction";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}

record! {
    /// BeiDou ionospheric correction (0x74).
    ///
    /// Ionospheric model that BeiDou broadcasts.
    ///
    /// Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93),
    /// gnss_external (0x94) and gnss_external_2 (0x95). Also called `beidou_iono_corr`. Not listed
    /// in any device profile. Known only from the MicroStrain MIP SDK.
    ///
    /// Source: mip-sdk-4: Beidou Iono Corr (0x81,0x74).
    #[derive(Default)]
    pub struct BeidouIonoCorrection {
        /// GPS time of week.
        ///
        /// Unit: s. Range: at least 0, less than 604800. Valid if
        /// [`valid_flags.tow`](BeidouIonoCorrectionFlags::tow) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// GPS week number.
        ///
        /// Unit: week. Valid if [`valid_flags.week_number`](BeidouIonoCorrectionFlags::week_number)
        /// is set.
        pub week_number: u16,
        /// Coefficients alpha 0 to 3.
        ///
        /// Valid if [`valid_flags.alpha`](BeidouIonoCorrectionFlags::alpha) is set. Uncertain: No
        /// source states the units.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub alpha: [f64; 4],
        /// Coefficients beta 0 to 3.
        ///
        /// Valid if [`valid_flags.beta`](BeidouIonoCorrectionFlags::beta) is set. Uncertain: No
        /// source states the units.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub beta: [f64; 4],
        /// Nine further coefficients of the delay.
        ///
        /// Valid if [`valid_flags.alpha_correction`](BeidouIonoCorrectionFlags::alpha_correction)
        /// is set. Uncertain: No source states the units.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub alpha_correction: [f64; 9],
        /// Validity flags for the model.
        pub valid_flags: BeidouIonoCorrectionFlags,
    }
}

view! {
    BeidouIonoCorrection
    tow: f64, at 0;
    week_number: u16, at 8;
    alpha: [f64; 4], at 10;
    beta: [f64; 4], at 42;
    alpha_correction: [f64; 9], at 74;
    valid_flags: BeidouIonoCorrectionFlags, at 146;
}

constructors! {
    BeidouIonoCorrection

    /// Creates it from its values.
    fn new(
        tow: f64,
        week_number: u16,
        alpha: [f64; 4],
        beta: [f64; 4],
        alpha_correction: [f64; 9],
        valid_flags: BeidouIonoCorrectionFlags,
    );
}

valid! {
    BeidouIonoCorrection
    tow_is_valid "tow": valid_flags 0x1;
    week_number_is_valid "week_number": valid_flags 0x2;
    alpha_is_valid "alpha": valid_flags 0x4;
    beta_is_valid "beta": valid_flags 0x8;
    alpha_correction_is_valid "alpha_correction": valid_flags 0x10;
}

field! {
    BeidouIonoCorrection: 0x74, "gnss_data.beidou_iono_correction";
    in [0x81 0x91 0x92 0x93 0x94 0x95];
}
