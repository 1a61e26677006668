// Bandwidth: choose data fields and rates, and see which baud rate they need.

import { certaintyOn } from "./build.mjs";
import { element, links, mark, profileNote } from "./dom.mjs";
import { needOf, portsFor, streamsOf } from "./stream.mjs";
import { descriptorOf, hexByte } from "./words.mjs";

/** Decimations have two bytes. */
const MOST = 0xffff;

/**
 * Fills an element with the tool. `options` are those of `links`, and `start`, the id of a device. If it is given, the
 * fragment of the address follows the choice.
 */
export function bandwidth(root, protocol, options = {}) {
    const to = links(options);
    const device = element(
        "select",
        { id: "mip-stream-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id, selected: one.id === options.start }, one.title)),
    );
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    const note = element("div", { role: "status" });
    const list = element("div");
    let rows = [];
    const kept = new Map(); // rates that were chosen, also of what the present device does not have
    const chosen = () => protocol.model.devices.find((one) => one.id === device.value);
    const show = () => output.replaceChildren(...report(chosen(), rows));
    const layOut = () => {
        for (const row of rows.flat()) {
            if (row.box.checked && !row.problem()) kept.set(row.box.id, row.rate());
            else kept.delete(row.box.id);
        }
        const streams = streamsOf(protocol, chosen());
        const certainty = (field, { set }) => certaintyOn(protocol, chosen(), field, set.number);
        rows = streams.map((stream) => stream.fields.map((field) => streamRow(field, stream, certainty(field, stream), show, to)));
        for (const row of rows.flat()) if (kept.has(row.box.id)) row.choose(kept.get(row.box.id));
        note.replaceChildren(...[profileNote(chosen())].filter(Boolean));
        list.replaceChildren(...streams.map((stream, i) => streamTable(stream, rows[i])));
        show();
    };
    device.addEventListener("input", () => {
        layOut();
        if (options.start !== undefined) history.replaceState(history.state, "", `#${encodeURIComponent(device.value)}`);
    });
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

/** A line of the table; `rate` is that of the field, `problem` says why there is none, and `choose` sets it. */
function streamRow(field, { set, base }, certainty, show, to) {
    const id = `mip-stream-${set.name}-${field.name}`;
    const box = element("input", { type: "checkbox", id });
    const number = element("input", {
        type: "number",
        min: base ? 1 : 0,
        max: base ? MOST : undefined,
        step: base ? 1 : "any",
        value: base ? 10 : 1,
        required: true,
        "aria-label": `${base ? "decimation" : "rate in Hz"} of ${field.title}`,
    });
    const text = element("td", { class: "mip-rate" });
    const row = {
        field,
        box,
        rate: () => (base ? base / Number(number.value) : Number(number.value)),
        problem() {
            if (number.validity.valid && Number(number.value) > 0) return undefined;
            return base ? `a whole number from 1 to ${MOST}` : "a number above 0";
        },
        choose(rate) {
            box.checked = true;
            number.value = base ? Math.min(MOST, Math.max(1, Math.round(base / rate))) : rate;
            tell();
        },
    };
    const tell = () => {
        const problem = row.problem();
        text.textContent = problem ?? `${Number(row.rate().toPrecision(6))} Hz`;
        text.classList.toggle("mip-wrong", Boolean(problem));
    };
    const changed = () => {
        tell();
        show();
    };
    for (const control of [box, number]) control.addEventListener("input", changed);
    tell();
    const label = element("label", { for: id }, ` ${descriptorOf(field, set.number)} ${field.title}${mark(certainty)}`);
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
    const chosen = rows.map((set) => set.filter(({ box }) => box.checked));
    const wrong = chosen.flat().find((row) => row.problem());
    if (wrong) return [element("p", { class: "mip-wrong" }, `${wrong.field.title} needs ${wrong.problem()}.`)];
    const { bytes, baud } = needOf(chosen.map((set) => set.map(({ field, rate }) => ({ field, rate: rate() }))));
    if (!bytes) return [element("p", { class: "mip-note" }, "Choose fields below.")];
    const ports = portsFor(device, baud).map(({ port, rate }) => {
        const words = rate === null ? "no baud rate" : (rate ?? "none of its baud rates is enough");
        return element("tr", { "data-port": port.name }, element("td", {}, port.name), element("td", {}, `${words}`));
    });
    const heads = ["Port", "Smallest baud rate"].map((text) => element("th", { scope: "col" }, text));
    return [
        element(
            "p",
            { class: "mip-need" },
            `${round(bytes)} byte${round(bytes) === 1 ? "" : "s"}/s; over a UART at least ${round(baud)} Bd.`,
        ),
        ports.length > 0 && element("table", {}, element("thead", {}, element("tr", {}, heads)), element("tbody", {}, ports)),
        element("p", {}, "Allow headroom for replies to commands. A device drops the packets that do not fit."),
    ].filter(Boolean);
}

/** Rounded up: a rate that is a little too low is too low. */
function round(number) {
    return Math.ceil(Number(number.toFixed(6)));
}
