// Packets: checks, builds and divides them into fields.

import { MipError, bytesOf, checksum, concatenated, described, sameBytes, toHex } from "./bytes.mjs";
import { MAX_FIELD_DATA, Reader } from "./codec.mjs";

/** The two bytes that each packet begins with. */
export const SYNC = /* @__PURE__ */ Uint8Array.of(0x75, 0x65);

const HEAD = 4;
const TAIL = 2;
const MAX_PAYLOAD = 255;

/** Descriptor set of the fields that are valid in every data set. */
export const SHARED_SET = 255;

/** The lowest number of a data set; command sets are below. */
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

    /** @param reader reads the bytes around these, if there is one for several packets */
    constructor(bytes, reader) {
        this.bytes = bytes;
        this.#reader = reader;
    }

    /** Checks that bytes are a whole packet. Throws a MipError: "sync", "length" or "checksum". */
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

    /** Builds a packet from fields, each with a `descriptor` and `data`. Throws a MipError if they do not fit. */
    static build(set, fields) {
        if (!isSet(set)) throw new MipError("set", `no packet has descriptor set ${described(set)}`);
        const payload = concatenated(
            ...fields.flatMap(({ descriptor, data }) => {
                if (data.length > MAX_FIELD_DATA) throw new MipError("length", `a field holds at most ${MAX_FIELD_DATA} bytes of data`);
                return [Uint8Array.of(data.length + 2, descriptor), data];
            }),
        );
        if (payload.length > MAX_PAYLOAD) {
            throw new MipError("length", `the fields have ${payload.length} bytes; a packet holds ${MAX_PAYLOAD}`);
        }
        const head = concatenated(SYNC, Uint8Array.of(set, payload.length), payload);
        return new Packet(concatenated(head, checksum(head)));
    }

    get set() {
        return this.bytes[2];
    }

    get payload() {
        return this.bytes.subarray(HEAD, -TAIL);
    }

    get checksum() {
        return this.bytes.subarray(-TAIL);
    }

    /** The correct checksum. */
    get rightChecksum() {
        return checksum(this.bytes.subarray(0, -TAIL));
    }

    /** Is the checksum correct? */
    get sound() {
        return sameBytes(this.checksum, this.rightChecksum);
    }

    /** Yields the fields; throws a MipError at a malformed one. */
    *fields() {
        const { bytes, set } = this;
        const found = [];
        const wrong = this.walk((at, end) => {
            found.push(new RawField(set, bytes[at + 1], bytes.subarray(at + 2, end), at));
        });
        yield* found;
        if (wrong) throw wrong;
    }

    /** Calls `visit(at, end)` for each field until it returns true; returns the error of a malformed field. */
    walk(visit) {
        const { bytes } = this;
        const last = bytes.length - TAIL;
        for (let at = HEAD; at < last; at += bytes[at]) {
            const end = at + bytes[at];
            if (bytes[at] < 2 || end > last) {
                return new MipError("field_length", `a field of length ${bytes[at]} in ${last - at} bytes`);
            }
            if (visit(at, end)) return undefined;
        }
        return undefined;
    }

    /** Returns its time by a clock of `mip-protocol/time`, in nanoseconds; null if that is not valid, undefined if it has none. */
    time(clock, device) {
        return clock.timeOf(this, device);
    }

    /** Returns the first field of a type; undefined if there is none. Throws a MipError if it cannot be decoded. */
    find(kind) {
        return this.#search(kind, true)[0];
    }

    /** Returns the fields of a type, in order. Throws a MipError if one cannot be decoded. */
    findAll(kind) {
        return this.#search(kind, false);
    }

    #search(kind, once) {
        const found = [];
        const { bytes, set } = this;
        if (!kind.occursIn(set)) return found;
        const wrong = this.walk((at, end) => {
            if (bytes[at + 1] !== kind.DESCRIPTOR || !kind.matches(bytes, at + 2, end)) return false;
            found.push(this.read(kind, at, end));
            return once;
        });
        if (wrong) throw wrong;
        return found;
    }

    /** Decodes the field from `at` to `end` as one of this type. Throws a MipError. */
    read(kind, at, end) {
        const { bytes } = this;
        this.#reader ??= new Reader(bytes);
        const begin = bytes.byteOffset - this.#reader.bytes.byteOffset;
        return kind.readFrom(this.#reader, begin + at + 2, begin + end, bytes[2]);
    }
}
