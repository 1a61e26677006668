// Results of the site's search: passages of pages, from text.js, and fields, from fields.js of the workbench. It does
// not need a page, so that tests can run it alone.
globalThis.mipSearch = (() => {
    const FIELDS = 8;
    const PASSAGES = 10;
    const OF_A_PAGE = 3;
    const LEADING = 4;
    const WEAK = 4; // a rank of fields: the words are in parameters, values and descriptions
    const COLLECTIONS = /^(errata|examples|types|compare|types\/.*|examples\/.*)\b/; // they repeat the contents of other pages

    /** Words of questions that do not describe their subject. */
    const FILLING = new Set(
        (
            "a about am an and any are as at be by can cannot could did do does doesn for from get got had has have how i if in is it " +
            "its just like me mean means much my need no not of on one only or our please should so still t than that the their then " +
            "there they this to use using want was way we what when where which while who why will with without work works would you your"
        ).split(" "),
    );

    function wordsOf(text) {
        return text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
    }

    /** Returns the words of a text that describe its subject, or all words if none do. */
    function telling(text) {
        const words = [...new Set(wordsOf(text))];
        const left = words.filter((word) => !FILLING.has(word));
        return left.length ? left : words;
    }

    /** Is a text, with many words or with words such as "no" or "why", rather a question than the name of a field? */
    function isSentence(text) {
        return telling(text).length < wordsOf(text).length || wordsOf(text).length > 3;
    }

    /** Returns a pattern for any form of a word and of its synonyms. */
    function patternOf(word, index) {
        const root = (one) => (one.length > 4 ? one.replace(/(?:ing|ed|es|s|e)$/, "") : one.length > 3 ? one.replace(/s$/, "") : one);
        const groups = index?.protocol.model.synonyms ?? [];
        const others = groups.filter((group) => group.some((one) => root(one) === root(word))).flat();
        const all = new Set([word, ...(index?.synonyms.get(word.replace(/s$/, "")) ?? []), ...others].map(root));
        return new RegExp(`(?<![a-z0-9])(?:${[...all].map((one) => (one.length < 3 ? `${one}(?![a-z0-9])` : one)).join("|")})`);
    }

    /** Returns the fraction of a heading that the words cover, from 0 to 1; 0 if it lacks one of them. */
    function shareOf(heading, patterns) {
        const all = telling(heading);
        return patterns.every((pattern) => pattern.test(heading.toLowerCase())) && all.length ? patterns.length / all.length : 0;
    }

    const PLACES = [3, 1.5, 1]; // the weight of a word in the heading, the title of the page, the text

    /**
     * The sections of all pages that have the words, the best first. A rare word counts for more, and a heading for more than
     * a text. If no section has all, those that have most. `leads` is more than 0 for what the words name: the pages that have
     * them in the title, the sections whose headings are mostly these words, or a question.
     */
    function passages(texts, text, index, without) {
        const words = telling(text);
        if (words.join("").length < 2) return [];
        const patterns = words.map((word) => patternOf(word, index));
        const found = [];
        for (const [url, title, sections] of texts) {
            if (without.has(url)) continue;
            for (const [anchor, heading, content] of sections) {
                if (without.has(`${url}#${anchor}`)) continue;
                const places = [heading || title, title, content].map((place) => place.toLowerCase());
                const at = patterns.map((pattern) => places.findIndex((place) => pattern.test(place)));
                if (at.every((one) => one < 0)) continue;
                // A heading of the page is enough: the title alone is no reason to show each of its sections.
                if (heading && at.every((one) => one === 1)) continue;
                found.push({ url, title, anchor, heading, content, patterns, places, at });
            }
        }
        const rarity = words.map((_, i) => Math.log(1 + texts.length / (1 + found.filter(({ at }) => at[i] >= 0).length)));
        const total = rarity.reduce((sum, one) => sum + one, 0) || 1;
        const typed = text.trim().toLowerCase();
        const sentence = isSentence(text);
        for (const one of found) {
            const { url, title, anchor, heading, places, at } = one;
            const sum = (weight) => at.reduce((all, place, i) => all + (place < 0 ? 0 : weight(place) * rarity[i]), 0) / total;
            one.covered = sum(() => 1);
            one.score = sum((place) => PLACES[place]) + (places.some((place) => place.includes(typed)) ? 0.5 : 0);
            if (anchor.includes(".question_")) one.score += 1;
            if (COLLECTIONS.test(url)) one.score -= 9;
            if (anchor.toLowerCase().endsWith(`.${typed}`)) one.score = 99; // an erratum by its id
            const asked = anchor.includes(".question_") && at.every((place) => place === 0) && words.length > 1;
            const listed = heading && !asked && /^(compare|guides|types|errata|examples)\b/.test(url); // these have pages of their own
            const share = url.startsWith("fields/") || listed ? 0 : shareOf(heading || title, patterns);
            one.leads = asked ? Math.max(share, 0.5) + (sentence ? 1 : 0) : heading && share < 0.5 ? 0 : share;
        }
        const whole = found.filter(({ covered }) => covered > 0.999);
        const kept = whole.length ? whole : found.filter(({ covered }) => covered >= 0.5);
        kept.sort((a, b) => b.covered - a.covered || b.score - a.score);
        const counts = new Map();
        const some = kept.filter(({ url }) => counts.set(url, (counts.get(url) ?? 0) + 1).get(url) <= OF_A_PAGE);
        const leading = some.filter(({ leads }) => leads).sort((a, b) => b.leads - a.leads || b.score - a.score);
        const first = new Set(leading.slice(0, LEADING));
        return [...first, ...some.filter((one) => !first.has(one)).map((one) => ({ ...one, leads: 0 }))].slice(0, PASSAGES);
    }

    /** Returns the text around the first of the words. */
    function excerpt({ content, patterns }) {
        const lower = content.toLowerCase();
        const at = Math.min(...patterns.map((pattern) => lower.search(pattern)).filter((place) => place >= 0), lower.length);
        const from = at < 60 || at === lower.length ? 0 : content.indexOf(" ", at - 60) + 1;
        return `${from ? "… " : ""}${content.slice(from, from + 160)}${from + 160 < content.length ? " …" : ""}`;
    }

    /** Returns the address of a field within the site. */
    function addressOf(field) {
        const [set, page] = (field.command ?? field.name).split(".");
        return `${field.set ? `fields/${set}/${page}.html` : "packets.html"}#${field.name}`;
    }

    /** Removes the responses of commands that are also listed, because they are on the same page. */
    function fieldsOf(found) {
        const names = found.map(({ field }) => field.name);
        return found.filter(({ field }, i) => !field.command || !names.slice(0, i).includes(field.command)).slice(0, FIELDS);
    }

    /** Returns the location of a field: its page, or its section if the page has several fields. */
    function shownBy(field) {
        const address = addressOf(field);
        return address.startsWith("fields/") ? address.split("#")[0] : address;
    }

    /**
     * The results for a text, in groups, the best first. `index` is of the fields, null for a site without them,
     * `texts` those of the pages. `instead` is the text that was searched if nothing has the words as they are typed.
     */
    function search(index, texts, text) {
        const found = searchAs(index, texts, text);
        if (found.groups.length || !index) return found;
        index.known ??= mipFields.knownWords(
            index,
            texts.map(([, title, sections]) => `${title} ${sections.flat().join(" ")}`),
        );
        const instead = mipFields.corrected(index.known, text);
        return instead ? { ...searchAs(index, texts, instead), instead } : found;
    }

    /** Removes the names of functions, such as "read" and "save", from a text. */
    function withoutFunctions(index, text) {
        const names = index.protocol.model.functions.map(({ name }) => name);
        const words = text.split(/\s+/);
        return words.filter((word) => !names.includes(word.toLowerCase())).join(" ") || text;
    }

    /** Returns pages that compare the devices in a text, if it names two or more. */
    function comparisonOf(index, text) {
        const short = (name) => name.toLowerCase().replace(/^3dm-/, "");
        const words = (text.match(/[a-z0-9]+(?:[-/][a-z0-9]+)*/gi) ?? []).map(short);
        const named = (index.protocol.model.devices ?? []).filter(({ id, title }) => [id, title].some((one) => words.includes(short(one))));
        if (named.length < 2) return [];
        const [titles, ids] = [named.map(({ title }) => title).join(" and "), named.map(({ id }) => id).join(",")];
        return ["commands", "data", "rates"].map((name) => ({
            title: `${titles}: ${name}`,
            href: `compare/${name}.html?devices=${ids}&differences=`,
            content: "What differs between them.",
            patterns: [],
        }));
    }

    function searchAs(index, texts, text) {
        const packet = index && mipFields.packetIn(index, text);
        const code = index && mipFields.codeIn(index, text);
        let ranked = index ? mipFields.find(index, text, 2 * FIELDS) : [];
        for (const less of index ? [withoutFunctions(index, text), telling(text).join(" ")] : []) {
            const others = less === text ? [] : mipFields.find(index, less, 2 * FIELDS);
            if (others.length && !(ranked[0]?.rank < WEAK)) ranked = others;
        }
        // Fields with the typed name or descriptor come before pages.
        const named = ranked.length > 0 && ranked[0].rank <= 0;
        const fields = fieldsOf(ranked).map(({ field, rank }) => ({ field, rank, href: addressOf(field) }));
        const parts = passages(texts, text, index, new Set(fields.map(({ field }) => shownBy(field))));
        const pages = parts.map((one) => ({ ...one, href: `${one.url}${one.anchor ? `#${one.anchor}` : ""}` }));
        const weak = !named && isSentence(text) && fields.every(({ rank }) => rank >= WEAK); // words of their descriptions
        const questions = weak ? pages.filter(({ anchor }) => anchor.includes(".question_")) : [];
        const leading = named ? [] : [...pages.filter(({ leads }) => leads), ...questions];
        const others = pages.filter((one) => !leading.includes(one));
        const acknowledge = code && `packets.html#${index.protocol.model.acknowledge}.code.${index.protocol.model.ack_code}.${code.name}`;
        const groups = [
            { title: "Comparison", pages: index ? comparisonOf(index, text) : [] },
            { title: "Tools", packets: packet ? [packet] : [] },
            { title: "Acknowledge", codes: code ? [{ ...code, href: acknowledge }] : [] },
            { title: "Pages", pages: [...new Set(leading)] },
            { title: "Fields", fields },
            { title: leading.length ? "In the text" : "Pages", pages: others },
        ];
        return { groups: groups.filter((group) => Object.values(group)[1].length) };
    }

    return { search, excerpt };
})();
