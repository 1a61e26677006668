// Finds the class of a field by its descriptor or its name.

import { MipError } from "./bytes.mjs";
import { Reader } from "./codec.mjs";
import { Field } from "./field.mjs";
import { RawField } from "./packet.mjs";

/** The number of constants that distinguish a layout. */
function constants(kind) {
    return kind.FITS?.[2].length ?? 0;
}

export class Registry {
    #found = new Map();
    #names = new Map();

    /** @param modules objects that have classes of fields among their properties */
    constructor(modules) {
        this.fields = modules.flatMap((one) => Object.values(one)).filter((one) => one?.prototype instanceof Field);
        for (const kind of this.fields) this.#names.set(kind.NAME, kind);
    }

    /** The class of a name of the specification, "sensor.scaled_accel"; undefined if there is none. */
    field(name) {
        return this.#names.get(name);
    }

    /** The classes that a descriptor may have in a packet of this set. */
    types(set, descriptor) {
        const key = set * 256 + descriptor;
        let found = this.#found.get(key);
        if (!found) {
            found = this.fields.filter((kind) => kind.DESCRIPTOR === descriptor && kind.occursIn(set));
            const own = found.filter((kind) => Array.isArray(kind.SETS)); // before those of every set
            found = own.length ? own : found;
            found.sort((a, b) => constants(b) - constants(a)); // the most specific layout first
            this.#found.set(key, found);
        }
        return found;
    }

    /** The class of these data of a field; undefined if there is none. */
    typeOf(set, descriptor, bytes, from = 0, to = bytes.length) {
        const found = this.types(set, descriptor);
        return found.length < 2 ? found[0] : found.find((kind) => kind.matches(bytes, from, to));
    }

    /**
     * The fields of a packet, decoded. One that is not known is a RawField, and so is one that cannot be decoded, with
     * the MipError as `error`; a wrong length ends the list.
     */
    decode(packet) {
        const { bytes, set } = packet;
        const reader = new Reader(bytes);
        const fields = [];
        packet.walk((at, end) => {
            const kind = this.typeOf(set, bytes[at + 1], bytes, at + 2, end);
            const raw = (error) => Object.assign(new RawField(set, bytes[at + 1], bytes.subarray(at + 2, end), at), error && { error });
            if (!kind) {
                fields.push(raw());
                return;
            }
            try {
                fields.push(kind.readFrom(reader, at + 2, end, set));
            } catch (error) {
                if (!(error instanceof MipError)) throw error;
                fields.push(raw(error));
            }
        });
        return fields;
    }
}
