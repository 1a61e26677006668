// The clocks of timestamps, and the rhythm of a field by one of them; `mip doctor` judges logs in the same way.

import { decodeData, MipError } from "mip-protocol/tools";

/** Seconds of the units of time. A timestamp is the sum of all parameters that have one of them. */
const UNITS = { week: 604_800, s: 1, ms: 1e-3, us: 1e-6, ns: 1e-9 };

/** The number of equal intervals that make a rhythm. */
const STEADY = 5;

/** Intervals whose relative difference is smaller are equal. */
const EQUAL = 0.1;

/** An interval longer than this many usual intervals is a gap. */
export const GAP = 1.5;

/**
 * Finds the time of packets by the clocks of the model. Each set has one clock: the last of those in its first packet
 * with a timestamp, as a clock without a date goes on evenly when the date is set. A clock that is not valid also runs.
 */
export class Clocks {
    #protocol;
    #order = new Map(); // timestamp -> the place of its clock
    #sources = new Map(); // set and descriptor -> the timestamp, undefined of other fields
    #chosen = new Map(); // set -> { place, valid, run }

    constructor(protocol) {
        this.#protocol = protocol;
        for (const [place, clock] of protocol.model.clocks.entries())
            for (const name of clock.timestamps) this.#order.set(protocol.field(name), place);
    }

    /**
     * Returns the time of a packet by its set's clock: { seconds, run }; undefined without a clock.
     * `run` counts how often the clock became valid or invalid: times before and after that cannot be compared.
     */
    timeOf(packet) {
        const chosen = this.#chosen.get(packet.set);
        let best;
        packet.walk((at, end) => {
            const source = this.#source(packet.set, packet.bytes[at + 1]);
            if (!source || (chosen ? best || source.place !== chosen.place : best?.place >= source.place)) return;
            best = this.#read(source, packet.bytes.subarray(at + 2, end)) ?? best;
        });
        if (!best) return undefined;
        const run = chosen ? chosen.run + (chosen.valid !== best.valid) : 0;
        this.#chosen.set(packet.set, { place: best.place, valid: best.valid, run });
        return { seconds: best.seconds, run };
    }

    #source(set, descriptor) {
        const key = set * 256 + descriptor;
        if (!this.#sources.has(key)) {
            const layouts = this.#protocol.candidates(set, descriptor);
            const place = layouts.length === 1 ? this.#order.get(layouts[0]) : undefined;
            this.#sources.set(key, place === undefined ? undefined : sourceOf(this.#protocol, layouts[0], place));
        }
        return this.#sources.get(key);
    }

    #read({ field, place, parts, flags }, data) {
        let values;
        try {
            values = decodeData(this.#protocol, field, data).values;
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            return undefined;
        }
        const valid = flags.every(({ name, bit }) => Math.floor(Number(values[name]) / 2 ** bit) % 2);
        const seconds = parts.reduce((sum, { name, scale }) => sum + Number(values[name]) * scale, 0);
        return Number.isFinite(seconds) ? { place, valid, seconds } : undefined;
    }
}

function sourceOf(protocol, field, place) {
    const keyOf = (unit) => protocol.model.units.find(({ symbol }) => symbol === unit)?.key ?? unit;
    const timed = field.parameters.filter(({ units }) => units?.length === 1 && keyOf(units[0]) in UNITS);
    const flags = [...new Set(timed.flatMap(({ valid }) => valid ?? []))].map((path) => {
        const [name, bit] = path.split(".");
        const type = protocol.type(field.parameters.find((one) => one.name === name).type);
        return { name, bit: type.bits.find((one) => one.name === bit).first };
    });
    return { field, place, flags, parts: timed.map(({ name, units }) => ({ name, scale: UNITS[keyOf(units[0])] })) };
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

    /** Processes the next time from `Clocks`, and returns the gaps that are now known: { at, seconds, lost, mark }. */
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
            this.#open.push({ at: before.seconds, seconds: interval, lost, mark });
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
