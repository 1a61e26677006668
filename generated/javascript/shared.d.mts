/**
 * Shared data (0xFF).
 *
 * Fields that every data set can contain. No packet has this descriptor set: the fields are sent in packets of the
 * other data sets.
 *
 * - 3dm-cv7-gnss-ins: Shared (0xFF)
 * - 3dm-cv7-gnss-ins: Shared Data Descriptors
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type GpsTimestampFlags = Flavor<number, "shared.gps_timestamp_flags">;
/** Validity flags for the GPS time. */
export declare const GpsTimestampFlags: Bitfield<GpsTimestampFlags> & {
    /** The whole seconds of the time of week have been set. Bit 0. */
    readonly TOW: GpsTimestampFlags;
    /** The week number has been set. Bit 1. */
    readonly WEEK_NUMBER: GpsTimestampFlags;
    /** The time of week and the week number have been set. Bits 0 to 1. Overlaps other bits. */
    readonly TIME_VALID: GpsTimestampFlags;
};

export type ExternalTimestampFlags = Flavor<number, "shared.external_timestamp_flags">;
/** Validity of the external time. */
export declare const ExternalTimestampFlags: Bitfield<ExternalTimestampFlags> & {
    /** The time is valid. Bit 0. */
    readonly NANOSECONDS: ExternalTimestampFlags;
};

export type ExternalTimeDeltaFlags = Flavor<number, "shared.external_time_delta_flags">;
/** Validity of the external time difference. */
export declare const ExternalTimeDeltaFlags: Bitfield<ExternalTimeDeltaFlags> & {
    /** The difference is valid. Bit 0. */
    readonly DT_NANOS: ExternalTimeDeltaFlags;
};

/**
 * Event source (0xFF,0xD0).
 *
 * The event trigger that caused the packet.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 8 more.
 *
 * Put it first in the format of event messages, to distinguish their packets from scheduled ones.
 *
 * - 3dm-cv7-gnss-ins: Event Source (0xFF,0xD0)
 */
export declare class EventSource extends Data {
    constructor(values: Values<EventSource>);
    /** Id of the trigger; 0 means that the packet was scheduled by `3dm.MessageFormat`. */
    triggerId: number;
}

/**
 * Ticks (0xFF,0xD1).
 *
 * Base periods since power-up.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: According to the SDK, the
 * counter returns to 0 after about 50 days. That fits 2^32 ticks at 1000 Hz; at other rates that time would be longer
 * or shorter.
 *
 * A tick is one period at the base rate of the device.
 *
 * - mip-sdk-4: Ticks (0xFF,0xD1)
 */
export declare class Ticks extends Data {
    constructor(values: Values<Ticks>);
    /** Base periods since the device started, modulo 2^32. Unit: 1. */
    ticks: number;
}

/**
 * Delta ticks (0xFF,0xD2).
 *
 * Number of base periods between the previous field of this kind and this one.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: Each set and each event
 * instance may count separately, as with `DeltaTime`.
 *
 * A tick is one period at the base rate of the device.
 *
 * - mip-sdk-4: Delta ticks (0xFF,0xD2)
 */
export declare class DeltaTicks extends Data {
    constructor(values: Values<DeltaTicks>);
    /** Base periods since the previous field of this kind. Unit: 1. */
    ticks: number;
}

/**
 * GPS timestamp (0xFF,0xD3).
 *
 * External time of the data as GPS time of week and week number.
 *
 * Confirmed on 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-GNSS/INS and 3DM-GQ7-GNSS/INS; likely or assumed on 7 more.
 *
 * In event messages it is the time of the trigger. It becomes valid after the PPS is locked and `base.GpsTimeUpdate`
 * has set the time of week and the week number. With an internal GNSS receiver as PPS source, the device usually sets
 * the time itself. With NMEA input, a ZDA sentence sets the time to UTC: the value is then behind GPS time by the leap
 * seconds, which are 18 s since 2017. `base.GpsTimeUpdate` sets GPS time.
 *
 * - 3dm-cv7-gnss-ins: GPS Timestamp (0xFF,0xD3)
 * - 3dm-cv7-gnss-ins: Configure the External GNSS Receiver
 * - 3dm-cv7-gnss-ins: RECEIVER Source
 */
export declare class GpsTimestamp extends Data {
    constructor(values: Values<GpsTimestamp>);
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if `GpsTimestampFlags.TOW` of `validFlags`
     * is set.
     */
    tow: number;
    /** GPS week number. Unit: week. Valid if `GpsTimestampFlags.WEEK_NUMBER` of `validFlags` is set. */
    weekNumber: number;
    /** Validity flags for the timestamp. */
    validFlags: GpsTimestampFlags;
}

/**
 * Delta time (0xFF,0xD4).
 *
 * External time since this field was last sent in the same set and event instance.
 *
 * Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * It is the same as `ExternalTimeDelta`, in other units. Sending either restarts the counter that both share, so use
 * only one of them.
 *
 * - 3dm-cv7-gnss-ins: Delta Time (0xFF,0xD4)
 */
export declare class DeltaTime extends Data {
    constructor(values: Values<DeltaTime>);
    /** Time since the last output. Unit: s. Range: at least 0. */
    seconds: number;
}

/**
 * Reference timestamp (0xFF,0xD5).
 *
 * Time of the data by the internal reference clock.
 *
 * Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * The clock starts at power-on, only moves forward and never jumps; the value is always valid. In event messages it is
 * the time of the trigger.
 *
 * - 3dm-cv7-gnss-ins: Reference Timestamp (0xFF,0xD5)
 */
export declare class ReferenceTimestamp extends Data {
    constructor(values: Values<ReferenceTimestamp>);
    /** Time since initialization. Unit: ns. */
    nanoseconds: bigint;
}

/**
 * Reference time delta (0xFF,0xD6).
 *
 * Reference time since this field was last sent in the same set and event instance.
 *
 * Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * The value is always valid.
 *
 * - 3dm-cv7-gnss-ins: Reference Time Delta (0xFF,0xD6)
 */
export declare class ReferenceTimeDelta extends Data {
    constructor(values: Values<ReferenceTimeDelta>);
    /** Time since the last output. Unit: ns. */
    dtNanos: bigint;
}

/**
 * External timestamp (0xFF,0xD7).
 *
 * Time of the data in the external clock domain.
 *
 * Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * It is `GpsTimestamp` in nanoseconds. In event messages it is the time of the trigger. It becomes valid when the
 * external clock is synchronized through the PPS. Its epoch is the epoch of the time sent with `base.GpsTimeUpdate`: in
 * most systems that of GPS time, but possibly another, such as the Unix epoch. Use `GpsTimestamp` for GPS time only.
 * With a receiver as the source of the PPS (`3dm.PpsSourceControl`), it is GPS time, and valid only while that receiver
 * has a fix.
 *
 * - 3dm-cv7-gnss-ins: External Timestamp (0xFF,0xD7)
 * - 3dm-cv7-gnss-ins: Timestamps
 * - 3dm-cv7-gnss-ins: RECEIVER Source
 */
export declare class ExternalTimestamp extends Data {
    constructor(values: Values<ExternalTimestamp>);
    /** External time. Unit: ns. Valid if `ExternalTimestampFlags.NANOSECONDS` of `validFlags` is set. */
    nanoseconds: bigint;
    /** Validity of the time. */
    validFlags: ExternalTimestampFlags;
}

/**
 * External time delta (0xFF,0xD8).
 *
 * External time since this field was last sent in the same set and event instance.
 *
 * Confirmed on 3DM-CV7-AR and 3DM-CV7-GNSS/INS; likely or assumed on 9 more.
 *
 * It is the same as `DeltaTime`, in other units. Sending either restarts the counter that both share, so use only one
 * of them.
 *
 * - 3dm-cv7-gnss-ins: External Time Delta (0xFF,0xD8)
 */
export declare class ExternalTimeDelta extends Data {
    constructor(values: Values<ExternalTimeDelta>);
    /** Time since the last output. Unit: ns. Valid if `ExternalTimeDeltaFlags.DT_NANOS` of `validFlags` is set. */
    dtNanos: bigint;
    /** Validity of the difference. */
    validFlags: ExternalTimeDeltaFlags;
}
