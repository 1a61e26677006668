// All fields, found by descriptor and by name. It contains every set; a program that knows its fields does not need it.

import type { Registry } from "./mip/registry.mjs";

export declare const registry: Registry;
