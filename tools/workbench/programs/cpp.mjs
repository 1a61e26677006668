// Programs in C++, whose structures and numbers are written as in C.

import { enumValue, parameterOf } from "mip-protocol/tools";
import { braced, cString, cType, cValue, numbers, wayOf } from "./c.mjs";
import { after, alternativeOf, brackets, flagsOf, isDerived, laidOut, Names, operationOf, refuseOptional, statement } from "./common.mjs";
import { hexLiteral } from "../words.mjs";

export function cppProgram(names, field, calls) {
    const c = new Names(names.protocol, "c");
    c.positional = true; // C++17 has no designated initializers
    const header = `${names.package}/cpp/${c.table.headers[field.name.split(".")[0]]}`;
    if (!calls) return reading(names, c, field, header);
    const lines = [`#include "${header}_commands.hpp"`];
    calls.forEach((values, i) => {
        const name = i ? "answer" : "result";
        lines.push(...call(names, c, field, values, `const auto ${name} = `));
        const { response } = wayOf(c, field, values);
        if (response) lines.push(braced(`if (${name})`, printed(names, c, names.protocol.field(response), `${name}->`)));
    });
    return lines.join("\n");
}

function reading(names, c, field, header) {
    return [
        `#include "${header}.hpp"`,
        `if (const auto value = field.as<${names.type(field)}>()) {`,
        printed(names, c, field, "value->"),
        ...(field.occurrences?.length > 1 ? ["    // field.descriptor_set is the set of its packet"] : []),
        "}",
    ].join("\n");
}

/** The statement that prints the first values of data or a response. */
function printed(names, c, field, path) {
    const member = (one) => (isCalled(names, one) ? `${names.member(one.name)}()` : c.member(one.name));
    const shown = numbers(c, field, path, member).map(([at, { kind, size }]) => {
        return size === 1 && kind !== "char" && !at.endsWith(")") ? `+${at}` : at;
    });
    if (!shown.length) shown.push(`"${field.name.split(".").at(-1)}"`);
    const line = `    std::cout << ${shown.join(" << ' ' << ")} << '\\n';`;
    return line.length <= 96 ? line : line.replaceAll(" << ' '", "\n              << ' '");
}

/** Does it have a function in place of a member, as it may be absent, has names, or varies in size? */
function isCalled({ protocol }, { type, length, optional }) {
    if (type === undefined) return false;
    const { kind, scalar } = protocol.types.get(type) ?? {};
    if (length === undefined) return optional || kind === "enum" || (kind === "bitfield" && scalar !== undefined);
    return type === "char" || typeof length === "string";
}

/** The declarations before a call, and the call, whose result is assigned. */
function call(names, c, field, values, result) {
    refuseOptional(names.protocol, field, values);
    const way = wayOf(c, field, values);
    if (way.whole) {
        const before = [`${c.type(field)} command = {}`, ...assigned(c, field, values, "command.")].map(statement);
        return [...before, brackets(`${result}device.call(`, ["command"], ");", { comma: "" })].map((line) => laidOut(line, 96));
    }
    const before = [];
    const given = [];
    for (const parameter of way.takes?.map((name) => parameterOf(field, name)) ?? []) {
        if (isDerived(parameter)) continue;
        const [declared, member] = argument(names, c, field, parameter, values[parameter.name]);
        before.push(...declared);
        given.push(member);
    }
    const asked = brackets(`${result}device.call(${way.cpp}{`, given, "});", { comma: "" });
    return [...before.map(statement), asked].map((line) => laidOut(line, 96));
}

/** The assignments of the numbers of a record, or of a value. */
function assigned(c, record, values, path) {
    const held = record.parameters.filter(({ constant, name }) => constant === undefined && Object.hasOwn(values, name));
    return held.flatMap((one) => assignments(c, one, operationOf(record, one.name), values[one.name], path + c.member(one.name)));
}

function assignments(c, parameter, op, value, path) {
    if (op.kind === "struct") return assigned(c, c.protocol.type(op.struct), value, `${path}.`);
    if (op.kind === "array") return value.flatMap((one, i) => assignments(c, parameter, op.item, one, `${path}[${i}]`));
    if (op.kind !== "switch") return [after(`${path} = `, cValue(c, parameter, op, value))];
    const found = alternativeOf(op, value);
    if (!found) return [];
    const { parameter: inner } = parameter.cases.find((one) => one.parameter?.name === found.operation.member);
    return assignments(c, inner, found.operation, found.value, `${path}.${c.member(inner.name)}`);
}

/** The declarations before a command, and its member. */
function argument(names, c, field, parameter, value) {
    const op = operationOf(field, parameter.name);
    if (op.kind === "switch") {
        if (!alternativeOf(op, value)) return [[], "{}"];
        const name = names.member(parameter.name);
        const declared = `${c.type(field)}_${parameter.name} ${name} = {}`; // an initializer would set its first member
        return [[declared, ...assignments(c, parameter, op, value, name)], name];
    }
    if (op.kind === "text") return [[], cString(value)];
    if (op.kind === "array" && !value.length) return [[], "{}"];
    if (op.kind === "array" && typeof parameter.length === "string") {
        const struct = names.protocol.types.get(parameter.type);
        const one = struct?.kind === "struct" ? names.type(struct) : cType(c, parameter);
        const name = names.member(parameter.name);
        const inner = op.item.kind === "array" ? `[${op.item.count}]` : "";
        return [[after(`const ${one} ${name}[]${inner} = `, cValue(c, parameter, op, value))], name];
    }
    const type = op.kind === "scalar" ? names.named(op) : undefined;
    if (type?.kind === "enum") {
        const known = enumValue(type, value);
        return [[], known ? names.constant(type, known) : `static_cast<${names.type(type)}>(${value})`];
    }
    if (type?.kind === "bitfield") {
        const flags = flagsOf(type, value).map((bits) => names.constant(type, bits));
        const number = parameter.shown ? hexLiteral(value, names.protocol.scalar(op.scalar).size) : value;
        return [[], flags.join(" | ") || `static_cast<${names.type(type)}>(${number})`];
    }
    return [[], cValue(c, parameter, op, value)];
}
