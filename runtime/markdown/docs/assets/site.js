// The tools of the site, and the search at the top of its pages. Everything is loaded from the folder of this script, when
// it is needed, as scripts, because pages that are opened from disk must not fetch.
(() => {
    const assets = new URL(".", document.currentScript.src).href;
    const site = new URL("..", assets).href;
    const addresses = {
        fieldPage: `${site}fields/{set}/{page}.html#{field}`,
        acknowledgePage: `${site}packets.html#{field}`,
        erratumPage: `${site}errata.html#erratum.{id}`,
        inspectorPage: `${site}tools/inspector.html#{packet}`,
    };
    const loading = new Map();

    /** Loads a script of this folder once. */
    function load(name) {
        if (!loading.has(name)) {
            const script = document.createElement("script");
            script.src = assets + name;
            const loaded = new Promise((done, failed) => Object.assign(script, { onload: done, onerror: failed }));
            document.head.append(script);
            loading.set(name, loaded);
        }
        return loading.get(name);
    }

    function hasTools() {
        return document.querySelector("link[href$='assets/tools.css']") !== null;
    }

    /** The specification, for the search and all tools of this page; null if the site is built without the workbench. */
    let known;
    async function protocol() {
        if (!hasTools()) return null;
        await load(document.querySelector("[data-tool]") ? "workbench.js" : "fields.js");
        known ??= new mip.Protocol(mip.model);
        return known;
    }

    function element(tag, attributes, ...children) {
        const made = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
        made.append(...children);
        return made;
    }

    // ------------------------------------------------------------------------------------------------ tools

    async function fill(tool) {
        const anchor = () => document.getElementById(location.hash.slice(1)); // that of a heading is not for the tool
        const show = async () => {
            const of = await protocol();
            if (of) mip[tool.dataset.tool](tool, of, { ...addresses, start: anchor() ? "" : mip.fragment(), device: mine()?.id });
        };
        await show();
        addEventListener("hashchange", () => anchor() || show());
    }

    /** Creates a link that opens a tool with a packet. */
    function openIn(tool, word, bytes) {
        const href = `${site}tools/${tool}.html#${encodeURIComponent(bytes)}`;
        return element("a", { href, "aria-label": `${word} ${bytes.slice(0, 17)} …` }, word);
    }

    /** Adds links from the page of a field to the tools: the builder opens with the field, or with the values of a packet. */
    function linkTools() {
        const field = document.querySelector("article :is(h1, a)[id*='.']")?.id;
        for (const link of document.querySelectorAll("article a[href$='tools/builder.html']")) {
            if (field) link.hash = field;
        }
        for (const code of document.querySelectorAll("article :is(td, pre, p) > code, article .mip-ruler")) {
            const bytes = code.textContent.trim().replace(/\s+/g, " ");
            if (!/^75 65( [0-9A-F]{2}){4,}$/.test(bytes)) continue;
            const links = element("span", { class: "mip-open" }, openIn("inspector", "inspect", bytes));
            const answer = /^75 65 [0-7]. .. .. F1/.test(bytes);
            if (!answer) links.append(" ", openIn("builder", "edit", bytes));
            if (code.parentElement.tagName === "PRE") code.parentElement.after(links);
            else code.after(" ", links);
            code.closest("td")?.classList.add("mip-packet-cell");
        }
    }

    const LONG = 30; // characters; longer texts are descriptions, whose column needs a minimum width

    /** Allows names in a table that is too wide to break between their words. */
    function breakNames(table) {
        const texts = document.createTreeWalker(table, NodeFilter.SHOW_TEXT);
        const found = [];
        while (texts.nextNode()) found.push(texts.currentNode);
        for (const text of found) {
            const parts = text.data.split(/(?<=[a-z0-9][_*](?=[a-z0-9]))|(?<=[a-z]\.(?=[a-z]))|(?<=\w::)|(?=\[)/i);
            if (parts.length > 1) text.replaceWith(...parts.flatMap((part, i) => (i ? [element("wbr", {}), part] : [part])));
        }
        const last = Math.max(...[...table.rows].map((row) => row.lastElementChild.textContent.length));
        table.dataset.narrow = last < LONG ? "short" : "long";
    }

    /** Breaks content that is too wide for the window; if that is not enough, it scrolls by itself, also by the keyboard. */
    function fit() {
        for (const nav of document.querySelectorAll("nav.md-code__nav")) nav.role = "group"; // no landmarks, of which there are many
        const boxes = [...document.querySelectorAll("article :is(.md-typeset__scrollwrap, .mip-scroll, pre > code)")];
        const isWide = (box) => box.scrollWidth > box.clientWidth;
        for (const box of boxes.filter(isWide)) for (const table of box.querySelectorAll("table:not([data-narrow])")) breakNames(table);
        const wide = boxes.map(isWide); // before the first change: to measure after each would lay out the page each time
        for (const [i, box] of boxes.entries()) {
            if (wide[i]) box.tabIndex = 0;
            else box.removeAttribute("tabindex");
        }
    }

    // --------------------------------------------------------------------------------------------- complete programs

    /** Returns the language of a tab: its name, and the suffix of its files. */
    const LANGUAGES = {
        C: ["c", "c"],
        "C++": ["cpp", "cpp"],
        Python: ["python", "py"],
        Rust: ["rust", "rs"],
        JavaScript: ["javascript", "mjs"],
    };

    /** Replaces the lines between two comments of a program by others, with the same indentation. */
    function replaced(lines, from, count, others) {
        const at = lines.findIndex((line) => line.includes(from)) + 1;
        if (!at) return;
        const indent = lines[at - 1].match(/^ */)[0];
        lines.splice(
            at,
            count ?? lines.findIndex((line) => line.includes("end of 2")) - at,
            ...others.map((line) => line && indent + line),
        );
    }

    /** Returns a complete program with the lines of a page; `numbers` are the descriptor set and the descriptor, in hexadecimal. */
    function wholeProgram(frame, text, [set, descriptor]) {
        const [lines, others] = [frame.split("\n"), text.trimEnd().split("\n")];
        const needs = others.filter((line) => /^(#include|from|use|import) /.test(line));
        replaced(lines, "1. the line", 1, needs);
        replaced(
            lines,
            "2. the other",
            undefined,
            others.filter((line) => !needs.includes(line)),
        );
        const type = /device\.fields\(([\w.]+)/.exec(text)?.[1];
        const numbers = lines[lines.findIndex((line) => line.includes("3. the")) + 1];
        const own = numbers.replace("0x80", `0x${set}`).replace("0x04", `0x${descriptor}`);
        replaced(lines, "3. the", 1, [type ? own.replace(/[\w.]+(?=\]?;?$)/, type) : own]);
        return lines.join("\n");
    }

    function showProgram(title, name, text) {
        const code = element("code", {}, text);
        const copy = element("button", { class: "md-button" }, "Copy");
        const save = element("a", { class: "md-button", download: name, href: `data:text/plain,${encodeURIComponent(text)}` }, "Download");
        const close = element("button", { class: "md-button" }, "Close");
        const box = element("dialog", { class: "mip-program md-typeset", "aria-label": title });
        box.append(element("p", {}, copy, " ", save, " ", close), element("pre", { tabindex: 0 }, code));
        copy.addEventListener("click", () => navigator.clipboard.writeText(text).then(() => copy.replaceChildren("Copied")));
        close.addEventListener("click", () => box.close());
        box.addEventListener("close", () => box.remove());
        document.body.append(box);
        box.showModal();
    }

    /** Offers each program of a field as a complete file. */
    function offerPrograms() {
        const role = document.querySelector("article a[href*='programs.html#programs.']")?.hash.split(".")[1];
        const field = document.querySelector("article h1[id*='.']")?.id;
        if (!role || !field) return;
        const bytes = [...document.querySelectorAll(".mip-ruler code")].map((code) => code.textContent);
        const labels = [...document.querySelectorAll("article .tabbed-labels label")].map((label) => label.textContent.trim());
        for (const [i, code] of document.querySelectorAll("article .tabbed-block code").entries()) {
            const [language, suffix] = LANGUAGES[labels[i]];
            const button = element("button", { class: "md-button mip-whole" }, "Complete program");
            button.addEventListener("click", async () => {
                await load("frames.js");
                const numbers = role === "data" ? [bytes[1], bytes[3].slice(3)] : [];
                const text = wholeProgram(mipFrames[role][language], code.textContent, numbers);
                showProgram(`Complete program for ${field}`, `${field.split(".")[1]}.${suffix}`, text);
            });
            code.closest(".tabbed-block").append(button);
        }
    }

    // ------------------------------------------------------------------------------------------------ my device

    const MINE = "mip-device";

    /** Returns the device that a reader has chosen, with id and title; null if there is none. */
    function mine() {
        try {
            return JSON.parse(localStorage.getItem(MINE));
        } catch {
            return null; // a browser may not store anything
        }
    }

    /** Returns how certain it is that a device supports a field in one of its sets; undefined if it does not. */
    function certaintyOf(device, name) {
        const of = known.model.devices.find(({ id }) => id === device.id);
        const field = known.fields.get(name);
        if (!of || !field) return "not known";
        const found = mip.placesOf(field).map(({ set }) => mip.certaintyOn(known, of, field, set));
        return Object.keys(SAID).find((one) => found.includes(one));
    }

    const SAID = {
        "": "supported",
        likely: "likely to be supported",
        assumed: "assumed to be supported",
        "not known": "not known to be supported",
        undefined: "not supported",
    };

    /** Creates a remark on whether the reader's device supports a field. */
    function remarkOn(device, name) {
        const link = element("a", { href: `${site}devices/${device.id}.html` }, device.title);
        return element("p", { class: "mip-mine" }, "On my device, ", link, `: ${SAID[certaintyOf(device, name)]}.`);
    }

    /** Adds a choice of the device to its page; the pages of fields and sets then show what it supports. */
    async function myDevice() {
        const title = document.querySelector("article h1");
        const [, kind, name] = /\/(devices|fields|sets)\/(?:\w+\/)?([\w-]+)\.html/.exec(location.pathname) ?? [];
        if (!title || !kind || !hasTools()) return;
        if (kind === "devices") return chooser(title, { id: name, title: title.firstChild.textContent.trim() });
        const device = mine();
        if (!device) return;
        await protocol();
        if (kind === "fields") return title.after(remarkOn(device, title.id), ...hiding(valuesOfOthers(device)));
        for (const row of document.querySelectorAll("article tbody tr")) {
            const link = row.querySelector("a[href*='fields/']");
            const certainty = link ? certaintyOf(device, link.hash.slice(1)) : "";
            if (certainty === undefined || certainty === "not known") row.classList.add("mip-other");
        }
        const words = `Only what the ${device.title}, my device, has or is believed to have.`;
        title.after(element("p", { class: "mip-mine" }, words), ...hiding(document.querySelectorAll(".mip-other")));
    }

    /** Hides content for other devices, and returns a check box that shows it. */
    function hiding(others) {
        if (!others.length) return [];
        const box = element("input", { type: "checkbox" });
        const hide = () => {
            for (const other of others) other.hidden = !box.checked;
        };
        box.addEventListener("change", hide);
        hide();
        return [element("label", {}, box, " Show what only other devices have")];
    }

    /** Finds the lines and sections of a field about values on devices other than the reader's. */
    function valuesOfOthers(device) {
        const lines = [...document.querySelectorAll("article li")].filter((line) => line.querySelector("a[href*='/devices/']"));
        const isMine = (line) => line.querySelector(`a[href$='/devices/${device.id}.html']`) !== null;
        const typesOf = (some) => some.flatMap((line) => [...line.querySelectorAll("a[href*='/types/']")].map((link) => link.hash));
        const meant = lines.filter((line) => /: values of/.test(line.textContent));
        if (!meant.some(isMine)) return [];
        const [own, others] = [typesOf(meant.filter(isMine)), meant.filter((line) => !isMine(line))];
        const names = typesOf(others)
            .filter((type) => !own.includes(type))
            .map((type) => type.split(".").at(-1));
        const sections = [...document.querySelectorAll("article h2")].filter((heading) =>
            names.includes(heading.querySelector("code:last-of-type")?.textContent),
        );
        return [...others, ...sections.flatMap(sectionOf)];
    }

    /** Returns a heading, and everything up to the next one. */
    function sectionOf(heading) {
        const section = [heading];
        while (section.at(-1).nextElementSibling && section.at(-1).nextElementSibling.tagName !== "H2") {
            section.push(section.at(-1).nextElementSibling);
        }
        return section;
    }

    function chooser(title, device) {
        const chosen = mine()?.id === device.id;
        const button = element("button", { class: "md-button mip-choose" }, chosen ? "No longer my device" : "This is my device");
        button.addEventListener("click", () => {
            if (chosen) localStorage.removeItem(MINE);
            else localStorage.setItem(MINE, JSON.stringify(device));
            button.remove();
            chooser(title, device);
        });
        title.after(button);
    }

    // ------------------------------------------------------------------------------------------------ search

    function fieldItem({ field, href }) {
        const title = element("strong", {}, field.title);
        const link = element("a", { href: site + href }, title, ` ${mip.descriptorOf(field)}`);
        const item = element("li", { "data-field": field.name }, link, ` ${field.role} `, element("code", {}, field.name));
        if (field.description) item.append(element("div", {}, field.description));
        if (mine()) item.append(remarkOn(mine(), field.name));
        return item;
    }

    function passageItem(passage, text) {
        const words = passage.heading ? `${passage.title}: ${passage.heading}` : passage.title;
        return element("li", {}, element("a", { href: site + passage.href }, words), element("div", {}, mipSearch.excerpt(passage, text)));
    }

    function codeItem({ href, code: { value, name, description } }) {
        const title = element("strong", {}, `0x${value.toString(16).padStart(2, "0")}`);
        return element("li", {}, element("a", { href: site + href }, title, " ", name), element("div", {}, description));
    }

    function packetItem(packet) {
        return element("li", {}, openIn("inspector", "Packet: open in the inspector", packet));
    }

    function resultItem(item, text) {
        if (item.packet) return packetItem(item.packet);
        if (item.code) return codeItem(item);
        return item.field ? fieldItem(item) : passageItem(item, text);
    }

    function list(title, items) {
        return [element("h2", {}, title), element("ul", {}, ...items)];
    }

    function search(header) {
        const label = "Search: a descriptor, a name, a symbol, words";
        const input = element("input", {
            type: "search",
            "aria-label": label,
            placeholder: "0x0D13, PPS …",
            autocomplete: "off",
            spellcheck: "false",
        });
        const status = element("p", { role: "status" });
        const results = element("div", {});
        const output = element("div", { class: "mip-search__output", hidden: "" }, status, results);
        const form = element("form", { class: "mip-search", role: "search", "aria-label": "This site" }, input, output);
        let index; // of fields; null if the site has no workbench

        const show = () => {
            const text = input.value.trim();
            output.hidden = !text;
            if (!text || index === undefined) {
                results.replaceChildren();
                status.textContent = text ? "Loading …" : "";
                return;
            }
            const { groups, instead } = mipSearch.search(index, globalThis.mipText ?? [], text);
            results.replaceChildren(
                ...groups.flatMap(({ title, items }) =>
                    list(
                        title,
                        items.map((item) => resultItem(item, text)),
                    ),
                ),
            );
            const total = groups.reduce((sum, { items }) => sum + items.length, 0);
            const asked = instead.map(([word, other]) => `Nothing has “${word}”; searched for “${other}”. `).join("");
            status.textContent = total
                ? `${asked}${total} ${total === 1 ? "result" : "results"} found, the best first.`
                : "Nothing found. Try fewer or other words, the guides, or the field finder.";
        };
        const begin = async () => {
            if (index !== undefined) return;
            await load("search.js");
            const of = await protocol();
            index ??= of && mip.indexOf(of);
            show();
            await load("text.js").catch(() => {}); // a site that is built without hooks.py has none
            if (document.activeElement === input) show();
        };
        const links = () => [...results.querySelectorAll("a")];

        input.addEventListener("focus", () => {
            begin();
            output.hidden = !input.value.trim();
        });
        input.addEventListener("input", () => {
            begin();
            show();
        });
        form.addEventListener("focusout", (event) => {
            if (!form.contains(event.relatedTarget)) output.hidden = true;
        });
        form.addEventListener("submit", async (event) => {
            event.preventDefault();
            await begin();
            links()[0]?.click();
        });
        form.addEventListener("keydown", (event) => {
            const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
            if (event.key === "Escape") {
                input.focus();
                output.hidden = true;
            } else if (step) {
                const stops = [input, ...links()];
                stops[Math.max(0, Math.min(stops.length - 1, stops.indexOf(document.activeElement) + step))].focus();
                event.preventDefault();
            }
        });
        results.addEventListener("click", (event) => {
            if (event.target.closest("a")) output.hidden = true; // the target may be on this page
        });
        document.addEventListener("keydown", (event) => {
            const typing = event.target.closest("input, textarea, select, [contenteditable]");
            if (typing || event.ctrlKey || event.metaKey || event.altKey || (event.key !== "/" && event.key !== "s")) return;
            event.preventDefault();
            input.focus();
        });
        header.append(form);
    }

    /** Unfolds everything for printing. */
    function unfoldOnPaper() {
        let folded = [];
        addEventListener("beforeprint", () => {
            folded = [...document.querySelectorAll("article details:not([open])")];
            for (const box of folded) box.open = true;
        });
        addEventListener("afterprint", () => {
            for (const box of folded) box.open = false;
        });
    }

    function begin() {
        const header = document.querySelector(".md-header__inner");
        if (header) search(header);
        document.querySelectorAll("[data-tool]").forEach(fill);
        linkTools();
        offerPrograms();
        myDevice();
        unfoldOnPaper();
        new ResizeObserver(fit).observe(document.querySelector("article") ?? document.body);
    }

    if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", begin);
    else begin();
})();
