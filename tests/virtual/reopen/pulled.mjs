// Reads base rates while data streams; reopens the port each time it is pulled, a given number of times.

import { GetBaseRate } from "mip-protocol/3dm";
import { ScaledAccel } from "mip-protocol/sensor";
import { openTcp } from "mip-protocol/tcp";

const [, , place, wanted] = process.argv;
const [host, port] = place.split(":");
const count = { reopened: 0, streamed: 0, answered: 0, lost: 0, wrong: 0, other: 0 };
const device = await openTcp(host, Number(port));
await device.stream([[ScaledAccel, 100]]);
const sets = [0x80, 0x82, 0x91];
for (let i = 0; count.reopened < Number(wanted); i++) {
    try {
        const { descriptorSet } = await device.request(new GetBaseRate({ descriptorSet: sets[i % 3] }));
        count.answered++;
        count.wrong += descriptorSet !== sets[i % 3];
    } catch (error) {
        if (error.kind !== "closed") {
            console.error(error);
            count.other++;
            continue;
        }
        count.lost++;
        count.streamed += device.waiting > 0;
        device.clear();
        await device.reopen({ within: 10 });
        count.reopened++;
    }
}
console.log(JSON.stringify(count));
await device.close();
