/**
 * @file
 *
 * Shared data (0xFF). Fields that every data set can contain. No packet has this descriptor set:
 * the fields are sent in packets of the other data sets.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_SHARED_H
#define MIP_SHARED_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/shared.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_shared Shared data (0xFF)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_SHARED_SET 0xFF

/** Validity flags for the GPS time. */
typedef uint16_t mip_shared_gps_timestamp_flags;
/** Bit 0. The whole seconds of the time of week have been set. */
#define MIP_SHARED_GPS_TIMESTAMP_FLAGS_TOW 0x0001U
/** Bit 1. The week number has been set. */
#define MIP_SHARED_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER 0x0002U
/** Bits 0 to 1. The time of week and the week number have been set. Overlaps other bits. */
#define MIP_SHARED_GPS_TIMESTAMP_FLAGS_TIME_VALID 0x0003U

/** Validity of the external time. */
typedef uint16_t mip_shared_external_timestamp_flags;
/** Bit 0. The time is valid. */
#define MIP_SHARED_EXTERNAL_TIMESTAMP_FLAGS_NANOSECONDS 0x0001U

/** Validity of the external time difference. */
typedef uint16_t mip_shared_external_time_delta_flags;
/** Bit 0. The difference is valid. */
#define MIP_SHARED_EXTERNAL_TIME_DELTA_FLAGS_DT_NANOS 0x0001U

/**
 * Event source: data (0xFF,0xD0).
 *
 * The event trigger that caused the packet.
 *
 * Put it first in the format of event messages, to distinguish their packets from scheduled ones.
 *
 * - 3dm-cv7-gnss-ins: Event Source (0xFF,0xD0)
 */
struct mip_shared_event_source {
    /** Id of the trigger; 0 means that the packet was scheduled by mip_3dm_message_format. */
    uint8_t trigger_id;
};

#define MIP_SHARED_EVENT_SOURCE 0xFFD0
#define MIP_SHARED_EVENT_SOURCE_DESCRIPTOR 0xD0
MIP_FIELD(mip_shared_event_source, 0xD0);

/**
 * Ticks: data (0xFF,0xD1).
 *
 * Base periods since power-up.
 *
 * Known only from the MicroStrain MIP SDK. Uncertain: According to the SDK, the counter returns to
 * 0 after about 50 days. That fits 2^32 ticks at 1000 Hz; at other rates that time would be longer
 * or shorter.
 *
 * A tick is one period at the base rate of the device.
 *
 * - mip-sdk-4: Ticks (0xFF,0xD1)
 */
struct mip_shared_ticks {
    /** Base periods since the device started, modulo 2^32. Unit: 1. */
    uint32_t ticks;
};

#define MIP_SHARED_TICKS 0xFFD1
#define MIP_SHARED_TICKS_DESCRIPTOR 0xD1
MIP_FIELD(mip_shared_ticks, 0xD1);

/**
 * Delta ticks: data (0xFF,0xD2).
 *
 * Number of base periods between the previous field of this kind and this one.
 *
 * Known only from the MicroStrain MIP SDK. Uncertain: Each set and each event instance may count
 * separately, as with mip_shared_delta_time.
 *
 * A tick is one period at the base rate of the device.
 *
 * - mip-sdk-4: Delta ticks (0xFF,0xD2)
 */
struct mip_shared_delta_ticks {
    /** Base periods since the previous field of this kind. Unit: 1. */
    uint32_t ticks;
};

#define MIP_SHARED_DELTA_TICKS 0xFFD2
#define MIP_SHARED_DELTA_TICKS_DESCRIPTOR 0xD2
MIP_FIELD(mip_shared_delta_ticks, 0xD2);

/**
 * GPS timestamp: data (0xFF,0xD3).
 *
 * External time of the data as GPS time of week and week number.
 *
 * In event messages it is the time of the trigger.
 *
 * It becomes valid after the PPS is locked and mip_base_gps_time_update has set the time of week
 * and the week number.
 *
 * With an internal GNSS receiver as PPS source, the device usually sets the time itself.
 *
 * With NMEA input, a ZDA sentence sets the time to UTC: the value is then behind GPS time by the
 * leap seconds, which are 18 s since 2017. mip_base_gps_time_update sets GPS time.
 *
 * - 3dm-cv7-gnss-ins: GPS Timestamp (0xFF,0xD3)
 * - 3dm-cv7-gnss-ins: Configure the External GNSS Receiver
 * - 3dm-cv7-gnss-ins: RECEIVER Source
 */
struct mip_shared_gps_timestamp {
    /**
     * GPS time of week. Unit: s. Range: at least 0, less than 604800. Valid if
     * MIP_SHARED_GPS_TIMESTAMP_FLAGS_TOW in valid_flags is set.
     */
    double tow;
    /**
     * GPS week number. Unit: week. Valid if MIP_SHARED_GPS_TIMESTAMP_FLAGS_WEEK_NUMBER in
     * valid_flags is set.
     */
    uint16_t week_number;
    /** Validity flags for the timestamp. */
    mip_shared_gps_timestamp_flags valid_flags;
};

#define MIP_SHARED_GPS_TIMESTAMP 0xFFD3
#define MIP_SHARED_GPS_TIMESTAMP_DESCRIPTOR 0xD3
MIP_FIELD(mip_shared_gps_timestamp, 0xD3);

/**
 * Delta time: data (0xFF,0xD4).
 *
 * External time since this field was last sent in the same set and event instance.
 *
 * It is the same as mip_shared_external_time_delta, in other units.
 *
 * Sending either restarts the counter that both share, so use only one of them.
 *
 * - 3dm-cv7-gnss-ins: Delta Time (0xFF,0xD4)
 */
struct mip_shared_delta_time {
    /** Time since the last output. Unit: s. Range: at least 0. */
    double seconds;
};

#define MIP_SHARED_DELTA_TIME 0xFFD4
#define MIP_SHARED_DELTA_TIME_DESCRIPTOR 0xD4
MIP_FIELD(mip_shared_delta_time, 0xD4);

/**
 * Reference timestamp: data (0xFF,0xD5).
 *
 * Time of the data by the internal reference clock.
 *
 * The clock starts at power-on, only moves forward and never jumps; the value is always valid.
 *
 * In event messages it is the time of the trigger.
 *
 * - 3dm-cv7-gnss-ins: Reference Timestamp (0xFF,0xD5)
 */
struct mip_shared_reference_timestamp {
    /** Time since initialization. Unit: ns. */
    uint64_t nanoseconds;
};

#define MIP_SHARED_REFERENCE_TIMESTAMP 0xFFD5
#define MIP_SHARED_REFERENCE_TIMESTAMP_DESCRIPTOR 0xD5
MIP_FIELD(mip_shared_reference_timestamp, 0xD5);

/**
 * Reference time delta: data (0xFF,0xD6).
 *
 * Reference time since this field was last sent in the same set and event instance.
 *
 * The value is always valid.
 *
 * - 3dm-cv7-gnss-ins: Reference Time Delta (0xFF,0xD6)
 */
struct mip_shared_reference_time_delta {
    /** Time since the last output. Unit: ns. */
    uint64_t dt_nanos;
};

#define MIP_SHARED_REFERENCE_TIME_DELTA 0xFFD6
#define MIP_SHARED_REFERENCE_TIME_DELTA_DESCRIPTOR 0xD6
MIP_FIELD(mip_shared_reference_time_delta, 0xD6);

/**
 * External timestamp: data (0xFF,0xD7).
 *
 * Time of the data in the external clock domain.
 *
 * It is mip_shared_gps_timestamp in nanoseconds.
 *
 * In event messages it is the time of the trigger.
 *
 * It becomes valid when the external clock is synchronized through the PPS.
 *
 * Its epoch is the epoch of the time sent with mip_base_gps_time_update: in most systems that of
 * GPS time, but possibly another, such as the Unix epoch. Use mip_shared_gps_timestamp for GPS time
 * only.
 *
 * With a receiver as the source of the PPS (mip_3dm_pps_source_control), it is GPS time, and valid
 * only while that receiver has a fix.
 *
 * - 3dm-cv7-gnss-ins: External Timestamp (0xFF,0xD7)
 * - 3dm-cv7-gnss-ins: Timestamps
 * - 3dm-cv7-gnss-ins: RECEIVER Source
 */
struct mip_shared_external_timestamp {
    /**
     * External time. Unit: ns. Valid if MIP_SHARED_EXTERNAL_TIMESTAMP_FLAGS_NANOSECONDS in
     * valid_flags is set.
     */
    uint64_t nanoseconds;
    /** Validity of the time. */
    mip_shared_external_timestamp_flags valid_flags;
};

#define MIP_SHARED_EXTERNAL_TIMESTAMP 0xFFD7
#define MIP_SHARED_EXTERNAL_TIMESTAMP_DESCRIPTOR 0xD7
MIP_FIELD(mip_shared_external_timestamp, 0xD7);

/**
 * External time delta: data (0xFF,0xD8).
 *
 * External time since this field was last sent in the same set and event instance.
 *
 * It is the same as mip_shared_delta_time, in other units.
 *
 * Sending either restarts the counter that both share, so use only one of them.
 *
 * - 3dm-cv7-gnss-ins: External Time Delta (0xFF,0xD8)
 */
struct mip_shared_external_time_delta {
    /**
     * Time since the last output. Unit: ns. Valid if MIP_SHARED_EXTERNAL_TIME_DELTA_FLAGS_DT_NANOS
     * in valid_flags is set.
     */
    uint64_t dt_nanos;
    /** Validity of the difference. */
    mip_shared_external_time_delta_flags valid_flags;
};

#define MIP_SHARED_EXTERNAL_TIME_DELTA 0xFFD8
#define MIP_SHARED_EXTERNAL_TIME_DELTA_DESCRIPTOR 0xD8
MIP_FIELD(mip_shared_external_time_delta, 0xD8);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
