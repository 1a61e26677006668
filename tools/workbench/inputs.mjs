// Inputs for parameter values of every kind in the specification, which update the values as you type.

import { bitsNumber, decimation, enumValue, isSame, maskOf, measuredHere, namedType, parameterOf, unitOf } from "mip-protocol/tools";
import { initialValue } from "./build.mjs";
import { element } from "./dom.mjs";
import { baseOf } from "./stream.mjs";
import { choicesOf, decimal, hexLiteral } from "./words.mjs";

let lastInput = 0; // for ids

export function labelled(words, control, ...behind) {
    control.id ||= `mip-input-${++lastInput}`;
    return element("p", element("label", { for: control.id }, `${words} `), control, ...behind);
}

export function select(options, value, set) {
    const known = options.map(([number, words]) => element("option", { value: number, selected: isSame(number, value) }, words));
    const control = element("select", known);
    control.addEventListener("input", () => set(numberOfText(control.value, "unsigned")));
    return control;
}

/** Creates the inputs of one operation, which update `values` of the context. */
export function input(context, op) {
    if (op.kind === "constant" || op.kind === "counter") return [];
    const { protocol, record, values, events, device } = context;
    const parameter = measuredHere(protocol, parameterOf(record, op.member) ?? { name: op.member }, values, device);
    const name = op.member;
    const set = (value) => {
        values[name] = value;
        events.changed();
    };
    const hint = [unitOf(parameter), parameter.description].filter(Boolean).join(" · ");
    const note = hint ? [" ", element("small", hint)] : [];
    const inside = (struct, inner) => ({ ...context, record: struct, values: inner, outer: { parameter, values } });
    switch (op.kind) {
        case "scalar":
            return [scalarInput(context, op, parameter, note)];
        case "bits":
            return [bitsInput(name, protocol.type(op.type), values[name], (number) => set(littleEndian(number, op.size)))];
        case "text": {
            const control = element("input", { value: values[name].trimEnd(), maxlength: op.count ?? op.capacity });
            control.addEventListener("input", () => set(control.value.padEnd(op.count ?? 0)));
            return [labelled(name, control, note)];
        }
        case "struct": {
            const struct = protocol.type(op.struct);
            return [
                group(
                    name,
                    hint,
                    struct.operations.flatMap((part) => input(inside(struct, values[name]), part)),
                ),
            ];
        }
        case "switch": {
            const selected = op.cases.find((one) => isSame(one.value, values[op.tag]))?.operation;
            return selected ? [group(name, hint, input({ ...context, values: values[name] }, selected))] : [];
        }
        default:
            return [arrayInput(context, op, parameter, hint)];
    }
}

function scalarInput(context, op, parameter, note) {
    const { protocol, record, values, events, device } = context;
    const name = op.member;
    const type = namedType(protocol, parameter, values, device);
    const { kind, size } = protocol.scalar(op.scalar);
    const shapes = record.parameters.some((one) =>
        [one.tag, one.fields_of, ...(one.variants ?? []).map((variant) => variant.by)].includes(name),
    );
    const set = (value) => {
        values[name] = value;
        if (!shapes) return events.changed();
        for (const union of unionsOf(record, name)) values[union.member] = initialValue(protocol, union, record, values);
        events.reshaped();
    };
    if (type?.kind === "enum") return labelled(name, ...enumInput(type, values[name], set), note);
    if (type?.kind === "bitfield") return bitsInput(name, type, values[name], set);
    if (kind === "bool") {
        const control = element("input", { type: "checkbox", checked: Boolean(values[name]) });
        control.addEventListener("input", () => set(control.checked ? 1 : 0));
        return labelled(name, control, note);
    }
    const rate = name === "decimation" && rateInput(context, set);
    if (rate) return labelled(name, ...rate, note);
    if (!parameter.shown) return labelled(name, numberInput(values[name], kind, size, set), note);
    return labelled(name, ...hexInput(context, parameter, values[name], size, set), note);
}

/** Offers the names of an enumeration, and any other number, because enumerations are open. */
function enumInput(type, value, set) {
    const known = type.values.map((one) => [one.value, `${one.value} ${one.name}`]);
    const other = enumValue(type, value) ? undefined : value;
    const control = element(
        "select",
        [...known, ["other", "another number"]].map(([number, words]) =>
            element("option", { value: number, selected: other === undefined ? isSame(number, value) : number === "other" }, words),
        ),
    );
    const number = element("input", {
        value: String(other ?? ""),
        hidden: other === undefined,
        "aria-label": "another number",
        spellcheck: "false",
    });
    control.addEventListener("input", () => {
        number.hidden = control.value !== "other";
        set(numberOfText(number.hidden ? control.value : number.value, "unsigned"));
    });
    number.addEventListener("input", () => set(numberOfText(number.value, "unsigned")));
    return [control, " ", number];
}

let lastList = 0; // for ids

/** Creates an input for a number that is usually hexadecimal, with sets or fields to choose from, and its meaning. */
function hexInput(context, parameter, value, size, set) {
    const control = element("input", { value: hexOf(value, size), spellcheck: "false", class: "mip-hex" });
    const { protocol, values, outer } = context;
    const choices = choicesOf(protocol, parameter, values, outer);
    const meaning = element("small.mip-meant", choices.get(Number(value)) ?? "");
    control.addEventListener("input", () => {
        const number = numberOfText(control.value, "unsigned");
        meaning.textContent = choices.get(Number(number)) ?? "";
        set(number);
    });
    if (!choices.size) return [control, meaning];
    const list = element(
        "datalist",
        { id: `mip-list-${++lastList}` },
        [...choices].map(([number, words]) => element("option", { value: hexOf(number, size) }, words)),
    );
    control.setAttribute("list", list.id);
    return [control, list, " ", meaning];
}

function hexOf(value, size) {
    return typeof value === "string" || Number.isNaN(value) ? String(value) : hexLiteral(value, size);
}

/** Creates an input for a decimation, with the resulting rate in Hz on the chosen device, if the base rate is known. */
function rateInput({ protocol, device, values, outer }, set) {
    const { base } = baseOf(protocol, device, outer);
    if (!base) return undefined;
    const number = element("input", { value: String(values.decimation), spellcheck: "false", class: "mip-short" });
    const rate = element("input", { inputmode: "decimal", spellcheck: "false", "aria-label": "Rate in Hz", class: "mip-short mip-hertz" });
    const tell = () => {
        const hertz = base / values.decimation;
        rate.value = Number.isFinite(hertz) ? String(Number(hertz.toPrecision(6))) : "";
    };
    number.addEventListener("input", () => {
        set(numberOfText(number.value, "unsigned"));
        tell();
    });
    rate.addEventListener("input", () => {
        const wanted = Number(rate.value);
        if (!(wanted > 0)) return;
        number.value = String(decimation(base, wanted));
        set(Number(number.value));
    });
    rate.addEventListener("change", tell); // shows the nearest possible rate
    tell();
    return [number, " = ", rate, " Hz"];
}

/** Returns the unions of a record that a parameter selects. */
function unionsOf(record, tag) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op])).filter((op) => op.kind === "switch" && op.tag === tag);
}

function numberInput(value, kind, size, set) {
    const text = kind === "float" && typeof value === "number" ? decimal(value, size) : String(value);
    const control = element("input", { value: text, inputmode: kind === "float" ? "decimal" : "text", spellcheck: "false" });
    control.addEventListener("input", () => set(numberOfText(control.value, kind)));
    return control;
}

/** Parses a number as people write it: 0x1F, 12, -0.5; for a float, also its bits, 0x with all digits. */
function numberOfText(text, kind) {
    const trimmed = text.trim();
    if (kind === "float") return floatOfText(trimmed);
    if (/^-?(\d+|0x[0-9a-f]+)$/i.test(trimmed)) {
        const number = trimmed.startsWith("-") ? -BigInt(trimmed.slice(1)) : BigInt(trimmed);
        return Number.isSafeInteger(Number(number)) ? Number(number) : number;
    }
    return trimmed;
}

/** A text that is not a number, or a number that is too large, stays a text, which encoding rejects. */
function floatOfText(text) {
    const words = { nan: NaN, inf: Infinity, infinity: Infinity, "-inf": -Infinity, "-infinity": -Infinity };
    if (Object.hasOwn(words, text.toLowerCase())) return words[text.toLowerCase()];
    const number = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN;
    return Number.isFinite(number) ? number : text;
}

/** Creates an input for the whole number, and one for each name in it. */
function bitsInput(name, type, value, set) {
    let number = bitsNumber(value);
    const whole = element("input", { spellcheck: "false" });
    const named = type.bits.map((bits) => {
        const flag = bits.first === bits.last;
        const control = element("input", { type: flag ? "checkbox" : "number", min: flag ? undefined : 0 });
        control.addEventListener("input", () => {
            const held = flag ? Number(control.checked) : Math.max(0, Math.trunc(Number(control.value)));
            change((number & ~maskOf(bits)) | ((BigInt(held) << BigInt(bits.first)) & maskOf(bits)));
        });
        return { bits, flag, control };
    });
    const showAll = () => {
        for (const { bits, flag, control } of named) {
            const held = (number & maskOf(bits)) >> BigInt(bits.first);
            if (flag) control.checked = held === 1n;
            else control.value = held;
        }
    };
    const change = (changed) => {
        number = changed;
        whole.value = hexLiteral(number);
        showAll();
        set(number);
    };
    whole.addEventListener("input", () => {
        const given = numberOfText(whole.value, "unsigned");
        if (typeof given === "string" || Number.isNaN(given)) return set(given);
        number = BigInt(given);
        showAll();
        set(number);
    });
    whole.value = hexLiteral(number);
    showAll();
    const controls = named.map(({ bits, control }) => labelled(bits.name, control, " ", element("small", bits.description)));
    return group(name, type.description, [labelled("value", whole), ...controls]);
}

/** Returns the bytes of a bitfield in bytes; any other value, or one that is too large, is an error when encoded. */
function littleEndian(number, size) {
    if (typeof number !== "bigint" || number < 0n || number >> BigInt(8 * size)) return [number];
    return Array.from({ length: size }, (_, i) => Number((number >> BigInt(8 * i)) & 0xffn));
}

/** Creates inputs for the elements of vectors and arrays; elements of a counted array can be added and removed. */
function arrayInput(context, op, parameter, hint) {
    const { protocol, values, events } = context;
    const items = values[op.member];
    const record = { parameters: [{ ...parameter, name: op.item.member, default: undefined, cases: undefined }], operations: [op.item] };
    const names = op.vector && parameter.elements;
    const rows = items.map((_, i) => {
        const holder = {
            get [op.item.member]() {
                return items[i];
            },
            set [op.item.member](value) {
                items[i] = value;
            },
        };
        const variants = parameter.variants?.filter((one) => one.type); // units are those of the element already
        const one = { ...record.parameters[0], description: "", units: [unitOf(parameter, i)], variants };
        if (Object.hasOwn(values, one.fields_of ?? "")) holder[one.fields_of] = values[one.fields_of];
        const [control] = input(
            { ...context, values: holder, record: { ...record, parameters: [one] }, outer: { parameter, values } },
            op.item,
        );
        const label = control.querySelector(":scope > label, :scope > legend");
        label.textContent = `${names?.[i] ?? `${op.member}[${i}]`} `;
        return control;
    });
    if (op.count !== undefined) return group(op.member, hint, rows);
    const add = () => {
        items.push(items.length ? structuredClone(items.at(-1)) : initialValue(protocol, op.item, record, {}));
        events.reshaped();
    };
    const remove = () => {
        items.pop();
        events.reshaped();
    };
    const buttons = element(
        "p",
        element("button", { type: "button", onclick: add, disabled: items.length >= op.capacity }, `Add to ${op.member}`),
        " ",
        element("button", { type: "button", onclick: remove, disabled: items.length === 0 }, "Remove the last"),
    );
    return group(op.member, hint, [...rows, buttons]);
}

function group(name, hint, controls) {
    return element("fieldset", element("legend", name), hint && element("small", hint), controls);
}
