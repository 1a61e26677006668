// A device behind TCP, in Node.

import type { Device, DeviceOptions } from "./index.mjs";

/** Connects to a device. Raises the error of Node if that fails. */
export declare function openTcp(host: string, port: number, options?: DeviceOptions): Promise<Device>;
