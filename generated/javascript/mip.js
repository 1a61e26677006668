// The modules of mip/ and tools/ as one script, for pages that are opened from disk: browsers load no modules there.
// It defines one global object, `mip`, with what their files index.mjs export.
(() => {
"use strict";

// ---------------------------------------------------------------------------------------------------- mip/bytes.mjs

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

// ---------------------------------------------------------------------------------------------------- mip/protocol.mjs

// The model of the protocol: what is in mip.json, found by name and by descriptor.

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

// ---------------------------------------------------------------------------------------------------- mip/codec.mjs

// Decodes and encodes the data of a field by the operations of its layout.
//
// Values: integers, enumerations, bitfields and bools are numbers, of eight bytes BigInts; floats are numbers, except for
// unusual NaNs (see readFloat); text is a string with one character for each byte; a bitfield of bytes is an array of
// them; arrays are arrays, structures objects, and a union is an object with one member or none.

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
            throw new MipError("truncated", `the data are ${short} byte${short > 1 ? "s" : ""} short`);
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

// ---------------------------------------------------------------------------------------------------- mip/packet.mjs

// Packets: their frame, their fields, and building them.

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

// ---------------------------------------------------------------------------------------------------- mip/parser.mjs

// Finds packets in a stream, among anything else.

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

// ---------------------------------------------------------------------------------------------------- mip/names.mjs

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

/** The bits of a bitfield with what they hold: flags that are set, and all numbers. `rest` are bits without a name. */
function bitsOf(protocol, type, value) {
    let rest = bitsNumber(value);
    const whole = rest;
    const found = [];
    for (const bits of type.bits) {
        const mask = ((1n << BigInt(bits.last - bits.first + 1)) - 1n) << BigInt(bits.first);
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

globalThis.mip = { MipError, checksum, fromHex, toHex, decodeData, encodeData, bitsOf, enumValue, namedType, parametersAt, unitOf, Packet, buildPacket, Parser, segments, Protocol, };
})();
