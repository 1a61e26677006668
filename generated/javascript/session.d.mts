// The commands that find a device and start its data.

import type { GetDeviceInfoResponse } from "./base.mjs";

/** What a device says of itself. */
export type Identity = GetDeviceInfoResponse;
