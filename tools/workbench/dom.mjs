// Creates elements of a page, and links to the reference.

/** Creates an element, "p" or "p.class", with attributes, if an object comes first, and children; texts are shown literally. */
export function element(name, ...children) {
    const [tag, ...classes] = name.split(".");
    const made = document.createElement(tag);
    if (classes.length) made.className = classes.join(" ");
    const attributes = children[0]?.constructor === Object ? children.shift() : {};
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
        else if (value === true) made.setAttribute(name, "");
        else if (value !== undefined && value !== false && value !== null) made.setAttribute(name, value);
    }
    made.append(...children.flat(Infinity).filter((child) => child !== undefined && child !== null && child !== false));
    return made;
}

/**
 * Creates an output, of which only the first line is announced to a screen reader: `root`, and `show`, which is called
 * with the words of that line, other elements, and the class of the line.
 */
export function announced(name) {
    const line = element("p", { role: "status" });
    const rest = element("div");
    const show = (words, parts = [], kind = "mip-note") => {
        line.className = kind;
        line.replaceChildren(...[words].flat().filter(Boolean));
        rest.replaceChildren(...parts.filter(Boolean));
    };
    return { root: element(name, line, rest), show };
}

/** Calls what rebuilds the controls in an element; the successor of the one that had the focus has it then. */
export function keepFocus(root, rebuild) {
    const before = root.contains(document.activeElement) ? document.activeElement : undefined;
    const controls = () => [...root.querySelectorAll("input, select, button")].filter((one) => !one.disabled && !one.hidden);
    const at = controls().indexOf(before);
    const { value, selectionStart: from, selectionEnd: to } = before ?? {};
    const name = before && nameOf(before);
    rebuild();
    if (!before) return;
    const now = controls();
    const same = before.isConnected ? before : now.find((one) => nameOf(one) === name);
    (same ?? now[Math.min(at, now.length - 1)])?.focus();
    if (!same || typeof from !== "number") return;
    same.value = value; // as it was typed
    same.setSelectionRange(from, to);
}

/** Returns what distinguishes a control from others: the legends around it, its label, and the kind of a button. */
function nameOf(control) {
    const names = [control.getAttribute("aria-label") ?? (control.matches("button") ? control.className || control.textContent : "")];
    names.push(control.closest("p")?.querySelector("label")?.textContent);
    const around = (one) => one.parentElement.closest("fieldset, .mip-entry");
    for (let one = around(control); one; one = around(one)) names.push(one.querySelector("legend, h2").textContent);
    return names.join("\n");
}

/**
 * Links into the reference. `options.fieldPage`, `options.acknowledgePage`, `options.erratumPage`,
 * `options.inspectorPage` and `options.builderPage` are addresses with {set}, {page}, {field} and {packet} in them;
 * that of an erratum has its {manual}, {severity} and {id}. Without one, there are no links. A response is on the page
 * of its command. `options.target` is that of the links.
 */
export function links(options = {}) {
    const { target } = options;
    const link = (href, words) => (href ? element("a", { href, target, rel: target && "noopener" }, ...words) : element("span", ...words));
    const address = (pattern, values) => pattern?.replace(/\{(\w+)\}/g, (_, name) => encodeURIComponent(values[name]));
    return {
        field(field, ...words) {
            const [set, page] = (field.command ?? field.name).split(".");
            const pattern = field.set ? options.fieldPage : options.acknowledgePage;
            return link(address(pattern, { set, page, field: field.name }), words.length ? words : [field.title]);
        },
        page(field) {
            return options.fieldPage ? this.field(field, "page") : "";
        },
        erratum(erratum) {
            return link(address(options.erratumPage, erratum), [erratum.id]);
        },
        inspector(packet) {
            return link(address(options.inspectorPage, { packet }), ["Packet: open in the inspector"]);
        },
        builder(field) {
            const href = address(options.builderPage, { field: field.name });
            return href && element("a", { href, class: "mip-note", "aria-label": `Build a packet: ${field.title}` }, "Build a packet");
        },
    };
}

/** Describes the gaps in the profile of a device, if it is incomplete. */
export function profileNote(device) {
    if (!device?.incomplete) return undefined;
    const unknown = device.incomplete.join(" ").replaceAll("`", "");
    const marked = "Fields whose support is likely, assumed or unknown are offered and marked.";
    return element("p.mip-note", `The profile of the ${device.title} is incomplete: ${unknown} ${marked}`);
}

/** Returns the words after the name of a field whose support by the device is not certain. */
export function mark(certainty) {
    return certainty ? ` (${certainty})` : "";
}

/** Creates a list of devices to choose from. `choose` is called with the device, or undefined for any. */
export function deviceChoice(protocol, state, id, choose) {
    const control = element(
        "select",
        { id },
        element("option", { value: "" }, "any device"),
        protocol.model.devices.map((one) => element("option", { value: one.id }, one.title)),
    );
    const chosen = () => deviceOf(protocol, control.value);
    control.value = deviceOf(protocol, state.get("device"))?.id ?? "";
    control.addEventListener("input", () => {
        state.set({ device: control.value });
        choose(chosen());
    });
    return { control, chosen };
}

export function deviceOf(protocol, id) {
    return protocol.model.devices.find((one) => one.id === id);
}

/** Creates a button that copies the text that a function returns. */
export function copyButton(words, text) {
    const button = element("button", { type: "button", class: "mip-copy" }, words);
    button.addEventListener("click", async () => {
        const done = await copied(text());
        button.textContent = done ? "Copied" : "Not copied";
        setTimeout(() => {
            button.textContent = words;
        }, 1500);
    });
    return button;
}

async function copied(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return copiedBySelection(text); // pages from disk, and without the permission
    }
}

function copiedBySelection(text) {
    const area = element("textarea", { "aria-hidden": "true" }, text);
    const before = document.activeElement;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    before?.focus();
    return done;
}

/** Creates a table with column headings, which scrolls if it is too wide. */
export function table(heads, rows, label) {
    const cells = heads.map((text) => element("th", { scope: "col" }, text));
    for (const row of rows) for (const [i, cell] of [...row.cells].entries()) cell.dataset.head = heads[i]; // on a narrow screen
    return element(
        "div.mip-scroll",
        { tabindex: "0", role: "group", "aria-label": label ?? heads.join(", ") },
        element("table", element("thead", element("tr", cells)), element("tbody", rows)),
    );
}

export function count(number, word) {
    return `${number} ${word}${number === 1 ? "" : "s"}`;
}
