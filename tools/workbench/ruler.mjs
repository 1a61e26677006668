// Shows the bytes of a packet and their meaning, linked by colours: pointing at one highlights the other.

import { nameIn } from "mip-protocol/tools";
import { copyButton, count, element, table } from "./dom.mjs";
import { descriptorOf, flagText, hexByte, spacedHex } from "./words.mjs";

/** The number of colours before they repeat. */
const COLOURS = 6;

/** Elements whose bytes and rows are linked. */
const linked = new WeakSet();

/**
 * Shows the bytes of a packet in pieces, each in the colour of its value. The argument is a part that `inspect`
 * returns.
 */
export function ruler({ bytes, kind, fields }) {
    const pieces = [];
    let at = 0;
    const until = (end, attributes) => {
        if (end > at) pieces.push(element("span", attributes, spacedHex(bytes.subarray(at, end))));
        at = Math.max(at, end);
    };
    until(Math.min(4, bytes.length), { class: "mip-frame", title: "Sync bytes, descriptor set, payload length" });
    let colour = 0;
    for (const { offset, bytes: whole, rows = [], field } of fields) {
        if (offset === undefined) continue;
        until(offset, { class: "mip-frame" });
        until(offset + 2, { class: "mip-head", title: `${field?.title ?? "Field"}: length, descriptor` });
        for (const row of rows) {
            row.colour = colour++ % COLOURS;
            until(at + row.bytes.length, { ...coloured(row.colour), "data-value": row.path, title: row.path });
        }
        until(offset + whole.length, { class: "mip-rest", title: "No known parameter" });
    }
    if (kind === "packet" || kind === "damaged") until(bytes.length - 2, { class: "mip-rest" });
    until(bytes.length, { class: "mip-frame", title: kind === "incomplete" ? "The rest" : "Checksum" });
    return element("code.mip-packet-bytes", ...pieces.flatMap((piece, i) => (i ? [" ", piece] : [piece])));
}

/** Highlights bytes and rows that belong together, in a part of a page. */
export function linkRows(root) {
    if (linked.has(root)) return;
    linked.add(root);
    const mark = (event) => {
        const held = event.target.closest?.("[data-value], [data-path]");
        const box = held?.closest(".mip-packet");
        for (const one of root.querySelectorAll(".mip-pointed")) one.classList.remove("mip-pointed");
        if (!box) return;
        const path = held.dataset.value ?? held.dataset.path;
        for (const one of box.querySelectorAll("[data-value], [data-path]")) {
            const same = (one.dataset.value ?? one.dataset.path) === path && colourOf(one) === colourOf(held);
            one.classList.toggle("mip-pointed", same);
        }
    };
    for (const event of ["mouseover", "focusin"]) root.addEventListener(event, mark);
}

/** Returns the attributes of bytes in a colour of the style sheet. */
const coloured = (colour) => ({ class: "mip-colour", "data-colour": colour, style: `--mip-own: var(--mip-${colour})` });

const colourOf = (one) => one.dataset.colour ?? one.firstElementChild?.dataset.colour;

export function valueTable(rows, label) {
    return table(["Bytes", "Parameter", "Value", "Meaning"], rows.map(valueRow), label);
}

const CHOOSE = " Depends on the device; choose one above.";

function valueRow({ bytes, path, text, unit, name, meaning, flags, parameter, byDevice, colour }) {
    const value = [element("span.mip-number", text), unit && ` ${unit}`, name && [" ", element("code", name)]];
    const shownFlags = flags?.flatMap((flag, i) => [
        i ? ", " : "",
        element("span.mip-flag", { title: flag.named?.description ?? flag.bits?.description }, flagText(flag)),
    ]);
    return element(
        "tr",
        { "data-path": path },
        element("td", coloured(colour), element("code", spacedHex(bytes))),
        element("td", element("code", path)),
        element("td", value),
        element("td", shownFlags?.length ? shownFlags : flags ? "none set" : (meaning ?? parameter.description ?? ""), byDevice && CHOOSE),
    );
}

/** Describes a packet as plain text: a line for each field and value. */
export function textOf({ bytes, set, fields, sound }) {
    const lines = [
        `${spacedHex(bytes)}`,
        `${set?.title ?? "unknown set"} (${hexByte(bytes[2] ?? 0)})${sound === false ? ", wrong checksum" : ""}`,
    ];
    for (const { field, descriptor, rows = [], error, trailing, answered } of fields) {
        if (descriptor === undefined) lines.push(`  ${error.message}`);
        else if (answered) lines.push(`  ${answered.text}`);
        else lines.push(`  ${field ? `${nameIn(field, bytes[2])} ${descriptorOf(field, bytes[2])}` : `descriptor ${hexByte(descriptor)}`}`);
        if (!answered) for (const row of rows) lines.push(`    ${row.path} = ${rowText(row)}`);
        if (trailing) lines.push(`    ${count(trailing, "byte")} after the last known parameter`);
    }
    return `${lines.join("\n")}\n`;
}

/** "4 receiver_1", "0.25 g", "0x0003 tow_valid, week_number_valid". */
export function rowText({ text, unit, name, flags, meaning }) {
    const said = flags ? flags.map(flagText).join(", ") || "none set" : (name ?? (meaning && meaning.length < 30 ? meaning : ""));
    return [text, unit, said].filter(Boolean).join(" ");
}

export function copies(part) {
    return element(
        "span.mip-copies",
        copyButton("Copy bytes", () => spacedHex(part.bytes)),
        " ",
        copyButton("Copy as text", () => textOf(part)),
    );
}
