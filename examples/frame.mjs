// Opens a device, and sends a command of the reference.
import { openTcp } from "mip-protocol/tcp";
// 1. the lines of the page that begin with import
import { Ping } from "mip-protocol/base";

const [host, port] = (process.argv[2] ?? "localhost:5005").split(":");
const device = await openTcp(host, Number(port));
// 2. the other lines of the page
await device.request(new Ping());
// end of 2
console.log("command: acknowledged");
await device.close();
