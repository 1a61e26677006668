// What strict TypeScript rejects: tsc reports each line below a comment of this form, and no other.
import { Command, Data, type Device, fromHex, type Packet } from "mip-protocol";
import { PpsSource, PpsSourceControl } from "mip-protocol/3dm";
import { CommSpeed, Ping } from "mip-protocol/base";
import { FunctionSelector } from "mip-protocol/protocol";
import { ScaledAccel } from "mip-protocol/sensor";

declare const device: Device;
declare const packet: Packet;

// @ts-expect-error no such member
new ScaledAccel({ accel: [0, 0, -1] });
// @ts-expect-error an element is missing
new ScaledAccel({ scaledAccel: [0, 0] });
// @ts-expect-error a number is not a vector
new ScaledAccel({ scaledAccel: 1 });
// @ts-expect-error a member is missing
CommSpeed.write({ port: 1 });
// @ts-expect-error a read takes no rate
CommSpeed.read({ port: 1, baud: 115200 });
// @ts-expect-error text is not a number
CommSpeed.write({ port: "1", baud: 115200 });
// @ts-expect-error a value of another enumeration
PpsSourceControl.write({ source: FunctionSelector.WRITE });
// @ts-expect-error no such value
PpsSource.NONE;
// @ts-expect-error it takes no values
new Ping({ port: 1 });
// @ts-expect-error data is not a command
device.request(new ScaledAccel({ scaledAccel: [0, 0, -1] }));
// @ts-expect-error a write has no response
(await device.request(PpsSourceControl.write({ source: 1 }))).source;
// @ts-expect-error a response of another command
const baud: number = (await device.request(PpsSourceControl.read())).baud;
// @ts-expect-error it may not be there
packet.find(ScaledAccel).scaledAccel;
// @ts-expect-error commands are not streamed
device.stream([[Ping, 1]]);
// @ts-expect-error a rate is a number
device.stream([[ScaledAccel, "100"]]);
// @ts-expect-error a clock that no timestamp has
device.stream([[ScaledAccel, 100]], { timestamp: "gsp" });
// @ts-expect-error bytes are not text
fromHex(Uint8Array.of(1));
// @ts-expect-error only the device answers
packet.bytes = "7565";
// @ts-expect-error a clock is an object, not its name
packet.time("gps");
// @ts-expect-error a packet has no speed
packet.speed;

export { baud, Command, Data };
