"use strict";
// The conformance driver in JavaScript; driver.py explains it.
//
//     driver.cjs FOLDER      with Mip.js and mip.json; KAITAI_MODULES is the folder above node_modules
//
// A number of JavaScript does not hold the bits of a NaN nor all integers of 64 bits, and its decoder of text takes
// ISO-8859-1 for windows-1252. What is read is compared with the data as far as it goes, and the data are answered.
const fs = require("fs");
const path = require("path");
const readline = require("readline");
const { createRequire } = require("module");

const folder = path.resolve(process.argv[2]);
const installed = createRequire(path.join(process.env.KAITAI_MODULES, "package.json"));
const KaitaiStream = installed("kaitai-struct").KaitaiStream;
const Mip = (() => {
    const module = { exports: {} };
    const text = fs.readFileSync(path.join(folder, "Mip.js"), "utf8");
    new Function("module", "exports", "require", text)(module, module.exports, installed);
    return module.exports.Mip;
})();
const tree = JSON.parse(fs.readFileSync(path.join(folder, "mip.json"), "utf8"));
const homes = tree.types.field.instances.data.type.cases;

const camel = (id) => id.replace(/_([a-z0-9])/g, (_, c) => c.toUpperCase());
const hex = (bytes) => Buffer.from(bytes).toString("hex");

function check(condition, what) {
    if (!condition) throw new Error(`internal: ${what}`);
}

class Walk {
    constructor(data) {
        this.data = Buffer.from(data);
        this.at = 0;
    }

    take(size) {
        this.at += size;
        return this.data.subarray(this.at - size, this.at);
    }

    record(thing, spec, outer) {
        const kind = spec["-kind"];
        if (kind === "bits" || kind === "bytes") return this.bits(thing, spec.seq, kind);
        const scope = { ...outer, ...spec.types };
        const entries = [];
        for (const attribute of spec.seq || []) {
            const value = thing[camel(attribute.id)];
            if (value === undefined || value === null) continue;
            const found = attribute.repeat
                ? value.map((v) => this.value(v, attribute, scope))
                : this.value(value, attribute, scope);
            if (typeof attribute.valid !== "number") entries.push([attribute["-orig-id"] || attribute.id, found]);
        }
        return kind === "vector" ? entries.map(([, v]) => v) : Object.fromEntries(entries);
    }

    bits(thing, seq, kind) {
        let number = 0n;
        let width = 0n;
        for (const part of seq) {
            const size = BigInt(part.type.slice(1));
            const value = BigInt(thing[camel(part.id)]);
            number = kind === "bytes" ? number | (value << width) : (number << size) | value;
            width += size;
        }
        this.take(Number(width / 8n));
        if (kind === "bits") return number;
        return Array.from({ length: Number(width / 8n) }, (_, i) => Number((number >> BigInt(8 * i)) & 255n));
    }

    value(value, attribute, scope) {
        if (scope[attribute.type]) return this.record(value, scope[attribute.type], scope);
        if (attribute.type === "str") {
            const raw = this.take(value.length);
            check(new TextDecoder("latin1").decode(raw) === value, attribute.id);
            return raw.toString("latin1");
        }
        const [kind, size] = [attribute.type[0], Number(attribute.type[1])];
        const raw = this.take(size);
        if (kind === "f") {
            const right = size === 4 ? raw.readFloatBE() : raw.readDoubleBE();
            check(Object.is(value, right), attribute.id);
            return `0x${hex(raw)}`;
        }
        if (size < 8) return value;
        const right = kind === "u" ? raw.readBigUInt64BE() : raw.readBigInt64BE();
        // Number() rounds once; the run-time library adds two halves, and rounds once too. Its negative numbers are
        // too large by 2^32 if the upper bit of the lower half is 0 (kaitai_struct_javascript_runtime#16).
        const [upper, lower] = [raw.readInt32BE(0), raw.readInt32BE(4)];
        const read = kind === "s" && upper < 0 ? -(2 ** 32 * ~upper + ~lower) - 1 : Number(right);
        check(value === read, attribute.id);
        return right;
    }
}

function field(found) {
    if (!found.isSound) return { error: "field_length" };
    const raw = found.content.bytes;
    const answer = { descriptor: found.descriptor };
    let data;
    try {
        data = found.data;
    } catch (error) {
        const words = [
            [KaitaiStream.EOFError, "truncated"],
            [KaitaiStream.ValidationExprError, "count"],
            [KaitaiStream.ValidationNotEqualError, "constant"],
        ];
        const known = words.find(([type]) => error instanceof type);
        if (!known) throw error;
        return { ...answer, error: known[1], raw: hex(raw) };
    }
    const kind = tree.enums.kind[found.kind];
    let spec = kind && tree.types[homes[`kind::${kind.id}`]];
    let name = kind && kind["-orig-id"];
    if (spec && spec["-kind"] === "layouts") {
        spec = tree.types[spec.seq[0].type.cases[data.number]];
        data = data.layout;
        name = spec && spec["-orig-id"];
    }
    if (!spec) {
        check(hex(data) === hex(raw), "bytes");
        return { ...answer, raw: hex(raw) };
    }
    const walk = new Walk(raw);
    const values = walk.record(data, spec, tree.types);
    check(walk.at === data._io.pos, "position");
    return { ...answer, name, role: kind["-role"], values, trailing: raw.length - walk.at };
}

function decode(packet) {
    if (packet.length < 2 || packet.readUInt16BE() !== 0x7565) return { error: "sync" };
    const part = new Mip(new KaitaiStream(packet)).parts[0];
    if (!part.isPacket || packet.length !== part.packet.length + 6) return { error: "length" };
    let [a, b] = [0, 0];
    for (const byte of packet.subarray(0, -2)) {
        a = (a + byte) & 255;
        b = (b + a) & 255;
    }
    if (part.packet.checksum !== ((a << 8) | b)) return { error: "checksum" };
    return { set: part.packet.set, fields: part.packet.payload.fields.map(field) };
}

// JSON with integers of any size, and without characters that could end a line.
const string = (text) =>
    JSON.stringify(text).replace(/[\x7f-\uffff]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);

function json(value) {
    if (typeof value === "bigint") return value.toString();
    if (Array.isArray(value)) return `[${value.map(json).join(",")}]`;
    if (value && typeof value === "object")
        return `{${Object.entries(value).map(([k, v]) => `${string(k)}:${json(v)}`).join(",")}}`;
    return typeof value === "string" ? string(value) : JSON.stringify(value);
}

function answer(line) {
    let request = null;
    try {
        request = JSON.parse(line);
    } catch (error) {
        return { error: "request" };
    }
    const packet = request && request.op === "decode" && request.packet;
    if (typeof packet !== "string" || !/^([0-9a-fA-F]{2})*$/.test(packet)) return { error: "request" };
    return decode(Buffer.from(packet, "hex"));
}

readline.createInterface({ input: process.stdin }).on("line", (line) => process.stdout.write(`${json(answer(line))}\n`));
