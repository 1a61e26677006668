// Finds packets in a stream, among anything else.

import { bytesOf, concatenated } from "./bytes.mjs";
import { Packet } from "./packet.mjs";
import { isSet } from "./protocol.mjs";

/**
 * Takes bytes in pieces of any size and gives the same packets for each division. What is no packet costs nothing but
 * itself: the search goes on one byte behind its beginning.
 */
export class Parser {
    constructor(protocol) {
        this.protocol = protocol;
        this.pending = new Uint8Array(0);
        /** Bytes so far that belong to no packet. */
        this.skipped = 0;
    }

    /** The packets that are complete with these bytes, a Uint8Array or an ArrayBuffer. */
    feed(bytes) {
        this.pending = concatenated(this.pending, bytesOf(bytes));
        return this.search(false);
    }

    /** The stream has ended: the packets behind one that is incomplete. */
    flush() {
        return this.search(true);
    }

    search(ended) {
        const packets = [];
        let at = 0;
        while (at < this.pending.length) {
            const size = packetAt(this.protocol, this.pending, at);
            if (size === undefined && !ended) break;
            if (size) {
                packets.push(new Packet(this.protocol, this.pending.slice(at, at + size)));
                at += size;
            } else {
                this.skipped++;
                at++;
            }
        }
        this.pending = this.pending.slice(at);
        return packets;
    }
}

/** The size of the whole packet that begins here; 0 if there is none, undefined if the bytes do not tell yet. */
function packetAt(protocol, bytes, at) {
    const [first, second] = protocol.sync;
    const left = bytes.length - at;
    if (bytes[at] !== first || (left > 1 && bytes[at + 1] !== second) || (left > 2 && !isSet(bytes[at + 2]))) return 0;
    if (left < 4 || left < bytes[at + 3] + 6) return undefined;
    const size = bytes[at + 3] + 6;
    return new Packet(protocol, bytes.subarray(at, at + size)).sound ? size : 0;
}

/**
 * What bytes consist of, in order: each part has its bytes, its offset, and a kind: "packet"; "damaged", a packet with a
 * wrong checksum whose fields end where it does; "incomplete", the beginning of a packet at the end; and "other".
 * A damaged or incomplete packet never hides a whole one.
 */
export function segments(protocol, given) {
    const bytes = bytesOf(given);
    const found = [];
    const add = (kind, offset, size) => {
        const last = found.at(-1);
        if (kind === "other" && last?.kind === "other") {
            last.bytes = bytes.subarray(last.offset, offset + size);
        } else {
            found.push({ kind, offset, bytes: bytes.subarray(offset, offset + size) });
        }
        return size;
    };
    const wholeWithin = (from, to) => {
        for (let at = from; at < to; at++) if (packetAt(protocol, bytes, at)) return true;
        return false;
    };
    for (let at = 0; at < bytes.length; ) {
        const size = packetAt(protocol, bytes, at);
        const left = bytes.length - at;
        if (size) {
            at += add("packet", at, size);
        } else if (size === undefined && left > 1 && !wholeWithin(at + 1, bytes.length)) {
            at += add("incomplete", at, left);
        } else if (isDamaged(protocol, bytes, at) && !wholeWithin(at + 1, at + bytes[at + 3] + 6)) {
            at += add("damaged", at, bytes[at + 3] + 6);
        } else {
            at += add("other", at, 1);
        }
    }
    return found;
}

function isDamaged(protocol, bytes, at) {
    const [first, second] = protocol.sync;
    if (bytes[at] !== first || bytes[at + 1] !== second || !isSet(bytes[at + 2])) return false;
    const size = bytes[at + 3] + 6;
    if (!(at + size <= bytes.length)) return false;
    try {
        for (const _ of new Packet(protocol, bytes.subarray(at, at + size)).fields());
        return true;
    } catch {
        return false;
    }
}
