// All fields, found by descriptor and by name. It contains every set; a program that knows its fields does not need it.

import * as tools_ from "./tools_.mjs";
import * as mip3d from "./3d.mjs";
import * as measurements from "./measurements.mjs";
import * as shared from "./shared.mjs";
import { Registry } from "./mip/registry.mjs";
import { Acknowledge } from "./protocol.mjs";

export const registry = new Registry([
    { Acknowledge },
    tools_,
    mip3d,
    measurements,
    shared,
]);
