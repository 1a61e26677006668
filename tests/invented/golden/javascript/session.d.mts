// The commands that find a device and start its data.

/** The specification names no command that identifies a device. */
export type Identity = never;
