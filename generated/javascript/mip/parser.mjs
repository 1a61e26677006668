// Finds packets in a stream of bytes.

import { bytesOf } from "./bytes.mjs";
import { Reader } from "./codec.mjs";
import { isSet, Packet, SYNC } from "./packet.mjs";

/** Bytes are copied to blocks of this size, so that small pieces do not cost a buffer each. Packets are views of them. */
const BLOCK = 16384;

/**
 * Accepts bytes in pieces of any size; the packets found do not depend on the division. A false packet never hides a true
 * one: the search continues one byte after its beginning.
 */
export class Parser {
    #block = new Uint8Array(0);
    #reader;
    #begin = 0; // the pending bytes in it
    #end = 0;

    constructor({ onSkipped } = {}) {
        this.onSkipped = onSkipped;
        this.skipped = 0;
    }

    /** Returns the packets that these bytes complete: a Uint8Array or an ArrayBuffer, which is copied. */
    feed(bytes) {
        const packets = [];
        const whole = bytesOf(bytes);
        for (let at = 0; at < whole.length; ) {
            if (this.#end === this.#block.length) {
                const { pending } = this; // less than a packet
                this.#block = new Uint8Array(BLOCK);
                this.#block.set(pending);
                this.#reader = new Reader(this.#block);
                this.#begin = 0;
                this.#end = pending.length;
            }
            const part = whole.subarray(at, at + this.#block.length - this.#end);
            this.#block.set(part, this.#end);
            this.#end += part.length;
            at += part.length;
            this.#search(packets);
        }
        return packets;
    }

    flush() {
        return this.#search([], true);
    }

    /** The bytes of an incomplete packet so far. */
    get pending() {
        return this.#block.subarray(this.#begin, this.#end);
    }

    lookBehind() {
        for (let at = this.#begin + 1; at < this.#end; at++) {
            if (!packetAt(this.#block, at, this.#end)) continue;
            this.#skip(at);
            return this.#search([]);
        }
        return [];
    }

    #search(packets, ended) {
        const bytes = this.#block;
        const end = this.#end;
        let at = this.#begin;
        while (at < end) {
            const size = packetAt(bytes, at, end);
            if (size === undefined && !ended) break;
            if (size) {
                this.#skip(at);
                packets.push(new Packet(this.#reader, at, at + size));
                at += size;
                this.#begin = at;
            } else {
                do at++;
                while (at < end && bytes[at] !== SYNC[0]);
            }
        }
        this.#skip(at);
        return packets;
    }

    /** Gives up the pending bytes before `at`. */
    #skip(at) {
        if (at === this.#begin) return;
        this.skipped += at - this.#begin;
        this.onSkipped?.(this.#block.subarray(this.#begin, at));
        this.#begin = at;
    }
}

/** Returns the size of the whole packet that begins here; 0 if there is none, undefined if that is not known yet. */
function packetAt(bytes, at, last = bytes.length) {
    const left = last - at;
    if (bytes[at] !== SYNC[0] || (left > 1 && bytes[at + 1] !== SYNC[1]) || (left > 2 && !isSet(bytes[at + 2]))) return 0;
    if (left < 4) return undefined;
    const size = bytes[at + 3] + 6;
    if (left < size) return undefined;
    let a = 0;
    let b = 0; // at most 260 bytes, so the sums need not be reduced in between
    const end = at + size - 2;
    for (let i = at; i < end; i++) {
        a += bytes[i];
        b += a;
    }
    return bytes[end] === (a & 0xff) && bytes[end + 1] === (b & 0xff) ? size : 0;
}

/**
 * Divides bytes into segments, in order. Each has its bytes, its offset, and a kind: "packet"; "damaged", a packet with a
 * wrong checksum whose fields end exactly where it does; "incomplete", the beginning of a packet at the end; and "other".
 * A damaged or incomplete packet never hides a whole one.
 */
export function segments(given) {
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
        for (let at = from; at < to; at++) if (packetAt(bytes, at)) return true;
        return false;
    };
    for (let at = 0; at < bytes.length; ) {
        const size = packetAt(bytes, at);
        const left = bytes.length - at;
        if (size) {
            at += add("packet", at, size);
        } else if (size === undefined && left > 1 && !wholeWithin(at + 1, bytes.length)) {
            at += add("incomplete", at, left);
        } else if (isDamaged(bytes, at) && !wholeWithin(at + 1, at + bytes[at + 3] + 6)) {
            at += add("damaged", at, bytes[at + 3] + 6);
        } else {
            at += add("other", at, 1);
        }
    }
    return found;
}

function isDamaged(bytes, at) {
    if (bytes[at] !== SYNC[0] || bytes[at + 1] !== SYNC[1] || !isSet(bytes[at + 2])) return false;
    const size = bytes[at + 3] + 6;
    return at + size <= bytes.length && new Packet(bytes.subarray(at, at + size)).walk(() => false) === undefined;
}
