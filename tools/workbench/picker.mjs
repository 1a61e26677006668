// A search for one field: what is typed, and a list of the fields that may be meant.

import { nameIn } from "mip-protocol/tools";
import { certaintyOn, setsOf } from "./build.mjs";
import { announced, count, element, mark } from "./dom.mjs";
import { find } from "./find.mjs";
import { descriptorOf, hexByte } from "./words.mjs";

/** The maximum number of fields that a search shows. */
const SHOWN = 12;

/**
 * Creates a search for a field. Enter chooses the first hit; arrow keys select a hit.
 *
 * @param options.id, options.label of the input
 * @param options.choose is called with the field, and the set under which it was listed if it was
 * @param options.device returns the device whose fields come first; options.sets the numbers of sets, undefined for all
 */
export function picker(index, { id, label, choose, device = () => undefined, sets = () => undefined }) {
    const { protocol } = index;
    const input = element("input", { type: "search", id, autocomplete: "off", spellcheck: "false", "aria-describedby": `${id}-hint` });
    const hint = element("small", { id: `${id}-hint` }, "A name, a descriptor such as 0x0C28, a symbol in your program, or words");
    const { root: list, show } = announced("div.mip-hits");
    const pick = (field, set) => {
        input.value = "";
        if (list.contains(document.activeElement)) input.focus(); // the list goes
        show("");
        choose(field, set);
    };
    const item = (field, set, certainty) =>
        element(
            "li",
            { "data-field": field.name },
            element(
                "button",
                { type: "button", onclick: () => pick(field, set) },
                element("strong", field.title, mark(certainty)),
                ` ${descriptorOf(field, set)} `,
                field.role !== "command" && `${field.role} `,
                element("code", nameIn(field, set)),
            ),
        );
    const placed = (field, chosen) => {
        const here = sets();
        const places = setsOf(protocol, field).filter((set) => !here || here.includes(set));
        const known = places.map((set) => ({ field, set, certainty: certaintyOn(protocol, chosen, field, set) }));
        const named = known.find(({ set }) => nameIn(field, set) === input.value.trim());
        return named ?? known.find(({ certainty }) => certainty !== undefined) ?? known[0];
    };
    const update = () => {
        const chosen = device();
        const hits = find(index, input.value, protocol.model.fields.length);
        const found = hits.map(({ field }) => placed(field, chosen)).filter(Boolean);
        const own = found.filter(({ certainty }) => certainty !== undefined);
        const others = found.filter(({ certainty }) => certainty === undefined);
        const rows = (some) => some.slice(0, SHOWN).map(({ field, set, certainty }) => item(field, set, certainty));
        const more = own.length > SHOWN && element("p.mip-note", `${own.length - SHOWN} more: type another word.`);
        const summary = found.length ? `${count(found.length, "field")} found.` : `Nothing found for “${input.value.trim()}”.`;
        const elsewhere = others.length > 0 && [
            element("p.mip-note", `Not supported by the ${chosen.title}:`),
            element("ul", rows(others).slice(0, own.length ? 3 : SHOWN)),
        ];
        show(input.value.trim() && summary, [own.length > 0 && element("ul", rows(own)), more, elsewhere].flat());
    };
    const browse = element("details.mip-browse", element("summary", "Browse by set"));
    browse.addEventListener("toggle", () => {
        if (browse.open) browse.replaceChildren(browse.firstChild, ...setLists());
    });
    const setLists = () => {
        const here = sets();
        const shown = protocol.model.sets.filter((set) => !here || here.includes(set.number));
        return shown.flatMap((set) => {
            const fields = set.fields.map((name) => protocol.field(name));
            const known = fields.map((field) => [field, certaintyOn(protocol, device(), field, set.number)]);
            const items = known.filter(([, certainty]) => certainty !== undefined);
            if (!items.length) return [];
            const title = `${set.title} (${hexByte(set.number)}), ${items.length}`;
            const rows = items.map(([field, certainty]) => item(field, set.number, certainty));
            return element("details", element("summary", title), element("ul", rows));
        });
    };
    const form = element(
        "form",
        {
            role: "search",
            "aria-label": label,
            onsubmit: (event) => {
                event.preventDefault();
                list.querySelector("button")?.click();
            },
        },
        element("label", { for: id }, label),
        input,
        hint,
    );
    input.addEventListener("input", update);
    const root = element("div.mip-picker", form, list, browse);
    root.addEventListener("keydown", (event) => stepThrough(event, input, list));
    const look = (text) => {
        input.value = text;
        update();
    };
    const refresh = () => {
        update();
        browse.open = false;
    };
    return { root, input, look, refresh };
}

function stepThrough(event, input, list) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const stops = [input, ...list.querySelectorAll("button")];
    const at = stops.indexOf(document.activeElement);
    if (!step || at < 0 || stops.length < 2) return;
    event.preventDefault();
    stops[Math.min(Math.max(at + step, 0), stops.length - 1)].focus();
}
