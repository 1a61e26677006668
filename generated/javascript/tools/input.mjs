// Bytes in any form in which people write them.

import { concatenated } from "../mip/bytes.mjs";

// A line of a hex dump: an offset, bytes, and what they look like. What begins with the sync bytes has no offset.
const DUMP_LINE =
    /^\s*(?:0x)?(?:[0-9a-f]{4,8}:\s*|(?!7565)[0-9a-f]{4,8}\s{2,})((?:[0-9a-f]{2,4}[ \t]+)*[0-9a-f]{2,4})(?:\s{2,}.*|\s*\|.*)?\s*$/i;

// What bytes are written as, in the order in which it is looked for; words that begin with digits are not.
const TOKEN = new RegExp(
    [
        /\bb"((?:[^"\\]|\\.)*)"|\bb'((?:[^'\\]|\\.)*)'/, // b"ue\x0c" of Python
        /((?:\\x[0-9a-f]{2})+)/, // \x75\x65
        /\b0x([0-9a-f]+)\b/, // 0x75, 0x7565
        /(?<![\w.])((?:[0-9a-f]{2})+)h?(?!\w|\.\d)/, // 75, 7565, 75h
    ]
        .map((one) => one.source)
        .join("|"),
    "gi",
);

// Bytes in a list, some of which may have a single digit: printf %x, or 1 in [0x75, 1].
const LIST = /(?<![\w.])(?:0x)?[0-9a-f]{1,2}h?(?:[\s,;]+(?:0x)?[0-9a-f]{1,2}h?(?!\w|\.\d))+/gi;

const ESCAPES = { n: 10, r: 13, t: 9, 0: 0, a: 7, b: 8, f: 12, v: 11, "\\": 92, "'": 39, '"': 34 };

/** The bytes of a text, and the pieces of text between them that are no bytes, such as words. */
export function bytesOfText(text) {
    const parts = [];
    const ignored = [];
    for (const line of text.split(/\r?\n/)) {
        const bytes = DUMP_LINE.exec(line)?.[1] ?? padded(line, parts.length > 0);
        let at = 0;
        for (const match of bytes.matchAll(TOKEN)) {
            ignored.push(bytes.slice(at, match.index));
            at = match.index + match[0].length;
            parts.push(bytesOfToken(match));
        }
        ignored.push(bytes.slice(at));
    }
    return {
        bytes: concatenated(...parts),
        ignored: ignored.map((piece) => piece.replace(/^[\s,;:|{}[\]()<>"'-]+|[\s,;:|{}[\]()<>"'-]+$/g, "")).filter(Boolean),
    };
}

/**
 * A line whose single digits are bytes of two digits where they stand between bytes, or at an end of the list that is one
 * of the line or in brackets; a list begins with one only if there are bytes before: lines may be numbered.
 */
function padded(line, begun) {
    return line.replace(LIST, (list, at) => {
        const whole = list.trim() === line.trim();
        const [before, behind] = [line.slice(0, at), line.slice(at + list.length)];
        const items = list.split(/([\s,;]+)/); // with what is between them
        const single = (item) => /^[0-9a-f]$/i.test(item);
        const others = items.flatMap((item, i) => (i % 2 || single(item) ? [] : [i]));
        if (others.length < 2 && !(begun && whole)) return list;
        const atStart = /[[({"'|]\s*$/.test(before) || (begun && before.trim() === "");
        const atEnd = /^\s*($|[\])}"'|;/,])/.test(behind);
        const known = (i) => (i > others[0] || atStart) && (i < others.at(-1) || atEnd);
        return items.map((item, i) => (single(item) && known(i) ? `0${item}` : item)).join("");
    });
}

function bytesOfToken([, double, single, escapes, number, digits]) {
    const literal = double ?? single;
    if (literal !== undefined) return bytesOfLiteral(literal);
    const hex = escapes ? escapes.replace(/\\x/g, "") : (number ?? digits);
    const even = hex.length % 2 ? `0${hex}` : hex;
    return Uint8Array.from(even.match(/../g), (pair) => Number.parseInt(pair, 16));
}

function bytesOfLiteral(text) {
    const found = [];
    for (const [whole, hex, letter] of text.matchAll(/\\x([0-9a-f]{2})|\\([^x])|[^\\]/gis)) {
        if (hex !== undefined) found.push(Number.parseInt(hex, 16));
        else found.push(letter === undefined ? whole.charCodeAt(0) & 0xff : (ESCAPES[letter] ?? letter.charCodeAt(0)));
    }
    return Uint8Array.from(found);
}
