// Programs in JavaScript.

import { bitsNumber } from "mip-protocol/tools";
import { after, alternativeOf, brackets, callOf, isDerived, isReserved, laidOut, numberText, operationOf, printable } from "./common.mjs";
import { hexLiteral } from "../words.mjs";

export function javascriptProgram(names, field, calls) {
    if (!calls) {
        const read = field.parameters.filter((one) => !isDerived(one)).map((one) => `value.${names.member(one.name)}`);
        const shown = laidOut(brackets("console.log(", read.length ? read.slice(0, 3) : ["value"], ");", { comma: "" }), 84);
        return withImports(names, [`for await (const value of device.fields(${names.type(field)})) {`, `    ${shown}`, "}"]);
    }
    const lines = [];
    for (const values of calls) {
        const { way, taken, asks } = callOf(names, field, values);
        const made = way ? `${names.type(field)}.${names.member(way)}(` : `new ${names.type(field)}(`;
        const given = membersOf(names, field, taken, values);
        const call = way && !given.items.length ? brackets("", [], "") : given;
        const head = `${asks ? "console.log(" : ""}await device.request(${made}`;
        lines.push(laidOut(after(head, { ...call, tail: `${call.tail}))${asks ? ")" : ""};` }), 84));
    }
    return withImports(names, lines);
}

/** A program, with its imports first. */
function withImports(names, lines) {
    const needs = [...names.imports].sort(([a], [b]) => (a < b ? -1 : 1));
    const imports = needs.map(([module, used]) => `import { ${[...used].sort().join(", ")} } from "${module}";`);
    return [...imports, ...lines].join("\n");
}

/** An object with the members that a constructor takes: nothing that is reserved. */
function membersOf(names, record, parameters, values) {
    const items = parameters
        .filter((one) => !isDerived(one) && !isReserved(one))
        .map((one) => after(`${names.member(one.name)}: `, literalOf(names, record, one, operationOf(record, one.name), values[one.name])));
    return brackets("{", items, "}", { pad: " " });
}

function literalOf(names, record, parameter, op, value) {
    switch (op.kind) {
        case "text":
            return JSON.stringify(printable(value));
        case "bits":
            return `${hexLiteral(bitsNumber(value)).toLowerCase()}n`;
        case "array": {
            const items = value.map((one) => literalOf(names, record, parameter, op.item, one));
            return brackets("[", items, "]");
        }
        case "struct": {
            const struct = names.protocol.type(op.struct);
            return membersOf(names, struct, struct.parameters, value);
        }
        case "switch": {
            const found = alternativeOf(op, value);
            const inner = found && parameter.cases.find((one) => one.parameter?.name === found.operation.member).parameter;
            const items = inner
                ? [after(`${names.member(inner.name)}: `, literalOf(names, record, inner, found.operation, found.value))]
                : [];
            return brackets("{", items, "}", { pad: " " });
        }
    }
    const { kind, size } = names.protocol.scalar(op.scalar);
    if (kind === "bool") return Number(value) ? "true" : "false";
    const big = size === 8 && kind !== "float" ? "n" : "";
    const highest = size === 4 && Number(value) >= 2 ** 31; // operators on bits would make it negative
    const text = numberText(names, parameter, op, value, {
        float: (one) => one,
        known: (type, one) => ({ named: names.constant(type, one) }),
        flags: (one) => ({ named: highest ? one.replaceAll(" | ", " + ") : one }),
        other: (_, one) => one,
    });
    return text.named ?? text + big;
}
