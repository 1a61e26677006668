// Decodes bytes: packets, fields and values, with names, units and verdicts. The inspector shows it.

import {
    decodeData,
    decodePacket,
    deviceWithNumber,
    enumValue,
    FIRST_DATA_SET,
    fromHex,
    isSet,
    measuredHere,
    MipError,
    namedType,
    Packet,
    parametersAt,
    partsOf,
    sameBytes,
    segments,
    toHex,
    valueAt,
} from "mip-protocol/tools";
import { bytesOfText } from "./pasted.mjs";
import { baseOf } from "./stream.mjs";
import { choicesOf, hexByte, pathText, shown } from "./words.mjs";

/**
 * The parts of a text of bytes, as `segments` returns them, at most `most`; packets also have `set`, `fields`,
 * `misprints`, and the correct checksum, and other bytes `why`: the faults of those that begin like a packet. `packets`
 * counts all packets, and `more` the parts that are left out.
 * @param device the id of a device, whose readings are used where they differ, or a function that returns it for a field
 */
export function inspect(protocol, text, device = undefined, most = Infinity) {
    const { bytes, ignored } = bytesOfText(text);
    const all = segments(bytes);
    const parts = all.slice(0, most).map((part) => inspectPart(protocol, part, device));
    const packets = all.filter((part) => part.kind !== "other").length;
    return { bytes, ignored, parts, packets, more: all.length - parts.length, transactions: transactionsOf(parts) };
}

/** The parts of bytes, as `inspect` returns them. */
export function inspectBytes(protocol, bytes, device = undefined) {
    return segments(bytes).map((part) => inspectPart(protocol, part, device));
}

/**
 * Pairs commands with their replies, in the order of the commands: { command, answer, response }, with the fields of
 * the parts. A reply belongs to the first command of its set and descriptor without one; its response directly follows
 * it.
 */
export function transactionsOf(parts) {
    const found = [];
    for (const part of parts) {
        for (const [i, one] of (part.fields ?? []).entries()) {
            if (one.field?.role === "command" && one.set < FIRST_DATA_SET) found.push({ command: one });
            if (!one.answered) continue;
            const waiting = found.find(
                ({ command, answer }) => !answer && command?.set === one.set && command.descriptor === one.answered.descriptor,
            );
            const behind = part.fields[i + 1];
            const response = behind?.field?.role === "response" ? behind : undefined;
            if (waiting) Object.assign(waiting, { answer: one, response });
            else found.push({ answer: one, response });
        }
    }
    return found;
}

function inspectPart(protocol, part, device) {
    if (part.kind === "other") return { ...part, why: whyOther(protocol, part.bytes) };
    const packet = new Packet(part.kind === "incomplete" ? completed(part.bytes) : part.bytes);
    const set = protocol.sets.get(part.bytes[2]);
    const fields = decodePacket(protocol, packet).map((raw) => inspectField(protocol, raw, packet, part, device));
    const verdict =
        part.kind === "incomplete" ? {} : { sound: packet.sound, checksum: packet.checksum, rightChecksum: packet.rightChecksum };
    return { ...part, set, fields: fields.filter(Boolean), misprints: misprintsOf(protocol, part.bytes), ...verdict };
}

/** Returns the faults of the frames that begin with the sync bytes: [{ at, error }]. */
function whyOther(protocol, bytes) {
    const found = [];
    for (let at = 0; at + 3 < bytes.length; at++) {
        const frame = new Packet(bytes.subarray(at, at + bytes[at + 3] + 6));
        if (!sameBytes(bytes.subarray(at, at + 2), protocol.model.packet.sync)) continue;
        const set = toHex(bytes.subarray(at + 2, at + 3)).toUpperCase();
        if (!isSet(bytes[at + 2])) found.push({ at, error: new MipError("set", `descriptor set 0x${set}, which no packet has`) });
        else if (frame.bytes.length === bytes[at + 3] + 6) found.push({ at, error: decodePacket(protocol, frame).at(-1)?.error });
    }
    return found.filter(({ error }) => error);
}

/** Returns an incomplete packet, with zeros for the missing bytes. */
function completed(bytes) {
    const whole = new Uint8Array(Math.max((bytes[3] ?? 0) + 6, bytes.length));
    whole.set(bytes);
    return whole;
}

function inspectField(protocol, raw, packet, part, device) {
    if (raw.offset === undefined) return part.kind === "incomplete" ? undefined : { error: raw.error };
    const end = raw.offset + 2 + raw.data.length;
    if (part.kind === "incomplete" && end > part.bytes.length) return undefined;
    const found = { ...raw, bytes: packet.bytes.subarray(raw.offset, end) };
    if (!raw.field) return found;
    const on = typeof device === "function" ? device(raw.field) : device;
    const rows = (raw.parts ?? []).map((one) => inspectValue(protocol, raw, one, on));
    return { ...found, rows, answered: answeredBy(protocol, raw), errata: errataOf(protocol, raw.field) };
}

/** Interprets an acknowledge: the command, the code, and both in words; undefined for other fields. */
export function answeredBy(protocol, { set, field, values }) {
    if (field !== protocol.acknowledge || !values) return undefined;
    const [descriptor, code] = field.operations.map((op) => values[op.member]);
    const command = protocol.candidates(set, descriptor).find((one) => one.role === "command");
    const named = enumValue(protocol.type(protocol.model.ack_code), code);
    const title = command?.title ?? `Command ${hexByte(descriptor)}`;
    const why = named ? named.name.replaceAll("_", " ") : `code ${code}`;
    return { command, descriptor, code, accepted: code === 0, text: code === 0 ? `${title} acknowledged` : `${title} refused: ${why}` };
}

/** Returns the values of a data field: rows like those of `inspect`, with the `key` of each value. */
export function inspectData(protocol, { set, descriptor, field, data }, device) {
    if (!field) return [];
    try {
        const { values } = decodeData(protocol, field, data);
        const raw = { set, descriptor, field, values, data };
        const rows = partsOf(protocol, field, values).map((part) => ({
            key: part.path.join("."),
            ...inspectValue(protocol, raw, part, device),
        }));
        return rows;
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return [];
    }
}

/** Returns the rate in Hz of a field in a message format, if the device's base rate is known. */
function rateText(protocol, device, decimation, outer) {
    const { base } = baseOf(protocol, device, outer);
    return base && decimation ? `${Number((base / decimation).toPrecision(6))} Hz on the chosen device` : undefined;
}

function inspectValue(protocol, { field, values, data }, part, device) {
    const parameters = parametersAt(protocol, field, part.path);
    const places = part.path.flatMap((step, i) => (typeof step === "number" ? [] : [i])); // of the names in the path
    const [siblings, around] = [places.at(-1), places.at(-2)].map((place) => valueAt(values, part.path.slice(0, place)));
    const parameter = measuredHere(protocol, parameters.at(-1).parameter, siblings, device);
    const type = namedType(protocol, parameter, siblings, device);
    const index = part.path.slice(places.at(-1) + 1).at(-1);
    const outer = parameters.length > 1 ? { parameter: parameters.at(-2).parameter, values: around } : undefined;
    const meaning = parameter.shown
        ? choicesOf(protocol, parameter, siblings, outer).get(Number(part.value))
        : parameter.name === "model_number"
          ? deviceWithNumber(protocol, part.value)?.title
          : parameter.name === "decimation"
            ? rateText(protocol, device, Number(part.value), outer)
            : undefined;
    const byDevice = (parameter.variants ?? []).some((one) => one.by === "device" && one.type && !one.member);
    return {
        path: pathText([...parameters.slice(0, -1), { parameter }], part.path),
        bytes: data.subarray(part.offset, part.offset + part.size),
        value: part.value,
        parameter,
        type,
        meaning,
        byDevice: byDevice && device === undefined && meaning === undefined,
        ...shown(protocol, part, parameter, type, index, siblings),
    };
}

// ------------------------------------------------------------------------------------------------ errata

/** Returns the manuals' mistakes about a field: in the sections that it cites, and in its lengths. */
export function errataOf(protocol, field) {
    const places = new Set(field.sources.map((source) => `${source.manual}\n${source.section}`));
    return protocol.model.errata.filter(
        (erratum) =>
            (field.role !== "response" && places.has(`${erratum.manual}\n${erratum.section}`)) ||
            erratum.claims.some((claim) => claim.kind === "length" && claim.subject === field.name),
    );
}

/** Returns the examples that a manual prints with exactly these bytes, although they are wrong. */
export function misprintsOf(protocol, bytes) {
    const { errata } = protocol.model;
    return printedExamples(protocol.model)
        .filter(({ right, printed }) => printed.some((one) => isPrinted(one, bytes)) && !sameBytes(right, bytes))
        .map(({ example, right }) => ({
            example,
            right,
            errata: errata.filter((one) => one.claims.some((claim) => claim.kind === "example" && claim.subject === example.id)),
        }));
}

const printedIn = new WeakMap(); // model -> its examples: bytes are compared with all of them

function printedExamples(model) {
    const prepared = (example) => {
        const digits = example.string?.replace(/[^0-9a-f]/gi, "") ?? "";
        const printed = [digits.length % 2 ? undefined : fromHex(digits), example.table].filter((one) => one?.length);
        return { example, right: fromHex(example.packet), printed };
    };
    if (!printedIn.has(model)) printedIn.set(model, model.examples.map(prepared));
    return printedIn.get(model);
}

function isPrinted(printed, bytes) {
    return printed.length === bytes.length && printed.every((byte, i) => byte === null || byte === bytes[i]);
}
