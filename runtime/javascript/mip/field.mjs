// The base of all fields, and the functions that create their classes.

import { camel, MipError, bytesOf, isSame } from "./bytes.mjs";
import { encoded, isObject, Layout, Reader, refuseOther } from "./codec.mjs";
import { Packet } from "./packet.mjs";

export { validity } from "./validity.mjs";

/** The received data of fields that contain NaNs with unusual bits, which their values do not preserve. */
const received = /* @__PURE__ */ new WeakMap();

/** The layout of a class of fields. All have the same properties, so that the code that reads them stays fast. */
class FieldLayout extends Layout {
    /** @param blocks the blocks, or a function that reads the values of data that is long enough: see `codec.mjs` */
    constructor(kind, sets, descriptor, blocks, { optional, fits, calls }) {
        const straight = typeof blocks === "function" ? blocks : undefined;
        const values = straight ? {} : blocks;
        straight?.(values);
        super(values, calls ? 1 : optional);
        this.descriptor = descriptor;
        this.set = kind.SET;
        this.sets = sets;
        this.fits = fits;
        this.calls = calls;
        this.straight = straight;
        this.prototype = kind.prototype;
        this.prototypes = []; // by set, for objects that know it
    }

    occursIn(set) {
        return this.sets.includes(set);
    }

    matches(bytes, from, to) {
        if (!this.fits) return true;
        const [least, most, constants] = this.fits;
        const size = to - from;
        const agrees = ([at, wanted]) => wanted.every((byte, i) => at + i >= size || bytes[from + at + i] === byte);
        return least <= size && size <= most && constants.every(agrees);
    }

    /** Decodes the data from `from` to `to` in a packet of this set. */
    decode(reader, from, to, set) {
        this.prototypes[set] ??= set === this.set ? this.prototype : Object.create(this.prototype, { set: { value: set } });
        const field = Object.create(this.prototypes[set]); // much faster than the constructors of many classes
        reader.limit(from, to);
        if (this.straight && reader.end >= this.size && !reader.json) {
            this.straight(field, reader);
            reader.at = this.size;
        } else {
            this.read(reader, field, this.groups.length ? this.required(reader.bytes[from]) : undefined);
        }
        if (reader.unusual) received.set(field, reader.bytes.slice(from, to));
        return field;
    }

    /** Returns the number of values that a function selector requires, including itself; an unknown one requires no others. */
    required(selector) {
        return this.calls && 1 + (this.calls[selector] ?? 0);
    }
}

export class Field {
    constructor(values) {
        if (values === undefined) return;
        const { layout, NAME } = this.constructor;
        refuseOther(NAME, values, isObject(values), "an object");
        layout.refuseUnknown(values, NAME);
        for (const key of Object.keys(values)) if (values[key] !== undefined) this[key] = values[key];
    }

    static decode(data) {
        return this.decodeWithTrailing(data).field;
    }

    static decodeWithTrailing(data) {
        const reader = new Reader(bytesOf(data));
        const field = this.layout.decode(reader, 0, reader.end, this.SET);
        return { field, trailing: reader.left };
    }

    static occursIn(set) {
        return this.layout.occursIn(set);
    }

    static matches(data) {
        return this.layout.matches(data, 0, data.length);
    }

    get set() {
        return this.constructor.SET;
    }

    encode() {
        const { layout, NAME } = this.constructor;
        return encoded(layout, NAME, this, { received: received.get(this), required: layout.required(this.function) });
    }

    toJSON() {
        const reader = new Reader(this.encode(), { json: true });
        return { ...this.constructor.layout.decode(reader, 0, reader.end, this.set) };
    }

    static fromJSON(values) {
        return this.decode(new this(values).encode());
    }

    isValid(name, device, seen) {
        const { layout, NAME, VALID } = this.constructor;
        const [member] = name.split("[");
        layout.refuseUnknown({ [member]: 0 }, NAME);
        return VALID ? VALID(this, name, device, seen) : this[member] !== undefined;
    }

    packet(set = this.set) {
        return packetOf([this], set);
    }
}

export class Data extends Field {
    static ROLE = "data";
}

export class Response extends Field {
    static ROLE = "response";
}

export class Command extends Field {
    static ROLE = "command";
    static REPLIES = [];
    static SILENCED_BY = [];

    static get RESPONSES() {
        return this.REPLIES.flatMap(([, , layouts]) => layouts);
    }

    get answered() {
        const { SILENT } = this.constructor;
        if (!SILENT) return true;
        const [functions, when] = SILENT;
        return !functions.includes(Number(this.function)) && !(when.length > 0 && when.every((one) => holds(one, this)));
    }

    get replies() {
        const found = this.constructor.REPLIES.find(
            ([functions, when]) => (!functions || functions.includes(Number(this.function))) && when.every((one) => holds(one, this)),
        );
        return found ? found[2] : [];
    }
}

/** Does a member have this value? For a Boolean, everything except 0 is true. */
function holds([name, value, boolean], values) {
    const held = values[name];
    return boolean && held !== undefined ? Boolean(held) === Boolean(value) : isSame(held, value);
}

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
    Object.defineProperty(kind, "name", { value: camel(name.replace(/.*\./, "_")) });
    const one = typeof sets === "number";
    Object.assign(kind, { NAME: name, SET: one ? sets : undefined, SETS: one ? [sets] : sets, DESCRIPTOR: descriptor, ...more });
    kind.layout = new FieldLayout(kind, kind.SETS, descriptor, blocks, { optional, fits, calls });
    return kind;
}

/**
 * Creates the class of a field. `sets`: the number of its set, or all of them. `more.optional`: how many parameters are
 * always present, if others may follow. `more.fits`: the sizes and constants that distinguish its descriptor's layouts.
 */
export const data = (name, sets, descriptor, blocks, more = {}) => made(Data, name, sets, descriptor, blocks, more);
export const response = (name, sets, descriptor, blocks, more = {}) => made(Response, name, sets, descriptor, blocks, more);

/**
 * Creates the class of a command. `more.calls`: how many parameters each function requires, by its number. `more.REPLIES`:
 * functions, conditions and layouts of each response. `more.SILENT`: functions and conditions without an acknowledge.
 * `more.TIMEOUT`: seconds.
 */
export function command(name, set, descriptor, blocks, more = {}) {
    const kind = made(Command, name, set, descriptor, blocks, more);
    more.calls?.forEach((_, selector) => {
        const call = (values) => new kind({ function: selector, ...values });
        Object.defineProperty(kind, camel(blocks.function.nameOf(selector).toLowerCase()), { value: call });
    });
    return kind;
}
