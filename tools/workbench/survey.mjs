// What is in a log of any size, which is read in pieces: packets, rates, gaps.

import { FIRST_DATA_SET, MipError, nameIn, Parser } from "mip-protocol/tools";

/** Bytes after which a page begins: it holds the packets that begin there. */
const PAGE = 8192;

/** Intervals from which the usual one is known. */
const FIRST = 40;

/** What is longer than so many usual intervals is a gap. */
const GAP = 1.6;

/** How many gaps are kept. */
const GAPS = 1000;

const WEEK = 604_800;

/**
 * Surveys the pieces of a log, Uint8Arrays in order: { bytes, packets, skipped, sentences, fields, gaps, pages }.
 *
 * A field has `name`, `set`, `field`, `count`, and of data with timestamps `seconds`, `rate`, `gaps` and `lost`, by the clock
 * of the device; a gap, the fields that it concerns and the packet behind it; a page, the `offset` at which it begins and
 * the number of the first packet in it.
 *
 * @param progress is called with the bytes that were read; if it returns false, the survey ends there
 */
export async function survey(protocol, pieces, progress = () => true) {
    const found = { bytes: 0, packets: 0, sentences: 0, damaged: 0, gaps: [], pages: [{ offset: 0, first: 0 }] };
    const fields = new Map();
    const watch = new Clocks(protocol);
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
            const time = watch.timeOf(packet);
            packet.walk((at, end) => {
                const key = packet.set * 256 + packet.bytes[at + 1];
                let one = fields.get(key);
                if (!one) {
                    one = seriesOf(protocol, packet, at, end);
                    fields.set(key, one);
                }
                const gap = one.add(time);
                if (!gap) return;
                const last = found.gaps.at(-1);
                if (last?.packet === found.packets) last.fields.push(one);
                else if (found.gaps.length < GAPS) found.gaps.push({ ...gap, fields: [one], packet: found.packets });
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
        if (progress(found.bytes) === false) break;
    }
    take(parser.flush());
    const holds = ({ first }, i) => (found.pages[i + 1]?.first ?? found.packets) > first;
    return {
        ...found,
        skipped: parser.skipped,
        pages: found.pages.filter(holds),
        fields: [...fields.values()].sort((a, b) => a.set - b.set || a.descriptor - b.descriptor),
    };
}

/** Finds the time of packets, by the first timestamp in each. */
class Clocks {
    #readers = new Map(); // set and descriptor -> reads seconds; undefined of other fields

    constructor(protocol) {
        this.protocol = protocol;
    }

    /** { clock, seconds }, or undefined; packets of an event have the time of the event, and are apart. */
    timeOf(packet) {
        let time;
        packet.walk((at, end) => {
            if (time) return;
            const seconds = this.#reader(packet, at, end)?.(packet.bytes.subarray(at + 2, end));
            if (seconds !== undefined) time = { clock: packet.bytes[at + 1], seconds };
        });
        return time;
    }

    #reader(packet, at, end) {
        const key = packet.set * 256 + packet.bytes[at + 1];
        if (!this.#readers.has(key)) {
            const field = this.protocol.choose(packet.set, packet.bytes[at + 1], packet.bytes.subarray(at + 2, end));
            this.#readers.set(key, packet.set >= FIRST_DATA_SET ? readerOf(field) : undefined);
        }
        return this.#readers.get(key);
    }
}

/** A timestamp begins with a time of week in seconds, or with nanoseconds. */
function readerOf(field) {
    const [first] = field?.parameters ?? [];
    const view = (data) => new DataView(data.buffer, data.byteOffset, data.length);
    if (first?.name === "tow" && first.type === "double") return (data) => (data.length < 8 ? undefined : view(data).getFloat64(0));
    if (first?.name === "nanoseconds" && first.type === "u64" && /timestamp/i.test(field.title)) {
        return (data) => (data.length < 8 ? undefined : Number(view(data).getBigUint64(0)) / 1e9);
    }
    return undefined;
}

function seriesOf(protocol, packet, at, end) {
    const descriptor = packet.bytes[at + 1];
    let field;
    try {
        field = protocol.choose(packet.set, descriptor, packet.bytes.subarray(at + 2, end));
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
    }
    const name = field ? nameIn(field, packet.set) : undefined;
    return new Series({ set: packet.set, descriptor, field, name });
}

/** The times of one field. */
class Series {
    #last; // time
    #clock;
    #first = []; // intervals, until the usual one is known

    constructor(of) {
        Object.assign(this, of, { count: 0, seconds: 0, timed: 0, gaps: 0, lost: 0, usual: undefined });
    }

    /** Counts one more; a gap before it is returned: { at, seconds, lost }. */
    add(time) {
        this.count++;
        if (!time) return undefined;
        const before = this.#last;
        this.#clock ??= time.clock;
        if (time.clock !== this.#clock || !Number.isFinite(time.seconds)) return undefined;
        this.#last = time.seconds;
        if (before === undefined) return undefined;
        const interval = time.seconds - before + (time.seconds < before - WEEK / 2 ? WEEK : 0);
        if (interval <= 0 || interval > WEEK / 2) return undefined; // the same instant, or the clock was set
        this.seconds += interval;
        this.timed++;
        if (this.usual === undefined) {
            this.#first.push(interval);
            if (this.#first.length === FIRST) this.#settle();
            return undefined;
        }
        return this.#judge(interval, before);
    }

    #settle() {
        this.usual = [...this.#first].sort((a, b) => a - b)[FIRST >> 1];
        for (const interval of this.#first) this.#judge(interval, 0);
    }

    #judge(interval, at) {
        if (interval <= GAP * this.usual) return undefined;
        const lost = Math.round(interval / this.usual) - 1;
        this.gaps++;
        this.lost += lost;
        return { at, seconds: interval, lost };
    }

    /** Hz, without the time that is lost in gaps. */
    get rate() {
        if (!this.timed) return undefined;
        return (this.timed + this.lost) / this.seconds;
    }
}
