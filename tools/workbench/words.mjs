// Formats numbers, names and positions of the protocol.

import { bitsOf, enumValue, placesOf, SHARED_SET, toHex, unitOf } from "mip-protocol/tools";

export function hexByte(number) {
    return hexLiteral(number, 1);
}

export function spacedHex(bytes) {
    return toHex(bytes, " ").toUpperCase();
}

/**
 * "(0x0C,0x28)", in one of the sets of a field, or "(0x81, 0x91–0x95; 0x07)", in all of them. A field of every command
 * set has its descriptor alone.
 */
export function descriptorOf(field, set) {
    return `(${pairOf(field, set)})`;
}

/** The same without parentheses. */
export function pairOf(field, set) {
    const descriptor = hexByte(field.descriptor);
    const sets = placesOf(field).map((place) => place.set);
    if (!field.set) return descriptor;
    if (sets.length === 1 || sets.includes(set)) return `${hexByte(sets.length === 1 ? sets[0] : set)},${descriptor}`;
    return `${ranges(sets)}; ${descriptor}`;
}

/** "0x81, 0x91–0x95" */
function ranges(numbers) {
    const found = [];
    for (const number of numbers) {
        if (found.at(-1)?.at(-1) === number - 1) found.at(-1)[1] = number;
        else found.push([number]);
    }
    return found.map((range) => range.map(hexByte).join("–")).join(", ");
}

/** Returns the shortest decimal number that has the same bits as a float of this size. */
export function decimal(value, size) {
    if (typeof value === "string") return `NaN (${value})`;
    if (Object.is(value, -0)) return "-0";
    if (size !== 4 || !Number.isFinite(value)) return String(value);
    for (let digits = 1; digits < 9; digits++) {
        const short = Number(value.toPrecision(digits));
        if (Math.fround(short) === value) return String(short);
    }
    return String(Number(value.toPrecision(9)));
}

/** Formats a number in hexadecimal, with all digits of its `size` in bytes. */
export function hexLiteral(value, size = 0) {
    return `0x${BigInt(value)
        .toString(16)
        .toUpperCase()
        .padStart(2 * size, "0")}`;
}

/**
 * Formats the path of a value: "descriptors[0].rate"; a vector's elements have names if the last parameter has them.
 */
export function pathText(parameters, path) {
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
 * Formats a value for people: `text`, `unit`, for an enumeration `name` and `meaning`, and for a bitfield `flags`.
 *
 * @param type the enumeration or bitfield of the value, if it has one
 * @param values those of the record, on which the meaning of bits may depend
 */
export function shown(protocol, part, parameter, type, index, values = {}) {
    const { operation, value, size } = part;
    const unit = unitOf(parameter, index);
    const kind = protocol.scalar(operation.scalar)?.kind;
    if (operation.kind === "text") return { text: JSON.stringify(value.replace(/[\0 ]+$/, "")), unit };
    if (kind === "float") return { text: decimal(value, size), unit, float: true };
    if (kind === "bool") return { text: `${value}`, name: value ? "true" : "false", unit };
    if (type?.kind === "enum") {
        const known = enumValue(type, value);
        return { text: `${value}`, name: known?.name ?? "unknown", meaning: known?.description, unit };
    }
    if (type?.kind === "bitfield") {
        const { found, rest } = bitsOf(protocol, type, value, values);
        const flags = found.filter(({ flag, value: held }) => !flag || held);
        const text = Array.isArray(value) ? spacedHex(Uint8Array.from(value)) : hexLiteral(value, size);
        return { text, flags: rest ? [...flags, { rest }] : flags, unit };
    }
    return { text: parameter.shown ? hexLiteral(value, size) : `${value}`, unit };
}

/**
 * Returns number -> title of the data sets, or of the fields of the set that a parameter refers to. `values` are those
 * of its record, `outer` the parameter that holds the record, with the values beside it.
 */
export function choicesOf(protocol, parameter, values, outer) {
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
export function flagText({ bits, value, flag, named, rest }) {
    if (rest !== undefined) return `${hexLiteral(rest)} has no name`;
    return flag && !named ? bits.name : `${bits.name} = ${named?.name ?? value}`;
}

/** "mode is fast"; of another command, "mode of base.echo_control is fast". */
export function conditionText({ parameter, label, command }) {
    return `${parameter}${command ? ` of ${command}` : ""} is ${label}`;
}
