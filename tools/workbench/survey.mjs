// Surveys a log of any size, which is read in pieces: packets, rates, gaps.

import { decodeData, deviceWithNumber, isValid, MipError, nameIn, Parser, Times } from "mip-protocol/tools";
import { Clocks, Rhythm } from "./clocks.mjs";
import { Senders } from "./known.mjs";

/** The number of bytes in a page, which contains the packets that begin in them. */
const PAGE = 8192;

/** The maximum number of gaps that are stored. */
const GAPS = 1000;

/**
 * Surveys a log: { bytes, packets, skipped, sentences, fields, gaps, pages, spans, device, read }. A field has `name`,
 * `set`, `field`, `count`, how many are `valid` (undefined if it has no flags), and a `rhythm` by the clock of the device;
 * a gap, the fields that it concerns and the packet after it; a page, the `offset` at which it begins and the number of
 * the first packet in it. `spans` are those of `Clocks`; `reads` returns the id of the device as which a field is read, `read`
 * is what was assumed about it, in words.
 * @param open returns the pieces, Uint8Arrays in order; it is called again if a later part changes how flags are read
 * @param progress is called with the bytes that were read; if it returns false, the survey ends there
 * @param named the id of the device; if it is undefined, it is the one in the log, if there is one
 */
export async function survey(protocol, open, progress = () => true, named = undefined) {
    let device = named;
    let times = new Times({ device });
    for (;;) {
        const found = await surveyed(protocol, open(), progress, times, device);
        if (found.stopped) return found;
        if (device === undefined && found.device) {
            device = found.device;
            times = new Times({ device });
        } else if (times.changed) {
            times.changed = false;
        } else {
            const { senders, ...rest } = found;
            return { ...rest, device, reads: (field) => device ?? senders.reads(field), read: assumed(protocol, senders, device, named) };
        }
    }
}

/** Describes in words how flags and names were read. */
function assumed(protocol, senders, device, named) {
    if (device === undefined) return senders.lines.join("; ");
    const { title } = protocol.model.devices.find(({ id }) => id === device) ?? { title: device };
    return `device ${title}${named === undefined ? " (from the log)" : ""}`;
}

async function surveyed(protocol, pieces, progress, times, named) {
    const found = { bytes: 0, packets: 0, sentences: 0, damaged: 0, pages: [{ offset: 0, first: 0 }] };
    const fields = new Map();
    const clocks = new Clocks(protocol, times);
    const senders = new Senders(protocol);
    let device;
    const gaps = new Map(); // packet after it -> gap
    let dollar = false; // the last byte outside packets
    const parser = new Parser({
        onSkipped: (bytes) => {
            for (const byte of bytes) {
                if (dollar && byte >= 0x41 && byte <= 0x5a) found.sentences++; // NMEA: a dollar and a capital letter
                dollar = byte === 0x24;
            }
            if (bytes.length > 1 && bytes[0] === 0x75 && bytes[1] === 0x65) found.damaged++;
        },
    });
    const take = (packets) => {
        for (const packet of packets) {
            const time = clocks.timeOf(packet);
            packet.walk((at, end) => {
                const raw = packet.raw(at, end);
                const key = raw.set * 256 + raw.descriptor;
                let one = fields.get(key);
                if (!one) {
                    one = seriesOf(protocol, raw);
                    if (one.field?.role === "data") one.learn = senders.add(raw.set, one.field);
                    fields.set(key, one);
                }
                one.count++;
                one.learn?.(raw.data);
                if (one.flagged.length || one.names) {
                    const values = valuesOf(protocol, one.field, raw.data);
                    if (one.names) device ??= deviceIn(protocol, values);
                    else one.valid += Boolean(values) && one.flagged.every((name) => isValid(protocol, one.field, values, name, named));
                }
                for (const { mark: packet, ...gap } of one.rhythm.add(time, found.packets)) {
                    if (gaps.has(packet)) gaps.get(packet).fields.push(one);
                    else if (gaps.size < GAPS) gaps.set(packet, { ...gap, fields: [one], packet });
                }
            });
            found.packets++;
        }
    };
    for await (const piece of pieces) {
        for (let at = 0; at < piece.length; at += PAGE) {
            const part = piece.subarray(at, at + PAGE);
            take(parser.feed(part));
            found.bytes += part.length;
            found.pages.push({ offset: found.bytes - parser.pending.length, first: found.packets });
        }
        if (progress(found.bytes) === false) {
            found.stopped = true;
            break;
        }
    }
    take(parser.flush());
    const holds = ({ first }, i) => (found.pages[i + 1]?.first ?? found.packets) > first;
    return {
        ...found,
        device,
        senders,
        spans: clocks.spans,
        skipped: parser.skipped,
        pages: found.pages.filter(holds),
        gaps: [...gaps.values()].sort((a, b) => a.packet - b.packet),
        fields: [...fields.values()].sort((a, b) => a.set - b.set || a.descriptor - b.descriptor),
    };
}

function seriesOf(protocol, { set, descriptor, data }) {
    let field;
    try {
        field = protocol.choose(set, descriptor, data);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
    }
    const name = field ? nameIn(field, set) : undefined;
    const flagged = field?.role === "data" ? field.parameters.filter(({ valid }) => valid?.length).map((one) => one.name) : [];
    const names = field?.role === "response" && field.parameters.some(({ type }) => named(protocol, type)); // the device
    const valid = flagged.length ? 0 : undefined;
    return { set, descriptor, field, name, count: 0, valid, flagged, names, rhythm: new Rhythm() };
}

function named(protocol, type) {
    return protocol.types.get(type)?.parameters?.some(({ name }) => name === "model_number");
}

function valuesOf(protocol, field, data) {
    try {
        return decodeData(protocol, field, data).values;
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return undefined;
    }
}

/** Returns the id of the device that a reply names. */
function deviceIn(protocol, values = {}) {
    const numbers = Object.values(values).map((one) => one?.model_number);
    return numbers.map((number) => number && deviceWithNumber(protocol, number)).find(Boolean)?.id;
}
