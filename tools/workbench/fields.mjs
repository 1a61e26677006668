// The exports for a search, without the tools: it works with the part of the model that `build.py` keeps for it.

export { nameIn, placesOf, Protocol } from "mip-protocol/tools";
export { codeIn, exactly, indexOf, packetIn, synonymsOf, WEIGHTS } from "./find.mjs";
export { Ranking, stem, telling, wordsOf } from "./rank.mjs";
export { descriptorOf } from "./words.mjs";
