// A device at a TCP connection, in Node.

import type { Device, DeviceOptions } from "./index.mjs";

/** Connects to a device. Throws Node's error if that fails. */
export declare function openTcp(host: string, port: number, options?: DeviceOptions): Promise<Device>;
