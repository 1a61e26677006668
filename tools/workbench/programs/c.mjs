// Programs in C.

import { enumValue, parameterOf } from "mip-protocol/tools";
import {
    after,
    alternativeOf,
    brackets,
    cannot,
    flagsOf,
    laidOut,
    numberText,
    operationOf,
    printable,
    refuseOptional,
    responseTo,
    statement,
} from "./common.mjs";
import { hexLiteral } from "../words.mjs";

export function cProgram(names, field, calls) {
    const header = `${names.package}/${names.table.headers[field.name.split(".")[0]]}`;
    if (!calls) {
        const type = names.type(field);
        return [
            `#include "${header}.h"`,
            `struct ${type} value;`,
            `if (${type}_decode(&value, &field) == ${names.package.toUpperCase()}_OK) {`,
            printed(names, field, "value."),
            ...(field.occurrences?.length > 1 ? ["    /* field.descriptor_set is the set of its packet */"] : []),
            "}",
        ].join("\n");
    }
    const lines = [`#include "${header}_commands.h"`];
    calls.forEach((values, i) => {
        lines.push(...cCall(names, field, values, i ? "result = " : `struct ${names.package}_result result = `));
        const { response } = wayOf(names, field, values);
        if (response) lines.push(braced("if (mip_succeeded(result))", printed(names, names.protocol.field(response), "response.")));
    });
    return lines.join("\n");
}

/** The first numbers and texts of a record, except those that may be absent, each with its type. */
export function numbers(names, record, path, member = ({ name }) => names.member(name)) {
    const { protocol } = names;
    const inside = (op, at, fills) => {
        switch (op.kind) {
            case "struct":
                return numbers(names, protocol.type(op.struct), `${at}.`);
            case "array":
                if (fills) return [[at.endsWith("()") ? `${at}.size()` : `${at}_count`, protocol.scalar("u8")]];
                return Array.from({ length: op.count ?? 0 }, (_, i) => inside(op.item, `${at}[${i}]`)).flat();
            case "bits":
                return [[`${at}.bytes[0]`, protocol.scalar("u8")]];
            case "switch":
                return [];
        }
        return [[at, protocol.scalar(op.kind === "text" ? "char" : op.scalar)]];
    };
    return record.parameters
        .filter(({ constant, optional }) => constant === undefined && !optional)
        .flatMap((one) => inside(operationOf(record, one.name), path + member(one), one.length === "rest"))
        .slice(0, 3);
}

/** The statement that prints the first values of a record. */
function printed(names, record, path) {
    const shown = numbers(names, record, path).map(([at, { kind, size }]) => {
        if (kind === "float") return [size === 8 ? "%.10g" : "%g", at];
        if (kind === "char") return ["%s", at];
        return size <= 2 ? [kind === "unsigned" ? "%u" : "%d", at] : ["%lld", `(long long)${at}`];
    });
    if (!shown.length) shown.push(["%s", `"${record.name.split(".").at(-1)}"`]);
    const text = `"${shown.map(([conversion]) => conversion).join(" ")}\\n"`;
    const call = laidOut(brackets("printf(", [text, ...shown.map(([, argument]) => argument)], ");", { comma: "" }), 96);
    return call.replace(/^/gm, "    ");
}

/** A block, on one line if it fits. */
export function braced(head, body) {
    const line = `${head} { ${body.trim()} }`;
    return !body.includes("\n") && line.length <= 100 ? line : `${head} {\n${body}\n}`;
}

/** The function that calls a command with these values, and decodes its response. */
export function wayOf(names, field, values) {
    const function_ = field.calls && names.protocol.functions.get(Number(values.function))?.name;
    const ways = names.table.calls[field.name].filter((way) => way.function === function_);
    const wanted = responseTo(names.protocol, field, values)?.name;
    const way = ways.find(({ response }) => response === wanted) ?? ways[0];
    if (!way) throw cannot("the function has no name");
    return way;
}

/** The declarations before a call, and the call, whose result is assigned. */
function cCall(names, field, values, result) {
    const { protocol } = names;
    refuseOptional(protocol, field, values);
    const way = wayOf(names, field, values);
    const before = [];
    const given = ["device"];
    if (way.whole) {
        before.push(after(`const struct ${names.type(field)} command = `, cRecord(names, field, values)));
        given.push("&command");
    }
    for (const name of way.takes ?? []) {
        const [declared, passed] = cArgument(names, field, parameterOf(field, name), values[name]);
        before.push(...declared);
        given.push(...passed);
    }
    if (way.response) {
        before.push(`struct ${names.type(protocol.field(way.response))} response`);
        given.push("&response");
    }
    const called = brackets(`${result}${way.name}(`, given, ")", { comma: "" });
    return [...before, called].map((line) => laidOut(statement(line), 96));
}

/** The declarations before a call, and its argument. */
function cArgument(names, field, parameter, value) {
    const name = names.table.arguments[parameter.name] ?? parameter.name;
    const op = operationOf(field, parameter.name);
    const count = parameter.length === "rest" ? [String(value.length)] : [];
    if (op.kind === "switch") {
        const union = `const union ${names.type(field)}_${parameter.name} ${name} = `;
        return [[after(union, cUnion(names, parameter, op, value))], [`&${name}`]];
    }
    if (op.kind === "text") return [[], [...count, cString(value)]];
    if (op.kind === "array") {
        if (!value.length) return [[], [...count, "NULL"]];
        const inner = op.item.kind === "array" ? `[${op.item.count}]` : "";
        const array = `const ${cType(names, parameter)} ${name}[]${inner} = `;
        return [[after(array, cValue(names, parameter, op, value))], [...count, name]];
    }
    if (cType(names, parameter).startsWith("struct ")) {
        return [[after(`const ${cType(names, parameter)} ${name} = `, cValue(names, parameter, op, value))], [`&${name}`]];
    }
    const type = names.named(op);
    if (type?.kind === "enum" && type.values.every((one) => one.value <= 0x7fff)) {
        const known = enumValue(type, value);
        return [[], [known ? names.constant(type, known) : `(enum ${names.type(type)})${value}`]];
    }
    return [[], [cValue(names, parameter, op, value)]];
}

/** The type of one item. */
export function cType(names, { type }) {
    const { protocol, table } = names;
    if (table.scalars[type]) return table.scalars[type];
    const known = protocol.type(type);
    if (known.kind === "bitfield" && known.scalar) return names.type(known);
    return table.scalars[known.scalar] ?? `struct ${names.type(known)}`;
}

function cUnion(names, parameter, op, value) {
    const found = alternativeOf(op, value);
    if (!found) return brackets("{", ["0"], "}");
    const { operation } = found;
    const inner = parameter.cases.find((one) => one.parameter?.name === operation.member).parameter;
    return brackets("{", [after(`.${names.member(operation.member)} = `, cValue(names, inner, operation, found.value))], "}");
}

function cRecord(names, record, values) {
    const held = record.parameters
        .filter((parameter) => parameter.constant === undefined && Object.hasOwn(values, parameter.name))
        .map((parameter) => [parameter, operationOf(record, parameter.name), values[parameter.name]])
        .filter(([, op, value]) => names.positional || op.kind !== "switch" || alternativeOf(op, value)) // {0} would lack braces inside
        .map(([parameter, op, value]) => {
            const text = op.kind === "switch" ? cUnion(names, parameter, op, value) : cValue(names, parameter, op, value);
            return names.positional ? text : after(`.${names.member(parameter.name)} = `, text);
        });
    return brackets("{", held.length || names.positional ? held : ["0"], "}");
}

export function cValue(names, parameter, op, value) {
    switch (op.kind) {
        case "counter":
            return String(value);
        case "text":
            return cString(value);
        case "bits":
            return brackets("{", [brackets("{", value.map(String), "}")], "}");
        case "array": {
            const items = value.map((one) => cValue(names, parameter, op.item, one));
            return brackets("{", items.length ? items : ["0"], "}");
        }
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

export function cString(text) {
    const whole = printable(text).trim();
    if (/ {2}/.test(whole)) throw cannot(`${JSON.stringify(text)} has several spaces`);
    return `"${whole.replace(/["\\]/g, "\\$&").replaceAll("??", "?\\?")}"`;
}
