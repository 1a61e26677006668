/**
 * RTK commands (0x0F).
 *
 * Commands of a corrections modem (RTK dongle), such as the 3DM-RTK.
 *
 * Uncertain: The SDK describes hardly any of this set; most descriptions are inferred from the names. Uncertain: No
 * source states how strings are padded or terminated.
 *
 * - mip-sdk-4: Rtk Commands (0x0F)
 */
import type { Bitfield, Command, Data, Enumeration, Flavor, Response, Values } from "./mip/index.mjs";
import type { FunctionSelector } from "./protocol.mjs";
import type * as types from "./types.mjs";

export type ConnectedDevice = Flavor<number, "rtk.connected_device">;
/**
 * Type of device connected to a corrections modem.
 *
 * - mip-sdk-4: Connected Device Type (0x0F,0x06)
 */
export declare const ConnectedDevice: Enumeration<ConnectedDevice> & {
    /** Any device. */
    readonly GENERIC: ConnectedDevice & 0;
    /** 3DM-GQ7. */
    readonly GQ7: ConnectedDevice & 1;
};

export type ServiceFlags = Flavor<number, "rtk.service_flags">;
/**
 * State of the correction service.
 *
 * - mip-sdk-4: Service Status (0x0F,0x0A)
 */
export declare const ServiceFlags: Bitfield<ServiceFlags> & {
    /** The server limits the rate. Bit 0. */
    readonly THROTTLE: ServiceFlags;
    /** There are no corrections. Bit 1. */
    readonly CORRECTIONS_UNAVAILABLE: ServiceFlags;
};

export type StorageMedium = Flavor<number, "rtk.storage_medium">;
/**
 * A storage medium of a corrections modem.
 *
 * - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
 */
export declare const StorageMedium: Enumeration<StorageMedium> & {
    /** External flash memory. */
    readonly EXTERNAL_FLASH: StorageMedium & 0;
    /** SD card. */
    readonly SD: StorageMedium & 1;
};

export type LedAction = Flavor<number, "rtk.led_action">;
/**
 * Pattern of an LED.
 *
 * - mip-sdk-4: Led Control (0x0F,0x21)
 */
export declare const LedAction: Enumeration<LedAction> & {
    /** No pattern. */
    readonly NONE: LedAction & 0;
    /** Flashing. */
    readonly FLASH: LedAction & 1;
    /** Pulsating. */
    readonly PULSATE: LedAction & 2;
};

/**
 * Get status flags response (0x0F,0x81).
 *
 * No device is known for certain to support it. Response to `GetStatusFlags`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get status flags (0x0F,0x01)
 */
export declare class GetStatusFlagsResponse extends Response {
    constructor(values: Values<GetStatusFlagsResponse>);
    /** State of the modem and of the corrections. */
    flags: types.RtkStatusFlags;
}

/**
 * Get IMEI response (0x0F,0x82).
 *
 * Response to `GetImei`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMEI (0x0F,0x02)
 */
export declare class GetImeiResponse extends Response {
    constructor(values: Values<GetImeiResponse>);
    /** International mobile equipment identity. */
    imei: string;
}

/**
 * Get IMSI response (0x0F,0x83).
 *
 * Response to `GetImsi`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMSI (0x0F,0x03)
 */
export declare class GetImsiResponse extends Response {
    constructor(values: Values<GetImsiResponse>);
    /** International mobile subscriber identity. */
    imsi: string;
}

/**
 * Get ICCID response (0x0F,0x84).
 *
 * Response to `GetIccid`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get ICCID (0x0F,0x04)
 */
export declare class GetIccidResponse extends Response {
    constructor(values: Values<GetIccidResponse>);
    /** Number of the SIM card. */
    iccid: string;
}

/**
 * Get RSSI response (0x0F,0x85).
 *
 * Response to `GetRssi`. Known only from the MicroStrain MIP SDK. Uncertain: That `valid` applies to the other values
 * is inferred.
 *
 * - mip-sdk-4: Get RSSI (0x0F,0x05)
 */
export declare class GetRssiResponse extends Response {
    constructor(values: Values<GetRssiResponse>);
    /** True if the modem is connected. */
    valid: boolean;
    /** Received signal strength. Valid if `valid` is true. Uncertain: No source states the unit; dBm is likely. */
    rssi: number;
    /** Quality of the modem's radio signal. Valid if `valid` is true. Uncertain: No source states the unit. */
    signalQuality: number;
}

/**
 * Connected device type response (0x0F,0x86).
 *
 * Response to `ConnectedDeviceType`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Connected device type (0x0F,0x06)
 */
export declare class ConnectedDeviceTypeResponse extends Response {
    constructor(values: Values<ConnectedDeviceTypeResponse>);
    /** Type of device that the modem is connected to. */
    deviceType: ConnectedDevice;
}

/**
 * Get activation code response (0x0F,0x87).
 *
 * No device is known for certain to support it. Also called `get_act_code_response`. Response to `GetActivationCode`.
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get Act Code (0x0F,0x07)
 */
export declare class GetActivationCodeResponse extends Response {
    constructor(values: Values<GetActivationCodeResponse>);
    /** Code that activates the modem for its service. */
    activationCode: string;
}

/**
 * Get modem firmware version response (0x0F,0x88).
 *
 * Response to `GetModemFirmwareVersion`. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get modem firmware version (0x0F,0x08)
 */
export declare class GetModemFirmwareVersionResponse extends Response {
    constructor(values: Values<GetModemFirmwareVersionResponse>);
    /** Firmware version of the modem, not of the dongle. */
    modemFirmwareVersion: string;
}

/**
 * Service status response (0x0F,0x8A).
 *
 * Connection status according to the server.
 *
 * Response to `ServiceStatus`. Known only from the MicroStrain MIP SDK. Uncertain: No source states what the counters
 * count.
 *
 * - mip-sdk-4: Service status (0x0F,0x0A)
 */
export declare class ServiceStatusResponse extends Response {
    constructor(values: Values<ServiceStatusResponse>);
    /** State of the service. */
    flags: ServiceFlags;
    /** Number of correction bytes that the service has sent. Unit: byte. */
    receivedBytes: number;
    /** Number of bytes in the last transfer. Unit: byte. */
    lastBytes: number;
    /** Time of the last transfer. Uncertain: No source states the unit and the epoch. */
    lastBytesTime: bigint;
}

/**
 * Get status flags (0x0F,0x01).
 *
 * Gets the state of the modem and of the corrections.
 *
 * No device is known for certain to support it. Response: `GetStatusFlagsResponse`. Known only from the MicroStrain MIP
 * SDK.
 *
 * The status word in the response has two forms: `types.RtkStatusFlags` if its `version` is not 0, and
 * `types.RtkStatusFlagsLegacy` if it is.
 *
 * - mip-sdk-4: Get status flags (0x0F,0x01)
 */
export declare class GetStatusFlags extends Command<GetStatusFlagsResponse> {
    constructor();
}

/**
 * Get IMEI (0x0F,0x02).
 *
 * Gets the identity of the modem.
 *
 * Response: `GetImeiResponse`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMEI (0x0F,0x02)
 */
export declare class GetImei extends Command<GetImeiResponse> {
    constructor();
}

/**
 * Get IMSI (0x0F,0x03).
 *
 * Gets the identity of the subscriber.
 *
 * Response: `GetImsiResponse`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get IMSI (0x0F,0x03)
 */
export declare class GetImsi extends Command<GetImsiResponse> {
    constructor();
}

/**
 * Get ICCID (0x0F,0x04).
 *
 * Gets the number of the SIM card.
 *
 * Response: `GetIccidResponse`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get ICCID (0x0F,0x04)
 */
export declare class GetIccid extends Command<GetIccidResponse> {
    constructor();
}

/**
 * Get RSSI (0x0F,0x05).
 *
 * Gets the strength of the cellular signal.
 *
 * Response: `GetRssiResponse`. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get RSSI (0x0F,0x05)
 */
export declare class GetRssi extends Command<GetRssiResponse> {
    constructor();
}

/**
 * Connected device type (0x0F,0x06).
 *
 * Sets the type of device that the modem is connected to.
 *
 * Functions: `write`, `read`, `save`, `load` and `default`. Response: `ConnectedDeviceTypeResponse`. Not listed in any
 * device profile. Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Connected device type (0x0F,0x06)
 */
export declare class ConnectedDeviceType<R extends Response | undefined = undefined | ConnectedDeviceTypeResponse> extends Command<R> {
    constructor(values: Values<ConnectedDeviceType>);
    /** Operation on the setting. */
    function: FunctionSelector;
    /** Type of device that the modem is connected to. Required for `write`. */
    deviceType?: ConnectedDevice;
    /** Apply the new setting. */
    static write(values: { deviceType: ConnectedDevice }): ConnectedDeviceType<undefined>;
    /** Return the current setting in a response. */
    static read(): ConnectedDeviceType<ConnectedDeviceTypeResponse>;
    /** Save the current setting to non-volatile memory. */
    static save(): ConnectedDeviceType<undefined>;
    /** Load the saved setting. */
    static load(): ConnectedDeviceType<undefined>;
    /** Load the factory default setting. */
    static default(): ConnectedDeviceType<undefined>;
}

/**
 * Get activation code (0x0F,0x07).
 *
 * Reads the code that activates the modem for its service.
 *
 * No device is known for certain to support it. Also called `get_act_code`. Response: `GetActivationCodeResponse`.
 * Known only from the MicroStrain MIP SDK.
 *
 * - mip-sdk-4: Get Act Code (0x0F,0x07)
 */
export declare class GetActivationCode extends Command<GetActivationCodeResponse> {
    constructor();
}

/**
 * Get modem firmware version (0x0F,0x08).
 *
 * Gets the firmware version of the cellular modem.
 *
 * Response: `GetModemFirmwareVersionResponse`. Not listed in any device profile. Known only from the MicroStrain MIP
 * SDK.
 *
 * - mip-sdk-4: Get modem firmware version (0x0F,0x08)
 */
export declare class GetModemFirmwareVersion extends Command<GetModemFirmwareVersionResponse> {
    constructor();
}

/**
 * Service status (0x0F,0x0A).
 *
 * Queries a correction server about the connection, which also keeps it open.
 *
 * Response: `ServiceStatusResponse`. Sent by the device; the host replies. Not listed in any device profile. Known only
 * from the MicroStrain MIP SDK.
 *
 * The modem acts as the host and the server as the device.
 *
 * - mip-sdk-4: Service status (0x0F,0x0A)
 */
export declare class ServiceStatus extends Command<ServiceStatusResponse> {
    constructor(values: Values<ServiceStatus, "reserved1" | "reserved2">);
    /** Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed. */
    reserved1: number;
    /** Reserved: send 0. Uncertain: No source states what the modem sends; 0 is assumed. */
    reserved2: number;
}

/**
 * Erase storage (0x0F,0x20).
 *
 * Returns a storage medium to its raw state. Everything on it is erased.
 *
 * For advanced use. Also called `prod_erase_storage`. Not listed in any device profile. Known only from the MicroStrain
 * MIP SDK.
 *
 * All stored data is lost. The command is for production. Accepted in calibration mode only.
 *
 * - mip-sdk-4: Prod Erase Storage (0x0F,0x20)
 */
export declare class EraseStorage extends Command<undefined> {
    constructor(values: Values<EraseStorage>);
    /** The medium. */
    media: StorageMedium;
}

/**
 * LED control (0x0F,0x21).
 *
 * Sets the colours and the pattern of the LED.
 *
 * For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * Accepted in calibration mode and production test mode only.
 *
 * - mip-sdk-4: LED control (0x0F,0x21)
 */
export declare class LedControl extends Command<undefined> {
    constructor(values: Values<LedControl>);
    /** First colour. Uncertain: No source states the order of its parts; red, green, blue is likely. */
    primaryColor: [number, number, number];
    /** Second colour. Uncertain: No source states the order of its parts; red, green, blue is likely. */
    alternateColor: [number, number, number];
    /** Pattern. */
    action: LedAction;
    /** Period of the pattern. Uncertain: No source states the unit; ms is likely. */
    period: number;
}

/**
 * Modem hard reset (0x0F,0x22).
 *
 * Clears the flash memory of the modem.
 *
 * For advanced use. Not listed in any device profile. Known only from the MicroStrain MIP SDK.
 *
 * It wears out the flash memory; use it rarely. Accepted in calibration mode only.
 *
 * - mip-sdk-4: Modem hard reset (0x0F,0x22)
 */
export declare class ModemHardReset extends Command<undefined> {
    constructor();
}
