// The tools for the browser.

export { bytesOfText } from "./input.mjs";
export { inspect } from "./inspect.mjs";
export { inspector } from "./inspector.mjs";
