// Starts a device's data at rates in Hz.

import { MipError } from "./bytes.mjs";

const LARGEST = 0xffff; // decimation

/**
 * @param rates a Map: class of a field -> Hz, 0 for the highest rate
 * @param timestamp false for none, or the name of its clock
 * @param identified false to ask the device which model it is
 * @param discard called with the set whose message format has changed
 */
export async function stream(device, session, rates, { set, timestamp = true }, identified, discard) {
    const number = setOf(rates, set);
    // Fields that all sets share come first, because each packet of a long message repeats them.
    const kinds = [...rates.keys()].sort((a, b) => Array.isArray(a.SETS) - Array.isArray(b.SETS));
    const stamps = timestamps(session, number, kinds, timestamp);
    // The device learns from the answer; without one, flags are read as those of no known model.
    if (!identified) await device.exchange([session.identify()]);
    const { base, older } = await baseRate(device, session, number);
    const decimations = new Map([...rates].map(([kind, rate]) => [kind, decimation(base, rate)]));
    const nearest = new Map([...decimations].map(([kind, by]) => [kind, base / by]));
    // 333.33 Hz is accepted for 1000 Hz / 3.
    const missing = [...rates].filter(([kind, rate]) => rate && Math.abs(rate - nearest.get(kind)) > 1e-4 * rate);
    if (missing.length && base) {
        const words = missing.map(([kind, rate]) => `${kind.NAME} at ${rate} Hz (nearest: ${nearest.get(kind)} Hz)`);
        throw new MipError("rate", `the base rate is ${base} Hz; not possible: ${words.join(", ")}`, { base, nearest });
    }
    const items = kinds.map((kind) => session.item(kind.DESCRIPTOR, decimations.get(kind)));
    for (;;) {
        const stamp = stamps.shift();
        const all = stamp ? [session.item(stamp, Math.min(...decimations.values())), ...items] : items;
        try {
            await device.request(older ? older.format(all) : session.format(number, all));
            break;
        } catch (error) {
            if (error.kind === "refused" && stamps.length) continue;
            if (stamp && !stamps.length) error.message = `timestamp "${timestamp}": ${error.message}`;
            throw error;
        }
    }
    discard(number); // those that arrived earlier have another format
    await device.request(session.stream(older ? older.stream : number));
    await device.request(session.resume());
    return nearest;
}

/** Returns the descriptors of the timestamps to try for a set; undefined is none, the last one unless a clock is named. */
function timestamps(session, set, kinds, clock) {
    const any = typeof clock === "boolean";
    const own = session.timestamps.filter(([, , ...sets]) => !sets.length || sets.includes(set));
    const found = own.flatMap(([stamp, clocks]) => (any || clocks.includes(clock) ? stamp : []));
    if (!any && !found.length) {
        const known = [...new Set(own.flatMap(([, clocks]) => clocks))].join(", ");
        throw new MipError("timestamp", `no clock "${clock}" in set ${set}: ${known}`);
    }
    if (!clock || !kinds.length || kinds.some((kind) => found.includes(kind.DESCRIPTOR))) return [undefined];
    return any ? [...found, undefined] : found;
}

/** Reads the base rate of a set in Hz; also returns the commands of older devices if this is one. */
async function baseRate(device, session, set) {
    try {
        return { base: session.rate(await device.request(session.baseRate(set))) };
    } catch (refused) {
        const older = session.older[set];
        if (refused.kind !== "refused" || !older) throw refused;
        try {
            return { base: older.rate(await device.request(older.baseRate())), older };
        } catch (error) {
            throw error.kind === "refused" ? refused : error; // the device does not have this set
        }
    }
}

/** Returns the descriptor set that all of these fields occur in. */
export function setOf(rates, set) {
    const kinds = [...rates.keys()];
    for (const [kind, rate] of rates) {
        if (!(typeof rate === "number" && rate >= 0)) {
            throw new MipError("range", `${kind.NAME}: a rate must be 0 (the highest rate) or more, not ${rate}`);
        }
    }
    if (set !== undefined) {
        const wrong = kinds.find((kind) => !kind.occursIn(set));
        if (wrong) throw new MipError("set", `${wrong.NAME} does not occur in set ${set}`);
        return set;
    }
    const listed = kinds.map((kind) => kind.SETS).filter(Array.isArray);
    const common = (listed[0] ?? []).filter((one) => listed.every((sets) => sets.includes(one)));
    if (common.length !== 1) {
        const names = kinds.map((kind) => kind.NAME).join(", ") || "no fields";
        const none = listed.length ? "they are in no common set; call stream once for each set" : "that of the packets";
        throw new MipError("set", `\`set\` is needed for ${names}: ${common.join(", ") || none}`);
    }
    return common[0];
}

/** Returns the decimation for the nearest rate; 1 for the highest rate. */
export function decimation(base, wanted) {
    if (!base || !wanted || wanted >= base) return 1;
    const below = Math.min(Math.floor(base / wanted), LARGEST);
    const above = Math.min(below + 1, LARGEST);
    return base / below - wanted <= wanted - base / above ? below : above;
}
