import { GetDeviceInfo } from "mip-protocol/base";
import { ScaledAccel } from "mip-protocol/sensor";
import { openTcp } from "mip-protocol/tcp";

const [host, port] = (process.argv[2] ?? "localhost:5005").split(":");
const device = await openTcp(host, Number(port));
const { deviceInfo } = await device.request(new GetDeviceInfo());
console.log(deviceInfo.modelName.trim());

await device.stream([[ScaledAccel, 100]]);
for await (const packet of device) {
    const accel = packet.find(ScaledAccel);
    if (accel) console.log(...accel.scaledAccel.map((value) => value.toFixed(4)), "g");
}
