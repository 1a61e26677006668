import { buildPacket, fromHex, Parser, Protocol, toHex } from "./mip/index.mjs";
import model from "./model.mjs";

const protocol = new Protocol(model);
const command = buildPacket(protocol, 0x01, [{ descriptor: 0x03, name: "base.get_device_info", values: {} }]);
console.log(toHex(command.bytes, " "));

const parser = new Parser(protocol);
parser.feed(new TextEncoder().encode("$GPGGA noise\r\n"));
for (const packet of parser.feed(fromHex("7565800e0e043e7a63a0bb8e3b297fe5bf7f84ee"))) {
    for (const { field, values } of packet.decode()) {
        if (field?.name === "sensor.scaled_accel") console.log(`${values.scaled_accel[0].toFixed(4)} g along x`);
    }
}
