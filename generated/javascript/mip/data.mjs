// For tools: the data of fields that a model describes, decoded and encoded with the blocks of the library.
//
// Values are in the plain form: integers, enumerations, bitfields and Booleans are numbers, or BigInts if they have eight
// bytes; floats are numbers, except for unusual NaNs (see readFloat); a bitfield in bytes is an array of bytes; a union is
// an object with one member or none.

import { MipError, bytesOf, described, fromHex, isSame } from "./bytes.mjs";
import {
    array,
    bool,
    char,
    constant,
    counted,
    countedText,
    counter,
    double,
    encoded,
    float,
    Layout,
    MAX_FIELD_DATA,
    octets,
    Reader,
    rest,
    restText,
    s16,
    s32,
    s64,
    s8,
    structOf,
    text,
    u16,
    u32,
    u64,
    u8,
    union,
} from "./codec.mjs";
import { nameIn } from "./model.mjs";
import { isSet, Packet } from "./packet.mjs";

const SCALARS = { u8, u16, u32, u64, s8, s16, s32, s64, float, double, bool, char };
const layouts = new WeakMap();

/** Returns the layout of a field or a structure of a model. */
function layoutOf(protocol, record) {
    if (!Array.isArray(record?.operations))
        throw new MipError("unknown", `${described(record)} is not a field; protocol.field(name) returns one`);
    if (!layouts.has(record)) {
        const first = record.operations.findIndex((op) => op.kind === "group");
        const flat = record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op]));
        const named = Object.fromEntries(flat.map((op) => [op.member, blockOf(protocol, op)]));
        layouts.set(record, new Layout(named, first < 0 ? undefined : first));
    }
    return layouts.get(record);
}

/** Creates the block of an operation. */
function blockOf(protocol, op) {
    const scalar = op.scalar && SCALARS[op.scalar];
    switch (op.kind) {
        case "scalar":
            return scalar;
        case "counter":
            return counter(scalar, op.array);
        case "constant":
            return constant(scalar, op.value);
        case "bits":
            return octets(op.size);
        case "text":
            if (op.count !== undefined) return text(op.count);
            return op.counter === undefined ? restText(op.capacity) : countedText(op.counter, op.capacity);
        case "array": {
            const item = blockOf(protocol, op.item);
            if (op.count !== undefined) return array(item, op.count);
            return op.counter === undefined ? rest(item, op.capacity) : counted(op.counter, item, op.capacity);
        }
        case "struct": {
            const layout = layoutOf(protocol, protocol.type(op.struct));
            return structOf(layout);
        }
        case "switch": {
            const cases = op.cases.filter((one) => one.operation);
            return union(
                op.tag,
                cases.map(({ value, operation }) => [value, operation.member, blockOf(protocol, operation)]),
            );
        }
    }
    throw new MipError("format", `the operation "${op.kind}" is not known`);
}

/** Returns the number of required parameters with this function, including the selector; undefined if there is none. */
function requiredOf(protocol, field, selector) {
    return field.calls && 1 + protocol.required(field, selector);
}

/**
 * Decodes the values of a field, and counts the bytes left over.
 *
 * @param options.floatBits every float is the text of its bits, "0x3e7a63a0"
 */
export function decodeData(protocol, field, given, options = {}) {
    const layout = layoutOf(protocol, field);
    const reader = new Reader(bytesOf(given), { ...options, plain: true });
    const values = {};
    layout.read(reader, values, requiredOf(protocol, field, reader.bytes[0]));
    return { values, trailing: reader.left };
}

/** Encodes a field's data with these values, in the shortest form that contains them. Counters may be omitted. */
export function encodeData(protocol, field, values) {
    const layout = layoutOf(protocol, field);
    return encoded(layout, field.name, values, { plain: true, required: requiredOf(protocol, field, values?.function) });
}

/**
 * Returns each value that is not divided further, in wire order, with its path (names and indices), its operation, and the
 * offset and size of its bytes in the data. `values` are the values decoded from the data.
 */
export function partsOf(protocol, field, values) {
    const parts = [];
    let offset = 0;
    const leaf = (operation, path, value, size) => {
        parts.push({ path, operation, value, offset, size });
        offset += size;
    };
    const walk = (op, value, path, beside) => {
        switch (op.kind) {
            case "bits":
                leaf(op, path, value, op.size);
                return;
            case "text":
                leaf(op, path, value, value.length);
                return;
            case "array":
                for (const [i, item] of value.entries()) walk(op.item, item, [...path, i], beside);
                return;
            case "struct":
                record(protocol.type(op.struct).operations, value, path);
                return;
            case "switch": {
                const selected = op.cases.find((one) => isSame(one.value, beside[op.tag]))?.operation;
                if (selected) record([selected], value, path);
                return;
            }
            default:
                leaf(op, path, value, protocol.scalar(op.scalar).size);
        }
    };
    const record = (operations, held, path) => {
        for (const op of operations) {
            const there = (one) => one.kind === "constant" || held[one.member] !== undefined;
            if (op.kind !== "group") walk(op, held[op.member] ?? op.value, [...path, op.member], held);
            else if (op.body.every(there)) record(op.body, held, path);
            else return; // all after an absent group are absent, too
        }
    };
    record(field.operations, values, []);
    return parts;
}

/**
 * Returns the fields of a packet with their values and parts. A field that cannot be decoded has an error instead of
 * values, and an unknown one has neither; the error of a malformed field is the last entry. `options` are as for
 * decodeData.
 */
export function decodePacket(protocol, packet, options = {}) {
    const decoded = [];
    try {
        for (const raw of packet.fields()) decoded.push({ ...raw, ...decodedField(protocol, raw, options) });
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        decoded.push({ error });
    }
    return decoded;
}

function decodedField(protocol, { set, descriptor, data }, options) {
    const field = protocol.choose(set, descriptor, data);
    if (!field) return {};
    try {
        const found = decodeData(protocol, field, data, options);
        return { field, ...found, parts: partsOf(protocol, field, found.values) };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { field, error };
    }
}

/**
 * Builds a packet of a set from fields. Each has a `name` and `values`, or a `descriptor` and `raw`, which is bytes or
 * hexadecimal text. Counters may be omitted. Throws a MipError if something does not fit.
 */
export function buildPacket(protocol, set, fields) {
    if (!isSet(set)) throw new MipError("set", `no packet has descriptor set ${described(set)}`);
    if (!Array.isArray(fields)) throw new MipError("fields", `${described(fields)} is not an array of fields`);
    return Packet.build(
        set,
        fields.map((entry) => {
            if (typeof entry !== "object" || entry === null) throw new MipError("fields", `${described(entry)} is not a field`);
            const field = entry.raw === undefined ? fieldIn(protocol, set, entry) : undefined;
            const descriptor = field?.descriptor ?? entry.descriptor;
            if (!(Number.isInteger(descriptor) && descriptor >= 0 && descriptor < 256)) {
                throw new MipError("descriptor", `no field has descriptor ${described(descriptor)}`);
            }
            const data = field ? encodeData(protocol, field, entry.values) : rawOf(entry.raw);
            if (data.length > MAX_FIELD_DATA) throw new MipError("length", `a field holds at most ${MAX_FIELD_DATA} bytes of data`);
            return { descriptor, data };
        }),
    );
}

/** Finds the field that an entry names; if the entry also has a descriptor, it must be the field's. */
function fieldIn(protocol, set, { descriptor, name }) {
    const field = protocol.fields.get(name);
    const here = field && protocol.candidates(set, field.descriptor).includes(field) && nameIn(field, set) === name;
    if (here && (descriptor === undefined || descriptor === field.descriptor)) return field;
    const beside = descriptor === undefined ? "" : ` with descriptor ${described(descriptor)}`;
    throw new MipError("unknown", `set ${set} has no field ${described(name)}${beside}`);
}

function rawOf(raw) {
    return typeof raw === "string" ? fromHex(raw) : bytesOf(raw);
}
