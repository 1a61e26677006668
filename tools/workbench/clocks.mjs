// The clocks of timestamps, and the rhythm of a field by one of them.

import { clocksIn, Times } from "mip-protocol/tools";

/** The number of equal intervals that make a rhythm. */
const STEADY = 5;

/** Intervals whose relative difference is smaller are equal. */
const EQUAL = 0.1;

/** An interval longer than this many usual intervals is a gap. */
const GAP = 1.5;

/** Returns the names of the clocks that have the time of those with a date when it is not valid. */
function undatedClocks(protocol) {
    const { clocks } = protocol.model;
    const dated = new Set(clocks.flatMap(({ epoch, timestamps }) => (epoch === undefined ? [] : timestamps)));
    const own = clocks.filter(({ epoch, timestamps }) => epoch === undefined && timestamps.some((name) => dated.has(name)));
    return new Set(own.map(({ name }) => name));
}

/**
 * Finds the time of packets by the clocks of the model. Each set has one clock: the last of those in its first packet
 * with a timestamp, as a clock without a date goes on evenly when the date is set. A time that is not valid as a date is
 * that of the device's clock, and both together are one clock.
 */
export class Clocks {
    #undated;
    #clocks;
    #chosen = new Map(); // set -> { place, valid, run }

    /** @param times the `Times` of the device; those of an unknown one otherwise */
    constructor(protocol, times = new Times()) {
        this.times = times;
        this.#clocks = clocksIn(protocol);
        this.#undated = undatedClocks(protocol);
    }

    /**
     * Returns the time of a packet by its set's clock: { seconds, dated, run }; undefined without a clock.
     * `run` counts how often the clock got or lost its date: times before and after that cannot be compared.
     */
    timeOf(packet) {
        const times = this.#clocks
            .map((clock) => ({ clock, time: this.times.time(packet, clock) }))
            .filter(({ time }) => typeof time === "bigint");
        if (!times.length) return undefined;
        const found = times.map(({ clock, time }) => ({
            clock,
            seconds: Number(time) / 1e9,
            line: clock.dated || this.#undated.has(clock.name),
        }));
        const chosen = this.#chosen.get(packet.set);
        const place = chosen?.place ?? found.findLast(({ line }) => !line)?.clock.name ?? "";
        const best = found.find(({ clock, line }) => (place ? clock.name === place : line));
        if (!best) return undefined;
        const run = chosen ? chosen.run + (chosen.dated !== best.clock.dated) : 0;
        this.#chosen.set(packet.set, { place, dated: best.clock.dated, run });
        return { seconds: best.seconds, dated: best.clock.dated, run };
    }
}

/**
 * Follows the times of one field: its `usual` interval once several are equal, and the samples that are `lost` in gaps. A
 * gap counts when the usual interval comes again, so that events between or instead of regular data are not gaps.
 */
export class Rhythm {
    usual; // seconds
    lost = 0;
    #last; // time
    #run = 0; // the interval that repeats, and how often it came
    #count = 0;
    #open = 0; // samples that are missing if the usual interval comes again

    /** Processes the next time from `Clocks`. */
    add(time) {
        if (!time) return;
        const before = this.#last;
        this.#last = time;
        if (!before) return;
        const interval = time.run === before.run ? time.seconds - before.seconds : -1;
        if (interval < 0) [this.#count, this.#open] = [0, 0]; // the device was reset, or its clock set
        if (interval <= 0) return;
        if (this.#count && near(interval, this.#run)) this.#count++;
        else [this.#run, this.#count] = [interval, 1];
        if (this.usual && near(interval, this.usual)) {
            this.lost += this.#open;
            this.#open = 0;
        } else if (this.#count >= STEADY) {
            this.usual = this.#run;
            this.#open = 0;
        } else if (this.usual && interval > GAP * this.usual) {
            this.#open += Math.round(interval / this.usual) - 1;
        }
    }

    /** Returns the rate in Hz; undefined if it is not regular. */
    get rate() {
        return this.usual && 1 / this.usual;
    }
}

function near(interval, usual) {
    return Math.abs(interval - usual) < EQUAL * usual;
}
