// The clocks of timestamps, for `packet.time`.

import { clocks } from "./mip/time.mjs";
import * as sensor from "./sensor.mjs";
import * as gnss_data from "./gnss_data.mjs";
import * as filter_data from "./filter_data.mjs";
import * as shared from "./shared.mjs";

export { Times } from "./mip/time.mjs";

const LEAP_SECONDS = {
    "1981-07-01": 1,
    "1982-07-01": 2,
    "1983-07-01": 3,
    "1985-07-01": 4,
    "1988-01-01": 5,
    "1990-01-01": 6,
    "1991-01-01": 7,
    "1992-07-01": 8,
    "1993-07-01": 9,
    "1994-07-01": 10,
    "1996-01-01": 11,
    "1997-07-01": 12,
    "1999-01-01": 13,
    "2006-01-01": 14,
    "2009-01-01": 15,
    "2012-07-01": 16,
    "2015-07-01": 17,
    "2017-01-01": 18,
};

export const Clock = /* @__PURE__ */ clocks(
    {
        GPS: ["gps", "1980-01-06"],
        EXTERNAL: ["external"],
        REFERENCE: ["reference"],
        DEVICE: ["device"],
    },
    LEAP_SECONDS,
    [
        [shared.GpsTimestamp, null, 12, ["gps", "device"], { tow: 1000000000, weekNumber: 604800000000000 }],
        [sensor.GpsTimestamp, [0x80], 12, ["gps", "device"], { tow: 1000000000, weekNumber: 604800000000000 }],
        [filter_data.Timestamp, [0x82], 12, ["gps", "device"], { tow: 1000000000, weekNumber: 604800000000000 }],
        [gnss_data.GpsTime, [0x81, 0x91, 0x92, 0x94, 0x95], 12, ["gps"], { tow: 1000000000, weekNumber: 604800000000000 }],
        [shared.ExternalTimestamp, null, 10, ["external"], { nanoseconds: 1 }],
        [shared.ReferenceTimestamp, null, 8, ["reference"], { nanoseconds: 1 }],
    ],
);
