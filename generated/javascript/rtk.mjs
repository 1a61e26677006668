// RTK commands: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const ConnectedDevice = /* @__PURE__ */ codec.enumeration(codec.u8, {
    GENERIC: 0,
    GQ7: 1,
});

export const ServiceFlags = /* @__PURE__ */ codec.bitfield(codec.u8, {
    THROTTLE: [0, 0],
    CORRECTIONS_UNAVAILABLE: [1, 1],
});

export const StorageMedium = /* @__PURE__ */ codec.enumeration(codec.u8, {
    EXTERNAL_FLASH: 0,
    SD: 1,
});

export const LedAction = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    FLASH: 1,
    PULSATE: 2,
});

export const GetStatusFlagsResponse = /* @__PURE__ */ field.response("rtk.get_status_flags_response", 0x0f, 0x81, {
    flags: types.RtkStatusFlags,
});

export const GetImeiResponse = /* @__PURE__ */ field.response("rtk.get_imei_response", 0x0f, 0x82, {
    imei: /* @__PURE__ */ codec.text(32),
});

export const GetImsiResponse = /* @__PURE__ */ field.response("rtk.get_imsi_response", 0x0f, 0x83, {
    imsi: /* @__PURE__ */ codec.text(32),
});

export const GetIccidResponse = /* @__PURE__ */ field.response("rtk.get_iccid_response", 0x0f, 0x84, {
    iccid: /* @__PURE__ */ codec.text(32),
});

export const GetRssiResponse = /* @__PURE__ */ field.response("rtk.get_rssi_response", 0x0f, 0x85, {
    valid: codec.bool,
    rssi: codec.s32,
    signalQuality: codec.s32,
}, {
    VALID: /* @__PURE__ */ field.validity({ valid: { rssi: 0x0, signalQuality: 0x0 } }),
});

export const ConnectedDeviceTypeResponse = /* @__PURE__ */ field.response("rtk.connected_device_type_response", 0x0f, 0x86, {
    deviceType: ConnectedDevice,
});

export const GetActivationCodeResponse = /* @__PURE__ */ field.response("rtk.get_activation_code_response", 0x0f, 0x87, {
    activationCode: /* @__PURE__ */ codec.text(32),
});

export const GetModemFirmwareVersionResponse = /* @__PURE__ */ field.response("rtk.get_modem_firmware_version_response", 0x0f, 0x88, {
    modemFirmwareVersion: /* @__PURE__ */ codec.text(32),
});

export const ServiceStatusResponse = /* @__PURE__ */ field.response("rtk.service_status_response", 0x0f, 0x8a, {
    flags: ServiceFlags,
    receivedBytes: codec.u32,
    lastBytes: codec.u32,
    lastBytesTime: codec.u64,
});

export const GetStatusFlags = /* @__PURE__ */ field.command("rtk.get_status_flags", 0x0f, 0x01, {}, {
    REPLIES: [[null, [], [GetStatusFlagsResponse]]],
});

export const GetImei = /* @__PURE__ */ field.command("rtk.get_imei", 0x0f, 0x02, {}, {
    REPLIES: [[null, [], [GetImeiResponse]]],
});

export const GetImsi = /* @__PURE__ */ field.command("rtk.get_imsi", 0x0f, 0x03, {}, {
    REPLIES: [[null, [], [GetImsiResponse]]],
});

export const GetIccid = /* @__PURE__ */ field.command("rtk.get_iccid", 0x0f, 0x04, {}, {
    REPLIES: [[null, [], [GetIccidResponse]]],
});

export const GetRssi = /* @__PURE__ */ field.command("rtk.get_rssi", 0x0f, 0x05, {}, {
    REPLIES: [[null, [], [GetRssiResponse]]],
});

export const ConnectedDeviceType = /* @__PURE__ */ field.command("rtk.connected_device_type", 0x0f, 0x06, {
    function: FunctionSelector,
    deviceType: ConnectedDevice,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [ConnectedDeviceTypeResponse]]],
});

export const GetActivationCode = /* @__PURE__ */ field.command("rtk.get_activation_code", 0x0f, 0x07, {}, {
    REPLIES: [[null, [], [GetActivationCodeResponse]]],
});

export const GetModemFirmwareVersion = /* @__PURE__ */ field.command("rtk.get_modem_firmware_version", 0x0f, 0x08, {}, {
    REPLIES: [[null, [], [GetModemFirmwareVersionResponse]]],
});

export const ServiceStatus = /* @__PURE__ */ field.command("rtk.service_status", 0x0f, 0x0a, {
    reserved1: /* @__PURE__ */ codec.reserved(codec.u32, 0),
    reserved2: /* @__PURE__ */ codec.reserved(codec.u32, 0),
}, {
    REPLIES: [[null, [], [ServiceStatusResponse]]],
});

export const EraseStorage = /* @__PURE__ */ field.command("rtk.erase_storage", 0x0f, 0x20, {
    media: StorageMedium,
});

export const LedControl = /* @__PURE__ */ field.command("rtk.led_control", 0x0f, 0x21, {
    primaryColor: /* @__PURE__ */ codec.array(codec.u8, 3),
    alternateColor: /* @__PURE__ */ codec.array(codec.u8, 3),
    action: LedAction,
    period: codec.u32,
});

export const ModemHardReset = /* @__PURE__ */ field.command("rtk.modem_hard_reset", 0x0f, 0x22, {});
