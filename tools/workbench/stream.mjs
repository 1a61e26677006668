// How much a port must carry for a stream of data fields.

import { SHARED_SET } from "mip-protocol/tools";
import { certaintyOn } from "./build.mjs";

/** Bytes of a packet beside its fields. */
const FRAME = 6;

/** Bits that a UART sends for a byte. */
const BITS = 10;

/**
 * What streams take: `bytes` per second, and the `baud` rate that a UART needs at least, by the formula of the manuals:
 * packets of a set are sent at the highest rate of its fields.
 *
 * @param streams for each data set an array of fields with their rates in Hz: [{ field, rate }]
 */
export function needOf(streams) {
    let bytes = 0;
    for (const fields of streams) {
        const highest = Math.max(0, ...fields.map(({ rate }) => rate));
        bytes += FRAME * highest + fields.reduce((sum, { field, rate }) => sum + (field.max_size + 2) * rate, 0);
    }
    return { bytes, baud: BITS * bytes };
}

/** The ports of a device with the smallest rate that is enough: undefined if none is, null where there is no rate. */
export function portsFor(device, baud) {
    return (device?.ports ?? []).map((port) => ({
        port,
        rate: port.baud_rates.length ? port.baud_rates.filter((rate) => rate >= baud).sort((a, b) => a - b)[0] : null,
    }));
}

/**
 * The data sets of a device with the fields that can be streamed in each, shared ones first, and the base rate: undefined if
 * it is not known, 0 for a set that is sent as it arrives. Without a device, all; of an incomplete profile, what is not
 * listed too.
 */
export function streamsOf(protocol, device) {
    const rates = new Map(device?.base_rates?.map((rate) => [rate.set, rate.hertz]));
    const fieldsOf = (set) =>
        (set?.fields ?? [])
            .map((name) => protocol.field(name))
            .filter((field) => certaintyOn(protocol, device, field, set.number) !== undefined);
    const shared = fieldsOf(protocol.sets.get(SHARED_SET));
    return protocol.model.sets
        .filter((set) => set.kind === "data" && set.number !== SHARED_SET)
        .map((set) => ({ set, base: rates.get(set.name), own: fieldsOf(set) }))
        .filter(({ own }) => own.length)
        .map(({ set, base, own }) => ({ set, base, fields: [...shared, ...own] }));
}
