// Bytes: hexadecimal text, the checksum, and big-endian numbers.

/** An error of this package; `kind` names it in one word: "truncated", "count", "range", … */
export class MipError extends Error {
    /** `details`: further facts, such as the command that was rejected, and its code. */
    constructor(kind, message, details = {}) {
        super(message);
        this.name = "MipError";
        this.kind = kind;
        Object.assign(this, details);
    }
}

export function checksum(bytes) {
    let a = 0;
    let b = 0;
    for (const byte of bytesOf(bytes)) {
        a = (a + byte) & 0xff;
        b = (b + a) & 0xff;
    }
    return Uint8Array.of(a, b);
}

/** Converts words to camel case: "gnss_1" to "gnss1", but "port_2_3" to "port2_3". */
export function camel(words) {
    return words.replace(/_(\D)|(?<!\d)_(\d)/g, (_, letter, digit) => letter?.toUpperCase() ?? digit);
}

export function toHex(bytes, between = "") {
    return Array.from(bytesOf(bytes), (byte) => byte.toString(16).padStart(2, "0")).join(between);
}

export function fromHex(text) {
    if (typeof text !== "string" || !/^\s*([0-9a-f]{2}(?:[\s:-]+(?=[0-9a-f])|\s*))*$/i.test(text))
        throw new MipError("hex", "the text must consist of pairs of hexadecimal digits");
    return Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));
}

// Returns the name of a typed array, even of another window; undefined for other values. No other value can imitate one.
const typedArray = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(Uint8Array.prototype), Symbol.toStringTag).get;
const bufferSize = Object.getOwnPropertyDescriptor(ArrayBuffer.prototype, "byteLength").get;

/** Returns a Uint8Array or an ArrayBuffer, even of another window, as a Uint8Array; rejects anything else. */
export function bytesOf(value) {
    if (typedArray.call(value) === "Uint8Array") return value;
    try {
        bufferSize.call(value); // a TypeError for all else
    } catch {
        throw new MipError("bytes", `${described(value)} is not a Uint8Array or an ArrayBuffer`);
    }
    return new Uint8Array(value);
}

/** Is a value an array or a typed array? */
export function isList(value) {
    return Array.isArray(value) || typedArray.call(value) !== undefined;
}

export function concatenated(...parts) {
    const whole = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
    let at = 0;
    for (const part of parts) {
        whole.set(part, at);
        at += part.length;
    }
    return whole;
}

export function sameBytes(a, b) {
    return a.length === b.length && a.every((byte, i) => byte === b[i]);
}

/** Describes a value for an error, even if it cannot be converted to a string. */
export function described(value) {
    if (typeof value === "string") return JSON.stringify(value);
    if (Array.isArray(value)) return "an array";
    return typeof value === "object" && value !== null ? "an object" : String(value);
}

/** Are a Number and a BigInt the same number? Above 2^53, a Number does not represent each whole number. */
export const isSame = (a, b) => a <= b && a >= b;

/** Encodes a whole number or a BigInt; rejects anything else. */
export function writeInteger(value, size, signed, what) {
    if (typeof value !== "bigint" && !Number.isInteger(value))
        throw new MipError("range", `${what}: ${described(value)} is not a whole number`);
    let number = BigInt(value);
    const width = BigInt(8 * size);
    const least = signed ? -(1n << (width - 1n)) : 0n;
    if (number < least || number >= least + (1n << width)) {
        throw new MipError("range", `${what}: ${value} does not fit in ${size} byte${size > 1 ? "s" : ""}`);
    }
    const bytes = new Uint8Array(size);
    for (let i = size - 1; i >= 0; i--) {
        bytes[i] = Number(number & 0xffn);
        number >>= 8n;
    }
    return bytes;
}

/**
 * Decodes a float. A NaN with unusual bits becomes the text of its bits, "0x7fe5bf7f", because JavaScript numbers do not
 * preserve them.
 */
export function readFloat(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const number = bytes.length === 4 ? view.getFloat32(0) : view.getFloat64(0);
    return Number.isNaN(number) && !sameBytes(bytes, writeFloat(NaN, bytes.length)) ? floatBits(bytes) : number;
}

/** Returns the bits of a float as text: "0x3e7a63a0". */
export function floatBits(bytes) {
    return `0x${toHex(bytes)}`;
}

/** Encodes a float: a number, or the text of its bits. */
export function writeFloat(value, size, what) {
    const view = new DataView(new ArrayBuffer(size));
    if (typeof value === "string") {
        if (!/^0x[0-9a-f]+$/i.test(value) || value.length !== 2 + 2 * size) {
            throw new MipError("range", `${what}: ${described(value)} is neither a number nor 0x and ${2 * size} hexadecimal digits`);
        }
        const bits = BigInt(value);
        if (size === 4) view.setUint32(0, Number(bits));
        else view.setBigUint64(0, bits);
    } else if (typeof value !== "number") {
        throw new MipError("range", `${what}: ${described(value)} is not a number`);
    } else if (size === 4 && Number.isFinite(value) && !Number.isFinite(Math.fround(value))) {
        throw new MipError("range", `${what}: ${value} does not fit in a float of 4 bytes`);
    } else if (Number.isNaN(value)) {
        view.setUint16(0, size === 4 ? 0x7fc0 : 0x7ff8);
    } else if (size === 4) {
        view.setFloat32(0, value);
    } else {
        view.setFloat64(0, value);
    }
    return new Uint8Array(view.buffer);
}

/** Decodes Latin-1 characters, one per byte. */
export function readText(bytes) {
    return Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
}

export function writeText(text, what) {
    if (typeof text !== "string") throw new MipError("range", `${what}: ${described(text)} is not a text`);
    return Uint8Array.from(text, (character) => {
        const code = character.codePointAt(0);
        if (code > 0xff) {
            const shown = /[\ud800-\udfff]/u.test(character) ? "half of a character" : `"${character}"`;
            throw new MipError("range", `${what}: ${shown} (U+${code.toString(16).toUpperCase()}) is not a character of Latin-1`);
        }
        return code;
    });
}
