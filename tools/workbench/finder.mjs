// The finder: type what you know of a field, and go to its page.

import { element, links } from "./dom.mjs";
import { find, indexOf, kindOf, packetIn } from "./find.mjs";

/** Fills an element with the finder. `options` are those of `links`, and `start`, the text to look for at first. */
export function finder(root, protocol, options = {}) {
    const to = links(options);
    const index = indexOf(protocol);
    const input = element("input", { type: "search", id: "mip-find", autocomplete: "off", spellcheck: "false", value: options.start });
    const output = element("ul", { class: "mip-results", "aria-live": "polite" });
    const update = () => {
        const packet = options.inspectorPage && packetIn(index, input.value);
        const found = find(index, input.value).map(({ field }) => resultItem(field, to));
        if (packet) found.unshift(element("li", {}, to.inspector(packet)));
        const nothing = input.value.trim() ? [element("li", {}, "Nothing found.")] : [];
        output.replaceChildren(...(found.length ? found : nothing));
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
        element("label", { for: "mip-find" }, "A descriptor (0x0D13, 82 10), a name, a symbol of C, Python or Rust, or words"),
        input,
    );
    root.replaceChildren(form, output);
    input.addEventListener("input", update);
    update();
    return { update, input, output };
}

function resultItem(field, to) {
    return element(
        "li",
        { "data-field": field.name },
        to.field(field, element("strong", {}, field.title)),
        ` ${kindOf(field)} `,
        element("code", {}, field.name),
        element("div", {}, field.description),
    );
}
