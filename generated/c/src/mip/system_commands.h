/**
 * @file
 * The commands of System, each with the types of its parameters and of its response.
 */
#ifndef MIP_SYSTEM_COMMANDS_H
#define MIP_SYSTEM_COMMANDS_H

#include "mip/system.h"
#include "mip/device.h"

#if MIP_VERSION_NUMBER != 200
#error "mip/system_commands.h and mip/constants.h have different versions"
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @addtogroup mip_system System (0x7F)
 * @{ */

MIP_COMMAND_REPLIES(mip_system_interface_control);
MIP_SEND(mip_send_system_interface_control, mip_system_interface_control,
         mip_system_interface_control_response);
MIP_CALL_WITH(mip_call_system_interface_control_with, mip_system_interface_control,
              mip_system_interface_control_response);

/**
 * Interface control: write.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
 *   source states whether write and read accept `all`.
 * - protocols_incoming: Protocols that the port receives. Required for write.
 * - protocols_outgoing: Protocols that the port sends. Required for write.
 */
static inline struct mip_result mip_call_system_interface_control_write(
    struct mip_device *device, enum mip_comm_interface port,
    mip_system_comm_protocols protocols_incoming, mip_system_comm_protocols protocols_outgoing) {
    uint8_t data[10];
    mip_put_8(data, (uint8_t)MIP_FUNCTION_SELECTOR_WRITE);
    mip_put_8(data + 1, (uint8_t)port);
    mip_put_32(data + 2, (uint32_t)protocols_incoming);
    mip_put_32(data + 6, (uint32_t)protocols_outgoing);
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 10);
}

/**
 * Interface control: read.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
 *   source states whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_read(struct mip_device *device, enum mip_comm_interface port,
                                       struct mip_system_interface_control_response *response) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_READ, (uint8_t)port};
    return mip_device_request(device, &mip_system_interface_control_exchange, data, 2,
                              &mip_system_interface_control_response_codec, response);
}

/**
 * Interface control: save.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
 *   source states whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_save(struct mip_device *device, enum mip_comm_interface port) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_SAVE, (uint8_t)port};
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 2);
}

/**
 * Interface control: load.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
 *   source states whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_load(struct mip_device *device, enum mip_comm_interface port) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_LOAD, (uint8_t)port};
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 2);
}

/**
 * Interface control: default.
 *
 * - port: Port whose protocols are set or read. A value of enum mip_comm_interface. Uncertain: No
 *   source states whether write and read accept `all`.
 */
static inline struct mip_result
mip_call_system_interface_control_default(struct mip_device *device, enum mip_comm_interface port) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_DEFAULT, (uint8_t)port};
    return mip_device_send(device, &mip_system_interface_control_exchange, data, 2);
}

MIP_COMMAND_REPLIES(mip_system_comm_mode);
MIP_SEND(mip_send_system_comm_mode, mip_system_comm_mode, mip_system_comm_mode_response);
MIP_CALL_FOR(mip_call_system_comm_mode_read, mip_system_comm_mode, MIP_FUNCTION_SELECTOR_READ,
             mip_system_comm_mode_response);
MIP_CALL(mip_call_system_comm_mode_save, mip_system_comm_mode, MIP_FUNCTION_SELECTOR_SAVE);
MIP_CALL(mip_call_system_comm_mode_load, mip_system_comm_mode, MIP_FUNCTION_SELECTOR_LOAD);
MIP_CALL(mip_call_system_comm_mode_default, mip_system_comm_mode, MIP_FUNCTION_SELECTOR_DEFAULT);
MIP_CALL_WITH(mip_call_system_comm_mode_with, mip_system_comm_mode, mip_system_comm_mode_response);

/**
 * Communication mode: write.
 *
 * - mode: Communication mode. A value of enum mip_system_protocol_mode. Default:
 *   MIP_SYSTEM_PROTOCOL_MODE_STANDARD. Required for write. On the 3DM-CV5-15, 3DM-CV5-25,
 *   3DM-CX5-15, 3DM-CX5-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-15 and 3DM-GX5-25: only
 *   MIP_SYSTEM_PROTOCOL_MODE_STANDARD and MIP_SYSTEM_PROTOCOL_MODE_SENSOR_DIRECT. On the
 *   3DM-GX5-35: default MIP_SYSTEM_PROTOCOL_MODE_STANDARD.
 */
static inline struct mip_result
mip_call_system_comm_mode_write(struct mip_device *device, enum mip_system_protocol_mode mode) {
    const uint8_t data[] = {(uint8_t)MIP_FUNCTION_SELECTOR_WRITE, (uint8_t)mode};
    return mip_device_send(device, &mip_system_comm_mode_exchange, data, 2);
}

/** @} */

#ifdef __cplusplus
}
#endif

#endif
