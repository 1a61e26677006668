// The builder: choose commands or fields, fill them in, and see the packet, the programs that send it and the answer.

import { decodePacket, FIRST_DATA_SET, MipError, nameIn, Packet, placesOf, SHARED_SET, toHex } from "mip-protocol/tools";
import { certaintyOn, initialValues, setsOf } from "./build.mjs";
import { element, links, mark, profileNote } from "./dom.mjs";
import { entryForms } from "./form.mjs";
import { bytesOfText } from "./pasted.mjs";
import { built, report } from "./report.mjs";
import { hexByte } from "./words.mjs";

/**
 * Fills an element with the builder. `options` are those of `links`, and `start`: the name of a field, or a packet in
 * hexadecimal, perhaps behind the id of a device. If it is given, the fragment of the address follows what is built.
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
    const start = startOf(protocol, options.start ?? "");
    const problem = element("p", { class: "mip-wrong", role: "status" }, start.problem);
    const forms = element("div", {});
    const output = element("div", { class: "mip-output", "aria-live": "polite" });

    let started = false; // the address stays as it is until something is changed
    const show = () => {
        const packet = built(protocol, state);
        output.replaceChildren(...report(protocol, state, packet, to));
        if (started && options.start !== undefined && packet.bytes) {
            const text = [state.device?.id, toHex(packet.bytes).toUpperCase()].filter(Boolean).join(" ");
            history.replaceState(history.state, "", `#${encodeURIComponent(text)}`);
        }
    };
    const chosenName = () => state.entries.length && nameIn(state.entries[0].field, state.set);
    const layOut = () => {
        forms.replaceChildren(...entryForms(protocol, state, { changed: show, reshaped }, to), adder());
        choice.value = chosenName();
    };
    const reshaped = () => {
        layOut();
        show();
    };
    const listFields = () => {
        const groups = protocol.model.sets.map((set) => [
            `${set.title} (${hexByte(set.number)})`,
            fieldOptions(protocol, state.device, set.number, set.fields, chosenName()),
        ]);
        groups.push(["All command sets", fieldOptions(protocol, state.device, 0, [protocol.acknowledge.name])]);
        choice.replaceChildren(
            ...groups.filter(([, options]) => options.length).map(([label, options]) => element("optgroup", { label }, options)),
        );
        note.replaceChildren(...[profileNote(state.device)].filter(Boolean));
    };
    const adder = () => {
        const options = fieldOptions(protocol, state.device, state.set, beside(protocol, state));
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
        const field = protocol.field(name);
        const place = placesOf(field).find((one) => one.name === name);
        begin(
            [entryOf(protocol, field, selector)],
            setsOf(protocol, field).find((number) => number === place?.set),
        );
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
        const packet = Packet.from(bytes);
        const entries = decodePacket(protocol, packet).map(takenOver);
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

/** The names of the fields that can be in the same packet. */
function beside(protocol, { set }) {
    const names = [protocol.sets.get(set), set >= FIRST_DATA_SET && protocol.sets.get(SHARED_SET)].flatMap((one) => one?.fields ?? []);
    return [...names, ...(set < FIRST_DATA_SET ? [protocol.acknowledge.name] : [])];
}

/** The choices among fields in a set: those that the device may have there, and the chosen one. */
function fieldOptions(protocol, device, set, names, chosen) {
    return names.flatMap((one) => {
        const field = protocol.field(one);
        const name = nameIn(field, set);
        const certainty = certaintyOn(protocol, device, field, set);
        if (certainty === undefined && name !== chosen) return [];
        const response = field.role === "response" ? " (response)" : "";
        return [element("option", { value: name }, `${hexByte(field.descriptor)} ${field.title}${response}${mark(certainty)}`)];
    });
}
