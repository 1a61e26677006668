// The commands that find a device and start its data; undefined if the specification names none.

import * as base from "./base.mjs";
import * as mip3dm from "./3dm.mjs";

/** The baud rates of all known devices, the usual one first. */
export const BAUD_RATES = [115200, 3000000, 921600, 460800, 230400, 57600, 38400, 19200, 9600, 4800];

export const session = {
    ping: () => new base.Ping(),
    idle: () => new base.SetIdle(),
    resume: () => new base.Resume(),
    identify: () => new base.GetDeviceInfo(),
    modelNumbers: (answer) => [answer.deviceInfo.modelNumber, answer.deviceInfo.serialNumber],
    descriptors: () => [new base.GetDeviceDescriptors(), new base.GetExtendedDescriptors()],
    baseRate: (set) => new mip3dm.GetBaseRate({ descriptorSet: set }),
    rate: (answer) => answer.rate,
    format: (set, items) => mip3dm.MessageFormat.write({ descriptorSet: set, descriptors: items }),
    item: (descriptor, decimation) => ({ descriptor: descriptor, decimation: decimation }),
    stream: (set) => mip3dm.DataStreamControl.write({ descriptorSet: set, enable: true }),
    older: {
        0x80: {
            baseRate: () => new mip3dm.GetImuBaseRate(),
            rate: (answer) => answer.rate,
            format: (items) => mip3dm.ImuMessageFormat.write({ descriptors: items }),
            stream: 1,
        },
        0x81: {
            baseRate: () => new mip3dm.GetGnssBaseRate(),
            rate: (answer) => answer.rate,
            format: (items) => mip3dm.GnssMessageFormat.write({ descriptors: items }),
            stream: 2,
        },
        0x82: {
            baseRate: () => new mip3dm.GetFilterBaseRate(),
            rate: (answer) => answer.rate,
            format: (items) => mip3dm.FilterMessageFormat.write({ descriptors: items }),
            stream: 3,
        },
    },
};
