import { MipError } from "mip-protocol";
import { PpsSource, PpsSourceControl } from "mip-protocol/3dm";
import { EulerAngles } from "mip-protocol/filter_data";
import { openTcp } from "mip-protocol/tcp";

const device = await openTcp("localhost", 5744);
const { deviceInfo } = await device.identify();
console.log(deviceInfo.modelName.trim());

try {
    await device.request(PpsSourceControl.write({ source: PpsSource.RECEIVER_1 }));
} catch (error) {
    if (!(error instanceof MipError) || error.kind !== "refused") throw error;
    console.log(error.message);
}

await device.stream([[EulerAngles, 10]]);
let count = 0;
for await (const packet of device) {
    const angles = packet.find(EulerAngles);
    if (!angles) continue;
    console.log(angles.roll.toFixed(3), angles.pitch.toFixed(3), angles.yaw.toFixed(3));
    if (++count === 10) break;
}
await device.close();
