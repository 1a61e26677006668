// The commands that find a device and start its data.

import type { GetDeviceInfoResponse } from "./base.mjs";

/** The device information. */
export type Identity = GetDeviceInfoResponse;

/** The clocks of timestamps that streams can have. */
export type ClockName = "reference" | "external" | "gps" | "device";
