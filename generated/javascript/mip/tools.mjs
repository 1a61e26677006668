// The interface for tools, without classes: the protocol's model, and values by their names in the specification.

export { checksum, fromHex, isSame, MipError, readFloat, sameBytes, toHex, writeFloat } from "./bytes.mjs";
export { buildPacket, decodeData, decodePacket, encodeData, partsOf } from "./data.mjs";
export { deviceWithNumber, nameIn, placesOf, Protocol } from "./model.mjs";
export { clocksIn, isValid } from "./model_time.mjs";
export {
    bitsNumber,
    bitsOf,
    enumValue,
    maskOf,
    measuredHere,
    memberName,
    namedType,
    parameterOf,
    parametersAt,
    unitOf,
    valueAt,
} from "./naming.mjs";
export { FIRST_DATA_SET, isSet, Packet, SHARED_SET } from "./packet.mjs";
export { Parser, segments } from "./parser.mjs";
export { decimation } from "./streaming.mjs";
export { Times } from "./time.mjs";
