// The clocks of timestamps, for `packet.time`.

import type { Clock as AnyClock } from "./mip/index.mjs";

export { Times } from "./mip/index.mjs";

export declare const Clock: {
    /**
     * GPS time, once a receiver, a PPS or the host has set it. Unix (POSIX) time is 315964800 s more, less the leap
     * seconds.
     */
    readonly GPS: AnyClock;
    /** Nanoseconds of the clock that is synchronized to the PPS. */
    readonly EXTERNAL: AnyClock;
    /** Nanoseconds since power-on, by the clock of the device. */
    readonly REFERENCE: AnyClock;
    /** Seconds since power-on, which a device without GPS time sends as the time of week. */
    readonly DEVICE: AnyClock;
};
