// The base of all fields, and the functions that create their classes.

import { MipError, bytesOf, isSame } from "./bytes.mjs";
import { encoded, Layout, memberName, Reader } from "./codec.mjs";
import { Packet } from "./packet.mjs";

export { validity } from "./validity.mjs";

export class Field {
    // Besides its values: the `set` of its packet, and `nans` with unusual bits, by their offset. Most objects have neither.
    #origin;

    constructor(values) {
        if (values === undefined) return;
        const { layout, NAME } = this.constructor;
        if (typeof values !== "object" || values === null) throw new MipError("range", `${NAME} needs an object of values`);
        layout.refuseUnknown(values, NAME, {});
        for (const key of Object.keys(values)) if (values[key] !== undefined) this[key] = values[key];
    }

    /** Decodes a field's data; bytes left over are not an error. Throws a MipError. */
    static decode(data) {
        return this.decodeWithTrailing(data).field;
    }

    /** Like `decode`, but also returns the number of bytes left over, which newer devices may send. */
    static decodeWithTrailing(data) {
        const reader = new Reader(bytesOf(data));
        const field = this.readFrom(reader);
        return { field, trailing: reader.left };
    }

    /** Decodes the data from `from` to `to` in a packet. */
    static readFrom(reader, from = 0, to = reader.bytes.length, set = undefined) {
        reader.limit(from, to);
        const field = new this();
        const { layout } = this;
        layout.read(reader, field, layout.groups.length ? requiredWith(this, reader.bytes[from]) : undefined);
        const { nans } = reader;
        if ((set ?? this.SET) !== this.SET || nans) field.#origin = { set, nans };
        return field;
    }

    static occursIn(set) {
        return this.SETS.includes(set);
    }

    /** Can this be the field's data? Checks what distinguishes a descriptor's layouts: constants and size. */
    static matches(bytes, from = 0, to = bytes.length) {
        if (!this.FITS) return true;
        const [least, most, constants] = this.FITS;
        const size = to - from;
        const agrees = ([at, wanted]) => wanted.every((byte, i) => at + i >= size || bytes[from + at + i] === byte);
        return least <= size && size <= most && constants.every(agrees);
    }

    /** The set of the packet that contained it, or the only set in which it occurs; undefined if unknown. */
    get set() {
        return this.#origin?.set ?? this.constructor.SET;
    }

    /** Encodes the field's data, without length and descriptor. Throws a MipError. */
    encode() {
        const { layout, NAME } = this.constructor;
        const required = requiredWith(this.constructor, this.function);
        return encoded(layout, NAME, this, { nans: this.#origin?.nans, required });
    }

    /**
     * Returns its values as JSON can contain them: an integer of more than four bytes as a decimal text, a float that JSON
     * lacks, such as a NaN, as the text of its bits, "0x7fc00000". Throws a MipError if it cannot be encoded.
     */
    toJSON() {
        return { ...this.constructor.readFrom(new Reader(this.encode(), { json: true })) };
    }

    /** Makes a field from what `toJSON` returned. Throws a MipError. */
    static fromJSON(values) {
        return this.decode(new this(values).encode());
    }

    /**
     * Is a value valid, as its flags say? One without flags is, unless it is absent.
     *
     * @param name the member, or an element: "velocity[0]"
     * @param device the id of the device, on which the flags may depend; if it is undefined, they are recognized by the bits
     *   that are set
     */
    isValid(name, device, seen) {
        const { layout, NAME, VALID } = this.constructor;
        const [member] = name.split("[");
        layout.refuseUnknown({ [member]: 0 }, NAME, {});
        return VALID ? VALID(this, name, device, seen) : this[member] !== undefined;
    }

    /** Makes a packet with only this field, in the set that contained it or in `set`. Throws a MipError. */
    packet(set = this.set) {
        return packetOf([this], set);
    }
}

/** Returns the number of values that a function selector requires, including itself; an unknown one requires no others. */
function requiredWith({ REQUIRED }, selector) {
    return REQUIRED && 1 + (REQUIRED[selector] ?? 0);
}

/** A field that a device sends as data. */
export class Data extends Field {
    static ROLE = "data";
}

/** A field with which the device answers a command, after the acknowledge. */
export class Response extends Field {
    static ROLE = "response";
}

/** A field that the device acknowledges, with or without a response. */
export class Command extends Field {
    static ROLE = "command";
    static REPLIES = [];
    static SILENCED_BY = [];

    /** The types of its responses. */
    static get RESPONSES() {
        return this.REPLIES.flatMap(([, , layouts]) => layouts);
    }

    /** Does the device acknowledge the command with these values? */
    get answered() {
        const { SILENT } = this.constructor;
        if (!SILENT) return true;
        const [functions, when] = SILENT;
        return !functions.includes(Number(this.function)) && !(when.length > 0 && when.every((one) => holds(one, this)));
    }

    /** The types of the response that it requests with these values; layouts may differ by device. */
    get replies() {
        const found = this.constructor.REPLIES.find(
            ([functions, when]) => (!functions || functions.includes(Number(this.function))) && when.every((one) => holds(one, this)),
        );
        return found ? found[2] : [];
    }
}

/** Does a member have this value? For a Boolean, everything except 0 is true. */
function holds([name, value, boolean], values) {
    const held = values[memberName(name)];
    return boolean && held !== undefined ? Boolean(held) === Boolean(value) : isSame(held, value);
}

/** Makes a packet with these fields. Each must occur in the set, which may be omitted if one of them occurs in no other. */
export function packetOf(fields, set = fields.find((one) => one.set !== undefined)?.set) {
    const parts = fields.map((field) => {
        const { NAME, DESCRIPTOR } = field.constructor;
        if (set === undefined) throw new MipError("set", `${NAME} belongs to packets of several sets; pass one of them`);
        if (!field.constructor.occursIn(set)) throw new MipError("set", `${NAME} does not occur in packets of set ${set}`);
        return { descriptor: DESCRIPTOR, data: field.encode() };
    });
    return Packet.build(set, parts);
}

// ---------------------------------------------------------------------------------------------------- creation of classes

/** Returns the sets from `first` to `last`. */
export const every = (first, last) => ({ includes: (set) => first <= set && set <= last });

function made(Base, name, sets, descriptor, blocks, { optional, fits, calls, ...more }) {
    const kind = class extends Base {};
    const words = name.slice(name.indexOf(".") + 1);
    Object.defineProperty(kind, "name", { value: words.replace(/(?:^|_)(.)/g, (_, next) => next.toUpperCase()) });
    const one = typeof sets === "number";
    Object.assign(kind, {
        NAME: name,
        SET: one ? sets : undefined,
        SETS: one ? [sets] : sets,
        DESCRIPTOR: descriptor,
        FITS: fits,
        layout: new Layout(blocks, calls ? 1 : optional),
        ...more,
    });
    if (calls) {
        kind.REQUIRED = calls;
        for (const selector of Object.keys(calls).map(Number)) {
            const call = (values) => new kind({ function: selector, ...values });
            Object.defineProperty(kind, memberName(blocks.function.nameOf(selector).toLowerCase()), { value: call });
        }
    }
    return kind;
}

/**
 * Creates the class of a field. `sets`: the number of its set, or all of them. `more.optional`: how many parameters are
 * always present, if others may follow. `more.fits`: the sizes and constants that distinguish its descriptor's layouts.
 */
export const data = (name, sets, descriptor, blocks, more = {}) => made(Data, name, sets, descriptor, blocks, more);
export const response = (name, sets, descriptor, blocks, more = {}) => made(Response, name, sets, descriptor, blocks, more);

/**
 * Creates the class of a command. `more.calls`: number of a function -> how many parameters it requires. `more.REPLIES`:
 * functions, conditions and layouts of each response. `more.SILENT`: functions and conditions without an acknowledge.
 * `more.TIMEOUT`: seconds.
 */
export const command = (name, set, descriptor, blocks, more = {}) => made(Command, name, set, descriptor, blocks, more);
