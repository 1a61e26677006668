// The conformance driver for JavaScript: one JSON request per line in, one JSON answer per line out.
//
//     driver.mjs GENERATED_FOLDER
import path from "node:path";
import readline from "node:readline";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.argv[2]);
const load = (name) => import(pathToFileURL(path.join(folder, name)));
const { default: model } = await load("model.mjs");
const { MipError, Packet, Parser, Protocol, buildPacket, fromHex, nameIn, toHex } = await load("mip/index.mjs");
const protocol = new Protocol(model);

class BadRequest extends Error {}

function check(condition) {
    if (!condition) throw new BadRequest();
}

const bytesOf = (text) => {
    check(typeof text === "string" && /^([0-9a-f]{2})*$/i.test(text));
    return fromHex(text);
};

function parse({ stream, chunk }) {
    const bytes = bytesOf(stream);
    check(Number.isInteger(chunk) && chunk > 0);
    const parser = new Parser(protocol);
    const packets = [];
    for (let at = 0; at < bytes.length; at += chunk) packets.push(...parser.feed(bytes.subarray(at, at + chunk)));
    packets.push(...parser.flush());
    return { packets: packets.map((packet) => toHex(packet.bytes)), skipped: parser.skipped };
}

function decode({ packet }) {
    const found = Packet.from(protocol, bytesOf(packet));
    const fields = found.decode({ floatBits: true }).map(({ descriptor, data, field, values, trailing, error }) => {
        if (descriptor === undefined) return { error: error.kind };
        if (!field) return { descriptor, raw: toHex(data) };
        if (error) return { descriptor, error: error.kind, raw: toHex(data) };
        return { descriptor, name: nameIn(field, found.set), role: field.role, values, trailing };
    });
    return { set: found.set, fields };
}

function encode({ set, fields }) {
    check(Number.isInteger(set) && set > 0 && set < 255 && Array.isArray(fields));
    for (const { descriptor, raw, values } of fields) {
        check(Number.isInteger(descriptor) && descriptor >= 0 && descriptor < 256);
        check(typeof raw === "string" || (typeof values === "object" && values !== null));
    }
    return { packet: toHex(buildPacket(protocol, set, fields).bytes) };
}

function answer(line) {
    try {
        const request = fromJson(line);
        const operation = { parse, decode, encode }[request?.op];
        check(operation);
        return operation(request);
    } catch (error) {
        if (error instanceof MipError) return { error: error.kind };
        if (error instanceof BadRequest || error instanceof SyntaxError) return { error: "request" };
        throw error;
    }
}

// JSON with integers of any size, and without characters that could end a line.
const STRING_OR_NUMBER = /"(?:[^"\\]|\\.)*"|-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?/g;

function fromJson(text) {
    const marked = text.replace(STRING_OR_NUMBER, (token) => (/^-?\d{16,}$/.test(token) ? `{"integer":"${token}"}` : token));
    return JSON.parse(marked, (_, value) => (typeof value?.integer === "string" ? BigInt(value.integer) : value));
}

const string = (text) => JSON.stringify(text).replace(/[\x7f-\uffff]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);

function toJson(value) {
    if (Array.isArray(value)) return `[${value.map(toJson).join(",")}]`;
    if (value && typeof value === "object") {
        return `{${Object.entries(value)
            .map(([key, inner]) => `${string(key)}:${toJson(inner)}`)
            .join(",")}}`;
    }
    return typeof value === "string" ? string(value) : String(value);
}

const lines = readline.createInterface({ input: process.stdin, crlfDelay: Infinity });
for await (const line of lines) process.stdout.write(`${toJson(answer(line))}\n`);
