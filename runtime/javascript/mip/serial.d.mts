// A device at a serial port, in browsers with Web Serial.

import type { Device, DeviceOptions } from "./index.mjs";

/** The part of Web Serial's `SerialPort` that is used. */
export interface SerialPortLike {
    open(options: { baudRate: number; bufferSize?: number }): Promise<void>;
    close(): Promise<void>;
    readonly readable: ReadableStream<Uint8Array> | null;
    readonly writable: WritableStream<Uint8Array> | null;
}

/**
 * Opens the port of a device. Raises "no_device" if none answers at any baud rate.
 *
 * @param port what `navigator.serial.requestPort()` returns; a browser asks its user only after a click
 * @param options.baud the baud rate; without it, the one at which the device answers is found
 */
export declare function openSerial(port: SerialPortLike, options?: DeviceOptions & { baud?: number }): Promise<Device>;
