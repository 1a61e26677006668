/**
 * @file
 * Constants of the protocol, and the version of this binding.
 */
#ifndef MIP_CONSTANTS_H
#define MIP_CONSTANTS_H

/** Version of the specification and of all files of this binding. */
#define MIP_VERSION "0.2.0"
/** The version as a number: 10203 is 1.2.3. */
#define MIP_VERSION_NUMBER 200

/** The first byte of every packet. */
#define MIP_SYNC_1 0x75
/** The second byte of every packet. */
#define MIP_SYNC_2 0x65

/** The maximum size of the payload of a packet. */
#define MIP_MAX_PAYLOAD 255
/** The maximum size of the data of a field. */
#define MIP_MAX_FIELD_DATA 253
/** Large enough for the structure of any field, on any machine. */
#define MIP_MAX_VALUE_SIZE 408
/** The descriptor of the acknowledge, in all command sets. */
#define MIP_ACKNOWLEDGE_DESCRIPTOR 0xF1
/** The first descriptor of the fields that all data sets share. */
#define MIP_FIRST_SHARED 0xD0

#endif
