// What a search needs, without the tools: it works with the part of the model that `build.py` leaves it.

export { nameIn, placesOf, Protocol } from "mip-protocol/tools";
export { codeIn, corrected, find, indexOf, knownWords, packetIn } from "./find.mjs";
export { descriptorOf } from "./words.mjs";
