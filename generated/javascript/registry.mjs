// All fields, found by descriptor and by name. It contains every set; a program that knows its fields does not need it.

import * as base from "./base.mjs";
import * as mip3dm from "./3dm.mjs";
import * as filter from "./filter.mjs";
import * as gnss from "./gnss.mjs";
import * as rtk from "./rtk.mjs";
import * as displacement from "./displacement.mjs";
import * as aiding from "./aiding.mjs";
import * as system from "./system.mjs";
import * as sensor from "./sensor.mjs";
import * as gnss_data from "./gnss_data.mjs";
import * as filter_data from "./filter_data.mjs";
import * as displacement_data from "./displacement_data.mjs";
import * as system_data from "./system_data.mjs";
import * as shared from "./shared.mjs";
import { Registry } from "./mip/registry.mjs";
import { Acknowledge } from "./protocol.mjs";

export const registry = new Registry([
    { Acknowledge },
    base,
    mip3dm,
    filter,
    gnss,
    rtk,
    displacement,
    aiding,
    system,
    sensor,
    gnss_data,
    filter_data,
    displacement_data,
    system_data,
    shared,
]);
