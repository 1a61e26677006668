import fs from "node:fs";
import { Parser } from "mip-protocol";
import { registry } from "mip-protocol/registry";

const parser = new Parser();
for await (const piece of fs.createReadStream("log.bin")) {
    for (const packet of parser.feed(piece)) {
        for (const field of registry.decode(packet)) console.log(packet.set, field);
    }
}
console.log(parser.skipped, "bytes between packets");
