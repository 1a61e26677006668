// Surveys a log of any size, which is read in pieces: packets, rates, gaps.

import { MipError, nameIn, Parser } from "mip-protocol/tools";
import { Clocks, Rhythm } from "./clocks.mjs";

/** The number of bytes in a page, which contains the packets that begin in them. */
const PAGE = 8192;

/** The maximum number of gaps that are stored. */
const GAPS = 1000;

/**
 * Surveys the pieces of a log, Uint8Arrays in order: { bytes, packets, skipped, sentences, fields, gaps, pages }.  A
 * field has `name`, `set`, `field`, `count`, and a `rhythm` by the clock of the device; a gap, the fields that it
 * concerns and the packet after it; a page, the `offset` at which it begins and the number of the first packet in it.
 * @param progress is called with the bytes that were read; if it returns false, the survey ends there
 */
export async function survey(protocol, pieces, progress = () => true) {
    const found = { bytes: 0, packets: 0, sentences: 0, damaged: 0, pages: [{ offset: 0, first: 0 }] };
    const fields = new Map();
    const clocks = new Clocks(protocol);
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
                const key = packet.set * 256 + packet.bytes[at + 1];
                let one = fields.get(key);
                if (!one) {
                    one = seriesOf(protocol, packet, at, end);
                    fields.set(key, one);
                }
                one.count++;
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
        if (progress(found.bytes) === false) break;
    }
    take(parser.flush());
    const holds = ({ first }, i) => (found.pages[i + 1]?.first ?? found.packets) > first;
    return {
        ...found,
        skipped: parser.skipped,
        pages: found.pages.filter(holds),
        gaps: [...gaps.values()].sort((a, b) => a.packet - b.packet),
        fields: [...fields.values()].sort((a, b) => a.set - b.set || a.descriptor - b.descriptor),
    };
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
    return { set: packet.set, descriptor, field, name, count: 0, rhythm: new Rhythm() };
}
