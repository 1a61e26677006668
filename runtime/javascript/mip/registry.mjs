// Finds the class of a field by its descriptor or its name.

import { MipError } from "./bytes.mjs";
import { Field } from "./field.mjs";

/** Returns the number of constants that distinguish a layout. */
function constants(kind) {
    return kind.layout.fits?.[2].length ?? 0;
}

export class Registry {
    #found = new Map();
    #names = new Map();

    /** @param modules objects with field classes among their properties */
    constructor(modules) {
        this.fields = modules.flatMap((one) => Object.values(one)).filter((one) => one?.prototype instanceof Field);
        for (const kind of this.fields) this.#names.set(kind.NAME, kind);
    }

    field(name) {
        return this.#names.get(name);
    }

    types(set, descriptor) {
        const key = set * 256 + descriptor;
        let found = this.#found.get(key);
        if (!found) {
            found = this.fields.filter((kind) => kind.DESCRIPTOR === descriptor && kind.occursIn(set));
            const own = found.filter((kind) => Array.isArray(kind.SETS)); // before fields of every set
            found = own.length ? own : found;
            found.sort((a, b) => constants(b) - constants(a)); // the most specific layout first
            this.#found.set(key, found);
        }
        return found;
    }

    typeOf(set, descriptor, bytes, from = 0, to = bytes.length) {
        const found = this.types(set, descriptor);
        return found.length < 2 ? found[0] : found.find(({ layout }) => layout.matches(bytes, from, to));
    }

    decode(packet) {
        const { reader, set } = packet;
        const { bytes } = reader;
        const fields = [];
        packet.walk((at, end) => {
            const kind = this.typeOf(set, bytes[at + 1], bytes, at + 2, end);
            try {
                fields.push(kind ? kind.layout.decode(reader, at + 2, end, set) : packet.raw(at, end));
            } catch (error) {
                if (!(error instanceof MipError)) throw error;
                fields.push(Object.assign(packet.raw(at, end), { error }));
            }
        });
        return fields;
    }
}
