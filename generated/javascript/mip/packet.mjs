// Packets: checks, builds and divides them into fields.

import { MipError, bytesOf, checksum, described, sameBytes, toHex } from "./bytes.mjs";
import { MAX_FIELD_DATA, Reader } from "./codec.mjs";

/** The two bytes that each packet begins with. */
export const SYNC = /* @__PURE__ */ Uint8Array.of(0x75, 0x65);

const HEAD = 4;
const TAIL = 2;
const MAX_PAYLOAD = 255;

export const SHARED_SET = 255;

export const FIRST_DATA_SET = 128;

/** May a packet have this descriptor set? Not 0 or 255, which denote all command sets and all data sets. */
export function isSet(number) {
    return Number.isInteger(number) && number > 0 && number < SHARED_SET;
}

/** An undecoded field: its `descriptor` and `data`, the packet's `set`, and the field's `offset` in the packet. */
export class RawField {
    constructor(set, descriptor, data, offset) {
        this.set = set;
        this.descriptor = descriptor;
        this.data = data;
        this.offset = offset;
    }
}

/** Bytes in the form of a packet; the checksum may be wrong. */
export class Packet {
    #reader;
    #begin;
    #end;

    /** Wraps bytes, or those from `begin` to `end` of a reader for several packets. */
    constructor(bytes, begin, end) {
        this.#reader = end ? bytes : new Reader(bytes);
        this.#begin = end ? begin : 0;
        this.#end = end ?? bytes.length;
        this.set = this.#reader.bytes[this.#begin + 2];
    }

    get bytes() {
        return this.#reader.bytes.subarray(this.#begin, this.#end);
    }

    /** Reads the bytes at the offsets that `walk` reports. */
    get reader() {
        return this.#reader;
    }

    static from(given) {
        const bytes = bytesOf(given);
        if (!sameBytes(bytes.subarray(0, 2), SYNC)) throw new MipError("sync", `it does not begin with ${toHex(SYNC, " ")}`);
        if (bytes.length < HEAD + TAIL || bytes.length !== bytes[3] + HEAD + TAIL || !isSet(bytes[2])) {
            throw new MipError("length", `its ${bytes.length} bytes are not a whole packet`);
        }
        const packet = new Packet(bytes);
        if (!packet.sound) {
            const [found, right] = [packet.checksum, packet.rightChecksum].map((two) => toHex(two, " "));
            throw new MipError("checksum", `its checksum is ${found}, but should be ${right}`);
        }
        return packet;
    }

    static build(set, fields) {
        if (!isSet(set)) throw new MipError("set", `no packet has descriptor set ${described(set)}`);
        const payload = [];
        for (const { descriptor, data } of fields) {
            if (data.length > MAX_FIELD_DATA) throw new MipError("length", `a field holds at most ${MAX_FIELD_DATA} bytes of data`);
            payload.push(data.length + 2, descriptor, ...data);
        }
        const size = payload.length;
        if (size > MAX_PAYLOAD) throw new MipError("length", `the fields have ${size} bytes; a packet holds ${MAX_PAYLOAD}`);
        const packet = new Packet(Uint8Array.of(...SYNC, set, size, ...payload, 0, 0));
        packet.checksum.set(packet.rightChecksum);
        return packet;
    }

    get payload() {
        return this.bytes.subarray(HEAD, -TAIL);
    }

    get checksum() {
        return this.bytes.subarray(-TAIL);
    }

    get rightChecksum() {
        return checksum(this.bytes.subarray(0, -TAIL));
    }

    get sound() {
        return sameBytes(this.checksum, this.rightChecksum);
    }

    *fields() {
        const found = [];
        const wrong = this.walk((at, end) => {
            found.push(this.raw(at, end));
        });
        yield* found;
        if (wrong) throw wrong;
    }

    /** Calls `visit(at, end)` for each field until it returns true; returns the error of a malformed field. */
    walk(visit) {
        const { bytes } = this.#reader;
        const last = this.#end - TAIL;
        for (let at = this.#begin + HEAD; at < last; ) {
            const end = at + bytes[at];
            if (end < at + 2 || end > last) return malformed(end - at, last - at);
            if (visit(at, end)) return undefined;
            at = end;
        }
        return undefined;
    }

    /** Returns the field from `at` to `end`, undecoded. */
    raw(at, end) {
        const { bytes } = this.#reader;
        return new RawField(this.set, bytes[at + 1], bytes.subarray(at + 2, end), at - this.#begin);
    }

    /** Returns its time by a clock of `mip-protocol/time`, in nanoseconds; null if that is not valid, undefined if it has none. */
    time(clock, device = this.model) {
        return clock.timeOf(this, device);
    }

    find(kind) {
        return this.#search(kind);
    }

    findAll(kind) {
        return this.#search(kind, []);
    }

    #search({ layout }, all) {
        const reader = this.#reader;
        const { bytes } = reader;
        const { set } = this;
        if (set !== layout.set && (layout.set || !layout.occursIn(set))) return all;
        const { descriptor, fits } = layout;
        const last = this.#end - TAIL;
        for (let at = this.#begin + HEAD; at < last; ) {
            const end = at + bytes[at];
            if (end < at + 2 || end > last) throw malformed(end - at, last - at);
            if (bytes[at + 1] === descriptor && (!fits || layout.matches(bytes, at + 2, end))) {
                const field = layout.decode(reader, at + 2, end, set);
                if (!all) return field;
                all.push(field);
            }
            at = end;
        }
        return all;
    }
}

function malformed(size, left) {
    return new MipError("field_length", `a field of length ${size} in ${left} bytes`);
}
