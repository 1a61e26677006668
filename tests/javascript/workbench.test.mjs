// The workbench as it is built: the finder, and the texts that people paste. The pages are tested in a browser.
//
//     FOLDER=generated/javascript WORKBENCH=build/workbench node --test workbench.test.mjs
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import vm from "node:vm";

const script = path.resolve(process.env.WORKBENCH, "workbench.js");
const load = (name) => import(pathToFileURL(path.resolve(process.env.FOLDER, name)));
await import(pathToFileURL(script));
const { Protocol, buildPacket, bytesOfText, find, indexOf, initialValues, inspect, model, toHex } = globalThis.mip;
const protocol = new Protocol(model);
const real = protocol.fields.has("shared.reference_timestamp") && protocol.fields.has("sensor.scaled_accel");

test("the script has all of the codec and decodes as it does, and nothing is global but `mip`", async () => {
    const context = vm.createContext({ TextEncoder });
    vm.runInContext(fs.readFileSync(script, "utf8"), context);
    assert.deepEqual(Object.keys(context), ["TextEncoder", "mip"]);
    const codec = await load("mip/tools.mjs");
    assert.deepEqual(
        Object.keys(codec).filter((name) => !(name in context.mip)),
        [],
    );
    const { default: wanted } = await load("model.mjs");
    const of = new codec.Protocol(wanted);
    const theirs = new context.mip.Protocol(context.mip.model);
    const text = (value) => JSON.stringify(value, (key, v) => (key === "field" ? v.name : typeof v === "bigint" ? `${v}` : v));
    for (const { packet } of wanted.examples) {
        const bits = { floatBits: true };
        const one = context.mip.decodePacket(theirs, context.mip.Packet.from(context.mip.fromHex(packet)), bits);
        assert.equal(text(one), text(codec.decodePacket(of, codec.Packet.from(codec.fromHex(packet)), bits)), packet);
    }
});

// ------------------------------------------------------------------------------------------------ the finder

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
    protocol.model.fields.forEach((field, i) => {
        const symbols = Object.values(field.symbols); // of one language after the other
        const [symbol, another] = [symbols[i % symbols.length], symbols[(i + 1) % symbols.length]];
        for (const text of [field.name, symbol, `${another}_encode`]) assert.equal(first(text)?.name, field.name, text);
    });
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

test("words that nothing has are named, and short words are not taken for others", { skip: !real && "of the real one" }, () => {
    const said = (text) => globalThis.mip.missing(index, text);
    assert.equal(said("gimbal lock"), "Nothing has “gimbal”.");
    assert.equal(said("quaternoin"), "Nothing has “quaternoin”; searched for “quaternion”.");
    for (const text of ["scaled_accel", "0x0D13", "xyzzy"]) assert.equal(said(text), "", text);
    const taken = (word) => index.ranking.search(`${word} speed`).instead;
    for (const [word, other] of [["posix"], ["wear"], ["buad", "baud"], ["antena", "antenna"], ["filtr", "filter"]]) {
        assert.deepEqual(taken(word), [[word, other]]);
    }
});

// ---------------------------------------------------------------------------------------------------- pasted text

const PING = "756501020201e0c6";

test("bytes are read in the forms in which programs and tools write them", () => {
    const texts = JSON.parse(fs.readFileSync(new URL("../pasted.json", import.meta.url), "utf8"));
    texts[PING].push(
        String.raw`don't: 'ue\x01\x02\x02\x01\xe0\xc6'`,
        String.raw`printf \165\145\001\002\002\001\340\306`,
        '{"data": "dWUBAgIB4MY"}',
        "75h 65h 01h 02h 02h 01h E0h C6h",
        "sent: 75 65 1 2 2 1 e0 c6\n",
        "75 65 1 2 2 1 e0 c6 is a ping",
        "=> md.b 80000000 8\n80000000: 75 65 01 02    ue..\n80000004: 02 01 e0 c6    ....",
        "[2024-08-02T12:00:01Z INFO  mip] rx [75, 65, 01, 02, 02, 01, e0, c6]",
        "TX: 75 65 01 02 RX: 02 01 e0 c6",
        "J-Link>mem8 20000000 8\n20000000 = 75 65 01 02\n20000004 = 02 01 e0 c6",
        "│00000000│ 75 65 01 02 02 01 e0 c6 ┊                         │ue•••••×┊        │",
        "[75] [65] [01] [02] [02] [01] [e0] [c6]",
        "0x75 65 01 02 02 01 e0 c6",
    );
    for (const [bytes, some] of Object.entries(texts)) {
        for (const text of some) assert.equal(toHex(bytesOfText(text).bytes), bytes, text);
    }
});

test("single digits are bytes between bytes, and at the end of a list, but not in words", () => {
    for (const [text, wanted] of [
        ["a b 75 65", "7565"],
        ["75 65 a packet", "7565"],
        ["3 4 5 packets: 75 65", "7565"],
        ["75 65 1 2 2 1 b 5", "7565010202010b05"],
        ["after 0.5 s: 75 65 1, 2", "75650102"],
    ]) {
        assert.equal(toHex(bytesOfText(text).bytes), wanted, text);
    }
    assert.equal(bytesOfText("75 65 ".repeat(50000)).bytes.length, 100000); // a long text
});

test("what is left out of a pasted text is listed", () => {
    for (const [text, ignored] of [
        ["7565 0102\n0201  e0c6", []],
        ["0124: 75 65 01 02", ["0124"]],
        ["0124: 75 65 then 01 02", ["0124", "then"]],
        ["I (1234) uart: 75 65 01 02", ["I (1234) uart"]],
        ["0124: 75 65 01 02  ue..\n0128: 02 01 e0 c6  ....", []],
        ["[10:11:12.345] 75 65", ["10:11:12.345"]],
        ["0x75, // sync 10\n0x65", ["// sync 10"]],
        ["117, 101, 256", ["256"]],
        ["117, 102", ["117, 102"]],
        ["hello world", ["hello world"]],
    ]) {
        assert.deepEqual(bytesOfText(text).ignored, ignored, text);
    }
});

// ------------------------------------------------------------------------------------------- what bytes mean

test("of the beginning of a packet, the fields are shown that are whole", () => {
    const fieldsOf = (text) => inspect(protocol, text).parts[0].fields ?? [];
    const { packet } = model.examples.find((one) => fieldsOf(one.packet).length > 1);
    const begun = packet.slice(0, -6); // without the checksum and the last byte of the last field
    assert.equal(inspect(protocol, begun).parts[0].kind, "incomplete");
    const bytes = (fields) => fields.map((one) => toHex(one.bytes));
    assert.deepEqual(bytes(fieldsOf(begun)), bytes(fieldsOf(packet)).slice(0, -1));
});

test("of a long text, only the first parts are decoded, and all are counted", () => {
    const { parts, packets, more } = inspect(protocol, `${PING} 00 `.repeat(20000), undefined, 5);
    assert.deepEqual([parts.length, packets, more], [5, 20000, 39995]);
});

// ------------------------------------------------------------------------------------------- values to begin with

test("a value begins with its default, which may be the names of bits; a text of no fixed length begins empty", () => {
    const type = model.types.find((one) => one.kind === "bitfield" && one.bits?.length > 1 && one.bits[1].first > 0);
    const [a, b] = type.bits;
    const begin = (kind, parameter) => {
        const field = { parameters: [{ name: "it", ...parameter }], operations: [{ kind, member: "it" }] };
        return initialValues(protocol, field).it;
    };
    assert.equal(begin("scalar", { type: type.name, default: [a.name, b.name] }), 2 ** a.first + 2 ** b.first);
    assert.equal(begin("scalar", { type: "u8", default: 7 }), 7);
    assert.equal(begin("scalar", { type: "u8", minimum: 3 }), 3);
    assert.equal(begin("text", {}), "");
    assert.equal(begin("text", { default: "ab" }), "ab");
});

// ------------------------------------------------------------------------------------------------ logs

/** Scaled acceleration at these times in seconds, by the clock of the device, with sentences between. */
function logOf(times) {
    const { buildPacket } = globalThis.mip;
    const accel = { name: "sensor.scaled_accel", values: initialValues(protocol, protocol.field("sensor.scaled_accel")) };
    const parts = [];
    for (const [i, seconds] of times.entries()) {
        const time = { name: "shared.reference_timestamp", values: { nanoseconds: BigInt(Math.round(seconds * 1e9)) } };
        parts.push(...buildPacket(protocol, 0x80, [time, accel]).bytes);
        if (i % 10 === 3) parts.push(...new TextEncoder().encode("$GPGGA,1*00\r\n"));
    }
    return Uint8Array.from(parts);
}

const regular = (count) => Array.from({ length: count }, (_, i) => 5 + i / 100);

async function* pieces(bytes, size) {
    for (let at = 0; at < bytes.length; at += size) yield bytes.subarray(at, at + size);
}

test("a log in pieces of any size has the same packets, rates and gaps", { skip: !real && "of the real specification" }, async () => {
    const { survey } = globalThis.mip;
    const log = logOf(regular(300).filter((_, i) => i < 100 || i >= 103));
    let before;
    for (const size of [1000, 65536]) {
        const found = await survey(protocol, () => pieces(log, size));
        assert.equal(found.packets, 297);
        assert.equal(found.sentences, 30);
        assert.equal(found.skipped, 390);
        const accel = found.fields.find(({ name }) => name === "sensor.scaled_accel");
        assert.deepEqual([accel.count, accel.rhythm.gaps, accel.rhythm.lost], [297, 1, 3]);
        assert.ok(Math.abs(accel.rhythm.rate - 100) < 1e-6);
        assert.deepEqual(
            found.gaps.map(({ packet, lost, fields }) => [packet, lost, fields.length]),
            [[100, 3, 2]],
        );
        const { pages, ...rest } = found;
        const behind = (offset) => new globalThis.mip.Parser().feed(log.subarray(offset)).length;
        for (const { offset, first } of pages) assert.equal(behind(offset), 297 - first);
        const text = JSON.stringify(rest, (key, value) => (key === "field" ? value.name : value));
        assert.equal(text, before ?? text);
        before = text;
    }
});

test("packets of events, a reset and a clock that becomes valid are not gaps", { skip: !real && "of the real one" }, async () => {
    const { survey } = globalThis.mip;
    const rhythmOf = async (log) => (await survey(protocol, () => pieces(log, 4096))).fields[0].rhythm;
    const events = [5.0013, 5.31, 5.32, 5.9]; // single ones, among regular data or alone
    for (const [times, rate] of [
        [[...regular(100), ...events].sort(), 100],
        [events, undefined],
        [[...regular(100), ...regular(100)], 100],
    ]) {
        const { rate: found, gaps } = await rhythmOf(logOf(times));
        assert.deepEqual([found && Math.round(found), gaps], [rate, 0]);
    }
    const packets = regular(100).flatMap((tow, i) => {
        const values = { tow: i < 50 ? tow : tow + 1e5, week_number: 2300, valid_flags: i < 50 ? 0 : 3 };
        return [...buildPacket(protocol, 0x80, [{ name: "shared.gps_timestamp", values }]).bytes];
    });
    const { rate, gaps } = await rhythmOf(Uint8Array.from(packets));
    assert.deepEqual([Math.round(rate), gaps], [100, 0]);
});

/** A log with one packet per timestamp: [tow, week, flags]. */
function stamped(rows) {
    const packet = ([tow, week_number, valid_flags]) =>
        buildPacket(protocol, 0x80, [{ name: "sensor.gps_timestamp", values: { tow, week_number, valid_flags } }]);
    return Uint8Array.from(rows.flatMap((row) => [...packet(row).bytes]));
}

const ticks = (from, count, ...rest) => Array.from({ length: count }, (_, i) => [from + i / 100, ...rest]);

test("times are those of the clocks with and without a date", { skip: !real && "of the real one" }, async () => {
    const { spanText, survey } = globalThis.mip;
    const dated = (from, to) => `2024-02-08T00:00:00.${from}Z to 2024-02-08T00:00:00.${to}Z`;
    const undated = (from, to) => `device clock ${from} to ${to} s, no date: not synchronized`;
    const [older, gx5] = ["sensor.gps_timestamp: flags read as those of generations 4 and 5 (recognized)", "device 3DM-GX5-25"];
    for (const [rows, device, texts, read, rate = 100] of [
        // three flags: valid with and without the device
        [ticks(345618, 40, 2300, 5), undefined, [dated("000", "390")], older],
        [ticks(345618, 40, 2300, 7), "3dm-gx5-25", [dated("000", "390")], gx5],
        [ticks(345618, 40, 2300, 7), "3dm-cv7-ar", [undated(345618, 345618.39)], "device 3DM-CV7-AR"],
        // five flags later in the log: flags 5 before them are not valid
        [
            [...ticks(345618, 20, 2300, 5), ...ticks(345618.2, 20, 2300, 0x1d)],
            undefined,
            [`${dated("200", "390")}; ${undated(345618, 345618.19)}`],
            "",
        ],
        [ticks(12.5, 40, 0, 0), "3dm-gx5-25", [undated(12.5, 12.89)], gx5],
        [[...ticks(5, 40, 0, 0), ...ticks(0.5, 40, 0, 0)], "3dm-gx5-25", [undated(5, 5.39), undated(0.5, 0.89)], gx5],
        [[...ticks(604799.5, 50, 0, 0), ...ticks(0, 50, 0, 0)], "3dm-gx5-25", [undated(604799.5, 604800.49)], gx5],
        [[...ticks(12, 40, 0, 0), ...ticks(345618, 40, 2300, 7)], "3dm-gx5-25", [`${dated("000", "390")}; ${undated(12, 12.39)}`], gx5],
        [ticks(NaN, 40, 0, 0), "3dm-gx5-25", [], gx5, null],
        [Array(40).fill([7, 0, 0]), "3dm-gx5-25", [undated(7, 7)], gx5, null],
    ]) {
        const log = stamped(rows);
        const found = await survey(protocol, () => pieces(log, 4096), undefined, device);
        const [{ rhythm, valid }] = found.fields;
        const shown = found.spans.map((span) => spanText(protocol, span));
        assert.deepEqual([rhythm.rate ? Math.round(rhythm.rate) : null, rhythm.gaps, shown, found.read], [rate, 0, texts, read]);
        assert.ok(valid <= rows.length);
    }
});

test("a gap in a log with dates has its date", { skip: !real && "of the real one" }, async () => {
    const { gapText, survey } = globalThis.mip;
    const texts = async (rows) => (await survey(protocol, () => [stamped(rows)])).gaps.map(gapText);
    const gap = (week, flags) => [...ticks(345618, 40, week, flags), ...ticks(345619, 40, week, flags)];
    const end = "60 samples of sensor.gps_timestamp";
    assert.deepEqual(await texts(gap(2300, 0x1d)), [`before packet 41: 0.61 s after 2024-02-08T00:00:00.390Z, ${end}`]);
    assert.deepEqual(await texts(gap(0, 0)), [`before packet 41: 0.61 s after 345618.39 s, ${end}`]);
});

test("a log of an unknown device is read as on those that explain it", { skip: !real && "of the real one" }, async () => {
    const { survey } = globalThis.mip;
    const fields = [
        ["filter_data.euler_angles", { roll: 0, pitch: 0, yaw: 0, valid_flags: 0 }],
        ["filter_data.status", { filter_state: 1, dynamics_mode: 1, status_flags: 0x1000 }],
    ].map(([name, values]) => ({ name, values }));
    const log = Uint8Array.from(buildPacket(protocol, 0x82, fields).bytes);
    const found = await survey(protocol, () => [log]);
    assert.equal(found.read, "filter_data.status: flags read as those of generations 4 and 5 (recognized)");
    const shown = (device) =>
        inspect(protocol, toHex(log), device).parts[0].fields[1].rows.map(({ name, flags }) => name ?? flags?.[0].bits.name);
    assert.deepEqual(shown(found.reads), ["init", "portable", "init_no_attitude"]);
    assert.deepEqual(shown(undefined), [undefined, undefined, undefined]);
    assert.equal((await survey(protocol, () => [log], undefined, "3dm-cv7-ar")).reads(found.fields[1].field), "3dm-cv7-ar");
});

test("the device is that of the log, and values that are not valid are counted", { skip: !real && "of the real one" }, async () => {
    const { survey } = globalThis.mip;
    const response = protocol.field("base.get_device_info_response");
    const info = { ...initialValues(protocol, response).device_info, model_number: "       6253-4220" };
    const reply = buildPacket(protocol, 1, [{ name: response.name, values: { device_info: info } }]);
    const angles = [1, 0, 0, 1].map((valid_flags) =>
        buildPacket(protocol, 0x82, [{ name: "filter_data.euler_angles", values: { roll: 0, pitch: 0, yaw: 0, valid_flags } }]),
    );
    const log = Uint8Array.from([...stamped(ticks(345618, 10, 2300, 5)), ...reply.bytes, ...angles.flatMap(({ bytes }) => [...bytes])]);
    for (const [named, read] of [
        [undefined, "device 3DM-GX5-25 (from the log)"],
        ["3dm-gx5-45", "device 3DM-GX5-45"],
    ]) {
        const found = await survey(protocol, () => pieces(log, 4096), undefined, named);
        const counts = Object.fromEntries(found.fields.map(({ name, valid, count }) => [name, [valid, count]]));
        assert.equal(found.read, read);
        assert.deepEqual(counts["filter_data.euler_angles"], [2, 4]);
        assert.deepEqual(counts["sensor.gps_timestamp"], [10, 10]);
    }
});

test("a survey ends where it is told to", { skip: !real && "of the real specification" }, async () => {
    const log = logOf(regular(300));
    const found = await globalThis.mip.survey(
        protocol,
        () => pieces(log, 4096),
        (bytes) => bytes < 8192,
    );
    assert.equal(found.bytes, 8192);
});

// ------------------------------------------------------------------------------------------------ transactions

test("an acknowledge names the command that it answers, and commands and answers are paired", { skip: !real && "of the real one" }, () => {
    const sent = "75650C04042801041B55"; // write
    const text = `${sent} 75650C0404F1280007FA 75650C03032802 1650 75650C0404F128030AFD`;
    const { transactions, parts } = inspect(protocol, text);
    const acknowledges = parts.flatMap(({ fields }) => fields ?? []).filter(({ answered }) => answered);
    assert.deepEqual(
        acknowledges.map(({ answered }) => answered.text),
        ["PPS source control acknowledged", "PPS source control refused: invalid parameter"],
    );
    assert.deepEqual(
        transactions.map(({ command, answer }) => [command?.field.name, answer?.answered.accepted]),
        [
            ["3dm.pps_source_control", true],
            ["3dm.pps_source_control", false],
        ],
    );
});

test("model numbers have the names of devices", { skip: !real && "of the real one" }, () => {
    const response = protocol.field("base.get_device_info_response");
    const info = { ...initialValues(protocol, response).device_info, model_number: "       6292-4220" };
    const packet = globalThis.mip.buildPacket(protocol, 1, [{ name: response.name, values: { device_info: info } }]);
    const [{ fields }] = inspect(protocol, toHex(packet.bytes)).parts;
    assert.equal(fields[0].rows.find(({ path }) => path.endsWith("model_number")).meaning, "3DM-CV7-GNSS/INS");
});

test("a set that a device lacks the hardware for is not supported", { skip: !real && "of the real one" }, () => {
    const context = vm.createContext({ TextEncoder }); // what the search of the reference uses has a smaller model
    vm.runInContext(fs.readFileSync(path.resolve(process.env.WORKBENCH, "fields.js"), "utf8"), context);
    for (const mip of [globalThis.mip, context.mip]) {
        const of = new mip.Protocol(mip.model);
        const device = of.model.devices.find(({ id }) => id === "3dm-cv7-ar");
        const on = (name, set) => mip.certaintyOn(of, device, of.field(name), set);
        assert.equal(on("gnss_1.fix_info", 0x91), undefined);
        assert.equal(on("shared.reference_timestamp", 0x91), undefined);
        assert.equal(on("shared.reference_timestamp", 0x80), "");
        assert.equal(on("3dm.poll_gnss_data", 0x0c), undefined);
        assert.equal(on("3dm.poll_imu_data", 0x0c), "not known");
    }
});

test("decimations have their rate in Hz on a device", { skip: !real && "of the real one" }, () => {
    const text = "75650C0B0B0F01800204000A05000AABE8"; // scaled accel and gyro
    const rates = (device) => {
        const rows = inspect(protocol, text, device).parts.flatMap(({ fields }) => fields.flatMap((one) => one.rows));
        return rows.filter(({ path }) => path.endsWith("decimation")).map(({ meaning }) => meaning);
    };
    assert.deepEqual(rates("3dm-cv7-gnss-ins"), Array(2).fill("100 Hz on the chosen device"));
    assert.deepEqual(rates(undefined), [undefined, undefined]);
});

test("all forms of an attitude are the same rotation", { skip: !real && "of the real one" }, () => {
    const [half, one] = [Math.SQRT1_2, Math.PI / 2]; // a quarter turn about z
    const forms = {
        euler_angles: { roll: 0, pitch: 0, yaw: one },
        attitude_quaternion: { q: [half, 0, 0, half] },
        attitude_dcm: { dcm: [0, 1, 0, -1, 0, 0, 0, 0, 1] },
    };
    const [wanted, ...others] = Object.entries(forms).map(([name, values]) =>
        globalThis.mip.rotationOf(protocol.field(`filter_data.${name}`), values).flat(),
    );
    for (const other of others) for (const [i, x] of other.entries()) assert.ok(Math.abs(x - wanted[i]) < 1e-9, `${other} ${wanted}`);
});

test("the live page reads times as those of the device", { skip: !real && "of the real one" }, () => {
    const values = { tow: 345600, week_number: 2300, valid_flags: 7 }; // a date, but not on a device with five flags
    const accel = { name: "sensor.scaled_accel", values: { scaled_accel: [0, 0, -1] } };
    const packet = buildPacket(protocol, 0x80, [{ name: "sensor.gps_timestamp", values }, accel]);
    const dated = (device) => {
        const readings = new globalThis.mip.Readings(protocol);
        readings.device = device;
        readings.take(packet);
        const reading = readings.fields.get(0x8004);
        reading.plotted = true;
        readings.take(packet);
        return reading.dated;
    };
    assert.deepEqual([undefined, "3dm-gx5-25", "3dm-cv7-ahrs"].map(dated), [true, true, false]);
});

test("live data that is not valid is not drawn, and slow data is not late", { skip: !real && "of the real one" }, () => {
    const readings = new globalThis.mip.Readings(protocol);
    const take = (field, values, arrival) => {
        const packet = buildPacket(protocol, 0x82, [{ name: `filter_data.${field}`, values }]);
        readings.take(Object.assign(packet, { arrival }));
        return readings.fields.get(0x8200 + protocol.field(`filter_data.${field}`).descriptor);
    };
    const angles = (values) => take("euler_angles", { roll: 0, pitch: 0, yaw: 1, valid_flags: 1, ...values }, 1).rotation;
    assert.ok(angles({}));
    for (const values of [{ valid_flags: 0 }, { yaw: Number.NaN }, { yaw: "0x7fe5bf7f" }]) assert.equal(angles(values), undefined);
    assert.equal(take("euler_angles_uncertainty", { roll: 0, pitch: 0, yaw: 1, valid_flags: 1 }, 1).rotation, undefined);
    const position = (values, arrival) =>
        take("llh_position", { latitude: 44, longitude: -73, ellipsoid_height: 90, valid_flags: 1, ...values }, arrival);
    const reading = position({}, 10);
    reading.plotted = true;
    for (const values of [{ valid_flags: 0 }, { latitude: Number.NaN }, {}]) position(values, 20);
    assert.deepEqual([reading.track.length, ...reading.plots.map(({ unit }) => unit)], [1, undefined, "m"]);
    position({}, 30);
    assert.deepEqual(
        [54, 56].map((now) => reading.isLate(now)),
        [false, true],
    );
    position({}, 30.01);
    assert.deepEqual(
        [32, 33].map((now) => reading.isLate(now)),
        [false, true],
    );
});
