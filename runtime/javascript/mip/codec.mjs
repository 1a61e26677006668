// Decodes and encodes the data of a field by the operations of its layout.
//
// Values: integers, enumerations, bitfields and bools are numbers, of eight bytes BigInts; floats are numbers, except for
// unusual NaNs (see readFloat); text is a string with one character for each byte; a bitfield of bytes is an array of
// them; arrays are arrays, structures objects, and a union is an object with one member or none.

import {
    MipError,
    bytesOf,
    concatenated,
    described,
    floatBits,
    isList,
    readFloat,
    readInteger,
    readText,
    writeFloat,
    writeInteger,
    writeText,
} from "./bytes.mjs";

/**
 * The values of a field, how many bytes are left over, and `parts`: each value that is not divided further, in wire order,
 * with its path (names and indices), its operation, and where its bytes are in the data (offset and size).
 *
 * @param options.floatBits every float is the text of its bits, "0x3e7a63a0"
 */
export function decodeData(protocol, field, given, options = {}) {
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
export function encodeData(protocol, field, values) {
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

    text(op, value, where) {
        checkCount(op, value, where);
        this.parts.push(writeText(value, where));
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
                this.text(op, value.padEnd(op.count ?? 0), where); // with spaces, as those of devices are
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
