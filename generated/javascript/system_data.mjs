// System data: the names and layouts of its fields. The declarations describe their meaning.

import * as codec from "./mip/codec.mjs";
import * as field from "./mip/field.mjs";
import { FunctionSelector } from "./protocol.mjs";
import * as types from "./types.mjs";

export const GpioPinStates = /* @__PURE__ */ codec.bitfield(codec.u8, {
    PIN_1: [0, 0],
    PIN_2: [1, 1],
    PIN_3: [2, 2],
    PIN_4: [3, 3],
});

export const BuiltInTest = /* @__PURE__ */ field.data("system_data.built_in_test", 0xa0, 0x01, {
    result: /* @__PURE__ */ codec.array(codec.u8, 16),
});

export const TimeSyncStatus = /* @__PURE__ */ field.data("system_data.time_sync_status", 0xa0, 0x02, {
    time_sync: codec.bool,
    last_pps_received: codec.u8,
});

export const GpioState = /* @__PURE__ */ field.data("system_data.gpio_state", 0xa0, 0x03, {
    states: GpioPinStates,
});

export const GpioAnalogValue = /* @__PURE__ */ field.data("system_data.gpio_analog_value", 0xa0, 0x04, {
    gpio_id: codec.u8,
    value: codec.float,
});
