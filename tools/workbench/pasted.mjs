// Reads bytes in any form in which people write them.

/**
 * The forms, in the order in which they are looked for: a pattern, and the reader of its text. Without one, the text
 * has digits but no bytes. Decimal numbers, base64 and pairs with dots must begin with the sync bytes, because other
 * things look like them; and a comment in which they are, or that has nothing but bytes, is read. The last two are
 * `LOOSE`: other numbers look like them, too.
 */
const FORMS = [
    [/^[^\n\0]*\0/], // marked below
    [/\/\*(?:(?!\*\/|75\W*0?x?65)[\s\S])*\*\/|\/\/(?!.*75\W*0?x?65|(?:[^\w\n]*(?:0x)?[0-9a-f]{2}){2,}[^\w\n]*$).*/], // a comment
    [/(?<![\w.:/-])(?:19|20)\d\d[-/.]\d\d[-/.]\d\d(?:(?![\w-])|t(?=\d\d:))/], // a date
    [/(?<![\w.:/-])\d\d?[-/.]\d\d?[-/.](?:19|20)?\d\d(?=[ ,]+\d\d?:\d\d)|\b(?:jan|feb|mar|apr|may|ju[nl]|aug|sep|oct|nov|dec) +\d\d?(?= )/],
    [/(?<![\d.:])(?:[01]?\d|2[0-3]):[0-5]\d:[0-5]\d(?:[.,]\d+(?:z|[+-]\d\d:?\d\d(?!\w))?|z|[+-]\d\d:?\d\d(?!\w)|(?=[\])]|[ \t]+\S))/], // a time
    [/\blen(?:gth)?[ =:]*\d+|\b(?:size|count|seq|from|to|id|ts?)=\d+(?![\w.])|\b\d+ bytes?\b/], // a number of bytes
    [/(?<=\w)\[\d+\](?!\[)|^[ \t]*\[\d+\](?=\s*[:=])/], // an index
    [/\bb"(?:[^"\\\n]|\\.)*"|\bb'(?:[^'\\\n]|\\.)*'/, bytesOfLiteral], // b"ue\x01"
    [/(?<!\w)(?=["'][^"'\n]*\\[x0-7])(?:"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')/, bytesOfLiteral], // "ue\1"
    [/(?:\\x[0-9a-f]{2}|\\[0-3][0-7]{2})+/, bytesOfLiteral], // \x75\x65, \165\145
    [
        // 117, 101; on lines of their own, in a list of YAML
        /(?<![\w.])117(?:u8?)?(?=\W+101(?!\d))(?:(?:\s*,\s*|[ \t]+|\s*\n[ \t]*(?:- +)?(?=[-\d, \t]+(?:[\])}]|$)))-?(?:25[0-5]|2[0-4]\d|1?\d?\d)(?:u8?)?(?!\w|\.\d))+/,
        bytesOfDecimals,
    ],
    [/(?<![\w+/])dw[u-x][\w+/-]{8,}={0,2}/, bytesOfBase64],
    [/(?<!\w)(?:0x|&h)[0-9a-f]{1,2}(?:_?[ui]\d+|u?l{0,2})(?!\w)/, bytesOfDigits], // 0x75, 0x75u8, &H75
    [/(?<!\w)(?:0x|&h)[0-9a-f][0-9a-f_]*?(?:_?[ui]\d+|u?l{0,2})(?!\w)/, bytesOfDigits], // 0x7565
    [
        /(?<![\w.])(?:75[._]65(?:[._][0-9a-f]{2})+|(?:[0-9a-f]{2})+h?(?:(?:[ \t]+|, *)(?:[0-9a-f]{2})+h?(?!\w|[.:-]\w))*)(?!\w|\.\d)/,
        bytesOfPairs,
    ], // 75 7565, 75h, 75.65.01
];
const LOOSE = FORMS.length - 2;

const ANY = new RegExp(FORMS.map(([pattern]) => `(${pattern.source})`).join("|"), "gim");

// Before bytes, a name with a colon or "=", or a count in brackets, with what is before it: a time, a process, a count.
// Nothing of it is bytes, unless it has the sync bytes or three bytes in a row.
const LABEL =
    /^(?<digits>[\s[(]*\d)?(?:(?!75\W*65|(?:(?:0x)?[0-9a-f]{2}[\s,]+){3}).)*(?:\b(?=\w*[g-wyz_])\w+[\])]?(?:\s*[[(]\d+[\])])?\s*(?:[:>-]\s+|=\s*)|[[(]\d+[\])]\s+)(?=(?:0x)?[0-9a-f]{2,}h?(?![\w.]))(?=(?<more>[0-9a-fx]{6}|(?:[0-9a-f]{2}\W+){2}[0-9a-f]{2})?)/i;

// A line of a hex dump: an offset, bytes, and the bytes as characters. The last line may be an offset alone.
const DUMP_LINE =
    /^\s*(?<offset>(?<number>(?:0x)?[0-9a-f]{4,16}|[0-9a-f]{8}`[0-9a-f]{8})(?:h?(?<colon>:| =)(?=\s)|(?=\s|$)))(?:(?<gap>\s+)(?<bytes>(?:[0-9a-f]{2,4}[ \t-]+)*[0-9a-f]{2,4})(?<text>\s.*|[|;].*)?)?\s*$/i;

// Bytes in a list, some of which may have a single digit: printf %x, or 1 in [0x75, 1].
const LIST = /(?<![\w.])(?:0x)?[0-9a-f]{1,2}h?(?:[\s,;]+(?:0x)?[0-9a-f]{1,2}h?(?!\w|\.\d))+/gi;

const ESCAPES = { n: 10, r: 13, t: 9, a: 7, b: 8, f: 12, v: 11 };

/** Returns the bytes in a text, and the pieces of text between them, such as words. */
export function bytesOfText(text) {
    const plain = padded(withoutOffsets(text.replace(/[│┊]/g, " ").split(/\r?\n/))).join("\n"); // columns of hexyl
    const bytes = [];
    const ignored = [];
    let at = 0;
    for (const one of ofOneForm(plain)) {
        ignored.push(plain.slice(at, one.at));
        at = one.at + one.text.length;
        for (const byte of one.read(one.text)) bytes.push(byte);
    }
    ignored.push(plain.slice(at));
    return {
        bytes: Uint8Array.from(bytes),
        ignored: ignored
            .flatMap((piece) => piece.split("\n"))
            .map((piece) => piece.replace(/\0/g, "").replace(/^[\s,;:|{}[\]()<>"'-]+|[\s,;:|{}[\]()<>"'-]+$/g, ""))
            .filter(Boolean),
    };
}

/** Returns the bytes of a text, without those of each line that are of a loose form if most are not: "buf", 4096) = 8. */
function ofOneForm(plain) {
    const lines = [[]];
    let from = 0;
    for (const match of plain.matchAll(ANY)) {
        const form = match.indexOf(match[0], 1) - 1;
        const { 0: text, index: at } = match;
        if (plain.slice(from, at).includes("\n")) lines.push([]);
        from = at;
        const loose = form < LOOSE ? 0 : text.split(/[ \t,]+/).length;
        if (FORMS[form][1]) lines.at(-1).push({ at, text, read: FORMS[form][1], loose });
    }
    return lines.flatMap((found) => {
        const sure = found.filter(({ loose }) => !loose);
        return sure.length < found.reduce((sum, { loose }) => sum + loose, 0) ? found : sure;
    });
}

/**
 * The lines without what is around the bytes: what is before them is marked, to be shown as ignored. A number at the
 * beginning is an offset if it begins with zeros, has a colon or 0x before bytes that have none, or is as far from that
 * of the line before or after as the bytes reach. Beside lines of a dump, others have no bytes.
 */
function withoutOffsets(lines) {
    const dumped = lines.map((line) => {
        const { 0: found = "", groups: { digits, more } = {} } = LABEL.exec(line) ?? {};
        const label = digits || more ? found : "";
        const rest = line.slice(label.length);
        const { number, offset, colon, gap, bytes = "", text } = DUMP_LINE.exec(rest)?.groups ?? {};
        const start = Number.parseInt(number?.replace("`", ""), 16); // NaN is not an offset
        const end = start + bytes.replace(/[\s-]/g, "").length / 2;
        const column = !text || /^\s{2}|^\s*[|;]/.test(text);
        const apart =
            bytes && (colon || /^0x(?!7565).{6}/i.test(number)) && (column ? bytes : rest.slice(rest.indexOf(offset) + offset.length));
        return { label, rest, offset, bytes, start, end, apart, zeros: /^0000/.test(number) && (colon || gap?.length > 1) };
    });
    const rows = dumped.map(({ zeros, start, end }, i) => {
        return dumped[i - 1]?.end === start || (end > start && (zeros || dumped[i + 1]?.start === end));
    });
    const beside = rows.some(Boolean);
    return dumped.map(({ label, rest, offset, bytes, apart }, i) => {
        if (rows[i]) return bytes;
        if (apart) return `${label}${offset} \0${apart}`;
        if (beside && !offset) return `${label}${rest}\0`;
        return label ? `${label}\0${rest}` : rest;
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
    const zero = others.filter((i) => /^0x/i.test(items[i])).length * 2 > others.length ? "0x0" : "0";
    const atStart = /[[({"'|]\s*$/.test(before) || (begun && before.trim() === "");
    const atEnd = /^\s*($|[\])}"'|;/,])/.test(behind);
    const known = (i) => (i > others[0] || atStart) && (i < others.at(-1) || atEnd);
    return items.map((item, i) => (single(item) && known(i) ? `${zero}${item}` : item)).join("");
}

function bytesOfDigits(text) {
    const digits = /^(?:0x|&h)([0-9a-f_]+)/i.exec(text)[1].replace(/_/g, "");
    return bytesOfPairs(digits.length % 2 ? `0${digits}` : digits);
}

function bytesOfPairs(text) {
    return Uint8Array.from(text.match(/[0-9a-f]{2}/gi), (pair) => Number.parseInt(pair, 16));
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
