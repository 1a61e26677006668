// Finds fields by what people know about them: a descriptor, a name, a symbol, a word.

import { placesOf, sameBytes } from "mip-protocol/tools";
import { bytesOfText } from "./pasted.mjs";
import { Ranking, wordsOf } from "./rank.mjs";
import { pairOf, spacedHex } from "./words.mjs";

// Ranks by what of a field a text is: the smaller, the better.
const EXACT = 0;
const VENDOR = 0.5;
const BEGINNING = 1;
export const WORDS = 2; // it only has the words

/** Weights of a word in names, in keywords, in the title of the set, in parameters and values, in descriptions. */
export const WEIGHTS = [6, 5, 2, 1.5, 1];

const ASKED_CODE =
    /^(?:mip )?(?:error|nack|n?ack code|ack\/nack|return code|code|err|result|reply)(?: code)?\s*[:=#]?\s*(?:0x([0-9a-f]{1,2})|(\d{1,2}))$/i;

/** The bytes of a packet before its payload; a shorter text may be a descriptor. */
const FRAME_HEAD = 4;

/** An index of all fields, for `find`. */
export function indexOf(protocol) {
    const commands = new Map();
    for (const field of protocol.model.fields) for (const name of field.responses ?? []) commands.set(name, field);
    const vendorWords = vendorWordsOf(protocol);
    const entries = protocol.model.fields.map((field) => entryOf(protocol, field, commands, vendorWords));
    const ranking = new Ranking(entries, WEIGHTS, synonymsOf(protocol.model));
    return { protocol, vendorWords, entries, ranking };
}

/** Returns groups of words of the same meaning. */
export function synonymsOf({ synonyms = [], vocabulary }) {
    const plain = (words) => words.filter((word) => !word.includes("_"));
    return [...synonyms, ...vocabulary.map(({ word, instead_of: others }) => plain([word, ...others]))];
}

/**
 * Returns the fields that a text may mean, the best first, at most `limit` of them. A text is a descriptor in any form
 * ("0x0D13", "82 10", "(0x82,0x10)", "0x82", 3399), a name, a symbol in a binding (including values), a vendor's name, or
 * words. `rank` is 0 or less if the text is a descriptor, a name, a symbol or a keyword of the field, and `WORDS` if the field
 * has words of the text.
 */
export function find(index, text, limit = 20) {
    const query = text.trim();
    if (!query) return [];
    const found = exactly(index, query);
    const fields = new Set(found.map(({ field }) => field));
    const [first, ...others] = index.ranking.search(query).found;
    const kept = first ? [first, ...others.filter(({ score }) => score > first.score / 8)] : [];
    const byWords = kept.map(({ at }) => ({ field: index.entries[at].field, rank: WORDS })).filter(({ field }) => !fields.has(field));
    return [...found, ...byWords].slice(0, limit);
}

/** Says which words of a text no field has, and which were taken for them. */
export function missing(index, text) {
    if (exactly(index, text).length) return "";
    const { found, instead } = index.ranking.search(text);
    if (!found.length) return "";
    return instead.map(([word, other]) => `Nothing has “${word}”${other ? `; searched for “${other}”` : ""}.`).join(" ");
}

/** Returns the fields of which a text is a descriptor, a name, a symbol, a keyword, or the beginning of one. */
export function exactly(index, text) {
    const query = text.trim();
    const ranks = new Map();
    for (const { field, rank } of [...byDescriptor(index, query), ...byNumber(index, query)]) ranks.set(field, rank);
    const squashed = squash(query);
    const vendor = /\s/.test(query) ? "" : index.vendorWords(query);
    const part = query.includes("_") ? squashed : ""; // single words are those of too many
    for (const entry of index.entries) {
        const isNamed = entry.vendor.has(vendor) || entry.parts.has(part);
        const rank = Math.min(rankOfSymbol(entry, squashed, /\s/.test(query)), isNamed ? VENDOR : Infinity);
        if (rank < Infinity && !ranks.has(entry.field)) ranks.set(entry.field, rank);
    }
    // Fields found by their set are in the order of the specification.
    const order = ({ field, rank }) => (rank < EXACT - 1 ? [rank] : [rank, entryRank(field), rank < EXACT ? 0 : field.name.length]);
    const found = [...ranks].map(([field, rank]) => ({ field, rank }));
    return found.sort((a, b) => compared(order(a), order(b)));
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

/**
 * Finds what a sentence calls by set and descriptor: "what is 0x82,0x10"; also as one decimal number, as in MSCL's "The
 * command (3399) is not supported".
 */
function byNumber({ protocol }, query) {
    const pairs = [...query.matchAll(/\b0x([0-9a-f]{2})[\s,]*(?:0x)?([0-9a-f]{2})\b/gi)];
    const numbers = [...pairs.map(([, set, one]) => Number(`0x${set}${one}`)), ...(query.match(/(?<![\w.,])\d{4,5}(?![\w.,])/g) ?? [])];
    const fields = numbers.flatMap((number) => protocol.candidates(number >> 8, number & 0xff));
    return fields.map((field) => ({ field, rank: EXACT - 3 }));
}

// ------------------------------------------------------------------------------------------------ names

/** Keeps only letters and digits, so that symbols of all languages look alike. */
function squash(text) {
    return text.toLowerCase().replace(/[^a-z0-9]+/g, "");
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
        const plain = words.map((word) => (word.length > 3 ? word.replace(/s$/, "") : word)).map((word) => usual.get(word) ?? word);
        return plain
            .filter((word) => !beside.has(word))
            .sort()
            .join(" ");
    };
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
        parts: new Set(types.map((one) => squash(one.name))),
        constants: new Set(field.parameters.flatMap((parameter) => constantsOf(protocol, parameter))),
        phrases: [field.title, ...keywords],
        texts: [
            [field.title, name, ...also],
            keywords,
            [...sets, ...titles, ...sections],
            types.map((one) => one.name),
            [field.description, asked?.description, ...types.map((one) => one.description)],
        ].map((some) => [...new Set(wordsOf(some.join(" ")))].join(" ")),
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

/** "command 0x0C,0x28", for lists. */
export function kindOf(field) {
    return `${field.role} ${pairOf(field)}`;
}
