// GNSS commands: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const ReceiverInfoEntry = /* @__PURE__ */ codec.struct({
    receiverId: codec.u8,
    mipDataDescriptorSet: codec.u8,
    description: /* @__PURE__ */ codec.text(32),
});

export const GpsSignals = /* @__PURE__ */ codec.bitfield(codec.u8, {
    L1CA: [0, 0],
    L2C: [1, 1],
    L5: [2, 2],
});

export const GlonassSignals = /* @__PURE__ */ codec.bitfield(codec.u8, {
    L1OF: [0, 0],
    L2OF: [1, 1],
});

export const GalileoSignals = /* @__PURE__ */ codec.bitfield(codec.u8, {
    E1: [0, 0],
    E5B: [1, 1],
    E5A: [2, 2],
});

export const BeidouSignals = /* @__PURE__ */ codec.bitfield(codec.u8, {
    B1: [0, 0],
    B2: [1, 1],
    B2A: [2, 2],
});

export const ReceiverId = /* @__PURE__ */ codec.enumeration(codec.u8, {
    ALL: 0,
    INTERNAL_RECEIVER_1: 1,
    INTERNAL_RECEIVER_2: 2,
    USER_RECEIVER_1: 4,
    USER_RECEIVER_2: 5,
});

export const ReceiverResetType = /* @__PURE__ */ codec.enumeration(codec.u8, {
    HARDWARE: 1,
    COLD: 2,
    WARM: 3,
    HOT: 4,
});

export const AmbiguityFixMode = /* @__PURE__ */ codec.enumeration(codec.u8, {
    OFF: 1,
    CONSERVATIVE: 2,
    MODERATE: 3,
    AGGRESSIVE: 4,
});

export const SpartnConnection = /* @__PURE__ */ codec.enumeration(codec.u8, {
    NONE: 0,
    NETWORK: 1,
    L_BAND: 2,
});

export const ReceiverInfoResponse = /* @__PURE__ */ field.response("gnss.receiver_info_response", 0x0e, 0x81, {
    numReceivers: /* @__PURE__ */ codec.counter(codec.u8, "receiverInfo"),
    receiverInfo: /* @__PURE__ */ codec.counted("numReceivers", ReceiverInfoEntry, 7),
});

export const SignalConfigResponse = /* @__PURE__ */ field.response("gnss.signal_config_response", 0x0e, 0x82, {
    gpsEnable: GpsSignals,
    glonassEnable: GlonassSignals,
    galileoEnable: GalileoSignals,
    beidouEnable: BeidouSignals,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 4), Array(4).fill(0)),
});

export const RtkConfigResponse = /* @__PURE__ */ field.response("gnss.rtk_config_response", 0x0e, 0x84, {
    ambiguityFixMode: AmbiguityFixMode,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 4), Array(4).fill(0)),
});

export const RtkDongleConfigResponse = /* @__PURE__ */ field.response("gnss.rtk_dongle_config_response", 0x0e, 0x90, {
    enable: codec.u8,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 3), Array(3).fill(0)),
});

export const SpartnConfigResponse = /* @__PURE__ */ field.response("gnss.spartn_config_response", 0x0e, 0xa0, {
    enable: codec.u8,
    type: SpartnConnection,
    currentKeyTow: codec.u32,
    currentKeyWeek: codec.u16,
    currentKey: /* @__PURE__ */ codec.array(codec.u8, 32),
    nextKeyTow: codec.u32,
    nextKeyWeek: codec.u16,
    nextKey: /* @__PURE__ */ codec.array(codec.u8, 32),
});

export const ReceiverInfo = /* @__PURE__ */ field.command("gnss.receiver_info", 0x0e, 0x01, {}, {
    REPLIES: [[null, [], [ReceiverInfoResponse]]],
});

export const SignalConfig = /* @__PURE__ */ field.command("gnss.signal_config", 0x0e, 0x02, {
    function: FunctionSelector,
    gpsEnable: GpsSignals,
    glonassEnable: GlonassSignals,
    galileoEnable: GalileoSignals,
    beidouEnable: BeidouSignals,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 4), Array(4).fill(0)),
}, {
    calls: [, 5, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SignalConfigResponse]]],
});

export const ReceiverReset = /* @__PURE__ */ field.command("gnss.receiver_reset", 0x0e, 0x03, {
    receiverId: ReceiverId,
    resetType: ReceiverResetType,
});

export const RtkConfig = /* @__PURE__ */ field.command("gnss.rtk_config", 0x0e, 0x04, {
    function: FunctionSelector,
    ambiguityFixMode: AmbiguityFixMode,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 4), Array(4).fill(0)),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [RtkConfigResponse]]],
});

export const RtkDongleConfig = /* @__PURE__ */ field.command("gnss.rtk_dongle_config", 0x0e, 0x10, {
    function: FunctionSelector,
    enable: codec.u8,
    reserved: /* @__PURE__ */ codec.reserved(/* @__PURE__ */ codec.array(/* @__PURE__ */ codec.reserved(codec.u8, 0), 3), Array(3).fill(0)),
}, {
    calls: [, 2, 0, 0, 0, 0],
    REPLIES: [[[2], [], [RtkDongleConfigResponse]]],
});

export const SpartnConfig = /* @__PURE__ */ field.command("gnss.spartn_config", 0x0e, 0x20, {
    function: FunctionSelector,
    enable: codec.u8,
    type: SpartnConnection,
    currentKeyTow: codec.u32,
    currentKeyWeek: codec.u16,
    currentKey: /* @__PURE__ */ codec.array(codec.u8, 32),
    nextKeyTow: codec.u32,
    nextKeyWeek: codec.u16,
    nextKey: /* @__PURE__ */ codec.array(codec.u8, 32),
}, {
    calls: [, 8, 0, 0, 0, 0],
    REPLIES: [[[2], [], [SpartnConfigResponse]]],
});

export const ReceiverSafeMode = /* @__PURE__ */ field.command("gnss.receiver_safe_mode", 0x0e, 0x60, {
    receiverId: codec.u8,
    enable: codec.u8,
});
