// Prints speeds over the packets of a file, in megabytes per second of CPU time.
//
//     speed.mjs GENERATED_FOLDER RECORDING
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const load = (name) => import(pathToFileURL(path.resolve(process.argv[2], name)));
const { Parser } = await load("mip/index.mjs");
const { registry } = await load("registry.mjs");
const stream = fs.readFileSync(process.argv[3]);
const ROUNDS = 5;
const PIECE = 65536;

function feed(take) {
    const parser = new Parser();
    let sum = 0;
    for (let at = 0; at < stream.length; at += PIECE) {
        for (const packet of parser.feed(stream.subarray(at, at + PIECE))) sum += take(packet);
    }
    return sum;
}

function speed(take) {
    feed(take); // so that it is compiled
    const seconds = Array.from({ length: ROUNDS }, () => {
        const before = process.cpuUsage();
        feed(take);
        const { user, system } = process.cpuUsage(before);
        return (user + system) / 1e6;
    });
    return stream.length / Math.min(...seconds) / 1e6;
}

const accel = registry.field("sensor.scaled_accel");
const measured = {
    parse: () => 1,
    "parse, and decode all fields": (packet) => registry.decode(packet).length,
    "parse, and find one field": (packet) => (packet.find(accel) ? 1 : 0),
};
for (const [what, take] of Object.entries(measured)) console.log(`${what}: ${speed(take).toFixed(1)} MB/s`);
