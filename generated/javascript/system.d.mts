/**
 * System (0x7F).
 *
 * Advanced commands of devices that consist of several intelligent parts.
 *
 * - 3dm-gx5-15: 4.4 System Commands
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type CommProtocols = Flavor<number, "system.comm_protocols">;
/**
 * Protocols of a port.
 *
 * - mip-sdk-4: Interface Control (0x7F,0x02)
 */
export declare const CommProtocols: Bitfield<CommProtocols> & {
    /** Bit 0. */
    readonly MIP: CommProtocols;
    /** NMEA-0183. Bit 8. */
    readonly NMEA: CommProtocols;
    /** RTCM corrections. Bit 9. */
    readonly RTCM: CommProtocols;
    /** SPARTN corrections. Bit 24. */
    readonly SPARTN: CommProtocols;
    /** SBF, the binary format of Septentrio receivers. Bit 29. */
    readonly SBF: CommProtocols;
};

export type ProtocolMode = Flavor<number, "system.protocol_mode">;
/** Part of the device that the host communicates with, and its protocol. */
export declare const ProtocolMode: Enumeration<ProtocolMode> & {
    /** The device itself; the protocol is MIP. */
    readonly STANDARD: ProtocolMode & 1;
    /** The internal inertial sensor; the protocol is MIP. */
    readonly SENSOR_DIRECT: ProtocolMode & 2;
    /** The internal GNSS receiver; the protocols are NMEA and UBX. Requires a receiver. */
    readonly GNSS_DIRECT: ProtocolMode & 3;
};

/**
 * Interface control response (0x7F,0x82).
 *
 * Response to `InterfaceControl`. Supported by 3DM-CV7-GNSS/INS.
 *
 * - mip-sdk-4: Interface control (0x7F,0x02)
 * - 3dm-cv7-gnss-ins: Ports
 */
export declare class InterfaceControlResponse extends Response {
    constructor(values: Values<InterfaceControlResponse>);
    /** Port whose protocols are set or read. Uncertain: No source states whether write and read accept `all`. */
    port: types.CommInterface;
    /** Protocols that the port receives. */
    protocolsIncoming: CommProtocols;
    /** Protocols that the port sends. */
    protocolsOutgoing: CommProtocols;
}

/**
 * Communication mode response (0x7F,0x90).
 *
 * Response to `CommMode`. Confirmed on 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 17 more.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
export declare class CommModeResponse extends Response {
    constructor(values: Values<CommModeResponse>);
    /** Communication mode. Default: `ProtocolMode.STANDARD`. */
    mode: ProtocolMode;
}

/**
 * Interface control (0x7F,0x02).
 *
 * Sets the protocols that a port receives and sends.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `InterfaceControlResponse`. Supported by
 * 3DM-CV7-GNSS/INS.
 *
 * Accepted on the main port only. The main port always keeps MIP in both directions. The change takes effect before the
 * ACK, which is sent on the main port. Bytes that arrive during the change may be lost. The device rejects protocols
 * that it or the port does not support, and settings that need more parsers than it has. A rejected command changes
 * nothing. Replies to an incoming protocol are sent on the same port, even if the protocol is not an outgoing one.
 * Devices differ in how many protocols they receive and send at a time.
 *
 * - mip-sdk-4: Interface control (0x7F,0x02)
 * - 3dm-cv7-gnss-ins: Ports
 */
export declare class InterfaceControl<R extends Response | undefined = undefined | InterfaceControlResponse> extends Command<R> {
    constructor(values: Values<InterfaceControl>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Port whose protocols are set or read. Uncertain: No source states whether write and read accept `all`. */
    port?: types.CommInterface;
    /** Protocols that the port receives. Required for `write`. */
    protocolsIncoming?: CommProtocols;
    /** Protocols that the port sends. Required for `write`. */
    protocolsOutgoing?: CommProtocols;
    /** Apply the new setting. */
    static write(values: { port: types.CommInterface; protocolsIncoming: CommProtocols; protocolsOutgoing: CommProtocols }): InterfaceControl<undefined>;
    /** Return the current setting in a response. */
    static read(values: { port: types.CommInterface }): InterfaceControl<InterfaceControlResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(values: { port: types.CommInterface }): InterfaceControl<undefined>;
    /** Load the saved setting. */
    static load(values: { port: types.CommInterface }): InterfaceControl<undefined>;
    /** Load the factory default setting. */
    static default(values: { port: types.CommInterface }): InterfaceControl<undefined>;
}

/**
 * Communication mode (0x7F,0x10).
 *
 * Switches the port between the device and one of its internal sensors.
 *
 * For advanced use. Functions: `write`, `read`, `save`, `load` and `default`. Response: `CommModeResponse`. Confirmed
 * on 3DM-GX5-15, 3DM-GX5-35 and 3DM-GX5-45; likely or assumed on 17 more.
 *
 * The ACK is sent in the old mode, just before the switch. In a direct mode, the device itself replies only to this
 * command and `3dm.DeviceStatus`.
 *
 * - 3dm-gx5-15: 4.4.1 Communication Mode (0x7F, 0x10)
 */
export declare class CommMode<R extends Response | undefined = undefined | CommModeResponse> extends Command<R> {
    constructor(values: Values<CommMode>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /**
     * Communication mode. Default: `ProtocolMode.STANDARD`. Required for `write`.
     *
     * - On the 3DM-CV5-15, 3DM-CV5-25, 3DM-CX5-15, 3DM-CX5-25, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX5-15 and 3DM-GX5-25: only
     *   `ProtocolMode.STANDARD` and `ProtocolMode.SENSOR_DIRECT`.
     * - On the 3DM-GX5-35: default `ProtocolMode.STANDARD`.
     */
    mode?: ProtocolMode;
    /** Apply the new setting. */
    static write(values: { mode: ProtocolMode }): CommMode<undefined>;
    /** Return the current setting in a response. */
    static read(): CommMode<CommModeResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): CommMode<undefined>;
    /** Load the saved setting. */
    static load(): CommMode<undefined>;
    /** Load the factory default setting. */
    static default(): CommMode<undefined>;
}
