// Reads the base rates of seven sets in turn, and counts the replies that are those of another command.

import dgram from "node:dgram";
import { on, once } from "node:events";
import { Device } from "mip-protocol";
import { GetBaseRate } from "mip-protocol/3dm";

const [, , place, pairs] = process.argv;
const count = { right: 0, stale: 0, other: 0, longest: 0, kept: 0 };

async function open() {
    const udp = dgram.createSocket("udp4");
    udp.connect(Number(place), "127.0.0.1");
    await once(udp, "connect");
    return {
        async *bytes() {
            for await (const [bytes] of on(udp, "message", { close: ["close"] })) yield new Uint8Array(bytes);
        },
        write: (bytes) => new Promise((done, fail) => udp.send(bytes, (error) => (error ? fail(error) : done()))),
        close: () => udp.close(),
    };
}

const device = await Device.open(open, { timeout: 10 });
const sets = [0x80, 0x82, 0x91, 0x92, 0x93, 0x94, 0xa0];
let shift = 0;
for (let i = 0; i < Number(pairs); i++) {
    let kind = "other";
    try {
        const { descriptorSet } = await device.request(new GetBaseRate({ descriptorSet: sets[i % 7] }));
        kind = descriptorSet === sets[i % 7] ? "right" : "stale";
    } catch {}
    count[kind]++;
    shift = kind === "right" ? 0 : shift + 1;
    count.longest = Math.max(count.longest, shift);
    await new Promise((done) => setTimeout(done, 20));
}
for (let packet = await device.next({ timeout: 0.3 }); packet; packet = await device.next({ timeout: 0.3 })) count.kept += [...packet.fields()].length;
console.log(JSON.stringify(count));
await device.close();
