// Filters the tables of a page: rows by the typed text and, on pages that compare devices, columns by device.
// It replaces `<div class="filter">`; without it, the tables are complete. The page's address keeps the choice.

(() => {
    const place = document.querySelector("div.filter");
    if (!place) return;
    const within = place.parentElement;
    const tables = [...within.querySelectorAll("table")].filter((table) => table.tHead);
    const asked = new URLSearchParams(location.search);

    const made = (name, attributes, ...children) => {
        const element = Object.assign(document.createElement(name), attributes);
        element.append(...children);
        return element;
    };
    const deviceOf = (link) => link.getAttribute("href").match(/(?:^|\/)devices\/([^/]+)\.(?:html|md)$/)?.[1];
    const devicesIn = (element) =>
        [...element.querySelectorAll("a[href]")].flatMap((link) => (deviceOf(link) ? [{ id: deviceOf(link), link }] : []));
    const withColumns = tables.filter((table) => devicesIn(table.tHead).length > 0);
    const chosen = new Set();

    // ------------------------------------------------------------------ devices

    /** Returns the id of the device that the reader has chosen on its page; see site.js. */
    function mine() {
        try {
            return JSON.parse(localStorage.getItem("mip-device"))?.id ?? "";
        } catch {
            return ""; // a browser may not store anything
        }
    }

    /** Adds columns for devices without one: with the entries of the list at the end of the page, else "?". */
    function addColumn(link, likely, assumed, refused) {
        const lists = { likely, assumed, no: refused };
        const answer = (field) => Object.keys(lists).find((word) => lists[word].includes(field)) ?? "?";
        for (const table of withColumns) {
            for (const row of table.rows) {
                const head = row.parentElement === table.tHead;
                const field = row.querySelector("td a[href]")?.getAttribute("href");
                const cell = made(head ? "th" : "td", { hidden: true });
                cell.append(head ? link.cloneNode(true) : answer(field));
                row.append(cell);
            }
        }
    }

    function devices() {
        const found = new Map();
        if (withColumns.length > 0) {
            for (const { id, link } of devicesIn(withColumns[0].tHead)) found.set(id, { title: link.textContent, own: true });
            for (const { id, link } of devicesIn(within)) {
                if (found.has(id)) continue;
                const fields = (cell) =>
                    [...(link.closest("tr")?.cells[cell]?.querySelectorAll("a[href]") ?? [])].map((a) => a.getAttribute("href"));
                addColumn(link, fields(2), fields(3), fields(4));
                found.set(id, { title: link.textContent, own: false });
            }
        } else {
            for (const { id, link } of devicesIn(within)) found.set(id, { title: link.textContent, own: true });
        }
        return found;
    }

    function chooser(known) {
        const boxes = [...known].map(([id, { title }]) => {
            const box = made("input", { type: "checkbox", value: id, checked: chosen.has(id) });
            box.addEventListener("change", () => {
                if (box.checked) chosen.add(id);
                else chosen.delete(id);
                update();
            });
            return made("label", {}, box, ` ${title}`);
        });
        const all = made("button", { type: "button", textContent: "All" });
        all.addEventListener("click", () => {
            chosen.clear();
            for (const label of boxes) label.firstChild.checked = false;
            update();
        });
        const summary = made("summary", {}, "Devices");
        const choices = made("fieldset", {}, made("legend", {}, "Compare"), ...boxes, all);
        return made("details", { open: chosen.size > 0 }, summary, choices);
    }

    // ------------------------------------------------------------------ rows

    /** Is a row the same for all chosen devices? */
    function alike(row, shown) {
        const cells = shown.map((at) => row.cells[at].textContent.trim());
        return cells.every((cell) => cell === cells[0]);
    }

    /** In a table without device columns, a row applies to the devices that it links to. */
    function listed(row, different) {
        const ids = new Set(devicesIn(row).map(({ id }) => id));
        const of = [...chosen].filter((id) => ids.has(id));
        return of.length > 0 && !(different && of.length === chosen.size);
    }

    function show(table, words, different) {
        const columns = new Map();
        for (const [at, cell] of [...table.tHead.rows[0].cells].entries()) {
            for (const { id } of devicesIn(cell)) columns.set(at, id);
        }
        const wanted = (id) => (chosen.size > 0 ? chosen.has(id) : known.get(id).own);
        const visible = (at) => !byDevice || wanted(columns.get(at));
        const shown = [...columns.keys()].filter(visible);
        let count = 0;
        for (const row of table.tBodies[0].rows) {
            row.dataset.text ??= row.textContent.toLowerCase();
            let keep = words.every((word) => row.dataset.text.includes(word));
            if (keep && columns.size > 0) keep = !(different && alike(row, shown));
            else if (keep && chosen.size > 0) keep = listed(row, different && withColumns.length === 0);
            row.hidden = !keep;
            if (keep) count += 1;
        }
        for (const row of table.rows) for (const at of columns.keys()) row.cells[at].hidden = !visible(at);
        return count;
    }

    /** Hides a table without rows, and its section from the heading on. */
    function hide(table, hidden) {
        let part = table;
        while (part.parentElement !== within) part = part.parentElement;
        for (; part && part !== form; part = part.previousElementSibling) {
            part.hidden = hidden;
            if (/^H[1-6]$/.test(part.tagName)) break;
        }
    }

    function update() {
        const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
        let count = 0;
        for (const table of tables) {
            const rows = show(table, words, differences.checked);
            hide(table, rows === 0);
            count += rows;
        }
        status.textContent = count === 1 ? "1 row" : `${count} rows`;
        remember();
    }

    /** Updates the address, and the links to the other pages that compare devices. */
    function remember() {
        const state = new URLSearchParams();
        if (chosen.size > 0) state.set("devices", [...chosen].join(","));
        if (differences.checked) state.set("differences", "");
        const kept = state.toString();
        if (byDevice) for (const link of siblings) link.search = kept;
        if (input.value) state.set("filter", input.value);
        const query = state.toString();
        history.replaceState(history.state, "", `${location.pathname}${query ? `?${query}` : ""}${location.hash}`);
    }

    // ------------------------------------------------------------------ controls

    const byDevice = place.classList.contains("devices");
    const besides = (link) => /^[a-z]+\.html$/.test(link.getAttribute("href"));
    const siblings = [...within.querySelectorAll("p a[href]")].filter(besides);
    const known = byDevice ? devices() : new Map();
    for (const id of (asked.get("devices") ?? mine()).split(",")) if (known.has(id)) chosen.add(id);

    const input = made("input", { type: "search", value: asked.get("filter") ?? "", autocomplete: "off" });
    const differences = made("input", { type: "checkbox", checked: asked.has("differences") });
    const status = made("output", {});
    const form = made("form", { className: place.className }, made("label", {}, "Rows with ", input));
    if (byDevice) form.append(made("label", {}, differences, " only differences"));
    form.append(status);
    if (byDevice) form.append(chooser(known));
    form.addEventListener("submit", (event) => event.preventDefault());
    input.addEventListener("input", update);
    differences.addEventListener("change", update);
    place.replaceWith(form);
    update();
})();
