// Results of the site's search: passages of pages, from text.js, and fields, by the index of the workbench. It does
// not need a page, so that tests can run it alone.
globalThis.mipSearch = (() => {
    const MOST = 14;
    const OF_A_PAGE = 2;
    const PAGES_FIRST = 3; // the first results are of different pages
    const LEAST = 5; // results are shown even if they are much worse than the first
    const NAMED = 6; // fields whose names begin with the text
    /** How much pages count that are rarely asked for: those that repeat others, documents. */
    const COUNT = [
        [/^(errata|examples|types|compare|indexes)\b.*#/, 0.3],
        [/^project\//, 0.7],
    ];
    /** Pages that are found by the words of all their sections, too. */
    const STORY = /^(guides|project)\/|^(packets|units)\./;
    const DEPRECATED = 0.3;

    /**
     * Returns what can be found: a field with its page, a section of any other page; each with its texts by weight.
     * `texts` are the pages: address, title, and sections with anchor, heading and text.
     */
    function documentsOf(index, texts) {
        const pages = new Map(texts.map((page) => [page[0], page]));
        const documents = [];
        for (const { field, phrases, texts: own } of index?.entries ?? []) {
            const href = addressOf(field);
            const url = href.split("#")[0];
            const isPage = url.startsWith("fields/");
            if (field.command && isPage) continue; // a response is on the page of its command
            const sections = (isPage && pages.get(url)?.[2]) || [];
            pages.delete(isPage ? url : "");
            const text = `${own.at(-1)} ${sections.map((section) => section.slice(1).join(" ")).join(" ")}`;
            documents.push({
                field,
                href,
                title: field.title,
                less: field.deprecated ? DEPRECATED : 1,
                phrases,
                texts: [...own.slice(0, -1), text],
            });
        }
        const devices = new Map((index?.protocol.model.devices ?? []).map((device) => [`devices/${device.id}.html`, device]));
        for (const [url, title, sections] of pages.values()) {
            const { also = [], model_number: number = "" } = devices.get(url) ?? {};
            const others = [title, ...also, number].join(" "); // the number is on the label: 6254, 6254-4220
            const whole = sections.map((section) => section.slice(1).join(" ")).join(" "); // words that no section has alone
            for (const [anchor, heading, content] of sections) {
                const href = anchor ? `${url}#${anchor}` : url;
                const less = COUNT.find(([pages]) => pages.test(href))?.[1] ?? 1;
                const own = heading ? [heading, "", title] : [others, "", title];
                const words = !heading && STORY.test(url) ? whole : content;
                documents.push({ url, href, title, heading, content, less, phrases: [heading || title], texts: [...own, "", words] });
            }
        }
        return documents;
    }

    /** Without the workbench: the documents that have most of the words. */
    function plainly(documents, text) {
        const words = text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
        const found = documents.map(({ texts }, at) => {
            const [title, whole] = [texts.slice(0, 3), texts].map((some) => some.join(" ").toLowerCase());
            return { at, score: words.reduce((sum, word) => sum + whole.includes(word) + title.includes(word), 0) };
        });
        return { found: found.filter(({ score }) => score).sort((a, b) => b.score - a.score) };
    }

    /** The documents that have the words, the best first, at most `OF_A_PAGE` of a page. */
    function ranked(documents, ranking, text) {
        const { found } = ranking ? ranking.search(text) : plainly(documents, text);
        const words = ranking ? mip.telling(text).map(mip.stem) : [];
        const isSentence = ranking && (words.length > 3 || words.length < mip.wordsOf(text).length);
        for (const one of found) {
            const { href, less } = documents[one.at];
            one.score *= less;
            if (isSentence && href.includes(".question_")) one.score *= 1.5;
        }
        found.sort((a, b) => b.score - a.score || a.at - b.at);
        const counts = new Map();
        const spread = found.flatMap(({ at, score }) => {
            const { url, href } = documents[at];
            const count = counts.get(url ?? href) ?? 0;
            counts.set(url ?? href, count + 1);
            return count < OF_A_PAGE ? [{ at, score, count }] : [];
        });
        const first = spread.filter(({ count }) => !count).slice(0, PAGES_FIRST);
        const shown = [...first, ...spread.filter((one) => !first.includes(one))];
        return shown.filter(({ score }, i) => i < LEAST || score > found[0].score / 10).map(({ at }) => documents[at]);
    }

    /** Returns the text around the first of the words. */
    function excerpt({ content }, text) {
        const lower = content.toLowerCase();
        const words = (globalThis.mip ? mip.telling(text).map(mip.stem) : [text.toLowerCase()]).filter(Boolean);
        const places = words.map((word) => lower.indexOf(word)).filter((place) => place >= 0);
        const at = Math.min(...places, lower.length);
        const from = at < 60 || at === lower.length ? 0 : content.indexOf(" ", at - 60) + 1;
        const [shown] = /^.{0,160}(?!\S)/s.exec(content.slice(from)) ?? [content.slice(from, from + 160)]; // ends with a word
        return `${from ? "… " : ""}${shown}${from + shown.length < content.length ? " …" : ""}`;
    }

    /** Returns the address of a field within the site. */
    function addressOf(field) {
        const [set, page] = (field.command ?? field.name).split(".");
        return `${field.set ? `fields/${set}/${page}.html` : "packets.html"}#${field.name}`;
    }

    /** Returns the devices that a text names, and its other words. */
    function devicesIn(index, text) {
        const short = (name) => name.toLowerCase().replace(/^3dm-/, "");
        const words = text.match(/[a-z0-9]+(?:[-/][a-z0-9]+)*/gi) ?? [];
        const devices = index?.protocol.model.devices ?? [];
        const means = (word, name) => short(name) === short(word) && (/\d/.test(short(word)) || word.includes("-"));
        const named = (word) => devices.find(({ id, title }) => [id, title].some((one) => means(word, one)));
        return [[...new Set(words.map(named).filter(Boolean))], words.filter((word) => !named(word)).join(" ")];
    }

    /** Returns pages that compare devices, if there are two or more. */
    function comparisonOf(named) {
        if (named.length < 2) return [];
        const [titles, ids] = [named.map(({ title }) => title).join(" and "), named.map(({ id }) => id).join(",")];
        return ["commands", "data", "rates"].map((name) => ({
            title: `${titles}: ${name}`,
            href: `compare/${name}.html?devices=${ids}&differences=`,
            content: "Differences between them.",
        }));
    }

    let made = []; // the documents and their ranking, of the last texts

    function rankingOf(index, texts) {
        if (made[0] !== index || made[1] !== texts) {
            const documents = documentsOf(index, texts);
            const ranking = index && new mip.Ranking(documents, mip.WEIGHTS, mip.synonymsOf(index.protocol.model));
            made = [index, texts, documents, ranking];
        }
        return made.slice(2);
    }

    /**
     * The results for a text, in groups of `items`, the best first: packets, codes, fields, and sections of pages, each
     * with `href`. `index` is of the fields, null for a site without them, `texts` those of the pages. `instead` are pairs of
     * an unknown word and what was searched for: the word that was taken for it, or the others of the text.
     */
    function search(index, texts, text) {
        const [documents, ranking] = rankingOf(index, texts);
        const unknown = ranking?.search(text).instead ?? [];
        const without = (word) => text.split(/\s+/).filter((one) => !mip.wordsOf(one).includes(word));
        const instead = unknown.map(([word, other]) => [word, other ?? without(word).join(" ")]);
        for (const [word, other] of unknown) if (other) text = text.toLowerCase().replace(word, other);
        const packet = index && mip.packetIn(index, text);
        const code = index && mip.codeIn(index, text);
        const named = index ? mip.exactly(index, text).map(({ field }) => ({ field, href: addressOf(field) })) : [];
        const commands = named.map(({ field }) => field.name);
        const fields = named.filter(({ field }) => !commands.includes(field.command)).slice(0, NAMED);
        const shown = new Set(fields.map(({ href }) => href));
        const [devices, subject] = devicesIn(index, text);
        const about = devices.length === 1 && ranking?.search(subject).found.length;
        const results = ranked(documents, ranking, about ? subject : text);
        const own = about ? documents.find(({ href }) => href === `devices/${devices[0].id}.html`) : undefined;
        // A device in a question says where, not what: its page is the third result.
        if (own) results.splice(2, results.length, own, ...results.slice(2).filter((one) => one !== own));
        const others = results.filter(({ href }) => !shown.has(href)).slice(0, MOST);
        const acknowledge = code && `packets.html#${index.protocol.model.acknowledge}.code.${index.protocol.model.ack_code}.${code.name}`;
        const groups = [
            { title: "Comparison", items: comparisonOf(devices) },
            { title: "Tools", items: packet ? [{ packet }] : [] },
            { title: "Acknowledge", items: code ? [{ code, href: acknowledge }] : [] },
            { title: "Fields", items: fields },
            { title: fields.length ? "Other results" : "Results", items: others },
        ];
        return { groups: groups.filter(({ items }) => items.length), instead };
    }

    return { search, excerpt };
})();
