/**
 * @file
 *
 * Displacement data (0x90). Measurements of the DEMOD-DC, a digital demodulator for displacement
 * sensors.
 *
 * The devices that support a field are in mip/extra/profiles.h.
 */
#ifndef MIP_DISPLACEMENT_DATA_H
#define MIP_DISPLACEMENT_DATA_H

#include "mip/protocol.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/displacement_data.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_displacement_data Displacement data (0x90)
 * @{ */

/** Descriptor set of these fields. */
#define MIP_DISPLACEMENT_DATA_SET 0x90

/**
 * Validity of the displacement timestamp. Uncertain: The number is possibly no bitfield, because
 * MSCL considers the time valid if it is 1.
 */
typedef uint8_t mip_displacement_data_timestamp_flags;
/** Bit 0. The clock has been set; `time` is valid. */
#define MIP_DISPLACEMENT_DATA_TIMESTAMP_FLAGS_TIME 0x01U

/**
 * Raw displacement: data (0x90,0x01).
 *
 * Displacement in ADC counts.
 *
 * No device is known for certain to support it. Known only from the MicroStrain Communication
 * Library.
 *
 * - mscl: Raw displacement (0x90,0x01)
 */
struct mip_displacement_data_displacement_raw {
    /** Output of the analog-to-digital converter. Unit: 1. */
    uint32_t counts;
};

#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW 0x9001
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_RAW_DESCRIPTOR 0x01
MIP_FIELD(mip_displacement_data_displacement_raw, 0x01);

/**
 * Displacement: data (0x90,0x02).
 *
 * Displacement of the sensor, computed with its calibration.
 *
 * No device is known for certain to support it. Known only from the MicroStrain Communication
 * Library.
 *
 * - mscl: Displacement (0x90,0x02)
 */
struct mip_displacement_data_displacement {
    /** Position of the sensor along its axis. Unit: mm. */
    float displacement;
};

#define MIP_DISPLACEMENT_DATA_DISPLACEMENT 0x9002
#define MIP_DISPLACEMENT_DATA_DISPLACEMENT_DESCRIPTOR 0x02
MIP_FIELD(mip_displacement_data_displacement, 0x02);

/**
 * Displacement device timestamp: data (0x90,0x04).
 *
 * Time of the measurement by the clock of the device.
 *
 * No device is known for certain to support it. Also called `displacement_timestamp`. Known only
 * from the MicroStrain Communication Library.
 *
 * - mscl: Displacement device timestamp (0x90,0x04)
 */
struct mip_displacement_data_timestamp {
    /** Validity of the displacement timestamp. */
    mip_displacement_data_timestamp_flags flags;
    /**
     * UTC since 1970-01-01, without leap seconds, if the clock was set to it. Unit: ns. Valid if
     * MIP_DISPLACEMENT_DATA_TIMESTAMP_FLAGS_TIME in flags is set.
     */
    uint64_t time;
};

#define MIP_DISPLACEMENT_DATA_TIMESTAMP 0x9004
#define MIP_DISPLACEMENT_DATA_TIMESTAMP_DESCRIPTOR 0x04
MIP_FIELD(mip_displacement_data_timestamp, 0x04);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
