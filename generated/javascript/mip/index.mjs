// The MIP protocol in JavaScript: everything that a program uses.

export { checksum, fromHex, MipError, readFloat, sameBytes, toHex, writeFloat } from "./bytes.mjs";
export { decodeData, encodeData } from "./codec.mjs";
export {
    bitsNumber,
    bitsOf,
    enumValue,
    maskOf,
    measuredHere,
    namedType,
    parameterOf,
    parametersAt,
    unitOf,
    valueAt,
} from "./names.mjs";
export { buildPacket, Packet } from "./packet.mjs";
export { Parser, segments } from "./parser.mjs";
export { FIRST_DATA_SET, isSet, nameIn, placesOf, Protocol, SHARED_SET } from "./protocol.mjs";
