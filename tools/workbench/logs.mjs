// A log in the inspector: the fields in a file of any size, and its packets page by page.

import { nameIn, Parser, segments } from "mip-protocol/tools";
import { Clocks, Rhythm } from "./clocks.mjs";
import { count, element, table } from "./dom.mjs";
import { inspectBytes } from "./inspect.mjs";
import { hexByte } from "./words.mjs";

/** The number of bytes that are read for a page. */
const PAGE = 8192;

/**
 * A panel for logs: `chooser`, the input for a file; `output`; and `acceptDrops(element)`.
 *
 * @param show returns the elements for parts of bytes; device returns the id of the device whose readings are used;
 *   opened is called when a log is opened
 */
export function logPanel(protocol, { show, device, opened }) {
    const output = element("div.mip-log", { role: "status" });
    const file = element("input", { type: "file", id: "mip-file", class: "mip-file" });
    const chooser = element("span.mip-chooser", element("label", { for: "mip-file" }, "Log or recording"), file);
    let reading = 0; // the latest file
    const open = async (chosen) => {
        const mine = ++reading;
        opened();
        output.replaceChildren(element("p", `Reading ${chosen.name} …`));
        const close = element("button", { type: "button", class: "mip-copy", onclick: () => output.replaceChildren() }, "Close the log");
        try {
            const found = await contents(protocol, chosen, () => mine === reading);
            const shown = await pages(chosen, (bytes) => show(inspectBytes(protocol, bytes, device())));
            if (mine !== reading) return;
            const words = `${count(chosen.size, "byte")}, ${count(found.packets, "packet")}; ${count(found.skipped, "byte")} outside packets. `;
            output.replaceChildren(element("h2", chosen.name), element("p.mip-summary", words, close), fieldTable(found), ...shown);
        } catch (error) {
            output.replaceChildren(element("p.mip-wrong", `${chosen.name} cannot be read: ${error.message}.`));
        }
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
    return { chooser, output, acceptDrops };
}

/** Reads a log while `wanted`: { packets, skipped, fields }. A field has `set`, `descriptor`, `field`, `count` and `rhythm`. */
async function contents(protocol, file, wanted) {
    const [parser, clocks, fields] = [new Parser(), new Clocks(protocol), new Map()];
    let packets = 0;
    const take = (packet) => {
        const time = clocks.timeOf(packet);
        packets++;
        packet.walk((at, end) => {
            const { set, descriptor, data } = packet.raw(at, end);
            const key = set * 256 + descriptor;
            if (!fields.has(key)) {
                fields.set(key, { set, descriptor, field: protocol.choose(set, descriptor, data), count: 0, rhythm: new Rhythm() });
            }
            const one = fields.get(key);
            one.count++;
            one.rhythm.add(time);
        });
    };
    for (const reader = file.stream().getReader(); wanted(); ) {
        const { value, done } = await reader.read();
        for (const packet of done ? parser.flush() : parser.feed(value)) take(packet);
        if (done) break;
    }
    return { packets, skipped: parser.skipped, fields: [...fields].sort(([a], [b]) => a - b).map(([, one]) => one) };
}

function fieldTable({ fields }) {
    const row = ({ set, descriptor, field, count: times, rhythm: { rate, lost } }) => [
        field ? `${field.title} · ${nameIn(field, set)}` : "unknown",
        `${hexByte(set)},${hexByte(descriptor)}`,
        times,
        rate ? Number(rate.toPrecision(5)) : "",
        lost || "",
    ];
    return table(
        ["Field", "Descriptor", "Count", "Rate in Hz", "Missing"],
        fields.map((one) =>
            element(
                "tr",
                row(one).map((text) => element("td", `${text}`)),
            ),
        ),
        "Fields in the log",
    );
}

/** Shows the first page of a file, with buttons and an input for the others; each is read when it is shown. */
async function pages(file, show) {
    const shown = element("div.mip-pages");
    const number = element("input", { type: "number", min: 0, max: file.size, value: 0, id: "mip-log-byte" });
    const place = element("span");
    let [before, end] = [[], 0]; // where earlier pages begin, and this one ends
    const go = async (begin) => {
        const bytes = new Uint8Array(await file.slice(begin, begin + PAGE).arrayBuffer());
        const whole = begin + bytes.length < file.size ? wholeUntil(bytes) : bytes.length;
        end = begin + whole;
        place.textContent = ` bytes ${begin} to ${end} `;
        number.value = begin;
        shown.replaceChildren(...show(bytes.subarray(0, whole)));
    };
    const earlier = () => go(before.pop() ?? 0);
    const later = () => {
        if (end >= file.size) return undefined;
        before.push(Number(number.value));
        return go(end);
    };
    number.addEventListener("change", () => {
        before = [];
        return go(Math.min(Math.max(Number(number.value), 0), file.size));
    });
    await go(0);
    const step = (words, onclick) => element("button", { type: "button", onclick }, words);
    const label = element("label", { for: "mip-log-byte" }, "Go to byte ");
    return [element("p", step("Earlier", earlier), place, step("Later", later), " ", label, number), shown];
}

/** Returns how many bytes of a page to show: its last part, of which more may follow, begins the next page. */
function wholeUntil(bytes) {
    return segments(bytes).at(-1).offset || bytes.length - 1;
}
