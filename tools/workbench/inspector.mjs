// The inspector: paste bytes or drop a log to see what they mean.

import { fromHex, nameIn } from "mip-protocol/tools";
import { State } from "./address.mjs";
import { announced, count, deviceChoice, element, links } from "./dom.mjs";
import { find, indexOf } from "./find.mjs";
import { hitsList } from "./finder.mjs";
import { inspect, transactionsOf } from "./inspect.mjs";
import { logPanel } from "./logs.mjs";
import { copies, linkRows, ruler, rowText, valueTable } from "./ruler.mjs";
import { descriptorOf, hexByte, spacedHex } from "./words.mjs";

/** The maximum number of packets shown for a text; logs have pages. */
const MOST = 1000;

/** A text of more letters is read a moment after the last key. */
const LONG = 10_000;
const PAUSE = 150;

/**
 * Fills an element with the inspector. `options` are those of `links`, and `start`, the fragment of an address; without
 * bytes in it, the inspector begins with the first example of the specification.
 */
export function inspector(root, protocol, options = {}) {
    const to = links(options);
    const state = options.state ?? new State(options.start, options.device);
    if (!state.get("bytes") && state.get("given")) state.adopt({ bytes: state.get("given") });
    const input = element(
        "textarea",
        { rows: 5, spellcheck: "false", autocomplete: "off", id: "mip-bytes" },
        state.get("bytes") || example(protocol),
    );
    const device = deviceChoice(protocol, state, "mip-device", () => update());
    const { root: output, show } = announced("div.mip-output");
    let index;
    const hits = (text) => {
        index ??= indexOf(protocol);
        return find(index, text).map(({ field }) => field);
    };
    const update = () => {
        show(...report(inspect(protocol, input.value, device.chosen()?.id, MOST), to, hits));
    };
    const log = logPanel(protocol, {
        device: () => device.chosen()?.id,
        opened() {
            if (state.get("bytes")) return;
            input.value = ""; // the example
            show("");
        },
        show: (parts) => [transactionList(transactionsOf(parts), to), ...parts.map((part) => partReport(part, to))].filter(Boolean),
    });
    root.replaceChildren(
        element(
            "p",
            element(
                "label",
                { for: "mip-bytes" },
                "Bytes in hexadecimal: dumps, arrays or strings; there may be other bytes between packets",
            ),
        ),
        input,
        element("p.mip-controls", element("span", element("label", { for: "mip-device" }, "Values as on"), device.control), log.chooser),
        log.output,
        output,
    );
    let timer;
    input.addEventListener("input", () => {
        state.set({ bytes: input.value });
        clearTimeout(timer);
        if (input.value.length > LONG) timer = setTimeout(update, PAUSE);
        else update();
    });
    log.acceptDrops(root);
    linkRows(root);
    update();
    return { update, input, output };
}

function example(protocol) {
    const first = protocol.model.examples[0];
    return first ? spacedHex(fromHex(first.packet)) : "";
}

/** Returns the words that are announced, the other elements, and the class of the words. */
function report({ bytes, ignored, parts, packets, more, transactions }, to, hits) {
    if (!bytes.length && ignored.length) {
        const text = ignored.join(" ");
        const fields = hits(text);
        const words = "No bytes were found in this text; hexadecimal is needed. Not read as bytes: ";
        return [words + text, fields.length ? [element("p", "Fields that it may mean:"), hitsList(fields, to)] : [], "mip-wrong"];
    }
    if (!bytes.length) return ["Nothing to read yet."];
    const summary = `${count(bytes.length, "byte")}, ${count(packets, "packet")}`;
    const note = State.tooLong(spacedHex(bytes)) ? "; too long for a link: the address does not hold it" : "";
    const others = ignored.length ? `; not read as bytes: ${ignored.join(" ")}` : "";
    const shown = [transactionList(transactions, to), ...parts.map((part) => partReport(part, to))];
    if (more) shown.push(element("p.mip-note", `${more} more are not shown; open the file as a log.`));
    return [summary + others + note, shown, "mip-summary"];
}

/** Shows commands and their replies, if there is a reply. */
export function transactionList(transactions, to) {
    if (!transactions.some(({ answer }) => answer)) return undefined;
    return element(
        "section.mip-transactions",
        element("h2", "Commands and answers"),
        element(
            "ol",
            transactions.map((one) => element("li", transaction(one, to))),
        ),
    );
}

/** Describes a command in words, with its outcome. */
export function transaction({ command, answer, response }, to) {
    const answered = answer?.answered;
    const field = command?.field ?? answered?.command;
    const named = field ? to.field(field) : answered ? `Command ${hexByte(answered.descriptor)}` : "";
    const asked = command ? command.rows.map((row) => `${row.path} ${rowText(row)}`).join(", ") : "";
    const became = !answered ? "no reply here" : answered.text;
    return [
        element("strong", named),
        field && ` ${descriptorOf(field)} `,
        asked && element("span.mip-asked", asked),
        element("div", { class: !answered ? "mip-note" : answered.accepted ? "mip-right" : "mip-refused" }, `${became}.`),
        response?.rows.length > 0 &&
            element(
                "ul",
                response.rows.map((row) => element("li", element("code", row.path), ` = ${rowText(row)}`)),
            ),
    ].filter(Boolean);
}

function partReport(part, to) {
    return part.kind === "other" ? otherBytes(part) : packetReport(part, to);
}

function otherBytes({ bytes, why }) {
    const text = Array.from(bytes, (byte) => (byte >= 32 && byte < 127 ? String.fromCharCode(byte) : "·")).join("");
    return element(
        "section.mip-other",
        { "data-kind": "other" },
        element("p", `${count(bytes.length, "byte")} outside packets: `, element("code", spacedHex(bytes)), ` ${text}`),
        why.map(({ at, error }) =>
            element("p.mip-wrong", `The bytes from byte ${at + 1} look like a packet, but are not one: ${error.message}.`),
        ),
    );
}

export function packetReport(part, to) {
    const { bytes, kind, set, fields } = part;
    const title = set ? `${set.title} (${hexByte(set.number)})` : bytes.length > 2 ? `Unknown set ${hexByte(bytes[2])}` : "Packet";
    const bytesShown = ruler(part); // which gives each row its colour
    return element(
        "section.mip-packet",
        { "data-kind": kind, "data-bytes": spacedHex(bytes) },
        element("h2", title),
        element("p.mip-bytes", bytesShown),
        element("p", copies(part), " ", verdict(part)),
        part.misprints.map((misprint) => misprintNote(misprint, to)),
        fields.map((field) => fieldReport(field, bytes[2], to)),
    );
}

function verdict({ kind, bytes, sound, checksum, rightChecksum }) {
    if (kind === "incomplete") {
        const missing = bytes.length > 3 ? count(bytes[3] + 6 - bytes.length, "byte") : "at least one byte";
        return element("span.mip-verdict.mip-wrong", `The packet is incomplete: ${missing} missing.`);
    }
    if (sound) {
        return element("span.mip-verdict.mip-right", "Checksum ", element("code", spacedHex(checksum)), " is right.");
    }
    return element(
        "span.mip-verdict.mip-wrong",
        "Checksum ",
        element("code", spacedHex(checksum)),
        " is wrong; correct: ",
        element("code", spacedHex(rightChecksum)),
        ".",
    );
}

function misprintNote({ example, right, errata }, to) {
    return element(
        "p.mip-note",
        `The manual ${example.manual} shows these bytes (${example.section}: ${example.title}) by mistake. Correct: `,
        element("code", spacedHex(right)),
        ". ",
        errata.length ? ["See ", listed(errata, to), "."] : "",
    );
}

function listed(errata, to) {
    return errata.flatMap((erratum, i) => [i ? ", " : "", to.erratum(erratum)]);
}

function fieldReport(found, set, to) {
    const { field, descriptor, bytes, error, rows = [], errata = [], trailing, answered } = found;
    if (descriptor === undefined) return element("p.mip-wrong", `The rest is malformed: ${error.message}.`);
    const heading = field
        ? element("h3", to.field(field), ` ${descriptorOf(field, set)} `, element("code", nameIn(field, set)))
        : element("h3", `Unknown descriptor ${hexByte(descriptor)}`);
    return element(
        "div.mip-field",
        { "data-field": field?.name ?? "" },
        heading,
        answered
            ? element("p", { class: answered.accepted ? "mip-right" : "mip-refused" }, `${answered.text}.`)
            : field && element("p", field.description),
        element("p.mip-bytes", element("code", spacedHex(bytes))),
        error && element("p.mip-wrong", `It cannot be decoded: ${error.message}.`),
        rows.length > 0 && valueTable(rows, field.title),
        trailing > 0 && element("p.mip-note", `${count(trailing, "byte")} after the last known parameter.`),
        errata.length > 0 && element("p.mip-note", "Mistakes in the manuals: ", listed(errata, to)),
    );
}
