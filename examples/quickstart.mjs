import { Parser, fromHex, toHex } from "mip-protocol";
import { MessageFormat } from "mip-protocol/3dm";
import { ScaledAccel } from "mip-protocol/sensor";

// A command: 100 Hz of acceleration, from a device whose base rate is 1000 Hz.
const items = [{ descriptor: ScaledAccel.DESCRIPTOR, decimation: 10 }];
const command = MessageFormat.write({ descriptorSet: ScaledAccel.SET, descriptors: items });
console.log(toHex(command.packet().bytes, " "));

// Data, mixed with anything else, in pieces of any size.
const parser = new Parser();
parser.feed(new TextEncoder().encode("$GPGGA noise\r\n"));
for (const packet of parser.feed(fromHex("75 65 80 0e 0e 04 3e 7a 63 a0 bb 8e 3b 29 7f e5 bf 7f 84 ee"))) {
    const accel = packet.find(ScaledAccel);
    if (accel) console.log(`${accel.scaledAccel[0].toFixed(4)} g along x`);
}
