// The forms of the builder: the parameters of a field, and the differences on a device.

import {
    countOptional,
    differencesOn,
    initialValue,
    initialValues,
    optionalGroups,
    setsOf,
    shownOperations,
    typicalValues,
} from "./build.mjs";
import { element } from "./dom.mjs";
import { input, labelled, select } from "./inputs.mjs";
import { descriptorOf, hexByte } from "./words.mjs";

/** Creates a form for each field; several can be moved and removed. */
export function entryForms(protocol, state, events, to) {
    return state.entries.map((entry, i) => {
        const form = element("div.mip-form", inputs(protocol, state, entry, events));
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
            "section.mip-entry",
            { "data-field": entry.field.name },
            element("h2", `${i + 1}. `, to.field(entry.field), ` ${descriptorOf(entry.field, state.set)}`),
            element(
                "p",
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
    const parts = [element("p", field.description), ...deviceNotes(protocol, state, field)];
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

/** Shows the parts of a field that the chosen device accepts, and the differences on it. */
function deviceNotes(protocol, { device, set }, field) {
    if (!device) return [];
    const found = differencesOn(protocol, device, field, set);
    if (!found.length) return [];
    return [
        element(
            "ul.mip-device-notes",
            found.map((text) => element("li", `${device.title}: ${text}`)),
        ),
    ];
}

/** Creates buttons for optional parameters, which are added in order and removed in reverse order. */
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
    return buttons.length ? [element("p", buttons)] : [];
}
