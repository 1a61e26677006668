// The builder: choose a command or a field, fill it in, and see its bytes and the answer.

import { MipError } from "../mip/bytes.mjs";
import { bitsNumber, maskOf, namedType, parameterOf, unitOf } from "../mip/names.mjs";
import { answerOf, initialValue, initialValues, packetOf, requiredOperations, setsOf, sourceOf } from "./build.mjs";
import { element, links } from "./dom.mjs";
import { descriptorOf, hexByte, spacedHex } from "./words.mjs";

const LANGUAGES = [
    ["c", "C"],
    ["python", "Python"],
    ["rust", "Rust"],
];

/** Fills an element with the builder. `options` are those of `links`, and `field`, the name of the one to begin with. */
export function builder(root, protocol, options = {}) {
    const to = links(options);
    const groups = protocol.model.sets.map((set) => fieldGroup(`${set.title} (${hexByte(set.number)})`, set.fields.map((name) => protocol.field(name))));
    const choice = element("select", { id: "mip-field" }, groups, fieldGroup("All command sets", [protocol.acknowledge]));
    const form = element("div", { class: "mip-form" });
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    let state;

    const show = () => output.replaceChildren(...builtPacket(protocol, state, to));
    const layOut = () => {
        form.replaceChildren(...inputs(protocol, state, { changed: show, reshaped: () => (layOut(), show()) }, choose));
    };
    const choose = (field, selector = protocol.functions.keys().next().value) => {
        const function_ = field.calls?.some((call) => call.function === protocol.functions.get(selector)?.name)
            ? selector
            : [...protocol.functions.values()].find((one) => one.name === field.calls?.[0].function)?.value;
        state = { field, set: setsOf(protocol, field)[0], values: initialValues(protocol, field, function_) };
        layOut();
        show();
    };
    choice.addEventListener("input", () => choose(protocol.field(choice.value)));
    root.replaceChildren(element("p", {}, element("label", { for: "mip-field" }, "Command or field "), choice), form, output);
    const start = options.field && protocol.fields.has(options.field) ? options.field : choice.value;
    choice.value = start;
    choose(protocol.field(start));
    return { choose: (name, selector) => ((choice.value = name), choose(protocol.field(name), selector)), state: () => state };
}

function fieldGroup(label, fields) {
    const words = (field) => `${hexByte(field.descriptor)} ${field.title}${field.role === "response" ? " (response)" : ""}`;
    return element("optgroup", { label }, fields.map((field) => element("option", { value: field.name }, words(field))));
}

// ------------------------------------------------------------------------------------------------ inputs

function inputs(protocol, state, events, choose) {
    const { field, values } = state;
    const operations = requiredOperations(protocol, field, values.function);
    const sets = setsOf(protocol, field);
    const parts = [element("p", {}, field.description)];
    if (sets.length > 1) {
        const options = sets.map((number) => [number, `${protocol.sets.get(number)?.title ?? ""} (${hexByte(number)})`]);
        parts.push(labelled("set", select(options, state.set, (number) => ((state.set = number), events.changed()))));
    }
    if (field.calls) {
        const functions = [...protocol.functions.values()].filter((one) => field.calls.some((call) => call.function === one.name));
        const options = functions.map((one) => [one.value, `${one.name}: ${one.description}`]);
        parts.push(labelled("function", select(options, values.function, (selector) => choose(field, selector))));
    }
    const shown = operations.filter((op) => !(field.calls && op.member === "function"));
    return [...parts, ...shown.flatMap((op) => input(protocol, op, field, values, events))];
}

let lastInput = 0; // for ids

function labelled(words, control, ...behind) {
    control.id ||= `mip-input-${++lastInput}`;
    return element("p", {}, element("label", { for: control.id }, `${words} `), control, ...behind);
}

function select(options, value, set) {
    const control = element("select", {}, options.map(([number, words]) => element("option", { value: number, selected: number === value }, words)));
    control.addEventListener("input", () => set(Number(control.value)));
    return control;
}

/** The inputs of one operation; they change `values`. */
function input(protocol, op, record, values, events) {
    if (op.kind === "constant" || op.kind === "counter") return [];
    const parameter = parameterOf(record, op.member) ?? { name: op.member };
    const [name, set] = [op.member, (value) => ((values[op.member] = value), events.changed())];
    const hint = [unitOf(parameter), parameter.description].filter(Boolean).join(" · ");
    const note = hint ? [" ", element("small", {}, hint)] : [];
    switch (op.kind) {
        case "scalar":
            return [scalarInput(protocol, op, parameter, record, values, events, note)];
        case "bits":
            return [bitsInput(name, protocol.type(op.type), values[name], (number) => set(littleEndian(number, op.size)))];
        case "text": {
            const control = element("input", { value: values[name].trimEnd(), maxlength: op.count ?? op.capacity });
            control.addEventListener("input", () => set(control.value.padEnd(op.count ?? 0)));
            return [labelled(name, control, note)];
        }
        case "struct":
            return [group(name, hint, protocol.type(op.struct).operations.flatMap((part) => input(protocol, part, protocol.type(op.struct), values[name], events)))];
        case "switch": {
            const selected = op.cases.find((one) => one.value === Number(values[op.tag]))?.operation;
            return selected ? [group(name, hint, input(protocol, selected, record, values[name], events))] : [];
        }
        default:
            return [arrayInput(protocol, op, parameter, values, events, hint)];
    }
}

function scalarInput(protocol, op, parameter, record, values, events, note) {
    const name = op.member;
    const type = namedType(protocol, parameter, values);
    const { kind } = protocol.scalar(op.scalar);
    const tags = record.parameters.some((one) => one.tag === name || one.variants?.some((variant) => variant.by === name));
    const set = (value) => {
        values[name] = value;
        if (!tags) return events.changed();
        for (const union of unionsOf(record, name)) values[union.member] = initialValue(protocol, union, record, values);
        events.reshaped();
    };
    if (type?.kind === "enum") {
        const options = type.values.map((one) => [one.value, `${one.value} ${one.name}`]);
        return labelled(name, select(options, Number(values[name]), set), note);
    }
    if (type?.kind === "bitfield") return bitsInput(name, type, values[name], set);
    if (kind === "bool") {
        const control = element("input", { type: "checkbox", checked: Boolean(values[name]) });
        control.addEventListener("input", () => set(control.checked ? 1 : 0));
        return labelled(name, control, note);
    }
    return labelled(name, numberInput(values[name], kind, set), note);
}

/** The switches of a record that a parameter selects. */
function unionsOf(record, tag) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op])).filter((op) => op.kind === "switch" && op.tag === tag);
}

function numberInput(value, kind, set) {
    const control = element("input", { value: String(value), inputmode: kind === "float" ? "decimal" : "text", spellcheck: "false" });
    control.addEventListener("input", () => set(numberOfText(control.value, kind)));
    return control;
}

/** A number as people write it: 0x1F, 12, -0.5; of floats also the bits, 0x and as many digits as it has. */
export function numberOfText(text, kind) {
    const trimmed = text.trim();
    if (kind === "float") return /^0x/i.test(trimmed) ? trimmed : trimmed === "" ? trimmed : Number(trimmed);
    if (/^-?(\d+|0x[0-9a-f]+)$/i.test(trimmed)) {
        const number = trimmed.startsWith("-") ? -BigInt(trimmed.slice(1)) : BigInt(trimmed);
        return Number.isSafeInteger(Number(number)) ? Number(number) : number;
    }
    return trimmed || NaN;
}

/** The whole number, and an input for each name in it. */
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
        whole.value = `0x${number.toString(16).toUpperCase()}`;
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
    whole.value = `0x${number.toString(16).toUpperCase()}`;
    showAll();
    const controls = named.map(({ bits, control }) => labelled(bits.name, control, " ", element("small", {}, bits.description)));
    return group(name, type.description, [labelled("value", whole), ...controls]);
}

/** The bytes of a bitfield of bytes; what is no number, or too large, is an error when it is encoded. */
function littleEndian(number, size) {
    if (typeof number !== "bigint" || number < 0n || number >> BigInt(8 * size)) return [number];
    return Array.from({ length: size }, (_, i) => Number((number >> BigInt(8 * i)) & 0xffn));
}

/** Vectors and arrays: their elements; those of an array that is counted can be added and removed. */
function arrayInput(protocol, op, parameter, values, events, hint) {
    const items = values[op.member];
    const inner = { parameters: [{ ...parameter, name: op.item.member, default: undefined, cases: undefined }], operations: [op.item] };
    const names = protocol.types.get(op.vector)?.elements;
    const rows = items.map((_, i) => {
        const holder = {
            get [op.item.member]() {
                return items[i];
            },
            set [op.item.member](value) {
                items[i] = value;
            },
        };
        const unit = { ...inner.parameters[0], description: "", units: [unitOf(parameter, i)] };
        const [control] = input(protocol, op.item, { ...inner, parameters: [unit] }, holder, events);
        const label = control.querySelector(":scope > label, :scope > legend");
        label.textContent = `${names?.[i] ?? `${op.member}[${i}]`} `;
        return control;
    });
    if (op.count !== undefined) return group(op.member, hint, rows);
    const add = () => {
        items.push(initialValue(protocol, op.item, inner, {}));
        events.reshaped();
    };
    const remove = () => {
        items.pop();
        events.reshaped();
    };
    const buttons = element(
        "p",
        {},
        element("button", { type: "button", onclick: add, disabled: items.length >= op.capacity }, `Add to ${op.member}`),
        " ",
        element("button", { type: "button", onclick: remove, disabled: items.length === 0 }, "Remove the last"),
    );
    return group(op.member, hint, [...rows, buttons]);
}

function group(name, hint, controls) {
    return element("fieldset", {}, element("legend", {}, name), hint && element("small", {}, hint), controls);
}

// ------------------------------------------------------------------------------------------------ result

function builtPacket(protocol, { field, set, values }, to) {
    let packet;
    try {
        packet = packetOf(protocol, field, set, values);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return [element("p", { class: "mip-wrong" }, `${error.message}.`)];
    }
    const sources = LANGUAGES.map(([key, title]) => [element("dt", {}, title), element("dd", {}, element("code", { "data-language": key }, sourceOf(packet.bytes, key)))]);
    return [
        element("h2", {}, to.field(field), ` ${descriptorOf(field)}`),
        element("p", { class: "mip-bytes" }, element("code", { class: "mip-packet-bytes" }, spacedHex(packet.bytes))),
        element("p", {}, `${packet.bytes.length} bytes; the checksum is ${spacedHex(packet.checksum)}.`),
        element("h3", {}, "As source code"),
        element("dl", { class: "mip-bytes" }, sources),
        ...(field.role === "command" && field.sent_by !== "device" ? answerReport(protocol, field, values, to) : []),
    ];
}

function answerReport(protocol, field, values, to) {
    const { silent, acknowledge, responses, conditions } = answerOf(protocol, field, values);
    const unless = conditions.length ? ` There is no answer if ${conditions.join(" or ")}.` : "";
    if (silent) return [element("h3", {}, "Answer"), element("p", { class: "mip-answer" }, silent)];
    const listed = responses.map(({ field: response, when }) =>
        element("li", { "data-field": response.name }, to.field(response), ` ${descriptorOf(response)}, ${sizeText(response)}`, when && `, if ${when}`),
    );
    return [
        element("h3", {}, "Answer"),
        element(
            "p",
            { class: "mip-answer" },
            listed.length ? "The acknowledge, directly followed by a response in the same packet:" : "The acknowledge: ",
            !listed.length && element("code", {}, spacedHex(acknowledge.bytes)),
            !listed.length && unless,
        ),
        listed.length > 0 && element("ul", {}, listed),
        listed.length > 0 && unless && element("p", {}, unless),
        element("p", {}, "A refusal is an acknowledge with another code, without a response."),
    ].filter(Boolean);
}

function sizeText({ min_size: least, max_size: most }) {
    return least === most ? `${least + 2} bytes` : `${least + 2} to ${most + 2} bytes`;
}
