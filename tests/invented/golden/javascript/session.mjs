// The commands that find a device and start its data; undefined if the specification names none.

export const BAUD_RATES = [115200];

export const session = undefined;
