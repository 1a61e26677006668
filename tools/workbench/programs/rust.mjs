// Programs in Rust.

import { alternativeOf, brackets, callOf, fail, isDerived, isReserved, laidOut, numberText, operationOf, printable } from "./common.mjs";

export function rustProgram(names, field, calls) {
    if (!calls) {
        const first = field.parameters.find((one) => !isDerived(one));
        const read = first ? `value.${names.member(first.name)}` : "value";
        const found = `packet.find::<${names.type(field)}>()?`; // a broken one is an error, as a refused command is
        return rustUses(names, `if let Some(value) = ${found} {\n    println!("{:?}", ${read});\n}`);
    }
    const lines = [];
    for (const values of calls) {
        const { way, taken, asks } = callOf(names, field, values);
        const made = way ? names.table.constructors[way] : "new";
        const head = `${asks ? 'println!("{:?}", ' : ""}device.request(&${names.type(field)}::${made}(`;
        const given = rustGiven(names, field, taken, values);
        lines.push(laidOut(brackets(head, given, asks ? "))?);" : "))?;"), 84));
    }
    return rustUses(names, lines.join("\n"));
}

/** A program, with its imports and declarations first. */
function rustUses(names, text) {
    const used = [...names.used].sort();
    return `use ${names.package}_protocol::${used.length === 1 ? used[0] : `{${used.join(", ")}}`};\n${text}`;
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
            if (op.count === undefined) return `${names.item("VarText")}::new("${text}").unwrap()`;
            return brackets(`${names.item("Text")}(`, [`*b"${text}"`], ")");
        }
        case "bits":
            return brackets(`${names.type(names.named(op))}(`, [brackets("[", value.map(String), "]")], ")");
        case "array": {
            const items = value.map((one) => rustInner(names, record, parameter, op.item, one));
            const array = brackets("[", items, "]");
            return op.vector ? brackets(`${names.item(names.table.vectors[op.vector])}::from(`, [array], ")") : array;
        }
        case "struct": {
            const struct = names.protocol.type(op.struct);
            return brackets(`${names.type(struct)}::new(`, rustGiven(names, struct, struct.parameters, value), ")");
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
    const union = names.item(names.table.unions[`${record.name}.${parameter.name}`]);
    const found = alternativeOf(op, value);
    const inner = found && parameter.cases.find((one) => one.parameter?.name === found.operation.member);
    const tag = (inner ?? parameter.cases.find((one) => !one.parameter))?.tag ?? fail(`${parameter.name} has no case`);
    const variant = `${union}::${names.table.variants[tag]}`;
    return inner ? brackets(`${variant}(`, [rustInner(names, record, inner.parameter, found.operation, found.value)], ")") : variant;
}

/** Inner values have a `Bool`, where constructors take a `bool`. */
function rustInner(names, record, parameter, op, value) {
    if (op.kind === "scalar" && names.protocol.scalar(op.scalar).kind === "bool") return `${names.item("Bool")}(${Number(value)})`;
    return rustValue(names, record, parameter, op, value);
}
