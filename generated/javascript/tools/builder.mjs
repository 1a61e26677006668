// The builder: choose commands or fields, fill them in, and see the packet, the programs that send it and the answer.

import { MipError, toHex } from "../mip/bytes.mjs";
import { bitsNumber, enumValue, maskOf, measuredHere, namedType, parameterOf, unitOf } from "../mip/names.mjs";
import { Packet } from "../mip/packet.mjs";
import { FIRST_DATA_SET, SHARED_SET } from "../mip/protocol.mjs";
import {
    allOperations,
    answerOf,
    certaintyOn,
    counted,
    countOptional,
    differencesOn,
    initialValue,
    initialValues,
    optionalGroups,
    packetOf,
    setsOf,
    shownOperations,
    sourceOf,
    typicalValues,
} from "./build.mjs";
import { LANGUAGES, programOf } from "./code.mjs";
import { element, links, mark, profileNote } from "./dom.mjs";
import { bytesOfText } from "./input.mjs";
import { choicesOf, decimal, descriptorOf, hexByte, hexLiteral, spacedHex } from "./words.mjs";

/**
 * Fills an element with the builder. `options` are those of `links`, and `field`, what to begin with: the name of a field,
 * or a packet in hexadecimal, perhaps behind the id of a device. If it is given, the fragment of the address follows what
 * is built.
 */
export function builder(root, protocol, options = {}) {
    const to = links(options);
    const state = { device: undefined, set: undefined, entries: [] };
    const deviceChoice = element(
        "select",
        { id: "mip-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id }, one.title)),
    );
    const note = element("div", { role: "status" });
    const choice = element("select", { id: "mip-field" });
    const start = startOf(protocol, options.field ?? "");
    const problem = element("p", { class: "mip-wrong", role: "status" }, start.problem);
    const forms = element("div", {});
    const output = element("div", { class: "mip-output", "aria-live": "polite" });

    let started = false; // the address stays as it is until something is changed
    const show = () => {
        const packet = built(protocol, state);
        output.replaceChildren(...report(protocol, state, packet, to));
        if (started && options.field !== undefined && packet.bytes) {
            const text = [state.device?.id, toHex(packet.bytes).toUpperCase()].filter(Boolean).join(" ");
            history.replaceState(history.state, "", `#${encodeURIComponent(text)}`);
        }
    };
    const layOut = () => {
        forms.replaceChildren(...entryForms(protocol, state, { changed: show, reshaped }, to), adder());
    };
    const reshaped = () => {
        layOut();
        show();
    };
    const listFields = () => {
        const groups = protocol.model.sets.map((set) => [
            `${set.title} (${hexByte(set.number)})`,
            set.fields.map((name) => protocol.field(name)),
        ]);
        groups.push(["All command sets", [protocol.acknowledge]]);
        const chosen = state.entries[0]?.field;
        const offered = groups.map(([label, fields]) => [label, fieldOptions(protocol, state.device, fields, chosen)]);
        choice.replaceChildren(
            ...offered.filter(([, options]) => options.length).map(([label, options]) => element("optgroup", { label }, options)),
        );
        note.replaceChildren(...[profileNote(state.device)].filter(Boolean));
        if (chosen) choice.value = chosen.name;
    };
    const adder = () => {
        const options = fieldOptions(protocol, state.device, beside(protocol, state));
        const add = element("select", { id: "mip-add" }, element("option", { value: "" }, "…"), options);
        add.addEventListener("input", () => {
            if (!add.value) return;
            state.entries.push(entryOf(protocol, protocol.field(add.value)));
            layOut();
            show();
        });
        return element("p", { class: "mip-adder" }, element("label", { for: "mip-add" }, "Add another field "), add);
    };
    const begin = (entries, set) => {
        state.entries = entries;
        state.set = set ?? setsOf(protocol, entries[0].field)[0];
        listFields();
        layOut();
        show();
    };
    const choose = (name, selector) => {
        problem.remove();
        begin([entryOf(protocol, protocol.field(name), selector)]);
    };

    choice.addEventListener("input", () => choose(choice.value));
    deviceChoice.addEventListener("input", () => {
        state.device = protocol.model.devices.find((one) => one.id === deviceChoice.value);
        listFields();
        layOut();
        show();
    });
    root.replaceChildren(
        element("p", {}, element("label", { for: "mip-device" }, "Device "), deviceChoice),
        note,
        element("p", {}, element("label", { for: "mip-field" }, "Command or field "), choice),
        forms,
        output,
    );
    state.device = start.device;
    deviceChoice.value = start.device?.id ?? "";
    if (start.entries) begin(start.entries, start.set);
    else choose(start.name ?? protocol.model.sets[0].fields[0]);
    if (start.problem) forms.before(problem);
    started = true;
    return { choose, state: () => state };
}

/** What a fragment says: a device, and a field by its name or a packet; `problem` is what cannot be taken over. */
function startOf(protocol, text) {
    const device = protocol.model.devices.find((one) => text === one.id || text.startsWith(`${one.id} `));
    const rest = device ? text.slice(device.id.length).trim() : text;
    if (!rest) return { device };
    if (protocol.fields.has(rest)) return { device, name: rest };
    const { bytes } = bytesOfText(rest);
    if (!bytes.length) return { device, problem: "The address has neither the name of a field nor a packet." };
    try {
        const packet = Packet.from(protocol, bytes);
        const entries = packet.decode().map(takenOver);
        if (!entries.length) throw new MipError("fields", "it has no field");
        const left = entries.filter(({ trailing }) => trailing).map(({ field, trailing }) => `${trailing} at the end of ${field.name}`);
        const problem = left.length ? `Bytes that no parameter has are left out: ${left.join(", ")}.` : undefined;
        return { device, entries: entries.map(({ field, values }) => ({ field, values })), set: packet.set, problem };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { device, problem: `The packet of the address cannot be taken over: ${error.message}.` };
    }
}

function takenOver({ descriptor, field, values, trailing, error }) {
    if (error) throw error;
    if (!field) throw new MipError("unknown", `there is no field with descriptor ${hexByte(descriptor)} in its set`);
    return { field, values, trailing };
}

function entryOf(protocol, field, selector) {
    const known = (value) => field.calls?.some((call) => call.function === protocol.functions.get(Number(value))?.name);
    const first = [...protocol.functions.values()].find((one) => one.name === field.calls?.[0].function)?.value;
    return { field, values: initialValues(protocol, field, field.calls ? (known(selector) ? Number(selector) : first) : undefined) };
}

/** The fields that can be in the same packet. */
function beside(protocol, { set }) {
    const names = [protocol.sets.get(set), set >= FIRST_DATA_SET && protocol.sets.get(SHARED_SET)].flatMap((one) => one?.fields ?? []);
    return [...names.map((name) => protocol.field(name)), ...(set < FIRST_DATA_SET ? [protocol.acknowledge] : [])];
}

/** The choices among fields: those that the device may have, and the chosen one. */
function fieldOptions(protocol, device, fields, chosen) {
    return fields.flatMap((field) => {
        const certainty = certaintyOn(protocol, device, field);
        if (certainty === undefined && field !== chosen) return [];
        const response = field.role === "response" ? " (response)" : "";
        return [element("option", { value: field.name }, `${hexByte(field.descriptor)} ${field.title}${response}${mark(certainty)}`)];
    });
}

// ------------------------------------------------------------------------------------------------ inputs

/** A form for each field; of several, they can be moved and removed. */
function entryForms(protocol, state, events, to) {
    return state.entries.map((entry, i) => {
        const form = element("div", { class: "mip-form" }, inputs(protocol, state, entry, events));
        if (state.entries.length === 1) return form;
        const move = (by) => () => {
            state.entries.splice(i + by, 0, ...state.entries.splice(i, 1));
            events.reshaped();
        };
        const remove = () => {
            state.entries.splice(i, 1);
            events.reshaped();
        };
        const button = (words, act, disabled) =>
            element("button", { type: "button", onclick: act, disabled, "aria-label": `${words}: field ${i + 1}` }, words);
        return element(
            "section",
            { class: "mip-entry", "data-field": entry.field.name },
            element("h2", {}, `${i + 1}. `, to.field(entry.field), ` ${descriptorOf(entry.field)}`),
            element(
                "p",
                {},
                button("Up", move(-1), i === 0),
                " ",
                button("Down", move(1), i === state.entries.length - 1),
                " ",
                button("Remove", remove),
            ),
            form,
        );
    });
}

function inputs(protocol, state, entry, events) {
    const { field } = entry;
    const sets = setsOf(protocol, field);
    const parts = [element("p", {}, field.description), ...deviceNotes(protocol, state.device, field)];
    if (sets.length > 1 && state.entries.length === 1) {
        const options = sets.map((number) => [number, `${protocol.sets.get(number)?.title ?? ""} (${hexByte(number)})`]);
        const change = (number) => {
            state.set = number;
            events.reshaped();
        };
        parts.push(labelled("set", select(options, state.set, change)));
    }
    const context = { protocol, device: state.device?.id, record: field, values: entry.values, events };
    if (field.calls) {
        const functions = [...protocol.functions.values()].filter((one) => field.calls.some((call) => call.function === one.name));
        const options = functions.map((one) => [one.value, `${one.name}: ${one.description}`]);
        const change = (selector) => {
            const kept = Object.entries(entry.values).filter(([name]) => name !== "function");
            const fresh = initialValues(protocol, field, selector);
            for (const [name, value] of kept) if (Object.hasOwn(fresh, name)) fresh[name] = value;
            entry.values = fresh;
            events.reshaped();
        };
        parts.push(labelled("function", select(options, entry.values.function, change)));
    }
    const shown = shownOperations(protocol, field, entry.values).filter((op) => !(field.calls && op.member === "function"));
    return [...parts, ...shown.flatMap((op) => input(context, op)), ...optionalButtons(protocol, entry, events)];
}

/** What the chosen device takes of a field, and what differs there. */
function deviceNotes(protocol, device, field) {
    if (!device) return [];
    const found = differencesOn(protocol, device, field);
    if (!found.length) return [];
    return [
        element(
            "ul",
            { class: "mip-device-notes" },
            found.map((text) => element("li", {}, `${device.title}: ${text}`)),
        ),
    ];
}

/** Parameters that no function requires come one after another, and go the other way round. */
function optionalButtons(protocol, entry, events) {
    const { field, values } = entry;
    const groups = optionalGroups(protocol, field, values.function);
    const present = countOptional(groups, values);
    const names = (group) =>
        group.body
            .filter(({ kind }) => kind !== "counter")
            .map((op) => op.member)
            .join(", ");
    const add = () => {
        const typical = typicalValues(protocol, field, values.function, true);
        for (const op of groups[present].body) values[op.member] = typical[op.member] ?? initialValue(protocol, op, field, values);
        events.reshaped();
    };
    const leaveOut = () => {
        for (const op of groups[present - 1].body) delete values[op.member];
        events.reshaped();
    };
    const buttons = [
        present < groups.length &&
            element("button", { type: "button", onclick: add, class: "mip-more" }, `Add ${names(groups[present])} (optional)`),
        present > 0 &&
            element("button", { type: "button", onclick: leaveOut, class: "mip-less" }, `Leave out ${names(groups[present - 1])}`),
    ].filter(Boolean);
    return buttons.length ? [element("p", {}, buttons)] : [];
}

let lastInput = 0; // for ids

function labelled(words, control, ...behind) {
    control.id ||= `mip-input-${++lastInput}`;
    return element("p", {}, element("label", { for: control.id }, `${words} `), control, ...behind);
}

function select(options, value, set) {
    const known = options.map(([number, words]) => element("option", { value: number, selected: number === Number(value) }, words));
    const control = element("select", {}, known);
    control.addEventListener("input", () => set(Number(control.value)));
    return control;
}

/** The inputs of one operation; they change `values` of the context. */
function input(context, op) {
    if (op.kind === "constant" || op.kind === "counter") return [];
    const { protocol, record, values, events, device } = context;
    const parameter = measuredHere(protocol, parameterOf(record, op.member) ?? { name: op.member }, values, device);
    const name = op.member;
    const set = (value) => {
        values[name] = value;
        events.changed();
    };
    const hint = [unitOf(parameter), parameter.description].filter(Boolean).join(" · ");
    const note = hint ? [" ", element("small", {}, hint)] : [];
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
            const selected = op.cases.find((one) => one.value === Number(values[op.tag]))?.operation;
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
    if (!parameter.shown) return labelled(name, numberInput(values[name], kind, size, set), note);
    return labelled(name, ...hexInput(context, parameter, values[name], size, set), note);
}

/** The names of an enumeration, and any other number: enumerations are open. */
function enumInput(type, value, set) {
    const known = type.values.map((one) => [one.value, `${one.value} ${one.name}`]);
    const other = enumValue(type, value) ? undefined : value;
    const control = element(
        "select",
        {},
        [...known, ["other", "another number"]].map(([number, words]) =>
            element("option", { value: number, selected: other === undefined ? number === Number(value) : number === "other" }, words),
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
        set(number.hidden ? Number(control.value) : numberOfText(number.value, "unsigned"));
    });
    number.addEventListener("input", () => set(numberOfText(number.value, "unsigned")));
    return [control, " ", number];
}

let lastList = 0; // for ids

/** A number that people know in hexadecimal, with the sets or fields to choose from, and what it means. */
function hexInput(context, parameter, value, size, set) {
    const control = element("input", { value: hexOf(value, size), spellcheck: "false", class: "mip-hex" });
    const { protocol, values, outer } = context;
    const choices = choicesOf(protocol, parameter, values, outer);
    const meaning = element("small", { class: "mip-meant" }, choices.get(Number(value)) ?? "");
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

/** The switches of a record that a parameter selects. */
function unionsOf(record, tag) {
    return record.operations.flatMap((op) => (op.kind === "group" ? op.body : [op])).filter((op) => op.kind === "switch" && op.tag === tag);
}

function numberInput(value, kind, size, set) {
    const text = kind === "float" && typeof value === "number" ? decimal(value, size) : String(value);
    const control = element("input", { value: text, inputmode: kind === "float" ? "decimal" : "text", spellcheck: "false" });
    control.addEventListener("input", () => set(numberOfText(control.value, kind)));
    return control;
}

/** A number as people write it: 0x1F, 12, -0.5; of floats also the bits, 0x and as many digits as it has. */
export function numberOfText(text, kind) {
    const trimmed = text.trim();
    if (kind === "float") return floatOfText(trimmed);
    if (/^-?(\d+|0x[0-9a-f]+)$/i.test(trimmed)) {
        const number = trimmed.startsWith("-") ? -BigInt(trimmed.slice(1)) : BigInt(trimmed);
        return Number.isSafeInteger(Number(number)) ? Number(number) : number;
    }
    return trimmed;
}

/** What is no number, or too large, stays a text, which is refused when it is encoded. */
function floatOfText(text) {
    const words = { nan: NaN, inf: Infinity, infinity: Infinity, "-inf": -Infinity, "-infinity": -Infinity };
    if (Object.hasOwn(words, text.toLowerCase())) return words[text.toLowerCase()];
    const number = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN;
    return Number.isFinite(number) ? number : text;
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
    const controls = named.map(({ bits, control }) => labelled(bits.name, control, " ", element("small", {}, bits.description)));
    return group(name, type.description, [labelled("value", whole), ...controls]);
}

/** The bytes of a bitfield of bytes; what is no number, or too large, is an error when it is encoded. */
function littleEndian(number, size) {
    if (typeof number !== "bigint" || number < 0n || number >> BigInt(8 * size)) return [number];
    return Array.from({ length: size }, (_, i) => Number((number >> BigInt(8 * i)) & 0xffn));
}

/** Vectors and arrays: their elements; those of an array that is counted can be added and removed. */
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

/** The packet, or the error that says why there is none. */
function built(protocol, { set, entries }) {
    try {
        return packetOf(protocol, set, entries);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { error };
    }
}

function report(protocol, { entries }, packet, to) {
    if (packet.error) return [element("p", { class: "mip-wrong" }, `${packet.error.message}.`)];
    const sources = LANGUAGES.map(([key, title]) => [
        element("dt", {}, title),
        element("dd", {}, element("code", { "data-language": key }, sourceOf(packet.bytes, key))),
    ]);
    const title =
        entries.length === 1
            ? [to.field(entries[0].field), ` ${descriptorOf(entries[0].field)}`]
            : [`A packet of ${entries.length} fields`];
    return [
        element("h2", {}, ...title),
        element("p", { class: "mip-bytes" }, element("code", { class: "mip-packet-bytes" }, spacedHex(packet.bytes))),
        element("p", {}, `${packet.bytes.length} bytes; the checksum is ${spacedHex(packet.checksum)}.`),
        ...entries.flatMap((entry) => entryReport(protocol, entry, entries.length > 1, to)),
        element("h3", {}, "The packet in source code"),
        element("dl", { class: "mip-bytes" }, sources),
    ];
}

/** The programs of a field, and what it is answered with. */
function entryReport(protocol, { field, values }, several, to) {
    const heading = several ? [element("h2", {}, to.field(field))] : [];
    const answer = field.role === "command" && field.sent_by !== "device" ? answerReport(protocol, field, values, to) : [];
    return [...heading, ...programs(protocol, field, values), ...answer];
}

function programs(protocol, field, values) {
    if (field.role === "response") return [];
    const shown = LANGUAGES.map(([key, title]) => {
        const text = programText(protocol, key, field, values);
        const code = element("pre", {}, element("code", { "data-program": key }, text));
        return element("details", { open: key === "python" }, element("summary", {}, title), code);
    });
    const given =
        field.role === "command"
            ? "Each assumes an open `device`."
            : "C has a `field` of a packet, Python an open `device`, Rust a `packet`.";
    return [
        element("h3", {}, field.role === "command" ? "Programs that send it" : "Programs that read it"),
        element("p", {}, given.replaceAll("`", "")),
        ...shown,
    ];
}

function programText(protocol, language, field, values) {
    try {
        return programOf(protocol, language, field, [counted(protocol, allOperations(field), values)]);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return `${error.message}.`;
    }
}

function answerReport(protocol, field, values, to) {
    const { silent, acknowledge, responses, conditions } = answerOf(protocol, field, values);
    const unless = conditions.length ? ` There is no answer if ${conditions.join(" or ")}.` : "";
    if (silent) return [element("h3", {}, "Answer"), element("p", { class: "mip-answer" }, silent)];
    const listed = responses.map(({ field: response, when, packet }) =>
        element(
            "li",
            { "data-field": response.name },
            to.field(response),
            ` ${descriptorOf(response)}, ${sizeText(response)}`,
            when && `, if ${when}`,
            element("br", {}),
            "for example ",
            element("code", { class: "mip-bytes" }, spacedHex(packet.bytes)),
            layoutTable(response),
        ),
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

/** The parameters of a response, in order. */
function layoutTable(response) {
    const rows = response.parameters.map((parameter) => {
        const many = parameter.length === undefined ? "" : `[${parameter.length}]`;
        const cells = [parameter.name, `${parameter.type ?? "union"}${many}`, unitOf(parameter), parameter.description ?? ""];
        return element(
            "tr",
            {},
            cells.map((cell) => element("td", {}, cell)),
        );
    });
    if (!rows.length) return "";
    const heading = element(
        "tr",
        {},
        ["Name", "Type", "Unit", "Description"].map((cell) => element("th", {}, cell)),
    );
    return element(
        "details",
        {},
        element("summary", {}, "Layout"),
        element("div", { class: "mip-scroll" }, element("table", {}, heading, rows)),
    );
}

function sizeText({ min_size: least, max_size: most }) {
    return least === most ? `${least + 2} bytes` : `${least + 2} to ${most + 2} bytes`;
}
