// The inspector: paste bytes, read what they mean.

import { fromHex, nameIn } from "mip-protocol/tools";
import { element, links, whenChanged } from "./dom.mjs";
import { inspect } from "./inspect.mjs";
import { descriptorOf, flagText, hexByte, spacedHex } from "./words.mjs";

/**
 * Fills an element with the inspector. `options` are those of `links`, and `start`, the bytes to begin with; without any,
 * the first example of the specification.
 */
export function inspector(root, protocol, options = {}) {
    const to = links(options);
    const input = element(
        "textarea",
        { rows: 5, spellcheck: "false", autocomplete: "off", id: "mip-bytes" },
        options.start || example(protocol),
    );
    const device = element(
        "select",
        { id: "mip-device" },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id }, one.title)),
    );
    const output = element("div", { class: "mip-output", "aria-live": "polite" });
    const update = () => {
        const found = inspect(protocol, input.value, device.value || undefined);
        output.replaceChildren(...report(found, to));
    };
    root.replaceChildren(
        element(
            "p",
            {},
            element(
                "label",
                { for: "mip-bytes" },
                "Bytes in hexadecimal: dumps, arrays or strings; there may be other bytes between packets",
            ),
        ),
        input,
        element("p", {}, element("label", { for: "mip-device" }, "Values as on "), device),
        output,
    );
    whenChanged([input, device], update);
    update();
    return { update, input, output };
}

function example(protocol) {
    const first = protocol.model.examples[0];
    return first ? spacedHex(fromHex(first.packet)) : "";
}

function report({ bytes, ignored, parts }, to) {
    if (!bytes.length && ignored.length) {
        const words = "No bytes were found in this text; hexadecimal is needed. Not read as bytes: ";
        return [element("p", { class: "mip-wrong" }, words, ignored.join(" "))];
    }
    if (!bytes.length) return [element("p", { class: "mip-note" }, "Nothing to read yet.")];
    const packets = parts.filter((part) => part.kind !== "other").length;
    const summary = `${count(bytes.length, "byte")}, ${count(packets, "packet")}`;
    return [
        element("p", { class: "mip-summary" }, summary, ignored.length ? `; not read as bytes: ${ignored.join(" ")}` : ""),
        ...parts.map((part) => (part.kind === "other" ? otherBytes(part) : packetReport(part, to))),
    ];
}

function count(number, word) {
    return `${number} ${word}${number === 1 ? "" : "s"}`;
}

function otherBytes({ bytes, why }) {
    const text = Array.from(bytes, (byte) => (byte >= 32 && byte < 127 ? String.fromCharCode(byte) : "·")).join("");
    return element(
        "section",
        { class: "mip-other", "data-kind": "other" },
        element("p", {}, `${count(bytes.length, "byte")} outside packets: `, element("code", {}, spacedHex(bytes)), ` ${text}`),
        why.map(({ at, error }) =>
            element("p", { class: "mip-wrong" }, `What begins like a packet at byte ${at + 1} is none: ${error.message}.`),
        ),
    );
}

function packetReport(part, to) {
    const { bytes, kind, set, fields } = part;
    const title = set ? `${set.title} (${hexByte(set.number)})` : bytes.length > 2 ? `Unknown set ${hexByte(bytes[2])}` : "Packet";
    return element(
        "section",
        { class: "mip-packet", "data-kind": kind, "data-bytes": spacedHex(bytes) },
        element("h2", {}, title),
        element("p", { class: "mip-bytes" }, element("code", {}, spacedHex(bytes))),
        verdict(part),
        part.misprints.map((misprint) => misprintNote(misprint, to)),
        fields.map((field) => fieldReport(field, bytes[2], to)),
    );
}

function verdict({ kind, bytes, sound, checksum, rightChecksum }) {
    if (kind === "incomplete") {
        const missing = bytes.length > 3 ? count(bytes[3] + 6 - bytes.length, "byte") : "at least one byte";
        return element("p", { class: "mip-verdict mip-wrong" }, `The packet is incomplete: ${missing} missing.`);
    }
    if (sound) return element("p", { class: "mip-verdict mip-right" }, "Checksum ", element("code", {}, spacedHex(checksum)), " is right.");
    return element(
        "p",
        { class: "mip-verdict mip-wrong" },
        "Checksum ",
        element("code", {}, spacedHex(checksum)),
        " is wrong; correct: ",
        element("code", {}, spacedHex(rightChecksum)),
        ".",
    );
}

function misprintNote({ example, right, errata }, to) {
    return element(
        "p",
        { class: "mip-note" },
        `The manual ${example.manual} gives these bytes (${example.section}: ${example.title}) by mistake. Correct: `,
        element("code", {}, spacedHex(right)),
        ". ",
        errata.length ? ["See ", listed(errata, to), "."] : "",
    );
}

function listed(errata, to) {
    return errata.flatMap((erratum, i) => [i ? ", " : "", to.erratum(erratum)]);
}

function fieldReport(found, set, to) {
    const { field, descriptor, bytes, error, rows = [], errata = [], trailing } = found;
    if (descriptor === undefined) return element("p", { class: "mip-wrong" }, `The rest is malformed: ${error.message}.`);
    const heading = field
        ? element("h3", {}, to.field(field), ` ${descriptorOf(field, set)} `, element("code", {}, nameIn(field, set)))
        : element("h3", {}, `Unknown descriptor ${hexByte(descriptor)}`);
    return element(
        "div",
        { class: "mip-field", "data-field": field?.name ?? "" },
        heading,
        field && element("p", {}, field.description),
        element("p", { class: "mip-bytes" }, element("code", {}, spacedHex(bytes))),
        error && element("p", { class: "mip-wrong" }, `It cannot be decoded: ${error.message}.`),
        rows.length > 0 && valueTable(rows),
        trailing > 0 && element("p", { class: "mip-note" }, `${count(trailing, "byte")} after the last known parameter.`),
        errata.length > 0 && element("p", { class: "mip-note" }, "Mistakes in the manuals: ", listed(errata, to)),
    );
}

function valueTable(rows) {
    const heads = ["Bytes", "Parameter", "Value", "Meaning"].map((text) => element("th", { scope: "col" }, text));
    return element(
        "div",
        { class: "mip-scroll" },
        element("table", {}, element("thead", {}, element("tr", {}, heads)), element("tbody", {}, rows.map(valueRow))),
    );
}

const CHOOSE = " Depends on the device; choose one above.";

function valueRow({ bytes, path, text, unit, name, meaning, flags, parameter, byDevice }) {
    const value = [element("span", { class: "mip-number" }, text), unit && ` ${unit}`, name && [" ", element("code", {}, name)]];
    const shownFlags = flags?.flatMap((flag, i) => [
        i ? ", " : "",
        element("span", { class: "mip-flag", title: flag.named?.description ?? flag.bits?.description }, flagText(flag)),
    ]);
    return element(
        "tr",
        { "data-path": path },
        element("td", {}, element("code", {}, spacedHex(bytes))),
        element("td", {}, element("code", {}, path)),
        element("td", {}, value),
        element(
            "td",
            {},
            shownFlags?.length ? shownFlags : flags ? "none set" : (meaning ?? parameter.description ?? ""),
            byDevice && CHOOSE,
        ),
    );
}
