// The builder: choose commands or fields, fill them in, and see the packet and the reply.

import { decodePacket, MipError, Packet, placesOf, toHex } from "mip-protocol/tools";
import { State } from "./address.mjs";
import { initialValues, setsOf } from "./build.mjs";
import { announced, deviceChoice, deviceOf, element, keepFocus, links, profileNote } from "./dom.mjs";
import { indexOf } from "./find.mjs";
import { entryForms } from "./form.mjs";
import { bytesOfText } from "./pasted.mjs";
import { picker } from "./picker.mjs";
import { built, report } from "./report.mjs";
import { linkRows } from "./ruler.mjs";
import { formatNeed, needText } from "./stream.mjs";
import { hexByte, spacedHex } from "./words.mjs";

/**
 * Fills an element with the builder. `options` are those of `links`, and `start`, the fragment of an address, which may
 * also be the name of a field, or a packet in hexadecimal, perhaps behind the id of a device. `send` is called with a
 * packet and its fields, and returns the elements that show what became of it; with it, there is a button for it. With
 * `deviceElsewhere`, the device is chosen by `useDevice` of what is returned, whose `send` is the button.
 */
export function builder(root, protocol, options = {}) {
    const to = links(options);
    const shared = options.state ?? new State(options.start, options.device);
    const start = startOf(protocol, shared.get("packet") || shared.get("given"));
    if (start.device) shared.adopt({ device: start.device.id });
    const state = { device: start.device ?? deviceOf(protocol, shared.get("device")), set: undefined, entries: [] };
    const index = indexOf(protocol);
    const device = options.deviceElsewhere
        ? undefined
        : deviceChoice(protocol, shared, "mip-device", (chosen) => {
              state.device = chosen;
              redrawn();
          });
    const note = element("div", { role: "status" });
    const search = picker(index, {
        id: "mip-field",
        label: "Command or field",
        device: () => state.device,
        choose: (field, set) => begin([entryOf(protocol, field)], set),
    });
    const adder = picker(index, {
        id: "mip-add",
        label: "Add another field to the packet",
        device: () => state.device,
        sets: () => [state.set],
        choose(field) {
            state.entries.push(entryOf(protocol, field));
            reshaped();
        },
    });
    const problem = element("p.mip-wrong", { role: "status" }, start.problem);
    const totals = element("p.mip-totals.mip-need", { role: "status", hidden: true });
    const forms = element("div.mip-forms");
    const output = announced("div.mip-output");
    const outcome = element("div.mip-outcome", { role: "status" });
    const send = element("button", { type: "button", class: "mip-main", onclick: () => transmit() }, "Send");

    let started = false; // the address stays as it is until something is changed
    const show = () => {
        if (!state.entries.length) return;
        const packet = built(protocol, state);
        const { bytes, checksum, error } = packet;
        if (error) output.show(`${error.message}.`, [], "mip-wrong");
        else output.show(`${bytes.length} bytes; the checksum is ${spacedHex(checksum)}.`, report(protocol, state, packet, to));
        const need = formatNeed(protocol, state.device?.id, state.entries);
        totals.hidden = !need;
        if (need) totals.textContent = `These rates need ${needText(need)}`;
        if (started && packet.bytes) shared.set({ packet: toHex(packet.bytes).toUpperCase() });
    };
    const layOut = () => {
        if (!state.entries.length) return;
        const sending = options.send && element("p", send);
        forms.replaceChildren(
            ...[...entryForms(protocol, state, { changed: show, reshaped }, to), sending, outcome, adder.root].filter(Boolean),
        );
        adder.refresh();
    };
    const reshaped = () =>
        keepFocus(forms, () => {
            layOut();
            show();
        });
    const redrawn = () => {
        search.refresh();
        note.replaceChildren(...[profileNote(state.device)].filter(Boolean));
        reshaped();
    };
    const transmit = async () => {
        const packet = built(protocol, state);
        if (packet.error) return;
        outcome.replaceChildren("Sent; waiting for the answer …");
        outcome.replaceChildren(...(await options.send(packet, state.entries)));
    };
    const begin = (entries, set) => {
        problem.remove();
        outcome.replaceChildren();
        const sets = setsOf(protocol, entries[0].field);
        state.entries = entries;
        state.set = sets.includes(set) ? set : sets[0];
        reshaped();
    };

    root.replaceChildren(
        ...[
            device && element("p", element("label", { for: "mip-device" }, "Device "), device.control),
            note,
            search.root,
            totals,
            element("div.mip-columns", forms, output.root),
        ].filter(Boolean),
    );
    linkRows(root);
    if (start.entries) begin(start.entries, start.set);
    else if (start.name) choose(protocol, start.name, begin);
    else if (start.search) search.look(start.search);
    else if (!start.problem) begin([entryOf(protocol, protocol.field(protocol.model.sets[0].fields[0]))]);
    note.replaceChildren(...[profileNote(state.device)].filter(Boolean));
    if (start.problem) search.root.before(problem);
    started = true;
    const useDevice = (chosen) => {
        state.device = chosen;
        started = false; // the packet is the same
        redrawn();
        started = true;
    };
    return { choose: (name) => choose(protocol, name, begin), send, state: () => state, useDevice };
}

/** Begins with the field of this name, which may be its name in one of its sets. */
function choose(protocol, name, begin) {
    const field = protocol.field(name);
    begin([entryOf(protocol, field)], placesOf(field).find((one) => one.name === name)?.set);
}

/** Interprets a fragment: a device, and the name of a field or a packet. `problem` describes what cannot be used. */
function startOf(protocol, text) {
    const device = protocol.model.devices.find((one) => text === one.id || text.startsWith(`${one.id} `));
    const rest = device ? text.slice(device.id.length).trim() : text;
    if (!rest) return { device };
    if (protocol.fields.has(rest)) return { device, name: rest };
    const { bytes } = bytesOfText(rest);
    if (!bytes.length) return { device, search: rest, problem: "The address contains neither the name of a field nor a packet." };
    try {
        const packet = Packet.from(bytes);
        const entries = decodePacket(protocol, packet).map(takenOver);
        if (!entries.length) throw new MipError("fields", "it has no fields");
        const left = entries.filter(({ trailing }) => trailing).map(({ field, trailing }) => `${trailing} at the end of ${field.name}`);
        const problem = left.length ? `Bytes that belong to no parameter are left out: ${left.join(", ")}.` : undefined;
        return { device, entries: entries.map(({ field, values }) => ({ field, values })), set: packet.set, problem };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { device, problem: `The packet in the address cannot be used: ${error.message}.` };
    }
}

function takenOver({ descriptor, field, values, trailing, error }) {
    if (error) throw error;
    if (!field) throw new MipError("unknown", `there is no field with descriptor ${hexByte(descriptor)} in its set`);
    return { field, values, trailing };
}

function entryOf(protocol, field) {
    const first = [...protocol.functions.values()].find((one) => one.name === field.calls?.[0].function)?.value;
    return { field, values: initialValues(protocol, field, first) };
}
