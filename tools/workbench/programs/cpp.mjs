// Programs in C++, whose structures and numbers are written as in C.

import { enumValue, parameterOf } from "mip-protocol/tools";
import { cRecord, cString, cType, cUnion, cValue, wayOf } from "./c.mjs";
import { after, brackets, flagsOf, isDerived, isUnion, laidOut, Names, operationOf, refuseOptional, statement } from "./common.mjs";
import { hexLiteral } from "../words.mjs";

export function cppProgram(names, field, calls) {
    const c = new Names(names.protocol, "c");
    const header = `${names.package}/${c.table.headers[field.name.split(".")[0]]}`;
    if (!calls) return reading(names, c, field, header);
    const lines = [`#include "${header}_commands.hpp"`];
    calls.forEach((values, i) => {
        const name = i ? "answer" : "result";
        lines.push(...call(names, c, field, values, `const auto ${name} = `));
    });
    return lines.join("\n");
}

function reading(names, c, field, header) {
    const held = field.parameters.filter((one) => !isDerived(one) && (!isUnion(one) || one.cases?.some((x) => x.parameter)));
    const members = held.map((one) => `value->${isCalled(names, one) ? `${names.member(one.name)}()` : c.member(one.name)}`);
    const read = members.slice(0, 3).join(", ") + (members.length > 3 ? " …" : "");
    return [
        `#include "${header}.hpp"`,
        `if (const auto value = field.as<${names.type(field)}>()) {`,
        `    // ${read || "it has no values"}`,
        ...(field.occurrences?.length > 1 ? ["    // field.descriptor_set is the set of its packet"] : []),
        "}",
    ].join("\n");
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
        const command = after(`const ${c.type(field)} command = `, cRecord(c, field, values));
        return [statement(command), brackets(`${result}device.call(`, ["command"], ");", { comma: "" })].map((line) => laidOut(line, 96));
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

/** The declarations before a command, and its member. */
function argument(names, c, field, parameter, value) {
    const op = operationOf(field, parameter.name);
    if (op.kind === "switch") return [[], cUnion(c, parameter, op, value)];
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
