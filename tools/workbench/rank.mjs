// Ranks documents by words: BM25F (Robertson and Zaragoza, 2009). A word also stands for words that begin with it, for its
// synonyms, for two words written as one, and, if nothing has it, for the nearest known word.

const SATURATION = 1.2; // how soon more of the same word counts for nothing
const BY_LENGTH = 0.6; // how much a long text counts less
const SYNONYM = 0.6;
const LONGER = 0.7; // a word that begins with the query's

/** Words of questions that do not describe their subject. */
const FILLING = new Set(
    (
        "a about am an and any are as at be by can cannot could did do does doesn don for from get got had has have how i if in into is it " +
        "its just like me mean means much my need no not of on one only or our please set should so still t than that the their then " +
        "there they this to use using want was way we what when where which while who why will with without work works would you your"
    ).split(" "),
);

export function wordsOf(text) {
    return text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
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
    const plain = word.replace(/(?:ies|y)$/, "i").replace(/(?<!s)s$/, "");
    return plain.length > 4 ? plain.replace(/(?:at(?:ions?|e[ds]?|ing|ors?)|ions?|ing|ed|es|e)$/, "") : plain;
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

    /** `documents` are lists of texts, one of each weight; `synonyms` are groups of words with the same meaning. */
    constructor(documents, weights, synonyms = []) {
        this.#count = documents.length;
        const words = documents.map((texts) => texts.map(wordsOf));
        const sums = weights.map((_, i) => words.reduce((sum, texts) => sum + texts[i].length, 0) / (documents.length || 1) || 1);
        for (const [at, texts] of words.entries()) {
            for (const [i, some] of texts.entries()) {
                const amount = weights[i] / (1 - BY_LENGTH + (BY_LENGTH * some.length) / sums[i]);
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

    /** Returns the known word that is most like one that is not known. */
    #nearest(word) {
        if (word.length < 4 || /[0-9]/.test(word)) return undefined;
        const near = [...this.#words.keys()].filter((one) => Math.abs(one.length - word.length) < 3 && !/[0-9]/.test(one));
        const ranked = near.map((one) => [slips(word, one), -this.#words.get(one), one]).filter(([far]) => far <= word.length / 4);
        return ranked.sort((a, b) => a[0] - b[0] || a[1] - b[1])[0]?.[2];
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

    /** Returns the parts of a query: stems with weights each. `instead` are words that were taken for unknown ones. */
    #partsOf(words) {
        const [parts, instead] = [[], []];
        for (let i = 0; i < words.length; i++) {
            const meant = this.#meant(words[i]);
            const joined = words[i + 1] && stem(words[i] + words[i + 1]);
            if (joined && this.#postings.has(joined)) meant.set(joined, 1);
            if (i && this.#postings.has(stem(words[i - 1] + words[i]))) meant.set(stem(words[i - 1] + words[i]), 1);
            if (meant.size) {
                parts.push(meant);
                continue;
            }
            const near = this.#nearest(words[i]);
            const cuts = Array.from({ length: Math.max(words[i].length - 5, 0) }, (_, at) => at + 3);
            const halves = cuts.map((at) => [words[i].slice(0, at), words[i].slice(at)]);
            const both = halves.find((two) => two.every((one) => this.#postings.has(stem(one)))) ?? [];
            if (near) parts.push(this.#meant(near));
            else parts.push(...(both.length ? both.map((one) => this.#meant(one)) : [new Map()]));
            if (near) instead.push([words[i], near]);
        }
        return { parts, instead };
    }

    /**
     * Returns the documents that have words of a text, the best first: `at`, the score, and `covered`, from 0 to 1, how much of
     * the text they have; and the words that were taken `instead` of unknown ones.
     */
    search(text) {
        const { parts, instead } = this.#partsOf(telling(text));
        const scores = new Map();
        let whole = 0;
        for (const meant of parts) {
            const amounts = new Map();
            for (const [root, weight] of meant) {
                for (const [at, amount] of this.#postings.get(root)) amounts.set(at, (amounts.get(at) ?? 0) + weight * amount);
            }
            const rarity = Math.log(1 + (this.#count - amounts.size + 0.5) / (amounts.size + 0.5));
            whole += rarity;
            for (const [at, amount] of amounts) {
                const one = scores.get(at) ?? { at, score: 0, covered: 0 };
                scores.set(at, one);
                one.score += (rarity * amount) / (SATURATION + amount);
                one.covered += rarity;
            }
        }
        const found = [...scores.values()].map(({ at, score, covered }) => ({
            at,
            covered: covered / whole,
            score: score * (covered / whole) ** 2,
        }));
        return { found: found.sort((a, b) => b.score - a.score || a.at - b.at), instead };
    }
}
