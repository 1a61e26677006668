// The modules of mip/ and tools/ as one script, for pages that are opened from disk, where browsers do not load modules.
// It defines one global object, `mip`, with the exports of their files index.mjs.
(() => {
"use strict";
const modules = {};

// ---------------------------------------------------------------------------------------------------- mip/bytes.mjs

modules["mip/bytes"] = (() => {
// Bytes: hexadecimal text, the checksum, and big-endian numbers.

/** What is wrong, in words; `kind` is one word for programs: "truncated", "count", "range", … */
class MipError extends Error {
    constructor(kind, message) {
        super(message);
        this.name = "MipError";
        this.kind = kind;
    }
}

/** The two bytes that end a packet, of all bytes before them. */
function checksum(bytes) {
    let a = 0;
    let b = 0;
    for (const byte of bytesOf(bytes)) {
        a = (a + byte) & 0xff;
        b = (b + a) & 0xff;
    }
    return Uint8Array.of(a, b);
}

/** "7565", or with a separator "75 65". */
function toHex(bytes, between = "") {
    return Array.from(bytesOf(bytes), (byte) => byte.toString(16).padStart(2, "0")).join(between);
}

/** The bytes of hexadecimal digits without anything between them. */
function fromHex(text) {
    if (typeof text !== "string" || !/^([0-9a-f]{2})*$/i.test(text))
        throw new MipError("hex", "the text is not an even number of hexadecimal digits");
    return Uint8Array.from(text.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16));
}

// What a value is, whatever it says of itself: the name of a typed array, also of another window, or undefined.
const typedArray = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(Uint8Array.prototype), Symbol.toStringTag).get;
const bufferSize = Object.getOwnPropertyDescriptor(ArrayBuffer.prototype, "byteLength").get;

/** The bytes of a Uint8Array or an ArrayBuffer, also one of another window; nothing else is taken for bytes. */
function bytesOf(value) {
    if (typedArray.call(value) === "Uint8Array") return value;
    try {
        bufferSize.call(value); // a TypeError for all else
    } catch {
        throw new MipError("bytes", `${described(value)} is not a Uint8Array or an ArrayBuffer`);
    }
    return new Uint8Array(value);
}

/** Is a value an array or a typed array? */
function isList(value) {
    return Array.isArray(value) || typedArray.call(value) !== undefined;
}

function concatenated(...parts) {
    const whole = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
    let at = 0;
    for (const part of parts) {
        whole.set(part, at);
        at += part.length;
    }
    return whole;
}

function sameBytes(a, b) {
    return a.length === b.length && a.every((byte, i) => byte === b[i]);
}

/** An unsigned or signed number; of eight bytes a BigInt. */
function readInteger(bytes, signed) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    switch (bytes.length) {
        case 1:
            return signed ? view.getInt8(0) : view.getUint8(0);
        case 2:
            return signed ? view.getInt16(0) : view.getUint16(0);
        case 4:
            return signed ? view.getInt32(0) : view.getUint32(0);
        default:
            return signed ? view.getBigInt64(0) : view.getBigUint64(0);
    }
}

/** What a value is, for errors: also what cannot be made a text. */
function described(value) {
    if (typeof value === "string") return JSON.stringify(value);
    if (Array.isArray(value)) return "an array";
    return typeof value === "object" && value !== null ? "an object" : String(value);
}

/** The bytes of a whole number or a BigInt. Nothing else is taken for a number. */
function writeInteger(value, size, signed, what) {
    if (typeof value !== "bigint" && !Number.isInteger(value))
        throw new MipError("range", `${what}: ${described(value)} is not a whole number`);
    let number = BigInt(value);
    const width = BigInt(8 * size);
    const least = signed ? -(1n << (width - 1n)) : 0n;
    if (number < least || number >= least + (1n << width)) {
        throw new MipError("range", `${what}: ${value} does not fit in ${size} byte${size > 1 ? "s" : ""}`);
    }
    const bytes = new Uint8Array(size);
    for (let i = size - 1; i >= 0; i--) {
        bytes[i] = Number(number & 0xffn);
        number >>= 8n;
    }
    return bytes;
}

/**
 * The number of a float. A NaN with other bits than the usual one is the text of its bits, "0x7fe5bf7f", because numbers
 * of JavaScript do not keep them.
 */
function readFloat(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const number = bytes.length === 4 ? view.getFloat32(0) : view.getFloat64(0);
    return Number.isNaN(number) && !sameBytes(bytes, writeFloat(NaN, bytes.length)) ? floatBits(bytes) : number;
}

/** The text of the bits of a float: "0x3e7a63a0". */
function floatBits(bytes) {
    return `0x${toHex(bytes)}`;
}

/** The bytes of a number, or of the text of its bits. */
function writeFloat(value, size, what) {
    if (typeof value === "string") {
        if (!/^0x[0-9a-f]+$/i.test(value) || value.length !== 2 + 2 * size) {
            throw new MipError("range", `${what}: ${described(value)} is neither a number nor 0x and ${2 * size} hexadecimal digits`);
        }
        return fromHex(value.slice(2));
    }
    if (typeof value !== "number") throw new MipError("range", `${what}: ${described(value)} is not a number`);
    if (size === 4 && Number.isFinite(value) && !Number.isFinite(Math.fround(value))) {
        throw new MipError("range", `${what}: ${value} does not fit in a float of 4 bytes`);
    }
    const view = new DataView(new ArrayBuffer(size));
    if (Number.isNaN(value)) {
        view.setUint16(0, size === 4 ? 0x7fc0 : 0x7ff8);
    } else if (size === 4) {
        view.setFloat32(0, value);
    } else {
        view.setFloat64(0, value);
    }
    return new Uint8Array(view.buffer);
}

/** Characters of Latin-1, one for each byte. */
function readText(bytes) {
    return Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
}

function writeText(text, what) {
    if (typeof text !== "string") throw new MipError("range", `${what}: ${described(text)} is not a text`);
    return Uint8Array.from(text, (character) => {
        const code = character.codePointAt(0);
        if (code > 0xff) {
            const shown = /[\ud800-\udfff]/u.test(character) ? "half of a character" : `"${character}"`;
            throw new MipError("range", `${what}: ${shown} (U+${code.toString(16).toUpperCase()}) is not a character of Latin-1`);
        }
        return code;
    });
}

return { MipError, checksum, toHex, fromHex, bytesOf, isList, concatenated, sameBytes, readInteger, described, writeInteger, readFloat, floatBits, writeFloat, readText, writeText };
})();

// ---------------------------------------------------------------------------------------------------- mip/protocol.mjs

modules["mip/protocol"] = (() => {
// The model of the protocol: what is in mip.json, found by name and by descriptor.

const { MipError, bytesOf, described } = modules["mip/bytes"];

/** Descriptor set of the fields that are valid in every data set. */
const SHARED_SET = 255;

/** Data sets have this number or a larger one; below are command sets. */
const FIRST_DATA_SET = 128;

/** The first number of the form of mip.json that this code knows. */
const FORMAT = "1";

class Protocol {
    /** @param model the parsed mip.json */
    constructor(model) {
        const format = model?.format;
        if (typeof format !== "string" || format.split(".")[0] !== FORMAT) {
            throw new MipError("format", `the model has format ${described(format)}; this code knows ${FORMAT}`);
        }
        for (const part of ["packet", "scalars", "fields", "types", "sets", "functions", "acknowledge"]) {
            if (!model[part]) throw new MipError("format", `the model has no "${part}"`);
        }
        this.model = model;
        this.sync = Uint8Array.from(model.packet.sync);
        this.maxPayload = model.packet.max_payload;
        this.maxFieldData = model.packet.max_field_data;
        this.fields = byKey(model.fields, "name");
        this.types = byKey(model.types, "name");
        this.sets = byKey(model.sets, "number");
        this.functions = byKey(model.functions, "value");
        this.acknowledge = this.field(model.acknowledge);
        this.layouts = new Map();
        for (const field of model.fields) {
            const key = field.set * 256 + field.descriptor;
            this.layouts.set(key, [...(this.layouts.get(key) ?? []), field]);
        }
    }

    /** A field by its name, "3dm.pps_source_control". */
    field(name) {
        return found(this.fields, name, "field");
    }

    /** A type by its name: an enumeration, a bitfield, a vector or a structure. */
    type(name) {
        return found(this.types, name, "type");
    }

    scalar(name) {
        return this.model.scalars[name];
    }

    /** The layouts that a descriptor may have in a packet of this set. */
    candidates(set, descriptor) {
        if (set < FIRST_DATA_SET && descriptor === this.acknowledge.descriptor) return [this.acknowledge];
        const own = this.layouts.get(set * 256 + descriptor);
        const shared = set >= FIRST_DATA_SET ? this.layouts.get(SHARED_SET * 256 + descriptor) : undefined;
        return own ?? shared ?? [];
    }

    /** The layout of these data: by constants, as far as the data reach, then by size. Undefined if there is none. */
    choose(set, descriptor, given) {
        const data = bytesOf(given);
        const layouts = this.candidates(set, descriptor);
        if (layouts.length < 2) return layouts[0];
        const fitting = layouts.filter((field) => (field.constants ?? []).every((constant) => agrees(constant, data)));
        const held = fitting.filter((field) => field.min_size <= data.length);
        const best = (fields, better) => fields.reduce((a, b) => (better(b.min_size, a.min_size) ? b : a), fields[0]);
        return held.length ? best(held, (a, b) => a > b) : best(fitting, (a, b) => a < b);
    }

    /** How many parameters must be there, the function selector not counted; an unknown function requires none. */
    required(field, selector) {
        if (!field.calls) return field.parameters.filter((parameter) => !parameter.optional).length;
        const name = this.functions.get(Number(selector))?.name;
        return field.calls.find((call) => call.function === name)?.required.length ?? 0;
    }
}

function byKey(things, key) {
    return new Map(things.map((thing) => [thing[key], thing]));
}

function found(things, name, what) {
    const thing = things.get(name);
    if (!thing) throw new MipError("unknown", `there is no ${what} ${described(name)}`);
    return thing;
}

function agrees(constant, data) {
    for (let i = 0; i < constant.size && constant.offset + i < data.length; i++) {
        const byte = Number((BigInt(constant.value) >> BigInt(8 * (constant.size - 1 - i))) & 0xffn);
        if (data[constant.offset + i] !== byte) return false;
    }
    return true;
}

return { SHARED_SET, FIRST_DATA_SET, FORMAT, Protocol };
})();

// ---------------------------------------------------------------------------------------------------- mip/codec.mjs

modules["mip/codec"] = (() => {
// Decodes and encodes the data of a field by the operations of its layout.
//
// Values: integers, enumerations, bitfields and bools are numbers, of eight bytes BigInts; floats are numbers, except for
// unusual NaNs (see readFloat); text is a string with one character for each byte; a bitfield of bytes is an array of
// them; arrays are arrays, structures objects, and a union is an object with one member or none.

const { MipError, bytesOf, concatenated, described, floatBits, isList, readFloat, readInteger, readText, writeFloat, writeInteger, writeText } = modules["mip/bytes"];

/**
 * The values of a field, how many bytes are left over, and `parts`: each value that is not divided further, in wire order,
 * with its path (names and indices), its operation, and where its bytes are in the data (offset and size).
 *
 * @param options.floatBits every float is the text of its bits, "0x3e7a63a0"
 */
function decodeData(protocol, field, given, options = {}) {
    refuseOtherField(field);
    const data = bytesOf(given);
    const reader = new Reader(protocol, data, options);
    const values = {};
    let required = protocol.required(field);
    for (const op of field.operations) {
        if (op.kind !== "group") {
            reader.read(op, values, []);
            continue;
        }
        if (op.first === 1 && field.calls) required = protocol.required(field, values.function);
        if (!reader.readGroup(op, op.last <= required, values)) break;
    }
    return { values, trailing: data.length - reader.at, parts: reader.parts };
}

class Reader {
    constructor(protocol, data, options) {
        this.protocol = protocol;
        this.data = data;
        this.options = options;
        this.at = 0;
        this.parts = [];
    }

    get left() {
        return this.data.length - this.at;
    }

    take(size) {
        if (size > this.left) {
            const short = size - this.left;
            throw new MipError("truncated", `the data is ${short} byte${short > 1 ? "s" : ""} short`);
        }
        this.at += size;
        return this.data.subarray(this.at - size, this.at);
    }

    readGroup(group, required, values) {
        if (!required && this.left === 0) return false;
        const before = this.at;
        const parts = this.parts.length;
        const inner = { ...values };
        const absent = () => {
            this.at = before;
            this.parts.length = parts;
            return false;
        };
        try {
            for (const op of group.body) this.read(op, inner, []);
        } catch (error) {
            if (required || error.kind !== "truncated") throw error;
            return absent();
        }
        if (!required && this.at === before) return absent(); // an empty union: the same as no union
        Object.assign(values, inner);
        return true;
    }

    read(op, values, path) {
        if (op.kind === "constant") {
            const value = this.number(op, [...path, op.member]);
            if (BigInt(value) !== BigInt(op.value)) {
                throw new MipError("constant", `${op.member} is ${value}, not ${op.value}`);
            }
        } else {
            values[op.member] = this.item(op, values, [...path, op.member]);
        }
    }

    item(op, values, path) {
        switch (op.kind) {
            case "scalar":
            case "counter":
                return this.number(op, path);
            case "bits":
                return this.leaf(op, path, op.size, (bytes) => Array.from(bytes));
            case "text":
                return this.leaf(op, path, this.count(op, 1, values), readText);
            case "array": {
                const count = this.count(op, sizeOf(this.protocol, op.item), values);
                return Array.from({ length: count }, (_, i) => this.item(op.item, {}, [...path, i]));
            }
            case "struct": {
                const inner = {};
                for (const part of this.protocol.type(op.struct).operations) this.read(part, inner, path);
                return inner;
            }
            case "switch": {
                const inner = {};
                const selected = selectedBy(op, values);
                if (selected) this.read(selected, inner, path);
                return inner;
            }
        }
        throw new MipError("format", `the operation "${op.kind}" is not known`);
    }

    number(op, path) {
        const { size, kind } = this.protocol.scalar(op.scalar);
        if (kind !== "float") return this.leaf(op, path, size, (bytes) => readInteger(bytes, kind === "signed"));
        return this.leaf(op, path, size, this.options.floatBits ? floatBits : readFloat);
    }

    leaf(operation, path, size, read) {
        const offset = this.at;
        const value = read(this.take(size));
        this.parts.push({ path, operation, value, offset, size });
        return value;
    }

    count(op, size, values) {
        if (op.count !== undefined) return op.count;
        if (op.counter === undefined) return Math.min(Math.floor(this.left / size), op.capacity);
        const count = Number(values[op.counter]);
        if (count * size > this.left) {
            throw new MipError("count", `${op.counter} is ${count}, but ${this.left} bytes follow`);
        }
        if (count > op.capacity) throw new MipError("count", `${op.counter} is ${count}, but a field holds ${op.capacity}`);
        return count;
    }
}

/** The bytes of one item of an array, which are always the same number. */
function sizeOf(protocol, op) {
    switch (op.kind) {
        case "bits":
            return op.size;
        case "struct":
            return protocol.type(op.struct).max_size;
        case "array":
            return op.count * sizeOf(protocol, op.item);
        case "text":
            return op.count;
        default:
            return protocol.scalar(op.scalar).size;
    }
}

function selectedBy(op, values) {
    return op.cases.find((one) => one.value === Number(values[op.tag]))?.operation;
}

// ---------------------------------------------------------------------------------------------------- encoding

/** The data of a field with these values, in the shortest form that holds them. Counters may be left out. */
function encodeData(protocol, field, values) {
    refuseOtherField(field);
    const writer = new Writer(protocol);
    refuseOther(field.name, values, isObject(values), "an object");
    refuseUnknown(values, field.parameters, field.name);
    let required = protocol.required(field);
    let ended; // the first parameter that was left out: all behind it must be, too
    for (const op of field.operations) {
        if (op.kind !== "group") {
            writer.write(op, values);
            continue;
        }
        if (op.first === 1 && field.calls) required = protocol.required(field, values.function);
        const members = op.body.filter((inner) => inner.kind !== "constant");
        const absent = members.find((inner) => !isGiven(inner, values))?.member;
        if (absent !== undefined && op.last <= required) throw missing(absent);
        ended ??= absent;
        if (ended === undefined) {
            for (const inner of op.body) writer.write(inner, values);
        } else if (members.some((inner) => isGiven(inner, values))) {
            throw missing(ended);
        }
    }
    const data = concatenated(...writer.parts);
    if (data.length > protocol.maxFieldData) {
        throw new MipError("length", `${data.length} bytes do not fit in a field, which holds ${protocol.maxFieldData}`);
    }
    return data;
}

class Writer {
    constructor(protocol) {
        this.protocol = protocol;
        this.parts = [];
    }

    /** `within` names the value that contains it, "segments[2]": errors say where they are. */
    write(op, values, within = "") {
        const where = within ? `${within}.${op.member}` : op.member;
        if (op.kind === "constant") {
            this.number(op, op.value, where);
        } else if (Object.hasOwn(values, op.member)) {
            this.put(op, values[op.member], values, where);
        } else if (isGiven(op, values)) {
            const counted = values[op.array];
            refuseOther(op.array, counted, isList(counted) || typeof counted === "string", "an array");
            this.number(op, counted.length, where);
        } else {
            throw missing(where);
        }
    }

    put(op, value, values, where) {
        switch (op.kind) {
            case "scalar":
                this.number(op, value, where);
                break;
            case "counter":
                this.number(op, value, where);
                if (values[op.array]?.length !== Number(value)) {
                    throw new MipError("count", `${where} is ${value}, but ${op.array} has another number of elements`);
                }
                break;
            case "bits":
                refuseOther(where, value, isList(value), "an array");
                if (value.length !== op.size) throw new MipError("count", `${where} needs ${op.size} bytes`);
                for (const [i, byte] of value.entries()) this.parts.push(writeInteger(byte, 1, false, `${where}[${i}]`));
                break;
            case "text":
                refuseOther(where, value, typeof value === "string", "a text");
                checkCount(op, value, where);
                this.parts.push(writeText(value, where));
                break;
            case "array":
                refuseOther(where, value, isList(value), "an array");
                checkCount(op, value, where);
                for (const [i, item] of value.entries()) this.put(op.item, item, {}, `${where}[${i}]`);
                break;
            case "struct": {
                const struct = this.protocol.type(op.struct);
                refuseOther(where, value, isObject(value), "an object");
                refuseUnknown(value, struct.parameters, where);
                for (const part of struct.operations) this.write(part, value, where);
                break;
            }
            case "switch": {
                const selected = selectedBy(op, values);
                const wanted = selected ? [selected.member] : [];
                refuseOther(where, value, isObject(value), "an object");
                const there = Object.keys(value);
                if (there.length !== wanted.length || there[0] !== wanted[0]) {
                    const right = wanted[0] ?? "nothing";
                    throw new MipError("tag", `${op.tag} is ${values[op.tag]}, so ${where} must hold ${right}`);
                }
                if (selected) this.write(selected, value, where);
                break;
            }
            default:
                throw new MipError("format", `the operation "${op.kind}" is not known`);
        }
    }

    number(op, value, where) {
        const { size, kind } = this.protocol.scalar(op.scalar);
        if (kind === "bool" && typeof value === "boolean") value = Number(value);
        const write = kind === "float" ? writeFloat : (number, width, what) => writeInteger(number, width, kind === "signed", what);
        this.parts.push(write(value, size, where));
    }
}

/** Is there a value? A counter that is left out counts its array. */
function isGiven(op, values) {
    return Object.hasOwn(values, op.member) || (op.kind === "counter" && Object.hasOwn(values, op.array));
}

function refuseOtherField(field) {
    if (!Array.isArray(field?.operations))
        throw new MipError("unknown", `${described(field)} is not a field; protocol.field(name) gives one`);
}

const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

function refuseOther(where, value, right, wanted) {
    if (!right) throw new MipError("range", `${where}: ${described(value)} is not ${wanted}`);
}

function missing(name) {
    return new MipError("missing", `${name} is missing`);
}

function refuseUnknown(values, parameters, where) {
    const known = new Set(parameters.filter((one) => one.constant === undefined).map((one) => one.name));
    for (const name of Object.keys(values)) {
        if (!known.has(name)) throw new MipError("unknown", `${where} has no parameter "${name}"`);
    }
}

function checkCount(op, value, where) {
    if (value.length !== (op.count ?? value.length) || value.length > op.capacity) {
        const right = op.count ?? `at most ${op.capacity}`;
        throw new MipError("count", `${where} has ${value.length} elements, not ${right}`);
    }
}

return { decodeData, encodeData };
})();

// ---------------------------------------------------------------------------------------------------- mip/packet.mjs

modules["mip/packet"] = (() => {
// Packets: their frame, their fields, and building them.

const { MipError, bytesOf, checksum, concatenated, described, fromHex, sameBytes, toHex } = modules["mip/bytes"];
const { decodeData, encodeData } = modules["mip/codec"];
const { SHARED_SET } = modules["mip/protocol"];

const HEAD = 4;
const TAIL = 2;

/** Bytes that have the frame of a packet; the checksum may be wrong. */
class Packet {
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
        if (bytes.length < HEAD + TAIL || bytes.length !== bytes[3] + HEAD + TAIL || bytes[2] === 0) {
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
function buildPacket(protocol, set, fields) {
    if (!(Number.isInteger(set) && set > 0 && set < SHARED_SET))
        throw new MipError("set", `no packet has descriptor set ${described(set)}`);
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
    const field = protocol.candidates(set, descriptor).find((candidate) => candidate.name === name);
    if (!field) throw new MipError("unknown", `set ${set} has no field ${described(name)} with descriptor ${descriptor}`);
    return encodeData(protocol, field, values);
}

function rawOf(raw) {
    return typeof raw === "string" ? fromHex(raw) : bytesOf(raw);
}

return { Packet, buildPacket };
})();

// ---------------------------------------------------------------------------------------------------- mip/parser.mjs

modules["mip/parser"] = (() => {
// Finds packets in a stream, among anything else.

const { bytesOf, concatenated } = modules["mip/bytes"];
const { Packet } = modules["mip/packet"];

/**
 * Takes bytes in pieces of any size and gives the same packets for each division. What is no packet costs nothing but
 * itself: the search goes on one byte behind its beginning.
 */
class Parser {
    constructor(protocol) {
        this.protocol = protocol;
        this.pending = new Uint8Array(0);
        /** Bytes so far that belong to no packet. */
        this.skipped = 0;
    }

    /** The packets that are complete with these bytes, a Uint8Array or an ArrayBuffer. */
    feed(bytes) {
        this.pending = concatenated(this.pending, bytesOf(bytes));
        return this.search(false);
    }

    /** The stream has ended: the packets behind one that is incomplete. */
    flush() {
        return this.search(true);
    }

    search(ended) {
        const packets = [];
        let at = 0;
        while (at < this.pending.length) {
            const size = packetAt(this.protocol, this.pending, at);
            if (size === undefined && !ended) break;
            if (size) {
                packets.push(new Packet(this.protocol, this.pending.slice(at, at + size)));
                at += size;
            } else {
                this.skipped++;
                at++;
            }
        }
        this.pending = this.pending.slice(at);
        return packets;
    }
}

/** The size of the whole packet that begins here; 0 if there is none, undefined if the bytes do not tell yet. */
function packetAt(protocol, bytes, at) {
    const [first, second] = protocol.sync;
    const left = bytes.length - at;
    if (bytes[at] !== first || (left > 1 && bytes[at + 1] !== second) || (left > 2 && bytes[at + 2] === 0)) return 0;
    if (left < 4 || left < bytes[at + 3] + 6) return undefined;
    const size = bytes[at + 3] + 6;
    return new Packet(protocol, bytes.subarray(at, at + size)).sound ? size : 0;
}

/**
 * What bytes consist of, in order: each part has its bytes, its offset, and a kind: "packet"; "damaged", a packet with a
 * wrong checksum whose fields end where it does; "incomplete", the beginning of a packet at the end; and "other".
 * A damaged or incomplete packet never hides a whole one.
 */
function segments(protocol, given) {
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
        for (let at = from; at < to; at++) if (packetAt(protocol, bytes, at)) return true;
        return false;
    };
    for (let at = 0; at < bytes.length; ) {
        const size = packetAt(protocol, bytes, at);
        const left = bytes.length - at;
        if (size) {
            at += add("packet", at, size);
        } else if (size === undefined && left > 1 && !wholeWithin(at + 1, bytes.length)) {
            at += add("incomplete", at, left);
        } else if (isDamaged(protocol, bytes, at) && !wholeWithin(at + 1, at + bytes[at + 3] + 6)) {
            at += add("damaged", at, bytes[at + 3] + 6);
        } else {
            at += add("other", at, 1);
        }
    }
    return found;
}

function isDamaged(protocol, bytes, at) {
    const [first, second] = protocol.sync;
    if (bytes[at] !== first || bytes[at + 1] !== second || !bytes[at + 2]) return false;
    const size = bytes[at + 3] + 6;
    if (!(at + size <= bytes.length)) return false;
    try {
        for (const _ of new Packet(protocol, bytes.subarray(at, at + size)).fields());
        return true;
    } catch {
        return false;
    }
}

return { Parser, segments };
})();

// ---------------------------------------------------------------------------------------------------- mip/names.mjs

modules["mip/names"] = (() => {
// What values are called: names of values and bits, units, and where the type of a value depends on another one.

/** The parameters of the record in which an operation is: those of a field or a structure. */
function parameterOf(record, name) {
    return record.parameters.find((parameter) => parameter.name === name) ?? caseOf(record, name);
}

function caseOf(record, name) {
    const cases = record.parameters.flatMap((parameter) => parameter.cases ?? []);
    return cases.find((one) => one.parameter?.name === name)?.parameter;
}

/**
 * What a value at a path of a field is: the parameters from the field to it, the last of which says what it means.
 * Indices have none.
 */
function parametersAt(protocol, field, path) {
    const found = [];
    let record = field;
    for (const step of path) {
        if (typeof step === "number") continue;
        const parameter = parameterOf(record, step);
        if (!parameter) break;
        found.push({ parameter, record });
        const type = protocol.types.get(parameter.type);
        record =
            type?.kind === "struct"
                ? type
                : parameter.cases
                  ? { parameters: parameter.cases.flatMap((one) => one.parameter ?? []) }
                  : record;
    }
    return found;
}

/** The value of a path: ["message", "descriptors", 2]. */
function valueAt(values, path) {
    return path.reduce((inner, step) => inner?.[step], values);
}

/**
 * The enumeration or bitfield that names the values of a parameter. It may depend on the value of a sibling, or on the
 * device; `siblings` are the values beside it, `device` the id of the device or undefined.
 */
function namedType(protocol, parameter, siblings = {}, device = undefined) {
    return protocol.types.get(differing(parameter, siblings, device, "type") ?? parameter.type);
}

/** The same for the units of a parameter, and the elements of a vector. */
function measuredHere(protocol, parameter, siblings = {}, device = undefined) {
    const own = { units: parameter.units, elements: protocol.types.get(parameter.type)?.elements };
    const found = Object.keys(own).map((key) => [key, differing(parameter, siblings, device, key) ?? own[key]]);
    return { ...parameter, ...Object.fromEntries(found) };
}

/** An attribute of a parameter, if it is another one beside these values or on the device. */
function differing(parameter, siblings, device, attribute) {
    const holds = (one) => (one.by === "device" ? one.key === device : one.value === Number(siblings?.[one.by]));
    return (parameter.variants ?? []).find((one) => one[attribute] && !one.member && holds(one))?.[attribute];
}

/** The value of an enumeration with this number, if it has a name. */
function enumValue(type, number) {
    return type.values.find((value) => value.value === Number(number));
}

/** The number of a bitfield, as a BigInt; one of bytes has its least significant byte first. */
function bitsNumber(value) {
    return Array.isArray(value) ? value.reduceRight((sum, byte) => (sum << 8n) | BigInt(byte), 0n) : BigInt(value);
}

/** The bits of a name as a number, a BigInt. */
function maskOf(bits) {
    return ((1n << BigInt(bits.last - bits.first + 1)) - 1n) << BigInt(bits.first);
}

/** The bits of a bitfield with what they hold: flags that are set, and all numbers. `rest` are bits without a name. */
function bitsOf(protocol, type, value) {
    let rest = bitsNumber(value);
    const whole = rest;
    const found = [];
    for (const bits of type.bits) {
        const mask = maskOf(bits);
        const held = (whole & mask) >> BigInt(bits.first);
        rest &= ~mask;
        const named = bits.enum ? enumValue(protocol.type(bits.enum), held) : undefined;
        found.push({ bits, value: held, flag: bits.first === bits.last, named });
    }
    return { found, rest };
}

/** The unit of an element of a parameter, or nothing; plain numbers have none. */
function unitOf(parameter, index = 0) {
    const units = parameter.units ?? [];
    const unit = units.length > 1 ? units[index] : units[0];
    return unit === "1" ? "" : (unit ?? "");
}

return { parameterOf, parametersAt, valueAt, namedType, measuredHere, enumValue, bitsNumber, maskOf, bitsOf, unitOf };
})();

// ---------------------------------------------------------------------------------------------------- mip/index.mjs

modules["mip/index"] = (() => {
// The MIP protocol in JavaScript: everything that a program uses.

const { MipError, checksum, fromHex, toHex } = modules["mip/bytes"];
const { decodeData, encodeData } = modules["mip/codec"];
const { bitsOf, enumValue, namedType, parametersAt, unitOf } = modules["mip/names"];
const { Packet, buildPacket } = modules["mip/packet"];
const { Parser, segments } = modules["mip/parser"];
const { Protocol } = modules["mip/protocol"];

return { MipError, checksum, fromHex, toHex, decodeData, encodeData, bitsOf, enumValue, namedType, parametersAt, unitOf, Packet, buildPacket, Parser, segments, Protocol };
})();

// ---------------------------------------------------------------------------------------------------- tools/input.mjs

modules["tools/input"] = (() => {
// Bytes in any form in which people write them.

/**
 * The forms, in the order in which they are looked for: a pattern, and what reads its text. Without a reader, the text has
 * digits but no bytes. Decimal numbers, base64 and pairs with dots must begin with the sync bytes, because other things
 * look like them; and a comment in which they are, or that has nothing but bytes, is read.
 */
const FORMS = [
    [/\/\*(?:(?!\*\/|75\W*0?x?65)[\s\S])*\*\/|\/\/(?!.*75\W*0?x?65|(?:[^\w\n]*(?:0x)?[0-9a-f]{2}){2,}[^\w\n]*$).*/], // a comment
    [/^[ \t]*(?:0x)?[0-9a-f]{4,8}:(?=\s)/], // an offset
    [/(?<![\w.:-])(?:19|20)\d\d-\d\d-\d\d(?:(?![\w-])|t(?=\d\d:))/], // a date
    [/(?<![\d.:])(?:[01]?\d|2[0-3]):[0-5]\d:[0-5]\d(?:[.,]\d+z?|z|(?=[\])]|[ \t]+\S))/], // a time
    [/\bb"(?:[^"\\\n]|\\.)*"|\bb'(?:[^'\\\n]|\\.)*'/, bytesOfLiteral], // b"ue\x01"
    [/(?<!\w)(?=["'][^"'\n]*\\[x0-7])(?:"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')/, bytesOfLiteral], // "ue\1"
    [/(?:\\x[0-9a-f]{2}|\\[0-3][0-7]{2})+/, bytesOfLiteral], // \x75\x65, \165\145
    [/(?<![\w.])117(?:u8?)?(?=\W+101(?!\d))(?:(?:\s*,\s*|[ \t]+)-?(?:25[0-5]|2[0-4]\d|1?\d?\d)(?:u8?)?(?!\w|\.\d))+/, bytesOfDecimals], // 117, 101
    [/(?<![\w+/])dw[u-x][\w+/-]{8,}={0,2}/, bytesOfBase64],
    [/(?<!\w)(?:0x|&h)[0-9a-f][0-9a-f_]*?(?:_?[ui]\d+|u?l{0,2})(?!\w)/, bytesOfDigits], // 0x75, 0x7565, 0x75u8, &H75
    [/(?<![\w.])(?:75[._]65(?:[._][0-9a-f]{2})+|(?:[0-9a-f]{2})+h?)(?!\w|\.\d)/, bytesOfDigits], // 75, 7565, 75h, 75.65.01
];

const ANY = new RegExp(FORMS.map(([pattern], i) => `(?<form${i}>${pattern.source})`).join("|"), "gim");

// A line of a hex dump: an offset, bytes, and what they look like.
const DUMP_LINE =
    /^(?<offset>\s*(?:0x)?(?<number>[0-9a-f]{4,8})(?::(?=\s)|(?<bare>\s{2,})))\s*(?<bytes>(?:[0-9a-f]{2,4}[ \t]+)*[0-9a-f]{2,4})(?<text>\s{2,}.*|\s*\|.*)?\s*$/i;

// Bytes in a list, some of which may have a single digit: printf %x, or 1 in [0x75, 1].
const LIST = /(?<![\w.])(?:0x)?[0-9a-f]{1,2}h?(?:[\s,;]+(?:0x)?[0-9a-f]{1,2}h?(?!\w|\.\d))+/gi;

const ESCAPES = { n: 10, r: 13, t: 9, a: 7, b: 8, f: 12, v: 11 };

/** The bytes of a text, and the pieces of text between them that are no bytes, such as words. */
function bytesOfText(text) {
    const plain = padded(withoutOffsets(text.split(/\r?\n/))).join("\n");
    const bytes = [];
    const ignored = [];
    let at = 0;
    for (const match of plain.matchAll(ANY)) {
        const [, read] = FORMS.find((_, i) => match.groups[`form${i}`] !== undefined);
        if (!read) continue;
        ignored.push(plain.slice(at, match.index));
        at = match.index + match[0].length;
        for (const byte of read(match[0])) bytes.push(byte);
    }
    ignored.push(plain.slice(at));
    return {
        bytes: Uint8Array.from(bytes),
        ignored: ignored
            .flatMap((piece) => piece.split("\n"))
            .map((piece) => piece.replace(/^[\s,;:|{}[\]()<>"'-]+|[\s,;:|{}[\]()<>"'-]+$/g, ""))
            .filter(Boolean),
    };
}

/**
 * The lines of hex dumps without what is around the bytes. A number at the beginning is an offset if it begins with zeros,
 * or is as far from that of the line before or behind as the bytes reach; one with a colon is left, to be shown as ignored.
 */
function withoutOffsets(lines) {
    const dumped = lines.map((line) => {
        const { number, ...parts } = DUMP_LINE.exec(line)?.groups ?? {};
        const start = Number.parseInt(number, 16); // NaN is no offset
        return { ...parts, zeros: number?.startsWith("0000"), start, end: start + parts.bytes?.replace(/\s/g, "").length / 2 };
    });
    return lines.map((line, i) => {
        const { offset, bare, bytes, zeros, start, end } = dumped[i];
        if (zeros || dumped[i - 1]?.end === start || dumped[i + 1]?.start === end) return bytes;
        return offset && !bare ? `${offset} ${bytes}` : line;
    });
}

/**
 * Lines whose single digits are bytes of two digits where they stand between bytes, or at an end of the list that is one
 * of the line or in brackets; a list begins with one only if there are bytes before: lines may be numbered.
 */
function padded(lines) {
    let begun = false;
    return lines.map((line) => {
        const found = line.replace(LIST, (list, at) => paddedList(list, line.slice(0, at), line.slice(at + list.length), begun));
        begun ||= /\b(?:0x)?(?:[0-9a-f]{2})+h?\b|\\x/i.test(found);
        return found;
    });
}

function paddedList(list, before, behind, begun) {
    const whole = !before.trim() && !behind.trim();
    const items = list.split(/([\s,;]+)/); // with what is between them
    const single = (item) => /^[0-9a-f]$/i.test(item);
    const others = items.flatMap((item, i) => (i % 2 || single(item) ? [] : [i]));
    if (others.length < 2 && !(begun && whole)) return list;
    const atStart = /[[({"'|]\s*$/.test(before) || (begun && before.trim() === "");
    const atEnd = /^\s*($|[\])}"'|;/,])/.test(behind);
    const known = (i) => (i > others[0] || atStart) && (i < others.at(-1) || atEnd);
    return items.map((item, i) => (single(item) && known(i) ? `0${item}` : item)).join("");
}

function bytesOfDigits(text) {
    const digits = /^(?:0x|&h)?([0-9a-f._]+)/i.exec(text)[1].replace(/[._]/g, "");
    const even = digits.length % 2 ? `0${digits}` : digits;
    return Uint8Array.from(even.match(/../g), (pair) => Number.parseInt(pair, 16));
}

/** Signed ones too: Java prints them. */
function bytesOfDecimals(text) {
    return Uint8Array.from(text.match(/-?\b\d+/g), Number);
}

function bytesOfBase64(text) {
    const letters = text.replace(/=/g, "").replace(/-/g, "+").replace(/_/g, "/");
    return Uint8Array.from(atob(letters.length % 4 === 1 ? letters.slice(0, -1) : letters), (one) => one.charCodeAt(0));
}

function bytesOfLiteral(text) {
    const inner = text.replace(/^b?(["'])(.*)\1$/i, "$2");
    return Uint8Array.from(inner.match(/\\x[0-9a-f]{2}|\\[0-7]{1,3}|\\.|[^\\]/gi), (one) => {
        if (/^\\x./i.test(one)) return Number.parseInt(one.slice(2), 16);
        if (/^\\[0-7]/.test(one)) return Number.parseInt(one.slice(1), 8);
        return ESCAPES[one[1]] ?? one.at(-1).charCodeAt(0);
    });
}

return { bytesOfText };
})();

// ---------------------------------------------------------------------------------------------------- tools/words.mjs

modules["tools/words"] = (() => {
// How things of the protocol are shown: numbers, names and places.

const { readFloat, toHex, writeFloat } = modules["mip/bytes"];
const { bitsOf, enumValue, unitOf } = modules["mip/names"];
const { SHARED_SET } = modules["mip/protocol"];

function hexByte(number) {
    return hexLiteral(number, 1);
}

function spacedHex(bytes) {
    return toHex(bytes, " ").toUpperCase();
}

/** "(0x0C,0x28)"; a field of all sets has its descriptor alone. */
function descriptorOf(field) {
    return field.set ? `(${hexByte(field.set)},${hexByte(field.descriptor)})` : `(${hexByte(field.descriptor)})`;
}

/** The shortest decimal number that has the same bits as a float of this size. */
function decimal(value, size) {
    if (typeof value === "string") return `NaN (${value})`;
    if (size !== 4 || !Number.isFinite(value)) {
        return Object.is(value, -0) ? "-0" : String(value);
    }
    for (let digits = 1; digits < 9; digits++) {
        const short = Number(value.toPrecision(digits));
        if (Object.is(Math.fround(short), value)) return Object.is(short, -0) ? "-0" : String(short);
    }
    return String(Number(value.toPrecision(9)));
}

/** The shortest literal of a float of this size in programs, with a point or an exponent; undefined if it is not finite. */
function decimalLiteral(value, size) {
    const number = typeof value === "string" ? readFloat(writeFloat(value, size, "value")) : size === 4 ? Math.fround(value) : value;
    if (!Number.isFinite(number)) return undefined;
    for (let digits = 1; digits < 18; digits++) {
        const text = general(number, digits);
        const read = size === 4 ? Math.fround(Number(text)) : Number(text);
        if (Object.is(read, number)) return /[.e]/.test(text) ? text : `${text}.0`;
    }
    return undefined;
}

/** A number with so many significant digits at most, with an exponent if it is small or large: `repr` of Python. */
function general(number, digits) {
    const text = number.toExponential(digits - 1);
    const [mantissa, exponent] = text.split("e");
    const power = Number(exponent);
    const sign = Object.is(number, -0) ? "-" : "";
    const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
    if (power >= -4 && power < 16) return sign + String(Number(text));
    return `${short}e${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;
}

/** A number in hexadecimal, with all digits of so many bytes. */
function hexLiteral(value, size = 0) {
    return `0x${BigInt(value)
        .toString(16)
        .toUpperCase()
        .padStart(2 * size, "0")}`;
}

/** The path of a value: "descriptors[0].rate"; elements of vectors have names, if the last parameter has them. */
function pathText(parameters, path) {
    let text = "";
    let next = 0;
    let items; // of the last parameter: its length, and the names of its elements
    for (const step of path) {
        if (typeof step !== "number") {
            const { parameter } = parameters[next++] ?? {};
            items = { array: parameter?.length !== undefined, elements: parameter?.elements };
            text += text ? `.${step}` : step;
        } else if (items.elements && !items.array) {
            text += `.${items.elements[step]}`;
        } else {
            text += `[${step}]`;
            items = { ...items, array: false };
        }
    }
    return text;
}

/**
 * What a value is, for readers: `text`, `unit`, and of an enumeration `name` and `meaning`, of a bitfield `flags`.
 *
 * @param type the enumeration or bitfield of the value, if it has one
 */
function shown(protocol, part, parameter, type, index) {
    const { operation, value, size } = part;
    const unit = unitOf(parameter, index);
    const kind = protocol.scalar(operation.scalar)?.kind;
    if (operation.kind === "text") return { text: JSON.stringify(value.replace(/[\0 ]+$/, "")), unit };
    if (kind === "float") return { text: decimal(value, size), unit };
    if (kind === "bool") return { text: `${value}`, name: value ? "true" : "false", unit };
    if (type?.kind === "enum") {
        const known = enumValue(type, value);
        return { text: `${value}`, name: known?.name ?? "unknown", meaning: known?.description, unit };
    }
    if (type?.kind === "bitfield") {
        const { found, rest } = bitsOf(protocol, type, value);
        const flags = found.filter(({ flag, value: held }) => !flag || held);
        const text = Array.isArray(value) ? spacedHex(Uint8Array.from(value)) : hexLiteral(value, size);
        return { text, flags: rest ? [...flags, { rest }] : flags, unit };
    }
    return { text: parameter.shown ? hexLiteral(value, size) : `${value}`, unit };
}

/**
 * Number -> title of the data sets, or of the fields of the set that a parameter refers to. `values` are those of its
 * record, `outer` the parameter that holds the record, with the values beside it.
 */
function choicesOf(protocol, parameter, values, outer) {
    if (parameter.shown === "set") {
        const sets = protocol.model.sets.filter((one) => one.kind === "data" && one.number !== SHARED_SET);
        return new Map(sets.map((one) => [one.number, one.title]));
    }
    const [where, record] = parameter.fields_of ? [parameter.fields_of, values] : [outer?.parameter.fields_of, outer?.values];
    if (parameter.shown !== "field" || !where) return new Map();
    const set = Object.hasOwn(record, where)
        ? protocol.sets.get(Number(record[where]))
        : protocol.model.sets.find((one) => one.name === where);
    if (set?.kind !== "data") return new Map();
    const fields = [set, protocol.sets.get(SHARED_SET)].flatMap((one) => one?.fields ?? []).map((name) => protocol.field(name));
    return new Map(fields.map((field) => [field.descriptor, field.title]));
}

/** "fix_valid", "quality = 3", or "state = ready". */
function flagText({ bits, value, flag, named, rest }) {
    if (rest !== undefined) return `${hexLiteral(rest)} has no name`;
    return flag && !named ? bits.name : `${bits.name} = ${named?.name ?? value}`;
}

/** "mode is fast"; of another command, "mode of base.echo_control is fast". */
function conditionText({ parameter, label, command }) {
    return `${parameter}${command ? ` of ${command}` : ""} is ${label}`;
}

return { hexByte, spacedHex, descriptorOf, decimal, decimalLiteral, hexLiteral, pathText, shown, choicesOf, flagText, conditionText };
})();

// ---------------------------------------------------------------------------------------------------- tools/inspect.mjs

modules["tools/inspect"] = (() => {
// What bytes mean: packets, fields and values, with names, units and verdicts. The inspector shows it.

const { MipError, fromHex, sameBytes } = modules["mip/bytes"];
const { measuredHere, namedType, parametersAt, valueAt } = modules["mip/names"];
const { Packet } = modules["mip/packet"];
const { segments } = modules["mip/parser"];
const { bytesOfText } = modules["tools/input"];
const { choicesOf, pathText, shown } = modules["tools/words"];

/**
 * What a text of bytes consists of, each part as `segments` gives it; packets also have `set`, `fields`, `misprints`, and
 * the checksum that is right, and other bytes `why`: what keeps those that begin like a packet from being one.
 *
 * @param device the id of a device, whose readings are used where they differ
 */
function inspect(protocol, text, device = undefined) {
    const { bytes, ignored } = bytesOfText(text);
    return { bytes, ignored, parts: segments(protocol, bytes).map((part) => inspectPart(protocol, part, device)) };
}

function inspectPart(protocol, part, device) {
    if (part.kind === "other") return { ...part, why: whyOther(protocol, part.bytes) };
    const packet = new Packet(protocol, part.kind === "incomplete" ? completed(part.bytes) : part.bytes);
    const set = protocol.sets.get(part.bytes[2]);
    const fields = packet.decode().map((raw) => inspectField(protocol, raw, packet, part, device));
    const verdict =
        part.kind === "incomplete" ? {} : { sound: packet.sound, checksum: packet.checksum, rightChecksum: packet.rightChecksum };
    return { ...part, set, fields: fields.filter(Boolean), misprints: misprintsOf(protocol, part.bytes), ...verdict };
}

/** What is wrong with the frames that begin with the sync bytes: [{ at, error }]. */
function whyOther(protocol, bytes) {
    const found = [];
    for (let at = 0; at + 3 < bytes.length; at++) {
        const frame = new Packet(protocol, bytes.subarray(at, at + bytes[at + 3] + 6));
        if (!sameBytes(bytes.subarray(at, at + 2), protocol.sync)) continue;
        if (!bytes[at + 2]) found.push({ at, error: new MipError("set", "descriptor set 0x00, which no packet has") });
        else if (frame.bytes.length === bytes[at + 3] + 6) found.push({ at, error: frame.decode().at(-1)?.error });
    }
    return found.filter(({ error }) => error);
}

/** The beginning of a packet with zeros in place of what is missing. */
function completed(bytes) {
    const whole = new Uint8Array(Math.max((bytes[3] ?? 0) + 6, bytes.length));
    whole.set(bytes);
    return whole;
}

function inspectField(protocol, raw, packet, part, device) {
    if (raw.offset === undefined) return part.kind === "incomplete" ? undefined : { error: raw.error };
    const end = raw.offset + 2 + raw.data.length;
    if (part.kind === "incomplete" && end > part.bytes.length) return undefined;
    const found = { ...raw, bytes: packet.bytes.subarray(raw.offset, end) };
    if (!raw.field) return found;
    const rows = (raw.parts ?? []).map((one) => inspectValue(protocol, raw, one, device));
    return { ...found, rows, errata: errataOf(protocol, raw.field) };
}

function inspectValue(protocol, { field, values, data }, part, device) {
    const parameters = parametersAt(protocol, field, part.path);
    const places = part.path.flatMap((step, i) => (typeof step === "number" ? [] : [i])); // of the names in the path
    const [siblings, around] = [places.at(-1), places.at(-2)].map((place) => valueAt(values, part.path.slice(0, place)));
    const parameter = measuredHere(protocol, parameters.at(-1).parameter, siblings, device);
    const type = namedType(protocol, parameter, siblings, device);
    const index = part.path.slice(places.at(-1) + 1).at(-1);
    const outer = parameters.length > 1 ? { parameter: parameters.at(-2).parameter, values: around } : undefined;
    const meaning = parameter.shown ? choicesOf(protocol, parameter, siblings, outer).get(Number(part.value)) : undefined;
    const byDevice = (parameter.variants ?? []).some((one) => one.by === "device" && one.type && !one.member);
    return {
        path: pathText([...parameters.slice(0, -1), { parameter }], part.path),
        bytes: data.subarray(part.offset, part.offset + part.size),
        value: part.value,
        parameter,
        type,
        meaning,
        byDevice: byDevice && device === undefined && meaning === undefined,
        ...shown(protocol, part, parameter, type, index),
    };
}

// ------------------------------------------------------------------------------------------------ errata

/** The mistakes of the manuals about a field: in the sections that it cites, and in its lengths. */
function errataOf(protocol, field) {
    const places = new Set(field.sources.map((source) => `${source.manual}\n${source.section}`));
    return protocol.model.errata.filter(
        (erratum) =>
            (field.role !== "response" && places.has(`${erratum.manual}\n${erratum.section}`)) ||
            erratum.claims.some((claim) => claim.kind === "length" && claim.subject === field.name),
    );
}

/** The examples of manuals that are printed with exactly these bytes although others are right. */
function misprintsOf(protocol, bytes) {
    const { examples, errata } = protocol.model;
    return examples
        .filter((example) => printedAs(example, bytes) && !sameBytes(fromHex(example.packet), bytes))
        .map((example) => ({
            example,
            right: fromHex(example.packet),
            errata: errata.filter((one) => one.claims.some((claim) => claim.kind === "example" && claim.subject === example.id)),
        }));
}

function printedAs({ string, table }, bytes) {
    const digits = string?.replace(/[^0-9a-f]/gi, "");
    if (digits && digits.length % 2 === 0 && sameBytes(fromHex(digits), bytes)) return true;
    return Boolean(table) && table.length === bytes.length && table.every((byte, i) => byte === null || byte === bytes[i]);
}

return { inspect, errataOf, misprintsOf };
})();

// ---------------------------------------------------------------------------------------------------- tools/dom.mjs

modules["tools/dom"] = (() => {
// Elements of a page, and links to the reference.

/** An element with attributes and children; texts are shown as they are. */
function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
        else if (value === true) made.setAttribute(name, "");
        else if (value !== undefined && value !== false && value !== null) made.setAttribute(name, value);
    }
    made.append(...children.flat(Infinity).filter((child) => child !== undefined && child !== null && child !== false));
    return made;
}

/**
 * Where the reference has things. `options.fieldPage`, `options.acknowledgePage`, `options.erratumPage` and
 * `options.inspectorPage` are addresses with {set}, {page}, {field}, {id} and {packet} in them; without one, there are no
 * links. A response is on the page of its command.
 */
function links(options = {}) {
    const address = (pattern, values) => pattern?.replace(/\{(\w+)\}/g, (_, name) => encodeURIComponent(values[name]));
    return {
        field(field, ...words) {
            const [set, page] = (field.command ?? field.name).split(".");
            const pattern = field.set ? options.fieldPage : options.acknowledgePage;
            return link(address(pattern, { set, page, field: field.name }), words.length ? words : [field.title]);
        },
        erratum(erratum) {
            return link(address(options.erratumPage, { id: erratum.id }), [erratum.id]);
        },
        inspector(packet) {
            return link(address(options.inspectorPage, { packet }), ["Packet: open in the inspector"]);
        },
    };
}

function link(href, words) {
    return href ? element("a", { href }, ...words) : element("span", {}, ...words);
}

/** What is not known of a device, if its profile is incomplete. */
function profileNote(device) {
    if (!device?.incomplete) return undefined;
    const unknown = device.incomplete.join(" ").replaceAll("`", "");
    const marked = "Fields that it perhaps has, or of which nothing is known, are offered and marked.";
    return element("p", { class: "mip-note" }, `The profile of the ${device.title} is incomplete: ${unknown} ${marked}`);
}

/** Words behind the name of a field that a device does not have for certain. */
function mark(certainty) {
    return certainty ? ` (${certainty})` : "";
}

/** Calls a function when the user has changed something. */
function whenChanged(inputs, update) {
    for (const input of inputs) input.addEventListener("input", update);
}

/** What is behind the # of the address, as it is if it is no encoded text. */
function fragment() {
    const text = location.hash.slice(1);
    try {
        return decodeURIComponent(text);
    } catch {
        return text;
    }
}

return { element, links, profileNote, mark, whenChanged, fragment };
})();

// ---------------------------------------------------------------------------------------------------- tools/find.mjs

modules["tools/find"] = (() => {
// Finds fields by what people know of them: a descriptor, a name, a symbol, a word.

const { sameBytes } = modules["mip/bytes"];
const { bytesOfText } = modules["tools/input"];
const { hexByte, spacedHex } = modules["tools/words"];

// Where a word is found counts: the smaller, the better.
const EXACT = 0;
const VENDOR = 0.5;
const BEGINNING = 1;
const TITLE = 2;
const WORDS = 3;
const PARTS = 4;
const TEXT = 5;
const PLACES = [TITLE, WORDS, PARTS, TEXT];

/** Bytes of a packet before its payload: what is shorter may be a descriptor. */
const FRAME_HEAD = 4;

/** An index of all fields, for `find`. */
function indexOf(protocol) {
    const synonyms = synonymsOf(protocol.model.vocabulary);
    const commands = new Map();
    for (const field of protocol.model.fields) for (const name of field.responses ?? []) commands.set(name, field);
    const vendorWords = vendorWordsOf(protocol);
    const entries = protocol.model.fields.map((field) => entryOf(protocol, field, commands, vendorWords));
    return { protocol, synonyms, vendorWords, entries };
}

/**
 * The fields that a text may mean, the best first, at most `limit` of them. A text is a descriptor in any form ("0x0D13",
 * "82 10", "(0x82,0x10)", "0x82"), a name, a symbol of C, Python or Rust, of a value too, a name of the vendor, or words.
 * `rank` is 0 at most if the text is a descriptor, a name, a symbol or a keyword of the field.
 */
function find(index, text, limit = 20) {
    const query = text.trim();
    if (!query) return [];
    const ranks = new Map();
    for (const { field, rank } of byDescriptor(index, query)) ranks.set(field, rank);
    const squashed = squash(query);
    const vendor = /\s/.test(query) ? "" : index.vendorWords(query);
    const words = [...new Set(wordsOf(query))];
    for (const entry of index.entries) {
        const rank = Math.min(
            rankOfSymbol(entry, squashed),
            entry.vendor.has(vendor) ? VENDOR : Infinity,
            rankOfWords(entry, words, index.synonyms),
        );
        if (rank < Infinity && !ranks.has(entry.field)) ranks.set(entry.field, rank);
    }
    // What is found by its set is in the order of the specification.
    const order = ({ field, rank }) => (rank < EXACT - 1 ? [rank] : [rank, entryRank(field), rank < EXACT ? 0 : field.name.length]);
    const found = [...ranks].map(([field, rank]) => ({ field, rank }));
    return found.sort((a, b) => compared(order(a), order(b))).slice(0, limit);
}

/** A text that is a packet, or the beginning of one, for the inspector; undefined for other texts. */
function packetIn({ protocol }, text) {
    const { bytes } = bytesOfText(text);
    const begun = bytes.length > FRAME_HEAD && sameBytes(bytes.subarray(0, 2), protocol.sync);
    return begun ? spacedHex(bytes) : undefined;
}

function compared(a, b) {
    const i = a.findIndex((value, at) => value !== b[at]);
    return i < 0 ? 0 : a[i] - b[i];
}

/** Commands and data before responses, and fields before those that repeat them. */
function entryRank(field) {
    return (field.role === "response" && field.set ? 1 : 0) + (field.definition ? 2 : 0) + (field.deprecated ? 1 : 0);
}

// ------------------------------------------------------------------------------------------------ descriptors

// Words and marks that people write around the numbers.
const AROUND = /\b(?:command|data|desc|descriptor|field|set)\b|[\s,:;/.()[\]{}=-]+/g;

// 0x4, 4h, 04; and 4, which is a descriptor only behind a set.
const NUMBER = /^(?:0x([0-9a-f]{1,2})h?|([0-9a-f]{1,2})h|([0-9a-f]{2}))$/;
const DIGIT = /^([0-9a-f])$/;
const TOGETHER = /^(?:0x)?([0-9a-f]{2})(?:0x)?([0-9a-f]{2})h?$/;

/** A set and a descriptor, or one of them; empty for other texts. */
function descriptorsOf(query) {
    const parts = query.toLowerCase().replace(AROUND, " ").trim().split(" ").filter(Boolean);
    const match = (part, ...forms) => forms.map((form) => form.exec(part)).find(Boolean);
    const matches = parts.map((part, i) => match(part, NUMBER, ...(i ? [DIGIT] : parts.length > 1 ? [] : [TOGETHER])));
    if (matches.length > 2 || !matches.every(Boolean)) return [];
    const digits = matches.flatMap((found) => found.slice(1).filter(Boolean));
    return digits.map((one) => Number.parseInt(one, 16));
}

function byDescriptor({ protocol }, query) {
    const [first, descriptor] = descriptorsOf(query);
    if (first === undefined) return [];
    if (descriptor !== undefined) {
        return protocol.candidates(first, descriptor).map((field) => ({ field, rank: EXACT - 3 }));
    }
    return protocol.model.fields
        .filter((field) => field.set === first || field.descriptor === first)
        .map((field) => ({ field, rank: field.set === first ? EXACT - 2 : EXACT - 1 }));
}

// ------------------------------------------------------------------------------------------------ names

/** Letters and digits alone: symbols of all languages look alike then. */
function squash(text) {
    return text.toLowerCase().replace(/[^a-z0-9]+/g, "");
}

function wordsOf(text) {
    return text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
}

// What symbols of the vendor have beside the words of a name: mip::data_sensor::, MIP_CMD_DESC_, CH_FIELD_, extract_mip_.
const BESIDE = ["mip", "data", "command", "cmd", "descriptor", "ch", "field", "vec", "insert", "to", "extract", "from"];

/**
 * A function: the words of a symbol in the vocabulary of the specification, in no order, without those beside a name and
 * functions. mip_filter_position_llh_data and DATA_FILTER_POS_LLH are the same then.
 */
function vendorWordsOf({ model, functions }) {
    const others = model.vocabulary.flatMap(({ word, instead_of: instead }) => instead.map((one) => [one, word]));
    const usual = new Map(others);
    const beside = new Set([...BESIDE, ...[...functions.values()].map((one) => one.name)]);
    return (symbol) => {
        const words = wordsOf(symbol.replace(/(?<=[a-z0-9])(?=[A-Z])/g, "_").replaceAll("_", " "));
        const plain = words.map(stem).map((word) => usual.get(word) ?? word);
        return plain
            .filter((word) => !beside.has(word))
            .sort()
            .join(" ");
    };
}

/** All words of some texts, with a space before and behind each. */
function spaced(...texts) {
    return ` ${[...new Set(wordsOf(texts.join(" ")))].join(" ")} `;
}

function entryOf(protocol, field, commands, vendorWords) {
    const [set, name] = field.name.split(".");
    const also = field.also ?? [];
    const keywords = field.keywords ?? [];
    const symbols = Object.values(field.symbols);
    const short = symbols.map((symbol) => symbol.replace(/^mip_protocol(\.|::)/, ""));
    const names = [
        field.name,
        name,
        field.title,
        ...also,
        ...also.flatMap((one) => [`${set}.${one}`, `mip.${set}.${one}`]),
        ...keywords,
        ...symbols,
        ...short,
    ];
    const types = field.parameters.flatMap((parameter) => partsOf(protocol, parameter));
    const sections = field.sources.map((source) => source.section);
    const asked = commands.get(field.name);
    return {
        field,
        squashed: [...new Set(names.map(squash))],
        vendor: new Set([name, ...also].map((one) => vendorWords(`${set}.${one}`))),
        constants: new Set(field.parameters.flatMap((parameter) => constantsOf(protocol, parameter))),
        words: {
            [TITLE]: spaced(field.title, name, ...also, ...keywords),
            [WORDS]: spaced(set, protocol.sets.get(field.set)?.title ?? "", field.title, name, ...also, ...keywords, ...sections),
            [PARTS]: spaced(...types.map((one) => one.name)),
            [TEXT]: spaced(field.description, asked?.description ?? "", ...types.map((one) => one.description ?? "")),
        },
    };
}

/** The symbols of the values and bits of a parameter, in all languages. */
function constantsOf(protocol, parameter) {
    const types = [parameter.type, ...(parameter.variants ?? []).map((variant) => variant.type)];
    const inner = types.flatMap((name) => {
        const type = protocol.types.get(name);
        if (type?.kind === "struct") return type.parameters.flatMap((one) => constantsOf(protocol, one));
        if (!type?.symbols || name === protocol.model.function_selector) return [];
        const owners = Object.values(type.symbols).flatMap((symbol) => [symbol, symbol.split(/\.|::/).at(-1)]);
        const parts = [...(type.values ?? []), ...(type.bits ?? [])].flatMap((one) => [one.name, one.short ?? one.name]);
        return owners.flatMap((owner) => parts.map((part) => squash(owner + part)));
    });
    return [...inner, ...(parameter.cases ?? []).flatMap((one) => (one.parameter ? constantsOf(protocol, one.parameter) : []))];
}

/** What has a name inside a parameter: itself, values, bits and members. */
function partsOf(protocol, parameter) {
    const types = [parameter.type, ...(parameter.variants ?? []).map((variant) => variant.type)];
    const inner = types.flatMap((name) => {
        const type = protocol.types.get(name);
        if (type?.kind === "struct") return type.parameters.flatMap((one) => partsOf(protocol, one));
        return name === protocol.model.function_selector ? [] : (type?.values ?? type?.bits ?? []);
    });
    const cases = (parameter.cases ?? []).flatMap((one) => (one.parameter ? partsOf(protocol, one.parameter) : []));
    return [parameter, ...inner, ...cases];
}

function rankOfSymbol(entry, query) {
    if (query.length < 2) return Infinity;
    if (entry.constants.has(query)) return EXACT;
    let rank = Infinity;
    for (const name of entry.squashed) {
        if (name === query) return EXACT;
        // A symbol with more behind it: mip_base_ping_encode, PpsSourceControl::write. The longest name is meant.
        if (name.length > 6 && query.startsWith(name)) rank = Math.min(rank, BEGINNING + 1 / name.length);
        else if (name.startsWith(query)) rank = Math.min(rank, BEGINNING + 0.9);
    }
    return rank;
}

/** The best place that has all words, or words that mean the same. */
function rankOfWords(entry, words, synonyms) {
    if (!words.length) return Infinity;
    let [worst, sum] = [0, 0];
    for (const word of words) {
        const wanted = synonyms.get(stem(word)) ?? [word];
        const place = PLACES.find((one) => wanted.some((each) => holds(entry.words[one], each)));
        if (place === undefined) return Infinity;
        worst = Math.max(worst, place);
        sum += place;
    }
    return worst + (sum / words.length) * 0.1;
}

/** Is a word there, or one that begins with it? Short words must be whole. */
function holds(words, wanted) {
    return words.includes(wanted.length < 3 ? ` ${wanted} ` : ` ${stem(wanted)}`);
}

/** A word without its plural. */
function stem(word) {
    return word.length > 3 ? word.replace(/s$/, "") : word;
}

/** Word -> the words of the specification that mean the same, itself among them. */
function synonymsOf(vocabulary) {
    const synonyms = new Map();
    for (const { word, instead_of: others } of vocabulary) {
        if (word.includes("_")) continue;
        for (const other of others.filter((one) => !one.includes("_"))) {
            synonyms.set(stem(other), [...(synonyms.get(stem(other)) ?? [other]), word]);
            synonyms.set(stem(word), [...(synonyms.get(stem(word)) ?? [word]), other]);
        }
    }
    return synonyms;
}

/** "command 0x0C,0x28", for lists. */
function kindOf(field) {
    return `${field.role} ${field.set ? `${hexByte(field.set)},` : ""}${hexByte(field.descriptor)}`;
}

return { indexOf, find, packetIn, kindOf };
})();

// ---------------------------------------------------------------------------------------------------- tools/code.mjs

modules["tools/code"] = (() => {
// Programs in C, Python and Rust that send a command, or read a data field: the same as on the pages of the reference.

const { MipError } = modules["mip/bytes"];
const { bitsNumber, enumValue, maskOf, parameterOf } = modules["mip/names"];
const { decimalLiteral, hexLiteral } = modules["tools/words"];

/** The languages, as programs name and as people call them. */
const LANGUAGES = [
    ["c", "C"],
    ["python", "Python"],
    ["rust", "Rust"],
];

/**
 * A program that sends a command once with each of some values, or that reads a data field or a response. Raises a
 * MipError of the kind "program" if a language cannot write a value.
 */
function programOf(protocol, language, field, values = []) {
    const writer = { c: cProgram, python: pythonProgram, rust: rustProgram }[language];
    if (field.role !== "command") return writer(new Names(protocol, language), field);
    for (const one of values) refuseReserved(protocol, field, one);
    return writer(new Names(protocol, language), field, values);
}

/** The first response that a command asks for with these values, or nothing. */
function responseTo(protocol, field, values) {
    const call = field.calls && protocol.functions.get(Number(values.function));
    if (field.calls && !call?.responds) return undefined;
    const holds = ({ parameter, label, value }) => {
        const held = values[parameter];
        if (held === undefined) return false;
        return ["true", "false"].includes(label) ? Boolean(Number(held)) === Boolean(value) : Number(held) === value;
    };
    const own = (response) => (response.command === field.name ? (response.when ?? []) : []);
    return (field.responses ?? []).map((name) => protocol.field(name)).find((response) => own(response).every(holds));
}

// ------------------------------------------------------------------------------------------------ names and values

class Names {
    constructor(protocol, language) {
        this.protocol = protocol;
        this.language = language;
        this.table = protocol.model.programs[language];
    }

    member(name) {
        return this.table.members[name] ?? name;
    }

    /** A value of an enumeration, or a bit. */
    constant(type, part) {
        if (this.language === "c") return `${type.symbols.c}_${part.short ?? part.name}`.toUpperCase();
        const name = this.table.constants[part.name] ?? part.name.toUpperCase();
        return `${this.type(type)}${this.language === "rust" ? "::" : "."}${name}`;
    }

    /** A type or a field, with a mark in front of the module that it needs. */
    type({ symbols }) {
        if (this.language === "c") return symbols.c;
        return `~${symbols[this.language].replace(/^mip_protocol(\.|::)/, "")}`;
    }

    named(op) {
        return op.type === undefined ? undefined : this.protocol.type(op.type);
    }
}

function cannot(what) {
    return new MipError("program", `no program can be given here: ${what}`);
}

function flatOperations(record) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op]));
}

/** The operation of a parameter of a field or a structure. */
function operationOf(record, name) {
    return flatOperations(record).find((op) => op.member === name);
}

const isDerived = (parameter) => parameter.constant !== undefined || parameter.counts !== undefined;
const isReserved = (parameter) => parameter.reserved !== undefined;
const isUnion = (parameter) => parameter.type === undefined;

/** The parameters that a command requires with these values. */
function requiredParameters(protocol, field, values) {
    const all = field.parameters.filter((parameter) => !parameter.selector);
    return all.slice(0, protocol.required(field, values.function));
}

function refuseOptional(protocol, field, values) {
    const required = new Set(requiredParameters(protocol, field, values).map((parameter) => parameter.name));
    const more = field.parameters.find(({ name, selector }) => !selector && !required.has(name) && values[name] !== undefined);
    if (more) throw cannot(`${more.name} is optional; set it in the object of the command`);
}

/** Constructors set what is reserved, so another value would be lost. */
function refuseReserved(protocol, record, values) {
    for (const parameter of record.parameters) {
        const value = values[parameter.name];
        if (value === undefined) continue;
        const { kind, size } = protocol.scalar(protocol.types.get(parameter.type)?.scalar ?? parameter.type) ?? {};
        const plain = (one) => (kind === "float" ? decimalLiteral(one, size) : String(Number(one)));
        if (isReserved(parameter) && [value].flat().some((one) => plain(one) !== plain(parameter.reserved))) {
            throw cannot(`${parameter.name} is reserved; set it in the object of the command`);
        }
        const struct = protocol.types.get(parameter.type);
        if (struct?.kind === "struct") for (const one of [value].flat()) refuseReserved(protocol, struct, one);
    }
}

/** The one case that a union has: its operation and value. */
function alternativeOf(op, value) {
    const found = op.cases.find((one) => one.operation && Object.hasOwn(value, one.operation.member));
    return found && { ...found, value: value[found.operation.member] };
}

/** The flags that make up a value; none if it has other bits, or numbers, too. */
function flagsOf(type, value) {
    const number = bitsNumber(value);
    const flags = type.bits.filter((bits) => bits.first === bits.last && !bits.alias && number & maskOf(bits));
    return flags.reduce((sum, bits) => sum | maskOf(bits), 0n) === number ? flags : [];
}

function printable(text) {
    if (/[^ -~]/.test(text)) throw cannot(`${JSON.stringify(text)} has characters that are not ASCII`);
    return text;
}

/** A call, with a line for each argument if one line is too long. */
function call(head, given, tail, width, comma = ",") {
    const line = `${head}${given.join(", ")}${tail}`;
    if (line.length <= width || given.length === 0) return line;
    const each = given.map((argument) => `    ${broken(argument, width - 5).replaceAll("\n", "\n    ")}`);
    return `${head}\n${each.join(",\n")}${comma}\n${tail}`;
}

/** An expression that ends with brackets, with a line for each of what is in them if one line is too long. */
function broken(text, width) {
    if (text.length <= width || !/([)\]}]|};)$/.test(text)) return text;
    const end = text.replace(/;$/, "").length - 1;
    const [start, commas] = lastBrackets(text);
    const edges = [start, ...commas, end];
    const parts = edges.slice(1).map((edge, i) => text.slice(edges[i] + 1, edge).trim());
    // A comma would make another value of what is only in parentheses.
    if (parts.length === 1 && text[start] === "(" && !/[A-Za-z0-9]$/.test(text.slice(0, start))) return text;
    const given = parts.filter((part) => part !== "");
    return call(text.slice(0, start + 1), given, text.slice(end), width);
}

/** Where the brackets that end last begin, and the commas between the things in them. */
function lastBrackets(text) {
    const opened = [];
    let last;
    let quote = "";
    let escaped = false;
    for (const [i, c] of [...text].entries()) {
        if (quote) {
            if (c === quote && !escaped) quote = "";
            escaped = c === "\\" && !escaped;
        } else if (c === '"' || c === "'") quote = c;
        else if ("([{".includes(c)) opened.push([i, []]);
        else if (")]}".includes(c)) last = opened.pop();
        else if (c === "," && opened.length) opened.at(-1)[1].push(i);
    }
    return last;
}

/** A number of a parameter; `known` writes the name of a value, `flags` names of bits, `other` another number of a type. */
function numberText(names, parameter, op, value, { float, known, flags, other }) {
    const { kind, size } = names.protocol.scalar(op.scalar);
    if (kind === "float") return float(decimalLiteral(value, size) ?? fail(`${op.member} is no finite number`), size);
    if (kind === "bool") return undefined;
    const type = names.named(op);
    if (type?.kind === "enum") {
        const found = enumValue(type, value);
        return found ? known(type, found) : other(type, String(value));
    }
    if (type?.kind === "bitfield") {
        const found = flagsOf(type, value);
        return found.length
            ? flags(found.map((bits) => names.constant(type, bits)).join(" | "))
            : other(type, hexLiteral(value).toLowerCase());
    }
    return parameter.shown ? hexLiteral(value, size) : String(value);
}

function fail(why) {
    throw cannot(why);
}

// ------------------------------------------------------------------------------------------------ C

function cProgram(names, field, calls) {
    const header = `mip/${names.table.headers[field.name.split(".")[0]]}`;
    if (!calls) {
        const held = field.parameters.filter((one) => one.constant === undefined && (!isUnion(one) || one.cases?.some((x) => x.parameter)));
        const read =
            held
                .slice(0, 3)
                .map((one) => `value.${names.member(one.name)}`)
                .join(", ") + (held.length > 3 ? " …" : "");
        const type = names.type(field);
        return [
            `#include "${header}.h"`,
            "",
            `struct ${type} value;`,
            `const mip_error error = ${type}_decode(&value, &field);`,
            "if (error == MIP_OK) {",
            `    /* ${read || "it holds nothing"} */`,
            "} else {",
            "    /* mip_error_name(error) says why */",
            "}",
        ].join("\n");
    }
    const lines = [`#include "${header}_commands.h"`, ""];
    calls.forEach((values, i) => {
        lines.push(...(i ? [""] : []), ...cCall(names, field, values, i ? "result = " : "struct mip_result result = "));
    });
    lines.push("if (!mip_succeeded(result)) {", "    /* mip_result_reason(result) says why */", "}");
    return lines.join("\n");
}

/** What must be declared before, and the call, whose result is assigned. */
function cCall(names, field, values, result) {
    const { protocol } = names;
    refuseOptional(protocol, field, values);
    const function_ = field.calls && protocol.functions.get(Number(values.function))?.name;
    const ways = names.table.calls[field.name].filter((way) => way.function === function_);
    const wanted = responseTo(protocol, field, values)?.name;
    const way = ways.find(({ response }) => response === wanted) ?? ways[0];
    if (!way) throw cannot("the function has no name");
    const before = [];
    const given = ["device"];
    if (way.whole) {
        before.push(`const struct ${names.type(field)} command = ${cRecord(names, field, values)};`);
        given.push("&command");
    }
    for (const name of way.takes ?? []) {
        const [declared, passed] = cArgument(names, field, parameterOf(field, name), values[name]);
        before.push(...declared);
        given.push(...passed);
    }
    if (way.response) {
        before.push(`struct ${names.type(protocol.field(way.response))} response;`);
        given.push("&response");
    }
    return [...before.map((line) => broken(line, 96)), call(`${result}${way.name}(`, given, ");", 96, "")];
}

/** What must be declared before, and what is passed. */
function cArgument(names, field, parameter, value) {
    const name = names.table.arguments[parameter.name] ?? parameter.name;
    const op = operationOf(field, parameter.name);
    const count = parameter.length === "rest" ? [String(value.length)] : [];
    if (op.kind === "switch") {
        return [[`const union ${names.type(field)}_${parameter.name} ${name} = ${cUnion(names, parameter, op, value)};`], [`&${name}`]];
    }
    if (op.kind === "text") return [[], [...count, cString(value)]];
    if (op.kind === "array") {
        if (!value.length) return [[], [...count, "NULL"]];
        const inner = op.item.kind === "array" ? `[${op.item.count}]` : "";
        return [[`const ${cType(names, parameter)} ${name}[]${inner} = ${cValue(names, parameter, op, value)};`], [...count, name]];
    }
    if (cType(names, parameter).startsWith("struct ")) {
        return [[`const ${cType(names, parameter)} ${name} = ${cValue(names, parameter, op, value)};`], [`&${name}`]];
    }
    const type = names.named(op);
    if (type?.kind === "enum" && type.values.every((one) => one.value <= 0x7fff)) {
        const known = enumValue(type, value);
        return [[], [known ? names.constant(type, known) : `(enum ${names.type(type)})${value}`]];
    }
    return [[], [cValue(names, parameter, op, value)]];
}

/** The type of one item. */
function cType(names, { type }) {
    const { protocol, table } = names;
    if (table.scalars[type]) return table.scalars[type];
    const known = protocol.type(type);
    if (known.kind === "bitfield" && known.scalar) return names.type(known);
    return table.scalars[known.scalar] ?? `struct ${names.type(known)}`;
}

function cUnion(names, parameter, op, value) {
    const found = alternativeOf(op, value);
    if (!found) return "{0}";
    const { operation } = found;
    const inner = parameter.cases.find((one) => one.parameter?.name === operation.member).parameter;
    return `{.${names.member(operation.member)} = ${cValue(names, inner, operation, found.value)}}`;
}

function cRecord(names, record, values) {
    const held = record.parameters
        .filter((parameter) => parameter.constant === undefined && Object.hasOwn(values, parameter.name))
        .map((parameter) => [parameter, operationOf(record, parameter.name), values[parameter.name]])
        .filter(([, op, value]) => op.kind !== "switch" || alternativeOf(op, value)) // {0} would lack braces inside
        .map(([parameter, op, value]) => {
            const text = op.kind === "switch" ? cUnion(names, parameter, op, value) : cValue(names, parameter, op, value);
            return `.${names.member(parameter.name)} = ${text}`;
        });
    return `{${held.join(", ") || "0"}}`;
}

function cValue(names, parameter, op, value) {
    switch (op.kind) {
        case "counter":
            return String(value);
        case "text":
            return cString(value);
        case "bits":
            return ["{", value.join(", "), "}"].map((part, i) => (i === 1 ? part : part + part)).join("");
        case "array":
            return `{${value.map((one) => cValue(names, parameter, op.item, one)).join(", ") || "0"}}`;
        case "struct":
            return cRecord(names, names.protocol.type(op.struct), value);
    }
    const { kind, size } = names.protocol.scalar(op.scalar);
    if (kind === "bool") return Number(value) ? "true" : "false";
    const type = names.named(op);
    if (
        kind !== "float" &&
        (!type || (type.kind === "enum" && !enumValue(type, value)) || (type.kind === "bitfield" && !flagsOf(type, value).length))
    ) {
        const form = !type && parameter.shown ? hexLiteral(value, size) : String(value);
        return cNumber(value, size, type?.kind === "bitfield" ? undefined : form);
    }
    return numberText(names, parameter, op, value, {
        float: (text, width) => text + (width === 4 ? "F" : ""),
        known: (of, one) => names.constant(of, one),
        flags: (text) => text,
    });
}

function cNumber(value, size, form) {
    const number = BigInt(value);
    if (number < 0n) return String(value);
    const text = form ?? (number < 0x8000n ? String(value) : hexLiteral(number));
    if (size === 8) return `UINT64_C(${text})`;
    return number > 0x7fffn && size === 4 ? `UINT32_C(${text})` : text;
}

function cString(text) {
    const whole = printable(text).trim();
    if (/ {2}/.test(whole)) throw cannot(`${JSON.stringify(text)} has several spaces`);
    return `"${whole.replace(/["\\]/g, "\\$&").replaceAll("??", "?\\?")}"`;
}

// ------------------------------------------------------------------------------------------------ Python

function pythonProgram(names, field, calls) {
    if (!calls) {
        const read = field.parameters.filter((one) => !isDerived(one)).map((one) => `value.${names.member(one.name)}`);
        return pythonImports(
            names,
            `for time, value in device.fields(${names.type(field)}):\n    ${call("print(", ["time", ...read.slice(0, 3)], ")", 84)}`,
        );
    }
    const lines = [];
    for (const values of calls) {
        refuseOptional(names.protocol, field, values);
        const asked = requiredParameters(names.protocol, field, values).filter((one) => !isDerived(one) && !isReserved(one));
        const given = asked.map((one) => pythonValue(names, field, one, operationOf(field, one.name), values[one.name]));
        const function_ = field.calls && names.protocol.functions.get(Number(values.function))?.name;
        const asks = responseTo(names.protocol, field, values) !== undefined;
        const head = `${asks ? "response = " : ""}device.request(${names.type(field)}${function_ ? `.${names.member(function_)}` : ""}(`;
        lines.push(call(head, given, "))", 84), ...(asks ? ["print(response)"] : []));
    }
    return pythonImports(names, lines.join("\n"));
}

/** What a program needs, in front of it. */
function pythonImports(names, text) {
    const used = [...new Set(Array.from(text.matchAll(/(?<![\w.])~(\w+)\./g), (match) => match[1]))].sort();
    const alias = (name) => names.table.modules[name] ?? name;
    const imports = used.map((name) => (alias(name) === name ? name : `${name} as ${alias(name)}`));
    const body = text.replace(/~(\w+)\./g, (_, name) => `${alias(name)}.`);
    return `from mip_protocol import ${imports.join(", ")}\n\n${body}`;
}

function pythonValue(names, record, parameter, op, value) {
    switch (op.kind) {
        case "text":
            return `"${printable(value).replace(/["\\]/g, "\\$&")}"`;
        case "bits":
            return `${names.type(names.named(op))}(${hexLiteral(bitsNumber(value)).toLowerCase()})`;
        case "array": {
            const items = value.map((one) => pythonValue(names, record, parameter, op.item, one));
            return `(${items.join(", ")}${items.length === 1 ? "," : ""})`;
        }
        case "struct":
            return pythonStruct(names, names.protocol.type(op.struct), value);
        case "switch": {
            const found = alternativeOf(op, value);
            if (!found) return "None";
            const inner = parameter.cases.find((one) => one.parameter?.name === found.operation.member).parameter;
            return pythonValue(names, record, inner, found.operation, found.value);
        }
    }
    if (names.protocol.scalar(op.scalar).kind === "bool") return Number(value) ? "True" : "False";
    return numberText(names, parameter, op, value, {
        float: (text) => text,
        known: (type, one) => names.constant(type, one),
        flags: (text) => text,
        other: (type, text) => `${names.type(type)}(${text})`,
    });
}

function pythonStruct(names, struct, values) {
    const held = struct.parameters.filter((one) => !isDerived(one));
    const hasDefault = (one) => isReserved(one) || isUnion(one);
    const given = held.flatMap((one, i) => {
        const byName = hasDefault(one) && held.slice(i + 1).some((other) => !hasDefault(other));
        if (byName && isReserved(one)) return [];
        const text = pythonValue(names, struct, one, operationOf(struct, one.name), values[one.name]);
        return [byName ? `${names.member(one.name)}=${text}` : text];
    });
    return `${names.type(struct)}(${given.join(", ")})`;
}

// ------------------------------------------------------------------------------------------------ Rust

function rustProgram(names, field, calls) {
    if (!calls) {
        const first = field.parameters.find((one) => !isDerived(one));
        const read = first ? `value.${names.member(first.name)}` : "value";
        const found = `packet.find::<${names.type(field)}>().transpose()?`; // a broken one is an error, as a refused command is
        return rustUses(`if let Some(value) = ${found} {\n    println!("{:?}", ${read});\n}`);
    }
    const lines = [];
    for (const values of calls) {
        refuseOptional(names.protocol, field, values);
        const required = requiredParameters(names.protocol, field, values);
        const function_ = field.calls && names.protocol.functions.get(Number(values.function))?.name;
        const made = function_ ? names.table.constructors[function_] : "new";
        const asks = responseTo(names.protocol, field, values) !== undefined;
        const head = `${asks ? "let response = device.request" : "device.run"}(&${names.type(field)}::${made}(`;
        lines.push(call(head, rustGiven(names, field, required, values), "))?;", 84), ...(asks ? ['println!("{response:?}");'] : []));
    }
    return rustUses(lines.join("\n"));
}

/** What a program needs, in front of it. */
function rustUses(text) {
    const used = [...new Set(Array.from(text.matchAll(/~(\w+)/g), (match) => match[1]))].sort();
    return `use mip_protocol::${used.length === 1 ? used[0] : `{${used.join(", ")}}`};\n\n${text.replaceAll("~", "")}`;
}

/** The arguments of a constructor: no reserved values, and no tag whose union is given. */
function rustGiven(names, record, parameters, values) {
    const tags = new Set(parameters.filter((one) => one.tag).map((one) => one.tag));
    return parameters
        .filter((one) => !isDerived(one) && !isReserved(one) && !tags.has(one.name))
        .map((one) => rustValue(names, record, one, operationOf(record, one.name), values[one.name]));
}

function rustValue(names, record, parameter, op, value) {
    switch (op.kind) {
        case "text": {
            const text = printable(value).replace(/["\\]/g, "\\$&");
            return op.count === undefined ? `~VarText::new("${text}").unwrap()` : `~Text(*b"${text}")`;
        }
        case "bits":
            return `${names.type(names.named(op))}([${value.join(", ")}])`;
        case "array": {
            const array = `[${value.map((one) => rustInner(names, record, parameter, op.item, one)).join(", ")}]`;
            return op.vector ? `~${names.table.vectors[op.vector]}::from(${array})` : array;
        }
        case "struct": {
            const struct = names.protocol.type(op.struct);
            return `${names.type(struct)}::new(${rustGiven(names, struct, struct.parameters, value).join(", ")})`;
        }
        case "switch":
            return rustUnion(names, record, parameter, op, value);
    }
    if (names.protocol.scalar(op.scalar).kind === "bool") return Number(value) ? "true" : "false";
    return numberText(names, parameter, op, value, {
        float: (text) => text,
        known: (type, one) => names.constant(type, one),
        flags: (text) => text,
        other: (type, text) => `${names.type(type)}(${text})`,
    });
}

function rustUnion(names, record, parameter, op, value) {
    const union = `~${names.table.unions[`${record.name}.${parameter.name}`]}`;
    const found = alternativeOf(op, value);
    const inner = found && parameter.cases.find((one) => one.parameter?.name === found.operation.member);
    const tag = (inner ?? parameter.cases.find((one) => !one.parameter))?.tag ?? fail(`${parameter.name} has no case`);
    const variant = `${union}::${names.table.variants[tag]}`;
    return inner ? `${variant}(${rustInner(names, record, inner.parameter, found.operation, found.value)})` : variant;
}

/** Constructors take a `bool`, everything else holds a `Bool`. */
function rustInner(names, record, parameter, op, value) {
    if (op.kind === "scalar" && names.protocol.scalar(op.scalar).kind === "bool") return `~Bool(${Number(value)})`;
    return rustValue(names, record, parameter, op, value);
}

return { LANGUAGES, programOf, responseTo };
})();

// ---------------------------------------------------------------------------------------------------- tools/build.mjs

modules["tools/build"] = (() => {
// What the builder knows of a packet with one field: values to begin with, bytes, source code, and the answer.

const { fromHex, readFloat, toHex } = modules["mip/bytes"];
const { FIRST_DATA_SET, SHARED_SET } = modules["mip/protocol"];
const { buildPacket } = modules["mip/packet"];
const { namedType, parameterOf } = modules["mip/names"];
const { conditionText, hexByte } = modules["tools/words"];

/** The sets in whose packets a field can be. */
function setsOf(protocol, field) {
    if (field.set && field.set !== SHARED_SET) return [field.set];
    const numbers = protocol.model.sets.map((set) => set.number).filter((number) => number !== SHARED_SET);
    return numbers.filter((number) => number >= FIRST_DATA_SET === (field.set === SHARED_SET));
}

/** The operations of a field that a function requires; all that are required where there is no selector. */
function requiredOperations(protocol, field, selector) {
    const required = protocol.required(field, selector);
    return field.operations.flatMap((op) => (op.kind !== "group" ? [op] : op.last <= required ? op.body : []));
}

/** Values that a user would send or see, for a function where the field has a selector; optional ones if asked for. */
function typicalValues(protocol, field, selector, optional = false) {
    const call = field.calls?.find((one) => one.function === protocol.functions.get(Number(selector))?.name);
    const found = numbersOf(protocol, field, (field.calls ? call?.typical : field.typical) ?? {});
    const operations = optional ? allOperations(field) : requiredOperations(protocol, field, selector);
    const values = {};
    if (field.calls) values.function = selector;
    for (const { kind, member } of operations) {
        if (kind !== "constant" && Object.hasOwn(found, member)) values[member] = found[member];
    }
    return values;
}

/** The operations of a field, those of groups too. */
function allOperations(field) {
    return field.operations.flatMap((op) => (op.kind === "group" ? op.body : [op]));
}

/** Values as JavaScript has them: the model has the bits of floats. */
function numbersOf(protocol, record, values) {
    const found = {};
    for (const op of record.operations.flatMap((one) => (one.kind === "group" ? one.body : [one]))) {
        if (Object.hasOwn(values, op.member)) found[op.member] = numberOfBits(protocol, op, values[op.member]);
    }
    return found;
}

function numberOfBits(protocol, op, value) {
    switch (op.kind) {
        case "array":
            return value.map((one) => numberOfBits(protocol, op.item, one));
        case "struct":
            return numbersOf(protocol, protocol.type(op.struct), value);
        case "switch":
            return numbersOf(protocol, { operations: op.cases.map((one) => one.operation).filter(Boolean) }, value);
        case "scalar":
            return protocol.scalar(op.scalar).kind === "float" ? readFloat(fromHex(value.slice(2))) : value;
        default:
            return Array.isArray(value) ? [...value] : value;
    }
}

/** Values to begin with: typical ones, else as few as possible. */
function initialValues(protocol, field, selector) {
    const values = typicalValues(protocol, field, selector);
    for (const op of requiredOperations(protocol, field, selector)) {
        if (op.kind !== "constant" && !Object.hasOwn(values, op.member)) values[op.member] = initialValue(protocol, op, field, values);
    }
    return values;
}

function begin(protocol, op, record, values) {
    if (op.kind === "constant") return;
    values[op.member] = initialValue(protocol, op, record, values);
}

/** The value to begin with of one operation; that of a union depends on the values before it. */
function initialValue(protocol, op, record, values) {
    const parameter = parameterOf(record, op.member) ?? {};
    const given = parameter.default ?? parameter.reserved;
    switch (op.kind) {
        case "counter":
            return 0;
        case "bits":
            return Array(op.size).fill(0);
        case "text":
            return (typeof given === "string" ? given : "").padEnd(op.count ?? 0);
        case "array": {
            const count = op.count ?? (Array.isArray(given) ? given.length : 0);
            const inner = { parameters: [{ name: op.item.member, type: parameter.type }] };
            return Array.from({ length: count }, (_, i) => {
                const one = Array.isArray(given) ? given[i] : given;
                return one === undefined ? initialValue(protocol, op.item, inner, {}) : numberOf(protocol, parameter, one, {});
            });
        }
        case "struct": {
            const struct = protocol.type(op.struct);
            const inner = {};
            for (const part of struct.operations) begin(protocol, part, struct, inner);
            return inner;
        }
        case "switch": {
            const selected = op.cases.find((one) => one.value === Number(values[op.tag]))?.operation;
            return selected ? { [selected.member]: initialValue(protocol, selected, record, {}) } : {};
        }
        default:
            return numberOf(protocol, parameter, given ?? firstOf(protocol, parameter, values), values);
    }
}

function firstOf(protocol, parameter, values) {
    const type = namedType(protocol, parameter, values);
    if (type?.kind === "enum") return type.values[0].value;
    return Math.max(0, parameter.minimum ?? 0);
}

/** A number for a default: it may be the name of a value, or names of bits. */
function numberOf(protocol, parameter, given, values) {
    const type = namedType(protocol, parameter, values);
    if (typeof given === "string") return type?.values?.find((one) => one.name === given)?.value ?? 0;
    if (Array.isArray(given)) {
        return given.reduce((sum, name) => sum + 2 ** (type?.bits?.find((one) => one.name === name)?.first ?? 0), 0);
    }
    return Number(given);
}

/** The same values, with the number of elements in every counter. */
function counted(protocol, operations, values) {
    const all = { ...values };
    for (const op of operations.flatMap((one) => (one.kind === "group" ? one.body : [one]))) {
        if (op.kind === "counter" && all[op.array] !== undefined) all[op.member] = all[op.array].length;
        if (!Object.hasOwn(all, op.member)) continue;
        if (op.kind === "struct") all[op.member] = counted(protocol, protocol.type(op.struct).operations, all[op.member]);
        if (op.kind === "array" && op.item.kind === "struct") {
            const { operations: inner } = protocol.type(op.item.struct);
            all[op.member] = all[op.member].map((item) => counted(protocol, inner, item));
        }
        if (op.kind === "switch") {
            const selected = op.cases.map((one) => one.operation).filter((one) => one && Object.hasOwn(all[op.member], one.member));
            all[op.member] = counted(protocol, selected, all[op.member]);
        }
    }
    return all;
}

/** The packet of some fields with their values, each `{ field, values }`; raises a MipError that says what is wrong. */
function packetOf(protocol, set, entries) {
    const fields = entries.map(({ field, values }) => ({
        descriptor: field.descriptor,
        name: field.name,
        values: counted(protocol, field.operations, values),
    }));
    return buildPacket(protocol, set, fields);
}

// ------------------------------------------------------------------------------------------------ optional parameters

/** The groups of operations that may follow what a function requires. */
function optionalGroups(protocol, field, selector) {
    const required = protocol.required(field, selector);
    const call = field.calls?.find((one) => one.function === protocol.functions.get(Number(selector))?.name);
    const groups = field.operations.filter((op) => op.kind === "group" && op.last > required);
    return field.calls ? groups.filter((op) => op.body.every((one) => call?.optional.includes(one.member))) : groups;
}

/** How many of these groups are there. */
function countOptional(groups, values) {
    const absent = groups.findIndex((op) => op.body.some(({ kind, member }) => kind !== "constant" && !Object.hasOwn(values, member)));
    return absent < 0 ? groups.length : absent;
}

/** The operations of what is there: all that are required, and the optional ones with values. */
function shownOperations(protocol, field, values) {
    const groups = optionalGroups(protocol, field, values.function);
    const optional = groups.slice(0, countOptional(groups, values)).flatMap((op) => op.body);
    return [...requiredOperations(protocol, field, values.function), ...optional];
}

// ------------------------------------------------------------------------------------------------ devices

/** What a device says of a field: an entry of its `supports`; without a device, of any field; responses go with commands. */
function supportOn(protocol, device, field) {
    if (!device || field === protocol.acknowledge) return {};
    const names = field.role === "response" ? commandsOf(protocol, field) : [field.name];
    return device.supports?.find((one) => names.includes(one.field));
}

function commandsOf(protocol, response) {
    return protocol.model.fields.filter((one) => one.responses?.includes(response.name)).map((one) => one.name);
}

/**
 * Whether a device can be offered a field: "" if it supports it, "perhaps" if it probably does, "not known" if its profile is
 * incomplete and does not list it, undefined if it has no such field.
 */
function certaintyOn(protocol, device, field) {
    const support = supportOn(protocol, device, field);
    if (support) return support.evidence ? "perhaps" : "";
    return device.incomplete ? "not known" : undefined;
}

/** What differs on a device, each in words. */
function differencesOn(protocol, device, field) {
    const support = supportOn(protocol, device, field);
    if (!support) return [`it is not known ${device.incomplete ? "whether it supports" : "to support"} this`];
    const found = [];
    if (support.evidence) found.push(`it probably supports this: ${support.evidence}`);
    if (support.functions) found.push(`only ${support.functions.join(", ")}`);
    if (support.deprecated) found.push(`deprecated: ${support.deprecated}`);
    for (const parameter of field.parameters) {
        for (const variant of parameter.variants ?? []) {
            if (variant.by === "device" && variant.key === device.id) found.push(`${parameter.name}: ${variantText(variant)}`);
        }
    }
    return found;
}

function variantText({ type, units, minimum, maximum, default: usual, only, constant, unknown, description, deprecated }) {
    const parts = [
        unknown && "its values are not known",
        type && `values of ${type}`,
        only && `only ${only.join(", ")}`,
        constant !== undefined && `always ${constant}`,
        units?.length && `in ${units.join(", ")}`,
        minimum !== undefined && `at least ${minimum}`,
        maximum !== undefined && `at most ${maximum}`,
        usual !== undefined && `default ${usual}`,
        deprecated && "deprecated",
        description,
    ];
    return parts.filter(Boolean).join("; ") || "differs";
}

// ------------------------------------------------------------------------------------------------ answers

/**
 * What a command is answered with: `silent`, why there is no answer; `acknowledge`, the packet if nothing else
 * comes; `responses`, each with the field, the condition under which it is directly behind the acknowledge, and a packet
 * with typical values.
 */
function answerOf(protocol, field, values) {
    const call = field.calls ? protocol.functions.get(Number(values.function)) : undefined;
    const conditions = [...(field.silent_when ?? []), ...(field.silenced_by ?? [])].map(conditionText);
    if (call && !call.reply) return { silent: `The function ${call.name} is not answered.`, conditions, responses: [] };
    const asked = !call || call.responds ? (field.responses ?? []).map((name) => protocol.field(name)) : [];
    const { acknowledge } = protocol;
    const [command, code] = acknowledge.operations.map((op) => op.member);
    const first = { field: acknowledge, values: { [command]: field.descriptor, [code]: 0 } };
    const packet = packetOf(protocol, field.set, [first]);
    const responses = asked.map((response) => ({
        field: response,
        when: response.command === field.name ? (response.when ?? []).map(conditionText).join(" and ") : "",
        packet: packetOf(protocol, field.set, [first, { field: response, values: initialValues(protocol, response) }]),
    }));
    return { acknowledge: packet, responses, conditions };
}

/** The bytes as source code. */
function sourceOf(bytes, language) {
    const list = Array.from(bytes, hexByte).join(", ");
    const plain = `\\x${toHex(bytes, "\\x")}`;
    return {
        c: `static const uint8_t packet[] = {${list}};`,
        python: `packet = b"${plain}"`,
        rust: `const PACKET: [u8; ${bytes.length}] = [${list}];`,
    }[language];
}

return { setsOf, requiredOperations, typicalValues, allOperations, initialValues, initialValue, counted, packetOf, optionalGroups, countOptional, shownOperations, supportOn, certaintyOn, differencesOn, answerOf, sourceOf };
})();

// ---------------------------------------------------------------------------------------------------- tools/stream.mjs

modules["tools/stream"] = (() => {
// How much a port must carry for a stream of data fields.

const { SHARED_SET } = modules["mip/protocol"];
const { certaintyOn } = modules["tools/build"];

/** Bytes of a packet beside its fields. */
const FRAME = 6;

/** Bits that a UART sends for a byte. */
const BITS = 10;

/**
 * What streams take: `bytes` per second, and the `baud` rate that a UART needs at least, by the formula of the manuals:
 * packets of a set are sent at the highest rate of its fields.
 *
 * @param streams for each data set an array of fields with their rates in Hz: [{ field, rate }]
 */
function needOf(streams) {
    let bytes = 0;
    for (const fields of streams) {
        const highest = Math.max(0, ...fields.map(({ rate }) => rate));
        bytes += FRAME * highest + fields.reduce((sum, { field, rate }) => sum + (field.max_size + 2) * rate, 0);
    }
    return { bytes, baud: BITS * bytes };
}

/** The ports of a device with the smallest rate that is enough: undefined if none is, null where there is no rate. */
function portsFor(device, baud) {
    return (device?.ports ?? []).map((port) => ({
        port,
        rate: port.baud_rates.length ? port.baud_rates.filter((rate) => rate >= baud).sort((a, b) => a - b)[0] : null,
    }));
}

/**
 * The data sets of a device with the fields that can be streamed in each, shared ones first, and the base rate: undefined if
 * it is not known, 0 for a set that is sent as it arrives. Without a device, all; of an incomplete profile, what is not
 * listed too.
 */
function streamsOf(protocol, device) {
    const rates = new Map(device?.base_rates?.map((rate) => [rate.set, rate.hertz]));
    const fieldsOf = (set) =>
        (set?.fields ?? []).map((name) => protocol.field(name)).filter((field) => certaintyOn(protocol, device, field) !== undefined);
    const shared = fieldsOf(protocol.sets.get(SHARED_SET));
    return protocol.model.sets
        .filter((set) => set.kind === "data" && set.number !== SHARED_SET)
        .map((set) => ({ set, base: rates.get(set.name), own: fieldsOf(set) }))
        .filter(({ own }) => own.length)
        .map(({ set, base, own }) => ({ set, base, fields: [...shared, ...own] }));
}

return { needOf, portsFor, streamsOf };
})();

// ---------------------------------------------------------------------------------------------------- tools/inspector.mjs

modules["tools/inspector"] = (() => {
// The inspector: paste bytes, read what they mean.

const { element, links, whenChanged } = modules["tools/dom"];
const { inspect } = modules["tools/inspect"];
const { descriptorOf, flagText, hexByte, spacedHex } = modules["tools/words"];

/** Fills an element with the inspector. `options` are those of `links`, and `text`, the bytes that it begins with. */
function inspector(root, protocol, options = {}) {
    const to = links(options);
    const input = element("textarea", { rows: 5, spellcheck: "false", autocomplete: "off", id: "mip-bytes" }, options.text ?? "");
    const device = element(
        "select",
        { id: "mip-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id }, one.title)),
    );
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    const update = () => {
        const found = inspect(protocol, input.value, device.value || undefined);
        output.replaceChildren(...report(found, to));
    };
    root.replaceChildren(
        element(
            "p",
            {},
            element(
                "label",
                { for: "mip-bytes" },
                "Bytes in hexadecimal: dumps, arrays or strings; there may be other bytes between packets",
            ),
        ),
        input,
        element("p", {}, element("label", { for: "mip-device" }, "Values as on "), device),
        output,
    );
    whenChanged([input, device], update);
    update();
    return { update, input, output };
}

function report({ bytes, ignored, parts }, to) {
    if (!bytes.length && ignored.length) {
        const words = "No bytes were found in this text; hexadecimal is needed. Not read as bytes: ";
        return [element("p", { class: "mip-wrong" }, words, ignored.join(" "))];
    }
    if (!bytes.length) return [element("p", { class: "mip-note" }, "Nothing to read yet.")];
    const packets = parts.filter((part) => part.kind !== "other").length;
    const summary = `${count(bytes.length, "byte")}, ${count(packets, "packet")}`;
    return [
        element("p", { class: "mip-summary" }, summary, ignored.length ? `; not read as bytes: ${ignored.join(" ")}` : ""),
        ...parts.map((part) => (part.kind === "other" ? otherBytes(part) : packetReport(part, to))),
    ];
}

function count(number, word) {
    return `${number} ${word}${number === 1 ? "" : "s"}`;
}

function otherBytes({ bytes, why }) {
    const text = Array.from(bytes, (byte) => (byte >= 32 && byte < 127 ? String.fromCharCode(byte) : "·")).join("");
    return element(
        "section",
        { class: "mip-other", "data-kind": "other" },
        element("p", {}, `${count(bytes.length, "byte")} outside packets: `, element("code", {}, spacedHex(bytes)), ` ${text}`),
        why.map(({ at, error }) =>
            element("p", { class: "mip-wrong" }, `What begins like a packet at byte ${at + 1} is none: ${error.message}.`),
        ),
    );
}

function packetReport(part, to) {
    const { bytes, kind, set, fields } = part;
    const title = set ? `${set.title} (${hexByte(set.number)})` : bytes.length > 2 ? `Unknown set ${hexByte(bytes[2])}` : "Packet";
    return element(
        "section",
        { class: "mip-packet", "data-kind": kind, "data-bytes": spacedHex(bytes) },
        element("h2", {}, title),
        element("p", { class: "mip-bytes" }, element("code", {}, spacedHex(bytes))),
        verdict(part),
        part.misprints.map((misprint) => misprintNote(misprint, to)),
        fields.map((field) => fieldReport(field, to)),
    );
}

function verdict({ kind, bytes, sound, checksum, rightChecksum }) {
    if (kind === "incomplete") {
        const missing = bytes.length > 3 ? count(bytes[3] + 6 - bytes.length, "byte") : "at least one byte";
        return element("p", { class: "mip-verdict mip-wrong" }, `The packet is incomplete: ${missing} missing.`);
    }
    if (sound) return element("p", { class: "mip-verdict mip-right" }, "Checksum ", element("code", {}, spacedHex(checksum)), " is right.");
    return element(
        "p",
        { class: "mip-verdict mip-wrong" },
        "Checksum ",
        element("code", {}, spacedHex(checksum)),
        " is wrong; correct: ",
        element("code", {}, spacedHex(rightChecksum)),
        ".",
    );
}

function misprintNote({ example, right, errata }, to) {
    return element(
        "p",
        { class: "mip-note" },
        `The manual ${example.manual} gives these bytes (${example.section}: ${example.title}) by mistake. Correct: `,
        element("code", {}, spacedHex(right)),
        ". ",
        errata.length ? ["See ", listed(errata, to), "."] : "",
    );
}

function listed(errata, to) {
    return errata.flatMap((erratum, i) => [i ? ", " : "", to.erratum(erratum)]);
}

function fieldReport(found, to) {
    const { field, descriptor, bytes, error, rows = [], errata = [], trailing } = found;
    if (descriptor === undefined) return element("p", { class: "mip-wrong" }, `The rest is malformed: ${error.message}.`);
    const heading = field
        ? element("h3", {}, to.field(field), ` ${descriptorOf(field)} `, element("code", {}, field.name))
        : element("h3", {}, `Unknown descriptor ${hexByte(descriptor)}`);
    return element(
        "div",
        { class: "mip-field", "data-field": field?.name ?? "" },
        heading,
        field && element("p", {}, field.description),
        element("p", { class: "mip-bytes" }, element("code", {}, spacedHex(bytes))),
        error && element("p", { class: "mip-wrong" }, `It cannot be decoded: ${error.message}.`),
        rows.length > 0 && valueTable(rows),
        trailing > 0 && element("p", { class: "mip-note" }, `${count(trailing, "byte")} after the last known parameter.`),
        errata.length > 0 && element("p", { class: "mip-note" }, "Mistakes in the manuals: ", listed(errata, to)),
    );
}

function valueTable(rows) {
    const heads = ["Bytes", "Parameter", "Value", "Meaning"].map((text) => element("th", { scope: "col" }, text));
    return element(
        "div",
        { class: "mip-scroll" },
        element("table", {}, element("thead", {}, element("tr", {}, heads)), element("tbody", {}, rows.map(valueRow))),
    );
}

const CHOOSE = " Depends on the device; choose one above.";

function valueRow({ bytes, path, text, unit, name, meaning, flags, parameter, byDevice }) {
    const value = [element("span", { class: "mip-number" }, text), unit && ` ${unit}`, name && [" ", element("code", {}, name)]];
    const shownFlags = flags?.flatMap((flag, i) => [
        i ? ", " : "",
        element("span", { class: "mip-flag", title: flag.named?.description ?? flag.bits?.description }, flagText(flag)),
    ]);
    return element(
        "tr",
        { "data-path": path },
        element("td", {}, element("code", {}, spacedHex(bytes))),
        element("td", {}, element("code", {}, path)),
        element("td", {}, value),
        element(
            "td",
            {},
            shownFlags?.length ? shownFlags : flags ? "none set" : (meaning ?? parameter.description ?? ""),
            byDevice && CHOOSE,
        ),
    );
}

return { inspector };
})();

// ---------------------------------------------------------------------------------------------------- tools/finder.mjs

modules["tools/finder"] = (() => {
// The finder: type what you know of a field, and go to its page.

const { element, links } = modules["tools/dom"];
const { find, indexOf, kindOf, packetIn } = modules["tools/find"];

/** Fills an element with the finder. `options` are those of `links`, and `text`, what is looked for at first. */
function finder(root, protocol, options = {}) {
    const to = links(options);
    const index = indexOf(protocol);
    const input = element("input", { type: "search", id: "mip-find", autocomplete: "off", spellcheck: "false", value: options.text });
    const output = element("ul", { class: "mip-results", "aria-live": "polite" });
    const update = () => {
        const packet = options.inspectorPage && packetIn(index, input.value);
        const found = find(index, input.value).map(({ field }) => resultItem(field, to));
        if (packet) found.unshift(element("li", {}, to.inspector(packet)));
        const nothing = input.value.trim() ? [element("li", {}, "Nothing found.")] : [];
        output.replaceChildren(...(found.length ? found : nothing));
    };
    const form = element(
        "form",
        {
            role: "search",
            onsubmit: (event) => {
                event.preventDefault();
                output.querySelector("a[href]")?.click();
            },
        },
        element("label", { for: "mip-find" }, "A descriptor (0x0D13, 82 10), a name, a symbol of C, Python or Rust, or words"),
        input,
    );
    root.replaceChildren(form, output);
    input.addEventListener("input", update);
    update();
    return { update, input, output };
}

function resultItem(field, to) {
    return element(
        "li",
        { "data-field": field.name },
        to.field(field, element("strong", {}, field.title)),
        ` ${kindOf(field)} `,
        element("code", {}, field.name),
        element("div", {}, field.description),
    );
}

return { finder };
})();

// ---------------------------------------------------------------------------------------------------- tools/builder.mjs

modules["tools/builder"] = (() => {
// The builder: choose commands or fields, fill them in, and see the packet, the programs that send it and the answer.

const { MipError, toHex } = modules["mip/bytes"];
const { bitsNumber, enumValue, maskOf, measuredHere, namedType, parameterOf, unitOf } = modules["mip/names"];
const { Packet } = modules["mip/packet"];
const { FIRST_DATA_SET, SHARED_SET } = modules["mip/protocol"];
const { allOperations, answerOf, certaintyOn, counted, countOptional, differencesOn, initialValue, initialValues, optionalGroups, packetOf, setsOf, shownOperations, sourceOf, typicalValues } = modules["tools/build"];
const { LANGUAGES, programOf } = modules["tools/code"];
const { element, links, mark, profileNote } = modules["tools/dom"];
const { bytesOfText } = modules["tools/input"];
const { choicesOf, decimal, descriptorOf, hexByte, hexLiteral, spacedHex } = modules["tools/words"];

/**
 * Fills an element with the builder. `options` are those of `links`, and `field`, what to begin with: the name of a field,
 * or a packet in hexadecimal, perhaps behind the id of a device. If it is given, the fragment of the address follows what
 * is built.
 */
function builder(root, protocol, options = {}) {
    const to = links(options);
    const state = { device: undefined, set: undefined, entries: [] };
    const deviceChoice = element(
        "select",
        { id: "mip-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id }, one.title)),
    );
    const note = element("div", { role: "status" });
    const choice = element("select", { id: "mip-field" });
    const start = startOf(protocol, options.field ?? "");
    const problem = element("p", { class: "mip-wrong", role: "status" }, start.problem);
    const forms = element("div", {});
    const output = element("div", { class: "mip-output", "aria-live": "polite" });

    let started = false; // the address stays as it is until something is changed
    const show = () => {
        const packet = built(protocol, state);
        output.replaceChildren(...report(protocol, state, packet, to));
        if (started && options.field !== undefined && packet.bytes) {
            const text = [state.device?.id, toHex(packet.bytes).toUpperCase()].filter(Boolean).join(" ");
            history.replaceState(history.state, "", `#${encodeURIComponent(text)}`);
        }
    };
    const layOut = () => {
        forms.replaceChildren(...entryForms(protocol, state, { changed: show, reshaped }, to), adder());
    };
    const reshaped = () => {
        layOut();
        show();
    };
    const listFields = () => {
        const groups = protocol.model.sets.map((set) => [
            `${set.title} (${hexByte(set.number)})`,
            set.fields.map((name) => protocol.field(name)),
        ]);
        groups.push(["All command sets", [protocol.acknowledge]]);
        const chosen = state.entries[0]?.field;
        const offered = groups.map(([label, fields]) => [label, fieldOptions(protocol, state.device, fields, chosen)]);
        choice.replaceChildren(
            ...offered.filter(([, options]) => options.length).map(([label, options]) => element("optgroup", { label }, options)),
        );
        note.replaceChildren(...[profileNote(state.device)].filter(Boolean));
        if (chosen) choice.value = chosen.name;
    };
    const adder = () => {
        const options = fieldOptions(protocol, state.device, beside(protocol, state));
        const add = element("select", { id: "mip-add" }, element("option", { value: "" }, "…"), options);
        add.addEventListener("input", () => {
            if (!add.value) return;
            state.entries.push(entryOf(protocol, protocol.field(add.value)));
            layOut();
            show();
        });
        return element("p", { class: "mip-adder" }, element("label", { for: "mip-add" }, "Add another field "), add);
    };
    const begin = (entries, set) => {
        state.entries = entries;
        state.set = set ?? setsOf(protocol, entries[0].field)[0];
        listFields();
        layOut();
        show();
    };
    const choose = (name, selector) => {
        problem.remove();
        begin([entryOf(protocol, protocol.field(name), selector)]);
    };

    choice.addEventListener("input", () => choose(choice.value));
    deviceChoice.addEventListener("input", () => {
        state.device = protocol.model.devices.find((one) => one.id === deviceChoice.value);
        listFields();
        layOut();
        show();
    });
    root.replaceChildren(
        element("p", {}, element("label", { for: "mip-device" }, "Device "), deviceChoice),
        note,
        element("p", {}, element("label", { for: "mip-field" }, "Command or field "), choice),
        forms,
        output,
    );
    state.device = start.device;
    deviceChoice.value = start.device?.id ?? "";
    if (start.entries) begin(start.entries, start.set);
    else choose(start.name ?? protocol.model.sets[0].fields[0]);
    if (start.problem) forms.before(problem);
    started = true;
    return { choose, state: () => state };
}

/** What a fragment says: a device, and a field by its name or a packet; `problem` is what cannot be taken over. */
function startOf(protocol, text) {
    const device = protocol.model.devices.find((one) => text === one.id || text.startsWith(`${one.id} `));
    const rest = device ? text.slice(device.id.length).trim() : text;
    if (!rest) return { device };
    if (protocol.fields.has(rest)) return { device, name: rest };
    const { bytes } = bytesOfText(rest);
    if (!bytes.length) return { device, problem: "The address has neither the name of a field nor a packet." };
    try {
        const packet = Packet.from(protocol, bytes);
        const entries = packet.decode().map(takenOver);
        if (!entries.length) throw new MipError("fields", "it has no field");
        const left = entries.filter(({ trailing }) => trailing).map(({ field, trailing }) => `${trailing} at the end of ${field.name}`);
        const problem = left.length ? `Bytes that no parameter has are left out: ${left.join(", ")}.` : undefined;
        return { device, entries: entries.map(({ field, values }) => ({ field, values })), set: packet.set, problem };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { device, problem: `The packet of the address cannot be taken over: ${error.message}.` };
    }
}

function takenOver({ descriptor, field, values, trailing, error }) {
    if (error) throw error;
    if (!field) throw new MipError("unknown", `there is no field with descriptor ${hexByte(descriptor)} in its set`);
    return { field, values, trailing };
}

function entryOf(protocol, field, selector) {
    const known = (value) => field.calls?.some((call) => call.function === protocol.functions.get(Number(value))?.name);
    const first = [...protocol.functions.values()].find((one) => one.name === field.calls?.[0].function)?.value;
    return { field, values: initialValues(protocol, field, field.calls ? (known(selector) ? Number(selector) : first) : undefined) };
}

/** The fields that can be in the same packet. */
function beside(protocol, { set }) {
    const names = [protocol.sets.get(set), set >= FIRST_DATA_SET && protocol.sets.get(SHARED_SET)].flatMap((one) => one?.fields ?? []);
    return [...names.map((name) => protocol.field(name)), ...(set < FIRST_DATA_SET ? [protocol.acknowledge] : [])];
}

/** The choices among fields: those that the device may have, and the chosen one. */
function fieldOptions(protocol, device, fields, chosen) {
    return fields.flatMap((field) => {
        const certainty = certaintyOn(protocol, device, field);
        if (certainty === undefined && field !== chosen) return [];
        const response = field.role === "response" ? " (response)" : "";
        return [element("option", { value: field.name }, `${hexByte(field.descriptor)} ${field.title}${response}${mark(certainty)}`)];
    });
}

// ------------------------------------------------------------------------------------------------ inputs

/** A form for each field; of several, they can be moved and removed. */
function entryForms(protocol, state, events, to) {
    return state.entries.map((entry, i) => {
        const form = element("div", { class: "mip-form" }, inputs(protocol, state, entry, events));
        if (state.entries.length === 1) return form;
        const move = (by) => () => {
            state.entries.splice(i + by, 0, ...state.entries.splice(i, 1));
            events.reshaped();
        };
        const remove = () => {
            state.entries.splice(i, 1);
            events.reshaped();
        };
        const button = (words, act, disabled) =>
            element("button", { type: "button", onclick: act, disabled, "aria-label": `${words}: field ${i + 1}` }, words);
        return element(
            "section",
            { class: "mip-entry", "data-field": entry.field.name },
            element("h2", {}, `${i + 1}. `, to.field(entry.field), ` ${descriptorOf(entry.field)}`),
            element(
                "p",
                {},
                button("Up", move(-1), i === 0),
                " ",
                button("Down", move(1), i === state.entries.length - 1),
                " ",
                button("Remove", remove),
            ),
            form,
        );
    });
}

function inputs(protocol, state, entry, events) {
    const { field } = entry;
    const sets = setsOf(protocol, field);
    const parts = [element("p", {}, field.description), ...deviceNotes(protocol, state.device, field)];
    if (sets.length > 1 && state.entries.length === 1) {
        const options = sets.map((number) => [number, `${protocol.sets.get(number)?.title ?? ""} (${hexByte(number)})`]);
        const change = (number) => {
            state.set = number;
            events.reshaped();
        };
        parts.push(labelled("set", select(options, state.set, change)));
    }
    const context = { protocol, device: state.device?.id, record: field, values: entry.values, events };
    if (field.calls) {
        const functions = [...protocol.functions.values()].filter((one) => field.calls.some((call) => call.function === one.name));
        const options = functions.map((one) => [one.value, `${one.name}: ${one.description}`]);
        const change = (selector) => {
            const kept = Object.entries(entry.values).filter(([name]) => name !== "function");
            const fresh = initialValues(protocol, field, selector);
            for (const [name, value] of kept) if (Object.hasOwn(fresh, name)) fresh[name] = value;
            entry.values = fresh;
            events.reshaped();
        };
        parts.push(labelled("function", select(options, entry.values.function, change)));
    }
    const shown = shownOperations(protocol, field, entry.values).filter((op) => !(field.calls && op.member === "function"));
    return [...parts, ...shown.flatMap((op) => input(context, op)), ...optionalButtons(protocol, entry, events)];
}

/** What the chosen device takes of a field, and what differs there. */
function deviceNotes(protocol, device, field) {
    if (!device) return [];
    const found = differencesOn(protocol, device, field);
    if (!found.length) return [];
    return [
        element(
            "ul",
            { class: "mip-device-notes" },
            found.map((text) => element("li", {}, `${device.title}: ${text}`)),
        ),
    ];
}

/** Parameters that no function requires come one after another, and go the other way round. */
function optionalButtons(protocol, entry, events) {
    const { field, values } = entry;
    const groups = optionalGroups(protocol, field, values.function);
    const present = countOptional(groups, values);
    const names = (group) =>
        group.body
            .filter(({ kind }) => kind !== "counter")
            .map((op) => op.member)
            .join(", ");
    const add = () => {
        const typical = typicalValues(protocol, field, values.function, true);
        for (const op of groups[present].body) values[op.member] = typical[op.member] ?? initialValue(protocol, op, field, values);
        events.reshaped();
    };
    const leaveOut = () => {
        for (const op of groups[present - 1].body) delete values[op.member];
        events.reshaped();
    };
    const buttons = [
        present < groups.length &&
            element("button", { type: "button", onclick: add, class: "mip-more" }, `Add ${names(groups[present])} (optional)`),
        present > 0 &&
            element("button", { type: "button", onclick: leaveOut, class: "mip-less" }, `Leave out ${names(groups[present - 1])}`),
    ].filter(Boolean);
    return buttons.length ? [element("p", {}, buttons)] : [];
}

let lastInput = 0; // for ids

function labelled(words, control, ...behind) {
    control.id ||= `mip-input-${++lastInput}`;
    return element("p", {}, element("label", { for: control.id }, `${words} `), control, ...behind);
}

function select(options, value, set) {
    const known = options.map(([number, words]) => element("option", { value: number, selected: number === Number(value) }, words));
    const control = element("select", {}, known);
    control.addEventListener("input", () => set(Number(control.value)));
    return control;
}

/** The inputs of one operation; they change `values` of the context. */
function input(context, op) {
    if (op.kind === "constant" || op.kind === "counter") return [];
    const { protocol, record, values, events, device } = context;
    const parameter = measuredHere(protocol, parameterOf(record, op.member) ?? { name: op.member }, values, device);
    const name = op.member;
    const set = (value) => {
        values[name] = value;
        events.changed();
    };
    const hint = [unitOf(parameter), parameter.description].filter(Boolean).join(" · ");
    const note = hint ? [" ", element("small", {}, hint)] : [];
    const inside = (struct, inner) => ({ ...context, record: struct, values: inner, outer: { parameter, values } });
    switch (op.kind) {
        case "scalar":
            return [scalarInput(context, op, parameter, note)];
        case "bits":
            return [bitsInput(name, protocol.type(op.type), values[name], (number) => set(littleEndian(number, op.size)))];
        case "text": {
            const control = element("input", { value: values[name].trimEnd(), maxlength: op.count ?? op.capacity });
            control.addEventListener("input", () => set(control.value.padEnd(op.count ?? 0)));
            return [labelled(name, control, note)];
        }
        case "struct": {
            const struct = protocol.type(op.struct);
            return [
                group(
                    name,
                    hint,
                    struct.operations.flatMap((part) => input(inside(struct, values[name]), part)),
                ),
            ];
        }
        case "switch": {
            const selected = op.cases.find((one) => one.value === Number(values[op.tag]))?.operation;
            return selected ? [group(name, hint, input({ ...context, values: values[name] }, selected))] : [];
        }
        default:
            return [arrayInput(context, op, parameter, hint)];
    }
}

function scalarInput(context, op, parameter, note) {
    const { protocol, record, values, events, device } = context;
    const name = op.member;
    const type = namedType(protocol, parameter, values, device);
    const { kind, size } = protocol.scalar(op.scalar);
    const shapes = record.parameters.some((one) =>
        [one.tag, one.fields_of, ...(one.variants ?? []).map((variant) => variant.by)].includes(name),
    );
    const set = (value) => {
        values[name] = value;
        if (!shapes) return events.changed();
        for (const union of unionsOf(record, name)) values[union.member] = initialValue(protocol, union, record, values);
        events.reshaped();
    };
    if (type?.kind === "enum") return labelled(name, ...enumInput(type, values[name], set), note);
    if (type?.kind === "bitfield") return bitsInput(name, type, values[name], set);
    if (kind === "bool") {
        const control = element("input", { type: "checkbox", checked: Boolean(values[name]) });
        control.addEventListener("input", () => set(control.checked ? 1 : 0));
        return labelled(name, control, note);
    }
    if (!parameter.shown) return labelled(name, numberInput(values[name], kind, size, set), note);
    return labelled(name, ...hexInput(context, parameter, values[name], size, set), note);
}

/** The names of an enumeration, and any other number: enumerations are open. */
function enumInput(type, value, set) {
    const known = type.values.map((one) => [one.value, `${one.value} ${one.name}`]);
    const other = enumValue(type, value) ? undefined : value;
    const control = element(
        "select",
        {},
        [...known, ["other", "another number"]].map(([number, words]) =>
            element("option", { value: number, selected: other === undefined ? number === Number(value) : number === "other" }, words),
        ),
    );
    const number = element("input", {
        value: String(other ?? ""),
        hidden: other === undefined,
        "aria-label": "another number",
        spellcheck: "false",
    });
    control.addEventListener("input", () => {
        number.hidden = control.value !== "other";
        set(number.hidden ? Number(control.value) : numberOfText(number.value, "unsigned"));
    });
    number.addEventListener("input", () => set(numberOfText(number.value, "unsigned")));
    return [control, " ", number];
}

let lastList = 0; // for ids

/** A number that people know in hexadecimal, with the sets or fields to choose from, and what it means. */
function hexInput(context, parameter, value, size, set) {
    const control = element("input", { value: hexOf(value, size), spellcheck: "false", class: "mip-hex" });
    const { protocol, values, outer } = context;
    const choices = choicesOf(protocol, parameter, values, outer);
    const meaning = element("small", { class: "mip-meant" }, choices.get(Number(value)) ?? "");
    control.addEventListener("input", () => {
        const number = numberOfText(control.value, "unsigned");
        meaning.textContent = choices.get(Number(number)) ?? "";
        set(number);
    });
    if (!choices.size) return [control, meaning];
    const list = element(
        "datalist",
        { id: `mip-list-${++lastList}` },
        [...choices].map(([number, words]) => element("option", { value: hexOf(number, size) }, words)),
    );
    control.setAttribute("list", list.id);
    return [control, list, " ", meaning];
}

function hexOf(value, size) {
    return typeof value === "string" || Number.isNaN(value) ? String(value) : hexLiteral(value, size);
}

/** The switches of a record that a parameter selects. */
function unionsOf(record, tag) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op])).filter((op) => op.kind === "switch" && op.tag === tag);
}

function numberInput(value, kind, size, set) {
    const text = kind === "float" && typeof value === "number" ? decimal(value, size) : String(value);
    const control = element("input", { value: text, inputmode: kind === "float" ? "decimal" : "text", spellcheck: "false" });
    control.addEventListener("input", () => set(numberOfText(control.value, kind)));
    return control;
}

/** A number as people write it: 0x1F, 12, -0.5; of floats also the bits, 0x and as many digits as it has. */
function numberOfText(text, kind) {
    const trimmed = text.trim();
    if (kind === "float") return floatOfText(trimmed);
    if (/^-?(\d+|0x[0-9a-f]+)$/i.test(trimmed)) {
        const number = trimmed.startsWith("-") ? -BigInt(trimmed.slice(1)) : BigInt(trimmed);
        return Number.isSafeInteger(Number(number)) ? Number(number) : number;
    }
    return trimmed;
}

/** What is no number, or too large, stays a text, which is refused when it is encoded. */
function floatOfText(text) {
    const words = { nan: NaN, inf: Infinity, infinity: Infinity, "-inf": -Infinity, "-infinity": -Infinity };
    if (Object.hasOwn(words, text.toLowerCase())) return words[text.toLowerCase()];
    const number = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN;
    return Number.isFinite(number) ? number : text;
}

/** The whole number, and an input for each name in it. */
function bitsInput(name, type, value, set) {
    let number = bitsNumber(value);
    const whole = element("input", { spellcheck: "false" });
    const named = type.bits.map((bits) => {
        const flag = bits.first === bits.last;
        const control = element("input", { type: flag ? "checkbox" : "number", min: flag ? undefined : 0 });
        control.addEventListener("input", () => {
            const held = flag ? Number(control.checked) : Math.max(0, Math.trunc(Number(control.value)));
            change((number & ~maskOf(bits)) | ((BigInt(held) << BigInt(bits.first)) & maskOf(bits)));
        });
        return { bits, flag, control };
    });
    const showAll = () => {
        for (const { bits, flag, control } of named) {
            const held = (number & maskOf(bits)) >> BigInt(bits.first);
            if (flag) control.checked = held === 1n;
            else control.value = held;
        }
    };
    const change = (changed) => {
        number = changed;
        whole.value = hexLiteral(number);
        showAll();
        set(number);
    };
    whole.addEventListener("input", () => {
        const given = numberOfText(whole.value, "unsigned");
        if (typeof given === "string" || Number.isNaN(given)) return set(given);
        number = BigInt(given);
        showAll();
        set(number);
    });
    whole.value = hexLiteral(number);
    showAll();
    const controls = named.map(({ bits, control }) => labelled(bits.name, control, " ", element("small", {}, bits.description)));
    return group(name, type.description, [labelled("value", whole), ...controls]);
}

/** The bytes of a bitfield of bytes; what is no number, or too large, is an error when it is encoded. */
function littleEndian(number, size) {
    if (typeof number !== "bigint" || number < 0n || number >> BigInt(8 * size)) return [number];
    return Array.from({ length: size }, (_, i) => Number((number >> BigInt(8 * i)) & 0xffn));
}

/** Vectors and arrays: their elements; those of an array that is counted can be added and removed. */
function arrayInput(context, op, parameter, hint) {
    const { protocol, values, events } = context;
    const items = values[op.member];
    const record = { parameters: [{ ...parameter, name: op.item.member, default: undefined, cases: undefined }], operations: [op.item] };
    const names = op.vector && parameter.elements;
    const rows = items.map((_, i) => {
        const holder = {
            get [op.item.member]() {
                return items[i];
            },
            set [op.item.member](value) {
                items[i] = value;
            },
        };
        const variants = parameter.variants?.filter((one) => one.type); // units are those of the element already
        const one = { ...record.parameters[0], description: "", units: [unitOf(parameter, i)], variants };
        if (Object.hasOwn(values, one.fields_of ?? "")) holder[one.fields_of] = values[one.fields_of];
        const [control] = input(
            { ...context, values: holder, record: { ...record, parameters: [one] }, outer: { parameter, values } },
            op.item,
        );
        const label = control.querySelector(":scope > label, :scope > legend");
        label.textContent = `${names?.[i] ?? `${op.member}[${i}]`} `;
        return control;
    });
    if (op.count !== undefined) return group(op.member, hint, rows);
    const add = () => {
        items.push(items.length ? structuredClone(items.at(-1)) : initialValue(protocol, op.item, record, {}));
        events.reshaped();
    };
    const remove = () => {
        items.pop();
        events.reshaped();
    };
    const buttons = element(
        "p",
        {},
        element("button", { type: "button", onclick: add, disabled: items.length >= op.capacity }, `Add to ${op.member}`),
        " ",
        element("button", { type: "button", onclick: remove, disabled: items.length === 0 }, "Remove the last"),
    );
    return group(op.member, hint, [...rows, buttons]);
}

function group(name, hint, controls) {
    return element("fieldset", {}, element("legend", {}, name), hint && element("small", {}, hint), controls);
}

// ------------------------------------------------------------------------------------------------ result

/** The packet, or the error that says why there is none. */
function built(protocol, { set, entries }) {
    try {
        return packetOf(protocol, set, entries);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { error };
    }
}

function report(protocol, { entries }, packet, to) {
    if (packet.error) return [element("p", { class: "mip-wrong" }, `${packet.error.message}.`)];
    const sources = LANGUAGES.map(([key, title]) => [
        element("dt", {}, title),
        element("dd", {}, element("code", { "data-language": key }, sourceOf(packet.bytes, key))),
    ]);
    const title =
        entries.length === 1
            ? [to.field(entries[0].field), ` ${descriptorOf(entries[0].field)}`]
            : [`A packet of ${entries.length} fields`];
    return [
        element("h2", {}, ...title),
        element("p", { class: "mip-bytes" }, element("code", { class: "mip-packet-bytes" }, spacedHex(packet.bytes))),
        element("p", {}, `${packet.bytes.length} bytes; the checksum is ${spacedHex(packet.checksum)}.`),
        ...entries.flatMap((entry) => entryReport(protocol, entry, entries.length > 1, to)),
        element("h3", {}, "The packet in source code"),
        element("dl", { class: "mip-bytes" }, sources),
    ];
}

/** The programs of a field, and what it is answered with. */
function entryReport(protocol, { field, values }, several, to) {
    const heading = several ? [element("h2", {}, to.field(field))] : [];
    const answer = field.role === "command" && field.sent_by !== "device" ? answerReport(protocol, field, values, to) : [];
    return [...heading, ...programs(protocol, field, values), ...answer];
}

function programs(protocol, field, values) {
    if (field.role === "response") return [];
    const shown = LANGUAGES.map(([key, title]) => {
        const text = programText(protocol, key, field, values);
        const code = element("pre", {}, element("code", { "data-program": key }, text));
        return element("details", { open: key === "python" }, element("summary", {}, title), code);
    });
    const given =
        field.role === "command"
            ? "Each assumes an open `device`."
            : "C has a `field` of a packet, Python an open `device`, Rust a `packet`.";
    return [
        element("h3", {}, field.role === "command" ? "Programs that send it" : "Programs that read it"),
        element("p", {}, given.replaceAll("`", "")),
        ...shown,
    ];
}

function programText(protocol, language, field, values) {
    try {
        return programOf(protocol, language, field, [counted(protocol, allOperations(field), values)]);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return `${error.message}.`;
    }
}

function answerReport(protocol, field, values, to) {
    const { silent, acknowledge, responses, conditions } = answerOf(protocol, field, values);
    const unless = conditions.length ? ` There is no answer if ${conditions.join(" or ")}.` : "";
    if (silent) return [element("h3", {}, "Answer"), element("p", { class: "mip-answer" }, silent)];
    const listed = responses.map(({ field: response, when, packet }) =>
        element(
            "li",
            { "data-field": response.name },
            to.field(response),
            ` ${descriptorOf(response)}, ${sizeText(response)}`,
            when && `, if ${when}`,
            element("br", {}),
            "for example ",
            element("code", { class: "mip-bytes" }, spacedHex(packet.bytes)),
            layoutTable(response),
        ),
    );
    return [
        element("h3", {}, "Answer"),
        element(
            "p",
            { class: "mip-answer" },
            listed.length ? "The acknowledge, directly followed by a response in the same packet:" : "The acknowledge: ",
            !listed.length && element("code", {}, spacedHex(acknowledge.bytes)),
            !listed.length && unless,
        ),
        listed.length > 0 && element("ul", {}, listed),
        listed.length > 0 && unless && element("p", {}, unless),
        element("p", {}, "A refusal is an acknowledge with another code, without a response."),
    ].filter(Boolean);
}

/** The parameters of a response, in order. */
function layoutTable(response) {
    const rows = response.parameters.map((parameter) => {
        const many = parameter.length === undefined ? "" : `[${parameter.length}]`;
        const cells = [parameter.name, `${parameter.type ?? "union"}${many}`, unitOf(parameter), parameter.description ?? ""];
        return element(
            "tr",
            {},
            cells.map((cell) => element("td", {}, cell)),
        );
    });
    if (!rows.length) return "";
    const heading = element(
        "tr",
        {},
        ["Name", "Type", "Unit", "Description"].map((cell) => element("th", {}, cell)),
    );
    return element(
        "details",
        {},
        element("summary", {}, "Layout"),
        element("div", { class: "mip-scroll" }, element("table", {}, heading, rows)),
    );
}

function sizeText({ min_size: least, max_size: most }) {
    return least === most ? `${least + 2} bytes` : `${least + 2} to ${most + 2} bytes`;
}

return { builder, numberOfText };
})();

// ---------------------------------------------------------------------------------------------------- tools/bandwidth.mjs

modules["tools/bandwidth"] = (() => {
// Bandwidth: choose data fields and rates, and see which baud rate they need.

const { certaintyOn } = modules["tools/build"];
const { element, links, mark, profileNote } = modules["tools/dom"];
const { needOf, portsFor, streamsOf } = modules["tools/stream"];
const { descriptorOf, hexByte } = modules["tools/words"];

/** Decimations have two bytes. */
const MOST = 0xffff;

/**
 * Fills an element with the tool. `options` are those of `links`, and `device`, the id of the one to begin with. If it is
 * given, the fragment of the address follows the choice.
 */
function bandwidth(root, protocol, options = {}) {
    const to = links(options);
    const device = element(
        "select",
        { id: "mip-stream-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id, selected: one.id === options.device }, one.title)),
    );
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    const note = element("div", { role: "status" });
    const list = element("div");
    let rows = [];
    const kept = new Map(); // rates that were chosen, also of what the present device does not have
    const chosen = () => protocol.model.devices.find((one) => one.id === device.value);
    const show = () => output.replaceChildren(...report(chosen(), rows));
    const layOut = () => {
        for (const row of rows.flat()) {
            if (row.box.checked && !row.problem()) kept.set(row.box.id, row.rate());
            else kept.delete(row.box.id);
        }
        const streams = streamsOf(protocol, chosen());
        const certainty = (field) => certaintyOn(protocol, chosen(), field);
        rows = streams.map((stream) => stream.fields.map((field) => streamRow(field, stream, certainty(field), show, to)));
        for (const row of rows.flat()) if (kept.has(row.box.id)) row.choose(kept.get(row.box.id));
        note.replaceChildren(...[profileNote(chosen())].filter(Boolean));
        list.replaceChildren(...streams.map((stream, i) => streamTable(stream, rows[i])));
        show();
    };
    device.addEventListener("input", () => {
        layOut();
        if (options.device !== undefined) history.replaceState(history.state, "", `#${encodeURIComponent(device.value)}`);
    });
    root.replaceChildren(element("p", {}, element("label", { for: "mip-stream-device" }, "Device "), device), note, output, list);
    layOut();
}

function streamTable({ set, base }, rows) {
    const rate = base ? `base rate ${base} Hz` : base === 0 ? "sent as it arrives" : "base rate not known";
    const heads = ["Field", "Bytes", base ? "Decimation" : "Rate in Hz", "Rate"].map((text) => element("th", { scope: "col" }, text));
    return element(
        "details",
        { "data-set": set.name, open: rows.some(({ box }) => box.checked) },
        element("summary", {}, `${set.title} (${hexByte(set.number)}), ${rate}`),
        element(
            "div",
            { class: "mip-scroll" },
            element(
                "table",
                {},
                element("thead", {}, element("tr", {}, heads)),
                element(
                    "tbody",
                    {},
                    rows.map(({ line }) => line),
                ),
            ),
        ),
    );
}

/** A line of the table; `rate` is that of the field, `problem` says why there is none, and `choose` sets it. */
function streamRow(field, { set, base }, certainty, show, to) {
    const id = `mip-stream-${set.name}-${field.name}`;
    const box = element("input", { type: "checkbox", id });
    const number = element("input", {
        type: "number",
        min: base ? 1 : 0,
        max: base ? MOST : undefined,
        step: base ? 1 : "any",
        value: base ? 10 : 1,
        required: true,
        "aria-label": `${base ? "decimation" : "rate in Hz"} of ${field.title}`,
    });
    const text = element("td", { class: "mip-rate" });
    const row = {
        field,
        box,
        rate: () => (base ? base / Number(number.value) : Number(number.value)),
        problem() {
            if (number.validity.valid && Number(number.value) > 0) return undefined;
            return base ? `a whole number from 1 to ${MOST}` : "a number above 0";
        },
        choose(rate) {
            box.checked = true;
            number.value = base ? Math.min(MOST, Math.max(1, Math.round(base / rate))) : rate;
            tell();
        },
    };
    const tell = () => {
        const problem = row.problem();
        text.textContent = problem ?? `${Number(row.rate().toPrecision(6))} Hz`;
        text.classList.toggle("mip-wrong", Boolean(problem));
    };
    const changed = () => {
        tell();
        show();
    };
    for (const control of [box, number]) control.addEventListener("input", changed);
    tell();
    const label = element("label", { for: id }, ` ${descriptorOf(field)} ${field.title}${mark(certainty)}`);
    row.line = element(
        "tr",
        { "data-field": field.name },
        element("td", {}, box, label, " ", to.field(field, "page")),
        element("td", {}, `${field.max_size + 2}`),
        element("td", {}, number),
        text,
    );
    return row;
}

function report(device, rows) {
    const chosen = rows.map((set) => set.filter(({ box }) => box.checked));
    const wrong = chosen.flat().find((row) => row.problem());
    if (wrong) return [element("p", { class: "mip-wrong" }, `${wrong.field.title} needs ${wrong.problem()}.`)];
    const { bytes, baud } = needOf(chosen.map((set) => set.map(({ field, rate }) => ({ field, rate: rate() }))));
    if (!bytes) return [element("p", { class: "mip-note" }, "Choose fields below.")];
    const ports = portsFor(device, baud).map(({ port, rate }) => {
        const words = rate === null ? "no baud rate" : (rate ?? "none of its baud rates is enough");
        return element("tr", { "data-port": port.name }, element("td", {}, port.name), element("td", {}, `${words}`));
    });
    const heads = ["Port", "Smallest baud rate"].map((text) => element("th", { scope: "col" }, text));
    return [
        element(
            "p",
            { class: "mip-need" },
            `${round(bytes)} byte${round(bytes) === 1 ? "" : "s"}/s; over a UART at least ${round(baud)} Bd.`,
        ),
        ports.length > 0 && element("table", {}, element("thead", {}, element("tr", {}, heads)), element("tbody", {}, ports)),
        element("p", {}, "Leave room for the answers to commands. A device drops the packets that do not fit."),
    ].filter(Boolean);
}

/** Rounded up: a rate that is a little too low is too low. */
function round(number) {
    return Math.ceil(Number(number.toFixed(6)));
}

return { bandwidth };
})();

// ---------------------------------------------------------------------------------------------------- tools/index.mjs

modules["tools/index"] = (() => {
// The tools for the browser.

const { bandwidth } = modules["tools/bandwidth"];
const { answerOf, initialValues, packetOf, typicalValues } = modules["tools/build"];
const { builder } = modules["tools/builder"];
const { programOf } = modules["tools/code"];
const { fragment } = modules["tools/dom"];
const { find, indexOf, packetIn } = modules["tools/find"];
const { finder } = modules["tools/finder"];
const { bytesOfText } = modules["tools/input"];
const { inspect } = modules["tools/inspect"];
const { inspector } = modules["tools/inspector"];
const { needOf, portsFor, streamsOf } = modules["tools/stream"];
const { descriptorOf } = modules["tools/words"];

return { bandwidth, answerOf, initialValues, packetOf, typicalValues, builder, programOf, fragment, find, indexOf, packetIn, finder, bytesOfText, inspect, inspector, needOf, portsFor, streamsOf, descriptorOf };
})();

globalThis.mip = { ...modules["mip/index"], ...modules["tools/index"], };
})();
