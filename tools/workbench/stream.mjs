// Computes the load of data streams on a port.

import { SHARED_SET } from "mip-protocol/tools";
import { certaintyOn } from "./build.mjs";

/** Bytes of a packet besides its fields. */
const FRAME = 6;

/** The number of bits that a UART sends for a byte. */
const BITS = 10;

/**
 * Returns the load of streams: `bytes` per second, and the minimum `baud` rate of a UART, by
 * the manuals' formula: packets of a set are sent at the highest rate of its fields.
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

/**
 * Returns the data set of a list of fields with decimations, and its base rate on a device; undefined if it is not
 * known.
 * @param list the `parameter` of the list, with the `values` beside it
 */
export function baseOf(protocol, device, list) {
    const where = list?.parameter.fields_of;
    const set = protocol.model.sets.find(({ number, name }) => (list?.values[where] ?? where) === number || name === where);
    const rates = protocol.model.devices.find(({ id }) => id === device)?.base_rates;
    return { set, base: rates?.find((rate) => rate.set === set?.name)?.hertz };
}

/**
 * Returns the load of the message formats among some fields on a device; undefined if there are none, or if a base rate
 * is not known.
 */
export function formatNeed(protocol, device, entries) {
    const streams = [];
    for (const { field, values } of entries) {
        for (const parameter of field.parameters) {
            const items = parameter.fields_of && values[parameter.name];
            if (!Array.isArray(items) || !items.every((one) => one.decimation !== undefined)) continue;
            const { set, base } = baseOf(protocol, device, { parameter, values });
            const chosen = items.map((one) => ({
                field: protocol.candidates(set?.number, one.descriptor)[0],
                rate: base / one.decimation,
            }));
            if (chosen.some((one) => !one.field || !Number.isFinite(one.rate))) return undefined;
            streams.push(chosen);
        }
    }
    return streams.flat().length ? needOf(streams) : undefined;
}

/** "3400 bytes/s; over a UART at least 34000 Bd." */
export function needText({ bytes, baud }) {
    return `${Math.ceil(bytes)} bytes/s; over a UART at least ${Math.ceil(baud)} Bd.`;
}

/**
 * Returns the ports of a device with the lowest sufficient rate: undefined if there is none, null for USB, which has no
 * baud rate, and "not known" for any other port without a list of rates.
 */
export function portsFor(device, baud) {
    const unlisted = ({ name }) => (name.startsWith("USB") ? null : "not known");
    return (device?.ports ?? []).map((port) => ({
        port,
        rate: port.baud_rates.length ? port.baud_rates.filter((rate) => rate >= baud).sort((a, b) => a - b)[0] : unlisted(port),
    }));
}

/**
 * Returns the data sets of a device with the fields that can be streamed in each, shared ones first, and the base rate:
 * undefined if it is not known, 0 for a set that is sent as it arrives. Without a device, or with an incomplete
 * profile, they include fields that are not listed.
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
