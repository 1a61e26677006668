// The builder's report on a packet: its bytes and the device's reply.

import { MipError, unitOf } from "mip-protocol/tools";
import { answerOf, LANGUAGES, packetOf, sourceOf } from "./build.mjs";
import { copyButton, element, table } from "./dom.mjs";
import { inspectBytes } from "./inspect.mjs";
import { copies, ruler, valueTable } from "./ruler.mjs";
import { descriptorOf, spacedHex } from "./words.mjs";

/** Returns the packet, or the error that explains why there is none. */
export function built(protocol, { set, entries }) {
    try {
        return packetOf(protocol, set, entries);
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { error };
    }
}

export function report(protocol, { device, set, entries }, packet, to) {
    const sources = LANGUAGES.map(([key, title]) => {
        const text = sourceOf(packet.bytes, key);
        const copy = copyButton("Copy", () => text);
        return [element("dt", title, " ", copy), element("dd", element("code", { "data-language": key }, text))];
    });
    const [part] = inspectBytes(protocol, packet.bytes, device?.id);
    const shown = ruler(part);
    const rows = part.fields.flatMap((field) => field.rows ?? []);
    const title =
        entries.length === 1
            ? [to.field(entries[0].field), ` ${descriptorOf(entries[0].field, set)}`]
            : [`A packet of ${entries.length} fields`];
    return [
        element("h2", ...title),
        element(
            "section.mip-packet",
            element("p.mip-bytes", shown),
            element("p", copies(part)),
            rows.length > 0 && valueTable(rows, "Bytes and parameters"),
        ),
        ...entries.flatMap((entry) => entryReport(protocol, entry, entries.length > 1, to)),
        element("h3", "The packet in source code"),
        element("dl.mip-bytes", sources),
    ];
}

/** Links to the programs of a field, and shows the reply. */
function entryReport(protocol, { field, values }, several, to) {
    const heading = several ? [element("h2", to.field(field))] : [];
    const answer = field.role === "command" && field.sent_by !== "device" ? answerReport(protocol, field, values, to) : [];
    const action = { command: "send", data: "read" }[field.role];
    const page = action && to.page(field);
    return [...heading, page && element("p", `Programs that ${action} it: `, page), ...answer].filter(Boolean);
}

function answerReport(protocol, field, values, to) {
    const { silent, acknowledge, responses, conditions } = answerOf(protocol, field, values);
    const unless = conditions.length ? ` There is no answer if ${conditions.join(" or ")}.` : "";
    if (silent) return [element("h3", "Answer"), element("p.mip-answer", silent)];
    const listed = responses.map(({ field: response, when, packet }) =>
        element(
            "li",
            { "data-field": response.name },
            to.field(response),
            ` ${descriptorOf(response)}, ${sizeText(response)}`,
            when && `, if ${when}`,
            element("br"),
            "for example ",
            element("code.mip-bytes", spacedHex(packet.bytes)),
            layoutTable(response),
        ),
    );
    return [
        element("h3", "Answer"),
        element(
            "p.mip-answer",
            listed.length ? "The acknowledge, directly followed by a response in the same packet:" : "The acknowledge: ",
            !listed.length && element("code", spacedHex(acknowledge.bytes)),
            !listed.length && unless,
        ),
        listed.length > 0 && element("ul", listed),
        listed.length > 0 && unless && element("p", unless),
        element("p", "A NACK is an acknowledge with another code, without a response."),
    ].filter(Boolean);
}

/** Returns the parameters of a response, in order. */
function layoutTable(response) {
    const rows = response.parameters.map((parameter) => {
        const many = parameter.length === undefined ? "" : `[${parameter.length}]`;
        const cells = [parameter.name, `${parameter.type ?? "union"}${many}`, unitOf(parameter), parameter.description ?? ""];
        return element(
            "tr",
            cells.map((cell) => element("td", cell)),
        );
    });
    if (!rows.length) return "";
    return element("details", element("summary", "Layout"), table(["Name", "Type", "Unit", "Description"], rows, response.title));
}

function sizeText({ min_size: least, max_size: most }) {
    return least === most ? `${least + 2} bytes` : `${least + 2} to ${most + 2} bytes`;
}
