// What pages use: the tools, the codec package, and the model of its specification.

export * from "mip-protocol/tools";
export { default as model } from "mip-protocol/model";
export { bandwidth } from "./bandwidth.mjs";
export { answerOf, initialValues, packetOf, typicalValues } from "./build.mjs";
export { builder } from "./builder.mjs";
export { fragment } from "./dom.mjs";
export { find, indexOf, packetIn } from "./find.mjs";
export { finder } from "./finder.mjs";
export { inspect } from "./inspect.mjs";
export { inspector } from "./inspector.mjs";
export { bytesOfText } from "./pasted.mjs";
export { programOf } from "./programs/index.mjs";
export { needOf, portsFor, streamsOf } from "./stream.mjs";
export { descriptorOf } from "./words.mjs";
