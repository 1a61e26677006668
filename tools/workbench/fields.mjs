// The exports for a search, without the tools: it works with the part of the model that `build.py` keeps for it.

export { nameIn, placesOf, Protocol } from "mip-protocol/tools";
export { codeIn, corrected, find, indexOf, knownWords, packetIn } from "./find.mjs";
export { descriptorOf } from "./words.mjs";
