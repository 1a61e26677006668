// The building blocks of layouts: each reads and writes one kind of value. A layout is an object of names and blocks:
//
//     { port: u8, baud: u32, position: array(double, 3) }
//
// Values have two forms. Programs use Booleans, and arrays without counters. Tools use the `plain` form of mip.json:
// Booleans as numbers, counters, and NaNs with unusual bits as the text of their bits, "0x7fe5bf7f".

import { MipError, described, floatBits, isList, isSame, readFloat, readText, writeFloat, writeInteger, writeText } from "./bytes.mjs";

/** The largest number of data bytes in a field. */
export const MAX_FIELD_DATA = 253;

// ---------------------------------------------------------------------------------------------------- bytes of a field

export class Reader {
    /**
     * @param options.plain use the form for tools; @param options.floatBits in that form, every float is the text of its bits
     * @param options.json values that JSON lacks are texts
     */
    constructor(bytes, { plain, floatBits, json } = {}) {
        this.bytes = bytes;
        this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
        this.plain = plain;
        this.floatBits = floatBits;
        this.json = json;
        this.exact = Boolean(floatBits || json);
        this.limit(0, bytes.length);
    }

    /** Limits reading to the bytes from `from` to `to`; all other offsets are relative to `from`. */
    limit(from, to) {
        this.from = from;
        this.at = 0;
        this.end = to - from;
        this.unusual = false; // was there a NaN with unusual bits, which JavaScript does not preserve?
    }

    get left() {
        return this.end - this.at;
    }

    /** Consumes the next `size` bytes, and returns their offset. */
    take(size) {
        const at = this.at;
        if (at + size > this.end) {
            const short = at + size - this.end;
            throw new MipError("truncated", `the data is ${short} byte${short > 1 ? "s" : ""} short`);
        }
        this.at = at + size;
        return at;
    }

    slice(at, size) {
        return this.bytes.subarray(this.from + at, this.from + at + size);
    }

    /** Handles a NaN, and in some forms other numbers. */
    exactly(number, at, size) {
        const bytes = this.slice(at, size);
        if (this.floatBits || (this.json && !Object.is(JSON.parse(JSON.stringify(number)), number))) return floatBits(bytes);
        const exact = readFloat(bytes);
        if (this.plain) return exact;
        this.unusual ||= typeof exact === "string";
        return number;
    }
}

class Writer {
    constructor(plain, received) {
        this.plain = plain;
        this.received = received;
        this.bytes = [];
    }

    put(bytes) {
        for (const byte of bytes) this.bytes.push(byte);
    }
}

// ---------------------------------------------------------------------------------------------------- numbers

// A block of a number is also a function that reads it at an offset, which the caller has checked. Without a reader, it
// returns the block itself: so a function that reads all numbers of a field also describes its layout.

const integer = (size, signed, readAt) =>
    Object.assign(readAt, {
        size,
        read: (r) => readAt(r, r.take(size)),
        write: (w, value, where) => w.put(writeInteger(value, size, signed, where)),
    });

/** A block whose values are BigInts. JSON lacks them, so it contains decimal texts. */
const big = (size, signed, readAt, order = (bytes) => bytes) =>
    Object.assign(readAt, {
        size,
        big: true,
        read(r) {
            const value = readAt(r, r.take(size));
            return r.json ? String(value) : value;
        },
        write(w, value, where) {
            const number = typeof value === "string" && /^-?\d+$/.test(value) ? BigInt(value) : value;
            w.put(order(writeInteger(number, size, signed, where)));
        },
    });

export const u8 = /* @__PURE__ */ integer(1, false, (r, at) => (r ? r.bytes[r.from + at] : u8));
export const u16 = /* @__PURE__ */ integer(2, false, (r, at) => (r ? r.view.getUint16(r.from + at) : u16));
export const u32 = /* @__PURE__ */ integer(4, false, (r, at) => (r ? r.view.getUint32(r.from + at) : u32));
export const u64 = /* @__PURE__ */ big(8, false, (r, at) => (r ? r.view.getBigUint64(r.from + at) : u64));
export const s8 = /* @__PURE__ */ integer(1, true, (r, at) => (r ? r.view.getInt8(r.from + at) : s8));
export const s16 = /* @__PURE__ */ integer(2, true, (r, at) => (r ? r.view.getInt16(r.from + at) : s16));
export const s32 = /* @__PURE__ */ integer(4, true, (r, at) => (r ? r.view.getInt32(r.from + at) : s32));
export const s64 = /* @__PURE__ */ big(8, true, (r, at) => (r ? r.view.getBigInt64(r.from + at) : s64));
export const char = u8;

const floating = (size, readAt) =>
    Object.assign(readAt, {
        size,
        read: (r) => readAt(r, r.take(size)),
        write(w, value, where) {
            const at = w.bytes.length;
            const received = Number.isNaN(value) ? w.received?.subarray(at, at + size) : undefined;
            const exact = received?.length === size ? readFloat(received) : value;
            w.put(writeFloat(typeof exact === "string" ? exact : value, size, where));
        },
    });

export const float = /* @__PURE__ */ floating(4, (r, at) => {
    if (!r) return float;
    const number = r.view.getFloat32(r.from + at);
    return Number.isNaN(number) || r.exact ? r.exactly(number, at, 4) : number;
});

export const double = /* @__PURE__ */ floating(8, (r, at) => {
    if (!r) return double;
    const number = r.view.getFloat64(r.from + at);
    return Number.isNaN(number) || r.exact ? r.exactly(number, at, 8) : number;
});

/** A Boolean. Bytes other than 0 and 1 stay numbers. */
export const bool = /* @__PURE__ */ Object.assign(
    (r, at) => {
        if (!r) return bool;
        const byte = r.bytes[r.from + at];
        return r.plain || byte > 1 ? byte : byte === 1;
    },
    {
        size: 1,
        read: (r) => bool(r, r.take(1)),
        write: (w, value, where) => w.put(writeInteger(typeof value === "boolean" ? Number(value) : value, 1, false, where)),
    },
);

// ---------------------------------------------------------------------------------------------------- named numbers

/** An object that reads and writes numbers with names. Its only enumerable properties are the names. */
class Names {
    constructor({ size, read, write }) {
        Object.defineProperties(this, { size: { value: size }, read: { value: read }, write: { value: write } });
    }
}

class Enumeration extends Names {
    constructor(of, values) {
        super(of);
        Object.assign(this, values);
    }

    nameOf(value) {
        return Object.keys(this).find((name) => isSame(this[name], value));
    }
}

/** Creates an open enumeration: its names are properties with their numbers. */
export const enumeration = (of, values) => new Enumeration(of, values);

class Bitfield extends Names {
    #bits;

    constructor(of, bits) {
        super(of);
        this.#bits = bits;
        const made = of.big ? BigInt : Number;
        for (const [name, [first, last]] of Object.entries(bits)) {
            this[name] = made(((1n << BigInt(last - first + 1)) - 1n) << BigInt(first));
        }
    }

    has(value, flag) {
        return (BigInt(value) & BigInt(flag)) !== 0n;
    }

    get(value, name) {
        const [first, last] = this.#bits[name];
        return Number((BigInt(value) >> BigInt(first)) & ((1n << BigInt(last - first + 1)) - 1n));
    }

    namesOf(value) {
        return Object.keys(this).filter((name) => this.#bits[name][0] === this.#bits[name][1] && this.has(value, this[name]));
    }
}

/** Creates a bitfield: its names are properties with their masks. `bits`: name -> first and last bit. */
export const bitfield = (of, bits) => new Bitfield(of, bits);

/** Creates a block for a bitfield in bytes, the least significant first: a BigInt, or in the plain form an array of bytes. */
export const octets = (size) => {
    const plain = array(u8, size);
    const number = (r, at) => r.slice(at, size).reduceRight((sum, byte) => (sum << 8n) | BigInt(byte), 0n);
    const whole = big(size, false, number, (bytes) => bytes.reverse());
    return {
        ...whole,
        read: (r) => (r.plain ? plain : whole).read(r),
        write: (w, ...of) => (w.plain ? plain : whole).write(w, ...of),
    };
};

// ---------------------------------------------------------------------------------------------------- several values

function checkCount(of, value, where) {
    if (value.length !== (of.fixed ?? value.length) || value.length > of.most) {
        const right = of.fixed ?? `at most ${of.most}`;
        throw new MipError("count", `${where} has ${value.length} elements, not ${right}`);
    }
}

class Items {
    /** @param count returns the number of items, which `fixed` is if it is always the same; at most `most` */
    constructor(item, fixed, most, count = () => fixed) {
        this.item = item;
        this.fixed = fixed;
        this.most = most;
        this.count = count;
        this.size = fixed * item.size; // NaN if it varies
    }

    read(r, _, counts) {
        const { item } = this;
        const count = this.fixed ?? this.count(r, counts);
        const items = [];
        for (let i = 0; i < count; i++) items.push(item.read(r));
        return items;
    }

    write(w, value, where) {
        refuseOther(where, value, isList(value), "an array");
        checkCount(this, value, where);
        for (const [i, item] of value.entries()) this.item.write(w, item, `${where}[${i}]`);
    }
}

/** The number of items is the value of another parameter. */
const countedBy =
    (counter, { size }, most) =>
    (r, counts) => {
        const count = Number(counts[counter]);
        if (count * size > r.left) throw new MipError("count", `${counter} is ${count}, but ${r.left} bytes follow`);
        if (count > most) throw new MipError("count", `${counter} is ${count}, but a field holds ${most}`);
        return count;
    };

/** As many items as follow. */
const following =
    ({ size }, most) =>
    (r) =>
        Math.min(Math.floor(r.left / size), most);

/** Creates a block for an array of fixed length. */
export const array = (item, count) => new Items(item, count, count);

/** Creates a block for a vector from a function that reads its numbers, as the blocks of numbers do. */
export const vector = (readAt) => {
    const [item, ...others] = readAt();
    const block = array(item, others.length + 1);
    return Object.assign((r, at) => (r ? readAt(r, at) : block), {
        size: block.size,
        read: (r) => block.read(r),
        write: (...of) => block.write(...of),
    });
};

/** Creates a block for an array whose length is the value of another parameter. */
export const counted = (counter, item, most) => new Items(item, undefined, most, countedBy(counter, item, most));
/** Creates a block for an array that fills the rest of the field. */
export const rest = (item, most) => new Items(item, undefined, most, following(item, most));

class Text extends Items {
    read(r, _, counts) {
        const size = this.count(r, counts);
        return readText(r.slice(r.take(size), size));
    }

    write(w, value, where) {
        refuseOther(where, value, typeof value === "string", "a text");
        const padded = value.padEnd(this.fixed ?? 0); // with spaces, as devices do
        checkCount(this, padded, where);
        w.put(writeText(padded, where));
    }
}

/** Creates a block for Latin-1 text: of fixed length, of the length in another parameter, or up to the end of the field. */
export const text = (count) => new Text(u8, count, count);
export const countedText = (counter, most) => new Text(u8, undefined, most, countedBy(counter, u8, most));
export const restText = (most) => new Text(u8, undefined, most, following(u8, most));

// ---------------------------------------------------------------------------------------------------- values that follow from others

/** Creates a block for the number of elements of an array, which only the plain form contains. */
export const counter = (of, counts) => ({ ...of, counts });

/** Creates a block for a constant, which is not part of the values. */
export const constant = (of, value) => ({ ...of, value });

/** Creates a block for a value that defaults to `initial`. */
export const reserved = (of, initial) => Object.create(of, { initial: { value: initial } });

/** Creates a block for a union: an object with one member or none, selected by another parameter. `cases`: value, name, block. */
export const union = (tag, cases) => {
    const found = cases.map(([value, name, of]) => [value, new Layout({ [name]: of })]);
    const selected = (values) => found.find(([value]) => isSame(value, values[tag]))?.[1];
    return {
        tag,
        read(r, values) {
            const inner = {};
            selected(values)?.read(r, inner);
            return inner;
        },
        write(w, value, where, values) {
            const layout = selected(values);
            const [wanted] = layout?.names ?? [];
            refuseOther(where, value, isObject(value), "an object");
            const there = Object.keys(value).filter((name) => w.plain || value[name] !== undefined);
            if (there.length !== (layout ? 1 : 0) || there[0] !== wanted) {
                throw new MipError("tag", `${tag} is ${values[tag]}, so ${where} must hold ${wanted ?? "nothing"}`);
            }
            layout?.write(w, value, where);
        },
    };
};

// ---------------------------------------------------------------------------------------------------- layouts

/** Named values, one after another. */
export class Layout {
    /** @param blocks name -> block, in wire order; @param always the number of parameters that are always present */
    constructor(blocks, always) {
        this.names = Object.keys(blocks);
        this.blocks = Object.values(blocks);
        this.always = always ?? this.names.length;
        this.groups = groupsOf(this, this.always);
        this.size = this.blocks.reduce((sum, { size }) => sum + size, 0); // NaN if it varies
    }

    read(r, values, required = this.always) {
        const counts = {};
        this.#span(r, values, counts, 0, this.always);
        for (const [first, last] of this.groups) {
            const optional = last > required;
            if (optional && r.left === 0) break;
            const before = r.at;
            const inner = Object.create(values); // a group is present as a whole or not at all
            try {
                this.#span(r, inner, counts, first, last);
            } catch (error) {
                if (!optional || error.kind !== "truncated") throw error;
                r.at = before;
                break;
            }
            if (optional && r.at === before) break; // an empty union is the same as an absent one
            Object.assign(values, inner);
        }
    }

    #span(r, values, counts, first, last) {
        const { blocks, names } = this;
        for (let i = first; i < last; i++) {
            const block = blocks[i];
            const value = block.read(r, values, counts);
            if (block.value !== undefined) {
                if (BigInt(value) !== BigInt(block.value)) {
                    throw new MipError("constant", `${names[i]} is ${value}, not ${block.value}`);
                }
            } else if (block.counts !== undefined) {
                counts[names[i]] = value;
                if (r.plain) values[names[i]] = value;
            } else {
                values[names[i]] = value;
            }
        }
    }

    /** Writes values. `within` is the path of the value that contains them, such as "segments[2]", for errors. */
    write(w, values, within = "", required = this.always) {
        const there = (i) => this.#isGiven(i, values, w);
        for (let i = 0; i < this.always; i++) this.#put(w, i, values, within);
        const { names } = this;
        let ended; // the first absent parameter: all after it must be absent, too
        for (const [first, last] of this.groups) {
            const members = range(first, last).filter((i) => this.blocks[i].value === undefined);
            const filled = last <= required || range(last, names.length).some(there);
            const absent = members.find((i) => !there(i) && !(filled && this.#initial(i, w) !== undefined));
            if (absent !== undefined && last <= required) throw missing(names[absent]);
            ended ??= absent;
            if (ended === undefined) {
                for (let i = first; i < last; i++) this.#put(w, i, values, within);
            } else if (members.some(there)) {
                throw missing(names[ended]);
            }
        }
    }

    refuseUnknown(values, within) {
        for (const name of Object.keys(values)) {
            const i = this.names.indexOf(name);
            if (i < 0 || this.blocks[i].value !== undefined) {
                throw new MipError("unknown", `${within} has no parameter "${name}"`);
            }
        }
    }

    /** Is there a value? For a counter, its array may supply it. */
    #isGiven(i, values, w) {
        const given = (key) => Object.hasOwn(values, key) && (w.plain || values[key] !== undefined);
        const { counts } = this.blocks[i];
        return given(this.names[i]) || (counts !== undefined && given(counts));
    }

    /** Returns the value to send if a program omits the parameter. */
    #initial(i, w) {
        return w.plain ? undefined : this.blocks[i].initial;
    }

    #put(w, i, values, within) {
        const block = this.blocks[i];
        const key = this.names[i];
        const where = within ? `${within}.${key}` : key;
        if (block.value !== undefined) {
            block.write(w, block.value, where);
        } else if (!this.#isGiven(i, values, w)) {
            const initial = this.#initial(i, w);
            if (initial === undefined) throw missing(where);
            block.write(w, initial, where);
        } else if (block.counts === undefined) {
            block.write(w, values[key], where, values);
        } else {
            const array = block.counts;
            const items = values[array];
            if (!Object.hasOwn(values, key)) {
                refuseOther(array, items, isList(items) || typeof items === "string", "an array");
                block.write(w, items.length, where);
                return;
            }
            block.write(w, values[key], where);
            if (items?.length !== Number(values[key])) {
                throw new MipError("count", `${where} is ${values[key]}, but ${array} has another number of elements`);
            }
        }
    }
}

/** Groups the parameters that may be absent, from `first` on: each by itself, but a counter with its array. */
function groupsOf({ names, blocks }, first) {
    const groups = [];
    const arrays = new Set();
    let begin = first;
    for (let i = first; i < blocks.length; i++) {
        arrays.delete(names[i]);
        if (names.includes(blocks[i].counts)) arrays.add(blocks[i].counts);
        if (arrays.size === 0) {
            groups.push([begin, i + 1]);
            begin = i + 1;
        }
    }
    return groups;
}

/** Creates a block for a structure inside a field. */
export const struct = (blocks) => structOf(new Layout(blocks));

export const structOf = (layout) => ({
    size: layout.size,
    read(r) {
        const values = {};
        layout.read(r, values);
        return values;
    },
    write(w, value, where) {
        refuseOther(where, value, isObject(value), "an object");
        layout.refuseUnknown(value, where);
        layout.write(w, value, where);
    },
});

/** Encodes a field's data with these values, in the shortest form that contains them. NaNs have the bits of the data `received`. */
export function encoded(layout, name, values, { plain = false, received, required } = {}) {
    refuseOther(name, values, isObject(values), "an object");
    const writer = new Writer(plain, received);
    layout.refuseUnknown(values, name);
    layout.write(writer, values, "", required);
    if (writer.bytes.length > MAX_FIELD_DATA) {
        throw new MipError("length", `${writer.bytes.length} bytes do not fit in a field, which holds ${MAX_FIELD_DATA}`);
    }
    return Uint8Array.from(writer.bytes);
}

export const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

const range = (first, last) => Array.from({ length: last - first }, (_, i) => first + i);

export function refuseOther(where, value, right, wanted) {
    if (!right) throw new MipError("range", `${where}: ${described(value)} is not ${wanted}`);
}

function missing(name) {
    return new MipError("missing", `${name} is missing`);
}
