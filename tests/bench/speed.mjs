// The speed of the JavaScript package relative to hand-written loops: `node speed.mjs FOLDER STREAM` prints ratios as JSON.
//
// The loops check the same checksums and read the same fields into objects, with a DataView. All run in turn in one
// process; the median of the ratios counts.

import { readFileSync } from "node:fs";

const [folder, path] = process.argv.slice(2);
const { Parser } = await import(`${folder}/mip/index.mjs`);
const { registry } = await import(`${folder}/registry.mjs`);
const { ScaledAccel, ScaledGyro } = await import(`${folder}/sensor.mjs`);
const { EulerAngles } = await import(`${folder}/filter_data.mjs`);

const ROUNDS = 15;
const PIECE = 4096;
const bytes = new Uint8Array(readFileSync(path));
const pieces = Array.from({ length: Math.ceil(bytes.length / PIECE) }, (_, i) => bytes.subarray(i * PIECE, (i + 1) * PIECE));

/** Adds the packets in `bytes` to `found`; returns where an incomplete one begins. */
function packetsIn(bytes, found) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    let at = 0;
    while (at + 6 <= bytes.length) {
        const end = at + bytes[at + 3] + 4;
        const begins = bytes[at] === 0x75 && bytes[at + 1] === 0x65;
        if (begins && end + 2 > bytes.length) break;
        let a = 0;
        let b = 0;
        for (let i = at; begins && i < end; i++) {
            a += bytes[i];
            b += a;
        }
        const whole = begins && bytes[end] === (a & 0xff) && bytes[end + 1] === (b & 0xff);
        if (whole) found.push({ view, at });
        at = whole ? end + 2 : at + 1;
    }
    return at;
}

/** Returns the sum of what `use` returns for each packet. */
function parsedByHand(pieces, use) {
    let rest = new Uint8Array(0);
    let sum = 0;
    for (const piece of pieces) {
        const joined = new Uint8Array(rest.length + piece.length);
        joined.set(rest);
        joined.set(piece, rest.length);
        const found = [];
        rest = joined.subarray(packetsIn(joined, found));
        sum += total(found, use);
    }
    return sum;
}

function parsed(pieces, use) {
    const parser = new Parser();
    let sum = 0;
    for (const piece of pieces) sum += total(parser.feed(piece), use);
    return sum;
}

function total(all, use) {
    let sum = 0;
    for (const one of all) sum += use(one);
    return sum;
}

/** Returns the offset of a field's data; 0 if the packet has no such field. */
function place(view, at, set, descriptor) {
    if (view.getUint8(at + 2) !== set) return 0;
    const end = at + 4 + view.getUint8(at + 3);
    for (let field = at + 4; field < end; field += view.getUint8(field)) {
        if (view.getUint8(field) < 2 || field + view.getUint8(field) > end) throw new Error("length");
        if (view.getUint8(field + 1) === descriptor) return field + 2;
    }
    return 0;
}

const vector = (view, at) => [view.getFloat32(at), view.getFloat32(at + 4), view.getFloat32(at + 8)];
const angles = (set, view, at) => ({ set, roll: view.getFloat32(at), pitch: view.getFloat32(at + 4), yaw: view.getFloat32(at + 8) });
const euler = (set, view, at) => ({
    set,
    roll: view.getFloat32(at),
    pitch: view.getFloat32(at + 4),
    yaw: view.getFloat32(at + 8),
    validFlags: view.getUint16(at + 12),
});

const kept = new Array(64); // what is found, so that no optimizer drops it
let number = 0;

function keep(field) {
    if (!field) return 0;
    kept[number++ & 63] = field;
    return 1;
}

function foundByHand({ view, at }) {
    const accel = place(view, at, 0x80, 0x04);
    const gyro = place(view, at, 0x80, 0x05);
    const attitude = place(view, at, 0x82, 0x05);
    return (
        keep(accel && { scaledAccel: vector(view, accel) }) +
        keep(gyro && { scaledGyro: vector(view, gyro) }) +
        keep(attitude && euler(0x82, view, attitude))
    );
}

const found = (packet) => keep(packet.find(ScaledAccel)) + keep(packet.find(ScaledGyro)) + keep(packet.find(EulerAngles));

function decodedByHand({ view, at }) {
    const set = view.getUint8(at + 2);
    const end = at + 4 + view.getUint8(at + 3);
    const fields = [];
    for (let field = at + 4; field < end; field += view.getUint8(field)) {
        if (view.getUint8(field) < 2 || field + view.getUint8(field) > end) throw new Error("length");
        const data = field + 2;
        const descriptor = view.getUint8(field + 1);
        if (descriptor === 0xd5 || descriptor === 0xd6) fields.push({ set, nanoseconds: view.getBigUint64(data) });
        else if (set === 0x80 && descriptor === 0x04) fields.push({ set, scaledAccel: vector(view, data) });
        else if (set === 0x80 && descriptor === 0x05) fields.push({ set, scaledGyro: vector(view, data) });
        else if (set === 0x80 && descriptor === 0x06) fields.push({ set, scaledMag: vector(view, data) });
        else if (set === 0x80 && descriptor === 0x0c) fields.push(angles(set, view, data));
        else if (set === 0x82 && descriptor === 0x05) fields.push(euler(set, view, data));
        else throw new Error(`${set} ${descriptor}`);
    }
    return keep(fields);
}

const decoded = (packet) => keep(registry.decode(packet));
const setByHand = ({ view, at }) => view.getUint8(at + 2);
const byHand = [];
packetsIn(bytes, byHand);
const packets = new Parser().feed(bytes);

/** Name -> what a program does by hand, and with the package; both return the same number. */
const WORK = {
    "Parser, all bytes at once": [() => parsedByHand([bytes], setByHand), () => parsed([bytes], ({ set }) => set)],
    "Parser, pieces of 4 KiB": [() => parsedByHand(pieces, setByHand), () => parsed(pieces, ({ set }) => set)],
    "`find` of three types": [() => total(byHand, foundByHand), () => total(packets, found)],
    "`registry.decode`": [() => total(byHand, decodedByHand), () => total(packets, decoded)],
    "Parser and `registry.decode`": [() => parsedByHand(pieces, decodedByHand), () => parsed(pieces, decoded)],
};

const ratios = {};
for (const [name, pair] of Object.entries(WORK)) {
    const times = [];
    for (let round = -2; round < ROUNDS; round++) {
        const [hand, own] = pair.map((work) => {
            const before = process.cpuUsage();
            const result = work();
            const { user, system } = process.cpuUsage(before);
            return { result, time: user + system };
        });
        if (hand.result !== own.result) throw new Error(`${name}: ${hand.result}, ${own.result}`);
        if (round >= 0) times.push(own.time / hand.time);
    }
    ratios[name] = times.sort((a, b) => a - b)[ROUNDS >> 1];
}
console.log(JSON.stringify(ratios));
