// A packet in the builder: initial values, bytes, source code, and the reply.

import {
    buildPacket,
    FIRST_DATA_SET,
    fromHex,
    isSame,
    nameIn,
    namedType,
    parameterOf,
    placesOf,
    readFloat,
    SHARED_SET,
    toHex,
} from "mip-protocol/tools";
import { conditionText, hexByte } from "./words.mjs";

/** Returns the sets whose packets can contain a field. */
export function setsOf(protocol, field) {
    if (field.set && field.set !== SHARED_SET) return placesOf(field).map(({ set }) => set);
    const numbers = protocol.model.sets.map((set) => set.number).filter((number) => number !== SHARED_SET);
    return numbers.filter((number) => number >= FIRST_DATA_SET === (field.set === SHARED_SET));
}

/** Returns the operations of a field that a function requires; without a selector, all required ones. */
export function requiredOperations(protocol, field, selector) {
    const required = protocol.required(field, selector);
    return field.operations.flatMap((op) => (op.kind !== "group" ? [op] : op.last <= required ? op.body : []));
}

/** Returns typical values for a function, if the field has a selector; includes optional ones on request. */
export function typicalValues(protocol, field, selector, optional = false) {
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

/** Returns the operations of a field, including those in groups. */
export function allOperations(field) {
    return field.operations.flatMap((op) => (op.kind === "group" ? op.body : [op]));
}

/** Converts values to JavaScript numbers, because the model contains the bits of floats. */
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

/** Returns the initial values: typical ones, else as few as possible. */
export function initialValues(protocol, field, selector) {
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

/** Returns the initial value of an operation; a union's depends on the values before it. */
export function initialValue(protocol, op, record, values) {
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
            const selected = op.cases.find((one) => isSame(one.value, values[op.tag]))?.operation;
            return selected ? { [selected.member]: initialValue(protocol, selected, record, {}) } : {};
        }
        default:
            return numberOf(protocol, parameter, given ?? firstOf(protocol, parameter, values), values);
    }
}

function firstOf(protocol, parameter, values) {
    const type = namedType(protocol, parameter, values);
    if (type?.kind === "enum") return type.values[0].value;
    return parameter.minimum > 0 ? parameter.minimum : 0;
}

/** Returns the number of a default, which may be the name of a value, or names of bits. */
function numberOf(protocol, parameter, given, values) {
    const type = namedType(protocol, parameter, values);
    if (typeof given === "string") return type?.values?.find((one) => one.name === given)?.value ?? 0;
    if (Array.isArray(given)) {
        const bits = given.map((name) => BigInt(type?.bits?.find((one) => one.name === name)?.first ?? 0));
        const sum = bits.reduce((all, bit) => all | (1n << bit), 0n);
        return Number.isSafeInteger(Number(sum)) ? Number(sum) : sum;
    }
    return typeof given === "bigint" ? given : Number(given);
}

/** Returns the same values, with every counter set to the number of elements. */
export function counted(protocol, operations, values) {
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

/** Builds a packet from fields with values, each `{ field, values }`. Throws a MipError with the reason. */
export function packetOf(protocol, set, entries) {
    const fields = entries.map(({ field, values }) => ({
        descriptor: field.descriptor,
        name: nameIn(field, set),
        values: counted(protocol, field.operations, values),
    }));
    return buildPacket(protocol, set, fields);
}

// ------------------------------------------------------------------------------------------------ optional parameters

/** Returns the groups of operations that may follow those that a function requires. */
export function optionalGroups(protocol, field, selector) {
    const required = protocol.required(field, selector);
    const call = field.calls?.find((one) => one.function === protocol.functions.get(Number(selector))?.name);
    const groups = field.operations.filter((op) => op.kind === "group" && op.last > required);
    return field.calls ? groups.filter((op) => op.body.every((one) => call?.optional.includes(one.member))) : groups;
}

/** Returns the number of these groups that are present. */
export function countOptional(groups, values) {
    const absent = groups.findIndex((op) => op.body.some(({ kind, member }) => kind !== "constant" && !Object.hasOwn(values, member)));
    return absent < 0 ? groups.length : absent;
}

/** Returns the operations that are present: all required ones, and the optional ones with values. */
export function shownOperations(protocol, field, values) {
    const groups = optionalGroups(protocol, field, values.function);
    const optional = groups.slice(0, countOptional(groups, values)).flatMap((op) => op.body);
    return [...requiredOperations(protocol, field, values.function), ...optional];
}

// ------------------------------------------------------------------------------------------------ devices

/**
 * Returns the entry of a device's `supports` for a field in a set, or for a response's command; without a device, an
 * empty one. A set that the device lacks has no shared fields either.
 */
export function supportOn(protocol, device, field, set) {
    if (!device || field === protocol.acknowledge) return {};
    const names = statedNames(protocol, field, set);
    return lacks(protocol, device, set) ? undefined : device.supports?.find((one) => names.includes(one.field));
}

/** Does the profile of a device rule out a field in a set, or the whole set for lack of hardware? */
function isRefused(protocol, device, field, set) {
    const names = statedNames(protocol, field, set);
    return lacks(protocol, device, set) || names.every((name) => device.refuses?.some((one) => one.field === name));
}

function lacks(protocol, device, set) {
    return device.evidence?.some(({ sets }) => sets?.includes(protocol.sets.get(set)?.name));
}

/** Returns the names under which a profile states whether a device has a field: a response's are those of its commands. */
function statedNames(protocol, field, set) {
    if (field.role !== "response") return [nameIn(field, set)];
    return protocol.model.fields.filter((one) => one.responses?.includes(field.name)).map((one) => one.name);
}

/** Returns how certain the evidence makes the support: "yes", "likely" or "assumed". */
function certaintyIn(device, support) {
    return device?.evidence?.[support.evidence]?.answer ?? "yes";
}

/**
 * Returns the mark of a field in a set on a device: "" if it is supported, "likely" or "assumed" if it
 * is believed to be, "not known" if the profile is incomplete and does not list it; undefined if it is not supported.
 */
export function certaintyOn(protocol, device, field, set) {
    const support = supportOn(protocol, device, field, set);
    const certainty = support && certaintyIn(device, support);
    if (support) return certainty === "yes" ? "" : certainty;
    return device.incomplete && !isRefused(protocol, device, field, set) ? "not known" : undefined;
}

/** Returns the differences on a device in a set, each in words. */
export function differencesOn(protocol, device, field, set) {
    const support = supportOn(protocol, device, field, set);
    if (!support && isRefused(protocol, device, field, set)) return ["it does not support this"];
    if (!support) return [`it is not known ${device.incomplete ? "whether it supports" : "to support"} this`];
    const found = [];
    const certainty = certaintyIn(device, support);
    if (certainty !== "yes") found.push(`${certainty}: ${device.evidence[support.evidence].why}`);
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
 * The answer to a command: `silent`, why there is none; `acknowledge`, the packet without a response; `responses`, each
 * with the field, the condition under which it directly follows the acknowledge, and a packet of typical values.
 */
export function answerOf(protocol, field, values) {
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

/** The languages in which `sourceOf` writes, as it and people call them. */
export const LANGUAGES = [
    ["c", "C"],
    ["cpp", "C++"],
    ["python", "Python"],
    ["rust", "Rust"],
    ["javascript", "JavaScript"],
];

/** Returns the bytes as source code. */
export function sourceOf(bytes, language) {
    const list = Array.from(bytes, hexByte).join(", ");
    const plain = `\\x${toHex(bytes, "\\x")}`;
    return {
        c: `static const uint8_t packet[] = {${list}};`,
        cpp: `constexpr std::array<std::uint8_t, ${bytes.length}> packet{${list}};`,
        python: `packet = b"${plain}"`,
        rust: `const PACKET: [u8; ${bytes.length}] = [${list}];`,
        javascript: `const packet = Uint8Array.of(${list});`,
    }[language];
}
