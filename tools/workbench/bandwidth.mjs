// The bandwidth calculator: choose data fields and rates, and see which baud rate they need.

import { State } from "./address.mjs";
import { deviceChoice, deviceOf, element, links, profileNote } from "./dom.mjs";
import { find, indexOf } from "./find.mjs";
import { hitsList } from "./finder.mjs";
import { needOf, portsFor } from "./stream.mjs";
import { streamChooser } from "./streams.mjs";

/**
 * Fills an element with the tool. `options` are those of `links`, and `start`, the fragment of an address, or the id of
 * a device.
 */
export function bandwidth(root, protocol, options = {}) {
    const to = links(options);
    const state = options.state ?? new State(options.start, options.device);
    const given = state.get("given");
    if (deviceOf(protocol, given)) state.adopt({ device: given });
    const output = element("div.mip-output.mip-totals", { "aria-live": "polite" });
    const note = element("div", { role: "status" });
    const show = () => output.replaceChildren(...report(device.chosen(), chooser));
    const chooser = streamChooser(protocol, state, to, show);
    const layOut = () => {
        note.replaceChildren(...[profileNote(device.chosen())].filter(Boolean));
        chooser.layOut(device.chosen());
    };
    const device = deviceChoice(protocol, state, "mip-stream-device", layOut);
    root.replaceChildren(
        ...unknown(protocol, given, to),
        element("p", element("label", { for: "mip-stream-device" }, "Device "), device.control),
        note,
        output,
        chooser.root,
    );
    layOut();
}

/** Interprets an address that names no device. */
function unknown(protocol, given, to) {
    if (!given || deviceOf(protocol, given)) return [];
    const hits = find(indexOf(protocol), given).map(({ field }) => field);
    return [
        element("p.mip-wrong", `The address contains an unknown device: “${given}”.`),
        hits.length > 0 && element("p", "Fields that it may mean:"),
        hits.length > 0 && hitsList(hits, to),
    ].filter(Boolean);
}

function report(device, chooser) {
    const wrong = chooser.problem();
    if (wrong) return [element("p.mip-wrong", `${wrong.field.title} needs ${wrong.problem()}.`)];
    const { bytes, baud } = needOf(chooser.chosen());
    if (!bytes) return [element("p.mip-note", "Choose fields below.")];
    const ports = portsFor(device, baud).map(({ port, rate }) => {
        const words = rate === null ? "no baud rate" : (rate ?? "none of its baud rates is sufficient");
        const kind = rate === undefined ? "mip-wrong" : "";
        return element("li", { "data-port": port.name, class: kind }, `${port.name}: `, element("span", `${words}`), rate > 0 ? " Bd" : "");
    });
    return [
        element("p.mip-need", `${round(bytes)} byte${round(bytes) === 1 ? "" : "s"}/s; over a UART at least ${round(baud)} Bd.`),
        ports.length > 0 && element("ul.mip-ports", { "aria-label": "Smallest baud rate of each port" }, ports),
        element("p", "Allow headroom for replies to commands. A device drops the packets that do not fit."),
    ].filter(Boolean);
}

/** Rounded up, because a rate that is slightly too low is not sufficient. */
function round(number) {
    return Math.ceil(Number(number.toFixed(6)));
}
