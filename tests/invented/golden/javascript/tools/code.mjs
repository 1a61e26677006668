// Programs in C, Python and Rust that send a command, or read a data field: the same as on the pages of the reference.

import { MipError } from "../mip/bytes.mjs";
import { bitsNumber, enumValue, maskOf, parameterOf } from "../mip/names.mjs";
import { decimalLiteral, hexLiteral } from "./words.mjs";

/** The languages, as programs name and as people call them. */
export const LANGUAGES = [
    ["c", "C"],
    ["python", "Python"],
    ["rust", "Rust"],
];

/**
 * A program that sends a command once with each of some values, or that reads a data field or a response. Raises a
 * MipError of the kind "program" if a language cannot write a value.
 */
export function programOf(protocol, language, field, values = []) {
    const writer = { c: cProgram, python: pythonProgram, rust: rustProgram }[language];
    if (field.role !== "command") return writer(new Names(protocol, language), field);
    for (const one of values) refuseReserved(protocol, field, one);
    return writer(new Names(protocol, language), field, values);
}

/** The first response that a command asks for with these values, or nothing. */
export function responseTo(protocol, field, values) {
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
