// Names of values and bits, units, and types that depend on another value.

import { camel, isSame } from "./bytes.mjs";

/** Names that every object has; a member with such a name is suffixed with "_". */
const TAKEN = new Set(["constructor", "encode", "packet", "set", "answered", "replies", "isValid", "toJSON", "toString", "valueOf"]);

/** Converts a name to a member's name in programs: "gnss_1" to "gnss1", and "3d_fix" to "_3dFix". */
export function memberName(words) {
    const name = camel(words);
    return /^\d/.test(name) ? `_${name}` : TAKEN.has(name) ? `${name}_` : name;
}

/** Returns the number with which a model or serial number of the device information begins; undefined if there is none. */
export function modelNumber(text) {
    const digits = /^\s*(\d+)(?=[-. \0]|$)/.exec(String(text))?.[1];
    return digits && Number(digits);
}

/** Finds a parameter of a field or a structure by its name. */
export function parameterOf(record, name) {
    return record.parameters.find((parameter) => parameter.name === name) ?? caseOf(record, name);
}

function caseOf(record, name) {
    const cases = record.parameters.flatMap((parameter) => parameter.cases ?? []);
    return cases.find((one) => one.parameter?.name === name)?.parameter;
}

/**
 * Returns the parameters along a path in a field, without entries for indices. The last one describes the value there.
 */
export function parametersAt(protocol, field, path) {
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

/** Returns the value at a path: ["message", "descriptors", 2]. */
export function valueAt(values, path) {
    return path.reduce((inner, step) => inner?.[step], values);
}

/**
 * Returns the enumeration or bitfield that names the values of a parameter. It may depend on a sibling's value or on the
 * device: `siblings` are the values beside it, `device` is the device's id or undefined.
 */
export function namedType(protocol, parameter, siblings = {}, device = undefined) {
    return protocol.types.get(differing(parameter, siblings, device, "type") ?? parameter.type);
}

/** Returns a parameter with the units and vector elements that it has with these siblings or on this device. */
export function measuredHere(protocol, parameter, siblings = {}, device = undefined) {
    const own = { units: parameter.units, elements: protocol.types.get(parameter.type)?.elements };
    const found = Object.keys(own).map((key) => [key, differing(parameter, siblings, device, key) ?? own[key]]);
    return { ...parameter, ...Object.fromEntries(found) };
}

/** Returns an attribute of a parameter, if it differs with these siblings or on this device. */
function differing(parameter, siblings, device, attribute) {
    const holds = (one) => (one.by === "device" ? one.key === device : isSame(one.value, siblings?.[one.by]));
    return (parameter.variants ?? []).find((one) => one[attribute] && !one.member && holds(one))?.[attribute];
}

/** Finds the value of an enumeration with this number, if it has a name. */
export function enumValue(type, number) {
    return type.values.find((value) => isSame(value.value, number));
}

/** Returns the number of a bitfield as a BigInt; bytes are combined with the least significant first. */
export function bitsNumber(value) {
    return Array.isArray(value) ? value.reduceRight((sum, byte) => (sum << 8n) | BigInt(byte), 0n) : BigInt(value);
}

/** Returns the mask of named bits, a BigInt. */
export function maskOf(bits) {
    return ((1n << BigInt(bits.last - bits.first + 1)) - 1n) << BigInt(bits.first);
}

/**
 * Returns the parts of a bitfield with their values: flags that are set, and all numbers. `rest` are unnamed bits.
 *
 * @param values those of the record: bits that mean nothing in its state are left out, and remain in `rest`
 */
export function bitsOf(protocol, type, value, values = {}) {
    let rest = bitsNumber(value);
    const whole = rest;
    const found = [];
    for (const bits of type.bits) {
        const state = bits.when && values[bits.when.parameter];
        if (state !== undefined && !bits.when.numbers.includes(Number(state))) continue;
        const mask = maskOf(bits);
        const held = (whole & mask) >> BigInt(bits.first);
        rest &= ~mask;
        const named = bits.enum ? enumValue(protocol.type(bits.enum), held) : undefined;
        found.push({ bits, value: held, flag: bits.first === bits.last, named });
    }
    return { found, rest };
}

/** Returns the unit of a parameter's element, or an empty text; plain numbers have none. */
export function unitOf(parameter, index = 0) {
    const units = parameter.units ?? [];
    const unit = units.length > 1 ? units[index] : units[0];
    return unit === "1" ? "" : (unit ?? "");
}
