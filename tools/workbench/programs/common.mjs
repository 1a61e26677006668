// Parts of programs in all languages: names of the bindings, the parts of a call, and expressions that are laid out.

import { bitsNumber, enumValue, maskOf, memberName, MipError } from "mip-protocol/tools";
import { decimalLiteral, hexLiteral } from "../words.mjs";

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

export class Names {
    constructor(protocol, language) {
        this.protocol = protocol;
        this.language = language;
        this.table = protocol.model.programs[language];
        this.package = protocol.model.package; // begins the names of the bindings
        this.used = new Set(); // imports of a program: modules of Python, items of the crate
        this.imports = new Map(); // of JavaScript: module -> names
    }

    member(name) {
        if (this.language === "javascript") return memberName(name);
        return this.table.members[name] ?? name;
    }

    /** A value of an enumeration, or a bit. */
    constant(type, part) {
        if (this.language === "c") return `${type.symbols.c}_${part.short ?? part.name}`.toUpperCase();
        const usual = this.language === "cpp" ? part.name : part.name.toUpperCase();
        const between = ["cpp", "rust"].includes(this.language) ? "::" : ".";
        return this.type(type) + between + (this.table.constants[part.name] ?? usual);
    }

    /** A type or a field; its imports are noted. */
    type({ symbols }) {
        const symbol = symbols[this.language];
        if (this.language === "c" || this.language === "cpp") return symbol;
        if (this.language === "javascript") return this.imported(...symbol.split("."));
        const path = symbol.replace(/^\w+_protocol(\.|::)/, "");
        if (this.language === "rust") return this.item(path);
        const [module, name] = path.split(".");
        this.used.add(module);
        return `${this.local(module)}.${name}`;
    }

    imported(module, name) {
        if (!this.imports.has(module)) this.imports.set(module, new Set());
        this.imports.get(module).add(name);
        return name;
    }

    /** The name of a module in a Python program. */
    local(module) {
        return this.table.modules[module] ?? module;
    }

    /** An item of the crate. */
    item(path) {
        this.used.add(path.split("::")[0]);
        return path;
    }

    named(op) {
        return op.type === undefined ? undefined : this.protocol.type(op.type);
    }
}

export function cannot(what) {
    return new MipError("program", `no program can be given here: ${what}`);
}

function flatOperations(record) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op]));
}

/** The operation of a parameter of a field or a structure. */
export function operationOf(record, name) {
    return flatOperations(record).find((op) => op.member === name);
}

export const isDerived = (parameter) => parameter.constant !== undefined || parameter.counts !== undefined;
export const isReserved = (parameter) => parameter.reserved !== undefined;
export const isUnion = (parameter) => parameter.type === undefined;

/** The parameters that a command requires with these values. */
export function requiredParameters(protocol, field, values) {
    const all = field.parameters.filter((parameter) => !parameter.selector);
    return all.slice(0, protocol.required(field, values.function));
}

/** Returns the name of the function that a call selects, the parameters that it takes, and whether a response comes. */
export function callOf({ protocol }, field, values) {
    refuseOptional(protocol, field, values);
    const taken = requiredParameters(protocol, field, values).filter((one) => !isDerived(one) && !isReserved(one));
    const way = field.calls && protocol.functions.get(Number(values.function))?.name;
    return { way, taken, asks: responseTo(protocol, field, values) !== undefined };
}

export function refuseOptional(protocol, field, values) {
    const required = new Set(requiredParameters(protocol, field, values).map((parameter) => parameter.name));
    const more = field.parameters.find(({ name, selector }) => !selector && !required.has(name) && values[name] !== undefined);
    if (more) throw cannot(`${more.name} is optional; set it in the object of the command`);
}

/** Refuses other values of reserved parameters, which constructors would replace. */
export function refuseReserved(protocol, record, values) {
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
export function alternativeOf(op, value) {
    const found = op.cases.find((one) => one.operation && Object.hasOwn(value, one.operation.member));
    return found && { ...found, value: value[found.operation.member] };
}

/** The flags that make up a value; none if it has other bits, or numbers, too. */
export function flagsOf(type, value) {
    const number = bitsNumber(value);
    const flags = type.bits.filter((bits) => bits.first === bits.last && !bits.alias && number & maskOf(bits));
    return flags.reduce((sum, bits) => sum | maskOf(bits), 0n) === number ? flags : [];
}

export function printable(text) {
    if (/[^ -~]/.test(text)) throw cannot(`${JSON.stringify(text)} has characters that are not ASCII`);
    return text;
}

/** An expression with others in brackets: a call, a list, a structure. `comma` follows the last of several lines;
 * in one line, `alone` follows the only item, and `pad` is inside the brackets. */
export function brackets(head, items, tail, { comma = ",", alone = "", pad = "" } = {}) {
    return { head, items, tail, comma, alone, pad };
}

/** An expression after a text. */
export function after(text, expression) {
    return typeof expression === "string" ? text + expression : { ...expression, head: text + expression.head };
}

export function statement(expression) {
    return typeof expression === "string" ? `${expression};` : { ...expression, tail: `${expression.tail};` };
}

/** An expression in one line. */
function flat(expression) {
    if (typeof expression === "string") return expression;
    const { head, items, tail, alone, pad } = expression;
    if (!items.length) return head + tail;
    return `${head}${pad}${items.map(flat).join(", ")}${items.length === 1 ? alone : ""}${pad}${tail}`;
}

/** So many items without brackets are elements of an array, several of which are on a line. */
const ARRAY = 13;

/** An expression, with a line for each item in brackets if one line is too long. Those of long arrays fill lines. */
export function laidOut(expression, width) {
    const line = flat(expression);
    if (line.length <= width || typeof expression === "string" || expression.items.length === 0) return line;
    const { head, items, tail, comma } = expression;
    const inner = flat({ ...expression, head: "", tail: "", pad: "" });
    if (inner.length <= width - 4) return `${head}\n    ${inner}\n${tail}`;
    if (items.length >= ARRAY && items.every((item) => typeof item === "string")) {
        const filled = (inner + comma).replace(new RegExp(`(.{1,${width - 4}})(?: |$)`, "g"), "    $1\n");
        return `${head}\n${filled}${tail}`;
    }
    const each = items.map((item) => `    ${laidOut(item, width - 5).replaceAll("\n", "\n    ")}`);
    return `${head}\n${each.join(",\n")}${comma}\n${tail}`;
}

/** A number of a parameter; `known` writes the name of a value, `flags` names of bits, `other` another number of a type. */
export function numberText(names, parameter, op, value, { float, known, flags, other }) {
    const { kind, size } = names.protocol.scalar(op.scalar);
    if (kind === "float") return float(decimalLiteral(value, size) ?? fail(`${op.member} is not a finite number`), size);
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

export function fail(why) {
    throw cannot(why);
}
