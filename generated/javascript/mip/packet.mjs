// Packets: their frame, their fields, and building them.

import { MipError, bytesOf, checksum, concatenated, described, fromHex, sameBytes, toHex } from "./bytes.mjs";
import { decodeData, encodeData } from "./codec.mjs";
import { isSet, nameIn } from "./protocol.mjs";

const HEAD = 4;
const TAIL = 2;

/** Bytes that have the frame of a packet; the checksum may be wrong. */
export class Packet {
    constructor(protocol, bytes) {
        this.protocol = protocol;
        this.bytes = bytes;
    }

    /** A whole packet; anything else raises a MipError: "sync", "length" or "checksum". */
    static from(protocol, given) {
        const bytes = bytesOf(given);
        if (!sameBytes(bytes.subarray(0, 2), protocol.sync)) {
            throw new MipError("sync", `it does not begin with ${toHex(protocol.sync, " ")}`);
        }
        if (bytes.length < HEAD + TAIL || bytes.length !== bytes[3] + HEAD + TAIL || !isSet(bytes[2])) {
            throw new MipError("length", `its ${bytes.length} bytes are not a whole packet`);
        }
        const packet = new Packet(protocol, bytes);
        if (!packet.sound) {
            const [found, right] = [packet.checksum, packet.rightChecksum].map((two) => toHex(two, " "));
            throw new MipError("checksum", `its checksum is ${found}, but should be ${right}`);
        }
        return packet;
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

    /** What the checksum must be. */
    get rightChecksum() {
        return checksum(this.bytes.subarray(0, -TAIL));
    }

    /** Is the checksum right? */
    get sound() {
        return sameBytes(this.checksum, this.rightChecksum);
    }

    /** The fields: descriptor, data, and offset in the packet. A wrong length raises a MipError behind those before it. */
    *fields() {
        const payload = this.payload;
        for (let at = 0; at < payload.length; at += payload[at]) {
            const length = payload[at];
            if (length < 2 || at + length > payload.length) {
                throw new MipError("field_length", `a field of length ${length} in ${payload.length - at} bytes`);
            }
            yield { descriptor: payload[at + 1], data: payload.subarray(at + 2, at + length), offset: HEAD + at };
        }
    }

    /**
     * The fields with their values. What cannot be decoded has an error in place of values, and what the protocol does not
     * know has neither; a wrong length is the last entry. `options` are those of decodeData.
     */
    decode(options = {}) {
        const decoded = [];
        try {
            for (const raw of this.fields()) decoded.push({ ...raw, ...decodeField(this.protocol, this.set, raw, options) });
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            decoded.push({ error });
        }
        return decoded;
    }
}

function decodeField(protocol, set, { descriptor, data }, options) {
    const field = protocol.choose(set, descriptor, data);
    if (!field) return {};
    try {
        return { field, ...decodeData(protocol, field, data, options) };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { field, error };
    }
}

/**
 * A packet of a set with these fields: each has a `descriptor`, and either `raw` (bytes or hexadecimal digits) or `name`
 * and `values`; a counter that is left out counts its array. Raises a MipError if something does not fit.
 */
export function buildPacket(protocol, set, fields) {
    if (!isSet(set)) throw new MipError("set", `no packet has descriptor set ${described(set)}`);
    if (!Array.isArray(fields)) throw new MipError("fields", `${described(fields)} is not an array of fields`);
    const parts = fields.flatMap((entry) => {
        if (typeof entry !== "object" || entry === null)
            throw new MipError("fields", `${described(entry)} is not a field with a descriptor`);
        if (!(Number.isInteger(entry.descriptor) && entry.descriptor >= 0 && entry.descriptor < 256)) {
            throw new MipError("descriptor", `no field has descriptor ${described(entry.descriptor)}`);
        }
        const data = entry.raw === undefined ? dataOf(protocol, set, entry) : rawOf(entry.raw);
        if (data.length > protocol.maxFieldData) {
            throw new MipError("length", `a field holds at most ${protocol.maxFieldData} bytes of data`);
        }
        return [Uint8Array.of(data.length + 2, entry.descriptor), data];
    });
    const payload = concatenated(...parts);
    if (payload.length > protocol.maxPayload) {
        throw new MipError("length", `the fields have ${payload.length} bytes; a packet holds ${protocol.maxPayload}`);
    }
    const head = concatenated(Uint8Array.of(...protocol.sync, set, payload.length), payload);
    return new Packet(protocol, concatenated(head, checksum(head)));
}

function dataOf(protocol, set, { descriptor, name, values }) {
    const field = protocol.candidates(set, descriptor).find((one) => nameIn(one, set) === name);
    if (!field) throw new MipError("unknown", `set ${set} has no field ${described(name)} with descriptor ${descriptor}`);
    return encodeData(protocol, field, values);
}

function rawOf(raw) {
    return typeof raw === "string" ? fromHex(raw) : bytesOf(raw);
}
