// The tools of the site, and the search at the top of its pages. Everything is loaded from the folder of this script, when
// it is needed, by scripts: pages that are opened from disk may not fetch.
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

    /** The specification, for all tools of this page; null if the site is built without the workbench. */
    let known;
    async function protocol() {
        if (!document.querySelector("link[href$='assets/tools.css']")) return null;
        await load("workbench.js");
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
        const show = async () => {
            const of = await protocol();
            if (of) mip[tool.dataset.tool](tool, of, { ...addresses, start: mip.fragment() });
        };
        await show();
        addEventListener("hashchange", show);
    }

    /** A link to a tool that begins with a packet. */
    function openIn(tool, word, bytes) {
        const href = `${site}tools/${tool}.html#${encodeURIComponent(bytes)}`;
        return element("a", { href, "aria-label": `${word} ${bytes.slice(0, 17)} …` }, word);
    }

    /** From the page of a field to the tools: the builder begins with the field, or with the values of a packet. */
    function linkTools() {
        const field = document.querySelector("article :is(h1, a)[id*='.']")?.id;
        for (const link of document.querySelectorAll("article a[href$='tools/builder.html']")) {
            if (field) link.hash = field;
        }
        for (const code of document.querySelectorAll("article :is(td, pre) > code")) {
            const bytes = code.textContent.trim();
            if (!/^75 65( [0-9A-F]{2}){4,}$/.test(bytes)) continue;
            const links = element("span", { class: "mip-open" }, openIn("inspector", "inspect", bytes));
            const answer = /^75 65 [0-7]. .. .. F1/.test(bytes);
            if (!answer) links.append(" ", openIn("builder", "edit", bytes));
            if (code.parentElement.tagName === "PRE") code.parentElement.after(links);
            else code.after(" ", links);
            code.closest("td")?.classList.add("mip-packet-cell");
        }
    }

    const LONG = 30; // characters of a description, which needs a column of some width

    /** Names in a table that is too wide may break between their words. */
    function breakNames(table) {
        const texts = document.createTreeWalker(table, NodeFilter.SHOW_TEXT);
        const found = [];
        while (texts.nextNode()) found.push(texts.currentNode);
        for (const text of found) {
            const parts = text.data.split(/(?<=[a-z0-9][_.*](?=[a-z0-9]))|(?<=\w::)|(?=\[)/i);
            if (parts.length > 1) text.replaceWith(...parts.flatMap((part, i) => (i ? [element("wbr", {}), part] : [part])));
        }
        const last = Math.max(...[...table.rows].map((row) => row.lastElementChild.textContent.length));
        table.dataset.narrow = last < LONG ? "short" : "long";
    }

    /** What is too wide for the window breaks, and if that is not enough, scrolls by itself and can be reached by the keyboard. */
    function reachable() {
        const boxes = document.querySelectorAll("article :is(.md-typeset__scrollwrap, .mip-scroll, pre > code)");
        const wide = [...boxes].filter((box) => box.scrollWidth > box.clientWidth);
        for (const box of wide) for (const table of box.querySelectorAll("table:not([data-narrow])")) breakNames(table);
        for (const box of boxes) {
            if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
            else box.removeAttribute("tabindex");
        }
    }

    // ------------------------------------------------------------------------------------------------ search

    const FIELDS = 8;
    const PASSAGES = 10;
    const OF_A_PAGE = 3;
    const LEADING = 4;
    const COLLECTIONS = ["errata.html", "examples.html"]; // they repeat what other pages have

    function wordsOf(text) {
        return text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
    }

    /** How much of a heading the words are, from 0 to 1; 0 if it lacks one of them. */
    function shareOf(heading, patterns) {
        const all = wordsOf(heading);
        return patterns.every((pattern) => pattern.test(heading.toLowerCase())) && all.length ? patterns.length / all.length : 0;
    }

    /**
     * The sections of all pages that have all words, the best first: in a heading, in the title, in the text. `leads` is more
     * than 0 for what is named by the words: the pages that have them in the title, the sections whose headings are mostly
     * these words.
     */
    function passages(text, without) {
        const words = [...new Set(wordsOf(text))];
        if (!words.length || words.join("").length < 2) return [];
        const patterns = words.map((word) => new RegExp(`(?<![a-z0-9])${word}`));
        const found = [];
        for (const [url, title, sections] of globalThis.mipText ?? []) {
            if (without.has(url)) continue;
            const ranked = [];
            for (const [anchor, heading, content] of sections) {
                if (without.has(`${url}#${anchor}`)) continue;
                const places = [heading || title, title, content].map((place) => place.toLowerCase());
                const ranks = patterns.map((pattern) => places.findIndex((place) => pattern.test(place)));
                // A heading of the page is enough: the title alone is no reason to show each of its sections.
                if (ranks.includes(-1) || (heading && ranks.every((rank) => rank === 1))) continue;
                const whole = places.findIndex((place) => place.includes(text.toLowerCase()));
                const named = anchor.toLowerCase().endsWith(`.${text.trim().toLowerCase()}`); // an erratum by its id
                const last = named ? -9 : COLLECTIONS.includes(url) ? 9 : 0;
                const rank = ranks.reduce((sum, one) => sum + one, 0) / ranks.length + (whole < 0 ? 0.5 : 0) + last;
                const listed = heading && (last || /^(compare|guides|types)\b/.test(url)); // what these name has pages of its own
                const share = url.startsWith("fields/") || listed ? 0 : shareOf(heading || title, patterns);
                const leads = heading && share < 0.5 ? 0 : share;
                ranked.push({ rank, leads, url, title, anchor, heading, content, patterns });
            }
            found.push(...ranked.sort((a, b) => a.rank - b.rank).slice(0, OF_A_PAGE));
        }
        const leading = found.filter(({ leads }) => leads).sort((a, b) => b.leads - a.leads || a.rank - b.rank);
        const first = new Set(leading.slice(0, LEADING));
        const others = found.filter((one) => !first.has(one)).sort((a, b) => a.rank - b.rank);
        return [...first, ...others.map((one) => ({ ...one, leads: 0 }))].slice(0, PASSAGES);
    }

    /** What stands around the first of the words. */
    function excerpt({ content, patterns }) {
        const lower = content.toLowerCase();
        const at = Math.min(...patterns.map((pattern) => lower.search(pattern)).filter((place) => place >= 0), lower.length);
        const from = at < 60 ? 0 : content.indexOf(" ", at - 60) + 1;
        return `${from ? "… " : ""}${content.slice(from, from + 160)}${from + 160 < content.length ? " …" : ""}`;
    }

    /** Without responses of commands that come before them: they are on the same page. */
    function fieldsOf(found) {
        const names = found.map(({ name }) => name);
        return found.filter(({ command }, i) => !command || !names.slice(0, i).includes(command));
    }

    function addressOf(field) {
        const [set, page] = (field.command ?? field.name).split(".");
        const page_ = field.set ? `fields/${set}/${page}.html` : "packets.html";
        return { page: page_, href: `${site}${page_}#${field.name}` };
    }

    /** What shows a field: its page, or a section of one that shows more. */
    function shownBy(field) {
        const { page } = addressOf(field);
        return page.startsWith("fields/") ? page : `${page}#${field.name}`;
    }

    function fieldItem(field) {
        const title = element("strong", {}, field.title);
        const link = element("a", { href: addressOf(field).href }, title, ` ${mip.descriptorOf(field)}`);
        const item = element("li", { "data-field": field.name }, link, ` ${field.role} `, element("code", {}, field.name));
        if (field.description) item.append(element("div", {}, field.description));
        return item;
    }

    function passageItem(passage) {
        const href = `${site}${passage.url}${passage.anchor ? `#${passage.anchor}` : ""}`;
        const words = passage.heading ? `${passage.title}: ${passage.heading}` : passage.title;
        return element("li", {}, element("a", { href }, words), element("div", {}, excerpt(passage)));
    }

    function count(number, word) {
        return number ? `${number} ${word}${number === 1 ? "" : "s"}` : "";
    }

    function list(title, items) {
        return items.length ? [element("h2", {}, title), element("ul", {}, ...items)] : [];
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
            const ranked = index ? mip.find(index, text, 2 * FIELDS) : [];
            const fields = fieldsOf(ranked.map(({ field }) => field)).slice(0, FIELDS);
            // What has the name that is typed, or is asked for by descriptor, comes before pages.
            const named = ranked.length > 0 && ranked[0].rank <= 0;
            const parts = passages(text, new Set(fields.map(shownBy)));
            const leading = named ? [] : parts.filter(({ leads }) => leads);
            const others = parts.filter((one) => !leading.includes(one));
            const packet = index && mip.packetIn(index, text);
            const inspector = packet ? [element("li", {}, openIn("inspector", "Packet: open in the inspector", packet))] : [];
            results.replaceChildren(
                ...list("Tools", inspector),
                ...list("Pages", leading.map(passageItem)),
                ...list("Fields", fields.map(fieldItem)),
                ...list(leading.length ? "In the text" : "Pages", others.map(passageItem)),
            );
            const counts = [count(inspector.length, "packet"), count(fields.length, "field"), count(parts.length, "passage")].filter(
                Boolean,
            );
            status.textContent = counts.length ? `${counts.join(" and ")} found, the best first.` : "Nothing found.";
        };
        const begin = async () => {
            if (index !== undefined) return;
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

    function begin() {
        const header = document.querySelector(".md-header__inner");
        if (header) search(header);
        document.querySelectorAll("[data-tool]").forEach(fill);
        linkTools();
        new ResizeObserver(reachable).observe(document.querySelector("article") ?? document.body);
    }

    if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", begin);
    else begin();
})();
