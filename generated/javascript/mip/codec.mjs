// The building blocks of layouts: each reads and writes one kind of value. A layout is an object of names and blocks:
//
//     { port: u8, baud: u32, position: array(double, 3) }
//
// Values have two forms. Programs use members in camel case, Booleans, and arrays without counters. Tools use the `plain`
// form of mip.json: the specification's names, Booleans as numbers, counters, and NaNs with unusual bits as the text of
// their bits, "0x7fe5bf7f".

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
        this.exact = floatBits || json;
        this.limit(0, bytes.length);
    }

    /** Limits reading to the bytes from `from` to `to`. */
    limit(from, to) {
        this.from = this.at = from;
        this.end = to;
        this.nans = undefined;
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

    slice(size) {
        const at = this.take(size);
        return this.bytes.subarray(at, at + size);
    }

    /** Handles a NaN: JavaScript does not preserve its bits, so they are recorded. */
    exactly(number, at, size) {
        const bytes = this.bytes.subarray(at, at + size);
        if (this.floatBits || (this.json && !Object.is(JSON.parse(JSON.stringify(number)), number))) return floatBits(bytes);
        if (this.plain) return readFloat(bytes);
        if (typeof readFloat(bytes) === "string") {
            this.nans ??= new Map();
            this.nans.set(at - this.from, floatBits(bytes));
        }
        return number;
    }
}

class Writer {
    constructor(plain, nans) {
        this.plain = plain;
        this.nans = nans;
        this.bytes = [];
    }

    put(bytes) {
        for (const byte of bytes) this.bytes.push(byte);
    }
}

// ---------------------------------------------------------------------------------------------------- numbers

const integer = (size, signed, read) => ({
    size,
    read,
    write: (w, value, where) => w.put(writeInteger(value, size, signed, where)),
});

/** A block whose values are BigInts. JSON lacks them, so it contains decimal texts. */
const big = (size, signed, read, order = (bytes) => bytes) => ({
    size,
    big: true,
    read(r) {
        const value = read(r);
        return r.json ? String(value) : value;
    },
    write(w, value, where) {
        const number = typeof value === "string" && /^-?\d+$/.test(value) ? BigInt(value) : value;
        w.put(order(writeInteger(number, size, signed, where)));
    },
});

export const u8 = /* @__PURE__ */ integer(1, false, (r) => r.bytes[r.take(1)]);
export const u16 = /* @__PURE__ */ integer(2, false, (r) => r.view.getUint16(r.take(2)));
export const u32 = /* @__PURE__ */ integer(4, false, (r) => r.view.getUint32(r.take(4)));
export const u64 = /* @__PURE__ */ big(8, false, (r) => r.view.getBigUint64(r.take(8)));
export const s8 = /* @__PURE__ */ integer(1, true, (r) => r.view.getInt8(r.take(1)));
export const s16 = /* @__PURE__ */ integer(2, true, (r) => r.view.getInt16(r.take(2)));
export const s32 = /* @__PURE__ */ integer(4, true, (r) => r.view.getInt32(r.take(4)));
export const s64 = /* @__PURE__ */ big(8, true, (r) => r.view.getBigInt64(r.take(8)));
export const char = u8;

const floating = (size, get) => ({
    size,
    read(r) {
        const at = r.take(size);
        const number = get(r.view, at);
        return Number.isNaN(number) || r.exact ? r.exactly(number, at, size) : number;
    },
    write(w, value, where) {
        const noted = Number.isNaN(value) ? w.nans?.get(w.bytes.length) : undefined;
        w.put(writeFloat(noted?.length === 2 + 2 * size ? noted : value, size, where));
    },
});

export const float = /* @__PURE__ */ floating(4, (view, at) => view.getFloat32(at));
export const double = /* @__PURE__ */ floating(8, (view, at) => view.getFloat64(at));

/** A Boolean. Bytes other than 0 and 1 stay numbers. */
export const bool = {
    size: 1,
    read(r) {
        const byte = r.bytes[r.take(1)];
        return r.plain || byte > 1 ? byte : byte === 1;
    },
    write: (w, value, where) => w.put(writeInteger(typeof value === "boolean" ? Number(value) : value, 1, false, where)),
};

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
    const number = (r) => plain.read(r).reduceRight((sum, byte) => (sum << 8n) | BigInt(byte), 0n);
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
        this.size = fixed === undefined ? undefined : fixed * item.size;
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

/** Creates a block for a vector, or another array of fixed length. */
export const array = (item, count) => new Items(item, count, count);
/** Creates a block for an array whose length is the value of another parameter. */
export const counted = (counter, item, most) => new Items(item, undefined, most, countedBy(counter, item, most));
/** Creates a block for an array that fills the rest of the field. */
export const rest = (item, most) => new Items(item, undefined, most, following(item, most));

class Text extends Items {
    read(r, _, counts) {
        return readText(r.slice(this.count(r, counts)));
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
    const selected = (key, values) => found.find(([value]) => isSame(value, values[key]))?.[1];
    return {
        tag,
        read(r, values) {
            const inner = {};
            selected(r.plain ? tag : memberName(tag), values)?.read(r, inner);
            return inner;
        },
        write(w, value, where, values) {
            const key = w.plain ? tag : memberName(tag);
            const layout = selected(key, values);
            const [wanted] = layout?.keys(w) ?? [];
            refuseOther(where, value, isObject(value), "an object");
            const there = Object.keys(value).filter((name) => w.plain || value[name] !== undefined);
            if (there.length !== (layout ? 1 : 0) || there[0] !== wanted) {
                throw new MipError("tag", `${key} is ${values[key]}, so ${where} must hold ${wanted ?? "nothing"}`);
            }
            layout?.write(w, value, where);
        },
    };
};

// ---------------------------------------------------------------------------------------------------- layouts

/** Names that every object has; a member with such a name is suffixed with "_". */
const TAKEN = new Set(["constructor", "encode", "packet", "set", "answered", "replies", "isValid", "toJSON", "toString", "valueOf"]);

/** Converts a name to a member's name in programs: "gnss_1" to "gnss1", and "3d_fix" to "_3dFix". */
export function memberName(words) {
    const camel = words.replace(/_(.)/g, (both, next, at) => (/\d\d/.test(words[at - 1] + next) ? both : next.toUpperCase()));
    return /^\d/.test(camel) ? `_${camel}` : TAKEN.has(camel) ? `${camel}_` : camel;
}

/** Named values, one after another. */
export class Layout {
    /** @param blocks name -> block, in wire order; @param always the number of parameters that are always present */
    constructor(blocks, always) {
        this.names = Object.keys(blocks);
        this.members = this.names.map(memberName);
        this.blocks = Object.values(blocks);
        this.always = always ?? this.names.length;
        this.groups = groupsOf(this, this.always);
        this.simple = !this.blocks.some((one) => one.counts !== undefined || one.value !== undefined);
        const sizes = this.blocks.map((one) => one.size);
        this.size = sizes.includes(undefined) ? undefined : sizes.reduce((sum, size) => sum + size, 0);
    }

    /** Returns the names of the values in the form that a reader or writer uses. */
    keys(form) {
        return form.plain ? this.names : this.members;
    }

    read(r, values, required = this.always) {
        const counts = this.simple ? undefined : {};
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
        const keys = this.keys(r);
        const { blocks, names } = this;
        if (this.simple) {
            for (let i = first; i < last; i++) values[keys[i]] = blocks[i].read(r, values, counts);
            return;
        }
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
                values[keys[i]] = value;
            }
        }
    }

    /** Writes values. `within` is the path of the value that contains them, such as "segments[2]", for errors. */
    write(w, values, within = "", required = this.always) {
        this.refuseUnknown(values, within, w);
        const there = (i) => this.#isGiven(i, values, w);
        for (let i = 0; i < this.always; i++) this.#put(w, i, values, within);
        const keys = this.keys(w);
        let ended; // the first absent parameter: all after it must be absent, too
        for (const [first, last] of this.groups) {
            const members = range(first, last).filter((i) => this.blocks[i].value === undefined);
            const filled = last <= required || range(last, keys.length).some(there);
            const absent = members.find((i) => !there(i) && !(filled && this.#initial(i, w) !== undefined));
            if (absent !== undefined && last <= required) throw missing(keys[absent]);
            ended ??= absent;
            if (ended === undefined) {
                for (let i = first; i < last; i++) this.#put(w, i, values, within);
            } else if (members.some(there)) {
                throw missing(keys[ended]);
            }
        }
    }

    refuseUnknown(values, within, form) {
        const keys = this.keys(form);
        for (const name of Object.keys(values)) {
            const i = keys.indexOf(name);
            if (i < 0 || this.blocks[i].value !== undefined) {
                throw new MipError("unknown", `${within || "it"} has no parameter "${name}"`);
            }
        }
    }

    /** Is there a value? For a counter, its array may supply it. */
    #isGiven(i, values, w) {
        const given = (key) => Object.hasOwn(values, key) && (w.plain || values[key] !== undefined);
        const { counts } = this.blocks[i];
        return given(this.keys(w)[i]) || (counts !== undefined && given(this.keys(w)[this.names.indexOf(counts)]));
    }

    /** Returns the value to send if a program omits the parameter. */
    #initial(i, w) {
        return w.plain ? undefined : this.blocks[i].initial;
    }

    #put(w, i, values, within) {
        const block = this.blocks[i];
        const key = this.keys(w)[i];
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
            const array = this.keys(w)[this.names.indexOf(block.counts)];
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
        layout.write(w, value, where);
    },
});

/** Encodes a field's data with these values, in the shortest form that contains them. */
export function encoded(layout, name, values, { plain = false, nans, required } = {}) {
    refuseOther(name, values, isObject(values), "an object");
    const writer = new Writer(plain, nans);
    layout.refuseUnknown(values, name, writer);
    layout.write(writer, values, "", required);
    if (writer.bytes.length > MAX_FIELD_DATA) {
        throw new MipError("length", `${writer.bytes.length} bytes do not fit in a field, which holds ${MAX_FIELD_DATA}`);
    }
    return Uint8Array.from(writer.bytes);
}

export const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

const range = (first, last) => Array.from({ length: last - first }, (_, i) => first + i);

function refuseOther(where, value, right, wanted) {
    if (!right) throw new MipError("range", `${where}: ${described(value)} is not ${wanted}`);
}

function missing(name) {
    return new MipError("missing", `${name} is missing`);
}
