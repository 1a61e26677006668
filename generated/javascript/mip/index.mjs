// The MIP protocol in JavaScript: everything that a program uses.

export { MipError, checksum, fromHex, toHex } from "./bytes.mjs";
export { decodeData, encodeData } from "./codec.mjs";
export { bitsOf, enumValue, namedType, parametersAt, unitOf } from "./names.mjs";
export { Packet, buildPacket } from "./packet.mjs";
export { Parser, segments } from "./parser.mjs";
export { Protocol } from "./protocol.mjs";
