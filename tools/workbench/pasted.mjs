// Reads bytes in any form in which people write them.

/**
 * The forms, in the order in which they are looked for: a pattern, and the reader of its text. Without one, the text
 * has digits but no bytes. Decimal numbers, base64 and pairs with dots must begin with the sync bytes, because other
 * things look like them; and a comment in which they are, or that has nothing but bytes, is read.
 */
const FORMS = [
    [/\/\*(?:(?!\*\/|75\W*0?x?65)[\s\S])*\*\/|\/\/(?!.*75\W*0?x?65|(?:[^\w\n]*(?:0x)?[0-9a-f]{2}){2,}[^\w\n]*$).*/], // a comment
    [/^[ \t]*(?:0x)?[0-9a-f]{4,8}:(?=\s)/], // an offset
    [/(?<![\w.:-])(?:19|20)\d\d-\d\d-\d\d(?:(?![\w-])|t(?=\d\d:))/], // a date
    [/(?<![\d.:])(?:[01]?\d|2[0-3]):[0-5]\d:[0-5]\d(?:[.,]\d+z?|z|(?=[\])]|[ \t]+\S))/], // a time
    [/\bb"(?:[^"\\\n]|\\.)*"|\bb'(?:[^'\\\n]|\\.)*'/, bytesOfLiteral], // b"ue\x01"
    [/(?<!\w)(?=["'][^"'\n]*\\[x0-7])(?:"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')/, bytesOfLiteral], // "ue\1"
    [/(?:\\x[0-9a-f]{2}|\\[0-3][0-7]{2})+/, bytesOfLiteral], // \x75\x65, \165\145
    [/(?<![\w.])117(?:u8?)?(?=\W+101(?!\d))(?:(?:\s*,\s*|[ \t]+)-?(?:25[0-5]|2[0-4]\d|1?\d?\d)(?:u8?)?(?!\w|\.\d))+/, bytesOfDecimals], // 117, 101
    [/(?<![\w+/])dw[u-x][\w+/-]{8,}={0,2}/, bytesOfBase64],
    [/(?<!\w)(?:0x|&h)[0-9a-f][0-9a-f_]*?(?:_?[ui]\d+|u?l{0,2})(?!\w)/, bytesOfDigits], // 0x75, 0x7565, 0x75u8, &H75
    [/(?<![\w.])(?:75[._]65(?:[._][0-9a-f]{2})+|(?:[0-9a-f]{2})+h?)(?!\w|\.\d)/, bytesOfDigits], // 75, 7565, 75h, 75.65.01
];

const ANY = new RegExp(FORMS.map(([pattern], i) => `(?<form${i}>${pattern.source})`).join("|"), "gim");

// A line of a hex dump: an offset, bytes, and the bytes as characters.
const DUMP_LINE =
    /^(?<offset>\s*(?:0x)?(?<number>[0-9a-f]{4,8})(?::(?=\s)|(?<bare>\s{2,})))\s*(?<bytes>(?:[0-9a-f]{2,4}[ \t]+)*[0-9a-f]{2,4})(?<text>\s{2,}.*|\s*\|.*)?\s*$/i;

// Bytes in a list, some of which may have a single digit: printf %x, or 1 in [0x75, 1].
const LIST = /(?<![\w.])(?:0x)?[0-9a-f]{1,2}h?(?:[\s,;]+(?:0x)?[0-9a-f]{1,2}h?(?!\w|\.\d))+/gi;

const ESCAPES = { n: 10, r: 13, t: 9, a: 7, b: 8, f: 12, v: 11 };

/** Returns the bytes in a text, and the pieces of text between them, such as words. */
export function bytesOfText(text) {
    const plain = padded(withoutOffsets(text.split(/\r?\n/))).join("\n");
    const bytes = [];
    const ignored = [];
    let at = 0;
    for (const match of plain.matchAll(ANY)) {
        const [, read] = FORMS.find((_, i) => match.groups[`form${i}`] !== undefined);
        if (!read) continue;
        ignored.push(plain.slice(at, match.index));
        at = match.index + match[0].length;
        for (const byte of read(match[0])) bytes.push(byte);
    }
    ignored.push(plain.slice(at));
    return {
        bytes: Uint8Array.from(bytes),
        ignored: ignored
            .flatMap((piece) => piece.split("\n"))
            .map((piece) => piece.replace(/^[\s,;:|{}[\]()<>"'-]+|[\s,;:|{}[\]()<>"'-]+$/g, ""))
            .filter(Boolean),
    };
}

/**
 * The lines of hex dumps without what is around the bytes. A number at the beginning is an offset if it begins with
 * zeros, or is as far from that of the line before or after as the bytes reach; one with a colon is left, to be shown
 * as ignored.
 */
function withoutOffsets(lines) {
    const dumped = lines.map((line) => {
        const { number, ...parts } = DUMP_LINE.exec(line)?.groups ?? {};
        const start = Number.parseInt(number, 16); // NaN is not an offset
        return { ...parts, zeros: number?.startsWith("0000"), start, end: start + parts.bytes?.replace(/\s/g, "").length / 2 };
    });
    return lines.map((line, i) => {
        const { offset, bare, bytes, zeros, start, end } = dumped[i];
        if (zeros || dumped[i - 1]?.end === start || dumped[i + 1]?.start === end) return bytes;
        return offset && !bare ? `${offset} ${bytes}` : line;
    });
}

/**
 * Lines whose single digits are bytes of two digits where they stand between bytes, or at an end of the list that is
 * one of the line or in brackets; a list begins with one only if there are bytes before: lines may be numbered.
 */
function padded(lines) {
    let begun = false;
    return lines.map((line) => {
        const found = line.replace(LIST, (list, at) => paddedList(list, line.slice(0, at), line.slice(at + list.length), begun));
        begun ||= /\b(?:0x)?(?:[0-9a-f]{2})+h?\b|\\x/i.test(found);
        return found;
    });
}

function paddedList(list, before, behind, begun) {
    const whole = !before.trim() && !behind.trim();
    const items = list.split(/([\s,;]+)/); // with what is between them
    const single = (item) => /^[0-9a-f]$/i.test(item);
    const others = items.flatMap((item, i) => (i % 2 || single(item) ? [] : [i]));
    if (others.length < 2 && !(begun && whole)) return list;
    const atStart = /[[({"'|]\s*$/.test(before) || (begun && before.trim() === "");
    const atEnd = /^\s*($|[\])}"'|;/,])/.test(behind);
    const known = (i) => (i > others[0] || atStart) && (i < others.at(-1) || atEnd);
    return items.map((item, i) => (single(item) && known(i) ? `0${item}` : item)).join("");
}

function bytesOfDigits(text) {
    const digits = /^(?:0x|&h)?([0-9a-f._]+)/i.exec(text)[1].replace(/[._]/g, "");
    const even = digits.length % 2 ? `0${digits}` : digits;
    return Uint8Array.from(even.match(/../g), (pair) => Number.parseInt(pair, 16));
}

/** Signed ones too: Java prints them. */
function bytesOfDecimals(text) {
    return Uint8Array.from(text.match(/-?\b\d+/g), Number);
}

function bytesOfBase64(text) {
    const letters = text.replace(/=/g, "").replace(/-/g, "+").replace(/_/g, "/");
    return Uint8Array.from(atob(letters.length % 4 === 1 ? letters.slice(0, -1) : letters), (one) => one.charCodeAt(0));
}

function bytesOfLiteral(text) {
    const inner = text.replace(/^b?(["'])(.*)\1$/i, "$2");
    return Uint8Array.from(inner.match(/\\x[0-9a-f]{2}|\\[0-7]{1,3}|\\.|[^\\]/gi), (one) => {
        if (/^\\x./i.test(one)) return Number.parseInt(one.slice(2), 16);
        if (/^\\[0-7]/.test(one)) return Number.parseInt(one.slice(1), 8);
        return ESCAPES[one[1]] ?? one.at(-1).charCodeAt(0);
    });
}
