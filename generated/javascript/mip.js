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
    for (const byte of bytes) {
        a = (a + byte) & 0xff;
        b = (b + a) & 0xff;
    }
    return Uint8Array.of(a, b);
}

/** "7565", or with a separator "75 65". */
function toHex(bytes, between = "") {
    return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join(between);
}

/** The bytes of hexadecimal digits without anything between them. */
function fromHex(text) {
    if (!/^([0-9a-f]{2})*$/i.test(text)) throw new MipError("hex", "the text is not an even number of hexadecimal digits");
    return Uint8Array.from(text.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16));
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

/** The bytes of a number, a BigInt or a Boolean. */
function writeInteger(value, size, signed, what) {
    let number;
    try {
        number = BigInt(value);
    } catch {
        throw new MipError("range", `${what}: ${value} is not a whole number`);
    }
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
            throw new MipError("range", `${what}: "${value}" is not 0x and ${2 * size} hexadecimal digits`);
        }
        return fromHex(value.slice(2));
    }
    if (typeof value !== "number") throw new MipError("range", `${what}: ${value} is not a number`);
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
    return Uint8Array.from(text, (character) => {
        const code = character.codePointAt(0);
        if (code > 0xff) throw new MipError("range", `${what}: "${character}" is not a character of Latin-1`);
        return code;
    });
}

return { MipError, checksum, toHex, fromHex, concatenated, sameBytes, readInteger, writeInteger, readFloat, floatBits, writeFloat, readText, writeText };
})();

// ---------------------------------------------------------------------------------------------------- mip/protocol.mjs

modules["mip/protocol"] = (() => {
// The model of the protocol: what is in mip.json, found by name and by descriptor.

const { MipError } = modules["mip/bytes"];

/** Descriptor set of the fields that are valid in every data set. */
const SHARED_SET = 255;

/** Data sets have this number or a larger one; below are command sets. */
const FIRST_DATA_SET = 128;

/** The first number of the form of mip.json that this code knows. */
const FORMAT = "1";

class Protocol {
    /** @param model the parsed mip.json */
    constructor(model) {
        if (String(model?.format).split(".")[0] !== FORMAT) {
            throw new MipError("format", `the model has format ${model?.format}; this code knows ${FORMAT}`);
        }
        this.model = model;
        this.sync = model.packet.sync;
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
    choose(set, descriptor, data) {
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
    if (!thing) throw new MipError("unknown", `there is no ${what} "${name}"`);
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

const { MipError, concatenated, floatBits, readFloat, readInteger, readText, writeFloat, writeInteger, writeText } = modules["mip/bytes"];

/**
 * The values of a field, how many bytes are left over, and `parts`: each value that is not divided further, in wire order,
 * with its path (names and indices), its operation, and where its bytes are in the data (offset and size).
 *
 * @param options.floatBits every float is the text of its bits, "0x3e7a63a0"
 */
function decodeData(protocol, field, data, options = {}) {
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

/** The data of a field with these values, in the shortest form that holds them. */
function encodeData(protocol, field, values) {
    const writer = new Writer(protocol);
    refuseUnknown(values, field.parameters, field.name);
    let required = protocol.required(field);
    let ended; // the first parameter that was left out: all behind it must be, too
    for (const op of field.operations) {
        if (op.kind !== "group") {
            writer.write(op, values);
            continue;
        }
        if (op.first === 1 && field.calls) required = protocol.required(field, values.function);
        const members = op.body.filter((inner) => inner.kind !== "constant").map((inner) => inner.member);
        const absent = members.find((name) => !Object.hasOwn(values, name));
        if (absent !== undefined && op.last <= required) throw missing(absent);
        ended ??= absent;
        if (ended === undefined) {
            for (const inner of op.body) writer.write(inner, values);
        } else if (members.some((name) => Object.hasOwn(values, name))) {
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

    write(op, values) {
        if (op.kind === "constant") {
            this.number(op, op.value);
        } else if (!Object.hasOwn(values, op.member)) {
            throw missing(op.member);
        } else {
            this.put(op, values[op.member], values);
        }
    }

    put(op, value, values) {
        switch (op.kind) {
            case "scalar":
                this.number(op, value);
                break;
            case "counter":
                if (values[op.array]?.length !== Number(value)) {
                    throw new MipError("count", `${op.member} is ${value}, but ${op.array} has another number of elements`);
                }
                this.number(op, value);
                break;
            case "bits":
                if (value.length !== op.size) throw new MipError("count", `${op.member} needs ${op.size} bytes`);
                for (const byte of value) this.parts.push(writeInteger(byte, 1, false, op.member));
                break;
            case "text":
                checkCount(op, value);
                this.parts.push(writeText(value, op.member));
                break;
            case "array":
                checkCount(op, value);
                for (const item of value) this.put(op.item, item, {});
                break;
            case "struct": {
                const struct = this.protocol.type(op.struct);
                refuseUnknown(value, struct.parameters, struct.name);
                for (const part of struct.operations) this.write(part, value);
                break;
            }
            case "switch": {
                const selected = selectedBy(op, values);
                const wanted = selected ? [selected.member] : [];
                const there = Object.keys(value);
                if (there.length !== wanted.length || there[0] !== wanted[0]) {
                    const right = wanted[0] ?? "nothing";
                    throw new MipError("tag", `${op.tag} is ${values[op.tag]}, so ${op.member} must hold ${right}`);
                }
                if (selected) this.write(selected, value);
                break;
            }
            default:
                throw new MipError("format", `the operation "${op.kind}" is not known`);
        }
    }

    number(op, value) {
        const { size, kind } = this.protocol.scalar(op.scalar);
        const write = kind === "float" ? writeFloat : (number, width, what) => writeInteger(number, width, kind === "signed", what);
        this.parts.push(write(value, size, op.member));
    }
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

function checkCount(op, value) {
    if (value.length !== (op.count ?? value.length) || value.length > op.capacity) {
        const right = op.count ?? `at most ${op.capacity}`;
        throw new MipError("count", `${op.member} has ${value.length} elements, not ${right}`);
    }
}

return { decodeData, encodeData };
})();

// ---------------------------------------------------------------------------------------------------- mip/packet.mjs

modules["mip/packet"] = (() => {
// Packets: their frame, their fields, and building them.

const { MipError, checksum, concatenated, fromHex, sameBytes, toHex } = modules["mip/bytes"];
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
    static from(protocol, bytes) {
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
 * and `values`. Raises a MipError if something does not fit.
 */
function buildPacket(protocol, set, fields) {
    if (!(set > 0 && set < SHARED_SET)) throw new MipError("set", `no packet has descriptor set ${set}`);
    const parts = fields.flatMap((entry) => {
        const data = entry.raw === undefined ? dataOf(protocol, set, entry) : bytesOf(entry.raw);
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
    if (!field) throw new MipError("unknown", `set ${set} has no field ${name} with descriptor ${descriptor}`);
    return encodeData(protocol, field, values);
}

function bytesOf(raw) {
    return typeof raw === "string" ? fromHex(raw) : raw;
}

return { Packet, buildPacket };
})();

// ---------------------------------------------------------------------------------------------------- mip/parser.mjs

modules["mip/parser"] = (() => {
// Finds packets in a stream, among anything else.

const { concatenated } = modules["mip/bytes"];
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

    /** The packets that are complete with these bytes. */
    feed(bytes) {
        this.pending = concatenated(this.pending, bytes);
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
function segments(protocol, bytes) {
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
    for (let at = 0; at < bytes.length;) {
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
        record = type?.kind === "struct" ? type : parameter.cases ? { parameters: parameter.cases.flatMap((one) => one.parameter ?? []) } : record;
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
    const variant = (parameter.variants ?? []).find(
        (one) =>
            one.type &&
            !one.member &&
            (one.by === "device" ? one.key === device : one.value === Number(siblings?.[one.by])),
    );
    return protocol.types.get(variant?.type ?? parameter.type);
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

return { parameterOf, parametersAt, valueAt, namedType, enumValue, bitsNumber, maskOf, bitsOf, unitOf };
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

const { concatenated } = modules["mip/bytes"];

// A line of a hex dump: an offset, bytes, and what they look like. What begins with the sync bytes has no offset.
const DUMP_LINE = /^\s*(?:0x)?(?:[0-9a-f]{4,8}:\s*|(?!7565)[0-9a-f]{4,8}\s{2,})((?:[0-9a-f]{2,4}[ \t]+)*[0-9a-f]{2,4})(?:\s{2,}.*|\s*\|.*)?\s*$/i;

// What bytes are written as, in the order in which it is looked for; words that begin with digits are not.
const TOKEN = new RegExp(
    [
        /\bb"((?:[^"\\]|\\.)*)"|\bb'((?:[^'\\]|\\.)*)'/, // b"ue\x0c" of Python
        /((?:\\x[0-9a-f]{2})+)/, // \x75\x65
        /\b0x([0-9a-f]+)\b/, // 0x75, 0x7565
        /(?<![\w.])((?:[0-9a-f]{2})+)h?(?!\w|\.\d)/, // 75, 7565, 75h
    ]
        .map((one) => one.source)
        .join("|"),
    "gi",
);

const ESCAPES = { n: 10, r: 13, t: 9, 0: 0, a: 7, b: 8, f: 12, v: 11, "\\": 92, "'": 39, '"': 34 };

/** The bytes of a text, and the pieces of text between them that are no bytes, such as words. */
function bytesOfText(text) {
    const parts = [];
    const ignored = [];
    for (const line of text.split(/\r?\n/)) {
        const bytes = DUMP_LINE.exec(line)?.[1] ?? line;
        let at = 0;
        for (const match of bytes.matchAll(TOKEN)) {
            ignored.push(bytes.slice(at, match.index));
            at = match.index + match[0].length;
            parts.push(bytesOfToken(match));
        }
        ignored.push(bytes.slice(at));
    }
    return {
        bytes: concatenated(...parts),
        ignored: ignored.map((piece) => piece.replace(/^[\s,;:|{}[\]()<>"'-]+|[\s,;:|{}[\]()<>"'-]+$/g, "")).filter(Boolean),
    };
}

function bytesOfToken([, double, single, escaped, number, digits]) {
    const literal = double ?? single;
    if (literal !== undefined) return bytesOfLiteral(literal);
    const hex = escaped ? escaped.replace(/\\x/g, "") : (number ?? digits);
    const even = hex.length % 2 ? `0${hex}` : hex;
    return Uint8Array.from(even.match(/../g), (pair) => Number.parseInt(pair, 16));
}

function bytesOfLiteral(text) {
    const found = [];
    for (const [whole, hex, escape] of text.matchAll(/\\x([0-9a-f]{2})|\\([^x])|[^\\]/gis)) {
        if (hex !== undefined) found.push(Number.parseInt(hex, 16));
        else found.push(escape === undefined ? whole.charCodeAt(0) & 0xff : (ESCAPES[escape] ?? escape.charCodeAt(0)));
    }
    return Uint8Array.from(found);
}

return { bytesOfText };
})();

// ---------------------------------------------------------------------------------------------------- tools/words.mjs

modules["tools/words"] = (() => {
// How things of the protocol are shown: numbers, names and places.

const { toHex } = modules["mip/bytes"];
const { bitsOf, enumValue, unitOf } = modules["mip/names"];

function hexByte(number) {
    return `0x${number.toString(16).toUpperCase().padStart(2, "0")}`;
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

/** The path of a value: "descriptors[0].rate"; elements of vectors have names. */
function pathText(protocol, parameters, path) {
    let text = "";
    let next = 0;
    let items; // of the last parameter: its length, and the names of its elements
    for (const step of path) {
        if (typeof step !== "number") {
            const { parameter } = parameters[next++] ?? {};
            const type = protocol.types.get(parameter?.type);
            items = { array: parameter?.length !== undefined, elements: type?.kind === "vector" ? type.elements : undefined };
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
        const text = Array.isArray(value) ? spacedHex(value) : `0x${value.toString(16).toUpperCase().padStart(2 * size, "0")}`;
        return { text, flags: rest ? [...flags, { rest }] : flags, unit };
    }
    return { text: `${value}`, unit };
}

/** "fix_valid", "quality = 3", or "state = ready". */
function flagText({ bits, value, flag, named, rest }) {
    if (rest !== undefined) return `0x${rest.toString(16).toUpperCase()} has no name`;
    return flag && !named ? bits.name : `${bits.name} = ${named?.name ?? value}`;
}

/** "mode is fast"; of another command, "mode of base.echo_control is fast". */
function conditionText({ parameter, label, command }) {
    return `${parameter}${command ? ` of ${command}` : ""} is ${label}`;
}

return { hexByte, spacedHex, descriptorOf, decimal, pathText, shown, flagText, conditionText };
})();

// ---------------------------------------------------------------------------------------------------- tools/inspect.mjs

modules["tools/inspect"] = (() => {
// What bytes mean: packets, fields and values, with names, units and verdicts. The inspector shows it.

const { fromHex, sameBytes } = modules["mip/bytes"];
const { namedType, parametersAt, valueAt } = modules["mip/names"];
const { Packet } = modules["mip/packet"];
const { segments } = modules["mip/parser"];
const { bytesOfText } = modules["tools/input"];
const { pathText, shown } = modules["tools/words"];

/**
 * What a text of bytes consists of, each part as `segments` gives it; packets also have `set`, `fields`, `misprints`, and
 * the checksum that is right.
 *
 * @param device the id of a device, whose readings are used where they differ
 */
function inspect(protocol, text, device = undefined) {
    const { bytes, ignored } = bytesOfText(text);
    return { bytes, ignored, parts: segments(protocol, bytes).map((part) => inspectPart(protocol, part, device)) };
}

function inspectPart(protocol, part, device) {
    if (part.kind === "other") return part;
    const packet = new Packet(protocol, part.kind === "incomplete" ? completed(part.bytes) : part.bytes);
    const set = protocol.sets.get(part.bytes[2]);
    const fields = packet.decode().map((raw) => inspectField(protocol, raw, packet, part, device));
    const verdict =
        part.kind === "incomplete" ? {} : { sound: packet.sound, checksum: packet.checksum, rightChecksum: packet.rightChecksum };
    return { ...part, set, fields: fields.filter(Boolean), misprints: misprintsOf(protocol, part.bytes), ...verdict };
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
    const { parameter } = parameters.at(-1);
    const names = part.path.length - 1 - [...part.path].reverse().findIndex((step) => typeof step !== "number");
    const siblings = valueAt(values, part.path.slice(0, names));
    const type = namedType(protocol, parameter, siblings, device);
    const index = part.path.slice(names + 1).at(-1);
    return {
        path: pathText(protocol, parameters, part.path),
        bytes: data.subarray(part.offset, part.offset + part.size),
        value: part.value,
        parameter,
        type,
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
 * Where the reference has things. `options.fieldPage`, `options.acknowledgePage` and `options.erratumPage` are addresses
 * with {set}, {page}, {field} and {id} in them; without one, there are no links. A response is on the page of its command.
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
    };
}

function link(href, words) {
    return href ? element("a", { href }, ...words) : element("span", {}, ...words);
}

/** Calls a function when the user has changed something. */
function whenChanged(inputs, update) {
    for (const input of inputs) input.addEventListener("input", update);
}

return { element, links, whenChanged };
})();

// ---------------------------------------------------------------------------------------------------- tools/find.mjs

modules["tools/find"] = (() => {
// Finds fields by what people know of them: a descriptor, a name, a symbol, a word.

const { hexByte } = modules["tools/words"];

// Where a word is found counts: the smaller, the better.
const EXACT = 0;
const BEGINNING = 1;
const TITLE = 2;
const WORDS = 3;
const PARTS = 4;
const TEXT = 5;
const PLACES = [TITLE, WORDS, PARTS, TEXT];

/** An index of all fields, for `find`. */
function indexOf(protocol) {
    const synonyms = synonymsOf(protocol.model.vocabulary);
    const commands = new Map();
    for (const field of protocol.model.fields) for (const name of field.responses ?? []) commands.set(name, field);
    return { protocol, synonyms, entries: protocol.model.fields.map((field) => entryOf(protocol, field, commands)) };
}

/**
 * The fields that a text may mean, the best first, at most `limit` of them. A text is a descriptor in any form ("0x0D13",
 * "82 10", "(0x82,0x10)", "0x82"), a name, a symbol of C, Python or Rust, a name of the vendor, or words.
 */
function find(index, text, limit = 20) {
    const query = text.trim();
    if (!query) return [];
    const ranks = new Map();
    for (const { field, rank } of byDescriptor(index, query)) ranks.set(field, rank);
    const squashed = squash(query);
    const words = [...new Set(wordsOf(query))];
    for (const entry of index.entries) {
        const rank = Math.min(rankOfSymbol(entry, squashed), rankOfWords(entry, words, index.synonyms));
        if (rank < Infinity && !ranks.has(entry.field)) ranks.set(entry.field, rank);
    }
    const order = ({ field, rank }) => (rank < EXACT ? [rank] : [rank, entryRank(field), field.name.length]);
    const found = [...ranks].map(([field, rank]) => ({ field, rank }));
    return found.sort((a, b) => compared(order(a), order(b))).slice(0, limit);
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

const PAIR = /^[([{]*\s*(?:0x)?([0-9a-f]{2})(?:\s*[\s,:;/.-]\s*(?:0x)?|(?:0x)?)([0-9a-f]{2})h?\s*[)\]}]*$/i;
const SINGLE = /^[([{]*\s*(?:0x([0-9a-f]{1,2})|([0-9a-f]{2})h?)\s*[)\]}]*$/i;

function byDescriptor({ protocol }, query) {
    const pair = PAIR.exec(query);
    if (pair) {
        const [set, descriptor] = [pair[1], pair[2]].map((digits) => Number.parseInt(digits, 16));
        return protocol.candidates(set, descriptor).map((field) => ({ field, rank: EXACT - 3 }));
    }
    const single = SINGLE.exec(query);
    if (!single) return [];
    const number = Number.parseInt(single[1] ?? single[2], 16);
    return protocol.model.fields
        .filter((field) => field.set === number || field.descriptor === number)
        .map((field) => ({ field, rank: field.set === number ? EXACT - 2 : EXACT - 1 }));
}

// ------------------------------------------------------------------------------------------------ names

/** Letters and digits alone: symbols of all languages look alike then. */
function squash(text) {
    return text.toLowerCase().replace(/[^a-z0-9]+/g, "");
}

function wordsOf(text) {
    return text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
}

/** All words of some texts, with a space before and behind each. */
function spaced(...texts) {
    return ` ${[...new Set(wordsOf(texts.join(" ")))].join(" ")} `;
}

function entryOf(protocol, field, commands) {
    const [set, name] = field.name.split(".");
    const also = field.also ?? [];
    const keywords = field.keywords ?? [];
    const symbols = Object.values(field.symbols);
    const short = symbols.map((symbol) => symbol.replace(/^mip_protocol(\.|::)/, ""));
    const names = [field.name, name, field.title, ...also, ...also.flatMap((one) => [`${set}.${one}`, `mip.${set}.${one}`]), ...keywords, ...symbols, ...short];
    const types = field.parameters.flatMap((parameter) => partsOf(protocol, parameter));
    const sections = field.sources.map((source) => source.section);
    const asked = commands.get(field.name);
    return {
        field,
        squashed: [...new Set(names.map(squash))],
        words: {
            [TITLE]: spaced(field.title, name, ...also, ...keywords),
            [WORDS]: spaced(set, protocol.sets.get(field.set)?.title ?? "", field.title, name, ...also, ...keywords, ...sections),
            [PARTS]: spaced(...types.map((one) => one.name)),
            [TEXT]: spaced(field.description, asked?.description ?? "", ...types.map((one) => one.description ?? "")),
        },
    };
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

return { indexOf, find, kindOf };
})();

// ---------------------------------------------------------------------------------------------------- tools/build.mjs

modules["tools/build"] = (() => {
// What the builder knows of a packet with one field: values to begin with, bytes, source code, and the answer.

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

/** Values to begin with: the function selector, then factory defaults and reserved values where there are any, else 0. */
function initialValues(protocol, field, selector) {
    const values = {};
    for (const op of requiredOperations(protocol, field, selector)) begin(protocol, op, field, values);
    if (field.calls) values.function = selector;
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
                return one === undefined ? initialValue(protocol, op.item, inner, {}) : numberOf(protocol, op.item, parameter, one, {});
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
            return numberOf(protocol, op, parameter, given ?? firstOf(protocol, op, parameter, values), values);
    }
}

function firstOf(protocol, op, parameter, values) {
    const type = namedType(protocol, parameter, values);
    if (type?.kind === "enum") return type.values[0].value;
    return Math.max(0, parameter.minimum ?? 0);
}

/** A number for a default: it may be the name of a value, or names of bits. */
function numberOf(protocol, op, parameter, given, values) {
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

/** The packet of a field with these values; raises a MipError that says what is wrong. */
function packetOf(protocol, field, set, values) {
    const all = counted(protocol, field.operations, values);
    return buildPacket(protocol, set, [{ descriptor: field.descriptor, name: field.name, values: all }]);
}

/**
 * What a command is answered with: `silent`, why there is no answer; `acknowledge`, the packet if nothing else
 * comes; `responses`, each with the field and the condition under which it is directly behind the acknowledge.
 */
function answerOf(protocol, field, values) {
    const call = field.calls ? protocol.functions.get(Number(values.function)) : undefined;
    const conditions = [...(field.silent_when ?? []), ...(field.silenced_by ?? [])].map(conditionText);
    if (call && !call.reply) return { silent: `The function ${call.name} is not answered.`, conditions, responses: [] };
    const asked = !call || call.responds ? (field.responses ?? []).map((name) => protocol.field(name)) : [];
    const { acknowledge } = protocol;
    const [command, code] = acknowledge.operations.map((op) => op.member);
    const packet = buildPacket(protocol, field.set, [
        { descriptor: acknowledge.descriptor, name: acknowledge.name, values: { [command]: field.descriptor, [code]: 0 } },
    ]);
    const responses = asked.map((response) => ({
        field: response,
        when: response.command === field.name ? (response.when ?? []).map(conditionText).join(" and ") : "",
    }));
    return { acknowledge: packet, responses, conditions };
}

/** The bytes as source code. */
function sourceOf(bytes, language) {
    const list = Array.from(bytes, hexByte).join(", ");
    const plain = Array.from(bytes, (byte) => `\\x${byte.toString(16).padStart(2, "0")}`).join("");
    return {
        c: `static const uint8_t packet[] = {${list}};`,
        python: `packet = b"${plain}"`,
        rust: `const PACKET: [u8; ${bytes.length}] = [${list}];`,
    }[language];
}

return { setsOf, requiredOperations, initialValues, initialValue, counted, packetOf, answerOf, sourceOf };
})();

// ---------------------------------------------------------------------------------------------------- tools/stream.mjs

modules["tools/stream"] = (() => {
// How much a port must carry for a stream of data fields.

const { SHARED_SET } = modules["mip/protocol"];

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
 * The data sets of a device with the fields that can be streamed in each, shared ones first, and the base rate, if it is
 * known. Without a device, all.
 */
function streamsOf(protocol, device) {
    const supported = device && new Set(device.supports?.map((support) => support.field));
    const rates = new Map(device?.base_rates?.map((rate) => [rate.set, rate.hertz]));
    const fieldsOf = (set) => (set?.fields ?? []).map((name) => protocol.field(name)).filter((field) => !supported || supported.has(field.name));
    const shared = fieldsOf(protocol.sets.get(SHARED_SET));
    return protocol.model.sets
        .filter((set) => set.kind === "data" && set.number !== SHARED_SET)
        .map((set) => ({ set, base: rates.get(set.name) || undefined, own: fieldsOf(set) }))
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
        element("p", {}, element("label", { for: "mip-bytes" }, "Bytes in hexadecimal: dumps, arrays or strings; there may be other bytes between packets")),
        input,
        element("p", {}, element("label", { for: "mip-device" }, "Values as on "), device),
        output,
    );
    whenChanged([input, device], update);
    update();
    return { update, input, output };
}

function report({ bytes, ignored, parts }, to) {
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

function otherBytes({ bytes }) {
    const text = Array.from(bytes, (byte) => (byte >= 32 && byte < 127 ? String.fromCharCode(byte) : "·")).join("");
    return element(
        "section",
        { class: "mip-other", "data-kind": "other" },
        element("p", {}, `${count(bytes.length, "byte")} outside packets: `, element("code", {}, spacedHex(bytes)), ` ${text}`),
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

function valueRow({ bytes, path, text, unit, name, meaning, flags, parameter }) {
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
        element("td", {}, shownFlags?.length ? shownFlags : flags ? "none set" : (meaning ?? parameter.description ?? "")),
    );
}

return { inspector };
})();

// ---------------------------------------------------------------------------------------------------- tools/finder.mjs

modules["tools/finder"] = (() => {
// The finder: type what you know of a field, and go to its page.

const { element, links } = modules["tools/dom"];
const { find, indexOf, kindOf } = modules["tools/find"];

/** Fills an element with the finder. `options` are those of `links`, and `text`, what is looked for at first. */
function finder(root, protocol, options = {}) {
    const to = links(options);
    const index = indexOf(protocol);
    const input = element("input", { type: "search", id: "mip-find", autocomplete: "off", spellcheck: "false", value: options.text });
    const output = element("ul", { class: "mip-results", "aria-live": "polite" });
    const update = () => {
        const found = find(index, input.value);
        const nothing = input.value.trim() ? [element("li", {}, "Nothing found.")] : [];
        output.replaceChildren(...(found.length ? found.map(({ field }) => resultItem(field, to)) : nothing));
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
// The builder: choose a command or a field, fill it in, and see its bytes and the answer.

const { MipError } = modules["mip/bytes"];
const { bitsNumber, maskOf, namedType, parameterOf, unitOf } = modules["mip/names"];
const { answerOf, initialValue, initialValues, packetOf, requiredOperations, setsOf, sourceOf } = modules["tools/build"];
const { element, links } = modules["tools/dom"];
const { descriptorOf, hexByte, spacedHex } = modules["tools/words"];

const LANGUAGES = [
    ["c", "C"],
    ["python", "Python"],
    ["rust", "Rust"],
];

/** Fills an element with the builder. `options` are those of `links`, and `field`, the name of the one to begin with. */
function builder(root, protocol, options = {}) {
    const to = links(options);
    const groups = protocol.model.sets.map((set) => fieldGroup(`${set.title} (${hexByte(set.number)})`, set.fields.map((name) => protocol.field(name))));
    const choice = element("select", { id: "mip-field" }, groups, fieldGroup("All command sets", [protocol.acknowledge]));
    const form = element("div", { class: "mip-form" });
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    let state;

    const show = () => output.replaceChildren(...builtPacket(protocol, state, to));
    const layOut = () => {
        form.replaceChildren(...inputs(protocol, state, { changed: show, reshaped: () => (layOut(), show()) }, choose));
    };
    const choose = (field, selector = protocol.functions.keys().next().value) => {
        const function_ = field.calls?.some((call) => call.function === protocol.functions.get(selector)?.name)
            ? selector
            : [...protocol.functions.values()].find((one) => one.name === field.calls?.[0].function)?.value;
        state = { field, set: setsOf(protocol, field)[0], values: initialValues(protocol, field, function_) };
        layOut();
        show();
    };
    choice.addEventListener("input", () => choose(protocol.field(choice.value)));
    root.replaceChildren(element("p", {}, element("label", { for: "mip-field" }, "Command or field "), choice), form, output);
    const start = options.field && protocol.fields.has(options.field) ? options.field : choice.value;
    choice.value = start;
    choose(protocol.field(start));
    return { choose: (name, selector) => ((choice.value = name), choose(protocol.field(name), selector)), state: () => state };
}

function fieldGroup(label, fields) {
    const words = (field) => `${hexByte(field.descriptor)} ${field.title}${field.role === "response" ? " (response)" : ""}`;
    return element("optgroup", { label }, fields.map((field) => element("option", { value: field.name }, words(field))));
}

// ------------------------------------------------------------------------------------------------ inputs

function inputs(protocol, state, events, choose) {
    const { field, values } = state;
    const operations = requiredOperations(protocol, field, values.function);
    const sets = setsOf(protocol, field);
    const parts = [element("p", {}, field.description)];
    if (sets.length > 1) {
        const options = sets.map((number) => [number, `${protocol.sets.get(number)?.title ?? ""} (${hexByte(number)})`]);
        parts.push(labelled("set", select(options, state.set, (number) => ((state.set = number), events.changed()))));
    }
    if (field.calls) {
        const functions = [...protocol.functions.values()].filter((one) => field.calls.some((call) => call.function === one.name));
        const options = functions.map((one) => [one.value, `${one.name}: ${one.description}`]);
        parts.push(labelled("function", select(options, values.function, (selector) => choose(field, selector))));
    }
    const shown = operations.filter((op) => !(field.calls && op.member === "function"));
    return [...parts, ...shown.flatMap((op) => input(protocol, op, field, values, events))];
}

let lastInput = 0; // for ids

function labelled(words, control, ...behind) {
    control.id ||= `mip-input-${++lastInput}`;
    return element("p", {}, element("label", { for: control.id }, `${words} `), control, ...behind);
}

function select(options, value, set) {
    const control = element("select", {}, options.map(([number, words]) => element("option", { value: number, selected: number === value }, words)));
    control.addEventListener("input", () => set(Number(control.value)));
    return control;
}

/** The inputs of one operation; they change `values`. */
function input(protocol, op, record, values, events) {
    if (op.kind === "constant" || op.kind === "counter") return [];
    const parameter = parameterOf(record, op.member) ?? { name: op.member };
    const [name, set] = [op.member, (value) => ((values[op.member] = value), events.changed())];
    const hint = [unitOf(parameter), parameter.description].filter(Boolean).join(" · ");
    const note = hint ? [" ", element("small", {}, hint)] : [];
    switch (op.kind) {
        case "scalar":
            return [scalarInput(protocol, op, parameter, record, values, events, note)];
        case "bits":
            return [bitsInput(name, protocol.type(op.type), values[name], (number) => set(littleEndian(number, op.size)))];
        case "text": {
            const control = element("input", { value: values[name].trimEnd(), maxlength: op.count ?? op.capacity });
            control.addEventListener("input", () => set(control.value.padEnd(op.count ?? 0)));
            return [labelled(name, control, note)];
        }
        case "struct":
            return [group(name, hint, protocol.type(op.struct).operations.flatMap((part) => input(protocol, part, protocol.type(op.struct), values[name], events)))];
        case "switch": {
            const selected = op.cases.find((one) => one.value === Number(values[op.tag]))?.operation;
            return selected ? [group(name, hint, input(protocol, selected, record, values[name], events))] : [];
        }
        default:
            return [arrayInput(protocol, op, parameter, values, events, hint)];
    }
}

function scalarInput(protocol, op, parameter, record, values, events, note) {
    const name = op.member;
    const type = namedType(protocol, parameter, values);
    const { kind } = protocol.scalar(op.scalar);
    const tags = record.parameters.some((one) => one.tag === name || one.variants?.some((variant) => variant.by === name));
    const set = (value) => {
        values[name] = value;
        if (!tags) return events.changed();
        for (const union of unionsOf(record, name)) values[union.member] = initialValue(protocol, union, record, values);
        events.reshaped();
    };
    if (type?.kind === "enum") {
        const options = type.values.map((one) => [one.value, `${one.value} ${one.name}`]);
        return labelled(name, select(options, Number(values[name]), set), note);
    }
    if (type?.kind === "bitfield") return bitsInput(name, type, values[name], set);
    if (kind === "bool") {
        const control = element("input", { type: "checkbox", checked: Boolean(values[name]) });
        control.addEventListener("input", () => set(control.checked ? 1 : 0));
        return labelled(name, control, note);
    }
    return labelled(name, numberInput(values[name], kind, set), note);
}

/** The switches of a record that a parameter selects. */
function unionsOf(record, tag) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op])).filter((op) => op.kind === "switch" && op.tag === tag);
}

function numberInput(value, kind, set) {
    const control = element("input", { value: String(value), inputmode: kind === "float" ? "decimal" : "text", spellcheck: "false" });
    control.addEventListener("input", () => set(numberOfText(control.value, kind)));
    return control;
}

/** A number as people write it: 0x1F, 12, -0.5; of floats also the bits, 0x and as many digits as it has. */
function numberOfText(text, kind) {
    const trimmed = text.trim();
    if (kind === "float") return /^0x/i.test(trimmed) ? trimmed : trimmed === "" ? trimmed : Number(trimmed);
    if (/^-?(\d+|0x[0-9a-f]+)$/i.test(trimmed)) {
        const number = trimmed.startsWith("-") ? -BigInt(trimmed.slice(1)) : BigInt(trimmed);
        return Number.isSafeInteger(Number(number)) ? Number(number) : number;
    }
    return trimmed || NaN;
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
        whole.value = `0x${number.toString(16).toUpperCase()}`;
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
    whole.value = `0x${number.toString(16).toUpperCase()}`;
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
function arrayInput(protocol, op, parameter, values, events, hint) {
    const items = values[op.member];
    const inner = { parameters: [{ ...parameter, name: op.item.member, default: undefined, cases: undefined }], operations: [op.item] };
    const names = protocol.types.get(op.vector)?.elements;
    const rows = items.map((_, i) => {
        const holder = {
            get [op.item.member]() {
                return items[i];
            },
            set [op.item.member](value) {
                items[i] = value;
            },
        };
        const unit = { ...inner.parameters[0], description: "", units: [unitOf(parameter, i)] };
        const [control] = input(protocol, op.item, { ...inner, parameters: [unit] }, holder, events);
        const label = control.querySelector(":scope > label, :scope > legend");
        label.textContent = `${names?.[i] ?? `${op.member}[${i}]`} `;
        return control;
    });
    if (op.count !== undefined) return group(op.member, hint, rows);
    const add = () => {
        items.push(initialValue(protocol, op.item, inner, {}));
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

function builtPacket(protocol, { field, set, values }, to) {
    let packet;
    try {
        packet = packetOf(protocol, field, set, values);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return [element("p", { class: "mip-wrong" }, `${error.message}.`)];
    }
    const sources = LANGUAGES.map(([key, title]) => [element("dt", {}, title), element("dd", {}, element("code", { "data-language": key }, sourceOf(packet.bytes, key)))]);
    return [
        element("h2", {}, to.field(field), ` ${descriptorOf(field)}`),
        element("p", { class: "mip-bytes" }, element("code", { class: "mip-packet-bytes" }, spacedHex(packet.bytes))),
        element("p", {}, `${packet.bytes.length} bytes; the checksum is ${spacedHex(packet.checksum)}.`),
        element("h3", {}, "As source code"),
        element("dl", { class: "mip-bytes" }, sources),
        ...(field.role === "command" && field.sent_by !== "device" ? answerReport(protocol, field, values, to) : []),
    ];
}

function answerReport(protocol, field, values, to) {
    const { silent, acknowledge, responses, conditions } = answerOf(protocol, field, values);
    const unless = conditions.length ? ` There is no answer if ${conditions.join(" or ")}.` : "";
    if (silent) return [element("h3", {}, "Answer"), element("p", { class: "mip-answer" }, silent)];
    const listed = responses.map(({ field: response, when }) =>
        element("li", { "data-field": response.name }, to.field(response), ` ${descriptorOf(response)}, ${sizeText(response)}`, when && `, if ${when}`),
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

function sizeText({ min_size: least, max_size: most }) {
    return least === most ? `${least + 2} bytes` : `${least + 2} to ${most + 2} bytes`;
}

return { builder, numberOfText };
})();

// ---------------------------------------------------------------------------------------------------- tools/bandwidth.mjs

modules["tools/bandwidth"] = (() => {
// Bandwidth: choose data fields and rates, and see which baud rate they need.

const { element, links } = modules["tools/dom"];
const { needOf, portsFor, streamsOf } = modules["tools/stream"];
const { descriptorOf, hexByte } = modules["tools/words"];

/** Fills an element with the tool. `options` are those of `links`, and `device`, the id of the one to begin with. */
function bandwidth(root, protocol, options = {}) {
    const to = links(options);
    const device = element(
        "select",
        { id: "mip-stream-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id, selected: one.id === options.device }, one.title)),
    );
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    const list = element("div");
    let rows = [];
    const chosen = () => protocol.model.devices.find((one) => one.id === device.value);
    const show = () => output.replaceChildren(...report(chosen(), rows));
    const layOut = () => {
        const streams = streamsOf(protocol, chosen());
        rows = streams.map((stream) => stream.fields.map((field) => streamRow(field, stream, show, to)));
        list.replaceChildren(...streams.map((stream, i) => streamTable(stream, rows[i])));
        show();
    };
    device.addEventListener("input", layOut);
    root.replaceChildren(element("p", {}, element("label", { for: "mip-stream-device" }, "Device "), device), output, list);
    layOut();
}

function streamTable({ set, base }, rows) {
    const rate = base ? `base rate ${base} Hz` : "base rate not known";
    const heads = ["Field", "Bytes", base ? "Decimation" : "Rate in Hz", "Rate"].map((text) => element("th", { scope: "col" }, text));
    return element(
        "details",
        { "data-set": set.name, open: rows.some(({ box }) => box.checked) },
        element("summary", {}, `${set.title} (${hexByte(set.number)}), ${rate}`),
        element(
            "div",
            { class: "mip-scroll" },
            element("table", {}, element("thead", {}, element("tr", {}, heads)), element("tbody", {}, rows.map(({ line }) => line))),
        ),
    );
}

/** A line of the table; `rate` is that of the field, 0 while it is not chosen. */
function streamRow(field, { set, base }, show, to) {
    const id = `mip-stream-${set.name}-${field.name}`;
    const box = element("input", { type: "checkbox", id });
    const number = element("input", { type: "number", min: base ? 1 : 0, step: base ? 1 : "any", value: base ? 10 : 1, "aria-label": `${base ? "decimation" : "rate in Hz"} of ${field.title}` });
    const text = element("td", { class: "mip-rate" });
    const rateOf = () => {
        const given = Math.max(0, Number(number.value) || 0);
        return base ? base / Math.max(1, Math.trunc(given)) : given;
    };
    const row = { field, box, rate: () => (box.checked ? rateOf() : 0) };
    const changed = () => {
        text.textContent = `${Number(rateOf().toPrecision(6))} Hz`;
        show();
    };
    for (const control of [box, number]) control.addEventListener("input", changed);
    text.textContent = `${Number(rateOf().toPrecision(6))} Hz`;
    const label = element("label", { for: id }, ` ${descriptorOf(field)} ${field.title}`);
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
    const streams = rows.map((set) => set.filter(({ box }) => box.checked).map(({ field, rate }) => ({ field, rate: rate() })));
    const { bytes, baud } = needOf(streams);
    if (!bytes) return [element("p", { class: "mip-note" }, "Choose fields below.")];
    const ports = portsFor(device, baud).map(({ port, rate }) => {
        const words = rate === null ? "no baud rate" : (rate ?? "none of its baud rates is enough");
        return element("tr", { "data-port": port.name }, element("td", {}, port.name), element("td", {}, `${words}`));
    });
    const heads = ["Port", "Smallest baud rate"].map((text) => element("th", { scope: "col" }, text));
    return [
        element("p", { class: "mip-need" }, `${round(bytes)} bytes/s; over a UART at least ${round(baud)} Bd.`),
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
const { answerOf, initialValues, packetOf } = modules["tools/build"];
const { builder } = modules["tools/builder"];
const { find, indexOf } = modules["tools/find"];
const { finder } = modules["tools/finder"];
const { bytesOfText } = modules["tools/input"];
const { inspect } = modules["tools/inspect"];
const { inspector } = modules["tools/inspector"];
const { needOf, portsFor, streamsOf } = modules["tools/stream"];

return { bandwidth, answerOf, initialValues, packetOf, builder, find, indexOf, finder, bytesOfText, inspect, inspector, needOf, portsFor, streamsOf };
})();

globalThis.mip = { ...modules["mip/index"], ...modules["tools/index"], };
})();
