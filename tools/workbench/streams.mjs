// Data fields with rates in Hz: a table for each data set, for the bandwidth calculator and for live data.

import { decimation, nameIn, SHARED_SET } from "mip-protocol/tools";
import { certaintyOn } from "./build.mjs";
import { count, element, mark, table } from "./dom.mjs";
import { streamsOf } from "./stream.mjs";
import { descriptorOf, hexByte } from "./words.mjs";

/** The initial rate of a chosen field. */
const USUAL = 10;

/**
 * Returns the name of a field in an address: "sensor.scaled_accel"; for a shared field, "sensor+shared.gps_timestamp".
 */
export function streamName(field, set) {
    return field.set === SHARED_SET ? `${set.name}+${field.name}` : nameIn(field, set.number);
}

/** Fields that show a device at once: the first one that it supports of each line. */
const PRESET = [
    ["sensor.scaled_accel"],
    ["sensor.scaled_gyro"],
    ["filter_data.euler_angles", "sensor.comp_euler_angles"],
    ["filter_data.llh_position", "gnss_1.llh_position", "gnss_data.llh_position"],
];

/** Their rate in Hz. */
const SHOWN = 50;

/** Returns the text in an address for those fields of a device, each set with a timestamp. */
export function presetOf(protocol, device) {
    const places = streamsOf(protocol, device).flatMap(({ set, base, fields }) =>
        fields
            .filter((field) => base !== 0 && certaintyOn(protocol, device, field, set.number) !== "not known")
            .map((field) => ({ name: nameIn(field, set.number), set, base, field })),
    );
    const timestamps = protocol.model.clocks.flatMap((clock) => clock.timestamps);
    const chosen = PRESET.map((names) => names.map((name) => places.find((place) => place.name === name)).find(Boolean)).filter(Boolean);
    const timed = [...new Set(chosen.map(({ set }) => set))].map((set) =>
        timestamps.map((name) => places.find((place) => place.name === name && place.set === set)).find(Boolean),
    );
    return [...timed.filter(Boolean), ...chosen]
        .map(({ set, base, field }) => `${streamName(field, set)}@${base ? base / decimation(base, SHOWN) : SHOWN}`)
        .join(",");
}

/** Parses the text in an address, "sensor.scaled_accel@100,sensor.scaled_gyro@50", as name -> rate. */
export function ratesOf(text) {
    const pairs = text.split(",").map((part) => part.split("@"));
    return new Map(pairs.filter(([name, rate]) => name && rate).map(([name, rate]) => [name, rate]));
}

/**
 * A chooser of fields, whose choice is in the state: `root`, `chosen()`, an array for each set of { set, field, rate }
 * with the rate that the device can send, `problem()`, the first row that has none, and `layOut(device)`.
 * @param changed is called when the choice changes
 */
export function streamChooser(protocol, state, to, changed) {
    const root = element("div.mip-streams");
    let rows = [];
    const tell = () => {
        // Rates of fields that the chosen device does not support stay in the address.
        const held = ratesOf(state.get("streams"));
        for (const row of rows.flat()) held.delete(row.name);
        for (const row of rows.flat()) if (row.box.checked) held.set(row.name, row.input.value);
        state.set({ streams: [...held].map(([name, rate]) => `${name}@${rate}`).join(",") });
        for (const [i, summary] of [...root.querySelectorAll("summary")].entries()) summary.lastChild.textContent = chosenText(rows[i]);
        changed();
    };
    const layOut = (device) => {
        const held = ratesOf(state.get("streams"));
        const streams = streamsOf(protocol, device);
        rows = streams.map((stream) =>
            stream.fields.map((field) => streamRow(protocol, device, field, stream, held.get(streamName(field, stream.set)), tell, to)),
        );
        root.replaceChildren(...streams.map((stream, i) => streamTable(stream, rows[i])));
        changed();
    };
    return {
        root,
        layOut,
        chosen: () => rows.map((set) => set.filter(({ box }) => box.checked).map(({ set, field, rate }) => ({ set, field, rate: rate() }))),
        problem: () => rows.flat().find((row) => row.box.checked && row.problem()),
    };
}

function chosenText(rows) {
    const chosen = rows.filter(({ box }) => box.checked).length;
    return chosen ? `: ${count(chosen, "field")} chosen` : "";
}

function streamTable({ set, base }, rows) {
    const rate = base ? `base rate ${base} Hz` : base === 0 ? "sent as it arrives" : "base rate not known";
    return element(
        "details",
        { "data-set": set.name, open: rows.some(({ box }) => box.checked) },
        element("summary", `${set.title} (${hexByte(set.number)}), ${rate}`, element("strong", chosenText(rows))),
        table(
            ["Field", "Bytes", "Rate in Hz", "Sent at"],
            rows.map(({ line }) => line),
            `Fields of ${set.title}`,
        ),
    );
}

function streamRow(protocol, device, field, { set, base }, held, changed, to) {
    const name = streamName(field, set);
    const id = `mip-stream-${name}`;
    const box = element("input", { type: "checkbox", id, checked: held !== undefined });
    const input = element("input", {
        type: "number",
        min: 0,
        max: base || undefined,
        step: "any",
        value: held ?? Math.min(USUAL, base || USUAL),
        required: true,
        "aria-label": `Rate of ${field.title} in Hz`,
    });
    const wanted = () => Number(input.value);
    const text = element("td.mip-rate");
    const row = {
        name,
        set,
        field,
        box,
        input,
        rate: () => (base ? base / decimation(base, wanted()) : wanted()),
        problem() {
            if (wanted() > 0 && wanted() <= (base || Number.POSITIVE_INFINITY) && input.value.trim()) return undefined;
            return base ? `a rate above 0 Hz and up to ${base} Hz` : "a rate above 0 Hz";
        },
    };
    const tell = () => {
        const problem = row.problem();
        text.textContent = problem ?? rateText(base, wanted(), row.rate());
        text.classList.toggle("mip-wrong", Boolean(problem));
    };
    for (const control of [box, input]) {
        control.addEventListener("input", () => {
            if (control === input) box.checked = true;
            tell();
            changed();
        });
    }
    tell();
    const certainty = certaintyOn(protocol, device, field, set.number);
    const label = element("label", { for: id }, ` ${descriptorOf(field, set.number)} ${field.title}${mark(certainty)}`);
    row.line = element(
        "tr",
        { "data-field": field.name },
        element("td", box, label, " ", to.page(field)),
        element("td", `${field.max_size + 2}`),
        element("td", input),
        text,
    );
    return row;
}

function rateText(base, wanted, rate) {
    const number = `${Number(rate.toPrecision(6))} Hz`;
    if (!base) return number;
    const near = Math.abs(rate - wanted) > 1e-6 * wanted ? ", the nearest" : "";
    return `${number}${near} (decimation ${decimation(base, wanted)})`;
}
