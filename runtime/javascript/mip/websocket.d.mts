// A device behind a WebSocket whose binary messages are the bytes of its port, in any division.

import type { Device, DeviceOptions } from "./index.mjs";

/** Connects to a device. @param options.WebSocket the class, where it is not global: Node 18 and 20 */
export declare function openWebSocket(
    url: string | URL,
    options?: DeviceOptions & { WebSocket?: new (url: string | URL) => any },
): Promise<Device>;
