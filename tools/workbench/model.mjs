// The model of the specification, which `bundle.mjs` compresses: a fifth of its text.

import { strFromU8, unzlibSync } from "fflate";
import compressed from "mip-protocol/model";

export const model = JSON.parse(strFromU8(unzlibSync(compressed)));
