// The codec: value forms, errors and what a stream consists of. Conformance tests the rest.
//
//     FOLDER=generated/javascript node --test unit.test.mjs
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import vm from "node:vm";

const folder = path.resolve(process.env.FOLDER);
const load = (name) => import(pathToFileURL(path.join(folder, name)));
const { default: model } = await load("model.mjs");
const mip = await load("mip/tools.mjs");
const { Packet, Parser, Protocol, buildPacket, checksum, decodeData, encodeData, fromHex, segments, toHex } = mip;
const protocol = new Protocol(model);

/** A protocol with one data field, 0x80,0x01, of these operations. */
function single(operations) {
    const parameters = operations.flatMap((op) => (op.body ?? [op]).map(({ member }) => ({ name: member, optional: !!op.body })));
    const field = { set: 128, descriptor: 1, name: "a.b", role: "data", parameters, operations, min_size: 0, max_size: 99 };
    const acknowledge = model.fields.find((one) => one.name === model.acknowledge);
    const of = new Protocol({ ...model, fields: [acknowledge, field] });
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

const NO_NUMBERS = [true, null, undefined, "", " 12 ", "12", "0x10", [], [1], {}, NaN, -Infinity, 0.5, () => 1, Symbol("x")];

test("only numbers are numbers", () => {
    for (const scalar of ["u8", "s8", "u16", "s32", "u64", "s64", "char"]) {
        const { encode } = single([{ kind: "scalar", member: "x", scalar }]);
        for (const wrong of NO_NUMBERS) {
            if (wrong === "12" && scalar.endsWith("64")) continue; // JSON contains it as a text
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

test("half a character is not a character", () => {
    const { encode } = single([{ kind: "text", member: "x", capacity: 9 }]);
    assert.throws(() => encode({ x: "a\ud800" }), { kind: "range", message: /half of a character \(U\+D800\)/ });
    assert.throws(() => encode({ x: "\udc00" }), { kind: "range" });
});

test("numbers of sets and fields are checked", () => {
    for (const wrong of ["1", null, undefined, NaN, 0, 255, 1.5]) assert.throws(() => buildPacket(protocol, wrong, []), { kind: "set" });
    for (const wrong of ["1", null, undefined, -1, 256, 1.5]) {
        assert.throws(() => buildPacket(protocol, 1, [{ descriptor: wrong, raw: "" }]), { kind: "descriptor" });
    }
    for (const wrong of [12, null, undefined, "1", "0x", "1 2", "12 3", "12--34-", "1g"]) {
        assert.throws(() => fromHex(wrong), { kind: "hex" }, String(wrong));
    }
});

test("what toHex writes is read again", () => {
    const bytes = Uint8Array.of(0, 0x75, 0xff);
    for (const between of ["", " ", ":", "-", "\n"]) assert.deepEqual(fromHex(toHex(bytes, between)), bytes, between);
    assert.deepEqual(fromHex(" 75 65\n"), Uint8Array.of(0x75, 0x65));
});

test("a field that is named needs no descriptor", () => {
    const { name, descriptor } = model.fields.find((one) => one.set && one.set < 128 && one.parameters.length === 0);
    const { set } = protocol.field(name);
    const packet = buildPacket(protocol, set, [{ name, values: {} }]);
    assert.deepEqual(packet.bytes, buildPacket(protocol, set, [{ descriptor, name, values: {} }]).bytes);
    assert.throws(() => buildPacket(protocol, set, [{ descriptor: descriptor ^ 1, name, values: {} }]), { kind: "unknown" });
    assert.throws(() => buildPacket(protocol, set, [{ name: "no.field", values: {} }]), { kind: "unknown" });
});

const FAKES = ["Uint8Array", "ArrayBuffer"].map((name) => ({ [Symbol.toStringTag]: name, length: 3 }));

test("only bytes are bytes", () => {
    const whole = buildPacket(protocol, 1, [{ descriptor: 1, raw: "" }]).bytes;
    const buffer = whole.buffer.slice(whole.byteOffset, whole.byteOffset + whole.length);
    const elsewhere = vm.runInNewContext("new Uint8Array(given)", { given: [...whole] });
    for (const bytes of [whole, buffer, Buffer.from(whole), elsewhere]) {
        assert.deepEqual(new Parser().feed(bytes)[0].bytes, whole);
        assert.equal(toHex(Packet.from(bytes).bytes), toHex(whole));
        assert.equal(toHex(bytes), toHex(whole));
        assert.equal(segments(bytes)[0].kind, "packet");
        assert.deepEqual(checksum(bytes), checksum(whole));
    }
    for (const wrong of ["text", "", null, undefined, 5, [...whole], {}, new DataView(buffer), new Uint16Array(3), ...FAKES]) {
        const parser = new Parser();
        assert.throws(() => parser.feed(wrong), { name: "MipError", kind: "bytes", message: / is not a Uint8Array or an ArrayBuffer$/ });
        assert.equal(parser.feed(whole).length, 1);
        assert.throws(() => Packet.from(wrong), { kind: "bytes" });
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

test("what is decoded says where its bytes are", () => {
    for (const example of model.examples) {
        const bytes = fromHex(example.packet);
        for (const { descriptor, data } of new Packet(bytes).fields()) {
            const field = protocol.choose(bytes[2], descriptor, data);
            if (!field) continue;
            const { values, trailing } = decodeData(protocol, field, data);
            const parts = mip.partsOf(protocol, field, values);
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

test("a model of another form is refused", () => {
    assert.throws(() => new Protocol({ ...model, format: "2.0" }), { kind: "format" });
    assert.throws(() => new Protocol(undefined), { kind: "format" });
});

test("what bytes consist of", () => {
    const whole = buildPacket(protocol, 1, [{ descriptor: 1, raw: "" }]).bytes;
    const damaged = whole.slice();
    damaged[damaged.length - 1] ^= 1;
    const kinds = (...parts) => {
        const found = segments(Uint8Array.from(parts.flatMap((part) => [...part])));
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
