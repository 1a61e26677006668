// The clocks of timestamps, and the rhythm of a field by one of them; `mip doctor` judges logs in the same way.

import { clocksIn, Times } from "mip-protocol/tools";

/** The number of equal intervals that make a rhythm. */
const STEADY = 5;

/** Intervals whose relative difference is smaller are equal. */
const EQUAL = 0.1;

/** An interval longer than this many usual intervals is a gap. */
export const GAP = 1.5;

/** Seconds of a week: a time of week that goes back by so much has begun a new one. */
const WEEK = 604_800;

/** Seconds that may be missing at the change of weeks. */
const NEAR_WEEK = 60;

/** Returns the names of the clocks that have the time of those with a date when it is not valid. */
export function undatedClocks(protocol) {
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
    /** From each start of the device to the next: name of a clock -> the first and the last time in seconds. */
    spans = [];
    #undated;
    #clocks;
    #chosen = new Map(); // set -> { place, valid, run }
    #last = new Map(); // set and clock -> time, since the device started
    #weeks = 0;

    /** @param times the `Times` of the log; those of an unknown device otherwise */
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
        this.#extend(packet.set, found.find(({ line }) => line) ?? found[0]);
        const chosen = this.#chosen.get(packet.set);
        const place = chosen?.place ?? found.findLast(({ line }) => !line)?.clock.name ?? "";
        const best = found.find(({ clock, line }) => (place ? clock.name === place : line));
        if (!best) return undefined;
        const run = chosen ? chosen.run + (chosen.dated !== best.clock.dated) : 0;
        this.#chosen.set(packet.set, { place, dated: best.clock.dated, run });
        return { seconds: best.seconds, dated: best.clock.dated, run };
    }

    /** Extends the last span, or begins another one if the clock goes back. */
    #extend(set, { clock, seconds }) {
        const key = `${set} ${clock.name}`;
        const before = this.#last.get(key);
        let time = clock.dated ? seconds : seconds + this.#weeks;
        if (before !== undefined && time < before) {
            if (this.#undated.has(clock.name) && before - time > WEEK - NEAR_WEEK) {
                this.#weeks += WEEK;
                time += WEEK;
            } else {
                this.#last.clear();
                this.#weeks = 0;
                time = seconds;
                this.spans.push({});
            }
        }
        this.#last.set(key, time);
        if (!this.spans.length) this.spans.push({});
        const span = this.spans.at(-1);
        const [first, last] = span[clock.name] ?? [time, time];
        span[clock.name] = [Math.min(first, time), Math.max(last, time)];
    }
}

/**
 * Follows the times of one field: its `usual` interval once several are equal, and the gaps in it. A gap counts when
 * the usual interval comes again, so that events between or instead of regular data are not gaps.
 */
export class Rhythm {
    usual; // seconds
    gaps = 0;
    lost = 0; // samples that are missing in the gaps
    #last; // time
    #run = 0; // the interval that repeats, and how often it came
    #count = 0;
    #open = []; // gaps after which the usual interval has not come again

    /** Processes the next time from `Clocks`, and returns the gaps that are now known: { at, dated, seconds, lost, mark }. */
    add(time, mark) {
        if (!time) return [];
        const before = this.#last;
        this.#last = time;
        if (!before) return [];
        const interval = time.run === before.run ? time.seconds - before.seconds : -1;
        if (interval < 0) [this.#count, this.#open] = [0, []]; // the device was reset, or its clock set
        if (interval <= 0) return [];
        if (this.#count && near(interval, this.#run)) this.#count++;
        else [this.#run, this.#count] = [interval, 1];
        if (this.usual && near(interval, this.usual)) return this.#settled();
        if (this.#count >= STEADY) {
            this.usual = this.#run;
            this.#open = [];
        } else if (this.usual && interval > GAP * this.usual) {
            const lost = Math.round(interval / this.usual) - 1;
            this.#open.push({ at: before.seconds, dated: before.dated, seconds: interval, lost, mark });
        }
        return [];
    }

    /** Returns the rate in Hz; undefined if it is not regular. */
    get rate() {
        return this.usual && 1 / this.usual;
    }

    #settled() {
        const found = this.#open;
        this.#open = [];
        for (const { lost } of found) {
            this.gaps++;
            this.lost += lost;
        }
        return found;
    }
}

function near(interval, usual) {
    return Math.abs(interval - usual) < EQUAL * usual;
}
