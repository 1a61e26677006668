// Elements of a page, and links to the reference.

/** An element with attributes and children; texts are shown as they are. */
export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
        else if (value === true) made.setAttribute(name, "");
        else if (value !== undefined && value !== false && value !== null) made.setAttribute(name, value);
    }
    made.append(...children.flat(Infinity).filter((child) => child !== undefined && child !== null && child !== false));
    return made;
}

/**
 * Where the reference has things. `options.fieldPage`, `options.acknowledgePage`, `options.erratumPage` and
 * `options.inspectorPage` are addresses with {set}, {page}, {field}, {id} and {packet} in them; without one, there are no
 * links. A response is on the page of its command.
 */
export function links(options = {}) {
    const address = (pattern, values) => pattern?.replace(/\{(\w+)\}/g, (_, name) => encodeURIComponent(values[name]));
    return {
        field(field, ...words) {
            const [set, page] = (field.command ?? field.name).split(".");
            const pattern = field.set ? options.fieldPage : options.acknowledgePage;
            return link(address(pattern, { set, page, field: field.name }), words.length ? words : [field.title]);
        },
        erratum(erratum) {
            return link(address(options.erratumPage, { id: erratum.id }), [erratum.id]);
        },
        inspector(packet) {
            return link(address(options.inspectorPage, { packet }), ["Packet: open in the inspector"]);
        },
    };
}

function link(href, words) {
    return href ? element("a", { href }, ...words) : element("span", {}, ...words);
}

/** What is not known of a device, if its profile is incomplete. */
export function profileNote(device) {
    if (!device?.incomplete) return undefined;
    const unknown = device.incomplete.join(" ").replaceAll("`", "");
    const marked = "Fields that it probably has, or of which nothing is known, are offered and marked.";
    return element("p", { class: "mip-note" }, `The profile of the ${device.title} is incomplete: ${unknown} ${marked}`);
}

/** Words behind the name of a field that a device does not have for certain. */
export function mark(certainty) {
    return certainty ? ` (${certainty})` : "";
}

/** Calls a function when the user has changed something. */
export function whenChanged(inputs, update) {
    for (const input of inputs) input.addEventListener("input", update);
}

/** What is behind the # of the address, as it is if it is no encoded text. */
export function fragment() {
    const text = location.hash.slice(1);
    try {
        return decodeURIComponent(text);
    } catch {
        return text;
    }
}
