// A device at fake ports that do what real ports do at their worst. Programs at a virtual device test the rest.
//
//     FOLDER=generated/javascript node --test device.test.mjs
import assert from "node:assert/strict";
import net from "node:net";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.env.FOLDER);
const load = (name) => import(pathToFileURL(path.join(folder, name)));
const { Device, fromHex, MipError, Packet, packetOf, Parser, toHex } = await load("mip/index.mjs");
const { openSerial } = await load("mip/serial.mjs");
const { openTcp } = await load("mip/tcp.mjs");
const { openWebSocket } = await load("mip/websocket.mjs");
const { GetBaseRate, MessageFormat, PpsSourceControl } = await load("3dm.mjs");
const { rejections } = await load("mip/rejected.mjs");
const { default: model } = await load("model.mjs");
const { CommSpeed, GetDeviceInfo, Ping } = await load("base.mjs");
const { EcefPosition } = await load("aiding.mjs");
const { GpsTimestamp: SensorTime, ScaledAccel, ScaledGyro } = await load("sensor.mjs");
const { GpsTimestamp } = await load("shared.mjs");
const { LlhPosition } = await load("gnss_data.mjs");
const { Clock, Times } = await load("time.mjs");

const ack = (set, descriptor, code = 0) => ({ descriptor: 0xf1, data: Uint8Array.of(descriptor, code), set });
const packet = (...fields) => Packet.build(fields[0].set, fields).bytes;
const DATA = new ScaledAccel({ scaledAccel: [0, 0, -1] }).packet().bytes;

/** A port whose other end answers what is written with what `reply` returns. */
function fakePort(reply) {
    const pieces = [];
    let wake = () => {};
    let failure;
    let ended = false;
    const port = {
        written: [],
        closes: 0,
        arrive(bytes) {
            pieces.push(bytes);
            wake();
        },
        lose(error) {
            failure = error;
            ended = true;
            wake();
        },
        async *bytes() {
            for (;;) {
                if (pieces.length) yield pieces.shift();
                else if (failure) throw failure;
                else if (ended) return;
                else
                    await new Promise((resolve) => {
                        wake = resolve;
                    });
            }
        },
        write(bytes) {
            port.written.push(bytes);
            const answer = reply?.(bytes);
            if (answer) port.arrive(answer);
        },
        close() {
            port.closes++;
            port.lose();
        },
    };
    return port;
}

const opened = async (reply, options) => {
    const port = fakePort(reply);
    return { port, device: await Device.open(async () => port, options) };
};

const joined = (parts) => new Uint8Array(Buffer.concat(parts));
const pings = (count) => packetOf(Array.from({ length: count }, () => new Ping())).bytes;

/** Answers each packet with what `reply` returns for each of its fields. */
const answering = (reply) => {
    const parser = new Parser();
    return (bytes) => joined(parser.feed(bytes).map((sent) => packet(...[...sent.fields()].flatMap(reply))));
};

/** Acknowledges every field, with a code. */
const acknowledging = (code = 0) => answering(({ set, descriptor }) => ack(set, descriptor, code));

/** Acknowledges every field, and returns base rates: 100 Hz for set 0x80, and 4 Hz for others. */
const rating = () =>
    answering(({ set, descriptor, data: [of] }) => {
        const rate = { descriptor: 0x8e, data: Uint8Array.of(of, 0, of === 0x80 ? 100 : 4), set };
        return [ack(set, descriptor), ...(descriptor === 0x0e ? [rate] : [])];
    });

/** The same, but the first answer comes with the second. */
const lagging = () => {
    const reply = rating();
    const late = [];
    let asked = 0;
    return (bytes) => {
        late.push(reply(bytes));
        return asked++ ? joined(late.splice(0)) : new Uint8Array();
    };
};

test("what a command may end with", async () => {
    const { device } = await opened(acknowledging());
    assert.equal(await device.request(new Ping()), undefined);
    await assert.rejects(device.request(new GetDeviceInfo()), { name: "MipError", kind: "missing_response" });
    const refused = await opened(acknowledging(3));
    await assert.rejects(refused.device.request(new Ping()), {
        kind: "refused",
        code: 3,
        message: "base.ping rejected (invalid parameter)",
    });
    const silent = await opened();
    await assert.rejects(silent.device.request(new Ping(), { timeout: 0.05 }), { kind: "timeout" });
    assert.deepEqual(
        (await refused.device.exchange([new Ping(), new Ping()])).map(({ accepted }) => accepted),
        [false, false],
    );
    for (const wrong of [-1, Number.NaN, "1"]) await assert.rejects(device.request(new Ping(), { timeout: wrong }), { kind: "timeout" });
    await assert.rejects(device.requestAll([]), { kind: "missing" });
    await assert.rejects(device.request(new ScaledAccel({ scaledAccel: [0, 0, -1] })), { kind: "set" });
    for (const one of [device, refused.device, silent.device]) await one.close();
});

/** Answers what a device is and what it lists, and rejects all else: descriptor -> the response and its data. */
const rejecting = (responses, sent = []) =>
    answering(({ set, descriptor }) => {
        sent.push(descriptor);
        const [number, data] = (set === 1 && responses[descriptor]) || [];
        if (!data) return ack(set, descriptor, 3);
        return [ack(set, descriptor), { descriptor: number, data: Uint8Array.from(data), set }];
    });
const informed = (...texts) => [0x81, [0, 0, ...[...texts.join("").padEnd(80)].map((letter) => letter.charCodeAt(0))]];
const listing = (...descriptors) =>
    MessageFormat.write({ descriptorSet: 0x82, descriptors: descriptors.map((descriptor) => ({ descriptor, decimation: 1 })) });

test("a device that rejects a list is asked once what it is and what it sends", async () => {
    const sent = [];
    const responses = { 3: informed("3DM-CV7-AHRS    ", "6286-9999"), 4: [0x82, [1, 1, 1, 7, 0x80, 4]], 7: [0x86, [0x82, 0x10]] };
    const { device } = await opened(rejecting(responses, sent), { explain: rejections(model) });
    const text = "3DM-CV7-AHRS does not send filter_data.llh_position";
    for (let i = 0; i < 2; i++)
        await assert.rejects(device.request(listing(0x10, 0x01)), {
            message: `3dm.message_format rejected (invalid parameter): ${text}`,
            rejected: { index: 1, set: 0x82, descriptor: 1, reason: "absent", text },
        });
    assert.deepEqual(sent, [0x0f, 3, 4, 7, 0x0f]);
    await assert.rejects(device.request(PpsSourceControl.read()), { rejected: undefined });
    const [outcome] = await device.exchange([listing(0x10, 0x01)]);
    assert.equal(outcome.rejected.text, text);
    await device.close();
});

test("a device that does not answer all that it was asked about itself is judged by its profile alone", async () => {
    const responses = { 3: informed(" ".repeat(16), "6286"), 4: [0x82, [1, 7, 0x80, 4]] };
    const { device } = await opened(rejecting(responses), { explain: rejections(model) });
    await assert.rejects(device.request(listing(0x05)), { rejected: undefined }); // of the list's second half: the model sends it
    await device.close();
});

test("the same command object may be sent twice at once", async () => {
    const { device, port } = await opened(acknowledging());
    const ping = new Ping();
    assert.deepEqual(await device.requestAll([ping, ping]), [undefined, undefined]);
    assert.equal(toHex(port.written[0]), toHex(pings(2)));
    await device.close();
});

test("a reply that arrives twice answers no later command, if the copy waits before that is sent", async () => {
    const reply = rating();
    const port = fakePort((bytes) => {
        const answer = reply(bytes);
        for (let i = 0; i < 2; i++) setImmediate(() => port.arrive(answer)); // like two datagrams that wait at a socket
        return undefined;
    });
    const device = await Device.open(async () => port);
    for (let i = 0; i < 500; i++) {
        const descriptorSet = [0x80, 0x82, 0x91][i % 3];
        assert.equal((await device.request(new GetBaseRate({ descriptorSet }))).descriptorSet, descriptorSet);
    }
    assert.ok(device.waiting >= 499); // the copies are data
    await device.close();
});

test("data arrives in order, and nothing is lost before the port is", async () => {
    const { device, port } = await opened(undefined, { capacity: 2 });
    assert.equal(await device.next({ timeout: 0.01 }), undefined);
    for (let i = 0; i < 3; i++) port.arrive(DATA);
    port.lose(new Error("unplugged"));
    await new Promise((resolve) => setTimeout(resolve, 10));
    assert.equal(device.dropped, 1);
    assert.equal(device.waiting, 2);
    let count = 0;
    await assert.rejects(
        async () => {
            for await (const one of device) {
                assert.deepEqual(one.find(ScaledAccel).scaledAccel, [0, 0, -1]);
                assert.ok(Math.abs(one.arrival - Date.now() / 1000) < 5);
                count++;
            }
        },
        { kind: "closed", message: "the port is lost: unplugged" },
    );
    assert.equal(count, 2);
    await assert.rejects(device.request(new Ping()), { kind: "closed" });
    assert.equal(device.closed, true);
});

test("a loop over the data ends when the device is closed, and so does a command", async () => {
    const { device, port } = await opened();
    const loop = (async () => {
        for await (const _ of device);
        return "ended";
    })();
    const command = device.request(new Ping());
    const waiting = assert.rejects(command, { kind: "closed" });
    await new Promise((resolve) => setTimeout(resolve, 10));
    await device.close();
    assert.equal(await loop, "ended");
    await waiting;
    assert.equal(port.closes, 1);
    assert.equal(await device.next(), undefined);
});

test("noise that looks like the beginning of a packet does not hide the data behind it", async () => {
    const skipped = [];
    const { device, port } = await opened(undefined, { onSkipped: (bytes) => skipped.push(...bytes) });
    port.arrive(Uint8Array.of(0x75, 0x65, 0x80, 0xff, 1));
    port.arrive(DATA);
    assert.ok((await device.next({ timeout: 2 })).find(ScaledAccel));
    assert.equal(device.skipped, 5);
    assert.deepEqual(skipped, [0x75, 0x65, 0x80, 0xff, 1]);
    await device.close();
});

test("a port that is lost is opened again", async () => {
    const ports = [fakePort(acknowledging()), undefined, fakePort(acknowledging())];
    let opens = 0;
    const device = await Device.open(async () => {
        const port = ports[opens++];
        if (!port) throw new Error("not there yet");
        return port;
    });
    ports[0].arrive(DATA);
    ports[0].lose();
    await new Promise((resolve) => setTimeout(resolve, 10));
    await assert.rejects(device.request(new Ping()), { kind: "closed" });
    await device.reopen({ within: 2 });
    assert.equal(await device.request(new Ping()), undefined);
    assert.ok((await device.next()).find(ScaledAccel)); // what had arrived is kept
    assert.equal(opens, 3);
    await device.close();
});

test("the answer of a lost connection is not that of a command of the next one", async () => {
    const ports = [fakePort(), fakePort(acknowledging())];
    let opens = 0;
    const device = await Device.open(async () => ports[opens++]);
    const waiting = assert.rejects(device.request(new Ping()), { kind: "closed" });
    ports[0].lose();
    await waiting;
    await device.reopen();
    ports[1].arrive(packet(ack(1, 1, 3)));
    assert.equal(await device.request(new Ping()), undefined);
    assert.equal(toHex((await device.next()).bytes), toHex(packet(ack(1, 1, 3))));
    await device.close();
});

test("the answer to a command that is only sent is not waited for, nor taken for that of the next", async () => {
    const { device, port } = await opened();
    await device.send(new Ping());
    const ping = device.request(new Ping(), { timeout: 5 });
    while (port.written.length < 2) await new Promise((resolve) => setImmediate(resolve));
    assert.equal(toHex(port.written[1]), toHex(pings(2)) + toHex(pings(1)));
    for (const answer of [[ack(1, 1, 3)], [ack(1, 1), ack(1, 1)], [ack(1, 1)]]) port.arrive(packet(...answer));
    assert.equal(await ping, undefined);
    assert.equal(toHex((await device.next()).bytes), toHex(packet(ack(1, 1, 3))));
    assert.equal(device.waiting, 0);
    await device.close();
});

test("bytes that are not commands are written until the port is lost", async () => {
    const { device, port } = await opened();
    await device.write(Uint8Array.of(0xd3, 0));
    assert.deepEqual(port.written, [Uint8Array.of(0xd3, 0)]);
    port.lose();
    await assert.rejects(device.next(), { kind: "closed" });
    await assert.rejects(device.write(Uint8Array.of(0xd3, 0)), { kind: "closed" });
});

test("a device that is closed while its port is opened again leaves no port open", async () => {
    const ports = [];
    const device = await Device.open(async () => {
        await new Promise((done) => setTimeout(done, 5 * ports.length));
        ports.push(fakePort());
        return ports.at(-1);
    });
    const reopened = device.reopen();
    await new Promise((done) => setTimeout(done, 1));
    await device.close();
    await assert.rejects(reopened, { kind: "closed" });
    assert.ok(device.closed && ports.at(-1).closes === 1);
});

test("a setting that silences commands is asked for once", async () => {
    const echo = Uint8Array.of(0); // commands are not acknowledged
    const { device, port } = await opened((bytes) => {
        const sent = new Packet(bytes);
        const [{ descriptor }] = sent.fields();
        return descriptor === 0x1f ? packet(ack(0x13, 0x1f), { descriptor: 0x9f, data: echo, set: 0x13 }) : undefined;
    });
    const position = new EcefPosition({
        time: { timebase: 1, reserved: 1, nanoseconds: 5n },
        frameId: 1,
        position: [1, 2, 3],
        uncertainty: [1, 1, 1],
        validFlags: 7,
    });
    assert.equal(await device.request(position), undefined);
    assert.equal(await device.request(position), undefined);
    assert.equal(port.written.length, 3);
    assert.deepEqual(port.written[2], port.written[1]); // without a barrier: no answer is missing
    await device.close();
});

test("rates are checked before anything is changed", async () => {
    const { device, port } = await opened(rating());
    await assert.rejects(device.stream([[ScaledAccel, 30]]), { kind: "rate", message: /100 Hz.*nearest: 33.3/ });
    assert.equal(port.written.length, 2); // the device was also asked which model it is
    await assert.rejects(device.stream([[LlhPosition, 1]]), { kind: "set" });
    await assert.rejects(device.stream([[ScaledAccel, 1]], { set: 0x82 }), { kind: "set" });
    await assert.rejects(device.stream([[ScaledAccel, -1]]), { kind: "range" });
    assert.equal(port.written.length, 2);
    device.model = "3dm-cv7-ahrs"; // it is not asked again
    const rates = await device.stream([[ScaledAccel, 50], [GpsTimestamp, 0], [ScaledGyro, 100]]); // biome-ignore format: one line
    assert.deepEqual([...rates.values()], [50, 100, 100]);
    assert.equal(toHex(port.written[3]).slice(8, -4), "0e0f018003d30001040002050001"); // the shared field first
    await device.close();
});

test("a stream gets the first timestamp that the device accepts", async () => {
    const formats = [];
    const accepting = (stamp) =>
        answering(({ set, descriptor, data }) => {
            const rate = { descriptor: 0x8e, data: Uint8Array.of(data[0], 3, 0xe8), set };
            if (descriptor === 0x0f) formats.push(toHex(data));
            return descriptor === 0x0f && data[3] !== stamp
                ? ack(set, descriptor, 3)
                : [ack(set, descriptor), ...(descriptor === 0x0e ? [rate] : [])];
        });
    const rates = [[ScaledGyro, 50], [ScaledAccel, 333.33]]; // biome-ignore format: one line
    for (const [i, stamp] of [0xd5, 0xd7, 0x12, 0xd3, 0x05].entries()) {
        const { device } = await opened(accepting(stamp));
        assert.deepEqual([...(await device.stream(rates)).values()], [50, 1000 / 3]);
        assert.equal(formats.length, i + 1);
        const begin = stamp === 5 ? "018002" : `018003${toHex(Uint8Array.of(stamp))}0003`;
        assert.equal(formats.splice(0).at(-1), `${begin}050014040003`);
        await device.close();
    }
    const { device } = await opened(accepting(0x05));
    await device.stream(rates, { timestamp: false });
    assert.deepEqual(formats.splice(0), ["018002050014040003"]);
    for (const clock of ["gsp", "", null]) await assert.rejects(device.stream(rates, { timestamp: clock }), { kind: "timestamp" });
    assert.deepEqual(formats, []); // nothing was changed
    const message = /^timestamp "gps": 3dm\.message_format rejected/;
    await assert.rejects(device.stream(rates, { timestamp: "gps" }), { kind: "refused", message });
    assert.deepEqual(
        formats.splice(0).map((one) => one.slice(6, 8)),
        ["12", "d3"],
    ); // but none without a timestamp
    await device.close();
    for (const clock of ["gps", "device"]) {
        const { device } = await opened(accepting(0xd3));
        await device.stream(rates, { timestamp: clock });
        await assert.rejects(device.stream([...rates, [SensorTime, 1]], { timestamp: clock }), { message: /^3dm/ }); // it has one
        assert.deepEqual(
            formats.splice(0).map((one) => one.slice(4, 8)),
            ["0312", "03d3", "0305"],
        );
        await device.close();
    }
});

test("a new message format discards what waits in the old one", async () => {
    const bytes = [];
    const { device, port } = await opened(rating(), { onBytes: (piece) => bytes.push(piece) });
    const other = new GpsTimestamp({ tow: 1, weekNumber: 2, validFlags: 3 }).packet(0x82).bytes;
    for (const one of [DATA, other, DATA]) port.arrive(one);
    await device.request(new Ping());
    assert.equal(device.waiting, 3);
    await assert.rejects(device.stream([[ScaledAccel, 30]]), { kind: "rate" });
    assert.equal(device.waiting, 3); // nothing was changed
    await device.stream([[ScaledAccel, 50]]);
    port.arrive(DATA);
    assert.deepEqual([(await device.next()).set, (await device.next()).set, device.waiting], [0x82, 0x80, 0]);
    assert.equal(toHex(joined(bytes)).split(toHex(DATA)).length, 4);
    await device.close();
});

test("the times of a device are those of its model, once that is known", async () => {
    const responses = { 3: informed("3DM-GX5-25      ", "6253-4220") };
    const { device, port } = await opened(rejecting(responses, []));
    const stamp = new SensorTime({ tow: 12.5, weekNumber: 2300, validFlags: 0x18 }).packet().bytes; // a date, but on such models
    const clocks = async () => {
        port.arrive(stamp);
        const packet = await device.next();
        const times = [Clock.GPS, Clock.DEVICE].map((clock) => [packet.time(clock), new Times().time(packet, clock)]);
        for (const [one, other] of times) assert.equal(one, other);
        return times.map(([one]) => typeof one === "bigint");
    };
    assert.deepEqual([device.model, await clocks()], [undefined, [true, false]]);
    await assert.rejects(device.stream([[ScaledAccel, 100]]), { kind: "refused" });
    assert.deepEqual([device.model, await clocks()], ["3dm-gx5-25", [false, true]]);
    responses[3] = informed("3DM-NEW", "".padEnd(9), "6299-0000".padEnd(16), "6253.4220");
    await device.request(new GetDeviceInfo());
    assert.equal(device.model, undefined); // the serial number does not count beside a model number
    device.model = "3dm-cv7-ahrs"; // whatever it answers
    await device.request(new GetDeviceInfo());
    assert.deepEqual([device.model, await clocks()], ["3dm-cv7-ahrs", [true, false]]);
    await device.close();
});

test("objects are checked as they are made", () => {
    assert.throws(() => new ScaledAccel({ accel: 1 }), { kind: "unknown", message: 'sensor.scaled_accel has no parameter "accel"' });
    for (const wrong of [null, 1, "x"]) assert.throws(() => new ScaledAccel(wrong), { name: "MipError" });
    assert.throws(() => CommSpeed.write({ port: 1 }).encode(), { kind: "missing", message: "baud is missing" });
    assert.equal(toHex(CommSpeed.read({ port: 1 }).encode()), "0201");
    assert.throws(() => ScaledAccel.decode(new Uint8Array(3)), { kind: "truncated" });
    assert.equal(ScaledAccel.name, "ScaledAccel");
    const nan = fromHex("7fe5bf7f 7fc00000 ffc00000");
    const accel = ScaledAccel.decode(nan);
    assert.deepEqual(accel.scaledAccel, [NaN, NaN, NaN]);
    assert.deepEqual(accel.encode(), nan);
    const time = new GpsTimestamp({ tow: 1, weekNumber: 2, validFlags: 3 });
    assert.throws(() => time.packet(), { kind: "set" });
    assert.equal(new Parser().feed(time.packet(0x82).bytes)[0].find(GpsTimestamp).set, 0x82);
    assert.deepEqual(JSON.parse(JSON.stringify(time)), { tow: 1, weekNumber: 2, validFlags: 3 });
});

// ---------------------------------------------------------------------------------------------------- ports

/** A serial port of Web Serial, behind which a device answers at one baud rate. */
class FakeSerial {
    opens = [];

    constructor(rate, reply = acknowledging()) {
        this.rate = rate;
        this.reply = reply;
    }

    async open({ baudRate }) {
        assert.ok(!this.isOpen, "it is open");
        this.isOpen = true;
        this.opens.push(baudRate);
        const answer = (bytes) => {
            const right = baudRate === this.rate;
            this.controller.enqueue(right ? this.reply(bytes) : Uint8Array.of(0xff, 0x75, 0x00));
        };
        const begin = () => {
            this.readable = new ReadableStream({
                start: (controller) => {
                    this.controller = controller;
                },
            });
        };
        begin();
        this.damage = () => {
            const { controller } = this;
            begin(); // as Web Serial does after a framing error
            controller.error(new Error("framing"));
        };
        this.writable = new WritableStream({ write: answer });
    }

    /** The device is unplugged: the port is open until it is closed. */
    lose() {
        this.readable = this.writable = null;
        this.controller.error(new Error("The device has been lost."));
    }

    async close() {
        assert.ok(this.isOpen, "it is closed");
        this.isOpen = false;
        this.readable = this.writable = null;
    }
}

test("the baud rate of a serial port is found", async () => {
    const port = new FakeSerial(921600);
    const device = await openSerial(port);
    assert.deepEqual(port.opens, [115200, 3000000, 921600]);
    assert.deepEqual(await Promise.all([1, 2].map(() => device.request(new Ping()))), [undefined, undefined]); // at once
    port.damage(); // a byte is lost, the port is not
    await new Promise((resolve) => setTimeout(resolve, 20));
    assert.equal(await device.request(new Ping()), undefined);
    await device.close();
    assert.ok(!port.isOpen);
    const given = new FakeSerial(9600);
    await (await openSerial(given, { baud: 9600 })).close();
    assert.deepEqual(given.opens, [9600]);
    const lost = new FakeSerial(1);
    setTimeout(() => lost.lose(), 100);
    await assert.rejects(openSerial(lost), { kind: "closed" });
    assert.ok(!lost.isOpen); // it can be opened again
});

test("a serial port without a device", async (t) => {
    const { now } = performance;
    const { setTimeout: later } = globalThis;
    t.mock.method(performance, "now", () => 50 * now.call(performance)); // 50 times as fast, as it waits at each rate
    t.mock.method(globalThis, "setTimeout", (call, milliseconds) => later(call, milliseconds / 50));
    await assert.rejects(openSerial(new FakeSerial(1)), { kind: "no_device" });
});

/** A class of WebSockets behind which a device answers. */
const fakeSocket = (reply) =>
    class extends EventTarget {
        constructor(url) {
            super();
            this.url = url;
            setTimeout(() => this.dispatchEvent(new Event(url === "ws://none" ? "error" : "open")), 1);
        }

        send(bytes) {
            const data = reply(bytes);
            this.dispatchEvent(new MessageEvent("message", { data: "text is no data" }));
            for (const part of [data.slice(0, 3), data.slice(3)]) {
                this.dispatchEvent(new MessageEvent("message", { data: part.buffer }));
            }
        }

        close() {
            this.dispatchEvent(new Event("close"));
        }
    };

test("a WebSocket", async () => {
    const device = await openWebSocket("ws://localhost:1", { WebSocket: fakeSocket(acknowledging()) });
    assert.equal(await device.request(new Ping()), undefined);
    await device.close();
    await assert.rejects(openWebSocket("ws://none", { WebSocket: fakeSocket() }), { kind: "closed" });
    await assert.rejects(openWebSocket("ws://none", { WebSocket: null }), { kind: "websocket" });
});

test("a TCP connection that the other end closes", async () => {
    const server = net.createServer((socket) => {
        socket.write(DATA);
        socket.end();
    });
    await new Promise((resolve) => server.listen(0, "localhost", resolve));
    const { port } = server.address();
    const device = await openTcp("localhost", port);
    assert.ok((await device.next({ timeout: 5 })).find(ScaledAccel));
    await assert.rejects(device.next({ timeout: 5 }), (error) => error instanceof MipError && error.kind === "closed");
    server.close();
    await assert.rejects(openTcp("localhost", 1), { code: "ECONNREFUSED" });
});

/** A TCP server behind which a device answers. */
async function served(reply) {
    const server = net.createServer((socket) => socket.on("data", (bytes) => socket.write(reply(bytes))));
    await new Promise((resolve) => server.listen(0, "localhost", resolve));
    return server.unref();
}

for (const [name, open] of Object.entries({
    "a port": async (reply) => (await opened(reply)).device,
    TCP: async (reply) => openTcp("localhost", (await served(reply)).address().port),
    "Web Serial": (reply) => openSerial(new FakeSerial(9600, reply), { baud: 9600 }),
    "a WebSocket": (reply) => openWebSocket("ws://localhost:1", { WebSocket: fakeSocket(reply) }),
})) {
    test(`a late answer over ${name} is not that of the next command`, async (t) => {
        const device = await open(lagging());
        t.after(() => device.close()); // an open socket would keep a failed test from ending
        await assert.rejects(device.request(new GetBaseRate({ descriptorSet: 0x82 }), { timeout: 0.05 }), { kind: "timeout" });
        assert.equal((await device.request(new GetBaseRate({ descriptorSet: 0x80 }), { timeout: 5 })).rate, 100);
        assert.equal([...(await device.next()).fields()][1].data[0], 0x82); // it is data
        assert.equal((await device.request(new GetBaseRate({ descriptorSet: 0x82 }))).rate, 4);
        assert.equal(device.waiting, 0);
    });
}
