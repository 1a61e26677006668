/**
 * GNSS commands (0x0E).
 *
 * Commands that describe and set up the internal GNSS receivers.
 *
 * - 3dm-cv7-gnss-ins: GNSS (0x0E)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

/**
 * Description of a GNSS receiver.
 *
 * - 3dm-cv7-gnss-ins: Info
 * - mip-sdk-4: Receiver Info (0x0E,0x01)
 */
export interface ReceiverInfoEntry {
    /** Receiver, numbered as in `receiver_id`: 1 and 2 are internal, 4 and 5 external. Range: at least 1. */
    receiverId: number;
    /** Descriptor set of this receiver's data. Range: 0x80 to 0xFE. */
    mipDataDescriptorSet: number;
    /** Module name or model and firmware version, separated by a comma. */
    description: string;
}

export type GpsSignals = Flavor<number, "gnss.gps_signals">;
/** GPS signals that are enabled. */
export declare const GpsSignals: Bitfield<GpsSignals> & {
    /** L1 C/A. Bit 0. */
    readonly L1CA: GpsSignals;
    /** Bit 1. */
    readonly L2C: GpsSignals;
    /** Bit 2. */
    readonly L5: GpsSignals;
};

export type GlonassSignals = Flavor<number, "gnss.glonass_signals">;
/** GLONASS signals that are enabled. */
export declare const GlonassSignals: Bitfield<GlonassSignals> & {
    /** Bit 0. */
    readonly L1OF: GlonassSignals;
    /** Bit 1. */
    readonly L2OF: GlonassSignals;
};

export type GalileoSignals = Flavor<number, "gnss.galileo_signals">;
/** Galileo signals that are enabled. */
export declare const GalileoSignals: Bitfield<GalileoSignals> & {
    /** Bit 0. */
    readonly E1: GalileoSignals;
    /** Bit 1. */
    readonly E5B: GalileoSignals;
    /** Bit 2. */
    readonly E5A: GalileoSignals;
};

export type BeidouSignals = Flavor<number, "gnss.beidou_signals">;
/** BeiDou signals that are enabled. */
export declare const BeidouSignals: Bitfield<BeidouSignals> & {
    /** Bit 0. */
    readonly B1: BeidouSignals;
    /** Bit 1. */
    readonly B2: BeidouSignals;
    /** Bit 2. */
    readonly B2A: BeidouSignals;
};

export type ReceiverId = Flavor<number, "gnss.receiver_id">;
/**
 * A GNSS receiver.
 *
 * - mip-sdk-4: Receiver Reset (0x0E,0x03)
 */
export declare const ReceiverId: Enumeration<ReceiverId> & {
    /** Every receiver; only for commands that accept it. */
    readonly ALL: ReceiverId & 0;
    /** The first receiver inside the device. */
    readonly INTERNAL_RECEIVER_1: ReceiverId & 1;
    /** The second receiver inside the device. */
    readonly INTERNAL_RECEIVER_2: ReceiverId & 2;
    /** The first external receiver. */
    readonly USER_RECEIVER_1: ReceiverId & 4;
    /** The second external receiver. */
    readonly USER_RECEIVER_2: ReceiverId & 5;
};

export type ReceiverResetType = Flavor<number, "gnss.receiver_reset_type">;
/**
 * Extent of a receiver restart.
 *
 * - mip-sdk-4: Receiver Reset (0x0E,0x03)
 */
export declare const ReceiverResetType: Enumeration<ReceiverResetType> & {
    /** Resets the hardware of the receiver. */
    readonly HARDWARE: ReceiverResetType & 1;
    /** Restarts all software of the receiver. */
    readonly COLD: ReceiverResetType & 2;
    /**
     * Restarts the positioning engine only. Uncertain: An earlier branch of the SDK calls 3 hot and 4 warm, with the
     * same descriptions of the two numbers. GNSS receivers usually keep their satellite data in a hot start and lose it
     * in a warm one.
     */
    readonly WARM: ReceiverResetType & 3;
    /**
     * Restarts the positioning engine and clears its ephemerides and almanacs. Uncertain: An earlier branch of the SDK
     * swaps this name with that of 3.
     */
    readonly HOT: ReceiverResetType & 4;
};

export type AmbiguityFixMode = Flavor<number, "gnss.ambiguity_fix_mode">;
/**
 * Strategy for fixing the RTK carrier phase ambiguities to whole numbers. Uncertain: The descriptions of `conservative`
 * and `moderate` are inferred from their names.
 *
 * - mip-sdk-4: Rtk Configuration (0x0E,0x04)
 */
export declare const AmbiguityFixMode: Enumeration<AmbiguityFixMode> & {
    /** Never fixes them. The solution remains a float solution. */
    readonly OFF: AmbiguityFixMode & 1;
    /** Fixes them late, so that few fixes are wrong. */
    readonly CONSERVATIVE: AmbiguityFixMode & 2;
    /** Between conservative and aggressive. */
    readonly MODERATE: AmbiguityFixMode & 3;
    /** Fixes them as soon as possible. */
    readonly AGGRESSIVE: AmbiguityFixMode & 4;
};

export type SpartnConnection = Flavor<number, "gnss.spartn_connection">;
/** Channel that delivers SPARTN corrections. */
export declare const SpartnConnection: Enumeration<SpartnConnection> & {
    /** No connection. */
    readonly NONE: SpartnConnection & 0;
    /** Over a network. */
    readonly NETWORK: SpartnConnection & 1;
    /** By satellite in the L band. */
    readonly L_BAND: SpartnConnection & 2;
};

/**
 * Receiver info response (0x0E,0x81).
 *
 * Response to `ReceiverInfo`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
 */
export declare class ReceiverInfoResponse extends Response {
    constructor(values: Values<ReceiverInfoResponse>);
    /** On the wire only: num_receivers. Number of physical receivers. Counts the elements of `receiverInfo`. */
    /** One entry for each receiver. */
    receiverInfo: ReceiverInfoEntry[];
}

/**
 * Signal configuration response (0x0E,0x82).
 *
 * Also called `signal_configuration_response`. Response to `SignalConfig`. Confirmed on 3DM-CV7-GNSS/INS; likely or
 * assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
 * - 3dm-cv7-gnss-ins: GNSS
 */
export declare class SignalConfigResponse extends Response {
    constructor(values: Values<SignalConfigResponse, "reserved">);
    /** GPS signals. */
    gpsEnable: GpsSignals;
    /** GLONASS signals. */
    glonassEnable: GlonassSignals;
    /** Galileo signals. */
    galileoEnable: GalileoSignals;
    /** BeiDou signals. */
    beidouEnable: BeidouSignals;
    /** Reserved. */
    reserved: [number, number, number, number];
}

/**
 * RTK configuration response (0x0E,0x84).
 *
 * Also called `rtk_configuration_response`. Response to `RtkConfig`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK configuration (0x0E,0x04)
 */
export declare class RtkConfigResponse extends Response {
    constructor(values: Values<RtkConfigResponse, "reserved">);
    /** Strategy for fixing ambiguities. */
    ambiguityFixMode: AmbiguityFixMode;
    /** Reserved. */
    reserved: [number, number, number, number];
}

/**
 * RTK dongle configuration response (0x0E,0x90).
 *
 * No device is known for certain to support it. Also called `rtk_dongle_configuration_response`. Response to
 * `RtkDongleConfig`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
 */
export declare class RtkDongleConfigResponse extends Response {
    constructor(values: Values<RtkDongleConfigResponse, "reserved">);
    /** 1 enables the dongle, 0 disables it. Range: 0 to 1. */
    enable: number;
    /** Reserved. Uncertain: No source states what to send; 0 is assumed. */
    reserved: [number, number, number];
}

/**
 * SPARTN configuration response (0x0E,0xA0).
 *
 * Also called `spartn_configuration_response`. Response to `SpartnConfig`. Supported by 3DM-CV7-GNSS/INS.
 *
 * - 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
 * - 3dm-cv7-gnss-ins: SPARTN Corrections
 * - 3dm-cv7-gnss-ins: SPARTN Corrections via UART
 */
export declare class SpartnConfigResponse extends Response {
    constructor(values: Values<SpartnConfigResponse>);
    /** 1 enables SPARTN corrections, 0 disables them. Range: 0 to 1. */
    enable: number;
    /** Channel of the corrections. */
    type: SpartnConnection;
    /** GPS time of week until which the current key is valid. Unit: s. */
    currentKeyTow: number;
    /** GPS week number until which the current key is valid. Unit: week. */
    currentKeyWeek: number;
    /** Current key in ASCII digits. */
    currentKey: number[];
    /** GPS time of week until which the next key is valid. Unit: s. */
    nextKeyTow: number;
    /** GPS week number until which the next key is valid. Unit: week. */
    nextKeyWeek: number;
    /** Next key in ASCII digits. */
    nextKey: number[];
}

/**
 * Receiver info (0x0E,0x01).
 *
 * Gets the GNSS receivers of the device.
 *
 * Response: `ReceiverInfoResponse`. Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more.
 *
 * - 3dm-cv7-gnss-ins: Receiver Info (0x0E,0x01)
 */
export declare class ReceiverInfo extends Command<ReceiverInfoResponse> {
    constructor();
}

/**
 * Signal configuration (0x0E,0x02).
 *
 * Selects the GNSS signals that the device uses.
 *
 * Also called `signal_configuration`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `SignalConfigResponse`. Probably affects `gnss_data.FixInfo`, `gnss_data.SatelliteStatus` and `gnss_data.Raw`.
 * Confirmed on 3DM-CV7-GNSS/INS; likely or assumed on 1 more. Requires firmware later than 1.0.10 on the
 * 3DM-GQ7-GNSS/INS.
 *
 * A device accepts only certain combinations. The 3DM-CV7-GNSS/INS needs GPS or Galileo, and rejects GPS L1 with BeiDou
 * L1 alone. For GPS and BeiDou it accepts none, L1, or L1 and L5; for Galileo none, or L1 and L5; for GLONASS none or
 * L1.
 *
 * - 3dm-cv7-gnss-ins: Signal Configuration (0x0E,0x02)
 * - 3dm-cv7-gnss-ins: GNSS
 */
export declare class SignalConfig<R extends Response | undefined = undefined | SignalConfigResponse> extends Command<R> {
    constructor(values: Values<SignalConfig, "reserved">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** GPS signals. Required for `write`. */
    gpsEnable?: GpsSignals;
    /** GLONASS signals. Required for `write`. */
    glonassEnable?: GlonassSignals;
    /** Galileo signals. Required for `write`. */
    galileoEnable?: GalileoSignals;
    /** BeiDou signals. Required for `write`. */
    beidouEnable?: BeidouSignals;
    /** Reserved: send 0. Required for `write`. */
    reserved?: [number, number, number, number];
    /** Apply the new setting. */
    static write(values: { gpsEnable: GpsSignals; glonassEnable: GlonassSignals; galileoEnable: GalileoSignals; beidouEnable: BeidouSignals }): SignalConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): SignalConfig<SignalConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SignalConfig<undefined>;
    /** Load the saved setting. */
    static load(): SignalConfig<undefined>;
    /** Load the factory default setting. */
    static default(): SignalConfig<undefined>;
}

/**
 * Receiver reset (0x0E,0x03).
 *
 * Resets a GNSS receiver of the device.
 *
 * Not listed in any device profile. Known only from the MicroStrain MIP SDK. Uncertain: The SDK names no device that
 * supports it.
 *
 * Only internal receivers can be reset. Some devices do not support all reset types.
 *
 * - mip-sdk-4: Receiver reset (0x0E,0x03)
 */
export declare class ReceiverReset extends Command<undefined> {
    constructor(values: Values<ReceiverReset>);
    /** Receiver to reset. */
    receiverId: ReceiverId;
    /** Extent of the restart. */
    resetType: ReceiverResetType;
}

/**
 * RTK configuration (0x0E,0x04).
 *
 * Sets how readily the device fixes the ambiguities of an RTK solution.
 *
 * Also called `rtk_configuration`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `RtkConfigResponse`. Probably affects `gnss_data.FixInfo` and `gnss_data.LlhPosition`. Not listed in any device
 * profile. Known only from the MicroStrain MIP SDK. Uncertain: No source lists the devices that support it. Users of
 * the vendor's ROS driver report it as experimental on the 3DM-GQ7, which accepts `conservative` only.
 *
 * The available modes differ by device.
 *
 * - mip-sdk-4: RTK configuration (0x0E,0x04)
 */
export declare class RtkConfig<R extends Response | undefined = undefined | RtkConfigResponse> extends Command<R> {
    constructor(values: Values<RtkConfig, "reserved">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Strategy for fixing ambiguities. Required for `write`. */
    ambiguityFixMode?: AmbiguityFixMode;
    /** Reserved: send 0. Required for `write`. */
    reserved?: [number, number, number, number];
    /** Apply the new setting. */
    static write(values: { ambiguityFixMode: AmbiguityFixMode }): RtkConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): RtkConfig<RtkConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): RtkConfig<undefined>;
    /** Load the saved setting. */
    static load(): RtkConfig<undefined>;
    /** Load the factory default setting. */
    static default(): RtkConfig<undefined>;
}

/**
 * RTK dongle configuration (0x0E,0x10).
 *
 * Switches the communication with a connected RTK dongle on or off.
 *
 * No device is known for certain to support it. Also called `rtk_dongle_configuration`. Functions: `write`, `read`,
 * `save`, `load` and `default`. Response: `RtkDongleConfigResponse`. Probably affects `gnss_data.RtkCorrectionsStatus`.
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: RTK dongle configuration (0x0E,0x10)
 */
export declare class RtkDongleConfig<R extends Response | undefined = undefined | RtkDongleConfigResponse> extends Command<R> {
    constructor(values: Values<RtkDongleConfig, "reserved">);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 1 enables the dongle, 0 disables it. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Reserved: send 0. Required for `write`. Uncertain: No source states what to send; 0 is assumed. */
    reserved?: [number, number, number];
    /** Apply the new setting. */
    static write(values: { enable: number }): RtkDongleConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): RtkDongleConfig<RtkDongleConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): RtkDongleConfig<undefined>;
    /** Load the saved setting. */
    static load(): RtkDongleConfig<undefined>;
    /** Load the factory default setting. */
    static default(): RtkDongleConfig<undefined>;
}

/**
 * SPARTN configuration (0x0E,0x20).
 *
 * Sets the source and the keys of SPARTN corrections.
 *
 * Also called `spartn_configuration`. Functions: `write`, `read`, `save`, `load` and `default`. Response:
 * `SpartnConfigResponse`. Probably affects `gnss_data.RtkCorrectionsStatus`. Supported by 3DM-CV7-GNSS/INS. Uncertain:
 * The device may not accept lower case: the section on UART uses the digits 0-9 and A-F, the description of the command
 * uses "bc" for 0xBC.
 *
 * A change of `enable` or `type` takes effect only after a power cycle; keys can be changed at any time. While SPARTN
 * corrections are enabled, RTCM corrections are blocked. A key has 16 bytes, none of them 0. Send it as 32 hexadecimal
 * digits in ASCII, two for each byte.
 *
 * - 3dm-cv7-gnss-ins: Spartn Configuration (0x0E,0x20)
 * - 3dm-cv7-gnss-ins: SPARTN Corrections
 * - 3dm-cv7-gnss-ins: SPARTN Corrections via UART
 */
export declare class SpartnConfig<R extends Response | undefined = undefined | SpartnConfigResponse> extends Command<R> {
    constructor(values: Values<SpartnConfig>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** 1 enables SPARTN corrections, 0 disables them. Range: 0 to 1. Required for `write`. */
    enable?: number;
    /** Channel of the corrections. Required for `write`. */
    type?: SpartnConnection;
    /** GPS time of week until which the current key is valid. Unit: s. Required for `write`. */
    currentKeyTow?: number;
    /** GPS week number until which the current key is valid. Unit: week. Required for `write`. */
    currentKeyWeek?: number;
    /** Current key in ASCII digits. Required for `write`. */
    currentKey?: number[];
    /** GPS time of week until which the next key is valid. Unit: s. Required for `write`. */
    nextKeyTow?: number;
    /** GPS week number until which the next key is valid. Unit: week. Required for `write`. */
    nextKeyWeek?: number;
    /** Next key in ASCII digits. Required for `write`. */
    nextKey?: number[];
    /** Apply the new setting. */
    static write(values: { enable: number; type: SpartnConnection; currentKeyTow: number; currentKeyWeek: number; currentKey: number[]; nextKeyTow: number; nextKeyWeek: number; nextKey: number[] }): SpartnConfig<undefined>;
    /** Return the current setting in a response. */
    static read(): SpartnConfig<SpartnConfigResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): SpartnConfig<undefined>;
    /** Load the saved setting. */
    static load(): SpartnConfig<undefined>;
    /** Load the factory default setting. */
    static default(): SpartnConfig<undefined>;
}

/**
 * Receiver safe mode (0x0E,0x60).
 *
 * Switches the safe mode of one receiver on or off. In safe mode, it sends no valid data.
 *
 * Affects gnss_data (0x81), gnss_1 (0x91), gnss_2 (0x92), gnss_corrections (0x93), gnss_external (0x94) and
 * gnss_external_2 (0x95). Not listed in any device profile. Known only from the MicroStrain MIP SDK, versions 1 to 3.
 * Uncertain: The layout is that of version 1.0.0 of the SDK; later versions do not have it. Uncertain: No source lists
 * the devices that support it.
 *
 * - mip-sdk-3: Receiver Safe Mode (0x0E,0x60), tag v1.0.0
 */
export declare class ReceiverSafeMode extends Command<undefined> {
    constructor(values: Values<ReceiverSafeMode>);
    /** Number of the receiver, from 1. Range: at least 1. */
    receiverId: number;
    /** 1 switches safe mode on, 0 off. Range: 0 to 1. */
    enable: number;
}
