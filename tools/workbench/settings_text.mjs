// Settings of a device as a file of `mip config`: commands and values with the names of the specification.

import { bitsOf, enumValue, isSame, maskOf, MipError, nameIn, parameterOf, readFloat, SHARED_SET, writeFloat } from "mip-protocol/tools";
import { Document, isMap, isScalar, isSeq, LineCounter, parseDocument, Scalar } from "yaml";
import { packetOf } from "./build.mjs";
import { keysOf, parametersOf, settingsOf } from "./settings.mjs";
import { decimal } from "./words.mjs";

const HEAD = ` Settings of a device. \`mip config push PORT FILE\` writes them to a device, and \`mip config save PORT\` makes it keep
 them. A setting that is removed from the file remains as it is on the device.`;

/** Returns a parameter as it is with some other values, and on a device. */
export function here(protocol, parameter, beside, device) {
    const holds = (one) => !one.member && (one.by === "device" ? one.key === device?.id : isSame(one.value, beside[one.by] ?? NaN));
    const { type, ...changed } = Object.assign({}, parameter, ...(parameter.variants ?? []).filter(holds));
    const known = protocol.types.get(type);
    return { ...changed, type, name: parameter.name, known, elements: changed.elements ?? known?.elements };
}

/** Returns the set of the fields that a parameter names: a sibling's value, or always the same set. */
function setOf(protocol, { fields_of: of }, beside, outer) {
    if (!of) return outer;
    return beside[of] === undefined ? protocol.model.sets.find(({ name }) => name === of)?.number : Number(beside[of]);
}

/** Returns the names that a number may have: name -> number. */
function wordsOf(protocol, parameter, set) {
    const { known, shown, only } = parameter;
    if (known?.kind === "enum") {
        return new Map(known.values.filter(({ name }) => !only || only.includes(name)).map(({ name, value }) => [name, value]));
    }
    if (shown === "set") return new Map(protocol.model.sets.map(({ name, number }) => [name, number]));
    if (shown !== "field") return new Map();
    const sets = [protocol.sets.get(set), protocol.sets.get(SHARED_SET)].filter(Boolean);
    const fields = sets.flatMap((one) => one.fields.map((name) => [protocol.field(name), one.number]));
    const data = fields.filter(([{ role }]) => role === "data");
    return new Map(data.map(([field, number]) => [nameIn(field, number).split(".")[1], field.descriptor]).reverse());
}

// ------------------------------------------------------------------------------------------------ writing

/** Returns the text of a file. Settings are { field, values }, with the values to write. */
export function textOf(protocol, device, { model, firmware, date }, settings) {
    const file = new Document({ model, firmware, date });
    file.commentBefore = HEAD;
    if (device) file.get("model", true).comment = ` ${device.title}`;
    const tree = new Map();
    for (const { field, values } of settings) {
        const keys = keysOf(field).map((name) => keyWord(protocol, field, name, values, device));
        const members = parametersOf(field).filter(({ name }) => !keysOf(field).includes(name));
        let inner = tree;
        for (const key of [...field.name.split("."), ...keys].slice(0, -1)) {
            if (!inner.has(key)) inner.set(key, new Map());
            inner = inner.get(key);
        }
        inner.set(keys.at(-1) ?? field.name.split(".")[1], file.createNode(membersTree(protocol, members, values, device), { flow: true }));
    }
    file.set("settings", file.createNode(tree));
    return file.toString({ lineWidth: 0, flowCollectionPadding: false });
}

function keyWord(protocol, field, name, values, device) {
    const parameter = here(protocol, parameterOf(field, name), values, device);
    return numberWord(protocol, parameter, values[name], setOf(protocol, parameter, values));
}

function membersTree(protocol, members, values, device, outer) {
    const present = members.filter(({ name }) => values[name] !== undefined && !isEmptyUnion(values[name]));
    const trees = present.map((parameter) => {
        const one = here(protocol, parameter, values, device);
        return [one.name, treeOf(protocol, one, values[one.name], values, device, setOf(protocol, one, values, outer))];
    });
    return Object.fromEntries(trees);
}

const isEmptyUnion = (value) => typeof value === "object" && !Array.isArray(value) && !Object.keys(value).length;

function treeOf(protocol, parameter, value, beside, device, set) {
    const { known, elements, length, type } = parameter;
    if (parameter.cases) {
        const [member] = Object.keys(value);
        const one = parameter.cases.find((each) => each.parameter?.name === member).parameter;
        return treeOf(protocol, here(protocol, one, beside, device), value[member], beside, device, set);
    }
    if (type === "char") return value;
    if (length !== undefined) {
        const { length: _, ...item } = parameter;
        return value.map((one) => treeOf(protocol, item, one, beside, device, set));
    }
    if (known?.kind === "struct") return membersTree(protocol, parametersIn(known), value, device, set);
    if (elements) return Object.fromEntries(elements.map((name, i) => [name, floatOf(protocol, known.scalar, value[i])]));
    if (known?.kind === "bitfield") return flagWords(protocol, known, value);
    if (protocol.scalar(type)?.kind === "float") return floatOf(protocol, type, value);
    if (type === "bool") return value === 0 || value === 1 ? Boolean(value) : value;
    return numberWord(protocol, parameter, value, set);
}

const parametersIn = (struct) =>
    struct.parameters.filter(({ counts, constant, reserved }) => [counts, constant, reserved].every((one) => one === undefined));

/** Returns a float as the shortest number of its size. */
function floatOf(protocol, scalar, value) {
    const { size } = protocol.scalar(scalar);
    const number = typeof value === "string" ? readFloat(writeFloat(value, size, "value")) : value;
    return Number.isFinite(Number(number)) ? Number(decimal(number, size)) : "nan";
}

function flagWords(protocol, type, value) {
    const { found, rest } = bitsOf(protocol, type, value);
    const set = found.filter(({ bits, value: held }) => held && !bits.alias);
    const words = set.map(({ bits, value: held, flag, named }) => (flag ? bits.name : `${bits.name}=${named?.name ?? held}`));
    return rest ? [...words, rest] : words;
}

function numberWord(protocol, parameter, value, set) {
    return [...wordsOf(protocol, parameter, set)].find(([, number]) => number === Number(value))?.[0] ?? value;
}

// ------------------------------------------------------------------------------------------------ reading

const KEYS = ["model", "firmware", "date", "settings"];

/**
 * The content of a file: { model, settings }, each { field, values, packet, place }. Checks all of it, for a device if
 * given, and throws a MipError with all mistakes, one per line.
 */
export function settingsIn(protocol, text, device) {
    return new File(protocol, text, device).read();
}

class Wrong extends Error {
    constructor(node, message) {
        super(message);
        this.node = node;
    }
}

class File {
    #mistakes = [];
    #lines = new LineCounter();

    constructor(protocol, text, device) {
        Object.assign(this, { protocol, text, device });
    }

    read() {
        const root = this.#parsed();
        if (!isMap(root)) throw new MipError("format", "this is not a settings file; `mip config pull` writes one");
        const parts = this.#keys(root, KEYS, "a settings file");
        if (!parts.model) this.#wrong(root, "'model' is missing; name the device");
        if (!parts.settings) this.#wrong(root, "'settings' is missing");
        const model = parts.model?.value ?? "";
        const settings = parts.settings ? this.#families(parts.settings) : [];
        if (this.#mistakes.length) throw new MipError("format", this.#mistakes.join("\n"));
        return { model, settings };
    }

    /** The nodes of the text, whose values are texts. */
    #parsed() {
        const { contents, errors, warnings } = parseDocument(this.text, {
            schema: "failsafe",
            uniqueKeys: false,
            lineCounter: this.#lines,
            prettyErrors: false,
        });
        const [wrong] = [...errors, ...warnings];
        if (wrong) throw new MipError("format", `${this.#place(wrong.pos[0])}: not YAML: ${wrong.message}`);
        return contents;
    }

    /** Returns the line and column of a position in the text: "3:12". */
    #place(at) {
        const { line, col } = this.#lines.linePos(at);
        return `${line}:${col}`;
    }

    #wrong(node, message) {
        this.#mistakes.push(`${this.#place(node.range[0])}: ${message}`);
    }

    /** Runs a function, and records the mistake that it may throw. */
    #try(act) {
        try {
            return act();
        } catch (error) {
            if (!(error instanceof Wrong)) throw error;
            this.#wrong(error.node, error.message);
            return undefined;
        }
    }

    #pairs(node, what) {
        if (isScalar(node) && ["", "~", "null"].includes(node.value)) return [];
        if (!isMap(node)) {
            this.#wrong(node, `${what} needs keys with values, {name: value}`);
            return [];
        }
        const seen = new Map(); // key -> line
        const items = node.items.filter(({ key }) => {
            const again = seen.has(key.value);
            if (!isScalar(key)) this.#wrong(key, "a key must be one word");
            else if (again) this.#wrong(key, `'${key.value}' is already on line ${seen.get(key.value)}; remove one`);
            else seen.set(key.value, this.#lines.linePos(key.range[0]).line);
            return isScalar(key) && !again;
        });
        const nothing = ({ range: [, end] }) => Object.assign(new Scalar(""), { range: [end, end, end] }); // {key}
        return items.map(({ key, value }) => ({ key, value: value ?? nothing(key) }));
    }

    #keys(node, names, what) {
        const found = {};
        for (const { key, value } of this.#pairs(node, what)) {
            if (names.includes(key.value)) found[key.value] = value;
            else this.#wrong(key, `${what} has no '${key.value}'${hint(key.value, names)}`);
        }
        return found;
    }

    // ---------------------------------------------------------------- commands

    #families(node) {
        const commands = settingsOf(this.protocol);
        const own = this.device && settingsOf(this.protocol, this.device);
        const families = [...new Set(commands.map(({ name }) => name.split(".")[0]))];
        const settings = [];
        for (const [family, inner] of Object.entries(this.#keys(node, families, "'settings'"))) {
            const names = commands.map(({ name }) => name.split(".")).filter(([one]) => one === family);
            const of = names.map(([, name]) => name);
            for (const [name, values] of Object.entries(this.#keys(inner, of, `'${family}'`))) {
                const field = this.protocol.field(`${family}.${name}`);
                if (own && !own.includes(field)) this.#wrong(values, `this device has no setting '${field.name}'; remove it`);
                else this.#instances(field, keysOf(field), {}, values, settings);
            }
        }
        return settings;
    }

    #instances(field, [name, ...rest], selected, node, settings) {
        if (name === undefined) {
            const before = this.#mistakes.length;
            const made = this.#try(() => this.#setting(field, selected, node));
            if (made && this.#mistakes.length === before) settings.push(made);
            return;
        }
        const parameter = here(this.protocol, parameterOf(field, name), selected, this.device);
        const set = setOf(this.protocol, parameter, selected);
        for (const { key, value } of this.#pairs(node, `'${field.name}'`)) {
            const number = this.#try(() => this.#number(parameter, key, set));
            if (number !== undefined) this.#instances(field, rest, { ...selected, [name]: number }, value, settings);
        }
    }

    #setting(field, selected, node) {
        const write = [...this.protocol.functions.values()].find((one) => one.name === "write").value;
        const required = field.calls.find((one) => one.function === "write").required;
        const members = parametersOf(field).filter(({ name }) => selected[name] === undefined);
        const before = this.#mistakes.length;
        const given = this.#members(field, `'${field.name}'`, node, members, required, { ...selected });
        if (this.#mistakes.length > before) return undefined;
        const values = { function: write, ...withReserved(field, given, required) };
        try {
            return { field, values, packet: packetOf(this.protocol, field.set, [{ field, values }]), place: this.#place(node.range[0]) };
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            throw new Wrong(node, `'${field.name}' cannot be sent: ${error.message}`);
        }
    }

    #members(record, what, node, members, required, given, outer) {
        const before = this.#mistakes.length;
        const nodes = this.#keys(
            node,
            members.map(({ name }) => name),
            what,
        );
        const unknown = this.#mistakes.length > before; // perhaps what seems to be missing
        const missing = [];
        const depends = ({ tag, variants }) => Boolean(tag) || (variants ?? []).some(({ by }) => by !== "device");
        for (const parameter of [...members].sort((a, b) => depends(a) - depends(b))) {
            const { name } = parameter;
            const one = here(this.protocol, parameter, given, this.device);
            const found = one.cases && this.#case(record, one, given);
            if (nodes[name] !== undefined) given[name] = this.#try(() => this.#value(one, nodes[name], given, outer, found)) ?? given[name];
            else if (one.cases && !found) given[name] = {};
            else if (required.includes(name)) missing.push(name);
        }
        if (missing.length && !unknown) this.#wrong(node, `${what} needs ${missing.join(", ")} too`);
        return given;
    }

    /** Returns the alternative that the tag's value selects. */
    #case(record, { cases, tag }, given) {
        const type = this.protocol.type(parameterOf(record, tag).type);
        return cases.find((one) => one.tag === enumValue(type, given[tag])?.name)?.parameter;
    }

    // ---------------------------------------------------------------- values

    #value(parameter, node, given, outer, found) {
        const { known, elements, length, type, name } = parameter;
        const set = setOf(this.protocol, parameter, given, outer);
        if (parameter.cases) {
            if (!found) throw new Wrong(node, `'${name}' is not used with this '${parameter.tag}'; remove it`);
            return { [found.name]: this.#value(here(this.protocol, { ...found }, given, this.device), node, given, set) };
        }
        if (type === "char") return this.#text(parameter, node);
        if (length !== undefined) return this.#items(parameter, node, given, set);
        if (known?.kind === "struct") {
            const members = parametersIn(known);
            const values = this.#members(
                known,
                `'${name}'`,
                node,
                members,
                members.map((one) => one.name),
                {},
                set,
            );
            return withReserved(known, values);
        }
        if (elements) return this.#vector(parameter, node);
        if (known?.kind === "bitfield") return this.#flags(known, name, node);
        return this.#number(parameter, node, set);
    }

    #text({ name, length }, node) {
        if (!isScalar(node)) throw new Wrong(node, `'${name}' needs one value`);
        return typeof length === "number" ? node.value.padEnd(length) : node.value;
    }

    #items(parameter, node, given, set) {
        const { length, ...item } = parameter;
        if (!isSeq(node)) throw new Wrong(node, `'${parameter.name}' needs a list, [...]`);
        if (typeof length === "number" && node.items.length !== length) {
            throw new Wrong(node, `'${parameter.name}' needs ${length} values, not ${node.items.length}`);
        }
        return node.items.map((one) => this.#try(() => this.#value({ ...item, fields_of: undefined }, one, given, set)));
    }

    #vector(parameter, node) {
        const { elements, name, known, magnitude } = parameter;
        const found = this.#keys(node, elements, `'${name}'`);
        const missing = elements.filter((one) => !found[one]);
        if (missing.length) throw new Wrong(node, `'${name}' needs ${missing.join(", ")} too`);
        const values = elements.map((one) =>
            this.#number({ ...parameter, type: known.scalar, known: undefined, elements: undefined }, found[one]),
        );
        const size = Math.hypot(...values);
        const [least, most] = magnitude ?? [];
        if ((least ?? 0) > size || (most ?? Infinity) < size) {
            throw new Wrong(
                node,
                `the magnitude of '${name}' must be ${most == null ? `at least ${least}` : `from ${least ?? 0} to ${most}`}`,
            );
        }
        return values;
    }

    #flags(type, name, node) {
        if (!isSeq(node) || !node.items.every(isScalar)) {
            const few = type.bits.slice(0, 3).map((bits) => bits.name);
            throw new Wrong(node, `'${name}' needs a list of flags, [${few.join(", ")}]`);
        }
        let sum = 0n;
        for (const one of node.items) {
            const [flag, number] = one.value.toLowerCase().split("=");
            const bits = type.bits.find((each) => each.name === flag);
            const named =
                number !== undefined && bits?.enum
                    ? this.protocol.type(bits.enum).values.find((each) => each.name === number)?.value
                    : undefined;
            const held = number === undefined ? undefined : (named ?? wholeOf(number));
            if (!bits && wholeOf(flag) === undefined) {
                const names = type.bits.map((each) => each.name);
                throw new Wrong(one, `'${name}' cannot have '${one.value}'${hint(flag, names, `; known: ${names.join(", ")}`)}`);
            }
            if (bits && number !== undefined && !(held >= 0 && BigInt(held) << BigInt(bits.first) <= maskOf(bits))) {
                throw new Wrong(one, `'${one.value}' does not fit; ${flag} has ${bits.last - bits.first + 1} bits`);
            }
            sum |= !bits ? BigInt(wholeOf(flag)) : number === undefined ? maskOf(bits) : BigInt(held) << BigInt(bits.first);
        }
        if (type.scalar) return this.protocol.scalar(type.scalar).size === 8 ? sum : Number(sum);
        return Array.from({ length: type.size }, (_, i) => Number((sum >> BigInt(8 * i)) & 0xffn));
    }

    /** Reads a number, or the name of one. */
    #number(parameter, node, set) {
        const { name, type, known } = parameter;
        if (!isScalar(node)) throw new Wrong(node, `'${name}' needs one value`);
        const words = wordsOf(this.protocol, parameter, set);
        const scalar = this.protocol.scalar(known?.scalar ?? type);
        const value = words.get(node.value) ?? this.#plain(scalar, name, node, words);
        if (known?.kind === "enum" && ![...words.values()].includes(Number(value))) {
            throw new Wrong(node, `'${name}' has no value ${node.value}; known: ${[...words.keys()].join(", ")}`);
        }
        if (scalar.kind === "bool") return value;
        if (!isInside(parameter, value, scalar)) throw new Wrong(node, `'${name}' must be ${rangeOf(parameter)}, not ${node.value}`);
        return scalar.size === 8 && scalar.kind !== "float" ? BigInt(value) : value;
    }

    #plain({ kind }, name, node, words) {
        const { value: text } = node;
        if (words.size && !/^\d/.test(text)) {
            const few = words.size <= 12 ? `; known: ${[...words.keys()].join(", ")}` : "";
            throw new Wrong(node, `'${name}' cannot be '${text}'${hint(text, [...words.keys()], few)}`);
        }
        if (kind === "bool" && /^(?:true|on|yes)$/i.test(text)) return 1;
        if (kind === "bool" && /^(?:false|off|no)$/i.test(text)) return 0;
        const whole = wholeOf(text);
        if (kind !== "float" && whole === undefined) {
            throw new Wrong(node, `${name}: '${text}' is ${kind === "bool" ? "neither true nor false" : "not a whole number"}`);
        }
        const value = kind === "float" ? Number(text.trim() || "none") : whole;
        if (kind === "float" && Number.isNaN(value)) throw new Wrong(node, `${name}: '${text}' is not a number`);
        return value;
    }
}

/** Parses a whole number in decimal, hexadecimal or binary: a BigInt if it is large; undefined for other texts. */
function wholeOf(text) {
    const found = /^([+-]?)(0x[0-9a-f]+|0b[01]+|\d+)$/i.exec(text);
    if (!found || text.length > 100) return undefined;
    const value = BigInt(found[2]) * (found[1] === "-" ? -1n : 1n);
    return Number.isSafeInteger(Number(value)) ? Number(value) : value;
}

/** Is a value within its limits, rounded to the type of the parameter? */
function isInside({ minimum, maximum, above, below, constant }, value, { kind, size }) {
    const held = (limit) => (kind === "float" && size === 4 ? Math.fround(limit) : limit);
    if (kind === "float" && !Number.isFinite(value)) return false;
    return (
        (minimum === undefined || value >= held(minimum)) &&
        (maximum === undefined || value <= held(maximum)) &&
        (above === undefined || value > above) &&
        (below === undefined || value < below) &&
        (constant === undefined || Number(value) === constant)
    );
}

function rangeOf({ minimum, maximum, above, below, constant, units }) {
    if (constant !== undefined) return `${constant}`;
    const bounds = [
        ["at least", minimum],
        ["greater than", above],
        ["at most", maximum],
        ["less than", below],
    ];
    const both = minimum !== undefined && maximum !== undefined;
    const limits = bounds.filter(([, limit]) => limit !== undefined).map((one) => one.join(" "));
    const text = both ? `${minimum} to ${maximum}` : limits.join(", ") || "a number";
    return units?.length === 1 && units[0] !== "1" ? `${text} ${units[0]}` : text;
}

/** Adds reserved values, which files do not contain, also in structures. */
function withReserved(record, given, required = record.parameters.map(({ name }) => name)) {
    const values = { ...given };
    for (const { name, reserved, length } of record.parameters) {
        if (reserved === undefined || !required.includes(name) || values[name] !== undefined) continue;
        values[name] = typeof length === "number" ? Array(length).fill(reserved) : reserved;
    }
    return values;
}

function hint(text, names, otherwise) {
    const ranked = names.map((name) => [likeness(text, name), name]).filter(([share]) => share >= 0.6);
    const near = ranked.sort((a, b) => b[0] - a[0] || (a[1] < b[1] ? 1 : -1)).slice(0, 3);
    return near.length ? `; did you mean ${near.map(([, name]) => `'${name}'`).join(" or ")}?` : (otherwise ?? "; remove it");
}

/** Returns the share of letters that two words have in common, in order. */
function likeness(one, other) {
    let row = Array(other.length + 1).fill(0);
    for (const letter of one) {
        const next = [0];
        for (let j = 1; j <= other.length; j++) next[j] = other[j - 1] === letter ? row[j - 1] + 1 : Math.max(row[j], next[j - 1]);
        row = next;
    }
    return (2 * row.at(-1)) / (one.length + other.length);
}
