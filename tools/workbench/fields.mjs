// What the search of the site uses; pages with a tool have it from `index.mjs`.

export { placesOf, Protocol } from "mip-protocol/tools";
export { certaintyOn } from "./build.mjs";
export { codeIn, exactly, indexOf, packetIn, synonymsOf, WEIGHTS } from "./find.mjs";
export { model } from "./model.mjs";
export { Ranking, stem, telling, wordsOf } from "./rank.mjs";
export { descriptorOf } from "./words.mjs";
