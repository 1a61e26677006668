// Finds fields by what people know about them: a descriptor, a name, a symbol, a word.

import { placesOf, sameBytes } from "mip-protocol/tools";
import { bytesOfText } from "./pasted.mjs";
import { pairOf, spacedHex } from "./words.mjs";

// Ranks by where a word is found: the smaller, the better.
const EXACT = 0;
const VENDOR = 0.5;
const BEGINNING = 1;
const TITLE = 2;
const WORDS = 3;
const PARTS = 4;
const TEXT = 5;
const PLACES = [TITLE, WORDS, PARTS, TEXT];

const ASKED_CODE =
    /^(?:mip )?(?:error|nack|n?ack code|ack\/nack|return code|code|err|result|reply)(?: code)?\s*[:=#]?\s*(?:0x([0-9a-f]{1,2})|(\d{1,2}))$/i;

/** The bytes of a packet before its payload; a shorter text may be a descriptor. */
const FRAME_HEAD = 4;

/** An index of all fields, for `find`. */
export function indexOf(protocol) {
    const synonyms = synonymsOf(protocol.model.vocabulary);
    const commands = new Map();
    for (const field of protocol.model.fields) for (const name of field.responses ?? []) commands.set(name, field);
    const vendorWords = vendorWordsOf(protocol);
    const entries = protocol.model.fields.map((field) => entryOf(protocol, field, commands, vendorWords));
    return { protocol, synonyms, vendorWords, entries };
}

/**
 * Returns the fields that a text may mean, the best first, at most `limit` of them. A text is a descriptor in any form
 * ("0x0D13", "82 10", "(0x82,0x10)", "0x82"), a name, a symbol in a binding (including values), a vendor's name, or
 * words. `rank` is 0 or less if the text is a descriptor, a name, a symbol or a keyword of the field.
 */
export function find(index, text, limit = 20) {
    const query = text.trim();
    if (!query) return [];
    const ranks = new Map();
    for (const { field, rank } of byDescriptor(index, query)) ranks.set(field, rank);
    const squashed = squash(query);
    const vendor = /\s/.test(query) ? "" : index.vendorWords(query);
    const words = [...new Set(wordsOf(query))];
    const enumerator = vendor && /[_:]/.test(query) ? vendor.split(" ") : []; // of the vendor, with its field and its value
    for (const entry of index.entries) {
        const rank = Math.min(
            rankOfSymbol(entry, squashed, /\s/.test(query)),
            entry.vendor.has(vendor) ? VENDOR : Infinity,
            rankOfWords(entry, words, index.synonyms),
            rankOfWords(entry, enumerator, index.synonyms),
        );
        if (rank < Infinity && !ranks.has(entry.field)) ranks.set(entry.field, rank);
    }
    // Fields found by their set are in the order of the specification.
    const order = ({ field, rank }) => (rank < EXACT - 1 ? [rank] : [rank, entryRank(field), rank < EXACT ? 0 : field.name.length]);
    const found = [...ranks].map(([field, rank]) => ({ field, rank }));
    return found.sort((a, b) => compared(order(a), order(b))).slice(0, limit);
}

/**
 * Returns the acknowledge code that a text asks for: "error 0x03", "NACK 4", "invalid_parameter"; undefined for other
 * texts.
 */
export function codeIn({ protocol }, text) {
    const [, hex, decimal] = ASKED_CODE.exec(text.trim()) ?? [];
    const number = hex ? Number.parseInt(hex, 16) : Number(decimal ?? Number.NaN);
    return protocol.types.get(protocol.model.ack_code).values.find((one) => one.value === number);
}

/** Replaces words that match nothing with the nearest known ones; undefined if all words are known. */
export function corrected(known, text) {
    let changed = false;
    const right = text.toLowerCase().replace(/[a-z]{4,}/g, (word) => {
        if (known.sorted.some((one) => one.startsWith(stem(word)))) return word;
        const near = known.sorted.filter((one) => Math.abs(one.length - word.length) < 3 && !/[0-9]/.test(one));
        const ranked = near.map((one) => [slips(word, one), -known.counts.get(one), one]).filter(([far]) => far <= word.length / 4);
        if (!ranked.length) return word;
        changed = true;
        return ranked.sort((a, b) => a[0] - b[0] || a[1] - b[1])[0][2];
    });
    return changed ? right : undefined;
}

/** Collects the words of texts and of all fields, for `corrected`. */
export function knownWords({ entries }, texts) {
    const counts = new Map();
    const all = [...entries.flatMap(({ words }) => Object.values(words)), ...texts];
    for (const text of all) for (const word of wordsOf(text)) counts.set(word, (counts.get(word) ?? 0) + 1);
    return { counts, sorted: [...counts.keys()].sort() };
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

/** Returns a text that is a packet, or the beginning of one, for the inspector; undefined for other texts. */
export function packetIn({ protocol }, text) {
    const { bytes } = bytesOfText(text);
    const begun = bytes.length > FRAME_HEAD && sameBytes(bytes.subarray(0, 2), protocol.model.packet.sync);
    return begun ? spacedHex(bytes) : undefined;
}

function compared(a, b) {
    const i = a.findIndex((value, at) => value !== b[at]);
    return i < 0 ? 0 : a[i] - b[i];
}

/** Commands and data before responses. */
function entryRank(field) {
    return (field.role === "response" && field.set ? 1 : 0) + (field.deprecated ? 1 : 0);
}

// ------------------------------------------------------------------------------------------------ descriptors

// Words and punctuation that people write around the numbers.
const AROUND = /\b(?:command|data|desc|descriptor|field|set)\b|[\s,:;/.()[\]{}=-]+/g;

// 0x4, 4h, 04; and 4, which is a descriptor only after a set.
const NUMBER = /^(?:0x([0-9a-f]{1,2})h?|([0-9a-f]{1,2})h|([0-9a-f]{2}))$/;
const DIGIT = /^([0-9a-f])$/;
const TOGETHER = /^(?:0x)?([0-9a-f]{2})(?:0x)?([0-9a-f]{2})h?$/;

/** Parses a set and a descriptor, or one of them; empty for other texts. */
function descriptorsOf(query) {
    const parts = query.toLowerCase().replace(AROUND, " ").trim().split(" ").filter(Boolean);
    const match = (part, ...forms) => forms.map((form) => form.exec(part)).find(Boolean);
    const matches = parts.map((part, i) => match(part, NUMBER, ...(i ? [DIGIT] : parts.length > 1 ? [] : [TOGETHER])));
    if (matches.length > 2 || !matches.every(Boolean)) return [];
    const digits = matches.flatMap((found) => found.slice(1).filter(Boolean));
    return digits.map((one) => Number.parseInt(one, 16));
}

function occursIn(field, number) {
    return placesOf(field).some(({ set }) => set === number);
}

function byDescriptor({ protocol }, query) {
    const [first, descriptor] = descriptorsOf(query);
    if (first === undefined) return [];
    if (descriptor !== undefined) {
        return protocol.candidates(first, descriptor).map((field) => ({ field, rank: EXACT - 3 }));
    }
    return protocol.model.fields
        .filter((field) => occursIn(field, first) || field.descriptor === first)
        .map((field) => ({ field, rank: occursIn(field, first) ? EXACT - 2 : EXACT - 1 }));
}

// ------------------------------------------------------------------------------------------------ names

/** Keeps only letters and digits, so that symbols of all languages look alike. */
function squash(text) {
    return text.toLowerCase().replace(/[^a-z0-9]+/g, "");
}

function wordsOf(text) {
    return text.toLowerCase().match(/[a-z0-9]+/g) ?? [];
}

// The parts of the vendor's symbols that are not words of a name: mip::data_sensor::, MIP_CMD_DESC_, CH_FIELD_,
// extract_mip_.
const BESIDE = ["mip", "data", "command", "cmd", "descriptor", "ch", "field", "vec", "estimated", "insert", "to", "extract", "from"];

/**
 * A function: the words of a symbol in the vocabulary of the specification, in no order, without those beside a name
 * and functions. mip_filter_position_llh_data and DATA_FILTER_POS_LLH are the same then.
 */
function vendorWordsOf({ model, functions }) {
    const others = model.vocabulary.flatMap(({ word, instead_of: instead }) => instead.map((one) => [one, word]));
    const usual = new Map(others);
    const beside = new Set([...BESIDE, ...[...functions.values()].map((one) => one.name)]);
    return (symbol) => {
        const words = wordsOf(symbol.replace(/(?<=[a-z]|[0-9](?=[A-Z][a-z]))(?=[A-Z])/g, "_").replaceAll("_", " "));
        const plain = words.map(stem).map((word) => usual.get(word) ?? word);
        return plain
            .filter((word) => !beside.has(word))
            .sort()
            .join(" ");
    };
}

/** Returns all words of some texts, with a space before and after each. */
function spaced(...texts) {
    return ` ${[...new Set(wordsOf(texts.join(" ")))].join(" ")} `;
}

function entryOf(protocol, field, commands, vendorWords) {
    const name = field.name.split(".")[1];
    const places = placesOf(field);
    const sets = [...new Set([field.name, ...places.map((place) => place.name)].map((one) => one.split(".")[0]))];
    const titles = places.map((place) => protocol.sets.get(place.set)?.title ?? "");
    const also = field.also ?? [];
    const keywords = field.keywords ?? [];
    const symbols = Object.values(field.symbols);
    const short = symbols.map((symbol) => symbol.replace(/^\w+[_-]protocol(\.|::|\/)/, ""));
    const names = [
        field.name,
        ...places.map((place) => place.name),
        name,
        field.title,
        ...also,
        ...also.flatMap((one) => sets.flatMap((set) => [`${set}.${one}`, `mip.${set}.${one}`])),
        ...keywords,
        ...symbols,
        ...short,
    ];
    const types = field.parameters.flatMap((parameter) => partsOf(protocol, parameter));
    const sections = field.sources.map((source) => source.section);
    const asked = commands.get(field.name);
    return {
        field,
        squashed: [...new Set(names.map(squash))],
        vendor: new Set([name, ...also].flatMap((one) => sets.map((set) => vendorWords(`${set}.${one}`)))),
        constants: new Set(field.parameters.flatMap((parameter) => constantsOf(protocol, parameter))),
        words: {
            [TITLE]: spaced(field.title, name, ...also, ...keywords),
            [WORDS]: spaced(...sets, ...titles, field.title, name, ...also, ...keywords, ...sections),
            [PARTS]: spaced(...types.map((one) => one.name)),
            [TEXT]: spaced(field.description, asked?.description ?? "", ...types.map((one) => one.description ?? "")),
        },
    };
}

/** Returns the symbols of a parameter's values and bits, in all languages. */
function constantsOf(protocol, parameter) {
    const types = [parameter.type, ...(parameter.variants ?? []).map((variant) => variant.type)];
    const inner = types.flatMap((name) => {
        const type = protocol.types.get(name);
        if (type?.kind === "struct") return type.parameters.flatMap((one) => constantsOf(protocol, one));
        if (!type?.symbols || name === protocol.model.function_selector) return [];
        const owners = Object.values(type.symbols).flatMap((symbol) => [symbol, symbol.split(/\.|::/).at(-1)]);
        const parts = [...(type.values ?? []), ...(type.bits ?? [])].flatMap((one) => [one.name, one.short ?? one.name]);
        return owners.flatMap((owner) => parts.map((part) => squash(owner + part)));
    });
    return [...inner, ...(parameter.cases ?? []).flatMap((one) => (one.parameter ? constantsOf(protocol, one.parameter) : []))];
}

/** Returns everything with a name in a parameter: itself, values, bits and members. */
function partsOf(protocol, parameter) {
    const types = [parameter.type, ...(parameter.variants ?? []).map((variant) => variant.type)];
    const inner = types.flatMap((name) => {
        const type = protocol.types.get(name);
        if (type?.kind === "struct") return type.parameters.flatMap((one) => partsOf(protocol, one));
        return name === protocol.model.function_selector ? [] : (type?.values ?? type?.bits ?? []);
    });
    const cases = (parameter.cases ?? []).flatMap((one) => (one.parameter ? partsOf(protocol, one.parameter) : []));
    return [parameter, ...inner, ...cases];
}

function rankOfSymbol(entry, query, several) {
    if (query.length < 2) return Infinity;
    if (entry.constants.has(query)) return EXACT;
    let rank = Infinity;
    for (const name of entry.squashed) {
        if (name === query) return EXACT;
        // Finds the longest name that a symbol begins with: mip_base_ping_encode, PpsSourceControl::write.
        if (name.length > 6 && !several && query.startsWith(name)) rank = Math.min(rank, BEGINNING + 1 / name.length);
        else if (name.startsWith(query)) rank = Math.min(rank, BEGINNING + 0.9);
    }
    return rank;
}

/** Returns the best rank at which all words, or their synonyms, are found. */
function rankOfWords(entry, words, synonyms) {
    if (!words.length) return Infinity;
    let [worst, sum] = [0, 0];
    for (const word of words) {
        const wanted = synonyms.get(stem(word)) ?? [word];
        const place = PLACES.find((one) => wanted.some((each) => holds(entry.words[one], each)));
        if (place === undefined) return Infinity;
        worst = Math.max(worst, place);
        sum += place;
    }
    return worst + (sum / words.length) * 0.1;
}

/** Does the text contain the word, or one that begins with it? Short words must match exactly. */
function holds(words, wanted) {
    return words.includes(wanted.length < 3 ? ` ${wanted} ` : ` ${stem(wanted)}`);
}

/** Returns a word in the singular. */
function stem(word) {
    return word.length > 3 ? word.replace(/s$/, "") : word;
}

/** Word -> its synonyms in the specification, including itself. */
function synonymsOf(vocabulary) {
    const synonyms = new Map();
    for (const { word, instead_of: others } of vocabulary) {
        if (word.includes("_")) continue;
        for (const other of others.filter((one) => !one.includes("_"))) {
            synonyms.set(stem(other), [...(synonyms.get(stem(other)) ?? [other]), word]);
            synonyms.set(stem(word), [...(synonyms.get(stem(word)) ?? [word]), other]);
        }
    }
    return synonyms;
}

/** "command 0x0C,0x28", for lists. */
export function kindOf(field) {
    return `${field.role} ${pairOf(field)}`;
}
