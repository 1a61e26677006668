// The tools for the browser.

export { bandwidth } from "./bandwidth.mjs";
export { answerOf, initialValues, packetOf, typicalValues } from "./build.mjs";
export { builder } from "./builder.mjs";
export { programOf } from "./code.mjs";
export { fragment } from "./dom.mjs";
export { find, indexOf, packetIn } from "./find.mjs";
export { finder } from "./finder.mjs";
export { bytesOfText } from "./input.mjs";
export { inspect } from "./inspect.mjs";
export { inspector } from "./inspector.mjs";
export { needOf, portsFor, streamsOf } from "./stream.mjs";
export { descriptorOf } from "./words.mjs";
