// GNSS data: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const LlhPositionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    LAT_LON: [0, 0],
    ELLIPSOID_HEIGHT: [1, 1],
    MSL_HEIGHT: [2, 2],
    HORIZONTAL_ACCURACY: [3, 3],
    VERTICAL_ACCURACY: [4, 4],
    FLAGS: [0, 4],
});

export const EcefPositionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    POSITION: [0, 0],
    POSITION_ACCURACY: [1, 1],
    FLAGS: [0, 1],
});

export const NedVelocityFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    VELOCITY: [0, 0],
    SPEED_3D: [1, 1],
    GROUND_SPEED: [2, 2],
    HEADING: [3, 3],
    SPEED_ACCURACY: [4, 4],
    HEADING_ACCURACY: [5, 5],
    FLAGS: [0, 5],
});

export const EcefVelocityFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    VELOCITY: [0, 0],
    VELOCITY_ACCURACY: [1, 1],
    FLAGS: [0, 1],
});

export const DopFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    GDOP: [0, 0],
    PDOP: [1, 1],
    HDOP: [2, 2],
    VDOP: [3, 3],
    TDOP: [4, 4],
    NDOP: [5, 5],
    EDOP: [6, 6],
    FLAGS: [0, 6],
});

export const UtcTimeFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    GNSS_DATE_TIME: [0, 0],
    LEAP_SECONDS_KNOWN: [1, 1],
    FLAGS: [0, 1],
});

export const GpsTimeFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    FLAGS: [0, 1],
});

export const ClockInfoFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    BIAS: [0, 0],
    DRIFT: [1, 1],
    ACCURACY_ESTIMATE: [2, 2],
    FLAGS: [0, 2],
});

export const FixFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    SBAS_USED: [0, 0],
    DGNSS_USED: [1, 1],
});

export const FixInfoFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    FIX_TYPE: [0, 0],
    NUM_SV: [1, 1],
    FIX_FLAGS: [2, 2],
    FLAGS: [0, 2],
});

export const SvFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    USED_FOR_NAVIGATION: [0, 0],
    HEALTHY: [1, 1],
});

export const SvInfoFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    CHANNEL: [0, 0],
    SATELLITE_ID: [1, 1],
    CARRIER_NOISE_RATIO: [2, 2],
    AZIMUTH: [3, 3],
    ELEVATION: [4, 4],
    SV_FLAGS: [5, 5],
    FLAGS: [0, 5],
});

export const ReceiverState = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OFF: 0,
    ON: 1,
    UNKNOWN: 2,
});

export const AntennaState = /* @__PURE__ */ codec.enumeration(codec.u8, {
    INIT: 1,
    SHORT: 2,
    OPEN: 3,
    GOOD: 4,
    UNKNOWN: 5,
});

export const AntennaPower = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OFF: 0,
    ON: 1,
    UNKNOWN: 2,
});

export const HardwareStatusFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    SENSOR_STATE: [0, 0],
    ANTENNA_STATE: [1, 1],
    ANTENNA_POWER: [2, 2],
    FLAGS: [0, 2],
});

export const DgpsInfoFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    AGE: [0, 0],
    BASE_STATION_ID: [1, 1],
    BASE_STATION_STATUS: [2, 2],
    NUM_CHANNELS: [3, 3],
    FLAGS: [0, 3],
});

export const DgpsChannelFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    SATELLITE_ID: [0, 0],
    AGE: [1, 1],
    RANGE_CORRECTION: [2, 2],
    RANGE_RATE_CORRECTION: [3, 3],
    FLAGS: [0, 3],
});

export const ClockInfo2Flags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    BIAS: [0, 0],
    DRIFT: [1, 1],
    BIAS_ACCURACY: [2, 2],
    DRIFT_ACCURACY: [3, 3],
    FLAGS: [0, 3],
});

export const GpsLeapSecondsFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    LEAP_SECONDS: [1, 1],
});

export const SbasSystem = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    WAAS: 1,
    EGNOS: 2,
    MSAS: 3,
    GAGAN: 4,
});

export const SbasStatus = /* @__PURE__ */ codec.bitfield(codec.u8, {
    RANGE_AVAILABLE: [0, 0],
    CORRECTIONS_AVAILABLE: [1, 1],
    INTEGRITY_AVAILABLE: [2, 2],
    TEST_MODE: [3, 3],
});

export const SbasInfoFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    SBAS_SYSTEM: [2, 2],
    SBAS_ID: [3, 3],
    COUNT: [4, 4],
    SBAS_STATUS: [5, 5],
    FLAGS: [0, 5],
});

export const SbasCorrectionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    UDREI: [0, 0],
    PSEUDORANGE_CORRECTION: [1, 1],
    IONO_CORRECTION: [2, 2],
    FLAGS: [0, 2],
});

export const RfBand = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    L1: 1,
    L2: 2,
    L5: 5,
});

export const JammingState = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    NONE: 1,
    PARTIAL: 2,
    SIGNIFICANT: 3,
});

export const SpoofingState = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    NONE: 1,
    PARTIAL: 2,
    SIGNIFICANT: 3,
});

export const RfErrorDetectionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    RF_BAND: [0, 0],
    JAMMING_STATE: [1, 1],
    SPOOFING_STATE: [2, 2],
    FREQUENCY: [3, 3],
    FLAGS: [0, 3],
});

export const HeadingFixType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    UNKNOWN: 0,
    FLOAT: 1,
    FIXED: 2,
});

export const HeadingFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    HEADING: [0, 0],
    UNCERTAINTY: [1, 1],
    FIX_TYPE: [2, 2],
    FLAGS: [0, 2],
});

export const SatelliteStatusFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    GNSS_ID: [2, 2],
    SATELLITE_ID: [3, 3],
    ELEVATION: [4, 4],
    AZIMUTH: [5, 5],
    HEALTH: [6, 6],
    FLAGS: [0, 6],
});

export const SignalQuality = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    SEARCHING: 1,
    ACQUIRED: 2,
    UNUSABLE: 3,
    TIME_LOCKED: 4,
    FULLY_LOCKED: 5,
});

export const RawFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    RECEIVER_ID: [2, 2],
    TRACKING_CHANNEL: [3, 3],
    GNSS_ID: [4, 4],
    SATELLITE_ID: [5, 5],
    SIGNAL_ID: [6, 6],
    SIGNAL_STRENGTH: [7, 7],
    QUALITY: [8, 8],
    PSEUDORANGE: [9, 9],
    CARRIER_PHASE: [10, 10],
    DOPPLER: [11, 11],
    RANGE_UNCERTAINTY: [12, 12],
    CARRIER_PHASE_UNCERTAINTY: [13, 13],
    DOPPLER_UNCERTAINTY: [14, 14],
    LOCK_TIME: [15, 15],
    FLAGS: [0, 15],
});

export const BaseStationIndicators = /* @__PURE__ */ codec.bitfield(codec.u16, {
    GPS: [0, 0],
    GLONASS: [1, 1],
    GALILEO: [2, 2],
    BEIDOU: [3, 3],
    REFERENCE_STATION: [4, 4],
    SINGLE_RECEIVER: [5, 5],
    QUARTER_CYCLE_BIT1: [6, 6],
    QUARTER_CYCLE_BIT2: [7, 7],
    QUARTER_CYCLE_BITS: [6, 7],
});

export const BaseStationInfoFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    ECEF_POSITION: [2, 2],
    HEIGHT: [3, 3],
    STATION_ID: [4, 4],
    INDICATORS: [5, 5],
    FLAGS: [0, 5],
});

export const RtkEpochStatus = /* @__PURE__ */ codec.bitfield(codec.u16, {
    ANTENNA_LOCATION_RECEIVED: [0, 0],
    ANTENNA_DESCRIPTION_RECEIVED: [1, 1],
    GPS_RECEIVED: [2, 2],
    GLONASS_RECEIVED: [3, 3],
    GALILEO_RECEIVED: [4, 4],
    BEIDOU_RECEIVED: [5, 5],
    USING_GPS_MSM_MESSAGES: [6, 6],
    USING_GLONASS_MSM_MESSAGES: [7, 7],
    DONGLE_STATUS_READ_FAILED: [8, 8],
});

export const RtkCorrectionsStatusFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    EPOCH_STATUS: [2, 2],
    DONGLE_STATUS: [3, 3],
    GPS_LATENCY: [4, 4],
    GLONASS_LATENCY: [5, 5],
    GALILEO_LATENCY: [6, 6],
    BEIDOU_LATENCY: [7, 7],
    FLAGS: [0, 7],
});

export const EphemerisFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    EPHEMERIS: [0, 0],
    MODERN_DATA: [1, 1],
    ISC_L5: [2, 2],
    FLAGS: [0, 2],
});

export const GlonassSatelliteType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    GLONASS: 0,
    GLONASS_M: 1,
});

export const GlonassEphemerisFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    EPHEMERIS: [0, 0],
    FLAGS: [0, 0],
});

export const GpsIonoCorrectionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    ALPHA: [2, 2],
    BETA: [3, 3],
    FLAGS: [0, 3],
});

export const GalileoIonoCorrectionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    ALPHA: [2, 2],
    DISTURBANCE_FLAGS: [3, 3],
    FLAGS: [0, 3],
});

export const BeidouIonoCorrectionFlags = /* @__PURE__ */ codec.bitfield(codec.u16, {
    TOW: [0, 0],
    WEEK_NUMBER: [1, 1],
    ALPHA: [2, 2],
    BETA: [3, 3],
    ALPHA_CORRECTION: [4, 4],
    FLAGS: [0, 4],
});

export const LlhPosition = /* @__PURE__ */ field.data("gnss_data.llh_position", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x03, (values, reader) => {
    values.latitude = codec.double(reader, 0);
    values.longitude = codec.double(reader, 8);
    values.ellipsoidHeight = codec.double(reader, 16);
    values.mslHeight = codec.double(reader, 24);
    values.horizontalAccuracy = codec.float(reader, 32);
    values.verticalAccuracy = codec.float(reader, 36);
    values.validFlags = codec.u16(reader, 40);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { latitude: 0x1, longitude: 0x1, ellipsoidHeight: 0x2, mslHeight: 0x4, horizontalAccuracy: 0x8, verticalAccuracy: 0x10 } }),
});

export const EcefPosition = /* @__PURE__ */ field.data("gnss_data.ecef_position", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x04, (values, reader) => {
    values.position = types.Vector3d(reader, 0);
    values.positionAccuracy = codec.float(reader, 24);
    values.validFlags = codec.u16(reader, 28);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { position: 0x1, positionAccuracy: 0x2 } }),
});

export const NedVelocity = /* @__PURE__ */ field.data("gnss_data.ned_velocity", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x05, (values, reader) => {
    values.velocity = types.Ned3f(reader, 0);
    values.speed = codec.float(reader, 12);
    values.groundSpeed = codec.float(reader, 16);
    values.heading = codec.float(reader, 20);
    values.speedAccuracy = codec.float(reader, 24);
    values.headingAccuracy = codec.float(reader, 28);
    values.validFlags = codec.u16(reader, 32);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: 0x1, speed: 0x2, groundSpeed: 0x4, heading: 0x8, speedAccuracy: 0x10, headingAccuracy: 0x20 } }),
});

export const EcefVelocity = /* @__PURE__ */ field.data("gnss_data.ecef_velocity", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x06, (values, reader) => {
    values.velocity = types.Vector3f(reader, 0);
    values.velocityAccuracy = codec.float(reader, 12);
    values.validFlags = codec.u16(reader, 16);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { velocity: 0x1, velocityAccuracy: 0x2 } }),
});

export const Dop = /* @__PURE__ */ field.data("gnss_data.dop", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x07, (values, reader) => {
    values.gdop = codec.float(reader, 0);
    values.pdop = codec.float(reader, 4);
    values.hdop = codec.float(reader, 8);
    values.vdop = codec.float(reader, 12);
    values.tdop = codec.float(reader, 16);
    values.ndop = codec.float(reader, 20);
    values.edop = codec.float(reader, 24);
    values.validFlags = codec.u16(reader, 28);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { gdop: 0x1, pdop: 0x2, hdop: 0x4, vdop: 0x8, tdop: 0x10, ndop: 0x20, edop: 0x40 } }),
});

export const UtcTime = /* @__PURE__ */ field.data("gnss_data.utc_time", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x08, (values, reader) => {
    values.year = codec.u16(reader, 0);
    values.month = codec.u8(reader, 2);
    values.day = codec.u8(reader, 3);
    values.hour = codec.u8(reader, 4);
    values.min = codec.u8(reader, 5);
    values.sec = codec.u8(reader, 6);
    values.msec = codec.u32(reader, 7);
    values.validFlags = codec.u16(reader, 11);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { year: 0x1, month: 0x1, day: 0x1, hour: 0x1, min: 0x1, sec: 0x1, msec: 0x1 } }),
});

export const GpsTime = /* @__PURE__ */ field.data("gnss_data.gps_time", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x09, (values, reader) => {
    values.tow = codec.double(reader, 0);
    values.weekNumber = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2 } }),
});

export const ClockInfo = /* @__PURE__ */ field.data("gnss_data.clock_info", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0a, (values, reader) => {
    values.bias = codec.double(reader, 0);
    values.drift = codec.double(reader, 8);
    values.accuracyEstimate = codec.double(reader, 16);
    values.validFlags = codec.u16(reader, 24);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1, drift: 0x2, accuracyEstimate: 0x4 } }),
});

export const FixInfo = /* @__PURE__ */ field.data("gnss_data.fix_info", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0b, (values, reader) => {
    values.fixType = codec.u8(reader, 0);
    values.numSv = codec.u8(reader, 1);
    values.fixFlags = codec.u16(reader, 2);
    values.validFlags = codec.u16(reader, 4);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { fixType: 0x1, numSv: 0x2, fixFlags: 0x4 } }),
});

export const SvInfo = /* @__PURE__ */ field.data("gnss_data.sv_info", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0c, (values, reader) => {
    values.channel = codec.u8(reader, 0);
    values.satelliteId = codec.u8(reader, 1);
    values.carrierNoiseRatio = codec.u16(reader, 2);
    values.azimuth = codec.s16(reader, 4);
    values.elevation = codec.s16(reader, 6);
    values.svFlags = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { channel: 0x1, satelliteId: 0x2, carrierNoiseRatio: 0x4, azimuth: 0x8, elevation: 0x10, svFlags: 0x20 } }),
});

export const HardwareStatus = /* @__PURE__ */ field.data("gnss_data.hardware_status", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0d, (values, reader) => {
    values.receiverState = codec.u8(reader, 0);
    values.antennaState = codec.u8(reader, 1);
    values.antennaPower = codec.u8(reader, 2);
    values.validFlags = codec.u16(reader, 3);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { receiverState: 0x1, antennaState: 0x2, antennaPower: 0x4 } }),
});

export const DgpsInfo = /* @__PURE__ */ field.data("gnss_data.dgps_info", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0e, (values, reader) => {
    values.age = codec.float(reader, 0);
    values.baseStationId = codec.s16(reader, 4);
    values.baseStationStatus = codec.s16(reader, 6);
    values.numChannels = codec.u16(reader, 8);
    values.validFlags = codec.u16(reader, 10);
}, {
    fits: [0, 14, []],
    VALID: /* @__PURE__ */ field.validity({ validFlags: { age: 0x1, baseStationId: 0x2, baseStationStatus: 0x4, numChannels: 0x8 } }),
});

export const DgpsInfoSatellite = /* @__PURE__ */ field.data("gnss_data.dgps_info_satellite", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0e, (values, reader) => {
    values.satelliteId = codec.u8(reader, 0);
    values.age = codec.float(reader, 1);
    values.rangeCorrection = codec.float(reader, 5);
    values.rangeRateCorrection = codec.float(reader, 9);
    values.validFlags = codec.u16(reader, 13);
}, {
    fits: [15, 253, []],
    VALID: /* @__PURE__ */ field.validity({ validFlags: { age: 0x1 } }),
});

export const DgpsChannel = /* @__PURE__ */ field.data("gnss_data.dgps_channel", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x0f, (values, reader) => {
    values.satelliteId = codec.u8(reader, 0);
    values.age = codec.float(reader, 1);
    values.rangeCorrection = codec.float(reader, 5);
    values.rangeRateCorrection = codec.float(reader, 9);
    values.validFlags = codec.u16(reader, 13);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { satelliteId: 0x1, age: 0x2, rangeCorrection: 0x4, rangeRateCorrection: 0x8 } }),
});

export const ClockInfo2 = /* @__PURE__ */ field.data("gnss_data.clock_info_2", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x10, (values, reader) => {
    values.bias = codec.double(reader, 0);
    values.drift = codec.double(reader, 8);
    values.biasAccuracyEstimate = codec.double(reader, 16);
    values.driftAccuracyEstimate = codec.double(reader, 24);
    values.validFlags = codec.u16(reader, 32);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { bias: 0x1, drift: 0x2, biasAccuracyEstimate: 0x4, driftAccuracyEstimate: 0x8 } }),
});

export const GpsLeapSeconds = /* @__PURE__ */ field.data("gnss_data.gps_leap_seconds", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x11, (values, reader) => {
    values.leapSeconds = codec.u8(reader, 0);
    values.validFlags = codec.u16(reader, 1);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { leapSeconds: 0x2 } }),
});

export const SbasInfo = /* @__PURE__ */ field.data("gnss_data.sbas_info", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x12, (values, reader) => {
    values.tow = codec.double(reader, 0);
    values.weekNumber = codec.u16(reader, 8);
    values.sbasSystem = codec.u8(reader, 10);
    values.sbasId = codec.u8(reader, 11);
    values.count = codec.u8(reader, 12);
    values.sbasStatus = codec.u8(reader, 13);
    values.validFlags = codec.u16(reader, 14);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, sbasSystem: 0x4, sbasId: 0x8, count: 0x10, sbasStatus: 0x20 } }),
});

export const SbasCorrection = /* @__PURE__ */ field.data("gnss_data.sbas_correction", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x13, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.gnssId = codec.u8(reader, 12);
    values.satelliteId = codec.u8(reader, 13);
    values.udrei = codec.u8(reader, 14);
    values.pseudorangeCorrection = codec.float(reader, 15);
    values.ionoCorrection = codec.float(reader, 19);
    values.validFlags = codec.u16(reader, 23);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { udrei: 0x1, pseudorangeCorrection: 0x2, ionoCorrection: 0x4 } }),
});

export const RfErrorDetection = /* @__PURE__ */ field.data("gnss_data.rf_error_detection", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x14, {
    rfBand: RfBand,
    jammingState: JammingState,
    spoofingState: SpoofingState,
    frequency: codec.u16,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 2), Array(2).fill(0)),
    validFlags: RfErrorDetectionFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { rfBand: 0x1, jammingState: 0x2, spoofingState: 0x4, frequency: 0x8 } }),
});

export const Heading = /* @__PURE__ */ field.data("gnss_data.heading", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x15, (values, reader) => {
    values.heading = codec.float(reader, 0);
    values.uncertainty = codec.float(reader, 4);
    values.fixType = codec.u8(reader, 8);
    values.validFlags = codec.u16(reader, 9);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { heading: 0x1, uncertainty: 0x2, fixType: 0x4 } }),
});

export const SatelliteStatus = /* @__PURE__ */ field.data("gnss_data.satellite_status", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x20, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.gnssId = codec.u8(reader, 12);
    values.satelliteId = codec.u8(reader, 13);
    values.elevation = codec.float(reader, 14);
    values.azimuth = codec.float(reader, 18);
    values.health = codec.bool(reader, 22);
    values.validFlags = codec.u16(reader, 23);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, gnssId: 0x4, satelliteId: 0x8, elevation: 0x10, azimuth: 0x20, health: 0x40 } }),
});

export const Raw = /* @__PURE__ */ field.data("gnss_data.raw", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x22, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.receiverId = codec.u16(reader, 12);
    values.trackingChannel = codec.u8(reader, 14);
    values.gnssId = codec.u8(reader, 15);
    values.satelliteId = codec.u8(reader, 16);
    values.signalId = codec.u8(reader, 17);
    values.signalStrength = codec.float(reader, 18);
    values.quality = codec.u8(reader, 22);
    values.pseudorange = codec.double(reader, 23);
    values.carrierPhase = codec.double(reader, 31);
    values.doppler = codec.float(reader, 39);
    values.rangeUncertainty = codec.float(reader, 43);
    values.phaseUncertainty = codec.float(reader, 47);
    values.dopplerUncertainty = codec.float(reader, 51);
    values.lockTime = codec.float(reader, 55);
    values.validFlags = codec.u16(reader, 59);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, receiverId: 0x4, trackingChannel: 0x8, gnssId: 0x10, satelliteId: 0x20, signalId: 0x40, signalStrength: 0x80, quality: 0x100, pseudorange: 0x200, carrierPhase: 0x400, doppler: 0x800, rangeUncertainty: 0x1000, phaseUncertainty: 0x2000, dopplerUncertainty: 0x4000, lockTime: 0x8000 } }),
});

export const BaseStationInfo = /* @__PURE__ */ field.data("gnss_data.base_station_info", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x30, (values, reader) => {
    values.tow = codec.double(reader, 0);
    values.weekNumber = codec.u16(reader, 8);
    values.ecefPosition = types.Vector3d(reader, 10);
    values.height = codec.float(reader, 34);
    values.stationId = codec.u16(reader, 38);
    values.indicators = codec.u16(reader, 40);
    values.validFlags = codec.u16(reader, 42);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, ecefPosition: 0x4, height: 0x8, stationId: 0x10, indicators: 0x20 } }),
});

export const RtkCorrectionsStatus = /* @__PURE__ */ field.data("gnss_data.rtk_corrections_status", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x31, {
    tow: codec.double,
    weekNumber: codec.u16,
    epochStatus: RtkEpochStatus,
    dongleStatus: types.RtkStatusFlags,
    gpsCorrectionLatency: codec.float,
    glonassCorrectionLatency: codec.float,
    galileoCorrectionLatency: codec.float,
    beidouCorrectionLatency: codec.float,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u32, 0), 4), Array(4).fill(0)),
    validFlags: RtkCorrectionsStatusFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, epochStatus: 0x4, dongleStatus: 0x8, gpsCorrectionLatency: 0x10, glonassCorrectionLatency: 0x20, galileoCorrectionLatency: 0x40, beidouCorrectionLatency: 0x80 } }),
});

export const GpsEphemeris = /* @__PURE__ */ field.data("gnss_data.gps_ephemeris", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x61, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.satelliteId = codec.u8(reader, 12);
    values.health = codec.u8(reader, 13);
    values.iodc = codec.u8(reader, 14);
    values.iode = codec.u8(reader, 15);
    values.tOc = codec.double(reader, 16);
    values.af0 = codec.double(reader, 24);
    values.af1 = codec.double(reader, 32);
    values.af2 = codec.double(reader, 40);
    values.tGd = codec.double(reader, 48);
    values.iscL1ca = codec.double(reader, 56);
    values.iscL2c = codec.double(reader, 64);
    values.tOe = codec.double(reader, 72);
    values.a = codec.double(reader, 80);
    values.aDot = codec.double(reader, 88);
    values.meanAnomaly = codec.double(reader, 96);
    values.deltaMeanMotion = codec.double(reader, 104);
    values.deltaMeanMotionDot = codec.double(reader, 112);
    values.eccentricity = codec.double(reader, 120);
    values.argumentOfPerigee = codec.double(reader, 128);
    values.omega = codec.double(reader, 136);
    values.omegaDot = codec.double(reader, 144);
    values.inclination = codec.double(reader, 152);
    values.inclinationDot = codec.double(reader, 160);
    values.cIc = codec.double(reader, 168);
    values.cIs = codec.double(reader, 176);
    values.cUc = codec.double(reader, 184);
    values.cUs = codec.double(reader, 192);
    values.cRc = codec.double(reader, 200);
    values.cRs = codec.double(reader, 208);
    values.validFlags = codec.u16(reader, 216);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { health: 0x1, iodc: 0x1, iode: 0x1, tOc: 0x1, af0: 0x1, af1: 0x1, af2: 0x1, tGd: 0x1, iscL1ca: 0x1, iscL2c: 0x1, tOe: 0x1, a: 0x1, aDot: 0x1, meanAnomaly: 0x1, deltaMeanMotion: 0x1, deltaMeanMotionDot: 0x1, eccentricity: 0x1, argumentOfPerigee: 0x1, omega: 0x1, omegaDot: 0x1, inclination: 0x1, inclinationDot: 0x1, cIc: 0x1, cIs: 0x1, cUc: 0x1, cUs: 0x1, cRc: 0x1, cRs: 0x1 } }),
});

export const GlonassEphemeris = /* @__PURE__ */ field.data("gnss_data.glonass_ephemeris", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x62, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.satelliteId = codec.u8(reader, 12);
    values.frequencyNumber = codec.s8(reader, 13);
    values.tk = codec.u32(reader, 14);
    values.tb = codec.u32(reader, 18);
    values.satelliteType = codec.u8(reader, 22);
    values.gamma = codec.double(reader, 23);
    values.tauN = codec.double(reader, 31);
    values.position = types.Vector3d(reader, 39);
    values.velocity = types.Vector3f(reader, 63);
    values.accel = types.Vector3f(reader, 75);
    values.health = codec.u8(reader, 87);
    values.p = codec.u8(reader, 88);
    values.nt = codec.u8(reader, 89);
    values.deltaTauN = codec.float(reader, 90);
    values.ft = codec.u8(reader, 94);
    values.en = codec.u8(reader, 95);
    values.p1 = codec.u8(reader, 96);
    values.p2 = codec.u8(reader, 97);
    values.p3 = codec.u8(reader, 98);
    values.p4 = codec.u8(reader, 99);
    values.validFlags = codec.u16(reader, 100);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { frequencyNumber: 0x1, tk: 0x1, tb: 0x1, satelliteType: 0x1, gamma: 0x1, tauN: 0x1, position: 0x1, velocity: 0x1, accel: 0x1, health: 0x1, p: 0x1, nt: 0x1, deltaTauN: 0x1, ft: 0x1, en: 0x1, p1: 0x1, p2: 0x1, p3: 0x1, p4: 0x1 } }),
});

export const GalileoEphemeris = /* @__PURE__ */ field.data("gnss_data.galileo_ephemeris", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x63, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.satelliteId = codec.u8(reader, 12);
    values.health = codec.u8(reader, 13);
    values.iodc = codec.u8(reader, 14);
    values.iode = codec.u8(reader, 15);
    values.tOc = codec.double(reader, 16);
    values.af0 = codec.double(reader, 24);
    values.af1 = codec.double(reader, 32);
    values.af2 = codec.double(reader, 40);
    values.tGd = codec.double(reader, 48);
    values.iscL1ca = codec.double(reader, 56);
    values.iscL2c = codec.double(reader, 64);
    values.tOe = codec.double(reader, 72);
    values.a = codec.double(reader, 80);
    values.aDot = codec.double(reader, 88);
    values.meanAnomaly = codec.double(reader, 96);
    values.deltaMeanMotion = codec.double(reader, 104);
    values.deltaMeanMotionDot = codec.double(reader, 112);
    values.eccentricity = codec.double(reader, 120);
    values.argumentOfPerigee = codec.double(reader, 128);
    values.omega = codec.double(reader, 136);
    values.omegaDot = codec.double(reader, 144);
    values.inclination = codec.double(reader, 152);
    values.inclinationDot = codec.double(reader, 160);
    values.cIc = codec.double(reader, 168);
    values.cIs = codec.double(reader, 176);
    values.cUc = codec.double(reader, 184);
    values.cUs = codec.double(reader, 192);
    values.cRc = codec.double(reader, 200);
    values.cRs = codec.double(reader, 208);
    values.validFlags = codec.u16(reader, 216);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { health: 0x1, iodc: 0x1, iode: 0x1, tOc: 0x1, af0: 0x1, af1: 0x1, af2: 0x1, tGd: 0x1, iscL1ca: 0x1, iscL2c: 0x1, tOe: 0x1, a: 0x1, aDot: 0x1, meanAnomaly: 0x1, deltaMeanMotion: 0x1, deltaMeanMotionDot: 0x1, eccentricity: 0x1, argumentOfPerigee: 0x1, omega: 0x1, omegaDot: 0x1, inclination: 0x1, inclinationDot: 0x1, cIc: 0x1, cIs: 0x1, cUc: 0x1, cUs: 0x1, cRc: 0x1, cRs: 0x1 } }),
});

export const BeidouEphemeris = /* @__PURE__ */ field.data("gnss_data.beidou_ephemeris", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x64, (values, reader) => {
    values.index = codec.u8(reader, 0);
    values.count = codec.u8(reader, 1);
    values.tow = codec.double(reader, 2);
    values.weekNumber = codec.u16(reader, 10);
    values.satelliteId = codec.u8(reader, 12);
    values.health = codec.u8(reader, 13);
    values.iodc = codec.u8(reader, 14);
    values.iode = codec.u8(reader, 15);
    values.tOc = codec.double(reader, 16);
    values.af0 = codec.double(reader, 24);
    values.af1 = codec.double(reader, 32);
    values.af2 = codec.double(reader, 40);
    values.tGd = codec.double(reader, 48);
    values.iscL1ca = codec.double(reader, 56);
    values.iscL2c = codec.double(reader, 64);
    values.tOe = codec.double(reader, 72);
    values.a = codec.double(reader, 80);
    values.aDot = codec.double(reader, 88);
    values.meanAnomaly = codec.double(reader, 96);
    values.deltaMeanMotion = codec.double(reader, 104);
    values.deltaMeanMotionDot = codec.double(reader, 112);
    values.eccentricity = codec.double(reader, 120);
    values.argumentOfPerigee = codec.double(reader, 128);
    values.omega = codec.double(reader, 136);
    values.omegaDot = codec.double(reader, 144);
    values.inclination = codec.double(reader, 152);
    values.inclinationDot = codec.double(reader, 160);
    values.cIc = codec.double(reader, 168);
    values.cIs = codec.double(reader, 176);
    values.cUc = codec.double(reader, 184);
    values.cUs = codec.double(reader, 192);
    values.cRc = codec.double(reader, 200);
    values.cRs = codec.double(reader, 208);
    values.validFlags = codec.u16(reader, 216);
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { health: 0x1, iodc: 0x1, iode: 0x1, tOc: 0x1, af0: 0x1, af1: 0x1, af2: 0x1, tGd: 0x1, iscL1ca: 0x1, iscL2c: 0x1, tOe: 0x1, a: 0x1, aDot: 0x1, meanAnomaly: 0x1, deltaMeanMotion: 0x1, deltaMeanMotionDot: 0x1, eccentricity: 0x1, argumentOfPerigee: 0x1, omega: 0x1, omegaDot: 0x1, inclination: 0x1, inclinationDot: 0x1, cIc: 0x1, cIs: 0x1, cUc: 0x1, cUs: 0x1, cRc: 0x1, cRs: 0x1 } }),
});

export const GpsIonoCorrection = /* @__PURE__ */ field.data("gnss_data.gps_iono_correction", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x71, {
    tow: codec.double,
    weekNumber: codec.u16,
    alpha: /* @__PURE__ */ codec.array(codec.double, 4),
    beta: /* @__PURE__ */ codec.array(codec.double, 4),
    validFlags: GpsIonoCorrectionFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, alpha: 0x4, beta: 0x8 } }),
});

export const GalileoIonoCorrection = /* @__PURE__ */ field.data("gnss_data.galileo_iono_correction", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x73, {
    tow: codec.double,
    weekNumber: codec.u16,
    alpha: /* @__PURE__ */ codec.array(codec.double, 3),
    disturbanceFlags: codec.u8,
    validFlags: GalileoIonoCorrectionFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, alpha: 0x4, disturbanceFlags: 0x8 } }),
});

export const BeidouIonoCorrection = /* @__PURE__ */ field.data("gnss_data.beidou_iono_correction", [0x81, 0x91, 0x92, 0x93, 0x94, 0x95], 0x74, {
    tow: codec.double,
    weekNumber: codec.u16,
    alpha: /* @__PURE__ */ codec.array(codec.double, 4),
    beta: /* @__PURE__ */ codec.array(codec.double, 4),
    alphaCorrection: /* @__PURE__ */ codec.array(codec.double, 9),
    validFlags: BeidouIonoCorrectionFlags,
}, {
    VALID: /* @__PURE__ */ field.validity({ validFlags: { tow: 0x1, weekNumber: 0x2, alpha: 0x4, beta: 0x8, alphaCorrection: 0x10 } }),
});
