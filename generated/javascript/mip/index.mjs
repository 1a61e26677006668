// The MIP protocol in JavaScript: what every program uses. Fields are in modules of their own, one for each set.
// The declarations, in index.d.mts, describe what is public.

export { checksum, fromHex, MipError, toHex } from "./bytes.mjs";
export { Client } from "./client.mjs";
export { Device } from "./device.mjs";
export { Command, Data, Field, packetOf, Response } from "./field.mjs";
export { Packet, RawField } from "./packet.mjs";
export { Parser, segments } from "./parser.mjs";
