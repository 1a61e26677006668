// The interface for pages: the tools, the codec package, and the model of its specification.

export * from "mip-protocol/tools";
export { model } from "./model.mjs";
export { bandwidth } from "./bandwidth.mjs";
export { answerOf, certaintyOn, initialValues, packetOf, typicalValues } from "./build.mjs";
export { builder } from "./builder.mjs";
export { fragment } from "./address.mjs";
export { codeIn, exactly, find, indexOf, missing, packetIn, synonymsOf, WEIGHTS } from "./find.mjs";
export { finder } from "./finder.mjs";
export { inspect, transactionsOf } from "./inspect.mjs";
export { inspector } from "./inspector.mjs";
export { Ranking, stem, telling, wordsOf } from "./rank.mjs";
export { Readings, rotationOf } from "./readings.mjs";
export { bytesOfText } from "./pasted.mjs";
export { gapText, spanText } from "./logs.mjs";
export { survey } from "./survey.mjs";
export { live } from "./live.mjs";
export { needOf, portsFor, streamsOf } from "./stream.mjs";
export { descriptorOf } from "./words.mjs";
