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

export const TimeSyncStatus = /* @__PURE__ */ field.data("system_data.time_sync_status", 0xa0, 0x02, (values, reader) => {
    values.timeSync = codec.bool(reader, 0);
    values.lastPpsReceived = codec.u8(reader, 1);
});

export const GpioState = /* @__PURE__ */ field.data("system_data.gpio_state", 0xa0, 0x03, (values, reader) => {
    values.states = codec.u8(reader, 0);
});

export const GpioAnalogValue = /* @__PURE__ */ field.data("system_data.gpio_analog_value", 0xa0, 0x04, (values, reader) => {
    values.gpioId = codec.u8(reader, 0);
    values.value = codec.float(reader, 1);
});
