// Bandwidth: choose data fields and rates, and see which baud rate they need.

import { certaintyOn } from "./build.mjs";
import { element, links, mark, profileNote } from "./dom.mjs";
import { needOf, portsFor, streamsOf } from "./stream.mjs";
import { descriptorOf, hexByte } from "./words.mjs";

/** Fills an element with the tool. `options` are those of `links`, and `device`, the id of the one to begin with. */
export function bandwidth(root, protocol, options = {}) {
    const to = links(options);
    const device = element(
        "select",
        { id: "mip-stream-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id, selected: one.id === options.device }, one.title)),
    );
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    const note = element("div", { role: "status" });
    const list = element("div");
    let rows = [];
    const chosen = () => protocol.model.devices.find((one) => one.id === device.value);
    const show = () => output.replaceChildren(...report(chosen(), rows));
    const layOut = () => {
        const streams = streamsOf(protocol, chosen());
        const certainty = (field) => certaintyOn(protocol, chosen(), field);
        rows = streams.map((stream) => stream.fields.map((field) => streamRow(field, stream, certainty(field), show, to)));
        note.replaceChildren(...[profileNote(chosen())].filter(Boolean));
        list.replaceChildren(...streams.map((stream, i) => streamTable(stream, rows[i])));
        show();
    };
    device.addEventListener("input", layOut);
    root.replaceChildren(element("p", {}, element("label", { for: "mip-stream-device" }, "Device "), device), note, output, list);
    layOut();
}

function streamTable({ set, base }, rows) {
    const rate = base ? `base rate ${base} Hz` : base === 0 ? "sent as it arrives" : "base rate not known";
    const heads = ["Field", "Bytes", base ? "Decimation" : "Rate in Hz", "Rate"].map((text) => element("th", { scope: "col" }, text));
    return element(
        "details",
        { "data-set": set.name, open: rows.some(({ box }) => box.checked) },
        element("summary", {}, `${set.title} (${hexByte(set.number)}), ${rate}`),
        element(
            "div",
            { class: "mip-scroll" },
            element(
                "table",
                {},
                element("thead", {}, element("tr", {}, heads)),
                element(
                    "tbody",
                    {},
                    rows.map(({ line }) => line),
                ),
            ),
        ),
    );
}

/** A line of the table; `rate` is that of the field, 0 while it is not chosen. */
function streamRow(field, { set, base }, certainty, show, to) {
    const id = `mip-stream-${set.name}-${field.name}`;
    const box = element("input", { type: "checkbox", id });
    const number = element("input", {
        type: "number",
        min: base ? 1 : 0,
        step: base ? 1 : "any",
        value: base ? 10 : 1,
        "aria-label": `${base ? "decimation" : "rate in Hz"} of ${field.title}`,
    });
    const text = element("td", { class: "mip-rate" });
    const rateOf = () => {
        const given = Math.max(0, Number(number.value) || 0);
        return base ? base / Math.max(1, Math.trunc(given)) : given;
    };
    const row = { field, box, rate: () => (box.checked ? rateOf() : 0) };
    const changed = () => {
        text.textContent = `${Number(rateOf().toPrecision(6))} Hz`;
        show();
    };
    for (const control of [box, number]) control.addEventListener("input", changed);
    text.textContent = `${Number(rateOf().toPrecision(6))} Hz`;
    const label = element("label", { for: id }, ` ${descriptorOf(field)} ${field.title}${mark(certainty)}`);
    row.line = element(
        "tr",
        { "data-field": field.name },
        element("td", {}, box, label, " ", to.field(field, "page")),
        element("td", {}, `${field.max_size + 2}`),
        element("td", {}, number),
        text,
    );
    return row;
}

function report(device, rows) {
    const streams = rows.map((set) => set.filter(({ box }) => box.checked).map(({ field, rate }) => ({ field, rate: rate() })));
    const { bytes, baud } = needOf(streams);
    if (!bytes) return [element("p", { class: "mip-note" }, "Choose fields below.")];
    const ports = portsFor(device, baud).map(({ port, rate }) => {
        const words = rate === null ? "no baud rate" : (rate ?? "none of its baud rates is enough");
        return element("tr", { "data-port": port.name }, element("td", {}, port.name), element("td", {}, `${words}`));
    });
    const heads = ["Port", "Smallest baud rate"].map((text) => element("th", { scope: "col" }, text));
    return [
        element("p", { class: "mip-need" }, `${round(bytes)} bytes/s; over a UART at least ${round(baud)} Bd.`),
        ports.length > 0 && element("table", {}, element("thead", {}, element("tr", {}, heads)), element("tbody", {}, ports)),
        element("p", {}, "Leave room for the answers to commands. A device drops the packets that do not fit."),
    ].filter(Boolean);
}

/** Rounded up: a rate that is a little too low is too low. */
function round(number) {
    return Math.ceil(Number(number.toFixed(6)));
}
