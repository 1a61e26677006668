// The finder: type what you know about a field, and go to its page.

import { State } from "./address.mjs";
import { announced, count, element, links } from "./dom.mjs";
import { find, indexOf, kindOf, missing, packetIn } from "./find.mjs";

/** Fills an element with the finder. `options` are those of `links`, and `start`, the fragment of an address. */
export function finder(root, protocol, options = {}) {
    const to = links(options);
    const state = options.state ?? new State(options.start, options.device);
    if (!state.get("find") && state.get("given")) state.adopt({ find: state.get("given") });
    const index = indexOf(protocol);
    const input = element("input", { type: "search", id: "mip-find", autocomplete: "off", spellcheck: "false", value: state.get("find") });
    const { root: output, show } = announced("div");
    const update = () => {
        const packet = options.inspectorPage && packetIn(index, input.value);
        const fields = find(index, input.value).map(({ field }) => field);
        const list = hitsList(fields, to);
        if (packet) list.prepend(element("li", to.inspector(packet)));
        const found = list.children.length ? `${count(list.children.length, "result")} found.` : "Nothing found.";
        show(input.value.trim() && [missing(index, input.value), found].join(" ").trim(), [list]);
    };
    const form = element(
        "form",
        {
            role: "search",
            onsubmit: (event) => {
                event.preventDefault();
                output.querySelector("a[href]")?.click();
            },
        },
        element("label", { for: "mip-find" }, "A descriptor (0x0D13, 82 10), a name, a symbol of a binding, or words"),
        input,
    );
    root.replaceChildren(form, output);
    input.addEventListener("input", () => {
        state.set({ find: input.value });
        update();
    });
    update();
    return { update, input, output };
}

/** Lists fields with links to their pages, and from the tools' own pages also to the builder. */
export function hitsList(fields, to) {
    return element(
        "ul.mip-results",
        fields.map((field) =>
            element(
                "li",
                { "data-field": field.name },
                to.field(field, element("strong", field.title)),
                ` ${kindOf(field)} `,
                element("code", field.name),
                " ",
                to.builder(field),
                element("div", field.description),
            ),
        ),
    );
}
