// The time of packets by clock. A time that is not valid as a date is that of a clock without one.

import { MipError } from "./bytes.mjs";
import { bitsNumber } from "./naming.mjs";
import { validity } from "./validity.mjs";

/** Nanoseconds. */
const SECOND = 1_000_000_000n;
const WEEK = 604_800_000_000_000;

/** Each part of a timestamp must be below this many nanoseconds, so that the sum of two fits into 64 bits. */
const MOST = 4e18;

export class Clock {
    #sources;
    #epoch;
    #leaps;

    /**
     * @param epoch its day, "1980-01-06"; undefined if it has no date
     * @param leaps day -> seconds by which clocks with an epoch are ahead of UTC from then on
     * @param sources the timestamps that can contain its time, lowest descriptor first
     */
    constructor(name, epoch, leaps, sources) {
        this.name = name;
        this.dated = epoch !== undefined;
        this.#epoch = secondsOf(epoch ?? "1970-01-01");
        this.#leaps = Object.entries(leaps).map(([day, ahead]) => [(secondsOf(day) - this.#epoch + BigInt(ahead)) * SECOND, BigInt(ahead)]);
        this.#sources = sources;
    }

    /** See `packet.time` and `Times`. */
    timeOf(packet, device, seen) {
        for (const source of this.#sources) {
            const values = valuesOf(source, packet);
            if (values === undefined) continue;
            const time = this.#read(source, values, device, seen);
            if (time !== undefined) return time;
        }
        return undefined;
    }

    /** Converts a time of a clock with a date to UTC, in nanoseconds since 1970. A leap second becomes the second after it. */
    utc(time) {
        const [, ahead] = this.#leaps.findLast(([begin]) => time >= begin) ?? [0n, 0n];
        return time + (this.#epoch - ahead) * SECOND;
    }

    #read(source, values, device, seen) {
        const [name, undated] = source.clocks;
        if (values === null) return name === this.name ? null : undefined;
        const bits = seen?.combined(source.isValid, values);
        const valid = source.parts.every(([part]) => source.isValid(values, part, device, bits));
        const ofWeek = timeOfWeek(source, values);
        const total = valid && ofWeek !== null ? sum(source.parts, values) : null;
        const time = total > ofWeek || !hasWeeks(source) ? total : null; // week 0 is no date
        if (name === this.name) return time !== null && this.dated ? this.utc(time) : time;
        return time === null && undated === this.name ? ofWeek : undefined;
    }
}

export class Times {
    #device;
    #seen = new Map(); // `isValid` of a timestamp -> its flags so far
    changed = false;

    constructor({ device } = {}) {
        this.#device = device;
    }

    time(packet, clock) {
        return clock.timeOf(packet, this.#device ?? packet.model, this);
    }

    get recognized() {
        return this.#device === undefined ? [...this.#seen].map(([isValid, bits]) => isValid.devices(bits)).find(Boolean) : undefined;
    }

    /** Combines the flags of a timestamp with those of earlier ones. */
    combined(isValid, values) {
        const { holders, devices } = isValid;
        const before = this.#seen.get(isValid);
        const all = Object.fromEntries(holders.map((name) => [name, bitsNumber(values[name]) | bitsNumber(before?.[name] ?? 0)]));
        this.#seen.set(isValid, all);
        this.changed ||= before !== undefined && devices(before) !== devices(all);
        return all;
    }
}

/**
 * Returns the values of the first such field in a packet that is long enough; null if they cannot be decoded, undefined
 * if there is none.
 */
function valuesOf(source, packet) {
    const { reader, set } = packet;
    if (!source.occursIn(set)) return undefined;
    let found;
    packet.walk((at, end) => {
        if (reader.bytes[at + 1] === source.descriptor && end - at - 2 >= source.size) found = [at + 2, end];
        return found;
    });
    if (!found) return undefined;
    try {
        return source.decode(reader, ...found);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return null;
    }
}

/** Returns the sum of these parts in nanoseconds; null if one is not a number, or absurd. */
function sum(parts, values) {
    let total = 0n;
    for (const [name, scale] of parts) {
        const value = values[name];
        const product = typeof value === "bigint" ? value * BigInt(scale) : typeof value === "number" ? value * scale : NaN;
        if (!(-MOST < product && product < MOST)) return null;
        total += typeof product === "bigint" ? product : BigInt(rounded(product));
    }
    return total;
}

function hasWeeks({ parts }) {
    return parts.some(([, scale]) => scale === WEEK);
}

/** Returns the sum of the parts that are not weeks; null if it is in no week. */
function timeOfWeek(source, values) {
    const own = source.parts.filter(([, scale]) => scale !== WEEK);
    const time = sum(own, values);
    return time === null || (hasWeeks(source) && !(0 <= time && time <= WEEK)) ? null : time;
}

/** Rounds to the nearest whole number, and the middle to the nearest even one. */
function rounded(number) {
    const up = Math.round(number);
    return up - number === 0.5 && up % 2 ? up - 1 : up;
}

function secondsOf(day) {
    return BigInt(Date.parse(`${day}T00:00:00Z`)) / 1000n;
}

/**
 * Creates clocks from their names and epochs, and from timestamps: `descriptor`, `occursIn(set)`, the least `size` of
 * data, `decode(reader, from, to)`, `isValid` (see `validity`), `parts` (names of values and nanoseconds
 * of their units), and the names of `clocks`: that of a valid time, and that of a time of week that is not.
 */
export function clocksOf(epochs, leaps, timestamps) {
    const ordered = [...timestamps].sort((a, b) => a.descriptor - b.descriptor);
    return epochs.map(([name, epoch]) => {
        const own = ordered.filter(({ clocks }) => clocks.includes(name));
        return new Clock(name, epoch, leaps, own);
    });
}

/**
 * Creates clocks: constant -> clock. `timestamps`: type, sets (null: all of its sets), least size, names of clocks,
 * member -> nanoseconds of its unit.
 */
export function clocks(names, leaps, timestamps) {
    const sources = timestamps.map(([kind, sets, size, own, scales]) => ({
        descriptor: kind.DESCRIPTOR,
        occursIn: (set) => (sets ? sets.includes(set) : kind.occursIn(set)),
        size,
        decode: (reader, from, to) => kind.layout.decode(reader, from, to, kind.SET),
        isValid: kind.VALID ?? validity({}),
        parts: Object.entries(scales),
        clocks: own,
    }));
    const found = clocksOf(Object.values(names), leaps, sources);
    return Object.fromEntries(Object.keys(names).map((name, i) => [name, found[i]]));
}
