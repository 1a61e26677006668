// What JavaScript makes of streams, in the form that tests/c/fuzz/answers.c defines: answers.mjs GENERATED_FOLDER
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const load = (name) => import(pathToFileURL(path.resolve(process.argv[2], name)));
const { MipError, Parser } = await load("mip/index.mjs");
const { registry } = await load("registry.mjs");
const { nameIn, Protocol } = await load("mip/tools.mjs");
const { default: model } = await load("model.mjs");
const fromHex = (text) => Uint8Array.from(Buffer.from(text, "hex")); // much faster than those of the package
const toHex = (bytes) => Buffer.from(bytes).toString("hex");
const protocol = new Protocol(model); // for names only: what a field is called in one of several sets

function shown({ set, descriptor, data }) {
    const kind = registry.typeOf(set, descriptor, data);
    if (!kind) return String(descriptor);
    const name = nameIn(protocol.field(kind.NAME), set);
    try {
        const { field, trailing } = kind.decodeWithTrailing(data);
        return `${name}=${toHex(field.encode())}+${trailing}`;
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return `${name}!${error.kind}`;
    }
}

function found(packet) {
    const parts = [toHex(packet.bytes)];
    try {
        for (const raw of packet.fields()) parts.push(shown(raw));
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        parts.push("!");
    }
    return parts;
}

function answer(line) {
    const [piece, text] = line.split(" ");
    const stream = fromHex(text);
    const size = Number(piece) || stream.length || 1;
    const parser = new Parser();
    const packets = [];
    for (let at = 0; at < stream.length; at += size) packets.push(...parser.feed(stream.subarray(at, at + size)));
    packets.push(...parser.flush());
    return `${[...packets.flatMap(found), parser.skipped].join(" ")}\n`;
}

const lines = readFileSync(0, "utf8").split("\n").slice(0, -1);
process.stdout.write(lines.map(answer).join(""));
