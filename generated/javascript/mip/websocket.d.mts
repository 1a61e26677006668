// A device at a WebSocket, whose binary messages carry the bytes of the device's port, divided in any way.

import type { Device, DeviceOptions } from "./index.mjs";

/** Connects to a device. @param options.WebSocket the class, if it is not global, as in Node 18 and 20 */
export declare function openWebSocket(
    url: string | URL,
    options?: DeviceOptions & { WebSocket?: new (url: string | URL) => any },
): Promise<Device>;
