// The modules: value forms, errors and what a stream consists of. Conformance tests the rest.
//
//     FOLDER=generated/javascript node --test unit.test.mjs
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import vm from "node:vm";

const folder = path.resolve(process.env.FOLDER);
const load = (name) => import(pathToFileURL(path.join(folder, name)));
const text = (name) => fs.readFileSync(path.join(folder, name), "utf8");
await load("model.js");
const mip = await load("mip/index.mjs");
const tools = await load("tools/index.mjs");
const { Packet, Parser, Protocol, buildPacket, checksum, decodeData, encodeData, fromHex, segments, toHex } = mip;
const protocol = new Protocol(globalThis.mipModel);

/** A protocol with one data field, 0x80,0x01, of these operations. */
function single(operations) {
    const parameters = operations.flatMap((op) => (op.body ?? [op]).map(({ member }) => ({ name: member, optional: !!op.body })));
    const field = { set: 128, descriptor: 1, name: "a.b", role: "data", parameters, operations, min_size: 0, max_size: 99 };
    const known = globalThis.mipModel;
    const acknowledge = known.fields.find((one) => one.name === known.acknowledge);
    const of = new Protocol({ ...known, fields: [acknowledge, field] });
    return {
        decode: (hex, options) => decodeData(of, field, fromHex(hex), options),
        encode: (values) => toHex(encodeData(of, field, values)),
    };
}

test("floats are numbers, and unusual NaNs keep their bits", () => {
    const { decode, encode } = single([
        { kind: "scalar", member: "x", scalar: "float" },
        { kind: "scalar", member: "y", scalar: "double" },
    ]);
    for (const [hex, values] of [
        ["3f800000" + "c000000000000000", { x: 1, y: -2 }],
        ["80000000" + "7ff8000000000000", { x: -0, y: NaN }],
        ["7fc00000" + "7ff0000000000001", { x: NaN, y: "0x7ff0000000000001" }],
        ["7fe5bf7f" + "fff8000000000000", { x: "0x7fe5bf7f", y: "0xfff8000000000000" }],
        ["7f800000" + "ffefffffffffffff", { x: Infinity, y: -Number.MAX_VALUE }],
    ]) {
        assert.deepEqual(decode(hex).values, values);
        assert.equal(encode(values), hex);
    }
    assert.deepEqual(decode("3f800000c000000000000000", { floatBits: true }).values, {
        x: "0x3f800000",
        y: "0xc000000000000000",
    });
    assert.throws(() => encode({ x: "0x3f80", y: 0 }), { kind: "range" });
    assert.throws(() => encode({ x: null, y: 0 }), { kind: "range" });
});

test("integers of eight bytes are BigInts, and all others numbers", () => {
    const { decode, encode } = single([
        { kind: "scalar", member: "x", scalar: "u64" },
        { kind: "scalar", member: "y", scalar: "s32" },
    ]);
    const values = { x: 0xffffffffffffffffn, y: -2 };
    assert.deepEqual(decode("fffffffffffffffffffffffe").values, values);
    assert.equal(encode(values), "fffffffffffffffffffffffe");
    assert.equal(encode({ x: 5, y: 1n }), "000000000000000500000001");
    for (const wrong of [
        { x: -1, y: 0 },
        { x: 1n << 64n, y: 0 },
        { x: 0, y: 2147483648 },
        { x: 0, y: 0.5 },
        { x: 0, y: "a" },
    ]) {
        assert.throws(() => encode(wrong), { kind: "range" });
    }
});

const NO_NUMBERS = [
    true,
    false,
    null,
    undefined,
    "",
    " ",
    "12",
    " 12 ",
    "0x",
    "0x10",
    [],
    [1],
    {},
    NaN,
    Infinity,
    -Infinity,
    0.5,
    () => 1,
    Symbol("x"),
];

test("only numbers are numbers", () => {
    for (const scalar of ["u8", "s8", "u16", "s32", "u64", "s64", "char"]) {
        const { encode } = single([{ kind: "scalar", member: "x", scalar }]);
        for (const wrong of NO_NUMBERS) {
            assert.throws(() => encode({ x: wrong }), { name: "MipError", kind: "range", message: /^x: .* is not a whole number$/ });
        }
    }
});

test("only numbers, and bits as text, are floats", () => {
    for (const scalar of ["float", "double"]) {
        const { encode } = single([{ kind: "scalar", member: "x", scalar }]);
        for (const wrong of [true, null, undefined, "", " 1 ", "1", "0x", "0x0", "nan", [], [1], {}, 1n]) {
            assert.throws(() => encode({ x: wrong }), { name: "MipError", kind: "range", message: /^x: / });
        }
    }
    const { encode } = single([{ kind: "scalar", member: "x", scalar: "float" }]);
    assert.throws(() => encode({ x: 1e40 }), { kind: "range", message: /does not fit/ });
    assert.equal(encode({ x: -Infinity }), "ff800000");
});

test("a bool is a number or a Boolean", () => {
    const { encode } = single([{ kind: "scalar", member: "x", scalar: "bool" }]);
    assert.equal(encode({ x: true }) + encode({ x: false }) + encode({ x: 2 }), "010002");
    for (const wrong of [null, undefined, "", "true", [], {}, NaN]) assert.throws(() => encode({ x: wrong }), { kind: "range" });
});

test("arrays, structures, unions and texts are nothing else", () => {
    const item = { kind: "scalar", member: "item", scalar: "u8" };
    for (const op of [
        { kind: "array", member: "x", item, capacity: 9 },
        { kind: "bits", member: "x", size: 0 },
        { kind: "text", member: "x", capacity: 9 },
        { kind: "switch", member: "x", tag: "t", cases: [] },
    ]) {
        const { encode } = single([op]);
        for (const wrong of [null, undefined, 0, true, 1n, op.kind === "text" ? [] : ""]) {
            assert.throws(() => encode({ x: wrong }), { name: "MipError", kind: "range", message: /^x: .* is not an? / });
        }
    }
    for (const wrong of [null, undefined, 1, "", []]) assert.throws(() => single([]).encode(wrong), { kind: "range" });
});

test("half a character is no character", () => {
    const { encode } = single([{ kind: "text", member: "x", capacity: 9 }]);
    assert.throws(() => encode({ x: "a\ud800" }), { kind: "range", message: /half of a character \(U\+D800\)/ });
    assert.throws(() => encode({ x: "\udc00" }), { kind: "range" });
});

test("numbers of sets and fields are checked", () => {
    for (const wrong of ["1", null, undefined, NaN, 0, 255, 1.5]) assert.throws(() => buildPacket(protocol, wrong, []), { kind: "set" });
    for (const wrong of ["1", null, undefined, -1, 256, 1.5]) {
        assert.throws(() => buildPacket(protocol, 1, [{ descriptor: wrong, raw: "" }]), { kind: "descriptor" });
    }
    for (const wrong of [12, null, undefined, "1", "0x", " 12"]) assert.throws(() => fromHex(wrong), { kind: "hex" });
});

const FAKES = ["Uint8Array", "ArrayBuffer"].map((name) => ({ [Symbol.toStringTag]: name, length: 3 }));

test("only bytes are bytes", () => {
    const whole = buildPacket(protocol, 1, [{ descriptor: 1, raw: "" }]).bytes;
    const buffer = whole.buffer.slice(whole.byteOffset, whole.byteOffset + whole.length);
    const elsewhere = vm.runInNewContext("new Uint8Array(given)", { given: [...whole] });
    for (const bytes of [whole, buffer, Buffer.from(whole), elsewhere]) {
        assert.deepEqual(new Parser(protocol).feed(bytes)[0].bytes, whole);
        assert.equal(toHex(Packet.from(protocol, bytes).bytes), toHex(whole));
        assert.equal(toHex(bytes), toHex(whole));
        assert.equal(segments(protocol, bytes)[0].kind, "packet");
        assert.deepEqual(checksum(bytes), checksum(whole));
    }
    for (const wrong of [
        "text",
        "",
        null,
        undefined,
        5,
        [...whole],
        {},
        new DataView(buffer),
        new Uint16Array(buffer.slice(0, 6)),
        ...FAKES,
    ]) {
        const parser = new Parser(protocol);
        assert.throws(() => parser.feed(wrong), { name: "MipError", kind: "bytes", message: / is not a Uint8Array or an ArrayBuffer$/ });
        assert.equal(parser.feed(whole).length, 1);
        assert.throws(() => Packet.from(protocol, wrong), { kind: "bytes" });
        for (const take of [segments, (of, bytes) => of.choose(128, 4, bytes)]) {
            assert.throws(() => take(protocol, wrong), { kind: "bytes" });
        }
        for (const take of [toHex, checksum]) assert.throws(() => take(wrong), { kind: "bytes" });
        assert.throws(() => decodeData(protocol, protocol.acknowledge, wrong), { kind: "bytes" });
        if (typeof wrong !== "string" && wrong !== undefined) {
            assert.throws(() => buildPacket(protocol, 1, [{ descriptor: 1, raw: wrong }]), { kind: "bytes" });
        }
    }
});

test("arrays may be typed arrays", () => {
    const floats = single([{ kind: "array", member: "x", item: { kind: "scalar", member: "item", scalar: "float" }, count: 2 }]);
    for (const x of [new Float32Array([1, -2]), new Float64Array([1, -2]), [1, -2]]) assert.equal(floats.encode({ x }), "3f800000c0000000");
    assert.throws(() => floats.encode({ x: new Float32Array(3) }), { kind: "count" });
    for (const x of [new DataView(new ArrayBuffer(8)), new ArrayBuffer(8)]) assert.throws(() => floats.encode({ x }), { kind: "range" });
    assert.equal(single(COUNTED).encode({ xs: Uint8Array.of(7, 8) }), "020708");
    assert.equal(single([{ kind: "bits", member: "b", size: 2 }]).encode({ b: Uint8Array.of(7, 8) }), "0708");
});

test("wrong arguments are errors of one class", () => {
    const field = protocol.model.fields.find((one) => one.operations.length > 0);
    for (const wrong of [undefined, null, 0, 1n, "x", Symbol("x"), {}, [], [null], Object.create(null), () => 1, ...FAKES]) {
        for (const call of [
            () => new Protocol(wrong),
            () => new Protocol({ format: wrong }),
            () => new Protocol({ format: "1.0", packet: wrong }),
            () => protocol.field(wrong),
            () => protocol.type(wrong),
            () => buildPacket(protocol, 1, [wrong]),
            () => buildPacket(protocol, 1, [{ descriptor: 1, name: wrong, values: {} }]),
            () => decodeData(protocol, wrong, new Uint8Array(12)),
            () => encodeData(protocol, wrong, {}),
            () => encodeData(protocol, field, wrong),
            () => single(COUNTED).encode({ n: wrong, xs: [1, 2] }),
        ]) {
            assert.throws(call, { name: "MipError" }, String(call));
        }
        if (!Array.isArray(wrong)) assert.throws(() => buildPacket(protocol, 1, wrong), { kind: "fields" });
    }
});

const COUNTED = [
    { kind: "counter", member: "n", scalar: "u8", array: "xs" },
    { kind: "array", member: "xs", item: { kind: "scalar", member: "item", scalar: "u8" }, counter: "n", capacity: 9 },
];

test("a counter that is left out counts its array", () => {
    const { encode } = single(COUNTED);
    assert.equal(encode({ xs: [7, 8] }), "020708");
    assert.equal(encode({ xs: [] }), "00");
    assert.equal(encode({ n: 1, xs: [7] }), "0107");
    assert.throws(() => encode({ n: 2, xs: [7] }), { kind: "count" });
    assert.throws(() => encode({}), { kind: "missing", message: "n is missing" });
    assert.throws(() => encode({ xs: 5 }), { kind: "range", message: "xs: 5 is not an array" });
    const optional = single([
        { kind: "group", first: 1, last: 2, body: COUNTED },
        { kind: "group", first: 3, last: 3, body: [{ kind: "scalar", member: "z", scalar: "u8" }] },
    ]);
    assert.equal(optional.encode({ xs: [7] }), "0107");
    assert.equal(optional.encode({ xs: [7], z: 1 }), "010701");
    assert.equal(optional.encode({}), "");
    assert.throws(() => optional.encode({ z: 1 }), { kind: "missing", message: "n is missing" });
    for (const field of protocol.model.fields) {
        const data = new Uint8Array(field.max_size);
        for (const { offset, size, value } of field.constants ?? []) data.set(fromHex(value.toString(16).padStart(2 * size, "0")), offset);
        if (field.operations[0]?.kind === "counter") {
            const { values } = decodeData(protocol, field, data);
            const { [field.operations[0].member]: _, ...others } = values;
            assert.equal(toHex(encodeData(protocol, field, others)), toHex(encodeData(protocol, field, values)), field.name);
        }
    }
});

test("errors say where the wrong value is", () => {
    const { encode } = single(COUNTED);
    assert.throws(() => encode({ xs: [1, 2, "a"] }), { kind: "range", message: 'xs[2]: "a" is not a whole number' });
    assert.throws(() => encode({ xs: [1, 256] }), { message: "xs[1]: 256 does not fit in 1 byte" });
    const bits = single([{ kind: "bits", member: "b", size: 2 }]);
    assert.throws(() => bits.encode({ b: [0, -1] }), { message: "b[1]: -1 does not fit in 1 byte" });
    const struct = protocol.model.types.find((one) => one.kind === "struct");
    if (struct) {
        const item = { kind: "struct", member: "item", struct: struct.name };
        const many = single([{ kind: "array", member: "many", item, capacity: 9 }]);
        assert.throws(() => many.encode({ many: [{}] }), { kind: "missing", message: /^many\[0\]\.\w+ is missing$/ });
        assert.throws(() => many.encode({ many: [{ x_y_z: 1 }] }), { kind: "unknown", message: /^many\[0\] has no parameter "x_y_z"$/ });
    }
});

test("text is Latin-1", () => {
    const { decode, encode } = single([{ kind: "text", member: "x", count: 3, capacity: 3 }]);
    assert.deepEqual(decode("8041ff").values, { x: "\x80A\xff" });
    assert.equal(encode({ x: "\x80A\xff" }), "8041ff");
    assert.throws(() => encode({ x: "€uro".slice(0, 3) }), { kind: "range" });
    assert.throws(() => encode({ x: "ab" }), { kind: "count" });
});

test("names of prototypes are no values", () => {
    const { encode } = single([{ kind: "scalar", member: "constructor", scalar: "u8" }]);
    assert.throws(() => encode({}), { kind: "missing" });
});

test("what is decoded says where its bytes are", () => {
    for (const example of globalThis.mipModel.examples) {
        const bytes = fromHex(example.packet);
        for (const { descriptor, data } of new Packet(protocol, bytes).fields()) {
            const field = protocol.choose(bytes[2], descriptor, data);
            if (!field) continue;
            const { values, trailing, parts } = decodeData(protocol, field, data);
            let at = 0;
            for (const part of parts) {
                assert.equal(part.offset, at, example.id);
                at += part.size;
                const held = part.path.reduce((inner, step) => inner?.[step], values);
                if (part.operation.kind !== "constant") assert.deepEqual(held, part.value, example.id);
                assert.ok(mip.parametersAt(protocol, field, part.path).length > 0, example.id);
            }
            assert.equal(at + trailing, data.length, example.id);
        }
    }
});

test("units of elements", () => {
    assert.deepEqual(
        [0, 1, 2].map((i) => mip.unitOf({ units: ["m", "1", "deg"] }, i)),
        ["m", "", "deg"],
    );
    assert.deepEqual(
        [0, 2].map((i) => mip.unitOf({ units: ["m"] }, i)),
        ["m", "m"],
    );
    assert.equal(mip.unitOf({}), "");
});

test("a model of another form is refused", () => {
    assert.throws(() => new Protocol({ ...globalThis.mipModel, format: "2.0" }), { kind: "format" });
    assert.throws(() => new Protocol(undefined), { kind: "format" });
});

test("no packet has the set of shared fields", () => {
    assert.throws(() => buildPacket(protocol, 255, []), { kind: "set" });
});

test("what bytes consist of", () => {
    const whole = buildPacket(protocol, 1, [{ descriptor: 1, raw: "" }]).bytes;
    const damaged = whole.slice();
    damaged[damaged.length - 1] ^= 1;
    const kinds = (...parts) => {
        const found = segments(protocol, Uint8Array.from(parts.flatMap((part) => [...part])));
        assert.deepEqual(
            found.flatMap((part) => [...part.bytes]),
            parts.flatMap((part) => [...part]),
        );
        return found.map((part) => part.kind).join(" ");
    };
    assert.equal(kinds(), "");
    assert.equal(kinds(whole, whole), "packet packet");
    assert.equal(kinds([1, 2, 0x75], whole, [9, 9]), "other packet other");
    assert.equal(kinds(damaged, whole), "damaged packet");
    assert.equal(kinds(whole, whole.slice(0, 5)), "packet incomplete");
    assert.equal(kinds([0x75, 0x65, 0x80, 0xff], whole), "other packet");
    // The false packet claims the real one as its payload, whose fields would fit.
    assert.equal(kinds([0x75, 0x65, 0x80, 10, 10, 1], whole, [0, 0]), "other packet other");
    assert.equal(kinds([0x75, 0x65, 0x80, 2, 9, 1, 0, 0]), "other");
});

// ------------------------------------------------------------------------------------------------ the finder

const { find, indexOf } = await load("tools/find.mjs");
const index = indexOf(protocol);
const first = (text) => find(index, text, 1)[0]?.field;
const pair = (field) => [field.set, field.descriptor].map((n) => n.toString(16).padStart(2, "0"));

test("every descriptor is found in every form", () => {
    const forms = [
        ([s, d]) => `0x${s}${d}`,
        ([s, d]) => `${s} ${d}`.toUpperCase(),
        ([s, d]) => `(0x${s},0x${d})`,
        ([s, d]) => `0x${s}, 0x${d}`,
        ([s, d]) => `${s}:${d}`,
        ([s, d]) => `${s}${d}`.toUpperCase(),
    ];
    protocol.model.fields.forEach((field, i) => {
        if (!field.set) return;
        const wanted = protocol.candidates(field.set, field.descriptor).map((one) => one.name);
        const text = forms[i % forms.length](pair(field));
        assert.deepEqual(
            find(index, text, wanted.length).map((one) => one.field.name),
            wanted,
            text,
        );
    });
    for (const form of forms) {
        const field = protocol.model.fields.at(-1);
        assert.equal(first(form(pair(field))).descriptor, field.descriptor, form(pair(field)));
    }
});

test("a set is found by its number, its own fields first", () => {
    for (const set of protocol.model.sets) {
        const found = find(index, `0x${set.number.toString(16)}`, set.fields.length);
        assert.deepEqual(
            found.map(({ field }) => field.name),
            set.fields,
        );
    }
});

test("every field is found by its name and its symbols", () => {
    for (const field of protocol.model.fields) {
        for (const symbol of [field.name, ...Object.values(field.symbols)]) {
            assert.equal(first(symbol)?.name, field.name, symbol);
            assert.equal(first(`${symbol}_encode`)?.name, field.name, symbol);
        }
    }
});

test("every field is found by its other names", () => {
    for (const field of protocol.model.fields) {
        for (const name of field.also ?? []) {
            const found = find(index, `${field.name.split(".")[0]}.${name}`, 2).map((one) => one.field.name);
            assert.ok(found.includes(field.name), name);
        }
    }
});

test("nothing is found by nothing", () => {
    assert.deepEqual(find(index, "  "), []);
    assert.deepEqual(find(index, "0xAB 0xCD"), []);
    assert.deepEqual(find(index, "xyzzy"), []);
});

// ------------------------------------------------------------------------------------------------ the bundle

test("the bundle has what the modules export", () => {
    const context = vm.createContext({ TextEncoder });
    vm.runInContext(text("model.js"), context);
    vm.runInContext(text("mip.js"), context);
    assert.deepEqual(Object.keys(context.mip).sort(), [...Object.keys(mip), ...Object.keys(tools)].sort());
    context.hex = globalThis.mipModel.examples.map((example) => example.packet);
    const theirs = vm.runInContext(
        "(() => { const p = new mip.Protocol(mipModel); return hex.map((h) => mip.Packet.from(p, mip.fromHex(h)).decode({ floatBits: true })); })()",
        context,
    );
    const plain = (value) => JSON.stringify(value, (_, v) => (typeof v === "bigint" ? `${v}` : v));
    const ours = context.hex.map((hex) => Packet.from(protocol, fromHex(hex)).decode({ floatBits: true }));
    assert.equal(plain(theirs), plain(ours));
});

test("nothing is global but `mip`", () => {
    const context = vm.createContext({ TextEncoder });
    vm.runInContext(text("mip.js"), context);
    assert.deepEqual(Object.keys(context), ["TextEncoder", "mip"]);
    assert.doesNotMatch(text("mip.js"), /^(import|export) /m);
});

// ---------------------------------------------------------------------------------------------------- pasted text

const PING = "756501020201e0c6";

test("bytes are read in the forms in which programs and tools write them", () => {
    for (const text of [
        "7565 0102\n0201  e0c6",
        "7565  0102\n0201  e0c6",
        "0120  75 65 01 02  ue..\n0124  02 01 e0 c6  ....",
        "20001000  75 65 01 02  ue..\n20001004  02 01 e0 c6  ....",
        "0x20001000: 75 65 01 02 02 01 e0 c6",
        "00000000: 7565 0102  ue..\n00000004: 0201 e0c6  ....",
        String.raw`b"ue\001\002\002\001\340\306"`,
        String.raw`b"ue\1\2\2\1\xe0\xc6"`,
        String.raw`"ue\1\2\2\1\340\306"`,
        String.raw`write(3, "ue\1\2\2\1\340\306", 8) = 8`,
        String.raw`don't: 'ue\x01\x02\x02\x01\xe0\xc6'`,
        String.raw`printf \165\145\001\002\002\001\340\306`,
        "{0x75u, 0x65u, 0x01u, 0x02U, 0x02u, 0x01ul, 0xE0u, 0xC6u}",
        "[0x75u8, 0x65, 1, 2, 2, 1, 0xE0, 0xC6]",
        "[0x75_u8, 0x65, 0x01, 0x02, 0x02, 0x01, 0xE0, 0xC6]",
        "0x7565_0102_0201_e0c6",
        "&H75, &H65, &H01, &H02, &H02, &H1, &HE0, &HC6",
        "75_65_01_02_02_01_e0_c6",
        "75.65.01.02.02.01.E0.C6",
        "75-65-01-02-02-01-E0-C6",
        "bytearray([117, 101, 1, 2, 2, 1, 224, 198])",
        "Uint8Array(8) [\n  117, 101,   1,   2,\n    2,   1, 224, 198\n]",
        "$1 = {117, 101, 1, 2, 2, 1, 224, 198}",
        "[117u8, 101, 1, 2, 2, 1, 224, 198]",
        "[117, 101, 1, 2, 2, 1, -32, -58]",
        "[117 101   1   2   2   1 224 198]",
        "dWUBAgIB4MY=",
        '{"data": "dWUBAgIB4MY"}',
        "[10:11:12.345] 75 65 01 02\n[10:11:12.346] 02 01 e0 c6",
        "10:11:12 75 65 01 02\n10:11:13 02 01 e0 c6",
        "2026-01-02T10:11:12.345Z 75 65 01 02\n2026-01-02T10:11:12.346Z 02 01 e0 c6",
        "2026-01-02 10:11:12,345 75 65 01 02\n2026-01-02 10:11:12,346 02 01 e0 c6",
        "0x75, 0x65, // sync 10\n0x01, /* set 20 */ 0x02, 0x02, 0x01, /* 30\n40 */ 0xe0, 0xc6",
        "0x75, // 10\n0x65, // 11\n0x01, 0x02, 0x02, 0x01, 0xe0, 0xc6",
        "// 75 65 01 02 02 01 e0 c6",
        "// 75 65 01 02\n// 02 01 e0 c6",
        String.raw`// "\x75\x65\x01\x02\x02\x01\xe0\xc6"`,
        "/* {0x75, 0x65, 0x01, 0x02, 0x02, 0x01, 0xe0, 0xc6} */",
        "75:65:01:02:02:01:e0:c6",
    ]) {
        assert.equal(toHex(tools.bytesOfText(text).bytes), PING, text);
    }
});

test("a long text is read", () => {
    assert.equal(tools.bytesOfText("75 65 ".repeat(200000)).bytes.length, 400000);
});

test("what is left out of a pasted text is listed", () => {
    for (const [text, ignored] of [
        ["7565 0102\n0201  e0c6", []],
        ["0124: 75 65 01 02", ["0124"]],
        ["0124: 75 65 01 02  ue..\n0128: 02 01 e0 c6  ....", []],
        ["[10:11:12.345] 75 65", ["10:11:12.345"]],
        ["0x75, // sync 10\n0x65", ["// sync 10"]],
        ["117, 101, 256", ["256"]],
        ["117, 102", ["117, 102"]],
        ["hello world", ["hello world"]],
    ]) {
        assert.deepEqual(tools.bytesOfText(text).ignored, ignored, text);
    }
});
