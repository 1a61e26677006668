// Programs in Python.

import { bitsNumber } from "mip-protocol/tools";
import {
    after,
    alternativeOf,
    brackets,
    callOf,
    isDerived,
    isReserved,
    isUnion,
    laidOut,
    numberText,
    operationOf,
    printable,
} from "./common.mjs";
import { hexLiteral } from "../words.mjs";

export function pythonProgram(names, field, calls) {
    if (!calls) {
        const read = field.parameters.filter((one) => !isDerived(one)).map((one) => `value.${names.member(one.name)}`);
        return pythonImports(
            names,
            `for stamp, value in device.fields(${names.type(field)}):\n    ${laidOut(brackets("print(", ["stamp.device", ...read.slice(0, 3)], ")"), 84)}`,
        );
    }
    const lines = [];
    for (const values of calls) {
        const { way, taken, asks } = callOf(names, field, values);
        const given = taken.map((one) => pythonValue(names, field, one, operationOf(field, one.name), values[one.name]));
        const head = `${asks ? "print(" : ""}device.request(${names.type(field)}${way ? `.${names.member(way)}` : ""}(`;
        lines.push(laidOut(brackets(head, given, asks ? ")))" : "))"), 84));
    }
    return pythonImports(names, lines.join("\n"));
}

/** A program, with its imports and declarations first. */
function pythonImports(names, text) {
    const imports = [...names.used].sort().map((name) => (names.local(name) === name ? name : `${name} as ${names.local(name)}`));
    return `from ${names.package}_protocol import ${imports.join(", ")}\n${text}`;
}

function pythonValue(names, record, parameter, op, value) {
    switch (op.kind) {
        case "text":
            return `"${printable(value).replace(/["\\]/g, "\\$&")}"`;
        case "bits":
            return `${names.type(names.named(op))}(${hexLiteral(bitsNumber(value)).toLowerCase()})`;
        case "array": {
            const items = value.map((one) => pythonValue(names, record, parameter, op.item, one));
            return brackets("(", items, ")", { alone: "," });
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
        return [byName ? after(`${names.member(one.name)}=`, text) : text];
    });
    return brackets(`${names.type(struct)}(`, given, ")");
}
