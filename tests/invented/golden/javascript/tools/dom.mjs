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
 * Where the reference has things. `options.fieldPage`, `options.acknowledgePage` and `options.erratumPage` are addresses
 * with {set}, {page}, {field} and {id} in them; without one, there are no links. A response is on the page of its command.
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
    };
}

function link(href, words) {
    return href ? element("a", { href }, ...words) : element("span", {}, ...words);
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
