// Names of values and bits, units, and types that depend on another value.

/** The parameters of the record in which an operation is: those of a field or a structure. */
export function parameterOf(record, name) {
    return record.parameters.find((parameter) => parameter.name === name) ?? caseOf(record, name);
}

function caseOf(record, name) {
    const cases = record.parameters.flatMap((parameter) => parameter.cases ?? []);
    return cases.find((one) => one.parameter?.name === name)?.parameter;
}

/**
 * The parameters along a path of a field; the last of them describes the value there. Indices have
 * none.
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

/** The value of a path: ["message", "descriptors", 2]. */
export function valueAt(values, path) {
    return path.reduce((inner, step) => inner?.[step], values);
}

/**
 * The enumeration or bitfield that names the values of a parameter. It may depend on the value of a sibling, or on the
 * device; `siblings` are the values beside it, `device` the id of the device or undefined.
 */
export function namedType(protocol, parameter, siblings = {}, device = undefined) {
    return protocol.types.get(differing(parameter, siblings, device, "type") ?? parameter.type);
}

/** The same for the units of a parameter, and the elements of a vector. */
export function measuredHere(protocol, parameter, siblings = {}, device = undefined) {
    const own = { units: parameter.units, elements: protocol.types.get(parameter.type)?.elements };
    const found = Object.keys(own).map((key) => [key, differing(parameter, siblings, device, key) ?? own[key]]);
    return { ...parameter, ...Object.fromEntries(found) };
}

/** An attribute of a parameter, if it differs with these values beside it or on the device. */
function differing(parameter, siblings, device, attribute) {
    const holds = (one) => (one.by === "device" ? one.key === device : one.value === Number(siblings?.[one.by]));
    return (parameter.variants ?? []).find((one) => one[attribute] && !one.member && holds(one))?.[attribute];
}

/** The value of an enumeration with this number, if it has a name. */
export function enumValue(type, number) {
    return type.values.find((value) => value.value === Number(number));
}

/** The number of a bitfield, as a BigInt; one of bytes has its least significant byte first. */
export function bitsNumber(value) {
    return Array.isArray(value) ? value.reduceRight((sum, byte) => (sum << 8n) | BigInt(byte), 0n) : BigInt(value);
}

/** The bits of a name as a number, a BigInt. */
export function maskOf(bits) {
    return ((1n << BigInt(bits.last - bits.first + 1)) - 1n) << BigInt(bits.first);
}

/** The bits of a bitfield with their values: flags that are set, and all numbers. `rest` are bits without a name. */
export function bitsOf(protocol, type, value) {
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
export function unitOf(parameter, index = 0) {
    const units = parameter.units ?? [];
    const unit = units.length > 1 ? units[index] : units[0];
    return unit === "1" ? "" : (unit ?? "");
}
