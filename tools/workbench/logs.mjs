// A log in the inspector: the contents of a file of any size, and its packets page by page.

import { GAP, undatedClocks } from "./clocks.mjs";
import { announced, copyButton, count, element, table } from "./dom.mjs";
import { inspectBytes } from "./inspect.mjs";
import { survey } from "./survey.mjs";
import { hexByte } from "./words.mjs";

/** The maximum number of gaps that are listed. */
const LISTED = 50;

/**
 * A panel for logs: `chooser`, the input for a file; `output`; and `acceptDrops(element)`.
 *
 * @param show returns the elements for parts of bytes; device returns the id of the device whose readings are used;
 *   opened is called when a log is opened
 */
export function logPanel(protocol, { show, device, opened }) {
    const { root: output, show: display } = announced("div.mip-log");
    const file = element("input", { type: "file", id: "mip-file", class: "mip-file" });
    const chooser = element("span.mip-chooser", element("label", { for: "mip-file" }, "Log or recording"), file);
    let reading = 0; // the latest file
    const open = async (chosen) => {
        const mine = ++reading;
        opened();
        const bar = element("progress", { max: Math.max(chosen.size, 1), value: 0, "aria-label": "Read so far" });
        const stop = element("button", { type: "button", onclick: () => reading++ }, "Stop");
        display(`Reading ${chosen.name}`, [element("p", bar, " ", stop)]);
        let found;
        try {
            const progress = (bytes) => {
                bar.value = bytes;
                return mine === reading;
            };
            found = await survey(protocol, () => piecesOf(chosen), progress, device());
        } catch (error) {
            display(`${chosen.name} cannot be read: ${error.message}.`, [], "mip-wrong");
            return;
        }
        const close = () => display("");
        if (mine === reading) display(...logReport(protocol, chosen, found, show, device, close));
        else if (output.contains(bar)) close();
    };
    file.addEventListener("change", () => {
        if (file.files[0]) open(file.files[0]);
        file.value = ""; // the same file may be chosen again
    });
    const acceptDrops = (root) => {
        const over = (there) => (event) => {
            if (!event.dataTransfer?.types.includes("Files")) return;
            event.preventDefault();
            root.classList.toggle("mip-over", there);
            if (event.type === "drop" && event.dataTransfer.files[0]) open(event.dataTransfer.files[0]);
        };
        root.addEventListener("dragover", over(true));
        root.addEventListener("dragleave", over(false));
        root.addEventListener("drop", over(false));
    };
    return { chooser, output, open, acceptDrops };
}

async function* piecesOf(file) {
    const reader = file.stream().getReader();
    for (;;) {
        const { value, done } = await reader.read();
        if (done) return;
        yield value;
    }
}

/** Returns the words that are announced, the other elements, and the class of the words. */
function logReport(protocol, file, found, show, device, close) {
    const beside = [
        found.skipped > 0 && `${count(found.skipped, "byte")} outside packets`,
        found.sentences > 0 && `${count(found.sentences, "NMEA sentence")} among them`,
    ].filter(Boolean);
    const summary = [`${count(found.bytes, "byte")}, ${count(found.packets, "packet")}`, ...beside].join("; ");
    const lines = () => [["field", "descriptor", "count", "rate_hz", "gaps"], ...found.fields.map(cellsOf)];
    const parts = [
        element(
            "p",
            copyButton("Copy the table", () =>
                lines()
                    .map((line) => line.join("\t"))
                    .join("\n"),
            ),
            " ",
            element("button", { type: "button", class: "mip-copy", onclick: close }, "Close the log"),
        ),
        ...timeReport(protocol, found),
        found.fields.length > 0 &&
            table(
                ["Field", "Descriptor", "Count", "Rate in Hz", "Gaps"],
                found.fields.map((one) =>
                    element(
                        "tr",
                        { "data-field": one.name ?? "" },
                        cellsOf(one).map((text) => element("td", text)),
                    ),
                ),
                `Contents of ${file.name}`,
            ),
        found.fields.some(({ rhythm }) => rhythm.rate) &&
            element(
                "p.mip-note",
                `Rates and gaps are by the timestamps of the device; a gap is more than ${GAP} usual intervals. `,
                "Fields without a rate are not regular, or have no timestamps.",
            ),
        found.gaps.length > 0 && gapList(found.gaps),
        found.packets > 0 && pages(protocol, file, found, show, () => device() ?? found.reads),
    ];
    return [`${file.name}: ${summary}.`, parts, "mip-summary"];
}

/** Describes the time of a log, how flags were read, and values that were not valid. */
function timeReport(protocol, { spans, fields, read }) {
    const lines = spans.map((span, i) => `${i ? "Restart of the clock: " : ""}${spanText(protocol, span)}.`);
    if (read) lines.push(`${read[0].toUpperCase()}${read.slice(1)}.`);
    for (const { field, valid, count: times } of fields) {
        if (valid === undefined || valid === times) continue;
        lines.push(`${field.title}: valid in ${Number(((100 * valid) / times).toPrecision(3))} % of ${times}.`);
    }
    return lines.map((line) => element("p.mip-time", line));
}

/** "2024-02-08T00:00:00.000Z to …; device clock 12.5 to 12.89 s, no date: not synchronized" */
export function spanText(protocol, span) {
    return protocol.model.clocks
        .filter(({ name }) => span[name])
        .map(({ name, title, epoch }) => {
            const [first, last] = span[name];
            if (epoch) return [first, last].map(dateText).join(" to ");
            const alone = undatedClocks(protocol).has(name);
            return `${title} ${[first, last].map((time) => Number(time.toFixed(4))).join(" to ")} s${alone ? ", no date: not synchronized" : ""}`;
        })
        .join("; ");
}

function cellsOf({ set, descriptor, field, name, count: times, rhythm: { rate, gaps, lost } }) {
    return [
        field ? `${field.title} · ${name}` : "unknown",
        `${hexByte(set)},${hexByte(descriptor)}`,
        `${times}`,
        rate ? `${Number(rate.toPrecision(5))}` : "",
        gaps ? `${gaps}, ${count(lost, "sample")} missing` : rate ? "none" : "",
    ];
}

/** "before packet 41: 0.5 s after 12.89 s, 49 samples of sensor.scaled_accel"; a date if the clock has one */
export function gapText({ at, dated, seconds, lost, fields, packet }) {
    const begin = dated ? dateText(at) : `${Number(at.toFixed(4))} s`;
    const names = fields.map(({ name }) => name ?? "unknown").join(", ");
    return `before packet ${packet + 1}: ${Number(seconds.toPrecision(4))} s after ${begin}, ${count(lost, "sample")} of ${names}`;
}

function dateText(seconds) {
    return new Date(1000 * seconds).toISOString();
}

function gapList(gaps) {
    const item = (gap) => element("li", gapText(gap));
    const more = gaps.length > LISTED && element("p", `${gaps.length - LISTED} more gaps.`);
    return element("details", element("summary", count(gaps.length, "gap")), element("ul", gaps.slice(0, LISTED).map(item)), more || "");
}

/** Shows the packets of a file page by page; each page is read when it is shown. */
function pages(protocol, file, found, show, device) {
    const shown = element("div");
    const number = element("input", { type: "number", min: 1, max: found.packets, value: 1, id: "mip-log-packet" });
    const place = element("span");
    const pageOf = (packet) =>
        Math.max(
            0,
            found.pages.findLastIndex(({ first }) => first <= packet),
        );
    let at = 0;
    const go = async (page) => {
        at = Math.min(Math.max(page, 0), found.pages.length - 1);
        const { offset, first } = found.pages[at];
        const end = found.pages[at + 1]?.offset ?? found.bytes;
        const bytes = new Uint8Array(await file.slice(offset, end).arrayBuffer());
        place.textContent = ` packets ${first + 1} to ${found.pages[at + 1]?.first ?? found.packets} of ${found.packets} `;
        shown.replaceChildren(...show(inspectBytes(protocol, bytes, device())));
    };
    const step = (words, by) => element("button", { type: "button", onclick: () => go(at + by) }, words);
    number.addEventListener("change", () => go(pageOf(Number(number.value) - 1)));
    const section = element(
        "details.mip-pages",
        element("summary", "Packets"),
        element(
            "p",
            step("Earlier", -1),
            place,
            step("Later", 1),
            " ",
            element("label", { for: "mip-log-packet" }, "Go to packet "),
            number,
        ),
        shown,
    );
    section.addEventListener("toggle", () => {
        if (section.open && !shown.children.length) go(0);
    });
    return section;
}
