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
 * Opens the port of a device. Throws "no_device" if none answers at any baud rate.
 *
 * @param port the result of `navigator.serial.requestPort()`; browsers prompt the user only after a click
 * @param options.baud the baud rate; if omitted, the rate at which the device answers is detected
 */
export declare function openSerial(port: SerialPortLike, options?: DeviceOptions & { baud?: number }): Promise<Device>;
