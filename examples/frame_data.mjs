// Opens a device, streams a data field of the reference once per second, and reads it.
import { openTcp } from "mip-protocol/tcp";
// 1. the lines of the page that begin with import
import { ScaledAccel } from "mip-protocol/sensor";

// 3. the descriptor set and the type of the page
const [set, field] = [0x80, ScaledAccel];

const [host, port] = (process.argv[2] ?? "localhost:5005").split(":");
const device = await openTcp(host, Number(port));
await device.stream([[field, 1]], { set }); // 1 Hz
// 2. the other lines of the page
for await (const value of device.fields(ScaledAccel)) {
    console.log(value.scaledAccel);
}
// end of 2
