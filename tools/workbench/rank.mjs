// Ranks documents by words: BM25F (Robertson and Zaragoza, 2009). A word also stands for words that begin with it, for its
// synonyms, for two words written as one, and, if nothing has it, for the nearest known word.

const SATURATION = 2; // how soon more of the same word counts for nothing
const BY_LENGTH = 0.4; // how much a long text counts less
const SYNONYM = 0.7;
const LONGER = 0.7; // a word that begins with the query's

/** Words of questions that do not describe their subject. */
const FILLING = new Set(
    (
        "a about again also always am an and any anyone are as at be between by can cannot correctly could " +
        "couple did do does doesn don during every for from get getting go goes got had has have help how i if in instead " +
        "into is issue issues it its just keep keeps know like make makes me mean means much my need never no not of on one " +
        "only or our please possible problem problems properly put question really same set several should show shows so some " +
        "somehow something sometimes still t than that the their then there they this to trouble try trying use using want " +
        "was way we what when where which while who why will with within without work works would you your"
    ).split(" "),
);

export function wordsOf(text) {
    return text.toLowerCase().match(/\d+\.\d+|[a-z0-9]+/g) ?? [];
}

/** Returns the words of a text, also two with a hyphen as one: time-out is found as timeout. */
function searchedIn(text) {
    return [...wordsOf(text), ...(text.toLowerCase().match(/[a-z]+-[a-z]+/g) ?? []).map((one) => one.replace("-", ""))];
}

/** Returns the words of a text that describe its subject, or all words if none do; those of a symbol such as setToIdle. */
export function telling(text) {
    const words = [...new Set(wordsOf(text.replace(/(?<=[a-z0-9])(?=[A-Z][a-z])/g, " ")))];
    const left = words.filter((word) => !FILLING.has(word));
    return left.length ? left : words;
}

/** Removes the endings in which forms of a word differ. */
export function stem(word) {
    if (word.length < 4 || /[0-9]/.test(word)) return word;
    const plain = word.replace(/(?:ies|ied|y)$/, "i").replace(/(?<!s)s$/, "");
    if (plain.length < 5) return plain;
    const root = plain.replace(/(?:(?<=.{4})(?:li|ness|able)|(?<=.{5})e?ment|at(?:ions?|e[ds]?|ing|ors?)|ions?|ing|ed|es|e)$/, "");
    return root.length < plain.length ? root.replace(/([bdgmnprt])\1$/, "$1").replace(/(?<!s)s$/, "") : root; // stopped, biases
}

/** Counts the letters that are wrong, missing, superfluous, or swapped with the next one. */
function slips(one, other) {
    let before = [];
    let last = Array.from({ length: other.length + 1 }, (_, j) => j);
    for (let i = 1; i <= one.length; i++) {
        const row = [i];
        for (let j = 1; j <= other.length; j++) {
            const same = one[i - 1] === other[j - 1];
            row[j] = Math.min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1));
            const exchanged = i > 1 && j > 1 && one[i - 1] === other[j - 2] && one[i - 2] === other[j - 1];
            if (exchanged) row[j] = Math.min(row[j], before[j - 2] + 1);
        }
        [before, last] = [last, row];
    }
    return last[other.length];
}

export class Ranking {
    #postings = new Map(); // stem -> document -> how much of it, longer texts counted less
    #stems; // sorted
    #words = new Map(); // word -> how often it occurs, to correct others
    #count;
    #synonyms = new Map();
    #phrases; // of each document: lists of stems

    /**
     * `documents` have `texts`, one of each weight, and `phrases`, a title and keywords; `synonyms` are groups of words with the
     * same meaning.
     */
    constructor(documents, weights, synonyms = []) {
        this.#count = documents.length;
        this.#phrases = documents.map(({ phrases }) => phrases.map((phrase) => telling(phrase).map(stem)));
        const words = documents.map(({ texts }) => texts.map(searchedIn));
        const lengths = weights.map((_, i) => words.map((texts) => texts[i].length).filter(Boolean));
        const means = lengths.map((some) => some.reduce((sum, one) => sum + one, 0) / (some.length || 1) || 1);
        for (const [at, texts] of words.entries()) {
            for (const [i, some] of texts.entries()) {
                const amount = weights[i] / (1 - BY_LENGTH + (BY_LENGTH * some.length) / means[i]);
                for (const word of some) {
                    const root = stem(word);
                    if (!this.#postings.has(root)) this.#postings.set(root, new Map());
                    this.#words.set(word, (this.#words.get(word) ?? 0) + 1);
                    const found = this.#postings.get(root);
                    found.set(at, (found.get(at) ?? 0) + amount);
                }
            }
        }
        this.#stems = [...this.#postings.keys()].sort();
        for (const group of synonyms) {
            const roots = group.map(stem);
            for (const root of roots) this.#synonyms.set(root, [...(this.#synonyms.get(root) ?? []), ...roots]);
        }
    }

    /** Returns how rare a stem is in documents. */
    #rarityOf(root) {
        const { size } = this.#postings.get(root);
        return Math.log(1 + (this.#count - size + 0.5) / (size + 0.5));
    }

    /** Returns stems that begin with the letters. */
    #beginning(letters) {
        let [low, high] = [0, this.#stems.length];
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.#stems[middle] < letters) low = middle + 1;
            else high = middle;
        }
        let end = low;
        while (this.#stems[end]?.startsWith(letters)) end++;
        return this.#stems.slice(low, end);
    }

    /**
     * Returns the known word that is most like one that is not known. A short one, of which many words differ in a letter,
     * may only lack one, or have two exchanged.
     */
    #nearest(word) {
        if (word.length < 4 || /[0-9]/.test(word)) return undefined;
        const sorted = (one) => [...one].sort().join("");
        const alike = (one) => one.length > word.length || sorted(one) === sorted(word);
        const near = [...this.#words.keys()].filter(
            (one) => Math.abs(one.length - word.length) < 3 && !/[0-9]/.test(one) && (word.length > 5 || alike(one)),
        );
        const ranked = near.map((one) => [slips(word, one), -this.#words.get(one), one]).filter(([far]) => far <= word.length / 4);
        return ranked.sort((a, b) => a[0] - b[0] || a[1] - b[1])[0]?.[2] ?? this.#beginningOf(word);
    }

    /** Returns the longest known word with which one begins that is not known, at least two thirds of it. */
    #beginningOf(word) {
        const parts = Array.from({ length: Math.floor(word.length / 3) }, (_, cut) => word.slice(0, word.length - cut - 1));
        return parts.find((part) => part.length > 4 && this.#words.has(part));
    }

    /** Returns the stems that a word stands for, with how much each counts. */
    #meant(word) {
        const root = stem(word);
        const meant = new Map();
        const add = (one, weight) => this.#postings.has(one) && meant.set(one, Math.max(meant.get(one) ?? 0, weight));
        add(root, 1);
        for (const one of root.length > 2 ? this.#beginning(root) : []) add(one, LONGER);
        for (const one of this.#synonyms.get(root) ?? []) add(one, SYNONYM);
        return meant;
    }

    /**
     * Returns the parts of a query: stems with weights each; those of two words written as one are `beside` those of the words.
     * `instead` are unknown words, with those that were taken for them.
     */
    #partsOf(words) {
        const [parts, beside, instead] = [[], [], []];
        const pairs = words.map((word, i) => stem(word + (words[i + 1] ?? ""))).slice(0, -1);
        for (const [i, word] of words.entries()) {
            const meant = this.#meant(word);
            const joined = [pairs[i], pairs[i - 1]].filter((pair) => this.#postings.has(pair));
            for (const pair of joined) meant.set(pair, 1);
            beside.push(...joined.map((pair) => new Map([[pair, 0.5]])));
            if (meant.size) {
                parts.push(meant);
                continue;
            }
            const near = this.#nearest(word);
            const cuts = Array.from({ length: Math.max(word.length - 5, 0) }, (_, at) => at + 3);
            const halves = cuts.map((at) => [word.slice(0, at), word.slice(at)]);
            const both = halves.find((two) => two.every((one) => this.#postings.has(stem(one)))) ?? [];
            if (near) parts.push(this.#meant(near));
            else parts.push(...(both.length ? both.map((one) => this.#meant(one)) : [new Map()]));
            if (near || !both.length) instead.push([word, near]);
        }
        return { parts, beside, instead };
    }

    /**
     * Returns how well a document's title, or a keyword of which all words are asked for, is what was asked for, from 0 to 1:
     * how much of it is in the query, and it of the `count` words of the query.
     */
    #shareOf(at, stems, count) {
        const shares = this.#phrases[at].map((phrase, i) => {
            const common = phrase.filter((one) => stems.has(one)).length;
            const isMeant = i === 0 || common === phrase.length;
            return isMeant ? (common / (phrase.length || 1)) * Math.sqrt(Math.min(1, common / count)) : 0;
        });
        return Math.max(...shares);
    }

    /** Returns the documents that have stems: how much of it they have, and how rare it is. The best of a document counts. */
    #having(meant) {
        const found = new Map();
        const own = [...meant].find(([, weight]) => weight === 1)?.[0];
        const most = own === undefined ? Infinity : this.#rarityOf(own); // "dataframe" is not rarer than "data"
        for (const [root, weight] of meant) {
            const rarity = Math.min(this.#rarityOf(root), most);
            for (const [at, amount] of this.#postings.get(root)) {
                const before = found.get(at) ?? { score: 0, rarity: 0 };
                const score = (weight * rarity * amount) / (SATURATION + amount);
                found.set(at, { score: Math.max(score, before.score), rarity: Math.max(rarity, before.rarity) });
            }
        }
        return found;
    }

    /**
     * Returns the documents that have words of a text, the best first: `at`, the score, and `covered`, from 0 to 1, how much of
     * the text they have; and `instead`, pairs of an unknown word and the one that was taken for it, undefined for none.
     */
    search(text) {
        const { parts, beside, instead } = this.#partsOf(telling(text));
        const scores = new Map();
        let whole = 0;
        for (const meant of parts) {
            const having = this.#having(meant);
            whole += Math.max(0, ...[...having.values()].map(({ rarity }) => rarity)) || Math.log(1 + this.#count);
            for (const [at, { score, rarity }] of having) {
                const one = scores.get(at) ?? { at, score: 0, covered: 0 };
                scores.set(at, { at, score: one.score + score, covered: one.covered + rarity });
            }
        }
        for (const meant of beside) for (const [at, { score }] of this.#having(meant)) scores.get(at).score += score;
        const stems = new Set(parts.flatMap((meant) => [...meant].filter(([, weight]) => weight === 1).map(([one]) => one)));
        const found = [...scores.values()].map(({ at, score, covered }) => ({
            at,
            covered: covered / whole,
            score: score * (covered / whole) * (1 + this.#shareOf(at, stems, parts.length)),
        }));
        return { found: found.sort((a, b) => b.score - a.score || a.at - b.at), instead };
    }
}
