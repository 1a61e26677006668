/**
 * GNSS data (0x81, 0x91, 0x92, 0x93, 0x94, 0x95).
 *
 * Measurements and status of GNSS receivers. Each receiver has a descriptor set; all have the same fields.
 *
 * Uncertain: Some devices may not send a field in every set: the SDK lists the same fields for all GNSS data sets, the
 * manuals fewer.
 *
 * - gnss_data (0x81): Measurements and status of the GNSS receiver of 4-series and 5-series devices.
 * - gnss_1 (0x91): Measurements and status of the first internal GNSS receiver.
 * - gnss_2 (0x92): Measurements and status of the second internal GNSS receiver.
 * - gnss_corrections (0x93): RTK corrections that the device receives. Data is sent as it is received.
 * - gnss_external (0x94): Data that an external GNSS receiver sends to the device in NMEA sentences. A field may need
 *   several sentences; a value that NMEA does not provide is not valid. Times are taken from the sentences.
 * - gnss_external_2 (0x95): Data that a second external GNSS receiver sends to the device. Uncertain: The name is from
 *   a page on the 3DM-CV7-INS that the vendor published for trial; the SDK calls the set GNSS 5.
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type LlhPositionFlags = Flavor<number, "gnss_data.llh_position_flags">;
/** Validity flags for the position. */
export declare const LlhPositionFlags: Bitfield<LlhPositionFlags> & {
    /** `latitude` and `longitude` are valid. Bit 0. */
    readonly LAT_LON: LlhPositionFlags;
    /** `ellipsoid_height` is valid. Bit 1. */
    readonly ELLIPSOID_HEIGHT: LlhPositionFlags;
    /** `msl_height` is valid. Bit 2. */
    readonly MSL_HEIGHT: LlhPositionFlags;
    /** `horizontal_accuracy` is valid. Bit 3. */
    readonly HORIZONTAL_ACCURACY: LlhPositionFlags;
    /** `vertical_accuracy` is valid. Bit 4. */
    readonly VERTICAL_ACCURACY: LlhPositionFlags;
    /** All values are valid. Bits 0 to 4. Overlaps other bits. */
    readonly FLAGS: LlhPositionFlags;
};

export type EcefPositionFlags = Flavor<number, "gnss_data.ecef_position_flags">;
/** Validity flags for the position. */
export declare const EcefPositionFlags: Bitfield<EcefPositionFlags> & {
    /** `position` is valid. Bit 0. */
    readonly POSITION: EcefPositionFlags;
    /** `position_accuracy` is valid. Bit 1. */
    readonly POSITION_ACCURACY: EcefPositionFlags;
    /** All values are valid. Bits 0 to 1. Overlaps other bits. */
    readonly FLAGS: EcefPositionFlags;
};

export type NedVelocityFlags = Flavor<number, "gnss_data.ned_velocity_flags">;
/** Validity flags for the velocity. */
export declare const NedVelocityFlags: Bitfield<NedVelocityFlags> & {
    /** `velocity` is valid. Bit 0. */
    readonly VELOCITY: NedVelocityFlags;
    /** `speed` is valid. Bit 1. */
    readonly SPEED_3D: NedVelocityFlags;
    /** `ground_speed` is valid. Bit 2. */
    readonly GROUND_SPEED: NedVelocityFlags;
    /** `heading` is valid. Bit 3. */
    readonly HEADING: NedVelocityFlags;
    /** `speed_accuracy` is valid. Bit 4. */
    readonly SPEED_ACCURACY: NedVelocityFlags;
    /** `heading_accuracy` is valid. Bit 5. */
    readonly HEADING_ACCURACY: NedVelocityFlags;
    /** All values are valid. Bits 0 to 5. Overlaps other bits. */
    readonly FLAGS: NedVelocityFlags;
};

export type EcefVelocityFlags = Flavor<number, "gnss_data.ecef_velocity_flags">;
/** Validity flags for the velocity. */
export declare const EcefVelocityFlags: Bitfield<EcefVelocityFlags> & {
    /** `velocity` is valid. Bit 0. */
    readonly VELOCITY: EcefVelocityFlags;
    /** `velocity_accuracy` is valid. Bit 1. */
    readonly VELOCITY_ACCURACY: EcefVelocityFlags;
    /** All values are valid. Bits 0 to 1. Overlaps other bits. */
    readonly FLAGS: EcefVelocityFlags;
};

export type DopFlags = Flavor<number, "gnss_data.dop_flags">;
/** Validity flags for the dilutions of precision. */
export declare const DopFlags: Bitfield<DopFlags> & {
    /** `gdop` is valid. Bit 0. */
    readonly GDOP: DopFlags;
    /** `pdop` is valid. Bit 1. */
    readonly PDOP: DopFlags;
    /** `hdop` is valid. Bit 2. */
    readonly HDOP: DopFlags;
    /** `vdop` is valid. Bit 3. */
    readonly VDOP: DopFlags;
    /** `tdop` is valid. Bit 4. */
    readonly TDOP: DopFlags;
    /** `ndop` is valid. Bit 5. */
    readonly NDOP: DopFlags;
    /** `edop` is valid. Bit 6. */
    readonly EDOP: DopFlags;
    /** All values are valid. Bits 0 to 6. Overlaps other bits. */
    readonly FLAGS: DopFlags;
};

export type UtcTimeFlags = Flavor<number, "gnss_data.utc_time_flags">;
/** Validity flags for the UTC time. */
export declare const UtcTimeFlags: Bitfield<UtcTimeFlags> & {
    /** Date and time come from GNSS. Bit 0. */
    readonly GNSS_DATE_TIME: UtcTimeFlags;
    /** The leap seconds between GPS time and UTC are known. Bit 1. */
    readonly LEAP_SECONDS_KNOWN: UtcTimeFlags;
    /** Date and time come from GNSS, and the leap seconds are known. Bits 0 to 1. Overlaps other bits. */
    readonly FLAGS: UtcTimeFlags;
};

export type GpsTimeFlags = Flavor<number, "gnss_data.gps_time_flags">;
/** Validity flags for the time. */
export declare const GpsTimeFlags: Bitfield<GpsTimeFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: GpsTimeFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: GpsTimeFlags;
    /** All values are valid. Bits 0 to 1. Overlaps other bits. */
    readonly FLAGS: GpsTimeFlags;
};

export type ClockInfoFlags = Flavor<number, "gnss_data.clock_info_flags">;
/** Validity flags for the clock parameters. */
export declare const ClockInfoFlags: Bitfield<ClockInfoFlags> & {
    /** `bias` is valid. Bit 0. */
    readonly BIAS: ClockInfoFlags;
    /** `drift` is valid. Bit 1. */
    readonly DRIFT: ClockInfoFlags;
    /** `accuracy_estimate` is valid. Bit 2. */
    readonly ACCURACY_ESTIMATE: ClockInfoFlags;
    /** All values are valid. Bits 0 to 2. Overlaps other bits. */
    readonly FLAGS: ClockInfoFlags;
};

export type FixFlags = Flavor<number, "gnss_data.fix_flags">;
/** Corrections and satellite systems of the fix. */
export declare const FixFlags: Bitfield<FixFlags> & {
    /** SBAS corrections were used in the fix. Bit 0. */
    readonly SBAS_USED: FixFlags;
    /** Differential corrections were used in the fix. Bit 1. */
    readonly DGNSS_USED: FixFlags;
};

export type FixInfoFlags = Flavor<number, "gnss_data.fix_info_flags">;
/** Validity flags for the fix information. */
export declare const FixInfoFlags: Bitfield<FixInfoFlags> & {
    /** `fix_type` is valid. Bit 0. */
    readonly FIX_TYPE: FixInfoFlags;
    /** `num_sv` is valid. Bit 1. */
    readonly NUM_SV: FixInfoFlags;
    /** `fix_flags` is valid. Bit 2. */
    readonly FIX_FLAGS: FixInfoFlags;
    /** All values are valid. Bits 0 to 2. Overlaps other bits. */
    readonly FLAGS: FixInfoFlags;
};

export type SvFlags = Flavor<number, "gnss_data.sv_flags">;
/** State of a satellite. */
export declare const SvFlags: Bitfield<SvFlags> & {
    /** The satellite is used in the position fix. Bit 0. */
    readonly USED_FOR_NAVIGATION: SvFlags;
    /** The satellite reports that its signals can be used. Bit 1. */
    readonly HEALTHY: SvFlags;
};

export type SvInfoFlags = Flavor<number, "gnss_data.sv_info_flags">;
/** Validity flags for the satellite info. */
export declare const SvInfoFlags: Bitfield<SvInfoFlags> & {
    /** `channel` is valid. Bit 0. */
    readonly CHANNEL: SvInfoFlags;
    /** `satellite_id` is valid. Bit 1. */
    readonly SATELLITE_ID: SvInfoFlags;
    /** `carrier_noise_ratio` is valid. Bit 2. */
    readonly CARRIER_NOISE_RATIO: SvInfoFlags;
    /** `azimuth` is valid. Bit 3. */
    readonly AZIMUTH: SvInfoFlags;
    /** `elevation` is valid. Bit 4. */
    readonly ELEVATION: SvInfoFlags;
    /** `sv_flags` is valid. Bit 5. */
    readonly SV_FLAGS: SvInfoFlags;
    /** All values are valid. Bits 0 to 5. Overlaps other bits. */
    readonly FLAGS: SvInfoFlags;
};

export type ReceiverState = Flavor<number, "gnss_data.receiver_state">;
/** Operating state of a GNSS receiver. */
export declare const ReceiverState: Enumeration<ReceiverState> & {
    readonly OFF: ReceiverState & 0;
    readonly ON: ReceiverState & 1;
    /** Not known. */
    readonly UNKNOWN: ReceiverState & 2;
};

export type AntennaState = Flavor<number, "gnss_data.antenna_state">;
/** Electrical condition of a GNSS antenna. */
export declare const AntennaState: Enumeration<AntennaState> & {
    /** Being initialized. */
    readonly INIT: AntennaState & 1;
    /** Short circuit. */
    readonly SHORT: AntennaState & 2;
    /** Open circuit, no antenna. */
    readonly OPEN: AntennaState & 3;
    readonly GOOD: AntennaState & 4;
    /** Not known. */
    readonly UNKNOWN: AntennaState & 5;
};

export type AntennaPower = Flavor<number, "gnss_data.antenna_power">;
/** State of the antenna's power supply. */
export declare const AntennaPower: Enumeration<AntennaPower> & {
    readonly OFF: AntennaPower & 0;
    readonly ON: AntennaPower & 1;
    /** Not known. */
    readonly UNKNOWN: AntennaPower & 2;
};

export type HardwareStatusFlags = Flavor<number, "gnss_data.hardware_status_flags">;
/** Validity flags for the hardware status. */
export declare const HardwareStatusFlags: Bitfield<HardwareStatusFlags> & {
    /** `receiver_state` is valid. Bit 0. */
    readonly SENSOR_STATE: HardwareStatusFlags;
    /** `antenna_state` is valid. Bit 1. */
    readonly ANTENNA_STATE: HardwareStatusFlags;
    /** `antenna_power` is valid. Bit 2. */
    readonly ANTENNA_POWER: HardwareStatusFlags;
    /** All values are valid. Bits 0 to 2. Overlaps other bits. */
    readonly FLAGS: HardwareStatusFlags;
};

export type DgpsInfoFlags = Flavor<number, "gnss_data.dgps_info_flags">;
/** Validity flags for the state of the corrections. */
export declare const DgpsInfoFlags: Bitfield<DgpsInfoFlags> & {
    /** `age` is valid. Bit 0. */
    readonly AGE: DgpsInfoFlags;
    /** `base_station_id` is valid. Bit 1. */
    readonly BASE_STATION_ID: DgpsInfoFlags;
    /** `base_station_status` is valid. Bit 2. */
    readonly BASE_STATION_STATUS: DgpsInfoFlags;
    /** `num_channels` is valid. Bit 3. */
    readonly NUM_CHANNELS: DgpsInfoFlags;
    /** All values are valid. Bits 0 to 3. Overlaps other bits. */
    readonly FLAGS: DgpsInfoFlags;
};

export type DgpsChannelFlags = Flavor<number, "gnss_data.dgps_channel_flags">;
/** Validity flags for a differential correction. */
export declare const DgpsChannelFlags: Bitfield<DgpsChannelFlags> & {
    /** `satellite_id` is valid. Bit 0. */
    readonly SATELLITE_ID: DgpsChannelFlags;
    /** `age` is valid. Bit 1. */
    readonly AGE: DgpsChannelFlags;
    /** `range_correction` is valid. Bit 2. */
    readonly RANGE_CORRECTION: DgpsChannelFlags;
    /** `range_rate_correction` is valid. Bit 3. */
    readonly RANGE_RATE_CORRECTION: DgpsChannelFlags;
    /** All values are valid. Bits 0 to 3. Overlaps other bits. */
    readonly FLAGS: DgpsChannelFlags;
};

export type ClockInfo2Flags = Flavor<number, "gnss_data.clock_info_2_flags">;
/** Validity flags for the clock parameters. */
export declare const ClockInfo2Flags: Bitfield<ClockInfo2Flags> & {
    /** `bias` is valid. Bit 0. */
    readonly BIAS: ClockInfo2Flags;
    /** `drift` is valid. Bit 1. */
    readonly DRIFT: ClockInfo2Flags;
    /** `bias_accuracy_estimate` is valid. Bit 2. */
    readonly BIAS_ACCURACY: ClockInfo2Flags;
    /** `drift_accuracy_estimate` is valid. Bit 3. */
    readonly DRIFT_ACCURACY: ClockInfo2Flags;
    /** All values are valid. Bits 0 to 3. Overlaps other bits. */
    readonly FLAGS: ClockInfo2Flags;
};

export type GpsLeapSecondsFlags = Flavor<number, "gnss_data.gps_leap_seconds_flags">;
/** Validity of the leap seconds. Bit 0 is not used. */
export declare const GpsLeapSecondsFlags: Bitfield<GpsLeapSecondsFlags> & {
    /** `leap_seconds` is valid. Bit 1. */
    readonly LEAP_SECONDS: GpsLeapSecondsFlags;
};

export type SbasSystem = Flavor<number, "gnss_data.sbas_system">;
/** Satellite-based augmentation system (SBAS). */
export declare const SbasSystem: Enumeration<SbasSystem> & {
    /** Not known. */
    readonly UNKNOWN: SbasSystem & 0;
    /** WAAS, the North American system. */
    readonly WAAS: SbasSystem & 1;
    /** EGNOS, the European system. */
    readonly EGNOS: SbasSystem & 2;
    /** MSAS, the Japanese system. */
    readonly MSAS: SbasSystem & 3;
    /** GAGAN, the Indian system. */
    readonly GAGAN: SbasSystem & 4;
};

export type SbasStatus = Flavor<number, "gnss_data.sbas_status">;
/** Services of an SBAS system. */
export declare const SbasStatus: Bitfield<SbasStatus> & {
    /** Ranging is available. Bit 0. */
    readonly RANGE_AVAILABLE: SbasStatus;
    /** Corrections are available. Bit 1. */
    readonly CORRECTIONS_AVAILABLE: SbasStatus;
    /** Integrity information is available. Bit 2. */
    readonly INTEGRITY_AVAILABLE: SbasStatus;
    /** The service is in test mode. Bit 3. */
    readonly TEST_MODE: SbasStatus;
};

export type SbasInfoFlags = Flavor<number, "gnss_data.sbas_info_flags">;
/** Validity flags for the SBAS status. */
export declare const SbasInfoFlags: Bitfield<SbasInfoFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: SbasInfoFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: SbasInfoFlags;
    /** `sbas_system` is valid. Bit 2. */
    readonly SBAS_SYSTEM: SbasInfoFlags;
    /** `sbas_id` is valid. Bit 3. */
    readonly SBAS_ID: SbasInfoFlags;
    /** `count` is valid. Bit 4. */
    readonly COUNT: SbasInfoFlags;
    /** `sbas_status` is valid. Bit 5. */
    readonly SBAS_STATUS: SbasInfoFlags;
    /** All values are valid. Bits 0 to 5. Overlaps other bits. */
    readonly FLAGS: SbasInfoFlags;
};

export type SbasCorrectionFlags = Flavor<number, "gnss_data.sbas_correction_flags">;
/** Validity flags for an SBAS correction. */
export declare const SbasCorrectionFlags: Bitfield<SbasCorrectionFlags> & {
    /** `udrei` is valid. Bit 0. */
    readonly UDREI: SbasCorrectionFlags;
    /** `pseudorange_correction` is valid. Bit 1. */
    readonly PSEUDORANGE_CORRECTION: SbasCorrectionFlags;
    /** `iono_correction` is valid. Bit 2. */
    readonly IONO_CORRECTION: SbasCorrectionFlags;
    /** All values are valid. Bits 0 to 2. Overlaps other bits. */
    readonly FLAGS: SbasCorrectionFlags;
};

export type RfBand = Flavor<number, "gnss_data.rf_band">;
/** Frequency band of GNSS signals. */
export declare const RfBand: Enumeration<RfBand> & {
    /** Not known. */
    readonly UNKNOWN: RfBand & 0;
    readonly L1: RfBand & 1;
    readonly L2: RfBand & 2;
    readonly L5: RfBand & 5;
};

export type JammingState = Flavor<number, "gnss_data.jamming_state">;
/** Severity of jamming. */
export declare const JammingState: Enumeration<JammingState> & {
    /** Not known. */
    readonly UNKNOWN: JammingState & 0;
    /** Not jammed. */
    readonly NONE: JammingState & 1;
    /** Partly jammed. */
    readonly PARTIAL: JammingState & 2;
    /** Heavily jammed. */
    readonly SIGNIFICANT: JammingState & 3;
};

export type SpoofingState = Flavor<number, "gnss_data.spoofing_state">;
/** Severity of spoofing. */
export declare const SpoofingState: Enumeration<SpoofingState> & {
    /** Not known. */
    readonly UNKNOWN: SpoofingState & 0;
    /** Not spoofed. */
    readonly NONE: SpoofingState & 1;
    /** Partly spoofed. */
    readonly PARTIAL: SpoofingState & 2;
    /** Heavily spoofed. */
    readonly SIGNIFICANT: SpoofingState & 3;
};

export type RfErrorDetectionFlags = Flavor<number, "gnss_data.rf_error_detection_flags">;
/** Validity flags for the detection. */
export declare const RfErrorDetectionFlags: Bitfield<RfErrorDetectionFlags> & {
    /** `rf_band` is valid. Bit 0. */
    readonly RF_BAND: RfErrorDetectionFlags;
    /** `jamming_state` is valid. Bit 1. */
    readonly JAMMING_STATE: RfErrorDetectionFlags;
    /** `spoofing_state` is valid. Bit 2. */
    readonly SPOOFING_STATE: RfErrorDetectionFlags;
    /** `frequency` is valid; set only by firmware that sends the frequency. Bit 3. */
    readonly FREQUENCY: RfErrorDetectionFlags;
    /** All values are valid. Bits 0 to 3. Overlaps other bits. */
    readonly FLAGS: RfErrorDetectionFlags;
};

export type HeadingFixType = Flavor<number, "gnss_data.heading_fix_type">;
/** Resolution of the carrier phase ambiguities for a heading. */
export declare const HeadingFixType: Enumeration<HeadingFixType> & {
    /** Not known. */
    readonly UNKNOWN: HeadingFixType & 0;
    /** The ambiguities are real numbers, which is less accurate. */
    readonly FLOAT: HeadingFixType & 1;
    /** The ambiguities are fixed to whole numbers of cycles. */
    readonly FIXED: HeadingFixType & 2;
};

export type HeadingFlags = Flavor<number, "gnss_data.heading_flags">;
/** Validity flags for the heading. */
export declare const HeadingFlags: Bitfield<HeadingFlags> & {
    /** `heading` is valid. Bit 0. */
    readonly HEADING: HeadingFlags;
    /** `uncertainty` is valid. Bit 1. */
    readonly UNCERTAINTY: HeadingFlags;
    /** `fix_type` is valid. Bit 2. */
    readonly FIX_TYPE: HeadingFlags;
    /** All values are valid. Bits 0 to 2. Overlaps other bits. */
    readonly FLAGS: HeadingFlags;
};

export type SatelliteStatusFlags = Flavor<number, "gnss_data.satellite_status_flags">;
/** Validity flags for the satellite status. */
export declare const SatelliteStatusFlags: Bitfield<SatelliteStatusFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: SatelliteStatusFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: SatelliteStatusFlags;
    /** `gnss_id` is valid. Bit 2. */
    readonly GNSS_ID: SatelliteStatusFlags;
    /** `satellite_id` is valid. Bit 3. */
    readonly SATELLITE_ID: SatelliteStatusFlags;
    /** `elevation` is valid. Bit 4. */
    readonly ELEVATION: SatelliteStatusFlags;
    /** `azimuth` is valid. Bit 5. */
    readonly AZIMUTH: SatelliteStatusFlags;
    /** `health` is valid. Bit 6. */
    readonly HEALTH: SatelliteStatusFlags;
    /** All values are valid. Bits 0 to 6. Overlaps other bits. */
    readonly FLAGS: SatelliteStatusFlags;
};

export type SignalQuality = Flavor<number, "gnss_data.signal_quality">;
/** Tracking quality of a signal. */
export declare const SignalQuality: Enumeration<SignalQuality> & {
    /** No signal. */
    readonly NONE: SignalQuality & 0;
    /** The signal is being searched for. */
    readonly SEARCHING: SignalQuality & 1;
    /** The signal is acquired. */
    readonly ACQUIRED: SignalQuality & 2;
    /** The signal is found but cannot be used. */
    readonly UNUSABLE: SignalQuality & 3;
    /** Time-locked. */
    readonly TIME_LOCKED: SignalQuality & 4;
    readonly FULLY_LOCKED: SignalQuality & 5;
};

export type RawFlags = Flavor<number, "gnss_data.raw_flags">;
/** Validity flags for the observation. */
export declare const RawFlags: Bitfield<RawFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: RawFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: RawFlags;
    /** `receiver_id` is valid. Bit 2. */
    readonly RECEIVER_ID: RawFlags;
    /** `tracking_channel` is valid. Bit 3. */
    readonly TRACKING_CHANNEL: RawFlags;
    /** `gnss_id` is valid. Bit 4. */
    readonly GNSS_ID: RawFlags;
    /** `satellite_id` is valid. Bit 5. */
    readonly SATELLITE_ID: RawFlags;
    /** `signal_id` is valid. Bit 6. */
    readonly SIGNAL_ID: RawFlags;
    /** `signal_strength` is valid. Bit 7. */
    readonly SIGNAL_STRENGTH: RawFlags;
    /** `quality` is valid. Bit 8. */
    readonly QUALITY: RawFlags;
    /** `pseudorange` is valid. Bit 9. */
    readonly PSEUDORANGE: RawFlags;
    /** `carrier_phase` is valid. Bit 10. */
    readonly CARRIER_PHASE: RawFlags;
    /** `doppler` is valid. Bit 11. */
    readonly DOPPLER: RawFlags;
    /** `range_uncertainty` is valid. Bit 12. */
    readonly RANGE_UNCERTAINTY: RawFlags;
    /** `phase_uncertainty` is valid. Bit 13. */
    readonly CARRIER_PHASE_UNCERTAINTY: RawFlags;
    /** `doppler_uncertainty` is valid. Bit 14. */
    readonly DOPPLER_UNCERTAINTY: RawFlags;
    /** `lock_time` is valid. Bit 15. */
    readonly LOCK_TIME: RawFlags;
    /** All values are valid. Bits 0 to 15. Overlaps other bits. */
    readonly FLAGS: RawFlags;
};

export type BaseStationIndicators = Flavor<number, "gnss_data.base_station_indicators">;
/** Properties of a base station, as in its RTCM message. */
export declare const BaseStationIndicators: Bitfield<BaseStationIndicators> & {
    /** GPS is supported. Bit 0. */
    readonly GPS: BaseStationIndicators;
    /** GLONASS is supported. Bit 1. */
    readonly GLONASS: BaseStationIndicators;
    /** Galileo is supported. Bit 2. */
    readonly GALILEO: BaseStationIndicators;
    /** BeiDou is supported. Bit 3. */
    readonly BEIDOU: BaseStationIndicators;
    /** Reference station indicator. Bit 4. */
    readonly REFERENCE_STATION: BaseStationIndicators;
    /** Single receiver oscillator indicator. Bit 5. */
    readonly SINGLE_RECEIVER: BaseStationIndicators;
    /** First bit of the quarter cycle indicator. Bit 6. */
    readonly QUARTER_CYCLE_BIT1: BaseStationIndicators;
    /** Second bit of the quarter cycle indicator. Bit 7. */
    readonly QUARTER_CYCLE_BIT2: BaseStationIndicators;
    /** Quarter cycle indicator. Bits 6 to 7. Overlaps other bits. */
    readonly QUARTER_CYCLE_BITS: BaseStationIndicators;
};

export type BaseStationInfoFlags = Flavor<number, "gnss_data.base_station_info_flags">;
/** Valid values. */
export declare const BaseStationInfoFlags: Bitfield<BaseStationInfoFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: BaseStationInfoFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: BaseStationInfoFlags;
    /** `ecef_position` is valid. Bit 2. */
    readonly ECEF_POSITION: BaseStationInfoFlags;
    /** `height` is valid. Bit 3. */
    readonly HEIGHT: BaseStationInfoFlags;
    /** `station_id` is valid. Bit 4. */
    readonly STATION_ID: BaseStationInfoFlags;
    /** `indicators` is valid. Bit 5. */
    readonly INDICATORS: BaseStationInfoFlags;
    /** All values are valid. Bits 0 to 5. Overlaps other bits. */
    readonly FLAGS: BaseStationInfoFlags;
};

export type RtkEpochStatus = Flavor<number, "gnss_data.rtk_epoch_status">;
/** Corrections received during an epoch. */
export declare const RtkEpochStatus: Bitfield<RtkEpochStatus> & {
    /** The position of the base station's antenna has arrived. Bit 0. */
    readonly ANTENNA_LOCATION_RECEIVED: RtkEpochStatus;
    /** The description of the base station's antenna has arrived. Bit 1. */
    readonly ANTENNA_DESCRIPTION_RECEIVED: RtkEpochStatus;
    /** GPS corrections have arrived. Bit 2. */
    readonly GPS_RECEIVED: RtkEpochStatus;
    /** GLONASS corrections have arrived. Bit 3. */
    readonly GLONASS_RECEIVED: RtkEpochStatus;
    /** Galileo corrections have arrived. Bit 4. */
    readonly GALILEO_RECEIVED: RtkEpochStatus;
    /** BeiDou corrections have arrived. Bit 5. */
    readonly BEIDOU_RECEIVED: RtkEpochStatus;
    /** GPS corrections are received in MSM messages, not in the RTCM messages 1001-1004. Bit 6. */
    readonly USING_GPS_MSM_MESSAGES: RtkEpochStatus;
    /** GLONASS corrections are received in MSM messages, not in the RTCM messages 1009-1012. Bit 7. */
    readonly USING_GLONASS_MSM_MESSAGES: RtkEpochStatus;
    /** The status of the dongle could not be read. Bit 8. */
    readonly DONGLE_STATUS_READ_FAILED: RtkEpochStatus;
};

export type RtkCorrectionsStatusFlags = Flavor<number, "gnss_data.rtk_corrections_status_flags">;
/** Valid values. */
export declare const RtkCorrectionsStatusFlags: Bitfield<RtkCorrectionsStatusFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: RtkCorrectionsStatusFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: RtkCorrectionsStatusFlags;
    /** `epoch_status` is valid. Bit 2. */
    readonly EPOCH_STATUS: RtkCorrectionsStatusFlags;
    /** `dongle_status` is valid. Bit 3. */
    readonly DONGLE_STATUS: RtkCorrectionsStatusFlags;
    /** `gps_correction_latency` is valid. Bit 4. */
    readonly GPS_LATENCY: RtkCorrectionsStatusFlags;
    /** `glonass_correction_latency` is valid. Bit 5. */
    readonly GLONASS_LATENCY: RtkCorrectionsStatusFlags;
    /** `galileo_correction_latency` is valid. Bit 6. */
    readonly GALILEO_LATENCY: RtkCorrectionsStatusFlags;
    /** `beidou_correction_latency` is valid. Bit 7. */
    readonly BEIDOU_LATENCY: RtkCorrectionsStatusFlags;
    /** All values are valid. Bits 0 to 7. Overlaps other bits. */
    readonly FLAGS: RtkCorrectionsStatusFlags;
};

export type EphemerisFlags = Flavor<number, "gnss_data.ephemeris_flags">;
/** Contents of a GPS, Galileo or BeiDou ephemeris. */
export declare const EphemerisFlags: Bitfield<EphemerisFlags> & {
    /** The ephemeris is valid. Bit 0. */
    readonly EPHEMERIS: EphemerisFlags;
    /** Data of the modernized navigation message is included. Bit 1. */
    readonly MODERN_DATA: EphemerisFlags;
    /** `isc_l2c` is the correction for L5, not for L2. Bit 2. */
    readonly ISC_L5: EphemerisFlags;
    /** The ephemeris is valid, with modernized data and the correction for L5. Bits 0 to 2. Overlaps other bits. */
    readonly FLAGS: EphemerisFlags;
};

export type GlonassSatelliteType = Flavor<number, "gnss_data.glonass_satellite_type">;
/** Generation of a GLONASS satellite. */
export declare const GlonassSatelliteType: Enumeration<GlonassSatelliteType> & {
    readonly GLONASS: GlonassSatelliteType & 0;
    readonly GLONASS_M: GlonassSatelliteType & 1;
};

export type GlonassEphemerisFlags = Flavor<number, "gnss_data.glonass_ephemeris_flags">;
/** Validity of the ephemeris. */
export declare const GlonassEphemerisFlags: Bitfield<GlonassEphemerisFlags> & {
    /** The ephemeris is valid. Bit 0. */
    readonly EPHEMERIS: GlonassEphemerisFlags;
    /** All values are valid. Bit 0. Overlaps other bits. */
    readonly FLAGS: GlonassEphemerisFlags;
};

export type GpsIonoCorrectionFlags = Flavor<number, "gnss_data.gps_iono_correction_flags">;
/** Validity flags for the model. */
export declare const GpsIonoCorrectionFlags: Bitfield<GpsIonoCorrectionFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: GpsIonoCorrectionFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: GpsIonoCorrectionFlags;
    /** `alpha` is valid. Bit 2. */
    readonly ALPHA: GpsIonoCorrectionFlags;
    /** `beta` is valid. Bit 3. */
    readonly BETA: GpsIonoCorrectionFlags;
    /** All values are valid. Bits 0 to 3. Overlaps other bits. */
    readonly FLAGS: GpsIonoCorrectionFlags;
};

export type GalileoIonoCorrectionFlags = Flavor<number, "gnss_data.galileo_iono_correction_flags">;
/** Validity flags for the model. */
export declare const GalileoIonoCorrectionFlags: Bitfield<GalileoIonoCorrectionFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: GalileoIonoCorrectionFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: GalileoIonoCorrectionFlags;
    /** `alpha` is valid. Bit 2. */
    readonly ALPHA: GalileoIonoCorrectionFlags;
    /** `disturbance_flags` is valid. Bit 3. */
    readonly DISTURBANCE_FLAGS: GalileoIonoCorrectionFlags;
    /** All values are valid. Bits 0 to 3. Overlaps other bits. */
    readonly FLAGS: GalileoIonoCorrectionFlags;
};

export type BeidouIonoCorrectionFlags = Flavor<number, "gnss_data.beidou_iono_correction_flags">;
/** Validity flags for the model. */
export declare const BeidouIonoCorrectionFlags: Bitfield<BeidouIonoCorrectionFlags> & {
    /** `tow` is valid. Bit 0. */
    readonly TOW: BeidouIonoCorrectionFlags;
    /** `week_number` is valid. Bit 1. */
    readonly WEEK_NUMBER: BeidouIonoCorrectionFlags;
    /** `alpha` is valid. Bit 2. */
    readonly ALPHA: BeidouIonoCorrectionFlags;
    /** `beta` is valid. Bit 3. */
    readonly BETA: BeidouIonoCorrectionFlags;
    /** `alpha_correction` is valid. Bit 4. */
    readonly ALPHA_CORRECTION: BeidouIonoCorrectionFlags;
    /** All values are valid. Bits 0 to 4. Overlaps other bits. */
    readonly FLAGS: BeidouIonoCorrectionFlags;
};

/**
 * GNSS LLH position (0x03).
 *
 * GNSS position as latitude, longitude and height.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `pos_llh`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GQ7-GNSS/INS;
 * likely or assumed on 11 more.
 *
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x91,0x03)
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x92,0x03)
 * - 3dm-cv7-gnss-ins: GNSS LLH Position (0x94,0x03)
 */
export declare class LlhPosition extends Data {
    constructor(values: Values<LlhPosition>);
    /**
     * Geodetic latitude. Unit: deg. Frame: llh. Range: -90 to 90. Positive: north. Valid if `LlhPositionFlags.LAT_LON`
     * of `validFlags` is set.
     */
    latitude: number;
    /**
     * Geodetic longitude. Unit: deg. Frame: llh. Range: -180 to 180. Positive: east. Valid if
     * `LlhPositionFlags.LAT_LON` of `validFlags` is set.
     */
    longitude: number;
    /**
     * Height above the ellipsoid. Unit: m. Frame: llh. Valid if `LlhPositionFlags.ELLIPSOID_HEIGHT` of `validFlags` is
     * set.
     */
    ellipsoidHeight: number;
    /** Height above mean sea level. Unit: m. Valid if `LlhPositionFlags.MSL_HEIGHT` of `validFlags` is set. */
    mslHeight: number;
    /**
     * Estimated error of latitude and longitude. Unit: m. Range: at least 0. Valid if
     * `LlhPositionFlags.HORIZONTAL_ACCURACY` of `validFlags` is set.
     */
    horizontalAccuracy: number;
    /**
     * Estimated error of the heights. Unit: m. Range: at least 0. Valid if `LlhPositionFlags.VERTICAL_ACCURACY` of
     * `validFlags` is set.
     */
    verticalAccuracy: number;
    /** Validity flags for the position. */
    validFlags: LlhPositionFlags;
}

/**
 * GNSS ECEF position (0x04).
 *
 * GNSS position in Earth-fixed coordinates.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `pos_ecef`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GQ7-GNSS/INS;
 * likely or assumed on 3 more.
 *
 * - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x91,0x04)
 * - 3dm-cv7-gnss-ins: GNSS ECEF Position (0x92,0x04)
 */
export declare class EcefPosition extends Data {
    constructor(values: Values<EcefPosition>);
    /**
     * Position of the antenna. Elements: x, y, z. Unit: m. Frame: ecef. Valid if `EcefPositionFlags.POSITION` of
     * `validFlags` is set.
     */
    position: types.Vector3d;
    /**
     * Estimated error of the position. Unit: m. Range: at least 0. Valid if `EcefPositionFlags.POSITION_ACCURACY` of
     * `validFlags` is set.
     */
    positionAccuracy: number;
    /** Validity flags for the position. */
    validFlags: EcefPositionFlags;
}

/**
 * NED velocity (0x05).
 *
 * GNSS velocity in the local level frame.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `vel_ned`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GQ7-GNSS/INS;
 * likely or assumed on 11 more.
 *
 * - 3dm-cv7-gnss-ins: NED Velocity (0x91,0x05)
 * - 3dm-cv7-gnss-ins: NED Velocity (0x92,0x05)
 * - 3dm-cv7-gnss-ins: NED Velocity (0x94,0x05)
 */
export declare class NedVelocity extends Data {
    constructor(values: Values<NedVelocity>);
    /**
     * Velocity of the antenna. Elements: north, east, down. Unit: m/s. Frame: ned. At rest and level: north 0, east 0,
     * down 0. Valid if `NedVelocityFlags.VELOCITY` of `validFlags` is set.
     */
    velocity: types.Ned3f;
    /** Speed in space. Unit: m/s. Range: at least 0. Valid if `NedVelocityFlags.SPEED_3D` of `validFlags` is set. */
    speed: number;
    /**
     * Speed over ground. Unit: m/s. Range: at least 0. Valid if `NedVelocityFlags.GROUND_SPEED` of `validFlags` is set.
     */
    groundSpeed: number;
    /**
     * Direction of the motion over ground. Unit: deg. Frame: ned. Positive: clockwise seen from above. Valid if
     * `NedVelocityFlags.HEADING` of `validFlags` is set.
     */
    heading: number;
    /**
     * Estimated error of the speed. Unit: m/s. Range: at least 0. Valid if `NedVelocityFlags.SPEED_ACCURACY` of
     * `validFlags` is set.
     */
    speedAccuracy: number;
    /**
     * Estimated error of the heading. Unit: deg. Range: at least 0. Valid if `NedVelocityFlags.HEADING_ACCURACY` of
     * `validFlags` is set.
     */
    headingAccuracy: number;
    /** Validity flags for the velocity. */
    validFlags: NedVelocityFlags;
}

/**
 * GNSS ECEF velocity (0x06).
 *
 * GNSS velocity in Earth-fixed coordinates.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `vel_ecef`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS, 3DM-GQ7-GNSS/INS and
 * 3DM-GX5-35; likely or assumed on 2 more.
 *
 * - 3dm-gx5-35: 5.2.4 ECEF Velocity (0x81, 0x06)
 * - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x91,0x06)
 * - 3dm-cv7-gnss-ins: GNSS ECEF Velocity (0x92,0x06)
 */
export declare class EcefVelocity extends Data {
    constructor(values: Values<EcefVelocity>);
    /**
     * Velocity of the antenna. Elements: x, y, z. Unit: m/s. Frame: ecef. At rest and level: x 0, y 0, z 0. Valid if
     * `EcefVelocityFlags.VELOCITY` of `validFlags` is set.
     */
    velocity: types.Vector3f;
    /**
     * Estimated error of the velocity. Unit: m/s. Range: at least 0. Valid if `EcefVelocityFlags.VELOCITY_ACCURACY` of
     * `validFlags` is set.
     */
    velocityAccuracy: number;
    /** Validity flags for the velocity. */
    validFlags: EcefVelocityFlags;
}

/**
 * DOP (0x07).
 *
 * Dilution of precision of the satellite geometry.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 4 more.
 *
 * - 3dm-cv7-gnss-ins: DOP (0x91,0x07)
 * - 3dm-cv7-gnss-ins: DOP (0x92,0x07)
 */
export declare class Dop extends Data {
    constructor(values: Values<Dop>);
    /** Geometric dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.GDOP` of `validFlags` is set. */
    gdop: number;
    /** Position dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.PDOP` of `validFlags` is set. */
    pdop: number;
    /** Horizontal dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.HDOP` of `validFlags` is set. */
    hdop: number;
    /** Vertical dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.VDOP` of `validFlags` is set. */
    vdop: number;
    /** Time dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.TDOP` of `validFlags` is set. */
    tdop: number;
    /** Northing dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.NDOP` of `validFlags` is set. */
    ndop: number;
    /** Easting dilution. Unit: 1. Range: at least 0. Valid if `DopFlags.EDOP` of `validFlags` is set. */
    edop: number;
    /** Validity flags for the dilutions of precision. */
    validFlags: DopFlags;
}

/**
 * UTC time (0x08).
 *
 * Coordinated universal time (UTC) according to the receiver.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 6 more.
 *
 * - 3dm-cv7-gnss-ins: UTC Time (0x91,0x08)
 * - 3dm-cv7-gnss-ins: UTC Time (0x92,0x08)
 * - 3dm-cv7-gnss-ins: UTC Time (0x94,0x08)
 */
export declare class UtcTime extends Data {
    constructor(values: Values<UtcTime>);
    /** Year with four digits. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set. */
    year: number;
    /** Month, 1 for January. Range: 1 to 12. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set. */
    month: number;
    /** Day of the month. Range: 1 to 31. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set. */
    day: number;
    /** Hour of the day. Range: 0 to 23. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set. */
    hour: number;
    /** Minute. Range: 0 to 59. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set. */
    min: number;
    /** Second. Unit: s. Range: 0 to 59. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set. */
    sec: number;
    /**
     * Fraction of the second. Unit: ms. Range: 0 to 999. Valid if `UtcTimeFlags.GNSS_DATE_TIME` of `validFlags` is set.
     */
    msec: number;
    /** Validity flags for the time. */
    validFlags: UtcTimeFlags;
}

/**
 * GPS time (0x09).
 *
 * GPS time according to the receiver.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 10 more.
 *
 * - 3dm-cv7-gnss-ins: GPS Time (0x91,0x09)
 * - 3dm-cv7-gnss-ins: GPS Time (0x92,0x09)
 */
export declare class GpsTime extends Data {
    constructor(values: Values<GpsTime>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `GpsTimeFlags.TOW` of `validFlags` is
     * set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `GpsTimeFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /** Validity flags for the time. */
    validFlags: GpsTimeFlags;
}

/**
 * Clock info (0x0A).
 *
 * Bias and drift of the receiver clock.
 *
 * No device is known for certain to support it. Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92),
 * gnss_corrections (0x93), gnss_external (0x94) and gnss_external_2 (0x95). Known only from the MicroStrain MIP SDK.
 *
 * Clock info 2 supersedes it and is more detailed.
 *
 * - mip-sdk-4: Clock Info (0x81,0x0A)
 */
export declare class ClockInfo extends Data {
    constructor(values: Values<ClockInfo>);
    /** Bias of the clock. Unit: s. Valid if `ClockInfoFlags.BIAS` of `validFlags` is set. */
    bias: number;
    /** Drift of the clock. Unit: s/s. Valid if `ClockInfoFlags.DRIFT` of `validFlags` is set. */
    drift: number;
    /**
     * Estimated error of the bias. Unit: s. Range: at least 0. Valid if `ClockInfoFlags.ACCURACY_ESTIMATE` of
     * `validFlags` is set.
     */
    accuracyEstimate: number;
    /** Validity flags for the clock parameters. */
    validFlags: ClockInfoFlags;
}

/**
 * Fix info (0x0B).
 *
 * Type of the position fix, with the satellites and corrections used.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS, 3DM-CV7-INS and 3DM-GQ7-GNSS/INS; likely or assumed on 5 more.
 *
 * - 3dm-cv7-gnss-ins: Fix Info (0x91,0x0B)
 * - 3dm-cv7-gnss-ins: Fix Info (0x92,0x0B)
 * - 3dm-cv7-gnss-ins: Fix Info (0x94,0x0B)
 */
export declare class FixInfo extends Data {
    constructor(values: Values<FixInfo>);
    /**
     * Quantities that the receiver can determine at present. Valid if `FixInfoFlags.FIX_TYPE` of `validFlags` is set.
     */
    fixType: types.GnssFixType;
    /** Number of satellites used in the fix. Unit: 1. Valid if `FixInfoFlags.NUM_SV` of `validFlags` is set. */
    numSv: number;
    /** Corrections and satellite systems of the fix. Valid if `FixInfoFlags.FIX_FLAGS` of `validFlags` is set. */
    fixFlags: FixFlags;
    /** Validity flags for the fix information. */
    validFlags: FixInfoFlags;
}

/**
 * Satellite info (0x0C).
 *
 * State of one tracked satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-GX5-45; likely or assumed on 2 more. Known only from the MicroStrain MIP
 * SDK. Uncertain: It is not known whether a packet contains one of these fields or several.
 *
 * Each satellite is sent as one field, in packets separate from other GNSS data.
 *
 * - mip-sdk-4: Sv Info (0x81,0x0C)
 */
export declare class SvInfo extends Data {
    constructor(values: Values<SvInfo>);
    /** Channel of the receiver that tracks the satellite. Valid if `SvInfoFlags.CHANNEL` of `validFlags` is set. */
    channel: number;
    /** Number of the satellite. Valid if `SvInfoFlags.SATELLITE_ID` of `validFlags` is set. */
    satelliteId: number;
    /**
     * Carrier to noise density ratio. Unit: dB-Hz. Valid if `SvInfoFlags.CARRIER_NOISE_RATIO` of `validFlags` is set.
     */
    carrierNoiseRatio: number;
    /**
     * Direction of the satellite, from true north. Unit: deg. Frame: ned. Positive: clockwise seen from above. Valid if
     * `SvInfoFlags.AZIMUTH` of `validFlags` is set.
     */
    azimuth: number;
    /**
     * Angle between the horizon and the satellite. Unit: deg. Frame: ned. Range: -90 to 90. Positive: above the
     * horizon. Valid if `SvInfoFlags.ELEVATION` of `validFlags` is set.
     */
    elevation: number;
    /** State of the satellite. Valid if `SvInfoFlags.SV_FLAGS` of `validFlags` is set. */
    svFlags: SvFlags;
    /** Validity flags for the satellite info. */
    validFlags: SvInfoFlags;
}

/**
 * GNSS hardware status (0x0D).
 *
 * State of the receiver and of its antenna.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `hw_status`. Confirmed on 3DM-CV7-GNSS/INS, 3DM-GQ7-GNSS/INS and 3DM-GX5-45;
 * likely or assumed on 2 more.
 *
 * - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x91,0x0D)
 * - 3dm-cv7-gnss-ins: GNSS Hardware Status (0x92,0x0D)
 */
export declare class HardwareStatus extends Data {
    constructor(values: Values<HardwareStatus>);
    /** Operating state of the receiver. Valid if `HardwareStatusFlags.SENSOR_STATE` of `validFlags` is set. */
    receiverState: ReceiverState;
    /** Electrical condition of the antenna. Valid if `HardwareStatusFlags.ANTENNA_STATE` of `validFlags` is set. */
    antennaState: AntennaState;
    /** State of the antenna's power supply. Valid if `HardwareStatusFlags.ANTENNA_POWER` of `validFlags` is set. */
    antennaPower: AntennaPower;
    /** Validity flags for the hardware status. */
    validFlags: HardwareStatusFlags;
}

/**
 * DGPS info (0x0E).
 *
 * State of the differential corrections.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). The size of its data distinguishes it from `DgpsInfoSatellite`. Confirmed on 3DM-GX5-35 and
 * 3DM-GX5-45; likely or assumed on 1 more. Uncertain: Devices could also send `DgpsInfoSatellite`, the layout of the
 * SDK, but only this one agrees with the valid flags, which are the same in all sources.
 *
 * The sources contradict each other. This layout is in a manual of the 3DM-GX5-35, in MSCL and in the SDK of 2014.
 *
 * - 3dm-gx5-35: 5.2.12 DGNSS Information (0x81, 0x0E)
 * - mscl: DGPS Info (0x81,0x0E)
 * - mip-sdk-2014: DGPS Info (0x81,0x0E)
 */
export declare class DgpsInfo extends Data {
    constructor(values: Values<DgpsInfo>);
    /**
     * Age of the corrections. Unit: s. Range: at least 0. Valid if `DgpsInfoFlags.AGE` of `validFlags` is set.
     * Uncertain: The unit is that of `DgpsChannel`; no source states it here.
     */
    age: number;
    /** Number of the base station. Valid if `DgpsInfoFlags.BASE_STATION_ID` of `validFlags` is set. */
    baseStationId: number;
    /**
     * State of the base station: 0 to 5 are factors of the user differential range error, which are 1.0, 0.75, 0.5,
     * 0.3, 0.2 and 0.1; 6 is not monitored, 7 not working. Valid if `DgpsInfoFlags.BASE_STATION_STATUS` of `validFlags`
     * is set.
     */
    baseStationStatus: number;
    /**
     * Number of channels that have corrections. Unit: 1. Valid if `DgpsInfoFlags.NUM_CHANNELS` of `validFlags` is set.
     */
    numChannels: number;
    /** Validity flags for the state of the corrections. */
    validFlags: DgpsInfoFlags;
}

/**
 * DGPS info for one satellite (0x0E).
 *
 * Differential correction for one satellite, in the SDK's layout of DGPS info.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). The size of its data distinguishes it from `DgpsInfo`. Not listed in any device profile.
 * Known only from the MicroStrain MIP SDK. Uncertain: Possibly no device sends it: the values are those of
 * `DgpsChannel`, but the flags those of `DgpsInfo`, so a mistake in the SDK is likely.
 *
 * The sources contradict each other. The manual of the 3DM-GX5-35 and MSCL document `DgpsInfo` instead. The flags of
 * `base_station_id`, `base_station_status` and `num_channels` correspond to no value in this layout.
 *
 * - mip-sdk-4: Dgps Info (0x81,0x0E)
 */
export declare class DgpsInfoSatellite extends Data {
    constructor(values: Values<DgpsInfoSatellite>);
    /** Number of the satellite. */
    satelliteId: number;
    /**
     * Age of the correction. Unit: s. Range: at least 0. Valid if `DgpsInfoFlags.AGE` of `validFlags` is set.
     * Uncertain: The unit is that of `DgpsChannel`; no source states it here.
     */
    age: number;
    /**
     * Differential correction of the pseudorange. Unit: m. Uncertain: The unit is that of `DgpsChannel`; no source
     * states it here.
     */
    rangeCorrection: number;
    /**
     * Rate of change of the correction. Unit: m/s. Uncertain: The unit is that of `DgpsChannel`; no source states it
     * here.
     */
    rangeRateCorrection: number;
    /** Validity flags for the state of the corrections. */
    validFlags: DgpsInfoFlags;
}

/**
 * DGPS channel (0x0F).
 *
 * Differential correction for one satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-GX5-45; likely or assumed on 2 more. Known only from the MIP SDK of 2014,
 * MicroStrain Communication Library and MicroStrain MIP SDK.
 *
 * Each active satellite is sent as one field, all in one packet.
 *
 * - mip-sdk-4: Dgps Channel (0x81,0x0F)
 * - mscl: DGPS Channel Status (0x81,0x0F)
 * - mip-sdk-2014: DGPS Channel (0x81,0x0F)
 */
export declare class DgpsChannel extends Data {
    constructor(values: Values<DgpsChannel>);
    /** Number of the satellite. Valid if `DgpsChannelFlags.SATELLITE_ID` of `validFlags` is set. */
    satelliteId: number;
    /** Age of the correction. Unit: s. Range: at least 0. Valid if `DgpsChannelFlags.AGE` of `validFlags` is set. */
    age: number;
    /**
     * Differential correction of the pseudorange. Unit: m. Valid if `DgpsChannelFlags.RANGE_CORRECTION` of `validFlags`
     * is set.
     */
    rangeCorrection: number;
    /**
     * Rate of change of the correction. Unit: m/s. Valid if `DgpsChannelFlags.RANGE_RATE_CORRECTION` of `validFlags` is
     * set.
     */
    rangeRateCorrection: number;
    /** Validity flags for a differential correction. */
    validFlags: DgpsChannelFlags;
}

/**
 * Clock info 2 (0x10).
 *
 * Bias and drift of the receiver clock.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 1 more. Uncertain: The
 * units are inferred from those of the ephemerides; no source states them.
 *
 * It supersedes clock info.
 *
 * - 3dm-cv7-gnss-ins: Clock Info 2 (0x91,0x10)
 * - 3dm-cv7-gnss-ins: Clock Info 2 (0x92,0x10)
 */
export declare class ClockInfo2 extends Data {
    constructor(values: Values<ClockInfo2>);
    /** Bias of the clock. Unit: s. Valid if `ClockInfo2Flags.BIAS` of `validFlags` is set. */
    bias: number;
    /** Drift of the clock. Unit: s/s. Valid if `ClockInfo2Flags.DRIFT` of `validFlags` is set. */
    drift: number;
    /**
     * Estimated error of the bias. Unit: s. Range: at least 0. Valid if `ClockInfo2Flags.BIAS_ACCURACY` of `validFlags`
     * is set.
     */
    biasAccuracyEstimate: number;
    /**
     * Estimated error of the drift. Unit: s/s. Range: at least 0. Valid if `ClockInfo2Flags.DRIFT_ACCURACY` of
     * `validFlags` is set.
     */
    driftAccuracyEstimate: number;
    /** Validity flags for the clock parameters. */
    validFlags: ClockInfo2Flags;
}

/**
 * GPS leap seconds (0x11).
 *
 * Difference between GPS time and UTC.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x91,0x11)
 * - 3dm-cv7-gnss-ins: GPS Leap Seconds (0x92,0x11)
 */
export declare class GpsLeapSeconds extends Data {
    constructor(values: Values<GpsLeapSeconds>);
    /** GPS time minus UTC. Unit: s. Valid if `GpsLeapSecondsFlags.LEAP_SECONDS` of `validFlags` is set. */
    leapSeconds: number;
    /** Validity of the leap seconds. */
    validFlags: GpsLeapSecondsFlags;
}

/**
 * SBAS info (0x12).
 *
 * Status of the satellite-based augmentation (SBAS).
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: SBAS Info (0x91,0x12)
 * - 3dm-cv7-gnss-ins: SBAS Info (0x92,0x12)
 */
export declare class SbasInfo extends Data {
    constructor(values: Values<SbasInfo>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `SbasInfoFlags.TOW` of `validFlags` is
     * set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `SbasInfoFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /** System in use. Valid if `SbasInfoFlags.SBAS_SYSTEM` of `validFlags` is set. */
    sbasSystem: SbasSystem;
    /** SBAS satellite. Valid if `SbasInfoFlags.SBAS_ID` of `validFlags` is set. */
    sbasId: number;
    /** Number of SBAS corrections. Unit: 1. Valid if `SbasInfoFlags.COUNT` of `validFlags` is set. */
    count: number;
    /** Status of the service. Valid if `SbasInfoFlags.SBAS_STATUS` of `validFlags` is set. */
    sbasStatus: SbasStatus;
    /** Validity flags for the SBAS status. */
    validFlags: SbasInfoFlags;
}

/**
 * SBAS correction (0x13).
 *
 * SBAS correction for one satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * An epoch is sent as one field for each satellite; `index` and `count` number the fields. For `udrei` 0 to 13, the
 * variances in m^2 are 0.0520, 0.0924, 0.1444, 0.2830, 0.4678, 0.8315, 1.2992, 1.8709, 2.5465, 3.3260, 5.1968, 20.7870,
 * 230.9661, 2078.695.
 *
 * - mip-sdk-4: Sbas Correction (0x81,0x13)
 */
export declare class SbasCorrection extends Data {
    constructor(values: Values<SbasCorrection>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /** GPS time of week of the reception. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week number. Unit: week. */
    weekNumber: number;
    /** Constellation. */
    gnssId: types.GnssConstellation;
    /** Satellite within the constellation. */
    satelliteId: number;
    /**
     * Indicator of the range error that remains after fast and long-term corrections, not counting the atmosphere; 14
     * is not monitored, 15 not usable. Range: 0 to 15. Valid if `SbasCorrectionFlags.UDREI` of `validFlags` is set.
     */
    udrei: number;
    /**
     * Correction of the pseudorange by the augmentation system. Unit: m. Valid if
     * `SbasCorrectionFlags.PSEUDORANGE_CORRECTION` of `validFlags` is set.
     */
    pseudorangeCorrection: number;
    /**
     * Correction of the ionospheric delay. Unit: m. Valid if `SbasCorrectionFlags.IONO_CORRECTION` of `validFlags` is
     * set.
     */
    ionoCorrection: number;
    /** Validity flags for an SBAS correction. */
    validFlags: SbasCorrectionFlags;
}

/**
 * RF error detection (0x14).
 *
 * Jamming and spoofing that the receiver detects in one band.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Supported by 3DM-CV7-INS and 3DM-GQ7-GNSS/INS. Known only from the MicroStrain MIP SDK.
 *
 * Version 4.0.0 of the SDK reserves the two bytes of `frequency`. Firmware from that time sends 0 there and does not
 * set its flag.
 *
 * - mip-sdk-4: Rf Error Detection (0x81,0x14)
 */
export declare class RfErrorDetection extends Data {
    constructor(values: Values<RfErrorDetection, "reserved">);
    /** Band to which the states apply. Valid if `RfErrorDetectionFlags.RF_BAND` of `validFlags` is set. */
    rfBand: RfBand;
    /** State of jamming in this band. Valid if `RfErrorDetectionFlags.JAMMING_STATE` of `validFlags` is set. */
    jammingState: JammingState;
    /** State of spoofing in this band. Valid if `RfErrorDetectionFlags.SPOOFING_STATE` of `validFlags` is set. */
    spoofingState: SpoofingState;
    /** Centre frequency of the band. Unit: MHz. Valid if `RfErrorDetectionFlags.FREQUENCY` of `validFlags` is set. */
    frequency: number;
    /** Reserved. */
    reserved: [number, number];
    /** Validity flags for the detection. */
    validFlags: RfErrorDetectionFlags;
}

/**
 * GNSS heading (0x15).
 *
 * Heading that the receiver computes from its antennas.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The SDK
 * names no device that sends it.
 *
 * - mip-sdk-4: Heading (0x81,0x15)
 */
export declare class Heading extends Data {
    constructor(values: Values<Heading>);
    /**
     * Heading of the baseline between the antennas, from true north. Unit: deg. Frame: ned. Positive: clockwise seen
     * from above. Valid if `HeadingFlags.HEADING` of `validFlags` is set. Uncertain: Clockwise from true north is
     * usual; the SDK only states degrees, and no range. Uncertain: No source states from which antenna to which the
     * baseline points. The opposite one differs by 180 degrees.
     */
    heading: number;
    /**
     * Uncertainty of the heading. Unit: deg. Range: at least 0. Valid if `HeadingFlags.UNCERTAINTY` of `validFlags` is
     * set. Uncertain: It is not known whether this is one standard deviation.
     */
    uncertainty: number;
    /** Kind of the fix. Valid if `HeadingFlags.FIX_TYPE` of `validFlags` is set. */
    fixType: HeadingFixType;
    /** Validity flags for the heading. */
    validFlags: HeadingFlags;
}

/**
 * Satellite status (0x20).
 *
 * Direction to one satellite, and its health.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS and 3DM-CV7-INS; likely or assumed on 3 more.
 *
 * An epoch is sent as one field for each satellite; `index` and `count` number the fields.
 *
 * - 3dm-cv7-gnss-ins: Satellite Status (0x91,0x20)
 * - 3dm-cv7-gnss-ins: Satellite Status (0x92,0x20)
 * - 3dm-cv7-gnss-ins: Satellite Status (0x94,0x20)
 */
export declare class SatelliteStatus extends Data {
    constructor(values: Values<SatelliteStatus>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `SatelliteStatusFlags.TOW` of
     * `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `SatelliteStatusFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /** Constellation. Valid if `SatelliteStatusFlags.GNSS_ID` of `validFlags` is set. */
    gnssId: types.GnssConstellation;
    /** Satellite within the constellation. Valid if `SatelliteStatusFlags.SATELLITE_ID` of `validFlags` is set. */
    satelliteId: number;
    /**
     * Angle between the horizon and the satellite, seen from the rover. Unit: deg. Frame: ned. Range: -90 to 90.
     * Positive: above the horizon. Valid if `SatelliteStatusFlags.ELEVATION` of `validFlags` is set.
     */
    elevation: number;
    /**
     * Direction of the satellite from the rover, from true north. Unit: deg. Frame: ned. Positive: clockwise seen from
     * above. Valid if `SatelliteStatusFlags.AZIMUTH` of `validFlags` is set.
     */
    azimuth: number;
    /** True if the satellite is healthy. Valid if `SatelliteStatusFlags.HEALTH` of `validFlags` is set. */
    health: boolean;
    /** Validity flags for the satellite status. */
    validFlags: SatelliteStatusFlags;
}

/**
 * Raw (0x22).
 *
 * Raw observation of one signal of one satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * An epoch is sent as one field for each signal; `index` and `count` number the fields. The greatest lock time depends
 * on the receiver.
 *
 * - 3dm-cv7-gnss-ins: Raw (0x91,0x22)
 * - 3dm-cv7-gnss-ins: Raw (0x92,0x22)
 */
export declare class Raw extends Data {
    constructor(values: Values<Raw>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `RawFlags.TOW` of `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `RawFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /**
     * Receiver, counted from 1; for a measurement from RTCM, the reference station. Valid if `RawFlags.RECEIVER_ID` of
     * `validFlags` is set.
     */
    receiverId: number;
    /** Channel that tracks the satellite. Valid if `RawFlags.TRACKING_CHANNEL` of `validFlags` is set. */
    trackingChannel: number;
    /** Constellation. Valid if `RawFlags.GNSS_ID` of `validFlags` is set. */
    gnssId: types.GnssConstellation;
    /** Satellite within the constellation. Valid if `RawFlags.SATELLITE_ID` of `validFlags` is set. */
    satelliteId: number;
    /** Signal of the satellite that was tracked. Valid if `RawFlags.SIGNAL_ID` of `validFlags` is set. */
    signalId: types.GnssSignal;
    /** Carrier to noise density ratio. Unit: dB-Hz. Valid if `RawFlags.SIGNAL_STRENGTH` of `validFlags` is set. */
    signalStrength: number;
    /** Tracking quality of the signal. Valid if `RawFlags.QUALITY` of `validFlags` is set. */
    quality: SignalQuality;
    /**
     * Measured distance, with the clock errors of receiver and satellite. Unit: m. Range: at least 0. Valid if
     * `RawFlags.PSEUDORANGE` of `validFlags` is set.
     */
    pseudorange: number;
    /**
     * Accumulated phase of the carrier; its initial number of cycles is arbitrary. Unit: cycle. Valid if
     * `RawFlags.CARRIER_PHASE` of `validFlags` is set.
     */
    carrierPhase: number;
    /** Doppler shift. Unit: Hz. Valid if `RawFlags.DOPPLER` of `validFlags` is set. */
    doppler: number;
    /**
     * Uncertainty of the pseudorange. Unit: m. Range: at least 0. Valid if `RawFlags.RANGE_UNCERTAINTY` of `validFlags`
     * is set.
     */
    rangeUncertainty: number;
    /**
     * Uncertainty of the carrier phase. Unit: cycle. Range: at least 0. Valid if `RawFlags.CARRIER_PHASE_UNCERTAINTY`
     * of `validFlags` is set.
     */
    phaseUncertainty: number;
    /**
     * Uncertainty of the Doppler shift. Unit: Hz. Range: at least 0. Valid if `RawFlags.DOPPLER_UNCERTAINTY` of
     * `validFlags` is set.
     */
    dopplerUncertainty: number;
    /**
     * Minimum time for which the carrier phase has been locked. Unit: s. Range: at least 0. Valid if
     * `RawFlags.LOCK_TIME` of `validFlags` is set.
     */
    lockTime: number;
    /** Validity flags for the observation. */
    validFlags: RawFlags;
}

/**
 * Base station info (0x30).
 *
 * Base station that sends the corrections, from RTCM message 1005 or 1006.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - mip-sdk-4: Base Station Info (0x81,0x30)
 * - 3dm-cv7-gnss-ins: Base Station Info (0x93,0x30)
 */
export declare class BaseStationInfo extends Data {
    constructor(values: Values<BaseStationInfo>);
    /**
     * GPS time of week at which the message was received. Unit: s. Range: at least 0, less than 604800. Valid if
     * `BaseStationInfoFlags.TOW` of `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `BaseStationInfoFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /**
     * Position of the station. Elements: x, y, z. Unit: m. Frame: ecef. Valid if `BaseStationInfoFlags.ECEF_POSITION`
     * of `validFlags` is set.
     */
    ecefPosition: types.Vector3d;
    /**
     * Height of the antenna above the surveyed marker. Unit: m. Valid if `BaseStationInfoFlags.HEIGHT` of `validFlags`
     * is set.
     */
    height: number;
    /** Number of the station. Range: 0 to 4095. Valid if `BaseStationInfoFlags.STATION_ID` of `validFlags` is set. */
    stationId: number;
    /** Properties of the station. Valid if `BaseStationInfoFlags.INDICATORS` of `validFlags` is set. */
    indicators: BaseStationIndicators;
    /** Valid values. */
    validFlags: BaseStationInfoFlags;
}

/**
 * RTK corrections status (0x31).
 *
 * Received corrections and their age.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Supported by 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS.
 *
 * - mip-sdk-4: Rtk Corrections Status (0x81,0x31)
 * - 3dm-cv7-gnss-ins: RTK Corrections Status (0x93,0x31)
 */
export declare class RtkCorrectionsStatus extends Data {
    constructor(values: Values<RtkCorrectionsStatus, "reserved">);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `RtkCorrectionsStatusFlags.TOW` of
     * `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `RtkCorrectionsStatusFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /**
     * Corrections received during this epoch. Valid if `RtkCorrectionsStatusFlags.EPOCH_STATUS` of `validFlags` is set.
     */
    epochStatus: RtkEpochStatus;
    /**
     * Status flags of the RTK dongle, meaningful only if one is connected. Valid if
     * `RtkCorrectionsStatusFlags.DONGLE_STATUS` of `validFlags` is set. The same word as in the response to
     * `rtk.GetStatusFlags`, in one of its two forms.
     */
    dongleStatus: types.RtkStatusFlags;
    /**
     * Latency of the last GPS correction. Unit: s. Range: at least 0. Valid if `RtkCorrectionsStatusFlags.GPS_LATENCY`
     * of `validFlags` is set.
     */
    gpsCorrectionLatency: number;
    /**
     * Latency of the last GLONASS correction. Unit: s. Range: at least 0. Valid if
     * `RtkCorrectionsStatusFlags.GLONASS_LATENCY` of `validFlags` is set.
     */
    glonassCorrectionLatency: number;
    /**
     * Latency of the last Galileo correction. Unit: s. Range: at least 0. Valid if
     * `RtkCorrectionsStatusFlags.GALILEO_LATENCY` of `validFlags` is set.
     */
    galileoCorrectionLatency: number;
    /**
     * Latency of the last BeiDou correction. Unit: s. Range: at least 0. Valid if
     * `RtkCorrectionsStatusFlags.BEIDOU_LATENCY` of `validFlags` is set.
     */
    beidouCorrectionLatency: number;
    /** Reserved. */
    reserved: [number, number, number, number];
    /** Valid values. */
    validFlags: RtkCorrectionsStatusFlags;
}

/**
 * GPS ephemeris (0x61).
 *
 * Broadcast orbit and clock of one GPS satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * `iodc` changes with the clock data; according to the manual, it rolls over at 4.
 *
 * - 3dm-cv7-gnss-ins: GPS Ephemeris (0x91,0x61)
 * - 3dm-cv7-gnss-ins: GPS Ephemeris (0x92,0x61)
 */
export declare class GpsEphemeris extends Data {
    constructor(values: Values<GpsEphemeris>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week number. Unit: week. */
    weekNumber: number;
    /** Satellite within the constellation. */
    satelliteId: number;
    /** Health of satellite and signals. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    health: number;
    /** Issue of data, clock. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iodc: number;
    /** Issue of data, ephemeris. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iode: number;
    /**
     * Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tOc: number;
    /** Clock bias. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af0: number;
    /** Clock drift. Unit: s/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af1: number;
    /** Clock drift rate. Unit: s/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af2: number;
    /** Group delay. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    tGd: number;
    /** Inter-signal correction for L1. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iscL1ca: number;
    /**
     * Inter-signal correction for L2, or for L5 if `isc_l5` is set. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    iscL2c: number;
    /**
     * Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tOe: number;
    /** Semi-major axis. Unit: m. Range: greater than 0. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    a: number;
    /** Rate of the semi-major axis. Unit: m/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    aDot: number;
    /** Mean anomaly at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    meanAnomaly: number;
    /** Correction of the mean motion. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    deltaMeanMotion: number;
    /**
     * Rate of the correction of the mean motion. Unit: rad/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    deltaMeanMotionDot: number;
    /**
     * Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    eccentricity: number;
    /**
     * Angle from the ascending node to the perigee. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    argumentOfPerigee: number;
    /** Longitude of the ascending node. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    omega: number;
    /** Rate of the right ascension. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    omegaDot: number;
    /**
     * Inclination of the orbit at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    inclination: number;
    /** Rate of the inclination. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    inclinationDot: number;
    /**
     * Cosine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cIc: number;
    /**
     * Sine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cIs: number;
    /**
     * Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    cUc: number;
    /**
     * Sine harmonic correction of the argument of latitude. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    cUs: number;
    /**
     * Cosine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cRc: number;
    /**
     * Sine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cRs: number;
    /** Contents of the ephemeris. */
    validFlags: EphemerisFlags;
}

/**
 * GLONASS ephemeris (0x62).
 *
 * Broadcast orbit and clock of one GLONASS satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `glo_ephemeris`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * The GLONASS interface control document explains p and ft. A period of four years has 1461 days; no source states how
 * nt, a u8, counts them.
 *
 * - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x91,0x62)
 * - 3dm-cv7-gnss-ins: Glonass Ephemeris (0x92,0x62)
 */
export declare class GlonassEphemeris extends Data {
    constructor(values: Values<GlonassEphemeris>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week number. Unit: week. */
    weekNumber: number;
    /** Satellite within the constellation. */
    satelliteId: number;
    /** GLONASS frequency number. Range: -7 to 24. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    frequencyNumber: number;
    /**
     * Start of the frame within the day. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tk: number;
    /** Reference time of the ephemeris. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    tb: number;
    /** Generation of the satellite (M). Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    satelliteType: GlonassSatelliteType;
    /**
     * Relative deviation of the carrier frequency from its nominal value. Unit: 1. Valid if
     * `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    gamma: number;
    /**
     * Correction of the satellite time relative to GLONASS time. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    tauN: number;
    /**
     * Position of the satellite in PZ-90. Elements: x, y, z. Unit: m. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    position: types.Vector3d;
    /**
     * Velocity of the satellite in PZ-90. Elements: x, y, z. Unit: m/s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    velocity: types.Vector3f;
    /**
     * Acceleration of the satellite due to perturbations, in PZ-90. Elements: x, y, z. Unit: m/s^2. Valid if
     * `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    accel: types.Vector3f;
    /**
     * Health (Bn); nonzero if the satellite is malfunctioning. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    health: number;
    /** Mode of operation of the satellite. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    p: number;
    /**
     * Day within a period of four years. Unit: day. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    nt: number;
    /**
     * Time difference between L1 and L2. Unit: s. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    deltaTauN: number;
    /** Code of the user range accuracy. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    ft: number;
    /** Age of the information. Unit: day. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    en: number;
    /**
     * Time between adjacent values of tb. Unit: min. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    p1: number;
    /**
     * 1 if tb is odd, 0 if it is even. Range: 0 to 1. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    p2: number;
    /**
     * Number of satellites in the almanac of the frame. Unit: 1. Valid if `GlonassEphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    p3: number;
    /** Presence of ephemeris parameters. Valid if `GlonassEphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    p4: number;
    /** Validity of the ephemeris. */
    validFlags: GlonassEphemerisFlags;
}

/**
 * Galileo ephemeris (0x63).
 *
 * Broadcast orbit and clock of one Galileo satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * It has the layout of the GPS ephemeris. No source states what the two inter-signal corrections mean here. `iodc`
 * changes with the clock data; according to the manual, it rolls over at 4.
 *
 * - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x91,0x63)
 * - 3dm-cv7-gnss-ins: Galileo Ephemeris (0x92,0x63)
 */
export declare class GalileoEphemeris extends Data {
    constructor(values: Values<GalileoEphemeris>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week number. Unit: week. */
    weekNumber: number;
    /** Satellite within the constellation. */
    satelliteId: number;
    /** Health of satellite and signals. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    health: number;
    /** Issue of data, clock. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iodc: number;
    /** Issue of data, ephemeris. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iode: number;
    /**
     * Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tOc: number;
    /** Clock bias. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af0: number;
    /** Clock drift. Unit: s/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af1: number;
    /** Clock drift rate. Unit: s/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af2: number;
    /** Group delay. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    tGd: number;
    /**
     * Value in the position of the GPS inter-signal correction for L1. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    iscL1ca: number;
    /**
     * Value in the position of the GPS inter-signal correction for L2 or L5. Unit: s. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    iscL2c: number;
    /**
     * Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tOe: number;
    /** Semi-major axis. Unit: m. Range: greater than 0. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    a: number;
    /** Rate of the semi-major axis. Unit: m/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    aDot: number;
    /** Mean anomaly at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    meanAnomaly: number;
    /** Correction of the mean motion. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    deltaMeanMotion: number;
    /**
     * Rate of the correction of the mean motion. Unit: rad/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    deltaMeanMotionDot: number;
    /**
     * Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    eccentricity: number;
    /**
     * Angle from the ascending node to the perigee. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    argumentOfPerigee: number;
    /** Longitude of the ascending node. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    omega: number;
    /** Rate of the right ascension. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    omegaDot: number;
    /**
     * Inclination of the orbit at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    inclination: number;
    /** Rate of the inclination. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    inclinationDot: number;
    /**
     * Cosine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cIc: number;
    /**
     * Sine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cIs: number;
    /**
     * Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    cUc: number;
    /**
     * Sine harmonic correction of the argument of latitude. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    cUs: number;
    /**
     * Cosine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cRc: number;
    /**
     * Sine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cRs: number;
    /** Contents of the ephemeris. */
    validFlags: EphemerisFlags;
}

/**
 * BeiDou ephemeris (0x64).
 *
 * Broadcast orbit and clock of one BeiDou satellite.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * It has the layout of the GPS ephemeris. No source states what the two inter-signal corrections mean here. `iodc`
 * changes with the clock data; according to the manual, it rolls over at 4.
 *
 * - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x91,0x64)
 * - 3dm-cv7-gnss-ins: BeiDou Ephemeris (0x92,0x64)
 */
export declare class BeidouEphemeris extends Data {
    constructor(values: Values<BeidouEphemeris>);
    /** Index of this field within the epoch. */
    index: number;
    /** Number of such fields in the epoch. */
    count: number;
    /** GPS time of week. Unit: s. Range: at least 0, less than 604800. */
    tow: number;
    /** GPS week number. Unit: week. */
    weekNumber: number;
    /** Satellite within the constellation. */
    satelliteId: number;
    /** Health of satellite and signals. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    health: number;
    /** Issue of data, clock. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iodc: number;
    /** Issue of data, ephemeris. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    iode: number;
    /**
     * Reference time of the clock data. Unit: s. Range: at least 0, less than 604800. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tOc: number;
    /** Clock bias. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af0: number;
    /** Clock drift. Unit: s/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af1: number;
    /** Clock drift rate. Unit: s/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    af2: number;
    /** Group delay. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    tGd: number;
    /**
     * Value in the position of the GPS inter-signal correction for L1. Unit: s. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    iscL1ca: number;
    /**
     * Value in the position of the GPS inter-signal correction for L2 or L5. Unit: s. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    iscL2c: number;
    /**
     * Reference time of the ephemeris. Unit: s. Range: at least 0, less than 604800. Valid if
     * `EphemerisFlags.EPHEMERIS` of `validFlags` is set.
     */
    tOe: number;
    /** Semi-major axis. Unit: m. Range: greater than 0. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    a: number;
    /** Rate of the semi-major axis. Unit: m/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    aDot: number;
    /** Mean anomaly at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    meanAnomaly: number;
    /** Correction of the mean motion. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    deltaMeanMotion: number;
    /**
     * Rate of the correction of the mean motion. Unit: rad/s^2. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    deltaMeanMotionDot: number;
    /**
     * Eccentricity of the orbit. Unit: 1. Range: at least 0, less than 1. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    eccentricity: number;
    /**
     * Angle from the ascending node to the perigee. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    argumentOfPerigee: number;
    /** Longitude of the ascending node. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    omega: number;
    /** Rate of the right ascension. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    omegaDot: number;
    /**
     * Inclination of the orbit at the reference time. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    inclination: number;
    /** Rate of the inclination. Unit: rad/s. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is set. */
    inclinationDot: number;
    /**
     * Cosine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cIc: number;
    /**
     * Sine harmonic correction of the inclination. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cIs: number;
    /**
     * Cosine harmonic correction of the argument of latitude. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    cUc: number;
    /**
     * Sine harmonic correction of the argument of latitude. Unit: rad. Valid if `EphemerisFlags.EPHEMERIS` of
     * `validFlags` is set.
     */
    cUs: number;
    /**
     * Cosine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cRc: number;
    /**
     * Sine harmonic correction of the orbit radius. Unit: m. Valid if `EphemerisFlags.EPHEMERIS` of `validFlags` is
     * set.
     */
    cRs: number;
    /** Contents of the ephemeris. */
    validFlags: EphemerisFlags;
}

/**
 * GPS ionospheric correction (0x71).
 *
 * Ionospheric model that GPS broadcasts.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `gps_iono_corr`. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Gps Iono Corr (0x81,0x71)
 */
export declare class GpsIonoCorrection extends Data {
    constructor(values: Values<GpsIonoCorrection>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `GpsIonoCorrectionFlags.TOW` of
     * `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `GpsIonoCorrectionFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /**
     * Coefficients alpha 0 to 3. Valid if `GpsIonoCorrectionFlags.ALPHA` of `validFlags` is set. Uncertain: No source
     * states the units.
     */
    alpha: [number, number, number, number];
    /**
     * Coefficients beta 0 to 3. Valid if `GpsIonoCorrectionFlags.BETA` of `validFlags` is set. Uncertain: No source
     * states the units.
     */
    beta: [number, number, number, number];
    /** Validity flags for the model. */
    validFlags: GpsIonoCorrectionFlags;
}

/**
 * Galileo ionospheric correction (0x73).
 *
 * Ionospheric model that Galileo broadcasts.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `galileo_iono_corr`. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Galileo Iono Corr (0x81,0x73)
 */
export declare class GalileoIonoCorrection extends Data {
    constructor(values: Values<GalileoIonoCorrection>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `GalileoIonoCorrectionFlags.TOW` of
     * `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `GalileoIonoCorrectionFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /**
     * The three coefficients of the model. Valid if `GalileoIonoCorrectionFlags.ALPHA` of `validFlags` is set.
     * Uncertain: No source states the units.
     */
    alpha: [number, number, number];
    /**
     * Ionospheric storms, one bit (1 to 5) for each of five regions. Valid if
     * `GalileoIonoCorrectionFlags.DISTURBANCE_FLAGS` of `validFlags` is set. Uncertain: No source states whether the
     * bits count from 0 or from 1, or the region of each.
     */
    disturbanceFlags: number;
    /** Validity flags for the model. */
    validFlags: GalileoIonoCorrectionFlags;
}

/**
 * BeiDou ionospheric correction (0x74).
 *
 * Ionospheric model that BeiDou broadcasts.
 *
 * Occurs in gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Also called `beidou_iono_corr`. Not listed in any device profile. Known only from the
 * MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Beidou Iono Corr (0x81,0x74)
 */
export declare class BeidouIonoCorrection extends Data {
    constructor(values: Values<BeidouIonoCorrection>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `BeidouIonoCorrectionFlags.TOW` of
     * `validFlags` is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `BeidouIonoCorrectionFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /**
     * Coefficients alpha 0 to 3. Valid if `BeidouIonoCorrectionFlags.ALPHA` of `validFlags` is set. Uncertain: No
     * source states the units.
     */
    alpha: [number, number, number, number];
    /**
     * Coefficients beta 0 to 3. Valid if `BeidouIonoCorrectionFlags.BETA` of `validFlags` is set. Uncertain: No source
     * states the units.
     */
    beta: [number, number, number, number];
    /**
     * Nine further coefficients of the delay. Valid if `BeidouIonoCorrectionFlags.ALPHA_CORRECTION` of `validFlags` is
     * set. Uncertain: No source states the units.
     */
    alphaCorrection: number[];
    /** Validity flags for the model. */
    validFlags: BeidouIonoCorrectionFlags;
}
