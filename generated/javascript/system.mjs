// System: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const CommProtocols = /* @__PURE__ */ codec.bitfield(codec.u32, {
    MIP: [0, 0],
    NMEA: [8, 8],
    RTCM: [9, 9],
    SPARTN: [24, 24],
    SBF: [29, 29],
});

export const ProtocolMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    STANDARD: 1,
    SENSOR_DIRECT: 2,
    GNSS_DIRECT: 3,
});

export const InterfaceControlResponse = /* @__PURE__ */ field.response("system.interface_control_response", 0x7f, 0x82, {
    port: types.CommInterface,
    protocolsIncoming: CommProtocols,
    protocolsOutgoing: CommProtocols,
});

export const CommModeResponse = /* @__PURE__ */ field.response("system.comm_mode_response", 0x7f, 0x90, {
    mode: ProtocolMode,
});

export const InterfaceControl = /* @__PURE__ */ field.command("system.interface_control", 0x7f, 0x02, {
    function: FunctionSelector,
    port: types.CommInterface,
    protocolsIncoming: CommProtocols,
    protocolsOutgoing: CommProtocols,
}, {
    calls: [, 3, 1, 1, 1, 1],
    REPLIES: [[[2], [], [InterfaceControlResponse]]],
});

export const CommMode = /* @__PURE__ */ field.command("system.comm_mode", 0x7f, 0x10, {
    function: FunctionSelector,
    mode: ProtocolMode,
}, {
    calls: [, 1, 0, 0, 0, 0],
    REPLIES: [[[2], [], [CommModeResponse]]],
});
